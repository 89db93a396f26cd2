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
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_22 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_25 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_33 {
    member: array<type_22>,
}

struct type_37 {
    member: array<array<type_21, 8>>,
}

struct type_43 {
    member: array<vec4<u32>, 2>,
}

struct type_50 {
    member: array<array<u32, 7>>,
}

struct type_52 {
    member: type_25,
    member_1: u32,
}

struct type_53 {
    member: array<vec4<f32>, 3>,
    member_1: type_52,
    member_2: type_52,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(3) 
var<storage> global_2: type_15;
@group(0) @binding(1) 
var<uniform> global_3: type_43;
@group(0) @binding(4) 
var<storage> global_4: type_33;
@group(0) @binding(2) 
var<storage> global_5: type_50;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_37;

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
    var local_9: array<type_21, 8>;
    var local_10: array<f32, 128>;
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
    var phi_3656_: bool;
    var phi_3569_: f32;
    var phi_899_: type_52;
    var phi_902_: u32;
    var phi_904_: bool;
    var phi_906_: u32;
    var phi_917_: bool;
    var phi_1004_: type_52;
    var phi_1005_: bool;
    var phi_1006_: u32;
    var phi_2702_: u32;
    var phi_2703_: u32;
    var phi_2713_: u32;
    var phi_2715_: u32;
    var phi_2716_: bool;
    var phi_2736_: u32;
    var phi_2737_: u32;
    var phi_2741_: type_53;
    var phi_3086_: type_52;
    var phi_3163_: type_52;
    var phi_3164_: type_52;
    var phi_3165_: u32;
    var phi_3167_: type_52;
    var phi_3168_: u32;
    var phi_3169_: bool;
    var phi_3178_: type_52;
    var phi_3183_: type_52;
    var phi_3184_: bool;
    var phi_3653_: bool;
    var phi_3643_: f32;
    var phi_1024_: type_4;
    var phi_1025_: type_4;
    var phi_1048_: type_4;
    var phi_1069_: u32;
    var phi_1158_: array<array<f32, 3>, 3>;
    var phi_1630_: vec3<f32>;
    var phi_1631_: vec3<f32>;
    var phi_1662_: bool;
    var phi_1671_: vec3<f32>;
    var phi_1711_: type_21;
    var phi_1713_: type_21;
    var phi_1714_: bool;
    var phi_1718_: type_21;
    var phi_1719_: type_21;
    var phi_1720_: type_21;
    var phi_1721_: bool;
    var phi_1725_: type_21;
    var phi_1726_: bool;
    var phi_1730_: type_21;
    var phi_1731_: bool;
    var phi_1735_: type_21;
    var phi_1747_: type_4;
    var phi_1750_: type_21;
    var phi_1748_: type_4;
    var phi_1773_: type_4;
    var phi_1805_: bool;
    var phi_1806_: bool;
    var phi_1827_: type_21;
    var phi_1751_: type_21;
    var phi_3644_: bool;
    var phi_3978_: f32;
    var phi_3977_: f32;
    var phi_3761_: bool;
    var phi_3976_: f32;
    var phi_3760_: bool;
    var phi_3975_: f32;
    var phi_3759_: bool;
    var phi_3915_: f32;
    var phi_3758_: bool;
    var phi_3880_: f32;
    var phi_3767_: bool;
    var phi_3186_: type_52;
    var phi_3187_: bool;
    var phi_3188_: u32;
    var phi_3879_: f32;
    var phi_3766_: bool;
    var phi_3189_: type_52;
    var phi_3190_: u32;
    var phi_3191_: bool;
    var phi_3192_: u32;
    var phi_3878_: f32;
    var phi_3765_: bool;
    var phi_3193_: type_52;
    var phi_3194_: u32;
    var phi_3195_: bool;
    var phi_3196_: u32;
    var phi_3877_: f32;
    var phi_3764_: bool;
    var phi_900_: type_52;
    var phi_903_: u32;
    var phi_905_: bool;
    var phi_907_: u32;
    var phi_3197_: bool;
    var phi_3763_: bool;
    var phi_3204_: type_4;
    var phi_3205_: type_4;
    var phi_3228_: type_4;
    var phi_3294_: type_21;
    var phi_3870_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e85 = global;
            let _e87 = arrayLength((&global_5.member));
            let _e89 = arrayLength((&global_2.member));
            let _e97 = global_3.member[0u][0u];
            let _e101 = global_3.member[0u][1u];
            let _e105 = global_3.member[0u][2u];
            let _e109 = global_3.member[0u][3u];
            let _e113 = global_3.member[1u][0u];
            let _e117 = global_3.member[1u][1u];
            let _e121 = global_3.member[1u][2u];
            let _e124 = global_1.member[0u];
            let _e125 = bitcast<i32>(_e124);
            let _e137 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e109) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e97), bitcast<i32>(_e101), bitcast<i32>(_e105));
            local = array<i32, 3>(bitcast<i32>(_e113), bitcast<i32>(_e117), bitcast<i32>(_e121));
            let _e143 = (_e85.x + (_e85.y * 2097152u));
            let _e144 = (_e143 < arrayLength((&global_4.member)));
            if _e144 {
                let _e145 = (_e143 < arrayLength((&global_6.member)));
                if _e145 {
                    if _e144 {
                    } else {
                        break;
                    }
                    let _e153 = global_4.member[_e143].member_2[0u];
                    let _e155 = (bitcast<u32>(_e153) & 2147483647u);
                    let _e160 = global_4.member[_e143].member_2[1u];
                    let _e162 = (bitcast<u32>(_e160) & 2147483647u);
                    let _e167 = global_4.member[_e143].member_2[2u];
                    let _e169 = (bitcast<u32>(_e167) & 2147483647u);
                    let _e174 = global_4.member[_e143].member[0u];
                    let _e176 = (bitcast<u32>(_e174) & 2147483647u);
                    let _e181 = global_4.member[_e143].member[1u];
                    let _e183 = (bitcast<u32>(_e181) & 2147483647u);
                    let _e188 = global_4.member[_e143].member[2u];
                    let _e190 = (bitcast<u32>(_e188) & 2147483647u);
                    let _e192 = select(_e162, _e155, (_e162 < _e155));
                    let _e194 = select(_e169, _e192, (_e169 < _e192));
                    let _e196 = select(_e176, _e194, (_e176 < _e194));
                    let _e198 = select(_e183, _e196, (_e183 < _e196));
                    let _e200 = select(_e190, _e198, (_e190 < _e198));
                    let _e204 = global_4.member[_e143].member_1;
                    let _e206 = (bitcast<u32>(_e204) & 2147483647u);
                    let _e213 = global_4.member[_e143].member_3;
                    let _e219 = (((select(_e206, _e200, (_e206 < _e200)) < 2139095040u) && ((bitcast<u32>(_e213) & 2147483647u) <= 2139095040u)) && (_e194 > 0u));
                    if _e219 {
                        let _e222 = (bitcast<u32>(bitcast<f32>(_e194)) & 2147483647u);
                        if (_e222 >= 8388608u) {
                            phi_387_ = (bitcast<i32>((_e222 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_387_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e222)), 32u, (_e222 == 0u))));
                        }
                        let _e236 = phi_387_;
                        phi_388_ = _e236;
                    } else {
                        phi_388_ = 0i;
                    }
                    let _e238 = phi_388_;
                    let _e239 = (_e155 == _e194);
                    if _e239 {
                        phi_398_ = true;
                    } else {
                        phi_398_ = (_e162 == _e194);
                    }
                    let _e242 = phi_398_;
                    let _e243 = select(1u, 0u, _e239);
                    if _e242 {
                        let _e244 = (_e243 + 1u);
                        phi_408_ = _e244;
                        phi_409_ = _e244;
                        phi_411_ = select(true, false, (_e244 == 2u));
                    } else {
                        phi_408_ = u32();
                        phi_409_ = 0u;
                        phi_411_ = true;
                    }
                    let _e248 = phi_408_;
                    let _e250 = phi_409_;
                    let _e252 = phi_411_;
                    if _e252 {
                        phi_416_ = (_e250 + 1u);
                    } else {
                        phi_416_ = 0u;
                    }
                    let _e256 = phi_416_;
                    let _e257 = select(_e248, _e250, _e252);
                    let _e258 = select(_e243, select(2u, _e243, _e242), _e252);
                    if (_e125 < -126i) {
                        phi_429_ = -126i;
                    } else {
                        phi_429_ = select(_e125, 127i, (_e125 > 127i));
                    }
                    let _e263 = phi_429_;
                    let _e268 = bitcast<f32>((bitcast<u32>((_e263 + 127i)) << bitcast<u32>(23i)));
                    let _e274 = bitcast<f32>((bitcast<u32>(((_e125 - _e263) + 127i)) << bitcast<u32>(23i)));
                    let _e275 = -(_e238);
                    if (_e275 < -126i) {
                        phi_449_ = -126i;
                    } else {
                        phi_449_ = select(_e275, 127i, (_e275 > 127i));
                    }
                    let _e280 = phi_449_;
                    let _e285 = bitcast<f32>((bitcast<u32>((_e280 + 127i)) << bitcast<u32>(23i)));
                    let _e291 = bitcast<f32>((bitcast<u32>(((_e275 - _e280) + 127i)) << bitcast<u32>(23i)));
                    let _e295 = global_4.member[_e143].member;
                    let _e296 = (_e257 == 0u);
                    if _e296 {
                        phi_467_ = _e295[0];
                    } else {
                        phi_467_ = _e295[1];
                    }
                    let _e300 = phi_467_;
                    let _e301 = (_e257 == 2u);
                    if _e301 {
                        phi_473_ = _e295[2];
                    } else {
                        phi_473_ = _e300;
                    }
                    let _e304 = phi_473_;
                    let _e306 = ((_e304 * _e268) * _e274);
                    let _e307 = global_4.member[_e143].member_2;
                    if _e296 {
                        phi_484_ = _e307[0];
                    } else {
                        phi_484_ = _e307[1];
                    }
                    let _e311 = phi_484_;
                    if _e301 {
                        phi_490_ = _e307[2];
                    } else {
                        phi_490_ = _e311;
                    }
                    let _e314 = phi_490_;
                    let _e316 = ((_e314 * _e285) * _e291);
                    let _e320 = (bitcast<f32>((bitcast<u32>(_e316) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e320 {
                        let _e324 = (bitcast<f32>((bitcast<u32>(_e306) & 2147483647u)) * 0.00000011920929f);
                        phi_513_ = select(0.00000000000011368684f, _e324, (_e324 > 0.00000000000011368684f));
                    } else {
                        phi_513_ = 0f;
                    }
                    let _e328 = phi_513_;
                    let _e329 = (_e306 + _e328);
                    let _e330 = (_e306 - _e328);
                    let _e331 = select(_e316, 0f, _e320);
                    if _e320 {
                        phi_524_ = 38685626000000000000000000f;
                    } else {
                        phi_524_ = (1f / _e316);
                    }
                    let _e334 = phi_524_;
                    let _e335 = (_e256 == 0u);
                    if _e335 {
                        phi_533_ = _e295[0];
                    } else {
                        phi_533_ = _e295[1];
                    }
                    let _e339 = phi_533_;
                    let _e340 = (_e256 == 2u);
                    if _e340 {
                        phi_539_ = _e295[2];
                    } else {
                        phi_539_ = _e339;
                    }
                    let _e343 = phi_539_;
                    let _e345 = ((_e343 * _e268) * _e274);
                    if _e335 {
                        phi_550_ = _e307[0];
                    } else {
                        phi_550_ = _e307[1];
                    }
                    let _e349 = phi_550_;
                    if _e340 {
                        phi_556_ = _e307[2];
                    } else {
                        phi_556_ = _e349;
                    }
                    let _e352 = phi_556_;
                    let _e354 = ((_e352 * _e285) * _e291);
                    let _e358 = (bitcast<f32>((bitcast<u32>(_e354) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e358 {
                        let _e362 = (bitcast<f32>((bitcast<u32>(_e345) & 2147483647u)) * 0.00000011920929f);
                        phi_579_ = select(0.00000000000011368684f, _e362, (_e362 > 0.00000000000011368684f));
                    } else {
                        phi_579_ = 0f;
                    }
                    let _e366 = phi_579_;
                    let _e367 = (_e345 + _e366);
                    let _e368 = (_e345 - _e366);
                    let _e369 = select(_e354, 0f, _e358);
                    if _e358 {
                        phi_590_ = 38685626000000000000000000f;
                    } else {
                        phi_590_ = (1f / _e354);
                    }
                    let _e372 = phi_590_;
                    let _e373 = (_e258 == 0u);
                    if _e373 {
                        phi_599_ = _e295[0];
                    } else {
                        phi_599_ = _e295[1];
                    }
                    let _e377 = phi_599_;
                    let _e378 = (_e258 == 2u);
                    if _e378 {
                        phi_605_ = _e295[2];
                    } else {
                        phi_605_ = _e377;
                    }
                    let _e381 = phi_605_;
                    let _e383 = ((_e381 * _e268) * _e274);
                    if _e373 {
                        phi_616_ = _e307[0];
                    } else {
                        phi_616_ = _e307[1];
                    }
                    let _e387 = phi_616_;
                    if _e378 {
                        phi_622_ = _e307[2];
                    } else {
                        phi_622_ = _e387;
                    }
                    let _e390 = phi_622_;
                    let _e392 = ((_e390 * _e285) * _e291);
                    let _e396 = (bitcast<f32>((bitcast<u32>(_e392) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e396 {
                        let _e400 = (bitcast<f32>((bitcast<u32>(_e383) & 2147483647u)) * 0.00000011920929f);
                        phi_645_ = select(0.00000000000011368684f, _e400, (_e400 > 0.00000000000011368684f));
                    } else {
                        phi_645_ = 0f;
                    }
                    let _e404 = phi_645_;
                    let _e405 = (_e383 + _e404);
                    let _e406 = (_e383 - _e404);
                    let _e407 = select(_e392, 0f, _e396);
                    if _e396 {
                        phi_656_ = 38685626000000000000000000f;
                    } else {
                        phi_656_ = (1f / _e392);
                    }
                    let _e410 = phi_656_;
                    let _e413 = bitcast<f32>((bitcast<u32>(_e306) & 2147483647u));
                    let _e416 = bitcast<f32>((bitcast<u32>(_e345) & 2147483647u));
                    let _e418 = select(_e416, _e413, (_e413 > _e416));
                    let _e421 = bitcast<f32>((bitcast<u32>(_e383) & 2147483647u));
                    let _e424 = (_e125 + _e238);
                    if (_e219 && (select(_e421, _e418, (_e418 > _e421)) <= 1099511600000f)) {
                        let _e427 = (_e424 / 3i);
                        let _e434 = bitcast<f32>((bitcast<u32>((_e427 + 127i)) << bitcast<u32>(23i)));
                        let _e441 = bitcast<f32>((bitcast<u32>(((_e424 - (2i * _e427)) + 127i)) << bitcast<u32>(23i)));
                        let _e442 = (((_e204 * _e434) * _e434) * _e441);
                        let _e444 = select(340282350000000000000000000000000000000f, _e442, (_e442 < 340282350000000000000000000000000000000f));
                        let _e449 = (((_e213 * _e434) * _e434) * _e441);
                        let _e451 = select(340282350000000000000000000000000000000f, _e449, (_e449 < 340282350000000000000000000000000000000f));
                        phi_756_ = select(-340282350000000000000000000000000000000f, _e451, (_e451 > -340282350000000000000000000000000000000f));
                        phi_757_ = select(-340282350000000000000000000000000000000f, _e444, (_e444 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_756_ = 0f;
                        phi_757_ = 1f;
                    }
                    let _e455 = phi_756_;
                    let _e457 = phi_757_;
                    local_9 = array<type_21, 8>(type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_10 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e460 = (_e257 % 3u);
                    let _e461 = (_e460 < 3u);
                    if _e461 {
                    } else {
                        break;
                    }
                    let _e463 = local_1[_e460];
                    let _e466 = (_e256 % 3u);
                    let _e467 = (_e466 < 3u);
                    if _e467 {
                    } else {
                        break;
                    }
                    let _e469 = local_1[_e466];
                    let _e472 = (_e258 % 3u);
                    let _e473 = (_e472 < 3u);
                    if _e473 {
                    } else {
                        break;
                    }
                    let _e475 = local_1[_e472];
                    if _e461 {
                    } else {
                        break;
                    }
                    let _e480 = local[_e460];
                    if _e467 {
                    } else {
                        break;
                    }
                    let _e484 = local[_e466];
                    if _e473 {
                    } else {
                        break;
                    }
                    let _e488 = local[_e472];
                    phi_3656_ = false;
                    phi_3569_ = _e455;
                    phi_899_ = type_52(type_25(vec4<f32>((f32(_e463) * _e137), (f32(_e469) * _e137), (f32(_e475) * _e137), 0f), vec4<f32>((f32(_e480) * _e137), (f32(_e484) * _e137), (f32(_e488) * _e137), 0f)), select(0u, 2147483648u, (_e87 == 0u)));
                    phi_902_ = ((3u * _e87) + 1u);
                    phi_904_ = (_e457 <= _e455);
                    phi_906_ = 0u;
                    loop {
                        let _e498 = phi_3656_;
                        let _e500 = phi_3569_;
                        let _e502 = phi_899_;
                        let _e504 = phi_902_;
                        let _e506 = phi_904_;
                        let _e508 = phi_906_;
                        if _e506 {
                            phi_917_ = true;
                        } else {
                            phi_917_ = (_e508 > 0u);
                        }
                        let _e511 = phi_917_;
                        if _e511 {
                            let _e512 = (_e504 > 0u);
                            if _e512 {
                                if _e506 {
                                    phi_1004_ = _e502;
                                    phi_1005_ = _e506;
                                    phi_1006_ = _e508;
                                } else {
                                    let _e513 = (_e508 - 1u);
                                    let _e514 = (_e513 % 128u);
                                    let _e515 = (_e514 < 128u);
                                    if _e515 {
                                    } else {
                                        phi_3763_ = true;
                                        break;
                                    }
                                    let _e517 = local_7[_e514];
                                    if _e515 {
                                    } else {
                                        phi_3763_ = true;
                                        break;
                                    }
                                    let _e519 = local_6[_e514];
                                    if _e515 {
                                    } else {
                                        phi_3763_ = true;
                                        break;
                                    }
                                    let _e521 = local_5[_e514];
                                    if _e515 {
                                    } else {
                                        phi_3763_ = true;
                                        break;
                                    }
                                    let _e523 = local_4[_e514];
                                    if _e515 {
                                    } else {
                                        phi_3763_ = true;
                                        break;
                                    }
                                    let _e525 = local_3[_e514];
                                    if _e515 {
                                    } else {
                                        phi_3763_ = true;
                                        break;
                                    }
                                    let _e527 = local_2[_e514];
                                    if _e515 {
                                    } else {
                                        phi_3763_ = true;
                                        break;
                                    }
                                    let _e532 = local_8[_e514];
                                    if _e515 {
                                    } else {
                                        phi_3763_ = true;
                                        break;
                                    }
                                    let _e535 = local_10[_e514];
                                    phi_1004_ = type_52(type_25(vec4<f32>(_e517, _e519, _e521, 0f), vec4<f32>(_e523, _e525, _e527, 0f)), _e532);
                                    phi_1005_ = (_e535 <= _e500);
                                    phi_1006_ = _e513;
                                }
                                let _e538 = phi_1004_;
                                let _e540 = phi_1005_;
                                let _e542 = phi_1006_;
                                if _e540 {
                                    if ((_e538.member_1 & 2147483648u) != 0u) {
                                        phi_3653_ = _e498;
                                        phi_3643_ = _e500;
                                        phi_1024_ = type_4(0u, ((_e538.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1006 = phi_3653_;
                                            let _e1008 = phi_3643_;
                                            let _e1010 = phi_1024_;
                                            if (_e1010.member < _e1010.member_1) {
                                                phi_1025_ = type_4((_e1010.member + 1u), _e1010.member_1);
                                                phi_1048_ = type_4(1u, _e1010.member);
                                            } else {
                                                phi_1025_ = _e1010;
                                                phi_1048_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e1023 = phi_1025_;
                                            let _e1025 = phi_1048_;
                                            let _e1029 = (bitcast<i32>(_e1025.member) != 0i);
                                            if _e1029 {
                                                let _e1030 = ((_e538.member_1 & 268435455u) + _e1025.member_1);
                                                let _e1031 = (_e1030 < _e89);
                                                if _e1031 {
                                                    if _e1031 {
                                                    } else {
                                                        phi_3915_ = _e1008;
                                                        phi_3758_ = true;
                                                        break;
                                                    }
                                                    let _e1035 = global_2.member[_e1030].member_1;
                                                    phi_1069_ = _e1035;
                                                } else {
                                                    phi_1069_ = 4294967295u;
                                                }
                                                let _e1037 = phi_1069_;
                                                if (_e1030 >= _e89) {
                                                    phi_1158_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1031 {
                                                    } else {
                                                        phi_3915_ = _e1008;
                                                        phi_3758_ = true;
                                                        break;
                                                    }
                                                    if (_e460 < 9u) {
                                                    } else {
                                                        phi_3915_ = _e1008;
                                                        phi_3758_ = true;
                                                        break;
                                                    }
                                                    let _e1044 = global_2.member[_e1030].member[_e460];
                                                    if (_e466 < 9u) {
                                                    } else {
                                                        phi_3915_ = _e1008;
                                                        phi_3758_ = true;
                                                        break;
                                                    }
                                                    let _e1050 = global_2.member[_e1030].member[_e466];
                                                    if (_e472 < 9u) {
                                                    } else {
                                                        phi_3915_ = _e1008;
                                                        phi_3758_ = true;
                                                        break;
                                                    }
                                                    let _e1056 = global_2.member[_e1030].member[_e472];
                                                    let _e1058 = (3u + _e460);
                                                    if (_e1058 < 9u) {
                                                    } else {
                                                        phi_3915_ = _e1008;
                                                        phi_3758_ = true;
                                                        break;
                                                    }
                                                    let _e1064 = global_2.member[_e1030].member[_e1058];
                                                    let _e1065 = (3u + _e466);
                                                    if (_e1065 < 9u) {
                                                    } else {
                                                        phi_3915_ = _e1008;
                                                        phi_3758_ = true;
                                                        break;
                                                    }
                                                    let _e1071 = global_2.member[_e1030].member[_e1065];
                                                    let _e1072 = (3u + _e472);
                                                    if (_e1072 < 9u) {
                                                    } else {
                                                        phi_3915_ = _e1008;
                                                        phi_3758_ = true;
                                                        break;
                                                    }
                                                    let _e1078 = global_2.member[_e1030].member[_e1072];
                                                    let _e1080 = (6u + _e460);
                                                    if (_e1080 < 9u) {
                                                    } else {
                                                        phi_3915_ = _e1008;
                                                        phi_3758_ = true;
                                                        break;
                                                    }
                                                    let _e1086 = global_2.member[_e1030].member[_e1080];
                                                    let _e1087 = (6u + _e466);
                                                    if (_e1087 < 9u) {
                                                    } else {
                                                        phi_3915_ = _e1008;
                                                        phi_3758_ = true;
                                                        break;
                                                    }
                                                    let _e1093 = global_2.member[_e1030].member[_e1087];
                                                    let _e1094 = (6u + _e472);
                                                    if (_e1094 < 9u) {
                                                    } else {
                                                        phi_3915_ = _e1008;
                                                        phi_3758_ = true;
                                                        break;
                                                    }
                                                    let _e1100 = global_2.member[_e1030].member[_e1094];
                                                    phi_1158_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1044, _e1050, _e1056), array<f32, 3>(_e1064, _e1071, _e1078), array<f32, 3>(_e1086, _e1093, _e1100));
                                                }
                                                let _e1104 = phi_1158_;
                                                let _e1111 = (_e1104[0][2] - _e383);
                                                let _e1114 = (((_e1104[0][0] - _e306) * _e407) - (_e1111 * _e331));
                                                let _e1117 = (((_e1104[0][1] - _e345) * _e407) - (_e1111 * _e369));
                                                let _e1124 = (_e1104[1][2] - _e383);
                                                let _e1127 = (((_e1104[1][0] - _e306) * _e407) - (_e1124 * _e331));
                                                let _e1130 = (((_e1104[1][1] - _e345) * _e407) - (_e1124 * _e369));
                                                let _e1137 = (_e1104[2][2] - _e383);
                                                let _e1140 = (((_e1104[2][0] - _e306) * _e407) - (_e1137 * _e331));
                                                let _e1143 = (((_e1104[2][1] - _e345) * _e407) - (_e1137 * _e369));
                                                let _e1144 = (_e1140 * _e1130);
                                                let _e1145 = (_e1143 * _e1127);
                                                let _e1146 = (_e1114 * _e1143);
                                                let _e1147 = (_e1117 * _e1140);
                                                let _e1148 = (_e1127 * _e1117);
                                                let _e1149 = (_e1130 * _e1114);
                                                let _e1154 = (((_e1144 >= _e1145) && (_e1146 >= _e1147)) && (_e1148 >= _e1149));
                                                if (_e1154 || (((_e1144 <= _e1145) && (_e1146 <= _e1147)) && (_e1148 <= _e1149))) {
                                                    let _e1161 = select(-1f, 1f, _e1154);
                                                    let _e1163 = ((_e1144 - _e1145) * _e1161);
                                                    let _e1165 = select(0f, _e1163, (_e1163 > 0f));
                                                    let _e1167 = ((_e1146 - _e1147) * _e1161);
                                                    let _e1169 = select(0f, _e1167, (_e1167 > 0f));
                                                    let _e1171 = ((_e1148 - _e1149) * _e1161);
                                                    let _e1173 = select(0f, _e1171, (_e1171 > 0f));
                                                    let _e1175 = ((_e1165 + _e1169) + _e1173);
                                                    if (_e1175 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1725_ = type_21();
                                                        phi_1726_ = true;
                                                    } else {
                                                        let _e1178 = select(_e1104[1][0], _e1104[0][0], (_e1104[0][0] < _e1104[1][0]));
                                                        let _e1182 = select(_e1104[1][0], _e1104[0][0], (_e1104[0][0] > _e1104[1][0]));
                                                        let _e1186 = select(_e1104[1][1], _e1104[0][1], (_e1104[0][1] < _e1104[1][1]));
                                                        let _e1190 = select(_e1104[1][1], _e1104[0][1], (_e1104[0][1] > _e1104[1][1]));
                                                        let _e1194 = select(_e1104[1][2], _e1104[0][2], (_e1104[0][2] < _e1104[1][2]));
                                                        let _e1198 = select(_e1104[1][2], _e1104[0][2], (_e1104[0][2] > _e1104[1][2]));
                                                        let _e1203 = ((select(_e1104[2][0], _e1178, (_e1178 < _e1104[2][0])) - _e329) * _e334);
                                                        let _e1204 = ((select(_e1104[2][0], _e1182, (_e1182 > _e1104[2][0])) - _e330) * _e334);
                                                        let _e1207 = ((select(_e1104[2][1], _e1186, (_e1186 < _e1104[2][1])) - _e367) * _e372);
                                                        let _e1208 = ((select(_e1104[2][1], _e1190, (_e1190 > _e1104[2][1])) - _e368) * _e372);
                                                        let _e1211 = ((select(_e1104[2][2], _e1194, (_e1194 < _e1104[2][2])) - _e405) * _e410);
                                                        let _e1212 = ((select(_e1104[2][2], _e1198, (_e1198 > _e1104[2][2])) - _e406) * _e410);
                                                        let _e1214 = select(_e1212, _e1211, (_e1211 < _e1212));
                                                        let _e1216 = select(_e1212, _e1211, (_e1211 > _e1212));
                                                        let _e1218 = select(_e1204, _e1203, (_e1203 < _e1204));
                                                        let _e1220 = select(_e1208, _e1207, (_e1207 < _e1208));
                                                        let _e1222 = select(_e1220, _e1218, (_e1218 > _e1220));
                                                        let _e1224 = select(_e1214, _e1222, (_e1222 > _e1214));
                                                        let _e1226 = select(_e1204, _e1203, (_e1203 > _e1204));
                                                        let _e1228 = select(_e1208, _e1207, (_e1207 > _e1208));
                                                        let _e1230 = select(_e1228, _e1226, (_e1226 < _e1228));
                                                        let _e1232 = select(_e1216, _e1230, (_e1230 < _e1216));
                                                        let _e1233 = -(_e1214);
                                                        let _e1239 = select(_e457, _e1224, (_e1224 > _e457));
                                                        if (_e1239 > (_e1232 + (select(_e1233, _e1216, (_e1216 > _e1233)) * 0.0000019073523f))) {
                                                            phi_1720_ = type_21();
                                                            phi_1721_ = true;
                                                        } else {
                                                            let _e1241 = (_e1239 > _e1008);
                                                            if _e1241 {
                                                                phi_1719_ = type_21();
                                                            } else {
                                                                let _e1245 = (_e1104[1][0] - _e1104[0][0]);
                                                                let _e1246 = (_e1104[1][1] - _e1104[0][1]);
                                                                let _e1247 = (_e1104[1][2] - _e1104[0][2]);
                                                                let _e1248 = vec3<f32>(_e1245, _e1246, _e1247);
                                                                let _e1249 = (_e1104[2][0] - _e1104[1][0]);
                                                                let _e1250 = (_e1104[2][1] - _e1104[1][1]);
                                                                let _e1251 = (_e1104[2][2] - _e1104[1][2]);
                                                                let _e1252 = vec3<f32>(_e1249, _e1250, _e1251);
                                                                let _e1253 = (_e1104[0][0] - _e1104[2][0]);
                                                                let _e1254 = (_e1104[0][1] - _e1104[2][1]);
                                                                let _e1255 = (_e1104[0][2] - _e1104[2][2]);
                                                                let _e1256 = vec3<f32>(_e1253, _e1254, _e1255);
                                                                let _e1259 = bitcast<f32>((bitcast<u32>(_e1245) & 2147483647u));
                                                                let _e1262 = bitcast<f32>((bitcast<u32>(_e1246) & 2147483647u));
                                                                let _e1264 = select(_e1262, _e1259, (_e1259 > _e1262));
                                                                let _e1267 = bitcast<f32>((bitcast<u32>(_e1247) & 2147483647u));
                                                                let _e1269 = select(_e1267, _e1264, (_e1264 > _e1267));
                                                                let _e1272 = bitcast<f32>((bitcast<u32>(_e1249) & 2147483647u));
                                                                let _e1275 = bitcast<f32>((bitcast<u32>(_e1250) & 2147483647u));
                                                                let _e1277 = select(_e1275, _e1272, (_e1272 > _e1275));
                                                                let _e1280 = bitcast<f32>((bitcast<u32>(_e1251) & 2147483647u));
                                                                let _e1282 = select(_e1280, _e1277, (_e1277 > _e1280));
                                                                let _e1285 = bitcast<f32>((bitcast<u32>(_e1253) & 2147483647u));
                                                                let _e1288 = bitcast<f32>((bitcast<u32>(_e1254) & 2147483647u));
                                                                let _e1290 = select(_e1288, _e1285, (_e1285 > _e1288));
                                                                let _e1293 = bitcast<f32>((bitcast<u32>(_e1255) & 2147483647u));
                                                                let _e1295 = select(_e1293, _e1290, (_e1290 > _e1293));
                                                                let _e1297 = select(_e1282, _e1269, (_e1269 > _e1282));
                                                                let _e1299 = select(_e1295, _e1297, (_e1297 > _e1295));
                                                                if (_e1269 == _e1299) {
                                                                    phi_1630_ = _e1252;
                                                                    phi_1631_ = _e1256;
                                                                } else {
                                                                    let _e1302 = vec3((_e1282 == _e1299));
                                                                    phi_1630_ = select(_e1248, _e1256, _e1302);
                                                                    phi_1631_ = select(_e1252, _e1248, _e1302);
                                                                }
                                                                let _e1306 = phi_1630_;
                                                                let _e1308 = phi_1631_;
                                                                let _e1315 = ((_e1306.y * _e1308.z) - (_e1308.y * _e1306.z));
                                                                let _e1320 = ((_e1306.z * _e1308.x) - (_e1308.z * _e1306.x));
                                                                let _e1323 = ((_e1306.x * _e1308.y) - (_e1308.x * _e1306.y));
                                                                if (_e1165 >= _e1169) {
                                                                    phi_1662_ = select(true, false, (_e1165 >= _e1173));
                                                                } else {
                                                                    phi_1662_ = true;
                                                                }
                                                                let _e1328 = phi_1662_;
                                                                if _e1328 {
                                                                    phi_1671_ = select(vec3<f32>(_e1104[2][0], _e1104[2][1], _e1104[2][2]), vec3<f32>(_e1104[1][0], _e1104[1][1], _e1104[1][2]), vec3((_e1169 >= _e1173)));
                                                                } else {
                                                                    phi_1671_ = vec3<f32>(_e1104[0][0], _e1104[0][1], _e1104[0][2]);
                                                                }
                                                                let _e1333 = phi_1671_;
                                                                let _e1350 = ((((_e1315 * (_e1333.x - _e306)) + (_e1320 * (_e1333.y - _e345))) + (_e1323 * (_e1333.z - _e383))) / (((_e1315 * _e331) + (_e1320 * _e369)) + (_e1323 * _e407)));
                                                                let _e1352 = select(_e1232, _e1350, (_e1350 < _e1232));
                                                                let _e1354 = select(_e1224, _e1352, (_e1352 > _e1224));
                                                                if (_e1354 >= _e457) {
                                                                    let _e1356 = (_e1354 <= _e1008);
                                                                    if _e1356 {
                                                                        let _e1357 = (1f / _e1175);
                                                                        phi_1711_ = type_21(_e1354, (_e1169 * _e1357), (_e1173 * _e1357), _e1037);
                                                                    } else {
                                                                        phi_1711_ = type_21();
                                                                    }
                                                                    let _e1362 = phi_1711_;
                                                                    phi_1713_ = _e1362;
                                                                    phi_1714_ = select(true, false, _e1356);
                                                                } else {
                                                                    phi_1713_ = type_21();
                                                                    phi_1714_ = true;
                                                                }
                                                                let _e1365 = phi_1713_;
                                                                let _e1367 = phi_1714_;
                                                                if _e1367 {
                                                                    phi_1718_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1718_ = _e1365;
                                                                }
                                                                let _e1369 = phi_1718_;
                                                                phi_1719_ = _e1369;
                                                            }
                                                            let _e1371 = phi_1719_;
                                                            phi_1720_ = _e1371;
                                                            phi_1721_ = _e1241;
                                                        }
                                                        let _e1373 = phi_1720_;
                                                        let _e1375 = phi_1721_;
                                                        phi_1725_ = _e1373;
                                                        phi_1726_ = _e1375;
                                                    }
                                                    let _e1377 = phi_1725_;
                                                    let _e1379 = phi_1726_;
                                                    phi_1730_ = _e1377;
                                                    phi_1731_ = _e1379;
                                                } else {
                                                    phi_1730_ = type_21();
                                                    phi_1731_ = true;
                                                }
                                                let _e1381 = phi_1730_;
                                                let _e1383 = phi_1731_;
                                                if _e1383 {
                                                    phi_1735_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1735_ = _e1381;
                                                }
                                                let _e1385 = phi_1735_;
                                                if (_e1385.member_3 != 4294967295u) {
                                                    if (_e1037 != 4294967295u) {
                                                        phi_1747_ = type_4(0u, 8u);
                                                        phi_1750_ = _e1385;
                                                        loop {
                                                            let _e1390 = phi_1747_;
                                                            let _e1392 = phi_1750_;
                                                            if (_e1390.member < _e1390.member_1) {
                                                                phi_1748_ = type_4((_e1390.member + 1u), _e1390.member_1);
                                                                phi_1773_ = type_4(1u, _e1390.member);
                                                            } else {
                                                                phi_1748_ = _e1390;
                                                                phi_1773_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1405 = phi_1748_;
                                                            let _e1407 = phi_1773_;
                                                            let _e1411 = (bitcast<i32>(_e1407.member) != 0i);
                                                            if _e1411 {
                                                                let _e1412 = (_e1407.member_1 < 8u);
                                                                if _e1412 {
                                                                } else {
                                                                    phi_3644_ = true;
                                                                    break;
                                                                }
                                                                let _e1417 = local_9[_e1407.member_1].member;
                                                                if (_e1392.member < _e1417) {
                                                                    phi_1806_ = true;
                                                                } else {
                                                                    let _e1419 = local_9[_e1407.member_1].member;
                                                                    if (_e1392.member == _e1419) {
                                                                        let _e1424 = local_9[_e1407.member_1].member_3;
                                                                        phi_1805_ = (_e1392.member_3 < _e1424);
                                                                    } else {
                                                                        phi_1805_ = false;
                                                                    }
                                                                    let _e1427 = phi_1805_;
                                                                    phi_1806_ = _e1427;
                                                                }
                                                                let _e1429 = phi_1806_;
                                                                if _e1429 {
                                                                    if _e1412 {
                                                                    } else {
                                                                        phi_3644_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1430 = local_9[_e1407.member_1];
                                                                    local_9[_e1407.member_1] = type_21(_e1392.member, _e1392.member_1, _e1392.member_2, _e1392.member_3);
                                                                    phi_1827_ = type_21(_e1430.member, _e1430.member_1, _e1430.member_2, _e1430.member_3);
                                                                } else {
                                                                    phi_1827_ = _e1392;
                                                                }
                                                                let _e1441 = phi_1827_;
                                                                phi_1751_ = _e1441;
                                                            } else {
                                                                phi_1751_ = type_21();
                                                            }
                                                            let _e1443 = phi_1751_;
                                                            continue;
                                                            continuing {
                                                                phi_1747_ = _e1405;
                                                                phi_1750_ = _e1443;
                                                                phi_3644_ = _e1006;
                                                                break if !(_e1411);
                                                            }
                                                        }
                                                        let _e1446 = phi_3644_;
                                                        phi_3915_ = _e1008;
                                                        phi_3758_ = _e1446;
                                                        if _e1446 {
                                                            break;
                                                        }
                                                        let _e1449 = local_9[7u].member_3;
                                                        if (_e1449 != 4294967295u) {
                                                            let _e1453 = local_9[7u].member;
                                                            phi_3978_ = _e1453;
                                                        } else {
                                                            phi_3978_ = _e1008;
                                                        }
                                                        let _e1455 = phi_3978_;
                                                        phi_3977_ = _e1455;
                                                        phi_3761_ = _e1446;
                                                    } else {
                                                        phi_3977_ = _e1008;
                                                        phi_3761_ = _e1006;
                                                    }
                                                    let _e1457 = phi_3977_;
                                                    let _e1459 = phi_3761_;
                                                    phi_3976_ = _e1457;
                                                    phi_3760_ = _e1459;
                                                } else {
                                                    phi_3976_ = _e1008;
                                                    phi_3760_ = _e1006;
                                                }
                                                let _e1461 = phi_3976_;
                                                let _e1463 = phi_3760_;
                                                phi_3975_ = _e1461;
                                                phi_3759_ = _e1463;
                                            } else {
                                                phi_3975_ = _e1008;
                                                phi_3759_ = _e1006;
                                            }
                                            let _e1465 = phi_3975_;
                                            let _e1467 = phi_3759_;
                                            continue;
                                            continuing {
                                                phi_3653_ = _e1467;
                                                phi_3643_ = _e1465;
                                                phi_1024_ = _e1023;
                                                phi_3915_ = _e1465;
                                                phi_3758_ = _e1467;
                                                break if !(_e1029);
                                            }
                                        }
                                        let _e1470 = phi_3915_;
                                        let _e1472 = phi_3758_;
                                        phi_3763_ = _e1472;
                                        if _e1472 {
                                            break;
                                        }
                                        phi_3880_ = _e1470;
                                        phi_3767_ = _e1472;
                                        phi_3186_ = _e538;
                                        phi_3187_ = false;
                                        phi_3188_ = _e542;
                                    } else {
                                        if (_e538.member_1 >= _e87) {
                                            phi_2741_ = type_53(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_52(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_52(type_25(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e538.member_1 < _e87) {
                                            } else {
                                                phi_3763_ = true;
                                                break;
                                            }
                                            let _e555 = ((1u + (_e257 * 2u)) % 7u);
                                            if (_e555 < 7u) {
                                            } else {
                                                phi_3763_ = true;
                                                break;
                                            }
                                            let _e560 = global_5.member[_e538.member_1][_e555];
                                            let _e563 = ((1u + (_e256 * 2u)) % 7u);
                                            if (_e563 < 7u) {
                                            } else {
                                                phi_3763_ = true;
                                                break;
                                            }
                                            let _e568 = global_5.member[_e538.member_1][_e563];
                                            let _e571 = ((1u + (_e258 * 2u)) % 7u);
                                            if (_e571 < 7u) {
                                            } else {
                                                phi_3763_ = true;
                                                break;
                                            }
                                            let _e576 = global_5.member[_e538.member_1][_e571];
                                            let _e579 = (((_e257 + 1u) * 2u) % 7u);
                                            if (_e579 < 7u) {
                                            } else {
                                                phi_3763_ = true;
                                                break;
                                            }
                                            let _e584 = global_5.member[_e538.member_1][_e579];
                                            let _e587 = (((_e256 + 1u) * 2u) % 7u);
                                            if (_e587 < 7u) {
                                            } else {
                                                phi_3763_ = true;
                                                break;
                                            }
                                            let _e592 = global_5.member[_e538.member_1][_e587];
                                            let _e595 = (((_e258 + 1u) * 2u) % 7u);
                                            if (_e595 < 7u) {
                                            } else {
                                                phi_3763_ = true;
                                                break;
                                            }
                                            let _e600 = global_5.member[_e538.member_1][_e595];
                                            let _e623 = (bitcast<f32>((bitcast<u32>((_e538.member.member_1.x - _e538.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e624 = (bitcast<f32>((bitcast<u32>((_e538.member.member_1.y - _e538.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e625 = (bitcast<f32>((bitcast<u32>((_e538.member.member_1.z - _e538.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e627 = select(_e137, _e623, (_e623 > _e137));
                                            let _e629 = select(_e137, _e624, (_e624 > _e137));
                                            let _e631 = select(_e137, _e625, (_e625 > _e137));
                                            let _e656 = bitcast<u32>((f32(bitcast<i32>((_e560 & 2097151u))) * _e627));
                                            let _e661 = (bitcast<i32>((_e560 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e664 = bitcast<f32>((_e656 & bitcast<u32>(_e661)));
                                            let _e665 = bitcast<u32>((f32(bitcast<i32>((_e568 & 2097151u))) * _e629));
                                            let _e670 = (bitcast<i32>((_e568 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e673 = bitcast<f32>((_e665 & bitcast<u32>(_e670)));
                                            let _e674 = bitcast<u32>((f32(bitcast<i32>((_e576 & 2097151u))) * _e631));
                                            let _e679 = (bitcast<i32>((_e576 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e682 = bitcast<f32>((_e674 & bitcast<u32>(_e679)));
                                            let _e686 = bitcast<f32>((_e656 & bitcast<u32>(~(_e661))));
                                            let _e690 = bitcast<f32>((_e665 & bitcast<u32>(~(_e670))));
                                            let _e694 = bitcast<f32>((_e674 & bitcast<u32>(~(_e679))));
                                            let _e695 = bitcast<u32>((f32(bitcast<i32>((_e584 & 2097151u))) * _e627));
                                            let _e700 = (bitcast<i32>((_e584 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e703 = bitcast<f32>((_e695 & bitcast<u32>(_e700)));
                                            let _e704 = bitcast<u32>((f32(bitcast<i32>((_e592 & 2097151u))) * _e629));
                                            let _e709 = (bitcast<i32>((_e592 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e712 = bitcast<f32>((_e704 & bitcast<u32>(_e709)));
                                            let _e713 = bitcast<u32>((f32(bitcast<i32>((_e600 & 2097151u))) * _e631));
                                            let _e718 = (bitcast<i32>((_e600 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e721 = bitcast<f32>((_e713 & bitcast<u32>(_e718)));
                                            let _e725 = bitcast<f32>((_e695 & bitcast<u32>(~(_e700))));
                                            let _e729 = bitcast<f32>((_e704 & bitcast<u32>(~(_e709))));
                                            let _e733 = bitcast<f32>((_e713 & bitcast<u32>(~(_e718))));
                                            let _e763 = global_5.member[_e538.member_1][0u];
                                            let _e767 = global_5.member[_e538.member_1][2u];
                                            let _e771 = global_5.member[_e538.member_1][4u];
                                            let _e775 = global_5.member[_e538.member_1][6u];
                                            let _e787 = (((_e767 >> bitcast<u32>(22i)) | ((_e771 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e775 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e788 = (_e763 & 268435455u);
                                            let _e789 = (_e787 & 268435455u);
                                            let _e792 = ((_e763 >> bitcast<u32>(28u)) & 7u);
                                            let _e800 = ((_e763 >> bitcast<u32>(31i)) | (((_e787 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e801 = (_e792 != 0u);
                                            if (_e792 == 0u) {
                                                phi_2703_ = _e788;
                                            } else {
                                                if (_e792 == 7u) {
                                                    phi_2702_ = 2147483648u;
                                                } else {
                                                    phi_2702_ = ((2147483648u | (_e792 << bitcast<u32>(28u))) | (_e789 & 268435455u));
                                                }
                                                let _e810 = phi_2702_;
                                                phi_2703_ = _e810;
                                            }
                                            let _e812 = phi_2703_;
                                            if _e801 {
                                                let _e813 = (_e792 != 7u);
                                                if _e813 {
                                                    phi_2713_ = (_e789 + _e792);
                                                } else {
                                                    phi_2713_ = u32();
                                                }
                                                let _e816 = phi_2713_;
                                                phi_2715_ = _e816;
                                                phi_2716_ = select(true, false, _e813);
                                            } else {
                                                phi_2715_ = u32();
                                                phi_2716_ = true;
                                            }
                                            let _e819 = phi_2715_;
                                            let _e821 = phi_2716_;
                                            if (_e800 == 0u) {
                                                phi_2737_ = (_e788 + select(0u, 1u, !(_e801)));
                                            } else {
                                                if (_e800 == 7u) {
                                                    phi_2736_ = 2147483648u;
                                                } else {
                                                    phi_2736_ = ((2147483648u | (_e800 << bitcast<u32>(28u))) | (select(_e819, _e789, _e821) & 268435455u));
                                                }
                                                let _e834 = phi_2736_;
                                                phi_2737_ = _e834;
                                            }
                                            let _e836 = phi_2737_;
                                            phi_2741_ = type_53(array<vec4<f32>, 3>(vec4<f32>((_e538.member.member.x + _e664), (_e538.member.member.x + _e686), (_e538.member.member_1.x - _e703), (_e538.member.member_1.x - _e725)), vec4<f32>((_e538.member.member.y + _e673), (_e538.member.member.y + _e690), (_e538.member.member_1.y - _e712), (_e538.member.member_1.y - _e729)), vec4<f32>((_e538.member.member.z + _e682), (_e538.member.member.z + _e694), (_e538.member.member_1.z - _e721), (_e538.member.member_1.z - _e733))), type_52(type_25((_e538.member.member + vec4<f32>(_e664, _e673, _e682, 0f)), (_e538.member.member_1 - vec4<f32>(_e703, _e712, _e721, 0f))), _e812), type_52(type_25((_e538.member.member + vec4<f32>(_e686, _e690, _e694, 0f)), (_e538.member.member_1 - vec4<f32>(_e725, _e729, _e733, 0f))), _e836));
                                        }
                                        let _e841 = phi_2741_;
                                        let _e852 = ((_e841.member[0].x - _e329) * _e334);
                                        let _e853 = ((_e841.member[0].y - _e329) * _e334);
                                        let _e854 = ((_e841.member[0].z - _e330) * _e334);
                                        let _e855 = ((_e841.member[0].w - _e330) * _e334);
                                        let _e865 = ((_e841.member[1].x - _e367) * _e372);
                                        let _e866 = ((_e841.member[1].y - _e367) * _e372);
                                        let _e867 = ((_e841.member[1].z - _e368) * _e372);
                                        let _e868 = ((_e841.member[1].w - _e368) * _e372);
                                        let _e878 = ((_e841.member[2].x - _e405) * _e410);
                                        let _e879 = ((_e841.member[2].y - _e405) * _e410);
                                        let _e880 = ((_e841.member[2].z - _e406) * _e410);
                                        let _e881 = ((_e841.member[2].w - _e406) * _e410);
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
                                        let _e933 = select(_e457, _e903, (_e903 > _e457));
                                        let _e935 = select(_e457, _e905, (_e905 > _e457));
                                        let _e940 = (_e933 <= select(_e500, _e930, (_e930 < _e500)));
                                        let _e941 = (_e935 <= select(_e500, _e931, (_e931 < _e500)));
                                        let _e942 = (_e933 <= _e935);
                                        if _e940 {
                                            if _e941 {
                                                if _e942 {
                                                    phi_3086_ = _e841.member_2;
                                                } else {
                                                    phi_3086_ = _e841.member_1;
                                                }
                                                let _e946 = phi_3086_;
                                                let _e968 = (_e542 % 128u);
                                                let _e969 = (_e968 < 128u);
                                                if _e969 {
                                                } else {
                                                    phi_3763_ = true;
                                                    break;
                                                }
                                                local_8[_e968] = _e946.member_1;
                                                if _e969 {
                                                } else {
                                                    phi_3763_ = true;
                                                    break;
                                                }
                                                local_7[_e968] = _e946.member.member.x;
                                                if _e969 {
                                                } else {
                                                    phi_3763_ = true;
                                                    break;
                                                }
                                                local_6[_e968] = _e946.member.member.y;
                                                if _e969 {
                                                } else {
                                                    phi_3763_ = true;
                                                    break;
                                                }
                                                local_5[_e968] = _e946.member.member.z;
                                                if _e969 {
                                                } else {
                                                    phi_3763_ = true;
                                                    break;
                                                }
                                                local_4[_e968] = _e946.member.member_1.x;
                                                if _e969 {
                                                } else {
                                                    phi_3763_ = true;
                                                    break;
                                                }
                                                local_3[_e968] = _e946.member.member_1.y;
                                                if _e969 {
                                                } else {
                                                    phi_3763_ = true;
                                                    break;
                                                }
                                                local_2[_e968] = _e946.member.member_1.z;
                                                if _e969 {
                                                } else {
                                                    phi_3763_ = true;
                                                    break;
                                                }
                                                local_10[_e968] = select(_e935, _e933, (_e933 > _e935));
                                                if _e942 {
                                                    phi_3163_ = _e841.member_1;
                                                } else {
                                                    phi_3163_ = _e841.member_2;
                                                }
                                                let _e982 = phi_3163_;
                                                phi_3164_ = _e982;
                                                phi_3165_ = (_e542 + 1u);
                                            } else {
                                                phi_3164_ = type_52();
                                                phi_3165_ = u32();
                                            }
                                            let _e984 = phi_3164_;
                                            let _e986 = phi_3165_;
                                            phi_3167_ = _e984;
                                            phi_3168_ = _e986;
                                            phi_3169_ = select(true, false, _e941);
                                        } else {
                                            phi_3167_ = type_52();
                                            phi_3168_ = u32();
                                            phi_3169_ = true;
                                        }
                                        let _e989 = phi_3167_;
                                        let _e991 = phi_3168_;
                                        let _e993 = phi_3169_;
                                        if _e993 {
                                            if _e940 {
                                                phi_3178_ = _e841.member_1;
                                            } else {
                                                phi_3178_ = _e841.member_2;
                                            }
                                            let _e997 = phi_3178_;
                                            phi_3183_ = _e997;
                                            phi_3184_ = select(_e941, true, _e940);
                                        } else {
                                            phi_3183_ = _e989;
                                            phi_3184_ = _e540;
                                        }
                                        let _e1000 = phi_3183_;
                                        let _e1002 = phi_3184_;
                                        phi_3880_ = _e500;
                                        phi_3767_ = _e498;
                                        phi_3186_ = _e1000;
                                        phi_3187_ = _e1002;
                                        phi_3188_ = select(_e991, _e542, _e993);
                                    }
                                    let _e1474 = phi_3880_;
                                    let _e1476 = phi_3767_;
                                    let _e1478 = phi_3186_;
                                    let _e1480 = phi_3187_;
                                    let _e1482 = phi_3188_;
                                    phi_3879_ = _e1474;
                                    phi_3766_ = _e1476;
                                    phi_3189_ = _e1478;
                                    phi_3190_ = (_e504 - 1u);
                                    phi_3191_ = _e1480;
                                    phi_3192_ = _e1482;
                                } else {
                                    phi_3879_ = _e500;
                                    phi_3766_ = _e498;
                                    phi_3189_ = _e538;
                                    phi_3190_ = _e504;
                                    phi_3191_ = _e540;
                                    phi_3192_ = _e542;
                                }
                                let _e1484 = phi_3879_;
                                let _e1486 = phi_3766_;
                                let _e1488 = phi_3189_;
                                let _e1490 = phi_3190_;
                                let _e1492 = phi_3191_;
                                let _e1494 = phi_3192_;
                                phi_3878_ = _e1484;
                                phi_3765_ = _e1486;
                                phi_3193_ = _e1488;
                                phi_3194_ = _e1490;
                                phi_3195_ = _e1492;
                                phi_3196_ = _e1494;
                            } else {
                                phi_3878_ = _e500;
                                phi_3765_ = _e498;
                                phi_3193_ = type_52();
                                phi_3194_ = u32();
                                phi_3195_ = bool();
                                phi_3196_ = u32();
                            }
                            let _e1496 = phi_3878_;
                            let _e1498 = phi_3765_;
                            let _e1500 = phi_3193_;
                            let _e1502 = phi_3194_;
                            let _e1504 = phi_3195_;
                            let _e1506 = phi_3196_;
                            phi_3877_ = _e1496;
                            phi_3764_ = _e1498;
                            phi_900_ = _e1500;
                            phi_903_ = _e1502;
                            phi_905_ = _e1504;
                            phi_907_ = _e1506;
                            phi_3197_ = _e512;
                        } else {
                            phi_3877_ = _e500;
                            phi_3764_ = _e498;
                            phi_900_ = type_52();
                            phi_903_ = u32();
                            phi_905_ = bool();
                            phi_907_ = u32();
                            phi_3197_ = false;
                        }
                        let _e1508 = phi_3877_;
                        let _e1510 = phi_3764_;
                        let _e1512 = phi_900_;
                        let _e1514 = phi_903_;
                        let _e1516 = phi_905_;
                        let _e1518 = phi_907_;
                        let _e1520 = phi_3197_;
                        continue;
                        continuing {
                            phi_3656_ = _e1510;
                            phi_3569_ = _e1508;
                            phi_899_ = _e1512;
                            phi_902_ = _e1514;
                            phi_904_ = _e1516;
                            phi_906_ = _e1518;
                            phi_3763_ = _e1510;
                            break if !(_e1520);
                        }
                    }
                    let _e1523 = phi_3763_;
                    if _e1523 {
                        break;
                    }
                    phi_3204_ = type_4(0u, 8u);
                    loop {
                        let _e1525 = phi_3204_;
                        if (_e1525.member < _e1525.member_1) {
                            phi_3205_ = type_4((_e1525.member + 1u), _e1525.member_1);
                            phi_3228_ = type_4(1u, _e1525.member);
                        } else {
                            phi_3205_ = _e1525;
                            phi_3228_ = type_4(0u, type_4().member_1);
                        }
                        let _e1538 = phi_3205_;
                        let _e1540 = phi_3228_;
                        let _e1544 = (bitcast<i32>(_e1540.member) != 0i);
                        if _e1544 {
                            let _e1545 = (_e1540.member_1 < 8u);
                            if _e1545 {
                            } else {
                                phi_3870_ = true;
                                break;
                            }
                            let _e1547 = local_9[_e1540.member_1];
                            if (_e1547.member_3 != 4294967295u) {
                                let _e1553 = -(_e424);
                                let _e1554 = (_e1553 / 3i);
                                let _e1561 = bitcast<f32>((bitcast<u32>((_e1554 + 127i)) << bitcast<u32>(23i)));
                                let _e1569 = (((_e1547.member * _e1561) * _e1561) * bitcast<f32>((bitcast<u32>(((_e1553 - (2i * _e1554)) + 127i)) << bitcast<u32>(23i))));
                                let _e1571 = select(340282350000000000000000000000000000000f, _e1569, (_e1569 < 340282350000000000000000000000000000000f));
                                phi_3294_ = type_21(select(-340282350000000000000000000000000000000f, _e1571, (_e1571 > -340282350000000000000000000000000000000f)), _e1547.member_1, _e1547.member_2, _e1547.member_3);
                            } else {
                                phi_3294_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1576 = phi_3294_;
                            if _e1545 {
                            } else {
                                phi_3870_ = true;
                                break;
                            }
                            local_9[_e1540.member_1] = type_21(_e1576.member, _e1576.member_1, _e1576.member_2, _e1576.member_3);
                        }
                        continue;
                        continuing {
                            phi_3204_ = _e1538;
                            phi_3870_ = _e1523;
                            break if !(_e1544);
                        }
                    }
                    let _e1584 = phi_3870_;
                    if _e1584 {
                        break;
                    }
                    let _e1585 = local_9;
                    if _e145 {
                    } else {
                        break;
                    }
                    global_6.member[_e143] = array<type_21, 8>(type_21(_e1585[0].member, _e1585[0].member_1, _e1585[0].member_2, _e1585[0].member_3), type_21(_e1585[1].member, _e1585[1].member_1, _e1585[1].member_2, _e1585[1].member_3), type_21(_e1585[2].member, _e1585[2].member_1, _e1585[2].member_2, _e1585[2].member_3), type_21(_e1585[3].member, _e1585[3].member_1, _e1585[3].member_2, _e1585[3].member_3), type_21(_e1585[4].member, _e1585[4].member_1, _e1585[4].member_2, _e1585[4].member_3), type_21(_e1585[5].member, _e1585[5].member_1, _e1585[5].member_2, _e1585[5].member_3), type_21(_e1585[6].member, _e1585[6].member_1, _e1585[6].member_2, _e1585[6].member_3), type_21(_e1585[7].member, _e1585[7].member_1, _e1585[7].member_2, _e1585[7].member_3));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_nearest_q21_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
