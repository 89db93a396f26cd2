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

struct type_21 {
    member: array<array<u32, 2>>,
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

struct type_32 {
    member: type_25,
    member_1: f32,
}

struct type_36 {
    member: array<type_26>,
}

struct type_38 {
    member: type_32,
    member_1: u32,
    member_2: u32,
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
var<storage> global_4: type_36;
@group(0) @binding(2) 
var<storage> global_5: type_44;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_21;

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
    var phi_342_: i32;
    var phi_343_: i32;
    var phi_353_: bool;
    var phi_363_: u32;
    var phi_364_: u32;
    var phi_366_: bool;
    var phi_371_: u32;
    var phi_384_: i32;
    var phi_404_: i32;
    var phi_422_: f32;
    var phi_428_: f32;
    var phi_468_: f32;
    var phi_474_: f32;
    var phi_526_: f32;
    var phi_538_: f32;
    var phi_547_: f32;
    var phi_553_: f32;
    var phi_593_: f32;
    var phi_599_: f32;
    var phi_651_: f32;
    var phi_663_: f32;
    var phi_672_: f32;
    var phi_678_: f32;
    var phi_718_: f32;
    var phi_724_: f32;
    var phi_776_: f32;
    var phi_788_: f32;
    var phi_843_: i32;
    var phi_865_: u32;
    var phi_866_: u32;
    var phi_903_: i32;
    var phi_925_: u32;
    var phi_926_: u32;
    var phi_934_: f32;
    var phi_935_: f32;
    var phi_3312_: bool;
    var phi_1019_: type_38;
    var phi_1022_: bool;
    var phi_1024_: u32;
    var phi_1026_: u32;
    var phi_1028_: type_49;
    var phi_1039_: bool;
    var phi_1125_: bool;
    var phi_1126_: u32;
    var phi_1127_: type_49;
    var phi_2247_: type_42;
    var phi_3136_: type_49;
    var phi_3213_: type_49;
    var phi_3214_: u32;
    var phi_3215_: type_49;
    var phi_3217_: u32;
    var phi_3218_: type_49;
    var phi_3219_: bool;
    var phi_3226_: type_49;
    var phi_3231_: bool;
    var phi_3233_: type_49;
    var phi_1145_: type_38;
    var phi_1148_: type_4;
    var phi_1149_: type_4;
    var phi_1171_: type_4;
    var phi_1195_: u32;
    var phi_1287_: array<array<f32, 3>, 3>;
    var phi_1439_: bool;
    var phi_1468_: bool;
    var phi_1887_: f32;
    var phi_1888_: f32;
    var phi_1889_: f32;
    var phi_1890_: f32;
    var phi_1891_: vec3<f32>;
    var phi_1892_: vec3<f32>;
    var phi_1893_: vec3<f32>;
    var phi_1894_: vec3<f32>;
    var phi_1931_: bool;
    var phi_1940_: vec3<f32>;
    var phi_2105_: f32;
    var phi_2107_: f32;
    var phi_2108_: bool;
    var phi_2128_: f32;
    var phi_2129_: f32;
    var phi_2152_: type_25;
    var phi_2154_: type_25;
    var phi_2155_: bool;
    var phi_2159_: type_25;
    var phi_2160_: type_25;
    var phi_2161_: type_25;
    var phi_2162_: bool;
    var phi_2166_: type_25;
    var phi_2167_: bool;
    var phi_2168_: type_25;
    var phi_2169_: bool;
    var phi_2170_: bool;
    var phi_2171_: type_25;
    var phi_2172_: bool;
    var phi_2173_: bool;
    var phi_2181_: type_25;
    var phi_2182_: bool;
    var phi_2186_: type_25;
    var phi_2211_: bool;
    var phi_2212_: bool;
    var phi_2219_: type_38;
    var phi_2220_: type_38;
    var phi_2221_: type_38;
    var phi_1146_: type_38;
    var phi_3306_: bool;
    var phi_3470_: bool;
    var phi_3238_: type_38;
    var phi_3239_: bool;
    var phi_3240_: u32;
    var phi_3241_: type_49;
    var phi_3469_: bool;
    var phi_3242_: type_38;
    var phi_3243_: bool;
    var phi_3244_: u32;
    var phi_3245_: u32;
    var phi_3246_: type_49;
    var phi_3468_: bool;
    var phi_3247_: type_38;
    var phi_3248_: bool;
    var phi_3249_: u32;
    var phi_3250_: u32;
    var phi_3251_: type_49;
    var phi_3467_: bool;
    var phi_1020_: type_38;
    var phi_1023_: bool;
    var phi_1025_: u32;
    var phi_1027_: u32;
    var phi_1029_: type_49;
    var phi_3252_: bool;
    var phi_3466_: bool;
    var local_10: type_38;
    var local_11: type_38;
    var local_12: type_38;

    switch bitcast<i32>(0u) {
        default: {
            let _e81 = global;
            let _e84 = arrayLength((&global_5.member));
            let _e86 = arrayLength((&global_2.member));
            let _e94 = global_3.member[0u][0u];
            let _e98 = global_3.member[0u][1u];
            let _e102 = global_3.member[0u][2u];
            let _e106 = global_3.member[1u][0u];
            let _e110 = global_3.member[1u][1u];
            let _e114 = global_3.member[1u][2u];
            let _e118 = global_3.member[1u][3u];
            let _e121 = global_1.member[0u];
            let _e122 = bitcast<i32>(_e121);
            let _e132 = (_e81.x + (_e81.y * 2097152u));
            let _e133 = (_e132 < arrayLength((&global_4.member)));
            if _e133 {
                let _e134 = (_e132 < arrayLength((&global_6.member)));
                if _e134 {
                    if _e133 {
                    } else {
                        break;
                    }
                    let _e142 = global_4.member[_e132].member_2[0u];
                    let _e144 = (bitcast<u32>(_e142) & 2147483647u);
                    let _e149 = global_4.member[_e132].member_2[1u];
                    let _e151 = (bitcast<u32>(_e149) & 2147483647u);
                    let _e156 = global_4.member[_e132].member_2[2u];
                    let _e158 = (bitcast<u32>(_e156) & 2147483647u);
                    let _e163 = global_4.member[_e132].member[0u];
                    let _e165 = (bitcast<u32>(_e163) & 2147483647u);
                    let _e170 = global_4.member[_e132].member[1u];
                    let _e172 = (bitcast<u32>(_e170) & 2147483647u);
                    let _e177 = global_4.member[_e132].member[2u];
                    let _e179 = (bitcast<u32>(_e177) & 2147483647u);
                    let _e181 = select(_e151, _e144, (_e151 < _e144));
                    let _e183 = select(_e158, _e181, (_e158 < _e181));
                    let _e185 = select(_e165, _e183, (_e165 < _e183));
                    let _e187 = select(_e172, _e185, (_e172 < _e185));
                    let _e189 = select(_e179, _e187, (_e179 < _e187));
                    let _e193 = global_4.member[_e132].member_1;
                    let _e194 = bitcast<u32>(_e193);
                    let _e195 = (_e194 & 2147483647u);
                    let _e202 = global_4.member[_e132].member_3;
                    let _e203 = bitcast<u32>(_e202);
                    let _e204 = (_e203 & 2147483647u);
                    let _e208 = (((select(_e195, _e189, (_e195 < _e189)) < 2139095040u) && (_e204 <= 2139095040u)) && (_e183 > 0u));
                    if _e208 {
                        let _e211 = (bitcast<u32>(bitcast<f32>(_e183)) & 2147483647u);
                        if (_e211 >= 8388608u) {
                            phi_342_ = (bitcast<i32>((_e211 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_342_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e211)), 32u, (_e211 == 0u))));
                        }
                        let _e225 = phi_342_;
                        phi_343_ = _e225;
                    } else {
                        phi_343_ = 0i;
                    }
                    let _e227 = phi_343_;
                    let _e228 = (_e144 == _e183);
                    if _e228 {
                        phi_353_ = true;
                    } else {
                        phi_353_ = (_e151 == _e183);
                    }
                    let _e231 = phi_353_;
                    let _e232 = select(1u, 0u, _e228);
                    if _e231 {
                        let _e233 = (_e232 + 1u);
                        phi_363_ = _e233;
                        phi_364_ = _e233;
                        phi_366_ = select(true, false, (_e233 == 2u));
                    } else {
                        phi_363_ = u32();
                        phi_364_ = 0u;
                        phi_366_ = true;
                    }
                    let _e237 = phi_363_;
                    let _e239 = phi_364_;
                    let _e241 = phi_366_;
                    if _e241 {
                        phi_371_ = (_e239 + 1u);
                    } else {
                        phi_371_ = 0u;
                    }
                    let _e245 = phi_371_;
                    let _e246 = select(_e237, _e239, _e241);
                    let _e247 = select(_e232, select(2u, _e232, _e231), _e241);
                    if (_e122 < -126i) {
                        phi_384_ = -126i;
                    } else {
                        phi_384_ = select(_e122, 127i, (_e122 > 127i));
                    }
                    let _e252 = phi_384_;
                    let _e257 = bitcast<f32>((bitcast<u32>((_e252 + 127i)) << bitcast<u32>(23i)));
                    let _e263 = bitcast<f32>((bitcast<u32>(((_e122 - _e252) + 127i)) << bitcast<u32>(23i)));
                    let _e264 = -(_e227);
                    if (_e264 < -126i) {
                        phi_404_ = -126i;
                    } else {
                        phi_404_ = select(_e264, 127i, (_e264 > 127i));
                    }
                    let _e269 = phi_404_;
                    let _e274 = bitcast<f32>((bitcast<u32>((_e269 + 127i)) << bitcast<u32>(23i)));
                    let _e280 = bitcast<f32>((bitcast<u32>(((_e264 - _e269) + 127i)) << bitcast<u32>(23i)));
                    let _e284 = global_4.member[_e132].member;
                    let _e285 = (_e246 == 0u);
                    if _e285 {
                        phi_422_ = _e284[0];
                    } else {
                        phi_422_ = _e284[1];
                    }
                    let _e289 = phi_422_;
                    let _e290 = (_e246 == 2u);
                    if _e290 {
                        phi_428_ = _e284[2];
                    } else {
                        phi_428_ = _e289;
                    }
                    let _e293 = phi_428_;
                    let _e294 = bitcast<u32>(_e293);
                    let _e296 = ((_e294 & 2139095040u) != 0u);
                    let _e310 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e294 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e294 & 2147483648u))), _e293, _e296) * _e257) * select(0.00000011920929f, 1f, _e296)) * _e263);
                    let _e311 = global_4.member[_e132].member_2;
                    if _e285 {
                        phi_468_ = _e311[0];
                    } else {
                        phi_468_ = _e311[1];
                    }
                    let _e315 = phi_468_;
                    if _e290 {
                        phi_474_ = _e311[2];
                    } else {
                        phi_474_ = _e315;
                    }
                    let _e318 = phi_474_;
                    let _e319 = bitcast<u32>(_e318);
                    let _e321 = ((_e319 & 2139095040u) != 0u);
                    let _e335 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e319 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e319 & 2147483648u))), _e318, _e321) * _e274) * select(0.00000011920929f, 1f, _e321)) * _e280);
                    let _e339 = (bitcast<f32>((bitcast<u32>(_e335) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e339 {
                        let _e343 = (bitcast<f32>((bitcast<u32>(_e310) & 2147483647u)) * 0.00000011920929f);
                        phi_526_ = select(0.00000000000011368684f, _e343, (_e343 > 0.00000000000011368684f));
                    } else {
                        phi_526_ = 0f;
                    }
                    let _e347 = phi_526_;
                    let _e348 = (_e310 + _e347);
                    let _e349 = (_e310 - _e347);
                    let _e350 = select(_e335, 0f, _e339);
                    if _e339 {
                        phi_538_ = 38685626000000000000000000f;
                    } else {
                        phi_538_ = (1f / _e335);
                    }
                    let _e353 = phi_538_;
                    let _e354 = (_e245 == 0u);
                    if _e354 {
                        phi_547_ = _e284[0];
                    } else {
                        phi_547_ = _e284[1];
                    }
                    let _e358 = phi_547_;
                    let _e359 = (_e245 == 2u);
                    if _e359 {
                        phi_553_ = _e284[2];
                    } else {
                        phi_553_ = _e358;
                    }
                    let _e362 = phi_553_;
                    let _e363 = bitcast<u32>(_e362);
                    let _e365 = ((_e363 & 2139095040u) != 0u);
                    let _e379 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e363 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e363 & 2147483648u))), _e362, _e365) * _e257) * select(0.00000011920929f, 1f, _e365)) * _e263);
                    if _e354 {
                        phi_593_ = _e311[0];
                    } else {
                        phi_593_ = _e311[1];
                    }
                    let _e383 = phi_593_;
                    if _e359 {
                        phi_599_ = _e311[2];
                    } else {
                        phi_599_ = _e383;
                    }
                    let _e386 = phi_599_;
                    let _e387 = bitcast<u32>(_e386);
                    let _e389 = ((_e387 & 2139095040u) != 0u);
                    let _e403 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e387 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e387 & 2147483648u))), _e386, _e389) * _e274) * select(0.00000011920929f, 1f, _e389)) * _e280);
                    let _e407 = (bitcast<f32>((bitcast<u32>(_e403) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e407 {
                        let _e411 = (bitcast<f32>((bitcast<u32>(_e379) & 2147483647u)) * 0.00000011920929f);
                        phi_651_ = select(0.00000000000011368684f, _e411, (_e411 > 0.00000000000011368684f));
                    } else {
                        phi_651_ = 0f;
                    }
                    let _e415 = phi_651_;
                    let _e416 = (_e379 + _e415);
                    let _e417 = (_e379 - _e415);
                    let _e418 = select(_e403, 0f, _e407);
                    if _e407 {
                        phi_663_ = 38685626000000000000000000f;
                    } else {
                        phi_663_ = (1f / _e403);
                    }
                    let _e421 = phi_663_;
                    let _e422 = (_e247 == 0u);
                    if _e422 {
                        phi_672_ = _e284[0];
                    } else {
                        phi_672_ = _e284[1];
                    }
                    let _e426 = phi_672_;
                    let _e427 = (_e247 == 2u);
                    if _e427 {
                        phi_678_ = _e284[2];
                    } else {
                        phi_678_ = _e426;
                    }
                    let _e430 = phi_678_;
                    let _e431 = bitcast<u32>(_e430);
                    let _e433 = ((_e431 & 2139095040u) != 0u);
                    let _e447 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e431 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e431 & 2147483648u))), _e430, _e433) * _e257) * select(0.00000011920929f, 1f, _e433)) * _e263);
                    if _e422 {
                        phi_718_ = _e311[0];
                    } else {
                        phi_718_ = _e311[1];
                    }
                    let _e451 = phi_718_;
                    if _e427 {
                        phi_724_ = _e311[2];
                    } else {
                        phi_724_ = _e451;
                    }
                    let _e454 = phi_724_;
                    let _e455 = bitcast<u32>(_e454);
                    let _e457 = ((_e455 & 2139095040u) != 0u);
                    let _e471 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e455 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e455 & 2147483648u))), _e454, _e457) * _e274) * select(0.00000011920929f, 1f, _e457)) * _e280);
                    let _e475 = (bitcast<f32>((bitcast<u32>(_e471) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e475 {
                        let _e479 = (bitcast<f32>((bitcast<u32>(_e447) & 2147483647u)) * 0.00000011920929f);
                        phi_776_ = select(0.00000000000011368684f, _e479, (_e479 > 0.00000000000011368684f));
                    } else {
                        phi_776_ = 0f;
                    }
                    let _e483 = phi_776_;
                    let _e484 = (_e447 + _e483);
                    let _e485 = (_e447 - _e483);
                    let _e486 = select(_e471, 0f, _e475);
                    if _e475 {
                        phi_788_ = 38685626000000000000000000f;
                    } else {
                        phi_788_ = (1f / _e471);
                    }
                    let _e489 = phi_788_;
                    let _e492 = bitcast<f32>((bitcast<u32>(_e310) & 2147483647u));
                    let _e495 = bitcast<f32>((bitcast<u32>(_e379) & 2147483647u));
                    let _e497 = select(_e495, _e492, (_e492 > _e495));
                    let _e500 = bitcast<f32>((bitcast<u32>(_e447) & 2147483647u));
                    let _e503 = (_e122 + _e227);
                    if (_e208 && (select(_e500, _e497, (_e497 > _e500)) <= 1099511600000f)) {
                        let _e513 = ((_e195 & 8388607u) | (select(0u, 1u, ((_e195 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e516 = bitcast<i32>((_e195 >> bitcast<u32>(23i)));
                        let _e520 = (_e513 == 0u);
                        let _e523 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e513)), 32u, _e520)) - 8i);
                        if (_e516 == 255i) {
                            phi_843_ = 255i;
                        } else {
                            phi_843_ = (((_e516 + select(0i, 1i, (_e516 == 0i))) - _e523) + _e503);
                        }
                        let _e531 = phi_843_;
                        let _e541 = (_e531 <= 0i);
                        if _e541 {
                            phi_866_ = u32();
                        } else {
                            if _e520 {
                                phi_865_ = u32();
                            } else {
                                phi_865_ = select(((bitcast<u32>(_e531) << bitcast<u32>(23i)) | ((_e513 << bitcast<u32>(((_e523 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e531 >= 255i));
                            }
                            let _e545 = phi_865_;
                            phi_866_ = _e545;
                        }
                        let _e547 = phi_866_;
                        let _e559 = ((_e204 & 8388607u) | (select(0u, 1u, ((_e204 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e562 = bitcast<i32>((_e204 >> bitcast<u32>(23i)));
                        let _e566 = (_e559 == 0u);
                        let _e569 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e559)), 32u, _e566)) - 8i);
                        if (_e562 == 255i) {
                            phi_903_ = 255i;
                        } else {
                            phi_903_ = (((_e562 + select(0i, 1i, (_e562 == 0i))) - _e569) + _e503);
                        }
                        let _e577 = phi_903_;
                        let _e587 = (_e577 <= 0i);
                        if _e587 {
                            phi_926_ = u32();
                        } else {
                            if _e566 {
                                phi_925_ = u32();
                            } else {
                                phi_925_ = select(((bitcast<u32>(_e577) << bitcast<u32>(23i)) | ((_e559 << bitcast<u32>(((_e569 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e577 >= 255i));
                            }
                            let _e591 = phi_925_;
                            phi_926_ = _e591;
                        }
                        let _e593 = phi_926_;
                        phi_934_ = bitcast<f32>(((_e203 & 2147483648u) | select(_e593, 0u, select(_e566, true, _e587))));
                        phi_935_ = bitcast<f32>(((_e194 & 2147483648u) | select(_e547, 0u, select(_e520, true, _e541))));
                    } else {
                        phi_934_ = 0f;
                        phi_935_ = 1f;
                    }
                    let _e599 = phi_934_;
                    let _e601 = phi_935_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 3>(bitcast<f32>(_e94), bitcast<f32>(_e98), bitcast<f32>(_e102));
                    let _e607 = (_e246 % 3u);
                    let _e608 = (_e607 < 3u);
                    if _e608 {
                    } else {
                        break;
                    }
                    let _e610 = local_9[_e607];
                    let _e611 = (_e245 % 3u);
                    let _e612 = (_e611 < 3u);
                    if _e612 {
                    } else {
                        break;
                    }
                    let _e614 = local_9[_e611];
                    let _e615 = (_e247 % 3u);
                    let _e616 = (_e615 < 3u);
                    if _e616 {
                    } else {
                        break;
                    }
                    let _e618 = local_9[_e615];
                    local_8 = array<f32, 3>(bitcast<f32>(_e106), bitcast<f32>(_e110), bitcast<f32>(_e114));
                    if _e608 {
                    } else {
                        break;
                    }
                    let _e622 = local_8[_e607];
                    if _e612 {
                    } else {
                        break;
                    }
                    let _e624 = local_8[_e611];
                    if _e616 {
                    } else {
                        break;
                    }
                    let _e626 = local_8[_e615];
                    phi_3312_ = false;
                    phi_1019_ = type_38(type_32(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e599), 0u, 0u);
                    phi_1022_ = (_e601 <= _e599);
                    phi_1024_ = ((3u * _e84) + 1u);
                    phi_1026_ = 0u;
                    phi_1028_ = type_49(type_47(array<f32, 3>(_e610, _e614, _e618), array<f32, 3>(_e622, _e624, _e626)), select(0u, 2147483648u, (_e84 == 0u)));
                    loop {
                        let _e634 = phi_3312_;
                        let _e636 = phi_1019_;
                        let _e638 = phi_1022_;
                        let _e640 = phi_1024_;
                        let _e642 = phi_1026_;
                        let _e644 = phi_1028_;
                        local_10 = _e636;
                        local_11 = _e636;
                        if _e638 {
                            phi_1039_ = true;
                        } else {
                            phi_1039_ = (_e642 > 0u);
                        }
                        let _e647 = phi_1039_;
                        if _e647 {
                            let _e648 = (_e640 > 0u);
                            if _e648 {
                                if _e638 {
                                    phi_1125_ = _e638;
                                    phi_1126_ = _e642;
                                    phi_1127_ = _e644;
                                } else {
                                    let _e649 = (_e642 - 1u);
                                    let _e650 = (_e649 % 128u);
                                    let _e651 = (_e650 < 128u);
                                    if _e651 {
                                    } else {
                                        phi_3466_ = true;
                                        break;
                                    }
                                    let _e653 = local_6[_e650];
                                    if _e651 {
                                    } else {
                                        phi_3466_ = true;
                                        break;
                                    }
                                    let _e655 = local_5[_e650];
                                    if _e651 {
                                    } else {
                                        phi_3466_ = true;
                                        break;
                                    }
                                    let _e657 = local_4[_e650];
                                    if _e651 {
                                    } else {
                                        phi_3466_ = true;
                                        break;
                                    }
                                    let _e659 = local_3[_e650];
                                    if _e651 {
                                    } else {
                                        phi_3466_ = true;
                                        break;
                                    }
                                    let _e662 = local_2[_e650];
                                    if _e651 {
                                    } else {
                                        phi_3466_ = true;
                                        break;
                                    }
                                    let _e664 = local_1[_e650];
                                    if _e651 {
                                    } else {
                                        phi_3466_ = true;
                                        break;
                                    }
                                    let _e666 = local[_e650];
                                    if _e651 {
                                    } else {
                                        phi_3466_ = true;
                                        break;
                                    }
                                    let _e671 = local_7[_e650];
                                    phi_1125_ = (_e671 <= _e636.member.member_1);
                                    phi_1126_ = _e649;
                                    phi_1127_ = type_49(type_47(array<f32, 3>(_e655, _e657, _e659), array<f32, 3>(_e662, _e664, _e666)), _e653);
                                }
                                let _e676 = phi_1125_;
                                let _e678 = phi_1126_;
                                let _e680 = phi_1127_;
                                if _e676 {
                                    if ((_e680.member_1 & 2147483648u) != 0u) {
                                        phi_1145_ = _e636;
                                        phi_1148_ = type_4(0u, ((_e680.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1063 = phi_1145_;
                                            let _e1065 = phi_1148_;
                                            local_12 = _e1063;
                                            if (_e1065.member < _e1065.member_1) {
                                                phi_1149_ = type_4((_e1065.member + 1u), _e1065.member_1);
                                                phi_1171_ = type_4(1u, _e1065.member);
                                            } else {
                                                phi_1149_ = _e1065;
                                                phi_1171_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1078 = phi_1149_;
                                            let _e1080 = phi_1171_;
                                            let _e1084 = (bitcast<i32>(_e1080.member) != 0i);
                                            if _e1084 {
                                                let _e1090 = type_38(_e1063.member, _e1063.member_1, (_e1063.member_2 + 1u));
                                                let _e1091 = ((_e680.member_1 & 268435455u) + _e1080.member_1);
                                                let _e1092 = (_e1091 < _e86);
                                                if _e1092 {
                                                    if _e1092 {
                                                    } else {
                                                        phi_3306_ = true;
                                                        break;
                                                    }
                                                    let _e1096 = global_2.member[_e1091].member_1;
                                                    phi_1195_ = _e1096;
                                                } else {
                                                    phi_1195_ = 4294967295u;
                                                }
                                                let _e1098 = phi_1195_;
                                                if (_e1091 >= _e86) {
                                                    phi_1287_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1092 {
                                                    } else {
                                                        phi_3306_ = true;
                                                        break;
                                                    }
                                                    if (_e607 < 9u) {
                                                    } else {
                                                        phi_3306_ = true;
                                                        break;
                                                    }
                                                    let _e1105 = global_2.member[_e1091].member[_e607];
                                                    if (_e611 < 9u) {
                                                    } else {
                                                        phi_3306_ = true;
                                                        break;
                                                    }
                                                    let _e1111 = global_2.member[_e1091].member[_e611];
                                                    if (_e615 < 9u) {
                                                    } else {
                                                        phi_3306_ = true;
                                                        break;
                                                    }
                                                    let _e1117 = global_2.member[_e1091].member[_e615];
                                                    let _e1119 = (3u + _e607);
                                                    if (_e1119 < 9u) {
                                                    } else {
                                                        phi_3306_ = true;
                                                        break;
                                                    }
                                                    let _e1125 = global_2.member[_e1091].member[_e1119];
                                                    let _e1126 = (3u + _e611);
                                                    if (_e1126 < 9u) {
                                                    } else {
                                                        phi_3306_ = true;
                                                        break;
                                                    }
                                                    let _e1132 = global_2.member[_e1091].member[_e1126];
                                                    let _e1133 = (3u + _e615);
                                                    if (_e1133 < 9u) {
                                                    } else {
                                                        phi_3306_ = true;
                                                        break;
                                                    }
                                                    let _e1139 = global_2.member[_e1091].member[_e1133];
                                                    let _e1141 = (6u + _e607);
                                                    if (_e1141 < 9u) {
                                                    } else {
                                                        phi_3306_ = true;
                                                        break;
                                                    }
                                                    let _e1147 = global_2.member[_e1091].member[_e1141];
                                                    let _e1148 = (6u + _e611);
                                                    if (_e1148 < 9u) {
                                                    } else {
                                                        phi_3306_ = true;
                                                        break;
                                                    }
                                                    let _e1154 = global_2.member[_e1091].member[_e1148];
                                                    let _e1155 = (6u + _e615);
                                                    if (_e1155 < 9u) {
                                                    } else {
                                                        phi_3306_ = true;
                                                        break;
                                                    }
                                                    let _e1161 = global_2.member[_e1091].member[_e1155];
                                                    phi_1287_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1105, _e1111, _e1117), array<f32, 3>(_e1125, _e1132, _e1139), array<f32, 3>(_e1147, _e1154, _e1161));
                                                }
                                                let _e1165 = phi_1287_;
                                                let _e1174 = (_e1165[0][2] - _e447);
                                                let _e1177 = (((_e1165[0][0] - _e310) * _e486) - (_e1174 * _e350));
                                                let _e1180 = (((_e1165[0][1] - _e379) * _e486) - (_e1174 * _e418));
                                                let _e1187 = (_e1165[1][2] - _e447);
                                                let _e1190 = (((_e1165[1][0] - _e310) * _e486) - (_e1187 * _e350));
                                                let _e1193 = (((_e1165[1][1] - _e379) * _e486) - (_e1187 * _e418));
                                                let _e1200 = (_e1165[2][2] - _e447);
                                                let _e1203 = (((_e1165[2][0] - _e310) * _e486) - (_e1200 * _e350));
                                                let _e1206 = (((_e1165[2][1] - _e379) * _e486) - (_e1200 * _e418));
                                                let _e1207 = (_e1203 * _e1193);
                                                let _e1208 = (_e1206 * _e1190);
                                                let _e1209 = (_e1177 * _e1206);
                                                let _e1210 = (_e1180 * _e1203);
                                                let _e1211 = (_e1190 * _e1180);
                                                let _e1212 = (_e1193 * _e1177);
                                                let _e1217 = (((_e1207 >= _e1208) && (_e1209 >= _e1210)) && (_e1211 >= _e1212));
                                                if (_e1217 || (((_e1207 <= _e1208) && (_e1209 <= _e1210)) && (_e1211 <= _e1212))) {
                                                    let _e1224 = select(-1f, 1f, _e1217);
                                                    let _e1226 = ((_e1207 - _e1208) * _e1224);
                                                    let _e1228 = select(0f, _e1226, (_e1226 > 0f));
                                                    let _e1230 = ((_e1209 - _e1210) * _e1224);
                                                    let _e1232 = select(0f, _e1230, (_e1230 > 0f));
                                                    let _e1234 = ((_e1211 - _e1212) * _e1224);
                                                    let _e1236 = select(0f, _e1234, (_e1234 > 0f));
                                                    let _e1238 = ((_e1228 + _e1232) + _e1236);
                                                    if (_e1238 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2171_ = type_25();
                                                        phi_2172_ = true;
                                                        phi_2173_ = false;
                                                    } else {
                                                        let _e1241 = select(_e1190, _e1177, (_e1177 < _e1190));
                                                        if (select(_e1203, _e1241, (_e1241 < _e1203)) > 0f) {
                                                            phi_1439_ = true;
                                                        } else {
                                                            let _e1246 = select(_e1190, _e1177, (_e1177 > _e1190));
                                                            phi_1439_ = (select(_e1203, _e1246, (_e1246 > _e1203)) < 0f);
                                                        }
                                                        let _e1251 = phi_1439_;
                                                        if _e1251 {
                                                            phi_2168_ = type_25();
                                                            phi_2169_ = true;
                                                            phi_2170_ = false;
                                                        } else {
                                                            let _e1253 = select(_e1193, _e1180, (_e1180 < _e1193));
                                                            if (select(_e1206, _e1253, (_e1253 < _e1206)) > 0f) {
                                                                phi_1468_ = true;
                                                            } else {
                                                                let _e1258 = select(_e1193, _e1180, (_e1180 > _e1193));
                                                                phi_1468_ = (select(_e1206, _e1258, (_e1258 > _e1206)) < 0f);
                                                            }
                                                            let _e1263 = phi_1468_;
                                                            if _e1263 {
                                                                phi_2166_ = type_25();
                                                                phi_2167_ = false;
                                                            } else {
                                                                let _e1265 = select(_e1165[1][0], _e1165[0][0], (_e1165[0][0] < _e1165[1][0]));
                                                                let _e1269 = select(_e1165[1][0], _e1165[0][0], (_e1165[0][0] > _e1165[1][0]));
                                                                let _e1273 = select(_e1165[1][1], _e1165[0][1], (_e1165[0][1] < _e1165[1][1]));
                                                                let _e1277 = select(_e1165[1][1], _e1165[0][1], (_e1165[0][1] > _e1165[1][1]));
                                                                let _e1281 = select(_e1165[1][2], _e1165[0][2], (_e1165[0][2] < _e1165[1][2]));
                                                                let _e1285 = select(_e1165[1][2], _e1165[0][2], (_e1165[0][2] > _e1165[1][2]));
                                                                let _e1290 = ((select(_e1165[2][0], _e1265, (_e1265 < _e1165[2][0])) - _e348) * _e353);
                                                                let _e1291 = ((select(_e1165[2][0], _e1269, (_e1269 > _e1165[2][0])) - _e349) * _e353);
                                                                let _e1294 = ((select(_e1165[2][1], _e1273, (_e1273 < _e1165[2][1])) - _e416) * _e421);
                                                                let _e1295 = ((select(_e1165[2][1], _e1277, (_e1277 > _e1165[2][1])) - _e417) * _e421);
                                                                let _e1298 = ((select(_e1165[2][2], _e1281, (_e1281 < _e1165[2][2])) - _e484) * _e489);
                                                                let _e1299 = ((select(_e1165[2][2], _e1285, (_e1285 > _e1165[2][2])) - _e485) * _e489);
                                                                let _e1301 = select(_e1299, _e1298, (_e1298 < _e1299));
                                                                let _e1303 = select(_e1299, _e1298, (_e1298 > _e1299));
                                                                let _e1305 = select(_e1291, _e1290, (_e1290 < _e1291));
                                                                let _e1307 = select(_e1295, _e1294, (_e1294 < _e1295));
                                                                let _e1309 = select(_e1307, _e1305, (_e1305 > _e1307));
                                                                let _e1311 = select(_e1301, _e1309, (_e1309 > _e1301));
                                                                let _e1313 = select(_e1291, _e1290, (_e1290 > _e1291));
                                                                let _e1315 = select(_e1295, _e1294, (_e1294 > _e1295));
                                                                let _e1317 = select(_e1315, _e1313, (_e1313 < _e1315));
                                                                let _e1319 = select(_e1303, _e1317, (_e1317 < _e1303));
                                                                let _e1320 = -(_e1301);
                                                                let _e1326 = select(_e601, _e1311, (_e1311 > _e601));
                                                                if (_e1326 > (_e1319 + (select(_e1320, _e1303, (_e1303 > _e1320)) * 0.0000019073523f))) {
                                                                    phi_2161_ = type_25();
                                                                    phi_2162_ = true;
                                                                } else {
                                                                    let _e1328 = (_e1326 > _e1063.member.member_1);
                                                                    if _e1328 {
                                                                        phi_2160_ = type_25();
                                                                    } else {
                                                                        let _e1329 = vec3<f32>(_e1165[0][0], _e1165[0][1], _e1165[0][2]);
                                                                        let _e1330 = vec3<f32>(_e1165[1][0], _e1165[1][1], _e1165[1][2]);
                                                                        let _e1331 = vec3<f32>(_e1165[2][0], _e1165[2][1], _e1165[2][2]);
                                                                        let _e1332 = (_e1165[1][0] - _e1165[0][0]);
                                                                        let _e1333 = (_e1165[1][1] - _e1165[0][1]);
                                                                        let _e1334 = (_e1165[1][2] - _e1165[0][2]);
                                                                        let _e1335 = vec3<f32>(_e1332, _e1333, _e1334);
                                                                        let _e1336 = (_e1165[2][0] - _e1165[1][0]);
                                                                        let _e1337 = (_e1165[2][1] - _e1165[1][1]);
                                                                        let _e1338 = (_e1165[2][2] - _e1165[1][2]);
                                                                        let _e1339 = vec3<f32>(_e1336, _e1337, _e1338);
                                                                        let _e1340 = (_e1165[0][0] - _e1165[2][0]);
                                                                        let _e1341 = (_e1165[0][1] - _e1165[2][1]);
                                                                        let _e1342 = (_e1165[0][2] - _e1165[2][2]);
                                                                        let _e1343 = vec3<f32>(_e1340, _e1341, _e1342);
                                                                        let _e1346 = bitcast<f32>((bitcast<u32>(_e1332) & 2147483647u));
                                                                        let _e1349 = bitcast<f32>((bitcast<u32>(_e1333) & 2147483647u));
                                                                        let _e1351 = select(_e1349, _e1346, (_e1346 > _e1349));
                                                                        let _e1354 = bitcast<f32>((bitcast<u32>(_e1334) & 2147483647u));
                                                                        let _e1356 = select(_e1354, _e1351, (_e1351 > _e1354));
                                                                        let _e1359 = bitcast<f32>((bitcast<u32>(_e1336) & 2147483647u));
                                                                        let _e1362 = bitcast<f32>((bitcast<u32>(_e1337) & 2147483647u));
                                                                        let _e1364 = select(_e1362, _e1359, (_e1359 > _e1362));
                                                                        let _e1367 = bitcast<f32>((bitcast<u32>(_e1338) & 2147483647u));
                                                                        let _e1369 = select(_e1367, _e1364, (_e1364 > _e1367));
                                                                        let _e1372 = bitcast<f32>((bitcast<u32>(_e1340) & 2147483647u));
                                                                        let _e1375 = bitcast<f32>((bitcast<u32>(_e1341) & 2147483647u));
                                                                        let _e1377 = select(_e1375, _e1372, (_e1372 > _e1375));
                                                                        let _e1380 = bitcast<f32>((bitcast<u32>(_e1342) & 2147483647u));
                                                                        let _e1382 = select(_e1380, _e1377, (_e1377 > _e1380));
                                                                        let _e1384 = select(_e1369, _e1356, (_e1356 > _e1369));
                                                                        let _e1386 = select(_e1382, _e1384, (_e1384 > _e1382));
                                                                        if (_e1356 == _e1386) {
                                                                            phi_1887_ = _e1193;
                                                                            phi_1888_ = _e1190;
                                                                            phi_1889_ = _e1180;
                                                                            phi_1890_ = _e1177;
                                                                            phi_1891_ = _e1329;
                                                                            phi_1892_ = _e1343;
                                                                            phi_1893_ = _e1339;
                                                                            phi_1894_ = _e1335;
                                                                        } else {
                                                                            let _e1388 = (_e1369 == _e1386);
                                                                            let _e1393 = vec3(_e1388);
                                                                            phi_1887_ = select(_e1180, _e1206, _e1388);
                                                                            phi_1888_ = select(_e1177, _e1203, _e1388);
                                                                            phi_1889_ = select(_e1206, _e1193, _e1388);
                                                                            phi_1890_ = select(_e1203, _e1190, _e1388);
                                                                            phi_1891_ = select(_e1331, _e1330, _e1393);
                                                                            phi_1892_ = select(_e1339, _e1335, _e1393);
                                                                            phi_1893_ = select(_e1335, _e1343, _e1393);
                                                                            phi_1894_ = select(_e1343, _e1339, _e1393);
                                                                        }
                                                                        let _e1399 = phi_1887_;
                                                                        let _e1401 = phi_1888_;
                                                                        let _e1403 = phi_1889_;
                                                                        let _e1405 = phi_1890_;
                                                                        let _e1407 = phi_1891_;
                                                                        let _e1409 = phi_1892_;
                                                                        let _e1411 = phi_1893_;
                                                                        let _e1413 = phi_1894_;
                                                                        let _e1420 = ((_e1411.y * _e1409.z) - (_e1409.y * _e1411.z));
                                                                        let _e1425 = ((_e1411.z * _e1409.x) - (_e1409.z * _e1411.x));
                                                                        let _e1428 = ((_e1411.x * _e1409.y) - (_e1409.x * _e1411.y));
                                                                        if (_e1228 >= _e1232) {
                                                                            phi_1931_ = select(true, false, (_e1228 >= _e1236));
                                                                        } else {
                                                                            phi_1931_ = true;
                                                                        }
                                                                        let _e1433 = phi_1931_;
                                                                        if _e1433 {
                                                                            phi_1940_ = select(_e1331, _e1330, vec3((_e1232 >= _e1236)));
                                                                        } else {
                                                                            phi_1940_ = _e1329;
                                                                        }
                                                                        let _e1438 = phi_1940_;
                                                                        let _e1449 = (((_e1420 * (_e1438.x - _e310)) + (_e1425 * (_e1438.y - _e379))) + (_e1428 * (_e1438.z - _e447)));
                                                                        let _e1454 = (((_e1420 * _e350) + (_e1425 * _e418)) + (_e1428 * _e486));
                                                                        let _e1455 = (_e1401 - _e1405);
                                                                        let _e1456 = (_e1399 - _e1403);
                                                                        let _e1464 = (-(((_e1405 * _e1455) + (_e1403 * _e1456))) / ((_e1455 * _e1455) + (_e1456 * _e1456)));
                                                                        let _e1466 = select(1f, _e1464, (_e1464 < 1f));
                                                                        let _e1468 = select(0f, _e1466, (_e1466 > 0f));
                                                                        let _e1481 = ((_e1407.x + (_e1413.x * _e1468)) - _e310);
                                                                        let _e1482 = ((_e1407.y + (_e1413.y * _e1468)) - _e379);
                                                                        let _e1483 = ((_e1407.z + (_e1413.z * _e1468)) - _e447);
                                                                        let _e1484 = (_e1483 / _e486);
                                                                        let _e1496 = bitcast<f32>((bitcast<u32>(_e1481) & 2147483647u));
                                                                        let _e1499 = bitcast<f32>((bitcast<u32>(_e1482) & 2147483647u));
                                                                        let _e1501 = select(_e1499, _e1496, (_e1496 > _e1499));
                                                                        let _e1504 = bitcast<f32>((bitcast<u32>(_e1483) & 2147483647u));
                                                                        let _e1506 = select(_e1504, _e1501, (_e1501 > _e1504));
                                                                        let _e1512 = bitcast<f32>((bitcast<u32>(_e1420) & 2147483647u));
                                                                        let _e1515 = bitcast<f32>((bitcast<u32>(_e1425) & 2147483647u));
                                                                        let _e1517 = select(_e1515, _e1512, (_e1512 > _e1515));
                                                                        let _e1520 = bitcast<f32>((bitcast<u32>(_e1428) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1420 * _e1481) + (_e1425 * _e1482)) + (_e1428 * _e1483)) - _e1449)) & 2147483647u)) <= ((0.0000009536743f * select(_e1386, _e1506, (_e1506 > _e1386))) * select(_e1520, _e1517, (_e1517 > _e1520)))) {
                                                                            let _e1530 = bitcast<f32>((bitcast<u32>(_e1411.x) & 2147483647u));
                                                                            let _e1533 = bitcast<f32>((bitcast<u32>(_e1411.y) & 2147483647u));
                                                                            let _e1535 = select(_e1533, _e1530, (_e1530 > _e1533));
                                                                            let _e1538 = bitcast<f32>((bitcast<u32>(_e1411.z) & 2147483647u));
                                                                            let _e1544 = bitcast<f32>((bitcast<u32>(_e1409.x) & 2147483647u));
                                                                            let _e1547 = bitcast<f32>((bitcast<u32>(_e1409.y) & 2147483647u));
                                                                            let _e1549 = select(_e1547, _e1544, (_e1544 > _e1547));
                                                                            let _e1552 = bitcast<f32>((bitcast<u32>(_e1409.z) & 2147483647u));
                                                                            let _e1556 = (bitcast<f32>((bitcast<u32>(_e1454) & 2147483647u)) > ((0.0000038146973f * select(_e1538, _e1535, (_e1535 > _e1538))) * select(_e1552, _e1549, (_e1549 > _e1552))));
                                                                            if _e1556 {
                                                                                phi_2105_ = (_e1449 / _e1454);
                                                                            } else {
                                                                                phi_2105_ = f32();
                                                                            }
                                                                            let _e1559 = phi_2105_;
                                                                            phi_2107_ = _e1559;
                                                                            phi_2108_ = select(true, false, _e1556);
                                                                        } else {
                                                                            phi_2107_ = f32();
                                                                            phi_2108_ = true;
                                                                        }
                                                                        let _e1562 = phi_2107_;
                                                                        let _e1564 = phi_2108_;
                                                                        if _e1564 {
                                                                            let _e1572 = (((_e1420 * (_e1481 - (_e350 * _e1484))) + (_e1425 * (_e1482 - (_e418 * _e1484)))) / _e1454);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1572) & 2147483647u)) <= _e1386) {
                                                                                phi_2128_ = (_e1484 + _e1572);
                                                                            } else {
                                                                                phi_2128_ = _e1484;
                                                                            }
                                                                            let _e1579 = phi_2128_;
                                                                            phi_2129_ = _e1579;
                                                                        } else {
                                                                            phi_2129_ = _e1562;
                                                                        }
                                                                        let _e1581 = phi_2129_;
                                                                        let _e1583 = select(_e1319, _e1581, (_e1581 < _e1319));
                                                                        let _e1585 = select(_e1311, _e1583, (_e1583 > _e1311));
                                                                        if (_e1585 >= _e601) {
                                                                            let _e1587 = (_e1585 <= _e1063.member.member_1);
                                                                            if _e1587 {
                                                                                let _e1588 = (1f / _e1238);
                                                                                phi_2152_ = type_25(_e1585, (_e1232 * _e1588), (_e1236 * _e1588), _e1098);
                                                                            } else {
                                                                                phi_2152_ = type_25();
                                                                            }
                                                                            let _e1593 = phi_2152_;
                                                                            phi_2154_ = _e1593;
                                                                            phi_2155_ = select(true, false, _e1587);
                                                                        } else {
                                                                            phi_2154_ = type_25();
                                                                            phi_2155_ = true;
                                                                        }
                                                                        let _e1596 = phi_2154_;
                                                                        let _e1598 = phi_2155_;
                                                                        if _e1598 {
                                                                            phi_2159_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2159_ = _e1596;
                                                                        }
                                                                        let _e1600 = phi_2159_;
                                                                        phi_2160_ = _e1600;
                                                                    }
                                                                    let _e1602 = phi_2160_;
                                                                    phi_2161_ = _e1602;
                                                                    phi_2162_ = _e1328;
                                                                }
                                                                let _e1604 = phi_2161_;
                                                                let _e1606 = phi_2162_;
                                                                phi_2166_ = _e1604;
                                                                phi_2167_ = _e1606;
                                                            }
                                                            let _e1608 = phi_2166_;
                                                            let _e1610 = phi_2167_;
                                                            phi_2168_ = _e1608;
                                                            phi_2169_ = _e1263;
                                                            phi_2170_ = _e1610;
                                                        }
                                                        let _e1612 = phi_2168_;
                                                        let _e1614 = phi_2169_;
                                                        let _e1616 = phi_2170_;
                                                        phi_2171_ = _e1612;
                                                        phi_2172_ = _e1614;
                                                        phi_2173_ = _e1616;
                                                    }
                                                    let _e1618 = phi_2171_;
                                                    let _e1620 = phi_2172_;
                                                    let _e1622 = phi_2173_;
                                                    phi_2181_ = _e1618;
                                                    phi_2182_ = select(_e1622, true, _e1620);
                                                } else {
                                                    phi_2181_ = type_25();
                                                    phi_2182_ = true;
                                                }
                                                let _e1625 = phi_2181_;
                                                let _e1627 = phi_2182_;
                                                if _e1627 {
                                                    phi_2186_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2186_ = _e1625;
                                                }
                                                let _e1629 = phi_2186_;
                                                if (_e1629.member_3 != 4294967295u) {
                                                    if (_e1098 != 4294967295u) {
                                                        if (_e1629.member < _e1063.member.member.member) {
                                                            phi_2212_ = true;
                                                        } else {
                                                            if (_e1629.member == _e1063.member.member.member) {
                                                                phi_2211_ = (_e1629.member_3 < _e1063.member.member.member_3);
                                                            } else {
                                                                phi_2211_ = false;
                                                            }
                                                            let _e1644 = phi_2211_;
                                                            phi_2212_ = _e1644;
                                                        }
                                                        let _e1646 = phi_2212_;
                                                        if _e1646 {
                                                            phi_2219_ = type_38(type_32(_e1629, _e1629.member), _e1090.member_1, _e1090.member_2);
                                                        } else {
                                                            phi_2219_ = _e1090;
                                                        }
                                                        let _e1653 = phi_2219_;
                                                        phi_2220_ = _e1653;
                                                    } else {
                                                        phi_2220_ = _e1090;
                                                    }
                                                    let _e1655 = phi_2220_;
                                                    phi_2221_ = _e1655;
                                                } else {
                                                    phi_2221_ = _e1090;
                                                }
                                                let _e1657 = phi_2221_;
                                                phi_1146_ = _e1657;
                                            } else {
                                                phi_1146_ = type_38();
                                            }
                                            let _e1659 = phi_1146_;
                                            continue;
                                            continuing {
                                                phi_1145_ = _e1659;
                                                phi_1148_ = _e1078;
                                                phi_3306_ = _e634;
                                                break if !(_e1084);
                                            }
                                        }
                                        let _e1662 = phi_3306_;
                                        phi_3466_ = _e1662;
                                        if _e1662 {
                                            break;
                                        }
                                        phi_3470_ = _e1662;
                                        let _e1833 = local_12;
                                        phi_3238_ = _e1833;
                                        phi_3239_ = false;
                                        phi_3240_ = _e678;
                                        phi_3241_ = _e680;
                                    } else {
                                        let _e689 = (_e680.member_1 < _e84);
                                        if _e689 {
                                            if _e689 {
                                            } else {
                                                phi_3466_ = true;
                                                break;
                                            }
                                            let _e691 = global_5.member[_e680.member_1];
                                            phi_2247_ = _e691;
                                        } else {
                                            phi_2247_ = type_42(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e693 = phi_2247_;
                                        let _e708 = ((10u * _e246) & 31u);
                                        let _e711 = ((_e693.member[0] >> bitcast<u32>(_e708)) & 1023u);
                                        let _e719 = bitcast<f32>((bitcast<u32>(((_e680.member.member_1[0] - _e680.member.member[0]) * 0.0009775171f)) ^ _e118));
                                        let _e724 = (_e680.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e711)) - 8388608f) * _e719)) ^ _e118)));
                                        let _e728 = select(select(_e680.member.member_1[0], _e724, (_e724 < _e680.member.member_1[0])), _e680.member.member_1[0], (_e711 == 1023u));
                                        let _e730 = ((10u * _e245) & 31u);
                                        let _e733 = ((_e693.member[0] >> bitcast<u32>(_e730)) & 1023u);
                                        let _e741 = bitcast<f32>((bitcast<u32>(((_e680.member.member_1[1] - _e680.member.member[1]) * 0.0009775171f)) ^ _e118));
                                        let _e746 = (_e680.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e733)) - 8388608f) * _e741)) ^ _e118)));
                                        let _e750 = select(select(_e680.member.member_1[1], _e746, (_e746 < _e680.member.member_1[1])), _e680.member.member_1[1], (_e733 == 1023u));
                                        let _e752 = ((10u * _e247) & 31u);
                                        let _e755 = ((_e693.member[0] >> bitcast<u32>(_e752)) & 1023u);
                                        let _e763 = bitcast<f32>((bitcast<u32>(((_e680.member.member_1[2] - _e680.member.member[2]) * 0.0009775171f)) ^ _e118));
                                        let _e768 = (_e680.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e755)) - 8388608f) * _e763)) ^ _e118)));
                                        let _e772 = select(select(_e680.member.member_1[2], _e768, (_e768 < _e680.member.member_1[2])), _e680.member.member_1[2], (_e755 == 1023u));
                                        let _e775 = ((_e693.member[1] >> bitcast<u32>(_e708)) & 1023u);
                                        let _e783 = (_e680.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e775)) - 8388608f) * _e719)) ^ _e118)));
                                        let _e787 = select(select(_e680.member.member_1[0], _e783, (_e783 < _e680.member.member_1[0])), _e680.member.member_1[0], (_e775 == 1023u));
                                        let _e790 = ((_e693.member[1] >> bitcast<u32>(_e730)) & 1023u);
                                        let _e798 = (_e680.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e790)) - 8388608f) * _e741)) ^ _e118)));
                                        let _e802 = select(select(_e680.member.member_1[1], _e798, (_e798 < _e680.member.member_1[1])), _e680.member.member_1[1], (_e790 == 1023u));
                                        let _e805 = ((_e693.member[1] >> bitcast<u32>(_e752)) & 1023u);
                                        let _e813 = (_e680.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e805)) - 8388608f) * _e763)) ^ _e118)));
                                        let _e817 = select(select(_e680.member.member_1[2], _e813, (_e813 < _e680.member.member_1[2])), _e680.member.member_1[2], (_e805 == 1023u));
                                        let _e823 = ((_e693.member_1[0] >> bitcast<u32>(_e708)) & 1023u);
                                        let _e831 = (_e680.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e823)) - 8388608f) * _e719)) ^ _e118)));
                                        let _e835 = select(select(_e680.member.member_1[0], _e831, (_e831 < _e680.member.member_1[0])), _e680.member.member_1[0], (_e823 == 1023u));
                                        let _e838 = ((_e693.member_1[0] >> bitcast<u32>(_e730)) & 1023u);
                                        let _e846 = (_e680.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e838)) - 8388608f) * _e741)) ^ _e118)));
                                        let _e850 = select(select(_e680.member.member_1[1], _e846, (_e846 < _e680.member.member_1[1])), _e680.member.member_1[1], (_e838 == 1023u));
                                        let _e853 = ((_e693.member_1[0] >> bitcast<u32>(_e752)) & 1023u);
                                        let _e861 = (_e680.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e853)) - 8388608f) * _e763)) ^ _e118)));
                                        let _e865 = select(select(_e680.member.member_1[2], _e861, (_e861 < _e680.member.member_1[2])), _e680.member.member_1[2], (_e853 == 1023u));
                                        let _e868 = ((_e693.member_1[1] >> bitcast<u32>(_e708)) & 1023u);
                                        let _e876 = (_e680.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e868)) - 8388608f) * _e719)) ^ _e118)));
                                        let _e880 = select(select(_e680.member.member_1[0], _e876, (_e876 < _e680.member.member_1[0])), _e680.member.member_1[0], (_e868 == 1023u));
                                        let _e883 = ((_e693.member_1[1] >> bitcast<u32>(_e730)) & 1023u);
                                        let _e891 = (_e680.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e883)) - 8388608f) * _e741)) ^ _e118)));
                                        let _e895 = select(select(_e680.member.member_1[1], _e891, (_e891 < _e680.member.member_1[1])), _e680.member.member_1[1], (_e883 == 1023u));
                                        let _e898 = ((_e693.member_1[1] >> bitcast<u32>(_e752)) & 1023u);
                                        let _e906 = (_e680.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e898)) - 8388608f) * _e763)) ^ _e118)));
                                        let _e910 = select(select(_e680.member.member_1[2], _e906, (_e906 < _e680.member.member_1[2])), _e680.member.member_1[2], (_e898 == 1023u));
                                        let _e915 = type_49(type_47(array<f32, 3>(_e728, _e750, _e772), array<f32, 3>(_e787, _e802, _e817)), _e693.member_2);
                                        let _e920 = type_49(type_47(array<f32, 3>(_e835, _e850, _e865), array<f32, 3>(_e880, _e895, _e910)), _e693.member_3);
                                        let _e933 = ((_e728 - _e348) * _e353);
                                        let _e934 = ((_e835 - _e348) * _e353);
                                        let _e935 = ((_e787 - _e349) * _e353);
                                        let _e936 = ((_e880 - _e349) * _e353);
                                        let _e941 = ((_e750 - _e416) * _e421);
                                        let _e942 = ((_e850 - _e416) * _e421);
                                        let _e943 = ((_e802 - _e417) * _e421);
                                        let _e944 = ((_e895 - _e417) * _e421);
                                        let _e949 = ((_e772 - _e484) * _e489);
                                        let _e950 = ((_e865 - _e484) * _e489);
                                        let _e951 = ((_e817 - _e485) * _e489);
                                        let _e952 = ((_e910 - _e485) * _e489);
                                        let _e954 = select(_e951, _e949, (_e949 < _e951));
                                        let _e956 = select(_e952, _e950, (_e950 < _e952));
                                        let _e958 = select(_e951, _e949, (_e949 > _e951));
                                        let _e960 = select(_e952, _e950, (_e950 > _e952));
                                        let _e962 = select(_e935, _e933, (_e933 < _e935));
                                        let _e964 = select(_e936, _e934, (_e934 < _e936));
                                        let _e966 = select(_e943, _e941, (_e941 < _e943));
                                        let _e968 = select(_e944, _e942, (_e942 < _e944));
                                        let _e970 = select(_e966, _e962, (_e962 > _e966));
                                        let _e972 = select(_e968, _e964, (_e964 > _e968));
                                        let _e974 = select(_e954, _e970, (_e970 > _e954));
                                        let _e976 = select(_e956, _e972, (_e972 > _e956));
                                        let _e978 = select(_e935, _e933, (_e933 > _e935));
                                        let _e980 = select(_e936, _e934, (_e934 > _e936));
                                        let _e982 = select(_e943, _e941, (_e941 > _e943));
                                        let _e984 = select(_e944, _e942, (_e942 > _e944));
                                        let _e986 = select(_e982, _e978, (_e978 < _e982));
                                        let _e988 = select(_e984, _e980, (_e980 < _e984));
                                        let _e993 = -(_e954);
                                        let _e994 = -(_e956);
                                        let _e1001 = (select(_e958, _e986, (_e986 < _e958)) + (select(_e993, _e958, (_e958 > _e993)) * 0.0000019073523f));
                                        let _e1002 = (select(_e960, _e988, (_e988 < _e960)) + (select(_e994, _e960, (_e960 > _e994)) * 0.0000019073523f));
                                        let _e1004 = select(_e601, _e974, (_e974 > _e601));
                                        let _e1006 = select(_e601, _e976, (_e976 > _e601));
                                        let _e1011 = (_e1004 <= select(_e636.member.member_1, _e1001, (_e1001 < _e636.member.member_1)));
                                        let _e1012 = (_e1006 <= select(_e636.member.member_1, _e1002, (_e1002 < _e636.member.member_1)));
                                        let _e1013 = (_e1004 <= _e1006);
                                        if _e1011 {
                                            if _e1012 {
                                                if _e1013 {
                                                    phi_3136_ = _e920;
                                                } else {
                                                    phi_3136_ = _e915;
                                                }
                                                let _e1015 = phi_3136_;
                                                let _e1023 = (_e678 % 128u);
                                                let _e1024 = (_e1023 < 128u);
                                                if _e1024 {
                                                } else {
                                                    phi_3466_ = true;
                                                    break;
                                                }
                                                local_6[_e1023] = _e1015.member_1;
                                                if _e1024 {
                                                } else {
                                                    phi_3466_ = true;
                                                    break;
                                                }
                                                local_5[_e1023] = _e1015.member.member[0];
                                                if _e1024 {
                                                } else {
                                                    phi_3466_ = true;
                                                    break;
                                                }
                                                local_4[_e1023] = _e1015.member.member[1];
                                                if _e1024 {
                                                } else {
                                                    phi_3466_ = true;
                                                    break;
                                                }
                                                local_3[_e1023] = _e1015.member.member[2];
                                                if _e1024 {
                                                } else {
                                                    phi_3466_ = true;
                                                    break;
                                                }
                                                local_2[_e1023] = _e1015.member.member_1[0];
                                                if _e1024 {
                                                } else {
                                                    phi_3466_ = true;
                                                    break;
                                                }
                                                local_1[_e1023] = _e1015.member.member_1[1];
                                                if _e1024 {
                                                } else {
                                                    phi_3466_ = true;
                                                    break;
                                                }
                                                local[_e1023] = _e1015.member.member_1[2];
                                                if _e1024 {
                                                } else {
                                                    phi_3466_ = true;
                                                    break;
                                                }
                                                local_7[_e1023] = select(_e1006, _e1004, !(_e1013));
                                                if _e1013 {
                                                    phi_3213_ = _e915;
                                                } else {
                                                    phi_3213_ = _e920;
                                                }
                                                let _e1041 = phi_3213_;
                                                phi_3214_ = (_e678 + 1u);
                                                phi_3215_ = _e1041;
                                            } else {
                                                phi_3214_ = u32();
                                                phi_3215_ = type_49();
                                            }
                                            let _e1043 = phi_3214_;
                                            let _e1045 = phi_3215_;
                                            phi_3217_ = _e1043;
                                            phi_3218_ = _e1045;
                                            phi_3219_ = select(true, false, _e1012);
                                        } else {
                                            phi_3217_ = u32();
                                            phi_3218_ = type_49();
                                            phi_3219_ = true;
                                        }
                                        let _e1048 = phi_3217_;
                                        let _e1050 = phi_3218_;
                                        let _e1052 = phi_3219_;
                                        if _e1052 {
                                            if _e1011 {
                                                phi_3226_ = _e915;
                                            } else {
                                                phi_3226_ = _e920;
                                            }
                                            let _e1054 = phi_3226_;
                                            phi_3231_ = select(_e1012, true, _e1011);
                                            phi_3233_ = _e1054;
                                        } else {
                                            phi_3231_ = _e676;
                                            phi_3233_ = _e1050;
                                        }
                                        let _e1057 = phi_3231_;
                                        let _e1059 = phi_3233_;
                                        phi_3470_ = _e634;
                                        phi_3238_ = type_38(_e636.member, (_e636.member_1 + 1u), _e636.member_2);
                                        phi_3239_ = _e1057;
                                        phi_3240_ = select(_e1048, _e678, _e1052);
                                        phi_3241_ = _e1059;
                                    }
                                    let _e1664 = phi_3470_;
                                    let _e1666 = phi_3238_;
                                    let _e1668 = phi_3239_;
                                    let _e1670 = phi_3240_;
                                    let _e1672 = phi_3241_;
                                    phi_3469_ = _e1664;
                                    phi_3242_ = _e1666;
                                    phi_3243_ = _e1668;
                                    phi_3244_ = (_e640 - 1u);
                                    phi_3245_ = _e1670;
                                    phi_3246_ = _e1672;
                                } else {
                                    phi_3469_ = _e634;
                                    phi_3242_ = _e636;
                                    phi_3243_ = _e676;
                                    phi_3244_ = _e640;
                                    phi_3245_ = _e678;
                                    phi_3246_ = _e680;
                                }
                                let _e1674 = phi_3469_;
                                let _e1676 = phi_3242_;
                                let _e1678 = phi_3243_;
                                let _e1680 = phi_3244_;
                                let _e1682 = phi_3245_;
                                let _e1684 = phi_3246_;
                                phi_3468_ = _e1674;
                                phi_3247_ = _e1676;
                                phi_3248_ = _e1678;
                                phi_3249_ = _e1680;
                                phi_3250_ = _e1682;
                                phi_3251_ = _e1684;
                            } else {
                                phi_3468_ = _e634;
                                phi_3247_ = type_38();
                                phi_3248_ = bool();
                                phi_3249_ = u32();
                                phi_3250_ = u32();
                                phi_3251_ = type_49();
                            }
                            let _e1686 = phi_3468_;
                            let _e1688 = phi_3247_;
                            let _e1690 = phi_3248_;
                            let _e1692 = phi_3249_;
                            let _e1694 = phi_3250_;
                            let _e1696 = phi_3251_;
                            phi_3467_ = _e1686;
                            phi_1020_ = _e1688;
                            phi_1023_ = _e1690;
                            phi_1025_ = _e1692;
                            phi_1027_ = _e1694;
                            phi_1029_ = _e1696;
                            phi_3252_ = _e648;
                        } else {
                            phi_3467_ = _e634;
                            phi_1020_ = type_38();
                            phi_1023_ = bool();
                            phi_1025_ = u32();
                            phi_1027_ = u32();
                            phi_1029_ = type_49();
                            phi_3252_ = false;
                        }
                        let _e1698 = phi_3467_;
                        let _e1700 = phi_1020_;
                        let _e1702 = phi_1023_;
                        let _e1704 = phi_1025_;
                        let _e1706 = phi_1027_;
                        let _e1708 = phi_1029_;
                        let _e1710 = phi_3252_;
                        continue;
                        continuing {
                            phi_3312_ = _e1698;
                            phi_1019_ = _e1700;
                            phi_1022_ = _e1702;
                            phi_1024_ = _e1704;
                            phi_1026_ = _e1706;
                            phi_1028_ = _e1708;
                            phi_3466_ = _e1698;
                            break if !(_e1710);
                        }
                    }
                    let _e1713 = phi_3466_;
                    if _e1713 {
                        break;
                    }
                    let _e1715 = local_10;
                    let _e1718 = local_11;
                    if _e134 {
                    } else {
                        break;
                    }
                    global_6.member[_e132][0u] = _e1715.member_1;
                    global_6.member[_e132][1u] = _e1718.member_2;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_counted_printed_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
