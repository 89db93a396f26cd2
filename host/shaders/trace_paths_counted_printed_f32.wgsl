struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_14 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_16 {
    member: array<type_14>,
}

struct type_23 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_25 {
    member: array<type_23>,
}

struct type_27 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_28 {
    member: type_27,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_30 {
    member: array<type_28>,
}

struct type_37 {
    member: type_23,
    member_1: f32,
}

struct type_40 {
    member: type_37,
    member_1: u32,
    member_2: u32,
}

struct type_42 {
    member: array<vec4<u32>, 2>,
}

struct type_44 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_46 {
    member: array<type_44>,
}

struct type_50 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_53 {
    member: type_50,
    member_1: u32,
}

struct type_60 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(2) 
var<storage> global_1: type_16;
@group(0) @binding(4) 
var<storage, read_write> global_2: type_25;
@group(0) @binding(0) 
var<uniform> global_3: type_42;
@group(0) @binding(3) 
var<storage> global_4: type_30;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_6: type_60;
@group(0) @binding(1) 
var<storage> global_7: type_46;

fn function_() {
    var local: array<f32, 3>;
    var local_1: array<f32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<type_53, 128>;
    var local_4: array<f32, 3>;
    var local_5: array<f32, 3>;
    var local_6: array<f32, 3>;
    var local_7: array<f32, 3>;
    var local_8: array<u32, 3>;
    var local_9: array<u32, 3>;
    var local_10: array<f32, 3>;
    var local_11: array<f32, 3>;
    var phi_346_: i32;
    var phi_347_: i32;
    var phi_357_: bool;
    var phi_367_: u32;
    var phi_368_: u32;
    var phi_370_: bool;
    var phi_375_: u32;
    var phi_408_: i32;
    var phi_426_: f32;
    var phi_432_: f32;
    var phi_443_: f32;
    var phi_449_: f32;
    var phi_472_: f32;
    var phi_483_: f32;
    var phi_492_: f32;
    var phi_498_: f32;
    var phi_509_: f32;
    var phi_515_: f32;
    var phi_538_: f32;
    var phi_549_: f32;
    var phi_558_: f32;
    var phi_564_: f32;
    var phi_575_: f32;
    var phi_581_: f32;
    var phi_604_: f32;
    var phi_615_: f32;
    var phi_715_: f32;
    var phi_716_: f32;
    var phi_4783_: bool;
    var phi_2853_: type_40;
    var phi_2856_: type_53;
    var phi_2858_: u32;
    var phi_2860_: bool;
    var phi_2862_: u32;
    var phi_2873_: bool;
    var phi_2918_: type_53;
    var phi_2919_: bool;
    var phi_2920_: u32;
    var phi_3725_: type_44;
    var phi_3734_: type_7;
    var phi_3735_: type_7;
    var phi_3758_: type_7;
    var phi_4776_: bool;
    var phi_3888_: type_7;
    var phi_3889_: type_7;
    var phi_3912_: type_7;
    var phi_4836_: bool;
    var phi_4475_: type_53;
    var phi_4514_: type_53;
    var phi_4515_: type_53;
    var phi_4516_: u32;
    var phi_4518_: type_53;
    var phi_4519_: u32;
    var phi_4520_: bool;
    var phi_4527_: type_53;
    var phi_4532_: type_53;
    var phi_4533_: bool;
    var phi_2938_: type_40;
    var phi_2941_: type_7;
    var phi_2942_: type_7;
    var phi_2964_: type_7;
    var phi_2988_: u32;
    var phi_3077_: array<array<f32, 3>, 3>;
    var phi_3548_: vec3<f32>;
    var phi_3549_: vec3<f32>;
    var phi_3580_: bool;
    var phi_3589_: vec3<f32>;
    var phi_3629_: type_23;
    var phi_3631_: type_23;
    var phi_3632_: bool;
    var phi_3636_: type_23;
    var phi_3637_: type_23;
    var phi_3638_: type_23;
    var phi_3639_: bool;
    var phi_3643_: type_23;
    var phi_3644_: bool;
    var phi_3648_: type_23;
    var phi_3649_: bool;
    var phi_3653_: type_23;
    var phi_3678_: bool;
    var phi_3679_: bool;
    var phi_3686_: type_40;
    var phi_3687_: type_40;
    var phi_3688_: type_40;
    var phi_2939_: type_40;
    var phi_4844_: bool;
    var phi_4911_: bool;
    var phi_4535_: type_40;
    var phi_4536_: type_53;
    var phi_4537_: bool;
    var phi_4538_: u32;
    var phi_4910_: bool;
    var phi_4539_: type_40;
    var phi_4540_: type_53;
    var phi_4541_: u32;
    var phi_4542_: bool;
    var phi_4543_: u32;
    var phi_4909_: bool;
    var phi_4544_: type_40;
    var phi_4545_: type_53;
    var phi_4546_: u32;
    var phi_4547_: bool;
    var phi_4548_: u32;
    var phi_4908_: bool;
    var phi_2854_: type_40;
    var phi_2857_: type_53;
    var phi_2859_: u32;
    var phi_2861_: bool;
    var phi_2863_: u32;
    var phi_4549_: bool;
    var phi_4907_: bool;
    var local_12: type_40;
    var phi_4601_: type_23;
    var local_13: type_40;
    var local_14: type_40;

    switch bitcast<i32>(0u) {
        default: {
            let _e83 = global;
            let _e86 = arrayLength((&global_7.member));
            let _e88 = arrayLength((&global_1.member));
            let _e96 = arrayLength((&global_6.member));
            let _e100 = global_3.member[0u][0u];
            let _e104 = global_3.member[0u][1u];
            let _e108 = global_3.member[0u][2u];
            let _e112 = global_3.member[1u][0u];
            let _e116 = global_3.member[1u][1u];
            let _e120 = global_3.member[1u][2u];
            let _e124 = global_3.member[1u][3u];
            let _e128 = (_e83.x + (_e83.y * 2097152u));
            let _e135 = (_e128 < arrayLength((&global_4.member)));
            if _e135 {
                let _e136 = (_e128 < arrayLength((&global_2.member)));
                if _e136 {
                    let _e137 = (_e128 < arrayLength((&global_5.member)));
                    if _e137 {
                        if _e135 {
                        } else {
                            break;
                        }
                        let _e147 = global_4.member[_e128].member.member_2[0u];
                        let _e149 = (bitcast<u32>(_e147) & 2147483647u);
                        let _e155 = global_4.member[_e128].member.member_2[1u];
                        let _e157 = (bitcast<u32>(_e155) & 2147483647u);
                        let _e163 = global_4.member[_e128].member.member_2[2u];
                        let _e165 = (bitcast<u32>(_e163) & 2147483647u);
                        let _e171 = global_4.member[_e128].member.member[0u];
                        let _e173 = (bitcast<u32>(_e171) & 2147483647u);
                        let _e179 = global_4.member[_e128].member.member[1u];
                        let _e181 = (bitcast<u32>(_e179) & 2147483647u);
                        let _e187 = global_4.member[_e128].member.member[2u];
                        let _e189 = (bitcast<u32>(_e187) & 2147483647u);
                        let _e191 = select(_e157, _e149, (_e157 < _e149));
                        let _e193 = select(_e165, _e191, (_e165 < _e191));
                        let _e195 = select(_e173, _e193, (_e173 < _e193));
                        let _e197 = select(_e181, _e195, (_e181 < _e195));
                        let _e199 = select(_e189, _e197, (_e189 < _e197));
                        let _e204 = global_4.member[_e128].member.member_1;
                        let _e206 = (bitcast<u32>(_e204) & 2147483647u);
                        let _e214 = global_4.member[_e128].member.member_3;
                        let _e220 = (((select(_e206, _e199, (_e206 < _e199)) < 2139095040u) && ((bitcast<u32>(_e214) & 2147483647u) <= 2139095040u)) && (_e193 > 0u));
                        if _e220 {
                            let _e223 = (bitcast<u32>(bitcast<f32>(_e193)) & 2147483647u);
                            if (_e223 >= 8388608u) {
                                phi_346_ = (bitcast<i32>((_e223 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_346_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e223)), 32u, (_e223 == 0u))));
                            }
                            let _e237 = phi_346_;
                            phi_347_ = _e237;
                        } else {
                            phi_347_ = 0i;
                        }
                        let _e239 = phi_347_;
                        let _e240 = (_e149 == _e193);
                        if _e240 {
                            phi_357_ = true;
                        } else {
                            phi_357_ = (_e157 == _e193);
                        }
                        let _e243 = phi_357_;
                        let _e244 = select(1u, 0u, _e240);
                        if _e243 {
                            let _e245 = (_e244 + 1u);
                            phi_367_ = _e245;
                            phi_368_ = _e245;
                            phi_370_ = select(true, false, (_e245 == 2u));
                        } else {
                            phi_367_ = u32();
                            phi_368_ = 0u;
                            phi_370_ = true;
                        }
                        let _e249 = phi_367_;
                        let _e251 = phi_368_;
                        let _e253 = phi_370_;
                        if _e253 {
                            phi_375_ = (_e251 + 1u);
                        } else {
                            phi_375_ = 0u;
                        }
                        let _e257 = phi_375_;
                        let _e258 = select(_e249, _e251, _e253);
                        let _e259 = select(_e244, select(2u, _e244, _e243), _e253);
                        let _e260 = -(_e239);
                        if (_e260 < -126i) {
                            phi_408_ = -126i;
                        } else {
                            phi_408_ = select(_e260, 127i, (_e260 > 127i));
                        }
                        let _e265 = phi_408_;
                        let _e270 = bitcast<f32>((bitcast<u32>((_e265 + 127i)) << bitcast<u32>(23i)));
                        let _e276 = bitcast<f32>((bitcast<u32>(((_e260 - _e265) + 127i)) << bitcast<u32>(23i)));
                        let _e281 = global_4.member[_e128].member.member;
                        let _e282 = (_e258 == 0u);
                        if _e282 {
                            phi_426_ = _e281[0];
                        } else {
                            phi_426_ = _e281[1];
                        }
                        let _e286 = phi_426_;
                        let _e287 = (_e258 == 2u);
                        if _e287 {
                            phi_432_ = _e281[2];
                        } else {
                            phi_432_ = _e286;
                        }
                        let _e290 = phi_432_;
                        let _e291 = global_4.member[_e128].member.member_2;
                        if _e282 {
                            phi_443_ = _e291[0];
                        } else {
                            phi_443_ = _e291[1];
                        }
                        let _e295 = phi_443_;
                        if _e287 {
                            phi_449_ = _e291[2];
                        } else {
                            phi_449_ = _e295;
                        }
                        let _e298 = phi_449_;
                        let _e300 = ((_e298 * _e270) * _e276);
                        let _e304 = (bitcast<f32>((bitcast<u32>(_e300) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e304 {
                            let _e308 = (bitcast<f32>((bitcast<u32>(_e290) & 2147483647u)) * 0.00000011920929f);
                            phi_472_ = select(0.00000000000011368684f, _e308, (_e308 > 0.00000000000011368684f));
                        } else {
                            phi_472_ = 0f;
                        }
                        let _e312 = phi_472_;
                        let _e313 = (_e290 + _e312);
                        let _e314 = (_e290 - _e312);
                        let _e315 = select(_e300, 0f, _e304);
                        if _e304 {
                            phi_483_ = 38685626000000000000000000f;
                        } else {
                            phi_483_ = (1f / _e300);
                        }
                        let _e318 = phi_483_;
                        let _e319 = (_e257 == 0u);
                        if _e319 {
                            phi_492_ = _e281[0];
                        } else {
                            phi_492_ = _e281[1];
                        }
                        let _e323 = phi_492_;
                        let _e324 = (_e257 == 2u);
                        if _e324 {
                            phi_498_ = _e281[2];
                        } else {
                            phi_498_ = _e323;
                        }
                        let _e327 = phi_498_;
                        if _e319 {
                            phi_509_ = _e291[0];
                        } else {
                            phi_509_ = _e291[1];
                        }
                        let _e331 = phi_509_;
                        if _e324 {
                            phi_515_ = _e291[2];
                        } else {
                            phi_515_ = _e331;
                        }
                        let _e334 = phi_515_;
                        let _e336 = ((_e334 * _e270) * _e276);
                        let _e340 = (bitcast<f32>((bitcast<u32>(_e336) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e340 {
                            let _e344 = (bitcast<f32>((bitcast<u32>(_e327) & 2147483647u)) * 0.00000011920929f);
                            phi_538_ = select(0.00000000000011368684f, _e344, (_e344 > 0.00000000000011368684f));
                        } else {
                            phi_538_ = 0f;
                        }
                        let _e348 = phi_538_;
                        let _e349 = (_e327 + _e348);
                        let _e350 = (_e327 - _e348);
                        let _e351 = select(_e336, 0f, _e340);
                        if _e340 {
                            phi_549_ = 38685626000000000000000000f;
                        } else {
                            phi_549_ = (1f / _e336);
                        }
                        let _e354 = phi_549_;
                        let _e355 = (_e259 == 0u);
                        if _e355 {
                            phi_558_ = _e281[0];
                        } else {
                            phi_558_ = _e281[1];
                        }
                        let _e359 = phi_558_;
                        let _e360 = (_e259 == 2u);
                        if _e360 {
                            phi_564_ = _e281[2];
                        } else {
                            phi_564_ = _e359;
                        }
                        let _e363 = phi_564_;
                        if _e355 {
                            phi_575_ = _e291[0];
                        } else {
                            phi_575_ = _e291[1];
                        }
                        let _e367 = phi_575_;
                        if _e360 {
                            phi_581_ = _e291[2];
                        } else {
                            phi_581_ = _e367;
                        }
                        let _e370 = phi_581_;
                        let _e372 = ((_e370 * _e270) * _e276);
                        let _e376 = (bitcast<f32>((bitcast<u32>(_e372) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e376 {
                            let _e380 = (bitcast<f32>((bitcast<u32>(_e363) & 2147483647u)) * 0.00000011920929f);
                            phi_604_ = select(0.00000000000011368684f, _e380, (_e380 > 0.00000000000011368684f));
                        } else {
                            phi_604_ = 0f;
                        }
                        let _e384 = phi_604_;
                        let _e385 = (_e363 + _e384);
                        let _e386 = (_e363 - _e384);
                        let _e387 = select(_e372, 0f, _e376);
                        if _e376 {
                            phi_615_ = 38685626000000000000000000f;
                        } else {
                            phi_615_ = (1f / _e372);
                        }
                        let _e390 = phi_615_;
                        let _e393 = bitcast<f32>((bitcast<u32>(_e290) & 2147483647u));
                        let _e396 = bitcast<f32>((bitcast<u32>(_e327) & 2147483647u));
                        let _e398 = select(_e396, _e393, (_e393 > _e396));
                        let _e401 = bitcast<f32>((bitcast<u32>(_e363) & 2147483647u));
                        if (_e220 && (select(_e401, _e398, (_e398 > _e401)) <= 1099511600000f)) {
                            let _e406 = (_e239 / 3i);
                            let _e413 = bitcast<f32>((bitcast<u32>((_e406 + 127i)) << bitcast<u32>(23i)));
                            let _e420 = bitcast<f32>((bitcast<u32>(((_e239 - (2i * _e406)) + 127i)) << bitcast<u32>(23i)));
                            let _e421 = (((_e204 * _e413) * _e413) * _e420);
                            let _e423 = select(340282350000000000000000000000000000000f, _e421, (_e421 < 340282350000000000000000000000000000000f));
                            let _e428 = (((_e214 * _e413) * _e413) * _e420);
                            let _e430 = select(340282350000000000000000000000000000000f, _e428, (_e428 < 340282350000000000000000000000000000000f));
                            phi_715_ = select(-340282350000000000000000000000000000000f, _e430, (_e430 > -340282350000000000000000000000000000000f));
                            phi_716_ = select(-340282350000000000000000000000000000000f, _e423, (_e423 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_715_ = 0f;
                            phi_716_ = 1f;
                        }
                        let _e434 = phi_715_;
                        let _e436 = phi_716_;
                        if _e135 {
                        } else {
                            break;
                        }
                        let _e442 = global_4.member[_e128].member_2;
                        local_3 = array<type_53, 128>(type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_53(type_50(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u));
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_11 = array<f32, 3>(bitcast<f32>(_e100), bitcast<f32>(_e104), bitcast<f32>(_e108));
                        let _e446 = (_e258 % 3u);
                        let _e447 = (_e446 < 3u);
                        if _e447 {
                        } else {
                            break;
                        }
                        let _e449 = local_11[_e446];
                        let _e450 = (_e257 % 3u);
                        let _e451 = (_e450 < 3u);
                        if _e451 {
                        } else {
                            break;
                        }
                        let _e453 = local_11[_e450];
                        let _e454 = (_e259 % 3u);
                        let _e455 = (_e454 < 3u);
                        if _e455 {
                        } else {
                            break;
                        }
                        let _e457 = local_11[_e454];
                        local_10 = array<f32, 3>(bitcast<f32>(_e112), bitcast<f32>(_e116), bitcast<f32>(_e120));
                        if _e447 {
                        } else {
                            break;
                        }
                        let _e461 = local_10[_e446];
                        if _e451 {
                        } else {
                            break;
                        }
                        let _e463 = local_10[_e450];
                        if _e455 {
                        } else {
                            break;
                        }
                        let _e465 = local_10[_e454];
                        phi_4783_ = false;
                        phi_2853_ = type_40(type_37(type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e434), 0u, 0u);
                        phi_2856_ = type_53(type_50(array<f32, 3>(_e449, _e453, _e457), array<f32, 3>(_e461, _e463, _e465)), select(0u, 2147483648u, (_e86 == 0u)));
                        phi_2858_ = ((3u * _e86) + 1u);
                        phi_2860_ = (_e436 <= _e434);
                        phi_2862_ = 0u;
                        loop {
                            let _e473 = phi_4783_;
                            let _e475 = phi_2853_;
                            let _e477 = phi_2856_;
                            let _e479 = phi_2858_;
                            let _e481 = phi_2860_;
                            let _e483 = phi_2862_;
                            local_12 = _e475;
                            local_13 = _e475;
                            if _e481 {
                                phi_2873_ = true;
                            } else {
                                phi_2873_ = (_e483 > 0u);
                            }
                            let _e486 = phi_2873_;
                            if _e486 {
                                let _e487 = (_e479 > 0u);
                                if _e487 {
                                    if _e481 {
                                        phi_2918_ = _e477;
                                        phi_2919_ = _e481;
                                        phi_2920_ = _e483;
                                    } else {
                                        let _e488 = (_e483 - 1u);
                                        let _e489 = (_e488 % 128u);
                                        let _e490 = (_e489 < 128u);
                                        if _e490 {
                                        } else {
                                            phi_4907_ = true;
                                            break;
                                        }
                                        let _e492 = local_3[_e489];
                                        if _e490 {
                                        } else {
                                            phi_4907_ = true;
                                            break;
                                        }
                                        let _e508 = local_2[_e489];
                                        phi_2918_ = type_53(type_50(array<f32, 3>(_e492.member.member[0], _e492.member.member[1], _e492.member.member[2]), array<f32, 3>(_e492.member.member_1[0], _e492.member.member_1[1], _e492.member.member_1[2])), _e492.member_1);
                                        phi_2919_ = (_e508 <= _e475.member.member_1);
                                        phi_2920_ = _e488;
                                    }
                                    let _e513 = phi_2918_;
                                    let _e515 = phi_2919_;
                                    let _e517 = phi_2920_;
                                    if _e515 {
                                        if ((_e513.member_1 & 2147483648u) != 0u) {
                                            phi_2938_ = _e475;
                                            phi_2941_ = type_7(0u, ((_e513.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e846 = phi_2938_;
                                                let _e848 = phi_2941_;
                                                local_14 = _e846;
                                                if (_e848.member < _e848.member_1) {
                                                    phi_2942_ = type_7((_e848.member + 1u), _e848.member_1);
                                                    phi_2964_ = type_7(1u, _e848.member);
                                                } else {
                                                    phi_2942_ = _e848;
                                                    phi_2964_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e861 = phi_2942_;
                                                let _e863 = phi_2964_;
                                                let _e867 = (bitcast<i32>(_e863.member) != 0i);
                                                if _e867 {
                                                    let _e873 = type_40(_e846.member, _e846.member_1, (_e846.member_2 + 1u));
                                                    let _e874 = ((_e513.member_1 & 268435455u) + _e863.member_1);
                                                    let _e875 = (_e874 < _e88);
                                                    if _e875 {
                                                        if _e875 {
                                                        } else {
                                                            phi_4844_ = true;
                                                            break;
                                                        }
                                                        let _e879 = global_1.member[_e874].member_1;
                                                        phi_2988_ = _e879;
                                                    } else {
                                                        phi_2988_ = 4294967295u;
                                                    }
                                                    let _e881 = phi_2988_;
                                                    if (_e874 >= _e88) {
                                                        phi_3077_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e875 {
                                                        } else {
                                                            phi_4844_ = true;
                                                            break;
                                                        }
                                                        if (_e446 < 9u) {
                                                        } else {
                                                            phi_4844_ = true;
                                                            break;
                                                        }
                                                        let _e888 = global_1.member[_e874].member[_e446];
                                                        if (_e450 < 9u) {
                                                        } else {
                                                            phi_4844_ = true;
                                                            break;
                                                        }
                                                        let _e894 = global_1.member[_e874].member[_e450];
                                                        if (_e454 < 9u) {
                                                        } else {
                                                            phi_4844_ = true;
                                                            break;
                                                        }
                                                        let _e900 = global_1.member[_e874].member[_e454];
                                                        let _e902 = (3u + _e446);
                                                        if (_e902 < 9u) {
                                                        } else {
                                                            phi_4844_ = true;
                                                            break;
                                                        }
                                                        let _e908 = global_1.member[_e874].member[_e902];
                                                        let _e909 = (3u + _e450);
                                                        if (_e909 < 9u) {
                                                        } else {
                                                            phi_4844_ = true;
                                                            break;
                                                        }
                                                        let _e915 = global_1.member[_e874].member[_e909];
                                                        let _e916 = (3u + _e454);
                                                        if (_e916 < 9u) {
                                                        } else {
                                                            phi_4844_ = true;
                                                            break;
                                                        }
                                                        let _e922 = global_1.member[_e874].member[_e916];
                                                        let _e924 = (6u + _e446);
                                                        if (_e924 < 9u) {
                                                        } else {
                                                            phi_4844_ = true;
                                                            break;
                                                        }
                                                        let _e930 = global_1.member[_e874].member[_e924];
                                                        let _e931 = (6u + _e450);
                                                        if (_e931 < 9u) {
                                                        } else {
                                                            phi_4844_ = true;
                                                            break;
                                                        }
                                                        let _e937 = global_1.member[_e874].member[_e931];
                                                        let _e938 = (6u + _e454);
                                                        if (_e938 < 9u) {
                                                        } else {
                                                            phi_4844_ = true;
                                                            break;
                                                        }
                                                        let _e944 = global_1.member[_e874].member[_e938];
                                                        phi_3077_ = array<array<f32, 3>, 3>(array<f32, 3>(_e888, _e894, _e900), array<f32, 3>(_e908, _e915, _e922), array<f32, 3>(_e930, _e937, _e944));
                                                    }
                                                    let _e948 = phi_3077_;
                                                    let _e957 = (_e948[0][2] - _e363);
                                                    let _e960 = (((_e948[0][0] - _e290) * _e387) - (_e957 * _e315));
                                                    let _e963 = (((_e948[0][1] - _e327) * _e387) - (_e957 * _e351));
                                                    let _e970 = (_e948[1][2] - _e363);
                                                    let _e973 = (((_e948[1][0] - _e290) * _e387) - (_e970 * _e315));
                                                    let _e976 = (((_e948[1][1] - _e327) * _e387) - (_e970 * _e351));
                                                    let _e983 = (_e948[2][2] - _e363);
                                                    let _e986 = (((_e948[2][0] - _e290) * _e387) - (_e983 * _e315));
                                                    let _e989 = (((_e948[2][1] - _e327) * _e387) - (_e983 * _e351));
                                                    let _e990 = (_e986 * _e976);
                                                    let _e991 = (_e989 * _e973);
                                                    let _e992 = (_e960 * _e989);
                                                    let _e993 = (_e963 * _e986);
                                                    let _e994 = (_e973 * _e963);
                                                    let _e995 = (_e976 * _e960);
                                                    let _e1000 = (((_e990 >= _e991) && (_e992 >= _e993)) && (_e994 >= _e995));
                                                    if (_e1000 || (((_e990 <= _e991) && (_e992 <= _e993)) && (_e994 <= _e995))) {
                                                        let _e1007 = select(-1f, 1f, _e1000);
                                                        let _e1009 = ((_e990 - _e991) * _e1007);
                                                        let _e1011 = select(0f, _e1009, (_e1009 > 0f));
                                                        let _e1013 = ((_e992 - _e993) * _e1007);
                                                        let _e1015 = select(0f, _e1013, (_e1013 > 0f));
                                                        let _e1017 = ((_e994 - _e995) * _e1007);
                                                        let _e1019 = select(0f, _e1017, (_e1017 > 0f));
                                                        let _e1021 = ((_e1011 + _e1015) + _e1019);
                                                        if (_e1021 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_3643_ = type_23();
                                                            phi_3644_ = true;
                                                        } else {
                                                            let _e1024 = select(_e948[1][0], _e948[0][0], (_e948[0][0] < _e948[1][0]));
                                                            let _e1028 = select(_e948[1][0], _e948[0][0], (_e948[0][0] > _e948[1][0]));
                                                            let _e1032 = select(_e948[1][1], _e948[0][1], (_e948[0][1] < _e948[1][1]));
                                                            let _e1036 = select(_e948[1][1], _e948[0][1], (_e948[0][1] > _e948[1][1]));
                                                            let _e1040 = select(_e948[1][2], _e948[0][2], (_e948[0][2] < _e948[1][2]));
                                                            let _e1044 = select(_e948[1][2], _e948[0][2], (_e948[0][2] > _e948[1][2]));
                                                            let _e1049 = ((select(_e948[2][0], _e1024, (_e1024 < _e948[2][0])) - _e313) * _e318);
                                                            let _e1050 = ((select(_e948[2][0], _e1028, (_e1028 > _e948[2][0])) - _e314) * _e318);
                                                            let _e1053 = ((select(_e948[2][1], _e1032, (_e1032 < _e948[2][1])) - _e349) * _e354);
                                                            let _e1054 = ((select(_e948[2][1], _e1036, (_e1036 > _e948[2][1])) - _e350) * _e354);
                                                            let _e1057 = ((select(_e948[2][2], _e1040, (_e1040 < _e948[2][2])) - _e385) * _e390);
                                                            let _e1058 = ((select(_e948[2][2], _e1044, (_e1044 > _e948[2][2])) - _e386) * _e390);
                                                            let _e1060 = select(_e1058, _e1057, (_e1057 < _e1058));
                                                            let _e1062 = select(_e1058, _e1057, (_e1057 > _e1058));
                                                            let _e1064 = select(_e1050, _e1049, (_e1049 < _e1050));
                                                            let _e1066 = select(_e1054, _e1053, (_e1053 < _e1054));
                                                            let _e1068 = select(_e1066, _e1064, (_e1064 > _e1066));
                                                            let _e1070 = select(_e1060, _e1068, (_e1068 > _e1060));
                                                            let _e1072 = select(_e1050, _e1049, (_e1049 > _e1050));
                                                            let _e1074 = select(_e1054, _e1053, (_e1053 > _e1054));
                                                            let _e1076 = select(_e1074, _e1072, (_e1072 < _e1074));
                                                            let _e1078 = select(_e1062, _e1076, (_e1076 < _e1062));
                                                            let _e1079 = -(_e1060);
                                                            let _e1085 = select(_e436, _e1070, (_e1070 > _e436));
                                                            if (_e1085 > (_e1078 + (select(_e1079, _e1062, (_e1062 > _e1079)) * 0.0000019073523f))) {
                                                                phi_3638_ = type_23();
                                                                phi_3639_ = true;
                                                            } else {
                                                                let _e1087 = (_e1085 > _e846.member.member_1);
                                                                if _e1087 {
                                                                    phi_3637_ = type_23();
                                                                } else {
                                                                    let _e1091 = (_e948[1][0] - _e948[0][0]);
                                                                    let _e1092 = (_e948[1][1] - _e948[0][1]);
                                                                    let _e1093 = (_e948[1][2] - _e948[0][2]);
                                                                    let _e1094 = vec3<f32>(_e1091, _e1092, _e1093);
                                                                    let _e1095 = (_e948[2][0] - _e948[1][0]);
                                                                    let _e1096 = (_e948[2][1] - _e948[1][1]);
                                                                    let _e1097 = (_e948[2][2] - _e948[1][2]);
                                                                    let _e1098 = vec3<f32>(_e1095, _e1096, _e1097);
                                                                    let _e1099 = (_e948[0][0] - _e948[2][0]);
                                                                    let _e1100 = (_e948[0][1] - _e948[2][1]);
                                                                    let _e1101 = (_e948[0][2] - _e948[2][2]);
                                                                    let _e1102 = vec3<f32>(_e1099, _e1100, _e1101);
                                                                    let _e1105 = bitcast<f32>((bitcast<u32>(_e1091) & 2147483647u));
                                                                    let _e1108 = bitcast<f32>((bitcast<u32>(_e1092) & 2147483647u));
                                                                    let _e1110 = select(_e1108, _e1105, (_e1105 > _e1108));
                                                                    let _e1113 = bitcast<f32>((bitcast<u32>(_e1093) & 2147483647u));
                                                                    let _e1115 = select(_e1113, _e1110, (_e1110 > _e1113));
                                                                    let _e1118 = bitcast<f32>((bitcast<u32>(_e1095) & 2147483647u));
                                                                    let _e1121 = bitcast<f32>((bitcast<u32>(_e1096) & 2147483647u));
                                                                    let _e1123 = select(_e1121, _e1118, (_e1118 > _e1121));
                                                                    let _e1126 = bitcast<f32>((bitcast<u32>(_e1097) & 2147483647u));
                                                                    let _e1128 = select(_e1126, _e1123, (_e1123 > _e1126));
                                                                    let _e1131 = bitcast<f32>((bitcast<u32>(_e1099) & 2147483647u));
                                                                    let _e1134 = bitcast<f32>((bitcast<u32>(_e1100) & 2147483647u));
                                                                    let _e1136 = select(_e1134, _e1131, (_e1131 > _e1134));
                                                                    let _e1139 = bitcast<f32>((bitcast<u32>(_e1101) & 2147483647u));
                                                                    let _e1141 = select(_e1139, _e1136, (_e1136 > _e1139));
                                                                    let _e1143 = select(_e1128, _e1115, (_e1115 > _e1128));
                                                                    let _e1145 = select(_e1141, _e1143, (_e1143 > _e1141));
                                                                    if (_e1115 == _e1145) {
                                                                        phi_3548_ = _e1098;
                                                                        phi_3549_ = _e1102;
                                                                    } else {
                                                                        let _e1148 = vec3((_e1128 == _e1145));
                                                                        phi_3548_ = select(_e1094, _e1102, _e1148);
                                                                        phi_3549_ = select(_e1098, _e1094, _e1148);
                                                                    }
                                                                    let _e1152 = phi_3548_;
                                                                    let _e1154 = phi_3549_;
                                                                    let _e1161 = ((_e1152.y * _e1154.z) - (_e1154.y * _e1152.z));
                                                                    let _e1166 = ((_e1152.z * _e1154.x) - (_e1154.z * _e1152.x));
                                                                    let _e1169 = ((_e1152.x * _e1154.y) - (_e1154.x * _e1152.y));
                                                                    if (_e1011 >= _e1015) {
                                                                        phi_3580_ = select(true, false, (_e1011 >= _e1019));
                                                                    } else {
                                                                        phi_3580_ = true;
                                                                    }
                                                                    let _e1174 = phi_3580_;
                                                                    if _e1174 {
                                                                        phi_3589_ = select(vec3<f32>(_e948[2][0], _e948[2][1], _e948[2][2]), vec3<f32>(_e948[1][0], _e948[1][1], _e948[1][2]), vec3((_e1015 >= _e1019)));
                                                                    } else {
                                                                        phi_3589_ = vec3<f32>(_e948[0][0], _e948[0][1], _e948[0][2]);
                                                                    }
                                                                    let _e1179 = phi_3589_;
                                                                    let _e1196 = ((((_e1161 * (_e1179.x - _e290)) + (_e1166 * (_e1179.y - _e327))) + (_e1169 * (_e1179.z - _e363))) / (((_e1161 * _e315) + (_e1166 * _e351)) + (_e1169 * _e387)));
                                                                    let _e1198 = select(_e1078, _e1196, (_e1196 < _e1078));
                                                                    let _e1200 = select(_e1070, _e1198, (_e1198 > _e1070));
                                                                    if (_e1200 >= _e436) {
                                                                        let _e1202 = (_e1200 <= _e846.member.member_1);
                                                                        if _e1202 {
                                                                            let _e1203 = (1f / _e1021);
                                                                            phi_3629_ = type_23(_e1200, (_e1015 * _e1203), (_e1019 * _e1203), _e881);
                                                                        } else {
                                                                            phi_3629_ = type_23();
                                                                        }
                                                                        let _e1208 = phi_3629_;
                                                                        phi_3631_ = _e1208;
                                                                        phi_3632_ = select(true, false, _e1202);
                                                                    } else {
                                                                        phi_3631_ = type_23();
                                                                        phi_3632_ = true;
                                                                    }
                                                                    let _e1211 = phi_3631_;
                                                                    let _e1213 = phi_3632_;
                                                                    if _e1213 {
                                                                        phi_3636_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_3636_ = _e1211;
                                                                    }
                                                                    let _e1215 = phi_3636_;
                                                                    phi_3637_ = _e1215;
                                                                }
                                                                let _e1217 = phi_3637_;
                                                                phi_3638_ = _e1217;
                                                                phi_3639_ = _e1087;
                                                            }
                                                            let _e1219 = phi_3638_;
                                                            let _e1221 = phi_3639_;
                                                            phi_3643_ = _e1219;
                                                            phi_3644_ = _e1221;
                                                        }
                                                        let _e1223 = phi_3643_;
                                                        let _e1225 = phi_3644_;
                                                        phi_3648_ = _e1223;
                                                        phi_3649_ = _e1225;
                                                    } else {
                                                        phi_3648_ = type_23();
                                                        phi_3649_ = true;
                                                    }
                                                    let _e1227 = phi_3648_;
                                                    let _e1229 = phi_3649_;
                                                    if _e1229 {
                                                        phi_3653_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_3653_ = _e1227;
                                                    }
                                                    let _e1231 = phi_3653_;
                                                    if (_e1231.member_3 != 4294967295u) {
                                                        if (_e881 != _e442) {
                                                            if (_e1231.member < _e846.member.member.member) {
                                                                phi_3679_ = true;
                                                            } else {
                                                                if (_e1231.member == _e846.member.member.member) {
                                                                    phi_3678_ = (_e1231.member_3 < _e846.member.member.member_3);
                                                                } else {
                                                                    phi_3678_ = false;
                                                                }
                                                                let _e1246 = phi_3678_;
                                                                phi_3679_ = _e1246;
                                                            }
                                                            let _e1248 = phi_3679_;
                                                            if _e1248 {
                                                                phi_3686_ = type_40(type_37(_e1231, _e1231.member), _e873.member_1, _e873.member_2);
                                                            } else {
                                                                phi_3686_ = _e873;
                                                            }
                                                            let _e1255 = phi_3686_;
                                                            phi_3687_ = _e1255;
                                                        } else {
                                                            phi_3687_ = _e873;
                                                        }
                                                        let _e1257 = phi_3687_;
                                                        phi_3688_ = _e1257;
                                                    } else {
                                                        phi_3688_ = _e873;
                                                    }
                                                    let _e1259 = phi_3688_;
                                                    phi_2939_ = _e1259;
                                                } else {
                                                    phi_2939_ = type_40();
                                                }
                                                let _e1261 = phi_2939_;
                                                continue;
                                                continuing {
                                                    phi_2938_ = _e1261;
                                                    phi_2941_ = _e861;
                                                    phi_4844_ = _e473;
                                                    break if !(_e867);
                                                }
                                            }
                                            let _e1264 = phi_4844_;
                                            phi_4907_ = _e1264;
                                            if _e1264 {
                                                break;
                                            }
                                            phi_4911_ = _e1264;
                                            let _e1482 = local_14;
                                            phi_4535_ = _e1482;
                                            phi_4536_ = _e513;
                                            phi_4537_ = false;
                                            phi_4538_ = _e517;
                                        } else {
                                            local_1 = array<f32, 3>(_e513.member.member[0], _e513.member.member[1], _e513.member.member[2]);
                                            local = array<f32, 3>(_e513.member.member_1[0], _e513.member.member_1[1], _e513.member.member_1[2]);
                                            let _e543 = (_e513.member_1 < _e86);
                                            if _e543 {
                                                if _e543 {
                                                } else {
                                                    phi_4907_ = true;
                                                    break;
                                                }
                                                let _e545 = global_7.member[_e513.member_1];
                                                phi_3725_ = _e545;
                                            } else {
                                                phi_3725_ = type_44(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                            }
                                            let _e547 = phi_3725_;
                                            let _e549 = array<u32, 3>(_e258, _e257, _e259);
                                            local_9 = _e549;
                                            local_5 = array<f32, 3>(0f, 0f, 0f);
                                            local_4 = array<f32, 3>(0f, 0f, 0f);
                                            phi_3734_ = type_7(0u, 3u);
                                            loop {
                                                let _e551 = phi_3734_;
                                                if (_e551.member < _e551.member_1) {
                                                    phi_3735_ = type_7((_e551.member + 1u), _e551.member_1);
                                                    phi_3758_ = type_7(1u, _e551.member);
                                                } else {
                                                    phi_3735_ = _e551;
                                                    phi_3758_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e564 = phi_3735_;
                                                let _e566 = phi_3758_;
                                                let _e570 = (bitcast<i32>(_e566.member) != 0i);
                                                if _e570 {
                                                    let _e571 = (_e566.member_1 < 3u);
                                                    if _e571 {
                                                    } else {
                                                        phi_4776_ = true;
                                                        break;
                                                    }
                                                    let _e573 = local_9[_e566.member_1];
                                                    if _e571 {
                                                    } else {
                                                        phi_4776_ = true;
                                                        break;
                                                    }
                                                    let _e575 = local_1[_e566.member_1];
                                                    if _e571 {
                                                    } else {
                                                        phi_4776_ = true;
                                                        break;
                                                    }
                                                    let _e577 = local[_e566.member_1];
                                                    let _e580 = ((10u * _e573) & 31u);
                                                    let _e583 = ((_e547.member[0] >> bitcast<u32>(_e580)) & 1023u);
                                                    let _e588 = bitcast<f32>((bitcast<u32>(((_e577 - _e575) * 0.0009775171f)) ^ _e124));
                                                    let _e594 = (_e575 + bitcast<f32>((bitcast<u32>((f32(_e583) * _e588)) ^ _e124)));
                                                    if _e571 {
                                                    } else {
                                                        phi_4776_ = true;
                                                        break;
                                                    }
                                                    local_5[_e566.member_1] = select(select(_e577, _e594, (_e594 < _e577)), _e577, (_e583 == 1023u));
                                                    let _e603 = ((_e547.member[1] >> bitcast<u32>(_e580)) & 1023u);
                                                    let _e609 = (_e575 + bitcast<f32>((bitcast<u32>((f32(_e603) * _e588)) ^ _e124)));
                                                    if _e571 {
                                                    } else {
                                                        phi_4776_ = true;
                                                        break;
                                                    }
                                                    local_4[_e566.member_1] = select(select(_e577, _e609, (_e609 < _e577)), _e577, (_e603 == 1023u));
                                                }
                                                continue;
                                                continuing {
                                                    phi_3734_ = _e564;
                                                    phi_4776_ = _e473;
                                                    break if !(_e570);
                                                }
                                            }
                                            let _e617 = phi_4776_;
                                            phi_4907_ = _e617;
                                            if _e617 {
                                                break;
                                            }
                                            let _e618 = local_4;
                                            let _e619 = local_5;
                                            local_8 = _e549;
                                            local_7 = array<f32, 3>(0f, 0f, 0f);
                                            local_6 = array<f32, 3>(0f, 0f, 0f);
                                            phi_3888_ = type_7(0u, 3u);
                                            loop {
                                                let _e628 = phi_3888_;
                                                if (_e628.member < _e628.member_1) {
                                                    phi_3889_ = type_7((_e628.member + 1u), _e628.member_1);
                                                    phi_3912_ = type_7(1u, _e628.member);
                                                } else {
                                                    phi_3889_ = _e628;
                                                    phi_3912_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e641 = phi_3889_;
                                                let _e643 = phi_3912_;
                                                let _e647 = (bitcast<i32>(_e643.member) != 0i);
                                                if _e647 {
                                                    let _e648 = (_e643.member_1 < 3u);
                                                    if _e648 {
                                                    } else {
                                                        phi_4836_ = true;
                                                        break;
                                                    }
                                                    let _e650 = local_8[_e643.member_1];
                                                    if _e648 {
                                                    } else {
                                                        phi_4836_ = true;
                                                        break;
                                                    }
                                                    let _e652 = local_1[_e643.member_1];
                                                    if _e648 {
                                                    } else {
                                                        phi_4836_ = true;
                                                        break;
                                                    }
                                                    let _e654 = local[_e643.member_1];
                                                    let _e657 = ((10u * _e650) & 31u);
                                                    let _e660 = ((_e547.member_1[0] >> bitcast<u32>(_e657)) & 1023u);
                                                    let _e665 = bitcast<f32>((bitcast<u32>(((_e654 - _e652) * 0.0009775171f)) ^ _e124));
                                                    let _e671 = (_e652 + bitcast<f32>((bitcast<u32>((f32(_e660) * _e665)) ^ _e124)));
                                                    if _e648 {
                                                    } else {
                                                        phi_4836_ = true;
                                                        break;
                                                    }
                                                    local_7[_e643.member_1] = select(select(_e654, _e671, (_e671 < _e654)), _e654, (_e660 == 1023u));
                                                    let _e680 = ((_e547.member_1[1] >> bitcast<u32>(_e657)) & 1023u);
                                                    let _e686 = (_e652 + bitcast<f32>((bitcast<u32>((f32(_e680) * _e665)) ^ _e124)));
                                                    if _e648 {
                                                    } else {
                                                        phi_4836_ = true;
                                                        break;
                                                    }
                                                    local_6[_e643.member_1] = select(select(_e654, _e686, (_e686 < _e654)), _e654, (_e680 == 1023u));
                                                }
                                                continue;
                                                continuing {
                                                    phi_3888_ = _e641;
                                                    phi_4836_ = _e617;
                                                    break if !(_e647);
                                                }
                                            }
                                            let _e694 = phi_4836_;
                                            phi_4907_ = _e694;
                                            if _e694 {
                                                break;
                                            }
                                            let _e695 = local_6;
                                            let _e696 = local_7;
                                            let _e707 = type_53(type_50(array<f32, 3>(_e619[0], _e619[1], _e619[2]), array<f32, 3>(_e618[0], _e618[1], _e618[2])), _e547.member_2);
                                            let _e712 = type_53(type_50(array<f32, 3>(_e696[0], _e696[1], _e696[2]), array<f32, 3>(_e695[0], _e695[1], _e695[2])), _e547.member_3);
                                            let _e719 = ((_e619[0] - _e313) * _e318);
                                            let _e720 = ((_e696[0] - _e313) * _e318);
                                            let _e721 = ((_e618[0] - _e314) * _e318);
                                            let _e722 = ((_e695[0] - _e314) * _e318);
                                            let _e727 = ((_e619[1] - _e349) * _e354);
                                            let _e728 = ((_e696[1] - _e349) * _e354);
                                            let _e729 = ((_e618[1] - _e350) * _e354);
                                            let _e730 = ((_e695[1] - _e350) * _e354);
                                            let _e735 = ((_e619[2] - _e385) * _e390);
                                            let _e736 = ((_e696[2] - _e385) * _e390);
                                            let _e737 = ((_e618[2] - _e386) * _e390);
                                            let _e738 = ((_e695[2] - _e386) * _e390);
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
                                            let _e790 = select(_e436, _e760, (_e760 > _e436));
                                            let _e792 = select(_e436, _e762, (_e762 > _e436));
                                            let _e797 = (_e790 <= select(_e475.member.member_1, _e787, (_e787 < _e475.member.member_1)));
                                            let _e798 = (_e792 <= select(_e475.member.member_1, _e788, (_e788 < _e475.member.member_1)));
                                            let _e799 = (_e790 <= _e792);
                                            if _e797 {
                                                if _e798 {
                                                    if _e799 {
                                                        phi_4475_ = _e712;
                                                    } else {
                                                        phi_4475_ = _e707;
                                                    }
                                                    let _e801 = phi_4475_;
                                                    let _e802 = (_e517 % 128u);
                                                    let _e803 = (_e802 < 128u);
                                                    if _e803 {
                                                    } else {
                                                        phi_4907_ = true;
                                                        break;
                                                    }
                                                    local_3[_e802] = type_53(type_50(array<f32, 3>(_e801.member.member[0], _e801.member.member[1], _e801.member.member[2]), array<f32, 3>(_e801.member.member_1[0], _e801.member.member_1[1], _e801.member.member_1[2])), _e801.member_1);
                                                    if _e803 {
                                                    } else {
                                                        phi_4907_ = true;
                                                        break;
                                                    }
                                                    local_2[_e802] = select(_e792, _e790, (_e790 > _e792));
                                                    if _e799 {
                                                        phi_4514_ = _e707;
                                                    } else {
                                                        phi_4514_ = _e712;
                                                    }
                                                    let _e824 = phi_4514_;
                                                    phi_4515_ = _e824;
                                                    phi_4516_ = (_e517 + 1u);
                                                } else {
                                                    phi_4515_ = type_53();
                                                    phi_4516_ = u32();
                                                }
                                                let _e826 = phi_4515_;
                                                let _e828 = phi_4516_;
                                                phi_4518_ = _e826;
                                                phi_4519_ = _e828;
                                                phi_4520_ = select(true, false, _e798);
                                            } else {
                                                phi_4518_ = type_53();
                                                phi_4519_ = u32();
                                                phi_4520_ = true;
                                            }
                                            let _e831 = phi_4518_;
                                            let _e833 = phi_4519_;
                                            let _e835 = phi_4520_;
                                            if _e835 {
                                                if _e797 {
                                                    phi_4527_ = _e707;
                                                } else {
                                                    phi_4527_ = _e712;
                                                }
                                                let _e837 = phi_4527_;
                                                phi_4532_ = _e837;
                                                phi_4533_ = select(_e798, true, _e797);
                                            } else {
                                                phi_4532_ = _e831;
                                                phi_4533_ = _e515;
                                            }
                                            let _e840 = phi_4532_;
                                            let _e842 = phi_4533_;
                                            phi_4911_ = _e694;
                                            phi_4535_ = type_40(_e475.member, (_e475.member_1 + 1u), _e475.member_2);
                                            phi_4536_ = _e840;
                                            phi_4537_ = _e842;
                                            phi_4538_ = select(_e833, _e517, _e835);
                                        }
                                        let _e1266 = phi_4911_;
                                        let _e1268 = phi_4535_;
                                        let _e1270 = phi_4536_;
                                        let _e1272 = phi_4537_;
                                        let _e1274 = phi_4538_;
                                        phi_4910_ = _e1266;
                                        phi_4539_ = _e1268;
                                        phi_4540_ = _e1270;
                                        phi_4541_ = (_e479 - 1u);
                                        phi_4542_ = _e1272;
                                        phi_4543_ = _e1274;
                                    } else {
                                        phi_4910_ = _e473;
                                        phi_4539_ = _e475;
                                        phi_4540_ = _e513;
                                        phi_4541_ = _e479;
                                        phi_4542_ = _e515;
                                        phi_4543_ = _e517;
                                    }
                                    let _e1276 = phi_4910_;
                                    let _e1278 = phi_4539_;
                                    let _e1280 = phi_4540_;
                                    let _e1282 = phi_4541_;
                                    let _e1284 = phi_4542_;
                                    let _e1286 = phi_4543_;
                                    phi_4909_ = _e1276;
                                    phi_4544_ = _e1278;
                                    phi_4545_ = _e1280;
                                    phi_4546_ = _e1282;
                                    phi_4547_ = _e1284;
                                    phi_4548_ = _e1286;
                                } else {
                                    phi_4909_ = _e473;
                                    phi_4544_ = type_40();
                                    phi_4545_ = type_53();
                                    phi_4546_ = u32();
                                    phi_4547_ = bool();
                                    phi_4548_ = u32();
                                }
                                let _e1288 = phi_4909_;
                                let _e1290 = phi_4544_;
                                let _e1292 = phi_4545_;
                                let _e1294 = phi_4546_;
                                let _e1296 = phi_4547_;
                                let _e1298 = phi_4548_;
                                phi_4908_ = _e1288;
                                phi_2854_ = _e1290;
                                phi_2857_ = _e1292;
                                phi_2859_ = _e1294;
                                phi_2861_ = _e1296;
                                phi_2863_ = _e1298;
                                phi_4549_ = _e487;
                            } else {
                                phi_4908_ = _e473;
                                phi_2854_ = type_40();
                                phi_2857_ = type_53();
                                phi_2859_ = u32();
                                phi_2861_ = bool();
                                phi_2863_ = u32();
                                phi_4549_ = false;
                            }
                            let _e1300 = phi_4908_;
                            let _e1302 = phi_2854_;
                            let _e1304 = phi_2857_;
                            let _e1306 = phi_2859_;
                            let _e1308 = phi_2861_;
                            let _e1310 = phi_2863_;
                            let _e1312 = phi_4549_;
                            continue;
                            continuing {
                                phi_4783_ = _e1300;
                                phi_2853_ = _e1302;
                                phi_2856_ = _e1304;
                                phi_2858_ = _e1306;
                                phi_2860_ = _e1308;
                                phi_2862_ = _e1310;
                                phi_4907_ = _e1300;
                                break if !(_e1312);
                            }
                        }
                        let _e1315 = phi_4907_;
                        if _e1315 {
                            break;
                        }
                        let _e1317 = local_12;
                        if (_e1317.member.member.member_3 != 4294967295u) {
                            let _e1323 = (_e260 / 3i);
                            let _e1330 = bitcast<f32>((bitcast<u32>((_e1323 + 127i)) << bitcast<u32>(23i)));
                            let _e1338 = (((_e1317.member.member.member * _e1330) * _e1330) * bitcast<f32>((bitcast<u32>(((_e260 - (2i * _e1323)) + 127i)) << bitcast<u32>(23i))));
                            let _e1340 = select(340282350000000000000000000000000000000f, _e1338, (_e1338 < 340282350000000000000000000000000000000f));
                            phi_4601_ = type_23(select(-340282350000000000000000000000000000000f, _e1340, (_e1340 > -340282350000000000000000000000000000000f)), _e1317.member.member.member_1, _e1317.member.member.member_2, _e1317.member.member.member_3);
                        } else {
                            phi_4601_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1347 = phi_4601_;
                        if _e136 {
                        } else {
                            break;
                        }
                        global_2.member[_e128] = _e1347;
                        let _e1351 = local_13;
                        if _e137 {
                        } else {
                            break;
                        }
                        global_5.member[_e128] = _e1351.member_1;
                        if _e135 {
                        } else {
                            break;
                        }
                        let _e1356 = select(0u, 1u, (_e204 <= _e214));
                        if (_e1356 > 0u) {
                            let _e1358 = (1u < _e96);
                            if _e1358 {
                                if (0u < _e96) {
                                } else {
                                    break;
                                }
                                let _e1362 = atomicAdd((&global_6.member[0u]), _e1356);
                                if ((_e1362 + _e1356) < _e1362) {
                                    if _e1358 {
                                    } else {
                                        break;
                                    }
                                    let _e1367 = atomicAdd((&global_6.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1370 = select(0u, 1u, (_e1347.member_3 != 4294967295u));
                        if (_e1370 > 0u) {
                            let _e1372 = (3u < _e96);
                            if _e1372 {
                                if (2u < _e96) {
                                } else {
                                    break;
                                }
                                let _e1376 = atomicAdd((&global_6.member[2u]), _e1370);
                                if ((_e1376 + _e1370) < _e1376) {
                                    if _e1372 {
                                    } else {
                                        break;
                                    }
                                    let _e1381 = atomicAdd((&global_6.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1351.member_1 > 0u) {
                            let _e1383 = (5u < _e96);
                            if _e1383 {
                                if (4u < _e96) {
                                } else {
                                    break;
                                }
                                let _e1387 = atomicAdd((&global_6.member[4u]), _e1351.member_1);
                                if ((_e1387 + _e1351.member_1) < _e1387) {
                                    if _e1383 {
                                    } else {
                                        break;
                                    }
                                    let _e1392 = atomicAdd((&global_6.member[5u]), 1u);
                                }
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
fn trace_paths_counted_printed_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
