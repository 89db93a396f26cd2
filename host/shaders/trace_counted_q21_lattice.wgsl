struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_12 {
    member: vec4<u32>,
}

struct type_20 {
    member: array<array<u32, 2>>,
}

struct type_24 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_25 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_28 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_32 {
    member: type_24,
    member_1: f32,
}

struct type_37 {
    member: array<type_25>,
}

struct type_39 {
    member: type_32,
    member_1: u32,
    member_2: u32,
}

struct type_41 {
    member: array<vec4<u32>, 2>,
}

struct type_45 {
    member: array<array<u32, 7>>,
}

struct type_50 {
    member: type_28,
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
@group(0) @binding(1) 
var<uniform> global_2: type_41;
@group(0) @binding(4) 
var<storage> global_3: type_37;
@group(0) @binding(2) 
var<storage> global_4: type_45;
@group(0) @binding(3) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_20;

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
    var phi_388_: i32;
    var phi_389_: i32;
    var phi_399_: bool;
    var phi_409_: u32;
    var phi_410_: u32;
    var phi_412_: bool;
    var phi_417_: u32;
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
    var phi_3776_: bool;
    var phi_847_: type_39;
    var phi_850_: type_50;
    var phi_852_: u32;
    var phi_854_: bool;
    var phi_856_: u32;
    var phi_867_: bool;
    var phi_953_: type_50;
    var phi_954_: bool;
    var phi_955_: u32;
    var phi_2807_: u32;
    var phi_2813_: u32;
    var phi_3067_: u32;
    var phi_3068_: u32;
    var phi_3078_: u32;
    var phi_3080_: u32;
    var phi_3081_: bool;
    var phi_3101_: u32;
    var phi_3102_: u32;
    var phi_3106_: type_51;
    var phi_3450_: type_50;
    var phi_3527_: type_50;
    var phi_3528_: type_50;
    var phi_3529_: u32;
    var phi_3531_: type_50;
    var phi_3532_: u32;
    var phi_3533_: bool;
    var phi_3542_: type_50;
    var phi_3547_: type_50;
    var phi_3548_: bool;
    var phi_974_: type_39;
    var phi_977_: type_8;
    var phi_978_: type_8;
    var phi_1000_: type_8;
    var phi_1044_: u32;
    var phi_1050_: u32;
    var phi_1060_: u32;
    var phi_1076_: u32;
    var phi_1109_: u32;
    var phi_1115_: u32;
    var phi_1542_: u32;
    var phi_1560_: u32;
    var phi_1578_: u32;
    var phi_1598_: u32;
    var phi_1616_: u32;
    var phi_1634_: u32;
    var phi_1654_: u32;
    var phi_1672_: u32;
    var phi_1690_: u32;
    var phi_1268_: u32;
    var phi_1283_: u32;
    var phi_1293_: u32;
    var phi_1313_: u32;
    var phi_1333_: u32;
    var phi_1359_: u32;
    var phi_1374_: u32;
    var phi_1384_: u32;
    var phi_1404_: u32;
    var phi_1424_: u32;
    var phi_1450_: u32;
    var phi_1465_: u32;
    var phi_1475_: u32;
    var phi_1495_: u32;
    var phi_1515_: u32;
    var phi_1139_: u32;
    var phi_1182_: u32;
    var phi_1225_: u32;
    var phi_1696_: array<array<f32, 3>, 3>;
    var phi_2167_: vec3<f32>;
    var phi_2168_: vec3<f32>;
    var phi_2199_: bool;
    var phi_2208_: vec3<f32>;
    var phi_2248_: type_24;
    var phi_2250_: type_24;
    var phi_2251_: bool;
    var phi_2255_: type_24;
    var phi_2256_: type_24;
    var phi_2257_: type_24;
    var phi_2258_: bool;
    var phi_2262_: type_24;
    var phi_2263_: bool;
    var phi_2267_: type_24;
    var phi_2268_: bool;
    var phi_2272_: type_24;
    var phi_2297_: bool;
    var phi_2298_: bool;
    var phi_2305_: type_39;
    var phi_2306_: type_39;
    var phi_2307_: type_39;
    var phi_975_: type_39;
    var phi_3770_: bool;
    var phi_3935_: bool;
    var phi_3550_: type_39;
    var phi_3551_: type_50;
    var phi_3552_: bool;
    var phi_3553_: u32;
    var phi_3934_: bool;
    var phi_3554_: type_39;
    var phi_3555_: type_50;
    var phi_3556_: u32;
    var phi_3557_: bool;
    var phi_3558_: u32;
    var phi_3933_: bool;
    var phi_3559_: type_39;
    var phi_3560_: type_50;
    var phi_3561_: u32;
    var phi_3562_: bool;
    var phi_3563_: u32;
    var phi_3932_: bool;
    var phi_848_: type_39;
    var phi_851_: type_50;
    var phi_853_: u32;
    var phi_855_: bool;
    var phi_857_: u32;
    var phi_3564_: bool;
    var phi_3931_: bool;
    var local_10: type_39;
    var local_11: type_39;
    var local_12: type_39;

    switch bitcast<i32>(0u) {
        default: {
            let _e86 = global;
            let _e88 = arrayLength((&global_4.member));
            let _e91 = arrayLength((&global_5.member));
            let _e99 = global_2.member[0u][0u];
            let _e103 = global_2.member[0u][1u];
            let _e107 = global_2.member[0u][2u];
            let _e111 = global_2.member[0u][3u];
            let _e115 = global_2.member[1u][0u];
            let _e119 = global_2.member[1u][1u];
            let _e123 = global_2.member[1u][2u];
            let _e126 = global_1.member[0u];
            let _e127 = bitcast<i32>(_e126);
            let _e139 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e111) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e99), bitcast<i32>(_e103), bitcast<i32>(_e107));
            local = array<i32, 3>(bitcast<i32>(_e115), bitcast<i32>(_e119), bitcast<i32>(_e123));
            let _e145 = (_e86.x + (_e86.y * 2097152u));
            let _e146 = (_e145 < arrayLength((&global_3.member)));
            if _e146 {
                let _e147 = (_e145 < arrayLength((&global_6.member)));
                if _e147 {
                    if _e146 {
                    } else {
                        break;
                    }
                    let _e155 = global_3.member[_e145].member_2[0u];
                    let _e157 = (bitcast<u32>(_e155) & 2147483647u);
                    let _e162 = global_3.member[_e145].member_2[1u];
                    let _e164 = (bitcast<u32>(_e162) & 2147483647u);
                    let _e169 = global_3.member[_e145].member_2[2u];
                    let _e171 = (bitcast<u32>(_e169) & 2147483647u);
                    let _e176 = global_3.member[_e145].member[0u];
                    let _e178 = (bitcast<u32>(_e176) & 2147483647u);
                    let _e183 = global_3.member[_e145].member[1u];
                    let _e185 = (bitcast<u32>(_e183) & 2147483647u);
                    let _e190 = global_3.member[_e145].member[2u];
                    let _e192 = (bitcast<u32>(_e190) & 2147483647u);
                    let _e194 = select(_e164, _e157, (_e164 < _e157));
                    let _e196 = select(_e171, _e194, (_e171 < _e194));
                    let _e198 = select(_e178, _e196, (_e178 < _e196));
                    let _e200 = select(_e185, _e198, (_e185 < _e198));
                    let _e202 = select(_e192, _e200, (_e192 < _e200));
                    let _e206 = global_3.member[_e145].member_1;
                    let _e208 = (bitcast<u32>(_e206) & 2147483647u);
                    let _e215 = global_3.member[_e145].member_3;
                    let _e221 = (((select(_e208, _e202, (_e208 < _e202)) < 2139095040u) && ((bitcast<u32>(_e215) & 2147483647u) <= 2139095040u)) && (_e196 > 0u));
                    if _e221 {
                        let _e224 = (bitcast<u32>(bitcast<f32>(_e196)) & 2147483647u);
                        if (_e224 >= 8388608u) {
                            phi_388_ = (bitcast<i32>((_e224 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_388_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e224)), 32u, (_e224 == 0u))));
                        }
                        let _e238 = phi_388_;
                        phi_389_ = _e238;
                    } else {
                        phi_389_ = 0i;
                    }
                    let _e240 = phi_389_;
                    let _e241 = (_e157 == _e196);
                    if _e241 {
                        phi_399_ = true;
                    } else {
                        phi_399_ = (_e164 == _e196);
                    }
                    let _e244 = phi_399_;
                    let _e245 = select(1u, 0u, _e241);
                    if _e244 {
                        let _e246 = (_e245 + 1u);
                        phi_409_ = _e246;
                        phi_410_ = _e246;
                        phi_412_ = select(true, false, (_e246 == 2u));
                    } else {
                        phi_409_ = u32();
                        phi_410_ = 0u;
                        phi_412_ = true;
                    }
                    let _e250 = phi_409_;
                    let _e252 = phi_410_;
                    let _e254 = phi_412_;
                    if _e254 {
                        phi_417_ = (_e252 + 1u);
                    } else {
                        phi_417_ = 0u;
                    }
                    let _e258 = phi_417_;
                    let _e259 = select(_e250, _e252, _e254);
                    let _e260 = select(_e245, select(2u, _e245, _e244), _e254);
                    if (_e127 < -126i) {
                        phi_429_ = -126i;
                    } else {
                        phi_429_ = select(_e127, 127i, (_e127 > 127i));
                    }
                    let _e265 = phi_429_;
                    let _e270 = bitcast<f32>((bitcast<u32>((_e265 + 127i)) << bitcast<u32>(23i)));
                    let _e276 = bitcast<f32>((bitcast<u32>(((_e127 - _e265) + 127i)) << bitcast<u32>(23i)));
                    let _e277 = -(_e240);
                    if (_e277 < -126i) {
                        phi_449_ = -126i;
                    } else {
                        phi_449_ = select(_e277, 127i, (_e277 > 127i));
                    }
                    let _e282 = phi_449_;
                    let _e287 = bitcast<f32>((bitcast<u32>((_e282 + 127i)) << bitcast<u32>(23i)));
                    let _e293 = bitcast<f32>((bitcast<u32>(((_e277 - _e282) + 127i)) << bitcast<u32>(23i)));
                    let _e297 = global_3.member[_e145].member;
                    let _e298 = (_e259 == 0u);
                    if _e298 {
                        phi_467_ = _e297[0];
                    } else {
                        phi_467_ = _e297[1];
                    }
                    let _e302 = phi_467_;
                    let _e303 = (_e259 == 2u);
                    if _e303 {
                        phi_473_ = _e297[2];
                    } else {
                        phi_473_ = _e302;
                    }
                    let _e306 = phi_473_;
                    let _e308 = ((_e306 * _e270) * _e276);
                    let _e309 = global_3.member[_e145].member_2;
                    if _e298 {
                        phi_484_ = _e309[0];
                    } else {
                        phi_484_ = _e309[1];
                    }
                    let _e313 = phi_484_;
                    if _e303 {
                        phi_490_ = _e309[2];
                    } else {
                        phi_490_ = _e313;
                    }
                    let _e316 = phi_490_;
                    let _e318 = ((_e316 * _e287) * _e293);
                    let _e322 = (bitcast<f32>((bitcast<u32>(_e318) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e322 {
                        let _e326 = (bitcast<f32>((bitcast<u32>(_e308) & 2147483647u)) * 0.00000011920929f);
                        phi_513_ = select(0.00000000000011368684f, _e326, (_e326 > 0.00000000000011368684f));
                    } else {
                        phi_513_ = 0f;
                    }
                    let _e330 = phi_513_;
                    let _e331 = (_e308 + _e330);
                    let _e332 = (_e308 - _e330);
                    let _e333 = select(_e318, 0f, _e322);
                    if _e322 {
                        phi_524_ = 38685626000000000000000000f;
                    } else {
                        phi_524_ = (1f / _e318);
                    }
                    let _e336 = phi_524_;
                    let _e337 = (_e258 == 0u);
                    if _e337 {
                        phi_533_ = _e297[0];
                    } else {
                        phi_533_ = _e297[1];
                    }
                    let _e341 = phi_533_;
                    let _e342 = (_e258 == 2u);
                    if _e342 {
                        phi_539_ = _e297[2];
                    } else {
                        phi_539_ = _e341;
                    }
                    let _e345 = phi_539_;
                    let _e347 = ((_e345 * _e270) * _e276);
                    if _e337 {
                        phi_550_ = _e309[0];
                    } else {
                        phi_550_ = _e309[1];
                    }
                    let _e351 = phi_550_;
                    if _e342 {
                        phi_556_ = _e309[2];
                    } else {
                        phi_556_ = _e351;
                    }
                    let _e354 = phi_556_;
                    let _e356 = ((_e354 * _e287) * _e293);
                    let _e360 = (bitcast<f32>((bitcast<u32>(_e356) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e360 {
                        let _e364 = (bitcast<f32>((bitcast<u32>(_e347) & 2147483647u)) * 0.00000011920929f);
                        phi_579_ = select(0.00000000000011368684f, _e364, (_e364 > 0.00000000000011368684f));
                    } else {
                        phi_579_ = 0f;
                    }
                    let _e368 = phi_579_;
                    let _e369 = (_e347 + _e368);
                    let _e370 = (_e347 - _e368);
                    let _e371 = select(_e356, 0f, _e360);
                    if _e360 {
                        phi_590_ = 38685626000000000000000000f;
                    } else {
                        phi_590_ = (1f / _e356);
                    }
                    let _e374 = phi_590_;
                    let _e375 = (_e260 == 0u);
                    if _e375 {
                        phi_599_ = _e297[0];
                    } else {
                        phi_599_ = _e297[1];
                    }
                    let _e379 = phi_599_;
                    let _e380 = (_e260 == 2u);
                    if _e380 {
                        phi_605_ = _e297[2];
                    } else {
                        phi_605_ = _e379;
                    }
                    let _e383 = phi_605_;
                    let _e385 = ((_e383 * _e270) * _e276);
                    if _e375 {
                        phi_616_ = _e309[0];
                    } else {
                        phi_616_ = _e309[1];
                    }
                    let _e389 = phi_616_;
                    if _e380 {
                        phi_622_ = _e309[2];
                    } else {
                        phi_622_ = _e389;
                    }
                    let _e392 = phi_622_;
                    let _e394 = ((_e392 * _e287) * _e293);
                    let _e398 = (bitcast<f32>((bitcast<u32>(_e394) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e398 {
                        let _e402 = (bitcast<f32>((bitcast<u32>(_e385) & 2147483647u)) * 0.00000011920929f);
                        phi_645_ = select(0.00000000000011368684f, _e402, (_e402 > 0.00000000000011368684f));
                    } else {
                        phi_645_ = 0f;
                    }
                    let _e406 = phi_645_;
                    let _e407 = (_e385 + _e406);
                    let _e408 = (_e385 - _e406);
                    let _e409 = select(_e394, 0f, _e398);
                    if _e398 {
                        phi_656_ = 38685626000000000000000000f;
                    } else {
                        phi_656_ = (1f / _e394);
                    }
                    let _e412 = phi_656_;
                    let _e415 = bitcast<f32>((bitcast<u32>(_e308) & 2147483647u));
                    let _e418 = bitcast<f32>((bitcast<u32>(_e347) & 2147483647u));
                    let _e420 = select(_e418, _e415, (_e415 > _e418));
                    let _e423 = bitcast<f32>((bitcast<u32>(_e385) & 2147483647u));
                    let _e426 = (_e127 + _e240);
                    if (_e221 && (select(_e423, _e420, (_e420 > _e423)) <= 1099511600000f)) {
                        let _e429 = (_e426 / 3i);
                        let _e436 = bitcast<f32>((bitcast<u32>((_e429 + 127i)) << bitcast<u32>(23i)));
                        let _e443 = bitcast<f32>((bitcast<u32>(((_e426 - (2i * _e429)) + 127i)) << bitcast<u32>(23i)));
                        let _e444 = (((_e206 * _e436) * _e436) * _e443);
                        let _e446 = select(340282350000000000000000000000000000000f, _e444, (_e444 < 340282350000000000000000000000000000000f));
                        let _e451 = (((_e215 * _e436) * _e436) * _e443);
                        let _e453 = select(340282350000000000000000000000000000000f, _e451, (_e451 < 340282350000000000000000000000000000000f));
                        phi_756_ = select(-340282350000000000000000000000000000000f, _e453, (_e453 > -340282350000000000000000000000000000000f));
                        phi_757_ = select(-340282350000000000000000000000000000000f, _e446, (_e446 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_756_ = 0f;
                        phi_757_ = 1f;
                    }
                    let _e457 = phi_756_;
                    let _e459 = phi_757_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e464 = (_e259 % 3u);
                    let _e465 = (_e464 < 3u);
                    if _e465 {
                    } else {
                        break;
                    }
                    let _e467 = local_1[_e464];
                    let _e470 = (_e258 % 3u);
                    let _e471 = (_e470 < 3u);
                    if _e471 {
                    } else {
                        break;
                    }
                    let _e473 = local_1[_e470];
                    let _e476 = (_e260 % 3u);
                    let _e477 = (_e476 < 3u);
                    if _e477 {
                    } else {
                        break;
                    }
                    let _e479 = local_1[_e476];
                    if _e465 {
                    } else {
                        break;
                    }
                    let _e484 = local[_e464];
                    if _e471 {
                    } else {
                        break;
                    }
                    let _e488 = local[_e470];
                    if _e477 {
                    } else {
                        break;
                    }
                    let _e492 = local[_e476];
                    phi_3776_ = false;
                    phi_847_ = type_39(type_32(type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e457), 0u, 0u);
                    phi_850_ = type_50(type_28(vec4<f32>((f32(_e467) * _e139), (f32(_e473) * _e139), (f32(_e479) * _e139), 0f), vec4<f32>((f32(_e484) * _e139), (f32(_e488) * _e139), (f32(_e492) * _e139), 0f)), select(0u, 2147483648u, (_e88 == 0u)));
                    phi_852_ = ((3u * _e88) + 1u);
                    phi_854_ = (_e459 <= _e457);
                    phi_856_ = 0u;
                    loop {
                        let _e502 = phi_3776_;
                        let _e504 = phi_847_;
                        let _e506 = phi_850_;
                        let _e508 = phi_852_;
                        let _e510 = phi_854_;
                        let _e512 = phi_856_;
                        local_10 = _e504;
                        local_11 = _e504;
                        if _e510 {
                            phi_867_ = true;
                        } else {
                            phi_867_ = (_e512 > 0u);
                        }
                        let _e515 = phi_867_;
                        if _e515 {
                            let _e516 = (_e508 > 0u);
                            if _e516 {
                                if _e510 {
                                    phi_953_ = _e506;
                                    phi_954_ = _e510;
                                    phi_955_ = _e512;
                                } else {
                                    let _e517 = (_e512 - 1u);
                                    let _e518 = (_e517 % 128u);
                                    let _e519 = (_e518 < 128u);
                                    if _e519 {
                                    } else {
                                        phi_3931_ = true;
                                        break;
                                    }
                                    let _e521 = local_7[_e518];
                                    if _e519 {
                                    } else {
                                        phi_3931_ = true;
                                        break;
                                    }
                                    let _e523 = local_6[_e518];
                                    if _e519 {
                                    } else {
                                        phi_3931_ = true;
                                        break;
                                    }
                                    let _e525 = local_5[_e518];
                                    if _e519 {
                                    } else {
                                        phi_3931_ = true;
                                        break;
                                    }
                                    let _e527 = local_4[_e518];
                                    if _e519 {
                                    } else {
                                        phi_3931_ = true;
                                        break;
                                    }
                                    let _e529 = local_3[_e518];
                                    if _e519 {
                                    } else {
                                        phi_3931_ = true;
                                        break;
                                    }
                                    let _e531 = local_2[_e518];
                                    if _e519 {
                                    } else {
                                        phi_3931_ = true;
                                        break;
                                    }
                                    let _e536 = local_8[_e518];
                                    if _e519 {
                                    } else {
                                        phi_3931_ = true;
                                        break;
                                    }
                                    let _e539 = local_9[_e518];
                                    phi_953_ = type_50(type_28(vec4<f32>(_e521, _e523, _e525, 0f), vec4<f32>(_e527, _e529, _e531, 0f)), _e536);
                                    phi_954_ = (_e539 <= _e504.member.member_1);
                                    phi_955_ = _e517;
                                }
                                let _e544 = phi_953_;
                                let _e546 = phi_954_;
                                let _e548 = phi_955_;
                                if _e546 {
                                    let _e553 = (_e544.member_1 & 268435455u);
                                    if ((_e544.member_1 & 2147483648u) != 0u) {
                                        phi_974_ = _e504;
                                        phi_977_ = type_8(0u, ((_e544.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1038 = phi_974_;
                                            let _e1040 = phi_977_;
                                            local_12 = _e1038;
                                            if (_e1040.member < _e1040.member_1) {
                                                phi_978_ = type_8((_e1040.member + 1u), _e1040.member_1);
                                                phi_1000_ = type_8(1u, _e1040.member);
                                            } else {
                                                phi_978_ = _e1040;
                                                phi_1000_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1053 = phi_978_;
                                            let _e1055 = phi_1000_;
                                            let _e1059 = (bitcast<i32>(_e1055.member) != 0i);
                                            if _e1059 {
                                                let _e1065 = type_39(_e1038.member, _e1038.member_1, (_e1038.member_2 + 1u));
                                                let _e1070 = (_e544.member.member_1.x - _e544.member.member.x);
                                                let _e1073 = (_e544.member.member_1.y - _e544.member.member.y);
                                                let _e1076 = (_e544.member.member_1.z - _e544.member.member.z);
                                                let _e1078 = select(_e1073, _e1070, (_e1070 > _e1073));
                                                let _e1080 = select(_e1076, _e1078, (_e1078 > _e1076));
                                                let _e1082 = (_e1080 < (1024f * _e139));
                                                if _e1082 {
                                                    phi_1044_ = 0u;
                                                } else {
                                                    phi_1044_ = select(2u, 1u, (_e1080 < (2097152f * _e139)));
                                                }
                                                let _e1087 = phi_1044_;
                                                switch bitcast<i32>(_e1087) {
                                                    case 0: {
                                                        phi_1050_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1050_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1050_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1050_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1090 = phi_1050_;
                                                switch bitcast<i32>(_e1087) {
                                                    case 0: {
                                                        phi_1060_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1060_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1060_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1060_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1097 = phi_1060_;
                                                let _e1099 = ((_e553 + (_e1055.member_1 * ((3u * _e1090) + 1u))) + (3u * _e1097));
                                                let _e1100 = (_e1099 < _e91);
                                                if _e1100 {
                                                    if _e1100 {
                                                    } else {
                                                        phi_3770_ = true;
                                                        break;
                                                    }
                                                    let _e1102 = global_5.member[_e1099];
                                                    phi_1076_ = _e1102;
                                                } else {
                                                    phi_1076_ = 4294967295u;
                                                }
                                                let _e1104 = phi_1076_;
                                                if _e1082 {
                                                    phi_1109_ = 0u;
                                                } else {
                                                    phi_1109_ = select(2u, 1u, (_e1080 < (2097152f * _e139)));
                                                }
                                                let _e1109 = phi_1109_;
                                                switch bitcast<i32>(_e1109) {
                                                    case 0: {
                                                        phi_1115_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1115_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1115_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1115_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1112 = phi_1115_;
                                                let _e1116 = (_e553 + (_e1055.member_1 * ((3u * _e1112) + 1u)));
                                                switch bitcast<i32>(_e1109) {
                                                    case 0: {
                                                        let _e1382 = (_e1116 < _e91);
                                                        if _e1382 {
                                                            if _e1382 {
                                                            } else {
                                                                phi_3770_ = true;
                                                                break;
                                                            }
                                                            let _e1384 = global_5.member[_e1116];
                                                            phi_1139_ = _e1384;
                                                        } else {
                                                            phi_1139_ = 0u;
                                                        }
                                                        let _e1386 = phi_1139_;
                                                        let _e1388 = ((10u * _e259) & 31u);
                                                        let _e1397 = ((10u * _e258) & 31u);
                                                        let _e1406 = ((10u * _e260) & 31u);
                                                        let _e1415 = (_e1116 + 1u);
                                                        let _e1416 = (_e1415 < _e91);
                                                        if _e1416 {
                                                            if _e1416 {
                                                            } else {
                                                                phi_3770_ = true;
                                                                break;
                                                            }
                                                            let _e1418 = global_5.member[_e1415];
                                                            phi_1182_ = _e1418;
                                                        } else {
                                                            phi_1182_ = 0u;
                                                        }
                                                        let _e1420 = phi_1182_;
                                                        let _e1443 = (_e1116 + 2u);
                                                        let _e1444 = (_e1443 < _e91);
                                                        if _e1444 {
                                                            if _e1444 {
                                                            } else {
                                                                phi_3770_ = true;
                                                                break;
                                                            }
                                                            let _e1446 = global_5.member[_e1443];
                                                            phi_1225_ = _e1446;
                                                        } else {
                                                            phi_1225_ = 0u;
                                                        }
                                                        let _e1448 = phi_1225_;
                                                        phi_1696_ = array<array<f32, 3>, 3>(array<f32, 3>((_e544.member.member.x + (f32(bitcast<i32>(((_e1386 >> bitcast<u32>(_e1388)) & 1023u))) * _e139)), (_e544.member.member.y + (f32(bitcast<i32>(((_e1386 >> bitcast<u32>(_e1397)) & 1023u))) * _e139)), (_e544.member.member.z + (f32(bitcast<i32>(((_e1386 >> bitcast<u32>(_e1406)) & 1023u))) * _e139))), array<f32, 3>((_e544.member.member.x + (f32(bitcast<i32>(((_e1420 >> bitcast<u32>(_e1388)) & 1023u))) * _e139)), (_e544.member.member.y + (f32(bitcast<i32>(((_e1420 >> bitcast<u32>(_e1397)) & 1023u))) * _e139)), (_e544.member.member.z + (f32(bitcast<i32>(((_e1420 >> bitcast<u32>(_e1406)) & 1023u))) * _e139))), array<f32, 3>((_e544.member.member.x + (f32(bitcast<i32>(((_e1448 >> bitcast<u32>(_e1388)) & 1023u))) * _e139)), (_e544.member.member.y + (f32(bitcast<i32>(((_e1448 >> bitcast<u32>(_e1397)) & 1023u))) * _e139)), (_e544.member.member.z + (f32(bitcast<i32>(((_e1448 >> bitcast<u32>(_e1406)) & 1023u))) * _e139))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1205 = (_e1116 < _e91);
                                                        if _e1205 {
                                                            if _e1205 {
                                                            } else {
                                                                phi_3770_ = true;
                                                                break;
                                                            }
                                                            let _e1207 = global_5.member[_e1116];
                                                            phi_1268_ = _e1207;
                                                        } else {
                                                            phi_1268_ = 0u;
                                                        }
                                                        let _e1209 = phi_1268_;
                                                        let _e1210 = (_e1116 + 1u);
                                                        let _e1211 = (_e1210 < _e91);
                                                        if _e1211 {
                                                            if _e1211 {
                                                            } else {
                                                                phi_3770_ = true;
                                                                break;
                                                            }
                                                            let _e1213 = global_5.member[_e1210];
                                                            phi_1283_ = _e1213;
                                                        } else {
                                                            phi_1283_ = 0u;
                                                        }
                                                        let _e1215 = phi_1283_;
                                                        let _e1216 = (_e259 == 1u);
                                                        if _e1216 {
                                                            phi_1293_ = ((_e1209 >> bitcast<u32>(21i)) | (_e1215 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1293_ = (_e1215 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1225 = phi_1293_;
                                                        let _e1232 = (_e258 == 1u);
                                                        if _e1232 {
                                                            phi_1313_ = ((_e1209 >> bitcast<u32>(21i)) | (_e1215 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1313_ = (_e1215 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1241 = phi_1313_;
                                                        let _e1248 = (_e260 == 1u);
                                                        if _e1248 {
                                                            phi_1333_ = ((_e1209 >> bitcast<u32>(21i)) | (_e1215 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1333_ = (_e1215 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1257 = phi_1333_;
                                                        let _e1265 = (_e1116 + 2u);
                                                        let _e1266 = (_e1265 < _e91);
                                                        if _e1266 {
                                                            if _e1266 {
                                                            } else {
                                                                phi_3770_ = true;
                                                                break;
                                                            }
                                                            let _e1268 = global_5.member[_e1265];
                                                            phi_1359_ = _e1268;
                                                        } else {
                                                            phi_1359_ = 0u;
                                                        }
                                                        let _e1270 = phi_1359_;
                                                        let _e1271 = (_e1116 + 3u);
                                                        let _e1272 = (_e1271 < _e91);
                                                        if _e1272 {
                                                            if _e1272 {
                                                            } else {
                                                                phi_3770_ = true;
                                                                break;
                                                            }
                                                            let _e1274 = global_5.member[_e1271];
                                                            phi_1374_ = _e1274;
                                                        } else {
                                                            phi_1374_ = 0u;
                                                        }
                                                        let _e1276 = phi_1374_;
                                                        if _e1216 {
                                                            phi_1384_ = ((_e1270 >> bitcast<u32>(21i)) | (_e1276 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1384_ = (_e1276 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1285 = phi_1384_;
                                                        if _e1232 {
                                                            phi_1404_ = ((_e1270 >> bitcast<u32>(21i)) | (_e1276 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1404_ = (_e1276 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1300 = phi_1404_;
                                                        if _e1248 {
                                                            phi_1424_ = ((_e1270 >> bitcast<u32>(21i)) | (_e1276 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1424_ = (_e1276 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1315 = phi_1424_;
                                                        let _e1323 = (_e1116 + 4u);
                                                        let _e1324 = (_e1323 < _e91);
                                                        if _e1324 {
                                                            if _e1324 {
                                                            } else {
                                                                phi_3770_ = true;
                                                                break;
                                                            }
                                                            let _e1326 = global_5.member[_e1323];
                                                            phi_1450_ = _e1326;
                                                        } else {
                                                            phi_1450_ = 0u;
                                                        }
                                                        let _e1328 = phi_1450_;
                                                        let _e1329 = (_e1116 + 5u);
                                                        let _e1330 = (_e1329 < _e91);
                                                        if _e1330 {
                                                            if _e1330 {
                                                            } else {
                                                                phi_3770_ = true;
                                                                break;
                                                            }
                                                            let _e1332 = global_5.member[_e1329];
                                                            phi_1465_ = _e1332;
                                                        } else {
                                                            phi_1465_ = 0u;
                                                        }
                                                        let _e1334 = phi_1465_;
                                                        if _e1216 {
                                                            phi_1475_ = ((_e1328 >> bitcast<u32>(21i)) | (_e1334 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1475_ = (_e1334 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1343 = phi_1475_;
                                                        if _e1232 {
                                                            phi_1495_ = ((_e1328 >> bitcast<u32>(21i)) | (_e1334 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1495_ = (_e1334 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1358 = phi_1495_;
                                                        if _e1248 {
                                                            phi_1515_ = ((_e1328 >> bitcast<u32>(21i)) | (_e1334 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1515_ = (_e1334 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1373 = phi_1515_;
                                                        phi_1696_ = array<array<f32, 3>, 3>(array<f32, 3>((_e544.member.member.x + (f32(bitcast<i32>((select(_e1225, _e1209, _e298) & 2097151u))) * _e139)), (_e544.member.member.y + (f32(bitcast<i32>((select(_e1241, _e1209, _e337) & 2097151u))) * _e139)), (_e544.member.member.z + (f32(bitcast<i32>((select(_e1257, _e1209, _e375) & 2097151u))) * _e139))), array<f32, 3>((_e544.member.member.x + (f32(bitcast<i32>((select(_e1285, _e1270, _e298) & 2097151u))) * _e139)), (_e544.member.member.y + (f32(bitcast<i32>((select(_e1300, _e1270, _e337) & 2097151u))) * _e139)), (_e544.member.member.z + (f32(bitcast<i32>((select(_e1315, _e1270, _e375) & 2097151u))) * _e139))), array<f32, 3>((_e544.member.member.x + (f32(bitcast<i32>((select(_e1343, _e1328, _e298) & 2097151u))) * _e139)), (_e544.member.member.y + (f32(bitcast<i32>((select(_e1358, _e1328, _e337) & 2097151u))) * _e139)), (_e544.member.member.z + (f32(bitcast<i32>((select(_e1373, _e1328, _e375) & 2097151u))) * _e139))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1118 = (_e1116 + _e259);
                                                        let _e1119 = (_e1118 < _e91);
                                                        if _e1119 {
                                                            if _e1119 {
                                                            } else {
                                                                phi_3770_ = true;
                                                                break;
                                                            }
                                                            let _e1121 = global_5.member[_e1118];
                                                            phi_1542_ = _e1121;
                                                        } else {
                                                            phi_1542_ = 0u;
                                                        }
                                                        let _e1123 = phi_1542_;
                                                        let _e1127 = (_e1116 + _e258);
                                                        let _e1128 = (_e1127 < _e91);
                                                        if _e1128 {
                                                            if _e1128 {
                                                            } else {
                                                                phi_3770_ = true;
                                                                break;
                                                            }
                                                            let _e1130 = global_5.member[_e1127];
                                                            phi_1560_ = _e1130;
                                                        } else {
                                                            phi_1560_ = 0u;
                                                        }
                                                        let _e1132 = phi_1560_;
                                                        let _e1136 = (_e1116 + _e260);
                                                        let _e1137 = (_e1136 < _e91);
                                                        if _e1137 {
                                                            if _e1137 {
                                                            } else {
                                                                phi_3770_ = true;
                                                                break;
                                                            }
                                                            let _e1139 = global_5.member[_e1136];
                                                            phi_1578_ = _e1139;
                                                        } else {
                                                            phi_1578_ = 0u;
                                                        }
                                                        let _e1141 = phi_1578_;
                                                        let _e1146 = (_e1116 + 3u);
                                                        let _e1147 = (_e1146 + _e259);
                                                        let _e1148 = (_e1147 < _e91);
                                                        if _e1148 {
                                                            if _e1148 {
                                                            } else {
                                                                phi_3770_ = true;
                                                                break;
                                                            }
                                                            let _e1150 = global_5.member[_e1147];
                                                            phi_1598_ = _e1150;
                                                        } else {
                                                            phi_1598_ = 0u;
                                                        }
                                                        let _e1152 = phi_1598_;
                                                        let _e1156 = (_e1146 + _e258);
                                                        let _e1157 = (_e1156 < _e91);
                                                        if _e1157 {
                                                            if _e1157 {
                                                            } else {
                                                                phi_3770_ = true;
                                                                break;
                                                            }
                                                            let _e1159 = global_5.member[_e1156];
                                                            phi_1616_ = _e1159;
                                                        } else {
                                                            phi_1616_ = 0u;
                                                        }
                                                        let _e1161 = phi_1616_;
                                                        let _e1165 = (_e1146 + _e260);
                                                        let _e1166 = (_e1165 < _e91);
                                                        if _e1166 {
                                                            if _e1166 {
                                                            } else {
                                                                phi_3770_ = true;
                                                                break;
                                                            }
                                                            let _e1168 = global_5.member[_e1165];
                                                            phi_1634_ = _e1168;
                                                        } else {
                                                            phi_1634_ = 0u;
                                                        }
                                                        let _e1170 = phi_1634_;
                                                        let _e1175 = (_e1116 + 6u);
                                                        let _e1176 = (_e1175 + _e259);
                                                        let _e1177 = (_e1176 < _e91);
                                                        if _e1177 {
                                                            if _e1177 {
                                                            } else {
                                                                phi_3770_ = true;
                                                                break;
                                                            }
                                                            let _e1179 = global_5.member[_e1176];
                                                            phi_1654_ = _e1179;
                                                        } else {
                                                            phi_1654_ = 0u;
                                                        }
                                                        let _e1181 = phi_1654_;
                                                        let _e1185 = (_e1175 + _e258);
                                                        let _e1186 = (_e1185 < _e91);
                                                        if _e1186 {
                                                            if _e1186 {
                                                            } else {
                                                                phi_3770_ = true;
                                                                break;
                                                            }
                                                            let _e1188 = global_5.member[_e1185];
                                                            phi_1672_ = _e1188;
                                                        } else {
                                                            phi_1672_ = 0u;
                                                        }
                                                        let _e1190 = phi_1672_;
                                                        let _e1194 = (_e1175 + _e260);
                                                        let _e1195 = (_e1194 < _e91);
                                                        if _e1195 {
                                                            if _e1195 {
                                                            } else {
                                                                phi_3770_ = true;
                                                                break;
                                                            }
                                                            let _e1197 = global_5.member[_e1194];
                                                            phi_1690_ = _e1197;
                                                        } else {
                                                            phi_1690_ = 0u;
                                                        }
                                                        let _e1199 = phi_1690_;
                                                        phi_1696_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1123)) * _e139), (f32(bitcast<i32>(_e1132)) * _e139), (f32(bitcast<i32>(_e1141)) * _e139)), array<f32, 3>((f32(bitcast<i32>(_e1152)) * _e139), (f32(bitcast<i32>(_e1161)) * _e139), (f32(bitcast<i32>(_e1170)) * _e139)), array<f32, 3>((f32(bitcast<i32>(_e1181)) * _e139), (f32(bitcast<i32>(_e1190)) * _e139), (f32(bitcast<i32>(_e1199)) * _e139)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1696_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1473 = phi_1696_;
                                                let _e1482 = (_e1473[0][2] - _e385);
                                                let _e1485 = (((_e1473[0][0] - _e308) * _e409) - (_e1482 * _e333));
                                                let _e1488 = (((_e1473[0][1] - _e347) * _e409) - (_e1482 * _e371));
                                                let _e1495 = (_e1473[1][2] - _e385);
                                                let _e1498 = (((_e1473[1][0] - _e308) * _e409) - (_e1495 * _e333));
                                                let _e1501 = (((_e1473[1][1] - _e347) * _e409) - (_e1495 * _e371));
                                                let _e1508 = (_e1473[2][2] - _e385);
                                                let _e1511 = (((_e1473[2][0] - _e308) * _e409) - (_e1508 * _e333));
                                                let _e1514 = (((_e1473[2][1] - _e347) * _e409) - (_e1508 * _e371));
                                                let _e1515 = (_e1511 * _e1501);
                                                let _e1516 = (_e1514 * _e1498);
                                                let _e1517 = (_e1485 * _e1514);
                                                let _e1518 = (_e1488 * _e1511);
                                                let _e1519 = (_e1498 * _e1488);
                                                let _e1520 = (_e1501 * _e1485);
                                                let _e1525 = (((_e1515 >= _e1516) && (_e1517 >= _e1518)) && (_e1519 >= _e1520));
                                                if (_e1525 || (((_e1515 <= _e1516) && (_e1517 <= _e1518)) && (_e1519 <= _e1520))) {
                                                    let _e1532 = select(-1f, 1f, _e1525);
                                                    let _e1534 = ((_e1515 - _e1516) * _e1532);
                                                    let _e1536 = select(0f, _e1534, (_e1534 > 0f));
                                                    let _e1538 = ((_e1517 - _e1518) * _e1532);
                                                    let _e1540 = select(0f, _e1538, (_e1538 > 0f));
                                                    let _e1542 = ((_e1519 - _e1520) * _e1532);
                                                    let _e1544 = select(0f, _e1542, (_e1542 > 0f));
                                                    let _e1546 = ((_e1536 + _e1540) + _e1544);
                                                    if (_e1546 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2262_ = type_24();
                                                        phi_2263_ = true;
                                                    } else {
                                                        let _e1549 = select(_e1473[1][0], _e1473[0][0], (_e1473[0][0] < _e1473[1][0]));
                                                        let _e1553 = select(_e1473[1][0], _e1473[0][0], (_e1473[0][0] > _e1473[1][0]));
                                                        let _e1557 = select(_e1473[1][1], _e1473[0][1], (_e1473[0][1] < _e1473[1][1]));
                                                        let _e1561 = select(_e1473[1][1], _e1473[0][1], (_e1473[0][1] > _e1473[1][1]));
                                                        let _e1565 = select(_e1473[1][2], _e1473[0][2], (_e1473[0][2] < _e1473[1][2]));
                                                        let _e1569 = select(_e1473[1][2], _e1473[0][2], (_e1473[0][2] > _e1473[1][2]));
                                                        let _e1574 = ((select(_e1473[2][0], _e1549, (_e1549 < _e1473[2][0])) - _e331) * _e336);
                                                        let _e1575 = ((select(_e1473[2][0], _e1553, (_e1553 > _e1473[2][0])) - _e332) * _e336);
                                                        let _e1578 = ((select(_e1473[2][1], _e1557, (_e1557 < _e1473[2][1])) - _e369) * _e374);
                                                        let _e1579 = ((select(_e1473[2][1], _e1561, (_e1561 > _e1473[2][1])) - _e370) * _e374);
                                                        let _e1582 = ((select(_e1473[2][2], _e1565, (_e1565 < _e1473[2][2])) - _e407) * _e412);
                                                        let _e1583 = ((select(_e1473[2][2], _e1569, (_e1569 > _e1473[2][2])) - _e408) * _e412);
                                                        let _e1585 = select(_e1583, _e1582, (_e1582 < _e1583));
                                                        let _e1587 = select(_e1583, _e1582, (_e1582 > _e1583));
                                                        let _e1589 = select(_e1575, _e1574, (_e1574 < _e1575));
                                                        let _e1591 = select(_e1579, _e1578, (_e1578 < _e1579));
                                                        let _e1593 = select(_e1591, _e1589, (_e1589 > _e1591));
                                                        let _e1595 = select(_e1585, _e1593, (_e1593 > _e1585));
                                                        let _e1597 = select(_e1575, _e1574, (_e1574 > _e1575));
                                                        let _e1599 = select(_e1579, _e1578, (_e1578 > _e1579));
                                                        let _e1601 = select(_e1599, _e1597, (_e1597 < _e1599));
                                                        let _e1603 = select(_e1587, _e1601, (_e1601 < _e1587));
                                                        let _e1604 = -(_e1585);
                                                        let _e1610 = select(_e459, _e1595, (_e1595 > _e459));
                                                        if (_e1610 > (_e1603 + (select(_e1604, _e1587, (_e1587 > _e1604)) * 0.0000019073523f))) {
                                                            phi_2257_ = type_24();
                                                            phi_2258_ = true;
                                                        } else {
                                                            let _e1612 = (_e1610 > _e1038.member.member_1);
                                                            if _e1612 {
                                                                phi_2256_ = type_24();
                                                            } else {
                                                                let _e1616 = (_e1473[1][0] - _e1473[0][0]);
                                                                let _e1617 = (_e1473[1][1] - _e1473[0][1]);
                                                                let _e1618 = (_e1473[1][2] - _e1473[0][2]);
                                                                let _e1619 = vec3<f32>(_e1616, _e1617, _e1618);
                                                                let _e1620 = (_e1473[2][0] - _e1473[1][0]);
                                                                let _e1621 = (_e1473[2][1] - _e1473[1][1]);
                                                                let _e1622 = (_e1473[2][2] - _e1473[1][2]);
                                                                let _e1623 = vec3<f32>(_e1620, _e1621, _e1622);
                                                                let _e1624 = (_e1473[0][0] - _e1473[2][0]);
                                                                let _e1625 = (_e1473[0][1] - _e1473[2][1]);
                                                                let _e1626 = (_e1473[0][2] - _e1473[2][2]);
                                                                let _e1627 = vec3<f32>(_e1624, _e1625, _e1626);
                                                                let _e1630 = bitcast<f32>((bitcast<u32>(_e1616) & 2147483647u));
                                                                let _e1633 = bitcast<f32>((bitcast<u32>(_e1617) & 2147483647u));
                                                                let _e1635 = select(_e1633, _e1630, (_e1630 > _e1633));
                                                                let _e1638 = bitcast<f32>((bitcast<u32>(_e1618) & 2147483647u));
                                                                let _e1640 = select(_e1638, _e1635, (_e1635 > _e1638));
                                                                let _e1643 = bitcast<f32>((bitcast<u32>(_e1620) & 2147483647u));
                                                                let _e1646 = bitcast<f32>((bitcast<u32>(_e1621) & 2147483647u));
                                                                let _e1648 = select(_e1646, _e1643, (_e1643 > _e1646));
                                                                let _e1651 = bitcast<f32>((bitcast<u32>(_e1622) & 2147483647u));
                                                                let _e1653 = select(_e1651, _e1648, (_e1648 > _e1651));
                                                                let _e1656 = bitcast<f32>((bitcast<u32>(_e1624) & 2147483647u));
                                                                let _e1659 = bitcast<f32>((bitcast<u32>(_e1625) & 2147483647u));
                                                                let _e1661 = select(_e1659, _e1656, (_e1656 > _e1659));
                                                                let _e1664 = bitcast<f32>((bitcast<u32>(_e1626) & 2147483647u));
                                                                let _e1666 = select(_e1664, _e1661, (_e1661 > _e1664));
                                                                let _e1668 = select(_e1653, _e1640, (_e1640 > _e1653));
                                                                let _e1670 = select(_e1666, _e1668, (_e1668 > _e1666));
                                                                if (_e1640 == _e1670) {
                                                                    phi_2167_ = _e1623;
                                                                    phi_2168_ = _e1627;
                                                                } else {
                                                                    let _e1673 = vec3((_e1653 == _e1670));
                                                                    phi_2167_ = select(_e1619, _e1627, _e1673);
                                                                    phi_2168_ = select(_e1623, _e1619, _e1673);
                                                                }
                                                                let _e1677 = phi_2167_;
                                                                let _e1679 = phi_2168_;
                                                                let _e1686 = ((_e1677.y * _e1679.z) - (_e1679.y * _e1677.z));
                                                                let _e1691 = ((_e1677.z * _e1679.x) - (_e1679.z * _e1677.x));
                                                                let _e1694 = ((_e1677.x * _e1679.y) - (_e1679.x * _e1677.y));
                                                                if (_e1536 >= _e1540) {
                                                                    phi_2199_ = select(true, false, (_e1536 >= _e1544));
                                                                } else {
                                                                    phi_2199_ = true;
                                                                }
                                                                let _e1699 = phi_2199_;
                                                                if _e1699 {
                                                                    phi_2208_ = select(vec3<f32>(_e1473[2][0], _e1473[2][1], _e1473[2][2]), vec3<f32>(_e1473[1][0], _e1473[1][1], _e1473[1][2]), vec3((_e1540 >= _e1544)));
                                                                } else {
                                                                    phi_2208_ = vec3<f32>(_e1473[0][0], _e1473[0][1], _e1473[0][2]);
                                                                }
                                                                let _e1704 = phi_2208_;
                                                                let _e1721 = ((((_e1686 * (_e1704.x - _e308)) + (_e1691 * (_e1704.y - _e347))) + (_e1694 * (_e1704.z - _e385))) / (((_e1686 * _e333) + (_e1691 * _e371)) + (_e1694 * _e409)));
                                                                let _e1723 = select(_e1603, _e1721, (_e1721 < _e1603));
                                                                let _e1725 = select(_e1595, _e1723, (_e1723 > _e1595));
                                                                if (_e1725 >= _e459) {
                                                                    let _e1727 = (_e1725 <= _e1038.member.member_1);
                                                                    if _e1727 {
                                                                        let _e1728 = (1f / _e1546);
                                                                        phi_2248_ = type_24(_e1725, (_e1540 * _e1728), (_e1544 * _e1728), _e1104);
                                                                    } else {
                                                                        phi_2248_ = type_24();
                                                                    }
                                                                    let _e1733 = phi_2248_;
                                                                    phi_2250_ = _e1733;
                                                                    phi_2251_ = select(true, false, _e1727);
                                                                } else {
                                                                    phi_2250_ = type_24();
                                                                    phi_2251_ = true;
                                                                }
                                                                let _e1736 = phi_2250_;
                                                                let _e1738 = phi_2251_;
                                                                if _e1738 {
                                                                    phi_2255_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2255_ = _e1736;
                                                                }
                                                                let _e1740 = phi_2255_;
                                                                phi_2256_ = _e1740;
                                                            }
                                                            let _e1742 = phi_2256_;
                                                            phi_2257_ = _e1742;
                                                            phi_2258_ = _e1612;
                                                        }
                                                        let _e1744 = phi_2257_;
                                                        let _e1746 = phi_2258_;
                                                        phi_2262_ = _e1744;
                                                        phi_2263_ = _e1746;
                                                    }
                                                    let _e1748 = phi_2262_;
                                                    let _e1750 = phi_2263_;
                                                    phi_2267_ = _e1748;
                                                    phi_2268_ = _e1750;
                                                } else {
                                                    phi_2267_ = type_24();
                                                    phi_2268_ = true;
                                                }
                                                let _e1752 = phi_2267_;
                                                let _e1754 = phi_2268_;
                                                if _e1754 {
                                                    phi_2272_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2272_ = _e1752;
                                                }
                                                let _e1756 = phi_2272_;
                                                if (_e1756.member_3 != 4294967295u) {
                                                    if (_e1104 != 4294967295u) {
                                                        if (_e1756.member < _e1038.member.member.member) {
                                                            phi_2298_ = true;
                                                        } else {
                                                            if (_e1756.member == _e1038.member.member.member) {
                                                                phi_2297_ = (_e1756.member_3 < _e1038.member.member.member_3);
                                                            } else {
                                                                phi_2297_ = false;
                                                            }
                                                            let _e1771 = phi_2297_;
                                                            phi_2298_ = _e1771;
                                                        }
                                                        let _e1773 = phi_2298_;
                                                        if _e1773 {
                                                            phi_2305_ = type_39(type_32(_e1756, _e1756.member), _e1065.member_1, _e1065.member_2);
                                                        } else {
                                                            phi_2305_ = _e1065;
                                                        }
                                                        let _e1780 = phi_2305_;
                                                        phi_2306_ = _e1780;
                                                    } else {
                                                        phi_2306_ = _e1065;
                                                    }
                                                    let _e1782 = phi_2306_;
                                                    phi_2307_ = _e1782;
                                                } else {
                                                    phi_2307_ = _e1065;
                                                }
                                                let _e1784 = phi_2307_;
                                                phi_975_ = _e1784;
                                            } else {
                                                phi_975_ = type_39();
                                            }
                                            let _e1786 = phi_975_;
                                            continue;
                                            continuing {
                                                phi_974_ = _e1786;
                                                phi_977_ = _e1053;
                                                phi_3770_ = _e502;
                                                break if !(_e1059);
                                            }
                                        }
                                        let _e1789 = phi_3770_;
                                        phi_3931_ = _e1789;
                                        if _e1789 {
                                            break;
                                        }
                                        phi_3935_ = _e1789;
                                        let _e1976 = local_12;
                                        phi_3550_ = _e1976;
                                        phi_3551_ = _e544;
                                        phi_3552_ = false;
                                        phi_3553_ = _e548;
                                    } else {
                                        if (_e544.member_1 >= _e88) {
                                            phi_3106_ = type_51(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_50(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_50(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e544.member_1 < _e88) {
                                            } else {
                                                phi_3931_ = true;
                                                break;
                                            }
                                            let _e566 = (_e259 * 2u);
                                            let _e568 = ((1u + _e566) % 7u);
                                            if (_e568 < 7u) {
                                            } else {
                                                phi_3931_ = true;
                                                break;
                                            }
                                            let _e573 = global_4.member[_e544.member_1][_e568];
                                            let _e575 = ((_e566 + 2u) % 7u);
                                            if (_e575 < 7u) {
                                            } else {
                                                phi_3931_ = true;
                                                break;
                                            }
                                            let _e580 = global_4.member[_e544.member_1][_e575];
                                            let _e581 = (_e258 * 2u);
                                            let _e583 = ((1u + _e581) % 7u);
                                            if (_e583 < 7u) {
                                            } else {
                                                phi_3931_ = true;
                                                break;
                                            }
                                            let _e588 = global_4.member[_e544.member_1][_e583];
                                            let _e590 = ((_e581 + 2u) % 7u);
                                            if (_e590 < 7u) {
                                            } else {
                                                phi_3931_ = true;
                                                break;
                                            }
                                            let _e595 = global_4.member[_e544.member_1][_e590];
                                            let _e596 = (_e260 * 2u);
                                            let _e598 = ((1u + _e596) % 7u);
                                            if (_e598 < 7u) {
                                            } else {
                                                phi_3931_ = true;
                                                break;
                                            }
                                            let _e603 = global_4.member[_e544.member_1][_e598];
                                            let _e605 = ((_e596 + 2u) % 7u);
                                            if (_e605 < 7u) {
                                            } else {
                                                phi_3931_ = true;
                                                break;
                                            }
                                            let _e610 = global_4.member[_e544.member_1][_e605];
                                            let _e633 = (bitcast<f32>((bitcast<u32>((_e544.member.member_1.x - _e544.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e634 = (bitcast<f32>((bitcast<u32>((_e544.member.member_1.y - _e544.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e635 = (bitcast<f32>((bitcast<u32>((_e544.member.member_1.z - _e544.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e637 = select(_e139, _e633, (_e633 > _e139));
                                            let _e639 = select(_e139, _e634, (_e634 > _e139));
                                            let _e641 = select(_e139, _e635, (_e635 > _e139));
                                            let _e666 = bitcast<u32>((f32(bitcast<i32>((_e573 & 2097151u))) * _e637));
                                            let _e671 = (bitcast<i32>((_e573 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e674 = bitcast<f32>((_e666 & bitcast<u32>(_e671)));
                                            let _e675 = bitcast<u32>((f32(bitcast<i32>((_e588 & 2097151u))) * _e639));
                                            let _e680 = (bitcast<i32>((_e588 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e683 = bitcast<f32>((_e675 & bitcast<u32>(_e680)));
                                            let _e684 = bitcast<u32>((f32(bitcast<i32>((_e603 & 2097151u))) * _e641));
                                            let _e689 = (bitcast<i32>((_e603 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e692 = bitcast<f32>((_e684 & bitcast<u32>(_e689)));
                                            let _e696 = bitcast<f32>((_e666 & bitcast<u32>(~(_e671))));
                                            let _e700 = bitcast<f32>((_e675 & bitcast<u32>(~(_e680))));
                                            let _e704 = bitcast<f32>((_e684 & bitcast<u32>(~(_e689))));
                                            let _e705 = bitcast<u32>((f32(bitcast<i32>((_e580 & 2097151u))) * _e637));
                                            let _e710 = (bitcast<i32>((_e580 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e713 = bitcast<f32>((_e705 & bitcast<u32>(_e710)));
                                            let _e714 = bitcast<u32>((f32(bitcast<i32>((_e595 & 2097151u))) * _e639));
                                            let _e719 = (bitcast<i32>((_e595 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e722 = bitcast<f32>((_e714 & bitcast<u32>(_e719)));
                                            let _e723 = bitcast<u32>((f32(bitcast<i32>((_e610 & 2097151u))) * _e641));
                                            let _e728 = (bitcast<i32>((_e610 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e731 = bitcast<f32>((_e723 & bitcast<u32>(_e728)));
                                            let _e735 = bitcast<f32>((_e705 & bitcast<u32>(~(_e710))));
                                            let _e739 = bitcast<f32>((_e714 & bitcast<u32>(~(_e719))));
                                            let _e743 = bitcast<f32>((_e723 & bitcast<u32>(~(_e728))));
                                            let _e744 = (_e544.member.member.x + _e674);
                                            let _e745 = (_e544.member.member.y + _e683);
                                            let _e746 = (_e544.member.member.z + _e692);
                                            let _e749 = (_e544.member.member_1.x - _e713);
                                            let _e750 = (_e544.member.member_1.y - _e722);
                                            let _e751 = (_e544.member.member_1.z - _e731);
                                            let _e770 = (_e749 - _e744);
                                            let _e771 = (_e750 - _e745);
                                            let _e772 = (_e751 - _e746);
                                            let _e774 = select(_e771, _e770, (_e770 > _e771));
                                            let _e776 = select(_e772, _e774, (_e774 > _e772));
                                            if (_e776 < (1024f * _e139)) {
                                                phi_2807_ = 0u;
                                            } else {
                                                phi_2807_ = select(2u, 1u, (_e776 < (2097152f * _e139)));
                                            }
                                            let _e783 = phi_2807_;
                                            switch bitcast<i32>(_e783) {
                                                case 0: {
                                                    phi_2813_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_2813_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_2813_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_2813_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e786 = phi_2813_;
                                            let _e792 = global_4.member[_e544.member_1][0u];
                                            let _e796 = global_4.member[_e544.member_1][2u];
                                            let _e800 = global_4.member[_e544.member_1][4u];
                                            let _e804 = global_4.member[_e544.member_1][6u];
                                            let _e816 = (((_e796 >> bitcast<u32>(22i)) | ((_e800 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e804 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e817 = (_e792 & 268435455u);
                                            let _e818 = (_e816 & 268435455u);
                                            let _e821 = ((_e792 >> bitcast<u32>(28u)) & 7u);
                                            let _e829 = ((_e792 >> bitcast<u32>(31i)) | (((_e816 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e830 = (_e821 != 0u);
                                            if (_e821 == 0u) {
                                                phi_3068_ = _e817;
                                            } else {
                                                if (_e821 == 7u) {
                                                    phi_3067_ = 2147483648u;
                                                } else {
                                                    phi_3067_ = ((2147483648u | (_e821 << bitcast<u32>(28u))) | (_e818 & 268435455u));
                                                }
                                                let _e839 = phi_3067_;
                                                phi_3068_ = _e839;
                                            }
                                            let _e841 = phi_3068_;
                                            if _e830 {
                                                let _e842 = (_e821 != 7u);
                                                if _e842 {
                                                    phi_3078_ = (_e818 + (_e821 * ((3u * _e786) + 1u)));
                                                } else {
                                                    phi_3078_ = u32();
                                                }
                                                let _e846 = phi_3078_;
                                                phi_3080_ = _e846;
                                                phi_3081_ = select(true, false, _e842);
                                            } else {
                                                phi_3080_ = u32();
                                                phi_3081_ = true;
                                            }
                                            let _e849 = phi_3080_;
                                            let _e851 = phi_3081_;
                                            if (_e829 == 0u) {
                                                phi_3102_ = (_e817 + select(0u, 1u, !(_e830)));
                                            } else {
                                                if (_e829 == 7u) {
                                                    phi_3101_ = 2147483648u;
                                                } else {
                                                    phi_3101_ = ((2147483648u | (_e829 << bitcast<u32>(28u))) | (select(_e849, _e818, _e851) & 268435455u));
                                                }
                                                let _e864 = phi_3101_;
                                                phi_3102_ = _e864;
                                            }
                                            let _e866 = phi_3102_;
                                            phi_3106_ = type_51(array<vec4<f32>, 3>(vec4<f32>(_e744, (_e544.member.member.x + _e696), _e749, (_e544.member.member_1.x - _e735)), vec4<f32>(_e745, (_e544.member.member.y + _e700), _e750, (_e544.member.member_1.y - _e739)), vec4<f32>(_e746, (_e544.member.member.z + _e704), _e751, (_e544.member.member_1.z - _e743))), type_50(type_28((_e544.member.member + vec4<f32>(_e674, _e683, _e692, 0f)), (_e544.member.member_1 - vec4<f32>(_e713, _e722, _e731, 0f))), _e841), type_50(type_28((_e544.member.member + vec4<f32>(_e696, _e700, _e704, 0f)), (_e544.member.member_1 - vec4<f32>(_e735, _e739, _e743, 0f))), _e866));
                                        }
                                        let _e871 = phi_3106_;
                                        let _e884 = ((_e871.member[0].x - _e331) * _e336);
                                        let _e885 = ((_e871.member[0].y - _e331) * _e336);
                                        let _e886 = ((_e871.member[0].z - _e332) * _e336);
                                        let _e887 = ((_e871.member[0].w - _e332) * _e336);
                                        let _e897 = ((_e871.member[1].x - _e369) * _e374);
                                        let _e898 = ((_e871.member[1].y - _e369) * _e374);
                                        let _e899 = ((_e871.member[1].z - _e370) * _e374);
                                        let _e900 = ((_e871.member[1].w - _e370) * _e374);
                                        let _e910 = ((_e871.member[2].x - _e407) * _e412);
                                        let _e911 = ((_e871.member[2].y - _e407) * _e412);
                                        let _e912 = ((_e871.member[2].z - _e408) * _e412);
                                        let _e913 = ((_e871.member[2].w - _e408) * _e412);
                                        let _e915 = select(_e912, _e910, (_e910 < _e912));
                                        let _e917 = select(_e913, _e911, (_e911 < _e913));
                                        let _e919 = select(_e912, _e910, (_e910 > _e912));
                                        let _e921 = select(_e913, _e911, (_e911 > _e913));
                                        let _e923 = select(_e886, _e884, (_e884 < _e886));
                                        let _e925 = select(_e887, _e885, (_e885 < _e887));
                                        let _e927 = select(_e899, _e897, (_e897 < _e899));
                                        let _e929 = select(_e900, _e898, (_e898 < _e900));
                                        let _e931 = select(_e927, _e923, (_e923 > _e927));
                                        let _e933 = select(_e929, _e925, (_e925 > _e929));
                                        let _e935 = select(_e915, _e931, (_e931 > _e915));
                                        let _e937 = select(_e917, _e933, (_e933 > _e917));
                                        let _e939 = select(_e886, _e884, (_e884 > _e886));
                                        let _e941 = select(_e887, _e885, (_e885 > _e887));
                                        let _e943 = select(_e899, _e897, (_e897 > _e899));
                                        let _e945 = select(_e900, _e898, (_e898 > _e900));
                                        let _e947 = select(_e943, _e939, (_e939 < _e943));
                                        let _e949 = select(_e945, _e941, (_e941 < _e945));
                                        let _e954 = -(_e915);
                                        let _e955 = -(_e917);
                                        let _e962 = (select(_e919, _e947, (_e947 < _e919)) + (select(_e954, _e919, (_e919 > _e954)) * 0.0000019073523f));
                                        let _e963 = (select(_e921, _e949, (_e949 < _e921)) + (select(_e955, _e921, (_e921 > _e955)) * 0.0000019073523f));
                                        let _e965 = select(_e459, _e935, (_e935 > _e459));
                                        let _e967 = select(_e459, _e937, (_e937 > _e459));
                                        let _e972 = (_e965 <= select(_e504.member.member_1, _e962, (_e962 < _e504.member.member_1)));
                                        let _e973 = (_e967 <= select(_e504.member.member_1, _e963, (_e963 < _e504.member.member_1)));
                                        let _e974 = (_e965 <= _e967);
                                        if _e972 {
                                            if _e973 {
                                                if _e974 {
                                                    phi_3450_ = _e871.member_2;
                                                } else {
                                                    phi_3450_ = _e871.member_1;
                                                }
                                                let _e978 = phi_3450_;
                                                let _e1000 = (_e548 % 128u);
                                                let _e1001 = (_e1000 < 128u);
                                                if _e1001 {
                                                } else {
                                                    phi_3931_ = true;
                                                    break;
                                                }
                                                local_8[_e1000] = _e978.member_1;
                                                if _e1001 {
                                                } else {
                                                    phi_3931_ = true;
                                                    break;
                                                }
                                                local_7[_e1000] = _e978.member.member.x;
                                                if _e1001 {
                                                } else {
                                                    phi_3931_ = true;
                                                    break;
                                                }
                                                local_6[_e1000] = _e978.member.member.y;
                                                if _e1001 {
                                                } else {
                                                    phi_3931_ = true;
                                                    break;
                                                }
                                                local_5[_e1000] = _e978.member.member.z;
                                                if _e1001 {
                                                } else {
                                                    phi_3931_ = true;
                                                    break;
                                                }
                                                local_4[_e1000] = _e978.member.member_1.x;
                                                if _e1001 {
                                                } else {
                                                    phi_3931_ = true;
                                                    break;
                                                }
                                                local_3[_e1000] = _e978.member.member_1.y;
                                                if _e1001 {
                                                } else {
                                                    phi_3931_ = true;
                                                    break;
                                                }
                                                local_2[_e1000] = _e978.member.member_1.z;
                                                if _e1001 {
                                                } else {
                                                    phi_3931_ = true;
                                                    break;
                                                }
                                                local_9[_e1000] = select(_e967, _e965, (_e965 > _e967));
                                                if _e974 {
                                                    phi_3527_ = _e871.member_1;
                                                } else {
                                                    phi_3527_ = _e871.member_2;
                                                }
                                                let _e1014 = phi_3527_;
                                                phi_3528_ = _e1014;
                                                phi_3529_ = (_e548 + 1u);
                                            } else {
                                                phi_3528_ = type_50();
                                                phi_3529_ = u32();
                                            }
                                            let _e1016 = phi_3528_;
                                            let _e1018 = phi_3529_;
                                            phi_3531_ = _e1016;
                                            phi_3532_ = _e1018;
                                            phi_3533_ = select(true, false, _e973);
                                        } else {
                                            phi_3531_ = type_50();
                                            phi_3532_ = u32();
                                            phi_3533_ = true;
                                        }
                                        let _e1021 = phi_3531_;
                                        let _e1023 = phi_3532_;
                                        let _e1025 = phi_3533_;
                                        if _e1025 {
                                            if _e972 {
                                                phi_3542_ = _e871.member_1;
                                            } else {
                                                phi_3542_ = _e871.member_2;
                                            }
                                            let _e1029 = phi_3542_;
                                            phi_3547_ = _e1029;
                                            phi_3548_ = select(_e973, true, _e972);
                                        } else {
                                            phi_3547_ = _e1021;
                                            phi_3548_ = _e546;
                                        }
                                        let _e1032 = phi_3547_;
                                        let _e1034 = phi_3548_;
                                        phi_3935_ = _e502;
                                        phi_3550_ = type_39(_e504.member, (_e504.member_1 + 1u), _e504.member_2);
                                        phi_3551_ = _e1032;
                                        phi_3552_ = _e1034;
                                        phi_3553_ = select(_e1023, _e548, _e1025);
                                    }
                                    let _e1791 = phi_3935_;
                                    let _e1793 = phi_3550_;
                                    let _e1795 = phi_3551_;
                                    let _e1797 = phi_3552_;
                                    let _e1799 = phi_3553_;
                                    phi_3934_ = _e1791;
                                    phi_3554_ = _e1793;
                                    phi_3555_ = _e1795;
                                    phi_3556_ = (_e508 - 1u);
                                    phi_3557_ = _e1797;
                                    phi_3558_ = _e1799;
                                } else {
                                    phi_3934_ = _e502;
                                    phi_3554_ = _e504;
                                    phi_3555_ = _e544;
                                    phi_3556_ = _e508;
                                    phi_3557_ = _e546;
                                    phi_3558_ = _e548;
                                }
                                let _e1801 = phi_3934_;
                                let _e1803 = phi_3554_;
                                let _e1805 = phi_3555_;
                                let _e1807 = phi_3556_;
                                let _e1809 = phi_3557_;
                                let _e1811 = phi_3558_;
                                phi_3933_ = _e1801;
                                phi_3559_ = _e1803;
                                phi_3560_ = _e1805;
                                phi_3561_ = _e1807;
                                phi_3562_ = _e1809;
                                phi_3563_ = _e1811;
                            } else {
                                phi_3933_ = _e502;
                                phi_3559_ = type_39();
                                phi_3560_ = type_50();
                                phi_3561_ = u32();
                                phi_3562_ = bool();
                                phi_3563_ = u32();
                            }
                            let _e1813 = phi_3933_;
                            let _e1815 = phi_3559_;
                            let _e1817 = phi_3560_;
                            let _e1819 = phi_3561_;
                            let _e1821 = phi_3562_;
                            let _e1823 = phi_3563_;
                            phi_3932_ = _e1813;
                            phi_848_ = _e1815;
                            phi_851_ = _e1817;
                            phi_853_ = _e1819;
                            phi_855_ = _e1821;
                            phi_857_ = _e1823;
                            phi_3564_ = _e516;
                        } else {
                            phi_3932_ = _e502;
                            phi_848_ = type_39();
                            phi_851_ = type_50();
                            phi_853_ = u32();
                            phi_855_ = bool();
                            phi_857_ = u32();
                            phi_3564_ = false;
                        }
                        let _e1825 = phi_3932_;
                        let _e1827 = phi_848_;
                        let _e1829 = phi_851_;
                        let _e1831 = phi_853_;
                        let _e1833 = phi_855_;
                        let _e1835 = phi_857_;
                        let _e1837 = phi_3564_;
                        continue;
                        continuing {
                            phi_3776_ = _e1825;
                            phi_847_ = _e1827;
                            phi_850_ = _e1829;
                            phi_852_ = _e1831;
                            phi_854_ = _e1833;
                            phi_856_ = _e1835;
                            phi_3931_ = _e1825;
                            break if !(_e1837);
                        }
                    }
                    let _e1840 = phi_3931_;
                    if _e1840 {
                        break;
                    }
                    let _e1842 = local_10;
                    let _e1845 = local_11;
                    if _e147 {
                    } else {
                        break;
                    }
                    global_6.member[_e145][0u] = _e1842.member_1;
                    global_6.member[_e145][1u] = _e1845.member_2;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_counted_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
