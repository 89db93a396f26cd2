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

struct type_31 {
    member: array<type_23>,
}

struct type_35 {
    member: array<array<type_22, 8>>,
}

struct type_41 {
    member: array<vec4<u32>, 2>,
}

struct type_43 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_45 {
    member: array<type_43>,
}

struct type_49 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_52 {
    member: type_49,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(3) 
var<storage> global_2: type_15;
@group(0) @binding(1) 
var<uniform> global_3: type_41;
@group(0) @binding(4) 
var<storage> global_4: type_31;
@group(0) @binding(2) 
var<storage> global_5: type_45;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_35;

fn function_() {
    var local: array<f32, 3>;
    var local_1: array<f32, 3>;
    var local_2: array<type_22, 8>;
    var local_3: array<f32, 128>;
    var local_4: array<type_52, 128>;
    var local_5: array<f32, 3>;
    var local_6: array<f32, 3>;
    var local_7: array<f32, 3>;
    var local_8: array<f32, 3>;
    var local_9: array<u32, 3>;
    var local_10: array<u32, 3>;
    var local_11: array<f32, 3>;
    var local_12: array<f32, 3>;
    var phi_341_: i32;
    var phi_342_: i32;
    var phi_352_: bool;
    var phi_362_: u32;
    var phi_363_: u32;
    var phi_365_: bool;
    var phi_370_: u32;
    var phi_383_: i32;
    var phi_403_: i32;
    var phi_421_: f32;
    var phi_427_: f32;
    var phi_438_: f32;
    var phi_444_: f32;
    var phi_467_: f32;
    var phi_478_: f32;
    var phi_487_: f32;
    var phi_493_: f32;
    var phi_504_: f32;
    var phi_510_: f32;
    var phi_533_: f32;
    var phi_544_: f32;
    var phi_553_: f32;
    var phi_559_: f32;
    var phi_570_: f32;
    var phi_576_: f32;
    var phi_599_: f32;
    var phi_610_: f32;
    var phi_710_: f32;
    var phi_711_: f32;
    var phi_4891_: bool;
    var phi_4882_: f32;
    var phi_2892_: type_52;
    var phi_2895_: u32;
    var phi_2897_: bool;
    var phi_2899_: u32;
    var phi_2910_: bool;
    var phi_2956_: type_52;
    var phi_2957_: bool;
    var phi_2958_: u32;
    var phi_3824_: type_43;
    var phi_3833_: type_4;
    var phi_3834_: type_4;
    var phi_3857_: type_4;
    var phi_4884_: bool;
    var phi_3987_: type_4;
    var phi_3988_: type_4;
    var phi_4011_: type_4;
    var phi_4944_: bool;
    var phi_4575_: type_52;
    var phi_4614_: type_52;
    var phi_4615_: type_52;
    var phi_4616_: u32;
    var phi_4618_: type_52;
    var phi_4619_: u32;
    var phi_4620_: bool;
    var phi_4627_: type_52;
    var phi_4632_: type_52;
    var phi_4633_: bool;
    var phi_4983_: bool;
    var phi_4973_: f32;
    var phi_2976_: type_4;
    var phi_2977_: type_4;
    var phi_3000_: type_4;
    var phi_3021_: u32;
    var phi_3110_: array<array<f32, 3>, 3>;
    var phi_3582_: vec3<f32>;
    var phi_3583_: vec3<f32>;
    var phi_3614_: bool;
    var phi_3623_: vec3<f32>;
    var phi_3663_: type_22;
    var phi_3665_: type_22;
    var phi_3666_: bool;
    var phi_3670_: type_22;
    var phi_3671_: type_22;
    var phi_3672_: type_22;
    var phi_3673_: bool;
    var phi_3677_: type_22;
    var phi_3678_: bool;
    var phi_3682_: type_22;
    var phi_3683_: bool;
    var phi_3687_: type_22;
    var phi_3699_: type_4;
    var phi_3702_: type_22;
    var phi_3700_: type_4;
    var phi_3725_: type_4;
    var phi_3757_: bool;
    var phi_3758_: bool;
    var phi_3779_: type_22;
    var phi_3703_: type_22;
    var phi_4974_: bool;
    var phi_5189_: f32;
    var phi_5188_: f32;
    var phi_5040_: bool;
    var phi_5187_: f32;
    var phi_5039_: bool;
    var phi_5186_: f32;
    var phi_5038_: bool;
    var phi_5126_: f32;
    var phi_5037_: bool;
    var phi_5091_: f32;
    var phi_5046_: bool;
    var phi_4635_: type_52;
    var phi_4636_: bool;
    var phi_4637_: u32;
    var phi_5090_: f32;
    var phi_5045_: bool;
    var phi_4638_: type_52;
    var phi_4639_: u32;
    var phi_4640_: bool;
    var phi_4641_: u32;
    var phi_5089_: f32;
    var phi_5044_: bool;
    var phi_4642_: type_52;
    var phi_4643_: u32;
    var phi_4644_: bool;
    var phi_4645_: u32;
    var phi_5088_: f32;
    var phi_5043_: bool;
    var phi_2893_: type_52;
    var phi_2896_: u32;
    var phi_2898_: bool;
    var phi_2900_: u32;
    var phi_4646_: bool;
    var phi_5042_: bool;
    var phi_4653_: type_4;
    var phi_4654_: type_4;
    var phi_4677_: type_4;
    var phi_4743_: type_22;
    var phi_5081_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e84 = global;
            let _e87 = arrayLength((&global_5.member));
            let _e89 = arrayLength((&global_2.member));
            let _e97 = global_3.member[0u][0u];
            let _e101 = global_3.member[0u][1u];
            let _e105 = global_3.member[0u][2u];
            let _e109 = global_3.member[1u][0u];
            let _e113 = global_3.member[1u][1u];
            let _e117 = global_3.member[1u][2u];
            let _e121 = global_3.member[1u][3u];
            let _e124 = global_1.member[0u];
            let _e125 = bitcast<i32>(_e124);
            let _e135 = (_e84.x + (_e84.y * 2097152u));
            let _e136 = (_e135 < arrayLength((&global_4.member)));
            if _e136 {
                let _e137 = (_e135 < arrayLength((&global_6.member)));
                if _e137 {
                    if _e136 {
                    } else {
                        break;
                    }
                    let _e145 = global_4.member[_e135].member_2[0u];
                    let _e147 = (bitcast<u32>(_e145) & 2147483647u);
                    let _e152 = global_4.member[_e135].member_2[1u];
                    let _e154 = (bitcast<u32>(_e152) & 2147483647u);
                    let _e159 = global_4.member[_e135].member_2[2u];
                    let _e161 = (bitcast<u32>(_e159) & 2147483647u);
                    let _e166 = global_4.member[_e135].member[0u];
                    let _e168 = (bitcast<u32>(_e166) & 2147483647u);
                    let _e173 = global_4.member[_e135].member[1u];
                    let _e175 = (bitcast<u32>(_e173) & 2147483647u);
                    let _e180 = global_4.member[_e135].member[2u];
                    let _e182 = (bitcast<u32>(_e180) & 2147483647u);
                    let _e184 = select(_e154, _e147, (_e154 < _e147));
                    let _e186 = select(_e161, _e184, (_e161 < _e184));
                    let _e188 = select(_e168, _e186, (_e168 < _e186));
                    let _e190 = select(_e175, _e188, (_e175 < _e188));
                    let _e192 = select(_e182, _e190, (_e182 < _e190));
                    let _e196 = global_4.member[_e135].member_1;
                    let _e198 = (bitcast<u32>(_e196) & 2147483647u);
                    let _e205 = global_4.member[_e135].member_3;
                    let _e211 = (((select(_e198, _e192, (_e198 < _e192)) < 2139095040u) && ((bitcast<u32>(_e205) & 2147483647u) <= 2139095040u)) && (_e186 > 0u));
                    if _e211 {
                        let _e214 = (bitcast<u32>(bitcast<f32>(_e186)) & 2147483647u);
                        if (_e214 >= 8388608u) {
                            phi_341_ = (bitcast<i32>((_e214 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_341_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e214)), 32u, (_e214 == 0u))));
                        }
                        let _e228 = phi_341_;
                        phi_342_ = _e228;
                    } else {
                        phi_342_ = 0i;
                    }
                    let _e230 = phi_342_;
                    let _e231 = (_e147 == _e186);
                    if _e231 {
                        phi_352_ = true;
                    } else {
                        phi_352_ = (_e154 == _e186);
                    }
                    let _e234 = phi_352_;
                    let _e235 = select(1u, 0u, _e231);
                    if _e234 {
                        let _e236 = (_e235 + 1u);
                        phi_362_ = _e236;
                        phi_363_ = _e236;
                        phi_365_ = select(true, false, (_e236 == 2u));
                    } else {
                        phi_362_ = u32();
                        phi_363_ = 0u;
                        phi_365_ = true;
                    }
                    let _e240 = phi_362_;
                    let _e242 = phi_363_;
                    let _e244 = phi_365_;
                    if _e244 {
                        phi_370_ = (_e242 + 1u);
                    } else {
                        phi_370_ = 0u;
                    }
                    let _e248 = phi_370_;
                    let _e249 = select(_e240, _e242, _e244);
                    let _e250 = select(_e235, select(2u, _e235, _e234), _e244);
                    if (_e125 < -126i) {
                        phi_383_ = -126i;
                    } else {
                        phi_383_ = select(_e125, 127i, (_e125 > 127i));
                    }
                    let _e255 = phi_383_;
                    let _e260 = bitcast<f32>((bitcast<u32>((_e255 + 127i)) << bitcast<u32>(23i)));
                    let _e266 = bitcast<f32>((bitcast<u32>(((_e125 - _e255) + 127i)) << bitcast<u32>(23i)));
                    let _e267 = -(_e230);
                    if (_e267 < -126i) {
                        phi_403_ = -126i;
                    } else {
                        phi_403_ = select(_e267, 127i, (_e267 > 127i));
                    }
                    let _e272 = phi_403_;
                    let _e277 = bitcast<f32>((bitcast<u32>((_e272 + 127i)) << bitcast<u32>(23i)));
                    let _e283 = bitcast<f32>((bitcast<u32>(((_e267 - _e272) + 127i)) << bitcast<u32>(23i)));
                    let _e287 = global_4.member[_e135].member;
                    let _e288 = (_e249 == 0u);
                    if _e288 {
                        phi_421_ = _e287[0];
                    } else {
                        phi_421_ = _e287[1];
                    }
                    let _e292 = phi_421_;
                    let _e293 = (_e249 == 2u);
                    if _e293 {
                        phi_427_ = _e287[2];
                    } else {
                        phi_427_ = _e292;
                    }
                    let _e296 = phi_427_;
                    let _e298 = ((_e296 * _e260) * _e266);
                    let _e299 = global_4.member[_e135].member_2;
                    if _e288 {
                        phi_438_ = _e299[0];
                    } else {
                        phi_438_ = _e299[1];
                    }
                    let _e303 = phi_438_;
                    if _e293 {
                        phi_444_ = _e299[2];
                    } else {
                        phi_444_ = _e303;
                    }
                    let _e306 = phi_444_;
                    let _e308 = ((_e306 * _e277) * _e283);
                    let _e312 = (bitcast<f32>((bitcast<u32>(_e308) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e312 {
                        let _e316 = (bitcast<f32>((bitcast<u32>(_e298) & 2147483647u)) * 0.00000011920929f);
                        phi_467_ = select(0.00000000000011368684f, _e316, (_e316 > 0.00000000000011368684f));
                    } else {
                        phi_467_ = 0f;
                    }
                    let _e320 = phi_467_;
                    let _e321 = (_e298 + _e320);
                    let _e322 = (_e298 - _e320);
                    let _e323 = select(_e308, 0f, _e312);
                    if _e312 {
                        phi_478_ = 38685626000000000000000000f;
                    } else {
                        phi_478_ = (1f / _e308);
                    }
                    let _e326 = phi_478_;
                    let _e327 = (_e248 == 0u);
                    if _e327 {
                        phi_487_ = _e287[0];
                    } else {
                        phi_487_ = _e287[1];
                    }
                    let _e331 = phi_487_;
                    let _e332 = (_e248 == 2u);
                    if _e332 {
                        phi_493_ = _e287[2];
                    } else {
                        phi_493_ = _e331;
                    }
                    let _e335 = phi_493_;
                    let _e337 = ((_e335 * _e260) * _e266);
                    if _e327 {
                        phi_504_ = _e299[0];
                    } else {
                        phi_504_ = _e299[1];
                    }
                    let _e341 = phi_504_;
                    if _e332 {
                        phi_510_ = _e299[2];
                    } else {
                        phi_510_ = _e341;
                    }
                    let _e344 = phi_510_;
                    let _e346 = ((_e344 * _e277) * _e283);
                    let _e350 = (bitcast<f32>((bitcast<u32>(_e346) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e350 {
                        let _e354 = (bitcast<f32>((bitcast<u32>(_e337) & 2147483647u)) * 0.00000011920929f);
                        phi_533_ = select(0.00000000000011368684f, _e354, (_e354 > 0.00000000000011368684f));
                    } else {
                        phi_533_ = 0f;
                    }
                    let _e358 = phi_533_;
                    let _e359 = (_e337 + _e358);
                    let _e360 = (_e337 - _e358);
                    let _e361 = select(_e346, 0f, _e350);
                    if _e350 {
                        phi_544_ = 38685626000000000000000000f;
                    } else {
                        phi_544_ = (1f / _e346);
                    }
                    let _e364 = phi_544_;
                    let _e365 = (_e250 == 0u);
                    if _e365 {
                        phi_553_ = _e287[0];
                    } else {
                        phi_553_ = _e287[1];
                    }
                    let _e369 = phi_553_;
                    let _e370 = (_e250 == 2u);
                    if _e370 {
                        phi_559_ = _e287[2];
                    } else {
                        phi_559_ = _e369;
                    }
                    let _e373 = phi_559_;
                    let _e375 = ((_e373 * _e260) * _e266);
                    if _e365 {
                        phi_570_ = _e299[0];
                    } else {
                        phi_570_ = _e299[1];
                    }
                    let _e379 = phi_570_;
                    if _e370 {
                        phi_576_ = _e299[2];
                    } else {
                        phi_576_ = _e379;
                    }
                    let _e382 = phi_576_;
                    let _e384 = ((_e382 * _e277) * _e283);
                    let _e388 = (bitcast<f32>((bitcast<u32>(_e384) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e388 {
                        let _e392 = (bitcast<f32>((bitcast<u32>(_e375) & 2147483647u)) * 0.00000011920929f);
                        phi_599_ = select(0.00000000000011368684f, _e392, (_e392 > 0.00000000000011368684f));
                    } else {
                        phi_599_ = 0f;
                    }
                    let _e396 = phi_599_;
                    let _e397 = (_e375 + _e396);
                    let _e398 = (_e375 - _e396);
                    let _e399 = select(_e384, 0f, _e388);
                    if _e388 {
                        phi_610_ = 38685626000000000000000000f;
                    } else {
                        phi_610_ = (1f / _e384);
                    }
                    let _e402 = phi_610_;
                    let _e405 = bitcast<f32>((bitcast<u32>(_e298) & 2147483647u));
                    let _e408 = bitcast<f32>((bitcast<u32>(_e337) & 2147483647u));
                    let _e410 = select(_e408, _e405, (_e405 > _e408));
                    let _e413 = bitcast<f32>((bitcast<u32>(_e375) & 2147483647u));
                    let _e416 = (_e125 + _e230);
                    if (_e211 && (select(_e413, _e410, (_e410 > _e413)) <= 1099511600000f)) {
                        let _e419 = (_e416 / 3i);
                        let _e426 = bitcast<f32>((bitcast<u32>((_e419 + 127i)) << bitcast<u32>(23i)));
                        let _e433 = bitcast<f32>((bitcast<u32>(((_e416 - (2i * _e419)) + 127i)) << bitcast<u32>(23i)));
                        let _e434 = (((_e196 * _e426) * _e426) * _e433);
                        let _e436 = select(340282350000000000000000000000000000000f, _e434, (_e434 < 340282350000000000000000000000000000000f));
                        let _e441 = (((_e205 * _e426) * _e426) * _e433);
                        let _e443 = select(340282350000000000000000000000000000000f, _e441, (_e441 < 340282350000000000000000000000000000000f));
                        phi_710_ = select(-340282350000000000000000000000000000000f, _e443, (_e443 > -340282350000000000000000000000000000000f));
                        phi_711_ = select(-340282350000000000000000000000000000000f, _e436, (_e436 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_710_ = 0f;
                        phi_711_ = 1f;
                    }
                    let _e447 = phi_710_;
                    let _e449 = phi_711_;
                    local_2 = array<type_22, 8>(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_4 = array<type_52, 128>(type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_49(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u));
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_12 = array<f32, 3>(bitcast<f32>(_e97), bitcast<f32>(_e101), bitcast<f32>(_e105));
                    let _e453 = (_e249 % 3u);
                    let _e454 = (_e453 < 3u);
                    if _e454 {
                    } else {
                        break;
                    }
                    let _e456 = local_12[_e453];
                    let _e457 = (_e248 % 3u);
                    let _e458 = (_e457 < 3u);
                    if _e458 {
                    } else {
                        break;
                    }
                    let _e460 = local_12[_e457];
                    let _e461 = (_e250 % 3u);
                    let _e462 = (_e461 < 3u);
                    if _e462 {
                    } else {
                        break;
                    }
                    let _e464 = local_12[_e461];
                    local_11 = array<f32, 3>(bitcast<f32>(_e109), bitcast<f32>(_e113), bitcast<f32>(_e117));
                    if _e454 {
                    } else {
                        break;
                    }
                    let _e468 = local_11[_e453];
                    if _e458 {
                    } else {
                        break;
                    }
                    let _e470 = local_11[_e457];
                    if _e462 {
                    } else {
                        break;
                    }
                    let _e472 = local_11[_e461];
                    phi_4891_ = false;
                    phi_4882_ = _e447;
                    phi_2892_ = type_52(type_49(array<f32, 3>(_e456, _e460, _e464), array<f32, 3>(_e468, _e470, _e472)), select(0u, 2147483648u, (_e87 == 0u)));
                    phi_2895_ = ((3u * _e87) + 1u);
                    phi_2897_ = (_e449 <= _e447);
                    phi_2899_ = 0u;
                    loop {
                        let _e480 = phi_4891_;
                        let _e482 = phi_4882_;
                        let _e484 = phi_2892_;
                        let _e486 = phi_2895_;
                        let _e488 = phi_2897_;
                        let _e490 = phi_2899_;
                        if _e488 {
                            phi_2910_ = true;
                        } else {
                            phi_2910_ = (_e490 > 0u);
                        }
                        let _e493 = phi_2910_;
                        if _e493 {
                            let _e494 = (_e486 > 0u);
                            if _e494 {
                                if _e488 {
                                    phi_2956_ = _e484;
                                    phi_2957_ = _e488;
                                    phi_2958_ = _e490;
                                } else {
                                    let _e495 = (_e490 - 1u);
                                    let _e496 = (_e495 % 128u);
                                    let _e497 = (_e496 < 128u);
                                    if _e497 {
                                    } else {
                                        phi_5042_ = true;
                                        break;
                                    }
                                    let _e499 = local_4[_e496];
                                    if _e497 {
                                    } else {
                                        phi_5042_ = true;
                                        break;
                                    }
                                    let _e515 = local_3[_e496];
                                    phi_2956_ = type_52(type_49(array<f32, 3>(_e499.member.member[0], _e499.member.member[1], _e499.member.member[2]), array<f32, 3>(_e499.member.member_1[0], _e499.member.member_1[1], _e499.member.member_1[2])), _e499.member_1);
                                    phi_2957_ = (_e515 <= _e482);
                                    phi_2958_ = _e495;
                                }
                                let _e518 = phi_2956_;
                                let _e520 = phi_2957_;
                                let _e522 = phi_2958_;
                                if _e520 {
                                    if ((_e518.member_1 & 2147483648u) != 0u) {
                                        phi_4983_ = _e480;
                                        phi_4973_ = _e482;
                                        phi_2976_ = type_4(0u, ((_e518.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e843 = phi_4983_;
                                            let _e845 = phi_4973_;
                                            let _e847 = phi_2976_;
                                            if (_e847.member < _e847.member_1) {
                                                phi_2977_ = type_4((_e847.member + 1u), _e847.member_1);
                                                phi_3000_ = type_4(1u, _e847.member);
                                            } else {
                                                phi_2977_ = _e847;
                                                phi_3000_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e860 = phi_2977_;
                                            let _e862 = phi_3000_;
                                            let _e866 = (bitcast<i32>(_e862.member) != 0i);
                                            if _e866 {
                                                let _e867 = ((_e518.member_1 & 268435455u) + _e862.member_1);
                                                let _e868 = (_e867 < _e89);
                                                if _e868 {
                                                    if _e868 {
                                                    } else {
                                                        phi_5126_ = _e845;
                                                        phi_5037_ = true;
                                                        break;
                                                    }
                                                    let _e872 = global_2.member[_e867].member_1;
                                                    phi_3021_ = _e872;
                                                } else {
                                                    phi_3021_ = 4294967295u;
                                                }
                                                let _e874 = phi_3021_;
                                                if (_e867 >= _e89) {
                                                    phi_3110_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e868 {
                                                    } else {
                                                        phi_5126_ = _e845;
                                                        phi_5037_ = true;
                                                        break;
                                                    }
                                                    if (_e453 < 9u) {
                                                    } else {
                                                        phi_5126_ = _e845;
                                                        phi_5037_ = true;
                                                        break;
                                                    }
                                                    let _e881 = global_2.member[_e867].member[_e453];
                                                    if (_e457 < 9u) {
                                                    } else {
                                                        phi_5126_ = _e845;
                                                        phi_5037_ = true;
                                                        break;
                                                    }
                                                    let _e887 = global_2.member[_e867].member[_e457];
                                                    if (_e461 < 9u) {
                                                    } else {
                                                        phi_5126_ = _e845;
                                                        phi_5037_ = true;
                                                        break;
                                                    }
                                                    let _e893 = global_2.member[_e867].member[_e461];
                                                    let _e895 = (3u + _e453);
                                                    if (_e895 < 9u) {
                                                    } else {
                                                        phi_5126_ = _e845;
                                                        phi_5037_ = true;
                                                        break;
                                                    }
                                                    let _e901 = global_2.member[_e867].member[_e895];
                                                    let _e902 = (3u + _e457);
                                                    if (_e902 < 9u) {
                                                    } else {
                                                        phi_5126_ = _e845;
                                                        phi_5037_ = true;
                                                        break;
                                                    }
                                                    let _e908 = global_2.member[_e867].member[_e902];
                                                    let _e909 = (3u + _e461);
                                                    if (_e909 < 9u) {
                                                    } else {
                                                        phi_5126_ = _e845;
                                                        phi_5037_ = true;
                                                        break;
                                                    }
                                                    let _e915 = global_2.member[_e867].member[_e909];
                                                    let _e917 = (6u + _e453);
                                                    if (_e917 < 9u) {
                                                    } else {
                                                        phi_5126_ = _e845;
                                                        phi_5037_ = true;
                                                        break;
                                                    }
                                                    let _e923 = global_2.member[_e867].member[_e917];
                                                    let _e924 = (6u + _e457);
                                                    if (_e924 < 9u) {
                                                    } else {
                                                        phi_5126_ = _e845;
                                                        phi_5037_ = true;
                                                        break;
                                                    }
                                                    let _e930 = global_2.member[_e867].member[_e924];
                                                    let _e931 = (6u + _e461);
                                                    if (_e931 < 9u) {
                                                    } else {
                                                        phi_5126_ = _e845;
                                                        phi_5037_ = true;
                                                        break;
                                                    }
                                                    let _e937 = global_2.member[_e867].member[_e931];
                                                    phi_3110_ = array<array<f32, 3>, 3>(array<f32, 3>(_e881, _e887, _e893), array<f32, 3>(_e901, _e908, _e915), array<f32, 3>(_e923, _e930, _e937));
                                                }
                                                let _e941 = phi_3110_;
                                                let _e948 = (_e941[0][2] - _e375);
                                                let _e951 = (((_e941[0][0] - _e298) * _e399) - (_e948 * _e323));
                                                let _e954 = (((_e941[0][1] - _e337) * _e399) - (_e948 * _e361));
                                                let _e961 = (_e941[1][2] - _e375);
                                                let _e964 = (((_e941[1][0] - _e298) * _e399) - (_e961 * _e323));
                                                let _e967 = (((_e941[1][1] - _e337) * _e399) - (_e961 * _e361));
                                                let _e974 = (_e941[2][2] - _e375);
                                                let _e977 = (((_e941[2][0] - _e298) * _e399) - (_e974 * _e323));
                                                let _e980 = (((_e941[2][1] - _e337) * _e399) - (_e974 * _e361));
                                                let _e981 = (_e977 * _e967);
                                                let _e982 = (_e980 * _e964);
                                                let _e983 = (_e951 * _e980);
                                                let _e984 = (_e954 * _e977);
                                                let _e985 = (_e964 * _e954);
                                                let _e986 = (_e967 * _e951);
                                                let _e991 = (((_e981 >= _e982) && (_e983 >= _e984)) && (_e985 >= _e986));
                                                if (_e991 || (((_e981 <= _e982) && (_e983 <= _e984)) && (_e985 <= _e986))) {
                                                    let _e998 = select(-1f, 1f, _e991);
                                                    let _e1000 = ((_e981 - _e982) * _e998);
                                                    let _e1002 = select(0f, _e1000, (_e1000 > 0f));
                                                    let _e1004 = ((_e983 - _e984) * _e998);
                                                    let _e1006 = select(0f, _e1004, (_e1004 > 0f));
                                                    let _e1008 = ((_e985 - _e986) * _e998);
                                                    let _e1010 = select(0f, _e1008, (_e1008 > 0f));
                                                    let _e1012 = ((_e1002 + _e1006) + _e1010);
                                                    if (_e1012 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_3677_ = type_22();
                                                        phi_3678_ = true;
                                                    } else {
                                                        let _e1015 = select(_e941[1][0], _e941[0][0], (_e941[0][0] < _e941[1][0]));
                                                        let _e1019 = select(_e941[1][0], _e941[0][0], (_e941[0][0] > _e941[1][0]));
                                                        let _e1023 = select(_e941[1][1], _e941[0][1], (_e941[0][1] < _e941[1][1]));
                                                        let _e1027 = select(_e941[1][1], _e941[0][1], (_e941[0][1] > _e941[1][1]));
                                                        let _e1031 = select(_e941[1][2], _e941[0][2], (_e941[0][2] < _e941[1][2]));
                                                        let _e1035 = select(_e941[1][2], _e941[0][2], (_e941[0][2] > _e941[1][2]));
                                                        let _e1040 = ((select(_e941[2][0], _e1015, (_e1015 < _e941[2][0])) - _e321) * _e326);
                                                        let _e1041 = ((select(_e941[2][0], _e1019, (_e1019 > _e941[2][0])) - _e322) * _e326);
                                                        let _e1044 = ((select(_e941[2][1], _e1023, (_e1023 < _e941[2][1])) - _e359) * _e364);
                                                        let _e1045 = ((select(_e941[2][1], _e1027, (_e1027 > _e941[2][1])) - _e360) * _e364);
                                                        let _e1048 = ((select(_e941[2][2], _e1031, (_e1031 < _e941[2][2])) - _e397) * _e402);
                                                        let _e1049 = ((select(_e941[2][2], _e1035, (_e1035 > _e941[2][2])) - _e398) * _e402);
                                                        let _e1051 = select(_e1049, _e1048, (_e1048 < _e1049));
                                                        let _e1053 = select(_e1049, _e1048, (_e1048 > _e1049));
                                                        let _e1055 = select(_e1041, _e1040, (_e1040 < _e1041));
                                                        let _e1057 = select(_e1045, _e1044, (_e1044 < _e1045));
                                                        let _e1059 = select(_e1057, _e1055, (_e1055 > _e1057));
                                                        let _e1061 = select(_e1051, _e1059, (_e1059 > _e1051));
                                                        let _e1063 = select(_e1041, _e1040, (_e1040 > _e1041));
                                                        let _e1065 = select(_e1045, _e1044, (_e1044 > _e1045));
                                                        let _e1067 = select(_e1065, _e1063, (_e1063 < _e1065));
                                                        let _e1069 = select(_e1053, _e1067, (_e1067 < _e1053));
                                                        let _e1070 = -(_e1051);
                                                        let _e1076 = select(_e449, _e1061, (_e1061 > _e449));
                                                        if (_e1076 > (_e1069 + (select(_e1070, _e1053, (_e1053 > _e1070)) * 0.0000019073523f))) {
                                                            phi_3672_ = type_22();
                                                            phi_3673_ = true;
                                                        } else {
                                                            let _e1078 = (_e1076 > _e845);
                                                            if _e1078 {
                                                                phi_3671_ = type_22();
                                                            } else {
                                                                let _e1082 = (_e941[1][0] - _e941[0][0]);
                                                                let _e1083 = (_e941[1][1] - _e941[0][1]);
                                                                let _e1084 = (_e941[1][2] - _e941[0][2]);
                                                                let _e1085 = vec3<f32>(_e1082, _e1083, _e1084);
                                                                let _e1086 = (_e941[2][0] - _e941[1][0]);
                                                                let _e1087 = (_e941[2][1] - _e941[1][1]);
                                                                let _e1088 = (_e941[2][2] - _e941[1][2]);
                                                                let _e1089 = vec3<f32>(_e1086, _e1087, _e1088);
                                                                let _e1090 = (_e941[0][0] - _e941[2][0]);
                                                                let _e1091 = (_e941[0][1] - _e941[2][1]);
                                                                let _e1092 = (_e941[0][2] - _e941[2][2]);
                                                                let _e1093 = vec3<f32>(_e1090, _e1091, _e1092);
                                                                let _e1096 = bitcast<f32>((bitcast<u32>(_e1082) & 2147483647u));
                                                                let _e1099 = bitcast<f32>((bitcast<u32>(_e1083) & 2147483647u));
                                                                let _e1101 = select(_e1099, _e1096, (_e1096 > _e1099));
                                                                let _e1104 = bitcast<f32>((bitcast<u32>(_e1084) & 2147483647u));
                                                                let _e1106 = select(_e1104, _e1101, (_e1101 > _e1104));
                                                                let _e1109 = bitcast<f32>((bitcast<u32>(_e1086) & 2147483647u));
                                                                let _e1112 = bitcast<f32>((bitcast<u32>(_e1087) & 2147483647u));
                                                                let _e1114 = select(_e1112, _e1109, (_e1109 > _e1112));
                                                                let _e1117 = bitcast<f32>((bitcast<u32>(_e1088) & 2147483647u));
                                                                let _e1119 = select(_e1117, _e1114, (_e1114 > _e1117));
                                                                let _e1122 = bitcast<f32>((bitcast<u32>(_e1090) & 2147483647u));
                                                                let _e1125 = bitcast<f32>((bitcast<u32>(_e1091) & 2147483647u));
                                                                let _e1127 = select(_e1125, _e1122, (_e1122 > _e1125));
                                                                let _e1130 = bitcast<f32>((bitcast<u32>(_e1092) & 2147483647u));
                                                                let _e1132 = select(_e1130, _e1127, (_e1127 > _e1130));
                                                                let _e1134 = select(_e1119, _e1106, (_e1106 > _e1119));
                                                                let _e1136 = select(_e1132, _e1134, (_e1134 > _e1132));
                                                                if (_e1106 == _e1136) {
                                                                    phi_3582_ = _e1089;
                                                                    phi_3583_ = _e1093;
                                                                } else {
                                                                    let _e1139 = vec3((_e1119 == _e1136));
                                                                    phi_3582_ = select(_e1085, _e1093, _e1139);
                                                                    phi_3583_ = select(_e1089, _e1085, _e1139);
                                                                }
                                                                let _e1143 = phi_3582_;
                                                                let _e1145 = phi_3583_;
                                                                let _e1152 = ((_e1143.y * _e1145.z) - (_e1145.y * _e1143.z));
                                                                let _e1157 = ((_e1143.z * _e1145.x) - (_e1145.z * _e1143.x));
                                                                let _e1160 = ((_e1143.x * _e1145.y) - (_e1145.x * _e1143.y));
                                                                if (_e1002 >= _e1006) {
                                                                    phi_3614_ = select(true, false, (_e1002 >= _e1010));
                                                                } else {
                                                                    phi_3614_ = true;
                                                                }
                                                                let _e1165 = phi_3614_;
                                                                if _e1165 {
                                                                    phi_3623_ = select(vec3<f32>(_e941[2][0], _e941[2][1], _e941[2][2]), vec3<f32>(_e941[1][0], _e941[1][1], _e941[1][2]), vec3((_e1006 >= _e1010)));
                                                                } else {
                                                                    phi_3623_ = vec3<f32>(_e941[0][0], _e941[0][1], _e941[0][2]);
                                                                }
                                                                let _e1170 = phi_3623_;
                                                                let _e1187 = ((((_e1152 * (_e1170.x - _e298)) + (_e1157 * (_e1170.y - _e337))) + (_e1160 * (_e1170.z - _e375))) / (((_e1152 * _e323) + (_e1157 * _e361)) + (_e1160 * _e399)));
                                                                let _e1189 = select(_e1069, _e1187, (_e1187 < _e1069));
                                                                let _e1191 = select(_e1061, _e1189, (_e1189 > _e1061));
                                                                if (_e1191 >= _e449) {
                                                                    let _e1193 = (_e1191 <= _e845);
                                                                    if _e1193 {
                                                                        let _e1194 = (1f / _e1012);
                                                                        phi_3663_ = type_22(_e1191, (_e1006 * _e1194), (_e1010 * _e1194), _e874);
                                                                    } else {
                                                                        phi_3663_ = type_22();
                                                                    }
                                                                    let _e1199 = phi_3663_;
                                                                    phi_3665_ = _e1199;
                                                                    phi_3666_ = select(true, false, _e1193);
                                                                } else {
                                                                    phi_3665_ = type_22();
                                                                    phi_3666_ = true;
                                                                }
                                                                let _e1202 = phi_3665_;
                                                                let _e1204 = phi_3666_;
                                                                if _e1204 {
                                                                    phi_3670_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_3670_ = _e1202;
                                                                }
                                                                let _e1206 = phi_3670_;
                                                                phi_3671_ = _e1206;
                                                            }
                                                            let _e1208 = phi_3671_;
                                                            phi_3672_ = _e1208;
                                                            phi_3673_ = _e1078;
                                                        }
                                                        let _e1210 = phi_3672_;
                                                        let _e1212 = phi_3673_;
                                                        phi_3677_ = _e1210;
                                                        phi_3678_ = _e1212;
                                                    }
                                                    let _e1214 = phi_3677_;
                                                    let _e1216 = phi_3678_;
                                                    phi_3682_ = _e1214;
                                                    phi_3683_ = _e1216;
                                                } else {
                                                    phi_3682_ = type_22();
                                                    phi_3683_ = true;
                                                }
                                                let _e1218 = phi_3682_;
                                                let _e1220 = phi_3683_;
                                                if _e1220 {
                                                    phi_3687_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_3687_ = _e1218;
                                                }
                                                let _e1222 = phi_3687_;
                                                if (_e1222.member_3 != 4294967295u) {
                                                    if (_e874 != 4294967295u) {
                                                        phi_3699_ = type_4(0u, 8u);
                                                        phi_3702_ = _e1222;
                                                        loop {
                                                            let _e1227 = phi_3699_;
                                                            let _e1229 = phi_3702_;
                                                            if (_e1227.member < _e1227.member_1) {
                                                                phi_3700_ = type_4((_e1227.member + 1u), _e1227.member_1);
                                                                phi_3725_ = type_4(1u, _e1227.member);
                                                            } else {
                                                                phi_3700_ = _e1227;
                                                                phi_3725_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1242 = phi_3700_;
                                                            let _e1244 = phi_3725_;
                                                            let _e1248 = (bitcast<i32>(_e1244.member) != 0i);
                                                            if _e1248 {
                                                                let _e1249 = (_e1244.member_1 < 8u);
                                                                if _e1249 {
                                                                } else {
                                                                    phi_4974_ = true;
                                                                    break;
                                                                }
                                                                let _e1254 = local_2[_e1244.member_1].member;
                                                                if (_e1229.member < _e1254) {
                                                                    phi_3758_ = true;
                                                                } else {
                                                                    let _e1256 = local_2[_e1244.member_1].member;
                                                                    if (_e1229.member == _e1256) {
                                                                        let _e1261 = local_2[_e1244.member_1].member_3;
                                                                        phi_3757_ = (_e1229.member_3 < _e1261);
                                                                    } else {
                                                                        phi_3757_ = false;
                                                                    }
                                                                    let _e1264 = phi_3757_;
                                                                    phi_3758_ = _e1264;
                                                                }
                                                                let _e1266 = phi_3758_;
                                                                if _e1266 {
                                                                    if _e1249 {
                                                                    } else {
                                                                        phi_4974_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1267 = local_2[_e1244.member_1];
                                                                    local_2[_e1244.member_1] = type_22(_e1229.member, _e1229.member_1, _e1229.member_2, _e1229.member_3);
                                                                    phi_3779_ = type_22(_e1267.member, _e1267.member_1, _e1267.member_2, _e1267.member_3);
                                                                } else {
                                                                    phi_3779_ = _e1229;
                                                                }
                                                                let _e1278 = phi_3779_;
                                                                phi_3703_ = _e1278;
                                                            } else {
                                                                phi_3703_ = type_22();
                                                            }
                                                            let _e1280 = phi_3703_;
                                                            continue;
                                                            continuing {
                                                                phi_3699_ = _e1242;
                                                                phi_3702_ = _e1280;
                                                                phi_4974_ = _e843;
                                                                break if !(_e1248);
                                                            }
                                                        }
                                                        let _e1283 = phi_4974_;
                                                        phi_5126_ = _e845;
                                                        phi_5037_ = _e1283;
                                                        if _e1283 {
                                                            break;
                                                        }
                                                        let _e1286 = local_2[7u].member_3;
                                                        if (_e1286 != 4294967295u) {
                                                            let _e1290 = local_2[7u].member;
                                                            phi_5189_ = _e1290;
                                                        } else {
                                                            phi_5189_ = _e845;
                                                        }
                                                        let _e1292 = phi_5189_;
                                                        phi_5188_ = _e1292;
                                                        phi_5040_ = _e1283;
                                                    } else {
                                                        phi_5188_ = _e845;
                                                        phi_5040_ = _e843;
                                                    }
                                                    let _e1294 = phi_5188_;
                                                    let _e1296 = phi_5040_;
                                                    phi_5187_ = _e1294;
                                                    phi_5039_ = _e1296;
                                                } else {
                                                    phi_5187_ = _e845;
                                                    phi_5039_ = _e843;
                                                }
                                                let _e1298 = phi_5187_;
                                                let _e1300 = phi_5039_;
                                                phi_5186_ = _e1298;
                                                phi_5038_ = _e1300;
                                            } else {
                                                phi_5186_ = _e845;
                                                phi_5038_ = _e843;
                                            }
                                            let _e1302 = phi_5186_;
                                            let _e1304 = phi_5038_;
                                            continue;
                                            continuing {
                                                phi_4983_ = _e1304;
                                                phi_4973_ = _e1302;
                                                phi_2976_ = _e860;
                                                phi_5126_ = _e1302;
                                                phi_5037_ = _e1304;
                                                break if !(_e866);
                                            }
                                        }
                                        let _e1307 = phi_5126_;
                                        let _e1309 = phi_5037_;
                                        phi_5042_ = _e1309;
                                        if _e1309 {
                                            break;
                                        }
                                        phi_5091_ = _e1307;
                                        phi_5046_ = _e1309;
                                        phi_4635_ = _e518;
                                        phi_4636_ = false;
                                        phi_4637_ = _e522;
                                    } else {
                                        local_1 = array<f32, 3>(_e518.member.member[0], _e518.member.member[1], _e518.member.member[2]);
                                        local = array<f32, 3>(_e518.member.member_1[0], _e518.member.member_1[1], _e518.member.member_1[2]);
                                        let _e542 = (_e518.member_1 < _e87);
                                        if _e542 {
                                            if _e542 {
                                            } else {
                                                phi_5042_ = true;
                                                break;
                                            }
                                            let _e544 = global_5.member[_e518.member_1];
                                            phi_3824_ = _e544;
                                        } else {
                                            phi_3824_ = type_43(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e546 = phi_3824_;
                                        let _e548 = array<u32, 3>(_e249, _e248, _e250);
                                        local_10 = _e548;
                                        local_6 = array<f32, 3>(0f, 0f, 0f);
                                        local_5 = array<f32, 3>(0f, 0f, 0f);
                                        phi_3833_ = type_4(0u, 3u);
                                        loop {
                                            let _e550 = phi_3833_;
                                            if (_e550.member < _e550.member_1) {
                                                phi_3834_ = type_4((_e550.member + 1u), _e550.member_1);
                                                phi_3857_ = type_4(1u, _e550.member);
                                            } else {
                                                phi_3834_ = _e550;
                                                phi_3857_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e563 = phi_3834_;
                                            let _e565 = phi_3857_;
                                            let _e569 = (bitcast<i32>(_e565.member) != 0i);
                                            if _e569 {
                                                let _e570 = (_e565.member_1 < 3u);
                                                if _e570 {
                                                } else {
                                                    phi_4884_ = true;
                                                    break;
                                                }
                                                let _e572 = local_10[_e565.member_1];
                                                if _e570 {
                                                } else {
                                                    phi_4884_ = true;
                                                    break;
                                                }
                                                let _e574 = local_1[_e565.member_1];
                                                if _e570 {
                                                } else {
                                                    phi_4884_ = true;
                                                    break;
                                                }
                                                let _e576 = local[_e565.member_1];
                                                let _e579 = ((10u * _e572) & 31u);
                                                let _e582 = ((_e546.member[0] >> bitcast<u32>(_e579)) & 1023u);
                                                let _e587 = bitcast<f32>((bitcast<u32>(((_e576 - _e574) * 0.0009775171f)) ^ _e121));
                                                let _e593 = (_e574 + bitcast<f32>((bitcast<u32>((f32(_e582) * _e587)) ^ _e121)));
                                                if _e570 {
                                                } else {
                                                    phi_4884_ = true;
                                                    break;
                                                }
                                                local_6[_e565.member_1] = select(select(_e576, _e593, (_e593 < _e576)), _e576, (_e582 == 1023u));
                                                let _e602 = ((_e546.member[1] >> bitcast<u32>(_e579)) & 1023u);
                                                let _e608 = (_e574 + bitcast<f32>((bitcast<u32>((f32(_e602) * _e587)) ^ _e121)));
                                                if _e570 {
                                                } else {
                                                    phi_4884_ = true;
                                                    break;
                                                }
                                                local_5[_e565.member_1] = select(select(_e576, _e608, (_e608 < _e576)), _e576, (_e602 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_3833_ = _e563;
                                                phi_4884_ = _e480;
                                                break if !(_e569);
                                            }
                                        }
                                        let _e616 = phi_4884_;
                                        phi_5042_ = _e616;
                                        if _e616 {
                                            break;
                                        }
                                        let _e617 = local_5;
                                        let _e618 = local_6;
                                        local_9 = _e548;
                                        local_8 = array<f32, 3>(0f, 0f, 0f);
                                        local_7 = array<f32, 3>(0f, 0f, 0f);
                                        phi_3987_ = type_4(0u, 3u);
                                        loop {
                                            let _e627 = phi_3987_;
                                            if (_e627.member < _e627.member_1) {
                                                phi_3988_ = type_4((_e627.member + 1u), _e627.member_1);
                                                phi_4011_ = type_4(1u, _e627.member);
                                            } else {
                                                phi_3988_ = _e627;
                                                phi_4011_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e640 = phi_3988_;
                                            let _e642 = phi_4011_;
                                            let _e646 = (bitcast<i32>(_e642.member) != 0i);
                                            if _e646 {
                                                let _e647 = (_e642.member_1 < 3u);
                                                if _e647 {
                                                } else {
                                                    phi_4944_ = true;
                                                    break;
                                                }
                                                let _e649 = local_9[_e642.member_1];
                                                if _e647 {
                                                } else {
                                                    phi_4944_ = true;
                                                    break;
                                                }
                                                let _e651 = local_1[_e642.member_1];
                                                if _e647 {
                                                } else {
                                                    phi_4944_ = true;
                                                    break;
                                                }
                                                let _e653 = local[_e642.member_1];
                                                let _e656 = ((10u * _e649) & 31u);
                                                let _e659 = ((_e546.member_1[0] >> bitcast<u32>(_e656)) & 1023u);
                                                let _e664 = bitcast<f32>((bitcast<u32>(((_e653 - _e651) * 0.0009775171f)) ^ _e121));
                                                let _e670 = (_e651 + bitcast<f32>((bitcast<u32>((f32(_e659) * _e664)) ^ _e121)));
                                                if _e647 {
                                                } else {
                                                    phi_4944_ = true;
                                                    break;
                                                }
                                                local_8[_e642.member_1] = select(select(_e653, _e670, (_e670 < _e653)), _e653, (_e659 == 1023u));
                                                let _e679 = ((_e546.member_1[1] >> bitcast<u32>(_e656)) & 1023u);
                                                let _e685 = (_e651 + bitcast<f32>((bitcast<u32>((f32(_e679) * _e664)) ^ _e121)));
                                                if _e647 {
                                                } else {
                                                    phi_4944_ = true;
                                                    break;
                                                }
                                                local_7[_e642.member_1] = select(select(_e653, _e685, (_e685 < _e653)), _e653, (_e679 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_3987_ = _e640;
                                                phi_4944_ = _e616;
                                                break if !(_e646);
                                            }
                                        }
                                        let _e693 = phi_4944_;
                                        phi_5042_ = _e693;
                                        if _e693 {
                                            break;
                                        }
                                        let _e694 = local_7;
                                        let _e695 = local_8;
                                        let _e706 = type_52(type_49(array<f32, 3>(_e618[0], _e618[1], _e618[2]), array<f32, 3>(_e617[0], _e617[1], _e617[2])), _e546.member_2);
                                        let _e711 = type_52(type_49(array<f32, 3>(_e695[0], _e695[1], _e695[2]), array<f32, 3>(_e694[0], _e694[1], _e694[2])), _e546.member_3);
                                        let _e716 = ((_e618[0] - _e321) * _e326);
                                        let _e717 = ((_e695[0] - _e321) * _e326);
                                        let _e718 = ((_e617[0] - _e322) * _e326);
                                        let _e719 = ((_e694[0] - _e322) * _e326);
                                        let _e724 = ((_e618[1] - _e359) * _e364);
                                        let _e725 = ((_e695[1] - _e359) * _e364);
                                        let _e726 = ((_e617[1] - _e360) * _e364);
                                        let _e727 = ((_e694[1] - _e360) * _e364);
                                        let _e732 = ((_e618[2] - _e397) * _e402);
                                        let _e733 = ((_e695[2] - _e397) * _e402);
                                        let _e734 = ((_e617[2] - _e398) * _e402);
                                        let _e735 = ((_e694[2] - _e398) * _e402);
                                        let _e737 = select(_e734, _e732, (_e732 < _e734));
                                        let _e739 = select(_e735, _e733, (_e733 < _e735));
                                        let _e741 = select(_e734, _e732, (_e732 > _e734));
                                        let _e743 = select(_e735, _e733, (_e733 > _e735));
                                        let _e745 = select(_e718, _e716, (_e716 < _e718));
                                        let _e747 = select(_e719, _e717, (_e717 < _e719));
                                        let _e749 = select(_e726, _e724, (_e724 < _e726));
                                        let _e751 = select(_e727, _e725, (_e725 < _e727));
                                        let _e753 = select(_e749, _e745, (_e745 > _e749));
                                        let _e755 = select(_e751, _e747, (_e747 > _e751));
                                        let _e757 = select(_e737, _e753, (_e753 > _e737));
                                        let _e759 = select(_e739, _e755, (_e755 > _e739));
                                        let _e761 = select(_e718, _e716, (_e716 > _e718));
                                        let _e763 = select(_e719, _e717, (_e717 > _e719));
                                        let _e765 = select(_e726, _e724, (_e724 > _e726));
                                        let _e767 = select(_e727, _e725, (_e725 > _e727));
                                        let _e769 = select(_e765, _e761, (_e761 < _e765));
                                        let _e771 = select(_e767, _e763, (_e763 < _e767));
                                        let _e776 = -(_e737);
                                        let _e777 = -(_e739);
                                        let _e784 = (select(_e741, _e769, (_e769 < _e741)) + (select(_e776, _e741, (_e741 > _e776)) * 0.0000019073523f));
                                        let _e785 = (select(_e743, _e771, (_e771 < _e743)) + (select(_e777, _e743, (_e743 > _e777)) * 0.0000019073523f));
                                        let _e787 = select(_e449, _e757, (_e757 > _e449));
                                        let _e789 = select(_e449, _e759, (_e759 > _e449));
                                        let _e794 = (_e787 <= select(_e482, _e784, (_e784 < _e482)));
                                        let _e795 = (_e789 <= select(_e482, _e785, (_e785 < _e482)));
                                        let _e796 = (_e787 <= _e789);
                                        if _e794 {
                                            if _e795 {
                                                if _e796 {
                                                    phi_4575_ = _e711;
                                                } else {
                                                    phi_4575_ = _e706;
                                                }
                                                let _e798 = phi_4575_;
                                                let _e799 = (_e522 % 128u);
                                                let _e800 = (_e799 < 128u);
                                                if _e800 {
                                                } else {
                                                    phi_5042_ = true;
                                                    break;
                                                }
                                                local_4[_e799] = type_52(type_49(array<f32, 3>(_e798.member.member[0], _e798.member.member[1], _e798.member.member[2]), array<f32, 3>(_e798.member.member_1[0], _e798.member.member_1[1], _e798.member.member_1[2])), _e798.member_1);
                                                if _e800 {
                                                } else {
                                                    phi_5042_ = true;
                                                    break;
                                                }
                                                local_3[_e799] = select(_e789, _e787, (_e787 > _e789));
                                                if _e796 {
                                                    phi_4614_ = _e706;
                                                } else {
                                                    phi_4614_ = _e711;
                                                }
                                                let _e821 = phi_4614_;
                                                phi_4615_ = _e821;
                                                phi_4616_ = (_e522 + 1u);
                                            } else {
                                                phi_4615_ = type_52();
                                                phi_4616_ = u32();
                                            }
                                            let _e823 = phi_4615_;
                                            let _e825 = phi_4616_;
                                            phi_4618_ = _e823;
                                            phi_4619_ = _e825;
                                            phi_4620_ = select(true, false, _e795);
                                        } else {
                                            phi_4618_ = type_52();
                                            phi_4619_ = u32();
                                            phi_4620_ = true;
                                        }
                                        let _e828 = phi_4618_;
                                        let _e830 = phi_4619_;
                                        let _e832 = phi_4620_;
                                        if _e832 {
                                            if _e794 {
                                                phi_4627_ = _e706;
                                            } else {
                                                phi_4627_ = _e711;
                                            }
                                            let _e834 = phi_4627_;
                                            phi_4632_ = _e834;
                                            phi_4633_ = select(_e795, true, _e794);
                                        } else {
                                            phi_4632_ = _e828;
                                            phi_4633_ = _e520;
                                        }
                                        let _e837 = phi_4632_;
                                        let _e839 = phi_4633_;
                                        phi_5091_ = _e482;
                                        phi_5046_ = _e693;
                                        phi_4635_ = _e837;
                                        phi_4636_ = _e839;
                                        phi_4637_ = select(_e830, _e522, _e832);
                                    }
                                    let _e1311 = phi_5091_;
                                    let _e1313 = phi_5046_;
                                    let _e1315 = phi_4635_;
                                    let _e1317 = phi_4636_;
                                    let _e1319 = phi_4637_;
                                    phi_5090_ = _e1311;
                                    phi_5045_ = _e1313;
                                    phi_4638_ = _e1315;
                                    phi_4639_ = (_e486 - 1u);
                                    phi_4640_ = _e1317;
                                    phi_4641_ = _e1319;
                                } else {
                                    phi_5090_ = _e482;
                                    phi_5045_ = _e480;
                                    phi_4638_ = _e518;
                                    phi_4639_ = _e486;
                                    phi_4640_ = _e520;
                                    phi_4641_ = _e522;
                                }
                                let _e1321 = phi_5090_;
                                let _e1323 = phi_5045_;
                                let _e1325 = phi_4638_;
                                let _e1327 = phi_4639_;
                                let _e1329 = phi_4640_;
                                let _e1331 = phi_4641_;
                                phi_5089_ = _e1321;
                                phi_5044_ = _e1323;
                                phi_4642_ = _e1325;
                                phi_4643_ = _e1327;
                                phi_4644_ = _e1329;
                                phi_4645_ = _e1331;
                            } else {
                                phi_5089_ = _e482;
                                phi_5044_ = _e480;
                                phi_4642_ = type_52();
                                phi_4643_ = u32();
                                phi_4644_ = bool();
                                phi_4645_ = u32();
                            }
                            let _e1333 = phi_5089_;
                            let _e1335 = phi_5044_;
                            let _e1337 = phi_4642_;
                            let _e1339 = phi_4643_;
                            let _e1341 = phi_4644_;
                            let _e1343 = phi_4645_;
                            phi_5088_ = _e1333;
                            phi_5043_ = _e1335;
                            phi_2893_ = _e1337;
                            phi_2896_ = _e1339;
                            phi_2898_ = _e1341;
                            phi_2900_ = _e1343;
                            phi_4646_ = _e494;
                        } else {
                            phi_5088_ = _e482;
                            phi_5043_ = _e480;
                            phi_2893_ = type_52();
                            phi_2896_ = u32();
                            phi_2898_ = bool();
                            phi_2900_ = u32();
                            phi_4646_ = false;
                        }
                        let _e1345 = phi_5088_;
                        let _e1347 = phi_5043_;
                        let _e1349 = phi_2893_;
                        let _e1351 = phi_2896_;
                        let _e1353 = phi_2898_;
                        let _e1355 = phi_2900_;
                        let _e1357 = phi_4646_;
                        continue;
                        continuing {
                            phi_4891_ = _e1347;
                            phi_4882_ = _e1345;
                            phi_2892_ = _e1349;
                            phi_2895_ = _e1351;
                            phi_2897_ = _e1353;
                            phi_2899_ = _e1355;
                            phi_5042_ = _e1347;
                            break if !(_e1357);
                        }
                    }
                    let _e1360 = phi_5042_;
                    if _e1360 {
                        break;
                    }
                    phi_4653_ = type_4(0u, 8u);
                    loop {
                        let _e1362 = phi_4653_;
                        if (_e1362.member < _e1362.member_1) {
                            phi_4654_ = type_4((_e1362.member + 1u), _e1362.member_1);
                            phi_4677_ = type_4(1u, _e1362.member);
                        } else {
                            phi_4654_ = _e1362;
                            phi_4677_ = type_4(0u, type_4().member_1);
                        }
                        let _e1375 = phi_4654_;
                        let _e1377 = phi_4677_;
                        let _e1381 = (bitcast<i32>(_e1377.member) != 0i);
                        if _e1381 {
                            let _e1382 = (_e1377.member_1 < 8u);
                            if _e1382 {
                            } else {
                                phi_5081_ = true;
                                break;
                            }
                            let _e1384 = local_2[_e1377.member_1];
                            if (_e1384.member_3 != 4294967295u) {
                                let _e1390 = -(_e416);
                                let _e1391 = (_e1390 / 3i);
                                let _e1398 = bitcast<f32>((bitcast<u32>((_e1391 + 127i)) << bitcast<u32>(23i)));
                                let _e1406 = (((_e1384.member * _e1398) * _e1398) * bitcast<f32>((bitcast<u32>(((_e1390 - (2i * _e1391)) + 127i)) << bitcast<u32>(23i))));
                                let _e1408 = select(340282350000000000000000000000000000000f, _e1406, (_e1406 < 340282350000000000000000000000000000000f));
                                phi_4743_ = type_22(select(-340282350000000000000000000000000000000f, _e1408, (_e1408 > -340282350000000000000000000000000000000f)), _e1384.member_1, _e1384.member_2, _e1384.member_3);
                            } else {
                                phi_4743_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1413 = phi_4743_;
                            if _e1382 {
                            } else {
                                phi_5081_ = true;
                                break;
                            }
                            local_2[_e1377.member_1] = type_22(_e1413.member, _e1413.member_1, _e1413.member_2, _e1413.member_3);
                        }
                        continue;
                        continuing {
                            phi_4653_ = _e1375;
                            phi_5081_ = _e1360;
                            break if !(_e1381);
                        }
                    }
                    let _e1421 = phi_5081_;
                    if _e1421 {
                        break;
                    }
                    let _e1422 = local_2;
                    if _e137 {
                    } else {
                        break;
                    }
                    global_6.member[_e135] = array<type_22, 8>(type_22(_e1422[0].member, _e1422[0].member_1, _e1422[0].member_2, _e1422[0].member_3), type_22(_e1422[1].member, _e1422[1].member_1, _e1422[1].member_2, _e1422[1].member_3), type_22(_e1422[2].member, _e1422[2].member_1, _e1422[2].member_2, _e1422[2].member_3), type_22(_e1422[3].member, _e1422[3].member_1, _e1422[3].member_2, _e1422[3].member_3), type_22(_e1422[4].member, _e1422[4].member_1, _e1422[4].member_2, _e1422[4].member_3), type_22(_e1422[5].member, _e1422[5].member_1, _e1422[5].member_2, _e1422[5].member_3), type_22(_e1422[6].member, _e1422[6].member_1, _e1422[6].member_2, _e1422[6].member_3), type_22(_e1422[7].member, _e1422[7].member_1, _e1422[7].member_2, _e1422[7].member_3));
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
