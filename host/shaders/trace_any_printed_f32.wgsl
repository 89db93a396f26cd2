struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_11 {
    member: vec4<u32>,
}

struct type_16 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_18 {
    member: array<type_16>,
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

struct type_35 {
    member: array<type_26>,
}

struct type_37 {
    member: f32,
    member_1: bool,
}

struct type_39 {
    member: array<vec4<u32>, 2>,
}

struct type_41 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_43 {
    member: array<type_41>,
}

struct type_46 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_48 {
    member: type_46,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_11;
@group(0) @binding(3) 
var<storage> global_2: type_18;
@group(0) @binding(1) 
var<uniform> global_3: type_39;
@group(0) @binding(4) 
var<storage> global_4: type_35;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_4;
@group(0) @binding(2) 
var<storage> global_6: type_43;

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
    var phi_340_: i32;
    var phi_341_: i32;
    var phi_351_: bool;
    var phi_361_: u32;
    var phi_362_: u32;
    var phi_364_: bool;
    var phi_369_: u32;
    var phi_382_: i32;
    var phi_402_: i32;
    var phi_420_: f32;
    var phi_426_: f32;
    var phi_466_: f32;
    var phi_472_: f32;
    var phi_524_: f32;
    var phi_536_: f32;
    var phi_545_: f32;
    var phi_551_: f32;
    var phi_591_: f32;
    var phi_597_: f32;
    var phi_649_: f32;
    var phi_661_: f32;
    var phi_670_: f32;
    var phi_676_: f32;
    var phi_716_: f32;
    var phi_722_: f32;
    var phi_774_: f32;
    var phi_786_: f32;
    var phi_841_: i32;
    var phi_863_: u32;
    var phi_864_: u32;
    var phi_901_: i32;
    var phi_923_: u32;
    var phi_924_: u32;
    var phi_932_: f32;
    var phi_933_: f32;
    var phi_3279_: bool;
    var phi_1016_: type_37;
    var phi_1019_: bool;
    var phi_1021_: u32;
    var phi_1023_: u32;
    var phi_1025_: type_48;
    var phi_1036_: bool;
    var phi_1122_: bool;
    var phi_1123_: u32;
    var phi_1124_: type_48;
    var phi_2220_: type_41;
    var phi_3106_: type_48;
    var phi_3183_: type_48;
    var phi_3184_: u32;
    var phi_3185_: type_48;
    var phi_3187_: u32;
    var phi_3188_: type_48;
    var phi_3189_: bool;
    var phi_3196_: type_48;
    var phi_3201_: bool;
    var phi_3203_: type_48;
    var phi_1142_: type_37;
    var phi_1145_: type_7;
    var phi_1146_: type_7;
    var phi_1168_: type_7;
    var phi_1189_: u32;
    var phi_1281_: array<array<f32, 3>, 3>;
    var phi_1433_: bool;
    var phi_1462_: bool;
    var phi_1881_: f32;
    var phi_1882_: f32;
    var phi_1883_: f32;
    var phi_1884_: f32;
    var phi_1885_: vec3<f32>;
    var phi_1886_: vec3<f32>;
    var phi_1887_: vec3<f32>;
    var phi_1888_: vec3<f32>;
    var phi_1925_: bool;
    var phi_1934_: vec3<f32>;
    var phi_2099_: f32;
    var phi_2101_: f32;
    var phi_2102_: bool;
    var phi_2122_: f32;
    var phi_2123_: f32;
    var phi_2146_: type_25;
    var phi_2148_: type_25;
    var phi_2149_: bool;
    var phi_2153_: type_25;
    var phi_2154_: type_25;
    var phi_2155_: type_25;
    var phi_2156_: bool;
    var phi_2160_: type_25;
    var phi_2161_: bool;
    var phi_2162_: type_25;
    var phi_2163_: bool;
    var phi_2164_: bool;
    var phi_2165_: type_25;
    var phi_2166_: bool;
    var phi_2167_: bool;
    var phi_2175_: type_25;
    var phi_2176_: bool;
    var phi_2180_: type_25;
    var phi_2191_: type_37;
    var phi_2192_: type_37;
    var phi_1143_: type_37;
    var phi_3273_: bool;
    var local_10: type_37;
    var phi_3434_: bool;
    var phi_3207_: type_37;
    var phi_3208_: bool;
    var phi_3209_: u32;
    var phi_3210_: type_48;
    var phi_3433_: bool;
    var phi_3211_: type_37;
    var phi_3212_: bool;
    var phi_3213_: u32;
    var phi_3214_: u32;
    var phi_3215_: type_48;
    var phi_3432_: bool;
    var phi_3216_: type_37;
    var phi_3217_: bool;
    var phi_3218_: u32;
    var phi_3219_: u32;
    var phi_3220_: type_48;
    var phi_3431_: bool;
    var phi_1017_: type_37;
    var phi_1020_: bool;
    var phi_1022_: u32;
    var phi_1024_: u32;
    var phi_1026_: type_48;
    var phi_3221_: bool;
    var phi_3430_: bool;
    var local_11: type_37;
    var local_12: type_37;

    switch bitcast<i32>(0u) {
        default: {
            let _e81 = global;
            let _e84 = arrayLength((&global_6.member));
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
                let _e134 = (_e132 < arrayLength((&global_5.member)));
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
                            phi_340_ = (bitcast<i32>((_e211 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_340_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e211)), 32u, (_e211 == 0u))));
                        }
                        let _e225 = phi_340_;
                        phi_341_ = _e225;
                    } else {
                        phi_341_ = 0i;
                    }
                    let _e227 = phi_341_;
                    let _e228 = (_e144 == _e183);
                    if _e228 {
                        phi_351_ = true;
                    } else {
                        phi_351_ = (_e151 == _e183);
                    }
                    let _e231 = phi_351_;
                    let _e232 = select(1u, 0u, _e228);
                    if _e231 {
                        let _e233 = (_e232 + 1u);
                        phi_361_ = _e233;
                        phi_362_ = _e233;
                        phi_364_ = select(true, false, (_e233 == 2u));
                    } else {
                        phi_361_ = u32();
                        phi_362_ = 0u;
                        phi_364_ = true;
                    }
                    let _e237 = phi_361_;
                    let _e239 = phi_362_;
                    let _e241 = phi_364_;
                    if _e241 {
                        phi_369_ = (_e239 + 1u);
                    } else {
                        phi_369_ = 0u;
                    }
                    let _e245 = phi_369_;
                    let _e246 = select(_e237, _e239, _e241);
                    let _e247 = select(_e232, select(2u, _e232, _e231), _e241);
                    if (_e122 < -126i) {
                        phi_382_ = -126i;
                    } else {
                        phi_382_ = select(_e122, 127i, (_e122 > 127i));
                    }
                    let _e252 = phi_382_;
                    let _e257 = bitcast<f32>((bitcast<u32>((_e252 + 127i)) << bitcast<u32>(23i)));
                    let _e263 = bitcast<f32>((bitcast<u32>(((_e122 - _e252) + 127i)) << bitcast<u32>(23i)));
                    let _e264 = -(_e227);
                    if (_e264 < -126i) {
                        phi_402_ = -126i;
                    } else {
                        phi_402_ = select(_e264, 127i, (_e264 > 127i));
                    }
                    let _e269 = phi_402_;
                    let _e274 = bitcast<f32>((bitcast<u32>((_e269 + 127i)) << bitcast<u32>(23i)));
                    let _e280 = bitcast<f32>((bitcast<u32>(((_e264 - _e269) + 127i)) << bitcast<u32>(23i)));
                    let _e284 = global_4.member[_e132].member;
                    let _e285 = (_e246 == 0u);
                    if _e285 {
                        phi_420_ = _e284[0];
                    } else {
                        phi_420_ = _e284[1];
                    }
                    let _e289 = phi_420_;
                    let _e290 = (_e246 == 2u);
                    if _e290 {
                        phi_426_ = _e284[2];
                    } else {
                        phi_426_ = _e289;
                    }
                    let _e293 = phi_426_;
                    let _e294 = bitcast<u32>(_e293);
                    let _e296 = ((_e294 & 2139095040u) != 0u);
                    let _e310 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e294 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e294 & 2147483648u))), _e293, _e296) * _e257) * select(0.00000011920929f, 1f, _e296)) * _e263);
                    let _e311 = global_4.member[_e132].member_2;
                    if _e285 {
                        phi_466_ = _e311[0];
                    } else {
                        phi_466_ = _e311[1];
                    }
                    let _e315 = phi_466_;
                    if _e290 {
                        phi_472_ = _e311[2];
                    } else {
                        phi_472_ = _e315;
                    }
                    let _e318 = phi_472_;
                    let _e319 = bitcast<u32>(_e318);
                    let _e321 = ((_e319 & 2139095040u) != 0u);
                    let _e335 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e319 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e319 & 2147483648u))), _e318, _e321) * _e274) * select(0.00000011920929f, 1f, _e321)) * _e280);
                    let _e339 = (bitcast<f32>((bitcast<u32>(_e335) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e339 {
                        let _e343 = (bitcast<f32>((bitcast<u32>(_e310) & 2147483647u)) * 0.00000011920929f);
                        phi_524_ = select(0.00000000000011368684f, _e343, (_e343 > 0.00000000000011368684f));
                    } else {
                        phi_524_ = 0f;
                    }
                    let _e347 = phi_524_;
                    let _e348 = (_e310 + _e347);
                    let _e349 = (_e310 - _e347);
                    let _e350 = select(_e335, 0f, _e339);
                    if _e339 {
                        phi_536_ = 38685626000000000000000000f;
                    } else {
                        phi_536_ = (1f / _e335);
                    }
                    let _e353 = phi_536_;
                    let _e354 = (_e245 == 0u);
                    if _e354 {
                        phi_545_ = _e284[0];
                    } else {
                        phi_545_ = _e284[1];
                    }
                    let _e358 = phi_545_;
                    let _e359 = (_e245 == 2u);
                    if _e359 {
                        phi_551_ = _e284[2];
                    } else {
                        phi_551_ = _e358;
                    }
                    let _e362 = phi_551_;
                    let _e363 = bitcast<u32>(_e362);
                    let _e365 = ((_e363 & 2139095040u) != 0u);
                    let _e379 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e363 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e363 & 2147483648u))), _e362, _e365) * _e257) * select(0.00000011920929f, 1f, _e365)) * _e263);
                    if _e354 {
                        phi_591_ = _e311[0];
                    } else {
                        phi_591_ = _e311[1];
                    }
                    let _e383 = phi_591_;
                    if _e359 {
                        phi_597_ = _e311[2];
                    } else {
                        phi_597_ = _e383;
                    }
                    let _e386 = phi_597_;
                    let _e387 = bitcast<u32>(_e386);
                    let _e389 = ((_e387 & 2139095040u) != 0u);
                    let _e403 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e387 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e387 & 2147483648u))), _e386, _e389) * _e274) * select(0.00000011920929f, 1f, _e389)) * _e280);
                    let _e407 = (bitcast<f32>((bitcast<u32>(_e403) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e407 {
                        let _e411 = (bitcast<f32>((bitcast<u32>(_e379) & 2147483647u)) * 0.00000011920929f);
                        phi_649_ = select(0.00000000000011368684f, _e411, (_e411 > 0.00000000000011368684f));
                    } else {
                        phi_649_ = 0f;
                    }
                    let _e415 = phi_649_;
                    let _e416 = (_e379 + _e415);
                    let _e417 = (_e379 - _e415);
                    let _e418 = select(_e403, 0f, _e407);
                    if _e407 {
                        phi_661_ = 38685626000000000000000000f;
                    } else {
                        phi_661_ = (1f / _e403);
                    }
                    let _e421 = phi_661_;
                    let _e422 = (_e247 == 0u);
                    if _e422 {
                        phi_670_ = _e284[0];
                    } else {
                        phi_670_ = _e284[1];
                    }
                    let _e426 = phi_670_;
                    let _e427 = (_e247 == 2u);
                    if _e427 {
                        phi_676_ = _e284[2];
                    } else {
                        phi_676_ = _e426;
                    }
                    let _e430 = phi_676_;
                    let _e431 = bitcast<u32>(_e430);
                    let _e433 = ((_e431 & 2139095040u) != 0u);
                    let _e447 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e431 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e431 & 2147483648u))), _e430, _e433) * _e257) * select(0.00000011920929f, 1f, _e433)) * _e263);
                    if _e422 {
                        phi_716_ = _e311[0];
                    } else {
                        phi_716_ = _e311[1];
                    }
                    let _e451 = phi_716_;
                    if _e427 {
                        phi_722_ = _e311[2];
                    } else {
                        phi_722_ = _e451;
                    }
                    let _e454 = phi_722_;
                    let _e455 = bitcast<u32>(_e454);
                    let _e457 = ((_e455 & 2139095040u) != 0u);
                    let _e471 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e455 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e455 & 2147483648u))), _e454, _e457) * _e274) * select(0.00000011920929f, 1f, _e457)) * _e280);
                    let _e475 = (bitcast<f32>((bitcast<u32>(_e471) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e475 {
                        let _e479 = (bitcast<f32>((bitcast<u32>(_e447) & 2147483647u)) * 0.00000011920929f);
                        phi_774_ = select(0.00000000000011368684f, _e479, (_e479 > 0.00000000000011368684f));
                    } else {
                        phi_774_ = 0f;
                    }
                    let _e483 = phi_774_;
                    let _e484 = (_e447 + _e483);
                    let _e485 = (_e447 - _e483);
                    let _e486 = select(_e471, 0f, _e475);
                    if _e475 {
                        phi_786_ = 38685626000000000000000000f;
                    } else {
                        phi_786_ = (1f / _e471);
                    }
                    let _e489 = phi_786_;
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
                            phi_841_ = 255i;
                        } else {
                            phi_841_ = (((_e516 + select(0i, 1i, (_e516 == 0i))) - _e523) + _e503);
                        }
                        let _e531 = phi_841_;
                        let _e541 = (_e531 <= 0i);
                        if _e541 {
                            phi_864_ = u32();
                        } else {
                            if _e520 {
                                phi_863_ = u32();
                            } else {
                                phi_863_ = select(((bitcast<u32>(_e531) << bitcast<u32>(23i)) | ((_e513 << bitcast<u32>(((_e523 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e531 >= 255i));
                            }
                            let _e545 = phi_863_;
                            phi_864_ = _e545;
                        }
                        let _e547 = phi_864_;
                        let _e559 = ((_e204 & 8388607u) | (select(0u, 1u, ((_e204 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e562 = bitcast<i32>((_e204 >> bitcast<u32>(23i)));
                        let _e566 = (_e559 == 0u);
                        let _e569 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e559)), 32u, _e566)) - 8i);
                        if (_e562 == 255i) {
                            phi_901_ = 255i;
                        } else {
                            phi_901_ = (((_e562 + select(0i, 1i, (_e562 == 0i))) - _e569) + _e503);
                        }
                        let _e577 = phi_901_;
                        let _e587 = (_e577 <= 0i);
                        if _e587 {
                            phi_924_ = u32();
                        } else {
                            if _e566 {
                                phi_923_ = u32();
                            } else {
                                phi_923_ = select(((bitcast<u32>(_e577) << bitcast<u32>(23i)) | ((_e559 << bitcast<u32>(((_e569 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e577 >= 255i));
                            }
                            let _e591 = phi_923_;
                            phi_924_ = _e591;
                        }
                        let _e593 = phi_924_;
                        phi_932_ = bitcast<f32>(((_e203 & 2147483648u) | select(_e593, 0u, select(_e566, true, _e587))));
                        phi_933_ = bitcast<f32>(((_e194 & 2147483648u) | select(_e547, 0u, select(_e520, true, _e541))));
                    } else {
                        phi_932_ = 0f;
                        phi_933_ = 1f;
                    }
                    let _e599 = phi_932_;
                    let _e601 = phi_933_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 3>(bitcast<f32>(_e94), bitcast<f32>(_e98), bitcast<f32>(_e102));
                    let _e606 = (_e246 % 3u);
                    let _e607 = (_e606 < 3u);
                    if _e607 {
                    } else {
                        break;
                    }
                    let _e609 = local_9[_e606];
                    let _e610 = (_e245 % 3u);
                    let _e611 = (_e610 < 3u);
                    if _e611 {
                    } else {
                        break;
                    }
                    let _e613 = local_9[_e610];
                    let _e614 = (_e247 % 3u);
                    let _e615 = (_e614 < 3u);
                    if _e615 {
                    } else {
                        break;
                    }
                    let _e617 = local_9[_e614];
                    local_8 = array<f32, 3>(bitcast<f32>(_e106), bitcast<f32>(_e110), bitcast<f32>(_e114));
                    if _e607 {
                    } else {
                        break;
                    }
                    let _e621 = local_8[_e606];
                    if _e611 {
                    } else {
                        break;
                    }
                    let _e623 = local_8[_e610];
                    if _e615 {
                    } else {
                        break;
                    }
                    let _e625 = local_8[_e614];
                    phi_3279_ = false;
                    phi_1016_ = type_37(_e599, false);
                    phi_1019_ = (_e601 <= _e599);
                    phi_1021_ = ((3u * _e84) + 1u);
                    phi_1023_ = 0u;
                    phi_1025_ = type_48(type_46(array<f32, 3>(_e609, _e613, _e617), array<f32, 3>(_e621, _e623, _e625)), select(0u, 2147483648u, (_e84 == 0u)));
                    loop {
                        let _e633 = phi_3279_;
                        let _e635 = phi_1016_;
                        let _e637 = phi_1019_;
                        let _e639 = phi_1021_;
                        let _e641 = phi_1023_;
                        let _e643 = phi_1025_;
                        local_11 = _e635;
                        if _e637 {
                            phi_1036_ = true;
                        } else {
                            phi_1036_ = (_e641 > 0u);
                        }
                        let _e646 = phi_1036_;
                        if _e646 {
                            let _e647 = (_e639 > 0u);
                            if _e647 {
                                if _e637 {
                                    phi_1122_ = _e637;
                                    phi_1123_ = _e641;
                                    phi_1124_ = _e643;
                                } else {
                                    let _e648 = (_e641 - 1u);
                                    let _e649 = (_e648 % 128u);
                                    let _e650 = (_e649 < 128u);
                                    if _e650 {
                                    } else {
                                        phi_3430_ = true;
                                        break;
                                    }
                                    let _e652 = local_6[_e649];
                                    if _e650 {
                                    } else {
                                        phi_3430_ = true;
                                        break;
                                    }
                                    let _e654 = local_5[_e649];
                                    if _e650 {
                                    } else {
                                        phi_3430_ = true;
                                        break;
                                    }
                                    let _e656 = local_4[_e649];
                                    if _e650 {
                                    } else {
                                        phi_3430_ = true;
                                        break;
                                    }
                                    let _e658 = local_3[_e649];
                                    if _e650 {
                                    } else {
                                        phi_3430_ = true;
                                        break;
                                    }
                                    let _e661 = local_2[_e649];
                                    if _e650 {
                                    } else {
                                        phi_3430_ = true;
                                        break;
                                    }
                                    let _e663 = local_1[_e649];
                                    if _e650 {
                                    } else {
                                        phi_3430_ = true;
                                        break;
                                    }
                                    let _e665 = local[_e649];
                                    if _e650 {
                                    } else {
                                        phi_3430_ = true;
                                        break;
                                    }
                                    let _e670 = local_7[_e649];
                                    phi_1122_ = (_e670 <= _e635.member);
                                    phi_1123_ = _e648;
                                    phi_1124_ = type_48(type_46(array<f32, 3>(_e654, _e656, _e658), array<f32, 3>(_e661, _e663, _e665)), _e652);
                                }
                                let _e674 = phi_1122_;
                                let _e676 = phi_1123_;
                                let _e678 = phi_1124_;
                                if _e674 {
                                    if ((_e678.member_1 & 2147483648u) != 0u) {
                                        phi_1142_ = _e635;
                                        phi_1145_ = type_7(0u, ((_e678.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1054 = phi_1142_;
                                            let _e1056 = phi_1145_;
                                            local_10 = _e1054;
                                            local_12 = _e1054;
                                            if (_e1056.member < _e1056.member_1) {
                                                phi_1146_ = type_7((_e1056.member + 1u), _e1056.member_1);
                                                phi_1168_ = type_7(1u, _e1056.member);
                                            } else {
                                                phi_1146_ = _e1056;
                                                phi_1168_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e1069 = phi_1146_;
                                            let _e1071 = phi_1168_;
                                            let _e1075 = (bitcast<i32>(_e1071.member) != 0i);
                                            if _e1075 {
                                                let _e1076 = ((_e678.member_1 & 268435455u) + _e1071.member_1);
                                                let _e1077 = (_e1076 < _e86);
                                                if _e1077 {
                                                    if _e1077 {
                                                    } else {
                                                        phi_3273_ = true;
                                                        break;
                                                    }
                                                    let _e1081 = global_2.member[_e1076].member_1;
                                                    phi_1189_ = _e1081;
                                                } else {
                                                    phi_1189_ = 4294967295u;
                                                }
                                                let _e1083 = phi_1189_;
                                                if (_e1076 >= _e86) {
                                                    phi_1281_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1077 {
                                                    } else {
                                                        phi_3273_ = true;
                                                        break;
                                                    }
                                                    if (_e606 < 9u) {
                                                    } else {
                                                        phi_3273_ = true;
                                                        break;
                                                    }
                                                    let _e1090 = global_2.member[_e1076].member[_e606];
                                                    if (_e610 < 9u) {
                                                    } else {
                                                        phi_3273_ = true;
                                                        break;
                                                    }
                                                    let _e1096 = global_2.member[_e1076].member[_e610];
                                                    if (_e614 < 9u) {
                                                    } else {
                                                        phi_3273_ = true;
                                                        break;
                                                    }
                                                    let _e1102 = global_2.member[_e1076].member[_e614];
                                                    let _e1104 = (3u + _e606);
                                                    if (_e1104 < 9u) {
                                                    } else {
                                                        phi_3273_ = true;
                                                        break;
                                                    }
                                                    let _e1110 = global_2.member[_e1076].member[_e1104];
                                                    let _e1111 = (3u + _e610);
                                                    if (_e1111 < 9u) {
                                                    } else {
                                                        phi_3273_ = true;
                                                        break;
                                                    }
                                                    let _e1117 = global_2.member[_e1076].member[_e1111];
                                                    let _e1118 = (3u + _e614);
                                                    if (_e1118 < 9u) {
                                                    } else {
                                                        phi_3273_ = true;
                                                        break;
                                                    }
                                                    let _e1124 = global_2.member[_e1076].member[_e1118];
                                                    let _e1126 = (6u + _e606);
                                                    if (_e1126 < 9u) {
                                                    } else {
                                                        phi_3273_ = true;
                                                        break;
                                                    }
                                                    let _e1132 = global_2.member[_e1076].member[_e1126];
                                                    let _e1133 = (6u + _e610);
                                                    if (_e1133 < 9u) {
                                                    } else {
                                                        phi_3273_ = true;
                                                        break;
                                                    }
                                                    let _e1139 = global_2.member[_e1076].member[_e1133];
                                                    let _e1140 = (6u + _e614);
                                                    if (_e1140 < 9u) {
                                                    } else {
                                                        phi_3273_ = true;
                                                        break;
                                                    }
                                                    let _e1146 = global_2.member[_e1076].member[_e1140];
                                                    phi_1281_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1090, _e1096, _e1102), array<f32, 3>(_e1110, _e1117, _e1124), array<f32, 3>(_e1132, _e1139, _e1146));
                                                }
                                                let _e1150 = phi_1281_;
                                                let _e1158 = (_e1150[0][2] - _e447);
                                                let _e1161 = (((_e1150[0][0] - _e310) * _e486) - (_e1158 * _e350));
                                                let _e1164 = (((_e1150[0][1] - _e379) * _e486) - (_e1158 * _e418));
                                                let _e1171 = (_e1150[1][2] - _e447);
                                                let _e1174 = (((_e1150[1][0] - _e310) * _e486) - (_e1171 * _e350));
                                                let _e1177 = (((_e1150[1][1] - _e379) * _e486) - (_e1171 * _e418));
                                                let _e1184 = (_e1150[2][2] - _e447);
                                                let _e1187 = (((_e1150[2][0] - _e310) * _e486) - (_e1184 * _e350));
                                                let _e1190 = (((_e1150[2][1] - _e379) * _e486) - (_e1184 * _e418));
                                                let _e1191 = (_e1187 * _e1177);
                                                let _e1192 = (_e1190 * _e1174);
                                                let _e1193 = (_e1161 * _e1190);
                                                let _e1194 = (_e1164 * _e1187);
                                                let _e1195 = (_e1174 * _e1164);
                                                let _e1196 = (_e1177 * _e1161);
                                                let _e1201 = (((_e1191 >= _e1192) && (_e1193 >= _e1194)) && (_e1195 >= _e1196));
                                                if (_e1201 || (((_e1191 <= _e1192) && (_e1193 <= _e1194)) && (_e1195 <= _e1196))) {
                                                    let _e1208 = select(-1f, 1f, _e1201);
                                                    let _e1210 = ((_e1191 - _e1192) * _e1208);
                                                    let _e1212 = select(0f, _e1210, (_e1210 > 0f));
                                                    let _e1214 = ((_e1193 - _e1194) * _e1208);
                                                    let _e1216 = select(0f, _e1214, (_e1214 > 0f));
                                                    let _e1218 = ((_e1195 - _e1196) * _e1208);
                                                    let _e1220 = select(0f, _e1218, (_e1218 > 0f));
                                                    let _e1222 = ((_e1212 + _e1216) + _e1220);
                                                    if (_e1222 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2165_ = type_25();
                                                        phi_2166_ = true;
                                                        phi_2167_ = false;
                                                    } else {
                                                        let _e1225 = select(_e1174, _e1161, (_e1161 < _e1174));
                                                        if (select(_e1187, _e1225, (_e1225 < _e1187)) > 0f) {
                                                            phi_1433_ = true;
                                                        } else {
                                                            let _e1230 = select(_e1174, _e1161, (_e1161 > _e1174));
                                                            phi_1433_ = (select(_e1187, _e1230, (_e1230 > _e1187)) < 0f);
                                                        }
                                                        let _e1235 = phi_1433_;
                                                        if _e1235 {
                                                            phi_2162_ = type_25();
                                                            phi_2163_ = true;
                                                            phi_2164_ = false;
                                                        } else {
                                                            let _e1237 = select(_e1177, _e1164, (_e1164 < _e1177));
                                                            if (select(_e1190, _e1237, (_e1237 < _e1190)) > 0f) {
                                                                phi_1462_ = true;
                                                            } else {
                                                                let _e1242 = select(_e1177, _e1164, (_e1164 > _e1177));
                                                                phi_1462_ = (select(_e1190, _e1242, (_e1242 > _e1190)) < 0f);
                                                            }
                                                            let _e1247 = phi_1462_;
                                                            if _e1247 {
                                                                phi_2160_ = type_25();
                                                                phi_2161_ = false;
                                                            } else {
                                                                let _e1249 = select(_e1150[1][0], _e1150[0][0], (_e1150[0][0] < _e1150[1][0]));
                                                                let _e1253 = select(_e1150[1][0], _e1150[0][0], (_e1150[0][0] > _e1150[1][0]));
                                                                let _e1257 = select(_e1150[1][1], _e1150[0][1], (_e1150[0][1] < _e1150[1][1]));
                                                                let _e1261 = select(_e1150[1][1], _e1150[0][1], (_e1150[0][1] > _e1150[1][1]));
                                                                let _e1265 = select(_e1150[1][2], _e1150[0][2], (_e1150[0][2] < _e1150[1][2]));
                                                                let _e1269 = select(_e1150[1][2], _e1150[0][2], (_e1150[0][2] > _e1150[1][2]));
                                                                let _e1274 = ((select(_e1150[2][0], _e1249, (_e1249 < _e1150[2][0])) - _e348) * _e353);
                                                                let _e1275 = ((select(_e1150[2][0], _e1253, (_e1253 > _e1150[2][0])) - _e349) * _e353);
                                                                let _e1278 = ((select(_e1150[2][1], _e1257, (_e1257 < _e1150[2][1])) - _e416) * _e421);
                                                                let _e1279 = ((select(_e1150[2][1], _e1261, (_e1261 > _e1150[2][1])) - _e417) * _e421);
                                                                let _e1282 = ((select(_e1150[2][2], _e1265, (_e1265 < _e1150[2][2])) - _e484) * _e489);
                                                                let _e1283 = ((select(_e1150[2][2], _e1269, (_e1269 > _e1150[2][2])) - _e485) * _e489);
                                                                let _e1285 = select(_e1283, _e1282, (_e1282 < _e1283));
                                                                let _e1287 = select(_e1283, _e1282, (_e1282 > _e1283));
                                                                let _e1289 = select(_e1275, _e1274, (_e1274 < _e1275));
                                                                let _e1291 = select(_e1279, _e1278, (_e1278 < _e1279));
                                                                let _e1293 = select(_e1291, _e1289, (_e1289 > _e1291));
                                                                let _e1295 = select(_e1285, _e1293, (_e1293 > _e1285));
                                                                let _e1297 = select(_e1275, _e1274, (_e1274 > _e1275));
                                                                let _e1299 = select(_e1279, _e1278, (_e1278 > _e1279));
                                                                let _e1301 = select(_e1299, _e1297, (_e1297 < _e1299));
                                                                let _e1303 = select(_e1287, _e1301, (_e1301 < _e1287));
                                                                let _e1304 = -(_e1285);
                                                                let _e1310 = select(_e601, _e1295, (_e1295 > _e601));
                                                                if (_e1310 > (_e1303 + (select(_e1304, _e1287, (_e1287 > _e1304)) * 0.0000019073523f))) {
                                                                    phi_2155_ = type_25();
                                                                    phi_2156_ = true;
                                                                } else {
                                                                    let _e1312 = (_e1310 > _e1054.member);
                                                                    if _e1312 {
                                                                        phi_2154_ = type_25();
                                                                    } else {
                                                                        let _e1313 = vec3<f32>(_e1150[0][0], _e1150[0][1], _e1150[0][2]);
                                                                        let _e1314 = vec3<f32>(_e1150[1][0], _e1150[1][1], _e1150[1][2]);
                                                                        let _e1315 = vec3<f32>(_e1150[2][0], _e1150[2][1], _e1150[2][2]);
                                                                        let _e1316 = (_e1150[1][0] - _e1150[0][0]);
                                                                        let _e1317 = (_e1150[1][1] - _e1150[0][1]);
                                                                        let _e1318 = (_e1150[1][2] - _e1150[0][2]);
                                                                        let _e1319 = vec3<f32>(_e1316, _e1317, _e1318);
                                                                        let _e1320 = (_e1150[2][0] - _e1150[1][0]);
                                                                        let _e1321 = (_e1150[2][1] - _e1150[1][1]);
                                                                        let _e1322 = (_e1150[2][2] - _e1150[1][2]);
                                                                        let _e1323 = vec3<f32>(_e1320, _e1321, _e1322);
                                                                        let _e1324 = (_e1150[0][0] - _e1150[2][0]);
                                                                        let _e1325 = (_e1150[0][1] - _e1150[2][1]);
                                                                        let _e1326 = (_e1150[0][2] - _e1150[2][2]);
                                                                        let _e1327 = vec3<f32>(_e1324, _e1325, _e1326);
                                                                        let _e1330 = bitcast<f32>((bitcast<u32>(_e1316) & 2147483647u));
                                                                        let _e1333 = bitcast<f32>((bitcast<u32>(_e1317) & 2147483647u));
                                                                        let _e1335 = select(_e1333, _e1330, (_e1330 > _e1333));
                                                                        let _e1338 = bitcast<f32>((bitcast<u32>(_e1318) & 2147483647u));
                                                                        let _e1340 = select(_e1338, _e1335, (_e1335 > _e1338));
                                                                        let _e1343 = bitcast<f32>((bitcast<u32>(_e1320) & 2147483647u));
                                                                        let _e1346 = bitcast<f32>((bitcast<u32>(_e1321) & 2147483647u));
                                                                        let _e1348 = select(_e1346, _e1343, (_e1343 > _e1346));
                                                                        let _e1351 = bitcast<f32>((bitcast<u32>(_e1322) & 2147483647u));
                                                                        let _e1353 = select(_e1351, _e1348, (_e1348 > _e1351));
                                                                        let _e1356 = bitcast<f32>((bitcast<u32>(_e1324) & 2147483647u));
                                                                        let _e1359 = bitcast<f32>((bitcast<u32>(_e1325) & 2147483647u));
                                                                        let _e1361 = select(_e1359, _e1356, (_e1356 > _e1359));
                                                                        let _e1364 = bitcast<f32>((bitcast<u32>(_e1326) & 2147483647u));
                                                                        let _e1366 = select(_e1364, _e1361, (_e1361 > _e1364));
                                                                        let _e1368 = select(_e1353, _e1340, (_e1340 > _e1353));
                                                                        let _e1370 = select(_e1366, _e1368, (_e1368 > _e1366));
                                                                        if (_e1340 == _e1370) {
                                                                            phi_1881_ = _e1177;
                                                                            phi_1882_ = _e1174;
                                                                            phi_1883_ = _e1164;
                                                                            phi_1884_ = _e1161;
                                                                            phi_1885_ = _e1313;
                                                                            phi_1886_ = _e1327;
                                                                            phi_1887_ = _e1323;
                                                                            phi_1888_ = _e1319;
                                                                        } else {
                                                                            let _e1372 = (_e1353 == _e1370);
                                                                            let _e1377 = vec3(_e1372);
                                                                            phi_1881_ = select(_e1164, _e1190, _e1372);
                                                                            phi_1882_ = select(_e1161, _e1187, _e1372);
                                                                            phi_1883_ = select(_e1190, _e1177, _e1372);
                                                                            phi_1884_ = select(_e1187, _e1174, _e1372);
                                                                            phi_1885_ = select(_e1315, _e1314, _e1377);
                                                                            phi_1886_ = select(_e1323, _e1319, _e1377);
                                                                            phi_1887_ = select(_e1319, _e1327, _e1377);
                                                                            phi_1888_ = select(_e1327, _e1323, _e1377);
                                                                        }
                                                                        let _e1383 = phi_1881_;
                                                                        let _e1385 = phi_1882_;
                                                                        let _e1387 = phi_1883_;
                                                                        let _e1389 = phi_1884_;
                                                                        let _e1391 = phi_1885_;
                                                                        let _e1393 = phi_1886_;
                                                                        let _e1395 = phi_1887_;
                                                                        let _e1397 = phi_1888_;
                                                                        let _e1404 = ((_e1395.y * _e1393.z) - (_e1393.y * _e1395.z));
                                                                        let _e1409 = ((_e1395.z * _e1393.x) - (_e1393.z * _e1395.x));
                                                                        let _e1412 = ((_e1395.x * _e1393.y) - (_e1393.x * _e1395.y));
                                                                        if (_e1212 >= _e1216) {
                                                                            phi_1925_ = select(true, false, (_e1212 >= _e1220));
                                                                        } else {
                                                                            phi_1925_ = true;
                                                                        }
                                                                        let _e1417 = phi_1925_;
                                                                        if _e1417 {
                                                                            phi_1934_ = select(_e1315, _e1314, vec3((_e1216 >= _e1220)));
                                                                        } else {
                                                                            phi_1934_ = _e1313;
                                                                        }
                                                                        let _e1422 = phi_1934_;
                                                                        let _e1433 = (((_e1404 * (_e1422.x - _e310)) + (_e1409 * (_e1422.y - _e379))) + (_e1412 * (_e1422.z - _e447)));
                                                                        let _e1438 = (((_e1404 * _e350) + (_e1409 * _e418)) + (_e1412 * _e486));
                                                                        let _e1439 = (_e1385 - _e1389);
                                                                        let _e1440 = (_e1383 - _e1387);
                                                                        let _e1448 = (-(((_e1389 * _e1439) + (_e1387 * _e1440))) / ((_e1439 * _e1439) + (_e1440 * _e1440)));
                                                                        let _e1450 = select(1f, _e1448, (_e1448 < 1f));
                                                                        let _e1452 = select(0f, _e1450, (_e1450 > 0f));
                                                                        let _e1465 = ((_e1391.x + (_e1397.x * _e1452)) - _e310);
                                                                        let _e1466 = ((_e1391.y + (_e1397.y * _e1452)) - _e379);
                                                                        let _e1467 = ((_e1391.z + (_e1397.z * _e1452)) - _e447);
                                                                        let _e1468 = (_e1467 / _e486);
                                                                        let _e1480 = bitcast<f32>((bitcast<u32>(_e1465) & 2147483647u));
                                                                        let _e1483 = bitcast<f32>((bitcast<u32>(_e1466) & 2147483647u));
                                                                        let _e1485 = select(_e1483, _e1480, (_e1480 > _e1483));
                                                                        let _e1488 = bitcast<f32>((bitcast<u32>(_e1467) & 2147483647u));
                                                                        let _e1490 = select(_e1488, _e1485, (_e1485 > _e1488));
                                                                        let _e1496 = bitcast<f32>((bitcast<u32>(_e1404) & 2147483647u));
                                                                        let _e1499 = bitcast<f32>((bitcast<u32>(_e1409) & 2147483647u));
                                                                        let _e1501 = select(_e1499, _e1496, (_e1496 > _e1499));
                                                                        let _e1504 = bitcast<f32>((bitcast<u32>(_e1412) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1404 * _e1465) + (_e1409 * _e1466)) + (_e1412 * _e1467)) - _e1433)) & 2147483647u)) <= ((0.0000009536743f * select(_e1370, _e1490, (_e1490 > _e1370))) * select(_e1504, _e1501, (_e1501 > _e1504)))) {
                                                                            let _e1514 = bitcast<f32>((bitcast<u32>(_e1395.x) & 2147483647u));
                                                                            let _e1517 = bitcast<f32>((bitcast<u32>(_e1395.y) & 2147483647u));
                                                                            let _e1519 = select(_e1517, _e1514, (_e1514 > _e1517));
                                                                            let _e1522 = bitcast<f32>((bitcast<u32>(_e1395.z) & 2147483647u));
                                                                            let _e1528 = bitcast<f32>((bitcast<u32>(_e1393.x) & 2147483647u));
                                                                            let _e1531 = bitcast<f32>((bitcast<u32>(_e1393.y) & 2147483647u));
                                                                            let _e1533 = select(_e1531, _e1528, (_e1528 > _e1531));
                                                                            let _e1536 = bitcast<f32>((bitcast<u32>(_e1393.z) & 2147483647u));
                                                                            let _e1540 = (bitcast<f32>((bitcast<u32>(_e1438) & 2147483647u)) > ((0.0000038146973f * select(_e1522, _e1519, (_e1519 > _e1522))) * select(_e1536, _e1533, (_e1533 > _e1536))));
                                                                            if _e1540 {
                                                                                phi_2099_ = (_e1433 / _e1438);
                                                                            } else {
                                                                                phi_2099_ = f32();
                                                                            }
                                                                            let _e1543 = phi_2099_;
                                                                            phi_2101_ = _e1543;
                                                                            phi_2102_ = select(true, false, _e1540);
                                                                        } else {
                                                                            phi_2101_ = f32();
                                                                            phi_2102_ = true;
                                                                        }
                                                                        let _e1546 = phi_2101_;
                                                                        let _e1548 = phi_2102_;
                                                                        if _e1548 {
                                                                            let _e1556 = (((_e1404 * (_e1465 - (_e350 * _e1468))) + (_e1409 * (_e1466 - (_e418 * _e1468)))) / _e1438);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1556) & 2147483647u)) <= _e1370) {
                                                                                phi_2122_ = (_e1468 + _e1556);
                                                                            } else {
                                                                                phi_2122_ = _e1468;
                                                                            }
                                                                            let _e1563 = phi_2122_;
                                                                            phi_2123_ = _e1563;
                                                                        } else {
                                                                            phi_2123_ = _e1546;
                                                                        }
                                                                        let _e1565 = phi_2123_;
                                                                        let _e1567 = select(_e1303, _e1565, (_e1565 < _e1303));
                                                                        let _e1569 = select(_e1295, _e1567, (_e1567 > _e1295));
                                                                        if (_e1569 >= _e601) {
                                                                            let _e1571 = (_e1569 <= _e1054.member);
                                                                            if _e1571 {
                                                                                let _e1572 = (1f / _e1222);
                                                                                phi_2146_ = type_25(_e1569, (_e1216 * _e1572), (_e1220 * _e1572), _e1083);
                                                                            } else {
                                                                                phi_2146_ = type_25();
                                                                            }
                                                                            let _e1577 = phi_2146_;
                                                                            phi_2148_ = _e1577;
                                                                            phi_2149_ = select(true, false, _e1571);
                                                                        } else {
                                                                            phi_2148_ = type_25();
                                                                            phi_2149_ = true;
                                                                        }
                                                                        let _e1580 = phi_2148_;
                                                                        let _e1582 = phi_2149_;
                                                                        if _e1582 {
                                                                            phi_2153_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2153_ = _e1580;
                                                                        }
                                                                        let _e1584 = phi_2153_;
                                                                        phi_2154_ = _e1584;
                                                                    }
                                                                    let _e1586 = phi_2154_;
                                                                    phi_2155_ = _e1586;
                                                                    phi_2156_ = _e1312;
                                                                }
                                                                let _e1588 = phi_2155_;
                                                                let _e1590 = phi_2156_;
                                                                phi_2160_ = _e1588;
                                                                phi_2161_ = _e1590;
                                                            }
                                                            let _e1592 = phi_2160_;
                                                            let _e1594 = phi_2161_;
                                                            phi_2162_ = _e1592;
                                                            phi_2163_ = _e1247;
                                                            phi_2164_ = _e1594;
                                                        }
                                                        let _e1596 = phi_2162_;
                                                        let _e1598 = phi_2163_;
                                                        let _e1600 = phi_2164_;
                                                        phi_2165_ = _e1596;
                                                        phi_2166_ = _e1598;
                                                        phi_2167_ = _e1600;
                                                    }
                                                    let _e1602 = phi_2165_;
                                                    let _e1604 = phi_2166_;
                                                    let _e1606 = phi_2167_;
                                                    phi_2175_ = _e1602;
                                                    phi_2176_ = select(_e1606, true, _e1604);
                                                } else {
                                                    phi_2175_ = type_25();
                                                    phi_2176_ = true;
                                                }
                                                let _e1609 = phi_2175_;
                                                let _e1611 = phi_2176_;
                                                if _e1611 {
                                                    phi_2180_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2180_ = _e1609;
                                                }
                                                let _e1613 = phi_2180_;
                                                if (_e1613.member_3 != 4294967295u) {
                                                    if (_e1083 != 4294967295u) {
                                                        phi_2191_ = type_37(_e1054.member, true);
                                                    } else {
                                                        phi_2191_ = _e1054;
                                                    }
                                                    let _e1621 = phi_2191_;
                                                    phi_2192_ = _e1621;
                                                } else {
                                                    phi_2192_ = _e1054;
                                                }
                                                let _e1623 = phi_2192_;
                                                phi_1143_ = _e1623;
                                            } else {
                                                phi_1143_ = type_37();
                                            }
                                            let _e1625 = phi_1143_;
                                            continue;
                                            continuing {
                                                phi_1142_ = _e1625;
                                                phi_1145_ = _e1069;
                                                phi_3273_ = _e633;
                                                break if !(_e1075);
                                            }
                                        }
                                        let _e1628 = phi_3273_;
                                        phi_3430_ = _e1628;
                                        if _e1628 {
                                            break;
                                        }
                                        let _e1630 = local_10;
                                        phi_3434_ = _e1628;
                                        let _e1795 = local_12;
                                        phi_3207_ = _e1795;
                                        phi_3208_ = false;
                                        phi_3209_ = select(_e676, 0u, _e1630.member_1);
                                        phi_3210_ = _e678;
                                    } else {
                                        let _e687 = (_e678.member_1 < _e84);
                                        if _e687 {
                                            if _e687 {
                                            } else {
                                                phi_3430_ = true;
                                                break;
                                            }
                                            let _e689 = global_6.member[_e678.member_1];
                                            phi_2220_ = _e689;
                                        } else {
                                            phi_2220_ = type_41(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e691 = phi_2220_;
                                        let _e706 = ((10u * _e246) & 31u);
                                        let _e709 = ((_e691.member[0] >> bitcast<u32>(_e706)) & 1023u);
                                        let _e717 = bitcast<f32>((bitcast<u32>(((_e678.member.member_1[0] - _e678.member.member[0]) * 0.0009775171f)) ^ _e118));
                                        let _e722 = (_e678.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e709)) - 8388608f) * _e717)) ^ _e118)));
                                        let _e726 = select(select(_e678.member.member_1[0], _e722, (_e722 < _e678.member.member_1[0])), _e678.member.member_1[0], (_e709 == 1023u));
                                        let _e728 = ((10u * _e245) & 31u);
                                        let _e731 = ((_e691.member[0] >> bitcast<u32>(_e728)) & 1023u);
                                        let _e739 = bitcast<f32>((bitcast<u32>(((_e678.member.member_1[1] - _e678.member.member[1]) * 0.0009775171f)) ^ _e118));
                                        let _e744 = (_e678.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e731)) - 8388608f) * _e739)) ^ _e118)));
                                        let _e748 = select(select(_e678.member.member_1[1], _e744, (_e744 < _e678.member.member_1[1])), _e678.member.member_1[1], (_e731 == 1023u));
                                        let _e750 = ((10u * _e247) & 31u);
                                        let _e753 = ((_e691.member[0] >> bitcast<u32>(_e750)) & 1023u);
                                        let _e761 = bitcast<f32>((bitcast<u32>(((_e678.member.member_1[2] - _e678.member.member[2]) * 0.0009775171f)) ^ _e118));
                                        let _e766 = (_e678.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e753)) - 8388608f) * _e761)) ^ _e118)));
                                        let _e770 = select(select(_e678.member.member_1[2], _e766, (_e766 < _e678.member.member_1[2])), _e678.member.member_1[2], (_e753 == 1023u));
                                        let _e773 = ((_e691.member[1] >> bitcast<u32>(_e706)) & 1023u);
                                        let _e781 = (_e678.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e773)) - 8388608f) * _e717)) ^ _e118)));
                                        let _e785 = select(select(_e678.member.member_1[0], _e781, (_e781 < _e678.member.member_1[0])), _e678.member.member_1[0], (_e773 == 1023u));
                                        let _e788 = ((_e691.member[1] >> bitcast<u32>(_e728)) & 1023u);
                                        let _e796 = (_e678.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e788)) - 8388608f) * _e739)) ^ _e118)));
                                        let _e800 = select(select(_e678.member.member_1[1], _e796, (_e796 < _e678.member.member_1[1])), _e678.member.member_1[1], (_e788 == 1023u));
                                        let _e803 = ((_e691.member[1] >> bitcast<u32>(_e750)) & 1023u);
                                        let _e811 = (_e678.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e803)) - 8388608f) * _e761)) ^ _e118)));
                                        let _e815 = select(select(_e678.member.member_1[2], _e811, (_e811 < _e678.member.member_1[2])), _e678.member.member_1[2], (_e803 == 1023u));
                                        let _e821 = ((_e691.member_1[0] >> bitcast<u32>(_e706)) & 1023u);
                                        let _e829 = (_e678.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e821)) - 8388608f) * _e717)) ^ _e118)));
                                        let _e833 = select(select(_e678.member.member_1[0], _e829, (_e829 < _e678.member.member_1[0])), _e678.member.member_1[0], (_e821 == 1023u));
                                        let _e836 = ((_e691.member_1[0] >> bitcast<u32>(_e728)) & 1023u);
                                        let _e844 = (_e678.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e836)) - 8388608f) * _e739)) ^ _e118)));
                                        let _e848 = select(select(_e678.member.member_1[1], _e844, (_e844 < _e678.member.member_1[1])), _e678.member.member_1[1], (_e836 == 1023u));
                                        let _e851 = ((_e691.member_1[0] >> bitcast<u32>(_e750)) & 1023u);
                                        let _e859 = (_e678.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e851)) - 8388608f) * _e761)) ^ _e118)));
                                        let _e863 = select(select(_e678.member.member_1[2], _e859, (_e859 < _e678.member.member_1[2])), _e678.member.member_1[2], (_e851 == 1023u));
                                        let _e866 = ((_e691.member_1[1] >> bitcast<u32>(_e706)) & 1023u);
                                        let _e874 = (_e678.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e866)) - 8388608f) * _e717)) ^ _e118)));
                                        let _e878 = select(select(_e678.member.member_1[0], _e874, (_e874 < _e678.member.member_1[0])), _e678.member.member_1[0], (_e866 == 1023u));
                                        let _e881 = ((_e691.member_1[1] >> bitcast<u32>(_e728)) & 1023u);
                                        let _e889 = (_e678.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e881)) - 8388608f) * _e739)) ^ _e118)));
                                        let _e893 = select(select(_e678.member.member_1[1], _e889, (_e889 < _e678.member.member_1[1])), _e678.member.member_1[1], (_e881 == 1023u));
                                        let _e896 = ((_e691.member_1[1] >> bitcast<u32>(_e750)) & 1023u);
                                        let _e904 = (_e678.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e896)) - 8388608f) * _e761)) ^ _e118)));
                                        let _e908 = select(select(_e678.member.member_1[2], _e904, (_e904 < _e678.member.member_1[2])), _e678.member.member_1[2], (_e896 == 1023u));
                                        let _e913 = type_48(type_46(array<f32, 3>(_e726, _e748, _e770), array<f32, 3>(_e785, _e800, _e815)), _e691.member_2);
                                        let _e918 = type_48(type_46(array<f32, 3>(_e833, _e848, _e863), array<f32, 3>(_e878, _e893, _e908)), _e691.member_3);
                                        let _e924 = ((_e726 - _e348) * _e353);
                                        let _e925 = ((_e833 - _e348) * _e353);
                                        let _e926 = ((_e785 - _e349) * _e353);
                                        let _e927 = ((_e878 - _e349) * _e353);
                                        let _e932 = ((_e748 - _e416) * _e421);
                                        let _e933 = ((_e848 - _e416) * _e421);
                                        let _e934 = ((_e800 - _e417) * _e421);
                                        let _e935 = ((_e893 - _e417) * _e421);
                                        let _e940 = ((_e770 - _e484) * _e489);
                                        let _e941 = ((_e863 - _e484) * _e489);
                                        let _e942 = ((_e815 - _e485) * _e489);
                                        let _e943 = ((_e908 - _e485) * _e489);
                                        let _e945 = select(_e942, _e940, (_e940 < _e942));
                                        let _e947 = select(_e943, _e941, (_e941 < _e943));
                                        let _e949 = select(_e942, _e940, (_e940 > _e942));
                                        let _e951 = select(_e943, _e941, (_e941 > _e943));
                                        let _e953 = select(_e926, _e924, (_e924 < _e926));
                                        let _e955 = select(_e927, _e925, (_e925 < _e927));
                                        let _e957 = select(_e934, _e932, (_e932 < _e934));
                                        let _e959 = select(_e935, _e933, (_e933 < _e935));
                                        let _e961 = select(_e957, _e953, (_e953 > _e957));
                                        let _e963 = select(_e959, _e955, (_e955 > _e959));
                                        let _e965 = select(_e945, _e961, (_e961 > _e945));
                                        let _e967 = select(_e947, _e963, (_e963 > _e947));
                                        let _e969 = select(_e926, _e924, (_e924 > _e926));
                                        let _e971 = select(_e927, _e925, (_e925 > _e927));
                                        let _e973 = select(_e934, _e932, (_e932 > _e934));
                                        let _e975 = select(_e935, _e933, (_e933 > _e935));
                                        let _e977 = select(_e973, _e969, (_e969 < _e973));
                                        let _e979 = select(_e975, _e971, (_e971 < _e975));
                                        let _e984 = -(_e945);
                                        let _e985 = -(_e947);
                                        let _e992 = (select(_e949, _e977, (_e977 < _e949)) + (select(_e984, _e949, (_e949 > _e984)) * 0.0000019073523f));
                                        let _e993 = (select(_e951, _e979, (_e979 < _e951)) + (select(_e985, _e951, (_e951 > _e985)) * 0.0000019073523f));
                                        let _e995 = select(_e601, _e965, (_e965 > _e601));
                                        let _e997 = select(_e601, _e967, (_e967 > _e601));
                                        let _e1002 = (_e995 <= select(_e635.member, _e992, (_e992 < _e635.member)));
                                        let _e1003 = (_e997 <= select(_e635.member, _e993, (_e993 < _e635.member)));
                                        let _e1004 = (_e995 <= _e997);
                                        if _e1002 {
                                            if _e1003 {
                                                if _e1004 {
                                                    phi_3106_ = _e918;
                                                } else {
                                                    phi_3106_ = _e913;
                                                }
                                                let _e1006 = phi_3106_;
                                                let _e1014 = (_e676 % 128u);
                                                let _e1015 = (_e1014 < 128u);
                                                if _e1015 {
                                                } else {
                                                    phi_3430_ = true;
                                                    break;
                                                }
                                                local_6[_e1014] = _e1006.member_1;
                                                if _e1015 {
                                                } else {
                                                    phi_3430_ = true;
                                                    break;
                                                }
                                                local_5[_e1014] = _e1006.member.member[0];
                                                if _e1015 {
                                                } else {
                                                    phi_3430_ = true;
                                                    break;
                                                }
                                                local_4[_e1014] = _e1006.member.member[1];
                                                if _e1015 {
                                                } else {
                                                    phi_3430_ = true;
                                                    break;
                                                }
                                                local_3[_e1014] = _e1006.member.member[2];
                                                if _e1015 {
                                                } else {
                                                    phi_3430_ = true;
                                                    break;
                                                }
                                                local_2[_e1014] = _e1006.member.member_1[0];
                                                if _e1015 {
                                                } else {
                                                    phi_3430_ = true;
                                                    break;
                                                }
                                                local_1[_e1014] = _e1006.member.member_1[1];
                                                if _e1015 {
                                                } else {
                                                    phi_3430_ = true;
                                                    break;
                                                }
                                                local[_e1014] = _e1006.member.member_1[2];
                                                if _e1015 {
                                                } else {
                                                    phi_3430_ = true;
                                                    break;
                                                }
                                                local_7[_e1014] = select(_e997, _e995, !(_e1004));
                                                if _e1004 {
                                                    phi_3183_ = _e913;
                                                } else {
                                                    phi_3183_ = _e918;
                                                }
                                                let _e1032 = phi_3183_;
                                                phi_3184_ = (_e676 + 1u);
                                                phi_3185_ = _e1032;
                                            } else {
                                                phi_3184_ = u32();
                                                phi_3185_ = type_48();
                                            }
                                            let _e1034 = phi_3184_;
                                            let _e1036 = phi_3185_;
                                            phi_3187_ = _e1034;
                                            phi_3188_ = _e1036;
                                            phi_3189_ = select(true, false, _e1003);
                                        } else {
                                            phi_3187_ = u32();
                                            phi_3188_ = type_48();
                                            phi_3189_ = true;
                                        }
                                        let _e1039 = phi_3187_;
                                        let _e1041 = phi_3188_;
                                        let _e1043 = phi_3189_;
                                        if _e1043 {
                                            if _e1002 {
                                                phi_3196_ = _e913;
                                            } else {
                                                phi_3196_ = _e918;
                                            }
                                            let _e1045 = phi_3196_;
                                            phi_3201_ = select(_e1003, true, _e1002);
                                            phi_3203_ = _e1045;
                                        } else {
                                            phi_3201_ = _e674;
                                            phi_3203_ = _e1041;
                                        }
                                        let _e1048 = phi_3201_;
                                        let _e1050 = phi_3203_;
                                        phi_3434_ = _e633;
                                        phi_3207_ = _e635;
                                        phi_3208_ = _e1048;
                                        phi_3209_ = select(_e1039, _e676, _e1043);
                                        phi_3210_ = _e1050;
                                    }
                                    let _e1634 = phi_3434_;
                                    let _e1636 = phi_3207_;
                                    let _e1638 = phi_3208_;
                                    let _e1640 = phi_3209_;
                                    let _e1642 = phi_3210_;
                                    phi_3433_ = _e1634;
                                    phi_3211_ = _e1636;
                                    phi_3212_ = _e1638;
                                    phi_3213_ = (_e639 - 1u);
                                    phi_3214_ = _e1640;
                                    phi_3215_ = _e1642;
                                } else {
                                    phi_3433_ = _e633;
                                    phi_3211_ = _e635;
                                    phi_3212_ = _e674;
                                    phi_3213_ = _e639;
                                    phi_3214_ = _e676;
                                    phi_3215_ = _e678;
                                }
                                let _e1644 = phi_3433_;
                                let _e1646 = phi_3211_;
                                let _e1648 = phi_3212_;
                                let _e1650 = phi_3213_;
                                let _e1652 = phi_3214_;
                                let _e1654 = phi_3215_;
                                phi_3432_ = _e1644;
                                phi_3216_ = _e1646;
                                phi_3217_ = _e1648;
                                phi_3218_ = _e1650;
                                phi_3219_ = _e1652;
                                phi_3220_ = _e1654;
                            } else {
                                phi_3432_ = _e633;
                                phi_3216_ = type_37();
                                phi_3217_ = bool();
                                phi_3218_ = u32();
                                phi_3219_ = u32();
                                phi_3220_ = type_48();
                            }
                            let _e1656 = phi_3432_;
                            let _e1658 = phi_3216_;
                            let _e1660 = phi_3217_;
                            let _e1662 = phi_3218_;
                            let _e1664 = phi_3219_;
                            let _e1666 = phi_3220_;
                            phi_3431_ = _e1656;
                            phi_1017_ = _e1658;
                            phi_1020_ = _e1660;
                            phi_1022_ = _e1662;
                            phi_1024_ = _e1664;
                            phi_1026_ = _e1666;
                            phi_3221_ = _e647;
                        } else {
                            phi_3431_ = _e633;
                            phi_1017_ = type_37();
                            phi_1020_ = bool();
                            phi_1022_ = u32();
                            phi_1024_ = u32();
                            phi_1026_ = type_48();
                            phi_3221_ = false;
                        }
                        let _e1668 = phi_3431_;
                        let _e1670 = phi_1017_;
                        let _e1672 = phi_1020_;
                        let _e1674 = phi_1022_;
                        let _e1676 = phi_1024_;
                        let _e1678 = phi_1026_;
                        let _e1680 = phi_3221_;
                        continue;
                        continuing {
                            phi_3279_ = _e1668;
                            phi_1016_ = _e1670;
                            phi_1019_ = _e1672;
                            phi_1021_ = _e1674;
                            phi_1023_ = _e1676;
                            phi_1025_ = _e1678;
                            phi_3430_ = _e1668;
                            break if !(_e1680);
                        }
                    }
                    let _e1683 = phi_3430_;
                    if _e1683 {
                        break;
                    }
                    let _e1685 = local_11;
                    if _e134 {
                    } else {
                        break;
                    }
                    global_5.member[_e132] = select(0u, 1u, _e1685.member_1);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_any_printed_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
