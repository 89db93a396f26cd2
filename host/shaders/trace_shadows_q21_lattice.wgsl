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

struct type_23 {
    member: type_22,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_25 {
    member: array<type_23>,
}

struct type_30 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_31 {
    member: type_22,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_33 {
    member: array<type_31>,
}

struct type_37 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_41 {
    member: f32,
    member_1: bool,
}

struct type_43 {
    member: array<vec4<u32>, 2>,
}

struct type_46 {
    member: array<i32>,
}

struct type_55 {
    member: array<array<u32, 7>>,
}

struct type_60 {
    member: type_30,
    member_1: u32,
}

struct type_63 {
    member: array<vec4<f32>, 3>,
    member_1: type_60,
    member_2: type_60,
}

struct type_70 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(8) 
var<storage, read_write> global_2: type_25;
@group(0) @binding(1) 
var<uniform> global_3: type_43;
@group(0) @binding(2) 
var<uniform> global_4: type_43;
@group(0) @binding(5) 
var<storage> global_5: type_4;
@group(0) @binding(6) 
var<storage> global_6: type_46;
@group(0) @binding(9) 
var<storage, read_write> global_7: type_70;
@group(0) @binding(3) 
var<storage> global_8: type_55;
@group(0) @binding(7) 
var<storage> global_9: type_33;
@group(0) @binding(4) 
var<storage> global_10: type_4;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<type_60, 128>;
    var local_4: array<u32, 3>;
    var local_5: array<array<f32, 3>, 3>;
    var local_6: array<f32, 4>;
    var phi_341_: u32;
    var phi_406_: type_37;
    var phi_556_: i32;
    var phi_557_: i32;
    var phi_567_: bool;
    var phi_577_: u32;
    var phi_578_: u32;
    var phi_580_: bool;
    var phi_585_: u32;
    var phi_630_: f32;
    var phi_636_: f32;
    var phi_647_: f32;
    var phi_653_: f32;
    var phi_676_: f32;
    var phi_687_: f32;
    var phi_696_: f32;
    var phi_702_: f32;
    var phi_713_: f32;
    var phi_719_: f32;
    var phi_742_: f32;
    var phi_753_: f32;
    var phi_762_: f32;
    var phi_768_: f32;
    var phi_779_: f32;
    var phi_785_: f32;
    var phi_808_: f32;
    var phi_819_: f32;
    var phi_919_: f32;
    var phi_920_: f32;
    var phi_4997_: bool;
    var phi_2040_: type_41;
    var phi_2043_: type_60;
    var phi_2045_: u32;
    var phi_2047_: bool;
    var phi_2049_: u32;
    var phi_2060_: bool;
    var phi_2097_: type_60;
    var phi_2098_: bool;
    var phi_2099_: u32;
    var phi_4025_: u32;
    var phi_4031_: u32;
    var phi_4285_: u32;
    var phi_4286_: u32;
    var phi_4296_: u32;
    var phi_4298_: u32;
    var phi_4299_: bool;
    var phi_4319_: u32;
    var phi_4320_: u32;
    var phi_4324_: type_63;
    var phi_4668_: type_60;
    var phi_4701_: type_60;
    var phi_4702_: type_60;
    var phi_4703_: u32;
    var phi_4705_: type_60;
    var phi_4706_: u32;
    var phi_4707_: bool;
    var phi_4716_: type_60;
    var phi_4721_: type_60;
    var phi_4722_: bool;
    var phi_4994_: bool;
    var phi_2118_: type_41;
    var phi_2121_: type_8;
    var phi_2122_: type_8;
    var phi_2144_: type_8;
    var phi_2185_: u32;
    var phi_2191_: u32;
    var phi_2201_: u32;
    var phi_2217_: u32;
    var phi_2254_: u32;
    var phi_2260_: u32;
    var phi_2270_: u32;
    var phi_4979_: bool;
    var phi_2286_: type_8;
    var phi_2287_: type_8;
    var phi_2310_: type_8;
    var phi_2333_: u32;
    var phi_2348_: u32;
    var phi_2351_: type_8;
    var phi_2352_: type_8;
    var phi_2375_: type_8;
    var phi_2441_: u32;
    var phi_2421_: u32;
    var phi_2422_: u32;
    var phi_2445_: f32;
    var phi_4972_: bool;
    var phi_5052_: bool;
    var phi_5051_: bool;
    var phi_2945_: vec3<f32>;
    var phi_2946_: vec3<f32>;
    var phi_2977_: bool;
    var phi_2986_: vec3<f32>;
    var phi_3026_: type_21;
    var phi_3028_: type_21;
    var phi_3029_: bool;
    var phi_3033_: type_21;
    var phi_3034_: type_21;
    var phi_3035_: type_21;
    var phi_3036_: bool;
    var phi_3040_: type_21;
    var phi_3041_: bool;
    var phi_3045_: type_21;
    var phi_3046_: bool;
    var phi_3050_: type_21;
    var phi_3073_: u32;
    var phi_3087_: i32;
    var phi_3107_: vec3<f32>;
    var phi_3108_: vec3<f32>;
    var phi_3124_: vec3<f32>;
    var phi_3125_: vec3<f32>;
    var phi_3141_: vec3<f32>;
    var phi_3142_: vec3<f32>;
    var phi_3178_: vec3<f32>;
    var phi_3360_: f32;
    var phi_3378_: bool;
    var phi_3379_: bool;
    var phi_3384_: type_41;
    var phi_3385_: type_41;
    var phi_5054_: bool;
    var phi_2119_: type_41;
    var phi_5053_: bool;
    var local_7: type_41;
    var phi_5133_: bool;
    var phi_4724_: type_41;
    var phi_4725_: type_60;
    var phi_4726_: bool;
    var phi_4727_: u32;
    var phi_5132_: bool;
    var phi_4728_: type_41;
    var phi_4729_: type_60;
    var phi_4730_: u32;
    var phi_4731_: bool;
    var phi_4732_: u32;
    var phi_5131_: bool;
    var phi_4733_: type_41;
    var phi_4734_: type_60;
    var phi_4735_: u32;
    var phi_4736_: bool;
    var phi_4737_: u32;
    var phi_5130_: bool;
    var phi_2041_: type_41;
    var phi_2044_: type_60;
    var phi_2046_: u32;
    var phi_2048_: bool;
    var phi_2050_: u32;
    var phi_4738_: bool;
    var phi_5129_: bool;
    var local_8: type_41;
    var local_9: type_41;

    switch bitcast<i32>(0u) {
        default: {
            let _e96 = global;
            let _e98 = arrayLength((&global_8.member));
            let _e101 = arrayLength((&global_10.member));
            let _e113 = arrayLength((&global_7.member));
            let _e117 = global_4.member[0u][0u];
            let _e121 = global_4.member[0u][1u];
            let _e125 = global_4.member[0u][2u];
            let _e129 = global_4.member[0u][3u];
            let _e133 = global_4.member[1u][0u];
            let _e137 = global_4.member[1u][1u];
            let _e141 = global_4.member[1u][2u];
            let _e145 = (_e96.x + (_e96.y * 2097152u));
            let _e157 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e129) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e117), bitcast<i32>(_e121), bitcast<i32>(_e125));
            local = array<i32, 3>(bitcast<i32>(_e133), bitcast<i32>(_e137), bitcast<i32>(_e141));
            let _e160 = (_e145 < arrayLength((&global_9.member)));
            if _e160 {
                if _e160 {
                } else {
                    break;
                }
                let _e164 = global_9.member[_e145].member_2;
                phi_341_ = _e164;
            } else {
                phi_341_ = 4294967295u;
            }
            let _e166 = phi_341_;
            let _e169 = global_1.member[0u];
            let _e173 = global_3.member[0u][0u];
            let _e177 = global_3.member[0u][1u];
            let _e181 = global_3.member[0u][2u];
            let _e185 = global_3.member[0u][3u];
            let _e189 = global_3.member[1u][0u];
            let _e193 = global_3.member[1u][1u];
            let _e197 = global_3.member[1u][2u];
            let _e201 = global_3.member[1u][3u];
            let _e202 = bitcast<f32>(_e173);
            let _e203 = bitcast<f32>(_e177);
            let _e204 = bitcast<f32>(_e181);
            let _e206 = bitcast<f32>(_e189);
            let _e207 = array<u32, 3>(_e193, _e197, _e201);
            let _e209 = bitcast<i32>(_e169);
            let _e210 = (_e209 / 2i);
            let _e215 = bitcast<f32>((bitcast<u32>((_e210 + 127i)) << bitcast<u32>(23i)));
            let _e221 = bitcast<f32>((bitcast<u32>(((_e209 - _e210) + 127i)) << bitcast<u32>(23i)));
            if (_e185 == 0u) {
                phi_406_ = type_37(array<f32, 3>(_e202, _e203, _e204), _e185, _e206, _e207);
            } else {
                phi_406_ = type_37(array<f32, 3>(((_e202 * _e215) * _e221), ((_e203 * _e215) * _e221), ((_e204 * _e215) * _e221)), _e185, ((_e206 * _e215) * _e221), _e207);
            }
            let _e234 = phi_406_;
            if _e160 {
                let _e235 = (_e145 < arrayLength((&global_2.member)));
                if _e235 {
                    if _e160 {
                    } else {
                        break;
                    }
                    let _e240 = global_9.member[_e145].member.member_1;
                    let _e245 = global_9.member[_e145].member.member_3;
                    if (_e240 <= _e245) {
                        let _e247 = (1u < _e113);
                        if _e247 {
                            if (0u < _e113) {
                            } else {
                                break;
                            }
                            let _e251 = atomicAdd((&global_7.member[0u]), 1u);
                            if ((_e251 + 1u) < _e251) {
                                if _e247 {
                                } else {
                                    break;
                                }
                                let _e256 = atomicAdd((&global_7.member[1u]), 1u);
                            }
                        }
                        if _e160 {
                        } else {
                            break;
                        }
                        let _e266 = global_9.member[_e145].member.member_2[0u];
                        let _e268 = (bitcast<u32>(_e266) & 2147483647u);
                        let _e274 = global_9.member[_e145].member.member_2[1u];
                        let _e276 = (bitcast<u32>(_e274) & 2147483647u);
                        let _e282 = global_9.member[_e145].member.member_2[2u];
                        let _e284 = (bitcast<u32>(_e282) & 2147483647u);
                        let _e290 = global_9.member[_e145].member.member[0u];
                        let _e292 = (bitcast<u32>(_e290) & 2147483647u);
                        let _e298 = global_9.member[_e145].member.member[1u];
                        let _e300 = (bitcast<u32>(_e298) & 2147483647u);
                        let _e306 = global_9.member[_e145].member.member[2u];
                        let _e308 = (bitcast<u32>(_e306) & 2147483647u);
                        let _e310 = select(_e276, _e268, (_e276 < _e268));
                        let _e312 = select(_e284, _e310, (_e284 < _e310));
                        let _e314 = select(_e292, _e312, (_e292 < _e312));
                        let _e316 = select(_e300, _e314, (_e300 < _e314));
                        let _e318 = select(_e308, _e316, (_e308 < _e316));
                        let _e320 = (bitcast<u32>(_e240) & 2147483647u);
                        let _e329 = (((select(_e320, _e318, (_e320 < _e318)) < 2139095040u) && ((bitcast<u32>(_e245) & 2147483647u) <= 2139095040u)) && (_e312 > 0u));
                        if _e329 {
                            let _e332 = (bitcast<u32>(bitcast<f32>(_e312)) & 2147483647u);
                            if (_e332 >= 8388608u) {
                                phi_556_ = (bitcast<i32>((_e332 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_556_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e332)), 32u, (_e332 == 0u))));
                            }
                            let _e346 = phi_556_;
                            phi_557_ = _e346;
                        } else {
                            phi_557_ = 0i;
                        }
                        let _e348 = phi_557_;
                        let _e349 = (_e268 == _e312);
                        if _e349 {
                            phi_567_ = true;
                        } else {
                            phi_567_ = (_e276 == _e312);
                        }
                        let _e352 = phi_567_;
                        let _e353 = select(1u, 0u, _e349);
                        if _e352 {
                            let _e354 = (_e353 + 1u);
                            phi_577_ = _e354;
                            phi_578_ = _e354;
                            phi_580_ = select(true, false, (_e354 == 2u));
                        } else {
                            phi_577_ = u32();
                            phi_578_ = 0u;
                            phi_580_ = true;
                        }
                        let _e358 = phi_577_;
                        let _e360 = phi_578_;
                        let _e362 = phi_580_;
                        if _e362 {
                            phi_585_ = (_e360 + 1u);
                        } else {
                            phi_585_ = 0u;
                        }
                        let _e366 = phi_585_;
                        let _e367 = select(_e358, _e360, _e362);
                        let _e368 = select(_e353, select(2u, _e353, _e352), _e362);
                        let _e369 = -(_e348);
                        let _e370 = (_e369 / 2i);
                        let _e375 = bitcast<f32>((bitcast<u32>((_e370 + 127i)) << bitcast<u32>(23i)));
                        let _e381 = bitcast<f32>((bitcast<u32>(((_e369 - _e370) + 127i)) << bitcast<u32>(23i)));
                        let _e386 = global_9.member[_e145].member.member;
                        let _e387 = (_e367 == 0u);
                        if _e387 {
                            phi_630_ = _e386[0];
                        } else {
                            phi_630_ = _e386[1];
                        }
                        let _e391 = phi_630_;
                        let _e392 = (_e367 == 2u);
                        if _e392 {
                            phi_636_ = _e386[2];
                        } else {
                            phi_636_ = _e391;
                        }
                        let _e395 = phi_636_;
                        let _e396 = global_9.member[_e145].member.member_2;
                        if _e387 {
                            phi_647_ = _e396[0];
                        } else {
                            phi_647_ = _e396[1];
                        }
                        let _e400 = phi_647_;
                        if _e392 {
                            phi_653_ = _e396[2];
                        } else {
                            phi_653_ = _e400;
                        }
                        let _e403 = phi_653_;
                        let _e405 = ((_e403 * _e375) * _e381);
                        let _e409 = (bitcast<f32>((bitcast<u32>(_e405) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e409 {
                            let _e413 = (bitcast<f32>((bitcast<u32>(_e395) & 2147483647u)) * 0.00000011920929f);
                            phi_676_ = select(0.00000000000011368684f, _e413, (_e413 > 0.00000000000011368684f));
                        } else {
                            phi_676_ = 0f;
                        }
                        let _e417 = phi_676_;
                        let _e418 = (_e395 + _e417);
                        let _e419 = (_e395 - _e417);
                        let _e420 = select(_e405, 0f, _e409);
                        if _e409 {
                            phi_687_ = 38685626000000000000000000f;
                        } else {
                            phi_687_ = (1f / _e405);
                        }
                        let _e423 = phi_687_;
                        let _e424 = (_e366 == 0u);
                        if _e424 {
                            phi_696_ = _e386[0];
                        } else {
                            phi_696_ = _e386[1];
                        }
                        let _e428 = phi_696_;
                        let _e429 = (_e366 == 2u);
                        if _e429 {
                            phi_702_ = _e386[2];
                        } else {
                            phi_702_ = _e428;
                        }
                        let _e432 = phi_702_;
                        if _e424 {
                            phi_713_ = _e396[0];
                        } else {
                            phi_713_ = _e396[1];
                        }
                        let _e436 = phi_713_;
                        if _e429 {
                            phi_719_ = _e396[2];
                        } else {
                            phi_719_ = _e436;
                        }
                        let _e439 = phi_719_;
                        let _e441 = ((_e439 * _e375) * _e381);
                        let _e445 = (bitcast<f32>((bitcast<u32>(_e441) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e445 {
                            let _e449 = (bitcast<f32>((bitcast<u32>(_e432) & 2147483647u)) * 0.00000011920929f);
                            phi_742_ = select(0.00000000000011368684f, _e449, (_e449 > 0.00000000000011368684f));
                        } else {
                            phi_742_ = 0f;
                        }
                        let _e453 = phi_742_;
                        let _e454 = (_e432 + _e453);
                        let _e455 = (_e432 - _e453);
                        let _e456 = select(_e441, 0f, _e445);
                        if _e445 {
                            phi_753_ = 38685626000000000000000000f;
                        } else {
                            phi_753_ = (1f / _e441);
                        }
                        let _e459 = phi_753_;
                        let _e460 = (_e368 == 0u);
                        if _e460 {
                            phi_762_ = _e386[0];
                        } else {
                            phi_762_ = _e386[1];
                        }
                        let _e464 = phi_762_;
                        let _e465 = (_e368 == 2u);
                        if _e465 {
                            phi_768_ = _e386[2];
                        } else {
                            phi_768_ = _e464;
                        }
                        let _e468 = phi_768_;
                        if _e460 {
                            phi_779_ = _e396[0];
                        } else {
                            phi_779_ = _e396[1];
                        }
                        let _e472 = phi_779_;
                        if _e465 {
                            phi_785_ = _e396[2];
                        } else {
                            phi_785_ = _e472;
                        }
                        let _e475 = phi_785_;
                        let _e477 = ((_e475 * _e375) * _e381);
                        let _e481 = (bitcast<f32>((bitcast<u32>(_e477) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e481 {
                            let _e485 = (bitcast<f32>((bitcast<u32>(_e468) & 2147483647u)) * 0.00000011920929f);
                            phi_808_ = select(0.00000000000011368684f, _e485, (_e485 > 0.00000000000011368684f));
                        } else {
                            phi_808_ = 0f;
                        }
                        let _e489 = phi_808_;
                        let _e490 = (_e468 + _e489);
                        let _e491 = (_e468 - _e489);
                        let _e492 = select(_e477, 0f, _e481);
                        if _e481 {
                            phi_819_ = 38685626000000000000000000f;
                        } else {
                            phi_819_ = (1f / _e477);
                        }
                        let _e495 = phi_819_;
                        let _e498 = bitcast<f32>((bitcast<u32>(_e395) & 2147483647u));
                        let _e501 = bitcast<f32>((bitcast<u32>(_e432) & 2147483647u));
                        let _e503 = select(_e501, _e498, (_e498 > _e501));
                        let _e506 = bitcast<f32>((bitcast<u32>(_e468) & 2147483647u));
                        if (_e329 && (select(_e506, _e503, (_e503 > _e506)) <= 1099511600000f)) {
                            let _e511 = (_e348 / 3i);
                            let _e518 = bitcast<f32>((bitcast<u32>((_e511 + 127i)) << bitcast<u32>(23i)));
                            let _e525 = bitcast<f32>((bitcast<u32>(((_e348 - (2i * _e511)) + 127i)) << bitcast<u32>(23i)));
                            let _e526 = (((_e240 * _e518) * _e518) * _e525);
                            let _e528 = select(340282350000000000000000000000000000000f, _e526, (_e526 < 340282350000000000000000000000000000000f));
                            let _e533 = (((_e245 * _e518) * _e518) * _e525);
                            let _e535 = select(340282350000000000000000000000000000000f, _e533, (_e533 < 340282350000000000000000000000000000000f));
                            phi_919_ = select(-340282350000000000000000000000000000000f, _e535, (_e535 > -340282350000000000000000000000000000000f));
                            phi_920_ = select(-340282350000000000000000000000000000000f, _e528, (_e528 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_919_ = 0f;
                            phi_920_ = 1f;
                        }
                        let _e539 = phi_919_;
                        let _e541 = phi_920_;
                        local_3 = array<type_60, 128>(type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e545 = (_e367 % 3u);
                        let _e546 = (_e545 < 3u);
                        if _e546 {
                        } else {
                            break;
                        }
                        let _e548 = local_1[_e545];
                        let _e551 = (_e366 % 3u);
                        let _e552 = (_e551 < 3u);
                        if _e552 {
                        } else {
                            break;
                        }
                        let _e554 = local_1[_e551];
                        let _e557 = (_e368 % 3u);
                        let _e558 = (_e557 < 3u);
                        if _e558 {
                        } else {
                            break;
                        }
                        let _e560 = local_1[_e557];
                        if _e546 {
                        } else {
                            break;
                        }
                        let _e565 = local[_e545];
                        if _e552 {
                        } else {
                            break;
                        }
                        let _e569 = local[_e551];
                        if _e558 {
                        } else {
                            break;
                        }
                        let _e573 = local[_e557];
                        phi_4997_ = false;
                        phi_2040_ = type_41(_e539, false);
                        phi_2043_ = type_60(type_30(vec4<f32>((f32(_e548) * _e157), (f32(_e554) * _e157), (f32(_e560) * _e157), 0f), vec4<f32>((f32(_e565) * _e157), (f32(_e569) * _e157), (f32(_e573) * _e157), 0f)), select(0u, 2147483648u, (_e98 == 0u)));
                        phi_2045_ = ((3u * _e98) + 1u);
                        phi_2047_ = (_e541 <= _e539);
                        phi_2049_ = 0u;
                        loop {
                            let _e583 = phi_4997_;
                            let _e585 = phi_2040_;
                            let _e587 = phi_2043_;
                            let _e589 = phi_2045_;
                            let _e591 = phi_2047_;
                            let _e593 = phi_2049_;
                            local_8 = _e585;
                            if _e591 {
                                phi_2060_ = true;
                            } else {
                                phi_2060_ = (_e593 > 0u);
                            }
                            let _e596 = phi_2060_;
                            if _e596 {
                                let _e597 = (_e589 > 0u);
                                if _e597 {
                                    if _e591 {
                                        phi_2097_ = _e587;
                                        phi_2098_ = _e591;
                                        phi_2099_ = _e593;
                                    } else {
                                        let _e598 = (_e593 - 1u);
                                        let _e599 = (_e598 % 128u);
                                        let _e600 = (_e599 < 128u);
                                        if _e600 {
                                        } else {
                                            phi_5129_ = true;
                                            break;
                                        }
                                        let _e602 = local_3[_e599];
                                        if _e600 {
                                        } else {
                                            phi_5129_ = true;
                                            break;
                                        }
                                        let _e610 = local_2[_e599];
                                        phi_2097_ = type_60(type_30(_e602.member.member, _e602.member.member_1), _e602.member_1);
                                        phi_2098_ = (_e610 <= _e585.member);
                                        phi_2099_ = _e598;
                                    }
                                    let _e614 = phi_2097_;
                                    let _e616 = phi_2098_;
                                    let _e618 = phi_2099_;
                                    if _e616 {
                                        let _e623 = (_e614.member_1 & 268435455u);
                                        if ((_e614.member_1 & 2147483648u) != 0u) {
                                            phi_4994_ = _e583;
                                            phi_2118_ = _e585;
                                            phi_2121_ = type_8(0u, ((_e614.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1085 = phi_4994_;
                                                let _e1087 = phi_2118_;
                                                let _e1089 = phi_2121_;
                                                local_7 = _e1087;
                                                local_9 = _e1087;
                                                if (_e1089.member < _e1089.member_1) {
                                                    phi_2122_ = type_8((_e1089.member + 1u), _e1089.member_1);
                                                    phi_2144_ = type_8(1u, _e1089.member);
                                                } else {
                                                    phi_2122_ = _e1089;
                                                    phi_2144_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1102 = phi_2122_;
                                                let _e1104 = phi_2144_;
                                                let _e1108 = (bitcast<i32>(_e1104.member) != 0i);
                                                if _e1108 {
                                                    let _e1113 = (_e614.member.member_1.x - _e614.member.member.x);
                                                    let _e1116 = (_e614.member.member_1.y - _e614.member.member.y);
                                                    let _e1119 = (_e614.member.member_1.z - _e614.member.member.z);
                                                    let _e1121 = select(_e1116, _e1113, (_e1113 > _e1116));
                                                    let _e1123 = select(_e1119, _e1121, (_e1121 > _e1119));
                                                    let _e1125 = (_e1123 < (1024f * _e157));
                                                    if _e1125 {
                                                        phi_2185_ = 0u;
                                                    } else {
                                                        phi_2185_ = select(2u, 1u, (_e1123 < (2097152f * _e157)));
                                                    }
                                                    let _e1130 = phi_2185_;
                                                    switch bitcast<i32>(_e1130) {
                                                        case 0: {
                                                            phi_2191_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_2191_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_2191_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_2191_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1133 = phi_2191_;
                                                    switch bitcast<i32>(_e1130) {
                                                        case 0: {
                                                            phi_2201_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_2201_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_2201_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_2201_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1140 = phi_2201_;
                                                    let _e1142 = ((_e623 + (_e1104.member_1 * ((3u * _e1133) + 1u))) + (3u * _e1140));
                                                    let _e1143 = (_e1142 < _e101);
                                                    if _e1143 {
                                                        if _e1143 {
                                                        } else {
                                                            phi_5053_ = true;
                                                            break;
                                                        }
                                                        let _e1145 = global_10.member[_e1142];
                                                        phi_2217_ = _e1145;
                                                    } else {
                                                        phi_2217_ = 4294967295u;
                                                    }
                                                    let _e1147 = phi_2217_;
                                                    local_4 = array<u32, 3>(_e367, _e366, _e368);
                                                    if _e1125 {
                                                        phi_2254_ = 0u;
                                                    } else {
                                                        phi_2254_ = select(2u, 1u, (_e1123 < (2097152f * _e157)));
                                                    }
                                                    let _e1153 = phi_2254_;
                                                    switch bitcast<i32>(_e1153) {
                                                        case 0: {
                                                            phi_2260_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_2260_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_2260_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_2260_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1156 = phi_2260_;
                                                    switch bitcast<i32>(_e1153) {
                                                        case 0: {
                                                            phi_2270_ = 1u;
                                                            break;
                                                        }
                                                        case 1: {
                                                            phi_2270_ = 2u;
                                                            break;
                                                        }
                                                        case 2: {
                                                            phi_2270_ = 3u;
                                                            break;
                                                        }
                                                        default: {
                                                            phi_2270_ = u32();
                                                            break;
                                                        }
                                                    }
                                                    let _e1163 = phi_2270_;
                                                    local_6 = array<f32, 4>(_e614.member.member.x, _e614.member.member.y, _e614.member.member.z, _e614.member.member.w);
                                                    local_5[0u] = array<f32, 3>(0f, 0f, 0f);
                                                    local_5[1u] = array<f32, 3>(0f, 0f, 0f);
                                                    local_5[2u] = array<f32, 3>(0f, 0f, 0f);
                                                    phi_4979_ = _e1085;
                                                    phi_2286_ = type_8(0u, 3u);
                                                    loop {
                                                        let _e1177 = phi_4979_;
                                                        let _e1179 = phi_2286_;
                                                        if (_e1179.member < _e1179.member_1) {
                                                            phi_2287_ = type_8((_e1179.member + 1u), _e1179.member_1);
                                                            phi_2310_ = type_8(1u, _e1179.member);
                                                        } else {
                                                            phi_2287_ = _e1179;
                                                            phi_2310_ = type_8(0u, type_8().member_1);
                                                        }
                                                        let _e1192 = phi_2287_;
                                                        let _e1194 = phi_2310_;
                                                        let _e1198 = (bitcast<i32>(_e1194.member) != 0i);
                                                        if _e1198 {
                                                            let _e1200 = ((_e623 + (_e1104.member_1 * ((3u * _e1156) + 1u))) + (_e1194.member_1 * _e1163));
                                                            let _e1201 = (_e1200 < _e101);
                                                            if _e1201 {
                                                                if _e1201 {
                                                                } else {
                                                                    phi_5051_ = true;
                                                                    break;
                                                                }
                                                                let _e1203 = global_10.member[_e1200];
                                                                phi_2333_ = _e1203;
                                                            } else {
                                                                phi_2333_ = 0u;
                                                            }
                                                            let _e1205 = phi_2333_;
                                                            let _e1206 = (_e1200 + 1u);
                                                            let _e1207 = (_e1206 < _e101);
                                                            if _e1207 {
                                                                if _e1207 {
                                                                } else {
                                                                    phi_5051_ = true;
                                                                    break;
                                                                }
                                                                let _e1209 = global_10.member[_e1206];
                                                                phi_2348_ = _e1209;
                                                            } else {
                                                                phi_2348_ = 0u;
                                                            }
                                                            let _e1211 = phi_2348_;
                                                            phi_2351_ = type_8(0u, 3u);
                                                            loop {
                                                                let _e1213 = phi_2351_;
                                                                if (_e1213.member < _e1213.member_1) {
                                                                    phi_2352_ = type_8((_e1213.member + 1u), _e1213.member_1);
                                                                    phi_2375_ = type_8(1u, _e1213.member);
                                                                } else {
                                                                    phi_2352_ = _e1213;
                                                                    phi_2375_ = type_8(0u, type_8().member_1);
                                                                }
                                                                let _e1226 = phi_2352_;
                                                                let _e1228 = phi_2375_;
                                                                let _e1232 = (bitcast<i32>(_e1228.member) != 0i);
                                                                if _e1232 {
                                                                    let _e1233 = (_e1228.member_1 < 3u);
                                                                    if _e1233 {
                                                                    } else {
                                                                        phi_4972_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1235 = local_4[_e1228.member_1];
                                                                    if (_e1228.member_1 < 4u) {
                                                                    } else {
                                                                        phi_4972_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1238 = local_6[_e1228.member_1];
                                                                    switch bitcast<i32>(_e1153) {
                                                                        case 0: {
                                                                            phi_2445_ = (_e1238 + (f32(((_e1205 >> bitcast<u32>(((10u * _e1235) & 31u))) & 1023u)) * _e157));
                                                                            break;
                                                                        }
                                                                        case 1: {
                                                                            if (_e1235 == 0u) {
                                                                                phi_2422_ = _e1205;
                                                                            } else {
                                                                                if (_e1235 == 1u) {
                                                                                    phi_2421_ = ((_e1205 >> bitcast<u32>(21i)) | (_e1211 << bitcast<u32>(11i)));
                                                                                } else {
                                                                                    phi_2421_ = (_e1211 >> bitcast<u32>(10i));
                                                                                }
                                                                                let _e1259 = phi_2421_;
                                                                                phi_2422_ = _e1259;
                                                                            }
                                                                            let _e1261 = phi_2422_;
                                                                            phi_2445_ = (_e1238 + (f32((_e1261 & 2097151u)) * _e157));
                                                                            break;
                                                                        }
                                                                        case 2: {
                                                                            let _e1240 = (_e1200 + _e1235);
                                                                            let _e1241 = (_e1240 < _e101);
                                                                            if _e1241 {
                                                                                if _e1241 {
                                                                                } else {
                                                                                    phi_4972_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e1243 = global_10.member[_e1240];
                                                                                phi_2441_ = _e1243;
                                                                            } else {
                                                                                phi_2441_ = 0u;
                                                                            }
                                                                            let _e1245 = phi_2441_;
                                                                            phi_2445_ = (f32(bitcast<i32>(_e1245)) * _e157);
                                                                            break;
                                                                        }
                                                                        default: {
                                                                            phi_2445_ = f32();
                                                                            break;
                                                                        }
                                                                    }
                                                                    let _e1275 = phi_2445_;
                                                                    if (_e1194.member_1 < 3u) {
                                                                    } else {
                                                                        phi_4972_ = true;
                                                                        break;
                                                                    }
                                                                    if _e1233 {
                                                                    } else {
                                                                        phi_4972_ = true;
                                                                        break;
                                                                    }
                                                                    local_5[_e1194.member_1][_e1228.member_1] = _e1275;
                                                                }
                                                                continue;
                                                                continuing {
                                                                    phi_2351_ = _e1226;
                                                                    phi_4972_ = _e1177;
                                                                    break if !(_e1232);
                                                                }
                                                            }
                                                            let _e1281 = phi_4972_;
                                                            phi_5051_ = _e1281;
                                                            if _e1281 {
                                                                break;
                                                            }
                                                            phi_5052_ = _e1281;
                                                        } else {
                                                            phi_5052_ = _e1177;
                                                        }
                                                        let _e1283 = phi_5052_;
                                                        continue;
                                                        continuing {
                                                            phi_4979_ = _e1283;
                                                            phi_2286_ = _e1192;
                                                            phi_5051_ = _e1283;
                                                            break if !(_e1198);
                                                        }
                                                    }
                                                    let _e1286 = phi_5051_;
                                                    phi_5053_ = _e1286;
                                                    if _e1286 {
                                                        break;
                                                    }
                                                    let _e1287 = local_5;
                                                    let _e1303 = (_e1287[0][2] - _e468);
                                                    let _e1306 = (((_e1287[0][0] - _e395) * _e492) - (_e1303 * _e420));
                                                    let _e1309 = (((_e1287[0][1] - _e432) * _e492) - (_e1303 * _e456));
                                                    let _e1312 = (_e1287[1][2] - _e468);
                                                    let _e1315 = (((_e1287[1][0] - _e395) * _e492) - (_e1312 * _e420));
                                                    let _e1318 = (((_e1287[1][1] - _e432) * _e492) - (_e1312 * _e456));
                                                    let _e1321 = (_e1287[2][2] - _e468);
                                                    let _e1324 = (((_e1287[2][0] - _e395) * _e492) - (_e1321 * _e420));
                                                    let _e1327 = (((_e1287[2][1] - _e432) * _e492) - (_e1321 * _e456));
                                                    let _e1328 = (_e1324 * _e1318);
                                                    let _e1329 = (_e1327 * _e1315);
                                                    let _e1330 = (_e1306 * _e1327);
                                                    let _e1331 = (_e1309 * _e1324);
                                                    let _e1332 = (_e1315 * _e1309);
                                                    let _e1333 = (_e1318 * _e1306);
                                                    let _e1338 = (((_e1328 >= _e1329) && (_e1330 >= _e1331)) && (_e1332 >= _e1333));
                                                    if (_e1338 || (((_e1328 <= _e1329) && (_e1330 <= _e1331)) && (_e1332 <= _e1333))) {
                                                        let _e1345 = select(-1f, 1f, _e1338);
                                                        let _e1347 = ((_e1328 - _e1329) * _e1345);
                                                        let _e1349 = select(0f, _e1347, (_e1347 > 0f));
                                                        let _e1351 = ((_e1330 - _e1331) * _e1345);
                                                        let _e1353 = select(0f, _e1351, (_e1351 > 0f));
                                                        let _e1355 = ((_e1332 - _e1333) * _e1345);
                                                        let _e1357 = select(0f, _e1355, (_e1355 > 0f));
                                                        let _e1359 = ((_e1349 + _e1353) + _e1357);
                                                        if (_e1359 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_3040_ = type_21();
                                                            phi_3041_ = true;
                                                        } else {
                                                            let _e1362 = select(_e1287[1][0], _e1287[0][0], (_e1287[0][0] < _e1287[1][0]));
                                                            let _e1366 = select(_e1287[1][0], _e1287[0][0], (_e1287[0][0] > _e1287[1][0]));
                                                            let _e1370 = select(_e1287[1][1], _e1287[0][1], (_e1287[0][1] < _e1287[1][1]));
                                                            let _e1374 = select(_e1287[1][1], _e1287[0][1], (_e1287[0][1] > _e1287[1][1]));
                                                            let _e1378 = select(_e1287[1][2], _e1287[0][2], (_e1287[0][2] < _e1287[1][2]));
                                                            let _e1382 = select(_e1287[1][2], _e1287[0][2], (_e1287[0][2] > _e1287[1][2]));
                                                            let _e1387 = ((select(_e1287[2][0], _e1362, (_e1362 < _e1287[2][0])) - _e418) * _e423);
                                                            let _e1388 = ((select(_e1287[2][0], _e1366, (_e1366 > _e1287[2][0])) - _e419) * _e423);
                                                            let _e1391 = ((select(_e1287[2][1], _e1370, (_e1370 < _e1287[2][1])) - _e454) * _e459);
                                                            let _e1392 = ((select(_e1287[2][1], _e1374, (_e1374 > _e1287[2][1])) - _e455) * _e459);
                                                            let _e1395 = ((select(_e1287[2][2], _e1378, (_e1378 < _e1287[2][2])) - _e490) * _e495);
                                                            let _e1396 = ((select(_e1287[2][2], _e1382, (_e1382 > _e1287[2][2])) - _e491) * _e495);
                                                            let _e1398 = select(_e1396, _e1395, (_e1395 < _e1396));
                                                            let _e1400 = select(_e1396, _e1395, (_e1395 > _e1396));
                                                            let _e1402 = select(_e1388, _e1387, (_e1387 < _e1388));
                                                            let _e1404 = select(_e1392, _e1391, (_e1391 < _e1392));
                                                            let _e1406 = select(_e1404, _e1402, (_e1402 > _e1404));
                                                            let _e1408 = select(_e1398, _e1406, (_e1406 > _e1398));
                                                            let _e1410 = select(_e1388, _e1387, (_e1387 > _e1388));
                                                            let _e1412 = select(_e1392, _e1391, (_e1391 > _e1392));
                                                            let _e1414 = select(_e1412, _e1410, (_e1410 < _e1412));
                                                            let _e1416 = select(_e1400, _e1414, (_e1414 < _e1400));
                                                            let _e1417 = -(_e1398);
                                                            let _e1423 = select(_e541, _e1408, (_e1408 > _e541));
                                                            if (_e1423 > (_e1416 + (select(_e1417, _e1400, (_e1400 > _e1417)) * 0.0000019073523f))) {
                                                                phi_3035_ = type_21();
                                                                phi_3036_ = true;
                                                            } else {
                                                                let _e1425 = (_e1423 > _e1087.member);
                                                                if _e1425 {
                                                                    phi_3034_ = type_21();
                                                                } else {
                                                                    let _e1429 = (_e1287[1][0] - _e1287[0][0]);
                                                                    let _e1430 = (_e1287[1][1] - _e1287[0][1]);
                                                                    let _e1431 = (_e1287[1][2] - _e1287[0][2]);
                                                                    let _e1432 = vec3<f32>(_e1429, _e1430, _e1431);
                                                                    let _e1433 = (_e1287[2][0] - _e1287[1][0]);
                                                                    let _e1434 = (_e1287[2][1] - _e1287[1][1]);
                                                                    let _e1435 = (_e1287[2][2] - _e1287[1][2]);
                                                                    let _e1436 = vec3<f32>(_e1433, _e1434, _e1435);
                                                                    let _e1437 = (_e1287[0][0] - _e1287[2][0]);
                                                                    let _e1438 = (_e1287[0][1] - _e1287[2][1]);
                                                                    let _e1439 = (_e1287[0][2] - _e1287[2][2]);
                                                                    let _e1440 = vec3<f32>(_e1437, _e1438, _e1439);
                                                                    let _e1443 = bitcast<f32>((bitcast<u32>(_e1429) & 2147483647u));
                                                                    let _e1446 = bitcast<f32>((bitcast<u32>(_e1430) & 2147483647u));
                                                                    let _e1448 = select(_e1446, _e1443, (_e1443 > _e1446));
                                                                    let _e1451 = bitcast<f32>((bitcast<u32>(_e1431) & 2147483647u));
                                                                    let _e1453 = select(_e1451, _e1448, (_e1448 > _e1451));
                                                                    let _e1456 = bitcast<f32>((bitcast<u32>(_e1433) & 2147483647u));
                                                                    let _e1459 = bitcast<f32>((bitcast<u32>(_e1434) & 2147483647u));
                                                                    let _e1461 = select(_e1459, _e1456, (_e1456 > _e1459));
                                                                    let _e1464 = bitcast<f32>((bitcast<u32>(_e1435) & 2147483647u));
                                                                    let _e1466 = select(_e1464, _e1461, (_e1461 > _e1464));
                                                                    let _e1469 = bitcast<f32>((bitcast<u32>(_e1437) & 2147483647u));
                                                                    let _e1472 = bitcast<f32>((bitcast<u32>(_e1438) & 2147483647u));
                                                                    let _e1474 = select(_e1472, _e1469, (_e1469 > _e1472));
                                                                    let _e1477 = bitcast<f32>((bitcast<u32>(_e1439) & 2147483647u));
                                                                    let _e1479 = select(_e1477, _e1474, (_e1474 > _e1477));
                                                                    let _e1481 = select(_e1466, _e1453, (_e1453 > _e1466));
                                                                    let _e1483 = select(_e1479, _e1481, (_e1481 > _e1479));
                                                                    if (_e1453 == _e1483) {
                                                                        phi_2945_ = _e1436;
                                                                        phi_2946_ = _e1440;
                                                                    } else {
                                                                        let _e1486 = vec3((_e1466 == _e1483));
                                                                        phi_2945_ = select(_e1432, _e1440, _e1486);
                                                                        phi_2946_ = select(_e1436, _e1432, _e1486);
                                                                    }
                                                                    let _e1490 = phi_2945_;
                                                                    let _e1492 = phi_2946_;
                                                                    let _e1499 = ((_e1490.y * _e1492.z) - (_e1492.y * _e1490.z));
                                                                    let _e1504 = ((_e1490.z * _e1492.x) - (_e1492.z * _e1490.x));
                                                                    let _e1507 = ((_e1490.x * _e1492.y) - (_e1492.x * _e1490.y));
                                                                    if (_e1349 >= _e1353) {
                                                                        phi_2977_ = select(true, false, (_e1349 >= _e1357));
                                                                    } else {
                                                                        phi_2977_ = true;
                                                                    }
                                                                    let _e1512 = phi_2977_;
                                                                    if _e1512 {
                                                                        phi_2986_ = select(vec3<f32>(_e1287[2][0], _e1287[2][1], _e1287[2][2]), vec3<f32>(_e1287[1][0], _e1287[1][1], _e1287[1][2]), vec3((_e1353 >= _e1357)));
                                                                    } else {
                                                                        phi_2986_ = vec3<f32>(_e1287[0][0], _e1287[0][1], _e1287[0][2]);
                                                                    }
                                                                    let _e1517 = phi_2986_;
                                                                    let _e1534 = ((((_e1499 * (_e1517.x - _e395)) + (_e1504 * (_e1517.y - _e432))) + (_e1507 * (_e1517.z - _e468))) / (((_e1499 * _e420) + (_e1504 * _e456)) + (_e1507 * _e492)));
                                                                    let _e1536 = select(_e1416, _e1534, (_e1534 < _e1416));
                                                                    let _e1538 = select(_e1408, _e1536, (_e1536 > _e1408));
                                                                    if (_e1538 >= _e541) {
                                                                        let _e1540 = (_e1538 <= _e1087.member);
                                                                        if _e1540 {
                                                                            let _e1541 = (1f / _e1359);
                                                                            phi_3026_ = type_21(_e1538, (_e1353 * _e1541), (_e1357 * _e1541), _e1147);
                                                                        } else {
                                                                            phi_3026_ = type_21();
                                                                        }
                                                                        let _e1546 = phi_3026_;
                                                                        phi_3028_ = _e1546;
                                                                        phi_3029_ = select(true, false, _e1540);
                                                                    } else {
                                                                        phi_3028_ = type_21();
                                                                        phi_3029_ = true;
                                                                    }
                                                                    let _e1549 = phi_3028_;
                                                                    let _e1551 = phi_3029_;
                                                                    if _e1551 {
                                                                        phi_3033_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_3033_ = _e1549;
                                                                    }
                                                                    let _e1553 = phi_3033_;
                                                                    phi_3034_ = _e1553;
                                                                }
                                                                let _e1555 = phi_3034_;
                                                                phi_3035_ = _e1555;
                                                                phi_3036_ = _e1425;
                                                            }
                                                            let _e1557 = phi_3035_;
                                                            let _e1559 = phi_3036_;
                                                            phi_3040_ = _e1557;
                                                            phi_3041_ = _e1559;
                                                        }
                                                        let _e1561 = phi_3040_;
                                                        let _e1563 = phi_3041_;
                                                        phi_3045_ = _e1561;
                                                        phi_3046_ = _e1563;
                                                    } else {
                                                        phi_3045_ = type_21();
                                                        phi_3046_ = true;
                                                    }
                                                    let _e1565 = phi_3045_;
                                                    let _e1567 = phi_3046_;
                                                    if _e1567 {
                                                        phi_3050_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_3050_ = _e1565;
                                                    }
                                                    let _e1569 = phi_3050_;
                                                    if (_e1569.member_3 != 4294967295u) {
                                                        if (_e1147 == _e166) {
                                                            phi_3379_ = false;
                                                        } else {
                                                            let _e1573 = (_e1147 < arrayLength((&global_5.member)));
                                                            if _e1573 {
                                                                if _e1573 {
                                                                } else {
                                                                    phi_5053_ = true;
                                                                    break;
                                                                }
                                                                let _e1575 = global_5.member[_e1147];
                                                                phi_3073_ = _e1575;
                                                            } else {
                                                                phi_3073_ = 4294967295u;
                                                            }
                                                            let _e1577 = phi_3073_;
                                                            let _e1578 = (_e1577 < arrayLength((&global_6.member)));
                                                            if _e1578 {
                                                                if _e1578 {
                                                                } else {
                                                                    phi_5053_ = true;
                                                                    break;
                                                                }
                                                                let _e1580 = global_6.member[_e1577];
                                                                phi_3087_ = _e1580;
                                                            } else {
                                                                phi_3087_ = 0i;
                                                            }
                                                            let _e1582 = phi_3087_;
                                                            let _e1583 = (_e1582 == 0i);
                                                            if _e1583 {
                                                                phi_3378_ = true;
                                                            } else {
                                                                if _e387 {
                                                                    phi_3108_ = vec3<f32>(_e1287[0][0], _e1287[0][1], _e1287[0][2]);
                                                                } else {
                                                                    if (_e367 == 1u) {
                                                                        phi_3107_ = vec3<f32>(_e1287[0][2], _e1287[0][0], _e1287[0][1]);
                                                                    } else {
                                                                        phi_3107_ = vec3<f32>(_e1287[0][1], _e1287[0][2], _e1287[0][0]);
                                                                    }
                                                                    let _e1588 = phi_3107_;
                                                                    phi_3108_ = _e1588;
                                                                }
                                                                let _e1591 = phi_3108_;
                                                                if _e387 {
                                                                    phi_3125_ = vec3<f32>(_e1287[1][0], _e1287[1][1], _e1287[1][2]);
                                                                } else {
                                                                    if (_e367 == 1u) {
                                                                        phi_3124_ = vec3<f32>(_e1287[1][2], _e1287[1][0], _e1287[1][1]);
                                                                    } else {
                                                                        phi_3124_ = vec3<f32>(_e1287[1][1], _e1287[1][2], _e1287[1][0]);
                                                                    }
                                                                    let _e1596 = phi_3124_;
                                                                    phi_3125_ = _e1596;
                                                                }
                                                                let _e1599 = phi_3125_;
                                                                if _e387 {
                                                                    phi_3142_ = vec3<f32>(_e1287[2][0], _e1287[2][1], _e1287[2][2]);
                                                                } else {
                                                                    if (_e367 == 1u) {
                                                                        phi_3141_ = vec3<f32>(_e1287[2][2], _e1287[2][0], _e1287[2][1]);
                                                                    } else {
                                                                        phi_3141_ = vec3<f32>(_e1287[2][1], _e1287[2][2], _e1287[2][0]);
                                                                    }
                                                                    let _e1604 = phi_3141_;
                                                                    phi_3142_ = _e1604;
                                                                }
                                                                let _e1607 = phi_3142_;
                                                                let _e1610 = (_e1599.x - _e1591.x);
                                                                let _e1613 = (_e1599.y - _e1591.y);
                                                                let _e1616 = (_e1599.z - _e1591.z);
                                                                let _e1618 = (_e1607.x - _e1591.x);
                                                                let _e1620 = (_e1607.y - _e1591.y);
                                                                let _e1622 = (_e1607.z - _e1591.z);
                                                                if (_e234.member_1 == 1u) {
                                                                    phi_3178_ = (vec3<f32>(_e234.member[0], _e234.member[1], _e234.member[2]) - _e1591);
                                                                } else {
                                                                    phi_3178_ = vec3<f32>(_e234.member[0], _e234.member[1], _e234.member[2]);
                                                                }
                                                                let _e1637 = phi_3178_;
                                                                let _e1643 = bitcast<f32>((bitcast<u32>((_e1610 * _e1620)) ^ _e234.member_3[0]));
                                                                let _e1647 = bitcast<f32>((bitcast<u32>((_e1613 * _e1618)) ^ _e234.member_3[0]));
                                                                let _e1651 = bitcast<f32>((bitcast<u32>((_e1613 * _e1622)) ^ _e234.member_3[0]));
                                                                let _e1655 = bitcast<f32>((bitcast<u32>((_e1616 * _e1620)) ^ _e234.member_3[0]));
                                                                let _e1659 = bitcast<f32>((bitcast<u32>((_e1616 * _e1618)) ^ _e234.member_3[0]));
                                                                let _e1663 = bitcast<f32>((bitcast<u32>((_e1610 * _e1622)) ^ _e234.member_3[0]));
                                                                let _e1664 = (_e1651 - _e1655);
                                                                let _e1665 = (_e1659 - _e1663);
                                                                let _e1666 = (_e1643 - _e1647);
                                                                let _e1690 = (bitcast<f32>((bitcast<u32>(_e1651) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1655) & 2147483647u)));
                                                                let _e1697 = (bitcast<f32>((bitcast<u32>(_e1659) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1663) & 2147483647u)));
                                                                let _e1704 = (bitcast<f32>((bitcast<u32>(_e1643) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1647) & 2147483647u)));
                                                                if (_e234.member_2 == 0f) {
                                                                    phi_3360_ = 0f;
                                                                } else {
                                                                    let _e1734 = bitcast<f32>((bitcast<u32>(_e1664) & 2147483647u));
                                                                    let _e1737 = bitcast<f32>((bitcast<u32>(_e1665) & 2147483647u));
                                                                    let _e1740 = bitcast<f32>((bitcast<u32>(_e1666) & 2147483647u));
                                                                    let _e1742 = select(_e1740, _e1737, (_e1737 > _e1740));
                                                                    let _e1746 = select(_e1740, _e1737, (_e1737 < _e1740));
                                                                    let _e1750 = select(_e1737, _e1734, (_e1734 < _e1737));
                                                                    let _e1752 = select(_e1737, _e1734, (_e1734 > _e1737));
                                                                    let _e1754 = select(_e1740, _e1752, (_e1752 < _e1740));
                                                                    phi_3360_ = bitcast<f32>((bitcast<u32>((_e234.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1742, _e1734, (_e1734 > _e1742)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1754, _e1750, (_e1750 > _e1754)))) ^ _e234.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1746, _e1734, (_e1734 < _e1746)))) ^ _e234.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1690 + _e1697) + _e1704))) ^ _e234.member_3[0]))) * 1.0000005f)) ^ _e234.member_3[0])))) ^ _e234.member_3[0]));
                                                                }
                                                                let _e1781 = phi_3360_;
                                                                phi_3378_ = (_e1583 || !(((((bitcast<f32>((bitcast<u32>((_e1637.x * _e1664)) ^ _e234.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1637.y * _e1665)) ^ _e234.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1637.z * _e1666)) ^ _e234.member_3[0]))) * f32(-(_e1582))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1637.x) & 2147483647u)) * _e1690)) ^ _e234.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1637.y) & 2147483647u)) * _e1697)) ^ _e234.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1637.z) & 2147483647u)) * _e1704)) ^ _e234.member_3[0]))))) ^ _e234.member_3[0])) + _e1781) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1795 = phi_3378_;
                                                            phi_3379_ = _e1795;
                                                        }
                                                        let _e1797 = phi_3379_;
                                                        if _e1797 {
                                                            phi_3384_ = type_41(_e1087.member, true);
                                                        } else {
                                                            phi_3384_ = _e1087;
                                                        }
                                                        let _e1802 = phi_3384_;
                                                        phi_3385_ = _e1802;
                                                    } else {
                                                        phi_3385_ = _e1087;
                                                    }
                                                    let _e1804 = phi_3385_;
                                                    phi_5054_ = _e1286;
                                                    phi_2119_ = _e1804;
                                                } else {
                                                    phi_5054_ = _e1085;
                                                    phi_2119_ = type_41();
                                                }
                                                let _e1806 = phi_5054_;
                                                let _e1808 = phi_2119_;
                                                continue;
                                                continuing {
                                                    phi_4994_ = _e1806;
                                                    phi_2118_ = _e1808;
                                                    phi_2121_ = _e1102;
                                                    phi_5053_ = _e1806;
                                                    break if !(_e1108);
                                                }
                                            }
                                            let _e1811 = phi_5053_;
                                            phi_5129_ = _e1811;
                                            if _e1811 {
                                                break;
                                            }
                                            let _e1813 = local_7;
                                            phi_5133_ = _e1811;
                                            let _e2023 = local_9;
                                            phi_4724_ = _e2023;
                                            phi_4725_ = _e614;
                                            phi_4726_ = false;
                                            phi_4727_ = select(_e618, 0u, _e1813.member_1);
                                        } else {
                                            if (_e614.member_1 >= _e98) {
                                                phi_4324_ = type_63(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_60(type_30(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e614.member_1 < _e98) {
                                                } else {
                                                    phi_5129_ = true;
                                                    break;
                                                }
                                                let _e632 = ((1u + (_e367 * 2u)) % 7u);
                                                if (_e632 < 7u) {
                                                } else {
                                                    phi_5129_ = true;
                                                    break;
                                                }
                                                let _e637 = global_8.member[_e614.member_1][_e632];
                                                let _e640 = ((1u + (_e366 * 2u)) % 7u);
                                                if (_e640 < 7u) {
                                                } else {
                                                    phi_5129_ = true;
                                                    break;
                                                }
                                                let _e645 = global_8.member[_e614.member_1][_e640];
                                                let _e648 = ((1u + (_e368 * 2u)) % 7u);
                                                if (_e648 < 7u) {
                                                } else {
                                                    phi_5129_ = true;
                                                    break;
                                                }
                                                let _e653 = global_8.member[_e614.member_1][_e648];
                                                let _e656 = (((_e367 + 1u) * 2u) % 7u);
                                                if (_e656 < 7u) {
                                                } else {
                                                    phi_5129_ = true;
                                                    break;
                                                }
                                                let _e661 = global_8.member[_e614.member_1][_e656];
                                                let _e664 = (((_e366 + 1u) * 2u) % 7u);
                                                if (_e664 < 7u) {
                                                } else {
                                                    phi_5129_ = true;
                                                    break;
                                                }
                                                let _e669 = global_8.member[_e614.member_1][_e664];
                                                let _e672 = (((_e368 + 1u) * 2u) % 7u);
                                                if (_e672 < 7u) {
                                                } else {
                                                    phi_5129_ = true;
                                                    break;
                                                }
                                                let _e677 = global_8.member[_e614.member_1][_e672];
                                                let _e700 = (bitcast<f32>((bitcast<u32>((_e614.member.member_1.x - _e614.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                                let _e701 = (bitcast<f32>((bitcast<u32>((_e614.member.member_1.y - _e614.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                                let _e702 = (bitcast<f32>((bitcast<u32>((_e614.member.member_1.z - _e614.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                                let _e704 = select(_e157, _e700, (_e700 > _e157));
                                                let _e706 = select(_e157, _e701, (_e701 > _e157));
                                                let _e708 = select(_e157, _e702, (_e702 > _e157));
                                                let _e733 = bitcast<u32>((f32(bitcast<i32>((_e637 & 2097151u))) * _e704));
                                                let _e738 = (bitcast<i32>((_e637 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e741 = bitcast<f32>((_e733 & bitcast<u32>(_e738)));
                                                let _e742 = bitcast<u32>((f32(bitcast<i32>((_e645 & 2097151u))) * _e706));
                                                let _e747 = (bitcast<i32>((_e645 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e750 = bitcast<f32>((_e742 & bitcast<u32>(_e747)));
                                                let _e751 = bitcast<u32>((f32(bitcast<i32>((_e653 & 2097151u))) * _e708));
                                                let _e756 = (bitcast<i32>((_e653 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e759 = bitcast<f32>((_e751 & bitcast<u32>(_e756)));
                                                let _e763 = bitcast<f32>((_e733 & bitcast<u32>(~(_e738))));
                                                let _e767 = bitcast<f32>((_e742 & bitcast<u32>(~(_e747))));
                                                let _e771 = bitcast<f32>((_e751 & bitcast<u32>(~(_e756))));
                                                let _e772 = bitcast<u32>((f32(bitcast<i32>((_e661 & 2097151u))) * _e704));
                                                let _e777 = (bitcast<i32>((_e661 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e780 = bitcast<f32>((_e772 & bitcast<u32>(_e777)));
                                                let _e781 = bitcast<u32>((f32(bitcast<i32>((_e669 & 2097151u))) * _e706));
                                                let _e786 = (bitcast<i32>((_e669 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e789 = bitcast<f32>((_e781 & bitcast<u32>(_e786)));
                                                let _e790 = bitcast<u32>((f32(bitcast<i32>((_e677 & 2097151u))) * _e708));
                                                let _e795 = (bitcast<i32>((_e677 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                                let _e798 = bitcast<f32>((_e790 & bitcast<u32>(_e795)));
                                                let _e802 = bitcast<f32>((_e772 & bitcast<u32>(~(_e777))));
                                                let _e806 = bitcast<f32>((_e781 & bitcast<u32>(~(_e786))));
                                                let _e810 = bitcast<f32>((_e790 & bitcast<u32>(~(_e795))));
                                                let _e811 = (_e614.member.member.x + _e741);
                                                let _e812 = (_e614.member.member.y + _e750);
                                                let _e813 = (_e614.member.member.z + _e759);
                                                let _e816 = (_e614.member.member_1.x - _e780);
                                                let _e817 = (_e614.member.member_1.y - _e789);
                                                let _e818 = (_e614.member.member_1.z - _e798);
                                                let _e837 = (_e816 - _e811);
                                                let _e838 = (_e817 - _e812);
                                                let _e839 = (_e818 - _e813);
                                                let _e841 = select(_e838, _e837, (_e837 > _e838));
                                                let _e843 = select(_e839, _e841, (_e841 > _e839));
                                                if (_e843 < (1024f * _e157)) {
                                                    phi_4025_ = 0u;
                                                } else {
                                                    phi_4025_ = select(2u, 1u, (_e843 < (2097152f * _e157)));
                                                }
                                                let _e850 = phi_4025_;
                                                switch bitcast<i32>(_e850) {
                                                    case 0: {
                                                        phi_4031_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_4031_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_4031_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_4031_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e853 = phi_4031_;
                                                let _e859 = global_8.member[_e614.member_1][0u];
                                                let _e863 = global_8.member[_e614.member_1][2u];
                                                let _e867 = global_8.member[_e614.member_1][4u];
                                                let _e871 = global_8.member[_e614.member_1][6u];
                                                let _e883 = (((_e863 >> bitcast<u32>(22i)) | ((_e867 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e871 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e884 = (_e859 & 268435455u);
                                                let _e885 = (_e883 & 268435455u);
                                                let _e888 = ((_e859 >> bitcast<u32>(28u)) & 7u);
                                                let _e896 = ((_e859 >> bitcast<u32>(31i)) | (((_e883 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e897 = (_e888 != 0u);
                                                if (_e888 == 0u) {
                                                    phi_4286_ = _e884;
                                                } else {
                                                    if (_e888 == 7u) {
                                                        phi_4285_ = 2147483648u;
                                                    } else {
                                                        phi_4285_ = ((2147483648u | (_e888 << bitcast<u32>(28u))) | (_e885 & 268435455u));
                                                    }
                                                    let _e906 = phi_4285_;
                                                    phi_4286_ = _e906;
                                                }
                                                let _e908 = phi_4286_;
                                                if _e897 {
                                                    let _e909 = (_e888 != 7u);
                                                    if _e909 {
                                                        phi_4296_ = (_e885 + (_e888 * ((3u * _e853) + 1u)));
                                                    } else {
                                                        phi_4296_ = u32();
                                                    }
                                                    let _e913 = phi_4296_;
                                                    phi_4298_ = _e913;
                                                    phi_4299_ = select(true, false, _e909);
                                                } else {
                                                    phi_4298_ = u32();
                                                    phi_4299_ = true;
                                                }
                                                let _e916 = phi_4298_;
                                                let _e918 = phi_4299_;
                                                if (_e896 == 0u) {
                                                    phi_4320_ = (_e884 + select(0u, 1u, !(_e897)));
                                                } else {
                                                    if (_e896 == 7u) {
                                                        phi_4319_ = 2147483648u;
                                                    } else {
                                                        phi_4319_ = ((2147483648u | (_e896 << bitcast<u32>(28u))) | (select(_e916, _e885, _e918) & 268435455u));
                                                    }
                                                    let _e931 = phi_4319_;
                                                    phi_4320_ = _e931;
                                                }
                                                let _e933 = phi_4320_;
                                                phi_4324_ = type_63(array<vec4<f32>, 3>(vec4<f32>(_e811, (_e614.member.member.x + _e763), _e816, (_e614.member.member_1.x - _e802)), vec4<f32>(_e812, (_e614.member.member.y + _e767), _e817, (_e614.member.member_1.y - _e806)), vec4<f32>(_e813, (_e614.member.member.z + _e771), _e818, (_e614.member.member_1.z - _e810))), type_60(type_30((_e614.member.member + vec4<f32>(_e741, _e750, _e759, 0f)), (_e614.member.member_1 - vec4<f32>(_e780, _e789, _e798, 0f))), _e908), type_60(type_30((_e614.member.member + vec4<f32>(_e763, _e767, _e771, 0f)), (_e614.member.member_1 - vec4<f32>(_e802, _e806, _e810, 0f))), _e933));
                                            }
                                            let _e938 = phi_4324_;
                                            let _e950 = ((_e938.member[0].x - _e418) * _e423);
                                            let _e951 = ((_e938.member[0].y - _e418) * _e423);
                                            let _e952 = ((_e938.member[0].z - _e419) * _e423);
                                            let _e953 = ((_e938.member[0].w - _e419) * _e423);
                                            let _e963 = ((_e938.member[1].x - _e454) * _e459);
                                            let _e964 = ((_e938.member[1].y - _e454) * _e459);
                                            let _e965 = ((_e938.member[1].z - _e455) * _e459);
                                            let _e966 = ((_e938.member[1].w - _e455) * _e459);
                                            let _e976 = ((_e938.member[2].x - _e490) * _e495);
                                            let _e977 = ((_e938.member[2].y - _e490) * _e495);
                                            let _e978 = ((_e938.member[2].z - _e491) * _e495);
                                            let _e979 = ((_e938.member[2].w - _e491) * _e495);
                                            let _e981 = select(_e978, _e976, (_e976 < _e978));
                                            let _e983 = select(_e979, _e977, (_e977 < _e979));
                                            let _e985 = select(_e978, _e976, (_e976 > _e978));
                                            let _e987 = select(_e979, _e977, (_e977 > _e979));
                                            let _e989 = select(_e952, _e950, (_e950 < _e952));
                                            let _e991 = select(_e953, _e951, (_e951 < _e953));
                                            let _e993 = select(_e965, _e963, (_e963 < _e965));
                                            let _e995 = select(_e966, _e964, (_e964 < _e966));
                                            let _e997 = select(_e993, _e989, (_e989 > _e993));
                                            let _e999 = select(_e995, _e991, (_e991 > _e995));
                                            let _e1001 = select(_e981, _e997, (_e997 > _e981));
                                            let _e1003 = select(_e983, _e999, (_e999 > _e983));
                                            let _e1005 = select(_e952, _e950, (_e950 > _e952));
                                            let _e1007 = select(_e953, _e951, (_e951 > _e953));
                                            let _e1009 = select(_e965, _e963, (_e963 > _e965));
                                            let _e1011 = select(_e966, _e964, (_e964 > _e966));
                                            let _e1013 = select(_e1009, _e1005, (_e1005 < _e1009));
                                            let _e1015 = select(_e1011, _e1007, (_e1007 < _e1011));
                                            let _e1020 = -(_e981);
                                            let _e1021 = -(_e983);
                                            let _e1028 = (select(_e985, _e1013, (_e1013 < _e985)) + (select(_e1020, _e985, (_e985 > _e1020)) * 0.0000019073523f));
                                            let _e1029 = (select(_e987, _e1015, (_e1015 < _e987)) + (select(_e1021, _e987, (_e987 > _e1021)) * 0.0000019073523f));
                                            let _e1031 = select(_e541, _e1001, (_e1001 > _e541));
                                            let _e1033 = select(_e541, _e1003, (_e1003 > _e541));
                                            let _e1038 = (_e1031 <= select(_e585.member, _e1028, (_e1028 < _e585.member)));
                                            let _e1039 = (_e1033 <= select(_e585.member, _e1029, (_e1029 < _e585.member)));
                                            let _e1040 = (_e1031 <= _e1033);
                                            if _e1038 {
                                                if _e1039 {
                                                    if _e1040 {
                                                        phi_4668_ = _e938.member_2;
                                                    } else {
                                                        phi_4668_ = _e938.member_1;
                                                    }
                                                    let _e1044 = phi_4668_;
                                                    let _e1045 = (_e618 % 128u);
                                                    let _e1046 = (_e1045 < 128u);
                                                    if _e1046 {
                                                    } else {
                                                        phi_5129_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1045] = type_60(type_30(_e1044.member.member, _e1044.member.member_1), _e1044.member_1);
                                                    if _e1046 {
                                                    } else {
                                                        phi_5129_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1045] = select(_e1033, _e1031, (_e1031 > _e1033));
                                                    if _e1040 {
                                                        phi_4701_ = _e938.member_1;
                                                    } else {
                                                        phi_4701_ = _e938.member_2;
                                                    }
                                                    let _e1061 = phi_4701_;
                                                    phi_4702_ = _e1061;
                                                    phi_4703_ = (_e618 + 1u);
                                                } else {
                                                    phi_4702_ = type_60();
                                                    phi_4703_ = u32();
                                                }
                                                let _e1063 = phi_4702_;
                                                let _e1065 = phi_4703_;
                                                phi_4705_ = _e1063;
                                                phi_4706_ = _e1065;
                                                phi_4707_ = select(true, false, _e1039);
                                            } else {
                                                phi_4705_ = type_60();
                                                phi_4706_ = u32();
                                                phi_4707_ = true;
                                            }
                                            let _e1068 = phi_4705_;
                                            let _e1070 = phi_4706_;
                                            let _e1072 = phi_4707_;
                                            if _e1072 {
                                                if _e1038 {
                                                    phi_4716_ = _e938.member_1;
                                                } else {
                                                    phi_4716_ = _e938.member_2;
                                                }
                                                let _e1076 = phi_4716_;
                                                phi_4721_ = _e1076;
                                                phi_4722_ = select(_e1039, true, _e1038);
                                            } else {
                                                phi_4721_ = _e1068;
                                                phi_4722_ = _e616;
                                            }
                                            let _e1079 = phi_4721_;
                                            let _e1081 = phi_4722_;
                                            phi_5133_ = _e583;
                                            phi_4724_ = _e585;
                                            phi_4725_ = _e1079;
                                            phi_4726_ = _e1081;
                                            phi_4727_ = select(_e1070, _e618, _e1072);
                                        }
                                        let _e1817 = phi_5133_;
                                        let _e1819 = phi_4724_;
                                        let _e1821 = phi_4725_;
                                        let _e1823 = phi_4726_;
                                        let _e1825 = phi_4727_;
                                        phi_5132_ = _e1817;
                                        phi_4728_ = _e1819;
                                        phi_4729_ = _e1821;
                                        phi_4730_ = (_e589 - 1u);
                                        phi_4731_ = _e1823;
                                        phi_4732_ = _e1825;
                                    } else {
                                        phi_5132_ = _e583;
                                        phi_4728_ = _e585;
                                        phi_4729_ = _e614;
                                        phi_4730_ = _e589;
                                        phi_4731_ = _e616;
                                        phi_4732_ = _e618;
                                    }
                                    let _e1827 = phi_5132_;
                                    let _e1829 = phi_4728_;
                                    let _e1831 = phi_4729_;
                                    let _e1833 = phi_4730_;
                                    let _e1835 = phi_4731_;
                                    let _e1837 = phi_4732_;
                                    phi_5131_ = _e1827;
                                    phi_4733_ = _e1829;
                                    phi_4734_ = _e1831;
                                    phi_4735_ = _e1833;
                                    phi_4736_ = _e1835;
                                    phi_4737_ = _e1837;
                                } else {
                                    phi_5131_ = _e583;
                                    phi_4733_ = type_41();
                                    phi_4734_ = type_60();
                                    phi_4735_ = u32();
                                    phi_4736_ = bool();
                                    phi_4737_ = u32();
                                }
                                let _e1839 = phi_5131_;
                                let _e1841 = phi_4733_;
                                let _e1843 = phi_4734_;
                                let _e1845 = phi_4735_;
                                let _e1847 = phi_4736_;
                                let _e1849 = phi_4737_;
                                phi_5130_ = _e1839;
                                phi_2041_ = _e1841;
                                phi_2044_ = _e1843;
                                phi_2046_ = _e1845;
                                phi_2048_ = _e1847;
                                phi_2050_ = _e1849;
                                phi_4738_ = _e597;
                            } else {
                                phi_5130_ = _e583;
                                phi_2041_ = type_41();
                                phi_2044_ = type_60();
                                phi_2046_ = u32();
                                phi_2048_ = bool();
                                phi_2050_ = u32();
                                phi_4738_ = false;
                            }
                            let _e1851 = phi_5130_;
                            let _e1853 = phi_2041_;
                            let _e1855 = phi_2044_;
                            let _e1857 = phi_2046_;
                            let _e1859 = phi_2048_;
                            let _e1861 = phi_2050_;
                            let _e1863 = phi_4738_;
                            continue;
                            continuing {
                                phi_4997_ = _e1851;
                                phi_2040_ = _e1853;
                                phi_2043_ = _e1855;
                                phi_2045_ = _e1857;
                                phi_2047_ = _e1859;
                                phi_2049_ = _e1861;
                                phi_5129_ = _e1851;
                                break if !(_e1863);
                            }
                        }
                        let _e1866 = phi_5129_;
                        if _e1866 {
                            break;
                        }
                        let _e1868 = local_8;
                        if _e1868.member_1 {
                        } else {
                            if _e235 {
                            } else {
                                break;
                            }
                            let _e1872 = global_2.member[_e145];
                            if _e160 {
                            } else {
                                break;
                            }
                            let _e1876 = global_9.member[_e145].member_1;
                            if _e235 {
                            } else {
                                break;
                            }
                            global_2.member[_e145] = type_23(_e1872.member, _e1872.member_1, _e1872.member_2, array<f32, 3>((_e1872.member_3[0] + (_e1876[0] * _e1872.member_1[0])), (_e1872.member_3[1] + (_e1876[1] * _e1872.member_1[1])), (_e1872.member_3[2] + (_e1876[2] * _e1872.member_1[2]))), _e1872.member_4);
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
fn trace_shadows_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
