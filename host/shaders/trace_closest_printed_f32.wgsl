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

struct type_24 {
    member: array<type_22>,
}

struct type_26 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_32 {
    member: type_22,
    member_1: f32,
}

struct type_36 {
    member: array<type_26>,
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
var<storage> global_4: type_36;
@group(0) @binding(2) 
var<storage> global_5: type_43;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_24;

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
    var phi_331_: i32;
    var phi_332_: i32;
    var phi_342_: bool;
    var phi_352_: u32;
    var phi_353_: u32;
    var phi_355_: bool;
    var phi_360_: u32;
    var phi_405_: f32;
    var phi_411_: f32;
    var phi_422_: f32;
    var phi_428_: f32;
    var phi_451_: f32;
    var phi_462_: f32;
    var phi_471_: f32;
    var phi_477_: f32;
    var phi_488_: f32;
    var phi_494_: f32;
    var phi_517_: f32;
    var phi_528_: f32;
    var phi_537_: f32;
    var phi_543_: f32;
    var phi_554_: f32;
    var phi_560_: f32;
    var phi_583_: f32;
    var phi_594_: f32;
    var phi_694_: f32;
    var phi_695_: f32;
    var phi_4633_: bool;
    var phi_2823_: type_32;
    var phi_2826_: type_50;
    var phi_2828_: u32;
    var phi_2830_: bool;
    var phi_2832_: u32;
    var phi_2843_: bool;
    var phi_2888_: type_50;
    var phi_2889_: bool;
    var phi_2890_: u32;
    var phi_3688_: type_41;
    var phi_3697_: type_4;
    var phi_3698_: type_4;
    var phi_3721_: type_4;
    var phi_4626_: bool;
    var phi_3851_: type_4;
    var phi_3852_: type_4;
    var phi_3875_: type_4;
    var phi_4682_: bool;
    var phi_4438_: type_50;
    var phi_4477_: type_50;
    var phi_4478_: type_50;
    var phi_4479_: u32;
    var phi_4481_: type_50;
    var phi_4482_: u32;
    var phi_4483_: bool;
    var phi_4490_: type_50;
    var phi_4495_: type_50;
    var phi_4496_: bool;
    var phi_2908_: type_32;
    var phi_2911_: type_4;
    var phi_2912_: type_4;
    var phi_2934_: type_4;
    var phi_2955_: u32;
    var phi_3044_: array<array<f32, 3>, 3>;
    var phi_3515_: vec3<f32>;
    var phi_3516_: vec3<f32>;
    var phi_3547_: bool;
    var phi_3556_: vec3<f32>;
    var phi_3596_: type_22;
    var phi_3598_: type_22;
    var phi_3599_: bool;
    var phi_3603_: type_22;
    var phi_3604_: type_22;
    var phi_3605_: type_22;
    var phi_3606_: bool;
    var phi_3610_: type_22;
    var phi_3611_: bool;
    var phi_3615_: type_22;
    var phi_3616_: bool;
    var phi_3620_: type_22;
    var phi_3645_: bool;
    var phi_3646_: bool;
    var phi_3652_: type_32;
    var phi_3653_: type_32;
    var phi_3654_: type_32;
    var phi_2909_: type_32;
    var phi_4690_: bool;
    var phi_4757_: bool;
    var phi_4498_: type_32;
    var phi_4499_: type_50;
    var phi_4500_: bool;
    var phi_4501_: u32;
    var phi_4756_: bool;
    var phi_4502_: type_32;
    var phi_4503_: type_50;
    var phi_4504_: u32;
    var phi_4505_: bool;
    var phi_4506_: u32;
    var phi_4755_: bool;
    var phi_4507_: type_32;
    var phi_4508_: type_50;
    var phi_4509_: u32;
    var phi_4510_: bool;
    var phi_4511_: u32;
    var phi_4754_: bool;
    var phi_2824_: type_32;
    var phi_2827_: type_50;
    var phi_2829_: u32;
    var phi_2831_: bool;
    var phi_2833_: u32;
    var phi_4512_: bool;
    var phi_4753_: bool;
    var local_12: type_32;
    var phi_4564_: type_22;
    var local_13: type_32;

    switch bitcast<i32>(0u) {
        default: {
            let _e79 = global;
            let _e82 = arrayLength((&global_5.member));
            let _e84 = arrayLength((&global_2.member));
            let _e92 = global_3.member[0u][0u];
            let _e96 = global_3.member[0u][1u];
            let _e100 = global_3.member[0u][2u];
            let _e104 = global_3.member[1u][0u];
            let _e108 = global_3.member[1u][1u];
            let _e112 = global_3.member[1u][2u];
            let _e116 = global_3.member[1u][3u];
            let _e119 = global_1.member[0u];
            let _e120 = bitcast<i32>(_e119);
            let _e130 = (_e79.x + (_e79.y * 2097152u));
            let _e131 = (_e130 < arrayLength((&global_4.member)));
            if _e131 {
                let _e132 = (_e130 < arrayLength((&global_6.member)));
                if _e132 {
                    if _e131 {
                    } else {
                        break;
                    }
                    let _e140 = global_4.member[_e130].member_2[0u];
                    let _e142 = (bitcast<u32>(_e140) & 2147483647u);
                    let _e147 = global_4.member[_e130].member_2[1u];
                    let _e149 = (bitcast<u32>(_e147) & 2147483647u);
                    let _e154 = global_4.member[_e130].member_2[2u];
                    let _e156 = (bitcast<u32>(_e154) & 2147483647u);
                    let _e161 = global_4.member[_e130].member[0u];
                    let _e163 = (bitcast<u32>(_e161) & 2147483647u);
                    let _e168 = global_4.member[_e130].member[1u];
                    let _e170 = (bitcast<u32>(_e168) & 2147483647u);
                    let _e175 = global_4.member[_e130].member[2u];
                    let _e177 = (bitcast<u32>(_e175) & 2147483647u);
                    let _e179 = select(_e149, _e142, (_e149 < _e142));
                    let _e181 = select(_e156, _e179, (_e156 < _e179));
                    let _e183 = select(_e163, _e181, (_e163 < _e181));
                    let _e185 = select(_e170, _e183, (_e170 < _e183));
                    let _e187 = select(_e177, _e185, (_e177 < _e185));
                    let _e191 = global_4.member[_e130].member_1;
                    let _e193 = (bitcast<u32>(_e191) & 2147483647u);
                    let _e200 = global_4.member[_e130].member_3;
                    let _e206 = (((select(_e193, _e187, (_e193 < _e187)) < 2139095040u) && ((bitcast<u32>(_e200) & 2147483647u) <= 2139095040u)) && (_e181 > 0u));
                    if _e206 {
                        let _e209 = (bitcast<u32>(bitcast<f32>(_e181)) & 2147483647u);
                        if (_e209 >= 8388608u) {
                            phi_331_ = (bitcast<i32>((_e209 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_331_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e209)), 32u, (_e209 == 0u))));
                        }
                        let _e223 = phi_331_;
                        phi_332_ = _e223;
                    } else {
                        phi_332_ = 0i;
                    }
                    let _e225 = phi_332_;
                    let _e226 = (_e142 == _e181);
                    if _e226 {
                        phi_342_ = true;
                    } else {
                        phi_342_ = (_e149 == _e181);
                    }
                    let _e229 = phi_342_;
                    let _e230 = select(1u, 0u, _e226);
                    if _e229 {
                        let _e231 = (_e230 + 1u);
                        phi_352_ = _e231;
                        phi_353_ = _e231;
                        phi_355_ = select(true, false, (_e231 == 2u));
                    } else {
                        phi_352_ = u32();
                        phi_353_ = 0u;
                        phi_355_ = true;
                    }
                    let _e235 = phi_352_;
                    let _e237 = phi_353_;
                    let _e239 = phi_355_;
                    if _e239 {
                        phi_360_ = (_e237 + 1u);
                    } else {
                        phi_360_ = 0u;
                    }
                    let _e243 = phi_360_;
                    let _e244 = select(_e235, _e237, _e239);
                    let _e245 = select(_e230, select(2u, _e230, _e229), _e239);
                    let _e246 = (_e120 / 2i);
                    let _e251 = bitcast<f32>((bitcast<u32>((_e246 + 127i)) << bitcast<u32>(23i)));
                    let _e257 = bitcast<f32>((bitcast<u32>(((_e120 - _e246) + 127i)) << bitcast<u32>(23i)));
                    let _e258 = -(_e225);
                    let _e259 = (_e258 / 2i);
                    let _e264 = bitcast<f32>((bitcast<u32>((_e259 + 127i)) << bitcast<u32>(23i)));
                    let _e270 = bitcast<f32>((bitcast<u32>(((_e258 - _e259) + 127i)) << bitcast<u32>(23i)));
                    let _e274 = global_4.member[_e130].member;
                    let _e275 = (_e244 == 0u);
                    if _e275 {
                        phi_405_ = _e274[0];
                    } else {
                        phi_405_ = _e274[1];
                    }
                    let _e279 = phi_405_;
                    let _e280 = (_e244 == 2u);
                    if _e280 {
                        phi_411_ = _e274[2];
                    } else {
                        phi_411_ = _e279;
                    }
                    let _e283 = phi_411_;
                    let _e285 = ((_e283 * _e251) * _e257);
                    let _e286 = global_4.member[_e130].member_2;
                    if _e275 {
                        phi_422_ = _e286[0];
                    } else {
                        phi_422_ = _e286[1];
                    }
                    let _e290 = phi_422_;
                    if _e280 {
                        phi_428_ = _e286[2];
                    } else {
                        phi_428_ = _e290;
                    }
                    let _e293 = phi_428_;
                    let _e295 = ((_e293 * _e264) * _e270);
                    let _e299 = (bitcast<f32>((bitcast<u32>(_e295) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e299 {
                        let _e303 = (bitcast<f32>((bitcast<u32>(_e285) & 2147483647u)) * 0.00000011920929f);
                        phi_451_ = select(0.00000000000011368684f, _e303, (_e303 > 0.00000000000011368684f));
                    } else {
                        phi_451_ = 0f;
                    }
                    let _e307 = phi_451_;
                    let _e308 = (_e285 + _e307);
                    let _e309 = (_e285 - _e307);
                    let _e310 = select(_e295, 0f, _e299);
                    if _e299 {
                        phi_462_ = 38685626000000000000000000f;
                    } else {
                        phi_462_ = (1f / _e295);
                    }
                    let _e313 = phi_462_;
                    let _e314 = (_e243 == 0u);
                    if _e314 {
                        phi_471_ = _e274[0];
                    } else {
                        phi_471_ = _e274[1];
                    }
                    let _e318 = phi_471_;
                    let _e319 = (_e243 == 2u);
                    if _e319 {
                        phi_477_ = _e274[2];
                    } else {
                        phi_477_ = _e318;
                    }
                    let _e322 = phi_477_;
                    let _e324 = ((_e322 * _e251) * _e257);
                    if _e314 {
                        phi_488_ = _e286[0];
                    } else {
                        phi_488_ = _e286[1];
                    }
                    let _e328 = phi_488_;
                    if _e319 {
                        phi_494_ = _e286[2];
                    } else {
                        phi_494_ = _e328;
                    }
                    let _e331 = phi_494_;
                    let _e333 = ((_e331 * _e264) * _e270);
                    let _e337 = (bitcast<f32>((bitcast<u32>(_e333) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e337 {
                        let _e341 = (bitcast<f32>((bitcast<u32>(_e324) & 2147483647u)) * 0.00000011920929f);
                        phi_517_ = select(0.00000000000011368684f, _e341, (_e341 > 0.00000000000011368684f));
                    } else {
                        phi_517_ = 0f;
                    }
                    let _e345 = phi_517_;
                    let _e346 = (_e324 + _e345);
                    let _e347 = (_e324 - _e345);
                    let _e348 = select(_e333, 0f, _e337);
                    if _e337 {
                        phi_528_ = 38685626000000000000000000f;
                    } else {
                        phi_528_ = (1f / _e333);
                    }
                    let _e351 = phi_528_;
                    let _e352 = (_e245 == 0u);
                    if _e352 {
                        phi_537_ = _e274[0];
                    } else {
                        phi_537_ = _e274[1];
                    }
                    let _e356 = phi_537_;
                    let _e357 = (_e245 == 2u);
                    if _e357 {
                        phi_543_ = _e274[2];
                    } else {
                        phi_543_ = _e356;
                    }
                    let _e360 = phi_543_;
                    let _e362 = ((_e360 * _e251) * _e257);
                    if _e352 {
                        phi_554_ = _e286[0];
                    } else {
                        phi_554_ = _e286[1];
                    }
                    let _e366 = phi_554_;
                    if _e357 {
                        phi_560_ = _e286[2];
                    } else {
                        phi_560_ = _e366;
                    }
                    let _e369 = phi_560_;
                    let _e371 = ((_e369 * _e264) * _e270);
                    let _e375 = (bitcast<f32>((bitcast<u32>(_e371) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e375 {
                        let _e379 = (bitcast<f32>((bitcast<u32>(_e362) & 2147483647u)) * 0.00000011920929f);
                        phi_583_ = select(0.00000000000011368684f, _e379, (_e379 > 0.00000000000011368684f));
                    } else {
                        phi_583_ = 0f;
                    }
                    let _e383 = phi_583_;
                    let _e384 = (_e362 + _e383);
                    let _e385 = (_e362 - _e383);
                    let _e386 = select(_e371, 0f, _e375);
                    if _e375 {
                        phi_594_ = 38685626000000000000000000f;
                    } else {
                        phi_594_ = (1f / _e371);
                    }
                    let _e389 = phi_594_;
                    let _e392 = bitcast<f32>((bitcast<u32>(_e285) & 2147483647u));
                    let _e395 = bitcast<f32>((bitcast<u32>(_e324) & 2147483647u));
                    let _e397 = select(_e395, _e392, (_e392 > _e395));
                    let _e400 = bitcast<f32>((bitcast<u32>(_e362) & 2147483647u));
                    let _e403 = (_e120 + _e225);
                    if (_e206 && (select(_e400, _e397, (_e397 > _e400)) <= 1099511600000f)) {
                        let _e406 = (_e403 / 3i);
                        let _e413 = bitcast<f32>((bitcast<u32>((_e406 + 127i)) << bitcast<u32>(23i)));
                        let _e420 = bitcast<f32>((bitcast<u32>(((_e403 - (2i * _e406)) + 127i)) << bitcast<u32>(23i)));
                        let _e421 = (((_e191 * _e413) * _e413) * _e420);
                        let _e423 = select(340282350000000000000000000000000000000f, _e421, (_e421 < 340282350000000000000000000000000000000f));
                        let _e428 = (((_e200 * _e413) * _e413) * _e420);
                        let _e430 = select(340282350000000000000000000000000000000f, _e428, (_e428 < 340282350000000000000000000000000000000f));
                        phi_694_ = select(-340282350000000000000000000000000000000f, _e430, (_e430 > -340282350000000000000000000000000000000f));
                        phi_695_ = select(-340282350000000000000000000000000000000f, _e423, (_e423 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_694_ = 0f;
                        phi_695_ = 1f;
                    }
                    let _e434 = phi_694_;
                    let _e436 = phi_695_;
                    local_3 = array<type_50, 128>(type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u));
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_11 = array<f32, 3>(bitcast<f32>(_e92), bitcast<f32>(_e96), bitcast<f32>(_e100));
                    let _e441 = (_e244 % 3u);
                    let _e442 = (_e441 < 3u);
                    if _e442 {
                    } else {
                        break;
                    }
                    let _e444 = local_11[_e441];
                    let _e445 = (_e243 % 3u);
                    let _e446 = (_e445 < 3u);
                    if _e446 {
                    } else {
                        break;
                    }
                    let _e448 = local_11[_e445];
                    let _e449 = (_e245 % 3u);
                    let _e450 = (_e449 < 3u);
                    if _e450 {
                    } else {
                        break;
                    }
                    let _e452 = local_11[_e449];
                    local_10 = array<f32, 3>(bitcast<f32>(_e104), bitcast<f32>(_e108), bitcast<f32>(_e112));
                    if _e442 {
                    } else {
                        break;
                    }
                    let _e456 = local_10[_e441];
                    if _e446 {
                    } else {
                        break;
                    }
                    let _e458 = local_10[_e445];
                    if _e450 {
                    } else {
                        break;
                    }
                    let _e460 = local_10[_e449];
                    phi_4633_ = false;
                    phi_2823_ = type_32(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e434);
                    phi_2826_ = type_50(type_47(array<f32, 3>(_e444, _e448, _e452), array<f32, 3>(_e456, _e458, _e460)), select(0u, 2147483648u, (_e82 == 0u)));
                    phi_2828_ = ((3u * _e82) + 1u);
                    phi_2830_ = (_e436 <= _e434);
                    phi_2832_ = 0u;
                    loop {
                        let _e468 = phi_4633_;
                        let _e470 = phi_2823_;
                        let _e472 = phi_2826_;
                        let _e474 = phi_2828_;
                        let _e476 = phi_2830_;
                        let _e478 = phi_2832_;
                        local_12 = _e470;
                        if _e476 {
                            phi_2843_ = true;
                        } else {
                            phi_2843_ = (_e478 > 0u);
                        }
                        let _e481 = phi_2843_;
                        if _e481 {
                            let _e482 = (_e474 > 0u);
                            if _e482 {
                                if _e476 {
                                    phi_2888_ = _e472;
                                    phi_2889_ = _e476;
                                    phi_2890_ = _e478;
                                } else {
                                    let _e483 = (_e478 - 1u);
                                    let _e484 = (_e483 % 128u);
                                    let _e485 = (_e484 < 128u);
                                    if _e485 {
                                    } else {
                                        phi_4753_ = true;
                                        break;
                                    }
                                    let _e487 = local_3[_e484];
                                    if _e485 {
                                    } else {
                                        phi_4753_ = true;
                                        break;
                                    }
                                    let _e503 = local_2[_e484];
                                    phi_2888_ = type_50(type_47(array<f32, 3>(_e487.member.member[0], _e487.member.member[1], _e487.member.member[2]), array<f32, 3>(_e487.member.member_1[0], _e487.member.member_1[1], _e487.member.member_1[2])), _e487.member_1);
                                    phi_2889_ = (_e503 <= _e470.member_1);
                                    phi_2890_ = _e483;
                                }
                                let _e507 = phi_2888_;
                                let _e509 = phi_2889_;
                                let _e511 = phi_2890_;
                                if _e509 {
                                    if ((_e507.member_1 & 2147483648u) != 0u) {
                                        phi_2908_ = _e470;
                                        phi_2911_ = type_4(0u, ((_e507.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e833 = phi_2908_;
                                            let _e835 = phi_2911_;
                                            local_13 = _e833;
                                            if (_e835.member < _e835.member_1) {
                                                phi_2912_ = type_4((_e835.member + 1u), _e835.member_1);
                                                phi_2934_ = type_4(1u, _e835.member);
                                            } else {
                                                phi_2912_ = _e835;
                                                phi_2934_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e848 = phi_2912_;
                                            let _e850 = phi_2934_;
                                            let _e854 = (bitcast<i32>(_e850.member) != 0i);
                                            if _e854 {
                                                let _e855 = ((_e507.member_1 & 268435455u) + _e850.member_1);
                                                let _e856 = (_e855 < _e84);
                                                if _e856 {
                                                    if _e856 {
                                                    } else {
                                                        phi_4690_ = true;
                                                        break;
                                                    }
                                                    let _e860 = global_2.member[_e855].member_1;
                                                    phi_2955_ = _e860;
                                                } else {
                                                    phi_2955_ = 4294967295u;
                                                }
                                                let _e862 = phi_2955_;
                                                if (_e855 >= _e84) {
                                                    phi_3044_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e856 {
                                                    } else {
                                                        phi_4690_ = true;
                                                        break;
                                                    }
                                                    if (_e441 < 9u) {
                                                    } else {
                                                        phi_4690_ = true;
                                                        break;
                                                    }
                                                    let _e869 = global_2.member[_e855].member[_e441];
                                                    if (_e445 < 9u) {
                                                    } else {
                                                        phi_4690_ = true;
                                                        break;
                                                    }
                                                    let _e875 = global_2.member[_e855].member[_e445];
                                                    if (_e449 < 9u) {
                                                    } else {
                                                        phi_4690_ = true;
                                                        break;
                                                    }
                                                    let _e881 = global_2.member[_e855].member[_e449];
                                                    let _e883 = (3u + _e441);
                                                    if (_e883 < 9u) {
                                                    } else {
                                                        phi_4690_ = true;
                                                        break;
                                                    }
                                                    let _e889 = global_2.member[_e855].member[_e883];
                                                    let _e890 = (3u + _e445);
                                                    if (_e890 < 9u) {
                                                    } else {
                                                        phi_4690_ = true;
                                                        break;
                                                    }
                                                    let _e896 = global_2.member[_e855].member[_e890];
                                                    let _e897 = (3u + _e449);
                                                    if (_e897 < 9u) {
                                                    } else {
                                                        phi_4690_ = true;
                                                        break;
                                                    }
                                                    let _e903 = global_2.member[_e855].member[_e897];
                                                    let _e905 = (6u + _e441);
                                                    if (_e905 < 9u) {
                                                    } else {
                                                        phi_4690_ = true;
                                                        break;
                                                    }
                                                    let _e911 = global_2.member[_e855].member[_e905];
                                                    let _e912 = (6u + _e445);
                                                    if (_e912 < 9u) {
                                                    } else {
                                                        phi_4690_ = true;
                                                        break;
                                                    }
                                                    let _e918 = global_2.member[_e855].member[_e912];
                                                    let _e919 = (6u + _e449);
                                                    if (_e919 < 9u) {
                                                    } else {
                                                        phi_4690_ = true;
                                                        break;
                                                    }
                                                    let _e925 = global_2.member[_e855].member[_e919];
                                                    phi_3044_ = array<array<f32, 3>, 3>(array<f32, 3>(_e869, _e875, _e881), array<f32, 3>(_e889, _e896, _e903), array<f32, 3>(_e911, _e918, _e925));
                                                }
                                                let _e929 = phi_3044_;
                                                let _e937 = (_e929[0][2] - _e362);
                                                let _e940 = (((_e929[0][0] - _e285) * _e386) - (_e937 * _e310));
                                                let _e943 = (((_e929[0][1] - _e324) * _e386) - (_e937 * _e348));
                                                let _e950 = (_e929[1][2] - _e362);
                                                let _e953 = (((_e929[1][0] - _e285) * _e386) - (_e950 * _e310));
                                                let _e956 = (((_e929[1][1] - _e324) * _e386) - (_e950 * _e348));
                                                let _e963 = (_e929[2][2] - _e362);
                                                let _e966 = (((_e929[2][0] - _e285) * _e386) - (_e963 * _e310));
                                                let _e969 = (((_e929[2][1] - _e324) * _e386) - (_e963 * _e348));
                                                let _e970 = (_e966 * _e956);
                                                let _e971 = (_e969 * _e953);
                                                let _e972 = (_e940 * _e969);
                                                let _e973 = (_e943 * _e966);
                                                let _e974 = (_e953 * _e943);
                                                let _e975 = (_e956 * _e940);
                                                let _e980 = (((_e970 >= _e971) && (_e972 >= _e973)) && (_e974 >= _e975));
                                                if (_e980 || (((_e970 <= _e971) && (_e972 <= _e973)) && (_e974 <= _e975))) {
                                                    let _e987 = select(-1f, 1f, _e980);
                                                    let _e989 = ((_e970 - _e971) * _e987);
                                                    let _e991 = select(0f, _e989, (_e989 > 0f));
                                                    let _e993 = ((_e972 - _e973) * _e987);
                                                    let _e995 = select(0f, _e993, (_e993 > 0f));
                                                    let _e997 = ((_e974 - _e975) * _e987);
                                                    let _e999 = select(0f, _e997, (_e997 > 0f));
                                                    let _e1001 = ((_e991 + _e995) + _e999);
                                                    if (_e1001 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_3610_ = type_22();
                                                        phi_3611_ = true;
                                                    } else {
                                                        let _e1004 = select(_e929[1][0], _e929[0][0], (_e929[0][0] < _e929[1][0]));
                                                        let _e1008 = select(_e929[1][0], _e929[0][0], (_e929[0][0] > _e929[1][0]));
                                                        let _e1012 = select(_e929[1][1], _e929[0][1], (_e929[0][1] < _e929[1][1]));
                                                        let _e1016 = select(_e929[1][1], _e929[0][1], (_e929[0][1] > _e929[1][1]));
                                                        let _e1020 = select(_e929[1][2], _e929[0][2], (_e929[0][2] < _e929[1][2]));
                                                        let _e1024 = select(_e929[1][2], _e929[0][2], (_e929[0][2] > _e929[1][2]));
                                                        let _e1029 = ((select(_e929[2][0], _e1004, (_e1004 < _e929[2][0])) - _e308) * _e313);
                                                        let _e1030 = ((select(_e929[2][0], _e1008, (_e1008 > _e929[2][0])) - _e309) * _e313);
                                                        let _e1033 = ((select(_e929[2][1], _e1012, (_e1012 < _e929[2][1])) - _e346) * _e351);
                                                        let _e1034 = ((select(_e929[2][1], _e1016, (_e1016 > _e929[2][1])) - _e347) * _e351);
                                                        let _e1037 = ((select(_e929[2][2], _e1020, (_e1020 < _e929[2][2])) - _e384) * _e389);
                                                        let _e1038 = ((select(_e929[2][2], _e1024, (_e1024 > _e929[2][2])) - _e385) * _e389);
                                                        let _e1040 = select(_e1038, _e1037, (_e1037 < _e1038));
                                                        let _e1042 = select(_e1038, _e1037, (_e1037 > _e1038));
                                                        let _e1044 = select(_e1030, _e1029, (_e1029 < _e1030));
                                                        let _e1046 = select(_e1034, _e1033, (_e1033 < _e1034));
                                                        let _e1048 = select(_e1046, _e1044, (_e1044 > _e1046));
                                                        let _e1050 = select(_e1040, _e1048, (_e1048 > _e1040));
                                                        let _e1052 = select(_e1030, _e1029, (_e1029 > _e1030));
                                                        let _e1054 = select(_e1034, _e1033, (_e1033 > _e1034));
                                                        let _e1056 = select(_e1054, _e1052, (_e1052 < _e1054));
                                                        let _e1058 = select(_e1042, _e1056, (_e1056 < _e1042));
                                                        let _e1059 = -(_e1040);
                                                        let _e1065 = select(_e436, _e1050, (_e1050 > _e436));
                                                        if (_e1065 > (_e1058 + (select(_e1059, _e1042, (_e1042 > _e1059)) * 0.0000019073523f))) {
                                                            phi_3605_ = type_22();
                                                            phi_3606_ = true;
                                                        } else {
                                                            let _e1067 = (_e1065 > _e833.member_1);
                                                            if _e1067 {
                                                                phi_3604_ = type_22();
                                                            } else {
                                                                let _e1071 = (_e929[1][0] - _e929[0][0]);
                                                                let _e1072 = (_e929[1][1] - _e929[0][1]);
                                                                let _e1073 = (_e929[1][2] - _e929[0][2]);
                                                                let _e1074 = vec3<f32>(_e1071, _e1072, _e1073);
                                                                let _e1075 = (_e929[2][0] - _e929[1][0]);
                                                                let _e1076 = (_e929[2][1] - _e929[1][1]);
                                                                let _e1077 = (_e929[2][2] - _e929[1][2]);
                                                                let _e1078 = vec3<f32>(_e1075, _e1076, _e1077);
                                                                let _e1079 = (_e929[0][0] - _e929[2][0]);
                                                                let _e1080 = (_e929[0][1] - _e929[2][1]);
                                                                let _e1081 = (_e929[0][2] - _e929[2][2]);
                                                                let _e1082 = vec3<f32>(_e1079, _e1080, _e1081);
                                                                let _e1085 = bitcast<f32>((bitcast<u32>(_e1071) & 2147483647u));
                                                                let _e1088 = bitcast<f32>((bitcast<u32>(_e1072) & 2147483647u));
                                                                let _e1090 = select(_e1088, _e1085, (_e1085 > _e1088));
                                                                let _e1093 = bitcast<f32>((bitcast<u32>(_e1073) & 2147483647u));
                                                                let _e1095 = select(_e1093, _e1090, (_e1090 > _e1093));
                                                                let _e1098 = bitcast<f32>((bitcast<u32>(_e1075) & 2147483647u));
                                                                let _e1101 = bitcast<f32>((bitcast<u32>(_e1076) & 2147483647u));
                                                                let _e1103 = select(_e1101, _e1098, (_e1098 > _e1101));
                                                                let _e1106 = bitcast<f32>((bitcast<u32>(_e1077) & 2147483647u));
                                                                let _e1108 = select(_e1106, _e1103, (_e1103 > _e1106));
                                                                let _e1111 = bitcast<f32>((bitcast<u32>(_e1079) & 2147483647u));
                                                                let _e1114 = bitcast<f32>((bitcast<u32>(_e1080) & 2147483647u));
                                                                let _e1116 = select(_e1114, _e1111, (_e1111 > _e1114));
                                                                let _e1119 = bitcast<f32>((bitcast<u32>(_e1081) & 2147483647u));
                                                                let _e1121 = select(_e1119, _e1116, (_e1116 > _e1119));
                                                                let _e1123 = select(_e1108, _e1095, (_e1095 > _e1108));
                                                                let _e1125 = select(_e1121, _e1123, (_e1123 > _e1121));
                                                                if (_e1095 == _e1125) {
                                                                    phi_3515_ = _e1078;
                                                                    phi_3516_ = _e1082;
                                                                } else {
                                                                    let _e1128 = vec3((_e1108 == _e1125));
                                                                    phi_3515_ = select(_e1074, _e1082, _e1128);
                                                                    phi_3516_ = select(_e1078, _e1074, _e1128);
                                                                }
                                                                let _e1132 = phi_3515_;
                                                                let _e1134 = phi_3516_;
                                                                let _e1141 = ((_e1132.y * _e1134.z) - (_e1134.y * _e1132.z));
                                                                let _e1146 = ((_e1132.z * _e1134.x) - (_e1134.z * _e1132.x));
                                                                let _e1149 = ((_e1132.x * _e1134.y) - (_e1134.x * _e1132.y));
                                                                if (_e991 >= _e995) {
                                                                    phi_3547_ = select(true, false, (_e991 >= _e999));
                                                                } else {
                                                                    phi_3547_ = true;
                                                                }
                                                                let _e1154 = phi_3547_;
                                                                if _e1154 {
                                                                    phi_3556_ = select(vec3<f32>(_e929[2][0], _e929[2][1], _e929[2][2]), vec3<f32>(_e929[1][0], _e929[1][1], _e929[1][2]), vec3((_e995 >= _e999)));
                                                                } else {
                                                                    phi_3556_ = vec3<f32>(_e929[0][0], _e929[0][1], _e929[0][2]);
                                                                }
                                                                let _e1159 = phi_3556_;
                                                                let _e1176 = ((((_e1141 * (_e1159.x - _e285)) + (_e1146 * (_e1159.y - _e324))) + (_e1149 * (_e1159.z - _e362))) / (((_e1141 * _e310) + (_e1146 * _e348)) + (_e1149 * _e386)));
                                                                let _e1178 = select(_e1058, _e1176, (_e1176 < _e1058));
                                                                let _e1180 = select(_e1050, _e1178, (_e1178 > _e1050));
                                                                if (_e1180 >= _e436) {
                                                                    let _e1182 = (_e1180 <= _e833.member_1);
                                                                    if _e1182 {
                                                                        let _e1183 = (1f / _e1001);
                                                                        phi_3596_ = type_22(_e1180, (_e995 * _e1183), (_e999 * _e1183), _e862);
                                                                    } else {
                                                                        phi_3596_ = type_22();
                                                                    }
                                                                    let _e1188 = phi_3596_;
                                                                    phi_3598_ = _e1188;
                                                                    phi_3599_ = select(true, false, _e1182);
                                                                } else {
                                                                    phi_3598_ = type_22();
                                                                    phi_3599_ = true;
                                                                }
                                                                let _e1191 = phi_3598_;
                                                                let _e1193 = phi_3599_;
                                                                if _e1193 {
                                                                    phi_3603_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_3603_ = _e1191;
                                                                }
                                                                let _e1195 = phi_3603_;
                                                                phi_3604_ = _e1195;
                                                            }
                                                            let _e1197 = phi_3604_;
                                                            phi_3605_ = _e1197;
                                                            phi_3606_ = _e1067;
                                                        }
                                                        let _e1199 = phi_3605_;
                                                        let _e1201 = phi_3606_;
                                                        phi_3610_ = _e1199;
                                                        phi_3611_ = _e1201;
                                                    }
                                                    let _e1203 = phi_3610_;
                                                    let _e1205 = phi_3611_;
                                                    phi_3615_ = _e1203;
                                                    phi_3616_ = _e1205;
                                                } else {
                                                    phi_3615_ = type_22();
                                                    phi_3616_ = true;
                                                }
                                                let _e1207 = phi_3615_;
                                                let _e1209 = phi_3616_;
                                                if _e1209 {
                                                    phi_3620_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_3620_ = _e1207;
                                                }
                                                let _e1211 = phi_3620_;
                                                if (_e1211.member_3 != 4294967295u) {
                                                    if (_e862 != 4294967295u) {
                                                        if (_e1211.member < _e833.member.member) {
                                                            phi_3646_ = true;
                                                        } else {
                                                            if (_e1211.member == _e833.member.member) {
                                                                phi_3645_ = (_e1211.member_3 < _e833.member.member_3);
                                                            } else {
                                                                phi_3645_ = false;
                                                            }
                                                            let _e1224 = phi_3645_;
                                                            phi_3646_ = _e1224;
                                                        }
                                                        let _e1226 = phi_3646_;
                                                        if _e1226 {
                                                            phi_3652_ = type_32(_e1211, _e1211.member);
                                                        } else {
                                                            phi_3652_ = _e833;
                                                        }
                                                        let _e1229 = phi_3652_;
                                                        phi_3653_ = _e1229;
                                                    } else {
                                                        phi_3653_ = _e833;
                                                    }
                                                    let _e1231 = phi_3653_;
                                                    phi_3654_ = _e1231;
                                                } else {
                                                    phi_3654_ = _e833;
                                                }
                                                let _e1233 = phi_3654_;
                                                phi_2909_ = _e1233;
                                            } else {
                                                phi_2909_ = type_32();
                                            }
                                            let _e1235 = phi_2909_;
                                            continue;
                                            continuing {
                                                phi_2908_ = _e1235;
                                                phi_2911_ = _e848;
                                                phi_4690_ = _e468;
                                                break if !(_e854);
                                            }
                                        }
                                        let _e1238 = phi_4690_;
                                        phi_4753_ = _e1238;
                                        if _e1238 {
                                            break;
                                        }
                                        phi_4757_ = _e1238;
                                        let _e1412 = local_13;
                                        phi_4498_ = _e1412;
                                        phi_4499_ = _e507;
                                        phi_4500_ = false;
                                        phi_4501_ = _e511;
                                    } else {
                                        local_1 = array<f32, 3>(_e507.member.member[0], _e507.member.member[1], _e507.member.member[2]);
                                        local = array<f32, 3>(_e507.member.member_1[0], _e507.member.member_1[1], _e507.member.member_1[2]);
                                        let _e531 = (_e507.member_1 < _e82);
                                        if _e531 {
                                            if _e531 {
                                            } else {
                                                phi_4753_ = true;
                                                break;
                                            }
                                            let _e533 = global_5.member[_e507.member_1];
                                            phi_3688_ = _e533;
                                        } else {
                                            phi_3688_ = type_41(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e535 = phi_3688_;
                                        let _e537 = array<u32, 3>(_e244, _e243, _e245);
                                        local_9 = _e537;
                                        local_5 = array<f32, 3>(0f, 0f, 0f);
                                        local_4 = array<f32, 3>(0f, 0f, 0f);
                                        phi_3697_ = type_4(0u, 3u);
                                        loop {
                                            let _e539 = phi_3697_;
                                            if (_e539.member < _e539.member_1) {
                                                phi_3698_ = type_4((_e539.member + 1u), _e539.member_1);
                                                phi_3721_ = type_4(1u, _e539.member);
                                            } else {
                                                phi_3698_ = _e539;
                                                phi_3721_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e552 = phi_3698_;
                                            let _e554 = phi_3721_;
                                            let _e558 = (bitcast<i32>(_e554.member) != 0i);
                                            if _e558 {
                                                let _e559 = (_e554.member_1 < 3u);
                                                if _e559 {
                                                } else {
                                                    phi_4626_ = true;
                                                    break;
                                                }
                                                let _e561 = local_9[_e554.member_1];
                                                if _e559 {
                                                } else {
                                                    phi_4626_ = true;
                                                    break;
                                                }
                                                let _e563 = local_1[_e554.member_1];
                                                if _e559 {
                                                } else {
                                                    phi_4626_ = true;
                                                    break;
                                                }
                                                let _e565 = local[_e554.member_1];
                                                let _e568 = ((10u * _e561) & 31u);
                                                let _e571 = ((_e535.member[0] >> bitcast<u32>(_e568)) & 1023u);
                                                let _e576 = bitcast<f32>((bitcast<u32>(((_e565 - _e563) * 0.0009775171f)) ^ _e116));
                                                let _e582 = (_e563 + bitcast<f32>((bitcast<u32>((f32(_e571) * _e576)) ^ _e116)));
                                                if _e559 {
                                                } else {
                                                    phi_4626_ = true;
                                                    break;
                                                }
                                                local_5[_e554.member_1] = select(select(_e565, _e582, (_e582 < _e565)), _e565, (_e571 == 1023u));
                                                let _e591 = ((_e535.member[1] >> bitcast<u32>(_e568)) & 1023u);
                                                let _e597 = (_e563 + bitcast<f32>((bitcast<u32>((f32(_e591) * _e576)) ^ _e116)));
                                                if _e559 {
                                                } else {
                                                    phi_4626_ = true;
                                                    break;
                                                }
                                                local_4[_e554.member_1] = select(select(_e565, _e597, (_e597 < _e565)), _e565, (_e591 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_3697_ = _e552;
                                                phi_4626_ = _e468;
                                                break if !(_e558);
                                            }
                                        }
                                        let _e605 = phi_4626_;
                                        phi_4753_ = _e605;
                                        if _e605 {
                                            break;
                                        }
                                        let _e606 = local_4;
                                        let _e607 = local_5;
                                        local_8 = _e537;
                                        local_7 = array<f32, 3>(0f, 0f, 0f);
                                        local_6 = array<f32, 3>(0f, 0f, 0f);
                                        phi_3851_ = type_4(0u, 3u);
                                        loop {
                                            let _e616 = phi_3851_;
                                            if (_e616.member < _e616.member_1) {
                                                phi_3852_ = type_4((_e616.member + 1u), _e616.member_1);
                                                phi_3875_ = type_4(1u, _e616.member);
                                            } else {
                                                phi_3852_ = _e616;
                                                phi_3875_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e629 = phi_3852_;
                                            let _e631 = phi_3875_;
                                            let _e635 = (bitcast<i32>(_e631.member) != 0i);
                                            if _e635 {
                                                let _e636 = (_e631.member_1 < 3u);
                                                if _e636 {
                                                } else {
                                                    phi_4682_ = true;
                                                    break;
                                                }
                                                let _e638 = local_8[_e631.member_1];
                                                if _e636 {
                                                } else {
                                                    phi_4682_ = true;
                                                    break;
                                                }
                                                let _e640 = local_1[_e631.member_1];
                                                if _e636 {
                                                } else {
                                                    phi_4682_ = true;
                                                    break;
                                                }
                                                let _e642 = local[_e631.member_1];
                                                let _e645 = ((10u * _e638) & 31u);
                                                let _e648 = ((_e535.member_1[0] >> bitcast<u32>(_e645)) & 1023u);
                                                let _e653 = bitcast<f32>((bitcast<u32>(((_e642 - _e640) * 0.0009775171f)) ^ _e116));
                                                let _e659 = (_e640 + bitcast<f32>((bitcast<u32>((f32(_e648) * _e653)) ^ _e116)));
                                                if _e636 {
                                                } else {
                                                    phi_4682_ = true;
                                                    break;
                                                }
                                                local_7[_e631.member_1] = select(select(_e642, _e659, (_e659 < _e642)), _e642, (_e648 == 1023u));
                                                let _e668 = ((_e535.member_1[1] >> bitcast<u32>(_e645)) & 1023u);
                                                let _e674 = (_e640 + bitcast<f32>((bitcast<u32>((f32(_e668) * _e653)) ^ _e116)));
                                                if _e636 {
                                                } else {
                                                    phi_4682_ = true;
                                                    break;
                                                }
                                                local_6[_e631.member_1] = select(select(_e642, _e674, (_e674 < _e642)), _e642, (_e668 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_3851_ = _e629;
                                                phi_4682_ = _e605;
                                                break if !(_e635);
                                            }
                                        }
                                        let _e682 = phi_4682_;
                                        phi_4753_ = _e682;
                                        if _e682 {
                                            break;
                                        }
                                        let _e683 = local_6;
                                        let _e684 = local_7;
                                        let _e695 = type_50(type_47(array<f32, 3>(_e607[0], _e607[1], _e607[2]), array<f32, 3>(_e606[0], _e606[1], _e606[2])), _e535.member_2);
                                        let _e700 = type_50(type_47(array<f32, 3>(_e684[0], _e684[1], _e684[2]), array<f32, 3>(_e683[0], _e683[1], _e683[2])), _e535.member_3);
                                        let _e706 = ((_e607[0] - _e308) * _e313);
                                        let _e707 = ((_e684[0] - _e308) * _e313);
                                        let _e708 = ((_e606[0] - _e309) * _e313);
                                        let _e709 = ((_e683[0] - _e309) * _e313);
                                        let _e714 = ((_e607[1] - _e346) * _e351);
                                        let _e715 = ((_e684[1] - _e346) * _e351);
                                        let _e716 = ((_e606[1] - _e347) * _e351);
                                        let _e717 = ((_e683[1] - _e347) * _e351);
                                        let _e722 = ((_e607[2] - _e384) * _e389);
                                        let _e723 = ((_e684[2] - _e384) * _e389);
                                        let _e724 = ((_e606[2] - _e385) * _e389);
                                        let _e725 = ((_e683[2] - _e385) * _e389);
                                        let _e727 = select(_e724, _e722, (_e722 < _e724));
                                        let _e729 = select(_e725, _e723, (_e723 < _e725));
                                        let _e731 = select(_e724, _e722, (_e722 > _e724));
                                        let _e733 = select(_e725, _e723, (_e723 > _e725));
                                        let _e735 = select(_e708, _e706, (_e706 < _e708));
                                        let _e737 = select(_e709, _e707, (_e707 < _e709));
                                        let _e739 = select(_e716, _e714, (_e714 < _e716));
                                        let _e741 = select(_e717, _e715, (_e715 < _e717));
                                        let _e743 = select(_e739, _e735, (_e735 > _e739));
                                        let _e745 = select(_e741, _e737, (_e737 > _e741));
                                        let _e747 = select(_e727, _e743, (_e743 > _e727));
                                        let _e749 = select(_e729, _e745, (_e745 > _e729));
                                        let _e751 = select(_e708, _e706, (_e706 > _e708));
                                        let _e753 = select(_e709, _e707, (_e707 > _e709));
                                        let _e755 = select(_e716, _e714, (_e714 > _e716));
                                        let _e757 = select(_e717, _e715, (_e715 > _e717));
                                        let _e759 = select(_e755, _e751, (_e751 < _e755));
                                        let _e761 = select(_e757, _e753, (_e753 < _e757));
                                        let _e766 = -(_e727);
                                        let _e767 = -(_e729);
                                        let _e774 = (select(_e731, _e759, (_e759 < _e731)) + (select(_e766, _e731, (_e731 > _e766)) * 0.0000019073523f));
                                        let _e775 = (select(_e733, _e761, (_e761 < _e733)) + (select(_e767, _e733, (_e733 > _e767)) * 0.0000019073523f));
                                        let _e777 = select(_e436, _e747, (_e747 > _e436));
                                        let _e779 = select(_e436, _e749, (_e749 > _e436));
                                        let _e784 = (_e777 <= select(_e470.member_1, _e774, (_e774 < _e470.member_1)));
                                        let _e785 = (_e779 <= select(_e470.member_1, _e775, (_e775 < _e470.member_1)));
                                        let _e786 = (_e777 <= _e779);
                                        if _e784 {
                                            if _e785 {
                                                if _e786 {
                                                    phi_4438_ = _e700;
                                                } else {
                                                    phi_4438_ = _e695;
                                                }
                                                let _e788 = phi_4438_;
                                                let _e789 = (_e511 % 128u);
                                                let _e790 = (_e789 < 128u);
                                                if _e790 {
                                                } else {
                                                    phi_4753_ = true;
                                                    break;
                                                }
                                                local_3[_e789] = type_50(type_47(array<f32, 3>(_e788.member.member[0], _e788.member.member[1], _e788.member.member[2]), array<f32, 3>(_e788.member.member_1[0], _e788.member.member_1[1], _e788.member.member_1[2])), _e788.member_1);
                                                if _e790 {
                                                } else {
                                                    phi_4753_ = true;
                                                    break;
                                                }
                                                local_2[_e789] = select(_e779, _e777, (_e777 > _e779));
                                                if _e786 {
                                                    phi_4477_ = _e695;
                                                } else {
                                                    phi_4477_ = _e700;
                                                }
                                                let _e811 = phi_4477_;
                                                phi_4478_ = _e811;
                                                phi_4479_ = (_e511 + 1u);
                                            } else {
                                                phi_4478_ = type_50();
                                                phi_4479_ = u32();
                                            }
                                            let _e813 = phi_4478_;
                                            let _e815 = phi_4479_;
                                            phi_4481_ = _e813;
                                            phi_4482_ = _e815;
                                            phi_4483_ = select(true, false, _e785);
                                        } else {
                                            phi_4481_ = type_50();
                                            phi_4482_ = u32();
                                            phi_4483_ = true;
                                        }
                                        let _e818 = phi_4481_;
                                        let _e820 = phi_4482_;
                                        let _e822 = phi_4483_;
                                        if _e822 {
                                            if _e784 {
                                                phi_4490_ = _e695;
                                            } else {
                                                phi_4490_ = _e700;
                                            }
                                            let _e824 = phi_4490_;
                                            phi_4495_ = _e824;
                                            phi_4496_ = select(_e785, true, _e784);
                                        } else {
                                            phi_4495_ = _e818;
                                            phi_4496_ = _e509;
                                        }
                                        let _e827 = phi_4495_;
                                        let _e829 = phi_4496_;
                                        phi_4757_ = _e682;
                                        phi_4498_ = _e470;
                                        phi_4499_ = _e827;
                                        phi_4500_ = _e829;
                                        phi_4501_ = select(_e820, _e511, _e822);
                                    }
                                    let _e1240 = phi_4757_;
                                    let _e1242 = phi_4498_;
                                    let _e1244 = phi_4499_;
                                    let _e1246 = phi_4500_;
                                    let _e1248 = phi_4501_;
                                    phi_4756_ = _e1240;
                                    phi_4502_ = _e1242;
                                    phi_4503_ = _e1244;
                                    phi_4504_ = (_e474 - 1u);
                                    phi_4505_ = _e1246;
                                    phi_4506_ = _e1248;
                                } else {
                                    phi_4756_ = _e468;
                                    phi_4502_ = _e470;
                                    phi_4503_ = _e507;
                                    phi_4504_ = _e474;
                                    phi_4505_ = _e509;
                                    phi_4506_ = _e511;
                                }
                                let _e1250 = phi_4756_;
                                let _e1252 = phi_4502_;
                                let _e1254 = phi_4503_;
                                let _e1256 = phi_4504_;
                                let _e1258 = phi_4505_;
                                let _e1260 = phi_4506_;
                                phi_4755_ = _e1250;
                                phi_4507_ = _e1252;
                                phi_4508_ = _e1254;
                                phi_4509_ = _e1256;
                                phi_4510_ = _e1258;
                                phi_4511_ = _e1260;
                            } else {
                                phi_4755_ = _e468;
                                phi_4507_ = type_32();
                                phi_4508_ = type_50();
                                phi_4509_ = u32();
                                phi_4510_ = bool();
                                phi_4511_ = u32();
                            }
                            let _e1262 = phi_4755_;
                            let _e1264 = phi_4507_;
                            let _e1266 = phi_4508_;
                            let _e1268 = phi_4509_;
                            let _e1270 = phi_4510_;
                            let _e1272 = phi_4511_;
                            phi_4754_ = _e1262;
                            phi_2824_ = _e1264;
                            phi_2827_ = _e1266;
                            phi_2829_ = _e1268;
                            phi_2831_ = _e1270;
                            phi_2833_ = _e1272;
                            phi_4512_ = _e482;
                        } else {
                            phi_4754_ = _e468;
                            phi_2824_ = type_32();
                            phi_2827_ = type_50();
                            phi_2829_ = u32();
                            phi_2831_ = bool();
                            phi_2833_ = u32();
                            phi_4512_ = false;
                        }
                        let _e1274 = phi_4754_;
                        let _e1276 = phi_2824_;
                        let _e1278 = phi_2827_;
                        let _e1280 = phi_2829_;
                        let _e1282 = phi_2831_;
                        let _e1284 = phi_2833_;
                        let _e1286 = phi_4512_;
                        continue;
                        continuing {
                            phi_4633_ = _e1274;
                            phi_2823_ = _e1276;
                            phi_2826_ = _e1278;
                            phi_2828_ = _e1280;
                            phi_2830_ = _e1282;
                            phi_2832_ = _e1284;
                            phi_4753_ = _e1274;
                            break if !(_e1286);
                        }
                    }
                    let _e1289 = phi_4753_;
                    if _e1289 {
                        break;
                    }
                    let _e1291 = local_12;
                    if (_e1291.member.member_3 != 4294967295u) {
                        let _e1296 = -(_e403);
                        let _e1297 = (_e1296 / 3i);
                        let _e1304 = bitcast<f32>((bitcast<u32>((_e1297 + 127i)) << bitcast<u32>(23i)));
                        let _e1312 = (((_e1291.member.member * _e1304) * _e1304) * bitcast<f32>((bitcast<u32>(((_e1296 - (2i * _e1297)) + 127i)) << bitcast<u32>(23i))));
                        let _e1314 = select(340282350000000000000000000000000000000f, _e1312, (_e1312 < 340282350000000000000000000000000000000f));
                        phi_4564_ = type_22(select(-340282350000000000000000000000000000000f, _e1314, (_e1314 > -340282350000000000000000000000000000000f)), _e1291.member.member_1, _e1291.member.member_2, _e1291.member.member_3);
                    } else {
                        phi_4564_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1321 = phi_4564_;
                    if _e132 {
                    } else {
                        break;
                    }
                    global_6.member[_e130] = _e1321;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_closest_printed_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
