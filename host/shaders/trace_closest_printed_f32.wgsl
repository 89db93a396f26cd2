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

struct type_33 {
    member: type_22,
    member_1: f32,
}

struct type_37 {
    member: array<type_26>,
}

struct type_40 {
    member: array<vec4<u32>, 2>,
}

struct type_42 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_44 {
    member: array<type_42>,
}

struct type_47 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_49 {
    member: type_47,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(3) 
var<storage> global_2: type_15;
@group(0) @binding(1) 
var<uniform> global_3: type_40;
@group(0) @binding(4) 
var<storage> global_4: type_37;
@group(0) @binding(2) 
var<storage> global_5: type_44;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_24;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<f32, 128>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<u32, 128>;
    var local_7: array<f32, 128>;
    var local_8: array<f32, 3>;
    var local_9: array<f32, 3>;
    var phi_323_: i32;
    var phi_324_: i32;
    var phi_334_: bool;
    var phi_344_: u32;
    var phi_345_: u32;
    var phi_347_: bool;
    var phi_352_: u32;
    var phi_364_: i32;
    var phi_384_: i32;
    var phi_402_: f32;
    var phi_408_: f32;
    var phi_419_: f32;
    var phi_425_: f32;
    var phi_448_: f32;
    var phi_459_: f32;
    var phi_468_: f32;
    var phi_474_: f32;
    var phi_485_: f32;
    var phi_491_: f32;
    var phi_514_: f32;
    var phi_525_: f32;
    var phi_534_: f32;
    var phi_540_: f32;
    var phi_551_: f32;
    var phi_557_: f32;
    var phi_580_: f32;
    var phi_591_: f32;
    var phi_691_: f32;
    var phi_692_: f32;
    var phi_2704_: bool;
    var phi_765_: type_33;
    var phi_768_: type_49;
    var phi_770_: u32;
    var phi_772_: bool;
    var phi_774_: u32;
    var phi_785_: bool;
    var phi_871_: type_49;
    var phi_872_: bool;
    var phi_873_: u32;
    var phi_1656_: type_42;
    var phi_2488_: type_49;
    var phi_2565_: type_49;
    var phi_2566_: type_49;
    var phi_2567_: u32;
    var phi_2569_: type_49;
    var phi_2570_: u32;
    var phi_2571_: bool;
    var phi_2578_: type_49;
    var phi_2583_: type_49;
    var phi_2584_: bool;
    var phi_891_: type_33;
    var phi_894_: type_4;
    var phi_895_: type_4;
    var phi_917_: type_4;
    var phi_938_: u32;
    var phi_1027_: array<array<f32, 3>, 3>;
    var phi_1498_: vec3<f32>;
    var phi_1499_: vec3<f32>;
    var phi_1530_: bool;
    var phi_1539_: vec3<f32>;
    var phi_1579_: type_22;
    var phi_1581_: type_22;
    var phi_1582_: bool;
    var phi_1586_: type_22;
    var phi_1587_: type_22;
    var phi_1588_: type_22;
    var phi_1589_: bool;
    var phi_1593_: type_22;
    var phi_1594_: bool;
    var phi_1598_: type_22;
    var phi_1599_: bool;
    var phi_1603_: type_22;
    var phi_1628_: bool;
    var phi_1629_: bool;
    var phi_1635_: type_33;
    var phi_1636_: type_33;
    var phi_1637_: type_33;
    var phi_892_: type_33;
    var phi_2698_: bool;
    var phi_2816_: bool;
    var phi_2586_: type_33;
    var phi_2587_: type_49;
    var phi_2588_: bool;
    var phi_2589_: u32;
    var phi_2815_: bool;
    var phi_2590_: type_33;
    var phi_2591_: type_49;
    var phi_2592_: u32;
    var phi_2593_: bool;
    var phi_2594_: u32;
    var phi_2814_: bool;
    var phi_2595_: type_33;
    var phi_2596_: type_49;
    var phi_2597_: u32;
    var phi_2598_: bool;
    var phi_2599_: u32;
    var phi_2813_: bool;
    var phi_766_: type_33;
    var phi_769_: type_49;
    var phi_771_: u32;
    var phi_773_: bool;
    var phi_775_: u32;
    var phi_2600_: bool;
    var phi_2812_: bool;
    var local_10: type_33;
    var phi_2652_: type_22;
    var local_11: type_33;

    switch bitcast<i32>(0u) {
        default: {
            let _e74 = global;
            let _e77 = arrayLength((&global_5.member));
            let _e79 = arrayLength((&global_2.member));
            let _e87 = global_3.member[0u][0u];
            let _e91 = global_3.member[0u][1u];
            let _e95 = global_3.member[0u][2u];
            let _e99 = global_3.member[1u][0u];
            let _e103 = global_3.member[1u][1u];
            let _e107 = global_3.member[1u][2u];
            let _e111 = global_3.member[1u][3u];
            let _e114 = global_1.member[0u];
            let _e115 = bitcast<i32>(_e114);
            let _e125 = (_e74.x + (_e74.y * 2097152u));
            let _e126 = (_e125 < arrayLength((&global_4.member)));
            if _e126 {
                let _e127 = (_e125 < arrayLength((&global_6.member)));
                if _e127 {
                    if _e126 {
                    } else {
                        break;
                    }
                    let _e135 = global_4.member[_e125].member_2[0u];
                    let _e137 = (bitcast<u32>(_e135) & 2147483647u);
                    let _e142 = global_4.member[_e125].member_2[1u];
                    let _e144 = (bitcast<u32>(_e142) & 2147483647u);
                    let _e149 = global_4.member[_e125].member_2[2u];
                    let _e151 = (bitcast<u32>(_e149) & 2147483647u);
                    let _e156 = global_4.member[_e125].member[0u];
                    let _e158 = (bitcast<u32>(_e156) & 2147483647u);
                    let _e163 = global_4.member[_e125].member[1u];
                    let _e165 = (bitcast<u32>(_e163) & 2147483647u);
                    let _e170 = global_4.member[_e125].member[2u];
                    let _e172 = (bitcast<u32>(_e170) & 2147483647u);
                    let _e174 = select(_e144, _e137, (_e144 < _e137));
                    let _e176 = select(_e151, _e174, (_e151 < _e174));
                    let _e178 = select(_e158, _e176, (_e158 < _e176));
                    let _e180 = select(_e165, _e178, (_e165 < _e178));
                    let _e182 = select(_e172, _e180, (_e172 < _e180));
                    let _e186 = global_4.member[_e125].member_1;
                    let _e188 = (bitcast<u32>(_e186) & 2147483647u);
                    let _e195 = global_4.member[_e125].member_3;
                    let _e201 = (((select(_e188, _e182, (_e188 < _e182)) < 2139095040u) && ((bitcast<u32>(_e195) & 2147483647u) <= 2139095040u)) && (_e176 > 0u));
                    if _e201 {
                        let _e204 = (bitcast<u32>(bitcast<f32>(_e176)) & 2147483647u);
                        if (_e204 >= 8388608u) {
                            phi_323_ = (bitcast<i32>((_e204 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_323_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e204)), 32u, (_e204 == 0u))));
                        }
                        let _e218 = phi_323_;
                        phi_324_ = _e218;
                    } else {
                        phi_324_ = 0i;
                    }
                    let _e220 = phi_324_;
                    let _e221 = (_e137 == _e176);
                    if _e221 {
                        phi_334_ = true;
                    } else {
                        phi_334_ = (_e144 == _e176);
                    }
                    let _e224 = phi_334_;
                    let _e225 = select(1u, 0u, _e221);
                    if _e224 {
                        let _e226 = (_e225 + 1u);
                        phi_344_ = _e226;
                        phi_345_ = _e226;
                        phi_347_ = select(true, false, (_e226 == 2u));
                    } else {
                        phi_344_ = u32();
                        phi_345_ = 0u;
                        phi_347_ = true;
                    }
                    let _e230 = phi_344_;
                    let _e232 = phi_345_;
                    let _e234 = phi_347_;
                    if _e234 {
                        phi_352_ = (_e232 + 1u);
                    } else {
                        phi_352_ = 0u;
                    }
                    let _e238 = phi_352_;
                    let _e239 = select(_e230, _e232, _e234);
                    let _e240 = select(_e225, select(2u, _e225, _e224), _e234);
                    if (_e115 < -126i) {
                        phi_364_ = -126i;
                    } else {
                        phi_364_ = select(_e115, 127i, (_e115 > 127i));
                    }
                    let _e245 = phi_364_;
                    let _e250 = bitcast<f32>((bitcast<u32>((_e245 + 127i)) << bitcast<u32>(23i)));
                    let _e256 = bitcast<f32>((bitcast<u32>(((_e115 - _e245) + 127i)) << bitcast<u32>(23i)));
                    let _e257 = -(_e220);
                    if (_e257 < -126i) {
                        phi_384_ = -126i;
                    } else {
                        phi_384_ = select(_e257, 127i, (_e257 > 127i));
                    }
                    let _e262 = phi_384_;
                    let _e267 = bitcast<f32>((bitcast<u32>((_e262 + 127i)) << bitcast<u32>(23i)));
                    let _e273 = bitcast<f32>((bitcast<u32>(((_e257 - _e262) + 127i)) << bitcast<u32>(23i)));
                    let _e277 = global_4.member[_e125].member;
                    let _e278 = (_e239 == 0u);
                    if _e278 {
                        phi_402_ = _e277[0];
                    } else {
                        phi_402_ = _e277[1];
                    }
                    let _e282 = phi_402_;
                    let _e283 = (_e239 == 2u);
                    if _e283 {
                        phi_408_ = _e277[2];
                    } else {
                        phi_408_ = _e282;
                    }
                    let _e286 = phi_408_;
                    let _e288 = ((_e286 * _e250) * _e256);
                    let _e289 = global_4.member[_e125].member_2;
                    if _e278 {
                        phi_419_ = _e289[0];
                    } else {
                        phi_419_ = _e289[1];
                    }
                    let _e293 = phi_419_;
                    if _e283 {
                        phi_425_ = _e289[2];
                    } else {
                        phi_425_ = _e293;
                    }
                    let _e296 = phi_425_;
                    let _e298 = ((_e296 * _e267) * _e273);
                    let _e302 = (bitcast<f32>((bitcast<u32>(_e298) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e302 {
                        let _e306 = (bitcast<f32>((bitcast<u32>(_e288) & 2147483647u)) * 0.00000011920929f);
                        phi_448_ = select(0.00000000000011368684f, _e306, (_e306 > 0.00000000000011368684f));
                    } else {
                        phi_448_ = 0f;
                    }
                    let _e310 = phi_448_;
                    let _e311 = (_e288 + _e310);
                    let _e312 = (_e288 - _e310);
                    let _e313 = select(_e298, 0f, _e302);
                    if _e302 {
                        phi_459_ = 38685626000000000000000000f;
                    } else {
                        phi_459_ = (1f / _e298);
                    }
                    let _e316 = phi_459_;
                    let _e317 = (_e238 == 0u);
                    if _e317 {
                        phi_468_ = _e277[0];
                    } else {
                        phi_468_ = _e277[1];
                    }
                    let _e321 = phi_468_;
                    let _e322 = (_e238 == 2u);
                    if _e322 {
                        phi_474_ = _e277[2];
                    } else {
                        phi_474_ = _e321;
                    }
                    let _e325 = phi_474_;
                    let _e327 = ((_e325 * _e250) * _e256);
                    if _e317 {
                        phi_485_ = _e289[0];
                    } else {
                        phi_485_ = _e289[1];
                    }
                    let _e331 = phi_485_;
                    if _e322 {
                        phi_491_ = _e289[2];
                    } else {
                        phi_491_ = _e331;
                    }
                    let _e334 = phi_491_;
                    let _e336 = ((_e334 * _e267) * _e273);
                    let _e340 = (bitcast<f32>((bitcast<u32>(_e336) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e340 {
                        let _e344 = (bitcast<f32>((bitcast<u32>(_e327) & 2147483647u)) * 0.00000011920929f);
                        phi_514_ = select(0.00000000000011368684f, _e344, (_e344 > 0.00000000000011368684f));
                    } else {
                        phi_514_ = 0f;
                    }
                    let _e348 = phi_514_;
                    let _e349 = (_e327 + _e348);
                    let _e350 = (_e327 - _e348);
                    let _e351 = select(_e336, 0f, _e340);
                    if _e340 {
                        phi_525_ = 38685626000000000000000000f;
                    } else {
                        phi_525_ = (1f / _e336);
                    }
                    let _e354 = phi_525_;
                    let _e355 = (_e240 == 0u);
                    if _e355 {
                        phi_534_ = _e277[0];
                    } else {
                        phi_534_ = _e277[1];
                    }
                    let _e359 = phi_534_;
                    let _e360 = (_e240 == 2u);
                    if _e360 {
                        phi_540_ = _e277[2];
                    } else {
                        phi_540_ = _e359;
                    }
                    let _e363 = phi_540_;
                    let _e365 = ((_e363 * _e250) * _e256);
                    if _e355 {
                        phi_551_ = _e289[0];
                    } else {
                        phi_551_ = _e289[1];
                    }
                    let _e369 = phi_551_;
                    if _e360 {
                        phi_557_ = _e289[2];
                    } else {
                        phi_557_ = _e369;
                    }
                    let _e372 = phi_557_;
                    let _e374 = ((_e372 * _e267) * _e273);
                    let _e378 = (bitcast<f32>((bitcast<u32>(_e374) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e378 {
                        let _e382 = (bitcast<f32>((bitcast<u32>(_e365) & 2147483647u)) * 0.00000011920929f);
                        phi_580_ = select(0.00000000000011368684f, _e382, (_e382 > 0.00000000000011368684f));
                    } else {
                        phi_580_ = 0f;
                    }
                    let _e386 = phi_580_;
                    let _e387 = (_e365 + _e386);
                    let _e388 = (_e365 - _e386);
                    let _e389 = select(_e374, 0f, _e378);
                    if _e378 {
                        phi_591_ = 38685626000000000000000000f;
                    } else {
                        phi_591_ = (1f / _e374);
                    }
                    let _e392 = phi_591_;
                    let _e395 = bitcast<f32>((bitcast<u32>(_e288) & 2147483647u));
                    let _e398 = bitcast<f32>((bitcast<u32>(_e327) & 2147483647u));
                    let _e400 = select(_e398, _e395, (_e395 > _e398));
                    let _e403 = bitcast<f32>((bitcast<u32>(_e365) & 2147483647u));
                    let _e406 = (_e115 + _e220);
                    if (_e201 && (select(_e403, _e400, (_e400 > _e403)) <= 1099511600000f)) {
                        let _e409 = (_e406 / 3i);
                        let _e416 = bitcast<f32>((bitcast<u32>((_e409 + 127i)) << bitcast<u32>(23i)));
                        let _e423 = bitcast<f32>((bitcast<u32>(((_e406 - (2i * _e409)) + 127i)) << bitcast<u32>(23i)));
                        let _e424 = (((_e186 * _e416) * _e416) * _e423);
                        let _e426 = select(340282350000000000000000000000000000000f, _e424, (_e424 < 340282350000000000000000000000000000000f));
                        let _e431 = (((_e195 * _e416) * _e416) * _e423);
                        let _e433 = select(340282350000000000000000000000000000000f, _e431, (_e431 < 340282350000000000000000000000000000000f));
                        phi_691_ = select(-340282350000000000000000000000000000000f, _e433, (_e433 > -340282350000000000000000000000000000000f));
                        phi_692_ = select(-340282350000000000000000000000000000000f, _e426, (_e426 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_691_ = 0f;
                        phi_692_ = 1f;
                    }
                    let _e437 = phi_691_;
                    let _e439 = phi_692_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 3>(bitcast<f32>(_e87), bitcast<f32>(_e91), bitcast<f32>(_e95));
                    let _e444 = (_e239 % 3u);
                    let _e445 = (_e444 < 3u);
                    if _e445 {
                    } else {
                        break;
                    }
                    let _e447 = local_9[_e444];
                    let _e448 = (_e238 % 3u);
                    let _e449 = (_e448 < 3u);
                    if _e449 {
                    } else {
                        break;
                    }
                    let _e451 = local_9[_e448];
                    let _e452 = (_e240 % 3u);
                    let _e453 = (_e452 < 3u);
                    if _e453 {
                    } else {
                        break;
                    }
                    let _e455 = local_9[_e452];
                    local_8 = array<f32, 3>(bitcast<f32>(_e99), bitcast<f32>(_e103), bitcast<f32>(_e107));
                    if _e445 {
                    } else {
                        break;
                    }
                    let _e459 = local_8[_e444];
                    if _e449 {
                    } else {
                        break;
                    }
                    let _e461 = local_8[_e448];
                    if _e453 {
                    } else {
                        break;
                    }
                    let _e463 = local_8[_e452];
                    phi_2704_ = false;
                    phi_765_ = type_33(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e437);
                    phi_768_ = type_49(type_47(array<f32, 3>(_e447, _e451, _e455), array<f32, 3>(_e459, _e461, _e463)), select(0u, 2147483648u, (_e77 == 0u)));
                    phi_770_ = ((3u * _e77) + 1u);
                    phi_772_ = (_e439 <= _e437);
                    phi_774_ = 0u;
                    loop {
                        let _e471 = phi_2704_;
                        let _e473 = phi_765_;
                        let _e475 = phi_768_;
                        let _e477 = phi_770_;
                        let _e479 = phi_772_;
                        let _e481 = phi_774_;
                        local_10 = _e473;
                        if _e479 {
                            phi_785_ = true;
                        } else {
                            phi_785_ = (_e481 > 0u);
                        }
                        let _e484 = phi_785_;
                        if _e484 {
                            let _e485 = (_e477 > 0u);
                            if _e485 {
                                if _e479 {
                                    phi_871_ = _e475;
                                    phi_872_ = _e479;
                                    phi_873_ = _e481;
                                } else {
                                    let _e486 = (_e481 - 1u);
                                    let _e487 = (_e486 % 128u);
                                    let _e488 = (_e487 < 128u);
                                    if _e488 {
                                    } else {
                                        phi_2812_ = true;
                                        break;
                                    }
                                    let _e490 = local_6[_e487];
                                    if _e488 {
                                    } else {
                                        phi_2812_ = true;
                                        break;
                                    }
                                    let _e492 = local_5[_e487];
                                    if _e488 {
                                    } else {
                                        phi_2812_ = true;
                                        break;
                                    }
                                    let _e494 = local_4[_e487];
                                    if _e488 {
                                    } else {
                                        phi_2812_ = true;
                                        break;
                                    }
                                    let _e496 = local_3[_e487];
                                    if _e488 {
                                    } else {
                                        phi_2812_ = true;
                                        break;
                                    }
                                    let _e499 = local_2[_e487];
                                    if _e488 {
                                    } else {
                                        phi_2812_ = true;
                                        break;
                                    }
                                    let _e501 = local_1[_e487];
                                    if _e488 {
                                    } else {
                                        phi_2812_ = true;
                                        break;
                                    }
                                    let _e503 = local[_e487];
                                    if _e488 {
                                    } else {
                                        phi_2812_ = true;
                                        break;
                                    }
                                    let _e508 = local_7[_e487];
                                    phi_871_ = type_49(type_47(array<f32, 3>(_e492, _e494, _e496), array<f32, 3>(_e499, _e501, _e503)), _e490);
                                    phi_872_ = (_e508 <= _e473.member_1);
                                    phi_873_ = _e486;
                                }
                                let _e512 = phi_871_;
                                let _e514 = phi_872_;
                                let _e516 = phi_873_;
                                if _e514 {
                                    if ((_e512.member_1 & 2147483648u) != 0u) {
                                        phi_891_ = _e473;
                                        phi_894_ = type_4(0u, ((_e512.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e868 = phi_891_;
                                            let _e870 = phi_894_;
                                            local_11 = _e868;
                                            if (_e870.member < _e870.member_1) {
                                                phi_895_ = type_4((_e870.member + 1u), _e870.member_1);
                                                phi_917_ = type_4(1u, _e870.member);
                                            } else {
                                                phi_895_ = _e870;
                                                phi_917_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e883 = phi_895_;
                                            let _e885 = phi_917_;
                                            let _e889 = (bitcast<i32>(_e885.member) != 0i);
                                            if _e889 {
                                                let _e890 = ((_e512.member_1 & 268435455u) + _e885.member_1);
                                                let _e891 = (_e890 < _e79);
                                                if _e891 {
                                                    if _e891 {
                                                    } else {
                                                        phi_2698_ = true;
                                                        break;
                                                    }
                                                    let _e895 = global_2.member[_e890].member_1;
                                                    phi_938_ = _e895;
                                                } else {
                                                    phi_938_ = 4294967295u;
                                                }
                                                let _e897 = phi_938_;
                                                if (_e890 >= _e79) {
                                                    phi_1027_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e891 {
                                                    } else {
                                                        phi_2698_ = true;
                                                        break;
                                                    }
                                                    if (_e444 < 9u) {
                                                    } else {
                                                        phi_2698_ = true;
                                                        break;
                                                    }
                                                    let _e904 = global_2.member[_e890].member[_e444];
                                                    if (_e448 < 9u) {
                                                    } else {
                                                        phi_2698_ = true;
                                                        break;
                                                    }
                                                    let _e910 = global_2.member[_e890].member[_e448];
                                                    if (_e452 < 9u) {
                                                    } else {
                                                        phi_2698_ = true;
                                                        break;
                                                    }
                                                    let _e916 = global_2.member[_e890].member[_e452];
                                                    let _e918 = (3u + _e444);
                                                    if (_e918 < 9u) {
                                                    } else {
                                                        phi_2698_ = true;
                                                        break;
                                                    }
                                                    let _e924 = global_2.member[_e890].member[_e918];
                                                    let _e925 = (3u + _e448);
                                                    if (_e925 < 9u) {
                                                    } else {
                                                        phi_2698_ = true;
                                                        break;
                                                    }
                                                    let _e931 = global_2.member[_e890].member[_e925];
                                                    let _e932 = (3u + _e452);
                                                    if (_e932 < 9u) {
                                                    } else {
                                                        phi_2698_ = true;
                                                        break;
                                                    }
                                                    let _e938 = global_2.member[_e890].member[_e932];
                                                    let _e940 = (6u + _e444);
                                                    if (_e940 < 9u) {
                                                    } else {
                                                        phi_2698_ = true;
                                                        break;
                                                    }
                                                    let _e946 = global_2.member[_e890].member[_e940];
                                                    let _e947 = (6u + _e448);
                                                    if (_e947 < 9u) {
                                                    } else {
                                                        phi_2698_ = true;
                                                        break;
                                                    }
                                                    let _e953 = global_2.member[_e890].member[_e947];
                                                    let _e954 = (6u + _e452);
                                                    if (_e954 < 9u) {
                                                    } else {
                                                        phi_2698_ = true;
                                                        break;
                                                    }
                                                    let _e960 = global_2.member[_e890].member[_e954];
                                                    phi_1027_ = array<array<f32, 3>, 3>(array<f32, 3>(_e904, _e910, _e916), array<f32, 3>(_e924, _e931, _e938), array<f32, 3>(_e946, _e953, _e960));
                                                }
                                                let _e964 = phi_1027_;
                                                let _e972 = (_e964[0][2] - _e365);
                                                let _e975 = (((_e964[0][0] - _e288) * _e389) - (_e972 * _e313));
                                                let _e978 = (((_e964[0][1] - _e327) * _e389) - (_e972 * _e351));
                                                let _e985 = (_e964[1][2] - _e365);
                                                let _e988 = (((_e964[1][0] - _e288) * _e389) - (_e985 * _e313));
                                                let _e991 = (((_e964[1][1] - _e327) * _e389) - (_e985 * _e351));
                                                let _e998 = (_e964[2][2] - _e365);
                                                let _e1001 = (((_e964[2][0] - _e288) * _e389) - (_e998 * _e313));
                                                let _e1004 = (((_e964[2][1] - _e327) * _e389) - (_e998 * _e351));
                                                let _e1005 = (_e1001 * _e991);
                                                let _e1006 = (_e1004 * _e988);
                                                let _e1007 = (_e975 * _e1004);
                                                let _e1008 = (_e978 * _e1001);
                                                let _e1009 = (_e988 * _e978);
                                                let _e1010 = (_e991 * _e975);
                                                let _e1015 = (((_e1005 >= _e1006) && (_e1007 >= _e1008)) && (_e1009 >= _e1010));
                                                if (_e1015 || (((_e1005 <= _e1006) && (_e1007 <= _e1008)) && (_e1009 <= _e1010))) {
                                                    let _e1022 = select(-1f, 1f, _e1015);
                                                    let _e1024 = ((_e1005 - _e1006) * _e1022);
                                                    let _e1026 = select(0f, _e1024, (_e1024 > 0f));
                                                    let _e1028 = ((_e1007 - _e1008) * _e1022);
                                                    let _e1030 = select(0f, _e1028, (_e1028 > 0f));
                                                    let _e1032 = ((_e1009 - _e1010) * _e1022);
                                                    let _e1034 = select(0f, _e1032, (_e1032 > 0f));
                                                    let _e1036 = ((_e1026 + _e1030) + _e1034);
                                                    if (_e1036 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1593_ = type_22();
                                                        phi_1594_ = true;
                                                    } else {
                                                        let _e1039 = select(_e964[1][0], _e964[0][0], (_e964[0][0] < _e964[1][0]));
                                                        let _e1043 = select(_e964[1][0], _e964[0][0], (_e964[0][0] > _e964[1][0]));
                                                        let _e1047 = select(_e964[1][1], _e964[0][1], (_e964[0][1] < _e964[1][1]));
                                                        let _e1051 = select(_e964[1][1], _e964[0][1], (_e964[0][1] > _e964[1][1]));
                                                        let _e1055 = select(_e964[1][2], _e964[0][2], (_e964[0][2] < _e964[1][2]));
                                                        let _e1059 = select(_e964[1][2], _e964[0][2], (_e964[0][2] > _e964[1][2]));
                                                        let _e1064 = ((select(_e964[2][0], _e1039, (_e1039 < _e964[2][0])) - _e311) * _e316);
                                                        let _e1065 = ((select(_e964[2][0], _e1043, (_e1043 > _e964[2][0])) - _e312) * _e316);
                                                        let _e1068 = ((select(_e964[2][1], _e1047, (_e1047 < _e964[2][1])) - _e349) * _e354);
                                                        let _e1069 = ((select(_e964[2][1], _e1051, (_e1051 > _e964[2][1])) - _e350) * _e354);
                                                        let _e1072 = ((select(_e964[2][2], _e1055, (_e1055 < _e964[2][2])) - _e387) * _e392);
                                                        let _e1073 = ((select(_e964[2][2], _e1059, (_e1059 > _e964[2][2])) - _e388) * _e392);
                                                        let _e1075 = select(_e1073, _e1072, (_e1072 < _e1073));
                                                        let _e1077 = select(_e1073, _e1072, (_e1072 > _e1073));
                                                        let _e1079 = select(_e1065, _e1064, (_e1064 < _e1065));
                                                        let _e1081 = select(_e1069, _e1068, (_e1068 < _e1069));
                                                        let _e1083 = select(_e1081, _e1079, (_e1079 > _e1081));
                                                        let _e1085 = select(_e1075, _e1083, (_e1083 > _e1075));
                                                        let _e1087 = select(_e1065, _e1064, (_e1064 > _e1065));
                                                        let _e1089 = select(_e1069, _e1068, (_e1068 > _e1069));
                                                        let _e1091 = select(_e1089, _e1087, (_e1087 < _e1089));
                                                        let _e1093 = select(_e1077, _e1091, (_e1091 < _e1077));
                                                        let _e1094 = -(_e1075);
                                                        let _e1100 = select(_e439, _e1085, (_e1085 > _e439));
                                                        if (_e1100 > (_e1093 + (select(_e1094, _e1077, (_e1077 > _e1094)) * 0.0000019073523f))) {
                                                            phi_1588_ = type_22();
                                                            phi_1589_ = true;
                                                        } else {
                                                            let _e1102 = (_e1100 > _e868.member_1);
                                                            if _e1102 {
                                                                phi_1587_ = type_22();
                                                            } else {
                                                                let _e1106 = (_e964[1][0] - _e964[0][0]);
                                                                let _e1107 = (_e964[1][1] - _e964[0][1]);
                                                                let _e1108 = (_e964[1][2] - _e964[0][2]);
                                                                let _e1109 = vec3<f32>(_e1106, _e1107, _e1108);
                                                                let _e1110 = (_e964[2][0] - _e964[1][0]);
                                                                let _e1111 = (_e964[2][1] - _e964[1][1]);
                                                                let _e1112 = (_e964[2][2] - _e964[1][2]);
                                                                let _e1113 = vec3<f32>(_e1110, _e1111, _e1112);
                                                                let _e1114 = (_e964[0][0] - _e964[2][0]);
                                                                let _e1115 = (_e964[0][1] - _e964[2][1]);
                                                                let _e1116 = (_e964[0][2] - _e964[2][2]);
                                                                let _e1117 = vec3<f32>(_e1114, _e1115, _e1116);
                                                                let _e1120 = bitcast<f32>((bitcast<u32>(_e1106) & 2147483647u));
                                                                let _e1123 = bitcast<f32>((bitcast<u32>(_e1107) & 2147483647u));
                                                                let _e1125 = select(_e1123, _e1120, (_e1120 > _e1123));
                                                                let _e1128 = bitcast<f32>((bitcast<u32>(_e1108) & 2147483647u));
                                                                let _e1130 = select(_e1128, _e1125, (_e1125 > _e1128));
                                                                let _e1133 = bitcast<f32>((bitcast<u32>(_e1110) & 2147483647u));
                                                                let _e1136 = bitcast<f32>((bitcast<u32>(_e1111) & 2147483647u));
                                                                let _e1138 = select(_e1136, _e1133, (_e1133 > _e1136));
                                                                let _e1141 = bitcast<f32>((bitcast<u32>(_e1112) & 2147483647u));
                                                                let _e1143 = select(_e1141, _e1138, (_e1138 > _e1141));
                                                                let _e1146 = bitcast<f32>((bitcast<u32>(_e1114) & 2147483647u));
                                                                let _e1149 = bitcast<f32>((bitcast<u32>(_e1115) & 2147483647u));
                                                                let _e1151 = select(_e1149, _e1146, (_e1146 > _e1149));
                                                                let _e1154 = bitcast<f32>((bitcast<u32>(_e1116) & 2147483647u));
                                                                let _e1156 = select(_e1154, _e1151, (_e1151 > _e1154));
                                                                let _e1158 = select(_e1143, _e1130, (_e1130 > _e1143));
                                                                let _e1160 = select(_e1156, _e1158, (_e1158 > _e1156));
                                                                if (_e1130 == _e1160) {
                                                                    phi_1498_ = _e1113;
                                                                    phi_1499_ = _e1117;
                                                                } else {
                                                                    let _e1163 = vec3((_e1143 == _e1160));
                                                                    phi_1498_ = select(_e1109, _e1117, _e1163);
                                                                    phi_1499_ = select(_e1113, _e1109, _e1163);
                                                                }
                                                                let _e1167 = phi_1498_;
                                                                let _e1169 = phi_1499_;
                                                                let _e1176 = ((_e1167.y * _e1169.z) - (_e1169.y * _e1167.z));
                                                                let _e1181 = ((_e1167.z * _e1169.x) - (_e1169.z * _e1167.x));
                                                                let _e1184 = ((_e1167.x * _e1169.y) - (_e1169.x * _e1167.y));
                                                                if (_e1026 >= _e1030) {
                                                                    phi_1530_ = select(true, false, (_e1026 >= _e1034));
                                                                } else {
                                                                    phi_1530_ = true;
                                                                }
                                                                let _e1189 = phi_1530_;
                                                                if _e1189 {
                                                                    phi_1539_ = select(vec3<f32>(_e964[2][0], _e964[2][1], _e964[2][2]), vec3<f32>(_e964[1][0], _e964[1][1], _e964[1][2]), vec3((_e1030 >= _e1034)));
                                                                } else {
                                                                    phi_1539_ = vec3<f32>(_e964[0][0], _e964[0][1], _e964[0][2]);
                                                                }
                                                                let _e1194 = phi_1539_;
                                                                let _e1211 = ((((_e1176 * (_e1194.x - _e288)) + (_e1181 * (_e1194.y - _e327))) + (_e1184 * (_e1194.z - _e365))) / (((_e1176 * _e313) + (_e1181 * _e351)) + (_e1184 * _e389)));
                                                                let _e1213 = select(_e1093, _e1211, (_e1211 < _e1093));
                                                                let _e1215 = select(_e1085, _e1213, (_e1213 > _e1085));
                                                                if (_e1215 >= _e439) {
                                                                    let _e1217 = (_e1215 <= _e868.member_1);
                                                                    if _e1217 {
                                                                        let _e1218 = (1f / _e1036);
                                                                        phi_1579_ = type_22(_e1215, (_e1030 * _e1218), (_e1034 * _e1218), _e897);
                                                                    } else {
                                                                        phi_1579_ = type_22();
                                                                    }
                                                                    let _e1223 = phi_1579_;
                                                                    phi_1581_ = _e1223;
                                                                    phi_1582_ = select(true, false, _e1217);
                                                                } else {
                                                                    phi_1581_ = type_22();
                                                                    phi_1582_ = true;
                                                                }
                                                                let _e1226 = phi_1581_;
                                                                let _e1228 = phi_1582_;
                                                                if _e1228 {
                                                                    phi_1586_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1586_ = _e1226;
                                                                }
                                                                let _e1230 = phi_1586_;
                                                                phi_1587_ = _e1230;
                                                            }
                                                            let _e1232 = phi_1587_;
                                                            phi_1588_ = _e1232;
                                                            phi_1589_ = _e1102;
                                                        }
                                                        let _e1234 = phi_1588_;
                                                        let _e1236 = phi_1589_;
                                                        phi_1593_ = _e1234;
                                                        phi_1594_ = _e1236;
                                                    }
                                                    let _e1238 = phi_1593_;
                                                    let _e1240 = phi_1594_;
                                                    phi_1598_ = _e1238;
                                                    phi_1599_ = _e1240;
                                                } else {
                                                    phi_1598_ = type_22();
                                                    phi_1599_ = true;
                                                }
                                                let _e1242 = phi_1598_;
                                                let _e1244 = phi_1599_;
                                                if _e1244 {
                                                    phi_1603_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1603_ = _e1242;
                                                }
                                                let _e1246 = phi_1603_;
                                                if (_e1246.member_3 != 4294967295u) {
                                                    if (_e897 != 4294967295u) {
                                                        if (_e1246.member < _e868.member.member) {
                                                            phi_1629_ = true;
                                                        } else {
                                                            if (_e1246.member == _e868.member.member) {
                                                                phi_1628_ = (_e1246.member_3 < _e868.member.member_3);
                                                            } else {
                                                                phi_1628_ = false;
                                                            }
                                                            let _e1259 = phi_1628_;
                                                            phi_1629_ = _e1259;
                                                        }
                                                        let _e1261 = phi_1629_;
                                                        if _e1261 {
                                                            phi_1635_ = type_33(_e1246, _e1246.member);
                                                        } else {
                                                            phi_1635_ = _e868;
                                                        }
                                                        let _e1264 = phi_1635_;
                                                        phi_1636_ = _e1264;
                                                    } else {
                                                        phi_1636_ = _e868;
                                                    }
                                                    let _e1266 = phi_1636_;
                                                    phi_1637_ = _e1266;
                                                } else {
                                                    phi_1637_ = _e868;
                                                }
                                                let _e1268 = phi_1637_;
                                                phi_892_ = _e1268;
                                            } else {
                                                phi_892_ = type_33();
                                            }
                                            let _e1270 = phi_892_;
                                            continue;
                                            continuing {
                                                phi_891_ = _e1270;
                                                phi_894_ = _e883;
                                                phi_2698_ = _e471;
                                                break if !(_e889);
                                            }
                                        }
                                        let _e1273 = phi_2698_;
                                        phi_2812_ = _e1273;
                                        if _e1273 {
                                            break;
                                        }
                                        phi_2816_ = _e1273;
                                        let _e1441 = local_11;
                                        phi_2586_ = _e1441;
                                        phi_2587_ = _e512;
                                        phi_2588_ = false;
                                        phi_2589_ = _e516;
                                    } else {
                                        let _e525 = (_e512.member_1 < _e77);
                                        if _e525 {
                                            if _e525 {
                                            } else {
                                                phi_2812_ = true;
                                                break;
                                            }
                                            let _e527 = global_5.member[_e512.member_1];
                                            phi_1656_ = _e527;
                                        } else {
                                            phi_1656_ = type_42(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e529 = phi_1656_;
                                        let _e544 = ((10u * _e239) & 31u);
                                        let _e547 = ((_e529.member[0] >> bitcast<u32>(_e544)) & 1023u);
                                        let _e552 = bitcast<f32>((bitcast<u32>(((_e512.member.member_1[0] - _e512.member.member[0]) * 0.0009775171f)) ^ _e111));
                                        let _e558 = (_e512.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e547) * _e552)) ^ _e111)));
                                        let _e562 = select(select(_e512.member.member_1[0], _e558, (_e558 < _e512.member.member_1[0])), _e512.member.member_1[0], (_e547 == 1023u));
                                        let _e564 = ((10u * _e238) & 31u);
                                        let _e567 = ((_e529.member[0] >> bitcast<u32>(_e564)) & 1023u);
                                        let _e572 = bitcast<f32>((bitcast<u32>(((_e512.member.member_1[1] - _e512.member.member[1]) * 0.0009775171f)) ^ _e111));
                                        let _e578 = (_e512.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e567) * _e572)) ^ _e111)));
                                        let _e582 = select(select(_e512.member.member_1[1], _e578, (_e578 < _e512.member.member_1[1])), _e512.member.member_1[1], (_e567 == 1023u));
                                        let _e584 = ((10u * _e240) & 31u);
                                        let _e587 = ((_e529.member[0] >> bitcast<u32>(_e584)) & 1023u);
                                        let _e592 = bitcast<f32>((bitcast<u32>(((_e512.member.member_1[2] - _e512.member.member[2]) * 0.0009775171f)) ^ _e111));
                                        let _e598 = (_e512.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e587) * _e592)) ^ _e111)));
                                        let _e602 = select(select(_e512.member.member_1[2], _e598, (_e598 < _e512.member.member_1[2])), _e512.member.member_1[2], (_e587 == 1023u));
                                        let _e605 = ((_e529.member[1] >> bitcast<u32>(_e544)) & 1023u);
                                        let _e611 = (_e512.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e605) * _e552)) ^ _e111)));
                                        let _e615 = select(select(_e512.member.member_1[0], _e611, (_e611 < _e512.member.member_1[0])), _e512.member.member_1[0], (_e605 == 1023u));
                                        let _e618 = ((_e529.member[1] >> bitcast<u32>(_e564)) & 1023u);
                                        let _e624 = (_e512.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e618) * _e572)) ^ _e111)));
                                        let _e628 = select(select(_e512.member.member_1[1], _e624, (_e624 < _e512.member.member_1[1])), _e512.member.member_1[1], (_e618 == 1023u));
                                        let _e631 = ((_e529.member[1] >> bitcast<u32>(_e584)) & 1023u);
                                        let _e637 = (_e512.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e631) * _e592)) ^ _e111)));
                                        let _e641 = select(select(_e512.member.member_1[2], _e637, (_e637 < _e512.member.member_1[2])), _e512.member.member_1[2], (_e631 == 1023u));
                                        let _e647 = ((_e529.member_1[0] >> bitcast<u32>(_e544)) & 1023u);
                                        let _e653 = (_e512.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e647) * _e552)) ^ _e111)));
                                        let _e657 = select(select(_e512.member.member_1[0], _e653, (_e653 < _e512.member.member_1[0])), _e512.member.member_1[0], (_e647 == 1023u));
                                        let _e660 = ((_e529.member_1[0] >> bitcast<u32>(_e564)) & 1023u);
                                        let _e666 = (_e512.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e660) * _e572)) ^ _e111)));
                                        let _e670 = select(select(_e512.member.member_1[1], _e666, (_e666 < _e512.member.member_1[1])), _e512.member.member_1[1], (_e660 == 1023u));
                                        let _e673 = ((_e529.member_1[0] >> bitcast<u32>(_e584)) & 1023u);
                                        let _e679 = (_e512.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e673) * _e592)) ^ _e111)));
                                        let _e683 = select(select(_e512.member.member_1[2], _e679, (_e679 < _e512.member.member_1[2])), _e512.member.member_1[2], (_e673 == 1023u));
                                        let _e686 = ((_e529.member_1[1] >> bitcast<u32>(_e544)) & 1023u);
                                        let _e692 = (_e512.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e686) * _e552)) ^ _e111)));
                                        let _e696 = select(select(_e512.member.member_1[0], _e692, (_e692 < _e512.member.member_1[0])), _e512.member.member_1[0], (_e686 == 1023u));
                                        let _e699 = ((_e529.member_1[1] >> bitcast<u32>(_e564)) & 1023u);
                                        let _e705 = (_e512.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e699) * _e572)) ^ _e111)));
                                        let _e709 = select(select(_e512.member.member_1[1], _e705, (_e705 < _e512.member.member_1[1])), _e512.member.member_1[1], (_e699 == 1023u));
                                        let _e712 = ((_e529.member_1[1] >> bitcast<u32>(_e584)) & 1023u);
                                        let _e718 = (_e512.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e712) * _e592)) ^ _e111)));
                                        let _e722 = select(select(_e512.member.member_1[2], _e718, (_e718 < _e512.member.member_1[2])), _e512.member.member_1[2], (_e712 == 1023u));
                                        let _e727 = type_49(type_47(array<f32, 3>(_e562, _e582, _e602), array<f32, 3>(_e615, _e628, _e641)), _e529.member_2);
                                        let _e732 = type_49(type_47(array<f32, 3>(_e657, _e670, _e683), array<f32, 3>(_e696, _e709, _e722)), _e529.member_3);
                                        let _e738 = ((_e562 - _e311) * _e316);
                                        let _e739 = ((_e657 - _e311) * _e316);
                                        let _e740 = ((_e615 - _e312) * _e316);
                                        let _e741 = ((_e696 - _e312) * _e316);
                                        let _e746 = ((_e582 - _e349) * _e354);
                                        let _e747 = ((_e670 - _e349) * _e354);
                                        let _e748 = ((_e628 - _e350) * _e354);
                                        let _e749 = ((_e709 - _e350) * _e354);
                                        let _e754 = ((_e602 - _e387) * _e392);
                                        let _e755 = ((_e683 - _e387) * _e392);
                                        let _e756 = ((_e641 - _e388) * _e392);
                                        let _e757 = ((_e722 - _e388) * _e392);
                                        let _e759 = select(_e756, _e754, (_e754 < _e756));
                                        let _e761 = select(_e757, _e755, (_e755 < _e757));
                                        let _e763 = select(_e756, _e754, (_e754 > _e756));
                                        let _e765 = select(_e757, _e755, (_e755 > _e757));
                                        let _e767 = select(_e740, _e738, (_e738 < _e740));
                                        let _e769 = select(_e741, _e739, (_e739 < _e741));
                                        let _e771 = select(_e748, _e746, (_e746 < _e748));
                                        let _e773 = select(_e749, _e747, (_e747 < _e749));
                                        let _e775 = select(_e771, _e767, (_e767 > _e771));
                                        let _e777 = select(_e773, _e769, (_e769 > _e773));
                                        let _e779 = select(_e759, _e775, (_e775 > _e759));
                                        let _e781 = select(_e761, _e777, (_e777 > _e761));
                                        let _e783 = select(_e740, _e738, (_e738 > _e740));
                                        let _e785 = select(_e741, _e739, (_e739 > _e741));
                                        let _e787 = select(_e748, _e746, (_e746 > _e748));
                                        let _e789 = select(_e749, _e747, (_e747 > _e749));
                                        let _e791 = select(_e787, _e783, (_e783 < _e787));
                                        let _e793 = select(_e789, _e785, (_e785 < _e789));
                                        let _e798 = -(_e759);
                                        let _e799 = -(_e761);
                                        let _e806 = (select(_e763, _e791, (_e791 < _e763)) + (select(_e798, _e763, (_e763 > _e798)) * 0.0000019073523f));
                                        let _e807 = (select(_e765, _e793, (_e793 < _e765)) + (select(_e799, _e765, (_e765 > _e799)) * 0.0000019073523f));
                                        let _e809 = select(_e439, _e779, (_e779 > _e439));
                                        let _e811 = select(_e439, _e781, (_e781 > _e439));
                                        let _e816 = (_e809 <= select(_e473.member_1, _e806, (_e806 < _e473.member_1)));
                                        let _e817 = (_e811 <= select(_e473.member_1, _e807, (_e807 < _e473.member_1)));
                                        let _e818 = (_e809 <= _e811);
                                        if _e816 {
                                            if _e817 {
                                                if _e818 {
                                                    phi_2488_ = _e732;
                                                } else {
                                                    phi_2488_ = _e727;
                                                }
                                                let _e820 = phi_2488_;
                                                let _e828 = (_e516 % 128u);
                                                let _e829 = (_e828 < 128u);
                                                if _e829 {
                                                } else {
                                                    phi_2812_ = true;
                                                    break;
                                                }
                                                local_6[_e828] = _e820.member_1;
                                                if _e829 {
                                                } else {
                                                    phi_2812_ = true;
                                                    break;
                                                }
                                                local_5[_e828] = _e820.member.member[0];
                                                if _e829 {
                                                } else {
                                                    phi_2812_ = true;
                                                    break;
                                                }
                                                local_4[_e828] = _e820.member.member[1];
                                                if _e829 {
                                                } else {
                                                    phi_2812_ = true;
                                                    break;
                                                }
                                                local_3[_e828] = _e820.member.member[2];
                                                if _e829 {
                                                } else {
                                                    phi_2812_ = true;
                                                    break;
                                                }
                                                local_2[_e828] = _e820.member.member_1[0];
                                                if _e829 {
                                                } else {
                                                    phi_2812_ = true;
                                                    break;
                                                }
                                                local_1[_e828] = _e820.member.member_1[1];
                                                if _e829 {
                                                } else {
                                                    phi_2812_ = true;
                                                    break;
                                                }
                                                local[_e828] = _e820.member.member_1[2];
                                                if _e829 {
                                                } else {
                                                    phi_2812_ = true;
                                                    break;
                                                }
                                                local_7[_e828] = select(_e811, _e809, (_e809 > _e811));
                                                if _e818 {
                                                    phi_2565_ = _e727;
                                                } else {
                                                    phi_2565_ = _e732;
                                                }
                                                let _e846 = phi_2565_;
                                                phi_2566_ = _e846;
                                                phi_2567_ = (_e516 + 1u);
                                            } else {
                                                phi_2566_ = type_49();
                                                phi_2567_ = u32();
                                            }
                                            let _e848 = phi_2566_;
                                            let _e850 = phi_2567_;
                                            phi_2569_ = _e848;
                                            phi_2570_ = _e850;
                                            phi_2571_ = select(true, false, _e817);
                                        } else {
                                            phi_2569_ = type_49();
                                            phi_2570_ = u32();
                                            phi_2571_ = true;
                                        }
                                        let _e853 = phi_2569_;
                                        let _e855 = phi_2570_;
                                        let _e857 = phi_2571_;
                                        if _e857 {
                                            if _e816 {
                                                phi_2578_ = _e727;
                                            } else {
                                                phi_2578_ = _e732;
                                            }
                                            let _e859 = phi_2578_;
                                            phi_2583_ = _e859;
                                            phi_2584_ = select(_e817, true, _e816);
                                        } else {
                                            phi_2583_ = _e853;
                                            phi_2584_ = _e514;
                                        }
                                        let _e862 = phi_2583_;
                                        let _e864 = phi_2584_;
                                        phi_2816_ = _e471;
                                        phi_2586_ = _e473;
                                        phi_2587_ = _e862;
                                        phi_2588_ = _e864;
                                        phi_2589_ = select(_e855, _e516, _e857);
                                    }
                                    let _e1275 = phi_2816_;
                                    let _e1277 = phi_2586_;
                                    let _e1279 = phi_2587_;
                                    let _e1281 = phi_2588_;
                                    let _e1283 = phi_2589_;
                                    phi_2815_ = _e1275;
                                    phi_2590_ = _e1277;
                                    phi_2591_ = _e1279;
                                    phi_2592_ = (_e477 - 1u);
                                    phi_2593_ = _e1281;
                                    phi_2594_ = _e1283;
                                } else {
                                    phi_2815_ = _e471;
                                    phi_2590_ = _e473;
                                    phi_2591_ = _e512;
                                    phi_2592_ = _e477;
                                    phi_2593_ = _e514;
                                    phi_2594_ = _e516;
                                }
                                let _e1285 = phi_2815_;
                                let _e1287 = phi_2590_;
                                let _e1289 = phi_2591_;
                                let _e1291 = phi_2592_;
                                let _e1293 = phi_2593_;
                                let _e1295 = phi_2594_;
                                phi_2814_ = _e1285;
                                phi_2595_ = _e1287;
                                phi_2596_ = _e1289;
                                phi_2597_ = _e1291;
                                phi_2598_ = _e1293;
                                phi_2599_ = _e1295;
                            } else {
                                phi_2814_ = _e471;
                                phi_2595_ = type_33();
                                phi_2596_ = type_49();
                                phi_2597_ = u32();
                                phi_2598_ = bool();
                                phi_2599_ = u32();
                            }
                            let _e1297 = phi_2814_;
                            let _e1299 = phi_2595_;
                            let _e1301 = phi_2596_;
                            let _e1303 = phi_2597_;
                            let _e1305 = phi_2598_;
                            let _e1307 = phi_2599_;
                            phi_2813_ = _e1297;
                            phi_766_ = _e1299;
                            phi_769_ = _e1301;
                            phi_771_ = _e1303;
                            phi_773_ = _e1305;
                            phi_775_ = _e1307;
                            phi_2600_ = _e485;
                        } else {
                            phi_2813_ = _e471;
                            phi_766_ = type_33();
                            phi_769_ = type_49();
                            phi_771_ = u32();
                            phi_773_ = bool();
                            phi_775_ = u32();
                            phi_2600_ = false;
                        }
                        let _e1309 = phi_2813_;
                        let _e1311 = phi_766_;
                        let _e1313 = phi_769_;
                        let _e1315 = phi_771_;
                        let _e1317 = phi_773_;
                        let _e1319 = phi_775_;
                        let _e1321 = phi_2600_;
                        continue;
                        continuing {
                            phi_2704_ = _e1309;
                            phi_765_ = _e1311;
                            phi_768_ = _e1313;
                            phi_770_ = _e1315;
                            phi_772_ = _e1317;
                            phi_774_ = _e1319;
                            phi_2812_ = _e1309;
                            break if !(_e1321);
                        }
                    }
                    let _e1324 = phi_2812_;
                    if _e1324 {
                        break;
                    }
                    let _e1326 = local_10;
                    if (_e1326.member.member_3 != 4294967295u) {
                        let _e1331 = -(_e406);
                        let _e1332 = (_e1331 / 3i);
                        let _e1339 = bitcast<f32>((bitcast<u32>((_e1332 + 127i)) << bitcast<u32>(23i)));
                        let _e1347 = (((_e1326.member.member * _e1339) * _e1339) * bitcast<f32>((bitcast<u32>(((_e1331 - (2i * _e1332)) + 127i)) << bitcast<u32>(23i))));
                        let _e1349 = select(340282350000000000000000000000000000000f, _e1347, (_e1347 < 340282350000000000000000000000000000000f));
                        phi_2652_ = type_22(select(-340282350000000000000000000000000000000f, _e1349, (_e1349 > -340282350000000000000000000000000000000f)), _e1326.member.member_1, _e1326.member.member_2, _e1326.member.member_3);
                    } else {
                        phi_2652_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1356 = phi_2652_;
                    if _e127 {
                    } else {
                        break;
                    }
                    global_6.member[_e125] = _e1356;
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
