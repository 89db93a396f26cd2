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

struct type_36 {
    member: array<array<type_20, 8>>,
}

struct type_42 {
    member: array<vec4<u32>, 2>,
}

struct type_46 {
    member: array<array<u32, 7>>,
}

struct type_51 {
    member: type_24,
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
@group(0) @binding(1) 
var<uniform> global_2: type_42;
@group(0) @binding(4) 
var<storage> global_3: type_32;
@group(0) @binding(2) 
var<storage> global_4: type_46;
@group(0) @binding(3) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_36;

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
    var local_9: array<type_20, 8>;
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
    var phi_2564_: type_20;
    var phi_2566_: type_20;
    var phi_2567_: bool;
    var phi_2571_: type_20;
    var phi_2572_: type_20;
    var phi_2573_: type_20;
    var phi_2574_: bool;
    var phi_2578_: type_20;
    var phi_2579_: bool;
    var phi_2580_: type_20;
    var phi_2581_: bool;
    var phi_2582_: bool;
    var phi_2583_: type_20;
    var phi_2584_: bool;
    var phi_2585_: bool;
    var phi_2593_: type_20;
    var phi_2594_: bool;
    var phi_2598_: type_20;
    var phi_2610_: type_8;
    var phi_2613_: type_20;
    var phi_2611_: type_8;
    var phi_2636_: type_8;
    var phi_2668_: bool;
    var phi_2669_: bool;
    var phi_2690_: type_20;
    var phi_2614_: type_20;
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
    var phi_4050_: type_20;
    var phi_4728_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e92 = global;
            let _e94 = arrayLength((&global_4.member));
            let _e97 = arrayLength((&global_5.member));
            let _e105 = global_2.member[0u][0u];
            let _e109 = global_2.member[0u][1u];
            let _e113 = global_2.member[0u][2u];
            let _e117 = global_2.member[0u][3u];
            let _e121 = global_2.member[1u][0u];
            let _e125 = global_2.member[1u][1u];
            let _e129 = global_2.member[1u][2u];
            let _e132 = global_1.member[0u];
            let _e133 = bitcast<i32>(_e132);
            let _e145 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e117) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e105), bitcast<i32>(_e109), bitcast<i32>(_e113));
            local = array<i32, 3>(bitcast<i32>(_e121), bitcast<i32>(_e125), bitcast<i32>(_e129));
            let _e151 = (_e92.x + (_e92.y * 2097152u));
            let _e152 = (_e151 < arrayLength((&global_3.member)));
            if _e152 {
                let _e153 = (_e151 < arrayLength((&global_6.member)));
                if _e153 {
                    if _e152 {
                    } else {
                        break;
                    }
                    let _e161 = global_3.member[_e151].member_2[0u];
                    let _e163 = (bitcast<u32>(_e161) & 2147483647u);
                    let _e168 = global_3.member[_e151].member_2[1u];
                    let _e170 = (bitcast<u32>(_e168) & 2147483647u);
                    let _e175 = global_3.member[_e151].member_2[2u];
                    let _e177 = (bitcast<u32>(_e175) & 2147483647u);
                    let _e182 = global_3.member[_e151].member[0u];
                    let _e184 = (bitcast<u32>(_e182) & 2147483647u);
                    let _e189 = global_3.member[_e151].member[1u];
                    let _e191 = (bitcast<u32>(_e189) & 2147483647u);
                    let _e196 = global_3.member[_e151].member[2u];
                    let _e198 = (bitcast<u32>(_e196) & 2147483647u);
                    let _e200 = select(_e170, _e163, (_e170 < _e163));
                    let _e202 = select(_e177, _e200, (_e177 < _e200));
                    let _e204 = select(_e184, _e202, (_e184 < _e202));
                    let _e206 = select(_e191, _e204, (_e191 < _e204));
                    let _e208 = select(_e198, _e206, (_e198 < _e206));
                    let _e212 = global_3.member[_e151].member_1;
                    let _e214 = (bitcast<u32>(_e212) & 2147483647u);
                    let _e221 = global_3.member[_e151].member_3;
                    let _e227 = (((select(_e214, _e208, (_e214 < _e208)) < 2139095040u) && ((bitcast<u32>(_e221) & 2147483647u) <= 2139095040u)) && (_e202 > 0u));
                    if _e227 {
                        let _e230 = (bitcast<u32>(bitcast<f32>(_e202)) & 2147483647u);
                        if (_e230 >= 8388608u) {
                            phi_403_ = (bitcast<i32>((_e230 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_403_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e230)), 32u, (_e230 == 0u))));
                        }
                        let _e244 = phi_403_;
                        phi_404_ = _e244;
                    } else {
                        phi_404_ = 0i;
                    }
                    let _e246 = phi_404_;
                    let _e247 = (_e163 == _e202);
                    if _e247 {
                        phi_414_ = true;
                    } else {
                        phi_414_ = (_e170 == _e202);
                    }
                    let _e250 = phi_414_;
                    let _e251 = select(1u, 0u, _e247);
                    if _e250 {
                        let _e252 = (_e251 + 1u);
                        phi_424_ = _e252;
                        phi_425_ = _e252;
                        phi_427_ = select(true, false, (_e252 == 2u));
                    } else {
                        phi_424_ = u32();
                        phi_425_ = 0u;
                        phi_427_ = true;
                    }
                    let _e256 = phi_424_;
                    let _e258 = phi_425_;
                    let _e260 = phi_427_;
                    if _e260 {
                        phi_432_ = (_e258 + 1u);
                    } else {
                        phi_432_ = 0u;
                    }
                    let _e264 = phi_432_;
                    let _e265 = select(_e256, _e258, _e260);
                    let _e266 = select(_e251, select(2u, _e251, _e250), _e260);
                    if (_e133 < -126i) {
                        phi_444_ = -126i;
                    } else {
                        phi_444_ = select(_e133, 127i, (_e133 > 127i));
                    }
                    let _e271 = phi_444_;
                    let _e276 = bitcast<f32>((bitcast<u32>((_e271 + 127i)) << bitcast<u32>(23i)));
                    let _e282 = bitcast<f32>((bitcast<u32>(((_e133 - _e271) + 127i)) << bitcast<u32>(23i)));
                    let _e283 = -(_e246);
                    if (_e283 < -126i) {
                        phi_464_ = -126i;
                    } else {
                        phi_464_ = select(_e283, 127i, (_e283 > 127i));
                    }
                    let _e288 = phi_464_;
                    let _e293 = bitcast<f32>((bitcast<u32>((_e288 + 127i)) << bitcast<u32>(23i)));
                    let _e299 = bitcast<f32>((bitcast<u32>(((_e283 - _e288) + 127i)) << bitcast<u32>(23i)));
                    let _e303 = global_3.member[_e151].member;
                    let _e304 = (_e265 == 0u);
                    if _e304 {
                        phi_482_ = _e303[0];
                    } else {
                        phi_482_ = _e303[1];
                    }
                    let _e308 = phi_482_;
                    let _e309 = (_e265 == 2u);
                    if _e309 {
                        phi_488_ = _e303[2];
                    } else {
                        phi_488_ = _e308;
                    }
                    let _e312 = phi_488_;
                    let _e314 = ((_e312 * _e276) * _e282);
                    let _e315 = global_3.member[_e151].member_2;
                    if _e304 {
                        phi_499_ = _e315[0];
                    } else {
                        phi_499_ = _e315[1];
                    }
                    let _e319 = phi_499_;
                    if _e309 {
                        phi_505_ = _e315[2];
                    } else {
                        phi_505_ = _e319;
                    }
                    let _e322 = phi_505_;
                    let _e324 = ((_e322 * _e293) * _e299);
                    let _e328 = (bitcast<f32>((bitcast<u32>(_e324) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e328 {
                        let _e332 = (bitcast<f32>((bitcast<u32>(_e314) & 2147483647u)) * 0.00000011920929f);
                        phi_528_ = select(0.00000000000011368684f, _e332, (_e332 > 0.00000000000011368684f));
                    } else {
                        phi_528_ = 0f;
                    }
                    let _e336 = phi_528_;
                    let _e337 = (_e314 + _e336);
                    let _e338 = (_e314 - _e336);
                    let _e339 = select(_e324, 0f, _e328);
                    if _e328 {
                        phi_539_ = 38685626000000000000000000f;
                    } else {
                        phi_539_ = (1f / _e324);
                    }
                    let _e342 = phi_539_;
                    let _e343 = (_e264 == 0u);
                    if _e343 {
                        phi_548_ = _e303[0];
                    } else {
                        phi_548_ = _e303[1];
                    }
                    let _e347 = phi_548_;
                    let _e348 = (_e264 == 2u);
                    if _e348 {
                        phi_554_ = _e303[2];
                    } else {
                        phi_554_ = _e347;
                    }
                    let _e351 = phi_554_;
                    let _e353 = ((_e351 * _e276) * _e282);
                    if _e343 {
                        phi_565_ = _e315[0];
                    } else {
                        phi_565_ = _e315[1];
                    }
                    let _e357 = phi_565_;
                    if _e348 {
                        phi_571_ = _e315[2];
                    } else {
                        phi_571_ = _e357;
                    }
                    let _e360 = phi_571_;
                    let _e362 = ((_e360 * _e293) * _e299);
                    let _e366 = (bitcast<f32>((bitcast<u32>(_e362) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e366 {
                        let _e370 = (bitcast<f32>((bitcast<u32>(_e353) & 2147483647u)) * 0.00000011920929f);
                        phi_594_ = select(0.00000000000011368684f, _e370, (_e370 > 0.00000000000011368684f));
                    } else {
                        phi_594_ = 0f;
                    }
                    let _e374 = phi_594_;
                    let _e375 = (_e353 + _e374);
                    let _e376 = (_e353 - _e374);
                    let _e377 = select(_e362, 0f, _e366);
                    if _e366 {
                        phi_605_ = 38685626000000000000000000f;
                    } else {
                        phi_605_ = (1f / _e362);
                    }
                    let _e380 = phi_605_;
                    let _e381 = (_e266 == 0u);
                    if _e381 {
                        phi_614_ = _e303[0];
                    } else {
                        phi_614_ = _e303[1];
                    }
                    let _e385 = phi_614_;
                    let _e386 = (_e266 == 2u);
                    if _e386 {
                        phi_620_ = _e303[2];
                    } else {
                        phi_620_ = _e385;
                    }
                    let _e389 = phi_620_;
                    let _e391 = ((_e389 * _e276) * _e282);
                    if _e381 {
                        phi_631_ = _e315[0];
                    } else {
                        phi_631_ = _e315[1];
                    }
                    let _e395 = phi_631_;
                    if _e386 {
                        phi_637_ = _e315[2];
                    } else {
                        phi_637_ = _e395;
                    }
                    let _e398 = phi_637_;
                    let _e400 = ((_e398 * _e293) * _e299);
                    let _e404 = (bitcast<f32>((bitcast<u32>(_e400) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e404 {
                        let _e408 = (bitcast<f32>((bitcast<u32>(_e391) & 2147483647u)) * 0.00000011920929f);
                        phi_660_ = select(0.00000000000011368684f, _e408, (_e408 > 0.00000000000011368684f));
                    } else {
                        phi_660_ = 0f;
                    }
                    let _e412 = phi_660_;
                    let _e413 = (_e391 + _e412);
                    let _e414 = (_e391 - _e412);
                    let _e415 = select(_e400, 0f, _e404);
                    if _e404 {
                        phi_671_ = 38685626000000000000000000f;
                    } else {
                        phi_671_ = (1f / _e400);
                    }
                    let _e418 = phi_671_;
                    let _e421 = bitcast<f32>((bitcast<u32>(_e314) & 2147483647u));
                    let _e424 = bitcast<f32>((bitcast<u32>(_e353) & 2147483647u));
                    let _e426 = select(_e424, _e421, (_e421 > _e424));
                    let _e429 = bitcast<f32>((bitcast<u32>(_e391) & 2147483647u));
                    let _e432 = (_e133 + _e246);
                    if (_e227 && (select(_e429, _e426, (_e426 > _e429)) <= 1099511600000f)) {
                        let _e435 = (_e432 / 3i);
                        let _e442 = bitcast<f32>((bitcast<u32>((_e435 + 127i)) << bitcast<u32>(23i)));
                        let _e449 = bitcast<f32>((bitcast<u32>(((_e432 - (2i * _e435)) + 127i)) << bitcast<u32>(23i)));
                        let _e450 = (((_e212 * _e442) * _e442) * _e449);
                        let _e452 = select(340282350000000000000000000000000000000f, _e450, (_e450 < 340282350000000000000000000000000000000f));
                        let _e457 = (((_e221 * _e442) * _e442) * _e449);
                        let _e459 = select(340282350000000000000000000000000000000f, _e457, (_e457 < 340282350000000000000000000000000000000f));
                        phi_771_ = select(-340282350000000000000000000000000000000f, _e459, (_e459 > -340282350000000000000000000000000000000f));
                        phi_772_ = select(-340282350000000000000000000000000000000f, _e452, (_e452 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_771_ = 0f;
                        phi_772_ = 1f;
                    }
                    let _e463 = phi_771_;
                    let _e465 = phi_772_;
                    local_9 = array<type_20, 8>(type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_10 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e468 = (_e265 % 3u);
                    let _e469 = (_e468 < 3u);
                    if _e469 {
                    } else {
                        break;
                    }
                    let _e471 = local_1[_e468];
                    let _e474 = (_e264 % 3u);
                    let _e475 = (_e474 < 3u);
                    if _e475 {
                    } else {
                        break;
                    }
                    let _e477 = local_1[_e474];
                    let _e480 = (_e266 % 3u);
                    let _e481 = (_e480 < 3u);
                    if _e481 {
                    } else {
                        break;
                    }
                    let _e483 = local_1[_e480];
                    if _e469 {
                    } else {
                        break;
                    }
                    let _e488 = local[_e468];
                    if _e475 {
                    } else {
                        break;
                    }
                    let _e492 = local[_e474];
                    if _e481 {
                    } else {
                        break;
                    }
                    let _e496 = local[_e480];
                    phi_4469_ = false;
                    phi_4325_ = _e463;
                    phi_914_ = type_51(type_24(vec4<f32>((f32(_e471) * _e145), (f32(_e477) * _e145), (f32(_e483) * _e145), 0f), vec4<f32>((f32(_e488) * _e145), (f32(_e492) * _e145), (f32(_e496) * _e145), 0f)), select(0u, 2147483648u, (_e94 == 0u)));
                    phi_917_ = ((3u * _e94) + 1u);
                    phi_919_ = (_e465 <= _e463);
                    phi_921_ = 0u;
                    loop {
                        let _e506 = phi_4469_;
                        let _e508 = phi_4325_;
                        let _e510 = phi_914_;
                        let _e512 = phi_917_;
                        let _e514 = phi_919_;
                        let _e516 = phi_921_;
                        if _e514 {
                            phi_932_ = true;
                        } else {
                            phi_932_ = (_e516 > 0u);
                        }
                        let _e519 = phi_932_;
                        if _e519 {
                            let _e520 = (_e512 > 0u);
                            if _e520 {
                                if _e514 {
                                    phi_1019_ = _e510;
                                    phi_1020_ = _e514;
                                    phi_1021_ = _e516;
                                } else {
                                    let _e521 = (_e516 - 1u);
                                    let _e522 = (_e521 % 128u);
                                    let _e523 = (_e522 < 128u);
                                    if _e523 {
                                    } else {
                                        phi_4631_ = true;
                                        break;
                                    }
                                    let _e525 = local_7[_e522];
                                    if _e523 {
                                    } else {
                                        phi_4631_ = true;
                                        break;
                                    }
                                    let _e527 = local_6[_e522];
                                    if _e523 {
                                    } else {
                                        phi_4631_ = true;
                                        break;
                                    }
                                    let _e529 = local_5[_e522];
                                    if _e523 {
                                    } else {
                                        phi_4631_ = true;
                                        break;
                                    }
                                    let _e531 = local_4[_e522];
                                    if _e523 {
                                    } else {
                                        phi_4631_ = true;
                                        break;
                                    }
                                    let _e533 = local_3[_e522];
                                    if _e523 {
                                    } else {
                                        phi_4631_ = true;
                                        break;
                                    }
                                    let _e535 = local_2[_e522];
                                    if _e523 {
                                    } else {
                                        phi_4631_ = true;
                                        break;
                                    }
                                    let _e540 = local_8[_e522];
                                    if _e523 {
                                    } else {
                                        phi_4631_ = true;
                                        break;
                                    }
                                    let _e543 = local_10[_e522];
                                    phi_1019_ = type_51(type_24(vec4<f32>(_e525, _e527, _e529, 0f), vec4<f32>(_e531, _e533, _e535, 0f)), _e540);
                                    phi_1020_ = (_e543 <= _e508);
                                    phi_1021_ = _e521;
                                }
                                let _e546 = phi_1019_;
                                let _e548 = phi_1020_;
                                let _e550 = phi_1021_;
                                if _e548 {
                                    let _e555 = (_e546.member_1 & 268435455u);
                                    if ((_e546.member_1 & 2147483648u) != 0u) {
                                        phi_4466_ = _e506;
                                        phi_4409_ = _e508;
                                        phi_1040_ = type_8(0u, ((_e546.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1032 = phi_4466_;
                                            let _e1034 = phi_4409_;
                                            let _e1036 = phi_1040_;
                                            if (_e1036.member < _e1036.member_1) {
                                                phi_1041_ = type_8((_e1036.member + 1u), _e1036.member_1);
                                                phi_1064_ = type_8(1u, _e1036.member);
                                            } else {
                                                phi_1041_ = _e1036;
                                                phi_1064_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1049 = phi_1041_;
                                            let _e1051 = phi_1064_;
                                            let _e1055 = (bitcast<i32>(_e1051.member) != 0i);
                                            if _e1055 {
                                                let _e1060 = (_e546.member.member_1.x - _e546.member.member.x);
                                                let _e1063 = (_e546.member.member_1.y - _e546.member.member.y);
                                                let _e1066 = (_e546.member.member_1.z - _e546.member.member.z);
                                                let _e1068 = select(_e1063, _e1060, (_e1060 > _e1063));
                                                let _e1070 = select(_e1066, _e1068, (_e1068 > _e1066));
                                                let _e1072 = (_e1070 < (1024f * _e145));
                                                if _e1072 {
                                                    phi_1105_ = 0u;
                                                } else {
                                                    phi_1105_ = select(2u, 1u, (_e1070 < (2097152f * _e145)));
                                                }
                                                let _e1077 = phi_1105_;
                                                switch bitcast<i32>(_e1077) {
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
                                                let _e1080 = phi_1111_;
                                                switch bitcast<i32>(_e1077) {
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
                                                let _e1087 = phi_1121_;
                                                let _e1089 = ((_e555 + (_e1051.member_1 * ((3u * _e1080) + 1u))) + (3u * _e1087));
                                                let _e1090 = (_e1089 < _e97);
                                                if _e1090 {
                                                    if _e1090 {
                                                    } else {
                                                        phi_4773_ = _e1034;
                                                        phi_4626_ = true;
                                                        break;
                                                    }
                                                    let _e1092 = global_5.member[_e1089];
                                                    phi_1137_ = _e1092;
                                                } else {
                                                    phi_1137_ = 4294967295u;
                                                }
                                                let _e1094 = phi_1137_;
                                                if _e1072 {
                                                    phi_1170_ = 0u;
                                                } else {
                                                    phi_1170_ = select(2u, 1u, (_e1070 < (2097152f * _e145)));
                                                }
                                                let _e1099 = phi_1170_;
                                                switch bitcast<i32>(_e1099) {
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
                                                let _e1102 = phi_1176_;
                                                let _e1106 = (_e555 + (_e1051.member_1 * ((3u * _e1102) + 1u)));
                                                switch bitcast<i32>(_e1099) {
                                                    case 0: {
                                                        let _e1372 = (_e1106 < _e97);
                                                        if _e1372 {
                                                            if _e1372 {
                                                            } else {
                                                                phi_4773_ = _e1034;
                                                                phi_4626_ = true;
                                                                break;
                                                            }
                                                            let _e1374 = global_5.member[_e1106];
                                                            phi_1200_ = _e1374;
                                                        } else {
                                                            phi_1200_ = 0u;
                                                        }
                                                        let _e1376 = phi_1200_;
                                                        let _e1378 = ((10u * _e265) & 31u);
                                                        let _e1387 = ((10u * _e264) & 31u);
                                                        let _e1396 = ((10u * _e266) & 31u);
                                                        let _e1405 = (_e1106 + 1u);
                                                        let _e1406 = (_e1405 < _e97);
                                                        if _e1406 {
                                                            if _e1406 {
                                                            } else {
                                                                phi_4773_ = _e1034;
                                                                phi_4626_ = true;
                                                                break;
                                                            }
                                                            let _e1408 = global_5.member[_e1405];
                                                            phi_1243_ = _e1408;
                                                        } else {
                                                            phi_1243_ = 0u;
                                                        }
                                                        let _e1410 = phi_1243_;
                                                        let _e1433 = (_e1106 + 2u);
                                                        let _e1434 = (_e1433 < _e97);
                                                        if _e1434 {
                                                            if _e1434 {
                                                            } else {
                                                                phi_4773_ = _e1034;
                                                                phi_4626_ = true;
                                                                break;
                                                            }
                                                            let _e1436 = global_5.member[_e1433];
                                                            phi_1286_ = _e1436;
                                                        } else {
                                                            phi_1286_ = 0u;
                                                        }
                                                        let _e1438 = phi_1286_;
                                                        phi_1757_ = array<array<f32, 3>, 3>(array<f32, 3>((_e546.member.member.x + (f32(bitcast<i32>(((_e1376 >> bitcast<u32>(_e1378)) & 1023u))) * _e145)), (_e546.member.member.y + (f32(bitcast<i32>(((_e1376 >> bitcast<u32>(_e1387)) & 1023u))) * _e145)), (_e546.member.member.z + (f32(bitcast<i32>(((_e1376 >> bitcast<u32>(_e1396)) & 1023u))) * _e145))), array<f32, 3>((_e546.member.member.x + (f32(bitcast<i32>(((_e1410 >> bitcast<u32>(_e1378)) & 1023u))) * _e145)), (_e546.member.member.y + (f32(bitcast<i32>(((_e1410 >> bitcast<u32>(_e1387)) & 1023u))) * _e145)), (_e546.member.member.z + (f32(bitcast<i32>(((_e1410 >> bitcast<u32>(_e1396)) & 1023u))) * _e145))), array<f32, 3>((_e546.member.member.x + (f32(bitcast<i32>(((_e1438 >> bitcast<u32>(_e1378)) & 1023u))) * _e145)), (_e546.member.member.y + (f32(bitcast<i32>(((_e1438 >> bitcast<u32>(_e1387)) & 1023u))) * _e145)), (_e546.member.member.z + (f32(bitcast<i32>(((_e1438 >> bitcast<u32>(_e1396)) & 1023u))) * _e145))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1195 = (_e1106 < _e97);
                                                        if _e1195 {
                                                            if _e1195 {
                                                            } else {
                                                                phi_4773_ = _e1034;
                                                                phi_4626_ = true;
                                                                break;
                                                            }
                                                            let _e1197 = global_5.member[_e1106];
                                                            phi_1329_ = _e1197;
                                                        } else {
                                                            phi_1329_ = 0u;
                                                        }
                                                        let _e1199 = phi_1329_;
                                                        let _e1200 = (_e1106 + 1u);
                                                        let _e1201 = (_e1200 < _e97);
                                                        if _e1201 {
                                                            if _e1201 {
                                                            } else {
                                                                phi_4773_ = _e1034;
                                                                phi_4626_ = true;
                                                                break;
                                                            }
                                                            let _e1203 = global_5.member[_e1200];
                                                            phi_1344_ = _e1203;
                                                        } else {
                                                            phi_1344_ = 0u;
                                                        }
                                                        let _e1205 = phi_1344_;
                                                        let _e1206 = (_e265 == 1u);
                                                        if _e1206 {
                                                            phi_1354_ = ((_e1199 >> bitcast<u32>(21i)) | (_e1205 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1354_ = (_e1205 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1215 = phi_1354_;
                                                        let _e1222 = (_e264 == 1u);
                                                        if _e1222 {
                                                            phi_1374_ = ((_e1199 >> bitcast<u32>(21i)) | (_e1205 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1374_ = (_e1205 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1231 = phi_1374_;
                                                        let _e1238 = (_e266 == 1u);
                                                        if _e1238 {
                                                            phi_1394_ = ((_e1199 >> bitcast<u32>(21i)) | (_e1205 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1394_ = (_e1205 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1247 = phi_1394_;
                                                        let _e1255 = (_e1106 + 2u);
                                                        let _e1256 = (_e1255 < _e97);
                                                        if _e1256 {
                                                            if _e1256 {
                                                            } else {
                                                                phi_4773_ = _e1034;
                                                                phi_4626_ = true;
                                                                break;
                                                            }
                                                            let _e1258 = global_5.member[_e1255];
                                                            phi_1420_ = _e1258;
                                                        } else {
                                                            phi_1420_ = 0u;
                                                        }
                                                        let _e1260 = phi_1420_;
                                                        let _e1261 = (_e1106 + 3u);
                                                        let _e1262 = (_e1261 < _e97);
                                                        if _e1262 {
                                                            if _e1262 {
                                                            } else {
                                                                phi_4773_ = _e1034;
                                                                phi_4626_ = true;
                                                                break;
                                                            }
                                                            let _e1264 = global_5.member[_e1261];
                                                            phi_1435_ = _e1264;
                                                        } else {
                                                            phi_1435_ = 0u;
                                                        }
                                                        let _e1266 = phi_1435_;
                                                        if _e1206 {
                                                            phi_1445_ = ((_e1260 >> bitcast<u32>(21i)) | (_e1266 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1445_ = (_e1266 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1275 = phi_1445_;
                                                        if _e1222 {
                                                            phi_1465_ = ((_e1260 >> bitcast<u32>(21i)) | (_e1266 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1465_ = (_e1266 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1290 = phi_1465_;
                                                        if _e1238 {
                                                            phi_1485_ = ((_e1260 >> bitcast<u32>(21i)) | (_e1266 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1485_ = (_e1266 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1305 = phi_1485_;
                                                        let _e1313 = (_e1106 + 4u);
                                                        let _e1314 = (_e1313 < _e97);
                                                        if _e1314 {
                                                            if _e1314 {
                                                            } else {
                                                                phi_4773_ = _e1034;
                                                                phi_4626_ = true;
                                                                break;
                                                            }
                                                            let _e1316 = global_5.member[_e1313];
                                                            phi_1511_ = _e1316;
                                                        } else {
                                                            phi_1511_ = 0u;
                                                        }
                                                        let _e1318 = phi_1511_;
                                                        let _e1319 = (_e1106 + 5u);
                                                        let _e1320 = (_e1319 < _e97);
                                                        if _e1320 {
                                                            if _e1320 {
                                                            } else {
                                                                phi_4773_ = _e1034;
                                                                phi_4626_ = true;
                                                                break;
                                                            }
                                                            let _e1322 = global_5.member[_e1319];
                                                            phi_1526_ = _e1322;
                                                        } else {
                                                            phi_1526_ = 0u;
                                                        }
                                                        let _e1324 = phi_1526_;
                                                        if _e1206 {
                                                            phi_1536_ = ((_e1318 >> bitcast<u32>(21i)) | (_e1324 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1536_ = (_e1324 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1333 = phi_1536_;
                                                        if _e1222 {
                                                            phi_1556_ = ((_e1318 >> bitcast<u32>(21i)) | (_e1324 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1556_ = (_e1324 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1348 = phi_1556_;
                                                        if _e1238 {
                                                            phi_1576_ = ((_e1318 >> bitcast<u32>(21i)) | (_e1324 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1576_ = (_e1324 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1363 = phi_1576_;
                                                        phi_1757_ = array<array<f32, 3>, 3>(array<f32, 3>((_e546.member.member.x + (f32(bitcast<i32>((select(_e1215, _e1199, _e304) & 2097151u))) * _e145)), (_e546.member.member.y + (f32(bitcast<i32>((select(_e1231, _e1199, _e343) & 2097151u))) * _e145)), (_e546.member.member.z + (f32(bitcast<i32>((select(_e1247, _e1199, _e381) & 2097151u))) * _e145))), array<f32, 3>((_e546.member.member.x + (f32(bitcast<i32>((select(_e1275, _e1260, _e304) & 2097151u))) * _e145)), (_e546.member.member.y + (f32(bitcast<i32>((select(_e1290, _e1260, _e343) & 2097151u))) * _e145)), (_e546.member.member.z + (f32(bitcast<i32>((select(_e1305, _e1260, _e381) & 2097151u))) * _e145))), array<f32, 3>((_e546.member.member.x + (f32(bitcast<i32>((select(_e1333, _e1318, _e304) & 2097151u))) * _e145)), (_e546.member.member.y + (f32(bitcast<i32>((select(_e1348, _e1318, _e343) & 2097151u))) * _e145)), (_e546.member.member.z + (f32(bitcast<i32>((select(_e1363, _e1318, _e381) & 2097151u))) * _e145))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1108 = (_e1106 + _e265);
                                                        let _e1109 = (_e1108 < _e97);
                                                        if _e1109 {
                                                            if _e1109 {
                                                            } else {
                                                                phi_4773_ = _e1034;
                                                                phi_4626_ = true;
                                                                break;
                                                            }
                                                            let _e1111 = global_5.member[_e1108];
                                                            phi_1603_ = _e1111;
                                                        } else {
                                                            phi_1603_ = 0u;
                                                        }
                                                        let _e1113 = phi_1603_;
                                                        let _e1117 = (_e1106 + _e264);
                                                        let _e1118 = (_e1117 < _e97);
                                                        if _e1118 {
                                                            if _e1118 {
                                                            } else {
                                                                phi_4773_ = _e1034;
                                                                phi_4626_ = true;
                                                                break;
                                                            }
                                                            let _e1120 = global_5.member[_e1117];
                                                            phi_1621_ = _e1120;
                                                        } else {
                                                            phi_1621_ = 0u;
                                                        }
                                                        let _e1122 = phi_1621_;
                                                        let _e1126 = (_e1106 + _e266);
                                                        let _e1127 = (_e1126 < _e97);
                                                        if _e1127 {
                                                            if _e1127 {
                                                            } else {
                                                                phi_4773_ = _e1034;
                                                                phi_4626_ = true;
                                                                break;
                                                            }
                                                            let _e1129 = global_5.member[_e1126];
                                                            phi_1639_ = _e1129;
                                                        } else {
                                                            phi_1639_ = 0u;
                                                        }
                                                        let _e1131 = phi_1639_;
                                                        let _e1136 = (_e1106 + 3u);
                                                        let _e1137 = (_e1136 + _e265);
                                                        let _e1138 = (_e1137 < _e97);
                                                        if _e1138 {
                                                            if _e1138 {
                                                            } else {
                                                                phi_4773_ = _e1034;
                                                                phi_4626_ = true;
                                                                break;
                                                            }
                                                            let _e1140 = global_5.member[_e1137];
                                                            phi_1659_ = _e1140;
                                                        } else {
                                                            phi_1659_ = 0u;
                                                        }
                                                        let _e1142 = phi_1659_;
                                                        let _e1146 = (_e1136 + _e264);
                                                        let _e1147 = (_e1146 < _e97);
                                                        if _e1147 {
                                                            if _e1147 {
                                                            } else {
                                                                phi_4773_ = _e1034;
                                                                phi_4626_ = true;
                                                                break;
                                                            }
                                                            let _e1149 = global_5.member[_e1146];
                                                            phi_1677_ = _e1149;
                                                        } else {
                                                            phi_1677_ = 0u;
                                                        }
                                                        let _e1151 = phi_1677_;
                                                        let _e1155 = (_e1136 + _e266);
                                                        let _e1156 = (_e1155 < _e97);
                                                        if _e1156 {
                                                            if _e1156 {
                                                            } else {
                                                                phi_4773_ = _e1034;
                                                                phi_4626_ = true;
                                                                break;
                                                            }
                                                            let _e1158 = global_5.member[_e1155];
                                                            phi_1695_ = _e1158;
                                                        } else {
                                                            phi_1695_ = 0u;
                                                        }
                                                        let _e1160 = phi_1695_;
                                                        let _e1165 = (_e1106 + 6u);
                                                        let _e1166 = (_e1165 + _e265);
                                                        let _e1167 = (_e1166 < _e97);
                                                        if _e1167 {
                                                            if _e1167 {
                                                            } else {
                                                                phi_4773_ = _e1034;
                                                                phi_4626_ = true;
                                                                break;
                                                            }
                                                            let _e1169 = global_5.member[_e1166];
                                                            phi_1715_ = _e1169;
                                                        } else {
                                                            phi_1715_ = 0u;
                                                        }
                                                        let _e1171 = phi_1715_;
                                                        let _e1175 = (_e1165 + _e264);
                                                        let _e1176 = (_e1175 < _e97);
                                                        if _e1176 {
                                                            if _e1176 {
                                                            } else {
                                                                phi_4773_ = _e1034;
                                                                phi_4626_ = true;
                                                                break;
                                                            }
                                                            let _e1178 = global_5.member[_e1175];
                                                            phi_1733_ = _e1178;
                                                        } else {
                                                            phi_1733_ = 0u;
                                                        }
                                                        let _e1180 = phi_1733_;
                                                        let _e1184 = (_e1165 + _e266);
                                                        let _e1185 = (_e1184 < _e97);
                                                        if _e1185 {
                                                            if _e1185 {
                                                            } else {
                                                                phi_4773_ = _e1034;
                                                                phi_4626_ = true;
                                                                break;
                                                            }
                                                            let _e1187 = global_5.member[_e1184];
                                                            phi_1751_ = _e1187;
                                                        } else {
                                                            phi_1751_ = 0u;
                                                        }
                                                        let _e1189 = phi_1751_;
                                                        phi_1757_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1113)) * _e145), (f32(bitcast<i32>(_e1122)) * _e145), (f32(bitcast<i32>(_e1131)) * _e145)), array<f32, 3>((f32(bitcast<i32>(_e1142)) * _e145), (f32(bitcast<i32>(_e1151)) * _e145), (f32(bitcast<i32>(_e1160)) * _e145)), array<f32, 3>((f32(bitcast<i32>(_e1171)) * _e145), (f32(bitcast<i32>(_e1180)) * _e145), (f32(bitcast<i32>(_e1189)) * _e145)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1757_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1463 = phi_1757_;
                                                let _e1470 = (_e1463[0][2] - _e391);
                                                let _e1473 = (((_e1463[0][0] - _e314) * _e415) - (_e1470 * _e339));
                                                let _e1476 = (((_e1463[0][1] - _e353) * _e415) - (_e1470 * _e377));
                                                let _e1483 = (_e1463[1][2] - _e391);
                                                let _e1486 = (((_e1463[1][0] - _e314) * _e415) - (_e1483 * _e339));
                                                let _e1489 = (((_e1463[1][1] - _e353) * _e415) - (_e1483 * _e377));
                                                let _e1496 = (_e1463[2][2] - _e391);
                                                let _e1499 = (((_e1463[2][0] - _e314) * _e415) - (_e1496 * _e339));
                                                let _e1502 = (((_e1463[2][1] - _e353) * _e415) - (_e1496 * _e377));
                                                let _e1503 = (_e1499 * _e1489);
                                                let _e1504 = (_e1502 * _e1486);
                                                let _e1505 = (_e1473 * _e1502);
                                                let _e1506 = (_e1476 * _e1499);
                                                let _e1507 = (_e1486 * _e1476);
                                                let _e1508 = (_e1489 * _e1473);
                                                let _e1513 = (((_e1503 >= _e1504) && (_e1505 >= _e1506)) && (_e1507 >= _e1508));
                                                if (_e1513 || (((_e1503 <= _e1504) && (_e1505 <= _e1506)) && (_e1507 <= _e1508))) {
                                                    let _e1520 = select(-1f, 1f, _e1513);
                                                    let _e1522 = ((_e1503 - _e1504) * _e1520);
                                                    let _e1524 = select(0f, _e1522, (_e1522 > 0f));
                                                    let _e1526 = ((_e1505 - _e1506) * _e1520);
                                                    let _e1528 = select(0f, _e1526, (_e1526 > 0f));
                                                    let _e1530 = ((_e1507 - _e1508) * _e1520);
                                                    let _e1532 = select(0f, _e1530, (_e1530 > 0f));
                                                    let _e1534 = ((_e1524 + _e1528) + _e1532);
                                                    if (_e1534 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2583_ = type_20();
                                                        phi_2584_ = true;
                                                        phi_2585_ = false;
                                                    } else {
                                                        let _e1537 = select(_e1486, _e1473, (_e1473 < _e1486));
                                                        if (select(_e1499, _e1537, (_e1537 < _e1499)) > 0f) {
                                                            phi_1875_ = true;
                                                        } else {
                                                            let _e1542 = select(_e1486, _e1473, (_e1473 > _e1486));
                                                            phi_1875_ = (select(_e1499, _e1542, (_e1542 > _e1499)) < 0f);
                                                        }
                                                        let _e1547 = phi_1875_;
                                                        if _e1547 {
                                                            phi_2580_ = type_20();
                                                            phi_2581_ = true;
                                                            phi_2582_ = false;
                                                        } else {
                                                            let _e1549 = select(_e1489, _e1476, (_e1476 < _e1489));
                                                            if (select(_e1502, _e1549, (_e1549 < _e1502)) > 0f) {
                                                                phi_1904_ = true;
                                                            } else {
                                                                let _e1554 = select(_e1489, _e1476, (_e1476 > _e1489));
                                                                phi_1904_ = (select(_e1502, _e1554, (_e1554 > _e1502)) < 0f);
                                                            }
                                                            let _e1559 = phi_1904_;
                                                            if _e1559 {
                                                                phi_2578_ = type_20();
                                                                phi_2579_ = false;
                                                            } else {
                                                                let _e1561 = select(_e1463[1][0], _e1463[0][0], (_e1463[0][0] < _e1463[1][0]));
                                                                let _e1565 = select(_e1463[1][0], _e1463[0][0], (_e1463[0][0] > _e1463[1][0]));
                                                                let _e1569 = select(_e1463[1][1], _e1463[0][1], (_e1463[0][1] < _e1463[1][1]));
                                                                let _e1573 = select(_e1463[1][1], _e1463[0][1], (_e1463[0][1] > _e1463[1][1]));
                                                                let _e1577 = select(_e1463[1][2], _e1463[0][2], (_e1463[0][2] < _e1463[1][2]));
                                                                let _e1581 = select(_e1463[1][2], _e1463[0][2], (_e1463[0][2] > _e1463[1][2]));
                                                                let _e1586 = ((select(_e1463[2][0], _e1561, (_e1561 < _e1463[2][0])) - _e337) * _e342);
                                                                let _e1587 = ((select(_e1463[2][0], _e1565, (_e1565 > _e1463[2][0])) - _e338) * _e342);
                                                                let _e1590 = ((select(_e1463[2][1], _e1569, (_e1569 < _e1463[2][1])) - _e375) * _e380);
                                                                let _e1591 = ((select(_e1463[2][1], _e1573, (_e1573 > _e1463[2][1])) - _e376) * _e380);
                                                                let _e1594 = ((select(_e1463[2][2], _e1577, (_e1577 < _e1463[2][2])) - _e413) * _e418);
                                                                let _e1595 = ((select(_e1463[2][2], _e1581, (_e1581 > _e1463[2][2])) - _e414) * _e418);
                                                                let _e1597 = select(_e1595, _e1594, (_e1594 < _e1595));
                                                                let _e1599 = select(_e1595, _e1594, (_e1594 > _e1595));
                                                                let _e1601 = select(_e1587, _e1586, (_e1586 < _e1587));
                                                                let _e1603 = select(_e1591, _e1590, (_e1590 < _e1591));
                                                                let _e1605 = select(_e1603, _e1601, (_e1601 > _e1603));
                                                                let _e1607 = select(_e1597, _e1605, (_e1605 > _e1597));
                                                                let _e1609 = select(_e1587, _e1586, (_e1586 > _e1587));
                                                                let _e1611 = select(_e1591, _e1590, (_e1590 > _e1591));
                                                                let _e1613 = select(_e1611, _e1609, (_e1609 < _e1611));
                                                                let _e1615 = select(_e1599, _e1613, (_e1613 < _e1599));
                                                                let _e1616 = -(_e1597);
                                                                let _e1622 = select(_e465, _e1607, (_e1607 > _e465));
                                                                if (_e1622 > (_e1615 + (select(_e1616, _e1599, (_e1599 > _e1616)) * 0.0000019073523f))) {
                                                                    phi_2573_ = type_20();
                                                                    phi_2574_ = true;
                                                                } else {
                                                                    let _e1624 = (_e1622 > _e1034);
                                                                    if _e1624 {
                                                                        phi_2572_ = type_20();
                                                                    } else {
                                                                        let _e1625 = vec3<f32>(_e1463[0][0], _e1463[0][1], _e1463[0][2]);
                                                                        let _e1626 = vec3<f32>(_e1463[1][0], _e1463[1][1], _e1463[1][2]);
                                                                        let _e1627 = vec3<f32>(_e1463[2][0], _e1463[2][1], _e1463[2][2]);
                                                                        let _e1628 = (_e1463[1][0] - _e1463[0][0]);
                                                                        let _e1629 = (_e1463[1][1] - _e1463[0][1]);
                                                                        let _e1630 = (_e1463[1][2] - _e1463[0][2]);
                                                                        let _e1631 = vec3<f32>(_e1628, _e1629, _e1630);
                                                                        let _e1632 = (_e1463[2][0] - _e1463[1][0]);
                                                                        let _e1633 = (_e1463[2][1] - _e1463[1][1]);
                                                                        let _e1634 = (_e1463[2][2] - _e1463[1][2]);
                                                                        let _e1635 = vec3<f32>(_e1632, _e1633, _e1634);
                                                                        let _e1636 = (_e1463[0][0] - _e1463[2][0]);
                                                                        let _e1637 = (_e1463[0][1] - _e1463[2][1]);
                                                                        let _e1638 = (_e1463[0][2] - _e1463[2][2]);
                                                                        let _e1639 = vec3<f32>(_e1636, _e1637, _e1638);
                                                                        let _e1642 = bitcast<f32>((bitcast<u32>(_e1628) & 2147483647u));
                                                                        let _e1645 = bitcast<f32>((bitcast<u32>(_e1629) & 2147483647u));
                                                                        let _e1647 = select(_e1645, _e1642, (_e1642 > _e1645));
                                                                        let _e1650 = bitcast<f32>((bitcast<u32>(_e1630) & 2147483647u));
                                                                        let _e1652 = select(_e1650, _e1647, (_e1647 > _e1650));
                                                                        let _e1655 = bitcast<f32>((bitcast<u32>(_e1632) & 2147483647u));
                                                                        let _e1658 = bitcast<f32>((bitcast<u32>(_e1633) & 2147483647u));
                                                                        let _e1660 = select(_e1658, _e1655, (_e1655 > _e1658));
                                                                        let _e1663 = bitcast<f32>((bitcast<u32>(_e1634) & 2147483647u));
                                                                        let _e1665 = select(_e1663, _e1660, (_e1660 > _e1663));
                                                                        let _e1668 = bitcast<f32>((bitcast<u32>(_e1636) & 2147483647u));
                                                                        let _e1671 = bitcast<f32>((bitcast<u32>(_e1637) & 2147483647u));
                                                                        let _e1673 = select(_e1671, _e1668, (_e1668 > _e1671));
                                                                        let _e1676 = bitcast<f32>((bitcast<u32>(_e1638) & 2147483647u));
                                                                        let _e1678 = select(_e1676, _e1673, (_e1673 > _e1676));
                                                                        let _e1680 = select(_e1665, _e1652, (_e1652 > _e1665));
                                                                        let _e1682 = select(_e1678, _e1680, (_e1680 > _e1678));
                                                                        if (_e1652 == _e1682) {
                                                                            phi_2305_ = _e1489;
                                                                            phi_2306_ = _e1486;
                                                                            phi_2307_ = _e1476;
                                                                            phi_2308_ = _e1473;
                                                                            phi_2309_ = _e1625;
                                                                            phi_2310_ = _e1639;
                                                                            phi_2311_ = _e1635;
                                                                            phi_2312_ = _e1631;
                                                                        } else {
                                                                            let _e1684 = (_e1665 == _e1682);
                                                                            let _e1689 = vec3(_e1684);
                                                                            phi_2305_ = select(_e1476, _e1502, _e1684);
                                                                            phi_2306_ = select(_e1473, _e1499, _e1684);
                                                                            phi_2307_ = select(_e1502, _e1489, _e1684);
                                                                            phi_2308_ = select(_e1499, _e1486, _e1684);
                                                                            phi_2309_ = select(_e1627, _e1626, _e1689);
                                                                            phi_2310_ = select(_e1635, _e1631, _e1689);
                                                                            phi_2311_ = select(_e1631, _e1639, _e1689);
                                                                            phi_2312_ = select(_e1639, _e1635, _e1689);
                                                                        }
                                                                        let _e1695 = phi_2305_;
                                                                        let _e1697 = phi_2306_;
                                                                        let _e1699 = phi_2307_;
                                                                        let _e1701 = phi_2308_;
                                                                        let _e1703 = phi_2309_;
                                                                        let _e1705 = phi_2310_;
                                                                        let _e1707 = phi_2311_;
                                                                        let _e1709 = phi_2312_;
                                                                        let _e1716 = ((_e1707.y * _e1705.z) - (_e1705.y * _e1707.z));
                                                                        let _e1721 = ((_e1707.z * _e1705.x) - (_e1705.z * _e1707.x));
                                                                        let _e1724 = ((_e1707.x * _e1705.y) - (_e1705.x * _e1707.y));
                                                                        if (_e1524 >= _e1528) {
                                                                            phi_2343_ = select(true, false, (_e1524 >= _e1532));
                                                                        } else {
                                                                            phi_2343_ = true;
                                                                        }
                                                                        let _e1729 = phi_2343_;
                                                                        if _e1729 {
                                                                            phi_2352_ = select(_e1627, _e1626, vec3((_e1528 >= _e1532)));
                                                                        } else {
                                                                            phi_2352_ = _e1625;
                                                                        }
                                                                        let _e1734 = phi_2352_;
                                                                        let _e1745 = (((_e1716 * (_e1734.x - _e314)) + (_e1721 * (_e1734.y - _e353))) + (_e1724 * (_e1734.z - _e391)));
                                                                        let _e1750 = (((_e1716 * _e339) + (_e1721 * _e377)) + (_e1724 * _e415));
                                                                        let _e1751 = (_e1697 - _e1701);
                                                                        let _e1752 = (_e1695 - _e1699);
                                                                        let _e1760 = (-(((_e1701 * _e1751) + (_e1699 * _e1752))) / ((_e1751 * _e1751) + (_e1752 * _e1752)));
                                                                        let _e1762 = select(1f, _e1760, (_e1760 < 1f));
                                                                        let _e1764 = select(0f, _e1762, (_e1762 > 0f));
                                                                        let _e1777 = ((_e1703.x + (_e1709.x * _e1764)) - _e314);
                                                                        let _e1778 = ((_e1703.y + (_e1709.y * _e1764)) - _e353);
                                                                        let _e1779 = ((_e1703.z + (_e1709.z * _e1764)) - _e391);
                                                                        let _e1780 = (_e1779 / _e415);
                                                                        let _e1792 = bitcast<f32>((bitcast<u32>(_e1777) & 2147483647u));
                                                                        let _e1795 = bitcast<f32>((bitcast<u32>(_e1778) & 2147483647u));
                                                                        let _e1797 = select(_e1795, _e1792, (_e1792 > _e1795));
                                                                        let _e1800 = bitcast<f32>((bitcast<u32>(_e1779) & 2147483647u));
                                                                        let _e1802 = select(_e1800, _e1797, (_e1797 > _e1800));
                                                                        let _e1808 = bitcast<f32>((bitcast<u32>(_e1716) & 2147483647u));
                                                                        let _e1811 = bitcast<f32>((bitcast<u32>(_e1721) & 2147483647u));
                                                                        let _e1813 = select(_e1811, _e1808, (_e1808 > _e1811));
                                                                        let _e1816 = bitcast<f32>((bitcast<u32>(_e1724) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1716 * _e1777) + (_e1721 * _e1778)) + (_e1724 * _e1779)) - _e1745)) & 2147483647u)) <= ((0.0000009536743f * select(_e1682, _e1802, (_e1802 > _e1682))) * select(_e1816, _e1813, (_e1813 > _e1816)))) {
                                                                            let _e1826 = bitcast<f32>((bitcast<u32>(_e1707.x) & 2147483647u));
                                                                            let _e1829 = bitcast<f32>((bitcast<u32>(_e1707.y) & 2147483647u));
                                                                            let _e1831 = select(_e1829, _e1826, (_e1826 > _e1829));
                                                                            let _e1834 = bitcast<f32>((bitcast<u32>(_e1707.z) & 2147483647u));
                                                                            let _e1840 = bitcast<f32>((bitcast<u32>(_e1705.x) & 2147483647u));
                                                                            let _e1843 = bitcast<f32>((bitcast<u32>(_e1705.y) & 2147483647u));
                                                                            let _e1845 = select(_e1843, _e1840, (_e1840 > _e1843));
                                                                            let _e1848 = bitcast<f32>((bitcast<u32>(_e1705.z) & 2147483647u));
                                                                            let _e1852 = (bitcast<f32>((bitcast<u32>(_e1750) & 2147483647u)) > ((0.0000038146973f * select(_e1834, _e1831, (_e1831 > _e1834))) * select(_e1848, _e1845, (_e1845 > _e1848))));
                                                                            if _e1852 {
                                                                                phi_2517_ = (_e1745 / _e1750);
                                                                            } else {
                                                                                phi_2517_ = f32();
                                                                            }
                                                                            let _e1855 = phi_2517_;
                                                                            phi_2519_ = _e1855;
                                                                            phi_2520_ = select(true, false, _e1852);
                                                                        } else {
                                                                            phi_2519_ = f32();
                                                                            phi_2520_ = true;
                                                                        }
                                                                        let _e1858 = phi_2519_;
                                                                        let _e1860 = phi_2520_;
                                                                        if _e1860 {
                                                                            let _e1868 = (((_e1716 * (_e1777 - (_e339 * _e1780))) + (_e1721 * (_e1778 - (_e377 * _e1780)))) / _e1750);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1868) & 2147483647u)) <= _e1682) {
                                                                                phi_2540_ = (_e1780 + _e1868);
                                                                            } else {
                                                                                phi_2540_ = _e1780;
                                                                            }
                                                                            let _e1875 = phi_2540_;
                                                                            phi_2541_ = _e1875;
                                                                        } else {
                                                                            phi_2541_ = _e1858;
                                                                        }
                                                                        let _e1877 = phi_2541_;
                                                                        let _e1879 = select(_e1615, _e1877, (_e1877 < _e1615));
                                                                        let _e1881 = select(_e1607, _e1879, (_e1879 > _e1607));
                                                                        if (_e1881 >= _e465) {
                                                                            let _e1883 = (_e1881 <= _e1034);
                                                                            if _e1883 {
                                                                                let _e1884 = (1f / _e1534);
                                                                                phi_2564_ = type_20(_e1881, (_e1528 * _e1884), (_e1532 * _e1884), _e1094);
                                                                            } else {
                                                                                phi_2564_ = type_20();
                                                                            }
                                                                            let _e1889 = phi_2564_;
                                                                            phi_2566_ = _e1889;
                                                                            phi_2567_ = select(true, false, _e1883);
                                                                        } else {
                                                                            phi_2566_ = type_20();
                                                                            phi_2567_ = true;
                                                                        }
                                                                        let _e1892 = phi_2566_;
                                                                        let _e1894 = phi_2567_;
                                                                        if _e1894 {
                                                                            phi_2571_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2571_ = _e1892;
                                                                        }
                                                                        let _e1896 = phi_2571_;
                                                                        phi_2572_ = _e1896;
                                                                    }
                                                                    let _e1898 = phi_2572_;
                                                                    phi_2573_ = _e1898;
                                                                    phi_2574_ = _e1624;
                                                                }
                                                                let _e1900 = phi_2573_;
                                                                let _e1902 = phi_2574_;
                                                                phi_2578_ = _e1900;
                                                                phi_2579_ = _e1902;
                                                            }
                                                            let _e1904 = phi_2578_;
                                                            let _e1906 = phi_2579_;
                                                            phi_2580_ = _e1904;
                                                            phi_2581_ = _e1559;
                                                            phi_2582_ = _e1906;
                                                        }
                                                        let _e1908 = phi_2580_;
                                                        let _e1910 = phi_2581_;
                                                        let _e1912 = phi_2582_;
                                                        phi_2583_ = _e1908;
                                                        phi_2584_ = _e1910;
                                                        phi_2585_ = _e1912;
                                                    }
                                                    let _e1914 = phi_2583_;
                                                    let _e1916 = phi_2584_;
                                                    let _e1918 = phi_2585_;
                                                    phi_2593_ = _e1914;
                                                    phi_2594_ = select(_e1918, true, _e1916);
                                                } else {
                                                    phi_2593_ = type_20();
                                                    phi_2594_ = true;
                                                }
                                                let _e1921 = phi_2593_;
                                                let _e1923 = phi_2594_;
                                                if _e1923 {
                                                    phi_2598_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2598_ = _e1921;
                                                }
                                                let _e1925 = phi_2598_;
                                                if (_e1925.member_3 != 4294967295u) {
                                                    if (_e1094 != 4294967295u) {
                                                        phi_2610_ = type_8(0u, 8u);
                                                        phi_2613_ = _e1925;
                                                        loop {
                                                            let _e1930 = phi_2610_;
                                                            let _e1932 = phi_2613_;
                                                            if (_e1930.member < _e1930.member_1) {
                                                                phi_2611_ = type_8((_e1930.member + 1u), _e1930.member_1);
                                                                phi_2636_ = type_8(1u, _e1930.member);
                                                            } else {
                                                                phi_2611_ = _e1930;
                                                                phi_2636_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1945 = phi_2611_;
                                                            let _e1947 = phi_2636_;
                                                            let _e1951 = (bitcast<i32>(_e1947.member) != 0i);
                                                            if _e1951 {
                                                                let _e1952 = (_e1947.member_1 < 8u);
                                                                if _e1952 {
                                                                } else {
                                                                    phi_4437_ = true;
                                                                    break;
                                                                }
                                                                let _e1957 = local_9[_e1947.member_1].member;
                                                                if (_e1932.member < _e1957) {
                                                                    phi_2669_ = true;
                                                                } else {
                                                                    let _e1959 = local_9[_e1947.member_1].member;
                                                                    if (_e1932.member == _e1959) {
                                                                        let _e1964 = local_9[_e1947.member_1].member_3;
                                                                        phi_2668_ = (_e1932.member_3 < _e1964);
                                                                    } else {
                                                                        phi_2668_ = false;
                                                                    }
                                                                    let _e1967 = phi_2668_;
                                                                    phi_2669_ = _e1967;
                                                                }
                                                                let _e1969 = phi_2669_;
                                                                if _e1969 {
                                                                    if _e1952 {
                                                                    } else {
                                                                        phi_4437_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1970 = local_9[_e1947.member_1];
                                                                    local_9[_e1947.member_1] = type_20(_e1932.member, _e1932.member_1, _e1932.member_2, _e1932.member_3);
                                                                    phi_2690_ = type_20(_e1970.member, _e1970.member_1, _e1970.member_2, _e1970.member_3);
                                                                } else {
                                                                    phi_2690_ = _e1932;
                                                                }
                                                                let _e1981 = phi_2690_;
                                                                phi_2614_ = _e1981;
                                                            } else {
                                                                phi_2614_ = type_20();
                                                            }
                                                            let _e1983 = phi_2614_;
                                                            continue;
                                                            continuing {
                                                                phi_2610_ = _e1945;
                                                                phi_2613_ = _e1983;
                                                                phi_4437_ = _e1032;
                                                                break if !(_e1951);
                                                            }
                                                        }
                                                        let _e1986 = phi_4437_;
                                                        phi_4773_ = _e1034;
                                                        phi_4626_ = _e1986;
                                                        if _e1986 {
                                                            break;
                                                        }
                                                        let _e1989 = local_9[7u].member_3;
                                                        if (_e1989 != 4294967295u) {
                                                            let _e1993 = local_9[7u].member;
                                                            phi_4864_ = _e1993;
                                                        } else {
                                                            phi_4864_ = _e1034;
                                                        }
                                                        let _e1995 = phi_4864_;
                                                        phi_4863_ = _e1995;
                                                        phi_4629_ = _e1986;
                                                    } else {
                                                        phi_4863_ = _e1034;
                                                        phi_4629_ = _e1032;
                                                    }
                                                    let _e1997 = phi_4863_;
                                                    let _e1999 = phi_4629_;
                                                    phi_4862_ = _e1997;
                                                    phi_4628_ = _e1999;
                                                } else {
                                                    phi_4862_ = _e1034;
                                                    phi_4628_ = _e1032;
                                                }
                                                let _e2001 = phi_4862_;
                                                let _e2003 = phi_4628_;
                                                phi_4861_ = _e2001;
                                                phi_4627_ = _e2003;
                                            } else {
                                                phi_4861_ = _e1034;
                                                phi_4627_ = _e1032;
                                            }
                                            let _e2005 = phi_4861_;
                                            let _e2007 = phi_4627_;
                                            continue;
                                            continuing {
                                                phi_4466_ = _e2007;
                                                phi_4409_ = _e2005;
                                                phi_1040_ = _e1049;
                                                phi_4773_ = _e2005;
                                                phi_4626_ = _e2007;
                                                break if !(_e1055);
                                            }
                                        }
                                        let _e2010 = phi_4773_;
                                        let _e2012 = phi_4626_;
                                        phi_4631_ = _e2012;
                                        if _e2012 {
                                            break;
                                        }
                                        phi_4738_ = _e2010;
                                        phi_4635_ = _e2012;
                                        phi_3942_ = _e546;
                                        phi_3943_ = false;
                                        phi_3944_ = _e550;
                                    } else {
                                        if (_e546.member_1 >= _e94) {
                                            phi_3497_ = type_52(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_51(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_51(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e546.member_1 < _e94) {
                                            } else {
                                                phi_4631_ = true;
                                                break;
                                            }
                                            let _e562 = (_e265 * 2u);
                                            let _e564 = ((1u + _e562) % 7u);
                                            if (_e564 < 7u) {
                                            } else {
                                                phi_4631_ = true;
                                                break;
                                            }
                                            let _e569 = global_4.member[_e546.member_1][_e564];
                                            let _e571 = ((_e562 + 2u) % 7u);
                                            if (_e571 < 7u) {
                                            } else {
                                                phi_4631_ = true;
                                                break;
                                            }
                                            let _e576 = global_4.member[_e546.member_1][_e571];
                                            let _e577 = (_e264 * 2u);
                                            let _e579 = ((1u + _e577) % 7u);
                                            if (_e579 < 7u) {
                                            } else {
                                                phi_4631_ = true;
                                                break;
                                            }
                                            let _e584 = global_4.member[_e546.member_1][_e579];
                                            let _e586 = ((_e577 + 2u) % 7u);
                                            if (_e586 < 7u) {
                                            } else {
                                                phi_4631_ = true;
                                                break;
                                            }
                                            let _e591 = global_4.member[_e546.member_1][_e586];
                                            let _e592 = (_e266 * 2u);
                                            let _e594 = ((1u + _e592) % 7u);
                                            if (_e594 < 7u) {
                                            } else {
                                                phi_4631_ = true;
                                                break;
                                            }
                                            let _e599 = global_4.member[_e546.member_1][_e594];
                                            let _e601 = ((_e592 + 2u) % 7u);
                                            if (_e601 < 7u) {
                                            } else {
                                                phi_4631_ = true;
                                                break;
                                            }
                                            let _e606 = global_4.member[_e546.member_1][_e601];
                                            let _e629 = (bitcast<f32>((bitcast<u32>((_e546.member.member_1.x - _e546.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e630 = (bitcast<f32>((bitcast<u32>((_e546.member.member_1.y - _e546.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e631 = (bitcast<f32>((bitcast<u32>((_e546.member.member_1.z - _e546.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e633 = select(_e145, _e629, (_e629 > _e145));
                                            let _e635 = select(_e145, _e630, (_e630 > _e145));
                                            let _e637 = select(_e145, _e631, (_e631 > _e145));
                                            let _e662 = bitcast<u32>((f32(bitcast<i32>((_e569 & 2097151u))) * _e633));
                                            let _e667 = (bitcast<i32>((_e569 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e670 = bitcast<f32>((_e662 & bitcast<u32>(_e667)));
                                            let _e671 = bitcast<u32>((f32(bitcast<i32>((_e584 & 2097151u))) * _e635));
                                            let _e676 = (bitcast<i32>((_e584 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e679 = bitcast<f32>((_e671 & bitcast<u32>(_e676)));
                                            let _e680 = bitcast<u32>((f32(bitcast<i32>((_e599 & 2097151u))) * _e637));
                                            let _e685 = (bitcast<i32>((_e599 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e688 = bitcast<f32>((_e680 & bitcast<u32>(_e685)));
                                            let _e692 = bitcast<f32>((_e662 & bitcast<u32>(~(_e667))));
                                            let _e696 = bitcast<f32>((_e671 & bitcast<u32>(~(_e676))));
                                            let _e700 = bitcast<f32>((_e680 & bitcast<u32>(~(_e685))));
                                            let _e701 = bitcast<u32>((f32(bitcast<i32>((_e576 & 2097151u))) * _e633));
                                            let _e706 = (bitcast<i32>((_e576 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e709 = bitcast<f32>((_e701 & bitcast<u32>(_e706)));
                                            let _e710 = bitcast<u32>((f32(bitcast<i32>((_e591 & 2097151u))) * _e635));
                                            let _e715 = (bitcast<i32>((_e591 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e718 = bitcast<f32>((_e710 & bitcast<u32>(_e715)));
                                            let _e719 = bitcast<u32>((f32(bitcast<i32>((_e606 & 2097151u))) * _e637));
                                            let _e724 = (bitcast<i32>((_e606 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e727 = bitcast<f32>((_e719 & bitcast<u32>(_e724)));
                                            let _e731 = bitcast<f32>((_e701 & bitcast<u32>(~(_e706))));
                                            let _e735 = bitcast<f32>((_e710 & bitcast<u32>(~(_e715))));
                                            let _e739 = bitcast<f32>((_e719 & bitcast<u32>(~(_e724))));
                                            let _e740 = (_e546.member.member.x + _e670);
                                            let _e741 = (_e546.member.member.y + _e679);
                                            let _e742 = (_e546.member.member.z + _e688);
                                            let _e745 = (_e546.member.member_1.x - _e709);
                                            let _e746 = (_e546.member.member_1.y - _e718);
                                            let _e747 = (_e546.member.member_1.z - _e727);
                                            let _e766 = (_e745 - _e740);
                                            let _e767 = (_e746 - _e741);
                                            let _e768 = (_e747 - _e742);
                                            let _e770 = select(_e767, _e766, (_e766 > _e767));
                                            let _e772 = select(_e768, _e770, (_e770 > _e768));
                                            if (_e772 < (1024f * _e145)) {
                                                phi_3198_ = 0u;
                                            } else {
                                                phi_3198_ = select(2u, 1u, (_e772 < (2097152f * _e145)));
                                            }
                                            let _e779 = phi_3198_;
                                            switch bitcast<i32>(_e779) {
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
                                            let _e782 = phi_3204_;
                                            let _e788 = global_4.member[_e546.member_1][0u];
                                            let _e792 = global_4.member[_e546.member_1][2u];
                                            let _e796 = global_4.member[_e546.member_1][4u];
                                            let _e800 = global_4.member[_e546.member_1][6u];
                                            let _e812 = (((_e792 >> bitcast<u32>(22i)) | ((_e796 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e800 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e813 = (_e788 & 268435455u);
                                            let _e814 = (_e812 & 268435455u);
                                            let _e817 = ((_e788 >> bitcast<u32>(28u)) & 7u);
                                            let _e825 = ((_e788 >> bitcast<u32>(31i)) | (((_e812 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e826 = (_e817 != 0u);
                                            if (_e817 == 0u) {
                                                phi_3459_ = _e813;
                                            } else {
                                                if (_e817 == 7u) {
                                                    phi_3458_ = 2147483648u;
                                                } else {
                                                    phi_3458_ = ((2147483648u | (_e817 << bitcast<u32>(28u))) | (_e814 & 268435455u));
                                                }
                                                let _e835 = phi_3458_;
                                                phi_3459_ = _e835;
                                            }
                                            let _e837 = phi_3459_;
                                            if _e826 {
                                                let _e838 = (_e817 != 7u);
                                                if _e838 {
                                                    phi_3469_ = (_e814 + (_e817 * ((3u * _e782) + 1u)));
                                                } else {
                                                    phi_3469_ = u32();
                                                }
                                                let _e842 = phi_3469_;
                                                phi_3471_ = _e842;
                                                phi_3472_ = select(true, false, _e838);
                                            } else {
                                                phi_3471_ = u32();
                                                phi_3472_ = true;
                                            }
                                            let _e845 = phi_3471_;
                                            let _e847 = phi_3472_;
                                            if (_e825 == 0u) {
                                                phi_3493_ = (_e813 + select(0u, 1u, !(_e826)));
                                            } else {
                                                if (_e825 == 7u) {
                                                    phi_3492_ = 2147483648u;
                                                } else {
                                                    phi_3492_ = ((2147483648u | (_e825 << bitcast<u32>(28u))) | (select(_e845, _e814, _e847) & 268435455u));
                                                }
                                                let _e860 = phi_3492_;
                                                phi_3493_ = _e860;
                                            }
                                            let _e862 = phi_3493_;
                                            phi_3497_ = type_52(array<vec4<f32>, 3>(vec4<f32>(_e740, (_e546.member.member.x + _e692), _e745, (_e546.member.member_1.x - _e731)), vec4<f32>(_e741, (_e546.member.member.y + _e696), _e746, (_e546.member.member_1.y - _e735)), vec4<f32>(_e742, (_e546.member.member.z + _e700), _e747, (_e546.member.member_1.z - _e739))), type_51(type_24((_e546.member.member + vec4<f32>(_e670, _e679, _e688, 0f)), (_e546.member.member_1 - vec4<f32>(_e709, _e718, _e727, 0f))), _e837), type_51(type_24((_e546.member.member + vec4<f32>(_e692, _e696, _e700, 0f)), (_e546.member.member_1 - vec4<f32>(_e731, _e735, _e739, 0f))), _e862));
                                        }
                                        let _e867 = phi_3497_;
                                        let _e878 = ((_e867.member[0].x - _e337) * _e342);
                                        let _e879 = ((_e867.member[0].y - _e337) * _e342);
                                        let _e880 = ((_e867.member[0].z - _e338) * _e342);
                                        let _e881 = ((_e867.member[0].w - _e338) * _e342);
                                        let _e891 = ((_e867.member[1].x - _e375) * _e380);
                                        let _e892 = ((_e867.member[1].y - _e375) * _e380);
                                        let _e893 = ((_e867.member[1].z - _e376) * _e380);
                                        let _e894 = ((_e867.member[1].w - _e376) * _e380);
                                        let _e904 = ((_e867.member[2].x - _e413) * _e418);
                                        let _e905 = ((_e867.member[2].y - _e413) * _e418);
                                        let _e906 = ((_e867.member[2].z - _e414) * _e418);
                                        let _e907 = ((_e867.member[2].w - _e414) * _e418);
                                        let _e909 = select(_e906, _e904, (_e904 < _e906));
                                        let _e911 = select(_e907, _e905, (_e905 < _e907));
                                        let _e913 = select(_e906, _e904, (_e904 > _e906));
                                        let _e915 = select(_e907, _e905, (_e905 > _e907));
                                        let _e917 = select(_e880, _e878, (_e878 < _e880));
                                        let _e919 = select(_e881, _e879, (_e879 < _e881));
                                        let _e921 = select(_e893, _e891, (_e891 < _e893));
                                        let _e923 = select(_e894, _e892, (_e892 < _e894));
                                        let _e925 = select(_e921, _e917, (_e917 > _e921));
                                        let _e927 = select(_e923, _e919, (_e919 > _e923));
                                        let _e929 = select(_e909, _e925, (_e925 > _e909));
                                        let _e931 = select(_e911, _e927, (_e927 > _e911));
                                        let _e933 = select(_e880, _e878, (_e878 > _e880));
                                        let _e935 = select(_e881, _e879, (_e879 > _e881));
                                        let _e937 = select(_e893, _e891, (_e891 > _e893));
                                        let _e939 = select(_e894, _e892, (_e892 > _e894));
                                        let _e941 = select(_e937, _e933, (_e933 < _e937));
                                        let _e943 = select(_e939, _e935, (_e935 < _e939));
                                        let _e948 = -(_e909);
                                        let _e949 = -(_e911);
                                        let _e956 = (select(_e913, _e941, (_e941 < _e913)) + (select(_e948, _e913, (_e913 > _e948)) * 0.0000019073523f));
                                        let _e957 = (select(_e915, _e943, (_e943 < _e915)) + (select(_e949, _e915, (_e915 > _e949)) * 0.0000019073523f));
                                        let _e959 = select(_e465, _e929, (_e929 > _e465));
                                        let _e961 = select(_e465, _e931, (_e931 > _e465));
                                        let _e966 = (_e959 <= select(_e508, _e956, (_e956 < _e508)));
                                        let _e967 = (_e961 <= select(_e508, _e957, (_e957 < _e508)));
                                        let _e968 = (_e959 <= _e961);
                                        if _e966 {
                                            if _e967 {
                                                if _e968 {
                                                    phi_3842_ = _e867.member_2;
                                                } else {
                                                    phi_3842_ = _e867.member_1;
                                                }
                                                let _e972 = phi_3842_;
                                                let _e994 = (_e550 % 128u);
                                                let _e995 = (_e994 < 128u);
                                                if _e995 {
                                                } else {
                                                    phi_4631_ = true;
                                                    break;
                                                }
                                                local_8[_e994] = _e972.member_1;
                                                if _e995 {
                                                } else {
                                                    phi_4631_ = true;
                                                    break;
                                                }
                                                local_7[_e994] = _e972.member.member.x;
                                                if _e995 {
                                                } else {
                                                    phi_4631_ = true;
                                                    break;
                                                }
                                                local_6[_e994] = _e972.member.member.y;
                                                if _e995 {
                                                } else {
                                                    phi_4631_ = true;
                                                    break;
                                                }
                                                local_5[_e994] = _e972.member.member.z;
                                                if _e995 {
                                                } else {
                                                    phi_4631_ = true;
                                                    break;
                                                }
                                                local_4[_e994] = _e972.member.member_1.x;
                                                if _e995 {
                                                } else {
                                                    phi_4631_ = true;
                                                    break;
                                                }
                                                local_3[_e994] = _e972.member.member_1.y;
                                                if _e995 {
                                                } else {
                                                    phi_4631_ = true;
                                                    break;
                                                }
                                                local_2[_e994] = _e972.member.member_1.z;
                                                if _e995 {
                                                } else {
                                                    phi_4631_ = true;
                                                    break;
                                                }
                                                local_10[_e994] = select(_e961, _e959, (_e959 > _e961));
                                                if _e968 {
                                                    phi_3919_ = _e867.member_1;
                                                } else {
                                                    phi_3919_ = _e867.member_2;
                                                }
                                                let _e1008 = phi_3919_;
                                                phi_3920_ = _e1008;
                                                phi_3921_ = (_e550 + 1u);
                                            } else {
                                                phi_3920_ = type_51();
                                                phi_3921_ = u32();
                                            }
                                            let _e1010 = phi_3920_;
                                            let _e1012 = phi_3921_;
                                            phi_3923_ = _e1010;
                                            phi_3924_ = _e1012;
                                            phi_3925_ = select(true, false, _e967);
                                        } else {
                                            phi_3923_ = type_51();
                                            phi_3924_ = u32();
                                            phi_3925_ = true;
                                        }
                                        let _e1015 = phi_3923_;
                                        let _e1017 = phi_3924_;
                                        let _e1019 = phi_3925_;
                                        if _e1019 {
                                            if _e966 {
                                                phi_3934_ = _e867.member_1;
                                            } else {
                                                phi_3934_ = _e867.member_2;
                                            }
                                            let _e1023 = phi_3934_;
                                            phi_3939_ = _e1023;
                                            phi_3940_ = select(_e967, true, _e966);
                                        } else {
                                            phi_3939_ = _e1015;
                                            phi_3940_ = _e548;
                                        }
                                        let _e1026 = phi_3939_;
                                        let _e1028 = phi_3940_;
                                        phi_4738_ = _e508;
                                        phi_4635_ = _e506;
                                        phi_3942_ = _e1026;
                                        phi_3943_ = _e1028;
                                        phi_3944_ = select(_e1017, _e550, _e1019);
                                    }
                                    let _e2014 = phi_4738_;
                                    let _e2016 = phi_4635_;
                                    let _e2018 = phi_3942_;
                                    let _e2020 = phi_3943_;
                                    let _e2022 = phi_3944_;
                                    phi_4737_ = _e2014;
                                    phi_4634_ = _e2016;
                                    phi_3945_ = _e2018;
                                    phi_3946_ = (_e512 - 1u);
                                    phi_3947_ = _e2020;
                                    phi_3948_ = _e2022;
                                } else {
                                    phi_4737_ = _e508;
                                    phi_4634_ = _e506;
                                    phi_3945_ = _e546;
                                    phi_3946_ = _e512;
                                    phi_3947_ = _e548;
                                    phi_3948_ = _e550;
                                }
                                let _e2024 = phi_4737_;
                                let _e2026 = phi_4634_;
                                let _e2028 = phi_3945_;
                                let _e2030 = phi_3946_;
                                let _e2032 = phi_3947_;
                                let _e2034 = phi_3948_;
                                phi_4736_ = _e2024;
                                phi_4633_ = _e2026;
                                phi_3949_ = _e2028;
                                phi_3950_ = _e2030;
                                phi_3951_ = _e2032;
                                phi_3952_ = _e2034;
                            } else {
                                phi_4736_ = _e508;
                                phi_4633_ = _e506;
                                phi_3949_ = type_51();
                                phi_3950_ = u32();
                                phi_3951_ = bool();
                                phi_3952_ = u32();
                            }
                            let _e2036 = phi_4736_;
                            let _e2038 = phi_4633_;
                            let _e2040 = phi_3949_;
                            let _e2042 = phi_3950_;
                            let _e2044 = phi_3951_;
                            let _e2046 = phi_3952_;
                            phi_4735_ = _e2036;
                            phi_4632_ = _e2038;
                            phi_915_ = _e2040;
                            phi_918_ = _e2042;
                            phi_920_ = _e2044;
                            phi_922_ = _e2046;
                            phi_3953_ = _e520;
                        } else {
                            phi_4735_ = _e508;
                            phi_4632_ = _e506;
                            phi_915_ = type_51();
                            phi_918_ = u32();
                            phi_920_ = bool();
                            phi_922_ = u32();
                            phi_3953_ = false;
                        }
                        let _e2048 = phi_4735_;
                        let _e2050 = phi_4632_;
                        let _e2052 = phi_915_;
                        let _e2054 = phi_918_;
                        let _e2056 = phi_920_;
                        let _e2058 = phi_922_;
                        let _e2060 = phi_3953_;
                        continue;
                        continuing {
                            phi_4469_ = _e2050;
                            phi_4325_ = _e2048;
                            phi_914_ = _e2052;
                            phi_917_ = _e2054;
                            phi_919_ = _e2056;
                            phi_921_ = _e2058;
                            phi_4631_ = _e2050;
                            break if !(_e2060);
                        }
                    }
                    let _e2063 = phi_4631_;
                    if _e2063 {
                        break;
                    }
                    phi_3960_ = type_8(0u, 8u);
                    loop {
                        let _e2065 = phi_3960_;
                        if (_e2065.member < _e2065.member_1) {
                            phi_3961_ = type_8((_e2065.member + 1u), _e2065.member_1);
                            phi_3984_ = type_8(1u, _e2065.member);
                        } else {
                            phi_3961_ = _e2065;
                            phi_3984_ = type_8(0u, type_8().member_1);
                        }
                        let _e2078 = phi_3961_;
                        let _e2080 = phi_3984_;
                        let _e2084 = (bitcast<i32>(_e2080.member) != 0i);
                        if _e2084 {
                            let _e2085 = (_e2080.member_1 < 8u);
                            if _e2085 {
                            } else {
                                phi_4728_ = true;
                                break;
                            }
                            let _e2087 = local_9[_e2080.member_1];
                            if (_e2087.member_3 != 4294967295u) {
                                let _e2093 = -(_e432);
                                let _e2094 = (_e2093 / 3i);
                                let _e2101 = bitcast<f32>((bitcast<u32>((_e2094 + 127i)) << bitcast<u32>(23i)));
                                let _e2109 = (((_e2087.member * _e2101) * _e2101) * bitcast<f32>((bitcast<u32>(((_e2093 - (2i * _e2094)) + 127i)) << bitcast<u32>(23i))));
                                let _e2111 = select(340282350000000000000000000000000000000f, _e2109, (_e2109 < 340282350000000000000000000000000000000f));
                                phi_4050_ = type_20(select(-340282350000000000000000000000000000000f, _e2111, (_e2111 > -340282350000000000000000000000000000000f)), _e2087.member_1, _e2087.member_2, _e2087.member_3);
                            } else {
                                phi_4050_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e2116 = phi_4050_;
                            if _e2085 {
                            } else {
                                phi_4728_ = true;
                                break;
                            }
                            local_9[_e2080.member_1] = type_20(_e2116.member, _e2116.member_1, _e2116.member_2, _e2116.member_3);
                        }
                        continue;
                        continuing {
                            phi_3960_ = _e2078;
                            phi_4728_ = _e2063;
                            break if !(_e2084);
                        }
                    }
                    let _e2124 = phi_4728_;
                    if _e2124 {
                        break;
                    }
                    let _e2125 = local_9;
                    if _e153 {
                    } else {
                        break;
                    }
                    global_6.member[_e151] = array<type_20, 8>(type_20(_e2125[0].member, _e2125[0].member_1, _e2125[0].member_2, _e2125[0].member_3), type_20(_e2125[1].member, _e2125[1].member_1, _e2125[1].member_2, _e2125[1].member_3), type_20(_e2125[2].member, _e2125[2].member_1, _e2125[2].member_2, _e2125[2].member_3), type_20(_e2125[3].member, _e2125[3].member_1, _e2125[3].member_2, _e2125[3].member_3), type_20(_e2125[4].member, _e2125[4].member_1, _e2125[4].member_2, _e2125[4].member_3), type_20(_e2125[5].member, _e2125[5].member_1, _e2125[5].member_2, _e2125[5].member_3), type_20(_e2125[6].member, _e2125[6].member_1, _e2125[6].member_2, _e2125[6].member_3), type_20(_e2125[7].member, _e2125[7].member_1, _e2125[7].member_2, _e2125[7].member_3));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_nearest_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
