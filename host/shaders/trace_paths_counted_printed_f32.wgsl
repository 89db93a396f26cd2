struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_14 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_16 {
    member: array<type_14>,
}

struct type_23 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_25 {
    member: array<type_23>,
}

struct type_27 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_28 {
    member: type_27,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_30 {
    member: array<type_28>,
}

struct type_38 {
    member: type_23,
    member_1: f32,
}

struct type_41 {
    member: type_38,
    member_1: u32,
    member_2: u32,
}

struct type_43 {
    member: array<vec4<u32>, 2>,
}

struct type_45 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_47 {
    member: array<type_45>,
}

struct type_50 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_52 {
    member: type_50,
    member_1: u32,
}

struct type_57 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(2) 
var<storage> global_1: type_16;
@group(0) @binding(4) 
var<storage, read_write> global_2: type_25;
@group(0) @binding(0) 
var<uniform> global_3: type_43;
@group(0) @binding(3) 
var<storage> global_4: type_30;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_6: type_57;
@group(0) @binding(1) 
var<storage> global_7: type_47;

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
    var phi_336_: i32;
    var phi_337_: i32;
    var phi_347_: bool;
    var phi_357_: u32;
    var phi_358_: u32;
    var phi_360_: bool;
    var phi_365_: u32;
    var phi_397_: i32;
    var phi_415_: f32;
    var phi_421_: f32;
    var phi_432_: f32;
    var phi_438_: f32;
    var phi_461_: f32;
    var phi_472_: f32;
    var phi_481_: f32;
    var phi_487_: f32;
    var phi_498_: f32;
    var phi_504_: f32;
    var phi_527_: f32;
    var phi_538_: f32;
    var phi_547_: f32;
    var phi_553_: f32;
    var phi_564_: f32;
    var phi_570_: f32;
    var phi_593_: f32;
    var phi_604_: f32;
    var phi_704_: f32;
    var phi_705_: f32;
    var phi_2846_: bool;
    var phi_787_: type_41;
    var phi_790_: type_52;
    var phi_792_: u32;
    var phi_794_: bool;
    var phi_796_: u32;
    var phi_807_: bool;
    var phi_893_: type_52;
    var phi_894_: bool;
    var phi_895_: u32;
    var phi_1685_: type_45;
    var phi_2517_: type_52;
    var phi_2594_: type_52;
    var phi_2595_: type_52;
    var phi_2596_: u32;
    var phi_2598_: type_52;
    var phi_2599_: u32;
    var phi_2600_: bool;
    var phi_2607_: type_52;
    var phi_2612_: type_52;
    var phi_2613_: bool;
    var phi_913_: type_41;
    var phi_916_: type_7;
    var phi_917_: type_7;
    var phi_939_: type_7;
    var phi_963_: u32;
    var phi_1052_: array<array<f32, 3>, 3>;
    var phi_1523_: vec3<f32>;
    var phi_1524_: vec3<f32>;
    var phi_1555_: bool;
    var phi_1564_: vec3<f32>;
    var phi_1604_: type_23;
    var phi_1606_: type_23;
    var phi_1607_: bool;
    var phi_1611_: type_23;
    var phi_1612_: type_23;
    var phi_1613_: type_23;
    var phi_1614_: bool;
    var phi_1618_: type_23;
    var phi_1619_: bool;
    var phi_1623_: type_23;
    var phi_1624_: bool;
    var phi_1628_: type_23;
    var phi_1653_: bool;
    var phi_1654_: bool;
    var phi_1661_: type_41;
    var phi_1662_: type_41;
    var phi_1663_: type_41;
    var phi_914_: type_41;
    var phi_2840_: bool;
    var phi_2958_: bool;
    var phi_2615_: type_41;
    var phi_2616_: type_52;
    var phi_2617_: bool;
    var phi_2618_: u32;
    var phi_2957_: bool;
    var phi_2619_: type_41;
    var phi_2620_: type_52;
    var phi_2621_: u32;
    var phi_2622_: bool;
    var phi_2623_: u32;
    var phi_2956_: bool;
    var phi_2624_: type_41;
    var phi_2625_: type_52;
    var phi_2626_: u32;
    var phi_2627_: bool;
    var phi_2628_: u32;
    var phi_2955_: bool;
    var phi_788_: type_41;
    var phi_791_: type_52;
    var phi_793_: u32;
    var phi_795_: bool;
    var phi_797_: u32;
    var phi_2629_: bool;
    var phi_2954_: bool;
    var local_10: type_41;
    var phi_2681_: type_23;
    var local_11: type_41;
    var local_12: type_41;

    switch bitcast<i32>(0u) {
        default: {
            let _e77 = global;
            let _e80 = arrayLength((&global_7.member));
            let _e82 = arrayLength((&global_1.member));
            let _e90 = arrayLength((&global_6.member));
            let _e94 = global_3.member[0u][0u];
            let _e98 = global_3.member[0u][1u];
            let _e102 = global_3.member[0u][2u];
            let _e106 = global_3.member[1u][0u];
            let _e110 = global_3.member[1u][1u];
            let _e114 = global_3.member[1u][2u];
            let _e118 = global_3.member[1u][3u];
            let _e122 = (_e77.x + (_e77.y * 2097152u));
            let _e129 = (_e122 < arrayLength((&global_4.member)));
            if _e129 {
                let _e130 = (_e122 < arrayLength((&global_2.member)));
                if _e130 {
                    let _e131 = (_e122 < arrayLength((&global_5.member)));
                    if _e131 {
                        if _e129 {
                        } else {
                            break;
                        }
                        let _e141 = global_4.member[_e122].member.member_2[0u];
                        let _e143 = (bitcast<u32>(_e141) & 2147483647u);
                        let _e149 = global_4.member[_e122].member.member_2[1u];
                        let _e151 = (bitcast<u32>(_e149) & 2147483647u);
                        let _e157 = global_4.member[_e122].member.member_2[2u];
                        let _e159 = (bitcast<u32>(_e157) & 2147483647u);
                        let _e165 = global_4.member[_e122].member.member[0u];
                        let _e167 = (bitcast<u32>(_e165) & 2147483647u);
                        let _e173 = global_4.member[_e122].member.member[1u];
                        let _e175 = (bitcast<u32>(_e173) & 2147483647u);
                        let _e181 = global_4.member[_e122].member.member[2u];
                        let _e183 = (bitcast<u32>(_e181) & 2147483647u);
                        let _e185 = select(_e151, _e143, (_e151 < _e143));
                        let _e187 = select(_e159, _e185, (_e159 < _e185));
                        let _e189 = select(_e167, _e187, (_e167 < _e187));
                        let _e191 = select(_e175, _e189, (_e175 < _e189));
                        let _e193 = select(_e183, _e191, (_e183 < _e191));
                        let _e198 = global_4.member[_e122].member.member_1;
                        let _e200 = (bitcast<u32>(_e198) & 2147483647u);
                        let _e208 = global_4.member[_e122].member.member_3;
                        let _e214 = (((select(_e200, _e193, (_e200 < _e193)) < 2139095040u) && ((bitcast<u32>(_e208) & 2147483647u) <= 2139095040u)) && (_e187 > 0u));
                        if _e214 {
                            let _e217 = (bitcast<u32>(bitcast<f32>(_e187)) & 2147483647u);
                            if (_e217 >= 8388608u) {
                                phi_336_ = (bitcast<i32>((_e217 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_336_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e217)), 32u, (_e217 == 0u))));
                            }
                            let _e231 = phi_336_;
                            phi_337_ = _e231;
                        } else {
                            phi_337_ = 0i;
                        }
                        let _e233 = phi_337_;
                        let _e234 = (_e143 == _e187);
                        if _e234 {
                            phi_347_ = true;
                        } else {
                            phi_347_ = (_e151 == _e187);
                        }
                        let _e237 = phi_347_;
                        let _e238 = select(1u, 0u, _e234);
                        if _e237 {
                            let _e239 = (_e238 + 1u);
                            phi_357_ = _e239;
                            phi_358_ = _e239;
                            phi_360_ = select(true, false, (_e239 == 2u));
                        } else {
                            phi_357_ = u32();
                            phi_358_ = 0u;
                            phi_360_ = true;
                        }
                        let _e243 = phi_357_;
                        let _e245 = phi_358_;
                        let _e247 = phi_360_;
                        if _e247 {
                            phi_365_ = (_e245 + 1u);
                        } else {
                            phi_365_ = 0u;
                        }
                        let _e251 = phi_365_;
                        let _e252 = select(_e243, _e245, _e247);
                        let _e253 = select(_e238, select(2u, _e238, _e237), _e247);
                        let _e254 = -(_e233);
                        if (_e254 < -126i) {
                            phi_397_ = -126i;
                        } else {
                            phi_397_ = select(_e254, 127i, (_e254 > 127i));
                        }
                        let _e259 = phi_397_;
                        let _e264 = bitcast<f32>((bitcast<u32>((_e259 + 127i)) << bitcast<u32>(23i)));
                        let _e270 = bitcast<f32>((bitcast<u32>(((_e254 - _e259) + 127i)) << bitcast<u32>(23i)));
                        let _e275 = global_4.member[_e122].member.member;
                        let _e276 = (_e252 == 0u);
                        if _e276 {
                            phi_415_ = _e275[0];
                        } else {
                            phi_415_ = _e275[1];
                        }
                        let _e280 = phi_415_;
                        let _e281 = (_e252 == 2u);
                        if _e281 {
                            phi_421_ = _e275[2];
                        } else {
                            phi_421_ = _e280;
                        }
                        let _e284 = phi_421_;
                        let _e285 = global_4.member[_e122].member.member_2;
                        if _e276 {
                            phi_432_ = _e285[0];
                        } else {
                            phi_432_ = _e285[1];
                        }
                        let _e289 = phi_432_;
                        if _e281 {
                            phi_438_ = _e285[2];
                        } else {
                            phi_438_ = _e289;
                        }
                        let _e292 = phi_438_;
                        let _e294 = ((_e292 * _e264) * _e270);
                        let _e298 = (bitcast<f32>((bitcast<u32>(_e294) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e298 {
                            let _e302 = (bitcast<f32>((bitcast<u32>(_e284) & 2147483647u)) * 0.00000011920929f);
                            phi_461_ = select(0.00000000000011368684f, _e302, (_e302 > 0.00000000000011368684f));
                        } else {
                            phi_461_ = 0f;
                        }
                        let _e306 = phi_461_;
                        let _e307 = (_e284 + _e306);
                        let _e308 = (_e284 - _e306);
                        let _e309 = select(_e294, 0f, _e298);
                        if _e298 {
                            phi_472_ = 38685626000000000000000000f;
                        } else {
                            phi_472_ = (1f / _e294);
                        }
                        let _e312 = phi_472_;
                        let _e313 = (_e251 == 0u);
                        if _e313 {
                            phi_481_ = _e275[0];
                        } else {
                            phi_481_ = _e275[1];
                        }
                        let _e317 = phi_481_;
                        let _e318 = (_e251 == 2u);
                        if _e318 {
                            phi_487_ = _e275[2];
                        } else {
                            phi_487_ = _e317;
                        }
                        let _e321 = phi_487_;
                        if _e313 {
                            phi_498_ = _e285[0];
                        } else {
                            phi_498_ = _e285[1];
                        }
                        let _e325 = phi_498_;
                        if _e318 {
                            phi_504_ = _e285[2];
                        } else {
                            phi_504_ = _e325;
                        }
                        let _e328 = phi_504_;
                        let _e330 = ((_e328 * _e264) * _e270);
                        let _e334 = (bitcast<f32>((bitcast<u32>(_e330) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e334 {
                            let _e338 = (bitcast<f32>((bitcast<u32>(_e321) & 2147483647u)) * 0.00000011920929f);
                            phi_527_ = select(0.00000000000011368684f, _e338, (_e338 > 0.00000000000011368684f));
                        } else {
                            phi_527_ = 0f;
                        }
                        let _e342 = phi_527_;
                        let _e343 = (_e321 + _e342);
                        let _e344 = (_e321 - _e342);
                        let _e345 = select(_e330, 0f, _e334);
                        if _e334 {
                            phi_538_ = 38685626000000000000000000f;
                        } else {
                            phi_538_ = (1f / _e330);
                        }
                        let _e348 = phi_538_;
                        let _e349 = (_e253 == 0u);
                        if _e349 {
                            phi_547_ = _e275[0];
                        } else {
                            phi_547_ = _e275[1];
                        }
                        let _e353 = phi_547_;
                        let _e354 = (_e253 == 2u);
                        if _e354 {
                            phi_553_ = _e275[2];
                        } else {
                            phi_553_ = _e353;
                        }
                        let _e357 = phi_553_;
                        if _e349 {
                            phi_564_ = _e285[0];
                        } else {
                            phi_564_ = _e285[1];
                        }
                        let _e361 = phi_564_;
                        if _e354 {
                            phi_570_ = _e285[2];
                        } else {
                            phi_570_ = _e361;
                        }
                        let _e364 = phi_570_;
                        let _e366 = ((_e364 * _e264) * _e270);
                        let _e370 = (bitcast<f32>((bitcast<u32>(_e366) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e370 {
                            let _e374 = (bitcast<f32>((bitcast<u32>(_e357) & 2147483647u)) * 0.00000011920929f);
                            phi_593_ = select(0.00000000000011368684f, _e374, (_e374 > 0.00000000000011368684f));
                        } else {
                            phi_593_ = 0f;
                        }
                        let _e378 = phi_593_;
                        let _e379 = (_e357 + _e378);
                        let _e380 = (_e357 - _e378);
                        let _e381 = select(_e366, 0f, _e370);
                        if _e370 {
                            phi_604_ = 38685626000000000000000000f;
                        } else {
                            phi_604_ = (1f / _e366);
                        }
                        let _e384 = phi_604_;
                        let _e387 = bitcast<f32>((bitcast<u32>(_e284) & 2147483647u));
                        let _e390 = bitcast<f32>((bitcast<u32>(_e321) & 2147483647u));
                        let _e392 = select(_e390, _e387, (_e387 > _e390));
                        let _e395 = bitcast<f32>((bitcast<u32>(_e357) & 2147483647u));
                        if (_e214 && (select(_e395, _e392, (_e392 > _e395)) <= 1099511600000f)) {
                            let _e400 = (_e233 / 3i);
                            let _e407 = bitcast<f32>((bitcast<u32>((_e400 + 127i)) << bitcast<u32>(23i)));
                            let _e414 = bitcast<f32>((bitcast<u32>(((_e233 - (2i * _e400)) + 127i)) << bitcast<u32>(23i)));
                            let _e415 = (((_e198 * _e407) * _e407) * _e414);
                            let _e417 = select(340282350000000000000000000000000000000f, _e415, (_e415 < 340282350000000000000000000000000000000f));
                            let _e422 = (((_e208 * _e407) * _e407) * _e414);
                            let _e424 = select(340282350000000000000000000000000000000f, _e422, (_e422 < 340282350000000000000000000000000000000f));
                            phi_704_ = select(-340282350000000000000000000000000000000f, _e424, (_e424 > -340282350000000000000000000000000000000f));
                            phi_705_ = select(-340282350000000000000000000000000000000f, _e417, (_e417 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_704_ = 0f;
                            phi_705_ = 1f;
                        }
                        let _e428 = phi_704_;
                        let _e430 = phi_705_;
                        if _e129 {
                        } else {
                            break;
                        }
                        let _e436 = global_4.member[_e122].member_2;
                        local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 3>(bitcast<f32>(_e94), bitcast<f32>(_e98), bitcast<f32>(_e102));
                        let _e440 = (_e252 % 3u);
                        let _e441 = (_e440 < 3u);
                        if _e441 {
                        } else {
                            break;
                        }
                        let _e443 = local_9[_e440];
                        let _e444 = (_e251 % 3u);
                        let _e445 = (_e444 < 3u);
                        if _e445 {
                        } else {
                            break;
                        }
                        let _e447 = local_9[_e444];
                        let _e448 = (_e253 % 3u);
                        let _e449 = (_e448 < 3u);
                        if _e449 {
                        } else {
                            break;
                        }
                        let _e451 = local_9[_e448];
                        local_8 = array<f32, 3>(bitcast<f32>(_e106), bitcast<f32>(_e110), bitcast<f32>(_e114));
                        if _e441 {
                        } else {
                            break;
                        }
                        let _e455 = local_8[_e440];
                        if _e445 {
                        } else {
                            break;
                        }
                        let _e457 = local_8[_e444];
                        if _e449 {
                        } else {
                            break;
                        }
                        let _e459 = local_8[_e448];
                        phi_2846_ = false;
                        phi_787_ = type_41(type_38(type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e428), 0u, 0u);
                        phi_790_ = type_52(type_50(array<f32, 3>(_e443, _e447, _e451), array<f32, 3>(_e455, _e457, _e459)), select(0u, 2147483648u, (_e80 == 0u)));
                        phi_792_ = ((3u * _e80) + 1u);
                        phi_794_ = (_e430 <= _e428);
                        phi_796_ = 0u;
                        loop {
                            let _e467 = phi_2846_;
                            let _e469 = phi_787_;
                            let _e471 = phi_790_;
                            let _e473 = phi_792_;
                            let _e475 = phi_794_;
                            let _e477 = phi_796_;
                            local_10 = _e469;
                            local_11 = _e469;
                            if _e475 {
                                phi_807_ = true;
                            } else {
                                phi_807_ = (_e477 > 0u);
                            }
                            let _e480 = phi_807_;
                            if _e480 {
                                let _e481 = (_e473 > 0u);
                                if _e481 {
                                    if _e475 {
                                        phi_893_ = _e471;
                                        phi_894_ = _e475;
                                        phi_895_ = _e477;
                                    } else {
                                        let _e482 = (_e477 - 1u);
                                        let _e483 = (_e482 % 128u);
                                        let _e484 = (_e483 < 128u);
                                        if _e484 {
                                        } else {
                                            phi_2954_ = true;
                                            break;
                                        }
                                        let _e486 = local_6[_e483];
                                        if _e484 {
                                        } else {
                                            phi_2954_ = true;
                                            break;
                                        }
                                        let _e488 = local_5[_e483];
                                        if _e484 {
                                        } else {
                                            phi_2954_ = true;
                                            break;
                                        }
                                        let _e490 = local_4[_e483];
                                        if _e484 {
                                        } else {
                                            phi_2954_ = true;
                                            break;
                                        }
                                        let _e492 = local_3[_e483];
                                        if _e484 {
                                        } else {
                                            phi_2954_ = true;
                                            break;
                                        }
                                        let _e495 = local_2[_e483];
                                        if _e484 {
                                        } else {
                                            phi_2954_ = true;
                                            break;
                                        }
                                        let _e497 = local_1[_e483];
                                        if _e484 {
                                        } else {
                                            phi_2954_ = true;
                                            break;
                                        }
                                        let _e499 = local[_e483];
                                        if _e484 {
                                        } else {
                                            phi_2954_ = true;
                                            break;
                                        }
                                        let _e504 = local_7[_e483];
                                        phi_893_ = type_52(type_50(array<f32, 3>(_e488, _e490, _e492), array<f32, 3>(_e495, _e497, _e499)), _e486);
                                        phi_894_ = (_e504 <= _e469.member.member_1);
                                        phi_895_ = _e482;
                                    }
                                    let _e509 = phi_893_;
                                    let _e511 = phi_894_;
                                    let _e513 = phi_895_;
                                    if _e511 {
                                        if ((_e509.member_1 & 2147483648u) != 0u) {
                                            phi_913_ = _e469;
                                            phi_916_ = type_7(0u, ((_e509.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e872 = phi_913_;
                                                let _e874 = phi_916_;
                                                local_12 = _e872;
                                                if (_e874.member < _e874.member_1) {
                                                    phi_917_ = type_7((_e874.member + 1u), _e874.member_1);
                                                    phi_939_ = type_7(1u, _e874.member);
                                                } else {
                                                    phi_917_ = _e874;
                                                    phi_939_ = type_7(0u, type_7().member_1);
                                                }
                                                let _e887 = phi_917_;
                                                let _e889 = phi_939_;
                                                let _e893 = (bitcast<i32>(_e889.member) != 0i);
                                                if _e893 {
                                                    let _e899 = type_41(_e872.member, _e872.member_1, (_e872.member_2 + 1u));
                                                    let _e900 = ((_e509.member_1 & 268435455u) + _e889.member_1);
                                                    let _e901 = (_e900 < _e82);
                                                    if _e901 {
                                                        if _e901 {
                                                        } else {
                                                            phi_2840_ = true;
                                                            break;
                                                        }
                                                        let _e905 = global_1.member[_e900].member_1;
                                                        phi_963_ = _e905;
                                                    } else {
                                                        phi_963_ = 4294967295u;
                                                    }
                                                    let _e907 = phi_963_;
                                                    if (_e900 >= _e82) {
                                                        phi_1052_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e901 {
                                                        } else {
                                                            phi_2840_ = true;
                                                            break;
                                                        }
                                                        if (_e440 < 9u) {
                                                        } else {
                                                            phi_2840_ = true;
                                                            break;
                                                        }
                                                        let _e914 = global_1.member[_e900].member[_e440];
                                                        if (_e444 < 9u) {
                                                        } else {
                                                            phi_2840_ = true;
                                                            break;
                                                        }
                                                        let _e920 = global_1.member[_e900].member[_e444];
                                                        if (_e448 < 9u) {
                                                        } else {
                                                            phi_2840_ = true;
                                                            break;
                                                        }
                                                        let _e926 = global_1.member[_e900].member[_e448];
                                                        let _e928 = (3u + _e440);
                                                        if (_e928 < 9u) {
                                                        } else {
                                                            phi_2840_ = true;
                                                            break;
                                                        }
                                                        let _e934 = global_1.member[_e900].member[_e928];
                                                        let _e935 = (3u + _e444);
                                                        if (_e935 < 9u) {
                                                        } else {
                                                            phi_2840_ = true;
                                                            break;
                                                        }
                                                        let _e941 = global_1.member[_e900].member[_e935];
                                                        let _e942 = (3u + _e448);
                                                        if (_e942 < 9u) {
                                                        } else {
                                                            phi_2840_ = true;
                                                            break;
                                                        }
                                                        let _e948 = global_1.member[_e900].member[_e942];
                                                        let _e950 = (6u + _e440);
                                                        if (_e950 < 9u) {
                                                        } else {
                                                            phi_2840_ = true;
                                                            break;
                                                        }
                                                        let _e956 = global_1.member[_e900].member[_e950];
                                                        let _e957 = (6u + _e444);
                                                        if (_e957 < 9u) {
                                                        } else {
                                                            phi_2840_ = true;
                                                            break;
                                                        }
                                                        let _e963 = global_1.member[_e900].member[_e957];
                                                        let _e964 = (6u + _e448);
                                                        if (_e964 < 9u) {
                                                        } else {
                                                            phi_2840_ = true;
                                                            break;
                                                        }
                                                        let _e970 = global_1.member[_e900].member[_e964];
                                                        phi_1052_ = array<array<f32, 3>, 3>(array<f32, 3>(_e914, _e920, _e926), array<f32, 3>(_e934, _e941, _e948), array<f32, 3>(_e956, _e963, _e970));
                                                    }
                                                    let _e974 = phi_1052_;
                                                    let _e983 = (_e974[0][2] - _e357);
                                                    let _e986 = (((_e974[0][0] - _e284) * _e381) - (_e983 * _e309));
                                                    let _e989 = (((_e974[0][1] - _e321) * _e381) - (_e983 * _e345));
                                                    let _e996 = (_e974[1][2] - _e357);
                                                    let _e999 = (((_e974[1][0] - _e284) * _e381) - (_e996 * _e309));
                                                    let _e1002 = (((_e974[1][1] - _e321) * _e381) - (_e996 * _e345));
                                                    let _e1009 = (_e974[2][2] - _e357);
                                                    let _e1012 = (((_e974[2][0] - _e284) * _e381) - (_e1009 * _e309));
                                                    let _e1015 = (((_e974[2][1] - _e321) * _e381) - (_e1009 * _e345));
                                                    let _e1016 = (_e1012 * _e1002);
                                                    let _e1017 = (_e1015 * _e999);
                                                    let _e1018 = (_e986 * _e1015);
                                                    let _e1019 = (_e989 * _e1012);
                                                    let _e1020 = (_e999 * _e989);
                                                    let _e1021 = (_e1002 * _e986);
                                                    let _e1026 = (((_e1016 >= _e1017) && (_e1018 >= _e1019)) && (_e1020 >= _e1021));
                                                    if (_e1026 || (((_e1016 <= _e1017) && (_e1018 <= _e1019)) && (_e1020 <= _e1021))) {
                                                        let _e1033 = select(-1f, 1f, _e1026);
                                                        let _e1035 = ((_e1016 - _e1017) * _e1033);
                                                        let _e1037 = select(0f, _e1035, (_e1035 > 0f));
                                                        let _e1039 = ((_e1018 - _e1019) * _e1033);
                                                        let _e1041 = select(0f, _e1039, (_e1039 > 0f));
                                                        let _e1043 = ((_e1020 - _e1021) * _e1033);
                                                        let _e1045 = select(0f, _e1043, (_e1043 > 0f));
                                                        let _e1047 = ((_e1037 + _e1041) + _e1045);
                                                        if (_e1047 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_1618_ = type_23();
                                                            phi_1619_ = true;
                                                        } else {
                                                            let _e1050 = select(_e974[1][0], _e974[0][0], (_e974[0][0] < _e974[1][0]));
                                                            let _e1054 = select(_e974[1][0], _e974[0][0], (_e974[0][0] > _e974[1][0]));
                                                            let _e1058 = select(_e974[1][1], _e974[0][1], (_e974[0][1] < _e974[1][1]));
                                                            let _e1062 = select(_e974[1][1], _e974[0][1], (_e974[0][1] > _e974[1][1]));
                                                            let _e1066 = select(_e974[1][2], _e974[0][2], (_e974[0][2] < _e974[1][2]));
                                                            let _e1070 = select(_e974[1][2], _e974[0][2], (_e974[0][2] > _e974[1][2]));
                                                            let _e1075 = ((select(_e974[2][0], _e1050, (_e1050 < _e974[2][0])) - _e307) * _e312);
                                                            let _e1076 = ((select(_e974[2][0], _e1054, (_e1054 > _e974[2][0])) - _e308) * _e312);
                                                            let _e1079 = ((select(_e974[2][1], _e1058, (_e1058 < _e974[2][1])) - _e343) * _e348);
                                                            let _e1080 = ((select(_e974[2][1], _e1062, (_e1062 > _e974[2][1])) - _e344) * _e348);
                                                            let _e1083 = ((select(_e974[2][2], _e1066, (_e1066 < _e974[2][2])) - _e379) * _e384);
                                                            let _e1084 = ((select(_e974[2][2], _e1070, (_e1070 > _e974[2][2])) - _e380) * _e384);
                                                            let _e1086 = select(_e1084, _e1083, (_e1083 < _e1084));
                                                            let _e1088 = select(_e1084, _e1083, (_e1083 > _e1084));
                                                            let _e1090 = select(_e1076, _e1075, (_e1075 < _e1076));
                                                            let _e1092 = select(_e1080, _e1079, (_e1079 < _e1080));
                                                            let _e1094 = select(_e1092, _e1090, (_e1090 > _e1092));
                                                            let _e1096 = select(_e1086, _e1094, (_e1094 > _e1086));
                                                            let _e1098 = select(_e1076, _e1075, (_e1075 > _e1076));
                                                            let _e1100 = select(_e1080, _e1079, (_e1079 > _e1080));
                                                            let _e1102 = select(_e1100, _e1098, (_e1098 < _e1100));
                                                            let _e1104 = select(_e1088, _e1102, (_e1102 < _e1088));
                                                            let _e1105 = -(_e1086);
                                                            let _e1111 = select(_e430, _e1096, (_e1096 > _e430));
                                                            if (_e1111 > (_e1104 + (select(_e1105, _e1088, (_e1088 > _e1105)) * 0.0000019073523f))) {
                                                                phi_1613_ = type_23();
                                                                phi_1614_ = true;
                                                            } else {
                                                                let _e1113 = (_e1111 > _e872.member.member_1);
                                                                if _e1113 {
                                                                    phi_1612_ = type_23();
                                                                } else {
                                                                    let _e1117 = (_e974[1][0] - _e974[0][0]);
                                                                    let _e1118 = (_e974[1][1] - _e974[0][1]);
                                                                    let _e1119 = (_e974[1][2] - _e974[0][2]);
                                                                    let _e1120 = vec3<f32>(_e1117, _e1118, _e1119);
                                                                    let _e1121 = (_e974[2][0] - _e974[1][0]);
                                                                    let _e1122 = (_e974[2][1] - _e974[1][1]);
                                                                    let _e1123 = (_e974[2][2] - _e974[1][2]);
                                                                    let _e1124 = vec3<f32>(_e1121, _e1122, _e1123);
                                                                    let _e1125 = (_e974[0][0] - _e974[2][0]);
                                                                    let _e1126 = (_e974[0][1] - _e974[2][1]);
                                                                    let _e1127 = (_e974[0][2] - _e974[2][2]);
                                                                    let _e1128 = vec3<f32>(_e1125, _e1126, _e1127);
                                                                    let _e1131 = bitcast<f32>((bitcast<u32>(_e1117) & 2147483647u));
                                                                    let _e1134 = bitcast<f32>((bitcast<u32>(_e1118) & 2147483647u));
                                                                    let _e1136 = select(_e1134, _e1131, (_e1131 > _e1134));
                                                                    let _e1139 = bitcast<f32>((bitcast<u32>(_e1119) & 2147483647u));
                                                                    let _e1141 = select(_e1139, _e1136, (_e1136 > _e1139));
                                                                    let _e1144 = bitcast<f32>((bitcast<u32>(_e1121) & 2147483647u));
                                                                    let _e1147 = bitcast<f32>((bitcast<u32>(_e1122) & 2147483647u));
                                                                    let _e1149 = select(_e1147, _e1144, (_e1144 > _e1147));
                                                                    let _e1152 = bitcast<f32>((bitcast<u32>(_e1123) & 2147483647u));
                                                                    let _e1154 = select(_e1152, _e1149, (_e1149 > _e1152));
                                                                    let _e1157 = bitcast<f32>((bitcast<u32>(_e1125) & 2147483647u));
                                                                    let _e1160 = bitcast<f32>((bitcast<u32>(_e1126) & 2147483647u));
                                                                    let _e1162 = select(_e1160, _e1157, (_e1157 > _e1160));
                                                                    let _e1165 = bitcast<f32>((bitcast<u32>(_e1127) & 2147483647u));
                                                                    let _e1167 = select(_e1165, _e1162, (_e1162 > _e1165));
                                                                    let _e1169 = select(_e1154, _e1141, (_e1141 > _e1154));
                                                                    let _e1171 = select(_e1167, _e1169, (_e1169 > _e1167));
                                                                    if (_e1141 == _e1171) {
                                                                        phi_1523_ = _e1124;
                                                                        phi_1524_ = _e1128;
                                                                    } else {
                                                                        let _e1174 = vec3((_e1154 == _e1171));
                                                                        phi_1523_ = select(_e1120, _e1128, _e1174);
                                                                        phi_1524_ = select(_e1124, _e1120, _e1174);
                                                                    }
                                                                    let _e1178 = phi_1523_;
                                                                    let _e1180 = phi_1524_;
                                                                    let _e1187 = ((_e1178.y * _e1180.z) - (_e1180.y * _e1178.z));
                                                                    let _e1192 = ((_e1178.z * _e1180.x) - (_e1180.z * _e1178.x));
                                                                    let _e1195 = ((_e1178.x * _e1180.y) - (_e1180.x * _e1178.y));
                                                                    if (_e1037 >= _e1041) {
                                                                        phi_1555_ = select(true, false, (_e1037 >= _e1045));
                                                                    } else {
                                                                        phi_1555_ = true;
                                                                    }
                                                                    let _e1200 = phi_1555_;
                                                                    if _e1200 {
                                                                        phi_1564_ = select(vec3<f32>(_e974[2][0], _e974[2][1], _e974[2][2]), vec3<f32>(_e974[1][0], _e974[1][1], _e974[1][2]), vec3((_e1041 >= _e1045)));
                                                                    } else {
                                                                        phi_1564_ = vec3<f32>(_e974[0][0], _e974[0][1], _e974[0][2]);
                                                                    }
                                                                    let _e1205 = phi_1564_;
                                                                    let _e1222 = ((((_e1187 * (_e1205.x - _e284)) + (_e1192 * (_e1205.y - _e321))) + (_e1195 * (_e1205.z - _e357))) / (((_e1187 * _e309) + (_e1192 * _e345)) + (_e1195 * _e381)));
                                                                    let _e1224 = select(_e1104, _e1222, (_e1222 < _e1104));
                                                                    let _e1226 = select(_e1096, _e1224, (_e1224 > _e1096));
                                                                    if (_e1226 >= _e430) {
                                                                        let _e1228 = (_e1226 <= _e872.member.member_1);
                                                                        if _e1228 {
                                                                            let _e1229 = (1f / _e1047);
                                                                            phi_1604_ = type_23(_e1226, (_e1041 * _e1229), (_e1045 * _e1229), _e907);
                                                                        } else {
                                                                            phi_1604_ = type_23();
                                                                        }
                                                                        let _e1234 = phi_1604_;
                                                                        phi_1606_ = _e1234;
                                                                        phi_1607_ = select(true, false, _e1228);
                                                                    } else {
                                                                        phi_1606_ = type_23();
                                                                        phi_1607_ = true;
                                                                    }
                                                                    let _e1237 = phi_1606_;
                                                                    let _e1239 = phi_1607_;
                                                                    if _e1239 {
                                                                        phi_1611_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_1611_ = _e1237;
                                                                    }
                                                                    let _e1241 = phi_1611_;
                                                                    phi_1612_ = _e1241;
                                                                }
                                                                let _e1243 = phi_1612_;
                                                                phi_1613_ = _e1243;
                                                                phi_1614_ = _e1113;
                                                            }
                                                            let _e1245 = phi_1613_;
                                                            let _e1247 = phi_1614_;
                                                            phi_1618_ = _e1245;
                                                            phi_1619_ = _e1247;
                                                        }
                                                        let _e1249 = phi_1618_;
                                                        let _e1251 = phi_1619_;
                                                        phi_1623_ = _e1249;
                                                        phi_1624_ = _e1251;
                                                    } else {
                                                        phi_1623_ = type_23();
                                                        phi_1624_ = true;
                                                    }
                                                    let _e1253 = phi_1623_;
                                                    let _e1255 = phi_1624_;
                                                    if _e1255 {
                                                        phi_1628_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1628_ = _e1253;
                                                    }
                                                    let _e1257 = phi_1628_;
                                                    if (_e1257.member_3 != 4294967295u) {
                                                        if (_e907 != _e436) {
                                                            if (_e1257.member < _e872.member.member.member) {
                                                                phi_1654_ = true;
                                                            } else {
                                                                if (_e1257.member == _e872.member.member.member) {
                                                                    phi_1653_ = (_e1257.member_3 < _e872.member.member.member_3);
                                                                } else {
                                                                    phi_1653_ = false;
                                                                }
                                                                let _e1272 = phi_1653_;
                                                                phi_1654_ = _e1272;
                                                            }
                                                            let _e1274 = phi_1654_;
                                                            if _e1274 {
                                                                phi_1661_ = type_41(type_38(_e1257, _e1257.member), _e899.member_1, _e899.member_2);
                                                            } else {
                                                                phi_1661_ = _e899;
                                                            }
                                                            let _e1281 = phi_1661_;
                                                            phi_1662_ = _e1281;
                                                        } else {
                                                            phi_1662_ = _e899;
                                                        }
                                                        let _e1283 = phi_1662_;
                                                        phi_1663_ = _e1283;
                                                    } else {
                                                        phi_1663_ = _e899;
                                                    }
                                                    let _e1285 = phi_1663_;
                                                    phi_914_ = _e1285;
                                                } else {
                                                    phi_914_ = type_41();
                                                }
                                                let _e1287 = phi_914_;
                                                continue;
                                                continuing {
                                                    phi_913_ = _e1287;
                                                    phi_916_ = _e887;
                                                    phi_2840_ = _e467;
                                                    break if !(_e893);
                                                }
                                            }
                                            let _e1290 = phi_2840_;
                                            phi_2954_ = _e1290;
                                            if _e1290 {
                                                break;
                                            }
                                            phi_2958_ = _e1290;
                                            let _e1500 = local_12;
                                            phi_2615_ = _e1500;
                                            phi_2616_ = _e509;
                                            phi_2617_ = false;
                                            phi_2618_ = _e513;
                                        } else {
                                            let _e528 = (_e509.member_1 < _e80);
                                            if _e528 {
                                                if _e528 {
                                                } else {
                                                    phi_2954_ = true;
                                                    break;
                                                }
                                                let _e530 = global_7.member[_e509.member_1];
                                                phi_1685_ = _e530;
                                            } else {
                                                phi_1685_ = type_45(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                            }
                                            let _e532 = phi_1685_;
                                            let _e547 = ((10u * _e252) & 31u);
                                            let _e550 = ((_e532.member[0] >> bitcast<u32>(_e547)) & 1023u);
                                            let _e555 = bitcast<f32>((bitcast<u32>(((_e509.member.member_1[0] - _e509.member.member[0]) * 0.0009775171f)) ^ _e118));
                                            let _e561 = (_e509.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e550) * _e555)) ^ _e118)));
                                            let _e565 = select(select(_e509.member.member_1[0], _e561, (_e561 < _e509.member.member_1[0])), _e509.member.member_1[0], (_e550 == 1023u));
                                            let _e567 = ((10u * _e251) & 31u);
                                            let _e570 = ((_e532.member[0] >> bitcast<u32>(_e567)) & 1023u);
                                            let _e575 = bitcast<f32>((bitcast<u32>(((_e509.member.member_1[1] - _e509.member.member[1]) * 0.0009775171f)) ^ _e118));
                                            let _e581 = (_e509.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e570) * _e575)) ^ _e118)));
                                            let _e585 = select(select(_e509.member.member_1[1], _e581, (_e581 < _e509.member.member_1[1])), _e509.member.member_1[1], (_e570 == 1023u));
                                            let _e587 = ((10u * _e253) & 31u);
                                            let _e590 = ((_e532.member[0] >> bitcast<u32>(_e587)) & 1023u);
                                            let _e595 = bitcast<f32>((bitcast<u32>(((_e509.member.member_1[2] - _e509.member.member[2]) * 0.0009775171f)) ^ _e118));
                                            let _e601 = (_e509.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e590) * _e595)) ^ _e118)));
                                            let _e605 = select(select(_e509.member.member_1[2], _e601, (_e601 < _e509.member.member_1[2])), _e509.member.member_1[2], (_e590 == 1023u));
                                            let _e608 = ((_e532.member[1] >> bitcast<u32>(_e547)) & 1023u);
                                            let _e614 = (_e509.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e608) * _e555)) ^ _e118)));
                                            let _e618 = select(select(_e509.member.member_1[0], _e614, (_e614 < _e509.member.member_1[0])), _e509.member.member_1[0], (_e608 == 1023u));
                                            let _e621 = ((_e532.member[1] >> bitcast<u32>(_e567)) & 1023u);
                                            let _e627 = (_e509.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e621) * _e575)) ^ _e118)));
                                            let _e631 = select(select(_e509.member.member_1[1], _e627, (_e627 < _e509.member.member_1[1])), _e509.member.member_1[1], (_e621 == 1023u));
                                            let _e634 = ((_e532.member[1] >> bitcast<u32>(_e587)) & 1023u);
                                            let _e640 = (_e509.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e634) * _e595)) ^ _e118)));
                                            let _e644 = select(select(_e509.member.member_1[2], _e640, (_e640 < _e509.member.member_1[2])), _e509.member.member_1[2], (_e634 == 1023u));
                                            let _e650 = ((_e532.member_1[0] >> bitcast<u32>(_e547)) & 1023u);
                                            let _e656 = (_e509.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e650) * _e555)) ^ _e118)));
                                            let _e660 = select(select(_e509.member.member_1[0], _e656, (_e656 < _e509.member.member_1[0])), _e509.member.member_1[0], (_e650 == 1023u));
                                            let _e663 = ((_e532.member_1[0] >> bitcast<u32>(_e567)) & 1023u);
                                            let _e669 = (_e509.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e663) * _e575)) ^ _e118)));
                                            let _e673 = select(select(_e509.member.member_1[1], _e669, (_e669 < _e509.member.member_1[1])), _e509.member.member_1[1], (_e663 == 1023u));
                                            let _e676 = ((_e532.member_1[0] >> bitcast<u32>(_e587)) & 1023u);
                                            let _e682 = (_e509.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e676) * _e595)) ^ _e118)));
                                            let _e686 = select(select(_e509.member.member_1[2], _e682, (_e682 < _e509.member.member_1[2])), _e509.member.member_1[2], (_e676 == 1023u));
                                            let _e689 = ((_e532.member_1[1] >> bitcast<u32>(_e547)) & 1023u);
                                            let _e695 = (_e509.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e689) * _e555)) ^ _e118)));
                                            let _e699 = select(select(_e509.member.member_1[0], _e695, (_e695 < _e509.member.member_1[0])), _e509.member.member_1[0], (_e689 == 1023u));
                                            let _e702 = ((_e532.member_1[1] >> bitcast<u32>(_e567)) & 1023u);
                                            let _e708 = (_e509.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e702) * _e575)) ^ _e118)));
                                            let _e712 = select(select(_e509.member.member_1[1], _e708, (_e708 < _e509.member.member_1[1])), _e509.member.member_1[1], (_e702 == 1023u));
                                            let _e715 = ((_e532.member_1[1] >> bitcast<u32>(_e587)) & 1023u);
                                            let _e721 = (_e509.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e715) * _e595)) ^ _e118)));
                                            let _e725 = select(select(_e509.member.member_1[2], _e721, (_e721 < _e509.member.member_1[2])), _e509.member.member_1[2], (_e715 == 1023u));
                                            let _e730 = type_52(type_50(array<f32, 3>(_e565, _e585, _e605), array<f32, 3>(_e618, _e631, _e644)), _e532.member_2);
                                            let _e735 = type_52(type_50(array<f32, 3>(_e660, _e673, _e686), array<f32, 3>(_e699, _e712, _e725)), _e532.member_3);
                                            let _e742 = ((_e565 - _e307) * _e312);
                                            let _e743 = ((_e660 - _e307) * _e312);
                                            let _e744 = ((_e618 - _e308) * _e312);
                                            let _e745 = ((_e699 - _e308) * _e312);
                                            let _e750 = ((_e585 - _e343) * _e348);
                                            let _e751 = ((_e673 - _e343) * _e348);
                                            let _e752 = ((_e631 - _e344) * _e348);
                                            let _e753 = ((_e712 - _e344) * _e348);
                                            let _e758 = ((_e605 - _e379) * _e384);
                                            let _e759 = ((_e686 - _e379) * _e384);
                                            let _e760 = ((_e644 - _e380) * _e384);
                                            let _e761 = ((_e725 - _e380) * _e384);
                                            let _e763 = select(_e760, _e758, (_e758 < _e760));
                                            let _e765 = select(_e761, _e759, (_e759 < _e761));
                                            let _e767 = select(_e760, _e758, (_e758 > _e760));
                                            let _e769 = select(_e761, _e759, (_e759 > _e761));
                                            let _e771 = select(_e744, _e742, (_e742 < _e744));
                                            let _e773 = select(_e745, _e743, (_e743 < _e745));
                                            let _e775 = select(_e752, _e750, (_e750 < _e752));
                                            let _e777 = select(_e753, _e751, (_e751 < _e753));
                                            let _e779 = select(_e775, _e771, (_e771 > _e775));
                                            let _e781 = select(_e777, _e773, (_e773 > _e777));
                                            let _e783 = select(_e763, _e779, (_e779 > _e763));
                                            let _e785 = select(_e765, _e781, (_e781 > _e765));
                                            let _e787 = select(_e744, _e742, (_e742 > _e744));
                                            let _e789 = select(_e745, _e743, (_e743 > _e745));
                                            let _e791 = select(_e752, _e750, (_e750 > _e752));
                                            let _e793 = select(_e753, _e751, (_e751 > _e753));
                                            let _e795 = select(_e791, _e787, (_e787 < _e791));
                                            let _e797 = select(_e793, _e789, (_e789 < _e793));
                                            let _e802 = -(_e763);
                                            let _e803 = -(_e765);
                                            let _e810 = (select(_e767, _e795, (_e795 < _e767)) + (select(_e802, _e767, (_e767 > _e802)) * 0.0000019073523f));
                                            let _e811 = (select(_e769, _e797, (_e797 < _e769)) + (select(_e803, _e769, (_e769 > _e803)) * 0.0000019073523f));
                                            let _e813 = select(_e430, _e783, (_e783 > _e430));
                                            let _e815 = select(_e430, _e785, (_e785 > _e430));
                                            let _e820 = (_e813 <= select(_e469.member.member_1, _e810, (_e810 < _e469.member.member_1)));
                                            let _e821 = (_e815 <= select(_e469.member.member_1, _e811, (_e811 < _e469.member.member_1)));
                                            let _e822 = (_e813 <= _e815);
                                            if _e820 {
                                                if _e821 {
                                                    if _e822 {
                                                        phi_2517_ = _e735;
                                                    } else {
                                                        phi_2517_ = _e730;
                                                    }
                                                    let _e824 = phi_2517_;
                                                    let _e832 = (_e513 % 128u);
                                                    let _e833 = (_e832 < 128u);
                                                    if _e833 {
                                                    } else {
                                                        phi_2954_ = true;
                                                        break;
                                                    }
                                                    local_6[_e832] = _e824.member_1;
                                                    if _e833 {
                                                    } else {
                                                        phi_2954_ = true;
                                                        break;
                                                    }
                                                    local_5[_e832] = _e824.member.member[0];
                                                    if _e833 {
                                                    } else {
                                                        phi_2954_ = true;
                                                        break;
                                                    }
                                                    local_4[_e832] = _e824.member.member[1];
                                                    if _e833 {
                                                    } else {
                                                        phi_2954_ = true;
                                                        break;
                                                    }
                                                    local_3[_e832] = _e824.member.member[2];
                                                    if _e833 {
                                                    } else {
                                                        phi_2954_ = true;
                                                        break;
                                                    }
                                                    local_2[_e832] = _e824.member.member_1[0];
                                                    if _e833 {
                                                    } else {
                                                        phi_2954_ = true;
                                                        break;
                                                    }
                                                    local_1[_e832] = _e824.member.member_1[1];
                                                    if _e833 {
                                                    } else {
                                                        phi_2954_ = true;
                                                        break;
                                                    }
                                                    local[_e832] = _e824.member.member_1[2];
                                                    if _e833 {
                                                    } else {
                                                        phi_2954_ = true;
                                                        break;
                                                    }
                                                    local_7[_e832] = select(_e815, _e813, (_e813 > _e815));
                                                    if _e822 {
                                                        phi_2594_ = _e730;
                                                    } else {
                                                        phi_2594_ = _e735;
                                                    }
                                                    let _e850 = phi_2594_;
                                                    phi_2595_ = _e850;
                                                    phi_2596_ = (_e513 + 1u);
                                                } else {
                                                    phi_2595_ = type_52();
                                                    phi_2596_ = u32();
                                                }
                                                let _e852 = phi_2595_;
                                                let _e854 = phi_2596_;
                                                phi_2598_ = _e852;
                                                phi_2599_ = _e854;
                                                phi_2600_ = select(true, false, _e821);
                                            } else {
                                                phi_2598_ = type_52();
                                                phi_2599_ = u32();
                                                phi_2600_ = true;
                                            }
                                            let _e857 = phi_2598_;
                                            let _e859 = phi_2599_;
                                            let _e861 = phi_2600_;
                                            if _e861 {
                                                if _e820 {
                                                    phi_2607_ = _e730;
                                                } else {
                                                    phi_2607_ = _e735;
                                                }
                                                let _e863 = phi_2607_;
                                                phi_2612_ = _e863;
                                                phi_2613_ = select(_e821, true, _e820);
                                            } else {
                                                phi_2612_ = _e857;
                                                phi_2613_ = _e511;
                                            }
                                            let _e866 = phi_2612_;
                                            let _e868 = phi_2613_;
                                            phi_2958_ = _e467;
                                            phi_2615_ = type_41(_e469.member, (_e469.member_1 + 1u), _e469.member_2);
                                            phi_2616_ = _e866;
                                            phi_2617_ = _e868;
                                            phi_2618_ = select(_e859, _e513, _e861);
                                        }
                                        let _e1292 = phi_2958_;
                                        let _e1294 = phi_2615_;
                                        let _e1296 = phi_2616_;
                                        let _e1298 = phi_2617_;
                                        let _e1300 = phi_2618_;
                                        phi_2957_ = _e1292;
                                        phi_2619_ = _e1294;
                                        phi_2620_ = _e1296;
                                        phi_2621_ = (_e473 - 1u);
                                        phi_2622_ = _e1298;
                                        phi_2623_ = _e1300;
                                    } else {
                                        phi_2957_ = _e467;
                                        phi_2619_ = _e469;
                                        phi_2620_ = _e509;
                                        phi_2621_ = _e473;
                                        phi_2622_ = _e511;
                                        phi_2623_ = _e513;
                                    }
                                    let _e1302 = phi_2957_;
                                    let _e1304 = phi_2619_;
                                    let _e1306 = phi_2620_;
                                    let _e1308 = phi_2621_;
                                    let _e1310 = phi_2622_;
                                    let _e1312 = phi_2623_;
                                    phi_2956_ = _e1302;
                                    phi_2624_ = _e1304;
                                    phi_2625_ = _e1306;
                                    phi_2626_ = _e1308;
                                    phi_2627_ = _e1310;
                                    phi_2628_ = _e1312;
                                } else {
                                    phi_2956_ = _e467;
                                    phi_2624_ = type_41();
                                    phi_2625_ = type_52();
                                    phi_2626_ = u32();
                                    phi_2627_ = bool();
                                    phi_2628_ = u32();
                                }
                                let _e1314 = phi_2956_;
                                let _e1316 = phi_2624_;
                                let _e1318 = phi_2625_;
                                let _e1320 = phi_2626_;
                                let _e1322 = phi_2627_;
                                let _e1324 = phi_2628_;
                                phi_2955_ = _e1314;
                                phi_788_ = _e1316;
                                phi_791_ = _e1318;
                                phi_793_ = _e1320;
                                phi_795_ = _e1322;
                                phi_797_ = _e1324;
                                phi_2629_ = _e481;
                            } else {
                                phi_2955_ = _e467;
                                phi_788_ = type_41();
                                phi_791_ = type_52();
                                phi_793_ = u32();
                                phi_795_ = bool();
                                phi_797_ = u32();
                                phi_2629_ = false;
                            }
                            let _e1326 = phi_2955_;
                            let _e1328 = phi_788_;
                            let _e1330 = phi_791_;
                            let _e1332 = phi_793_;
                            let _e1334 = phi_795_;
                            let _e1336 = phi_797_;
                            let _e1338 = phi_2629_;
                            continue;
                            continuing {
                                phi_2846_ = _e1326;
                                phi_787_ = _e1328;
                                phi_790_ = _e1330;
                                phi_792_ = _e1332;
                                phi_794_ = _e1334;
                                phi_796_ = _e1336;
                                phi_2954_ = _e1326;
                                break if !(_e1338);
                            }
                        }
                        let _e1341 = phi_2954_;
                        if _e1341 {
                            break;
                        }
                        let _e1343 = local_10;
                        if (_e1343.member.member.member_3 != 4294967295u) {
                            let _e1349 = (_e254 / 3i);
                            let _e1356 = bitcast<f32>((bitcast<u32>((_e1349 + 127i)) << bitcast<u32>(23i)));
                            let _e1364 = (((_e1343.member.member.member * _e1356) * _e1356) * bitcast<f32>((bitcast<u32>(((_e254 - (2i * _e1349)) + 127i)) << bitcast<u32>(23i))));
                            let _e1366 = select(340282350000000000000000000000000000000f, _e1364, (_e1364 < 340282350000000000000000000000000000000f));
                            phi_2681_ = type_23(select(-340282350000000000000000000000000000000f, _e1366, (_e1366 > -340282350000000000000000000000000000000f)), _e1343.member.member.member_1, _e1343.member.member.member_2, _e1343.member.member.member_3);
                        } else {
                            phi_2681_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                        }
                        let _e1373 = phi_2681_;
                        if _e130 {
                        } else {
                            break;
                        }
                        global_2.member[_e122] = _e1373;
                        let _e1377 = local_11;
                        if _e131 {
                        } else {
                            break;
                        }
                        global_5.member[_e122] = _e1377.member_1;
                        if _e129 {
                        } else {
                            break;
                        }
                        let _e1382 = select(0u, 1u, (_e198 <= _e208));
                        if (_e1382 > 0u) {
                            let _e1384 = (1u < _e90);
                            if _e1384 {
                                if (0u < _e90) {
                                } else {
                                    break;
                                }
                                let _e1388 = atomicAdd((&global_6.member[0u]), _e1382);
                                if ((_e1388 + _e1382) < _e1388) {
                                    if _e1384 {
                                    } else {
                                        break;
                                    }
                                    let _e1393 = atomicAdd((&global_6.member[1u]), 1u);
                                }
                            }
                        }
                        let _e1396 = select(0u, 1u, (_e1373.member_3 != 4294967295u));
                        if (_e1396 > 0u) {
                            let _e1398 = (3u < _e90);
                            if _e1398 {
                                if (2u < _e90) {
                                } else {
                                    break;
                                }
                                let _e1402 = atomicAdd((&global_6.member[2u]), _e1396);
                                if ((_e1402 + _e1396) < _e1402) {
                                    if _e1398 {
                                    } else {
                                        break;
                                    }
                                    let _e1407 = atomicAdd((&global_6.member[3u]), 1u);
                                }
                            }
                        }
                        if (_e1377.member_1 > 0u) {
                            let _e1409 = (5u < _e90);
                            if _e1409 {
                                if (4u < _e90) {
                                } else {
                                    break;
                                }
                                let _e1413 = atomicAdd((&global_6.member[4u]), _e1377.member_1);
                                if ((_e1413 + _e1377.member_1) < _e1413) {
                                    if _e1409 {
                                    } else {
                                        break;
                                    }
                                    let _e1418 = atomicAdd((&global_6.member[5u]), 1u);
                                }
                            }
                        }
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_paths_counted_printed_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
