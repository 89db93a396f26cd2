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
    var phi_332_: i32;
    var phi_333_: i32;
    var phi_343_: bool;
    var phi_353_: u32;
    var phi_354_: u32;
    var phi_356_: bool;
    var phi_361_: u32;
    var phi_373_: i32;
    var phi_393_: i32;
    var phi_411_: f32;
    var phi_417_: f32;
    var phi_457_: f32;
    var phi_463_: f32;
    var phi_515_: f32;
    var phi_526_: f32;
    var phi_535_: f32;
    var phi_541_: f32;
    var phi_581_: f32;
    var phi_587_: f32;
    var phi_639_: f32;
    var phi_650_: f32;
    var phi_659_: f32;
    var phi_665_: f32;
    var phi_705_: f32;
    var phi_711_: f32;
    var phi_763_: f32;
    var phi_774_: f32;
    var phi_829_: i32;
    var phi_851_: u32;
    var phi_852_: u32;
    var phi_889_: i32;
    var phi_911_: u32;
    var phi_912_: u32;
    var phi_920_: f32;
    var phi_921_: f32;
    var phi_3185_: bool;
    var phi_995_: type_38;
    var phi_998_: type_49;
    var phi_1000_: u32;
    var phi_1002_: bool;
    var phi_1004_: u32;
    var phi_1015_: bool;
    var phi_1101_: type_49;
    var phi_1102_: bool;
    var phi_1103_: u32;
    var phi_2157_: type_42;
    var phi_3013_: type_49;
    var phi_3090_: type_49;
    var phi_3091_: type_49;
    var phi_3092_: u32;
    var phi_3094_: type_49;
    var phi_3095_: u32;
    var phi_3096_: bool;
    var phi_3103_: type_49;
    var phi_3108_: type_49;
    var phi_3109_: bool;
    var phi_1121_: type_38;
    var phi_1124_: type_4;
    var phi_1125_: type_4;
    var phi_1147_: type_4;
    var phi_1171_: u32;
    var phi_1260_: array<array<f32, 3>, 3>;
    var phi_1377_: bool;
    var phi_1406_: bool;
    var phi_1807_: f32;
    var phi_1808_: f32;
    var phi_1809_: f32;
    var phi_1810_: f32;
    var phi_1811_: vec3<f32>;
    var phi_1812_: vec3<f32>;
    var phi_1813_: vec3<f32>;
    var phi_1814_: vec3<f32>;
    var phi_1845_: bool;
    var phi_1854_: vec3<f32>;
    var phi_2019_: f32;
    var phi_2021_: f32;
    var phi_2022_: bool;
    var phi_2042_: f32;
    var phi_2043_: f32;
    var phi_2066_: type_25;
    var phi_2068_: type_25;
    var phi_2069_: bool;
    var phi_2073_: type_25;
    var phi_2074_: type_25;
    var phi_2075_: type_25;
    var phi_2076_: bool;
    var phi_2080_: type_25;
    var phi_2081_: bool;
    var phi_2082_: type_25;
    var phi_2083_: bool;
    var phi_2084_: bool;
    var phi_2085_: type_25;
    var phi_2086_: bool;
    var phi_2087_: bool;
    var phi_2095_: type_25;
    var phi_2096_: bool;
    var phi_2100_: type_25;
    var phi_2125_: bool;
    var phi_2126_: bool;
    var phi_2133_: type_38;
    var phi_2134_: type_38;
    var phi_2135_: type_38;
    var phi_1122_: type_38;
    var phi_3179_: bool;
    var phi_3343_: bool;
    var phi_3111_: type_38;
    var phi_3112_: type_49;
    var phi_3113_: bool;
    var phi_3114_: u32;
    var phi_3342_: bool;
    var phi_3115_: type_38;
    var phi_3116_: type_49;
    var phi_3117_: u32;
    var phi_3118_: bool;
    var phi_3119_: u32;
    var phi_3341_: bool;
    var phi_3120_: type_38;
    var phi_3121_: type_49;
    var phi_3122_: u32;
    var phi_3123_: bool;
    var phi_3124_: u32;
    var phi_3340_: bool;
    var phi_996_: type_38;
    var phi_999_: type_49;
    var phi_1001_: u32;
    var phi_1003_: bool;
    var phi_1005_: u32;
    var phi_3125_: bool;
    var phi_3339_: bool;
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
                            phi_332_ = (bitcast<i32>((_e211 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_332_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e211)), 32u, (_e211 == 0u))));
                        }
                        let _e225 = phi_332_;
                        phi_333_ = _e225;
                    } else {
                        phi_333_ = 0i;
                    }
                    let _e227 = phi_333_;
                    let _e228 = (_e144 == _e183);
                    if _e228 {
                        phi_343_ = true;
                    } else {
                        phi_343_ = (_e151 == _e183);
                    }
                    let _e231 = phi_343_;
                    let _e232 = select(1u, 0u, _e228);
                    if _e231 {
                        let _e233 = (_e232 + 1u);
                        phi_353_ = _e233;
                        phi_354_ = _e233;
                        phi_356_ = select(true, false, (_e233 == 2u));
                    } else {
                        phi_353_ = u32();
                        phi_354_ = 0u;
                        phi_356_ = true;
                    }
                    let _e237 = phi_353_;
                    let _e239 = phi_354_;
                    let _e241 = phi_356_;
                    if _e241 {
                        phi_361_ = (_e239 + 1u);
                    } else {
                        phi_361_ = 0u;
                    }
                    let _e245 = phi_361_;
                    let _e246 = select(_e237, _e239, _e241);
                    let _e247 = select(_e232, select(2u, _e232, _e231), _e241);
                    if (_e122 < -126i) {
                        phi_373_ = -126i;
                    } else {
                        phi_373_ = select(_e122, 127i, (_e122 > 127i));
                    }
                    let _e252 = phi_373_;
                    let _e257 = bitcast<f32>((bitcast<u32>((_e252 + 127i)) << bitcast<u32>(23i)));
                    let _e263 = bitcast<f32>((bitcast<u32>(((_e122 - _e252) + 127i)) << bitcast<u32>(23i)));
                    let _e264 = -(_e227);
                    if (_e264 < -126i) {
                        phi_393_ = -126i;
                    } else {
                        phi_393_ = select(_e264, 127i, (_e264 > 127i));
                    }
                    let _e269 = phi_393_;
                    let _e274 = bitcast<f32>((bitcast<u32>((_e269 + 127i)) << bitcast<u32>(23i)));
                    let _e280 = bitcast<f32>((bitcast<u32>(((_e264 - _e269) + 127i)) << bitcast<u32>(23i)));
                    let _e284 = global_4.member[_e132].member;
                    let _e285 = (_e246 == 0u);
                    if _e285 {
                        phi_411_ = _e284[0];
                    } else {
                        phi_411_ = _e284[1];
                    }
                    let _e289 = phi_411_;
                    let _e290 = (_e246 == 2u);
                    if _e290 {
                        phi_417_ = _e284[2];
                    } else {
                        phi_417_ = _e289;
                    }
                    let _e293 = phi_417_;
                    let _e294 = bitcast<u32>(_e293);
                    let _e296 = ((_e294 & 2139095040u) != 0u);
                    let _e310 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e294 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e294 & 2147483648u))), _e293, _e296) * _e257) * select(0.00000011920929f, 1f, _e296)) * _e263);
                    let _e311 = global_4.member[_e132].member_2;
                    if _e285 {
                        phi_457_ = _e311[0];
                    } else {
                        phi_457_ = _e311[1];
                    }
                    let _e315 = phi_457_;
                    if _e290 {
                        phi_463_ = _e311[2];
                    } else {
                        phi_463_ = _e315;
                    }
                    let _e318 = phi_463_;
                    let _e319 = bitcast<u32>(_e318);
                    let _e321 = ((_e319 & 2139095040u) != 0u);
                    let _e335 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e319 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e319 & 2147483648u))), _e318, _e321) * _e274) * select(0.00000011920929f, 1f, _e321)) * _e280);
                    let _e339 = (bitcast<f32>((bitcast<u32>(_e335) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e339 {
                        let _e343 = (bitcast<f32>((bitcast<u32>(_e310) & 2147483647u)) * 0.00000011920929f);
                        phi_515_ = select(0.00000000000011368684f, _e343, (_e343 > 0.00000000000011368684f));
                    } else {
                        phi_515_ = 0f;
                    }
                    let _e347 = phi_515_;
                    let _e348 = (_e310 + _e347);
                    let _e349 = (_e310 - _e347);
                    let _e350 = select(_e335, 0f, _e339);
                    if _e339 {
                        phi_526_ = 38685626000000000000000000f;
                    } else {
                        phi_526_ = (1f / _e335);
                    }
                    let _e353 = phi_526_;
                    let _e354 = (_e245 == 0u);
                    if _e354 {
                        phi_535_ = _e284[0];
                    } else {
                        phi_535_ = _e284[1];
                    }
                    let _e358 = phi_535_;
                    let _e359 = (_e245 == 2u);
                    if _e359 {
                        phi_541_ = _e284[2];
                    } else {
                        phi_541_ = _e358;
                    }
                    let _e362 = phi_541_;
                    let _e363 = bitcast<u32>(_e362);
                    let _e365 = ((_e363 & 2139095040u) != 0u);
                    let _e379 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e363 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e363 & 2147483648u))), _e362, _e365) * _e257) * select(0.00000011920929f, 1f, _e365)) * _e263);
                    if _e354 {
                        phi_581_ = _e311[0];
                    } else {
                        phi_581_ = _e311[1];
                    }
                    let _e383 = phi_581_;
                    if _e359 {
                        phi_587_ = _e311[2];
                    } else {
                        phi_587_ = _e383;
                    }
                    let _e386 = phi_587_;
                    let _e387 = bitcast<u32>(_e386);
                    let _e389 = ((_e387 & 2139095040u) != 0u);
                    let _e403 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e387 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e387 & 2147483648u))), _e386, _e389) * _e274) * select(0.00000011920929f, 1f, _e389)) * _e280);
                    let _e407 = (bitcast<f32>((bitcast<u32>(_e403) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e407 {
                        let _e411 = (bitcast<f32>((bitcast<u32>(_e379) & 2147483647u)) * 0.00000011920929f);
                        phi_639_ = select(0.00000000000011368684f, _e411, (_e411 > 0.00000000000011368684f));
                    } else {
                        phi_639_ = 0f;
                    }
                    let _e415 = phi_639_;
                    let _e416 = (_e379 + _e415);
                    let _e417 = (_e379 - _e415);
                    let _e418 = select(_e403, 0f, _e407);
                    if _e407 {
                        phi_650_ = 38685626000000000000000000f;
                    } else {
                        phi_650_ = (1f / _e403);
                    }
                    let _e421 = phi_650_;
                    let _e422 = (_e247 == 0u);
                    if _e422 {
                        phi_659_ = _e284[0];
                    } else {
                        phi_659_ = _e284[1];
                    }
                    let _e426 = phi_659_;
                    let _e427 = (_e247 == 2u);
                    if _e427 {
                        phi_665_ = _e284[2];
                    } else {
                        phi_665_ = _e426;
                    }
                    let _e430 = phi_665_;
                    let _e431 = bitcast<u32>(_e430);
                    let _e433 = ((_e431 & 2139095040u) != 0u);
                    let _e447 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e431 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e431 & 2147483648u))), _e430, _e433) * _e257) * select(0.00000011920929f, 1f, _e433)) * _e263);
                    if _e422 {
                        phi_705_ = _e311[0];
                    } else {
                        phi_705_ = _e311[1];
                    }
                    let _e451 = phi_705_;
                    if _e427 {
                        phi_711_ = _e311[2];
                    } else {
                        phi_711_ = _e451;
                    }
                    let _e454 = phi_711_;
                    let _e455 = bitcast<u32>(_e454);
                    let _e457 = ((_e455 & 2139095040u) != 0u);
                    let _e471 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e455 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e455 & 2147483648u))), _e454, _e457) * _e274) * select(0.00000011920929f, 1f, _e457)) * _e280);
                    let _e475 = (bitcast<f32>((bitcast<u32>(_e471) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e475 {
                        let _e479 = (bitcast<f32>((bitcast<u32>(_e447) & 2147483647u)) * 0.00000011920929f);
                        phi_763_ = select(0.00000000000011368684f, _e479, (_e479 > 0.00000000000011368684f));
                    } else {
                        phi_763_ = 0f;
                    }
                    let _e483 = phi_763_;
                    let _e484 = (_e447 + _e483);
                    let _e485 = (_e447 - _e483);
                    let _e486 = select(_e471, 0f, _e475);
                    if _e475 {
                        phi_774_ = 38685626000000000000000000f;
                    } else {
                        phi_774_ = (1f / _e471);
                    }
                    let _e489 = phi_774_;
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
                            phi_829_ = 255i;
                        } else {
                            phi_829_ = (((_e516 + select(0i, 1i, (_e516 == 0i))) - _e523) + _e503);
                        }
                        let _e531 = phi_829_;
                        let _e541 = (_e531 <= 0i);
                        if _e541 {
                            phi_852_ = u32();
                        } else {
                            if _e520 {
                                phi_851_ = u32();
                            } else {
                                phi_851_ = select(((bitcast<u32>(_e531) << bitcast<u32>(23i)) | ((_e513 << bitcast<u32>(((_e523 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e531 >= 255i));
                            }
                            let _e545 = phi_851_;
                            phi_852_ = _e545;
                        }
                        let _e547 = phi_852_;
                        let _e559 = ((_e204 & 8388607u) | (select(0u, 1u, ((_e204 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e562 = bitcast<i32>((_e204 >> bitcast<u32>(23i)));
                        let _e566 = (_e559 == 0u);
                        let _e569 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e559)), 32u, _e566)) - 8i);
                        if (_e562 == 255i) {
                            phi_889_ = 255i;
                        } else {
                            phi_889_ = (((_e562 + select(0i, 1i, (_e562 == 0i))) - _e569) + _e503);
                        }
                        let _e577 = phi_889_;
                        let _e587 = (_e577 <= 0i);
                        if _e587 {
                            phi_912_ = u32();
                        } else {
                            if _e566 {
                                phi_911_ = u32();
                            } else {
                                phi_911_ = select(((bitcast<u32>(_e577) << bitcast<u32>(23i)) | ((_e559 << bitcast<u32>(((_e569 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e577 >= 255i));
                            }
                            let _e591 = phi_911_;
                            phi_912_ = _e591;
                        }
                        let _e593 = phi_912_;
                        phi_920_ = bitcast<f32>(((_e203 & 2147483648u) | select(_e593, 0u, select(_e566, true, _e587))));
                        phi_921_ = bitcast<f32>(((_e194 & 2147483648u) | select(_e547, 0u, select(_e520, true, _e541))));
                    } else {
                        phi_920_ = 0f;
                        phi_921_ = 1f;
                    }
                    let _e599 = phi_920_;
                    let _e601 = phi_921_;
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
                    phi_3185_ = false;
                    phi_995_ = type_38(type_32(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e599), 0u, 0u);
                    phi_998_ = type_49(type_47(array<f32, 3>(_e610, _e614, _e618), array<f32, 3>(_e622, _e624, _e626)), select(0u, 2147483648u, (_e84 == 0u)));
                    phi_1000_ = ((3u * _e84) + 1u);
                    phi_1002_ = (_e601 <= _e599);
                    phi_1004_ = 0u;
                    loop {
                        let _e634 = phi_3185_;
                        let _e636 = phi_995_;
                        let _e638 = phi_998_;
                        let _e640 = phi_1000_;
                        let _e642 = phi_1002_;
                        let _e644 = phi_1004_;
                        local_10 = _e636;
                        local_11 = _e636;
                        if _e642 {
                            phi_1015_ = true;
                        } else {
                            phi_1015_ = (_e644 > 0u);
                        }
                        let _e647 = phi_1015_;
                        if _e647 {
                            let _e648 = (_e640 > 0u);
                            if _e648 {
                                if _e642 {
                                    phi_1101_ = _e638;
                                    phi_1102_ = _e642;
                                    phi_1103_ = _e644;
                                } else {
                                    let _e649 = (_e644 - 1u);
                                    let _e650 = (_e649 % 128u);
                                    let _e651 = (_e650 < 128u);
                                    if _e651 {
                                    } else {
                                        phi_3339_ = true;
                                        break;
                                    }
                                    let _e653 = local_6[_e650];
                                    if _e651 {
                                    } else {
                                        phi_3339_ = true;
                                        break;
                                    }
                                    let _e655 = local_5[_e650];
                                    if _e651 {
                                    } else {
                                        phi_3339_ = true;
                                        break;
                                    }
                                    let _e657 = local_4[_e650];
                                    if _e651 {
                                    } else {
                                        phi_3339_ = true;
                                        break;
                                    }
                                    let _e659 = local_3[_e650];
                                    if _e651 {
                                    } else {
                                        phi_3339_ = true;
                                        break;
                                    }
                                    let _e662 = local_2[_e650];
                                    if _e651 {
                                    } else {
                                        phi_3339_ = true;
                                        break;
                                    }
                                    let _e664 = local_1[_e650];
                                    if _e651 {
                                    } else {
                                        phi_3339_ = true;
                                        break;
                                    }
                                    let _e666 = local[_e650];
                                    if _e651 {
                                    } else {
                                        phi_3339_ = true;
                                        break;
                                    }
                                    let _e671 = local_7[_e650];
                                    phi_1101_ = type_49(type_47(array<f32, 3>(_e655, _e657, _e659), array<f32, 3>(_e662, _e664, _e666)), _e653);
                                    phi_1102_ = (_e671 <= _e636.member.member_1);
                                    phi_1103_ = _e649;
                                }
                                let _e676 = phi_1101_;
                                let _e678 = phi_1102_;
                                let _e680 = phi_1103_;
                                if _e678 {
                                    if ((_e676.member_1 & 2147483648u) != 0u) {
                                        phi_1121_ = _e636;
                                        phi_1124_ = type_4(0u, ((_e676.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1063 = phi_1121_;
                                            let _e1065 = phi_1124_;
                                            local_12 = _e1063;
                                            if (_e1065.member < _e1065.member_1) {
                                                phi_1125_ = type_4((_e1065.member + 1u), _e1065.member_1);
                                                phi_1147_ = type_4(1u, _e1065.member);
                                            } else {
                                                phi_1125_ = _e1065;
                                                phi_1147_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1078 = phi_1125_;
                                            let _e1080 = phi_1147_;
                                            let _e1084 = (bitcast<i32>(_e1080.member) != 0i);
                                            if _e1084 {
                                                let _e1090 = type_38(_e1063.member, _e1063.member_1, (_e1063.member_2 + 1u));
                                                let _e1091 = ((_e676.member_1 & 268435455u) + _e1080.member_1);
                                                let _e1092 = (_e1091 < _e86);
                                                if _e1092 {
                                                    if _e1092 {
                                                    } else {
                                                        phi_3179_ = true;
                                                        break;
                                                    }
                                                    let _e1096 = global_2.member[_e1091].member_1;
                                                    phi_1171_ = _e1096;
                                                } else {
                                                    phi_1171_ = 4294967295u;
                                                }
                                                let _e1098 = phi_1171_;
                                                if (_e1091 >= _e86) {
                                                    phi_1260_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1092 {
                                                    } else {
                                                        phi_3179_ = true;
                                                        break;
                                                    }
                                                    if (_e607 < 9u) {
                                                    } else {
                                                        phi_3179_ = true;
                                                        break;
                                                    }
                                                    let _e1105 = global_2.member[_e1091].member[_e607];
                                                    if (_e611 < 9u) {
                                                    } else {
                                                        phi_3179_ = true;
                                                        break;
                                                    }
                                                    let _e1111 = global_2.member[_e1091].member[_e611];
                                                    if (_e615 < 9u) {
                                                    } else {
                                                        phi_3179_ = true;
                                                        break;
                                                    }
                                                    let _e1117 = global_2.member[_e1091].member[_e615];
                                                    let _e1119 = (3u + _e607);
                                                    if (_e1119 < 9u) {
                                                    } else {
                                                        phi_3179_ = true;
                                                        break;
                                                    }
                                                    let _e1125 = global_2.member[_e1091].member[_e1119];
                                                    let _e1126 = (3u + _e611);
                                                    if (_e1126 < 9u) {
                                                    } else {
                                                        phi_3179_ = true;
                                                        break;
                                                    }
                                                    let _e1132 = global_2.member[_e1091].member[_e1126];
                                                    let _e1133 = (3u + _e615);
                                                    if (_e1133 < 9u) {
                                                    } else {
                                                        phi_3179_ = true;
                                                        break;
                                                    }
                                                    let _e1139 = global_2.member[_e1091].member[_e1133];
                                                    let _e1141 = (6u + _e607);
                                                    if (_e1141 < 9u) {
                                                    } else {
                                                        phi_3179_ = true;
                                                        break;
                                                    }
                                                    let _e1147 = global_2.member[_e1091].member[_e1141];
                                                    let _e1148 = (6u + _e611);
                                                    if (_e1148 < 9u) {
                                                    } else {
                                                        phi_3179_ = true;
                                                        break;
                                                    }
                                                    let _e1154 = global_2.member[_e1091].member[_e1148];
                                                    let _e1155 = (6u + _e615);
                                                    if (_e1155 < 9u) {
                                                    } else {
                                                        phi_3179_ = true;
                                                        break;
                                                    }
                                                    let _e1161 = global_2.member[_e1091].member[_e1155];
                                                    phi_1260_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1105, _e1111, _e1117), array<f32, 3>(_e1125, _e1132, _e1139), array<f32, 3>(_e1147, _e1154, _e1161));
                                                }
                                                let _e1165 = phi_1260_;
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
                                                        phi_2085_ = type_25();
                                                        phi_2086_ = true;
                                                        phi_2087_ = false;
                                                    } else {
                                                        let _e1241 = select(_e1190, _e1177, (_e1177 < _e1190));
                                                        if (select(_e1203, _e1241, (_e1241 < _e1203)) > 0f) {
                                                            phi_1377_ = true;
                                                        } else {
                                                            let _e1246 = select(_e1190, _e1177, (_e1177 > _e1190));
                                                            phi_1377_ = (select(_e1203, _e1246, (_e1246 > _e1203)) < 0f);
                                                        }
                                                        let _e1251 = phi_1377_;
                                                        if _e1251 {
                                                            phi_2082_ = type_25();
                                                            phi_2083_ = true;
                                                            phi_2084_ = false;
                                                        } else {
                                                            let _e1253 = select(_e1193, _e1180, (_e1180 < _e1193));
                                                            if (select(_e1206, _e1253, (_e1253 < _e1206)) > 0f) {
                                                                phi_1406_ = true;
                                                            } else {
                                                                let _e1258 = select(_e1193, _e1180, (_e1180 > _e1193));
                                                                phi_1406_ = (select(_e1206, _e1258, (_e1258 > _e1206)) < 0f);
                                                            }
                                                            let _e1263 = phi_1406_;
                                                            if _e1263 {
                                                                phi_2080_ = type_25();
                                                                phi_2081_ = false;
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
                                                                    phi_2075_ = type_25();
                                                                    phi_2076_ = true;
                                                                } else {
                                                                    let _e1328 = (_e1326 > _e1063.member.member_1);
                                                                    if _e1328 {
                                                                        phi_2074_ = type_25();
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
                                                                            phi_1807_ = _e1193;
                                                                            phi_1808_ = _e1190;
                                                                            phi_1809_ = _e1180;
                                                                            phi_1810_ = _e1177;
                                                                            phi_1811_ = _e1329;
                                                                            phi_1812_ = _e1343;
                                                                            phi_1813_ = _e1339;
                                                                            phi_1814_ = _e1335;
                                                                        } else {
                                                                            let _e1388 = (_e1369 == _e1386);
                                                                            let _e1393 = vec3(_e1388);
                                                                            phi_1807_ = select(_e1180, _e1206, _e1388);
                                                                            phi_1808_ = select(_e1177, _e1203, _e1388);
                                                                            phi_1809_ = select(_e1206, _e1193, _e1388);
                                                                            phi_1810_ = select(_e1203, _e1190, _e1388);
                                                                            phi_1811_ = select(_e1331, _e1330, _e1393);
                                                                            phi_1812_ = select(_e1339, _e1335, _e1393);
                                                                            phi_1813_ = select(_e1335, _e1343, _e1393);
                                                                            phi_1814_ = select(_e1343, _e1339, _e1393);
                                                                        }
                                                                        let _e1399 = phi_1807_;
                                                                        let _e1401 = phi_1808_;
                                                                        let _e1403 = phi_1809_;
                                                                        let _e1405 = phi_1810_;
                                                                        let _e1407 = phi_1811_;
                                                                        let _e1409 = phi_1812_;
                                                                        let _e1411 = phi_1813_;
                                                                        let _e1413 = phi_1814_;
                                                                        let _e1420 = ((_e1411.y * _e1409.z) - (_e1409.y * _e1411.z));
                                                                        let _e1425 = ((_e1411.z * _e1409.x) - (_e1409.z * _e1411.x));
                                                                        let _e1428 = ((_e1411.x * _e1409.y) - (_e1409.x * _e1411.y));
                                                                        if (_e1228 >= _e1232) {
                                                                            phi_1845_ = select(true, false, (_e1228 >= _e1236));
                                                                        } else {
                                                                            phi_1845_ = true;
                                                                        }
                                                                        let _e1433 = phi_1845_;
                                                                        if _e1433 {
                                                                            phi_1854_ = select(_e1331, _e1330, vec3((_e1232 >= _e1236)));
                                                                        } else {
                                                                            phi_1854_ = _e1329;
                                                                        }
                                                                        let _e1438 = phi_1854_;
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
                                                                                phi_2019_ = (_e1449 / _e1454);
                                                                            } else {
                                                                                phi_2019_ = f32();
                                                                            }
                                                                            let _e1559 = phi_2019_;
                                                                            phi_2021_ = _e1559;
                                                                            phi_2022_ = select(true, false, _e1556);
                                                                        } else {
                                                                            phi_2021_ = f32();
                                                                            phi_2022_ = true;
                                                                        }
                                                                        let _e1562 = phi_2021_;
                                                                        let _e1564 = phi_2022_;
                                                                        if _e1564 {
                                                                            let _e1572 = (((_e1420 * (_e1481 - (_e350 * _e1484))) + (_e1425 * (_e1482 - (_e418 * _e1484)))) / _e1454);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1572) & 2147483647u)) <= _e1386) {
                                                                                phi_2042_ = (_e1484 + _e1572);
                                                                            } else {
                                                                                phi_2042_ = _e1484;
                                                                            }
                                                                            let _e1579 = phi_2042_;
                                                                            phi_2043_ = _e1579;
                                                                        } else {
                                                                            phi_2043_ = _e1562;
                                                                        }
                                                                        let _e1581 = phi_2043_;
                                                                        let _e1583 = select(_e1319, _e1581, (_e1581 < _e1319));
                                                                        let _e1585 = select(_e1311, _e1583, (_e1583 > _e1311));
                                                                        if (_e1585 >= _e601) {
                                                                            let _e1587 = (_e1585 <= _e1063.member.member_1);
                                                                            if _e1587 {
                                                                                let _e1588 = (1f / _e1238);
                                                                                phi_2066_ = type_25(_e1585, (_e1232 * _e1588), (_e1236 * _e1588), _e1098);
                                                                            } else {
                                                                                phi_2066_ = type_25();
                                                                            }
                                                                            let _e1593 = phi_2066_;
                                                                            phi_2068_ = _e1593;
                                                                            phi_2069_ = select(true, false, _e1587);
                                                                        } else {
                                                                            phi_2068_ = type_25();
                                                                            phi_2069_ = true;
                                                                        }
                                                                        let _e1596 = phi_2068_;
                                                                        let _e1598 = phi_2069_;
                                                                        if _e1598 {
                                                                            phi_2073_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2073_ = _e1596;
                                                                        }
                                                                        let _e1600 = phi_2073_;
                                                                        phi_2074_ = _e1600;
                                                                    }
                                                                    let _e1602 = phi_2074_;
                                                                    phi_2075_ = _e1602;
                                                                    phi_2076_ = _e1328;
                                                                }
                                                                let _e1604 = phi_2075_;
                                                                let _e1606 = phi_2076_;
                                                                phi_2080_ = _e1604;
                                                                phi_2081_ = _e1606;
                                                            }
                                                            let _e1608 = phi_2080_;
                                                            let _e1610 = phi_2081_;
                                                            phi_2082_ = _e1608;
                                                            phi_2083_ = _e1263;
                                                            phi_2084_ = _e1610;
                                                        }
                                                        let _e1612 = phi_2082_;
                                                        let _e1614 = phi_2083_;
                                                        let _e1616 = phi_2084_;
                                                        phi_2085_ = _e1612;
                                                        phi_2086_ = _e1614;
                                                        phi_2087_ = _e1616;
                                                    }
                                                    let _e1618 = phi_2085_;
                                                    let _e1620 = phi_2086_;
                                                    let _e1622 = phi_2087_;
                                                    phi_2095_ = _e1618;
                                                    phi_2096_ = select(_e1622, true, _e1620);
                                                } else {
                                                    phi_2095_ = type_25();
                                                    phi_2096_ = true;
                                                }
                                                let _e1625 = phi_2095_;
                                                let _e1627 = phi_2096_;
                                                if _e1627 {
                                                    phi_2100_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2100_ = _e1625;
                                                }
                                                let _e1629 = phi_2100_;
                                                if (_e1629.member_3 != 4294967295u) {
                                                    if (_e1098 != 4294967295u) {
                                                        if (_e1629.member < _e1063.member.member.member) {
                                                            phi_2126_ = true;
                                                        } else {
                                                            if (_e1629.member == _e1063.member.member.member) {
                                                                phi_2125_ = (_e1629.member_3 < _e1063.member.member.member_3);
                                                            } else {
                                                                phi_2125_ = false;
                                                            }
                                                            let _e1644 = phi_2125_;
                                                            phi_2126_ = _e1644;
                                                        }
                                                        let _e1646 = phi_2126_;
                                                        if _e1646 {
                                                            phi_2133_ = type_38(type_32(_e1629, _e1629.member), _e1090.member_1, _e1090.member_2);
                                                        } else {
                                                            phi_2133_ = _e1090;
                                                        }
                                                        let _e1653 = phi_2133_;
                                                        phi_2134_ = _e1653;
                                                    } else {
                                                        phi_2134_ = _e1090;
                                                    }
                                                    let _e1655 = phi_2134_;
                                                    phi_2135_ = _e1655;
                                                } else {
                                                    phi_2135_ = _e1090;
                                                }
                                                let _e1657 = phi_2135_;
                                                phi_1122_ = _e1657;
                                            } else {
                                                phi_1122_ = type_38();
                                            }
                                            let _e1659 = phi_1122_;
                                            continue;
                                            continuing {
                                                phi_1121_ = _e1659;
                                                phi_1124_ = _e1078;
                                                phi_3179_ = _e634;
                                                break if !(_e1084);
                                            }
                                        }
                                        let _e1662 = phi_3179_;
                                        phi_3339_ = _e1662;
                                        if _e1662 {
                                            break;
                                        }
                                        phi_3343_ = _e1662;
                                        let _e1833 = local_12;
                                        phi_3111_ = _e1833;
                                        phi_3112_ = _e676;
                                        phi_3113_ = false;
                                        phi_3114_ = _e680;
                                    } else {
                                        let _e695 = (_e676.member_1 < _e84);
                                        if _e695 {
                                            if _e695 {
                                            } else {
                                                phi_3339_ = true;
                                                break;
                                            }
                                            let _e697 = global_5.member[_e676.member_1];
                                            phi_2157_ = _e697;
                                        } else {
                                            phi_2157_ = type_42(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e699 = phi_2157_;
                                        let _e714 = ((10u * _e246) & 31u);
                                        let _e717 = ((_e699.member[0] >> bitcast<u32>(_e714)) & 1023u);
                                        let _e725 = bitcast<f32>((bitcast<u32>(((_e676.member.member_1[0] - _e676.member.member[0]) * 0.0009775171f)) ^ _e118));
                                        let _e730 = (_e676.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e717)) - 8388608f) * _e725)) ^ _e118)));
                                        let _e734 = select(select(_e676.member.member_1[0], _e730, (_e730 < _e676.member.member_1[0])), _e676.member.member_1[0], (_e717 == 1023u));
                                        let _e736 = ((10u * _e245) & 31u);
                                        let _e739 = ((_e699.member[0] >> bitcast<u32>(_e736)) & 1023u);
                                        let _e747 = bitcast<f32>((bitcast<u32>(((_e676.member.member_1[1] - _e676.member.member[1]) * 0.0009775171f)) ^ _e118));
                                        let _e752 = (_e676.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e739)) - 8388608f) * _e747)) ^ _e118)));
                                        let _e756 = select(select(_e676.member.member_1[1], _e752, (_e752 < _e676.member.member_1[1])), _e676.member.member_1[1], (_e739 == 1023u));
                                        let _e758 = ((10u * _e247) & 31u);
                                        let _e761 = ((_e699.member[0] >> bitcast<u32>(_e758)) & 1023u);
                                        let _e769 = bitcast<f32>((bitcast<u32>(((_e676.member.member_1[2] - _e676.member.member[2]) * 0.0009775171f)) ^ _e118));
                                        let _e774 = (_e676.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e761)) - 8388608f) * _e769)) ^ _e118)));
                                        let _e778 = select(select(_e676.member.member_1[2], _e774, (_e774 < _e676.member.member_1[2])), _e676.member.member_1[2], (_e761 == 1023u));
                                        let _e781 = ((_e699.member[1] >> bitcast<u32>(_e714)) & 1023u);
                                        let _e789 = (_e676.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e781)) - 8388608f) * _e725)) ^ _e118)));
                                        let _e793 = select(select(_e676.member.member_1[0], _e789, (_e789 < _e676.member.member_1[0])), _e676.member.member_1[0], (_e781 == 1023u));
                                        let _e796 = ((_e699.member[1] >> bitcast<u32>(_e736)) & 1023u);
                                        let _e804 = (_e676.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e796)) - 8388608f) * _e747)) ^ _e118)));
                                        let _e808 = select(select(_e676.member.member_1[1], _e804, (_e804 < _e676.member.member_1[1])), _e676.member.member_1[1], (_e796 == 1023u));
                                        let _e811 = ((_e699.member[1] >> bitcast<u32>(_e758)) & 1023u);
                                        let _e819 = (_e676.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e811)) - 8388608f) * _e769)) ^ _e118)));
                                        let _e823 = select(select(_e676.member.member_1[2], _e819, (_e819 < _e676.member.member_1[2])), _e676.member.member_1[2], (_e811 == 1023u));
                                        let _e829 = ((_e699.member_1[0] >> bitcast<u32>(_e714)) & 1023u);
                                        let _e837 = (_e676.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e829)) - 8388608f) * _e725)) ^ _e118)));
                                        let _e841 = select(select(_e676.member.member_1[0], _e837, (_e837 < _e676.member.member_1[0])), _e676.member.member_1[0], (_e829 == 1023u));
                                        let _e844 = ((_e699.member_1[0] >> bitcast<u32>(_e736)) & 1023u);
                                        let _e852 = (_e676.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e844)) - 8388608f) * _e747)) ^ _e118)));
                                        let _e856 = select(select(_e676.member.member_1[1], _e852, (_e852 < _e676.member.member_1[1])), _e676.member.member_1[1], (_e844 == 1023u));
                                        let _e859 = ((_e699.member_1[0] >> bitcast<u32>(_e758)) & 1023u);
                                        let _e867 = (_e676.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e859)) - 8388608f) * _e769)) ^ _e118)));
                                        let _e871 = select(select(_e676.member.member_1[2], _e867, (_e867 < _e676.member.member_1[2])), _e676.member.member_1[2], (_e859 == 1023u));
                                        let _e874 = ((_e699.member_1[1] >> bitcast<u32>(_e714)) & 1023u);
                                        let _e882 = (_e676.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e874)) - 8388608f) * _e725)) ^ _e118)));
                                        let _e886 = select(select(_e676.member.member_1[0], _e882, (_e882 < _e676.member.member_1[0])), _e676.member.member_1[0], (_e874 == 1023u));
                                        let _e889 = ((_e699.member_1[1] >> bitcast<u32>(_e736)) & 1023u);
                                        let _e897 = (_e676.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e889)) - 8388608f) * _e747)) ^ _e118)));
                                        let _e901 = select(select(_e676.member.member_1[1], _e897, (_e897 < _e676.member.member_1[1])), _e676.member.member_1[1], (_e889 == 1023u));
                                        let _e904 = ((_e699.member_1[1] >> bitcast<u32>(_e758)) & 1023u);
                                        let _e912 = (_e676.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e904)) - 8388608f) * _e769)) ^ _e118)));
                                        let _e916 = select(select(_e676.member.member_1[2], _e912, (_e912 < _e676.member.member_1[2])), _e676.member.member_1[2], (_e904 == 1023u));
                                        let _e921 = type_49(type_47(array<f32, 3>(_e734, _e756, _e778), array<f32, 3>(_e793, _e808, _e823)), _e699.member_2);
                                        let _e926 = type_49(type_47(array<f32, 3>(_e841, _e856, _e871), array<f32, 3>(_e886, _e901, _e916)), _e699.member_3);
                                        let _e933 = ((_e734 - _e348) * _e353);
                                        let _e934 = ((_e841 - _e348) * _e353);
                                        let _e935 = ((_e793 - _e349) * _e353);
                                        let _e936 = ((_e886 - _e349) * _e353);
                                        let _e941 = ((_e756 - _e416) * _e421);
                                        let _e942 = ((_e856 - _e416) * _e421);
                                        let _e943 = ((_e808 - _e417) * _e421);
                                        let _e944 = ((_e901 - _e417) * _e421);
                                        let _e949 = ((_e778 - _e484) * _e489);
                                        let _e950 = ((_e871 - _e484) * _e489);
                                        let _e951 = ((_e823 - _e485) * _e489);
                                        let _e952 = ((_e916 - _e485) * _e489);
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
                                                    phi_3013_ = _e926;
                                                } else {
                                                    phi_3013_ = _e921;
                                                }
                                                let _e1015 = phi_3013_;
                                                let _e1023 = (_e680 % 128u);
                                                let _e1024 = (_e1023 < 128u);
                                                if _e1024 {
                                                } else {
                                                    phi_3339_ = true;
                                                    break;
                                                }
                                                local_6[_e1023] = _e1015.member_1;
                                                if _e1024 {
                                                } else {
                                                    phi_3339_ = true;
                                                    break;
                                                }
                                                local_5[_e1023] = _e1015.member.member[0];
                                                if _e1024 {
                                                } else {
                                                    phi_3339_ = true;
                                                    break;
                                                }
                                                local_4[_e1023] = _e1015.member.member[1];
                                                if _e1024 {
                                                } else {
                                                    phi_3339_ = true;
                                                    break;
                                                }
                                                local_3[_e1023] = _e1015.member.member[2];
                                                if _e1024 {
                                                } else {
                                                    phi_3339_ = true;
                                                    break;
                                                }
                                                local_2[_e1023] = _e1015.member.member_1[0];
                                                if _e1024 {
                                                } else {
                                                    phi_3339_ = true;
                                                    break;
                                                }
                                                local_1[_e1023] = _e1015.member.member_1[1];
                                                if _e1024 {
                                                } else {
                                                    phi_3339_ = true;
                                                    break;
                                                }
                                                local[_e1023] = _e1015.member.member_1[2];
                                                if _e1024 {
                                                } else {
                                                    phi_3339_ = true;
                                                    break;
                                                }
                                                local_7[_e1023] = select(_e1006, _e1004, (_e1004 > _e1006));
                                                if _e1013 {
                                                    phi_3090_ = _e921;
                                                } else {
                                                    phi_3090_ = _e926;
                                                }
                                                let _e1041 = phi_3090_;
                                                phi_3091_ = _e1041;
                                                phi_3092_ = (_e680 + 1u);
                                            } else {
                                                phi_3091_ = type_49();
                                                phi_3092_ = u32();
                                            }
                                            let _e1043 = phi_3091_;
                                            let _e1045 = phi_3092_;
                                            phi_3094_ = _e1043;
                                            phi_3095_ = _e1045;
                                            phi_3096_ = select(true, false, _e1012);
                                        } else {
                                            phi_3094_ = type_49();
                                            phi_3095_ = u32();
                                            phi_3096_ = true;
                                        }
                                        let _e1048 = phi_3094_;
                                        let _e1050 = phi_3095_;
                                        let _e1052 = phi_3096_;
                                        if _e1052 {
                                            if _e1011 {
                                                phi_3103_ = _e921;
                                            } else {
                                                phi_3103_ = _e926;
                                            }
                                            let _e1054 = phi_3103_;
                                            phi_3108_ = _e1054;
                                            phi_3109_ = select(_e1012, true, _e1011);
                                        } else {
                                            phi_3108_ = _e1048;
                                            phi_3109_ = _e678;
                                        }
                                        let _e1057 = phi_3108_;
                                        let _e1059 = phi_3109_;
                                        phi_3343_ = _e634;
                                        phi_3111_ = type_38(_e636.member, (_e636.member_1 + 1u), _e636.member_2);
                                        phi_3112_ = _e1057;
                                        phi_3113_ = _e1059;
                                        phi_3114_ = select(_e1050, _e680, _e1052);
                                    }
                                    let _e1664 = phi_3343_;
                                    let _e1666 = phi_3111_;
                                    let _e1668 = phi_3112_;
                                    let _e1670 = phi_3113_;
                                    let _e1672 = phi_3114_;
                                    phi_3342_ = _e1664;
                                    phi_3115_ = _e1666;
                                    phi_3116_ = _e1668;
                                    phi_3117_ = (_e640 - 1u);
                                    phi_3118_ = _e1670;
                                    phi_3119_ = _e1672;
                                } else {
                                    phi_3342_ = _e634;
                                    phi_3115_ = _e636;
                                    phi_3116_ = _e676;
                                    phi_3117_ = _e640;
                                    phi_3118_ = _e678;
                                    phi_3119_ = _e680;
                                }
                                let _e1674 = phi_3342_;
                                let _e1676 = phi_3115_;
                                let _e1678 = phi_3116_;
                                let _e1680 = phi_3117_;
                                let _e1682 = phi_3118_;
                                let _e1684 = phi_3119_;
                                phi_3341_ = _e1674;
                                phi_3120_ = _e1676;
                                phi_3121_ = _e1678;
                                phi_3122_ = _e1680;
                                phi_3123_ = _e1682;
                                phi_3124_ = _e1684;
                            } else {
                                phi_3341_ = _e634;
                                phi_3120_ = type_38();
                                phi_3121_ = type_49();
                                phi_3122_ = u32();
                                phi_3123_ = bool();
                                phi_3124_ = u32();
                            }
                            let _e1686 = phi_3341_;
                            let _e1688 = phi_3120_;
                            let _e1690 = phi_3121_;
                            let _e1692 = phi_3122_;
                            let _e1694 = phi_3123_;
                            let _e1696 = phi_3124_;
                            phi_3340_ = _e1686;
                            phi_996_ = _e1688;
                            phi_999_ = _e1690;
                            phi_1001_ = _e1692;
                            phi_1003_ = _e1694;
                            phi_1005_ = _e1696;
                            phi_3125_ = _e648;
                        } else {
                            phi_3340_ = _e634;
                            phi_996_ = type_38();
                            phi_999_ = type_49();
                            phi_1001_ = u32();
                            phi_1003_ = bool();
                            phi_1005_ = u32();
                            phi_3125_ = false;
                        }
                        let _e1698 = phi_3340_;
                        let _e1700 = phi_996_;
                        let _e1702 = phi_999_;
                        let _e1704 = phi_1001_;
                        let _e1706 = phi_1003_;
                        let _e1708 = phi_1005_;
                        let _e1710 = phi_3125_;
                        continue;
                        continuing {
                            phi_3185_ = _e1698;
                            phi_995_ = _e1700;
                            phi_998_ = _e1702;
                            phi_1000_ = _e1704;
                            phi_1002_ = _e1706;
                            phi_1004_ = _e1708;
                            phi_3339_ = _e1698;
                            break if !(_e1710);
                        }
                    }
                    let _e1713 = phi_3339_;
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
