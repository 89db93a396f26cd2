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

struct type_30 {
    member: type_29,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_32 {
    member: array<type_30>,
}

struct type_37 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_39 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_42 {
    member: type_25,
    member_1: f32,
}

struct type_47 {
    member: array<vec4<u32>, 2>,
}

struct type_50 {
    member: array<i32>,
}

struct type_57 {
    member: type_37,
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
var<uniform> global_1: type_16;
@group(0) @binding(1) 
var<uniform> global_2: type_47;
@group(0) @binding(2) 
var<uniform> global_3: type_47;
@group(0) @binding(3) 
var<storage> global_4: type_13;
@group(0) @binding(5) 
var<storage> global_5: type_4;
@group(0) @binding(6) 
var<storage> global_6: type_50;
@group(0) @binding(7) 
var<storage> global_7: type_32;
@group(0) @binding(8) 
var<storage, read_write> global_8: type_27;
@group(0) @binding(9) 
var<storage, read_write> global_9: type_63;
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
    var phi_401_: type_39;
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
    var phi_965_: type_42;
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
    var phi_1092_: type_42;
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
    var phi_2620_: type_25;
    var phi_2622_: type_25;
    var phi_2623_: bool;
    var phi_2627_: type_25;
    var phi_2628_: type_25;
    var phi_2629_: type_25;
    var phi_2630_: bool;
    var phi_2634_: type_25;
    var phi_2635_: bool;
    var phi_2636_: type_25;
    var phi_2637_: bool;
    var phi_2638_: bool;
    var phi_2639_: type_25;
    var phi_2640_: bool;
    var phi_2641_: bool;
    var phi_2649_: type_25;
    var phi_2650_: bool;
    var phi_2654_: type_25;
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
    var phi_3009_: type_42;
    var phi_3010_: type_42;
    var phi_3011_: type_42;
    var phi_1093_: type_42;
    var phi_4590_: bool;
    var phi_4807_: bool;
    var phi_4251_: type_42;
    var phi_4252_: type_57;
    var phi_4253_: bool;
    var phi_4254_: u32;
    var phi_4806_: bool;
    var phi_4255_: type_42;
    var phi_4256_: type_57;
    var phi_4257_: u32;
    var phi_4258_: bool;
    var phi_4259_: u32;
    var phi_4805_: bool;
    var phi_4260_: type_42;
    var phi_4261_: type_57;
    var phi_4262_: u32;
    var phi_4263_: bool;
    var phi_4264_: u32;
    var phi_4804_: bool;
    var phi_966_: type_42;
    var phi_969_: type_57;
    var phi_971_: u32;
    var phi_973_: bool;
    var phi_975_: u32;
    var phi_4265_: bool;
    var phi_4803_: bool;
    var local_10: type_42;
    var phi_4317_: type_25;
    var local_11: type_42;

    switch bitcast<i32>(0u) {
        default: {
            let _e100 = global;
            let _e102 = arrayLength((&global_4.member));
            let _e105 = arrayLength((&global_10.member));
            let _e117 = arrayLength((&global_9.member));
            let _e121 = global_3.member[0u][0u];
            let _e125 = global_3.member[0u][1u];
            let _e129 = global_3.member[0u][2u];
            let _e133 = global_3.member[0u][3u];
            let _e137 = global_3.member[1u][0u];
            let _e141 = global_3.member[1u][1u];
            let _e145 = global_3.member[1u][2u];
            let _e149 = (_e100.x + (_e100.y * 2097152u));
            let _e161 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e133) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e121), bitcast<i32>(_e125), bitcast<i32>(_e129));
            local = array<i32, 3>(bitcast<i32>(_e137), bitcast<i32>(_e141), bitcast<i32>(_e145));
            let _e164 = (_e149 < arrayLength((&global_7.member)));
            if _e164 {
                if _e164 {
                } else {
                    break;
                }
                let _e168 = global_7.member[_e149].member_2;
                phi_333_ = _e168;
            } else {
                phi_333_ = 4294967295u;
            }
            let _e170 = phi_333_;
            let _e173 = global_1.member[0u];
            let _e177 = global_2.member[0u][0u];
            let _e181 = global_2.member[0u][1u];
            let _e185 = global_2.member[0u][2u];
            let _e189 = global_2.member[0u][3u];
            let _e193 = global_2.member[1u][0u];
            let _e197 = global_2.member[1u][1u];
            let _e201 = global_2.member[1u][2u];
            let _e205 = global_2.member[1u][3u];
            let _e206 = bitcast<f32>(_e177);
            let _e207 = bitcast<f32>(_e181);
            let _e208 = bitcast<f32>(_e185);
            let _e210 = bitcast<f32>(_e193);
            let _e211 = array<u32, 3>(_e197, _e201, _e205);
            let _e213 = bitcast<i32>(_e173);
            if (_e213 < -126i) {
                phi_377_ = -126i;
            } else {
                phi_377_ = select(_e213, 127i, (_e213 > 127i));
            }
            let _e218 = phi_377_;
            let _e223 = bitcast<f32>((bitcast<u32>((_e218 + 127i)) << bitcast<u32>(23i)));
            let _e229 = bitcast<f32>((bitcast<u32>(((_e213 - _e218) + 127i)) << bitcast<u32>(23i)));
            if (_e189 == 0u) {
                phi_401_ = type_39(array<f32, 3>(_e206, _e207, _e208), _e189, _e210, _e211);
            } else {
                phi_401_ = type_39(array<f32, 3>(((_e206 * _e223) * _e229), ((_e207 * _e223) * _e229), ((_e208 * _e223) * _e229)), _e189, ((_e210 * _e223) * _e229), _e211);
            }
            let _e242 = phi_401_;
            if _e164 {
                let _e243 = (_e149 < arrayLength((&global_8.member)));
                if _e243 {
                    if _e164 {
                    } else {
                        break;
                    }
                    let _e253 = global_7.member[_e149].member.member_2[0u];
                    let _e255 = (bitcast<u32>(_e253) & 2147483647u);
                    let _e261 = global_7.member[_e149].member.member_2[1u];
                    let _e263 = (bitcast<u32>(_e261) & 2147483647u);
                    let _e269 = global_7.member[_e149].member.member_2[2u];
                    let _e271 = (bitcast<u32>(_e269) & 2147483647u);
                    let _e277 = global_7.member[_e149].member.member[0u];
                    let _e279 = (bitcast<u32>(_e277) & 2147483647u);
                    let _e285 = global_7.member[_e149].member.member[1u];
                    let _e287 = (bitcast<u32>(_e285) & 2147483647u);
                    let _e293 = global_7.member[_e149].member.member[2u];
                    let _e295 = (bitcast<u32>(_e293) & 2147483647u);
                    let _e297 = select(_e263, _e255, (_e263 < _e255));
                    let _e299 = select(_e271, _e297, (_e271 < _e297));
                    let _e301 = select(_e279, _e299, (_e279 < _e299));
                    let _e303 = select(_e287, _e301, (_e287 < _e301));
                    let _e305 = select(_e295, _e303, (_e295 < _e303));
                    let _e310 = global_7.member[_e149].member.member_1;
                    let _e312 = (bitcast<u32>(_e310) & 2147483647u);
                    let _e320 = global_7.member[_e149].member.member_3;
                    let _e326 = (((select(_e312, _e305, (_e312 < _e305)) < 2139095040u) && ((bitcast<u32>(_e320) & 2147483647u) <= 2139095040u)) && (_e299 > 0u));
                    if _e326 {
                        let _e329 = (bitcast<u32>(bitcast<f32>(_e299)) & 2147483647u);
                        if (_e329 >= 8388608u) {
                            phi_507_ = (bitcast<i32>((_e329 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_507_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e329)), 32u, (_e329 == 0u))));
                        }
                        let _e343 = phi_507_;
                        phi_508_ = _e343;
                    } else {
                        phi_508_ = 0i;
                    }
                    let _e345 = phi_508_;
                    let _e346 = (_e255 == _e299);
                    if _e346 {
                        phi_518_ = true;
                    } else {
                        phi_518_ = (_e263 == _e299);
                    }
                    let _e349 = phi_518_;
                    let _e350 = select(1u, 0u, _e346);
                    if _e349 {
                        let _e351 = (_e350 + 1u);
                        phi_528_ = _e351;
                        phi_529_ = _e351;
                        phi_531_ = select(true, false, (_e351 == 2u));
                    } else {
                        phi_528_ = u32();
                        phi_529_ = 0u;
                        phi_531_ = true;
                    }
                    let _e355 = phi_528_;
                    let _e357 = phi_529_;
                    let _e359 = phi_531_;
                    if _e359 {
                        phi_536_ = (_e357 + 1u);
                    } else {
                        phi_536_ = 0u;
                    }
                    let _e363 = phi_536_;
                    let _e364 = select(_e355, _e357, _e359);
                    let _e365 = select(_e350, select(2u, _e350, _e349), _e359);
                    let _e366 = -(_e345);
                    if (_e366 < -126i) {
                        phi_568_ = -126i;
                    } else {
                        phi_568_ = select(_e366, 127i, (_e366 > 127i));
                    }
                    let _e371 = phi_568_;
                    let _e376 = bitcast<f32>((bitcast<u32>((_e371 + 127i)) << bitcast<u32>(23i)));
                    let _e382 = bitcast<f32>((bitcast<u32>(((_e366 - _e371) + 127i)) << bitcast<u32>(23i)));
                    let _e387 = global_7.member[_e149].member.member;
                    let _e388 = (_e364 == 0u);
                    if _e388 {
                        phi_586_ = _e387[0];
                    } else {
                        phi_586_ = _e387[1];
                    }
                    let _e392 = phi_586_;
                    let _e393 = (_e364 == 2u);
                    if _e393 {
                        phi_592_ = _e387[2];
                    } else {
                        phi_592_ = _e392;
                    }
                    let _e396 = phi_592_;
                    let _e397 = global_7.member[_e149].member.member_2;
                    if _e388 {
                        phi_603_ = _e397[0];
                    } else {
                        phi_603_ = _e397[1];
                    }
                    let _e401 = phi_603_;
                    if _e393 {
                        phi_609_ = _e397[2];
                    } else {
                        phi_609_ = _e401;
                    }
                    let _e404 = phi_609_;
                    let _e406 = ((_e404 * _e376) * _e382);
                    let _e410 = (bitcast<f32>((bitcast<u32>(_e406) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e410 {
                        let _e414 = (bitcast<f32>((bitcast<u32>(_e396) & 2147483647u)) * 0.00000011920929f);
                        phi_632_ = select(0.00000000000011368684f, _e414, (_e414 > 0.00000000000011368684f));
                    } else {
                        phi_632_ = 0f;
                    }
                    let _e418 = phi_632_;
                    let _e419 = (_e396 + _e418);
                    let _e420 = (_e396 - _e418);
                    let _e421 = select(_e406, 0f, _e410);
                    if _e410 {
                        phi_643_ = 38685626000000000000000000f;
                    } else {
                        phi_643_ = (1f / _e406);
                    }
                    let _e424 = phi_643_;
                    let _e425 = (_e363 == 0u);
                    if _e425 {
                        phi_652_ = _e387[0];
                    } else {
                        phi_652_ = _e387[1];
                    }
                    let _e429 = phi_652_;
                    let _e430 = (_e363 == 2u);
                    if _e430 {
                        phi_658_ = _e387[2];
                    } else {
                        phi_658_ = _e429;
                    }
                    let _e433 = phi_658_;
                    if _e425 {
                        phi_669_ = _e397[0];
                    } else {
                        phi_669_ = _e397[1];
                    }
                    let _e437 = phi_669_;
                    if _e430 {
                        phi_675_ = _e397[2];
                    } else {
                        phi_675_ = _e437;
                    }
                    let _e440 = phi_675_;
                    let _e442 = ((_e440 * _e376) * _e382);
                    let _e446 = (bitcast<f32>((bitcast<u32>(_e442) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e446 {
                        let _e450 = (bitcast<f32>((bitcast<u32>(_e433) & 2147483647u)) * 0.00000011920929f);
                        phi_698_ = select(0.00000000000011368684f, _e450, (_e450 > 0.00000000000011368684f));
                    } else {
                        phi_698_ = 0f;
                    }
                    let _e454 = phi_698_;
                    let _e455 = (_e433 + _e454);
                    let _e456 = (_e433 - _e454);
                    let _e457 = select(_e442, 0f, _e446);
                    if _e446 {
                        phi_709_ = 38685626000000000000000000f;
                    } else {
                        phi_709_ = (1f / _e442);
                    }
                    let _e460 = phi_709_;
                    let _e461 = (_e365 == 0u);
                    if _e461 {
                        phi_718_ = _e387[0];
                    } else {
                        phi_718_ = _e387[1];
                    }
                    let _e465 = phi_718_;
                    let _e466 = (_e365 == 2u);
                    if _e466 {
                        phi_724_ = _e387[2];
                    } else {
                        phi_724_ = _e465;
                    }
                    let _e469 = phi_724_;
                    if _e461 {
                        phi_735_ = _e397[0];
                    } else {
                        phi_735_ = _e397[1];
                    }
                    let _e473 = phi_735_;
                    if _e466 {
                        phi_741_ = _e397[2];
                    } else {
                        phi_741_ = _e473;
                    }
                    let _e476 = phi_741_;
                    let _e478 = ((_e476 * _e376) * _e382);
                    let _e482 = (bitcast<f32>((bitcast<u32>(_e478) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e482 {
                        let _e486 = (bitcast<f32>((bitcast<u32>(_e469) & 2147483647u)) * 0.00000011920929f);
                        phi_764_ = select(0.00000000000011368684f, _e486, (_e486 > 0.00000000000011368684f));
                    } else {
                        phi_764_ = 0f;
                    }
                    let _e490 = phi_764_;
                    let _e491 = (_e469 + _e490);
                    let _e492 = (_e469 - _e490);
                    let _e493 = select(_e478, 0f, _e482);
                    if _e482 {
                        phi_775_ = 38685626000000000000000000f;
                    } else {
                        phi_775_ = (1f / _e478);
                    }
                    let _e496 = phi_775_;
                    let _e499 = bitcast<f32>((bitcast<u32>(_e396) & 2147483647u));
                    let _e502 = bitcast<f32>((bitcast<u32>(_e433) & 2147483647u));
                    let _e504 = select(_e502, _e499, (_e499 > _e502));
                    let _e507 = bitcast<f32>((bitcast<u32>(_e469) & 2147483647u));
                    if (_e326 && (select(_e507, _e504, (_e504 > _e507)) <= 1099511600000f)) {
                        let _e512 = (_e345 / 3i);
                        let _e519 = bitcast<f32>((bitcast<u32>((_e512 + 127i)) << bitcast<u32>(23i)));
                        let _e526 = bitcast<f32>((bitcast<u32>(((_e345 - (2i * _e512)) + 127i)) << bitcast<u32>(23i)));
                        let _e527 = (((_e310 * _e519) * _e519) * _e526);
                        let _e529 = select(340282350000000000000000000000000000000f, _e527, (_e527 < 340282350000000000000000000000000000000f));
                        let _e534 = (((_e320 * _e519) * _e519) * _e526);
                        let _e536 = select(340282350000000000000000000000000000000f, _e534, (_e534 < 340282350000000000000000000000000000000f));
                        phi_875_ = select(-340282350000000000000000000000000000000f, _e536, (_e536 > -340282350000000000000000000000000000000f));
                        phi_876_ = select(-340282350000000000000000000000000000000f, _e529, (_e529 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_875_ = 0f;
                        phi_876_ = 1f;
                    }
                    let _e540 = phi_875_;
                    let _e542 = phi_876_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e546 = (_e364 % 3u);
                    let _e547 = (_e546 < 3u);
                    if _e547 {
                    } else {
                        break;
                    }
                    let _e549 = local_1[_e546];
                    let _e552 = (_e363 % 3u);
                    let _e553 = (_e552 < 3u);
                    if _e553 {
                    } else {
                        break;
                    }
                    let _e555 = local_1[_e552];
                    let _e558 = (_e365 % 3u);
                    let _e559 = (_e558 < 3u);
                    if _e559 {
                    } else {
                        break;
                    }
                    let _e561 = local_1[_e558];
                    if _e547 {
                    } else {
                        break;
                    }
                    let _e566 = local[_e546];
                    if _e553 {
                    } else {
                        break;
                    }
                    let _e570 = local[_e552];
                    if _e559 {
                    } else {
                        break;
                    }
                    let _e574 = local[_e558];
                    phi_4596_ = false;
                    phi_965_ = type_42(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e540);
                    phi_968_ = type_57(type_37(vec4<f32>((f32(_e549) * _e161), (f32(_e555) * _e161), (f32(_e561) * _e161), 0f), vec4<f32>((f32(_e566) * _e161), (f32(_e570) * _e161), (f32(_e574) * _e161), 0f)), select(0u, 2147483648u, (_e102 == 0u)));
                    phi_970_ = ((3u * _e102) + 1u);
                    phi_972_ = (_e542 <= _e540);
                    phi_974_ = 0u;
                    loop {
                        let _e584 = phi_4596_;
                        let _e586 = phi_965_;
                        let _e588 = phi_968_;
                        let _e590 = phi_970_;
                        let _e592 = phi_972_;
                        let _e594 = phi_974_;
                        local_10 = _e586;
                        if _e592 {
                            phi_985_ = true;
                        } else {
                            phi_985_ = (_e594 > 0u);
                        }
                        let _e597 = phi_985_;
                        if _e597 {
                            let _e598 = (_e590 > 0u);
                            if _e598 {
                                if _e592 {
                                    phi_1071_ = _e588;
                                    phi_1072_ = _e592;
                                    phi_1073_ = _e594;
                                } else {
                                    let _e599 = (_e594 - 1u);
                                    let _e600 = (_e599 % 128u);
                                    let _e601 = (_e600 < 128u);
                                    if _e601 {
                                    } else {
                                        phi_4803_ = true;
                                        break;
                                    }
                                    let _e603 = local_7[_e600];
                                    if _e601 {
                                    } else {
                                        phi_4803_ = true;
                                        break;
                                    }
                                    let _e605 = local_6[_e600];
                                    if _e601 {
                                    } else {
                                        phi_4803_ = true;
                                        break;
                                    }
                                    let _e607 = local_5[_e600];
                                    if _e601 {
                                    } else {
                                        phi_4803_ = true;
                                        break;
                                    }
                                    let _e609 = local_4[_e600];
                                    if _e601 {
                                    } else {
                                        phi_4803_ = true;
                                        break;
                                    }
                                    let _e611 = local_3[_e600];
                                    if _e601 {
                                    } else {
                                        phi_4803_ = true;
                                        break;
                                    }
                                    let _e613 = local_2[_e600];
                                    if _e601 {
                                    } else {
                                        phi_4803_ = true;
                                        break;
                                    }
                                    let _e618 = local_8[_e600];
                                    if _e601 {
                                    } else {
                                        phi_4803_ = true;
                                        break;
                                    }
                                    let _e621 = local_9[_e600];
                                    phi_1071_ = type_57(type_37(vec4<f32>(_e603, _e605, _e607, 0f), vec4<f32>(_e609, _e611, _e613, 0f)), _e618);
                                    phi_1072_ = (_e621 <= _e586.member_1);
                                    phi_1073_ = _e599;
                                }
                                let _e625 = phi_1071_;
                                let _e627 = phi_1072_;
                                let _e629 = phi_1073_;
                                if _e627 {
                                    let _e634 = (_e625.member_1 & 268435455u);
                                    if ((_e625.member_1 & 2147483648u) != 0u) {
                                        phi_1092_ = _e586;
                                        phi_1095_ = type_8(0u, ((_e625.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1094 = phi_1092_;
                                            let _e1096 = phi_1095_;
                                            local_11 = _e1094;
                                            if (_e1096.member < _e1096.member_1) {
                                                phi_1096_ = type_8((_e1096.member + 1u), _e1096.member_1);
                                                phi_1118_ = type_8(1u, _e1096.member);
                                            } else {
                                                phi_1096_ = _e1096;
                                                phi_1118_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1109 = phi_1096_;
                                            let _e1111 = phi_1118_;
                                            let _e1115 = (bitcast<i32>(_e1111.member) != 0i);
                                            if _e1115 {
                                                let _e1120 = (_e625.member.member_1.x - _e625.member.member.x);
                                                let _e1123 = (_e625.member.member_1.y - _e625.member.member.y);
                                                let _e1126 = (_e625.member.member_1.z - _e625.member.member.z);
                                                let _e1128 = select(_e1123, _e1120, (_e1120 > _e1123));
                                                let _e1130 = select(_e1126, _e1128, (_e1128 > _e1126));
                                                let _e1132 = (_e1130 < (1024f * _e161));
                                                if _e1132 {
                                                    phi_1159_ = 0u;
                                                } else {
                                                    phi_1159_ = select(2u, 1u, (_e1130 < (2097152f * _e161)));
                                                }
                                                let _e1137 = phi_1159_;
                                                switch bitcast<i32>(_e1137) {
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
                                                let _e1140 = phi_1165_;
                                                switch bitcast<i32>(_e1137) {
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
                                                let _e1147 = phi_1175_;
                                                let _e1149 = ((_e634 + (_e1111.member_1 * ((3u * _e1140) + 1u))) + (3u * _e1147));
                                                let _e1150 = (_e1149 < _e105);
                                                if _e1150 {
                                                    if _e1150 {
                                                    } else {
                                                        phi_4590_ = true;
                                                        break;
                                                    }
                                                    let _e1152 = global_10.member[_e1149];
                                                    phi_1191_ = _e1152;
                                                } else {
                                                    phi_1191_ = 4294967295u;
                                                }
                                                let _e1154 = phi_1191_;
                                                if _e1132 {
                                                    phi_1224_ = 0u;
                                                } else {
                                                    phi_1224_ = select(2u, 1u, (_e1130 < (2097152f * _e161)));
                                                }
                                                let _e1159 = phi_1224_;
                                                switch bitcast<i32>(_e1159) {
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
                                                let _e1162 = phi_1230_;
                                                let _e1166 = (_e634 + (_e1111.member_1 * ((3u * _e1162) + 1u)));
                                                switch bitcast<i32>(_e1159) {
                                                    case 0: {
                                                        let _e1432 = (_e1166 < _e105);
                                                        if _e1432 {
                                                            if _e1432 {
                                                            } else {
                                                                phi_4590_ = true;
                                                                break;
                                                            }
                                                            let _e1434 = global_10.member[_e1166];
                                                            phi_1254_ = _e1434;
                                                        } else {
                                                            phi_1254_ = 0u;
                                                        }
                                                        let _e1436 = phi_1254_;
                                                        let _e1438 = ((10u * _e364) & 31u);
                                                        let _e1447 = ((10u * _e363) & 31u);
                                                        let _e1456 = ((10u * _e365) & 31u);
                                                        let _e1465 = (_e1166 + 1u);
                                                        let _e1466 = (_e1465 < _e105);
                                                        if _e1466 {
                                                            if _e1466 {
                                                            } else {
                                                                phi_4590_ = true;
                                                                break;
                                                            }
                                                            let _e1468 = global_10.member[_e1465];
                                                            phi_1297_ = _e1468;
                                                        } else {
                                                            phi_1297_ = 0u;
                                                        }
                                                        let _e1470 = phi_1297_;
                                                        let _e1493 = (_e1166 + 2u);
                                                        let _e1494 = (_e1493 < _e105);
                                                        if _e1494 {
                                                            if _e1494 {
                                                            } else {
                                                                phi_4590_ = true;
                                                                break;
                                                            }
                                                            let _e1496 = global_10.member[_e1493];
                                                            phi_1340_ = _e1496;
                                                        } else {
                                                            phi_1340_ = 0u;
                                                        }
                                                        let _e1498 = phi_1340_;
                                                        phi_1811_ = array<array<f32, 3>, 3>(array<f32, 3>((_e625.member.member.x + (f32(bitcast<i32>(((_e1436 >> bitcast<u32>(_e1438)) & 1023u))) * _e161)), (_e625.member.member.y + (f32(bitcast<i32>(((_e1436 >> bitcast<u32>(_e1447)) & 1023u))) * _e161)), (_e625.member.member.z + (f32(bitcast<i32>(((_e1436 >> bitcast<u32>(_e1456)) & 1023u))) * _e161))), array<f32, 3>((_e625.member.member.x + (f32(bitcast<i32>(((_e1470 >> bitcast<u32>(_e1438)) & 1023u))) * _e161)), (_e625.member.member.y + (f32(bitcast<i32>(((_e1470 >> bitcast<u32>(_e1447)) & 1023u))) * _e161)), (_e625.member.member.z + (f32(bitcast<i32>(((_e1470 >> bitcast<u32>(_e1456)) & 1023u))) * _e161))), array<f32, 3>((_e625.member.member.x + (f32(bitcast<i32>(((_e1498 >> bitcast<u32>(_e1438)) & 1023u))) * _e161)), (_e625.member.member.y + (f32(bitcast<i32>(((_e1498 >> bitcast<u32>(_e1447)) & 1023u))) * _e161)), (_e625.member.member.z + (f32(bitcast<i32>(((_e1498 >> bitcast<u32>(_e1456)) & 1023u))) * _e161))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1255 = (_e1166 < _e105);
                                                        if _e1255 {
                                                            if _e1255 {
                                                            } else {
                                                                phi_4590_ = true;
                                                                break;
                                                            }
                                                            let _e1257 = global_10.member[_e1166];
                                                            phi_1383_ = _e1257;
                                                        } else {
                                                            phi_1383_ = 0u;
                                                        }
                                                        let _e1259 = phi_1383_;
                                                        let _e1260 = (_e1166 + 1u);
                                                        let _e1261 = (_e1260 < _e105);
                                                        if _e1261 {
                                                            if _e1261 {
                                                            } else {
                                                                phi_4590_ = true;
                                                                break;
                                                            }
                                                            let _e1263 = global_10.member[_e1260];
                                                            phi_1398_ = _e1263;
                                                        } else {
                                                            phi_1398_ = 0u;
                                                        }
                                                        let _e1265 = phi_1398_;
                                                        let _e1266 = (_e364 == 1u);
                                                        if _e1266 {
                                                            phi_1408_ = ((_e1259 >> bitcast<u32>(21i)) | (_e1265 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1408_ = (_e1265 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1275 = phi_1408_;
                                                        let _e1282 = (_e363 == 1u);
                                                        if _e1282 {
                                                            phi_1428_ = ((_e1259 >> bitcast<u32>(21i)) | (_e1265 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1428_ = (_e1265 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1291 = phi_1428_;
                                                        let _e1298 = (_e365 == 1u);
                                                        if _e1298 {
                                                            phi_1448_ = ((_e1259 >> bitcast<u32>(21i)) | (_e1265 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1448_ = (_e1265 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1307 = phi_1448_;
                                                        let _e1315 = (_e1166 + 2u);
                                                        let _e1316 = (_e1315 < _e105);
                                                        if _e1316 {
                                                            if _e1316 {
                                                            } else {
                                                                phi_4590_ = true;
                                                                break;
                                                            }
                                                            let _e1318 = global_10.member[_e1315];
                                                            phi_1474_ = _e1318;
                                                        } else {
                                                            phi_1474_ = 0u;
                                                        }
                                                        let _e1320 = phi_1474_;
                                                        let _e1321 = (_e1166 + 3u);
                                                        let _e1322 = (_e1321 < _e105);
                                                        if _e1322 {
                                                            if _e1322 {
                                                            } else {
                                                                phi_4590_ = true;
                                                                break;
                                                            }
                                                            let _e1324 = global_10.member[_e1321];
                                                            phi_1489_ = _e1324;
                                                        } else {
                                                            phi_1489_ = 0u;
                                                        }
                                                        let _e1326 = phi_1489_;
                                                        if _e1266 {
                                                            phi_1499_ = ((_e1320 >> bitcast<u32>(21i)) | (_e1326 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1499_ = (_e1326 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1335 = phi_1499_;
                                                        if _e1282 {
                                                            phi_1519_ = ((_e1320 >> bitcast<u32>(21i)) | (_e1326 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1519_ = (_e1326 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1350 = phi_1519_;
                                                        if _e1298 {
                                                            phi_1539_ = ((_e1320 >> bitcast<u32>(21i)) | (_e1326 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1539_ = (_e1326 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1365 = phi_1539_;
                                                        let _e1373 = (_e1166 + 4u);
                                                        let _e1374 = (_e1373 < _e105);
                                                        if _e1374 {
                                                            if _e1374 {
                                                            } else {
                                                                phi_4590_ = true;
                                                                break;
                                                            }
                                                            let _e1376 = global_10.member[_e1373];
                                                            phi_1565_ = _e1376;
                                                        } else {
                                                            phi_1565_ = 0u;
                                                        }
                                                        let _e1378 = phi_1565_;
                                                        let _e1379 = (_e1166 + 5u);
                                                        let _e1380 = (_e1379 < _e105);
                                                        if _e1380 {
                                                            if _e1380 {
                                                            } else {
                                                                phi_4590_ = true;
                                                                break;
                                                            }
                                                            let _e1382 = global_10.member[_e1379];
                                                            phi_1580_ = _e1382;
                                                        } else {
                                                            phi_1580_ = 0u;
                                                        }
                                                        let _e1384 = phi_1580_;
                                                        if _e1266 {
                                                            phi_1590_ = ((_e1378 >> bitcast<u32>(21i)) | (_e1384 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1590_ = (_e1384 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1393 = phi_1590_;
                                                        if _e1282 {
                                                            phi_1610_ = ((_e1378 >> bitcast<u32>(21i)) | (_e1384 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1610_ = (_e1384 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1408 = phi_1610_;
                                                        if _e1298 {
                                                            phi_1630_ = ((_e1378 >> bitcast<u32>(21i)) | (_e1384 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1630_ = (_e1384 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1423 = phi_1630_;
                                                        phi_1811_ = array<array<f32, 3>, 3>(array<f32, 3>((_e625.member.member.x + (f32(bitcast<i32>((select(_e1275, _e1259, _e388) & 2097151u))) * _e161)), (_e625.member.member.y + (f32(bitcast<i32>((select(_e1291, _e1259, _e425) & 2097151u))) * _e161)), (_e625.member.member.z + (f32(bitcast<i32>((select(_e1307, _e1259, _e461) & 2097151u))) * _e161))), array<f32, 3>((_e625.member.member.x + (f32(bitcast<i32>((select(_e1335, _e1320, _e388) & 2097151u))) * _e161)), (_e625.member.member.y + (f32(bitcast<i32>((select(_e1350, _e1320, _e425) & 2097151u))) * _e161)), (_e625.member.member.z + (f32(bitcast<i32>((select(_e1365, _e1320, _e461) & 2097151u))) * _e161))), array<f32, 3>((_e625.member.member.x + (f32(bitcast<i32>((select(_e1393, _e1378, _e388) & 2097151u))) * _e161)), (_e625.member.member.y + (f32(bitcast<i32>((select(_e1408, _e1378, _e425) & 2097151u))) * _e161)), (_e625.member.member.z + (f32(bitcast<i32>((select(_e1423, _e1378, _e461) & 2097151u))) * _e161))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1168 = (_e1166 + _e364);
                                                        let _e1169 = (_e1168 < _e105);
                                                        if _e1169 {
                                                            if _e1169 {
                                                            } else {
                                                                phi_4590_ = true;
                                                                break;
                                                            }
                                                            let _e1171 = global_10.member[_e1168];
                                                            phi_1657_ = _e1171;
                                                        } else {
                                                            phi_1657_ = 0u;
                                                        }
                                                        let _e1173 = phi_1657_;
                                                        let _e1177 = (_e1166 + _e363);
                                                        let _e1178 = (_e1177 < _e105);
                                                        if _e1178 {
                                                            if _e1178 {
                                                            } else {
                                                                phi_4590_ = true;
                                                                break;
                                                            }
                                                            let _e1180 = global_10.member[_e1177];
                                                            phi_1675_ = _e1180;
                                                        } else {
                                                            phi_1675_ = 0u;
                                                        }
                                                        let _e1182 = phi_1675_;
                                                        let _e1186 = (_e1166 + _e365);
                                                        let _e1187 = (_e1186 < _e105);
                                                        if _e1187 {
                                                            if _e1187 {
                                                            } else {
                                                                phi_4590_ = true;
                                                                break;
                                                            }
                                                            let _e1189 = global_10.member[_e1186];
                                                            phi_1693_ = _e1189;
                                                        } else {
                                                            phi_1693_ = 0u;
                                                        }
                                                        let _e1191 = phi_1693_;
                                                        let _e1196 = (_e1166 + 3u);
                                                        let _e1197 = (_e1196 + _e364);
                                                        let _e1198 = (_e1197 < _e105);
                                                        if _e1198 {
                                                            if _e1198 {
                                                            } else {
                                                                phi_4590_ = true;
                                                                break;
                                                            }
                                                            let _e1200 = global_10.member[_e1197];
                                                            phi_1713_ = _e1200;
                                                        } else {
                                                            phi_1713_ = 0u;
                                                        }
                                                        let _e1202 = phi_1713_;
                                                        let _e1206 = (_e1196 + _e363);
                                                        let _e1207 = (_e1206 < _e105);
                                                        if _e1207 {
                                                            if _e1207 {
                                                            } else {
                                                                phi_4590_ = true;
                                                                break;
                                                            }
                                                            let _e1209 = global_10.member[_e1206];
                                                            phi_1731_ = _e1209;
                                                        } else {
                                                            phi_1731_ = 0u;
                                                        }
                                                        let _e1211 = phi_1731_;
                                                        let _e1215 = (_e1196 + _e365);
                                                        let _e1216 = (_e1215 < _e105);
                                                        if _e1216 {
                                                            if _e1216 {
                                                            } else {
                                                                phi_4590_ = true;
                                                                break;
                                                            }
                                                            let _e1218 = global_10.member[_e1215];
                                                            phi_1749_ = _e1218;
                                                        } else {
                                                            phi_1749_ = 0u;
                                                        }
                                                        let _e1220 = phi_1749_;
                                                        let _e1225 = (_e1166 + 6u);
                                                        let _e1226 = (_e1225 + _e364);
                                                        let _e1227 = (_e1226 < _e105);
                                                        if _e1227 {
                                                            if _e1227 {
                                                            } else {
                                                                phi_4590_ = true;
                                                                break;
                                                            }
                                                            let _e1229 = global_10.member[_e1226];
                                                            phi_1769_ = _e1229;
                                                        } else {
                                                            phi_1769_ = 0u;
                                                        }
                                                        let _e1231 = phi_1769_;
                                                        let _e1235 = (_e1225 + _e363);
                                                        let _e1236 = (_e1235 < _e105);
                                                        if _e1236 {
                                                            if _e1236 {
                                                            } else {
                                                                phi_4590_ = true;
                                                                break;
                                                            }
                                                            let _e1238 = global_10.member[_e1235];
                                                            phi_1787_ = _e1238;
                                                        } else {
                                                            phi_1787_ = 0u;
                                                        }
                                                        let _e1240 = phi_1787_;
                                                        let _e1244 = (_e1225 + _e365);
                                                        let _e1245 = (_e1244 < _e105);
                                                        if _e1245 {
                                                            if _e1245 {
                                                            } else {
                                                                phi_4590_ = true;
                                                                break;
                                                            }
                                                            let _e1247 = global_10.member[_e1244];
                                                            phi_1805_ = _e1247;
                                                        } else {
                                                            phi_1805_ = 0u;
                                                        }
                                                        let _e1249 = phi_1805_;
                                                        phi_1811_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1173)) * _e161), (f32(bitcast<i32>(_e1182)) * _e161), (f32(bitcast<i32>(_e1191)) * _e161)), array<f32, 3>((f32(bitcast<i32>(_e1202)) * _e161), (f32(bitcast<i32>(_e1211)) * _e161), (f32(bitcast<i32>(_e1220)) * _e161)), array<f32, 3>((f32(bitcast<i32>(_e1231)) * _e161), (f32(bitcast<i32>(_e1240)) * _e161), (f32(bitcast<i32>(_e1249)) * _e161)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1811_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1523 = phi_1811_;
                                                let _e1531 = (_e1523[0][2] - _e469);
                                                let _e1534 = (((_e1523[0][0] - _e396) * _e493) - (_e1531 * _e421));
                                                let _e1537 = (((_e1523[0][1] - _e433) * _e493) - (_e1531 * _e457));
                                                let _e1544 = (_e1523[1][2] - _e469);
                                                let _e1547 = (((_e1523[1][0] - _e396) * _e493) - (_e1544 * _e421));
                                                let _e1550 = (((_e1523[1][1] - _e433) * _e493) - (_e1544 * _e457));
                                                let _e1557 = (_e1523[2][2] - _e469);
                                                let _e1560 = (((_e1523[2][0] - _e396) * _e493) - (_e1557 * _e421));
                                                let _e1563 = (((_e1523[2][1] - _e433) * _e493) - (_e1557 * _e457));
                                                let _e1564 = (_e1560 * _e1550);
                                                let _e1565 = (_e1563 * _e1547);
                                                let _e1566 = (_e1534 * _e1563);
                                                let _e1567 = (_e1537 * _e1560);
                                                let _e1568 = (_e1547 * _e1537);
                                                let _e1569 = (_e1550 * _e1534);
                                                let _e1574 = (((_e1564 >= _e1565) && (_e1566 >= _e1567)) && (_e1568 >= _e1569));
                                                if (_e1574 || (((_e1564 <= _e1565) && (_e1566 <= _e1567)) && (_e1568 <= _e1569))) {
                                                    let _e1581 = select(-1f, 1f, _e1574);
                                                    let _e1583 = ((_e1564 - _e1565) * _e1581);
                                                    let _e1585 = select(0f, _e1583, (_e1583 > 0f));
                                                    let _e1587 = ((_e1566 - _e1567) * _e1581);
                                                    let _e1589 = select(0f, _e1587, (_e1587 > 0f));
                                                    let _e1591 = ((_e1568 - _e1569) * _e1581);
                                                    let _e1593 = select(0f, _e1591, (_e1591 > 0f));
                                                    let _e1595 = ((_e1585 + _e1589) + _e1593);
                                                    if (_e1595 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2639_ = type_25();
                                                        phi_2640_ = true;
                                                        phi_2641_ = false;
                                                    } else {
                                                        let _e1598 = select(_e1547, _e1534, (_e1534 < _e1547));
                                                        if (select(_e1560, _e1598, (_e1598 < _e1560)) > 0f) {
                                                            phi_1928_ = true;
                                                        } else {
                                                            let _e1603 = select(_e1547, _e1534, (_e1534 > _e1547));
                                                            phi_1928_ = (select(_e1560, _e1603, (_e1603 > _e1560)) < 0f);
                                                        }
                                                        let _e1608 = phi_1928_;
                                                        if _e1608 {
                                                            phi_2636_ = type_25();
                                                            phi_2637_ = true;
                                                            phi_2638_ = false;
                                                        } else {
                                                            let _e1610 = select(_e1550, _e1537, (_e1537 < _e1550));
                                                            if (select(_e1563, _e1610, (_e1610 < _e1563)) > 0f) {
                                                                phi_1957_ = true;
                                                            } else {
                                                                let _e1615 = select(_e1550, _e1537, (_e1537 > _e1550));
                                                                phi_1957_ = (select(_e1563, _e1615, (_e1615 > _e1563)) < 0f);
                                                            }
                                                            let _e1620 = phi_1957_;
                                                            if _e1620 {
                                                                phi_2634_ = type_25();
                                                                phi_2635_ = false;
                                                            } else {
                                                                let _e1622 = select(_e1523[1][0], _e1523[0][0], (_e1523[0][0] < _e1523[1][0]));
                                                                let _e1626 = select(_e1523[1][0], _e1523[0][0], (_e1523[0][0] > _e1523[1][0]));
                                                                let _e1630 = select(_e1523[1][1], _e1523[0][1], (_e1523[0][1] < _e1523[1][1]));
                                                                let _e1634 = select(_e1523[1][1], _e1523[0][1], (_e1523[0][1] > _e1523[1][1]));
                                                                let _e1638 = select(_e1523[1][2], _e1523[0][2], (_e1523[0][2] < _e1523[1][2]));
                                                                let _e1642 = select(_e1523[1][2], _e1523[0][2], (_e1523[0][2] > _e1523[1][2]));
                                                                let _e1647 = ((select(_e1523[2][0], _e1622, (_e1622 < _e1523[2][0])) - _e419) * _e424);
                                                                let _e1648 = ((select(_e1523[2][0], _e1626, (_e1626 > _e1523[2][0])) - _e420) * _e424);
                                                                let _e1651 = ((select(_e1523[2][1], _e1630, (_e1630 < _e1523[2][1])) - _e455) * _e460);
                                                                let _e1652 = ((select(_e1523[2][1], _e1634, (_e1634 > _e1523[2][1])) - _e456) * _e460);
                                                                let _e1655 = ((select(_e1523[2][2], _e1638, (_e1638 < _e1523[2][2])) - _e491) * _e496);
                                                                let _e1656 = ((select(_e1523[2][2], _e1642, (_e1642 > _e1523[2][2])) - _e492) * _e496);
                                                                let _e1658 = select(_e1656, _e1655, (_e1655 < _e1656));
                                                                let _e1660 = select(_e1656, _e1655, (_e1655 > _e1656));
                                                                let _e1662 = select(_e1648, _e1647, (_e1647 < _e1648));
                                                                let _e1664 = select(_e1652, _e1651, (_e1651 < _e1652));
                                                                let _e1666 = select(_e1664, _e1662, (_e1662 > _e1664));
                                                                let _e1668 = select(_e1658, _e1666, (_e1666 > _e1658));
                                                                let _e1670 = select(_e1648, _e1647, (_e1647 > _e1648));
                                                                let _e1672 = select(_e1652, _e1651, (_e1651 > _e1652));
                                                                let _e1674 = select(_e1672, _e1670, (_e1670 < _e1672));
                                                                let _e1676 = select(_e1660, _e1674, (_e1674 < _e1660));
                                                                let _e1677 = -(_e1658);
                                                                let _e1683 = select(_e542, _e1668, (_e1668 > _e542));
                                                                if (_e1683 > (_e1676 + (select(_e1677, _e1660, (_e1660 > _e1677)) * 0.0000019073523f))) {
                                                                    phi_2629_ = type_25();
                                                                    phi_2630_ = true;
                                                                } else {
                                                                    let _e1685 = (_e1683 > _e1094.member_1);
                                                                    if _e1685 {
                                                                        phi_2628_ = type_25();
                                                                    } else {
                                                                        let _e1686 = vec3<f32>(_e1523[0][0], _e1523[0][1], _e1523[0][2]);
                                                                        let _e1687 = vec3<f32>(_e1523[1][0], _e1523[1][1], _e1523[1][2]);
                                                                        let _e1688 = vec3<f32>(_e1523[2][0], _e1523[2][1], _e1523[2][2]);
                                                                        let _e1689 = (_e1523[1][0] - _e1523[0][0]);
                                                                        let _e1690 = (_e1523[1][1] - _e1523[0][1]);
                                                                        let _e1691 = (_e1523[1][2] - _e1523[0][2]);
                                                                        let _e1692 = vec3<f32>(_e1689, _e1690, _e1691);
                                                                        let _e1693 = (_e1523[2][0] - _e1523[1][0]);
                                                                        let _e1694 = (_e1523[2][1] - _e1523[1][1]);
                                                                        let _e1695 = (_e1523[2][2] - _e1523[1][2]);
                                                                        let _e1696 = vec3<f32>(_e1693, _e1694, _e1695);
                                                                        let _e1697 = (_e1523[0][0] - _e1523[2][0]);
                                                                        let _e1698 = (_e1523[0][1] - _e1523[2][1]);
                                                                        let _e1699 = (_e1523[0][2] - _e1523[2][2]);
                                                                        let _e1700 = vec3<f32>(_e1697, _e1698, _e1699);
                                                                        let _e1703 = bitcast<f32>((bitcast<u32>(_e1689) & 2147483647u));
                                                                        let _e1706 = bitcast<f32>((bitcast<u32>(_e1690) & 2147483647u));
                                                                        let _e1708 = select(_e1706, _e1703, (_e1703 > _e1706));
                                                                        let _e1711 = bitcast<f32>((bitcast<u32>(_e1691) & 2147483647u));
                                                                        let _e1713 = select(_e1711, _e1708, (_e1708 > _e1711));
                                                                        let _e1716 = bitcast<f32>((bitcast<u32>(_e1693) & 2147483647u));
                                                                        let _e1719 = bitcast<f32>((bitcast<u32>(_e1694) & 2147483647u));
                                                                        let _e1721 = select(_e1719, _e1716, (_e1716 > _e1719));
                                                                        let _e1724 = bitcast<f32>((bitcast<u32>(_e1695) & 2147483647u));
                                                                        let _e1726 = select(_e1724, _e1721, (_e1721 > _e1724));
                                                                        let _e1729 = bitcast<f32>((bitcast<u32>(_e1697) & 2147483647u));
                                                                        let _e1732 = bitcast<f32>((bitcast<u32>(_e1698) & 2147483647u));
                                                                        let _e1734 = select(_e1732, _e1729, (_e1729 > _e1732));
                                                                        let _e1737 = bitcast<f32>((bitcast<u32>(_e1699) & 2147483647u));
                                                                        let _e1739 = select(_e1737, _e1734, (_e1734 > _e1737));
                                                                        let _e1741 = select(_e1726, _e1713, (_e1713 > _e1726));
                                                                        let _e1743 = select(_e1739, _e1741, (_e1741 > _e1739));
                                                                        if (_e1713 == _e1743) {
                                                                            phi_2358_ = _e1550;
                                                                            phi_2359_ = _e1547;
                                                                            phi_2360_ = _e1537;
                                                                            phi_2361_ = _e1534;
                                                                            phi_2362_ = _e1686;
                                                                            phi_2363_ = _e1700;
                                                                            phi_2364_ = _e1696;
                                                                            phi_2365_ = _e1692;
                                                                        } else {
                                                                            let _e1745 = (_e1726 == _e1743);
                                                                            let _e1750 = vec3(_e1745);
                                                                            phi_2358_ = select(_e1537, _e1563, _e1745);
                                                                            phi_2359_ = select(_e1534, _e1560, _e1745);
                                                                            phi_2360_ = select(_e1563, _e1550, _e1745);
                                                                            phi_2361_ = select(_e1560, _e1547, _e1745);
                                                                            phi_2362_ = select(_e1688, _e1687, _e1750);
                                                                            phi_2363_ = select(_e1696, _e1692, _e1750);
                                                                            phi_2364_ = select(_e1692, _e1700, _e1750);
                                                                            phi_2365_ = select(_e1700, _e1696, _e1750);
                                                                        }
                                                                        let _e1756 = phi_2358_;
                                                                        let _e1758 = phi_2359_;
                                                                        let _e1760 = phi_2360_;
                                                                        let _e1762 = phi_2361_;
                                                                        let _e1764 = phi_2362_;
                                                                        let _e1766 = phi_2363_;
                                                                        let _e1768 = phi_2364_;
                                                                        let _e1770 = phi_2365_;
                                                                        let _e1777 = ((_e1768.y * _e1766.z) - (_e1766.y * _e1768.z));
                                                                        let _e1782 = ((_e1768.z * _e1766.x) - (_e1766.z * _e1768.x));
                                                                        let _e1785 = ((_e1768.x * _e1766.y) - (_e1766.x * _e1768.y));
                                                                        if (_e1585 >= _e1589) {
                                                                            phi_2396_ = select(true, false, (_e1585 >= _e1593));
                                                                        } else {
                                                                            phi_2396_ = true;
                                                                        }
                                                                        let _e1790 = phi_2396_;
                                                                        if _e1790 {
                                                                            phi_2405_ = select(_e1688, _e1687, vec3((_e1589 >= _e1593)));
                                                                        } else {
                                                                            phi_2405_ = _e1686;
                                                                        }
                                                                        let _e1795 = phi_2405_;
                                                                        let _e1800 = (((_e1777 * _e421) + (_e1782 * _e457)) + (_e1785 * _e493));
                                                                        let _e1811 = (((_e1777 * (_e1795.x - _e396)) + (_e1782 * (_e1795.y - _e433))) + (_e1785 * (_e1795.z - _e469)));
                                                                        let _e1813 = (_e1758 - _e1762);
                                                                        let _e1814 = (_e1756 - _e1760);
                                                                        let _e1822 = (-(((_e1762 * _e1813) + (_e1760 * _e1814))) / ((_e1813 * _e1813) + (_e1814 * _e1814)));
                                                                        let _e1824 = select(1f, _e1822, (_e1822 < 1f));
                                                                        let _e1826 = select(0f, _e1824, (_e1824 > 0f));
                                                                        let _e1839 = ((_e1764.x + (_e1770.x * _e1826)) - _e396);
                                                                        let _e1840 = ((_e1764.y + (_e1770.y * _e1826)) - _e433);
                                                                        let _e1841 = ((_e1764.z + (_e1770.z * _e1826)) - _e469);
                                                                        let _e1842 = (_e1841 / _e493);
                                                                        let _e1854 = bitcast<f32>((bitcast<u32>(_e1839) & 2147483647u));
                                                                        let _e1857 = bitcast<f32>((bitcast<u32>(_e1840) & 2147483647u));
                                                                        let _e1859 = select(_e1857, _e1854, (_e1854 > _e1857));
                                                                        let _e1862 = bitcast<f32>((bitcast<u32>(_e1841) & 2147483647u));
                                                                        let _e1864 = select(_e1862, _e1859, (_e1859 > _e1862));
                                                                        let _e1870 = bitcast<f32>((bitcast<u32>(_e1777) & 2147483647u));
                                                                        let _e1873 = bitcast<f32>((bitcast<u32>(_e1782) & 2147483647u));
                                                                        let _e1875 = select(_e1873, _e1870, (_e1870 > _e1873));
                                                                        let _e1878 = bitcast<f32>((bitcast<u32>(_e1785) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1777 * _e1839) + (_e1782 * _e1840)) + (_e1785 * _e1841)) - _e1811)) & 2147483647u)) <= ((0.0000009536743f * select(_e1743, _e1864, (_e1864 > _e1743))) * select(_e1878, _e1875, (_e1875 > _e1878)))) {
                                                                            let _e1888 = bitcast<f32>((bitcast<u32>(_e1768.x) & 2147483647u));
                                                                            let _e1891 = bitcast<f32>((bitcast<u32>(_e1768.y) & 2147483647u));
                                                                            let _e1893 = select(_e1891, _e1888, (_e1888 > _e1891));
                                                                            let _e1896 = bitcast<f32>((bitcast<u32>(_e1768.z) & 2147483647u));
                                                                            let _e1902 = bitcast<f32>((bitcast<u32>(_e1766.x) & 2147483647u));
                                                                            let _e1905 = bitcast<f32>((bitcast<u32>(_e1766.y) & 2147483647u));
                                                                            let _e1907 = select(_e1905, _e1902, (_e1902 > _e1905));
                                                                            let _e1910 = bitcast<f32>((bitcast<u32>(_e1766.z) & 2147483647u));
                                                                            phi_2572_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e1800) & 2147483647u)) > ((0.0000038146973f * select(_e1896, _e1893, (_e1893 > _e1896))) * select(_e1910, _e1907, (_e1907 > _e1910)))));
                                                                        } else {
                                                                            phi_2572_ = true;
                                                                        }
                                                                        let _e1917 = phi_2572_;
                                                                        if _e1917 {
                                                                            let _e1928 = ((((_e1777 * (_e1839 - (_e421 * _e1842))) + (_e1782 * (_e1840 - (_e457 * _e1842)))) + (_e1785 * (_e1841 - _e1841))) / _e1800);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1928) & 2147483647u)) <= _e1743) {
                                                                                phi_2596_ = (_e1842 + _e1928);
                                                                            } else {
                                                                                phi_2596_ = _e1842;
                                                                            }
                                                                            let _e1935 = phi_2596_;
                                                                            phi_2597_ = _e1935;
                                                                        } else {
                                                                            phi_2597_ = (_e1811 / _e1800);
                                                                        }
                                                                        let _e1937 = phi_2597_;
                                                                        let _e1939 = select(_e1676, _e1937, (_e1937 < _e1676));
                                                                        let _e1941 = select(_e1668, _e1939, (_e1939 > _e1668));
                                                                        if (_e1941 >= _e542) {
                                                                            let _e1943 = (_e1941 <= _e1094.member_1);
                                                                            if _e1943 {
                                                                                let _e1944 = (1f / _e1595);
                                                                                phi_2620_ = type_25(_e1941, (_e1589 * _e1944), (_e1593 * _e1944), _e1154);
                                                                            } else {
                                                                                phi_2620_ = type_25();
                                                                            }
                                                                            let _e1949 = phi_2620_;
                                                                            phi_2622_ = _e1949;
                                                                            phi_2623_ = select(true, false, _e1943);
                                                                        } else {
                                                                            phi_2622_ = type_25();
                                                                            phi_2623_ = true;
                                                                        }
                                                                        let _e1952 = phi_2622_;
                                                                        let _e1954 = phi_2623_;
                                                                        if _e1954 {
                                                                            phi_2627_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2627_ = _e1952;
                                                                        }
                                                                        let _e1956 = phi_2627_;
                                                                        phi_2628_ = _e1956;
                                                                    }
                                                                    let _e1958 = phi_2628_;
                                                                    phi_2629_ = _e1958;
                                                                    phi_2630_ = _e1685;
                                                                }
                                                                let _e1960 = phi_2629_;
                                                                let _e1962 = phi_2630_;
                                                                phi_2634_ = _e1960;
                                                                phi_2635_ = _e1962;
                                                            }
                                                            let _e1964 = phi_2634_;
                                                            let _e1966 = phi_2635_;
                                                            phi_2636_ = _e1964;
                                                            phi_2637_ = _e1620;
                                                            phi_2638_ = _e1966;
                                                        }
                                                        let _e1968 = phi_2636_;
                                                        let _e1970 = phi_2637_;
                                                        let _e1972 = phi_2638_;
                                                        phi_2639_ = _e1968;
                                                        phi_2640_ = _e1970;
                                                        phi_2641_ = _e1972;
                                                    }
                                                    let _e1974 = phi_2639_;
                                                    let _e1976 = phi_2640_;
                                                    let _e1978 = phi_2641_;
                                                    phi_2649_ = _e1974;
                                                    phi_2650_ = select(_e1978, true, _e1976);
                                                } else {
                                                    phi_2649_ = type_25();
                                                    phi_2650_ = true;
                                                }
                                                let _e1981 = phi_2649_;
                                                let _e1983 = phi_2650_;
                                                if _e1983 {
                                                    phi_2654_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2654_ = _e1981;
                                                }
                                                let _e1985 = phi_2654_;
                                                if (_e1985.member_3 != 4294967295u) {
                                                    if (_e1154 == _e170) {
                                                        phi_2983_ = false;
                                                    } else {
                                                        let _e1989 = (_e1154 < arrayLength((&global_5.member)));
                                                        if _e1989 {
                                                            if _e1989 {
                                                            } else {
                                                                phi_4590_ = true;
                                                                break;
                                                            }
                                                            let _e1991 = global_5.member[_e1154];
                                                            phi_2677_ = _e1991;
                                                        } else {
                                                            phi_2677_ = 4294967295u;
                                                        }
                                                        let _e1993 = phi_2677_;
                                                        let _e1994 = (_e1993 < arrayLength((&global_6.member)));
                                                        if _e1994 {
                                                            if _e1994 {
                                                            } else {
                                                                phi_4590_ = true;
                                                                break;
                                                            }
                                                            let _e1996 = global_6.member[_e1993];
                                                            phi_2691_ = _e1996;
                                                        } else {
                                                            phi_2691_ = 0i;
                                                        }
                                                        let _e1998 = phi_2691_;
                                                        let _e1999 = (_e1998 == 0i);
                                                        if _e1999 {
                                                            phi_2982_ = true;
                                                        } else {
                                                            if _e388 {
                                                                phi_2712_ = vec3<f32>(_e1523[0][0], _e1523[0][1], _e1523[0][2]);
                                                            } else {
                                                                if (_e364 == 1u) {
                                                                    phi_2711_ = vec3<f32>(_e1523[0][2], _e1523[0][0], _e1523[0][1]);
                                                                } else {
                                                                    phi_2711_ = vec3<f32>(_e1523[0][1], _e1523[0][2], _e1523[0][0]);
                                                                }
                                                                let _e2004 = phi_2711_;
                                                                phi_2712_ = _e2004;
                                                            }
                                                            let _e2007 = phi_2712_;
                                                            if _e388 {
                                                                phi_2729_ = vec3<f32>(_e1523[1][0], _e1523[1][1], _e1523[1][2]);
                                                            } else {
                                                                if (_e364 == 1u) {
                                                                    phi_2728_ = vec3<f32>(_e1523[1][2], _e1523[1][0], _e1523[1][1]);
                                                                } else {
                                                                    phi_2728_ = vec3<f32>(_e1523[1][1], _e1523[1][2], _e1523[1][0]);
                                                                }
                                                                let _e2012 = phi_2728_;
                                                                phi_2729_ = _e2012;
                                                            }
                                                            let _e2015 = phi_2729_;
                                                            if _e388 {
                                                                phi_2746_ = vec3<f32>(_e1523[2][0], _e1523[2][1], _e1523[2][2]);
                                                            } else {
                                                                if (_e364 == 1u) {
                                                                    phi_2745_ = vec3<f32>(_e1523[2][2], _e1523[2][0], _e1523[2][1]);
                                                                } else {
                                                                    phi_2745_ = vec3<f32>(_e1523[2][1], _e1523[2][2], _e1523[2][0]);
                                                                }
                                                                let _e2020 = phi_2745_;
                                                                phi_2746_ = _e2020;
                                                            }
                                                            let _e2023 = phi_2746_;
                                                            let _e2026 = (_e2015.x - _e2007.x);
                                                            let _e2029 = (_e2015.y - _e2007.y);
                                                            let _e2032 = (_e2015.z - _e2007.z);
                                                            let _e2034 = (_e2023.x - _e2007.x);
                                                            let _e2036 = (_e2023.y - _e2007.y);
                                                            let _e2038 = (_e2023.z - _e2007.z);
                                                            if (_e242.member_1 == 1u) {
                                                                phi_2782_ = (vec3<f32>(_e242.member[0], _e242.member[1], _e242.member[2]) - _e2007);
                                                            } else {
                                                                phi_2782_ = vec3<f32>(_e242.member[0], _e242.member[1], _e242.member[2]);
                                                            }
                                                            let _e2053 = phi_2782_;
                                                            let _e2059 = bitcast<f32>((bitcast<u32>((_e2026 * _e2036)) ^ _e242.member_3[0]));
                                                            let _e2063 = bitcast<f32>((bitcast<u32>((_e2029 * _e2034)) ^ _e242.member_3[0]));
                                                            let _e2067 = bitcast<f32>((bitcast<u32>((_e2029 * _e2038)) ^ _e242.member_3[0]));
                                                            let _e2071 = bitcast<f32>((bitcast<u32>((_e2032 * _e2036)) ^ _e242.member_3[0]));
                                                            let _e2075 = bitcast<f32>((bitcast<u32>((_e2032 * _e2034)) ^ _e242.member_3[0]));
                                                            let _e2079 = bitcast<f32>((bitcast<u32>((_e2026 * _e2038)) ^ _e242.member_3[0]));
                                                            let _e2080 = (_e2067 - _e2071);
                                                            let _e2081 = (_e2075 - _e2079);
                                                            let _e2082 = (_e2059 - _e2063);
                                                            let _e2106 = (bitcast<f32>((bitcast<u32>(_e2067) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2071) & 2147483647u)));
                                                            let _e2113 = (bitcast<f32>((bitcast<u32>(_e2075) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2079) & 2147483647u)));
                                                            let _e2120 = (bitcast<f32>((bitcast<u32>(_e2059) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2063) & 2147483647u)));
                                                            if (_e242.member_2 == 0f) {
                                                                phi_2964_ = 0f;
                                                            } else {
                                                                let _e2150 = bitcast<f32>((bitcast<u32>(_e2080) & 2147483647u));
                                                                let _e2153 = bitcast<f32>((bitcast<u32>(_e2081) & 2147483647u));
                                                                let _e2156 = bitcast<f32>((bitcast<u32>(_e2082) & 2147483647u));
                                                                let _e2158 = select(_e2156, _e2153, (_e2153 > _e2156));
                                                                let _e2162 = select(_e2156, _e2153, (_e2153 < _e2156));
                                                                let _e2166 = select(_e2153, _e2150, (_e2150 < _e2153));
                                                                let _e2168 = select(_e2153, _e2150, (_e2150 > _e2153));
                                                                let _e2170 = select(_e2156, _e2168, (_e2168 < _e2156));
                                                                phi_2964_ = bitcast<f32>((bitcast<u32>((_e242.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e2158, _e2150, (_e2150 > _e2158)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e2170, _e2166, (_e2166 > _e2170)))) ^ _e242.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e2162, _e2150, (_e2150 < _e2162)))) ^ _e242.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e2106 + _e2113) + _e2120))) ^ _e242.member_3[0]))) * 1.0000005f)) ^ _e242.member_3[0])))) ^ _e242.member_3[0]));
                                                            }
                                                            let _e2197 = phi_2964_;
                                                            phi_2982_ = (_e1999 || !(((((bitcast<f32>((bitcast<u32>((_e2053.x * _e2080)) ^ _e242.member_3[0])) + bitcast<f32>((bitcast<u32>((_e2053.y * _e2081)) ^ _e242.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e2053.z * _e2082)) ^ _e242.member_3[0]))) * f32(-(_e1998))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2053.x) & 2147483647u)) * _e2106)) ^ _e242.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2053.y) & 2147483647u)) * _e2113)) ^ _e242.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2053.z) & 2147483647u)) * _e2120)) ^ _e242.member_3[0]))))) ^ _e242.member_3[0])) + _e2197) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e2211 = phi_2982_;
                                                        phi_2983_ = _e2211;
                                                    }
                                                    let _e2213 = phi_2983_;
                                                    if _e2213 {
                                                        if (_e1985.member < _e1094.member.member) {
                                                            phi_3003_ = true;
                                                        } else {
                                                            if (_e1985.member == _e1094.member.member) {
                                                                phi_3002_ = (_e1985.member_3 < _e1094.member.member_3);
                                                            } else {
                                                                phi_3002_ = false;
                                                            }
                                                            let _e2223 = phi_3002_;
                                                            phi_3003_ = _e2223;
                                                        }
                                                        let _e2225 = phi_3003_;
                                                        if _e2225 {
                                                            phi_3009_ = type_42(_e1985, _e1985.member);
                                                        } else {
                                                            phi_3009_ = _e1094;
                                                        }
                                                        let _e2228 = phi_3009_;
                                                        phi_3010_ = _e2228;
                                                    } else {
                                                        phi_3010_ = _e1094;
                                                    }
                                                    let _e2230 = phi_3010_;
                                                    phi_3011_ = _e2230;
                                                } else {
                                                    phi_3011_ = _e1094;
                                                }
                                                let _e2232 = phi_3011_;
                                                phi_1093_ = _e2232;
                                            } else {
                                                phi_1093_ = type_42();
                                            }
                                            let _e2234 = phi_1093_;
                                            continue;
                                            continuing {
                                                phi_1092_ = _e2234;
                                                phi_1095_ = _e1109;
                                                phi_4590_ = _e584;
                                                break if !(_e1115);
                                            }
                                        }
                                        let _e2237 = phi_4590_;
                                        phi_4803_ = _e2237;
                                        if _e2237 {
                                            break;
                                        }
                                        phi_4807_ = _e2237;
                                        let _e2503 = local_11;
                                        phi_4251_ = _e2503;
                                        phi_4252_ = _e625;
                                        phi_4253_ = false;
                                        phi_4254_ = _e629;
                                    } else {
                                        if (_e625.member_1 >= _e102) {
                                            phi_3807_ = type_58(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_57(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_57(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e625.member_1 < _e102) {
                                            } else {
                                                phi_4803_ = true;
                                                break;
                                            }
                                            let _e642 = ((1u + _e364) % 4u);
                                            if (_e642 < 4u) {
                                            } else {
                                                phi_4803_ = true;
                                                break;
                                            }
                                            let _e647 = global_4.member[_e625.member_1][_e642];
                                            let _e649 = (_e647 >> bitcast<u32>(11u));
                                            let _e651 = ((1u + _e363) % 4u);
                                            if (_e651 < 4u) {
                                            } else {
                                                phi_4803_ = true;
                                                break;
                                            }
                                            let _e656 = global_4.member[_e625.member_1][_e651];
                                            let _e658 = (_e656 >> bitcast<u32>(11u));
                                            let _e660 = ((1u + _e365) % 4u);
                                            if (_e660 < 4u) {
                                            } else {
                                                phi_4803_ = true;
                                                break;
                                            }
                                            let _e665 = global_4.member[_e625.member_1][_e660];
                                            let _e667 = (_e665 >> bitcast<u32>(11u));
                                            let _e690 = (bitcast<f32>((bitcast<u32>((_e625.member.member_1.x - _e625.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e691 = (bitcast<f32>((bitcast<u32>((_e625.member.member_1.y - _e625.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e692 = (bitcast<f32>((bitcast<u32>((_e625.member.member_1.z - _e625.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e694 = select(_e161, _e690, (_e690 > _e161));
                                            let _e696 = select(_e161, _e691, (_e691 > _e161));
                                            let _e698 = select(_e161, _e692, (_e692 > _e161));
                                            let _e723 = bitcast<u32>((f32(bitcast<i32>((_e647 & 1023u))) * _e694));
                                            let _e728 = (bitcast<i32>((_e647 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e731 = bitcast<f32>((_e723 & bitcast<u32>(_e728)));
                                            let _e732 = bitcast<u32>((f32(bitcast<i32>((_e656 & 1023u))) * _e696));
                                            let _e737 = (bitcast<i32>((_e656 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e740 = bitcast<f32>((_e732 & bitcast<u32>(_e737)));
                                            let _e741 = bitcast<u32>((f32(bitcast<i32>((_e665 & 1023u))) * _e698));
                                            let _e746 = (bitcast<i32>((_e665 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e749 = bitcast<f32>((_e741 & bitcast<u32>(_e746)));
                                            let _e753 = bitcast<f32>((_e723 & bitcast<u32>(~(_e728))));
                                            let _e757 = bitcast<f32>((_e732 & bitcast<u32>(~(_e737))));
                                            let _e761 = bitcast<f32>((_e741 & bitcast<u32>(~(_e746))));
                                            let _e762 = bitcast<u32>((f32(bitcast<i32>((_e649 & 1023u))) * _e694));
                                            let _e767 = (bitcast<i32>((_e649 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e770 = bitcast<f32>((_e762 & bitcast<u32>(_e767)));
                                            let _e771 = bitcast<u32>((f32(bitcast<i32>((_e658 & 1023u))) * _e696));
                                            let _e776 = (bitcast<i32>((_e658 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e779 = bitcast<f32>((_e771 & bitcast<u32>(_e776)));
                                            let _e780 = bitcast<u32>((f32(bitcast<i32>((_e667 & 1023u))) * _e698));
                                            let _e785 = (bitcast<i32>((_e667 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e788 = bitcast<f32>((_e780 & bitcast<u32>(_e785)));
                                            let _e792 = bitcast<f32>((_e762 & bitcast<u32>(~(_e767))));
                                            let _e796 = bitcast<f32>((_e771 & bitcast<u32>(~(_e776))));
                                            let _e800 = bitcast<f32>((_e780 & bitcast<u32>(~(_e785))));
                                            let _e801 = (_e625.member.member.x + _e731);
                                            let _e802 = (_e625.member.member.y + _e740);
                                            let _e803 = (_e625.member.member.z + _e749);
                                            let _e806 = (_e625.member.member_1.x - _e770);
                                            let _e807 = (_e625.member.member_1.y - _e779);
                                            let _e808 = (_e625.member.member_1.z - _e788);
                                            let _e827 = (_e806 - _e801);
                                            let _e828 = (_e807 - _e802);
                                            let _e829 = (_e808 - _e803);
                                            let _e831 = select(_e828, _e827, (_e827 > _e828));
                                            let _e833 = select(_e829, _e831, (_e831 > _e829));
                                            if (_e833 < (1024f * _e161)) {
                                                phi_3508_ = 0u;
                                            } else {
                                                phi_3508_ = select(2u, 1u, (_e833 < (2097152f * _e161)));
                                            }
                                            let _e840 = phi_3508_;
                                            switch bitcast<i32>(_e840) {
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
                                            let _e843 = phi_3514_;
                                            let _e849 = global_4.member[_e625.member_1][0u];
                                            let _e853 = global_4.member[_e625.member_1][1u];
                                            let _e857 = global_4.member[_e625.member_1][2u];
                                            let _e861 = global_4.member[_e625.member_1][3u];
                                            let _e873 = (((_e853 >> bitcast<u32>(22i)) | ((_e857 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e861 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e874 = (_e849 & 268435455u);
                                            let _e875 = (_e873 & 268435455u);
                                            let _e878 = ((_e849 >> bitcast<u32>(28u)) & 7u);
                                            let _e886 = ((_e849 >> bitcast<u32>(31i)) | (((_e873 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e887 = (_e878 != 0u);
                                            if (_e878 == 0u) {
                                                phi_3769_ = _e874;
                                            } else {
                                                if (_e878 == 7u) {
                                                    phi_3768_ = 2147483648u;
                                                } else {
                                                    phi_3768_ = ((2147483648u | (_e878 << bitcast<u32>(28u))) | (_e875 & 268435455u));
                                                }
                                                let _e896 = phi_3768_;
                                                phi_3769_ = _e896;
                                            }
                                            let _e898 = phi_3769_;
                                            if _e887 {
                                                let _e899 = (_e878 != 7u);
                                                if _e899 {
                                                    phi_3779_ = (_e875 + (_e878 * ((3u * _e843) + 1u)));
                                                } else {
                                                    phi_3779_ = u32();
                                                }
                                                let _e903 = phi_3779_;
                                                phi_3781_ = _e903;
                                                phi_3782_ = select(true, false, _e899);
                                            } else {
                                                phi_3781_ = u32();
                                                phi_3782_ = true;
                                            }
                                            let _e906 = phi_3781_;
                                            let _e908 = phi_3782_;
                                            if (_e886 == 0u) {
                                                phi_3803_ = (_e874 + select(0u, 1u, !(_e887)));
                                            } else {
                                                if (_e886 == 7u) {
                                                    phi_3802_ = 2147483648u;
                                                } else {
                                                    phi_3802_ = ((2147483648u | (_e886 << bitcast<u32>(28u))) | (select(_e906, _e875, _e908) & 268435455u));
                                                }
                                                let _e921 = phi_3802_;
                                                phi_3803_ = _e921;
                                            }
                                            let _e923 = phi_3803_;
                                            phi_3807_ = type_58(array<vec4<f32>, 3>(vec4<f32>(_e801, (_e625.member.member.x + _e753), _e806, (_e625.member.member_1.x - _e792)), vec4<f32>(_e802, (_e625.member.member.y + _e757), _e807, (_e625.member.member_1.y - _e796)), vec4<f32>(_e803, (_e625.member.member.z + _e761), _e808, (_e625.member.member_1.z - _e800))), type_57(type_37((_e625.member.member + vec4<f32>(_e731, _e740, _e749, 0f)), (_e625.member.member_1 - vec4<f32>(_e770, _e779, _e788, 0f))), _e898), type_57(type_37((_e625.member.member + vec4<f32>(_e753, _e757, _e761, 0f)), (_e625.member.member_1 - vec4<f32>(_e792, _e796, _e800, 0f))), _e923));
                                        }
                                        let _e928 = phi_3807_;
                                        let _e940 = ((_e928.member[0].x - _e419) * _e424);
                                        let _e941 = ((_e928.member[0].y - _e419) * _e424);
                                        let _e942 = ((_e928.member[0].z - _e420) * _e424);
                                        let _e943 = ((_e928.member[0].w - _e420) * _e424);
                                        let _e953 = ((_e928.member[1].x - _e455) * _e460);
                                        let _e954 = ((_e928.member[1].y - _e455) * _e460);
                                        let _e955 = ((_e928.member[1].z - _e456) * _e460);
                                        let _e956 = ((_e928.member[1].w - _e456) * _e460);
                                        let _e966 = ((_e928.member[2].x - _e491) * _e496);
                                        let _e967 = ((_e928.member[2].y - _e491) * _e496);
                                        let _e968 = ((_e928.member[2].z - _e492) * _e496);
                                        let _e969 = ((_e928.member[2].w - _e492) * _e496);
                                        let _e971 = select(_e968, _e966, (_e966 < _e968));
                                        let _e973 = select(_e969, _e967, (_e967 < _e969));
                                        let _e975 = select(_e968, _e966, (_e966 > _e968));
                                        let _e977 = select(_e969, _e967, (_e967 > _e969));
                                        let _e979 = select(_e942, _e940, (_e940 < _e942));
                                        let _e981 = select(_e943, _e941, (_e941 < _e943));
                                        let _e983 = select(_e955, _e953, (_e953 < _e955));
                                        let _e985 = select(_e956, _e954, (_e954 < _e956));
                                        let _e987 = select(_e983, _e979, (_e979 > _e983));
                                        let _e989 = select(_e985, _e981, (_e981 > _e985));
                                        let _e991 = select(_e971, _e987, (_e987 > _e971));
                                        let _e993 = select(_e973, _e989, (_e989 > _e973));
                                        let _e995 = select(_e942, _e940, (_e940 > _e942));
                                        let _e997 = select(_e943, _e941, (_e941 > _e943));
                                        let _e999 = select(_e955, _e953, (_e953 > _e955));
                                        let _e1001 = select(_e956, _e954, (_e954 > _e956));
                                        let _e1003 = select(_e999, _e995, (_e995 < _e999));
                                        let _e1005 = select(_e1001, _e997, (_e997 < _e1001));
                                        let _e1010 = -(_e971);
                                        let _e1011 = -(_e973);
                                        let _e1018 = (select(_e975, _e1003, (_e1003 < _e975)) + (select(_e1010, _e975, (_e975 > _e1010)) * 0.0000019073523f));
                                        let _e1019 = (select(_e977, _e1005, (_e1005 < _e977)) + (select(_e1011, _e977, (_e977 > _e1011)) * 0.0000019073523f));
                                        let _e1021 = select(_e542, _e991, (_e991 > _e542));
                                        let _e1023 = select(_e542, _e993, (_e993 > _e542));
                                        let _e1028 = (_e1021 <= select(_e586.member_1, _e1018, (_e1018 < _e586.member_1)));
                                        let _e1029 = (_e1023 <= select(_e586.member_1, _e1019, (_e1019 < _e586.member_1)));
                                        let _e1030 = (_e1021 <= _e1023);
                                        if _e1028 {
                                            if _e1029 {
                                                if _e1030 {
                                                    phi_4151_ = _e928.member_2;
                                                } else {
                                                    phi_4151_ = _e928.member_1;
                                                }
                                                let _e1034 = phi_4151_;
                                                let _e1056 = (_e629 % 128u);
                                                let _e1057 = (_e1056 < 128u);
                                                if _e1057 {
                                                } else {
                                                    phi_4803_ = true;
                                                    break;
                                                }
                                                local_8[_e1056] = _e1034.member_1;
                                                if _e1057 {
                                                } else {
                                                    phi_4803_ = true;
                                                    break;
                                                }
                                                local_7[_e1056] = _e1034.member.member.x;
                                                if _e1057 {
                                                } else {
                                                    phi_4803_ = true;
                                                    break;
                                                }
                                                local_6[_e1056] = _e1034.member.member.y;
                                                if _e1057 {
                                                } else {
                                                    phi_4803_ = true;
                                                    break;
                                                }
                                                local_5[_e1056] = _e1034.member.member.z;
                                                if _e1057 {
                                                } else {
                                                    phi_4803_ = true;
                                                    break;
                                                }
                                                local_4[_e1056] = _e1034.member.member_1.x;
                                                if _e1057 {
                                                } else {
                                                    phi_4803_ = true;
                                                    break;
                                                }
                                                local_3[_e1056] = _e1034.member.member_1.y;
                                                if _e1057 {
                                                } else {
                                                    phi_4803_ = true;
                                                    break;
                                                }
                                                local_2[_e1056] = _e1034.member.member_1.z;
                                                if _e1057 {
                                                } else {
                                                    phi_4803_ = true;
                                                    break;
                                                }
                                                local_9[_e1056] = select(_e1023, _e1021, (_e1021 > _e1023));
                                                if _e1030 {
                                                    phi_4228_ = _e928.member_1;
                                                } else {
                                                    phi_4228_ = _e928.member_2;
                                                }
                                                let _e1070 = phi_4228_;
                                                phi_4229_ = _e1070;
                                                phi_4230_ = (_e629 + 1u);
                                            } else {
                                                phi_4229_ = type_57();
                                                phi_4230_ = u32();
                                            }
                                            let _e1072 = phi_4229_;
                                            let _e1074 = phi_4230_;
                                            phi_4232_ = _e1072;
                                            phi_4233_ = _e1074;
                                            phi_4234_ = select(true, false, _e1029);
                                        } else {
                                            phi_4232_ = type_57();
                                            phi_4233_ = u32();
                                            phi_4234_ = true;
                                        }
                                        let _e1077 = phi_4232_;
                                        let _e1079 = phi_4233_;
                                        let _e1081 = phi_4234_;
                                        if _e1081 {
                                            if _e1028 {
                                                phi_4243_ = _e928.member_1;
                                            } else {
                                                phi_4243_ = _e928.member_2;
                                            }
                                            let _e1085 = phi_4243_;
                                            phi_4248_ = _e1085;
                                            phi_4249_ = select(_e1029, true, _e1028);
                                        } else {
                                            phi_4248_ = _e1077;
                                            phi_4249_ = _e627;
                                        }
                                        let _e1088 = phi_4248_;
                                        let _e1090 = phi_4249_;
                                        phi_4807_ = _e584;
                                        phi_4251_ = _e586;
                                        phi_4252_ = _e1088;
                                        phi_4253_ = _e1090;
                                        phi_4254_ = select(_e1079, _e629, _e1081);
                                    }
                                    let _e2239 = phi_4807_;
                                    let _e2241 = phi_4251_;
                                    let _e2243 = phi_4252_;
                                    let _e2245 = phi_4253_;
                                    let _e2247 = phi_4254_;
                                    phi_4806_ = _e2239;
                                    phi_4255_ = _e2241;
                                    phi_4256_ = _e2243;
                                    phi_4257_ = (_e590 - 1u);
                                    phi_4258_ = _e2245;
                                    phi_4259_ = _e2247;
                                } else {
                                    phi_4806_ = _e584;
                                    phi_4255_ = _e586;
                                    phi_4256_ = _e625;
                                    phi_4257_ = _e590;
                                    phi_4258_ = _e627;
                                    phi_4259_ = _e629;
                                }
                                let _e2249 = phi_4806_;
                                let _e2251 = phi_4255_;
                                let _e2253 = phi_4256_;
                                let _e2255 = phi_4257_;
                                let _e2257 = phi_4258_;
                                let _e2259 = phi_4259_;
                                phi_4805_ = _e2249;
                                phi_4260_ = _e2251;
                                phi_4261_ = _e2253;
                                phi_4262_ = _e2255;
                                phi_4263_ = _e2257;
                                phi_4264_ = _e2259;
                            } else {
                                phi_4805_ = _e584;
                                phi_4260_ = type_42();
                                phi_4261_ = type_57();
                                phi_4262_ = u32();
                                phi_4263_ = bool();
                                phi_4264_ = u32();
                            }
                            let _e2261 = phi_4805_;
                            let _e2263 = phi_4260_;
                            let _e2265 = phi_4261_;
                            let _e2267 = phi_4262_;
                            let _e2269 = phi_4263_;
                            let _e2271 = phi_4264_;
                            phi_4804_ = _e2261;
                            phi_966_ = _e2263;
                            phi_969_ = _e2265;
                            phi_971_ = _e2267;
                            phi_973_ = _e2269;
                            phi_975_ = _e2271;
                            phi_4265_ = _e598;
                        } else {
                            phi_4804_ = _e584;
                            phi_966_ = type_42();
                            phi_969_ = type_57();
                            phi_971_ = u32();
                            phi_973_ = bool();
                            phi_975_ = u32();
                            phi_4265_ = false;
                        }
                        let _e2273 = phi_4804_;
                        let _e2275 = phi_966_;
                        let _e2277 = phi_969_;
                        let _e2279 = phi_971_;
                        let _e2281 = phi_973_;
                        let _e2283 = phi_975_;
                        let _e2285 = phi_4265_;
                        continue;
                        continuing {
                            phi_4596_ = _e2273;
                            phi_965_ = _e2275;
                            phi_968_ = _e2277;
                            phi_970_ = _e2279;
                            phi_972_ = _e2281;
                            phi_974_ = _e2283;
                            phi_4803_ = _e2273;
                            break if !(_e2285);
                        }
                    }
                    let _e2288 = phi_4803_;
                    if _e2288 {
                        break;
                    }
                    let _e2290 = local_10;
                    if (_e2290.member.member_3 != 4294967295u) {
                        let _e2295 = (_e366 / 3i);
                        let _e2302 = bitcast<f32>((bitcast<u32>((_e2295 + 127i)) << bitcast<u32>(23i)));
                        let _e2310 = (((_e2290.member.member * _e2302) * _e2302) * bitcast<f32>((bitcast<u32>(((_e366 - (2i * _e2295)) + 127i)) << bitcast<u32>(23i))));
                        let _e2312 = select(340282350000000000000000000000000000000f, _e2310, (_e2310 < 340282350000000000000000000000000000000f));
                        phi_4317_ = type_25(select(-340282350000000000000000000000000000000f, _e2312, (_e2312 > -340282350000000000000000000000000000000f)), _e2290.member.member_1, _e2290.member.member_2, _e2290.member.member_3);
                    } else {
                        phi_4317_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e2319 = phi_4317_;
                    if _e243 {
                    } else {
                        break;
                    }
                    global_8.member[_e149] = _e2319;
                    if _e164 {
                    } else {
                        break;
                    }
                    let _e2323 = select(0u, 1u, (_e310 <= _e320));
                    if (_e2323 > 0u) {
                        let _e2325 = (1u < _e117);
                        if _e2325 {
                            if (0u < _e117) {
                            } else {
                                break;
                            }
                            let _e2329 = atomicAdd((&global_9.member[0u]), _e2323);
                            if ((_e2329 + _e2323) < _e2329) {
                                if _e2325 {
                                } else {
                                    break;
                                }
                                let _e2334 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                    }
                    let _e2337 = select(0u, 1u, (_e2319.member_3 != 4294967295u));
                    if (_e2337 > 0u) {
                        let _e2339 = (3u < _e117);
                        if _e2339 {
                            if (2u < _e117) {
                            } else {
                                break;
                            }
                            let _e2343 = atomicAdd((&global_9.member[2u]), _e2337);
                            if ((_e2343 + _e2337) < _e2343) {
                                if _e2339 {
                                } else {
                                    break;
                                }
                                let _e2348 = atomicAdd((&global_9.member[3u]), 1u);
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
fn trace_paths_q10_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
