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

struct type_18 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_20 {
    member: array<type_18>,
}

struct type_28 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_30 {
    member: array<type_28>,
}

struct type_32 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_33 {
    member: type_32,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_35 {
    member: array<type_33>,
}

struct type_40 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_42 {
    member: array<type_40>,
}

struct type_46 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_49 {
    member: type_28,
    member_1: f32,
}

struct type_53 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_55 {
    member: array<vec4<u32>, 2>,
}

struct type_58 {
    member: array<i32>,
}

struct type_66 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_55;
@group(0) @binding(2) 
var<storage> global_3: type_42;
@group(0) @binding(3) 
var<storage> global_4: type_20;
@group(0) @binding(4) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage> global_6: type_58;
@group(0) @binding(6) 
var<storage> global_7: type_35;
@group(0) @binding(7) 
var<storage, read_write> global_8: type_30;
@group(0) @binding(8) 
var<storage, read_write> global_9: type_66;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_215_: u32;
    var phi_280_: type_46;
    var phi_386_: i32;
    var phi_387_: i32;
    var phi_397_: bool;
    var phi_407_: u32;
    var phi_408_: u32;
    var phi_410_: bool;
    var phi_415_: u32;
    var phi_459_: f32;
    var phi_465_: f32;
    var phi_476_: f32;
    var phi_482_: f32;
    var phi_505_: f32;
    var phi_516_: f32;
    var phi_525_: f32;
    var phi_531_: f32;
    var phi_542_: f32;
    var phi_548_: f32;
    var phi_571_: f32;
    var phi_582_: f32;
    var phi_591_: f32;
    var phi_597_: f32;
    var phi_608_: f32;
    var phi_614_: f32;
    var phi_637_: f32;
    var phi_648_: f32;
    var phi_748_: f32;
    var phi_749_: f32;
    var phi_2785_: bool;
    var phi_1023_: type_49;
    var phi_1026_: u32;
    var phi_1028_: u32;
    var phi_1030_: bool;
    var phi_1032_: u32;
    var phi_1043_: bool;
    var phi_1074_: u32;
    var phi_1075_: bool;
    var phi_1076_: u32;
    var phi_2220_: type_53;
    var phi_2564_: u32;
    var phi_2591_: u32;
    var phi_2592_: u32;
    var phi_2593_: u32;
    var phi_2595_: u32;
    var phi_2596_: u32;
    var phi_2597_: bool;
    var phi_2606_: u32;
    var phi_2611_: u32;
    var phi_2612_: bool;
    var phi_1091_: type_49;
    var phi_1094_: type_8;
    var phi_1095_: type_8;
    var phi_1117_: type_8;
    var phi_1138_: u32;
    var phi_1227_: array<array<f32, 3>, 3>;
    var phi_1698_: vec3<f32>;
    var phi_1699_: vec3<f32>;
    var phi_1730_: bool;
    var phi_1739_: vec3<f32>;
    var phi_1779_: type_28;
    var phi_1781_: type_28;
    var phi_1782_: bool;
    var phi_1786_: type_28;
    var phi_1787_: type_28;
    var phi_1788_: type_28;
    var phi_1789_: bool;
    var phi_1793_: type_28;
    var phi_1794_: bool;
    var phi_1798_: type_28;
    var phi_1799_: bool;
    var phi_1803_: type_28;
    var phi_1826_: u32;
    var phi_1840_: i32;
    var phi_1860_: vec3<f32>;
    var phi_1861_: vec3<f32>;
    var phi_1877_: vec3<f32>;
    var phi_1878_: vec3<f32>;
    var phi_1894_: vec3<f32>;
    var phi_1895_: vec3<f32>;
    var phi_1931_: vec3<f32>;
    var phi_2113_: f32;
    var phi_2131_: bool;
    var phi_2132_: bool;
    var phi_2151_: bool;
    var phi_2152_: bool;
    var phi_2158_: type_49;
    var phi_2159_: type_49;
    var phi_2160_: type_49;
    var phi_1092_: type_49;
    var phi_2779_: bool;
    var phi_2915_: bool;
    var phi_2614_: type_49;
    var phi_2615_: u32;
    var phi_2616_: bool;
    var phi_2617_: u32;
    var phi_2914_: bool;
    var phi_2618_: type_49;
    var phi_2619_: u32;
    var phi_2620_: u32;
    var phi_2621_: bool;
    var phi_2622_: u32;
    var phi_2913_: bool;
    var phi_2623_: type_49;
    var phi_2624_: u32;
    var phi_2625_: u32;
    var phi_2626_: bool;
    var phi_2627_: u32;
    var phi_2912_: bool;
    var phi_1024_: type_49;
    var phi_1027_: u32;
    var phi_1029_: u32;
    var phi_1031_: bool;
    var phi_1033_: u32;
    var phi_2628_: bool;
    var phi_2911_: bool;
    var local_2: type_49;
    var phi_2680_: type_28;
    var local_3: type_49;

    switch bitcast<i32>(0u) {
        default: {
            let _e72 = global;
            let _e74 = arrayLength((&global_3.member));
            let _e76 = arrayLength((&global_4.member));
            let _e88 = arrayLength((&global_9.member));
            let _e92 = (_e72.x + (_e72.y * 2097152u));
            let _e93 = (_e92 < arrayLength((&global_7.member)));
            if _e93 {
                if _e93 {
                } else {
                    break;
                }
                let _e97 = global_7.member[_e92].member_2;
                phi_215_ = _e97;
            } else {
                phi_215_ = 4294967295u;
            }
            let _e99 = phi_215_;
            let _e102 = global_1.member[0u];
            let _e106 = global_2.member[0u][0u];
            let _e110 = global_2.member[0u][1u];
            let _e114 = global_2.member[0u][2u];
            let _e118 = global_2.member[0u][3u];
            let _e122 = global_2.member[1u][0u];
            let _e126 = global_2.member[1u][1u];
            let _e130 = global_2.member[1u][2u];
            let _e134 = global_2.member[1u][3u];
            let _e135 = bitcast<f32>(_e106);
            let _e136 = bitcast<f32>(_e110);
            let _e137 = bitcast<f32>(_e114);
            let _e139 = bitcast<f32>(_e122);
            let _e140 = array<u32, 3>(_e126, _e130, _e134);
            let _e142 = bitcast<i32>(_e102);
            let _e143 = (_e142 / 2i);
            let _e148 = bitcast<f32>((bitcast<u32>((_e143 + 127i)) << bitcast<u32>(23i)));
            let _e154 = bitcast<f32>((bitcast<u32>(((_e142 - _e143) + 127i)) << bitcast<u32>(23i)));
            if (_e118 == 0u) {
                phi_280_ = type_46(array<f32, 3>(_e135, _e136, _e137), _e118, _e139, _e140);
            } else {
                phi_280_ = type_46(array<f32, 3>(((_e135 * _e148) * _e154), ((_e136 * _e148) * _e154), ((_e137 * _e148) * _e154)), _e118, ((_e139 * _e148) * _e154), _e140);
            }
            let _e167 = phi_280_;
            if _e93 {
                let _e168 = (_e92 < arrayLength((&global_8.member)));
                if _e168 {
                    if _e93 {
                    } else {
                        break;
                    }
                    let _e178 = global_7.member[_e92].member.member_2[0u];
                    let _e180 = (bitcast<u32>(_e178) & 2147483647u);
                    let _e186 = global_7.member[_e92].member.member_2[1u];
                    let _e188 = (bitcast<u32>(_e186) & 2147483647u);
                    let _e194 = global_7.member[_e92].member.member_2[2u];
                    let _e196 = (bitcast<u32>(_e194) & 2147483647u);
                    let _e202 = global_7.member[_e92].member.member[0u];
                    let _e204 = (bitcast<u32>(_e202) & 2147483647u);
                    let _e210 = global_7.member[_e92].member.member[1u];
                    let _e212 = (bitcast<u32>(_e210) & 2147483647u);
                    let _e218 = global_7.member[_e92].member.member[2u];
                    let _e220 = (bitcast<u32>(_e218) & 2147483647u);
                    let _e222 = select(_e188, _e180, (_e188 < _e180));
                    let _e224 = select(_e196, _e222, (_e196 < _e222));
                    let _e226 = select(_e204, _e224, (_e204 < _e224));
                    let _e228 = select(_e212, _e226, (_e212 < _e226));
                    let _e230 = select(_e220, _e228, (_e220 < _e228));
                    let _e235 = global_7.member[_e92].member.member_1;
                    let _e237 = (bitcast<u32>(_e235) & 2147483647u);
                    let _e245 = global_7.member[_e92].member.member_3;
                    let _e251 = (((select(_e237, _e230, (_e237 < _e230)) < 2139095040u) && ((bitcast<u32>(_e245) & 2147483647u) <= 2139095040u)) && (_e224 > 0u));
                    if _e251 {
                        let _e254 = (bitcast<u32>(bitcast<f32>(_e224)) & 2147483647u);
                        if (_e254 >= 8388608u) {
                            phi_386_ = (bitcast<i32>((_e254 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_386_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e254)), 32u, (_e254 == 0u))));
                        }
                        let _e268 = phi_386_;
                        phi_387_ = _e268;
                    } else {
                        phi_387_ = 0i;
                    }
                    let _e270 = phi_387_;
                    let _e271 = (_e180 == _e224);
                    if _e271 {
                        phi_397_ = true;
                    } else {
                        phi_397_ = (_e188 == _e224);
                    }
                    let _e274 = phi_397_;
                    let _e275 = select(1u, 0u, _e271);
                    if _e274 {
                        let _e276 = (_e275 + 1u);
                        phi_407_ = _e276;
                        phi_408_ = _e276;
                        phi_410_ = select(true, false, (_e276 == 2u));
                    } else {
                        phi_407_ = u32();
                        phi_408_ = 0u;
                        phi_410_ = true;
                    }
                    let _e280 = phi_407_;
                    let _e282 = phi_408_;
                    let _e284 = phi_410_;
                    if _e284 {
                        phi_415_ = (_e282 + 1u);
                    } else {
                        phi_415_ = 0u;
                    }
                    let _e288 = phi_415_;
                    let _e289 = select(_e280, _e282, _e284);
                    let _e290 = select(_e275, select(2u, _e275, _e274), _e284);
                    let _e291 = -(_e270);
                    let _e292 = (_e291 / 2i);
                    let _e297 = bitcast<f32>((bitcast<u32>((_e292 + 127i)) << bitcast<u32>(23i)));
                    let _e303 = bitcast<f32>((bitcast<u32>(((_e291 - _e292) + 127i)) << bitcast<u32>(23i)));
                    let _e308 = global_7.member[_e92].member.member;
                    let _e309 = (_e289 == 0u);
                    if _e309 {
                        phi_459_ = _e308[0];
                    } else {
                        phi_459_ = _e308[1];
                    }
                    let _e313 = phi_459_;
                    let _e314 = (_e289 == 2u);
                    if _e314 {
                        phi_465_ = _e308[2];
                    } else {
                        phi_465_ = _e313;
                    }
                    let _e317 = phi_465_;
                    let _e318 = global_7.member[_e92].member.member_2;
                    if _e309 {
                        phi_476_ = _e318[0];
                    } else {
                        phi_476_ = _e318[1];
                    }
                    let _e322 = phi_476_;
                    if _e314 {
                        phi_482_ = _e318[2];
                    } else {
                        phi_482_ = _e322;
                    }
                    let _e325 = phi_482_;
                    let _e327 = ((_e325 * _e297) * _e303);
                    let _e331 = (bitcast<f32>((bitcast<u32>(_e327) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e331 {
                        let _e335 = (bitcast<f32>((bitcast<u32>(_e317) & 2147483647u)) * 0.00000011920929f);
                        phi_505_ = select(0.00000000000011368684f, _e335, (_e335 > 0.00000000000011368684f));
                    } else {
                        phi_505_ = 0f;
                    }
                    let _e339 = phi_505_;
                    let _e340 = (_e317 + _e339);
                    let _e341 = (_e317 - _e339);
                    let _e342 = select(_e327, 0f, _e331);
                    if _e331 {
                        phi_516_ = 38685626000000000000000000f;
                    } else {
                        phi_516_ = (1f / _e327);
                    }
                    let _e345 = phi_516_;
                    let _e346 = (_e288 == 0u);
                    if _e346 {
                        phi_525_ = _e308[0];
                    } else {
                        phi_525_ = _e308[1];
                    }
                    let _e350 = phi_525_;
                    let _e351 = (_e288 == 2u);
                    if _e351 {
                        phi_531_ = _e308[2];
                    } else {
                        phi_531_ = _e350;
                    }
                    let _e354 = phi_531_;
                    if _e346 {
                        phi_542_ = _e318[0];
                    } else {
                        phi_542_ = _e318[1];
                    }
                    let _e358 = phi_542_;
                    if _e351 {
                        phi_548_ = _e318[2];
                    } else {
                        phi_548_ = _e358;
                    }
                    let _e361 = phi_548_;
                    let _e363 = ((_e361 * _e297) * _e303);
                    let _e367 = (bitcast<f32>((bitcast<u32>(_e363) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e367 {
                        let _e371 = (bitcast<f32>((bitcast<u32>(_e354) & 2147483647u)) * 0.00000011920929f);
                        phi_571_ = select(0.00000000000011368684f, _e371, (_e371 > 0.00000000000011368684f));
                    } else {
                        phi_571_ = 0f;
                    }
                    let _e375 = phi_571_;
                    let _e376 = (_e354 + _e375);
                    let _e377 = (_e354 - _e375);
                    let _e378 = select(_e363, 0f, _e367);
                    if _e367 {
                        phi_582_ = 38685626000000000000000000f;
                    } else {
                        phi_582_ = (1f / _e363);
                    }
                    let _e381 = phi_582_;
                    let _e382 = (_e290 == 0u);
                    if _e382 {
                        phi_591_ = _e308[0];
                    } else {
                        phi_591_ = _e308[1];
                    }
                    let _e386 = phi_591_;
                    let _e387 = (_e290 == 2u);
                    if _e387 {
                        phi_597_ = _e308[2];
                    } else {
                        phi_597_ = _e386;
                    }
                    let _e390 = phi_597_;
                    if _e382 {
                        phi_608_ = _e318[0];
                    } else {
                        phi_608_ = _e318[1];
                    }
                    let _e394 = phi_608_;
                    if _e387 {
                        phi_614_ = _e318[2];
                    } else {
                        phi_614_ = _e394;
                    }
                    let _e397 = phi_614_;
                    let _e399 = ((_e397 * _e297) * _e303);
                    let _e403 = (bitcast<f32>((bitcast<u32>(_e399) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e403 {
                        let _e407 = (bitcast<f32>((bitcast<u32>(_e390) & 2147483647u)) * 0.00000011920929f);
                        phi_637_ = select(0.00000000000011368684f, _e407, (_e407 > 0.00000000000011368684f));
                    } else {
                        phi_637_ = 0f;
                    }
                    let _e411 = phi_637_;
                    let _e412 = (_e390 + _e411);
                    let _e413 = (_e390 - _e411);
                    let _e414 = select(_e399, 0f, _e403);
                    if _e403 {
                        phi_648_ = 38685626000000000000000000f;
                    } else {
                        phi_648_ = (1f / _e399);
                    }
                    let _e417 = phi_648_;
                    let _e420 = bitcast<f32>((bitcast<u32>(_e317) & 2147483647u));
                    let _e423 = bitcast<f32>((bitcast<u32>(_e354) & 2147483647u));
                    let _e425 = select(_e423, _e420, (_e420 > _e423));
                    let _e428 = bitcast<f32>((bitcast<u32>(_e390) & 2147483647u));
                    if (_e251 && (select(_e428, _e425, (_e425 > _e428)) <= 1099511600000f)) {
                        let _e433 = (_e270 / 3i);
                        let _e440 = bitcast<f32>((bitcast<u32>((_e433 + 127i)) << bitcast<u32>(23i)));
                        let _e447 = bitcast<f32>((bitcast<u32>(((_e270 - (2i * _e433)) + 127i)) << bitcast<u32>(23i)));
                        let _e448 = (((_e235 * _e440) * _e440) * _e447);
                        let _e450 = select(340282350000000000000000000000000000000f, _e448, (_e448 < 340282350000000000000000000000000000000f));
                        let _e455 = (((_e245 * _e440) * _e440) * _e447);
                        let _e457 = select(340282350000000000000000000000000000000f, _e455, (_e455 < 340282350000000000000000000000000000000f));
                        phi_748_ = select(-340282350000000000000000000000000000000f, _e457, (_e457 > -340282350000000000000000000000000000000f));
                        phi_749_ = select(-340282350000000000000000000000000000000f, _e450, (_e450 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_748_ = 0f;
                        phi_749_ = 1f;
                    }
                    let _e461 = phi_748_;
                    let _e463 = phi_749_;
                    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_2785_ = false;
                    phi_1023_ = type_49(type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e461);
                    phi_1026_ = select(0u, 2147483648u, (_e74 == 0u));
                    phi_1028_ = ((3u * _e74) + 1u);
                    phi_1030_ = (_e463 <= _e461);
                    phi_1032_ = 0u;
                    loop {
                        let _e471 = phi_2785_;
                        let _e473 = phi_1023_;
                        let _e475 = phi_1026_;
                        let _e477 = phi_1028_;
                        let _e479 = phi_1030_;
                        let _e481 = phi_1032_;
                        local_2 = _e473;
                        if _e479 {
                            phi_1043_ = true;
                        } else {
                            phi_1043_ = (_e481 > 0u);
                        }
                        let _e484 = phi_1043_;
                        if _e484 {
                            let _e485 = (_e477 > 0u);
                            if _e485 {
                                if _e479 {
                                    phi_1074_ = _e475;
                                    phi_1075_ = _e479;
                                    phi_1076_ = _e481;
                                } else {
                                    let _e486 = (_e481 - 1u);
                                    let _e487 = (_e486 % 128u);
                                    let _e488 = (_e487 < 128u);
                                    if _e488 {
                                    } else {
                                        phi_2911_ = true;
                                        break;
                                    }
                                    let _e490 = local_1[_e487];
                                    if _e488 {
                                    } else {
                                        phi_2911_ = true;
                                        break;
                                    }
                                    let _e492 = local[_e487];
                                    phi_1074_ = _e490;
                                    phi_1075_ = (_e492 <= _e473.member_1);
                                    phi_1076_ = _e486;
                                }
                                let _e496 = phi_1074_;
                                let _e498 = phi_1075_;
                                let _e500 = phi_1076_;
                                if _e498 {
                                    if ((_e496 & 2147483648u) != 0u) {
                                        phi_1091_ = _e473;
                                        phi_1094_ = type_8(0u, ((_e496 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e698 = phi_1091_;
                                            let _e700 = phi_1094_;
                                            local_3 = _e698;
                                            if (_e700.member < _e700.member_1) {
                                                phi_1095_ = type_8((_e700.member + 1u), _e700.member_1);
                                                phi_1117_ = type_8(1u, _e700.member);
                                            } else {
                                                phi_1095_ = _e700;
                                                phi_1117_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e713 = phi_1095_;
                                            let _e715 = phi_1117_;
                                            let _e719 = (bitcast<i32>(_e715.member) != 0i);
                                            if _e719 {
                                                let _e720 = ((_e496 & 268435455u) + _e715.member_1);
                                                let _e721 = (_e720 < _e76);
                                                if _e721 {
                                                    if _e721 {
                                                    } else {
                                                        phi_2779_ = true;
                                                        break;
                                                    }
                                                    let _e725 = global_4.member[_e720].member_1;
                                                    phi_1138_ = _e725;
                                                } else {
                                                    phi_1138_ = 4294967295u;
                                                }
                                                let _e727 = phi_1138_;
                                                if (_e720 >= _e76) {
                                                    phi_1227_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e721 {
                                                    } else {
                                                        phi_2779_ = true;
                                                        break;
                                                    }
                                                    let _e729 = (_e289 % 3u);
                                                    let _e730 = (_e288 % 3u);
                                                    let _e731 = (_e290 % 3u);
                                                    if (_e729 < 9u) {
                                                    } else {
                                                        phi_2779_ = true;
                                                        break;
                                                    }
                                                    let _e737 = global_4.member[_e720].member[_e729];
                                                    if (_e730 < 9u) {
                                                    } else {
                                                        phi_2779_ = true;
                                                        break;
                                                    }
                                                    let _e743 = global_4.member[_e720].member[_e730];
                                                    if (_e731 < 9u) {
                                                    } else {
                                                        phi_2779_ = true;
                                                        break;
                                                    }
                                                    let _e749 = global_4.member[_e720].member[_e731];
                                                    let _e751 = (3u + _e729);
                                                    if (_e751 < 9u) {
                                                    } else {
                                                        phi_2779_ = true;
                                                        break;
                                                    }
                                                    let _e757 = global_4.member[_e720].member[_e751];
                                                    let _e758 = (3u + _e730);
                                                    if (_e758 < 9u) {
                                                    } else {
                                                        phi_2779_ = true;
                                                        break;
                                                    }
                                                    let _e764 = global_4.member[_e720].member[_e758];
                                                    let _e765 = (3u + _e731);
                                                    if (_e765 < 9u) {
                                                    } else {
                                                        phi_2779_ = true;
                                                        break;
                                                    }
                                                    let _e771 = global_4.member[_e720].member[_e765];
                                                    let _e773 = (6u + _e729);
                                                    if (_e773 < 9u) {
                                                    } else {
                                                        phi_2779_ = true;
                                                        break;
                                                    }
                                                    let _e779 = global_4.member[_e720].member[_e773];
                                                    let _e780 = (6u + _e730);
                                                    if (_e780 < 9u) {
                                                    } else {
                                                        phi_2779_ = true;
                                                        break;
                                                    }
                                                    let _e786 = global_4.member[_e720].member[_e780];
                                                    let _e787 = (6u + _e731);
                                                    if (_e787 < 9u) {
                                                    } else {
                                                        phi_2779_ = true;
                                                        break;
                                                    }
                                                    let _e793 = global_4.member[_e720].member[_e787];
                                                    phi_1227_ = array<array<f32, 3>, 3>(array<f32, 3>(_e737, _e743, _e749), array<f32, 3>(_e757, _e764, _e771), array<f32, 3>(_e779, _e786, _e793));
                                                }
                                                let _e797 = phi_1227_;
                                                let _e805 = (_e797[0][2] - _e390);
                                                let _e808 = (((_e797[0][0] - _e317) * _e414) - (_e805 * _e342));
                                                let _e811 = (((_e797[0][1] - _e354) * _e414) - (_e805 * _e378));
                                                let _e818 = (_e797[1][2] - _e390);
                                                let _e821 = (((_e797[1][0] - _e317) * _e414) - (_e818 * _e342));
                                                let _e824 = (((_e797[1][1] - _e354) * _e414) - (_e818 * _e378));
                                                let _e831 = (_e797[2][2] - _e390);
                                                let _e834 = (((_e797[2][0] - _e317) * _e414) - (_e831 * _e342));
                                                let _e837 = (((_e797[2][1] - _e354) * _e414) - (_e831 * _e378));
                                                let _e838 = (_e834 * _e824);
                                                let _e839 = (_e837 * _e821);
                                                let _e840 = (_e808 * _e837);
                                                let _e841 = (_e811 * _e834);
                                                let _e842 = (_e821 * _e811);
                                                let _e843 = (_e824 * _e808);
                                                let _e848 = (((_e838 >= _e839) && (_e840 >= _e841)) && (_e842 >= _e843));
                                                if (_e848 || (((_e838 <= _e839) && (_e840 <= _e841)) && (_e842 <= _e843))) {
                                                    let _e855 = select(-1f, 1f, _e848);
                                                    let _e857 = ((_e838 - _e839) * _e855);
                                                    let _e859 = select(0f, _e857, (_e857 > 0f));
                                                    let _e861 = ((_e840 - _e841) * _e855);
                                                    let _e863 = select(0f, _e861, (_e861 > 0f));
                                                    let _e865 = ((_e842 - _e843) * _e855);
                                                    let _e867 = select(0f, _e865, (_e865 > 0f));
                                                    let _e869 = ((_e859 + _e863) + _e867);
                                                    if (_e869 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1793_ = type_28();
                                                        phi_1794_ = true;
                                                    } else {
                                                        let _e872 = select(_e797[1][0], _e797[0][0], (_e797[0][0] < _e797[1][0]));
                                                        let _e876 = select(_e797[1][0], _e797[0][0], (_e797[0][0] > _e797[1][0]));
                                                        let _e880 = select(_e797[1][1], _e797[0][1], (_e797[0][1] < _e797[1][1]));
                                                        let _e884 = select(_e797[1][1], _e797[0][1], (_e797[0][1] > _e797[1][1]));
                                                        let _e888 = select(_e797[1][2], _e797[0][2], (_e797[0][2] < _e797[1][2]));
                                                        let _e892 = select(_e797[1][2], _e797[0][2], (_e797[0][2] > _e797[1][2]));
                                                        let _e897 = ((select(_e797[2][0], _e872, (_e872 < _e797[2][0])) - _e340) * _e345);
                                                        let _e898 = ((select(_e797[2][0], _e876, (_e876 > _e797[2][0])) - _e341) * _e345);
                                                        let _e901 = ((select(_e797[2][1], _e880, (_e880 < _e797[2][1])) - _e376) * _e381);
                                                        let _e902 = ((select(_e797[2][1], _e884, (_e884 > _e797[2][1])) - _e377) * _e381);
                                                        let _e905 = ((select(_e797[2][2], _e888, (_e888 < _e797[2][2])) - _e412) * _e417);
                                                        let _e906 = ((select(_e797[2][2], _e892, (_e892 > _e797[2][2])) - _e413) * _e417);
                                                        let _e908 = select(_e906, _e905, (_e905 < _e906));
                                                        let _e910 = select(_e906, _e905, (_e905 > _e906));
                                                        let _e912 = select(_e898, _e897, (_e897 < _e898));
                                                        let _e914 = select(_e902, _e901, (_e901 < _e902));
                                                        let _e916 = select(_e914, _e912, (_e912 > _e914));
                                                        let _e918 = select(_e908, _e916, (_e916 > _e908));
                                                        let _e920 = select(_e898, _e897, (_e897 > _e898));
                                                        let _e922 = select(_e902, _e901, (_e901 > _e902));
                                                        let _e924 = select(_e922, _e920, (_e920 < _e922));
                                                        let _e926 = select(_e910, _e924, (_e924 < _e910));
                                                        let _e927 = -(_e908);
                                                        let _e933 = select(_e463, _e918, (_e918 > _e463));
                                                        if (_e933 > (_e926 + (select(_e927, _e910, (_e910 > _e927)) * 0.0000019073523f))) {
                                                            phi_1788_ = type_28();
                                                            phi_1789_ = true;
                                                        } else {
                                                            let _e935 = (_e933 > _e698.member_1);
                                                            if _e935 {
                                                                phi_1787_ = type_28();
                                                            } else {
                                                                let _e939 = (_e797[1][0] - _e797[0][0]);
                                                                let _e940 = (_e797[1][1] - _e797[0][1]);
                                                                let _e941 = (_e797[1][2] - _e797[0][2]);
                                                                let _e942 = vec3<f32>(_e939, _e940, _e941);
                                                                let _e943 = (_e797[2][0] - _e797[1][0]);
                                                                let _e944 = (_e797[2][1] - _e797[1][1]);
                                                                let _e945 = (_e797[2][2] - _e797[1][2]);
                                                                let _e946 = vec3<f32>(_e943, _e944, _e945);
                                                                let _e947 = (_e797[0][0] - _e797[2][0]);
                                                                let _e948 = (_e797[0][1] - _e797[2][1]);
                                                                let _e949 = (_e797[0][2] - _e797[2][2]);
                                                                let _e950 = vec3<f32>(_e947, _e948, _e949);
                                                                let _e953 = bitcast<f32>((bitcast<u32>(_e939) & 2147483647u));
                                                                let _e956 = bitcast<f32>((bitcast<u32>(_e940) & 2147483647u));
                                                                let _e958 = select(_e956, _e953, (_e953 > _e956));
                                                                let _e961 = bitcast<f32>((bitcast<u32>(_e941) & 2147483647u));
                                                                let _e963 = select(_e961, _e958, (_e958 > _e961));
                                                                let _e966 = bitcast<f32>((bitcast<u32>(_e943) & 2147483647u));
                                                                let _e969 = bitcast<f32>((bitcast<u32>(_e944) & 2147483647u));
                                                                let _e971 = select(_e969, _e966, (_e966 > _e969));
                                                                let _e974 = bitcast<f32>((bitcast<u32>(_e945) & 2147483647u));
                                                                let _e976 = select(_e974, _e971, (_e971 > _e974));
                                                                let _e979 = bitcast<f32>((bitcast<u32>(_e947) & 2147483647u));
                                                                let _e982 = bitcast<f32>((bitcast<u32>(_e948) & 2147483647u));
                                                                let _e984 = select(_e982, _e979, (_e979 > _e982));
                                                                let _e987 = bitcast<f32>((bitcast<u32>(_e949) & 2147483647u));
                                                                let _e989 = select(_e987, _e984, (_e984 > _e987));
                                                                let _e991 = select(_e976, _e963, (_e963 > _e976));
                                                                let _e993 = select(_e989, _e991, (_e991 > _e989));
                                                                if (_e963 == _e993) {
                                                                    phi_1698_ = _e946;
                                                                    phi_1699_ = _e950;
                                                                } else {
                                                                    let _e996 = vec3((_e976 == _e993));
                                                                    phi_1698_ = select(_e942, _e950, _e996);
                                                                    phi_1699_ = select(_e946, _e942, _e996);
                                                                }
                                                                let _e1000 = phi_1698_;
                                                                let _e1002 = phi_1699_;
                                                                let _e1009 = ((_e1000.y * _e1002.z) - (_e1002.y * _e1000.z));
                                                                let _e1014 = ((_e1000.z * _e1002.x) - (_e1002.z * _e1000.x));
                                                                let _e1017 = ((_e1000.x * _e1002.y) - (_e1002.x * _e1000.y));
                                                                if (_e859 >= _e863) {
                                                                    phi_1730_ = select(true, false, (_e859 >= _e867));
                                                                } else {
                                                                    phi_1730_ = true;
                                                                }
                                                                let _e1022 = phi_1730_;
                                                                if _e1022 {
                                                                    phi_1739_ = select(vec3<f32>(_e797[2][0], _e797[2][1], _e797[2][2]), vec3<f32>(_e797[1][0], _e797[1][1], _e797[1][2]), vec3((_e863 >= _e867)));
                                                                } else {
                                                                    phi_1739_ = vec3<f32>(_e797[0][0], _e797[0][1], _e797[0][2]);
                                                                }
                                                                let _e1027 = phi_1739_;
                                                                let _e1044 = ((((_e1009 * (_e1027.x - _e317)) + (_e1014 * (_e1027.y - _e354))) + (_e1017 * (_e1027.z - _e390))) / (((_e1009 * _e342) + (_e1014 * _e378)) + (_e1017 * _e414)));
                                                                let _e1046 = select(_e926, _e1044, (_e1044 < _e926));
                                                                let _e1048 = select(_e918, _e1046, (_e1046 > _e918));
                                                                if (_e1048 >= _e463) {
                                                                    let _e1050 = (_e1048 <= _e698.member_1);
                                                                    if _e1050 {
                                                                        let _e1051 = (1f / _e869);
                                                                        phi_1779_ = type_28(_e1048, (_e863 * _e1051), (_e867 * _e1051), _e727);
                                                                    } else {
                                                                        phi_1779_ = type_28();
                                                                    }
                                                                    let _e1056 = phi_1779_;
                                                                    phi_1781_ = _e1056;
                                                                    phi_1782_ = select(true, false, _e1050);
                                                                } else {
                                                                    phi_1781_ = type_28();
                                                                    phi_1782_ = true;
                                                                }
                                                                let _e1059 = phi_1781_;
                                                                let _e1061 = phi_1782_;
                                                                if _e1061 {
                                                                    phi_1786_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1786_ = _e1059;
                                                                }
                                                                let _e1063 = phi_1786_;
                                                                phi_1787_ = _e1063;
                                                            }
                                                            let _e1065 = phi_1787_;
                                                            phi_1788_ = _e1065;
                                                            phi_1789_ = _e935;
                                                        }
                                                        let _e1067 = phi_1788_;
                                                        let _e1069 = phi_1789_;
                                                        phi_1793_ = _e1067;
                                                        phi_1794_ = _e1069;
                                                    }
                                                    let _e1071 = phi_1793_;
                                                    let _e1073 = phi_1794_;
                                                    phi_1798_ = _e1071;
                                                    phi_1799_ = _e1073;
                                                } else {
                                                    phi_1798_ = type_28();
                                                    phi_1799_ = true;
                                                }
                                                let _e1075 = phi_1798_;
                                                let _e1077 = phi_1799_;
                                                if _e1077 {
                                                    phi_1803_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1803_ = _e1075;
                                                }
                                                let _e1079 = phi_1803_;
                                                if (_e1079.member_3 != 4294967295u) {
                                                    if (_e727 == _e99) {
                                                        phi_2132_ = false;
                                                    } else {
                                                        let _e1083 = (_e727 < arrayLength((&global_5.member)));
                                                        if _e1083 {
                                                            if _e1083 {
                                                            } else {
                                                                phi_2779_ = true;
                                                                break;
                                                            }
                                                            let _e1085 = global_5.member[_e727];
                                                            phi_1826_ = _e1085;
                                                        } else {
                                                            phi_1826_ = 4294967295u;
                                                        }
                                                        let _e1087 = phi_1826_;
                                                        let _e1088 = (_e1087 < arrayLength((&global_6.member)));
                                                        if _e1088 {
                                                            if _e1088 {
                                                            } else {
                                                                phi_2779_ = true;
                                                                break;
                                                            }
                                                            let _e1090 = global_6.member[_e1087];
                                                            phi_1840_ = _e1090;
                                                        } else {
                                                            phi_1840_ = 0i;
                                                        }
                                                        let _e1092 = phi_1840_;
                                                        let _e1093 = (_e1092 == 0i);
                                                        if _e1093 {
                                                            phi_2131_ = true;
                                                        } else {
                                                            if _e309 {
                                                                phi_1861_ = vec3<f32>(_e797[0][0], _e797[0][1], _e797[0][2]);
                                                            } else {
                                                                if (_e289 == 1u) {
                                                                    phi_1860_ = vec3<f32>(_e797[0][2], _e797[0][0], _e797[0][1]);
                                                                } else {
                                                                    phi_1860_ = vec3<f32>(_e797[0][1], _e797[0][2], _e797[0][0]);
                                                                }
                                                                let _e1098 = phi_1860_;
                                                                phi_1861_ = _e1098;
                                                            }
                                                            let _e1101 = phi_1861_;
                                                            if _e309 {
                                                                phi_1878_ = vec3<f32>(_e797[1][0], _e797[1][1], _e797[1][2]);
                                                            } else {
                                                                if (_e289 == 1u) {
                                                                    phi_1877_ = vec3<f32>(_e797[1][2], _e797[1][0], _e797[1][1]);
                                                                } else {
                                                                    phi_1877_ = vec3<f32>(_e797[1][1], _e797[1][2], _e797[1][0]);
                                                                }
                                                                let _e1106 = phi_1877_;
                                                                phi_1878_ = _e1106;
                                                            }
                                                            let _e1109 = phi_1878_;
                                                            if _e309 {
                                                                phi_1895_ = vec3<f32>(_e797[2][0], _e797[2][1], _e797[2][2]);
                                                            } else {
                                                                if (_e289 == 1u) {
                                                                    phi_1894_ = vec3<f32>(_e797[2][2], _e797[2][0], _e797[2][1]);
                                                                } else {
                                                                    phi_1894_ = vec3<f32>(_e797[2][1], _e797[2][2], _e797[2][0]);
                                                                }
                                                                let _e1114 = phi_1894_;
                                                                phi_1895_ = _e1114;
                                                            }
                                                            let _e1117 = phi_1895_;
                                                            let _e1120 = (_e1109.x - _e1101.x);
                                                            let _e1123 = (_e1109.y - _e1101.y);
                                                            let _e1126 = (_e1109.z - _e1101.z);
                                                            let _e1128 = (_e1117.x - _e1101.x);
                                                            let _e1130 = (_e1117.y - _e1101.y);
                                                            let _e1132 = (_e1117.z - _e1101.z);
                                                            if (_e167.member_1 == 1u) {
                                                                phi_1931_ = (vec3<f32>(_e167.member[0], _e167.member[1], _e167.member[2]) - _e1101);
                                                            } else {
                                                                phi_1931_ = vec3<f32>(_e167.member[0], _e167.member[1], _e167.member[2]);
                                                            }
                                                            let _e1147 = phi_1931_;
                                                            let _e1153 = bitcast<f32>((bitcast<u32>((_e1120 * _e1130)) ^ _e167.member_3[0]));
                                                            let _e1157 = bitcast<f32>((bitcast<u32>((_e1123 * _e1128)) ^ _e167.member_3[0]));
                                                            let _e1161 = bitcast<f32>((bitcast<u32>((_e1123 * _e1132)) ^ _e167.member_3[0]));
                                                            let _e1165 = bitcast<f32>((bitcast<u32>((_e1126 * _e1130)) ^ _e167.member_3[0]));
                                                            let _e1169 = bitcast<f32>((bitcast<u32>((_e1126 * _e1128)) ^ _e167.member_3[0]));
                                                            let _e1173 = bitcast<f32>((bitcast<u32>((_e1120 * _e1132)) ^ _e167.member_3[0]));
                                                            let _e1174 = (_e1161 - _e1165);
                                                            let _e1175 = (_e1169 - _e1173);
                                                            let _e1176 = (_e1153 - _e1157);
                                                            let _e1200 = (bitcast<f32>((bitcast<u32>(_e1161) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1165) & 2147483647u)));
                                                            let _e1207 = (bitcast<f32>((bitcast<u32>(_e1169) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1173) & 2147483647u)));
                                                            let _e1214 = (bitcast<f32>((bitcast<u32>(_e1153) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1157) & 2147483647u)));
                                                            if (_e167.member_2 == 0f) {
                                                                phi_2113_ = 0f;
                                                            } else {
                                                                let _e1244 = bitcast<f32>((bitcast<u32>(_e1174) & 2147483647u));
                                                                let _e1247 = bitcast<f32>((bitcast<u32>(_e1175) & 2147483647u));
                                                                let _e1250 = bitcast<f32>((bitcast<u32>(_e1176) & 2147483647u));
                                                                let _e1252 = select(_e1250, _e1247, (_e1247 > _e1250));
                                                                let _e1256 = select(_e1250, _e1247, (_e1247 < _e1250));
                                                                let _e1260 = select(_e1247, _e1244, (_e1244 < _e1247));
                                                                let _e1262 = select(_e1247, _e1244, (_e1244 > _e1247));
                                                                let _e1264 = select(_e1250, _e1262, (_e1262 < _e1250));
                                                                phi_2113_ = bitcast<f32>((bitcast<u32>((_e167.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1252, _e1244, (_e1244 > _e1252)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1264, _e1260, (_e1260 > _e1264)))) ^ _e167.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1256, _e1244, (_e1244 < _e1256)))) ^ _e167.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1200 + _e1207) + _e1214))) ^ _e167.member_3[0]))) * 1.0000005f)) ^ _e167.member_3[0])))) ^ _e167.member_3[0]));
                                                            }
                                                            let _e1291 = phi_2113_;
                                                            phi_2131_ = (_e1093 || !(((((bitcast<f32>((bitcast<u32>((_e1147.x * _e1174)) ^ _e167.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1147.y * _e1175)) ^ _e167.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1147.z * _e1176)) ^ _e167.member_3[0]))) * f32(-(_e1092))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1147.x) & 2147483647u)) * _e1200)) ^ _e167.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1147.y) & 2147483647u)) * _e1207)) ^ _e167.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1147.z) & 2147483647u)) * _e1214)) ^ _e167.member_3[0]))))) ^ _e167.member_3[0])) + _e1291) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1305 = phi_2131_;
                                                        phi_2132_ = _e1305;
                                                    }
                                                    let _e1307 = phi_2132_;
                                                    if _e1307 {
                                                        if (_e1079.member < _e698.member.member) {
                                                            phi_2152_ = true;
                                                        } else {
                                                            if (_e1079.member == _e698.member.member) {
                                                                phi_2151_ = (_e1079.member_3 < _e698.member.member_3);
                                                            } else {
                                                                phi_2151_ = false;
                                                            }
                                                            let _e1317 = phi_2151_;
                                                            phi_2152_ = _e1317;
                                                        }
                                                        let _e1319 = phi_2152_;
                                                        if _e1319 {
                                                            phi_2158_ = type_49(_e1079, _e1079.member);
                                                        } else {
                                                            phi_2158_ = _e698;
                                                        }
                                                        let _e1322 = phi_2158_;
                                                        phi_2159_ = _e1322;
                                                    } else {
                                                        phi_2159_ = _e698;
                                                    }
                                                    let _e1324 = phi_2159_;
                                                    phi_2160_ = _e1324;
                                                } else {
                                                    phi_2160_ = _e698;
                                                }
                                                let _e1326 = phi_2160_;
                                                phi_1092_ = _e1326;
                                            } else {
                                                phi_1092_ = type_49();
                                            }
                                            let _e1328 = phi_1092_;
                                            continue;
                                            continuing {
                                                phi_1091_ = _e1328;
                                                phi_1094_ = _e713;
                                                phi_2779_ = _e471;
                                                break if !(_e719);
                                            }
                                        }
                                        let _e1331 = phi_2779_;
                                        phi_2911_ = _e1331;
                                        if _e1331 {
                                            break;
                                        }
                                        phi_2915_ = _e1331;
                                        let _e1537 = local_3;
                                        phi_2614_ = _e1537;
                                        phi_2615_ = _e496;
                                        phi_2616_ = false;
                                        phi_2617_ = _e500;
                                    } else {
                                        if (_e496 >= _e74) {
                                            phi_2220_ = type_53(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e496 < _e74) {
                                            } else {
                                                phi_2911_ = true;
                                                break;
                                            }
                                            let _e510 = (_e289 % 3u);
                                            if (_e510 < 3u) {
                                            } else {
                                                phi_2911_ = true;
                                                break;
                                            }
                                            let _e516 = global_3.member[_e496].member[_e510];
                                            let _e522 = (_e288 % 3u);
                                            if (_e522 < 3u) {
                                            } else {
                                                phi_2911_ = true;
                                                break;
                                            }
                                            let _e528 = global_3.member[_e496].member[_e522];
                                            let _e534 = (_e290 % 3u);
                                            if (_e534 < 3u) {
                                            } else {
                                                phi_2911_ = true;
                                                break;
                                            }
                                            let _e540 = global_3.member[_e496].member[_e534];
                                            let _e550 = global_3.member[_e496].member_1;
                                            let _e554 = global_3.member[_e496].member_2;
                                            phi_2220_ = type_53(array<vec4<f32>, 3>(vec4<f32>(_e516[0], _e516[1], _e516[2], _e516[3]), vec4<f32>(_e528[0], _e528[1], _e528[2], _e528[3]), vec4<f32>(_e540[0], _e540[1], _e540[2], _e540[3])), _e550, _e554);
                                        }
                                        let _e557 = phi_2220_;
                                        let _e569 = ((_e557.member[0].x - _e340) * _e345);
                                        let _e570 = ((_e557.member[0].y - _e340) * _e345);
                                        let _e571 = ((_e557.member[0].z - _e341) * _e345);
                                        let _e572 = ((_e557.member[0].w - _e341) * _e345);
                                        let _e582 = ((_e557.member[1].x - _e376) * _e381);
                                        let _e583 = ((_e557.member[1].y - _e376) * _e381);
                                        let _e584 = ((_e557.member[1].z - _e377) * _e381);
                                        let _e585 = ((_e557.member[1].w - _e377) * _e381);
                                        let _e595 = ((_e557.member[2].x - _e412) * _e417);
                                        let _e596 = ((_e557.member[2].y - _e412) * _e417);
                                        let _e597 = ((_e557.member[2].z - _e413) * _e417);
                                        let _e598 = ((_e557.member[2].w - _e413) * _e417);
                                        let _e600 = select(_e597, _e595, (_e595 < _e597));
                                        let _e602 = select(_e598, _e596, (_e596 < _e598));
                                        let _e604 = select(_e597, _e595, (_e595 > _e597));
                                        let _e606 = select(_e598, _e596, (_e596 > _e598));
                                        let _e608 = select(_e571, _e569, (_e569 < _e571));
                                        let _e610 = select(_e572, _e570, (_e570 < _e572));
                                        let _e612 = select(_e584, _e582, (_e582 < _e584));
                                        let _e614 = select(_e585, _e583, (_e583 < _e585));
                                        let _e616 = select(_e612, _e608, (_e608 > _e612));
                                        let _e618 = select(_e614, _e610, (_e610 > _e614));
                                        let _e620 = select(_e600, _e616, (_e616 > _e600));
                                        let _e622 = select(_e602, _e618, (_e618 > _e602));
                                        let _e624 = select(_e571, _e569, (_e569 > _e571));
                                        let _e626 = select(_e572, _e570, (_e570 > _e572));
                                        let _e628 = select(_e584, _e582, (_e582 > _e584));
                                        let _e630 = select(_e585, _e583, (_e583 > _e585));
                                        let _e632 = select(_e628, _e624, (_e624 < _e628));
                                        let _e634 = select(_e630, _e626, (_e626 < _e630));
                                        let _e639 = -(_e600);
                                        let _e640 = -(_e602);
                                        let _e647 = (select(_e604, _e632, (_e632 < _e604)) + (select(_e639, _e604, (_e604 > _e639)) * 0.0000019073523f));
                                        let _e648 = (select(_e606, _e634, (_e634 < _e606)) + (select(_e640, _e606, (_e606 > _e640)) * 0.0000019073523f));
                                        let _e650 = select(_e463, _e620, (_e620 > _e463));
                                        let _e652 = select(_e463, _e622, (_e622 > _e463));
                                        let _e657 = (_e650 <= select(_e473.member_1, _e647, (_e647 < _e473.member_1)));
                                        let _e658 = (_e652 <= select(_e473.member_1, _e648, (_e648 < _e473.member_1)));
                                        let _e659 = (_e650 <= _e652);
                                        if _e657 {
                                            if _e658 {
                                                if _e659 {
                                                    phi_2564_ = _e557.member_2;
                                                } else {
                                                    phi_2564_ = _e557.member_1;
                                                }
                                                let _e663 = phi_2564_;
                                                let _e664 = (_e500 % 128u);
                                                let _e665 = (_e664 < 128u);
                                                if _e665 {
                                                } else {
                                                    phi_2911_ = true;
                                                    break;
                                                }
                                                local_1[_e664] = _e663;
                                                if _e665 {
                                                } else {
                                                    phi_2911_ = true;
                                                    break;
                                                }
                                                local[_e664] = select(_e652, _e650, (_e650 > _e652));
                                                if _e659 {
                                                    phi_2591_ = _e557.member_1;
                                                } else {
                                                    phi_2591_ = _e557.member_2;
                                                }
                                                let _e674 = phi_2591_;
                                                phi_2592_ = _e674;
                                                phi_2593_ = (_e500 + 1u);
                                            } else {
                                                phi_2592_ = u32();
                                                phi_2593_ = u32();
                                            }
                                            let _e676 = phi_2592_;
                                            let _e678 = phi_2593_;
                                            phi_2595_ = _e676;
                                            phi_2596_ = _e678;
                                            phi_2597_ = select(true, false, _e658);
                                        } else {
                                            phi_2595_ = u32();
                                            phi_2596_ = u32();
                                            phi_2597_ = true;
                                        }
                                        let _e681 = phi_2595_;
                                        let _e683 = phi_2596_;
                                        let _e685 = phi_2597_;
                                        if _e685 {
                                            if _e657 {
                                                phi_2606_ = _e557.member_1;
                                            } else {
                                                phi_2606_ = _e557.member_2;
                                            }
                                            let _e689 = phi_2606_;
                                            phi_2611_ = _e689;
                                            phi_2612_ = select(_e658, true, _e657);
                                        } else {
                                            phi_2611_ = _e681;
                                            phi_2612_ = _e498;
                                        }
                                        let _e692 = phi_2611_;
                                        let _e694 = phi_2612_;
                                        phi_2915_ = _e471;
                                        phi_2614_ = _e473;
                                        phi_2615_ = _e692;
                                        phi_2616_ = _e694;
                                        phi_2617_ = select(_e683, _e500, _e685);
                                    }
                                    let _e1333 = phi_2915_;
                                    let _e1335 = phi_2614_;
                                    let _e1337 = phi_2615_;
                                    let _e1339 = phi_2616_;
                                    let _e1341 = phi_2617_;
                                    phi_2914_ = _e1333;
                                    phi_2618_ = _e1335;
                                    phi_2619_ = _e1337;
                                    phi_2620_ = (_e477 - 1u);
                                    phi_2621_ = _e1339;
                                    phi_2622_ = _e1341;
                                } else {
                                    phi_2914_ = _e471;
                                    phi_2618_ = _e473;
                                    phi_2619_ = _e496;
                                    phi_2620_ = _e477;
                                    phi_2621_ = _e498;
                                    phi_2622_ = _e500;
                                }
                                let _e1343 = phi_2914_;
                                let _e1345 = phi_2618_;
                                let _e1347 = phi_2619_;
                                let _e1349 = phi_2620_;
                                let _e1351 = phi_2621_;
                                let _e1353 = phi_2622_;
                                phi_2913_ = _e1343;
                                phi_2623_ = _e1345;
                                phi_2624_ = _e1347;
                                phi_2625_ = _e1349;
                                phi_2626_ = _e1351;
                                phi_2627_ = _e1353;
                            } else {
                                phi_2913_ = _e471;
                                phi_2623_ = type_49();
                                phi_2624_ = u32();
                                phi_2625_ = u32();
                                phi_2626_ = bool();
                                phi_2627_ = u32();
                            }
                            let _e1355 = phi_2913_;
                            let _e1357 = phi_2623_;
                            let _e1359 = phi_2624_;
                            let _e1361 = phi_2625_;
                            let _e1363 = phi_2626_;
                            let _e1365 = phi_2627_;
                            phi_2912_ = _e1355;
                            phi_1024_ = _e1357;
                            phi_1027_ = _e1359;
                            phi_1029_ = _e1361;
                            phi_1031_ = _e1363;
                            phi_1033_ = _e1365;
                            phi_2628_ = _e485;
                        } else {
                            phi_2912_ = _e471;
                            phi_1024_ = type_49();
                            phi_1027_ = u32();
                            phi_1029_ = u32();
                            phi_1031_ = bool();
                            phi_1033_ = u32();
                            phi_2628_ = false;
                        }
                        let _e1367 = phi_2912_;
                        let _e1369 = phi_1024_;
                        let _e1371 = phi_1027_;
                        let _e1373 = phi_1029_;
                        let _e1375 = phi_1031_;
                        let _e1377 = phi_1033_;
                        let _e1379 = phi_2628_;
                        continue;
                        continuing {
                            phi_2785_ = _e1367;
                            phi_1023_ = _e1369;
                            phi_1026_ = _e1371;
                            phi_1028_ = _e1373;
                            phi_1030_ = _e1375;
                            phi_1032_ = _e1377;
                            phi_2911_ = _e1367;
                            break if !(_e1379);
                        }
                    }
                    let _e1382 = phi_2911_;
                    if _e1382 {
                        break;
                    }
                    let _e1384 = local_2;
                    if (_e1384.member.member_3 != 4294967295u) {
                        let _e1389 = (_e291 / 3i);
                        let _e1396 = bitcast<f32>((bitcast<u32>((_e1389 + 127i)) << bitcast<u32>(23i)));
                        let _e1404 = (((_e1384.member.member * _e1396) * _e1396) * bitcast<f32>((bitcast<u32>(((_e291 - (2i * _e1389)) + 127i)) << bitcast<u32>(23i))));
                        let _e1406 = select(340282350000000000000000000000000000000f, _e1404, (_e1404 < 340282350000000000000000000000000000000f));
                        phi_2680_ = type_28(select(-340282350000000000000000000000000000000f, _e1406, (_e1406 > -340282350000000000000000000000000000000f)), _e1384.member.member_1, _e1384.member.member_2, _e1384.member.member_3);
                    } else {
                        phi_2680_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1413 = phi_2680_;
                    if _e168 {
                    } else {
                        break;
                    }
                    global_8.member[_e92] = _e1413;
                    if _e93 {
                    } else {
                        break;
                    }
                    let _e1417 = select(0u, 1u, (_e235 <= _e245));
                    if (_e1417 > 0u) {
                        let _e1419 = (1u < _e88);
                        if _e1419 {
                            if (0u < _e88) {
                            } else {
                                break;
                            }
                            let _e1423 = atomicAdd((&global_9.member[0u]), _e1417);
                            if ((_e1423 + _e1417) < _e1423) {
                                if _e1419 {
                                } else {
                                    break;
                                }
                                let _e1428 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1431 = select(0u, 1u, (_e1413.member_3 != 4294967295u));
                    if (_e1431 > 0u) {
                        let _e1433 = (3u < _e88);
                        if _e1433 {
                            if (2u < _e88) {
                            } else {
                                break;
                            }
                            let _e1437 = atomicAdd((&global_9.member[2u]), _e1431);
                            if ((_e1437 + _e1431) < _e1437) {
                                if _e1433 {
                                } else {
                                    break;
                                }
                                let _e1442 = atomicAdd((&global_9.member[3u]), 1u);
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
fn trace_paths_facing(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
