struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_11 {
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

struct type_30 {
    member: array<type_22>,
}

struct type_32 {
    member: f32,
    member_1: bool,
}

struct type_34 {
    member: array<vec4<u32>, 2>,
}

struct type_36 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_38 {
    member: array<type_36>,
}

struct type_42 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_44 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_46 {
    member: array<type_44>,
}

struct type_50 {
    member: type_42,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_11;
@group(0) @binding(1) 
var<uniform> global_2: type_34;
@group(0) @binding(4) 
var<storage> global_3: type_30;
@group(0) @binding(5) 
var<storage, read_write> global_4: type_4;
@group(0) @binding(2) 
var<storage> global_5: type_38;
@group(0) @binding(3) 
var<storage> global_6: type_46;

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
    var local_9: array<f32, 3>;
    var local_10: array<f32, 3>;
    var local_11: array<f32, 128>;
    var local_12: array<f32, 3>;
    var local_13: array<f32, 3>;
    var local_14: array<f32, 3>;
    var local_15: array<f32, 3>;
    var local_16: array<u32, 3>;
    var local_17: array<u32, 3>;
    var local_18: array<u32, 3>;
    var local_19: array<array<f32, 3>, 3>;
    var local_20: array<u32, 3>;
    var local_21: array<f32, 3>;
    var local_22: array<f32, 3>;
    var phi_345_: i32;
    var phi_346_: i32;
    var phi_356_: bool;
    var phi_366_: u32;
    var phi_367_: u32;
    var phi_369_: bool;
    var phi_374_: u32;
    var phi_387_: i32;
    var phi_407_: i32;
    var phi_425_: f32;
    var phi_431_: f32;
    var phi_442_: f32;
    var phi_448_: f32;
    var phi_471_: f32;
    var phi_482_: f32;
    var phi_491_: f32;
    var phi_497_: f32;
    var phi_508_: f32;
    var phi_514_: f32;
    var phi_537_: f32;
    var phi_548_: f32;
    var phi_557_: f32;
    var phi_563_: f32;
    var phi_574_: f32;
    var phi_580_: f32;
    var phi_603_: f32;
    var phi_614_: f32;
    var phi_714_: f32;
    var phi_715_: f32;
    var phi_2756_: bool;
    var phi_788_: type_32;
    var phi_791_: type_50;
    var phi_793_: u32;
    var phi_795_: bool;
    var phi_797_: u32;
    var phi_808_: bool;
    var phi_894_: type_50;
    var phi_895_: bool;
    var phi_896_: u32;
    var phi_1791_: type_36;
    var phi_1800_: type_7;
    var phi_1801_: type_7;
    var phi_1824_: type_7;
    var phi_2749_: bool;
    var phi_1954_: type_7;
    var phi_1955_: type_7;
    var phi_1978_: type_7;
    var phi_2809_: bool;
    var phi_2541_: type_50;
    var phi_2618_: type_50;
    var phi_2619_: type_50;
    var phi_2620_: u32;
    var phi_2622_: type_50;
    var phi_2623_: u32;
    var phi_2624_: bool;
    var phi_2631_: type_50;
    var phi_2636_: type_50;
    var phi_2637_: bool;
    var phi_2826_: bool;
    var phi_915_: type_32;
    var phi_918_: type_7;
    var phi_919_: type_7;
    var phi_941_: type_7;
    var phi_983_: u32;
    var phi_1007_: type_44;
    var phi_2822_: bool;
    var phi_1018_: type_7;
    var phi_1019_: type_7;
    var phi_1042_: type_7;
    var phi_1052_: type_7;
    var phi_1053_: type_7;
    var phi_1076_: type_7;
    var phi_2817_: bool;
    var phi_2830_: bool;
    var phi_2829_: bool;
    var phi_1639_: vec3<f32>;
    var phi_1640_: vec3<f32>;
    var phi_1671_: bool;
    var phi_1680_: vec3<f32>;
    var phi_1720_: type_21;
    var phi_1722_: type_21;
    var phi_1723_: bool;
    var phi_1727_: type_21;
    var phi_1728_: type_21;
    var phi_1729_: type_21;
    var phi_1730_: bool;
    var phi_1734_: type_21;
    var phi_1735_: bool;
    var phi_1739_: type_21;
    var phi_1740_: bool;
    var phi_1744_: type_21;
    var phi_1755_: type_32;
    var phi_1756_: type_32;
    var phi_2832_: bool;
    var phi_916_: type_32;
    var phi_2831_: bool;
    var local_23: type_32;
    var phi_2891_: bool;
    var phi_2639_: type_32;
    var phi_2640_: type_50;
    var phi_2641_: bool;
    var phi_2642_: u32;
    var phi_2890_: bool;
    var phi_2643_: type_32;
    var phi_2644_: type_50;
    var phi_2645_: u32;
    var phi_2646_: bool;
    var phi_2647_: u32;
    var phi_2889_: bool;
    var phi_2648_: type_32;
    var phi_2649_: type_50;
    var phi_2650_: u32;
    var phi_2651_: bool;
    var phi_2652_: u32;
    var phi_2888_: bool;
    var phi_789_: type_32;
    var phi_792_: type_50;
    var phi_794_: u32;
    var phi_796_: bool;
    var phi_798_: u32;
    var phi_2653_: bool;
    var phi_2887_: bool;
    var local_24: type_32;
    var local_25: type_32;

    switch bitcast<i32>(0u) {
        default: {
            let _e87 = global;
            let _e90 = arrayLength((&global_5.member));
            let _e101 = global_2.member[0u][0u];
            let _e105 = global_2.member[0u][1u];
            let _e109 = global_2.member[0u][2u];
            let _e113 = global_2.member[1u][0u];
            let _e117 = global_2.member[1u][1u];
            let _e121 = global_2.member[1u][2u];
            let _e125 = global_2.member[1u][3u];
            let _e128 = global_1.member[0u];
            let _e129 = bitcast<i32>(_e128);
            let _e139 = (_e87.x + (_e87.y * 2097152u));
            let _e140 = (_e139 < arrayLength((&global_3.member)));
            if _e140 {
                let _e141 = (_e139 < arrayLength((&global_4.member)));
                if _e141 {
                    if _e140 {
                    } else {
                        break;
                    }
                    let _e149 = global_3.member[_e139].member_2[0u];
                    let _e151 = (bitcast<u32>(_e149) & 2147483647u);
                    let _e156 = global_3.member[_e139].member_2[1u];
                    let _e158 = (bitcast<u32>(_e156) & 2147483647u);
                    let _e163 = global_3.member[_e139].member_2[2u];
                    let _e165 = (bitcast<u32>(_e163) & 2147483647u);
                    let _e170 = global_3.member[_e139].member[0u];
                    let _e172 = (bitcast<u32>(_e170) & 2147483647u);
                    let _e177 = global_3.member[_e139].member[1u];
                    let _e179 = (bitcast<u32>(_e177) & 2147483647u);
                    let _e184 = global_3.member[_e139].member[2u];
                    let _e186 = (bitcast<u32>(_e184) & 2147483647u);
                    let _e188 = select(_e158, _e151, (_e158 < _e151));
                    let _e190 = select(_e165, _e188, (_e165 < _e188));
                    let _e192 = select(_e172, _e190, (_e172 < _e190));
                    let _e194 = select(_e179, _e192, (_e179 < _e192));
                    let _e196 = select(_e186, _e194, (_e186 < _e194));
                    let _e200 = global_3.member[_e139].member_1;
                    let _e202 = (bitcast<u32>(_e200) & 2147483647u);
                    let _e209 = global_3.member[_e139].member_3;
                    let _e215 = (((select(_e202, _e196, (_e202 < _e196)) < 2139095040u) && ((bitcast<u32>(_e209) & 2147483647u) <= 2139095040u)) && (_e190 > 0u));
                    if _e215 {
                        let _e218 = (bitcast<u32>(bitcast<f32>(_e190)) & 2147483647u);
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
                    let _e235 = (_e151 == _e190);
                    if _e235 {
                        phi_356_ = true;
                    } else {
                        phi_356_ = (_e158 == _e190);
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
                    if (_e129 < -126i) {
                        phi_387_ = -126i;
                    } else {
                        phi_387_ = select(_e129, 127i, (_e129 > 127i));
                    }
                    let _e259 = phi_387_;
                    let _e264 = bitcast<f32>((bitcast<u32>((_e259 + 127i)) << bitcast<u32>(23i)));
                    let _e270 = bitcast<f32>((bitcast<u32>(((_e129 - _e259) + 127i)) << bitcast<u32>(23i)));
                    let _e271 = -(_e234);
                    if (_e271 < -126i) {
                        phi_407_ = -126i;
                    } else {
                        phi_407_ = select(_e271, 127i, (_e271 > 127i));
                    }
                    let _e276 = phi_407_;
                    let _e281 = bitcast<f32>((bitcast<u32>((_e276 + 127i)) << bitcast<u32>(23i)));
                    let _e287 = bitcast<f32>((bitcast<u32>(((_e271 - _e276) + 127i)) << bitcast<u32>(23i)));
                    let _e291 = global_3.member[_e139].member;
                    let _e292 = (_e253 == 0u);
                    if _e292 {
                        phi_425_ = _e291[0];
                    } else {
                        phi_425_ = _e291[1];
                    }
                    let _e296 = phi_425_;
                    let _e297 = (_e253 == 2u);
                    if _e297 {
                        phi_431_ = _e291[2];
                    } else {
                        phi_431_ = _e296;
                    }
                    let _e300 = phi_431_;
                    let _e302 = ((_e300 * _e264) * _e270);
                    let _e303 = global_3.member[_e139].member_2;
                    if _e292 {
                        phi_442_ = _e303[0];
                    } else {
                        phi_442_ = _e303[1];
                    }
                    let _e307 = phi_442_;
                    if _e297 {
                        phi_448_ = _e303[2];
                    } else {
                        phi_448_ = _e307;
                    }
                    let _e310 = phi_448_;
                    let _e312 = ((_e310 * _e281) * _e287);
                    let _e316 = (bitcast<f32>((bitcast<u32>(_e312) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e316 {
                        let _e320 = (bitcast<f32>((bitcast<u32>(_e302) & 2147483647u)) * 0.00000011920929f);
                        phi_471_ = select(0.00000000000011368684f, _e320, (_e320 > 0.00000000000011368684f));
                    } else {
                        phi_471_ = 0f;
                    }
                    let _e324 = phi_471_;
                    let _e325 = (_e302 + _e324);
                    let _e326 = (_e302 - _e324);
                    let _e327 = select(_e312, 0f, _e316);
                    if _e316 {
                        phi_482_ = 38685626000000000000000000f;
                    } else {
                        phi_482_ = (1f / _e312);
                    }
                    let _e330 = phi_482_;
                    let _e331 = (_e252 == 0u);
                    if _e331 {
                        phi_491_ = _e291[0];
                    } else {
                        phi_491_ = _e291[1];
                    }
                    let _e335 = phi_491_;
                    let _e336 = (_e252 == 2u);
                    if _e336 {
                        phi_497_ = _e291[2];
                    } else {
                        phi_497_ = _e335;
                    }
                    let _e339 = phi_497_;
                    let _e341 = ((_e339 * _e264) * _e270);
                    if _e331 {
                        phi_508_ = _e303[0];
                    } else {
                        phi_508_ = _e303[1];
                    }
                    let _e345 = phi_508_;
                    if _e336 {
                        phi_514_ = _e303[2];
                    } else {
                        phi_514_ = _e345;
                    }
                    let _e348 = phi_514_;
                    let _e350 = ((_e348 * _e281) * _e287);
                    let _e354 = (bitcast<f32>((bitcast<u32>(_e350) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e354 {
                        let _e358 = (bitcast<f32>((bitcast<u32>(_e341) & 2147483647u)) * 0.00000011920929f);
                        phi_537_ = select(0.00000000000011368684f, _e358, (_e358 > 0.00000000000011368684f));
                    } else {
                        phi_537_ = 0f;
                    }
                    let _e362 = phi_537_;
                    let _e363 = (_e341 + _e362);
                    let _e364 = (_e341 - _e362);
                    let _e365 = select(_e350, 0f, _e354);
                    if _e354 {
                        phi_548_ = 38685626000000000000000000f;
                    } else {
                        phi_548_ = (1f / _e350);
                    }
                    let _e368 = phi_548_;
                    let _e369 = (_e254 == 0u);
                    if _e369 {
                        phi_557_ = _e291[0];
                    } else {
                        phi_557_ = _e291[1];
                    }
                    let _e373 = phi_557_;
                    let _e374 = (_e254 == 2u);
                    if _e374 {
                        phi_563_ = _e291[2];
                    } else {
                        phi_563_ = _e373;
                    }
                    let _e377 = phi_563_;
                    let _e379 = ((_e377 * _e264) * _e270);
                    if _e369 {
                        phi_574_ = _e303[0];
                    } else {
                        phi_574_ = _e303[1];
                    }
                    let _e383 = phi_574_;
                    if _e374 {
                        phi_580_ = _e303[2];
                    } else {
                        phi_580_ = _e383;
                    }
                    let _e386 = phi_580_;
                    let _e388 = ((_e386 * _e281) * _e287);
                    let _e392 = (bitcast<f32>((bitcast<u32>(_e388) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e392 {
                        let _e396 = (bitcast<f32>((bitcast<u32>(_e379) & 2147483647u)) * 0.00000011920929f);
                        phi_603_ = select(0.00000000000011368684f, _e396, (_e396 > 0.00000000000011368684f));
                    } else {
                        phi_603_ = 0f;
                    }
                    let _e400 = phi_603_;
                    let _e401 = (_e379 + _e400);
                    let _e402 = (_e379 - _e400);
                    let _e403 = select(_e388, 0f, _e392);
                    if _e392 {
                        phi_614_ = 38685626000000000000000000f;
                    } else {
                        phi_614_ = (1f / _e388);
                    }
                    let _e406 = phi_614_;
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
                        phi_714_ = select(-340282350000000000000000000000000000000f, _e447, (_e447 > -340282350000000000000000000000000000000f));
                        phi_715_ = select(-340282350000000000000000000000000000000f, _e440, (_e440 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_714_ = 0f;
                        phi_715_ = 1f;
                    }
                    let _e451 = phi_714_;
                    let _e453 = phi_715_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_11 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_22 = array<f32, 3>(bitcast<f32>(_e101), bitcast<f32>(_e105), bitcast<f32>(_e109));
                    let _e458 = (_e253 % 3u);
                    let _e459 = (_e458 < 3u);
                    if _e459 {
                    } else {
                        break;
                    }
                    let _e461 = local_22[_e458];
                    let _e462 = (_e252 % 3u);
                    let _e463 = (_e462 < 3u);
                    if _e463 {
                    } else {
                        break;
                    }
                    let _e465 = local_22[_e462];
                    let _e466 = (_e254 % 3u);
                    let _e467 = (_e466 < 3u);
                    if _e467 {
                    } else {
                        break;
                    }
                    let _e469 = local_22[_e466];
                    local_21 = array<f32, 3>(bitcast<f32>(_e113), bitcast<f32>(_e117), bitcast<f32>(_e121));
                    if _e459 {
                    } else {
                        break;
                    }
                    let _e473 = local_21[_e458];
                    if _e463 {
                    } else {
                        break;
                    }
                    let _e475 = local_21[_e462];
                    if _e467 {
                    } else {
                        break;
                    }
                    let _e477 = local_21[_e466];
                    phi_2756_ = false;
                    phi_788_ = type_32(_e451, false);
                    phi_791_ = type_50(type_42(array<f32, 3>(_e461, _e465, _e469), array<f32, 3>(_e473, _e475, _e477)), select(0u, 2147483648u, (_e90 == 0u)));
                    phi_793_ = ((3u * _e90) + 1u);
                    phi_795_ = (_e453 <= _e451);
                    phi_797_ = 0u;
                    loop {
                        let _e485 = phi_2756_;
                        let _e487 = phi_788_;
                        let _e489 = phi_791_;
                        let _e491 = phi_793_;
                        let _e493 = phi_795_;
                        let _e495 = phi_797_;
                        local_24 = _e487;
                        if _e493 {
                            phi_808_ = true;
                        } else {
                            phi_808_ = (_e495 > 0u);
                        }
                        let _e498 = phi_808_;
                        if _e498 {
                            let _e499 = (_e491 > 0u);
                            if _e499 {
                                if _e493 {
                                    phi_894_ = _e489;
                                    phi_895_ = _e493;
                                    phi_896_ = _e495;
                                } else {
                                    let _e500 = (_e495 - 1u);
                                    let _e501 = (_e500 % 128u);
                                    let _e502 = (_e501 < 128u);
                                    if _e502 {
                                    } else {
                                        phi_2887_ = true;
                                        break;
                                    }
                                    let _e504 = local_6[_e501];
                                    if _e502 {
                                    } else {
                                        phi_2887_ = true;
                                        break;
                                    }
                                    let _e506 = local_5[_e501];
                                    if _e502 {
                                    } else {
                                        phi_2887_ = true;
                                        break;
                                    }
                                    let _e508 = local_4[_e501];
                                    if _e502 {
                                    } else {
                                        phi_2887_ = true;
                                        break;
                                    }
                                    let _e510 = local_3[_e501];
                                    if _e502 {
                                    } else {
                                        phi_2887_ = true;
                                        break;
                                    }
                                    let _e513 = local_2[_e501];
                                    if _e502 {
                                    } else {
                                        phi_2887_ = true;
                                        break;
                                    }
                                    let _e515 = local_1[_e501];
                                    if _e502 {
                                    } else {
                                        phi_2887_ = true;
                                        break;
                                    }
                                    let _e517 = local[_e501];
                                    if _e502 {
                                    } else {
                                        phi_2887_ = true;
                                        break;
                                    }
                                    let _e522 = local_11[_e501];
                                    phi_894_ = type_50(type_42(array<f32, 3>(_e506, _e508, _e510), array<f32, 3>(_e513, _e515, _e517)), _e504);
                                    phi_895_ = (_e522 <= _e487.member);
                                    phi_896_ = _e500;
                                }
                                let _e526 = phi_894_;
                                let _e528 = phi_895_;
                                let _e530 = phi_896_;
                                if _e528 {
                                    if ((_e526.member_1 & 2147483648u) != 0u) {
                                        phi_2826_ = _e485;
                                        phi_915_ = _e487;
                                        phi_918_ = type_7(0u, ((_e526.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e855 = phi_2826_;
                                            let _e857 = phi_915_;
                                            let _e859 = phi_918_;
                                            local_23 = _e857;
                                            local_25 = _e857;
                                            if (_e859.member < _e859.member_1) {
                                                phi_919_ = type_7((_e859.member + 1u), _e859.member_1);
                                                phi_941_ = type_7(1u, _e859.member);
                                            } else {
                                                phi_919_ = _e859;
                                                phi_941_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e872 = phi_919_;
                                            let _e874 = phi_941_;
                                            let _e878 = (bitcast<i32>(_e874.member) != 0i);
                                            if _e878 {
                                                local_8 = array<f32, 3>(_e526.member.member[0], _e526.member.member[1], _e526.member.member[2]);
                                                local_7 = array<f32, 3>(_e526.member.member_1[0], _e526.member.member_1[1], _e526.member.member_1[2]);
                                                let _e889 = ((_e526.member_1 & 268435455u) + _e874.member_1);
                                                let _e890 = (_e889 < arrayLength((&global_6.member)));
                                                if _e890 {
                                                    if _e890 {
                                                    } else {
                                                        phi_2831_ = true;
                                                        break;
                                                    }
                                                    let _e893 = global_6.member[_e889].member_1;
                                                    phi_983_ = _e893;
                                                } else {
                                                    phi_983_ = 4294967295u;
                                                }
                                                let _e895 = phi_983_;
                                                local_18 = array<u32, 3>(_e253, _e252, _e254);
                                                if _e890 {
                                                    if _e890 {
                                                    } else {
                                                        phi_2831_ = true;
                                                        break;
                                                    }
                                                    let _e898 = global_6.member[_e889];
                                                    phi_1007_ = _e898;
                                                } else {
                                                    phi_1007_ = type_44(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e900 = phi_1007_;
                                                local_20 = array<u32, 3>(_e900.member[0], _e900.member[1], _e900.member[2]);
                                                local_19[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_19[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_19[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_2822_ = _e855;
                                                phi_1018_ = type_7(0u, 3u);
                                                loop {
                                                    let _e910 = phi_2822_;
                                                    let _e912 = phi_1018_;
                                                    if (_e912.member < _e912.member_1) {
                                                        phi_1019_ = type_7((_e912.member + 1u), _e912.member_1);
                                                        phi_1042_ = type_7(1u, _e912.member);
                                                    } else {
                                                        phi_1019_ = _e912;
                                                        phi_1042_ = type_7(0u, type_7().member_1);
                                                    }
                                                    let _e925 = phi_1019_;
                                                    let _e927 = phi_1042_;
                                                    let _e931 = (bitcast<i32>(_e927.member) != 0i);
                                                    if _e931 {
                                                        phi_1052_ = type_7(0u, 3u);
                                                        loop {
                                                            let _e933 = phi_1052_;
                                                            if (_e933.member < _e933.member_1) {
                                                                phi_1053_ = type_7((_e933.member + 1u), _e933.member_1);
                                                                phi_1076_ = type_7(1u, _e933.member);
                                                            } else {
                                                                phi_1053_ = _e933;
                                                                phi_1076_ = type_7(0u, type_7().member_1);
                                                            }
                                                            let _e946 = phi_1053_;
                                                            let _e948 = phi_1076_;
                                                            let _e952 = (bitcast<i32>(_e948.member) != 0i);
                                                            if _e952 {
                                                                let _e953 = (_e927.member_1 < 3u);
                                                                if _e953 {
                                                                } else {
                                                                    phi_2817_ = true;
                                                                    break;
                                                                }
                                                                let _e955 = local_20[_e927.member_1];
                                                                let _e956 = (_e948.member_1 < 3u);
                                                                if _e956 {
                                                                } else {
                                                                    phi_2817_ = true;
                                                                    break;
                                                                }
                                                                let _e958 = local_18[_e948.member_1];
                                                                let _e963 = ((_e955 >> bitcast<u32>(((10u * _e958) & 31u))) & 1023u);
                                                                if _e956 {
                                                                } else {
                                                                    phi_2817_ = true;
                                                                    break;
                                                                }
                                                                let _e965 = local_8[_e948.member_1];
                                                                if _e956 {
                                                                } else {
                                                                    phi_2817_ = true;
                                                                    break;
                                                                }
                                                                let _e967 = local_7[_e948.member_1];
                                                                let _e978 = (_e965 + bitcast<f32>((bitcast<u32>((f32(_e963) * bitcast<f32>((bitcast<u32>(((_e967 - _e965) * 0.0009775171f)) ^ _e125)))) ^ _e125)));
                                                                if _e953 {
                                                                } else {
                                                                    phi_2817_ = true;
                                                                    break;
                                                                }
                                                                if _e956 {
                                                                } else {
                                                                    phi_2817_ = true;
                                                                    break;
                                                                }
                                                                local_19[_e927.member_1][_e948.member_1] = select(select(_e967, _e978, (_e978 < _e967)), _e967, (_e963 == 1023u));
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_1052_ = _e946;
                                                                phi_2817_ = _e910;
                                                                break if !(_e952);
                                                            }
                                                        }
                                                        let _e987 = phi_2817_;
                                                        phi_2829_ = _e987;
                                                        if _e987 {
                                                            break;
                                                        }
                                                        phi_2830_ = _e987;
                                                    } else {
                                                        phi_2830_ = _e910;
                                                    }
                                                    let _e989 = phi_2830_;
                                                    continue;
                                                    continuing {
                                                        phi_2822_ = _e989;
                                                        phi_1018_ = _e925;
                                                        phi_2829_ = _e989;
                                                        break if !(_e931);
                                                    }
                                                }
                                                let _e992 = phi_2829_;
                                                phi_2831_ = _e992;
                                                if _e992 {
                                                    break;
                                                }
                                                let _e993 = local_19;
                                                let _e1009 = (_e993[0][2] - _e379);
                                                let _e1012 = (((_e993[0][0] - _e302) * _e403) - (_e1009 * _e327));
                                                let _e1015 = (((_e993[0][1] - _e341) * _e403) - (_e1009 * _e365));
                                                let _e1018 = (_e993[1][2] - _e379);
                                                let _e1021 = (((_e993[1][0] - _e302) * _e403) - (_e1018 * _e327));
                                                let _e1024 = (((_e993[1][1] - _e341) * _e403) - (_e1018 * _e365));
                                                let _e1027 = (_e993[2][2] - _e379);
                                                let _e1030 = (((_e993[2][0] - _e302) * _e403) - (_e1027 * _e327));
                                                let _e1033 = (((_e993[2][1] - _e341) * _e403) - (_e1027 * _e365));
                                                let _e1034 = (_e1030 * _e1024);
                                                let _e1035 = (_e1033 * _e1021);
                                                let _e1036 = (_e1012 * _e1033);
                                                let _e1037 = (_e1015 * _e1030);
                                                let _e1038 = (_e1021 * _e1015);
                                                let _e1039 = (_e1024 * _e1012);
                                                let _e1044 = (((_e1034 >= _e1035) && (_e1036 >= _e1037)) && (_e1038 >= _e1039));
                                                if (_e1044 || (((_e1034 <= _e1035) && (_e1036 <= _e1037)) && (_e1038 <= _e1039))) {
                                                    let _e1051 = select(-1f, 1f, _e1044);
                                                    let _e1053 = ((_e1034 - _e1035) * _e1051);
                                                    let _e1055 = select(0f, _e1053, (_e1053 > 0f));
                                                    let _e1057 = ((_e1036 - _e1037) * _e1051);
                                                    let _e1059 = select(0f, _e1057, (_e1057 > 0f));
                                                    let _e1061 = ((_e1038 - _e1039) * _e1051);
                                                    let _e1063 = select(0f, _e1061, (_e1061 > 0f));
                                                    let _e1065 = ((_e1055 + _e1059) + _e1063);
                                                    if (_e1065 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1734_ = type_21();
                                                        phi_1735_ = true;
                                                    } else {
                                                        let _e1068 = select(_e993[1][0], _e993[0][0], (_e993[0][0] < _e993[1][0]));
                                                        let _e1072 = select(_e993[1][0], _e993[0][0], (_e993[0][0] > _e993[1][0]));
                                                        let _e1076 = select(_e993[1][1], _e993[0][1], (_e993[0][1] < _e993[1][1]));
                                                        let _e1080 = select(_e993[1][1], _e993[0][1], (_e993[0][1] > _e993[1][1]));
                                                        let _e1084 = select(_e993[1][2], _e993[0][2], (_e993[0][2] < _e993[1][2]));
                                                        let _e1088 = select(_e993[1][2], _e993[0][2], (_e993[0][2] > _e993[1][2]));
                                                        let _e1093 = ((select(_e993[2][0], _e1068, (_e1068 < _e993[2][0])) - _e325) * _e330);
                                                        let _e1094 = ((select(_e993[2][0], _e1072, (_e1072 > _e993[2][0])) - _e326) * _e330);
                                                        let _e1097 = ((select(_e993[2][1], _e1076, (_e1076 < _e993[2][1])) - _e363) * _e368);
                                                        let _e1098 = ((select(_e993[2][1], _e1080, (_e1080 > _e993[2][1])) - _e364) * _e368);
                                                        let _e1101 = ((select(_e993[2][2], _e1084, (_e1084 < _e993[2][2])) - _e401) * _e406);
                                                        let _e1102 = ((select(_e993[2][2], _e1088, (_e1088 > _e993[2][2])) - _e402) * _e406);
                                                        let _e1104 = select(_e1102, _e1101, (_e1101 < _e1102));
                                                        let _e1106 = select(_e1102, _e1101, (_e1101 > _e1102));
                                                        let _e1108 = select(_e1094, _e1093, (_e1093 < _e1094));
                                                        let _e1110 = select(_e1098, _e1097, (_e1097 < _e1098));
                                                        let _e1112 = select(_e1110, _e1108, (_e1108 > _e1110));
                                                        let _e1114 = select(_e1104, _e1112, (_e1112 > _e1104));
                                                        let _e1116 = select(_e1094, _e1093, (_e1093 > _e1094));
                                                        let _e1118 = select(_e1098, _e1097, (_e1097 > _e1098));
                                                        let _e1120 = select(_e1118, _e1116, (_e1116 < _e1118));
                                                        let _e1122 = select(_e1106, _e1120, (_e1120 < _e1106));
                                                        let _e1123 = -(_e1104);
                                                        let _e1129 = select(_e453, _e1114, (_e1114 > _e453));
                                                        if (_e1129 > (_e1122 + (select(_e1123, _e1106, (_e1106 > _e1123)) * 0.0000019073523f))) {
                                                            phi_1729_ = type_21();
                                                            phi_1730_ = true;
                                                        } else {
                                                            let _e1131 = (_e1129 > _e857.member);
                                                            if _e1131 {
                                                                phi_1728_ = type_21();
                                                            } else {
                                                                let _e1135 = (_e993[1][0] - _e993[0][0]);
                                                                let _e1136 = (_e993[1][1] - _e993[0][1]);
                                                                let _e1137 = (_e993[1][2] - _e993[0][2]);
                                                                let _e1138 = vec3<f32>(_e1135, _e1136, _e1137);
                                                                let _e1139 = (_e993[2][0] - _e993[1][0]);
                                                                let _e1140 = (_e993[2][1] - _e993[1][1]);
                                                                let _e1141 = (_e993[2][2] - _e993[1][2]);
                                                                let _e1142 = vec3<f32>(_e1139, _e1140, _e1141);
                                                                let _e1143 = (_e993[0][0] - _e993[2][0]);
                                                                let _e1144 = (_e993[0][1] - _e993[2][1]);
                                                                let _e1145 = (_e993[0][2] - _e993[2][2]);
                                                                let _e1146 = vec3<f32>(_e1143, _e1144, _e1145);
                                                                let _e1149 = bitcast<f32>((bitcast<u32>(_e1135) & 2147483647u));
                                                                let _e1152 = bitcast<f32>((bitcast<u32>(_e1136) & 2147483647u));
                                                                let _e1154 = select(_e1152, _e1149, (_e1149 > _e1152));
                                                                let _e1157 = bitcast<f32>((bitcast<u32>(_e1137) & 2147483647u));
                                                                let _e1159 = select(_e1157, _e1154, (_e1154 > _e1157));
                                                                let _e1162 = bitcast<f32>((bitcast<u32>(_e1139) & 2147483647u));
                                                                let _e1165 = bitcast<f32>((bitcast<u32>(_e1140) & 2147483647u));
                                                                let _e1167 = select(_e1165, _e1162, (_e1162 > _e1165));
                                                                let _e1170 = bitcast<f32>((bitcast<u32>(_e1141) & 2147483647u));
                                                                let _e1172 = select(_e1170, _e1167, (_e1167 > _e1170));
                                                                let _e1175 = bitcast<f32>((bitcast<u32>(_e1143) & 2147483647u));
                                                                let _e1178 = bitcast<f32>((bitcast<u32>(_e1144) & 2147483647u));
                                                                let _e1180 = select(_e1178, _e1175, (_e1175 > _e1178));
                                                                let _e1183 = bitcast<f32>((bitcast<u32>(_e1145) & 2147483647u));
                                                                let _e1185 = select(_e1183, _e1180, (_e1180 > _e1183));
                                                                let _e1187 = select(_e1172, _e1159, (_e1159 > _e1172));
                                                                let _e1189 = select(_e1185, _e1187, (_e1187 > _e1185));
                                                                if (_e1159 == _e1189) {
                                                                    phi_1639_ = _e1142;
                                                                    phi_1640_ = _e1146;
                                                                } else {
                                                                    let _e1192 = vec3((_e1172 == _e1189));
                                                                    phi_1639_ = select(_e1138, _e1146, _e1192);
                                                                    phi_1640_ = select(_e1142, _e1138, _e1192);
                                                                }
                                                                let _e1196 = phi_1639_;
                                                                let _e1198 = phi_1640_;
                                                                let _e1205 = ((_e1196.y * _e1198.z) - (_e1198.y * _e1196.z));
                                                                let _e1210 = ((_e1196.z * _e1198.x) - (_e1198.z * _e1196.x));
                                                                let _e1213 = ((_e1196.x * _e1198.y) - (_e1198.x * _e1196.y));
                                                                if (_e1055 >= _e1059) {
                                                                    phi_1671_ = select(true, false, (_e1055 >= _e1063));
                                                                } else {
                                                                    phi_1671_ = true;
                                                                }
                                                                let _e1218 = phi_1671_;
                                                                if _e1218 {
                                                                    phi_1680_ = select(vec3<f32>(_e993[2][0], _e993[2][1], _e993[2][2]), vec3<f32>(_e993[1][0], _e993[1][1], _e993[1][2]), vec3((_e1059 >= _e1063)));
                                                                } else {
                                                                    phi_1680_ = vec3<f32>(_e993[0][0], _e993[0][1], _e993[0][2]);
                                                                }
                                                                let _e1223 = phi_1680_;
                                                                let _e1240 = ((((_e1205 * (_e1223.x - _e302)) + (_e1210 * (_e1223.y - _e341))) + (_e1213 * (_e1223.z - _e379))) / (((_e1205 * _e327) + (_e1210 * _e365)) + (_e1213 * _e403)));
                                                                let _e1242 = select(_e1122, _e1240, (_e1240 < _e1122));
                                                                let _e1244 = select(_e1114, _e1242, (_e1242 > _e1114));
                                                                if (_e1244 >= _e453) {
                                                                    let _e1246 = (_e1244 <= _e857.member);
                                                                    if _e1246 {
                                                                        let _e1247 = (1f / _e1065);
                                                                        phi_1720_ = type_21(_e1244, (_e1059 * _e1247), (_e1063 * _e1247), _e895);
                                                                    } else {
                                                                        phi_1720_ = type_21();
                                                                    }
                                                                    let _e1252 = phi_1720_;
                                                                    phi_1722_ = _e1252;
                                                                    phi_1723_ = select(true, false, _e1246);
                                                                } else {
                                                                    phi_1722_ = type_21();
                                                                    phi_1723_ = true;
                                                                }
                                                                let _e1255 = phi_1722_;
                                                                let _e1257 = phi_1723_;
                                                                if _e1257 {
                                                                    phi_1727_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1727_ = _e1255;
                                                                }
                                                                let _e1259 = phi_1727_;
                                                                phi_1728_ = _e1259;
                                                            }
                                                            let _e1261 = phi_1728_;
                                                            phi_1729_ = _e1261;
                                                            phi_1730_ = _e1131;
                                                        }
                                                        let _e1263 = phi_1729_;
                                                        let _e1265 = phi_1730_;
                                                        phi_1734_ = _e1263;
                                                        phi_1735_ = _e1265;
                                                    }
                                                    let _e1267 = phi_1734_;
                                                    let _e1269 = phi_1735_;
                                                    phi_1739_ = _e1267;
                                                    phi_1740_ = _e1269;
                                                } else {
                                                    phi_1739_ = type_21();
                                                    phi_1740_ = true;
                                                }
                                                let _e1271 = phi_1739_;
                                                let _e1273 = phi_1740_;
                                                if _e1273 {
                                                    phi_1744_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1744_ = _e1271;
                                                }
                                                let _e1275 = phi_1744_;
                                                if (_e1275.member_3 != 4294967295u) {
                                                    if (_e895 != 4294967295u) {
                                                        phi_1755_ = type_32(_e857.member, true);
                                                    } else {
                                                        phi_1755_ = _e857;
                                                    }
                                                    let _e1283 = phi_1755_;
                                                    phi_1756_ = _e1283;
                                                } else {
                                                    phi_1756_ = _e857;
                                                }
                                                let _e1285 = phi_1756_;
                                                phi_2832_ = _e992;
                                                phi_916_ = _e1285;
                                            } else {
                                                phi_2832_ = _e855;
                                                phi_916_ = type_32();
                                            }
                                            let _e1287 = phi_2832_;
                                            let _e1289 = phi_916_;
                                            continue;
                                            continuing {
                                                phi_2826_ = _e1287;
                                                phi_915_ = _e1289;
                                                phi_918_ = _e872;
                                                phi_2831_ = _e1287;
                                                break if !(_e878);
                                            }
                                        }
                                        let _e1292 = phi_2831_;
                                        phi_2887_ = _e1292;
                                        if _e1292 {
                                            break;
                                        }
                                        let _e1294 = local_23;
                                        phi_2891_ = _e1292;
                                        let _e1454 = local_25;
                                        phi_2639_ = _e1454;
                                        phi_2640_ = _e526;
                                        phi_2641_ = false;
                                        phi_2642_ = select(_e530, 0u, _e1294.member_1);
                                    } else {
                                        local_10 = array<f32, 3>(_e526.member.member[0], _e526.member.member[1], _e526.member.member[2]);
                                        local_9 = array<f32, 3>(_e526.member.member_1[0], _e526.member.member_1[1], _e526.member.member_1[2]);
                                        let _e550 = (_e526.member_1 < _e90);
                                        if _e550 {
                                            if _e550 {
                                            } else {
                                                phi_2887_ = true;
                                                break;
                                            }
                                            let _e552 = global_5.member[_e526.member_1];
                                            phi_1791_ = _e552;
                                        } else {
                                            phi_1791_ = type_36(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e554 = phi_1791_;
                                        let _e556 = array<u32, 3>(_e253, _e252, _e254);
                                        local_17 = _e556;
                                        local_13 = array<f32, 3>(0f, 0f, 0f);
                                        local_12 = array<f32, 3>(0f, 0f, 0f);
                                        phi_1800_ = type_7(0u, 3u);
                                        loop {
                                            let _e558 = phi_1800_;
                                            if (_e558.member < _e558.member_1) {
                                                phi_1801_ = type_7((_e558.member + 1u), _e558.member_1);
                                                phi_1824_ = type_7(1u, _e558.member);
                                            } else {
                                                phi_1801_ = _e558;
                                                phi_1824_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e571 = phi_1801_;
                                            let _e573 = phi_1824_;
                                            let _e577 = (bitcast<i32>(_e573.member) != 0i);
                                            if _e577 {
                                                let _e578 = (_e573.member_1 < 3u);
                                                if _e578 {
                                                } else {
                                                    phi_2749_ = true;
                                                    break;
                                                }
                                                let _e580 = local_17[_e573.member_1];
                                                if _e578 {
                                                } else {
                                                    phi_2749_ = true;
                                                    break;
                                                }
                                                let _e582 = local_10[_e573.member_1];
                                                if _e578 {
                                                } else {
                                                    phi_2749_ = true;
                                                    break;
                                                }
                                                let _e584 = local_9[_e573.member_1];
                                                let _e587 = ((10u * _e580) & 31u);
                                                let _e590 = ((_e554.member[0] >> bitcast<u32>(_e587)) & 1023u);
                                                let _e595 = bitcast<f32>((bitcast<u32>(((_e584 - _e582) * 0.0009775171f)) ^ _e125));
                                                let _e601 = (_e582 + bitcast<f32>((bitcast<u32>((f32(_e590) * _e595)) ^ _e125)));
                                                if _e578 {
                                                } else {
                                                    phi_2749_ = true;
                                                    break;
                                                }
                                                local_13[_e573.member_1] = select(select(_e584, _e601, (_e601 < _e584)), _e584, (_e590 == 1023u));
                                                let _e610 = ((_e554.member[1] >> bitcast<u32>(_e587)) & 1023u);
                                                let _e616 = (_e582 + bitcast<f32>((bitcast<u32>((f32(_e610) * _e595)) ^ _e125)));
                                                if _e578 {
                                                } else {
                                                    phi_2749_ = true;
                                                    break;
                                                }
                                                local_12[_e573.member_1] = select(select(_e584, _e616, (_e616 < _e584)), _e584, (_e610 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_1800_ = _e571;
                                                phi_2749_ = _e485;
                                                break if !(_e577);
                                            }
                                        }
                                        let _e624 = phi_2749_;
                                        phi_2887_ = _e624;
                                        if _e624 {
                                            break;
                                        }
                                        let _e625 = local_12;
                                        let _e626 = local_13;
                                        local_16 = _e556;
                                        local_15 = array<f32, 3>(0f, 0f, 0f);
                                        local_14 = array<f32, 3>(0f, 0f, 0f);
                                        phi_1954_ = type_7(0u, 3u);
                                        loop {
                                            let _e635 = phi_1954_;
                                            if (_e635.member < _e635.member_1) {
                                                phi_1955_ = type_7((_e635.member + 1u), _e635.member_1);
                                                phi_1978_ = type_7(1u, _e635.member);
                                            } else {
                                                phi_1955_ = _e635;
                                                phi_1978_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e648 = phi_1955_;
                                            let _e650 = phi_1978_;
                                            let _e654 = (bitcast<i32>(_e650.member) != 0i);
                                            if _e654 {
                                                let _e655 = (_e650.member_1 < 3u);
                                                if _e655 {
                                                } else {
                                                    phi_2809_ = true;
                                                    break;
                                                }
                                                let _e657 = local_16[_e650.member_1];
                                                if _e655 {
                                                } else {
                                                    phi_2809_ = true;
                                                    break;
                                                }
                                                let _e659 = local_10[_e650.member_1];
                                                if _e655 {
                                                } else {
                                                    phi_2809_ = true;
                                                    break;
                                                }
                                                let _e661 = local_9[_e650.member_1];
                                                let _e664 = ((10u * _e657) & 31u);
                                                let _e667 = ((_e554.member_1[0] >> bitcast<u32>(_e664)) & 1023u);
                                                let _e672 = bitcast<f32>((bitcast<u32>(((_e661 - _e659) * 0.0009775171f)) ^ _e125));
                                                let _e678 = (_e659 + bitcast<f32>((bitcast<u32>((f32(_e667) * _e672)) ^ _e125)));
                                                if _e655 {
                                                } else {
                                                    phi_2809_ = true;
                                                    break;
                                                }
                                                local_15[_e650.member_1] = select(select(_e661, _e678, (_e678 < _e661)), _e661, (_e667 == 1023u));
                                                let _e687 = ((_e554.member_1[1] >> bitcast<u32>(_e664)) & 1023u);
                                                let _e693 = (_e659 + bitcast<f32>((bitcast<u32>((f32(_e687) * _e672)) ^ _e125)));
                                                if _e655 {
                                                } else {
                                                    phi_2809_ = true;
                                                    break;
                                                }
                                                local_14[_e650.member_1] = select(select(_e661, _e693, (_e693 < _e661)), _e661, (_e687 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_1954_ = _e648;
                                                phi_2809_ = _e624;
                                                break if !(_e654);
                                            }
                                        }
                                        let _e701 = phi_2809_;
                                        phi_2887_ = _e701;
                                        if _e701 {
                                            break;
                                        }
                                        let _e702 = local_14;
                                        let _e703 = local_15;
                                        let _e714 = type_50(type_42(array<f32, 3>(_e626[0], _e626[1], _e626[2]), array<f32, 3>(_e625[0], _e625[1], _e625[2])), _e554.member_2);
                                        let _e719 = type_50(type_42(array<f32, 3>(_e703[0], _e703[1], _e703[2]), array<f32, 3>(_e702[0], _e702[1], _e702[2])), _e554.member_3);
                                        let _e725 = ((_e626[0] - _e325) * _e330);
                                        let _e726 = ((_e703[0] - _e325) * _e330);
                                        let _e727 = ((_e625[0] - _e326) * _e330);
                                        let _e728 = ((_e702[0] - _e326) * _e330);
                                        let _e733 = ((_e626[1] - _e363) * _e368);
                                        let _e734 = ((_e703[1] - _e363) * _e368);
                                        let _e735 = ((_e625[1] - _e364) * _e368);
                                        let _e736 = ((_e702[1] - _e364) * _e368);
                                        let _e741 = ((_e626[2] - _e401) * _e406);
                                        let _e742 = ((_e703[2] - _e401) * _e406);
                                        let _e743 = ((_e625[2] - _e402) * _e406);
                                        let _e744 = ((_e702[2] - _e402) * _e406);
                                        let _e746 = select(_e743, _e741, (_e741 < _e743));
                                        let _e748 = select(_e744, _e742, (_e742 < _e744));
                                        let _e750 = select(_e743, _e741, (_e741 > _e743));
                                        let _e752 = select(_e744, _e742, (_e742 > _e744));
                                        let _e754 = select(_e727, _e725, (_e725 < _e727));
                                        let _e756 = select(_e728, _e726, (_e726 < _e728));
                                        let _e758 = select(_e735, _e733, (_e733 < _e735));
                                        let _e760 = select(_e736, _e734, (_e734 < _e736));
                                        let _e762 = select(_e758, _e754, (_e754 > _e758));
                                        let _e764 = select(_e760, _e756, (_e756 > _e760));
                                        let _e766 = select(_e746, _e762, (_e762 > _e746));
                                        let _e768 = select(_e748, _e764, (_e764 > _e748));
                                        let _e770 = select(_e727, _e725, (_e725 > _e727));
                                        let _e772 = select(_e728, _e726, (_e726 > _e728));
                                        let _e774 = select(_e735, _e733, (_e733 > _e735));
                                        let _e776 = select(_e736, _e734, (_e734 > _e736));
                                        let _e778 = select(_e774, _e770, (_e770 < _e774));
                                        let _e780 = select(_e776, _e772, (_e772 < _e776));
                                        let _e785 = -(_e746);
                                        let _e786 = -(_e748);
                                        let _e793 = (select(_e750, _e778, (_e778 < _e750)) + (select(_e785, _e750, (_e750 > _e785)) * 0.0000019073523f));
                                        let _e794 = (select(_e752, _e780, (_e780 < _e752)) + (select(_e786, _e752, (_e752 > _e786)) * 0.0000019073523f));
                                        let _e796 = select(_e453, _e766, (_e766 > _e453));
                                        let _e798 = select(_e453, _e768, (_e768 > _e453));
                                        let _e803 = (_e796 <= select(_e487.member, _e793, (_e793 < _e487.member)));
                                        let _e804 = (_e798 <= select(_e487.member, _e794, (_e794 < _e487.member)));
                                        let _e805 = (_e796 <= _e798);
                                        if _e803 {
                                            if _e804 {
                                                if _e805 {
                                                    phi_2541_ = _e719;
                                                } else {
                                                    phi_2541_ = _e714;
                                                }
                                                let _e807 = phi_2541_;
                                                let _e815 = (_e530 % 128u);
                                                let _e816 = (_e815 < 128u);
                                                if _e816 {
                                                } else {
                                                    phi_2887_ = true;
                                                    break;
                                                }
                                                local_6[_e815] = _e807.member_1;
                                                if _e816 {
                                                } else {
                                                    phi_2887_ = true;
                                                    break;
                                                }
                                                local_5[_e815] = _e807.member.member[0];
                                                if _e816 {
                                                } else {
                                                    phi_2887_ = true;
                                                    break;
                                                }
                                                local_4[_e815] = _e807.member.member[1];
                                                if _e816 {
                                                } else {
                                                    phi_2887_ = true;
                                                    break;
                                                }
                                                local_3[_e815] = _e807.member.member[2];
                                                if _e816 {
                                                } else {
                                                    phi_2887_ = true;
                                                    break;
                                                }
                                                local_2[_e815] = _e807.member.member_1[0];
                                                if _e816 {
                                                } else {
                                                    phi_2887_ = true;
                                                    break;
                                                }
                                                local_1[_e815] = _e807.member.member_1[1];
                                                if _e816 {
                                                } else {
                                                    phi_2887_ = true;
                                                    break;
                                                }
                                                local[_e815] = _e807.member.member_1[2];
                                                if _e816 {
                                                } else {
                                                    phi_2887_ = true;
                                                    break;
                                                }
                                                local_11[_e815] = select(_e798, _e796, (_e796 > _e798));
                                                if _e805 {
                                                    phi_2618_ = _e714;
                                                } else {
                                                    phi_2618_ = _e719;
                                                }
                                                let _e833 = phi_2618_;
                                                phi_2619_ = _e833;
                                                phi_2620_ = (_e530 + 1u);
                                            } else {
                                                phi_2619_ = type_50();
                                                phi_2620_ = u32();
                                            }
                                            let _e835 = phi_2619_;
                                            let _e837 = phi_2620_;
                                            phi_2622_ = _e835;
                                            phi_2623_ = _e837;
                                            phi_2624_ = select(true, false, _e804);
                                        } else {
                                            phi_2622_ = type_50();
                                            phi_2623_ = u32();
                                            phi_2624_ = true;
                                        }
                                        let _e840 = phi_2622_;
                                        let _e842 = phi_2623_;
                                        let _e844 = phi_2624_;
                                        if _e844 {
                                            if _e803 {
                                                phi_2631_ = _e714;
                                            } else {
                                                phi_2631_ = _e719;
                                            }
                                            let _e846 = phi_2631_;
                                            phi_2636_ = _e846;
                                            phi_2637_ = select(_e804, true, _e803);
                                        } else {
                                            phi_2636_ = _e840;
                                            phi_2637_ = _e528;
                                        }
                                        let _e849 = phi_2636_;
                                        let _e851 = phi_2637_;
                                        phi_2891_ = _e701;
                                        phi_2639_ = _e487;
                                        phi_2640_ = _e849;
                                        phi_2641_ = _e851;
                                        phi_2642_ = select(_e842, _e530, _e844);
                                    }
                                    let _e1298 = phi_2891_;
                                    let _e1300 = phi_2639_;
                                    let _e1302 = phi_2640_;
                                    let _e1304 = phi_2641_;
                                    let _e1306 = phi_2642_;
                                    phi_2890_ = _e1298;
                                    phi_2643_ = _e1300;
                                    phi_2644_ = _e1302;
                                    phi_2645_ = (_e491 - 1u);
                                    phi_2646_ = _e1304;
                                    phi_2647_ = _e1306;
                                } else {
                                    phi_2890_ = _e485;
                                    phi_2643_ = _e487;
                                    phi_2644_ = _e526;
                                    phi_2645_ = _e491;
                                    phi_2646_ = _e528;
                                    phi_2647_ = _e530;
                                }
                                let _e1308 = phi_2890_;
                                let _e1310 = phi_2643_;
                                let _e1312 = phi_2644_;
                                let _e1314 = phi_2645_;
                                let _e1316 = phi_2646_;
                                let _e1318 = phi_2647_;
                                phi_2889_ = _e1308;
                                phi_2648_ = _e1310;
                                phi_2649_ = _e1312;
                                phi_2650_ = _e1314;
                                phi_2651_ = _e1316;
                                phi_2652_ = _e1318;
                            } else {
                                phi_2889_ = _e485;
                                phi_2648_ = type_32();
                                phi_2649_ = type_50();
                                phi_2650_ = u32();
                                phi_2651_ = bool();
                                phi_2652_ = u32();
                            }
                            let _e1320 = phi_2889_;
                            let _e1322 = phi_2648_;
                            let _e1324 = phi_2649_;
                            let _e1326 = phi_2650_;
                            let _e1328 = phi_2651_;
                            let _e1330 = phi_2652_;
                            phi_2888_ = _e1320;
                            phi_789_ = _e1322;
                            phi_792_ = _e1324;
                            phi_794_ = _e1326;
                            phi_796_ = _e1328;
                            phi_798_ = _e1330;
                            phi_2653_ = _e499;
                        } else {
                            phi_2888_ = _e485;
                            phi_789_ = type_32();
                            phi_792_ = type_50();
                            phi_794_ = u32();
                            phi_796_ = bool();
                            phi_798_ = u32();
                            phi_2653_ = false;
                        }
                        let _e1332 = phi_2888_;
                        let _e1334 = phi_789_;
                        let _e1336 = phi_792_;
                        let _e1338 = phi_794_;
                        let _e1340 = phi_796_;
                        let _e1342 = phi_798_;
                        let _e1344 = phi_2653_;
                        continue;
                        continuing {
                            phi_2756_ = _e1332;
                            phi_788_ = _e1334;
                            phi_791_ = _e1336;
                            phi_793_ = _e1338;
                            phi_795_ = _e1340;
                            phi_797_ = _e1342;
                            phi_2887_ = _e1332;
                            break if !(_e1344);
                        }
                    }
                    let _e1347 = phi_2887_;
                    if _e1347 {
                        break;
                    }
                    let _e1349 = local_24;
                    if _e141 {
                    } else {
                        break;
                    }
                    global_4.member[_e139] = select(0u, 1u, _e1349.member_1);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_any_printed_leaf10_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
