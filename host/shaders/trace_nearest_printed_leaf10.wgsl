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

struct type_19 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_26 {
    member: array<type_19>,
}

struct type_30 {
    member: array<array<type_18, 8>>,
}

struct type_36 {
    member: array<vec4<u32>, 2>,
}

struct type_38 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_40 {
    member: array<type_38>,
}

struct type_43 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_46 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_48 {
    member: array<type_46>,
}

struct type_52 {
    member: type_43,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(1) 
var<uniform> global_2: type_36;
@group(0) @binding(4) 
var<storage> global_3: type_26;
@group(0) @binding(2) 
var<storage> global_4: type_40;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_30;
@group(0) @binding(3) 
var<storage> global_6: type_48;

fn function_() {
    var local: array<f32, 3>;
    var local_1: array<f32, 3>;
    var local_2: array<f32, 3>;
    var local_3: array<f32, 3>;
    var local_4: array<type_18, 8>;
    var local_5: array<f32, 128>;
    var local_6: array<type_52, 128>;
    var local_7: array<f32, 3>;
    var local_8: array<f32, 3>;
    var local_9: array<f32, 3>;
    var local_10: array<f32, 3>;
    var local_11: array<u32, 3>;
    var local_12: array<u32, 3>;
    var local_13: array<u32, 3>;
    var local_14: array<array<f32, 3>, 3>;
    var local_15: array<u32, 3>;
    var local_16: array<f32, 3>;
    var local_17: array<f32, 3>;
    var phi_351_: i32;
    var phi_352_: i32;
    var phi_362_: bool;
    var phi_372_: u32;
    var phi_373_: u32;
    var phi_375_: bool;
    var phi_380_: u32;
    var phi_425_: f32;
    var phi_431_: f32;
    var phi_442_: f32;
    var phi_448_: f32;
    var phi_471_: f32;
    var phi_482_: f32;
    var phi_491_: f32;
    var phi_497_: f32;
    var phi_508_: f32;
    var phi_514_: f32;
    var phi_537_: f32;
    var phi_548_: f32;
    var phi_557_: f32;
    var phi_563_: f32;
    var phi_574_: f32;
    var phi_580_: f32;
    var phi_603_: f32;
    var phi_614_: f32;
    var phi_714_: f32;
    var phi_715_: f32;
    var phi_5027_: bool;
    var phi_5018_: f32;
    var phi_2896_: type_52;
    var phi_2899_: u32;
    var phi_2901_: bool;
    var phi_2903_: u32;
    var phi_2914_: bool;
    var phi_2960_: type_52;
    var phi_2961_: bool;
    var phi_2962_: u32;
    var phi_3946_: type_38;
    var phi_3955_: type_4;
    var phi_3956_: type_4;
    var phi_3979_: type_4;
    var phi_5020_: bool;
    var phi_4109_: type_4;
    var phi_4110_: type_4;
    var phi_4133_: type_4;
    var phi_5076_: bool;
    var phi_4697_: type_52;
    var phi_4736_: type_52;
    var phi_4737_: type_52;
    var phi_4738_: u32;
    var phi_4740_: type_52;
    var phi_4741_: u32;
    var phi_4742_: bool;
    var phi_4749_: type_52;
    var phi_4754_: type_52;
    var phi_4755_: bool;
    var phi_5125_: f32;
    var phi_5111_: bool;
    var phi_2981_: type_4;
    var phi_2982_: type_4;
    var phi_3005_: type_4;
    var phi_3047_: u32;
    var phi_3071_: type_46;
    var phi_5107_: bool;
    var phi_3082_: type_4;
    var phi_3083_: type_4;
    var phi_3106_: type_4;
    var phi_3116_: type_4;
    var phi_3117_: type_4;
    var phi_3140_: type_4;
    var phi_5102_: bool;
    var phi_5115_: bool;
    var phi_5114_: bool;
    var phi_3704_: vec3<f32>;
    var phi_3705_: vec3<f32>;
    var phi_3736_: bool;
    var phi_3745_: vec3<f32>;
    var phi_3785_: type_18;
    var phi_3787_: type_18;
    var phi_3788_: bool;
    var phi_3792_: type_18;
    var phi_3793_: type_18;
    var phi_3794_: type_18;
    var phi_3795_: bool;
    var phi_3799_: type_18;
    var phi_3800_: bool;
    var phi_3804_: type_18;
    var phi_3805_: bool;
    var phi_3809_: type_18;
    var phi_3821_: type_4;
    var phi_3824_: type_18;
    var phi_3822_: type_4;
    var phi_3847_: type_4;
    var phi_3879_: bool;
    var phi_3880_: bool;
    var phi_3901_: type_18;
    var phi_3825_: type_18;
    var phi_5130_: bool;
    var phi_5341_: f32;
    var phi_5340_: f32;
    var phi_5192_: bool;
    var phi_5339_: f32;
    var phi_5191_: bool;
    var phi_5338_: f32;
    var phi_5190_: bool;
    var phi_5278_: f32;
    var phi_5189_: bool;
    var phi_5243_: f32;
    var phi_5198_: bool;
    var phi_4757_: type_52;
    var phi_4758_: bool;
    var phi_4759_: u32;
    var phi_5242_: f32;
    var phi_5197_: bool;
    var phi_4760_: type_52;
    var phi_4761_: u32;
    var phi_4762_: bool;
    var phi_4763_: u32;
    var phi_5241_: f32;
    var phi_5196_: bool;
    var phi_4764_: type_52;
    var phi_4765_: u32;
    var phi_4766_: bool;
    var phi_4767_: u32;
    var phi_5240_: f32;
    var phi_5195_: bool;
    var phi_2897_: type_52;
    var phi_2900_: u32;
    var phi_2902_: bool;
    var phi_2904_: u32;
    var phi_4768_: bool;
    var phi_5194_: bool;
    var phi_4775_: type_4;
    var phi_4776_: type_4;
    var phi_4799_: type_4;
    var phi_4865_: type_18;
    var phi_5233_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e86 = global;
            let _e89 = arrayLength((&global_4.member));
            let _e100 = global_2.member[0u][0u];
            let _e104 = global_2.member[0u][1u];
            let _e108 = global_2.member[0u][2u];
            let _e112 = global_2.member[1u][0u];
            let _e116 = global_2.member[1u][1u];
            let _e120 = global_2.member[1u][2u];
            let _e124 = global_2.member[1u][3u];
            let _e127 = global_1.member[0u];
            let _e128 = bitcast<i32>(_e127);
            let _e138 = (_e86.x + (_e86.y * 2097152u));
            let _e139 = (_e138 < arrayLength((&global_3.member)));
            if _e139 {
                let _e140 = (_e138 < arrayLength((&global_5.member)));
                if _e140 {
                    if _e139 {
                    } else {
                        break;
                    }
                    let _e148 = global_3.member[_e138].member_2[0u];
                    let _e150 = (bitcast<u32>(_e148) & 2147483647u);
                    let _e155 = global_3.member[_e138].member_2[1u];
                    let _e157 = (bitcast<u32>(_e155) & 2147483647u);
                    let _e162 = global_3.member[_e138].member_2[2u];
                    let _e164 = (bitcast<u32>(_e162) & 2147483647u);
                    let _e169 = global_3.member[_e138].member[0u];
                    let _e171 = (bitcast<u32>(_e169) & 2147483647u);
                    let _e176 = global_3.member[_e138].member[1u];
                    let _e178 = (bitcast<u32>(_e176) & 2147483647u);
                    let _e183 = global_3.member[_e138].member[2u];
                    let _e185 = (bitcast<u32>(_e183) & 2147483647u);
                    let _e187 = select(_e157, _e150, (_e157 < _e150));
                    let _e189 = select(_e164, _e187, (_e164 < _e187));
                    let _e191 = select(_e171, _e189, (_e171 < _e189));
                    let _e193 = select(_e178, _e191, (_e178 < _e191));
                    let _e195 = select(_e185, _e193, (_e185 < _e193));
                    let _e199 = global_3.member[_e138].member_1;
                    let _e201 = (bitcast<u32>(_e199) & 2147483647u);
                    let _e208 = global_3.member[_e138].member_3;
                    let _e214 = (((select(_e201, _e195, (_e201 < _e195)) < 2139095040u) && ((bitcast<u32>(_e208) & 2147483647u) <= 2139095040u)) && (_e189 > 0u));
                    if _e214 {
                        let _e217 = (bitcast<u32>(bitcast<f32>(_e189)) & 2147483647u);
                        if (_e217 >= 8388608u) {
                            phi_351_ = (bitcast<i32>((_e217 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_351_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e217)), 32u, (_e217 == 0u))));
                        }
                        let _e231 = phi_351_;
                        phi_352_ = _e231;
                    } else {
                        phi_352_ = 0i;
                    }
                    let _e233 = phi_352_;
                    let _e234 = (_e150 == _e189);
                    if _e234 {
                        phi_362_ = true;
                    } else {
                        phi_362_ = (_e157 == _e189);
                    }
                    let _e237 = phi_362_;
                    let _e238 = select(1u, 0u, _e234);
                    if _e237 {
                        let _e239 = (_e238 + 1u);
                        phi_372_ = _e239;
                        phi_373_ = _e239;
                        phi_375_ = select(true, false, (_e239 == 2u));
                    } else {
                        phi_372_ = u32();
                        phi_373_ = 0u;
                        phi_375_ = true;
                    }
                    let _e243 = phi_372_;
                    let _e245 = phi_373_;
                    let _e247 = phi_375_;
                    if _e247 {
                        phi_380_ = (_e245 + 1u);
                    } else {
                        phi_380_ = 0u;
                    }
                    let _e251 = phi_380_;
                    let _e252 = select(_e243, _e245, _e247);
                    let _e253 = select(_e238, select(2u, _e238, _e237), _e247);
                    let _e254 = (_e128 / 2i);
                    let _e259 = bitcast<f32>((bitcast<u32>((_e254 + 127i)) << bitcast<u32>(23i)));
                    let _e265 = bitcast<f32>((bitcast<u32>(((_e128 - _e254) + 127i)) << bitcast<u32>(23i)));
                    let _e266 = -(_e233);
                    let _e267 = (_e266 / 2i);
                    let _e272 = bitcast<f32>((bitcast<u32>((_e267 + 127i)) << bitcast<u32>(23i)));
                    let _e278 = bitcast<f32>((bitcast<u32>(((_e266 - _e267) + 127i)) << bitcast<u32>(23i)));
                    let _e282 = global_3.member[_e138].member;
                    let _e283 = (_e252 == 0u);
                    if _e283 {
                        phi_425_ = _e282[0];
                    } else {
                        phi_425_ = _e282[1];
                    }
                    let _e287 = phi_425_;
                    let _e288 = (_e252 == 2u);
                    if _e288 {
                        phi_431_ = _e282[2];
                    } else {
                        phi_431_ = _e287;
                    }
                    let _e291 = phi_431_;
                    let _e293 = ((_e291 * _e259) * _e265);
                    let _e294 = global_3.member[_e138].member_2;
                    if _e283 {
                        phi_442_ = _e294[0];
                    } else {
                        phi_442_ = _e294[1];
                    }
                    let _e298 = phi_442_;
                    if _e288 {
                        phi_448_ = _e294[2];
                    } else {
                        phi_448_ = _e298;
                    }
                    let _e301 = phi_448_;
                    let _e303 = ((_e301 * _e272) * _e278);
                    let _e307 = (bitcast<f32>((bitcast<u32>(_e303) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e307 {
                        let _e311 = (bitcast<f32>((bitcast<u32>(_e293) & 2147483647u)) * 0.00000011920929f);
                        phi_471_ = select(0.00000000000011368684f, _e311, (_e311 > 0.00000000000011368684f));
                    } else {
                        phi_471_ = 0f;
                    }
                    let _e315 = phi_471_;
                    let _e316 = (_e293 + _e315);
                    let _e317 = (_e293 - _e315);
                    let _e318 = select(_e303, 0f, _e307);
                    if _e307 {
                        phi_482_ = 38685626000000000000000000f;
                    } else {
                        phi_482_ = (1f / _e303);
                    }
                    let _e321 = phi_482_;
                    let _e322 = (_e251 == 0u);
                    if _e322 {
                        phi_491_ = _e282[0];
                    } else {
                        phi_491_ = _e282[1];
                    }
                    let _e326 = phi_491_;
                    let _e327 = (_e251 == 2u);
                    if _e327 {
                        phi_497_ = _e282[2];
                    } else {
                        phi_497_ = _e326;
                    }
                    let _e330 = phi_497_;
                    let _e332 = ((_e330 * _e259) * _e265);
                    if _e322 {
                        phi_508_ = _e294[0];
                    } else {
                        phi_508_ = _e294[1];
                    }
                    let _e336 = phi_508_;
                    if _e327 {
                        phi_514_ = _e294[2];
                    } else {
                        phi_514_ = _e336;
                    }
                    let _e339 = phi_514_;
                    let _e341 = ((_e339 * _e272) * _e278);
                    let _e345 = (bitcast<f32>((bitcast<u32>(_e341) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e345 {
                        let _e349 = (bitcast<f32>((bitcast<u32>(_e332) & 2147483647u)) * 0.00000011920929f);
                        phi_537_ = select(0.00000000000011368684f, _e349, (_e349 > 0.00000000000011368684f));
                    } else {
                        phi_537_ = 0f;
                    }
                    let _e353 = phi_537_;
                    let _e354 = (_e332 + _e353);
                    let _e355 = (_e332 - _e353);
                    let _e356 = select(_e341, 0f, _e345);
                    if _e345 {
                        phi_548_ = 38685626000000000000000000f;
                    } else {
                        phi_548_ = (1f / _e341);
                    }
                    let _e359 = phi_548_;
                    let _e360 = (_e253 == 0u);
                    if _e360 {
                        phi_557_ = _e282[0];
                    } else {
                        phi_557_ = _e282[1];
                    }
                    let _e364 = phi_557_;
                    let _e365 = (_e253 == 2u);
                    if _e365 {
                        phi_563_ = _e282[2];
                    } else {
                        phi_563_ = _e364;
                    }
                    let _e368 = phi_563_;
                    let _e370 = ((_e368 * _e259) * _e265);
                    if _e360 {
                        phi_574_ = _e294[0];
                    } else {
                        phi_574_ = _e294[1];
                    }
                    let _e374 = phi_574_;
                    if _e365 {
                        phi_580_ = _e294[2];
                    } else {
                        phi_580_ = _e374;
                    }
                    let _e377 = phi_580_;
                    let _e379 = ((_e377 * _e272) * _e278);
                    let _e383 = (bitcast<f32>((bitcast<u32>(_e379) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e383 {
                        let _e387 = (bitcast<f32>((bitcast<u32>(_e370) & 2147483647u)) * 0.00000011920929f);
                        phi_603_ = select(0.00000000000011368684f, _e387, (_e387 > 0.00000000000011368684f));
                    } else {
                        phi_603_ = 0f;
                    }
                    let _e391 = phi_603_;
                    let _e392 = (_e370 + _e391);
                    let _e393 = (_e370 - _e391);
                    let _e394 = select(_e379, 0f, _e383);
                    if _e383 {
                        phi_614_ = 38685626000000000000000000f;
                    } else {
                        phi_614_ = (1f / _e379);
                    }
                    let _e397 = phi_614_;
                    let _e400 = bitcast<f32>((bitcast<u32>(_e293) & 2147483647u));
                    let _e403 = bitcast<f32>((bitcast<u32>(_e332) & 2147483647u));
                    let _e405 = select(_e403, _e400, (_e400 > _e403));
                    let _e408 = bitcast<f32>((bitcast<u32>(_e370) & 2147483647u));
                    let _e411 = (_e128 + _e233);
                    if (_e214 && (select(_e408, _e405, (_e405 > _e408)) <= 1099511600000f)) {
                        let _e414 = (_e411 / 3i);
                        let _e421 = bitcast<f32>((bitcast<u32>((_e414 + 127i)) << bitcast<u32>(23i)));
                        let _e428 = bitcast<f32>((bitcast<u32>(((_e411 - (2i * _e414)) + 127i)) << bitcast<u32>(23i)));
                        let _e429 = (((_e199 * _e421) * _e421) * _e428);
                        let _e431 = select(340282350000000000000000000000000000000f, _e429, (_e429 < 340282350000000000000000000000000000000f));
                        let _e436 = (((_e208 * _e421) * _e421) * _e428);
                        let _e438 = select(340282350000000000000000000000000000000f, _e436, (_e436 < 340282350000000000000000000000000000000f));
                        phi_714_ = select(-340282350000000000000000000000000000000f, _e438, (_e438 > -340282350000000000000000000000000000000f));
                        phi_715_ = select(-340282350000000000000000000000000000000f, _e431, (_e431 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_714_ = 0f;
                        phi_715_ = 1f;
                    }
                    let _e442 = phi_714_;
                    let _e444 = phi_715_;
                    local_4 = array<type_18, 8>(type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_6 = array<type_52, 128>(type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u));
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_17 = array<f32, 3>(bitcast<f32>(_e100), bitcast<f32>(_e104), bitcast<f32>(_e108));
                    let _e448 = (_e252 % 3u);
                    let _e449 = (_e448 < 3u);
                    if _e449 {
                    } else {
                        break;
                    }
                    let _e451 = local_17[_e448];
                    let _e452 = (_e251 % 3u);
                    let _e453 = (_e452 < 3u);
                    if _e453 {
                    } else {
                        break;
                    }
                    let _e455 = local_17[_e452];
                    let _e456 = (_e253 % 3u);
                    let _e457 = (_e456 < 3u);
                    if _e457 {
                    } else {
                        break;
                    }
                    let _e459 = local_17[_e456];
                    local_16 = array<f32, 3>(bitcast<f32>(_e112), bitcast<f32>(_e116), bitcast<f32>(_e120));
                    if _e449 {
                    } else {
                        break;
                    }
                    let _e463 = local_16[_e448];
                    if _e453 {
                    } else {
                        break;
                    }
                    let _e465 = local_16[_e452];
                    if _e457 {
                    } else {
                        break;
                    }
                    let _e467 = local_16[_e456];
                    phi_5027_ = false;
                    phi_5018_ = _e442;
                    phi_2896_ = type_52(type_43(array<f32, 3>(_e451, _e455, _e459), array<f32, 3>(_e463, _e465, _e467)), select(0u, 2147483648u, (_e89 == 0u)));
                    phi_2899_ = ((3u * _e89) + 1u);
                    phi_2901_ = (_e444 <= _e442);
                    phi_2903_ = 0u;
                    loop {
                        let _e475 = phi_5027_;
                        let _e477 = phi_5018_;
                        let _e479 = phi_2896_;
                        let _e481 = phi_2899_;
                        let _e483 = phi_2901_;
                        let _e485 = phi_2903_;
                        if _e483 {
                            phi_2914_ = true;
                        } else {
                            phi_2914_ = (_e485 > 0u);
                        }
                        let _e488 = phi_2914_;
                        if _e488 {
                            let _e489 = (_e481 > 0u);
                            if _e489 {
                                if _e483 {
                                    phi_2960_ = _e479;
                                    phi_2961_ = _e483;
                                    phi_2962_ = _e485;
                                } else {
                                    let _e490 = (_e485 - 1u);
                                    let _e491 = (_e490 % 128u);
                                    let _e492 = (_e491 < 128u);
                                    if _e492 {
                                    } else {
                                        phi_5194_ = true;
                                        break;
                                    }
                                    let _e494 = local_6[_e491];
                                    if _e492 {
                                    } else {
                                        phi_5194_ = true;
                                        break;
                                    }
                                    let _e510 = local_5[_e491];
                                    phi_2960_ = type_52(type_43(array<f32, 3>(_e494.member.member[0], _e494.member.member[1], _e494.member.member[2]), array<f32, 3>(_e494.member.member_1[0], _e494.member.member_1[1], _e494.member.member_1[2])), _e494.member_1);
                                    phi_2961_ = (_e510 <= _e477);
                                    phi_2962_ = _e490;
                                }
                                let _e513 = phi_2960_;
                                let _e515 = phi_2961_;
                                let _e517 = phi_2962_;
                                if _e515 {
                                    if ((_e513.member_1 & 2147483648u) != 0u) {
                                        phi_5125_ = _e477;
                                        phi_5111_ = _e475;
                                        phi_2981_ = type_4(0u, ((_e513.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e838 = phi_5125_;
                                            let _e840 = phi_5111_;
                                            let _e842 = phi_2981_;
                                            if (_e842.member < _e842.member_1) {
                                                phi_2982_ = type_4((_e842.member + 1u), _e842.member_1);
                                                phi_3005_ = type_4(1u, _e842.member);
                                            } else {
                                                phi_2982_ = _e842;
                                                phi_3005_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e855 = phi_2982_;
                                            let _e857 = phi_3005_;
                                            let _e861 = (bitcast<i32>(_e857.member) != 0i);
                                            if _e861 {
                                                local_1 = array<f32, 3>(_e513.member.member[0], _e513.member.member[1], _e513.member.member[2]);
                                                local = array<f32, 3>(_e513.member.member_1[0], _e513.member.member_1[1], _e513.member.member_1[2]);
                                                let _e872 = ((_e513.member_1 & 268435455u) + _e857.member_1);
                                                let _e873 = (_e872 < arrayLength((&global_6.member)));
                                                if _e873 {
                                                    if _e873 {
                                                    } else {
                                                        phi_5278_ = _e838;
                                                        phi_5189_ = true;
                                                        break;
                                                    }
                                                    let _e876 = global_6.member[_e872].member_1;
                                                    phi_3047_ = _e876;
                                                } else {
                                                    phi_3047_ = 4294967295u;
                                                }
                                                let _e878 = phi_3047_;
                                                local_13 = array<u32, 3>(_e252, _e251, _e253);
                                                if _e873 {
                                                    if _e873 {
                                                    } else {
                                                        phi_5278_ = _e838;
                                                        phi_5189_ = true;
                                                        break;
                                                    }
                                                    let _e881 = global_6.member[_e872];
                                                    phi_3071_ = _e881;
                                                } else {
                                                    phi_3071_ = type_46(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e883 = phi_3071_;
                                                local_15 = array<u32, 3>(_e883.member[0], _e883.member[1], _e883.member[2]);
                                                local_14[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_14[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_14[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_5107_ = _e840;
                                                phi_3082_ = type_4(0u, 3u);
                                                loop {
                                                    let _e893 = phi_5107_;
                                                    let _e895 = phi_3082_;
                                                    if (_e895.member < _e895.member_1) {
                                                        phi_3083_ = type_4((_e895.member + 1u), _e895.member_1);
                                                        phi_3106_ = type_4(1u, _e895.member);
                                                    } else {
                                                        phi_3083_ = _e895;
                                                        phi_3106_ = type_4(0u, type_4().member_1);
                                                    }
                                                    let _e908 = phi_3083_;
                                                    let _e910 = phi_3106_;
                                                    let _e914 = (bitcast<i32>(_e910.member) != 0i);
                                                    if _e914 {
                                                        phi_3116_ = type_4(0u, 3u);
                                                        loop {
                                                            let _e916 = phi_3116_;
                                                            if (_e916.member < _e916.member_1) {
                                                                phi_3117_ = type_4((_e916.member + 1u), _e916.member_1);
                                                                phi_3140_ = type_4(1u, _e916.member);
                                                            } else {
                                                                phi_3117_ = _e916;
                                                                phi_3140_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e929 = phi_3117_;
                                                            let _e931 = phi_3140_;
                                                            let _e935 = (bitcast<i32>(_e931.member) != 0i);
                                                            if _e935 {
                                                                let _e936 = (_e910.member_1 < 3u);
                                                                if _e936 {
                                                                } else {
                                                                    phi_5102_ = true;
                                                                    break;
                                                                }
                                                                let _e938 = local_15[_e910.member_1];
                                                                let _e939 = (_e931.member_1 < 3u);
                                                                if _e939 {
                                                                } else {
                                                                    phi_5102_ = true;
                                                                    break;
                                                                }
                                                                let _e941 = local_13[_e931.member_1];
                                                                let _e946 = ((_e938 >> bitcast<u32>(((10u * _e941) & 31u))) & 1023u);
                                                                if _e939 {
                                                                } else {
                                                                    phi_5102_ = true;
                                                                    break;
                                                                }
                                                                let _e948 = local_1[_e931.member_1];
                                                                if _e939 {
                                                                } else {
                                                                    phi_5102_ = true;
                                                                    break;
                                                                }
                                                                let _e950 = local[_e931.member_1];
                                                                let _e961 = (_e948 + bitcast<f32>((bitcast<u32>((f32(_e946) * bitcast<f32>((bitcast<u32>(((_e950 - _e948) * 0.0009775171f)) ^ _e124)))) ^ _e124)));
                                                                if _e936 {
                                                                } else {
                                                                    phi_5102_ = true;
                                                                    break;
                                                                }
                                                                if _e939 {
                                                                } else {
                                                                    phi_5102_ = true;
                                                                    break;
                                                                }
                                                                local_14[_e910.member_1][_e931.member_1] = select(select(_e950, _e961, (_e961 < _e950)), _e950, (_e946 == 1023u));
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_3116_ = _e929;
                                                                phi_5102_ = _e893;
                                                                break if !(_e935);
                                                            }
                                                        }
                                                        let _e970 = phi_5102_;
                                                        phi_5114_ = _e970;
                                                        if _e970 {
                                                            break;
                                                        }
                                                        phi_5115_ = _e970;
                                                    } else {
                                                        phi_5115_ = _e893;
                                                    }
                                                    let _e972 = phi_5115_;
                                                    continue;
                                                    continuing {
                                                        phi_5107_ = _e972;
                                                        phi_3082_ = _e908;
                                                        phi_5114_ = _e972;
                                                        break if !(_e914);
                                                    }
                                                }
                                                let _e975 = phi_5114_;
                                                phi_5278_ = _e838;
                                                phi_5189_ = _e975;
                                                if _e975 {
                                                    break;
                                                }
                                                let _e976 = local_14;
                                                let _e991 = (_e976[0][2] - _e370);
                                                let _e994 = (((_e976[0][0] - _e293) * _e394) - (_e991 * _e318));
                                                let _e997 = (((_e976[0][1] - _e332) * _e394) - (_e991 * _e356));
                                                let _e1000 = (_e976[1][2] - _e370);
                                                let _e1003 = (((_e976[1][0] - _e293) * _e394) - (_e1000 * _e318));
                                                let _e1006 = (((_e976[1][1] - _e332) * _e394) - (_e1000 * _e356));
                                                let _e1009 = (_e976[2][2] - _e370);
                                                let _e1012 = (((_e976[2][0] - _e293) * _e394) - (_e1009 * _e318));
                                                let _e1015 = (((_e976[2][1] - _e332) * _e394) - (_e1009 * _e356));
                                                let _e1016 = (_e1012 * _e1006);
                                                let _e1017 = (_e1015 * _e1003);
                                                let _e1018 = (_e994 * _e1015);
                                                let _e1019 = (_e997 * _e1012);
                                                let _e1020 = (_e1003 * _e997);
                                                let _e1021 = (_e1006 * _e994);
                                                let _e1026 = (((_e1016 >= _e1017) && (_e1018 >= _e1019)) && (_e1020 >= _e1021));
                                                if (_e1026 || (((_e1016 <= _e1017) && (_e1018 <= _e1019)) && (_e1020 <= _e1021))) {
                                                    let _e1033 = select(-1f, 1f, _e1026);
                                                    let _e1035 = ((_e1016 - _e1017) * _e1033);
                                                    let _e1037 = select(0f, _e1035, (_e1035 > 0f));
                                                    let _e1039 = ((_e1018 - _e1019) * _e1033);
                                                    let _e1041 = select(0f, _e1039, (_e1039 > 0f));
                                                    let _e1043 = ((_e1020 - _e1021) * _e1033);
                                                    let _e1045 = select(0f, _e1043, (_e1043 > 0f));
                                                    let _e1047 = ((_e1037 + _e1041) + _e1045);
                                                    if (_e1047 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_3799_ = type_18();
                                                        phi_3800_ = true;
                                                    } else {
                                                        let _e1050 = select(_e976[1][0], _e976[0][0], (_e976[0][0] < _e976[1][0]));
                                                        let _e1054 = select(_e976[1][0], _e976[0][0], (_e976[0][0] > _e976[1][0]));
                                                        let _e1058 = select(_e976[1][1], _e976[0][1], (_e976[0][1] < _e976[1][1]));
                                                        let _e1062 = select(_e976[1][1], _e976[0][1], (_e976[0][1] > _e976[1][1]));
                                                        let _e1066 = select(_e976[1][2], _e976[0][2], (_e976[0][2] < _e976[1][2]));
                                                        let _e1070 = select(_e976[1][2], _e976[0][2], (_e976[0][2] > _e976[1][2]));
                                                        let _e1075 = ((select(_e976[2][0], _e1050, (_e1050 < _e976[2][0])) - _e316) * _e321);
                                                        let _e1076 = ((select(_e976[2][0], _e1054, (_e1054 > _e976[2][0])) - _e317) * _e321);
                                                        let _e1079 = ((select(_e976[2][1], _e1058, (_e1058 < _e976[2][1])) - _e354) * _e359);
                                                        let _e1080 = ((select(_e976[2][1], _e1062, (_e1062 > _e976[2][1])) - _e355) * _e359);
                                                        let _e1083 = ((select(_e976[2][2], _e1066, (_e1066 < _e976[2][2])) - _e392) * _e397);
                                                        let _e1084 = ((select(_e976[2][2], _e1070, (_e1070 > _e976[2][2])) - _e393) * _e397);
                                                        let _e1086 = select(_e1084, _e1083, (_e1083 < _e1084));
                                                        let _e1088 = select(_e1084, _e1083, (_e1083 > _e1084));
                                                        let _e1090 = select(_e1076, _e1075, (_e1075 < _e1076));
                                                        let _e1092 = select(_e1080, _e1079, (_e1079 < _e1080));
                                                        let _e1094 = select(_e1092, _e1090, (_e1090 > _e1092));
                                                        let _e1096 = select(_e1086, _e1094, (_e1094 > _e1086));
                                                        let _e1098 = select(_e1076, _e1075, (_e1075 > _e1076));
                                                        let _e1100 = select(_e1080, _e1079, (_e1079 > _e1080));
                                                        let _e1102 = select(_e1100, _e1098, (_e1098 < _e1100));
                                                        let _e1104 = select(_e1088, _e1102, (_e1102 < _e1088));
                                                        let _e1105 = -(_e1086);
                                                        let _e1111 = select(_e444, _e1096, (_e1096 > _e444));
                                                        if (_e1111 > (_e1104 + (select(_e1105, _e1088, (_e1088 > _e1105)) * 0.0000019073523f))) {
                                                            phi_3794_ = type_18();
                                                            phi_3795_ = true;
                                                        } else {
                                                            let _e1113 = (_e1111 > _e838);
                                                            if _e1113 {
                                                                phi_3793_ = type_18();
                                                            } else {
                                                                let _e1117 = (_e976[1][0] - _e976[0][0]);
                                                                let _e1118 = (_e976[1][1] - _e976[0][1]);
                                                                let _e1119 = (_e976[1][2] - _e976[0][2]);
                                                                let _e1120 = vec3<f32>(_e1117, _e1118, _e1119);
                                                                let _e1121 = (_e976[2][0] - _e976[1][0]);
                                                                let _e1122 = (_e976[2][1] - _e976[1][1]);
                                                                let _e1123 = (_e976[2][2] - _e976[1][2]);
                                                                let _e1124 = vec3<f32>(_e1121, _e1122, _e1123);
                                                                let _e1125 = (_e976[0][0] - _e976[2][0]);
                                                                let _e1126 = (_e976[0][1] - _e976[2][1]);
                                                                let _e1127 = (_e976[0][2] - _e976[2][2]);
                                                                let _e1128 = vec3<f32>(_e1125, _e1126, _e1127);
                                                                let _e1131 = bitcast<f32>((bitcast<u32>(_e1117) & 2147483647u));
                                                                let _e1134 = bitcast<f32>((bitcast<u32>(_e1118) & 2147483647u));
                                                                let _e1136 = select(_e1134, _e1131, (_e1131 > _e1134));
                                                                let _e1139 = bitcast<f32>((bitcast<u32>(_e1119) & 2147483647u));
                                                                let _e1141 = select(_e1139, _e1136, (_e1136 > _e1139));
                                                                let _e1144 = bitcast<f32>((bitcast<u32>(_e1121) & 2147483647u));
                                                                let _e1147 = bitcast<f32>((bitcast<u32>(_e1122) & 2147483647u));
                                                                let _e1149 = select(_e1147, _e1144, (_e1144 > _e1147));
                                                                let _e1152 = bitcast<f32>((bitcast<u32>(_e1123) & 2147483647u));
                                                                let _e1154 = select(_e1152, _e1149, (_e1149 > _e1152));
                                                                let _e1157 = bitcast<f32>((bitcast<u32>(_e1125) & 2147483647u));
                                                                let _e1160 = bitcast<f32>((bitcast<u32>(_e1126) & 2147483647u));
                                                                let _e1162 = select(_e1160, _e1157, (_e1157 > _e1160));
                                                                let _e1165 = bitcast<f32>((bitcast<u32>(_e1127) & 2147483647u));
                                                                let _e1167 = select(_e1165, _e1162, (_e1162 > _e1165));
                                                                let _e1169 = select(_e1154, _e1141, (_e1141 > _e1154));
                                                                let _e1171 = select(_e1167, _e1169, (_e1169 > _e1167));
                                                                if (_e1141 == _e1171) {
                                                                    phi_3704_ = _e1124;
                                                                    phi_3705_ = _e1128;
                                                                } else {
                                                                    let _e1174 = vec3((_e1154 == _e1171));
                                                                    phi_3704_ = select(_e1120, _e1128, _e1174);
                                                                    phi_3705_ = select(_e1124, _e1120, _e1174);
                                                                }
                                                                let _e1178 = phi_3704_;
                                                                let _e1180 = phi_3705_;
                                                                let _e1187 = ((_e1178.y * _e1180.z) - (_e1180.y * _e1178.z));
                                                                let _e1192 = ((_e1178.z * _e1180.x) - (_e1180.z * _e1178.x));
                                                                let _e1195 = ((_e1178.x * _e1180.y) - (_e1180.x * _e1178.y));
                                                                if (_e1037 >= _e1041) {
                                                                    phi_3736_ = select(true, false, (_e1037 >= _e1045));
                                                                } else {
                                                                    phi_3736_ = true;
                                                                }
                                                                let _e1200 = phi_3736_;
                                                                if _e1200 {
                                                                    phi_3745_ = select(vec3<f32>(_e976[2][0], _e976[2][1], _e976[2][2]), vec3<f32>(_e976[1][0], _e976[1][1], _e976[1][2]), vec3((_e1041 >= _e1045)));
                                                                } else {
                                                                    phi_3745_ = vec3<f32>(_e976[0][0], _e976[0][1], _e976[0][2]);
                                                                }
                                                                let _e1205 = phi_3745_;
                                                                let _e1222 = ((((_e1187 * (_e1205.x - _e293)) + (_e1192 * (_e1205.y - _e332))) + (_e1195 * (_e1205.z - _e370))) / (((_e1187 * _e318) + (_e1192 * _e356)) + (_e1195 * _e394)));
                                                                let _e1224 = select(_e1104, _e1222, (_e1222 < _e1104));
                                                                let _e1226 = select(_e1096, _e1224, (_e1224 > _e1096));
                                                                if (_e1226 >= _e444) {
                                                                    let _e1228 = (_e1226 <= _e838);
                                                                    if _e1228 {
                                                                        let _e1229 = (1f / _e1047);
                                                                        phi_3785_ = type_18(_e1226, (_e1041 * _e1229), (_e1045 * _e1229), _e878);
                                                                    } else {
                                                                        phi_3785_ = type_18();
                                                                    }
                                                                    let _e1234 = phi_3785_;
                                                                    phi_3787_ = _e1234;
                                                                    phi_3788_ = select(true, false, _e1228);
                                                                } else {
                                                                    phi_3787_ = type_18();
                                                                    phi_3788_ = true;
                                                                }
                                                                let _e1237 = phi_3787_;
                                                                let _e1239 = phi_3788_;
                                                                if _e1239 {
                                                                    phi_3792_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_3792_ = _e1237;
                                                                }
                                                                let _e1241 = phi_3792_;
                                                                phi_3793_ = _e1241;
                                                            }
                                                            let _e1243 = phi_3793_;
                                                            phi_3794_ = _e1243;
                                                            phi_3795_ = _e1113;
                                                        }
                                                        let _e1245 = phi_3794_;
                                                        let _e1247 = phi_3795_;
                                                        phi_3799_ = _e1245;
                                                        phi_3800_ = _e1247;
                                                    }
                                                    let _e1249 = phi_3799_;
                                                    let _e1251 = phi_3800_;
                                                    phi_3804_ = _e1249;
                                                    phi_3805_ = _e1251;
                                                } else {
                                                    phi_3804_ = type_18();
                                                    phi_3805_ = true;
                                                }
                                                let _e1253 = phi_3804_;
                                                let _e1255 = phi_3805_;
                                                if _e1255 {
                                                    phi_3809_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_3809_ = _e1253;
                                                }
                                                let _e1257 = phi_3809_;
                                                if (_e1257.member_3 != 4294967295u) {
                                                    if (_e878 != 4294967295u) {
                                                        phi_3821_ = type_4(0u, 8u);
                                                        phi_3824_ = _e1257;
                                                        loop {
                                                            let _e1262 = phi_3821_;
                                                            let _e1264 = phi_3824_;
                                                            if (_e1262.member < _e1262.member_1) {
                                                                phi_3822_ = type_4((_e1262.member + 1u), _e1262.member_1);
                                                                phi_3847_ = type_4(1u, _e1262.member);
                                                            } else {
                                                                phi_3822_ = _e1262;
                                                                phi_3847_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1277 = phi_3822_;
                                                            let _e1279 = phi_3847_;
                                                            let _e1283 = (bitcast<i32>(_e1279.member) != 0i);
                                                            if _e1283 {
                                                                let _e1284 = (_e1279.member_1 < 8u);
                                                                if _e1284 {
                                                                } else {
                                                                    phi_5130_ = true;
                                                                    break;
                                                                }
                                                                let _e1289 = local_4[_e1279.member_1].member;
                                                                if (_e1264.member < _e1289) {
                                                                    phi_3880_ = true;
                                                                } else {
                                                                    let _e1291 = local_4[_e1279.member_1].member;
                                                                    if (_e1264.member == _e1291) {
                                                                        let _e1296 = local_4[_e1279.member_1].member_3;
                                                                        phi_3879_ = (_e1264.member_3 < _e1296);
                                                                    } else {
                                                                        phi_3879_ = false;
                                                                    }
                                                                    let _e1299 = phi_3879_;
                                                                    phi_3880_ = _e1299;
                                                                }
                                                                let _e1301 = phi_3880_;
                                                                if _e1301 {
                                                                    if _e1284 {
                                                                    } else {
                                                                        phi_5130_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1302 = local_4[_e1279.member_1];
                                                                    local_4[_e1279.member_1] = type_18(_e1264.member, _e1264.member_1, _e1264.member_2, _e1264.member_3);
                                                                    phi_3901_ = type_18(_e1302.member, _e1302.member_1, _e1302.member_2, _e1302.member_3);
                                                                } else {
                                                                    phi_3901_ = _e1264;
                                                                }
                                                                let _e1313 = phi_3901_;
                                                                phi_3825_ = _e1313;
                                                            } else {
                                                                phi_3825_ = type_18();
                                                            }
                                                            let _e1315 = phi_3825_;
                                                            continue;
                                                            continuing {
                                                                phi_3821_ = _e1277;
                                                                phi_3824_ = _e1315;
                                                                phi_5130_ = _e975;
                                                                break if !(_e1283);
                                                            }
                                                        }
                                                        let _e1318 = phi_5130_;
                                                        phi_5278_ = _e838;
                                                        phi_5189_ = _e1318;
                                                        if _e1318 {
                                                            break;
                                                        }
                                                        let _e1321 = local_4[7u].member_3;
                                                        if (_e1321 != 4294967295u) {
                                                            let _e1325 = local_4[7u].member;
                                                            phi_5341_ = _e1325;
                                                        } else {
                                                            phi_5341_ = _e838;
                                                        }
                                                        let _e1327 = phi_5341_;
                                                        phi_5340_ = _e1327;
                                                        phi_5192_ = _e1318;
                                                    } else {
                                                        phi_5340_ = _e838;
                                                        phi_5192_ = _e975;
                                                    }
                                                    let _e1329 = phi_5340_;
                                                    let _e1331 = phi_5192_;
                                                    phi_5339_ = _e1329;
                                                    phi_5191_ = _e1331;
                                                } else {
                                                    phi_5339_ = _e838;
                                                    phi_5191_ = _e975;
                                                }
                                                let _e1333 = phi_5339_;
                                                let _e1335 = phi_5191_;
                                                phi_5338_ = _e1333;
                                                phi_5190_ = _e1335;
                                            } else {
                                                phi_5338_ = _e838;
                                                phi_5190_ = _e840;
                                            }
                                            let _e1337 = phi_5338_;
                                            let _e1339 = phi_5190_;
                                            continue;
                                            continuing {
                                                phi_5125_ = _e1337;
                                                phi_5111_ = _e1339;
                                                phi_2981_ = _e855;
                                                phi_5278_ = _e1337;
                                                phi_5189_ = _e1339;
                                                break if !(_e861);
                                            }
                                        }
                                        let _e1342 = phi_5278_;
                                        let _e1344 = phi_5189_;
                                        phi_5194_ = _e1344;
                                        if _e1344 {
                                            break;
                                        }
                                        phi_5243_ = _e1342;
                                        phi_5198_ = _e1344;
                                        phi_4757_ = _e513;
                                        phi_4758_ = false;
                                        phi_4759_ = _e517;
                                    } else {
                                        local_3 = array<f32, 3>(_e513.member.member[0], _e513.member.member[1], _e513.member.member[2]);
                                        local_2 = array<f32, 3>(_e513.member.member_1[0], _e513.member.member_1[1], _e513.member.member_1[2]);
                                        let _e537 = (_e513.member_1 < _e89);
                                        if _e537 {
                                            if _e537 {
                                            } else {
                                                phi_5194_ = true;
                                                break;
                                            }
                                            let _e539 = global_4.member[_e513.member_1];
                                            phi_3946_ = _e539;
                                        } else {
                                            phi_3946_ = type_38(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e541 = phi_3946_;
                                        let _e543 = array<u32, 3>(_e252, _e251, _e253);
                                        local_12 = _e543;
                                        local_8 = array<f32, 3>(0f, 0f, 0f);
                                        local_7 = array<f32, 3>(0f, 0f, 0f);
                                        phi_3955_ = type_4(0u, 3u);
                                        loop {
                                            let _e545 = phi_3955_;
                                            if (_e545.member < _e545.member_1) {
                                                phi_3956_ = type_4((_e545.member + 1u), _e545.member_1);
                                                phi_3979_ = type_4(1u, _e545.member);
                                            } else {
                                                phi_3956_ = _e545;
                                                phi_3979_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e558 = phi_3956_;
                                            let _e560 = phi_3979_;
                                            let _e564 = (bitcast<i32>(_e560.member) != 0i);
                                            if _e564 {
                                                let _e565 = (_e560.member_1 < 3u);
                                                if _e565 {
                                                } else {
                                                    phi_5020_ = true;
                                                    break;
                                                }
                                                let _e567 = local_12[_e560.member_1];
                                                if _e565 {
                                                } else {
                                                    phi_5020_ = true;
                                                    break;
                                                }
                                                let _e569 = local_3[_e560.member_1];
                                                if _e565 {
                                                } else {
                                                    phi_5020_ = true;
                                                    break;
                                                }
                                                let _e571 = local_2[_e560.member_1];
                                                let _e574 = ((10u * _e567) & 31u);
                                                let _e577 = ((_e541.member[0] >> bitcast<u32>(_e574)) & 1023u);
                                                let _e582 = bitcast<f32>((bitcast<u32>(((_e571 - _e569) * 0.0009775171f)) ^ _e124));
                                                let _e588 = (_e569 + bitcast<f32>((bitcast<u32>((f32(_e577) * _e582)) ^ _e124)));
                                                if _e565 {
                                                } else {
                                                    phi_5020_ = true;
                                                    break;
                                                }
                                                local_8[_e560.member_1] = select(select(_e571, _e588, (_e588 < _e571)), _e571, (_e577 == 1023u));
                                                let _e597 = ((_e541.member[1] >> bitcast<u32>(_e574)) & 1023u);
                                                let _e603 = (_e569 + bitcast<f32>((bitcast<u32>((f32(_e597) * _e582)) ^ _e124)));
                                                if _e565 {
                                                } else {
                                                    phi_5020_ = true;
                                                    break;
                                                }
                                                local_7[_e560.member_1] = select(select(_e571, _e603, (_e603 < _e571)), _e571, (_e597 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_3955_ = _e558;
                                                phi_5020_ = _e475;
                                                break if !(_e564);
                                            }
                                        }
                                        let _e611 = phi_5020_;
                                        phi_5194_ = _e611;
                                        if _e611 {
                                            break;
                                        }
                                        let _e612 = local_7;
                                        let _e613 = local_8;
                                        local_11 = _e543;
                                        local_10 = array<f32, 3>(0f, 0f, 0f);
                                        local_9 = array<f32, 3>(0f, 0f, 0f);
                                        phi_4109_ = type_4(0u, 3u);
                                        loop {
                                            let _e622 = phi_4109_;
                                            if (_e622.member < _e622.member_1) {
                                                phi_4110_ = type_4((_e622.member + 1u), _e622.member_1);
                                                phi_4133_ = type_4(1u, _e622.member);
                                            } else {
                                                phi_4110_ = _e622;
                                                phi_4133_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e635 = phi_4110_;
                                            let _e637 = phi_4133_;
                                            let _e641 = (bitcast<i32>(_e637.member) != 0i);
                                            if _e641 {
                                                let _e642 = (_e637.member_1 < 3u);
                                                if _e642 {
                                                } else {
                                                    phi_5076_ = true;
                                                    break;
                                                }
                                                let _e644 = local_11[_e637.member_1];
                                                if _e642 {
                                                } else {
                                                    phi_5076_ = true;
                                                    break;
                                                }
                                                let _e646 = local_3[_e637.member_1];
                                                if _e642 {
                                                } else {
                                                    phi_5076_ = true;
                                                    break;
                                                }
                                                let _e648 = local_2[_e637.member_1];
                                                let _e651 = ((10u * _e644) & 31u);
                                                let _e654 = ((_e541.member_1[0] >> bitcast<u32>(_e651)) & 1023u);
                                                let _e659 = bitcast<f32>((bitcast<u32>(((_e648 - _e646) * 0.0009775171f)) ^ _e124));
                                                let _e665 = (_e646 + bitcast<f32>((bitcast<u32>((f32(_e654) * _e659)) ^ _e124)));
                                                if _e642 {
                                                } else {
                                                    phi_5076_ = true;
                                                    break;
                                                }
                                                local_10[_e637.member_1] = select(select(_e648, _e665, (_e665 < _e648)), _e648, (_e654 == 1023u));
                                                let _e674 = ((_e541.member_1[1] >> bitcast<u32>(_e651)) & 1023u);
                                                let _e680 = (_e646 + bitcast<f32>((bitcast<u32>((f32(_e674) * _e659)) ^ _e124)));
                                                if _e642 {
                                                } else {
                                                    phi_5076_ = true;
                                                    break;
                                                }
                                                local_9[_e637.member_1] = select(select(_e648, _e680, (_e680 < _e648)), _e648, (_e674 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_4109_ = _e635;
                                                phi_5076_ = _e611;
                                                break if !(_e641);
                                            }
                                        }
                                        let _e688 = phi_5076_;
                                        phi_5194_ = _e688;
                                        if _e688 {
                                            break;
                                        }
                                        let _e689 = local_9;
                                        let _e690 = local_10;
                                        let _e701 = type_52(type_43(array<f32, 3>(_e613[0], _e613[1], _e613[2]), array<f32, 3>(_e612[0], _e612[1], _e612[2])), _e541.member_2);
                                        let _e706 = type_52(type_43(array<f32, 3>(_e690[0], _e690[1], _e690[2]), array<f32, 3>(_e689[0], _e689[1], _e689[2])), _e541.member_3);
                                        let _e711 = ((_e613[0] - _e316) * _e321);
                                        let _e712 = ((_e690[0] - _e316) * _e321);
                                        let _e713 = ((_e612[0] - _e317) * _e321);
                                        let _e714 = ((_e689[0] - _e317) * _e321);
                                        let _e719 = ((_e613[1] - _e354) * _e359);
                                        let _e720 = ((_e690[1] - _e354) * _e359);
                                        let _e721 = ((_e612[1] - _e355) * _e359);
                                        let _e722 = ((_e689[1] - _e355) * _e359);
                                        let _e727 = ((_e613[2] - _e392) * _e397);
                                        let _e728 = ((_e690[2] - _e392) * _e397);
                                        let _e729 = ((_e612[2] - _e393) * _e397);
                                        let _e730 = ((_e689[2] - _e393) * _e397);
                                        let _e732 = select(_e729, _e727, (_e727 < _e729));
                                        let _e734 = select(_e730, _e728, (_e728 < _e730));
                                        let _e736 = select(_e729, _e727, (_e727 > _e729));
                                        let _e738 = select(_e730, _e728, (_e728 > _e730));
                                        let _e740 = select(_e713, _e711, (_e711 < _e713));
                                        let _e742 = select(_e714, _e712, (_e712 < _e714));
                                        let _e744 = select(_e721, _e719, (_e719 < _e721));
                                        let _e746 = select(_e722, _e720, (_e720 < _e722));
                                        let _e748 = select(_e744, _e740, (_e740 > _e744));
                                        let _e750 = select(_e746, _e742, (_e742 > _e746));
                                        let _e752 = select(_e732, _e748, (_e748 > _e732));
                                        let _e754 = select(_e734, _e750, (_e750 > _e734));
                                        let _e756 = select(_e713, _e711, (_e711 > _e713));
                                        let _e758 = select(_e714, _e712, (_e712 > _e714));
                                        let _e760 = select(_e721, _e719, (_e719 > _e721));
                                        let _e762 = select(_e722, _e720, (_e720 > _e722));
                                        let _e764 = select(_e760, _e756, (_e756 < _e760));
                                        let _e766 = select(_e762, _e758, (_e758 < _e762));
                                        let _e771 = -(_e732);
                                        let _e772 = -(_e734);
                                        let _e779 = (select(_e736, _e764, (_e764 < _e736)) + (select(_e771, _e736, (_e736 > _e771)) * 0.0000019073523f));
                                        let _e780 = (select(_e738, _e766, (_e766 < _e738)) + (select(_e772, _e738, (_e738 > _e772)) * 0.0000019073523f));
                                        let _e782 = select(_e444, _e752, (_e752 > _e444));
                                        let _e784 = select(_e444, _e754, (_e754 > _e444));
                                        let _e789 = (_e782 <= select(_e477, _e779, (_e779 < _e477)));
                                        let _e790 = (_e784 <= select(_e477, _e780, (_e780 < _e477)));
                                        let _e791 = (_e782 <= _e784);
                                        if _e789 {
                                            if _e790 {
                                                if _e791 {
                                                    phi_4697_ = _e706;
                                                } else {
                                                    phi_4697_ = _e701;
                                                }
                                                let _e793 = phi_4697_;
                                                let _e794 = (_e517 % 128u);
                                                let _e795 = (_e794 < 128u);
                                                if _e795 {
                                                } else {
                                                    phi_5194_ = true;
                                                    break;
                                                }
                                                local_6[_e794] = type_52(type_43(array<f32, 3>(_e793.member.member[0], _e793.member.member[1], _e793.member.member[2]), array<f32, 3>(_e793.member.member_1[0], _e793.member.member_1[1], _e793.member.member_1[2])), _e793.member_1);
                                                if _e795 {
                                                } else {
                                                    phi_5194_ = true;
                                                    break;
                                                }
                                                local_5[_e794] = select(_e784, _e782, (_e782 > _e784));
                                                if _e791 {
                                                    phi_4736_ = _e701;
                                                } else {
                                                    phi_4736_ = _e706;
                                                }
                                                let _e816 = phi_4736_;
                                                phi_4737_ = _e816;
                                                phi_4738_ = (_e517 + 1u);
                                            } else {
                                                phi_4737_ = type_52();
                                                phi_4738_ = u32();
                                            }
                                            let _e818 = phi_4737_;
                                            let _e820 = phi_4738_;
                                            phi_4740_ = _e818;
                                            phi_4741_ = _e820;
                                            phi_4742_ = select(true, false, _e790);
                                        } else {
                                            phi_4740_ = type_52();
                                            phi_4741_ = u32();
                                            phi_4742_ = true;
                                        }
                                        let _e823 = phi_4740_;
                                        let _e825 = phi_4741_;
                                        let _e827 = phi_4742_;
                                        if _e827 {
                                            if _e789 {
                                                phi_4749_ = _e701;
                                            } else {
                                                phi_4749_ = _e706;
                                            }
                                            let _e829 = phi_4749_;
                                            phi_4754_ = _e829;
                                            phi_4755_ = select(_e790, true, _e789);
                                        } else {
                                            phi_4754_ = _e823;
                                            phi_4755_ = _e515;
                                        }
                                        let _e832 = phi_4754_;
                                        let _e834 = phi_4755_;
                                        phi_5243_ = _e477;
                                        phi_5198_ = _e688;
                                        phi_4757_ = _e832;
                                        phi_4758_ = _e834;
                                        phi_4759_ = select(_e825, _e517, _e827);
                                    }
                                    let _e1346 = phi_5243_;
                                    let _e1348 = phi_5198_;
                                    let _e1350 = phi_4757_;
                                    let _e1352 = phi_4758_;
                                    let _e1354 = phi_4759_;
                                    phi_5242_ = _e1346;
                                    phi_5197_ = _e1348;
                                    phi_4760_ = _e1350;
                                    phi_4761_ = (_e481 - 1u);
                                    phi_4762_ = _e1352;
                                    phi_4763_ = _e1354;
                                } else {
                                    phi_5242_ = _e477;
                                    phi_5197_ = _e475;
                                    phi_4760_ = _e513;
                                    phi_4761_ = _e481;
                                    phi_4762_ = _e515;
                                    phi_4763_ = _e517;
                                }
                                let _e1356 = phi_5242_;
                                let _e1358 = phi_5197_;
                                let _e1360 = phi_4760_;
                                let _e1362 = phi_4761_;
                                let _e1364 = phi_4762_;
                                let _e1366 = phi_4763_;
                                phi_5241_ = _e1356;
                                phi_5196_ = _e1358;
                                phi_4764_ = _e1360;
                                phi_4765_ = _e1362;
                                phi_4766_ = _e1364;
                                phi_4767_ = _e1366;
                            } else {
                                phi_5241_ = _e477;
                                phi_5196_ = _e475;
                                phi_4764_ = type_52();
                                phi_4765_ = u32();
                                phi_4766_ = bool();
                                phi_4767_ = u32();
                            }
                            let _e1368 = phi_5241_;
                            let _e1370 = phi_5196_;
                            let _e1372 = phi_4764_;
                            let _e1374 = phi_4765_;
                            let _e1376 = phi_4766_;
                            let _e1378 = phi_4767_;
                            phi_5240_ = _e1368;
                            phi_5195_ = _e1370;
                            phi_2897_ = _e1372;
                            phi_2900_ = _e1374;
                            phi_2902_ = _e1376;
                            phi_2904_ = _e1378;
                            phi_4768_ = _e489;
                        } else {
                            phi_5240_ = _e477;
                            phi_5195_ = _e475;
                            phi_2897_ = type_52();
                            phi_2900_ = u32();
                            phi_2902_ = bool();
                            phi_2904_ = u32();
                            phi_4768_ = false;
                        }
                        let _e1380 = phi_5240_;
                        let _e1382 = phi_5195_;
                        let _e1384 = phi_2897_;
                        let _e1386 = phi_2900_;
                        let _e1388 = phi_2902_;
                        let _e1390 = phi_2904_;
                        let _e1392 = phi_4768_;
                        continue;
                        continuing {
                            phi_5027_ = _e1382;
                            phi_5018_ = _e1380;
                            phi_2896_ = _e1384;
                            phi_2899_ = _e1386;
                            phi_2901_ = _e1388;
                            phi_2903_ = _e1390;
                            phi_5194_ = _e1382;
                            break if !(_e1392);
                        }
                    }
                    let _e1395 = phi_5194_;
                    if _e1395 {
                        break;
                    }
                    phi_4775_ = type_4(0u, 8u);
                    loop {
                        let _e1397 = phi_4775_;
                        if (_e1397.member < _e1397.member_1) {
                            phi_4776_ = type_4((_e1397.member + 1u), _e1397.member_1);
                            phi_4799_ = type_4(1u, _e1397.member);
                        } else {
                            phi_4776_ = _e1397;
                            phi_4799_ = type_4(0u, type_4().member_1);
                        }
                        let _e1410 = phi_4776_;
                        let _e1412 = phi_4799_;
                        let _e1416 = (bitcast<i32>(_e1412.member) != 0i);
                        if _e1416 {
                            let _e1417 = (_e1412.member_1 < 8u);
                            if _e1417 {
                            } else {
                                phi_5233_ = true;
                                break;
                            }
                            let _e1419 = local_4[_e1412.member_1];
                            if (_e1419.member_3 != 4294967295u) {
                                let _e1425 = -(_e411);
                                let _e1426 = (_e1425 / 3i);
                                let _e1433 = bitcast<f32>((bitcast<u32>((_e1426 + 127i)) << bitcast<u32>(23i)));
                                let _e1441 = (((_e1419.member * _e1433) * _e1433) * bitcast<f32>((bitcast<u32>(((_e1425 - (2i * _e1426)) + 127i)) << bitcast<u32>(23i))));
                                let _e1443 = select(340282350000000000000000000000000000000f, _e1441, (_e1441 < 340282350000000000000000000000000000000f));
                                phi_4865_ = type_18(select(-340282350000000000000000000000000000000f, _e1443, (_e1443 > -340282350000000000000000000000000000000f)), _e1419.member_1, _e1419.member_2, _e1419.member_3);
                            } else {
                                phi_4865_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1448 = phi_4865_;
                            if _e1417 {
                            } else {
                                phi_5233_ = true;
                                break;
                            }
                            local_4[_e1412.member_1] = type_18(_e1448.member, _e1448.member_1, _e1448.member_2, _e1448.member_3);
                        }
                        continue;
                        continuing {
                            phi_4775_ = _e1410;
                            phi_5233_ = _e1395;
                            break if !(_e1416);
                        }
                    }
                    let _e1456 = phi_5233_;
                    if _e1456 {
                        break;
                    }
                    let _e1457 = local_4;
                    if _e140 {
                    } else {
                        break;
                    }
                    global_5.member[_e138] = array<type_18, 8>(type_18(_e1457[0].member, _e1457[0].member_1, _e1457[0].member_2, _e1457[0].member_3), type_18(_e1457[1].member, _e1457[1].member_1, _e1457[1].member_2, _e1457[1].member_3), type_18(_e1457[2].member, _e1457[2].member_1, _e1457[2].member_2, _e1457[2].member_3), type_18(_e1457[3].member, _e1457[3].member_1, _e1457[3].member_2, _e1457[3].member_3), type_18(_e1457[4].member, _e1457[4].member_1, _e1457[4].member_2, _e1457[4].member_3), type_18(_e1457[5].member, _e1457[5].member_1, _e1457[5].member_2, _e1457[5].member_3), type_18(_e1457[6].member, _e1457[6].member_1, _e1457[6].member_2, _e1457[6].member_3), type_18(_e1457[7].member, _e1457[7].member_1, _e1457[7].member_2, _e1457[7].member_3));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_nearest_printed_leaf10_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
