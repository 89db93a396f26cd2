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

struct type_24 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_25 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_28 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_36 {
    member: array<type_25>,
}

struct type_38 {
    member: f32,
    member_1: bool,
}

struct type_40 {
    member: array<vec4<u32>, 2>,
}

struct type_45 {
    member: type_28,
    member_1: u32,
}

struct type_46 {
    member: array<vec4<f32>, 3>,
    member_1: type_45,
    member_2: type_45,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_16;
@group(0) @binding(1) 
var<uniform> global_2: type_40;
@group(0) @binding(2) 
var<storage> global_3: type_13;
@group(0) @binding(4) 
var<storage> global_4: type_36;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_4;
@group(0) @binding(3) 
var<storage> global_6: type_4;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<f32, 128>;
    var local_7: array<f32, 128>;
    var local_8: array<u32, 128>;
    var local_9: array<f32, 128>;
    var phi_388_: i32;
    var phi_389_: i32;
    var phi_399_: bool;
    var phi_409_: u32;
    var phi_410_: u32;
    var phi_412_: bool;
    var phi_417_: u32;
    var phi_429_: i32;
    var phi_449_: i32;
    var phi_467_: f32;
    var phi_473_: f32;
    var phi_484_: f32;
    var phi_490_: f32;
    var phi_513_: f32;
    var phi_524_: f32;
    var phi_533_: f32;
    var phi_539_: f32;
    var phi_550_: f32;
    var phi_556_: f32;
    var phi_579_: f32;
    var phi_590_: f32;
    var phi_599_: f32;
    var phi_605_: f32;
    var phi_616_: f32;
    var phi_622_: f32;
    var phi_645_: f32;
    var phi_656_: f32;
    var phi_756_: f32;
    var phi_757_: f32;
    var phi_4012_: bool;
    var phi_846_: type_38;
    var phi_849_: type_45;
    var phi_851_: u32;
    var phi_853_: bool;
    var phi_855_: u32;
    var phi_866_: bool;
    var phi_952_: type_45;
    var phi_953_: bool;
    var phi_954_: u32;
    var phi_3045_: u32;
    var phi_3051_: u32;
    var phi_3305_: u32;
    var phi_3306_: u32;
    var phi_3316_: u32;
    var phi_3318_: u32;
    var phi_3319_: bool;
    var phi_3339_: u32;
    var phi_3340_: u32;
    var phi_3344_: type_46;
    var phi_3688_: type_45;
    var phi_3765_: type_45;
    var phi_3766_: type_45;
    var phi_3767_: u32;
    var phi_3769_: type_45;
    var phi_3770_: u32;
    var phi_3771_: bool;
    var phi_3780_: type_45;
    var phi_3785_: type_45;
    var phi_3786_: bool;
    var phi_973_: type_38;
    var phi_976_: type_8;
    var phi_977_: type_8;
    var phi_999_: type_8;
    var phi_1040_: u32;
    var phi_1046_: u32;
    var phi_1056_: u32;
    var phi_1072_: u32;
    var phi_1105_: u32;
    var phi_1111_: u32;
    var phi_1538_: u32;
    var phi_1556_: u32;
    var phi_1574_: u32;
    var phi_1594_: u32;
    var phi_1612_: u32;
    var phi_1630_: u32;
    var phi_1650_: u32;
    var phi_1668_: u32;
    var phi_1686_: u32;
    var phi_1264_: u32;
    var phi_1279_: u32;
    var phi_1289_: u32;
    var phi_1309_: u32;
    var phi_1329_: u32;
    var phi_1355_: u32;
    var phi_1370_: u32;
    var phi_1380_: u32;
    var phi_1400_: u32;
    var phi_1420_: u32;
    var phi_1446_: u32;
    var phi_1461_: u32;
    var phi_1471_: u32;
    var phi_1491_: u32;
    var phi_1511_: u32;
    var phi_1135_: u32;
    var phi_1178_: u32;
    var phi_1221_: u32;
    var phi_1692_: array<array<f32, 3>, 3>;
    var phi_1809_: bool;
    var phi_1838_: bool;
    var phi_2239_: f32;
    var phi_2240_: f32;
    var phi_2241_: f32;
    var phi_2242_: f32;
    var phi_2243_: vec3<f32>;
    var phi_2244_: vec3<f32>;
    var phi_2245_: vec3<f32>;
    var phi_2246_: vec3<f32>;
    var phi_2277_: bool;
    var phi_2286_: vec3<f32>;
    var phi_2453_: bool;
    var phi_2477_: f32;
    var phi_2478_: f32;
    var phi_2501_: type_24;
    var phi_2503_: type_24;
    var phi_2504_: bool;
    var phi_2508_: type_24;
    var phi_2509_: type_24;
    var phi_2510_: type_24;
    var phi_2511_: bool;
    var phi_2515_: type_24;
    var phi_2516_: bool;
    var phi_2517_: type_24;
    var phi_2518_: bool;
    var phi_2519_: bool;
    var phi_2520_: type_24;
    var phi_2521_: bool;
    var phi_2522_: bool;
    var phi_2530_: type_24;
    var phi_2531_: bool;
    var phi_2535_: type_24;
    var phi_2546_: type_38;
    var phi_2547_: type_38;
    var phi_974_: type_38;
    var phi_4006_: bool;
    var local_10: type_38;
    var phi_4196_: bool;
    var phi_3788_: type_38;
    var phi_3789_: type_45;
    var phi_3790_: bool;
    var phi_3791_: u32;
    var phi_4195_: bool;
    var phi_3792_: type_38;
    var phi_3793_: type_45;
    var phi_3794_: u32;
    var phi_3795_: bool;
    var phi_3796_: u32;
    var phi_4194_: bool;
    var phi_3797_: type_38;
    var phi_3798_: type_45;
    var phi_3799_: u32;
    var phi_3800_: bool;
    var phi_3801_: u32;
    var phi_4193_: bool;
    var phi_847_: type_38;
    var phi_850_: type_45;
    var phi_852_: u32;
    var phi_854_: bool;
    var phi_856_: u32;
    var phi_3802_: bool;
    var phi_4192_: bool;
    var local_11: type_38;
    var local_12: type_38;

    switch bitcast<i32>(0u) {
        default: {
            let _e90 = global;
            let _e92 = arrayLength((&global_3.member));
            let _e95 = arrayLength((&global_6.member));
            let _e103 = global_2.member[0u][0u];
            let _e107 = global_2.member[0u][1u];
            let _e111 = global_2.member[0u][2u];
            let _e115 = global_2.member[0u][3u];
            let _e119 = global_2.member[1u][0u];
            let _e123 = global_2.member[1u][1u];
            let _e127 = global_2.member[1u][2u];
            let _e130 = global_1.member[0u];
            let _e131 = bitcast<i32>(_e130);
            let _e143 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e115) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e103), bitcast<i32>(_e107), bitcast<i32>(_e111));
            local = array<i32, 3>(bitcast<i32>(_e119), bitcast<i32>(_e123), bitcast<i32>(_e127));
            let _e149 = (_e90.x + (_e90.y * 2097152u));
            let _e150 = (_e149 < arrayLength((&global_4.member)));
            if _e150 {
                let _e151 = (_e149 < arrayLength((&global_5.member)));
                if _e151 {
                    if _e150 {
                    } else {
                        break;
                    }
                    let _e159 = global_4.member[_e149].member_2[0u];
                    let _e161 = (bitcast<u32>(_e159) & 2147483647u);
                    let _e166 = global_4.member[_e149].member_2[1u];
                    let _e168 = (bitcast<u32>(_e166) & 2147483647u);
                    let _e173 = global_4.member[_e149].member_2[2u];
                    let _e175 = (bitcast<u32>(_e173) & 2147483647u);
                    let _e180 = global_4.member[_e149].member[0u];
                    let _e182 = (bitcast<u32>(_e180) & 2147483647u);
                    let _e187 = global_4.member[_e149].member[1u];
                    let _e189 = (bitcast<u32>(_e187) & 2147483647u);
                    let _e194 = global_4.member[_e149].member[2u];
                    let _e196 = (bitcast<u32>(_e194) & 2147483647u);
                    let _e198 = select(_e168, _e161, (_e168 < _e161));
                    let _e200 = select(_e175, _e198, (_e175 < _e198));
                    let _e202 = select(_e182, _e200, (_e182 < _e200));
                    let _e204 = select(_e189, _e202, (_e189 < _e202));
                    let _e206 = select(_e196, _e204, (_e196 < _e204));
                    let _e210 = global_4.member[_e149].member_1;
                    let _e212 = (bitcast<u32>(_e210) & 2147483647u);
                    let _e219 = global_4.member[_e149].member_3;
                    let _e225 = (((select(_e212, _e206, (_e212 < _e206)) < 2139095040u) && ((bitcast<u32>(_e219) & 2147483647u) <= 2139095040u)) && (_e200 > 0u));
                    if _e225 {
                        let _e228 = (bitcast<u32>(bitcast<f32>(_e200)) & 2147483647u);
                        if (_e228 >= 8388608u) {
                            phi_388_ = (bitcast<i32>((_e228 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_388_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e228)), 32u, (_e228 == 0u))));
                        }
                        let _e242 = phi_388_;
                        phi_389_ = _e242;
                    } else {
                        phi_389_ = 0i;
                    }
                    let _e244 = phi_389_;
                    let _e245 = (_e161 == _e200);
                    if _e245 {
                        phi_399_ = true;
                    } else {
                        phi_399_ = (_e168 == _e200);
                    }
                    let _e248 = phi_399_;
                    let _e249 = select(1u, 0u, _e245);
                    if _e248 {
                        let _e250 = (_e249 + 1u);
                        phi_409_ = _e250;
                        phi_410_ = _e250;
                        phi_412_ = select(true, false, (_e250 == 2u));
                    } else {
                        phi_409_ = u32();
                        phi_410_ = 0u;
                        phi_412_ = true;
                    }
                    let _e254 = phi_409_;
                    let _e256 = phi_410_;
                    let _e258 = phi_412_;
                    if _e258 {
                        phi_417_ = (_e256 + 1u);
                    } else {
                        phi_417_ = 0u;
                    }
                    let _e262 = phi_417_;
                    let _e263 = select(_e254, _e256, _e258);
                    let _e264 = select(_e249, select(2u, _e249, _e248), _e258);
                    if (_e131 < -126i) {
                        phi_429_ = -126i;
                    } else {
                        phi_429_ = select(_e131, 127i, (_e131 > 127i));
                    }
                    let _e269 = phi_429_;
                    let _e274 = bitcast<f32>((bitcast<u32>((_e269 + 127i)) << bitcast<u32>(23i)));
                    let _e280 = bitcast<f32>((bitcast<u32>(((_e131 - _e269) + 127i)) << bitcast<u32>(23i)));
                    let _e281 = -(_e244);
                    if (_e281 < -126i) {
                        phi_449_ = -126i;
                    } else {
                        phi_449_ = select(_e281, 127i, (_e281 > 127i));
                    }
                    let _e286 = phi_449_;
                    let _e291 = bitcast<f32>((bitcast<u32>((_e286 + 127i)) << bitcast<u32>(23i)));
                    let _e297 = bitcast<f32>((bitcast<u32>(((_e281 - _e286) + 127i)) << bitcast<u32>(23i)));
                    let _e301 = global_4.member[_e149].member;
                    let _e302 = (_e263 == 0u);
                    if _e302 {
                        phi_467_ = _e301[0];
                    } else {
                        phi_467_ = _e301[1];
                    }
                    let _e306 = phi_467_;
                    let _e307 = (_e263 == 2u);
                    if _e307 {
                        phi_473_ = _e301[2];
                    } else {
                        phi_473_ = _e306;
                    }
                    let _e310 = phi_473_;
                    let _e312 = ((_e310 * _e274) * _e280);
                    let _e313 = global_4.member[_e149].member_2;
                    if _e302 {
                        phi_484_ = _e313[0];
                    } else {
                        phi_484_ = _e313[1];
                    }
                    let _e317 = phi_484_;
                    if _e307 {
                        phi_490_ = _e313[2];
                    } else {
                        phi_490_ = _e317;
                    }
                    let _e320 = phi_490_;
                    let _e322 = ((_e320 * _e291) * _e297);
                    let _e326 = (bitcast<f32>((bitcast<u32>(_e322) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e326 {
                        let _e330 = (bitcast<f32>((bitcast<u32>(_e312) & 2147483647u)) * 0.00000011920929f);
                        phi_513_ = select(0.00000000000011368684f, _e330, (_e330 > 0.00000000000011368684f));
                    } else {
                        phi_513_ = 0f;
                    }
                    let _e334 = phi_513_;
                    let _e335 = (_e312 + _e334);
                    let _e336 = (_e312 - _e334);
                    let _e337 = select(_e322, 0f, _e326);
                    if _e326 {
                        phi_524_ = 38685626000000000000000000f;
                    } else {
                        phi_524_ = (1f / _e322);
                    }
                    let _e340 = phi_524_;
                    let _e341 = (_e262 == 0u);
                    if _e341 {
                        phi_533_ = _e301[0];
                    } else {
                        phi_533_ = _e301[1];
                    }
                    let _e345 = phi_533_;
                    let _e346 = (_e262 == 2u);
                    if _e346 {
                        phi_539_ = _e301[2];
                    } else {
                        phi_539_ = _e345;
                    }
                    let _e349 = phi_539_;
                    let _e351 = ((_e349 * _e274) * _e280);
                    if _e341 {
                        phi_550_ = _e313[0];
                    } else {
                        phi_550_ = _e313[1];
                    }
                    let _e355 = phi_550_;
                    if _e346 {
                        phi_556_ = _e313[2];
                    } else {
                        phi_556_ = _e355;
                    }
                    let _e358 = phi_556_;
                    let _e360 = ((_e358 * _e291) * _e297);
                    let _e364 = (bitcast<f32>((bitcast<u32>(_e360) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e364 {
                        let _e368 = (bitcast<f32>((bitcast<u32>(_e351) & 2147483647u)) * 0.00000011920929f);
                        phi_579_ = select(0.00000000000011368684f, _e368, (_e368 > 0.00000000000011368684f));
                    } else {
                        phi_579_ = 0f;
                    }
                    let _e372 = phi_579_;
                    let _e373 = (_e351 + _e372);
                    let _e374 = (_e351 - _e372);
                    let _e375 = select(_e360, 0f, _e364);
                    if _e364 {
                        phi_590_ = 38685626000000000000000000f;
                    } else {
                        phi_590_ = (1f / _e360);
                    }
                    let _e378 = phi_590_;
                    let _e379 = (_e264 == 0u);
                    if _e379 {
                        phi_599_ = _e301[0];
                    } else {
                        phi_599_ = _e301[1];
                    }
                    let _e383 = phi_599_;
                    let _e384 = (_e264 == 2u);
                    if _e384 {
                        phi_605_ = _e301[2];
                    } else {
                        phi_605_ = _e383;
                    }
                    let _e387 = phi_605_;
                    let _e389 = ((_e387 * _e274) * _e280);
                    if _e379 {
                        phi_616_ = _e313[0];
                    } else {
                        phi_616_ = _e313[1];
                    }
                    let _e393 = phi_616_;
                    if _e384 {
                        phi_622_ = _e313[2];
                    } else {
                        phi_622_ = _e393;
                    }
                    let _e396 = phi_622_;
                    let _e398 = ((_e396 * _e291) * _e297);
                    let _e402 = (bitcast<f32>((bitcast<u32>(_e398) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e402 {
                        let _e406 = (bitcast<f32>((bitcast<u32>(_e389) & 2147483647u)) * 0.00000011920929f);
                        phi_645_ = select(0.00000000000011368684f, _e406, (_e406 > 0.00000000000011368684f));
                    } else {
                        phi_645_ = 0f;
                    }
                    let _e410 = phi_645_;
                    let _e411 = (_e389 + _e410);
                    let _e412 = (_e389 - _e410);
                    let _e413 = select(_e398, 0f, _e402);
                    if _e402 {
                        phi_656_ = 38685626000000000000000000f;
                    } else {
                        phi_656_ = (1f / _e398);
                    }
                    let _e416 = phi_656_;
                    let _e419 = bitcast<f32>((bitcast<u32>(_e312) & 2147483647u));
                    let _e422 = bitcast<f32>((bitcast<u32>(_e351) & 2147483647u));
                    let _e424 = select(_e422, _e419, (_e419 > _e422));
                    let _e427 = bitcast<f32>((bitcast<u32>(_e389) & 2147483647u));
                    let _e430 = (_e131 + _e244);
                    if (_e225 && (select(_e427, _e424, (_e424 > _e427)) <= 1099511600000f)) {
                        let _e433 = (_e430 / 3i);
                        let _e440 = bitcast<f32>((bitcast<u32>((_e433 + 127i)) << bitcast<u32>(23i)));
                        let _e447 = bitcast<f32>((bitcast<u32>(((_e430 - (2i * _e433)) + 127i)) << bitcast<u32>(23i)));
                        let _e448 = (((_e210 * _e440) * _e440) * _e447);
                        let _e450 = select(340282350000000000000000000000000000000f, _e448, (_e448 < 340282350000000000000000000000000000000f));
                        let _e455 = (((_e219 * _e440) * _e440) * _e447);
                        let _e457 = select(340282350000000000000000000000000000000f, _e455, (_e455 < 340282350000000000000000000000000000000f));
                        phi_756_ = select(-340282350000000000000000000000000000000f, _e457, (_e457 > -340282350000000000000000000000000000000f));
                        phi_757_ = select(-340282350000000000000000000000000000000f, _e450, (_e450 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_756_ = 0f;
                        phi_757_ = 1f;
                    }
                    let _e461 = phi_756_;
                    let _e463 = phi_757_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e467 = (_e263 % 3u);
                    let _e468 = (_e467 < 3u);
                    if _e468 {
                    } else {
                        break;
                    }
                    let _e470 = local_1[_e467];
                    let _e473 = (_e262 % 3u);
                    let _e474 = (_e473 < 3u);
                    if _e474 {
                    } else {
                        break;
                    }
                    let _e476 = local_1[_e473];
                    let _e479 = (_e264 % 3u);
                    let _e480 = (_e479 < 3u);
                    if _e480 {
                    } else {
                        break;
                    }
                    let _e482 = local_1[_e479];
                    if _e468 {
                    } else {
                        break;
                    }
                    let _e487 = local[_e467];
                    if _e474 {
                    } else {
                        break;
                    }
                    let _e491 = local[_e473];
                    if _e480 {
                    } else {
                        break;
                    }
                    let _e495 = local[_e479];
                    phi_4012_ = false;
                    phi_846_ = type_38(_e461, false);
                    phi_849_ = type_45(type_28(vec4<f32>((f32(_e470) * _e143), (f32(_e476) * _e143), (f32(_e482) * _e143), 0f), vec4<f32>((f32(_e487) * _e143), (f32(_e491) * _e143), (f32(_e495) * _e143), 0f)), select(0u, 2147483648u, (_e92 == 0u)));
                    phi_851_ = ((3u * _e92) + 1u);
                    phi_853_ = (_e463 <= _e461);
                    phi_855_ = 0u;
                    loop {
                        let _e505 = phi_4012_;
                        let _e507 = phi_846_;
                        let _e509 = phi_849_;
                        let _e511 = phi_851_;
                        let _e513 = phi_853_;
                        let _e515 = phi_855_;
                        local_11 = _e507;
                        if _e513 {
                            phi_866_ = true;
                        } else {
                            phi_866_ = (_e515 > 0u);
                        }
                        let _e518 = phi_866_;
                        if _e518 {
                            let _e519 = (_e511 > 0u);
                            if _e519 {
                                if _e513 {
                                    phi_952_ = _e509;
                                    phi_953_ = _e513;
                                    phi_954_ = _e515;
                                } else {
                                    let _e520 = (_e515 - 1u);
                                    let _e521 = (_e520 % 128u);
                                    let _e522 = (_e521 < 128u);
                                    if _e522 {
                                    } else {
                                        phi_4192_ = true;
                                        break;
                                    }
                                    let _e524 = local_7[_e521];
                                    if _e522 {
                                    } else {
                                        phi_4192_ = true;
                                        break;
                                    }
                                    let _e526 = local_6[_e521];
                                    if _e522 {
                                    } else {
                                        phi_4192_ = true;
                                        break;
                                    }
                                    let _e528 = local_5[_e521];
                                    if _e522 {
                                    } else {
                                        phi_4192_ = true;
                                        break;
                                    }
                                    let _e530 = local_4[_e521];
                                    if _e522 {
                                    } else {
                                        phi_4192_ = true;
                                        break;
                                    }
                                    let _e532 = local_3[_e521];
                                    if _e522 {
                                    } else {
                                        phi_4192_ = true;
                                        break;
                                    }
                                    let _e534 = local_2[_e521];
                                    if _e522 {
                                    } else {
                                        phi_4192_ = true;
                                        break;
                                    }
                                    let _e539 = local_8[_e521];
                                    if _e522 {
                                    } else {
                                        phi_4192_ = true;
                                        break;
                                    }
                                    let _e542 = local_9[_e521];
                                    phi_952_ = type_45(type_28(vec4<f32>(_e524, _e526, _e528, 0f), vec4<f32>(_e530, _e532, _e534, 0f)), _e539);
                                    phi_953_ = (_e542 <= _e507.member);
                                    phi_954_ = _e520;
                                }
                                let _e546 = phi_952_;
                                let _e548 = phi_953_;
                                let _e550 = phi_954_;
                                if _e548 {
                                    let _e555 = (_e546.member_1 & 268435455u);
                                    if ((_e546.member_1 & 2147483648u) != 0u) {
                                        phi_973_ = _e507;
                                        phi_976_ = type_8(0u, ((_e546.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1015 = phi_973_;
                                            let _e1017 = phi_976_;
                                            local_10 = _e1015;
                                            local_12 = _e1015;
                                            if (_e1017.member < _e1017.member_1) {
                                                phi_977_ = type_8((_e1017.member + 1u), _e1017.member_1);
                                                phi_999_ = type_8(1u, _e1017.member);
                                            } else {
                                                phi_977_ = _e1017;
                                                phi_999_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1030 = phi_977_;
                                            let _e1032 = phi_999_;
                                            let _e1036 = (bitcast<i32>(_e1032.member) != 0i);
                                            if _e1036 {
                                                let _e1041 = (_e546.member.member_1.x - _e546.member.member.x);
                                                let _e1044 = (_e546.member.member_1.y - _e546.member.member.y);
                                                let _e1047 = (_e546.member.member_1.z - _e546.member.member.z);
                                                let _e1049 = select(_e1044, _e1041, (_e1041 > _e1044));
                                                let _e1051 = select(_e1047, _e1049, (_e1049 > _e1047));
                                                let _e1053 = (_e1051 < (1024f * _e143));
                                                if _e1053 {
                                                    phi_1040_ = 0u;
                                                } else {
                                                    phi_1040_ = select(2u, 1u, (_e1051 < (2097152f * _e143)));
                                                }
                                                let _e1058 = phi_1040_;
                                                switch bitcast<i32>(_e1058) {
                                                    case 0: {
                                                        phi_1046_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1046_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1046_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1046_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1061 = phi_1046_;
                                                switch bitcast<i32>(_e1058) {
                                                    case 0: {
                                                        phi_1056_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1056_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1056_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1056_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1068 = phi_1056_;
                                                let _e1070 = ((_e555 + (_e1032.member_1 * ((3u * _e1061) + 1u))) + (3u * _e1068));
                                                let _e1071 = (_e1070 < _e95);
                                                if _e1071 {
                                                    if _e1071 {
                                                    } else {
                                                        phi_4006_ = true;
                                                        break;
                                                    }
                                                    let _e1073 = global_6.member[_e1070];
                                                    phi_1072_ = _e1073;
                                                } else {
                                                    phi_1072_ = 4294967295u;
                                                }
                                                let _e1075 = phi_1072_;
                                                if _e1053 {
                                                    phi_1105_ = 0u;
                                                } else {
                                                    phi_1105_ = select(2u, 1u, (_e1051 < (2097152f * _e143)));
                                                }
                                                let _e1080 = phi_1105_;
                                                switch bitcast<i32>(_e1080) {
                                                    case 0: {
                                                        phi_1111_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1111_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1111_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1111_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1083 = phi_1111_;
                                                let _e1087 = (_e555 + (_e1032.member_1 * ((3u * _e1083) + 1u)));
                                                switch bitcast<i32>(_e1080) {
                                                    case 0: {
                                                        let _e1353 = (_e1087 < _e95);
                                                        if _e1353 {
                                                            if _e1353 {
                                                            } else {
                                                                phi_4006_ = true;
                                                                break;
                                                            }
                                                            let _e1355 = global_6.member[_e1087];
                                                            phi_1135_ = _e1355;
                                                        } else {
                                                            phi_1135_ = 0u;
                                                        }
                                                        let _e1357 = phi_1135_;
                                                        let _e1359 = ((10u * _e263) & 31u);
                                                        let _e1368 = ((10u * _e262) & 31u);
                                                        let _e1377 = ((10u * _e264) & 31u);
                                                        let _e1386 = (_e1087 + 1u);
                                                        let _e1387 = (_e1386 < _e95);
                                                        if _e1387 {
                                                            if _e1387 {
                                                            } else {
                                                                phi_4006_ = true;
                                                                break;
                                                            }
                                                            let _e1389 = global_6.member[_e1386];
                                                            phi_1178_ = _e1389;
                                                        } else {
                                                            phi_1178_ = 0u;
                                                        }
                                                        let _e1391 = phi_1178_;
                                                        let _e1414 = (_e1087 + 2u);
                                                        let _e1415 = (_e1414 < _e95);
                                                        if _e1415 {
                                                            if _e1415 {
                                                            } else {
                                                                phi_4006_ = true;
                                                                break;
                                                            }
                                                            let _e1417 = global_6.member[_e1414];
                                                            phi_1221_ = _e1417;
                                                        } else {
                                                            phi_1221_ = 0u;
                                                        }
                                                        let _e1419 = phi_1221_;
                                                        phi_1692_ = array<array<f32, 3>, 3>(array<f32, 3>((_e546.member.member.x + (f32(bitcast<i32>(((_e1357 >> bitcast<u32>(_e1359)) & 1023u))) * _e143)), (_e546.member.member.y + (f32(bitcast<i32>(((_e1357 >> bitcast<u32>(_e1368)) & 1023u))) * _e143)), (_e546.member.member.z + (f32(bitcast<i32>(((_e1357 >> bitcast<u32>(_e1377)) & 1023u))) * _e143))), array<f32, 3>((_e546.member.member.x + (f32(bitcast<i32>(((_e1391 >> bitcast<u32>(_e1359)) & 1023u))) * _e143)), (_e546.member.member.y + (f32(bitcast<i32>(((_e1391 >> bitcast<u32>(_e1368)) & 1023u))) * _e143)), (_e546.member.member.z + (f32(bitcast<i32>(((_e1391 >> bitcast<u32>(_e1377)) & 1023u))) * _e143))), array<f32, 3>((_e546.member.member.x + (f32(bitcast<i32>(((_e1419 >> bitcast<u32>(_e1359)) & 1023u))) * _e143)), (_e546.member.member.y + (f32(bitcast<i32>(((_e1419 >> bitcast<u32>(_e1368)) & 1023u))) * _e143)), (_e546.member.member.z + (f32(bitcast<i32>(((_e1419 >> bitcast<u32>(_e1377)) & 1023u))) * _e143))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1176 = (_e1087 < _e95);
                                                        if _e1176 {
                                                            if _e1176 {
                                                            } else {
                                                                phi_4006_ = true;
                                                                break;
                                                            }
                                                            let _e1178 = global_6.member[_e1087];
                                                            phi_1264_ = _e1178;
                                                        } else {
                                                            phi_1264_ = 0u;
                                                        }
                                                        let _e1180 = phi_1264_;
                                                        let _e1181 = (_e1087 + 1u);
                                                        let _e1182 = (_e1181 < _e95);
                                                        if _e1182 {
                                                            if _e1182 {
                                                            } else {
                                                                phi_4006_ = true;
                                                                break;
                                                            }
                                                            let _e1184 = global_6.member[_e1181];
                                                            phi_1279_ = _e1184;
                                                        } else {
                                                            phi_1279_ = 0u;
                                                        }
                                                        let _e1186 = phi_1279_;
                                                        let _e1187 = (_e263 == 1u);
                                                        if _e1187 {
                                                            phi_1289_ = ((_e1180 >> bitcast<u32>(21i)) | (_e1186 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1289_ = (_e1186 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1196 = phi_1289_;
                                                        let _e1203 = (_e262 == 1u);
                                                        if _e1203 {
                                                            phi_1309_ = ((_e1180 >> bitcast<u32>(21i)) | (_e1186 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1309_ = (_e1186 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1212 = phi_1309_;
                                                        let _e1219 = (_e264 == 1u);
                                                        if _e1219 {
                                                            phi_1329_ = ((_e1180 >> bitcast<u32>(21i)) | (_e1186 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1329_ = (_e1186 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1228 = phi_1329_;
                                                        let _e1236 = (_e1087 + 2u);
                                                        let _e1237 = (_e1236 < _e95);
                                                        if _e1237 {
                                                            if _e1237 {
                                                            } else {
                                                                phi_4006_ = true;
                                                                break;
                                                            }
                                                            let _e1239 = global_6.member[_e1236];
                                                            phi_1355_ = _e1239;
                                                        } else {
                                                            phi_1355_ = 0u;
                                                        }
                                                        let _e1241 = phi_1355_;
                                                        let _e1242 = (_e1087 + 3u);
                                                        let _e1243 = (_e1242 < _e95);
                                                        if _e1243 {
                                                            if _e1243 {
                                                            } else {
                                                                phi_4006_ = true;
                                                                break;
                                                            }
                                                            let _e1245 = global_6.member[_e1242];
                                                            phi_1370_ = _e1245;
                                                        } else {
                                                            phi_1370_ = 0u;
                                                        }
                                                        let _e1247 = phi_1370_;
                                                        if _e1187 {
                                                            phi_1380_ = ((_e1241 >> bitcast<u32>(21i)) | (_e1247 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1380_ = (_e1247 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1256 = phi_1380_;
                                                        if _e1203 {
                                                            phi_1400_ = ((_e1241 >> bitcast<u32>(21i)) | (_e1247 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1400_ = (_e1247 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1271 = phi_1400_;
                                                        if _e1219 {
                                                            phi_1420_ = ((_e1241 >> bitcast<u32>(21i)) | (_e1247 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1420_ = (_e1247 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1286 = phi_1420_;
                                                        let _e1294 = (_e1087 + 4u);
                                                        let _e1295 = (_e1294 < _e95);
                                                        if _e1295 {
                                                            if _e1295 {
                                                            } else {
                                                                phi_4006_ = true;
                                                                break;
                                                            }
                                                            let _e1297 = global_6.member[_e1294];
                                                            phi_1446_ = _e1297;
                                                        } else {
                                                            phi_1446_ = 0u;
                                                        }
                                                        let _e1299 = phi_1446_;
                                                        let _e1300 = (_e1087 + 5u);
                                                        let _e1301 = (_e1300 < _e95);
                                                        if _e1301 {
                                                            if _e1301 {
                                                            } else {
                                                                phi_4006_ = true;
                                                                break;
                                                            }
                                                            let _e1303 = global_6.member[_e1300];
                                                            phi_1461_ = _e1303;
                                                        } else {
                                                            phi_1461_ = 0u;
                                                        }
                                                        let _e1305 = phi_1461_;
                                                        if _e1187 {
                                                            phi_1471_ = ((_e1299 >> bitcast<u32>(21i)) | (_e1305 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1471_ = (_e1305 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1314 = phi_1471_;
                                                        if _e1203 {
                                                            phi_1491_ = ((_e1299 >> bitcast<u32>(21i)) | (_e1305 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1491_ = (_e1305 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1329 = phi_1491_;
                                                        if _e1219 {
                                                            phi_1511_ = ((_e1299 >> bitcast<u32>(21i)) | (_e1305 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1511_ = (_e1305 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1344 = phi_1511_;
                                                        phi_1692_ = array<array<f32, 3>, 3>(array<f32, 3>((_e546.member.member.x + (f32(bitcast<i32>((select(_e1196, _e1180, _e302) & 2097151u))) * _e143)), (_e546.member.member.y + (f32(bitcast<i32>((select(_e1212, _e1180, _e341) & 2097151u))) * _e143)), (_e546.member.member.z + (f32(bitcast<i32>((select(_e1228, _e1180, _e379) & 2097151u))) * _e143))), array<f32, 3>((_e546.member.member.x + (f32(bitcast<i32>((select(_e1256, _e1241, _e302) & 2097151u))) * _e143)), (_e546.member.member.y + (f32(bitcast<i32>((select(_e1271, _e1241, _e341) & 2097151u))) * _e143)), (_e546.member.member.z + (f32(bitcast<i32>((select(_e1286, _e1241, _e379) & 2097151u))) * _e143))), array<f32, 3>((_e546.member.member.x + (f32(bitcast<i32>((select(_e1314, _e1299, _e302) & 2097151u))) * _e143)), (_e546.member.member.y + (f32(bitcast<i32>((select(_e1329, _e1299, _e341) & 2097151u))) * _e143)), (_e546.member.member.z + (f32(bitcast<i32>((select(_e1344, _e1299, _e379) & 2097151u))) * _e143))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1089 = (_e1087 + _e263);
                                                        let _e1090 = (_e1089 < _e95);
                                                        if _e1090 {
                                                            if _e1090 {
                                                            } else {
                                                                phi_4006_ = true;
                                                                break;
                                                            }
                                                            let _e1092 = global_6.member[_e1089];
                                                            phi_1538_ = _e1092;
                                                        } else {
                                                            phi_1538_ = 0u;
                                                        }
                                                        let _e1094 = phi_1538_;
                                                        let _e1098 = (_e1087 + _e262);
                                                        let _e1099 = (_e1098 < _e95);
                                                        if _e1099 {
                                                            if _e1099 {
                                                            } else {
                                                                phi_4006_ = true;
                                                                break;
                                                            }
                                                            let _e1101 = global_6.member[_e1098];
                                                            phi_1556_ = _e1101;
                                                        } else {
                                                            phi_1556_ = 0u;
                                                        }
                                                        let _e1103 = phi_1556_;
                                                        let _e1107 = (_e1087 + _e264);
                                                        let _e1108 = (_e1107 < _e95);
                                                        if _e1108 {
                                                            if _e1108 {
                                                            } else {
                                                                phi_4006_ = true;
                                                                break;
                                                            }
                                                            let _e1110 = global_6.member[_e1107];
                                                            phi_1574_ = _e1110;
                                                        } else {
                                                            phi_1574_ = 0u;
                                                        }
                                                        let _e1112 = phi_1574_;
                                                        let _e1117 = (_e1087 + 3u);
                                                        let _e1118 = (_e1117 + _e263);
                                                        let _e1119 = (_e1118 < _e95);
                                                        if _e1119 {
                                                            if _e1119 {
                                                            } else {
                                                                phi_4006_ = true;
                                                                break;
                                                            }
                                                            let _e1121 = global_6.member[_e1118];
                                                            phi_1594_ = _e1121;
                                                        } else {
                                                            phi_1594_ = 0u;
                                                        }
                                                        let _e1123 = phi_1594_;
                                                        let _e1127 = (_e1117 + _e262);
                                                        let _e1128 = (_e1127 < _e95);
                                                        if _e1128 {
                                                            if _e1128 {
                                                            } else {
                                                                phi_4006_ = true;
                                                                break;
                                                            }
                                                            let _e1130 = global_6.member[_e1127];
                                                            phi_1612_ = _e1130;
                                                        } else {
                                                            phi_1612_ = 0u;
                                                        }
                                                        let _e1132 = phi_1612_;
                                                        let _e1136 = (_e1117 + _e264);
                                                        let _e1137 = (_e1136 < _e95);
                                                        if _e1137 {
                                                            if _e1137 {
                                                            } else {
                                                                phi_4006_ = true;
                                                                break;
                                                            }
                                                            let _e1139 = global_6.member[_e1136];
                                                            phi_1630_ = _e1139;
                                                        } else {
                                                            phi_1630_ = 0u;
                                                        }
                                                        let _e1141 = phi_1630_;
                                                        let _e1146 = (_e1087 + 6u);
                                                        let _e1147 = (_e1146 + _e263);
                                                        let _e1148 = (_e1147 < _e95);
                                                        if _e1148 {
                                                            if _e1148 {
                                                            } else {
                                                                phi_4006_ = true;
                                                                break;
                                                            }
                                                            let _e1150 = global_6.member[_e1147];
                                                            phi_1650_ = _e1150;
                                                        } else {
                                                            phi_1650_ = 0u;
                                                        }
                                                        let _e1152 = phi_1650_;
                                                        let _e1156 = (_e1146 + _e262);
                                                        let _e1157 = (_e1156 < _e95);
                                                        if _e1157 {
                                                            if _e1157 {
                                                            } else {
                                                                phi_4006_ = true;
                                                                break;
                                                            }
                                                            let _e1159 = global_6.member[_e1156];
                                                            phi_1668_ = _e1159;
                                                        } else {
                                                            phi_1668_ = 0u;
                                                        }
                                                        let _e1161 = phi_1668_;
                                                        let _e1165 = (_e1146 + _e264);
                                                        let _e1166 = (_e1165 < _e95);
                                                        if _e1166 {
                                                            if _e1166 {
                                                            } else {
                                                                phi_4006_ = true;
                                                                break;
                                                            }
                                                            let _e1168 = global_6.member[_e1165];
                                                            phi_1686_ = _e1168;
                                                        } else {
                                                            phi_1686_ = 0u;
                                                        }
                                                        let _e1170 = phi_1686_;
                                                        phi_1692_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1094)) * _e143), (f32(bitcast<i32>(_e1103)) * _e143), (f32(bitcast<i32>(_e1112)) * _e143)), array<f32, 3>((f32(bitcast<i32>(_e1123)) * _e143), (f32(bitcast<i32>(_e1132)) * _e143), (f32(bitcast<i32>(_e1141)) * _e143)), array<f32, 3>((f32(bitcast<i32>(_e1152)) * _e143), (f32(bitcast<i32>(_e1161)) * _e143), (f32(bitcast<i32>(_e1170)) * _e143)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1692_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1444 = phi_1692_;
                                                let _e1452 = (_e1444[0][2] - _e389);
                                                let _e1455 = (((_e1444[0][0] - _e312) * _e413) - (_e1452 * _e337));
                                                let _e1458 = (((_e1444[0][1] - _e351) * _e413) - (_e1452 * _e375));
                                                let _e1465 = (_e1444[1][2] - _e389);
                                                let _e1468 = (((_e1444[1][0] - _e312) * _e413) - (_e1465 * _e337));
                                                let _e1471 = (((_e1444[1][1] - _e351) * _e413) - (_e1465 * _e375));
                                                let _e1478 = (_e1444[2][2] - _e389);
                                                let _e1481 = (((_e1444[2][0] - _e312) * _e413) - (_e1478 * _e337));
                                                let _e1484 = (((_e1444[2][1] - _e351) * _e413) - (_e1478 * _e375));
                                                let _e1485 = (_e1481 * _e1471);
                                                let _e1486 = (_e1484 * _e1468);
                                                let _e1487 = (_e1455 * _e1484);
                                                let _e1488 = (_e1458 * _e1481);
                                                let _e1489 = (_e1468 * _e1458);
                                                let _e1490 = (_e1471 * _e1455);
                                                let _e1495 = (((_e1485 >= _e1486) && (_e1487 >= _e1488)) && (_e1489 >= _e1490));
                                                if (_e1495 || (((_e1485 <= _e1486) && (_e1487 <= _e1488)) && (_e1489 <= _e1490))) {
                                                    let _e1502 = select(-1f, 1f, _e1495);
                                                    let _e1504 = ((_e1485 - _e1486) * _e1502);
                                                    let _e1506 = select(0f, _e1504, (_e1504 > 0f));
                                                    let _e1508 = ((_e1487 - _e1488) * _e1502);
                                                    let _e1510 = select(0f, _e1508, (_e1508 > 0f));
                                                    let _e1512 = ((_e1489 - _e1490) * _e1502);
                                                    let _e1514 = select(0f, _e1512, (_e1512 > 0f));
                                                    let _e1516 = ((_e1506 + _e1510) + _e1514);
                                                    if (_e1516 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2520_ = type_24();
                                                        phi_2521_ = true;
                                                        phi_2522_ = false;
                                                    } else {
                                                        let _e1519 = select(_e1468, _e1455, (_e1455 < _e1468));
                                                        if (select(_e1481, _e1519, (_e1519 < _e1481)) > 0f) {
                                                            phi_1809_ = true;
                                                        } else {
                                                            let _e1524 = select(_e1468, _e1455, (_e1455 > _e1468));
                                                            phi_1809_ = (select(_e1481, _e1524, (_e1524 > _e1481)) < 0f);
                                                        }
                                                        let _e1529 = phi_1809_;
                                                        if _e1529 {
                                                            phi_2517_ = type_24();
                                                            phi_2518_ = true;
                                                            phi_2519_ = false;
                                                        } else {
                                                            let _e1531 = select(_e1471, _e1458, (_e1458 < _e1471));
                                                            if (select(_e1484, _e1531, (_e1531 < _e1484)) > 0f) {
                                                                phi_1838_ = true;
                                                            } else {
                                                                let _e1536 = select(_e1471, _e1458, (_e1458 > _e1471));
                                                                phi_1838_ = (select(_e1484, _e1536, (_e1536 > _e1484)) < 0f);
                                                            }
                                                            let _e1541 = phi_1838_;
                                                            if _e1541 {
                                                                phi_2515_ = type_24();
                                                                phi_2516_ = false;
                                                            } else {
                                                                let _e1543 = select(_e1444[1][0], _e1444[0][0], (_e1444[0][0] < _e1444[1][0]));
                                                                let _e1547 = select(_e1444[1][0], _e1444[0][0], (_e1444[0][0] > _e1444[1][0]));
                                                                let _e1551 = select(_e1444[1][1], _e1444[0][1], (_e1444[0][1] < _e1444[1][1]));
                                                                let _e1555 = select(_e1444[1][1], _e1444[0][1], (_e1444[0][1] > _e1444[1][1]));
                                                                let _e1559 = select(_e1444[1][2], _e1444[0][2], (_e1444[0][2] < _e1444[1][2]));
                                                                let _e1563 = select(_e1444[1][2], _e1444[0][2], (_e1444[0][2] > _e1444[1][2]));
                                                                let _e1568 = ((select(_e1444[2][0], _e1543, (_e1543 < _e1444[2][0])) - _e335) * _e340);
                                                                let _e1569 = ((select(_e1444[2][0], _e1547, (_e1547 > _e1444[2][0])) - _e336) * _e340);
                                                                let _e1572 = ((select(_e1444[2][1], _e1551, (_e1551 < _e1444[2][1])) - _e373) * _e378);
                                                                let _e1573 = ((select(_e1444[2][1], _e1555, (_e1555 > _e1444[2][1])) - _e374) * _e378);
                                                                let _e1576 = ((select(_e1444[2][2], _e1559, (_e1559 < _e1444[2][2])) - _e411) * _e416);
                                                                let _e1577 = ((select(_e1444[2][2], _e1563, (_e1563 > _e1444[2][2])) - _e412) * _e416);
                                                                let _e1579 = select(_e1577, _e1576, (_e1576 < _e1577));
                                                                let _e1581 = select(_e1577, _e1576, (_e1576 > _e1577));
                                                                let _e1583 = select(_e1569, _e1568, (_e1568 < _e1569));
                                                                let _e1585 = select(_e1573, _e1572, (_e1572 < _e1573));
                                                                let _e1587 = select(_e1585, _e1583, (_e1583 > _e1585));
                                                                let _e1589 = select(_e1579, _e1587, (_e1587 > _e1579));
                                                                let _e1591 = select(_e1569, _e1568, (_e1568 > _e1569));
                                                                let _e1593 = select(_e1573, _e1572, (_e1572 > _e1573));
                                                                let _e1595 = select(_e1593, _e1591, (_e1591 < _e1593));
                                                                let _e1597 = select(_e1581, _e1595, (_e1595 < _e1581));
                                                                let _e1598 = -(_e1579);
                                                                let _e1604 = select(_e463, _e1589, (_e1589 > _e463));
                                                                if (_e1604 > (_e1597 + (select(_e1598, _e1581, (_e1581 > _e1598)) * 0.0000019073523f))) {
                                                                    phi_2510_ = type_24();
                                                                    phi_2511_ = true;
                                                                } else {
                                                                    let _e1606 = (_e1604 > _e1015.member);
                                                                    if _e1606 {
                                                                        phi_2509_ = type_24();
                                                                    } else {
                                                                        let _e1607 = vec3<f32>(_e1444[0][0], _e1444[0][1], _e1444[0][2]);
                                                                        let _e1608 = vec3<f32>(_e1444[1][0], _e1444[1][1], _e1444[1][2]);
                                                                        let _e1609 = vec3<f32>(_e1444[2][0], _e1444[2][1], _e1444[2][2]);
                                                                        let _e1610 = (_e1444[1][0] - _e1444[0][0]);
                                                                        let _e1611 = (_e1444[1][1] - _e1444[0][1]);
                                                                        let _e1612 = (_e1444[1][2] - _e1444[0][2]);
                                                                        let _e1613 = vec3<f32>(_e1610, _e1611, _e1612);
                                                                        let _e1614 = (_e1444[2][0] - _e1444[1][0]);
                                                                        let _e1615 = (_e1444[2][1] - _e1444[1][1]);
                                                                        let _e1616 = (_e1444[2][2] - _e1444[1][2]);
                                                                        let _e1617 = vec3<f32>(_e1614, _e1615, _e1616);
                                                                        let _e1618 = (_e1444[0][0] - _e1444[2][0]);
                                                                        let _e1619 = (_e1444[0][1] - _e1444[2][1]);
                                                                        let _e1620 = (_e1444[0][2] - _e1444[2][2]);
                                                                        let _e1621 = vec3<f32>(_e1618, _e1619, _e1620);
                                                                        let _e1624 = bitcast<f32>((bitcast<u32>(_e1610) & 2147483647u));
                                                                        let _e1627 = bitcast<f32>((bitcast<u32>(_e1611) & 2147483647u));
                                                                        let _e1629 = select(_e1627, _e1624, (_e1624 > _e1627));
                                                                        let _e1632 = bitcast<f32>((bitcast<u32>(_e1612) & 2147483647u));
                                                                        let _e1634 = select(_e1632, _e1629, (_e1629 > _e1632));
                                                                        let _e1637 = bitcast<f32>((bitcast<u32>(_e1614) & 2147483647u));
                                                                        let _e1640 = bitcast<f32>((bitcast<u32>(_e1615) & 2147483647u));
                                                                        let _e1642 = select(_e1640, _e1637, (_e1637 > _e1640));
                                                                        let _e1645 = bitcast<f32>((bitcast<u32>(_e1616) & 2147483647u));
                                                                        let _e1647 = select(_e1645, _e1642, (_e1642 > _e1645));
                                                                        let _e1650 = bitcast<f32>((bitcast<u32>(_e1618) & 2147483647u));
                                                                        let _e1653 = bitcast<f32>((bitcast<u32>(_e1619) & 2147483647u));
                                                                        let _e1655 = select(_e1653, _e1650, (_e1650 > _e1653));
                                                                        let _e1658 = bitcast<f32>((bitcast<u32>(_e1620) & 2147483647u));
                                                                        let _e1660 = select(_e1658, _e1655, (_e1655 > _e1658));
                                                                        let _e1662 = select(_e1647, _e1634, (_e1634 > _e1647));
                                                                        let _e1664 = select(_e1660, _e1662, (_e1662 > _e1660));
                                                                        if (_e1634 == _e1664) {
                                                                            phi_2239_ = _e1471;
                                                                            phi_2240_ = _e1468;
                                                                            phi_2241_ = _e1458;
                                                                            phi_2242_ = _e1455;
                                                                            phi_2243_ = _e1607;
                                                                            phi_2244_ = _e1621;
                                                                            phi_2245_ = _e1617;
                                                                            phi_2246_ = _e1613;
                                                                        } else {
                                                                            let _e1666 = (_e1647 == _e1664);
                                                                            let _e1671 = vec3(_e1666);
                                                                            phi_2239_ = select(_e1458, _e1484, _e1666);
                                                                            phi_2240_ = select(_e1455, _e1481, _e1666);
                                                                            phi_2241_ = select(_e1484, _e1471, _e1666);
                                                                            phi_2242_ = select(_e1481, _e1468, _e1666);
                                                                            phi_2243_ = select(_e1609, _e1608, _e1671);
                                                                            phi_2244_ = select(_e1617, _e1613, _e1671);
                                                                            phi_2245_ = select(_e1613, _e1621, _e1671);
                                                                            phi_2246_ = select(_e1621, _e1617, _e1671);
                                                                        }
                                                                        let _e1677 = phi_2239_;
                                                                        let _e1679 = phi_2240_;
                                                                        let _e1681 = phi_2241_;
                                                                        let _e1683 = phi_2242_;
                                                                        let _e1685 = phi_2243_;
                                                                        let _e1687 = phi_2244_;
                                                                        let _e1689 = phi_2245_;
                                                                        let _e1691 = phi_2246_;
                                                                        let _e1698 = ((_e1689.y * _e1687.z) - (_e1687.y * _e1689.z));
                                                                        let _e1703 = ((_e1689.z * _e1687.x) - (_e1687.z * _e1689.x));
                                                                        let _e1706 = ((_e1689.x * _e1687.y) - (_e1687.x * _e1689.y));
                                                                        if (_e1506 >= _e1510) {
                                                                            phi_2277_ = select(true, false, (_e1506 >= _e1514));
                                                                        } else {
                                                                            phi_2277_ = true;
                                                                        }
                                                                        let _e1711 = phi_2277_;
                                                                        if _e1711 {
                                                                            phi_2286_ = select(_e1609, _e1608, vec3((_e1510 >= _e1514)));
                                                                        } else {
                                                                            phi_2286_ = _e1607;
                                                                        }
                                                                        let _e1716 = phi_2286_;
                                                                        let _e1721 = (((_e1698 * _e337) + (_e1703 * _e375)) + (_e1706 * _e413));
                                                                        let _e1732 = (((_e1698 * (_e1716.x - _e312)) + (_e1703 * (_e1716.y - _e351))) + (_e1706 * (_e1716.z - _e389)));
                                                                        let _e1734 = (_e1679 - _e1683);
                                                                        let _e1735 = (_e1677 - _e1681);
                                                                        let _e1743 = (-(((_e1683 * _e1734) + (_e1681 * _e1735))) / ((_e1734 * _e1734) + (_e1735 * _e1735)));
                                                                        let _e1745 = select(1f, _e1743, (_e1743 < 1f));
                                                                        let _e1747 = select(0f, _e1745, (_e1745 > 0f));
                                                                        let _e1760 = ((_e1685.x + (_e1691.x * _e1747)) - _e312);
                                                                        let _e1761 = ((_e1685.y + (_e1691.y * _e1747)) - _e351);
                                                                        let _e1762 = ((_e1685.z + (_e1691.z * _e1747)) - _e389);
                                                                        let _e1763 = (_e1762 / _e413);
                                                                        let _e1775 = bitcast<f32>((bitcast<u32>(_e1760) & 2147483647u));
                                                                        let _e1778 = bitcast<f32>((bitcast<u32>(_e1761) & 2147483647u));
                                                                        let _e1780 = select(_e1778, _e1775, (_e1775 > _e1778));
                                                                        let _e1783 = bitcast<f32>((bitcast<u32>(_e1762) & 2147483647u));
                                                                        let _e1785 = select(_e1783, _e1780, (_e1780 > _e1783));
                                                                        let _e1791 = bitcast<f32>((bitcast<u32>(_e1698) & 2147483647u));
                                                                        let _e1794 = bitcast<f32>((bitcast<u32>(_e1703) & 2147483647u));
                                                                        let _e1796 = select(_e1794, _e1791, (_e1791 > _e1794));
                                                                        let _e1799 = bitcast<f32>((bitcast<u32>(_e1706) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1698 * _e1760) + (_e1703 * _e1761)) + (_e1706 * _e1762)) - _e1732)) & 2147483647u)) <= ((0.0000009536743f * select(_e1664, _e1785, (_e1785 > _e1664))) * select(_e1799, _e1796, (_e1796 > _e1799)))) {
                                                                            let _e1809 = bitcast<f32>((bitcast<u32>(_e1689.x) & 2147483647u));
                                                                            let _e1812 = bitcast<f32>((bitcast<u32>(_e1689.y) & 2147483647u));
                                                                            let _e1814 = select(_e1812, _e1809, (_e1809 > _e1812));
                                                                            let _e1817 = bitcast<f32>((bitcast<u32>(_e1689.z) & 2147483647u));
                                                                            let _e1823 = bitcast<f32>((bitcast<u32>(_e1687.x) & 2147483647u));
                                                                            let _e1826 = bitcast<f32>((bitcast<u32>(_e1687.y) & 2147483647u));
                                                                            let _e1828 = select(_e1826, _e1823, (_e1823 > _e1826));
                                                                            let _e1831 = bitcast<f32>((bitcast<u32>(_e1687.z) & 2147483647u));
                                                                            phi_2453_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e1721) & 2147483647u)) > ((0.0000038146973f * select(_e1817, _e1814, (_e1814 > _e1817))) * select(_e1831, _e1828, (_e1828 > _e1831)))));
                                                                        } else {
                                                                            phi_2453_ = true;
                                                                        }
                                                                        let _e1838 = phi_2453_;
                                                                        if _e1838 {
                                                                            let _e1849 = ((((_e1698 * (_e1760 - (_e337 * _e1763))) + (_e1703 * (_e1761 - (_e375 * _e1763)))) + (_e1706 * (_e1762 - _e1762))) / _e1721);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1849) & 2147483647u)) <= _e1664) {
                                                                                phi_2477_ = (_e1763 + _e1849);
                                                                            } else {
                                                                                phi_2477_ = _e1763;
                                                                            }
                                                                            let _e1856 = phi_2477_;
                                                                            phi_2478_ = _e1856;
                                                                        } else {
                                                                            phi_2478_ = (_e1732 / _e1721);
                                                                        }
                                                                        let _e1858 = phi_2478_;
                                                                        let _e1860 = select(_e1597, _e1858, (_e1858 < _e1597));
                                                                        let _e1862 = select(_e1589, _e1860, (_e1860 > _e1589));
                                                                        if (_e1862 >= _e463) {
                                                                            let _e1864 = (_e1862 <= _e1015.member);
                                                                            if _e1864 {
                                                                                let _e1865 = (1f / _e1516);
                                                                                phi_2501_ = type_24(_e1862, (_e1510 * _e1865), (_e1514 * _e1865), _e1075);
                                                                            } else {
                                                                                phi_2501_ = type_24();
                                                                            }
                                                                            let _e1870 = phi_2501_;
                                                                            phi_2503_ = _e1870;
                                                                            phi_2504_ = select(true, false, _e1864);
                                                                        } else {
                                                                            phi_2503_ = type_24();
                                                                            phi_2504_ = true;
                                                                        }
                                                                        let _e1873 = phi_2503_;
                                                                        let _e1875 = phi_2504_;
                                                                        if _e1875 {
                                                                            phi_2508_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2508_ = _e1873;
                                                                        }
                                                                        let _e1877 = phi_2508_;
                                                                        phi_2509_ = _e1877;
                                                                    }
                                                                    let _e1879 = phi_2509_;
                                                                    phi_2510_ = _e1879;
                                                                    phi_2511_ = _e1606;
                                                                }
                                                                let _e1881 = phi_2510_;
                                                                let _e1883 = phi_2511_;
                                                                phi_2515_ = _e1881;
                                                                phi_2516_ = _e1883;
                                                            }
                                                            let _e1885 = phi_2515_;
                                                            let _e1887 = phi_2516_;
                                                            phi_2517_ = _e1885;
                                                            phi_2518_ = _e1541;
                                                            phi_2519_ = _e1887;
                                                        }
                                                        let _e1889 = phi_2517_;
                                                        let _e1891 = phi_2518_;
                                                        let _e1893 = phi_2519_;
                                                        phi_2520_ = _e1889;
                                                        phi_2521_ = _e1891;
                                                        phi_2522_ = _e1893;
                                                    }
                                                    let _e1895 = phi_2520_;
                                                    let _e1897 = phi_2521_;
                                                    let _e1899 = phi_2522_;
                                                    phi_2530_ = _e1895;
                                                    phi_2531_ = select(_e1899, true, _e1897);
                                                } else {
                                                    phi_2530_ = type_24();
                                                    phi_2531_ = true;
                                                }
                                                let _e1902 = phi_2530_;
                                                let _e1904 = phi_2531_;
                                                if _e1904 {
                                                    phi_2535_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2535_ = _e1902;
                                                }
                                                let _e1906 = phi_2535_;
                                                if (_e1906.member_3 != 4294967295u) {
                                                    if (_e1075 != 4294967295u) {
                                                        phi_2546_ = type_38(_e1015.member, true);
                                                    } else {
                                                        phi_2546_ = _e1015;
                                                    }
                                                    let _e1914 = phi_2546_;
                                                    phi_2547_ = _e1914;
                                                } else {
                                                    phi_2547_ = _e1015;
                                                }
                                                let _e1916 = phi_2547_;
                                                phi_974_ = _e1916;
                                            } else {
                                                phi_974_ = type_38();
                                            }
                                            let _e1918 = phi_974_;
                                            continue;
                                            continuing {
                                                phi_973_ = _e1918;
                                                phi_976_ = _e1030;
                                                phi_4006_ = _e505;
                                                break if !(_e1036);
                                            }
                                        }
                                        let _e1921 = phi_4006_;
                                        phi_4192_ = _e1921;
                                        if _e1921 {
                                            break;
                                        }
                                        let _e1923 = local_10;
                                        phi_4196_ = _e1921;
                                        let _e2121 = local_12;
                                        phi_3788_ = _e2121;
                                        phi_3789_ = _e546;
                                        phi_3790_ = false;
                                        phi_3791_ = select(_e550, 0u, _e1923.member_1);
                                    } else {
                                        if (_e546.member_1 >= _e92) {
                                            phi_3344_ = type_46(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_45(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_45(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e546.member_1 < _e92) {
                                            } else {
                                                phi_4192_ = true;
                                                break;
                                            }
                                            let _e563 = ((1u + _e263) % 4u);
                                            if (_e563 < 4u) {
                                            } else {
                                                phi_4192_ = true;
                                                break;
                                            }
                                            let _e568 = global_3.member[_e546.member_1][_e563];
                                            let _e570 = (_e568 >> bitcast<u32>(11u));
                                            let _e572 = ((1u + _e262) % 4u);
                                            if (_e572 < 4u) {
                                            } else {
                                                phi_4192_ = true;
                                                break;
                                            }
                                            let _e577 = global_3.member[_e546.member_1][_e572];
                                            let _e579 = (_e577 >> bitcast<u32>(11u));
                                            let _e581 = ((1u + _e264) % 4u);
                                            if (_e581 < 4u) {
                                            } else {
                                                phi_4192_ = true;
                                                break;
                                            }
                                            let _e586 = global_3.member[_e546.member_1][_e581];
                                            let _e588 = (_e586 >> bitcast<u32>(11u));
                                            let _e611 = (bitcast<f32>((bitcast<u32>((_e546.member.member_1.x - _e546.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e612 = (bitcast<f32>((bitcast<u32>((_e546.member.member_1.y - _e546.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e613 = (bitcast<f32>((bitcast<u32>((_e546.member.member_1.z - _e546.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e615 = select(_e143, _e611, (_e611 > _e143));
                                            let _e617 = select(_e143, _e612, (_e612 > _e143));
                                            let _e619 = select(_e143, _e613, (_e613 > _e143));
                                            let _e644 = bitcast<u32>((f32(bitcast<i32>((_e568 & 1023u))) * _e615));
                                            let _e649 = (bitcast<i32>((_e568 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e652 = bitcast<f32>((_e644 & bitcast<u32>(_e649)));
                                            let _e653 = bitcast<u32>((f32(bitcast<i32>((_e577 & 1023u))) * _e617));
                                            let _e658 = (bitcast<i32>((_e577 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e661 = bitcast<f32>((_e653 & bitcast<u32>(_e658)));
                                            let _e662 = bitcast<u32>((f32(bitcast<i32>((_e586 & 1023u))) * _e619));
                                            let _e667 = (bitcast<i32>((_e586 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e670 = bitcast<f32>((_e662 & bitcast<u32>(_e667)));
                                            let _e674 = bitcast<f32>((_e644 & bitcast<u32>(~(_e649))));
                                            let _e678 = bitcast<f32>((_e653 & bitcast<u32>(~(_e658))));
                                            let _e682 = bitcast<f32>((_e662 & bitcast<u32>(~(_e667))));
                                            let _e683 = bitcast<u32>((f32(bitcast<i32>((_e570 & 1023u))) * _e615));
                                            let _e688 = (bitcast<i32>((_e570 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e691 = bitcast<f32>((_e683 & bitcast<u32>(_e688)));
                                            let _e692 = bitcast<u32>((f32(bitcast<i32>((_e579 & 1023u))) * _e617));
                                            let _e697 = (bitcast<i32>((_e579 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e700 = bitcast<f32>((_e692 & bitcast<u32>(_e697)));
                                            let _e701 = bitcast<u32>((f32(bitcast<i32>((_e588 & 1023u))) * _e619));
                                            let _e706 = (bitcast<i32>((_e588 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e709 = bitcast<f32>((_e701 & bitcast<u32>(_e706)));
                                            let _e713 = bitcast<f32>((_e683 & bitcast<u32>(~(_e688))));
                                            let _e717 = bitcast<f32>((_e692 & bitcast<u32>(~(_e697))));
                                            let _e721 = bitcast<f32>((_e701 & bitcast<u32>(~(_e706))));
                                            let _e722 = (_e546.member.member.x + _e652);
                                            let _e723 = (_e546.member.member.y + _e661);
                                            let _e724 = (_e546.member.member.z + _e670);
                                            let _e727 = (_e546.member.member_1.x - _e691);
                                            let _e728 = (_e546.member.member_1.y - _e700);
                                            let _e729 = (_e546.member.member_1.z - _e709);
                                            let _e748 = (_e727 - _e722);
                                            let _e749 = (_e728 - _e723);
                                            let _e750 = (_e729 - _e724);
                                            let _e752 = select(_e749, _e748, (_e748 > _e749));
                                            let _e754 = select(_e750, _e752, (_e752 > _e750));
                                            if (_e754 < (1024f * _e143)) {
                                                phi_3045_ = 0u;
                                            } else {
                                                phi_3045_ = select(2u, 1u, (_e754 < (2097152f * _e143)));
                                            }
                                            let _e761 = phi_3045_;
                                            switch bitcast<i32>(_e761) {
                                                case 0: {
                                                    phi_3051_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3051_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3051_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3051_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e764 = phi_3051_;
                                            let _e770 = global_3.member[_e546.member_1][0u];
                                            let _e774 = global_3.member[_e546.member_1][1u];
                                            let _e778 = global_3.member[_e546.member_1][2u];
                                            let _e782 = global_3.member[_e546.member_1][3u];
                                            let _e794 = (((_e774 >> bitcast<u32>(22i)) | ((_e778 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e782 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e795 = (_e770 & 268435455u);
                                            let _e796 = (_e794 & 268435455u);
                                            let _e799 = ((_e770 >> bitcast<u32>(28u)) & 7u);
                                            let _e807 = ((_e770 >> bitcast<u32>(31i)) | (((_e794 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e808 = (_e799 != 0u);
                                            if (_e799 == 0u) {
                                                phi_3306_ = _e795;
                                            } else {
                                                if (_e799 == 7u) {
                                                    phi_3305_ = 2147483648u;
                                                } else {
                                                    phi_3305_ = ((2147483648u | (_e799 << bitcast<u32>(28u))) | (_e796 & 268435455u));
                                                }
                                                let _e817 = phi_3305_;
                                                phi_3306_ = _e817;
                                            }
                                            let _e819 = phi_3306_;
                                            if _e808 {
                                                let _e820 = (_e799 != 7u);
                                                if _e820 {
                                                    phi_3316_ = (_e796 + (_e799 * ((3u * _e764) + 1u)));
                                                } else {
                                                    phi_3316_ = u32();
                                                }
                                                let _e824 = phi_3316_;
                                                phi_3318_ = _e824;
                                                phi_3319_ = select(true, false, _e820);
                                            } else {
                                                phi_3318_ = u32();
                                                phi_3319_ = true;
                                            }
                                            let _e827 = phi_3318_;
                                            let _e829 = phi_3319_;
                                            if (_e807 == 0u) {
                                                phi_3340_ = (_e795 + select(0u, 1u, !(_e808)));
                                            } else {
                                                if (_e807 == 7u) {
                                                    phi_3339_ = 2147483648u;
                                                } else {
                                                    phi_3339_ = ((2147483648u | (_e807 << bitcast<u32>(28u))) | (select(_e827, _e796, _e829) & 268435455u));
                                                }
                                                let _e842 = phi_3339_;
                                                phi_3340_ = _e842;
                                            }
                                            let _e844 = phi_3340_;
                                            phi_3344_ = type_46(array<vec4<f32>, 3>(vec4<f32>(_e722, (_e546.member.member.x + _e674), _e727, (_e546.member.member_1.x - _e713)), vec4<f32>(_e723, (_e546.member.member.y + _e678), _e728, (_e546.member.member_1.y - _e717)), vec4<f32>(_e724, (_e546.member.member.z + _e682), _e729, (_e546.member.member_1.z - _e721))), type_45(type_28((_e546.member.member + vec4<f32>(_e652, _e661, _e670, 0f)), (_e546.member.member_1 - vec4<f32>(_e691, _e700, _e709, 0f))), _e819), type_45(type_28((_e546.member.member + vec4<f32>(_e674, _e678, _e682, 0f)), (_e546.member.member_1 - vec4<f32>(_e713, _e717, _e721, 0f))), _e844));
                                        }
                                        let _e849 = phi_3344_;
                                        let _e861 = ((_e849.member[0].x - _e335) * _e340);
                                        let _e862 = ((_e849.member[0].y - _e335) * _e340);
                                        let _e863 = ((_e849.member[0].z - _e336) * _e340);
                                        let _e864 = ((_e849.member[0].w - _e336) * _e340);
                                        let _e874 = ((_e849.member[1].x - _e373) * _e378);
                                        let _e875 = ((_e849.member[1].y - _e373) * _e378);
                                        let _e876 = ((_e849.member[1].z - _e374) * _e378);
                                        let _e877 = ((_e849.member[1].w - _e374) * _e378);
                                        let _e887 = ((_e849.member[2].x - _e411) * _e416);
                                        let _e888 = ((_e849.member[2].y - _e411) * _e416);
                                        let _e889 = ((_e849.member[2].z - _e412) * _e416);
                                        let _e890 = ((_e849.member[2].w - _e412) * _e416);
                                        let _e892 = select(_e889, _e887, (_e887 < _e889));
                                        let _e894 = select(_e890, _e888, (_e888 < _e890));
                                        let _e896 = select(_e889, _e887, (_e887 > _e889));
                                        let _e898 = select(_e890, _e888, (_e888 > _e890));
                                        let _e900 = select(_e863, _e861, (_e861 < _e863));
                                        let _e902 = select(_e864, _e862, (_e862 < _e864));
                                        let _e904 = select(_e876, _e874, (_e874 < _e876));
                                        let _e906 = select(_e877, _e875, (_e875 < _e877));
                                        let _e908 = select(_e904, _e900, (_e900 > _e904));
                                        let _e910 = select(_e906, _e902, (_e902 > _e906));
                                        let _e912 = select(_e892, _e908, (_e908 > _e892));
                                        let _e914 = select(_e894, _e910, (_e910 > _e894));
                                        let _e916 = select(_e863, _e861, (_e861 > _e863));
                                        let _e918 = select(_e864, _e862, (_e862 > _e864));
                                        let _e920 = select(_e876, _e874, (_e874 > _e876));
                                        let _e922 = select(_e877, _e875, (_e875 > _e877));
                                        let _e924 = select(_e920, _e916, (_e916 < _e920));
                                        let _e926 = select(_e922, _e918, (_e918 < _e922));
                                        let _e931 = -(_e892);
                                        let _e932 = -(_e894);
                                        let _e939 = (select(_e896, _e924, (_e924 < _e896)) + (select(_e931, _e896, (_e896 > _e931)) * 0.0000019073523f));
                                        let _e940 = (select(_e898, _e926, (_e926 < _e898)) + (select(_e932, _e898, (_e898 > _e932)) * 0.0000019073523f));
                                        let _e942 = select(_e463, _e912, (_e912 > _e463));
                                        let _e944 = select(_e463, _e914, (_e914 > _e463));
                                        let _e949 = (_e942 <= select(_e507.member, _e939, (_e939 < _e507.member)));
                                        let _e950 = (_e944 <= select(_e507.member, _e940, (_e940 < _e507.member)));
                                        let _e951 = (_e942 <= _e944);
                                        if _e949 {
                                            if _e950 {
                                                if _e951 {
                                                    phi_3688_ = _e849.member_2;
                                                } else {
                                                    phi_3688_ = _e849.member_1;
                                                }
                                                let _e955 = phi_3688_;
                                                let _e977 = (_e550 % 128u);
                                                let _e978 = (_e977 < 128u);
                                                if _e978 {
                                                } else {
                                                    phi_4192_ = true;
                                                    break;
                                                }
                                                local_8[_e977] = _e955.member_1;
                                                if _e978 {
                                                } else {
                                                    phi_4192_ = true;
                                                    break;
                                                }
                                                local_7[_e977] = _e955.member.member.x;
                                                if _e978 {
                                                } else {
                                                    phi_4192_ = true;
                                                    break;
                                                }
                                                local_6[_e977] = _e955.member.member.y;
                                                if _e978 {
                                                } else {
                                                    phi_4192_ = true;
                                                    break;
                                                }
                                                local_5[_e977] = _e955.member.member.z;
                                                if _e978 {
                                                } else {
                                                    phi_4192_ = true;
                                                    break;
                                                }
                                                local_4[_e977] = _e955.member.member_1.x;
                                                if _e978 {
                                                } else {
                                                    phi_4192_ = true;
                                                    break;
                                                }
                                                local_3[_e977] = _e955.member.member_1.y;
                                                if _e978 {
                                                } else {
                                                    phi_4192_ = true;
                                                    break;
                                                }
                                                local_2[_e977] = _e955.member.member_1.z;
                                                if _e978 {
                                                } else {
                                                    phi_4192_ = true;
                                                    break;
                                                }
                                                local_9[_e977] = select(_e944, _e942, (_e942 > _e944));
                                                if _e951 {
                                                    phi_3765_ = _e849.member_1;
                                                } else {
                                                    phi_3765_ = _e849.member_2;
                                                }
                                                let _e991 = phi_3765_;
                                                phi_3766_ = _e991;
                                                phi_3767_ = (_e550 + 1u);
                                            } else {
                                                phi_3766_ = type_45();
                                                phi_3767_ = u32();
                                            }
                                            let _e993 = phi_3766_;
                                            let _e995 = phi_3767_;
                                            phi_3769_ = _e993;
                                            phi_3770_ = _e995;
                                            phi_3771_ = select(true, false, _e950);
                                        } else {
                                            phi_3769_ = type_45();
                                            phi_3770_ = u32();
                                            phi_3771_ = true;
                                        }
                                        let _e998 = phi_3769_;
                                        let _e1000 = phi_3770_;
                                        let _e1002 = phi_3771_;
                                        if _e1002 {
                                            if _e949 {
                                                phi_3780_ = _e849.member_1;
                                            } else {
                                                phi_3780_ = _e849.member_2;
                                            }
                                            let _e1006 = phi_3780_;
                                            phi_3785_ = _e1006;
                                            phi_3786_ = select(_e950, true, _e949);
                                        } else {
                                            phi_3785_ = _e998;
                                            phi_3786_ = _e548;
                                        }
                                        let _e1009 = phi_3785_;
                                        let _e1011 = phi_3786_;
                                        phi_4196_ = _e505;
                                        phi_3788_ = _e507;
                                        phi_3789_ = _e1009;
                                        phi_3790_ = _e1011;
                                        phi_3791_ = select(_e1000, _e550, _e1002);
                                    }
                                    let _e1927 = phi_4196_;
                                    let _e1929 = phi_3788_;
                                    let _e1931 = phi_3789_;
                                    let _e1933 = phi_3790_;
                                    let _e1935 = phi_3791_;
                                    phi_4195_ = _e1927;
                                    phi_3792_ = _e1929;
                                    phi_3793_ = _e1931;
                                    phi_3794_ = (_e511 - 1u);
                                    phi_3795_ = _e1933;
                                    phi_3796_ = _e1935;
                                } else {
                                    phi_4195_ = _e505;
                                    phi_3792_ = _e507;
                                    phi_3793_ = _e546;
                                    phi_3794_ = _e511;
                                    phi_3795_ = _e548;
                                    phi_3796_ = _e550;
                                }
                                let _e1937 = phi_4195_;
                                let _e1939 = phi_3792_;
                                let _e1941 = phi_3793_;
                                let _e1943 = phi_3794_;
                                let _e1945 = phi_3795_;
                                let _e1947 = phi_3796_;
                                phi_4194_ = _e1937;
                                phi_3797_ = _e1939;
                                phi_3798_ = _e1941;
                                phi_3799_ = _e1943;
                                phi_3800_ = _e1945;
                                phi_3801_ = _e1947;
                            } else {
                                phi_4194_ = _e505;
                                phi_3797_ = type_38();
                                phi_3798_ = type_45();
                                phi_3799_ = u32();
                                phi_3800_ = bool();
                                phi_3801_ = u32();
                            }
                            let _e1949 = phi_4194_;
                            let _e1951 = phi_3797_;
                            let _e1953 = phi_3798_;
                            let _e1955 = phi_3799_;
                            let _e1957 = phi_3800_;
                            let _e1959 = phi_3801_;
                            phi_4193_ = _e1949;
                            phi_847_ = _e1951;
                            phi_850_ = _e1953;
                            phi_852_ = _e1955;
                            phi_854_ = _e1957;
                            phi_856_ = _e1959;
                            phi_3802_ = _e519;
                        } else {
                            phi_4193_ = _e505;
                            phi_847_ = type_38();
                            phi_850_ = type_45();
                            phi_852_ = u32();
                            phi_854_ = bool();
                            phi_856_ = u32();
                            phi_3802_ = false;
                        }
                        let _e1961 = phi_4193_;
                        let _e1963 = phi_847_;
                        let _e1965 = phi_850_;
                        let _e1967 = phi_852_;
                        let _e1969 = phi_854_;
                        let _e1971 = phi_856_;
                        let _e1973 = phi_3802_;
                        continue;
                        continuing {
                            phi_4012_ = _e1961;
                            phi_846_ = _e1963;
                            phi_849_ = _e1965;
                            phi_851_ = _e1967;
                            phi_853_ = _e1969;
                            phi_855_ = _e1971;
                            phi_4192_ = _e1961;
                            break if !(_e1973);
                        }
                    }
                    let _e1976 = phi_4192_;
                    if _e1976 {
                        break;
                    }
                    let _e1978 = local_11;
                    if _e151 {
                    } else {
                        break;
                    }
                    global_5.member[_e149] = select(0u, 1u, _e1978.member_1);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_any_q10_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
