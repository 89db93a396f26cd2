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

struct type_21 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_23 {
    member: array<type_21>,
}

struct type_25 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_26 {
    member: type_25,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_28 {
    member: array<type_26>,
}

struct type_33 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_35 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_38 {
    member: type_21,
    member_1: f32,
}

struct type_43 {
    member: array<vec4<u32>, 2>,
}

struct type_46 {
    member: array<i32>,
}

struct type_52 {
    member: array<array<u32, 7>>,
}

struct type_57 {
    member: type_33,
    member_1: u32,
}

struct type_58 {
    member: array<vec4<f32>, 3>,
    member_1: type_57,
    member_2: type_57,
}

struct type_63 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_43;
@group(0) @binding(2) 
var<uniform> global_3: type_43;
@group(0) @binding(5) 
var<storage> global_4: type_4;
@group(0) @binding(6) 
var<storage> global_5: type_46;
@group(0) @binding(7) 
var<storage> global_6: type_28;
@group(0) @binding(8) 
var<storage, read_write> global_7: type_23;
@group(0) @binding(9) 
var<storage, read_write> global_8: type_63;
@group(0) @binding(3) 
var<storage> global_9: type_52;
@group(0) @binding(4) 
var<storage> global_10: type_4;

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
    var phi_333_: u32;
    var phi_377_: i32;
    var phi_401_: type_35;
    var phi_507_: i32;
    var phi_508_: i32;
    var phi_518_: bool;
    var phi_528_: u32;
    var phi_529_: u32;
    var phi_531_: bool;
    var phi_536_: u32;
    var phi_568_: i32;
    var phi_586_: f32;
    var phi_592_: f32;
    var phi_603_: f32;
    var phi_609_: f32;
    var phi_632_: f32;
    var phi_643_: f32;
    var phi_652_: f32;
    var phi_658_: f32;
    var phi_669_: f32;
    var phi_675_: f32;
    var phi_698_: f32;
    var phi_709_: f32;
    var phi_718_: f32;
    var phi_724_: f32;
    var phi_735_: f32;
    var phi_741_: f32;
    var phi_764_: f32;
    var phi_775_: f32;
    var phi_875_: f32;
    var phi_876_: f32;
    var phi_4596_: bool;
    var phi_965_: type_38;
    var phi_968_: type_57;
    var phi_970_: u32;
    var phi_972_: bool;
    var phi_974_: u32;
    var phi_985_: bool;
    var phi_1071_: type_57;
    var phi_1072_: bool;
    var phi_1073_: u32;
    var phi_3508_: u32;
    var phi_3514_: u32;
    var phi_3768_: u32;
    var phi_3769_: u32;
    var phi_3779_: u32;
    var phi_3781_: u32;
    var phi_3782_: bool;
    var phi_3802_: u32;
    var phi_3803_: u32;
    var phi_3807_: type_58;
    var phi_4151_: type_57;
    var phi_4228_: type_57;
    var phi_4229_: type_57;
    var phi_4230_: u32;
    var phi_4232_: type_57;
    var phi_4233_: u32;
    var phi_4234_: bool;
    var phi_4243_: type_57;
    var phi_4248_: type_57;
    var phi_4249_: bool;
    var phi_1092_: type_38;
    var phi_1095_: type_8;
    var phi_1096_: type_8;
    var phi_1118_: type_8;
    var phi_1159_: u32;
    var phi_1165_: u32;
    var phi_1175_: u32;
    var phi_1191_: u32;
    var phi_1224_: u32;
    var phi_1230_: u32;
    var phi_1657_: u32;
    var phi_1675_: u32;
    var phi_1693_: u32;
    var phi_1713_: u32;
    var phi_1731_: u32;
    var phi_1749_: u32;
    var phi_1769_: u32;
    var phi_1787_: u32;
    var phi_1805_: u32;
    var phi_1383_: u32;
    var phi_1398_: u32;
    var phi_1408_: u32;
    var phi_1428_: u32;
    var phi_1448_: u32;
    var phi_1474_: u32;
    var phi_1489_: u32;
    var phi_1499_: u32;
    var phi_1519_: u32;
    var phi_1539_: u32;
    var phi_1565_: u32;
    var phi_1580_: u32;
    var phi_1590_: u32;
    var phi_1610_: u32;
    var phi_1630_: u32;
    var phi_1254_: u32;
    var phi_1297_: u32;
    var phi_1340_: u32;
    var phi_1811_: array<array<f32, 3>, 3>;
    var phi_1928_: bool;
    var phi_1957_: bool;
    var phi_2358_: f32;
    var phi_2359_: f32;
    var phi_2360_: f32;
    var phi_2361_: f32;
    var phi_2362_: vec3<f32>;
    var phi_2363_: vec3<f32>;
    var phi_2364_: vec3<f32>;
    var phi_2365_: vec3<f32>;
    var phi_2396_: bool;
    var phi_2405_: vec3<f32>;
    var phi_2572_: bool;
    var phi_2596_: f32;
    var phi_2597_: f32;
    var phi_2620_: type_21;
    var phi_2622_: type_21;
    var phi_2623_: bool;
    var phi_2627_: type_21;
    var phi_2628_: type_21;
    var phi_2629_: type_21;
    var phi_2630_: bool;
    var phi_2634_: type_21;
    var phi_2635_: bool;
    var phi_2636_: type_21;
    var phi_2637_: bool;
    var phi_2638_: bool;
    var phi_2639_: type_21;
    var phi_2640_: bool;
    var phi_2641_: bool;
    var phi_2649_: type_21;
    var phi_2650_: bool;
    var phi_2654_: type_21;
    var phi_2677_: u32;
    var phi_2691_: i32;
    var phi_2711_: vec3<f32>;
    var phi_2712_: vec3<f32>;
    var phi_2728_: vec3<f32>;
    var phi_2729_: vec3<f32>;
    var phi_2745_: vec3<f32>;
    var phi_2746_: vec3<f32>;
    var phi_2782_: vec3<f32>;
    var phi_2964_: f32;
    var phi_2982_: bool;
    var phi_2983_: bool;
    var phi_3002_: bool;
    var phi_3003_: bool;
    var phi_3009_: type_38;
    var phi_3010_: type_38;
    var phi_3011_: type_38;
    var phi_1093_: type_38;
    var phi_4590_: bool;
    var phi_4807_: bool;
    var phi_4251_: type_38;
    var phi_4252_: type_57;
    var phi_4253_: bool;
    var phi_4254_: u32;
    var phi_4806_: bool;
    var phi_4255_: type_38;
    var phi_4256_: type_57;
    var phi_4257_: u32;
    var phi_4258_: bool;
    var phi_4259_: u32;
    var phi_4805_: bool;
    var phi_4260_: type_38;
    var phi_4261_: type_57;
    var phi_4262_: u32;
    var phi_4263_: bool;
    var phi_4264_: u32;
    var phi_4804_: bool;
    var phi_966_: type_38;
    var phi_969_: type_57;
    var phi_971_: u32;
    var phi_973_: bool;
    var phi_975_: u32;
    var phi_4265_: bool;
    var phi_4803_: bool;
    var local_10: type_38;
    var phi_4317_: type_21;
    var local_11: type_38;

    switch bitcast<i32>(0u) {
        default: {
            let _e97 = global;
            let _e99 = arrayLength((&global_9.member));
            let _e102 = arrayLength((&global_10.member));
            let _e114 = arrayLength((&global_8.member));
            let _e118 = global_3.member[0u][0u];
            let _e122 = global_3.member[0u][1u];
            let _e126 = global_3.member[0u][2u];
            let _e130 = global_3.member[0u][3u];
            let _e134 = global_3.member[1u][0u];
            let _e138 = global_3.member[1u][1u];
            let _e142 = global_3.member[1u][2u];
            let _e146 = (_e97.x + (_e97.y * 2097152u));
            let _e158 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e130) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e118), bitcast<i32>(_e122), bitcast<i32>(_e126));
            local = array<i32, 3>(bitcast<i32>(_e134), bitcast<i32>(_e138), bitcast<i32>(_e142));
            let _e161 = (_e146 < arrayLength((&global_6.member)));
            if _e161 {
                if _e161 {
                } else {
                    break;
                }
                let _e165 = global_6.member[_e146].member_2;
                phi_333_ = _e165;
            } else {
                phi_333_ = 4294967295u;
            }
            let _e167 = phi_333_;
            let _e170 = global_1.member[0u];
            let _e174 = global_2.member[0u][0u];
            let _e178 = global_2.member[0u][1u];
            let _e182 = global_2.member[0u][2u];
            let _e186 = global_2.member[0u][3u];
            let _e190 = global_2.member[1u][0u];
            let _e194 = global_2.member[1u][1u];
            let _e198 = global_2.member[1u][2u];
            let _e202 = global_2.member[1u][3u];
            let _e203 = bitcast<f32>(_e174);
            let _e204 = bitcast<f32>(_e178);
            let _e205 = bitcast<f32>(_e182);
            let _e207 = bitcast<f32>(_e190);
            let _e208 = array<u32, 3>(_e194, _e198, _e202);
            let _e210 = bitcast<i32>(_e170);
            if (_e210 < -126i) {
                phi_377_ = -126i;
            } else {
                phi_377_ = select(_e210, 127i, (_e210 > 127i));
            }
            let _e215 = phi_377_;
            let _e220 = bitcast<f32>((bitcast<u32>((_e215 + 127i)) << bitcast<u32>(23i)));
            let _e226 = bitcast<f32>((bitcast<u32>(((_e210 - _e215) + 127i)) << bitcast<u32>(23i)));
            if (_e186 == 0u) {
                phi_401_ = type_35(array<f32, 3>(_e203, _e204, _e205), _e186, _e207, _e208);
            } else {
                phi_401_ = type_35(array<f32, 3>(((_e203 * _e220) * _e226), ((_e204 * _e220) * _e226), ((_e205 * _e220) * _e226)), _e186, ((_e207 * _e220) * _e226), _e208);
            }
            let _e239 = phi_401_;
            if _e161 {
                let _e240 = (_e146 < arrayLength((&global_7.member)));
                if _e240 {
                    if _e161 {
                    } else {
                        break;
                    }
                    let _e250 = global_6.member[_e146].member.member_2[0u];
                    let _e252 = (bitcast<u32>(_e250) & 2147483647u);
                    let _e258 = global_6.member[_e146].member.member_2[1u];
                    let _e260 = (bitcast<u32>(_e258) & 2147483647u);
                    let _e266 = global_6.member[_e146].member.member_2[2u];
                    let _e268 = (bitcast<u32>(_e266) & 2147483647u);
                    let _e274 = global_6.member[_e146].member.member[0u];
                    let _e276 = (bitcast<u32>(_e274) & 2147483647u);
                    let _e282 = global_6.member[_e146].member.member[1u];
                    let _e284 = (bitcast<u32>(_e282) & 2147483647u);
                    let _e290 = global_6.member[_e146].member.member[2u];
                    let _e292 = (bitcast<u32>(_e290) & 2147483647u);
                    let _e294 = select(_e260, _e252, (_e260 < _e252));
                    let _e296 = select(_e268, _e294, (_e268 < _e294));
                    let _e298 = select(_e276, _e296, (_e276 < _e296));
                    let _e300 = select(_e284, _e298, (_e284 < _e298));
                    let _e302 = select(_e292, _e300, (_e292 < _e300));
                    let _e307 = global_6.member[_e146].member.member_1;
                    let _e309 = (bitcast<u32>(_e307) & 2147483647u);
                    let _e317 = global_6.member[_e146].member.member_3;
                    let _e323 = (((select(_e309, _e302, (_e309 < _e302)) < 2139095040u) && ((bitcast<u32>(_e317) & 2147483647u) <= 2139095040u)) && (_e296 > 0u));
                    if _e323 {
                        let _e326 = (bitcast<u32>(bitcast<f32>(_e296)) & 2147483647u);
                        if (_e326 >= 8388608u) {
                            phi_507_ = (bitcast<i32>((_e326 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_507_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e326)), 32u, (_e326 == 0u))));
                        }
                        let _e340 = phi_507_;
                        phi_508_ = _e340;
                    } else {
                        phi_508_ = 0i;
                    }
                    let _e342 = phi_508_;
                    let _e343 = (_e252 == _e296);
                    if _e343 {
                        phi_518_ = true;
                    } else {
                        phi_518_ = (_e260 == _e296);
                    }
                    let _e346 = phi_518_;
                    let _e347 = select(1u, 0u, _e343);
                    if _e346 {
                        let _e348 = (_e347 + 1u);
                        phi_528_ = _e348;
                        phi_529_ = _e348;
                        phi_531_ = select(true, false, (_e348 == 2u));
                    } else {
                        phi_528_ = u32();
                        phi_529_ = 0u;
                        phi_531_ = true;
                    }
                    let _e352 = phi_528_;
                    let _e354 = phi_529_;
                    let _e356 = phi_531_;
                    if _e356 {
                        phi_536_ = (_e354 + 1u);
                    } else {
                        phi_536_ = 0u;
                    }
                    let _e360 = phi_536_;
                    let _e361 = select(_e352, _e354, _e356);
                    let _e362 = select(_e347, select(2u, _e347, _e346), _e356);
                    let _e363 = -(_e342);
                    if (_e363 < -126i) {
                        phi_568_ = -126i;
                    } else {
                        phi_568_ = select(_e363, 127i, (_e363 > 127i));
                    }
                    let _e368 = phi_568_;
                    let _e373 = bitcast<f32>((bitcast<u32>((_e368 + 127i)) << bitcast<u32>(23i)));
                    let _e379 = bitcast<f32>((bitcast<u32>(((_e363 - _e368) + 127i)) << bitcast<u32>(23i)));
                    let _e384 = global_6.member[_e146].member.member;
                    let _e385 = (_e361 == 0u);
                    if _e385 {
                        phi_586_ = _e384[0];
                    } else {
                        phi_586_ = _e384[1];
                    }
                    let _e389 = phi_586_;
                    let _e390 = (_e361 == 2u);
                    if _e390 {
                        phi_592_ = _e384[2];
                    } else {
                        phi_592_ = _e389;
                    }
                    let _e393 = phi_592_;
                    let _e394 = global_6.member[_e146].member.member_2;
                    if _e385 {
                        phi_603_ = _e394[0];
                    } else {
                        phi_603_ = _e394[1];
                    }
                    let _e398 = phi_603_;
                    if _e390 {
                        phi_609_ = _e394[2];
                    } else {
                        phi_609_ = _e398;
                    }
                    let _e401 = phi_609_;
                    let _e403 = ((_e401 * _e373) * _e379);
                    let _e407 = (bitcast<f32>((bitcast<u32>(_e403) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e407 {
                        let _e411 = (bitcast<f32>((bitcast<u32>(_e393) & 2147483647u)) * 0.00000011920929f);
                        phi_632_ = select(0.00000000000011368684f, _e411, (_e411 > 0.00000000000011368684f));
                    } else {
                        phi_632_ = 0f;
                    }
                    let _e415 = phi_632_;
                    let _e416 = (_e393 + _e415);
                    let _e417 = (_e393 - _e415);
                    let _e418 = select(_e403, 0f, _e407);
                    if _e407 {
                        phi_643_ = 38685626000000000000000000f;
                    } else {
                        phi_643_ = (1f / _e403);
                    }
                    let _e421 = phi_643_;
                    let _e422 = (_e360 == 0u);
                    if _e422 {
                        phi_652_ = _e384[0];
                    } else {
                        phi_652_ = _e384[1];
                    }
                    let _e426 = phi_652_;
                    let _e427 = (_e360 == 2u);
                    if _e427 {
                        phi_658_ = _e384[2];
                    } else {
                        phi_658_ = _e426;
                    }
                    let _e430 = phi_658_;
                    if _e422 {
                        phi_669_ = _e394[0];
                    } else {
                        phi_669_ = _e394[1];
                    }
                    let _e434 = phi_669_;
                    if _e427 {
                        phi_675_ = _e394[2];
                    } else {
                        phi_675_ = _e434;
                    }
                    let _e437 = phi_675_;
                    let _e439 = ((_e437 * _e373) * _e379);
                    let _e443 = (bitcast<f32>((bitcast<u32>(_e439) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e443 {
                        let _e447 = (bitcast<f32>((bitcast<u32>(_e430) & 2147483647u)) * 0.00000011920929f);
                        phi_698_ = select(0.00000000000011368684f, _e447, (_e447 > 0.00000000000011368684f));
                    } else {
                        phi_698_ = 0f;
                    }
                    let _e451 = phi_698_;
                    let _e452 = (_e430 + _e451);
                    let _e453 = (_e430 - _e451);
                    let _e454 = select(_e439, 0f, _e443);
                    if _e443 {
                        phi_709_ = 38685626000000000000000000f;
                    } else {
                        phi_709_ = (1f / _e439);
                    }
                    let _e457 = phi_709_;
                    let _e458 = (_e362 == 0u);
                    if _e458 {
                        phi_718_ = _e384[0];
                    } else {
                        phi_718_ = _e384[1];
                    }
                    let _e462 = phi_718_;
                    let _e463 = (_e362 == 2u);
                    if _e463 {
                        phi_724_ = _e384[2];
                    } else {
                        phi_724_ = _e462;
                    }
                    let _e466 = phi_724_;
                    if _e458 {
                        phi_735_ = _e394[0];
                    } else {
                        phi_735_ = _e394[1];
                    }
                    let _e470 = phi_735_;
                    if _e463 {
                        phi_741_ = _e394[2];
                    } else {
                        phi_741_ = _e470;
                    }
                    let _e473 = phi_741_;
                    let _e475 = ((_e473 * _e373) * _e379);
                    let _e479 = (bitcast<f32>((bitcast<u32>(_e475) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e479 {
                        let _e483 = (bitcast<f32>((bitcast<u32>(_e466) & 2147483647u)) * 0.00000011920929f);
                        phi_764_ = select(0.00000000000011368684f, _e483, (_e483 > 0.00000000000011368684f));
                    } else {
                        phi_764_ = 0f;
                    }
                    let _e487 = phi_764_;
                    let _e488 = (_e466 + _e487);
                    let _e489 = (_e466 - _e487);
                    let _e490 = select(_e475, 0f, _e479);
                    if _e479 {
                        phi_775_ = 38685626000000000000000000f;
                    } else {
                        phi_775_ = (1f / _e475);
                    }
                    let _e493 = phi_775_;
                    let _e496 = bitcast<f32>((bitcast<u32>(_e393) & 2147483647u));
                    let _e499 = bitcast<f32>((bitcast<u32>(_e430) & 2147483647u));
                    let _e501 = select(_e499, _e496, (_e496 > _e499));
                    let _e504 = bitcast<f32>((bitcast<u32>(_e466) & 2147483647u));
                    if (_e323 && (select(_e504, _e501, (_e501 > _e504)) <= 1099511600000f)) {
                        let _e509 = (_e342 / 3i);
                        let _e516 = bitcast<f32>((bitcast<u32>((_e509 + 127i)) << bitcast<u32>(23i)));
                        let _e523 = bitcast<f32>((bitcast<u32>(((_e342 - (2i * _e509)) + 127i)) << bitcast<u32>(23i)));
                        let _e524 = (((_e307 * _e516) * _e516) * _e523);
                        let _e526 = select(340282350000000000000000000000000000000f, _e524, (_e524 < 340282350000000000000000000000000000000f));
                        let _e531 = (((_e317 * _e516) * _e516) * _e523);
                        let _e533 = select(340282350000000000000000000000000000000f, _e531, (_e531 < 340282350000000000000000000000000000000f));
                        phi_875_ = select(-340282350000000000000000000000000000000f, _e533, (_e533 > -340282350000000000000000000000000000000f));
                        phi_876_ = select(-340282350000000000000000000000000000000f, _e526, (_e526 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_875_ = 0f;
                        phi_876_ = 1f;
                    }
                    let _e537 = phi_875_;
                    let _e539 = phi_876_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e543 = (_e361 % 3u);
                    let _e544 = (_e543 < 3u);
                    if _e544 {
                    } else {
                        break;
                    }
                    let _e546 = local_1[_e543];
                    let _e549 = (_e360 % 3u);
                    let _e550 = (_e549 < 3u);
                    if _e550 {
                    } else {
                        break;
                    }
                    let _e552 = local_1[_e549];
                    let _e555 = (_e362 % 3u);
                    let _e556 = (_e555 < 3u);
                    if _e556 {
                    } else {
                        break;
                    }
                    let _e558 = local_1[_e555];
                    if _e544 {
                    } else {
                        break;
                    }
                    let _e563 = local[_e543];
                    if _e550 {
                    } else {
                        break;
                    }
                    let _e567 = local[_e549];
                    if _e556 {
                    } else {
                        break;
                    }
                    let _e571 = local[_e555];
                    phi_4596_ = false;
                    phi_965_ = type_38(type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e537);
                    phi_968_ = type_57(type_33(vec4<f32>((f32(_e546) * _e158), (f32(_e552) * _e158), (f32(_e558) * _e158), 0f), vec4<f32>((f32(_e563) * _e158), (f32(_e567) * _e158), (f32(_e571) * _e158), 0f)), select(0u, 2147483648u, (_e99 == 0u)));
                    phi_970_ = ((3u * _e99) + 1u);
                    phi_972_ = (_e539 <= _e537);
                    phi_974_ = 0u;
                    loop {
                        let _e581 = phi_4596_;
                        let _e583 = phi_965_;
                        let _e585 = phi_968_;
                        let _e587 = phi_970_;
                        let _e589 = phi_972_;
                        let _e591 = phi_974_;
                        local_10 = _e583;
                        if _e589 {
                            phi_985_ = true;
                        } else {
                            phi_985_ = (_e591 > 0u);
                        }
                        let _e594 = phi_985_;
                        if _e594 {
                            let _e595 = (_e587 > 0u);
                            if _e595 {
                                if _e589 {
                                    phi_1071_ = _e585;
                                    phi_1072_ = _e589;
                                    phi_1073_ = _e591;
                                } else {
                                    let _e596 = (_e591 - 1u);
                                    let _e597 = (_e596 % 128u);
                                    let _e598 = (_e597 < 128u);
                                    if _e598 {
                                    } else {
                                        phi_4803_ = true;
                                        break;
                                    }
                                    let _e600 = local_7[_e597];
                                    if _e598 {
                                    } else {
                                        phi_4803_ = true;
                                        break;
                                    }
                                    let _e602 = local_6[_e597];
                                    if _e598 {
                                    } else {
                                        phi_4803_ = true;
                                        break;
                                    }
                                    let _e604 = local_5[_e597];
                                    if _e598 {
                                    } else {
                                        phi_4803_ = true;
                                        break;
                                    }
                                    let _e606 = local_4[_e597];
                                    if _e598 {
                                    } else {
                                        phi_4803_ = true;
                                        break;
                                    }
                                    let _e608 = local_3[_e597];
                                    if _e598 {
                                    } else {
                                        phi_4803_ = true;
                                        break;
                                    }
                                    let _e610 = local_2[_e597];
                                    if _e598 {
                                    } else {
                                        phi_4803_ = true;
                                        break;
                                    }
                                    let _e615 = local_8[_e597];
                                    if _e598 {
                                    } else {
                                        phi_4803_ = true;
                                        break;
                                    }
                                    let _e618 = local_9[_e597];
                                    phi_1071_ = type_57(type_33(vec4<f32>(_e600, _e602, _e604, 0f), vec4<f32>(_e606, _e608, _e610, 0f)), _e615);
                                    phi_1072_ = (_e618 <= _e583.member_1);
                                    phi_1073_ = _e596;
                                }
                                let _e622 = phi_1071_;
                                let _e624 = phi_1072_;
                                let _e626 = phi_1073_;
                                if _e624 {
                                    let _e631 = (_e622.member_1 & 268435455u);
                                    if ((_e622.member_1 & 2147483648u) != 0u) {
                                        phi_1092_ = _e583;
                                        phi_1095_ = type_8(0u, ((_e622.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1109 = phi_1092_;
                                            let _e1111 = phi_1095_;
                                            local_11 = _e1109;
                                            if (_e1111.member < _e1111.member_1) {
                                                phi_1096_ = type_8((_e1111.member + 1u), _e1111.member_1);
                                                phi_1118_ = type_8(1u, _e1111.member);
                                            } else {
                                                phi_1096_ = _e1111;
                                                phi_1118_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1124 = phi_1096_;
                                            let _e1126 = phi_1118_;
                                            let _e1130 = (bitcast<i32>(_e1126.member) != 0i);
                                            if _e1130 {
                                                let _e1135 = (_e622.member.member_1.x - _e622.member.member.x);
                                                let _e1138 = (_e622.member.member_1.y - _e622.member.member.y);
                                                let _e1141 = (_e622.member.member_1.z - _e622.member.member.z);
                                                let _e1143 = select(_e1138, _e1135, (_e1135 > _e1138));
                                                let _e1145 = select(_e1141, _e1143, (_e1143 > _e1141));
                                                let _e1147 = (_e1145 < (1024f * _e158));
                                                if _e1147 {
                                                    phi_1159_ = 0u;
                                                } else {
                                                    phi_1159_ = select(2u, 1u, (_e1145 < (2097152f * _e158)));
                                                }
                                                let _e1152 = phi_1159_;
                                                switch bitcast<i32>(_e1152) {
                                                    case 0: {
                                                        phi_1165_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1165_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1165_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1165_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1155 = phi_1165_;
                                                switch bitcast<i32>(_e1152) {
                                                    case 0: {
                                                        phi_1175_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1175_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1175_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1175_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1162 = phi_1175_;
                                                let _e1164 = ((_e631 + (_e1126.member_1 * ((3u * _e1155) + 1u))) + (3u * _e1162));
                                                let _e1165 = (_e1164 < _e102);
                                                if _e1165 {
                                                    if _e1165 {
                                                    } else {
                                                        phi_4590_ = true;
                                                        break;
                                                    }
                                                    let _e1167 = global_10.member[_e1164];
                                                    phi_1191_ = _e1167;
                                                } else {
                                                    phi_1191_ = 4294967295u;
                                                }
                                                let _e1169 = phi_1191_;
                                                if _e1147 {
                                                    phi_1224_ = 0u;
                                                } else {
                                                    phi_1224_ = select(2u, 1u, (_e1145 < (2097152f * _e158)));
                                                }
                                                let _e1174 = phi_1224_;
                                                switch bitcast<i32>(_e1174) {
                                                    case 0: {
                                                        phi_1230_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1230_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1230_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1230_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1177 = phi_1230_;
                                                let _e1181 = (_e631 + (_e1126.member_1 * ((3u * _e1177) + 1u)));
                                                switch bitcast<i32>(_e1174) {
                                                    case 0: {
                                                        let _e1447 = (_e1181 < _e102);
                                                        if _e1447 {
                                                            if _e1447 {
                                                            } else {
                                                                phi_4590_ = true;
                                                                break;
                                                            }
                                                            let _e1449 = global_10.member[_e1181];
                                                            phi_1254_ = _e1449;
                                                        } else {
                                                            phi_1254_ = 0u;
                                                        }
                                                        let _e1451 = phi_1254_;
                                                        let _e1453 = ((10u * _e361) & 31u);
                                                        let _e1462 = ((10u * _e360) & 31u);
                                                        let _e1471 = ((10u * _e362) & 31u);
                                                        let _e1480 = (_e1181 + 1u);
                                                        let _e1481 = (_e1480 < _e102);
                                                        if _e1481 {
                                                            if _e1481 {
                                                            } else {
                                                                phi_4590_ = true;
                                                                break;
                                                            }
                                                            let _e1483 = global_10.member[_e1480];
                                                            phi_1297_ = _e1483;
                                                        } else {
                                                            phi_1297_ = 0u;
                                                        }
                                                        let _e1485 = phi_1297_;
                                                        let _e1508 = (_e1181 + 2u);
                                                        let _e1509 = (_e1508 < _e102);
                                                        if _e1509 {
                                                            if _e1509 {
                                                            } else {
                                                                phi_4590_ = true;
                                                                break;
                                                            }
                                                            let _e1511 = global_10.member[_e1508];
                                                            phi_1340_ = _e1511;
                                                        } else {
                                                            phi_1340_ = 0u;
                                                        }
                                                        let _e1513 = phi_1340_;
                                                        phi_1811_ = array<array<f32, 3>, 3>(array<f32, 3>((_e622.member.member.x + (f32(bitcast<i32>(((_e1451 >> bitcast<u32>(_e1453)) & 1023u))) * _e158)), (_e622.member.member.y + (f32(bitcast<i32>(((_e1451 >> bitcast<u32>(_e1462)) & 1023u))) * _e158)), (_e622.member.member.z + (f32(bitcast<i32>(((_e1451 >> bitcast<u32>(_e1471)) & 1023u))) * _e158))), array<f32, 3>((_e622.member.member.x + (f32(bitcast<i32>(((_e1485 >> bitcast<u32>(_e1453)) & 1023u))) * _e158)), (_e622.member.member.y + (f32(bitcast<i32>(((_e1485 >> bitcast<u32>(_e1462)) & 1023u))) * _e158)), (_e622.member.member.z + (f32(bitcast<i32>(((_e1485 >> bitcast<u32>(_e1471)) & 1023u))) * _e158))), array<f32, 3>((_e622.member.member.x + (f32(bitcast<i32>(((_e1513 >> bitcast<u32>(_e1453)) & 1023u))) * _e158)), (_e622.member.member.y + (f32(bitcast<i32>(((_e1513 >> bitcast<u32>(_e1462)) & 1023u))) * _e158)), (_e622.member.member.z + (f32(bitcast<i32>(((_e1513 >> bitcast<u32>(_e1471)) & 1023u))) * _e158))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1270 = (_e1181 < _e102);
                                                        if _e1270 {
                                                            if _e1270 {
                                                            } else {
                                                                phi_4590_ = true;
                                                                break;
                                                            }
                                                            let _e1272 = global_10.member[_e1181];
                                                            phi_1383_ = _e1272;
                                                        } else {
                                                            phi_1383_ = 0u;
                                                        }
                                                        let _e1274 = phi_1383_;
                                                        let _e1275 = (_e1181 + 1u);
                                                        let _e1276 = (_e1275 < _e102);
                                                        if _e1276 {
                                                            if _e1276 {
                                                            } else {
                                                                phi_4590_ = true;
                                                                break;
                                                            }
                                                            let _e1278 = global_10.member[_e1275];
                                                            phi_1398_ = _e1278;
                                                        } else {
                                                            phi_1398_ = 0u;
                                                        }
                                                        let _e1280 = phi_1398_;
                                                        let _e1281 = (_e361 == 1u);
                                                        if _e1281 {
                                                            phi_1408_ = ((_e1274 >> bitcast<u32>(21i)) | (_e1280 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1408_ = (_e1280 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1290 = phi_1408_;
                                                        let _e1297 = (_e360 == 1u);
                                                        if _e1297 {
                                                            phi_1428_ = ((_e1274 >> bitcast<u32>(21i)) | (_e1280 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1428_ = (_e1280 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1306 = phi_1428_;
                                                        let _e1313 = (_e362 == 1u);
                                                        if _e1313 {
                                                            phi_1448_ = ((_e1274 >> bitcast<u32>(21i)) | (_e1280 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1448_ = (_e1280 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1322 = phi_1448_;
                                                        let _e1330 = (_e1181 + 2u);
                                                        let _e1331 = (_e1330 < _e102);
                                                        if _e1331 {
                                                            if _e1331 {
                                                            } else {
                                                                phi_4590_ = true;
                                                                break;
                                                            }
                                                            let _e1333 = global_10.member[_e1330];
                                                            phi_1474_ = _e1333;
                                                        } else {
                                                            phi_1474_ = 0u;
                                                        }
                                                        let _e1335 = phi_1474_;
                                                        let _e1336 = (_e1181 + 3u);
                                                        let _e1337 = (_e1336 < _e102);
                                                        if _e1337 {
                                                            if _e1337 {
                                                            } else {
                                                                phi_4590_ = true;
                                                                break;
                                                            }
                                                            let _e1339 = global_10.member[_e1336];
                                                            phi_1489_ = _e1339;
                                                        } else {
                                                            phi_1489_ = 0u;
                                                        }
                                                        let _e1341 = phi_1489_;
                                                        if _e1281 {
                                                            phi_1499_ = ((_e1335 >> bitcast<u32>(21i)) | (_e1341 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1499_ = (_e1341 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1350 = phi_1499_;
                                                        if _e1297 {
                                                            phi_1519_ = ((_e1335 >> bitcast<u32>(21i)) | (_e1341 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1519_ = (_e1341 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1365 = phi_1519_;
                                                        if _e1313 {
                                                            phi_1539_ = ((_e1335 >> bitcast<u32>(21i)) | (_e1341 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1539_ = (_e1341 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1380 = phi_1539_;
                                                        let _e1388 = (_e1181 + 4u);
                                                        let _e1389 = (_e1388 < _e102);
                                                        if _e1389 {
                                                            if _e1389 {
                                                            } else {
                                                                phi_4590_ = true;
                                                                break;
                                                            }
                                                            let _e1391 = global_10.member[_e1388];
                                                            phi_1565_ = _e1391;
                                                        } else {
                                                            phi_1565_ = 0u;
                                                        }
                                                        let _e1393 = phi_1565_;
                                                        let _e1394 = (_e1181 + 5u);
                                                        let _e1395 = (_e1394 < _e102);
                                                        if _e1395 {
                                                            if _e1395 {
                                                            } else {
                                                                phi_4590_ = true;
                                                                break;
                                                            }
                                                            let _e1397 = global_10.member[_e1394];
                                                            phi_1580_ = _e1397;
                                                        } else {
                                                            phi_1580_ = 0u;
                                                        }
                                                        let _e1399 = phi_1580_;
                                                        if _e1281 {
                                                            phi_1590_ = ((_e1393 >> bitcast<u32>(21i)) | (_e1399 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1590_ = (_e1399 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1408 = phi_1590_;
                                                        if _e1297 {
                                                            phi_1610_ = ((_e1393 >> bitcast<u32>(21i)) | (_e1399 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1610_ = (_e1399 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1423 = phi_1610_;
                                                        if _e1313 {
                                                            phi_1630_ = ((_e1393 >> bitcast<u32>(21i)) | (_e1399 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1630_ = (_e1399 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1438 = phi_1630_;
                                                        phi_1811_ = array<array<f32, 3>, 3>(array<f32, 3>((_e622.member.member.x + (f32(bitcast<i32>((select(_e1290, _e1274, _e385) & 2097151u))) * _e158)), (_e622.member.member.y + (f32(bitcast<i32>((select(_e1306, _e1274, _e422) & 2097151u))) * _e158)), (_e622.member.member.z + (f32(bitcast<i32>((select(_e1322, _e1274, _e458) & 2097151u))) * _e158))), array<f32, 3>((_e622.member.member.x + (f32(bitcast<i32>((select(_e1350, _e1335, _e385) & 2097151u))) * _e158)), (_e622.member.member.y + (f32(bitcast<i32>((select(_e1365, _e1335, _e422) & 2097151u))) * _e158)), (_e622.member.member.z + (f32(bitcast<i32>((select(_e1380, _e1335, _e458) & 2097151u))) * _e158))), array<f32, 3>((_e622.member.member.x + (f32(bitcast<i32>((select(_e1408, _e1393, _e385) & 2097151u))) * _e158)), (_e622.member.member.y + (f32(bitcast<i32>((select(_e1423, _e1393, _e422) & 2097151u))) * _e158)), (_e622.member.member.z + (f32(bitcast<i32>((select(_e1438, _e1393, _e458) & 2097151u))) * _e158))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1183 = (_e1181 + _e361);
                                                        let _e1184 = (_e1183 < _e102);
                                                        if _e1184 {
                                                            if _e1184 {
                                                            } else {
                                                                phi_4590_ = true;
                                                                break;
                                                            }
                                                            let _e1186 = global_10.member[_e1183];
                                                            phi_1657_ = _e1186;
                                                        } else {
                                                            phi_1657_ = 0u;
                                                        }
                                                        let _e1188 = phi_1657_;
                                                        let _e1192 = (_e1181 + _e360);
                                                        let _e1193 = (_e1192 < _e102);
                                                        if _e1193 {
                                                            if _e1193 {
                                                            } else {
                                                                phi_4590_ = true;
                                                                break;
                                                            }
                                                            let _e1195 = global_10.member[_e1192];
                                                            phi_1675_ = _e1195;
                                                        } else {
                                                            phi_1675_ = 0u;
                                                        }
                                                        let _e1197 = phi_1675_;
                                                        let _e1201 = (_e1181 + _e362);
                                                        let _e1202 = (_e1201 < _e102);
                                                        if _e1202 {
                                                            if _e1202 {
                                                            } else {
                                                                phi_4590_ = true;
                                                                break;
                                                            }
                                                            let _e1204 = global_10.member[_e1201];
                                                            phi_1693_ = _e1204;
                                                        } else {
                                                            phi_1693_ = 0u;
                                                        }
                                                        let _e1206 = phi_1693_;
                                                        let _e1211 = (_e1181 + 3u);
                                                        let _e1212 = (_e1211 + _e361);
                                                        let _e1213 = (_e1212 < _e102);
                                                        if _e1213 {
                                                            if _e1213 {
                                                            } else {
                                                                phi_4590_ = true;
                                                                break;
                                                            }
                                                            let _e1215 = global_10.member[_e1212];
                                                            phi_1713_ = _e1215;
                                                        } else {
                                                            phi_1713_ = 0u;
                                                        }
                                                        let _e1217 = phi_1713_;
                                                        let _e1221 = (_e1211 + _e360);
                                                        let _e1222 = (_e1221 < _e102);
                                                        if _e1222 {
                                                            if _e1222 {
                                                            } else {
                                                                phi_4590_ = true;
                                                                break;
                                                            }
                                                            let _e1224 = global_10.member[_e1221];
                                                            phi_1731_ = _e1224;
                                                        } else {
                                                            phi_1731_ = 0u;
                                                        }
                                                        let _e1226 = phi_1731_;
                                                        let _e1230 = (_e1211 + _e362);
                                                        let _e1231 = (_e1230 < _e102);
                                                        if _e1231 {
                                                            if _e1231 {
                                                            } else {
                                                                phi_4590_ = true;
                                                                break;
                                                            }
                                                            let _e1233 = global_10.member[_e1230];
                                                            phi_1749_ = _e1233;
                                                        } else {
                                                            phi_1749_ = 0u;
                                                        }
                                                        let _e1235 = phi_1749_;
                                                        let _e1240 = (_e1181 + 6u);
                                                        let _e1241 = (_e1240 + _e361);
                                                        let _e1242 = (_e1241 < _e102);
                                                        if _e1242 {
                                                            if _e1242 {
                                                            } else {
                                                                phi_4590_ = true;
                                                                break;
                                                            }
                                                            let _e1244 = global_10.member[_e1241];
                                                            phi_1769_ = _e1244;
                                                        } else {
                                                            phi_1769_ = 0u;
                                                        }
                                                        let _e1246 = phi_1769_;
                                                        let _e1250 = (_e1240 + _e360);
                                                        let _e1251 = (_e1250 < _e102);
                                                        if _e1251 {
                                                            if _e1251 {
                                                            } else {
                                                                phi_4590_ = true;
                                                                break;
                                                            }
                                                            let _e1253 = global_10.member[_e1250];
                                                            phi_1787_ = _e1253;
                                                        } else {
                                                            phi_1787_ = 0u;
                                                        }
                                                        let _e1255 = phi_1787_;
                                                        let _e1259 = (_e1240 + _e362);
                                                        let _e1260 = (_e1259 < _e102);
                                                        if _e1260 {
                                                            if _e1260 {
                                                            } else {
                                                                phi_4590_ = true;
                                                                break;
                                                            }
                                                            let _e1262 = global_10.member[_e1259];
                                                            phi_1805_ = _e1262;
                                                        } else {
                                                            phi_1805_ = 0u;
                                                        }
                                                        let _e1264 = phi_1805_;
                                                        phi_1811_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1188)) * _e158), (f32(bitcast<i32>(_e1197)) * _e158), (f32(bitcast<i32>(_e1206)) * _e158)), array<f32, 3>((f32(bitcast<i32>(_e1217)) * _e158), (f32(bitcast<i32>(_e1226)) * _e158), (f32(bitcast<i32>(_e1235)) * _e158)), array<f32, 3>((f32(bitcast<i32>(_e1246)) * _e158), (f32(bitcast<i32>(_e1255)) * _e158), (f32(bitcast<i32>(_e1264)) * _e158)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1811_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1538 = phi_1811_;
                                                let _e1546 = (_e1538[0][2] - _e466);
                                                let _e1549 = (((_e1538[0][0] - _e393) * _e490) - (_e1546 * _e418));
                                                let _e1552 = (((_e1538[0][1] - _e430) * _e490) - (_e1546 * _e454));
                                                let _e1559 = (_e1538[1][2] - _e466);
                                                let _e1562 = (((_e1538[1][0] - _e393) * _e490) - (_e1559 * _e418));
                                                let _e1565 = (((_e1538[1][1] - _e430) * _e490) - (_e1559 * _e454));
                                                let _e1572 = (_e1538[2][2] - _e466);
                                                let _e1575 = (((_e1538[2][0] - _e393) * _e490) - (_e1572 * _e418));
                                                let _e1578 = (((_e1538[2][1] - _e430) * _e490) - (_e1572 * _e454));
                                                let _e1579 = (_e1575 * _e1565);
                                                let _e1580 = (_e1578 * _e1562);
                                                let _e1581 = (_e1549 * _e1578);
                                                let _e1582 = (_e1552 * _e1575);
                                                let _e1583 = (_e1562 * _e1552);
                                                let _e1584 = (_e1565 * _e1549);
                                                let _e1589 = (((_e1579 >= _e1580) && (_e1581 >= _e1582)) && (_e1583 >= _e1584));
                                                if (_e1589 || (((_e1579 <= _e1580) && (_e1581 <= _e1582)) && (_e1583 <= _e1584))) {
                                                    let _e1596 = select(-1f, 1f, _e1589);
                                                    let _e1598 = ((_e1579 - _e1580) * _e1596);
                                                    let _e1600 = select(0f, _e1598, (_e1598 > 0f));
                                                    let _e1602 = ((_e1581 - _e1582) * _e1596);
                                                    let _e1604 = select(0f, _e1602, (_e1602 > 0f));
                                                    let _e1606 = ((_e1583 - _e1584) * _e1596);
                                                    let _e1608 = select(0f, _e1606, (_e1606 > 0f));
                                                    let _e1610 = ((_e1600 + _e1604) + _e1608);
                                                    if (_e1610 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2639_ = type_21();
                                                        phi_2640_ = true;
                                                        phi_2641_ = false;
                                                    } else {
                                                        let _e1613 = select(_e1562, _e1549, (_e1549 < _e1562));
                                                        if (select(_e1575, _e1613, (_e1613 < _e1575)) > 0f) {
                                                            phi_1928_ = true;
                                                        } else {
                                                            let _e1618 = select(_e1562, _e1549, (_e1549 > _e1562));
                                                            phi_1928_ = (select(_e1575, _e1618, (_e1618 > _e1575)) < 0f);
                                                        }
                                                        let _e1623 = phi_1928_;
                                                        if _e1623 {
                                                            phi_2636_ = type_21();
                                                            phi_2637_ = true;
                                                            phi_2638_ = false;
                                                        } else {
                                                            let _e1625 = select(_e1565, _e1552, (_e1552 < _e1565));
                                                            if (select(_e1578, _e1625, (_e1625 < _e1578)) > 0f) {
                                                                phi_1957_ = true;
                                                            } else {
                                                                let _e1630 = select(_e1565, _e1552, (_e1552 > _e1565));
                                                                phi_1957_ = (select(_e1578, _e1630, (_e1630 > _e1578)) < 0f);
                                                            }
                                                            let _e1635 = phi_1957_;
                                                            if _e1635 {
                                                                phi_2634_ = type_21();
                                                                phi_2635_ = false;
                                                            } else {
                                                                let _e1637 = select(_e1538[1][0], _e1538[0][0], (_e1538[0][0] < _e1538[1][0]));
                                                                let _e1641 = select(_e1538[1][0], _e1538[0][0], (_e1538[0][0] > _e1538[1][0]));
                                                                let _e1645 = select(_e1538[1][1], _e1538[0][1], (_e1538[0][1] < _e1538[1][1]));
                                                                let _e1649 = select(_e1538[1][1], _e1538[0][1], (_e1538[0][1] > _e1538[1][1]));
                                                                let _e1653 = select(_e1538[1][2], _e1538[0][2], (_e1538[0][2] < _e1538[1][2]));
                                                                let _e1657 = select(_e1538[1][2], _e1538[0][2], (_e1538[0][2] > _e1538[1][2]));
                                                                let _e1662 = ((select(_e1538[2][0], _e1637, (_e1637 < _e1538[2][0])) - _e416) * _e421);
                                                                let _e1663 = ((select(_e1538[2][0], _e1641, (_e1641 > _e1538[2][0])) - _e417) * _e421);
                                                                let _e1666 = ((select(_e1538[2][1], _e1645, (_e1645 < _e1538[2][1])) - _e452) * _e457);
                                                                let _e1667 = ((select(_e1538[2][1], _e1649, (_e1649 > _e1538[2][1])) - _e453) * _e457);
                                                                let _e1670 = ((select(_e1538[2][2], _e1653, (_e1653 < _e1538[2][2])) - _e488) * _e493);
                                                                let _e1671 = ((select(_e1538[2][2], _e1657, (_e1657 > _e1538[2][2])) - _e489) * _e493);
                                                                let _e1673 = select(_e1671, _e1670, (_e1670 < _e1671));
                                                                let _e1675 = select(_e1671, _e1670, (_e1670 > _e1671));
                                                                let _e1677 = select(_e1663, _e1662, (_e1662 < _e1663));
                                                                let _e1679 = select(_e1667, _e1666, (_e1666 < _e1667));
                                                                let _e1681 = select(_e1679, _e1677, (_e1677 > _e1679));
                                                                let _e1683 = select(_e1673, _e1681, (_e1681 > _e1673));
                                                                let _e1685 = select(_e1663, _e1662, (_e1662 > _e1663));
                                                                let _e1687 = select(_e1667, _e1666, (_e1666 > _e1667));
                                                                let _e1689 = select(_e1687, _e1685, (_e1685 < _e1687));
                                                                let _e1691 = select(_e1675, _e1689, (_e1689 < _e1675));
                                                                let _e1692 = -(_e1673);
                                                                let _e1698 = select(_e539, _e1683, (_e1683 > _e539));
                                                                if (_e1698 > (_e1691 + (select(_e1692, _e1675, (_e1675 > _e1692)) * 0.0000019073523f))) {
                                                                    phi_2629_ = type_21();
                                                                    phi_2630_ = true;
                                                                } else {
                                                                    let _e1700 = (_e1698 > _e1109.member_1);
                                                                    if _e1700 {
                                                                        phi_2628_ = type_21();
                                                                    } else {
                                                                        let _e1701 = vec3<f32>(_e1538[0][0], _e1538[0][1], _e1538[0][2]);
                                                                        let _e1702 = vec3<f32>(_e1538[1][0], _e1538[1][1], _e1538[1][2]);
                                                                        let _e1703 = vec3<f32>(_e1538[2][0], _e1538[2][1], _e1538[2][2]);
                                                                        let _e1704 = (_e1538[1][0] - _e1538[0][0]);
                                                                        let _e1705 = (_e1538[1][1] - _e1538[0][1]);
                                                                        let _e1706 = (_e1538[1][2] - _e1538[0][2]);
                                                                        let _e1707 = vec3<f32>(_e1704, _e1705, _e1706);
                                                                        let _e1708 = (_e1538[2][0] - _e1538[1][0]);
                                                                        let _e1709 = (_e1538[2][1] - _e1538[1][1]);
                                                                        let _e1710 = (_e1538[2][2] - _e1538[1][2]);
                                                                        let _e1711 = vec3<f32>(_e1708, _e1709, _e1710);
                                                                        let _e1712 = (_e1538[0][0] - _e1538[2][0]);
                                                                        let _e1713 = (_e1538[0][1] - _e1538[2][1]);
                                                                        let _e1714 = (_e1538[0][2] - _e1538[2][2]);
                                                                        let _e1715 = vec3<f32>(_e1712, _e1713, _e1714);
                                                                        let _e1718 = bitcast<f32>((bitcast<u32>(_e1704) & 2147483647u));
                                                                        let _e1721 = bitcast<f32>((bitcast<u32>(_e1705) & 2147483647u));
                                                                        let _e1723 = select(_e1721, _e1718, (_e1718 > _e1721));
                                                                        let _e1726 = bitcast<f32>((bitcast<u32>(_e1706) & 2147483647u));
                                                                        let _e1728 = select(_e1726, _e1723, (_e1723 > _e1726));
                                                                        let _e1731 = bitcast<f32>((bitcast<u32>(_e1708) & 2147483647u));
                                                                        let _e1734 = bitcast<f32>((bitcast<u32>(_e1709) & 2147483647u));
                                                                        let _e1736 = select(_e1734, _e1731, (_e1731 > _e1734));
                                                                        let _e1739 = bitcast<f32>((bitcast<u32>(_e1710) & 2147483647u));
                                                                        let _e1741 = select(_e1739, _e1736, (_e1736 > _e1739));
                                                                        let _e1744 = bitcast<f32>((bitcast<u32>(_e1712) & 2147483647u));
                                                                        let _e1747 = bitcast<f32>((bitcast<u32>(_e1713) & 2147483647u));
                                                                        let _e1749 = select(_e1747, _e1744, (_e1744 > _e1747));
                                                                        let _e1752 = bitcast<f32>((bitcast<u32>(_e1714) & 2147483647u));
                                                                        let _e1754 = select(_e1752, _e1749, (_e1749 > _e1752));
                                                                        let _e1756 = select(_e1741, _e1728, (_e1728 > _e1741));
                                                                        let _e1758 = select(_e1754, _e1756, (_e1756 > _e1754));
                                                                        if (_e1728 == _e1758) {
                                                                            phi_2358_ = _e1565;
                                                                            phi_2359_ = _e1562;
                                                                            phi_2360_ = _e1552;
                                                                            phi_2361_ = _e1549;
                                                                            phi_2362_ = _e1701;
                                                                            phi_2363_ = _e1715;
                                                                            phi_2364_ = _e1711;
                                                                            phi_2365_ = _e1707;
                                                                        } else {
                                                                            let _e1760 = (_e1741 == _e1758);
                                                                            let _e1765 = vec3(_e1760);
                                                                            phi_2358_ = select(_e1552, _e1578, _e1760);
                                                                            phi_2359_ = select(_e1549, _e1575, _e1760);
                                                                            phi_2360_ = select(_e1578, _e1565, _e1760);
                                                                            phi_2361_ = select(_e1575, _e1562, _e1760);
                                                                            phi_2362_ = select(_e1703, _e1702, _e1765);
                                                                            phi_2363_ = select(_e1711, _e1707, _e1765);
                                                                            phi_2364_ = select(_e1707, _e1715, _e1765);
                                                                            phi_2365_ = select(_e1715, _e1711, _e1765);
                                                                        }
                                                                        let _e1771 = phi_2358_;
                                                                        let _e1773 = phi_2359_;
                                                                        let _e1775 = phi_2360_;
                                                                        let _e1777 = phi_2361_;
                                                                        let _e1779 = phi_2362_;
                                                                        let _e1781 = phi_2363_;
                                                                        let _e1783 = phi_2364_;
                                                                        let _e1785 = phi_2365_;
                                                                        let _e1792 = ((_e1783.y * _e1781.z) - (_e1781.y * _e1783.z));
                                                                        let _e1797 = ((_e1783.z * _e1781.x) - (_e1781.z * _e1783.x));
                                                                        let _e1800 = ((_e1783.x * _e1781.y) - (_e1781.x * _e1783.y));
                                                                        if (_e1600 >= _e1604) {
                                                                            phi_2396_ = select(true, false, (_e1600 >= _e1608));
                                                                        } else {
                                                                            phi_2396_ = true;
                                                                        }
                                                                        let _e1805 = phi_2396_;
                                                                        if _e1805 {
                                                                            phi_2405_ = select(_e1703, _e1702, vec3((_e1604 >= _e1608)));
                                                                        } else {
                                                                            phi_2405_ = _e1701;
                                                                        }
                                                                        let _e1810 = phi_2405_;
                                                                        let _e1815 = (((_e1792 * _e418) + (_e1797 * _e454)) + (_e1800 * _e490));
                                                                        let _e1826 = (((_e1792 * (_e1810.x - _e393)) + (_e1797 * (_e1810.y - _e430))) + (_e1800 * (_e1810.z - _e466)));
                                                                        let _e1828 = (_e1773 - _e1777);
                                                                        let _e1829 = (_e1771 - _e1775);
                                                                        let _e1837 = (-(((_e1777 * _e1828) + (_e1775 * _e1829))) / ((_e1828 * _e1828) + (_e1829 * _e1829)));
                                                                        let _e1839 = select(1f, _e1837, (_e1837 < 1f));
                                                                        let _e1841 = select(0f, _e1839, (_e1839 > 0f));
                                                                        let _e1854 = ((_e1779.x + (_e1785.x * _e1841)) - _e393);
                                                                        let _e1855 = ((_e1779.y + (_e1785.y * _e1841)) - _e430);
                                                                        let _e1856 = ((_e1779.z + (_e1785.z * _e1841)) - _e466);
                                                                        let _e1857 = (_e1856 / _e490);
                                                                        let _e1869 = bitcast<f32>((bitcast<u32>(_e1854) & 2147483647u));
                                                                        let _e1872 = bitcast<f32>((bitcast<u32>(_e1855) & 2147483647u));
                                                                        let _e1874 = select(_e1872, _e1869, (_e1869 > _e1872));
                                                                        let _e1877 = bitcast<f32>((bitcast<u32>(_e1856) & 2147483647u));
                                                                        let _e1879 = select(_e1877, _e1874, (_e1874 > _e1877));
                                                                        let _e1885 = bitcast<f32>((bitcast<u32>(_e1792) & 2147483647u));
                                                                        let _e1888 = bitcast<f32>((bitcast<u32>(_e1797) & 2147483647u));
                                                                        let _e1890 = select(_e1888, _e1885, (_e1885 > _e1888));
                                                                        let _e1893 = bitcast<f32>((bitcast<u32>(_e1800) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1792 * _e1854) + (_e1797 * _e1855)) + (_e1800 * _e1856)) - _e1826)) & 2147483647u)) <= ((0.0000009536743f * select(_e1758, _e1879, (_e1879 > _e1758))) * select(_e1893, _e1890, (_e1890 > _e1893)))) {
                                                                            let _e1903 = bitcast<f32>((bitcast<u32>(_e1783.x) & 2147483647u));
                                                                            let _e1906 = bitcast<f32>((bitcast<u32>(_e1783.y) & 2147483647u));
                                                                            let _e1908 = select(_e1906, _e1903, (_e1903 > _e1906));
                                                                            let _e1911 = bitcast<f32>((bitcast<u32>(_e1783.z) & 2147483647u));
                                                                            let _e1917 = bitcast<f32>((bitcast<u32>(_e1781.x) & 2147483647u));
                                                                            let _e1920 = bitcast<f32>((bitcast<u32>(_e1781.y) & 2147483647u));
                                                                            let _e1922 = select(_e1920, _e1917, (_e1917 > _e1920));
                                                                            let _e1925 = bitcast<f32>((bitcast<u32>(_e1781.z) & 2147483647u));
                                                                            phi_2572_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e1815) & 2147483647u)) > ((0.0000038146973f * select(_e1911, _e1908, (_e1908 > _e1911))) * select(_e1925, _e1922, (_e1922 > _e1925)))));
                                                                        } else {
                                                                            phi_2572_ = true;
                                                                        }
                                                                        let _e1932 = phi_2572_;
                                                                        if _e1932 {
                                                                            let _e1943 = ((((_e1792 * (_e1854 - (_e418 * _e1857))) + (_e1797 * (_e1855 - (_e454 * _e1857)))) + (_e1800 * (_e1856 - _e1856))) / _e1815);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1943) & 2147483647u)) <= _e1758) {
                                                                                phi_2596_ = (_e1857 + _e1943);
                                                                            } else {
                                                                                phi_2596_ = _e1857;
                                                                            }
                                                                            let _e1950 = phi_2596_;
                                                                            phi_2597_ = _e1950;
                                                                        } else {
                                                                            phi_2597_ = (_e1826 / _e1815);
                                                                        }
                                                                        let _e1952 = phi_2597_;
                                                                        let _e1954 = select(_e1691, _e1952, (_e1952 < _e1691));
                                                                        let _e1956 = select(_e1683, _e1954, (_e1954 > _e1683));
                                                                        if (_e1956 >= _e539) {
                                                                            let _e1958 = (_e1956 <= _e1109.member_1);
                                                                            if _e1958 {
                                                                                let _e1959 = (1f / _e1610);
                                                                                phi_2620_ = type_21(_e1956, (_e1604 * _e1959), (_e1608 * _e1959), _e1169);
                                                                            } else {
                                                                                phi_2620_ = type_21();
                                                                            }
                                                                            let _e1964 = phi_2620_;
                                                                            phi_2622_ = _e1964;
                                                                            phi_2623_ = select(true, false, _e1958);
                                                                        } else {
                                                                            phi_2622_ = type_21();
                                                                            phi_2623_ = true;
                                                                        }
                                                                        let _e1967 = phi_2622_;
                                                                        let _e1969 = phi_2623_;
                                                                        if _e1969 {
                                                                            phi_2627_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2627_ = _e1967;
                                                                        }
                                                                        let _e1971 = phi_2627_;
                                                                        phi_2628_ = _e1971;
                                                                    }
                                                                    let _e1973 = phi_2628_;
                                                                    phi_2629_ = _e1973;
                                                                    phi_2630_ = _e1700;
                                                                }
                                                                let _e1975 = phi_2629_;
                                                                let _e1977 = phi_2630_;
                                                                phi_2634_ = _e1975;
                                                                phi_2635_ = _e1977;
                                                            }
                                                            let _e1979 = phi_2634_;
                                                            let _e1981 = phi_2635_;
                                                            phi_2636_ = _e1979;
                                                            phi_2637_ = _e1635;
                                                            phi_2638_ = _e1981;
                                                        }
                                                        let _e1983 = phi_2636_;
                                                        let _e1985 = phi_2637_;
                                                        let _e1987 = phi_2638_;
                                                        phi_2639_ = _e1983;
                                                        phi_2640_ = _e1985;
                                                        phi_2641_ = _e1987;
                                                    }
                                                    let _e1989 = phi_2639_;
                                                    let _e1991 = phi_2640_;
                                                    let _e1993 = phi_2641_;
                                                    phi_2649_ = _e1989;
                                                    phi_2650_ = select(_e1993, true, _e1991);
                                                } else {
                                                    phi_2649_ = type_21();
                                                    phi_2650_ = true;
                                                }
                                                let _e1996 = phi_2649_;
                                                let _e1998 = phi_2650_;
                                                if _e1998 {
                                                    phi_2654_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2654_ = _e1996;
                                                }
                                                let _e2000 = phi_2654_;
                                                if (_e2000.member_3 != 4294967295u) {
                                                    if (_e1169 == _e167) {
                                                        phi_2983_ = false;
                                                    } else {
                                                        let _e2004 = (_e1169 < arrayLength((&global_4.member)));
                                                        if _e2004 {
                                                            if _e2004 {
                                                            } else {
                                                                phi_4590_ = true;
                                                                break;
                                                            }
                                                            let _e2006 = global_4.member[_e1169];
                                                            phi_2677_ = _e2006;
                                                        } else {
                                                            phi_2677_ = 4294967295u;
                                                        }
                                                        let _e2008 = phi_2677_;
                                                        let _e2009 = (_e2008 < arrayLength((&global_5.member)));
                                                        if _e2009 {
                                                            if _e2009 {
                                                            } else {
                                                                phi_4590_ = true;
                                                                break;
                                                            }
                                                            let _e2011 = global_5.member[_e2008];
                                                            phi_2691_ = _e2011;
                                                        } else {
                                                            phi_2691_ = 0i;
                                                        }
                                                        let _e2013 = phi_2691_;
                                                        let _e2014 = (_e2013 == 0i);
                                                        if _e2014 {
                                                            phi_2982_ = true;
                                                        } else {
                                                            if _e385 {
                                                                phi_2712_ = vec3<f32>(_e1538[0][0], _e1538[0][1], _e1538[0][2]);
                                                            } else {
                                                                if (_e361 == 1u) {
                                                                    phi_2711_ = vec3<f32>(_e1538[0][2], _e1538[0][0], _e1538[0][1]);
                                                                } else {
                                                                    phi_2711_ = vec3<f32>(_e1538[0][1], _e1538[0][2], _e1538[0][0]);
                                                                }
                                                                let _e2019 = phi_2711_;
                                                                phi_2712_ = _e2019;
                                                            }
                                                            let _e2022 = phi_2712_;
                                                            if _e385 {
                                                                phi_2729_ = vec3<f32>(_e1538[1][0], _e1538[1][1], _e1538[1][2]);
                                                            } else {
                                                                if (_e361 == 1u) {
                                                                    phi_2728_ = vec3<f32>(_e1538[1][2], _e1538[1][0], _e1538[1][1]);
                                                                } else {
                                                                    phi_2728_ = vec3<f32>(_e1538[1][1], _e1538[1][2], _e1538[1][0]);
                                                                }
                                                                let _e2027 = phi_2728_;
                                                                phi_2729_ = _e2027;
                                                            }
                                                            let _e2030 = phi_2729_;
                                                            if _e385 {
                                                                phi_2746_ = vec3<f32>(_e1538[2][0], _e1538[2][1], _e1538[2][2]);
                                                            } else {
                                                                if (_e361 == 1u) {
                                                                    phi_2745_ = vec3<f32>(_e1538[2][2], _e1538[2][0], _e1538[2][1]);
                                                                } else {
                                                                    phi_2745_ = vec3<f32>(_e1538[2][1], _e1538[2][2], _e1538[2][0]);
                                                                }
                                                                let _e2035 = phi_2745_;
                                                                phi_2746_ = _e2035;
                                                            }
                                                            let _e2038 = phi_2746_;
                                                            let _e2041 = (_e2030.x - _e2022.x);
                                                            let _e2044 = (_e2030.y - _e2022.y);
                                                            let _e2047 = (_e2030.z - _e2022.z);
                                                            let _e2049 = (_e2038.x - _e2022.x);
                                                            let _e2051 = (_e2038.y - _e2022.y);
                                                            let _e2053 = (_e2038.z - _e2022.z);
                                                            if (_e239.member_1 == 1u) {
                                                                phi_2782_ = (vec3<f32>(_e239.member[0], _e239.member[1], _e239.member[2]) - _e2022);
                                                            } else {
                                                                phi_2782_ = vec3<f32>(_e239.member[0], _e239.member[1], _e239.member[2]);
                                                            }
                                                            let _e2068 = phi_2782_;
                                                            let _e2074 = bitcast<f32>((bitcast<u32>((_e2041 * _e2051)) ^ _e239.member_3[0]));
                                                            let _e2078 = bitcast<f32>((bitcast<u32>((_e2044 * _e2049)) ^ _e239.member_3[0]));
                                                            let _e2082 = bitcast<f32>((bitcast<u32>((_e2044 * _e2053)) ^ _e239.member_3[0]));
                                                            let _e2086 = bitcast<f32>((bitcast<u32>((_e2047 * _e2051)) ^ _e239.member_3[0]));
                                                            let _e2090 = bitcast<f32>((bitcast<u32>((_e2047 * _e2049)) ^ _e239.member_3[0]));
                                                            let _e2094 = bitcast<f32>((bitcast<u32>((_e2041 * _e2053)) ^ _e239.member_3[0]));
                                                            let _e2095 = (_e2082 - _e2086);
                                                            let _e2096 = (_e2090 - _e2094);
                                                            let _e2097 = (_e2074 - _e2078);
                                                            let _e2121 = (bitcast<f32>((bitcast<u32>(_e2082) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2086) & 2147483647u)));
                                                            let _e2128 = (bitcast<f32>((bitcast<u32>(_e2090) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2094) & 2147483647u)));
                                                            let _e2135 = (bitcast<f32>((bitcast<u32>(_e2074) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2078) & 2147483647u)));
                                                            if (_e239.member_2 == 0f) {
                                                                phi_2964_ = 0f;
                                                            } else {
                                                                let _e2165 = bitcast<f32>((bitcast<u32>(_e2095) & 2147483647u));
                                                                let _e2168 = bitcast<f32>((bitcast<u32>(_e2096) & 2147483647u));
                                                                let _e2171 = bitcast<f32>((bitcast<u32>(_e2097) & 2147483647u));
                                                                let _e2173 = select(_e2171, _e2168, (_e2168 > _e2171));
                                                                let _e2177 = select(_e2171, _e2168, (_e2168 < _e2171));
                                                                let _e2181 = select(_e2168, _e2165, (_e2165 < _e2168));
                                                                let _e2183 = select(_e2168, _e2165, (_e2165 > _e2168));
                                                                let _e2185 = select(_e2171, _e2183, (_e2183 < _e2171));
                                                                phi_2964_ = bitcast<f32>((bitcast<u32>((_e239.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e2173, _e2165, (_e2165 > _e2173)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e2185, _e2181, (_e2181 > _e2185)))) ^ _e239.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e2177, _e2165, (_e2165 < _e2177)))) ^ _e239.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e2121 + _e2128) + _e2135))) ^ _e239.member_3[0]))) * 1.0000005f)) ^ _e239.member_3[0])))) ^ _e239.member_3[0]));
                                                            }
                                                            let _e2212 = phi_2964_;
                                                            phi_2982_ = (_e2014 || !(((((bitcast<f32>((bitcast<u32>((_e2068.x * _e2095)) ^ _e239.member_3[0])) + bitcast<f32>((bitcast<u32>((_e2068.y * _e2096)) ^ _e239.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e2068.z * _e2097)) ^ _e239.member_3[0]))) * f32(-(_e2013))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2068.x) & 2147483647u)) * _e2121)) ^ _e239.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2068.y) & 2147483647u)) * _e2128)) ^ _e239.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2068.z) & 2147483647u)) * _e2135)) ^ _e239.member_3[0]))))) ^ _e239.member_3[0])) + _e2212) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e2226 = phi_2982_;
                                                        phi_2983_ = _e2226;
                                                    }
                                                    let _e2228 = phi_2983_;
                                                    if _e2228 {
                                                        if (_e2000.member < _e1109.member.member) {
                                                            phi_3003_ = true;
                                                        } else {
                                                            if (_e2000.member == _e1109.member.member) {
                                                                phi_3002_ = (_e2000.member_3 < _e1109.member.member_3);
                                                            } else {
                                                                phi_3002_ = false;
                                                            }
                                                            let _e2238 = phi_3002_;
                                                            phi_3003_ = _e2238;
                                                        }
                                                        let _e2240 = phi_3003_;
                                                        if _e2240 {
                                                            phi_3009_ = type_38(_e2000, _e2000.member);
                                                        } else {
                                                            phi_3009_ = _e1109;
                                                        }
                                                        let _e2243 = phi_3009_;
                                                        phi_3010_ = _e2243;
                                                    } else {
                                                        phi_3010_ = _e1109;
                                                    }
                                                    let _e2245 = phi_3010_;
                                                    phi_3011_ = _e2245;
                                                } else {
                                                    phi_3011_ = _e1109;
                                                }
                                                let _e2247 = phi_3011_;
                                                phi_1093_ = _e2247;
                                            } else {
                                                phi_1093_ = type_38();
                                            }
                                            let _e2249 = phi_1093_;
                                            continue;
                                            continuing {
                                                phi_1092_ = _e2249;
                                                phi_1095_ = _e1124;
                                                phi_4590_ = _e581;
                                                break if !(_e1130);
                                            }
                                        }
                                        let _e2252 = phi_4590_;
                                        phi_4803_ = _e2252;
                                        if _e2252 {
                                            break;
                                        }
                                        phi_4807_ = _e2252;
                                        let _e2518 = local_11;
                                        phi_4251_ = _e2518;
                                        phi_4252_ = _e622;
                                        phi_4253_ = false;
                                        phi_4254_ = _e626;
                                    } else {
                                        if (_e622.member_1 >= _e99) {
                                            phi_3807_ = type_58(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_57(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_57(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e622.member_1 < _e99) {
                                            } else {
                                                phi_4803_ = true;
                                                break;
                                            }
                                            let _e638 = (_e361 * 2u);
                                            let _e640 = ((1u + _e638) % 7u);
                                            if (_e640 < 7u) {
                                            } else {
                                                phi_4803_ = true;
                                                break;
                                            }
                                            let _e645 = global_9.member[_e622.member_1][_e640];
                                            let _e647 = ((_e638 + 2u) % 7u);
                                            if (_e647 < 7u) {
                                            } else {
                                                phi_4803_ = true;
                                                break;
                                            }
                                            let _e652 = global_9.member[_e622.member_1][_e647];
                                            let _e653 = (_e360 * 2u);
                                            let _e655 = ((1u + _e653) % 7u);
                                            if (_e655 < 7u) {
                                            } else {
                                                phi_4803_ = true;
                                                break;
                                            }
                                            let _e660 = global_9.member[_e622.member_1][_e655];
                                            let _e662 = ((_e653 + 2u) % 7u);
                                            if (_e662 < 7u) {
                                            } else {
                                                phi_4803_ = true;
                                                break;
                                            }
                                            let _e667 = global_9.member[_e622.member_1][_e662];
                                            let _e668 = (_e362 * 2u);
                                            let _e670 = ((1u + _e668) % 7u);
                                            if (_e670 < 7u) {
                                            } else {
                                                phi_4803_ = true;
                                                break;
                                            }
                                            let _e675 = global_9.member[_e622.member_1][_e670];
                                            let _e677 = ((_e668 + 2u) % 7u);
                                            if (_e677 < 7u) {
                                            } else {
                                                phi_4803_ = true;
                                                break;
                                            }
                                            let _e682 = global_9.member[_e622.member_1][_e677];
                                            let _e705 = (bitcast<f32>((bitcast<u32>((_e622.member.member_1.x - _e622.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e706 = (bitcast<f32>((bitcast<u32>((_e622.member.member_1.y - _e622.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e707 = (bitcast<f32>((bitcast<u32>((_e622.member.member_1.z - _e622.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e709 = select(_e158, _e705, (_e705 > _e158));
                                            let _e711 = select(_e158, _e706, (_e706 > _e158));
                                            let _e713 = select(_e158, _e707, (_e707 > _e158));
                                            let _e738 = bitcast<u32>((f32(bitcast<i32>((_e645 & 2097151u))) * _e709));
                                            let _e743 = (bitcast<i32>((_e645 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e746 = bitcast<f32>((_e738 & bitcast<u32>(_e743)));
                                            let _e747 = bitcast<u32>((f32(bitcast<i32>((_e660 & 2097151u))) * _e711));
                                            let _e752 = (bitcast<i32>((_e660 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e755 = bitcast<f32>((_e747 & bitcast<u32>(_e752)));
                                            let _e756 = bitcast<u32>((f32(bitcast<i32>((_e675 & 2097151u))) * _e713));
                                            let _e761 = (bitcast<i32>((_e675 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e764 = bitcast<f32>((_e756 & bitcast<u32>(_e761)));
                                            let _e768 = bitcast<f32>((_e738 & bitcast<u32>(~(_e743))));
                                            let _e772 = bitcast<f32>((_e747 & bitcast<u32>(~(_e752))));
                                            let _e776 = bitcast<f32>((_e756 & bitcast<u32>(~(_e761))));
                                            let _e777 = bitcast<u32>((f32(bitcast<i32>((_e652 & 2097151u))) * _e709));
                                            let _e782 = (bitcast<i32>((_e652 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e785 = bitcast<f32>((_e777 & bitcast<u32>(_e782)));
                                            let _e786 = bitcast<u32>((f32(bitcast<i32>((_e667 & 2097151u))) * _e711));
                                            let _e791 = (bitcast<i32>((_e667 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e794 = bitcast<f32>((_e786 & bitcast<u32>(_e791)));
                                            let _e795 = bitcast<u32>((f32(bitcast<i32>((_e682 & 2097151u))) * _e713));
                                            let _e800 = (bitcast<i32>((_e682 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e803 = bitcast<f32>((_e795 & bitcast<u32>(_e800)));
                                            let _e807 = bitcast<f32>((_e777 & bitcast<u32>(~(_e782))));
                                            let _e811 = bitcast<f32>((_e786 & bitcast<u32>(~(_e791))));
                                            let _e815 = bitcast<f32>((_e795 & bitcast<u32>(~(_e800))));
                                            let _e816 = (_e622.member.member.x + _e746);
                                            let _e817 = (_e622.member.member.y + _e755);
                                            let _e818 = (_e622.member.member.z + _e764);
                                            let _e821 = (_e622.member.member_1.x - _e785);
                                            let _e822 = (_e622.member.member_1.y - _e794);
                                            let _e823 = (_e622.member.member_1.z - _e803);
                                            let _e842 = (_e821 - _e816);
                                            let _e843 = (_e822 - _e817);
                                            let _e844 = (_e823 - _e818);
                                            let _e846 = select(_e843, _e842, (_e842 > _e843));
                                            let _e848 = select(_e844, _e846, (_e846 > _e844));
                                            if (_e848 < (1024f * _e158)) {
                                                phi_3508_ = 0u;
                                            } else {
                                                phi_3508_ = select(2u, 1u, (_e848 < (2097152f * _e158)));
                                            }
                                            let _e855 = phi_3508_;
                                            switch bitcast<i32>(_e855) {
                                                case 0: {
                                                    phi_3514_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3514_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3514_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3514_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e858 = phi_3514_;
                                            let _e864 = global_9.member[_e622.member_1][0u];
                                            let _e868 = global_9.member[_e622.member_1][2u];
                                            let _e872 = global_9.member[_e622.member_1][4u];
                                            let _e876 = global_9.member[_e622.member_1][6u];
                                            let _e888 = (((_e868 >> bitcast<u32>(22i)) | ((_e872 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e876 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e889 = (_e864 & 268435455u);
                                            let _e890 = (_e888 & 268435455u);
                                            let _e893 = ((_e864 >> bitcast<u32>(28u)) & 7u);
                                            let _e901 = ((_e864 >> bitcast<u32>(31i)) | (((_e888 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e902 = (_e893 != 0u);
                                            if (_e893 == 0u) {
                                                phi_3769_ = _e889;
                                            } else {
                                                if (_e893 == 7u) {
                                                    phi_3768_ = 2147483648u;
                                                } else {
                                                    phi_3768_ = ((2147483648u | (_e893 << bitcast<u32>(28u))) | (_e890 & 268435455u));
                                                }
                                                let _e911 = phi_3768_;
                                                phi_3769_ = _e911;
                                            }
                                            let _e913 = phi_3769_;
                                            if _e902 {
                                                let _e914 = (_e893 != 7u);
                                                if _e914 {
                                                    phi_3779_ = (_e890 + (_e893 * ((3u * _e858) + 1u)));
                                                } else {
                                                    phi_3779_ = u32();
                                                }
                                                let _e918 = phi_3779_;
                                                phi_3781_ = _e918;
                                                phi_3782_ = select(true, false, _e914);
                                            } else {
                                                phi_3781_ = u32();
                                                phi_3782_ = true;
                                            }
                                            let _e921 = phi_3781_;
                                            let _e923 = phi_3782_;
                                            if (_e901 == 0u) {
                                                phi_3803_ = (_e889 + select(0u, 1u, !(_e902)));
                                            } else {
                                                if (_e901 == 7u) {
                                                    phi_3802_ = 2147483648u;
                                                } else {
                                                    phi_3802_ = ((2147483648u | (_e901 << bitcast<u32>(28u))) | (select(_e921, _e890, _e923) & 268435455u));
                                                }
                                                let _e936 = phi_3802_;
                                                phi_3803_ = _e936;
                                            }
                                            let _e938 = phi_3803_;
                                            phi_3807_ = type_58(array<vec4<f32>, 3>(vec4<f32>(_e816, (_e622.member.member.x + _e768), _e821, (_e622.member.member_1.x - _e807)), vec4<f32>(_e817, (_e622.member.member.y + _e772), _e822, (_e622.member.member_1.y - _e811)), vec4<f32>(_e818, (_e622.member.member.z + _e776), _e823, (_e622.member.member_1.z - _e815))), type_57(type_33((_e622.member.member + vec4<f32>(_e746, _e755, _e764, 0f)), (_e622.member.member_1 - vec4<f32>(_e785, _e794, _e803, 0f))), _e913), type_57(type_33((_e622.member.member + vec4<f32>(_e768, _e772, _e776, 0f)), (_e622.member.member_1 - vec4<f32>(_e807, _e811, _e815, 0f))), _e938));
                                        }
                                        let _e943 = phi_3807_;
                                        let _e955 = ((_e943.member[0].x - _e416) * _e421);
                                        let _e956 = ((_e943.member[0].y - _e416) * _e421);
                                        let _e957 = ((_e943.member[0].z - _e417) * _e421);
                                        let _e958 = ((_e943.member[0].w - _e417) * _e421);
                                        let _e968 = ((_e943.member[1].x - _e452) * _e457);
                                        let _e969 = ((_e943.member[1].y - _e452) * _e457);
                                        let _e970 = ((_e943.member[1].z - _e453) * _e457);
                                        let _e971 = ((_e943.member[1].w - _e453) * _e457);
                                        let _e981 = ((_e943.member[2].x - _e488) * _e493);
                                        let _e982 = ((_e943.member[2].y - _e488) * _e493);
                                        let _e983 = ((_e943.member[2].z - _e489) * _e493);
                                        let _e984 = ((_e943.member[2].w - _e489) * _e493);
                                        let _e986 = select(_e983, _e981, (_e981 < _e983));
                                        let _e988 = select(_e984, _e982, (_e982 < _e984));
                                        let _e990 = select(_e983, _e981, (_e981 > _e983));
                                        let _e992 = select(_e984, _e982, (_e982 > _e984));
                                        let _e994 = select(_e957, _e955, (_e955 < _e957));
                                        let _e996 = select(_e958, _e956, (_e956 < _e958));
                                        let _e998 = select(_e970, _e968, (_e968 < _e970));
                                        let _e1000 = select(_e971, _e969, (_e969 < _e971));
                                        let _e1002 = select(_e998, _e994, (_e994 > _e998));
                                        let _e1004 = select(_e1000, _e996, (_e996 > _e1000));
                                        let _e1006 = select(_e986, _e1002, (_e1002 > _e986));
                                        let _e1008 = select(_e988, _e1004, (_e1004 > _e988));
                                        let _e1010 = select(_e957, _e955, (_e955 > _e957));
                                        let _e1012 = select(_e958, _e956, (_e956 > _e958));
                                        let _e1014 = select(_e970, _e968, (_e968 > _e970));
                                        let _e1016 = select(_e971, _e969, (_e969 > _e971));
                                        let _e1018 = select(_e1014, _e1010, (_e1010 < _e1014));
                                        let _e1020 = select(_e1016, _e1012, (_e1012 < _e1016));
                                        let _e1025 = -(_e986);
                                        let _e1026 = -(_e988);
                                        let _e1033 = (select(_e990, _e1018, (_e1018 < _e990)) + (select(_e1025, _e990, (_e990 > _e1025)) * 0.0000019073523f));
                                        let _e1034 = (select(_e992, _e1020, (_e1020 < _e992)) + (select(_e1026, _e992, (_e992 > _e1026)) * 0.0000019073523f));
                                        let _e1036 = select(_e539, _e1006, (_e1006 > _e539));
                                        let _e1038 = select(_e539, _e1008, (_e1008 > _e539));
                                        let _e1043 = (_e1036 <= select(_e583.member_1, _e1033, (_e1033 < _e583.member_1)));
                                        let _e1044 = (_e1038 <= select(_e583.member_1, _e1034, (_e1034 < _e583.member_1)));
                                        let _e1045 = (_e1036 <= _e1038);
                                        if _e1043 {
                                            if _e1044 {
                                                if _e1045 {
                                                    phi_4151_ = _e943.member_2;
                                                } else {
                                                    phi_4151_ = _e943.member_1;
                                                }
                                                let _e1049 = phi_4151_;
                                                let _e1071 = (_e626 % 128u);
                                                let _e1072 = (_e1071 < 128u);
                                                if _e1072 {
                                                } else {
                                                    phi_4803_ = true;
                                                    break;
                                                }
                                                local_8[_e1071] = _e1049.member_1;
                                                if _e1072 {
                                                } else {
                                                    phi_4803_ = true;
                                                    break;
                                                }
                                                local_7[_e1071] = _e1049.member.member.x;
                                                if _e1072 {
                                                } else {
                                                    phi_4803_ = true;
                                                    break;
                                                }
                                                local_6[_e1071] = _e1049.member.member.y;
                                                if _e1072 {
                                                } else {
                                                    phi_4803_ = true;
                                                    break;
                                                }
                                                local_5[_e1071] = _e1049.member.member.z;
                                                if _e1072 {
                                                } else {
                                                    phi_4803_ = true;
                                                    break;
                                                }
                                                local_4[_e1071] = _e1049.member.member_1.x;
                                                if _e1072 {
                                                } else {
                                                    phi_4803_ = true;
                                                    break;
                                                }
                                                local_3[_e1071] = _e1049.member.member_1.y;
                                                if _e1072 {
                                                } else {
                                                    phi_4803_ = true;
                                                    break;
                                                }
                                                local_2[_e1071] = _e1049.member.member_1.z;
                                                if _e1072 {
                                                } else {
                                                    phi_4803_ = true;
                                                    break;
                                                }
                                                local_9[_e1071] = select(_e1038, _e1036, (_e1036 > _e1038));
                                                if _e1045 {
                                                    phi_4228_ = _e943.member_1;
                                                } else {
                                                    phi_4228_ = _e943.member_2;
                                                }
                                                let _e1085 = phi_4228_;
                                                phi_4229_ = _e1085;
                                                phi_4230_ = (_e626 + 1u);
                                            } else {
                                                phi_4229_ = type_57();
                                                phi_4230_ = u32();
                                            }
                                            let _e1087 = phi_4229_;
                                            let _e1089 = phi_4230_;
                                            phi_4232_ = _e1087;
                                            phi_4233_ = _e1089;
                                            phi_4234_ = select(true, false, _e1044);
                                        } else {
                                            phi_4232_ = type_57();
                                            phi_4233_ = u32();
                                            phi_4234_ = true;
                                        }
                                        let _e1092 = phi_4232_;
                                        let _e1094 = phi_4233_;
                                        let _e1096 = phi_4234_;
                                        if _e1096 {
                                            if _e1043 {
                                                phi_4243_ = _e943.member_1;
                                            } else {
                                                phi_4243_ = _e943.member_2;
                                            }
                                            let _e1100 = phi_4243_;
                                            phi_4248_ = _e1100;
                                            phi_4249_ = select(_e1044, true, _e1043);
                                        } else {
                                            phi_4248_ = _e1092;
                                            phi_4249_ = _e624;
                                        }
                                        let _e1103 = phi_4248_;
                                        let _e1105 = phi_4249_;
                                        phi_4807_ = _e581;
                                        phi_4251_ = _e583;
                                        phi_4252_ = _e1103;
                                        phi_4253_ = _e1105;
                                        phi_4254_ = select(_e1094, _e626, _e1096);
                                    }
                                    let _e2254 = phi_4807_;
                                    let _e2256 = phi_4251_;
                                    let _e2258 = phi_4252_;
                                    let _e2260 = phi_4253_;
                                    let _e2262 = phi_4254_;
                                    phi_4806_ = _e2254;
                                    phi_4255_ = _e2256;
                                    phi_4256_ = _e2258;
                                    phi_4257_ = (_e587 - 1u);
                                    phi_4258_ = _e2260;
                                    phi_4259_ = _e2262;
                                } else {
                                    phi_4806_ = _e581;
                                    phi_4255_ = _e583;
                                    phi_4256_ = _e622;
                                    phi_4257_ = _e587;
                                    phi_4258_ = _e624;
                                    phi_4259_ = _e626;
                                }
                                let _e2264 = phi_4806_;
                                let _e2266 = phi_4255_;
                                let _e2268 = phi_4256_;
                                let _e2270 = phi_4257_;
                                let _e2272 = phi_4258_;
                                let _e2274 = phi_4259_;
                                phi_4805_ = _e2264;
                                phi_4260_ = _e2266;
                                phi_4261_ = _e2268;
                                phi_4262_ = _e2270;
                                phi_4263_ = _e2272;
                                phi_4264_ = _e2274;
                            } else {
                                phi_4805_ = _e581;
                                phi_4260_ = type_38();
                                phi_4261_ = type_57();
                                phi_4262_ = u32();
                                phi_4263_ = bool();
                                phi_4264_ = u32();
                            }
                            let _e2276 = phi_4805_;
                            let _e2278 = phi_4260_;
                            let _e2280 = phi_4261_;
                            let _e2282 = phi_4262_;
                            let _e2284 = phi_4263_;
                            let _e2286 = phi_4264_;
                            phi_4804_ = _e2276;
                            phi_966_ = _e2278;
                            phi_969_ = _e2280;
                            phi_971_ = _e2282;
                            phi_973_ = _e2284;
                            phi_975_ = _e2286;
                            phi_4265_ = _e595;
                        } else {
                            phi_4804_ = _e581;
                            phi_966_ = type_38();
                            phi_969_ = type_57();
                            phi_971_ = u32();
                            phi_973_ = bool();
                            phi_975_ = u32();
                            phi_4265_ = false;
                        }
                        let _e2288 = phi_4804_;
                        let _e2290 = phi_966_;
                        let _e2292 = phi_969_;
                        let _e2294 = phi_971_;
                        let _e2296 = phi_973_;
                        let _e2298 = phi_975_;
                        let _e2300 = phi_4265_;
                        continue;
                        continuing {
                            phi_4596_ = _e2288;
                            phi_965_ = _e2290;
                            phi_968_ = _e2292;
                            phi_970_ = _e2294;
                            phi_972_ = _e2296;
                            phi_974_ = _e2298;
                            phi_4803_ = _e2288;
                            break if !(_e2300);
                        }
                    }
                    let _e2303 = phi_4803_;
                    if _e2303 {
                        break;
                    }
                    let _e2305 = local_10;
                    if (_e2305.member.member_3 != 4294967295u) {
                        let _e2310 = (_e363 / 3i);
                        let _e2317 = bitcast<f32>((bitcast<u32>((_e2310 + 127i)) << bitcast<u32>(23i)));
                        let _e2325 = (((_e2305.member.member * _e2317) * _e2317) * bitcast<f32>((bitcast<u32>(((_e363 - (2i * _e2310)) + 127i)) << bitcast<u32>(23i))));
                        let _e2327 = select(340282350000000000000000000000000000000f, _e2325, (_e2325 < 340282350000000000000000000000000000000f));
                        phi_4317_ = type_21(select(-340282350000000000000000000000000000000f, _e2327, (_e2327 > -340282350000000000000000000000000000000f)), _e2305.member.member_1, _e2305.member.member_2, _e2305.member.member_3);
                    } else {
                        phi_4317_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e2334 = phi_4317_;
                    if _e240 {
                    } else {
                        break;
                    }
                    global_7.member[_e146] = _e2334;
                    if _e161 {
                    } else {
                        break;
                    }
                    let _e2338 = select(0u, 1u, (_e307 <= _e317));
                    if (_e2338 > 0u) {
                        let _e2340 = (1u < _e114);
                        if _e2340 {
                            if (0u < _e114) {
                            } else {
                                break;
                            }
                            let _e2344 = atomicAdd((&global_8.member[0u]), _e2338);
                            if ((_e2344 + _e2338) < _e2344) {
                                if _e2340 {
                                } else {
                                    break;
                                }
                                let _e2349 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                    }
                    let _e2352 = select(0u, 1u, (_e2334.member_3 != 4294967295u));
                    if (_e2352 > 0u) {
                        let _e2354 = (3u < _e114);
                        if _e2354 {
                            if (2u < _e114) {
                            } else {
                                break;
                            }
                            let _e2358 = atomicAdd((&global_8.member[2u]), _e2352);
                            if ((_e2358 + _e2352) < _e2358) {
                                if _e2354 {
                                } else {
                                    break;
                                }
                                let _e2363 = atomicAdd((&global_8.member[3u]), 1u);
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
fn trace_paths_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
