struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_8 {
    member: vec4<u32>,
}

struct type_18 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_20 {
    member: array<type_18>,
}

struct type_22 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_28 {
    member: type_18,
    member_1: f32,
}

struct type_31 {
    member: array<type_22>,
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

struct type_41 {
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
    member: type_41,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(1) 
var<uniform> global_2: type_34;
@group(0) @binding(4) 
var<storage> global_3: type_31;
@group(0) @binding(2) 
var<storage> global_4: type_38;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_20;
@group(0) @binding(3) 
var<storage> global_6: type_46;

fn function_() {
    var local: array<f32, 3>;
    var local_1: array<f32, 3>;
    var local_2: array<f32, 3>;
    var local_3: array<f32, 3>;
    var local_4: array<f32, 128>;
    var local_5: array<type_50, 128>;
    var local_6: array<f32, 3>;
    var local_7: array<f32, 3>;
    var local_8: array<f32, 3>;
    var local_9: array<f32, 3>;
    var local_10: array<u32, 3>;
    var local_11: array<u32, 3>;
    var local_12: array<u32, 3>;
    var local_13: array<array<f32, 3>, 3>;
    var local_14: array<u32, 3>;
    var local_15: array<f32, 3>;
    var local_16: array<f32, 3>;
    var phi_343_: i32;
    var phi_344_: i32;
    var phi_354_: bool;
    var phi_364_: u32;
    var phi_365_: u32;
    var phi_367_: bool;
    var phi_372_: u32;
    var phi_385_: i32;
    var phi_405_: i32;
    var phi_423_: f32;
    var phi_429_: f32;
    var phi_440_: f32;
    var phi_446_: f32;
    var phi_469_: f32;
    var phi_480_: f32;
    var phi_489_: f32;
    var phi_495_: f32;
    var phi_506_: f32;
    var phi_512_: f32;
    var phi_535_: f32;
    var phi_546_: f32;
    var phi_555_: f32;
    var phi_561_: f32;
    var phi_572_: f32;
    var phi_578_: f32;
    var phi_601_: f32;
    var phi_612_: f32;
    var phi_712_: f32;
    var phi_713_: f32;
    var phi_4783_: bool;
    var phi_2841_: type_28;
    var phi_2844_: type_50;
    var phi_2846_: u32;
    var phi_2848_: bool;
    var phi_2850_: u32;
    var phi_2861_: bool;
    var phi_2906_: type_50;
    var phi_2907_: bool;
    var phi_2908_: u32;
    var phi_3824_: type_36;
    var phi_3833_: type_4;
    var phi_3834_: type_4;
    var phi_3857_: type_4;
    var phi_4776_: bool;
    var phi_3987_: type_4;
    var phi_3988_: type_4;
    var phi_4011_: type_4;
    var phi_4836_: bool;
    var phi_4574_: type_50;
    var phi_4613_: type_50;
    var phi_4614_: type_50;
    var phi_4615_: u32;
    var phi_4617_: type_50;
    var phi_4618_: u32;
    var phi_4619_: bool;
    var phi_4626_: type_50;
    var phi_4631_: type_50;
    var phi_4632_: bool;
    var phi_4853_: bool;
    var phi_2927_: type_28;
    var phi_2930_: type_4;
    var phi_2931_: type_4;
    var phi_2953_: type_4;
    var phi_2995_: u32;
    var phi_3019_: type_44;
    var phi_4849_: bool;
    var phi_3030_: type_4;
    var phi_3031_: type_4;
    var phi_3054_: type_4;
    var phi_3064_: type_4;
    var phi_3065_: type_4;
    var phi_3088_: type_4;
    var phi_4844_: bool;
    var phi_4857_: bool;
    var phi_4856_: bool;
    var phi_3651_: vec3<f32>;
    var phi_3652_: vec3<f32>;
    var phi_3683_: bool;
    var phi_3692_: vec3<f32>;
    var phi_3732_: type_18;
    var phi_3734_: type_18;
    var phi_3735_: bool;
    var phi_3739_: type_18;
    var phi_3740_: type_18;
    var phi_3741_: type_18;
    var phi_3742_: bool;
    var phi_3746_: type_18;
    var phi_3747_: bool;
    var phi_3751_: type_18;
    var phi_3752_: bool;
    var phi_3756_: type_18;
    var phi_3781_: bool;
    var phi_3782_: bool;
    var phi_3788_: type_28;
    var phi_3789_: type_28;
    var phi_3790_: type_28;
    var phi_4859_: bool;
    var phi_2928_: type_28;
    var phi_4858_: bool;
    var phi_4921_: bool;
    var phi_4634_: type_28;
    var phi_4635_: type_50;
    var phi_4636_: bool;
    var phi_4637_: u32;
    var phi_4920_: bool;
    var phi_4638_: type_28;
    var phi_4639_: type_50;
    var phi_4640_: u32;
    var phi_4641_: bool;
    var phi_4642_: u32;
    var phi_4919_: bool;
    var phi_4643_: type_28;
    var phi_4644_: type_50;
    var phi_4645_: u32;
    var phi_4646_: bool;
    var phi_4647_: u32;
    var phi_4918_: bool;
    var phi_2842_: type_28;
    var phi_2845_: type_50;
    var phi_2847_: u32;
    var phi_2849_: bool;
    var phi_2851_: u32;
    var phi_4648_: bool;
    var phi_4917_: bool;
    var local_17: type_28;
    var phi_4700_: type_18;
    var local_18: type_28;

    switch bitcast<i32>(0u) {
        default: {
            let _e83 = global;
            let _e86 = arrayLength((&global_4.member));
            let _e97 = global_2.member[0u][0u];
            let _e101 = global_2.member[0u][1u];
            let _e105 = global_2.member[0u][2u];
            let _e109 = global_2.member[1u][0u];
            let _e113 = global_2.member[1u][1u];
            let _e117 = global_2.member[1u][2u];
            let _e121 = global_2.member[1u][3u];
            let _e124 = global_1.member[0u];
            let _e125 = bitcast<i32>(_e124);
            let _e135 = (_e83.x + (_e83.y * 2097152u));
            let _e136 = (_e135 < arrayLength((&global_3.member)));
            if _e136 {
                let _e137 = (_e135 < arrayLength((&global_5.member)));
                if _e137 {
                    if _e136 {
                    } else {
                        break;
                    }
                    let _e145 = global_3.member[_e135].member_2[0u];
                    let _e147 = (bitcast<u32>(_e145) & 2147483647u);
                    let _e152 = global_3.member[_e135].member_2[1u];
                    let _e154 = (bitcast<u32>(_e152) & 2147483647u);
                    let _e159 = global_3.member[_e135].member_2[2u];
                    let _e161 = (bitcast<u32>(_e159) & 2147483647u);
                    let _e166 = global_3.member[_e135].member[0u];
                    let _e168 = (bitcast<u32>(_e166) & 2147483647u);
                    let _e173 = global_3.member[_e135].member[1u];
                    let _e175 = (bitcast<u32>(_e173) & 2147483647u);
                    let _e180 = global_3.member[_e135].member[2u];
                    let _e182 = (bitcast<u32>(_e180) & 2147483647u);
                    let _e184 = select(_e154, _e147, (_e154 < _e147));
                    let _e186 = select(_e161, _e184, (_e161 < _e184));
                    let _e188 = select(_e168, _e186, (_e168 < _e186));
                    let _e190 = select(_e175, _e188, (_e175 < _e188));
                    let _e192 = select(_e182, _e190, (_e182 < _e190));
                    let _e196 = global_3.member[_e135].member_1;
                    let _e198 = (bitcast<u32>(_e196) & 2147483647u);
                    let _e205 = global_3.member[_e135].member_3;
                    let _e211 = (((select(_e198, _e192, (_e198 < _e192)) < 2139095040u) && ((bitcast<u32>(_e205) & 2147483647u) <= 2139095040u)) && (_e186 > 0u));
                    if _e211 {
                        let _e214 = (bitcast<u32>(bitcast<f32>(_e186)) & 2147483647u);
                        if (_e214 >= 8388608u) {
                            phi_343_ = (bitcast<i32>((_e214 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_343_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e214)), 32u, (_e214 == 0u))));
                        }
                        let _e228 = phi_343_;
                        phi_344_ = _e228;
                    } else {
                        phi_344_ = 0i;
                    }
                    let _e230 = phi_344_;
                    let _e231 = (_e147 == _e186);
                    if _e231 {
                        phi_354_ = true;
                    } else {
                        phi_354_ = (_e154 == _e186);
                    }
                    let _e234 = phi_354_;
                    let _e235 = select(1u, 0u, _e231);
                    if _e234 {
                        let _e236 = (_e235 + 1u);
                        phi_364_ = _e236;
                        phi_365_ = _e236;
                        phi_367_ = select(true, false, (_e236 == 2u));
                    } else {
                        phi_364_ = u32();
                        phi_365_ = 0u;
                        phi_367_ = true;
                    }
                    let _e240 = phi_364_;
                    let _e242 = phi_365_;
                    let _e244 = phi_367_;
                    if _e244 {
                        phi_372_ = (_e242 + 1u);
                    } else {
                        phi_372_ = 0u;
                    }
                    let _e248 = phi_372_;
                    let _e249 = select(_e240, _e242, _e244);
                    let _e250 = select(_e235, select(2u, _e235, _e234), _e244);
                    if (_e125 < -126i) {
                        phi_385_ = -126i;
                    } else {
                        phi_385_ = select(_e125, 127i, (_e125 > 127i));
                    }
                    let _e255 = phi_385_;
                    let _e260 = bitcast<f32>((bitcast<u32>((_e255 + 127i)) << bitcast<u32>(23i)));
                    let _e266 = bitcast<f32>((bitcast<u32>(((_e125 - _e255) + 127i)) << bitcast<u32>(23i)));
                    let _e267 = -(_e230);
                    if (_e267 < -126i) {
                        phi_405_ = -126i;
                    } else {
                        phi_405_ = select(_e267, 127i, (_e267 > 127i));
                    }
                    let _e272 = phi_405_;
                    let _e277 = bitcast<f32>((bitcast<u32>((_e272 + 127i)) << bitcast<u32>(23i)));
                    let _e283 = bitcast<f32>((bitcast<u32>(((_e267 - _e272) + 127i)) << bitcast<u32>(23i)));
                    let _e287 = global_3.member[_e135].member;
                    let _e288 = (_e249 == 0u);
                    if _e288 {
                        phi_423_ = _e287[0];
                    } else {
                        phi_423_ = _e287[1];
                    }
                    let _e292 = phi_423_;
                    let _e293 = (_e249 == 2u);
                    if _e293 {
                        phi_429_ = _e287[2];
                    } else {
                        phi_429_ = _e292;
                    }
                    let _e296 = phi_429_;
                    let _e298 = ((_e296 * _e260) * _e266);
                    let _e299 = global_3.member[_e135].member_2;
                    if _e288 {
                        phi_440_ = _e299[0];
                    } else {
                        phi_440_ = _e299[1];
                    }
                    let _e303 = phi_440_;
                    if _e293 {
                        phi_446_ = _e299[2];
                    } else {
                        phi_446_ = _e303;
                    }
                    let _e306 = phi_446_;
                    let _e308 = ((_e306 * _e277) * _e283);
                    let _e312 = (bitcast<f32>((bitcast<u32>(_e308) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e312 {
                        let _e316 = (bitcast<f32>((bitcast<u32>(_e298) & 2147483647u)) * 0.00000011920929f);
                        phi_469_ = select(0.00000000000011368684f, _e316, (_e316 > 0.00000000000011368684f));
                    } else {
                        phi_469_ = 0f;
                    }
                    let _e320 = phi_469_;
                    let _e321 = (_e298 + _e320);
                    let _e322 = (_e298 - _e320);
                    let _e323 = select(_e308, 0f, _e312);
                    if _e312 {
                        phi_480_ = 38685626000000000000000000f;
                    } else {
                        phi_480_ = (1f / _e308);
                    }
                    let _e326 = phi_480_;
                    let _e327 = (_e248 == 0u);
                    if _e327 {
                        phi_489_ = _e287[0];
                    } else {
                        phi_489_ = _e287[1];
                    }
                    let _e331 = phi_489_;
                    let _e332 = (_e248 == 2u);
                    if _e332 {
                        phi_495_ = _e287[2];
                    } else {
                        phi_495_ = _e331;
                    }
                    let _e335 = phi_495_;
                    let _e337 = ((_e335 * _e260) * _e266);
                    if _e327 {
                        phi_506_ = _e299[0];
                    } else {
                        phi_506_ = _e299[1];
                    }
                    let _e341 = phi_506_;
                    if _e332 {
                        phi_512_ = _e299[2];
                    } else {
                        phi_512_ = _e341;
                    }
                    let _e344 = phi_512_;
                    let _e346 = ((_e344 * _e277) * _e283);
                    let _e350 = (bitcast<f32>((bitcast<u32>(_e346) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e350 {
                        let _e354 = (bitcast<f32>((bitcast<u32>(_e337) & 2147483647u)) * 0.00000011920929f);
                        phi_535_ = select(0.00000000000011368684f, _e354, (_e354 > 0.00000000000011368684f));
                    } else {
                        phi_535_ = 0f;
                    }
                    let _e358 = phi_535_;
                    let _e359 = (_e337 + _e358);
                    let _e360 = (_e337 - _e358);
                    let _e361 = select(_e346, 0f, _e350);
                    if _e350 {
                        phi_546_ = 38685626000000000000000000f;
                    } else {
                        phi_546_ = (1f / _e346);
                    }
                    let _e364 = phi_546_;
                    let _e365 = (_e250 == 0u);
                    if _e365 {
                        phi_555_ = _e287[0];
                    } else {
                        phi_555_ = _e287[1];
                    }
                    let _e369 = phi_555_;
                    let _e370 = (_e250 == 2u);
                    if _e370 {
                        phi_561_ = _e287[2];
                    } else {
                        phi_561_ = _e369;
                    }
                    let _e373 = phi_561_;
                    let _e375 = ((_e373 * _e260) * _e266);
                    if _e365 {
                        phi_572_ = _e299[0];
                    } else {
                        phi_572_ = _e299[1];
                    }
                    let _e379 = phi_572_;
                    if _e370 {
                        phi_578_ = _e299[2];
                    } else {
                        phi_578_ = _e379;
                    }
                    let _e382 = phi_578_;
                    let _e384 = ((_e382 * _e277) * _e283);
                    let _e388 = (bitcast<f32>((bitcast<u32>(_e384) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e388 {
                        let _e392 = (bitcast<f32>((bitcast<u32>(_e375) & 2147483647u)) * 0.00000011920929f);
                        phi_601_ = select(0.00000000000011368684f, _e392, (_e392 > 0.00000000000011368684f));
                    } else {
                        phi_601_ = 0f;
                    }
                    let _e396 = phi_601_;
                    let _e397 = (_e375 + _e396);
                    let _e398 = (_e375 - _e396);
                    let _e399 = select(_e384, 0f, _e388);
                    if _e388 {
                        phi_612_ = 38685626000000000000000000f;
                    } else {
                        phi_612_ = (1f / _e384);
                    }
                    let _e402 = phi_612_;
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
                        phi_712_ = select(-340282350000000000000000000000000000000f, _e443, (_e443 > -340282350000000000000000000000000000000f));
                        phi_713_ = select(-340282350000000000000000000000000000000f, _e436, (_e436 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_712_ = 0f;
                        phi_713_ = 1f;
                    }
                    let _e447 = phi_712_;
                    let _e449 = phi_713_;
                    local_5 = array<type_50, 128>(type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u));
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_16 = array<f32, 3>(bitcast<f32>(_e97), bitcast<f32>(_e101), bitcast<f32>(_e105));
                    let _e454 = (_e249 % 3u);
                    let _e455 = (_e454 < 3u);
                    if _e455 {
                    } else {
                        break;
                    }
                    let _e457 = local_16[_e454];
                    let _e458 = (_e248 % 3u);
                    let _e459 = (_e458 < 3u);
                    if _e459 {
                    } else {
                        break;
                    }
                    let _e461 = local_16[_e458];
                    let _e462 = (_e250 % 3u);
                    let _e463 = (_e462 < 3u);
                    if _e463 {
                    } else {
                        break;
                    }
                    let _e465 = local_16[_e462];
                    local_15 = array<f32, 3>(bitcast<f32>(_e109), bitcast<f32>(_e113), bitcast<f32>(_e117));
                    if _e455 {
                    } else {
                        break;
                    }
                    let _e469 = local_15[_e454];
                    if _e459 {
                    } else {
                        break;
                    }
                    let _e471 = local_15[_e458];
                    if _e463 {
                    } else {
                        break;
                    }
                    let _e473 = local_15[_e462];
                    phi_4783_ = false;
                    phi_2841_ = type_28(type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e447);
                    phi_2844_ = type_50(type_41(array<f32, 3>(_e457, _e461, _e465), array<f32, 3>(_e469, _e471, _e473)), select(0u, 2147483648u, (_e86 == 0u)));
                    phi_2846_ = ((3u * _e86) + 1u);
                    phi_2848_ = (_e449 <= _e447);
                    phi_2850_ = 0u;
                    loop {
                        let _e481 = phi_4783_;
                        let _e483 = phi_2841_;
                        let _e485 = phi_2844_;
                        let _e487 = phi_2846_;
                        let _e489 = phi_2848_;
                        let _e491 = phi_2850_;
                        local_17 = _e483;
                        if _e489 {
                            phi_2861_ = true;
                        } else {
                            phi_2861_ = (_e491 > 0u);
                        }
                        let _e494 = phi_2861_;
                        if _e494 {
                            let _e495 = (_e487 > 0u);
                            if _e495 {
                                if _e489 {
                                    phi_2906_ = _e485;
                                    phi_2907_ = _e489;
                                    phi_2908_ = _e491;
                                } else {
                                    let _e496 = (_e491 - 1u);
                                    let _e497 = (_e496 % 128u);
                                    let _e498 = (_e497 < 128u);
                                    if _e498 {
                                    } else {
                                        phi_4917_ = true;
                                        break;
                                    }
                                    let _e500 = local_5[_e497];
                                    if _e498 {
                                    } else {
                                        phi_4917_ = true;
                                        break;
                                    }
                                    let _e516 = local_4[_e497];
                                    phi_2906_ = type_50(type_41(array<f32, 3>(_e500.member.member[0], _e500.member.member[1], _e500.member.member[2]), array<f32, 3>(_e500.member.member_1[0], _e500.member.member_1[1], _e500.member.member_1[2])), _e500.member_1);
                                    phi_2907_ = (_e516 <= _e483.member_1);
                                    phi_2908_ = _e496;
                                }
                                let _e520 = phi_2906_;
                                let _e522 = phi_2907_;
                                let _e524 = phi_2908_;
                                if _e522 {
                                    if ((_e520.member_1 & 2147483648u) != 0u) {
                                        phi_4853_ = _e481;
                                        phi_2927_ = _e483;
                                        phi_2930_ = type_4(0u, ((_e520.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e846 = phi_4853_;
                                            let _e848 = phi_2927_;
                                            let _e850 = phi_2930_;
                                            local_18 = _e848;
                                            if (_e850.member < _e850.member_1) {
                                                phi_2931_ = type_4((_e850.member + 1u), _e850.member_1);
                                                phi_2953_ = type_4(1u, _e850.member);
                                            } else {
                                                phi_2931_ = _e850;
                                                phi_2953_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e863 = phi_2931_;
                                            let _e865 = phi_2953_;
                                            let _e869 = (bitcast<i32>(_e865.member) != 0i);
                                            if _e869 {
                                                local_1 = array<f32, 3>(_e520.member.member[0], _e520.member.member[1], _e520.member.member[2]);
                                                local = array<f32, 3>(_e520.member.member_1[0], _e520.member.member_1[1], _e520.member.member_1[2]);
                                                let _e880 = ((_e520.member_1 & 268435455u) + _e865.member_1);
                                                let _e881 = (_e880 < arrayLength((&global_6.member)));
                                                if _e881 {
                                                    if _e881 {
                                                    } else {
                                                        phi_4858_ = true;
                                                        break;
                                                    }
                                                    let _e884 = global_6.member[_e880].member_1;
                                                    phi_2995_ = _e884;
                                                } else {
                                                    phi_2995_ = 4294967295u;
                                                }
                                                let _e886 = phi_2995_;
                                                local_12 = array<u32, 3>(_e249, _e248, _e250);
                                                if _e881 {
                                                    if _e881 {
                                                    } else {
                                                        phi_4858_ = true;
                                                        break;
                                                    }
                                                    let _e889 = global_6.member[_e880];
                                                    phi_3019_ = _e889;
                                                } else {
                                                    phi_3019_ = type_44(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e891 = phi_3019_;
                                                local_14 = array<u32, 3>(_e891.member[0], _e891.member[1], _e891.member[2]);
                                                local_13[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_13[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_13[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_4849_ = _e846;
                                                phi_3030_ = type_4(0u, 3u);
                                                loop {
                                                    let _e901 = phi_4849_;
                                                    let _e903 = phi_3030_;
                                                    if (_e903.member < _e903.member_1) {
                                                        phi_3031_ = type_4((_e903.member + 1u), _e903.member_1);
                                                        phi_3054_ = type_4(1u, _e903.member);
                                                    } else {
                                                        phi_3031_ = _e903;
                                                        phi_3054_ = type_4(0u, type_4().member_1);
                                                    }
                                                    let _e916 = phi_3031_;
                                                    let _e918 = phi_3054_;
                                                    let _e922 = (bitcast<i32>(_e918.member) != 0i);
                                                    if _e922 {
                                                        phi_3064_ = type_4(0u, 3u);
                                                        loop {
                                                            let _e924 = phi_3064_;
                                                            if (_e924.member < _e924.member_1) {
                                                                phi_3065_ = type_4((_e924.member + 1u), _e924.member_1);
                                                                phi_3088_ = type_4(1u, _e924.member);
                                                            } else {
                                                                phi_3065_ = _e924;
                                                                phi_3088_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e937 = phi_3065_;
                                                            let _e939 = phi_3088_;
                                                            let _e943 = (bitcast<i32>(_e939.member) != 0i);
                                                            if _e943 {
                                                                let _e944 = (_e918.member_1 < 3u);
                                                                if _e944 {
                                                                } else {
                                                                    phi_4844_ = true;
                                                                    break;
                                                                }
                                                                let _e946 = local_14[_e918.member_1];
                                                                let _e947 = (_e939.member_1 < 3u);
                                                                if _e947 {
                                                                } else {
                                                                    phi_4844_ = true;
                                                                    break;
                                                                }
                                                                let _e949 = local_12[_e939.member_1];
                                                                let _e954 = ((_e946 >> bitcast<u32>(((10u * _e949) & 31u))) & 1023u);
                                                                if _e947 {
                                                                } else {
                                                                    phi_4844_ = true;
                                                                    break;
                                                                }
                                                                let _e956 = local_1[_e939.member_1];
                                                                if _e947 {
                                                                } else {
                                                                    phi_4844_ = true;
                                                                    break;
                                                                }
                                                                let _e958 = local[_e939.member_1];
                                                                let _e969 = (_e956 + bitcast<f32>((bitcast<u32>((f32(_e954) * bitcast<f32>((bitcast<u32>(((_e958 - _e956) * 0.0009775171f)) ^ _e121)))) ^ _e121)));
                                                                if _e944 {
                                                                } else {
                                                                    phi_4844_ = true;
                                                                    break;
                                                                }
                                                                if _e947 {
                                                                } else {
                                                                    phi_4844_ = true;
                                                                    break;
                                                                }
                                                                local_13[_e918.member_1][_e939.member_1] = select(select(_e958, _e969, (_e969 < _e958)), _e958, (_e954 == 1023u));
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_3064_ = _e937;
                                                                phi_4844_ = _e901;
                                                                break if !(_e943);
                                                            }
                                                        }
                                                        let _e978 = phi_4844_;
                                                        phi_4856_ = _e978;
                                                        if _e978 {
                                                            break;
                                                        }
                                                        phi_4857_ = _e978;
                                                    } else {
                                                        phi_4857_ = _e901;
                                                    }
                                                    let _e980 = phi_4857_;
                                                    continue;
                                                    continuing {
                                                        phi_4849_ = _e980;
                                                        phi_3030_ = _e916;
                                                        phi_4856_ = _e980;
                                                        break if !(_e922);
                                                    }
                                                }
                                                let _e983 = phi_4856_;
                                                phi_4858_ = _e983;
                                                if _e983 {
                                                    break;
                                                }
                                                let _e984 = local_13;
                                                let _e1000 = (_e984[0][2] - _e375);
                                                let _e1003 = (((_e984[0][0] - _e298) * _e399) - (_e1000 * _e323));
                                                let _e1006 = (((_e984[0][1] - _e337) * _e399) - (_e1000 * _e361));
                                                let _e1009 = (_e984[1][2] - _e375);
                                                let _e1012 = (((_e984[1][0] - _e298) * _e399) - (_e1009 * _e323));
                                                let _e1015 = (((_e984[1][1] - _e337) * _e399) - (_e1009 * _e361));
                                                let _e1018 = (_e984[2][2] - _e375);
                                                let _e1021 = (((_e984[2][0] - _e298) * _e399) - (_e1018 * _e323));
                                                let _e1024 = (((_e984[2][1] - _e337) * _e399) - (_e1018 * _e361));
                                                let _e1025 = (_e1021 * _e1015);
                                                let _e1026 = (_e1024 * _e1012);
                                                let _e1027 = (_e1003 * _e1024);
                                                let _e1028 = (_e1006 * _e1021);
                                                let _e1029 = (_e1012 * _e1006);
                                                let _e1030 = (_e1015 * _e1003);
                                                let _e1035 = (((_e1025 >= _e1026) && (_e1027 >= _e1028)) && (_e1029 >= _e1030));
                                                if (_e1035 || (((_e1025 <= _e1026) && (_e1027 <= _e1028)) && (_e1029 <= _e1030))) {
                                                    let _e1042 = select(-1f, 1f, _e1035);
                                                    let _e1044 = ((_e1025 - _e1026) * _e1042);
                                                    let _e1046 = select(0f, _e1044, (_e1044 > 0f));
                                                    let _e1048 = ((_e1027 - _e1028) * _e1042);
                                                    let _e1050 = select(0f, _e1048, (_e1048 > 0f));
                                                    let _e1052 = ((_e1029 - _e1030) * _e1042);
                                                    let _e1054 = select(0f, _e1052, (_e1052 > 0f));
                                                    let _e1056 = ((_e1046 + _e1050) + _e1054);
                                                    if (_e1056 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_3746_ = type_18();
                                                        phi_3747_ = true;
                                                    } else {
                                                        let _e1059 = select(_e984[1][0], _e984[0][0], (_e984[0][0] < _e984[1][0]));
                                                        let _e1063 = select(_e984[1][0], _e984[0][0], (_e984[0][0] > _e984[1][0]));
                                                        let _e1067 = select(_e984[1][1], _e984[0][1], (_e984[0][1] < _e984[1][1]));
                                                        let _e1071 = select(_e984[1][1], _e984[0][1], (_e984[0][1] > _e984[1][1]));
                                                        let _e1075 = select(_e984[1][2], _e984[0][2], (_e984[0][2] < _e984[1][2]));
                                                        let _e1079 = select(_e984[1][2], _e984[0][2], (_e984[0][2] > _e984[1][2]));
                                                        let _e1084 = ((select(_e984[2][0], _e1059, (_e1059 < _e984[2][0])) - _e321) * _e326);
                                                        let _e1085 = ((select(_e984[2][0], _e1063, (_e1063 > _e984[2][0])) - _e322) * _e326);
                                                        let _e1088 = ((select(_e984[2][1], _e1067, (_e1067 < _e984[2][1])) - _e359) * _e364);
                                                        let _e1089 = ((select(_e984[2][1], _e1071, (_e1071 > _e984[2][1])) - _e360) * _e364);
                                                        let _e1092 = ((select(_e984[2][2], _e1075, (_e1075 < _e984[2][2])) - _e397) * _e402);
                                                        let _e1093 = ((select(_e984[2][2], _e1079, (_e1079 > _e984[2][2])) - _e398) * _e402);
                                                        let _e1095 = select(_e1093, _e1092, (_e1092 < _e1093));
                                                        let _e1097 = select(_e1093, _e1092, (_e1092 > _e1093));
                                                        let _e1099 = select(_e1085, _e1084, (_e1084 < _e1085));
                                                        let _e1101 = select(_e1089, _e1088, (_e1088 < _e1089));
                                                        let _e1103 = select(_e1101, _e1099, (_e1099 > _e1101));
                                                        let _e1105 = select(_e1095, _e1103, (_e1103 > _e1095));
                                                        let _e1107 = select(_e1085, _e1084, (_e1084 > _e1085));
                                                        let _e1109 = select(_e1089, _e1088, (_e1088 > _e1089));
                                                        let _e1111 = select(_e1109, _e1107, (_e1107 < _e1109));
                                                        let _e1113 = select(_e1097, _e1111, (_e1111 < _e1097));
                                                        let _e1114 = -(_e1095);
                                                        let _e1120 = select(_e449, _e1105, (_e1105 > _e449));
                                                        if (_e1120 > (_e1113 + (select(_e1114, _e1097, (_e1097 > _e1114)) * 0.0000019073523f))) {
                                                            phi_3741_ = type_18();
                                                            phi_3742_ = true;
                                                        } else {
                                                            let _e1122 = (_e1120 > _e848.member_1);
                                                            if _e1122 {
                                                                phi_3740_ = type_18();
                                                            } else {
                                                                let _e1126 = (_e984[1][0] - _e984[0][0]);
                                                                let _e1127 = (_e984[1][1] - _e984[0][1]);
                                                                let _e1128 = (_e984[1][2] - _e984[0][2]);
                                                                let _e1129 = vec3<f32>(_e1126, _e1127, _e1128);
                                                                let _e1130 = (_e984[2][0] - _e984[1][0]);
                                                                let _e1131 = (_e984[2][1] - _e984[1][1]);
                                                                let _e1132 = (_e984[2][2] - _e984[1][2]);
                                                                let _e1133 = vec3<f32>(_e1130, _e1131, _e1132);
                                                                let _e1134 = (_e984[0][0] - _e984[2][0]);
                                                                let _e1135 = (_e984[0][1] - _e984[2][1]);
                                                                let _e1136 = (_e984[0][2] - _e984[2][2]);
                                                                let _e1137 = vec3<f32>(_e1134, _e1135, _e1136);
                                                                let _e1140 = bitcast<f32>((bitcast<u32>(_e1126) & 2147483647u));
                                                                let _e1143 = bitcast<f32>((bitcast<u32>(_e1127) & 2147483647u));
                                                                let _e1145 = select(_e1143, _e1140, (_e1140 > _e1143));
                                                                let _e1148 = bitcast<f32>((bitcast<u32>(_e1128) & 2147483647u));
                                                                let _e1150 = select(_e1148, _e1145, (_e1145 > _e1148));
                                                                let _e1153 = bitcast<f32>((bitcast<u32>(_e1130) & 2147483647u));
                                                                let _e1156 = bitcast<f32>((bitcast<u32>(_e1131) & 2147483647u));
                                                                let _e1158 = select(_e1156, _e1153, (_e1153 > _e1156));
                                                                let _e1161 = bitcast<f32>((bitcast<u32>(_e1132) & 2147483647u));
                                                                let _e1163 = select(_e1161, _e1158, (_e1158 > _e1161));
                                                                let _e1166 = bitcast<f32>((bitcast<u32>(_e1134) & 2147483647u));
                                                                let _e1169 = bitcast<f32>((bitcast<u32>(_e1135) & 2147483647u));
                                                                let _e1171 = select(_e1169, _e1166, (_e1166 > _e1169));
                                                                let _e1174 = bitcast<f32>((bitcast<u32>(_e1136) & 2147483647u));
                                                                let _e1176 = select(_e1174, _e1171, (_e1171 > _e1174));
                                                                let _e1178 = select(_e1163, _e1150, (_e1150 > _e1163));
                                                                let _e1180 = select(_e1176, _e1178, (_e1178 > _e1176));
                                                                if (_e1150 == _e1180) {
                                                                    phi_3651_ = _e1133;
                                                                    phi_3652_ = _e1137;
                                                                } else {
                                                                    let _e1183 = vec3((_e1163 == _e1180));
                                                                    phi_3651_ = select(_e1129, _e1137, _e1183);
                                                                    phi_3652_ = select(_e1133, _e1129, _e1183);
                                                                }
                                                                let _e1187 = phi_3651_;
                                                                let _e1189 = phi_3652_;
                                                                let _e1196 = ((_e1187.y * _e1189.z) - (_e1189.y * _e1187.z));
                                                                let _e1201 = ((_e1187.z * _e1189.x) - (_e1189.z * _e1187.x));
                                                                let _e1204 = ((_e1187.x * _e1189.y) - (_e1189.x * _e1187.y));
                                                                if (_e1046 >= _e1050) {
                                                                    phi_3683_ = select(true, false, (_e1046 >= _e1054));
                                                                } else {
                                                                    phi_3683_ = true;
                                                                }
                                                                let _e1209 = phi_3683_;
                                                                if _e1209 {
                                                                    phi_3692_ = select(vec3<f32>(_e984[2][0], _e984[2][1], _e984[2][2]), vec3<f32>(_e984[1][0], _e984[1][1], _e984[1][2]), vec3((_e1050 >= _e1054)));
                                                                } else {
                                                                    phi_3692_ = vec3<f32>(_e984[0][0], _e984[0][1], _e984[0][2]);
                                                                }
                                                                let _e1214 = phi_3692_;
                                                                let _e1231 = ((((_e1196 * (_e1214.x - _e298)) + (_e1201 * (_e1214.y - _e337))) + (_e1204 * (_e1214.z - _e375))) / (((_e1196 * _e323) + (_e1201 * _e361)) + (_e1204 * _e399)));
                                                                let _e1233 = select(_e1113, _e1231, (_e1231 < _e1113));
                                                                let _e1235 = select(_e1105, _e1233, (_e1233 > _e1105));
                                                                if (_e1235 >= _e449) {
                                                                    let _e1237 = (_e1235 <= _e848.member_1);
                                                                    if _e1237 {
                                                                        let _e1238 = (1f / _e1056);
                                                                        phi_3732_ = type_18(_e1235, (_e1050 * _e1238), (_e1054 * _e1238), _e886);
                                                                    } else {
                                                                        phi_3732_ = type_18();
                                                                    }
                                                                    let _e1243 = phi_3732_;
                                                                    phi_3734_ = _e1243;
                                                                    phi_3735_ = select(true, false, _e1237);
                                                                } else {
                                                                    phi_3734_ = type_18();
                                                                    phi_3735_ = true;
                                                                }
                                                                let _e1246 = phi_3734_;
                                                                let _e1248 = phi_3735_;
                                                                if _e1248 {
                                                                    phi_3739_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_3739_ = _e1246;
                                                                }
                                                                let _e1250 = phi_3739_;
                                                                phi_3740_ = _e1250;
                                                            }
                                                            let _e1252 = phi_3740_;
                                                            phi_3741_ = _e1252;
                                                            phi_3742_ = _e1122;
                                                        }
                                                        let _e1254 = phi_3741_;
                                                        let _e1256 = phi_3742_;
                                                        phi_3746_ = _e1254;
                                                        phi_3747_ = _e1256;
                                                    }
                                                    let _e1258 = phi_3746_;
                                                    let _e1260 = phi_3747_;
                                                    phi_3751_ = _e1258;
                                                    phi_3752_ = _e1260;
                                                } else {
                                                    phi_3751_ = type_18();
                                                    phi_3752_ = true;
                                                }
                                                let _e1262 = phi_3751_;
                                                let _e1264 = phi_3752_;
                                                if _e1264 {
                                                    phi_3756_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_3756_ = _e1262;
                                                }
                                                let _e1266 = phi_3756_;
                                                if (_e1266.member_3 != 4294967295u) {
                                                    if (_e886 != 4294967295u) {
                                                        if (_e1266.member < _e848.member.member) {
                                                            phi_3782_ = true;
                                                        } else {
                                                            if (_e1266.member == _e848.member.member) {
                                                                phi_3781_ = (_e1266.member_3 < _e848.member.member_3);
                                                            } else {
                                                                phi_3781_ = false;
                                                            }
                                                            let _e1279 = phi_3781_;
                                                            phi_3782_ = _e1279;
                                                        }
                                                        let _e1281 = phi_3782_;
                                                        if _e1281 {
                                                            phi_3788_ = type_28(_e1266, _e1266.member);
                                                        } else {
                                                            phi_3788_ = _e848;
                                                        }
                                                        let _e1284 = phi_3788_;
                                                        phi_3789_ = _e1284;
                                                    } else {
                                                        phi_3789_ = _e848;
                                                    }
                                                    let _e1286 = phi_3789_;
                                                    phi_3790_ = _e1286;
                                                } else {
                                                    phi_3790_ = _e848;
                                                }
                                                let _e1288 = phi_3790_;
                                                phi_4859_ = _e983;
                                                phi_2928_ = _e1288;
                                            } else {
                                                phi_4859_ = _e846;
                                                phi_2928_ = type_28();
                                            }
                                            let _e1290 = phi_4859_;
                                            let _e1292 = phi_2928_;
                                            continue;
                                            continuing {
                                                phi_4853_ = _e1290;
                                                phi_2927_ = _e1292;
                                                phi_2930_ = _e863;
                                                phi_4858_ = _e1290;
                                                break if !(_e869);
                                            }
                                        }
                                        let _e1295 = phi_4858_;
                                        phi_4917_ = _e1295;
                                        if _e1295 {
                                            break;
                                        }
                                        phi_4921_ = _e1295;
                                        let _e1483 = local_18;
                                        phi_4634_ = _e1483;
                                        phi_4635_ = _e520;
                                        phi_4636_ = false;
                                        phi_4637_ = _e524;
                                    } else {
                                        local_3 = array<f32, 3>(_e520.member.member[0], _e520.member.member[1], _e520.member.member[2]);
                                        local_2 = array<f32, 3>(_e520.member.member_1[0], _e520.member.member_1[1], _e520.member.member_1[2]);
                                        let _e544 = (_e520.member_1 < _e86);
                                        if _e544 {
                                            if _e544 {
                                            } else {
                                                phi_4917_ = true;
                                                break;
                                            }
                                            let _e546 = global_4.member[_e520.member_1];
                                            phi_3824_ = _e546;
                                        } else {
                                            phi_3824_ = type_36(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e548 = phi_3824_;
                                        let _e550 = array<u32, 3>(_e249, _e248, _e250);
                                        local_11 = _e550;
                                        local_7 = array<f32, 3>(0f, 0f, 0f);
                                        local_6 = array<f32, 3>(0f, 0f, 0f);
                                        phi_3833_ = type_4(0u, 3u);
                                        loop {
                                            let _e552 = phi_3833_;
                                            if (_e552.member < _e552.member_1) {
                                                phi_3834_ = type_4((_e552.member + 1u), _e552.member_1);
                                                phi_3857_ = type_4(1u, _e552.member);
                                            } else {
                                                phi_3834_ = _e552;
                                                phi_3857_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e565 = phi_3834_;
                                            let _e567 = phi_3857_;
                                            let _e571 = (bitcast<i32>(_e567.member) != 0i);
                                            if _e571 {
                                                let _e572 = (_e567.member_1 < 3u);
                                                if _e572 {
                                                } else {
                                                    phi_4776_ = true;
                                                    break;
                                                }
                                                let _e574 = local_11[_e567.member_1];
                                                if _e572 {
                                                } else {
                                                    phi_4776_ = true;
                                                    break;
                                                }
                                                let _e576 = local_3[_e567.member_1];
                                                if _e572 {
                                                } else {
                                                    phi_4776_ = true;
                                                    break;
                                                }
                                                let _e578 = local_2[_e567.member_1];
                                                let _e581 = ((10u * _e574) & 31u);
                                                let _e584 = ((_e548.member[0] >> bitcast<u32>(_e581)) & 1023u);
                                                let _e589 = bitcast<f32>((bitcast<u32>(((_e578 - _e576) * 0.0009775171f)) ^ _e121));
                                                let _e595 = (_e576 + bitcast<f32>((bitcast<u32>((f32(_e584) * _e589)) ^ _e121)));
                                                if _e572 {
                                                } else {
                                                    phi_4776_ = true;
                                                    break;
                                                }
                                                local_7[_e567.member_1] = select(select(_e578, _e595, (_e595 < _e578)), _e578, (_e584 == 1023u));
                                                let _e604 = ((_e548.member[1] >> bitcast<u32>(_e581)) & 1023u);
                                                let _e610 = (_e576 + bitcast<f32>((bitcast<u32>((f32(_e604) * _e589)) ^ _e121)));
                                                if _e572 {
                                                } else {
                                                    phi_4776_ = true;
                                                    break;
                                                }
                                                local_6[_e567.member_1] = select(select(_e578, _e610, (_e610 < _e578)), _e578, (_e604 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_3833_ = _e565;
                                                phi_4776_ = _e481;
                                                break if !(_e571);
                                            }
                                        }
                                        let _e618 = phi_4776_;
                                        phi_4917_ = _e618;
                                        if _e618 {
                                            break;
                                        }
                                        let _e619 = local_6;
                                        let _e620 = local_7;
                                        local_10 = _e550;
                                        local_9 = array<f32, 3>(0f, 0f, 0f);
                                        local_8 = array<f32, 3>(0f, 0f, 0f);
                                        phi_3987_ = type_4(0u, 3u);
                                        loop {
                                            let _e629 = phi_3987_;
                                            if (_e629.member < _e629.member_1) {
                                                phi_3988_ = type_4((_e629.member + 1u), _e629.member_1);
                                                phi_4011_ = type_4(1u, _e629.member);
                                            } else {
                                                phi_3988_ = _e629;
                                                phi_4011_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e642 = phi_3988_;
                                            let _e644 = phi_4011_;
                                            let _e648 = (bitcast<i32>(_e644.member) != 0i);
                                            if _e648 {
                                                let _e649 = (_e644.member_1 < 3u);
                                                if _e649 {
                                                } else {
                                                    phi_4836_ = true;
                                                    break;
                                                }
                                                let _e651 = local_10[_e644.member_1];
                                                if _e649 {
                                                } else {
                                                    phi_4836_ = true;
                                                    break;
                                                }
                                                let _e653 = local_3[_e644.member_1];
                                                if _e649 {
                                                } else {
                                                    phi_4836_ = true;
                                                    break;
                                                }
                                                let _e655 = local_2[_e644.member_1];
                                                let _e658 = ((10u * _e651) & 31u);
                                                let _e661 = ((_e548.member_1[0] >> bitcast<u32>(_e658)) & 1023u);
                                                let _e666 = bitcast<f32>((bitcast<u32>(((_e655 - _e653) * 0.0009775171f)) ^ _e121));
                                                let _e672 = (_e653 + bitcast<f32>((bitcast<u32>((f32(_e661) * _e666)) ^ _e121)));
                                                if _e649 {
                                                } else {
                                                    phi_4836_ = true;
                                                    break;
                                                }
                                                local_9[_e644.member_1] = select(select(_e655, _e672, (_e672 < _e655)), _e655, (_e661 == 1023u));
                                                let _e681 = ((_e548.member_1[1] >> bitcast<u32>(_e658)) & 1023u);
                                                let _e687 = (_e653 + bitcast<f32>((bitcast<u32>((f32(_e681) * _e666)) ^ _e121)));
                                                if _e649 {
                                                } else {
                                                    phi_4836_ = true;
                                                    break;
                                                }
                                                local_8[_e644.member_1] = select(select(_e655, _e687, (_e687 < _e655)), _e655, (_e681 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_3987_ = _e642;
                                                phi_4836_ = _e618;
                                                break if !(_e648);
                                            }
                                        }
                                        let _e695 = phi_4836_;
                                        phi_4917_ = _e695;
                                        if _e695 {
                                            break;
                                        }
                                        let _e696 = local_8;
                                        let _e697 = local_9;
                                        let _e708 = type_50(type_41(array<f32, 3>(_e620[0], _e620[1], _e620[2]), array<f32, 3>(_e619[0], _e619[1], _e619[2])), _e548.member_2);
                                        let _e713 = type_50(type_41(array<f32, 3>(_e697[0], _e697[1], _e697[2]), array<f32, 3>(_e696[0], _e696[1], _e696[2])), _e548.member_3);
                                        let _e719 = ((_e620[0] - _e321) * _e326);
                                        let _e720 = ((_e697[0] - _e321) * _e326);
                                        let _e721 = ((_e619[0] - _e322) * _e326);
                                        let _e722 = ((_e696[0] - _e322) * _e326);
                                        let _e727 = ((_e620[1] - _e359) * _e364);
                                        let _e728 = ((_e697[1] - _e359) * _e364);
                                        let _e729 = ((_e619[1] - _e360) * _e364);
                                        let _e730 = ((_e696[1] - _e360) * _e364);
                                        let _e735 = ((_e620[2] - _e397) * _e402);
                                        let _e736 = ((_e697[2] - _e397) * _e402);
                                        let _e737 = ((_e619[2] - _e398) * _e402);
                                        let _e738 = ((_e696[2] - _e398) * _e402);
                                        let _e740 = select(_e737, _e735, (_e735 < _e737));
                                        let _e742 = select(_e738, _e736, (_e736 < _e738));
                                        let _e744 = select(_e737, _e735, (_e735 > _e737));
                                        let _e746 = select(_e738, _e736, (_e736 > _e738));
                                        let _e748 = select(_e721, _e719, (_e719 < _e721));
                                        let _e750 = select(_e722, _e720, (_e720 < _e722));
                                        let _e752 = select(_e729, _e727, (_e727 < _e729));
                                        let _e754 = select(_e730, _e728, (_e728 < _e730));
                                        let _e756 = select(_e752, _e748, (_e748 > _e752));
                                        let _e758 = select(_e754, _e750, (_e750 > _e754));
                                        let _e760 = select(_e740, _e756, (_e756 > _e740));
                                        let _e762 = select(_e742, _e758, (_e758 > _e742));
                                        let _e764 = select(_e721, _e719, (_e719 > _e721));
                                        let _e766 = select(_e722, _e720, (_e720 > _e722));
                                        let _e768 = select(_e729, _e727, (_e727 > _e729));
                                        let _e770 = select(_e730, _e728, (_e728 > _e730));
                                        let _e772 = select(_e768, _e764, (_e764 < _e768));
                                        let _e774 = select(_e770, _e766, (_e766 < _e770));
                                        let _e779 = -(_e740);
                                        let _e780 = -(_e742);
                                        let _e787 = (select(_e744, _e772, (_e772 < _e744)) + (select(_e779, _e744, (_e744 > _e779)) * 0.0000019073523f));
                                        let _e788 = (select(_e746, _e774, (_e774 < _e746)) + (select(_e780, _e746, (_e746 > _e780)) * 0.0000019073523f));
                                        let _e790 = select(_e449, _e760, (_e760 > _e449));
                                        let _e792 = select(_e449, _e762, (_e762 > _e449));
                                        let _e797 = (_e790 <= select(_e483.member_1, _e787, (_e787 < _e483.member_1)));
                                        let _e798 = (_e792 <= select(_e483.member_1, _e788, (_e788 < _e483.member_1)));
                                        let _e799 = (_e790 <= _e792);
                                        if _e797 {
                                            if _e798 {
                                                if _e799 {
                                                    phi_4574_ = _e713;
                                                } else {
                                                    phi_4574_ = _e708;
                                                }
                                                let _e801 = phi_4574_;
                                                let _e802 = (_e524 % 128u);
                                                let _e803 = (_e802 < 128u);
                                                if _e803 {
                                                } else {
                                                    phi_4917_ = true;
                                                    break;
                                                }
                                                local_5[_e802] = type_50(type_41(array<f32, 3>(_e801.member.member[0], _e801.member.member[1], _e801.member.member[2]), array<f32, 3>(_e801.member.member_1[0], _e801.member.member_1[1], _e801.member.member_1[2])), _e801.member_1);
                                                if _e803 {
                                                } else {
                                                    phi_4917_ = true;
                                                    break;
                                                }
                                                local_4[_e802] = select(_e792, _e790, (_e790 > _e792));
                                                if _e799 {
                                                    phi_4613_ = _e708;
                                                } else {
                                                    phi_4613_ = _e713;
                                                }
                                                let _e824 = phi_4613_;
                                                phi_4614_ = _e824;
                                                phi_4615_ = (_e524 + 1u);
                                            } else {
                                                phi_4614_ = type_50();
                                                phi_4615_ = u32();
                                            }
                                            let _e826 = phi_4614_;
                                            let _e828 = phi_4615_;
                                            phi_4617_ = _e826;
                                            phi_4618_ = _e828;
                                            phi_4619_ = select(true, false, _e798);
                                        } else {
                                            phi_4617_ = type_50();
                                            phi_4618_ = u32();
                                            phi_4619_ = true;
                                        }
                                        let _e831 = phi_4617_;
                                        let _e833 = phi_4618_;
                                        let _e835 = phi_4619_;
                                        if _e835 {
                                            if _e797 {
                                                phi_4626_ = _e708;
                                            } else {
                                                phi_4626_ = _e713;
                                            }
                                            let _e837 = phi_4626_;
                                            phi_4631_ = _e837;
                                            phi_4632_ = select(_e798, true, _e797);
                                        } else {
                                            phi_4631_ = _e831;
                                            phi_4632_ = _e522;
                                        }
                                        let _e840 = phi_4631_;
                                        let _e842 = phi_4632_;
                                        phi_4921_ = _e695;
                                        phi_4634_ = _e483;
                                        phi_4635_ = _e840;
                                        phi_4636_ = _e842;
                                        phi_4637_ = select(_e833, _e524, _e835);
                                    }
                                    let _e1297 = phi_4921_;
                                    let _e1299 = phi_4634_;
                                    let _e1301 = phi_4635_;
                                    let _e1303 = phi_4636_;
                                    let _e1305 = phi_4637_;
                                    phi_4920_ = _e1297;
                                    phi_4638_ = _e1299;
                                    phi_4639_ = _e1301;
                                    phi_4640_ = (_e487 - 1u);
                                    phi_4641_ = _e1303;
                                    phi_4642_ = _e1305;
                                } else {
                                    phi_4920_ = _e481;
                                    phi_4638_ = _e483;
                                    phi_4639_ = _e520;
                                    phi_4640_ = _e487;
                                    phi_4641_ = _e522;
                                    phi_4642_ = _e524;
                                }
                                let _e1307 = phi_4920_;
                                let _e1309 = phi_4638_;
                                let _e1311 = phi_4639_;
                                let _e1313 = phi_4640_;
                                let _e1315 = phi_4641_;
                                let _e1317 = phi_4642_;
                                phi_4919_ = _e1307;
                                phi_4643_ = _e1309;
                                phi_4644_ = _e1311;
                                phi_4645_ = _e1313;
                                phi_4646_ = _e1315;
                                phi_4647_ = _e1317;
                            } else {
                                phi_4919_ = _e481;
                                phi_4643_ = type_28();
                                phi_4644_ = type_50();
                                phi_4645_ = u32();
                                phi_4646_ = bool();
                                phi_4647_ = u32();
                            }
                            let _e1319 = phi_4919_;
                            let _e1321 = phi_4643_;
                            let _e1323 = phi_4644_;
                            let _e1325 = phi_4645_;
                            let _e1327 = phi_4646_;
                            let _e1329 = phi_4647_;
                            phi_4918_ = _e1319;
                            phi_2842_ = _e1321;
                            phi_2845_ = _e1323;
                            phi_2847_ = _e1325;
                            phi_2849_ = _e1327;
                            phi_2851_ = _e1329;
                            phi_4648_ = _e495;
                        } else {
                            phi_4918_ = _e481;
                            phi_2842_ = type_28();
                            phi_2845_ = type_50();
                            phi_2847_ = u32();
                            phi_2849_ = bool();
                            phi_2851_ = u32();
                            phi_4648_ = false;
                        }
                        let _e1331 = phi_4918_;
                        let _e1333 = phi_2842_;
                        let _e1335 = phi_2845_;
                        let _e1337 = phi_2847_;
                        let _e1339 = phi_2849_;
                        let _e1341 = phi_2851_;
                        let _e1343 = phi_4648_;
                        continue;
                        continuing {
                            phi_4783_ = _e1331;
                            phi_2841_ = _e1333;
                            phi_2844_ = _e1335;
                            phi_2846_ = _e1337;
                            phi_2848_ = _e1339;
                            phi_2850_ = _e1341;
                            phi_4917_ = _e1331;
                            break if !(_e1343);
                        }
                    }
                    let _e1346 = phi_4917_;
                    if _e1346 {
                        break;
                    }
                    let _e1348 = local_17;
                    if (_e1348.member.member_3 != 4294967295u) {
                        let _e1353 = -(_e416);
                        let _e1354 = (_e1353 / 3i);
                        let _e1361 = bitcast<f32>((bitcast<u32>((_e1354 + 127i)) << bitcast<u32>(23i)));
                        let _e1369 = (((_e1348.member.member * _e1361) * _e1361) * bitcast<f32>((bitcast<u32>(((_e1353 - (2i * _e1354)) + 127i)) << bitcast<u32>(23i))));
                        let _e1371 = select(340282350000000000000000000000000000000f, _e1369, (_e1369 < 340282350000000000000000000000000000000f));
                        phi_4700_ = type_18(select(-340282350000000000000000000000000000000f, _e1371, (_e1371 > -340282350000000000000000000000000000000f)), _e1348.member.member_1, _e1348.member.member_2, _e1348.member.member_3);
                    } else {
                        phi_4700_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1378 = phi_4700_;
                    if _e137 {
                    } else {
                        break;
                    }
                    global_5.member[_e135] = _e1378;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_closest_printed_leaf10_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
