struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_8 {
    member: vec4<u32>,
}

struct type_18 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_19 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_27 {
    member: array<type_19>,
}

struct type_31 {
    member: array<array<type_18, 8>>,
}

struct type_37 {
    member: array<vec4<u32>, 2>,
}

struct type_39 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_41 {
    member: array<type_39>,
}

struct type_44 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_46 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_48 {
    member: array<type_46>,
}

struct type_52 {
    member: type_44,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(1) 
var<uniform> global_2: type_37;
@group(0) @binding(4) 
var<storage> global_3: type_27;
@group(0) @binding(2) 
var<storage> global_4: type_41;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_31;
@group(0) @binding(3) 
var<storage> global_6: type_48;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<f32, 128>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<u32, 128>;
    var local_7: array<type_18, 8>;
    var local_8: array<f32, 128>;
    var local_9: array<f32, 3>;
    var local_10: array<f32, 3>;
    var phi_341_: i32;
    var phi_342_: i32;
    var phi_352_: bool;
    var phi_362_: u32;
    var phi_363_: u32;
    var phi_365_: bool;
    var phi_370_: u32;
    var phi_382_: i32;
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
    var phi_3470_: bool;
    var phi_3390_: f32;
    var phi_836_: type_52;
    var phi_839_: u32;
    var phi_841_: bool;
    var phi_843_: u32;
    var phi_854_: bool;
    var phi_941_: type_52;
    var phi_942_: bool;
    var phi_943_: u32;
    var phi_2228_: type_39;
    var phi_3061_: type_52;
    var phi_3138_: type_52;
    var phi_3139_: type_52;
    var phi_3140_: u32;
    var phi_3142_: type_52;
    var phi_3143_: u32;
    var phi_3144_: bool;
    var phi_3151_: type_52;
    var phi_3156_: type_52;
    var phi_3157_: bool;
    var phi_3467_: bool;
    var phi_3439_: f32;
    var phi_962_: type_4;
    var phi_963_: type_4;
    var phi_986_: type_4;
    var phi_1011_: u32;
    var phi_1027_: type_46;
    var phi_1404_: bool;
    var phi_1433_: bool;
    var phi_1810_: f32;
    var phi_1811_: f32;
    var phi_1812_: f32;
    var phi_1813_: f32;
    var phi_1814_: vec3<f32>;
    var phi_1815_: vec3<f32>;
    var phi_1816_: vec3<f32>;
    var phi_1817_: vec3<f32>;
    var phi_1848_: bool;
    var phi_1857_: vec3<f32>;
    var phi_2024_: bool;
    var phi_2048_: f32;
    var phi_2049_: f32;
    var phi_2072_: type_18;
    var phi_2074_: type_18;
    var phi_2075_: bool;
    var phi_2079_: type_18;
    var phi_2080_: type_18;
    var phi_2081_: type_18;
    var phi_2082_: bool;
    var phi_2086_: type_18;
    var phi_2087_: bool;
    var phi_2088_: type_18;
    var phi_2089_: bool;
    var phi_2090_: bool;
    var phi_2091_: type_18;
    var phi_2092_: bool;
    var phi_2093_: bool;
    var phi_2101_: type_18;
    var phi_2102_: bool;
    var phi_2106_: type_18;
    var phi_2118_: type_4;
    var phi_2121_: type_18;
    var phi_2119_: type_4;
    var phi_2144_: type_4;
    var phi_2176_: bool;
    var phi_2177_: bool;
    var phi_2198_: type_18;
    var phi_2122_: type_18;
    var phi_3440_: bool;
    var phi_3805_: f32;
    var phi_3804_: f32;
    var phi_3603_: bool;
    var phi_3803_: f32;
    var phi_3602_: bool;
    var phi_3802_: f32;
    var phi_3601_: bool;
    var phi_3714_: f32;
    var phi_3600_: bool;
    var phi_3679_: f32;
    var phi_3609_: bool;
    var phi_3159_: type_52;
    var phi_3160_: bool;
    var phi_3161_: u32;
    var phi_3678_: f32;
    var phi_3608_: bool;
    var phi_3162_: type_52;
    var phi_3163_: u32;
    var phi_3164_: bool;
    var phi_3165_: u32;
    var phi_3677_: f32;
    var phi_3607_: bool;
    var phi_3166_: type_52;
    var phi_3167_: u32;
    var phi_3168_: bool;
    var phi_3169_: u32;
    var phi_3676_: f32;
    var phi_3606_: bool;
    var phi_837_: type_52;
    var phi_840_: u32;
    var phi_842_: bool;
    var phi_844_: u32;
    var phi_3170_: bool;
    var phi_3605_: bool;
    var phi_3177_: type_4;
    var phi_3178_: type_4;
    var phi_3201_: type_4;
    var phi_3267_: type_18;
    var phi_3669_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e78 = global;
            let _e81 = arrayLength((&global_4.member));
            let _e92 = global_2.member[0u][0u];
            let _e96 = global_2.member[0u][1u];
            let _e100 = global_2.member[0u][2u];
            let _e104 = global_2.member[1u][0u];
            let _e108 = global_2.member[1u][1u];
            let _e112 = global_2.member[1u][2u];
            let _e116 = global_2.member[1u][3u];
            let _e119 = global_1.member[0u];
            let _e120 = bitcast<i32>(_e119);
            let _e130 = (_e78.x + (_e78.y * 2097152u));
            let _e131 = (_e130 < arrayLength((&global_3.member)));
            if _e131 {
                let _e132 = (_e130 < arrayLength((&global_5.member)));
                if _e132 {
                    if _e131 {
                    } else {
                        break;
                    }
                    let _e140 = global_3.member[_e130].member_2[0u];
                    let _e142 = (bitcast<u32>(_e140) & 2147483647u);
                    let _e147 = global_3.member[_e130].member_2[1u];
                    let _e149 = (bitcast<u32>(_e147) & 2147483647u);
                    let _e154 = global_3.member[_e130].member_2[2u];
                    let _e156 = (bitcast<u32>(_e154) & 2147483647u);
                    let _e161 = global_3.member[_e130].member[0u];
                    let _e163 = (bitcast<u32>(_e161) & 2147483647u);
                    let _e168 = global_3.member[_e130].member[1u];
                    let _e170 = (bitcast<u32>(_e168) & 2147483647u);
                    let _e175 = global_3.member[_e130].member[2u];
                    let _e177 = (bitcast<u32>(_e175) & 2147483647u);
                    let _e179 = select(_e149, _e142, (_e149 < _e142));
                    let _e181 = select(_e156, _e179, (_e156 < _e179));
                    let _e183 = select(_e163, _e181, (_e163 < _e181));
                    let _e185 = select(_e170, _e183, (_e170 < _e183));
                    let _e187 = select(_e177, _e185, (_e177 < _e185));
                    let _e191 = global_3.member[_e130].member_1;
                    let _e193 = (bitcast<u32>(_e191) & 2147483647u);
                    let _e200 = global_3.member[_e130].member_3;
                    let _e206 = (((select(_e193, _e187, (_e193 < _e187)) < 2139095040u) && ((bitcast<u32>(_e200) & 2147483647u) <= 2139095040u)) && (_e181 > 0u));
                    if _e206 {
                        let _e209 = (bitcast<u32>(bitcast<f32>(_e181)) & 2147483647u);
                        if (_e209 >= 8388608u) {
                            phi_341_ = (bitcast<i32>((_e209 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_341_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e209)), 32u, (_e209 == 0u))));
                        }
                        let _e223 = phi_341_;
                        phi_342_ = _e223;
                    } else {
                        phi_342_ = 0i;
                    }
                    let _e225 = phi_342_;
                    let _e226 = (_e142 == _e181);
                    if _e226 {
                        phi_352_ = true;
                    } else {
                        phi_352_ = (_e149 == _e181);
                    }
                    let _e229 = phi_352_;
                    let _e230 = select(1u, 0u, _e226);
                    if _e229 {
                        let _e231 = (_e230 + 1u);
                        phi_362_ = _e231;
                        phi_363_ = _e231;
                        phi_365_ = select(true, false, (_e231 == 2u));
                    } else {
                        phi_362_ = u32();
                        phi_363_ = 0u;
                        phi_365_ = true;
                    }
                    let _e235 = phi_362_;
                    let _e237 = phi_363_;
                    let _e239 = phi_365_;
                    if _e239 {
                        phi_370_ = (_e237 + 1u);
                    } else {
                        phi_370_ = 0u;
                    }
                    let _e243 = phi_370_;
                    let _e244 = select(_e235, _e237, _e239);
                    let _e245 = select(_e230, select(2u, _e230, _e229), _e239);
                    if (_e120 < -126i) {
                        phi_382_ = -126i;
                    } else {
                        phi_382_ = select(_e120, 127i, (_e120 > 127i));
                    }
                    let _e250 = phi_382_;
                    let _e255 = bitcast<f32>((bitcast<u32>((_e250 + 127i)) << bitcast<u32>(23i)));
                    let _e261 = bitcast<f32>((bitcast<u32>(((_e120 - _e250) + 127i)) << bitcast<u32>(23i)));
                    let _e262 = -(_e225);
                    if (_e262 < -126i) {
                        phi_402_ = -126i;
                    } else {
                        phi_402_ = select(_e262, 127i, (_e262 > 127i));
                    }
                    let _e267 = phi_402_;
                    let _e272 = bitcast<f32>((bitcast<u32>((_e267 + 127i)) << bitcast<u32>(23i)));
                    let _e278 = bitcast<f32>((bitcast<u32>(((_e262 - _e267) + 127i)) << bitcast<u32>(23i)));
                    let _e282 = global_3.member[_e130].member;
                    let _e283 = (_e244 == 0u);
                    if _e283 {
                        phi_420_ = _e282[0];
                    } else {
                        phi_420_ = _e282[1];
                    }
                    let _e287 = phi_420_;
                    let _e288 = (_e244 == 2u);
                    if _e288 {
                        phi_426_ = _e282[2];
                    } else {
                        phi_426_ = _e287;
                    }
                    let _e291 = phi_426_;
                    let _e293 = ((_e291 * _e255) * _e261);
                    let _e294 = global_3.member[_e130].member_2;
                    if _e283 {
                        phi_437_ = _e294[0];
                    } else {
                        phi_437_ = _e294[1];
                    }
                    let _e298 = phi_437_;
                    if _e288 {
                        phi_443_ = _e294[2];
                    } else {
                        phi_443_ = _e298;
                    }
                    let _e301 = phi_443_;
                    let _e303 = ((_e301 * _e272) * _e278);
                    let _e307 = (bitcast<f32>((bitcast<u32>(_e303) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e307 {
                        let _e311 = (bitcast<f32>((bitcast<u32>(_e293) & 2147483647u)) * 0.00000011920929f);
                        phi_466_ = select(0.00000000000011368684f, _e311, (_e311 > 0.00000000000011368684f));
                    } else {
                        phi_466_ = 0f;
                    }
                    let _e315 = phi_466_;
                    let _e316 = (_e293 + _e315);
                    let _e317 = (_e293 - _e315);
                    let _e318 = select(_e303, 0f, _e307);
                    if _e307 {
                        phi_477_ = 38685626000000000000000000f;
                    } else {
                        phi_477_ = (1f / _e303);
                    }
                    let _e321 = phi_477_;
                    let _e322 = (_e243 == 0u);
                    if _e322 {
                        phi_486_ = _e282[0];
                    } else {
                        phi_486_ = _e282[1];
                    }
                    let _e326 = phi_486_;
                    let _e327 = (_e243 == 2u);
                    if _e327 {
                        phi_492_ = _e282[2];
                    } else {
                        phi_492_ = _e326;
                    }
                    let _e330 = phi_492_;
                    let _e332 = ((_e330 * _e255) * _e261);
                    if _e322 {
                        phi_503_ = _e294[0];
                    } else {
                        phi_503_ = _e294[1];
                    }
                    let _e336 = phi_503_;
                    if _e327 {
                        phi_509_ = _e294[2];
                    } else {
                        phi_509_ = _e336;
                    }
                    let _e339 = phi_509_;
                    let _e341 = ((_e339 * _e272) * _e278);
                    let _e345 = (bitcast<f32>((bitcast<u32>(_e341) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e345 {
                        let _e349 = (bitcast<f32>((bitcast<u32>(_e332) & 2147483647u)) * 0.00000011920929f);
                        phi_532_ = select(0.00000000000011368684f, _e349, (_e349 > 0.00000000000011368684f));
                    } else {
                        phi_532_ = 0f;
                    }
                    let _e353 = phi_532_;
                    let _e354 = (_e332 + _e353);
                    let _e355 = (_e332 - _e353);
                    let _e356 = select(_e341, 0f, _e345);
                    if _e345 {
                        phi_543_ = 38685626000000000000000000f;
                    } else {
                        phi_543_ = (1f / _e341);
                    }
                    let _e359 = phi_543_;
                    let _e360 = (_e245 == 0u);
                    if _e360 {
                        phi_552_ = _e282[0];
                    } else {
                        phi_552_ = _e282[1];
                    }
                    let _e364 = phi_552_;
                    let _e365 = (_e245 == 2u);
                    if _e365 {
                        phi_558_ = _e282[2];
                    } else {
                        phi_558_ = _e364;
                    }
                    let _e368 = phi_558_;
                    let _e370 = ((_e368 * _e255) * _e261);
                    if _e360 {
                        phi_569_ = _e294[0];
                    } else {
                        phi_569_ = _e294[1];
                    }
                    let _e374 = phi_569_;
                    if _e365 {
                        phi_575_ = _e294[2];
                    } else {
                        phi_575_ = _e374;
                    }
                    let _e377 = phi_575_;
                    let _e379 = ((_e377 * _e272) * _e278);
                    let _e383 = (bitcast<f32>((bitcast<u32>(_e379) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e383 {
                        let _e387 = (bitcast<f32>((bitcast<u32>(_e370) & 2147483647u)) * 0.00000011920929f);
                        phi_598_ = select(0.00000000000011368684f, _e387, (_e387 > 0.00000000000011368684f));
                    } else {
                        phi_598_ = 0f;
                    }
                    let _e391 = phi_598_;
                    let _e392 = (_e370 + _e391);
                    let _e393 = (_e370 - _e391);
                    let _e394 = select(_e379, 0f, _e383);
                    if _e383 {
                        phi_609_ = 38685626000000000000000000f;
                    } else {
                        phi_609_ = (1f / _e379);
                    }
                    let _e397 = phi_609_;
                    let _e400 = bitcast<f32>((bitcast<u32>(_e293) & 2147483647u));
                    let _e403 = bitcast<f32>((bitcast<u32>(_e332) & 2147483647u));
                    let _e405 = select(_e403, _e400, (_e400 > _e403));
                    let _e408 = bitcast<f32>((bitcast<u32>(_e370) & 2147483647u));
                    let _e411 = (_e120 + _e225);
                    if (_e206 && (select(_e408, _e405, (_e405 > _e408)) <= 1099511600000f)) {
                        let _e414 = (_e411 / 3i);
                        let _e421 = bitcast<f32>((bitcast<u32>((_e414 + 127i)) << bitcast<u32>(23i)));
                        let _e428 = bitcast<f32>((bitcast<u32>(((_e411 - (2i * _e414)) + 127i)) << bitcast<u32>(23i)));
                        let _e429 = (((_e191 * _e421) * _e421) * _e428);
                        let _e431 = select(340282350000000000000000000000000000000f, _e429, (_e429 < 340282350000000000000000000000000000000f));
                        let _e436 = (((_e200 * _e421) * _e421) * _e428);
                        let _e438 = select(340282350000000000000000000000000000000f, _e436, (_e436 < 340282350000000000000000000000000000000f));
                        phi_709_ = select(-340282350000000000000000000000000000000f, _e438, (_e438 > -340282350000000000000000000000000000000f));
                        phi_710_ = select(-340282350000000000000000000000000000000f, _e431, (_e431 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_709_ = 0f;
                        phi_710_ = 1f;
                    }
                    let _e442 = phi_709_;
                    let _e444 = phi_710_;
                    local_7 = array<type_18, 8>(type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_8 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_10 = array<f32, 3>(bitcast<f32>(_e92), bitcast<f32>(_e96), bitcast<f32>(_e100));
                    let _e448 = (_e244 % 3u);
                    let _e449 = (_e448 < 3u);
                    if _e449 {
                    } else {
                        break;
                    }
                    let _e451 = local_10[_e448];
                    let _e452 = (_e243 % 3u);
                    let _e453 = (_e452 < 3u);
                    if _e453 {
                    } else {
                        break;
                    }
                    let _e455 = local_10[_e452];
                    let _e456 = (_e245 % 3u);
                    let _e457 = (_e456 < 3u);
                    if _e457 {
                    } else {
                        break;
                    }
                    let _e459 = local_10[_e456];
                    local_9 = array<f32, 3>(bitcast<f32>(_e104), bitcast<f32>(_e108), bitcast<f32>(_e112));
                    if _e449 {
                    } else {
                        break;
                    }
                    let _e463 = local_9[_e448];
                    if _e453 {
                    } else {
                        break;
                    }
                    let _e465 = local_9[_e452];
                    if _e457 {
                    } else {
                        break;
                    }
                    let _e467 = local_9[_e456];
                    phi_3470_ = false;
                    phi_3390_ = _e442;
                    phi_836_ = type_52(type_44(array<f32, 3>(_e451, _e455, _e459), array<f32, 3>(_e463, _e465, _e467)), select(0u, 2147483648u, (_e81 == 0u)));
                    phi_839_ = ((3u * _e81) + 1u);
                    phi_841_ = (_e444 <= _e442);
                    phi_843_ = 0u;
                    loop {
                        let _e475 = phi_3470_;
                        let _e477 = phi_3390_;
                        let _e479 = phi_836_;
                        let _e481 = phi_839_;
                        let _e483 = phi_841_;
                        let _e485 = phi_843_;
                        if _e483 {
                            phi_854_ = true;
                        } else {
                            phi_854_ = (_e485 > 0u);
                        }
                        let _e488 = phi_854_;
                        if _e488 {
                            let _e489 = (_e481 > 0u);
                            if _e489 {
                                if _e483 {
                                    phi_941_ = _e479;
                                    phi_942_ = _e483;
                                    phi_943_ = _e485;
                                } else {
                                    let _e490 = (_e485 - 1u);
                                    let _e491 = (_e490 % 128u);
                                    let _e492 = (_e491 < 128u);
                                    if _e492 {
                                    } else {
                                        phi_3605_ = true;
                                        break;
                                    }
                                    let _e494 = local_6[_e491];
                                    if _e492 {
                                    } else {
                                        phi_3605_ = true;
                                        break;
                                    }
                                    let _e496 = local_5[_e491];
                                    if _e492 {
                                    } else {
                                        phi_3605_ = true;
                                        break;
                                    }
                                    let _e498 = local_4[_e491];
                                    if _e492 {
                                    } else {
                                        phi_3605_ = true;
                                        break;
                                    }
                                    let _e500 = local_3[_e491];
                                    if _e492 {
                                    } else {
                                        phi_3605_ = true;
                                        break;
                                    }
                                    let _e503 = local_2[_e491];
                                    if _e492 {
                                    } else {
                                        phi_3605_ = true;
                                        break;
                                    }
                                    let _e505 = local_1[_e491];
                                    if _e492 {
                                    } else {
                                        phi_3605_ = true;
                                        break;
                                    }
                                    let _e507 = local[_e491];
                                    if _e492 {
                                    } else {
                                        phi_3605_ = true;
                                        break;
                                    }
                                    let _e512 = local_8[_e491];
                                    phi_941_ = type_52(type_44(array<f32, 3>(_e496, _e498, _e500), array<f32, 3>(_e503, _e505, _e507)), _e494);
                                    phi_942_ = (_e512 <= _e477);
                                    phi_943_ = _e490;
                                }
                                let _e515 = phi_941_;
                                let _e517 = phi_942_;
                                let _e519 = phi_943_;
                                if _e517 {
                                    if ((_e515.member_1 & 2147483648u) != 0u) {
                                        phi_3467_ = _e475;
                                        phi_3439_ = _e477;
                                        phi_962_ = type_4(0u, ((_e515.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e871 = phi_3467_;
                                            let _e873 = phi_3439_;
                                            let _e875 = phi_962_;
                                            if (_e875.member < _e875.member_1) {
                                                phi_963_ = type_4((_e875.member + 1u), _e875.member_1);
                                                phi_986_ = type_4(1u, _e875.member);
                                            } else {
                                                phi_963_ = _e875;
                                                phi_986_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e888 = phi_963_;
                                            let _e890 = phi_986_;
                                            let _e894 = (bitcast<i32>(_e890.member) != 0i);
                                            if _e894 {
                                                let _e895 = ((_e515.member_1 & 268435455u) + _e890.member_1);
                                                let _e896 = (_e895 < arrayLength((&global_6.member)));
                                                if _e896 {
                                                    if _e896 {
                                                    } else {
                                                        phi_3714_ = _e873;
                                                        phi_3600_ = true;
                                                        break;
                                                    }
                                                    let _e899 = global_6.member[_e895].member_1;
                                                    phi_1011_ = _e899;
                                                } else {
                                                    phi_1011_ = 4294967295u;
                                                }
                                                let _e901 = phi_1011_;
                                                if _e896 {
                                                    if _e896 {
                                                    } else {
                                                        phi_3714_ = _e873;
                                                        phi_3600_ = true;
                                                        break;
                                                    }
                                                    let _e903 = global_6.member[_e895];
                                                    phi_1027_ = _e903;
                                                } else {
                                                    phi_1027_ = type_46(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e905 = phi_1027_;
                                                let _e917 = ((10u * _e244) & 31u);
                                                let _e920 = ((_e905.member[0] >> bitcast<u32>(_e917)) & 1023u);
                                                let _e925 = bitcast<f32>((bitcast<u32>(((_e515.member.member_1[0] - _e515.member.member[0]) * 0.0009775171f)) ^ _e116));
                                                let _e931 = (_e515.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e920) * _e925)) ^ _e116)));
                                                let _e935 = select(select(_e515.member.member_1[0], _e931, (_e931 < _e515.member.member_1[0])), _e515.member.member_1[0], (_e920 == 1023u));
                                                let _e937 = ((10u * _e243) & 31u);
                                                let _e940 = ((_e905.member[0] >> bitcast<u32>(_e937)) & 1023u);
                                                let _e945 = bitcast<f32>((bitcast<u32>(((_e515.member.member_1[1] - _e515.member.member[1]) * 0.0009775171f)) ^ _e116));
                                                let _e951 = (_e515.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e940) * _e945)) ^ _e116)));
                                                let _e955 = select(select(_e515.member.member_1[1], _e951, (_e951 < _e515.member.member_1[1])), _e515.member.member_1[1], (_e940 == 1023u));
                                                let _e957 = ((10u * _e245) & 31u);
                                                let _e960 = ((_e905.member[0] >> bitcast<u32>(_e957)) & 1023u);
                                                let _e965 = bitcast<f32>((bitcast<u32>(((_e515.member.member_1[2] - _e515.member.member[2]) * 0.0009775171f)) ^ _e116));
                                                let _e971 = (_e515.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e960) * _e965)) ^ _e116)));
                                                let _e975 = select(select(_e515.member.member_1[2], _e971, (_e971 < _e515.member.member_1[2])), _e515.member.member_1[2], (_e960 == 1023u));
                                                let _e979 = ((_e905.member[1] >> bitcast<u32>(_e917)) & 1023u);
                                                let _e985 = (_e515.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e979) * _e925)) ^ _e116)));
                                                let _e989 = select(select(_e515.member.member_1[0], _e985, (_e985 < _e515.member.member_1[0])), _e515.member.member_1[0], (_e979 == 1023u));
                                                let _e992 = ((_e905.member[1] >> bitcast<u32>(_e937)) & 1023u);
                                                let _e998 = (_e515.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e992) * _e945)) ^ _e116)));
                                                let _e1002 = select(select(_e515.member.member_1[1], _e998, (_e998 < _e515.member.member_1[1])), _e515.member.member_1[1], (_e992 == 1023u));
                                                let _e1005 = ((_e905.member[1] >> bitcast<u32>(_e957)) & 1023u);
                                                let _e1011 = (_e515.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1005) * _e965)) ^ _e116)));
                                                let _e1015 = select(select(_e515.member.member_1[2], _e1011, (_e1011 < _e515.member.member_1[2])), _e515.member.member_1[2], (_e1005 == 1023u));
                                                let _e1019 = ((_e905.member[2] >> bitcast<u32>(_e917)) & 1023u);
                                                let _e1025 = (_e515.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1019) * _e925)) ^ _e116)));
                                                let _e1029 = select(select(_e515.member.member_1[0], _e1025, (_e1025 < _e515.member.member_1[0])), _e515.member.member_1[0], (_e1019 == 1023u));
                                                let _e1032 = ((_e905.member[2] >> bitcast<u32>(_e937)) & 1023u);
                                                let _e1038 = (_e515.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1032) * _e945)) ^ _e116)));
                                                let _e1042 = select(select(_e515.member.member_1[1], _e1038, (_e1038 < _e515.member.member_1[1])), _e515.member.member_1[1], (_e1032 == 1023u));
                                                let _e1045 = ((_e905.member[2] >> bitcast<u32>(_e957)) & 1023u);
                                                let _e1051 = (_e515.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1045) * _e965)) ^ _e116)));
                                                let _e1055 = select(select(_e515.member.member_1[2], _e1051, (_e1051 < _e515.member.member_1[2])), _e515.member.member_1[2], (_e1045 == 1023u));
                                                let _e1058 = (_e975 - _e370);
                                                let _e1061 = (((_e935 - _e293) * _e394) - (_e1058 * _e318));
                                                let _e1064 = (((_e955 - _e332) * _e394) - (_e1058 * _e356));
                                                let _e1067 = (_e1015 - _e370);
                                                let _e1070 = (((_e989 - _e293) * _e394) - (_e1067 * _e318));
                                                let _e1073 = (((_e1002 - _e332) * _e394) - (_e1067 * _e356));
                                                let _e1076 = (_e1055 - _e370);
                                                let _e1079 = (((_e1029 - _e293) * _e394) - (_e1076 * _e318));
                                                let _e1082 = (((_e1042 - _e332) * _e394) - (_e1076 * _e356));
                                                let _e1083 = (_e1079 * _e1073);
                                                let _e1084 = (_e1082 * _e1070);
                                                let _e1085 = (_e1061 * _e1082);
                                                let _e1086 = (_e1064 * _e1079);
                                                let _e1087 = (_e1070 * _e1064);
                                                let _e1088 = (_e1073 * _e1061);
                                                let _e1093 = (((_e1083 >= _e1084) && (_e1085 >= _e1086)) && (_e1087 >= _e1088));
                                                if (_e1093 || (((_e1083 <= _e1084) && (_e1085 <= _e1086)) && (_e1087 <= _e1088))) {
                                                    let _e1100 = select(-1f, 1f, _e1093);
                                                    let _e1102 = ((_e1083 - _e1084) * _e1100);
                                                    let _e1104 = select(0f, _e1102, (_e1102 > 0f));
                                                    let _e1106 = ((_e1085 - _e1086) * _e1100);
                                                    let _e1108 = select(0f, _e1106, (_e1106 > 0f));
                                                    let _e1110 = ((_e1087 - _e1088) * _e1100);
                                                    let _e1112 = select(0f, _e1110, (_e1110 > 0f));
                                                    let _e1114 = ((_e1104 + _e1108) + _e1112);
                                                    if (_e1114 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2091_ = type_18();
                                                        phi_2092_ = true;
                                                        phi_2093_ = false;
                                                    } else {
                                                        let _e1117 = select(_e1070, _e1061, (_e1061 < _e1070));
                                                        if (select(_e1079, _e1117, (_e1117 < _e1079)) > 0f) {
                                                            phi_1404_ = true;
                                                        } else {
                                                            let _e1122 = select(_e1070, _e1061, (_e1061 > _e1070));
                                                            phi_1404_ = (select(_e1079, _e1122, (_e1122 > _e1079)) < 0f);
                                                        }
                                                        let _e1127 = phi_1404_;
                                                        if _e1127 {
                                                            phi_2088_ = type_18();
                                                            phi_2089_ = true;
                                                            phi_2090_ = false;
                                                        } else {
                                                            let _e1129 = select(_e1073, _e1064, (_e1064 < _e1073));
                                                            if (select(_e1082, _e1129, (_e1129 < _e1082)) > 0f) {
                                                                phi_1433_ = true;
                                                            } else {
                                                                let _e1134 = select(_e1073, _e1064, (_e1064 > _e1073));
                                                                phi_1433_ = (select(_e1082, _e1134, (_e1134 > _e1082)) < 0f);
                                                            }
                                                            let _e1139 = phi_1433_;
                                                            if _e1139 {
                                                                phi_2086_ = type_18();
                                                                phi_2087_ = false;
                                                            } else {
                                                                let _e1141 = select(_e989, _e935, (_e935 < _e989));
                                                                let _e1145 = select(_e989, _e935, (_e935 > _e989));
                                                                let _e1149 = select(_e1002, _e955, (_e955 < _e1002));
                                                                let _e1153 = select(_e1002, _e955, (_e955 > _e1002));
                                                                let _e1157 = select(_e1015, _e975, (_e975 < _e1015));
                                                                let _e1161 = select(_e1015, _e975, (_e975 > _e1015));
                                                                let _e1166 = ((select(_e1029, _e1141, (_e1141 < _e1029)) - _e316) * _e321);
                                                                let _e1167 = ((select(_e1029, _e1145, (_e1145 > _e1029)) - _e317) * _e321);
                                                                let _e1170 = ((select(_e1042, _e1149, (_e1149 < _e1042)) - _e354) * _e359);
                                                                let _e1171 = ((select(_e1042, _e1153, (_e1153 > _e1042)) - _e355) * _e359);
                                                                let _e1174 = ((select(_e1055, _e1157, (_e1157 < _e1055)) - _e392) * _e397);
                                                                let _e1175 = ((select(_e1055, _e1161, (_e1161 > _e1055)) - _e393) * _e397);
                                                                let _e1177 = select(_e1175, _e1174, (_e1174 < _e1175));
                                                                let _e1179 = select(_e1175, _e1174, (_e1174 > _e1175));
                                                                let _e1181 = select(_e1167, _e1166, (_e1166 < _e1167));
                                                                let _e1183 = select(_e1171, _e1170, (_e1170 < _e1171));
                                                                let _e1185 = select(_e1183, _e1181, (_e1181 > _e1183));
                                                                let _e1187 = select(_e1177, _e1185, (_e1185 > _e1177));
                                                                let _e1189 = select(_e1167, _e1166, (_e1166 > _e1167));
                                                                let _e1191 = select(_e1171, _e1170, (_e1170 > _e1171));
                                                                let _e1193 = select(_e1191, _e1189, (_e1189 < _e1191));
                                                                let _e1195 = select(_e1179, _e1193, (_e1193 < _e1179));
                                                                let _e1196 = -(_e1177);
                                                                let _e1202 = select(_e444, _e1187, (_e1187 > _e444));
                                                                if (_e1202 > (_e1195 + (select(_e1196, _e1179, (_e1179 > _e1196)) * 0.0000019073523f))) {
                                                                    phi_2081_ = type_18();
                                                                    phi_2082_ = true;
                                                                } else {
                                                                    let _e1204 = (_e1202 > _e873);
                                                                    if _e1204 {
                                                                        phi_2080_ = type_18();
                                                                    } else {
                                                                        let _e1205 = vec3<f32>(_e935, _e955, _e975);
                                                                        let _e1206 = vec3<f32>(_e989, _e1002, _e1015);
                                                                        let _e1207 = vec3<f32>(_e1029, _e1042, _e1055);
                                                                        let _e1208 = (_e989 - _e935);
                                                                        let _e1209 = (_e1002 - _e955);
                                                                        let _e1210 = (_e1015 - _e975);
                                                                        let _e1211 = vec3<f32>(_e1208, _e1209, _e1210);
                                                                        let _e1212 = (_e1029 - _e989);
                                                                        let _e1213 = (_e1042 - _e1002);
                                                                        let _e1214 = (_e1055 - _e1015);
                                                                        let _e1215 = vec3<f32>(_e1212, _e1213, _e1214);
                                                                        let _e1216 = (_e935 - _e1029);
                                                                        let _e1217 = (_e955 - _e1042);
                                                                        let _e1218 = (_e975 - _e1055);
                                                                        let _e1219 = vec3<f32>(_e1216, _e1217, _e1218);
                                                                        let _e1222 = bitcast<f32>((bitcast<u32>(_e1208) & 2147483647u));
                                                                        let _e1225 = bitcast<f32>((bitcast<u32>(_e1209) & 2147483647u));
                                                                        let _e1227 = select(_e1225, _e1222, (_e1222 > _e1225));
                                                                        let _e1230 = bitcast<f32>((bitcast<u32>(_e1210) & 2147483647u));
                                                                        let _e1232 = select(_e1230, _e1227, (_e1227 > _e1230));
                                                                        let _e1235 = bitcast<f32>((bitcast<u32>(_e1212) & 2147483647u));
                                                                        let _e1238 = bitcast<f32>((bitcast<u32>(_e1213) & 2147483647u));
                                                                        let _e1240 = select(_e1238, _e1235, (_e1235 > _e1238));
                                                                        let _e1243 = bitcast<f32>((bitcast<u32>(_e1214) & 2147483647u));
                                                                        let _e1245 = select(_e1243, _e1240, (_e1240 > _e1243));
                                                                        let _e1248 = bitcast<f32>((bitcast<u32>(_e1216) & 2147483647u));
                                                                        let _e1251 = bitcast<f32>((bitcast<u32>(_e1217) & 2147483647u));
                                                                        let _e1253 = select(_e1251, _e1248, (_e1248 > _e1251));
                                                                        let _e1256 = bitcast<f32>((bitcast<u32>(_e1218) & 2147483647u));
                                                                        let _e1258 = select(_e1256, _e1253, (_e1253 > _e1256));
                                                                        let _e1260 = select(_e1245, _e1232, (_e1232 > _e1245));
                                                                        let _e1262 = select(_e1258, _e1260, (_e1260 > _e1258));
                                                                        if (_e1232 == _e1262) {
                                                                            phi_1810_ = _e1073;
                                                                            phi_1811_ = _e1070;
                                                                            phi_1812_ = _e1064;
                                                                            phi_1813_ = _e1061;
                                                                            phi_1814_ = _e1205;
                                                                            phi_1815_ = _e1219;
                                                                            phi_1816_ = _e1215;
                                                                            phi_1817_ = _e1211;
                                                                        } else {
                                                                            let _e1264 = (_e1245 == _e1262);
                                                                            let _e1269 = vec3(_e1264);
                                                                            phi_1810_ = select(_e1064, _e1082, _e1264);
                                                                            phi_1811_ = select(_e1061, _e1079, _e1264);
                                                                            phi_1812_ = select(_e1082, _e1073, _e1264);
                                                                            phi_1813_ = select(_e1079, _e1070, _e1264);
                                                                            phi_1814_ = select(_e1207, _e1206, _e1269);
                                                                            phi_1815_ = select(_e1215, _e1211, _e1269);
                                                                            phi_1816_ = select(_e1211, _e1219, _e1269);
                                                                            phi_1817_ = select(_e1219, _e1215, _e1269);
                                                                        }
                                                                        let _e1275 = phi_1810_;
                                                                        let _e1277 = phi_1811_;
                                                                        let _e1279 = phi_1812_;
                                                                        let _e1281 = phi_1813_;
                                                                        let _e1283 = phi_1814_;
                                                                        let _e1285 = phi_1815_;
                                                                        let _e1287 = phi_1816_;
                                                                        let _e1289 = phi_1817_;
                                                                        let _e1296 = ((_e1287.y * _e1285.z) - (_e1285.y * _e1287.z));
                                                                        let _e1301 = ((_e1287.z * _e1285.x) - (_e1285.z * _e1287.x));
                                                                        let _e1304 = ((_e1287.x * _e1285.y) - (_e1285.x * _e1287.y));
                                                                        if (_e1104 >= _e1108) {
                                                                            phi_1848_ = select(true, false, (_e1104 >= _e1112));
                                                                        } else {
                                                                            phi_1848_ = true;
                                                                        }
                                                                        let _e1309 = phi_1848_;
                                                                        if _e1309 {
                                                                            phi_1857_ = select(_e1207, _e1206, vec3((_e1108 >= _e1112)));
                                                                        } else {
                                                                            phi_1857_ = _e1205;
                                                                        }
                                                                        let _e1314 = phi_1857_;
                                                                        let _e1319 = (((_e1296 * _e318) + (_e1301 * _e356)) + (_e1304 * _e394));
                                                                        let _e1330 = (((_e1296 * (_e1314.x - _e293)) + (_e1301 * (_e1314.y - _e332))) + (_e1304 * (_e1314.z - _e370)));
                                                                        let _e1332 = (_e1277 - _e1281);
                                                                        let _e1333 = (_e1275 - _e1279);
                                                                        let _e1341 = (-(((_e1281 * _e1332) + (_e1279 * _e1333))) / ((_e1332 * _e1332) + (_e1333 * _e1333)));
                                                                        let _e1343 = select(1f, _e1341, (_e1341 < 1f));
                                                                        let _e1345 = select(0f, _e1343, (_e1343 > 0f));
                                                                        let _e1358 = ((_e1283.x + (_e1289.x * _e1345)) - _e293);
                                                                        let _e1359 = ((_e1283.y + (_e1289.y * _e1345)) - _e332);
                                                                        let _e1360 = ((_e1283.z + (_e1289.z * _e1345)) - _e370);
                                                                        let _e1361 = (_e1360 / _e394);
                                                                        let _e1373 = bitcast<f32>((bitcast<u32>(_e1358) & 2147483647u));
                                                                        let _e1376 = bitcast<f32>((bitcast<u32>(_e1359) & 2147483647u));
                                                                        let _e1378 = select(_e1376, _e1373, (_e1373 > _e1376));
                                                                        let _e1381 = bitcast<f32>((bitcast<u32>(_e1360) & 2147483647u));
                                                                        let _e1383 = select(_e1381, _e1378, (_e1378 > _e1381));
                                                                        let _e1389 = bitcast<f32>((bitcast<u32>(_e1296) & 2147483647u));
                                                                        let _e1392 = bitcast<f32>((bitcast<u32>(_e1301) & 2147483647u));
                                                                        let _e1394 = select(_e1392, _e1389, (_e1389 > _e1392));
                                                                        let _e1397 = bitcast<f32>((bitcast<u32>(_e1304) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1296 * _e1358) + (_e1301 * _e1359)) + (_e1304 * _e1360)) - _e1330)) & 2147483647u)) <= ((0.0000009536743f * select(_e1262, _e1383, (_e1383 > _e1262))) * select(_e1397, _e1394, (_e1394 > _e1397)))) {
                                                                            let _e1407 = bitcast<f32>((bitcast<u32>(_e1287.x) & 2147483647u));
                                                                            let _e1410 = bitcast<f32>((bitcast<u32>(_e1287.y) & 2147483647u));
                                                                            let _e1412 = select(_e1410, _e1407, (_e1407 > _e1410));
                                                                            let _e1415 = bitcast<f32>((bitcast<u32>(_e1287.z) & 2147483647u));
                                                                            let _e1421 = bitcast<f32>((bitcast<u32>(_e1285.x) & 2147483647u));
                                                                            let _e1424 = bitcast<f32>((bitcast<u32>(_e1285.y) & 2147483647u));
                                                                            let _e1426 = select(_e1424, _e1421, (_e1421 > _e1424));
                                                                            let _e1429 = bitcast<f32>((bitcast<u32>(_e1285.z) & 2147483647u));
                                                                            phi_2024_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e1319) & 2147483647u)) > ((0.0000038146973f * select(_e1415, _e1412, (_e1412 > _e1415))) * select(_e1429, _e1426, (_e1426 > _e1429)))));
                                                                        } else {
                                                                            phi_2024_ = true;
                                                                        }
                                                                        let _e1436 = phi_2024_;
                                                                        if _e1436 {
                                                                            let _e1447 = ((((_e1296 * (_e1358 - (_e318 * _e1361))) + (_e1301 * (_e1359 - (_e356 * _e1361)))) + (_e1304 * (_e1360 - _e1360))) / _e1319);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1447) & 2147483647u)) <= _e1262) {
                                                                                phi_2048_ = (_e1361 + _e1447);
                                                                            } else {
                                                                                phi_2048_ = _e1361;
                                                                            }
                                                                            let _e1454 = phi_2048_;
                                                                            phi_2049_ = _e1454;
                                                                        } else {
                                                                            phi_2049_ = (_e1330 / _e1319);
                                                                        }
                                                                        let _e1456 = phi_2049_;
                                                                        let _e1458 = select(_e1195, _e1456, (_e1456 < _e1195));
                                                                        let _e1460 = select(_e1187, _e1458, (_e1458 > _e1187));
                                                                        if (_e1460 >= _e444) {
                                                                            let _e1462 = (_e1460 <= _e873);
                                                                            if _e1462 {
                                                                                let _e1463 = (1f / _e1114);
                                                                                phi_2072_ = type_18(_e1460, (_e1108 * _e1463), (_e1112 * _e1463), _e901);
                                                                            } else {
                                                                                phi_2072_ = type_18();
                                                                            }
                                                                            let _e1468 = phi_2072_;
                                                                            phi_2074_ = _e1468;
                                                                            phi_2075_ = select(true, false, _e1462);
                                                                        } else {
                                                                            phi_2074_ = type_18();
                                                                            phi_2075_ = true;
                                                                        }
                                                                        let _e1471 = phi_2074_;
                                                                        let _e1473 = phi_2075_;
                                                                        if _e1473 {
                                                                            phi_2079_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2079_ = _e1471;
                                                                        }
                                                                        let _e1475 = phi_2079_;
                                                                        phi_2080_ = _e1475;
                                                                    }
                                                                    let _e1477 = phi_2080_;
                                                                    phi_2081_ = _e1477;
                                                                    phi_2082_ = _e1204;
                                                                }
                                                                let _e1479 = phi_2081_;
                                                                let _e1481 = phi_2082_;
                                                                phi_2086_ = _e1479;
                                                                phi_2087_ = _e1481;
                                                            }
                                                            let _e1483 = phi_2086_;
                                                            let _e1485 = phi_2087_;
                                                            phi_2088_ = _e1483;
                                                            phi_2089_ = _e1139;
                                                            phi_2090_ = _e1485;
                                                        }
                                                        let _e1487 = phi_2088_;
                                                        let _e1489 = phi_2089_;
                                                        let _e1491 = phi_2090_;
                                                        phi_2091_ = _e1487;
                                                        phi_2092_ = _e1489;
                                                        phi_2093_ = _e1491;
                                                    }
                                                    let _e1493 = phi_2091_;
                                                    let _e1495 = phi_2092_;
                                                    let _e1497 = phi_2093_;
                                                    phi_2101_ = _e1493;
                                                    phi_2102_ = select(_e1497, true, _e1495);
                                                } else {
                                                    phi_2101_ = type_18();
                                                    phi_2102_ = true;
                                                }
                                                let _e1500 = phi_2101_;
                                                let _e1502 = phi_2102_;
                                                if _e1502 {
                                                    phi_2106_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2106_ = _e1500;
                                                }
                                                let _e1504 = phi_2106_;
                                                if (_e1504.member_3 != 4294967295u) {
                                                    if (_e901 != 4294967295u) {
                                                        phi_2118_ = type_4(0u, 8u);
                                                        phi_2121_ = _e1504;
                                                        loop {
                                                            let _e1509 = phi_2118_;
                                                            let _e1511 = phi_2121_;
                                                            if (_e1509.member < _e1509.member_1) {
                                                                phi_2119_ = type_4((_e1509.member + 1u), _e1509.member_1);
                                                                phi_2144_ = type_4(1u, _e1509.member);
                                                            } else {
                                                                phi_2119_ = _e1509;
                                                                phi_2144_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1524 = phi_2119_;
                                                            let _e1526 = phi_2144_;
                                                            let _e1530 = (bitcast<i32>(_e1526.member) != 0i);
                                                            if _e1530 {
                                                                let _e1531 = (_e1526.member_1 < 8u);
                                                                if _e1531 {
                                                                } else {
                                                                    phi_3440_ = true;
                                                                    break;
                                                                }
                                                                let _e1536 = local_7[_e1526.member_1].member;
                                                                if (_e1511.member < _e1536) {
                                                                    phi_2177_ = true;
                                                                } else {
                                                                    let _e1538 = local_7[_e1526.member_1].member;
                                                                    if (_e1511.member == _e1538) {
                                                                        let _e1543 = local_7[_e1526.member_1].member_3;
                                                                        phi_2176_ = (_e1511.member_3 < _e1543);
                                                                    } else {
                                                                        phi_2176_ = false;
                                                                    }
                                                                    let _e1546 = phi_2176_;
                                                                    phi_2177_ = _e1546;
                                                                }
                                                                let _e1548 = phi_2177_;
                                                                if _e1548 {
                                                                    if _e1531 {
                                                                    } else {
                                                                        phi_3440_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1549 = local_7[_e1526.member_1];
                                                                    local_7[_e1526.member_1] = type_18(_e1511.member, _e1511.member_1, _e1511.member_2, _e1511.member_3);
                                                                    phi_2198_ = type_18(_e1549.member, _e1549.member_1, _e1549.member_2, _e1549.member_3);
                                                                } else {
                                                                    phi_2198_ = _e1511;
                                                                }
                                                                let _e1560 = phi_2198_;
                                                                phi_2122_ = _e1560;
                                                            } else {
                                                                phi_2122_ = type_18();
                                                            }
                                                            let _e1562 = phi_2122_;
                                                            continue;
                                                            continuing {
                                                                phi_2118_ = _e1524;
                                                                phi_2121_ = _e1562;
                                                                phi_3440_ = _e871;
                                                                break if !(_e1530);
                                                            }
                                                        }
                                                        let _e1565 = phi_3440_;
                                                        phi_3714_ = _e873;
                                                        phi_3600_ = _e1565;
                                                        if _e1565 {
                                                            break;
                                                        }
                                                        let _e1568 = local_7[7u].member_3;
                                                        if (_e1568 != 4294967295u) {
                                                            let _e1572 = local_7[7u].member;
                                                            phi_3805_ = _e1572;
                                                        } else {
                                                            phi_3805_ = _e873;
                                                        }
                                                        let _e1574 = phi_3805_;
                                                        phi_3804_ = _e1574;
                                                        phi_3603_ = _e1565;
                                                    } else {
                                                        phi_3804_ = _e873;
                                                        phi_3603_ = _e871;
                                                    }
                                                    let _e1576 = phi_3804_;
                                                    let _e1578 = phi_3603_;
                                                    phi_3803_ = _e1576;
                                                    phi_3602_ = _e1578;
                                                } else {
                                                    phi_3803_ = _e873;
                                                    phi_3602_ = _e871;
                                                }
                                                let _e1580 = phi_3803_;
                                                let _e1582 = phi_3602_;
                                                phi_3802_ = _e1580;
                                                phi_3601_ = _e1582;
                                            } else {
                                                phi_3802_ = _e873;
                                                phi_3601_ = _e871;
                                            }
                                            let _e1584 = phi_3802_;
                                            let _e1586 = phi_3601_;
                                            continue;
                                            continuing {
                                                phi_3467_ = _e1586;
                                                phi_3439_ = _e1584;
                                                phi_962_ = _e888;
                                                phi_3714_ = _e1584;
                                                phi_3600_ = _e1586;
                                                break if !(_e894);
                                            }
                                        }
                                        let _e1589 = phi_3714_;
                                        let _e1591 = phi_3600_;
                                        phi_3605_ = _e1591;
                                        if _e1591 {
                                            break;
                                        }
                                        phi_3679_ = _e1589;
                                        phi_3609_ = _e1591;
                                        phi_3159_ = _e515;
                                        phi_3160_ = false;
                                        phi_3161_ = _e519;
                                    } else {
                                        let _e529 = (_e515.member_1 < _e81);
                                        if _e529 {
                                            if _e529 {
                                            } else {
                                                phi_3605_ = true;
                                                break;
                                            }
                                            let _e531 = global_4.member[_e515.member_1];
                                            phi_2228_ = _e531;
                                        } else {
                                            phi_2228_ = type_39(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e533 = phi_2228_;
                                        let _e548 = ((10u * _e244) & 31u);
                                        let _e551 = ((_e533.member[0] >> bitcast<u32>(_e548)) & 1023u);
                                        let _e556 = bitcast<f32>((bitcast<u32>(((_e515.member.member_1[0] - _e515.member.member[0]) * 0.0009775171f)) ^ _e116));
                                        let _e562 = (_e515.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e551) * _e556)) ^ _e116)));
                                        let _e566 = select(select(_e515.member.member_1[0], _e562, (_e562 < _e515.member.member_1[0])), _e515.member.member_1[0], (_e551 == 1023u));
                                        let _e568 = ((10u * _e243) & 31u);
                                        let _e571 = ((_e533.member[0] >> bitcast<u32>(_e568)) & 1023u);
                                        let _e576 = bitcast<f32>((bitcast<u32>(((_e515.member.member_1[1] - _e515.member.member[1]) * 0.0009775171f)) ^ _e116));
                                        let _e582 = (_e515.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e571) * _e576)) ^ _e116)));
                                        let _e586 = select(select(_e515.member.member_1[1], _e582, (_e582 < _e515.member.member_1[1])), _e515.member.member_1[1], (_e571 == 1023u));
                                        let _e588 = ((10u * _e245) & 31u);
                                        let _e591 = ((_e533.member[0] >> bitcast<u32>(_e588)) & 1023u);
                                        let _e596 = bitcast<f32>((bitcast<u32>(((_e515.member.member_1[2] - _e515.member.member[2]) * 0.0009775171f)) ^ _e116));
                                        let _e602 = (_e515.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e591) * _e596)) ^ _e116)));
                                        let _e606 = select(select(_e515.member.member_1[2], _e602, (_e602 < _e515.member.member_1[2])), _e515.member.member_1[2], (_e591 == 1023u));
                                        let _e609 = ((_e533.member[1] >> bitcast<u32>(_e548)) & 1023u);
                                        let _e615 = (_e515.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e609) * _e556)) ^ _e116)));
                                        let _e619 = select(select(_e515.member.member_1[0], _e615, (_e615 < _e515.member.member_1[0])), _e515.member.member_1[0], (_e609 == 1023u));
                                        let _e622 = ((_e533.member[1] >> bitcast<u32>(_e568)) & 1023u);
                                        let _e628 = (_e515.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e622) * _e576)) ^ _e116)));
                                        let _e632 = select(select(_e515.member.member_1[1], _e628, (_e628 < _e515.member.member_1[1])), _e515.member.member_1[1], (_e622 == 1023u));
                                        let _e635 = ((_e533.member[1] >> bitcast<u32>(_e588)) & 1023u);
                                        let _e641 = (_e515.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e635) * _e596)) ^ _e116)));
                                        let _e645 = select(select(_e515.member.member_1[2], _e641, (_e641 < _e515.member.member_1[2])), _e515.member.member_1[2], (_e635 == 1023u));
                                        let _e651 = ((_e533.member_1[0] >> bitcast<u32>(_e548)) & 1023u);
                                        let _e657 = (_e515.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e651) * _e556)) ^ _e116)));
                                        let _e661 = select(select(_e515.member.member_1[0], _e657, (_e657 < _e515.member.member_1[0])), _e515.member.member_1[0], (_e651 == 1023u));
                                        let _e664 = ((_e533.member_1[0] >> bitcast<u32>(_e568)) & 1023u);
                                        let _e670 = (_e515.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e664) * _e576)) ^ _e116)));
                                        let _e674 = select(select(_e515.member.member_1[1], _e670, (_e670 < _e515.member.member_1[1])), _e515.member.member_1[1], (_e664 == 1023u));
                                        let _e677 = ((_e533.member_1[0] >> bitcast<u32>(_e588)) & 1023u);
                                        let _e683 = (_e515.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e677) * _e596)) ^ _e116)));
                                        let _e687 = select(select(_e515.member.member_1[2], _e683, (_e683 < _e515.member.member_1[2])), _e515.member.member_1[2], (_e677 == 1023u));
                                        let _e690 = ((_e533.member_1[1] >> bitcast<u32>(_e548)) & 1023u);
                                        let _e696 = (_e515.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e690) * _e556)) ^ _e116)));
                                        let _e700 = select(select(_e515.member.member_1[0], _e696, (_e696 < _e515.member.member_1[0])), _e515.member.member_1[0], (_e690 == 1023u));
                                        let _e703 = ((_e533.member_1[1] >> bitcast<u32>(_e568)) & 1023u);
                                        let _e709 = (_e515.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e703) * _e576)) ^ _e116)));
                                        let _e713 = select(select(_e515.member.member_1[1], _e709, (_e709 < _e515.member.member_1[1])), _e515.member.member_1[1], (_e703 == 1023u));
                                        let _e716 = ((_e533.member_1[1] >> bitcast<u32>(_e588)) & 1023u);
                                        let _e722 = (_e515.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e716) * _e596)) ^ _e116)));
                                        let _e726 = select(select(_e515.member.member_1[2], _e722, (_e722 < _e515.member.member_1[2])), _e515.member.member_1[2], (_e716 == 1023u));
                                        let _e731 = type_52(type_44(array<f32, 3>(_e566, _e586, _e606), array<f32, 3>(_e619, _e632, _e645)), _e533.member_2);
                                        let _e736 = type_52(type_44(array<f32, 3>(_e661, _e674, _e687), array<f32, 3>(_e700, _e713, _e726)), _e533.member_3);
                                        let _e741 = ((_e566 - _e316) * _e321);
                                        let _e742 = ((_e661 - _e316) * _e321);
                                        let _e743 = ((_e619 - _e317) * _e321);
                                        let _e744 = ((_e700 - _e317) * _e321);
                                        let _e749 = ((_e586 - _e354) * _e359);
                                        let _e750 = ((_e674 - _e354) * _e359);
                                        let _e751 = ((_e632 - _e355) * _e359);
                                        let _e752 = ((_e713 - _e355) * _e359);
                                        let _e757 = ((_e606 - _e392) * _e397);
                                        let _e758 = ((_e687 - _e392) * _e397);
                                        let _e759 = ((_e645 - _e393) * _e397);
                                        let _e760 = ((_e726 - _e393) * _e397);
                                        let _e762 = select(_e759, _e757, (_e757 < _e759));
                                        let _e764 = select(_e760, _e758, (_e758 < _e760));
                                        let _e766 = select(_e759, _e757, (_e757 > _e759));
                                        let _e768 = select(_e760, _e758, (_e758 > _e760));
                                        let _e770 = select(_e743, _e741, (_e741 < _e743));
                                        let _e772 = select(_e744, _e742, (_e742 < _e744));
                                        let _e774 = select(_e751, _e749, (_e749 < _e751));
                                        let _e776 = select(_e752, _e750, (_e750 < _e752));
                                        let _e778 = select(_e774, _e770, (_e770 > _e774));
                                        let _e780 = select(_e776, _e772, (_e772 > _e776));
                                        let _e782 = select(_e762, _e778, (_e778 > _e762));
                                        let _e784 = select(_e764, _e780, (_e780 > _e764));
                                        let _e786 = select(_e743, _e741, (_e741 > _e743));
                                        let _e788 = select(_e744, _e742, (_e742 > _e744));
                                        let _e790 = select(_e751, _e749, (_e749 > _e751));
                                        let _e792 = select(_e752, _e750, (_e750 > _e752));
                                        let _e794 = select(_e790, _e786, (_e786 < _e790));
                                        let _e796 = select(_e792, _e788, (_e788 < _e792));
                                        let _e801 = -(_e762);
                                        let _e802 = -(_e764);
                                        let _e809 = (select(_e766, _e794, (_e794 < _e766)) + (select(_e801, _e766, (_e766 > _e801)) * 0.0000019073523f));
                                        let _e810 = (select(_e768, _e796, (_e796 < _e768)) + (select(_e802, _e768, (_e768 > _e802)) * 0.0000019073523f));
                                        let _e812 = select(_e444, _e782, (_e782 > _e444));
                                        let _e814 = select(_e444, _e784, (_e784 > _e444));
                                        let _e819 = (_e812 <= select(_e477, _e809, (_e809 < _e477)));
                                        let _e820 = (_e814 <= select(_e477, _e810, (_e810 < _e477)));
                                        let _e821 = (_e812 <= _e814);
                                        if _e819 {
                                            if _e820 {
                                                if _e821 {
                                                    phi_3061_ = _e736;
                                                } else {
                                                    phi_3061_ = _e731;
                                                }
                                                let _e823 = phi_3061_;
                                                let _e831 = (_e519 % 128u);
                                                let _e832 = (_e831 < 128u);
                                                if _e832 {
                                                } else {
                                                    phi_3605_ = true;
                                                    break;
                                                }
                                                local_6[_e831] = _e823.member_1;
                                                if _e832 {
                                                } else {
                                                    phi_3605_ = true;
                                                    break;
                                                }
                                                local_5[_e831] = _e823.member.member[0];
                                                if _e832 {
                                                } else {
                                                    phi_3605_ = true;
                                                    break;
                                                }
                                                local_4[_e831] = _e823.member.member[1];
                                                if _e832 {
                                                } else {
                                                    phi_3605_ = true;
                                                    break;
                                                }
                                                local_3[_e831] = _e823.member.member[2];
                                                if _e832 {
                                                } else {
                                                    phi_3605_ = true;
                                                    break;
                                                }
                                                local_2[_e831] = _e823.member.member_1[0];
                                                if _e832 {
                                                } else {
                                                    phi_3605_ = true;
                                                    break;
                                                }
                                                local_1[_e831] = _e823.member.member_1[1];
                                                if _e832 {
                                                } else {
                                                    phi_3605_ = true;
                                                    break;
                                                }
                                                local[_e831] = _e823.member.member_1[2];
                                                if _e832 {
                                                } else {
                                                    phi_3605_ = true;
                                                    break;
                                                }
                                                local_8[_e831] = select(_e814, _e812, (_e812 > _e814));
                                                if _e821 {
                                                    phi_3138_ = _e731;
                                                } else {
                                                    phi_3138_ = _e736;
                                                }
                                                let _e849 = phi_3138_;
                                                phi_3139_ = _e849;
                                                phi_3140_ = (_e519 + 1u);
                                            } else {
                                                phi_3139_ = type_52();
                                                phi_3140_ = u32();
                                            }
                                            let _e851 = phi_3139_;
                                            let _e853 = phi_3140_;
                                            phi_3142_ = _e851;
                                            phi_3143_ = _e853;
                                            phi_3144_ = select(true, false, _e820);
                                        } else {
                                            phi_3142_ = type_52();
                                            phi_3143_ = u32();
                                            phi_3144_ = true;
                                        }
                                        let _e856 = phi_3142_;
                                        let _e858 = phi_3143_;
                                        let _e860 = phi_3144_;
                                        if _e860 {
                                            if _e819 {
                                                phi_3151_ = _e731;
                                            } else {
                                                phi_3151_ = _e736;
                                            }
                                            let _e862 = phi_3151_;
                                            phi_3156_ = _e862;
                                            phi_3157_ = select(_e820, true, _e819);
                                        } else {
                                            phi_3156_ = _e856;
                                            phi_3157_ = _e517;
                                        }
                                        let _e865 = phi_3156_;
                                        let _e867 = phi_3157_;
                                        phi_3679_ = _e477;
                                        phi_3609_ = _e475;
                                        phi_3159_ = _e865;
                                        phi_3160_ = _e867;
                                        phi_3161_ = select(_e858, _e519, _e860);
                                    }
                                    let _e1593 = phi_3679_;
                                    let _e1595 = phi_3609_;
                                    let _e1597 = phi_3159_;
                                    let _e1599 = phi_3160_;
                                    let _e1601 = phi_3161_;
                                    phi_3678_ = _e1593;
                                    phi_3608_ = _e1595;
                                    phi_3162_ = _e1597;
                                    phi_3163_ = (_e481 - 1u);
                                    phi_3164_ = _e1599;
                                    phi_3165_ = _e1601;
                                } else {
                                    phi_3678_ = _e477;
                                    phi_3608_ = _e475;
                                    phi_3162_ = _e515;
                                    phi_3163_ = _e481;
                                    phi_3164_ = _e517;
                                    phi_3165_ = _e519;
                                }
                                let _e1603 = phi_3678_;
                                let _e1605 = phi_3608_;
                                let _e1607 = phi_3162_;
                                let _e1609 = phi_3163_;
                                let _e1611 = phi_3164_;
                                let _e1613 = phi_3165_;
                                phi_3677_ = _e1603;
                                phi_3607_ = _e1605;
                                phi_3166_ = _e1607;
                                phi_3167_ = _e1609;
                                phi_3168_ = _e1611;
                                phi_3169_ = _e1613;
                            } else {
                                phi_3677_ = _e477;
                                phi_3607_ = _e475;
                                phi_3166_ = type_52();
                                phi_3167_ = u32();
                                phi_3168_ = bool();
                                phi_3169_ = u32();
                            }
                            let _e1615 = phi_3677_;
                            let _e1617 = phi_3607_;
                            let _e1619 = phi_3166_;
                            let _e1621 = phi_3167_;
                            let _e1623 = phi_3168_;
                            let _e1625 = phi_3169_;
                            phi_3676_ = _e1615;
                            phi_3606_ = _e1617;
                            phi_837_ = _e1619;
                            phi_840_ = _e1621;
                            phi_842_ = _e1623;
                            phi_844_ = _e1625;
                            phi_3170_ = _e489;
                        } else {
                            phi_3676_ = _e477;
                            phi_3606_ = _e475;
                            phi_837_ = type_52();
                            phi_840_ = u32();
                            phi_842_ = bool();
                            phi_844_ = u32();
                            phi_3170_ = false;
                        }
                        let _e1627 = phi_3676_;
                        let _e1629 = phi_3606_;
                        let _e1631 = phi_837_;
                        let _e1633 = phi_840_;
                        let _e1635 = phi_842_;
                        let _e1637 = phi_844_;
                        let _e1639 = phi_3170_;
                        continue;
                        continuing {
                            phi_3470_ = _e1629;
                            phi_3390_ = _e1627;
                            phi_836_ = _e1631;
                            phi_839_ = _e1633;
                            phi_841_ = _e1635;
                            phi_843_ = _e1637;
                            phi_3605_ = _e1629;
                            break if !(_e1639);
                        }
                    }
                    let _e1642 = phi_3605_;
                    if _e1642 {
                        break;
                    }
                    phi_3177_ = type_4(0u, 8u);
                    loop {
                        let _e1644 = phi_3177_;
                        if (_e1644.member < _e1644.member_1) {
                            phi_3178_ = type_4((_e1644.member + 1u), _e1644.member_1);
                            phi_3201_ = type_4(1u, _e1644.member);
                        } else {
                            phi_3178_ = _e1644;
                            phi_3201_ = type_4(0u, type_4().member_1);
                        }
                        let _e1657 = phi_3178_;
                        let _e1659 = phi_3201_;
                        let _e1663 = (bitcast<i32>(_e1659.member) != 0i);
                        if _e1663 {
                            let _e1664 = (_e1659.member_1 < 8u);
                            if _e1664 {
                            } else {
                                phi_3669_ = true;
                                break;
                            }
                            let _e1666 = local_7[_e1659.member_1];
                            if (_e1666.member_3 != 4294967295u) {
                                let _e1672 = -(_e411);
                                let _e1673 = (_e1672 / 3i);
                                let _e1680 = bitcast<f32>((bitcast<u32>((_e1673 + 127i)) << bitcast<u32>(23i)));
                                let _e1688 = (((_e1666.member * _e1680) * _e1680) * bitcast<f32>((bitcast<u32>(((_e1672 - (2i * _e1673)) + 127i)) << bitcast<u32>(23i))));
                                let _e1690 = select(340282350000000000000000000000000000000f, _e1688, (_e1688 < 340282350000000000000000000000000000000f));
                                phi_3267_ = type_18(select(-340282350000000000000000000000000000000f, _e1690, (_e1690 > -340282350000000000000000000000000000000f)), _e1666.member_1, _e1666.member_2, _e1666.member_3);
                            } else {
                                phi_3267_ = type_18(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1695 = phi_3267_;
                            if _e1664 {
                            } else {
                                phi_3669_ = true;
                                break;
                            }
                            local_7[_e1659.member_1] = type_18(_e1695.member, _e1695.member_1, _e1695.member_2, _e1695.member_3);
                        }
                        continue;
                        continuing {
                            phi_3177_ = _e1657;
                            phi_3669_ = _e1642;
                            break if !(_e1663);
                        }
                    }
                    let _e1703 = phi_3669_;
                    if _e1703 {
                        break;
                    }
                    let _e1704 = local_7;
                    if _e132 {
                    } else {
                        break;
                    }
                    global_5.member[_e130] = array<type_18, 8>(type_18(_e1704[0].member, _e1704[0].member_1, _e1704[0].member_2, _e1704[0].member_3), type_18(_e1704[1].member, _e1704[1].member_1, _e1704[1].member_2, _e1704[1].member_3), type_18(_e1704[2].member, _e1704[2].member_1, _e1704[2].member_2, _e1704[2].member_3), type_18(_e1704[3].member, _e1704[3].member_1, _e1704[3].member_2, _e1704[3].member_3), type_18(_e1704[4].member, _e1704[4].member_1, _e1704[4].member_2, _e1704[4].member_3), type_18(_e1704[5].member, _e1704[5].member_1, _e1704[5].member_2, _e1704[5].member_3), type_18(_e1704[6].member, _e1704[6].member_1, _e1704[6].member_2, _e1704[6].member_3), type_18(_e1704[7].member, _e1704[7].member_1, _e1704[7].member_2, _e1704[7].member_3));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_nearest_printed_leaf10_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
