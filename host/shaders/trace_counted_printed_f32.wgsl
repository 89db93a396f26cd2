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
    var phi_332_: i32;
    var phi_333_: i32;
    var phi_343_: bool;
    var phi_353_: u32;
    var phi_354_: u32;
    var phi_356_: bool;
    var phi_361_: u32;
    var phi_406_: f32;
    var phi_412_: f32;
    var phi_423_: f32;
    var phi_429_: f32;
    var phi_452_: f32;
    var phi_463_: f32;
    var phi_472_: f32;
    var phi_478_: f32;
    var phi_489_: f32;
    var phi_495_: f32;
    var phi_518_: f32;
    var phi_529_: f32;
    var phi_538_: f32;
    var phi_544_: f32;
    var phi_555_: f32;
    var phi_561_: f32;
    var phi_584_: f32;
    var phi_595_: f32;
    var phi_695_: f32;
    var phi_696_: f32;
    var phi_4598_: bool;
    var phi_2825_: type_37;
    var phi_2828_: type_50;
    var phi_2830_: u32;
    var phi_2832_: bool;
    var phi_2834_: u32;
    var phi_2845_: bool;
    var phi_2890_: type_50;
    var phi_2891_: bool;
    var phi_2892_: u32;
    var phi_3697_: type_41;
    var phi_3706_: type_4;
    var phi_3707_: type_4;
    var phi_3730_: type_4;
    var phi_4591_: bool;
    var phi_3860_: type_4;
    var phi_3861_: type_4;
    var phi_3884_: type_4;
    var phi_4647_: bool;
    var phi_4447_: type_50;
    var phi_4486_: type_50;
    var phi_4487_: type_50;
    var phi_4488_: u32;
    var phi_4490_: type_50;
    var phi_4491_: u32;
    var phi_4492_: bool;
    var phi_4499_: type_50;
    var phi_4504_: type_50;
    var phi_4505_: bool;
    var phi_2910_: type_37;
    var phi_2913_: type_4;
    var phi_2914_: type_4;
    var phi_2936_: type_4;
    var phi_2960_: u32;
    var phi_3049_: array<array<f32, 3>, 3>;
    var phi_3520_: vec3<f32>;
    var phi_3521_: vec3<f32>;
    var phi_3552_: bool;
    var phi_3561_: vec3<f32>;
    var phi_3601_: type_25;
    var phi_3603_: type_25;
    var phi_3604_: bool;
    var phi_3608_: type_25;
    var phi_3609_: type_25;
    var phi_3610_: type_25;
    var phi_3611_: bool;
    var phi_3615_: type_25;
    var phi_3616_: bool;
    var phi_3620_: type_25;
    var phi_3621_: bool;
    var phi_3625_: type_25;
    var phi_3650_: bool;
    var phi_3651_: bool;
    var phi_3658_: type_37;
    var phi_3659_: type_37;
    var phi_3660_: type_37;
    var phi_2911_: type_37;
    var phi_4655_: bool;
    var phi_4722_: bool;
    var phi_4507_: type_37;
    var phi_4508_: type_50;
    var phi_4509_: bool;
    var phi_4510_: u32;
    var phi_4721_: bool;
    var phi_4511_: type_37;
    var phi_4512_: type_50;
    var phi_4513_: u32;
    var phi_4514_: bool;
    var phi_4515_: u32;
    var phi_4720_: bool;
    var phi_4516_: type_37;
    var phi_4517_: type_50;
    var phi_4518_: u32;
    var phi_4519_: bool;
    var phi_4520_: u32;
    var phi_4719_: bool;
    var phi_2826_: type_37;
    var phi_2829_: type_50;
    var phi_2831_: u32;
    var phi_2833_: bool;
    var phi_2835_: u32;
    var phi_4521_: bool;
    var phi_4718_: bool;
    var local_12: type_37;
    var local_13: type_37;
    var local_14: type_37;

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
                            phi_332_ = (bitcast<i32>((_e209 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_332_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e209)), 32u, (_e209 == 0u))));
                        }
                        let _e223 = phi_332_;
                        phi_333_ = _e223;
                    } else {
                        phi_333_ = 0i;
                    }
                    let _e225 = phi_333_;
                    let _e226 = (_e142 == _e181);
                    if _e226 {
                        phi_343_ = true;
                    } else {
                        phi_343_ = (_e149 == _e181);
                    }
                    let _e229 = phi_343_;
                    let _e230 = select(1u, 0u, _e226);
                    if _e229 {
                        let _e231 = (_e230 + 1u);
                        phi_353_ = _e231;
                        phi_354_ = _e231;
                        phi_356_ = select(true, false, (_e231 == 2u));
                    } else {
                        phi_353_ = u32();
                        phi_354_ = 0u;
                        phi_356_ = true;
                    }
                    let _e235 = phi_353_;
                    let _e237 = phi_354_;
                    let _e239 = phi_356_;
                    if _e239 {
                        phi_361_ = (_e237 + 1u);
                    } else {
                        phi_361_ = 0u;
                    }
                    let _e243 = phi_361_;
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
                        phi_406_ = _e274[0];
                    } else {
                        phi_406_ = _e274[1];
                    }
                    let _e279 = phi_406_;
                    let _e280 = (_e244 == 2u);
                    if _e280 {
                        phi_412_ = _e274[2];
                    } else {
                        phi_412_ = _e279;
                    }
                    let _e283 = phi_412_;
                    let _e285 = ((_e283 * _e251) * _e257);
                    let _e286 = global_4.member[_e130].member_2;
                    if _e275 {
                        phi_423_ = _e286[0];
                    } else {
                        phi_423_ = _e286[1];
                    }
                    let _e290 = phi_423_;
                    if _e280 {
                        phi_429_ = _e286[2];
                    } else {
                        phi_429_ = _e290;
                    }
                    let _e293 = phi_429_;
                    let _e295 = ((_e293 * _e264) * _e270);
                    let _e299 = (bitcast<f32>((bitcast<u32>(_e295) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e299 {
                        let _e303 = (bitcast<f32>((bitcast<u32>(_e285) & 2147483647u)) * 0.00000011920929f);
                        phi_452_ = select(0.00000000000011368684f, _e303, (_e303 > 0.00000000000011368684f));
                    } else {
                        phi_452_ = 0f;
                    }
                    let _e307 = phi_452_;
                    let _e308 = (_e285 + _e307);
                    let _e309 = (_e285 - _e307);
                    let _e310 = select(_e295, 0f, _e299);
                    if _e299 {
                        phi_463_ = 38685626000000000000000000f;
                    } else {
                        phi_463_ = (1f / _e295);
                    }
                    let _e313 = phi_463_;
                    let _e314 = (_e243 == 0u);
                    if _e314 {
                        phi_472_ = _e274[0];
                    } else {
                        phi_472_ = _e274[1];
                    }
                    let _e318 = phi_472_;
                    let _e319 = (_e243 == 2u);
                    if _e319 {
                        phi_478_ = _e274[2];
                    } else {
                        phi_478_ = _e318;
                    }
                    let _e322 = phi_478_;
                    let _e324 = ((_e322 * _e251) * _e257);
                    if _e314 {
                        phi_489_ = _e286[0];
                    } else {
                        phi_489_ = _e286[1];
                    }
                    let _e328 = phi_489_;
                    if _e319 {
                        phi_495_ = _e286[2];
                    } else {
                        phi_495_ = _e328;
                    }
                    let _e331 = phi_495_;
                    let _e333 = ((_e331 * _e264) * _e270);
                    let _e337 = (bitcast<f32>((bitcast<u32>(_e333) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e337 {
                        let _e341 = (bitcast<f32>((bitcast<u32>(_e324) & 2147483647u)) * 0.00000011920929f);
                        phi_518_ = select(0.00000000000011368684f, _e341, (_e341 > 0.00000000000011368684f));
                    } else {
                        phi_518_ = 0f;
                    }
                    let _e345 = phi_518_;
                    let _e346 = (_e324 + _e345);
                    let _e347 = (_e324 - _e345);
                    let _e348 = select(_e333, 0f, _e337);
                    if _e337 {
                        phi_529_ = 38685626000000000000000000f;
                    } else {
                        phi_529_ = (1f / _e333);
                    }
                    let _e351 = phi_529_;
                    let _e352 = (_e245 == 0u);
                    if _e352 {
                        phi_538_ = _e274[0];
                    } else {
                        phi_538_ = _e274[1];
                    }
                    let _e356 = phi_538_;
                    let _e357 = (_e245 == 2u);
                    if _e357 {
                        phi_544_ = _e274[2];
                    } else {
                        phi_544_ = _e356;
                    }
                    let _e360 = phi_544_;
                    let _e362 = ((_e360 * _e251) * _e257);
                    if _e352 {
                        phi_555_ = _e286[0];
                    } else {
                        phi_555_ = _e286[1];
                    }
                    let _e366 = phi_555_;
                    if _e357 {
                        phi_561_ = _e286[2];
                    } else {
                        phi_561_ = _e366;
                    }
                    let _e369 = phi_561_;
                    let _e371 = ((_e369 * _e264) * _e270);
                    let _e375 = (bitcast<f32>((bitcast<u32>(_e371) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e375 {
                        let _e379 = (bitcast<f32>((bitcast<u32>(_e362) & 2147483647u)) * 0.00000011920929f);
                        phi_584_ = select(0.00000000000011368684f, _e379, (_e379 > 0.00000000000011368684f));
                    } else {
                        phi_584_ = 0f;
                    }
                    let _e383 = phi_584_;
                    let _e384 = (_e362 + _e383);
                    let _e385 = (_e362 - _e383);
                    let _e386 = select(_e371, 0f, _e375);
                    if _e375 {
                        phi_595_ = 38685626000000000000000000f;
                    } else {
                        phi_595_ = (1f / _e371);
                    }
                    let _e389 = phi_595_;
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
                        phi_695_ = select(-340282350000000000000000000000000000000f, _e430, (_e430 > -340282350000000000000000000000000000000f));
                        phi_696_ = select(-340282350000000000000000000000000000000f, _e423, (_e423 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_695_ = 0f;
                        phi_696_ = 1f;
                    }
                    let _e434 = phi_695_;
                    let _e436 = phi_696_;
                    local_3 = array<type_50, 128>(type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_50(type_47(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u));
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_11 = array<f32, 3>(bitcast<f32>(_e92), bitcast<f32>(_e96), bitcast<f32>(_e100));
                    let _e442 = (_e244 % 3u);
                    let _e443 = (_e442 < 3u);
                    if _e443 {
                    } else {
                        break;
                    }
                    let _e445 = local_11[_e442];
                    let _e446 = (_e243 % 3u);
                    let _e447 = (_e446 < 3u);
                    if _e447 {
                    } else {
                        break;
                    }
                    let _e449 = local_11[_e446];
                    let _e450 = (_e245 % 3u);
                    let _e451 = (_e450 < 3u);
                    if _e451 {
                    } else {
                        break;
                    }
                    let _e453 = local_11[_e450];
                    local_10 = array<f32, 3>(bitcast<f32>(_e104), bitcast<f32>(_e108), bitcast<f32>(_e112));
                    if _e443 {
                    } else {
                        break;
                    }
                    let _e457 = local_10[_e442];
                    if _e447 {
                    } else {
                        break;
                    }
                    let _e459 = local_10[_e446];
                    if _e451 {
                    } else {
                        break;
                    }
                    let _e461 = local_10[_e450];
                    phi_4598_ = false;
                    phi_2825_ = type_37(type_31(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e434), 0u, 0u);
                    phi_2828_ = type_50(type_47(array<f32, 3>(_e445, _e449, _e453), array<f32, 3>(_e457, _e459, _e461)), select(0u, 2147483648u, (_e82 == 0u)));
                    phi_2830_ = ((3u * _e82) + 1u);
                    phi_2832_ = (_e436 <= _e434);
                    phi_2834_ = 0u;
                    loop {
                        let _e469 = phi_4598_;
                        let _e471 = phi_2825_;
                        let _e473 = phi_2828_;
                        let _e475 = phi_2830_;
                        let _e477 = phi_2832_;
                        let _e479 = phi_2834_;
                        local_12 = _e471;
                        local_13 = _e471;
                        if _e477 {
                            phi_2845_ = true;
                        } else {
                            phi_2845_ = (_e479 > 0u);
                        }
                        let _e482 = phi_2845_;
                        if _e482 {
                            let _e483 = (_e475 > 0u);
                            if _e483 {
                                if _e477 {
                                    phi_2890_ = _e473;
                                    phi_2891_ = _e477;
                                    phi_2892_ = _e479;
                                } else {
                                    let _e484 = (_e479 - 1u);
                                    let _e485 = (_e484 % 128u);
                                    let _e486 = (_e485 < 128u);
                                    if _e486 {
                                    } else {
                                        phi_4718_ = true;
                                        break;
                                    }
                                    let _e488 = local_3[_e485];
                                    if _e486 {
                                    } else {
                                        phi_4718_ = true;
                                        break;
                                    }
                                    let _e504 = local_2[_e485];
                                    phi_2890_ = type_50(type_47(array<f32, 3>(_e488.member.member[0], _e488.member.member[1], _e488.member.member[2]), array<f32, 3>(_e488.member.member_1[0], _e488.member.member_1[1], _e488.member.member_1[2])), _e488.member_1);
                                    phi_2891_ = (_e504 <= _e471.member.member_1);
                                    phi_2892_ = _e484;
                                }
                                let _e509 = phi_2890_;
                                let _e511 = phi_2891_;
                                let _e513 = phi_2892_;
                                if _e511 {
                                    if ((_e509.member_1 & 2147483648u) != 0u) {
                                        phi_2910_ = _e471;
                                        phi_2913_ = type_4(0u, ((_e509.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e842 = phi_2910_;
                                            let _e844 = phi_2913_;
                                            local_14 = _e842;
                                            if (_e844.member < _e844.member_1) {
                                                phi_2914_ = type_4((_e844.member + 1u), _e844.member_1);
                                                phi_2936_ = type_4(1u, _e844.member);
                                            } else {
                                                phi_2914_ = _e844;
                                                phi_2936_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e857 = phi_2914_;
                                            let _e859 = phi_2936_;
                                            let _e863 = (bitcast<i32>(_e859.member) != 0i);
                                            if _e863 {
                                                let _e869 = type_37(_e842.member, _e842.member_1, (_e842.member_2 + 1u));
                                                let _e870 = ((_e509.member_1 & 268435455u) + _e859.member_1);
                                                let _e871 = (_e870 < _e84);
                                                if _e871 {
                                                    if _e871 {
                                                    } else {
                                                        phi_4655_ = true;
                                                        break;
                                                    }
                                                    let _e875 = global_2.member[_e870].member_1;
                                                    phi_2960_ = _e875;
                                                } else {
                                                    phi_2960_ = 4294967295u;
                                                }
                                                let _e877 = phi_2960_;
                                                if (_e870 >= _e84) {
                                                    phi_3049_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e871 {
                                                    } else {
                                                        phi_4655_ = true;
                                                        break;
                                                    }
                                                    if (_e442 < 9u) {
                                                    } else {
                                                        phi_4655_ = true;
                                                        break;
                                                    }
                                                    let _e884 = global_2.member[_e870].member[_e442];
                                                    if (_e446 < 9u) {
                                                    } else {
                                                        phi_4655_ = true;
                                                        break;
                                                    }
                                                    let _e890 = global_2.member[_e870].member[_e446];
                                                    if (_e450 < 9u) {
                                                    } else {
                                                        phi_4655_ = true;
                                                        break;
                                                    }
                                                    let _e896 = global_2.member[_e870].member[_e450];
                                                    let _e898 = (3u + _e442);
                                                    if (_e898 < 9u) {
                                                    } else {
                                                        phi_4655_ = true;
                                                        break;
                                                    }
                                                    let _e904 = global_2.member[_e870].member[_e898];
                                                    let _e905 = (3u + _e446);
                                                    if (_e905 < 9u) {
                                                    } else {
                                                        phi_4655_ = true;
                                                        break;
                                                    }
                                                    let _e911 = global_2.member[_e870].member[_e905];
                                                    let _e912 = (3u + _e450);
                                                    if (_e912 < 9u) {
                                                    } else {
                                                        phi_4655_ = true;
                                                        break;
                                                    }
                                                    let _e918 = global_2.member[_e870].member[_e912];
                                                    let _e920 = (6u + _e442);
                                                    if (_e920 < 9u) {
                                                    } else {
                                                        phi_4655_ = true;
                                                        break;
                                                    }
                                                    let _e926 = global_2.member[_e870].member[_e920];
                                                    let _e927 = (6u + _e446);
                                                    if (_e927 < 9u) {
                                                    } else {
                                                        phi_4655_ = true;
                                                        break;
                                                    }
                                                    let _e933 = global_2.member[_e870].member[_e927];
                                                    let _e934 = (6u + _e450);
                                                    if (_e934 < 9u) {
                                                    } else {
                                                        phi_4655_ = true;
                                                        break;
                                                    }
                                                    let _e940 = global_2.member[_e870].member[_e934];
                                                    phi_3049_ = array<array<f32, 3>, 3>(array<f32, 3>(_e884, _e890, _e896), array<f32, 3>(_e904, _e911, _e918), array<f32, 3>(_e926, _e933, _e940));
                                                }
                                                let _e944 = phi_3049_;
                                                let _e953 = (_e944[0][2] - _e362);
                                                let _e956 = (((_e944[0][0] - _e285) * _e386) - (_e953 * _e310));
                                                let _e959 = (((_e944[0][1] - _e324) * _e386) - (_e953 * _e348));
                                                let _e966 = (_e944[1][2] - _e362);
                                                let _e969 = (((_e944[1][0] - _e285) * _e386) - (_e966 * _e310));
                                                let _e972 = (((_e944[1][1] - _e324) * _e386) - (_e966 * _e348));
                                                let _e979 = (_e944[2][2] - _e362);
                                                let _e982 = (((_e944[2][0] - _e285) * _e386) - (_e979 * _e310));
                                                let _e985 = (((_e944[2][1] - _e324) * _e386) - (_e979 * _e348));
                                                let _e986 = (_e982 * _e972);
                                                let _e987 = (_e985 * _e969);
                                                let _e988 = (_e956 * _e985);
                                                let _e989 = (_e959 * _e982);
                                                let _e990 = (_e969 * _e959);
                                                let _e991 = (_e972 * _e956);
                                                let _e996 = (((_e986 >= _e987) && (_e988 >= _e989)) && (_e990 >= _e991));
                                                if (_e996 || (((_e986 <= _e987) && (_e988 <= _e989)) && (_e990 <= _e991))) {
                                                    let _e1003 = select(-1f, 1f, _e996);
                                                    let _e1005 = ((_e986 - _e987) * _e1003);
                                                    let _e1007 = select(0f, _e1005, (_e1005 > 0f));
                                                    let _e1009 = ((_e988 - _e989) * _e1003);
                                                    let _e1011 = select(0f, _e1009, (_e1009 > 0f));
                                                    let _e1013 = ((_e990 - _e991) * _e1003);
                                                    let _e1015 = select(0f, _e1013, (_e1013 > 0f));
                                                    let _e1017 = ((_e1007 + _e1011) + _e1015);
                                                    if (_e1017 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_3615_ = type_25();
                                                        phi_3616_ = true;
                                                    } else {
                                                        let _e1020 = select(_e944[1][0], _e944[0][0], (_e944[0][0] < _e944[1][0]));
                                                        let _e1024 = select(_e944[1][0], _e944[0][0], (_e944[0][0] > _e944[1][0]));
                                                        let _e1028 = select(_e944[1][1], _e944[0][1], (_e944[0][1] < _e944[1][1]));
                                                        let _e1032 = select(_e944[1][1], _e944[0][1], (_e944[0][1] > _e944[1][1]));
                                                        let _e1036 = select(_e944[1][2], _e944[0][2], (_e944[0][2] < _e944[1][2]));
                                                        let _e1040 = select(_e944[1][2], _e944[0][2], (_e944[0][2] > _e944[1][2]));
                                                        let _e1045 = ((select(_e944[2][0], _e1020, (_e1020 < _e944[2][0])) - _e308) * _e313);
                                                        let _e1046 = ((select(_e944[2][0], _e1024, (_e1024 > _e944[2][0])) - _e309) * _e313);
                                                        let _e1049 = ((select(_e944[2][1], _e1028, (_e1028 < _e944[2][1])) - _e346) * _e351);
                                                        let _e1050 = ((select(_e944[2][1], _e1032, (_e1032 > _e944[2][1])) - _e347) * _e351);
                                                        let _e1053 = ((select(_e944[2][2], _e1036, (_e1036 < _e944[2][2])) - _e384) * _e389);
                                                        let _e1054 = ((select(_e944[2][2], _e1040, (_e1040 > _e944[2][2])) - _e385) * _e389);
                                                        let _e1056 = select(_e1054, _e1053, (_e1053 < _e1054));
                                                        let _e1058 = select(_e1054, _e1053, (_e1053 > _e1054));
                                                        let _e1060 = select(_e1046, _e1045, (_e1045 < _e1046));
                                                        let _e1062 = select(_e1050, _e1049, (_e1049 < _e1050));
                                                        let _e1064 = select(_e1062, _e1060, (_e1060 > _e1062));
                                                        let _e1066 = select(_e1056, _e1064, (_e1064 > _e1056));
                                                        let _e1068 = select(_e1046, _e1045, (_e1045 > _e1046));
                                                        let _e1070 = select(_e1050, _e1049, (_e1049 > _e1050));
                                                        let _e1072 = select(_e1070, _e1068, (_e1068 < _e1070));
                                                        let _e1074 = select(_e1058, _e1072, (_e1072 < _e1058));
                                                        let _e1075 = -(_e1056);
                                                        let _e1081 = select(_e436, _e1066, (_e1066 > _e436));
                                                        if (_e1081 > (_e1074 + (select(_e1075, _e1058, (_e1058 > _e1075)) * 0.0000019073523f))) {
                                                            phi_3610_ = type_25();
                                                            phi_3611_ = true;
                                                        } else {
                                                            let _e1083 = (_e1081 > _e842.member.member_1);
                                                            if _e1083 {
                                                                phi_3609_ = type_25();
                                                            } else {
                                                                let _e1087 = (_e944[1][0] - _e944[0][0]);
                                                                let _e1088 = (_e944[1][1] - _e944[0][1]);
                                                                let _e1089 = (_e944[1][2] - _e944[0][2]);
                                                                let _e1090 = vec3<f32>(_e1087, _e1088, _e1089);
                                                                let _e1091 = (_e944[2][0] - _e944[1][0]);
                                                                let _e1092 = (_e944[2][1] - _e944[1][1]);
                                                                let _e1093 = (_e944[2][2] - _e944[1][2]);
                                                                let _e1094 = vec3<f32>(_e1091, _e1092, _e1093);
                                                                let _e1095 = (_e944[0][0] - _e944[2][0]);
                                                                let _e1096 = (_e944[0][1] - _e944[2][1]);
                                                                let _e1097 = (_e944[0][2] - _e944[2][2]);
                                                                let _e1098 = vec3<f32>(_e1095, _e1096, _e1097);
                                                                let _e1101 = bitcast<f32>((bitcast<u32>(_e1087) & 2147483647u));
                                                                let _e1104 = bitcast<f32>((bitcast<u32>(_e1088) & 2147483647u));
                                                                let _e1106 = select(_e1104, _e1101, (_e1101 > _e1104));
                                                                let _e1109 = bitcast<f32>((bitcast<u32>(_e1089) & 2147483647u));
                                                                let _e1111 = select(_e1109, _e1106, (_e1106 > _e1109));
                                                                let _e1114 = bitcast<f32>((bitcast<u32>(_e1091) & 2147483647u));
                                                                let _e1117 = bitcast<f32>((bitcast<u32>(_e1092) & 2147483647u));
                                                                let _e1119 = select(_e1117, _e1114, (_e1114 > _e1117));
                                                                let _e1122 = bitcast<f32>((bitcast<u32>(_e1093) & 2147483647u));
                                                                let _e1124 = select(_e1122, _e1119, (_e1119 > _e1122));
                                                                let _e1127 = bitcast<f32>((bitcast<u32>(_e1095) & 2147483647u));
                                                                let _e1130 = bitcast<f32>((bitcast<u32>(_e1096) & 2147483647u));
                                                                let _e1132 = select(_e1130, _e1127, (_e1127 > _e1130));
                                                                let _e1135 = bitcast<f32>((bitcast<u32>(_e1097) & 2147483647u));
                                                                let _e1137 = select(_e1135, _e1132, (_e1132 > _e1135));
                                                                let _e1139 = select(_e1124, _e1111, (_e1111 > _e1124));
                                                                let _e1141 = select(_e1137, _e1139, (_e1139 > _e1137));
                                                                if (_e1111 == _e1141) {
                                                                    phi_3520_ = _e1094;
                                                                    phi_3521_ = _e1098;
                                                                } else {
                                                                    let _e1144 = vec3((_e1124 == _e1141));
                                                                    phi_3520_ = select(_e1090, _e1098, _e1144);
                                                                    phi_3521_ = select(_e1094, _e1090, _e1144);
                                                                }
                                                                let _e1148 = phi_3520_;
                                                                let _e1150 = phi_3521_;
                                                                let _e1157 = ((_e1148.y * _e1150.z) - (_e1150.y * _e1148.z));
                                                                let _e1162 = ((_e1148.z * _e1150.x) - (_e1150.z * _e1148.x));
                                                                let _e1165 = ((_e1148.x * _e1150.y) - (_e1150.x * _e1148.y));
                                                                if (_e1007 >= _e1011) {
                                                                    phi_3552_ = select(true, false, (_e1007 >= _e1015));
                                                                } else {
                                                                    phi_3552_ = true;
                                                                }
                                                                let _e1170 = phi_3552_;
                                                                if _e1170 {
                                                                    phi_3561_ = select(vec3<f32>(_e944[2][0], _e944[2][1], _e944[2][2]), vec3<f32>(_e944[1][0], _e944[1][1], _e944[1][2]), vec3((_e1011 >= _e1015)));
                                                                } else {
                                                                    phi_3561_ = vec3<f32>(_e944[0][0], _e944[0][1], _e944[0][2]);
                                                                }
                                                                let _e1175 = phi_3561_;
                                                                let _e1192 = ((((_e1157 * (_e1175.x - _e285)) + (_e1162 * (_e1175.y - _e324))) + (_e1165 * (_e1175.z - _e362))) / (((_e1157 * _e310) + (_e1162 * _e348)) + (_e1165 * _e386)));
                                                                let _e1194 = select(_e1074, _e1192, (_e1192 < _e1074));
                                                                let _e1196 = select(_e1066, _e1194, (_e1194 > _e1066));
                                                                if (_e1196 >= _e436) {
                                                                    let _e1198 = (_e1196 <= _e842.member.member_1);
                                                                    if _e1198 {
                                                                        let _e1199 = (1f / _e1017);
                                                                        phi_3601_ = type_25(_e1196, (_e1011 * _e1199), (_e1015 * _e1199), _e877);
                                                                    } else {
                                                                        phi_3601_ = type_25();
                                                                    }
                                                                    let _e1204 = phi_3601_;
                                                                    phi_3603_ = _e1204;
                                                                    phi_3604_ = select(true, false, _e1198);
                                                                } else {
                                                                    phi_3603_ = type_25();
                                                                    phi_3604_ = true;
                                                                }
                                                                let _e1207 = phi_3603_;
                                                                let _e1209 = phi_3604_;
                                                                if _e1209 {
                                                                    phi_3608_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_3608_ = _e1207;
                                                                }
                                                                let _e1211 = phi_3608_;
                                                                phi_3609_ = _e1211;
                                                            }
                                                            let _e1213 = phi_3609_;
                                                            phi_3610_ = _e1213;
                                                            phi_3611_ = _e1083;
                                                        }
                                                        let _e1215 = phi_3610_;
                                                        let _e1217 = phi_3611_;
                                                        phi_3615_ = _e1215;
                                                        phi_3616_ = _e1217;
                                                    }
                                                    let _e1219 = phi_3615_;
                                                    let _e1221 = phi_3616_;
                                                    phi_3620_ = _e1219;
                                                    phi_3621_ = _e1221;
                                                } else {
                                                    phi_3620_ = type_25();
                                                    phi_3621_ = true;
                                                }
                                                let _e1223 = phi_3620_;
                                                let _e1225 = phi_3621_;
                                                if _e1225 {
                                                    phi_3625_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_3625_ = _e1223;
                                                }
                                                let _e1227 = phi_3625_;
                                                if (_e1227.member_3 != 4294967295u) {
                                                    if (_e877 != 4294967295u) {
                                                        if (_e1227.member < _e842.member.member.member) {
                                                            phi_3651_ = true;
                                                        } else {
                                                            if (_e1227.member == _e842.member.member.member) {
                                                                phi_3650_ = (_e1227.member_3 < _e842.member.member.member_3);
                                                            } else {
                                                                phi_3650_ = false;
                                                            }
                                                            let _e1242 = phi_3650_;
                                                            phi_3651_ = _e1242;
                                                        }
                                                        let _e1244 = phi_3651_;
                                                        if _e1244 {
                                                            phi_3658_ = type_37(type_31(_e1227, _e1227.member), _e869.member_1, _e869.member_2);
                                                        } else {
                                                            phi_3658_ = _e869;
                                                        }
                                                        let _e1251 = phi_3658_;
                                                        phi_3659_ = _e1251;
                                                    } else {
                                                        phi_3659_ = _e869;
                                                    }
                                                    let _e1253 = phi_3659_;
                                                    phi_3660_ = _e1253;
                                                } else {
                                                    phi_3660_ = _e869;
                                                }
                                                let _e1255 = phi_3660_;
                                                phi_2911_ = _e1255;
                                            } else {
                                                phi_2911_ = type_37();
                                            }
                                            let _e1257 = phi_2911_;
                                            continue;
                                            continuing {
                                                phi_2910_ = _e1257;
                                                phi_2913_ = _e857;
                                                phi_4655_ = _e469;
                                                break if !(_e863);
                                            }
                                        }
                                        let _e1260 = phi_4655_;
                                        phi_4718_ = _e1260;
                                        if _e1260 {
                                            break;
                                        }
                                        phi_4722_ = _e1260;
                                        let _e1412 = local_14;
                                        phi_4507_ = _e1412;
                                        phi_4508_ = _e509;
                                        phi_4509_ = false;
                                        phi_4510_ = _e513;
                                    } else {
                                        local_1 = array<f32, 3>(_e509.member.member[0], _e509.member.member[1], _e509.member.member[2]);
                                        local = array<f32, 3>(_e509.member.member_1[0], _e509.member.member_1[1], _e509.member.member_1[2]);
                                        let _e539 = (_e509.member_1 < _e82);
                                        if _e539 {
                                            if _e539 {
                                            } else {
                                                phi_4718_ = true;
                                                break;
                                            }
                                            let _e541 = global_5.member[_e509.member_1];
                                            phi_3697_ = _e541;
                                        } else {
                                            phi_3697_ = type_41(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e543 = phi_3697_;
                                        let _e545 = array<u32, 3>(_e244, _e243, _e245);
                                        local_9 = _e545;
                                        local_5 = array<f32, 3>(0f, 0f, 0f);
                                        local_4 = array<f32, 3>(0f, 0f, 0f);
                                        phi_3706_ = type_4(0u, 3u);
                                        loop {
                                            let _e547 = phi_3706_;
                                            if (_e547.member < _e547.member_1) {
                                                phi_3707_ = type_4((_e547.member + 1u), _e547.member_1);
                                                phi_3730_ = type_4(1u, _e547.member);
                                            } else {
                                                phi_3707_ = _e547;
                                                phi_3730_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e560 = phi_3707_;
                                            let _e562 = phi_3730_;
                                            let _e566 = (bitcast<i32>(_e562.member) != 0i);
                                            if _e566 {
                                                let _e567 = (_e562.member_1 < 3u);
                                                if _e567 {
                                                } else {
                                                    phi_4591_ = true;
                                                    break;
                                                }
                                                let _e569 = local_9[_e562.member_1];
                                                if _e567 {
                                                } else {
                                                    phi_4591_ = true;
                                                    break;
                                                }
                                                let _e571 = local_1[_e562.member_1];
                                                if _e567 {
                                                } else {
                                                    phi_4591_ = true;
                                                    break;
                                                }
                                                let _e573 = local[_e562.member_1];
                                                let _e576 = ((10u * _e569) & 31u);
                                                let _e579 = ((_e543.member[0] >> bitcast<u32>(_e576)) & 1023u);
                                                let _e584 = bitcast<f32>((bitcast<u32>(((_e573 - _e571) * 0.0009775171f)) ^ _e116));
                                                let _e590 = (_e571 + bitcast<f32>((bitcast<u32>((f32(_e579) * _e584)) ^ _e116)));
                                                if _e567 {
                                                } else {
                                                    phi_4591_ = true;
                                                    break;
                                                }
                                                local_5[_e562.member_1] = select(select(_e573, _e590, (_e590 < _e573)), _e573, (_e579 == 1023u));
                                                let _e599 = ((_e543.member[1] >> bitcast<u32>(_e576)) & 1023u);
                                                let _e605 = (_e571 + bitcast<f32>((bitcast<u32>((f32(_e599) * _e584)) ^ _e116)));
                                                if _e567 {
                                                } else {
                                                    phi_4591_ = true;
                                                    break;
                                                }
                                                local_4[_e562.member_1] = select(select(_e573, _e605, (_e605 < _e573)), _e573, (_e599 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_3706_ = _e560;
                                                phi_4591_ = _e469;
                                                break if !(_e566);
                                            }
                                        }
                                        let _e613 = phi_4591_;
                                        phi_4718_ = _e613;
                                        if _e613 {
                                            break;
                                        }
                                        let _e614 = local_4;
                                        let _e615 = local_5;
                                        local_8 = _e545;
                                        local_7 = array<f32, 3>(0f, 0f, 0f);
                                        local_6 = array<f32, 3>(0f, 0f, 0f);
                                        phi_3860_ = type_4(0u, 3u);
                                        loop {
                                            let _e624 = phi_3860_;
                                            if (_e624.member < _e624.member_1) {
                                                phi_3861_ = type_4((_e624.member + 1u), _e624.member_1);
                                                phi_3884_ = type_4(1u, _e624.member);
                                            } else {
                                                phi_3861_ = _e624;
                                                phi_3884_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e637 = phi_3861_;
                                            let _e639 = phi_3884_;
                                            let _e643 = (bitcast<i32>(_e639.member) != 0i);
                                            if _e643 {
                                                let _e644 = (_e639.member_1 < 3u);
                                                if _e644 {
                                                } else {
                                                    phi_4647_ = true;
                                                    break;
                                                }
                                                let _e646 = local_8[_e639.member_1];
                                                if _e644 {
                                                } else {
                                                    phi_4647_ = true;
                                                    break;
                                                }
                                                let _e648 = local_1[_e639.member_1];
                                                if _e644 {
                                                } else {
                                                    phi_4647_ = true;
                                                    break;
                                                }
                                                let _e650 = local[_e639.member_1];
                                                let _e653 = ((10u * _e646) & 31u);
                                                let _e656 = ((_e543.member_1[0] >> bitcast<u32>(_e653)) & 1023u);
                                                let _e661 = bitcast<f32>((bitcast<u32>(((_e650 - _e648) * 0.0009775171f)) ^ _e116));
                                                let _e667 = (_e648 + bitcast<f32>((bitcast<u32>((f32(_e656) * _e661)) ^ _e116)));
                                                if _e644 {
                                                } else {
                                                    phi_4647_ = true;
                                                    break;
                                                }
                                                local_7[_e639.member_1] = select(select(_e650, _e667, (_e667 < _e650)), _e650, (_e656 == 1023u));
                                                let _e676 = ((_e543.member_1[1] >> bitcast<u32>(_e653)) & 1023u);
                                                let _e682 = (_e648 + bitcast<f32>((bitcast<u32>((f32(_e676) * _e661)) ^ _e116)));
                                                if _e644 {
                                                } else {
                                                    phi_4647_ = true;
                                                    break;
                                                }
                                                local_6[_e639.member_1] = select(select(_e650, _e682, (_e682 < _e650)), _e650, (_e676 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_3860_ = _e637;
                                                phi_4647_ = _e613;
                                                break if !(_e643);
                                            }
                                        }
                                        let _e690 = phi_4647_;
                                        phi_4718_ = _e690;
                                        if _e690 {
                                            break;
                                        }
                                        let _e691 = local_6;
                                        let _e692 = local_7;
                                        let _e703 = type_50(type_47(array<f32, 3>(_e615[0], _e615[1], _e615[2]), array<f32, 3>(_e614[0], _e614[1], _e614[2])), _e543.member_2);
                                        let _e708 = type_50(type_47(array<f32, 3>(_e692[0], _e692[1], _e692[2]), array<f32, 3>(_e691[0], _e691[1], _e691[2])), _e543.member_3);
                                        let _e715 = ((_e615[0] - _e308) * _e313);
                                        let _e716 = ((_e692[0] - _e308) * _e313);
                                        let _e717 = ((_e614[0] - _e309) * _e313);
                                        let _e718 = ((_e691[0] - _e309) * _e313);
                                        let _e723 = ((_e615[1] - _e346) * _e351);
                                        let _e724 = ((_e692[1] - _e346) * _e351);
                                        let _e725 = ((_e614[1] - _e347) * _e351);
                                        let _e726 = ((_e691[1] - _e347) * _e351);
                                        let _e731 = ((_e615[2] - _e384) * _e389);
                                        let _e732 = ((_e692[2] - _e384) * _e389);
                                        let _e733 = ((_e614[2] - _e385) * _e389);
                                        let _e734 = ((_e691[2] - _e385) * _e389);
                                        let _e736 = select(_e733, _e731, (_e731 < _e733));
                                        let _e738 = select(_e734, _e732, (_e732 < _e734));
                                        let _e740 = select(_e733, _e731, (_e731 > _e733));
                                        let _e742 = select(_e734, _e732, (_e732 > _e734));
                                        let _e744 = select(_e717, _e715, (_e715 < _e717));
                                        let _e746 = select(_e718, _e716, (_e716 < _e718));
                                        let _e748 = select(_e725, _e723, (_e723 < _e725));
                                        let _e750 = select(_e726, _e724, (_e724 < _e726));
                                        let _e752 = select(_e748, _e744, (_e744 > _e748));
                                        let _e754 = select(_e750, _e746, (_e746 > _e750));
                                        let _e756 = select(_e736, _e752, (_e752 > _e736));
                                        let _e758 = select(_e738, _e754, (_e754 > _e738));
                                        let _e760 = select(_e717, _e715, (_e715 > _e717));
                                        let _e762 = select(_e718, _e716, (_e716 > _e718));
                                        let _e764 = select(_e725, _e723, (_e723 > _e725));
                                        let _e766 = select(_e726, _e724, (_e724 > _e726));
                                        let _e768 = select(_e764, _e760, (_e760 < _e764));
                                        let _e770 = select(_e766, _e762, (_e762 < _e766));
                                        let _e775 = -(_e736);
                                        let _e776 = -(_e738);
                                        let _e783 = (select(_e740, _e768, (_e768 < _e740)) + (select(_e775, _e740, (_e740 > _e775)) * 0.0000019073523f));
                                        let _e784 = (select(_e742, _e770, (_e770 < _e742)) + (select(_e776, _e742, (_e742 > _e776)) * 0.0000019073523f));
                                        let _e786 = select(_e436, _e756, (_e756 > _e436));
                                        let _e788 = select(_e436, _e758, (_e758 > _e436));
                                        let _e793 = (_e786 <= select(_e471.member.member_1, _e783, (_e783 < _e471.member.member_1)));
                                        let _e794 = (_e788 <= select(_e471.member.member_1, _e784, (_e784 < _e471.member.member_1)));
                                        let _e795 = (_e786 <= _e788);
                                        if _e793 {
                                            if _e794 {
                                                if _e795 {
                                                    phi_4447_ = _e708;
                                                } else {
                                                    phi_4447_ = _e703;
                                                }
                                                let _e797 = phi_4447_;
                                                let _e798 = (_e513 % 128u);
                                                let _e799 = (_e798 < 128u);
                                                if _e799 {
                                                } else {
                                                    phi_4718_ = true;
                                                    break;
                                                }
                                                local_3[_e798] = type_50(type_47(array<f32, 3>(_e797.member.member[0], _e797.member.member[1], _e797.member.member[2]), array<f32, 3>(_e797.member.member_1[0], _e797.member.member_1[1], _e797.member.member_1[2])), _e797.member_1);
                                                if _e799 {
                                                } else {
                                                    phi_4718_ = true;
                                                    break;
                                                }
                                                local_2[_e798] = select(_e788, _e786, (_e786 > _e788));
                                                if _e795 {
                                                    phi_4486_ = _e703;
                                                } else {
                                                    phi_4486_ = _e708;
                                                }
                                                let _e820 = phi_4486_;
                                                phi_4487_ = _e820;
                                                phi_4488_ = (_e513 + 1u);
                                            } else {
                                                phi_4487_ = type_50();
                                                phi_4488_ = u32();
                                            }
                                            let _e822 = phi_4487_;
                                            let _e824 = phi_4488_;
                                            phi_4490_ = _e822;
                                            phi_4491_ = _e824;
                                            phi_4492_ = select(true, false, _e794);
                                        } else {
                                            phi_4490_ = type_50();
                                            phi_4491_ = u32();
                                            phi_4492_ = true;
                                        }
                                        let _e827 = phi_4490_;
                                        let _e829 = phi_4491_;
                                        let _e831 = phi_4492_;
                                        if _e831 {
                                            if _e793 {
                                                phi_4499_ = _e703;
                                            } else {
                                                phi_4499_ = _e708;
                                            }
                                            let _e833 = phi_4499_;
                                            phi_4504_ = _e833;
                                            phi_4505_ = select(_e794, true, _e793);
                                        } else {
                                            phi_4504_ = _e827;
                                            phi_4505_ = _e511;
                                        }
                                        let _e836 = phi_4504_;
                                        let _e838 = phi_4505_;
                                        phi_4722_ = _e690;
                                        phi_4507_ = type_37(_e471.member, (_e471.member_1 + 1u), _e471.member_2);
                                        phi_4508_ = _e836;
                                        phi_4509_ = _e838;
                                        phi_4510_ = select(_e829, _e513, _e831);
                                    }
                                    let _e1262 = phi_4722_;
                                    let _e1264 = phi_4507_;
                                    let _e1266 = phi_4508_;
                                    let _e1268 = phi_4509_;
                                    let _e1270 = phi_4510_;
                                    phi_4721_ = _e1262;
                                    phi_4511_ = _e1264;
                                    phi_4512_ = _e1266;
                                    phi_4513_ = (_e475 - 1u);
                                    phi_4514_ = _e1268;
                                    phi_4515_ = _e1270;
                                } else {
                                    phi_4721_ = _e469;
                                    phi_4511_ = _e471;
                                    phi_4512_ = _e509;
                                    phi_4513_ = _e475;
                                    phi_4514_ = _e511;
                                    phi_4515_ = _e513;
                                }
                                let _e1272 = phi_4721_;
                                let _e1274 = phi_4511_;
                                let _e1276 = phi_4512_;
                                let _e1278 = phi_4513_;
                                let _e1280 = phi_4514_;
                                let _e1282 = phi_4515_;
                                phi_4720_ = _e1272;
                                phi_4516_ = _e1274;
                                phi_4517_ = _e1276;
                                phi_4518_ = _e1278;
                                phi_4519_ = _e1280;
                                phi_4520_ = _e1282;
                            } else {
                                phi_4720_ = _e469;
                                phi_4516_ = type_37();
                                phi_4517_ = type_50();
                                phi_4518_ = u32();
                                phi_4519_ = bool();
                                phi_4520_ = u32();
                            }
                            let _e1284 = phi_4720_;
                            let _e1286 = phi_4516_;
                            let _e1288 = phi_4517_;
                            let _e1290 = phi_4518_;
                            let _e1292 = phi_4519_;
                            let _e1294 = phi_4520_;
                            phi_4719_ = _e1284;
                            phi_2826_ = _e1286;
                            phi_2829_ = _e1288;
                            phi_2831_ = _e1290;
                            phi_2833_ = _e1292;
                            phi_2835_ = _e1294;
                            phi_4521_ = _e483;
                        } else {
                            phi_4719_ = _e469;
                            phi_2826_ = type_37();
                            phi_2829_ = type_50();
                            phi_2831_ = u32();
                            phi_2833_ = bool();
                            phi_2835_ = u32();
                            phi_4521_ = false;
                        }
                        let _e1296 = phi_4719_;
                        let _e1298 = phi_2826_;
                        let _e1300 = phi_2829_;
                        let _e1302 = phi_2831_;
                        let _e1304 = phi_2833_;
                        let _e1306 = phi_2835_;
                        let _e1308 = phi_4521_;
                        continue;
                        continuing {
                            phi_4598_ = _e1296;
                            phi_2825_ = _e1298;
                            phi_2828_ = _e1300;
                            phi_2830_ = _e1302;
                            phi_2832_ = _e1304;
                            phi_2834_ = _e1306;
                            phi_4718_ = _e1296;
                            break if !(_e1308);
                        }
                    }
                    let _e1311 = phi_4718_;
                    if _e1311 {
                        break;
                    }
                    let _e1313 = local_12;
                    let _e1316 = local_13;
                    if _e132 {
                    } else {
                        break;
                    }
                    global_6.member[_e130][0u] = _e1313.member_1;
                    global_6.member[_e130][1u] = _e1316.member_2;
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
