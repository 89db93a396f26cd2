struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_9 {
    member: array<array<u32, 4>>,
}

struct type_12 {
    member: vec4<u32>,
}

struct type_17 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_19 {
    member: array<type_17>,
}

struct type_25 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_27 {
    member: array<type_25>,
}

struct type_29 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_33 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_37 {
    member: type_25,
    member_1: f32,
}

struct type_42 {
    member: array<type_29>,
}

struct type_45 {
    member: array<vec4<u32>, 2>,
}

struct type_50 {
    member: type_33,
    member_1: u32,
}

struct type_51 {
    member: array<vec4<f32>, 3>,
    member_1: type_50,
    member_2: type_50,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(3) 
var<storage> global_2: type_19;
@group(0) @binding(1) 
var<uniform> global_3: type_45;
@group(0) @binding(2) 
var<storage> global_4: type_9;
@group(0) @binding(4) 
var<storage> global_5: type_42;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_27;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<f32, 128>;
    var local_7: array<f32, 128>;
    var local_8: array<u32, 128>;
    var local_9: array<f32, 128>;
    var phi_374_: i32;
    var phi_375_: i32;
    var phi_385_: bool;
    var phi_395_: u32;
    var phi_396_: u32;
    var phi_398_: bool;
    var phi_403_: u32;
    var phi_415_: i32;
    var phi_435_: i32;
    var phi_453_: f32;
    var phi_459_: f32;
    var phi_470_: f32;
    var phi_476_: f32;
    var phi_499_: f32;
    var phi_510_: f32;
    var phi_519_: f32;
    var phi_525_: f32;
    var phi_536_: f32;
    var phi_542_: f32;
    var phi_565_: f32;
    var phi_576_: f32;
    var phi_585_: f32;
    var phi_591_: f32;
    var phi_602_: f32;
    var phi_608_: f32;
    var phi_631_: f32;
    var phi_642_: f32;
    var phi_742_: f32;
    var phi_743_: f32;
    var phi_3179_: bool;
    var phi_832_: type_37;
    var phi_835_: type_50;
    var phi_837_: u32;
    var phi_839_: bool;
    var phi_841_: u32;
    var phi_852_: bool;
    var phi_938_: type_50;
    var phi_939_: bool;
    var phi_940_: u32;
    var phi_2426_: u32;
    var phi_2427_: u32;
    var phi_2437_: u32;
    var phi_2439_: u32;
    var phi_2440_: bool;
    var phi_2460_: u32;
    var phi_2461_: u32;
    var phi_2465_: type_51;
    var phi_2809_: type_50;
    var phi_2886_: type_50;
    var phi_2887_: type_50;
    var phi_2888_: u32;
    var phi_2890_: type_50;
    var phi_2891_: u32;
    var phi_2892_: bool;
    var phi_2901_: type_50;
    var phi_2906_: type_50;
    var phi_2907_: bool;
    var phi_958_: type_37;
    var phi_961_: type_4;
    var phi_962_: type_4;
    var phi_984_: type_4;
    var phi_1005_: u32;
    var phi_1094_: array<array<f32, 3>, 3>;
    var phi_1565_: vec3<f32>;
    var phi_1566_: vec3<f32>;
    var phi_1597_: bool;
    var phi_1606_: vec3<f32>;
    var phi_1646_: type_25;
    var phi_1648_: type_25;
    var phi_1649_: bool;
    var phi_1653_: type_25;
    var phi_1654_: type_25;
    var phi_1655_: type_25;
    var phi_1656_: bool;
    var phi_1660_: type_25;
    var phi_1661_: bool;
    var phi_1665_: type_25;
    var phi_1666_: bool;
    var phi_1670_: type_25;
    var phi_1695_: bool;
    var phi_1696_: bool;
    var phi_1702_: type_37;
    var phi_1703_: type_37;
    var phi_1704_: type_37;
    var phi_959_: type_37;
    var phi_3173_: bool;
    var phi_3291_: bool;
    var phi_2909_: type_37;
    var phi_2910_: type_50;
    var phi_2911_: bool;
    var phi_2912_: u32;
    var phi_3290_: bool;
    var phi_2913_: type_37;
    var phi_2914_: type_50;
    var phi_2915_: u32;
    var phi_2916_: bool;
    var phi_2917_: u32;
    var phi_3289_: bool;
    var phi_2918_: type_37;
    var phi_2919_: type_50;
    var phi_2920_: u32;
    var phi_2921_: bool;
    var phi_2922_: u32;
    var phi_3288_: bool;
    var phi_833_: type_37;
    var phi_836_: type_50;
    var phi_838_: u32;
    var phi_840_: bool;
    var phi_842_: u32;
    var phi_2923_: bool;
    var phi_3287_: bool;
    var local_10: type_37;
    var phi_2975_: type_25;
    var local_11: type_37;

    switch bitcast<i32>(0u) {
        default: {
            let _e82 = global;
            let _e84 = arrayLength((&global_4.member));
            let _e86 = arrayLength((&global_2.member));
            let _e94 = global_3.member[0u][0u];
            let _e98 = global_3.member[0u][1u];
            let _e102 = global_3.member[0u][2u];
            let _e106 = global_3.member[0u][3u];
            let _e110 = global_3.member[1u][0u];
            let _e114 = global_3.member[1u][1u];
            let _e118 = global_3.member[1u][2u];
            let _e121 = global_1.member[0u];
            let _e122 = bitcast<i32>(_e121);
            let _e134 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e106) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e94), bitcast<i32>(_e98), bitcast<i32>(_e102));
            local = array<i32, 3>(bitcast<i32>(_e110), bitcast<i32>(_e114), bitcast<i32>(_e118));
            let _e140 = (_e82.x + (_e82.y * 2097152u));
            let _e141 = (_e140 < arrayLength((&global_5.member)));
            if _e141 {
                let _e142 = (_e140 < arrayLength((&global_6.member)));
                if _e142 {
                    if _e141 {
                    } else {
                        break;
                    }
                    let _e150 = global_5.member[_e140].member_2[0u];
                    let _e152 = (bitcast<u32>(_e150) & 2147483647u);
                    let _e157 = global_5.member[_e140].member_2[1u];
                    let _e159 = (bitcast<u32>(_e157) & 2147483647u);
                    let _e164 = global_5.member[_e140].member_2[2u];
                    let _e166 = (bitcast<u32>(_e164) & 2147483647u);
                    let _e171 = global_5.member[_e140].member[0u];
                    let _e173 = (bitcast<u32>(_e171) & 2147483647u);
                    let _e178 = global_5.member[_e140].member[1u];
                    let _e180 = (bitcast<u32>(_e178) & 2147483647u);
                    let _e185 = global_5.member[_e140].member[2u];
                    let _e187 = (bitcast<u32>(_e185) & 2147483647u);
                    let _e189 = select(_e159, _e152, (_e159 < _e152));
                    let _e191 = select(_e166, _e189, (_e166 < _e189));
                    let _e193 = select(_e173, _e191, (_e173 < _e191));
                    let _e195 = select(_e180, _e193, (_e180 < _e193));
                    let _e197 = select(_e187, _e195, (_e187 < _e195));
                    let _e201 = global_5.member[_e140].member_1;
                    let _e203 = (bitcast<u32>(_e201) & 2147483647u);
                    let _e210 = global_5.member[_e140].member_3;
                    let _e216 = (((select(_e203, _e197, (_e203 < _e197)) < 2139095040u) && ((bitcast<u32>(_e210) & 2147483647u) <= 2139095040u)) && (_e191 > 0u));
                    if _e216 {
                        let _e219 = (bitcast<u32>(bitcast<f32>(_e191)) & 2147483647u);
                        if (_e219 >= 8388608u) {
                            phi_374_ = (bitcast<i32>((_e219 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_374_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e219)), 32u, (_e219 == 0u))));
                        }
                        let _e233 = phi_374_;
                        phi_375_ = _e233;
                    } else {
                        phi_375_ = 0i;
                    }
                    let _e235 = phi_375_;
                    let _e236 = (_e152 == _e191);
                    if _e236 {
                        phi_385_ = true;
                    } else {
                        phi_385_ = (_e159 == _e191);
                    }
                    let _e239 = phi_385_;
                    let _e240 = select(1u, 0u, _e236);
                    if _e239 {
                        let _e241 = (_e240 + 1u);
                        phi_395_ = _e241;
                        phi_396_ = _e241;
                        phi_398_ = select(true, false, (_e241 == 2u));
                    } else {
                        phi_395_ = u32();
                        phi_396_ = 0u;
                        phi_398_ = true;
                    }
                    let _e245 = phi_395_;
                    let _e247 = phi_396_;
                    let _e249 = phi_398_;
                    if _e249 {
                        phi_403_ = (_e247 + 1u);
                    } else {
                        phi_403_ = 0u;
                    }
                    let _e253 = phi_403_;
                    let _e254 = select(_e245, _e247, _e249);
                    let _e255 = select(_e240, select(2u, _e240, _e239), _e249);
                    if (_e122 < -126i) {
                        phi_415_ = -126i;
                    } else {
                        phi_415_ = select(_e122, 127i, (_e122 > 127i));
                    }
                    let _e260 = phi_415_;
                    let _e265 = bitcast<f32>((bitcast<u32>((_e260 + 127i)) << bitcast<u32>(23i)));
                    let _e271 = bitcast<f32>((bitcast<u32>(((_e122 - _e260) + 127i)) << bitcast<u32>(23i)));
                    let _e272 = -(_e235);
                    if (_e272 < -126i) {
                        phi_435_ = -126i;
                    } else {
                        phi_435_ = select(_e272, 127i, (_e272 > 127i));
                    }
                    let _e277 = phi_435_;
                    let _e282 = bitcast<f32>((bitcast<u32>((_e277 + 127i)) << bitcast<u32>(23i)));
                    let _e288 = bitcast<f32>((bitcast<u32>(((_e272 - _e277) + 127i)) << bitcast<u32>(23i)));
                    let _e292 = global_5.member[_e140].member;
                    let _e293 = (_e254 == 0u);
                    if _e293 {
                        phi_453_ = _e292[0];
                    } else {
                        phi_453_ = _e292[1];
                    }
                    let _e297 = phi_453_;
                    let _e298 = (_e254 == 2u);
                    if _e298 {
                        phi_459_ = _e292[2];
                    } else {
                        phi_459_ = _e297;
                    }
                    let _e301 = phi_459_;
                    let _e303 = ((_e301 * _e265) * _e271);
                    let _e304 = global_5.member[_e140].member_2;
                    if _e293 {
                        phi_470_ = _e304[0];
                    } else {
                        phi_470_ = _e304[1];
                    }
                    let _e308 = phi_470_;
                    if _e298 {
                        phi_476_ = _e304[2];
                    } else {
                        phi_476_ = _e308;
                    }
                    let _e311 = phi_476_;
                    let _e313 = ((_e311 * _e282) * _e288);
                    let _e317 = (bitcast<f32>((bitcast<u32>(_e313) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e317 {
                        let _e321 = (bitcast<f32>((bitcast<u32>(_e303) & 2147483647u)) * 0.00000011920929f);
                        phi_499_ = select(0.00000000000011368684f, _e321, (_e321 > 0.00000000000011368684f));
                    } else {
                        phi_499_ = 0f;
                    }
                    let _e325 = phi_499_;
                    let _e326 = (_e303 + _e325);
                    let _e327 = (_e303 - _e325);
                    let _e328 = select(_e313, 0f, _e317);
                    if _e317 {
                        phi_510_ = 38685626000000000000000000f;
                    } else {
                        phi_510_ = (1f / _e313);
                    }
                    let _e331 = phi_510_;
                    let _e332 = (_e253 == 0u);
                    if _e332 {
                        phi_519_ = _e292[0];
                    } else {
                        phi_519_ = _e292[1];
                    }
                    let _e336 = phi_519_;
                    let _e337 = (_e253 == 2u);
                    if _e337 {
                        phi_525_ = _e292[2];
                    } else {
                        phi_525_ = _e336;
                    }
                    let _e340 = phi_525_;
                    let _e342 = ((_e340 * _e265) * _e271);
                    if _e332 {
                        phi_536_ = _e304[0];
                    } else {
                        phi_536_ = _e304[1];
                    }
                    let _e346 = phi_536_;
                    if _e337 {
                        phi_542_ = _e304[2];
                    } else {
                        phi_542_ = _e346;
                    }
                    let _e349 = phi_542_;
                    let _e351 = ((_e349 * _e282) * _e288);
                    let _e355 = (bitcast<f32>((bitcast<u32>(_e351) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e355 {
                        let _e359 = (bitcast<f32>((bitcast<u32>(_e342) & 2147483647u)) * 0.00000011920929f);
                        phi_565_ = select(0.00000000000011368684f, _e359, (_e359 > 0.00000000000011368684f));
                    } else {
                        phi_565_ = 0f;
                    }
                    let _e363 = phi_565_;
                    let _e364 = (_e342 + _e363);
                    let _e365 = (_e342 - _e363);
                    let _e366 = select(_e351, 0f, _e355);
                    if _e355 {
                        phi_576_ = 38685626000000000000000000f;
                    } else {
                        phi_576_ = (1f / _e351);
                    }
                    let _e369 = phi_576_;
                    let _e370 = (_e255 == 0u);
                    if _e370 {
                        phi_585_ = _e292[0];
                    } else {
                        phi_585_ = _e292[1];
                    }
                    let _e374 = phi_585_;
                    let _e375 = (_e255 == 2u);
                    if _e375 {
                        phi_591_ = _e292[2];
                    } else {
                        phi_591_ = _e374;
                    }
                    let _e378 = phi_591_;
                    let _e380 = ((_e378 * _e265) * _e271);
                    if _e370 {
                        phi_602_ = _e304[0];
                    } else {
                        phi_602_ = _e304[1];
                    }
                    let _e384 = phi_602_;
                    if _e375 {
                        phi_608_ = _e304[2];
                    } else {
                        phi_608_ = _e384;
                    }
                    let _e387 = phi_608_;
                    let _e389 = ((_e387 * _e282) * _e288);
                    let _e393 = (bitcast<f32>((bitcast<u32>(_e389) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e393 {
                        let _e397 = (bitcast<f32>((bitcast<u32>(_e380) & 2147483647u)) * 0.00000011920929f);
                        phi_631_ = select(0.00000000000011368684f, _e397, (_e397 > 0.00000000000011368684f));
                    } else {
                        phi_631_ = 0f;
                    }
                    let _e401 = phi_631_;
                    let _e402 = (_e380 + _e401);
                    let _e403 = (_e380 - _e401);
                    let _e404 = select(_e389, 0f, _e393);
                    if _e393 {
                        phi_642_ = 38685626000000000000000000f;
                    } else {
                        phi_642_ = (1f / _e389);
                    }
                    let _e407 = phi_642_;
                    let _e410 = bitcast<f32>((bitcast<u32>(_e303) & 2147483647u));
                    let _e413 = bitcast<f32>((bitcast<u32>(_e342) & 2147483647u));
                    let _e415 = select(_e413, _e410, (_e410 > _e413));
                    let _e418 = bitcast<f32>((bitcast<u32>(_e380) & 2147483647u));
                    let _e421 = (_e122 + _e235);
                    if (_e216 && (select(_e418, _e415, (_e415 > _e418)) <= 1099511600000f)) {
                        let _e424 = (_e421 / 3i);
                        let _e431 = bitcast<f32>((bitcast<u32>((_e424 + 127i)) << bitcast<u32>(23i)));
                        let _e438 = bitcast<f32>((bitcast<u32>(((_e421 - (2i * _e424)) + 127i)) << bitcast<u32>(23i)));
                        let _e439 = (((_e201 * _e431) * _e431) * _e438);
                        let _e441 = select(340282350000000000000000000000000000000f, _e439, (_e439 < 340282350000000000000000000000000000000f));
                        let _e446 = (((_e210 * _e431) * _e431) * _e438);
                        let _e448 = select(340282350000000000000000000000000000000f, _e446, (_e446 < 340282350000000000000000000000000000000f));
                        phi_742_ = select(-340282350000000000000000000000000000000f, _e448, (_e448 > -340282350000000000000000000000000000000f));
                        phi_743_ = select(-340282350000000000000000000000000000000f, _e441, (_e441 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_742_ = 0f;
                        phi_743_ = 1f;
                    }
                    let _e452 = phi_742_;
                    let _e454 = phi_743_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e458 = (_e254 % 3u);
                    let _e459 = (_e458 < 3u);
                    if _e459 {
                    } else {
                        break;
                    }
                    let _e461 = local_1[_e458];
                    let _e464 = (_e253 % 3u);
                    let _e465 = (_e464 < 3u);
                    if _e465 {
                    } else {
                        break;
                    }
                    let _e467 = local_1[_e464];
                    let _e470 = (_e255 % 3u);
                    let _e471 = (_e470 < 3u);
                    if _e471 {
                    } else {
                        break;
                    }
                    let _e473 = local_1[_e470];
                    if _e459 {
                    } else {
                        break;
                    }
                    let _e478 = local[_e458];
                    if _e465 {
                    } else {
                        break;
                    }
                    let _e482 = local[_e464];
                    if _e471 {
                    } else {
                        break;
                    }
                    let _e486 = local[_e470];
                    phi_3179_ = false;
                    phi_832_ = type_37(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e452);
                    phi_835_ = type_50(type_33(vec4<f32>((f32(_e461) * _e134), (f32(_e467) * _e134), (f32(_e473) * _e134), 0f), vec4<f32>((f32(_e478) * _e134), (f32(_e482) * _e134), (f32(_e486) * _e134), 0f)), select(0u, 2147483648u, (_e84 == 0u)));
                    phi_837_ = ((3u * _e84) + 1u);
                    phi_839_ = (_e454 <= _e452);
                    phi_841_ = 0u;
                    loop {
                        let _e496 = phi_3179_;
                        let _e498 = phi_832_;
                        let _e500 = phi_835_;
                        let _e502 = phi_837_;
                        let _e504 = phi_839_;
                        let _e506 = phi_841_;
                        local_10 = _e498;
                        if _e504 {
                            phi_852_ = true;
                        } else {
                            phi_852_ = (_e506 > 0u);
                        }
                        let _e509 = phi_852_;
                        if _e509 {
                            let _e510 = (_e502 > 0u);
                            if _e510 {
                                if _e504 {
                                    phi_938_ = _e500;
                                    phi_939_ = _e504;
                                    phi_940_ = _e506;
                                } else {
                                    let _e511 = (_e506 - 1u);
                                    let _e512 = (_e511 % 128u);
                                    let _e513 = (_e512 < 128u);
                                    if _e513 {
                                    } else {
                                        phi_3287_ = true;
                                        break;
                                    }
                                    let _e515 = local_7[_e512];
                                    if _e513 {
                                    } else {
                                        phi_3287_ = true;
                                        break;
                                    }
                                    let _e517 = local_6[_e512];
                                    if _e513 {
                                    } else {
                                        phi_3287_ = true;
                                        break;
                                    }
                                    let _e519 = local_5[_e512];
                                    if _e513 {
                                    } else {
                                        phi_3287_ = true;
                                        break;
                                    }
                                    let _e521 = local_4[_e512];
                                    if _e513 {
                                    } else {
                                        phi_3287_ = true;
                                        break;
                                    }
                                    let _e523 = local_3[_e512];
                                    if _e513 {
                                    } else {
                                        phi_3287_ = true;
                                        break;
                                    }
                                    let _e525 = local_2[_e512];
                                    if _e513 {
                                    } else {
                                        phi_3287_ = true;
                                        break;
                                    }
                                    let _e530 = local_8[_e512];
                                    if _e513 {
                                    } else {
                                        phi_3287_ = true;
                                        break;
                                    }
                                    let _e533 = local_9[_e512];
                                    phi_938_ = type_50(type_33(vec4<f32>(_e515, _e517, _e519, 0f), vec4<f32>(_e521, _e523, _e525, 0f)), _e530);
                                    phi_939_ = (_e533 <= _e498.member_1);
                                    phi_940_ = _e511;
                                }
                                let _e537 = phi_938_;
                                let _e539 = phi_939_;
                                let _e541 = phi_940_;
                                if _e539 {
                                    if ((_e537.member_1 & 2147483648u) != 0u) {
                                        phi_958_ = _e498;
                                        phi_961_ = type_4(0u, ((_e537.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e985 = phi_958_;
                                            let _e987 = phi_961_;
                                            local_11 = _e985;
                                            if (_e987.member < _e987.member_1) {
                                                phi_962_ = type_4((_e987.member + 1u), _e987.member_1);
                                                phi_984_ = type_4(1u, _e987.member);
                                            } else {
                                                phi_962_ = _e987;
                                                phi_984_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1000 = phi_962_;
                                            let _e1002 = phi_984_;
                                            let _e1006 = (bitcast<i32>(_e1002.member) != 0i);
                                            if _e1006 {
                                                let _e1007 = ((_e537.member_1 & 268435455u) + _e1002.member_1);
                                                let _e1008 = (_e1007 < _e86);
                                                if _e1008 {
                                                    if _e1008 {
                                                    } else {
                                                        phi_3173_ = true;
                                                        break;
                                                    }
                                                    let _e1012 = global_2.member[_e1007].member_1;
                                                    phi_1005_ = _e1012;
                                                } else {
                                                    phi_1005_ = 4294967295u;
                                                }
                                                let _e1014 = phi_1005_;
                                                if (_e1007 >= _e86) {
                                                    phi_1094_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1008 {
                                                    } else {
                                                        phi_3173_ = true;
                                                        break;
                                                    }
                                                    if (_e458 < 9u) {
                                                    } else {
                                                        phi_3173_ = true;
                                                        break;
                                                    }
                                                    let _e1021 = global_2.member[_e1007].member[_e458];
                                                    if (_e464 < 9u) {
                                                    } else {
                                                        phi_3173_ = true;
                                                        break;
                                                    }
                                                    let _e1027 = global_2.member[_e1007].member[_e464];
                                                    if (_e470 < 9u) {
                                                    } else {
                                                        phi_3173_ = true;
                                                        break;
                                                    }
                                                    let _e1033 = global_2.member[_e1007].member[_e470];
                                                    let _e1035 = (3u + _e458);
                                                    if (_e1035 < 9u) {
                                                    } else {
                                                        phi_3173_ = true;
                                                        break;
                                                    }
                                                    let _e1041 = global_2.member[_e1007].member[_e1035];
                                                    let _e1042 = (3u + _e464);
                                                    if (_e1042 < 9u) {
                                                    } else {
                                                        phi_3173_ = true;
                                                        break;
                                                    }
                                                    let _e1048 = global_2.member[_e1007].member[_e1042];
                                                    let _e1049 = (3u + _e470);
                                                    if (_e1049 < 9u) {
                                                    } else {
                                                        phi_3173_ = true;
                                                        break;
                                                    }
                                                    let _e1055 = global_2.member[_e1007].member[_e1049];
                                                    let _e1057 = (6u + _e458);
                                                    if (_e1057 < 9u) {
                                                    } else {
                                                        phi_3173_ = true;
                                                        break;
                                                    }
                                                    let _e1063 = global_2.member[_e1007].member[_e1057];
                                                    let _e1064 = (6u + _e464);
                                                    if (_e1064 < 9u) {
                                                    } else {
                                                        phi_3173_ = true;
                                                        break;
                                                    }
                                                    let _e1070 = global_2.member[_e1007].member[_e1064];
                                                    let _e1071 = (6u + _e470);
                                                    if (_e1071 < 9u) {
                                                    } else {
                                                        phi_3173_ = true;
                                                        break;
                                                    }
                                                    let _e1077 = global_2.member[_e1007].member[_e1071];
                                                    phi_1094_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1021, _e1027, _e1033), array<f32, 3>(_e1041, _e1048, _e1055), array<f32, 3>(_e1063, _e1070, _e1077));
                                                }
                                                let _e1081 = phi_1094_;
                                                let _e1089 = (_e1081[0][2] - _e380);
                                                let _e1092 = (((_e1081[0][0] - _e303) * _e404) - (_e1089 * _e328));
                                                let _e1095 = (((_e1081[0][1] - _e342) * _e404) - (_e1089 * _e366));
                                                let _e1102 = (_e1081[1][2] - _e380);
                                                let _e1105 = (((_e1081[1][0] - _e303) * _e404) - (_e1102 * _e328));
                                                let _e1108 = (((_e1081[1][1] - _e342) * _e404) - (_e1102 * _e366));
                                                let _e1115 = (_e1081[2][2] - _e380);
                                                let _e1118 = (((_e1081[2][0] - _e303) * _e404) - (_e1115 * _e328));
                                                let _e1121 = (((_e1081[2][1] - _e342) * _e404) - (_e1115 * _e366));
                                                let _e1122 = (_e1118 * _e1108);
                                                let _e1123 = (_e1121 * _e1105);
                                                let _e1124 = (_e1092 * _e1121);
                                                let _e1125 = (_e1095 * _e1118);
                                                let _e1126 = (_e1105 * _e1095);
                                                let _e1127 = (_e1108 * _e1092);
                                                let _e1132 = (((_e1122 >= _e1123) && (_e1124 >= _e1125)) && (_e1126 >= _e1127));
                                                if (_e1132 || (((_e1122 <= _e1123) && (_e1124 <= _e1125)) && (_e1126 <= _e1127))) {
                                                    let _e1139 = select(-1f, 1f, _e1132);
                                                    let _e1141 = ((_e1122 - _e1123) * _e1139);
                                                    let _e1143 = select(0f, _e1141, (_e1141 > 0f));
                                                    let _e1145 = ((_e1124 - _e1125) * _e1139);
                                                    let _e1147 = select(0f, _e1145, (_e1145 > 0f));
                                                    let _e1149 = ((_e1126 - _e1127) * _e1139);
                                                    let _e1151 = select(0f, _e1149, (_e1149 > 0f));
                                                    let _e1153 = ((_e1143 + _e1147) + _e1151);
                                                    if (_e1153 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1660_ = type_25();
                                                        phi_1661_ = true;
                                                    } else {
                                                        let _e1156 = select(_e1081[1][0], _e1081[0][0], (_e1081[0][0] < _e1081[1][0]));
                                                        let _e1160 = select(_e1081[1][0], _e1081[0][0], (_e1081[0][0] > _e1081[1][0]));
                                                        let _e1164 = select(_e1081[1][1], _e1081[0][1], (_e1081[0][1] < _e1081[1][1]));
                                                        let _e1168 = select(_e1081[1][1], _e1081[0][1], (_e1081[0][1] > _e1081[1][1]));
                                                        let _e1172 = select(_e1081[1][2], _e1081[0][2], (_e1081[0][2] < _e1081[1][2]));
                                                        let _e1176 = select(_e1081[1][2], _e1081[0][2], (_e1081[0][2] > _e1081[1][2]));
                                                        let _e1181 = ((select(_e1081[2][0], _e1156, (_e1156 < _e1081[2][0])) - _e326) * _e331);
                                                        let _e1182 = ((select(_e1081[2][0], _e1160, (_e1160 > _e1081[2][0])) - _e327) * _e331);
                                                        let _e1185 = ((select(_e1081[2][1], _e1164, (_e1164 < _e1081[2][1])) - _e364) * _e369);
                                                        let _e1186 = ((select(_e1081[2][1], _e1168, (_e1168 > _e1081[2][1])) - _e365) * _e369);
                                                        let _e1189 = ((select(_e1081[2][2], _e1172, (_e1172 < _e1081[2][2])) - _e402) * _e407);
                                                        let _e1190 = ((select(_e1081[2][2], _e1176, (_e1176 > _e1081[2][2])) - _e403) * _e407);
                                                        let _e1192 = select(_e1190, _e1189, (_e1189 < _e1190));
                                                        let _e1194 = select(_e1190, _e1189, (_e1189 > _e1190));
                                                        let _e1196 = select(_e1182, _e1181, (_e1181 < _e1182));
                                                        let _e1198 = select(_e1186, _e1185, (_e1185 < _e1186));
                                                        let _e1200 = select(_e1198, _e1196, (_e1196 > _e1198));
                                                        let _e1202 = select(_e1192, _e1200, (_e1200 > _e1192));
                                                        let _e1204 = select(_e1182, _e1181, (_e1181 > _e1182));
                                                        let _e1206 = select(_e1186, _e1185, (_e1185 > _e1186));
                                                        let _e1208 = select(_e1206, _e1204, (_e1204 < _e1206));
                                                        let _e1210 = select(_e1194, _e1208, (_e1208 < _e1194));
                                                        let _e1211 = -(_e1192);
                                                        let _e1217 = select(_e454, _e1202, (_e1202 > _e454));
                                                        if (_e1217 > (_e1210 + (select(_e1211, _e1194, (_e1194 > _e1211)) * 0.0000019073523f))) {
                                                            phi_1655_ = type_25();
                                                            phi_1656_ = true;
                                                        } else {
                                                            let _e1219 = (_e1217 > _e985.member_1);
                                                            if _e1219 {
                                                                phi_1654_ = type_25();
                                                            } else {
                                                                let _e1223 = (_e1081[1][0] - _e1081[0][0]);
                                                                let _e1224 = (_e1081[1][1] - _e1081[0][1]);
                                                                let _e1225 = (_e1081[1][2] - _e1081[0][2]);
                                                                let _e1226 = vec3<f32>(_e1223, _e1224, _e1225);
                                                                let _e1227 = (_e1081[2][0] - _e1081[1][0]);
                                                                let _e1228 = (_e1081[2][1] - _e1081[1][1]);
                                                                let _e1229 = (_e1081[2][2] - _e1081[1][2]);
                                                                let _e1230 = vec3<f32>(_e1227, _e1228, _e1229);
                                                                let _e1231 = (_e1081[0][0] - _e1081[2][0]);
                                                                let _e1232 = (_e1081[0][1] - _e1081[2][1]);
                                                                let _e1233 = (_e1081[0][2] - _e1081[2][2]);
                                                                let _e1234 = vec3<f32>(_e1231, _e1232, _e1233);
                                                                let _e1237 = bitcast<f32>((bitcast<u32>(_e1223) & 2147483647u));
                                                                let _e1240 = bitcast<f32>((bitcast<u32>(_e1224) & 2147483647u));
                                                                let _e1242 = select(_e1240, _e1237, (_e1237 > _e1240));
                                                                let _e1245 = bitcast<f32>((bitcast<u32>(_e1225) & 2147483647u));
                                                                let _e1247 = select(_e1245, _e1242, (_e1242 > _e1245));
                                                                let _e1250 = bitcast<f32>((bitcast<u32>(_e1227) & 2147483647u));
                                                                let _e1253 = bitcast<f32>((bitcast<u32>(_e1228) & 2147483647u));
                                                                let _e1255 = select(_e1253, _e1250, (_e1250 > _e1253));
                                                                let _e1258 = bitcast<f32>((bitcast<u32>(_e1229) & 2147483647u));
                                                                let _e1260 = select(_e1258, _e1255, (_e1255 > _e1258));
                                                                let _e1263 = bitcast<f32>((bitcast<u32>(_e1231) & 2147483647u));
                                                                let _e1266 = bitcast<f32>((bitcast<u32>(_e1232) & 2147483647u));
                                                                let _e1268 = select(_e1266, _e1263, (_e1263 > _e1266));
                                                                let _e1271 = bitcast<f32>((bitcast<u32>(_e1233) & 2147483647u));
                                                                let _e1273 = select(_e1271, _e1268, (_e1268 > _e1271));
                                                                let _e1275 = select(_e1260, _e1247, (_e1247 > _e1260));
                                                                let _e1277 = select(_e1273, _e1275, (_e1275 > _e1273));
                                                                if (_e1247 == _e1277) {
                                                                    phi_1565_ = _e1230;
                                                                    phi_1566_ = _e1234;
                                                                } else {
                                                                    let _e1280 = vec3((_e1260 == _e1277));
                                                                    phi_1565_ = select(_e1226, _e1234, _e1280);
                                                                    phi_1566_ = select(_e1230, _e1226, _e1280);
                                                                }
                                                                let _e1284 = phi_1565_;
                                                                let _e1286 = phi_1566_;
                                                                let _e1293 = ((_e1284.y * _e1286.z) - (_e1286.y * _e1284.z));
                                                                let _e1298 = ((_e1284.z * _e1286.x) - (_e1286.z * _e1284.x));
                                                                let _e1301 = ((_e1284.x * _e1286.y) - (_e1286.x * _e1284.y));
                                                                if (_e1143 >= _e1147) {
                                                                    phi_1597_ = select(true, false, (_e1143 >= _e1151));
                                                                } else {
                                                                    phi_1597_ = true;
                                                                }
                                                                let _e1306 = phi_1597_;
                                                                if _e1306 {
                                                                    phi_1606_ = select(vec3<f32>(_e1081[2][0], _e1081[2][1], _e1081[2][2]), vec3<f32>(_e1081[1][0], _e1081[1][1], _e1081[1][2]), vec3((_e1147 >= _e1151)));
                                                                } else {
                                                                    phi_1606_ = vec3<f32>(_e1081[0][0], _e1081[0][1], _e1081[0][2]);
                                                                }
                                                                let _e1311 = phi_1606_;
                                                                let _e1328 = ((((_e1293 * (_e1311.x - _e303)) + (_e1298 * (_e1311.y - _e342))) + (_e1301 * (_e1311.z - _e380))) / (((_e1293 * _e328) + (_e1298 * _e366)) + (_e1301 * _e404)));
                                                                let _e1330 = select(_e1210, _e1328, (_e1328 < _e1210));
                                                                let _e1332 = select(_e1202, _e1330, (_e1330 > _e1202));
                                                                if (_e1332 >= _e454) {
                                                                    let _e1334 = (_e1332 <= _e985.member_1);
                                                                    if _e1334 {
                                                                        let _e1335 = (1f / _e1153);
                                                                        phi_1646_ = type_25(_e1332, (_e1147 * _e1335), (_e1151 * _e1335), _e1014);
                                                                    } else {
                                                                        phi_1646_ = type_25();
                                                                    }
                                                                    let _e1340 = phi_1646_;
                                                                    phi_1648_ = _e1340;
                                                                    phi_1649_ = select(true, false, _e1334);
                                                                } else {
                                                                    phi_1648_ = type_25();
                                                                    phi_1649_ = true;
                                                                }
                                                                let _e1343 = phi_1648_;
                                                                let _e1345 = phi_1649_;
                                                                if _e1345 {
                                                                    phi_1653_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1653_ = _e1343;
                                                                }
                                                                let _e1347 = phi_1653_;
                                                                phi_1654_ = _e1347;
                                                            }
                                                            let _e1349 = phi_1654_;
                                                            phi_1655_ = _e1349;
                                                            phi_1656_ = _e1219;
                                                        }
                                                        let _e1351 = phi_1655_;
                                                        let _e1353 = phi_1656_;
                                                        phi_1660_ = _e1351;
                                                        phi_1661_ = _e1353;
                                                    }
                                                    let _e1355 = phi_1660_;
                                                    let _e1357 = phi_1661_;
                                                    phi_1665_ = _e1355;
                                                    phi_1666_ = _e1357;
                                                } else {
                                                    phi_1665_ = type_25();
                                                    phi_1666_ = true;
                                                }
                                                let _e1359 = phi_1665_;
                                                let _e1361 = phi_1666_;
                                                if _e1361 {
                                                    phi_1670_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1670_ = _e1359;
                                                }
                                                let _e1363 = phi_1670_;
                                                if (_e1363.member_3 != 4294967295u) {
                                                    if (_e1014 != 4294967295u) {
                                                        if (_e1363.member < _e985.member.member) {
                                                            phi_1696_ = true;
                                                        } else {
                                                            if (_e1363.member == _e985.member.member) {
                                                                phi_1695_ = (_e1363.member_3 < _e985.member.member_3);
                                                            } else {
                                                                phi_1695_ = false;
                                                            }
                                                            let _e1376 = phi_1695_;
                                                            phi_1696_ = _e1376;
                                                        }
                                                        let _e1378 = phi_1696_;
                                                        if _e1378 {
                                                            phi_1702_ = type_37(_e1363, _e1363.member);
                                                        } else {
                                                            phi_1702_ = _e985;
                                                        }
                                                        let _e1381 = phi_1702_;
                                                        phi_1703_ = _e1381;
                                                    } else {
                                                        phi_1703_ = _e985;
                                                    }
                                                    let _e1383 = phi_1703_;
                                                    phi_1704_ = _e1383;
                                                } else {
                                                    phi_1704_ = _e985;
                                                }
                                                let _e1385 = phi_1704_;
                                                phi_959_ = _e1385;
                                            } else {
                                                phi_959_ = type_37();
                                            }
                                            let _e1387 = phi_959_;
                                            continue;
                                            continuing {
                                                phi_958_ = _e1387;
                                                phi_961_ = _e1000;
                                                phi_3173_ = _e496;
                                                break if !(_e1006);
                                            }
                                        }
                                        let _e1390 = phi_3173_;
                                        phi_3287_ = _e1390;
                                        if _e1390 {
                                            break;
                                        }
                                        phi_3291_ = _e1390;
                                        let _e1565 = local_11;
                                        phi_2909_ = _e1565;
                                        phi_2910_ = _e537;
                                        phi_2911_ = false;
                                        phi_2912_ = _e541;
                                    } else {
                                        if (_e537.member_1 >= _e84) {
                                            phi_2465_ = type_51(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_50(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_50(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e537.member_1 < _e84) {
                                            } else {
                                                phi_3287_ = true;
                                                break;
                                            }
                                            let _e553 = ((1u + _e254) % 4u);
                                            if (_e553 < 4u) {
                                            } else {
                                                phi_3287_ = true;
                                                break;
                                            }
                                            let _e558 = global_4.member[_e537.member_1][_e553];
                                            let _e560 = (_e558 >> bitcast<u32>(11u));
                                            let _e562 = ((1u + _e253) % 4u);
                                            if (_e562 < 4u) {
                                            } else {
                                                phi_3287_ = true;
                                                break;
                                            }
                                            let _e567 = global_4.member[_e537.member_1][_e562];
                                            let _e569 = (_e567 >> bitcast<u32>(11u));
                                            let _e571 = ((1u + _e255) % 4u);
                                            if (_e571 < 4u) {
                                            } else {
                                                phi_3287_ = true;
                                                break;
                                            }
                                            let _e576 = global_4.member[_e537.member_1][_e571];
                                            let _e578 = (_e576 >> bitcast<u32>(11u));
                                            let _e601 = (bitcast<f32>((bitcast<u32>((_e537.member.member_1.x - _e537.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e602 = (bitcast<f32>((bitcast<u32>((_e537.member.member_1.y - _e537.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e603 = (bitcast<f32>((bitcast<u32>((_e537.member.member_1.z - _e537.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e605 = select(_e134, _e601, (_e601 > _e134));
                                            let _e607 = select(_e134, _e602, (_e602 > _e134));
                                            let _e609 = select(_e134, _e603, (_e603 > _e134));
                                            let _e634 = bitcast<u32>((f32(bitcast<i32>((_e558 & 1023u))) * _e605));
                                            let _e639 = (bitcast<i32>((_e558 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e642 = bitcast<f32>((_e634 & bitcast<u32>(_e639)));
                                            let _e643 = bitcast<u32>((f32(bitcast<i32>((_e567 & 1023u))) * _e607));
                                            let _e648 = (bitcast<i32>((_e567 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e651 = bitcast<f32>((_e643 & bitcast<u32>(_e648)));
                                            let _e652 = bitcast<u32>((f32(bitcast<i32>((_e576 & 1023u))) * _e609));
                                            let _e657 = (bitcast<i32>((_e576 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e660 = bitcast<f32>((_e652 & bitcast<u32>(_e657)));
                                            let _e664 = bitcast<f32>((_e634 & bitcast<u32>(~(_e639))));
                                            let _e668 = bitcast<f32>((_e643 & bitcast<u32>(~(_e648))));
                                            let _e672 = bitcast<f32>((_e652 & bitcast<u32>(~(_e657))));
                                            let _e673 = bitcast<u32>((f32(bitcast<i32>((_e560 & 1023u))) * _e605));
                                            let _e678 = (bitcast<i32>((_e560 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e681 = bitcast<f32>((_e673 & bitcast<u32>(_e678)));
                                            let _e682 = bitcast<u32>((f32(bitcast<i32>((_e569 & 1023u))) * _e607));
                                            let _e687 = (bitcast<i32>((_e569 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e690 = bitcast<f32>((_e682 & bitcast<u32>(_e687)));
                                            let _e691 = bitcast<u32>((f32(bitcast<i32>((_e578 & 1023u))) * _e609));
                                            let _e696 = (bitcast<i32>((_e578 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e699 = bitcast<f32>((_e691 & bitcast<u32>(_e696)));
                                            let _e703 = bitcast<f32>((_e673 & bitcast<u32>(~(_e678))));
                                            let _e707 = bitcast<f32>((_e682 & bitcast<u32>(~(_e687))));
                                            let _e711 = bitcast<f32>((_e691 & bitcast<u32>(~(_e696))));
                                            let _e741 = global_4.member[_e537.member_1][0u];
                                            let _e745 = global_4.member[_e537.member_1][1u];
                                            let _e749 = global_4.member[_e537.member_1][2u];
                                            let _e753 = global_4.member[_e537.member_1][3u];
                                            let _e765 = (((_e745 >> bitcast<u32>(22i)) | ((_e749 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e753 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e766 = (_e741 & 268435455u);
                                            let _e767 = (_e765 & 268435455u);
                                            let _e770 = ((_e741 >> bitcast<u32>(28u)) & 7u);
                                            let _e778 = ((_e741 >> bitcast<u32>(31i)) | (((_e765 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e779 = (_e770 != 0u);
                                            if (_e770 == 0u) {
                                                phi_2427_ = _e766;
                                            } else {
                                                if (_e770 == 7u) {
                                                    phi_2426_ = 2147483648u;
                                                } else {
                                                    phi_2426_ = ((2147483648u | (_e770 << bitcast<u32>(28u))) | (_e767 & 268435455u));
                                                }
                                                let _e788 = phi_2426_;
                                                phi_2427_ = _e788;
                                            }
                                            let _e790 = phi_2427_;
                                            if _e779 {
                                                let _e791 = (_e770 != 7u);
                                                if _e791 {
                                                    phi_2437_ = (_e767 + _e770);
                                                } else {
                                                    phi_2437_ = u32();
                                                }
                                                let _e794 = phi_2437_;
                                                phi_2439_ = _e794;
                                                phi_2440_ = select(true, false, _e791);
                                            } else {
                                                phi_2439_ = u32();
                                                phi_2440_ = true;
                                            }
                                            let _e797 = phi_2439_;
                                            let _e799 = phi_2440_;
                                            if (_e778 == 0u) {
                                                phi_2461_ = (_e766 + select(0u, 1u, !(_e779)));
                                            } else {
                                                if (_e778 == 7u) {
                                                    phi_2460_ = 2147483648u;
                                                } else {
                                                    phi_2460_ = ((2147483648u | (_e778 << bitcast<u32>(28u))) | (select(_e797, _e767, _e799) & 268435455u));
                                                }
                                                let _e812 = phi_2460_;
                                                phi_2461_ = _e812;
                                            }
                                            let _e814 = phi_2461_;
                                            phi_2465_ = type_51(array<vec4<f32>, 3>(vec4<f32>((_e537.member.member.x + _e642), (_e537.member.member.x + _e664), (_e537.member.member_1.x - _e681), (_e537.member.member_1.x - _e703)), vec4<f32>((_e537.member.member.y + _e651), (_e537.member.member.y + _e668), (_e537.member.member_1.y - _e690), (_e537.member.member_1.y - _e707)), vec4<f32>((_e537.member.member.z + _e660), (_e537.member.member.z + _e672), (_e537.member.member_1.z - _e699), (_e537.member.member_1.z - _e711))), type_50(type_33((_e537.member.member + vec4<f32>(_e642, _e651, _e660, 0f)), (_e537.member.member_1 - vec4<f32>(_e681, _e690, _e699, 0f))), _e790), type_50(type_33((_e537.member.member + vec4<f32>(_e664, _e668, _e672, 0f)), (_e537.member.member_1 - vec4<f32>(_e703, _e707, _e711, 0f))), _e814));
                                        }
                                        let _e819 = phi_2465_;
                                        let _e831 = ((_e819.member[0].x - _e326) * _e331);
                                        let _e832 = ((_e819.member[0].y - _e326) * _e331);
                                        let _e833 = ((_e819.member[0].z - _e327) * _e331);
                                        let _e834 = ((_e819.member[0].w - _e327) * _e331);
                                        let _e844 = ((_e819.member[1].x - _e364) * _e369);
                                        let _e845 = ((_e819.member[1].y - _e364) * _e369);
                                        let _e846 = ((_e819.member[1].z - _e365) * _e369);
                                        let _e847 = ((_e819.member[1].w - _e365) * _e369);
                                        let _e857 = ((_e819.member[2].x - _e402) * _e407);
                                        let _e858 = ((_e819.member[2].y - _e402) * _e407);
                                        let _e859 = ((_e819.member[2].z - _e403) * _e407);
                                        let _e860 = ((_e819.member[2].w - _e403) * _e407);
                                        let _e862 = select(_e859, _e857, (_e857 < _e859));
                                        let _e864 = select(_e860, _e858, (_e858 < _e860));
                                        let _e866 = select(_e859, _e857, (_e857 > _e859));
                                        let _e868 = select(_e860, _e858, (_e858 > _e860));
                                        let _e870 = select(_e833, _e831, (_e831 < _e833));
                                        let _e872 = select(_e834, _e832, (_e832 < _e834));
                                        let _e874 = select(_e846, _e844, (_e844 < _e846));
                                        let _e876 = select(_e847, _e845, (_e845 < _e847));
                                        let _e878 = select(_e874, _e870, (_e870 > _e874));
                                        let _e880 = select(_e876, _e872, (_e872 > _e876));
                                        let _e882 = select(_e862, _e878, (_e878 > _e862));
                                        let _e884 = select(_e864, _e880, (_e880 > _e864));
                                        let _e886 = select(_e833, _e831, (_e831 > _e833));
                                        let _e888 = select(_e834, _e832, (_e832 > _e834));
                                        let _e890 = select(_e846, _e844, (_e844 > _e846));
                                        let _e892 = select(_e847, _e845, (_e845 > _e847));
                                        let _e894 = select(_e890, _e886, (_e886 < _e890));
                                        let _e896 = select(_e892, _e888, (_e888 < _e892));
                                        let _e901 = -(_e862);
                                        let _e902 = -(_e864);
                                        let _e909 = (select(_e866, _e894, (_e894 < _e866)) + (select(_e901, _e866, (_e866 > _e901)) * 0.0000019073523f));
                                        let _e910 = (select(_e868, _e896, (_e896 < _e868)) + (select(_e902, _e868, (_e868 > _e902)) * 0.0000019073523f));
                                        let _e912 = select(_e454, _e882, (_e882 > _e454));
                                        let _e914 = select(_e454, _e884, (_e884 > _e454));
                                        let _e919 = (_e912 <= select(_e498.member_1, _e909, (_e909 < _e498.member_1)));
                                        let _e920 = (_e914 <= select(_e498.member_1, _e910, (_e910 < _e498.member_1)));
                                        let _e921 = (_e912 <= _e914);
                                        if _e919 {
                                            if _e920 {
                                                if _e921 {
                                                    phi_2809_ = _e819.member_2;
                                                } else {
                                                    phi_2809_ = _e819.member_1;
                                                }
                                                let _e925 = phi_2809_;
                                                let _e947 = (_e541 % 128u);
                                                let _e948 = (_e947 < 128u);
                                                if _e948 {
                                                } else {
                                                    phi_3287_ = true;
                                                    break;
                                                }
                                                local_8[_e947] = _e925.member_1;
                                                if _e948 {
                                                } else {
                                                    phi_3287_ = true;
                                                    break;
                                                }
                                                local_7[_e947] = _e925.member.member.x;
                                                if _e948 {
                                                } else {
                                                    phi_3287_ = true;
                                                    break;
                                                }
                                                local_6[_e947] = _e925.member.member.y;
                                                if _e948 {
                                                } else {
                                                    phi_3287_ = true;
                                                    break;
                                                }
                                                local_5[_e947] = _e925.member.member.z;
                                                if _e948 {
                                                } else {
                                                    phi_3287_ = true;
                                                    break;
                                                }
                                                local_4[_e947] = _e925.member.member_1.x;
                                                if _e948 {
                                                } else {
                                                    phi_3287_ = true;
                                                    break;
                                                }
                                                local_3[_e947] = _e925.member.member_1.y;
                                                if _e948 {
                                                } else {
                                                    phi_3287_ = true;
                                                    break;
                                                }
                                                local_2[_e947] = _e925.member.member_1.z;
                                                if _e948 {
                                                } else {
                                                    phi_3287_ = true;
                                                    break;
                                                }
                                                local_9[_e947] = select(_e914, _e912, (_e912 > _e914));
                                                if _e921 {
                                                    phi_2886_ = _e819.member_1;
                                                } else {
                                                    phi_2886_ = _e819.member_2;
                                                }
                                                let _e961 = phi_2886_;
                                                phi_2887_ = _e961;
                                                phi_2888_ = (_e541 + 1u);
                                            } else {
                                                phi_2887_ = type_50();
                                                phi_2888_ = u32();
                                            }
                                            let _e963 = phi_2887_;
                                            let _e965 = phi_2888_;
                                            phi_2890_ = _e963;
                                            phi_2891_ = _e965;
                                            phi_2892_ = select(true, false, _e920);
                                        } else {
                                            phi_2890_ = type_50();
                                            phi_2891_ = u32();
                                            phi_2892_ = true;
                                        }
                                        let _e968 = phi_2890_;
                                        let _e970 = phi_2891_;
                                        let _e972 = phi_2892_;
                                        if _e972 {
                                            if _e919 {
                                                phi_2901_ = _e819.member_1;
                                            } else {
                                                phi_2901_ = _e819.member_2;
                                            }
                                            let _e976 = phi_2901_;
                                            phi_2906_ = _e976;
                                            phi_2907_ = select(_e920, true, _e919);
                                        } else {
                                            phi_2906_ = _e968;
                                            phi_2907_ = _e539;
                                        }
                                        let _e979 = phi_2906_;
                                        let _e981 = phi_2907_;
                                        phi_3291_ = _e496;
                                        phi_2909_ = _e498;
                                        phi_2910_ = _e979;
                                        phi_2911_ = _e981;
                                        phi_2912_ = select(_e970, _e541, _e972);
                                    }
                                    let _e1392 = phi_3291_;
                                    let _e1394 = phi_2909_;
                                    let _e1396 = phi_2910_;
                                    let _e1398 = phi_2911_;
                                    let _e1400 = phi_2912_;
                                    phi_3290_ = _e1392;
                                    phi_2913_ = _e1394;
                                    phi_2914_ = _e1396;
                                    phi_2915_ = (_e502 - 1u);
                                    phi_2916_ = _e1398;
                                    phi_2917_ = _e1400;
                                } else {
                                    phi_3290_ = _e496;
                                    phi_2913_ = _e498;
                                    phi_2914_ = _e537;
                                    phi_2915_ = _e502;
                                    phi_2916_ = _e539;
                                    phi_2917_ = _e541;
                                }
                                let _e1402 = phi_3290_;
                                let _e1404 = phi_2913_;
                                let _e1406 = phi_2914_;
                                let _e1408 = phi_2915_;
                                let _e1410 = phi_2916_;
                                let _e1412 = phi_2917_;
                                phi_3289_ = _e1402;
                                phi_2918_ = _e1404;
                                phi_2919_ = _e1406;
                                phi_2920_ = _e1408;
                                phi_2921_ = _e1410;
                                phi_2922_ = _e1412;
                            } else {
                                phi_3289_ = _e496;
                                phi_2918_ = type_37();
                                phi_2919_ = type_50();
                                phi_2920_ = u32();
                                phi_2921_ = bool();
                                phi_2922_ = u32();
                            }
                            let _e1414 = phi_3289_;
                            let _e1416 = phi_2918_;
                            let _e1418 = phi_2919_;
                            let _e1420 = phi_2920_;
                            let _e1422 = phi_2921_;
                            let _e1424 = phi_2922_;
                            phi_3288_ = _e1414;
                            phi_833_ = _e1416;
                            phi_836_ = _e1418;
                            phi_838_ = _e1420;
                            phi_840_ = _e1422;
                            phi_842_ = _e1424;
                            phi_2923_ = _e510;
                        } else {
                            phi_3288_ = _e496;
                            phi_833_ = type_37();
                            phi_836_ = type_50();
                            phi_838_ = u32();
                            phi_840_ = bool();
                            phi_842_ = u32();
                            phi_2923_ = false;
                        }
                        let _e1426 = phi_3288_;
                        let _e1428 = phi_833_;
                        let _e1430 = phi_836_;
                        let _e1432 = phi_838_;
                        let _e1434 = phi_840_;
                        let _e1436 = phi_842_;
                        let _e1438 = phi_2923_;
                        continue;
                        continuing {
                            phi_3179_ = _e1426;
                            phi_832_ = _e1428;
                            phi_835_ = _e1430;
                            phi_837_ = _e1432;
                            phi_839_ = _e1434;
                            phi_841_ = _e1436;
                            phi_3287_ = _e1426;
                            break if !(_e1438);
                        }
                    }
                    let _e1441 = phi_3287_;
                    if _e1441 {
                        break;
                    }
                    let _e1443 = local_10;
                    if (_e1443.member.member_3 != 4294967295u) {
                        let _e1448 = -(_e421);
                        let _e1449 = (_e1448 / 3i);
                        let _e1456 = bitcast<f32>((bitcast<u32>((_e1449 + 127i)) << bitcast<u32>(23i)));
                        let _e1464 = (((_e1443.member.member * _e1456) * _e1456) * bitcast<f32>((bitcast<u32>(((_e1448 - (2i * _e1449)) + 127i)) << bitcast<u32>(23i))));
                        let _e1466 = select(340282350000000000000000000000000000000f, _e1464, (_e1464 < 340282350000000000000000000000000000000f));
                        phi_2975_ = type_25(select(-340282350000000000000000000000000000000f, _e1466, (_e1466 > -340282350000000000000000000000000000000f)), _e1443.member.member_1, _e1443.member.member_2, _e1443.member.member_3);
                    } else {
                        phi_2975_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1473 = phi_2975_;
                    if _e142 {
                    } else {
                        break;
                    }
                    global_6.member[_e140] = _e1473;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_closest_q10_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
