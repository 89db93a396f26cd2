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

struct type_16 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_18 {
    member: array<type_16>,
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

struct type_34 {
    member: array<type_26>,
}

struct type_36 {
    member: f32,
    member_1: bool,
}

struct type_38 {
    member: array<vec4<u32>, 2>,
}

struct type_40 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_42 {
    member: array<type_40>,
}

struct type_46 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_49 {
    member: type_46,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_11;
@group(0) @binding(3) 
var<storage> global_2: type_18;
@group(0) @binding(1) 
var<uniform> global_3: type_38;
@group(0) @binding(4) 
var<storage> global_4: type_34;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_4;
@group(0) @binding(2) 
var<storage> global_6: type_42;

fn function_() {
    var local: array<f32, 3>;
    var local_1: array<f32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<type_49, 128>;
    var local_4: array<f32, 3>;
    var local_5: array<f32, 3>;
    var local_6: array<f32, 3>;
    var local_7: array<f32, 3>;
    var local_8: array<u32, 3>;
    var local_9: array<u32, 3>;
    var local_10: array<f32, 3>;
    var local_11: array<f32, 3>;
    var phi_330_: i32;
    var phi_331_: i32;
    var phi_341_: bool;
    var phi_351_: u32;
    var phi_352_: u32;
    var phi_354_: bool;
    var phi_359_: u32;
    var phi_404_: f32;
    var phi_410_: f32;
    var phi_421_: f32;
    var phi_427_: f32;
    var phi_450_: f32;
    var phi_461_: f32;
    var phi_470_: f32;
    var phi_476_: f32;
    var phi_487_: f32;
    var phi_493_: f32;
    var phi_516_: f32;
    var phi_527_: f32;
    var phi_536_: f32;
    var phi_542_: f32;
    var phi_553_: f32;
    var phi_559_: f32;
    var phi_582_: f32;
    var phi_593_: f32;
    var phi_693_: f32;
    var phi_694_: f32;
    var phi_4565_: bool;
    var phi_2822_: type_36;
    var phi_2825_: type_49;
    var phi_2827_: u32;
    var phi_2829_: bool;
    var phi_2831_: u32;
    var phi_2842_: bool;
    var phi_2887_: type_49;
    var phi_2888_: bool;
    var phi_2889_: u32;
    var phi_3666_: type_40;
    var phi_3675_: type_7;
    var phi_3676_: type_7;
    var phi_3699_: type_7;
    var phi_4558_: bool;
    var phi_3829_: type_7;
    var phi_3830_: type_7;
    var phi_3853_: type_7;
    var phi_4614_: bool;
    var phi_4416_: type_49;
    var phi_4455_: type_49;
    var phi_4456_: type_49;
    var phi_4457_: u32;
    var phi_4459_: type_49;
    var phi_4460_: u32;
    var phi_4461_: bool;
    var phi_4468_: type_49;
    var phi_4473_: type_49;
    var phi_4474_: bool;
    var phi_2907_: type_36;
    var phi_2910_: type_7;
    var phi_2911_: type_7;
    var phi_2933_: type_7;
    var phi_2954_: u32;
    var phi_3043_: array<array<f32, 3>, 3>;
    var phi_3514_: vec3<f32>;
    var phi_3515_: vec3<f32>;
    var phi_3546_: bool;
    var phi_3555_: vec3<f32>;
    var phi_3595_: type_25;
    var phi_3597_: type_25;
    var phi_3598_: bool;
    var phi_3602_: type_25;
    var phi_3603_: type_25;
    var phi_3604_: type_25;
    var phi_3605_: bool;
    var phi_3609_: type_25;
    var phi_3610_: bool;
    var phi_3614_: type_25;
    var phi_3615_: bool;
    var phi_3619_: type_25;
    var phi_3630_: type_36;
    var phi_3631_: type_36;
    var phi_2908_: type_36;
    var phi_4622_: bool;
    var local_12: type_36;
    var phi_4686_: bool;
    var phi_4476_: type_36;
    var phi_4477_: type_49;
    var phi_4478_: bool;
    var phi_4479_: u32;
    var phi_4685_: bool;
    var phi_4480_: type_36;
    var phi_4481_: type_49;
    var phi_4482_: u32;
    var phi_4483_: bool;
    var phi_4484_: u32;
    var phi_4684_: bool;
    var phi_4485_: type_36;
    var phi_4486_: type_49;
    var phi_4487_: u32;
    var phi_4488_: bool;
    var phi_4489_: u32;
    var phi_4683_: bool;
    var phi_2823_: type_36;
    var phi_2826_: type_49;
    var phi_2828_: u32;
    var phi_2830_: bool;
    var phi_2832_: u32;
    var phi_4490_: bool;
    var phi_4682_: bool;
    var local_13: type_36;
    var local_14: type_36;

    switch bitcast<i32>(0u) {
        default: {
            let _e79 = global;
            let _e82 = arrayLength((&global_6.member));
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
                let _e132 = (_e130 < arrayLength((&global_5.member)));
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
                            phi_330_ = (bitcast<i32>((_e209 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_330_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e209)), 32u, (_e209 == 0u))));
                        }
                        let _e223 = phi_330_;
                        phi_331_ = _e223;
                    } else {
                        phi_331_ = 0i;
                    }
                    let _e225 = phi_331_;
                    let _e226 = (_e142 == _e181);
                    if _e226 {
                        phi_341_ = true;
                    } else {
                        phi_341_ = (_e149 == _e181);
                    }
                    let _e229 = phi_341_;
                    let _e230 = select(1u, 0u, _e226);
                    if _e229 {
                        let _e231 = (_e230 + 1u);
                        phi_351_ = _e231;
                        phi_352_ = _e231;
                        phi_354_ = select(true, false, (_e231 == 2u));
                    } else {
                        phi_351_ = u32();
                        phi_352_ = 0u;
                        phi_354_ = true;
                    }
                    let _e235 = phi_351_;
                    let _e237 = phi_352_;
                    let _e239 = phi_354_;
                    if _e239 {
                        phi_359_ = (_e237 + 1u);
                    } else {
                        phi_359_ = 0u;
                    }
                    let _e243 = phi_359_;
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
                        phi_404_ = _e274[0];
                    } else {
                        phi_404_ = _e274[1];
                    }
                    let _e279 = phi_404_;
                    let _e280 = (_e244 == 2u);
                    if _e280 {
                        phi_410_ = _e274[2];
                    } else {
                        phi_410_ = _e279;
                    }
                    let _e283 = phi_410_;
                    let _e285 = ((_e283 * _e251) * _e257);
                    let _e286 = global_4.member[_e130].member_2;
                    if _e275 {
                        phi_421_ = _e286[0];
                    } else {
                        phi_421_ = _e286[1];
                    }
                    let _e290 = phi_421_;
                    if _e280 {
                        phi_427_ = _e286[2];
                    } else {
                        phi_427_ = _e290;
                    }
                    let _e293 = phi_427_;
                    let _e295 = ((_e293 * _e264) * _e270);
                    let _e299 = (bitcast<f32>((bitcast<u32>(_e295) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e299 {
                        let _e303 = (bitcast<f32>((bitcast<u32>(_e285) & 2147483647u)) * 0.00000011920929f);
                        phi_450_ = select(0.00000000000011368684f, _e303, (_e303 > 0.00000000000011368684f));
                    } else {
                        phi_450_ = 0f;
                    }
                    let _e307 = phi_450_;
                    let _e308 = (_e285 + _e307);
                    let _e309 = (_e285 - _e307);
                    let _e310 = select(_e295, 0f, _e299);
                    if _e299 {
                        phi_461_ = 38685626000000000000000000f;
                    } else {
                        phi_461_ = (1f / _e295);
                    }
                    let _e313 = phi_461_;
                    let _e314 = (_e243 == 0u);
                    if _e314 {
                        phi_470_ = _e274[0];
                    } else {
                        phi_470_ = _e274[1];
                    }
                    let _e318 = phi_470_;
                    let _e319 = (_e243 == 2u);
                    if _e319 {
                        phi_476_ = _e274[2];
                    } else {
                        phi_476_ = _e318;
                    }
                    let _e322 = phi_476_;
                    let _e324 = ((_e322 * _e251) * _e257);
                    if _e314 {
                        phi_487_ = _e286[0];
                    } else {
                        phi_487_ = _e286[1];
                    }
                    let _e328 = phi_487_;
                    if _e319 {
                        phi_493_ = _e286[2];
                    } else {
                        phi_493_ = _e328;
                    }
                    let _e331 = phi_493_;
                    let _e333 = ((_e331 * _e264) * _e270);
                    let _e337 = (bitcast<f32>((bitcast<u32>(_e333) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e337 {
                        let _e341 = (bitcast<f32>((bitcast<u32>(_e324) & 2147483647u)) * 0.00000011920929f);
                        phi_516_ = select(0.00000000000011368684f, _e341, (_e341 > 0.00000000000011368684f));
                    } else {
                        phi_516_ = 0f;
                    }
                    let _e345 = phi_516_;
                    let _e346 = (_e324 + _e345);
                    let _e347 = (_e324 - _e345);
                    let _e348 = select(_e333, 0f, _e337);
                    if _e337 {
                        phi_527_ = 38685626000000000000000000f;
                    } else {
                        phi_527_ = (1f / _e333);
                    }
                    let _e351 = phi_527_;
                    let _e352 = (_e245 == 0u);
                    if _e352 {
                        phi_536_ = _e274[0];
                    } else {
                        phi_536_ = _e274[1];
                    }
                    let _e356 = phi_536_;
                    let _e357 = (_e245 == 2u);
                    if _e357 {
                        phi_542_ = _e274[2];
                    } else {
                        phi_542_ = _e356;
                    }
                    let _e360 = phi_542_;
                    let _e362 = ((_e360 * _e251) * _e257);
                    if _e352 {
                        phi_553_ = _e286[0];
                    } else {
                        phi_553_ = _e286[1];
                    }
                    let _e366 = phi_553_;
                    if _e357 {
                        phi_559_ = _e286[2];
                    } else {
                        phi_559_ = _e366;
                    }
                    let _e369 = phi_559_;
                    let _e371 = ((_e369 * _e264) * _e270);
                    let _e375 = (bitcast<f32>((bitcast<u32>(_e371) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e375 {
                        let _e379 = (bitcast<f32>((bitcast<u32>(_e362) & 2147483647u)) * 0.00000011920929f);
                        phi_582_ = select(0.00000000000011368684f, _e379, (_e379 > 0.00000000000011368684f));
                    } else {
                        phi_582_ = 0f;
                    }
                    let _e383 = phi_582_;
                    let _e384 = (_e362 + _e383);
                    let _e385 = (_e362 - _e383);
                    let _e386 = select(_e371, 0f, _e375);
                    if _e375 {
                        phi_593_ = 38685626000000000000000000f;
                    } else {
                        phi_593_ = (1f / _e371);
                    }
                    let _e389 = phi_593_;
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
                        phi_693_ = select(-340282350000000000000000000000000000000f, _e430, (_e430 > -340282350000000000000000000000000000000f));
                        phi_694_ = select(-340282350000000000000000000000000000000f, _e423, (_e423 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_693_ = 0f;
                        phi_694_ = 1f;
                    }
                    let _e434 = phi_693_;
                    let _e436 = phi_694_;
                    local_3 = array<type_49, 128>(type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_49(type_46(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u));
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
                    phi_4565_ = false;
                    phi_2822_ = type_36(_e434, false);
                    phi_2825_ = type_49(type_46(array<f32, 3>(_e444, _e448, _e452), array<f32, 3>(_e456, _e458, _e460)), select(0u, 2147483648u, (_e82 == 0u)));
                    phi_2827_ = ((3u * _e82) + 1u);
                    phi_2829_ = (_e436 <= _e434);
                    phi_2831_ = 0u;
                    loop {
                        let _e468 = phi_4565_;
                        let _e470 = phi_2822_;
                        let _e472 = phi_2825_;
                        let _e474 = phi_2827_;
                        let _e476 = phi_2829_;
                        let _e478 = phi_2831_;
                        local_13 = _e470;
                        if _e476 {
                            phi_2842_ = true;
                        } else {
                            phi_2842_ = (_e478 > 0u);
                        }
                        let _e481 = phi_2842_;
                        if _e481 {
                            let _e482 = (_e474 > 0u);
                            if _e482 {
                                if _e476 {
                                    phi_2887_ = _e472;
                                    phi_2888_ = _e476;
                                    phi_2889_ = _e478;
                                } else {
                                    let _e483 = (_e478 - 1u);
                                    let _e484 = (_e483 % 128u);
                                    let _e485 = (_e484 < 128u);
                                    if _e485 {
                                    } else {
                                        phi_4682_ = true;
                                        break;
                                    }
                                    let _e487 = local_3[_e484];
                                    if _e485 {
                                    } else {
                                        phi_4682_ = true;
                                        break;
                                    }
                                    let _e503 = local_2[_e484];
                                    phi_2887_ = type_49(type_46(array<f32, 3>(_e487.member.member[0], _e487.member.member[1], _e487.member.member[2]), array<f32, 3>(_e487.member.member_1[0], _e487.member.member_1[1], _e487.member.member_1[2])), _e487.member_1);
                                    phi_2888_ = (_e503 <= _e470.member);
                                    phi_2889_ = _e483;
                                }
                                let _e507 = phi_2887_;
                                let _e509 = phi_2888_;
                                let _e511 = phi_2889_;
                                if _e509 {
                                    if ((_e507.member_1 & 2147483648u) != 0u) {
                                        phi_2907_ = _e470;
                                        phi_2910_ = type_7(0u, ((_e507.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e833 = phi_2907_;
                                            let _e835 = phi_2910_;
                                            local_12 = _e833;
                                            local_14 = _e833;
                                            if (_e835.member < _e835.member_1) {
                                                phi_2911_ = type_7((_e835.member + 1u), _e835.member_1);
                                                phi_2933_ = type_7(1u, _e835.member);
                                            } else {
                                                phi_2911_ = _e835;
                                                phi_2933_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e848 = phi_2911_;
                                            let _e850 = phi_2933_;
                                            let _e854 = (bitcast<i32>(_e850.member) != 0i);
                                            if _e854 {
                                                let _e855 = ((_e507.member_1 & 268435455u) + _e850.member_1);
                                                let _e856 = (_e855 < _e84);
                                                if _e856 {
                                                    if _e856 {
                                                    } else {
                                                        phi_4622_ = true;
                                                        break;
                                                    }
                                                    let _e860 = global_2.member[_e855].member_1;
                                                    phi_2954_ = _e860;
                                                } else {
                                                    phi_2954_ = 4294967295u;
                                                }
                                                let _e862 = phi_2954_;
                                                if (_e855 >= _e84) {
                                                    phi_3043_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e856 {
                                                    } else {
                                                        phi_4622_ = true;
                                                        break;
                                                    }
                                                    if (_e441 < 9u) {
                                                    } else {
                                                        phi_4622_ = true;
                                                        break;
                                                    }
                                                    let _e869 = global_2.member[_e855].member[_e441];
                                                    if (_e445 < 9u) {
                                                    } else {
                                                        phi_4622_ = true;
                                                        break;
                                                    }
                                                    let _e875 = global_2.member[_e855].member[_e445];
                                                    if (_e449 < 9u) {
                                                    } else {
                                                        phi_4622_ = true;
                                                        break;
                                                    }
                                                    let _e881 = global_2.member[_e855].member[_e449];
                                                    let _e883 = (3u + _e441);
                                                    if (_e883 < 9u) {
                                                    } else {
                                                        phi_4622_ = true;
                                                        break;
                                                    }
                                                    let _e889 = global_2.member[_e855].member[_e883];
                                                    let _e890 = (3u + _e445);
                                                    if (_e890 < 9u) {
                                                    } else {
                                                        phi_4622_ = true;
                                                        break;
                                                    }
                                                    let _e896 = global_2.member[_e855].member[_e890];
                                                    let _e897 = (3u + _e449);
                                                    if (_e897 < 9u) {
                                                    } else {
                                                        phi_4622_ = true;
                                                        break;
                                                    }
                                                    let _e903 = global_2.member[_e855].member[_e897];
                                                    let _e905 = (6u + _e441);
                                                    if (_e905 < 9u) {
                                                    } else {
                                                        phi_4622_ = true;
                                                        break;
                                                    }
                                                    let _e911 = global_2.member[_e855].member[_e905];
                                                    let _e912 = (6u + _e445);
                                                    if (_e912 < 9u) {
                                                    } else {
                                                        phi_4622_ = true;
                                                        break;
                                                    }
                                                    let _e918 = global_2.member[_e855].member[_e912];
                                                    let _e919 = (6u + _e449);
                                                    if (_e919 < 9u) {
                                                    } else {
                                                        phi_4622_ = true;
                                                        break;
                                                    }
                                                    let _e925 = global_2.member[_e855].member[_e919];
                                                    phi_3043_ = array<array<f32, 3>, 3>(array<f32, 3>(_e869, _e875, _e881), array<f32, 3>(_e889, _e896, _e903), array<f32, 3>(_e911, _e918, _e925));
                                                }
                                                let _e929 = phi_3043_;
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
                                                        phi_3609_ = type_25();
                                                        phi_3610_ = true;
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
                                                            phi_3604_ = type_25();
                                                            phi_3605_ = true;
                                                        } else {
                                                            let _e1067 = (_e1065 > _e833.member);
                                                            if _e1067 {
                                                                phi_3603_ = type_25();
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
                                                                    phi_3514_ = _e1078;
                                                                    phi_3515_ = _e1082;
                                                                } else {
                                                                    let _e1128 = vec3((_e1108 == _e1125));
                                                                    phi_3514_ = select(_e1074, _e1082, _e1128);
                                                                    phi_3515_ = select(_e1078, _e1074, _e1128);
                                                                }
                                                                let _e1132 = phi_3514_;
                                                                let _e1134 = phi_3515_;
                                                                let _e1141 = ((_e1132.y * _e1134.z) - (_e1134.y * _e1132.z));
                                                                let _e1146 = ((_e1132.z * _e1134.x) - (_e1134.z * _e1132.x));
                                                                let _e1149 = ((_e1132.x * _e1134.y) - (_e1134.x * _e1132.y));
                                                                if (_e991 >= _e995) {
                                                                    phi_3546_ = select(true, false, (_e991 >= _e999));
                                                                } else {
                                                                    phi_3546_ = true;
                                                                }
                                                                let _e1154 = phi_3546_;
                                                                if _e1154 {
                                                                    phi_3555_ = select(vec3<f32>(_e929[2][0], _e929[2][1], _e929[2][2]), vec3<f32>(_e929[1][0], _e929[1][1], _e929[1][2]), vec3((_e995 >= _e999)));
                                                                } else {
                                                                    phi_3555_ = vec3<f32>(_e929[0][0], _e929[0][1], _e929[0][2]);
                                                                }
                                                                let _e1159 = phi_3555_;
                                                                let _e1176 = ((((_e1141 * (_e1159.x - _e285)) + (_e1146 * (_e1159.y - _e324))) + (_e1149 * (_e1159.z - _e362))) / (((_e1141 * _e310) + (_e1146 * _e348)) + (_e1149 * _e386)));
                                                                let _e1178 = select(_e1058, _e1176, (_e1176 < _e1058));
                                                                let _e1180 = select(_e1050, _e1178, (_e1178 > _e1050));
                                                                if (_e1180 >= _e436) {
                                                                    let _e1182 = (_e1180 <= _e833.member);
                                                                    if _e1182 {
                                                                        let _e1183 = (1f / _e1001);
                                                                        phi_3595_ = type_25(_e1180, (_e995 * _e1183), (_e999 * _e1183), _e862);
                                                                    } else {
                                                                        phi_3595_ = type_25();
                                                                    }
                                                                    let _e1188 = phi_3595_;
                                                                    phi_3597_ = _e1188;
                                                                    phi_3598_ = select(true, false, _e1182);
                                                                } else {
                                                                    phi_3597_ = type_25();
                                                                    phi_3598_ = true;
                                                                }
                                                                let _e1191 = phi_3597_;
                                                                let _e1193 = phi_3598_;
                                                                if _e1193 {
                                                                    phi_3602_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_3602_ = _e1191;
                                                                }
                                                                let _e1195 = phi_3602_;
                                                                phi_3603_ = _e1195;
                                                            }
                                                            let _e1197 = phi_3603_;
                                                            phi_3604_ = _e1197;
                                                            phi_3605_ = _e1067;
                                                        }
                                                        let _e1199 = phi_3604_;
                                                        let _e1201 = phi_3605_;
                                                        phi_3609_ = _e1199;
                                                        phi_3610_ = _e1201;
                                                    }
                                                    let _e1203 = phi_3609_;
                                                    let _e1205 = phi_3610_;
                                                    phi_3614_ = _e1203;
                                                    phi_3615_ = _e1205;
                                                } else {
                                                    phi_3614_ = type_25();
                                                    phi_3615_ = true;
                                                }
                                                let _e1207 = phi_3614_;
                                                let _e1209 = phi_3615_;
                                                if _e1209 {
                                                    phi_3619_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_3619_ = _e1207;
                                                }
                                                let _e1211 = phi_3619_;
                                                if (_e1211.member_3 != 4294967295u) {
                                                    if (_e862 != 4294967295u) {
                                                        phi_3630_ = type_36(_e833.member, true);
                                                    } else {
                                                        phi_3630_ = _e833;
                                                    }
                                                    let _e1219 = phi_3630_;
                                                    phi_3631_ = _e1219;
                                                } else {
                                                    phi_3631_ = _e833;
                                                }
                                                let _e1221 = phi_3631_;
                                                phi_2908_ = _e1221;
                                            } else {
                                                phi_2908_ = type_36();
                                            }
                                            let _e1223 = phi_2908_;
                                            continue;
                                            continuing {
                                                phi_2907_ = _e1223;
                                                phi_2910_ = _e848;
                                                phi_4622_ = _e468;
                                                break if !(_e854);
                                            }
                                        }
                                        let _e1226 = phi_4622_;
                                        phi_4682_ = _e1226;
                                        if _e1226 {
                                            break;
                                        }
                                        let _e1228 = local_12;
                                        phi_4686_ = _e1226;
                                        let _e1374 = local_14;
                                        phi_4476_ = _e1374;
                                        phi_4477_ = _e507;
                                        phi_4478_ = false;
                                        phi_4479_ = select(_e511, 0u, _e1228.member_1);
                                    } else {
                                        local_1 = array<f32, 3>(_e507.member.member[0], _e507.member.member[1], _e507.member.member[2]);
                                        local = array<f32, 3>(_e507.member.member_1[0], _e507.member.member_1[1], _e507.member.member_1[2]);
                                        let _e531 = (_e507.member_1 < _e82);
                                        if _e531 {
                                            if _e531 {
                                            } else {
                                                phi_4682_ = true;
                                                break;
                                            }
                                            let _e533 = global_6.member[_e507.member_1];
                                            phi_3666_ = _e533;
                                        } else {
                                            phi_3666_ = type_40(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e535 = phi_3666_;
                                        let _e537 = array<u32, 3>(_e244, _e243, _e245);
                                        local_9 = _e537;
                                        local_5 = array<f32, 3>(0f, 0f, 0f);
                                        local_4 = array<f32, 3>(0f, 0f, 0f);
                                        phi_3675_ = type_7(0u, 3u);
                                        loop {
                                            let _e539 = phi_3675_;
                                            if (_e539.member < _e539.member_1) {
                                                phi_3676_ = type_7((_e539.member + 1u), _e539.member_1);
                                                phi_3699_ = type_7(1u, _e539.member);
                                            } else {
                                                phi_3676_ = _e539;
                                                phi_3699_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e552 = phi_3676_;
                                            let _e554 = phi_3699_;
                                            let _e558 = (bitcast<i32>(_e554.member) != 0i);
                                            if _e558 {
                                                let _e559 = (_e554.member_1 < 3u);
                                                if _e559 {
                                                } else {
                                                    phi_4558_ = true;
                                                    break;
                                                }
                                                let _e561 = local_9[_e554.member_1];
                                                if _e559 {
                                                } else {
                                                    phi_4558_ = true;
                                                    break;
                                                }
                                                let _e563 = local_1[_e554.member_1];
                                                if _e559 {
                                                } else {
                                                    phi_4558_ = true;
                                                    break;
                                                }
                                                let _e565 = local[_e554.member_1];
                                                let _e568 = ((10u * _e561) & 31u);
                                                let _e571 = ((_e535.member[0] >> bitcast<u32>(_e568)) & 1023u);
                                                let _e576 = bitcast<f32>((bitcast<u32>(((_e565 - _e563) * 0.0009775171f)) ^ _e116));
                                                let _e582 = (_e563 + bitcast<f32>((bitcast<u32>((f32(_e571) * _e576)) ^ _e116)));
                                                if _e559 {
                                                } else {
                                                    phi_4558_ = true;
                                                    break;
                                                }
                                                local_5[_e554.member_1] = select(select(_e565, _e582, (_e582 < _e565)), _e565, (_e571 == 1023u));
                                                let _e591 = ((_e535.member[1] >> bitcast<u32>(_e568)) & 1023u);
                                                let _e597 = (_e563 + bitcast<f32>((bitcast<u32>((f32(_e591) * _e576)) ^ _e116)));
                                                if _e559 {
                                                } else {
                                                    phi_4558_ = true;
                                                    break;
                                                }
                                                local_4[_e554.member_1] = select(select(_e565, _e597, (_e597 < _e565)), _e565, (_e591 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_3675_ = _e552;
                                                phi_4558_ = _e468;
                                                break if !(_e558);
                                            }
                                        }
                                        let _e605 = phi_4558_;
                                        phi_4682_ = _e605;
                                        if _e605 {
                                            break;
                                        }
                                        let _e606 = local_4;
                                        let _e607 = local_5;
                                        local_8 = _e537;
                                        local_7 = array<f32, 3>(0f, 0f, 0f);
                                        local_6 = array<f32, 3>(0f, 0f, 0f);
                                        phi_3829_ = type_7(0u, 3u);
                                        loop {
                                            let _e616 = phi_3829_;
                                            if (_e616.member < _e616.member_1) {
                                                phi_3830_ = type_7((_e616.member + 1u), _e616.member_1);
                                                phi_3853_ = type_7(1u, _e616.member);
                                            } else {
                                                phi_3830_ = _e616;
                                                phi_3853_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e629 = phi_3830_;
                                            let _e631 = phi_3853_;
                                            let _e635 = (bitcast<i32>(_e631.member) != 0i);
                                            if _e635 {
                                                let _e636 = (_e631.member_1 < 3u);
                                                if _e636 {
                                                } else {
                                                    phi_4614_ = true;
                                                    break;
                                                }
                                                let _e638 = local_8[_e631.member_1];
                                                if _e636 {
                                                } else {
                                                    phi_4614_ = true;
                                                    break;
                                                }
                                                let _e640 = local_1[_e631.member_1];
                                                if _e636 {
                                                } else {
                                                    phi_4614_ = true;
                                                    break;
                                                }
                                                let _e642 = local[_e631.member_1];
                                                let _e645 = ((10u * _e638) & 31u);
                                                let _e648 = ((_e535.member_1[0] >> bitcast<u32>(_e645)) & 1023u);
                                                let _e653 = bitcast<f32>((bitcast<u32>(((_e642 - _e640) * 0.0009775171f)) ^ _e116));
                                                let _e659 = (_e640 + bitcast<f32>((bitcast<u32>((f32(_e648) * _e653)) ^ _e116)));
                                                if _e636 {
                                                } else {
                                                    phi_4614_ = true;
                                                    break;
                                                }
                                                local_7[_e631.member_1] = select(select(_e642, _e659, (_e659 < _e642)), _e642, (_e648 == 1023u));
                                                let _e668 = ((_e535.member_1[1] >> bitcast<u32>(_e645)) & 1023u);
                                                let _e674 = (_e640 + bitcast<f32>((bitcast<u32>((f32(_e668) * _e653)) ^ _e116)));
                                                if _e636 {
                                                } else {
                                                    phi_4614_ = true;
                                                    break;
                                                }
                                                local_6[_e631.member_1] = select(select(_e642, _e674, (_e674 < _e642)), _e642, (_e668 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_3829_ = _e629;
                                                phi_4614_ = _e605;
                                                break if !(_e635);
                                            }
                                        }
                                        let _e682 = phi_4614_;
                                        phi_4682_ = _e682;
                                        if _e682 {
                                            break;
                                        }
                                        let _e683 = local_6;
                                        let _e684 = local_7;
                                        let _e695 = type_49(type_46(array<f32, 3>(_e607[0], _e607[1], _e607[2]), array<f32, 3>(_e606[0], _e606[1], _e606[2])), _e535.member_2);
                                        let _e700 = type_49(type_46(array<f32, 3>(_e684[0], _e684[1], _e684[2]), array<f32, 3>(_e683[0], _e683[1], _e683[2])), _e535.member_3);
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
                                        let _e784 = (_e777 <= select(_e470.member, _e774, (_e774 < _e470.member)));
                                        let _e785 = (_e779 <= select(_e470.member, _e775, (_e775 < _e470.member)));
                                        let _e786 = (_e777 <= _e779);
                                        if _e784 {
                                            if _e785 {
                                                if _e786 {
                                                    phi_4416_ = _e700;
                                                } else {
                                                    phi_4416_ = _e695;
                                                }
                                                let _e788 = phi_4416_;
                                                let _e789 = (_e511 % 128u);
                                                let _e790 = (_e789 < 128u);
                                                if _e790 {
                                                } else {
                                                    phi_4682_ = true;
                                                    break;
                                                }
                                                local_3[_e789] = type_49(type_46(array<f32, 3>(_e788.member.member[0], _e788.member.member[1], _e788.member.member[2]), array<f32, 3>(_e788.member.member_1[0], _e788.member.member_1[1], _e788.member.member_1[2])), _e788.member_1);
                                                if _e790 {
                                                } else {
                                                    phi_4682_ = true;
                                                    break;
                                                }
                                                local_2[_e789] = select(_e779, _e777, (_e777 > _e779));
                                                if _e786 {
                                                    phi_4455_ = _e695;
                                                } else {
                                                    phi_4455_ = _e700;
                                                }
                                                let _e811 = phi_4455_;
                                                phi_4456_ = _e811;
                                                phi_4457_ = (_e511 + 1u);
                                            } else {
                                                phi_4456_ = type_49();
                                                phi_4457_ = u32();
                                            }
                                            let _e813 = phi_4456_;
                                            let _e815 = phi_4457_;
                                            phi_4459_ = _e813;
                                            phi_4460_ = _e815;
                                            phi_4461_ = select(true, false, _e785);
                                        } else {
                                            phi_4459_ = type_49();
                                            phi_4460_ = u32();
                                            phi_4461_ = true;
                                        }
                                        let _e818 = phi_4459_;
                                        let _e820 = phi_4460_;
                                        let _e822 = phi_4461_;
                                        if _e822 {
                                            if _e784 {
                                                phi_4468_ = _e695;
                                            } else {
                                                phi_4468_ = _e700;
                                            }
                                            let _e824 = phi_4468_;
                                            phi_4473_ = _e824;
                                            phi_4474_ = select(_e785, true, _e784);
                                        } else {
                                            phi_4473_ = _e818;
                                            phi_4474_ = _e509;
                                        }
                                        let _e827 = phi_4473_;
                                        let _e829 = phi_4474_;
                                        phi_4686_ = _e682;
                                        phi_4476_ = _e470;
                                        phi_4477_ = _e827;
                                        phi_4478_ = _e829;
                                        phi_4479_ = select(_e820, _e511, _e822);
                                    }
                                    let _e1232 = phi_4686_;
                                    let _e1234 = phi_4476_;
                                    let _e1236 = phi_4477_;
                                    let _e1238 = phi_4478_;
                                    let _e1240 = phi_4479_;
                                    phi_4685_ = _e1232;
                                    phi_4480_ = _e1234;
                                    phi_4481_ = _e1236;
                                    phi_4482_ = (_e474 - 1u);
                                    phi_4483_ = _e1238;
                                    phi_4484_ = _e1240;
                                } else {
                                    phi_4685_ = _e468;
                                    phi_4480_ = _e470;
                                    phi_4481_ = _e507;
                                    phi_4482_ = _e474;
                                    phi_4483_ = _e509;
                                    phi_4484_ = _e511;
                                }
                                let _e1242 = phi_4685_;
                                let _e1244 = phi_4480_;
                                let _e1246 = phi_4481_;
                                let _e1248 = phi_4482_;
                                let _e1250 = phi_4483_;
                                let _e1252 = phi_4484_;
                                phi_4684_ = _e1242;
                                phi_4485_ = _e1244;
                                phi_4486_ = _e1246;
                                phi_4487_ = _e1248;
                                phi_4488_ = _e1250;
                                phi_4489_ = _e1252;
                            } else {
                                phi_4684_ = _e468;
                                phi_4485_ = type_36();
                                phi_4486_ = type_49();
                                phi_4487_ = u32();
                                phi_4488_ = bool();
                                phi_4489_ = u32();
                            }
                            let _e1254 = phi_4684_;
                            let _e1256 = phi_4485_;
                            let _e1258 = phi_4486_;
                            let _e1260 = phi_4487_;
                            let _e1262 = phi_4488_;
                            let _e1264 = phi_4489_;
                            phi_4683_ = _e1254;
                            phi_2823_ = _e1256;
                            phi_2826_ = _e1258;
                            phi_2828_ = _e1260;
                            phi_2830_ = _e1262;
                            phi_2832_ = _e1264;
                            phi_4490_ = _e482;
                        } else {
                            phi_4683_ = _e468;
                            phi_2823_ = type_36();
                            phi_2826_ = type_49();
                            phi_2828_ = u32();
                            phi_2830_ = bool();
                            phi_2832_ = u32();
                            phi_4490_ = false;
                        }
                        let _e1266 = phi_4683_;
                        let _e1268 = phi_2823_;
                        let _e1270 = phi_2826_;
                        let _e1272 = phi_2828_;
                        let _e1274 = phi_2830_;
                        let _e1276 = phi_2832_;
                        let _e1278 = phi_4490_;
                        continue;
                        continuing {
                            phi_4565_ = _e1266;
                            phi_2822_ = _e1268;
                            phi_2825_ = _e1270;
                            phi_2827_ = _e1272;
                            phi_2829_ = _e1274;
                            phi_2831_ = _e1276;
                            phi_4682_ = _e1266;
                            break if !(_e1278);
                        }
                    }
                    let _e1281 = phi_4682_;
                    if _e1281 {
                        break;
                    }
                    let _e1283 = local_13;
                    if _e132 {
                    } else {
                        break;
                    }
                    global_5.member[_e130] = select(0u, 1u, _e1283.member_1);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_any_printed_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
