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

struct type_27 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_28 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_31 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_33 {
    member: array<type_31>,
}

struct type_39 {
    member: type_27,
    member_1: f32,
}

struct type_44 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_46 {
    member: array<type_28>,
}

struct type_48 {
    member: type_39,
    member_1: u32,
    member_2: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(1) 
var<storage> global_2: type_33;
@group(0) @binding(2) 
var<storage> global_3: type_15;
@group(0) @binding(3) 
var<storage> global_4: type_46;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_21;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_269_: i32;
    var phi_270_: i32;
    var phi_280_: bool;
    var phi_290_: u32;
    var phi_291_: u32;
    var phi_293_: bool;
    var phi_298_: u32;
    var phi_310_: i32;
    var phi_330_: i32;
    var phi_348_: f32;
    var phi_354_: f32;
    var phi_365_: f32;
    var phi_371_: f32;
    var phi_394_: f32;
    var phi_405_: f32;
    var phi_414_: f32;
    var phi_420_: f32;
    var phi_431_: f32;
    var phi_437_: f32;
    var phi_460_: f32;
    var phi_471_: f32;
    var phi_480_: f32;
    var phi_486_: f32;
    var phi_497_: f32;
    var phi_503_: f32;
    var phi_526_: f32;
    var phi_537_: f32;
    var phi_637_: f32;
    var phi_638_: f32;
    var phi_1976_: bool;
    var phi_650_: type_48;
    var phi_653_: u32;
    var phi_655_: u32;
    var phi_657_: bool;
    var phi_659_: u32;
    var phi_670_: bool;
    var phi_702_: u32;
    var phi_703_: bool;
    var phi_704_: u32;
    var phi_1532_: type_44;
    var phi_1876_: u32;
    var phi_1904_: u32;
    var phi_1905_: u32;
    var phi_1906_: u32;
    var phi_1908_: u32;
    var phi_1909_: u32;
    var phi_1910_: bool;
    var phi_1919_: u32;
    var phi_1924_: u32;
    var phi_1925_: bool;
    var phi_719_: type_48;
    var phi_722_: type_4;
    var phi_723_: type_4;
    var phi_745_: type_4;
    var phi_769_: u32;
    var phi_858_: array<array<f32, 3>, 3>;
    var phi_1329_: vec3<f32>;
    var phi_1330_: vec3<f32>;
    var phi_1361_: bool;
    var phi_1370_: vec3<f32>;
    var phi_1410_: type_27;
    var phi_1412_: type_27;
    var phi_1413_: bool;
    var phi_1417_: type_27;
    var phi_1418_: type_27;
    var phi_1419_: type_27;
    var phi_1420_: bool;
    var phi_1424_: type_27;
    var phi_1425_: bool;
    var phi_1429_: type_27;
    var phi_1430_: bool;
    var phi_1434_: type_27;
    var phi_1459_: bool;
    var phi_1460_: bool;
    var phi_1467_: type_48;
    var phi_1468_: type_48;
    var phi_1469_: type_48;
    var phi_720_: type_48;
    var phi_1970_: bool;
    var phi_2088_: bool;
    var phi_1927_: type_48;
    var phi_1928_: u32;
    var phi_1929_: bool;
    var phi_1930_: u32;
    var phi_2087_: bool;
    var phi_1931_: type_48;
    var phi_1932_: u32;
    var phi_1933_: u32;
    var phi_1934_: bool;
    var phi_1935_: u32;
    var phi_2086_: bool;
    var phi_1936_: type_48;
    var phi_1937_: u32;
    var phi_1938_: u32;
    var phi_1939_: bool;
    var phi_1940_: u32;
    var phi_2085_: bool;
    var phi_651_: type_48;
    var phi_654_: u32;
    var phi_656_: u32;
    var phi_658_: bool;
    var phi_660_: u32;
    var phi_1941_: bool;
    var phi_2084_: bool;
    var local_2: type_48;
    var local_3: type_48;
    var local_4: type_48;

    switch bitcast<i32>(0u) {
        default: {
            let _e62 = global;
            let _e64 = arrayLength((&global_2.member));
            let _e66 = arrayLength((&global_3.member));
            let _e74 = (_e62.x + (_e62.y * 2097152u));
            let _e77 = global_1.member[0u];
            let _e78 = bitcast<i32>(_e77);
            let _e79 = (_e74 < arrayLength((&global_4.member)));
            if _e79 {
                let _e80 = (_e74 < arrayLength((&global_5.member)));
                if _e80 {
                    if _e79 {
                    } else {
                        break;
                    }
                    let _e88 = global_4.member[_e74].member_2[0u];
                    let _e90 = (bitcast<u32>(_e88) & 2147483647u);
                    let _e95 = global_4.member[_e74].member_2[1u];
                    let _e97 = (bitcast<u32>(_e95) & 2147483647u);
                    let _e102 = global_4.member[_e74].member_2[2u];
                    let _e104 = (bitcast<u32>(_e102) & 2147483647u);
                    let _e109 = global_4.member[_e74].member[0u];
                    let _e111 = (bitcast<u32>(_e109) & 2147483647u);
                    let _e116 = global_4.member[_e74].member[1u];
                    let _e118 = (bitcast<u32>(_e116) & 2147483647u);
                    let _e123 = global_4.member[_e74].member[2u];
                    let _e125 = (bitcast<u32>(_e123) & 2147483647u);
                    let _e127 = select(_e97, _e90, (_e97 < _e90));
                    let _e129 = select(_e104, _e127, (_e104 < _e127));
                    let _e131 = select(_e111, _e129, (_e111 < _e129));
                    let _e133 = select(_e118, _e131, (_e118 < _e131));
                    let _e135 = select(_e125, _e133, (_e125 < _e133));
                    let _e139 = global_4.member[_e74].member_1;
                    let _e141 = (bitcast<u32>(_e139) & 2147483647u);
                    let _e148 = global_4.member[_e74].member_3;
                    let _e154 = (((select(_e141, _e135, (_e141 < _e135)) < 2139095040u) && ((bitcast<u32>(_e148) & 2147483647u) <= 2139095040u)) && (_e129 > 0u));
                    if _e154 {
                        let _e157 = (bitcast<u32>(bitcast<f32>(_e129)) & 2147483647u);
                        if (_e157 >= 8388608u) {
                            phi_269_ = (bitcast<i32>((_e157 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_269_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e157)), 32u, (_e157 == 0u))));
                        }
                        let _e171 = phi_269_;
                        phi_270_ = _e171;
                    } else {
                        phi_270_ = 0i;
                    }
                    let _e173 = phi_270_;
                    let _e174 = (_e90 == _e129);
                    if _e174 {
                        phi_280_ = true;
                    } else {
                        phi_280_ = (_e97 == _e129);
                    }
                    let _e177 = phi_280_;
                    let _e178 = select(1u, 0u, _e174);
                    if _e177 {
                        let _e179 = (_e178 + 1u);
                        phi_290_ = _e179;
                        phi_291_ = _e179;
                        phi_293_ = select(true, false, (_e179 == 2u));
                    } else {
                        phi_290_ = u32();
                        phi_291_ = 0u;
                        phi_293_ = true;
                    }
                    let _e183 = phi_290_;
                    let _e185 = phi_291_;
                    let _e187 = phi_293_;
                    if _e187 {
                        phi_298_ = (_e185 + 1u);
                    } else {
                        phi_298_ = 0u;
                    }
                    let _e191 = phi_298_;
                    let _e192 = select(_e183, _e185, _e187);
                    let _e193 = select(_e178, select(2u, _e178, _e177), _e187);
                    if (_e78 < -126i) {
                        phi_310_ = -126i;
                    } else {
                        phi_310_ = select(_e78, 127i, (_e78 > 127i));
                    }
                    let _e198 = phi_310_;
                    let _e203 = bitcast<f32>((bitcast<u32>((_e198 + 127i)) << bitcast<u32>(23i)));
                    let _e209 = bitcast<f32>((bitcast<u32>(((_e78 - _e198) + 127i)) << bitcast<u32>(23i)));
                    let _e210 = -(_e173);
                    if (_e210 < -126i) {
                        phi_330_ = -126i;
                    } else {
                        phi_330_ = select(_e210, 127i, (_e210 > 127i));
                    }
                    let _e215 = phi_330_;
                    let _e220 = bitcast<f32>((bitcast<u32>((_e215 + 127i)) << bitcast<u32>(23i)));
                    let _e226 = bitcast<f32>((bitcast<u32>(((_e210 - _e215) + 127i)) << bitcast<u32>(23i)));
                    let _e230 = global_4.member[_e74].member;
                    let _e231 = (_e192 == 0u);
                    if _e231 {
                        phi_348_ = _e230[0];
                    } else {
                        phi_348_ = _e230[1];
                    }
                    let _e235 = phi_348_;
                    let _e236 = (_e192 == 2u);
                    if _e236 {
                        phi_354_ = _e230[2];
                    } else {
                        phi_354_ = _e235;
                    }
                    let _e239 = phi_354_;
                    let _e241 = ((_e239 * _e203) * _e209);
                    let _e242 = global_4.member[_e74].member_2;
                    if _e231 {
                        phi_365_ = _e242[0];
                    } else {
                        phi_365_ = _e242[1];
                    }
                    let _e246 = phi_365_;
                    if _e236 {
                        phi_371_ = _e242[2];
                    } else {
                        phi_371_ = _e246;
                    }
                    let _e249 = phi_371_;
                    let _e251 = ((_e249 * _e220) * _e226);
                    let _e255 = (bitcast<f32>((bitcast<u32>(_e251) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e255 {
                        let _e259 = (bitcast<f32>((bitcast<u32>(_e241) & 2147483647u)) * 0.00000011920929f);
                        phi_394_ = select(0.00000000000011368684f, _e259, (_e259 > 0.00000000000011368684f));
                    } else {
                        phi_394_ = 0f;
                    }
                    let _e263 = phi_394_;
                    let _e264 = (_e241 + _e263);
                    let _e265 = (_e241 - _e263);
                    let _e266 = select(_e251, 0f, _e255);
                    if _e255 {
                        phi_405_ = 38685626000000000000000000f;
                    } else {
                        phi_405_ = (1f / _e251);
                    }
                    let _e269 = phi_405_;
                    let _e270 = (_e191 == 0u);
                    if _e270 {
                        phi_414_ = _e230[0];
                    } else {
                        phi_414_ = _e230[1];
                    }
                    let _e274 = phi_414_;
                    let _e275 = (_e191 == 2u);
                    if _e275 {
                        phi_420_ = _e230[2];
                    } else {
                        phi_420_ = _e274;
                    }
                    let _e278 = phi_420_;
                    let _e280 = ((_e278 * _e203) * _e209);
                    if _e270 {
                        phi_431_ = _e242[0];
                    } else {
                        phi_431_ = _e242[1];
                    }
                    let _e284 = phi_431_;
                    if _e275 {
                        phi_437_ = _e242[2];
                    } else {
                        phi_437_ = _e284;
                    }
                    let _e287 = phi_437_;
                    let _e289 = ((_e287 * _e220) * _e226);
                    let _e293 = (bitcast<f32>((bitcast<u32>(_e289) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e293 {
                        let _e297 = (bitcast<f32>((bitcast<u32>(_e280) & 2147483647u)) * 0.00000011920929f);
                        phi_460_ = select(0.00000000000011368684f, _e297, (_e297 > 0.00000000000011368684f));
                    } else {
                        phi_460_ = 0f;
                    }
                    let _e301 = phi_460_;
                    let _e302 = (_e280 + _e301);
                    let _e303 = (_e280 - _e301);
                    let _e304 = select(_e289, 0f, _e293);
                    if _e293 {
                        phi_471_ = 38685626000000000000000000f;
                    } else {
                        phi_471_ = (1f / _e289);
                    }
                    let _e307 = phi_471_;
                    let _e308 = (_e193 == 0u);
                    if _e308 {
                        phi_480_ = _e230[0];
                    } else {
                        phi_480_ = _e230[1];
                    }
                    let _e312 = phi_480_;
                    let _e313 = (_e193 == 2u);
                    if _e313 {
                        phi_486_ = _e230[2];
                    } else {
                        phi_486_ = _e312;
                    }
                    let _e316 = phi_486_;
                    let _e318 = ((_e316 * _e203) * _e209);
                    if _e308 {
                        phi_497_ = _e242[0];
                    } else {
                        phi_497_ = _e242[1];
                    }
                    let _e322 = phi_497_;
                    if _e313 {
                        phi_503_ = _e242[2];
                    } else {
                        phi_503_ = _e322;
                    }
                    let _e325 = phi_503_;
                    let _e327 = ((_e325 * _e220) * _e226);
                    let _e331 = (bitcast<f32>((bitcast<u32>(_e327) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e331 {
                        let _e335 = (bitcast<f32>((bitcast<u32>(_e318) & 2147483647u)) * 0.00000011920929f);
                        phi_526_ = select(0.00000000000011368684f, _e335, (_e335 > 0.00000000000011368684f));
                    } else {
                        phi_526_ = 0f;
                    }
                    let _e339 = phi_526_;
                    let _e340 = (_e318 + _e339);
                    let _e341 = (_e318 - _e339);
                    let _e342 = select(_e327, 0f, _e331);
                    if _e331 {
                        phi_537_ = 38685626000000000000000000f;
                    } else {
                        phi_537_ = (1f / _e327);
                    }
                    let _e345 = phi_537_;
                    let _e348 = bitcast<f32>((bitcast<u32>(_e241) & 2147483647u));
                    let _e351 = bitcast<f32>((bitcast<u32>(_e280) & 2147483647u));
                    let _e353 = select(_e351, _e348, (_e348 > _e351));
                    let _e356 = bitcast<f32>((bitcast<u32>(_e318) & 2147483647u));
                    let _e359 = (_e78 + _e173);
                    if (_e154 && (select(_e356, _e353, (_e353 > _e356)) <= 1099511600000f)) {
                        let _e362 = (_e359 / 3i);
                        let _e369 = bitcast<f32>((bitcast<u32>((_e362 + 127i)) << bitcast<u32>(23i)));
                        let _e376 = bitcast<f32>((bitcast<u32>(((_e359 - (2i * _e362)) + 127i)) << bitcast<u32>(23i)));
                        let _e377 = (((_e139 * _e369) * _e369) * _e376);
                        let _e379 = select(340282350000000000000000000000000000000f, _e377, (_e377 < 340282350000000000000000000000000000000f));
                        let _e384 = (((_e148 * _e369) * _e369) * _e376);
                        let _e386 = select(340282350000000000000000000000000000000f, _e384, (_e384 < 340282350000000000000000000000000000000f));
                        phi_637_ = select(-340282350000000000000000000000000000000f, _e386, (_e386 > -340282350000000000000000000000000000000f));
                        phi_638_ = select(-340282350000000000000000000000000000000f, _e379, (_e379 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_637_ = 0f;
                        phi_638_ = 1f;
                    }
                    let _e390 = phi_637_;
                    let _e392 = phi_638_;
                    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_1976_ = false;
                    phi_650_ = type_48(type_39(type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e390), 0u, 0u);
                    phi_653_ = select(0u, 2147483648u, (_e64 == 0u));
                    phi_655_ = ((3u * _e64) + 1u);
                    phi_657_ = (_e392 <= _e390);
                    phi_659_ = 0u;
                    loop {
                        let _e401 = phi_1976_;
                        let _e403 = phi_650_;
                        let _e405 = phi_653_;
                        let _e407 = phi_655_;
                        let _e409 = phi_657_;
                        let _e411 = phi_659_;
                        local_2 = _e403;
                        local_3 = _e403;
                        if _e409 {
                            phi_670_ = true;
                        } else {
                            phi_670_ = (_e411 > 0u);
                        }
                        let _e414 = phi_670_;
                        if _e414 {
                            let _e415 = (_e407 > 0u);
                            if _e415 {
                                if _e409 {
                                    phi_702_ = _e405;
                                    phi_703_ = _e409;
                                    phi_704_ = _e411;
                                } else {
                                    let _e416 = (_e411 - 1u);
                                    let _e417 = (_e416 % 128u);
                                    let _e418 = (_e417 < 128u);
                                    if _e418 {
                                    } else {
                                        phi_2084_ = true;
                                        break;
                                    }
                                    let _e420 = local_1[_e417];
                                    if _e418 {
                                    } else {
                                        phi_2084_ = true;
                                        break;
                                    }
                                    let _e422 = local[_e417];
                                    phi_702_ = _e420;
                                    phi_703_ = (_e422 <= _e403.member.member_1);
                                    phi_704_ = _e416;
                                }
                                let _e427 = phi_702_;
                                let _e429 = phi_703_;
                                let _e431 = phi_704_;
                                if _e429 {
                                    if ((_e427 & 2147483648u) != 0u) {
                                        phi_719_ = _e403;
                                        phi_722_ = type_4(0u, ((_e427 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e636 = phi_719_;
                                            let _e638 = phi_722_;
                                            local_4 = _e636;
                                            if (_e638.member < _e638.member_1) {
                                                phi_723_ = type_4((_e638.member + 1u), _e638.member_1);
                                                phi_745_ = type_4(1u, _e638.member);
                                            } else {
                                                phi_723_ = _e638;
                                                phi_745_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e651 = phi_723_;
                                            let _e653 = phi_745_;
                                            let _e657 = (bitcast<i32>(_e653.member) != 0i);
                                            if _e657 {
                                                let _e663 = type_48(_e636.member, _e636.member_1, (_e636.member_2 + 1u));
                                                let _e664 = ((_e427 & 268435455u) + _e653.member_1);
                                                let _e665 = (_e664 < _e66);
                                                if _e665 {
                                                    if _e665 {
                                                    } else {
                                                        phi_1970_ = true;
                                                        break;
                                                    }
                                                    let _e669 = global_3.member[_e664].member_1;
                                                    phi_769_ = _e669;
                                                } else {
                                                    phi_769_ = 4294967295u;
                                                }
                                                let _e671 = phi_769_;
                                                if (_e664 >= _e66) {
                                                    phi_858_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e665 {
                                                    } else {
                                                        phi_1970_ = true;
                                                        break;
                                                    }
                                                    let _e673 = (_e192 % 3u);
                                                    let _e674 = (_e191 % 3u);
                                                    let _e675 = (_e193 % 3u);
                                                    if (_e673 < 9u) {
                                                    } else {
                                                        phi_1970_ = true;
                                                        break;
                                                    }
                                                    let _e681 = global_3.member[_e664].member[_e673];
                                                    if (_e674 < 9u) {
                                                    } else {
                                                        phi_1970_ = true;
                                                        break;
                                                    }
                                                    let _e687 = global_3.member[_e664].member[_e674];
                                                    if (_e675 < 9u) {
                                                    } else {
                                                        phi_1970_ = true;
                                                        break;
                                                    }
                                                    let _e693 = global_3.member[_e664].member[_e675];
                                                    let _e695 = (3u + _e673);
                                                    if (_e695 < 9u) {
                                                    } else {
                                                        phi_1970_ = true;
                                                        break;
                                                    }
                                                    let _e701 = global_3.member[_e664].member[_e695];
                                                    let _e702 = (3u + _e674);
                                                    if (_e702 < 9u) {
                                                    } else {
                                                        phi_1970_ = true;
                                                        break;
                                                    }
                                                    let _e708 = global_3.member[_e664].member[_e702];
                                                    let _e709 = (3u + _e675);
                                                    if (_e709 < 9u) {
                                                    } else {
                                                        phi_1970_ = true;
                                                        break;
                                                    }
                                                    let _e715 = global_3.member[_e664].member[_e709];
                                                    let _e717 = (6u + _e673);
                                                    if (_e717 < 9u) {
                                                    } else {
                                                        phi_1970_ = true;
                                                        break;
                                                    }
                                                    let _e723 = global_3.member[_e664].member[_e717];
                                                    let _e724 = (6u + _e674);
                                                    if (_e724 < 9u) {
                                                    } else {
                                                        phi_1970_ = true;
                                                        break;
                                                    }
                                                    let _e730 = global_3.member[_e664].member[_e724];
                                                    let _e731 = (6u + _e675);
                                                    if (_e731 < 9u) {
                                                    } else {
                                                        phi_1970_ = true;
                                                        break;
                                                    }
                                                    let _e737 = global_3.member[_e664].member[_e731];
                                                    phi_858_ = array<array<f32, 3>, 3>(array<f32, 3>(_e681, _e687, _e693), array<f32, 3>(_e701, _e708, _e715), array<f32, 3>(_e723, _e730, _e737));
                                                }
                                                let _e741 = phi_858_;
                                                let _e750 = (_e741[0][2] - _e318);
                                                let _e753 = (((_e741[0][0] - _e241) * _e342) - (_e750 * _e266));
                                                let _e756 = (((_e741[0][1] - _e280) * _e342) - (_e750 * _e304));
                                                let _e763 = (_e741[1][2] - _e318);
                                                let _e766 = (((_e741[1][0] - _e241) * _e342) - (_e763 * _e266));
                                                let _e769 = (((_e741[1][1] - _e280) * _e342) - (_e763 * _e304));
                                                let _e776 = (_e741[2][2] - _e318);
                                                let _e779 = (((_e741[2][0] - _e241) * _e342) - (_e776 * _e266));
                                                let _e782 = (((_e741[2][1] - _e280) * _e342) - (_e776 * _e304));
                                                let _e783 = (_e779 * _e769);
                                                let _e784 = (_e782 * _e766);
                                                let _e785 = (_e753 * _e782);
                                                let _e786 = (_e756 * _e779);
                                                let _e787 = (_e766 * _e756);
                                                let _e788 = (_e769 * _e753);
                                                let _e793 = (((_e783 >= _e784) && (_e785 >= _e786)) && (_e787 >= _e788));
                                                if (_e793 || (((_e783 <= _e784) && (_e785 <= _e786)) && (_e787 <= _e788))) {
                                                    let _e800 = select(-1f, 1f, _e793);
                                                    let _e802 = ((_e783 - _e784) * _e800);
                                                    let _e804 = select(0f, _e802, (_e802 > 0f));
                                                    let _e806 = ((_e785 - _e786) * _e800);
                                                    let _e808 = select(0f, _e806, (_e806 > 0f));
                                                    let _e810 = ((_e787 - _e788) * _e800);
                                                    let _e812 = select(0f, _e810, (_e810 > 0f));
                                                    let _e814 = ((_e804 + _e808) + _e812);
                                                    if (_e814 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1424_ = type_27();
                                                        phi_1425_ = true;
                                                    } else {
                                                        let _e817 = select(_e741[1][0], _e741[0][0], (_e741[0][0] < _e741[1][0]));
                                                        let _e821 = select(_e741[1][0], _e741[0][0], (_e741[0][0] > _e741[1][0]));
                                                        let _e825 = select(_e741[1][1], _e741[0][1], (_e741[0][1] < _e741[1][1]));
                                                        let _e829 = select(_e741[1][1], _e741[0][1], (_e741[0][1] > _e741[1][1]));
                                                        let _e833 = select(_e741[1][2], _e741[0][2], (_e741[0][2] < _e741[1][2]));
                                                        let _e837 = select(_e741[1][2], _e741[0][2], (_e741[0][2] > _e741[1][2]));
                                                        let _e842 = ((select(_e741[2][0], _e817, (_e817 < _e741[2][0])) - _e264) * _e269);
                                                        let _e843 = ((select(_e741[2][0], _e821, (_e821 > _e741[2][0])) - _e265) * _e269);
                                                        let _e846 = ((select(_e741[2][1], _e825, (_e825 < _e741[2][1])) - _e302) * _e307);
                                                        let _e847 = ((select(_e741[2][1], _e829, (_e829 > _e741[2][1])) - _e303) * _e307);
                                                        let _e850 = ((select(_e741[2][2], _e833, (_e833 < _e741[2][2])) - _e340) * _e345);
                                                        let _e851 = ((select(_e741[2][2], _e837, (_e837 > _e741[2][2])) - _e341) * _e345);
                                                        let _e853 = select(_e851, _e850, (_e850 < _e851));
                                                        let _e855 = select(_e851, _e850, (_e850 > _e851));
                                                        let _e857 = select(_e843, _e842, (_e842 < _e843));
                                                        let _e859 = select(_e847, _e846, (_e846 < _e847));
                                                        let _e861 = select(_e859, _e857, (_e857 > _e859));
                                                        let _e863 = select(_e853, _e861, (_e861 > _e853));
                                                        let _e865 = select(_e843, _e842, (_e842 > _e843));
                                                        let _e867 = select(_e847, _e846, (_e846 > _e847));
                                                        let _e869 = select(_e867, _e865, (_e865 < _e867));
                                                        let _e871 = select(_e855, _e869, (_e869 < _e855));
                                                        let _e872 = -(_e853);
                                                        let _e878 = select(_e392, _e863, (_e863 > _e392));
                                                        if (_e878 > (_e871 + (select(_e872, _e855, (_e855 > _e872)) * 0.0000019073523f))) {
                                                            phi_1419_ = type_27();
                                                            phi_1420_ = true;
                                                        } else {
                                                            let _e880 = (_e878 > _e636.member.member_1);
                                                            if _e880 {
                                                                phi_1418_ = type_27();
                                                            } else {
                                                                let _e884 = (_e741[1][0] - _e741[0][0]);
                                                                let _e885 = (_e741[1][1] - _e741[0][1]);
                                                                let _e886 = (_e741[1][2] - _e741[0][2]);
                                                                let _e887 = vec3<f32>(_e884, _e885, _e886);
                                                                let _e888 = (_e741[2][0] - _e741[1][0]);
                                                                let _e889 = (_e741[2][1] - _e741[1][1]);
                                                                let _e890 = (_e741[2][2] - _e741[1][2]);
                                                                let _e891 = vec3<f32>(_e888, _e889, _e890);
                                                                let _e892 = (_e741[0][0] - _e741[2][0]);
                                                                let _e893 = (_e741[0][1] - _e741[2][1]);
                                                                let _e894 = (_e741[0][2] - _e741[2][2]);
                                                                let _e895 = vec3<f32>(_e892, _e893, _e894);
                                                                let _e898 = bitcast<f32>((bitcast<u32>(_e884) & 2147483647u));
                                                                let _e901 = bitcast<f32>((bitcast<u32>(_e885) & 2147483647u));
                                                                let _e903 = select(_e901, _e898, (_e898 > _e901));
                                                                let _e906 = bitcast<f32>((bitcast<u32>(_e886) & 2147483647u));
                                                                let _e908 = select(_e906, _e903, (_e903 > _e906));
                                                                let _e911 = bitcast<f32>((bitcast<u32>(_e888) & 2147483647u));
                                                                let _e914 = bitcast<f32>((bitcast<u32>(_e889) & 2147483647u));
                                                                let _e916 = select(_e914, _e911, (_e911 > _e914));
                                                                let _e919 = bitcast<f32>((bitcast<u32>(_e890) & 2147483647u));
                                                                let _e921 = select(_e919, _e916, (_e916 > _e919));
                                                                let _e924 = bitcast<f32>((bitcast<u32>(_e892) & 2147483647u));
                                                                let _e927 = bitcast<f32>((bitcast<u32>(_e893) & 2147483647u));
                                                                let _e929 = select(_e927, _e924, (_e924 > _e927));
                                                                let _e932 = bitcast<f32>((bitcast<u32>(_e894) & 2147483647u));
                                                                let _e934 = select(_e932, _e929, (_e929 > _e932));
                                                                let _e936 = select(_e921, _e908, (_e908 > _e921));
                                                                let _e938 = select(_e934, _e936, (_e936 > _e934));
                                                                if (_e908 == _e938) {
                                                                    phi_1329_ = _e891;
                                                                    phi_1330_ = _e895;
                                                                } else {
                                                                    let _e941 = vec3((_e921 == _e938));
                                                                    phi_1329_ = select(_e887, _e895, _e941);
                                                                    phi_1330_ = select(_e891, _e887, _e941);
                                                                }
                                                                let _e945 = phi_1329_;
                                                                let _e947 = phi_1330_;
                                                                let _e954 = ((_e945.y * _e947.z) - (_e947.y * _e945.z));
                                                                let _e959 = ((_e945.z * _e947.x) - (_e947.z * _e945.x));
                                                                let _e962 = ((_e945.x * _e947.y) - (_e947.x * _e945.y));
                                                                if (_e804 >= _e808) {
                                                                    phi_1361_ = select(true, false, (_e804 >= _e812));
                                                                } else {
                                                                    phi_1361_ = true;
                                                                }
                                                                let _e967 = phi_1361_;
                                                                if _e967 {
                                                                    phi_1370_ = select(vec3<f32>(_e741[2][0], _e741[2][1], _e741[2][2]), vec3<f32>(_e741[1][0], _e741[1][1], _e741[1][2]), vec3((_e808 >= _e812)));
                                                                } else {
                                                                    phi_1370_ = vec3<f32>(_e741[0][0], _e741[0][1], _e741[0][2]);
                                                                }
                                                                let _e972 = phi_1370_;
                                                                let _e989 = ((((_e954 * (_e972.x - _e241)) + (_e959 * (_e972.y - _e280))) + (_e962 * (_e972.z - _e318))) / (((_e954 * _e266) + (_e959 * _e304)) + (_e962 * _e342)));
                                                                let _e991 = select(_e871, _e989, (_e989 < _e871));
                                                                let _e993 = select(_e863, _e991, (_e991 > _e863));
                                                                if (_e993 >= _e392) {
                                                                    let _e995 = (_e993 <= _e636.member.member_1);
                                                                    if _e995 {
                                                                        let _e996 = (1f / _e814);
                                                                        phi_1410_ = type_27(_e993, (_e808 * _e996), (_e812 * _e996), _e671);
                                                                    } else {
                                                                        phi_1410_ = type_27();
                                                                    }
                                                                    let _e1001 = phi_1410_;
                                                                    phi_1412_ = _e1001;
                                                                    phi_1413_ = select(true, false, _e995);
                                                                } else {
                                                                    phi_1412_ = type_27();
                                                                    phi_1413_ = true;
                                                                }
                                                                let _e1004 = phi_1412_;
                                                                let _e1006 = phi_1413_;
                                                                if _e1006 {
                                                                    phi_1417_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1417_ = _e1004;
                                                                }
                                                                let _e1008 = phi_1417_;
                                                                phi_1418_ = _e1008;
                                                            }
                                                            let _e1010 = phi_1418_;
                                                            phi_1419_ = _e1010;
                                                            phi_1420_ = _e880;
                                                        }
                                                        let _e1012 = phi_1419_;
                                                        let _e1014 = phi_1420_;
                                                        phi_1424_ = _e1012;
                                                        phi_1425_ = _e1014;
                                                    }
                                                    let _e1016 = phi_1424_;
                                                    let _e1018 = phi_1425_;
                                                    phi_1429_ = _e1016;
                                                    phi_1430_ = _e1018;
                                                } else {
                                                    phi_1429_ = type_27();
                                                    phi_1430_ = true;
                                                }
                                                let _e1020 = phi_1429_;
                                                let _e1022 = phi_1430_;
                                                if _e1022 {
                                                    phi_1434_ = type_27(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1434_ = _e1020;
                                                }
                                                let _e1024 = phi_1434_;
                                                if (_e1024.member_3 != 4294967295u) {
                                                    if (_e671 != 4294967295u) {
                                                        if (_e1024.member < _e636.member.member.member) {
                                                            phi_1460_ = true;
                                                        } else {
                                                            if (_e1024.member == _e636.member.member.member) {
                                                                phi_1459_ = (_e1024.member_3 < _e636.member.member.member_3);
                                                            } else {
                                                                phi_1459_ = false;
                                                            }
                                                            let _e1039 = phi_1459_;
                                                            phi_1460_ = _e1039;
                                                        }
                                                        let _e1041 = phi_1460_;
                                                        if _e1041 {
                                                            phi_1467_ = type_48(type_39(_e1024, _e1024.member), _e663.member_1, _e663.member_2);
                                                        } else {
                                                            phi_1467_ = _e663;
                                                        }
                                                        let _e1048 = phi_1467_;
                                                        phi_1468_ = _e1048;
                                                    } else {
                                                        phi_1468_ = _e663;
                                                    }
                                                    let _e1050 = phi_1468_;
                                                    phi_1469_ = _e1050;
                                                } else {
                                                    phi_1469_ = _e663;
                                                }
                                                let _e1052 = phi_1469_;
                                                phi_720_ = _e1052;
                                            } else {
                                                phi_720_ = type_48();
                                            }
                                            let _e1054 = phi_720_;
                                            continue;
                                            continuing {
                                                phi_719_ = _e1054;
                                                phi_722_ = _e651;
                                                phi_1970_ = _e401;
                                                break if !(_e657);
                                            }
                                        }
                                        let _e1057 = phi_1970_;
                                        phi_2084_ = _e1057;
                                        if _e1057 {
                                            break;
                                        }
                                        phi_2088_ = _e1057;
                                        let _e1203 = local_4;
                                        phi_1927_ = _e1203;
                                        phi_1928_ = _e427;
                                        phi_1929_ = false;
                                        phi_1930_ = _e431;
                                    } else {
                                        if (_e427 >= _e64) {
                                            phi_1532_ = type_44(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e427 < _e64) {
                                            } else {
                                                phi_2084_ = true;
                                                break;
                                            }
                                            let _e447 = (_e192 % 3u);
                                            if (_e447 < 3u) {
                                            } else {
                                                phi_2084_ = true;
                                                break;
                                            }
                                            let _e453 = global_2.member[_e427].member[_e447];
                                            let _e459 = (_e191 % 3u);
                                            if (_e459 < 3u) {
                                            } else {
                                                phi_2084_ = true;
                                                break;
                                            }
                                            let _e465 = global_2.member[_e427].member[_e459];
                                            let _e471 = (_e193 % 3u);
                                            if (_e471 < 3u) {
                                            } else {
                                                phi_2084_ = true;
                                                break;
                                            }
                                            let _e477 = global_2.member[_e427].member[_e471];
                                            let _e487 = global_2.member[_e427].member_1;
                                            let _e491 = global_2.member[_e427].member_2;
                                            phi_1532_ = type_44(array<vec4<f32>, 3>(vec4<f32>(_e453[0], _e453[1], _e453[2], _e453[3]), vec4<f32>(_e465[0], _e465[1], _e465[2], _e465[3]), vec4<f32>(_e477[0], _e477[1], _e477[2], _e477[3])), _e487, _e491);
                                        }
                                        let _e494 = phi_1532_;
                                        let _e507 = ((_e494.member[0].x - _e264) * _e269);
                                        let _e508 = ((_e494.member[0].y - _e264) * _e269);
                                        let _e509 = ((_e494.member[0].z - _e265) * _e269);
                                        let _e510 = ((_e494.member[0].w - _e265) * _e269);
                                        let _e520 = ((_e494.member[1].x - _e302) * _e307);
                                        let _e521 = ((_e494.member[1].y - _e302) * _e307);
                                        let _e522 = ((_e494.member[1].z - _e303) * _e307);
                                        let _e523 = ((_e494.member[1].w - _e303) * _e307);
                                        let _e533 = ((_e494.member[2].x - _e340) * _e345);
                                        let _e534 = ((_e494.member[2].y - _e340) * _e345);
                                        let _e535 = ((_e494.member[2].z - _e341) * _e345);
                                        let _e536 = ((_e494.member[2].w - _e341) * _e345);
                                        let _e538 = select(_e535, _e533, (_e533 < _e535));
                                        let _e540 = select(_e536, _e534, (_e534 < _e536));
                                        let _e542 = select(_e535, _e533, (_e533 > _e535));
                                        let _e544 = select(_e536, _e534, (_e534 > _e536));
                                        let _e546 = select(_e509, _e507, (_e507 < _e509));
                                        let _e548 = select(_e510, _e508, (_e508 < _e510));
                                        let _e550 = select(_e522, _e520, (_e520 < _e522));
                                        let _e552 = select(_e523, _e521, (_e521 < _e523));
                                        let _e554 = select(_e550, _e546, (_e546 > _e550));
                                        let _e556 = select(_e552, _e548, (_e548 > _e552));
                                        let _e558 = select(_e538, _e554, (_e554 > _e538));
                                        let _e560 = select(_e540, _e556, (_e556 > _e540));
                                        let _e562 = select(_e509, _e507, (_e507 > _e509));
                                        let _e564 = select(_e510, _e508, (_e508 > _e510));
                                        let _e566 = select(_e522, _e520, (_e520 > _e522));
                                        let _e568 = select(_e523, _e521, (_e521 > _e523));
                                        let _e570 = select(_e566, _e562, (_e562 < _e566));
                                        let _e572 = select(_e568, _e564, (_e564 < _e568));
                                        let _e577 = -(_e538);
                                        let _e578 = -(_e540);
                                        let _e585 = (select(_e542, _e570, (_e570 < _e542)) + (select(_e577, _e542, (_e542 > _e577)) * 0.0000019073523f));
                                        let _e586 = (select(_e544, _e572, (_e572 < _e544)) + (select(_e578, _e544, (_e544 > _e578)) * 0.0000019073523f));
                                        let _e588 = select(_e392, _e558, (_e558 > _e392));
                                        let _e590 = select(_e392, _e560, (_e560 > _e392));
                                        let _e595 = (_e588 <= select(_e403.member.member_1, _e585, (_e585 < _e403.member.member_1)));
                                        let _e596 = (_e590 <= select(_e403.member.member_1, _e586, (_e586 < _e403.member.member_1)));
                                        let _e597 = (_e588 <= _e590);
                                        if _e595 {
                                            if _e596 {
                                                if _e597 {
                                                    phi_1876_ = _e494.member_2;
                                                } else {
                                                    phi_1876_ = _e494.member_1;
                                                }
                                                let _e601 = phi_1876_;
                                                let _e604 = (_e431 % 128u);
                                                let _e605 = (_e604 < 128u);
                                                if _e605 {
                                                } else {
                                                    phi_2084_ = true;
                                                    break;
                                                }
                                                local_1[_e604] = _e601;
                                                if _e605 {
                                                } else {
                                                    phi_2084_ = true;
                                                    break;
                                                }
                                                local[_e604] = select(_e590, _e588, (_e588 > _e590));
                                                if _e597 {
                                                    phi_1904_ = _e494.member_1;
                                                } else {
                                                    phi_1904_ = _e494.member_2;
                                                }
                                                let _e612 = phi_1904_;
                                                phi_1905_ = _e612;
                                                phi_1906_ = (_e431 + 1u);
                                            } else {
                                                phi_1905_ = u32();
                                                phi_1906_ = u32();
                                            }
                                            let _e614 = phi_1905_;
                                            let _e616 = phi_1906_;
                                            phi_1908_ = _e614;
                                            phi_1909_ = _e616;
                                            phi_1910_ = select(true, false, _e596);
                                        } else {
                                            phi_1908_ = u32();
                                            phi_1909_ = u32();
                                            phi_1910_ = true;
                                        }
                                        let _e619 = phi_1908_;
                                        let _e621 = phi_1909_;
                                        let _e623 = phi_1910_;
                                        if _e623 {
                                            if _e595 {
                                                phi_1919_ = _e494.member_1;
                                            } else {
                                                phi_1919_ = _e494.member_2;
                                            }
                                            let _e627 = phi_1919_;
                                            phi_1924_ = _e627;
                                            phi_1925_ = select(_e596, true, _e595);
                                        } else {
                                            phi_1924_ = _e619;
                                            phi_1925_ = _e429;
                                        }
                                        let _e630 = phi_1924_;
                                        let _e632 = phi_1925_;
                                        phi_2088_ = _e401;
                                        phi_1927_ = type_48(_e403.member, (_e403.member_1 + 1u), _e403.member_2);
                                        phi_1928_ = _e630;
                                        phi_1929_ = _e632;
                                        phi_1930_ = select(_e621, _e431, _e623);
                                    }
                                    let _e1059 = phi_2088_;
                                    let _e1061 = phi_1927_;
                                    let _e1063 = phi_1928_;
                                    let _e1065 = phi_1929_;
                                    let _e1067 = phi_1930_;
                                    phi_2087_ = _e1059;
                                    phi_1931_ = _e1061;
                                    phi_1932_ = _e1063;
                                    phi_1933_ = (_e407 - 1u);
                                    phi_1934_ = _e1065;
                                    phi_1935_ = _e1067;
                                } else {
                                    phi_2087_ = _e401;
                                    phi_1931_ = _e403;
                                    phi_1932_ = _e427;
                                    phi_1933_ = _e407;
                                    phi_1934_ = _e429;
                                    phi_1935_ = _e431;
                                }
                                let _e1069 = phi_2087_;
                                let _e1071 = phi_1931_;
                                let _e1073 = phi_1932_;
                                let _e1075 = phi_1933_;
                                let _e1077 = phi_1934_;
                                let _e1079 = phi_1935_;
                                phi_2086_ = _e1069;
                                phi_1936_ = _e1071;
                                phi_1937_ = _e1073;
                                phi_1938_ = _e1075;
                                phi_1939_ = _e1077;
                                phi_1940_ = _e1079;
                            } else {
                                phi_2086_ = _e401;
                                phi_1936_ = type_48();
                                phi_1937_ = u32();
                                phi_1938_ = u32();
                                phi_1939_ = bool();
                                phi_1940_ = u32();
                            }
                            let _e1081 = phi_2086_;
                            let _e1083 = phi_1936_;
                            let _e1085 = phi_1937_;
                            let _e1087 = phi_1938_;
                            let _e1089 = phi_1939_;
                            let _e1091 = phi_1940_;
                            phi_2085_ = _e1081;
                            phi_651_ = _e1083;
                            phi_654_ = _e1085;
                            phi_656_ = _e1087;
                            phi_658_ = _e1089;
                            phi_660_ = _e1091;
                            phi_1941_ = _e415;
                        } else {
                            phi_2085_ = _e401;
                            phi_651_ = type_48();
                            phi_654_ = u32();
                            phi_656_ = u32();
                            phi_658_ = bool();
                            phi_660_ = u32();
                            phi_1941_ = false;
                        }
                        let _e1093 = phi_2085_;
                        let _e1095 = phi_651_;
                        let _e1097 = phi_654_;
                        let _e1099 = phi_656_;
                        let _e1101 = phi_658_;
                        let _e1103 = phi_660_;
                        let _e1105 = phi_1941_;
                        continue;
                        continuing {
                            phi_1976_ = _e1093;
                            phi_650_ = _e1095;
                            phi_653_ = _e1097;
                            phi_655_ = _e1099;
                            phi_657_ = _e1101;
                            phi_659_ = _e1103;
                            phi_2084_ = _e1093;
                            break if !(_e1105);
                        }
                    }
                    let _e1108 = phi_2084_;
                    if _e1108 {
                        break;
                    }
                    let _e1110 = local_2;
                    let _e1113 = local_3;
                    if _e80 {
                    } else {
                        break;
                    }
                    global_5.member[_e74][0u] = _e1110.member_1;
                    global_5.member[_e74][1u] = _e1113.member_2;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_counted(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
