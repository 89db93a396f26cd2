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
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_21 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_24 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_32 {
    member: array<type_21>,
}

struct type_34 {
    member: f32,
    member_1: bool,
}

struct type_36 {
    member: array<vec4<u32>, 2>,
}

struct type_40 {
    member: array<array<u32, 7>>,
}

struct type_45 {
    member: type_24,
    member_1: u32,
}

struct type_46 {
    member: array<vec4<f32>, 3>,
    member_1: type_45,
    member_2: type_45,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_36;
@group(0) @binding(4) 
var<storage> global_3: type_32;
@group(0) @binding(5) 
var<storage, read_write> global_4: type_4;
@group(0) @binding(2) 
var<storage> global_5: type_40;
@group(0) @binding(3) 
var<storage> global_6: type_4;

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
    var phi_382_: i32;
    var phi_383_: i32;
    var phi_393_: bool;
    var phi_403_: u32;
    var phi_404_: u32;
    var phi_406_: bool;
    var phi_411_: u32;
    var phi_423_: i32;
    var phi_443_: i32;
    var phi_461_: f32;
    var phi_467_: f32;
    var phi_478_: f32;
    var phi_484_: f32;
    var phi_507_: f32;
    var phi_518_: f32;
    var phi_527_: f32;
    var phi_533_: f32;
    var phi_544_: f32;
    var phi_550_: f32;
    var phi_573_: f32;
    var phi_584_: f32;
    var phi_593_: f32;
    var phi_599_: f32;
    var phi_610_: f32;
    var phi_616_: f32;
    var phi_639_: f32;
    var phi_650_: f32;
    var phi_750_: f32;
    var phi_751_: f32;
    var phi_3739_: bool;
    var phi_840_: type_34;
    var phi_843_: type_45;
    var phi_845_: u32;
    var phi_847_: bool;
    var phi_849_: u32;
    var phi_860_: bool;
    var phi_946_: type_45;
    var phi_947_: bool;
    var phi_948_: u32;
    var phi_2772_: u32;
    var phi_2778_: u32;
    var phi_3032_: u32;
    var phi_3033_: u32;
    var phi_3043_: u32;
    var phi_3045_: u32;
    var phi_3046_: bool;
    var phi_3066_: u32;
    var phi_3067_: u32;
    var phi_3071_: type_46;
    var phi_3415_: type_45;
    var phi_3492_: type_45;
    var phi_3493_: type_45;
    var phi_3494_: u32;
    var phi_3496_: type_45;
    var phi_3497_: u32;
    var phi_3498_: bool;
    var phi_3507_: type_45;
    var phi_3512_: type_45;
    var phi_3513_: bool;
    var phi_967_: type_34;
    var phi_970_: type_8;
    var phi_971_: type_8;
    var phi_993_: type_8;
    var phi_1034_: u32;
    var phi_1040_: u32;
    var phi_1050_: u32;
    var phi_1066_: u32;
    var phi_1099_: u32;
    var phi_1105_: u32;
    var phi_1532_: u32;
    var phi_1550_: u32;
    var phi_1568_: u32;
    var phi_1588_: u32;
    var phi_1606_: u32;
    var phi_1624_: u32;
    var phi_1644_: u32;
    var phi_1662_: u32;
    var phi_1680_: u32;
    var phi_1258_: u32;
    var phi_1273_: u32;
    var phi_1283_: u32;
    var phi_1303_: u32;
    var phi_1323_: u32;
    var phi_1349_: u32;
    var phi_1364_: u32;
    var phi_1374_: u32;
    var phi_1394_: u32;
    var phi_1414_: u32;
    var phi_1440_: u32;
    var phi_1455_: u32;
    var phi_1465_: u32;
    var phi_1485_: u32;
    var phi_1505_: u32;
    var phi_1129_: u32;
    var phi_1172_: u32;
    var phi_1215_: u32;
    var phi_1686_: array<array<f32, 3>, 3>;
    var phi_2157_: vec3<f32>;
    var phi_2158_: vec3<f32>;
    var phi_2189_: bool;
    var phi_2198_: vec3<f32>;
    var phi_2238_: type_20;
    var phi_2240_: type_20;
    var phi_2241_: bool;
    var phi_2245_: type_20;
    var phi_2246_: type_20;
    var phi_2247_: type_20;
    var phi_2248_: bool;
    var phi_2252_: type_20;
    var phi_2253_: bool;
    var phi_2257_: type_20;
    var phi_2258_: bool;
    var phi_2262_: type_20;
    var phi_2273_: type_34;
    var phi_2274_: type_34;
    var phi_968_: type_34;
    var phi_3733_: bool;
    var local_10: type_34;
    var phi_3895_: bool;
    var phi_3515_: type_34;
    var phi_3516_: type_45;
    var phi_3517_: bool;
    var phi_3518_: u32;
    var phi_3894_: bool;
    var phi_3519_: type_34;
    var phi_3520_: type_45;
    var phi_3521_: u32;
    var phi_3522_: bool;
    var phi_3523_: u32;
    var phi_3893_: bool;
    var phi_3524_: type_34;
    var phi_3525_: type_45;
    var phi_3526_: u32;
    var phi_3527_: bool;
    var phi_3528_: u32;
    var phi_3892_: bool;
    var phi_841_: type_34;
    var phi_844_: type_45;
    var phi_846_: u32;
    var phi_848_: bool;
    var phi_850_: u32;
    var phi_3529_: bool;
    var phi_3891_: bool;
    var local_11: type_34;
    var local_12: type_34;

    switch bitcast<i32>(0u) {
        default: {
            let _e86 = global;
            let _e88 = arrayLength((&global_5.member));
            let _e91 = arrayLength((&global_6.member));
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
                let _e147 = (_e145 < arrayLength((&global_4.member)));
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
                            phi_382_ = (bitcast<i32>((_e224 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_382_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e224)), 32u, (_e224 == 0u))));
                        }
                        let _e238 = phi_382_;
                        phi_383_ = _e238;
                    } else {
                        phi_383_ = 0i;
                    }
                    let _e240 = phi_383_;
                    let _e241 = (_e157 == _e196);
                    if _e241 {
                        phi_393_ = true;
                    } else {
                        phi_393_ = (_e164 == _e196);
                    }
                    let _e244 = phi_393_;
                    let _e245 = select(1u, 0u, _e241);
                    if _e244 {
                        let _e246 = (_e245 + 1u);
                        phi_403_ = _e246;
                        phi_404_ = _e246;
                        phi_406_ = select(true, false, (_e246 == 2u));
                    } else {
                        phi_403_ = u32();
                        phi_404_ = 0u;
                        phi_406_ = true;
                    }
                    let _e250 = phi_403_;
                    let _e252 = phi_404_;
                    let _e254 = phi_406_;
                    if _e254 {
                        phi_411_ = (_e252 + 1u);
                    } else {
                        phi_411_ = 0u;
                    }
                    let _e258 = phi_411_;
                    let _e259 = select(_e250, _e252, _e254);
                    let _e260 = select(_e245, select(2u, _e245, _e244), _e254);
                    if (_e127 < -126i) {
                        phi_423_ = -126i;
                    } else {
                        phi_423_ = select(_e127, 127i, (_e127 > 127i));
                    }
                    let _e265 = phi_423_;
                    let _e270 = bitcast<f32>((bitcast<u32>((_e265 + 127i)) << bitcast<u32>(23i)));
                    let _e276 = bitcast<f32>((bitcast<u32>(((_e127 - _e265) + 127i)) << bitcast<u32>(23i)));
                    let _e277 = -(_e240);
                    if (_e277 < -126i) {
                        phi_443_ = -126i;
                    } else {
                        phi_443_ = select(_e277, 127i, (_e277 > 127i));
                    }
                    let _e282 = phi_443_;
                    let _e287 = bitcast<f32>((bitcast<u32>((_e282 + 127i)) << bitcast<u32>(23i)));
                    let _e293 = bitcast<f32>((bitcast<u32>(((_e277 - _e282) + 127i)) << bitcast<u32>(23i)));
                    let _e297 = global_3.member[_e145].member;
                    let _e298 = (_e259 == 0u);
                    if _e298 {
                        phi_461_ = _e297[0];
                    } else {
                        phi_461_ = _e297[1];
                    }
                    let _e302 = phi_461_;
                    let _e303 = (_e259 == 2u);
                    if _e303 {
                        phi_467_ = _e297[2];
                    } else {
                        phi_467_ = _e302;
                    }
                    let _e306 = phi_467_;
                    let _e308 = ((_e306 * _e270) * _e276);
                    let _e309 = global_3.member[_e145].member_2;
                    if _e298 {
                        phi_478_ = _e309[0];
                    } else {
                        phi_478_ = _e309[1];
                    }
                    let _e313 = phi_478_;
                    if _e303 {
                        phi_484_ = _e309[2];
                    } else {
                        phi_484_ = _e313;
                    }
                    let _e316 = phi_484_;
                    let _e318 = ((_e316 * _e287) * _e293);
                    let _e322 = (bitcast<f32>((bitcast<u32>(_e318) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e322 {
                        let _e326 = (bitcast<f32>((bitcast<u32>(_e308) & 2147483647u)) * 0.00000011920929f);
                        phi_507_ = select(0.00000000000011368684f, _e326, (_e326 > 0.00000000000011368684f));
                    } else {
                        phi_507_ = 0f;
                    }
                    let _e330 = phi_507_;
                    let _e331 = (_e308 + _e330);
                    let _e332 = (_e308 - _e330);
                    let _e333 = select(_e318, 0f, _e322);
                    if _e322 {
                        phi_518_ = 38685626000000000000000000f;
                    } else {
                        phi_518_ = (1f / _e318);
                    }
                    let _e336 = phi_518_;
                    let _e337 = (_e258 == 0u);
                    if _e337 {
                        phi_527_ = _e297[0];
                    } else {
                        phi_527_ = _e297[1];
                    }
                    let _e341 = phi_527_;
                    let _e342 = (_e258 == 2u);
                    if _e342 {
                        phi_533_ = _e297[2];
                    } else {
                        phi_533_ = _e341;
                    }
                    let _e345 = phi_533_;
                    let _e347 = ((_e345 * _e270) * _e276);
                    if _e337 {
                        phi_544_ = _e309[0];
                    } else {
                        phi_544_ = _e309[1];
                    }
                    let _e351 = phi_544_;
                    if _e342 {
                        phi_550_ = _e309[2];
                    } else {
                        phi_550_ = _e351;
                    }
                    let _e354 = phi_550_;
                    let _e356 = ((_e354 * _e287) * _e293);
                    let _e360 = (bitcast<f32>((bitcast<u32>(_e356) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e360 {
                        let _e364 = (bitcast<f32>((bitcast<u32>(_e347) & 2147483647u)) * 0.00000011920929f);
                        phi_573_ = select(0.00000000000011368684f, _e364, (_e364 > 0.00000000000011368684f));
                    } else {
                        phi_573_ = 0f;
                    }
                    let _e368 = phi_573_;
                    let _e369 = (_e347 + _e368);
                    let _e370 = (_e347 - _e368);
                    let _e371 = select(_e356, 0f, _e360);
                    if _e360 {
                        phi_584_ = 38685626000000000000000000f;
                    } else {
                        phi_584_ = (1f / _e356);
                    }
                    let _e374 = phi_584_;
                    let _e375 = (_e260 == 0u);
                    if _e375 {
                        phi_593_ = _e297[0];
                    } else {
                        phi_593_ = _e297[1];
                    }
                    let _e379 = phi_593_;
                    let _e380 = (_e260 == 2u);
                    if _e380 {
                        phi_599_ = _e297[2];
                    } else {
                        phi_599_ = _e379;
                    }
                    let _e383 = phi_599_;
                    let _e385 = ((_e383 * _e270) * _e276);
                    if _e375 {
                        phi_610_ = _e309[0];
                    } else {
                        phi_610_ = _e309[1];
                    }
                    let _e389 = phi_610_;
                    if _e380 {
                        phi_616_ = _e309[2];
                    } else {
                        phi_616_ = _e389;
                    }
                    let _e392 = phi_616_;
                    let _e394 = ((_e392 * _e287) * _e293);
                    let _e398 = (bitcast<f32>((bitcast<u32>(_e394) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e398 {
                        let _e402 = (bitcast<f32>((bitcast<u32>(_e385) & 2147483647u)) * 0.00000011920929f);
                        phi_639_ = select(0.00000000000011368684f, _e402, (_e402 > 0.00000000000011368684f));
                    } else {
                        phi_639_ = 0f;
                    }
                    let _e406 = phi_639_;
                    let _e407 = (_e385 + _e406);
                    let _e408 = (_e385 - _e406);
                    let _e409 = select(_e394, 0f, _e398);
                    if _e398 {
                        phi_650_ = 38685626000000000000000000f;
                    } else {
                        phi_650_ = (1f / _e394);
                    }
                    let _e412 = phi_650_;
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
                        phi_750_ = select(-340282350000000000000000000000000000000f, _e453, (_e453 > -340282350000000000000000000000000000000f));
                        phi_751_ = select(-340282350000000000000000000000000000000f, _e446, (_e446 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_750_ = 0f;
                        phi_751_ = 1f;
                    }
                    let _e457 = phi_750_;
                    let _e459 = phi_751_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e463 = (_e259 % 3u);
                    let _e464 = (_e463 < 3u);
                    if _e464 {
                    } else {
                        break;
                    }
                    let _e466 = local_1[_e463];
                    let _e469 = (_e258 % 3u);
                    let _e470 = (_e469 < 3u);
                    if _e470 {
                    } else {
                        break;
                    }
                    let _e472 = local_1[_e469];
                    let _e475 = (_e260 % 3u);
                    let _e476 = (_e475 < 3u);
                    if _e476 {
                    } else {
                        break;
                    }
                    let _e478 = local_1[_e475];
                    if _e464 {
                    } else {
                        break;
                    }
                    let _e483 = local[_e463];
                    if _e470 {
                    } else {
                        break;
                    }
                    let _e487 = local[_e469];
                    if _e476 {
                    } else {
                        break;
                    }
                    let _e491 = local[_e475];
                    phi_3739_ = false;
                    phi_840_ = type_34(_e457, false);
                    phi_843_ = type_45(type_24(vec4<f32>((f32(_e466) * _e139), (f32(_e472) * _e139), (f32(_e478) * _e139), 0f), vec4<f32>((f32(_e483) * _e139), (f32(_e487) * _e139), (f32(_e491) * _e139), 0f)), select(0u, 2147483648u, (_e88 == 0u)));
                    phi_845_ = ((3u * _e88) + 1u);
                    phi_847_ = (_e459 <= _e457);
                    phi_849_ = 0u;
                    loop {
                        let _e501 = phi_3739_;
                        let _e503 = phi_840_;
                        let _e505 = phi_843_;
                        let _e507 = phi_845_;
                        let _e509 = phi_847_;
                        let _e511 = phi_849_;
                        local_11 = _e503;
                        if _e509 {
                            phi_860_ = true;
                        } else {
                            phi_860_ = (_e511 > 0u);
                        }
                        let _e514 = phi_860_;
                        if _e514 {
                            let _e515 = (_e507 > 0u);
                            if _e515 {
                                if _e509 {
                                    phi_946_ = _e505;
                                    phi_947_ = _e509;
                                    phi_948_ = _e511;
                                } else {
                                    let _e516 = (_e511 - 1u);
                                    let _e517 = (_e516 % 128u);
                                    let _e518 = (_e517 < 128u);
                                    if _e518 {
                                    } else {
                                        phi_3891_ = true;
                                        break;
                                    }
                                    let _e520 = local_7[_e517];
                                    if _e518 {
                                    } else {
                                        phi_3891_ = true;
                                        break;
                                    }
                                    let _e522 = local_6[_e517];
                                    if _e518 {
                                    } else {
                                        phi_3891_ = true;
                                        break;
                                    }
                                    let _e524 = local_5[_e517];
                                    if _e518 {
                                    } else {
                                        phi_3891_ = true;
                                        break;
                                    }
                                    let _e526 = local_4[_e517];
                                    if _e518 {
                                    } else {
                                        phi_3891_ = true;
                                        break;
                                    }
                                    let _e528 = local_3[_e517];
                                    if _e518 {
                                    } else {
                                        phi_3891_ = true;
                                        break;
                                    }
                                    let _e530 = local_2[_e517];
                                    if _e518 {
                                    } else {
                                        phi_3891_ = true;
                                        break;
                                    }
                                    let _e535 = local_8[_e517];
                                    if _e518 {
                                    } else {
                                        phi_3891_ = true;
                                        break;
                                    }
                                    let _e538 = local_9[_e517];
                                    phi_946_ = type_45(type_24(vec4<f32>(_e520, _e522, _e524, 0f), vec4<f32>(_e526, _e528, _e530, 0f)), _e535);
                                    phi_947_ = (_e538 <= _e503.member);
                                    phi_948_ = _e516;
                                }
                                let _e542 = phi_946_;
                                let _e544 = phi_947_;
                                let _e546 = phi_948_;
                                if _e544 {
                                    let _e551 = (_e542.member_1 & 268435455u);
                                    if ((_e542.member_1 & 2147483648u) != 0u) {
                                        phi_967_ = _e503;
                                        phi_970_ = type_8(0u, ((_e542.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1029 = phi_967_;
                                            let _e1031 = phi_970_;
                                            local_10 = _e1029;
                                            local_12 = _e1029;
                                            if (_e1031.member < _e1031.member_1) {
                                                phi_971_ = type_8((_e1031.member + 1u), _e1031.member_1);
                                                phi_993_ = type_8(1u, _e1031.member);
                                            } else {
                                                phi_971_ = _e1031;
                                                phi_993_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1044 = phi_971_;
                                            let _e1046 = phi_993_;
                                            let _e1050 = (bitcast<i32>(_e1046.member) != 0i);
                                            if _e1050 {
                                                let _e1055 = (_e542.member.member_1.x - _e542.member.member.x);
                                                let _e1058 = (_e542.member.member_1.y - _e542.member.member.y);
                                                let _e1061 = (_e542.member.member_1.z - _e542.member.member.z);
                                                let _e1063 = select(_e1058, _e1055, (_e1055 > _e1058));
                                                let _e1065 = select(_e1061, _e1063, (_e1063 > _e1061));
                                                let _e1067 = (_e1065 < (1024f * _e139));
                                                if _e1067 {
                                                    phi_1034_ = 0u;
                                                } else {
                                                    phi_1034_ = select(2u, 1u, (_e1065 < (2097152f * _e139)));
                                                }
                                                let _e1072 = phi_1034_;
                                                switch bitcast<i32>(_e1072) {
                                                    case 0: {
                                                        phi_1040_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1040_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1040_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1040_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1075 = phi_1040_;
                                                switch bitcast<i32>(_e1072) {
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
                                                let _e1082 = phi_1050_;
                                                let _e1084 = ((_e551 + (_e1046.member_1 * ((3u * _e1075) + 1u))) + (3u * _e1082));
                                                let _e1085 = (_e1084 < _e91);
                                                if _e1085 {
                                                    if _e1085 {
                                                    } else {
                                                        phi_3733_ = true;
                                                        break;
                                                    }
                                                    let _e1087 = global_6.member[_e1084];
                                                    phi_1066_ = _e1087;
                                                } else {
                                                    phi_1066_ = 4294967295u;
                                                }
                                                let _e1089 = phi_1066_;
                                                if _e1067 {
                                                    phi_1099_ = 0u;
                                                } else {
                                                    phi_1099_ = select(2u, 1u, (_e1065 < (2097152f * _e139)));
                                                }
                                                let _e1094 = phi_1099_;
                                                switch bitcast<i32>(_e1094) {
                                                    case 0: {
                                                        phi_1105_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1105_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1105_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1105_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1097 = phi_1105_;
                                                let _e1101 = (_e551 + (_e1046.member_1 * ((3u * _e1097) + 1u)));
                                                switch bitcast<i32>(_e1094) {
                                                    case 0: {
                                                        let _e1367 = (_e1101 < _e91);
                                                        if _e1367 {
                                                            if _e1367 {
                                                            } else {
                                                                phi_3733_ = true;
                                                                break;
                                                            }
                                                            let _e1369 = global_6.member[_e1101];
                                                            phi_1129_ = _e1369;
                                                        } else {
                                                            phi_1129_ = 0u;
                                                        }
                                                        let _e1371 = phi_1129_;
                                                        let _e1373 = ((10u * _e259) & 31u);
                                                        let _e1382 = ((10u * _e258) & 31u);
                                                        let _e1391 = ((10u * _e260) & 31u);
                                                        let _e1400 = (_e1101 + 1u);
                                                        let _e1401 = (_e1400 < _e91);
                                                        if _e1401 {
                                                            if _e1401 {
                                                            } else {
                                                                phi_3733_ = true;
                                                                break;
                                                            }
                                                            let _e1403 = global_6.member[_e1400];
                                                            phi_1172_ = _e1403;
                                                        } else {
                                                            phi_1172_ = 0u;
                                                        }
                                                        let _e1405 = phi_1172_;
                                                        let _e1428 = (_e1101 + 2u);
                                                        let _e1429 = (_e1428 < _e91);
                                                        if _e1429 {
                                                            if _e1429 {
                                                            } else {
                                                                phi_3733_ = true;
                                                                break;
                                                            }
                                                            let _e1431 = global_6.member[_e1428];
                                                            phi_1215_ = _e1431;
                                                        } else {
                                                            phi_1215_ = 0u;
                                                        }
                                                        let _e1433 = phi_1215_;
                                                        phi_1686_ = array<array<f32, 3>, 3>(array<f32, 3>((_e542.member.member.x + (f32(bitcast<i32>(((_e1371 >> bitcast<u32>(_e1373)) & 1023u))) * _e139)), (_e542.member.member.y + (f32(bitcast<i32>(((_e1371 >> bitcast<u32>(_e1382)) & 1023u))) * _e139)), (_e542.member.member.z + (f32(bitcast<i32>(((_e1371 >> bitcast<u32>(_e1391)) & 1023u))) * _e139))), array<f32, 3>((_e542.member.member.x + (f32(bitcast<i32>(((_e1405 >> bitcast<u32>(_e1373)) & 1023u))) * _e139)), (_e542.member.member.y + (f32(bitcast<i32>(((_e1405 >> bitcast<u32>(_e1382)) & 1023u))) * _e139)), (_e542.member.member.z + (f32(bitcast<i32>(((_e1405 >> bitcast<u32>(_e1391)) & 1023u))) * _e139))), array<f32, 3>((_e542.member.member.x + (f32(bitcast<i32>(((_e1433 >> bitcast<u32>(_e1373)) & 1023u))) * _e139)), (_e542.member.member.y + (f32(bitcast<i32>(((_e1433 >> bitcast<u32>(_e1382)) & 1023u))) * _e139)), (_e542.member.member.z + (f32(bitcast<i32>(((_e1433 >> bitcast<u32>(_e1391)) & 1023u))) * _e139))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1190 = (_e1101 < _e91);
                                                        if _e1190 {
                                                            if _e1190 {
                                                            } else {
                                                                phi_3733_ = true;
                                                                break;
                                                            }
                                                            let _e1192 = global_6.member[_e1101];
                                                            phi_1258_ = _e1192;
                                                        } else {
                                                            phi_1258_ = 0u;
                                                        }
                                                        let _e1194 = phi_1258_;
                                                        let _e1195 = (_e1101 + 1u);
                                                        let _e1196 = (_e1195 < _e91);
                                                        if _e1196 {
                                                            if _e1196 {
                                                            } else {
                                                                phi_3733_ = true;
                                                                break;
                                                            }
                                                            let _e1198 = global_6.member[_e1195];
                                                            phi_1273_ = _e1198;
                                                        } else {
                                                            phi_1273_ = 0u;
                                                        }
                                                        let _e1200 = phi_1273_;
                                                        let _e1201 = (_e259 == 1u);
                                                        if _e1201 {
                                                            phi_1283_ = ((_e1194 >> bitcast<u32>(21i)) | (_e1200 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1283_ = (_e1200 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1210 = phi_1283_;
                                                        let _e1217 = (_e258 == 1u);
                                                        if _e1217 {
                                                            phi_1303_ = ((_e1194 >> bitcast<u32>(21i)) | (_e1200 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1303_ = (_e1200 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1226 = phi_1303_;
                                                        let _e1233 = (_e260 == 1u);
                                                        if _e1233 {
                                                            phi_1323_ = ((_e1194 >> bitcast<u32>(21i)) | (_e1200 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1323_ = (_e1200 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1242 = phi_1323_;
                                                        let _e1250 = (_e1101 + 2u);
                                                        let _e1251 = (_e1250 < _e91);
                                                        if _e1251 {
                                                            if _e1251 {
                                                            } else {
                                                                phi_3733_ = true;
                                                                break;
                                                            }
                                                            let _e1253 = global_6.member[_e1250];
                                                            phi_1349_ = _e1253;
                                                        } else {
                                                            phi_1349_ = 0u;
                                                        }
                                                        let _e1255 = phi_1349_;
                                                        let _e1256 = (_e1101 + 3u);
                                                        let _e1257 = (_e1256 < _e91);
                                                        if _e1257 {
                                                            if _e1257 {
                                                            } else {
                                                                phi_3733_ = true;
                                                                break;
                                                            }
                                                            let _e1259 = global_6.member[_e1256];
                                                            phi_1364_ = _e1259;
                                                        } else {
                                                            phi_1364_ = 0u;
                                                        }
                                                        let _e1261 = phi_1364_;
                                                        if _e1201 {
                                                            phi_1374_ = ((_e1255 >> bitcast<u32>(21i)) | (_e1261 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1374_ = (_e1261 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1270 = phi_1374_;
                                                        if _e1217 {
                                                            phi_1394_ = ((_e1255 >> bitcast<u32>(21i)) | (_e1261 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1394_ = (_e1261 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1285 = phi_1394_;
                                                        if _e1233 {
                                                            phi_1414_ = ((_e1255 >> bitcast<u32>(21i)) | (_e1261 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1414_ = (_e1261 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1300 = phi_1414_;
                                                        let _e1308 = (_e1101 + 4u);
                                                        let _e1309 = (_e1308 < _e91);
                                                        if _e1309 {
                                                            if _e1309 {
                                                            } else {
                                                                phi_3733_ = true;
                                                                break;
                                                            }
                                                            let _e1311 = global_6.member[_e1308];
                                                            phi_1440_ = _e1311;
                                                        } else {
                                                            phi_1440_ = 0u;
                                                        }
                                                        let _e1313 = phi_1440_;
                                                        let _e1314 = (_e1101 + 5u);
                                                        let _e1315 = (_e1314 < _e91);
                                                        if _e1315 {
                                                            if _e1315 {
                                                            } else {
                                                                phi_3733_ = true;
                                                                break;
                                                            }
                                                            let _e1317 = global_6.member[_e1314];
                                                            phi_1455_ = _e1317;
                                                        } else {
                                                            phi_1455_ = 0u;
                                                        }
                                                        let _e1319 = phi_1455_;
                                                        if _e1201 {
                                                            phi_1465_ = ((_e1313 >> bitcast<u32>(21i)) | (_e1319 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1465_ = (_e1319 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1328 = phi_1465_;
                                                        if _e1217 {
                                                            phi_1485_ = ((_e1313 >> bitcast<u32>(21i)) | (_e1319 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1485_ = (_e1319 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1343 = phi_1485_;
                                                        if _e1233 {
                                                            phi_1505_ = ((_e1313 >> bitcast<u32>(21i)) | (_e1319 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1505_ = (_e1319 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1358 = phi_1505_;
                                                        phi_1686_ = array<array<f32, 3>, 3>(array<f32, 3>((_e542.member.member.x + (f32(bitcast<i32>((select(_e1210, _e1194, _e298) & 2097151u))) * _e139)), (_e542.member.member.y + (f32(bitcast<i32>((select(_e1226, _e1194, _e337) & 2097151u))) * _e139)), (_e542.member.member.z + (f32(bitcast<i32>((select(_e1242, _e1194, _e375) & 2097151u))) * _e139))), array<f32, 3>((_e542.member.member.x + (f32(bitcast<i32>((select(_e1270, _e1255, _e298) & 2097151u))) * _e139)), (_e542.member.member.y + (f32(bitcast<i32>((select(_e1285, _e1255, _e337) & 2097151u))) * _e139)), (_e542.member.member.z + (f32(bitcast<i32>((select(_e1300, _e1255, _e375) & 2097151u))) * _e139))), array<f32, 3>((_e542.member.member.x + (f32(bitcast<i32>((select(_e1328, _e1313, _e298) & 2097151u))) * _e139)), (_e542.member.member.y + (f32(bitcast<i32>((select(_e1343, _e1313, _e337) & 2097151u))) * _e139)), (_e542.member.member.z + (f32(bitcast<i32>((select(_e1358, _e1313, _e375) & 2097151u))) * _e139))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1103 = (_e1101 + _e259);
                                                        let _e1104 = (_e1103 < _e91);
                                                        if _e1104 {
                                                            if _e1104 {
                                                            } else {
                                                                phi_3733_ = true;
                                                                break;
                                                            }
                                                            let _e1106 = global_6.member[_e1103];
                                                            phi_1532_ = _e1106;
                                                        } else {
                                                            phi_1532_ = 0u;
                                                        }
                                                        let _e1108 = phi_1532_;
                                                        let _e1112 = (_e1101 + _e258);
                                                        let _e1113 = (_e1112 < _e91);
                                                        if _e1113 {
                                                            if _e1113 {
                                                            } else {
                                                                phi_3733_ = true;
                                                                break;
                                                            }
                                                            let _e1115 = global_6.member[_e1112];
                                                            phi_1550_ = _e1115;
                                                        } else {
                                                            phi_1550_ = 0u;
                                                        }
                                                        let _e1117 = phi_1550_;
                                                        let _e1121 = (_e1101 + _e260);
                                                        let _e1122 = (_e1121 < _e91);
                                                        if _e1122 {
                                                            if _e1122 {
                                                            } else {
                                                                phi_3733_ = true;
                                                                break;
                                                            }
                                                            let _e1124 = global_6.member[_e1121];
                                                            phi_1568_ = _e1124;
                                                        } else {
                                                            phi_1568_ = 0u;
                                                        }
                                                        let _e1126 = phi_1568_;
                                                        let _e1131 = (_e1101 + 3u);
                                                        let _e1132 = (_e1131 + _e259);
                                                        let _e1133 = (_e1132 < _e91);
                                                        if _e1133 {
                                                            if _e1133 {
                                                            } else {
                                                                phi_3733_ = true;
                                                                break;
                                                            }
                                                            let _e1135 = global_6.member[_e1132];
                                                            phi_1588_ = _e1135;
                                                        } else {
                                                            phi_1588_ = 0u;
                                                        }
                                                        let _e1137 = phi_1588_;
                                                        let _e1141 = (_e1131 + _e258);
                                                        let _e1142 = (_e1141 < _e91);
                                                        if _e1142 {
                                                            if _e1142 {
                                                            } else {
                                                                phi_3733_ = true;
                                                                break;
                                                            }
                                                            let _e1144 = global_6.member[_e1141];
                                                            phi_1606_ = _e1144;
                                                        } else {
                                                            phi_1606_ = 0u;
                                                        }
                                                        let _e1146 = phi_1606_;
                                                        let _e1150 = (_e1131 + _e260);
                                                        let _e1151 = (_e1150 < _e91);
                                                        if _e1151 {
                                                            if _e1151 {
                                                            } else {
                                                                phi_3733_ = true;
                                                                break;
                                                            }
                                                            let _e1153 = global_6.member[_e1150];
                                                            phi_1624_ = _e1153;
                                                        } else {
                                                            phi_1624_ = 0u;
                                                        }
                                                        let _e1155 = phi_1624_;
                                                        let _e1160 = (_e1101 + 6u);
                                                        let _e1161 = (_e1160 + _e259);
                                                        let _e1162 = (_e1161 < _e91);
                                                        if _e1162 {
                                                            if _e1162 {
                                                            } else {
                                                                phi_3733_ = true;
                                                                break;
                                                            }
                                                            let _e1164 = global_6.member[_e1161];
                                                            phi_1644_ = _e1164;
                                                        } else {
                                                            phi_1644_ = 0u;
                                                        }
                                                        let _e1166 = phi_1644_;
                                                        let _e1170 = (_e1160 + _e258);
                                                        let _e1171 = (_e1170 < _e91);
                                                        if _e1171 {
                                                            if _e1171 {
                                                            } else {
                                                                phi_3733_ = true;
                                                                break;
                                                            }
                                                            let _e1173 = global_6.member[_e1170];
                                                            phi_1662_ = _e1173;
                                                        } else {
                                                            phi_1662_ = 0u;
                                                        }
                                                        let _e1175 = phi_1662_;
                                                        let _e1179 = (_e1160 + _e260);
                                                        let _e1180 = (_e1179 < _e91);
                                                        if _e1180 {
                                                            if _e1180 {
                                                            } else {
                                                                phi_3733_ = true;
                                                                break;
                                                            }
                                                            let _e1182 = global_6.member[_e1179];
                                                            phi_1680_ = _e1182;
                                                        } else {
                                                            phi_1680_ = 0u;
                                                        }
                                                        let _e1184 = phi_1680_;
                                                        phi_1686_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1108)) * _e139), (f32(bitcast<i32>(_e1117)) * _e139), (f32(bitcast<i32>(_e1126)) * _e139)), array<f32, 3>((f32(bitcast<i32>(_e1137)) * _e139), (f32(bitcast<i32>(_e1146)) * _e139), (f32(bitcast<i32>(_e1155)) * _e139)), array<f32, 3>((f32(bitcast<i32>(_e1166)) * _e139), (f32(bitcast<i32>(_e1175)) * _e139), (f32(bitcast<i32>(_e1184)) * _e139)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1686_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1458 = phi_1686_;
                                                let _e1466 = (_e1458[0][2] - _e385);
                                                let _e1469 = (((_e1458[0][0] - _e308) * _e409) - (_e1466 * _e333));
                                                let _e1472 = (((_e1458[0][1] - _e347) * _e409) - (_e1466 * _e371));
                                                let _e1479 = (_e1458[1][2] - _e385);
                                                let _e1482 = (((_e1458[1][0] - _e308) * _e409) - (_e1479 * _e333));
                                                let _e1485 = (((_e1458[1][1] - _e347) * _e409) - (_e1479 * _e371));
                                                let _e1492 = (_e1458[2][2] - _e385);
                                                let _e1495 = (((_e1458[2][0] - _e308) * _e409) - (_e1492 * _e333));
                                                let _e1498 = (((_e1458[2][1] - _e347) * _e409) - (_e1492 * _e371));
                                                let _e1499 = (_e1495 * _e1485);
                                                let _e1500 = (_e1498 * _e1482);
                                                let _e1501 = (_e1469 * _e1498);
                                                let _e1502 = (_e1472 * _e1495);
                                                let _e1503 = (_e1482 * _e1472);
                                                let _e1504 = (_e1485 * _e1469);
                                                let _e1509 = (((_e1499 >= _e1500) && (_e1501 >= _e1502)) && (_e1503 >= _e1504));
                                                if (_e1509 || (((_e1499 <= _e1500) && (_e1501 <= _e1502)) && (_e1503 <= _e1504))) {
                                                    let _e1516 = select(-1f, 1f, _e1509);
                                                    let _e1518 = ((_e1499 - _e1500) * _e1516);
                                                    let _e1520 = select(0f, _e1518, (_e1518 > 0f));
                                                    let _e1522 = ((_e1501 - _e1502) * _e1516);
                                                    let _e1524 = select(0f, _e1522, (_e1522 > 0f));
                                                    let _e1526 = ((_e1503 - _e1504) * _e1516);
                                                    let _e1528 = select(0f, _e1526, (_e1526 > 0f));
                                                    let _e1530 = ((_e1520 + _e1524) + _e1528);
                                                    if (_e1530 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2252_ = type_20();
                                                        phi_2253_ = true;
                                                    } else {
                                                        let _e1533 = select(_e1458[1][0], _e1458[0][0], (_e1458[0][0] < _e1458[1][0]));
                                                        let _e1537 = select(_e1458[1][0], _e1458[0][0], (_e1458[0][0] > _e1458[1][0]));
                                                        let _e1541 = select(_e1458[1][1], _e1458[0][1], (_e1458[0][1] < _e1458[1][1]));
                                                        let _e1545 = select(_e1458[1][1], _e1458[0][1], (_e1458[0][1] > _e1458[1][1]));
                                                        let _e1549 = select(_e1458[1][2], _e1458[0][2], (_e1458[0][2] < _e1458[1][2]));
                                                        let _e1553 = select(_e1458[1][2], _e1458[0][2], (_e1458[0][2] > _e1458[1][2]));
                                                        let _e1558 = ((select(_e1458[2][0], _e1533, (_e1533 < _e1458[2][0])) - _e331) * _e336);
                                                        let _e1559 = ((select(_e1458[2][0], _e1537, (_e1537 > _e1458[2][0])) - _e332) * _e336);
                                                        let _e1562 = ((select(_e1458[2][1], _e1541, (_e1541 < _e1458[2][1])) - _e369) * _e374);
                                                        let _e1563 = ((select(_e1458[2][1], _e1545, (_e1545 > _e1458[2][1])) - _e370) * _e374);
                                                        let _e1566 = ((select(_e1458[2][2], _e1549, (_e1549 < _e1458[2][2])) - _e407) * _e412);
                                                        let _e1567 = ((select(_e1458[2][2], _e1553, (_e1553 > _e1458[2][2])) - _e408) * _e412);
                                                        let _e1569 = select(_e1567, _e1566, (_e1566 < _e1567));
                                                        let _e1571 = select(_e1567, _e1566, (_e1566 > _e1567));
                                                        let _e1573 = select(_e1559, _e1558, (_e1558 < _e1559));
                                                        let _e1575 = select(_e1563, _e1562, (_e1562 < _e1563));
                                                        let _e1577 = select(_e1575, _e1573, (_e1573 > _e1575));
                                                        let _e1579 = select(_e1569, _e1577, (_e1577 > _e1569));
                                                        let _e1581 = select(_e1559, _e1558, (_e1558 > _e1559));
                                                        let _e1583 = select(_e1563, _e1562, (_e1562 > _e1563));
                                                        let _e1585 = select(_e1583, _e1581, (_e1581 < _e1583));
                                                        let _e1587 = select(_e1571, _e1585, (_e1585 < _e1571));
                                                        let _e1588 = -(_e1569);
                                                        let _e1594 = select(_e459, _e1579, (_e1579 > _e459));
                                                        if (_e1594 > (_e1587 + (select(_e1588, _e1571, (_e1571 > _e1588)) * 0.0000019073523f))) {
                                                            phi_2247_ = type_20();
                                                            phi_2248_ = true;
                                                        } else {
                                                            let _e1596 = (_e1594 > _e1029.member);
                                                            if _e1596 {
                                                                phi_2246_ = type_20();
                                                            } else {
                                                                let _e1600 = (_e1458[1][0] - _e1458[0][0]);
                                                                let _e1601 = (_e1458[1][1] - _e1458[0][1]);
                                                                let _e1602 = (_e1458[1][2] - _e1458[0][2]);
                                                                let _e1603 = vec3<f32>(_e1600, _e1601, _e1602);
                                                                let _e1604 = (_e1458[2][0] - _e1458[1][0]);
                                                                let _e1605 = (_e1458[2][1] - _e1458[1][1]);
                                                                let _e1606 = (_e1458[2][2] - _e1458[1][2]);
                                                                let _e1607 = vec3<f32>(_e1604, _e1605, _e1606);
                                                                let _e1608 = (_e1458[0][0] - _e1458[2][0]);
                                                                let _e1609 = (_e1458[0][1] - _e1458[2][1]);
                                                                let _e1610 = (_e1458[0][2] - _e1458[2][2]);
                                                                let _e1611 = vec3<f32>(_e1608, _e1609, _e1610);
                                                                let _e1614 = bitcast<f32>((bitcast<u32>(_e1600) & 2147483647u));
                                                                let _e1617 = bitcast<f32>((bitcast<u32>(_e1601) & 2147483647u));
                                                                let _e1619 = select(_e1617, _e1614, (_e1614 > _e1617));
                                                                let _e1622 = bitcast<f32>((bitcast<u32>(_e1602) & 2147483647u));
                                                                let _e1624 = select(_e1622, _e1619, (_e1619 > _e1622));
                                                                let _e1627 = bitcast<f32>((bitcast<u32>(_e1604) & 2147483647u));
                                                                let _e1630 = bitcast<f32>((bitcast<u32>(_e1605) & 2147483647u));
                                                                let _e1632 = select(_e1630, _e1627, (_e1627 > _e1630));
                                                                let _e1635 = bitcast<f32>((bitcast<u32>(_e1606) & 2147483647u));
                                                                let _e1637 = select(_e1635, _e1632, (_e1632 > _e1635));
                                                                let _e1640 = bitcast<f32>((bitcast<u32>(_e1608) & 2147483647u));
                                                                let _e1643 = bitcast<f32>((bitcast<u32>(_e1609) & 2147483647u));
                                                                let _e1645 = select(_e1643, _e1640, (_e1640 > _e1643));
                                                                let _e1648 = bitcast<f32>((bitcast<u32>(_e1610) & 2147483647u));
                                                                let _e1650 = select(_e1648, _e1645, (_e1645 > _e1648));
                                                                let _e1652 = select(_e1637, _e1624, (_e1624 > _e1637));
                                                                let _e1654 = select(_e1650, _e1652, (_e1652 > _e1650));
                                                                if (_e1624 == _e1654) {
                                                                    phi_2157_ = _e1607;
                                                                    phi_2158_ = _e1611;
                                                                } else {
                                                                    let _e1657 = vec3((_e1637 == _e1654));
                                                                    phi_2157_ = select(_e1603, _e1611, _e1657);
                                                                    phi_2158_ = select(_e1607, _e1603, _e1657);
                                                                }
                                                                let _e1661 = phi_2157_;
                                                                let _e1663 = phi_2158_;
                                                                let _e1670 = ((_e1661.y * _e1663.z) - (_e1663.y * _e1661.z));
                                                                let _e1675 = ((_e1661.z * _e1663.x) - (_e1663.z * _e1661.x));
                                                                let _e1678 = ((_e1661.x * _e1663.y) - (_e1663.x * _e1661.y));
                                                                if (_e1520 >= _e1524) {
                                                                    phi_2189_ = select(true, false, (_e1520 >= _e1528));
                                                                } else {
                                                                    phi_2189_ = true;
                                                                }
                                                                let _e1683 = phi_2189_;
                                                                if _e1683 {
                                                                    phi_2198_ = select(vec3<f32>(_e1458[2][0], _e1458[2][1], _e1458[2][2]), vec3<f32>(_e1458[1][0], _e1458[1][1], _e1458[1][2]), vec3((_e1524 >= _e1528)));
                                                                } else {
                                                                    phi_2198_ = vec3<f32>(_e1458[0][0], _e1458[0][1], _e1458[0][2]);
                                                                }
                                                                let _e1688 = phi_2198_;
                                                                let _e1705 = ((((_e1670 * (_e1688.x - _e308)) + (_e1675 * (_e1688.y - _e347))) + (_e1678 * (_e1688.z - _e385))) / (((_e1670 * _e333) + (_e1675 * _e371)) + (_e1678 * _e409)));
                                                                let _e1707 = select(_e1587, _e1705, (_e1705 < _e1587));
                                                                let _e1709 = select(_e1579, _e1707, (_e1707 > _e1579));
                                                                if (_e1709 >= _e459) {
                                                                    let _e1711 = (_e1709 <= _e1029.member);
                                                                    if _e1711 {
                                                                        let _e1712 = (1f / _e1530);
                                                                        phi_2238_ = type_20(_e1709, (_e1524 * _e1712), (_e1528 * _e1712), _e1089);
                                                                    } else {
                                                                        phi_2238_ = type_20();
                                                                    }
                                                                    let _e1717 = phi_2238_;
                                                                    phi_2240_ = _e1717;
                                                                    phi_2241_ = select(true, false, _e1711);
                                                                } else {
                                                                    phi_2240_ = type_20();
                                                                    phi_2241_ = true;
                                                                }
                                                                let _e1720 = phi_2240_;
                                                                let _e1722 = phi_2241_;
                                                                if _e1722 {
                                                                    phi_2245_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2245_ = _e1720;
                                                                }
                                                                let _e1724 = phi_2245_;
                                                                phi_2246_ = _e1724;
                                                            }
                                                            let _e1726 = phi_2246_;
                                                            phi_2247_ = _e1726;
                                                            phi_2248_ = _e1596;
                                                        }
                                                        let _e1728 = phi_2247_;
                                                        let _e1730 = phi_2248_;
                                                        phi_2252_ = _e1728;
                                                        phi_2253_ = _e1730;
                                                    }
                                                    let _e1732 = phi_2252_;
                                                    let _e1734 = phi_2253_;
                                                    phi_2257_ = _e1732;
                                                    phi_2258_ = _e1734;
                                                } else {
                                                    phi_2257_ = type_20();
                                                    phi_2258_ = true;
                                                }
                                                let _e1736 = phi_2257_;
                                                let _e1738 = phi_2258_;
                                                if _e1738 {
                                                    phi_2262_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2262_ = _e1736;
                                                }
                                                let _e1740 = phi_2262_;
                                                if (_e1740.member_3 != 4294967295u) {
                                                    if (_e1089 != 4294967295u) {
                                                        phi_2273_ = type_34(_e1029.member, true);
                                                    } else {
                                                        phi_2273_ = _e1029;
                                                    }
                                                    let _e1748 = phi_2273_;
                                                    phi_2274_ = _e1748;
                                                } else {
                                                    phi_2274_ = _e1029;
                                                }
                                                let _e1750 = phi_2274_;
                                                phi_968_ = _e1750;
                                            } else {
                                                phi_968_ = type_34();
                                            }
                                            let _e1752 = phi_968_;
                                            continue;
                                            continuing {
                                                phi_967_ = _e1752;
                                                phi_970_ = _e1044;
                                                phi_3733_ = _e501;
                                                break if !(_e1050);
                                            }
                                        }
                                        let _e1755 = phi_3733_;
                                        phi_3891_ = _e1755;
                                        if _e1755 {
                                            break;
                                        }
                                        let _e1757 = local_10;
                                        phi_3895_ = _e1755;
                                        let _e1938 = local_12;
                                        phi_3515_ = _e1938;
                                        phi_3516_ = _e542;
                                        phi_3517_ = false;
                                        phi_3518_ = select(_e546, 0u, _e1757.member_1);
                                    } else {
                                        if (_e542.member_1 >= _e88) {
                                            phi_3071_ = type_46(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_45(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_45(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e542.member_1 < _e88) {
                                            } else {
                                                phi_3891_ = true;
                                                break;
                                            }
                                            let _e558 = (_e259 * 2u);
                                            let _e560 = ((1u + _e558) % 7u);
                                            if (_e560 < 7u) {
                                            } else {
                                                phi_3891_ = true;
                                                break;
                                            }
                                            let _e565 = global_5.member[_e542.member_1][_e560];
                                            let _e567 = ((_e558 + 2u) % 7u);
                                            if (_e567 < 7u) {
                                            } else {
                                                phi_3891_ = true;
                                                break;
                                            }
                                            let _e572 = global_5.member[_e542.member_1][_e567];
                                            let _e573 = (_e258 * 2u);
                                            let _e575 = ((1u + _e573) % 7u);
                                            if (_e575 < 7u) {
                                            } else {
                                                phi_3891_ = true;
                                                break;
                                            }
                                            let _e580 = global_5.member[_e542.member_1][_e575];
                                            let _e582 = ((_e573 + 2u) % 7u);
                                            if (_e582 < 7u) {
                                            } else {
                                                phi_3891_ = true;
                                                break;
                                            }
                                            let _e587 = global_5.member[_e542.member_1][_e582];
                                            let _e588 = (_e260 * 2u);
                                            let _e590 = ((1u + _e588) % 7u);
                                            if (_e590 < 7u) {
                                            } else {
                                                phi_3891_ = true;
                                                break;
                                            }
                                            let _e595 = global_5.member[_e542.member_1][_e590];
                                            let _e597 = ((_e588 + 2u) % 7u);
                                            if (_e597 < 7u) {
                                            } else {
                                                phi_3891_ = true;
                                                break;
                                            }
                                            let _e602 = global_5.member[_e542.member_1][_e597];
                                            let _e625 = (bitcast<f32>((bitcast<u32>((_e542.member.member_1.x - _e542.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e626 = (bitcast<f32>((bitcast<u32>((_e542.member.member_1.y - _e542.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e627 = (bitcast<f32>((bitcast<u32>((_e542.member.member_1.z - _e542.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e629 = select(_e139, _e625, (_e625 > _e139));
                                            let _e631 = select(_e139, _e626, (_e626 > _e139));
                                            let _e633 = select(_e139, _e627, (_e627 > _e139));
                                            let _e658 = bitcast<u32>((f32(bitcast<i32>((_e565 & 2097151u))) * _e629));
                                            let _e663 = (bitcast<i32>((_e565 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e666 = bitcast<f32>((_e658 & bitcast<u32>(_e663)));
                                            let _e667 = bitcast<u32>((f32(bitcast<i32>((_e580 & 2097151u))) * _e631));
                                            let _e672 = (bitcast<i32>((_e580 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e675 = bitcast<f32>((_e667 & bitcast<u32>(_e672)));
                                            let _e676 = bitcast<u32>((f32(bitcast<i32>((_e595 & 2097151u))) * _e633));
                                            let _e681 = (bitcast<i32>((_e595 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e684 = bitcast<f32>((_e676 & bitcast<u32>(_e681)));
                                            let _e688 = bitcast<f32>((_e658 & bitcast<u32>(~(_e663))));
                                            let _e692 = bitcast<f32>((_e667 & bitcast<u32>(~(_e672))));
                                            let _e696 = bitcast<f32>((_e676 & bitcast<u32>(~(_e681))));
                                            let _e697 = bitcast<u32>((f32(bitcast<i32>((_e572 & 2097151u))) * _e629));
                                            let _e702 = (bitcast<i32>((_e572 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e705 = bitcast<f32>((_e697 & bitcast<u32>(_e702)));
                                            let _e706 = bitcast<u32>((f32(bitcast<i32>((_e587 & 2097151u))) * _e631));
                                            let _e711 = (bitcast<i32>((_e587 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e714 = bitcast<f32>((_e706 & bitcast<u32>(_e711)));
                                            let _e715 = bitcast<u32>((f32(bitcast<i32>((_e602 & 2097151u))) * _e633));
                                            let _e720 = (bitcast<i32>((_e602 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e723 = bitcast<f32>((_e715 & bitcast<u32>(_e720)));
                                            let _e727 = bitcast<f32>((_e697 & bitcast<u32>(~(_e702))));
                                            let _e731 = bitcast<f32>((_e706 & bitcast<u32>(~(_e711))));
                                            let _e735 = bitcast<f32>((_e715 & bitcast<u32>(~(_e720))));
                                            let _e736 = (_e542.member.member.x + _e666);
                                            let _e737 = (_e542.member.member.y + _e675);
                                            let _e738 = (_e542.member.member.z + _e684);
                                            let _e741 = (_e542.member.member_1.x - _e705);
                                            let _e742 = (_e542.member.member_1.y - _e714);
                                            let _e743 = (_e542.member.member_1.z - _e723);
                                            let _e762 = (_e741 - _e736);
                                            let _e763 = (_e742 - _e737);
                                            let _e764 = (_e743 - _e738);
                                            let _e766 = select(_e763, _e762, (_e762 > _e763));
                                            let _e768 = select(_e764, _e766, (_e766 > _e764));
                                            if (_e768 < (1024f * _e139)) {
                                                phi_2772_ = 0u;
                                            } else {
                                                phi_2772_ = select(2u, 1u, (_e768 < (2097152f * _e139)));
                                            }
                                            let _e775 = phi_2772_;
                                            switch bitcast<i32>(_e775) {
                                                case 0: {
                                                    phi_2778_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_2778_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_2778_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_2778_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e778 = phi_2778_;
                                            let _e784 = global_5.member[_e542.member_1][0u];
                                            let _e788 = global_5.member[_e542.member_1][2u];
                                            let _e792 = global_5.member[_e542.member_1][4u];
                                            let _e796 = global_5.member[_e542.member_1][6u];
                                            let _e808 = (((_e788 >> bitcast<u32>(22i)) | ((_e792 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e796 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e809 = (_e784 & 268435455u);
                                            let _e810 = (_e808 & 268435455u);
                                            let _e813 = ((_e784 >> bitcast<u32>(28u)) & 7u);
                                            let _e821 = ((_e784 >> bitcast<u32>(31i)) | (((_e808 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e822 = (_e813 != 0u);
                                            if (_e813 == 0u) {
                                                phi_3033_ = _e809;
                                            } else {
                                                if (_e813 == 7u) {
                                                    phi_3032_ = 2147483648u;
                                                } else {
                                                    phi_3032_ = ((2147483648u | (_e813 << bitcast<u32>(28u))) | (_e810 & 268435455u));
                                                }
                                                let _e831 = phi_3032_;
                                                phi_3033_ = _e831;
                                            }
                                            let _e833 = phi_3033_;
                                            if _e822 {
                                                let _e834 = (_e813 != 7u);
                                                if _e834 {
                                                    phi_3043_ = (_e810 + (_e813 * ((3u * _e778) + 1u)));
                                                } else {
                                                    phi_3043_ = u32();
                                                }
                                                let _e838 = phi_3043_;
                                                phi_3045_ = _e838;
                                                phi_3046_ = select(true, false, _e834);
                                            } else {
                                                phi_3045_ = u32();
                                                phi_3046_ = true;
                                            }
                                            let _e841 = phi_3045_;
                                            let _e843 = phi_3046_;
                                            if (_e821 == 0u) {
                                                phi_3067_ = (_e809 + select(0u, 1u, !(_e822)));
                                            } else {
                                                if (_e821 == 7u) {
                                                    phi_3066_ = 2147483648u;
                                                } else {
                                                    phi_3066_ = ((2147483648u | (_e821 << bitcast<u32>(28u))) | (select(_e841, _e810, _e843) & 268435455u));
                                                }
                                                let _e856 = phi_3066_;
                                                phi_3067_ = _e856;
                                            }
                                            let _e858 = phi_3067_;
                                            phi_3071_ = type_46(array<vec4<f32>, 3>(vec4<f32>(_e736, (_e542.member.member.x + _e688), _e741, (_e542.member.member_1.x - _e727)), vec4<f32>(_e737, (_e542.member.member.y + _e692), _e742, (_e542.member.member_1.y - _e731)), vec4<f32>(_e738, (_e542.member.member.z + _e696), _e743, (_e542.member.member_1.z - _e735))), type_45(type_24((_e542.member.member + vec4<f32>(_e666, _e675, _e684, 0f)), (_e542.member.member_1 - vec4<f32>(_e705, _e714, _e723, 0f))), _e833), type_45(type_24((_e542.member.member + vec4<f32>(_e688, _e692, _e696, 0f)), (_e542.member.member_1 - vec4<f32>(_e727, _e731, _e735, 0f))), _e858));
                                        }
                                        let _e863 = phi_3071_;
                                        let _e875 = ((_e863.member[0].x - _e331) * _e336);
                                        let _e876 = ((_e863.member[0].y - _e331) * _e336);
                                        let _e877 = ((_e863.member[0].z - _e332) * _e336);
                                        let _e878 = ((_e863.member[0].w - _e332) * _e336);
                                        let _e888 = ((_e863.member[1].x - _e369) * _e374);
                                        let _e889 = ((_e863.member[1].y - _e369) * _e374);
                                        let _e890 = ((_e863.member[1].z - _e370) * _e374);
                                        let _e891 = ((_e863.member[1].w - _e370) * _e374);
                                        let _e901 = ((_e863.member[2].x - _e407) * _e412);
                                        let _e902 = ((_e863.member[2].y - _e407) * _e412);
                                        let _e903 = ((_e863.member[2].z - _e408) * _e412);
                                        let _e904 = ((_e863.member[2].w - _e408) * _e412);
                                        let _e906 = select(_e903, _e901, (_e901 < _e903));
                                        let _e908 = select(_e904, _e902, (_e902 < _e904));
                                        let _e910 = select(_e903, _e901, (_e901 > _e903));
                                        let _e912 = select(_e904, _e902, (_e902 > _e904));
                                        let _e914 = select(_e877, _e875, (_e875 < _e877));
                                        let _e916 = select(_e878, _e876, (_e876 < _e878));
                                        let _e918 = select(_e890, _e888, (_e888 < _e890));
                                        let _e920 = select(_e891, _e889, (_e889 < _e891));
                                        let _e922 = select(_e918, _e914, (_e914 > _e918));
                                        let _e924 = select(_e920, _e916, (_e916 > _e920));
                                        let _e926 = select(_e906, _e922, (_e922 > _e906));
                                        let _e928 = select(_e908, _e924, (_e924 > _e908));
                                        let _e930 = select(_e877, _e875, (_e875 > _e877));
                                        let _e932 = select(_e878, _e876, (_e876 > _e878));
                                        let _e934 = select(_e890, _e888, (_e888 > _e890));
                                        let _e936 = select(_e891, _e889, (_e889 > _e891));
                                        let _e938 = select(_e934, _e930, (_e930 < _e934));
                                        let _e940 = select(_e936, _e932, (_e932 < _e936));
                                        let _e945 = -(_e906);
                                        let _e946 = -(_e908);
                                        let _e953 = (select(_e910, _e938, (_e938 < _e910)) + (select(_e945, _e910, (_e910 > _e945)) * 0.0000019073523f));
                                        let _e954 = (select(_e912, _e940, (_e940 < _e912)) + (select(_e946, _e912, (_e912 > _e946)) * 0.0000019073523f));
                                        let _e956 = select(_e459, _e926, (_e926 > _e459));
                                        let _e958 = select(_e459, _e928, (_e928 > _e459));
                                        let _e963 = (_e956 <= select(_e503.member, _e953, (_e953 < _e503.member)));
                                        let _e964 = (_e958 <= select(_e503.member, _e954, (_e954 < _e503.member)));
                                        let _e965 = (_e956 <= _e958);
                                        if _e963 {
                                            if _e964 {
                                                if _e965 {
                                                    phi_3415_ = _e863.member_2;
                                                } else {
                                                    phi_3415_ = _e863.member_1;
                                                }
                                                let _e969 = phi_3415_;
                                                let _e991 = (_e546 % 128u);
                                                let _e992 = (_e991 < 128u);
                                                if _e992 {
                                                } else {
                                                    phi_3891_ = true;
                                                    break;
                                                }
                                                local_8[_e991] = _e969.member_1;
                                                if _e992 {
                                                } else {
                                                    phi_3891_ = true;
                                                    break;
                                                }
                                                local_7[_e991] = _e969.member.member.x;
                                                if _e992 {
                                                } else {
                                                    phi_3891_ = true;
                                                    break;
                                                }
                                                local_6[_e991] = _e969.member.member.y;
                                                if _e992 {
                                                } else {
                                                    phi_3891_ = true;
                                                    break;
                                                }
                                                local_5[_e991] = _e969.member.member.z;
                                                if _e992 {
                                                } else {
                                                    phi_3891_ = true;
                                                    break;
                                                }
                                                local_4[_e991] = _e969.member.member_1.x;
                                                if _e992 {
                                                } else {
                                                    phi_3891_ = true;
                                                    break;
                                                }
                                                local_3[_e991] = _e969.member.member_1.y;
                                                if _e992 {
                                                } else {
                                                    phi_3891_ = true;
                                                    break;
                                                }
                                                local_2[_e991] = _e969.member.member_1.z;
                                                if _e992 {
                                                } else {
                                                    phi_3891_ = true;
                                                    break;
                                                }
                                                local_9[_e991] = select(_e958, _e956, (_e956 > _e958));
                                                if _e965 {
                                                    phi_3492_ = _e863.member_1;
                                                } else {
                                                    phi_3492_ = _e863.member_2;
                                                }
                                                let _e1005 = phi_3492_;
                                                phi_3493_ = _e1005;
                                                phi_3494_ = (_e546 + 1u);
                                            } else {
                                                phi_3493_ = type_45();
                                                phi_3494_ = u32();
                                            }
                                            let _e1007 = phi_3493_;
                                            let _e1009 = phi_3494_;
                                            phi_3496_ = _e1007;
                                            phi_3497_ = _e1009;
                                            phi_3498_ = select(true, false, _e964);
                                        } else {
                                            phi_3496_ = type_45();
                                            phi_3497_ = u32();
                                            phi_3498_ = true;
                                        }
                                        let _e1012 = phi_3496_;
                                        let _e1014 = phi_3497_;
                                        let _e1016 = phi_3498_;
                                        if _e1016 {
                                            if _e963 {
                                                phi_3507_ = _e863.member_1;
                                            } else {
                                                phi_3507_ = _e863.member_2;
                                            }
                                            let _e1020 = phi_3507_;
                                            phi_3512_ = _e1020;
                                            phi_3513_ = select(_e964, true, _e963);
                                        } else {
                                            phi_3512_ = _e1012;
                                            phi_3513_ = _e544;
                                        }
                                        let _e1023 = phi_3512_;
                                        let _e1025 = phi_3513_;
                                        phi_3895_ = _e501;
                                        phi_3515_ = _e503;
                                        phi_3516_ = _e1023;
                                        phi_3517_ = _e1025;
                                        phi_3518_ = select(_e1014, _e546, _e1016);
                                    }
                                    let _e1761 = phi_3895_;
                                    let _e1763 = phi_3515_;
                                    let _e1765 = phi_3516_;
                                    let _e1767 = phi_3517_;
                                    let _e1769 = phi_3518_;
                                    phi_3894_ = _e1761;
                                    phi_3519_ = _e1763;
                                    phi_3520_ = _e1765;
                                    phi_3521_ = (_e507 - 1u);
                                    phi_3522_ = _e1767;
                                    phi_3523_ = _e1769;
                                } else {
                                    phi_3894_ = _e501;
                                    phi_3519_ = _e503;
                                    phi_3520_ = _e542;
                                    phi_3521_ = _e507;
                                    phi_3522_ = _e544;
                                    phi_3523_ = _e546;
                                }
                                let _e1771 = phi_3894_;
                                let _e1773 = phi_3519_;
                                let _e1775 = phi_3520_;
                                let _e1777 = phi_3521_;
                                let _e1779 = phi_3522_;
                                let _e1781 = phi_3523_;
                                phi_3893_ = _e1771;
                                phi_3524_ = _e1773;
                                phi_3525_ = _e1775;
                                phi_3526_ = _e1777;
                                phi_3527_ = _e1779;
                                phi_3528_ = _e1781;
                            } else {
                                phi_3893_ = _e501;
                                phi_3524_ = type_34();
                                phi_3525_ = type_45();
                                phi_3526_ = u32();
                                phi_3527_ = bool();
                                phi_3528_ = u32();
                            }
                            let _e1783 = phi_3893_;
                            let _e1785 = phi_3524_;
                            let _e1787 = phi_3525_;
                            let _e1789 = phi_3526_;
                            let _e1791 = phi_3527_;
                            let _e1793 = phi_3528_;
                            phi_3892_ = _e1783;
                            phi_841_ = _e1785;
                            phi_844_ = _e1787;
                            phi_846_ = _e1789;
                            phi_848_ = _e1791;
                            phi_850_ = _e1793;
                            phi_3529_ = _e515;
                        } else {
                            phi_3892_ = _e501;
                            phi_841_ = type_34();
                            phi_844_ = type_45();
                            phi_846_ = u32();
                            phi_848_ = bool();
                            phi_850_ = u32();
                            phi_3529_ = false;
                        }
                        let _e1795 = phi_3892_;
                        let _e1797 = phi_841_;
                        let _e1799 = phi_844_;
                        let _e1801 = phi_846_;
                        let _e1803 = phi_848_;
                        let _e1805 = phi_850_;
                        let _e1807 = phi_3529_;
                        continue;
                        continuing {
                            phi_3739_ = _e1795;
                            phi_840_ = _e1797;
                            phi_843_ = _e1799;
                            phi_845_ = _e1801;
                            phi_847_ = _e1803;
                            phi_849_ = _e1805;
                            phi_3891_ = _e1795;
                            break if !(_e1807);
                        }
                    }
                    let _e1810 = phi_3891_;
                    if _e1810 {
                        break;
                    }
                    let _e1812 = local_11;
                    if _e147 {
                    } else {
                        break;
                    }
                    global_4.member[_e145] = select(0u, 1u, _e1812.member_1);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_any_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
