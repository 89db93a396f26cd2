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
    var phi_378_: i32;
    var phi_379_: i32;
    var phi_389_: bool;
    var phi_399_: u32;
    var phi_400_: u32;
    var phi_402_: bool;
    var phi_407_: u32;
    var phi_420_: i32;
    var phi_440_: i32;
    var phi_458_: f32;
    var phi_464_: f32;
    var phi_475_: f32;
    var phi_481_: f32;
    var phi_504_: f32;
    var phi_515_: f32;
    var phi_524_: f32;
    var phi_530_: f32;
    var phi_541_: f32;
    var phi_547_: f32;
    var phi_570_: f32;
    var phi_581_: f32;
    var phi_590_: f32;
    var phi_596_: f32;
    var phi_607_: f32;
    var phi_613_: f32;
    var phi_636_: f32;
    var phi_647_: f32;
    var phi_747_: f32;
    var phi_748_: f32;
    var phi_3326_: bool;
    var phi_837_: type_37;
    var phi_840_: type_50;
    var phi_842_: u32;
    var phi_844_: bool;
    var phi_846_: u32;
    var phi_857_: bool;
    var phi_943_: type_50;
    var phi_944_: bool;
    var phi_945_: u32;
    var phi_2573_: u32;
    var phi_2574_: u32;
    var phi_2584_: u32;
    var phi_2586_: u32;
    var phi_2587_: bool;
    var phi_2607_: u32;
    var phi_2608_: u32;
    var phi_2612_: type_51;
    var phi_2956_: type_50;
    var phi_3033_: type_50;
    var phi_3034_: type_50;
    var phi_3035_: u32;
    var phi_3037_: type_50;
    var phi_3038_: u32;
    var phi_3039_: bool;
    var phi_3048_: type_50;
    var phi_3053_: type_50;
    var phi_3054_: bool;
    var phi_963_: type_37;
    var phi_966_: type_4;
    var phi_967_: type_4;
    var phi_989_: type_4;
    var phi_1010_: u32;
    var phi_1099_: array<array<f32, 3>, 3>;
    var phi_1570_: vec3<f32>;
    var phi_1571_: vec3<f32>;
    var phi_1602_: bool;
    var phi_1611_: vec3<f32>;
    var phi_1651_: type_25;
    var phi_1653_: type_25;
    var phi_1654_: bool;
    var phi_1658_: type_25;
    var phi_1659_: type_25;
    var phi_1660_: type_25;
    var phi_1661_: bool;
    var phi_1665_: type_25;
    var phi_1666_: bool;
    var phi_1670_: type_25;
    var phi_1671_: bool;
    var phi_1675_: type_25;
    var phi_1700_: bool;
    var phi_1701_: bool;
    var phi_1707_: type_37;
    var phi_1708_: type_37;
    var phi_1709_: type_37;
    var phi_964_: type_37;
    var phi_3320_: bool;
    var phi_3438_: bool;
    var phi_3056_: type_37;
    var phi_3057_: type_50;
    var phi_3058_: bool;
    var phi_3059_: u32;
    var phi_3437_: bool;
    var phi_3060_: type_37;
    var phi_3061_: type_50;
    var phi_3062_: u32;
    var phi_3063_: bool;
    var phi_3064_: u32;
    var phi_3436_: bool;
    var phi_3065_: type_37;
    var phi_3066_: type_50;
    var phi_3067_: u32;
    var phi_3068_: bool;
    var phi_3069_: u32;
    var phi_3435_: bool;
    var phi_838_: type_37;
    var phi_841_: type_50;
    var phi_843_: u32;
    var phi_845_: bool;
    var phi_847_: u32;
    var phi_3070_: bool;
    var phi_3434_: bool;
    var local_10: type_37;
    var phi_3122_: type_25;
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
                            phi_378_ = (bitcast<i32>((_e219 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_378_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e219)), 32u, (_e219 == 0u))));
                        }
                        let _e233 = phi_378_;
                        phi_379_ = _e233;
                    } else {
                        phi_379_ = 0i;
                    }
                    let _e235 = phi_379_;
                    let _e236 = (_e152 == _e191);
                    if _e236 {
                        phi_389_ = true;
                    } else {
                        phi_389_ = (_e159 == _e191);
                    }
                    let _e239 = phi_389_;
                    let _e240 = select(1u, 0u, _e236);
                    if _e239 {
                        let _e241 = (_e240 + 1u);
                        phi_399_ = _e241;
                        phi_400_ = _e241;
                        phi_402_ = select(true, false, (_e241 == 2u));
                    } else {
                        phi_399_ = u32();
                        phi_400_ = 0u;
                        phi_402_ = true;
                    }
                    let _e245 = phi_399_;
                    let _e247 = phi_400_;
                    let _e249 = phi_402_;
                    if _e249 {
                        phi_407_ = (_e247 + 1u);
                    } else {
                        phi_407_ = 0u;
                    }
                    let _e253 = phi_407_;
                    let _e254 = select(_e245, _e247, _e249);
                    let _e255 = select(_e240, select(2u, _e240, _e239), _e249);
                    if (_e122 < -126i) {
                        phi_420_ = -126i;
                    } else {
                        phi_420_ = select(_e122, 127i, (_e122 > 127i));
                    }
                    let _e260 = phi_420_;
                    let _e265 = bitcast<f32>((bitcast<u32>((_e260 + 127i)) << bitcast<u32>(23i)));
                    let _e271 = bitcast<f32>((bitcast<u32>(((_e122 - _e260) + 127i)) << bitcast<u32>(23i)));
                    let _e272 = -(_e235);
                    if (_e272 < -126i) {
                        phi_440_ = -126i;
                    } else {
                        phi_440_ = select(_e272, 127i, (_e272 > 127i));
                    }
                    let _e277 = phi_440_;
                    let _e282 = bitcast<f32>((bitcast<u32>((_e277 + 127i)) << bitcast<u32>(23i)));
                    let _e288 = bitcast<f32>((bitcast<u32>(((_e272 - _e277) + 127i)) << bitcast<u32>(23i)));
                    let _e292 = global_5.member[_e140].member;
                    let _e293 = (_e254 == 0u);
                    if _e293 {
                        phi_458_ = _e292[0];
                    } else {
                        phi_458_ = _e292[1];
                    }
                    let _e297 = phi_458_;
                    let _e298 = (_e254 == 2u);
                    if _e298 {
                        phi_464_ = _e292[2];
                    } else {
                        phi_464_ = _e297;
                    }
                    let _e301 = phi_464_;
                    let _e303 = ((_e301 * _e265) * _e271);
                    let _e304 = global_5.member[_e140].member_2;
                    if _e293 {
                        phi_475_ = _e304[0];
                    } else {
                        phi_475_ = _e304[1];
                    }
                    let _e308 = phi_475_;
                    if _e298 {
                        phi_481_ = _e304[2];
                    } else {
                        phi_481_ = _e308;
                    }
                    let _e311 = phi_481_;
                    let _e313 = ((_e311 * _e282) * _e288);
                    let _e317 = (bitcast<f32>((bitcast<u32>(_e313) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e317 {
                        let _e321 = (bitcast<f32>((bitcast<u32>(_e303) & 2147483647u)) * 0.00000011920929f);
                        phi_504_ = select(0.00000000000011368684f, _e321, (_e321 > 0.00000000000011368684f));
                    } else {
                        phi_504_ = 0f;
                    }
                    let _e325 = phi_504_;
                    let _e326 = (_e303 + _e325);
                    let _e327 = (_e303 - _e325);
                    let _e328 = select(_e313, 0f, _e317);
                    if _e317 {
                        phi_515_ = 38685626000000000000000000f;
                    } else {
                        phi_515_ = (1f / _e313);
                    }
                    let _e331 = phi_515_;
                    let _e332 = (_e253 == 0u);
                    if _e332 {
                        phi_524_ = _e292[0];
                    } else {
                        phi_524_ = _e292[1];
                    }
                    let _e336 = phi_524_;
                    let _e337 = (_e253 == 2u);
                    if _e337 {
                        phi_530_ = _e292[2];
                    } else {
                        phi_530_ = _e336;
                    }
                    let _e340 = phi_530_;
                    let _e342 = ((_e340 * _e265) * _e271);
                    if _e332 {
                        phi_541_ = _e304[0];
                    } else {
                        phi_541_ = _e304[1];
                    }
                    let _e346 = phi_541_;
                    if _e337 {
                        phi_547_ = _e304[2];
                    } else {
                        phi_547_ = _e346;
                    }
                    let _e349 = phi_547_;
                    let _e351 = ((_e349 * _e282) * _e288);
                    let _e355 = (bitcast<f32>((bitcast<u32>(_e351) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e355 {
                        let _e359 = (bitcast<f32>((bitcast<u32>(_e342) & 2147483647u)) * 0.00000011920929f);
                        phi_570_ = select(0.00000000000011368684f, _e359, (_e359 > 0.00000000000011368684f));
                    } else {
                        phi_570_ = 0f;
                    }
                    let _e363 = phi_570_;
                    let _e364 = (_e342 + _e363);
                    let _e365 = (_e342 - _e363);
                    let _e366 = select(_e351, 0f, _e355);
                    if _e355 {
                        phi_581_ = 38685626000000000000000000f;
                    } else {
                        phi_581_ = (1f / _e351);
                    }
                    let _e369 = phi_581_;
                    let _e370 = (_e255 == 0u);
                    if _e370 {
                        phi_590_ = _e292[0];
                    } else {
                        phi_590_ = _e292[1];
                    }
                    let _e374 = phi_590_;
                    let _e375 = (_e255 == 2u);
                    if _e375 {
                        phi_596_ = _e292[2];
                    } else {
                        phi_596_ = _e374;
                    }
                    let _e378 = phi_596_;
                    let _e380 = ((_e378 * _e265) * _e271);
                    if _e370 {
                        phi_607_ = _e304[0];
                    } else {
                        phi_607_ = _e304[1];
                    }
                    let _e384 = phi_607_;
                    if _e375 {
                        phi_613_ = _e304[2];
                    } else {
                        phi_613_ = _e384;
                    }
                    let _e387 = phi_613_;
                    let _e389 = ((_e387 * _e282) * _e288);
                    let _e393 = (bitcast<f32>((bitcast<u32>(_e389) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e393 {
                        let _e397 = (bitcast<f32>((bitcast<u32>(_e380) & 2147483647u)) * 0.00000011920929f);
                        phi_636_ = select(0.00000000000011368684f, _e397, (_e397 > 0.00000000000011368684f));
                    } else {
                        phi_636_ = 0f;
                    }
                    let _e401 = phi_636_;
                    let _e402 = (_e380 + _e401);
                    let _e403 = (_e380 - _e401);
                    let _e404 = select(_e389, 0f, _e393);
                    if _e393 {
                        phi_647_ = 38685626000000000000000000f;
                    } else {
                        phi_647_ = (1f / _e389);
                    }
                    let _e407 = phi_647_;
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
                        phi_747_ = select(-340282350000000000000000000000000000000f, _e448, (_e448 > -340282350000000000000000000000000000000f));
                        phi_748_ = select(-340282350000000000000000000000000000000f, _e441, (_e441 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_747_ = 0f;
                        phi_748_ = 1f;
                    }
                    let _e452 = phi_747_;
                    let _e454 = phi_748_;
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
                    phi_3326_ = false;
                    phi_837_ = type_37(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e452);
                    phi_840_ = type_50(type_33(vec4<f32>((f32(_e461) * _e134), (f32(_e467) * _e134), (f32(_e473) * _e134), 0f), vec4<f32>((f32(_e478) * _e134), (f32(_e482) * _e134), (f32(_e486) * _e134), 0f)), select(0u, 2147483648u, (_e84 == 0u)));
                    phi_842_ = ((3u * _e84) + 1u);
                    phi_844_ = (_e454 <= _e452);
                    phi_846_ = 0u;
                    loop {
                        let _e496 = phi_3326_;
                        let _e498 = phi_837_;
                        let _e500 = phi_840_;
                        let _e502 = phi_842_;
                        let _e504 = phi_844_;
                        let _e506 = phi_846_;
                        local_10 = _e498;
                        if _e504 {
                            phi_857_ = true;
                        } else {
                            phi_857_ = (_e506 > 0u);
                        }
                        let _e509 = phi_857_;
                        if _e509 {
                            let _e510 = (_e502 > 0u);
                            if _e510 {
                                if _e504 {
                                    phi_943_ = _e500;
                                    phi_944_ = _e504;
                                    phi_945_ = _e506;
                                } else {
                                    let _e511 = (_e506 - 1u);
                                    let _e512 = (_e511 % 128u);
                                    let _e513 = (_e512 < 128u);
                                    if _e513 {
                                    } else {
                                        phi_3434_ = true;
                                        break;
                                    }
                                    let _e515 = local_7[_e512];
                                    if _e513 {
                                    } else {
                                        phi_3434_ = true;
                                        break;
                                    }
                                    let _e517 = local_6[_e512];
                                    if _e513 {
                                    } else {
                                        phi_3434_ = true;
                                        break;
                                    }
                                    let _e519 = local_5[_e512];
                                    if _e513 {
                                    } else {
                                        phi_3434_ = true;
                                        break;
                                    }
                                    let _e521 = local_4[_e512];
                                    if _e513 {
                                    } else {
                                        phi_3434_ = true;
                                        break;
                                    }
                                    let _e523 = local_3[_e512];
                                    if _e513 {
                                    } else {
                                        phi_3434_ = true;
                                        break;
                                    }
                                    let _e525 = local_2[_e512];
                                    if _e513 {
                                    } else {
                                        phi_3434_ = true;
                                        break;
                                    }
                                    let _e530 = local_8[_e512];
                                    if _e513 {
                                    } else {
                                        phi_3434_ = true;
                                        break;
                                    }
                                    let _e533 = local_9[_e512];
                                    phi_943_ = type_50(type_33(vec4<f32>(_e515, _e517, _e519, 0f), vec4<f32>(_e521, _e523, _e525, 0f)), _e530);
                                    phi_944_ = (_e533 <= _e498.member_1);
                                    phi_945_ = _e511;
                                }
                                let _e537 = phi_943_;
                                let _e539 = phi_944_;
                                let _e541 = phi_945_;
                                if _e539 {
                                    if ((_e537.member_1 & 2147483648u) != 0u) {
                                        phi_963_ = _e498;
                                        phi_966_ = type_4(0u, ((_e537.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1006 = phi_963_;
                                            let _e1008 = phi_966_;
                                            local_11 = _e1006;
                                            if (_e1008.member < _e1008.member_1) {
                                                phi_967_ = type_4((_e1008.member + 1u), _e1008.member_1);
                                                phi_989_ = type_4(1u, _e1008.member);
                                            } else {
                                                phi_967_ = _e1008;
                                                phi_989_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1021 = phi_967_;
                                            let _e1023 = phi_989_;
                                            let _e1027 = (bitcast<i32>(_e1023.member) != 0i);
                                            if _e1027 {
                                                let _e1028 = ((_e537.member_1 & 268435455u) + _e1023.member_1);
                                                let _e1029 = (_e1028 < _e86);
                                                if _e1029 {
                                                    if _e1029 {
                                                    } else {
                                                        phi_3320_ = true;
                                                        break;
                                                    }
                                                    let _e1033 = global_2.member[_e1028].member_1;
                                                    phi_1010_ = _e1033;
                                                } else {
                                                    phi_1010_ = 4294967295u;
                                                }
                                                let _e1035 = phi_1010_;
                                                if (_e1028 >= _e86) {
                                                    phi_1099_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1029 {
                                                    } else {
                                                        phi_3320_ = true;
                                                        break;
                                                    }
                                                    if (_e458 < 9u) {
                                                    } else {
                                                        phi_3320_ = true;
                                                        break;
                                                    }
                                                    let _e1042 = global_2.member[_e1028].member[_e458];
                                                    if (_e464 < 9u) {
                                                    } else {
                                                        phi_3320_ = true;
                                                        break;
                                                    }
                                                    let _e1048 = global_2.member[_e1028].member[_e464];
                                                    if (_e470 < 9u) {
                                                    } else {
                                                        phi_3320_ = true;
                                                        break;
                                                    }
                                                    let _e1054 = global_2.member[_e1028].member[_e470];
                                                    let _e1056 = (3u + _e458);
                                                    if (_e1056 < 9u) {
                                                    } else {
                                                        phi_3320_ = true;
                                                        break;
                                                    }
                                                    let _e1062 = global_2.member[_e1028].member[_e1056];
                                                    let _e1063 = (3u + _e464);
                                                    if (_e1063 < 9u) {
                                                    } else {
                                                        phi_3320_ = true;
                                                        break;
                                                    }
                                                    let _e1069 = global_2.member[_e1028].member[_e1063];
                                                    let _e1070 = (3u + _e470);
                                                    if (_e1070 < 9u) {
                                                    } else {
                                                        phi_3320_ = true;
                                                        break;
                                                    }
                                                    let _e1076 = global_2.member[_e1028].member[_e1070];
                                                    let _e1078 = (6u + _e458);
                                                    if (_e1078 < 9u) {
                                                    } else {
                                                        phi_3320_ = true;
                                                        break;
                                                    }
                                                    let _e1084 = global_2.member[_e1028].member[_e1078];
                                                    let _e1085 = (6u + _e464);
                                                    if (_e1085 < 9u) {
                                                    } else {
                                                        phi_3320_ = true;
                                                        break;
                                                    }
                                                    let _e1091 = global_2.member[_e1028].member[_e1085];
                                                    let _e1092 = (6u + _e470);
                                                    if (_e1092 < 9u) {
                                                    } else {
                                                        phi_3320_ = true;
                                                        break;
                                                    }
                                                    let _e1098 = global_2.member[_e1028].member[_e1092];
                                                    phi_1099_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1042, _e1048, _e1054), array<f32, 3>(_e1062, _e1069, _e1076), array<f32, 3>(_e1084, _e1091, _e1098));
                                                }
                                                let _e1102 = phi_1099_;
                                                let _e1110 = (_e1102[0][2] - _e380);
                                                let _e1113 = (((_e1102[0][0] - _e303) * _e404) - (_e1110 * _e328));
                                                let _e1116 = (((_e1102[0][1] - _e342) * _e404) - (_e1110 * _e366));
                                                let _e1123 = (_e1102[1][2] - _e380);
                                                let _e1126 = (((_e1102[1][0] - _e303) * _e404) - (_e1123 * _e328));
                                                let _e1129 = (((_e1102[1][1] - _e342) * _e404) - (_e1123 * _e366));
                                                let _e1136 = (_e1102[2][2] - _e380);
                                                let _e1139 = (((_e1102[2][0] - _e303) * _e404) - (_e1136 * _e328));
                                                let _e1142 = (((_e1102[2][1] - _e342) * _e404) - (_e1136 * _e366));
                                                let _e1143 = (_e1139 * _e1129);
                                                let _e1144 = (_e1142 * _e1126);
                                                let _e1145 = (_e1113 * _e1142);
                                                let _e1146 = (_e1116 * _e1139);
                                                let _e1147 = (_e1126 * _e1116);
                                                let _e1148 = (_e1129 * _e1113);
                                                let _e1153 = (((_e1143 >= _e1144) && (_e1145 >= _e1146)) && (_e1147 >= _e1148));
                                                if (_e1153 || (((_e1143 <= _e1144) && (_e1145 <= _e1146)) && (_e1147 <= _e1148))) {
                                                    let _e1160 = select(-1f, 1f, _e1153);
                                                    let _e1162 = ((_e1143 - _e1144) * _e1160);
                                                    let _e1164 = select(0f, _e1162, (_e1162 > 0f));
                                                    let _e1166 = ((_e1145 - _e1146) * _e1160);
                                                    let _e1168 = select(0f, _e1166, (_e1166 > 0f));
                                                    let _e1170 = ((_e1147 - _e1148) * _e1160);
                                                    let _e1172 = select(0f, _e1170, (_e1170 > 0f));
                                                    let _e1174 = ((_e1164 + _e1168) + _e1172);
                                                    if (_e1174 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1665_ = type_25();
                                                        phi_1666_ = true;
                                                    } else {
                                                        let _e1177 = select(_e1102[1][0], _e1102[0][0], (_e1102[0][0] < _e1102[1][0]));
                                                        let _e1181 = select(_e1102[1][0], _e1102[0][0], (_e1102[0][0] > _e1102[1][0]));
                                                        let _e1185 = select(_e1102[1][1], _e1102[0][1], (_e1102[0][1] < _e1102[1][1]));
                                                        let _e1189 = select(_e1102[1][1], _e1102[0][1], (_e1102[0][1] > _e1102[1][1]));
                                                        let _e1193 = select(_e1102[1][2], _e1102[0][2], (_e1102[0][2] < _e1102[1][2]));
                                                        let _e1197 = select(_e1102[1][2], _e1102[0][2], (_e1102[0][2] > _e1102[1][2]));
                                                        let _e1202 = ((select(_e1102[2][0], _e1177, (_e1177 < _e1102[2][0])) - _e326) * _e331);
                                                        let _e1203 = ((select(_e1102[2][0], _e1181, (_e1181 > _e1102[2][0])) - _e327) * _e331);
                                                        let _e1206 = ((select(_e1102[2][1], _e1185, (_e1185 < _e1102[2][1])) - _e364) * _e369);
                                                        let _e1207 = ((select(_e1102[2][1], _e1189, (_e1189 > _e1102[2][1])) - _e365) * _e369);
                                                        let _e1210 = ((select(_e1102[2][2], _e1193, (_e1193 < _e1102[2][2])) - _e402) * _e407);
                                                        let _e1211 = ((select(_e1102[2][2], _e1197, (_e1197 > _e1102[2][2])) - _e403) * _e407);
                                                        let _e1213 = select(_e1211, _e1210, (_e1210 < _e1211));
                                                        let _e1215 = select(_e1211, _e1210, (_e1210 > _e1211));
                                                        let _e1217 = select(_e1203, _e1202, (_e1202 < _e1203));
                                                        let _e1219 = select(_e1207, _e1206, (_e1206 < _e1207));
                                                        let _e1221 = select(_e1219, _e1217, (_e1217 > _e1219));
                                                        let _e1223 = select(_e1213, _e1221, (_e1221 > _e1213));
                                                        let _e1225 = select(_e1203, _e1202, (_e1202 > _e1203));
                                                        let _e1227 = select(_e1207, _e1206, (_e1206 > _e1207));
                                                        let _e1229 = select(_e1227, _e1225, (_e1225 < _e1227));
                                                        let _e1231 = select(_e1215, _e1229, (_e1229 < _e1215));
                                                        let _e1232 = -(_e1213);
                                                        let _e1238 = select(_e454, _e1223, (_e1223 > _e454));
                                                        if (_e1238 > (_e1231 + (select(_e1232, _e1215, (_e1215 > _e1232)) * 0.0000019073523f))) {
                                                            phi_1660_ = type_25();
                                                            phi_1661_ = true;
                                                        } else {
                                                            let _e1240 = (_e1238 > _e1006.member_1);
                                                            if _e1240 {
                                                                phi_1659_ = type_25();
                                                            } else {
                                                                let _e1244 = (_e1102[1][0] - _e1102[0][0]);
                                                                let _e1245 = (_e1102[1][1] - _e1102[0][1]);
                                                                let _e1246 = (_e1102[1][2] - _e1102[0][2]);
                                                                let _e1247 = vec3<f32>(_e1244, _e1245, _e1246);
                                                                let _e1248 = (_e1102[2][0] - _e1102[1][0]);
                                                                let _e1249 = (_e1102[2][1] - _e1102[1][1]);
                                                                let _e1250 = (_e1102[2][2] - _e1102[1][2]);
                                                                let _e1251 = vec3<f32>(_e1248, _e1249, _e1250);
                                                                let _e1252 = (_e1102[0][0] - _e1102[2][0]);
                                                                let _e1253 = (_e1102[0][1] - _e1102[2][1]);
                                                                let _e1254 = (_e1102[0][2] - _e1102[2][2]);
                                                                let _e1255 = vec3<f32>(_e1252, _e1253, _e1254);
                                                                let _e1258 = bitcast<f32>((bitcast<u32>(_e1244) & 2147483647u));
                                                                let _e1261 = bitcast<f32>((bitcast<u32>(_e1245) & 2147483647u));
                                                                let _e1263 = select(_e1261, _e1258, (_e1258 > _e1261));
                                                                let _e1266 = bitcast<f32>((bitcast<u32>(_e1246) & 2147483647u));
                                                                let _e1268 = select(_e1266, _e1263, (_e1263 > _e1266));
                                                                let _e1271 = bitcast<f32>((bitcast<u32>(_e1248) & 2147483647u));
                                                                let _e1274 = bitcast<f32>((bitcast<u32>(_e1249) & 2147483647u));
                                                                let _e1276 = select(_e1274, _e1271, (_e1271 > _e1274));
                                                                let _e1279 = bitcast<f32>((bitcast<u32>(_e1250) & 2147483647u));
                                                                let _e1281 = select(_e1279, _e1276, (_e1276 > _e1279));
                                                                let _e1284 = bitcast<f32>((bitcast<u32>(_e1252) & 2147483647u));
                                                                let _e1287 = bitcast<f32>((bitcast<u32>(_e1253) & 2147483647u));
                                                                let _e1289 = select(_e1287, _e1284, (_e1284 > _e1287));
                                                                let _e1292 = bitcast<f32>((bitcast<u32>(_e1254) & 2147483647u));
                                                                let _e1294 = select(_e1292, _e1289, (_e1289 > _e1292));
                                                                let _e1296 = select(_e1281, _e1268, (_e1268 > _e1281));
                                                                let _e1298 = select(_e1294, _e1296, (_e1296 > _e1294));
                                                                if (_e1268 == _e1298) {
                                                                    phi_1570_ = _e1251;
                                                                    phi_1571_ = _e1255;
                                                                } else {
                                                                    let _e1301 = vec3((_e1281 == _e1298));
                                                                    phi_1570_ = select(_e1247, _e1255, _e1301);
                                                                    phi_1571_ = select(_e1251, _e1247, _e1301);
                                                                }
                                                                let _e1305 = phi_1570_;
                                                                let _e1307 = phi_1571_;
                                                                let _e1314 = ((_e1305.y * _e1307.z) - (_e1307.y * _e1305.z));
                                                                let _e1319 = ((_e1305.z * _e1307.x) - (_e1307.z * _e1305.x));
                                                                let _e1322 = ((_e1305.x * _e1307.y) - (_e1307.x * _e1305.y));
                                                                if (_e1164 >= _e1168) {
                                                                    phi_1602_ = select(true, false, (_e1164 >= _e1172));
                                                                } else {
                                                                    phi_1602_ = true;
                                                                }
                                                                let _e1327 = phi_1602_;
                                                                if _e1327 {
                                                                    phi_1611_ = select(vec3<f32>(_e1102[2][0], _e1102[2][1], _e1102[2][2]), vec3<f32>(_e1102[1][0], _e1102[1][1], _e1102[1][2]), vec3((_e1168 >= _e1172)));
                                                                } else {
                                                                    phi_1611_ = vec3<f32>(_e1102[0][0], _e1102[0][1], _e1102[0][2]);
                                                                }
                                                                let _e1332 = phi_1611_;
                                                                let _e1349 = ((((_e1314 * (_e1332.x - _e303)) + (_e1319 * (_e1332.y - _e342))) + (_e1322 * (_e1332.z - _e380))) / (((_e1314 * _e328) + (_e1319 * _e366)) + (_e1322 * _e404)));
                                                                let _e1351 = select(_e1231, _e1349, (_e1349 < _e1231));
                                                                let _e1353 = select(_e1223, _e1351, (_e1351 > _e1223));
                                                                if (_e1353 >= _e454) {
                                                                    let _e1355 = (_e1353 <= _e1006.member_1);
                                                                    if _e1355 {
                                                                        let _e1356 = (1f / _e1174);
                                                                        phi_1651_ = type_25(_e1353, (_e1168 * _e1356), (_e1172 * _e1356), _e1035);
                                                                    } else {
                                                                        phi_1651_ = type_25();
                                                                    }
                                                                    let _e1361 = phi_1651_;
                                                                    phi_1653_ = _e1361;
                                                                    phi_1654_ = select(true, false, _e1355);
                                                                } else {
                                                                    phi_1653_ = type_25();
                                                                    phi_1654_ = true;
                                                                }
                                                                let _e1364 = phi_1653_;
                                                                let _e1366 = phi_1654_;
                                                                if _e1366 {
                                                                    phi_1658_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1658_ = _e1364;
                                                                }
                                                                let _e1368 = phi_1658_;
                                                                phi_1659_ = _e1368;
                                                            }
                                                            let _e1370 = phi_1659_;
                                                            phi_1660_ = _e1370;
                                                            phi_1661_ = _e1240;
                                                        }
                                                        let _e1372 = phi_1660_;
                                                        let _e1374 = phi_1661_;
                                                        phi_1665_ = _e1372;
                                                        phi_1666_ = _e1374;
                                                    }
                                                    let _e1376 = phi_1665_;
                                                    let _e1378 = phi_1666_;
                                                    phi_1670_ = _e1376;
                                                    phi_1671_ = _e1378;
                                                } else {
                                                    phi_1670_ = type_25();
                                                    phi_1671_ = true;
                                                }
                                                let _e1380 = phi_1670_;
                                                let _e1382 = phi_1671_;
                                                if _e1382 {
                                                    phi_1675_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1675_ = _e1380;
                                                }
                                                let _e1384 = phi_1675_;
                                                if (_e1384.member_3 != 4294967295u) {
                                                    if (_e1035 != 4294967295u) {
                                                        if (_e1384.member < _e1006.member.member) {
                                                            phi_1701_ = true;
                                                        } else {
                                                            if (_e1384.member == _e1006.member.member) {
                                                                phi_1700_ = (_e1384.member_3 < _e1006.member.member_3);
                                                            } else {
                                                                phi_1700_ = false;
                                                            }
                                                            let _e1397 = phi_1700_;
                                                            phi_1701_ = _e1397;
                                                        }
                                                        let _e1399 = phi_1701_;
                                                        if _e1399 {
                                                            phi_1707_ = type_37(_e1384, _e1384.member);
                                                        } else {
                                                            phi_1707_ = _e1006;
                                                        }
                                                        let _e1402 = phi_1707_;
                                                        phi_1708_ = _e1402;
                                                    } else {
                                                        phi_1708_ = _e1006;
                                                    }
                                                    let _e1404 = phi_1708_;
                                                    phi_1709_ = _e1404;
                                                } else {
                                                    phi_1709_ = _e1006;
                                                }
                                                let _e1406 = phi_1709_;
                                                phi_964_ = _e1406;
                                            } else {
                                                phi_964_ = type_37();
                                            }
                                            let _e1408 = phi_964_;
                                            continue;
                                            continuing {
                                                phi_963_ = _e1408;
                                                phi_966_ = _e1021;
                                                phi_3320_ = _e496;
                                                break if !(_e1027);
                                            }
                                        }
                                        let _e1411 = phi_3320_;
                                        phi_3434_ = _e1411;
                                        if _e1411 {
                                            break;
                                        }
                                        phi_3438_ = _e1411;
                                        let _e1586 = local_11;
                                        phi_3056_ = _e1586;
                                        phi_3057_ = _e537;
                                        phi_3058_ = false;
                                        phi_3059_ = _e541;
                                    } else {
                                        if (_e537.member_1 >= _e84) {
                                            phi_2612_ = type_51(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_50(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_50(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e537.member_1 < _e84) {
                                            } else {
                                                phi_3434_ = true;
                                                break;
                                            }
                                            let _e553 = ((1u + _e254) % 4u);
                                            if (_e553 < 4u) {
                                            } else {
                                                phi_3434_ = true;
                                                break;
                                            }
                                            let _e558 = global_4.member[_e537.member_1][_e553];
                                            let _e560 = ((1u + _e253) % 4u);
                                            if (_e560 < 4u) {
                                            } else {
                                                phi_3434_ = true;
                                                break;
                                            }
                                            let _e565 = global_4.member[_e537.member_1][_e560];
                                            let _e567 = ((1u + _e255) % 4u);
                                            if (_e567 < 4u) {
                                            } else {
                                                phi_3434_ = true;
                                                break;
                                            }
                                            let _e572 = global_4.member[_e537.member_1][_e567];
                                            let _e574 = ((_e254 + 1u) % 4u);
                                            if (_e574 < 4u) {
                                            } else {
                                                phi_3434_ = true;
                                                break;
                                            }
                                            let _e579 = global_4.member[_e537.member_1][_e574];
                                            let _e581 = (_e579 >> bitcast<u32>(11u));
                                            let _e583 = ((_e253 + 1u) % 4u);
                                            if (_e583 < 4u) {
                                            } else {
                                                phi_3434_ = true;
                                                break;
                                            }
                                            let _e588 = global_4.member[_e537.member_1][_e583];
                                            let _e590 = (_e588 >> bitcast<u32>(11u));
                                            let _e592 = ((_e255 + 1u) % 4u);
                                            if (_e592 < 4u) {
                                            } else {
                                                phi_3434_ = true;
                                                break;
                                            }
                                            let _e597 = global_4.member[_e537.member_1][_e592];
                                            let _e599 = (_e597 >> bitcast<u32>(11u));
                                            let _e622 = (bitcast<f32>((bitcast<u32>((_e537.member.member_1.x - _e537.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e623 = (bitcast<f32>((bitcast<u32>((_e537.member.member_1.y - _e537.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e624 = (bitcast<f32>((bitcast<u32>((_e537.member.member_1.z - _e537.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e626 = select(_e134, _e622, (_e622 > _e134));
                                            let _e628 = select(_e134, _e623, (_e623 > _e134));
                                            let _e630 = select(_e134, _e624, (_e624 > _e134));
                                            let _e655 = bitcast<u32>((f32(bitcast<i32>((_e558 & 1023u))) * _e626));
                                            let _e660 = (bitcast<i32>((_e558 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e663 = bitcast<f32>((_e655 & bitcast<u32>(_e660)));
                                            let _e664 = bitcast<u32>((f32(bitcast<i32>((_e565 & 1023u))) * _e628));
                                            let _e669 = (bitcast<i32>((_e565 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e672 = bitcast<f32>((_e664 & bitcast<u32>(_e669)));
                                            let _e673 = bitcast<u32>((f32(bitcast<i32>((_e572 & 1023u))) * _e630));
                                            let _e678 = (bitcast<i32>((_e572 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e681 = bitcast<f32>((_e673 & bitcast<u32>(_e678)));
                                            let _e685 = bitcast<f32>((_e655 & bitcast<u32>(~(_e660))));
                                            let _e689 = bitcast<f32>((_e664 & bitcast<u32>(~(_e669))));
                                            let _e693 = bitcast<f32>((_e673 & bitcast<u32>(~(_e678))));
                                            let _e694 = bitcast<u32>((f32(bitcast<i32>((_e581 & 1023u))) * _e626));
                                            let _e699 = (bitcast<i32>((_e581 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e702 = bitcast<f32>((_e694 & bitcast<u32>(_e699)));
                                            let _e703 = bitcast<u32>((f32(bitcast<i32>((_e590 & 1023u))) * _e628));
                                            let _e708 = (bitcast<i32>((_e590 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e711 = bitcast<f32>((_e703 & bitcast<u32>(_e708)));
                                            let _e712 = bitcast<u32>((f32(bitcast<i32>((_e599 & 1023u))) * _e630));
                                            let _e717 = (bitcast<i32>((_e599 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e720 = bitcast<f32>((_e712 & bitcast<u32>(_e717)));
                                            let _e724 = bitcast<f32>((_e694 & bitcast<u32>(~(_e699))));
                                            let _e728 = bitcast<f32>((_e703 & bitcast<u32>(~(_e708))));
                                            let _e732 = bitcast<f32>((_e712 & bitcast<u32>(~(_e717))));
                                            let _e762 = global_4.member[_e537.member_1][0u];
                                            let _e766 = global_4.member[_e537.member_1][1u];
                                            let _e770 = global_4.member[_e537.member_1][2u];
                                            let _e774 = global_4.member[_e537.member_1][3u];
                                            let _e786 = (((_e766 >> bitcast<u32>(22i)) | ((_e770 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e774 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e787 = (_e762 & 268435455u);
                                            let _e788 = (_e786 & 268435455u);
                                            let _e791 = ((_e762 >> bitcast<u32>(28u)) & 7u);
                                            let _e799 = ((_e762 >> bitcast<u32>(31i)) | (((_e786 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e800 = (_e791 != 0u);
                                            if (_e791 == 0u) {
                                                phi_2574_ = _e787;
                                            } else {
                                                if (_e791 == 7u) {
                                                    phi_2573_ = 2147483648u;
                                                } else {
                                                    phi_2573_ = ((2147483648u | (_e791 << bitcast<u32>(28u))) | (_e788 & 268435455u));
                                                }
                                                let _e809 = phi_2573_;
                                                phi_2574_ = _e809;
                                            }
                                            let _e811 = phi_2574_;
                                            if _e800 {
                                                let _e812 = (_e791 != 7u);
                                                if _e812 {
                                                    phi_2584_ = (_e788 + _e791);
                                                } else {
                                                    phi_2584_ = u32();
                                                }
                                                let _e815 = phi_2584_;
                                                phi_2586_ = _e815;
                                                phi_2587_ = select(true, false, _e812);
                                            } else {
                                                phi_2586_ = u32();
                                                phi_2587_ = true;
                                            }
                                            let _e818 = phi_2586_;
                                            let _e820 = phi_2587_;
                                            if (_e799 == 0u) {
                                                phi_2608_ = (_e787 + select(0u, 1u, !(_e800)));
                                            } else {
                                                if (_e799 == 7u) {
                                                    phi_2607_ = 2147483648u;
                                                } else {
                                                    phi_2607_ = ((2147483648u | (_e799 << bitcast<u32>(28u))) | (select(_e818, _e788, _e820) & 268435455u));
                                                }
                                                let _e833 = phi_2607_;
                                                phi_2608_ = _e833;
                                            }
                                            let _e835 = phi_2608_;
                                            phi_2612_ = type_51(array<vec4<f32>, 3>(vec4<f32>((_e537.member.member.x + _e663), (_e537.member.member.x + _e685), (_e537.member.member_1.x - _e702), (_e537.member.member_1.x - _e724)), vec4<f32>((_e537.member.member.y + _e672), (_e537.member.member.y + _e689), (_e537.member.member_1.y - _e711), (_e537.member.member_1.y - _e728)), vec4<f32>((_e537.member.member.z + _e681), (_e537.member.member.z + _e693), (_e537.member.member_1.z - _e720), (_e537.member.member_1.z - _e732))), type_50(type_33((_e537.member.member + vec4<f32>(_e663, _e672, _e681, 0f)), (_e537.member.member_1 - vec4<f32>(_e702, _e711, _e720, 0f))), _e811), type_50(type_33((_e537.member.member + vec4<f32>(_e685, _e689, _e693, 0f)), (_e537.member.member_1 - vec4<f32>(_e724, _e728, _e732, 0f))), _e835));
                                        }
                                        let _e840 = phi_2612_;
                                        let _e852 = ((_e840.member[0].x - _e326) * _e331);
                                        let _e853 = ((_e840.member[0].y - _e326) * _e331);
                                        let _e854 = ((_e840.member[0].z - _e327) * _e331);
                                        let _e855 = ((_e840.member[0].w - _e327) * _e331);
                                        let _e865 = ((_e840.member[1].x - _e364) * _e369);
                                        let _e866 = ((_e840.member[1].y - _e364) * _e369);
                                        let _e867 = ((_e840.member[1].z - _e365) * _e369);
                                        let _e868 = ((_e840.member[1].w - _e365) * _e369);
                                        let _e878 = ((_e840.member[2].x - _e402) * _e407);
                                        let _e879 = ((_e840.member[2].y - _e402) * _e407);
                                        let _e880 = ((_e840.member[2].z - _e403) * _e407);
                                        let _e881 = ((_e840.member[2].w - _e403) * _e407);
                                        let _e883 = select(_e880, _e878, (_e878 < _e880));
                                        let _e885 = select(_e881, _e879, (_e879 < _e881));
                                        let _e887 = select(_e880, _e878, (_e878 > _e880));
                                        let _e889 = select(_e881, _e879, (_e879 > _e881));
                                        let _e891 = select(_e854, _e852, (_e852 < _e854));
                                        let _e893 = select(_e855, _e853, (_e853 < _e855));
                                        let _e895 = select(_e867, _e865, (_e865 < _e867));
                                        let _e897 = select(_e868, _e866, (_e866 < _e868));
                                        let _e899 = select(_e895, _e891, (_e891 > _e895));
                                        let _e901 = select(_e897, _e893, (_e893 > _e897));
                                        let _e903 = select(_e883, _e899, (_e899 > _e883));
                                        let _e905 = select(_e885, _e901, (_e901 > _e885));
                                        let _e907 = select(_e854, _e852, (_e852 > _e854));
                                        let _e909 = select(_e855, _e853, (_e853 > _e855));
                                        let _e911 = select(_e867, _e865, (_e865 > _e867));
                                        let _e913 = select(_e868, _e866, (_e866 > _e868));
                                        let _e915 = select(_e911, _e907, (_e907 < _e911));
                                        let _e917 = select(_e913, _e909, (_e909 < _e913));
                                        let _e922 = -(_e883);
                                        let _e923 = -(_e885);
                                        let _e930 = (select(_e887, _e915, (_e915 < _e887)) + (select(_e922, _e887, (_e887 > _e922)) * 0.0000019073523f));
                                        let _e931 = (select(_e889, _e917, (_e917 < _e889)) + (select(_e923, _e889, (_e889 > _e923)) * 0.0000019073523f));
                                        let _e933 = select(_e454, _e903, (_e903 > _e454));
                                        let _e935 = select(_e454, _e905, (_e905 > _e454));
                                        let _e940 = (_e933 <= select(_e498.member_1, _e930, (_e930 < _e498.member_1)));
                                        let _e941 = (_e935 <= select(_e498.member_1, _e931, (_e931 < _e498.member_1)));
                                        let _e942 = (_e933 <= _e935);
                                        if _e940 {
                                            if _e941 {
                                                if _e942 {
                                                    phi_2956_ = _e840.member_2;
                                                } else {
                                                    phi_2956_ = _e840.member_1;
                                                }
                                                let _e946 = phi_2956_;
                                                let _e968 = (_e541 % 128u);
                                                let _e969 = (_e968 < 128u);
                                                if _e969 {
                                                } else {
                                                    phi_3434_ = true;
                                                    break;
                                                }
                                                local_8[_e968] = _e946.member_1;
                                                if _e969 {
                                                } else {
                                                    phi_3434_ = true;
                                                    break;
                                                }
                                                local_7[_e968] = _e946.member.member.x;
                                                if _e969 {
                                                } else {
                                                    phi_3434_ = true;
                                                    break;
                                                }
                                                local_6[_e968] = _e946.member.member.y;
                                                if _e969 {
                                                } else {
                                                    phi_3434_ = true;
                                                    break;
                                                }
                                                local_5[_e968] = _e946.member.member.z;
                                                if _e969 {
                                                } else {
                                                    phi_3434_ = true;
                                                    break;
                                                }
                                                local_4[_e968] = _e946.member.member_1.x;
                                                if _e969 {
                                                } else {
                                                    phi_3434_ = true;
                                                    break;
                                                }
                                                local_3[_e968] = _e946.member.member_1.y;
                                                if _e969 {
                                                } else {
                                                    phi_3434_ = true;
                                                    break;
                                                }
                                                local_2[_e968] = _e946.member.member_1.z;
                                                if _e969 {
                                                } else {
                                                    phi_3434_ = true;
                                                    break;
                                                }
                                                local_9[_e968] = select(_e935, _e933, (_e933 > _e935));
                                                if _e942 {
                                                    phi_3033_ = _e840.member_1;
                                                } else {
                                                    phi_3033_ = _e840.member_2;
                                                }
                                                let _e982 = phi_3033_;
                                                phi_3034_ = _e982;
                                                phi_3035_ = (_e541 + 1u);
                                            } else {
                                                phi_3034_ = type_50();
                                                phi_3035_ = u32();
                                            }
                                            let _e984 = phi_3034_;
                                            let _e986 = phi_3035_;
                                            phi_3037_ = _e984;
                                            phi_3038_ = _e986;
                                            phi_3039_ = select(true, false, _e941);
                                        } else {
                                            phi_3037_ = type_50();
                                            phi_3038_ = u32();
                                            phi_3039_ = true;
                                        }
                                        let _e989 = phi_3037_;
                                        let _e991 = phi_3038_;
                                        let _e993 = phi_3039_;
                                        if _e993 {
                                            if _e940 {
                                                phi_3048_ = _e840.member_1;
                                            } else {
                                                phi_3048_ = _e840.member_2;
                                            }
                                            let _e997 = phi_3048_;
                                            phi_3053_ = _e997;
                                            phi_3054_ = select(_e941, true, _e940);
                                        } else {
                                            phi_3053_ = _e989;
                                            phi_3054_ = _e539;
                                        }
                                        let _e1000 = phi_3053_;
                                        let _e1002 = phi_3054_;
                                        phi_3438_ = _e496;
                                        phi_3056_ = _e498;
                                        phi_3057_ = _e1000;
                                        phi_3058_ = _e1002;
                                        phi_3059_ = select(_e991, _e541, _e993);
                                    }
                                    let _e1413 = phi_3438_;
                                    let _e1415 = phi_3056_;
                                    let _e1417 = phi_3057_;
                                    let _e1419 = phi_3058_;
                                    let _e1421 = phi_3059_;
                                    phi_3437_ = _e1413;
                                    phi_3060_ = _e1415;
                                    phi_3061_ = _e1417;
                                    phi_3062_ = (_e502 - 1u);
                                    phi_3063_ = _e1419;
                                    phi_3064_ = _e1421;
                                } else {
                                    phi_3437_ = _e496;
                                    phi_3060_ = _e498;
                                    phi_3061_ = _e537;
                                    phi_3062_ = _e502;
                                    phi_3063_ = _e539;
                                    phi_3064_ = _e541;
                                }
                                let _e1423 = phi_3437_;
                                let _e1425 = phi_3060_;
                                let _e1427 = phi_3061_;
                                let _e1429 = phi_3062_;
                                let _e1431 = phi_3063_;
                                let _e1433 = phi_3064_;
                                phi_3436_ = _e1423;
                                phi_3065_ = _e1425;
                                phi_3066_ = _e1427;
                                phi_3067_ = _e1429;
                                phi_3068_ = _e1431;
                                phi_3069_ = _e1433;
                            } else {
                                phi_3436_ = _e496;
                                phi_3065_ = type_37();
                                phi_3066_ = type_50();
                                phi_3067_ = u32();
                                phi_3068_ = bool();
                                phi_3069_ = u32();
                            }
                            let _e1435 = phi_3436_;
                            let _e1437 = phi_3065_;
                            let _e1439 = phi_3066_;
                            let _e1441 = phi_3067_;
                            let _e1443 = phi_3068_;
                            let _e1445 = phi_3069_;
                            phi_3435_ = _e1435;
                            phi_838_ = _e1437;
                            phi_841_ = _e1439;
                            phi_843_ = _e1441;
                            phi_845_ = _e1443;
                            phi_847_ = _e1445;
                            phi_3070_ = _e510;
                        } else {
                            phi_3435_ = _e496;
                            phi_838_ = type_37();
                            phi_841_ = type_50();
                            phi_843_ = u32();
                            phi_845_ = bool();
                            phi_847_ = u32();
                            phi_3070_ = false;
                        }
                        let _e1447 = phi_3435_;
                        let _e1449 = phi_838_;
                        let _e1451 = phi_841_;
                        let _e1453 = phi_843_;
                        let _e1455 = phi_845_;
                        let _e1457 = phi_847_;
                        let _e1459 = phi_3070_;
                        continue;
                        continuing {
                            phi_3326_ = _e1447;
                            phi_837_ = _e1449;
                            phi_840_ = _e1451;
                            phi_842_ = _e1453;
                            phi_844_ = _e1455;
                            phi_846_ = _e1457;
                            phi_3434_ = _e1447;
                            break if !(_e1459);
                        }
                    }
                    let _e1462 = phi_3434_;
                    if _e1462 {
                        break;
                    }
                    let _e1464 = local_10;
                    if (_e1464.member.member_3 != 4294967295u) {
                        let _e1469 = -(_e421);
                        let _e1470 = (_e1469 / 3i);
                        let _e1477 = bitcast<f32>((bitcast<u32>((_e1470 + 127i)) << bitcast<u32>(23i)));
                        let _e1485 = (((_e1464.member.member * _e1477) * _e1477) * bitcast<f32>((bitcast<u32>(((_e1469 - (2i * _e1470)) + 127i)) << bitcast<u32>(23i))));
                        let _e1487 = select(340282350000000000000000000000000000000f, _e1485, (_e1485 < 340282350000000000000000000000000000000f));
                        phi_3122_ = type_25(select(-340282350000000000000000000000000000000f, _e1487, (_e1487 > -340282350000000000000000000000000000000f)), _e1464.member.member_1, _e1464.member.member_2, _e1464.member.member_3);
                    } else {
                        phi_3122_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1494 = phi_3122_;
                    if _e142 {
                    } else {
                        break;
                    }
                    global_6.member[_e140] = _e1494;
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
