struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_8 {
    member: vec4<u32>,
}

struct type_17 {
    member: array<array<u32, 2>>,
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

struct type_28 {
    member: type_21,
    member_1: f32,
}

struct type_31 {
    member: array<type_22>,
}

struct type_33 {
    member: type_28,
    member_1: u32,
    member_2: u32,
}

struct type_35 {
    member: array<vec4<u32>, 2>,
}

struct type_37 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_39 {
    member: array<type_37>,
}

struct type_43 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_45 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_47 {
    member: array<type_45>,
}

struct type_51 {
    member: type_43,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(1) 
var<uniform> global_2: type_35;
@group(0) @binding(4) 
var<storage> global_3: type_31;
@group(0) @binding(2) 
var<storage> global_4: type_39;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_17;
@group(0) @binding(3) 
var<storage> global_6: type_47;

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
    var phi_347_: i32;
    var phi_348_: i32;
    var phi_358_: bool;
    var phi_368_: u32;
    var phi_369_: u32;
    var phi_371_: bool;
    var phi_376_: u32;
    var phi_389_: i32;
    var phi_409_: i32;
    var phi_427_: f32;
    var phi_433_: f32;
    var phi_444_: f32;
    var phi_450_: f32;
    var phi_473_: f32;
    var phi_484_: f32;
    var phi_493_: f32;
    var phi_499_: f32;
    var phi_510_: f32;
    var phi_516_: f32;
    var phi_539_: f32;
    var phi_550_: f32;
    var phi_559_: f32;
    var phi_565_: f32;
    var phi_576_: f32;
    var phi_582_: f32;
    var phi_605_: f32;
    var phi_616_: f32;
    var phi_716_: f32;
    var phi_717_: f32;
    var phi_2789_: bool;
    var phi_791_: type_33;
    var phi_794_: type_51;
    var phi_796_: u32;
    var phi_798_: bool;
    var phi_800_: u32;
    var phi_811_: bool;
    var phi_897_: type_51;
    var phi_898_: bool;
    var phi_899_: u32;
    var phi_1822_: type_37;
    var phi_1831_: type_4;
    var phi_1832_: type_4;
    var phi_1855_: type_4;
    var phi_2782_: bool;
    var phi_1985_: type_4;
    var phi_1986_: type_4;
    var phi_2009_: type_4;
    var phi_2842_: bool;
    var phi_2572_: type_51;
    var phi_2649_: type_51;
    var phi_2650_: type_51;
    var phi_2651_: u32;
    var phi_2653_: type_51;
    var phi_2654_: u32;
    var phi_2655_: bool;
    var phi_2662_: type_51;
    var phi_2667_: type_51;
    var phi_2668_: bool;
    var phi_2859_: bool;
    var phi_918_: type_33;
    var phi_921_: type_4;
    var phi_922_: type_4;
    var phi_944_: type_4;
    var phi_989_: u32;
    var phi_1013_: type_45;
    var phi_2855_: bool;
    var phi_1024_: type_4;
    var phi_1025_: type_4;
    var phi_1048_: type_4;
    var phi_1058_: type_4;
    var phi_1059_: type_4;
    var phi_1082_: type_4;
    var phi_2850_: bool;
    var phi_2863_: bool;
    var phi_2862_: bool;
    var phi_1645_: vec3<f32>;
    var phi_1646_: vec3<f32>;
    var phi_1677_: bool;
    var phi_1686_: vec3<f32>;
    var phi_1726_: type_21;
    var phi_1728_: type_21;
    var phi_1729_: bool;
    var phi_1733_: type_21;
    var phi_1734_: type_21;
    var phi_1735_: type_21;
    var phi_1736_: bool;
    var phi_1740_: type_21;
    var phi_1741_: bool;
    var phi_1745_: type_21;
    var phi_1746_: bool;
    var phi_1750_: type_21;
    var phi_1775_: bool;
    var phi_1776_: bool;
    var phi_1783_: type_33;
    var phi_1784_: type_33;
    var phi_1785_: type_33;
    var phi_2865_: bool;
    var phi_919_: type_33;
    var phi_2864_: bool;
    var phi_2927_: bool;
    var phi_2670_: type_33;
    var phi_2671_: type_51;
    var phi_2672_: bool;
    var phi_2673_: u32;
    var phi_2926_: bool;
    var phi_2674_: type_33;
    var phi_2675_: type_51;
    var phi_2676_: u32;
    var phi_2677_: bool;
    var phi_2678_: u32;
    var phi_2925_: bool;
    var phi_2679_: type_33;
    var phi_2680_: type_51;
    var phi_2681_: u32;
    var phi_2682_: bool;
    var phi_2683_: u32;
    var phi_2924_: bool;
    var phi_792_: type_33;
    var phi_795_: type_51;
    var phi_797_: u32;
    var phi_799_: bool;
    var phi_801_: u32;
    var phi_2684_: bool;
    var phi_2923_: bool;
    var local_23: type_33;
    var local_24: type_33;
    var local_25: type_33;

    switch bitcast<i32>(0u) {
        default: {
            let _e87 = global;
            let _e90 = arrayLength((&global_4.member));
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
                let _e141 = (_e139 < arrayLength((&global_5.member)));
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
                            phi_347_ = (bitcast<i32>((_e218 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_347_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e218)), 32u, (_e218 == 0u))));
                        }
                        let _e232 = phi_347_;
                        phi_348_ = _e232;
                    } else {
                        phi_348_ = 0i;
                    }
                    let _e234 = phi_348_;
                    let _e235 = (_e151 == _e190);
                    if _e235 {
                        phi_358_ = true;
                    } else {
                        phi_358_ = (_e158 == _e190);
                    }
                    let _e238 = phi_358_;
                    let _e239 = select(1u, 0u, _e235);
                    if _e238 {
                        let _e240 = (_e239 + 1u);
                        phi_368_ = _e240;
                        phi_369_ = _e240;
                        phi_371_ = select(true, false, (_e240 == 2u));
                    } else {
                        phi_368_ = u32();
                        phi_369_ = 0u;
                        phi_371_ = true;
                    }
                    let _e244 = phi_368_;
                    let _e246 = phi_369_;
                    let _e248 = phi_371_;
                    if _e248 {
                        phi_376_ = (_e246 + 1u);
                    } else {
                        phi_376_ = 0u;
                    }
                    let _e252 = phi_376_;
                    let _e253 = select(_e244, _e246, _e248);
                    let _e254 = select(_e239, select(2u, _e239, _e238), _e248);
                    if (_e129 < -126i) {
                        phi_389_ = -126i;
                    } else {
                        phi_389_ = select(_e129, 127i, (_e129 > 127i));
                    }
                    let _e259 = phi_389_;
                    let _e264 = bitcast<f32>((bitcast<u32>((_e259 + 127i)) << bitcast<u32>(23i)));
                    let _e270 = bitcast<f32>((bitcast<u32>(((_e129 - _e259) + 127i)) << bitcast<u32>(23i)));
                    let _e271 = -(_e234);
                    if (_e271 < -126i) {
                        phi_409_ = -126i;
                    } else {
                        phi_409_ = select(_e271, 127i, (_e271 > 127i));
                    }
                    let _e276 = phi_409_;
                    let _e281 = bitcast<f32>((bitcast<u32>((_e276 + 127i)) << bitcast<u32>(23i)));
                    let _e287 = bitcast<f32>((bitcast<u32>(((_e271 - _e276) + 127i)) << bitcast<u32>(23i)));
                    let _e291 = global_3.member[_e139].member;
                    let _e292 = (_e253 == 0u);
                    if _e292 {
                        phi_427_ = _e291[0];
                    } else {
                        phi_427_ = _e291[1];
                    }
                    let _e296 = phi_427_;
                    let _e297 = (_e253 == 2u);
                    if _e297 {
                        phi_433_ = _e291[2];
                    } else {
                        phi_433_ = _e296;
                    }
                    let _e300 = phi_433_;
                    let _e302 = ((_e300 * _e264) * _e270);
                    let _e303 = global_3.member[_e139].member_2;
                    if _e292 {
                        phi_444_ = _e303[0];
                    } else {
                        phi_444_ = _e303[1];
                    }
                    let _e307 = phi_444_;
                    if _e297 {
                        phi_450_ = _e303[2];
                    } else {
                        phi_450_ = _e307;
                    }
                    let _e310 = phi_450_;
                    let _e312 = ((_e310 * _e281) * _e287);
                    let _e316 = (bitcast<f32>((bitcast<u32>(_e312) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e316 {
                        let _e320 = (bitcast<f32>((bitcast<u32>(_e302) & 2147483647u)) * 0.00000011920929f);
                        phi_473_ = select(0.00000000000011368684f, _e320, (_e320 > 0.00000000000011368684f));
                    } else {
                        phi_473_ = 0f;
                    }
                    let _e324 = phi_473_;
                    let _e325 = (_e302 + _e324);
                    let _e326 = (_e302 - _e324);
                    let _e327 = select(_e312, 0f, _e316);
                    if _e316 {
                        phi_484_ = 38685626000000000000000000f;
                    } else {
                        phi_484_ = (1f / _e312);
                    }
                    let _e330 = phi_484_;
                    let _e331 = (_e252 == 0u);
                    if _e331 {
                        phi_493_ = _e291[0];
                    } else {
                        phi_493_ = _e291[1];
                    }
                    let _e335 = phi_493_;
                    let _e336 = (_e252 == 2u);
                    if _e336 {
                        phi_499_ = _e291[2];
                    } else {
                        phi_499_ = _e335;
                    }
                    let _e339 = phi_499_;
                    let _e341 = ((_e339 * _e264) * _e270);
                    if _e331 {
                        phi_510_ = _e303[0];
                    } else {
                        phi_510_ = _e303[1];
                    }
                    let _e345 = phi_510_;
                    if _e336 {
                        phi_516_ = _e303[2];
                    } else {
                        phi_516_ = _e345;
                    }
                    let _e348 = phi_516_;
                    let _e350 = ((_e348 * _e281) * _e287);
                    let _e354 = (bitcast<f32>((bitcast<u32>(_e350) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e354 {
                        let _e358 = (bitcast<f32>((bitcast<u32>(_e341) & 2147483647u)) * 0.00000011920929f);
                        phi_539_ = select(0.00000000000011368684f, _e358, (_e358 > 0.00000000000011368684f));
                    } else {
                        phi_539_ = 0f;
                    }
                    let _e362 = phi_539_;
                    let _e363 = (_e341 + _e362);
                    let _e364 = (_e341 - _e362);
                    let _e365 = select(_e350, 0f, _e354);
                    if _e354 {
                        phi_550_ = 38685626000000000000000000f;
                    } else {
                        phi_550_ = (1f / _e350);
                    }
                    let _e368 = phi_550_;
                    let _e369 = (_e254 == 0u);
                    if _e369 {
                        phi_559_ = _e291[0];
                    } else {
                        phi_559_ = _e291[1];
                    }
                    let _e373 = phi_559_;
                    let _e374 = (_e254 == 2u);
                    if _e374 {
                        phi_565_ = _e291[2];
                    } else {
                        phi_565_ = _e373;
                    }
                    let _e377 = phi_565_;
                    let _e379 = ((_e377 * _e264) * _e270);
                    if _e369 {
                        phi_576_ = _e303[0];
                    } else {
                        phi_576_ = _e303[1];
                    }
                    let _e383 = phi_576_;
                    if _e374 {
                        phi_582_ = _e303[2];
                    } else {
                        phi_582_ = _e383;
                    }
                    let _e386 = phi_582_;
                    let _e388 = ((_e386 * _e281) * _e287);
                    let _e392 = (bitcast<f32>((bitcast<u32>(_e388) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e392 {
                        let _e396 = (bitcast<f32>((bitcast<u32>(_e379) & 2147483647u)) * 0.00000011920929f);
                        phi_605_ = select(0.00000000000011368684f, _e396, (_e396 > 0.00000000000011368684f));
                    } else {
                        phi_605_ = 0f;
                    }
                    let _e400 = phi_605_;
                    let _e401 = (_e379 + _e400);
                    let _e402 = (_e379 - _e400);
                    let _e403 = select(_e388, 0f, _e392);
                    if _e392 {
                        phi_616_ = 38685626000000000000000000f;
                    } else {
                        phi_616_ = (1f / _e388);
                    }
                    let _e406 = phi_616_;
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
                        phi_716_ = select(-340282350000000000000000000000000000000f, _e447, (_e447 > -340282350000000000000000000000000000000f));
                        phi_717_ = select(-340282350000000000000000000000000000000f, _e440, (_e440 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_716_ = 0f;
                        phi_717_ = 1f;
                    }
                    let _e451 = phi_716_;
                    let _e453 = phi_717_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_11 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_22 = array<f32, 3>(bitcast<f32>(_e101), bitcast<f32>(_e105), bitcast<f32>(_e109));
                    let _e459 = (_e253 % 3u);
                    let _e460 = (_e459 < 3u);
                    if _e460 {
                    } else {
                        break;
                    }
                    let _e462 = local_22[_e459];
                    let _e463 = (_e252 % 3u);
                    let _e464 = (_e463 < 3u);
                    if _e464 {
                    } else {
                        break;
                    }
                    let _e466 = local_22[_e463];
                    let _e467 = (_e254 % 3u);
                    let _e468 = (_e467 < 3u);
                    if _e468 {
                    } else {
                        break;
                    }
                    let _e470 = local_22[_e467];
                    local_21 = array<f32, 3>(bitcast<f32>(_e113), bitcast<f32>(_e117), bitcast<f32>(_e121));
                    if _e460 {
                    } else {
                        break;
                    }
                    let _e474 = local_21[_e459];
                    if _e464 {
                    } else {
                        break;
                    }
                    let _e476 = local_21[_e463];
                    if _e468 {
                    } else {
                        break;
                    }
                    let _e478 = local_21[_e467];
                    phi_2789_ = false;
                    phi_791_ = type_33(type_28(type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e451), 0u, 0u);
                    phi_794_ = type_51(type_43(array<f32, 3>(_e462, _e466, _e470), array<f32, 3>(_e474, _e476, _e478)), select(0u, 2147483648u, (_e90 == 0u)));
                    phi_796_ = ((3u * _e90) + 1u);
                    phi_798_ = (_e453 <= _e451);
                    phi_800_ = 0u;
                    loop {
                        let _e486 = phi_2789_;
                        let _e488 = phi_791_;
                        let _e490 = phi_794_;
                        let _e492 = phi_796_;
                        let _e494 = phi_798_;
                        let _e496 = phi_800_;
                        local_23 = _e488;
                        local_24 = _e488;
                        if _e494 {
                            phi_811_ = true;
                        } else {
                            phi_811_ = (_e496 > 0u);
                        }
                        let _e499 = phi_811_;
                        if _e499 {
                            let _e500 = (_e492 > 0u);
                            if _e500 {
                                if _e494 {
                                    phi_897_ = _e490;
                                    phi_898_ = _e494;
                                    phi_899_ = _e496;
                                } else {
                                    let _e501 = (_e496 - 1u);
                                    let _e502 = (_e501 % 128u);
                                    let _e503 = (_e502 < 128u);
                                    if _e503 {
                                    } else {
                                        phi_2923_ = true;
                                        break;
                                    }
                                    let _e505 = local_6[_e502];
                                    if _e503 {
                                    } else {
                                        phi_2923_ = true;
                                        break;
                                    }
                                    let _e507 = local_5[_e502];
                                    if _e503 {
                                    } else {
                                        phi_2923_ = true;
                                        break;
                                    }
                                    let _e509 = local_4[_e502];
                                    if _e503 {
                                    } else {
                                        phi_2923_ = true;
                                        break;
                                    }
                                    let _e511 = local_3[_e502];
                                    if _e503 {
                                    } else {
                                        phi_2923_ = true;
                                        break;
                                    }
                                    let _e514 = local_2[_e502];
                                    if _e503 {
                                    } else {
                                        phi_2923_ = true;
                                        break;
                                    }
                                    let _e516 = local_1[_e502];
                                    if _e503 {
                                    } else {
                                        phi_2923_ = true;
                                        break;
                                    }
                                    let _e518 = local[_e502];
                                    if _e503 {
                                    } else {
                                        phi_2923_ = true;
                                        break;
                                    }
                                    let _e523 = local_11[_e502];
                                    phi_897_ = type_51(type_43(array<f32, 3>(_e507, _e509, _e511), array<f32, 3>(_e514, _e516, _e518)), _e505);
                                    phi_898_ = (_e523 <= _e488.member.member_1);
                                    phi_899_ = _e501;
                                }
                                let _e528 = phi_897_;
                                let _e530 = phi_898_;
                                let _e532 = phi_899_;
                                if _e530 {
                                    if ((_e528.member_1 & 2147483648u) != 0u) {
                                        phi_2859_ = _e486;
                                        phi_918_ = _e488;
                                        phi_921_ = type_4(0u, ((_e528.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e864 = phi_2859_;
                                            let _e866 = phi_918_;
                                            let _e868 = phi_921_;
                                            local_25 = _e866;
                                            if (_e868.member < _e868.member_1) {
                                                phi_922_ = type_4((_e868.member + 1u), _e868.member_1);
                                                phi_944_ = type_4(1u, _e868.member);
                                            } else {
                                                phi_922_ = _e868;
                                                phi_944_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e881 = phi_922_;
                                            let _e883 = phi_944_;
                                            let _e887 = (bitcast<i32>(_e883.member) != 0i);
                                            if _e887 {
                                                let _e893 = type_33(_e866.member, _e866.member_1, (_e866.member_2 + 1u));
                                                local_8 = array<f32, 3>(_e528.member.member[0], _e528.member.member[1], _e528.member.member[2]);
                                                local_7 = array<f32, 3>(_e528.member.member_1[0], _e528.member.member_1[1], _e528.member.member_1[2]);
                                                let _e904 = ((_e528.member_1 & 268435455u) + _e883.member_1);
                                                let _e905 = (_e904 < arrayLength((&global_6.member)));
                                                if _e905 {
                                                    if _e905 {
                                                    } else {
                                                        phi_2864_ = true;
                                                        break;
                                                    }
                                                    let _e908 = global_6.member[_e904].member_1;
                                                    phi_989_ = _e908;
                                                } else {
                                                    phi_989_ = 4294967295u;
                                                }
                                                let _e910 = phi_989_;
                                                local_18 = array<u32, 3>(_e253, _e252, _e254);
                                                if _e905 {
                                                    if _e905 {
                                                    } else {
                                                        phi_2864_ = true;
                                                        break;
                                                    }
                                                    let _e913 = global_6.member[_e904];
                                                    phi_1013_ = _e913;
                                                } else {
                                                    phi_1013_ = type_45(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e915 = phi_1013_;
                                                local_20 = array<u32, 3>(_e915.member[0], _e915.member[1], _e915.member[2]);
                                                local_19[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_19[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_19[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_2855_ = _e864;
                                                phi_1024_ = type_4(0u, 3u);
                                                loop {
                                                    let _e925 = phi_2855_;
                                                    let _e927 = phi_1024_;
                                                    if (_e927.member < _e927.member_1) {
                                                        phi_1025_ = type_4((_e927.member + 1u), _e927.member_1);
                                                        phi_1048_ = type_4(1u, _e927.member);
                                                    } else {
                                                        phi_1025_ = _e927;
                                                        phi_1048_ = type_4(0u, type_4().member_1);
                                                    }
                                                    let _e940 = phi_1025_;
                                                    let _e942 = phi_1048_;
                                                    let _e946 = (bitcast<i32>(_e942.member) != 0i);
                                                    if _e946 {
                                                        phi_1058_ = type_4(0u, 3u);
                                                        loop {
                                                            let _e948 = phi_1058_;
                                                            if (_e948.member < _e948.member_1) {
                                                                phi_1059_ = type_4((_e948.member + 1u), _e948.member_1);
                                                                phi_1082_ = type_4(1u, _e948.member);
                                                            } else {
                                                                phi_1059_ = _e948;
                                                                phi_1082_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e961 = phi_1059_;
                                                            let _e963 = phi_1082_;
                                                            let _e967 = (bitcast<i32>(_e963.member) != 0i);
                                                            if _e967 {
                                                                let _e968 = (_e942.member_1 < 3u);
                                                                if _e968 {
                                                                } else {
                                                                    phi_2850_ = true;
                                                                    break;
                                                                }
                                                                let _e970 = local_20[_e942.member_1];
                                                                let _e971 = (_e963.member_1 < 3u);
                                                                if _e971 {
                                                                } else {
                                                                    phi_2850_ = true;
                                                                    break;
                                                                }
                                                                let _e973 = local_18[_e963.member_1];
                                                                let _e978 = ((_e970 >> bitcast<u32>(((10u * _e973) & 31u))) & 1023u);
                                                                if _e971 {
                                                                } else {
                                                                    phi_2850_ = true;
                                                                    break;
                                                                }
                                                                let _e980 = local_8[_e963.member_1];
                                                                if _e971 {
                                                                } else {
                                                                    phi_2850_ = true;
                                                                    break;
                                                                }
                                                                let _e982 = local_7[_e963.member_1];
                                                                let _e993 = (_e980 + bitcast<f32>((bitcast<u32>((f32(_e978) * bitcast<f32>((bitcast<u32>(((_e982 - _e980) * 0.0009775171f)) ^ _e125)))) ^ _e125)));
                                                                if _e968 {
                                                                } else {
                                                                    phi_2850_ = true;
                                                                    break;
                                                                }
                                                                if _e971 {
                                                                } else {
                                                                    phi_2850_ = true;
                                                                    break;
                                                                }
                                                                local_19[_e942.member_1][_e963.member_1] = select(select(_e982, _e993, (_e993 < _e982)), _e982, (_e978 == 1023u));
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_1058_ = _e961;
                                                                phi_2850_ = _e925;
                                                                break if !(_e967);
                                                            }
                                                        }
                                                        let _e1002 = phi_2850_;
                                                        phi_2862_ = _e1002;
                                                        if _e1002 {
                                                            break;
                                                        }
                                                        phi_2863_ = _e1002;
                                                    } else {
                                                        phi_2863_ = _e925;
                                                    }
                                                    let _e1004 = phi_2863_;
                                                    continue;
                                                    continuing {
                                                        phi_2855_ = _e1004;
                                                        phi_1024_ = _e940;
                                                        phi_2862_ = _e1004;
                                                        break if !(_e946);
                                                    }
                                                }
                                                let _e1007 = phi_2862_;
                                                phi_2864_ = _e1007;
                                                if _e1007 {
                                                    break;
                                                }
                                                let _e1008 = local_19;
                                                let _e1025 = (_e1008[0][2] - _e379);
                                                let _e1028 = (((_e1008[0][0] - _e302) * _e403) - (_e1025 * _e327));
                                                let _e1031 = (((_e1008[0][1] - _e341) * _e403) - (_e1025 * _e365));
                                                let _e1034 = (_e1008[1][2] - _e379);
                                                let _e1037 = (((_e1008[1][0] - _e302) * _e403) - (_e1034 * _e327));
                                                let _e1040 = (((_e1008[1][1] - _e341) * _e403) - (_e1034 * _e365));
                                                let _e1043 = (_e1008[2][2] - _e379);
                                                let _e1046 = (((_e1008[2][0] - _e302) * _e403) - (_e1043 * _e327));
                                                let _e1049 = (((_e1008[2][1] - _e341) * _e403) - (_e1043 * _e365));
                                                let _e1050 = (_e1046 * _e1040);
                                                let _e1051 = (_e1049 * _e1037);
                                                let _e1052 = (_e1028 * _e1049);
                                                let _e1053 = (_e1031 * _e1046);
                                                let _e1054 = (_e1037 * _e1031);
                                                let _e1055 = (_e1040 * _e1028);
                                                let _e1060 = (((_e1050 >= _e1051) && (_e1052 >= _e1053)) && (_e1054 >= _e1055));
                                                if (_e1060 || (((_e1050 <= _e1051) && (_e1052 <= _e1053)) && (_e1054 <= _e1055))) {
                                                    let _e1067 = select(-1f, 1f, _e1060);
                                                    let _e1069 = ((_e1050 - _e1051) * _e1067);
                                                    let _e1071 = select(0f, _e1069, (_e1069 > 0f));
                                                    let _e1073 = ((_e1052 - _e1053) * _e1067);
                                                    let _e1075 = select(0f, _e1073, (_e1073 > 0f));
                                                    let _e1077 = ((_e1054 - _e1055) * _e1067);
                                                    let _e1079 = select(0f, _e1077, (_e1077 > 0f));
                                                    let _e1081 = ((_e1071 + _e1075) + _e1079);
                                                    if (_e1081 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1740_ = type_21();
                                                        phi_1741_ = true;
                                                    } else {
                                                        let _e1084 = select(_e1008[1][0], _e1008[0][0], (_e1008[0][0] < _e1008[1][0]));
                                                        let _e1088 = select(_e1008[1][0], _e1008[0][0], (_e1008[0][0] > _e1008[1][0]));
                                                        let _e1092 = select(_e1008[1][1], _e1008[0][1], (_e1008[0][1] < _e1008[1][1]));
                                                        let _e1096 = select(_e1008[1][1], _e1008[0][1], (_e1008[0][1] > _e1008[1][1]));
                                                        let _e1100 = select(_e1008[1][2], _e1008[0][2], (_e1008[0][2] < _e1008[1][2]));
                                                        let _e1104 = select(_e1008[1][2], _e1008[0][2], (_e1008[0][2] > _e1008[1][2]));
                                                        let _e1109 = ((select(_e1008[2][0], _e1084, (_e1084 < _e1008[2][0])) - _e325) * _e330);
                                                        let _e1110 = ((select(_e1008[2][0], _e1088, (_e1088 > _e1008[2][0])) - _e326) * _e330);
                                                        let _e1113 = ((select(_e1008[2][1], _e1092, (_e1092 < _e1008[2][1])) - _e363) * _e368);
                                                        let _e1114 = ((select(_e1008[2][1], _e1096, (_e1096 > _e1008[2][1])) - _e364) * _e368);
                                                        let _e1117 = ((select(_e1008[2][2], _e1100, (_e1100 < _e1008[2][2])) - _e401) * _e406);
                                                        let _e1118 = ((select(_e1008[2][2], _e1104, (_e1104 > _e1008[2][2])) - _e402) * _e406);
                                                        let _e1120 = select(_e1118, _e1117, (_e1117 < _e1118));
                                                        let _e1122 = select(_e1118, _e1117, (_e1117 > _e1118));
                                                        let _e1124 = select(_e1110, _e1109, (_e1109 < _e1110));
                                                        let _e1126 = select(_e1114, _e1113, (_e1113 < _e1114));
                                                        let _e1128 = select(_e1126, _e1124, (_e1124 > _e1126));
                                                        let _e1130 = select(_e1120, _e1128, (_e1128 > _e1120));
                                                        let _e1132 = select(_e1110, _e1109, (_e1109 > _e1110));
                                                        let _e1134 = select(_e1114, _e1113, (_e1113 > _e1114));
                                                        let _e1136 = select(_e1134, _e1132, (_e1132 < _e1134));
                                                        let _e1138 = select(_e1122, _e1136, (_e1136 < _e1122));
                                                        let _e1139 = -(_e1120);
                                                        let _e1145 = select(_e453, _e1130, (_e1130 > _e453));
                                                        if (_e1145 > (_e1138 + (select(_e1139, _e1122, (_e1122 > _e1139)) * 0.0000019073523f))) {
                                                            phi_1735_ = type_21();
                                                            phi_1736_ = true;
                                                        } else {
                                                            let _e1147 = (_e1145 > _e866.member.member_1);
                                                            if _e1147 {
                                                                phi_1734_ = type_21();
                                                            } else {
                                                                let _e1151 = (_e1008[1][0] - _e1008[0][0]);
                                                                let _e1152 = (_e1008[1][1] - _e1008[0][1]);
                                                                let _e1153 = (_e1008[1][2] - _e1008[0][2]);
                                                                let _e1154 = vec3<f32>(_e1151, _e1152, _e1153);
                                                                let _e1155 = (_e1008[2][0] - _e1008[1][0]);
                                                                let _e1156 = (_e1008[2][1] - _e1008[1][1]);
                                                                let _e1157 = (_e1008[2][2] - _e1008[1][2]);
                                                                let _e1158 = vec3<f32>(_e1155, _e1156, _e1157);
                                                                let _e1159 = (_e1008[0][0] - _e1008[2][0]);
                                                                let _e1160 = (_e1008[0][1] - _e1008[2][1]);
                                                                let _e1161 = (_e1008[0][2] - _e1008[2][2]);
                                                                let _e1162 = vec3<f32>(_e1159, _e1160, _e1161);
                                                                let _e1165 = bitcast<f32>((bitcast<u32>(_e1151) & 2147483647u));
                                                                let _e1168 = bitcast<f32>((bitcast<u32>(_e1152) & 2147483647u));
                                                                let _e1170 = select(_e1168, _e1165, (_e1165 > _e1168));
                                                                let _e1173 = bitcast<f32>((bitcast<u32>(_e1153) & 2147483647u));
                                                                let _e1175 = select(_e1173, _e1170, (_e1170 > _e1173));
                                                                let _e1178 = bitcast<f32>((bitcast<u32>(_e1155) & 2147483647u));
                                                                let _e1181 = bitcast<f32>((bitcast<u32>(_e1156) & 2147483647u));
                                                                let _e1183 = select(_e1181, _e1178, (_e1178 > _e1181));
                                                                let _e1186 = bitcast<f32>((bitcast<u32>(_e1157) & 2147483647u));
                                                                let _e1188 = select(_e1186, _e1183, (_e1183 > _e1186));
                                                                let _e1191 = bitcast<f32>((bitcast<u32>(_e1159) & 2147483647u));
                                                                let _e1194 = bitcast<f32>((bitcast<u32>(_e1160) & 2147483647u));
                                                                let _e1196 = select(_e1194, _e1191, (_e1191 > _e1194));
                                                                let _e1199 = bitcast<f32>((bitcast<u32>(_e1161) & 2147483647u));
                                                                let _e1201 = select(_e1199, _e1196, (_e1196 > _e1199));
                                                                let _e1203 = select(_e1188, _e1175, (_e1175 > _e1188));
                                                                let _e1205 = select(_e1201, _e1203, (_e1203 > _e1201));
                                                                if (_e1175 == _e1205) {
                                                                    phi_1645_ = _e1158;
                                                                    phi_1646_ = _e1162;
                                                                } else {
                                                                    let _e1208 = vec3((_e1188 == _e1205));
                                                                    phi_1645_ = select(_e1154, _e1162, _e1208);
                                                                    phi_1646_ = select(_e1158, _e1154, _e1208);
                                                                }
                                                                let _e1212 = phi_1645_;
                                                                let _e1214 = phi_1646_;
                                                                let _e1221 = ((_e1212.y * _e1214.z) - (_e1214.y * _e1212.z));
                                                                let _e1226 = ((_e1212.z * _e1214.x) - (_e1214.z * _e1212.x));
                                                                let _e1229 = ((_e1212.x * _e1214.y) - (_e1214.x * _e1212.y));
                                                                if (_e1071 >= _e1075) {
                                                                    phi_1677_ = select(true, false, (_e1071 >= _e1079));
                                                                } else {
                                                                    phi_1677_ = true;
                                                                }
                                                                let _e1234 = phi_1677_;
                                                                if _e1234 {
                                                                    phi_1686_ = select(vec3<f32>(_e1008[2][0], _e1008[2][1], _e1008[2][2]), vec3<f32>(_e1008[1][0], _e1008[1][1], _e1008[1][2]), vec3((_e1075 >= _e1079)));
                                                                } else {
                                                                    phi_1686_ = vec3<f32>(_e1008[0][0], _e1008[0][1], _e1008[0][2]);
                                                                }
                                                                let _e1239 = phi_1686_;
                                                                let _e1256 = ((((_e1221 * (_e1239.x - _e302)) + (_e1226 * (_e1239.y - _e341))) + (_e1229 * (_e1239.z - _e379))) / (((_e1221 * _e327) + (_e1226 * _e365)) + (_e1229 * _e403)));
                                                                let _e1258 = select(_e1138, _e1256, (_e1256 < _e1138));
                                                                let _e1260 = select(_e1130, _e1258, (_e1258 > _e1130));
                                                                if (_e1260 >= _e453) {
                                                                    let _e1262 = (_e1260 <= _e866.member.member_1);
                                                                    if _e1262 {
                                                                        let _e1263 = (1f / _e1081);
                                                                        phi_1726_ = type_21(_e1260, (_e1075 * _e1263), (_e1079 * _e1263), _e910);
                                                                    } else {
                                                                        phi_1726_ = type_21();
                                                                    }
                                                                    let _e1268 = phi_1726_;
                                                                    phi_1728_ = _e1268;
                                                                    phi_1729_ = select(true, false, _e1262);
                                                                } else {
                                                                    phi_1728_ = type_21();
                                                                    phi_1729_ = true;
                                                                }
                                                                let _e1271 = phi_1728_;
                                                                let _e1273 = phi_1729_;
                                                                if _e1273 {
                                                                    phi_1733_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1733_ = _e1271;
                                                                }
                                                                let _e1275 = phi_1733_;
                                                                phi_1734_ = _e1275;
                                                            }
                                                            let _e1277 = phi_1734_;
                                                            phi_1735_ = _e1277;
                                                            phi_1736_ = _e1147;
                                                        }
                                                        let _e1279 = phi_1735_;
                                                        let _e1281 = phi_1736_;
                                                        phi_1740_ = _e1279;
                                                        phi_1741_ = _e1281;
                                                    }
                                                    let _e1283 = phi_1740_;
                                                    let _e1285 = phi_1741_;
                                                    phi_1745_ = _e1283;
                                                    phi_1746_ = _e1285;
                                                } else {
                                                    phi_1745_ = type_21();
                                                    phi_1746_ = true;
                                                }
                                                let _e1287 = phi_1745_;
                                                let _e1289 = phi_1746_;
                                                if _e1289 {
                                                    phi_1750_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1750_ = _e1287;
                                                }
                                                let _e1291 = phi_1750_;
                                                if (_e1291.member_3 != 4294967295u) {
                                                    if (_e910 != 4294967295u) {
                                                        if (_e1291.member < _e866.member.member.member) {
                                                            phi_1776_ = true;
                                                        } else {
                                                            if (_e1291.member == _e866.member.member.member) {
                                                                phi_1775_ = (_e1291.member_3 < _e866.member.member.member_3);
                                                            } else {
                                                                phi_1775_ = false;
                                                            }
                                                            let _e1306 = phi_1775_;
                                                            phi_1776_ = _e1306;
                                                        }
                                                        let _e1308 = phi_1776_;
                                                        if _e1308 {
                                                            phi_1783_ = type_33(type_28(_e1291, _e1291.member), _e893.member_1, _e893.member_2);
                                                        } else {
                                                            phi_1783_ = _e893;
                                                        }
                                                        let _e1315 = phi_1783_;
                                                        phi_1784_ = _e1315;
                                                    } else {
                                                        phi_1784_ = _e893;
                                                    }
                                                    let _e1317 = phi_1784_;
                                                    phi_1785_ = _e1317;
                                                } else {
                                                    phi_1785_ = _e893;
                                                }
                                                let _e1319 = phi_1785_;
                                                phi_2865_ = _e1007;
                                                phi_919_ = _e1319;
                                            } else {
                                                phi_2865_ = _e864;
                                                phi_919_ = type_33();
                                            }
                                            let _e1321 = phi_2865_;
                                            let _e1323 = phi_919_;
                                            continue;
                                            continuing {
                                                phi_2859_ = _e1321;
                                                phi_918_ = _e1323;
                                                phi_921_ = _e881;
                                                phi_2864_ = _e1321;
                                                break if !(_e887);
                                            }
                                        }
                                        let _e1326 = phi_2864_;
                                        phi_2923_ = _e1326;
                                        if _e1326 {
                                            break;
                                        }
                                        phi_2927_ = _e1326;
                                        let _e1492 = local_25;
                                        phi_2670_ = _e1492;
                                        phi_2671_ = _e528;
                                        phi_2672_ = false;
                                        phi_2673_ = _e532;
                                    } else {
                                        local_10 = array<f32, 3>(_e528.member.member[0], _e528.member.member[1], _e528.member.member[2]);
                                        local_9 = array<f32, 3>(_e528.member.member_1[0], _e528.member.member_1[1], _e528.member.member_1[2]);
                                        let _e558 = (_e528.member_1 < _e90);
                                        if _e558 {
                                            if _e558 {
                                            } else {
                                                phi_2923_ = true;
                                                break;
                                            }
                                            let _e560 = global_4.member[_e528.member_1];
                                            phi_1822_ = _e560;
                                        } else {
                                            phi_1822_ = type_37(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e562 = phi_1822_;
                                        let _e564 = array<u32, 3>(_e253, _e252, _e254);
                                        local_17 = _e564;
                                        local_13 = array<f32, 3>(0f, 0f, 0f);
                                        local_12 = array<f32, 3>(0f, 0f, 0f);
                                        phi_1831_ = type_4(0u, 3u);
                                        loop {
                                            let _e566 = phi_1831_;
                                            if (_e566.member < _e566.member_1) {
                                                phi_1832_ = type_4((_e566.member + 1u), _e566.member_1);
                                                phi_1855_ = type_4(1u, _e566.member);
                                            } else {
                                                phi_1832_ = _e566;
                                                phi_1855_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e579 = phi_1832_;
                                            let _e581 = phi_1855_;
                                            let _e585 = (bitcast<i32>(_e581.member) != 0i);
                                            if _e585 {
                                                let _e586 = (_e581.member_1 < 3u);
                                                if _e586 {
                                                } else {
                                                    phi_2782_ = true;
                                                    break;
                                                }
                                                let _e588 = local_17[_e581.member_1];
                                                if _e586 {
                                                } else {
                                                    phi_2782_ = true;
                                                    break;
                                                }
                                                let _e590 = local_10[_e581.member_1];
                                                if _e586 {
                                                } else {
                                                    phi_2782_ = true;
                                                    break;
                                                }
                                                let _e592 = local_9[_e581.member_1];
                                                let _e595 = ((10u * _e588) & 31u);
                                                let _e598 = ((_e562.member[0] >> bitcast<u32>(_e595)) & 1023u);
                                                let _e603 = bitcast<f32>((bitcast<u32>(((_e592 - _e590) * 0.0009775171f)) ^ _e125));
                                                let _e609 = (_e590 + bitcast<f32>((bitcast<u32>((f32(_e598) * _e603)) ^ _e125)));
                                                if _e586 {
                                                } else {
                                                    phi_2782_ = true;
                                                    break;
                                                }
                                                local_13[_e581.member_1] = select(select(_e592, _e609, (_e609 < _e592)), _e592, (_e598 == 1023u));
                                                let _e618 = ((_e562.member[1] >> bitcast<u32>(_e595)) & 1023u);
                                                let _e624 = (_e590 + bitcast<f32>((bitcast<u32>((f32(_e618) * _e603)) ^ _e125)));
                                                if _e586 {
                                                } else {
                                                    phi_2782_ = true;
                                                    break;
                                                }
                                                local_12[_e581.member_1] = select(select(_e592, _e624, (_e624 < _e592)), _e592, (_e618 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_1831_ = _e579;
                                                phi_2782_ = _e486;
                                                break if !(_e585);
                                            }
                                        }
                                        let _e632 = phi_2782_;
                                        phi_2923_ = _e632;
                                        if _e632 {
                                            break;
                                        }
                                        let _e633 = local_12;
                                        let _e634 = local_13;
                                        local_16 = _e564;
                                        local_15 = array<f32, 3>(0f, 0f, 0f);
                                        local_14 = array<f32, 3>(0f, 0f, 0f);
                                        phi_1985_ = type_4(0u, 3u);
                                        loop {
                                            let _e643 = phi_1985_;
                                            if (_e643.member < _e643.member_1) {
                                                phi_1986_ = type_4((_e643.member + 1u), _e643.member_1);
                                                phi_2009_ = type_4(1u, _e643.member);
                                            } else {
                                                phi_1986_ = _e643;
                                                phi_2009_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e656 = phi_1986_;
                                            let _e658 = phi_2009_;
                                            let _e662 = (bitcast<i32>(_e658.member) != 0i);
                                            if _e662 {
                                                let _e663 = (_e658.member_1 < 3u);
                                                if _e663 {
                                                } else {
                                                    phi_2842_ = true;
                                                    break;
                                                }
                                                let _e665 = local_16[_e658.member_1];
                                                if _e663 {
                                                } else {
                                                    phi_2842_ = true;
                                                    break;
                                                }
                                                let _e667 = local_10[_e658.member_1];
                                                if _e663 {
                                                } else {
                                                    phi_2842_ = true;
                                                    break;
                                                }
                                                let _e669 = local_9[_e658.member_1];
                                                let _e672 = ((10u * _e665) & 31u);
                                                let _e675 = ((_e562.member_1[0] >> bitcast<u32>(_e672)) & 1023u);
                                                let _e680 = bitcast<f32>((bitcast<u32>(((_e669 - _e667) * 0.0009775171f)) ^ _e125));
                                                let _e686 = (_e667 + bitcast<f32>((bitcast<u32>((f32(_e675) * _e680)) ^ _e125)));
                                                if _e663 {
                                                } else {
                                                    phi_2842_ = true;
                                                    break;
                                                }
                                                local_15[_e658.member_1] = select(select(_e669, _e686, (_e686 < _e669)), _e669, (_e675 == 1023u));
                                                let _e695 = ((_e562.member_1[1] >> bitcast<u32>(_e672)) & 1023u);
                                                let _e701 = (_e667 + bitcast<f32>((bitcast<u32>((f32(_e695) * _e680)) ^ _e125)));
                                                if _e663 {
                                                } else {
                                                    phi_2842_ = true;
                                                    break;
                                                }
                                                local_14[_e658.member_1] = select(select(_e669, _e701, (_e701 < _e669)), _e669, (_e695 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_1985_ = _e656;
                                                phi_2842_ = _e632;
                                                break if !(_e662);
                                            }
                                        }
                                        let _e709 = phi_2842_;
                                        phi_2923_ = _e709;
                                        if _e709 {
                                            break;
                                        }
                                        let _e710 = local_14;
                                        let _e711 = local_15;
                                        let _e722 = type_51(type_43(array<f32, 3>(_e634[0], _e634[1], _e634[2]), array<f32, 3>(_e633[0], _e633[1], _e633[2])), _e562.member_2);
                                        let _e727 = type_51(type_43(array<f32, 3>(_e711[0], _e711[1], _e711[2]), array<f32, 3>(_e710[0], _e710[1], _e710[2])), _e562.member_3);
                                        let _e734 = ((_e634[0] - _e325) * _e330);
                                        let _e735 = ((_e711[0] - _e325) * _e330);
                                        let _e736 = ((_e633[0] - _e326) * _e330);
                                        let _e737 = ((_e710[0] - _e326) * _e330);
                                        let _e742 = ((_e634[1] - _e363) * _e368);
                                        let _e743 = ((_e711[1] - _e363) * _e368);
                                        let _e744 = ((_e633[1] - _e364) * _e368);
                                        let _e745 = ((_e710[1] - _e364) * _e368);
                                        let _e750 = ((_e634[2] - _e401) * _e406);
                                        let _e751 = ((_e711[2] - _e401) * _e406);
                                        let _e752 = ((_e633[2] - _e402) * _e406);
                                        let _e753 = ((_e710[2] - _e402) * _e406);
                                        let _e755 = select(_e752, _e750, (_e750 < _e752));
                                        let _e757 = select(_e753, _e751, (_e751 < _e753));
                                        let _e759 = select(_e752, _e750, (_e750 > _e752));
                                        let _e761 = select(_e753, _e751, (_e751 > _e753));
                                        let _e763 = select(_e736, _e734, (_e734 < _e736));
                                        let _e765 = select(_e737, _e735, (_e735 < _e737));
                                        let _e767 = select(_e744, _e742, (_e742 < _e744));
                                        let _e769 = select(_e745, _e743, (_e743 < _e745));
                                        let _e771 = select(_e767, _e763, (_e763 > _e767));
                                        let _e773 = select(_e769, _e765, (_e765 > _e769));
                                        let _e775 = select(_e755, _e771, (_e771 > _e755));
                                        let _e777 = select(_e757, _e773, (_e773 > _e757));
                                        let _e779 = select(_e736, _e734, (_e734 > _e736));
                                        let _e781 = select(_e737, _e735, (_e735 > _e737));
                                        let _e783 = select(_e744, _e742, (_e742 > _e744));
                                        let _e785 = select(_e745, _e743, (_e743 > _e745));
                                        let _e787 = select(_e783, _e779, (_e779 < _e783));
                                        let _e789 = select(_e785, _e781, (_e781 < _e785));
                                        let _e794 = -(_e755);
                                        let _e795 = -(_e757);
                                        let _e802 = (select(_e759, _e787, (_e787 < _e759)) + (select(_e794, _e759, (_e759 > _e794)) * 0.0000019073523f));
                                        let _e803 = (select(_e761, _e789, (_e789 < _e761)) + (select(_e795, _e761, (_e761 > _e795)) * 0.0000019073523f));
                                        let _e805 = select(_e453, _e775, (_e775 > _e453));
                                        let _e807 = select(_e453, _e777, (_e777 > _e453));
                                        let _e812 = (_e805 <= select(_e488.member.member_1, _e802, (_e802 < _e488.member.member_1)));
                                        let _e813 = (_e807 <= select(_e488.member.member_1, _e803, (_e803 < _e488.member.member_1)));
                                        let _e814 = (_e805 <= _e807);
                                        if _e812 {
                                            if _e813 {
                                                if _e814 {
                                                    phi_2572_ = _e727;
                                                } else {
                                                    phi_2572_ = _e722;
                                                }
                                                let _e816 = phi_2572_;
                                                let _e824 = (_e532 % 128u);
                                                let _e825 = (_e824 < 128u);
                                                if _e825 {
                                                } else {
                                                    phi_2923_ = true;
                                                    break;
                                                }
                                                local_6[_e824] = _e816.member_1;
                                                if _e825 {
                                                } else {
                                                    phi_2923_ = true;
                                                    break;
                                                }
                                                local_5[_e824] = _e816.member.member[0];
                                                if _e825 {
                                                } else {
                                                    phi_2923_ = true;
                                                    break;
                                                }
                                                local_4[_e824] = _e816.member.member[1];
                                                if _e825 {
                                                } else {
                                                    phi_2923_ = true;
                                                    break;
                                                }
                                                local_3[_e824] = _e816.member.member[2];
                                                if _e825 {
                                                } else {
                                                    phi_2923_ = true;
                                                    break;
                                                }
                                                local_2[_e824] = _e816.member.member_1[0];
                                                if _e825 {
                                                } else {
                                                    phi_2923_ = true;
                                                    break;
                                                }
                                                local_1[_e824] = _e816.member.member_1[1];
                                                if _e825 {
                                                } else {
                                                    phi_2923_ = true;
                                                    break;
                                                }
                                                local[_e824] = _e816.member.member_1[2];
                                                if _e825 {
                                                } else {
                                                    phi_2923_ = true;
                                                    break;
                                                }
                                                local_11[_e824] = select(_e807, _e805, (_e805 > _e807));
                                                if _e814 {
                                                    phi_2649_ = _e722;
                                                } else {
                                                    phi_2649_ = _e727;
                                                }
                                                let _e842 = phi_2649_;
                                                phi_2650_ = _e842;
                                                phi_2651_ = (_e532 + 1u);
                                            } else {
                                                phi_2650_ = type_51();
                                                phi_2651_ = u32();
                                            }
                                            let _e844 = phi_2650_;
                                            let _e846 = phi_2651_;
                                            phi_2653_ = _e844;
                                            phi_2654_ = _e846;
                                            phi_2655_ = select(true, false, _e813);
                                        } else {
                                            phi_2653_ = type_51();
                                            phi_2654_ = u32();
                                            phi_2655_ = true;
                                        }
                                        let _e849 = phi_2653_;
                                        let _e851 = phi_2654_;
                                        let _e853 = phi_2655_;
                                        if _e853 {
                                            if _e812 {
                                                phi_2662_ = _e722;
                                            } else {
                                                phi_2662_ = _e727;
                                            }
                                            let _e855 = phi_2662_;
                                            phi_2667_ = _e855;
                                            phi_2668_ = select(_e813, true, _e812);
                                        } else {
                                            phi_2667_ = _e849;
                                            phi_2668_ = _e530;
                                        }
                                        let _e858 = phi_2667_;
                                        let _e860 = phi_2668_;
                                        phi_2927_ = _e709;
                                        phi_2670_ = type_33(_e488.member, (_e488.member_1 + 1u), _e488.member_2);
                                        phi_2671_ = _e858;
                                        phi_2672_ = _e860;
                                        phi_2673_ = select(_e851, _e532, _e853);
                                    }
                                    let _e1328 = phi_2927_;
                                    let _e1330 = phi_2670_;
                                    let _e1332 = phi_2671_;
                                    let _e1334 = phi_2672_;
                                    let _e1336 = phi_2673_;
                                    phi_2926_ = _e1328;
                                    phi_2674_ = _e1330;
                                    phi_2675_ = _e1332;
                                    phi_2676_ = (_e492 - 1u);
                                    phi_2677_ = _e1334;
                                    phi_2678_ = _e1336;
                                } else {
                                    phi_2926_ = _e486;
                                    phi_2674_ = _e488;
                                    phi_2675_ = _e528;
                                    phi_2676_ = _e492;
                                    phi_2677_ = _e530;
                                    phi_2678_ = _e532;
                                }
                                let _e1338 = phi_2926_;
                                let _e1340 = phi_2674_;
                                let _e1342 = phi_2675_;
                                let _e1344 = phi_2676_;
                                let _e1346 = phi_2677_;
                                let _e1348 = phi_2678_;
                                phi_2925_ = _e1338;
                                phi_2679_ = _e1340;
                                phi_2680_ = _e1342;
                                phi_2681_ = _e1344;
                                phi_2682_ = _e1346;
                                phi_2683_ = _e1348;
                            } else {
                                phi_2925_ = _e486;
                                phi_2679_ = type_33();
                                phi_2680_ = type_51();
                                phi_2681_ = u32();
                                phi_2682_ = bool();
                                phi_2683_ = u32();
                            }
                            let _e1350 = phi_2925_;
                            let _e1352 = phi_2679_;
                            let _e1354 = phi_2680_;
                            let _e1356 = phi_2681_;
                            let _e1358 = phi_2682_;
                            let _e1360 = phi_2683_;
                            phi_2924_ = _e1350;
                            phi_792_ = _e1352;
                            phi_795_ = _e1354;
                            phi_797_ = _e1356;
                            phi_799_ = _e1358;
                            phi_801_ = _e1360;
                            phi_2684_ = _e500;
                        } else {
                            phi_2924_ = _e486;
                            phi_792_ = type_33();
                            phi_795_ = type_51();
                            phi_797_ = u32();
                            phi_799_ = bool();
                            phi_801_ = u32();
                            phi_2684_ = false;
                        }
                        let _e1362 = phi_2924_;
                        let _e1364 = phi_792_;
                        let _e1366 = phi_795_;
                        let _e1368 = phi_797_;
                        let _e1370 = phi_799_;
                        let _e1372 = phi_801_;
                        let _e1374 = phi_2684_;
                        continue;
                        continuing {
                            phi_2789_ = _e1362;
                            phi_791_ = _e1364;
                            phi_794_ = _e1366;
                            phi_796_ = _e1368;
                            phi_798_ = _e1370;
                            phi_800_ = _e1372;
                            phi_2923_ = _e1362;
                            break if !(_e1374);
                        }
                    }
                    let _e1377 = phi_2923_;
                    if _e1377 {
                        break;
                    }
                    let _e1379 = local_23;
                    let _e1382 = local_24;
                    if _e141 {
                    } else {
                        break;
                    }
                    global_5.member[_e139][0u] = _e1379.member_1;
                    global_5.member[_e139][1u] = _e1382.member_2;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_counted_printed_leaf10_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
