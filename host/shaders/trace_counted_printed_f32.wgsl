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

struct type_31 {
    member: type_25,
    member_1: f32,
}

struct type_35 {
    member: array<type_26>,
}

struct type_37 {
    member: type_31,
    member_1: u32,
    member_2: u32,
}

struct type_39 {
    member: array<vec4<u32>, 2>,
}

struct type_41 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_43 {
    member: array<type_41>,
}

struct type_47 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_50 {
    member: type_47,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(3) 
var<storage> global_2: type_15;
@group(0) @binding(1) 
var<uniform> global_3: type_39;
@group(0) @binding(4) 
var<storage> global_4: type_35;
@group(0) @binding(2) 
var<storage> global_5: type_43;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_21;

fn function_() {
    var local: array<f32, 3>;
    var local_1: array<f32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<type_50, 128>;
    var local_4: array<f32, 3>;
    var local_5: array<f32, 3>;
    var local_6: array<f32, 3>;
    var local_7: array<f32, 3>;
    var local_8: array<u32, 3>;
    var local_9: array<u32, 3>;
    var local_10: array<f32, 3>;
    var local_11: array<f32, 3>;
    var phi_333_: i32;
    var phi_334_: i32;
    var phi_344_: bool;
    var phi_354_: u32;
    var phi_355_: u32;
    var phi_357_: bool;
    var phi_362_: u32;
    var phi_375_: i32;
    var phi_395_: i32;
    var phi_413_: f32;
    var phi_419_: f32;
    var phi_430_: f32;
    var phi_436_: f32;
    var phi_459_: f32;
    var phi_470_: f32;
    var phi_479_: f32;
    var phi_485_: f32;
    var phi_496_: f32;
    var phi_502_: f32;
    var phi_525_: f32;
    var phi_536_: f32;
    var phi_545_: f32;
    var phi_551_: f32;
    var phi_562_: f32;
    var phi_568_: f32;
    var phi_591_: f32;
    var phi_602_: f32;
    var phi_702_: f32;
    var phi_703_: f32;
    var phi_4605_: bool;
    var phi_2832_: type_37;
    var phi_2835_: type_50;
    var phi_2837_: u32;
    var phi_2839_: bool;
    var phi_2841_: u32;
    var phi_2852_: bool;
    var phi_2897_: type_50;
    var phi_2898_: bool;
    var phi_2899_: u32;
    var phi_3704_: type_41;
    var phi_3713_: type_4;
    var phi_3714_: type_4;
    var phi_3737_: type_4;
    var phi_4598_: bool;
    var phi_3867_: type_4;
    var phi_3868_: type_4;
    var phi_3891_: type_4;
    var phi_4658_: bool;
    var phi_4454_: type_50;
    var phi_4493_: type_50;
    var phi_4494_: type_50;
    var phi_4495_: u32;
    var phi_4497_: type_50;
    var phi_4498_: u32;
    var phi_4499_: bool;
    var phi_4506_: type_50;
    var phi_4511_: type_50;
    var phi_4512_: bool;
    var phi_2917_: type_37;
    var phi_2920_: type_4;
    var phi_2921_: type_4;
    var phi_2943_: type_4;
    var phi_2967_: u32;
    var phi_3056_: array<array<f32, 3>, 3>;
    var phi_3527_: vec3<f32>;
    var phi_3528_: vec3<f32>;
    var phi_3559_: bool;
    var phi_3568_: vec3<f32>;
    var phi_3608_: type_25;
    var phi_3610_: type_25;
    var phi_3611_: bool;
    var phi_3615_: type_25;
    var phi_3616_: type_25;
    var phi_3617_: type_25;
    var phi_3618_: bool;
    var phi_3622_: type_25;
    var phi_3623_: bool;
    var phi_3627_: type_25;
    var phi_3628_: bool;
    var phi_3632_: type_25;
    var phi_3657_: bool;
    var phi_3658_: bool;
    var phi_3665_: type_37;
    var phi_3666_: type_37;
    var phi_3667_: type_37;
    var phi_2918_: type_37;
    var phi_4666_: bool;
    var phi_4733_: bool;
    var phi_4514_: type_37;
    var phi_4515_: type_50;
    var phi_4516_: bool;
    var phi_4517_: u32;
    var phi_4732_: bool;
    var phi_4518_: type_37;
    var phi_4519_: type_50;
    var phi_4520_: u32;
    var phi_4521_: bool;
    var phi_4522_: u32;
    var phi_4731_: bool;
    var phi_4523_: type_37;
    var phi_4524_: type_50;
    var phi_4525_: u32;
    var phi_4526_: bool;
    var phi_4527_: u32;
    var phi_4730_: bool;
    var phi_2833_: type_37;
    var phi_2836_: type_50;
    var phi_2838_: u32;
    var phi_2840_: bool;
    var phi_2842_: u32;
    var phi_4528_: bool;
    var phi_4729_: bool;
    var local_12: type_37;
    var local_13: type_37;
    var local_14: type_37;

    switch bitcast<i32>(0u) {
        default: {
            let _e80 = global;
            let _e83 = arrayLength((&global_5.member));
            let _e85 = arrayLength((&global_2.member));
            let _e93 = global_3.member[0u][0u];
            let _e97 = global_3.member[0u][1u];
            let _e101 = global_3.member[0u][2u];
            let _e105 = global_3.member[1u][0u];
            let _e109 = global_3.member[1u][1u];
            let _e113 = global_3.member[1u][2u];
            let _e117 = global_3.member[1u][3u];
            let _e120 = global_1.member[0u];
            let _e121 = bitcast<i32>(_e120);
            let _e131 = (_e80.x + (_e80.y * 2097152u));
            let _e132 = (_e131 < arrayLength((&global_4.member)));
            if _e132 {
                let _e133 = (_e131 < arrayLength((&global_6.member)));
                if _e133 {
                    if _e132 {
                    } else {
                        break;
                    }
                    let _e141 = global_4.member[_e131].member_2[0u];
                    let _e143 = (bitcast<u32>(_e141) & 2147483647u);
                    let _e148 = global_4.member[_e131].member_2[1u];
                    let _e150 = (bitcast<u32>(_e148) & 2147483647u);
                    let _e155 = global_4.member[_e131].member_2[2u];
                    let _e157 = (bitcast<u32>(_e155) & 2147483647u);
                    let _e162 = global_4.member[_e131].member[0u];
                    let _e164 = (bitcast<u32>(_e162) & 2147483647u);
                    let _e169 = global_4.member[_e131].member[1u];
                    let _e171 = (bitcast<u32>(_e169) & 2147483647u);
                    let _e176 = global_4.member[_e131].member[2u];
                    let _e178 = (bitcast<u32>(_e176) & 2147483647u);
                    let _e180 = select(_e150, _e143, (_e150 < _e143));
                    let _e182 = select(_e157, _e180, (_e157 < _e180));
                    let _e184 = select(_e164, _e182, (_e164 < _e182));
                    let _e186 = select(_e171, _e184, (_e171 < _e184));
                    let _e188 = select(_e178, _e186, (_e178 < _e186));
                    let _e192 = global_4.member[_e131].member_1;
                    let _e194 = (bitcast<u32>(_e192) & 2147483647u);
                    let _e201 = global_4.member[_e131].member_3;
                    let _e207 = (((select(_e194, _e188, (_e194 < _e188)) < 2139095040u) && ((bitcast<u32>(_e201) & 2147483647u) <= 2139095040u)) && (_e182 > 0u));
                    if _e207 {
                        let _e210 = (bitcast<u32>(bitcast<f32>(_e182)) & 2147483647u);
                        if (_e210 >= 8388608u) {
                            phi_333_ = (bitcast<i32>((_e210 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_333_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e210)), 32u, (_e210 == 0u))));
                        }
                        let _e224 = phi_333_;
                        phi_334_ = _e224;
                    } else {
                        phi_334_ = 0i;
                    }
                    let _e226 = phi_334_;
                    let _e227 = (_e143 == _e182);
                    if _e227 {
                        phi_344_ = true;
                    } else {
                        phi_344_ = (_e150 == _e182);
                    }
                    let _e230 = phi_344_;
                    let _e231 = select(1u, 0u, _e227);
                    if _e230 {
                        let _e232 = (_e231 + 1u);
                        phi_354_ = _e232;
                        phi_355_ = _e232;
                        phi_357_ = select(true, false, (_e232 == 2u));
                    } else {
                        phi_354_ = u32();
                        phi_355_ = 0u;
                        phi_357_ = true;
                    }
                    let _e236 = phi_354_;
                    let _e238 = phi_355_;
                    let _e240 = phi_357_;
                    if _e240 {
                        phi_362_ = (_e238 + 1u);
                    } else {
                        phi_362_ = 0u;
                    }
                    let _e244 = phi_362_;
                    let _e245 = select(_e236, _e238, _e240);
                    let _e246 = select(_e231, select(2u, _e231, _e230), _e240);
                    if (_e121 < -126i) {
                        phi_375_ = -126i;
                    } else {
                        phi_375_ = select(_e121, 127i, (_e121 > 127i));
                    }
                    let _e251 = phi_375_;
                    let _e256 = bitcast<f32>((bitcast<u32>((_e251 + 127i)) << bitcast<u32>(23i)));
                    let _e262 = bitcast<f32>((bitcast<u32>(((_e121 - _e251) + 127i)) << bitcast<u32>(23i)));
                    let _e263 = -(_e226);
                    if (_e263 < -126i) {
                        phi_395_ = -126i;
                    } else {
                        phi_395_ = select(_e263, 127i, (_e263 > 127i));
                    }
                    let _e268 = phi_395_;
                    let _e273 = bitcast<f32>((bitcast<u32>((_e268 + 127i)) << bitcast<u32>(23i)));
                    let _e279 = bitcast<f32>((bitcast<u32>(((_e263 - _e268) + 127i)) << bitcast<u32>(23i)));
                    let _e283 = global_4.member[_e131].member;
                    let _e284 = (_e245 == 0u);
                    if _e284 {
                        phi_413_ = _e283[0];
                    } else {
                        phi_413_ = _e283[1];
                    }
                    let _e288 = phi_413_;
                    let _e289 = (_e245 == 2u);
                    if _e289 {
                        phi_419_ = _e283[2];
                    } else {
                        phi_419_ = _e288;
                    }
                    let _e292 = phi_419_;
                    let _e294 = ((_e292 * _e256) * _e262);
                    let _e295 = global_4.member[_e131].member_2;
                    if _e284 {
                        phi_430_ = _e295[0];
                    } else {
                        phi_430_ = _e295[1];
                    }
                    let _e299 = phi_430_;
                    if _e289 {
                        phi_436_ = _e295[2];
                    } else {
                        phi_436_ = _e299;
                    }
                    let _e302 = phi_436_;
                    let _e304 = ((_e302 * _e273) * _e279);
                    let _e308 = (bitcast<f32>((bitcast<u32>(_e304) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e308 {
                        let _e312 = (bitcast<f32>((bitcast<u32>(_e294) & 2147483647u)) * 0.00000011920929f);
                        phi_459_ = select(0.00000000000011368684f, _e312, (_e312 > 0.00000000000011368684f));
                    } else {
                        phi_459_ = 0f;
                    }
                    let _e316 = phi_459_;
                    let _e317 = (_e294 + _e316);
                    let _e318 = (_e294 - _e316);
                    let _e319 = select(_e304, 0f, _e308);
                    if _e308 {
                        phi_470_ = 38685626000000000000000000f;
                    } else {
                        phi_470_ = (1f / _e304);
                    }
                    let _e322 = phi_470_;
                    let _e323 = (_e244 == 0u);
                    if _e323 {
                        phi_479_ = _e283[0];
                    } else {
                        phi_479_ = _e283[1];
                    }
                    let _e327 = phi_479_;
                    let _e328 = (_e244 == 2u);
                    if _e328 {
                        phi_485_ = _e283[2];
                    } else {
                        phi_485_ = _e327;
                    }
                    let _e331 = phi_485_;
                    let _e333 = ((_e331 * _e256) * _e262);
                    if _e323 {
                        phi_496_ = _e295[0];
                    } else {
                        phi_496_ = _e295[1];
                    }
                    let _e337 = phi_496_;
                    if _e328 {
                        phi_502_ = _e295[2];
                    } else {
                        phi_502_ = _e337;
                    }
                    let _e340 = phi_502_;
                    let _e342 = ((_e340 * _e273) * _e279);
                    let _e346 = (bitcast<f32>((bitcast<u32>(_e342) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e346 {
                        let _e350 = (bitcast<f32>((bitcast<u32>(_e333) & 2147483647u)) * 0.00000011920929f);
                        phi_525_ = select(0.00000000000011368684f, _e350, (_e350 > 0.00000000000011368684f));
                    } else {
                        phi_525_ = 0f;
                    }
                    let _e354 = phi_525_;
                    let _e355 = (_e333 + _e354);
                    let _e356 = (_e333 - _e354);
                    let _e357 = select(_e342, 0f, _e346);
                    if _e346 {
                        phi_536_ = 38685626000000000000000000f;
                    } else {
                        phi_536_ = (1f / _e342);
                    }
                    let _e360 = phi_536_;
                    let _e361 = (_e246 == 0u);
                    if _e361 {
                        phi_545_ = _e283[0];
                    } else {
                        phi_545_ = _e283[1];
                    }
                    let _e365 = phi_545_;
                    let _e366 = (_e246 == 2u);
                    if _e366 {
                        phi_551_ = _e283[2];
                    } else {
                        phi_551_ = _e365;
                    }
                    let _e369 = phi_551_;
                    let _e371 = ((_e369 * _e256) * _e262);
                    if _e361 {
                        phi_562_ = _e295[0];
                    } else {
                        phi_562_ = _e295[1];
                    }
                    let _e375 = phi_562_;
                    if _e366 {
                        phi_568_ = _e295[2];
                    } else {
                        phi_568_ = _e375;
                    }
                    let _e378 = phi_568_;
                    let _e380 = ((_e378 * _e273) * _e279);
                    let _e384 = (bitcast<f32>((bitcast<u32>(_e380) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e384 {
                        let _e388 = (bitcast<f32>((bitcast<u32>(_e371) & 2147483647u)) * 0.00000011920929f);
                        phi_591_ = select(0.00000000000011368684f, _e388, (_e388 > 0.00000000000011368684f));
                    } else {
                        phi_591_ = 0f;
                    }
                    let _e392 = phi_591_;
                    let _e393 = (_e371 + _e392);
                    let _e394 = (_e371 - _e392);
                    let _e395 = select(_e380, 0f, _e384);
                    if _e384 {
                        phi_602_ = 38685626000000000000000000f;
                    } else {
                        phi_602_ = (1f / _e380);
                    }
                    let _e398 = phi_602_;
                    let _e401 = bitcast<f32>((bitcast<u32>(_e294) & 2147483647u));
                    let _e404 = bitcast<f32>((bitcast<u32>(_e333) & 2147483647u));
                    let _e406 = select(_e404, _e401, (_e401 > _e404));
                    let _e409 = bitcast<f32>((bitcast<u32>(_e371) & 2147483647u));
                    let _e412 = (_e121 + _e226);
                    if (_e207 && (select(_e409, _e406, (_e406 > _e409)) <= 1099511600000f)) {
                        let _e415 = (_e412 / 3i);
                        let _e422 = bitcast<f32>((bitcast<u32>((_e415 + 127i)) << bitcast<u32>(23i)));
                        let _e429 = bitcast<f32>((bitcast<u32>(((_e412 - (2i * _e415)) + 127i)) << bitcast<u32>(23i)));
                        let _e430 = (((_e192 * _e422) * _e422) * _e429);
                        let _e432 = select(340282350000000000000000000000000000000f, _e430, (_e430 < 340282350000000000000000000000000000000f));
                        let _e437 = (((_e201 * _e422) * _e422) * _e429);
                        let _e439 = select(340282350000000000000000000000000000000f, _e437, (_e437 < 340282350000000000000000000000000000000f));
                        phi_702_ = select(-340282350000000000000000000000000000000f, _e439, (_e439 > -340282350000000000000000000000000000000f));
                        phi_703_ = select(-340282350000000000000000000000000000000f, _e432, (_e432 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_702_ = 0f;
                        phi_703_ = 1f;
                    }
                    let _e443 = phi_702_;
                    let _e445 = phi_703_;
                    local_3 = array<type_50, 128>(type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u));
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_11 = array<f32, 3>(bitcast<f32>(_e93), bitcast<f32>(_e97), bitcast<f32>(_e101));
                    let _e451 = (_e245 % 3u);
                    let _e452 = (_e451 < 3u);
                    if _e452 {
                    } else {
                        break;
                    }
                    let _e454 = local_11[_e451];
                    let _e455 = (_e244 % 3u);
                    let _e456 = (_e455 < 3u);
                    if _e456 {
                    } else {
                        break;
                    }
                    let _e458 = local_11[_e455];
                    let _e459 = (_e246 % 3u);
                    let _e460 = (_e459 < 3u);
                    if _e460 {
                    } else {
                        break;
                    }
                    let _e462 = local_11[_e459];
                    local_10 = array<f32, 3>(bitcast<f32>(_e105), bitcast<f32>(_e109), bitcast<f32>(_e113));
                    if _e452 {
                    } else {
                        break;
                    }
                    let _e466 = local_10[_e451];
                    if _e456 {
                    } else {
                        break;
                    }
                    let _e468 = local_10[_e455];
                    if _e460 {
                    } else {
                        break;
                    }
                    let _e470 = local_10[_e459];
                    phi_4605_ = false;
                    phi_2832_ = type_37(type_31(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e443), 0u, 0u);
                    phi_2835_ = type_50(type_47(array<f32, 3>(_e454, _e458, _e462), array<f32, 3>(_e466, _e468, _e470)), select(0u, 2147483648u, (_e83 == 0u)));
                    phi_2837_ = ((3u * _e83) + 1u);
                    phi_2839_ = (_e445 <= _e443);
                    phi_2841_ = 0u;
                    loop {
                        let _e478 = phi_4605_;
                        let _e480 = phi_2832_;
                        let _e482 = phi_2835_;
                        let _e484 = phi_2837_;
                        let _e486 = phi_2839_;
                        let _e488 = phi_2841_;
                        local_12 = _e480;
                        local_13 = _e480;
                        if _e486 {
                            phi_2852_ = true;
                        } else {
                            phi_2852_ = (_e488 > 0u);
                        }
                        let _e491 = phi_2852_;
                        if _e491 {
                            let _e492 = (_e484 > 0u);
                            if _e492 {
                                if _e486 {
                                    phi_2897_ = _e482;
                                    phi_2898_ = _e486;
                                    phi_2899_ = _e488;
                                } else {
                                    let _e493 = (_e488 - 1u);
                                    let _e494 = (_e493 % 128u);
                                    let _e495 = (_e494 < 128u);
                                    if _e495 {
                                    } else {
                                        phi_4729_ = true;
                                        break;
                                    }
                                    let _e497 = local_3[_e494];
                                    if _e495 {
                                    } else {
                                        phi_4729_ = true;
                                        break;
                                    }
                                    let _e513 = local_2[_e494];
                                    phi_2897_ = type_50(type_47(array<f32, 3>(_e497.member.member[0], _e497.member.member[1], _e497.member.member[2]), array<f32, 3>(_e497.member.member_1[0], _e497.member.member_1[1], _e497.member.member_1[2])), _e497.member_1);
                                    phi_2898_ = (_e513 <= _e480.member.member_1);
                                    phi_2899_ = _e493;
                                }
                                let _e518 = phi_2897_;
                                let _e520 = phi_2898_;
                                let _e522 = phi_2899_;
                                if _e520 {
                                    if ((_e518.member_1 & 2147483648u) != 0u) {
                                        phi_2917_ = _e480;
                                        phi_2920_ = type_4(0u, ((_e518.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e851 = phi_2917_;
                                            let _e853 = phi_2920_;
                                            local_14 = _e851;
                                            if (_e853.member < _e853.member_1) {
                                                phi_2921_ = type_4((_e853.member + 1u), _e853.member_1);
                                                phi_2943_ = type_4(1u, _e853.member);
                                            } else {
                                                phi_2921_ = _e853;
                                                phi_2943_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e866 = phi_2921_;
                                            let _e868 = phi_2943_;
                                            let _e872 = (bitcast<i32>(_e868.member) != 0i);
                                            if _e872 {
                                                let _e878 = type_37(_e851.member, _e851.member_1, (_e851.member_2 + 1u));
                                                let _e879 = ((_e518.member_1 & 268435455u) + _e868.member_1);
                                                let _e880 = (_e879 < _e85);
                                                if _e880 {
                                                    if _e880 {
                                                    } else {
                                                        phi_4666_ = true;
                                                        break;
                                                    }
                                                    let _e884 = global_2.member[_e879].member_1;
                                                    phi_2967_ = _e884;
                                                } else {
                                                    phi_2967_ = 4294967295u;
                                                }
                                                let _e886 = phi_2967_;
                                                if (_e879 >= _e85) {
                                                    phi_3056_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e880 {
                                                    } else {
                                                        phi_4666_ = true;
                                                        break;
                                                    }
                                                    if (_e451 < 9u) {
                                                    } else {
                                                        phi_4666_ = true;
                                                        break;
                                                    }
                                                    let _e893 = global_2.member[_e879].member[_e451];
                                                    if (_e455 < 9u) {
                                                    } else {
                                                        phi_4666_ = true;
                                                        break;
                                                    }
                                                    let _e899 = global_2.member[_e879].member[_e455];
                                                    if (_e459 < 9u) {
                                                    } else {
                                                        phi_4666_ = true;
                                                        break;
                                                    }
                                                    let _e905 = global_2.member[_e879].member[_e459];
                                                    let _e907 = (3u + _e451);
                                                    if (_e907 < 9u) {
                                                    } else {
                                                        phi_4666_ = true;
                                                        break;
                                                    }
                                                    let _e913 = global_2.member[_e879].member[_e907];
                                                    let _e914 = (3u + _e455);
                                                    if (_e914 < 9u) {
                                                    } else {
                                                        phi_4666_ = true;
                                                        break;
                                                    }
                                                    let _e920 = global_2.member[_e879].member[_e914];
                                                    let _e921 = (3u + _e459);
                                                    if (_e921 < 9u) {
                                                    } else {
                                                        phi_4666_ = true;
                                                        break;
                                                    }
                                                    let _e927 = global_2.member[_e879].member[_e921];
                                                    let _e929 = (6u + _e451);
                                                    if (_e929 < 9u) {
                                                    } else {
                                                        phi_4666_ = true;
                                                        break;
                                                    }
                                                    let _e935 = global_2.member[_e879].member[_e929];
                                                    let _e936 = (6u + _e455);
                                                    if (_e936 < 9u) {
                                                    } else {
                                                        phi_4666_ = true;
                                                        break;
                                                    }
                                                    let _e942 = global_2.member[_e879].member[_e936];
                                                    let _e943 = (6u + _e459);
                                                    if (_e943 < 9u) {
                                                    } else {
                                                        phi_4666_ = true;
                                                        break;
                                                    }
                                                    let _e949 = global_2.member[_e879].member[_e943];
                                                    phi_3056_ = array<array<f32, 3>, 3>(array<f32, 3>(_e893, _e899, _e905), array<f32, 3>(_e913, _e920, _e927), array<f32, 3>(_e935, _e942, _e949));
                                                }
                                                let _e953 = phi_3056_;
                                                let _e962 = (_e953[0][2] - _e371);
                                                let _e965 = (((_e953[0][0] - _e294) * _e395) - (_e962 * _e319));
                                                let _e968 = (((_e953[0][1] - _e333) * _e395) - (_e962 * _e357));
                                                let _e975 = (_e953[1][2] - _e371);
                                                let _e978 = (((_e953[1][0] - _e294) * _e395) - (_e975 * _e319));
                                                let _e981 = (((_e953[1][1] - _e333) * _e395) - (_e975 * _e357));
                                                let _e988 = (_e953[2][2] - _e371);
                                                let _e991 = (((_e953[2][0] - _e294) * _e395) - (_e988 * _e319));
                                                let _e994 = (((_e953[2][1] - _e333) * _e395) - (_e988 * _e357));
                                                let _e995 = (_e991 * _e981);
                                                let _e996 = (_e994 * _e978);
                                                let _e997 = (_e965 * _e994);
                                                let _e998 = (_e968 * _e991);
                                                let _e999 = (_e978 * _e968);
                                                let _e1000 = (_e981 * _e965);
                                                let _e1005 = (((_e995 >= _e996) && (_e997 >= _e998)) && (_e999 >= _e1000));
                                                if (_e1005 || (((_e995 <= _e996) && (_e997 <= _e998)) && (_e999 <= _e1000))) {
                                                    let _e1012 = select(-1f, 1f, _e1005);
                                                    let _e1014 = ((_e995 - _e996) * _e1012);
                                                    let _e1016 = select(0f, _e1014, (_e1014 > 0f));
                                                    let _e1018 = ((_e997 - _e998) * _e1012);
                                                    let _e1020 = select(0f, _e1018, (_e1018 > 0f));
                                                    let _e1022 = ((_e999 - _e1000) * _e1012);
                                                    let _e1024 = select(0f, _e1022, (_e1022 > 0f));
                                                    let _e1026 = ((_e1016 + _e1020) + _e1024);
                                                    if (_e1026 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_3622_ = type_25();
                                                        phi_3623_ = true;
                                                    } else {
                                                        let _e1029 = select(_e953[1][0], _e953[0][0], (_e953[0][0] < _e953[1][0]));
                                                        let _e1033 = select(_e953[1][0], _e953[0][0], (_e953[0][0] > _e953[1][0]));
                                                        let _e1037 = select(_e953[1][1], _e953[0][1], (_e953[0][1] < _e953[1][1]));
                                                        let _e1041 = select(_e953[1][1], _e953[0][1], (_e953[0][1] > _e953[1][1]));
                                                        let _e1045 = select(_e953[1][2], _e953[0][2], (_e953[0][2] < _e953[1][2]));
                                                        let _e1049 = select(_e953[1][2], _e953[0][2], (_e953[0][2] > _e953[1][2]));
                                                        let _e1054 = ((select(_e953[2][0], _e1029, (_e1029 < _e953[2][0])) - _e317) * _e322);
                                                        let _e1055 = ((select(_e953[2][0], _e1033, (_e1033 > _e953[2][0])) - _e318) * _e322);
                                                        let _e1058 = ((select(_e953[2][1], _e1037, (_e1037 < _e953[2][1])) - _e355) * _e360);
                                                        let _e1059 = ((select(_e953[2][1], _e1041, (_e1041 > _e953[2][1])) - _e356) * _e360);
                                                        let _e1062 = ((select(_e953[2][2], _e1045, (_e1045 < _e953[2][2])) - _e393) * _e398);
                                                        let _e1063 = ((select(_e953[2][2], _e1049, (_e1049 > _e953[2][2])) - _e394) * _e398);
                                                        let _e1065 = select(_e1063, _e1062, (_e1062 < _e1063));
                                                        let _e1067 = select(_e1063, _e1062, (_e1062 > _e1063));
                                                        let _e1069 = select(_e1055, _e1054, (_e1054 < _e1055));
                                                        let _e1071 = select(_e1059, _e1058, (_e1058 < _e1059));
                                                        let _e1073 = select(_e1071, _e1069, (_e1069 > _e1071));
                                                        let _e1075 = select(_e1065, _e1073, (_e1073 > _e1065));
                                                        let _e1077 = select(_e1055, _e1054, (_e1054 > _e1055));
                                                        let _e1079 = select(_e1059, _e1058, (_e1058 > _e1059));
                                                        let _e1081 = select(_e1079, _e1077, (_e1077 < _e1079));
                                                        let _e1083 = select(_e1067, _e1081, (_e1081 < _e1067));
                                                        let _e1084 = -(_e1065);
                                                        let _e1090 = select(_e445, _e1075, (_e1075 > _e445));
                                                        if (_e1090 > (_e1083 + (select(_e1084, _e1067, (_e1067 > _e1084)) * 0.0000019073523f))) {
                                                            phi_3617_ = type_25();
                                                            phi_3618_ = true;
                                                        } else {
                                                            let _e1092 = (_e1090 > _e851.member.member_1);
                                                            if _e1092 {
                                                                phi_3616_ = type_25();
                                                            } else {
                                                                let _e1096 = (_e953[1][0] - _e953[0][0]);
                                                                let _e1097 = (_e953[1][1] - _e953[0][1]);
                                                                let _e1098 = (_e953[1][2] - _e953[0][2]);
                                                                let _e1099 = vec3<f32>(_e1096, _e1097, _e1098);
                                                                let _e1100 = (_e953[2][0] - _e953[1][0]);
                                                                let _e1101 = (_e953[2][1] - _e953[1][1]);
                                                                let _e1102 = (_e953[2][2] - _e953[1][2]);
                                                                let _e1103 = vec3<f32>(_e1100, _e1101, _e1102);
                                                                let _e1104 = (_e953[0][0] - _e953[2][0]);
                                                                let _e1105 = (_e953[0][1] - _e953[2][1]);
                                                                let _e1106 = (_e953[0][2] - _e953[2][2]);
                                                                let _e1107 = vec3<f32>(_e1104, _e1105, _e1106);
                                                                let _e1110 = bitcast<f32>((bitcast<u32>(_e1096) & 2147483647u));
                                                                let _e1113 = bitcast<f32>((bitcast<u32>(_e1097) & 2147483647u));
                                                                let _e1115 = select(_e1113, _e1110, (_e1110 > _e1113));
                                                                let _e1118 = bitcast<f32>((bitcast<u32>(_e1098) & 2147483647u));
                                                                let _e1120 = select(_e1118, _e1115, (_e1115 > _e1118));
                                                                let _e1123 = bitcast<f32>((bitcast<u32>(_e1100) & 2147483647u));
                                                                let _e1126 = bitcast<f32>((bitcast<u32>(_e1101) & 2147483647u));
                                                                let _e1128 = select(_e1126, _e1123, (_e1123 > _e1126));
                                                                let _e1131 = bitcast<f32>((bitcast<u32>(_e1102) & 2147483647u));
                                                                let _e1133 = select(_e1131, _e1128, (_e1128 > _e1131));
                                                                let _e1136 = bitcast<f32>((bitcast<u32>(_e1104) & 2147483647u));
                                                                let _e1139 = bitcast<f32>((bitcast<u32>(_e1105) & 2147483647u));
                                                                let _e1141 = select(_e1139, _e1136, (_e1136 > _e1139));
                                                                let _e1144 = bitcast<f32>((bitcast<u32>(_e1106) & 2147483647u));
                                                                let _e1146 = select(_e1144, _e1141, (_e1141 > _e1144));
                                                                let _e1148 = select(_e1133, _e1120, (_e1120 > _e1133));
                                                                let _e1150 = select(_e1146, _e1148, (_e1148 > _e1146));
                                                                if (_e1120 == _e1150) {
                                                                    phi_3527_ = _e1103;
                                                                    phi_3528_ = _e1107;
                                                                } else {
                                                                    let _e1153 = vec3((_e1133 == _e1150));
                                                                    phi_3527_ = select(_e1099, _e1107, _e1153);
                                                                    phi_3528_ = select(_e1103, _e1099, _e1153);
                                                                }
                                                                let _e1157 = phi_3527_;
                                                                let _e1159 = phi_3528_;
                                                                let _e1166 = ((_e1157.y * _e1159.z) - (_e1159.y * _e1157.z));
                                                                let _e1171 = ((_e1157.z * _e1159.x) - (_e1159.z * _e1157.x));
                                                                let _e1174 = ((_e1157.x * _e1159.y) - (_e1159.x * _e1157.y));
                                                                if (_e1016 >= _e1020) {
                                                                    phi_3559_ = select(true, false, (_e1016 >= _e1024));
                                                                } else {
                                                                    phi_3559_ = true;
                                                                }
                                                                let _e1179 = phi_3559_;
                                                                if _e1179 {
                                                                    phi_3568_ = select(vec3<f32>(_e953[2][0], _e953[2][1], _e953[2][2]), vec3<f32>(_e953[1][0], _e953[1][1], _e953[1][2]), vec3((_e1020 >= _e1024)));
                                                                } else {
                                                                    phi_3568_ = vec3<f32>(_e953[0][0], _e953[0][1], _e953[0][2]);
                                                                }
                                                                let _e1184 = phi_3568_;
                                                                let _e1201 = ((((_e1166 * (_e1184.x - _e294)) + (_e1171 * (_e1184.y - _e333))) + (_e1174 * (_e1184.z - _e371))) / (((_e1166 * _e319) + (_e1171 * _e357)) + (_e1174 * _e395)));
                                                                let _e1203 = select(_e1083, _e1201, (_e1201 < _e1083));
                                                                let _e1205 = select(_e1075, _e1203, (_e1203 > _e1075));
                                                                if (_e1205 >= _e445) {
                                                                    let _e1207 = (_e1205 <= _e851.member.member_1);
                                                                    if _e1207 {
                                                                        let _e1208 = (1f / _e1026);
                                                                        phi_3608_ = type_25(_e1205, (_e1020 * _e1208), (_e1024 * _e1208), _e886);
                                                                    } else {
                                                                        phi_3608_ = type_25();
                                                                    }
                                                                    let _e1213 = phi_3608_;
                                                                    phi_3610_ = _e1213;
                                                                    phi_3611_ = select(true, false, _e1207);
                                                                } else {
                                                                    phi_3610_ = type_25();
                                                                    phi_3611_ = true;
                                                                }
                                                                let _e1216 = phi_3610_;
                                                                let _e1218 = phi_3611_;
                                                                if _e1218 {
                                                                    phi_3615_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_3615_ = _e1216;
                                                                }
                                                                let _e1220 = phi_3615_;
                                                                phi_3616_ = _e1220;
                                                            }
                                                            let _e1222 = phi_3616_;
                                                            phi_3617_ = _e1222;
                                                            phi_3618_ = _e1092;
                                                        }
                                                        let _e1224 = phi_3617_;
                                                        let _e1226 = phi_3618_;
                                                        phi_3622_ = _e1224;
                                                        phi_3623_ = _e1226;
                                                    }
                                                    let _e1228 = phi_3622_;
                                                    let _e1230 = phi_3623_;
                                                    phi_3627_ = _e1228;
                                                    phi_3628_ = _e1230;
                                                } else {
                                                    phi_3627_ = type_25();
                                                    phi_3628_ = true;
                                                }
                                                let _e1232 = phi_3627_;
                                                let _e1234 = phi_3628_;
                                                if _e1234 {
                                                    phi_3632_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_3632_ = _e1232;
                                                }
                                                let _e1236 = phi_3632_;
                                                if (_e1236.member_3 != 4294967295u) {
                                                    if (_e886 != 4294967295u) {
                                                        if (_e1236.member < _e851.member.member.member) {
                                                            phi_3658_ = true;
                                                        } else {
                                                            if (_e1236.member == _e851.member.member.member) {
                                                                phi_3657_ = (_e1236.member_3 < _e851.member.member.member_3);
                                                            } else {
                                                                phi_3657_ = false;
                                                            }
                                                            let _e1251 = phi_3657_;
                                                            phi_3658_ = _e1251;
                                                        }
                                                        let _e1253 = phi_3658_;
                                                        if _e1253 {
                                                            phi_3665_ = type_37(type_31(_e1236, _e1236.member), _e878.member_1, _e878.member_2);
                                                        } else {
                                                            phi_3665_ = _e878;
                                                        }
                                                        let _e1260 = phi_3665_;
                                                        phi_3666_ = _e1260;
                                                    } else {
                                                        phi_3666_ = _e878;
                                                    }
                                                    let _e1262 = phi_3666_;
                                                    phi_3667_ = _e1262;
                                                } else {
                                                    phi_3667_ = _e878;
                                                }
                                                let _e1264 = phi_3667_;
                                                phi_2918_ = _e1264;
                                            } else {
                                                phi_2918_ = type_37();
                                            }
                                            let _e1266 = phi_2918_;
                                            continue;
                                            continuing {
                                                phi_2917_ = _e1266;
                                                phi_2920_ = _e866;
                                                phi_4666_ = _e478;
                                                break if !(_e872);
                                            }
                                        }
                                        let _e1269 = phi_4666_;
                                        phi_4729_ = _e1269;
                                        if _e1269 {
                                            break;
                                        }
                                        phi_4733_ = _e1269;
                                        let _e1423 = local_14;
                                        phi_4514_ = _e1423;
                                        phi_4515_ = _e518;
                                        phi_4516_ = false;
                                        phi_4517_ = _e522;
                                    } else {
                                        local_1 = array<f32, 3>(_e518.member.member[0], _e518.member.member[1], _e518.member.member[2]);
                                        local = array<f32, 3>(_e518.member.member_1[0], _e518.member.member_1[1], _e518.member.member_1[2]);
                                        let _e548 = (_e518.member_1 < _e83);
                                        if _e548 {
                                            if _e548 {
                                            } else {
                                                phi_4729_ = true;
                                                break;
                                            }
                                            let _e550 = global_5.member[_e518.member_1];
                                            phi_3704_ = _e550;
                                        } else {
                                            phi_3704_ = type_41(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e552 = phi_3704_;
                                        let _e554 = array<u32, 3>(_e245, _e244, _e246);
                                        local_9 = _e554;
                                        local_5 = array<f32, 3>(0f, 0f, 0f);
                                        local_4 = array<f32, 3>(0f, 0f, 0f);
                                        phi_3713_ = type_4(0u, 3u);
                                        loop {
                                            let _e556 = phi_3713_;
                                            if (_e556.member < _e556.member_1) {
                                                phi_3714_ = type_4((_e556.member + 1u), _e556.member_1);
                                                phi_3737_ = type_4(1u, _e556.member);
                                            } else {
                                                phi_3714_ = _e556;
                                                phi_3737_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e569 = phi_3714_;
                                            let _e571 = phi_3737_;
                                            let _e575 = (bitcast<i32>(_e571.member) != 0i);
                                            if _e575 {
                                                let _e576 = (_e571.member_1 < 3u);
                                                if _e576 {
                                                } else {
                                                    phi_4598_ = true;
                                                    break;
                                                }
                                                let _e578 = local_9[_e571.member_1];
                                                if _e576 {
                                                } else {
                                                    phi_4598_ = true;
                                                    break;
                                                }
                                                let _e580 = local_1[_e571.member_1];
                                                if _e576 {
                                                } else {
                                                    phi_4598_ = true;
                                                    break;
                                                }
                                                let _e582 = local[_e571.member_1];
                                                let _e585 = ((10u * _e578) & 31u);
                                                let _e588 = ((_e552.member[0] >> bitcast<u32>(_e585)) & 1023u);
                                                let _e593 = bitcast<f32>((bitcast<u32>(((_e582 - _e580) * 0.0009775171f)) ^ _e117));
                                                let _e599 = (_e580 + bitcast<f32>((bitcast<u32>((f32(_e588) * _e593)) ^ _e117)));
                                                if _e576 {
                                                } else {
                                                    phi_4598_ = true;
                                                    break;
                                                }
                                                local_5[_e571.member_1] = select(select(_e582, _e599, (_e599 < _e582)), _e582, (_e588 == 1023u));
                                                let _e608 = ((_e552.member[1] >> bitcast<u32>(_e585)) & 1023u);
                                                let _e614 = (_e580 + bitcast<f32>((bitcast<u32>((f32(_e608) * _e593)) ^ _e117)));
                                                if _e576 {
                                                } else {
                                                    phi_4598_ = true;
                                                    break;
                                                }
                                                local_4[_e571.member_1] = select(select(_e582, _e614, (_e614 < _e582)), _e582, (_e608 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_3713_ = _e569;
                                                phi_4598_ = _e478;
                                                break if !(_e575);
                                            }
                                        }
                                        let _e622 = phi_4598_;
                                        phi_4729_ = _e622;
                                        if _e622 {
                                            break;
                                        }
                                        let _e623 = local_4;
                                        let _e624 = local_5;
                                        local_8 = _e554;
                                        local_7 = array<f32, 3>(0f, 0f, 0f);
                                        local_6 = array<f32, 3>(0f, 0f, 0f);
                                        phi_3867_ = type_4(0u, 3u);
                                        loop {
                                            let _e633 = phi_3867_;
                                            if (_e633.member < _e633.member_1) {
                                                phi_3868_ = type_4((_e633.member + 1u), _e633.member_1);
                                                phi_3891_ = type_4(1u, _e633.member);
                                            } else {
                                                phi_3868_ = _e633;
                                                phi_3891_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e646 = phi_3868_;
                                            let _e648 = phi_3891_;
                                            let _e652 = (bitcast<i32>(_e648.member) != 0i);
                                            if _e652 {
                                                let _e653 = (_e648.member_1 < 3u);
                                                if _e653 {
                                                } else {
                                                    phi_4658_ = true;
                                                    break;
                                                }
                                                let _e655 = local_8[_e648.member_1];
                                                if _e653 {
                                                } else {
                                                    phi_4658_ = true;
                                                    break;
                                                }
                                                let _e657 = local_1[_e648.member_1];
                                                if _e653 {
                                                } else {
                                                    phi_4658_ = true;
                                                    break;
                                                }
                                                let _e659 = local[_e648.member_1];
                                                let _e662 = ((10u * _e655) & 31u);
                                                let _e665 = ((_e552.member_1[0] >> bitcast<u32>(_e662)) & 1023u);
                                                let _e670 = bitcast<f32>((bitcast<u32>(((_e659 - _e657) * 0.0009775171f)) ^ _e117));
                                                let _e676 = (_e657 + bitcast<f32>((bitcast<u32>((f32(_e665) * _e670)) ^ _e117)));
                                                if _e653 {
                                                } else {
                                                    phi_4658_ = true;
                                                    break;
                                                }
                                                local_7[_e648.member_1] = select(select(_e659, _e676, (_e676 < _e659)), _e659, (_e665 == 1023u));
                                                let _e685 = ((_e552.member_1[1] >> bitcast<u32>(_e662)) & 1023u);
                                                let _e691 = (_e657 + bitcast<f32>((bitcast<u32>((f32(_e685) * _e670)) ^ _e117)));
                                                if _e653 {
                                                } else {
                                                    phi_4658_ = true;
                                                    break;
                                                }
                                                local_6[_e648.member_1] = select(select(_e659, _e691, (_e691 < _e659)), _e659, (_e685 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_3867_ = _e646;
                                                phi_4658_ = _e622;
                                                break if !(_e652);
                                            }
                                        }
                                        let _e699 = phi_4658_;
                                        phi_4729_ = _e699;
                                        if _e699 {
                                            break;
                                        }
                                        let _e700 = local_6;
                                        let _e701 = local_7;
                                        let _e712 = type_50(type_47(array<f32, 3>(_e624[0], _e624[1], _e624[2]), array<f32, 3>(_e623[0], _e623[1], _e623[2])), _e552.member_2);
                                        let _e717 = type_50(type_47(array<f32, 3>(_e701[0], _e701[1], _e701[2]), array<f32, 3>(_e700[0], _e700[1], _e700[2])), _e552.member_3);
                                        let _e724 = ((_e624[0] - _e317) * _e322);
                                        let _e725 = ((_e701[0] - _e317) * _e322);
                                        let _e726 = ((_e623[0] - _e318) * _e322);
                                        let _e727 = ((_e700[0] - _e318) * _e322);
                                        let _e732 = ((_e624[1] - _e355) * _e360);
                                        let _e733 = ((_e701[1] - _e355) * _e360);
                                        let _e734 = ((_e623[1] - _e356) * _e360);
                                        let _e735 = ((_e700[1] - _e356) * _e360);
                                        let _e740 = ((_e624[2] - _e393) * _e398);
                                        let _e741 = ((_e701[2] - _e393) * _e398);
                                        let _e742 = ((_e623[2] - _e394) * _e398);
                                        let _e743 = ((_e700[2] - _e394) * _e398);
                                        let _e745 = select(_e742, _e740, (_e740 < _e742));
                                        let _e747 = select(_e743, _e741, (_e741 < _e743));
                                        let _e749 = select(_e742, _e740, (_e740 > _e742));
                                        let _e751 = select(_e743, _e741, (_e741 > _e743));
                                        let _e753 = select(_e726, _e724, (_e724 < _e726));
                                        let _e755 = select(_e727, _e725, (_e725 < _e727));
                                        let _e757 = select(_e734, _e732, (_e732 < _e734));
                                        let _e759 = select(_e735, _e733, (_e733 < _e735));
                                        let _e761 = select(_e757, _e753, (_e753 > _e757));
                                        let _e763 = select(_e759, _e755, (_e755 > _e759));
                                        let _e765 = select(_e745, _e761, (_e761 > _e745));
                                        let _e767 = select(_e747, _e763, (_e763 > _e747));
                                        let _e769 = select(_e726, _e724, (_e724 > _e726));
                                        let _e771 = select(_e727, _e725, (_e725 > _e727));
                                        let _e773 = select(_e734, _e732, (_e732 > _e734));
                                        let _e775 = select(_e735, _e733, (_e733 > _e735));
                                        let _e777 = select(_e773, _e769, (_e769 < _e773));
                                        let _e779 = select(_e775, _e771, (_e771 < _e775));
                                        let _e784 = -(_e745);
                                        let _e785 = -(_e747);
                                        let _e792 = (select(_e749, _e777, (_e777 < _e749)) + (select(_e784, _e749, (_e749 > _e784)) * 0.0000019073523f));
                                        let _e793 = (select(_e751, _e779, (_e779 < _e751)) + (select(_e785, _e751, (_e751 > _e785)) * 0.0000019073523f));
                                        let _e795 = select(_e445, _e765, (_e765 > _e445));
                                        let _e797 = select(_e445, _e767, (_e767 > _e445));
                                        let _e802 = (_e795 <= select(_e480.member.member_1, _e792, (_e792 < _e480.member.member_1)));
                                        let _e803 = (_e797 <= select(_e480.member.member_1, _e793, (_e793 < _e480.member.member_1)));
                                        let _e804 = (_e795 <= _e797);
                                        if _e802 {
                                            if _e803 {
                                                if _e804 {
                                                    phi_4454_ = _e717;
                                                } else {
                                                    phi_4454_ = _e712;
                                                }
                                                let _e806 = phi_4454_;
                                                let _e807 = (_e522 % 128u);
                                                let _e808 = (_e807 < 128u);
                                                if _e808 {
                                                } else {
                                                    phi_4729_ = true;
                                                    break;
                                                }
                                                local_3[_e807] = type_50(type_47(array<f32, 3>(_e806.member.member[0], _e806.member.member[1], _e806.member.member[2]), array<f32, 3>(_e806.member.member_1[0], _e806.member.member_1[1], _e806.member.member_1[2])), _e806.member_1);
                                                if _e808 {
                                                } else {
                                                    phi_4729_ = true;
                                                    break;
                                                }
                                                local_2[_e807] = select(_e797, _e795, (_e795 > _e797));
                                                if _e804 {
                                                    phi_4493_ = _e712;
                                                } else {
                                                    phi_4493_ = _e717;
                                                }
                                                let _e829 = phi_4493_;
                                                phi_4494_ = _e829;
                                                phi_4495_ = (_e522 + 1u);
                                            } else {
                                                phi_4494_ = type_50();
                                                phi_4495_ = u32();
                                            }
                                            let _e831 = phi_4494_;
                                            let _e833 = phi_4495_;
                                            phi_4497_ = _e831;
                                            phi_4498_ = _e833;
                                            phi_4499_ = select(true, false, _e803);
                                        } else {
                                            phi_4497_ = type_50();
                                            phi_4498_ = u32();
                                            phi_4499_ = true;
                                        }
                                        let _e836 = phi_4497_;
                                        let _e838 = phi_4498_;
                                        let _e840 = phi_4499_;
                                        if _e840 {
                                            if _e802 {
                                                phi_4506_ = _e712;
                                            } else {
                                                phi_4506_ = _e717;
                                            }
                                            let _e842 = phi_4506_;
                                            phi_4511_ = _e842;
                                            phi_4512_ = select(_e803, true, _e802);
                                        } else {
                                            phi_4511_ = _e836;
                                            phi_4512_ = _e520;
                                        }
                                        let _e845 = phi_4511_;
                                        let _e847 = phi_4512_;
                                        phi_4733_ = _e699;
                                        phi_4514_ = type_37(_e480.member, (_e480.member_1 + 1u), _e480.member_2);
                                        phi_4515_ = _e845;
                                        phi_4516_ = _e847;
                                        phi_4517_ = select(_e838, _e522, _e840);
                                    }
                                    let _e1271 = phi_4733_;
                                    let _e1273 = phi_4514_;
                                    let _e1275 = phi_4515_;
                                    let _e1277 = phi_4516_;
                                    let _e1279 = phi_4517_;
                                    phi_4732_ = _e1271;
                                    phi_4518_ = _e1273;
                                    phi_4519_ = _e1275;
                                    phi_4520_ = (_e484 - 1u);
                                    phi_4521_ = _e1277;
                                    phi_4522_ = _e1279;
                                } else {
                                    phi_4732_ = _e478;
                                    phi_4518_ = _e480;
                                    phi_4519_ = _e518;
                                    phi_4520_ = _e484;
                                    phi_4521_ = _e520;
                                    phi_4522_ = _e522;
                                }
                                let _e1281 = phi_4732_;
                                let _e1283 = phi_4518_;
                                let _e1285 = phi_4519_;
                                let _e1287 = phi_4520_;
                                let _e1289 = phi_4521_;
                                let _e1291 = phi_4522_;
                                phi_4731_ = _e1281;
                                phi_4523_ = _e1283;
                                phi_4524_ = _e1285;
                                phi_4525_ = _e1287;
                                phi_4526_ = _e1289;
                                phi_4527_ = _e1291;
                            } else {
                                phi_4731_ = _e478;
                                phi_4523_ = type_37();
                                phi_4524_ = type_50();
                                phi_4525_ = u32();
                                phi_4526_ = bool();
                                phi_4527_ = u32();
                            }
                            let _e1293 = phi_4731_;
                            let _e1295 = phi_4523_;
                            let _e1297 = phi_4524_;
                            let _e1299 = phi_4525_;
                            let _e1301 = phi_4526_;
                            let _e1303 = phi_4527_;
                            phi_4730_ = _e1293;
                            phi_2833_ = _e1295;
                            phi_2836_ = _e1297;
                            phi_2838_ = _e1299;
                            phi_2840_ = _e1301;
                            phi_2842_ = _e1303;
                            phi_4528_ = _e492;
                        } else {
                            phi_4730_ = _e478;
                            phi_2833_ = type_37();
                            phi_2836_ = type_50();
                            phi_2838_ = u32();
                            phi_2840_ = bool();
                            phi_2842_ = u32();
                            phi_4528_ = false;
                        }
                        let _e1305 = phi_4730_;
                        let _e1307 = phi_2833_;
                        let _e1309 = phi_2836_;
                        let _e1311 = phi_2838_;
                        let _e1313 = phi_2840_;
                        let _e1315 = phi_2842_;
                        let _e1317 = phi_4528_;
                        continue;
                        continuing {
                            phi_4605_ = _e1305;
                            phi_2832_ = _e1307;
                            phi_2835_ = _e1309;
                            phi_2837_ = _e1311;
                            phi_2839_ = _e1313;
                            phi_2841_ = _e1315;
                            phi_4729_ = _e1305;
                            break if !(_e1317);
                        }
                    }
                    let _e1320 = phi_4729_;
                    if _e1320 {
                        break;
                    }
                    let _e1322 = local_12;
                    let _e1325 = local_13;
                    if _e133 {
                    } else {
                        break;
                    }
                    global_6.member[_e131][0u] = _e1322.member_1;
                    global_6.member[_e131][1u] = _e1325.member_2;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_counted_printed_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
