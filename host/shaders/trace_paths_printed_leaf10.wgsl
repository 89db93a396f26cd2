struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_12 {
    member: vec4<u32>,
}

struct type_22 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_24 {
    member: array<type_22>,
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

struct type_35 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_37 {
    member: type_22,
    member_1: f32,
}

struct type_40 {
    member: array<vec4<u32>, 2>,
}

struct type_43 {
    member: array<i32>,
}

struct type_47 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_49 {
    member: array<type_47>,
}

struct type_52 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_55 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_57 {
    member: array<type_55>,
}

struct type_61 {
    member: type_52,
    member_1: u32,
}

struct type_70 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_40;
@group(0) @binding(2) 
var<uniform> global_3: type_40;
@group(0) @binding(5) 
var<storage> global_4: type_4;
@group(0) @binding(6) 
var<storage> global_5: type_43;
@group(0) @binding(7) 
var<storage> global_6: type_29;
@group(0) @binding(8) 
var<storage, read_write> global_7: type_24;
@group(0) @binding(9) 
var<storage, read_write> global_8: type_70;
@group(0) @binding(3) 
var<storage> global_9: type_49;
@group(0) @binding(4) 
var<storage> global_10: type_57;

fn function_() {
    var local: array<f32, 3>;
    var local_1: array<f32, 3>;
    var local_2: array<f32, 3>;
    var local_3: array<f32, 3>;
    var local_4: array<f32, 128>;
    var local_5: array<type_61, 128>;
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
    var phi_286_: u32;
    var phi_351_: type_35;
    var phi_457_: i32;
    var phi_458_: i32;
    var phi_468_: bool;
    var phi_478_: u32;
    var phi_479_: u32;
    var phi_481_: bool;
    var phi_486_: u32;
    var phi_531_: f32;
    var phi_537_: f32;
    var phi_548_: f32;
    var phi_554_: f32;
    var phi_577_: f32;
    var phi_588_: f32;
    var phi_597_: f32;
    var phi_603_: f32;
    var phi_614_: f32;
    var phi_620_: f32;
    var phi_643_: f32;
    var phi_654_: f32;
    var phi_663_: f32;
    var phi_669_: f32;
    var phi_680_: f32;
    var phi_686_: f32;
    var phi_709_: f32;
    var phi_720_: f32;
    var phi_820_: f32;
    var phi_821_: f32;
    var phi_5289_: bool;
    var phi_2949_: type_37;
    var phi_2952_: type_61;
    var phi_2954_: u32;
    var phi_2956_: bool;
    var phi_2958_: u32;
    var phi_2969_: bool;
    var phi_3014_: type_61;
    var phi_3015_: bool;
    var phi_3016_: u32;
    var phi_4255_: type_47;
    var phi_4264_: type_8;
    var phi_4265_: type_8;
    var phi_4288_: type_8;
    var phi_5282_: bool;
    var phi_4418_: type_8;
    var phi_4419_: type_8;
    var phi_4442_: type_8;
    var phi_5340_: bool;
    var phi_5005_: type_61;
    var phi_5044_: type_61;
    var phi_5045_: type_61;
    var phi_5046_: u32;
    var phi_5048_: type_61;
    var phi_5049_: u32;
    var phi_5050_: bool;
    var phi_5057_: type_61;
    var phi_5062_: type_61;
    var phi_5063_: bool;
    var phi_5357_: bool;
    var phi_3035_: type_37;
    var phi_3038_: type_8;
    var phi_3039_: type_8;
    var phi_3061_: type_8;
    var phi_3103_: u32;
    var phi_3127_: type_55;
    var phi_5353_: bool;
    var phi_3138_: type_8;
    var phi_3139_: type_8;
    var phi_3162_: type_8;
    var phi_3172_: type_8;
    var phi_3173_: type_8;
    var phi_3196_: type_8;
    var phi_5348_: bool;
    var phi_5361_: bool;
    var phi_5360_: bool;
    var phi_3759_: vec3<f32>;
    var phi_3760_: vec3<f32>;
    var phi_3791_: bool;
    var phi_3800_: vec3<f32>;
    var phi_3840_: type_22;
    var phi_3842_: type_22;
    var phi_3843_: bool;
    var phi_3847_: type_22;
    var phi_3848_: type_22;
    var phi_3849_: type_22;
    var phi_3850_: bool;
    var phi_3854_: type_22;
    var phi_3855_: bool;
    var phi_3859_: type_22;
    var phi_3860_: bool;
    var phi_3864_: type_22;
    var phi_3887_: u32;
    var phi_3901_: i32;
    var phi_3921_: vec3<f32>;
    var phi_3922_: vec3<f32>;
    var phi_3938_: vec3<f32>;
    var phi_3939_: vec3<f32>;
    var phi_3955_: vec3<f32>;
    var phi_3956_: vec3<f32>;
    var phi_3992_: vec3<f32>;
    var phi_4174_: f32;
    var phi_4192_: bool;
    var phi_4193_: bool;
    var phi_4212_: bool;
    var phi_4213_: bool;
    var phi_4219_: type_37;
    var phi_4220_: type_37;
    var phi_4221_: type_37;
    var phi_5363_: bool;
    var phi_3036_: type_37;
    var phi_5362_: bool;
    var phi_5445_: bool;
    var phi_5065_: type_37;
    var phi_5066_: type_61;
    var phi_5067_: bool;
    var phi_5068_: u32;
    var phi_5444_: bool;
    var phi_5069_: type_37;
    var phi_5070_: type_61;
    var phi_5071_: u32;
    var phi_5072_: bool;
    var phi_5073_: u32;
    var phi_5443_: bool;
    var phi_5074_: type_37;
    var phi_5075_: type_61;
    var phi_5076_: u32;
    var phi_5077_: bool;
    var phi_5078_: u32;
    var phi_5442_: bool;
    var phi_2950_: type_37;
    var phi_2953_: type_61;
    var phi_2955_: u32;
    var phi_2957_: bool;
    var phi_2959_: u32;
    var phi_5079_: bool;
    var phi_5441_: bool;
    var local_17: type_37;
    var phi_5131_: type_22;
    var local_18: type_37;

    switch bitcast<i32>(0u) {
        default: {
            let _e93 = global;
            let _e96 = arrayLength((&global_9.member));
            let _e111 = arrayLength((&global_8.member));
            let _e115 = global_3.member[0u][0u];
            let _e119 = global_3.member[0u][1u];
            let _e123 = global_3.member[0u][2u];
            let _e127 = global_3.member[1u][0u];
            let _e131 = global_3.member[1u][1u];
            let _e135 = global_3.member[1u][2u];
            let _e139 = global_3.member[1u][3u];
            let _e143 = (_e93.x + (_e93.y * 2097152u));
            let _e150 = (_e143 < arrayLength((&global_6.member)));
            if _e150 {
                if _e150 {
                } else {
                    break;
                }
                let _e154 = global_6.member[_e143].member_2;
                phi_286_ = _e154;
            } else {
                phi_286_ = 4294967295u;
            }
            let _e156 = phi_286_;
            let _e159 = global_1.member[0u];
            let _e163 = global_2.member[0u][0u];
            let _e167 = global_2.member[0u][1u];
            let _e171 = global_2.member[0u][2u];
            let _e175 = global_2.member[0u][3u];
            let _e179 = global_2.member[1u][0u];
            let _e183 = global_2.member[1u][1u];
            let _e187 = global_2.member[1u][2u];
            let _e191 = global_2.member[1u][3u];
            let _e192 = bitcast<f32>(_e163);
            let _e193 = bitcast<f32>(_e167);
            let _e194 = bitcast<f32>(_e171);
            let _e196 = bitcast<f32>(_e179);
            let _e197 = array<u32, 3>(_e183, _e187, _e191);
            let _e199 = bitcast<i32>(_e159);
            let _e200 = (_e199 / 2i);
            let _e205 = bitcast<f32>((bitcast<u32>((_e200 + 127i)) << bitcast<u32>(23i)));
            let _e211 = bitcast<f32>((bitcast<u32>(((_e199 - _e200) + 127i)) << bitcast<u32>(23i)));
            if (_e175 == 0u) {
                phi_351_ = type_35(array<f32, 3>(_e192, _e193, _e194), _e175, _e196, _e197);
            } else {
                phi_351_ = type_35(array<f32, 3>(((_e192 * _e205) * _e211), ((_e193 * _e205) * _e211), ((_e194 * _e205) * _e211)), _e175, ((_e196 * _e205) * _e211), _e197);
            }
            let _e224 = phi_351_;
            if _e150 {
                let _e225 = (_e143 < arrayLength((&global_7.member)));
                if _e225 {
                    if _e150 {
                    } else {
                        break;
                    }
                    let _e235 = global_6.member[_e143].member.member_2[0u];
                    let _e237 = (bitcast<u32>(_e235) & 2147483647u);
                    let _e243 = global_6.member[_e143].member.member_2[1u];
                    let _e245 = (bitcast<u32>(_e243) & 2147483647u);
                    let _e251 = global_6.member[_e143].member.member_2[2u];
                    let _e253 = (bitcast<u32>(_e251) & 2147483647u);
                    let _e259 = global_6.member[_e143].member.member[0u];
                    let _e261 = (bitcast<u32>(_e259) & 2147483647u);
                    let _e267 = global_6.member[_e143].member.member[1u];
                    let _e269 = (bitcast<u32>(_e267) & 2147483647u);
                    let _e275 = global_6.member[_e143].member.member[2u];
                    let _e277 = (bitcast<u32>(_e275) & 2147483647u);
                    let _e279 = select(_e245, _e237, (_e245 < _e237));
                    let _e281 = select(_e253, _e279, (_e253 < _e279));
                    let _e283 = select(_e261, _e281, (_e261 < _e281));
                    let _e285 = select(_e269, _e283, (_e269 < _e283));
                    let _e287 = select(_e277, _e285, (_e277 < _e285));
                    let _e292 = global_6.member[_e143].member.member_1;
                    let _e294 = (bitcast<u32>(_e292) & 2147483647u);
                    let _e302 = global_6.member[_e143].member.member_3;
                    let _e308 = (((select(_e294, _e287, (_e294 < _e287)) < 2139095040u) && ((bitcast<u32>(_e302) & 2147483647u) <= 2139095040u)) && (_e281 > 0u));
                    if _e308 {
                        let _e311 = (bitcast<u32>(bitcast<f32>(_e281)) & 2147483647u);
                        if (_e311 >= 8388608u) {
                            phi_457_ = (bitcast<i32>((_e311 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_457_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e311)), 32u, (_e311 == 0u))));
                        }
                        let _e325 = phi_457_;
                        phi_458_ = _e325;
                    } else {
                        phi_458_ = 0i;
                    }
                    let _e327 = phi_458_;
                    let _e328 = (_e237 == _e281);
                    if _e328 {
                        phi_468_ = true;
                    } else {
                        phi_468_ = (_e245 == _e281);
                    }
                    let _e331 = phi_468_;
                    let _e332 = select(1u, 0u, _e328);
                    if _e331 {
                        let _e333 = (_e332 + 1u);
                        phi_478_ = _e333;
                        phi_479_ = _e333;
                        phi_481_ = select(true, false, (_e333 == 2u));
                    } else {
                        phi_478_ = u32();
                        phi_479_ = 0u;
                        phi_481_ = true;
                    }
                    let _e337 = phi_478_;
                    let _e339 = phi_479_;
                    let _e341 = phi_481_;
                    if _e341 {
                        phi_486_ = (_e339 + 1u);
                    } else {
                        phi_486_ = 0u;
                    }
                    let _e345 = phi_486_;
                    let _e346 = select(_e337, _e339, _e341);
                    let _e347 = select(_e332, select(2u, _e332, _e331), _e341);
                    let _e348 = -(_e327);
                    let _e349 = (_e348 / 2i);
                    let _e354 = bitcast<f32>((bitcast<u32>((_e349 + 127i)) << bitcast<u32>(23i)));
                    let _e360 = bitcast<f32>((bitcast<u32>(((_e348 - _e349) + 127i)) << bitcast<u32>(23i)));
                    let _e365 = global_6.member[_e143].member.member;
                    let _e366 = (_e346 == 0u);
                    if _e366 {
                        phi_531_ = _e365[0];
                    } else {
                        phi_531_ = _e365[1];
                    }
                    let _e370 = phi_531_;
                    let _e371 = (_e346 == 2u);
                    if _e371 {
                        phi_537_ = _e365[2];
                    } else {
                        phi_537_ = _e370;
                    }
                    let _e374 = phi_537_;
                    let _e375 = global_6.member[_e143].member.member_2;
                    if _e366 {
                        phi_548_ = _e375[0];
                    } else {
                        phi_548_ = _e375[1];
                    }
                    let _e379 = phi_548_;
                    if _e371 {
                        phi_554_ = _e375[2];
                    } else {
                        phi_554_ = _e379;
                    }
                    let _e382 = phi_554_;
                    let _e384 = ((_e382 * _e354) * _e360);
                    let _e388 = (bitcast<f32>((bitcast<u32>(_e384) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e388 {
                        let _e392 = (bitcast<f32>((bitcast<u32>(_e374) & 2147483647u)) * 0.00000011920929f);
                        phi_577_ = select(0.00000000000011368684f, _e392, (_e392 > 0.00000000000011368684f));
                    } else {
                        phi_577_ = 0f;
                    }
                    let _e396 = phi_577_;
                    let _e397 = (_e374 + _e396);
                    let _e398 = (_e374 - _e396);
                    let _e399 = select(_e384, 0f, _e388);
                    if _e388 {
                        phi_588_ = 38685626000000000000000000f;
                    } else {
                        phi_588_ = (1f / _e384);
                    }
                    let _e402 = phi_588_;
                    let _e403 = (_e345 == 0u);
                    if _e403 {
                        phi_597_ = _e365[0];
                    } else {
                        phi_597_ = _e365[1];
                    }
                    let _e407 = phi_597_;
                    let _e408 = (_e345 == 2u);
                    if _e408 {
                        phi_603_ = _e365[2];
                    } else {
                        phi_603_ = _e407;
                    }
                    let _e411 = phi_603_;
                    if _e403 {
                        phi_614_ = _e375[0];
                    } else {
                        phi_614_ = _e375[1];
                    }
                    let _e415 = phi_614_;
                    if _e408 {
                        phi_620_ = _e375[2];
                    } else {
                        phi_620_ = _e415;
                    }
                    let _e418 = phi_620_;
                    let _e420 = ((_e418 * _e354) * _e360);
                    let _e424 = (bitcast<f32>((bitcast<u32>(_e420) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e424 {
                        let _e428 = (bitcast<f32>((bitcast<u32>(_e411) & 2147483647u)) * 0.00000011920929f);
                        phi_643_ = select(0.00000000000011368684f, _e428, (_e428 > 0.00000000000011368684f));
                    } else {
                        phi_643_ = 0f;
                    }
                    let _e432 = phi_643_;
                    let _e433 = (_e411 + _e432);
                    let _e434 = (_e411 - _e432);
                    let _e435 = select(_e420, 0f, _e424);
                    if _e424 {
                        phi_654_ = 38685626000000000000000000f;
                    } else {
                        phi_654_ = (1f / _e420);
                    }
                    let _e438 = phi_654_;
                    let _e439 = (_e347 == 0u);
                    if _e439 {
                        phi_663_ = _e365[0];
                    } else {
                        phi_663_ = _e365[1];
                    }
                    let _e443 = phi_663_;
                    let _e444 = (_e347 == 2u);
                    if _e444 {
                        phi_669_ = _e365[2];
                    } else {
                        phi_669_ = _e443;
                    }
                    let _e447 = phi_669_;
                    if _e439 {
                        phi_680_ = _e375[0];
                    } else {
                        phi_680_ = _e375[1];
                    }
                    let _e451 = phi_680_;
                    if _e444 {
                        phi_686_ = _e375[2];
                    } else {
                        phi_686_ = _e451;
                    }
                    let _e454 = phi_686_;
                    let _e456 = ((_e454 * _e354) * _e360);
                    let _e460 = (bitcast<f32>((bitcast<u32>(_e456) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e460 {
                        let _e464 = (bitcast<f32>((bitcast<u32>(_e447) & 2147483647u)) * 0.00000011920929f);
                        phi_709_ = select(0.00000000000011368684f, _e464, (_e464 > 0.00000000000011368684f));
                    } else {
                        phi_709_ = 0f;
                    }
                    let _e468 = phi_709_;
                    let _e469 = (_e447 + _e468);
                    let _e470 = (_e447 - _e468);
                    let _e471 = select(_e456, 0f, _e460);
                    if _e460 {
                        phi_720_ = 38685626000000000000000000f;
                    } else {
                        phi_720_ = (1f / _e456);
                    }
                    let _e474 = phi_720_;
                    let _e477 = bitcast<f32>((bitcast<u32>(_e374) & 2147483647u));
                    let _e480 = bitcast<f32>((bitcast<u32>(_e411) & 2147483647u));
                    let _e482 = select(_e480, _e477, (_e477 > _e480));
                    let _e485 = bitcast<f32>((bitcast<u32>(_e447) & 2147483647u));
                    if (_e308 && (select(_e485, _e482, (_e482 > _e485)) <= 1099511600000f)) {
                        let _e490 = (_e327 / 3i);
                        let _e497 = bitcast<f32>((bitcast<u32>((_e490 + 127i)) << bitcast<u32>(23i)));
                        let _e504 = bitcast<f32>((bitcast<u32>(((_e327 - (2i * _e490)) + 127i)) << bitcast<u32>(23i)));
                        let _e505 = (((_e292 * _e497) * _e497) * _e504);
                        let _e507 = select(340282350000000000000000000000000000000f, _e505, (_e505 < 340282350000000000000000000000000000000f));
                        let _e512 = (((_e302 * _e497) * _e497) * _e504);
                        let _e514 = select(340282350000000000000000000000000000000f, _e512, (_e512 < 340282350000000000000000000000000000000f));
                        phi_820_ = select(-340282350000000000000000000000000000000f, _e514, (_e514 > -340282350000000000000000000000000000000f));
                        phi_821_ = select(-340282350000000000000000000000000000000f, _e507, (_e507 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_820_ = 0f;
                        phi_821_ = 1f;
                    }
                    let _e518 = phi_820_;
                    let _e520 = phi_821_;
                    local_5 = array<type_61, 128>(type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_61(type_52(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u));
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_16 = array<f32, 3>(bitcast<f32>(_e115), bitcast<f32>(_e119), bitcast<f32>(_e123));
                    let _e525 = (_e346 % 3u);
                    let _e526 = (_e525 < 3u);
                    if _e526 {
                    } else {
                        break;
                    }
                    let _e528 = local_16[_e525];
                    let _e529 = (_e345 % 3u);
                    let _e530 = (_e529 < 3u);
                    if _e530 {
                    } else {
                        break;
                    }
                    let _e532 = local_16[_e529];
                    let _e533 = (_e347 % 3u);
                    let _e534 = (_e533 < 3u);
                    if _e534 {
                    } else {
                        break;
                    }
                    let _e536 = local_16[_e533];
                    local_15 = array<f32, 3>(bitcast<f32>(_e127), bitcast<f32>(_e131), bitcast<f32>(_e135));
                    if _e526 {
                    } else {
                        break;
                    }
                    let _e540 = local_15[_e525];
                    if _e530 {
                    } else {
                        break;
                    }
                    let _e542 = local_15[_e529];
                    if _e534 {
                    } else {
                        break;
                    }
                    let _e544 = local_15[_e533];
                    phi_5289_ = false;
                    phi_2949_ = type_37(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e518);
                    phi_2952_ = type_61(type_52(array<f32, 3>(_e528, _e532, _e536), array<f32, 3>(_e540, _e542, _e544)), select(0u, 2147483648u, (_e96 == 0u)));
                    phi_2954_ = ((3u * _e96) + 1u);
                    phi_2956_ = (_e520 <= _e518);
                    phi_2958_ = 0u;
                    loop {
                        let _e552 = phi_5289_;
                        let _e554 = phi_2949_;
                        let _e556 = phi_2952_;
                        let _e558 = phi_2954_;
                        let _e560 = phi_2956_;
                        let _e562 = phi_2958_;
                        local_17 = _e554;
                        if _e560 {
                            phi_2969_ = true;
                        } else {
                            phi_2969_ = (_e562 > 0u);
                        }
                        let _e565 = phi_2969_;
                        if _e565 {
                            let _e566 = (_e558 > 0u);
                            if _e566 {
                                if _e560 {
                                    phi_3014_ = _e556;
                                    phi_3015_ = _e560;
                                    phi_3016_ = _e562;
                                } else {
                                    let _e567 = (_e562 - 1u);
                                    let _e568 = (_e567 % 128u);
                                    let _e569 = (_e568 < 128u);
                                    if _e569 {
                                    } else {
                                        phi_5441_ = true;
                                        break;
                                    }
                                    let _e571 = local_5[_e568];
                                    if _e569 {
                                    } else {
                                        phi_5441_ = true;
                                        break;
                                    }
                                    let _e587 = local_4[_e568];
                                    phi_3014_ = type_61(type_52(array<f32, 3>(_e571.member.member[0], _e571.member.member[1], _e571.member.member[2]), array<f32, 3>(_e571.member.member_1[0], _e571.member.member_1[1], _e571.member.member_1[2])), _e571.member_1);
                                    phi_3015_ = (_e587 <= _e554.member_1);
                                    phi_3016_ = _e567;
                                }
                                let _e591 = phi_3014_;
                                let _e593 = phi_3015_;
                                let _e595 = phi_3016_;
                                if _e593 {
                                    if ((_e591.member_1 & 2147483648u) != 0u) {
                                        phi_5357_ = _e552;
                                        phi_3035_ = _e554;
                                        phi_3038_ = type_8(0u, ((_e591.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e917 = phi_5357_;
                                            let _e919 = phi_3035_;
                                            let _e921 = phi_3038_;
                                            local_18 = _e919;
                                            if (_e921.member < _e921.member_1) {
                                                phi_3039_ = type_8((_e921.member + 1u), _e921.member_1);
                                                phi_3061_ = type_8(1u, _e921.member);
                                            } else {
                                                phi_3039_ = _e921;
                                                phi_3061_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e934 = phi_3039_;
                                            let _e936 = phi_3061_;
                                            let _e940 = (bitcast<i32>(_e936.member) != 0i);
                                            if _e940 {
                                                local_1 = array<f32, 3>(_e591.member.member[0], _e591.member.member[1], _e591.member.member[2]);
                                                local = array<f32, 3>(_e591.member.member_1[0], _e591.member.member_1[1], _e591.member.member_1[2]);
                                                let _e951 = ((_e591.member_1 & 268435455u) + _e936.member_1);
                                                let _e952 = (_e951 < arrayLength((&global_10.member)));
                                                if _e952 {
                                                    if _e952 {
                                                    } else {
                                                        phi_5362_ = true;
                                                        break;
                                                    }
                                                    let _e955 = global_10.member[_e951].member_1;
                                                    phi_3103_ = _e955;
                                                } else {
                                                    phi_3103_ = 4294967295u;
                                                }
                                                let _e957 = phi_3103_;
                                                local_12 = array<u32, 3>(_e346, _e345, _e347);
                                                if _e952 {
                                                    if _e952 {
                                                    } else {
                                                        phi_5362_ = true;
                                                        break;
                                                    }
                                                    let _e960 = global_10.member[_e951];
                                                    phi_3127_ = _e960;
                                                } else {
                                                    phi_3127_ = type_55(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e962 = phi_3127_;
                                                local_14 = array<u32, 3>(_e962.member[0], _e962.member[1], _e962.member[2]);
                                                local_13[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_13[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_13[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_5353_ = _e917;
                                                phi_3138_ = type_8(0u, 3u);
                                                loop {
                                                    let _e972 = phi_5353_;
                                                    let _e974 = phi_3138_;
                                                    if (_e974.member < _e974.member_1) {
                                                        phi_3139_ = type_8((_e974.member + 1u), _e974.member_1);
                                                        phi_3162_ = type_8(1u, _e974.member);
                                                    } else {
                                                        phi_3139_ = _e974;
                                                        phi_3162_ = type_8(0u, type_8().member_1);
                                                    }
                                                    let _e987 = phi_3139_;
                                                    let _e989 = phi_3162_;
                                                    let _e993 = (bitcast<i32>(_e989.member) != 0i);
                                                    if _e993 {
                                                        phi_3172_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e995 = phi_3172_;
                                                            if (_e995.member < _e995.member_1) {
                                                                phi_3173_ = type_8((_e995.member + 1u), _e995.member_1);
                                                                phi_3196_ = type_8(1u, _e995.member);
                                                            } else {
                                                                phi_3173_ = _e995;
                                                                phi_3196_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1008 = phi_3173_;
                                                            let _e1010 = phi_3196_;
                                                            let _e1014 = (bitcast<i32>(_e1010.member) != 0i);
                                                            if _e1014 {
                                                                let _e1015 = (_e989.member_1 < 3u);
                                                                if _e1015 {
                                                                } else {
                                                                    phi_5348_ = true;
                                                                    break;
                                                                }
                                                                let _e1017 = local_14[_e989.member_1];
                                                                let _e1018 = (_e1010.member_1 < 3u);
                                                                if _e1018 {
                                                                } else {
                                                                    phi_5348_ = true;
                                                                    break;
                                                                }
                                                                let _e1020 = local_12[_e1010.member_1];
                                                                let _e1025 = ((_e1017 >> bitcast<u32>(((10u * _e1020) & 31u))) & 1023u);
                                                                if _e1018 {
                                                                } else {
                                                                    phi_5348_ = true;
                                                                    break;
                                                                }
                                                                let _e1027 = local_1[_e1010.member_1];
                                                                if _e1018 {
                                                                } else {
                                                                    phi_5348_ = true;
                                                                    break;
                                                                }
                                                                let _e1029 = local[_e1010.member_1];
                                                                let _e1040 = (_e1027 + bitcast<f32>((bitcast<u32>((f32(_e1025) * bitcast<f32>((bitcast<u32>(((_e1029 - _e1027) * 0.0009775171f)) ^ _e139)))) ^ _e139)));
                                                                if _e1015 {
                                                                } else {
                                                                    phi_5348_ = true;
                                                                    break;
                                                                }
                                                                if _e1018 {
                                                                } else {
                                                                    phi_5348_ = true;
                                                                    break;
                                                                }
                                                                local_13[_e989.member_1][_e1010.member_1] = select(select(_e1029, _e1040, (_e1040 < _e1029)), _e1029, (_e1025 == 1023u));
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_3172_ = _e1008;
                                                                phi_5348_ = _e972;
                                                                break if !(_e1014);
                                                            }
                                                        }
                                                        let _e1049 = phi_5348_;
                                                        phi_5360_ = _e1049;
                                                        if _e1049 {
                                                            break;
                                                        }
                                                        phi_5361_ = _e1049;
                                                    } else {
                                                        phi_5361_ = _e972;
                                                    }
                                                    let _e1051 = phi_5361_;
                                                    continue;
                                                    continuing {
                                                        phi_5353_ = _e1051;
                                                        phi_3138_ = _e987;
                                                        phi_5360_ = _e1051;
                                                        break if !(_e993);
                                                    }
                                                }
                                                let _e1054 = phi_5360_;
                                                phi_5362_ = _e1054;
                                                if _e1054 {
                                                    break;
                                                }
                                                let _e1055 = local_13;
                                                let _e1071 = (_e1055[0][2] - _e447);
                                                let _e1074 = (((_e1055[0][0] - _e374) * _e471) - (_e1071 * _e399));
                                                let _e1077 = (((_e1055[0][1] - _e411) * _e471) - (_e1071 * _e435));
                                                let _e1080 = (_e1055[1][2] - _e447);
                                                let _e1083 = (((_e1055[1][0] - _e374) * _e471) - (_e1080 * _e399));
                                                let _e1086 = (((_e1055[1][1] - _e411) * _e471) - (_e1080 * _e435));
                                                let _e1089 = (_e1055[2][2] - _e447);
                                                let _e1092 = (((_e1055[2][0] - _e374) * _e471) - (_e1089 * _e399));
                                                let _e1095 = (((_e1055[2][1] - _e411) * _e471) - (_e1089 * _e435));
                                                let _e1096 = (_e1092 * _e1086);
                                                let _e1097 = (_e1095 * _e1083);
                                                let _e1098 = (_e1074 * _e1095);
                                                let _e1099 = (_e1077 * _e1092);
                                                let _e1100 = (_e1083 * _e1077);
                                                let _e1101 = (_e1086 * _e1074);
                                                let _e1106 = (((_e1096 >= _e1097) && (_e1098 >= _e1099)) && (_e1100 >= _e1101));
                                                if (_e1106 || (((_e1096 <= _e1097) && (_e1098 <= _e1099)) && (_e1100 <= _e1101))) {
                                                    let _e1113 = select(-1f, 1f, _e1106);
                                                    let _e1115 = ((_e1096 - _e1097) * _e1113);
                                                    let _e1117 = select(0f, _e1115, (_e1115 > 0f));
                                                    let _e1119 = ((_e1098 - _e1099) * _e1113);
                                                    let _e1121 = select(0f, _e1119, (_e1119 > 0f));
                                                    let _e1123 = ((_e1100 - _e1101) * _e1113);
                                                    let _e1125 = select(0f, _e1123, (_e1123 > 0f));
                                                    let _e1127 = ((_e1117 + _e1121) + _e1125);
                                                    if (_e1127 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_3854_ = type_22();
                                                        phi_3855_ = true;
                                                    } else {
                                                        let _e1130 = select(_e1055[1][0], _e1055[0][0], (_e1055[0][0] < _e1055[1][0]));
                                                        let _e1134 = select(_e1055[1][0], _e1055[0][0], (_e1055[0][0] > _e1055[1][0]));
                                                        let _e1138 = select(_e1055[1][1], _e1055[0][1], (_e1055[0][1] < _e1055[1][1]));
                                                        let _e1142 = select(_e1055[1][1], _e1055[0][1], (_e1055[0][1] > _e1055[1][1]));
                                                        let _e1146 = select(_e1055[1][2], _e1055[0][2], (_e1055[0][2] < _e1055[1][2]));
                                                        let _e1150 = select(_e1055[1][2], _e1055[0][2], (_e1055[0][2] > _e1055[1][2]));
                                                        let _e1155 = ((select(_e1055[2][0], _e1130, (_e1130 < _e1055[2][0])) - _e397) * _e402);
                                                        let _e1156 = ((select(_e1055[2][0], _e1134, (_e1134 > _e1055[2][0])) - _e398) * _e402);
                                                        let _e1159 = ((select(_e1055[2][1], _e1138, (_e1138 < _e1055[2][1])) - _e433) * _e438);
                                                        let _e1160 = ((select(_e1055[2][1], _e1142, (_e1142 > _e1055[2][1])) - _e434) * _e438);
                                                        let _e1163 = ((select(_e1055[2][2], _e1146, (_e1146 < _e1055[2][2])) - _e469) * _e474);
                                                        let _e1164 = ((select(_e1055[2][2], _e1150, (_e1150 > _e1055[2][2])) - _e470) * _e474);
                                                        let _e1166 = select(_e1164, _e1163, (_e1163 < _e1164));
                                                        let _e1168 = select(_e1164, _e1163, (_e1163 > _e1164));
                                                        let _e1170 = select(_e1156, _e1155, (_e1155 < _e1156));
                                                        let _e1172 = select(_e1160, _e1159, (_e1159 < _e1160));
                                                        let _e1174 = select(_e1172, _e1170, (_e1170 > _e1172));
                                                        let _e1176 = select(_e1166, _e1174, (_e1174 > _e1166));
                                                        let _e1178 = select(_e1156, _e1155, (_e1155 > _e1156));
                                                        let _e1180 = select(_e1160, _e1159, (_e1159 > _e1160));
                                                        let _e1182 = select(_e1180, _e1178, (_e1178 < _e1180));
                                                        let _e1184 = select(_e1168, _e1182, (_e1182 < _e1168));
                                                        let _e1185 = -(_e1166);
                                                        let _e1191 = select(_e520, _e1176, (_e1176 > _e520));
                                                        if (_e1191 > (_e1184 + (select(_e1185, _e1168, (_e1168 > _e1185)) * 0.0000019073523f))) {
                                                            phi_3849_ = type_22();
                                                            phi_3850_ = true;
                                                        } else {
                                                            let _e1193 = (_e1191 > _e919.member_1);
                                                            if _e1193 {
                                                                phi_3848_ = type_22();
                                                            } else {
                                                                let _e1197 = (_e1055[1][0] - _e1055[0][0]);
                                                                let _e1198 = (_e1055[1][1] - _e1055[0][1]);
                                                                let _e1199 = (_e1055[1][2] - _e1055[0][2]);
                                                                let _e1200 = vec3<f32>(_e1197, _e1198, _e1199);
                                                                let _e1201 = (_e1055[2][0] - _e1055[1][0]);
                                                                let _e1202 = (_e1055[2][1] - _e1055[1][1]);
                                                                let _e1203 = (_e1055[2][2] - _e1055[1][2]);
                                                                let _e1204 = vec3<f32>(_e1201, _e1202, _e1203);
                                                                let _e1205 = (_e1055[0][0] - _e1055[2][0]);
                                                                let _e1206 = (_e1055[0][1] - _e1055[2][1]);
                                                                let _e1207 = (_e1055[0][2] - _e1055[2][2]);
                                                                let _e1208 = vec3<f32>(_e1205, _e1206, _e1207);
                                                                let _e1211 = bitcast<f32>((bitcast<u32>(_e1197) & 2147483647u));
                                                                let _e1214 = bitcast<f32>((bitcast<u32>(_e1198) & 2147483647u));
                                                                let _e1216 = select(_e1214, _e1211, (_e1211 > _e1214));
                                                                let _e1219 = bitcast<f32>((bitcast<u32>(_e1199) & 2147483647u));
                                                                let _e1221 = select(_e1219, _e1216, (_e1216 > _e1219));
                                                                let _e1224 = bitcast<f32>((bitcast<u32>(_e1201) & 2147483647u));
                                                                let _e1227 = bitcast<f32>((bitcast<u32>(_e1202) & 2147483647u));
                                                                let _e1229 = select(_e1227, _e1224, (_e1224 > _e1227));
                                                                let _e1232 = bitcast<f32>((bitcast<u32>(_e1203) & 2147483647u));
                                                                let _e1234 = select(_e1232, _e1229, (_e1229 > _e1232));
                                                                let _e1237 = bitcast<f32>((bitcast<u32>(_e1205) & 2147483647u));
                                                                let _e1240 = bitcast<f32>((bitcast<u32>(_e1206) & 2147483647u));
                                                                let _e1242 = select(_e1240, _e1237, (_e1237 > _e1240));
                                                                let _e1245 = bitcast<f32>((bitcast<u32>(_e1207) & 2147483647u));
                                                                let _e1247 = select(_e1245, _e1242, (_e1242 > _e1245));
                                                                let _e1249 = select(_e1234, _e1221, (_e1221 > _e1234));
                                                                let _e1251 = select(_e1247, _e1249, (_e1249 > _e1247));
                                                                if (_e1221 == _e1251) {
                                                                    phi_3759_ = _e1204;
                                                                    phi_3760_ = _e1208;
                                                                } else {
                                                                    let _e1254 = vec3((_e1234 == _e1251));
                                                                    phi_3759_ = select(_e1200, _e1208, _e1254);
                                                                    phi_3760_ = select(_e1204, _e1200, _e1254);
                                                                }
                                                                let _e1258 = phi_3759_;
                                                                let _e1260 = phi_3760_;
                                                                let _e1267 = ((_e1258.y * _e1260.z) - (_e1260.y * _e1258.z));
                                                                let _e1272 = ((_e1258.z * _e1260.x) - (_e1260.z * _e1258.x));
                                                                let _e1275 = ((_e1258.x * _e1260.y) - (_e1260.x * _e1258.y));
                                                                if (_e1117 >= _e1121) {
                                                                    phi_3791_ = select(true, false, (_e1117 >= _e1125));
                                                                } else {
                                                                    phi_3791_ = true;
                                                                }
                                                                let _e1280 = phi_3791_;
                                                                if _e1280 {
                                                                    phi_3800_ = select(vec3<f32>(_e1055[2][0], _e1055[2][1], _e1055[2][2]), vec3<f32>(_e1055[1][0], _e1055[1][1], _e1055[1][2]), vec3((_e1121 >= _e1125)));
                                                                } else {
                                                                    phi_3800_ = vec3<f32>(_e1055[0][0], _e1055[0][1], _e1055[0][2]);
                                                                }
                                                                let _e1285 = phi_3800_;
                                                                let _e1302 = ((((_e1267 * (_e1285.x - _e374)) + (_e1272 * (_e1285.y - _e411))) + (_e1275 * (_e1285.z - _e447))) / (((_e1267 * _e399) + (_e1272 * _e435)) + (_e1275 * _e471)));
                                                                let _e1304 = select(_e1184, _e1302, (_e1302 < _e1184));
                                                                let _e1306 = select(_e1176, _e1304, (_e1304 > _e1176));
                                                                if (_e1306 >= _e520) {
                                                                    let _e1308 = (_e1306 <= _e919.member_1);
                                                                    if _e1308 {
                                                                        let _e1309 = (1f / _e1127);
                                                                        phi_3840_ = type_22(_e1306, (_e1121 * _e1309), (_e1125 * _e1309), _e957);
                                                                    } else {
                                                                        phi_3840_ = type_22();
                                                                    }
                                                                    let _e1314 = phi_3840_;
                                                                    phi_3842_ = _e1314;
                                                                    phi_3843_ = select(true, false, _e1308);
                                                                } else {
                                                                    phi_3842_ = type_22();
                                                                    phi_3843_ = true;
                                                                }
                                                                let _e1317 = phi_3842_;
                                                                let _e1319 = phi_3843_;
                                                                if _e1319 {
                                                                    phi_3847_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_3847_ = _e1317;
                                                                }
                                                                let _e1321 = phi_3847_;
                                                                phi_3848_ = _e1321;
                                                            }
                                                            let _e1323 = phi_3848_;
                                                            phi_3849_ = _e1323;
                                                            phi_3850_ = _e1193;
                                                        }
                                                        let _e1325 = phi_3849_;
                                                        let _e1327 = phi_3850_;
                                                        phi_3854_ = _e1325;
                                                        phi_3855_ = _e1327;
                                                    }
                                                    let _e1329 = phi_3854_;
                                                    let _e1331 = phi_3855_;
                                                    phi_3859_ = _e1329;
                                                    phi_3860_ = _e1331;
                                                } else {
                                                    phi_3859_ = type_22();
                                                    phi_3860_ = true;
                                                }
                                                let _e1333 = phi_3859_;
                                                let _e1335 = phi_3860_;
                                                if _e1335 {
                                                    phi_3864_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_3864_ = _e1333;
                                                }
                                                let _e1337 = phi_3864_;
                                                if (_e1337.member_3 != 4294967295u) {
                                                    if (_e957 == _e156) {
                                                        phi_4193_ = false;
                                                    } else {
                                                        let _e1341 = (_e957 < arrayLength((&global_4.member)));
                                                        if _e1341 {
                                                            if _e1341 {
                                                            } else {
                                                                phi_5362_ = true;
                                                                break;
                                                            }
                                                            let _e1343 = global_4.member[_e957];
                                                            phi_3887_ = _e1343;
                                                        } else {
                                                            phi_3887_ = 4294967295u;
                                                        }
                                                        let _e1345 = phi_3887_;
                                                        let _e1346 = (_e1345 < arrayLength((&global_5.member)));
                                                        if _e1346 {
                                                            if _e1346 {
                                                            } else {
                                                                phi_5362_ = true;
                                                                break;
                                                            }
                                                            let _e1348 = global_5.member[_e1345];
                                                            phi_3901_ = _e1348;
                                                        } else {
                                                            phi_3901_ = 0i;
                                                        }
                                                        let _e1350 = phi_3901_;
                                                        let _e1351 = (_e1350 == 0i);
                                                        if _e1351 {
                                                            phi_4192_ = true;
                                                        } else {
                                                            if _e366 {
                                                                phi_3922_ = vec3<f32>(_e1055[0][0], _e1055[0][1], _e1055[0][2]);
                                                            } else {
                                                                if (_e346 == 1u) {
                                                                    phi_3921_ = vec3<f32>(_e1055[0][2], _e1055[0][0], _e1055[0][1]);
                                                                } else {
                                                                    phi_3921_ = vec3<f32>(_e1055[0][1], _e1055[0][2], _e1055[0][0]);
                                                                }
                                                                let _e1356 = phi_3921_;
                                                                phi_3922_ = _e1356;
                                                            }
                                                            let _e1359 = phi_3922_;
                                                            if _e366 {
                                                                phi_3939_ = vec3<f32>(_e1055[1][0], _e1055[1][1], _e1055[1][2]);
                                                            } else {
                                                                if (_e346 == 1u) {
                                                                    phi_3938_ = vec3<f32>(_e1055[1][2], _e1055[1][0], _e1055[1][1]);
                                                                } else {
                                                                    phi_3938_ = vec3<f32>(_e1055[1][1], _e1055[1][2], _e1055[1][0]);
                                                                }
                                                                let _e1364 = phi_3938_;
                                                                phi_3939_ = _e1364;
                                                            }
                                                            let _e1367 = phi_3939_;
                                                            if _e366 {
                                                                phi_3956_ = vec3<f32>(_e1055[2][0], _e1055[2][1], _e1055[2][2]);
                                                            } else {
                                                                if (_e346 == 1u) {
                                                                    phi_3955_ = vec3<f32>(_e1055[2][2], _e1055[2][0], _e1055[2][1]);
                                                                } else {
                                                                    phi_3955_ = vec3<f32>(_e1055[2][1], _e1055[2][2], _e1055[2][0]);
                                                                }
                                                                let _e1372 = phi_3955_;
                                                                phi_3956_ = _e1372;
                                                            }
                                                            let _e1375 = phi_3956_;
                                                            let _e1378 = (_e1367.x - _e1359.x);
                                                            let _e1381 = (_e1367.y - _e1359.y);
                                                            let _e1384 = (_e1367.z - _e1359.z);
                                                            let _e1386 = (_e1375.x - _e1359.x);
                                                            let _e1388 = (_e1375.y - _e1359.y);
                                                            let _e1390 = (_e1375.z - _e1359.z);
                                                            if (_e224.member_1 == 1u) {
                                                                phi_3992_ = (vec3<f32>(_e224.member[0], _e224.member[1], _e224.member[2]) - _e1359);
                                                            } else {
                                                                phi_3992_ = vec3<f32>(_e224.member[0], _e224.member[1], _e224.member[2]);
                                                            }
                                                            let _e1405 = phi_3992_;
                                                            let _e1411 = bitcast<f32>((bitcast<u32>((_e1378 * _e1388)) ^ _e224.member_3[0]));
                                                            let _e1415 = bitcast<f32>((bitcast<u32>((_e1381 * _e1386)) ^ _e224.member_3[0]));
                                                            let _e1419 = bitcast<f32>((bitcast<u32>((_e1381 * _e1390)) ^ _e224.member_3[0]));
                                                            let _e1423 = bitcast<f32>((bitcast<u32>((_e1384 * _e1388)) ^ _e224.member_3[0]));
                                                            let _e1427 = bitcast<f32>((bitcast<u32>((_e1384 * _e1386)) ^ _e224.member_3[0]));
                                                            let _e1431 = bitcast<f32>((bitcast<u32>((_e1378 * _e1390)) ^ _e224.member_3[0]));
                                                            let _e1432 = (_e1419 - _e1423);
                                                            let _e1433 = (_e1427 - _e1431);
                                                            let _e1434 = (_e1411 - _e1415);
                                                            let _e1458 = (bitcast<f32>((bitcast<u32>(_e1419) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1423) & 2147483647u)));
                                                            let _e1465 = (bitcast<f32>((bitcast<u32>(_e1427) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1431) & 2147483647u)));
                                                            let _e1472 = (bitcast<f32>((bitcast<u32>(_e1411) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1415) & 2147483647u)));
                                                            if (_e224.member_2 == 0f) {
                                                                phi_4174_ = 0f;
                                                            } else {
                                                                let _e1502 = bitcast<f32>((bitcast<u32>(_e1432) & 2147483647u));
                                                                let _e1505 = bitcast<f32>((bitcast<u32>(_e1433) & 2147483647u));
                                                                let _e1508 = bitcast<f32>((bitcast<u32>(_e1434) & 2147483647u));
                                                                let _e1510 = select(_e1508, _e1505, (_e1505 > _e1508));
                                                                let _e1514 = select(_e1508, _e1505, (_e1505 < _e1508));
                                                                let _e1518 = select(_e1505, _e1502, (_e1502 < _e1505));
                                                                let _e1520 = select(_e1505, _e1502, (_e1502 > _e1505));
                                                                let _e1522 = select(_e1508, _e1520, (_e1520 < _e1508));
                                                                phi_4174_ = bitcast<f32>((bitcast<u32>((_e224.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1510, _e1502, (_e1502 > _e1510)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1522, _e1518, (_e1518 > _e1522)))) ^ _e224.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1514, _e1502, (_e1502 < _e1514)))) ^ _e224.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1458 + _e1465) + _e1472))) ^ _e224.member_3[0]))) * 1.0000005f)) ^ _e224.member_3[0])))) ^ _e224.member_3[0]));
                                                            }
                                                            let _e1549 = phi_4174_;
                                                            phi_4192_ = (_e1351 || !(((((bitcast<f32>((bitcast<u32>((_e1405.x * _e1432)) ^ _e224.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1405.y * _e1433)) ^ _e224.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1405.z * _e1434)) ^ _e224.member_3[0]))) * f32(-(_e1350))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1405.x) & 2147483647u)) * _e1458)) ^ _e224.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1405.y) & 2147483647u)) * _e1465)) ^ _e224.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1405.z) & 2147483647u)) * _e1472)) ^ _e224.member_3[0]))))) ^ _e224.member_3[0])) + _e1549) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1563 = phi_4192_;
                                                        phi_4193_ = _e1563;
                                                    }
                                                    let _e1565 = phi_4193_;
                                                    if _e1565 {
                                                        if (_e1337.member < _e919.member.member) {
                                                            phi_4213_ = true;
                                                        } else {
                                                            if (_e1337.member == _e919.member.member) {
                                                                phi_4212_ = (_e1337.member_3 < _e919.member.member_3);
                                                            } else {
                                                                phi_4212_ = false;
                                                            }
                                                            let _e1575 = phi_4212_;
                                                            phi_4213_ = _e1575;
                                                        }
                                                        let _e1577 = phi_4213_;
                                                        if _e1577 {
                                                            phi_4219_ = type_37(_e1337, _e1337.member);
                                                        } else {
                                                            phi_4219_ = _e919;
                                                        }
                                                        let _e1580 = phi_4219_;
                                                        phi_4220_ = _e1580;
                                                    } else {
                                                        phi_4220_ = _e919;
                                                    }
                                                    let _e1582 = phi_4220_;
                                                    phi_4221_ = _e1582;
                                                } else {
                                                    phi_4221_ = _e919;
                                                }
                                                let _e1584 = phi_4221_;
                                                phi_5363_ = _e1054;
                                                phi_3036_ = _e1584;
                                            } else {
                                                phi_5363_ = _e917;
                                                phi_3036_ = type_37();
                                            }
                                            let _e1586 = phi_5363_;
                                            let _e1588 = phi_3036_;
                                            continue;
                                            continuing {
                                                phi_5357_ = _e1586;
                                                phi_3035_ = _e1588;
                                                phi_3038_ = _e934;
                                                phi_5362_ = _e1586;
                                                break if !(_e940);
                                            }
                                        }
                                        let _e1591 = phi_5362_;
                                        phi_5441_ = _e1591;
                                        if _e1591 {
                                            break;
                                        }
                                        phi_5445_ = _e1591;
                                        let _e1817 = local_18;
                                        phi_5065_ = _e1817;
                                        phi_5066_ = _e591;
                                        phi_5067_ = false;
                                        phi_5068_ = _e595;
                                    } else {
                                        local_3 = array<f32, 3>(_e591.member.member[0], _e591.member.member[1], _e591.member.member[2]);
                                        local_2 = array<f32, 3>(_e591.member.member_1[0], _e591.member.member_1[1], _e591.member.member_1[2]);
                                        let _e615 = (_e591.member_1 < _e96);
                                        if _e615 {
                                            if _e615 {
                                            } else {
                                                phi_5441_ = true;
                                                break;
                                            }
                                            let _e617 = global_9.member[_e591.member_1];
                                            phi_4255_ = _e617;
                                        } else {
                                            phi_4255_ = type_47(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e619 = phi_4255_;
                                        let _e621 = array<u32, 3>(_e346, _e345, _e347);
                                        local_11 = _e621;
                                        local_7 = array<f32, 3>(0f, 0f, 0f);
                                        local_6 = array<f32, 3>(0f, 0f, 0f);
                                        phi_4264_ = type_8(0u, 3u);
                                        loop {
                                            let _e623 = phi_4264_;
                                            if (_e623.member < _e623.member_1) {
                                                phi_4265_ = type_8((_e623.member + 1u), _e623.member_1);
                                                phi_4288_ = type_8(1u, _e623.member);
                                            } else {
                                                phi_4265_ = _e623;
                                                phi_4288_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e636 = phi_4265_;
                                            let _e638 = phi_4288_;
                                            let _e642 = (bitcast<i32>(_e638.member) != 0i);
                                            if _e642 {
                                                let _e643 = (_e638.member_1 < 3u);
                                                if _e643 {
                                                } else {
                                                    phi_5282_ = true;
                                                    break;
                                                }
                                                let _e645 = local_11[_e638.member_1];
                                                if _e643 {
                                                } else {
                                                    phi_5282_ = true;
                                                    break;
                                                }
                                                let _e647 = local_3[_e638.member_1];
                                                if _e643 {
                                                } else {
                                                    phi_5282_ = true;
                                                    break;
                                                }
                                                let _e649 = local_2[_e638.member_1];
                                                let _e652 = ((10u * _e645) & 31u);
                                                let _e655 = ((_e619.member[0] >> bitcast<u32>(_e652)) & 1023u);
                                                let _e660 = bitcast<f32>((bitcast<u32>(((_e649 - _e647) * 0.0009775171f)) ^ _e139));
                                                let _e666 = (_e647 + bitcast<f32>((bitcast<u32>((f32(_e655) * _e660)) ^ _e139)));
                                                if _e643 {
                                                } else {
                                                    phi_5282_ = true;
                                                    break;
                                                }
                                                local_7[_e638.member_1] = select(select(_e649, _e666, (_e666 < _e649)), _e649, (_e655 == 1023u));
                                                let _e675 = ((_e619.member[1] >> bitcast<u32>(_e652)) & 1023u);
                                                let _e681 = (_e647 + bitcast<f32>((bitcast<u32>((f32(_e675) * _e660)) ^ _e139)));
                                                if _e643 {
                                                } else {
                                                    phi_5282_ = true;
                                                    break;
                                                }
                                                local_6[_e638.member_1] = select(select(_e649, _e681, (_e681 < _e649)), _e649, (_e675 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_4264_ = _e636;
                                                phi_5282_ = _e552;
                                                break if !(_e642);
                                            }
                                        }
                                        let _e689 = phi_5282_;
                                        phi_5441_ = _e689;
                                        if _e689 {
                                            break;
                                        }
                                        let _e690 = local_6;
                                        let _e691 = local_7;
                                        local_10 = _e621;
                                        local_9 = array<f32, 3>(0f, 0f, 0f);
                                        local_8 = array<f32, 3>(0f, 0f, 0f);
                                        phi_4418_ = type_8(0u, 3u);
                                        loop {
                                            let _e700 = phi_4418_;
                                            if (_e700.member < _e700.member_1) {
                                                phi_4419_ = type_8((_e700.member + 1u), _e700.member_1);
                                                phi_4442_ = type_8(1u, _e700.member);
                                            } else {
                                                phi_4419_ = _e700;
                                                phi_4442_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e713 = phi_4419_;
                                            let _e715 = phi_4442_;
                                            let _e719 = (bitcast<i32>(_e715.member) != 0i);
                                            if _e719 {
                                                let _e720 = (_e715.member_1 < 3u);
                                                if _e720 {
                                                } else {
                                                    phi_5340_ = true;
                                                    break;
                                                }
                                                let _e722 = local_10[_e715.member_1];
                                                if _e720 {
                                                } else {
                                                    phi_5340_ = true;
                                                    break;
                                                }
                                                let _e724 = local_3[_e715.member_1];
                                                if _e720 {
                                                } else {
                                                    phi_5340_ = true;
                                                    break;
                                                }
                                                let _e726 = local_2[_e715.member_1];
                                                let _e729 = ((10u * _e722) & 31u);
                                                let _e732 = ((_e619.member_1[0] >> bitcast<u32>(_e729)) & 1023u);
                                                let _e737 = bitcast<f32>((bitcast<u32>(((_e726 - _e724) * 0.0009775171f)) ^ _e139));
                                                let _e743 = (_e724 + bitcast<f32>((bitcast<u32>((f32(_e732) * _e737)) ^ _e139)));
                                                if _e720 {
                                                } else {
                                                    phi_5340_ = true;
                                                    break;
                                                }
                                                local_9[_e715.member_1] = select(select(_e726, _e743, (_e743 < _e726)), _e726, (_e732 == 1023u));
                                                let _e752 = ((_e619.member_1[1] >> bitcast<u32>(_e729)) & 1023u);
                                                let _e758 = (_e724 + bitcast<f32>((bitcast<u32>((f32(_e752) * _e737)) ^ _e139)));
                                                if _e720 {
                                                } else {
                                                    phi_5340_ = true;
                                                    break;
                                                }
                                                local_8[_e715.member_1] = select(select(_e726, _e758, (_e758 < _e726)), _e726, (_e752 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_4418_ = _e713;
                                                phi_5340_ = _e689;
                                                break if !(_e719);
                                            }
                                        }
                                        let _e766 = phi_5340_;
                                        phi_5441_ = _e766;
                                        if _e766 {
                                            break;
                                        }
                                        let _e767 = local_8;
                                        let _e768 = local_9;
                                        let _e779 = type_61(type_52(array<f32, 3>(_e691[0], _e691[1], _e691[2]), array<f32, 3>(_e690[0], _e690[1], _e690[2])), _e619.member_2);
                                        let _e784 = type_61(type_52(array<f32, 3>(_e768[0], _e768[1], _e768[2]), array<f32, 3>(_e767[0], _e767[1], _e767[2])), _e619.member_3);
                                        let _e790 = ((_e691[0] - _e397) * _e402);
                                        let _e791 = ((_e768[0] - _e397) * _e402);
                                        let _e792 = ((_e690[0] - _e398) * _e402);
                                        let _e793 = ((_e767[0] - _e398) * _e402);
                                        let _e798 = ((_e691[1] - _e433) * _e438);
                                        let _e799 = ((_e768[1] - _e433) * _e438);
                                        let _e800 = ((_e690[1] - _e434) * _e438);
                                        let _e801 = ((_e767[1] - _e434) * _e438);
                                        let _e806 = ((_e691[2] - _e469) * _e474);
                                        let _e807 = ((_e768[2] - _e469) * _e474);
                                        let _e808 = ((_e690[2] - _e470) * _e474);
                                        let _e809 = ((_e767[2] - _e470) * _e474);
                                        let _e811 = select(_e808, _e806, (_e806 < _e808));
                                        let _e813 = select(_e809, _e807, (_e807 < _e809));
                                        let _e815 = select(_e808, _e806, (_e806 > _e808));
                                        let _e817 = select(_e809, _e807, (_e807 > _e809));
                                        let _e819 = select(_e792, _e790, (_e790 < _e792));
                                        let _e821 = select(_e793, _e791, (_e791 < _e793));
                                        let _e823 = select(_e800, _e798, (_e798 < _e800));
                                        let _e825 = select(_e801, _e799, (_e799 < _e801));
                                        let _e827 = select(_e823, _e819, (_e819 > _e823));
                                        let _e829 = select(_e825, _e821, (_e821 > _e825));
                                        let _e831 = select(_e811, _e827, (_e827 > _e811));
                                        let _e833 = select(_e813, _e829, (_e829 > _e813));
                                        let _e835 = select(_e792, _e790, (_e790 > _e792));
                                        let _e837 = select(_e793, _e791, (_e791 > _e793));
                                        let _e839 = select(_e800, _e798, (_e798 > _e800));
                                        let _e841 = select(_e801, _e799, (_e799 > _e801));
                                        let _e843 = select(_e839, _e835, (_e835 < _e839));
                                        let _e845 = select(_e841, _e837, (_e837 < _e841));
                                        let _e850 = -(_e811);
                                        let _e851 = -(_e813);
                                        let _e858 = (select(_e815, _e843, (_e843 < _e815)) + (select(_e850, _e815, (_e815 > _e850)) * 0.0000019073523f));
                                        let _e859 = (select(_e817, _e845, (_e845 < _e817)) + (select(_e851, _e817, (_e817 > _e851)) * 0.0000019073523f));
                                        let _e861 = select(_e520, _e831, (_e831 > _e520));
                                        let _e863 = select(_e520, _e833, (_e833 > _e520));
                                        let _e868 = (_e861 <= select(_e554.member_1, _e858, (_e858 < _e554.member_1)));
                                        let _e869 = (_e863 <= select(_e554.member_1, _e859, (_e859 < _e554.member_1)));
                                        let _e870 = (_e861 <= _e863);
                                        if _e868 {
                                            if _e869 {
                                                if _e870 {
                                                    phi_5005_ = _e784;
                                                } else {
                                                    phi_5005_ = _e779;
                                                }
                                                let _e872 = phi_5005_;
                                                let _e873 = (_e595 % 128u);
                                                let _e874 = (_e873 < 128u);
                                                if _e874 {
                                                } else {
                                                    phi_5441_ = true;
                                                    break;
                                                }
                                                local_5[_e873] = type_61(type_52(array<f32, 3>(_e872.member.member[0], _e872.member.member[1], _e872.member.member[2]), array<f32, 3>(_e872.member.member_1[0], _e872.member.member_1[1], _e872.member.member_1[2])), _e872.member_1);
                                                if _e874 {
                                                } else {
                                                    phi_5441_ = true;
                                                    break;
                                                }
                                                local_4[_e873] = select(_e863, _e861, (_e861 > _e863));
                                                if _e870 {
                                                    phi_5044_ = _e779;
                                                } else {
                                                    phi_5044_ = _e784;
                                                }
                                                let _e895 = phi_5044_;
                                                phi_5045_ = _e895;
                                                phi_5046_ = (_e595 + 1u);
                                            } else {
                                                phi_5045_ = type_61();
                                                phi_5046_ = u32();
                                            }
                                            let _e897 = phi_5045_;
                                            let _e899 = phi_5046_;
                                            phi_5048_ = _e897;
                                            phi_5049_ = _e899;
                                            phi_5050_ = select(true, false, _e869);
                                        } else {
                                            phi_5048_ = type_61();
                                            phi_5049_ = u32();
                                            phi_5050_ = true;
                                        }
                                        let _e902 = phi_5048_;
                                        let _e904 = phi_5049_;
                                        let _e906 = phi_5050_;
                                        if _e906 {
                                            if _e868 {
                                                phi_5057_ = _e779;
                                            } else {
                                                phi_5057_ = _e784;
                                            }
                                            let _e908 = phi_5057_;
                                            phi_5062_ = _e908;
                                            phi_5063_ = select(_e869, true, _e868);
                                        } else {
                                            phi_5062_ = _e902;
                                            phi_5063_ = _e593;
                                        }
                                        let _e911 = phi_5062_;
                                        let _e913 = phi_5063_;
                                        phi_5445_ = _e766;
                                        phi_5065_ = _e554;
                                        phi_5066_ = _e911;
                                        phi_5067_ = _e913;
                                        phi_5068_ = select(_e904, _e595, _e906);
                                    }
                                    let _e1593 = phi_5445_;
                                    let _e1595 = phi_5065_;
                                    let _e1597 = phi_5066_;
                                    let _e1599 = phi_5067_;
                                    let _e1601 = phi_5068_;
                                    phi_5444_ = _e1593;
                                    phi_5069_ = _e1595;
                                    phi_5070_ = _e1597;
                                    phi_5071_ = (_e558 - 1u);
                                    phi_5072_ = _e1599;
                                    phi_5073_ = _e1601;
                                } else {
                                    phi_5444_ = _e552;
                                    phi_5069_ = _e554;
                                    phi_5070_ = _e591;
                                    phi_5071_ = _e558;
                                    phi_5072_ = _e593;
                                    phi_5073_ = _e595;
                                }
                                let _e1603 = phi_5444_;
                                let _e1605 = phi_5069_;
                                let _e1607 = phi_5070_;
                                let _e1609 = phi_5071_;
                                let _e1611 = phi_5072_;
                                let _e1613 = phi_5073_;
                                phi_5443_ = _e1603;
                                phi_5074_ = _e1605;
                                phi_5075_ = _e1607;
                                phi_5076_ = _e1609;
                                phi_5077_ = _e1611;
                                phi_5078_ = _e1613;
                            } else {
                                phi_5443_ = _e552;
                                phi_5074_ = type_37();
                                phi_5075_ = type_61();
                                phi_5076_ = u32();
                                phi_5077_ = bool();
                                phi_5078_ = u32();
                            }
                            let _e1615 = phi_5443_;
                            let _e1617 = phi_5074_;
                            let _e1619 = phi_5075_;
                            let _e1621 = phi_5076_;
                            let _e1623 = phi_5077_;
                            let _e1625 = phi_5078_;
                            phi_5442_ = _e1615;
                            phi_2950_ = _e1617;
                            phi_2953_ = _e1619;
                            phi_2955_ = _e1621;
                            phi_2957_ = _e1623;
                            phi_2959_ = _e1625;
                            phi_5079_ = _e566;
                        } else {
                            phi_5442_ = _e552;
                            phi_2950_ = type_37();
                            phi_2953_ = type_61();
                            phi_2955_ = u32();
                            phi_2957_ = bool();
                            phi_2959_ = u32();
                            phi_5079_ = false;
                        }
                        let _e1627 = phi_5442_;
                        let _e1629 = phi_2950_;
                        let _e1631 = phi_2953_;
                        let _e1633 = phi_2955_;
                        let _e1635 = phi_2957_;
                        let _e1637 = phi_2959_;
                        let _e1639 = phi_5079_;
                        continue;
                        continuing {
                            phi_5289_ = _e1627;
                            phi_2949_ = _e1629;
                            phi_2952_ = _e1631;
                            phi_2954_ = _e1633;
                            phi_2956_ = _e1635;
                            phi_2958_ = _e1637;
                            phi_5441_ = _e1627;
                            break if !(_e1639);
                        }
                    }
                    let _e1642 = phi_5441_;
                    if _e1642 {
                        break;
                    }
                    let _e1644 = local_17;
                    if (_e1644.member.member_3 != 4294967295u) {
                        let _e1649 = (_e348 / 3i);
                        let _e1656 = bitcast<f32>((bitcast<u32>((_e1649 + 127i)) << bitcast<u32>(23i)));
                        let _e1664 = (((_e1644.member.member * _e1656) * _e1656) * bitcast<f32>((bitcast<u32>(((_e348 - (2i * _e1649)) + 127i)) << bitcast<u32>(23i))));
                        let _e1666 = select(340282350000000000000000000000000000000f, _e1664, (_e1664 < 340282350000000000000000000000000000000f));
                        phi_5131_ = type_22(select(-340282350000000000000000000000000000000f, _e1666, (_e1666 > -340282350000000000000000000000000000000f)), _e1644.member.member_1, _e1644.member.member_2, _e1644.member.member_3);
                    } else {
                        phi_5131_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1673 = phi_5131_;
                    if _e225 {
                    } else {
                        break;
                    }
                    global_7.member[_e143] = _e1673;
                    if _e150 {
                    } else {
                        break;
                    }
                    let _e1677 = select(0u, 1u, (_e292 <= _e302));
                    if (_e1677 > 0u) {
                        let _e1679 = (1u < _e111);
                        if _e1679 {
                            if (0u < _e111) {
                            } else {
                                break;
                            }
                            let _e1683 = atomicAdd((&global_8.member[0u]), _e1677);
                            if ((_e1683 + _e1677) < _e1683) {
                                if _e1679 {
                                } else {
                                    break;
                                }
                                let _e1688 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1691 = select(0u, 1u, (_e1673.member_3 != 4294967295u));
                    if (_e1691 > 0u) {
                        let _e1693 = (3u < _e111);
                        if _e1693 {
                            if (2u < _e111) {
                            } else {
                                break;
                            }
                            let _e1697 = atomicAdd((&global_8.member[2u]), _e1691);
                            if ((_e1697 + _e1691) < _e1697) {
                                if _e1693 {
                                } else {
                                    break;
                                }
                                let _e1702 = atomicAdd((&global_8.member[3u]), 1u);
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
fn trace_paths_printed_leaf10_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
