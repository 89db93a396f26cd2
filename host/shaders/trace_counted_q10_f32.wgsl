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
    member: array<array<u32, 2>>,
}

struct type_29 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_30 {
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
    member: type_29,
    member_1: f32,
}

struct type_42 {
    member: array<type_30>,
}

struct type_44 {
    member: type_37,
    member_1: u32,
    member_2: u32,
}

struct type_46 {
    member: array<vec4<u32>, 2>,
}

struct type_51 {
    member: type_33,
    member_1: u32,
}

struct type_52 {
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
var<storage> global_5: type_42;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_25;

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
    var phi_375_: i32;
    var phi_376_: i32;
    var phi_386_: bool;
    var phi_396_: u32;
    var phi_397_: u32;
    var phi_399_: bool;
    var phi_404_: u32;
    var phi_416_: i32;
    var phi_436_: i32;
    var phi_454_: f32;
    var phi_460_: f32;
    var phi_471_: f32;
    var phi_477_: f32;
    var phi_500_: f32;
    var phi_511_: f32;
    var phi_520_: f32;
    var phi_526_: f32;
    var phi_537_: f32;
    var phi_543_: f32;
    var phi_566_: f32;
    var phi_577_: f32;
    var phi_586_: f32;
    var phi_592_: f32;
    var phi_603_: f32;
    var phi_609_: f32;
    var phi_632_: f32;
    var phi_643_: f32;
    var phi_743_: f32;
    var phi_744_: f32;
    var phi_3144_: bool;
    var phi_834_: type_44;
    var phi_837_: type_51;
    var phi_839_: u32;
    var phi_841_: bool;
    var phi_843_: u32;
    var phi_854_: bool;
    var phi_940_: type_51;
    var phi_941_: bool;
    var phi_942_: u32;
    var phi_2435_: u32;
    var phi_2436_: u32;
    var phi_2446_: u32;
    var phi_2448_: u32;
    var phi_2449_: bool;
    var phi_2469_: u32;
    var phi_2470_: u32;
    var phi_2474_: type_52;
    var phi_2818_: type_51;
    var phi_2895_: type_51;
    var phi_2896_: type_51;
    var phi_2897_: u32;
    var phi_2899_: type_51;
    var phi_2900_: u32;
    var phi_2901_: bool;
    var phi_2910_: type_51;
    var phi_2915_: type_51;
    var phi_2916_: bool;
    var phi_960_: type_44;
    var phi_963_: type_4;
    var phi_964_: type_4;
    var phi_986_: type_4;
    var phi_1010_: u32;
    var phi_1099_: array<array<f32, 3>, 3>;
    var phi_1570_: vec3<f32>;
    var phi_1571_: vec3<f32>;
    var phi_1602_: bool;
    var phi_1611_: vec3<f32>;
    var phi_1651_: type_29;
    var phi_1653_: type_29;
    var phi_1654_: bool;
    var phi_1658_: type_29;
    var phi_1659_: type_29;
    var phi_1660_: type_29;
    var phi_1661_: bool;
    var phi_1665_: type_29;
    var phi_1666_: bool;
    var phi_1670_: type_29;
    var phi_1671_: bool;
    var phi_1675_: type_29;
    var phi_1700_: bool;
    var phi_1701_: bool;
    var phi_1708_: type_44;
    var phi_1709_: type_44;
    var phi_1710_: type_44;
    var phi_961_: type_44;
    var phi_3138_: bool;
    var phi_3256_: bool;
    var phi_2918_: type_44;
    var phi_2919_: type_51;
    var phi_2920_: bool;
    var phi_2921_: u32;
    var phi_3255_: bool;
    var phi_2922_: type_44;
    var phi_2923_: type_51;
    var phi_2924_: u32;
    var phi_2925_: bool;
    var phi_2926_: u32;
    var phi_3254_: bool;
    var phi_2927_: type_44;
    var phi_2928_: type_51;
    var phi_2929_: u32;
    var phi_2930_: bool;
    var phi_2931_: u32;
    var phi_3253_: bool;
    var phi_835_: type_44;
    var phi_838_: type_51;
    var phi_840_: u32;
    var phi_842_: bool;
    var phi_844_: u32;
    var phi_2932_: bool;
    var phi_3252_: bool;
    var local_10: type_44;
    var local_11: type_44;
    var local_12: type_44;

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
                            phi_375_ = (bitcast<i32>((_e219 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_375_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e219)), 32u, (_e219 == 0u))));
                        }
                        let _e233 = phi_375_;
                        phi_376_ = _e233;
                    } else {
                        phi_376_ = 0i;
                    }
                    let _e235 = phi_376_;
                    let _e236 = (_e152 == _e191);
                    if _e236 {
                        phi_386_ = true;
                    } else {
                        phi_386_ = (_e159 == _e191);
                    }
                    let _e239 = phi_386_;
                    let _e240 = select(1u, 0u, _e236);
                    if _e239 {
                        let _e241 = (_e240 + 1u);
                        phi_396_ = _e241;
                        phi_397_ = _e241;
                        phi_399_ = select(true, false, (_e241 == 2u));
                    } else {
                        phi_396_ = u32();
                        phi_397_ = 0u;
                        phi_399_ = true;
                    }
                    let _e245 = phi_396_;
                    let _e247 = phi_397_;
                    let _e249 = phi_399_;
                    if _e249 {
                        phi_404_ = (_e247 + 1u);
                    } else {
                        phi_404_ = 0u;
                    }
                    let _e253 = phi_404_;
                    let _e254 = select(_e245, _e247, _e249);
                    let _e255 = select(_e240, select(2u, _e240, _e239), _e249);
                    if (_e122 < -126i) {
                        phi_416_ = -126i;
                    } else {
                        phi_416_ = select(_e122, 127i, (_e122 > 127i));
                    }
                    let _e260 = phi_416_;
                    let _e265 = bitcast<f32>((bitcast<u32>((_e260 + 127i)) << bitcast<u32>(23i)));
                    let _e271 = bitcast<f32>((bitcast<u32>(((_e122 - _e260) + 127i)) << bitcast<u32>(23i)));
                    let _e272 = -(_e235);
                    if (_e272 < -126i) {
                        phi_436_ = -126i;
                    } else {
                        phi_436_ = select(_e272, 127i, (_e272 > 127i));
                    }
                    let _e277 = phi_436_;
                    let _e282 = bitcast<f32>((bitcast<u32>((_e277 + 127i)) << bitcast<u32>(23i)));
                    let _e288 = bitcast<f32>((bitcast<u32>(((_e272 - _e277) + 127i)) << bitcast<u32>(23i)));
                    let _e292 = global_5.member[_e140].member;
                    let _e293 = (_e254 == 0u);
                    if _e293 {
                        phi_454_ = _e292[0];
                    } else {
                        phi_454_ = _e292[1];
                    }
                    let _e297 = phi_454_;
                    let _e298 = (_e254 == 2u);
                    if _e298 {
                        phi_460_ = _e292[2];
                    } else {
                        phi_460_ = _e297;
                    }
                    let _e301 = phi_460_;
                    let _e303 = ((_e301 * _e265) * _e271);
                    let _e304 = global_5.member[_e140].member_2;
                    if _e293 {
                        phi_471_ = _e304[0];
                    } else {
                        phi_471_ = _e304[1];
                    }
                    let _e308 = phi_471_;
                    if _e298 {
                        phi_477_ = _e304[2];
                    } else {
                        phi_477_ = _e308;
                    }
                    let _e311 = phi_477_;
                    let _e313 = ((_e311 * _e282) * _e288);
                    let _e317 = (bitcast<f32>((bitcast<u32>(_e313) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e317 {
                        let _e321 = (bitcast<f32>((bitcast<u32>(_e303) & 2147483647u)) * 0.00000011920929f);
                        phi_500_ = select(0.00000000000011368684f, _e321, (_e321 > 0.00000000000011368684f));
                    } else {
                        phi_500_ = 0f;
                    }
                    let _e325 = phi_500_;
                    let _e326 = (_e303 + _e325);
                    let _e327 = (_e303 - _e325);
                    let _e328 = select(_e313, 0f, _e317);
                    if _e317 {
                        phi_511_ = 38685626000000000000000000f;
                    } else {
                        phi_511_ = (1f / _e313);
                    }
                    let _e331 = phi_511_;
                    let _e332 = (_e253 == 0u);
                    if _e332 {
                        phi_520_ = _e292[0];
                    } else {
                        phi_520_ = _e292[1];
                    }
                    let _e336 = phi_520_;
                    let _e337 = (_e253 == 2u);
                    if _e337 {
                        phi_526_ = _e292[2];
                    } else {
                        phi_526_ = _e336;
                    }
                    let _e340 = phi_526_;
                    let _e342 = ((_e340 * _e265) * _e271);
                    if _e332 {
                        phi_537_ = _e304[0];
                    } else {
                        phi_537_ = _e304[1];
                    }
                    let _e346 = phi_537_;
                    if _e337 {
                        phi_543_ = _e304[2];
                    } else {
                        phi_543_ = _e346;
                    }
                    let _e349 = phi_543_;
                    let _e351 = ((_e349 * _e282) * _e288);
                    let _e355 = (bitcast<f32>((bitcast<u32>(_e351) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e355 {
                        let _e359 = (bitcast<f32>((bitcast<u32>(_e342) & 2147483647u)) * 0.00000011920929f);
                        phi_566_ = select(0.00000000000011368684f, _e359, (_e359 > 0.00000000000011368684f));
                    } else {
                        phi_566_ = 0f;
                    }
                    let _e363 = phi_566_;
                    let _e364 = (_e342 + _e363);
                    let _e365 = (_e342 - _e363);
                    let _e366 = select(_e351, 0f, _e355);
                    if _e355 {
                        phi_577_ = 38685626000000000000000000f;
                    } else {
                        phi_577_ = (1f / _e351);
                    }
                    let _e369 = phi_577_;
                    let _e370 = (_e255 == 0u);
                    if _e370 {
                        phi_586_ = _e292[0];
                    } else {
                        phi_586_ = _e292[1];
                    }
                    let _e374 = phi_586_;
                    let _e375 = (_e255 == 2u);
                    if _e375 {
                        phi_592_ = _e292[2];
                    } else {
                        phi_592_ = _e374;
                    }
                    let _e378 = phi_592_;
                    let _e380 = ((_e378 * _e265) * _e271);
                    if _e370 {
                        phi_603_ = _e304[0];
                    } else {
                        phi_603_ = _e304[1];
                    }
                    let _e384 = phi_603_;
                    if _e375 {
                        phi_609_ = _e304[2];
                    } else {
                        phi_609_ = _e384;
                    }
                    let _e387 = phi_609_;
                    let _e389 = ((_e387 * _e282) * _e288);
                    let _e393 = (bitcast<f32>((bitcast<u32>(_e389) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e393 {
                        let _e397 = (bitcast<f32>((bitcast<u32>(_e380) & 2147483647u)) * 0.00000011920929f);
                        phi_632_ = select(0.00000000000011368684f, _e397, (_e397 > 0.00000000000011368684f));
                    } else {
                        phi_632_ = 0f;
                    }
                    let _e401 = phi_632_;
                    let _e402 = (_e380 + _e401);
                    let _e403 = (_e380 - _e401);
                    let _e404 = select(_e389, 0f, _e393);
                    if _e393 {
                        phi_643_ = 38685626000000000000000000f;
                    } else {
                        phi_643_ = (1f / _e389);
                    }
                    let _e407 = phi_643_;
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
                        phi_743_ = select(-340282350000000000000000000000000000000f, _e448, (_e448 > -340282350000000000000000000000000000000f));
                        phi_744_ = select(-340282350000000000000000000000000000000f, _e441, (_e441 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_743_ = 0f;
                        phi_744_ = 1f;
                    }
                    let _e452 = phi_743_;
                    let _e454 = phi_744_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e459 = (_e254 % 3u);
                    let _e460 = (_e459 < 3u);
                    if _e460 {
                    } else {
                        break;
                    }
                    let _e462 = local_1[_e459];
                    let _e465 = (_e253 % 3u);
                    let _e466 = (_e465 < 3u);
                    if _e466 {
                    } else {
                        break;
                    }
                    let _e468 = local_1[_e465];
                    let _e471 = (_e255 % 3u);
                    let _e472 = (_e471 < 3u);
                    if _e472 {
                    } else {
                        break;
                    }
                    let _e474 = local_1[_e471];
                    if _e460 {
                    } else {
                        break;
                    }
                    let _e479 = local[_e459];
                    if _e466 {
                    } else {
                        break;
                    }
                    let _e483 = local[_e465];
                    if _e472 {
                    } else {
                        break;
                    }
                    let _e487 = local[_e471];
                    phi_3144_ = false;
                    phi_834_ = type_44(type_37(type_29(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e452), 0u, 0u);
                    phi_837_ = type_51(type_33(vec4<f32>((f32(_e462) * _e134), (f32(_e468) * _e134), (f32(_e474) * _e134), 0f), vec4<f32>((f32(_e479) * _e134), (f32(_e483) * _e134), (f32(_e487) * _e134), 0f)), select(0u, 2147483648u, (_e84 == 0u)));
                    phi_839_ = ((3u * _e84) + 1u);
                    phi_841_ = (_e454 <= _e452);
                    phi_843_ = 0u;
                    loop {
                        let _e497 = phi_3144_;
                        let _e499 = phi_834_;
                        let _e501 = phi_837_;
                        let _e503 = phi_839_;
                        let _e505 = phi_841_;
                        let _e507 = phi_843_;
                        local_10 = _e499;
                        local_11 = _e499;
                        if _e505 {
                            phi_854_ = true;
                        } else {
                            phi_854_ = (_e507 > 0u);
                        }
                        let _e510 = phi_854_;
                        if _e510 {
                            let _e511 = (_e503 > 0u);
                            if _e511 {
                                if _e505 {
                                    phi_940_ = _e501;
                                    phi_941_ = _e505;
                                    phi_942_ = _e507;
                                } else {
                                    let _e512 = (_e507 - 1u);
                                    let _e513 = (_e512 % 128u);
                                    let _e514 = (_e513 < 128u);
                                    if _e514 {
                                    } else {
                                        phi_3252_ = true;
                                        break;
                                    }
                                    let _e516 = local_7[_e513];
                                    if _e514 {
                                    } else {
                                        phi_3252_ = true;
                                        break;
                                    }
                                    let _e518 = local_6[_e513];
                                    if _e514 {
                                    } else {
                                        phi_3252_ = true;
                                        break;
                                    }
                                    let _e520 = local_5[_e513];
                                    if _e514 {
                                    } else {
                                        phi_3252_ = true;
                                        break;
                                    }
                                    let _e522 = local_4[_e513];
                                    if _e514 {
                                    } else {
                                        phi_3252_ = true;
                                        break;
                                    }
                                    let _e524 = local_3[_e513];
                                    if _e514 {
                                    } else {
                                        phi_3252_ = true;
                                        break;
                                    }
                                    let _e526 = local_2[_e513];
                                    if _e514 {
                                    } else {
                                        phi_3252_ = true;
                                        break;
                                    }
                                    let _e531 = local_8[_e513];
                                    if _e514 {
                                    } else {
                                        phi_3252_ = true;
                                        break;
                                    }
                                    let _e534 = local_9[_e513];
                                    phi_940_ = type_51(type_33(vec4<f32>(_e516, _e518, _e520, 0f), vec4<f32>(_e522, _e524, _e526, 0f)), _e531);
                                    phi_941_ = (_e534 <= _e499.member.member_1);
                                    phi_942_ = _e512;
                                }
                                let _e539 = phi_940_;
                                let _e541 = phi_941_;
                                let _e543 = phi_942_;
                                if _e541 {
                                    if ((_e539.member_1 & 2147483648u) != 0u) {
                                        phi_960_ = _e499;
                                        phi_963_ = type_4(0u, ((_e539.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e994 = phi_960_;
                                            let _e996 = phi_963_;
                                            local_12 = _e994;
                                            if (_e996.member < _e996.member_1) {
                                                phi_964_ = type_4((_e996.member + 1u), _e996.member_1);
                                                phi_986_ = type_4(1u, _e996.member);
                                            } else {
                                                phi_964_ = _e996;
                                                phi_986_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1009 = phi_964_;
                                            let _e1011 = phi_986_;
                                            let _e1015 = (bitcast<i32>(_e1011.member) != 0i);
                                            if _e1015 {
                                                let _e1021 = type_44(_e994.member, _e994.member_1, (_e994.member_2 + 1u));
                                                let _e1022 = ((_e539.member_1 & 268435455u) + _e1011.member_1);
                                                let _e1023 = (_e1022 < _e86);
                                                if _e1023 {
                                                    if _e1023 {
                                                    } else {
                                                        phi_3138_ = true;
                                                        break;
                                                    }
                                                    let _e1027 = global_2.member[_e1022].member_1;
                                                    phi_1010_ = _e1027;
                                                } else {
                                                    phi_1010_ = 4294967295u;
                                                }
                                                let _e1029 = phi_1010_;
                                                if (_e1022 >= _e86) {
                                                    phi_1099_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1023 {
                                                    } else {
                                                        phi_3138_ = true;
                                                        break;
                                                    }
                                                    if (_e459 < 9u) {
                                                    } else {
                                                        phi_3138_ = true;
                                                        break;
                                                    }
                                                    let _e1036 = global_2.member[_e1022].member[_e459];
                                                    if (_e465 < 9u) {
                                                    } else {
                                                        phi_3138_ = true;
                                                        break;
                                                    }
                                                    let _e1042 = global_2.member[_e1022].member[_e465];
                                                    if (_e471 < 9u) {
                                                    } else {
                                                        phi_3138_ = true;
                                                        break;
                                                    }
                                                    let _e1048 = global_2.member[_e1022].member[_e471];
                                                    let _e1050 = (3u + _e459);
                                                    if (_e1050 < 9u) {
                                                    } else {
                                                        phi_3138_ = true;
                                                        break;
                                                    }
                                                    let _e1056 = global_2.member[_e1022].member[_e1050];
                                                    let _e1057 = (3u + _e465);
                                                    if (_e1057 < 9u) {
                                                    } else {
                                                        phi_3138_ = true;
                                                        break;
                                                    }
                                                    let _e1063 = global_2.member[_e1022].member[_e1057];
                                                    let _e1064 = (3u + _e471);
                                                    if (_e1064 < 9u) {
                                                    } else {
                                                        phi_3138_ = true;
                                                        break;
                                                    }
                                                    let _e1070 = global_2.member[_e1022].member[_e1064];
                                                    let _e1072 = (6u + _e459);
                                                    if (_e1072 < 9u) {
                                                    } else {
                                                        phi_3138_ = true;
                                                        break;
                                                    }
                                                    let _e1078 = global_2.member[_e1022].member[_e1072];
                                                    let _e1079 = (6u + _e465);
                                                    if (_e1079 < 9u) {
                                                    } else {
                                                        phi_3138_ = true;
                                                        break;
                                                    }
                                                    let _e1085 = global_2.member[_e1022].member[_e1079];
                                                    let _e1086 = (6u + _e471);
                                                    if (_e1086 < 9u) {
                                                    } else {
                                                        phi_3138_ = true;
                                                        break;
                                                    }
                                                    let _e1092 = global_2.member[_e1022].member[_e1086];
                                                    phi_1099_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1036, _e1042, _e1048), array<f32, 3>(_e1056, _e1063, _e1070), array<f32, 3>(_e1078, _e1085, _e1092));
                                                }
                                                let _e1096 = phi_1099_;
                                                let _e1105 = (_e1096[0][2] - _e380);
                                                let _e1108 = (((_e1096[0][0] - _e303) * _e404) - (_e1105 * _e328));
                                                let _e1111 = (((_e1096[0][1] - _e342) * _e404) - (_e1105 * _e366));
                                                let _e1118 = (_e1096[1][2] - _e380);
                                                let _e1121 = (((_e1096[1][0] - _e303) * _e404) - (_e1118 * _e328));
                                                let _e1124 = (((_e1096[1][1] - _e342) * _e404) - (_e1118 * _e366));
                                                let _e1131 = (_e1096[2][2] - _e380);
                                                let _e1134 = (((_e1096[2][0] - _e303) * _e404) - (_e1131 * _e328));
                                                let _e1137 = (((_e1096[2][1] - _e342) * _e404) - (_e1131 * _e366));
                                                let _e1138 = (_e1134 * _e1124);
                                                let _e1139 = (_e1137 * _e1121);
                                                let _e1140 = (_e1108 * _e1137);
                                                let _e1141 = (_e1111 * _e1134);
                                                let _e1142 = (_e1121 * _e1111);
                                                let _e1143 = (_e1124 * _e1108);
                                                let _e1148 = (((_e1138 >= _e1139) && (_e1140 >= _e1141)) && (_e1142 >= _e1143));
                                                if (_e1148 || (((_e1138 <= _e1139) && (_e1140 <= _e1141)) && (_e1142 <= _e1143))) {
                                                    let _e1155 = select(-1f, 1f, _e1148);
                                                    let _e1157 = ((_e1138 - _e1139) * _e1155);
                                                    let _e1159 = select(0f, _e1157, (_e1157 > 0f));
                                                    let _e1161 = ((_e1140 - _e1141) * _e1155);
                                                    let _e1163 = select(0f, _e1161, (_e1161 > 0f));
                                                    let _e1165 = ((_e1142 - _e1143) * _e1155);
                                                    let _e1167 = select(0f, _e1165, (_e1165 > 0f));
                                                    let _e1169 = ((_e1159 + _e1163) + _e1167);
                                                    if (_e1169 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1665_ = type_29();
                                                        phi_1666_ = true;
                                                    } else {
                                                        let _e1172 = select(_e1096[1][0], _e1096[0][0], (_e1096[0][0] < _e1096[1][0]));
                                                        let _e1176 = select(_e1096[1][0], _e1096[0][0], (_e1096[0][0] > _e1096[1][0]));
                                                        let _e1180 = select(_e1096[1][1], _e1096[0][1], (_e1096[0][1] < _e1096[1][1]));
                                                        let _e1184 = select(_e1096[1][1], _e1096[0][1], (_e1096[0][1] > _e1096[1][1]));
                                                        let _e1188 = select(_e1096[1][2], _e1096[0][2], (_e1096[0][2] < _e1096[1][2]));
                                                        let _e1192 = select(_e1096[1][2], _e1096[0][2], (_e1096[0][2] > _e1096[1][2]));
                                                        let _e1197 = ((select(_e1096[2][0], _e1172, (_e1172 < _e1096[2][0])) - _e326) * _e331);
                                                        let _e1198 = ((select(_e1096[2][0], _e1176, (_e1176 > _e1096[2][0])) - _e327) * _e331);
                                                        let _e1201 = ((select(_e1096[2][1], _e1180, (_e1180 < _e1096[2][1])) - _e364) * _e369);
                                                        let _e1202 = ((select(_e1096[2][1], _e1184, (_e1184 > _e1096[2][1])) - _e365) * _e369);
                                                        let _e1205 = ((select(_e1096[2][2], _e1188, (_e1188 < _e1096[2][2])) - _e402) * _e407);
                                                        let _e1206 = ((select(_e1096[2][2], _e1192, (_e1192 > _e1096[2][2])) - _e403) * _e407);
                                                        let _e1208 = select(_e1206, _e1205, (_e1205 < _e1206));
                                                        let _e1210 = select(_e1206, _e1205, (_e1205 > _e1206));
                                                        let _e1212 = select(_e1198, _e1197, (_e1197 < _e1198));
                                                        let _e1214 = select(_e1202, _e1201, (_e1201 < _e1202));
                                                        let _e1216 = select(_e1214, _e1212, (_e1212 > _e1214));
                                                        let _e1218 = select(_e1208, _e1216, (_e1216 > _e1208));
                                                        let _e1220 = select(_e1198, _e1197, (_e1197 > _e1198));
                                                        let _e1222 = select(_e1202, _e1201, (_e1201 > _e1202));
                                                        let _e1224 = select(_e1222, _e1220, (_e1220 < _e1222));
                                                        let _e1226 = select(_e1210, _e1224, (_e1224 < _e1210));
                                                        let _e1227 = -(_e1208);
                                                        let _e1233 = select(_e454, _e1218, (_e1218 > _e454));
                                                        if (_e1233 > (_e1226 + (select(_e1227, _e1210, (_e1210 > _e1227)) * 0.0000019073523f))) {
                                                            phi_1660_ = type_29();
                                                            phi_1661_ = true;
                                                        } else {
                                                            let _e1235 = (_e1233 > _e994.member.member_1);
                                                            if _e1235 {
                                                                phi_1659_ = type_29();
                                                            } else {
                                                                let _e1239 = (_e1096[1][0] - _e1096[0][0]);
                                                                let _e1240 = (_e1096[1][1] - _e1096[0][1]);
                                                                let _e1241 = (_e1096[1][2] - _e1096[0][2]);
                                                                let _e1242 = vec3<f32>(_e1239, _e1240, _e1241);
                                                                let _e1243 = (_e1096[2][0] - _e1096[1][0]);
                                                                let _e1244 = (_e1096[2][1] - _e1096[1][1]);
                                                                let _e1245 = (_e1096[2][2] - _e1096[1][2]);
                                                                let _e1246 = vec3<f32>(_e1243, _e1244, _e1245);
                                                                let _e1247 = (_e1096[0][0] - _e1096[2][0]);
                                                                let _e1248 = (_e1096[0][1] - _e1096[2][1]);
                                                                let _e1249 = (_e1096[0][2] - _e1096[2][2]);
                                                                let _e1250 = vec3<f32>(_e1247, _e1248, _e1249);
                                                                let _e1253 = bitcast<f32>((bitcast<u32>(_e1239) & 2147483647u));
                                                                let _e1256 = bitcast<f32>((bitcast<u32>(_e1240) & 2147483647u));
                                                                let _e1258 = select(_e1256, _e1253, (_e1253 > _e1256));
                                                                let _e1261 = bitcast<f32>((bitcast<u32>(_e1241) & 2147483647u));
                                                                let _e1263 = select(_e1261, _e1258, (_e1258 > _e1261));
                                                                let _e1266 = bitcast<f32>((bitcast<u32>(_e1243) & 2147483647u));
                                                                let _e1269 = bitcast<f32>((bitcast<u32>(_e1244) & 2147483647u));
                                                                let _e1271 = select(_e1269, _e1266, (_e1266 > _e1269));
                                                                let _e1274 = bitcast<f32>((bitcast<u32>(_e1245) & 2147483647u));
                                                                let _e1276 = select(_e1274, _e1271, (_e1271 > _e1274));
                                                                let _e1279 = bitcast<f32>((bitcast<u32>(_e1247) & 2147483647u));
                                                                let _e1282 = bitcast<f32>((bitcast<u32>(_e1248) & 2147483647u));
                                                                let _e1284 = select(_e1282, _e1279, (_e1279 > _e1282));
                                                                let _e1287 = bitcast<f32>((bitcast<u32>(_e1249) & 2147483647u));
                                                                let _e1289 = select(_e1287, _e1284, (_e1284 > _e1287));
                                                                let _e1291 = select(_e1276, _e1263, (_e1263 > _e1276));
                                                                let _e1293 = select(_e1289, _e1291, (_e1291 > _e1289));
                                                                if (_e1263 == _e1293) {
                                                                    phi_1570_ = _e1246;
                                                                    phi_1571_ = _e1250;
                                                                } else {
                                                                    let _e1296 = vec3((_e1276 == _e1293));
                                                                    phi_1570_ = select(_e1242, _e1250, _e1296);
                                                                    phi_1571_ = select(_e1246, _e1242, _e1296);
                                                                }
                                                                let _e1300 = phi_1570_;
                                                                let _e1302 = phi_1571_;
                                                                let _e1309 = ((_e1300.y * _e1302.z) - (_e1302.y * _e1300.z));
                                                                let _e1314 = ((_e1300.z * _e1302.x) - (_e1302.z * _e1300.x));
                                                                let _e1317 = ((_e1300.x * _e1302.y) - (_e1302.x * _e1300.y));
                                                                if (_e1159 >= _e1163) {
                                                                    phi_1602_ = select(true, false, (_e1159 >= _e1167));
                                                                } else {
                                                                    phi_1602_ = true;
                                                                }
                                                                let _e1322 = phi_1602_;
                                                                if _e1322 {
                                                                    phi_1611_ = select(vec3<f32>(_e1096[2][0], _e1096[2][1], _e1096[2][2]), vec3<f32>(_e1096[1][0], _e1096[1][1], _e1096[1][2]), vec3((_e1163 >= _e1167)));
                                                                } else {
                                                                    phi_1611_ = vec3<f32>(_e1096[0][0], _e1096[0][1], _e1096[0][2]);
                                                                }
                                                                let _e1327 = phi_1611_;
                                                                let _e1344 = ((((_e1309 * (_e1327.x - _e303)) + (_e1314 * (_e1327.y - _e342))) + (_e1317 * (_e1327.z - _e380))) / (((_e1309 * _e328) + (_e1314 * _e366)) + (_e1317 * _e404)));
                                                                let _e1346 = select(_e1226, _e1344, (_e1344 < _e1226));
                                                                let _e1348 = select(_e1218, _e1346, (_e1346 > _e1218));
                                                                if (_e1348 >= _e454) {
                                                                    let _e1350 = (_e1348 <= _e994.member.member_1);
                                                                    if _e1350 {
                                                                        let _e1351 = (1f / _e1169);
                                                                        phi_1651_ = type_29(_e1348, (_e1163 * _e1351), (_e1167 * _e1351), _e1029);
                                                                    } else {
                                                                        phi_1651_ = type_29();
                                                                    }
                                                                    let _e1356 = phi_1651_;
                                                                    phi_1653_ = _e1356;
                                                                    phi_1654_ = select(true, false, _e1350);
                                                                } else {
                                                                    phi_1653_ = type_29();
                                                                    phi_1654_ = true;
                                                                }
                                                                let _e1359 = phi_1653_;
                                                                let _e1361 = phi_1654_;
                                                                if _e1361 {
                                                                    phi_1658_ = type_29(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1658_ = _e1359;
                                                                }
                                                                let _e1363 = phi_1658_;
                                                                phi_1659_ = _e1363;
                                                            }
                                                            let _e1365 = phi_1659_;
                                                            phi_1660_ = _e1365;
                                                            phi_1661_ = _e1235;
                                                        }
                                                        let _e1367 = phi_1660_;
                                                        let _e1369 = phi_1661_;
                                                        phi_1665_ = _e1367;
                                                        phi_1666_ = _e1369;
                                                    }
                                                    let _e1371 = phi_1665_;
                                                    let _e1373 = phi_1666_;
                                                    phi_1670_ = _e1371;
                                                    phi_1671_ = _e1373;
                                                } else {
                                                    phi_1670_ = type_29();
                                                    phi_1671_ = true;
                                                }
                                                let _e1375 = phi_1670_;
                                                let _e1377 = phi_1671_;
                                                if _e1377 {
                                                    phi_1675_ = type_29(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1675_ = _e1375;
                                                }
                                                let _e1379 = phi_1675_;
                                                if (_e1379.member_3 != 4294967295u) {
                                                    if (_e1029 != 4294967295u) {
                                                        if (_e1379.member < _e994.member.member.member) {
                                                            phi_1701_ = true;
                                                        } else {
                                                            if (_e1379.member == _e994.member.member.member) {
                                                                phi_1700_ = (_e1379.member_3 < _e994.member.member.member_3);
                                                            } else {
                                                                phi_1700_ = false;
                                                            }
                                                            let _e1394 = phi_1700_;
                                                            phi_1701_ = _e1394;
                                                        }
                                                        let _e1396 = phi_1701_;
                                                        if _e1396 {
                                                            phi_1708_ = type_44(type_37(_e1379, _e1379.member), _e1021.member_1, _e1021.member_2);
                                                        } else {
                                                            phi_1708_ = _e1021;
                                                        }
                                                        let _e1403 = phi_1708_;
                                                        phi_1709_ = _e1403;
                                                    } else {
                                                        phi_1709_ = _e1021;
                                                    }
                                                    let _e1405 = phi_1709_;
                                                    phi_1710_ = _e1405;
                                                } else {
                                                    phi_1710_ = _e1021;
                                                }
                                                let _e1407 = phi_1710_;
                                                phi_961_ = _e1407;
                                            } else {
                                                phi_961_ = type_44();
                                            }
                                            let _e1409 = phi_961_;
                                            continue;
                                            continuing {
                                                phi_960_ = _e1409;
                                                phi_963_ = _e1009;
                                                phi_3138_ = _e497;
                                                break if !(_e1015);
                                            }
                                        }
                                        let _e1412 = phi_3138_;
                                        phi_3252_ = _e1412;
                                        if _e1412 {
                                            break;
                                        }
                                        phi_3256_ = _e1412;
                                        let _e1565 = local_12;
                                        phi_2918_ = _e1565;
                                        phi_2919_ = _e539;
                                        phi_2920_ = false;
                                        phi_2921_ = _e543;
                                    } else {
                                        if (_e539.member_1 >= _e84) {
                                            phi_2474_ = type_52(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_51(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e539.member_1 < _e84) {
                                            } else {
                                                phi_3252_ = true;
                                                break;
                                            }
                                            let _e561 = ((1u + _e254) % 4u);
                                            if (_e561 < 4u) {
                                            } else {
                                                phi_3252_ = true;
                                                break;
                                            }
                                            let _e566 = global_4.member[_e539.member_1][_e561];
                                            let _e568 = (_e566 >> bitcast<u32>(11u));
                                            let _e570 = ((1u + _e253) % 4u);
                                            if (_e570 < 4u) {
                                            } else {
                                                phi_3252_ = true;
                                                break;
                                            }
                                            let _e575 = global_4.member[_e539.member_1][_e570];
                                            let _e577 = (_e575 >> bitcast<u32>(11u));
                                            let _e579 = ((1u + _e255) % 4u);
                                            if (_e579 < 4u) {
                                            } else {
                                                phi_3252_ = true;
                                                break;
                                            }
                                            let _e584 = global_4.member[_e539.member_1][_e579];
                                            let _e586 = (_e584 >> bitcast<u32>(11u));
                                            let _e609 = (bitcast<f32>((bitcast<u32>((_e539.member.member_1.x - _e539.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e610 = (bitcast<f32>((bitcast<u32>((_e539.member.member_1.y - _e539.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e611 = (bitcast<f32>((bitcast<u32>((_e539.member.member_1.z - _e539.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e613 = select(_e134, _e609, (_e609 > _e134));
                                            let _e615 = select(_e134, _e610, (_e610 > _e134));
                                            let _e617 = select(_e134, _e611, (_e611 > _e134));
                                            let _e642 = bitcast<u32>((f32(bitcast<i32>((_e566 & 1023u))) * _e613));
                                            let _e647 = (bitcast<i32>((_e566 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e650 = bitcast<f32>((_e642 & bitcast<u32>(_e647)));
                                            let _e651 = bitcast<u32>((f32(bitcast<i32>((_e575 & 1023u))) * _e615));
                                            let _e656 = (bitcast<i32>((_e575 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e659 = bitcast<f32>((_e651 & bitcast<u32>(_e656)));
                                            let _e660 = bitcast<u32>((f32(bitcast<i32>((_e584 & 1023u))) * _e617));
                                            let _e665 = (bitcast<i32>((_e584 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e668 = bitcast<f32>((_e660 & bitcast<u32>(_e665)));
                                            let _e672 = bitcast<f32>((_e642 & bitcast<u32>(~(_e647))));
                                            let _e676 = bitcast<f32>((_e651 & bitcast<u32>(~(_e656))));
                                            let _e680 = bitcast<f32>((_e660 & bitcast<u32>(~(_e665))));
                                            let _e681 = bitcast<u32>((f32(bitcast<i32>((_e568 & 1023u))) * _e613));
                                            let _e686 = (bitcast<i32>((_e568 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e689 = bitcast<f32>((_e681 & bitcast<u32>(_e686)));
                                            let _e690 = bitcast<u32>((f32(bitcast<i32>((_e577 & 1023u))) * _e615));
                                            let _e695 = (bitcast<i32>((_e577 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e698 = bitcast<f32>((_e690 & bitcast<u32>(_e695)));
                                            let _e699 = bitcast<u32>((f32(bitcast<i32>((_e586 & 1023u))) * _e617));
                                            let _e704 = (bitcast<i32>((_e586 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e707 = bitcast<f32>((_e699 & bitcast<u32>(_e704)));
                                            let _e711 = bitcast<f32>((_e681 & bitcast<u32>(~(_e686))));
                                            let _e715 = bitcast<f32>((_e690 & bitcast<u32>(~(_e695))));
                                            let _e719 = bitcast<f32>((_e699 & bitcast<u32>(~(_e704))));
                                            let _e749 = global_4.member[_e539.member_1][0u];
                                            let _e753 = global_4.member[_e539.member_1][1u];
                                            let _e757 = global_4.member[_e539.member_1][2u];
                                            let _e761 = global_4.member[_e539.member_1][3u];
                                            let _e773 = (((_e753 >> bitcast<u32>(22i)) | ((_e757 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e761 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e774 = (_e749 & 268435455u);
                                            let _e775 = (_e773 & 268435455u);
                                            let _e778 = ((_e749 >> bitcast<u32>(28u)) & 7u);
                                            let _e786 = ((_e749 >> bitcast<u32>(31i)) | (((_e773 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e787 = (_e778 != 0u);
                                            if (_e778 == 0u) {
                                                phi_2436_ = _e774;
                                            } else {
                                                if (_e778 == 7u) {
                                                    phi_2435_ = 2147483648u;
                                                } else {
                                                    phi_2435_ = ((2147483648u | (_e778 << bitcast<u32>(28u))) | (_e775 & 268435455u));
                                                }
                                                let _e796 = phi_2435_;
                                                phi_2436_ = _e796;
                                            }
                                            let _e798 = phi_2436_;
                                            if _e787 {
                                                let _e799 = (_e778 != 7u);
                                                if _e799 {
                                                    phi_2446_ = (_e775 + _e778);
                                                } else {
                                                    phi_2446_ = u32();
                                                }
                                                let _e802 = phi_2446_;
                                                phi_2448_ = _e802;
                                                phi_2449_ = select(true, false, _e799);
                                            } else {
                                                phi_2448_ = u32();
                                                phi_2449_ = true;
                                            }
                                            let _e805 = phi_2448_;
                                            let _e807 = phi_2449_;
                                            if (_e786 == 0u) {
                                                phi_2470_ = (_e774 + select(0u, 1u, !(_e787)));
                                            } else {
                                                if (_e786 == 7u) {
                                                    phi_2469_ = 2147483648u;
                                                } else {
                                                    phi_2469_ = ((2147483648u | (_e786 << bitcast<u32>(28u))) | (select(_e805, _e775, _e807) & 268435455u));
                                                }
                                                let _e820 = phi_2469_;
                                                phi_2470_ = _e820;
                                            }
                                            let _e822 = phi_2470_;
                                            phi_2474_ = type_52(array<vec4<f32>, 3>(vec4<f32>((_e539.member.member.x + _e650), (_e539.member.member.x + _e672), (_e539.member.member_1.x - _e689), (_e539.member.member_1.x - _e711)), vec4<f32>((_e539.member.member.y + _e659), (_e539.member.member.y + _e676), (_e539.member.member_1.y - _e698), (_e539.member.member_1.y - _e715)), vec4<f32>((_e539.member.member.z + _e668), (_e539.member.member.z + _e680), (_e539.member.member_1.z - _e707), (_e539.member.member_1.z - _e719))), type_51(type_33((_e539.member.member + vec4<f32>(_e650, _e659, _e668, 0f)), (_e539.member.member_1 - vec4<f32>(_e689, _e698, _e707, 0f))), _e798), type_51(type_33((_e539.member.member + vec4<f32>(_e672, _e676, _e680, 0f)), (_e539.member.member_1 - vec4<f32>(_e711, _e715, _e719, 0f))), _e822));
                                        }
                                        let _e827 = phi_2474_;
                                        let _e840 = ((_e827.member[0].x - _e326) * _e331);
                                        let _e841 = ((_e827.member[0].y - _e326) * _e331);
                                        let _e842 = ((_e827.member[0].z - _e327) * _e331);
                                        let _e843 = ((_e827.member[0].w - _e327) * _e331);
                                        let _e853 = ((_e827.member[1].x - _e364) * _e369);
                                        let _e854 = ((_e827.member[1].y - _e364) * _e369);
                                        let _e855 = ((_e827.member[1].z - _e365) * _e369);
                                        let _e856 = ((_e827.member[1].w - _e365) * _e369);
                                        let _e866 = ((_e827.member[2].x - _e402) * _e407);
                                        let _e867 = ((_e827.member[2].y - _e402) * _e407);
                                        let _e868 = ((_e827.member[2].z - _e403) * _e407);
                                        let _e869 = ((_e827.member[2].w - _e403) * _e407);
                                        let _e871 = select(_e868, _e866, (_e866 < _e868));
                                        let _e873 = select(_e869, _e867, (_e867 < _e869));
                                        let _e875 = select(_e868, _e866, (_e866 > _e868));
                                        let _e877 = select(_e869, _e867, (_e867 > _e869));
                                        let _e879 = select(_e842, _e840, (_e840 < _e842));
                                        let _e881 = select(_e843, _e841, (_e841 < _e843));
                                        let _e883 = select(_e855, _e853, (_e853 < _e855));
                                        let _e885 = select(_e856, _e854, (_e854 < _e856));
                                        let _e887 = select(_e883, _e879, (_e879 > _e883));
                                        let _e889 = select(_e885, _e881, (_e881 > _e885));
                                        let _e891 = select(_e871, _e887, (_e887 > _e871));
                                        let _e893 = select(_e873, _e889, (_e889 > _e873));
                                        let _e895 = select(_e842, _e840, (_e840 > _e842));
                                        let _e897 = select(_e843, _e841, (_e841 > _e843));
                                        let _e899 = select(_e855, _e853, (_e853 > _e855));
                                        let _e901 = select(_e856, _e854, (_e854 > _e856));
                                        let _e903 = select(_e899, _e895, (_e895 < _e899));
                                        let _e905 = select(_e901, _e897, (_e897 < _e901));
                                        let _e910 = -(_e871);
                                        let _e911 = -(_e873);
                                        let _e918 = (select(_e875, _e903, (_e903 < _e875)) + (select(_e910, _e875, (_e875 > _e910)) * 0.0000019073523f));
                                        let _e919 = (select(_e877, _e905, (_e905 < _e877)) + (select(_e911, _e877, (_e877 > _e911)) * 0.0000019073523f));
                                        let _e921 = select(_e454, _e891, (_e891 > _e454));
                                        let _e923 = select(_e454, _e893, (_e893 > _e454));
                                        let _e928 = (_e921 <= select(_e499.member.member_1, _e918, (_e918 < _e499.member.member_1)));
                                        let _e929 = (_e923 <= select(_e499.member.member_1, _e919, (_e919 < _e499.member.member_1)));
                                        let _e930 = (_e921 <= _e923);
                                        if _e928 {
                                            if _e929 {
                                                if _e930 {
                                                    phi_2818_ = _e827.member_2;
                                                } else {
                                                    phi_2818_ = _e827.member_1;
                                                }
                                                let _e934 = phi_2818_;
                                                let _e956 = (_e543 % 128u);
                                                let _e957 = (_e956 < 128u);
                                                if _e957 {
                                                } else {
                                                    phi_3252_ = true;
                                                    break;
                                                }
                                                local_8[_e956] = _e934.member_1;
                                                if _e957 {
                                                } else {
                                                    phi_3252_ = true;
                                                    break;
                                                }
                                                local_7[_e956] = _e934.member.member.x;
                                                if _e957 {
                                                } else {
                                                    phi_3252_ = true;
                                                    break;
                                                }
                                                local_6[_e956] = _e934.member.member.y;
                                                if _e957 {
                                                } else {
                                                    phi_3252_ = true;
                                                    break;
                                                }
                                                local_5[_e956] = _e934.member.member.z;
                                                if _e957 {
                                                } else {
                                                    phi_3252_ = true;
                                                    break;
                                                }
                                                local_4[_e956] = _e934.member.member_1.x;
                                                if _e957 {
                                                } else {
                                                    phi_3252_ = true;
                                                    break;
                                                }
                                                local_3[_e956] = _e934.member.member_1.y;
                                                if _e957 {
                                                } else {
                                                    phi_3252_ = true;
                                                    break;
                                                }
                                                local_2[_e956] = _e934.member.member_1.z;
                                                if _e957 {
                                                } else {
                                                    phi_3252_ = true;
                                                    break;
                                                }
                                                local_9[_e956] = select(_e923, _e921, (_e921 > _e923));
                                                if _e930 {
                                                    phi_2895_ = _e827.member_1;
                                                } else {
                                                    phi_2895_ = _e827.member_2;
                                                }
                                                let _e970 = phi_2895_;
                                                phi_2896_ = _e970;
                                                phi_2897_ = (_e543 + 1u);
                                            } else {
                                                phi_2896_ = type_51();
                                                phi_2897_ = u32();
                                            }
                                            let _e972 = phi_2896_;
                                            let _e974 = phi_2897_;
                                            phi_2899_ = _e972;
                                            phi_2900_ = _e974;
                                            phi_2901_ = select(true, false, _e929);
                                        } else {
                                            phi_2899_ = type_51();
                                            phi_2900_ = u32();
                                            phi_2901_ = true;
                                        }
                                        let _e977 = phi_2899_;
                                        let _e979 = phi_2900_;
                                        let _e981 = phi_2901_;
                                        if _e981 {
                                            if _e928 {
                                                phi_2910_ = _e827.member_1;
                                            } else {
                                                phi_2910_ = _e827.member_2;
                                            }
                                            let _e985 = phi_2910_;
                                            phi_2915_ = _e985;
                                            phi_2916_ = select(_e929, true, _e928);
                                        } else {
                                            phi_2915_ = _e977;
                                            phi_2916_ = _e541;
                                        }
                                        let _e988 = phi_2915_;
                                        let _e990 = phi_2916_;
                                        phi_3256_ = _e497;
                                        phi_2918_ = type_44(_e499.member, (_e499.member_1 + 1u), _e499.member_2);
                                        phi_2919_ = _e988;
                                        phi_2920_ = _e990;
                                        phi_2921_ = select(_e979, _e543, _e981);
                                    }
                                    let _e1414 = phi_3256_;
                                    let _e1416 = phi_2918_;
                                    let _e1418 = phi_2919_;
                                    let _e1420 = phi_2920_;
                                    let _e1422 = phi_2921_;
                                    phi_3255_ = _e1414;
                                    phi_2922_ = _e1416;
                                    phi_2923_ = _e1418;
                                    phi_2924_ = (_e503 - 1u);
                                    phi_2925_ = _e1420;
                                    phi_2926_ = _e1422;
                                } else {
                                    phi_3255_ = _e497;
                                    phi_2922_ = _e499;
                                    phi_2923_ = _e539;
                                    phi_2924_ = _e503;
                                    phi_2925_ = _e541;
                                    phi_2926_ = _e543;
                                }
                                let _e1424 = phi_3255_;
                                let _e1426 = phi_2922_;
                                let _e1428 = phi_2923_;
                                let _e1430 = phi_2924_;
                                let _e1432 = phi_2925_;
                                let _e1434 = phi_2926_;
                                phi_3254_ = _e1424;
                                phi_2927_ = _e1426;
                                phi_2928_ = _e1428;
                                phi_2929_ = _e1430;
                                phi_2930_ = _e1432;
                                phi_2931_ = _e1434;
                            } else {
                                phi_3254_ = _e497;
                                phi_2927_ = type_44();
                                phi_2928_ = type_51();
                                phi_2929_ = u32();
                                phi_2930_ = bool();
                                phi_2931_ = u32();
                            }
                            let _e1436 = phi_3254_;
                            let _e1438 = phi_2927_;
                            let _e1440 = phi_2928_;
                            let _e1442 = phi_2929_;
                            let _e1444 = phi_2930_;
                            let _e1446 = phi_2931_;
                            phi_3253_ = _e1436;
                            phi_835_ = _e1438;
                            phi_838_ = _e1440;
                            phi_840_ = _e1442;
                            phi_842_ = _e1444;
                            phi_844_ = _e1446;
                            phi_2932_ = _e511;
                        } else {
                            phi_3253_ = _e497;
                            phi_835_ = type_44();
                            phi_838_ = type_51();
                            phi_840_ = u32();
                            phi_842_ = bool();
                            phi_844_ = u32();
                            phi_2932_ = false;
                        }
                        let _e1448 = phi_3253_;
                        let _e1450 = phi_835_;
                        let _e1452 = phi_838_;
                        let _e1454 = phi_840_;
                        let _e1456 = phi_842_;
                        let _e1458 = phi_844_;
                        let _e1460 = phi_2932_;
                        continue;
                        continuing {
                            phi_3144_ = _e1448;
                            phi_834_ = _e1450;
                            phi_837_ = _e1452;
                            phi_839_ = _e1454;
                            phi_841_ = _e1456;
                            phi_843_ = _e1458;
                            phi_3252_ = _e1448;
                            break if !(_e1460);
                        }
                    }
                    let _e1463 = phi_3252_;
                    if _e1463 {
                        break;
                    }
                    let _e1465 = local_10;
                    let _e1468 = local_11;
                    if _e142 {
                    } else {
                        break;
                    }
                    global_6.member[_e140][0u] = _e1465.member_1;
                    global_6.member[_e140][1u] = _e1468.member_2;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_counted_q10_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
