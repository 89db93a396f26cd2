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

struct type_20 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_21 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_24 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_31 {
    member: array<type_21>,
}

struct type_35 {
    member: array<array<type_20, 8>>,
}

struct type_41 {
    member: array<vec4<u32>, 2>,
}

struct type_48 {
    member: array<array<u32, 7>>,
}

struct type_54 {
    member: type_24,
    member_1: u32,
}

struct type_57 {
    member: array<vec4<f32>, 3>,
    member_1: type_54,
    member_2: type_54,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_41;
@group(0) @binding(4) 
var<storage> global_3: type_31;
@group(0) @binding(2) 
var<storage> global_4: type_48;
@group(0) @binding(3) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_35;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<type_20, 8>;
    var local_3: array<f32, 128>;
    var local_4: array<type_54, 128>;
    var local_5: array<u32, 3>;
    var local_6: array<array<f32, 3>, 3>;
    var local_7: array<f32, 4>;
    var phi_410_: i32;
    var phi_411_: i32;
    var phi_421_: bool;
    var phi_431_: u32;
    var phi_432_: u32;
    var phi_434_: bool;
    var phi_439_: u32;
    var phi_452_: i32;
    var phi_472_: i32;
    var phi_490_: f32;
    var phi_496_: f32;
    var phi_507_: f32;
    var phi_513_: f32;
    var phi_536_: f32;
    var phi_547_: f32;
    var phi_556_: f32;
    var phi_562_: f32;
    var phi_573_: f32;
    var phi_579_: f32;
    var phi_602_: f32;
    var phi_613_: f32;
    var phi_622_: f32;
    var phi_628_: f32;
    var phi_639_: f32;
    var phi_645_: f32;
    var phi_668_: f32;
    var phi_679_: f32;
    var phi_779_: f32;
    var phi_780_: f32;
    var phi_4877_: bool;
    var phi_4776_: f32;
    var phi_1953_: type_54;
    var phi_1956_: u32;
    var phi_1958_: bool;
    var phi_1960_: u32;
    var phi_1971_: bool;
    var phi_2009_: type_54;
    var phi_2010_: bool;
    var phi_2011_: u32;
    var phi_3703_: u32;
    var phi_3709_: u32;
    var phi_3963_: u32;
    var phi_3964_: u32;
    var phi_3974_: u32;
    var phi_3976_: u32;
    var phi_3977_: bool;
    var phi_3997_: u32;
    var phi_3998_: u32;
    var phi_4002_: type_57;
    var phi_4347_: type_54;
    var phi_4380_: type_54;
    var phi_4381_: type_54;
    var phi_4382_: u32;
    var phi_4384_: type_54;
    var phi_4385_: u32;
    var phi_4386_: bool;
    var phi_4395_: type_54;
    var phi_4400_: type_54;
    var phi_4401_: bool;
    var phi_4949_: f32;
    var phi_4874_: bool;
    var phi_2030_: type_8;
    var phi_2031_: type_8;
    var phi_2054_: type_8;
    var phi_2095_: u32;
    var phi_2101_: u32;
    var phi_2111_: u32;
    var phi_2127_: u32;
    var phi_2164_: u32;
    var phi_2170_: u32;
    var phi_2180_: u32;
    var phi_4859_: bool;
    var phi_2196_: type_8;
    var phi_2197_: type_8;
    var phi_2220_: type_8;
    var phi_2243_: u32;
    var phi_2258_: u32;
    var phi_2261_: type_8;
    var phi_2262_: type_8;
    var phi_2285_: type_8;
    var phi_2351_: u32;
    var phi_2331_: u32;
    var phi_2332_: u32;
    var phi_2355_: f32;
    var phi_4852_: bool;
    var phi_4931_: bool;
    var phi_4930_: bool;
    var phi_2856_: vec3<f32>;
    var phi_2857_: vec3<f32>;
    var phi_2888_: bool;
    var phi_2897_: vec3<f32>;
    var phi_2937_: type_20;
    var phi_2939_: type_20;
    var phi_2940_: bool;
    var phi_2944_: type_20;
    var phi_2945_: type_20;
    var phi_2946_: type_20;
    var phi_2947_: bool;
    var phi_2951_: type_20;
    var phi_2952_: bool;
    var phi_2956_: type_20;
    var phi_2957_: bool;
    var phi_2961_: type_20;
    var phi_2973_: type_8;
    var phi_2976_: type_20;
    var phi_2974_: type_8;
    var phi_2999_: type_8;
    var phi_3031_: bool;
    var phi_3032_: bool;
    var phi_3053_: type_20;
    var phi_2977_: type_20;
    var phi_4961_: bool;
    var phi_5245_: f32;
    var phi_5244_: f32;
    var phi_5023_: bool;
    var phi_5243_: f32;
    var phi_5022_: bool;
    var phi_5242_: f32;
    var phi_5021_: bool;
    var phi_5182_: f32;
    var phi_5020_: bool;
    var phi_5147_: f32;
    var phi_5029_: bool;
    var phi_4403_: type_54;
    var phi_4404_: bool;
    var phi_4405_: u32;
    var phi_5146_: f32;
    var phi_5028_: bool;
    var phi_4406_: type_54;
    var phi_4407_: u32;
    var phi_4408_: bool;
    var phi_4409_: u32;
    var phi_5145_: f32;
    var phi_5027_: bool;
    var phi_4410_: type_54;
    var phi_4411_: u32;
    var phi_4412_: bool;
    var phi_4413_: u32;
    var phi_5144_: f32;
    var phi_5026_: bool;
    var phi_1954_: type_54;
    var phi_1957_: u32;
    var phi_1959_: bool;
    var phi_1961_: u32;
    var phi_4414_: bool;
    var phi_5025_: bool;
    var phi_4421_: type_8;
    var phi_4422_: type_8;
    var phi_4445_: type_8;
    var phi_4511_: type_20;
    var phi_5137_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e90 = global;
            let _e92 = arrayLength((&global_4.member));
            let _e95 = arrayLength((&global_5.member));
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
            let _e150 = (_e149 < arrayLength((&global_3.member)));
            if _e150 {
                let _e151 = (_e149 < arrayLength((&global_6.member)));
                if _e151 {
                    if _e150 {
                    } else {
                        break;
                    }
                    let _e159 = global_3.member[_e149].member_2[0u];
                    let _e161 = (bitcast<u32>(_e159) & 2147483647u);
                    let _e166 = global_3.member[_e149].member_2[1u];
                    let _e168 = (bitcast<u32>(_e166) & 2147483647u);
                    let _e173 = global_3.member[_e149].member_2[2u];
                    let _e175 = (bitcast<u32>(_e173) & 2147483647u);
                    let _e180 = global_3.member[_e149].member[0u];
                    let _e182 = (bitcast<u32>(_e180) & 2147483647u);
                    let _e187 = global_3.member[_e149].member[1u];
                    let _e189 = (bitcast<u32>(_e187) & 2147483647u);
                    let _e194 = global_3.member[_e149].member[2u];
                    let _e196 = (bitcast<u32>(_e194) & 2147483647u);
                    let _e198 = select(_e168, _e161, (_e168 < _e161));
                    let _e200 = select(_e175, _e198, (_e175 < _e198));
                    let _e202 = select(_e182, _e200, (_e182 < _e200));
                    let _e204 = select(_e189, _e202, (_e189 < _e202));
                    let _e206 = select(_e196, _e204, (_e196 < _e204));
                    let _e210 = global_3.member[_e149].member_1;
                    let _e212 = (bitcast<u32>(_e210) & 2147483647u);
                    let _e219 = global_3.member[_e149].member_3;
                    let _e225 = (((select(_e212, _e206, (_e212 < _e206)) < 2139095040u) && ((bitcast<u32>(_e219) & 2147483647u) <= 2139095040u)) && (_e200 > 0u));
                    if _e225 {
                        let _e228 = (bitcast<u32>(bitcast<f32>(_e200)) & 2147483647u);
                        if (_e228 >= 8388608u) {
                            phi_410_ = (bitcast<i32>((_e228 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_410_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e228)), 32u, (_e228 == 0u))));
                        }
                        let _e242 = phi_410_;
                        phi_411_ = _e242;
                    } else {
                        phi_411_ = 0i;
                    }
                    let _e244 = phi_411_;
                    let _e245 = (_e161 == _e200);
                    if _e245 {
                        phi_421_ = true;
                    } else {
                        phi_421_ = (_e168 == _e200);
                    }
                    let _e248 = phi_421_;
                    let _e249 = select(1u, 0u, _e245);
                    if _e248 {
                        let _e250 = (_e249 + 1u);
                        phi_431_ = _e250;
                        phi_432_ = _e250;
                        phi_434_ = select(true, false, (_e250 == 2u));
                    } else {
                        phi_431_ = u32();
                        phi_432_ = 0u;
                        phi_434_ = true;
                    }
                    let _e254 = phi_431_;
                    let _e256 = phi_432_;
                    let _e258 = phi_434_;
                    if _e258 {
                        phi_439_ = (_e256 + 1u);
                    } else {
                        phi_439_ = 0u;
                    }
                    let _e262 = phi_439_;
                    let _e263 = select(_e254, _e256, _e258);
                    let _e264 = select(_e249, select(2u, _e249, _e248), _e258);
                    if (_e131 < -126i) {
                        phi_452_ = -126i;
                    } else {
                        phi_452_ = select(_e131, 127i, (_e131 > 127i));
                    }
                    let _e269 = phi_452_;
                    let _e274 = bitcast<f32>((bitcast<u32>((_e269 + 127i)) << bitcast<u32>(23i)));
                    let _e280 = bitcast<f32>((bitcast<u32>(((_e131 - _e269) + 127i)) << bitcast<u32>(23i)));
                    let _e281 = -(_e244);
                    if (_e281 < -126i) {
                        phi_472_ = -126i;
                    } else {
                        phi_472_ = select(_e281, 127i, (_e281 > 127i));
                    }
                    let _e286 = phi_472_;
                    let _e291 = bitcast<f32>((bitcast<u32>((_e286 + 127i)) << bitcast<u32>(23i)));
                    let _e297 = bitcast<f32>((bitcast<u32>(((_e281 - _e286) + 127i)) << bitcast<u32>(23i)));
                    let _e301 = global_3.member[_e149].member;
                    let _e302 = (_e263 == 0u);
                    if _e302 {
                        phi_490_ = _e301[0];
                    } else {
                        phi_490_ = _e301[1];
                    }
                    let _e306 = phi_490_;
                    let _e307 = (_e263 == 2u);
                    if _e307 {
                        phi_496_ = _e301[2];
                    } else {
                        phi_496_ = _e306;
                    }
                    let _e310 = phi_496_;
                    let _e312 = ((_e310 * _e274) * _e280);
                    let _e313 = global_3.member[_e149].member_2;
                    if _e302 {
                        phi_507_ = _e313[0];
                    } else {
                        phi_507_ = _e313[1];
                    }
                    let _e317 = phi_507_;
                    if _e307 {
                        phi_513_ = _e313[2];
                    } else {
                        phi_513_ = _e317;
                    }
                    let _e320 = phi_513_;
                    let _e322 = ((_e320 * _e291) * _e297);
                    let _e326 = (bitcast<f32>((bitcast<u32>(_e322) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e326 {
                        let _e330 = (bitcast<f32>((bitcast<u32>(_e312) & 2147483647u)) * 0.00000011920929f);
                        phi_536_ = select(0.00000000000011368684f, _e330, (_e330 > 0.00000000000011368684f));
                    } else {
                        phi_536_ = 0f;
                    }
                    let _e334 = phi_536_;
                    let _e335 = (_e312 + _e334);
                    let _e336 = (_e312 - _e334);
                    let _e337 = select(_e322, 0f, _e326);
                    if _e326 {
                        phi_547_ = 38685626000000000000000000f;
                    } else {
                        phi_547_ = (1f / _e322);
                    }
                    let _e340 = phi_547_;
                    let _e341 = (_e262 == 0u);
                    if _e341 {
                        phi_556_ = _e301[0];
                    } else {
                        phi_556_ = _e301[1];
                    }
                    let _e345 = phi_556_;
                    let _e346 = (_e262 == 2u);
                    if _e346 {
                        phi_562_ = _e301[2];
                    } else {
                        phi_562_ = _e345;
                    }
                    let _e349 = phi_562_;
                    let _e351 = ((_e349 * _e274) * _e280);
                    if _e341 {
                        phi_573_ = _e313[0];
                    } else {
                        phi_573_ = _e313[1];
                    }
                    let _e355 = phi_573_;
                    if _e346 {
                        phi_579_ = _e313[2];
                    } else {
                        phi_579_ = _e355;
                    }
                    let _e358 = phi_579_;
                    let _e360 = ((_e358 * _e291) * _e297);
                    let _e364 = (bitcast<f32>((bitcast<u32>(_e360) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e364 {
                        let _e368 = (bitcast<f32>((bitcast<u32>(_e351) & 2147483647u)) * 0.00000011920929f);
                        phi_602_ = select(0.00000000000011368684f, _e368, (_e368 > 0.00000000000011368684f));
                    } else {
                        phi_602_ = 0f;
                    }
                    let _e372 = phi_602_;
                    let _e373 = (_e351 + _e372);
                    let _e374 = (_e351 - _e372);
                    let _e375 = select(_e360, 0f, _e364);
                    if _e364 {
                        phi_613_ = 38685626000000000000000000f;
                    } else {
                        phi_613_ = (1f / _e360);
                    }
                    let _e378 = phi_613_;
                    let _e379 = (_e264 == 0u);
                    if _e379 {
                        phi_622_ = _e301[0];
                    } else {
                        phi_622_ = _e301[1];
                    }
                    let _e383 = phi_622_;
                    let _e384 = (_e264 == 2u);
                    if _e384 {
                        phi_628_ = _e301[2];
                    } else {
                        phi_628_ = _e383;
                    }
                    let _e387 = phi_628_;
                    let _e389 = ((_e387 * _e274) * _e280);
                    if _e379 {
                        phi_639_ = _e313[0];
                    } else {
                        phi_639_ = _e313[1];
                    }
                    let _e393 = phi_639_;
                    if _e384 {
                        phi_645_ = _e313[2];
                    } else {
                        phi_645_ = _e393;
                    }
                    let _e396 = phi_645_;
                    let _e398 = ((_e396 * _e291) * _e297);
                    let _e402 = (bitcast<f32>((bitcast<u32>(_e398) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e402 {
                        let _e406 = (bitcast<f32>((bitcast<u32>(_e389) & 2147483647u)) * 0.00000011920929f);
                        phi_668_ = select(0.00000000000011368684f, _e406, (_e406 > 0.00000000000011368684f));
                    } else {
                        phi_668_ = 0f;
                    }
                    let _e410 = phi_668_;
                    let _e411 = (_e389 + _e410);
                    let _e412 = (_e389 - _e410);
                    let _e413 = select(_e398, 0f, _e402);
                    if _e402 {
                        phi_679_ = 38685626000000000000000000f;
                    } else {
                        phi_679_ = (1f / _e398);
                    }
                    let _e416 = phi_679_;
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
                        phi_779_ = select(-340282350000000000000000000000000000000f, _e457, (_e457 > -340282350000000000000000000000000000000f));
                        phi_780_ = select(-340282350000000000000000000000000000000f, _e450, (_e450 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_779_ = 0f;
                        phi_780_ = 1f;
                    }
                    let _e461 = phi_779_;
                    let _e463 = phi_780_;
                    local_2 = array<type_20, 8>(type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_4 = array<type_54, 128>(type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e466 = (_e263 % 3u);
                    let _e467 = (_e466 < 3u);
                    if _e467 {
                    } else {
                        break;
                    }
                    let _e469 = local_1[_e466];
                    let _e472 = (_e262 % 3u);
                    let _e473 = (_e472 < 3u);
                    if _e473 {
                    } else {
                        break;
                    }
                    let _e475 = local_1[_e472];
                    let _e478 = (_e264 % 3u);
                    let _e479 = (_e478 < 3u);
                    if _e479 {
                    } else {
                        break;
                    }
                    let _e481 = local_1[_e478];
                    if _e467 {
                    } else {
                        break;
                    }
                    let _e486 = local[_e466];
                    if _e473 {
                    } else {
                        break;
                    }
                    let _e490 = local[_e472];
                    if _e479 {
                    } else {
                        break;
                    }
                    let _e494 = local[_e478];
                    phi_4877_ = false;
                    phi_4776_ = _e461;
                    phi_1953_ = type_54(type_24(vec4<f32>((f32(_e469) * _e143), (f32(_e475) * _e143), (f32(_e481) * _e143), 0f), vec4<f32>((f32(_e486) * _e143), (f32(_e490) * _e143), (f32(_e494) * _e143), 0f)), select(0u, 2147483648u, (_e92 == 0u)));
                    phi_1956_ = ((3u * _e92) + 1u);
                    phi_1958_ = (_e463 <= _e461);
                    phi_1960_ = 0u;
                    loop {
                        let _e504 = phi_4877_;
                        let _e506 = phi_4776_;
                        let _e508 = phi_1953_;
                        let _e510 = phi_1956_;
                        let _e512 = phi_1958_;
                        let _e514 = phi_1960_;
                        if _e512 {
                            phi_1971_ = true;
                        } else {
                            phi_1971_ = (_e514 > 0u);
                        }
                        let _e517 = phi_1971_;
                        if _e517 {
                            let _e518 = (_e510 > 0u);
                            if _e518 {
                                if _e512 {
                                    phi_2009_ = _e508;
                                    phi_2010_ = _e512;
                                    phi_2011_ = _e514;
                                } else {
                                    let _e519 = (_e514 - 1u);
                                    let _e520 = (_e519 % 128u);
                                    let _e521 = (_e520 < 128u);
                                    if _e521 {
                                    } else {
                                        phi_5025_ = true;
                                        break;
                                    }
                                    let _e523 = local_4[_e520];
                                    if _e521 {
                                    } else {
                                        phi_5025_ = true;
                                        break;
                                    }
                                    let _e531 = local_3[_e520];
                                    phi_2009_ = type_54(type_24(_e523.member.member, _e523.member.member_1), _e523.member_1);
                                    phi_2010_ = (_e531 <= _e506);
                                    phi_2011_ = _e519;
                                }
                                let _e534 = phi_2009_;
                                let _e536 = phi_2010_;
                                let _e538 = phi_2011_;
                                if _e536 {
                                    let _e543 = (_e534.member_1 & 268435455u);
                                    if ((_e534.member_1 & 2147483648u) != 0u) {
                                        phi_4949_ = _e506;
                                        phi_4874_ = _e504;
                                        phi_2030_ = type_8(0u, ((_e534.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1004 = phi_4949_;
                                            let _e1006 = phi_4874_;
                                            let _e1008 = phi_2030_;
                                            if (_e1008.member < _e1008.member_1) {
                                                phi_2031_ = type_8((_e1008.member + 1u), _e1008.member_1);
                                                phi_2054_ = type_8(1u, _e1008.member);
                                            } else {
                                                phi_2031_ = _e1008;
                                                phi_2054_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1021 = phi_2031_;
                                            let _e1023 = phi_2054_;
                                            let _e1027 = (bitcast<i32>(_e1023.member) != 0i);
                                            if _e1027 {
                                                let _e1032 = (_e534.member.member_1.x - _e534.member.member.x);
                                                let _e1035 = (_e534.member.member_1.y - _e534.member.member.y);
                                                let _e1038 = (_e534.member.member_1.z - _e534.member.member.z);
                                                let _e1040 = select(_e1035, _e1032, (_e1032 > _e1035));
                                                let _e1042 = select(_e1038, _e1040, (_e1040 > _e1038));
                                                let _e1044 = (_e1042 < (1024f * _e143));
                                                if _e1044 {
                                                    phi_2095_ = 0u;
                                                } else {
                                                    phi_2095_ = select(2u, 1u, (_e1042 < (2097152f * _e143)));
                                                }
                                                let _e1049 = phi_2095_;
                                                switch bitcast<i32>(_e1049) {
                                                    case 0: {
                                                        phi_2101_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2101_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2101_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2101_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1052 = phi_2101_;
                                                switch bitcast<i32>(_e1049) {
                                                    case 0: {
                                                        phi_2111_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2111_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2111_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2111_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1059 = phi_2111_;
                                                let _e1061 = ((_e543 + (_e1023.member_1 * ((3u * _e1052) + 1u))) + (3u * _e1059));
                                                let _e1062 = (_e1061 < _e95);
                                                if _e1062 {
                                                    if _e1062 {
                                                    } else {
                                                        phi_5182_ = _e1004;
                                                        phi_5020_ = true;
                                                        break;
                                                    }
                                                    let _e1064 = global_5.member[_e1061];
                                                    phi_2127_ = _e1064;
                                                } else {
                                                    phi_2127_ = 4294967295u;
                                                }
                                                let _e1066 = phi_2127_;
                                                local_5 = array<u32, 3>(_e263, _e262, _e264);
                                                if _e1044 {
                                                    phi_2164_ = 0u;
                                                } else {
                                                    phi_2164_ = select(2u, 1u, (_e1042 < (2097152f * _e143)));
                                                }
                                                let _e1072 = phi_2164_;
                                                switch bitcast<i32>(_e1072) {
                                                    case 0: {
                                                        phi_2170_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2170_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2170_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2170_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1075 = phi_2170_;
                                                switch bitcast<i32>(_e1072) {
                                                    case 0: {
                                                        phi_2180_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_2180_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_2180_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2180_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1082 = phi_2180_;
                                                local_7 = array<f32, 4>(_e534.member.member.x, _e534.member.member.y, _e534.member.member.z, _e534.member.member.w);
                                                local_6[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_6[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_6[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_4859_ = _e1006;
                                                phi_2196_ = type_8(0u, 3u);
                                                loop {
                                                    let _e1096 = phi_4859_;
                                                    let _e1098 = phi_2196_;
                                                    if (_e1098.member < _e1098.member_1) {
                                                        phi_2197_ = type_8((_e1098.member + 1u), _e1098.member_1);
                                                        phi_2220_ = type_8(1u, _e1098.member);
                                                    } else {
                                                        phi_2197_ = _e1098;
                                                        phi_2220_ = type_8(0u, type_8().member_1);
                                                    }
                                                    let _e1111 = phi_2197_;
                                                    let _e1113 = phi_2220_;
                                                    let _e1117 = (bitcast<i32>(_e1113.member) != 0i);
                                                    if _e1117 {
                                                        let _e1119 = ((_e543 + (_e1023.member_1 * ((3u * _e1075) + 1u))) + (_e1113.member_1 * _e1082));
                                                        let _e1120 = (_e1119 < _e95);
                                                        if _e1120 {
                                                            if _e1120 {
                                                            } else {
                                                                phi_4930_ = true;
                                                                break;
                                                            }
                                                            let _e1122 = global_5.member[_e1119];
                                                            phi_2243_ = _e1122;
                                                        } else {
                                                            phi_2243_ = 0u;
                                                        }
                                                        let _e1124 = phi_2243_;
                                                        let _e1125 = (_e1119 + 1u);
                                                        let _e1126 = (_e1125 < _e95);
                                                        if _e1126 {
                                                            if _e1126 {
                                                            } else {
                                                                phi_4930_ = true;
                                                                break;
                                                            }
                                                            let _e1128 = global_5.member[_e1125];
                                                            phi_2258_ = _e1128;
                                                        } else {
                                                            phi_2258_ = 0u;
                                                        }
                                                        let _e1130 = phi_2258_;
                                                        phi_2261_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e1132 = phi_2261_;
                                                            if (_e1132.member < _e1132.member_1) {
                                                                phi_2262_ = type_8((_e1132.member + 1u), _e1132.member_1);
                                                                phi_2285_ = type_8(1u, _e1132.member);
                                                            } else {
                                                                phi_2262_ = _e1132;
                                                                phi_2285_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1145 = phi_2262_;
                                                            let _e1147 = phi_2285_;
                                                            let _e1151 = (bitcast<i32>(_e1147.member) != 0i);
                                                            if _e1151 {
                                                                let _e1152 = (_e1147.member_1 < 3u);
                                                                if _e1152 {
                                                                } else {
                                                                    phi_4852_ = true;
                                                                    break;
                                                                }
                                                                let _e1154 = local_5[_e1147.member_1];
                                                                if (_e1147.member_1 < 4u) {
                                                                } else {
                                                                    phi_4852_ = true;
                                                                    break;
                                                                }
                                                                let _e1157 = local_7[_e1147.member_1];
                                                                switch bitcast<i32>(_e1072) {
                                                                    case 0: {
                                                                        phi_2355_ = (_e1157 + (f32(((_e1124 >> bitcast<u32>(((10u * _e1154) & 31u))) & 1023u)) * _e143));
                                                                        break;
                                                                    }
                                                                    case 1: {
                                                                        if (_e1154 == 0u) {
                                                                            phi_2332_ = _e1124;
                                                                        } else {
                                                                            if (_e1154 == 1u) {
                                                                                phi_2331_ = ((_e1124 >> bitcast<u32>(21i)) | (_e1130 << bitcast<u32>(11i)));
                                                                            } else {
                                                                                phi_2331_ = (_e1130 >> bitcast<u32>(10i));
                                                                            }
                                                                            let _e1178 = phi_2331_;
                                                                            phi_2332_ = _e1178;
                                                                        }
                                                                        let _e1180 = phi_2332_;
                                                                        phi_2355_ = (_e1157 + (f32((_e1180 & 2097151u)) * _e143));
                                                                        break;
                                                                    }
                                                                    case 2: {
                                                                        let _e1159 = (_e1119 + _e1154);
                                                                        let _e1160 = (_e1159 < _e95);
                                                                        if _e1160 {
                                                                            if _e1160 {
                                                                            } else {
                                                                                phi_4852_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1162 = global_5.member[_e1159];
                                                                            phi_2351_ = _e1162;
                                                                        } else {
                                                                            phi_2351_ = 0u;
                                                                        }
                                                                        let _e1164 = phi_2351_;
                                                                        phi_2355_ = (f32(bitcast<i32>(_e1164)) * _e143);
                                                                        break;
                                                                    }
                                                                    default: {
                                                                        phi_2355_ = f32();
                                                                        break;
                                                                    }
                                                                }
                                                                let _e1194 = phi_2355_;
                                                                if (_e1113.member_1 < 3u) {
                                                                } else {
                                                                    phi_4852_ = true;
                                                                    break;
                                                                }
                                                                if _e1152 {
                                                                } else {
                                                                    phi_4852_ = true;
                                                                    break;
                                                                }
                                                                local_6[_e1113.member_1][_e1147.member_1] = _e1194;
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_2261_ = _e1145;
                                                                phi_4852_ = _e1096;
                                                                break if !(_e1151);
                                                            }
                                                        }
                                                        let _e1200 = phi_4852_;
                                                        phi_4930_ = _e1200;
                                                        if _e1200 {
                                                            break;
                                                        }
                                                        phi_4931_ = _e1200;
                                                    } else {
                                                        phi_4931_ = _e1096;
                                                    }
                                                    let _e1202 = phi_4931_;
                                                    continue;
                                                    continuing {
                                                        phi_4859_ = _e1202;
                                                        phi_2196_ = _e1111;
                                                        phi_4930_ = _e1202;
                                                        break if !(_e1117);
                                                    }
                                                }
                                                let _e1205 = phi_4930_;
                                                phi_5182_ = _e1004;
                                                phi_5020_ = _e1205;
                                                if _e1205 {
                                                    break;
                                                }
                                                let _e1206 = local_6;
                                                let _e1221 = (_e1206[0][2] - _e389);
                                                let _e1224 = (((_e1206[0][0] - _e312) * _e413) - (_e1221 * _e337));
                                                let _e1227 = (((_e1206[0][1] - _e351) * _e413) - (_e1221 * _e375));
                                                let _e1230 = (_e1206[1][2] - _e389);
                                                let _e1233 = (((_e1206[1][0] - _e312) * _e413) - (_e1230 * _e337));
                                                let _e1236 = (((_e1206[1][1] - _e351) * _e413) - (_e1230 * _e375));
                                                let _e1239 = (_e1206[2][2] - _e389);
                                                let _e1242 = (((_e1206[2][0] - _e312) * _e413) - (_e1239 * _e337));
                                                let _e1245 = (((_e1206[2][1] - _e351) * _e413) - (_e1239 * _e375));
                                                let _e1246 = (_e1242 * _e1236);
                                                let _e1247 = (_e1245 * _e1233);
                                                let _e1248 = (_e1224 * _e1245);
                                                let _e1249 = (_e1227 * _e1242);
                                                let _e1250 = (_e1233 * _e1227);
                                                let _e1251 = (_e1236 * _e1224);
                                                let _e1256 = (((_e1246 >= _e1247) && (_e1248 >= _e1249)) && (_e1250 >= _e1251));
                                                if (_e1256 || (((_e1246 <= _e1247) && (_e1248 <= _e1249)) && (_e1250 <= _e1251))) {
                                                    let _e1263 = select(-1f, 1f, _e1256);
                                                    let _e1265 = ((_e1246 - _e1247) * _e1263);
                                                    let _e1267 = select(0f, _e1265, (_e1265 > 0f));
                                                    let _e1269 = ((_e1248 - _e1249) * _e1263);
                                                    let _e1271 = select(0f, _e1269, (_e1269 > 0f));
                                                    let _e1273 = ((_e1250 - _e1251) * _e1263);
                                                    let _e1275 = select(0f, _e1273, (_e1273 > 0f));
                                                    let _e1277 = ((_e1267 + _e1271) + _e1275);
                                                    if (_e1277 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2951_ = type_20();
                                                        phi_2952_ = true;
                                                    } else {
                                                        let _e1280 = select(_e1206[1][0], _e1206[0][0], (_e1206[0][0] < _e1206[1][0]));
                                                        let _e1284 = select(_e1206[1][0], _e1206[0][0], (_e1206[0][0] > _e1206[1][0]));
                                                        let _e1288 = select(_e1206[1][1], _e1206[0][1], (_e1206[0][1] < _e1206[1][1]));
                                                        let _e1292 = select(_e1206[1][1], _e1206[0][1], (_e1206[0][1] > _e1206[1][1]));
                                                        let _e1296 = select(_e1206[1][2], _e1206[0][2], (_e1206[0][2] < _e1206[1][2]));
                                                        let _e1300 = select(_e1206[1][2], _e1206[0][2], (_e1206[0][2] > _e1206[1][2]));
                                                        let _e1305 = ((select(_e1206[2][0], _e1280, (_e1280 < _e1206[2][0])) - _e335) * _e340);
                                                        let _e1306 = ((select(_e1206[2][0], _e1284, (_e1284 > _e1206[2][0])) - _e336) * _e340);
                                                        let _e1309 = ((select(_e1206[2][1], _e1288, (_e1288 < _e1206[2][1])) - _e373) * _e378);
                                                        let _e1310 = ((select(_e1206[2][1], _e1292, (_e1292 > _e1206[2][1])) - _e374) * _e378);
                                                        let _e1313 = ((select(_e1206[2][2], _e1296, (_e1296 < _e1206[2][2])) - _e411) * _e416);
                                                        let _e1314 = ((select(_e1206[2][2], _e1300, (_e1300 > _e1206[2][2])) - _e412) * _e416);
                                                        let _e1316 = select(_e1314, _e1313, (_e1313 < _e1314));
                                                        let _e1318 = select(_e1314, _e1313, (_e1313 > _e1314));
                                                        let _e1320 = select(_e1306, _e1305, (_e1305 < _e1306));
                                                        let _e1322 = select(_e1310, _e1309, (_e1309 < _e1310));
                                                        let _e1324 = select(_e1322, _e1320, (_e1320 > _e1322));
                                                        let _e1326 = select(_e1316, _e1324, (_e1324 > _e1316));
                                                        let _e1328 = select(_e1306, _e1305, (_e1305 > _e1306));
                                                        let _e1330 = select(_e1310, _e1309, (_e1309 > _e1310));
                                                        let _e1332 = select(_e1330, _e1328, (_e1328 < _e1330));
                                                        let _e1334 = select(_e1318, _e1332, (_e1332 < _e1318));
                                                        let _e1335 = -(_e1316);
                                                        let _e1341 = select(_e463, _e1326, (_e1326 > _e463));
                                                        if (_e1341 > (_e1334 + (select(_e1335, _e1318, (_e1318 > _e1335)) * 0.0000019073523f))) {
                                                            phi_2946_ = type_20();
                                                            phi_2947_ = true;
                                                        } else {
                                                            let _e1343 = (_e1341 > _e1004);
                                                            if _e1343 {
                                                                phi_2945_ = type_20();
                                                            } else {
                                                                let _e1347 = (_e1206[1][0] - _e1206[0][0]);
                                                                let _e1348 = (_e1206[1][1] - _e1206[0][1]);
                                                                let _e1349 = (_e1206[1][2] - _e1206[0][2]);
                                                                let _e1350 = vec3<f32>(_e1347, _e1348, _e1349);
                                                                let _e1351 = (_e1206[2][0] - _e1206[1][0]);
                                                                let _e1352 = (_e1206[2][1] - _e1206[1][1]);
                                                                let _e1353 = (_e1206[2][2] - _e1206[1][2]);
                                                                let _e1354 = vec3<f32>(_e1351, _e1352, _e1353);
                                                                let _e1355 = (_e1206[0][0] - _e1206[2][0]);
                                                                let _e1356 = (_e1206[0][1] - _e1206[2][1]);
                                                                let _e1357 = (_e1206[0][2] - _e1206[2][2]);
                                                                let _e1358 = vec3<f32>(_e1355, _e1356, _e1357);
                                                                let _e1361 = bitcast<f32>((bitcast<u32>(_e1347) & 2147483647u));
                                                                let _e1364 = bitcast<f32>((bitcast<u32>(_e1348) & 2147483647u));
                                                                let _e1366 = select(_e1364, _e1361, (_e1361 > _e1364));
                                                                let _e1369 = bitcast<f32>((bitcast<u32>(_e1349) & 2147483647u));
                                                                let _e1371 = select(_e1369, _e1366, (_e1366 > _e1369));
                                                                let _e1374 = bitcast<f32>((bitcast<u32>(_e1351) & 2147483647u));
                                                                let _e1377 = bitcast<f32>((bitcast<u32>(_e1352) & 2147483647u));
                                                                let _e1379 = select(_e1377, _e1374, (_e1374 > _e1377));
                                                                let _e1382 = bitcast<f32>((bitcast<u32>(_e1353) & 2147483647u));
                                                                let _e1384 = select(_e1382, _e1379, (_e1379 > _e1382));
                                                                let _e1387 = bitcast<f32>((bitcast<u32>(_e1355) & 2147483647u));
                                                                let _e1390 = bitcast<f32>((bitcast<u32>(_e1356) & 2147483647u));
                                                                let _e1392 = select(_e1390, _e1387, (_e1387 > _e1390));
                                                                let _e1395 = bitcast<f32>((bitcast<u32>(_e1357) & 2147483647u));
                                                                let _e1397 = select(_e1395, _e1392, (_e1392 > _e1395));
                                                                let _e1399 = select(_e1384, _e1371, (_e1371 > _e1384));
                                                                let _e1401 = select(_e1397, _e1399, (_e1399 > _e1397));
                                                                if (_e1371 == _e1401) {
                                                                    phi_2856_ = _e1354;
                                                                    phi_2857_ = _e1358;
                                                                } else {
                                                                    let _e1404 = vec3((_e1384 == _e1401));
                                                                    phi_2856_ = select(_e1350, _e1358, _e1404);
                                                                    phi_2857_ = select(_e1354, _e1350, _e1404);
                                                                }
                                                                let _e1408 = phi_2856_;
                                                                let _e1410 = phi_2857_;
                                                                let _e1417 = ((_e1408.y * _e1410.z) - (_e1410.y * _e1408.z));
                                                                let _e1422 = ((_e1408.z * _e1410.x) - (_e1410.z * _e1408.x));
                                                                let _e1425 = ((_e1408.x * _e1410.y) - (_e1410.x * _e1408.y));
                                                                if (_e1267 >= _e1271) {
                                                                    phi_2888_ = select(true, false, (_e1267 >= _e1275));
                                                                } else {
                                                                    phi_2888_ = true;
                                                                }
                                                                let _e1430 = phi_2888_;
                                                                if _e1430 {
                                                                    phi_2897_ = select(vec3<f32>(_e1206[2][0], _e1206[2][1], _e1206[2][2]), vec3<f32>(_e1206[1][0], _e1206[1][1], _e1206[1][2]), vec3((_e1271 >= _e1275)));
                                                                } else {
                                                                    phi_2897_ = vec3<f32>(_e1206[0][0], _e1206[0][1], _e1206[0][2]);
                                                                }
                                                                let _e1435 = phi_2897_;
                                                                let _e1452 = ((((_e1417 * (_e1435.x - _e312)) + (_e1422 * (_e1435.y - _e351))) + (_e1425 * (_e1435.z - _e389))) / (((_e1417 * _e337) + (_e1422 * _e375)) + (_e1425 * _e413)));
                                                                let _e1454 = select(_e1334, _e1452, (_e1452 < _e1334));
                                                                let _e1456 = select(_e1326, _e1454, (_e1454 > _e1326));
                                                                if (_e1456 >= _e463) {
                                                                    let _e1458 = (_e1456 <= _e1004);
                                                                    if _e1458 {
                                                                        let _e1459 = (1f / _e1277);
                                                                        phi_2937_ = type_20(_e1456, (_e1271 * _e1459), (_e1275 * _e1459), _e1066);
                                                                    } else {
                                                                        phi_2937_ = type_20();
                                                                    }
                                                                    let _e1464 = phi_2937_;
                                                                    phi_2939_ = _e1464;
                                                                    phi_2940_ = select(true, false, _e1458);
                                                                } else {
                                                                    phi_2939_ = type_20();
                                                                    phi_2940_ = true;
                                                                }
                                                                let _e1467 = phi_2939_;
                                                                let _e1469 = phi_2940_;
                                                                if _e1469 {
                                                                    phi_2944_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2944_ = _e1467;
                                                                }
                                                                let _e1471 = phi_2944_;
                                                                phi_2945_ = _e1471;
                                                            }
                                                            let _e1473 = phi_2945_;
                                                            phi_2946_ = _e1473;
                                                            phi_2947_ = _e1343;
                                                        }
                                                        let _e1475 = phi_2946_;
                                                        let _e1477 = phi_2947_;
                                                        phi_2951_ = _e1475;
                                                        phi_2952_ = _e1477;
                                                    }
                                                    let _e1479 = phi_2951_;
                                                    let _e1481 = phi_2952_;
                                                    phi_2956_ = _e1479;
                                                    phi_2957_ = _e1481;
                                                } else {
                                                    phi_2956_ = type_20();
                                                    phi_2957_ = true;
                                                }
                                                let _e1483 = phi_2956_;
                                                let _e1485 = phi_2957_;
                                                if _e1485 {
                                                    phi_2961_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2961_ = _e1483;
                                                }
                                                let _e1487 = phi_2961_;
                                                if (_e1487.member_3 != 4294967295u) {
                                                    if (_e1066 != 4294967295u) {
                                                        phi_2973_ = type_8(0u, 8u);
                                                        phi_2976_ = _e1487;
                                                        loop {
                                                            let _e1492 = phi_2973_;
                                                            let _e1494 = phi_2976_;
                                                            if (_e1492.member < _e1492.member_1) {
                                                                phi_2974_ = type_8((_e1492.member + 1u), _e1492.member_1);
                                                                phi_2999_ = type_8(1u, _e1492.member);
                                                            } else {
                                                                phi_2974_ = _e1492;
                                                                phi_2999_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1507 = phi_2974_;
                                                            let _e1509 = phi_2999_;
                                                            let _e1513 = (bitcast<i32>(_e1509.member) != 0i);
                                                            if _e1513 {
                                                                let _e1514 = (_e1509.member_1 < 8u);
                                                                if _e1514 {
                                                                } else {
                                                                    phi_4961_ = true;
                                                                    break;
                                                                }
                                                                let _e1519 = local_2[_e1509.member_1].member;
                                                                if (_e1494.member < _e1519) {
                                                                    phi_3032_ = true;
                                                                } else {
                                                                    let _e1521 = local_2[_e1509.member_1].member;
                                                                    if (_e1494.member == _e1521) {
                                                                        let _e1526 = local_2[_e1509.member_1].member_3;
                                                                        phi_3031_ = (_e1494.member_3 < _e1526);
                                                                    } else {
                                                                        phi_3031_ = false;
                                                                    }
                                                                    let _e1529 = phi_3031_;
                                                                    phi_3032_ = _e1529;
                                                                }
                                                                let _e1531 = phi_3032_;
                                                                if _e1531 {
                                                                    if _e1514 {
                                                                    } else {
                                                                        phi_4961_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1532 = local_2[_e1509.member_1];
                                                                    local_2[_e1509.member_1] = type_20(_e1494.member, _e1494.member_1, _e1494.member_2, _e1494.member_3);
                                                                    phi_3053_ = type_20(_e1532.member, _e1532.member_1, _e1532.member_2, _e1532.member_3);
                                                                } else {
                                                                    phi_3053_ = _e1494;
                                                                }
                                                                let _e1543 = phi_3053_;
                                                                phi_2977_ = _e1543;
                                                            } else {
                                                                phi_2977_ = type_20();
                                                            }
                                                            let _e1545 = phi_2977_;
                                                            continue;
                                                            continuing {
                                                                phi_2973_ = _e1507;
                                                                phi_2976_ = _e1545;
                                                                phi_4961_ = _e1205;
                                                                break if !(_e1513);
                                                            }
                                                        }
                                                        let _e1548 = phi_4961_;
                                                        phi_5182_ = _e1004;
                                                        phi_5020_ = _e1548;
                                                        if _e1548 {
                                                            break;
                                                        }
                                                        let _e1551 = local_2[7u].member_3;
                                                        if (_e1551 != 4294967295u) {
                                                            let _e1555 = local_2[7u].member;
                                                            phi_5245_ = _e1555;
                                                        } else {
                                                            phi_5245_ = _e1004;
                                                        }
                                                        let _e1557 = phi_5245_;
                                                        phi_5244_ = _e1557;
                                                        phi_5023_ = _e1548;
                                                    } else {
                                                        phi_5244_ = _e1004;
                                                        phi_5023_ = _e1205;
                                                    }
                                                    let _e1559 = phi_5244_;
                                                    let _e1561 = phi_5023_;
                                                    phi_5243_ = _e1559;
                                                    phi_5022_ = _e1561;
                                                } else {
                                                    phi_5243_ = _e1004;
                                                    phi_5022_ = _e1205;
                                                }
                                                let _e1563 = phi_5243_;
                                                let _e1565 = phi_5022_;
                                                phi_5242_ = _e1563;
                                                phi_5021_ = _e1565;
                                            } else {
                                                phi_5242_ = _e1004;
                                                phi_5021_ = _e1006;
                                            }
                                            let _e1567 = phi_5242_;
                                            let _e1569 = phi_5021_;
                                            continue;
                                            continuing {
                                                phi_4949_ = _e1567;
                                                phi_4874_ = _e1569;
                                                phi_2030_ = _e1021;
                                                phi_5182_ = _e1567;
                                                phi_5020_ = _e1569;
                                                break if !(_e1027);
                                            }
                                        }
                                        let _e1572 = phi_5182_;
                                        let _e1574 = phi_5020_;
                                        phi_5025_ = _e1574;
                                        if _e1574 {
                                            break;
                                        }
                                        phi_5147_ = _e1572;
                                        phi_5029_ = _e1574;
                                        phi_4403_ = _e534;
                                        phi_4404_ = false;
                                        phi_4405_ = _e538;
                                    } else {
                                        if (_e534.member_1 >= _e92) {
                                            phi_4002_ = type_57(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_54(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e534.member_1 < _e92) {
                                            } else {
                                                phi_5025_ = true;
                                                break;
                                            }
                                            let _e552 = ((1u + (_e263 * 2u)) % 7u);
                                            if (_e552 < 7u) {
                                            } else {
                                                phi_5025_ = true;
                                                break;
                                            }
                                            let _e557 = global_4.member[_e534.member_1][_e552];
                                            let _e560 = ((1u + (_e262 * 2u)) % 7u);
                                            if (_e560 < 7u) {
                                            } else {
                                                phi_5025_ = true;
                                                break;
                                            }
                                            let _e565 = global_4.member[_e534.member_1][_e560];
                                            let _e568 = ((1u + (_e264 * 2u)) % 7u);
                                            if (_e568 < 7u) {
                                            } else {
                                                phi_5025_ = true;
                                                break;
                                            }
                                            let _e573 = global_4.member[_e534.member_1][_e568];
                                            let _e576 = (((_e263 + 1u) * 2u) % 7u);
                                            if (_e576 < 7u) {
                                            } else {
                                                phi_5025_ = true;
                                                break;
                                            }
                                            let _e581 = global_4.member[_e534.member_1][_e576];
                                            let _e584 = (((_e262 + 1u) * 2u) % 7u);
                                            if (_e584 < 7u) {
                                            } else {
                                                phi_5025_ = true;
                                                break;
                                            }
                                            let _e589 = global_4.member[_e534.member_1][_e584];
                                            let _e592 = (((_e264 + 1u) * 2u) % 7u);
                                            if (_e592 < 7u) {
                                            } else {
                                                phi_5025_ = true;
                                                break;
                                            }
                                            let _e597 = global_4.member[_e534.member_1][_e592];
                                            let _e620 = (bitcast<f32>((bitcast<u32>((_e534.member.member_1.x - _e534.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e621 = (bitcast<f32>((bitcast<u32>((_e534.member.member_1.y - _e534.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e622 = (bitcast<f32>((bitcast<u32>((_e534.member.member_1.z - _e534.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e624 = select(_e143, _e620, (_e620 > _e143));
                                            let _e626 = select(_e143, _e621, (_e621 > _e143));
                                            let _e628 = select(_e143, _e622, (_e622 > _e143));
                                            let _e653 = bitcast<u32>((f32(bitcast<i32>((_e557 & 2097151u))) * _e624));
                                            let _e658 = (bitcast<i32>((_e557 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e661 = bitcast<f32>((_e653 & bitcast<u32>(_e658)));
                                            let _e662 = bitcast<u32>((f32(bitcast<i32>((_e565 & 2097151u))) * _e626));
                                            let _e667 = (bitcast<i32>((_e565 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e670 = bitcast<f32>((_e662 & bitcast<u32>(_e667)));
                                            let _e671 = bitcast<u32>((f32(bitcast<i32>((_e573 & 2097151u))) * _e628));
                                            let _e676 = (bitcast<i32>((_e573 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e679 = bitcast<f32>((_e671 & bitcast<u32>(_e676)));
                                            let _e683 = bitcast<f32>((_e653 & bitcast<u32>(~(_e658))));
                                            let _e687 = bitcast<f32>((_e662 & bitcast<u32>(~(_e667))));
                                            let _e691 = bitcast<f32>((_e671 & bitcast<u32>(~(_e676))));
                                            let _e692 = bitcast<u32>((f32(bitcast<i32>((_e581 & 2097151u))) * _e624));
                                            let _e697 = (bitcast<i32>((_e581 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e700 = bitcast<f32>((_e692 & bitcast<u32>(_e697)));
                                            let _e701 = bitcast<u32>((f32(bitcast<i32>((_e589 & 2097151u))) * _e626));
                                            let _e706 = (bitcast<i32>((_e589 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e709 = bitcast<f32>((_e701 & bitcast<u32>(_e706)));
                                            let _e710 = bitcast<u32>((f32(bitcast<i32>((_e597 & 2097151u))) * _e628));
                                            let _e715 = (bitcast<i32>((_e597 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e718 = bitcast<f32>((_e710 & bitcast<u32>(_e715)));
                                            let _e722 = bitcast<f32>((_e692 & bitcast<u32>(~(_e697))));
                                            let _e726 = bitcast<f32>((_e701 & bitcast<u32>(~(_e706))));
                                            let _e730 = bitcast<f32>((_e710 & bitcast<u32>(~(_e715))));
                                            let _e731 = (_e534.member.member.x + _e661);
                                            let _e732 = (_e534.member.member.y + _e670);
                                            let _e733 = (_e534.member.member.z + _e679);
                                            let _e736 = (_e534.member.member_1.x - _e700);
                                            let _e737 = (_e534.member.member_1.y - _e709);
                                            let _e738 = (_e534.member.member_1.z - _e718);
                                            let _e757 = (_e736 - _e731);
                                            let _e758 = (_e737 - _e732);
                                            let _e759 = (_e738 - _e733);
                                            let _e761 = select(_e758, _e757, (_e757 > _e758));
                                            let _e763 = select(_e759, _e761, (_e761 > _e759));
                                            if (_e763 < (1024f * _e143)) {
                                                phi_3703_ = 0u;
                                            } else {
                                                phi_3703_ = select(2u, 1u, (_e763 < (2097152f * _e143)));
                                            }
                                            let _e770 = phi_3703_;
                                            switch bitcast<i32>(_e770) {
                                                case 0: {
                                                    phi_3709_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3709_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3709_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3709_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e773 = phi_3709_;
                                            let _e779 = global_4.member[_e534.member_1][0u];
                                            let _e783 = global_4.member[_e534.member_1][2u];
                                            let _e787 = global_4.member[_e534.member_1][4u];
                                            let _e791 = global_4.member[_e534.member_1][6u];
                                            let _e803 = (((_e783 >> bitcast<u32>(22i)) | ((_e787 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e791 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e804 = (_e779 & 268435455u);
                                            let _e805 = (_e803 & 268435455u);
                                            let _e808 = ((_e779 >> bitcast<u32>(28u)) & 7u);
                                            let _e816 = ((_e779 >> bitcast<u32>(31i)) | (((_e803 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e817 = (_e808 != 0u);
                                            if (_e808 == 0u) {
                                                phi_3964_ = _e804;
                                            } else {
                                                if (_e808 == 7u) {
                                                    phi_3963_ = 2147483648u;
                                                } else {
                                                    phi_3963_ = ((2147483648u | (_e808 << bitcast<u32>(28u))) | (_e805 & 268435455u));
                                                }
                                                let _e826 = phi_3963_;
                                                phi_3964_ = _e826;
                                            }
                                            let _e828 = phi_3964_;
                                            if _e817 {
                                                let _e829 = (_e808 != 7u);
                                                if _e829 {
                                                    phi_3974_ = (_e805 + (_e808 * ((3u * _e773) + 1u)));
                                                } else {
                                                    phi_3974_ = u32();
                                                }
                                                let _e833 = phi_3974_;
                                                phi_3976_ = _e833;
                                                phi_3977_ = select(true, false, _e829);
                                            } else {
                                                phi_3976_ = u32();
                                                phi_3977_ = true;
                                            }
                                            let _e836 = phi_3976_;
                                            let _e838 = phi_3977_;
                                            if (_e816 == 0u) {
                                                phi_3998_ = (_e804 + select(0u, 1u, !(_e817)));
                                            } else {
                                                if (_e816 == 7u) {
                                                    phi_3997_ = 2147483648u;
                                                } else {
                                                    phi_3997_ = ((2147483648u | (_e816 << bitcast<u32>(28u))) | (select(_e836, _e805, _e838) & 268435455u));
                                                }
                                                let _e851 = phi_3997_;
                                                phi_3998_ = _e851;
                                            }
                                            let _e853 = phi_3998_;
                                            phi_4002_ = type_57(array<vec4<f32>, 3>(vec4<f32>(_e731, (_e534.member.member.x + _e683), _e736, (_e534.member.member_1.x - _e722)), vec4<f32>(_e732, (_e534.member.member.y + _e687), _e737, (_e534.member.member_1.y - _e726)), vec4<f32>(_e733, (_e534.member.member.z + _e691), _e738, (_e534.member.member_1.z - _e730))), type_54(type_24((_e534.member.member + vec4<f32>(_e661, _e670, _e679, 0f)), (_e534.member.member_1 - vec4<f32>(_e700, _e709, _e718, 0f))), _e828), type_54(type_24((_e534.member.member + vec4<f32>(_e683, _e687, _e691, 0f)), (_e534.member.member_1 - vec4<f32>(_e722, _e726, _e730, 0f))), _e853));
                                        }
                                        let _e858 = phi_4002_;
                                        let _e869 = ((_e858.member[0].x - _e335) * _e340);
                                        let _e870 = ((_e858.member[0].y - _e335) * _e340);
                                        let _e871 = ((_e858.member[0].z - _e336) * _e340);
                                        let _e872 = ((_e858.member[0].w - _e336) * _e340);
                                        let _e882 = ((_e858.member[1].x - _e373) * _e378);
                                        let _e883 = ((_e858.member[1].y - _e373) * _e378);
                                        let _e884 = ((_e858.member[1].z - _e374) * _e378);
                                        let _e885 = ((_e858.member[1].w - _e374) * _e378);
                                        let _e895 = ((_e858.member[2].x - _e411) * _e416);
                                        let _e896 = ((_e858.member[2].y - _e411) * _e416);
                                        let _e897 = ((_e858.member[2].z - _e412) * _e416);
                                        let _e898 = ((_e858.member[2].w - _e412) * _e416);
                                        let _e900 = select(_e897, _e895, (_e895 < _e897));
                                        let _e902 = select(_e898, _e896, (_e896 < _e898));
                                        let _e904 = select(_e897, _e895, (_e895 > _e897));
                                        let _e906 = select(_e898, _e896, (_e896 > _e898));
                                        let _e908 = select(_e871, _e869, (_e869 < _e871));
                                        let _e910 = select(_e872, _e870, (_e870 < _e872));
                                        let _e912 = select(_e884, _e882, (_e882 < _e884));
                                        let _e914 = select(_e885, _e883, (_e883 < _e885));
                                        let _e916 = select(_e912, _e908, (_e908 > _e912));
                                        let _e918 = select(_e914, _e910, (_e910 > _e914));
                                        let _e920 = select(_e900, _e916, (_e916 > _e900));
                                        let _e922 = select(_e902, _e918, (_e918 > _e902));
                                        let _e924 = select(_e871, _e869, (_e869 > _e871));
                                        let _e926 = select(_e872, _e870, (_e870 > _e872));
                                        let _e928 = select(_e884, _e882, (_e882 > _e884));
                                        let _e930 = select(_e885, _e883, (_e883 > _e885));
                                        let _e932 = select(_e928, _e924, (_e924 < _e928));
                                        let _e934 = select(_e930, _e926, (_e926 < _e930));
                                        let _e939 = -(_e900);
                                        let _e940 = -(_e902);
                                        let _e947 = (select(_e904, _e932, (_e932 < _e904)) + (select(_e939, _e904, (_e904 > _e939)) * 0.0000019073523f));
                                        let _e948 = (select(_e906, _e934, (_e934 < _e906)) + (select(_e940, _e906, (_e906 > _e940)) * 0.0000019073523f));
                                        let _e950 = select(_e463, _e920, (_e920 > _e463));
                                        let _e952 = select(_e463, _e922, (_e922 > _e463));
                                        let _e957 = (_e950 <= select(_e506, _e947, (_e947 < _e506)));
                                        let _e958 = (_e952 <= select(_e506, _e948, (_e948 < _e506)));
                                        let _e959 = (_e950 <= _e952);
                                        if _e957 {
                                            if _e958 {
                                                if _e959 {
                                                    phi_4347_ = _e858.member_2;
                                                } else {
                                                    phi_4347_ = _e858.member_1;
                                                }
                                                let _e963 = phi_4347_;
                                                let _e964 = (_e538 % 128u);
                                                let _e965 = (_e964 < 128u);
                                                if _e965 {
                                                } else {
                                                    phi_5025_ = true;
                                                    break;
                                                }
                                                local_4[_e964] = type_54(type_24(_e963.member.member, _e963.member.member_1), _e963.member_1);
                                                if _e965 {
                                                } else {
                                                    phi_5025_ = true;
                                                    break;
                                                }
                                                local_3[_e964] = select(_e952, _e950, (_e950 > _e952));
                                                if _e959 {
                                                    phi_4380_ = _e858.member_1;
                                                } else {
                                                    phi_4380_ = _e858.member_2;
                                                }
                                                let _e980 = phi_4380_;
                                                phi_4381_ = _e980;
                                                phi_4382_ = (_e538 + 1u);
                                            } else {
                                                phi_4381_ = type_54();
                                                phi_4382_ = u32();
                                            }
                                            let _e982 = phi_4381_;
                                            let _e984 = phi_4382_;
                                            phi_4384_ = _e982;
                                            phi_4385_ = _e984;
                                            phi_4386_ = select(true, false, _e958);
                                        } else {
                                            phi_4384_ = type_54();
                                            phi_4385_ = u32();
                                            phi_4386_ = true;
                                        }
                                        let _e987 = phi_4384_;
                                        let _e989 = phi_4385_;
                                        let _e991 = phi_4386_;
                                        if _e991 {
                                            if _e957 {
                                                phi_4395_ = _e858.member_1;
                                            } else {
                                                phi_4395_ = _e858.member_2;
                                            }
                                            let _e995 = phi_4395_;
                                            phi_4400_ = _e995;
                                            phi_4401_ = select(_e958, true, _e957);
                                        } else {
                                            phi_4400_ = _e987;
                                            phi_4401_ = _e536;
                                        }
                                        let _e998 = phi_4400_;
                                        let _e1000 = phi_4401_;
                                        phi_5147_ = _e506;
                                        phi_5029_ = _e504;
                                        phi_4403_ = _e998;
                                        phi_4404_ = _e1000;
                                        phi_4405_ = select(_e989, _e538, _e991);
                                    }
                                    let _e1576 = phi_5147_;
                                    let _e1578 = phi_5029_;
                                    let _e1580 = phi_4403_;
                                    let _e1582 = phi_4404_;
                                    let _e1584 = phi_4405_;
                                    phi_5146_ = _e1576;
                                    phi_5028_ = _e1578;
                                    phi_4406_ = _e1580;
                                    phi_4407_ = (_e510 - 1u);
                                    phi_4408_ = _e1582;
                                    phi_4409_ = _e1584;
                                } else {
                                    phi_5146_ = _e506;
                                    phi_5028_ = _e504;
                                    phi_4406_ = _e534;
                                    phi_4407_ = _e510;
                                    phi_4408_ = _e536;
                                    phi_4409_ = _e538;
                                }
                                let _e1586 = phi_5146_;
                                let _e1588 = phi_5028_;
                                let _e1590 = phi_4406_;
                                let _e1592 = phi_4407_;
                                let _e1594 = phi_4408_;
                                let _e1596 = phi_4409_;
                                phi_5145_ = _e1586;
                                phi_5027_ = _e1588;
                                phi_4410_ = _e1590;
                                phi_4411_ = _e1592;
                                phi_4412_ = _e1594;
                                phi_4413_ = _e1596;
                            } else {
                                phi_5145_ = _e506;
                                phi_5027_ = _e504;
                                phi_4410_ = type_54();
                                phi_4411_ = u32();
                                phi_4412_ = bool();
                                phi_4413_ = u32();
                            }
                            let _e1598 = phi_5145_;
                            let _e1600 = phi_5027_;
                            let _e1602 = phi_4410_;
                            let _e1604 = phi_4411_;
                            let _e1606 = phi_4412_;
                            let _e1608 = phi_4413_;
                            phi_5144_ = _e1598;
                            phi_5026_ = _e1600;
                            phi_1954_ = _e1602;
                            phi_1957_ = _e1604;
                            phi_1959_ = _e1606;
                            phi_1961_ = _e1608;
                            phi_4414_ = _e518;
                        } else {
                            phi_5144_ = _e506;
                            phi_5026_ = _e504;
                            phi_1954_ = type_54();
                            phi_1957_ = u32();
                            phi_1959_ = bool();
                            phi_1961_ = u32();
                            phi_4414_ = false;
                        }
                        let _e1610 = phi_5144_;
                        let _e1612 = phi_5026_;
                        let _e1614 = phi_1954_;
                        let _e1616 = phi_1957_;
                        let _e1618 = phi_1959_;
                        let _e1620 = phi_1961_;
                        let _e1622 = phi_4414_;
                        continue;
                        continuing {
                            phi_4877_ = _e1612;
                            phi_4776_ = _e1610;
                            phi_1953_ = _e1614;
                            phi_1956_ = _e1616;
                            phi_1958_ = _e1618;
                            phi_1960_ = _e1620;
                            phi_5025_ = _e1612;
                            break if !(_e1622);
                        }
                    }
                    let _e1625 = phi_5025_;
                    if _e1625 {
                        break;
                    }
                    phi_4421_ = type_8(0u, 8u);
                    loop {
                        let _e1627 = phi_4421_;
                        if (_e1627.member < _e1627.member_1) {
                            phi_4422_ = type_8((_e1627.member + 1u), _e1627.member_1);
                            phi_4445_ = type_8(1u, _e1627.member);
                        } else {
                            phi_4422_ = _e1627;
                            phi_4445_ = type_8(0u, type_8().member_1);
                        }
                        let _e1640 = phi_4422_;
                        let _e1642 = phi_4445_;
                        let _e1646 = (bitcast<i32>(_e1642.member) != 0i);
                        if _e1646 {
                            let _e1647 = (_e1642.member_1 < 8u);
                            if _e1647 {
                            } else {
                                phi_5137_ = true;
                                break;
                            }
                            let _e1649 = local_2[_e1642.member_1];
                            if (_e1649.member_3 != 4294967295u) {
                                let _e1655 = -(_e430);
                                let _e1656 = (_e1655 / 3i);
                                let _e1663 = bitcast<f32>((bitcast<u32>((_e1656 + 127i)) << bitcast<u32>(23i)));
                                let _e1671 = (((_e1649.member * _e1663) * _e1663) * bitcast<f32>((bitcast<u32>(((_e1655 - (2i * _e1656)) + 127i)) << bitcast<u32>(23i))));
                                let _e1673 = select(340282350000000000000000000000000000000f, _e1671, (_e1671 < 340282350000000000000000000000000000000f));
                                phi_4511_ = type_20(select(-340282350000000000000000000000000000000f, _e1673, (_e1673 > -340282350000000000000000000000000000000f)), _e1649.member_1, _e1649.member_2, _e1649.member_3);
                            } else {
                                phi_4511_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1678 = phi_4511_;
                            if _e1647 {
                            } else {
                                phi_5137_ = true;
                                break;
                            }
                            local_2[_e1642.member_1] = type_20(_e1678.member, _e1678.member_1, _e1678.member_2, _e1678.member_3);
                        }
                        continue;
                        continuing {
                            phi_4421_ = _e1640;
                            phi_5137_ = _e1625;
                            break if !(_e1646);
                        }
                    }
                    let _e1686 = phi_5137_;
                    if _e1686 {
                        break;
                    }
                    let _e1687 = local_2;
                    if _e151 {
                    } else {
                        break;
                    }
                    global_6.member[_e149] = array<type_20, 8>(type_20(_e1687[0].member, _e1687[0].member_1, _e1687[0].member_2, _e1687[0].member_3), type_20(_e1687[1].member, _e1687[1].member_1, _e1687[1].member_2, _e1687[1].member_3), type_20(_e1687[2].member, _e1687[2].member_1, _e1687[2].member_2, _e1687[2].member_3), type_20(_e1687[3].member, _e1687[3].member_1, _e1687[3].member_2, _e1687[3].member_3), type_20(_e1687[4].member, _e1687[4].member_1, _e1687[4].member_2, _e1687[4].member_3), type_20(_e1687[5].member, _e1687[5].member_1, _e1687[5].member_2, _e1687[5].member_3), type_20(_e1687[6].member, _e1687[6].member_1, _e1687[6].member_2, _e1687[6].member_3), type_20(_e1687[7].member, _e1687[7].member_1, _e1687[7].member_2, _e1687[7].member_3));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_nearest_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
