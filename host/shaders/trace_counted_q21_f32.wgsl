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

struct type_21 {
    member: array<array<u32, 2>>,
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

struct type_29 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_33 {
    member: type_25,
    member_1: f32,
}

struct type_38 {
    member: array<type_26>,
}

struct type_40 {
    member: type_33,
    member_1: u32,
    member_2: u32,
}

struct type_42 {
    member: array<vec4<u32>, 2>,
}

struct type_46 {
    member: array<array<u32, 7>>,
}

struct type_51 {
    member: type_29,
    member_1: u32,
}

struct type_52 {
    member: array<vec4<f32>, 3>,
    member_1: type_51,
    member_2: type_51,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(3) 
var<storage> global_2: type_15;
@group(0) @binding(1) 
var<uniform> global_3: type_42;
@group(0) @binding(4) 
var<storage> global_4: type_38;
@group(0) @binding(2) 
var<storage> global_5: type_46;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_21;

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
    var phi_375_: i32;
    var phi_376_: i32;
    var phi_386_: bool;
    var phi_396_: u32;
    var phi_397_: u32;
    var phi_399_: bool;
    var phi_404_: u32;
    var phi_416_: i32;
    var phi_436_: i32;
    var phi_454_: f32;
    var phi_460_: f32;
    var phi_471_: f32;
    var phi_477_: f32;
    var phi_500_: f32;
    var phi_511_: f32;
    var phi_520_: f32;
    var phi_526_: f32;
    var phi_537_: f32;
    var phi_543_: f32;
    var phi_566_: f32;
    var phi_577_: f32;
    var phi_586_: f32;
    var phi_592_: f32;
    var phi_603_: f32;
    var phi_609_: f32;
    var phi_632_: f32;
    var phi_643_: f32;
    var phi_743_: f32;
    var phi_744_: f32;
    var phi_3144_: bool;
    var phi_834_: type_40;
    var phi_837_: type_51;
    var phi_839_: u32;
    var phi_841_: bool;
    var phi_843_: u32;
    var phi_854_: bool;
    var phi_940_: type_51;
    var phi_941_: bool;
    var phi_942_: u32;
    var phi_2435_: u32;
    var phi_2436_: u32;
    var phi_2446_: u32;
    var phi_2448_: u32;
    var phi_2449_: bool;
    var phi_2469_: u32;
    var phi_2470_: u32;
    var phi_2474_: type_52;
    var phi_2818_: type_51;
    var phi_2895_: type_51;
    var phi_2896_: type_51;
    var phi_2897_: u32;
    var phi_2899_: type_51;
    var phi_2900_: u32;
    var phi_2901_: bool;
    var phi_2910_: type_51;
    var phi_2915_: type_51;
    var phi_2916_: bool;
    var phi_960_: type_40;
    var phi_963_: type_4;
    var phi_964_: type_4;
    var phi_986_: type_4;
    var phi_1010_: u32;
    var phi_1099_: array<array<f32, 3>, 3>;
    var phi_1570_: vec3<f32>;
    var phi_1571_: vec3<f32>;
    var phi_1602_: bool;
    var phi_1611_: vec3<f32>;
    var phi_1651_: type_25;
    var phi_1653_: type_25;
    var phi_1654_: bool;
    var phi_1658_: type_25;
    var phi_1659_: type_25;
    var phi_1660_: type_25;
    var phi_1661_: bool;
    var phi_1665_: type_25;
    var phi_1666_: bool;
    var phi_1670_: type_25;
    var phi_1671_: bool;
    var phi_1675_: type_25;
    var phi_1700_: bool;
    var phi_1701_: bool;
    var phi_1708_: type_40;
    var phi_1709_: type_40;
    var phi_1710_: type_40;
    var phi_961_: type_40;
    var phi_3138_: bool;
    var phi_3256_: bool;
    var phi_2918_: type_40;
    var phi_2919_: type_51;
    var phi_2920_: bool;
    var phi_2921_: u32;
    var phi_3255_: bool;
    var phi_2922_: type_40;
    var phi_2923_: type_51;
    var phi_2924_: u32;
    var phi_2925_: bool;
    var phi_2926_: u32;
    var phi_3254_: bool;
    var phi_2927_: type_40;
    var phi_2928_: type_51;
    var phi_2929_: u32;
    var phi_2930_: bool;
    var phi_2931_: u32;
    var phi_3253_: bool;
    var phi_835_: type_40;
    var phi_838_: type_51;
    var phi_840_: u32;
    var phi_842_: bool;
    var phi_844_: u32;
    var phi_2932_: bool;
    var phi_3252_: bool;
    var local_10: type_40;
    var local_11: type_40;
    var local_12: type_40;

    switch bitcast<i32>(0u) {
        default: {
            let _e81 = global;
            let _e83 = arrayLength((&global_5.member));
            let _e85 = arrayLength((&global_2.member));
            let _e93 = global_3.member[0u][0u];
            let _e97 = global_3.member[0u][1u];
            let _e101 = global_3.member[0u][2u];
            let _e105 = global_3.member[0u][3u];
            let _e109 = global_3.member[1u][0u];
            let _e113 = global_3.member[1u][1u];
            let _e117 = global_3.member[1u][2u];
            let _e120 = global_1.member[0u];
            let _e121 = bitcast<i32>(_e120);
            let _e133 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e105) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e93), bitcast<i32>(_e97), bitcast<i32>(_e101));
            local = array<i32, 3>(bitcast<i32>(_e109), bitcast<i32>(_e113), bitcast<i32>(_e117));
            let _e139 = (_e81.x + (_e81.y * 2097152u));
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
                            phi_375_ = (bitcast<i32>((_e218 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_375_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e218)), 32u, (_e218 == 0u))));
                        }
                        let _e232 = phi_375_;
                        phi_376_ = _e232;
                    } else {
                        phi_376_ = 0i;
                    }
                    let _e234 = phi_376_;
                    let _e235 = (_e151 == _e190);
                    if _e235 {
                        phi_386_ = true;
                    } else {
                        phi_386_ = (_e158 == _e190);
                    }
                    let _e238 = phi_386_;
                    let _e239 = select(1u, 0u, _e235);
                    if _e238 {
                        let _e240 = (_e239 + 1u);
                        phi_396_ = _e240;
                        phi_397_ = _e240;
                        phi_399_ = select(true, false, (_e240 == 2u));
                    } else {
                        phi_396_ = u32();
                        phi_397_ = 0u;
                        phi_399_ = true;
                    }
                    let _e244 = phi_396_;
                    let _e246 = phi_397_;
                    let _e248 = phi_399_;
                    if _e248 {
                        phi_404_ = (_e246 + 1u);
                    } else {
                        phi_404_ = 0u;
                    }
                    let _e252 = phi_404_;
                    let _e253 = select(_e244, _e246, _e248);
                    let _e254 = select(_e239, select(2u, _e239, _e238), _e248);
                    if (_e121 < -126i) {
                        phi_416_ = -126i;
                    } else {
                        phi_416_ = select(_e121, 127i, (_e121 > 127i));
                    }
                    let _e259 = phi_416_;
                    let _e264 = bitcast<f32>((bitcast<u32>((_e259 + 127i)) << bitcast<u32>(23i)));
                    let _e270 = bitcast<f32>((bitcast<u32>(((_e121 - _e259) + 127i)) << bitcast<u32>(23i)));
                    let _e271 = -(_e234);
                    if (_e271 < -126i) {
                        phi_436_ = -126i;
                    } else {
                        phi_436_ = select(_e271, 127i, (_e271 > 127i));
                    }
                    let _e276 = phi_436_;
                    let _e281 = bitcast<f32>((bitcast<u32>((_e276 + 127i)) << bitcast<u32>(23i)));
                    let _e287 = bitcast<f32>((bitcast<u32>(((_e271 - _e276) + 127i)) << bitcast<u32>(23i)));
                    let _e291 = global_4.member[_e139].member;
                    let _e292 = (_e253 == 0u);
                    if _e292 {
                        phi_454_ = _e291[0];
                    } else {
                        phi_454_ = _e291[1];
                    }
                    let _e296 = phi_454_;
                    let _e297 = (_e253 == 2u);
                    if _e297 {
                        phi_460_ = _e291[2];
                    } else {
                        phi_460_ = _e296;
                    }
                    let _e300 = phi_460_;
                    let _e302 = ((_e300 * _e264) * _e270);
                    let _e303 = global_4.member[_e139].member_2;
                    if _e292 {
                        phi_471_ = _e303[0];
                    } else {
                        phi_471_ = _e303[1];
                    }
                    let _e307 = phi_471_;
                    if _e297 {
                        phi_477_ = _e303[2];
                    } else {
                        phi_477_ = _e307;
                    }
                    let _e310 = phi_477_;
                    let _e312 = ((_e310 * _e281) * _e287);
                    let _e316 = (bitcast<f32>((bitcast<u32>(_e312) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e316 {
                        let _e320 = (bitcast<f32>((bitcast<u32>(_e302) & 2147483647u)) * 0.00000011920929f);
                        phi_500_ = select(0.00000000000011368684f, _e320, (_e320 > 0.00000000000011368684f));
                    } else {
                        phi_500_ = 0f;
                    }
                    let _e324 = phi_500_;
                    let _e325 = (_e302 + _e324);
                    let _e326 = (_e302 - _e324);
                    let _e327 = select(_e312, 0f, _e316);
                    if _e316 {
                        phi_511_ = 38685626000000000000000000f;
                    } else {
                        phi_511_ = (1f / _e312);
                    }
                    let _e330 = phi_511_;
                    let _e331 = (_e252 == 0u);
                    if _e331 {
                        phi_520_ = _e291[0];
                    } else {
                        phi_520_ = _e291[1];
                    }
                    let _e335 = phi_520_;
                    let _e336 = (_e252 == 2u);
                    if _e336 {
                        phi_526_ = _e291[2];
                    } else {
                        phi_526_ = _e335;
                    }
                    let _e339 = phi_526_;
                    let _e341 = ((_e339 * _e264) * _e270);
                    if _e331 {
                        phi_537_ = _e303[0];
                    } else {
                        phi_537_ = _e303[1];
                    }
                    let _e345 = phi_537_;
                    if _e336 {
                        phi_543_ = _e303[2];
                    } else {
                        phi_543_ = _e345;
                    }
                    let _e348 = phi_543_;
                    let _e350 = ((_e348 * _e281) * _e287);
                    let _e354 = (bitcast<f32>((bitcast<u32>(_e350) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e354 {
                        let _e358 = (bitcast<f32>((bitcast<u32>(_e341) & 2147483647u)) * 0.00000011920929f);
                        phi_566_ = select(0.00000000000011368684f, _e358, (_e358 > 0.00000000000011368684f));
                    } else {
                        phi_566_ = 0f;
                    }
                    let _e362 = phi_566_;
                    let _e363 = (_e341 + _e362);
                    let _e364 = (_e341 - _e362);
                    let _e365 = select(_e350, 0f, _e354);
                    if _e354 {
                        phi_577_ = 38685626000000000000000000f;
                    } else {
                        phi_577_ = (1f / _e350);
                    }
                    let _e368 = phi_577_;
                    let _e369 = (_e254 == 0u);
                    if _e369 {
                        phi_586_ = _e291[0];
                    } else {
                        phi_586_ = _e291[1];
                    }
                    let _e373 = phi_586_;
                    let _e374 = (_e254 == 2u);
                    if _e374 {
                        phi_592_ = _e291[2];
                    } else {
                        phi_592_ = _e373;
                    }
                    let _e377 = phi_592_;
                    let _e379 = ((_e377 * _e264) * _e270);
                    if _e369 {
                        phi_603_ = _e303[0];
                    } else {
                        phi_603_ = _e303[1];
                    }
                    let _e383 = phi_603_;
                    if _e374 {
                        phi_609_ = _e303[2];
                    } else {
                        phi_609_ = _e383;
                    }
                    let _e386 = phi_609_;
                    let _e388 = ((_e386 * _e281) * _e287);
                    let _e392 = (bitcast<f32>((bitcast<u32>(_e388) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e392 {
                        let _e396 = (bitcast<f32>((bitcast<u32>(_e379) & 2147483647u)) * 0.00000011920929f);
                        phi_632_ = select(0.00000000000011368684f, _e396, (_e396 > 0.00000000000011368684f));
                    } else {
                        phi_632_ = 0f;
                    }
                    let _e400 = phi_632_;
                    let _e401 = (_e379 + _e400);
                    let _e402 = (_e379 - _e400);
                    let _e403 = select(_e388, 0f, _e392);
                    if _e392 {
                        phi_643_ = 38685626000000000000000000f;
                    } else {
                        phi_643_ = (1f / _e388);
                    }
                    let _e406 = phi_643_;
                    let _e409 = bitcast<f32>((bitcast<u32>(_e302) & 2147483647u));
                    let _e412 = bitcast<f32>((bitcast<u32>(_e341) & 2147483647u));
                    let _e414 = select(_e412, _e409, (_e409 > _e412));
                    let _e417 = bitcast<f32>((bitcast<u32>(_e379) & 2147483647u));
                    let _e420 = (_e121 + _e234);
                    if (_e215 && (select(_e417, _e414, (_e414 > _e417)) <= 1099511600000f)) {
                        let _e423 = (_e420 / 3i);
                        let _e430 = bitcast<f32>((bitcast<u32>((_e423 + 127i)) << bitcast<u32>(23i)));
                        let _e437 = bitcast<f32>((bitcast<u32>(((_e420 - (2i * _e423)) + 127i)) << bitcast<u32>(23i)));
                        let _e438 = (((_e200 * _e430) * _e430) * _e437);
                        let _e440 = select(340282350000000000000000000000000000000f, _e438, (_e438 < 340282350000000000000000000000000000000f));
                        let _e445 = (((_e209 * _e430) * _e430) * _e437);
                        let _e447 = select(340282350000000000000000000000000000000f, _e445, (_e445 < 340282350000000000000000000000000000000f));
                        phi_743_ = select(-340282350000000000000000000000000000000f, _e447, (_e447 > -340282350000000000000000000000000000000f));
                        phi_744_ = select(-340282350000000000000000000000000000000f, _e440, (_e440 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_743_ = 0f;
                        phi_744_ = 1f;
                    }
                    let _e451 = phi_743_;
                    let _e453 = phi_744_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e458 = (_e253 % 3u);
                    let _e459 = (_e458 < 3u);
                    if _e459 {
                    } else {
                        break;
                    }
                    let _e461 = local_1[_e458];
                    let _e464 = (_e252 % 3u);
                    let _e465 = (_e464 < 3u);
                    if _e465 {
                    } else {
                        break;
                    }
                    let _e467 = local_1[_e464];
                    let _e470 = (_e254 % 3u);
                    let _e471 = (_e470 < 3u);
                    if _e471 {
                    } else {
                        break;
                    }
                    let _e473 = local_1[_e470];
                    if _e459 {
                    } else {
                        break;
                    }
                    let _e478 = local[_e458];
                    if _e465 {
                    } else {
                        break;
                    }
                    let _e482 = local[_e464];
                    if _e471 {
                    } else {
                        break;
                    }
                    let _e486 = local[_e470];
                    phi_3144_ = false;
                    phi_834_ = type_40(type_33(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e451), 0u, 0u);
                    phi_837_ = type_51(type_29(vec4<f32>((f32(_e461) * _e133), (f32(_e467) * _e133), (f32(_e473) * _e133), 0f), vec4<f32>((f32(_e478) * _e133), (f32(_e482) * _e133), (f32(_e486) * _e133), 0f)), select(0u, 2147483648u, (_e83 == 0u)));
                    phi_839_ = ((3u * _e83) + 1u);
                    phi_841_ = (_e453 <= _e451);
                    phi_843_ = 0u;
                    loop {
                        let _e496 = phi_3144_;
                        let _e498 = phi_834_;
                        let _e500 = phi_837_;
                        let _e502 = phi_839_;
                        let _e504 = phi_841_;
                        let _e506 = phi_843_;
                        local_10 = _e498;
                        local_11 = _e498;
                        if _e504 {
                            phi_854_ = true;
                        } else {
                            phi_854_ = (_e506 > 0u);
                        }
                        let _e509 = phi_854_;
                        if _e509 {
                            let _e510 = (_e502 > 0u);
                            if _e510 {
                                if _e504 {
                                    phi_940_ = _e500;
                                    phi_941_ = _e504;
                                    phi_942_ = _e506;
                                } else {
                                    let _e511 = (_e506 - 1u);
                                    let _e512 = (_e511 % 128u);
                                    let _e513 = (_e512 < 128u);
                                    if _e513 {
                                    } else {
                                        phi_3252_ = true;
                                        break;
                                    }
                                    let _e515 = local_7[_e512];
                                    if _e513 {
                                    } else {
                                        phi_3252_ = true;
                                        break;
                                    }
                                    let _e517 = local_6[_e512];
                                    if _e513 {
                                    } else {
                                        phi_3252_ = true;
                                        break;
                                    }
                                    let _e519 = local_5[_e512];
                                    if _e513 {
                                    } else {
                                        phi_3252_ = true;
                                        break;
                                    }
                                    let _e521 = local_4[_e512];
                                    if _e513 {
                                    } else {
                                        phi_3252_ = true;
                                        break;
                                    }
                                    let _e523 = local_3[_e512];
                                    if _e513 {
                                    } else {
                                        phi_3252_ = true;
                                        break;
                                    }
                                    let _e525 = local_2[_e512];
                                    if _e513 {
                                    } else {
                                        phi_3252_ = true;
                                        break;
                                    }
                                    let _e530 = local_8[_e512];
                                    if _e513 {
                                    } else {
                                        phi_3252_ = true;
                                        break;
                                    }
                                    let _e533 = local_9[_e512];
                                    phi_940_ = type_51(type_29(vec4<f32>(_e515, _e517, _e519, 0f), vec4<f32>(_e521, _e523, _e525, 0f)), _e530);
                                    phi_941_ = (_e533 <= _e498.member.member_1);
                                    phi_942_ = _e511;
                                }
                                let _e538 = phi_940_;
                                let _e540 = phi_941_;
                                let _e542 = phi_942_;
                                if _e540 {
                                    if ((_e538.member_1 & 2147483648u) != 0u) {
                                        phi_960_ = _e498;
                                        phi_963_ = type_4(0u, ((_e538.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1011 = phi_960_;
                                            let _e1013 = phi_963_;
                                            local_12 = _e1011;
                                            if (_e1013.member < _e1013.member_1) {
                                                phi_964_ = type_4((_e1013.member + 1u), _e1013.member_1);
                                                phi_986_ = type_4(1u, _e1013.member);
                                            } else {
                                                phi_964_ = _e1013;
                                                phi_986_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1026 = phi_964_;
                                            let _e1028 = phi_986_;
                                            let _e1032 = (bitcast<i32>(_e1028.member) != 0i);
                                            if _e1032 {
                                                let _e1038 = type_40(_e1011.member, _e1011.member_1, (_e1011.member_2 + 1u));
                                                let _e1039 = ((_e538.member_1 & 268435455u) + _e1028.member_1);
                                                let _e1040 = (_e1039 < _e85);
                                                if _e1040 {
                                                    if _e1040 {
                                                    } else {
                                                        phi_3138_ = true;
                                                        break;
                                                    }
                                                    let _e1044 = global_2.member[_e1039].member_1;
                                                    phi_1010_ = _e1044;
                                                } else {
                                                    phi_1010_ = 4294967295u;
                                                }
                                                let _e1046 = phi_1010_;
                                                if (_e1039 >= _e85) {
                                                    phi_1099_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1040 {
                                                    } else {
                                                        phi_3138_ = true;
                                                        break;
                                                    }
                                                    if (_e458 < 9u) {
                                                    } else {
                                                        phi_3138_ = true;
                                                        break;
                                                    }
                                                    let _e1053 = global_2.member[_e1039].member[_e458];
                                                    if (_e464 < 9u) {
                                                    } else {
                                                        phi_3138_ = true;
                                                        break;
                                                    }
                                                    let _e1059 = global_2.member[_e1039].member[_e464];
                                                    if (_e470 < 9u) {
                                                    } else {
                                                        phi_3138_ = true;
                                                        break;
                                                    }
                                                    let _e1065 = global_2.member[_e1039].member[_e470];
                                                    let _e1067 = (3u + _e458);
                                                    if (_e1067 < 9u) {
                                                    } else {
                                                        phi_3138_ = true;
                                                        break;
                                                    }
                                                    let _e1073 = global_2.member[_e1039].member[_e1067];
                                                    let _e1074 = (3u + _e464);
                                                    if (_e1074 < 9u) {
                                                    } else {
                                                        phi_3138_ = true;
                                                        break;
                                                    }
                                                    let _e1080 = global_2.member[_e1039].member[_e1074];
                                                    let _e1081 = (3u + _e470);
                                                    if (_e1081 < 9u) {
                                                    } else {
                                                        phi_3138_ = true;
                                                        break;
                                                    }
                                                    let _e1087 = global_2.member[_e1039].member[_e1081];
                                                    let _e1089 = (6u + _e458);
                                                    if (_e1089 < 9u) {
                                                    } else {
                                                        phi_3138_ = true;
                                                        break;
                                                    }
                                                    let _e1095 = global_2.member[_e1039].member[_e1089];
                                                    let _e1096 = (6u + _e464);
                                                    if (_e1096 < 9u) {
                                                    } else {
                                                        phi_3138_ = true;
                                                        break;
                                                    }
                                                    let _e1102 = global_2.member[_e1039].member[_e1096];
                                                    let _e1103 = (6u + _e470);
                                                    if (_e1103 < 9u) {
                                                    } else {
                                                        phi_3138_ = true;
                                                        break;
                                                    }
                                                    let _e1109 = global_2.member[_e1039].member[_e1103];
                                                    phi_1099_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1053, _e1059, _e1065), array<f32, 3>(_e1073, _e1080, _e1087), array<f32, 3>(_e1095, _e1102, _e1109));
                                                }
                                                let _e1113 = phi_1099_;
                                                let _e1122 = (_e1113[0][2] - _e379);
                                                let _e1125 = (((_e1113[0][0] - _e302) * _e403) - (_e1122 * _e327));
                                                let _e1128 = (((_e1113[0][1] - _e341) * _e403) - (_e1122 * _e365));
                                                let _e1135 = (_e1113[1][2] - _e379);
                                                let _e1138 = (((_e1113[1][0] - _e302) * _e403) - (_e1135 * _e327));
                                                let _e1141 = (((_e1113[1][1] - _e341) * _e403) - (_e1135 * _e365));
                                                let _e1148 = (_e1113[2][2] - _e379);
                                                let _e1151 = (((_e1113[2][0] - _e302) * _e403) - (_e1148 * _e327));
                                                let _e1154 = (((_e1113[2][1] - _e341) * _e403) - (_e1148 * _e365));
                                                let _e1155 = (_e1151 * _e1141);
                                                let _e1156 = (_e1154 * _e1138);
                                                let _e1157 = (_e1125 * _e1154);
                                                let _e1158 = (_e1128 * _e1151);
                                                let _e1159 = (_e1138 * _e1128);
                                                let _e1160 = (_e1141 * _e1125);
                                                let _e1165 = (((_e1155 >= _e1156) && (_e1157 >= _e1158)) && (_e1159 >= _e1160));
                                                if (_e1165 || (((_e1155 <= _e1156) && (_e1157 <= _e1158)) && (_e1159 <= _e1160))) {
                                                    let _e1172 = select(-1f, 1f, _e1165);
                                                    let _e1174 = ((_e1155 - _e1156) * _e1172);
                                                    let _e1176 = select(0f, _e1174, (_e1174 > 0f));
                                                    let _e1178 = ((_e1157 - _e1158) * _e1172);
                                                    let _e1180 = select(0f, _e1178, (_e1178 > 0f));
                                                    let _e1182 = ((_e1159 - _e1160) * _e1172);
                                                    let _e1184 = select(0f, _e1182, (_e1182 > 0f));
                                                    let _e1186 = ((_e1176 + _e1180) + _e1184);
                                                    if (_e1186 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1665_ = type_25();
                                                        phi_1666_ = true;
                                                    } else {
                                                        let _e1189 = select(_e1113[1][0], _e1113[0][0], (_e1113[0][0] < _e1113[1][0]));
                                                        let _e1193 = select(_e1113[1][0], _e1113[0][0], (_e1113[0][0] > _e1113[1][0]));
                                                        let _e1197 = select(_e1113[1][1], _e1113[0][1], (_e1113[0][1] < _e1113[1][1]));
                                                        let _e1201 = select(_e1113[1][1], _e1113[0][1], (_e1113[0][1] > _e1113[1][1]));
                                                        let _e1205 = select(_e1113[1][2], _e1113[0][2], (_e1113[0][2] < _e1113[1][2]));
                                                        let _e1209 = select(_e1113[1][2], _e1113[0][2], (_e1113[0][2] > _e1113[1][2]));
                                                        let _e1214 = ((select(_e1113[2][0], _e1189, (_e1189 < _e1113[2][0])) - _e325) * _e330);
                                                        let _e1215 = ((select(_e1113[2][0], _e1193, (_e1193 > _e1113[2][0])) - _e326) * _e330);
                                                        let _e1218 = ((select(_e1113[2][1], _e1197, (_e1197 < _e1113[2][1])) - _e363) * _e368);
                                                        let _e1219 = ((select(_e1113[2][1], _e1201, (_e1201 > _e1113[2][1])) - _e364) * _e368);
                                                        let _e1222 = ((select(_e1113[2][2], _e1205, (_e1205 < _e1113[2][2])) - _e401) * _e406);
                                                        let _e1223 = ((select(_e1113[2][2], _e1209, (_e1209 > _e1113[2][2])) - _e402) * _e406);
                                                        let _e1225 = select(_e1223, _e1222, (_e1222 < _e1223));
                                                        let _e1227 = select(_e1223, _e1222, (_e1222 > _e1223));
                                                        let _e1229 = select(_e1215, _e1214, (_e1214 < _e1215));
                                                        let _e1231 = select(_e1219, _e1218, (_e1218 < _e1219));
                                                        let _e1233 = select(_e1231, _e1229, (_e1229 > _e1231));
                                                        let _e1235 = select(_e1225, _e1233, (_e1233 > _e1225));
                                                        let _e1237 = select(_e1215, _e1214, (_e1214 > _e1215));
                                                        let _e1239 = select(_e1219, _e1218, (_e1218 > _e1219));
                                                        let _e1241 = select(_e1239, _e1237, (_e1237 < _e1239));
                                                        let _e1243 = select(_e1227, _e1241, (_e1241 < _e1227));
                                                        let _e1244 = -(_e1225);
                                                        let _e1250 = select(_e453, _e1235, (_e1235 > _e453));
                                                        if (_e1250 > (_e1243 + (select(_e1244, _e1227, (_e1227 > _e1244)) * 0.0000019073523f))) {
                                                            phi_1660_ = type_25();
                                                            phi_1661_ = true;
                                                        } else {
                                                            let _e1252 = (_e1250 > _e1011.member.member_1);
                                                            if _e1252 {
                                                                phi_1659_ = type_25();
                                                            } else {
                                                                let _e1256 = (_e1113[1][0] - _e1113[0][0]);
                                                                let _e1257 = (_e1113[1][1] - _e1113[0][1]);
                                                                let _e1258 = (_e1113[1][2] - _e1113[0][2]);
                                                                let _e1259 = vec3<f32>(_e1256, _e1257, _e1258);
                                                                let _e1260 = (_e1113[2][0] - _e1113[1][0]);
                                                                let _e1261 = (_e1113[2][1] - _e1113[1][1]);
                                                                let _e1262 = (_e1113[2][2] - _e1113[1][2]);
                                                                let _e1263 = vec3<f32>(_e1260, _e1261, _e1262);
                                                                let _e1264 = (_e1113[0][0] - _e1113[2][0]);
                                                                let _e1265 = (_e1113[0][1] - _e1113[2][1]);
                                                                let _e1266 = (_e1113[0][2] - _e1113[2][2]);
                                                                let _e1267 = vec3<f32>(_e1264, _e1265, _e1266);
                                                                let _e1270 = bitcast<f32>((bitcast<u32>(_e1256) & 2147483647u));
                                                                let _e1273 = bitcast<f32>((bitcast<u32>(_e1257) & 2147483647u));
                                                                let _e1275 = select(_e1273, _e1270, (_e1270 > _e1273));
                                                                let _e1278 = bitcast<f32>((bitcast<u32>(_e1258) & 2147483647u));
                                                                let _e1280 = select(_e1278, _e1275, (_e1275 > _e1278));
                                                                let _e1283 = bitcast<f32>((bitcast<u32>(_e1260) & 2147483647u));
                                                                let _e1286 = bitcast<f32>((bitcast<u32>(_e1261) & 2147483647u));
                                                                let _e1288 = select(_e1286, _e1283, (_e1283 > _e1286));
                                                                let _e1291 = bitcast<f32>((bitcast<u32>(_e1262) & 2147483647u));
                                                                let _e1293 = select(_e1291, _e1288, (_e1288 > _e1291));
                                                                let _e1296 = bitcast<f32>((bitcast<u32>(_e1264) & 2147483647u));
                                                                let _e1299 = bitcast<f32>((bitcast<u32>(_e1265) & 2147483647u));
                                                                let _e1301 = select(_e1299, _e1296, (_e1296 > _e1299));
                                                                let _e1304 = bitcast<f32>((bitcast<u32>(_e1266) & 2147483647u));
                                                                let _e1306 = select(_e1304, _e1301, (_e1301 > _e1304));
                                                                let _e1308 = select(_e1293, _e1280, (_e1280 > _e1293));
                                                                let _e1310 = select(_e1306, _e1308, (_e1308 > _e1306));
                                                                if (_e1280 == _e1310) {
                                                                    phi_1570_ = _e1263;
                                                                    phi_1571_ = _e1267;
                                                                } else {
                                                                    let _e1313 = vec3((_e1293 == _e1310));
                                                                    phi_1570_ = select(_e1259, _e1267, _e1313);
                                                                    phi_1571_ = select(_e1263, _e1259, _e1313);
                                                                }
                                                                let _e1317 = phi_1570_;
                                                                let _e1319 = phi_1571_;
                                                                let _e1326 = ((_e1317.y * _e1319.z) - (_e1319.y * _e1317.z));
                                                                let _e1331 = ((_e1317.z * _e1319.x) - (_e1319.z * _e1317.x));
                                                                let _e1334 = ((_e1317.x * _e1319.y) - (_e1319.x * _e1317.y));
                                                                if (_e1176 >= _e1180) {
                                                                    phi_1602_ = select(true, false, (_e1176 >= _e1184));
                                                                } else {
                                                                    phi_1602_ = true;
                                                                }
                                                                let _e1339 = phi_1602_;
                                                                if _e1339 {
                                                                    phi_1611_ = select(vec3<f32>(_e1113[2][0], _e1113[2][1], _e1113[2][2]), vec3<f32>(_e1113[1][0], _e1113[1][1], _e1113[1][2]), vec3((_e1180 >= _e1184)));
                                                                } else {
                                                                    phi_1611_ = vec3<f32>(_e1113[0][0], _e1113[0][1], _e1113[0][2]);
                                                                }
                                                                let _e1344 = phi_1611_;
                                                                let _e1361 = ((((_e1326 * (_e1344.x - _e302)) + (_e1331 * (_e1344.y - _e341))) + (_e1334 * (_e1344.z - _e379))) / (((_e1326 * _e327) + (_e1331 * _e365)) + (_e1334 * _e403)));
                                                                let _e1363 = select(_e1243, _e1361, (_e1361 < _e1243));
                                                                let _e1365 = select(_e1235, _e1363, (_e1363 > _e1235));
                                                                if (_e1365 >= _e453) {
                                                                    let _e1367 = (_e1365 <= _e1011.member.member_1);
                                                                    if _e1367 {
                                                                        let _e1368 = (1f / _e1186);
                                                                        phi_1651_ = type_25(_e1365, (_e1180 * _e1368), (_e1184 * _e1368), _e1046);
                                                                    } else {
                                                                        phi_1651_ = type_25();
                                                                    }
                                                                    let _e1373 = phi_1651_;
                                                                    phi_1653_ = _e1373;
                                                                    phi_1654_ = select(true, false, _e1367);
                                                                } else {
                                                                    phi_1653_ = type_25();
                                                                    phi_1654_ = true;
                                                                }
                                                                let _e1376 = phi_1653_;
                                                                let _e1378 = phi_1654_;
                                                                if _e1378 {
                                                                    phi_1658_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1658_ = _e1376;
                                                                }
                                                                let _e1380 = phi_1658_;
                                                                phi_1659_ = _e1380;
                                                            }
                                                            let _e1382 = phi_1659_;
                                                            phi_1660_ = _e1382;
                                                            phi_1661_ = _e1252;
                                                        }
                                                        let _e1384 = phi_1660_;
                                                        let _e1386 = phi_1661_;
                                                        phi_1665_ = _e1384;
                                                        phi_1666_ = _e1386;
                                                    }
                                                    let _e1388 = phi_1665_;
                                                    let _e1390 = phi_1666_;
                                                    phi_1670_ = _e1388;
                                                    phi_1671_ = _e1390;
                                                } else {
                                                    phi_1670_ = type_25();
                                                    phi_1671_ = true;
                                                }
                                                let _e1392 = phi_1670_;
                                                let _e1394 = phi_1671_;
                                                if _e1394 {
                                                    phi_1675_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1675_ = _e1392;
                                                }
                                                let _e1396 = phi_1675_;
                                                if (_e1396.member_3 != 4294967295u) {
                                                    if (_e1046 != 4294967295u) {
                                                        if (_e1396.member < _e1011.member.member.member) {
                                                            phi_1701_ = true;
                                                        } else {
                                                            if (_e1396.member == _e1011.member.member.member) {
                                                                phi_1700_ = (_e1396.member_3 < _e1011.member.member.member_3);
                                                            } else {
                                                                phi_1700_ = false;
                                                            }
                                                            let _e1411 = phi_1700_;
                                                            phi_1701_ = _e1411;
                                                        }
                                                        let _e1413 = phi_1701_;
                                                        if _e1413 {
                                                            phi_1708_ = type_40(type_33(_e1396, _e1396.member), _e1038.member_1, _e1038.member_2);
                                                        } else {
                                                            phi_1708_ = _e1038;
                                                        }
                                                        let _e1420 = phi_1708_;
                                                        phi_1709_ = _e1420;
                                                    } else {
                                                        phi_1709_ = _e1038;
                                                    }
                                                    let _e1422 = phi_1709_;
                                                    phi_1710_ = _e1422;
                                                } else {
                                                    phi_1710_ = _e1038;
                                                }
                                                let _e1424 = phi_1710_;
                                                phi_961_ = _e1424;
                                            } else {
                                                phi_961_ = type_40();
                                            }
                                            let _e1426 = phi_961_;
                                            continue;
                                            continuing {
                                                phi_960_ = _e1426;
                                                phi_963_ = _e1026;
                                                phi_3138_ = _e496;
                                                break if !(_e1032);
                                            }
                                        }
                                        let _e1429 = phi_3138_;
                                        phi_3252_ = _e1429;
                                        if _e1429 {
                                            break;
                                        }
                                        phi_3256_ = _e1429;
                                        let _e1582 = local_12;
                                        phi_2918_ = _e1582;
                                        phi_2919_ = _e538;
                                        phi_2920_ = false;
                                        phi_2921_ = _e542;
                                    } else {
                                        if (_e538.member_1 >= _e83) {
                                            phi_2474_ = type_52(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e538.member_1 < _e83) {
                                            } else {
                                                phi_3252_ = true;
                                                break;
                                            }
                                            let _e559 = (_e253 * 2u);
                                            let _e561 = ((1u + _e559) % 7u);
                                            if (_e561 < 7u) {
                                            } else {
                                                phi_3252_ = true;
                                                break;
                                            }
                                            let _e566 = global_5.member[_e538.member_1][_e561];
                                            let _e568 = ((_e559 + 2u) % 7u);
                                            if (_e568 < 7u) {
                                            } else {
                                                phi_3252_ = true;
                                                break;
                                            }
                                            let _e573 = global_5.member[_e538.member_1][_e568];
                                            let _e574 = (_e252 * 2u);
                                            let _e576 = ((1u + _e574) % 7u);
                                            if (_e576 < 7u) {
                                            } else {
                                                phi_3252_ = true;
                                                break;
                                            }
                                            let _e581 = global_5.member[_e538.member_1][_e576];
                                            let _e583 = ((_e574 + 2u) % 7u);
                                            if (_e583 < 7u) {
                                            } else {
                                                phi_3252_ = true;
                                                break;
                                            }
                                            let _e588 = global_5.member[_e538.member_1][_e583];
                                            let _e589 = (_e254 * 2u);
                                            let _e591 = ((1u + _e589) % 7u);
                                            if (_e591 < 7u) {
                                            } else {
                                                phi_3252_ = true;
                                                break;
                                            }
                                            let _e596 = global_5.member[_e538.member_1][_e591];
                                            let _e598 = ((_e589 + 2u) % 7u);
                                            if (_e598 < 7u) {
                                            } else {
                                                phi_3252_ = true;
                                                break;
                                            }
                                            let _e603 = global_5.member[_e538.member_1][_e598];
                                            let _e626 = (bitcast<f32>((bitcast<u32>((_e538.member.member_1.x - _e538.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e627 = (bitcast<f32>((bitcast<u32>((_e538.member.member_1.y - _e538.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e628 = (bitcast<f32>((bitcast<u32>((_e538.member.member_1.z - _e538.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e630 = select(_e133, _e626, (_e626 > _e133));
                                            let _e632 = select(_e133, _e627, (_e627 > _e133));
                                            let _e634 = select(_e133, _e628, (_e628 > _e133));
                                            let _e659 = bitcast<u32>((f32(bitcast<i32>((_e566 & 2097151u))) * _e630));
                                            let _e664 = (bitcast<i32>((_e566 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e667 = bitcast<f32>((_e659 & bitcast<u32>(_e664)));
                                            let _e668 = bitcast<u32>((f32(bitcast<i32>((_e581 & 2097151u))) * _e632));
                                            let _e673 = (bitcast<i32>((_e581 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e676 = bitcast<f32>((_e668 & bitcast<u32>(_e673)));
                                            let _e677 = bitcast<u32>((f32(bitcast<i32>((_e596 & 2097151u))) * _e634));
                                            let _e682 = (bitcast<i32>((_e596 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e685 = bitcast<f32>((_e677 & bitcast<u32>(_e682)));
                                            let _e689 = bitcast<f32>((_e659 & bitcast<u32>(~(_e664))));
                                            let _e693 = bitcast<f32>((_e668 & bitcast<u32>(~(_e673))));
                                            let _e697 = bitcast<f32>((_e677 & bitcast<u32>(~(_e682))));
                                            let _e698 = bitcast<u32>((f32(bitcast<i32>((_e573 & 2097151u))) * _e630));
                                            let _e703 = (bitcast<i32>((_e573 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e706 = bitcast<f32>((_e698 & bitcast<u32>(_e703)));
                                            let _e707 = bitcast<u32>((f32(bitcast<i32>((_e588 & 2097151u))) * _e632));
                                            let _e712 = (bitcast<i32>((_e588 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e715 = bitcast<f32>((_e707 & bitcast<u32>(_e712)));
                                            let _e716 = bitcast<u32>((f32(bitcast<i32>((_e603 & 2097151u))) * _e634));
                                            let _e721 = (bitcast<i32>((_e603 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e724 = bitcast<f32>((_e716 & bitcast<u32>(_e721)));
                                            let _e728 = bitcast<f32>((_e698 & bitcast<u32>(~(_e703))));
                                            let _e732 = bitcast<f32>((_e707 & bitcast<u32>(~(_e712))));
                                            let _e736 = bitcast<f32>((_e716 & bitcast<u32>(~(_e721))));
                                            let _e766 = global_5.member[_e538.member_1][0u];
                                            let _e770 = global_5.member[_e538.member_1][2u];
                                            let _e774 = global_5.member[_e538.member_1][4u];
                                            let _e778 = global_5.member[_e538.member_1][6u];
                                            let _e790 = (((_e770 >> bitcast<u32>(22i)) | ((_e774 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e778 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e791 = (_e766 & 268435455u);
                                            let _e792 = (_e790 & 268435455u);
                                            let _e795 = ((_e766 >> bitcast<u32>(28u)) & 7u);
                                            let _e803 = ((_e766 >> bitcast<u32>(31i)) | (((_e790 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e804 = (_e795 != 0u);
                                            if (_e795 == 0u) {
                                                phi_2436_ = _e791;
                                            } else {
                                                if (_e795 == 7u) {
                                                    phi_2435_ = 2147483648u;
                                                } else {
                                                    phi_2435_ = ((2147483648u | (_e795 << bitcast<u32>(28u))) | (_e792 & 268435455u));
                                                }
                                                let _e813 = phi_2435_;
                                                phi_2436_ = _e813;
                                            }
                                            let _e815 = phi_2436_;
                                            if _e804 {
                                                let _e816 = (_e795 != 7u);
                                                if _e816 {
                                                    phi_2446_ = (_e792 + _e795);
                                                } else {
                                                    phi_2446_ = u32();
                                                }
                                                let _e819 = phi_2446_;
                                                phi_2448_ = _e819;
                                                phi_2449_ = select(true, false, _e816);
                                            } else {
                                                phi_2448_ = u32();
                                                phi_2449_ = true;
                                            }
                                            let _e822 = phi_2448_;
                                            let _e824 = phi_2449_;
                                            if (_e803 == 0u) {
                                                phi_2470_ = (_e791 + select(0u, 1u, !(_e804)));
                                            } else {
                                                if (_e803 == 7u) {
                                                    phi_2469_ = 2147483648u;
                                                } else {
                                                    phi_2469_ = ((2147483648u | (_e803 << bitcast<u32>(28u))) | (select(_e822, _e792, _e824) & 268435455u));
                                                }
                                                let _e837 = phi_2469_;
                                                phi_2470_ = _e837;
                                            }
                                            let _e839 = phi_2470_;
                                            phi_2474_ = type_52(array<vec4<f32>, 3>(vec4<f32>((_e538.member.member.x + _e667), (_e538.member.member.x + _e689), (_e538.member.member_1.x - _e706), (_e538.member.member_1.x - _e728)), vec4<f32>((_e538.member.member.y + _e676), (_e538.member.member.y + _e693), (_e538.member.member_1.y - _e715), (_e538.member.member_1.y - _e732)), vec4<f32>((_e538.member.member.z + _e685), (_e538.member.member.z + _e697), (_e538.member.member_1.z - _e724), (_e538.member.member_1.z - _e736))), type_51(type_29((_e538.member.member + vec4<f32>(_e667, _e676, _e685, 0f)), (_e538.member.member_1 - vec4<f32>(_e706, _e715, _e724, 0f))), _e815), type_51(type_29((_e538.member.member + vec4<f32>(_e689, _e693, _e697, 0f)), (_e538.member.member_1 - vec4<f32>(_e728, _e732, _e736, 0f))), _e839));
                                        }
                                        let _e844 = phi_2474_;
                                        let _e857 = ((_e844.member[0].x - _e325) * _e330);
                                        let _e858 = ((_e844.member[0].y - _e325) * _e330);
                                        let _e859 = ((_e844.member[0].z - _e326) * _e330);
                                        let _e860 = ((_e844.member[0].w - _e326) * _e330);
                                        let _e870 = ((_e844.member[1].x - _e363) * _e368);
                                        let _e871 = ((_e844.member[1].y - _e363) * _e368);
                                        let _e872 = ((_e844.member[1].z - _e364) * _e368);
                                        let _e873 = ((_e844.member[1].w - _e364) * _e368);
                                        let _e883 = ((_e844.member[2].x - _e401) * _e406);
                                        let _e884 = ((_e844.member[2].y - _e401) * _e406);
                                        let _e885 = ((_e844.member[2].z - _e402) * _e406);
                                        let _e886 = ((_e844.member[2].w - _e402) * _e406);
                                        let _e888 = select(_e885, _e883, (_e883 < _e885));
                                        let _e890 = select(_e886, _e884, (_e884 < _e886));
                                        let _e892 = select(_e885, _e883, (_e883 > _e885));
                                        let _e894 = select(_e886, _e884, (_e884 > _e886));
                                        let _e896 = select(_e859, _e857, (_e857 < _e859));
                                        let _e898 = select(_e860, _e858, (_e858 < _e860));
                                        let _e900 = select(_e872, _e870, (_e870 < _e872));
                                        let _e902 = select(_e873, _e871, (_e871 < _e873));
                                        let _e904 = select(_e900, _e896, (_e896 > _e900));
                                        let _e906 = select(_e902, _e898, (_e898 > _e902));
                                        let _e908 = select(_e888, _e904, (_e904 > _e888));
                                        let _e910 = select(_e890, _e906, (_e906 > _e890));
                                        let _e912 = select(_e859, _e857, (_e857 > _e859));
                                        let _e914 = select(_e860, _e858, (_e858 > _e860));
                                        let _e916 = select(_e872, _e870, (_e870 > _e872));
                                        let _e918 = select(_e873, _e871, (_e871 > _e873));
                                        let _e920 = select(_e916, _e912, (_e912 < _e916));
                                        let _e922 = select(_e918, _e914, (_e914 < _e918));
                                        let _e927 = -(_e888);
                                        let _e928 = -(_e890);
                                        let _e935 = (select(_e892, _e920, (_e920 < _e892)) + (select(_e927, _e892, (_e892 > _e927)) * 0.0000019073523f));
                                        let _e936 = (select(_e894, _e922, (_e922 < _e894)) + (select(_e928, _e894, (_e894 > _e928)) * 0.0000019073523f));
                                        let _e938 = select(_e453, _e908, (_e908 > _e453));
                                        let _e940 = select(_e453, _e910, (_e910 > _e453));
                                        let _e945 = (_e938 <= select(_e498.member.member_1, _e935, (_e935 < _e498.member.member_1)));
                                        let _e946 = (_e940 <= select(_e498.member.member_1, _e936, (_e936 < _e498.member.member_1)));
                                        let _e947 = (_e938 <= _e940);
                                        if _e945 {
                                            if _e946 {
                                                if _e947 {
                                                    phi_2818_ = _e844.member_2;
                                                } else {
                                                    phi_2818_ = _e844.member_1;
                                                }
                                                let _e951 = phi_2818_;
                                                let _e973 = (_e542 % 128u);
                                                let _e974 = (_e973 < 128u);
                                                if _e974 {
                                                } else {
                                                    phi_3252_ = true;
                                                    break;
                                                }
                                                local_8[_e973] = _e951.member_1;
                                                if _e974 {
                                                } else {
                                                    phi_3252_ = true;
                                                    break;
                                                }
                                                local_7[_e973] = _e951.member.member.x;
                                                if _e974 {
                                                } else {
                                                    phi_3252_ = true;
                                                    break;
                                                }
                                                local_6[_e973] = _e951.member.member.y;
                                                if _e974 {
                                                } else {
                                                    phi_3252_ = true;
                                                    break;
                                                }
                                                local_5[_e973] = _e951.member.member.z;
                                                if _e974 {
                                                } else {
                                                    phi_3252_ = true;
                                                    break;
                                                }
                                                local_4[_e973] = _e951.member.member_1.x;
                                                if _e974 {
                                                } else {
                                                    phi_3252_ = true;
                                                    break;
                                                }
                                                local_3[_e973] = _e951.member.member_1.y;
                                                if _e974 {
                                                } else {
                                                    phi_3252_ = true;
                                                    break;
                                                }
                                                local_2[_e973] = _e951.member.member_1.z;
                                                if _e974 {
                                                } else {
                                                    phi_3252_ = true;
                                                    break;
                                                }
                                                local_9[_e973] = select(_e940, _e938, (_e938 > _e940));
                                                if _e947 {
                                                    phi_2895_ = _e844.member_1;
                                                } else {
                                                    phi_2895_ = _e844.member_2;
                                                }
                                                let _e987 = phi_2895_;
                                                phi_2896_ = _e987;
                                                phi_2897_ = (_e542 + 1u);
                                            } else {
                                                phi_2896_ = type_51();
                                                phi_2897_ = u32();
                                            }
                                            let _e989 = phi_2896_;
                                            let _e991 = phi_2897_;
                                            phi_2899_ = _e989;
                                            phi_2900_ = _e991;
                                            phi_2901_ = select(true, false, _e946);
                                        } else {
                                            phi_2899_ = type_51();
                                            phi_2900_ = u32();
                                            phi_2901_ = true;
                                        }
                                        let _e994 = phi_2899_;
                                        let _e996 = phi_2900_;
                                        let _e998 = phi_2901_;
                                        if _e998 {
                                            if _e945 {
                                                phi_2910_ = _e844.member_1;
                                            } else {
                                                phi_2910_ = _e844.member_2;
                                            }
                                            let _e1002 = phi_2910_;
                                            phi_2915_ = _e1002;
                                            phi_2916_ = select(_e946, true, _e945);
                                        } else {
                                            phi_2915_ = _e994;
                                            phi_2916_ = _e540;
                                        }
                                        let _e1005 = phi_2915_;
                                        let _e1007 = phi_2916_;
                                        phi_3256_ = _e496;
                                        phi_2918_ = type_40(_e498.member, (_e498.member_1 + 1u), _e498.member_2);
                                        phi_2919_ = _e1005;
                                        phi_2920_ = _e1007;
                                        phi_2921_ = select(_e996, _e542, _e998);
                                    }
                                    let _e1431 = phi_3256_;
                                    let _e1433 = phi_2918_;
                                    let _e1435 = phi_2919_;
                                    let _e1437 = phi_2920_;
                                    let _e1439 = phi_2921_;
                                    phi_3255_ = _e1431;
                                    phi_2922_ = _e1433;
                                    phi_2923_ = _e1435;
                                    phi_2924_ = (_e502 - 1u);
                                    phi_2925_ = _e1437;
                                    phi_2926_ = _e1439;
                                } else {
                                    phi_3255_ = _e496;
                                    phi_2922_ = _e498;
                                    phi_2923_ = _e538;
                                    phi_2924_ = _e502;
                                    phi_2925_ = _e540;
                                    phi_2926_ = _e542;
                                }
                                let _e1441 = phi_3255_;
                                let _e1443 = phi_2922_;
                                let _e1445 = phi_2923_;
                                let _e1447 = phi_2924_;
                                let _e1449 = phi_2925_;
                                let _e1451 = phi_2926_;
                                phi_3254_ = _e1441;
                                phi_2927_ = _e1443;
                                phi_2928_ = _e1445;
                                phi_2929_ = _e1447;
                                phi_2930_ = _e1449;
                                phi_2931_ = _e1451;
                            } else {
                                phi_3254_ = _e496;
                                phi_2927_ = type_40();
                                phi_2928_ = type_51();
                                phi_2929_ = u32();
                                phi_2930_ = bool();
                                phi_2931_ = u32();
                            }
                            let _e1453 = phi_3254_;
                            let _e1455 = phi_2927_;
                            let _e1457 = phi_2928_;
                            let _e1459 = phi_2929_;
                            let _e1461 = phi_2930_;
                            let _e1463 = phi_2931_;
                            phi_3253_ = _e1453;
                            phi_835_ = _e1455;
                            phi_838_ = _e1457;
                            phi_840_ = _e1459;
                            phi_842_ = _e1461;
                            phi_844_ = _e1463;
                            phi_2932_ = _e510;
                        } else {
                            phi_3253_ = _e496;
                            phi_835_ = type_40();
                            phi_838_ = type_51();
                            phi_840_ = u32();
                            phi_842_ = bool();
                            phi_844_ = u32();
                            phi_2932_ = false;
                        }
                        let _e1465 = phi_3253_;
                        let _e1467 = phi_835_;
                        let _e1469 = phi_838_;
                        let _e1471 = phi_840_;
                        let _e1473 = phi_842_;
                        let _e1475 = phi_844_;
                        let _e1477 = phi_2932_;
                        continue;
                        continuing {
                            phi_3144_ = _e1465;
                            phi_834_ = _e1467;
                            phi_837_ = _e1469;
                            phi_839_ = _e1471;
                            phi_841_ = _e1473;
                            phi_843_ = _e1475;
                            phi_3252_ = _e1465;
                            break if !(_e1477);
                        }
                    }
                    let _e1480 = phi_3252_;
                    if _e1480 {
                        break;
                    }
                    let _e1482 = local_10;
                    let _e1485 = local_11;
                    if _e141 {
                    } else {
                        break;
                    }
                    global_6.member[_e139][0u] = _e1482.member_1;
                    global_6.member[_e139][1u] = _e1485.member_2;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_counted_q21_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
