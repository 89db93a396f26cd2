struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_19 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_21 {
    member: array<type_19>,
}

struct type_23 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_24 {
    member: type_23,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_26 {
    member: array<type_24>,
}

struct type_34 {
    member: type_19,
    member_1: f32,
}

struct type_36 {
    member: type_34,
    member_1: u32,
    member_2: u32,
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

struct type_45 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_47 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_49 {
    member: array<type_47>,
}

struct type_53 {
    member: type_45,
    member_1: u32,
}

struct type_58 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(4) 
var<storage, read_write> global_1: type_21;
@group(0) @binding(0) 
var<uniform> global_2: type_38;
@group(0) @binding(3) 
var<storage> global_3: type_26;
@group(0) @binding(5) 
var<storage, read_write> global_4: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_5: type_58;
@group(0) @binding(1) 
var<storage> global_6: type_42;
@group(0) @binding(2) 
var<storage> global_7: type_49;

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
    var phi_346_: i32;
    var phi_347_: i32;
    var phi_357_: bool;
    var phi_367_: u32;
    var phi_368_: u32;
    var phi_370_: bool;
    var phi_375_: u32;
    var phi_407_: i32;
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
    var phi_3287_: bool;
    var phi_797_: type_36;
    var phi_800_: type_53;
    var phi_802_: u32;
    var phi_804_: bool;
    var phi_806_: u32;
    var phi_817_: bool;
    var phi_903_: type_53;
    var phi_904_: bool;
    var phi_905_: u32;
    var phi_2126_: type_40;
    var phi_2958_: type_53;
    var phi_3035_: type_53;
    var phi_3036_: type_53;
    var phi_3037_: u32;
    var phi_3039_: type_53;
    var phi_3040_: u32;
    var phi_3041_: bool;
    var phi_3048_: type_53;
    var phi_3053_: type_53;
    var phi_3054_: bool;
    var phi_924_: type_36;
    var phi_927_: type_7;
    var phi_928_: type_7;
    var phi_950_: type_7;
    var phi_978_: u32;
    var phi_994_: type_47;
    var phi_1370_: bool;
    var phi_1399_: bool;
    var phi_1776_: f32;
    var phi_1777_: f32;
    var phi_1778_: f32;
    var phi_1779_: f32;
    var phi_1780_: vec3<f32>;
    var phi_1781_: vec3<f32>;
    var phi_1782_: vec3<f32>;
    var phi_1783_: vec3<f32>;
    var phi_1814_: bool;
    var phi_1823_: vec3<f32>;
    var phi_1988_: f32;
    var phi_1990_: f32;
    var phi_1991_: bool;
    var phi_2011_: f32;
    var phi_2012_: f32;
    var phi_2035_: type_19;
    var phi_2037_: type_19;
    var phi_2038_: bool;
    var phi_2042_: type_19;
    var phi_2043_: type_19;
    var phi_2044_: type_19;
    var phi_2045_: bool;
    var phi_2049_: type_19;
    var phi_2050_: bool;
    var phi_2051_: type_19;
    var phi_2052_: bool;
    var phi_2053_: bool;
    var phi_2054_: type_19;
    var phi_2055_: bool;
    var phi_2056_: bool;
    var phi_2064_: type_19;
    var phi_2065_: bool;
    var phi_2069_: type_19;
    var phi_2094_: bool;
    var phi_2095_: bool;
    var phi_2102_: type_36;
    var phi_2103_: type_36;
    var phi_2104_: type_36;
    var phi_925_: type_36;
    var phi_3281_: bool;
    var phi_3445_: bool;
    var phi_3056_: type_36;
    var phi_3057_: type_53;
    var phi_3058_: bool;
    var phi_3059_: u32;
    var phi_3444_: bool;
    var phi_3060_: type_36;
    var phi_3061_: type_53;
    var phi_3062_: u32;
    var phi_3063_: bool;
    var phi_3064_: u32;
    var phi_3443_: bool;
    var phi_3065_: type_36;
    var phi_3066_: type_53;
    var phi_3067_: u32;
    var phi_3068_: bool;
    var phi_3069_: u32;
    var phi_3442_: bool;
    var phi_798_: type_36;
    var phi_801_: type_53;
    var phi_803_: u32;
    var phi_805_: bool;
    var phi_807_: u32;
    var phi_3070_: bool;
    var phi_3441_: bool;
    var local_10: type_36;
    var phi_3122_: type_19;
    var local_11: type_36;
    var local_12: type_36;

    switch bitcast<i32>(0u) {
        default: {
            let _e78 = global;
            let _e81 = arrayLength((&global_6.member));
            let _e92 = arrayLength((&global_5.member));
            let _e96 = global_2.member[0u][0u];
            let _e100 = global_2.member[0u][1u];
            let _e104 = global_2.member[0u][2u];
            let _e108 = global_2.member[1u][0u];
            let _e112 = global_2.member[1u][1u];
            let _e116 = global_2.member[1u][2u];
            let _e120 = global_2.member[1u][3u];
            let _e124 = (_e78.x + (_e78.y * 2097152u));
            let _e131 = (_e124 < arrayLength((&global_3.member)));
            if _e131 {
                let _e132 = (_e124 < arrayLength((&global_1.member)));
                if _e132 {
                    let _e133 = (_e124 < arrayLength((&global_4.member)));
                    if _e133 {
                        if _e131 {
                        } else {
                            break;
                        }
                        let _e143 = global_3.member[_e124].member.member_2[0u];
                        let _e145 = (bitcast<u32>(_e143) & 2147483647u);
                        let _e151 = global_3.member[_e124].member.member_2[1u];
                        let _e153 = (bitcast<u32>(_e151) & 2147483647u);
                        let _e159 = global_3.member[_e124].member.member_2[2u];
                        let _e161 = (bitcast<u32>(_e159) & 2147483647u);
                        let _e167 = global_3.member[_e124].member.member[0u];
                        let _e169 = (bitcast<u32>(_e167) & 2147483647u);
                        let _e175 = global_3.member[_e124].member.member[1u];
                        let _e177 = (bitcast<u32>(_e175) & 2147483647u);
                        let _e183 = global_3.member[_e124].member.member[2u];
                        let _e185 = (bitcast<u32>(_e183) & 2147483647u);
                        let _e187 = select(_e153, _e145, (_e153 < _e145));
                        let _e189 = select(_e161, _e187, (_e161 < _e187));
                        let _e191 = select(_e169, _e189, (_e169 < _e189));
                        let _e193 = select(_e177, _e191, (_e177 < _e191));
                        let _e195 = select(_e185, _e193, (_e185 < _e193));
                        let _e200 = global_3.member[_e124].member.member_1;
                        let _e202 = (bitcast<u32>(_e200) & 2147483647u);
                        let _e210 = global_3.member[_e124].member.member_3;
                        let _e216 = (((select(_e202, _e195, (_e202 < _e195)) < 2139095040u) && ((bitcast<u32>(_e210) & 2147483647u) <= 2139095040u)) && (_e189 > 0u));
                        if _e216 {
                            let _e219 = (bitcast<u32>(bitcast<f32>(_e189)) & 2147483647u);
                            if (_e219 >= 8388608u) {
                                phi_346_ = (bitcast<i32>((_e219 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_346_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e219)), 32u, (_e219 == 0u))));
                            }
                            let _e233 = phi_346_;
                            phi_347_ = _e233;
                        } else {
                            phi_347_ = 0i;
                        }
                        let _e235 = phi_347_;
                        let _e236 = (_e145 == _e189);
                        if _e236 {
                            phi_357_ = true;
                        } else {
                            phi_357_ = (_e153 == _e189);
                        }
                        let _e239 = phi_357_;
                        let _e240 = select(1u, 0u, _e236);
                        if _e239 {
                            let _e241 = (_e240 + 1u);
                            phi_367_ = _e241;
                            phi_368_ = _e241;
                            phi_370_ = select(true, false, (_e241 == 2u));
                        } else {
                            phi_367_ = u32();
                            phi_368_ = 0u;
                            phi_370_ = true;
                        }
                        let _e245 = phi_367_;
                        let _e247 = phi_368_;
                        let _e249 = phi_370_;
                        if _e249 {
                            phi_375_ = (_e247 + 1u);
                        } else {
                            phi_375_ = 0u;
                        }
                        let _e253 = phi_375_;
                        let _e254 = select(_e245, _e247, _e249);
                        let _e255 = select(_e240, select(2u, _e240, _e239), _e249);
                        let _e256 = -(_e235);
                        if (_e256 < -126i) {
                            phi_407_ = -126i;
                        } else {
                            phi_407_ = select(_e256, 127i, (_e256 > 127i));
                        }
                        let _e261 = phi_407_;
                        let _e266 = bitcast<f32>((bitcast<u32>((_e261 + 127i)) << bitcast<u32>(23i)));
                        let _e272 = bitcast<f32>((bitcast<u32>(((_e256 - _e261) + 127i)) << bitcast<u32>(23i)));
                        let _e277 = global_3.member[_e124].member.member;
                        let _e278 = (_e254 == 0u);
                        if _e278 {
                            phi_425_ = _e277[0];
                        } else {
                            phi_425_ = _e277[1];
                        }
                        let _e282 = phi_425_;
                        let _e283 = (_e254 == 2u);
                        if _e283 {
                            phi_431_ = _e277[2];
                        } else {
                            phi_431_ = _e282;
                        }
                        let _e286 = phi_431_;
                        let _e287 = global_3.member[_e124].member.member_2;
                        if _e278 {
                            phi_442_ = _e287[0];
                        } else {
                            phi_442_ = _e287[1];
                        }
                        let _e291 = phi_442_;
                        if _e283 {
                            phi_448_ = _e287[2];
                        } else {
                            phi_448_ = _e291;
                        }
                        let _e294 = phi_448_;
                        let _e296 = ((_e294 * _e266) * _e272);
                        let _e300 = (bitcast<f32>((bitcast<u32>(_e296) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e300 {
                            let _e304 = (bitcast<f32>((bitcast<u32>(_e286) & 2147483647u)) * 0.00000011920929f);
                            phi_471_ = select(0.00000000000011368684f, _e304, (_e304 > 0.00000000000011368684f));
                        } else {
                            phi_471_ = 0f;
                        }
                        let _e308 = phi_471_;
                        let _e309 = (_e286 + _e308);
                        let _e310 = (_e286 - _e308);
                        let _e311 = select(_e296, 0f, _e300);
                        if _e300 {
                            phi_482_ = 38685626000000000000000000f;
                        } else {
                            phi_482_ = (1f / _e296);
                        }
                        let _e314 = phi_482_;
                        let _e315 = (_e253 == 0u);
                        if _e315 {
                            phi_491_ = _e277[0];
                        } else {
                            phi_491_ = _e277[1];
                        }
                        let _e319 = phi_491_;
                        let _e320 = (_e253 == 2u);
                        if _e320 {
                            phi_497_ = _e277[2];
                        } else {
                            phi_497_ = _e319;
                        }
                        let _e323 = phi_497_;
                        if _e315 {
                            phi_508_ = _e287[0];
                        } else {
                            phi_508_ = _e287[1];
                        }
                        let _e327 = phi_508_;
                        if _e320 {
                            phi_514_ = _e287[2];
                        } else {
                            phi_514_ = _e327;
                        }
                        let _e330 = phi_514_;
                        let _e332 = ((_e330 * _e266) * _e272);
                        let _e336 = (bitcast<f32>((bitcast<u32>(_e332) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e336 {
                            let _e340 = (bitcast<f32>((bitcast<u32>(_e323) & 2147483647u)) * 0.00000011920929f);
                            phi_537_ = select(0.00000000000011368684f, _e340, (_e340 > 0.00000000000011368684f));
                        } else {
                            phi_537_ = 0f;
                        }
                        let _e344 = phi_537_;
                        let _e345 = (_e323 + _e344);
                        let _e346 = (_e323 - _e344);
                        let _e347 = select(_e332, 0f, _e336);
                        if _e336 {
                            phi_548_ = 38685626000000000000000000f;
                        } else {
                            phi_548_ = (1f / _e332);
                        }
                        let _e350 = phi_548_;
                        let _e351 = (_e255 == 0u);
                        if _e351 {
                            phi_557_ = _e277[0];
                        } else {
                            phi_557_ = _e277[1];
                        }
                        let _e355 = phi_557_;
                        let _e356 = (_e255 == 2u);
                        if _e356 {
                            phi_563_ = _e277[2];
                        } else {
                            phi_563_ = _e355;
                        }
                        let _e359 = phi_563_;
                        if _e351 {
                            phi_574_ = _e287[0];
                        } else {
                            phi_574_ = _e287[1];
                        }
                        let _e363 = phi_574_;
                        if _e356 {
                            phi_580_ = _e287[2];
                        } else {
                            phi_580_ = _e363;
                        }
                        let _e366 = phi_580_;
                        let _e368 = ((_e366 * _e266) * _e272);
                        let _e372 = (bitcast<f32>((bitcast<u32>(_e368) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e372 {
                            let _e376 = (bitcast<f32>((bitcast<u32>(_e359) & 2147483647u)) * 0.00000011920929f);
                            phi_603_ = select(0.00000000000011368684f, _e376, (_e376 > 0.00000000000011368684f));
                        } else {
                            phi_603_ = 0f;
                        }
                        let _e380 = phi_603_;
                        let _e381 = (_e359 + _e380);
                        let _e382 = (_e359 - _e380);
                        let _e383 = select(_e368, 0f, _e372);
                        if _e372 {
                            phi_614_ = 38685626000000000000000000f;
                        } else {
                            phi_614_ = (1f / _e368);
                        }
                        let _e386 = phi_614_;
                        let _e389 = bitcast<f32>((bitcast<u32>(_e286) & 2147483647u));
                        let _e392 = bitcast<f32>((bitcast<u32>(_e323) & 2147483647u));
                        let _e394 = select(_e392, _e389, (_e389 > _e392));
                        let _e397 = bitcast<f32>((bitcast<u32>(_e359) & 2147483647u));
                        if (_e216 && (select(_e397, _e394, (_e394 > _e397)) <= 1099511600000f)) {
                            let _e402 = (_e235 / 3i);
                            let _e409 = bitcast<f32>((bitcast<u32>((_e402 + 127i)) << bitcast<u32>(23i)));
                            let _e416 = bitcast<f32>((bitcast<u32>(((_e235 - (2i * _e402)) + 127i)) << bitcast<u32>(23i)));
                            let _e417 = (((_e200 * _e409) * _e409) * _e416);
                            let _e419 = select(340282350000000000000000000000000000000f, _e417, (_e417 < 340282350000000000000000000000000000000f));
                            let _e424 = (((_e210 * _e409) * _e409) * _e416);
                            let _e426 = select(340282350000000000000000000000000000000f, _e424, (_e424 < 340282350000000000000000000000000000000f));
                            phi_714_ = select(-340282350000000000000000000000000000000f, _e426, (_e426 > -340282350000000000000000000000000000000f));
                            phi_715_ = select(-340282350000000000000000000000000000000f, _e419, (_e419 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_714_ = 0f;
                            phi_715_ = 1f;
                        }
                        let _e430 = phi_714_;
                        let _e432 = phi_715_;
                        if _e131 {
                        } else {
                            break;
                        }
                        let _e438 = global_3.member[_e124].member_2;
                        local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 3>(bitcast<f32>(_e96), bitcast<f32>(_e100), bitcast<f32>(_e104));
                        let _e442 = (_e254 % 3u);
                        let _e443 = (_e442 < 3u);
                        if _e443 {
                        } else {
                            break;
                        }
                        let _e445 = local_9[_e442];
                        let _e446 = (_e253 % 3u);
                        let _e447 = (_e446 < 3u);
                        if _e447 {
                        } else {
                            break;
                        }
                        let _e449 = local_9[_e446];
                        let _e450 = (_e255 % 3u);
                        let _e451 = (_e450 < 3u);
                        if _e451 {
                        } else {
                            break;
                        }
                        let _e453 = local_9[_e450];
                        local_8 = array<f32, 3>(bitcast<f32>(_e108), bitcast<f32>(_e112), bitcast<f32>(_e116));
                        if _e443 {
                        } else {
                            break;
                        }
                        let _e457 = local_8[_e442];
                        if _e447 {
                        } else {
                            break;
                        }
                        let _e459 = local_8[_e446];
                        if _e451 {
                        } else {
                            break;
                        }
                        let _e461 = local_8[_e450];
                        phi_3287_ = false;
                        phi_797_ = type_36(type_34(type_19(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e430), 0u, 0u);
                        phi_800_ = type_53(type_45(array<f32, 3>(_e445, _e449, _e453), array<f32, 3>(_e457, _e459, _e461)), select(0u, 2147483648u, (_e81 == 0u)));
                        phi_802_ = ((3u * _e81) + 1u);
                        phi_804_ = (_e432 <= _e430);
                        phi_806_ = 0u;
                        loop {
                            let _e469 = phi_3287_;
                            let _e471 = phi_797_;
                            let _e473 = phi_800_;
                            let _e475 = phi_802_;
                            let _e477 = phi_804_;
                            let _e479 = phi_806_;
                            local_10 = _e471;
                            local_11 = _e471;
                            if _e477 {
                                phi_817_ = true;
                            } else {
                                phi_817_ = (_e479 > 0u);
                            }
                            let _e482 = phi_817_;
                            if _e482 {
                                let _e483 = (_e475 > 0u);
                                if _e483 {
                                    if _e477 {
                                        phi_903_ = _e473;
                                        phi_904_ = _e477;
                                        phi_905_ = _e479;
                                    } else {
                                        let _e484 = (_e479 - 1u);
                                        let _e485 = (_e484 % 128u);
                                        let _e486 = (_e485 < 128u);
                                        if _e486 {
                                        } else {
                                            phi_3441_ = true;
                                            break;
                                        }
                                        let _e488 = local_6[_e485];
                                        if _e486 {
                                        } else {
                                            phi_3441_ = true;
                                            break;
                                        }
                                        let _e490 = local_5[_e485];
                                        if _e486 {
                                        } else {
                                            phi_3441_ = true;
                                            break;
                                        }
                                        let _e492 = local_4[_e485];
                                        if _e486 {
                                        } else {
                                            phi_3441_ = true;
                                            break;
                                        }
                                        let _e494 = local_3[_e485];
                                        if _e486 {
                                        } else {
                                            phi_3441_ = true;
                                            break;
                                        }
                                        let _e497 = local_2[_e485];
                                        if _e486 {
                                        } else {
                                            phi_3441_ = true;
                                            break;
                                        }
                                        let _e499 = local_1[_e485];
                                        if _e486 {
                                        } else {
                                            phi_3441_ = true;
                                            break;
                                        }
                                        let _e501 = local[_e485];
                                        if _e486 {
                                        } else {
                                            phi_3441_ = true;
                                            break;
                                        }
                                        let _e506 = local_7[_e485];
                                        phi_903_ = type_53(type_45(array<f32, 3>(_e490, _e492, _e494), array<f32, 3>(_e497, _e499, _e501)), _e488);
                                        phi_904_ = (_e506 <= _e471.member.member_1);
                                        phi_905_ = _e484;
                                    }
                                    let _e511 = phi_903_;
                                    let _e513 = phi_904_;
                                    let _e515 = phi_905_;
                                    if _e513 {
                                        if ((_e511.member_1 & 2147483648u) != 0u) {
                                            phi_924_ = _e471;
                                            phi_927_ = type_7(0u, ((_e511.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e875 = phi_924_;
                                                let _e877 = phi_927_;
                                                local_12 = _e875;
                                                if (_e877.member < _e877.member_1) {
                                                    phi_928_ = type_7((_e877.member + 1u), _e877.member_1);
                                                    phi_950_ = type_7(1u, _e877.member);
                                                } else {
                                                    phi_928_ = _e877;
                                                    phi_950_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e890 = phi_928_;
                                                let _e892 = phi_950_;
                                                let _e896 = (bitcast<i32>(_e892.member) != 0i);
                                                if _e896 {
                                                    let _e902 = type_36(_e875.member, _e875.member_1, (_e875.member_2 + 1u));
                                                    let _e903 = ((_e511.member_1 & 268435455u) + _e892.member_1);
                                                    let _e904 = (_e903 < arrayLength((&global_7.member)));
                                                    if _e904 {
                                                        if _e904 {
                                                        } else {
                                                            phi_3281_ = true;
                                                            break;
                                                        }
                                                        let _e907 = global_7.member[_e903].member_1;
                                                        phi_978_ = _e907;
                                                    } else {
                                                        phi_978_ = 4294967295u;
                                                    }
                                                    let _e909 = phi_978_;
                                                    if _e904 {
                                                        if _e904 {
                                                        } else {
                                                            phi_3281_ = true;
                                                            break;
                                                        }
                                                        let _e911 = global_7.member[_e903];
                                                        phi_994_ = _e911;
                                                    } else {
                                                        phi_994_ = type_47(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                    }
                                                    let _e913 = phi_994_;
                                                    let _e925 = ((10u * _e254) & 31u);
                                                    let _e928 = ((_e913.member[0] >> bitcast<u32>(_e925)) & 1023u);
                                                    let _e933 = bitcast<f32>((bitcast<u32>(((_e511.member.member_1[0] - _e511.member.member[0]) * 0.0009775171f)) ^ _e120));
                                                    let _e939 = (_e511.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e928) * _e933)) ^ _e120)));
                                                    let _e943 = select(select(_e511.member.member_1[0], _e939, (_e939 < _e511.member.member_1[0])), _e511.member.member_1[0], (_e928 == 1023u));
                                                    let _e945 = ((10u * _e253) & 31u);
                                                    let _e948 = ((_e913.member[0] >> bitcast<u32>(_e945)) & 1023u);
                                                    let _e953 = bitcast<f32>((bitcast<u32>(((_e511.member.member_1[1] - _e511.member.member[1]) * 0.0009775171f)) ^ _e120));
                                                    let _e959 = (_e511.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e948) * _e953)) ^ _e120)));
                                                    let _e963 = select(select(_e511.member.member_1[1], _e959, (_e959 < _e511.member.member_1[1])), _e511.member.member_1[1], (_e948 == 1023u));
                                                    let _e965 = ((10u * _e255) & 31u);
                                                    let _e968 = ((_e913.member[0] >> bitcast<u32>(_e965)) & 1023u);
                                                    let _e973 = bitcast<f32>((bitcast<u32>(((_e511.member.member_1[2] - _e511.member.member[2]) * 0.0009775171f)) ^ _e120));
                                                    let _e979 = (_e511.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e968) * _e973)) ^ _e120)));
                                                    let _e983 = select(select(_e511.member.member_1[2], _e979, (_e979 < _e511.member.member_1[2])), _e511.member.member_1[2], (_e968 == 1023u));
                                                    let _e987 = ((_e913.member[1] >> bitcast<u32>(_e925)) & 1023u);
                                                    let _e993 = (_e511.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e987) * _e933)) ^ _e120)));
                                                    let _e997 = select(select(_e511.member.member_1[0], _e993, (_e993 < _e511.member.member_1[0])), _e511.member.member_1[0], (_e987 == 1023u));
                                                    let _e1000 = ((_e913.member[1] >> bitcast<u32>(_e945)) & 1023u);
                                                    let _e1006 = (_e511.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1000) * _e953)) ^ _e120)));
                                                    let _e1010 = select(select(_e511.member.member_1[1], _e1006, (_e1006 < _e511.member.member_1[1])), _e511.member.member_1[1], (_e1000 == 1023u));
                                                    let _e1013 = ((_e913.member[1] >> bitcast<u32>(_e965)) & 1023u);
                                                    let _e1019 = (_e511.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1013) * _e973)) ^ _e120)));
                                                    let _e1023 = select(select(_e511.member.member_1[2], _e1019, (_e1019 < _e511.member.member_1[2])), _e511.member.member_1[2], (_e1013 == 1023u));
                                                    let _e1027 = ((_e913.member[2] >> bitcast<u32>(_e925)) & 1023u);
                                                    let _e1033 = (_e511.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1027) * _e933)) ^ _e120)));
                                                    let _e1037 = select(select(_e511.member.member_1[0], _e1033, (_e1033 < _e511.member.member_1[0])), _e511.member.member_1[0], (_e1027 == 1023u));
                                                    let _e1040 = ((_e913.member[2] >> bitcast<u32>(_e945)) & 1023u);
                                                    let _e1046 = (_e511.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1040) * _e953)) ^ _e120)));
                                                    let _e1050 = select(select(_e511.member.member_1[1], _e1046, (_e1046 < _e511.member.member_1[1])), _e511.member.member_1[1], (_e1040 == 1023u));
                                                    let _e1053 = ((_e913.member[2] >> bitcast<u32>(_e965)) & 1023u);
                                                    let _e1059 = (_e511.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1053) * _e973)) ^ _e120)));
                                                    let _e1063 = select(select(_e511.member.member_1[2], _e1059, (_e1059 < _e511.member.member_1[2])), _e511.member.member_1[2], (_e1053 == 1023u));
                                                    let _e1068 = (_e983 - _e359);
                                                    let _e1071 = (((_e943 - _e286) * _e383) - (_e1068 * _e311));
                                                    let _e1074 = (((_e963 - _e323) * _e383) - (_e1068 * _e347));
                                                    let _e1077 = (_e1023 - _e359);
                                                    let _e1080 = (((_e997 - _e286) * _e383) - (_e1077 * _e311));
                                                    let _e1083 = (((_e1010 - _e323) * _e383) - (_e1077 * _e347));
                                                    let _e1086 = (_e1063 - _e359);
                                                    let _e1089 = (((_e1037 - _e286) * _e383) - (_e1086 * _e311));
                                                    let _e1092 = (((_e1050 - _e323) * _e383) - (_e1086 * _e347));
                                                    let _e1093 = (_e1089 * _e1083);
                                                    let _e1094 = (_e1092 * _e1080);
                                                    let _e1095 = (_e1071 * _e1092);
                                                    let _e1096 = (_e1074 * _e1089);
                                                    let _e1097 = (_e1080 * _e1074);
                                                    let _e1098 = (_e1083 * _e1071);
                                                    let _e1103 = (((_e1093 >= _e1094) && (_e1095 >= _e1096)) && (_e1097 >= _e1098));
                                                    if (_e1103 || (((_e1093 <= _e1094) && (_e1095 <= _e1096)) && (_e1097 <= _e1098))) {
                                                        let _e1110 = select(-1f, 1f, _e1103);
                                                        let _e1112 = ((_e1093 - _e1094) * _e1110);
                                                        let _e1114 = select(0f, _e1112, (_e1112 > 0f));
                                                        let _e1116 = ((_e1095 - _e1096) * _e1110);
                                                        let _e1118 = select(0f, _e1116, (_e1116 > 0f));
                                                        let _e1120 = ((_e1097 - _e1098) * _e1110);
                                                        let _e1122 = select(0f, _e1120, (_e1120 > 0f));
                                                        let _e1124 = ((_e1114 + _e1118) + _e1122);
                                                        if (_e1124 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2054_ = type_19();
                                                            phi_2055_ = true;
                                                            phi_2056_ = false;
                                                        } else {
                                                            let _e1127 = select(_e1080, _e1071, (_e1071 < _e1080));
                                                            if (select(_e1089, _e1127, (_e1127 < _e1089)) > 0f) {
                                                                phi_1370_ = true;
                                                            } else {
                                                                let _e1132 = select(_e1080, _e1071, (_e1071 > _e1080));
                                                                phi_1370_ = (select(_e1089, _e1132, (_e1132 > _e1089)) < 0f);
                                                            }
                                                            let _e1137 = phi_1370_;
                                                            if _e1137 {
                                                                phi_2051_ = type_19();
                                                                phi_2052_ = true;
                                                                phi_2053_ = false;
                                                            } else {
                                                                let _e1139 = select(_e1083, _e1074, (_e1074 < _e1083));
                                                                if (select(_e1092, _e1139, (_e1139 < _e1092)) > 0f) {
                                                                    phi_1399_ = true;
                                                                } else {
                                                                    let _e1144 = select(_e1083, _e1074, (_e1074 > _e1083));
                                                                    phi_1399_ = (select(_e1092, _e1144, (_e1144 > _e1092)) < 0f);
                                                                }
                                                                let _e1149 = phi_1399_;
                                                                if _e1149 {
                                                                    phi_2049_ = type_19();
                                                                    phi_2050_ = false;
                                                                } else {
                                                                    let _e1151 = select(_e997, _e943, (_e943 < _e997));
                                                                    let _e1155 = select(_e997, _e943, (_e943 > _e997));
                                                                    let _e1159 = select(_e1010, _e963, (_e963 < _e1010));
                                                                    let _e1163 = select(_e1010, _e963, (_e963 > _e1010));
                                                                    let _e1167 = select(_e1023, _e983, (_e983 < _e1023));
                                                                    let _e1171 = select(_e1023, _e983, (_e983 > _e1023));
                                                                    let _e1176 = ((select(_e1037, _e1151, (_e1151 < _e1037)) - _e309) * _e314);
                                                                    let _e1177 = ((select(_e1037, _e1155, (_e1155 > _e1037)) - _e310) * _e314);
                                                                    let _e1180 = ((select(_e1050, _e1159, (_e1159 < _e1050)) - _e345) * _e350);
                                                                    let _e1181 = ((select(_e1050, _e1163, (_e1163 > _e1050)) - _e346) * _e350);
                                                                    let _e1184 = ((select(_e1063, _e1167, (_e1167 < _e1063)) - _e381) * _e386);
                                                                    let _e1185 = ((select(_e1063, _e1171, (_e1171 > _e1063)) - _e382) * _e386);
                                                                    let _e1187 = select(_e1185, _e1184, (_e1184 < _e1185));
                                                                    let _e1189 = select(_e1185, _e1184, (_e1184 > _e1185));
                                                                    let _e1191 = select(_e1177, _e1176, (_e1176 < _e1177));
                                                                    let _e1193 = select(_e1181, _e1180, (_e1180 < _e1181));
                                                                    let _e1195 = select(_e1193, _e1191, (_e1191 > _e1193));
                                                                    let _e1197 = select(_e1187, _e1195, (_e1195 > _e1187));
                                                                    let _e1199 = select(_e1177, _e1176, (_e1176 > _e1177));
                                                                    let _e1201 = select(_e1181, _e1180, (_e1180 > _e1181));
                                                                    let _e1203 = select(_e1201, _e1199, (_e1199 < _e1201));
                                                                    let _e1205 = select(_e1189, _e1203, (_e1203 < _e1189));
                                                                    let _e1206 = -(_e1187);
                                                                    let _e1212 = select(_e432, _e1197, (_e1197 > _e432));
                                                                    if (_e1212 > (_e1205 + (select(_e1206, _e1189, (_e1189 > _e1206)) * 0.0000019073523f))) {
                                                                        phi_2044_ = type_19();
                                                                        phi_2045_ = true;
                                                                    } else {
                                                                        let _e1214 = (_e1212 > _e875.member.member_1);
                                                                        if _e1214 {
                                                                            phi_2043_ = type_19();
                                                                        } else {
                                                                            let _e1215 = vec3<f32>(_e943, _e963, _e983);
                                                                            let _e1216 = vec3<f32>(_e997, _e1010, _e1023);
                                                                            let _e1217 = vec3<f32>(_e1037, _e1050, _e1063);
                                                                            let _e1218 = (_e997 - _e943);
                                                                            let _e1219 = (_e1010 - _e963);
                                                                            let _e1220 = (_e1023 - _e983);
                                                                            let _e1221 = vec3<f32>(_e1218, _e1219, _e1220);
                                                                            let _e1222 = (_e1037 - _e997);
                                                                            let _e1223 = (_e1050 - _e1010);
                                                                            let _e1224 = (_e1063 - _e1023);
                                                                            let _e1225 = vec3<f32>(_e1222, _e1223, _e1224);
                                                                            let _e1226 = (_e943 - _e1037);
                                                                            let _e1227 = (_e963 - _e1050);
                                                                            let _e1228 = (_e983 - _e1063);
                                                                            let _e1229 = vec3<f32>(_e1226, _e1227, _e1228);
                                                                            let _e1232 = bitcast<f32>((bitcast<u32>(_e1218) & 2147483647u));
                                                                            let _e1235 = bitcast<f32>((bitcast<u32>(_e1219) & 2147483647u));
                                                                            let _e1237 = select(_e1235, _e1232, (_e1232 > _e1235));
                                                                            let _e1240 = bitcast<f32>((bitcast<u32>(_e1220) & 2147483647u));
                                                                            let _e1242 = select(_e1240, _e1237, (_e1237 > _e1240));
                                                                            let _e1245 = bitcast<f32>((bitcast<u32>(_e1222) & 2147483647u));
                                                                            let _e1248 = bitcast<f32>((bitcast<u32>(_e1223) & 2147483647u));
                                                                            let _e1250 = select(_e1248, _e1245, (_e1245 > _e1248));
                                                                            let _e1253 = bitcast<f32>((bitcast<u32>(_e1224) & 2147483647u));
                                                                            let _e1255 = select(_e1253, _e1250, (_e1250 > _e1253));
                                                                            let _e1258 = bitcast<f32>((bitcast<u32>(_e1226) & 2147483647u));
                                                                            let _e1261 = bitcast<f32>((bitcast<u32>(_e1227) & 2147483647u));
                                                                            let _e1263 = select(_e1261, _e1258, (_e1258 > _e1261));
                                                                            let _e1266 = bitcast<f32>((bitcast<u32>(_e1228) & 2147483647u));
                                                                            let _e1268 = select(_e1266, _e1263, (_e1263 > _e1266));
                                                                            let _e1270 = select(_e1255, _e1242, (_e1242 > _e1255));
                                                                            let _e1272 = select(_e1268, _e1270, (_e1270 > _e1268));
                                                                            if (_e1242 == _e1272) {
                                                                                phi_1776_ = _e1083;
                                                                                phi_1777_ = _e1080;
                                                                                phi_1778_ = _e1074;
                                                                                phi_1779_ = _e1071;
                                                                                phi_1780_ = _e1215;
                                                                                phi_1781_ = _e1229;
                                                                                phi_1782_ = _e1225;
                                                                                phi_1783_ = _e1221;
                                                                            } else {
                                                                                let _e1274 = (_e1255 == _e1272);
                                                                                let _e1279 = vec3(_e1274);
                                                                                phi_1776_ = select(_e1074, _e1092, _e1274);
                                                                                phi_1777_ = select(_e1071, _e1089, _e1274);
                                                                                phi_1778_ = select(_e1092, _e1083, _e1274);
                                                                                phi_1779_ = select(_e1089, _e1080, _e1274);
                                                                                phi_1780_ = select(_e1217, _e1216, _e1279);
                                                                                phi_1781_ = select(_e1225, _e1221, _e1279);
                                                                                phi_1782_ = select(_e1221, _e1229, _e1279);
                                                                                phi_1783_ = select(_e1229, _e1225, _e1279);
                                                                            }
                                                                            let _e1285 = phi_1776_;
                                                                            let _e1287 = phi_1777_;
                                                                            let _e1289 = phi_1778_;
                                                                            let _e1291 = phi_1779_;
                                                                            let _e1293 = phi_1780_;
                                                                            let _e1295 = phi_1781_;
                                                                            let _e1297 = phi_1782_;
                                                                            let _e1299 = phi_1783_;
                                                                            let _e1306 = ((_e1297.y * _e1295.z) - (_e1295.y * _e1297.z));
                                                                            let _e1311 = ((_e1297.z * _e1295.x) - (_e1295.z * _e1297.x));
                                                                            let _e1314 = ((_e1297.x * _e1295.y) - (_e1295.x * _e1297.y));
                                                                            if (_e1114 >= _e1118) {
                                                                                phi_1814_ = select(true, false, (_e1114 >= _e1122));
                                                                            } else {
                                                                                phi_1814_ = true;
                                                                            }
                                                                            let _e1319 = phi_1814_;
                                                                            if _e1319 {
                                                                                phi_1823_ = select(_e1217, _e1216, vec3((_e1118 >= _e1122)));
                                                                            } else {
                                                                                phi_1823_ = _e1215;
                                                                            }
                                                                            let _e1324 = phi_1823_;
                                                                            let _e1335 = (((_e1306 * (_e1324.x - _e286)) + (_e1311 * (_e1324.y - _e323))) + (_e1314 * (_e1324.z - _e359)));
                                                                            let _e1340 = (((_e1306 * _e311) + (_e1311 * _e347)) + (_e1314 * _e383));
                                                                            let _e1341 = (_e1287 - _e1291);
                                                                            let _e1342 = (_e1285 - _e1289);
                                                                            let _e1350 = (-(((_e1291 * _e1341) + (_e1289 * _e1342))) / ((_e1341 * _e1341) + (_e1342 * _e1342)));
                                                                            let _e1352 = select(1f, _e1350, (_e1350 < 1f));
                                                                            let _e1354 = select(0f, _e1352, (_e1352 > 0f));
                                                                            let _e1367 = ((_e1293.x + (_e1299.x * _e1354)) - _e286);
                                                                            let _e1368 = ((_e1293.y + (_e1299.y * _e1354)) - _e323);
                                                                            let _e1369 = ((_e1293.z + (_e1299.z * _e1354)) - _e359);
                                                                            let _e1370 = (_e1369 / _e383);
                                                                            let _e1382 = bitcast<f32>((bitcast<u32>(_e1367) & 2147483647u));
                                                                            let _e1385 = bitcast<f32>((bitcast<u32>(_e1368) & 2147483647u));
                                                                            let _e1387 = select(_e1385, _e1382, (_e1382 > _e1385));
                                                                            let _e1390 = bitcast<f32>((bitcast<u32>(_e1369) & 2147483647u));
                                                                            let _e1392 = select(_e1390, _e1387, (_e1387 > _e1390));
                                                                            let _e1398 = bitcast<f32>((bitcast<u32>(_e1306) & 2147483647u));
                                                                            let _e1401 = bitcast<f32>((bitcast<u32>(_e1311) & 2147483647u));
                                                                            let _e1403 = select(_e1401, _e1398, (_e1398 > _e1401));
                                                                            let _e1406 = bitcast<f32>((bitcast<u32>(_e1314) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1306 * _e1367) + (_e1311 * _e1368)) + (_e1314 * _e1369)) - _e1335)) & 2147483647u)) <= ((0.0000009536743f * select(_e1272, _e1392, (_e1392 > _e1272))) * select(_e1406, _e1403, (_e1403 > _e1406)))) {
                                                                                let _e1416 = bitcast<f32>((bitcast<u32>(_e1297.x) & 2147483647u));
                                                                                let _e1419 = bitcast<f32>((bitcast<u32>(_e1297.y) & 2147483647u));
                                                                                let _e1421 = select(_e1419, _e1416, (_e1416 > _e1419));
                                                                                let _e1424 = bitcast<f32>((bitcast<u32>(_e1297.z) & 2147483647u));
                                                                                let _e1430 = bitcast<f32>((bitcast<u32>(_e1295.x) & 2147483647u));
                                                                                let _e1433 = bitcast<f32>((bitcast<u32>(_e1295.y) & 2147483647u));
                                                                                let _e1435 = select(_e1433, _e1430, (_e1430 > _e1433));
                                                                                let _e1438 = bitcast<f32>((bitcast<u32>(_e1295.z) & 2147483647u));
                                                                                let _e1442 = (bitcast<f32>((bitcast<u32>(_e1340) & 2147483647u)) > ((0.0000038146973f * select(_e1424, _e1421, (_e1421 > _e1424))) * select(_e1438, _e1435, (_e1435 > _e1438))));
                                                                                if _e1442 {
                                                                                    phi_1988_ = (_e1335 / _e1340);
                                                                                } else {
                                                                                    phi_1988_ = f32();
                                                                                }
                                                                                let _e1445 = phi_1988_;
                                                                                phi_1990_ = _e1445;
                                                                                phi_1991_ = select(true, false, _e1442);
                                                                            } else {
                                                                                phi_1990_ = f32();
                                                                                phi_1991_ = true;
                                                                            }
                                                                            let _e1448 = phi_1990_;
                                                                            let _e1450 = phi_1991_;
                                                                            if _e1450 {
                                                                                let _e1458 = (((_e1306 * (_e1367 - (_e311 * _e1370))) + (_e1311 * (_e1368 - (_e347 * _e1370)))) / _e1340);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1458) & 2147483647u)) <= _e1272) {
                                                                                    phi_2011_ = (_e1370 + _e1458);
                                                                                } else {
                                                                                    phi_2011_ = _e1370;
                                                                                }
                                                                                let _e1465 = phi_2011_;
                                                                                phi_2012_ = _e1465;
                                                                            } else {
                                                                                phi_2012_ = _e1448;
                                                                            }
                                                                            let _e1467 = phi_2012_;
                                                                            let _e1469 = select(_e1205, _e1467, (_e1467 < _e1205));
                                                                            let _e1471 = select(_e1197, _e1469, (_e1469 > _e1197));
                                                                            if (_e1471 >= _e432) {
                                                                                let _e1473 = (_e1471 <= _e875.member.member_1);
                                                                                if _e1473 {
                                                                                    let _e1474 = (1f / _e1124);
                                                                                    phi_2035_ = type_19(_e1471, (_e1118 * _e1474), (_e1122 * _e1474), _e909);
                                                                                } else {
                                                                                    phi_2035_ = type_19();
                                                                                }
                                                                                let _e1479 = phi_2035_;
                                                                                phi_2037_ = _e1479;
                                                                                phi_2038_ = select(true, false, _e1473);
                                                                            } else {
                                                                                phi_2037_ = type_19();
                                                                                phi_2038_ = true;
                                                                            }
                                                                            let _e1482 = phi_2037_;
                                                                            let _e1484 = phi_2038_;
                                                                            if _e1484 {
                                                                                phi_2042_ = type_19(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2042_ = _e1482;
                                                                            }
                                                                            let _e1486 = phi_2042_;
                                                                            phi_2043_ = _e1486;
                                                                        }
                                                                        let _e1488 = phi_2043_;
                                                                        phi_2044_ = _e1488;
                                                                        phi_2045_ = _e1214;
                                                                    }
                                                                    let _e1490 = phi_2044_;
                                                                    let _e1492 = phi_2045_;
                                                                    phi_2049_ = _e1490;
                                                                    phi_2050_ = _e1492;
                                                                }
                                                                let _e1494 = phi_2049_;
                                                                let _e1496 = phi_2050_;
                                                                phi_2051_ = _e1494;
                                                                phi_2052_ = _e1149;
                                                                phi_2053_ = _e1496;
                                                            }
                                                            let _e1498 = phi_2051_;
                                                            let _e1500 = phi_2052_;
                                                            let _e1502 = phi_2053_;
                                                            phi_2054_ = _e1498;
                                                            phi_2055_ = _e1500;
                                                            phi_2056_ = _e1502;
                                                        }
                                                        let _e1504 = phi_2054_;
                                                        let _e1506 = phi_2055_;
                                                        let _e1508 = phi_2056_;
                                                        phi_2064_ = _e1504;
                                                        phi_2065_ = select(_e1508, true, _e1506);
                                                    } else {
                                                        phi_2064_ = type_19();
                                                        phi_2065_ = true;
                                                    }
                                                    let _e1511 = phi_2064_;
                                                    let _e1513 = phi_2065_;
                                                    if _e1513 {
                                                        phi_2069_ = type_19(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2069_ = _e1511;
                                                    }
                                                    let _e1515 = phi_2069_;
                                                    if (_e1515.member_3 != 4294967295u) {
                                                        if (_e909 != _e438) {
                                                            if (_e1515.member < _e875.member.member.member) {
                                                                phi_2095_ = true;
                                                            } else {
                                                                if (_e1515.member == _e875.member.member.member) {
                                                                    phi_2094_ = (_e1515.member_3 < _e875.member.member.member_3);
                                                                } else {
                                                                    phi_2094_ = false;
                                                                }
                                                                let _e1530 = phi_2094_;
                                                                phi_2095_ = _e1530;
                                                            }
                                                            let _e1532 = phi_2095_;
                                                            if _e1532 {
                                                                phi_2102_ = type_36(type_34(_e1515, _e1515.member), _e902.member_1, _e902.member_2);
                                                            } else {
                                                                phi_2102_ = _e902;
                                                            }
                                                            let _e1539 = phi_2102_;
                                                            phi_2103_ = _e1539;
                                                        } else {
                                                            phi_2103_ = _e902;
                                                        }
                                                        let _e1541 = phi_2103_;
                                                        phi_2104_ = _e1541;
                                                    } else {
                                                        phi_2104_ = _e902;
                                                    }
                                                    let _e1543 = phi_2104_;
                                                    phi_925_ = _e1543;
                                                } else {
                                                    phi_925_ = type_36();
                                                }
                                                let _e1545 = phi_925_;
                                                continue;
                                                continuing {
                                                    phi_924_ = _e1545;
                                                    phi_927_ = _e890;
                                                    phi_3281_ = _e469;
                                                    break if !(_e896);
                                                }
                                            }
                                            let _e1548 = phi_3281_;
                                            phi_3441_ = _e1548;
                                            if _e1548 {
                                                break;
                                            }
                                            phi_3445_ = _e1548;
                                            let _e1777 = local_12;
                                            phi_3056_ = _e1777;
                                            phi_3057_ = _e511;
                                            phi_3058_ = false;
                                            phi_3059_ = _e515;
                                        } else {
                                            let _e531 = (_e511.member_1 < _e81);
                                            if _e531 {
                                                if _e531 {
                                                } else {
                                                    phi_3441_ = true;
                                                    break;
                                                }
                                                let _e533 = global_6.member[_e511.member_1];
                                                phi_2126_ = _e533;
                                            } else {
                                                phi_2126_ = type_40(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                            }
                                            let _e535 = phi_2126_;
                                            let _e550 = ((10u * _e254) & 31u);
                                            let _e553 = ((_e535.member[0] >> bitcast<u32>(_e550)) & 1023u);
                                            let _e558 = bitcast<f32>((bitcast<u32>(((_e511.member.member_1[0] - _e511.member.member[0]) * 0.0009775171f)) ^ _e120));
                                            let _e564 = (_e511.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e553) * _e558)) ^ _e120)));
                                            let _e568 = select(select(_e511.member.member_1[0], _e564, (_e564 < _e511.member.member_1[0])), _e511.member.member_1[0], (_e553 == 1023u));
                                            let _e570 = ((10u * _e253) & 31u);
                                            let _e573 = ((_e535.member[0] >> bitcast<u32>(_e570)) & 1023u);
                                            let _e578 = bitcast<f32>((bitcast<u32>(((_e511.member.member_1[1] - _e511.member.member[1]) * 0.0009775171f)) ^ _e120));
                                            let _e584 = (_e511.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e573) * _e578)) ^ _e120)));
                                            let _e588 = select(select(_e511.member.member_1[1], _e584, (_e584 < _e511.member.member_1[1])), _e511.member.member_1[1], (_e573 == 1023u));
                                            let _e590 = ((10u * _e255) & 31u);
                                            let _e593 = ((_e535.member[0] >> bitcast<u32>(_e590)) & 1023u);
                                            let _e598 = bitcast<f32>((bitcast<u32>(((_e511.member.member_1[2] - _e511.member.member[2]) * 0.0009775171f)) ^ _e120));
                                            let _e604 = (_e511.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e593) * _e598)) ^ _e120)));
                                            let _e608 = select(select(_e511.member.member_1[2], _e604, (_e604 < _e511.member.member_1[2])), _e511.member.member_1[2], (_e593 == 1023u));
                                            let _e611 = ((_e535.member[1] >> bitcast<u32>(_e550)) & 1023u);
                                            let _e617 = (_e511.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e611) * _e558)) ^ _e120)));
                                            let _e621 = select(select(_e511.member.member_1[0], _e617, (_e617 < _e511.member.member_1[0])), _e511.member.member_1[0], (_e611 == 1023u));
                                            let _e624 = ((_e535.member[1] >> bitcast<u32>(_e570)) & 1023u);
                                            let _e630 = (_e511.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e624) * _e578)) ^ _e120)));
                                            let _e634 = select(select(_e511.member.member_1[1], _e630, (_e630 < _e511.member.member_1[1])), _e511.member.member_1[1], (_e624 == 1023u));
                                            let _e637 = ((_e535.member[1] >> bitcast<u32>(_e590)) & 1023u);
                                            let _e643 = (_e511.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e637) * _e598)) ^ _e120)));
                                            let _e647 = select(select(_e511.member.member_1[2], _e643, (_e643 < _e511.member.member_1[2])), _e511.member.member_1[2], (_e637 == 1023u));
                                            let _e653 = ((_e535.member_1[0] >> bitcast<u32>(_e550)) & 1023u);
                                            let _e659 = (_e511.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e653) * _e558)) ^ _e120)));
                                            let _e663 = select(select(_e511.member.member_1[0], _e659, (_e659 < _e511.member.member_1[0])), _e511.member.member_1[0], (_e653 == 1023u));
                                            let _e666 = ((_e535.member_1[0] >> bitcast<u32>(_e570)) & 1023u);
                                            let _e672 = (_e511.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e666) * _e578)) ^ _e120)));
                                            let _e676 = select(select(_e511.member.member_1[1], _e672, (_e672 < _e511.member.member_1[1])), _e511.member.member_1[1], (_e666 == 1023u));
                                            let _e679 = ((_e535.member_1[0] >> bitcast<u32>(_e590)) & 1023u);
                                            let _e685 = (_e511.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e679) * _e598)) ^ _e120)));
                                            let _e689 = select(select(_e511.member.member_1[2], _e685, (_e685 < _e511.member.member_1[2])), _e511.member.member_1[2], (_e679 == 1023u));
                                            let _e692 = ((_e535.member_1[1] >> bitcast<u32>(_e550)) & 1023u);
                                            let _e698 = (_e511.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e692) * _e558)) ^ _e120)));
                                            let _e702 = select(select(_e511.member.member_1[0], _e698, (_e698 < _e511.member.member_1[0])), _e511.member.member_1[0], (_e692 == 1023u));
                                            let _e705 = ((_e535.member_1[1] >> bitcast<u32>(_e570)) & 1023u);
                                            let _e711 = (_e511.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e705) * _e578)) ^ _e120)));
                                            let _e715 = select(select(_e511.member.member_1[1], _e711, (_e711 < _e511.member.member_1[1])), _e511.member.member_1[1], (_e705 == 1023u));
                                            let _e718 = ((_e535.member_1[1] >> bitcast<u32>(_e590)) & 1023u);
                                            let _e724 = (_e511.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e718) * _e598)) ^ _e120)));
                                            let _e728 = select(select(_e511.member.member_1[2], _e724, (_e724 < _e511.member.member_1[2])), _e511.member.member_1[2], (_e718 == 1023u));
                                            let _e733 = type_53(type_45(array<f32, 3>(_e568, _e588, _e608), array<f32, 3>(_e621, _e634, _e647)), _e535.member_2);
                                            let _e738 = type_53(type_45(array<f32, 3>(_e663, _e676, _e689), array<f32, 3>(_e702, _e715, _e728)), _e535.member_3);
                                            let _e745 = ((_e568 - _e309) * _e314);
                                            let _e746 = ((_e663 - _e309) * _e314);
                                            let _e747 = ((_e621 - _e310) * _e314);
                                            let _e748 = ((_e702 - _e310) * _e314);
                                            let _e753 = ((_e588 - _e345) * _e350);
                                            let _e754 = ((_e676 - _e345) * _e350);
                                            let _e755 = ((_e634 - _e346) * _e350);
                                            let _e756 = ((_e715 - _e346) * _e350);
                                            let _e761 = ((_e608 - _e381) * _e386);
                                            let _e762 = ((_e689 - _e381) * _e386);
                                            let _e763 = ((_e647 - _e382) * _e386);
                                            let _e764 = ((_e728 - _e382) * _e386);
                                            let _e766 = select(_e763, _e761, (_e761 < _e763));
                                            let _e768 = select(_e764, _e762, (_e762 < _e764));
                                            let _e770 = select(_e763, _e761, (_e761 > _e763));
                                            let _e772 = select(_e764, _e762, (_e762 > _e764));
                                            let _e774 = select(_e747, _e745, (_e745 < _e747));
                                            let _e776 = select(_e748, _e746, (_e746 < _e748));
                                            let _e778 = select(_e755, _e753, (_e753 < _e755));
                                            let _e780 = select(_e756, _e754, (_e754 < _e756));
                                            let _e782 = select(_e778, _e774, (_e774 > _e778));
                                            let _e784 = select(_e780, _e776, (_e776 > _e780));
                                            let _e786 = select(_e766, _e782, (_e782 > _e766));
                                            let _e788 = select(_e768, _e784, (_e784 > _e768));
                                            let _e790 = select(_e747, _e745, (_e745 > _e747));
                                            let _e792 = select(_e748, _e746, (_e746 > _e748));
                                            let _e794 = select(_e755, _e753, (_e753 > _e755));
                                            let _e796 = select(_e756, _e754, (_e754 > _e756));
                                            let _e798 = select(_e794, _e790, (_e790 < _e794));
                                            let _e800 = select(_e796, _e792, (_e792 < _e796));
                                            let _e805 = -(_e766);
                                            let _e806 = -(_e768);
                                            let _e813 = (select(_e770, _e798, (_e798 < _e770)) + (select(_e805, _e770, (_e770 > _e805)) * 0.0000019073523f));
                                            let _e814 = (select(_e772, _e800, (_e800 < _e772)) + (select(_e806, _e772, (_e772 > _e806)) * 0.0000019073523f));
                                            let _e816 = select(_e432, _e786, (_e786 > _e432));
                                            let _e818 = select(_e432, _e788, (_e788 > _e432));
                                            let _e823 = (_e816 <= select(_e471.member.member_1, _e813, (_e813 < _e471.member.member_1)));
                                            let _e824 = (_e818 <= select(_e471.member.member_1, _e814, (_e814 < _e471.member.member_1)));
                                            let _e825 = (_e816 <= _e818);
                                            if _e823 {
                                                if _e824 {
                                                    if _e825 {
                                                        phi_2958_ = _e738;
                                                    } else {
                                                        phi_2958_ = _e733;
                                                    }
                                                    let _e827 = phi_2958_;
                                                    let _e835 = (_e515 % 128u);
                                                    let _e836 = (_e835 < 128u);
                                                    if _e836 {
                                                    } else {
                                                        phi_3441_ = true;
                                                        break;
                                                    }
                                                    local_6[_e835] = _e827.member_1;
                                                    if _e836 {
                                                    } else {
                                                        phi_3441_ = true;
                                                        break;
                                                    }
                                                    local_5[_e835] = _e827.member.member[0];
                                                    if _e836 {
                                                    } else {
                                                        phi_3441_ = true;
                                                        break;
                                                    }
                                                    local_4[_e835] = _e827.member.member[1];
                                                    if _e836 {
                                                    } else {
                                                        phi_3441_ = true;
                                                        break;
                                                    }
                                                    local_3[_e835] = _e827.member.member[2];
                                                    if _e836 {
                                                    } else {
                                                        phi_3441_ = true;
                                                        break;
                                                    }
                                                    local_2[_e835] = _e827.member.member_1[0];
                                                    if _e836 {
                                                    } else {
                                                        phi_3441_ = true;
                                                        break;
                                                    }
                                                    local_1[_e835] = _e827.member.member_1[1];
                                                    if _e836 {
                                                    } else {
                                                        phi_3441_ = true;
                                                        break;
                                                    }
                                                    local[_e835] = _e827.member.member_1[2];
                                                    if _e836 {
                                                    } else {
                                                        phi_3441_ = true;
                                                        break;
                                                    }
                                                    local_7[_e835] = select(_e818, _e816, (_e816 > _e818));
                                                    if _e825 {
                                                        phi_3035_ = _e733;
                                                    } else {
                                                        phi_3035_ = _e738;
                                                    }
                                                    let _e853 = phi_3035_;
                                                    phi_3036_ = _e853;
                                                    phi_3037_ = (_e515 + 1u);
                                                } else {
                                                    phi_3036_ = type_53();
                                                    phi_3037_ = u32();
                                                }
                                                let _e855 = phi_3036_;
                                                let _e857 = phi_3037_;
                                                phi_3039_ = _e855;
                                                phi_3040_ = _e857;
                                                phi_3041_ = select(true, false, _e824);
                                            } else {
                                                phi_3039_ = type_53();
                                                phi_3040_ = u32();
                                                phi_3041_ = true;
                                            }
                                            let _e860 = phi_3039_;
                                            let _e862 = phi_3040_;
                                            let _e864 = phi_3041_;
                                            if _e864 {
                                                if _e823 {
                                                    phi_3048_ = _e733;
                                                } else {
                                                    phi_3048_ = _e738;
                                                }
                                                let _e866 = phi_3048_;
                                                phi_3053_ = _e866;
                                                phi_3054_ = select(_e824, true, _e823);
                                            } else {
                                                phi_3053_ = _e860;
                                                phi_3054_ = _e513;
                                            }
                                            let _e869 = phi_3053_;
                                            let _e871 = phi_3054_;
                                            phi_3445_ = _e469;
                                            phi_3056_ = type_36(_e471.member, (_e471.member_1 + 1u), _e471.member_2);
                                            phi_3057_ = _e869;
                                            phi_3058_ = _e871;
                                            phi_3059_ = select(_e862, _e515, _e864);
                                        }
                                        let _e1550 = phi_3445_;
                                        let _e1552 = phi_3056_;
                                        let _e1554 = phi_3057_;
                                        let _e1556 = phi_3058_;
                                        let _e1558 = phi_3059_;
                                        phi_3444_ = _e1550;
                                        phi_3060_ = _e1552;
                                        phi_3061_ = _e1554;
                                        phi_3062_ = (_e475 - 1u);
                                        phi_3063_ = _e1556;
                                        phi_3064_ = _e1558;
                                    } else {
                                        phi_3444_ = _e469;
                                        phi_3060_ = _e471;
                                        phi_3061_ = _e511;
                                        phi_3062_ = _e475;
                                        phi_3063_ = _e513;
                                        phi_3064_ = _e515;
                                    }
                                    let _e1560 = phi_3444_;
                                    let _e1562 = phi_3060_;
                                    let _e1564 = phi_3061_;
                                    let _e1566 = phi_3062_;
                                    let _e1568 = phi_3063_;
                                    let _e1570 = phi_3064_;
                                    phi_3443_ = _e1560;
                                    phi_3065_ = _e1562;
                                    phi_3066_ = _e1564;
                                    phi_3067_ = _e1566;
                                    phi_3068_ = _e1568;
                                    phi_3069_ = _e1570;
                                } else {
                                    phi_3443_ = _e469;
                                    phi_3065_ = type_36();
                                    phi_3066_ = type_53();
                                    phi_3067_ = u32();
                                    phi_3068_ = bool();
                                    phi_3069_ = u32();
                                }
                                let _e1572 = phi_3443_;
                                let _e1574 = phi_3065_;
                                let _e1576 = phi_3066_;
                                let _e1578 = phi_3067_;
                                let _e1580 = phi_3068_;
                                let _e1582 = phi_3069_;
                                phi_3442_ = _e1572;
                                phi_798_ = _e1574;
                                phi_801_ = _e1576;
                                phi_803_ = _e1578;
                                phi_805_ = _e1580;
                                phi_807_ = _e1582;
                                phi_3070_ = _e483;
                            } else {
                                phi_3442_ = _e469;
                                phi_798_ = type_36();
                                phi_801_ = type_53();
                                phi_803_ = u32();
                                phi_805_ = bool();
                                phi_807_ = u32();
                                phi_3070_ = false;
                            }
                            let _e1584 = phi_3442_;
                            let _e1586 = phi_798_;
                            let _e1588 = phi_801_;
                            let _e1590 = phi_803_;
                            let _e1592 = phi_805_;
                            let _e1594 = phi_807_;
                            let _e1596 = phi_3070_;
                            continue;
                            continuing {
                                phi_3287_ = _e1584;
                                phi_797_ = _e1586;
                                phi_800_ = _e1588;
                                phi_802_ = _e1590;
                                phi_804_ = _e1592;
                                phi_806_ = _e1594;
                                phi_3441_ = _e1584;
                                break if !(_e1596);
                            }
                        }
                        let _e1599 = phi_3441_;
                        if _e1599 {
                            break;
                        }
                        let _e1601 = local_10;
                        if (_e1601.member.member.member_3 != 4294967295u) {
                            let _e1607 = (_e256 / 3i);
                            let _e1614 = bitcast<f32>((bitcast<u32>((_e1607 + 127i)) << bitcast<u32>(23i)));
                            let _e1622 = (((_e1601.member.member.member * _e1614) * _e1614) * bitcast<f32>((bitcast<u32>(((_e256 - (2i * _e1607)) + 127i)) << bitcast<u32>(23i))));
                            let _e1624 = select(340282350000000000000000000000000000000f, _e1622, (_e1622 < 340282350000000000000000000000000000000f));
                            phi_3122_ = type_19(select(-340282350000000000000000000000000000000f, _e1624, (_e1624 > -340282350000000000000000000000000000000f)), _e1601.member.member.member_1, _e1601.member.member.member_2, _e1601.member.member.member_3);
                        } else {
                            phi_3122_ = type_19(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1631 = phi_3122_;
                        if _e132 {
                        } else {
                            break;
                        }
                        global_1.member[_e124] = _e1631;
                        let _e1635 = local_11;
                        if _e133 {
                        } else {
                            break;
                        }
                        global_4.member[_e124] = _e1635.member_1;
                        if _e131 {
                        } else {
                            break;
                        }
                        let _e1640 = select(0u, 1u, (_e200 <= _e210));
                        if (_e1640 > 0u) {
                            let _e1642 = (1u < _e92);
                            if _e1642 {
                                if (0u < _e92) {
                                } else {
                                    break;
                                }
                                let _e1646 = atomicAdd((&global_5.member[0u]), _e1640);
                                if ((_e1646 + _e1640) < _e1646) {
                                    if _e1642 {
                                    } else {
                                        break;
                                    }
                                    let _e1651 = atomicAdd((&global_5.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1654 = select(0u, 1u, (_e1631.member_3 != 4294967295u));
                        if (_e1654 > 0u) {
                            let _e1656 = (3u < _e92);
                            if _e1656 {
                                if (2u < _e92) {
                                } else {
                                    break;
                                }
                                let _e1660 = atomicAdd((&global_5.member[2u]), _e1654);
                                if ((_e1660 + _e1654) < _e1660) {
                                    if _e1656 {
                                    } else {
                                        break;
                                    }
                                    let _e1665 = atomicAdd((&global_5.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1635.member_1 > 0u) {
                            let _e1667 = (5u < _e92);
                            if _e1667 {
                                if (4u < _e92) {
                                } else {
                                    break;
                                }
                                let _e1671 = atomicAdd((&global_5.member[4u]), _e1635.member_1);
                                if ((_e1671 + _e1635.member_1) < _e1671) {
                                    if _e1667 {
                                    } else {
                                        break;
                                    }
                                    let _e1676 = atomicAdd((&global_5.member[5u]), 1u);
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
fn trace_paths_counted_printed_leaf10_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
