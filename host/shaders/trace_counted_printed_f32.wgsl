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
    var phi_3318_: bool;
    var phi_1019_: type_38;
    var phi_1022_: u32;
    var phi_1024_: bool;
    var phi_1026_: u32;
    var phi_1028_: type_49;
    var phi_1039_: bool;
    var phi_1125_: bool;
    var phi_1126_: u32;
    var phi_1127_: type_49;
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
    var phi_3312_: bool;
    var phi_3531_: bool;
    var phi_2222_: type_38;
    var phi_2243_: type_42;
    var phi_3132_: type_49;
    var phi_3208_: type_49;
    var phi_3209_: u32;
    var phi_3210_: type_49;
    var phi_3212_: u32;
    var phi_3213_: type_49;
    var phi_3214_: bool;
    var phi_3221_: type_49;
    var phi_3226_: bool;
    var phi_3228_: type_49;
    var phi_3233_: type_38;
    var phi_3234_: bool;
    var phi_3235_: u32;
    var phi_3236_: type_49;
    var phi_3244_: type_38;
    var phi_3247_: type_49;
    var phi_3475_: bool;
    var phi_3248_: type_38;
    var phi_3249_: u32;
    var phi_3250_: bool;
    var phi_3251_: u32;
    var phi_3252_: type_49;
    var phi_3474_: bool;
    var phi_3253_: type_38;
    var phi_3254_: u32;
    var phi_3255_: bool;
    var phi_3256_: u32;
    var phi_3257_: type_49;
    var phi_3473_: bool;
    var phi_1020_: type_38;
    var phi_1023_: u32;
    var phi_1025_: bool;
    var phi_1027_: u32;
    var phi_1029_: type_49;
    var phi_3258_: bool;
    var phi_3472_: bool;
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
                    phi_3318_ = false;
                    phi_1019_ = type_38(type_32(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e599), 0u, 0u);
                    phi_1022_ = ((3u * _e84) + 1u);
                    phi_1024_ = (_e601 <= _e599);
                    phi_1026_ = 0u;
                    phi_1028_ = type_49(type_47(array<f32, 3>(_e610, _e614, _e618), array<f32, 3>(_e622, _e624, _e626)), select(0u, 2147483648u, (_e84 == 0u)));
                    loop {
                        let _e634 = phi_3318_;
                        let _e636 = phi_1019_;
                        let _e638 = phi_1022_;
                        let _e640 = phi_1024_;
                        let _e642 = phi_1026_;
                        let _e644 = phi_1028_;
                        local_10 = _e636;
                        local_11 = _e636;
                        if _e640 {
                            phi_1039_ = true;
                        } else {
                            phi_1039_ = (_e642 > 0u);
                        }
                        let _e647 = phi_1039_;
                        if _e647 {
                            let _e648 = (_e638 > 0u);
                            if _e648 {
                                if _e640 {
                                    phi_1125_ = _e640;
                                    phi_1126_ = _e642;
                                    phi_1127_ = _e644;
                                } else {
                                    let _e649 = (_e642 - 1u);
                                    let _e650 = (_e649 % 128u);
                                    let _e651 = (_e650 < 128u);
                                    if _e651 {
                                    } else {
                                        phi_3472_ = true;
                                        break;
                                    }
                                    let _e653 = local_6[_e650];
                                    if _e651 {
                                    } else {
                                        phi_3472_ = true;
                                        break;
                                    }
                                    let _e655 = local_5[_e650];
                                    if _e651 {
                                    } else {
                                        phi_3472_ = true;
                                        break;
                                    }
                                    let _e657 = local_4[_e650];
                                    if _e651 {
                                    } else {
                                        phi_3472_ = true;
                                        break;
                                    }
                                    let _e659 = local_3[_e650];
                                    if _e651 {
                                    } else {
                                        phi_3472_ = true;
                                        break;
                                    }
                                    let _e662 = local_2[_e650];
                                    if _e651 {
                                    } else {
                                        phi_3472_ = true;
                                        break;
                                    }
                                    let _e664 = local_1[_e650];
                                    if _e651 {
                                    } else {
                                        phi_3472_ = true;
                                        break;
                                    }
                                    let _e666 = local[_e650];
                                    if _e651 {
                                    } else {
                                        phi_3472_ = true;
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
                                    let _e684 = ((_e680.member_1 & 2147483648u) != 0u);
                                    if _e684 {
                                        phi_1145_ = _e636;
                                        phi_1148_ = type_4(0u, ((_e680.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e691 = phi_1145_;
                                            let _e693 = phi_1148_;
                                            local_12 = _e691;
                                            if (_e693.member < _e693.member_1) {
                                                phi_1149_ = type_4((_e693.member + 1u), _e693.member_1);
                                                phi_1171_ = type_4(1u, _e693.member);
                                            } else {
                                                phi_1149_ = _e693;
                                                phi_1171_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e706 = phi_1149_;
                                            let _e708 = phi_1171_;
                                            let _e712 = (bitcast<i32>(_e708.member) != 0i);
                                            if _e712 {
                                                let _e718 = type_38(_e691.member, _e691.member_1, (_e691.member_2 + 1u));
                                                let _e719 = ((_e680.member_1 & 268435455u) + _e708.member_1);
                                                let _e720 = (_e719 < _e86);
                                                if _e720 {
                                                    if _e720 {
                                                    } else {
                                                        phi_3312_ = true;
                                                        break;
                                                    }
                                                    let _e724 = global_2.member[_e719].member_1;
                                                    phi_1195_ = _e724;
                                                } else {
                                                    phi_1195_ = 4294967295u;
                                                }
                                                let _e726 = phi_1195_;
                                                if (_e719 >= _e86) {
                                                    phi_1287_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e720 {
                                                    } else {
                                                        phi_3312_ = true;
                                                        break;
                                                    }
                                                    if (_e607 < 9u) {
                                                    } else {
                                                        phi_3312_ = true;
                                                        break;
                                                    }
                                                    let _e733 = global_2.member[_e719].member[_e607];
                                                    if (_e611 < 9u) {
                                                    } else {
                                                        phi_3312_ = true;
                                                        break;
                                                    }
                                                    let _e739 = global_2.member[_e719].member[_e611];
                                                    if (_e615 < 9u) {
                                                    } else {
                                                        phi_3312_ = true;
                                                        break;
                                                    }
                                                    let _e745 = global_2.member[_e719].member[_e615];
                                                    let _e747 = (3u + _e607);
                                                    if (_e747 < 9u) {
                                                    } else {
                                                        phi_3312_ = true;
                                                        break;
                                                    }
                                                    let _e753 = global_2.member[_e719].member[_e747];
                                                    let _e754 = (3u + _e611);
                                                    if (_e754 < 9u) {
                                                    } else {
                                                        phi_3312_ = true;
                                                        break;
                                                    }
                                                    let _e760 = global_2.member[_e719].member[_e754];
                                                    let _e761 = (3u + _e615);
                                                    if (_e761 < 9u) {
                                                    } else {
                                                        phi_3312_ = true;
                                                        break;
                                                    }
                                                    let _e767 = global_2.member[_e719].member[_e761];
                                                    let _e769 = (6u + _e607);
                                                    if (_e769 < 9u) {
                                                    } else {
                                                        phi_3312_ = true;
                                                        break;
                                                    }
                                                    let _e775 = global_2.member[_e719].member[_e769];
                                                    let _e776 = (6u + _e611);
                                                    if (_e776 < 9u) {
                                                    } else {
                                                        phi_3312_ = true;
                                                        break;
                                                    }
                                                    let _e782 = global_2.member[_e719].member[_e776];
                                                    let _e783 = (6u + _e615);
                                                    if (_e783 < 9u) {
                                                    } else {
                                                        phi_3312_ = true;
                                                        break;
                                                    }
                                                    let _e789 = global_2.member[_e719].member[_e783];
                                                    phi_1287_ = array<array<f32, 3>, 3>(array<f32, 3>(_e733, _e739, _e745), array<f32, 3>(_e753, _e760, _e767), array<f32, 3>(_e775, _e782, _e789));
                                                }
                                                let _e793 = phi_1287_;
                                                let _e802 = (_e793[0][2] - _e447);
                                                let _e805 = (((_e793[0][0] - _e310) * _e486) - (_e802 * _e350));
                                                let _e808 = (((_e793[0][1] - _e379) * _e486) - (_e802 * _e418));
                                                let _e815 = (_e793[1][2] - _e447);
                                                let _e818 = (((_e793[1][0] - _e310) * _e486) - (_e815 * _e350));
                                                let _e821 = (((_e793[1][1] - _e379) * _e486) - (_e815 * _e418));
                                                let _e828 = (_e793[2][2] - _e447);
                                                let _e831 = (((_e793[2][0] - _e310) * _e486) - (_e828 * _e350));
                                                let _e834 = (((_e793[2][1] - _e379) * _e486) - (_e828 * _e418));
                                                let _e835 = (_e831 * _e821);
                                                let _e836 = (_e834 * _e818);
                                                let _e837 = (_e805 * _e834);
                                                let _e838 = (_e808 * _e831);
                                                let _e839 = (_e818 * _e808);
                                                let _e840 = (_e821 * _e805);
                                                let _e845 = (((_e835 >= _e836) && (_e837 >= _e838)) && (_e839 >= _e840));
                                                if (_e845 || (((_e835 <= _e836) && (_e837 <= _e838)) && (_e839 <= _e840))) {
                                                    let _e852 = select(-1f, 1f, _e845);
                                                    let _e854 = ((_e835 - _e836) * _e852);
                                                    let _e856 = select(0f, _e854, (_e854 > 0f));
                                                    let _e858 = ((_e837 - _e838) * _e852);
                                                    let _e860 = select(0f, _e858, (_e858 > 0f));
                                                    let _e862 = ((_e839 - _e840) * _e852);
                                                    let _e864 = select(0f, _e862, (_e862 > 0f));
                                                    let _e866 = ((_e856 + _e860) + _e864);
                                                    if (_e866 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2171_ = type_25();
                                                        phi_2172_ = true;
                                                        phi_2173_ = false;
                                                    } else {
                                                        let _e869 = select(_e818, _e805, (_e805 < _e818));
                                                        if (select(_e831, _e869, (_e869 < _e831)) > 0f) {
                                                            phi_1439_ = true;
                                                        } else {
                                                            let _e874 = select(_e818, _e805, (_e805 > _e818));
                                                            phi_1439_ = (select(_e831, _e874, (_e874 > _e831)) < 0f);
                                                        }
                                                        let _e879 = phi_1439_;
                                                        if _e879 {
                                                            phi_2168_ = type_25();
                                                            phi_2169_ = true;
                                                            phi_2170_ = false;
                                                        } else {
                                                            let _e881 = select(_e821, _e808, (_e808 < _e821));
                                                            if (select(_e834, _e881, (_e881 < _e834)) > 0f) {
                                                                phi_1468_ = true;
                                                            } else {
                                                                let _e886 = select(_e821, _e808, (_e808 > _e821));
                                                                phi_1468_ = (select(_e834, _e886, (_e886 > _e834)) < 0f);
                                                            }
                                                            let _e891 = phi_1468_;
                                                            if _e891 {
                                                                phi_2166_ = type_25();
                                                                phi_2167_ = false;
                                                            } else {
                                                                let _e893 = select(_e793[1][0], _e793[0][0], (_e793[0][0] < _e793[1][0]));
                                                                let _e897 = select(_e793[1][0], _e793[0][0], (_e793[0][0] > _e793[1][0]));
                                                                let _e901 = select(_e793[1][1], _e793[0][1], (_e793[0][1] < _e793[1][1]));
                                                                let _e905 = select(_e793[1][1], _e793[0][1], (_e793[0][1] > _e793[1][1]));
                                                                let _e909 = select(_e793[1][2], _e793[0][2], (_e793[0][2] < _e793[1][2]));
                                                                let _e913 = select(_e793[1][2], _e793[0][2], (_e793[0][2] > _e793[1][2]));
                                                                let _e918 = ((select(_e793[2][0], _e893, (_e893 < _e793[2][0])) - _e348) * _e353);
                                                                let _e919 = ((select(_e793[2][0], _e897, (_e897 > _e793[2][0])) - _e349) * _e353);
                                                                let _e922 = ((select(_e793[2][1], _e901, (_e901 < _e793[2][1])) - _e416) * _e421);
                                                                let _e923 = ((select(_e793[2][1], _e905, (_e905 > _e793[2][1])) - _e417) * _e421);
                                                                let _e926 = ((select(_e793[2][2], _e909, (_e909 < _e793[2][2])) - _e484) * _e489);
                                                                let _e927 = ((select(_e793[2][2], _e913, (_e913 > _e793[2][2])) - _e485) * _e489);
                                                                let _e929 = select(_e927, _e926, (_e926 < _e927));
                                                                let _e931 = select(_e927, _e926, (_e926 > _e927));
                                                                let _e933 = select(_e919, _e918, (_e918 < _e919));
                                                                let _e935 = select(_e923, _e922, (_e922 < _e923));
                                                                let _e937 = select(_e935, _e933, (_e933 > _e935));
                                                                let _e939 = select(_e929, _e937, (_e937 > _e929));
                                                                let _e941 = select(_e919, _e918, (_e918 > _e919));
                                                                let _e943 = select(_e923, _e922, (_e922 > _e923));
                                                                let _e945 = select(_e943, _e941, (_e941 < _e943));
                                                                let _e947 = select(_e931, _e945, (_e945 < _e931));
                                                                let _e948 = -(_e929);
                                                                let _e954 = select(_e601, _e939, (_e939 > _e601));
                                                                if (_e954 > (_e947 + (select(_e948, _e931, (_e931 > _e948)) * 0.0000019073523f))) {
                                                                    phi_2161_ = type_25();
                                                                    phi_2162_ = true;
                                                                } else {
                                                                    let _e956 = (_e954 > _e691.member.member_1);
                                                                    if _e956 {
                                                                        phi_2160_ = type_25();
                                                                    } else {
                                                                        let _e957 = vec3<f32>(_e793[0][0], _e793[0][1], _e793[0][2]);
                                                                        let _e958 = vec3<f32>(_e793[1][0], _e793[1][1], _e793[1][2]);
                                                                        let _e959 = vec3<f32>(_e793[2][0], _e793[2][1], _e793[2][2]);
                                                                        let _e960 = (_e793[1][0] - _e793[0][0]);
                                                                        let _e961 = (_e793[1][1] - _e793[0][1]);
                                                                        let _e962 = (_e793[1][2] - _e793[0][2]);
                                                                        let _e963 = vec3<f32>(_e960, _e961, _e962);
                                                                        let _e964 = (_e793[2][0] - _e793[1][0]);
                                                                        let _e965 = (_e793[2][1] - _e793[1][1]);
                                                                        let _e966 = (_e793[2][2] - _e793[1][2]);
                                                                        let _e967 = vec3<f32>(_e964, _e965, _e966);
                                                                        let _e968 = (_e793[0][0] - _e793[2][0]);
                                                                        let _e969 = (_e793[0][1] - _e793[2][1]);
                                                                        let _e970 = (_e793[0][2] - _e793[2][2]);
                                                                        let _e971 = vec3<f32>(_e968, _e969, _e970);
                                                                        let _e974 = bitcast<f32>((bitcast<u32>(_e960) & 2147483647u));
                                                                        let _e977 = bitcast<f32>((bitcast<u32>(_e961) & 2147483647u));
                                                                        let _e979 = select(_e977, _e974, (_e974 > _e977));
                                                                        let _e982 = bitcast<f32>((bitcast<u32>(_e962) & 2147483647u));
                                                                        let _e984 = select(_e982, _e979, (_e979 > _e982));
                                                                        let _e987 = bitcast<f32>((bitcast<u32>(_e964) & 2147483647u));
                                                                        let _e990 = bitcast<f32>((bitcast<u32>(_e965) & 2147483647u));
                                                                        let _e992 = select(_e990, _e987, (_e987 > _e990));
                                                                        let _e995 = bitcast<f32>((bitcast<u32>(_e966) & 2147483647u));
                                                                        let _e997 = select(_e995, _e992, (_e992 > _e995));
                                                                        let _e1000 = bitcast<f32>((bitcast<u32>(_e968) & 2147483647u));
                                                                        let _e1003 = bitcast<f32>((bitcast<u32>(_e969) & 2147483647u));
                                                                        let _e1005 = select(_e1003, _e1000, (_e1000 > _e1003));
                                                                        let _e1008 = bitcast<f32>((bitcast<u32>(_e970) & 2147483647u));
                                                                        let _e1010 = select(_e1008, _e1005, (_e1005 > _e1008));
                                                                        let _e1012 = select(_e997, _e984, (_e984 > _e997));
                                                                        let _e1014 = select(_e1010, _e1012, (_e1012 > _e1010));
                                                                        if (_e984 == _e1014) {
                                                                            phi_1887_ = _e821;
                                                                            phi_1888_ = _e818;
                                                                            phi_1889_ = _e808;
                                                                            phi_1890_ = _e805;
                                                                            phi_1891_ = _e957;
                                                                            phi_1892_ = _e971;
                                                                            phi_1893_ = _e967;
                                                                            phi_1894_ = _e963;
                                                                        } else {
                                                                            let _e1016 = (_e997 == _e1014);
                                                                            let _e1021 = vec3(_e1016);
                                                                            phi_1887_ = select(_e808, _e834, _e1016);
                                                                            phi_1888_ = select(_e805, _e831, _e1016);
                                                                            phi_1889_ = select(_e834, _e821, _e1016);
                                                                            phi_1890_ = select(_e831, _e818, _e1016);
                                                                            phi_1891_ = select(_e959, _e958, _e1021);
                                                                            phi_1892_ = select(_e967, _e963, _e1021);
                                                                            phi_1893_ = select(_e963, _e971, _e1021);
                                                                            phi_1894_ = select(_e971, _e967, _e1021);
                                                                        }
                                                                        let _e1027 = phi_1887_;
                                                                        let _e1029 = phi_1888_;
                                                                        let _e1031 = phi_1889_;
                                                                        let _e1033 = phi_1890_;
                                                                        let _e1035 = phi_1891_;
                                                                        let _e1037 = phi_1892_;
                                                                        let _e1039 = phi_1893_;
                                                                        let _e1041 = phi_1894_;
                                                                        let _e1048 = ((_e1039.y * _e1037.z) - (_e1037.y * _e1039.z));
                                                                        let _e1053 = ((_e1039.z * _e1037.x) - (_e1037.z * _e1039.x));
                                                                        let _e1056 = ((_e1039.x * _e1037.y) - (_e1037.x * _e1039.y));
                                                                        if (_e856 >= _e860) {
                                                                            phi_1931_ = select(true, false, (_e856 >= _e864));
                                                                        } else {
                                                                            phi_1931_ = true;
                                                                        }
                                                                        let _e1061 = phi_1931_;
                                                                        if _e1061 {
                                                                            phi_1940_ = select(_e959, _e958, vec3((_e860 >= _e864)));
                                                                        } else {
                                                                            phi_1940_ = _e957;
                                                                        }
                                                                        let _e1066 = phi_1940_;
                                                                        let _e1077 = (((_e1048 * (_e1066.x - _e310)) + (_e1053 * (_e1066.y - _e379))) + (_e1056 * (_e1066.z - _e447)));
                                                                        let _e1082 = (((_e1048 * _e350) + (_e1053 * _e418)) + (_e1056 * _e486));
                                                                        let _e1083 = (_e1029 - _e1033);
                                                                        let _e1084 = (_e1027 - _e1031);
                                                                        let _e1092 = (-(((_e1033 * _e1083) + (_e1031 * _e1084))) / ((_e1083 * _e1083) + (_e1084 * _e1084)));
                                                                        let _e1094 = select(1f, _e1092, (_e1092 < 1f));
                                                                        let _e1096 = select(0f, _e1094, (_e1094 > 0f));
                                                                        let _e1109 = ((_e1035.x + (_e1041.x * _e1096)) - _e310);
                                                                        let _e1110 = ((_e1035.y + (_e1041.y * _e1096)) - _e379);
                                                                        let _e1111 = ((_e1035.z + (_e1041.z * _e1096)) - _e447);
                                                                        let _e1112 = (_e1111 / _e486);
                                                                        let _e1124 = bitcast<f32>((bitcast<u32>(_e1109) & 2147483647u));
                                                                        let _e1127 = bitcast<f32>((bitcast<u32>(_e1110) & 2147483647u));
                                                                        let _e1129 = select(_e1127, _e1124, (_e1124 > _e1127));
                                                                        let _e1132 = bitcast<f32>((bitcast<u32>(_e1111) & 2147483647u));
                                                                        let _e1134 = select(_e1132, _e1129, (_e1129 > _e1132));
                                                                        let _e1140 = bitcast<f32>((bitcast<u32>(_e1048) & 2147483647u));
                                                                        let _e1143 = bitcast<f32>((bitcast<u32>(_e1053) & 2147483647u));
                                                                        let _e1145 = select(_e1143, _e1140, (_e1140 > _e1143));
                                                                        let _e1148 = bitcast<f32>((bitcast<u32>(_e1056) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1048 * _e1109) + (_e1053 * _e1110)) + (_e1056 * _e1111)) - _e1077)) & 2147483647u)) <= ((0.0000009536743f * select(_e1014, _e1134, (_e1134 > _e1014))) * select(_e1148, _e1145, (_e1145 > _e1148)))) {
                                                                            let _e1158 = bitcast<f32>((bitcast<u32>(_e1039.x) & 2147483647u));
                                                                            let _e1161 = bitcast<f32>((bitcast<u32>(_e1039.y) & 2147483647u));
                                                                            let _e1163 = select(_e1161, _e1158, (_e1158 > _e1161));
                                                                            let _e1166 = bitcast<f32>((bitcast<u32>(_e1039.z) & 2147483647u));
                                                                            let _e1172 = bitcast<f32>((bitcast<u32>(_e1037.x) & 2147483647u));
                                                                            let _e1175 = bitcast<f32>((bitcast<u32>(_e1037.y) & 2147483647u));
                                                                            let _e1177 = select(_e1175, _e1172, (_e1172 > _e1175));
                                                                            let _e1180 = bitcast<f32>((bitcast<u32>(_e1037.z) & 2147483647u));
                                                                            let _e1184 = (bitcast<f32>((bitcast<u32>(_e1082) & 2147483647u)) > ((0.0000038146973f * select(_e1166, _e1163, (_e1163 > _e1166))) * select(_e1180, _e1177, (_e1177 > _e1180))));
                                                                            if _e1184 {
                                                                                phi_2105_ = (_e1077 / _e1082);
                                                                            } else {
                                                                                phi_2105_ = f32();
                                                                            }
                                                                            let _e1187 = phi_2105_;
                                                                            phi_2107_ = _e1187;
                                                                            phi_2108_ = select(true, false, _e1184);
                                                                        } else {
                                                                            phi_2107_ = f32();
                                                                            phi_2108_ = true;
                                                                        }
                                                                        let _e1190 = phi_2107_;
                                                                        let _e1192 = phi_2108_;
                                                                        if _e1192 {
                                                                            let _e1200 = (((_e1048 * (_e1109 - (_e350 * _e1112))) + (_e1053 * (_e1110 - (_e418 * _e1112)))) / _e1082);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1200) & 2147483647u)) <= _e1014) {
                                                                                phi_2128_ = (_e1112 + _e1200);
                                                                            } else {
                                                                                phi_2128_ = _e1112;
                                                                            }
                                                                            let _e1207 = phi_2128_;
                                                                            phi_2129_ = _e1207;
                                                                        } else {
                                                                            phi_2129_ = _e1190;
                                                                        }
                                                                        let _e1209 = phi_2129_;
                                                                        let _e1211 = select(_e947, _e1209, (_e1209 < _e947));
                                                                        let _e1213 = select(_e939, _e1211, (_e1211 > _e939));
                                                                        if (_e1213 >= _e601) {
                                                                            let _e1215 = (_e1213 <= _e691.member.member_1);
                                                                            if _e1215 {
                                                                                let _e1216 = (1f / _e866);
                                                                                phi_2152_ = type_25(_e1213, (_e860 * _e1216), (_e864 * _e1216), _e726);
                                                                            } else {
                                                                                phi_2152_ = type_25();
                                                                            }
                                                                            let _e1221 = phi_2152_;
                                                                            phi_2154_ = _e1221;
                                                                            phi_2155_ = select(true, false, _e1215);
                                                                        } else {
                                                                            phi_2154_ = type_25();
                                                                            phi_2155_ = true;
                                                                        }
                                                                        let _e1224 = phi_2154_;
                                                                        let _e1226 = phi_2155_;
                                                                        if _e1226 {
                                                                            phi_2159_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2159_ = _e1224;
                                                                        }
                                                                        let _e1228 = phi_2159_;
                                                                        phi_2160_ = _e1228;
                                                                    }
                                                                    let _e1230 = phi_2160_;
                                                                    phi_2161_ = _e1230;
                                                                    phi_2162_ = _e956;
                                                                }
                                                                let _e1232 = phi_2161_;
                                                                let _e1234 = phi_2162_;
                                                                phi_2166_ = _e1232;
                                                                phi_2167_ = _e1234;
                                                            }
                                                            let _e1236 = phi_2166_;
                                                            let _e1238 = phi_2167_;
                                                            phi_2168_ = _e1236;
                                                            phi_2169_ = _e891;
                                                            phi_2170_ = _e1238;
                                                        }
                                                        let _e1240 = phi_2168_;
                                                        let _e1242 = phi_2169_;
                                                        let _e1244 = phi_2170_;
                                                        phi_2171_ = _e1240;
                                                        phi_2172_ = _e1242;
                                                        phi_2173_ = _e1244;
                                                    }
                                                    let _e1246 = phi_2171_;
                                                    let _e1248 = phi_2172_;
                                                    let _e1250 = phi_2173_;
                                                    phi_2181_ = _e1246;
                                                    phi_2182_ = select(_e1250, true, _e1248);
                                                } else {
                                                    phi_2181_ = type_25();
                                                    phi_2182_ = true;
                                                }
                                                let _e1253 = phi_2181_;
                                                let _e1255 = phi_2182_;
                                                if _e1255 {
                                                    phi_2186_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2186_ = _e1253;
                                                }
                                                let _e1257 = phi_2186_;
                                                if (_e1257.member_3 != 4294967295u) {
                                                    if (_e726 != 4294967295u) {
                                                        if (_e1257.member < _e691.member.member.member) {
                                                            phi_2212_ = true;
                                                        } else {
                                                            if (_e1257.member == _e691.member.member.member) {
                                                                phi_2211_ = (_e1257.member_3 < _e691.member.member.member_3);
                                                            } else {
                                                                phi_2211_ = false;
                                                            }
                                                            let _e1272 = phi_2211_;
                                                            phi_2212_ = _e1272;
                                                        }
                                                        let _e1274 = phi_2212_;
                                                        if _e1274 {
                                                            phi_2219_ = type_38(type_32(_e1257, _e1257.member), _e718.member_1, _e718.member_2);
                                                        } else {
                                                            phi_2219_ = _e718;
                                                        }
                                                        let _e1281 = phi_2219_;
                                                        phi_2220_ = _e1281;
                                                    } else {
                                                        phi_2220_ = _e718;
                                                    }
                                                    let _e1283 = phi_2220_;
                                                    phi_2221_ = _e1283;
                                                } else {
                                                    phi_2221_ = _e718;
                                                }
                                                let _e1285 = phi_2221_;
                                                phi_1146_ = _e1285;
                                            } else {
                                                phi_1146_ = type_38();
                                            }
                                            let _e1287 = phi_1146_;
                                            continue;
                                            continuing {
                                                phi_1145_ = _e1287;
                                                phi_1148_ = _e706;
                                                phi_3312_ = _e634;
                                                break if !(_e712);
                                            }
                                        }
                                        let _e1290 = phi_3312_;
                                        phi_3472_ = _e1290;
                                        if _e1290 {
                                            break;
                                        }
                                        phi_3531_ = _e1290;
                                        let _e1829 = local_12;
                                        phi_2222_ = _e1829;
                                    } else {
                                        phi_3531_ = _e634;
                                        phi_2222_ = _e636;
                                    }
                                    let _e1292 = phi_3531_;
                                    let _e1294 = phi_2222_;
                                    if _e684 {
                                        phi_3233_ = type_38();
                                        phi_3234_ = bool();
                                        phi_3235_ = u32();
                                        phi_3236_ = type_49();
                                    } else {
                                        let _e1295 = (_e680.member_1 < _e84);
                                        if _e1295 {
                                            if _e1295 {
                                            } else {
                                                phi_3472_ = true;
                                                break;
                                            }
                                            let _e1297 = global_5.member[_e680.member_1];
                                            phi_2243_ = _e1297;
                                        } else {
                                            phi_2243_ = type_42(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e1299 = phi_2243_;
                                        let _e1314 = ((10u * _e246) & 31u);
                                        let _e1317 = ((_e1299.member[0] >> bitcast<u32>(_e1314)) & 1023u);
                                        let _e1325 = bitcast<f32>((bitcast<u32>(((_e680.member.member_1[0] - _e680.member.member[0]) * 0.0009775171f)) ^ _e118));
                                        let _e1330 = (_e680.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1317)) - 8388608f) * _e1325)) ^ _e118)));
                                        let _e1334 = select(select(_e680.member.member_1[0], _e1330, (_e1330 < _e680.member.member_1[0])), _e680.member.member_1[0], (_e1317 == 1023u));
                                        let _e1336 = ((10u * _e245) & 31u);
                                        let _e1339 = ((_e1299.member[0] >> bitcast<u32>(_e1336)) & 1023u);
                                        let _e1347 = bitcast<f32>((bitcast<u32>(((_e680.member.member_1[1] - _e680.member.member[1]) * 0.0009775171f)) ^ _e118));
                                        let _e1352 = (_e680.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1339)) - 8388608f) * _e1347)) ^ _e118)));
                                        let _e1356 = select(select(_e680.member.member_1[1], _e1352, (_e1352 < _e680.member.member_1[1])), _e680.member.member_1[1], (_e1339 == 1023u));
                                        let _e1358 = ((10u * _e247) & 31u);
                                        let _e1361 = ((_e1299.member[0] >> bitcast<u32>(_e1358)) & 1023u);
                                        let _e1369 = bitcast<f32>((bitcast<u32>(((_e680.member.member_1[2] - _e680.member.member[2]) * 0.0009775171f)) ^ _e118));
                                        let _e1374 = (_e680.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1361)) - 8388608f) * _e1369)) ^ _e118)));
                                        let _e1378 = select(select(_e680.member.member_1[2], _e1374, (_e1374 < _e680.member.member_1[2])), _e680.member.member_1[2], (_e1361 == 1023u));
                                        let _e1381 = ((_e1299.member[1] >> bitcast<u32>(_e1314)) & 1023u);
                                        let _e1389 = (_e680.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1381)) - 8388608f) * _e1325)) ^ _e118)));
                                        let _e1393 = select(select(_e680.member.member_1[0], _e1389, (_e1389 < _e680.member.member_1[0])), _e680.member.member_1[0], (_e1381 == 1023u));
                                        let _e1396 = ((_e1299.member[1] >> bitcast<u32>(_e1336)) & 1023u);
                                        let _e1404 = (_e680.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1396)) - 8388608f) * _e1347)) ^ _e118)));
                                        let _e1408 = select(select(_e680.member.member_1[1], _e1404, (_e1404 < _e680.member.member_1[1])), _e680.member.member_1[1], (_e1396 == 1023u));
                                        let _e1411 = ((_e1299.member[1] >> bitcast<u32>(_e1358)) & 1023u);
                                        let _e1419 = (_e680.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1411)) - 8388608f) * _e1369)) ^ _e118)));
                                        let _e1423 = select(select(_e680.member.member_1[2], _e1419, (_e1419 < _e680.member.member_1[2])), _e680.member.member_1[2], (_e1411 == 1023u));
                                        let _e1429 = ((_e1299.member_1[0] >> bitcast<u32>(_e1314)) & 1023u);
                                        let _e1437 = (_e680.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1429)) - 8388608f) * _e1325)) ^ _e118)));
                                        let _e1441 = select(select(_e680.member.member_1[0], _e1437, (_e1437 < _e680.member.member_1[0])), _e680.member.member_1[0], (_e1429 == 1023u));
                                        let _e1444 = ((_e1299.member_1[0] >> bitcast<u32>(_e1336)) & 1023u);
                                        let _e1452 = (_e680.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1444)) - 8388608f) * _e1347)) ^ _e118)));
                                        let _e1456 = select(select(_e680.member.member_1[1], _e1452, (_e1452 < _e680.member.member_1[1])), _e680.member.member_1[1], (_e1444 == 1023u));
                                        let _e1459 = ((_e1299.member_1[0] >> bitcast<u32>(_e1358)) & 1023u);
                                        let _e1467 = (_e680.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1459)) - 8388608f) * _e1369)) ^ _e118)));
                                        let _e1471 = select(select(_e680.member.member_1[2], _e1467, (_e1467 < _e680.member.member_1[2])), _e680.member.member_1[2], (_e1459 == 1023u));
                                        let _e1474 = ((_e1299.member_1[1] >> bitcast<u32>(_e1314)) & 1023u);
                                        let _e1482 = (_e680.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1474)) - 8388608f) * _e1325)) ^ _e118)));
                                        let _e1486 = select(select(_e680.member.member_1[0], _e1482, (_e1482 < _e680.member.member_1[0])), _e680.member.member_1[0], (_e1474 == 1023u));
                                        let _e1489 = ((_e1299.member_1[1] >> bitcast<u32>(_e1336)) & 1023u);
                                        let _e1497 = (_e680.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1489)) - 8388608f) * _e1347)) ^ _e118)));
                                        let _e1501 = select(select(_e680.member.member_1[1], _e1497, (_e1497 < _e680.member.member_1[1])), _e680.member.member_1[1], (_e1489 == 1023u));
                                        let _e1504 = ((_e1299.member_1[1] >> bitcast<u32>(_e1358)) & 1023u);
                                        let _e1512 = (_e680.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1504)) - 8388608f) * _e1369)) ^ _e118)));
                                        let _e1516 = select(select(_e680.member.member_1[2], _e1512, (_e1512 < _e680.member.member_1[2])), _e680.member.member_1[2], (_e1504 == 1023u));
                                        let _e1521 = type_49(type_47(array<f32, 3>(_e1334, _e1356, _e1378), array<f32, 3>(_e1393, _e1408, _e1423)), _e1299.member_2);
                                        let _e1526 = type_49(type_47(array<f32, 3>(_e1441, _e1456, _e1471), array<f32, 3>(_e1486, _e1501, _e1516)), _e1299.member_3);
                                        let _e1539 = ((_e1334 - _e348) * _e353);
                                        let _e1540 = ((_e1441 - _e348) * _e353);
                                        let _e1541 = ((_e1393 - _e349) * _e353);
                                        let _e1542 = ((_e1486 - _e349) * _e353);
                                        let _e1547 = ((_e1356 - _e416) * _e421);
                                        let _e1548 = ((_e1456 - _e416) * _e421);
                                        let _e1549 = ((_e1408 - _e417) * _e421);
                                        let _e1550 = ((_e1501 - _e417) * _e421);
                                        let _e1555 = ((_e1378 - _e484) * _e489);
                                        let _e1556 = ((_e1471 - _e484) * _e489);
                                        let _e1557 = ((_e1423 - _e485) * _e489);
                                        let _e1558 = ((_e1516 - _e485) * _e489);
                                        let _e1560 = select(_e1557, _e1555, (_e1555 < _e1557));
                                        let _e1562 = select(_e1558, _e1556, (_e1556 < _e1558));
                                        let _e1564 = select(_e1557, _e1555, (_e1555 > _e1557));
                                        let _e1566 = select(_e1558, _e1556, (_e1556 > _e1558));
                                        let _e1568 = select(_e1541, _e1539, (_e1539 < _e1541));
                                        let _e1570 = select(_e1542, _e1540, (_e1540 < _e1542));
                                        let _e1572 = select(_e1549, _e1547, (_e1547 < _e1549));
                                        let _e1574 = select(_e1550, _e1548, (_e1548 < _e1550));
                                        let _e1576 = select(_e1572, _e1568, (_e1568 > _e1572));
                                        let _e1578 = select(_e1574, _e1570, (_e1570 > _e1574));
                                        let _e1580 = select(_e1560, _e1576, (_e1576 > _e1560));
                                        let _e1582 = select(_e1562, _e1578, (_e1578 > _e1562));
                                        let _e1584 = select(_e1541, _e1539, (_e1539 > _e1541));
                                        let _e1586 = select(_e1542, _e1540, (_e1540 > _e1542));
                                        let _e1588 = select(_e1549, _e1547, (_e1547 > _e1549));
                                        let _e1590 = select(_e1550, _e1548, (_e1548 > _e1550));
                                        let _e1592 = select(_e1588, _e1584, (_e1584 < _e1588));
                                        let _e1594 = select(_e1590, _e1586, (_e1586 < _e1590));
                                        let _e1599 = -(_e1560);
                                        let _e1600 = -(_e1562);
                                        let _e1607 = (select(_e1564, _e1592, (_e1592 < _e1564)) + (select(_e1599, _e1564, (_e1564 > _e1599)) * 0.0000019073523f));
                                        let _e1608 = (select(_e1566, _e1594, (_e1594 < _e1566)) + (select(_e1600, _e1566, (_e1566 > _e1600)) * 0.0000019073523f));
                                        let _e1610 = select(_e601, _e1580, (_e1580 > _e601));
                                        let _e1612 = select(_e601, _e1582, (_e1582 > _e601));
                                        let _e1617 = (_e1610 <= select(_e1294.member.member_1, _e1607, (_e1607 < _e1294.member.member_1)));
                                        let _e1618 = (_e1612 <= select(_e1294.member.member_1, _e1608, (_e1608 < _e1294.member.member_1)));
                                        let _e1619 = (_e1610 <= _e1612);
                                        if _e1617 {
                                            if _e1618 {
                                                if _e1619 {
                                                    phi_3132_ = _e1526;
                                                } else {
                                                    phi_3132_ = _e1521;
                                                }
                                                let _e1621 = phi_3132_;
                                                let _e1628 = (_e678 % 128u);
                                                let _e1629 = (_e1628 < 128u);
                                                if _e1629 {
                                                } else {
                                                    phi_3472_ = true;
                                                    break;
                                                }
                                                local_6[_e1628] = _e1621.member_1;
                                                if _e1629 {
                                                } else {
                                                    phi_3472_ = true;
                                                    break;
                                                }
                                                local_5[_e1628] = _e1621.member.member[0];
                                                if _e1629 {
                                                } else {
                                                    phi_3472_ = true;
                                                    break;
                                                }
                                                local_4[_e1628] = _e1621.member.member[1];
                                                if _e1629 {
                                                } else {
                                                    phi_3472_ = true;
                                                    break;
                                                }
                                                local_3[_e1628] = _e1621.member.member[2];
                                                if _e1629 {
                                                } else {
                                                    phi_3472_ = true;
                                                    break;
                                                }
                                                local_2[_e1628] = _e1621.member.member_1[0];
                                                if _e1629 {
                                                } else {
                                                    phi_3472_ = true;
                                                    break;
                                                }
                                                local_1[_e1628] = _e1621.member.member_1[1];
                                                if _e1629 {
                                                } else {
                                                    phi_3472_ = true;
                                                    break;
                                                }
                                                local[_e1628] = _e1621.member.member_1[2];
                                                if _e1629 {
                                                } else {
                                                    phi_3472_ = true;
                                                    break;
                                                }
                                                local_7[_e1628] = select(_e1610, _e1612, _e1619);
                                                if _e1619 {
                                                    phi_3208_ = _e1521;
                                                } else {
                                                    phi_3208_ = _e1526;
                                                }
                                                let _e1646 = phi_3208_;
                                                phi_3209_ = (_e678 + 1u);
                                                phi_3210_ = _e1646;
                                            } else {
                                                phi_3209_ = u32();
                                                phi_3210_ = type_49();
                                            }
                                            let _e1648 = phi_3209_;
                                            let _e1650 = phi_3210_;
                                            phi_3212_ = _e1648;
                                            phi_3213_ = _e1650;
                                            phi_3214_ = select(true, false, _e1618);
                                        } else {
                                            phi_3212_ = u32();
                                            phi_3213_ = type_49();
                                            phi_3214_ = true;
                                        }
                                        let _e1653 = phi_3212_;
                                        let _e1655 = phi_3213_;
                                        let _e1657 = phi_3214_;
                                        if _e1657 {
                                            if _e1617 {
                                                phi_3221_ = _e1521;
                                            } else {
                                                phi_3221_ = _e1526;
                                            }
                                            let _e1659 = phi_3221_;
                                            phi_3226_ = select(_e1618, true, _e1617);
                                            phi_3228_ = _e1659;
                                        } else {
                                            phi_3226_ = _e676;
                                            phi_3228_ = _e1655;
                                        }
                                        let _e1662 = phi_3226_;
                                        let _e1664 = phi_3228_;
                                        phi_3233_ = type_38(_e1294.member, (_e1294.member_1 + 1u), _e1294.member_2);
                                        phi_3234_ = _e1662;
                                        phi_3235_ = select(_e1653, _e678, _e1657);
                                        phi_3236_ = _e1664;
                                    }
                                    let _e1667 = phi_3233_;
                                    let _e1669 = phi_3234_;
                                    let _e1671 = phi_3235_;
                                    let _e1673 = phi_3236_;
                                    if _e684 {
                                        phi_3244_ = _e1294;
                                        phi_3247_ = _e680;
                                    } else {
                                        phi_3244_ = _e1667;
                                        phi_3247_ = _e1673;
                                    }
                                    let _e1675 = phi_3244_;
                                    let _e1677 = phi_3247_;
                                    phi_3475_ = _e1292;
                                    phi_3248_ = _e1675;
                                    phi_3249_ = (_e638 - 1u);
                                    phi_3250_ = select(_e1669, false, _e684);
                                    phi_3251_ = select(_e1671, _e678, _e684);
                                    phi_3252_ = _e1677;
                                } else {
                                    phi_3475_ = _e634;
                                    phi_3248_ = _e636;
                                    phi_3249_ = _e638;
                                    phi_3250_ = _e676;
                                    phi_3251_ = _e678;
                                    phi_3252_ = _e680;
                                }
                                let _e1681 = phi_3475_;
                                let _e1683 = phi_3248_;
                                let _e1685 = phi_3249_;
                                let _e1687 = phi_3250_;
                                let _e1689 = phi_3251_;
                                let _e1691 = phi_3252_;
                                phi_3474_ = _e1681;
                                phi_3253_ = _e1683;
                                phi_3254_ = _e1685;
                                phi_3255_ = _e1687;
                                phi_3256_ = _e1689;
                                phi_3257_ = _e1691;
                            } else {
                                phi_3474_ = _e634;
                                phi_3253_ = type_38();
                                phi_3254_ = u32();
                                phi_3255_ = bool();
                                phi_3256_ = u32();
                                phi_3257_ = type_49();
                            }
                            let _e1693 = phi_3474_;
                            let _e1695 = phi_3253_;
                            let _e1697 = phi_3254_;
                            let _e1699 = phi_3255_;
                            let _e1701 = phi_3256_;
                            let _e1703 = phi_3257_;
                            phi_3473_ = _e1693;
                            phi_1020_ = _e1695;
                            phi_1023_ = _e1697;
                            phi_1025_ = _e1699;
                            phi_1027_ = _e1701;
                            phi_1029_ = _e1703;
                            phi_3258_ = _e648;
                        } else {
                            phi_3473_ = _e634;
                            phi_1020_ = type_38();
                            phi_1023_ = u32();
                            phi_1025_ = bool();
                            phi_1027_ = u32();
                            phi_1029_ = type_49();
                            phi_3258_ = false;
                        }
                        let _e1705 = phi_3473_;
                        let _e1707 = phi_1020_;
                        let _e1709 = phi_1023_;
                        let _e1711 = phi_1025_;
                        let _e1713 = phi_1027_;
                        let _e1715 = phi_1029_;
                        let _e1717 = phi_3258_;
                        continue;
                        continuing {
                            phi_3318_ = _e1705;
                            phi_1019_ = _e1707;
                            phi_1022_ = _e1709;
                            phi_1024_ = _e1711;
                            phi_1026_ = _e1713;
                            phi_1028_ = _e1715;
                            phi_3472_ = _e1705;
                            break if !(_e1717);
                        }
                    }
                    let _e1720 = phi_3472_;
                    if _e1720 {
                        break;
                    }
                    let _e1722 = local_10;
                    let _e1725 = local_11;
                    if _e134 {
                    } else {
                        break;
                    }
                    global_6.member[_e132][0u] = _e1722.member_1;
                    global_6.member[_e132][1u] = _e1725.member_2;
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
