struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_13 {
    member: array<array<u32, 4>>,
}

struct type_16 {
    member: vec4<u32>,
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

struct type_36 {
    member: array<type_25>,
}

struct type_40 {
    member: array<array<type_24, 8>>,
}

struct type_46 {
    member: array<vec4<u32>, 2>,
}

struct type_51 {
    member: type_28,
    member_1: u32,
}

struct type_52 {
    member: array<vec4<f32>, 3>,
    member_1: type_51,
    member_2: type_51,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_16;
@group(0) @binding(1) 
var<uniform> global_2: type_46;
@group(0) @binding(2) 
var<storage> global_3: type_13;
@group(0) @binding(4) 
var<storage> global_4: type_36;
@group(0) @binding(3) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_40;

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
    var local_9: array<type_24, 8>;
    var local_10: array<f32, 128>;
    var phi_403_: i32;
    var phi_404_: i32;
    var phi_414_: bool;
    var phi_424_: u32;
    var phi_425_: u32;
    var phi_427_: bool;
    var phi_432_: u32;
    var phi_444_: i32;
    var phi_464_: i32;
    var phi_482_: f32;
    var phi_488_: f32;
    var phi_499_: f32;
    var phi_505_: f32;
    var phi_528_: f32;
    var phi_539_: f32;
    var phi_548_: f32;
    var phi_554_: f32;
    var phi_565_: f32;
    var phi_571_: f32;
    var phi_594_: f32;
    var phi_605_: f32;
    var phi_614_: f32;
    var phi_620_: f32;
    var phi_631_: f32;
    var phi_637_: f32;
    var phi_660_: f32;
    var phi_671_: f32;
    var phi_771_: f32;
    var phi_772_: f32;
    var phi_4469_: bool;
    var phi_4325_: f32;
    var phi_914_: type_51;
    var phi_917_: u32;
    var phi_919_: bool;
    var phi_921_: u32;
    var phi_932_: bool;
    var phi_1019_: type_51;
    var phi_1020_: bool;
    var phi_1021_: u32;
    var phi_3198_: u32;
    var phi_3204_: u32;
    var phi_3458_: u32;
    var phi_3459_: u32;
    var phi_3469_: u32;
    var phi_3471_: u32;
    var phi_3472_: bool;
    var phi_3492_: u32;
    var phi_3493_: u32;
    var phi_3497_: type_52;
    var phi_3842_: type_51;
    var phi_3919_: type_51;
    var phi_3920_: type_51;
    var phi_3921_: u32;
    var phi_3923_: type_51;
    var phi_3924_: u32;
    var phi_3925_: bool;
    var phi_3934_: type_51;
    var phi_3939_: type_51;
    var phi_3940_: bool;
    var phi_4466_: bool;
    var phi_4409_: f32;
    var phi_1040_: type_8;
    var phi_1041_: type_8;
    var phi_1064_: type_8;
    var phi_1105_: u32;
    var phi_1111_: u32;
    var phi_1121_: u32;
    var phi_1137_: u32;
    var phi_1170_: u32;
    var phi_1176_: u32;
    var phi_1603_: u32;
    var phi_1621_: u32;
    var phi_1639_: u32;
    var phi_1659_: u32;
    var phi_1677_: u32;
    var phi_1695_: u32;
    var phi_1715_: u32;
    var phi_1733_: u32;
    var phi_1751_: u32;
    var phi_1329_: u32;
    var phi_1344_: u32;
    var phi_1354_: u32;
    var phi_1374_: u32;
    var phi_1394_: u32;
    var phi_1420_: u32;
    var phi_1435_: u32;
    var phi_1445_: u32;
    var phi_1465_: u32;
    var phi_1485_: u32;
    var phi_1511_: u32;
    var phi_1526_: u32;
    var phi_1536_: u32;
    var phi_1556_: u32;
    var phi_1576_: u32;
    var phi_1200_: u32;
    var phi_1243_: u32;
    var phi_1286_: u32;
    var phi_1757_: array<array<f32, 3>, 3>;
    var phi_1875_: bool;
    var phi_1904_: bool;
    var phi_2305_: f32;
    var phi_2306_: f32;
    var phi_2307_: f32;
    var phi_2308_: f32;
    var phi_2309_: vec3<f32>;
    var phi_2310_: vec3<f32>;
    var phi_2311_: vec3<f32>;
    var phi_2312_: vec3<f32>;
    var phi_2343_: bool;
    var phi_2352_: vec3<f32>;
    var phi_2517_: f32;
    var phi_2519_: f32;
    var phi_2520_: bool;
    var phi_2540_: f32;
    var phi_2541_: f32;
    var phi_2564_: type_24;
    var phi_2566_: type_24;
    var phi_2567_: bool;
    var phi_2571_: type_24;
    var phi_2572_: type_24;
    var phi_2573_: type_24;
    var phi_2574_: bool;
    var phi_2578_: type_24;
    var phi_2579_: bool;
    var phi_2580_: type_24;
    var phi_2581_: bool;
    var phi_2582_: bool;
    var phi_2583_: type_24;
    var phi_2584_: bool;
    var phi_2585_: bool;
    var phi_2593_: type_24;
    var phi_2594_: bool;
    var phi_2598_: type_24;
    var phi_2610_: type_8;
    var phi_2613_: type_24;
    var phi_2611_: type_8;
    var phi_2636_: type_8;
    var phi_2668_: bool;
    var phi_2669_: bool;
    var phi_2690_: type_24;
    var phi_2614_: type_24;
    var phi_4437_: bool;
    var phi_4864_: f32;
    var phi_4863_: f32;
    var phi_4629_: bool;
    var phi_4862_: f32;
    var phi_4628_: bool;
    var phi_4861_: f32;
    var phi_4627_: bool;
    var phi_4773_: f32;
    var phi_4626_: bool;
    var phi_4738_: f32;
    var phi_4635_: bool;
    var phi_3942_: type_51;
    var phi_3943_: bool;
    var phi_3944_: u32;
    var phi_4737_: f32;
    var phi_4634_: bool;
    var phi_3945_: type_51;
    var phi_3946_: u32;
    var phi_3947_: bool;
    var phi_3948_: u32;
    var phi_4736_: f32;
    var phi_4633_: bool;
    var phi_3949_: type_51;
    var phi_3950_: u32;
    var phi_3951_: bool;
    var phi_3952_: u32;
    var phi_4735_: f32;
    var phi_4632_: bool;
    var phi_915_: type_51;
    var phi_918_: u32;
    var phi_920_: bool;
    var phi_922_: u32;
    var phi_3953_: bool;
    var phi_4631_: bool;
    var phi_3960_: type_8;
    var phi_3961_: type_8;
    var phi_3984_: type_8;
    var phi_4050_: type_24;
    var phi_4728_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e95 = global;
            let _e97 = arrayLength((&global_3.member));
            let _e100 = arrayLength((&global_5.member));
            let _e108 = global_2.member[0u][0u];
            let _e112 = global_2.member[0u][1u];
            let _e116 = global_2.member[0u][2u];
            let _e120 = global_2.member[0u][3u];
            let _e124 = global_2.member[1u][0u];
            let _e128 = global_2.member[1u][1u];
            let _e132 = global_2.member[1u][2u];
            let _e135 = global_1.member[0u];
            let _e136 = bitcast<i32>(_e135);
            let _e148 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e120) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e108), bitcast<i32>(_e112), bitcast<i32>(_e116));
            local = array<i32, 3>(bitcast<i32>(_e124), bitcast<i32>(_e128), bitcast<i32>(_e132));
            let _e154 = (_e95.x + (_e95.y * 2097152u));
            let _e155 = (_e154 < arrayLength((&global_4.member)));
            if _e155 {
                let _e156 = (_e154 < arrayLength((&global_6.member)));
                if _e156 {
                    if _e155 {
                    } else {
                        break;
                    }
                    let _e164 = global_4.member[_e154].member_2[0u];
                    let _e166 = (bitcast<u32>(_e164) & 2147483647u);
                    let _e171 = global_4.member[_e154].member_2[1u];
                    let _e173 = (bitcast<u32>(_e171) & 2147483647u);
                    let _e178 = global_4.member[_e154].member_2[2u];
                    let _e180 = (bitcast<u32>(_e178) & 2147483647u);
                    let _e185 = global_4.member[_e154].member[0u];
                    let _e187 = (bitcast<u32>(_e185) & 2147483647u);
                    let _e192 = global_4.member[_e154].member[1u];
                    let _e194 = (bitcast<u32>(_e192) & 2147483647u);
                    let _e199 = global_4.member[_e154].member[2u];
                    let _e201 = (bitcast<u32>(_e199) & 2147483647u);
                    let _e203 = select(_e173, _e166, (_e173 < _e166));
                    let _e205 = select(_e180, _e203, (_e180 < _e203));
                    let _e207 = select(_e187, _e205, (_e187 < _e205));
                    let _e209 = select(_e194, _e207, (_e194 < _e207));
                    let _e211 = select(_e201, _e209, (_e201 < _e209));
                    let _e215 = global_4.member[_e154].member_1;
                    let _e217 = (bitcast<u32>(_e215) & 2147483647u);
                    let _e224 = global_4.member[_e154].member_3;
                    let _e230 = (((select(_e217, _e211, (_e217 < _e211)) < 2139095040u) && ((bitcast<u32>(_e224) & 2147483647u) <= 2139095040u)) && (_e205 > 0u));
                    if _e230 {
                        let _e233 = (bitcast<u32>(bitcast<f32>(_e205)) & 2147483647u);
                        if (_e233 >= 8388608u) {
                            phi_403_ = (bitcast<i32>((_e233 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_403_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e233)), 32u, (_e233 == 0u))));
                        }
                        let _e247 = phi_403_;
                        phi_404_ = _e247;
                    } else {
                        phi_404_ = 0i;
                    }
                    let _e249 = phi_404_;
                    let _e250 = (_e166 == _e205);
                    if _e250 {
                        phi_414_ = true;
                    } else {
                        phi_414_ = (_e173 == _e205);
                    }
                    let _e253 = phi_414_;
                    let _e254 = select(1u, 0u, _e250);
                    if _e253 {
                        let _e255 = (_e254 + 1u);
                        phi_424_ = _e255;
                        phi_425_ = _e255;
                        phi_427_ = select(true, false, (_e255 == 2u));
                    } else {
                        phi_424_ = u32();
                        phi_425_ = 0u;
                        phi_427_ = true;
                    }
                    let _e259 = phi_424_;
                    let _e261 = phi_425_;
                    let _e263 = phi_427_;
                    if _e263 {
                        phi_432_ = (_e261 + 1u);
                    } else {
                        phi_432_ = 0u;
                    }
                    let _e267 = phi_432_;
                    let _e268 = select(_e259, _e261, _e263);
                    let _e269 = select(_e254, select(2u, _e254, _e253), _e263);
                    if (_e136 < -126i) {
                        phi_444_ = -126i;
                    } else {
                        phi_444_ = select(_e136, 127i, (_e136 > 127i));
                    }
                    let _e274 = phi_444_;
                    let _e279 = bitcast<f32>((bitcast<u32>((_e274 + 127i)) << bitcast<u32>(23i)));
                    let _e285 = bitcast<f32>((bitcast<u32>(((_e136 - _e274) + 127i)) << bitcast<u32>(23i)));
                    let _e286 = -(_e249);
                    if (_e286 < -126i) {
                        phi_464_ = -126i;
                    } else {
                        phi_464_ = select(_e286, 127i, (_e286 > 127i));
                    }
                    let _e291 = phi_464_;
                    let _e296 = bitcast<f32>((bitcast<u32>((_e291 + 127i)) << bitcast<u32>(23i)));
                    let _e302 = bitcast<f32>((bitcast<u32>(((_e286 - _e291) + 127i)) << bitcast<u32>(23i)));
                    let _e306 = global_4.member[_e154].member;
                    let _e307 = (_e268 == 0u);
                    if _e307 {
                        phi_482_ = _e306[0];
                    } else {
                        phi_482_ = _e306[1];
                    }
                    let _e311 = phi_482_;
                    let _e312 = (_e268 == 2u);
                    if _e312 {
                        phi_488_ = _e306[2];
                    } else {
                        phi_488_ = _e311;
                    }
                    let _e315 = phi_488_;
                    let _e317 = ((_e315 * _e279) * _e285);
                    let _e318 = global_4.member[_e154].member_2;
                    if _e307 {
                        phi_499_ = _e318[0];
                    } else {
                        phi_499_ = _e318[1];
                    }
                    let _e322 = phi_499_;
                    if _e312 {
                        phi_505_ = _e318[2];
                    } else {
                        phi_505_ = _e322;
                    }
                    let _e325 = phi_505_;
                    let _e327 = ((_e325 * _e296) * _e302);
                    let _e331 = (bitcast<f32>((bitcast<u32>(_e327) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e331 {
                        let _e335 = (bitcast<f32>((bitcast<u32>(_e317) & 2147483647u)) * 0.00000011920929f);
                        phi_528_ = select(0.00000000000011368684f, _e335, (_e335 > 0.00000000000011368684f));
                    } else {
                        phi_528_ = 0f;
                    }
                    let _e339 = phi_528_;
                    let _e340 = (_e317 + _e339);
                    let _e341 = (_e317 - _e339);
                    let _e342 = select(_e327, 0f, _e331);
                    if _e331 {
                        phi_539_ = 38685626000000000000000000f;
                    } else {
                        phi_539_ = (1f / _e327);
                    }
                    let _e345 = phi_539_;
                    let _e346 = (_e267 == 0u);
                    if _e346 {
                        phi_548_ = _e306[0];
                    } else {
                        phi_548_ = _e306[1];
                    }
                    let _e350 = phi_548_;
                    let _e351 = (_e267 == 2u);
                    if _e351 {
                        phi_554_ = _e306[2];
                    } else {
                        phi_554_ = _e350;
                    }
                    let _e354 = phi_554_;
                    let _e356 = ((_e354 * _e279) * _e285);
                    if _e346 {
                        phi_565_ = _e318[0];
                    } else {
                        phi_565_ = _e318[1];
                    }
                    let _e360 = phi_565_;
                    if _e351 {
                        phi_571_ = _e318[2];
                    } else {
                        phi_571_ = _e360;
                    }
                    let _e363 = phi_571_;
                    let _e365 = ((_e363 * _e296) * _e302);
                    let _e369 = (bitcast<f32>((bitcast<u32>(_e365) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e369 {
                        let _e373 = (bitcast<f32>((bitcast<u32>(_e356) & 2147483647u)) * 0.00000011920929f);
                        phi_594_ = select(0.00000000000011368684f, _e373, (_e373 > 0.00000000000011368684f));
                    } else {
                        phi_594_ = 0f;
                    }
                    let _e377 = phi_594_;
                    let _e378 = (_e356 + _e377);
                    let _e379 = (_e356 - _e377);
                    let _e380 = select(_e365, 0f, _e369);
                    if _e369 {
                        phi_605_ = 38685626000000000000000000f;
                    } else {
                        phi_605_ = (1f / _e365);
                    }
                    let _e383 = phi_605_;
                    let _e384 = (_e269 == 0u);
                    if _e384 {
                        phi_614_ = _e306[0];
                    } else {
                        phi_614_ = _e306[1];
                    }
                    let _e388 = phi_614_;
                    let _e389 = (_e269 == 2u);
                    if _e389 {
                        phi_620_ = _e306[2];
                    } else {
                        phi_620_ = _e388;
                    }
                    let _e392 = phi_620_;
                    let _e394 = ((_e392 * _e279) * _e285);
                    if _e384 {
                        phi_631_ = _e318[0];
                    } else {
                        phi_631_ = _e318[1];
                    }
                    let _e398 = phi_631_;
                    if _e389 {
                        phi_637_ = _e318[2];
                    } else {
                        phi_637_ = _e398;
                    }
                    let _e401 = phi_637_;
                    let _e403 = ((_e401 * _e296) * _e302);
                    let _e407 = (bitcast<f32>((bitcast<u32>(_e403) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e407 {
                        let _e411 = (bitcast<f32>((bitcast<u32>(_e394) & 2147483647u)) * 0.00000011920929f);
                        phi_660_ = select(0.00000000000011368684f, _e411, (_e411 > 0.00000000000011368684f));
                    } else {
                        phi_660_ = 0f;
                    }
                    let _e415 = phi_660_;
                    let _e416 = (_e394 + _e415);
                    let _e417 = (_e394 - _e415);
                    let _e418 = select(_e403, 0f, _e407);
                    if _e407 {
                        phi_671_ = 38685626000000000000000000f;
                    } else {
                        phi_671_ = (1f / _e403);
                    }
                    let _e421 = phi_671_;
                    let _e424 = bitcast<f32>((bitcast<u32>(_e317) & 2147483647u));
                    let _e427 = bitcast<f32>((bitcast<u32>(_e356) & 2147483647u));
                    let _e429 = select(_e427, _e424, (_e424 > _e427));
                    let _e432 = bitcast<f32>((bitcast<u32>(_e394) & 2147483647u));
                    let _e435 = (_e136 + _e249);
                    if (_e230 && (select(_e432, _e429, (_e429 > _e432)) <= 1099511600000f)) {
                        let _e438 = (_e435 / 3i);
                        let _e445 = bitcast<f32>((bitcast<u32>((_e438 + 127i)) << bitcast<u32>(23i)));
                        let _e452 = bitcast<f32>((bitcast<u32>(((_e435 - (2i * _e438)) + 127i)) << bitcast<u32>(23i)));
                        let _e453 = (((_e215 * _e445) * _e445) * _e452);
                        let _e455 = select(340282350000000000000000000000000000000f, _e453, (_e453 < 340282350000000000000000000000000000000f));
                        let _e460 = (((_e224 * _e445) * _e445) * _e452);
                        let _e462 = select(340282350000000000000000000000000000000f, _e460, (_e460 < 340282350000000000000000000000000000000f));
                        phi_771_ = select(-340282350000000000000000000000000000000f, _e462, (_e462 > -340282350000000000000000000000000000000f));
                        phi_772_ = select(-340282350000000000000000000000000000000f, _e455, (_e455 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_771_ = 0f;
                        phi_772_ = 1f;
                    }
                    let _e466 = phi_771_;
                    let _e468 = phi_772_;
                    local_9 = array<type_24, 8>(type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_10 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e471 = (_e268 % 3u);
                    let _e472 = (_e471 < 3u);
                    if _e472 {
                    } else {
                        break;
                    }
                    let _e474 = local_1[_e471];
                    let _e477 = (_e267 % 3u);
                    let _e478 = (_e477 < 3u);
                    if _e478 {
                    } else {
                        break;
                    }
                    let _e480 = local_1[_e477];
                    let _e483 = (_e269 % 3u);
                    let _e484 = (_e483 < 3u);
                    if _e484 {
                    } else {
                        break;
                    }
                    let _e486 = local_1[_e483];
                    if _e472 {
                    } else {
                        break;
                    }
                    let _e491 = local[_e471];
                    if _e478 {
                    } else {
                        break;
                    }
                    let _e495 = local[_e477];
                    if _e484 {
                    } else {
                        break;
                    }
                    let _e499 = local[_e483];
                    phi_4469_ = false;
                    phi_4325_ = _e466;
                    phi_914_ = type_51(type_28(vec4<f32>((f32(_e474) * _e148), (f32(_e480) * _e148), (f32(_e486) * _e148), 0f), vec4<f32>((f32(_e491) * _e148), (f32(_e495) * _e148), (f32(_e499) * _e148), 0f)), select(0u, 2147483648u, (_e97 == 0u)));
                    phi_917_ = ((3u * _e97) + 1u);
                    phi_919_ = (_e468 <= _e466);
                    phi_921_ = 0u;
                    loop {
                        let _e509 = phi_4469_;
                        let _e511 = phi_4325_;
                        let _e513 = phi_914_;
                        let _e515 = phi_917_;
                        let _e517 = phi_919_;
                        let _e519 = phi_921_;
                        if _e517 {
                            phi_932_ = true;
                        } else {
                            phi_932_ = (_e519 > 0u);
                        }
                        let _e522 = phi_932_;
                        if _e522 {
                            let _e523 = (_e515 > 0u);
                            if _e523 {
                                if _e517 {
                                    phi_1019_ = _e513;
                                    phi_1020_ = _e517;
                                    phi_1021_ = _e519;
                                } else {
                                    let _e524 = (_e519 - 1u);
                                    let _e525 = (_e524 % 128u);
                                    let _e526 = (_e525 < 128u);
                                    if _e526 {
                                    } else {
                                        phi_4631_ = true;
                                        break;
                                    }
                                    let _e528 = local_7[_e525];
                                    if _e526 {
                                    } else {
                                        phi_4631_ = true;
                                        break;
                                    }
                                    let _e530 = local_6[_e525];
                                    if _e526 {
                                    } else {
                                        phi_4631_ = true;
                                        break;
                                    }
                                    let _e532 = local_5[_e525];
                                    if _e526 {
                                    } else {
                                        phi_4631_ = true;
                                        break;
                                    }
                                    let _e534 = local_4[_e525];
                                    if _e526 {
                                    } else {
                                        phi_4631_ = true;
                                        break;
                                    }
                                    let _e536 = local_3[_e525];
                                    if _e526 {
                                    } else {
                                        phi_4631_ = true;
                                        break;
                                    }
                                    let _e538 = local_2[_e525];
                                    if _e526 {
                                    } else {
                                        phi_4631_ = true;
                                        break;
                                    }
                                    let _e543 = local_8[_e525];
                                    if _e526 {
                                    } else {
                                        phi_4631_ = true;
                                        break;
                                    }
                                    let _e546 = local_10[_e525];
                                    phi_1019_ = type_51(type_28(vec4<f32>(_e528, _e530, _e532, 0f), vec4<f32>(_e534, _e536, _e538, 0f)), _e543);
                                    phi_1020_ = (_e546 <= _e511);
                                    phi_1021_ = _e524;
                                }
                                let _e549 = phi_1019_;
                                let _e551 = phi_1020_;
                                let _e553 = phi_1021_;
                                if _e551 {
                                    let _e558 = (_e549.member_1 & 268435455u);
                                    if ((_e549.member_1 & 2147483648u) != 0u) {
                                        phi_4466_ = _e509;
                                        phi_4409_ = _e511;
                                        phi_1040_ = type_8(0u, ((_e549.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1017 = phi_4466_;
                                            let _e1019 = phi_4409_;
                                            let _e1021 = phi_1040_;
                                            if (_e1021.member < _e1021.member_1) {
                                                phi_1041_ = type_8((_e1021.member + 1u), _e1021.member_1);
                                                phi_1064_ = type_8(1u, _e1021.member);
                                            } else {
                                                phi_1041_ = _e1021;
                                                phi_1064_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1034 = phi_1041_;
                                            let _e1036 = phi_1064_;
                                            let _e1040 = (bitcast<i32>(_e1036.member) != 0i);
                                            if _e1040 {
                                                let _e1045 = (_e549.member.member_1.x - _e549.member.member.x);
                                                let _e1048 = (_e549.member.member_1.y - _e549.member.member.y);
                                                let _e1051 = (_e549.member.member_1.z - _e549.member.member.z);
                                                let _e1053 = select(_e1048, _e1045, (_e1045 > _e1048));
                                                let _e1055 = select(_e1051, _e1053, (_e1053 > _e1051));
                                                let _e1057 = (_e1055 < (1024f * _e148));
                                                if _e1057 {
                                                    phi_1105_ = 0u;
                                                } else {
                                                    phi_1105_ = select(2u, 1u, (_e1055 < (2097152f * _e148)));
                                                }
                                                let _e1062 = phi_1105_;
                                                switch bitcast<i32>(_e1062) {
                                                    case 0: {
                                                        phi_1111_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1111_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1111_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1111_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1065 = phi_1111_;
                                                switch bitcast<i32>(_e1062) {
                                                    case 0: {
                                                        phi_1121_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1121_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1121_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1121_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1072 = phi_1121_;
                                                let _e1074 = ((_e558 + (_e1036.member_1 * ((3u * _e1065) + 1u))) + (3u * _e1072));
                                                let _e1075 = (_e1074 < _e100);
                                                if _e1075 {
                                                    if _e1075 {
                                                    } else {
                                                        phi_4773_ = _e1019;
                                                        phi_4626_ = true;
                                                        break;
                                                    }
                                                    let _e1077 = global_5.member[_e1074];
                                                    phi_1137_ = _e1077;
                                                } else {
                                                    phi_1137_ = 4294967295u;
                                                }
                                                let _e1079 = phi_1137_;
                                                if _e1057 {
                                                    phi_1170_ = 0u;
                                                } else {
                                                    phi_1170_ = select(2u, 1u, (_e1055 < (2097152f * _e148)));
                                                }
                                                let _e1084 = phi_1170_;
                                                switch bitcast<i32>(_e1084) {
                                                    case 0: {
                                                        phi_1176_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1176_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1176_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1176_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1087 = phi_1176_;
                                                let _e1091 = (_e558 + (_e1036.member_1 * ((3u * _e1087) + 1u)));
                                                switch bitcast<i32>(_e1084) {
                                                    case 0: {
                                                        let _e1357 = (_e1091 < _e100);
                                                        if _e1357 {
                                                            if _e1357 {
                                                            } else {
                                                                phi_4773_ = _e1019;
                                                                phi_4626_ = true;
                                                                break;
                                                            }
                                                            let _e1359 = global_5.member[_e1091];
                                                            phi_1200_ = _e1359;
                                                        } else {
                                                            phi_1200_ = 0u;
                                                        }
                                                        let _e1361 = phi_1200_;
                                                        let _e1363 = ((10u * _e268) & 31u);
                                                        let _e1372 = ((10u * _e267) & 31u);
                                                        let _e1381 = ((10u * _e269) & 31u);
                                                        let _e1390 = (_e1091 + 1u);
                                                        let _e1391 = (_e1390 < _e100);
                                                        if _e1391 {
                                                            if _e1391 {
                                                            } else {
                                                                phi_4773_ = _e1019;
                                                                phi_4626_ = true;
                                                                break;
                                                            }
                                                            let _e1393 = global_5.member[_e1390];
                                                            phi_1243_ = _e1393;
                                                        } else {
                                                            phi_1243_ = 0u;
                                                        }
                                                        let _e1395 = phi_1243_;
                                                        let _e1418 = (_e1091 + 2u);
                                                        let _e1419 = (_e1418 < _e100);
                                                        if _e1419 {
                                                            if _e1419 {
                                                            } else {
                                                                phi_4773_ = _e1019;
                                                                phi_4626_ = true;
                                                                break;
                                                            }
                                                            let _e1421 = global_5.member[_e1418];
                                                            phi_1286_ = _e1421;
                                                        } else {
                                                            phi_1286_ = 0u;
                                                        }
                                                        let _e1423 = phi_1286_;
                                                        phi_1757_ = array<array<f32, 3>, 3>(array<f32, 3>((_e549.member.member.x + (f32(bitcast<i32>(((_e1361 >> bitcast<u32>(_e1363)) & 1023u))) * _e148)), (_e549.member.member.y + (f32(bitcast<i32>(((_e1361 >> bitcast<u32>(_e1372)) & 1023u))) * _e148)), (_e549.member.member.z + (f32(bitcast<i32>(((_e1361 >> bitcast<u32>(_e1381)) & 1023u))) * _e148))), array<f32, 3>((_e549.member.member.x + (f32(bitcast<i32>(((_e1395 >> bitcast<u32>(_e1363)) & 1023u))) * _e148)), (_e549.member.member.y + (f32(bitcast<i32>(((_e1395 >> bitcast<u32>(_e1372)) & 1023u))) * _e148)), (_e549.member.member.z + (f32(bitcast<i32>(((_e1395 >> bitcast<u32>(_e1381)) & 1023u))) * _e148))), array<f32, 3>((_e549.member.member.x + (f32(bitcast<i32>(((_e1423 >> bitcast<u32>(_e1363)) & 1023u))) * _e148)), (_e549.member.member.y + (f32(bitcast<i32>(((_e1423 >> bitcast<u32>(_e1372)) & 1023u))) * _e148)), (_e549.member.member.z + (f32(bitcast<i32>(((_e1423 >> bitcast<u32>(_e1381)) & 1023u))) * _e148))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1180 = (_e1091 < _e100);
                                                        if _e1180 {
                                                            if _e1180 {
                                                            } else {
                                                                phi_4773_ = _e1019;
                                                                phi_4626_ = true;
                                                                break;
                                                            }
                                                            let _e1182 = global_5.member[_e1091];
                                                            phi_1329_ = _e1182;
                                                        } else {
                                                            phi_1329_ = 0u;
                                                        }
                                                        let _e1184 = phi_1329_;
                                                        let _e1185 = (_e1091 + 1u);
                                                        let _e1186 = (_e1185 < _e100);
                                                        if _e1186 {
                                                            if _e1186 {
                                                            } else {
                                                                phi_4773_ = _e1019;
                                                                phi_4626_ = true;
                                                                break;
                                                            }
                                                            let _e1188 = global_5.member[_e1185];
                                                            phi_1344_ = _e1188;
                                                        } else {
                                                            phi_1344_ = 0u;
                                                        }
                                                        let _e1190 = phi_1344_;
                                                        let _e1191 = (_e268 == 1u);
                                                        if _e1191 {
                                                            phi_1354_ = ((_e1184 >> bitcast<u32>(21i)) | (_e1190 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1354_ = (_e1190 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1200 = phi_1354_;
                                                        let _e1207 = (_e267 == 1u);
                                                        if _e1207 {
                                                            phi_1374_ = ((_e1184 >> bitcast<u32>(21i)) | (_e1190 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1374_ = (_e1190 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1216 = phi_1374_;
                                                        let _e1223 = (_e269 == 1u);
                                                        if _e1223 {
                                                            phi_1394_ = ((_e1184 >> bitcast<u32>(21i)) | (_e1190 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1394_ = (_e1190 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1232 = phi_1394_;
                                                        let _e1240 = (_e1091 + 2u);
                                                        let _e1241 = (_e1240 < _e100);
                                                        if _e1241 {
                                                            if _e1241 {
                                                            } else {
                                                                phi_4773_ = _e1019;
                                                                phi_4626_ = true;
                                                                break;
                                                            }
                                                            let _e1243 = global_5.member[_e1240];
                                                            phi_1420_ = _e1243;
                                                        } else {
                                                            phi_1420_ = 0u;
                                                        }
                                                        let _e1245 = phi_1420_;
                                                        let _e1246 = (_e1091 + 3u);
                                                        let _e1247 = (_e1246 < _e100);
                                                        if _e1247 {
                                                            if _e1247 {
                                                            } else {
                                                                phi_4773_ = _e1019;
                                                                phi_4626_ = true;
                                                                break;
                                                            }
                                                            let _e1249 = global_5.member[_e1246];
                                                            phi_1435_ = _e1249;
                                                        } else {
                                                            phi_1435_ = 0u;
                                                        }
                                                        let _e1251 = phi_1435_;
                                                        if _e1191 {
                                                            phi_1445_ = ((_e1245 >> bitcast<u32>(21i)) | (_e1251 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1445_ = (_e1251 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1260 = phi_1445_;
                                                        if _e1207 {
                                                            phi_1465_ = ((_e1245 >> bitcast<u32>(21i)) | (_e1251 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1465_ = (_e1251 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1275 = phi_1465_;
                                                        if _e1223 {
                                                            phi_1485_ = ((_e1245 >> bitcast<u32>(21i)) | (_e1251 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1485_ = (_e1251 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1290 = phi_1485_;
                                                        let _e1298 = (_e1091 + 4u);
                                                        let _e1299 = (_e1298 < _e100);
                                                        if _e1299 {
                                                            if _e1299 {
                                                            } else {
                                                                phi_4773_ = _e1019;
                                                                phi_4626_ = true;
                                                                break;
                                                            }
                                                            let _e1301 = global_5.member[_e1298];
                                                            phi_1511_ = _e1301;
                                                        } else {
                                                            phi_1511_ = 0u;
                                                        }
                                                        let _e1303 = phi_1511_;
                                                        let _e1304 = (_e1091 + 5u);
                                                        let _e1305 = (_e1304 < _e100);
                                                        if _e1305 {
                                                            if _e1305 {
                                                            } else {
                                                                phi_4773_ = _e1019;
                                                                phi_4626_ = true;
                                                                break;
                                                            }
                                                            let _e1307 = global_5.member[_e1304];
                                                            phi_1526_ = _e1307;
                                                        } else {
                                                            phi_1526_ = 0u;
                                                        }
                                                        let _e1309 = phi_1526_;
                                                        if _e1191 {
                                                            phi_1536_ = ((_e1303 >> bitcast<u32>(21i)) | (_e1309 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1536_ = (_e1309 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1318 = phi_1536_;
                                                        if _e1207 {
                                                            phi_1556_ = ((_e1303 >> bitcast<u32>(21i)) | (_e1309 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1556_ = (_e1309 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1333 = phi_1556_;
                                                        if _e1223 {
                                                            phi_1576_ = ((_e1303 >> bitcast<u32>(21i)) | (_e1309 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1576_ = (_e1309 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1348 = phi_1576_;
                                                        phi_1757_ = array<array<f32, 3>, 3>(array<f32, 3>((_e549.member.member.x + (f32(bitcast<i32>((select(_e1200, _e1184, _e307) & 2097151u))) * _e148)), (_e549.member.member.y + (f32(bitcast<i32>((select(_e1216, _e1184, _e346) & 2097151u))) * _e148)), (_e549.member.member.z + (f32(bitcast<i32>((select(_e1232, _e1184, _e384) & 2097151u))) * _e148))), array<f32, 3>((_e549.member.member.x + (f32(bitcast<i32>((select(_e1260, _e1245, _e307) & 2097151u))) * _e148)), (_e549.member.member.y + (f32(bitcast<i32>((select(_e1275, _e1245, _e346) & 2097151u))) * _e148)), (_e549.member.member.z + (f32(bitcast<i32>((select(_e1290, _e1245, _e384) & 2097151u))) * _e148))), array<f32, 3>((_e549.member.member.x + (f32(bitcast<i32>((select(_e1318, _e1303, _e307) & 2097151u))) * _e148)), (_e549.member.member.y + (f32(bitcast<i32>((select(_e1333, _e1303, _e346) & 2097151u))) * _e148)), (_e549.member.member.z + (f32(bitcast<i32>((select(_e1348, _e1303, _e384) & 2097151u))) * _e148))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1093 = (_e1091 + _e268);
                                                        let _e1094 = (_e1093 < _e100);
                                                        if _e1094 {
                                                            if _e1094 {
                                                            } else {
                                                                phi_4773_ = _e1019;
                                                                phi_4626_ = true;
                                                                break;
                                                            }
                                                            let _e1096 = global_5.member[_e1093];
                                                            phi_1603_ = _e1096;
                                                        } else {
                                                            phi_1603_ = 0u;
                                                        }
                                                        let _e1098 = phi_1603_;
                                                        let _e1102 = (_e1091 + _e267);
                                                        let _e1103 = (_e1102 < _e100);
                                                        if _e1103 {
                                                            if _e1103 {
                                                            } else {
                                                                phi_4773_ = _e1019;
                                                                phi_4626_ = true;
                                                                break;
                                                            }
                                                            let _e1105 = global_5.member[_e1102];
                                                            phi_1621_ = _e1105;
                                                        } else {
                                                            phi_1621_ = 0u;
                                                        }
                                                        let _e1107 = phi_1621_;
                                                        let _e1111 = (_e1091 + _e269);
                                                        let _e1112 = (_e1111 < _e100);
                                                        if _e1112 {
                                                            if _e1112 {
                                                            } else {
                                                                phi_4773_ = _e1019;
                                                                phi_4626_ = true;
                                                                break;
                                                            }
                                                            let _e1114 = global_5.member[_e1111];
                                                            phi_1639_ = _e1114;
                                                        } else {
                                                            phi_1639_ = 0u;
                                                        }
                                                        let _e1116 = phi_1639_;
                                                        let _e1121 = (_e1091 + 3u);
                                                        let _e1122 = (_e1121 + _e268);
                                                        let _e1123 = (_e1122 < _e100);
                                                        if _e1123 {
                                                            if _e1123 {
                                                            } else {
                                                                phi_4773_ = _e1019;
                                                                phi_4626_ = true;
                                                                break;
                                                            }
                                                            let _e1125 = global_5.member[_e1122];
                                                            phi_1659_ = _e1125;
                                                        } else {
                                                            phi_1659_ = 0u;
                                                        }
                                                        let _e1127 = phi_1659_;
                                                        let _e1131 = (_e1121 + _e267);
                                                        let _e1132 = (_e1131 < _e100);
                                                        if _e1132 {
                                                            if _e1132 {
                                                            } else {
                                                                phi_4773_ = _e1019;
                                                                phi_4626_ = true;
                                                                break;
                                                            }
                                                            let _e1134 = global_5.member[_e1131];
                                                            phi_1677_ = _e1134;
                                                        } else {
                                                            phi_1677_ = 0u;
                                                        }
                                                        let _e1136 = phi_1677_;
                                                        let _e1140 = (_e1121 + _e269);
                                                        let _e1141 = (_e1140 < _e100);
                                                        if _e1141 {
                                                            if _e1141 {
                                                            } else {
                                                                phi_4773_ = _e1019;
                                                                phi_4626_ = true;
                                                                break;
                                                            }
                                                            let _e1143 = global_5.member[_e1140];
                                                            phi_1695_ = _e1143;
                                                        } else {
                                                            phi_1695_ = 0u;
                                                        }
                                                        let _e1145 = phi_1695_;
                                                        let _e1150 = (_e1091 + 6u);
                                                        let _e1151 = (_e1150 + _e268);
                                                        let _e1152 = (_e1151 < _e100);
                                                        if _e1152 {
                                                            if _e1152 {
                                                            } else {
                                                                phi_4773_ = _e1019;
                                                                phi_4626_ = true;
                                                                break;
                                                            }
                                                            let _e1154 = global_5.member[_e1151];
                                                            phi_1715_ = _e1154;
                                                        } else {
                                                            phi_1715_ = 0u;
                                                        }
                                                        let _e1156 = phi_1715_;
                                                        let _e1160 = (_e1150 + _e267);
                                                        let _e1161 = (_e1160 < _e100);
                                                        if _e1161 {
                                                            if _e1161 {
                                                            } else {
                                                                phi_4773_ = _e1019;
                                                                phi_4626_ = true;
                                                                break;
                                                            }
                                                            let _e1163 = global_5.member[_e1160];
                                                            phi_1733_ = _e1163;
                                                        } else {
                                                            phi_1733_ = 0u;
                                                        }
                                                        let _e1165 = phi_1733_;
                                                        let _e1169 = (_e1150 + _e269);
                                                        let _e1170 = (_e1169 < _e100);
                                                        if _e1170 {
                                                            if _e1170 {
                                                            } else {
                                                                phi_4773_ = _e1019;
                                                                phi_4626_ = true;
                                                                break;
                                                            }
                                                            let _e1172 = global_5.member[_e1169];
                                                            phi_1751_ = _e1172;
                                                        } else {
                                                            phi_1751_ = 0u;
                                                        }
                                                        let _e1174 = phi_1751_;
                                                        phi_1757_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1098)) * _e148), (f32(bitcast<i32>(_e1107)) * _e148), (f32(bitcast<i32>(_e1116)) * _e148)), array<f32, 3>((f32(bitcast<i32>(_e1127)) * _e148), (f32(bitcast<i32>(_e1136)) * _e148), (f32(bitcast<i32>(_e1145)) * _e148)), array<f32, 3>((f32(bitcast<i32>(_e1156)) * _e148), (f32(bitcast<i32>(_e1165)) * _e148), (f32(bitcast<i32>(_e1174)) * _e148)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1757_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1448 = phi_1757_;
                                                let _e1455 = (_e1448[0][2] - _e394);
                                                let _e1458 = (((_e1448[0][0] - _e317) * _e418) - (_e1455 * _e342));
                                                let _e1461 = (((_e1448[0][1] - _e356) * _e418) - (_e1455 * _e380));
                                                let _e1468 = (_e1448[1][2] - _e394);
                                                let _e1471 = (((_e1448[1][0] - _e317) * _e418) - (_e1468 * _e342));
                                                let _e1474 = (((_e1448[1][1] - _e356) * _e418) - (_e1468 * _e380));
                                                let _e1481 = (_e1448[2][2] - _e394);
                                                let _e1484 = (((_e1448[2][0] - _e317) * _e418) - (_e1481 * _e342));
                                                let _e1487 = (((_e1448[2][1] - _e356) * _e418) - (_e1481 * _e380));
                                                let _e1488 = (_e1484 * _e1474);
                                                let _e1489 = (_e1487 * _e1471);
                                                let _e1490 = (_e1458 * _e1487);
                                                let _e1491 = (_e1461 * _e1484);
                                                let _e1492 = (_e1471 * _e1461);
                                                let _e1493 = (_e1474 * _e1458);
                                                let _e1498 = (((_e1488 >= _e1489) && (_e1490 >= _e1491)) && (_e1492 >= _e1493));
                                                if (_e1498 || (((_e1488 <= _e1489) && (_e1490 <= _e1491)) && (_e1492 <= _e1493))) {
                                                    let _e1505 = select(-1f, 1f, _e1498);
                                                    let _e1507 = ((_e1488 - _e1489) * _e1505);
                                                    let _e1509 = select(0f, _e1507, (_e1507 > 0f));
                                                    let _e1511 = ((_e1490 - _e1491) * _e1505);
                                                    let _e1513 = select(0f, _e1511, (_e1511 > 0f));
                                                    let _e1515 = ((_e1492 - _e1493) * _e1505);
                                                    let _e1517 = select(0f, _e1515, (_e1515 > 0f));
                                                    let _e1519 = ((_e1509 + _e1513) + _e1517);
                                                    if (_e1519 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2583_ = type_24();
                                                        phi_2584_ = true;
                                                        phi_2585_ = false;
                                                    } else {
                                                        let _e1522 = select(_e1471, _e1458, (_e1458 < _e1471));
                                                        if (select(_e1484, _e1522, (_e1522 < _e1484)) > 0f) {
                                                            phi_1875_ = true;
                                                        } else {
                                                            let _e1527 = select(_e1471, _e1458, (_e1458 > _e1471));
                                                            phi_1875_ = (select(_e1484, _e1527, (_e1527 > _e1484)) < 0f);
                                                        }
                                                        let _e1532 = phi_1875_;
                                                        if _e1532 {
                                                            phi_2580_ = type_24();
                                                            phi_2581_ = true;
                                                            phi_2582_ = false;
                                                        } else {
                                                            let _e1534 = select(_e1474, _e1461, (_e1461 < _e1474));
                                                            if (select(_e1487, _e1534, (_e1534 < _e1487)) > 0f) {
                                                                phi_1904_ = true;
                                                            } else {
                                                                let _e1539 = select(_e1474, _e1461, (_e1461 > _e1474));
                                                                phi_1904_ = (select(_e1487, _e1539, (_e1539 > _e1487)) < 0f);
                                                            }
                                                            let _e1544 = phi_1904_;
                                                            if _e1544 {
                                                                phi_2578_ = type_24();
                                                                phi_2579_ = false;
                                                            } else {
                                                                let _e1546 = select(_e1448[1][0], _e1448[0][0], (_e1448[0][0] < _e1448[1][0]));
                                                                let _e1550 = select(_e1448[1][0], _e1448[0][0], (_e1448[0][0] > _e1448[1][0]));
                                                                let _e1554 = select(_e1448[1][1], _e1448[0][1], (_e1448[0][1] < _e1448[1][1]));
                                                                let _e1558 = select(_e1448[1][1], _e1448[0][1], (_e1448[0][1] > _e1448[1][1]));
                                                                let _e1562 = select(_e1448[1][2], _e1448[0][2], (_e1448[0][2] < _e1448[1][2]));
                                                                let _e1566 = select(_e1448[1][2], _e1448[0][2], (_e1448[0][2] > _e1448[1][2]));
                                                                let _e1571 = ((select(_e1448[2][0], _e1546, (_e1546 < _e1448[2][0])) - _e340) * _e345);
                                                                let _e1572 = ((select(_e1448[2][0], _e1550, (_e1550 > _e1448[2][0])) - _e341) * _e345);
                                                                let _e1575 = ((select(_e1448[2][1], _e1554, (_e1554 < _e1448[2][1])) - _e378) * _e383);
                                                                let _e1576 = ((select(_e1448[2][1], _e1558, (_e1558 > _e1448[2][1])) - _e379) * _e383);
                                                                let _e1579 = ((select(_e1448[2][2], _e1562, (_e1562 < _e1448[2][2])) - _e416) * _e421);
                                                                let _e1580 = ((select(_e1448[2][2], _e1566, (_e1566 > _e1448[2][2])) - _e417) * _e421);
                                                                let _e1582 = select(_e1580, _e1579, (_e1579 < _e1580));
                                                                let _e1584 = select(_e1580, _e1579, (_e1579 > _e1580));
                                                                let _e1586 = select(_e1572, _e1571, (_e1571 < _e1572));
                                                                let _e1588 = select(_e1576, _e1575, (_e1575 < _e1576));
                                                                let _e1590 = select(_e1588, _e1586, (_e1586 > _e1588));
                                                                let _e1592 = select(_e1582, _e1590, (_e1590 > _e1582));
                                                                let _e1594 = select(_e1572, _e1571, (_e1571 > _e1572));
                                                                let _e1596 = select(_e1576, _e1575, (_e1575 > _e1576));
                                                                let _e1598 = select(_e1596, _e1594, (_e1594 < _e1596));
                                                                let _e1600 = select(_e1584, _e1598, (_e1598 < _e1584));
                                                                let _e1601 = -(_e1582);
                                                                let _e1607 = select(_e468, _e1592, (_e1592 > _e468));
                                                                if (_e1607 > (_e1600 + (select(_e1601, _e1584, (_e1584 > _e1601)) * 0.0000019073523f))) {
                                                                    phi_2573_ = type_24();
                                                                    phi_2574_ = true;
                                                                } else {
                                                                    let _e1609 = (_e1607 > _e1019);
                                                                    if _e1609 {
                                                                        phi_2572_ = type_24();
                                                                    } else {
                                                                        let _e1610 = vec3<f32>(_e1448[0][0], _e1448[0][1], _e1448[0][2]);
                                                                        let _e1611 = vec3<f32>(_e1448[1][0], _e1448[1][1], _e1448[1][2]);
                                                                        let _e1612 = vec3<f32>(_e1448[2][0], _e1448[2][1], _e1448[2][2]);
                                                                        let _e1613 = (_e1448[1][0] - _e1448[0][0]);
                                                                        let _e1614 = (_e1448[1][1] - _e1448[0][1]);
                                                                        let _e1615 = (_e1448[1][2] - _e1448[0][2]);
                                                                        let _e1616 = vec3<f32>(_e1613, _e1614, _e1615);
                                                                        let _e1617 = (_e1448[2][0] - _e1448[1][0]);
                                                                        let _e1618 = (_e1448[2][1] - _e1448[1][1]);
                                                                        let _e1619 = (_e1448[2][2] - _e1448[1][2]);
                                                                        let _e1620 = vec3<f32>(_e1617, _e1618, _e1619);
                                                                        let _e1621 = (_e1448[0][0] - _e1448[2][0]);
                                                                        let _e1622 = (_e1448[0][1] - _e1448[2][1]);
                                                                        let _e1623 = (_e1448[0][2] - _e1448[2][2]);
                                                                        let _e1624 = vec3<f32>(_e1621, _e1622, _e1623);
                                                                        let _e1627 = bitcast<f32>((bitcast<u32>(_e1613) & 2147483647u));
                                                                        let _e1630 = bitcast<f32>((bitcast<u32>(_e1614) & 2147483647u));
                                                                        let _e1632 = select(_e1630, _e1627, (_e1627 > _e1630));
                                                                        let _e1635 = bitcast<f32>((bitcast<u32>(_e1615) & 2147483647u));
                                                                        let _e1637 = select(_e1635, _e1632, (_e1632 > _e1635));
                                                                        let _e1640 = bitcast<f32>((bitcast<u32>(_e1617) & 2147483647u));
                                                                        let _e1643 = bitcast<f32>((bitcast<u32>(_e1618) & 2147483647u));
                                                                        let _e1645 = select(_e1643, _e1640, (_e1640 > _e1643));
                                                                        let _e1648 = bitcast<f32>((bitcast<u32>(_e1619) & 2147483647u));
                                                                        let _e1650 = select(_e1648, _e1645, (_e1645 > _e1648));
                                                                        let _e1653 = bitcast<f32>((bitcast<u32>(_e1621) & 2147483647u));
                                                                        let _e1656 = bitcast<f32>((bitcast<u32>(_e1622) & 2147483647u));
                                                                        let _e1658 = select(_e1656, _e1653, (_e1653 > _e1656));
                                                                        let _e1661 = bitcast<f32>((bitcast<u32>(_e1623) & 2147483647u));
                                                                        let _e1663 = select(_e1661, _e1658, (_e1658 > _e1661));
                                                                        let _e1665 = select(_e1650, _e1637, (_e1637 > _e1650));
                                                                        let _e1667 = select(_e1663, _e1665, (_e1665 > _e1663));
                                                                        if (_e1637 == _e1667) {
                                                                            phi_2305_ = _e1474;
                                                                            phi_2306_ = _e1471;
                                                                            phi_2307_ = _e1461;
                                                                            phi_2308_ = _e1458;
                                                                            phi_2309_ = _e1610;
                                                                            phi_2310_ = _e1624;
                                                                            phi_2311_ = _e1620;
                                                                            phi_2312_ = _e1616;
                                                                        } else {
                                                                            let _e1669 = (_e1650 == _e1667);
                                                                            let _e1674 = vec3(_e1669);
                                                                            phi_2305_ = select(_e1461, _e1487, _e1669);
                                                                            phi_2306_ = select(_e1458, _e1484, _e1669);
                                                                            phi_2307_ = select(_e1487, _e1474, _e1669);
                                                                            phi_2308_ = select(_e1484, _e1471, _e1669);
                                                                            phi_2309_ = select(_e1612, _e1611, _e1674);
                                                                            phi_2310_ = select(_e1620, _e1616, _e1674);
                                                                            phi_2311_ = select(_e1616, _e1624, _e1674);
                                                                            phi_2312_ = select(_e1624, _e1620, _e1674);
                                                                        }
                                                                        let _e1680 = phi_2305_;
                                                                        let _e1682 = phi_2306_;
                                                                        let _e1684 = phi_2307_;
                                                                        let _e1686 = phi_2308_;
                                                                        let _e1688 = phi_2309_;
                                                                        let _e1690 = phi_2310_;
                                                                        let _e1692 = phi_2311_;
                                                                        let _e1694 = phi_2312_;
                                                                        let _e1701 = ((_e1692.y * _e1690.z) - (_e1690.y * _e1692.z));
                                                                        let _e1706 = ((_e1692.z * _e1690.x) - (_e1690.z * _e1692.x));
                                                                        let _e1709 = ((_e1692.x * _e1690.y) - (_e1690.x * _e1692.y));
                                                                        if (_e1509 >= _e1513) {
                                                                            phi_2343_ = select(true, false, (_e1509 >= _e1517));
                                                                        } else {
                                                                            phi_2343_ = true;
                                                                        }
                                                                        let _e1714 = phi_2343_;
                                                                        if _e1714 {
                                                                            phi_2352_ = select(_e1612, _e1611, vec3((_e1513 >= _e1517)));
                                                                        } else {
                                                                            phi_2352_ = _e1610;
                                                                        }
                                                                        let _e1719 = phi_2352_;
                                                                        let _e1730 = (((_e1701 * (_e1719.x - _e317)) + (_e1706 * (_e1719.y - _e356))) + (_e1709 * (_e1719.z - _e394)));
                                                                        let _e1735 = (((_e1701 * _e342) + (_e1706 * _e380)) + (_e1709 * _e418));
                                                                        let _e1736 = (_e1682 - _e1686);
                                                                        let _e1737 = (_e1680 - _e1684);
                                                                        let _e1745 = (-(((_e1686 * _e1736) + (_e1684 * _e1737))) / ((_e1736 * _e1736) + (_e1737 * _e1737)));
                                                                        let _e1747 = select(1f, _e1745, (_e1745 < 1f));
                                                                        let _e1749 = select(0f, _e1747, (_e1747 > 0f));
                                                                        let _e1762 = ((_e1688.x + (_e1694.x * _e1749)) - _e317);
                                                                        let _e1763 = ((_e1688.y + (_e1694.y * _e1749)) - _e356);
                                                                        let _e1764 = ((_e1688.z + (_e1694.z * _e1749)) - _e394);
                                                                        let _e1765 = (_e1764 / _e418);
                                                                        let _e1777 = bitcast<f32>((bitcast<u32>(_e1762) & 2147483647u));
                                                                        let _e1780 = bitcast<f32>((bitcast<u32>(_e1763) & 2147483647u));
                                                                        let _e1782 = select(_e1780, _e1777, (_e1777 > _e1780));
                                                                        let _e1785 = bitcast<f32>((bitcast<u32>(_e1764) & 2147483647u));
                                                                        let _e1787 = select(_e1785, _e1782, (_e1782 > _e1785));
                                                                        let _e1793 = bitcast<f32>((bitcast<u32>(_e1701) & 2147483647u));
                                                                        let _e1796 = bitcast<f32>((bitcast<u32>(_e1706) & 2147483647u));
                                                                        let _e1798 = select(_e1796, _e1793, (_e1793 > _e1796));
                                                                        let _e1801 = bitcast<f32>((bitcast<u32>(_e1709) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1701 * _e1762) + (_e1706 * _e1763)) + (_e1709 * _e1764)) - _e1730)) & 2147483647u)) <= ((0.0000009536743f * select(_e1667, _e1787, (_e1787 > _e1667))) * select(_e1801, _e1798, (_e1798 > _e1801)))) {
                                                                            let _e1811 = bitcast<f32>((bitcast<u32>(_e1692.x) & 2147483647u));
                                                                            let _e1814 = bitcast<f32>((bitcast<u32>(_e1692.y) & 2147483647u));
                                                                            let _e1816 = select(_e1814, _e1811, (_e1811 > _e1814));
                                                                            let _e1819 = bitcast<f32>((bitcast<u32>(_e1692.z) & 2147483647u));
                                                                            let _e1825 = bitcast<f32>((bitcast<u32>(_e1690.x) & 2147483647u));
                                                                            let _e1828 = bitcast<f32>((bitcast<u32>(_e1690.y) & 2147483647u));
                                                                            let _e1830 = select(_e1828, _e1825, (_e1825 > _e1828));
                                                                            let _e1833 = bitcast<f32>((bitcast<u32>(_e1690.z) & 2147483647u));
                                                                            let _e1837 = (bitcast<f32>((bitcast<u32>(_e1735) & 2147483647u)) > ((0.0000038146973f * select(_e1819, _e1816, (_e1816 > _e1819))) * select(_e1833, _e1830, (_e1830 > _e1833))));
                                                                            if _e1837 {
                                                                                phi_2517_ = (_e1730 / _e1735);
                                                                            } else {
                                                                                phi_2517_ = f32();
                                                                            }
                                                                            let _e1840 = phi_2517_;
                                                                            phi_2519_ = _e1840;
                                                                            phi_2520_ = select(true, false, _e1837);
                                                                        } else {
                                                                            phi_2519_ = f32();
                                                                            phi_2520_ = true;
                                                                        }
                                                                        let _e1843 = phi_2519_;
                                                                        let _e1845 = phi_2520_;
                                                                        if _e1845 {
                                                                            let _e1853 = (((_e1701 * (_e1762 - (_e342 * _e1765))) + (_e1706 * (_e1763 - (_e380 * _e1765)))) / _e1735);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1853) & 2147483647u)) <= _e1667) {
                                                                                phi_2540_ = (_e1765 + _e1853);
                                                                            } else {
                                                                                phi_2540_ = _e1765;
                                                                            }
                                                                            let _e1860 = phi_2540_;
                                                                            phi_2541_ = _e1860;
                                                                        } else {
                                                                            phi_2541_ = _e1843;
                                                                        }
                                                                        let _e1862 = phi_2541_;
                                                                        let _e1864 = select(_e1600, _e1862, (_e1862 < _e1600));
                                                                        let _e1866 = select(_e1592, _e1864, (_e1864 > _e1592));
                                                                        if (_e1866 >= _e468) {
                                                                            let _e1868 = (_e1866 <= _e1019);
                                                                            if _e1868 {
                                                                                let _e1869 = (1f / _e1519);
                                                                                phi_2564_ = type_24(_e1866, (_e1513 * _e1869), (_e1517 * _e1869), _e1079);
                                                                            } else {
                                                                                phi_2564_ = type_24();
                                                                            }
                                                                            let _e1874 = phi_2564_;
                                                                            phi_2566_ = _e1874;
                                                                            phi_2567_ = select(true, false, _e1868);
                                                                        } else {
                                                                            phi_2566_ = type_24();
                                                                            phi_2567_ = true;
                                                                        }
                                                                        let _e1877 = phi_2566_;
                                                                        let _e1879 = phi_2567_;
                                                                        if _e1879 {
                                                                            phi_2571_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2571_ = _e1877;
                                                                        }
                                                                        let _e1881 = phi_2571_;
                                                                        phi_2572_ = _e1881;
                                                                    }
                                                                    let _e1883 = phi_2572_;
                                                                    phi_2573_ = _e1883;
                                                                    phi_2574_ = _e1609;
                                                                }
                                                                let _e1885 = phi_2573_;
                                                                let _e1887 = phi_2574_;
                                                                phi_2578_ = _e1885;
                                                                phi_2579_ = _e1887;
                                                            }
                                                            let _e1889 = phi_2578_;
                                                            let _e1891 = phi_2579_;
                                                            phi_2580_ = _e1889;
                                                            phi_2581_ = _e1544;
                                                            phi_2582_ = _e1891;
                                                        }
                                                        let _e1893 = phi_2580_;
                                                        let _e1895 = phi_2581_;
                                                        let _e1897 = phi_2582_;
                                                        phi_2583_ = _e1893;
                                                        phi_2584_ = _e1895;
                                                        phi_2585_ = _e1897;
                                                    }
                                                    let _e1899 = phi_2583_;
                                                    let _e1901 = phi_2584_;
                                                    let _e1903 = phi_2585_;
                                                    phi_2593_ = _e1899;
                                                    phi_2594_ = select(_e1903, true, _e1901);
                                                } else {
                                                    phi_2593_ = type_24();
                                                    phi_2594_ = true;
                                                }
                                                let _e1906 = phi_2593_;
                                                let _e1908 = phi_2594_;
                                                if _e1908 {
                                                    phi_2598_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2598_ = _e1906;
                                                }
                                                let _e1910 = phi_2598_;
                                                if (_e1910.member_3 != 4294967295u) {
                                                    if (_e1079 != 4294967295u) {
                                                        phi_2610_ = type_8(0u, 8u);
                                                        phi_2613_ = _e1910;
                                                        loop {
                                                            let _e1915 = phi_2610_;
                                                            let _e1917 = phi_2613_;
                                                            if (_e1915.member < _e1915.member_1) {
                                                                phi_2611_ = type_8((_e1915.member + 1u), _e1915.member_1);
                                                                phi_2636_ = type_8(1u, _e1915.member);
                                                            } else {
                                                                phi_2611_ = _e1915;
                                                                phi_2636_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1930 = phi_2611_;
                                                            let _e1932 = phi_2636_;
                                                            let _e1936 = (bitcast<i32>(_e1932.member) != 0i);
                                                            if _e1936 {
                                                                let _e1937 = (_e1932.member_1 < 8u);
                                                                if _e1937 {
                                                                } else {
                                                                    phi_4437_ = true;
                                                                    break;
                                                                }
                                                                let _e1942 = local_9[_e1932.member_1].member;
                                                                if (_e1917.member < _e1942) {
                                                                    phi_2669_ = true;
                                                                } else {
                                                                    let _e1944 = local_9[_e1932.member_1].member;
                                                                    if (_e1917.member == _e1944) {
                                                                        let _e1949 = local_9[_e1932.member_1].member_3;
                                                                        phi_2668_ = (_e1917.member_3 < _e1949);
                                                                    } else {
                                                                        phi_2668_ = false;
                                                                    }
                                                                    let _e1952 = phi_2668_;
                                                                    phi_2669_ = _e1952;
                                                                }
                                                                let _e1954 = phi_2669_;
                                                                if _e1954 {
                                                                    if _e1937 {
                                                                    } else {
                                                                        phi_4437_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1955 = local_9[_e1932.member_1];
                                                                    local_9[_e1932.member_1] = type_24(_e1917.member, _e1917.member_1, _e1917.member_2, _e1917.member_3);
                                                                    phi_2690_ = type_24(_e1955.member, _e1955.member_1, _e1955.member_2, _e1955.member_3);
                                                                } else {
                                                                    phi_2690_ = _e1917;
                                                                }
                                                                let _e1966 = phi_2690_;
                                                                phi_2614_ = _e1966;
                                                            } else {
                                                                phi_2614_ = type_24();
                                                            }
                                                            let _e1968 = phi_2614_;
                                                            continue;
                                                            continuing {
                                                                phi_2610_ = _e1930;
                                                                phi_2613_ = _e1968;
                                                                phi_4437_ = _e1017;
                                                                break if !(_e1936);
                                                            }
                                                        }
                                                        let _e1971 = phi_4437_;
                                                        phi_4773_ = _e1019;
                                                        phi_4626_ = _e1971;
                                                        if _e1971 {
                                                            break;
                                                        }
                                                        let _e1974 = local_9[7u].member_3;
                                                        if (_e1974 != 4294967295u) {
                                                            let _e1978 = local_9[7u].member;
                                                            phi_4864_ = _e1978;
                                                        } else {
                                                            phi_4864_ = _e1019;
                                                        }
                                                        let _e1980 = phi_4864_;
                                                        phi_4863_ = _e1980;
                                                        phi_4629_ = _e1971;
                                                    } else {
                                                        phi_4863_ = _e1019;
                                                        phi_4629_ = _e1017;
                                                    }
                                                    let _e1982 = phi_4863_;
                                                    let _e1984 = phi_4629_;
                                                    phi_4862_ = _e1982;
                                                    phi_4628_ = _e1984;
                                                } else {
                                                    phi_4862_ = _e1019;
                                                    phi_4628_ = _e1017;
                                                }
                                                let _e1986 = phi_4862_;
                                                let _e1988 = phi_4628_;
                                                phi_4861_ = _e1986;
                                                phi_4627_ = _e1988;
                                            } else {
                                                phi_4861_ = _e1019;
                                                phi_4627_ = _e1017;
                                            }
                                            let _e1990 = phi_4861_;
                                            let _e1992 = phi_4627_;
                                            continue;
                                            continuing {
                                                phi_4466_ = _e1992;
                                                phi_4409_ = _e1990;
                                                phi_1040_ = _e1034;
                                                phi_4773_ = _e1990;
                                                phi_4626_ = _e1992;
                                                break if !(_e1040);
                                            }
                                        }
                                        let _e1995 = phi_4773_;
                                        let _e1997 = phi_4626_;
                                        phi_4631_ = _e1997;
                                        if _e1997 {
                                            break;
                                        }
                                        phi_4738_ = _e1995;
                                        phi_4635_ = _e1997;
                                        phi_3942_ = _e549;
                                        phi_3943_ = false;
                                        phi_3944_ = _e553;
                                    } else {
                                        if (_e549.member_1 >= _e97) {
                                            phi_3497_ = type_52(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_51(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_51(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e549.member_1 < _e97) {
                                            } else {
                                                phi_4631_ = true;
                                                break;
                                            }
                                            let _e566 = ((1u + _e268) % 4u);
                                            if (_e566 < 4u) {
                                            } else {
                                                phi_4631_ = true;
                                                break;
                                            }
                                            let _e571 = global_3.member[_e549.member_1][_e566];
                                            let _e573 = (_e571 >> bitcast<u32>(11u));
                                            let _e575 = ((1u + _e267) % 4u);
                                            if (_e575 < 4u) {
                                            } else {
                                                phi_4631_ = true;
                                                break;
                                            }
                                            let _e580 = global_3.member[_e549.member_1][_e575];
                                            let _e582 = (_e580 >> bitcast<u32>(11u));
                                            let _e584 = ((1u + _e269) % 4u);
                                            if (_e584 < 4u) {
                                            } else {
                                                phi_4631_ = true;
                                                break;
                                            }
                                            let _e589 = global_3.member[_e549.member_1][_e584];
                                            let _e591 = (_e589 >> bitcast<u32>(11u));
                                            let _e614 = (bitcast<f32>((bitcast<u32>((_e549.member.member_1.x - _e549.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e615 = (bitcast<f32>((bitcast<u32>((_e549.member.member_1.y - _e549.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e616 = (bitcast<f32>((bitcast<u32>((_e549.member.member_1.z - _e549.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e618 = select(_e148, _e614, (_e614 > _e148));
                                            let _e620 = select(_e148, _e615, (_e615 > _e148));
                                            let _e622 = select(_e148, _e616, (_e616 > _e148));
                                            let _e647 = bitcast<u32>((f32(bitcast<i32>((_e571 & 1023u))) * _e618));
                                            let _e652 = (bitcast<i32>((_e571 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e655 = bitcast<f32>((_e647 & bitcast<u32>(_e652)));
                                            let _e656 = bitcast<u32>((f32(bitcast<i32>((_e580 & 1023u))) * _e620));
                                            let _e661 = (bitcast<i32>((_e580 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e664 = bitcast<f32>((_e656 & bitcast<u32>(_e661)));
                                            let _e665 = bitcast<u32>((f32(bitcast<i32>((_e589 & 1023u))) * _e622));
                                            let _e670 = (bitcast<i32>((_e589 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e673 = bitcast<f32>((_e665 & bitcast<u32>(_e670)));
                                            let _e677 = bitcast<f32>((_e647 & bitcast<u32>(~(_e652))));
                                            let _e681 = bitcast<f32>((_e656 & bitcast<u32>(~(_e661))));
                                            let _e685 = bitcast<f32>((_e665 & bitcast<u32>(~(_e670))));
                                            let _e686 = bitcast<u32>((f32(bitcast<i32>((_e573 & 1023u))) * _e618));
                                            let _e691 = (bitcast<i32>((_e573 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e694 = bitcast<f32>((_e686 & bitcast<u32>(_e691)));
                                            let _e695 = bitcast<u32>((f32(bitcast<i32>((_e582 & 1023u))) * _e620));
                                            let _e700 = (bitcast<i32>((_e582 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e703 = bitcast<f32>((_e695 & bitcast<u32>(_e700)));
                                            let _e704 = bitcast<u32>((f32(bitcast<i32>((_e591 & 1023u))) * _e622));
                                            let _e709 = (bitcast<i32>((_e591 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e712 = bitcast<f32>((_e704 & bitcast<u32>(_e709)));
                                            let _e716 = bitcast<f32>((_e686 & bitcast<u32>(~(_e691))));
                                            let _e720 = bitcast<f32>((_e695 & bitcast<u32>(~(_e700))));
                                            let _e724 = bitcast<f32>((_e704 & bitcast<u32>(~(_e709))));
                                            let _e725 = (_e549.member.member.x + _e655);
                                            let _e726 = (_e549.member.member.y + _e664);
                                            let _e727 = (_e549.member.member.z + _e673);
                                            let _e730 = (_e549.member.member_1.x - _e694);
                                            let _e731 = (_e549.member.member_1.y - _e703);
                                            let _e732 = (_e549.member.member_1.z - _e712);
                                            let _e751 = (_e730 - _e725);
                                            let _e752 = (_e731 - _e726);
                                            let _e753 = (_e732 - _e727);
                                            let _e755 = select(_e752, _e751, (_e751 > _e752));
                                            let _e757 = select(_e753, _e755, (_e755 > _e753));
                                            if (_e757 < (1024f * _e148)) {
                                                phi_3198_ = 0u;
                                            } else {
                                                phi_3198_ = select(2u, 1u, (_e757 < (2097152f * _e148)));
                                            }
                                            let _e764 = phi_3198_;
                                            switch bitcast<i32>(_e764) {
                                                case 0: {
                                                    phi_3204_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3204_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3204_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3204_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e767 = phi_3204_;
                                            let _e773 = global_3.member[_e549.member_1][0u];
                                            let _e777 = global_3.member[_e549.member_1][1u];
                                            let _e781 = global_3.member[_e549.member_1][2u];
                                            let _e785 = global_3.member[_e549.member_1][3u];
                                            let _e797 = (((_e777 >> bitcast<u32>(22i)) | ((_e781 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e785 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e798 = (_e773 & 268435455u);
                                            let _e799 = (_e797 & 268435455u);
                                            let _e802 = ((_e773 >> bitcast<u32>(28u)) & 7u);
                                            let _e810 = ((_e773 >> bitcast<u32>(31i)) | (((_e797 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e811 = (_e802 != 0u);
                                            if (_e802 == 0u) {
                                                phi_3459_ = _e798;
                                            } else {
                                                if (_e802 == 7u) {
                                                    phi_3458_ = 2147483648u;
                                                } else {
                                                    phi_3458_ = ((2147483648u | (_e802 << bitcast<u32>(28u))) | (_e799 & 268435455u));
                                                }
                                                let _e820 = phi_3458_;
                                                phi_3459_ = _e820;
                                            }
                                            let _e822 = phi_3459_;
                                            if _e811 {
                                                let _e823 = (_e802 != 7u);
                                                if _e823 {
                                                    phi_3469_ = (_e799 + (_e802 * ((3u * _e767) + 1u)));
                                                } else {
                                                    phi_3469_ = u32();
                                                }
                                                let _e827 = phi_3469_;
                                                phi_3471_ = _e827;
                                                phi_3472_ = select(true, false, _e823);
                                            } else {
                                                phi_3471_ = u32();
                                                phi_3472_ = true;
                                            }
                                            let _e830 = phi_3471_;
                                            let _e832 = phi_3472_;
                                            if (_e810 == 0u) {
                                                phi_3493_ = (_e798 + select(0u, 1u, !(_e811)));
                                            } else {
                                                if (_e810 == 7u) {
                                                    phi_3492_ = 2147483648u;
                                                } else {
                                                    phi_3492_ = ((2147483648u | (_e810 << bitcast<u32>(28u))) | (select(_e830, _e799, _e832) & 268435455u));
                                                }
                                                let _e845 = phi_3492_;
                                                phi_3493_ = _e845;
                                            }
                                            let _e847 = phi_3493_;
                                            phi_3497_ = type_52(array<vec4<f32>, 3>(vec4<f32>(_e725, (_e549.member.member.x + _e677), _e730, (_e549.member.member_1.x - _e716)), vec4<f32>(_e726, (_e549.member.member.y + _e681), _e731, (_e549.member.member_1.y - _e720)), vec4<f32>(_e727, (_e549.member.member.z + _e685), _e732, (_e549.member.member_1.z - _e724))), type_51(type_28((_e549.member.member + vec4<f32>(_e655, _e664, _e673, 0f)), (_e549.member.member_1 - vec4<f32>(_e694, _e703, _e712, 0f))), _e822), type_51(type_28((_e549.member.member + vec4<f32>(_e677, _e681, _e685, 0f)), (_e549.member.member_1 - vec4<f32>(_e716, _e720, _e724, 0f))), _e847));
                                        }
                                        let _e852 = phi_3497_;
                                        let _e863 = ((_e852.member[0].x - _e340) * _e345);
                                        let _e864 = ((_e852.member[0].y - _e340) * _e345);
                                        let _e865 = ((_e852.member[0].z - _e341) * _e345);
                                        let _e866 = ((_e852.member[0].w - _e341) * _e345);
                                        let _e876 = ((_e852.member[1].x - _e378) * _e383);
                                        let _e877 = ((_e852.member[1].y - _e378) * _e383);
                                        let _e878 = ((_e852.member[1].z - _e379) * _e383);
                                        let _e879 = ((_e852.member[1].w - _e379) * _e383);
                                        let _e889 = ((_e852.member[2].x - _e416) * _e421);
                                        let _e890 = ((_e852.member[2].y - _e416) * _e421);
                                        let _e891 = ((_e852.member[2].z - _e417) * _e421);
                                        let _e892 = ((_e852.member[2].w - _e417) * _e421);
                                        let _e894 = select(_e891, _e889, (_e889 < _e891));
                                        let _e896 = select(_e892, _e890, (_e890 < _e892));
                                        let _e898 = select(_e891, _e889, (_e889 > _e891));
                                        let _e900 = select(_e892, _e890, (_e890 > _e892));
                                        let _e902 = select(_e865, _e863, (_e863 < _e865));
                                        let _e904 = select(_e866, _e864, (_e864 < _e866));
                                        let _e906 = select(_e878, _e876, (_e876 < _e878));
                                        let _e908 = select(_e879, _e877, (_e877 < _e879));
                                        let _e910 = select(_e906, _e902, (_e902 > _e906));
                                        let _e912 = select(_e908, _e904, (_e904 > _e908));
                                        let _e914 = select(_e894, _e910, (_e910 > _e894));
                                        let _e916 = select(_e896, _e912, (_e912 > _e896));
                                        let _e918 = select(_e865, _e863, (_e863 > _e865));
                                        let _e920 = select(_e866, _e864, (_e864 > _e866));
                                        let _e922 = select(_e878, _e876, (_e876 > _e878));
                                        let _e924 = select(_e879, _e877, (_e877 > _e879));
                                        let _e926 = select(_e922, _e918, (_e918 < _e922));
                                        let _e928 = select(_e924, _e920, (_e920 < _e924));
                                        let _e933 = -(_e894);
                                        let _e934 = -(_e896);
                                        let _e941 = (select(_e898, _e926, (_e926 < _e898)) + (select(_e933, _e898, (_e898 > _e933)) * 0.0000019073523f));
                                        let _e942 = (select(_e900, _e928, (_e928 < _e900)) + (select(_e934, _e900, (_e900 > _e934)) * 0.0000019073523f));
                                        let _e944 = select(_e468, _e914, (_e914 > _e468));
                                        let _e946 = select(_e468, _e916, (_e916 > _e468));
                                        let _e951 = (_e944 <= select(_e511, _e941, (_e941 < _e511)));
                                        let _e952 = (_e946 <= select(_e511, _e942, (_e942 < _e511)));
                                        let _e953 = (_e944 <= _e946);
                                        if _e951 {
                                            if _e952 {
                                                if _e953 {
                                                    phi_3842_ = _e852.member_2;
                                                } else {
                                                    phi_3842_ = _e852.member_1;
                                                }
                                                let _e957 = phi_3842_;
                                                let _e979 = (_e553 % 128u);
                                                let _e980 = (_e979 < 128u);
                                                if _e980 {
                                                } else {
                                                    phi_4631_ = true;
                                                    break;
                                                }
                                                local_8[_e979] = _e957.member_1;
                                                if _e980 {
                                                } else {
                                                    phi_4631_ = true;
                                                    break;
                                                }
                                                local_7[_e979] = _e957.member.member.x;
                                                if _e980 {
                                                } else {
                                                    phi_4631_ = true;
                                                    break;
                                                }
                                                local_6[_e979] = _e957.member.member.y;
                                                if _e980 {
                                                } else {
                                                    phi_4631_ = true;
                                                    break;
                                                }
                                                local_5[_e979] = _e957.member.member.z;
                                                if _e980 {
                                                } else {
                                                    phi_4631_ = true;
                                                    break;
                                                }
                                                local_4[_e979] = _e957.member.member_1.x;
                                                if _e980 {
                                                } else {
                                                    phi_4631_ = true;
                                                    break;
                                                }
                                                local_3[_e979] = _e957.member.member_1.y;
                                                if _e980 {
                                                } else {
                                                    phi_4631_ = true;
                                                    break;
                                                }
                                                local_2[_e979] = _e957.member.member_1.z;
                                                if _e980 {
                                                } else {
                                                    phi_4631_ = true;
                                                    break;
                                                }
                                                local_10[_e979] = select(_e946, _e944, (_e944 > _e946));
                                                if _e953 {
                                                    phi_3919_ = _e852.member_1;
                                                } else {
                                                    phi_3919_ = _e852.member_2;
                                                }
                                                let _e993 = phi_3919_;
                                                phi_3920_ = _e993;
                                                phi_3921_ = (_e553 + 1u);
                                            } else {
                                                phi_3920_ = type_51();
                                                phi_3921_ = u32();
                                            }
                                            let _e995 = phi_3920_;
                                            let _e997 = phi_3921_;
                                            phi_3923_ = _e995;
                                            phi_3924_ = _e997;
                                            phi_3925_ = select(true, false, _e952);
                                        } else {
                                            phi_3923_ = type_51();
                                            phi_3924_ = u32();
                                            phi_3925_ = true;
                                        }
                                        let _e1000 = phi_3923_;
                                        let _e1002 = phi_3924_;
                                        let _e1004 = phi_3925_;
                                        if _e1004 {
                                            if _e951 {
                                                phi_3934_ = _e852.member_1;
                                            } else {
                                                phi_3934_ = _e852.member_2;
                                            }
                                            let _e1008 = phi_3934_;
                                            phi_3939_ = _e1008;
                                            phi_3940_ = select(_e952, true, _e951);
                                        } else {
                                            phi_3939_ = _e1000;
                                            phi_3940_ = _e551;
                                        }
                                        let _e1011 = phi_3939_;
                                        let _e1013 = phi_3940_;
                                        phi_4738_ = _e511;
                                        phi_4635_ = _e509;
                                        phi_3942_ = _e1011;
                                        phi_3943_ = _e1013;
                                        phi_3944_ = select(_e1002, _e553, _e1004);
                                    }
                                    let _e1999 = phi_4738_;
                                    let _e2001 = phi_4635_;
                                    let _e2003 = phi_3942_;
                                    let _e2005 = phi_3943_;
                                    let _e2007 = phi_3944_;
                                    phi_4737_ = _e1999;
                                    phi_4634_ = _e2001;
                                    phi_3945_ = _e2003;
                                    phi_3946_ = (_e515 - 1u);
                                    phi_3947_ = _e2005;
                                    phi_3948_ = _e2007;
                                } else {
                                    phi_4737_ = _e511;
                                    phi_4634_ = _e509;
                                    phi_3945_ = _e549;
                                    phi_3946_ = _e515;
                                    phi_3947_ = _e551;
                                    phi_3948_ = _e553;
                                }
                                let _e2009 = phi_4737_;
                                let _e2011 = phi_4634_;
                                let _e2013 = phi_3945_;
                                let _e2015 = phi_3946_;
                                let _e2017 = phi_3947_;
                                let _e2019 = phi_3948_;
                                phi_4736_ = _e2009;
                                phi_4633_ = _e2011;
                                phi_3949_ = _e2013;
                                phi_3950_ = _e2015;
                                phi_3951_ = _e2017;
                                phi_3952_ = _e2019;
                            } else {
                                phi_4736_ = _e511;
                                phi_4633_ = _e509;
                                phi_3949_ = type_51();
                                phi_3950_ = u32();
                                phi_3951_ = bool();
                                phi_3952_ = u32();
                            }
                            let _e2021 = phi_4736_;
                            let _e2023 = phi_4633_;
                            let _e2025 = phi_3949_;
                            let _e2027 = phi_3950_;
                            let _e2029 = phi_3951_;
                            let _e2031 = phi_3952_;
                            phi_4735_ = _e2021;
                            phi_4632_ = _e2023;
                            phi_915_ = _e2025;
                            phi_918_ = _e2027;
                            phi_920_ = _e2029;
                            phi_922_ = _e2031;
                            phi_3953_ = _e523;
                        } else {
                            phi_4735_ = _e511;
                            phi_4632_ = _e509;
                            phi_915_ = type_51();
                            phi_918_ = u32();
                            phi_920_ = bool();
                            phi_922_ = u32();
                            phi_3953_ = false;
                        }
                        let _e2033 = phi_4735_;
                        let _e2035 = phi_4632_;
                        let _e2037 = phi_915_;
                        let _e2039 = phi_918_;
                        let _e2041 = phi_920_;
                        let _e2043 = phi_922_;
                        let _e2045 = phi_3953_;
                        continue;
                        continuing {
                            phi_4469_ = _e2035;
                            phi_4325_ = _e2033;
                            phi_914_ = _e2037;
                            phi_917_ = _e2039;
                            phi_919_ = _e2041;
                            phi_921_ = _e2043;
                            phi_4631_ = _e2035;
                            break if !(_e2045);
                        }
                    }
                    let _e2048 = phi_4631_;
                    if _e2048 {
                        break;
                    }
                    phi_3960_ = type_8(0u, 8u);
                    loop {
                        let _e2050 = phi_3960_;
                        if (_e2050.member < _e2050.member_1) {
                            phi_3961_ = type_8((_e2050.member + 1u), _e2050.member_1);
                            phi_3984_ = type_8(1u, _e2050.member);
                        } else {
                            phi_3961_ = _e2050;
                            phi_3984_ = type_8(0u, type_8().member_1);
                        }
                        let _e2063 = phi_3961_;
                        let _e2065 = phi_3984_;
                        let _e2069 = (bitcast<i32>(_e2065.member) != 0i);
                        if _e2069 {
                            let _e2070 = (_e2065.member_1 < 8u);
                            if _e2070 {
                            } else {
                                phi_4728_ = true;
                                break;
                            }
                            let _e2072 = local_9[_e2065.member_1];
                            if (_e2072.member_3 != 4294967295u) {
                                let _e2078 = -(_e435);
                                let _e2079 = (_e2078 / 3i);
                                let _e2086 = bitcast<f32>((bitcast<u32>((_e2079 + 127i)) << bitcast<u32>(23i)));
                                let _e2094 = (((_e2072.member * _e2086) * _e2086) * bitcast<f32>((bitcast<u32>(((_e2078 - (2i * _e2079)) + 127i)) << bitcast<u32>(23i))));
                                let _e2096 = select(340282350000000000000000000000000000000f, _e2094, (_e2094 < 340282350000000000000000000000000000000f));
                                phi_4050_ = type_24(select(-340282350000000000000000000000000000000f, _e2096, (_e2096 > -340282350000000000000000000000000000000f)), _e2072.member_1, _e2072.member_2, _e2072.member_3);
                            } else {
                                phi_4050_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e2101 = phi_4050_;
                            if _e2070 {
                            } else {
                                phi_4728_ = true;
                                break;
                            }
                            local_9[_e2065.member_1] = type_24(_e2101.member, _e2101.member_1, _e2101.member_2, _e2101.member_3);
                        }
                        continue;
                        continuing {
                            phi_3960_ = _e2063;
                            phi_4728_ = _e2048;
                            break if !(_e2069);
                        }
                    }
                    let _e2109 = phi_4728_;
                    if _e2109 {
                        break;
                    }
                    let _e2110 = local_9;
                    if _e156 {
                    } else {
                        break;
                    }
                    global_6.member[_e154] = array<type_24, 8>(type_24(_e2110[0].member, _e2110[0].member_1, _e2110[0].member_2, _e2110[0].member_3), type_24(_e2110[1].member, _e2110[1].member_1, _e2110[1].member_2, _e2110[1].member_3), type_24(_e2110[2].member, _e2110[2].member_1, _e2110[2].member_2, _e2110[2].member_3), type_24(_e2110[3].member, _e2110[3].member_1, _e2110[3].member_2, _e2110[3].member_3), type_24(_e2110[4].member, _e2110[4].member_1, _e2110[4].member_2, _e2110[4].member_3), type_24(_e2110[5].member, _e2110[5].member_1, _e2110[5].member_2, _e2110[5].member_3), type_24(_e2110[6].member, _e2110[6].member_1, _e2110[6].member_2, _e2110[6].member_3), type_24(_e2110[7].member, _e2110[7].member_1, _e2110[7].member_2, _e2110[7].member_3));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_nearest_q10_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
