struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_13 {
    member: array<array<u32, 4>>,
}

struct type_16 {
    member: vec4<u32>,
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

struct type_34 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_35 {
    member: type_26,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_37 {
    member: array<type_35>,
}

struct type_41 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_45 {
    member: f32,
    member_1: bool,
}

struct type_47 {
    member: array<vec4<u32>, 2>,
}

struct type_50 {
    member: array<i32>,
}

struct type_60 {
    member: type_34,
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
var<uniform> global_1: type_16;
@group(0) @binding(8) 
var<storage, read_write> global_2: type_29;
@group(0) @binding(1) 
var<uniform> global_3: type_47;
@group(0) @binding(2) 
var<uniform> global_4: type_47;
@group(0) @binding(3) 
var<storage> global_5: type_13;
@group(0) @binding(5) 
var<storage> global_6: type_4;
@group(0) @binding(6) 
var<storage> global_7: type_50;
@group(0) @binding(9) 
var<storage, read_write> global_8: type_70;
@group(0) @binding(7) 
var<storage> global_9: type_37;
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
    var phi_406_: type_41;
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
    var phi_2040_: type_45;
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
    var phi_2118_: type_45;
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
    var phi_3026_: type_25;
    var phi_3028_: type_25;
    var phi_3029_: bool;
    var phi_3033_: type_25;
    var phi_3034_: type_25;
    var phi_3035_: type_25;
    var phi_3036_: bool;
    var phi_3040_: type_25;
    var phi_3041_: bool;
    var phi_3045_: type_25;
    var phi_3046_: bool;
    var phi_3050_: type_25;
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
    var phi_3384_: type_45;
    var phi_3385_: type_45;
    var phi_5054_: bool;
    var phi_2119_: type_45;
    var phi_5053_: bool;
    var local_7: type_45;
    var phi_5133_: bool;
    var phi_4724_: type_45;
    var phi_4725_: type_60;
    var phi_4726_: bool;
    var phi_4727_: u32;
    var phi_5132_: bool;
    var phi_4728_: type_45;
    var phi_4729_: type_60;
    var phi_4730_: u32;
    var phi_4731_: bool;
    var phi_4732_: u32;
    var phi_5131_: bool;
    var phi_4733_: type_45;
    var phi_4734_: type_60;
    var phi_4735_: u32;
    var phi_4736_: bool;
    var phi_4737_: u32;
    var phi_5130_: bool;
    var phi_2041_: type_45;
    var phi_2044_: type_60;
    var phi_2046_: u32;
    var phi_2048_: bool;
    var phi_2050_: u32;
    var phi_4738_: bool;
    var phi_5129_: bool;
    var local_8: type_45;
    var local_9: type_45;

    switch bitcast<i32>(0u) {
        default: {
            let _e97 = global;
            let _e99 = arrayLength((&global_5.member));
            let _e102 = arrayLength((&global_10.member));
            let _e114 = arrayLength((&global_8.member));
            let _e118 = global_4.member[0u][0u];
            let _e122 = global_4.member[0u][1u];
            let _e126 = global_4.member[0u][2u];
            let _e130 = global_4.member[0u][3u];
            let _e134 = global_4.member[1u][0u];
            let _e138 = global_4.member[1u][1u];
            let _e142 = global_4.member[1u][2u];
            let _e146 = (_e97.x + (_e97.y * 2097152u));
            let _e158 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e130) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e118), bitcast<i32>(_e122), bitcast<i32>(_e126));
            local = array<i32, 3>(bitcast<i32>(_e134), bitcast<i32>(_e138), bitcast<i32>(_e142));
            let _e161 = (_e146 < arrayLength((&global_9.member)));
            if _e161 {
                if _e161 {
                } else {
                    break;
                }
                let _e165 = global_9.member[_e146].member_2;
                phi_341_ = _e165;
            } else {
                phi_341_ = 4294967295u;
            }
            let _e167 = phi_341_;
            let _e170 = global_1.member[0u];
            let _e174 = global_3.member[0u][0u];
            let _e178 = global_3.member[0u][1u];
            let _e182 = global_3.member[0u][2u];
            let _e186 = global_3.member[0u][3u];
            let _e190 = global_3.member[1u][0u];
            let _e194 = global_3.member[1u][1u];
            let _e198 = global_3.member[1u][2u];
            let _e202 = global_3.member[1u][3u];
            let _e203 = bitcast<f32>(_e174);
            let _e204 = bitcast<f32>(_e178);
            let _e205 = bitcast<f32>(_e182);
            let _e207 = bitcast<f32>(_e190);
            let _e208 = array<u32, 3>(_e194, _e198, _e202);
            let _e210 = bitcast<i32>(_e170);
            let _e211 = (_e210 / 2i);
            let _e216 = bitcast<f32>((bitcast<u32>((_e211 + 127i)) << bitcast<u32>(23i)));
            let _e222 = bitcast<f32>((bitcast<u32>(((_e210 - _e211) + 127i)) << bitcast<u32>(23i)));
            if (_e186 == 0u) {
                phi_406_ = type_41(array<f32, 3>(_e203, _e204, _e205), _e186, _e207, _e208);
            } else {
                phi_406_ = type_41(array<f32, 3>(((_e203 * _e216) * _e222), ((_e204 * _e216) * _e222), ((_e205 * _e216) * _e222)), _e186, ((_e207 * _e216) * _e222), _e208);
            }
            let _e235 = phi_406_;
            if _e161 {
                let _e236 = (_e146 < arrayLength((&global_2.member)));
                if _e236 {
                    if _e161 {
                    } else {
                        break;
                    }
                    let _e241 = global_9.member[_e146].member.member_1;
                    let _e246 = global_9.member[_e146].member.member_3;
                    if (_e241 <= _e246) {
                        let _e248 = (1u < _e114);
                        if _e248 {
                            if (0u < _e114) {
                            } else {
                                break;
                            }
                            let _e252 = atomicAdd((&global_8.member[0u]), 1u);
                            if ((_e252 + 1u) < _e252) {
                                if _e248 {
                                } else {
                                    break;
                                }
                                let _e257 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                        if _e161 {
                        } else {
                            break;
                        }
                        let _e267 = global_9.member[_e146].member.member_2[0u];
                        let _e269 = (bitcast<u32>(_e267) & 2147483647u);
                        let _e275 = global_9.member[_e146].member.member_2[1u];
                        let _e277 = (bitcast<u32>(_e275) & 2147483647u);
                        let _e283 = global_9.member[_e146].member.member_2[2u];
                        let _e285 = (bitcast<u32>(_e283) & 2147483647u);
                        let _e291 = global_9.member[_e146].member.member[0u];
                        let _e293 = (bitcast<u32>(_e291) & 2147483647u);
                        let _e299 = global_9.member[_e146].member.member[1u];
                        let _e301 = (bitcast<u32>(_e299) & 2147483647u);
                        let _e307 = global_9.member[_e146].member.member[2u];
                        let _e309 = (bitcast<u32>(_e307) & 2147483647u);
                        let _e311 = select(_e277, _e269, (_e277 < _e269));
                        let _e313 = select(_e285, _e311, (_e285 < _e311));
                        let _e315 = select(_e293, _e313, (_e293 < _e313));
                        let _e317 = select(_e301, _e315, (_e301 < _e315));
                        let _e319 = select(_e309, _e317, (_e309 < _e317));
                        let _e321 = (bitcast<u32>(_e241) & 2147483647u);
                        let _e330 = (((select(_e321, _e319, (_e321 < _e319)) < 2139095040u) && ((bitcast<u32>(_e246) & 2147483647u) <= 2139095040u)) && (_e313 > 0u));
                        if _e330 {
                            let _e333 = (bitcast<u32>(bitcast<f32>(_e313)) & 2147483647u);
                            if (_e333 >= 8388608u) {
                                phi_556_ = (bitcast<i32>((_e333 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_556_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e333)), 32u, (_e333 == 0u))));
                            }
                            let _e347 = phi_556_;
                            phi_557_ = _e347;
                        } else {
                            phi_557_ = 0i;
                        }
                        let _e349 = phi_557_;
                        let _e350 = (_e269 == _e313);
                        if _e350 {
                            phi_567_ = true;
                        } else {
                            phi_567_ = (_e277 == _e313);
                        }
                        let _e353 = phi_567_;
                        let _e354 = select(1u, 0u, _e350);
                        if _e353 {
                            let _e355 = (_e354 + 1u);
                            phi_577_ = _e355;
                            phi_578_ = _e355;
                            phi_580_ = select(true, false, (_e355 == 2u));
                        } else {
                            phi_577_ = u32();
                            phi_578_ = 0u;
                            phi_580_ = true;
                        }
                        let _e359 = phi_577_;
                        let _e361 = phi_578_;
                        let _e363 = phi_580_;
                        if _e363 {
                            phi_585_ = (_e361 + 1u);
                        } else {
                            phi_585_ = 0u;
                        }
                        let _e367 = phi_585_;
                        let _e368 = select(_e359, _e361, _e363);
                        let _e369 = select(_e354, select(2u, _e354, _e353), _e363);
                        let _e370 = -(_e349);
                        let _e371 = (_e370 / 2i);
                        let _e376 = bitcast<f32>((bitcast<u32>((_e371 + 127i)) << bitcast<u32>(23i)));
                        let _e382 = bitcast<f32>((bitcast<u32>(((_e370 - _e371) + 127i)) << bitcast<u32>(23i)));
                        let _e387 = global_9.member[_e146].member.member;
                        let _e388 = (_e368 == 0u);
                        if _e388 {
                            phi_630_ = _e387[0];
                        } else {
                            phi_630_ = _e387[1];
                        }
                        let _e392 = phi_630_;
                        let _e393 = (_e368 == 2u);
                        if _e393 {
                            phi_636_ = _e387[2];
                        } else {
                            phi_636_ = _e392;
                        }
                        let _e396 = phi_636_;
                        let _e397 = global_9.member[_e146].member.member_2;
                        if _e388 {
                            phi_647_ = _e397[0];
                        } else {
                            phi_647_ = _e397[1];
                        }
                        let _e401 = phi_647_;
                        if _e393 {
                            phi_653_ = _e397[2];
                        } else {
                            phi_653_ = _e401;
                        }
                        let _e404 = phi_653_;
                        let _e406 = ((_e404 * _e376) * _e382);
                        let _e410 = (bitcast<f32>((bitcast<u32>(_e406) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e410 {
                            let _e414 = (bitcast<f32>((bitcast<u32>(_e396) & 2147483647u)) * 0.00000011920929f);
                            phi_676_ = select(0.00000000000011368684f, _e414, (_e414 > 0.00000000000011368684f));
                        } else {
                            phi_676_ = 0f;
                        }
                        let _e418 = phi_676_;
                        let _e419 = (_e396 + _e418);
                        let _e420 = (_e396 - _e418);
                        let _e421 = select(_e406, 0f, _e410);
                        if _e410 {
                            phi_687_ = 38685626000000000000000000f;
                        } else {
                            phi_687_ = (1f / _e406);
                        }
                        let _e424 = phi_687_;
                        let _e425 = (_e367 == 0u);
                        if _e425 {
                            phi_696_ = _e387[0];
                        } else {
                            phi_696_ = _e387[1];
                        }
                        let _e429 = phi_696_;
                        let _e430 = (_e367 == 2u);
                        if _e430 {
                            phi_702_ = _e387[2];
                        } else {
                            phi_702_ = _e429;
                        }
                        let _e433 = phi_702_;
                        if _e425 {
                            phi_713_ = _e397[0];
                        } else {
                            phi_713_ = _e397[1];
                        }
                        let _e437 = phi_713_;
                        if _e430 {
                            phi_719_ = _e397[2];
                        } else {
                            phi_719_ = _e437;
                        }
                        let _e440 = phi_719_;
                        let _e442 = ((_e440 * _e376) * _e382);
                        let _e446 = (bitcast<f32>((bitcast<u32>(_e442) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e446 {
                            let _e450 = (bitcast<f32>((bitcast<u32>(_e433) & 2147483647u)) * 0.00000011920929f);
                            phi_742_ = select(0.00000000000011368684f, _e450, (_e450 > 0.00000000000011368684f));
                        } else {
                            phi_742_ = 0f;
                        }
                        let _e454 = phi_742_;
                        let _e455 = (_e433 + _e454);
                        let _e456 = (_e433 - _e454);
                        let _e457 = select(_e442, 0f, _e446);
                        if _e446 {
                            phi_753_ = 38685626000000000000000000f;
                        } else {
                            phi_753_ = (1f / _e442);
                        }
                        let _e460 = phi_753_;
                        let _e461 = (_e369 == 0u);
                        if _e461 {
                            phi_762_ = _e387[0];
                        } else {
                            phi_762_ = _e387[1];
                        }
                        let _e465 = phi_762_;
                        let _e466 = (_e369 == 2u);
                        if _e466 {
                            phi_768_ = _e387[2];
                        } else {
                            phi_768_ = _e465;
                        }
                        let _e469 = phi_768_;
                        if _e461 {
                            phi_779_ = _e397[0];
                        } else {
                            phi_779_ = _e397[1];
                        }
                        let _e473 = phi_779_;
                        if _e466 {
                            phi_785_ = _e397[2];
                        } else {
                            phi_785_ = _e473;
                        }
                        let _e476 = phi_785_;
                        let _e478 = ((_e476 * _e376) * _e382);
                        let _e482 = (bitcast<f32>((bitcast<u32>(_e478) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e482 {
                            let _e486 = (bitcast<f32>((bitcast<u32>(_e469) & 2147483647u)) * 0.00000011920929f);
                            phi_808_ = select(0.00000000000011368684f, _e486, (_e486 > 0.00000000000011368684f));
                        } else {
                            phi_808_ = 0f;
                        }
                        let _e490 = phi_808_;
                        let _e491 = (_e469 + _e490);
                        let _e492 = (_e469 - _e490);
                        let _e493 = select(_e478, 0f, _e482);
                        if _e482 {
                            phi_819_ = 38685626000000000000000000f;
                        } else {
                            phi_819_ = (1f / _e478);
                        }
                        let _e496 = phi_819_;
                        let _e499 = bitcast<f32>((bitcast<u32>(_e396) & 2147483647u));
                        let _e502 = bitcast<f32>((bitcast<u32>(_e433) & 2147483647u));
                        let _e504 = select(_e502, _e499, (_e499 > _e502));
                        let _e507 = bitcast<f32>((bitcast<u32>(_e469) & 2147483647u));
                        if (_e330 && (select(_e507, _e504, (_e504 > _e507)) <= 1099511600000f)) {
                            let _e512 = (_e349 / 3i);
                            let _e519 = bitcast<f32>((bitcast<u32>((_e512 + 127i)) << bitcast<u32>(23i)));
                            let _e526 = bitcast<f32>((bitcast<u32>(((_e349 - (2i * _e512)) + 127i)) << bitcast<u32>(23i)));
                            let _e527 = (((_e241 * _e519) * _e519) * _e526);
                            let _e529 = select(340282350000000000000000000000000000000f, _e527, (_e527 < 340282350000000000000000000000000000000f));
                            let _e534 = (((_e246 * _e519) * _e519) * _e526);
                            let _e536 = select(340282350000000000000000000000000000000f, _e534, (_e534 < 340282350000000000000000000000000000000f));
                            phi_919_ = select(-340282350000000000000000000000000000000f, _e536, (_e536 > -340282350000000000000000000000000000000f));
                            phi_920_ = select(-340282350000000000000000000000000000000f, _e529, (_e529 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_919_ = 0f;
                            phi_920_ = 1f;
                        }
                        let _e540 = phi_919_;
                        let _e542 = phi_920_;
                        local_3 = array<type_60, 128>(type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e546 = (_e368 % 3u);
                        let _e547 = (_e546 < 3u);
                        if _e547 {
                        } else {
                            break;
                        }
                        let _e549 = local_1[_e546];
                        let _e552 = (_e367 % 3u);
                        let _e553 = (_e552 < 3u);
                        if _e553 {
                        } else {
                            break;
                        }
                        let _e555 = local_1[_e552];
                        let _e558 = (_e369 % 3u);
                        let _e559 = (_e558 < 3u);
                        if _e559 {
                        } else {
                            break;
                        }
                        let _e561 = local_1[_e558];
                        if _e547 {
                        } else {
                            break;
                        }
                        let _e566 = local[_e546];
                        if _e553 {
                        } else {
                            break;
                        }
                        let _e570 = local[_e552];
                        if _e559 {
                        } else {
                            break;
                        }
                        let _e574 = local[_e558];
                        phi_4997_ = false;
                        phi_2040_ = type_45(_e540, false);
                        phi_2043_ = type_60(type_34(vec4<f32>((f32(_e549) * _e158), (f32(_e555) * _e158), (f32(_e561) * _e158), 0f), vec4<f32>((f32(_e566) * _e158), (f32(_e570) * _e158), (f32(_e574) * _e158), 0f)), select(0u, 2147483648u, (_e99 == 0u)));
                        phi_2045_ = ((3u * _e99) + 1u);
                        phi_2047_ = (_e542 <= _e540);
                        phi_2049_ = 0u;
                        loop {
                            let _e584 = phi_4997_;
                            let _e586 = phi_2040_;
                            let _e588 = phi_2043_;
                            let _e590 = phi_2045_;
                            let _e592 = phi_2047_;
                            let _e594 = phi_2049_;
                            local_8 = _e586;
                            if _e592 {
                                phi_2060_ = true;
                            } else {
                                phi_2060_ = (_e594 > 0u);
                            }
                            let _e597 = phi_2060_;
                            if _e597 {
                                let _e598 = (_e590 > 0u);
                                if _e598 {
                                    if _e592 {
                                        phi_2097_ = _e588;
                                        phi_2098_ = _e592;
                                        phi_2099_ = _e594;
                                    } else {
                                        let _e599 = (_e594 - 1u);
                                        let _e600 = (_e599 % 128u);
                                        let _e601 = (_e600 < 128u);
                                        if _e601 {
                                        } else {
                                            phi_5129_ = true;
                                            break;
                                        }
                                        let _e603 = local_3[_e600];
                                        if _e601 {
                                        } else {
                                            phi_5129_ = true;
                                            break;
                                        }
                                        let _e611 = local_2[_e600];
                                        phi_2097_ = type_60(type_34(_e603.member.member, _e603.member.member_1), _e603.member_1);
                                        phi_2098_ = (_e611 <= _e586.member);
                                        phi_2099_ = _e599;
                                    }
                                    let _e615 = phi_2097_;
                                    let _e617 = phi_2098_;
                                    let _e619 = phi_2099_;
                                    if _e617 {
                                        let _e624 = (_e615.member_1 & 268435455u);
                                        if ((_e615.member_1 & 2147483648u) != 0u) {
                                            phi_4994_ = _e584;
                                            phi_2118_ = _e586;
                                            phi_2121_ = type_8(0u, ((_e615.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1086 = phi_4994_;
                                                let _e1088 = phi_2118_;
                                                let _e1090 = phi_2121_;
                                                local_7 = _e1088;
                                                local_9 = _e1088;
                                                if (_e1090.member < _e1090.member_1) {
                                                    phi_2122_ = type_8((_e1090.member + 1u), _e1090.member_1);
                                                    phi_2144_ = type_8(1u, _e1090.member);
                                                } else {
                                                    phi_2122_ = _e1090;
                                                    phi_2144_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1103 = phi_2122_;
                                                let _e1105 = phi_2144_;
                                                let _e1109 = (bitcast<i32>(_e1105.member) != 0i);
                                                if _e1109 {
                                                    let _e1114 = (_e615.member.member_1.x - _e615.member.member.x);
                                                    let _e1117 = (_e615.member.member_1.y - _e615.member.member.y);
                                                    let _e1120 = (_e615.member.member_1.z - _e615.member.member.z);
                                                    let _e1122 = select(_e1117, _e1114, (_e1114 > _e1117));
                                                    let _e1124 = select(_e1120, _e1122, (_e1122 > _e1120));
                                                    let _e1126 = (_e1124 < (1024f * _e158));
                                                    if _e1126 {
                                                        phi_2185_ = 0u;
                                                    } else {
                                                        phi_2185_ = select(2u, 1u, (_e1124 < (2097152f * _e158)));
                                                    }
                                                    let _e1131 = phi_2185_;
                                                    switch bitcast<i32>(_e1131) {
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
                                                    let _e1134 = phi_2191_;
                                                    switch bitcast<i32>(_e1131) {
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
                                                    let _e1141 = phi_2201_;
                                                    let _e1143 = ((_e624 + (_e1105.member_1 * ((3u * _e1134) + 1u))) + (3u * _e1141));
                                                    let _e1144 = (_e1143 < _e102);
                                                    if _e1144 {
                                                        if _e1144 {
                                                        } else {
                                                            phi_5053_ = true;
                                                            break;
                                                        }
                                                        let _e1146 = global_10.member[_e1143];
                                                        phi_2217_ = _e1146;
                                                    } else {
                                                        phi_2217_ = 4294967295u;
                                                    }
                                                    let _e1148 = phi_2217_;
                                                    local_4 = array<u32, 3>(_e368, _e367, _e369);
                                                    if _e1126 {
                                                        phi_2254_ = 0u;
                                                    } else {
                                                        phi_2254_ = select(2u, 1u, (_e1124 < (2097152f * _e158)));
                                                    }
                                                    let _e1154 = phi_2254_;
                                                    switch bitcast<i32>(_e1154) {
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
                                                    let _e1157 = phi_2260_;
                                                    switch bitcast<i32>(_e1154) {
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
                                                    let _e1164 = phi_2270_;
                                                    local_6 = array<f32, 4>(_e615.member.member.x, _e615.member.member.y, _e615.member.member.z, _e615.member.member.w);
                                                    local_5[0u] = array<f32, 3>(0f, 0f, 0f);
                                                    local_5[1u] = array<f32, 3>(0f, 0f, 0f);
                                                    local_5[2u] = array<f32, 3>(0f, 0f, 0f);
                                                    phi_4979_ = _e1086;
                                                    phi_2286_ = type_8(0u, 3u);
                                                    loop {
                                                        let _e1178 = phi_4979_;
                                                        let _e1180 = phi_2286_;
                                                        if (_e1180.member < _e1180.member_1) {
                                                            phi_2287_ = type_8((_e1180.member + 1u), _e1180.member_1);
                                                            phi_2310_ = type_8(1u, _e1180.member);
                                                        } else {
                                                            phi_2287_ = _e1180;
                                                            phi_2310_ = type_8(0u, type_8().member_1);
                                                        }
                                                        let _e1193 = phi_2287_;
                                                        let _e1195 = phi_2310_;
                                                        let _e1199 = (bitcast<i32>(_e1195.member) != 0i);
                                                        if _e1199 {
                                                            let _e1201 = ((_e624 + (_e1105.member_1 * ((3u * _e1157) + 1u))) + (_e1195.member_1 * _e1164));
                                                            let _e1202 = (_e1201 < _e102);
                                                            if _e1202 {
                                                                if _e1202 {
                                                                } else {
                                                                    phi_5051_ = true;
                                                                    break;
                                                                }
                                                                let _e1204 = global_10.member[_e1201];
                                                                phi_2333_ = _e1204;
                                                            } else {
                                                                phi_2333_ = 0u;
                                                            }
                                                            let _e1206 = phi_2333_;
                                                            let _e1207 = (_e1201 + 1u);
                                                            let _e1208 = (_e1207 < _e102);
                                                            if _e1208 {
                                                                if _e1208 {
                                                                } else {
                                                                    phi_5051_ = true;
                                                                    break;
                                                                }
                                                                let _e1210 = global_10.member[_e1207];
                                                                phi_2348_ = _e1210;
                                                            } else {
                                                                phi_2348_ = 0u;
                                                            }
                                                            let _e1212 = phi_2348_;
                                                            phi_2351_ = type_8(0u, 3u);
                                                            loop {
                                                                let _e1214 = phi_2351_;
                                                                if (_e1214.member < _e1214.member_1) {
                                                                    phi_2352_ = type_8((_e1214.member + 1u), _e1214.member_1);
                                                                    phi_2375_ = type_8(1u, _e1214.member);
                                                                } else {
                                                                    phi_2352_ = _e1214;
                                                                    phi_2375_ = type_8(0u, type_8().member_1);
                                                                }
                                                                let _e1227 = phi_2352_;
                                                                let _e1229 = phi_2375_;
                                                                let _e1233 = (bitcast<i32>(_e1229.member) != 0i);
                                                                if _e1233 {
                                                                    let _e1234 = (_e1229.member_1 < 3u);
                                                                    if _e1234 {
                                                                    } else {
                                                                        phi_4972_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1236 = local_4[_e1229.member_1];
                                                                    if (_e1229.member_1 < 4u) {
                                                                    } else {
                                                                        phi_4972_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1239 = local_6[_e1229.member_1];
                                                                    switch bitcast<i32>(_e1154) {
                                                                        case 0: {
                                                                            phi_2445_ = (_e1239 + (f32(((_e1206 >> bitcast<u32>(((10u * _e1236) & 31u))) & 1023u)) * _e158));
                                                                            break;
                                                                        }
                                                                        case 1: {
                                                                            if (_e1236 == 0u) {
                                                                                phi_2422_ = _e1206;
                                                                            } else {
                                                                                if (_e1236 == 1u) {
                                                                                    phi_2421_ = ((_e1206 >> bitcast<u32>(21i)) | (_e1212 << bitcast<u32>(11i)));
                                                                                } else {
                                                                                    phi_2421_ = (_e1212 >> bitcast<u32>(10i));
                                                                                }
                                                                                let _e1260 = phi_2421_;
                                                                                phi_2422_ = _e1260;
                                                                            }
                                                                            let _e1262 = phi_2422_;
                                                                            phi_2445_ = (_e1239 + (f32((_e1262 & 2097151u)) * _e158));
                                                                            break;
                                                                        }
                                                                        case 2: {
                                                                            let _e1241 = (_e1201 + _e1236);
                                                                            let _e1242 = (_e1241 < _e102);
                                                                            if _e1242 {
                                                                                if _e1242 {
                                                                                } else {
                                                                                    phi_4972_ = true;
                                                                                    break;
                                                                                }
                                                                                let _e1244 = global_10.member[_e1241];
                                                                                phi_2441_ = _e1244;
                                                                            } else {
                                                                                phi_2441_ = 0u;
                                                                            }
                                                                            let _e1246 = phi_2441_;
                                                                            phi_2445_ = (f32(bitcast<i32>(_e1246)) * _e158);
                                                                            break;
                                                                        }
                                                                        default: {
                                                                            phi_2445_ = f32();
                                                                            break;
                                                                        }
                                                                    }
                                                                    let _e1276 = phi_2445_;
                                                                    if (_e1195.member_1 < 3u) {
                                                                    } else {
                                                                        phi_4972_ = true;
                                                                        break;
                                                                    }
                                                                    if _e1234 {
                                                                    } else {
                                                                        phi_4972_ = true;
                                                                        break;
                                                                    }
                                                                    local_5[_e1195.member_1][_e1229.member_1] = _e1276;
                                                                }
                                                                continue;
                                                                continuing {
                                                                    phi_2351_ = _e1227;
                                                                    phi_4972_ = _e1178;
                                                                    break if !(_e1233);
                                                                }
                                                            }
                                                            let _e1282 = phi_4972_;
                                                            phi_5051_ = _e1282;
                                                            if _e1282 {
                                                                break;
                                                            }
                                                            phi_5052_ = _e1282;
                                                        } else {
                                                            phi_5052_ = _e1178;
                                                        }
                                                        let _e1284 = phi_5052_;
                                                        continue;
                                                        continuing {
                                                            phi_4979_ = _e1284;
                                                            phi_2286_ = _e1193;
                                                            phi_5051_ = _e1284;
                                                            break if !(_e1199);
                                                        }
                                                    }
                                                    let _e1287 = phi_5051_;
                                                    phi_5053_ = _e1287;
                                                    if _e1287 {
                                                        break;
                                                    }
                                                    let _e1288 = local_5;
                                                    let _e1304 = (_e1288[0][2] - _e469);
                                                    let _e1307 = (((_e1288[0][0] - _e396) * _e493) - (_e1304 * _e421));
                                                    let _e1310 = (((_e1288[0][1] - _e433) * _e493) - (_e1304 * _e457));
                                                    let _e1313 = (_e1288[1][2] - _e469);
                                                    let _e1316 = (((_e1288[1][0] - _e396) * _e493) - (_e1313 * _e421));
                                                    let _e1319 = (((_e1288[1][1] - _e433) * _e493) - (_e1313 * _e457));
                                                    let _e1322 = (_e1288[2][2] - _e469);
                                                    let _e1325 = (((_e1288[2][0] - _e396) * _e493) - (_e1322 * _e421));
                                                    let _e1328 = (((_e1288[2][1] - _e433) * _e493) - (_e1322 * _e457));
                                                    let _e1329 = (_e1325 * _e1319);
                                                    let _e1330 = (_e1328 * _e1316);
                                                    let _e1331 = (_e1307 * _e1328);
                                                    let _e1332 = (_e1310 * _e1325);
                                                    let _e1333 = (_e1316 * _e1310);
                                                    let _e1334 = (_e1319 * _e1307);
                                                    let _e1339 = (((_e1329 >= _e1330) && (_e1331 >= _e1332)) && (_e1333 >= _e1334));
                                                    if (_e1339 || (((_e1329 <= _e1330) && (_e1331 <= _e1332)) && (_e1333 <= _e1334))) {
                                                        let _e1346 = select(-1f, 1f, _e1339);
                                                        let _e1348 = ((_e1329 - _e1330) * _e1346);
                                                        let _e1350 = select(0f, _e1348, (_e1348 > 0f));
                                                        let _e1352 = ((_e1331 - _e1332) * _e1346);
                                                        let _e1354 = select(0f, _e1352, (_e1352 > 0f));
                                                        let _e1356 = ((_e1333 - _e1334) * _e1346);
                                                        let _e1358 = select(0f, _e1356, (_e1356 > 0f));
                                                        let _e1360 = ((_e1350 + _e1354) + _e1358);
                                                        if (_e1360 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_3040_ = type_25();
                                                            phi_3041_ = true;
                                                        } else {
                                                            let _e1363 = select(_e1288[1][0], _e1288[0][0], (_e1288[0][0] < _e1288[1][0]));
                                                            let _e1367 = select(_e1288[1][0], _e1288[0][0], (_e1288[0][0] > _e1288[1][0]));
                                                            let _e1371 = select(_e1288[1][1], _e1288[0][1], (_e1288[0][1] < _e1288[1][1]));
                                                            let _e1375 = select(_e1288[1][1], _e1288[0][1], (_e1288[0][1] > _e1288[1][1]));
                                                            let _e1379 = select(_e1288[1][2], _e1288[0][2], (_e1288[0][2] < _e1288[1][2]));
                                                            let _e1383 = select(_e1288[1][2], _e1288[0][2], (_e1288[0][2] > _e1288[1][2]));
                                                            let _e1388 = ((select(_e1288[2][0], _e1363, (_e1363 < _e1288[2][0])) - _e419) * _e424);
                                                            let _e1389 = ((select(_e1288[2][0], _e1367, (_e1367 > _e1288[2][0])) - _e420) * _e424);
                                                            let _e1392 = ((select(_e1288[2][1], _e1371, (_e1371 < _e1288[2][1])) - _e455) * _e460);
                                                            let _e1393 = ((select(_e1288[2][1], _e1375, (_e1375 > _e1288[2][1])) - _e456) * _e460);
                                                            let _e1396 = ((select(_e1288[2][2], _e1379, (_e1379 < _e1288[2][2])) - _e491) * _e496);
                                                            let _e1397 = ((select(_e1288[2][2], _e1383, (_e1383 > _e1288[2][2])) - _e492) * _e496);
                                                            let _e1399 = select(_e1397, _e1396, (_e1396 < _e1397));
                                                            let _e1401 = select(_e1397, _e1396, (_e1396 > _e1397));
                                                            let _e1403 = select(_e1389, _e1388, (_e1388 < _e1389));
                                                            let _e1405 = select(_e1393, _e1392, (_e1392 < _e1393));
                                                            let _e1407 = select(_e1405, _e1403, (_e1403 > _e1405));
                                                            let _e1409 = select(_e1399, _e1407, (_e1407 > _e1399));
                                                            let _e1411 = select(_e1389, _e1388, (_e1388 > _e1389));
                                                            let _e1413 = select(_e1393, _e1392, (_e1392 > _e1393));
                                                            let _e1415 = select(_e1413, _e1411, (_e1411 < _e1413));
                                                            let _e1417 = select(_e1401, _e1415, (_e1415 < _e1401));
                                                            let _e1418 = -(_e1399);
                                                            let _e1424 = select(_e542, _e1409, (_e1409 > _e542));
                                                            if (_e1424 > (_e1417 + (select(_e1418, _e1401, (_e1401 > _e1418)) * 0.0000019073523f))) {
                                                                phi_3035_ = type_25();
                                                                phi_3036_ = true;
                                                            } else {
                                                                let _e1426 = (_e1424 > _e1088.member);
                                                                if _e1426 {
                                                                    phi_3034_ = type_25();
                                                                } else {
                                                                    let _e1430 = (_e1288[1][0] - _e1288[0][0]);
                                                                    let _e1431 = (_e1288[1][1] - _e1288[0][1]);
                                                                    let _e1432 = (_e1288[1][2] - _e1288[0][2]);
                                                                    let _e1433 = vec3<f32>(_e1430, _e1431, _e1432);
                                                                    let _e1434 = (_e1288[2][0] - _e1288[1][0]);
                                                                    let _e1435 = (_e1288[2][1] - _e1288[1][1]);
                                                                    let _e1436 = (_e1288[2][2] - _e1288[1][2]);
                                                                    let _e1437 = vec3<f32>(_e1434, _e1435, _e1436);
                                                                    let _e1438 = (_e1288[0][0] - _e1288[2][0]);
                                                                    let _e1439 = (_e1288[0][1] - _e1288[2][1]);
                                                                    let _e1440 = (_e1288[0][2] - _e1288[2][2]);
                                                                    let _e1441 = vec3<f32>(_e1438, _e1439, _e1440);
                                                                    let _e1444 = bitcast<f32>((bitcast<u32>(_e1430) & 2147483647u));
                                                                    let _e1447 = bitcast<f32>((bitcast<u32>(_e1431) & 2147483647u));
                                                                    let _e1449 = select(_e1447, _e1444, (_e1444 > _e1447));
                                                                    let _e1452 = bitcast<f32>((bitcast<u32>(_e1432) & 2147483647u));
                                                                    let _e1454 = select(_e1452, _e1449, (_e1449 > _e1452));
                                                                    let _e1457 = bitcast<f32>((bitcast<u32>(_e1434) & 2147483647u));
                                                                    let _e1460 = bitcast<f32>((bitcast<u32>(_e1435) & 2147483647u));
                                                                    let _e1462 = select(_e1460, _e1457, (_e1457 > _e1460));
                                                                    let _e1465 = bitcast<f32>((bitcast<u32>(_e1436) & 2147483647u));
                                                                    let _e1467 = select(_e1465, _e1462, (_e1462 > _e1465));
                                                                    let _e1470 = bitcast<f32>((bitcast<u32>(_e1438) & 2147483647u));
                                                                    let _e1473 = bitcast<f32>((bitcast<u32>(_e1439) & 2147483647u));
                                                                    let _e1475 = select(_e1473, _e1470, (_e1470 > _e1473));
                                                                    let _e1478 = bitcast<f32>((bitcast<u32>(_e1440) & 2147483647u));
                                                                    let _e1480 = select(_e1478, _e1475, (_e1475 > _e1478));
                                                                    let _e1482 = select(_e1467, _e1454, (_e1454 > _e1467));
                                                                    let _e1484 = select(_e1480, _e1482, (_e1482 > _e1480));
                                                                    if (_e1454 == _e1484) {
                                                                        phi_2945_ = _e1437;
                                                                        phi_2946_ = _e1441;
                                                                    } else {
                                                                        let _e1487 = vec3((_e1467 == _e1484));
                                                                        phi_2945_ = select(_e1433, _e1441, _e1487);
                                                                        phi_2946_ = select(_e1437, _e1433, _e1487);
                                                                    }
                                                                    let _e1491 = phi_2945_;
                                                                    let _e1493 = phi_2946_;
                                                                    let _e1500 = ((_e1491.y * _e1493.z) - (_e1493.y * _e1491.z));
                                                                    let _e1505 = ((_e1491.z * _e1493.x) - (_e1493.z * _e1491.x));
                                                                    let _e1508 = ((_e1491.x * _e1493.y) - (_e1493.x * _e1491.y));
                                                                    if (_e1350 >= _e1354) {
                                                                        phi_2977_ = select(true, false, (_e1350 >= _e1358));
                                                                    } else {
                                                                        phi_2977_ = true;
                                                                    }
                                                                    let _e1513 = phi_2977_;
                                                                    if _e1513 {
                                                                        phi_2986_ = select(vec3<f32>(_e1288[2][0], _e1288[2][1], _e1288[2][2]), vec3<f32>(_e1288[1][0], _e1288[1][1], _e1288[1][2]), vec3((_e1354 >= _e1358)));
                                                                    } else {
                                                                        phi_2986_ = vec3<f32>(_e1288[0][0], _e1288[0][1], _e1288[0][2]);
                                                                    }
                                                                    let _e1518 = phi_2986_;
                                                                    let _e1535 = ((((_e1500 * (_e1518.x - _e396)) + (_e1505 * (_e1518.y - _e433))) + (_e1508 * (_e1518.z - _e469))) / (((_e1500 * _e421) + (_e1505 * _e457)) + (_e1508 * _e493)));
                                                                    let _e1537 = select(_e1417, _e1535, (_e1535 < _e1417));
                                                                    let _e1539 = select(_e1409, _e1537, (_e1537 > _e1409));
                                                                    if (_e1539 >= _e542) {
                                                                        let _e1541 = (_e1539 <= _e1088.member);
                                                                        if _e1541 {
                                                                            let _e1542 = (1f / _e1360);
                                                                            phi_3026_ = type_25(_e1539, (_e1354 * _e1542), (_e1358 * _e1542), _e1148);
                                                                        } else {
                                                                            phi_3026_ = type_25();
                                                                        }
                                                                        let _e1547 = phi_3026_;
                                                                        phi_3028_ = _e1547;
                                                                        phi_3029_ = select(true, false, _e1541);
                                                                    } else {
                                                                        phi_3028_ = type_25();
                                                                        phi_3029_ = true;
                                                                    }
                                                                    let _e1550 = phi_3028_;
                                                                    let _e1552 = phi_3029_;
                                                                    if _e1552 {
                                                                        phi_3033_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_3033_ = _e1550;
                                                                    }
                                                                    let _e1554 = phi_3033_;
                                                                    phi_3034_ = _e1554;
                                                                }
                                                                let _e1556 = phi_3034_;
                                                                phi_3035_ = _e1556;
                                                                phi_3036_ = _e1426;
                                                            }
                                                            let _e1558 = phi_3035_;
                                                            let _e1560 = phi_3036_;
                                                            phi_3040_ = _e1558;
                                                            phi_3041_ = _e1560;
                                                        }
                                                        let _e1562 = phi_3040_;
                                                        let _e1564 = phi_3041_;
                                                        phi_3045_ = _e1562;
                                                        phi_3046_ = _e1564;
                                                    } else {
                                                        phi_3045_ = type_25();
                                                        phi_3046_ = true;
                                                    }
                                                    let _e1566 = phi_3045_;
                                                    let _e1568 = phi_3046_;
                                                    if _e1568 {
                                                        phi_3050_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_3050_ = _e1566;
                                                    }
                                                    let _e1570 = phi_3050_;
                                                    if (_e1570.member_3 != 4294967295u) {
                                                        if (_e1148 == _e167) {
                                                            phi_3379_ = false;
                                                        } else {
                                                            let _e1574 = (_e1148 < arrayLength((&global_6.member)));
                                                            if _e1574 {
                                                                if _e1574 {
                                                                } else {
                                                                    phi_5053_ = true;
                                                                    break;
                                                                }
                                                                let _e1576 = global_6.member[_e1148];
                                                                phi_3073_ = _e1576;
                                                            } else {
                                                                phi_3073_ = 4294967295u;
                                                            }
                                                            let _e1578 = phi_3073_;
                                                            let _e1579 = (_e1578 < arrayLength((&global_7.member)));
                                                            if _e1579 {
                                                                if _e1579 {
                                                                } else {
                                                                    phi_5053_ = true;
                                                                    break;
                                                                }
                                                                let _e1581 = global_7.member[_e1578];
                                                                phi_3087_ = _e1581;
                                                            } else {
                                                                phi_3087_ = 0i;
                                                            }
                                                            let _e1583 = phi_3087_;
                                                            let _e1584 = (_e1583 == 0i);
                                                            if _e1584 {
                                                                phi_3378_ = true;
                                                            } else {
                                                                if _e388 {
                                                                    phi_3108_ = vec3<f32>(_e1288[0][0], _e1288[0][1], _e1288[0][2]);
                                                                } else {
                                                                    if (_e368 == 1u) {
                                                                        phi_3107_ = vec3<f32>(_e1288[0][2], _e1288[0][0], _e1288[0][1]);
                                                                    } else {
                                                                        phi_3107_ = vec3<f32>(_e1288[0][1], _e1288[0][2], _e1288[0][0]);
                                                                    }
                                                                    let _e1589 = phi_3107_;
                                                                    phi_3108_ = _e1589;
                                                                }
                                                                let _e1592 = phi_3108_;
                                                                if _e388 {
                                                                    phi_3125_ = vec3<f32>(_e1288[1][0], _e1288[1][1], _e1288[1][2]);
                                                                } else {
                                                                    if (_e368 == 1u) {
                                                                        phi_3124_ = vec3<f32>(_e1288[1][2], _e1288[1][0], _e1288[1][1]);
                                                                    } else {
                                                                        phi_3124_ = vec3<f32>(_e1288[1][1], _e1288[1][2], _e1288[1][0]);
                                                                    }
                                                                    let _e1597 = phi_3124_;
                                                                    phi_3125_ = _e1597;
                                                                }
                                                                let _e1600 = phi_3125_;
                                                                if _e388 {
                                                                    phi_3142_ = vec3<f32>(_e1288[2][0], _e1288[2][1], _e1288[2][2]);
                                                                } else {
                                                                    if (_e368 == 1u) {
                                                                        phi_3141_ = vec3<f32>(_e1288[2][2], _e1288[2][0], _e1288[2][1]);
                                                                    } else {
                                                                        phi_3141_ = vec3<f32>(_e1288[2][1], _e1288[2][2], _e1288[2][0]);
                                                                    }
                                                                    let _e1605 = phi_3141_;
                                                                    phi_3142_ = _e1605;
                                                                }
                                                                let _e1608 = phi_3142_;
                                                                let _e1611 = (_e1600.x - _e1592.x);
                                                                let _e1614 = (_e1600.y - _e1592.y);
                                                                let _e1617 = (_e1600.z - _e1592.z);
                                                                let _e1619 = (_e1608.x - _e1592.x);
                                                                let _e1621 = (_e1608.y - _e1592.y);
                                                                let _e1623 = (_e1608.z - _e1592.z);
                                                                if (_e235.member_1 == 1u) {
                                                                    phi_3178_ = (vec3<f32>(_e235.member[0], _e235.member[1], _e235.member[2]) - _e1592);
                                                                } else {
                                                                    phi_3178_ = vec3<f32>(_e235.member[0], _e235.member[1], _e235.member[2]);
                                                                }
                                                                let _e1638 = phi_3178_;
                                                                let _e1644 = bitcast<f32>((bitcast<u32>((_e1611 * _e1621)) ^ _e235.member_3[0]));
                                                                let _e1648 = bitcast<f32>((bitcast<u32>((_e1614 * _e1619)) ^ _e235.member_3[0]));
                                                                let _e1652 = bitcast<f32>((bitcast<u32>((_e1614 * _e1623)) ^ _e235.member_3[0]));
                                                                let _e1656 = bitcast<f32>((bitcast<u32>((_e1617 * _e1621)) ^ _e235.member_3[0]));
                                                                let _e1660 = bitcast<f32>((bitcast<u32>((_e1617 * _e1619)) ^ _e235.member_3[0]));
                                                                let _e1664 = bitcast<f32>((bitcast<u32>((_e1611 * _e1623)) ^ _e235.member_3[0]));
                                                                let _e1665 = (_e1652 - _e1656);
                                                                let _e1666 = (_e1660 - _e1664);
                                                                let _e1667 = (_e1644 - _e1648);
                                                                let _e1691 = (bitcast<f32>((bitcast<u32>(_e1652) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1656) & 2147483647u)));
                                                                let _e1698 = (bitcast<f32>((bitcast<u32>(_e1660) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1664) & 2147483647u)));
                                                                let _e1705 = (bitcast<f32>((bitcast<u32>(_e1644) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1648) & 2147483647u)));
                                                                if (_e235.member_2 == 0f) {
                                                                    phi_3360_ = 0f;
                                                                } else {
                                                                    let _e1735 = bitcast<f32>((bitcast<u32>(_e1665) & 2147483647u));
                                                                    let _e1738 = bitcast<f32>((bitcast<u32>(_e1666) & 2147483647u));
                                                                    let _e1741 = bitcast<f32>((bitcast<u32>(_e1667) & 2147483647u));
                                                                    let _e1743 = select(_e1741, _e1738, (_e1738 > _e1741));
                                                                    let _e1747 = select(_e1741, _e1738, (_e1738 < _e1741));
                                                                    let _e1751 = select(_e1738, _e1735, (_e1735 < _e1738));
                                                                    let _e1753 = select(_e1738, _e1735, (_e1735 > _e1738));
                                                                    let _e1755 = select(_e1741, _e1753, (_e1753 < _e1741));
                                                                    phi_3360_ = bitcast<f32>((bitcast<u32>((_e235.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1743, _e1735, (_e1735 > _e1743)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1755, _e1751, (_e1751 > _e1755)))) ^ _e235.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1747, _e1735, (_e1735 < _e1747)))) ^ _e235.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1691 + _e1698) + _e1705))) ^ _e235.member_3[0]))) * 1.0000005f)) ^ _e235.member_3[0])))) ^ _e235.member_3[0]));
                                                                }
                                                                let _e1782 = phi_3360_;
                                                                phi_3378_ = (_e1584 || !(((((bitcast<f32>((bitcast<u32>((_e1638.x * _e1665)) ^ _e235.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1638.y * _e1666)) ^ _e235.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1638.z * _e1667)) ^ _e235.member_3[0]))) * f32(-(_e1583))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1638.x) & 2147483647u)) * _e1691)) ^ _e235.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1638.y) & 2147483647u)) * _e1698)) ^ _e235.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1638.z) & 2147483647u)) * _e1705)) ^ _e235.member_3[0]))))) ^ _e235.member_3[0])) + _e1782) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1796 = phi_3378_;
                                                            phi_3379_ = _e1796;
                                                        }
                                                        let _e1798 = phi_3379_;
                                                        if _e1798 {
                                                            phi_3384_ = type_45(_e1088.member, true);
                                                        } else {
                                                            phi_3384_ = _e1088;
                                                        }
                                                        let _e1803 = phi_3384_;
                                                        phi_3385_ = _e1803;
                                                    } else {
                                                        phi_3385_ = _e1088;
                                                    }
                                                    let _e1805 = phi_3385_;
                                                    phi_5054_ = _e1287;
                                                    phi_2119_ = _e1805;
                                                } else {
                                                    phi_5054_ = _e1086;
                                                    phi_2119_ = type_45();
                                                }
                                                let _e1807 = phi_5054_;
                                                let _e1809 = phi_2119_;
                                                continue;
                                                continuing {
                                                    phi_4994_ = _e1807;
                                                    phi_2118_ = _e1809;
                                                    phi_2121_ = _e1103;
                                                    phi_5053_ = _e1807;
                                                    break if !(_e1109);
                                                }
                                            }
                                            let _e1812 = phi_5053_;
                                            phi_5129_ = _e1812;
                                            if _e1812 {
                                                break;
                                            }
                                            let _e1814 = local_7;
                                            phi_5133_ = _e1812;
                                            let _e2024 = local_9;
                                            phi_4724_ = _e2024;
                                            phi_4725_ = _e615;
                                            phi_4726_ = false;
                                            phi_4727_ = select(_e619, 0u, _e1814.member_1);
                                        } else {
                                            if (_e615.member_1 >= _e99) {
                                                phi_4324_ = type_63(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_60(type_34(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e615.member_1 < _e99) {
                                                } else {
                                                    phi_5129_ = true;
                                                    break;
                                                }
                                                let _e632 = ((1u + _e368) % 4u);
                                                if (_e632 < 4u) {
                                                } else {
                                                    phi_5129_ = true;
                                                    break;
                                                }
                                                let _e637 = global_5.member[_e615.member_1][_e632];
                                                let _e639 = ((1u + _e367) % 4u);
                                                if (_e639 < 4u) {
                                                } else {
                                                    phi_5129_ = true;
                                                    break;
                                                }
                                                let _e644 = global_5.member[_e615.member_1][_e639];
                                                let _e646 = ((1u + _e369) % 4u);
                                                if (_e646 < 4u) {
                                                } else {
                                                    phi_5129_ = true;
                                                    break;
                                                }
                                                let _e651 = global_5.member[_e615.member_1][_e646];
                                                let _e653 = ((_e368 + 1u) % 4u);
                                                if (_e653 < 4u) {
                                                } else {
                                                    phi_5129_ = true;
                                                    break;
                                                }
                                                let _e658 = global_5.member[_e615.member_1][_e653];
                                                let _e660 = (_e658 >> bitcast<u32>(11u));
                                                let _e662 = ((_e367 + 1u) % 4u);
                                                if (_e662 < 4u) {
                                                } else {
                                                    phi_5129_ = true;
                                                    break;
                                                }
                                                let _e667 = global_5.member[_e615.member_1][_e662];
                                                let _e669 = (_e667 >> bitcast<u32>(11u));
                                                let _e671 = ((_e369 + 1u) % 4u);
                                                if (_e671 < 4u) {
                                                } else {
                                                    phi_5129_ = true;
                                                    break;
                                                }
                                                let _e676 = global_5.member[_e615.member_1][_e671];
                                                let _e678 = (_e676 >> bitcast<u32>(11u));
                                                let _e701 = (bitcast<f32>((bitcast<u32>((_e615.member.member_1.x - _e615.member.member.x)) & 2139095040u)) * 0.001953125f);
                                                let _e702 = (bitcast<f32>((bitcast<u32>((_e615.member.member_1.y - _e615.member.member.y)) & 2139095040u)) * 0.001953125f);
                                                let _e703 = (bitcast<f32>((bitcast<u32>((_e615.member.member_1.z - _e615.member.member.z)) & 2139095040u)) * 0.001953125f);
                                                let _e705 = select(_e158, _e701, (_e701 > _e158));
                                                let _e707 = select(_e158, _e702, (_e702 > _e158));
                                                let _e709 = select(_e158, _e703, (_e703 > _e158));
                                                let _e734 = bitcast<u32>((f32(bitcast<i32>((_e637 & 1023u))) * _e705));
                                                let _e739 = (bitcast<i32>((_e637 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e742 = bitcast<f32>((_e734 & bitcast<u32>(_e739)));
                                                let _e743 = bitcast<u32>((f32(bitcast<i32>((_e644 & 1023u))) * _e707));
                                                let _e748 = (bitcast<i32>((_e644 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e751 = bitcast<f32>((_e743 & bitcast<u32>(_e748)));
                                                let _e752 = bitcast<u32>((f32(bitcast<i32>((_e651 & 1023u))) * _e709));
                                                let _e757 = (bitcast<i32>((_e651 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e760 = bitcast<f32>((_e752 & bitcast<u32>(_e757)));
                                                let _e764 = bitcast<f32>((_e734 & bitcast<u32>(~(_e739))));
                                                let _e768 = bitcast<f32>((_e743 & bitcast<u32>(~(_e748))));
                                                let _e772 = bitcast<f32>((_e752 & bitcast<u32>(~(_e757))));
                                                let _e773 = bitcast<u32>((f32(bitcast<i32>((_e660 & 1023u))) * _e705));
                                                let _e778 = (bitcast<i32>((_e660 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e781 = bitcast<f32>((_e773 & bitcast<u32>(_e778)));
                                                let _e782 = bitcast<u32>((f32(bitcast<i32>((_e669 & 1023u))) * _e707));
                                                let _e787 = (bitcast<i32>((_e669 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e790 = bitcast<f32>((_e782 & bitcast<u32>(_e787)));
                                                let _e791 = bitcast<u32>((f32(bitcast<i32>((_e678 & 1023u))) * _e709));
                                                let _e796 = (bitcast<i32>((_e678 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e799 = bitcast<f32>((_e791 & bitcast<u32>(_e796)));
                                                let _e803 = bitcast<f32>((_e773 & bitcast<u32>(~(_e778))));
                                                let _e807 = bitcast<f32>((_e782 & bitcast<u32>(~(_e787))));
                                                let _e811 = bitcast<f32>((_e791 & bitcast<u32>(~(_e796))));
                                                let _e812 = (_e615.member.member.x + _e742);
                                                let _e813 = (_e615.member.member.y + _e751);
                                                let _e814 = (_e615.member.member.z + _e760);
                                                let _e817 = (_e615.member.member_1.x - _e781);
                                                let _e818 = (_e615.member.member_1.y - _e790);
                                                let _e819 = (_e615.member.member_1.z - _e799);
                                                let _e838 = (_e817 - _e812);
                                                let _e839 = (_e818 - _e813);
                                                let _e840 = (_e819 - _e814);
                                                let _e842 = select(_e839, _e838, (_e838 > _e839));
                                                let _e844 = select(_e840, _e842, (_e842 > _e840));
                                                if (_e844 < (1024f * _e158)) {
                                                    phi_4025_ = 0u;
                                                } else {
                                                    phi_4025_ = select(2u, 1u, (_e844 < (2097152f * _e158)));
                                                }
                                                let _e851 = phi_4025_;
                                                switch bitcast<i32>(_e851) {
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
                                                let _e854 = phi_4031_;
                                                let _e860 = global_5.member[_e615.member_1][0u];
                                                let _e864 = global_5.member[_e615.member_1][1u];
                                                let _e868 = global_5.member[_e615.member_1][2u];
                                                let _e872 = global_5.member[_e615.member_1][3u];
                                                let _e884 = (((_e864 >> bitcast<u32>(22i)) | ((_e868 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e872 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e885 = (_e860 & 268435455u);
                                                let _e886 = (_e884 & 268435455u);
                                                let _e889 = ((_e860 >> bitcast<u32>(28u)) & 7u);
                                                let _e897 = ((_e860 >> bitcast<u32>(31i)) | (((_e884 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e898 = (_e889 != 0u);
                                                if (_e889 == 0u) {
                                                    phi_4286_ = _e885;
                                                } else {
                                                    if (_e889 == 7u) {
                                                        phi_4285_ = 2147483648u;
                                                    } else {
                                                        phi_4285_ = ((2147483648u | (_e889 << bitcast<u32>(28u))) | (_e886 & 268435455u));
                                                    }
                                                    let _e907 = phi_4285_;
                                                    phi_4286_ = _e907;
                                                }
                                                let _e909 = phi_4286_;
                                                if _e898 {
                                                    let _e910 = (_e889 != 7u);
                                                    if _e910 {
                                                        phi_4296_ = (_e886 + (_e889 * ((3u * _e854) + 1u)));
                                                    } else {
                                                        phi_4296_ = u32();
                                                    }
                                                    let _e914 = phi_4296_;
                                                    phi_4298_ = _e914;
                                                    phi_4299_ = select(true, false, _e910);
                                                } else {
                                                    phi_4298_ = u32();
                                                    phi_4299_ = true;
                                                }
                                                let _e917 = phi_4298_;
                                                let _e919 = phi_4299_;
                                                if (_e897 == 0u) {
                                                    phi_4320_ = (_e885 + select(0u, 1u, !(_e898)));
                                                } else {
                                                    if (_e897 == 7u) {
                                                        phi_4319_ = 2147483648u;
                                                    } else {
                                                        phi_4319_ = ((2147483648u | (_e897 << bitcast<u32>(28u))) | (select(_e917, _e886, _e919) & 268435455u));
                                                    }
                                                    let _e932 = phi_4319_;
                                                    phi_4320_ = _e932;
                                                }
                                                let _e934 = phi_4320_;
                                                phi_4324_ = type_63(array<vec4<f32>, 3>(vec4<f32>(_e812, (_e615.member.member.x + _e764), _e817, (_e615.member.member_1.x - _e803)), vec4<f32>(_e813, (_e615.member.member.y + _e768), _e818, (_e615.member.member_1.y - _e807)), vec4<f32>(_e814, (_e615.member.member.z + _e772), _e819, (_e615.member.member_1.z - _e811))), type_60(type_34((_e615.member.member + vec4<f32>(_e742, _e751, _e760, 0f)), (_e615.member.member_1 - vec4<f32>(_e781, _e790, _e799, 0f))), _e909), type_60(type_34((_e615.member.member + vec4<f32>(_e764, _e768, _e772, 0f)), (_e615.member.member_1 - vec4<f32>(_e803, _e807, _e811, 0f))), _e934));
                                            }
                                            let _e939 = phi_4324_;
                                            let _e951 = ((_e939.member[0].x - _e419) * _e424);
                                            let _e952 = ((_e939.member[0].y - _e419) * _e424);
                                            let _e953 = ((_e939.member[0].z - _e420) * _e424);
                                            let _e954 = ((_e939.member[0].w - _e420) * _e424);
                                            let _e964 = ((_e939.member[1].x - _e455) * _e460);
                                            let _e965 = ((_e939.member[1].y - _e455) * _e460);
                                            let _e966 = ((_e939.member[1].z - _e456) * _e460);
                                            let _e967 = ((_e939.member[1].w - _e456) * _e460);
                                            let _e977 = ((_e939.member[2].x - _e491) * _e496);
                                            let _e978 = ((_e939.member[2].y - _e491) * _e496);
                                            let _e979 = ((_e939.member[2].z - _e492) * _e496);
                                            let _e980 = ((_e939.member[2].w - _e492) * _e496);
                                            let _e982 = select(_e979, _e977, (_e977 < _e979));
                                            let _e984 = select(_e980, _e978, (_e978 < _e980));
                                            let _e986 = select(_e979, _e977, (_e977 > _e979));
                                            let _e988 = select(_e980, _e978, (_e978 > _e980));
                                            let _e990 = select(_e953, _e951, (_e951 < _e953));
                                            let _e992 = select(_e954, _e952, (_e952 < _e954));
                                            let _e994 = select(_e966, _e964, (_e964 < _e966));
                                            let _e996 = select(_e967, _e965, (_e965 < _e967));
                                            let _e998 = select(_e994, _e990, (_e990 > _e994));
                                            let _e1000 = select(_e996, _e992, (_e992 > _e996));
                                            let _e1002 = select(_e982, _e998, (_e998 > _e982));
                                            let _e1004 = select(_e984, _e1000, (_e1000 > _e984));
                                            let _e1006 = select(_e953, _e951, (_e951 > _e953));
                                            let _e1008 = select(_e954, _e952, (_e952 > _e954));
                                            let _e1010 = select(_e966, _e964, (_e964 > _e966));
                                            let _e1012 = select(_e967, _e965, (_e965 > _e967));
                                            let _e1014 = select(_e1010, _e1006, (_e1006 < _e1010));
                                            let _e1016 = select(_e1012, _e1008, (_e1008 < _e1012));
                                            let _e1021 = -(_e982);
                                            let _e1022 = -(_e984);
                                            let _e1029 = (select(_e986, _e1014, (_e1014 < _e986)) + (select(_e1021, _e986, (_e986 > _e1021)) * 0.0000019073523f));
                                            let _e1030 = (select(_e988, _e1016, (_e1016 < _e988)) + (select(_e1022, _e988, (_e988 > _e1022)) * 0.0000019073523f));
                                            let _e1032 = select(_e542, _e1002, (_e1002 > _e542));
                                            let _e1034 = select(_e542, _e1004, (_e1004 > _e542));
                                            let _e1039 = (_e1032 <= select(_e586.member, _e1029, (_e1029 < _e586.member)));
                                            let _e1040 = (_e1034 <= select(_e586.member, _e1030, (_e1030 < _e586.member)));
                                            let _e1041 = (_e1032 <= _e1034);
                                            if _e1039 {
                                                if _e1040 {
                                                    if _e1041 {
                                                        phi_4668_ = _e939.member_2;
                                                    } else {
                                                        phi_4668_ = _e939.member_1;
                                                    }
                                                    let _e1045 = phi_4668_;
                                                    let _e1046 = (_e619 % 128u);
                                                    let _e1047 = (_e1046 < 128u);
                                                    if _e1047 {
                                                    } else {
                                                        phi_5129_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1046] = type_60(type_34(_e1045.member.member, _e1045.member.member_1), _e1045.member_1);
                                                    if _e1047 {
                                                    } else {
                                                        phi_5129_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1046] = select(_e1034, _e1032, (_e1032 > _e1034));
                                                    if _e1041 {
                                                        phi_4701_ = _e939.member_1;
                                                    } else {
                                                        phi_4701_ = _e939.member_2;
                                                    }
                                                    let _e1062 = phi_4701_;
                                                    phi_4702_ = _e1062;
                                                    phi_4703_ = (_e619 + 1u);
                                                } else {
                                                    phi_4702_ = type_60();
                                                    phi_4703_ = u32();
                                                }
                                                let _e1064 = phi_4702_;
                                                let _e1066 = phi_4703_;
                                                phi_4705_ = _e1064;
                                                phi_4706_ = _e1066;
                                                phi_4707_ = select(true, false, _e1040);
                                            } else {
                                                phi_4705_ = type_60();
                                                phi_4706_ = u32();
                                                phi_4707_ = true;
                                            }
                                            let _e1069 = phi_4705_;
                                            let _e1071 = phi_4706_;
                                            let _e1073 = phi_4707_;
                                            if _e1073 {
                                                if _e1039 {
                                                    phi_4716_ = _e939.member_1;
                                                } else {
                                                    phi_4716_ = _e939.member_2;
                                                }
                                                let _e1077 = phi_4716_;
                                                phi_4721_ = _e1077;
                                                phi_4722_ = select(_e1040, true, _e1039);
                                            } else {
                                                phi_4721_ = _e1069;
                                                phi_4722_ = _e617;
                                            }
                                            let _e1080 = phi_4721_;
                                            let _e1082 = phi_4722_;
                                            phi_5133_ = _e584;
                                            phi_4724_ = _e586;
                                            phi_4725_ = _e1080;
                                            phi_4726_ = _e1082;
                                            phi_4727_ = select(_e1071, _e619, _e1073);
                                        }
                                        let _e1818 = phi_5133_;
                                        let _e1820 = phi_4724_;
                                        let _e1822 = phi_4725_;
                                        let _e1824 = phi_4726_;
                                        let _e1826 = phi_4727_;
                                        phi_5132_ = _e1818;
                                        phi_4728_ = _e1820;
                                        phi_4729_ = _e1822;
                                        phi_4730_ = (_e590 - 1u);
                                        phi_4731_ = _e1824;
                                        phi_4732_ = _e1826;
                                    } else {
                                        phi_5132_ = _e584;
                                        phi_4728_ = _e586;
                                        phi_4729_ = _e615;
                                        phi_4730_ = _e590;
                                        phi_4731_ = _e617;
                                        phi_4732_ = _e619;
                                    }
                                    let _e1828 = phi_5132_;
                                    let _e1830 = phi_4728_;
                                    let _e1832 = phi_4729_;
                                    let _e1834 = phi_4730_;
                                    let _e1836 = phi_4731_;
                                    let _e1838 = phi_4732_;
                                    phi_5131_ = _e1828;
                                    phi_4733_ = _e1830;
                                    phi_4734_ = _e1832;
                                    phi_4735_ = _e1834;
                                    phi_4736_ = _e1836;
                                    phi_4737_ = _e1838;
                                } else {
                                    phi_5131_ = _e584;
                                    phi_4733_ = type_45();
                                    phi_4734_ = type_60();
                                    phi_4735_ = u32();
                                    phi_4736_ = bool();
                                    phi_4737_ = u32();
                                }
                                let _e1840 = phi_5131_;
                                let _e1842 = phi_4733_;
                                let _e1844 = phi_4734_;
                                let _e1846 = phi_4735_;
                                let _e1848 = phi_4736_;
                                let _e1850 = phi_4737_;
                                phi_5130_ = _e1840;
                                phi_2041_ = _e1842;
                                phi_2044_ = _e1844;
                                phi_2046_ = _e1846;
                                phi_2048_ = _e1848;
                                phi_2050_ = _e1850;
                                phi_4738_ = _e598;
                            } else {
                                phi_5130_ = _e584;
                                phi_2041_ = type_45();
                                phi_2044_ = type_60();
                                phi_2046_ = u32();
                                phi_2048_ = bool();
                                phi_2050_ = u32();
                                phi_4738_ = false;
                            }
                            let _e1852 = phi_5130_;
                            let _e1854 = phi_2041_;
                            let _e1856 = phi_2044_;
                            let _e1858 = phi_2046_;
                            let _e1860 = phi_2048_;
                            let _e1862 = phi_2050_;
                            let _e1864 = phi_4738_;
                            continue;
                            continuing {
                                phi_4997_ = _e1852;
                                phi_2040_ = _e1854;
                                phi_2043_ = _e1856;
                                phi_2045_ = _e1858;
                                phi_2047_ = _e1860;
                                phi_2049_ = _e1862;
                                phi_5129_ = _e1852;
                                break if !(_e1864);
                            }
                        }
                        let _e1867 = phi_5129_;
                        if _e1867 {
                            break;
                        }
                        let _e1869 = local_8;
                        if _e1869.member_1 {
                        } else {
                            if _e236 {
                            } else {
                                break;
                            }
                            let _e1873 = global_2.member[_e146];
                            if _e161 {
                            } else {
                                break;
                            }
                            let _e1877 = global_9.member[_e146].member_1;
                            if _e236 {
                            } else {
                                break;
                            }
                            global_2.member[_e146] = type_27(_e1873.member, _e1873.member_1, _e1873.member_2, array<f32, 3>((_e1873.member_3[0] + (_e1877[0] * _e1873.member_1[0])), (_e1873.member_3[1] + (_e1877[1] * _e1873.member_1[1])), (_e1873.member_3[2] + (_e1877[2] * _e1873.member_1[2]))), _e1873.member_4);
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
fn trace_shadows_q10_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
