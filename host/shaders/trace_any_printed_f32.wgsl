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
    var phi_3282_: bool;
    var phi_1016_: type_37;
    var phi_1019_: u32;
    var phi_1021_: bool;
    var phi_1023_: u32;
    var phi_1025_: type_48;
    var phi_1036_: bool;
    var phi_1122_: bool;
    var phi_1123_: u32;
    var phi_1124_: type_48;
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
    var phi_3276_: bool;
    var phi_3492_: bool;
    var phi_2193_: type_37;
    var phi_2214_: type_41;
    var phi_3100_: type_48;
    var phi_3176_: type_48;
    var phi_3177_: u32;
    var phi_3178_: type_48;
    var phi_3180_: u32;
    var phi_3181_: type_48;
    var phi_3182_: bool;
    var phi_3189_: type_48;
    var phi_3194_: bool;
    var phi_3196_: type_48;
    var phi_3200_: bool;
    var phi_3201_: u32;
    var phi_3202_: type_48;
    var phi_3212_: u32;
    var phi_3213_: type_48;
    var phi_3436_: bool;
    var phi_3214_: type_37;
    var phi_3215_: u32;
    var phi_3216_: bool;
    var phi_3217_: u32;
    var phi_3218_: type_48;
    var phi_3435_: bool;
    var phi_3219_: type_37;
    var phi_3220_: u32;
    var phi_3221_: bool;
    var phi_3222_: u32;
    var phi_3223_: type_48;
    var phi_3434_: bool;
    var phi_1017_: type_37;
    var phi_1020_: u32;
    var phi_1022_: bool;
    var phi_1024_: u32;
    var phi_1026_: type_48;
    var phi_3224_: bool;
    var phi_3433_: bool;
    var local_10: type_37;
    var local_11: type_37;

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
                    phi_3282_ = false;
                    phi_1016_ = type_37(_e599, false);
                    phi_1019_ = ((3u * _e84) + 1u);
                    phi_1021_ = (_e601 <= _e599);
                    phi_1023_ = 0u;
                    phi_1025_ = type_48(type_46(array<f32, 3>(_e609, _e613, _e617), array<f32, 3>(_e621, _e623, _e625)), select(0u, 2147483648u, (_e84 == 0u)));
                    loop {
                        let _e633 = phi_3282_;
                        let _e635 = phi_1016_;
                        let _e637 = phi_1019_;
                        let _e639 = phi_1021_;
                        let _e641 = phi_1023_;
                        let _e643 = phi_1025_;
                        local_10 = _e635;
                        if _e639 {
                            phi_1036_ = true;
                        } else {
                            phi_1036_ = (_e641 > 0u);
                        }
                        let _e646 = phi_1036_;
                        if _e646 {
                            let _e647 = (_e637 > 0u);
                            if _e647 {
                                if _e639 {
                                    phi_1122_ = _e639;
                                    phi_1123_ = _e641;
                                    phi_1124_ = _e643;
                                } else {
                                    let _e648 = (_e641 - 1u);
                                    let _e649 = (_e648 % 128u);
                                    let _e650 = (_e649 < 128u);
                                    if _e650 {
                                    } else {
                                        phi_3433_ = true;
                                        break;
                                    }
                                    let _e652 = local_6[_e649];
                                    if _e650 {
                                    } else {
                                        phi_3433_ = true;
                                        break;
                                    }
                                    let _e654 = local_5[_e649];
                                    if _e650 {
                                    } else {
                                        phi_3433_ = true;
                                        break;
                                    }
                                    let _e656 = local_4[_e649];
                                    if _e650 {
                                    } else {
                                        phi_3433_ = true;
                                        break;
                                    }
                                    let _e658 = local_3[_e649];
                                    if _e650 {
                                    } else {
                                        phi_3433_ = true;
                                        break;
                                    }
                                    let _e661 = local_2[_e649];
                                    if _e650 {
                                    } else {
                                        phi_3433_ = true;
                                        break;
                                    }
                                    let _e663 = local_1[_e649];
                                    if _e650 {
                                    } else {
                                        phi_3433_ = true;
                                        break;
                                    }
                                    let _e665 = local[_e649];
                                    if _e650 {
                                    } else {
                                        phi_3433_ = true;
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
                                    let _e682 = ((_e678.member_1 & 2147483648u) != 0u);
                                    if _e682 {
                                        phi_1142_ = _e635;
                                        phi_1145_ = type_7(0u, ((_e678.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e689 = phi_1142_;
                                            let _e691 = phi_1145_;
                                            local_11 = _e689;
                                            if (_e691.member < _e691.member_1) {
                                                phi_1146_ = type_7((_e691.member + 1u), _e691.member_1);
                                                phi_1168_ = type_7(1u, _e691.member);
                                            } else {
                                                phi_1146_ = _e691;
                                                phi_1168_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e704 = phi_1146_;
                                            let _e706 = phi_1168_;
                                            let _e710 = (bitcast<i32>(_e706.member) != 0i);
                                            if _e710 {
                                                let _e711 = ((_e678.member_1 & 268435455u) + _e706.member_1);
                                                let _e712 = (_e711 < _e86);
                                                if _e712 {
                                                    if _e712 {
                                                    } else {
                                                        phi_3276_ = true;
                                                        break;
                                                    }
                                                    let _e716 = global_2.member[_e711].member_1;
                                                    phi_1189_ = _e716;
                                                } else {
                                                    phi_1189_ = 4294967295u;
                                                }
                                                let _e718 = phi_1189_;
                                                if (_e711 >= _e86) {
                                                    phi_1281_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e712 {
                                                    } else {
                                                        phi_3276_ = true;
                                                        break;
                                                    }
                                                    if (_e606 < 9u) {
                                                    } else {
                                                        phi_3276_ = true;
                                                        break;
                                                    }
                                                    let _e725 = global_2.member[_e711].member[_e606];
                                                    if (_e610 < 9u) {
                                                    } else {
                                                        phi_3276_ = true;
                                                        break;
                                                    }
                                                    let _e731 = global_2.member[_e711].member[_e610];
                                                    if (_e614 < 9u) {
                                                    } else {
                                                        phi_3276_ = true;
                                                        break;
                                                    }
                                                    let _e737 = global_2.member[_e711].member[_e614];
                                                    let _e739 = (3u + _e606);
                                                    if (_e739 < 9u) {
                                                    } else {
                                                        phi_3276_ = true;
                                                        break;
                                                    }
                                                    let _e745 = global_2.member[_e711].member[_e739];
                                                    let _e746 = (3u + _e610);
                                                    if (_e746 < 9u) {
                                                    } else {
                                                        phi_3276_ = true;
                                                        break;
                                                    }
                                                    let _e752 = global_2.member[_e711].member[_e746];
                                                    let _e753 = (3u + _e614);
                                                    if (_e753 < 9u) {
                                                    } else {
                                                        phi_3276_ = true;
                                                        break;
                                                    }
                                                    let _e759 = global_2.member[_e711].member[_e753];
                                                    let _e761 = (6u + _e606);
                                                    if (_e761 < 9u) {
                                                    } else {
                                                        phi_3276_ = true;
                                                        break;
                                                    }
                                                    let _e767 = global_2.member[_e711].member[_e761];
                                                    let _e768 = (6u + _e610);
                                                    if (_e768 < 9u) {
                                                    } else {
                                                        phi_3276_ = true;
                                                        break;
                                                    }
                                                    let _e774 = global_2.member[_e711].member[_e768];
                                                    let _e775 = (6u + _e614);
                                                    if (_e775 < 9u) {
                                                    } else {
                                                        phi_3276_ = true;
                                                        break;
                                                    }
                                                    let _e781 = global_2.member[_e711].member[_e775];
                                                    phi_1281_ = array<array<f32, 3>, 3>(array<f32, 3>(_e725, _e731, _e737), array<f32, 3>(_e745, _e752, _e759), array<f32, 3>(_e767, _e774, _e781));
                                                }
                                                let _e785 = phi_1281_;
                                                let _e793 = (_e785[0][2] - _e447);
                                                let _e796 = (((_e785[0][0] - _e310) * _e486) - (_e793 * _e350));
                                                let _e799 = (((_e785[0][1] - _e379) * _e486) - (_e793 * _e418));
                                                let _e806 = (_e785[1][2] - _e447);
                                                let _e809 = (((_e785[1][0] - _e310) * _e486) - (_e806 * _e350));
                                                let _e812 = (((_e785[1][1] - _e379) * _e486) - (_e806 * _e418));
                                                let _e819 = (_e785[2][2] - _e447);
                                                let _e822 = (((_e785[2][0] - _e310) * _e486) - (_e819 * _e350));
                                                let _e825 = (((_e785[2][1] - _e379) * _e486) - (_e819 * _e418));
                                                let _e826 = (_e822 * _e812);
                                                let _e827 = (_e825 * _e809);
                                                let _e828 = (_e796 * _e825);
                                                let _e829 = (_e799 * _e822);
                                                let _e830 = (_e809 * _e799);
                                                let _e831 = (_e812 * _e796);
                                                let _e836 = (((_e826 >= _e827) && (_e828 >= _e829)) && (_e830 >= _e831));
                                                if (_e836 || (((_e826 <= _e827) && (_e828 <= _e829)) && (_e830 <= _e831))) {
                                                    let _e843 = select(-1f, 1f, _e836);
                                                    let _e845 = ((_e826 - _e827) * _e843);
                                                    let _e847 = select(0f, _e845, (_e845 > 0f));
                                                    let _e849 = ((_e828 - _e829) * _e843);
                                                    let _e851 = select(0f, _e849, (_e849 > 0f));
                                                    let _e853 = ((_e830 - _e831) * _e843);
                                                    let _e855 = select(0f, _e853, (_e853 > 0f));
                                                    let _e857 = ((_e847 + _e851) + _e855);
                                                    if (_e857 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2165_ = type_25();
                                                        phi_2166_ = true;
                                                        phi_2167_ = false;
                                                    } else {
                                                        let _e860 = select(_e809, _e796, (_e796 < _e809));
                                                        if (select(_e822, _e860, (_e860 < _e822)) > 0f) {
                                                            phi_1433_ = true;
                                                        } else {
                                                            let _e865 = select(_e809, _e796, (_e796 > _e809));
                                                            phi_1433_ = (select(_e822, _e865, (_e865 > _e822)) < 0f);
                                                        }
                                                        let _e870 = phi_1433_;
                                                        if _e870 {
                                                            phi_2162_ = type_25();
                                                            phi_2163_ = true;
                                                            phi_2164_ = false;
                                                        } else {
                                                            let _e872 = select(_e812, _e799, (_e799 < _e812));
                                                            if (select(_e825, _e872, (_e872 < _e825)) > 0f) {
                                                                phi_1462_ = true;
                                                            } else {
                                                                let _e877 = select(_e812, _e799, (_e799 > _e812));
                                                                phi_1462_ = (select(_e825, _e877, (_e877 > _e825)) < 0f);
                                                            }
                                                            let _e882 = phi_1462_;
                                                            if _e882 {
                                                                phi_2160_ = type_25();
                                                                phi_2161_ = false;
                                                            } else {
                                                                let _e884 = select(_e785[1][0], _e785[0][0], (_e785[0][0] < _e785[1][0]));
                                                                let _e888 = select(_e785[1][0], _e785[0][0], (_e785[0][0] > _e785[1][0]));
                                                                let _e892 = select(_e785[1][1], _e785[0][1], (_e785[0][1] < _e785[1][1]));
                                                                let _e896 = select(_e785[1][1], _e785[0][1], (_e785[0][1] > _e785[1][1]));
                                                                let _e900 = select(_e785[1][2], _e785[0][2], (_e785[0][2] < _e785[1][2]));
                                                                let _e904 = select(_e785[1][2], _e785[0][2], (_e785[0][2] > _e785[1][2]));
                                                                let _e909 = ((select(_e785[2][0], _e884, (_e884 < _e785[2][0])) - _e348) * _e353);
                                                                let _e910 = ((select(_e785[2][0], _e888, (_e888 > _e785[2][0])) - _e349) * _e353);
                                                                let _e913 = ((select(_e785[2][1], _e892, (_e892 < _e785[2][1])) - _e416) * _e421);
                                                                let _e914 = ((select(_e785[2][1], _e896, (_e896 > _e785[2][1])) - _e417) * _e421);
                                                                let _e917 = ((select(_e785[2][2], _e900, (_e900 < _e785[2][2])) - _e484) * _e489);
                                                                let _e918 = ((select(_e785[2][2], _e904, (_e904 > _e785[2][2])) - _e485) * _e489);
                                                                let _e920 = select(_e918, _e917, (_e917 < _e918));
                                                                let _e922 = select(_e918, _e917, (_e917 > _e918));
                                                                let _e924 = select(_e910, _e909, (_e909 < _e910));
                                                                let _e926 = select(_e914, _e913, (_e913 < _e914));
                                                                let _e928 = select(_e926, _e924, (_e924 > _e926));
                                                                let _e930 = select(_e920, _e928, (_e928 > _e920));
                                                                let _e932 = select(_e910, _e909, (_e909 > _e910));
                                                                let _e934 = select(_e914, _e913, (_e913 > _e914));
                                                                let _e936 = select(_e934, _e932, (_e932 < _e934));
                                                                let _e938 = select(_e922, _e936, (_e936 < _e922));
                                                                let _e939 = -(_e920);
                                                                let _e945 = select(_e601, _e930, (_e930 > _e601));
                                                                if (_e945 > (_e938 + (select(_e939, _e922, (_e922 > _e939)) * 0.0000019073523f))) {
                                                                    phi_2155_ = type_25();
                                                                    phi_2156_ = true;
                                                                } else {
                                                                    let _e947 = (_e945 > _e689.member);
                                                                    if _e947 {
                                                                        phi_2154_ = type_25();
                                                                    } else {
                                                                        let _e948 = vec3<f32>(_e785[0][0], _e785[0][1], _e785[0][2]);
                                                                        let _e949 = vec3<f32>(_e785[1][0], _e785[1][1], _e785[1][2]);
                                                                        let _e950 = vec3<f32>(_e785[2][0], _e785[2][1], _e785[2][2]);
                                                                        let _e951 = (_e785[1][0] - _e785[0][0]);
                                                                        let _e952 = (_e785[1][1] - _e785[0][1]);
                                                                        let _e953 = (_e785[1][2] - _e785[0][2]);
                                                                        let _e954 = vec3<f32>(_e951, _e952, _e953);
                                                                        let _e955 = (_e785[2][0] - _e785[1][0]);
                                                                        let _e956 = (_e785[2][1] - _e785[1][1]);
                                                                        let _e957 = (_e785[2][2] - _e785[1][2]);
                                                                        let _e958 = vec3<f32>(_e955, _e956, _e957);
                                                                        let _e959 = (_e785[0][0] - _e785[2][0]);
                                                                        let _e960 = (_e785[0][1] - _e785[2][1]);
                                                                        let _e961 = (_e785[0][2] - _e785[2][2]);
                                                                        let _e962 = vec3<f32>(_e959, _e960, _e961);
                                                                        let _e965 = bitcast<f32>((bitcast<u32>(_e951) & 2147483647u));
                                                                        let _e968 = bitcast<f32>((bitcast<u32>(_e952) & 2147483647u));
                                                                        let _e970 = select(_e968, _e965, (_e965 > _e968));
                                                                        let _e973 = bitcast<f32>((bitcast<u32>(_e953) & 2147483647u));
                                                                        let _e975 = select(_e973, _e970, (_e970 > _e973));
                                                                        let _e978 = bitcast<f32>((bitcast<u32>(_e955) & 2147483647u));
                                                                        let _e981 = bitcast<f32>((bitcast<u32>(_e956) & 2147483647u));
                                                                        let _e983 = select(_e981, _e978, (_e978 > _e981));
                                                                        let _e986 = bitcast<f32>((bitcast<u32>(_e957) & 2147483647u));
                                                                        let _e988 = select(_e986, _e983, (_e983 > _e986));
                                                                        let _e991 = bitcast<f32>((bitcast<u32>(_e959) & 2147483647u));
                                                                        let _e994 = bitcast<f32>((bitcast<u32>(_e960) & 2147483647u));
                                                                        let _e996 = select(_e994, _e991, (_e991 > _e994));
                                                                        let _e999 = bitcast<f32>((bitcast<u32>(_e961) & 2147483647u));
                                                                        let _e1001 = select(_e999, _e996, (_e996 > _e999));
                                                                        let _e1003 = select(_e988, _e975, (_e975 > _e988));
                                                                        let _e1005 = select(_e1001, _e1003, (_e1003 > _e1001));
                                                                        if (_e975 == _e1005) {
                                                                            phi_1881_ = _e812;
                                                                            phi_1882_ = _e809;
                                                                            phi_1883_ = _e799;
                                                                            phi_1884_ = _e796;
                                                                            phi_1885_ = _e948;
                                                                            phi_1886_ = _e962;
                                                                            phi_1887_ = _e958;
                                                                            phi_1888_ = _e954;
                                                                        } else {
                                                                            let _e1007 = (_e988 == _e1005);
                                                                            let _e1012 = vec3(_e1007);
                                                                            phi_1881_ = select(_e799, _e825, _e1007);
                                                                            phi_1882_ = select(_e796, _e822, _e1007);
                                                                            phi_1883_ = select(_e825, _e812, _e1007);
                                                                            phi_1884_ = select(_e822, _e809, _e1007);
                                                                            phi_1885_ = select(_e950, _e949, _e1012);
                                                                            phi_1886_ = select(_e958, _e954, _e1012);
                                                                            phi_1887_ = select(_e954, _e962, _e1012);
                                                                            phi_1888_ = select(_e962, _e958, _e1012);
                                                                        }
                                                                        let _e1018 = phi_1881_;
                                                                        let _e1020 = phi_1882_;
                                                                        let _e1022 = phi_1883_;
                                                                        let _e1024 = phi_1884_;
                                                                        let _e1026 = phi_1885_;
                                                                        let _e1028 = phi_1886_;
                                                                        let _e1030 = phi_1887_;
                                                                        let _e1032 = phi_1888_;
                                                                        let _e1039 = ((_e1030.y * _e1028.z) - (_e1028.y * _e1030.z));
                                                                        let _e1044 = ((_e1030.z * _e1028.x) - (_e1028.z * _e1030.x));
                                                                        let _e1047 = ((_e1030.x * _e1028.y) - (_e1028.x * _e1030.y));
                                                                        if (_e847 >= _e851) {
                                                                            phi_1925_ = select(true, false, (_e847 >= _e855));
                                                                        } else {
                                                                            phi_1925_ = true;
                                                                        }
                                                                        let _e1052 = phi_1925_;
                                                                        if _e1052 {
                                                                            phi_1934_ = select(_e950, _e949, vec3((_e851 >= _e855)));
                                                                        } else {
                                                                            phi_1934_ = _e948;
                                                                        }
                                                                        let _e1057 = phi_1934_;
                                                                        let _e1068 = (((_e1039 * (_e1057.x - _e310)) + (_e1044 * (_e1057.y - _e379))) + (_e1047 * (_e1057.z - _e447)));
                                                                        let _e1073 = (((_e1039 * _e350) + (_e1044 * _e418)) + (_e1047 * _e486));
                                                                        let _e1074 = (_e1020 - _e1024);
                                                                        let _e1075 = (_e1018 - _e1022);
                                                                        let _e1083 = (-(((_e1024 * _e1074) + (_e1022 * _e1075))) / ((_e1074 * _e1074) + (_e1075 * _e1075)));
                                                                        let _e1085 = select(1f, _e1083, (_e1083 < 1f));
                                                                        let _e1087 = select(0f, _e1085, (_e1085 > 0f));
                                                                        let _e1100 = ((_e1026.x + (_e1032.x * _e1087)) - _e310);
                                                                        let _e1101 = ((_e1026.y + (_e1032.y * _e1087)) - _e379);
                                                                        let _e1102 = ((_e1026.z + (_e1032.z * _e1087)) - _e447);
                                                                        let _e1103 = (_e1102 / _e486);
                                                                        let _e1115 = bitcast<f32>((bitcast<u32>(_e1100) & 2147483647u));
                                                                        let _e1118 = bitcast<f32>((bitcast<u32>(_e1101) & 2147483647u));
                                                                        let _e1120 = select(_e1118, _e1115, (_e1115 > _e1118));
                                                                        let _e1123 = bitcast<f32>((bitcast<u32>(_e1102) & 2147483647u));
                                                                        let _e1125 = select(_e1123, _e1120, (_e1120 > _e1123));
                                                                        let _e1131 = bitcast<f32>((bitcast<u32>(_e1039) & 2147483647u));
                                                                        let _e1134 = bitcast<f32>((bitcast<u32>(_e1044) & 2147483647u));
                                                                        let _e1136 = select(_e1134, _e1131, (_e1131 > _e1134));
                                                                        let _e1139 = bitcast<f32>((bitcast<u32>(_e1047) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1039 * _e1100) + (_e1044 * _e1101)) + (_e1047 * _e1102)) - _e1068)) & 2147483647u)) <= ((0.0000009536743f * select(_e1005, _e1125, (_e1125 > _e1005))) * select(_e1139, _e1136, (_e1136 > _e1139)))) {
                                                                            let _e1149 = bitcast<f32>((bitcast<u32>(_e1030.x) & 2147483647u));
                                                                            let _e1152 = bitcast<f32>((bitcast<u32>(_e1030.y) & 2147483647u));
                                                                            let _e1154 = select(_e1152, _e1149, (_e1149 > _e1152));
                                                                            let _e1157 = bitcast<f32>((bitcast<u32>(_e1030.z) & 2147483647u));
                                                                            let _e1163 = bitcast<f32>((bitcast<u32>(_e1028.x) & 2147483647u));
                                                                            let _e1166 = bitcast<f32>((bitcast<u32>(_e1028.y) & 2147483647u));
                                                                            let _e1168 = select(_e1166, _e1163, (_e1163 > _e1166));
                                                                            let _e1171 = bitcast<f32>((bitcast<u32>(_e1028.z) & 2147483647u));
                                                                            let _e1175 = (bitcast<f32>((bitcast<u32>(_e1073) & 2147483647u)) > ((0.0000038146973f * select(_e1157, _e1154, (_e1154 > _e1157))) * select(_e1171, _e1168, (_e1168 > _e1171))));
                                                                            if _e1175 {
                                                                                phi_2099_ = (_e1068 / _e1073);
                                                                            } else {
                                                                                phi_2099_ = f32();
                                                                            }
                                                                            let _e1178 = phi_2099_;
                                                                            phi_2101_ = _e1178;
                                                                            phi_2102_ = select(true, false, _e1175);
                                                                        } else {
                                                                            phi_2101_ = f32();
                                                                            phi_2102_ = true;
                                                                        }
                                                                        let _e1181 = phi_2101_;
                                                                        let _e1183 = phi_2102_;
                                                                        if _e1183 {
                                                                            let _e1191 = (((_e1039 * (_e1100 - (_e350 * _e1103))) + (_e1044 * (_e1101 - (_e418 * _e1103)))) / _e1073);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1191) & 2147483647u)) <= _e1005) {
                                                                                phi_2122_ = (_e1103 + _e1191);
                                                                            } else {
                                                                                phi_2122_ = _e1103;
                                                                            }
                                                                            let _e1198 = phi_2122_;
                                                                            phi_2123_ = _e1198;
                                                                        } else {
                                                                            phi_2123_ = _e1181;
                                                                        }
                                                                        let _e1200 = phi_2123_;
                                                                        let _e1202 = select(_e938, _e1200, (_e1200 < _e938));
                                                                        let _e1204 = select(_e930, _e1202, (_e1202 > _e930));
                                                                        if (_e1204 >= _e601) {
                                                                            let _e1206 = (_e1204 <= _e689.member);
                                                                            if _e1206 {
                                                                                let _e1207 = (1f / _e857);
                                                                                phi_2146_ = type_25(_e1204, (_e851 * _e1207), (_e855 * _e1207), _e718);
                                                                            } else {
                                                                                phi_2146_ = type_25();
                                                                            }
                                                                            let _e1212 = phi_2146_;
                                                                            phi_2148_ = _e1212;
                                                                            phi_2149_ = select(true, false, _e1206);
                                                                        } else {
                                                                            phi_2148_ = type_25();
                                                                            phi_2149_ = true;
                                                                        }
                                                                        let _e1215 = phi_2148_;
                                                                        let _e1217 = phi_2149_;
                                                                        if _e1217 {
                                                                            phi_2153_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2153_ = _e1215;
                                                                        }
                                                                        let _e1219 = phi_2153_;
                                                                        phi_2154_ = _e1219;
                                                                    }
                                                                    let _e1221 = phi_2154_;
                                                                    phi_2155_ = _e1221;
                                                                    phi_2156_ = _e947;
                                                                }
                                                                let _e1223 = phi_2155_;
                                                                let _e1225 = phi_2156_;
                                                                phi_2160_ = _e1223;
                                                                phi_2161_ = _e1225;
                                                            }
                                                            let _e1227 = phi_2160_;
                                                            let _e1229 = phi_2161_;
                                                            phi_2162_ = _e1227;
                                                            phi_2163_ = _e882;
                                                            phi_2164_ = _e1229;
                                                        }
                                                        let _e1231 = phi_2162_;
                                                        let _e1233 = phi_2163_;
                                                        let _e1235 = phi_2164_;
                                                        phi_2165_ = _e1231;
                                                        phi_2166_ = _e1233;
                                                        phi_2167_ = _e1235;
                                                    }
                                                    let _e1237 = phi_2165_;
                                                    let _e1239 = phi_2166_;
                                                    let _e1241 = phi_2167_;
                                                    phi_2175_ = _e1237;
                                                    phi_2176_ = select(_e1241, true, _e1239);
                                                } else {
                                                    phi_2175_ = type_25();
                                                    phi_2176_ = true;
                                                }
                                                let _e1244 = phi_2175_;
                                                let _e1246 = phi_2176_;
                                                if _e1246 {
                                                    phi_2180_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2180_ = _e1244;
                                                }
                                                let _e1248 = phi_2180_;
                                                if (_e1248.member_3 != 4294967295u) {
                                                    if (_e718 != 4294967295u) {
                                                        phi_2191_ = type_37(_e689.member, true);
                                                    } else {
                                                        phi_2191_ = _e689;
                                                    }
                                                    let _e1256 = phi_2191_;
                                                    phi_2192_ = _e1256;
                                                } else {
                                                    phi_2192_ = _e689;
                                                }
                                                let _e1258 = phi_2192_;
                                                phi_1143_ = _e1258;
                                            } else {
                                                phi_1143_ = type_37();
                                            }
                                            let _e1260 = phi_1143_;
                                            continue;
                                            continuing {
                                                phi_1142_ = _e1260;
                                                phi_1145_ = _e704;
                                                phi_3276_ = _e633;
                                                break if !(_e710);
                                            }
                                        }
                                        let _e1263 = phi_3276_;
                                        phi_3433_ = _e1263;
                                        if _e1263 {
                                            break;
                                        }
                                        phi_3492_ = _e1263;
                                        let _e1785 = local_11;
                                        phi_2193_ = _e1785;
                                    } else {
                                        phi_3492_ = _e633;
                                        phi_2193_ = _e635;
                                    }
                                    let _e1265 = phi_3492_;
                                    let _e1267 = phi_2193_;
                                    if _e682 {
                                        phi_3200_ = bool();
                                        phi_3201_ = u32();
                                        phi_3202_ = type_48();
                                    } else {
                                        let _e1268 = (_e678.member_1 < _e84);
                                        if _e1268 {
                                            if _e1268 {
                                            } else {
                                                phi_3433_ = true;
                                                break;
                                            }
                                            let _e1270 = global_6.member[_e678.member_1];
                                            phi_2214_ = _e1270;
                                        } else {
                                            phi_2214_ = type_41(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e1272 = phi_2214_;
                                        let _e1287 = ((10u * _e246) & 31u);
                                        let _e1290 = ((_e1272.member[0] >> bitcast<u32>(_e1287)) & 1023u);
                                        let _e1298 = bitcast<f32>((bitcast<u32>(((_e678.member.member_1[0] - _e678.member.member[0]) * 0.0009775171f)) ^ _e118));
                                        let _e1303 = (_e678.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1290)) - 8388608f) * _e1298)) ^ _e118)));
                                        let _e1307 = select(select(_e678.member.member_1[0], _e1303, (_e1303 < _e678.member.member_1[0])), _e678.member.member_1[0], (_e1290 == 1023u));
                                        let _e1309 = ((10u * _e245) & 31u);
                                        let _e1312 = ((_e1272.member[0] >> bitcast<u32>(_e1309)) & 1023u);
                                        let _e1320 = bitcast<f32>((bitcast<u32>(((_e678.member.member_1[1] - _e678.member.member[1]) * 0.0009775171f)) ^ _e118));
                                        let _e1325 = (_e678.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1312)) - 8388608f) * _e1320)) ^ _e118)));
                                        let _e1329 = select(select(_e678.member.member_1[1], _e1325, (_e1325 < _e678.member.member_1[1])), _e678.member.member_1[1], (_e1312 == 1023u));
                                        let _e1331 = ((10u * _e247) & 31u);
                                        let _e1334 = ((_e1272.member[0] >> bitcast<u32>(_e1331)) & 1023u);
                                        let _e1342 = bitcast<f32>((bitcast<u32>(((_e678.member.member_1[2] - _e678.member.member[2]) * 0.0009775171f)) ^ _e118));
                                        let _e1347 = (_e678.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1334)) - 8388608f) * _e1342)) ^ _e118)));
                                        let _e1351 = select(select(_e678.member.member_1[2], _e1347, (_e1347 < _e678.member.member_1[2])), _e678.member.member_1[2], (_e1334 == 1023u));
                                        let _e1354 = ((_e1272.member[1] >> bitcast<u32>(_e1287)) & 1023u);
                                        let _e1362 = (_e678.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1354)) - 8388608f) * _e1298)) ^ _e118)));
                                        let _e1366 = select(select(_e678.member.member_1[0], _e1362, (_e1362 < _e678.member.member_1[0])), _e678.member.member_1[0], (_e1354 == 1023u));
                                        let _e1369 = ((_e1272.member[1] >> bitcast<u32>(_e1309)) & 1023u);
                                        let _e1377 = (_e678.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1369)) - 8388608f) * _e1320)) ^ _e118)));
                                        let _e1381 = select(select(_e678.member.member_1[1], _e1377, (_e1377 < _e678.member.member_1[1])), _e678.member.member_1[1], (_e1369 == 1023u));
                                        let _e1384 = ((_e1272.member[1] >> bitcast<u32>(_e1331)) & 1023u);
                                        let _e1392 = (_e678.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1384)) - 8388608f) * _e1342)) ^ _e118)));
                                        let _e1396 = select(select(_e678.member.member_1[2], _e1392, (_e1392 < _e678.member.member_1[2])), _e678.member.member_1[2], (_e1384 == 1023u));
                                        let _e1402 = ((_e1272.member_1[0] >> bitcast<u32>(_e1287)) & 1023u);
                                        let _e1410 = (_e678.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1402)) - 8388608f) * _e1298)) ^ _e118)));
                                        let _e1414 = select(select(_e678.member.member_1[0], _e1410, (_e1410 < _e678.member.member_1[0])), _e678.member.member_1[0], (_e1402 == 1023u));
                                        let _e1417 = ((_e1272.member_1[0] >> bitcast<u32>(_e1309)) & 1023u);
                                        let _e1425 = (_e678.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1417)) - 8388608f) * _e1320)) ^ _e118)));
                                        let _e1429 = select(select(_e678.member.member_1[1], _e1425, (_e1425 < _e678.member.member_1[1])), _e678.member.member_1[1], (_e1417 == 1023u));
                                        let _e1432 = ((_e1272.member_1[0] >> bitcast<u32>(_e1331)) & 1023u);
                                        let _e1440 = (_e678.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1432)) - 8388608f) * _e1342)) ^ _e118)));
                                        let _e1444 = select(select(_e678.member.member_1[2], _e1440, (_e1440 < _e678.member.member_1[2])), _e678.member.member_1[2], (_e1432 == 1023u));
                                        let _e1447 = ((_e1272.member_1[1] >> bitcast<u32>(_e1287)) & 1023u);
                                        let _e1455 = (_e678.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1447)) - 8388608f) * _e1298)) ^ _e118)));
                                        let _e1459 = select(select(_e678.member.member_1[0], _e1455, (_e1455 < _e678.member.member_1[0])), _e678.member.member_1[0], (_e1447 == 1023u));
                                        let _e1462 = ((_e1272.member_1[1] >> bitcast<u32>(_e1309)) & 1023u);
                                        let _e1470 = (_e678.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1462)) - 8388608f) * _e1320)) ^ _e118)));
                                        let _e1474 = select(select(_e678.member.member_1[1], _e1470, (_e1470 < _e678.member.member_1[1])), _e678.member.member_1[1], (_e1462 == 1023u));
                                        let _e1477 = ((_e1272.member_1[1] >> bitcast<u32>(_e1331)) & 1023u);
                                        let _e1485 = (_e678.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1477)) - 8388608f) * _e1342)) ^ _e118)));
                                        let _e1489 = select(select(_e678.member.member_1[2], _e1485, (_e1485 < _e678.member.member_1[2])), _e678.member.member_1[2], (_e1477 == 1023u));
                                        let _e1494 = type_48(type_46(array<f32, 3>(_e1307, _e1329, _e1351), array<f32, 3>(_e1366, _e1381, _e1396)), _e1272.member_2);
                                        let _e1499 = type_48(type_46(array<f32, 3>(_e1414, _e1429, _e1444), array<f32, 3>(_e1459, _e1474, _e1489)), _e1272.member_3);
                                        let _e1505 = ((_e1307 - _e348) * _e353);
                                        let _e1506 = ((_e1414 - _e348) * _e353);
                                        let _e1507 = ((_e1366 - _e349) * _e353);
                                        let _e1508 = ((_e1459 - _e349) * _e353);
                                        let _e1513 = ((_e1329 - _e416) * _e421);
                                        let _e1514 = ((_e1429 - _e416) * _e421);
                                        let _e1515 = ((_e1381 - _e417) * _e421);
                                        let _e1516 = ((_e1474 - _e417) * _e421);
                                        let _e1521 = ((_e1351 - _e484) * _e489);
                                        let _e1522 = ((_e1444 - _e484) * _e489);
                                        let _e1523 = ((_e1396 - _e485) * _e489);
                                        let _e1524 = ((_e1489 - _e485) * _e489);
                                        let _e1526 = select(_e1523, _e1521, (_e1521 < _e1523));
                                        let _e1528 = select(_e1524, _e1522, (_e1522 < _e1524));
                                        let _e1530 = select(_e1523, _e1521, (_e1521 > _e1523));
                                        let _e1532 = select(_e1524, _e1522, (_e1522 > _e1524));
                                        let _e1534 = select(_e1507, _e1505, (_e1505 < _e1507));
                                        let _e1536 = select(_e1508, _e1506, (_e1506 < _e1508));
                                        let _e1538 = select(_e1515, _e1513, (_e1513 < _e1515));
                                        let _e1540 = select(_e1516, _e1514, (_e1514 < _e1516));
                                        let _e1542 = select(_e1538, _e1534, (_e1534 > _e1538));
                                        let _e1544 = select(_e1540, _e1536, (_e1536 > _e1540));
                                        let _e1546 = select(_e1526, _e1542, (_e1542 > _e1526));
                                        let _e1548 = select(_e1528, _e1544, (_e1544 > _e1528));
                                        let _e1550 = select(_e1507, _e1505, (_e1505 > _e1507));
                                        let _e1552 = select(_e1508, _e1506, (_e1506 > _e1508));
                                        let _e1554 = select(_e1515, _e1513, (_e1513 > _e1515));
                                        let _e1556 = select(_e1516, _e1514, (_e1514 > _e1516));
                                        let _e1558 = select(_e1554, _e1550, (_e1550 < _e1554));
                                        let _e1560 = select(_e1556, _e1552, (_e1552 < _e1556));
                                        let _e1565 = -(_e1526);
                                        let _e1566 = -(_e1528);
                                        let _e1573 = (select(_e1530, _e1558, (_e1558 < _e1530)) + (select(_e1565, _e1530, (_e1530 > _e1565)) * 0.0000019073523f));
                                        let _e1574 = (select(_e1532, _e1560, (_e1560 < _e1532)) + (select(_e1566, _e1532, (_e1532 > _e1566)) * 0.0000019073523f));
                                        let _e1576 = select(_e601, _e1546, (_e1546 > _e601));
                                        let _e1578 = select(_e601, _e1548, (_e1548 > _e601));
                                        let _e1583 = (_e1576 <= select(_e1267.member, _e1573, (_e1573 < _e1267.member)));
                                        let _e1584 = (_e1578 <= select(_e1267.member, _e1574, (_e1574 < _e1267.member)));
                                        let _e1585 = (_e1576 <= _e1578);
                                        if _e1583 {
                                            if _e1584 {
                                                if _e1585 {
                                                    phi_3100_ = _e1499;
                                                } else {
                                                    phi_3100_ = _e1494;
                                                }
                                                let _e1587 = phi_3100_;
                                                let _e1594 = (_e676 % 128u);
                                                let _e1595 = (_e1594 < 128u);
                                                if _e1595 {
                                                } else {
                                                    phi_3433_ = true;
                                                    break;
                                                }
                                                local_6[_e1594] = _e1587.member_1;
                                                if _e1595 {
                                                } else {
                                                    phi_3433_ = true;
                                                    break;
                                                }
                                                local_5[_e1594] = _e1587.member.member[0];
                                                if _e1595 {
                                                } else {
                                                    phi_3433_ = true;
                                                    break;
                                                }
                                                local_4[_e1594] = _e1587.member.member[1];
                                                if _e1595 {
                                                } else {
                                                    phi_3433_ = true;
                                                    break;
                                                }
                                                local_3[_e1594] = _e1587.member.member[2];
                                                if _e1595 {
                                                } else {
                                                    phi_3433_ = true;
                                                    break;
                                                }
                                                local_2[_e1594] = _e1587.member.member_1[0];
                                                if _e1595 {
                                                } else {
                                                    phi_3433_ = true;
                                                    break;
                                                }
                                                local_1[_e1594] = _e1587.member.member_1[1];
                                                if _e1595 {
                                                } else {
                                                    phi_3433_ = true;
                                                    break;
                                                }
                                                local[_e1594] = _e1587.member.member_1[2];
                                                if _e1595 {
                                                } else {
                                                    phi_3433_ = true;
                                                    break;
                                                }
                                                local_7[_e1594] = select(_e1576, _e1578, _e1585);
                                                if _e1585 {
                                                    phi_3176_ = _e1494;
                                                } else {
                                                    phi_3176_ = _e1499;
                                                }
                                                let _e1612 = phi_3176_;
                                                phi_3177_ = (_e676 + 1u);
                                                phi_3178_ = _e1612;
                                            } else {
                                                phi_3177_ = u32();
                                                phi_3178_ = type_48();
                                            }
                                            let _e1614 = phi_3177_;
                                            let _e1616 = phi_3178_;
                                            phi_3180_ = _e1614;
                                            phi_3181_ = _e1616;
                                            phi_3182_ = select(true, false, _e1584);
                                        } else {
                                            phi_3180_ = u32();
                                            phi_3181_ = type_48();
                                            phi_3182_ = true;
                                        }
                                        let _e1619 = phi_3180_;
                                        let _e1621 = phi_3181_;
                                        let _e1623 = phi_3182_;
                                        if _e1623 {
                                            if _e1583 {
                                                phi_3189_ = _e1494;
                                            } else {
                                                phi_3189_ = _e1499;
                                            }
                                            let _e1625 = phi_3189_;
                                            phi_3194_ = select(_e1584, true, _e1583);
                                            phi_3196_ = _e1625;
                                        } else {
                                            phi_3194_ = _e674;
                                            phi_3196_ = _e1621;
                                        }
                                        let _e1628 = phi_3194_;
                                        let _e1630 = phi_3196_;
                                        phi_3200_ = _e1628;
                                        phi_3201_ = select(_e1619, _e676, _e1623);
                                        phi_3202_ = _e1630;
                                    }
                                    let _e1633 = phi_3200_;
                                    let _e1635 = phi_3201_;
                                    let _e1637 = phi_3202_;
                                    if _e682 {
                                        phi_3212_ = select(_e676, 0u, _e1267.member_1);
                                        phi_3213_ = _e678;
                                    } else {
                                        phi_3212_ = _e1635;
                                        phi_3213_ = _e1637;
                                    }
                                    let _e1641 = phi_3212_;
                                    let _e1643 = phi_3213_;
                                    phi_3436_ = _e1265;
                                    phi_3214_ = _e1267;
                                    phi_3215_ = (_e637 - 1u);
                                    phi_3216_ = select(_e1633, false, _e682);
                                    phi_3217_ = _e1641;
                                    phi_3218_ = _e1643;
                                } else {
                                    phi_3436_ = _e633;
                                    phi_3214_ = _e635;
                                    phi_3215_ = _e637;
                                    phi_3216_ = _e674;
                                    phi_3217_ = _e676;
                                    phi_3218_ = _e678;
                                }
                                let _e1646 = phi_3436_;
                                let _e1648 = phi_3214_;
                                let _e1650 = phi_3215_;
                                let _e1652 = phi_3216_;
                                let _e1654 = phi_3217_;
                                let _e1656 = phi_3218_;
                                phi_3435_ = _e1646;
                                phi_3219_ = _e1648;
                                phi_3220_ = _e1650;
                                phi_3221_ = _e1652;
                                phi_3222_ = _e1654;
                                phi_3223_ = _e1656;
                            } else {
                                phi_3435_ = _e633;
                                phi_3219_ = type_37();
                                phi_3220_ = u32();
                                phi_3221_ = bool();
                                phi_3222_ = u32();
                                phi_3223_ = type_48();
                            }
                            let _e1658 = phi_3435_;
                            let _e1660 = phi_3219_;
                            let _e1662 = phi_3220_;
                            let _e1664 = phi_3221_;
                            let _e1666 = phi_3222_;
                            let _e1668 = phi_3223_;
                            phi_3434_ = _e1658;
                            phi_1017_ = _e1660;
                            phi_1020_ = _e1662;
                            phi_1022_ = _e1664;
                            phi_1024_ = _e1666;
                            phi_1026_ = _e1668;
                            phi_3224_ = _e647;
                        } else {
                            phi_3434_ = _e633;
                            phi_1017_ = type_37();
                            phi_1020_ = u32();
                            phi_1022_ = bool();
                            phi_1024_ = u32();
                            phi_1026_ = type_48();
                            phi_3224_ = false;
                        }
                        let _e1670 = phi_3434_;
                        let _e1672 = phi_1017_;
                        let _e1674 = phi_1020_;
                        let _e1676 = phi_1022_;
                        let _e1678 = phi_1024_;
                        let _e1680 = phi_1026_;
                        let _e1682 = phi_3224_;
                        continue;
                        continuing {
                            phi_3282_ = _e1670;
                            phi_1016_ = _e1672;
                            phi_1019_ = _e1674;
                            phi_1021_ = _e1676;
                            phi_1023_ = _e1678;
                            phi_1025_ = _e1680;
                            phi_3433_ = _e1670;
                            break if !(_e1682);
                        }
                    }
                    let _e1685 = phi_3433_;
                    if _e1685 {
                        break;
                    }
                    let _e1687 = local_10;
                    if _e134 {
                    } else {
                        break;
                    }
                    global_5.member[_e132] = select(0u, 1u, _e1687.member_1);
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
