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

struct type_26 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_29 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_36 {
    member: array<type_26>,
}

struct type_40 {
    member: array<array<type_25, 8>>,
}

struct type_46 {
    member: array<vec4<u32>, 2>,
}

struct type_51 {
    member: type_29,
    member_1: u32,
}

struct type_54 {
    member: array<vec4<f32>, 3>,
    member_1: type_51,
    member_2: type_51,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(3) 
var<storage> global_2: type_19;
@group(0) @binding(1) 
var<uniform> global_3: type_46;
@group(0) @binding(2) 
var<storage> global_4: type_9;
@group(0) @binding(4) 
var<storage> global_5: type_36;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_40;

fn function_() {
    var local: array<i32, 3>;
    var local_1: array<i32, 3>;
    var local_2: array<type_25, 8>;
    var local_3: array<f32, 128>;
    var local_4: array<type_51, 128>;
    var phi_387_: i32;
    var phi_388_: i32;
    var phi_398_: bool;
    var phi_408_: u32;
    var phi_409_: u32;
    var phi_411_: bool;
    var phi_416_: u32;
    var phi_429_: i32;
    var phi_449_: i32;
    var phi_467_: f32;
    var phi_473_: f32;
    var phi_484_: f32;
    var phi_490_: f32;
    var phi_513_: f32;
    var phi_524_: f32;
    var phi_533_: f32;
    var phi_539_: f32;
    var phi_550_: f32;
    var phi_556_: f32;
    var phi_579_: f32;
    var phi_590_: f32;
    var phi_599_: f32;
    var phi_605_: f32;
    var phi_616_: f32;
    var phi_622_: f32;
    var phi_645_: f32;
    var phi_656_: f32;
    var phi_756_: f32;
    var phi_757_: f32;
    var phi_4580_: bool;
    var phi_4493_: f32;
    var phi_1930_: type_51;
    var phi_1933_: u32;
    var phi_1935_: bool;
    var phi_1937_: u32;
    var phi_1948_: bool;
    var phi_1986_: type_51;
    var phi_1987_: bool;
    var phi_1988_: u32;
    var phi_3684_: u32;
    var phi_3685_: u32;
    var phi_3695_: u32;
    var phi_3697_: u32;
    var phi_3698_: bool;
    var phi_3718_: u32;
    var phi_3719_: u32;
    var phi_3723_: type_54;
    var phi_4068_: type_51;
    var phi_4101_: type_51;
    var phi_4102_: type_51;
    var phi_4103_: u32;
    var phi_4105_: type_51;
    var phi_4106_: u32;
    var phi_4107_: bool;
    var phi_4116_: type_51;
    var phi_4121_: type_51;
    var phi_4122_: bool;
    var phi_4577_: bool;
    var phi_4567_: f32;
    var phi_2006_: type_4;
    var phi_2007_: type_4;
    var phi_2030_: type_4;
    var phi_2051_: u32;
    var phi_2140_: array<array<f32, 3>, 3>;
    var phi_2612_: vec3<f32>;
    var phi_2613_: vec3<f32>;
    var phi_2644_: bool;
    var phi_2653_: vec3<f32>;
    var phi_2693_: type_25;
    var phi_2695_: type_25;
    var phi_2696_: bool;
    var phi_2700_: type_25;
    var phi_2701_: type_25;
    var phi_2702_: type_25;
    var phi_2703_: bool;
    var phi_2707_: type_25;
    var phi_2708_: bool;
    var phi_2712_: type_25;
    var phi_2713_: bool;
    var phi_2717_: type_25;
    var phi_2729_: type_4;
    var phi_2732_: type_25;
    var phi_2730_: type_4;
    var phi_2755_: type_4;
    var phi_2787_: bool;
    var phi_2788_: bool;
    var phi_2809_: type_25;
    var phi_2733_: type_25;
    var phi_4568_: bool;
    var phi_4902_: f32;
    var phi_4901_: f32;
    var phi_4685_: bool;
    var phi_4900_: f32;
    var phi_4684_: bool;
    var phi_4899_: f32;
    var phi_4683_: bool;
    var phi_4839_: f32;
    var phi_4682_: bool;
    var phi_4804_: f32;
    var phi_4691_: bool;
    var phi_4124_: type_51;
    var phi_4125_: bool;
    var phi_4126_: u32;
    var phi_4803_: f32;
    var phi_4690_: bool;
    var phi_4127_: type_51;
    var phi_4128_: u32;
    var phi_4129_: bool;
    var phi_4130_: u32;
    var phi_4802_: f32;
    var phi_4689_: bool;
    var phi_4131_: type_51;
    var phi_4132_: u32;
    var phi_4133_: bool;
    var phi_4134_: u32;
    var phi_4801_: f32;
    var phi_4688_: bool;
    var phi_1931_: type_51;
    var phi_1934_: u32;
    var phi_1936_: bool;
    var phi_1938_: u32;
    var phi_4135_: bool;
    var phi_4687_: bool;
    var phi_4142_: type_4;
    var phi_4143_: type_4;
    var phi_4166_: type_4;
    var phi_4232_: type_25;
    var phi_4794_: bool;

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
                            phi_387_ = (bitcast<i32>((_e219 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_387_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e219)), 32u, (_e219 == 0u))));
                        }
                        let _e233 = phi_387_;
                        phi_388_ = _e233;
                    } else {
                        phi_388_ = 0i;
                    }
                    let _e235 = phi_388_;
                    let _e236 = (_e152 == _e191);
                    if _e236 {
                        phi_398_ = true;
                    } else {
                        phi_398_ = (_e159 == _e191);
                    }
                    let _e239 = phi_398_;
                    let _e240 = select(1u, 0u, _e236);
                    if _e239 {
                        let _e241 = (_e240 + 1u);
                        phi_408_ = _e241;
                        phi_409_ = _e241;
                        phi_411_ = select(true, false, (_e241 == 2u));
                    } else {
                        phi_408_ = u32();
                        phi_409_ = 0u;
                        phi_411_ = true;
                    }
                    let _e245 = phi_408_;
                    let _e247 = phi_409_;
                    let _e249 = phi_411_;
                    if _e249 {
                        phi_416_ = (_e247 + 1u);
                    } else {
                        phi_416_ = 0u;
                    }
                    let _e253 = phi_416_;
                    let _e254 = select(_e245, _e247, _e249);
                    let _e255 = select(_e240, select(2u, _e240, _e239), _e249);
                    if (_e122 < -126i) {
                        phi_429_ = -126i;
                    } else {
                        phi_429_ = select(_e122, 127i, (_e122 > 127i));
                    }
                    let _e260 = phi_429_;
                    let _e265 = bitcast<f32>((bitcast<u32>((_e260 + 127i)) << bitcast<u32>(23i)));
                    let _e271 = bitcast<f32>((bitcast<u32>(((_e122 - _e260) + 127i)) << bitcast<u32>(23i)));
                    let _e272 = -(_e235);
                    if (_e272 < -126i) {
                        phi_449_ = -126i;
                    } else {
                        phi_449_ = select(_e272, 127i, (_e272 > 127i));
                    }
                    let _e277 = phi_449_;
                    let _e282 = bitcast<f32>((bitcast<u32>((_e277 + 127i)) << bitcast<u32>(23i)));
                    let _e288 = bitcast<f32>((bitcast<u32>(((_e272 - _e277) + 127i)) << bitcast<u32>(23i)));
                    let _e292 = global_5.member[_e140].member;
                    let _e293 = (_e254 == 0u);
                    if _e293 {
                        phi_467_ = _e292[0];
                    } else {
                        phi_467_ = _e292[1];
                    }
                    let _e297 = phi_467_;
                    let _e298 = (_e254 == 2u);
                    if _e298 {
                        phi_473_ = _e292[2];
                    } else {
                        phi_473_ = _e297;
                    }
                    let _e301 = phi_473_;
                    let _e303 = ((_e301 * _e265) * _e271);
                    let _e304 = global_5.member[_e140].member_2;
                    if _e293 {
                        phi_484_ = _e304[0];
                    } else {
                        phi_484_ = _e304[1];
                    }
                    let _e308 = phi_484_;
                    if _e298 {
                        phi_490_ = _e304[2];
                    } else {
                        phi_490_ = _e308;
                    }
                    let _e311 = phi_490_;
                    let _e313 = ((_e311 * _e282) * _e288);
                    let _e317 = (bitcast<f32>((bitcast<u32>(_e313) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e317 {
                        let _e321 = (bitcast<f32>((bitcast<u32>(_e303) & 2147483647u)) * 0.00000011920929f);
                        phi_513_ = select(0.00000000000011368684f, _e321, (_e321 > 0.00000000000011368684f));
                    } else {
                        phi_513_ = 0f;
                    }
                    let _e325 = phi_513_;
                    let _e326 = (_e303 + _e325);
                    let _e327 = (_e303 - _e325);
                    let _e328 = select(_e313, 0f, _e317);
                    if _e317 {
                        phi_524_ = 38685626000000000000000000f;
                    } else {
                        phi_524_ = (1f / _e313);
                    }
                    let _e331 = phi_524_;
                    let _e332 = (_e253 == 0u);
                    if _e332 {
                        phi_533_ = _e292[0];
                    } else {
                        phi_533_ = _e292[1];
                    }
                    let _e336 = phi_533_;
                    let _e337 = (_e253 == 2u);
                    if _e337 {
                        phi_539_ = _e292[2];
                    } else {
                        phi_539_ = _e336;
                    }
                    let _e340 = phi_539_;
                    let _e342 = ((_e340 * _e265) * _e271);
                    if _e332 {
                        phi_550_ = _e304[0];
                    } else {
                        phi_550_ = _e304[1];
                    }
                    let _e346 = phi_550_;
                    if _e337 {
                        phi_556_ = _e304[2];
                    } else {
                        phi_556_ = _e346;
                    }
                    let _e349 = phi_556_;
                    let _e351 = ((_e349 * _e282) * _e288);
                    let _e355 = (bitcast<f32>((bitcast<u32>(_e351) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e355 {
                        let _e359 = (bitcast<f32>((bitcast<u32>(_e342) & 2147483647u)) * 0.00000011920929f);
                        phi_579_ = select(0.00000000000011368684f, _e359, (_e359 > 0.00000000000011368684f));
                    } else {
                        phi_579_ = 0f;
                    }
                    let _e363 = phi_579_;
                    let _e364 = (_e342 + _e363);
                    let _e365 = (_e342 - _e363);
                    let _e366 = select(_e351, 0f, _e355);
                    if _e355 {
                        phi_590_ = 38685626000000000000000000f;
                    } else {
                        phi_590_ = (1f / _e351);
                    }
                    let _e369 = phi_590_;
                    let _e370 = (_e255 == 0u);
                    if _e370 {
                        phi_599_ = _e292[0];
                    } else {
                        phi_599_ = _e292[1];
                    }
                    let _e374 = phi_599_;
                    let _e375 = (_e255 == 2u);
                    if _e375 {
                        phi_605_ = _e292[2];
                    } else {
                        phi_605_ = _e374;
                    }
                    let _e378 = phi_605_;
                    let _e380 = ((_e378 * _e265) * _e271);
                    if _e370 {
                        phi_616_ = _e304[0];
                    } else {
                        phi_616_ = _e304[1];
                    }
                    let _e384 = phi_616_;
                    if _e375 {
                        phi_622_ = _e304[2];
                    } else {
                        phi_622_ = _e384;
                    }
                    let _e387 = phi_622_;
                    let _e389 = ((_e387 * _e282) * _e288);
                    let _e393 = (bitcast<f32>((bitcast<u32>(_e389) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e393 {
                        let _e397 = (bitcast<f32>((bitcast<u32>(_e380) & 2147483647u)) * 0.00000011920929f);
                        phi_645_ = select(0.00000000000011368684f, _e397, (_e397 > 0.00000000000011368684f));
                    } else {
                        phi_645_ = 0f;
                    }
                    let _e401 = phi_645_;
                    let _e402 = (_e380 + _e401);
                    let _e403 = (_e380 - _e401);
                    let _e404 = select(_e389, 0f, _e393);
                    if _e393 {
                        phi_656_ = 38685626000000000000000000f;
                    } else {
                        phi_656_ = (1f / _e389);
                    }
                    let _e407 = phi_656_;
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
                        phi_756_ = select(-340282350000000000000000000000000000000f, _e448, (_e448 > -340282350000000000000000000000000000000f));
                        phi_757_ = select(-340282350000000000000000000000000000000f, _e441, (_e441 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_756_ = 0f;
                        phi_757_ = 1f;
                    }
                    let _e452 = phi_756_;
                    let _e454 = phi_757_;
                    local_2 = array<type_25, 8>(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_4 = array<type_51, 128>(type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 0u));
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e457 = (_e254 % 3u);
                    let _e458 = (_e457 < 3u);
                    if _e458 {
                    } else {
                        break;
                    }
                    let _e460 = local_1[_e457];
                    let _e463 = (_e253 % 3u);
                    let _e464 = (_e463 < 3u);
                    if _e464 {
                    } else {
                        break;
                    }
                    let _e466 = local_1[_e463];
                    let _e469 = (_e255 % 3u);
                    let _e470 = (_e469 < 3u);
                    if _e470 {
                    } else {
                        break;
                    }
                    let _e472 = local_1[_e469];
                    if _e458 {
                    } else {
                        break;
                    }
                    let _e477 = local[_e457];
                    if _e464 {
                    } else {
                        break;
                    }
                    let _e481 = local[_e463];
                    if _e470 {
                    } else {
                        break;
                    }
                    let _e485 = local[_e469];
                    phi_4580_ = false;
                    phi_4493_ = _e452;
                    phi_1930_ = type_51(type_29(vec4<f32>((f32(_e460) * _e134), (f32(_e466) * _e134), (f32(_e472) * _e134), 0f), vec4<f32>((f32(_e477) * _e134), (f32(_e481) * _e134), (f32(_e485) * _e134), 0f)), select(0u, 2147483648u, (_e84 == 0u)));
                    phi_1933_ = ((3u * _e84) + 1u);
                    phi_1935_ = (_e454 <= _e452);
                    phi_1937_ = 0u;
                    loop {
                        let _e495 = phi_4580_;
                        let _e497 = phi_4493_;
                        let _e499 = phi_1930_;
                        let _e501 = phi_1933_;
                        let _e503 = phi_1935_;
                        let _e505 = phi_1937_;
                        if _e503 {
                            phi_1948_ = true;
                        } else {
                            phi_1948_ = (_e505 > 0u);
                        }
                        let _e508 = phi_1948_;
                        if _e508 {
                            let _e509 = (_e501 > 0u);
                            if _e509 {
                                if _e503 {
                                    phi_1986_ = _e499;
                                    phi_1987_ = _e503;
                                    phi_1988_ = _e505;
                                } else {
                                    let _e510 = (_e505 - 1u);
                                    let _e511 = (_e510 % 128u);
                                    let _e512 = (_e511 < 128u);
                                    if _e512 {
                                    } else {
                                        phi_4687_ = true;
                                        break;
                                    }
                                    let _e514 = local_4[_e511];
                                    if _e512 {
                                    } else {
                                        phi_4687_ = true;
                                        break;
                                    }
                                    let _e522 = local_3[_e511];
                                    phi_1986_ = type_51(type_29(_e514.member.member, _e514.member.member_1), _e514.member_1);
                                    phi_1987_ = (_e522 <= _e497);
                                    phi_1988_ = _e510;
                                }
                                let _e525 = phi_1986_;
                                let _e527 = phi_1987_;
                                let _e529 = phi_1988_;
                                if _e527 {
                                    if ((_e525.member_1 & 2147483648u) != 0u) {
                                        phi_4577_ = _e495;
                                        phi_4567_ = _e497;
                                        phi_2006_ = type_4(0u, ((_e525.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e974 = phi_4577_;
                                            let _e976 = phi_4567_;
                                            let _e978 = phi_2006_;
                                            if (_e978.member < _e978.member_1) {
                                                phi_2007_ = type_4((_e978.member + 1u), _e978.member_1);
                                                phi_2030_ = type_4(1u, _e978.member);
                                            } else {
                                                phi_2007_ = _e978;
                                                phi_2030_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e991 = phi_2007_;
                                            let _e993 = phi_2030_;
                                            let _e997 = (bitcast<i32>(_e993.member) != 0i);
                                            if _e997 {
                                                let _e998 = ((_e525.member_1 & 268435455u) + _e993.member_1);
                                                let _e999 = (_e998 < _e86);
                                                if _e999 {
                                                    if _e999 {
                                                    } else {
                                                        phi_4839_ = _e976;
                                                        phi_4682_ = true;
                                                        break;
                                                    }
                                                    let _e1003 = global_2.member[_e998].member_1;
                                                    phi_2051_ = _e1003;
                                                } else {
                                                    phi_2051_ = 4294967295u;
                                                }
                                                let _e1005 = phi_2051_;
                                                if (_e998 >= _e86) {
                                                    phi_2140_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e999 {
                                                    } else {
                                                        phi_4839_ = _e976;
                                                        phi_4682_ = true;
                                                        break;
                                                    }
                                                    if (_e457 < 9u) {
                                                    } else {
                                                        phi_4839_ = _e976;
                                                        phi_4682_ = true;
                                                        break;
                                                    }
                                                    let _e1012 = global_2.member[_e998].member[_e457];
                                                    if (_e463 < 9u) {
                                                    } else {
                                                        phi_4839_ = _e976;
                                                        phi_4682_ = true;
                                                        break;
                                                    }
                                                    let _e1018 = global_2.member[_e998].member[_e463];
                                                    if (_e469 < 9u) {
                                                    } else {
                                                        phi_4839_ = _e976;
                                                        phi_4682_ = true;
                                                        break;
                                                    }
                                                    let _e1024 = global_2.member[_e998].member[_e469];
                                                    let _e1026 = (3u + _e457);
                                                    if (_e1026 < 9u) {
                                                    } else {
                                                        phi_4839_ = _e976;
                                                        phi_4682_ = true;
                                                        break;
                                                    }
                                                    let _e1032 = global_2.member[_e998].member[_e1026];
                                                    let _e1033 = (3u + _e463);
                                                    if (_e1033 < 9u) {
                                                    } else {
                                                        phi_4839_ = _e976;
                                                        phi_4682_ = true;
                                                        break;
                                                    }
                                                    let _e1039 = global_2.member[_e998].member[_e1033];
                                                    let _e1040 = (3u + _e469);
                                                    if (_e1040 < 9u) {
                                                    } else {
                                                        phi_4839_ = _e976;
                                                        phi_4682_ = true;
                                                        break;
                                                    }
                                                    let _e1046 = global_2.member[_e998].member[_e1040];
                                                    let _e1048 = (6u + _e457);
                                                    if (_e1048 < 9u) {
                                                    } else {
                                                        phi_4839_ = _e976;
                                                        phi_4682_ = true;
                                                        break;
                                                    }
                                                    let _e1054 = global_2.member[_e998].member[_e1048];
                                                    let _e1055 = (6u + _e463);
                                                    if (_e1055 < 9u) {
                                                    } else {
                                                        phi_4839_ = _e976;
                                                        phi_4682_ = true;
                                                        break;
                                                    }
                                                    let _e1061 = global_2.member[_e998].member[_e1055];
                                                    let _e1062 = (6u + _e469);
                                                    if (_e1062 < 9u) {
                                                    } else {
                                                        phi_4839_ = _e976;
                                                        phi_4682_ = true;
                                                        break;
                                                    }
                                                    let _e1068 = global_2.member[_e998].member[_e1062];
                                                    phi_2140_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1012, _e1018, _e1024), array<f32, 3>(_e1032, _e1039, _e1046), array<f32, 3>(_e1054, _e1061, _e1068));
                                                }
                                                let _e1072 = phi_2140_;
                                                let _e1079 = (_e1072[0][2] - _e380);
                                                let _e1082 = (((_e1072[0][0] - _e303) * _e404) - (_e1079 * _e328));
                                                let _e1085 = (((_e1072[0][1] - _e342) * _e404) - (_e1079 * _e366));
                                                let _e1092 = (_e1072[1][2] - _e380);
                                                let _e1095 = (((_e1072[1][0] - _e303) * _e404) - (_e1092 * _e328));
                                                let _e1098 = (((_e1072[1][1] - _e342) * _e404) - (_e1092 * _e366));
                                                let _e1105 = (_e1072[2][2] - _e380);
                                                let _e1108 = (((_e1072[2][0] - _e303) * _e404) - (_e1105 * _e328));
                                                let _e1111 = (((_e1072[2][1] - _e342) * _e404) - (_e1105 * _e366));
                                                let _e1112 = (_e1108 * _e1098);
                                                let _e1113 = (_e1111 * _e1095);
                                                let _e1114 = (_e1082 * _e1111);
                                                let _e1115 = (_e1085 * _e1108);
                                                let _e1116 = (_e1095 * _e1085);
                                                let _e1117 = (_e1098 * _e1082);
                                                let _e1122 = (((_e1112 >= _e1113) && (_e1114 >= _e1115)) && (_e1116 >= _e1117));
                                                if (_e1122 || (((_e1112 <= _e1113) && (_e1114 <= _e1115)) && (_e1116 <= _e1117))) {
                                                    let _e1129 = select(-1f, 1f, _e1122);
                                                    let _e1131 = ((_e1112 - _e1113) * _e1129);
                                                    let _e1133 = select(0f, _e1131, (_e1131 > 0f));
                                                    let _e1135 = ((_e1114 - _e1115) * _e1129);
                                                    let _e1137 = select(0f, _e1135, (_e1135 > 0f));
                                                    let _e1139 = ((_e1116 - _e1117) * _e1129);
                                                    let _e1141 = select(0f, _e1139, (_e1139 > 0f));
                                                    let _e1143 = ((_e1133 + _e1137) + _e1141);
                                                    if (_e1143 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2707_ = type_25();
                                                        phi_2708_ = true;
                                                    } else {
                                                        let _e1146 = select(_e1072[1][0], _e1072[0][0], (_e1072[0][0] < _e1072[1][0]));
                                                        let _e1150 = select(_e1072[1][0], _e1072[0][0], (_e1072[0][0] > _e1072[1][0]));
                                                        let _e1154 = select(_e1072[1][1], _e1072[0][1], (_e1072[0][1] < _e1072[1][1]));
                                                        let _e1158 = select(_e1072[1][1], _e1072[0][1], (_e1072[0][1] > _e1072[1][1]));
                                                        let _e1162 = select(_e1072[1][2], _e1072[0][2], (_e1072[0][2] < _e1072[1][2]));
                                                        let _e1166 = select(_e1072[1][2], _e1072[0][2], (_e1072[0][2] > _e1072[1][2]));
                                                        let _e1171 = ((select(_e1072[2][0], _e1146, (_e1146 < _e1072[2][0])) - _e326) * _e331);
                                                        let _e1172 = ((select(_e1072[2][0], _e1150, (_e1150 > _e1072[2][0])) - _e327) * _e331);
                                                        let _e1175 = ((select(_e1072[2][1], _e1154, (_e1154 < _e1072[2][1])) - _e364) * _e369);
                                                        let _e1176 = ((select(_e1072[2][1], _e1158, (_e1158 > _e1072[2][1])) - _e365) * _e369);
                                                        let _e1179 = ((select(_e1072[2][2], _e1162, (_e1162 < _e1072[2][2])) - _e402) * _e407);
                                                        let _e1180 = ((select(_e1072[2][2], _e1166, (_e1166 > _e1072[2][2])) - _e403) * _e407);
                                                        let _e1182 = select(_e1180, _e1179, (_e1179 < _e1180));
                                                        let _e1184 = select(_e1180, _e1179, (_e1179 > _e1180));
                                                        let _e1186 = select(_e1172, _e1171, (_e1171 < _e1172));
                                                        let _e1188 = select(_e1176, _e1175, (_e1175 < _e1176));
                                                        let _e1190 = select(_e1188, _e1186, (_e1186 > _e1188));
                                                        let _e1192 = select(_e1182, _e1190, (_e1190 > _e1182));
                                                        let _e1194 = select(_e1172, _e1171, (_e1171 > _e1172));
                                                        let _e1196 = select(_e1176, _e1175, (_e1175 > _e1176));
                                                        let _e1198 = select(_e1196, _e1194, (_e1194 < _e1196));
                                                        let _e1200 = select(_e1184, _e1198, (_e1198 < _e1184));
                                                        let _e1201 = -(_e1182);
                                                        let _e1207 = select(_e454, _e1192, (_e1192 > _e454));
                                                        if (_e1207 > (_e1200 + (select(_e1201, _e1184, (_e1184 > _e1201)) * 0.0000019073523f))) {
                                                            phi_2702_ = type_25();
                                                            phi_2703_ = true;
                                                        } else {
                                                            let _e1209 = (_e1207 > _e976);
                                                            if _e1209 {
                                                                phi_2701_ = type_25();
                                                            } else {
                                                                let _e1213 = (_e1072[1][0] - _e1072[0][0]);
                                                                let _e1214 = (_e1072[1][1] - _e1072[0][1]);
                                                                let _e1215 = (_e1072[1][2] - _e1072[0][2]);
                                                                let _e1216 = vec3<f32>(_e1213, _e1214, _e1215);
                                                                let _e1217 = (_e1072[2][0] - _e1072[1][0]);
                                                                let _e1218 = (_e1072[2][1] - _e1072[1][1]);
                                                                let _e1219 = (_e1072[2][2] - _e1072[1][2]);
                                                                let _e1220 = vec3<f32>(_e1217, _e1218, _e1219);
                                                                let _e1221 = (_e1072[0][0] - _e1072[2][0]);
                                                                let _e1222 = (_e1072[0][1] - _e1072[2][1]);
                                                                let _e1223 = (_e1072[0][2] - _e1072[2][2]);
                                                                let _e1224 = vec3<f32>(_e1221, _e1222, _e1223);
                                                                let _e1227 = bitcast<f32>((bitcast<u32>(_e1213) & 2147483647u));
                                                                let _e1230 = bitcast<f32>((bitcast<u32>(_e1214) & 2147483647u));
                                                                let _e1232 = select(_e1230, _e1227, (_e1227 > _e1230));
                                                                let _e1235 = bitcast<f32>((bitcast<u32>(_e1215) & 2147483647u));
                                                                let _e1237 = select(_e1235, _e1232, (_e1232 > _e1235));
                                                                let _e1240 = bitcast<f32>((bitcast<u32>(_e1217) & 2147483647u));
                                                                let _e1243 = bitcast<f32>((bitcast<u32>(_e1218) & 2147483647u));
                                                                let _e1245 = select(_e1243, _e1240, (_e1240 > _e1243));
                                                                let _e1248 = bitcast<f32>((bitcast<u32>(_e1219) & 2147483647u));
                                                                let _e1250 = select(_e1248, _e1245, (_e1245 > _e1248));
                                                                let _e1253 = bitcast<f32>((bitcast<u32>(_e1221) & 2147483647u));
                                                                let _e1256 = bitcast<f32>((bitcast<u32>(_e1222) & 2147483647u));
                                                                let _e1258 = select(_e1256, _e1253, (_e1253 > _e1256));
                                                                let _e1261 = bitcast<f32>((bitcast<u32>(_e1223) & 2147483647u));
                                                                let _e1263 = select(_e1261, _e1258, (_e1258 > _e1261));
                                                                let _e1265 = select(_e1250, _e1237, (_e1237 > _e1250));
                                                                let _e1267 = select(_e1263, _e1265, (_e1265 > _e1263));
                                                                if (_e1237 == _e1267) {
                                                                    phi_2612_ = _e1220;
                                                                    phi_2613_ = _e1224;
                                                                } else {
                                                                    let _e1270 = vec3((_e1250 == _e1267));
                                                                    phi_2612_ = select(_e1216, _e1224, _e1270);
                                                                    phi_2613_ = select(_e1220, _e1216, _e1270);
                                                                }
                                                                let _e1274 = phi_2612_;
                                                                let _e1276 = phi_2613_;
                                                                let _e1283 = ((_e1274.y * _e1276.z) - (_e1276.y * _e1274.z));
                                                                let _e1288 = ((_e1274.z * _e1276.x) - (_e1276.z * _e1274.x));
                                                                let _e1291 = ((_e1274.x * _e1276.y) - (_e1276.x * _e1274.y));
                                                                if (_e1133 >= _e1137) {
                                                                    phi_2644_ = select(true, false, (_e1133 >= _e1141));
                                                                } else {
                                                                    phi_2644_ = true;
                                                                }
                                                                let _e1296 = phi_2644_;
                                                                if _e1296 {
                                                                    phi_2653_ = select(vec3<f32>(_e1072[2][0], _e1072[2][1], _e1072[2][2]), vec3<f32>(_e1072[1][0], _e1072[1][1], _e1072[1][2]), vec3((_e1137 >= _e1141)));
                                                                } else {
                                                                    phi_2653_ = vec3<f32>(_e1072[0][0], _e1072[0][1], _e1072[0][2]);
                                                                }
                                                                let _e1301 = phi_2653_;
                                                                let _e1318 = ((((_e1283 * (_e1301.x - _e303)) + (_e1288 * (_e1301.y - _e342))) + (_e1291 * (_e1301.z - _e380))) / (((_e1283 * _e328) + (_e1288 * _e366)) + (_e1291 * _e404)));
                                                                let _e1320 = select(_e1200, _e1318, (_e1318 < _e1200));
                                                                let _e1322 = select(_e1192, _e1320, (_e1320 > _e1192));
                                                                if (_e1322 >= _e454) {
                                                                    let _e1324 = (_e1322 <= _e976);
                                                                    if _e1324 {
                                                                        let _e1325 = (1f / _e1143);
                                                                        phi_2693_ = type_25(_e1322, (_e1137 * _e1325), (_e1141 * _e1325), _e1005);
                                                                    } else {
                                                                        phi_2693_ = type_25();
                                                                    }
                                                                    let _e1330 = phi_2693_;
                                                                    phi_2695_ = _e1330;
                                                                    phi_2696_ = select(true, false, _e1324);
                                                                } else {
                                                                    phi_2695_ = type_25();
                                                                    phi_2696_ = true;
                                                                }
                                                                let _e1333 = phi_2695_;
                                                                let _e1335 = phi_2696_;
                                                                if _e1335 {
                                                                    phi_2700_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2700_ = _e1333;
                                                                }
                                                                let _e1337 = phi_2700_;
                                                                phi_2701_ = _e1337;
                                                            }
                                                            let _e1339 = phi_2701_;
                                                            phi_2702_ = _e1339;
                                                            phi_2703_ = _e1209;
                                                        }
                                                        let _e1341 = phi_2702_;
                                                        let _e1343 = phi_2703_;
                                                        phi_2707_ = _e1341;
                                                        phi_2708_ = _e1343;
                                                    }
                                                    let _e1345 = phi_2707_;
                                                    let _e1347 = phi_2708_;
                                                    phi_2712_ = _e1345;
                                                    phi_2713_ = _e1347;
                                                } else {
                                                    phi_2712_ = type_25();
                                                    phi_2713_ = true;
                                                }
                                                let _e1349 = phi_2712_;
                                                let _e1351 = phi_2713_;
                                                if _e1351 {
                                                    phi_2717_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2717_ = _e1349;
                                                }
                                                let _e1353 = phi_2717_;
                                                if (_e1353.member_3 != 4294967295u) {
                                                    if (_e1005 != 4294967295u) {
                                                        phi_2729_ = type_4(0u, 8u);
                                                        phi_2732_ = _e1353;
                                                        loop {
                                                            let _e1358 = phi_2729_;
                                                            let _e1360 = phi_2732_;
                                                            if (_e1358.member < _e1358.member_1) {
                                                                phi_2730_ = type_4((_e1358.member + 1u), _e1358.member_1);
                                                                phi_2755_ = type_4(1u, _e1358.member);
                                                            } else {
                                                                phi_2730_ = _e1358;
                                                                phi_2755_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1373 = phi_2730_;
                                                            let _e1375 = phi_2755_;
                                                            let _e1379 = (bitcast<i32>(_e1375.member) != 0i);
                                                            if _e1379 {
                                                                let _e1380 = (_e1375.member_1 < 8u);
                                                                if _e1380 {
                                                                } else {
                                                                    phi_4568_ = true;
                                                                    break;
                                                                }
                                                                let _e1385 = local_2[_e1375.member_1].member;
                                                                if (_e1360.member < _e1385) {
                                                                    phi_2788_ = true;
                                                                } else {
                                                                    let _e1387 = local_2[_e1375.member_1].member;
                                                                    if (_e1360.member == _e1387) {
                                                                        let _e1392 = local_2[_e1375.member_1].member_3;
                                                                        phi_2787_ = (_e1360.member_3 < _e1392);
                                                                    } else {
                                                                        phi_2787_ = false;
                                                                    }
                                                                    let _e1395 = phi_2787_;
                                                                    phi_2788_ = _e1395;
                                                                }
                                                                let _e1397 = phi_2788_;
                                                                if _e1397 {
                                                                    if _e1380 {
                                                                    } else {
                                                                        phi_4568_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1398 = local_2[_e1375.member_1];
                                                                    local_2[_e1375.member_1] = type_25(_e1360.member, _e1360.member_1, _e1360.member_2, _e1360.member_3);
                                                                    phi_2809_ = type_25(_e1398.member, _e1398.member_1, _e1398.member_2, _e1398.member_3);
                                                                } else {
                                                                    phi_2809_ = _e1360;
                                                                }
                                                                let _e1409 = phi_2809_;
                                                                phi_2733_ = _e1409;
                                                            } else {
                                                                phi_2733_ = type_25();
                                                            }
                                                            let _e1411 = phi_2733_;
                                                            continue;
                                                            continuing {
                                                                phi_2729_ = _e1373;
                                                                phi_2732_ = _e1411;
                                                                phi_4568_ = _e974;
                                                                break if !(_e1379);
                                                            }
                                                        }
                                                        let _e1414 = phi_4568_;
                                                        phi_4839_ = _e976;
                                                        phi_4682_ = _e1414;
                                                        if _e1414 {
                                                            break;
                                                        }
                                                        let _e1417 = local_2[7u].member_3;
                                                        if (_e1417 != 4294967295u) {
                                                            let _e1421 = local_2[7u].member;
                                                            phi_4902_ = _e1421;
                                                        } else {
                                                            phi_4902_ = _e976;
                                                        }
                                                        let _e1423 = phi_4902_;
                                                        phi_4901_ = _e1423;
                                                        phi_4685_ = _e1414;
                                                    } else {
                                                        phi_4901_ = _e976;
                                                        phi_4685_ = _e974;
                                                    }
                                                    let _e1425 = phi_4901_;
                                                    let _e1427 = phi_4685_;
                                                    phi_4900_ = _e1425;
                                                    phi_4684_ = _e1427;
                                                } else {
                                                    phi_4900_ = _e976;
                                                    phi_4684_ = _e974;
                                                }
                                                let _e1429 = phi_4900_;
                                                let _e1431 = phi_4684_;
                                                phi_4899_ = _e1429;
                                                phi_4683_ = _e1431;
                                            } else {
                                                phi_4899_ = _e976;
                                                phi_4683_ = _e974;
                                            }
                                            let _e1433 = phi_4899_;
                                            let _e1435 = phi_4683_;
                                            continue;
                                            continuing {
                                                phi_4577_ = _e1435;
                                                phi_4567_ = _e1433;
                                                phi_2006_ = _e991;
                                                phi_4839_ = _e1433;
                                                phi_4682_ = _e1435;
                                                break if !(_e997);
                                            }
                                        }
                                        let _e1438 = phi_4839_;
                                        let _e1440 = phi_4682_;
                                        phi_4687_ = _e1440;
                                        if _e1440 {
                                            break;
                                        }
                                        phi_4804_ = _e1438;
                                        phi_4691_ = _e1440;
                                        phi_4124_ = _e525;
                                        phi_4125_ = false;
                                        phi_4126_ = _e529;
                                    } else {
                                        if (_e525.member_1 >= _e84) {
                                            phi_3723_ = type_54(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_51(type_29(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e525.member_1 < _e84) {
                                            } else {
                                                phi_4687_ = true;
                                                break;
                                            }
                                            let _e541 = ((1u + _e254) % 4u);
                                            if (_e541 < 4u) {
                                            } else {
                                                phi_4687_ = true;
                                                break;
                                            }
                                            let _e546 = global_4.member[_e525.member_1][_e541];
                                            let _e548 = ((1u + _e253) % 4u);
                                            if (_e548 < 4u) {
                                            } else {
                                                phi_4687_ = true;
                                                break;
                                            }
                                            let _e553 = global_4.member[_e525.member_1][_e548];
                                            let _e555 = ((1u + _e255) % 4u);
                                            if (_e555 < 4u) {
                                            } else {
                                                phi_4687_ = true;
                                                break;
                                            }
                                            let _e560 = global_4.member[_e525.member_1][_e555];
                                            let _e562 = ((_e254 + 1u) % 4u);
                                            if (_e562 < 4u) {
                                            } else {
                                                phi_4687_ = true;
                                                break;
                                            }
                                            let _e567 = global_4.member[_e525.member_1][_e562];
                                            let _e569 = (_e567 >> bitcast<u32>(11u));
                                            let _e571 = ((_e253 + 1u) % 4u);
                                            if (_e571 < 4u) {
                                            } else {
                                                phi_4687_ = true;
                                                break;
                                            }
                                            let _e576 = global_4.member[_e525.member_1][_e571];
                                            let _e578 = (_e576 >> bitcast<u32>(11u));
                                            let _e580 = ((_e255 + 1u) % 4u);
                                            if (_e580 < 4u) {
                                            } else {
                                                phi_4687_ = true;
                                                break;
                                            }
                                            let _e585 = global_4.member[_e525.member_1][_e580];
                                            let _e587 = (_e585 >> bitcast<u32>(11u));
                                            let _e610 = (bitcast<f32>((bitcast<u32>((_e525.member.member_1.x - _e525.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e611 = (bitcast<f32>((bitcast<u32>((_e525.member.member_1.y - _e525.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e612 = (bitcast<f32>((bitcast<u32>((_e525.member.member_1.z - _e525.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e614 = select(_e134, _e610, (_e610 > _e134));
                                            let _e616 = select(_e134, _e611, (_e611 > _e134));
                                            let _e618 = select(_e134, _e612, (_e612 > _e134));
                                            let _e643 = bitcast<u32>((f32(bitcast<i32>((_e546 & 1023u))) * _e614));
                                            let _e648 = (bitcast<i32>((_e546 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e651 = bitcast<f32>((_e643 & bitcast<u32>(_e648)));
                                            let _e652 = bitcast<u32>((f32(bitcast<i32>((_e553 & 1023u))) * _e616));
                                            let _e657 = (bitcast<i32>((_e553 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e660 = bitcast<f32>((_e652 & bitcast<u32>(_e657)));
                                            let _e661 = bitcast<u32>((f32(bitcast<i32>((_e560 & 1023u))) * _e618));
                                            let _e666 = (bitcast<i32>((_e560 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e669 = bitcast<f32>((_e661 & bitcast<u32>(_e666)));
                                            let _e673 = bitcast<f32>((_e643 & bitcast<u32>(~(_e648))));
                                            let _e677 = bitcast<f32>((_e652 & bitcast<u32>(~(_e657))));
                                            let _e681 = bitcast<f32>((_e661 & bitcast<u32>(~(_e666))));
                                            let _e682 = bitcast<u32>((f32(bitcast<i32>((_e569 & 1023u))) * _e614));
                                            let _e687 = (bitcast<i32>((_e569 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e690 = bitcast<f32>((_e682 & bitcast<u32>(_e687)));
                                            let _e691 = bitcast<u32>((f32(bitcast<i32>((_e578 & 1023u))) * _e616));
                                            let _e696 = (bitcast<i32>((_e578 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e699 = bitcast<f32>((_e691 & bitcast<u32>(_e696)));
                                            let _e700 = bitcast<u32>((f32(bitcast<i32>((_e587 & 1023u))) * _e618));
                                            let _e705 = (bitcast<i32>((_e587 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e708 = bitcast<f32>((_e700 & bitcast<u32>(_e705)));
                                            let _e712 = bitcast<f32>((_e682 & bitcast<u32>(~(_e687))));
                                            let _e716 = bitcast<f32>((_e691 & bitcast<u32>(~(_e696))));
                                            let _e720 = bitcast<f32>((_e700 & bitcast<u32>(~(_e705))));
                                            let _e750 = global_4.member[_e525.member_1][0u];
                                            let _e754 = global_4.member[_e525.member_1][1u];
                                            let _e758 = global_4.member[_e525.member_1][2u];
                                            let _e762 = global_4.member[_e525.member_1][3u];
                                            let _e774 = (((_e754 >> bitcast<u32>(22i)) | ((_e758 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e762 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e775 = (_e750 & 268435455u);
                                            let _e776 = (_e774 & 268435455u);
                                            let _e779 = ((_e750 >> bitcast<u32>(28u)) & 7u);
                                            let _e787 = ((_e750 >> bitcast<u32>(31i)) | (((_e774 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e788 = (_e779 != 0u);
                                            if (_e779 == 0u) {
                                                phi_3685_ = _e775;
                                            } else {
                                                if (_e779 == 7u) {
                                                    phi_3684_ = 2147483648u;
                                                } else {
                                                    phi_3684_ = ((2147483648u | (_e779 << bitcast<u32>(28u))) | (_e776 & 268435455u));
                                                }
                                                let _e797 = phi_3684_;
                                                phi_3685_ = _e797;
                                            }
                                            let _e799 = phi_3685_;
                                            if _e788 {
                                                let _e800 = (_e779 != 7u);
                                                if _e800 {
                                                    phi_3695_ = (_e776 + _e779);
                                                } else {
                                                    phi_3695_ = u32();
                                                }
                                                let _e803 = phi_3695_;
                                                phi_3697_ = _e803;
                                                phi_3698_ = select(true, false, _e800);
                                            } else {
                                                phi_3697_ = u32();
                                                phi_3698_ = true;
                                            }
                                            let _e806 = phi_3697_;
                                            let _e808 = phi_3698_;
                                            if (_e787 == 0u) {
                                                phi_3719_ = (_e775 + select(0u, 1u, !(_e788)));
                                            } else {
                                                if (_e787 == 7u) {
                                                    phi_3718_ = 2147483648u;
                                                } else {
                                                    phi_3718_ = ((2147483648u | (_e787 << bitcast<u32>(28u))) | (select(_e806, _e776, _e808) & 268435455u));
                                                }
                                                let _e821 = phi_3718_;
                                                phi_3719_ = _e821;
                                            }
                                            let _e823 = phi_3719_;
                                            phi_3723_ = type_54(array<vec4<f32>, 3>(vec4<f32>((_e525.member.member.x + _e651), (_e525.member.member.x + _e673), (_e525.member.member_1.x - _e690), (_e525.member.member_1.x - _e712)), vec4<f32>((_e525.member.member.y + _e660), (_e525.member.member.y + _e677), (_e525.member.member_1.y - _e699), (_e525.member.member_1.y - _e716)), vec4<f32>((_e525.member.member.z + _e669), (_e525.member.member.z + _e681), (_e525.member.member_1.z - _e708), (_e525.member.member_1.z - _e720))), type_51(type_29((_e525.member.member + vec4<f32>(_e651, _e660, _e669, 0f)), (_e525.member.member_1 - vec4<f32>(_e690, _e699, _e708, 0f))), _e799), type_51(type_29((_e525.member.member + vec4<f32>(_e673, _e677, _e681, 0f)), (_e525.member.member_1 - vec4<f32>(_e712, _e716, _e720, 0f))), _e823));
                                        }
                                        let _e828 = phi_3723_;
                                        let _e839 = ((_e828.member[0].x - _e326) * _e331);
                                        let _e840 = ((_e828.member[0].y - _e326) * _e331);
                                        let _e841 = ((_e828.member[0].z - _e327) * _e331);
                                        let _e842 = ((_e828.member[0].w - _e327) * _e331);
                                        let _e852 = ((_e828.member[1].x - _e364) * _e369);
                                        let _e853 = ((_e828.member[1].y - _e364) * _e369);
                                        let _e854 = ((_e828.member[1].z - _e365) * _e369);
                                        let _e855 = ((_e828.member[1].w - _e365) * _e369);
                                        let _e865 = ((_e828.member[2].x - _e402) * _e407);
                                        let _e866 = ((_e828.member[2].y - _e402) * _e407);
                                        let _e867 = ((_e828.member[2].z - _e403) * _e407);
                                        let _e868 = ((_e828.member[2].w - _e403) * _e407);
                                        let _e870 = select(_e867, _e865, (_e865 < _e867));
                                        let _e872 = select(_e868, _e866, (_e866 < _e868));
                                        let _e874 = select(_e867, _e865, (_e865 > _e867));
                                        let _e876 = select(_e868, _e866, (_e866 > _e868));
                                        let _e878 = select(_e841, _e839, (_e839 < _e841));
                                        let _e880 = select(_e842, _e840, (_e840 < _e842));
                                        let _e882 = select(_e854, _e852, (_e852 < _e854));
                                        let _e884 = select(_e855, _e853, (_e853 < _e855));
                                        let _e886 = select(_e882, _e878, (_e878 > _e882));
                                        let _e888 = select(_e884, _e880, (_e880 > _e884));
                                        let _e890 = select(_e870, _e886, (_e886 > _e870));
                                        let _e892 = select(_e872, _e888, (_e888 > _e872));
                                        let _e894 = select(_e841, _e839, (_e839 > _e841));
                                        let _e896 = select(_e842, _e840, (_e840 > _e842));
                                        let _e898 = select(_e854, _e852, (_e852 > _e854));
                                        let _e900 = select(_e855, _e853, (_e853 > _e855));
                                        let _e902 = select(_e898, _e894, (_e894 < _e898));
                                        let _e904 = select(_e900, _e896, (_e896 < _e900));
                                        let _e909 = -(_e870);
                                        let _e910 = -(_e872);
                                        let _e917 = (select(_e874, _e902, (_e902 < _e874)) + (select(_e909, _e874, (_e874 > _e909)) * 0.0000019073523f));
                                        let _e918 = (select(_e876, _e904, (_e904 < _e876)) + (select(_e910, _e876, (_e876 > _e910)) * 0.0000019073523f));
                                        let _e920 = select(_e454, _e890, (_e890 > _e454));
                                        let _e922 = select(_e454, _e892, (_e892 > _e454));
                                        let _e927 = (_e920 <= select(_e497, _e917, (_e917 < _e497)));
                                        let _e928 = (_e922 <= select(_e497, _e918, (_e918 < _e497)));
                                        let _e929 = (_e920 <= _e922);
                                        if _e927 {
                                            if _e928 {
                                                if _e929 {
                                                    phi_4068_ = _e828.member_2;
                                                } else {
                                                    phi_4068_ = _e828.member_1;
                                                }
                                                let _e933 = phi_4068_;
                                                let _e934 = (_e529 % 128u);
                                                let _e935 = (_e934 < 128u);
                                                if _e935 {
                                                } else {
                                                    phi_4687_ = true;
                                                    break;
                                                }
                                                local_4[_e934] = type_51(type_29(_e933.member.member, _e933.member.member_1), _e933.member_1);
                                                if _e935 {
                                                } else {
                                                    phi_4687_ = true;
                                                    break;
                                                }
                                                local_3[_e934] = select(_e922, _e920, (_e920 > _e922));
                                                if _e929 {
                                                    phi_4101_ = _e828.member_1;
                                                } else {
                                                    phi_4101_ = _e828.member_2;
                                                }
                                                let _e950 = phi_4101_;
                                                phi_4102_ = _e950;
                                                phi_4103_ = (_e529 + 1u);
                                            } else {
                                                phi_4102_ = type_51();
                                                phi_4103_ = u32();
                                            }
                                            let _e952 = phi_4102_;
                                            let _e954 = phi_4103_;
                                            phi_4105_ = _e952;
                                            phi_4106_ = _e954;
                                            phi_4107_ = select(true, false, _e928);
                                        } else {
                                            phi_4105_ = type_51();
                                            phi_4106_ = u32();
                                            phi_4107_ = true;
                                        }
                                        let _e957 = phi_4105_;
                                        let _e959 = phi_4106_;
                                        let _e961 = phi_4107_;
                                        if _e961 {
                                            if _e927 {
                                                phi_4116_ = _e828.member_1;
                                            } else {
                                                phi_4116_ = _e828.member_2;
                                            }
                                            let _e965 = phi_4116_;
                                            phi_4121_ = _e965;
                                            phi_4122_ = select(_e928, true, _e927);
                                        } else {
                                            phi_4121_ = _e957;
                                            phi_4122_ = _e527;
                                        }
                                        let _e968 = phi_4121_;
                                        let _e970 = phi_4122_;
                                        phi_4804_ = _e497;
                                        phi_4691_ = _e495;
                                        phi_4124_ = _e968;
                                        phi_4125_ = _e970;
                                        phi_4126_ = select(_e959, _e529, _e961);
                                    }
                                    let _e1442 = phi_4804_;
                                    let _e1444 = phi_4691_;
                                    let _e1446 = phi_4124_;
                                    let _e1448 = phi_4125_;
                                    let _e1450 = phi_4126_;
                                    phi_4803_ = _e1442;
                                    phi_4690_ = _e1444;
                                    phi_4127_ = _e1446;
                                    phi_4128_ = (_e501 - 1u);
                                    phi_4129_ = _e1448;
                                    phi_4130_ = _e1450;
                                } else {
                                    phi_4803_ = _e497;
                                    phi_4690_ = _e495;
                                    phi_4127_ = _e525;
                                    phi_4128_ = _e501;
                                    phi_4129_ = _e527;
                                    phi_4130_ = _e529;
                                }
                                let _e1452 = phi_4803_;
                                let _e1454 = phi_4690_;
                                let _e1456 = phi_4127_;
                                let _e1458 = phi_4128_;
                                let _e1460 = phi_4129_;
                                let _e1462 = phi_4130_;
                                phi_4802_ = _e1452;
                                phi_4689_ = _e1454;
                                phi_4131_ = _e1456;
                                phi_4132_ = _e1458;
                                phi_4133_ = _e1460;
                                phi_4134_ = _e1462;
                            } else {
                                phi_4802_ = _e497;
                                phi_4689_ = _e495;
                                phi_4131_ = type_51();
                                phi_4132_ = u32();
                                phi_4133_ = bool();
                                phi_4134_ = u32();
                            }
                            let _e1464 = phi_4802_;
                            let _e1466 = phi_4689_;
                            let _e1468 = phi_4131_;
                            let _e1470 = phi_4132_;
                            let _e1472 = phi_4133_;
                            let _e1474 = phi_4134_;
                            phi_4801_ = _e1464;
                            phi_4688_ = _e1466;
                            phi_1931_ = _e1468;
                            phi_1934_ = _e1470;
                            phi_1936_ = _e1472;
                            phi_1938_ = _e1474;
                            phi_4135_ = _e509;
                        } else {
                            phi_4801_ = _e497;
                            phi_4688_ = _e495;
                            phi_1931_ = type_51();
                            phi_1934_ = u32();
                            phi_1936_ = bool();
                            phi_1938_ = u32();
                            phi_4135_ = false;
                        }
                        let _e1476 = phi_4801_;
                        let _e1478 = phi_4688_;
                        let _e1480 = phi_1931_;
                        let _e1482 = phi_1934_;
                        let _e1484 = phi_1936_;
                        let _e1486 = phi_1938_;
                        let _e1488 = phi_4135_;
                        continue;
                        continuing {
                            phi_4580_ = _e1478;
                            phi_4493_ = _e1476;
                            phi_1930_ = _e1480;
                            phi_1933_ = _e1482;
                            phi_1935_ = _e1484;
                            phi_1937_ = _e1486;
                            phi_4687_ = _e1478;
                            break if !(_e1488);
                        }
                    }
                    let _e1491 = phi_4687_;
                    if _e1491 {
                        break;
                    }
                    phi_4142_ = type_4(0u, 8u);
                    loop {
                        let _e1493 = phi_4142_;
                        if (_e1493.member < _e1493.member_1) {
                            phi_4143_ = type_4((_e1493.member + 1u), _e1493.member_1);
                            phi_4166_ = type_4(1u, _e1493.member);
                        } else {
                            phi_4143_ = _e1493;
                            phi_4166_ = type_4(0u, type_4().member_1);
                        }
                        let _e1506 = phi_4143_;
                        let _e1508 = phi_4166_;
                        let _e1512 = (bitcast<i32>(_e1508.member) != 0i);
                        if _e1512 {
                            let _e1513 = (_e1508.member_1 < 8u);
                            if _e1513 {
                            } else {
                                phi_4794_ = true;
                                break;
                            }
                            let _e1515 = local_2[_e1508.member_1];
                            if (_e1515.member_3 != 4294967295u) {
                                let _e1521 = -(_e421);
                                let _e1522 = (_e1521 / 3i);
                                let _e1529 = bitcast<f32>((bitcast<u32>((_e1522 + 127i)) << bitcast<u32>(23i)));
                                let _e1537 = (((_e1515.member * _e1529) * _e1529) * bitcast<f32>((bitcast<u32>(((_e1521 - (2i * _e1522)) + 127i)) << bitcast<u32>(23i))));
                                let _e1539 = select(340282350000000000000000000000000000000f, _e1537, (_e1537 < 340282350000000000000000000000000000000f));
                                phi_4232_ = type_25(select(-340282350000000000000000000000000000000f, _e1539, (_e1539 > -340282350000000000000000000000000000000f)), _e1515.member_1, _e1515.member_2, _e1515.member_3);
                            } else {
                                phi_4232_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1544 = phi_4232_;
                            if _e1513 {
                            } else {
                                phi_4794_ = true;
                                break;
                            }
                            local_2[_e1508.member_1] = type_25(_e1544.member, _e1544.member_1, _e1544.member_2, _e1544.member_3);
                        }
                        continue;
                        continuing {
                            phi_4142_ = _e1506;
                            phi_4794_ = _e1491;
                            break if !(_e1512);
                        }
                    }
                    let _e1552 = phi_4794_;
                    if _e1552 {
                        break;
                    }
                    let _e1553 = local_2;
                    if _e142 {
                    } else {
                        break;
                    }
                    global_6.member[_e140] = array<type_25, 8>(type_25(_e1553[0].member, _e1553[0].member_1, _e1553[0].member_2, _e1553[0].member_3), type_25(_e1553[1].member, _e1553[1].member_1, _e1553[1].member_2, _e1553[1].member_3), type_25(_e1553[2].member, _e1553[2].member_1, _e1553[2].member_2, _e1553[2].member_3), type_25(_e1553[3].member, _e1553[3].member_1, _e1553[3].member_2, _e1553[3].member_3), type_25(_e1553[4].member, _e1553[4].member_1, _e1553[4].member_2, _e1553[4].member_3), type_25(_e1553[5].member, _e1553[5].member_1, _e1553[5].member_2, _e1553[5].member_3), type_25(_e1553[6].member, _e1553[6].member_1, _e1553[6].member_2, _e1553[6].member_3), type_25(_e1553[7].member, _e1553[7].member_1, _e1553[7].member_2, _e1553[7].member_3));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_nearest_q10_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
