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
    var phi_352_: i32;
    var phi_353_: i32;
    var phi_363_: bool;
    var phi_373_: u32;
    var phi_374_: u32;
    var phi_376_: bool;
    var phi_381_: u32;
    var phi_394_: i32;
    var phi_414_: i32;
    var phi_432_: f32;
    var phi_438_: f32;
    var phi_449_: f32;
    var phi_455_: f32;
    var phi_478_: f32;
    var phi_489_: f32;
    var phi_498_: f32;
    var phi_504_: f32;
    var phi_515_: f32;
    var phi_521_: f32;
    var phi_544_: f32;
    var phi_555_: f32;
    var phi_564_: f32;
    var phi_570_: f32;
    var phi_581_: f32;
    var phi_587_: f32;
    var phi_610_: f32;
    var phi_621_: f32;
    var phi_721_: f32;
    var phi_722_: f32;
    var phi_5034_: bool;
    var phi_5025_: f32;
    var phi_2903_: type_52;
    var phi_2906_: u32;
    var phi_2908_: bool;
    var phi_2910_: u32;
    var phi_2921_: bool;
    var phi_2967_: type_52;
    var phi_2968_: bool;
    var phi_2969_: u32;
    var phi_3953_: type_38;
    var phi_3962_: type_4;
    var phi_3963_: type_4;
    var phi_3986_: type_4;
    var phi_5027_: bool;
    var phi_4116_: type_4;
    var phi_4117_: type_4;
    var phi_4140_: type_4;
    var phi_5087_: bool;
    var phi_4704_: type_52;
    var phi_4743_: type_52;
    var phi_4744_: type_52;
    var phi_4745_: u32;
    var phi_4747_: type_52;
    var phi_4748_: u32;
    var phi_4749_: bool;
    var phi_4756_: type_52;
    var phi_4761_: type_52;
    var phi_4762_: bool;
    var phi_5136_: f32;
    var phi_5122_: bool;
    var phi_2988_: type_4;
    var phi_2989_: type_4;
    var phi_3012_: type_4;
    var phi_3054_: u32;
    var phi_3078_: type_46;
    var phi_5118_: bool;
    var phi_3089_: type_4;
    var phi_3090_: type_4;
    var phi_3113_: type_4;
    var phi_3123_: type_4;
    var phi_3124_: type_4;
    var phi_3147_: type_4;
    var phi_5113_: bool;
    var phi_5126_: bool;
    var phi_5125_: bool;
    var phi_3711_: vec3<f32>;
    var phi_3712_: vec3<f32>;
    var phi_3743_: bool;
    var phi_3752_: vec3<f32>;
    var phi_3792_: type_18;
    var phi_3794_: type_18;
    var phi_3795_: bool;
    var phi_3799_: type_18;
    var phi_3800_: type_18;
    var phi_3801_: type_18;
    var phi_3802_: bool;
    var phi_3806_: type_18;
    var phi_3807_: bool;
    var phi_3811_: type_18;
    var phi_3812_: bool;
    var phi_3816_: type_18;
    var phi_3828_: type_4;
    var phi_3831_: type_18;
    var phi_3829_: type_4;
    var phi_3854_: type_4;
    var phi_3886_: bool;
    var phi_3887_: bool;
    var phi_3908_: type_18;
    var phi_3832_: type_18;
    var phi_5141_: bool;
    var phi_5352_: f32;
    var phi_5351_: f32;
    var phi_5203_: bool;
    var phi_5350_: f32;
    var phi_5202_: bool;
    var phi_5349_: f32;
    var phi_5201_: bool;
    var phi_5289_: f32;
    var phi_5200_: bool;
    var phi_5254_: f32;
    var phi_5209_: bool;
    var phi_4764_: type_52;
    var phi_4765_: bool;
    var phi_4766_: u32;
    var phi_5253_: f32;
    var phi_5208_: bool;
    var phi_4767_: type_52;
    var phi_4768_: u32;
    var phi_4769_: bool;
    var phi_4770_: u32;
    var phi_5252_: f32;
    var phi_5207_: bool;
    var phi_4771_: type_52;
    var phi_4772_: u32;
    var phi_4773_: bool;
    var phi_4774_: u32;
    var phi_5251_: f32;
    var phi_5206_: bool;
    var phi_2904_: type_52;
    var phi_2907_: u32;
    var phi_2909_: bool;
    var phi_2911_: u32;
    var phi_4775_: bool;
    var phi_5205_: bool;
    var phi_4782_: type_4;
    var phi_4783_: type_4;
    var phi_4806_: type_4;
    var phi_4872_: type_18;
    var phi_5244_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e87 = global;
            let _e90 = arrayLength((&global_4.member));
            let _e101 = global_2.member[0u][0u];
            let _e105 = global_2.member[0u][1u];
            let _e109 = global_2.member[0u][2u];
            let _e113 = global_2.member[1u][0u];
            let _e117 = global_2.member[1u][1u];
            let _e121 = global_2.member[1u][2u];
            let _e125 = global_2.member[1u][3u];
            let _e128 = global_1.member[0u];
            let _e129 = bitcast<i32>(_e128);
            let _e139 = (_e87.x + (_e87.y * 2097152u));
            let _e140 = (_e139 < arrayLength((&global_3.member)));
            if _e140 {
                let _e141 = (_e139 < arrayLength((&global_5.member)));
                if _e141 {
                    if _e140 {
                    } else {
                        break;
                    }
                    let _e149 = global_3.member[_e139].member_2[0u];
                    let _e151 = (bitcast<u32>(_e149) & 2147483647u);
                    let _e156 = global_3.member[_e139].member_2[1u];
                    let _e158 = (bitcast<u32>(_e156) & 2147483647u);
                    let _e163 = global_3.member[_e139].member_2[2u];
                    let _e165 = (bitcast<u32>(_e163) & 2147483647u);
                    let _e170 = global_3.member[_e139].member[0u];
                    let _e172 = (bitcast<u32>(_e170) & 2147483647u);
                    let _e177 = global_3.member[_e139].member[1u];
                    let _e179 = (bitcast<u32>(_e177) & 2147483647u);
                    let _e184 = global_3.member[_e139].member[2u];
                    let _e186 = (bitcast<u32>(_e184) & 2147483647u);
                    let _e188 = select(_e158, _e151, (_e158 < _e151));
                    let _e190 = select(_e165, _e188, (_e165 < _e188));
                    let _e192 = select(_e172, _e190, (_e172 < _e190));
                    let _e194 = select(_e179, _e192, (_e179 < _e192));
                    let _e196 = select(_e186, _e194, (_e186 < _e194));
                    let _e200 = global_3.member[_e139].member_1;
                    let _e202 = (bitcast<u32>(_e200) & 2147483647u);
                    let _e209 = global_3.member[_e139].member_3;
                    let _e215 = (((select(_e202, _e196, (_e202 < _e196)) < 2139095040u) && ((bitcast<u32>(_e209) & 2147483647u) <= 2139095040u)) && (_e190 > 0u));
                    if _e215 {
                        let _e218 = (bitcast<u32>(bitcast<f32>(_e190)) & 2147483647u);
                        if (_e218 >= 8388608u) {
                            phi_352_ = (bitcast<i32>((_e218 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_352_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e218)), 32u, (_e218 == 0u))));
                        }
                        let _e232 = phi_352_;
                        phi_353_ = _e232;
                    } else {
                        phi_353_ = 0i;
                    }
                    let _e234 = phi_353_;
                    let _e235 = (_e151 == _e190);
                    if _e235 {
                        phi_363_ = true;
                    } else {
                        phi_363_ = (_e158 == _e190);
                    }
                    let _e238 = phi_363_;
                    let _e239 = select(1u, 0u, _e235);
                    if _e238 {
                        let _e240 = (_e239 + 1u);
                        phi_373_ = _e240;
                        phi_374_ = _e240;
                        phi_376_ = select(true, false, (_e240 == 2u));
                    } else {
                        phi_373_ = u32();
                        phi_374_ = 0u;
                        phi_376_ = true;
                    }
                    let _e244 = phi_373_;
                    let _e246 = phi_374_;
                    let _e248 = phi_376_;
                    if _e248 {
                        phi_381_ = (_e246 + 1u);
                    } else {
                        phi_381_ = 0u;
                    }
                    let _e252 = phi_381_;
                    let _e253 = select(_e244, _e246, _e248);
                    let _e254 = select(_e239, select(2u, _e239, _e238), _e248);
                    if (_e129 < -126i) {
                        phi_394_ = -126i;
                    } else {
                        phi_394_ = select(_e129, 127i, (_e129 > 127i));
                    }
                    let _e259 = phi_394_;
                    let _e264 = bitcast<f32>((bitcast<u32>((_e259 + 127i)) << bitcast<u32>(23i)));
                    let _e270 = bitcast<f32>((bitcast<u32>(((_e129 - _e259) + 127i)) << bitcast<u32>(23i)));
                    let _e271 = -(_e234);
                    if (_e271 < -126i) {
                        phi_414_ = -126i;
                    } else {
                        phi_414_ = select(_e271, 127i, (_e271 > 127i));
                    }
                    let _e276 = phi_414_;
                    let _e281 = bitcast<f32>((bitcast<u32>((_e276 + 127i)) << bitcast<u32>(23i)));
                    let _e287 = bitcast<f32>((bitcast<u32>(((_e271 - _e276) + 127i)) << bitcast<u32>(23i)));
                    let _e291 = global_3.member[_e139].member;
                    let _e292 = (_e253 == 0u);
                    if _e292 {
                        phi_432_ = _e291[0];
                    } else {
                        phi_432_ = _e291[1];
                    }
                    let _e296 = phi_432_;
                    let _e297 = (_e253 == 2u);
                    if _e297 {
                        phi_438_ = _e291[2];
                    } else {
                        phi_438_ = _e296;
                    }
                    let _e300 = phi_438_;
                    let _e302 = ((_e300 * _e264) * _e270);
                    let _e303 = global_3.member[_e139].member_2;
                    if _e292 {
                        phi_449_ = _e303[0];
                    } else {
                        phi_449_ = _e303[1];
                    }
                    let _e307 = phi_449_;
                    if _e297 {
                        phi_455_ = _e303[2];
                    } else {
                        phi_455_ = _e307;
                    }
                    let _e310 = phi_455_;
                    let _e312 = ((_e310 * _e281) * _e287);
                    let _e316 = (bitcast<f32>((bitcast<u32>(_e312) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e316 {
                        let _e320 = (bitcast<f32>((bitcast<u32>(_e302) & 2147483647u)) * 0.00000011920929f);
                        phi_478_ = select(0.00000000000011368684f, _e320, (_e320 > 0.00000000000011368684f));
                    } else {
                        phi_478_ = 0f;
                    }
                    let _e324 = phi_478_;
                    let _e325 = (_e302 + _e324);
                    let _e326 = (_e302 - _e324);
                    let _e327 = select(_e312, 0f, _e316);
                    if _e316 {
                        phi_489_ = 38685626000000000000000000f;
                    } else {
                        phi_489_ = (1f / _e312);
                    }
                    let _e330 = phi_489_;
                    let _e331 = (_e252 == 0u);
                    if _e331 {
                        phi_498_ = _e291[0];
                    } else {
                        phi_498_ = _e291[1];
                    }
                    let _e335 = phi_498_;
                    let _e336 = (_e252 == 2u);
                    if _e336 {
                        phi_504_ = _e291[2];
                    } else {
                        phi_504_ = _e335;
                    }
                    let _e339 = phi_504_;
                    let _e341 = ((_e339 * _e264) * _e270);
                    if _e331 {
                        phi_515_ = _e303[0];
                    } else {
                        phi_515_ = _e303[1];
                    }
                    let _e345 = phi_515_;
                    if _e336 {
                        phi_521_ = _e303[2];
                    } else {
                        phi_521_ = _e345;
                    }
                    let _e348 = phi_521_;
                    let _e350 = ((_e348 * _e281) * _e287);
                    let _e354 = (bitcast<f32>((bitcast<u32>(_e350) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e354 {
                        let _e358 = (bitcast<f32>((bitcast<u32>(_e341) & 2147483647u)) * 0.00000011920929f);
                        phi_544_ = select(0.00000000000011368684f, _e358, (_e358 > 0.00000000000011368684f));
                    } else {
                        phi_544_ = 0f;
                    }
                    let _e362 = phi_544_;
                    let _e363 = (_e341 + _e362);
                    let _e364 = (_e341 - _e362);
                    let _e365 = select(_e350, 0f, _e354);
                    if _e354 {
                        phi_555_ = 38685626000000000000000000f;
                    } else {
                        phi_555_ = (1f / _e350);
                    }
                    let _e368 = phi_555_;
                    let _e369 = (_e254 == 0u);
                    if _e369 {
                        phi_564_ = _e291[0];
                    } else {
                        phi_564_ = _e291[1];
                    }
                    let _e373 = phi_564_;
                    let _e374 = (_e254 == 2u);
                    if _e374 {
                        phi_570_ = _e291[2];
                    } else {
                        phi_570_ = _e373;
                    }
                    let _e377 = phi_570_;
                    let _e379 = ((_e377 * _e264) * _e270);
                    if _e369 {
                        phi_581_ = _e303[0];
                    } else {
                        phi_581_ = _e303[1];
                    }
                    let _e383 = phi_581_;
                    if _e374 {
                        phi_587_ = _e303[2];
                    } else {
                        phi_587_ = _e383;
                    }
                    let _e386 = phi_587_;
                    let _e388 = ((_e386 * _e281) * _e287);
                    let _e392 = (bitcast<f32>((bitcast<u32>(_e388) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e392 {
                        let _e396 = (bitcast<f32>((bitcast<u32>(_e379) & 2147483647u)) * 0.00000011920929f);
                        phi_610_ = select(0.00000000000011368684f, _e396, (_e396 > 0.00000000000011368684f));
                    } else {
                        phi_610_ = 0f;
                    }
                    let _e400 = phi_610_;
                    let _e401 = (_e379 + _e400);
                    let _e402 = (_e379 - _e400);
                    let _e403 = select(_e388, 0f, _e392);
                    if _e392 {
                        phi_621_ = 38685626000000000000000000f;
                    } else {
                        phi_621_ = (1f / _e388);
                    }
                    let _e406 = phi_621_;
                    let _e409 = bitcast<f32>((bitcast<u32>(_e302) & 2147483647u));
                    let _e412 = bitcast<f32>((bitcast<u32>(_e341) & 2147483647u));
                    let _e414 = select(_e412, _e409, (_e409 > _e412));
                    let _e417 = bitcast<f32>((bitcast<u32>(_e379) & 2147483647u));
                    let _e420 = (_e129 + _e234);
                    if (_e215 && (select(_e417, _e414, (_e414 > _e417)) <= 1099511600000f)) {
                        let _e423 = (_e420 / 3i);
                        let _e430 = bitcast<f32>((bitcast<u32>((_e423 + 127i)) << bitcast<u32>(23i)));
                        let _e437 = bitcast<f32>((bitcast<u32>(((_e420 - (2i * _e423)) + 127i)) << bitcast<u32>(23i)));
                        let _e438 = (((_e200 * _e430) * _e430) * _e437);
                        let _e440 = select(340282350000000000000000000000000000000f, _e438, (_e438 < 340282350000000000000000000000000000000f));
                        let _e445 = (((_e209 * _e430) * _e430) * _e437);
                        let _e447 = select(340282350000000000000000000000000000000f, _e445, (_e445 < 340282350000000000000000000000000000000f));
                        phi_721_ = select(-340282350000000000000000000000000000000f, _e447, (_e447 > -340282350000000000000000000000000000000f));
                        phi_722_ = select(-340282350000000000000000000000000000000f, _e440, (_e440 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_721_ = 0f;
                        phi_722_ = 1f;
                    }
                    let _e451 = phi_721_;
                    let _e453 = phi_722_;
                    local_4 = array<type_18, 8>(type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_6 = array<type_52, 128>(type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u), type_52(type_43(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f)), 0u));
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_17 = array<f32, 3>(bitcast<f32>(_e101), bitcast<f32>(_e105), bitcast<f32>(_e109));
                    let _e457 = (_e253 % 3u);
                    let _e458 = (_e457 < 3u);
                    if _e458 {
                    } else {
                        break;
                    }
                    let _e460 = local_17[_e457];
                    let _e461 = (_e252 % 3u);
                    let _e462 = (_e461 < 3u);
                    if _e462 {
                    } else {
                        break;
                    }
                    let _e464 = local_17[_e461];
                    let _e465 = (_e254 % 3u);
                    let _e466 = (_e465 < 3u);
                    if _e466 {
                    } else {
                        break;
                    }
                    let _e468 = local_17[_e465];
                    local_16 = array<f32, 3>(bitcast<f32>(_e113), bitcast<f32>(_e117), bitcast<f32>(_e121));
                    if _e458 {
                    } else {
                        break;
                    }
                    let _e472 = local_16[_e457];
                    if _e462 {
                    } else {
                        break;
                    }
                    let _e474 = local_16[_e461];
                    if _e466 {
                    } else {
                        break;
                    }
                    let _e476 = local_16[_e465];
                    phi_5034_ = false;
                    phi_5025_ = _e451;
                    phi_2903_ = type_52(type_43(array<f32, 3>(_e460, _e464, _e468), array<f32, 3>(_e472, _e474, _e476)), select(0u, 2147483648u, (_e90 == 0u)));
                    phi_2906_ = ((3u * _e90) + 1u);
                    phi_2908_ = (_e453 <= _e451);
                    phi_2910_ = 0u;
                    loop {
                        let _e484 = phi_5034_;
                        let _e486 = phi_5025_;
                        let _e488 = phi_2903_;
                        let _e490 = phi_2906_;
                        let _e492 = phi_2908_;
                        let _e494 = phi_2910_;
                        if _e492 {
                            phi_2921_ = true;
                        } else {
                            phi_2921_ = (_e494 > 0u);
                        }
                        let _e497 = phi_2921_;
                        if _e497 {
                            let _e498 = (_e490 > 0u);
                            if _e498 {
                                if _e492 {
                                    phi_2967_ = _e488;
                                    phi_2968_ = _e492;
                                    phi_2969_ = _e494;
                                } else {
                                    let _e499 = (_e494 - 1u);
                                    let _e500 = (_e499 % 128u);
                                    let _e501 = (_e500 < 128u);
                                    if _e501 {
                                    } else {
                                        phi_5205_ = true;
                                        break;
                                    }
                                    let _e503 = local_6[_e500];
                                    if _e501 {
                                    } else {
                                        phi_5205_ = true;
                                        break;
                                    }
                                    let _e519 = local_5[_e500];
                                    phi_2967_ = type_52(type_43(array<f32, 3>(_e503.member.member[0], _e503.member.member[1], _e503.member.member[2]), array<f32, 3>(_e503.member.member_1[0], _e503.member.member_1[1], _e503.member.member_1[2])), _e503.member_1);
                                    phi_2968_ = (_e519 <= _e486);
                                    phi_2969_ = _e499;
                                }
                                let _e522 = phi_2967_;
                                let _e524 = phi_2968_;
                                let _e526 = phi_2969_;
                                if _e524 {
                                    if ((_e522.member_1 & 2147483648u) != 0u) {
                                        phi_5136_ = _e486;
                                        phi_5122_ = _e484;
                                        phi_2988_ = type_4(0u, ((_e522.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e847 = phi_5136_;
                                            let _e849 = phi_5122_;
                                            let _e851 = phi_2988_;
                                            if (_e851.member < _e851.member_1) {
                                                phi_2989_ = type_4((_e851.member + 1u), _e851.member_1);
                                                phi_3012_ = type_4(1u, _e851.member);
                                            } else {
                                                phi_2989_ = _e851;
                                                phi_3012_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e864 = phi_2989_;
                                            let _e866 = phi_3012_;
                                            let _e870 = (bitcast<i32>(_e866.member) != 0i);
                                            if _e870 {
                                                local_1 = array<f32, 3>(_e522.member.member[0], _e522.member.member[1], _e522.member.member[2]);
                                                local = array<f32, 3>(_e522.member.member_1[0], _e522.member.member_1[1], _e522.member.member_1[2]);
                                                let _e881 = ((_e522.member_1 & 268435455u) + _e866.member_1);
                                                let _e882 = (_e881 < arrayLength((&global_6.member)));
                                                if _e882 {
                                                    if _e882 {
                                                    } else {
                                                        phi_5289_ = _e847;
                                                        phi_5200_ = true;
                                                        break;
                                                    }
                                                    let _e885 = global_6.member[_e881].member_1;
                                                    phi_3054_ = _e885;
                                                } else {
                                                    phi_3054_ = 4294967295u;
                                                }
                                                let _e887 = phi_3054_;
                                                local_13 = array<u32, 3>(_e253, _e252, _e254);
                                                if _e882 {
                                                    if _e882 {
                                                    } else {
                                                        phi_5289_ = _e847;
                                                        phi_5200_ = true;
                                                        break;
                                                    }
                                                    let _e890 = global_6.member[_e881];
                                                    phi_3078_ = _e890;
                                                } else {
                                                    phi_3078_ = type_46(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e892 = phi_3078_;
                                                local_15 = array<u32, 3>(_e892.member[0], _e892.member[1], _e892.member[2]);
                                                local_14[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_14[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_14[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_5118_ = _e849;
                                                phi_3089_ = type_4(0u, 3u);
                                                loop {
                                                    let _e902 = phi_5118_;
                                                    let _e904 = phi_3089_;
                                                    if (_e904.member < _e904.member_1) {
                                                        phi_3090_ = type_4((_e904.member + 1u), _e904.member_1);
                                                        phi_3113_ = type_4(1u, _e904.member);
                                                    } else {
                                                        phi_3090_ = _e904;
                                                        phi_3113_ = type_4(0u, type_4().member_1);
                                                    }
                                                    let _e917 = phi_3090_;
                                                    let _e919 = phi_3113_;
                                                    let _e923 = (bitcast<i32>(_e919.member) != 0i);
                                                    if _e923 {
                                                        phi_3123_ = type_4(0u, 3u);
                                                        loop {
                                                            let _e925 = phi_3123_;
                                                            if (_e925.member < _e925.member_1) {
                                                                phi_3124_ = type_4((_e925.member + 1u), _e925.member_1);
                                                                phi_3147_ = type_4(1u, _e925.member);
                                                            } else {
                                                                phi_3124_ = _e925;
                                                                phi_3147_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e938 = phi_3124_;
                                                            let _e940 = phi_3147_;
                                                            let _e944 = (bitcast<i32>(_e940.member) != 0i);
                                                            if _e944 {
                                                                let _e945 = (_e919.member_1 < 3u);
                                                                if _e945 {
                                                                } else {
                                                                    phi_5113_ = true;
                                                                    break;
                                                                }
                                                                let _e947 = local_15[_e919.member_1];
                                                                let _e948 = (_e940.member_1 < 3u);
                                                                if _e948 {
                                                                } else {
                                                                    phi_5113_ = true;
                                                                    break;
                                                                }
                                                                let _e950 = local_13[_e940.member_1];
                                                                let _e955 = ((_e947 >> bitcast<u32>(((10u * _e950) & 31u))) & 1023u);
                                                                if _e948 {
                                                                } else {
                                                                    phi_5113_ = true;
                                                                    break;
                                                                }
                                                                let _e957 = local_1[_e940.member_1];
                                                                if _e948 {
                                                                } else {
                                                                    phi_5113_ = true;
                                                                    break;
                                                                }
                                                                let _e959 = local[_e940.member_1];
                                                                let _e970 = (_e957 + bitcast<f32>((bitcast<u32>((f32(_e955) * bitcast<f32>((bitcast<u32>(((_e959 - _e957) * 0.0009775171f)) ^ _e125)))) ^ _e125)));
                                                                if _e945 {
                                                                } else {
                                                                    phi_5113_ = true;
                                                                    break;
                                                                }
                                                                if _e948 {
                                                                } else {
                                                                    phi_5113_ = true;
                                                                    break;
                                                                }
                                                                local_14[_e919.member_1][_e940.member_1] = select(select(_e959, _e970, (_e970 < _e959)), _e959, (_e955 == 1023u));
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_3123_ = _e938;
                                                                phi_5113_ = _e902;
                                                                break if !(_e944);
                                                            }
                                                        }
                                                        let _e979 = phi_5113_;
                                                        phi_5125_ = _e979;
                                                        if _e979 {
                                                            break;
                                                        }
                                                        phi_5126_ = _e979;
                                                    } else {
                                                        phi_5126_ = _e902;
                                                    }
                                                    let _e981 = phi_5126_;
                                                    continue;
                                                    continuing {
                                                        phi_5118_ = _e981;
                                                        phi_3089_ = _e917;
                                                        phi_5125_ = _e981;
                                                        break if !(_e923);
                                                    }
                                                }
                                                let _e984 = phi_5125_;
                                                phi_5289_ = _e847;
                                                phi_5200_ = _e984;
                                                if _e984 {
                                                    break;
                                                }
                                                let _e985 = local_14;
                                                let _e1000 = (_e985[0][2] - _e379);
                                                let _e1003 = (((_e985[0][0] - _e302) * _e403) - (_e1000 * _e327));
                                                let _e1006 = (((_e985[0][1] - _e341) * _e403) - (_e1000 * _e365));
                                                let _e1009 = (_e985[1][2] - _e379);
                                                let _e1012 = (((_e985[1][0] - _e302) * _e403) - (_e1009 * _e327));
                                                let _e1015 = (((_e985[1][1] - _e341) * _e403) - (_e1009 * _e365));
                                                let _e1018 = (_e985[2][2] - _e379);
                                                let _e1021 = (((_e985[2][0] - _e302) * _e403) - (_e1018 * _e327));
                                                let _e1024 = (((_e985[2][1] - _e341) * _e403) - (_e1018 * _e365));
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
                                                        phi_3806_ = type_18();
                                                        phi_3807_ = true;
                                                    } else {
                                                        let _e1059 = select(_e985[1][0], _e985[0][0], (_e985[0][0] < _e985[1][0]));
                                                        let _e1063 = select(_e985[1][0], _e985[0][0], (_e985[0][0] > _e985[1][0]));
                                                        let _e1067 = select(_e985[1][1], _e985[0][1], (_e985[0][1] < _e985[1][1]));
                                                        let _e1071 = select(_e985[1][1], _e985[0][1], (_e985[0][1] > _e985[1][1]));
                                                        let _e1075 = select(_e985[1][2], _e985[0][2], (_e985[0][2] < _e985[1][2]));
                                                        let _e1079 = select(_e985[1][2], _e985[0][2], (_e985[0][2] > _e985[1][2]));
                                                        let _e1084 = ((select(_e985[2][0], _e1059, (_e1059 < _e985[2][0])) - _e325) * _e330);
                                                        let _e1085 = ((select(_e985[2][0], _e1063, (_e1063 > _e985[2][0])) - _e326) * _e330);
                                                        let _e1088 = ((select(_e985[2][1], _e1067, (_e1067 < _e985[2][1])) - _e363) * _e368);
                                                        let _e1089 = ((select(_e985[2][1], _e1071, (_e1071 > _e985[2][1])) - _e364) * _e368);
                                                        let _e1092 = ((select(_e985[2][2], _e1075, (_e1075 < _e985[2][2])) - _e401) * _e406);
                                                        let _e1093 = ((select(_e985[2][2], _e1079, (_e1079 > _e985[2][2])) - _e402) * _e406);
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
                                                        let _e1120 = select(_e453, _e1105, (_e1105 > _e453));
                                                        if (_e1120 > (_e1113 + (select(_e1114, _e1097, (_e1097 > _e1114)) * 0.0000019073523f))) {
                                                            phi_3801_ = type_18();
                                                            phi_3802_ = true;
                                                        } else {
                                                            let _e1122 = (_e1120 > _e847);
                                                            if _e1122 {
                                                                phi_3800_ = type_18();
                                                            } else {
                                                                let _e1126 = (_e985[1][0] - _e985[0][0]);
                                                                let _e1127 = (_e985[1][1] - _e985[0][1]);
                                                                let _e1128 = (_e985[1][2] - _e985[0][2]);
                                                                let _e1129 = vec3<f32>(_e1126, _e1127, _e1128);
                                                                let _e1130 = (_e985[2][0] - _e985[1][0]);
                                                                let _e1131 = (_e985[2][1] - _e985[1][1]);
                                                                let _e1132 = (_e985[2][2] - _e985[1][2]);
                                                                let _e1133 = vec3<f32>(_e1130, _e1131, _e1132);
                                                                let _e1134 = (_e985[0][0] - _e985[2][0]);
                                                                let _e1135 = (_e985[0][1] - _e985[2][1]);
                                                                let _e1136 = (_e985[0][2] - _e985[2][2]);
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
                                                                    phi_3711_ = _e1133;
                                                                    phi_3712_ = _e1137;
                                                                } else {
                                                                    let _e1183 = vec3((_e1163 == _e1180));
                                                                    phi_3711_ = select(_e1129, _e1137, _e1183);
                                                                    phi_3712_ = select(_e1133, _e1129, _e1183);
                                                                }
                                                                let _e1187 = phi_3711_;
                                                                let _e1189 = phi_3712_;
                                                                let _e1196 = ((_e1187.y * _e1189.z) - (_e1189.y * _e1187.z));
                                                                let _e1201 = ((_e1187.z * _e1189.x) - (_e1189.z * _e1187.x));
                                                                let _e1204 = ((_e1187.x * _e1189.y) - (_e1189.x * _e1187.y));
                                                                if (_e1046 >= _e1050) {
                                                                    phi_3743_ = select(true, false, (_e1046 >= _e1054));
                                                                } else {
                                                                    phi_3743_ = true;
                                                                }
                                                                let _e1209 = phi_3743_;
                                                                if _e1209 {
                                                                    phi_3752_ = select(vec3<f32>(_e985[2][0], _e985[2][1], _e985[2][2]), vec3<f32>(_e985[1][0], _e985[1][1], _e985[1][2]), vec3((_e1050 >= _e1054)));
                                                                } else {
                                                                    phi_3752_ = vec3<f32>(_e985[0][0], _e985[0][1], _e985[0][2]);
                                                                }
                                                                let _e1214 = phi_3752_;
                                                                let _e1231 = ((((_e1196 * (_e1214.x - _e302)) + (_e1201 * (_e1214.y - _e341))) + (_e1204 * (_e1214.z - _e379))) / (((_e1196 * _e327) + (_e1201 * _e365)) + (_e1204 * _e403)));
                                                                let _e1233 = select(_e1113, _e1231, (_e1231 < _e1113));
                                                                let _e1235 = select(_e1105, _e1233, (_e1233 > _e1105));
                                                                if (_e1235 >= _e453) {
                                                                    let _e1237 = (_e1235 <= _e847);
                                                                    if _e1237 {
                                                                        let _e1238 = (1f / _e1056);
                                                                        phi_3792_ = type_18(_e1235, (_e1050 * _e1238), (_e1054 * _e1238), _e887);
                                                                    } else {
                                                                        phi_3792_ = type_18();
                                                                    }
                                                                    let _e1243 = phi_3792_;
                                                                    phi_3794_ = _e1243;
                                                                    phi_3795_ = select(true, false, _e1237);
                                                                } else {
                                                                    phi_3794_ = type_18();
                                                                    phi_3795_ = true;
                                                                }
                                                                let _e1246 = phi_3794_;
                                                                let _e1248 = phi_3795_;
                                                                if _e1248 {
                                                                    phi_3799_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_3799_ = _e1246;
                                                                }
                                                                let _e1250 = phi_3799_;
                                                                phi_3800_ = _e1250;
                                                            }
                                                            let _e1252 = phi_3800_;
                                                            phi_3801_ = _e1252;
                                                            phi_3802_ = _e1122;
                                                        }
                                                        let _e1254 = phi_3801_;
                                                        let _e1256 = phi_3802_;
                                                        phi_3806_ = _e1254;
                                                        phi_3807_ = _e1256;
                                                    }
                                                    let _e1258 = phi_3806_;
                                                    let _e1260 = phi_3807_;
                                                    phi_3811_ = _e1258;
                                                    phi_3812_ = _e1260;
                                                } else {
                                                    phi_3811_ = type_18();
                                                    phi_3812_ = true;
                                                }
                                                let _e1262 = phi_3811_;
                                                let _e1264 = phi_3812_;
                                                if _e1264 {
                                                    phi_3816_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_3816_ = _e1262;
                                                }
                                                let _e1266 = phi_3816_;
                                                if (_e1266.member_3 != 4294967295u) {
                                                    if (_e887 != 4294967295u) {
                                                        phi_3828_ = type_4(0u, 8u);
                                                        phi_3831_ = _e1266;
                                                        loop {
                                                            let _e1271 = phi_3828_;
                                                            let _e1273 = phi_3831_;
                                                            if (_e1271.member < _e1271.member_1) {
                                                                phi_3829_ = type_4((_e1271.member + 1u), _e1271.member_1);
                                                                phi_3854_ = type_4(1u, _e1271.member);
                                                            } else {
                                                                phi_3829_ = _e1271;
                                                                phi_3854_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1286 = phi_3829_;
                                                            let _e1288 = phi_3854_;
                                                            let _e1292 = (bitcast<i32>(_e1288.member) != 0i);
                                                            if _e1292 {
                                                                let _e1293 = (_e1288.member_1 < 8u);
                                                                if _e1293 {
                                                                } else {
                                                                    phi_5141_ = true;
                                                                    break;
                                                                }
                                                                let _e1298 = local_4[_e1288.member_1].member;
                                                                if (_e1273.member < _e1298) {
                                                                    phi_3887_ = true;
                                                                } else {
                                                                    let _e1300 = local_4[_e1288.member_1].member;
                                                                    if (_e1273.member == _e1300) {
                                                                        let _e1305 = local_4[_e1288.member_1].member_3;
                                                                        phi_3886_ = (_e1273.member_3 < _e1305);
                                                                    } else {
                                                                        phi_3886_ = false;
                                                                    }
                                                                    let _e1308 = phi_3886_;
                                                                    phi_3887_ = _e1308;
                                                                }
                                                                let _e1310 = phi_3887_;
                                                                if _e1310 {
                                                                    if _e1293 {
                                                                    } else {
                                                                        phi_5141_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1311 = local_4[_e1288.member_1];
                                                                    local_4[_e1288.member_1] = type_18(_e1273.member, _e1273.member_1, _e1273.member_2, _e1273.member_3);
                                                                    phi_3908_ = type_18(_e1311.member, _e1311.member_1, _e1311.member_2, _e1311.member_3);
                                                                } else {
                                                                    phi_3908_ = _e1273;
                                                                }
                                                                let _e1322 = phi_3908_;
                                                                phi_3832_ = _e1322;
                                                            } else {
                                                                phi_3832_ = type_18();
                                                            }
                                                            let _e1324 = phi_3832_;
                                                            continue;
                                                            continuing {
                                                                phi_3828_ = _e1286;
                                                                phi_3831_ = _e1324;
                                                                phi_5141_ = _e984;
                                                                break if !(_e1292);
                                                            }
                                                        }
                                                        let _e1327 = phi_5141_;
                                                        phi_5289_ = _e847;
                                                        phi_5200_ = _e1327;
                                                        if _e1327 {
                                                            break;
                                                        }
                                                        let _e1330 = local_4[7u].member_3;
                                                        if (_e1330 != 4294967295u) {
                                                            let _e1334 = local_4[7u].member;
                                                            phi_5352_ = _e1334;
                                                        } else {
                                                            phi_5352_ = _e847;
                                                        }
                                                        let _e1336 = phi_5352_;
                                                        phi_5351_ = _e1336;
                                                        phi_5203_ = _e1327;
                                                    } else {
                                                        phi_5351_ = _e847;
                                                        phi_5203_ = _e984;
                                                    }
                                                    let _e1338 = phi_5351_;
                                                    let _e1340 = phi_5203_;
                                                    phi_5350_ = _e1338;
                                                    phi_5202_ = _e1340;
                                                } else {
                                                    phi_5350_ = _e847;
                                                    phi_5202_ = _e984;
                                                }
                                                let _e1342 = phi_5350_;
                                                let _e1344 = phi_5202_;
                                                phi_5349_ = _e1342;
                                                phi_5201_ = _e1344;
                                            } else {
                                                phi_5349_ = _e847;
                                                phi_5201_ = _e849;
                                            }
                                            let _e1346 = phi_5349_;
                                            let _e1348 = phi_5201_;
                                            continue;
                                            continuing {
                                                phi_5136_ = _e1346;
                                                phi_5122_ = _e1348;
                                                phi_2988_ = _e864;
                                                phi_5289_ = _e1346;
                                                phi_5200_ = _e1348;
                                                break if !(_e870);
                                            }
                                        }
                                        let _e1351 = phi_5289_;
                                        let _e1353 = phi_5200_;
                                        phi_5205_ = _e1353;
                                        if _e1353 {
                                            break;
                                        }
                                        phi_5254_ = _e1351;
                                        phi_5209_ = _e1353;
                                        phi_4764_ = _e522;
                                        phi_4765_ = false;
                                        phi_4766_ = _e526;
                                    } else {
                                        local_3 = array<f32, 3>(_e522.member.member[0], _e522.member.member[1], _e522.member.member[2]);
                                        local_2 = array<f32, 3>(_e522.member.member_1[0], _e522.member.member_1[1], _e522.member.member_1[2]);
                                        let _e546 = (_e522.member_1 < _e90);
                                        if _e546 {
                                            if _e546 {
                                            } else {
                                                phi_5205_ = true;
                                                break;
                                            }
                                            let _e548 = global_4.member[_e522.member_1];
                                            phi_3953_ = _e548;
                                        } else {
                                            phi_3953_ = type_38(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e550 = phi_3953_;
                                        let _e552 = array<u32, 3>(_e253, _e252, _e254);
                                        local_12 = _e552;
                                        local_8 = array<f32, 3>(0f, 0f, 0f);
                                        local_7 = array<f32, 3>(0f, 0f, 0f);
                                        phi_3962_ = type_4(0u, 3u);
                                        loop {
                                            let _e554 = phi_3962_;
                                            if (_e554.member < _e554.member_1) {
                                                phi_3963_ = type_4((_e554.member + 1u), _e554.member_1);
                                                phi_3986_ = type_4(1u, _e554.member);
                                            } else {
                                                phi_3963_ = _e554;
                                                phi_3986_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e567 = phi_3963_;
                                            let _e569 = phi_3986_;
                                            let _e573 = (bitcast<i32>(_e569.member) != 0i);
                                            if _e573 {
                                                let _e574 = (_e569.member_1 < 3u);
                                                if _e574 {
                                                } else {
                                                    phi_5027_ = true;
                                                    break;
                                                }
                                                let _e576 = local_12[_e569.member_1];
                                                if _e574 {
                                                } else {
                                                    phi_5027_ = true;
                                                    break;
                                                }
                                                let _e578 = local_3[_e569.member_1];
                                                if _e574 {
                                                } else {
                                                    phi_5027_ = true;
                                                    break;
                                                }
                                                let _e580 = local_2[_e569.member_1];
                                                let _e583 = ((10u * _e576) & 31u);
                                                let _e586 = ((_e550.member[0] >> bitcast<u32>(_e583)) & 1023u);
                                                let _e591 = bitcast<f32>((bitcast<u32>(((_e580 - _e578) * 0.0009775171f)) ^ _e125));
                                                let _e597 = (_e578 + bitcast<f32>((bitcast<u32>((f32(_e586) * _e591)) ^ _e125)));
                                                if _e574 {
                                                } else {
                                                    phi_5027_ = true;
                                                    break;
                                                }
                                                local_8[_e569.member_1] = select(select(_e580, _e597, (_e597 < _e580)), _e580, (_e586 == 1023u));
                                                let _e606 = ((_e550.member[1] >> bitcast<u32>(_e583)) & 1023u);
                                                let _e612 = (_e578 + bitcast<f32>((bitcast<u32>((f32(_e606) * _e591)) ^ _e125)));
                                                if _e574 {
                                                } else {
                                                    phi_5027_ = true;
                                                    break;
                                                }
                                                local_7[_e569.member_1] = select(select(_e580, _e612, (_e612 < _e580)), _e580, (_e606 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_3962_ = _e567;
                                                phi_5027_ = _e484;
                                                break if !(_e573);
                                            }
                                        }
                                        let _e620 = phi_5027_;
                                        phi_5205_ = _e620;
                                        if _e620 {
                                            break;
                                        }
                                        let _e621 = local_7;
                                        let _e622 = local_8;
                                        local_11 = _e552;
                                        local_10 = array<f32, 3>(0f, 0f, 0f);
                                        local_9 = array<f32, 3>(0f, 0f, 0f);
                                        phi_4116_ = type_4(0u, 3u);
                                        loop {
                                            let _e631 = phi_4116_;
                                            if (_e631.member < _e631.member_1) {
                                                phi_4117_ = type_4((_e631.member + 1u), _e631.member_1);
                                                phi_4140_ = type_4(1u, _e631.member);
                                            } else {
                                                phi_4117_ = _e631;
                                                phi_4140_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e644 = phi_4117_;
                                            let _e646 = phi_4140_;
                                            let _e650 = (bitcast<i32>(_e646.member) != 0i);
                                            if _e650 {
                                                let _e651 = (_e646.member_1 < 3u);
                                                if _e651 {
                                                } else {
                                                    phi_5087_ = true;
                                                    break;
                                                }
                                                let _e653 = local_11[_e646.member_1];
                                                if _e651 {
                                                } else {
                                                    phi_5087_ = true;
                                                    break;
                                                }
                                                let _e655 = local_3[_e646.member_1];
                                                if _e651 {
                                                } else {
                                                    phi_5087_ = true;
                                                    break;
                                                }
                                                let _e657 = local_2[_e646.member_1];
                                                let _e660 = ((10u * _e653) & 31u);
                                                let _e663 = ((_e550.member_1[0] >> bitcast<u32>(_e660)) & 1023u);
                                                let _e668 = bitcast<f32>((bitcast<u32>(((_e657 - _e655) * 0.0009775171f)) ^ _e125));
                                                let _e674 = (_e655 + bitcast<f32>((bitcast<u32>((f32(_e663) * _e668)) ^ _e125)));
                                                if _e651 {
                                                } else {
                                                    phi_5087_ = true;
                                                    break;
                                                }
                                                local_10[_e646.member_1] = select(select(_e657, _e674, (_e674 < _e657)), _e657, (_e663 == 1023u));
                                                let _e683 = ((_e550.member_1[1] >> bitcast<u32>(_e660)) & 1023u);
                                                let _e689 = (_e655 + bitcast<f32>((bitcast<u32>((f32(_e683) * _e668)) ^ _e125)));
                                                if _e651 {
                                                } else {
                                                    phi_5087_ = true;
                                                    break;
                                                }
                                                local_9[_e646.member_1] = select(select(_e657, _e689, (_e689 < _e657)), _e657, (_e683 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_4116_ = _e644;
                                                phi_5087_ = _e620;
                                                break if !(_e650);
                                            }
                                        }
                                        let _e697 = phi_5087_;
                                        phi_5205_ = _e697;
                                        if _e697 {
                                            break;
                                        }
                                        let _e698 = local_9;
                                        let _e699 = local_10;
                                        let _e710 = type_52(type_43(array<f32, 3>(_e622[0], _e622[1], _e622[2]), array<f32, 3>(_e621[0], _e621[1], _e621[2])), _e550.member_2);
                                        let _e715 = type_52(type_43(array<f32, 3>(_e699[0], _e699[1], _e699[2]), array<f32, 3>(_e698[0], _e698[1], _e698[2])), _e550.member_3);
                                        let _e720 = ((_e622[0] - _e325) * _e330);
                                        let _e721 = ((_e699[0] - _e325) * _e330);
                                        let _e722 = ((_e621[0] - _e326) * _e330);
                                        let _e723 = ((_e698[0] - _e326) * _e330);
                                        let _e728 = ((_e622[1] - _e363) * _e368);
                                        let _e729 = ((_e699[1] - _e363) * _e368);
                                        let _e730 = ((_e621[1] - _e364) * _e368);
                                        let _e731 = ((_e698[1] - _e364) * _e368);
                                        let _e736 = ((_e622[2] - _e401) * _e406);
                                        let _e737 = ((_e699[2] - _e401) * _e406);
                                        let _e738 = ((_e621[2] - _e402) * _e406);
                                        let _e739 = ((_e698[2] - _e402) * _e406);
                                        let _e741 = select(_e738, _e736, (_e736 < _e738));
                                        let _e743 = select(_e739, _e737, (_e737 < _e739));
                                        let _e745 = select(_e738, _e736, (_e736 > _e738));
                                        let _e747 = select(_e739, _e737, (_e737 > _e739));
                                        let _e749 = select(_e722, _e720, (_e720 < _e722));
                                        let _e751 = select(_e723, _e721, (_e721 < _e723));
                                        let _e753 = select(_e730, _e728, (_e728 < _e730));
                                        let _e755 = select(_e731, _e729, (_e729 < _e731));
                                        let _e757 = select(_e753, _e749, (_e749 > _e753));
                                        let _e759 = select(_e755, _e751, (_e751 > _e755));
                                        let _e761 = select(_e741, _e757, (_e757 > _e741));
                                        let _e763 = select(_e743, _e759, (_e759 > _e743));
                                        let _e765 = select(_e722, _e720, (_e720 > _e722));
                                        let _e767 = select(_e723, _e721, (_e721 > _e723));
                                        let _e769 = select(_e730, _e728, (_e728 > _e730));
                                        let _e771 = select(_e731, _e729, (_e729 > _e731));
                                        let _e773 = select(_e769, _e765, (_e765 < _e769));
                                        let _e775 = select(_e771, _e767, (_e767 < _e771));
                                        let _e780 = -(_e741);
                                        let _e781 = -(_e743);
                                        let _e788 = (select(_e745, _e773, (_e773 < _e745)) + (select(_e780, _e745, (_e745 > _e780)) * 0.0000019073523f));
                                        let _e789 = (select(_e747, _e775, (_e775 < _e747)) + (select(_e781, _e747, (_e747 > _e781)) * 0.0000019073523f));
                                        let _e791 = select(_e453, _e761, (_e761 > _e453));
                                        let _e793 = select(_e453, _e763, (_e763 > _e453));
                                        let _e798 = (_e791 <= select(_e486, _e788, (_e788 < _e486)));
                                        let _e799 = (_e793 <= select(_e486, _e789, (_e789 < _e486)));
                                        let _e800 = (_e791 <= _e793);
                                        if _e798 {
                                            if _e799 {
                                                if _e800 {
                                                    phi_4704_ = _e715;
                                                } else {
                                                    phi_4704_ = _e710;
                                                }
                                                let _e802 = phi_4704_;
                                                let _e803 = (_e526 % 128u);
                                                let _e804 = (_e803 < 128u);
                                                if _e804 {
                                                } else {
                                                    phi_5205_ = true;
                                                    break;
                                                }
                                                local_6[_e803] = type_52(type_43(array<f32, 3>(_e802.member.member[0], _e802.member.member[1], _e802.member.member[2]), array<f32, 3>(_e802.member.member_1[0], _e802.member.member_1[1], _e802.member.member_1[2])), _e802.member_1);
                                                if _e804 {
                                                } else {
                                                    phi_5205_ = true;
                                                    break;
                                                }
                                                local_5[_e803] = select(_e793, _e791, (_e791 > _e793));
                                                if _e800 {
                                                    phi_4743_ = _e710;
                                                } else {
                                                    phi_4743_ = _e715;
                                                }
                                                let _e825 = phi_4743_;
                                                phi_4744_ = _e825;
                                                phi_4745_ = (_e526 + 1u);
                                            } else {
                                                phi_4744_ = type_52();
                                                phi_4745_ = u32();
                                            }
                                            let _e827 = phi_4744_;
                                            let _e829 = phi_4745_;
                                            phi_4747_ = _e827;
                                            phi_4748_ = _e829;
                                            phi_4749_ = select(true, false, _e799);
                                        } else {
                                            phi_4747_ = type_52();
                                            phi_4748_ = u32();
                                            phi_4749_ = true;
                                        }
                                        let _e832 = phi_4747_;
                                        let _e834 = phi_4748_;
                                        let _e836 = phi_4749_;
                                        if _e836 {
                                            if _e798 {
                                                phi_4756_ = _e710;
                                            } else {
                                                phi_4756_ = _e715;
                                            }
                                            let _e838 = phi_4756_;
                                            phi_4761_ = _e838;
                                            phi_4762_ = select(_e799, true, _e798);
                                        } else {
                                            phi_4761_ = _e832;
                                            phi_4762_ = _e524;
                                        }
                                        let _e841 = phi_4761_;
                                        let _e843 = phi_4762_;
                                        phi_5254_ = _e486;
                                        phi_5209_ = _e697;
                                        phi_4764_ = _e841;
                                        phi_4765_ = _e843;
                                        phi_4766_ = select(_e834, _e526, _e836);
                                    }
                                    let _e1355 = phi_5254_;
                                    let _e1357 = phi_5209_;
                                    let _e1359 = phi_4764_;
                                    let _e1361 = phi_4765_;
                                    let _e1363 = phi_4766_;
                                    phi_5253_ = _e1355;
                                    phi_5208_ = _e1357;
                                    phi_4767_ = _e1359;
                                    phi_4768_ = (_e490 - 1u);
                                    phi_4769_ = _e1361;
                                    phi_4770_ = _e1363;
                                } else {
                                    phi_5253_ = _e486;
                                    phi_5208_ = _e484;
                                    phi_4767_ = _e522;
                                    phi_4768_ = _e490;
                                    phi_4769_ = _e524;
                                    phi_4770_ = _e526;
                                }
                                let _e1365 = phi_5253_;
                                let _e1367 = phi_5208_;
                                let _e1369 = phi_4767_;
                                let _e1371 = phi_4768_;
                                let _e1373 = phi_4769_;
                                let _e1375 = phi_4770_;
                                phi_5252_ = _e1365;
                                phi_5207_ = _e1367;
                                phi_4771_ = _e1369;
                                phi_4772_ = _e1371;
                                phi_4773_ = _e1373;
                                phi_4774_ = _e1375;
                            } else {
                                phi_5252_ = _e486;
                                phi_5207_ = _e484;
                                phi_4771_ = type_52();
                                phi_4772_ = u32();
                                phi_4773_ = bool();
                                phi_4774_ = u32();
                            }
                            let _e1377 = phi_5252_;
                            let _e1379 = phi_5207_;
                            let _e1381 = phi_4771_;
                            let _e1383 = phi_4772_;
                            let _e1385 = phi_4773_;
                            let _e1387 = phi_4774_;
                            phi_5251_ = _e1377;
                            phi_5206_ = _e1379;
                            phi_2904_ = _e1381;
                            phi_2907_ = _e1383;
                            phi_2909_ = _e1385;
                            phi_2911_ = _e1387;
                            phi_4775_ = _e498;
                        } else {
                            phi_5251_ = _e486;
                            phi_5206_ = _e484;
                            phi_2904_ = type_52();
                            phi_2907_ = u32();
                            phi_2909_ = bool();
                            phi_2911_ = u32();
                            phi_4775_ = false;
                        }
                        let _e1389 = phi_5251_;
                        let _e1391 = phi_5206_;
                        let _e1393 = phi_2904_;
                        let _e1395 = phi_2907_;
                        let _e1397 = phi_2909_;
                        let _e1399 = phi_2911_;
                        let _e1401 = phi_4775_;
                        continue;
                        continuing {
                            phi_5034_ = _e1391;
                            phi_5025_ = _e1389;
                            phi_2903_ = _e1393;
                            phi_2906_ = _e1395;
                            phi_2908_ = _e1397;
                            phi_2910_ = _e1399;
                            phi_5205_ = _e1391;
                            break if !(_e1401);
                        }
                    }
                    let _e1404 = phi_5205_;
                    if _e1404 {
                        break;
                    }
                    phi_4782_ = type_4(0u, 8u);
                    loop {
                        let _e1406 = phi_4782_;
                        if (_e1406.member < _e1406.member_1) {
                            phi_4783_ = type_4((_e1406.member + 1u), _e1406.member_1);
                            phi_4806_ = type_4(1u, _e1406.member);
                        } else {
                            phi_4783_ = _e1406;
                            phi_4806_ = type_4(0u, type_4().member_1);
                        }
                        let _e1419 = phi_4783_;
                        let _e1421 = phi_4806_;
                        let _e1425 = (bitcast<i32>(_e1421.member) != 0i);
                        if _e1425 {
                            let _e1426 = (_e1421.member_1 < 8u);
                            if _e1426 {
                            } else {
                                phi_5244_ = true;
                                break;
                            }
                            let _e1428 = local_4[_e1421.member_1];
                            if (_e1428.member_3 != 4294967295u) {
                                let _e1434 = -(_e420);
                                let _e1435 = (_e1434 / 3i);
                                let _e1442 = bitcast<f32>((bitcast<u32>((_e1435 + 127i)) << bitcast<u32>(23i)));
                                let _e1450 = (((_e1428.member * _e1442) * _e1442) * bitcast<f32>((bitcast<u32>(((_e1434 - (2i * _e1435)) + 127i)) << bitcast<u32>(23i))));
                                let _e1452 = select(340282350000000000000000000000000000000f, _e1450, (_e1450 < 340282350000000000000000000000000000000f));
                                phi_4872_ = type_18(select(-340282350000000000000000000000000000000f, _e1452, (_e1452 > -340282350000000000000000000000000000000f)), _e1428.member_1, _e1428.member_2, _e1428.member_3);
                            } else {
                                phi_4872_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1457 = phi_4872_;
                            if _e1426 {
                            } else {
                                phi_5244_ = true;
                                break;
                            }
                            local_4[_e1421.member_1] = type_18(_e1457.member, _e1457.member_1, _e1457.member_2, _e1457.member_3);
                        }
                        continue;
                        continuing {
                            phi_4782_ = _e1419;
                            phi_5244_ = _e1404;
                            break if !(_e1425);
                        }
                    }
                    let _e1465 = phi_5244_;
                    if _e1465 {
                        break;
                    }
                    let _e1466 = local_4;
                    if _e141 {
                    } else {
                        break;
                    }
                    global_5.member[_e139] = array<type_18, 8>(type_18(_e1466[0].member, _e1466[0].member_1, _e1466[0].member_2, _e1466[0].member_3), type_18(_e1466[1].member, _e1466[1].member_1, _e1466[1].member_2, _e1466[1].member_3), type_18(_e1466[2].member, _e1466[2].member_1, _e1466[2].member_2, _e1466[2].member_3), type_18(_e1466[3].member, _e1466[3].member_1, _e1466[3].member_2, _e1466[3].member_3), type_18(_e1466[4].member, _e1466[4].member_1, _e1466[4].member_2, _e1466[4].member_3), type_18(_e1466[5].member, _e1466[5].member_1, _e1466[5].member_2, _e1466[5].member_3), type_18(_e1466[6].member, _e1466[6].member_1, _e1466[6].member_2, _e1466[6].member_3), type_18(_e1466[7].member, _e1466[7].member_1, _e1466[7].member_2, _e1466[7].member_3));
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
