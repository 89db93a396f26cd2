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

struct type_38 {
    member: type_23,
    member_1: f32,
}

struct type_41 {
    member: type_38,
    member_1: u32,
    member_2: u32,
}

struct type_43 {
    member: array<vec4<u32>, 2>,
}

struct type_45 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_47 {
    member: array<type_45>,
}

struct type_50 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_52 {
    member: type_50,
    member_1: u32,
}

struct type_57 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(2) 
var<storage> global_1: type_16;
@group(0) @binding(4) 
var<storage, read_write> global_2: type_25;
@group(0) @binding(0) 
var<uniform> global_3: type_43;
@group(0) @binding(3) 
var<storage> global_4: type_30;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_6: type_57;
@group(0) @binding(1) 
var<storage> global_7: type_47;

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
    var phi_341_: i32;
    var phi_342_: i32;
    var phi_352_: bool;
    var phi_362_: u32;
    var phi_363_: u32;
    var phi_365_: bool;
    var phi_370_: u32;
    var phi_402_: i32;
    var phi_420_: f32;
    var phi_426_: f32;
    var phi_437_: f32;
    var phi_443_: f32;
    var phi_466_: f32;
    var phi_477_: f32;
    var phi_486_: f32;
    var phi_492_: f32;
    var phi_503_: f32;
    var phi_509_: f32;
    var phi_532_: f32;
    var phi_543_: f32;
    var phi_552_: f32;
    var phi_558_: f32;
    var phi_569_: f32;
    var phi_575_: f32;
    var phi_598_: f32;
    var phi_609_: f32;
    var phi_709_: f32;
    var phi_710_: f32;
    var phi_3118_: bool;
    var phi_792_: type_41;
    var phi_795_: type_52;
    var phi_797_: u32;
    var phi_799_: bool;
    var phi_801_: u32;
    var phi_812_: bool;
    var phi_898_: type_52;
    var phi_899_: bool;
    var phi_900_: u32;
    var phi_1957_: type_45;
    var phi_2789_: type_52;
    var phi_2866_: type_52;
    var phi_2867_: type_52;
    var phi_2868_: u32;
    var phi_2870_: type_52;
    var phi_2871_: u32;
    var phi_2872_: bool;
    var phi_2879_: type_52;
    var phi_2884_: type_52;
    var phi_2885_: bool;
    var phi_918_: type_41;
    var phi_921_: type_7;
    var phi_922_: type_7;
    var phi_944_: type_7;
    var phi_968_: u32;
    var phi_1057_: array<array<f32, 3>, 3>;
    var phi_1174_: bool;
    var phi_1203_: bool;
    var phi_1604_: f32;
    var phi_1605_: f32;
    var phi_1606_: f32;
    var phi_1607_: f32;
    var phi_1608_: vec3<f32>;
    var phi_1609_: vec3<f32>;
    var phi_1610_: vec3<f32>;
    var phi_1611_: vec3<f32>;
    var phi_1642_: bool;
    var phi_1651_: vec3<f32>;
    var phi_1818_: bool;
    var phi_1842_: f32;
    var phi_1843_: f32;
    var phi_1866_: type_23;
    var phi_1868_: type_23;
    var phi_1869_: bool;
    var phi_1873_: type_23;
    var phi_1874_: type_23;
    var phi_1875_: type_23;
    var phi_1876_: bool;
    var phi_1880_: type_23;
    var phi_1881_: bool;
    var phi_1882_: type_23;
    var phi_1883_: bool;
    var phi_1884_: bool;
    var phi_1885_: type_23;
    var phi_1886_: bool;
    var phi_1887_: bool;
    var phi_1895_: type_23;
    var phi_1896_: bool;
    var phi_1900_: type_23;
    var phi_1925_: bool;
    var phi_1926_: bool;
    var phi_1933_: type_41;
    var phi_1934_: type_41;
    var phi_1935_: type_41;
    var phi_919_: type_41;
    var phi_3112_: bool;
    var phi_3258_: bool;
    var phi_2887_: type_41;
    var phi_2888_: type_52;
    var phi_2889_: bool;
    var phi_2890_: u32;
    var phi_3257_: bool;
    var phi_2891_: type_41;
    var phi_2892_: type_52;
    var phi_2893_: u32;
    var phi_2894_: bool;
    var phi_2895_: u32;
    var phi_3256_: bool;
    var phi_2896_: type_41;
    var phi_2897_: type_52;
    var phi_2898_: u32;
    var phi_2899_: bool;
    var phi_2900_: u32;
    var phi_3255_: bool;
    var phi_793_: type_41;
    var phi_796_: type_52;
    var phi_798_: u32;
    var phi_800_: bool;
    var phi_802_: u32;
    var phi_2901_: bool;
    var phi_3254_: bool;
    var local_10: type_41;
    var phi_2953_: type_23;
    var local_11: type_41;
    var local_12: type_41;

    switch bitcast<i32>(0u) {
        default: {
            let _e79 = global;
            let _e82 = arrayLength((&global_7.member));
            let _e84 = arrayLength((&global_1.member));
            let _e92 = arrayLength((&global_6.member));
            let _e96 = global_3.member[0u][0u];
            let _e100 = global_3.member[0u][1u];
            let _e104 = global_3.member[0u][2u];
            let _e108 = global_3.member[1u][0u];
            let _e112 = global_3.member[1u][1u];
            let _e116 = global_3.member[1u][2u];
            let _e120 = global_3.member[1u][3u];
            let _e124 = (_e79.x + (_e79.y * 2097152u));
            let _e131 = (_e124 < arrayLength((&global_4.member)));
            if _e131 {
                let _e132 = (_e124 < arrayLength((&global_2.member)));
                if _e132 {
                    let _e133 = (_e124 < arrayLength((&global_5.member)));
                    if _e133 {
                        if _e131 {
                        } else {
                            break;
                        }
                        let _e143 = global_4.member[_e124].member.member_2[0u];
                        let _e145 = (bitcast<u32>(_e143) & 2147483647u);
                        let _e151 = global_4.member[_e124].member.member_2[1u];
                        let _e153 = (bitcast<u32>(_e151) & 2147483647u);
                        let _e159 = global_4.member[_e124].member.member_2[2u];
                        let _e161 = (bitcast<u32>(_e159) & 2147483647u);
                        let _e167 = global_4.member[_e124].member.member[0u];
                        let _e169 = (bitcast<u32>(_e167) & 2147483647u);
                        let _e175 = global_4.member[_e124].member.member[1u];
                        let _e177 = (bitcast<u32>(_e175) & 2147483647u);
                        let _e183 = global_4.member[_e124].member.member[2u];
                        let _e185 = (bitcast<u32>(_e183) & 2147483647u);
                        let _e187 = select(_e153, _e145, (_e153 < _e145));
                        let _e189 = select(_e161, _e187, (_e161 < _e187));
                        let _e191 = select(_e169, _e189, (_e169 < _e189));
                        let _e193 = select(_e177, _e191, (_e177 < _e191));
                        let _e195 = select(_e185, _e193, (_e185 < _e193));
                        let _e200 = global_4.member[_e124].member.member_1;
                        let _e202 = (bitcast<u32>(_e200) & 2147483647u);
                        let _e210 = global_4.member[_e124].member.member_3;
                        let _e216 = (((select(_e202, _e195, (_e202 < _e195)) < 2139095040u) && ((bitcast<u32>(_e210) & 2147483647u) <= 2139095040u)) && (_e189 > 0u));
                        if _e216 {
                            let _e219 = (bitcast<u32>(bitcast<f32>(_e189)) & 2147483647u);
                            if (_e219 >= 8388608u) {
                                phi_341_ = (bitcast<i32>((_e219 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_341_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e219)), 32u, (_e219 == 0u))));
                            }
                            let _e233 = phi_341_;
                            phi_342_ = _e233;
                        } else {
                            phi_342_ = 0i;
                        }
                        let _e235 = phi_342_;
                        let _e236 = (_e145 == _e189);
                        if _e236 {
                            phi_352_ = true;
                        } else {
                            phi_352_ = (_e153 == _e189);
                        }
                        let _e239 = phi_352_;
                        let _e240 = select(1u, 0u, _e236);
                        if _e239 {
                            let _e241 = (_e240 + 1u);
                            phi_362_ = _e241;
                            phi_363_ = _e241;
                            phi_365_ = select(true, false, (_e241 == 2u));
                        } else {
                            phi_362_ = u32();
                            phi_363_ = 0u;
                            phi_365_ = true;
                        }
                        let _e245 = phi_362_;
                        let _e247 = phi_363_;
                        let _e249 = phi_365_;
                        if _e249 {
                            phi_370_ = (_e247 + 1u);
                        } else {
                            phi_370_ = 0u;
                        }
                        let _e253 = phi_370_;
                        let _e254 = select(_e245, _e247, _e249);
                        let _e255 = select(_e240, select(2u, _e240, _e239), _e249);
                        let _e256 = -(_e235);
                        if (_e256 < -126i) {
                            phi_402_ = -126i;
                        } else {
                            phi_402_ = select(_e256, 127i, (_e256 > 127i));
                        }
                        let _e261 = phi_402_;
                        let _e266 = bitcast<f32>((bitcast<u32>((_e261 + 127i)) << bitcast<u32>(23i)));
                        let _e272 = bitcast<f32>((bitcast<u32>(((_e256 - _e261) + 127i)) << bitcast<u32>(23i)));
                        let _e277 = global_4.member[_e124].member.member;
                        let _e278 = (_e254 == 0u);
                        if _e278 {
                            phi_420_ = _e277[0];
                        } else {
                            phi_420_ = _e277[1];
                        }
                        let _e282 = phi_420_;
                        let _e283 = (_e254 == 2u);
                        if _e283 {
                            phi_426_ = _e277[2];
                        } else {
                            phi_426_ = _e282;
                        }
                        let _e286 = phi_426_;
                        let _e287 = global_4.member[_e124].member.member_2;
                        if _e278 {
                            phi_437_ = _e287[0];
                        } else {
                            phi_437_ = _e287[1];
                        }
                        let _e291 = phi_437_;
                        if _e283 {
                            phi_443_ = _e287[2];
                        } else {
                            phi_443_ = _e291;
                        }
                        let _e294 = phi_443_;
                        let _e296 = ((_e294 * _e266) * _e272);
                        let _e300 = (bitcast<f32>((bitcast<u32>(_e296) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e300 {
                            let _e304 = (bitcast<f32>((bitcast<u32>(_e286) & 2147483647u)) * 0.00000011920929f);
                            phi_466_ = select(0.00000000000011368684f, _e304, (_e304 > 0.00000000000011368684f));
                        } else {
                            phi_466_ = 0f;
                        }
                        let _e308 = phi_466_;
                        let _e309 = (_e286 + _e308);
                        let _e310 = (_e286 - _e308);
                        let _e311 = select(_e296, 0f, _e300);
                        if _e300 {
                            phi_477_ = 38685626000000000000000000f;
                        } else {
                            phi_477_ = (1f / _e296);
                        }
                        let _e314 = phi_477_;
                        let _e315 = (_e253 == 0u);
                        if _e315 {
                            phi_486_ = _e277[0];
                        } else {
                            phi_486_ = _e277[1];
                        }
                        let _e319 = phi_486_;
                        let _e320 = (_e253 == 2u);
                        if _e320 {
                            phi_492_ = _e277[2];
                        } else {
                            phi_492_ = _e319;
                        }
                        let _e323 = phi_492_;
                        if _e315 {
                            phi_503_ = _e287[0];
                        } else {
                            phi_503_ = _e287[1];
                        }
                        let _e327 = phi_503_;
                        if _e320 {
                            phi_509_ = _e287[2];
                        } else {
                            phi_509_ = _e327;
                        }
                        let _e330 = phi_509_;
                        let _e332 = ((_e330 * _e266) * _e272);
                        let _e336 = (bitcast<f32>((bitcast<u32>(_e332) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e336 {
                            let _e340 = (bitcast<f32>((bitcast<u32>(_e323) & 2147483647u)) * 0.00000011920929f);
                            phi_532_ = select(0.00000000000011368684f, _e340, (_e340 > 0.00000000000011368684f));
                        } else {
                            phi_532_ = 0f;
                        }
                        let _e344 = phi_532_;
                        let _e345 = (_e323 + _e344);
                        let _e346 = (_e323 - _e344);
                        let _e347 = select(_e332, 0f, _e336);
                        if _e336 {
                            phi_543_ = 38685626000000000000000000f;
                        } else {
                            phi_543_ = (1f / _e332);
                        }
                        let _e350 = phi_543_;
                        let _e351 = (_e255 == 0u);
                        if _e351 {
                            phi_552_ = _e277[0];
                        } else {
                            phi_552_ = _e277[1];
                        }
                        let _e355 = phi_552_;
                        let _e356 = (_e255 == 2u);
                        if _e356 {
                            phi_558_ = _e277[2];
                        } else {
                            phi_558_ = _e355;
                        }
                        let _e359 = phi_558_;
                        if _e351 {
                            phi_569_ = _e287[0];
                        } else {
                            phi_569_ = _e287[1];
                        }
                        let _e363 = phi_569_;
                        if _e356 {
                            phi_575_ = _e287[2];
                        } else {
                            phi_575_ = _e363;
                        }
                        let _e366 = phi_575_;
                        let _e368 = ((_e366 * _e266) * _e272);
                        let _e372 = (bitcast<f32>((bitcast<u32>(_e368) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e372 {
                            let _e376 = (bitcast<f32>((bitcast<u32>(_e359) & 2147483647u)) * 0.00000011920929f);
                            phi_598_ = select(0.00000000000011368684f, _e376, (_e376 > 0.00000000000011368684f));
                        } else {
                            phi_598_ = 0f;
                        }
                        let _e380 = phi_598_;
                        let _e381 = (_e359 + _e380);
                        let _e382 = (_e359 - _e380);
                        let _e383 = select(_e368, 0f, _e372);
                        if _e372 {
                            phi_609_ = 38685626000000000000000000f;
                        } else {
                            phi_609_ = (1f / _e368);
                        }
                        let _e386 = phi_609_;
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
                            phi_709_ = select(-340282350000000000000000000000000000000f, _e426, (_e426 > -340282350000000000000000000000000000000f));
                            phi_710_ = select(-340282350000000000000000000000000000000f, _e419, (_e419 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_709_ = 0f;
                            phi_710_ = 1f;
                        }
                        let _e430 = phi_709_;
                        let _e432 = phi_710_;
                        if _e131 {
                        } else {
                            break;
                        }
                        let _e438 = global_4.member[_e124].member_2;
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
                        phi_3118_ = false;
                        phi_792_ = type_41(type_38(type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e430), 0u, 0u);
                        phi_795_ = type_52(type_50(array<f32, 3>(_e445, _e449, _e453), array<f32, 3>(_e457, _e459, _e461)), select(0u, 2147483648u, (_e82 == 0u)));
                        phi_797_ = ((3u * _e82) + 1u);
                        phi_799_ = (_e432 <= _e430);
                        phi_801_ = 0u;
                        loop {
                            let _e469 = phi_3118_;
                            let _e471 = phi_792_;
                            let _e473 = phi_795_;
                            let _e475 = phi_797_;
                            let _e477 = phi_799_;
                            let _e479 = phi_801_;
                            local_10 = _e471;
                            local_11 = _e471;
                            if _e477 {
                                phi_812_ = true;
                            } else {
                                phi_812_ = (_e479 > 0u);
                            }
                            let _e482 = phi_812_;
                            if _e482 {
                                let _e483 = (_e475 > 0u);
                                if _e483 {
                                    if _e477 {
                                        phi_898_ = _e473;
                                        phi_899_ = _e477;
                                        phi_900_ = _e479;
                                    } else {
                                        let _e484 = (_e479 - 1u);
                                        let _e485 = (_e484 % 128u);
                                        let _e486 = (_e485 < 128u);
                                        if _e486 {
                                        } else {
                                            phi_3254_ = true;
                                            break;
                                        }
                                        let _e488 = local_6[_e485];
                                        if _e486 {
                                        } else {
                                            phi_3254_ = true;
                                            break;
                                        }
                                        let _e490 = local_5[_e485];
                                        if _e486 {
                                        } else {
                                            phi_3254_ = true;
                                            break;
                                        }
                                        let _e492 = local_4[_e485];
                                        if _e486 {
                                        } else {
                                            phi_3254_ = true;
                                            break;
                                        }
                                        let _e494 = local_3[_e485];
                                        if _e486 {
                                        } else {
                                            phi_3254_ = true;
                                            break;
                                        }
                                        let _e497 = local_2[_e485];
                                        if _e486 {
                                        } else {
                                            phi_3254_ = true;
                                            break;
                                        }
                                        let _e499 = local_1[_e485];
                                        if _e486 {
                                        } else {
                                            phi_3254_ = true;
                                            break;
                                        }
                                        let _e501 = local[_e485];
                                        if _e486 {
                                        } else {
                                            phi_3254_ = true;
                                            break;
                                        }
                                        let _e506 = local_7[_e485];
                                        phi_898_ = type_52(type_50(array<f32, 3>(_e490, _e492, _e494), array<f32, 3>(_e497, _e499, _e501)), _e488);
                                        phi_899_ = (_e506 <= _e471.member.member_1);
                                        phi_900_ = _e484;
                                    }
                                    let _e511 = phi_898_;
                                    let _e513 = phi_899_;
                                    let _e515 = phi_900_;
                                    if _e513 {
                                        if ((_e511.member_1 & 2147483648u) != 0u) {
                                            phi_918_ = _e471;
                                            phi_921_ = type_7(0u, ((_e511.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e874 = phi_918_;
                                                let _e876 = phi_921_;
                                                local_12 = _e874;
                                                if (_e876.member < _e876.member_1) {
                                                    phi_922_ = type_7((_e876.member + 1u), _e876.member_1);
                                                    phi_944_ = type_7(1u, _e876.member);
                                                } else {
                                                    phi_922_ = _e876;
                                                    phi_944_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e889 = phi_922_;
                                                let _e891 = phi_944_;
                                                let _e895 = (bitcast<i32>(_e891.member) != 0i);
                                                if _e895 {
                                                    let _e901 = type_41(_e874.member, _e874.member_1, (_e874.member_2 + 1u));
                                                    let _e902 = ((_e511.member_1 & 268435455u) + _e891.member_1);
                                                    let _e903 = (_e902 < _e84);
                                                    if _e903 {
                                                        if _e903 {
                                                        } else {
                                                            phi_3112_ = true;
                                                            break;
                                                        }
                                                        let _e907 = global_1.member[_e902].member_1;
                                                        phi_968_ = _e907;
                                                    } else {
                                                        phi_968_ = 4294967295u;
                                                    }
                                                    let _e909 = phi_968_;
                                                    if (_e902 >= _e84) {
                                                        phi_1057_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e903 {
                                                        } else {
                                                            phi_3112_ = true;
                                                            break;
                                                        }
                                                        if (_e442 < 9u) {
                                                        } else {
                                                            phi_3112_ = true;
                                                            break;
                                                        }
                                                        let _e916 = global_1.member[_e902].member[_e442];
                                                        if (_e446 < 9u) {
                                                        } else {
                                                            phi_3112_ = true;
                                                            break;
                                                        }
                                                        let _e922 = global_1.member[_e902].member[_e446];
                                                        if (_e450 < 9u) {
                                                        } else {
                                                            phi_3112_ = true;
                                                            break;
                                                        }
                                                        let _e928 = global_1.member[_e902].member[_e450];
                                                        let _e930 = (3u + _e442);
                                                        if (_e930 < 9u) {
                                                        } else {
                                                            phi_3112_ = true;
                                                            break;
                                                        }
                                                        let _e936 = global_1.member[_e902].member[_e930];
                                                        let _e937 = (3u + _e446);
                                                        if (_e937 < 9u) {
                                                        } else {
                                                            phi_3112_ = true;
                                                            break;
                                                        }
                                                        let _e943 = global_1.member[_e902].member[_e937];
                                                        let _e944 = (3u + _e450);
                                                        if (_e944 < 9u) {
                                                        } else {
                                                            phi_3112_ = true;
                                                            break;
                                                        }
                                                        let _e950 = global_1.member[_e902].member[_e944];
                                                        let _e952 = (6u + _e442);
                                                        if (_e952 < 9u) {
                                                        } else {
                                                            phi_3112_ = true;
                                                            break;
                                                        }
                                                        let _e958 = global_1.member[_e902].member[_e952];
                                                        let _e959 = (6u + _e446);
                                                        if (_e959 < 9u) {
                                                        } else {
                                                            phi_3112_ = true;
                                                            break;
                                                        }
                                                        let _e965 = global_1.member[_e902].member[_e959];
                                                        let _e966 = (6u + _e450);
                                                        if (_e966 < 9u) {
                                                        } else {
                                                            phi_3112_ = true;
                                                            break;
                                                        }
                                                        let _e972 = global_1.member[_e902].member[_e966];
                                                        phi_1057_ = array<array<f32, 3>, 3>(array<f32, 3>(_e916, _e922, _e928), array<f32, 3>(_e936, _e943, _e950), array<f32, 3>(_e958, _e965, _e972));
                                                    }
                                                    let _e976 = phi_1057_;
                                                    let _e985 = (_e976[0][2] - _e359);
                                                    let _e988 = (((_e976[0][0] - _e286) * _e383) - (_e985 * _e311));
                                                    let _e991 = (((_e976[0][1] - _e323) * _e383) - (_e985 * _e347));
                                                    let _e998 = (_e976[1][2] - _e359);
                                                    let _e1001 = (((_e976[1][0] - _e286) * _e383) - (_e998 * _e311));
                                                    let _e1004 = (((_e976[1][1] - _e323) * _e383) - (_e998 * _e347));
                                                    let _e1011 = (_e976[2][2] - _e359);
                                                    let _e1014 = (((_e976[2][0] - _e286) * _e383) - (_e1011 * _e311));
                                                    let _e1017 = (((_e976[2][1] - _e323) * _e383) - (_e1011 * _e347));
                                                    let _e1018 = (_e1014 * _e1004);
                                                    let _e1019 = (_e1017 * _e1001);
                                                    let _e1020 = (_e988 * _e1017);
                                                    let _e1021 = (_e991 * _e1014);
                                                    let _e1022 = (_e1001 * _e991);
                                                    let _e1023 = (_e1004 * _e988);
                                                    let _e1028 = (((_e1018 >= _e1019) && (_e1020 >= _e1021)) && (_e1022 >= _e1023));
                                                    if (_e1028 || (((_e1018 <= _e1019) && (_e1020 <= _e1021)) && (_e1022 <= _e1023))) {
                                                        let _e1035 = select(-1f, 1f, _e1028);
                                                        let _e1037 = ((_e1018 - _e1019) * _e1035);
                                                        let _e1039 = select(0f, _e1037, (_e1037 > 0f));
                                                        let _e1041 = ((_e1020 - _e1021) * _e1035);
                                                        let _e1043 = select(0f, _e1041, (_e1041 > 0f));
                                                        let _e1045 = ((_e1022 - _e1023) * _e1035);
                                                        let _e1047 = select(0f, _e1045, (_e1045 > 0f));
                                                        let _e1049 = ((_e1039 + _e1043) + _e1047);
                                                        if (_e1049 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_1885_ = type_23();
                                                            phi_1886_ = true;
                                                            phi_1887_ = false;
                                                        } else {
                                                            let _e1052 = select(_e1001, _e988, (_e988 < _e1001));
                                                            if (select(_e1014, _e1052, (_e1052 < _e1014)) > 0f) {
                                                                phi_1174_ = true;
                                                            } else {
                                                                let _e1057 = select(_e1001, _e988, (_e988 > _e1001));
                                                                phi_1174_ = (select(_e1014, _e1057, (_e1057 > _e1014)) < 0f);
                                                            }
                                                            let _e1062 = phi_1174_;
                                                            if _e1062 {
                                                                phi_1882_ = type_23();
                                                                phi_1883_ = true;
                                                                phi_1884_ = false;
                                                            } else {
                                                                let _e1064 = select(_e1004, _e991, (_e991 < _e1004));
                                                                if (select(_e1017, _e1064, (_e1064 < _e1017)) > 0f) {
                                                                    phi_1203_ = true;
                                                                } else {
                                                                    let _e1069 = select(_e1004, _e991, (_e991 > _e1004));
                                                                    phi_1203_ = (select(_e1017, _e1069, (_e1069 > _e1017)) < 0f);
                                                                }
                                                                let _e1074 = phi_1203_;
                                                                if _e1074 {
                                                                    phi_1880_ = type_23();
                                                                    phi_1881_ = false;
                                                                } else {
                                                                    let _e1076 = select(_e976[1][0], _e976[0][0], (_e976[0][0] < _e976[1][0]));
                                                                    let _e1080 = select(_e976[1][0], _e976[0][0], (_e976[0][0] > _e976[1][0]));
                                                                    let _e1084 = select(_e976[1][1], _e976[0][1], (_e976[0][1] < _e976[1][1]));
                                                                    let _e1088 = select(_e976[1][1], _e976[0][1], (_e976[0][1] > _e976[1][1]));
                                                                    let _e1092 = select(_e976[1][2], _e976[0][2], (_e976[0][2] < _e976[1][2]));
                                                                    let _e1096 = select(_e976[1][2], _e976[0][2], (_e976[0][2] > _e976[1][2]));
                                                                    let _e1101 = ((select(_e976[2][0], _e1076, (_e1076 < _e976[2][0])) - _e309) * _e314);
                                                                    let _e1102 = ((select(_e976[2][0], _e1080, (_e1080 > _e976[2][0])) - _e310) * _e314);
                                                                    let _e1105 = ((select(_e976[2][1], _e1084, (_e1084 < _e976[2][1])) - _e345) * _e350);
                                                                    let _e1106 = ((select(_e976[2][1], _e1088, (_e1088 > _e976[2][1])) - _e346) * _e350);
                                                                    let _e1109 = ((select(_e976[2][2], _e1092, (_e1092 < _e976[2][2])) - _e381) * _e386);
                                                                    let _e1110 = ((select(_e976[2][2], _e1096, (_e1096 > _e976[2][2])) - _e382) * _e386);
                                                                    let _e1112 = select(_e1110, _e1109, (_e1109 < _e1110));
                                                                    let _e1114 = select(_e1110, _e1109, (_e1109 > _e1110));
                                                                    let _e1116 = select(_e1102, _e1101, (_e1101 < _e1102));
                                                                    let _e1118 = select(_e1106, _e1105, (_e1105 < _e1106));
                                                                    let _e1120 = select(_e1118, _e1116, (_e1116 > _e1118));
                                                                    let _e1122 = select(_e1112, _e1120, (_e1120 > _e1112));
                                                                    let _e1124 = select(_e1102, _e1101, (_e1101 > _e1102));
                                                                    let _e1126 = select(_e1106, _e1105, (_e1105 > _e1106));
                                                                    let _e1128 = select(_e1126, _e1124, (_e1124 < _e1126));
                                                                    let _e1130 = select(_e1114, _e1128, (_e1128 < _e1114));
                                                                    let _e1131 = -(_e1112);
                                                                    let _e1137 = select(_e432, _e1122, (_e1122 > _e432));
                                                                    if (_e1137 > (_e1130 + (select(_e1131, _e1114, (_e1114 > _e1131)) * 0.0000019073523f))) {
                                                                        phi_1875_ = type_23();
                                                                        phi_1876_ = true;
                                                                    } else {
                                                                        let _e1139 = (_e1137 > _e874.member.member_1);
                                                                        if _e1139 {
                                                                            phi_1874_ = type_23();
                                                                        } else {
                                                                            let _e1140 = vec3<f32>(_e976[0][0], _e976[0][1], _e976[0][2]);
                                                                            let _e1141 = vec3<f32>(_e976[1][0], _e976[1][1], _e976[1][2]);
                                                                            let _e1142 = vec3<f32>(_e976[2][0], _e976[2][1], _e976[2][2]);
                                                                            let _e1143 = (_e976[1][0] - _e976[0][0]);
                                                                            let _e1144 = (_e976[1][1] - _e976[0][1]);
                                                                            let _e1145 = (_e976[1][2] - _e976[0][2]);
                                                                            let _e1146 = vec3<f32>(_e1143, _e1144, _e1145);
                                                                            let _e1147 = (_e976[2][0] - _e976[1][0]);
                                                                            let _e1148 = (_e976[2][1] - _e976[1][1]);
                                                                            let _e1149 = (_e976[2][2] - _e976[1][2]);
                                                                            let _e1150 = vec3<f32>(_e1147, _e1148, _e1149);
                                                                            let _e1151 = (_e976[0][0] - _e976[2][0]);
                                                                            let _e1152 = (_e976[0][1] - _e976[2][1]);
                                                                            let _e1153 = (_e976[0][2] - _e976[2][2]);
                                                                            let _e1154 = vec3<f32>(_e1151, _e1152, _e1153);
                                                                            let _e1157 = bitcast<f32>((bitcast<u32>(_e1143) & 2147483647u));
                                                                            let _e1160 = bitcast<f32>((bitcast<u32>(_e1144) & 2147483647u));
                                                                            let _e1162 = select(_e1160, _e1157, (_e1157 > _e1160));
                                                                            let _e1165 = bitcast<f32>((bitcast<u32>(_e1145) & 2147483647u));
                                                                            let _e1167 = select(_e1165, _e1162, (_e1162 > _e1165));
                                                                            let _e1170 = bitcast<f32>((bitcast<u32>(_e1147) & 2147483647u));
                                                                            let _e1173 = bitcast<f32>((bitcast<u32>(_e1148) & 2147483647u));
                                                                            let _e1175 = select(_e1173, _e1170, (_e1170 > _e1173));
                                                                            let _e1178 = bitcast<f32>((bitcast<u32>(_e1149) & 2147483647u));
                                                                            let _e1180 = select(_e1178, _e1175, (_e1175 > _e1178));
                                                                            let _e1183 = bitcast<f32>((bitcast<u32>(_e1151) & 2147483647u));
                                                                            let _e1186 = bitcast<f32>((bitcast<u32>(_e1152) & 2147483647u));
                                                                            let _e1188 = select(_e1186, _e1183, (_e1183 > _e1186));
                                                                            let _e1191 = bitcast<f32>((bitcast<u32>(_e1153) & 2147483647u));
                                                                            let _e1193 = select(_e1191, _e1188, (_e1188 > _e1191));
                                                                            let _e1195 = select(_e1180, _e1167, (_e1167 > _e1180));
                                                                            let _e1197 = select(_e1193, _e1195, (_e1195 > _e1193));
                                                                            if (_e1167 == _e1197) {
                                                                                phi_1604_ = _e1004;
                                                                                phi_1605_ = _e1001;
                                                                                phi_1606_ = _e991;
                                                                                phi_1607_ = _e988;
                                                                                phi_1608_ = _e1140;
                                                                                phi_1609_ = _e1154;
                                                                                phi_1610_ = _e1150;
                                                                                phi_1611_ = _e1146;
                                                                            } else {
                                                                                let _e1199 = (_e1180 == _e1197);
                                                                                let _e1204 = vec3(_e1199);
                                                                                phi_1604_ = select(_e991, _e1017, _e1199);
                                                                                phi_1605_ = select(_e988, _e1014, _e1199);
                                                                                phi_1606_ = select(_e1017, _e1004, _e1199);
                                                                                phi_1607_ = select(_e1014, _e1001, _e1199);
                                                                                phi_1608_ = select(_e1142, _e1141, _e1204);
                                                                                phi_1609_ = select(_e1150, _e1146, _e1204);
                                                                                phi_1610_ = select(_e1146, _e1154, _e1204);
                                                                                phi_1611_ = select(_e1154, _e1150, _e1204);
                                                                            }
                                                                            let _e1210 = phi_1604_;
                                                                            let _e1212 = phi_1605_;
                                                                            let _e1214 = phi_1606_;
                                                                            let _e1216 = phi_1607_;
                                                                            let _e1218 = phi_1608_;
                                                                            let _e1220 = phi_1609_;
                                                                            let _e1222 = phi_1610_;
                                                                            let _e1224 = phi_1611_;
                                                                            let _e1231 = ((_e1222.y * _e1220.z) - (_e1220.y * _e1222.z));
                                                                            let _e1236 = ((_e1222.z * _e1220.x) - (_e1220.z * _e1222.x));
                                                                            let _e1239 = ((_e1222.x * _e1220.y) - (_e1220.x * _e1222.y));
                                                                            if (_e1039 >= _e1043) {
                                                                                phi_1642_ = select(true, false, (_e1039 >= _e1047));
                                                                            } else {
                                                                                phi_1642_ = true;
                                                                            }
                                                                            let _e1244 = phi_1642_;
                                                                            if _e1244 {
                                                                                phi_1651_ = select(_e1142, _e1141, vec3((_e1043 >= _e1047)));
                                                                            } else {
                                                                                phi_1651_ = _e1140;
                                                                            }
                                                                            let _e1249 = phi_1651_;
                                                                            let _e1254 = (((_e1231 * _e311) + (_e1236 * _e347)) + (_e1239 * _e383));
                                                                            let _e1265 = (((_e1231 * (_e1249.x - _e286)) + (_e1236 * (_e1249.y - _e323))) + (_e1239 * (_e1249.z - _e359)));
                                                                            let _e1267 = (_e1212 - _e1216);
                                                                            let _e1268 = (_e1210 - _e1214);
                                                                            let _e1276 = (-(((_e1216 * _e1267) + (_e1214 * _e1268))) / ((_e1267 * _e1267) + (_e1268 * _e1268)));
                                                                            let _e1278 = select(1f, _e1276, (_e1276 < 1f));
                                                                            let _e1280 = select(0f, _e1278, (_e1278 > 0f));
                                                                            let _e1293 = ((_e1218.x + (_e1224.x * _e1280)) - _e286);
                                                                            let _e1294 = ((_e1218.y + (_e1224.y * _e1280)) - _e323);
                                                                            let _e1295 = ((_e1218.z + (_e1224.z * _e1280)) - _e359);
                                                                            let _e1296 = (_e1295 / _e383);
                                                                            let _e1308 = bitcast<f32>((bitcast<u32>(_e1293) & 2147483647u));
                                                                            let _e1311 = bitcast<f32>((bitcast<u32>(_e1294) & 2147483647u));
                                                                            let _e1313 = select(_e1311, _e1308, (_e1308 > _e1311));
                                                                            let _e1316 = bitcast<f32>((bitcast<u32>(_e1295) & 2147483647u));
                                                                            let _e1318 = select(_e1316, _e1313, (_e1313 > _e1316));
                                                                            let _e1324 = bitcast<f32>((bitcast<u32>(_e1231) & 2147483647u));
                                                                            let _e1327 = bitcast<f32>((bitcast<u32>(_e1236) & 2147483647u));
                                                                            let _e1329 = select(_e1327, _e1324, (_e1324 > _e1327));
                                                                            let _e1332 = bitcast<f32>((bitcast<u32>(_e1239) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1231 * _e1293) + (_e1236 * _e1294)) + (_e1239 * _e1295)) - _e1265)) & 2147483647u)) <= ((0.0000009536743f * select(_e1197, _e1318, (_e1318 > _e1197))) * select(_e1332, _e1329, (_e1329 > _e1332)))) {
                                                                                let _e1342 = bitcast<f32>((bitcast<u32>(_e1222.x) & 2147483647u));
                                                                                let _e1345 = bitcast<f32>((bitcast<u32>(_e1222.y) & 2147483647u));
                                                                                let _e1347 = select(_e1345, _e1342, (_e1342 > _e1345));
                                                                                let _e1350 = bitcast<f32>((bitcast<u32>(_e1222.z) & 2147483647u));
                                                                                let _e1356 = bitcast<f32>((bitcast<u32>(_e1220.x) & 2147483647u));
                                                                                let _e1359 = bitcast<f32>((bitcast<u32>(_e1220.y) & 2147483647u));
                                                                                let _e1361 = select(_e1359, _e1356, (_e1356 > _e1359));
                                                                                let _e1364 = bitcast<f32>((bitcast<u32>(_e1220.z) & 2147483647u));
                                                                                phi_1818_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e1254) & 2147483647u)) > ((0.0000038146973f * select(_e1350, _e1347, (_e1347 > _e1350))) * select(_e1364, _e1361, (_e1361 > _e1364)))));
                                                                            } else {
                                                                                phi_1818_ = true;
                                                                            }
                                                                            let _e1371 = phi_1818_;
                                                                            if _e1371 {
                                                                                let _e1382 = ((((_e1231 * (_e1293 - (_e311 * _e1296))) + (_e1236 * (_e1294 - (_e347 * _e1296)))) + (_e1239 * (_e1295 - _e1295))) / _e1254);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1382) & 2147483647u)) <= _e1197) {
                                                                                    phi_1842_ = (_e1296 + _e1382);
                                                                                } else {
                                                                                    phi_1842_ = _e1296;
                                                                                }
                                                                                let _e1389 = phi_1842_;
                                                                                phi_1843_ = _e1389;
                                                                            } else {
                                                                                phi_1843_ = (_e1265 / _e1254);
                                                                            }
                                                                            let _e1391 = phi_1843_;
                                                                            let _e1393 = select(_e1130, _e1391, (_e1391 < _e1130));
                                                                            let _e1395 = select(_e1122, _e1393, (_e1393 > _e1122));
                                                                            if (_e1395 >= _e432) {
                                                                                let _e1397 = (_e1395 <= _e874.member.member_1);
                                                                                if _e1397 {
                                                                                    let _e1398 = (1f / _e1049);
                                                                                    phi_1866_ = type_23(_e1395, (_e1043 * _e1398), (_e1047 * _e1398), _e909);
                                                                                } else {
                                                                                    phi_1866_ = type_23();
                                                                                }
                                                                                let _e1403 = phi_1866_;
                                                                                phi_1868_ = _e1403;
                                                                                phi_1869_ = select(true, false, _e1397);
                                                                            } else {
                                                                                phi_1868_ = type_23();
                                                                                phi_1869_ = true;
                                                                            }
                                                                            let _e1406 = phi_1868_;
                                                                            let _e1408 = phi_1869_;
                                                                            if _e1408 {
                                                                                phi_1873_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_1873_ = _e1406;
                                                                            }
                                                                            let _e1410 = phi_1873_;
                                                                            phi_1874_ = _e1410;
                                                                        }
                                                                        let _e1412 = phi_1874_;
                                                                        phi_1875_ = _e1412;
                                                                        phi_1876_ = _e1139;
                                                                    }
                                                                    let _e1414 = phi_1875_;
                                                                    let _e1416 = phi_1876_;
                                                                    phi_1880_ = _e1414;
                                                                    phi_1881_ = _e1416;
                                                                }
                                                                let _e1418 = phi_1880_;
                                                                let _e1420 = phi_1881_;
                                                                phi_1882_ = _e1418;
                                                                phi_1883_ = _e1074;
                                                                phi_1884_ = _e1420;
                                                            }
                                                            let _e1422 = phi_1882_;
                                                            let _e1424 = phi_1883_;
                                                            let _e1426 = phi_1884_;
                                                            phi_1885_ = _e1422;
                                                            phi_1886_ = _e1424;
                                                            phi_1887_ = _e1426;
                                                        }
                                                        let _e1428 = phi_1885_;
                                                        let _e1430 = phi_1886_;
                                                        let _e1432 = phi_1887_;
                                                        phi_1895_ = _e1428;
                                                        phi_1896_ = select(_e1432, true, _e1430);
                                                    } else {
                                                        phi_1895_ = type_23();
                                                        phi_1896_ = true;
                                                    }
                                                    let _e1435 = phi_1895_;
                                                    let _e1437 = phi_1896_;
                                                    if _e1437 {
                                                        phi_1900_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1900_ = _e1435;
                                                    }
                                                    let _e1439 = phi_1900_;
                                                    if (_e1439.member_3 != 4294967295u) {
                                                        if (_e909 != _e438) {
                                                            if (_e1439.member < _e874.member.member.member) {
                                                                phi_1926_ = true;
                                                            } else {
                                                                if (_e1439.member == _e874.member.member.member) {
                                                                    phi_1925_ = (_e1439.member_3 < _e874.member.member.member_3);
                                                                } else {
                                                                    phi_1925_ = false;
                                                                }
                                                                let _e1454 = phi_1925_;
                                                                phi_1926_ = _e1454;
                                                            }
                                                            let _e1456 = phi_1926_;
                                                            if _e1456 {
                                                                phi_1933_ = type_41(type_38(_e1439, _e1439.member), _e901.member_1, _e901.member_2);
                                                            } else {
                                                                phi_1933_ = _e901;
                                                            }
                                                            let _e1463 = phi_1933_;
                                                            phi_1934_ = _e1463;
                                                        } else {
                                                            phi_1934_ = _e901;
                                                        }
                                                        let _e1465 = phi_1934_;
                                                        phi_1935_ = _e1465;
                                                    } else {
                                                        phi_1935_ = _e901;
                                                    }
                                                    let _e1467 = phi_1935_;
                                                    phi_919_ = _e1467;
                                                } else {
                                                    phi_919_ = type_41();
                                                }
                                                let _e1469 = phi_919_;
                                                continue;
                                                continuing {
                                                    phi_918_ = _e1469;
                                                    phi_921_ = _e889;
                                                    phi_3112_ = _e469;
                                                    break if !(_e895);
                                                }
                                            }
                                            let _e1472 = phi_3112_;
                                            phi_3254_ = _e1472;
                                            if _e1472 {
                                                break;
                                            }
                                            phi_3258_ = _e1472;
                                            let _e1699 = local_12;
                                            phi_2887_ = _e1699;
                                            phi_2888_ = _e511;
                                            phi_2889_ = false;
                                            phi_2890_ = _e515;
                                        } else {
                                            let _e530 = (_e511.member_1 < _e82);
                                            if _e530 {
                                                if _e530 {
                                                } else {
                                                    phi_3254_ = true;
                                                    break;
                                                }
                                                let _e532 = global_7.member[_e511.member_1];
                                                phi_1957_ = _e532;
                                            } else {
                                                phi_1957_ = type_45(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                            }
                                            let _e534 = phi_1957_;
                                            let _e549 = ((10u * _e254) & 31u);
                                            let _e552 = ((_e534.member[0] >> bitcast<u32>(_e549)) & 1023u);
                                            let _e557 = bitcast<f32>((bitcast<u32>(((_e511.member.member_1[0] - _e511.member.member[0]) * 0.0009775171f)) ^ _e120));
                                            let _e563 = (_e511.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e552) * _e557)) ^ _e120)));
                                            let _e567 = select(select(_e511.member.member_1[0], _e563, (_e563 < _e511.member.member_1[0])), _e511.member.member_1[0], (_e552 == 1023u));
                                            let _e569 = ((10u * _e253) & 31u);
                                            let _e572 = ((_e534.member[0] >> bitcast<u32>(_e569)) & 1023u);
                                            let _e577 = bitcast<f32>((bitcast<u32>(((_e511.member.member_1[1] - _e511.member.member[1]) * 0.0009775171f)) ^ _e120));
                                            let _e583 = (_e511.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e572) * _e577)) ^ _e120)));
                                            let _e587 = select(select(_e511.member.member_1[1], _e583, (_e583 < _e511.member.member_1[1])), _e511.member.member_1[1], (_e572 == 1023u));
                                            let _e589 = ((10u * _e255) & 31u);
                                            let _e592 = ((_e534.member[0] >> bitcast<u32>(_e589)) & 1023u);
                                            let _e597 = bitcast<f32>((bitcast<u32>(((_e511.member.member_1[2] - _e511.member.member[2]) * 0.0009775171f)) ^ _e120));
                                            let _e603 = (_e511.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e592) * _e597)) ^ _e120)));
                                            let _e607 = select(select(_e511.member.member_1[2], _e603, (_e603 < _e511.member.member_1[2])), _e511.member.member_1[2], (_e592 == 1023u));
                                            let _e610 = ((_e534.member[1] >> bitcast<u32>(_e549)) & 1023u);
                                            let _e616 = (_e511.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e610) * _e557)) ^ _e120)));
                                            let _e620 = select(select(_e511.member.member_1[0], _e616, (_e616 < _e511.member.member_1[0])), _e511.member.member_1[0], (_e610 == 1023u));
                                            let _e623 = ((_e534.member[1] >> bitcast<u32>(_e569)) & 1023u);
                                            let _e629 = (_e511.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e623) * _e577)) ^ _e120)));
                                            let _e633 = select(select(_e511.member.member_1[1], _e629, (_e629 < _e511.member.member_1[1])), _e511.member.member_1[1], (_e623 == 1023u));
                                            let _e636 = ((_e534.member[1] >> bitcast<u32>(_e589)) & 1023u);
                                            let _e642 = (_e511.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e636) * _e597)) ^ _e120)));
                                            let _e646 = select(select(_e511.member.member_1[2], _e642, (_e642 < _e511.member.member_1[2])), _e511.member.member_1[2], (_e636 == 1023u));
                                            let _e652 = ((_e534.member_1[0] >> bitcast<u32>(_e549)) & 1023u);
                                            let _e658 = (_e511.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e652) * _e557)) ^ _e120)));
                                            let _e662 = select(select(_e511.member.member_1[0], _e658, (_e658 < _e511.member.member_1[0])), _e511.member.member_1[0], (_e652 == 1023u));
                                            let _e665 = ((_e534.member_1[0] >> bitcast<u32>(_e569)) & 1023u);
                                            let _e671 = (_e511.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e665) * _e577)) ^ _e120)));
                                            let _e675 = select(select(_e511.member.member_1[1], _e671, (_e671 < _e511.member.member_1[1])), _e511.member.member_1[1], (_e665 == 1023u));
                                            let _e678 = ((_e534.member_1[0] >> bitcast<u32>(_e589)) & 1023u);
                                            let _e684 = (_e511.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e678) * _e597)) ^ _e120)));
                                            let _e688 = select(select(_e511.member.member_1[2], _e684, (_e684 < _e511.member.member_1[2])), _e511.member.member_1[2], (_e678 == 1023u));
                                            let _e691 = ((_e534.member_1[1] >> bitcast<u32>(_e549)) & 1023u);
                                            let _e697 = (_e511.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e691) * _e557)) ^ _e120)));
                                            let _e701 = select(select(_e511.member.member_1[0], _e697, (_e697 < _e511.member.member_1[0])), _e511.member.member_1[0], (_e691 == 1023u));
                                            let _e704 = ((_e534.member_1[1] >> bitcast<u32>(_e569)) & 1023u);
                                            let _e710 = (_e511.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e704) * _e577)) ^ _e120)));
                                            let _e714 = select(select(_e511.member.member_1[1], _e710, (_e710 < _e511.member.member_1[1])), _e511.member.member_1[1], (_e704 == 1023u));
                                            let _e717 = ((_e534.member_1[1] >> bitcast<u32>(_e589)) & 1023u);
                                            let _e723 = (_e511.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e717) * _e597)) ^ _e120)));
                                            let _e727 = select(select(_e511.member.member_1[2], _e723, (_e723 < _e511.member.member_1[2])), _e511.member.member_1[2], (_e717 == 1023u));
                                            let _e732 = type_52(type_50(array<f32, 3>(_e567, _e587, _e607), array<f32, 3>(_e620, _e633, _e646)), _e534.member_2);
                                            let _e737 = type_52(type_50(array<f32, 3>(_e662, _e675, _e688), array<f32, 3>(_e701, _e714, _e727)), _e534.member_3);
                                            let _e744 = ((_e567 - _e309) * _e314);
                                            let _e745 = ((_e662 - _e309) * _e314);
                                            let _e746 = ((_e620 - _e310) * _e314);
                                            let _e747 = ((_e701 - _e310) * _e314);
                                            let _e752 = ((_e587 - _e345) * _e350);
                                            let _e753 = ((_e675 - _e345) * _e350);
                                            let _e754 = ((_e633 - _e346) * _e350);
                                            let _e755 = ((_e714 - _e346) * _e350);
                                            let _e760 = ((_e607 - _e381) * _e386);
                                            let _e761 = ((_e688 - _e381) * _e386);
                                            let _e762 = ((_e646 - _e382) * _e386);
                                            let _e763 = ((_e727 - _e382) * _e386);
                                            let _e765 = select(_e762, _e760, (_e760 < _e762));
                                            let _e767 = select(_e763, _e761, (_e761 < _e763));
                                            let _e769 = select(_e762, _e760, (_e760 > _e762));
                                            let _e771 = select(_e763, _e761, (_e761 > _e763));
                                            let _e773 = select(_e746, _e744, (_e744 < _e746));
                                            let _e775 = select(_e747, _e745, (_e745 < _e747));
                                            let _e777 = select(_e754, _e752, (_e752 < _e754));
                                            let _e779 = select(_e755, _e753, (_e753 < _e755));
                                            let _e781 = select(_e777, _e773, (_e773 > _e777));
                                            let _e783 = select(_e779, _e775, (_e775 > _e779));
                                            let _e785 = select(_e765, _e781, (_e781 > _e765));
                                            let _e787 = select(_e767, _e783, (_e783 > _e767));
                                            let _e789 = select(_e746, _e744, (_e744 > _e746));
                                            let _e791 = select(_e747, _e745, (_e745 > _e747));
                                            let _e793 = select(_e754, _e752, (_e752 > _e754));
                                            let _e795 = select(_e755, _e753, (_e753 > _e755));
                                            let _e797 = select(_e793, _e789, (_e789 < _e793));
                                            let _e799 = select(_e795, _e791, (_e791 < _e795));
                                            let _e804 = -(_e765);
                                            let _e805 = -(_e767);
                                            let _e812 = (select(_e769, _e797, (_e797 < _e769)) + (select(_e804, _e769, (_e769 > _e804)) * 0.0000019073523f));
                                            let _e813 = (select(_e771, _e799, (_e799 < _e771)) + (select(_e805, _e771, (_e771 > _e805)) * 0.0000019073523f));
                                            let _e815 = select(_e432, _e785, (_e785 > _e432));
                                            let _e817 = select(_e432, _e787, (_e787 > _e432));
                                            let _e822 = (_e815 <= select(_e471.member.member_1, _e812, (_e812 < _e471.member.member_1)));
                                            let _e823 = (_e817 <= select(_e471.member.member_1, _e813, (_e813 < _e471.member.member_1)));
                                            let _e824 = (_e815 <= _e817);
                                            if _e822 {
                                                if _e823 {
                                                    if _e824 {
                                                        phi_2789_ = _e737;
                                                    } else {
                                                        phi_2789_ = _e732;
                                                    }
                                                    let _e826 = phi_2789_;
                                                    let _e834 = (_e515 % 128u);
                                                    let _e835 = (_e834 < 128u);
                                                    if _e835 {
                                                    } else {
                                                        phi_3254_ = true;
                                                        break;
                                                    }
                                                    local_6[_e834] = _e826.member_1;
                                                    if _e835 {
                                                    } else {
                                                        phi_3254_ = true;
                                                        break;
                                                    }
                                                    local_5[_e834] = _e826.member.member[0];
                                                    if _e835 {
                                                    } else {
                                                        phi_3254_ = true;
                                                        break;
                                                    }
                                                    local_4[_e834] = _e826.member.member[1];
                                                    if _e835 {
                                                    } else {
                                                        phi_3254_ = true;
                                                        break;
                                                    }
                                                    local_3[_e834] = _e826.member.member[2];
                                                    if _e835 {
                                                    } else {
                                                        phi_3254_ = true;
                                                        break;
                                                    }
                                                    local_2[_e834] = _e826.member.member_1[0];
                                                    if _e835 {
                                                    } else {
                                                        phi_3254_ = true;
                                                        break;
                                                    }
                                                    local_1[_e834] = _e826.member.member_1[1];
                                                    if _e835 {
                                                    } else {
                                                        phi_3254_ = true;
                                                        break;
                                                    }
                                                    local[_e834] = _e826.member.member_1[2];
                                                    if _e835 {
                                                    } else {
                                                        phi_3254_ = true;
                                                        break;
                                                    }
                                                    local_7[_e834] = select(_e817, _e815, (_e815 > _e817));
                                                    if _e824 {
                                                        phi_2866_ = _e732;
                                                    } else {
                                                        phi_2866_ = _e737;
                                                    }
                                                    let _e852 = phi_2866_;
                                                    phi_2867_ = _e852;
                                                    phi_2868_ = (_e515 + 1u);
                                                } else {
                                                    phi_2867_ = type_52();
                                                    phi_2868_ = u32();
                                                }
                                                let _e854 = phi_2867_;
                                                let _e856 = phi_2868_;
                                                phi_2870_ = _e854;
                                                phi_2871_ = _e856;
                                                phi_2872_ = select(true, false, _e823);
                                            } else {
                                                phi_2870_ = type_52();
                                                phi_2871_ = u32();
                                                phi_2872_ = true;
                                            }
                                            let _e859 = phi_2870_;
                                            let _e861 = phi_2871_;
                                            let _e863 = phi_2872_;
                                            if _e863 {
                                                if _e822 {
                                                    phi_2879_ = _e732;
                                                } else {
                                                    phi_2879_ = _e737;
                                                }
                                                let _e865 = phi_2879_;
                                                phi_2884_ = _e865;
                                                phi_2885_ = select(_e823, true, _e822);
                                            } else {
                                                phi_2884_ = _e859;
                                                phi_2885_ = _e513;
                                            }
                                            let _e868 = phi_2884_;
                                            let _e870 = phi_2885_;
                                            phi_3258_ = _e469;
                                            phi_2887_ = type_41(_e471.member, (_e471.member_1 + 1u), _e471.member_2);
                                            phi_2888_ = _e868;
                                            phi_2889_ = _e870;
                                            phi_2890_ = select(_e861, _e515, _e863);
                                        }
                                        let _e1474 = phi_3258_;
                                        let _e1476 = phi_2887_;
                                        let _e1478 = phi_2888_;
                                        let _e1480 = phi_2889_;
                                        let _e1482 = phi_2890_;
                                        phi_3257_ = _e1474;
                                        phi_2891_ = _e1476;
                                        phi_2892_ = _e1478;
                                        phi_2893_ = (_e475 - 1u);
                                        phi_2894_ = _e1480;
                                        phi_2895_ = _e1482;
                                    } else {
                                        phi_3257_ = _e469;
                                        phi_2891_ = _e471;
                                        phi_2892_ = _e511;
                                        phi_2893_ = _e475;
                                        phi_2894_ = _e513;
                                        phi_2895_ = _e515;
                                    }
                                    let _e1484 = phi_3257_;
                                    let _e1486 = phi_2891_;
                                    let _e1488 = phi_2892_;
                                    let _e1490 = phi_2893_;
                                    let _e1492 = phi_2894_;
                                    let _e1494 = phi_2895_;
                                    phi_3256_ = _e1484;
                                    phi_2896_ = _e1486;
                                    phi_2897_ = _e1488;
                                    phi_2898_ = _e1490;
                                    phi_2899_ = _e1492;
                                    phi_2900_ = _e1494;
                                } else {
                                    phi_3256_ = _e469;
                                    phi_2896_ = type_41();
                                    phi_2897_ = type_52();
                                    phi_2898_ = u32();
                                    phi_2899_ = bool();
                                    phi_2900_ = u32();
                                }
                                let _e1496 = phi_3256_;
                                let _e1498 = phi_2896_;
                                let _e1500 = phi_2897_;
                                let _e1502 = phi_2898_;
                                let _e1504 = phi_2899_;
                                let _e1506 = phi_2900_;
                                phi_3255_ = _e1496;
                                phi_793_ = _e1498;
                                phi_796_ = _e1500;
                                phi_798_ = _e1502;
                                phi_800_ = _e1504;
                                phi_802_ = _e1506;
                                phi_2901_ = _e483;
                            } else {
                                phi_3255_ = _e469;
                                phi_793_ = type_41();
                                phi_796_ = type_52();
                                phi_798_ = u32();
                                phi_800_ = bool();
                                phi_802_ = u32();
                                phi_2901_ = false;
                            }
                            let _e1508 = phi_3255_;
                            let _e1510 = phi_793_;
                            let _e1512 = phi_796_;
                            let _e1514 = phi_798_;
                            let _e1516 = phi_800_;
                            let _e1518 = phi_802_;
                            let _e1520 = phi_2901_;
                            continue;
                            continuing {
                                phi_3118_ = _e1508;
                                phi_792_ = _e1510;
                                phi_795_ = _e1512;
                                phi_797_ = _e1514;
                                phi_799_ = _e1516;
                                phi_801_ = _e1518;
                                phi_3254_ = _e1508;
                                break if !(_e1520);
                            }
                        }
                        let _e1523 = phi_3254_;
                        if _e1523 {
                            break;
                        }
                        let _e1525 = local_10;
                        if (_e1525.member.member.member_3 != 4294967295u) {
                            let _e1531 = (_e256 / 3i);
                            let _e1538 = bitcast<f32>((bitcast<u32>((_e1531 + 127i)) << bitcast<u32>(23i)));
                            let _e1546 = (((_e1525.member.member.member * _e1538) * _e1538) * bitcast<f32>((bitcast<u32>(((_e256 - (2i * _e1531)) + 127i)) << bitcast<u32>(23i))));
                            let _e1548 = select(340282350000000000000000000000000000000f, _e1546, (_e1546 < 340282350000000000000000000000000000000f));
                            phi_2953_ = type_23(select(-340282350000000000000000000000000000000f, _e1548, (_e1548 > -340282350000000000000000000000000000000f)), _e1525.member.member.member_1, _e1525.member.member.member_2, _e1525.member.member.member_3);
                        } else {
                            phi_2953_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1555 = phi_2953_;
                        if _e132 {
                        } else {
                            break;
                        }
                        global_2.member[_e124] = _e1555;
                        let _e1559 = local_11;
                        if _e133 {
                        } else {
                            break;
                        }
                        global_5.member[_e124] = _e1559.member_1;
                        if _e131 {
                        } else {
                            break;
                        }
                        let _e1564 = select(0u, 1u, (_e200 <= _e210));
                        if (_e1564 > 0u) {
                            let _e1566 = (1u < _e92);
                            if _e1566 {
                                if (0u < _e92) {
                                } else {
                                    break;
                                }
                                let _e1570 = atomicAdd((&global_6.member[0u]), _e1564);
                                if ((_e1570 + _e1564) < _e1570) {
                                    if _e1566 {
                                    } else {
                                        break;
                                    }
                                    let _e1575 = atomicAdd((&global_6.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1578 = select(0u, 1u, (_e1555.member_3 != 4294967295u));
                        if (_e1578 > 0u) {
                            let _e1580 = (3u < _e92);
                            if _e1580 {
                                if (2u < _e92) {
                                } else {
                                    break;
                                }
                                let _e1584 = atomicAdd((&global_6.member[2u]), _e1578);
                                if ((_e1584 + _e1578) < _e1584) {
                                    if _e1580 {
                                    } else {
                                        break;
                                    }
                                    let _e1589 = atomicAdd((&global_6.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1559.member_1 > 0u) {
                            let _e1591 = (5u < _e92);
                            if _e1591 {
                                if (4u < _e92) {
                                } else {
                                    break;
                                }
                                let _e1595 = atomicAdd((&global_6.member[4u]), _e1559.member_1);
                                if ((_e1595 + _e1559.member_1) < _e1595) {
                                    if _e1591 {
                                    } else {
                                        break;
                                    }
                                    let _e1600 = atomicAdd((&global_6.member[5u]), 1u);
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
