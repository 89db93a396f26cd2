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

struct type_27 {
    member: type_21,
    member_1: f32,
}

struct type_30 {
    member: array<type_22>,
}

struct type_32 {
    member: type_27,
    member_1: u32,
    member_2: u32,
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
var<storage> global_3: type_30;
@group(0) @binding(2) 
var<storage> global_4: type_38;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_17;
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
    var phi_4748_: bool;
    var phi_2843_: type_32;
    var phi_2846_: type_50;
    var phi_2848_: u32;
    var phi_2850_: bool;
    var phi_2852_: u32;
    var phi_2863_: bool;
    var phi_2908_: type_50;
    var phi_2909_: bool;
    var phi_2910_: u32;
    var phi_3833_: type_36;
    var phi_3842_: type_4;
    var phi_3843_: type_4;
    var phi_3866_: type_4;
    var phi_4741_: bool;
    var phi_3996_: type_4;
    var phi_3997_: type_4;
    var phi_4020_: type_4;
    var phi_4801_: bool;
    var phi_4583_: type_50;
    var phi_4622_: type_50;
    var phi_4623_: type_50;
    var phi_4624_: u32;
    var phi_4626_: type_50;
    var phi_4627_: u32;
    var phi_4628_: bool;
    var phi_4635_: type_50;
    var phi_4640_: type_50;
    var phi_4641_: bool;
    var phi_4818_: bool;
    var phi_2929_: type_32;
    var phi_2932_: type_4;
    var phi_2933_: type_4;
    var phi_2955_: type_4;
    var phi_3000_: u32;
    var phi_3024_: type_44;
    var phi_4814_: bool;
    var phi_3035_: type_4;
    var phi_3036_: type_4;
    var phi_3059_: type_4;
    var phi_3069_: type_4;
    var phi_3070_: type_4;
    var phi_3093_: type_4;
    var phi_4809_: bool;
    var phi_4822_: bool;
    var phi_4821_: bool;
    var phi_3656_: vec3<f32>;
    var phi_3657_: vec3<f32>;
    var phi_3688_: bool;
    var phi_3697_: vec3<f32>;
    var phi_3737_: type_21;
    var phi_3739_: type_21;
    var phi_3740_: bool;
    var phi_3744_: type_21;
    var phi_3745_: type_21;
    var phi_3746_: type_21;
    var phi_3747_: bool;
    var phi_3751_: type_21;
    var phi_3752_: bool;
    var phi_3756_: type_21;
    var phi_3757_: bool;
    var phi_3761_: type_21;
    var phi_3786_: bool;
    var phi_3787_: bool;
    var phi_3794_: type_32;
    var phi_3795_: type_32;
    var phi_3796_: type_32;
    var phi_4824_: bool;
    var phi_2930_: type_32;
    var phi_4823_: bool;
    var phi_4886_: bool;
    var phi_4643_: type_32;
    var phi_4644_: type_50;
    var phi_4645_: bool;
    var phi_4646_: u32;
    var phi_4885_: bool;
    var phi_4647_: type_32;
    var phi_4648_: type_50;
    var phi_4649_: u32;
    var phi_4650_: bool;
    var phi_4651_: u32;
    var phi_4884_: bool;
    var phi_4652_: type_32;
    var phi_4653_: type_50;
    var phi_4654_: u32;
    var phi_4655_: bool;
    var phi_4656_: u32;
    var phi_4883_: bool;
    var phi_2844_: type_32;
    var phi_2847_: type_50;
    var phi_2849_: u32;
    var phi_2851_: bool;
    var phi_2853_: u32;
    var phi_4657_: bool;
    var phi_4882_: bool;
    var local_17: type_32;
    var local_18: type_32;
    var local_19: type_32;

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
                            phi_344_ = (bitcast<i32>((_e214 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_344_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e214)), 32u, (_e214 == 0u))));
                        }
                        let _e228 = phi_344_;
                        phi_345_ = _e228;
                    } else {
                        phi_345_ = 0i;
                    }
                    let _e230 = phi_345_;
                    let _e231 = (_e147 == _e186);
                    if _e231 {
                        phi_355_ = true;
                    } else {
                        phi_355_ = (_e154 == _e186);
                    }
                    let _e234 = phi_355_;
                    let _e235 = select(1u, 0u, _e231);
                    if _e234 {
                        let _e236 = (_e235 + 1u);
                        phi_365_ = _e236;
                        phi_366_ = _e236;
                        phi_368_ = select(true, false, (_e236 == 2u));
                    } else {
                        phi_365_ = u32();
                        phi_366_ = 0u;
                        phi_368_ = true;
                    }
                    let _e240 = phi_365_;
                    let _e242 = phi_366_;
                    let _e244 = phi_368_;
                    if _e244 {
                        phi_373_ = (_e242 + 1u);
                    } else {
                        phi_373_ = 0u;
                    }
                    let _e248 = phi_373_;
                    let _e249 = select(_e240, _e242, _e244);
                    let _e250 = select(_e235, select(2u, _e235, _e234), _e244);
                    if (_e125 < -126i) {
                        phi_386_ = -126i;
                    } else {
                        phi_386_ = select(_e125, 127i, (_e125 > 127i));
                    }
                    let _e255 = phi_386_;
                    let _e260 = bitcast<f32>((bitcast<u32>((_e255 + 127i)) << bitcast<u32>(23i)));
                    let _e266 = bitcast<f32>((bitcast<u32>(((_e125 - _e255) + 127i)) << bitcast<u32>(23i)));
                    let _e267 = -(_e230);
                    if (_e267 < -126i) {
                        phi_406_ = -126i;
                    } else {
                        phi_406_ = select(_e267, 127i, (_e267 > 127i));
                    }
                    let _e272 = phi_406_;
                    let _e277 = bitcast<f32>((bitcast<u32>((_e272 + 127i)) << bitcast<u32>(23i)));
                    let _e283 = bitcast<f32>((bitcast<u32>(((_e267 - _e272) + 127i)) << bitcast<u32>(23i)));
                    let _e287 = global_3.member[_e135].member;
                    let _e288 = (_e249 == 0u);
                    if _e288 {
                        phi_424_ = _e287[0];
                    } else {
                        phi_424_ = _e287[1];
                    }
                    let _e292 = phi_424_;
                    let _e293 = (_e249 == 2u);
                    if _e293 {
                        phi_430_ = _e287[2];
                    } else {
                        phi_430_ = _e292;
                    }
                    let _e296 = phi_430_;
                    let _e298 = ((_e296 * _e260) * _e266);
                    let _e299 = global_3.member[_e135].member_2;
                    if _e288 {
                        phi_441_ = _e299[0];
                    } else {
                        phi_441_ = _e299[1];
                    }
                    let _e303 = phi_441_;
                    if _e293 {
                        phi_447_ = _e299[2];
                    } else {
                        phi_447_ = _e303;
                    }
                    let _e306 = phi_447_;
                    let _e308 = ((_e306 * _e277) * _e283);
                    let _e312 = (bitcast<f32>((bitcast<u32>(_e308) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e312 {
                        let _e316 = (bitcast<f32>((bitcast<u32>(_e298) & 2147483647u)) * 0.00000011920929f);
                        phi_470_ = select(0.00000000000011368684f, _e316, (_e316 > 0.00000000000011368684f));
                    } else {
                        phi_470_ = 0f;
                    }
                    let _e320 = phi_470_;
                    let _e321 = (_e298 + _e320);
                    let _e322 = (_e298 - _e320);
                    let _e323 = select(_e308, 0f, _e312);
                    if _e312 {
                        phi_481_ = 38685626000000000000000000f;
                    } else {
                        phi_481_ = (1f / _e308);
                    }
                    let _e326 = phi_481_;
                    let _e327 = (_e248 == 0u);
                    if _e327 {
                        phi_490_ = _e287[0];
                    } else {
                        phi_490_ = _e287[1];
                    }
                    let _e331 = phi_490_;
                    let _e332 = (_e248 == 2u);
                    if _e332 {
                        phi_496_ = _e287[2];
                    } else {
                        phi_496_ = _e331;
                    }
                    let _e335 = phi_496_;
                    let _e337 = ((_e335 * _e260) * _e266);
                    if _e327 {
                        phi_507_ = _e299[0];
                    } else {
                        phi_507_ = _e299[1];
                    }
                    let _e341 = phi_507_;
                    if _e332 {
                        phi_513_ = _e299[2];
                    } else {
                        phi_513_ = _e341;
                    }
                    let _e344 = phi_513_;
                    let _e346 = ((_e344 * _e277) * _e283);
                    let _e350 = (bitcast<f32>((bitcast<u32>(_e346) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e350 {
                        let _e354 = (bitcast<f32>((bitcast<u32>(_e337) & 2147483647u)) * 0.00000011920929f);
                        phi_536_ = select(0.00000000000011368684f, _e354, (_e354 > 0.00000000000011368684f));
                    } else {
                        phi_536_ = 0f;
                    }
                    let _e358 = phi_536_;
                    let _e359 = (_e337 + _e358);
                    let _e360 = (_e337 - _e358);
                    let _e361 = select(_e346, 0f, _e350);
                    if _e350 {
                        phi_547_ = 38685626000000000000000000f;
                    } else {
                        phi_547_ = (1f / _e346);
                    }
                    let _e364 = phi_547_;
                    let _e365 = (_e250 == 0u);
                    if _e365 {
                        phi_556_ = _e287[0];
                    } else {
                        phi_556_ = _e287[1];
                    }
                    let _e369 = phi_556_;
                    let _e370 = (_e250 == 2u);
                    if _e370 {
                        phi_562_ = _e287[2];
                    } else {
                        phi_562_ = _e369;
                    }
                    let _e373 = phi_562_;
                    let _e375 = ((_e373 * _e260) * _e266);
                    if _e365 {
                        phi_573_ = _e299[0];
                    } else {
                        phi_573_ = _e299[1];
                    }
                    let _e379 = phi_573_;
                    if _e370 {
                        phi_579_ = _e299[2];
                    } else {
                        phi_579_ = _e379;
                    }
                    let _e382 = phi_579_;
                    let _e384 = ((_e382 * _e277) * _e283);
                    let _e388 = (bitcast<f32>((bitcast<u32>(_e384) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e388 {
                        let _e392 = (bitcast<f32>((bitcast<u32>(_e375) & 2147483647u)) * 0.00000011920929f);
                        phi_602_ = select(0.00000000000011368684f, _e392, (_e392 > 0.00000000000011368684f));
                    } else {
                        phi_602_ = 0f;
                    }
                    let _e396 = phi_602_;
                    let _e397 = (_e375 + _e396);
                    let _e398 = (_e375 - _e396);
                    let _e399 = select(_e384, 0f, _e388);
                    if _e388 {
                        phi_613_ = 38685626000000000000000000f;
                    } else {
                        phi_613_ = (1f / _e384);
                    }
                    let _e402 = phi_613_;
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
                        phi_713_ = select(-340282350000000000000000000000000000000f, _e443, (_e443 > -340282350000000000000000000000000000000f));
                        phi_714_ = select(-340282350000000000000000000000000000000f, _e436, (_e436 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_713_ = 0f;
                        phi_714_ = 1f;
                    }
                    let _e447 = phi_713_;
                    let _e449 = phi_714_;
                    local_5 = array<type_50, 128>(type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_41(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u));
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_16 = array<f32, 3>(bitcast<f32>(_e97), bitcast<f32>(_e101), bitcast<f32>(_e105));
                    let _e455 = (_e249 % 3u);
                    let _e456 = (_e455 < 3u);
                    if _e456 {
                    } else {
                        break;
                    }
                    let _e458 = local_16[_e455];
                    let _e459 = (_e248 % 3u);
                    let _e460 = (_e459 < 3u);
                    if _e460 {
                    } else {
                        break;
                    }
                    let _e462 = local_16[_e459];
                    let _e463 = (_e250 % 3u);
                    let _e464 = (_e463 < 3u);
                    if _e464 {
                    } else {
                        break;
                    }
                    let _e466 = local_16[_e463];
                    local_15 = array<f32, 3>(bitcast<f32>(_e109), bitcast<f32>(_e113), bitcast<f32>(_e117));
                    if _e456 {
                    } else {
                        break;
                    }
                    let _e470 = local_15[_e455];
                    if _e460 {
                    } else {
                        break;
                    }
                    let _e472 = local_15[_e459];
                    if _e464 {
                    } else {
                        break;
                    }
                    let _e474 = local_15[_e463];
                    phi_4748_ = false;
                    phi_2843_ = type_32(type_27(type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e447), 0u, 0u);
                    phi_2846_ = type_50(type_41(array<f32, 3>(_e458, _e462, _e466), array<f32, 3>(_e470, _e472, _e474)), select(0u, 2147483648u, (_e86 == 0u)));
                    phi_2848_ = ((3u * _e86) + 1u);
                    phi_2850_ = (_e449 <= _e447);
                    phi_2852_ = 0u;
                    loop {
                        let _e482 = phi_4748_;
                        let _e484 = phi_2843_;
                        let _e486 = phi_2846_;
                        let _e488 = phi_2848_;
                        let _e490 = phi_2850_;
                        let _e492 = phi_2852_;
                        local_17 = _e484;
                        local_18 = _e484;
                        if _e490 {
                            phi_2863_ = true;
                        } else {
                            phi_2863_ = (_e492 > 0u);
                        }
                        let _e495 = phi_2863_;
                        if _e495 {
                            let _e496 = (_e488 > 0u);
                            if _e496 {
                                if _e490 {
                                    phi_2908_ = _e486;
                                    phi_2909_ = _e490;
                                    phi_2910_ = _e492;
                                } else {
                                    let _e497 = (_e492 - 1u);
                                    let _e498 = (_e497 % 128u);
                                    let _e499 = (_e498 < 128u);
                                    if _e499 {
                                    } else {
                                        phi_4882_ = true;
                                        break;
                                    }
                                    let _e501 = local_5[_e498];
                                    if _e499 {
                                    } else {
                                        phi_4882_ = true;
                                        break;
                                    }
                                    let _e517 = local_4[_e498];
                                    phi_2908_ = type_50(type_41(array<f32, 3>(_e501.member.member[0], _e501.member.member[1], _e501.member.member[2]), array<f32, 3>(_e501.member.member_1[0], _e501.member.member_1[1], _e501.member.member_1[2])), _e501.member_1);
                                    phi_2909_ = (_e517 <= _e484.member.member_1);
                                    phi_2910_ = _e497;
                                }
                                let _e522 = phi_2908_;
                                let _e524 = phi_2909_;
                                let _e526 = phi_2910_;
                                if _e524 {
                                    if ((_e522.member_1 & 2147483648u) != 0u) {
                                        phi_4818_ = _e482;
                                        phi_2929_ = _e484;
                                        phi_2932_ = type_4(0u, ((_e522.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e855 = phi_4818_;
                                            let _e857 = phi_2929_;
                                            let _e859 = phi_2932_;
                                            local_19 = _e857;
                                            if (_e859.member < _e859.member_1) {
                                                phi_2933_ = type_4((_e859.member + 1u), _e859.member_1);
                                                phi_2955_ = type_4(1u, _e859.member);
                                            } else {
                                                phi_2933_ = _e859;
                                                phi_2955_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e872 = phi_2933_;
                                            let _e874 = phi_2955_;
                                            let _e878 = (bitcast<i32>(_e874.member) != 0i);
                                            if _e878 {
                                                let _e884 = type_32(_e857.member, _e857.member_1, (_e857.member_2 + 1u));
                                                local_1 = array<f32, 3>(_e522.member.member[0], _e522.member.member[1], _e522.member.member[2]);
                                                local = array<f32, 3>(_e522.member.member_1[0], _e522.member.member_1[1], _e522.member.member_1[2]);
                                                let _e895 = ((_e522.member_1 & 268435455u) + _e874.member_1);
                                                let _e896 = (_e895 < arrayLength((&global_6.member)));
                                                if _e896 {
                                                    if _e896 {
                                                    } else {
                                                        phi_4823_ = true;
                                                        break;
                                                    }
                                                    let _e899 = global_6.member[_e895].member_1;
                                                    phi_3000_ = _e899;
                                                } else {
                                                    phi_3000_ = 4294967295u;
                                                }
                                                let _e901 = phi_3000_;
                                                local_12 = array<u32, 3>(_e249, _e248, _e250);
                                                if _e896 {
                                                    if _e896 {
                                                    } else {
                                                        phi_4823_ = true;
                                                        break;
                                                    }
                                                    let _e904 = global_6.member[_e895];
                                                    phi_3024_ = _e904;
                                                } else {
                                                    phi_3024_ = type_44(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e906 = phi_3024_;
                                                local_14 = array<u32, 3>(_e906.member[0], _e906.member[1], _e906.member[2]);
                                                local_13[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_13[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_13[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_4814_ = _e855;
                                                phi_3035_ = type_4(0u, 3u);
                                                loop {
                                                    let _e916 = phi_4814_;
                                                    let _e918 = phi_3035_;
                                                    if (_e918.member < _e918.member_1) {
                                                        phi_3036_ = type_4((_e918.member + 1u), _e918.member_1);
                                                        phi_3059_ = type_4(1u, _e918.member);
                                                    } else {
                                                        phi_3036_ = _e918;
                                                        phi_3059_ = type_4(0u, type_4().member_1);
                                                    }
                                                    let _e931 = phi_3036_;
                                                    let _e933 = phi_3059_;
                                                    let _e937 = (bitcast<i32>(_e933.member) != 0i);
                                                    if _e937 {
                                                        phi_3069_ = type_4(0u, 3u);
                                                        loop {
                                                            let _e939 = phi_3069_;
                                                            if (_e939.member < _e939.member_1) {
                                                                phi_3070_ = type_4((_e939.member + 1u), _e939.member_1);
                                                                phi_3093_ = type_4(1u, _e939.member);
                                                            } else {
                                                                phi_3070_ = _e939;
                                                                phi_3093_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e952 = phi_3070_;
                                                            let _e954 = phi_3093_;
                                                            let _e958 = (bitcast<i32>(_e954.member) != 0i);
                                                            if _e958 {
                                                                let _e959 = (_e933.member_1 < 3u);
                                                                if _e959 {
                                                                } else {
                                                                    phi_4809_ = true;
                                                                    break;
                                                                }
                                                                let _e961 = local_14[_e933.member_1];
                                                                let _e962 = (_e954.member_1 < 3u);
                                                                if _e962 {
                                                                } else {
                                                                    phi_4809_ = true;
                                                                    break;
                                                                }
                                                                let _e964 = local_12[_e954.member_1];
                                                                let _e969 = ((_e961 >> bitcast<u32>(((10u * _e964) & 31u))) & 1023u);
                                                                if _e962 {
                                                                } else {
                                                                    phi_4809_ = true;
                                                                    break;
                                                                }
                                                                let _e971 = local_1[_e954.member_1];
                                                                if _e962 {
                                                                } else {
                                                                    phi_4809_ = true;
                                                                    break;
                                                                }
                                                                let _e973 = local[_e954.member_1];
                                                                let _e984 = (_e971 + bitcast<f32>((bitcast<u32>((f32(_e969) * bitcast<f32>((bitcast<u32>(((_e973 - _e971) * 0.0009775171f)) ^ _e121)))) ^ _e121)));
                                                                if _e959 {
                                                                } else {
                                                                    phi_4809_ = true;
                                                                    break;
                                                                }
                                                                if _e962 {
                                                                } else {
                                                                    phi_4809_ = true;
                                                                    break;
                                                                }
                                                                local_13[_e933.member_1][_e954.member_1] = select(select(_e973, _e984, (_e984 < _e973)), _e973, (_e969 == 1023u));
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_3069_ = _e952;
                                                                phi_4809_ = _e916;
                                                                break if !(_e958);
                                                            }
                                                        }
                                                        let _e993 = phi_4809_;
                                                        phi_4821_ = _e993;
                                                        if _e993 {
                                                            break;
                                                        }
                                                        phi_4822_ = _e993;
                                                    } else {
                                                        phi_4822_ = _e916;
                                                    }
                                                    let _e995 = phi_4822_;
                                                    continue;
                                                    continuing {
                                                        phi_4814_ = _e995;
                                                        phi_3035_ = _e931;
                                                        phi_4821_ = _e995;
                                                        break if !(_e937);
                                                    }
                                                }
                                                let _e998 = phi_4821_;
                                                phi_4823_ = _e998;
                                                if _e998 {
                                                    break;
                                                }
                                                let _e999 = local_13;
                                                let _e1016 = (_e999[0][2] - _e375);
                                                let _e1019 = (((_e999[0][0] - _e298) * _e399) - (_e1016 * _e323));
                                                let _e1022 = (((_e999[0][1] - _e337) * _e399) - (_e1016 * _e361));
                                                let _e1025 = (_e999[1][2] - _e375);
                                                let _e1028 = (((_e999[1][0] - _e298) * _e399) - (_e1025 * _e323));
                                                let _e1031 = (((_e999[1][1] - _e337) * _e399) - (_e1025 * _e361));
                                                let _e1034 = (_e999[2][2] - _e375);
                                                let _e1037 = (((_e999[2][0] - _e298) * _e399) - (_e1034 * _e323));
                                                let _e1040 = (((_e999[2][1] - _e337) * _e399) - (_e1034 * _e361));
                                                let _e1041 = (_e1037 * _e1031);
                                                let _e1042 = (_e1040 * _e1028);
                                                let _e1043 = (_e1019 * _e1040);
                                                let _e1044 = (_e1022 * _e1037);
                                                let _e1045 = (_e1028 * _e1022);
                                                let _e1046 = (_e1031 * _e1019);
                                                let _e1051 = (((_e1041 >= _e1042) && (_e1043 >= _e1044)) && (_e1045 >= _e1046));
                                                if (_e1051 || (((_e1041 <= _e1042) && (_e1043 <= _e1044)) && (_e1045 <= _e1046))) {
                                                    let _e1058 = select(-1f, 1f, _e1051);
                                                    let _e1060 = ((_e1041 - _e1042) * _e1058);
                                                    let _e1062 = select(0f, _e1060, (_e1060 > 0f));
                                                    let _e1064 = ((_e1043 - _e1044) * _e1058);
                                                    let _e1066 = select(0f, _e1064, (_e1064 > 0f));
                                                    let _e1068 = ((_e1045 - _e1046) * _e1058);
                                                    let _e1070 = select(0f, _e1068, (_e1068 > 0f));
                                                    let _e1072 = ((_e1062 + _e1066) + _e1070);
                                                    if (_e1072 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_3751_ = type_21();
                                                        phi_3752_ = true;
                                                    } else {
                                                        let _e1075 = select(_e999[1][0], _e999[0][0], (_e999[0][0] < _e999[1][0]));
                                                        let _e1079 = select(_e999[1][0], _e999[0][0], (_e999[0][0] > _e999[1][0]));
                                                        let _e1083 = select(_e999[1][1], _e999[0][1], (_e999[0][1] < _e999[1][1]));
                                                        let _e1087 = select(_e999[1][1], _e999[0][1], (_e999[0][1] > _e999[1][1]));
                                                        let _e1091 = select(_e999[1][2], _e999[0][2], (_e999[0][2] < _e999[1][2]));
                                                        let _e1095 = select(_e999[1][2], _e999[0][2], (_e999[0][2] > _e999[1][2]));
                                                        let _e1100 = ((select(_e999[2][0], _e1075, (_e1075 < _e999[2][0])) - _e321) * _e326);
                                                        let _e1101 = ((select(_e999[2][0], _e1079, (_e1079 > _e999[2][0])) - _e322) * _e326);
                                                        let _e1104 = ((select(_e999[2][1], _e1083, (_e1083 < _e999[2][1])) - _e359) * _e364);
                                                        let _e1105 = ((select(_e999[2][1], _e1087, (_e1087 > _e999[2][1])) - _e360) * _e364);
                                                        let _e1108 = ((select(_e999[2][2], _e1091, (_e1091 < _e999[2][2])) - _e397) * _e402);
                                                        let _e1109 = ((select(_e999[2][2], _e1095, (_e1095 > _e999[2][2])) - _e398) * _e402);
                                                        let _e1111 = select(_e1109, _e1108, (_e1108 < _e1109));
                                                        let _e1113 = select(_e1109, _e1108, (_e1108 > _e1109));
                                                        let _e1115 = select(_e1101, _e1100, (_e1100 < _e1101));
                                                        let _e1117 = select(_e1105, _e1104, (_e1104 < _e1105));
                                                        let _e1119 = select(_e1117, _e1115, (_e1115 > _e1117));
                                                        let _e1121 = select(_e1111, _e1119, (_e1119 > _e1111));
                                                        let _e1123 = select(_e1101, _e1100, (_e1100 > _e1101));
                                                        let _e1125 = select(_e1105, _e1104, (_e1104 > _e1105));
                                                        let _e1127 = select(_e1125, _e1123, (_e1123 < _e1125));
                                                        let _e1129 = select(_e1113, _e1127, (_e1127 < _e1113));
                                                        let _e1130 = -(_e1111);
                                                        let _e1136 = select(_e449, _e1121, (_e1121 > _e449));
                                                        if (_e1136 > (_e1129 + (select(_e1130, _e1113, (_e1113 > _e1130)) * 0.0000019073523f))) {
                                                            phi_3746_ = type_21();
                                                            phi_3747_ = true;
                                                        } else {
                                                            let _e1138 = (_e1136 > _e857.member.member_1);
                                                            if _e1138 {
                                                                phi_3745_ = type_21();
                                                            } else {
                                                                let _e1142 = (_e999[1][0] - _e999[0][0]);
                                                                let _e1143 = (_e999[1][1] - _e999[0][1]);
                                                                let _e1144 = (_e999[1][2] - _e999[0][2]);
                                                                let _e1145 = vec3<f32>(_e1142, _e1143, _e1144);
                                                                let _e1146 = (_e999[2][0] - _e999[1][0]);
                                                                let _e1147 = (_e999[2][1] - _e999[1][1]);
                                                                let _e1148 = (_e999[2][2] - _e999[1][2]);
                                                                let _e1149 = vec3<f32>(_e1146, _e1147, _e1148);
                                                                let _e1150 = (_e999[0][0] - _e999[2][0]);
                                                                let _e1151 = (_e999[0][1] - _e999[2][1]);
                                                                let _e1152 = (_e999[0][2] - _e999[2][2]);
                                                                let _e1153 = vec3<f32>(_e1150, _e1151, _e1152);
                                                                let _e1156 = bitcast<f32>((bitcast<u32>(_e1142) & 2147483647u));
                                                                let _e1159 = bitcast<f32>((bitcast<u32>(_e1143) & 2147483647u));
                                                                let _e1161 = select(_e1159, _e1156, (_e1156 > _e1159));
                                                                let _e1164 = bitcast<f32>((bitcast<u32>(_e1144) & 2147483647u));
                                                                let _e1166 = select(_e1164, _e1161, (_e1161 > _e1164));
                                                                let _e1169 = bitcast<f32>((bitcast<u32>(_e1146) & 2147483647u));
                                                                let _e1172 = bitcast<f32>((bitcast<u32>(_e1147) & 2147483647u));
                                                                let _e1174 = select(_e1172, _e1169, (_e1169 > _e1172));
                                                                let _e1177 = bitcast<f32>((bitcast<u32>(_e1148) & 2147483647u));
                                                                let _e1179 = select(_e1177, _e1174, (_e1174 > _e1177));
                                                                let _e1182 = bitcast<f32>((bitcast<u32>(_e1150) & 2147483647u));
                                                                let _e1185 = bitcast<f32>((bitcast<u32>(_e1151) & 2147483647u));
                                                                let _e1187 = select(_e1185, _e1182, (_e1182 > _e1185));
                                                                let _e1190 = bitcast<f32>((bitcast<u32>(_e1152) & 2147483647u));
                                                                let _e1192 = select(_e1190, _e1187, (_e1187 > _e1190));
                                                                let _e1194 = select(_e1179, _e1166, (_e1166 > _e1179));
                                                                let _e1196 = select(_e1192, _e1194, (_e1194 > _e1192));
                                                                if (_e1166 == _e1196) {
                                                                    phi_3656_ = _e1149;
                                                                    phi_3657_ = _e1153;
                                                                } else {
                                                                    let _e1199 = vec3((_e1179 == _e1196));
                                                                    phi_3656_ = select(_e1145, _e1153, _e1199);
                                                                    phi_3657_ = select(_e1149, _e1145, _e1199);
                                                                }
                                                                let _e1203 = phi_3656_;
                                                                let _e1205 = phi_3657_;
                                                                let _e1212 = ((_e1203.y * _e1205.z) - (_e1205.y * _e1203.z));
                                                                let _e1217 = ((_e1203.z * _e1205.x) - (_e1205.z * _e1203.x));
                                                                let _e1220 = ((_e1203.x * _e1205.y) - (_e1205.x * _e1203.y));
                                                                if (_e1062 >= _e1066) {
                                                                    phi_3688_ = select(true, false, (_e1062 >= _e1070));
                                                                } else {
                                                                    phi_3688_ = true;
                                                                }
                                                                let _e1225 = phi_3688_;
                                                                if _e1225 {
                                                                    phi_3697_ = select(vec3<f32>(_e999[2][0], _e999[2][1], _e999[2][2]), vec3<f32>(_e999[1][0], _e999[1][1], _e999[1][2]), vec3((_e1066 >= _e1070)));
                                                                } else {
                                                                    phi_3697_ = vec3<f32>(_e999[0][0], _e999[0][1], _e999[0][2]);
                                                                }
                                                                let _e1230 = phi_3697_;
                                                                let _e1247 = ((((_e1212 * (_e1230.x - _e298)) + (_e1217 * (_e1230.y - _e337))) + (_e1220 * (_e1230.z - _e375))) / (((_e1212 * _e323) + (_e1217 * _e361)) + (_e1220 * _e399)));
                                                                let _e1249 = select(_e1129, _e1247, (_e1247 < _e1129));
                                                                let _e1251 = select(_e1121, _e1249, (_e1249 > _e1121));
                                                                if (_e1251 >= _e449) {
                                                                    let _e1253 = (_e1251 <= _e857.member.member_1);
                                                                    if _e1253 {
                                                                        let _e1254 = (1f / _e1072);
                                                                        phi_3737_ = type_21(_e1251, (_e1066 * _e1254), (_e1070 * _e1254), _e901);
                                                                    } else {
                                                                        phi_3737_ = type_21();
                                                                    }
                                                                    let _e1259 = phi_3737_;
                                                                    phi_3739_ = _e1259;
                                                                    phi_3740_ = select(true, false, _e1253);
                                                                } else {
                                                                    phi_3739_ = type_21();
                                                                    phi_3740_ = true;
                                                                }
                                                                let _e1262 = phi_3739_;
                                                                let _e1264 = phi_3740_;
                                                                if _e1264 {
                                                                    phi_3744_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_3744_ = _e1262;
                                                                }
                                                                let _e1266 = phi_3744_;
                                                                phi_3745_ = _e1266;
                                                            }
                                                            let _e1268 = phi_3745_;
                                                            phi_3746_ = _e1268;
                                                            phi_3747_ = _e1138;
                                                        }
                                                        let _e1270 = phi_3746_;
                                                        let _e1272 = phi_3747_;
                                                        phi_3751_ = _e1270;
                                                        phi_3752_ = _e1272;
                                                    }
                                                    let _e1274 = phi_3751_;
                                                    let _e1276 = phi_3752_;
                                                    phi_3756_ = _e1274;
                                                    phi_3757_ = _e1276;
                                                } else {
                                                    phi_3756_ = type_21();
                                                    phi_3757_ = true;
                                                }
                                                let _e1278 = phi_3756_;
                                                let _e1280 = phi_3757_;
                                                if _e1280 {
                                                    phi_3761_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_3761_ = _e1278;
                                                }
                                                let _e1282 = phi_3761_;
                                                if (_e1282.member_3 != 4294967295u) {
                                                    if (_e901 != 4294967295u) {
                                                        if (_e1282.member < _e857.member.member.member) {
                                                            phi_3787_ = true;
                                                        } else {
                                                            if (_e1282.member == _e857.member.member.member) {
                                                                phi_3786_ = (_e1282.member_3 < _e857.member.member.member_3);
                                                            } else {
                                                                phi_3786_ = false;
                                                            }
                                                            let _e1297 = phi_3786_;
                                                            phi_3787_ = _e1297;
                                                        }
                                                        let _e1299 = phi_3787_;
                                                        if _e1299 {
                                                            phi_3794_ = type_32(type_27(_e1282, _e1282.member), _e884.member_1, _e884.member_2);
                                                        } else {
                                                            phi_3794_ = _e884;
                                                        }
                                                        let _e1306 = phi_3794_;
                                                        phi_3795_ = _e1306;
                                                    } else {
                                                        phi_3795_ = _e884;
                                                    }
                                                    let _e1308 = phi_3795_;
                                                    phi_3796_ = _e1308;
                                                } else {
                                                    phi_3796_ = _e884;
                                                }
                                                let _e1310 = phi_3796_;
                                                phi_4824_ = _e998;
                                                phi_2930_ = _e1310;
                                            } else {
                                                phi_4824_ = _e855;
                                                phi_2930_ = type_32();
                                            }
                                            let _e1312 = phi_4824_;
                                            let _e1314 = phi_2930_;
                                            continue;
                                            continuing {
                                                phi_4818_ = _e1312;
                                                phi_2929_ = _e1314;
                                                phi_2932_ = _e872;
                                                phi_4823_ = _e1312;
                                                break if !(_e878);
                                            }
                                        }
                                        let _e1317 = phi_4823_;
                                        phi_4882_ = _e1317;
                                        if _e1317 {
                                            break;
                                        }
                                        phi_4886_ = _e1317;
                                        let _e1483 = local_19;
                                        phi_4643_ = _e1483;
                                        phi_4644_ = _e522;
                                        phi_4645_ = false;
                                        phi_4646_ = _e526;
                                    } else {
                                        local_3 = array<f32, 3>(_e522.member.member[0], _e522.member.member[1], _e522.member.member[2]);
                                        local_2 = array<f32, 3>(_e522.member.member_1[0], _e522.member.member_1[1], _e522.member.member_1[2]);
                                        let _e552 = (_e522.member_1 < _e86);
                                        if _e552 {
                                            if _e552 {
                                            } else {
                                                phi_4882_ = true;
                                                break;
                                            }
                                            let _e554 = global_4.member[_e522.member_1];
                                            phi_3833_ = _e554;
                                        } else {
                                            phi_3833_ = type_36(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e556 = phi_3833_;
                                        let _e558 = array<u32, 3>(_e249, _e248, _e250);
                                        local_11 = _e558;
                                        local_7 = array<f32, 3>(0f, 0f, 0f);
                                        local_6 = array<f32, 3>(0f, 0f, 0f);
                                        phi_3842_ = type_4(0u, 3u);
                                        loop {
                                            let _e560 = phi_3842_;
                                            if (_e560.member < _e560.member_1) {
                                                phi_3843_ = type_4((_e560.member + 1u), _e560.member_1);
                                                phi_3866_ = type_4(1u, _e560.member);
                                            } else {
                                                phi_3843_ = _e560;
                                                phi_3866_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e573 = phi_3843_;
                                            let _e575 = phi_3866_;
                                            let _e579 = (bitcast<i32>(_e575.member) != 0i);
                                            if _e579 {
                                                let _e580 = (_e575.member_1 < 3u);
                                                if _e580 {
                                                } else {
                                                    phi_4741_ = true;
                                                    break;
                                                }
                                                let _e582 = local_11[_e575.member_1];
                                                if _e580 {
                                                } else {
                                                    phi_4741_ = true;
                                                    break;
                                                }
                                                let _e584 = local_3[_e575.member_1];
                                                if _e580 {
                                                } else {
                                                    phi_4741_ = true;
                                                    break;
                                                }
                                                let _e586 = local_2[_e575.member_1];
                                                let _e589 = ((10u * _e582) & 31u);
                                                let _e592 = ((_e556.member[0] >> bitcast<u32>(_e589)) & 1023u);
                                                let _e597 = bitcast<f32>((bitcast<u32>(((_e586 - _e584) * 0.0009775171f)) ^ _e121));
                                                let _e603 = (_e584 + bitcast<f32>((bitcast<u32>((f32(_e592) * _e597)) ^ _e121)));
                                                if _e580 {
                                                } else {
                                                    phi_4741_ = true;
                                                    break;
                                                }
                                                local_7[_e575.member_1] = select(select(_e586, _e603, (_e603 < _e586)), _e586, (_e592 == 1023u));
                                                let _e612 = ((_e556.member[1] >> bitcast<u32>(_e589)) & 1023u);
                                                let _e618 = (_e584 + bitcast<f32>((bitcast<u32>((f32(_e612) * _e597)) ^ _e121)));
                                                if _e580 {
                                                } else {
                                                    phi_4741_ = true;
                                                    break;
                                                }
                                                local_6[_e575.member_1] = select(select(_e586, _e618, (_e618 < _e586)), _e586, (_e612 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_3842_ = _e573;
                                                phi_4741_ = _e482;
                                                break if !(_e579);
                                            }
                                        }
                                        let _e626 = phi_4741_;
                                        phi_4882_ = _e626;
                                        if _e626 {
                                            break;
                                        }
                                        let _e627 = local_6;
                                        let _e628 = local_7;
                                        local_10 = _e558;
                                        local_9 = array<f32, 3>(0f, 0f, 0f);
                                        local_8 = array<f32, 3>(0f, 0f, 0f);
                                        phi_3996_ = type_4(0u, 3u);
                                        loop {
                                            let _e637 = phi_3996_;
                                            if (_e637.member < _e637.member_1) {
                                                phi_3997_ = type_4((_e637.member + 1u), _e637.member_1);
                                                phi_4020_ = type_4(1u, _e637.member);
                                            } else {
                                                phi_3997_ = _e637;
                                                phi_4020_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e650 = phi_3997_;
                                            let _e652 = phi_4020_;
                                            let _e656 = (bitcast<i32>(_e652.member) != 0i);
                                            if _e656 {
                                                let _e657 = (_e652.member_1 < 3u);
                                                if _e657 {
                                                } else {
                                                    phi_4801_ = true;
                                                    break;
                                                }
                                                let _e659 = local_10[_e652.member_1];
                                                if _e657 {
                                                } else {
                                                    phi_4801_ = true;
                                                    break;
                                                }
                                                let _e661 = local_3[_e652.member_1];
                                                if _e657 {
                                                } else {
                                                    phi_4801_ = true;
                                                    break;
                                                }
                                                let _e663 = local_2[_e652.member_1];
                                                let _e666 = ((10u * _e659) & 31u);
                                                let _e669 = ((_e556.member_1[0] >> bitcast<u32>(_e666)) & 1023u);
                                                let _e674 = bitcast<f32>((bitcast<u32>(((_e663 - _e661) * 0.0009775171f)) ^ _e121));
                                                let _e680 = (_e661 + bitcast<f32>((bitcast<u32>((f32(_e669) * _e674)) ^ _e121)));
                                                if _e657 {
                                                } else {
                                                    phi_4801_ = true;
                                                    break;
                                                }
                                                local_9[_e652.member_1] = select(select(_e663, _e680, (_e680 < _e663)), _e663, (_e669 == 1023u));
                                                let _e689 = ((_e556.member_1[1] >> bitcast<u32>(_e666)) & 1023u);
                                                let _e695 = (_e661 + bitcast<f32>((bitcast<u32>((f32(_e689) * _e674)) ^ _e121)));
                                                if _e657 {
                                                } else {
                                                    phi_4801_ = true;
                                                    break;
                                                }
                                                local_8[_e652.member_1] = select(select(_e663, _e695, (_e695 < _e663)), _e663, (_e689 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_3996_ = _e650;
                                                phi_4801_ = _e626;
                                                break if !(_e656);
                                            }
                                        }
                                        let _e703 = phi_4801_;
                                        phi_4882_ = _e703;
                                        if _e703 {
                                            break;
                                        }
                                        let _e704 = local_8;
                                        let _e705 = local_9;
                                        let _e716 = type_50(type_41(array<f32, 3>(_e628[0], _e628[1], _e628[2]), array<f32, 3>(_e627[0], _e627[1], _e627[2])), _e556.member_2);
                                        let _e721 = type_50(type_41(array<f32, 3>(_e705[0], _e705[1], _e705[2]), array<f32, 3>(_e704[0], _e704[1], _e704[2])), _e556.member_3);
                                        let _e728 = ((_e628[0] - _e321) * _e326);
                                        let _e729 = ((_e705[0] - _e321) * _e326);
                                        let _e730 = ((_e627[0] - _e322) * _e326);
                                        let _e731 = ((_e704[0] - _e322) * _e326);
                                        let _e736 = ((_e628[1] - _e359) * _e364);
                                        let _e737 = ((_e705[1] - _e359) * _e364);
                                        let _e738 = ((_e627[1] - _e360) * _e364);
                                        let _e739 = ((_e704[1] - _e360) * _e364);
                                        let _e744 = ((_e628[2] - _e397) * _e402);
                                        let _e745 = ((_e705[2] - _e397) * _e402);
                                        let _e746 = ((_e627[2] - _e398) * _e402);
                                        let _e747 = ((_e704[2] - _e398) * _e402);
                                        let _e749 = select(_e746, _e744, (_e744 < _e746));
                                        let _e751 = select(_e747, _e745, (_e745 < _e747));
                                        let _e753 = select(_e746, _e744, (_e744 > _e746));
                                        let _e755 = select(_e747, _e745, (_e745 > _e747));
                                        let _e757 = select(_e730, _e728, (_e728 < _e730));
                                        let _e759 = select(_e731, _e729, (_e729 < _e731));
                                        let _e761 = select(_e738, _e736, (_e736 < _e738));
                                        let _e763 = select(_e739, _e737, (_e737 < _e739));
                                        let _e765 = select(_e761, _e757, (_e757 > _e761));
                                        let _e767 = select(_e763, _e759, (_e759 > _e763));
                                        let _e769 = select(_e749, _e765, (_e765 > _e749));
                                        let _e771 = select(_e751, _e767, (_e767 > _e751));
                                        let _e773 = select(_e730, _e728, (_e728 > _e730));
                                        let _e775 = select(_e731, _e729, (_e729 > _e731));
                                        let _e777 = select(_e738, _e736, (_e736 > _e738));
                                        let _e779 = select(_e739, _e737, (_e737 > _e739));
                                        let _e781 = select(_e777, _e773, (_e773 < _e777));
                                        let _e783 = select(_e779, _e775, (_e775 < _e779));
                                        let _e788 = -(_e749);
                                        let _e789 = -(_e751);
                                        let _e796 = (select(_e753, _e781, (_e781 < _e753)) + (select(_e788, _e753, (_e753 > _e788)) * 0.0000019073523f));
                                        let _e797 = (select(_e755, _e783, (_e783 < _e755)) + (select(_e789, _e755, (_e755 > _e789)) * 0.0000019073523f));
                                        let _e799 = select(_e449, _e769, (_e769 > _e449));
                                        let _e801 = select(_e449, _e771, (_e771 > _e449));
                                        let _e806 = (_e799 <= select(_e484.member.member_1, _e796, (_e796 < _e484.member.member_1)));
                                        let _e807 = (_e801 <= select(_e484.member.member_1, _e797, (_e797 < _e484.member.member_1)));
                                        let _e808 = (_e799 <= _e801);
                                        if _e806 {
                                            if _e807 {
                                                if _e808 {
                                                    phi_4583_ = _e721;
                                                } else {
                                                    phi_4583_ = _e716;
                                                }
                                                let _e810 = phi_4583_;
                                                let _e811 = (_e526 % 128u);
                                                let _e812 = (_e811 < 128u);
                                                if _e812 {
                                                } else {
                                                    phi_4882_ = true;
                                                    break;
                                                }
                                                local_5[_e811] = type_50(type_41(array<f32, 3>(_e810.member.member[0], _e810.member.member[1], _e810.member.member[2]), array<f32, 3>(_e810.member.member_1[0], _e810.member.member_1[1], _e810.member.member_1[2])), _e810.member_1);
                                                if _e812 {
                                                } else {
                                                    phi_4882_ = true;
                                                    break;
                                                }
                                                local_4[_e811] = select(_e801, _e799, (_e799 > _e801));
                                                if _e808 {
                                                    phi_4622_ = _e716;
                                                } else {
                                                    phi_4622_ = _e721;
                                                }
                                                let _e833 = phi_4622_;
                                                phi_4623_ = _e833;
                                                phi_4624_ = (_e526 + 1u);
                                            } else {
                                                phi_4623_ = type_50();
                                                phi_4624_ = u32();
                                            }
                                            let _e835 = phi_4623_;
                                            let _e837 = phi_4624_;
                                            phi_4626_ = _e835;
                                            phi_4627_ = _e837;
                                            phi_4628_ = select(true, false, _e807);
                                        } else {
                                            phi_4626_ = type_50();
                                            phi_4627_ = u32();
                                            phi_4628_ = true;
                                        }
                                        let _e840 = phi_4626_;
                                        let _e842 = phi_4627_;
                                        let _e844 = phi_4628_;
                                        if _e844 {
                                            if _e806 {
                                                phi_4635_ = _e716;
                                            } else {
                                                phi_4635_ = _e721;
                                            }
                                            let _e846 = phi_4635_;
                                            phi_4640_ = _e846;
                                            phi_4641_ = select(_e807, true, _e806);
                                        } else {
                                            phi_4640_ = _e840;
                                            phi_4641_ = _e524;
                                        }
                                        let _e849 = phi_4640_;
                                        let _e851 = phi_4641_;
                                        phi_4886_ = _e703;
                                        phi_4643_ = type_32(_e484.member, (_e484.member_1 + 1u), _e484.member_2);
                                        phi_4644_ = _e849;
                                        phi_4645_ = _e851;
                                        phi_4646_ = select(_e842, _e526, _e844);
                                    }
                                    let _e1319 = phi_4886_;
                                    let _e1321 = phi_4643_;
                                    let _e1323 = phi_4644_;
                                    let _e1325 = phi_4645_;
                                    let _e1327 = phi_4646_;
                                    phi_4885_ = _e1319;
                                    phi_4647_ = _e1321;
                                    phi_4648_ = _e1323;
                                    phi_4649_ = (_e488 - 1u);
                                    phi_4650_ = _e1325;
                                    phi_4651_ = _e1327;
                                } else {
                                    phi_4885_ = _e482;
                                    phi_4647_ = _e484;
                                    phi_4648_ = _e522;
                                    phi_4649_ = _e488;
                                    phi_4650_ = _e524;
                                    phi_4651_ = _e526;
                                }
                                let _e1329 = phi_4885_;
                                let _e1331 = phi_4647_;
                                let _e1333 = phi_4648_;
                                let _e1335 = phi_4649_;
                                let _e1337 = phi_4650_;
                                let _e1339 = phi_4651_;
                                phi_4884_ = _e1329;
                                phi_4652_ = _e1331;
                                phi_4653_ = _e1333;
                                phi_4654_ = _e1335;
                                phi_4655_ = _e1337;
                                phi_4656_ = _e1339;
                            } else {
                                phi_4884_ = _e482;
                                phi_4652_ = type_32();
                                phi_4653_ = type_50();
                                phi_4654_ = u32();
                                phi_4655_ = bool();
                                phi_4656_ = u32();
                            }
                            let _e1341 = phi_4884_;
                            let _e1343 = phi_4652_;
                            let _e1345 = phi_4653_;
                            let _e1347 = phi_4654_;
                            let _e1349 = phi_4655_;
                            let _e1351 = phi_4656_;
                            phi_4883_ = _e1341;
                            phi_2844_ = _e1343;
                            phi_2847_ = _e1345;
                            phi_2849_ = _e1347;
                            phi_2851_ = _e1349;
                            phi_2853_ = _e1351;
                            phi_4657_ = _e496;
                        } else {
                            phi_4883_ = _e482;
                            phi_2844_ = type_32();
                            phi_2847_ = type_50();
                            phi_2849_ = u32();
                            phi_2851_ = bool();
                            phi_2853_ = u32();
                            phi_4657_ = false;
                        }
                        let _e1353 = phi_4883_;
                        let _e1355 = phi_2844_;
                        let _e1357 = phi_2847_;
                        let _e1359 = phi_2849_;
                        let _e1361 = phi_2851_;
                        let _e1363 = phi_2853_;
                        let _e1365 = phi_4657_;
                        continue;
                        continuing {
                            phi_4748_ = _e1353;
                            phi_2843_ = _e1355;
                            phi_2846_ = _e1357;
                            phi_2848_ = _e1359;
                            phi_2850_ = _e1361;
                            phi_2852_ = _e1363;
                            phi_4882_ = _e1353;
                            break if !(_e1365);
                        }
                    }
                    let _e1368 = phi_4882_;
                    if _e1368 {
                        break;
                    }
                    let _e1370 = local_17;
                    let _e1373 = local_18;
                    if _e137 {
                    } else {
                        break;
                    }
                    global_5.member[_e135][0u] = _e1370.member_1;
                    global_5.member[_e135][1u] = _e1373.member_2;
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
