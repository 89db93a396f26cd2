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
    var phi_334_: u32;
    var phi_378_: i32;
    var phi_402_: type_39;
    var phi_508_: i32;
    var phi_509_: i32;
    var phi_519_: bool;
    var phi_529_: u32;
    var phi_530_: u32;
    var phi_532_: bool;
    var phi_537_: u32;
    var phi_569_: i32;
    var phi_587_: f32;
    var phi_593_: f32;
    var phi_604_: f32;
    var phi_610_: f32;
    var phi_633_: f32;
    var phi_644_: f32;
    var phi_653_: f32;
    var phi_659_: f32;
    var phi_670_: f32;
    var phi_676_: f32;
    var phi_699_: f32;
    var phi_710_: f32;
    var phi_719_: f32;
    var phi_725_: f32;
    var phi_736_: f32;
    var phi_742_: f32;
    var phi_765_: f32;
    var phi_776_: f32;
    var phi_876_: f32;
    var phi_877_: f32;
    var phi_4594_: bool;
    var phi_966_: type_42;
    var phi_969_: type_57;
    var phi_971_: u32;
    var phi_973_: bool;
    var phi_975_: u32;
    var phi_986_: bool;
    var phi_1072_: type_57;
    var phi_1073_: bool;
    var phi_1074_: u32;
    var phi_3506_: u32;
    var phi_3512_: u32;
    var phi_3766_: u32;
    var phi_3767_: u32;
    var phi_3777_: u32;
    var phi_3779_: u32;
    var phi_3780_: bool;
    var phi_3800_: u32;
    var phi_3801_: u32;
    var phi_3805_: type_58;
    var phi_4149_: type_57;
    var phi_4226_: type_57;
    var phi_4227_: type_57;
    var phi_4228_: u32;
    var phi_4230_: type_57;
    var phi_4231_: u32;
    var phi_4232_: bool;
    var phi_4241_: type_57;
    var phi_4246_: type_57;
    var phi_4247_: bool;
    var phi_1093_: type_42;
    var phi_1096_: type_8;
    var phi_1097_: type_8;
    var phi_1119_: type_8;
    var phi_1160_: u32;
    var phi_1166_: u32;
    var phi_1176_: u32;
    var phi_1192_: u32;
    var phi_1225_: u32;
    var phi_1231_: u32;
    var phi_1658_: u32;
    var phi_1676_: u32;
    var phi_1694_: u32;
    var phi_1714_: u32;
    var phi_1732_: u32;
    var phi_1750_: u32;
    var phi_1770_: u32;
    var phi_1788_: u32;
    var phi_1806_: u32;
    var phi_1384_: u32;
    var phi_1399_: u32;
    var phi_1409_: u32;
    var phi_1429_: u32;
    var phi_1449_: u32;
    var phi_1475_: u32;
    var phi_1490_: u32;
    var phi_1500_: u32;
    var phi_1520_: u32;
    var phi_1540_: u32;
    var phi_1566_: u32;
    var phi_1581_: u32;
    var phi_1591_: u32;
    var phi_1611_: u32;
    var phi_1631_: u32;
    var phi_1255_: u32;
    var phi_1298_: u32;
    var phi_1341_: u32;
    var phi_1812_: array<array<f32, 3>, 3>;
    var phi_1929_: bool;
    var phi_1958_: bool;
    var phi_2359_: f32;
    var phi_2360_: f32;
    var phi_2361_: f32;
    var phi_2362_: f32;
    var phi_2363_: vec3<f32>;
    var phi_2364_: vec3<f32>;
    var phi_2365_: vec3<f32>;
    var phi_2366_: vec3<f32>;
    var phi_2397_: bool;
    var phi_2406_: vec3<f32>;
    var phi_2571_: f32;
    var phi_2573_: f32;
    var phi_2574_: bool;
    var phi_2594_: f32;
    var phi_2595_: f32;
    var phi_2618_: type_25;
    var phi_2620_: type_25;
    var phi_2621_: bool;
    var phi_2625_: type_25;
    var phi_2626_: type_25;
    var phi_2627_: type_25;
    var phi_2628_: bool;
    var phi_2632_: type_25;
    var phi_2633_: bool;
    var phi_2634_: type_25;
    var phi_2635_: bool;
    var phi_2636_: bool;
    var phi_2637_: type_25;
    var phi_2638_: bool;
    var phi_2639_: bool;
    var phi_2647_: type_25;
    var phi_2648_: bool;
    var phi_2652_: type_25;
    var phi_2675_: u32;
    var phi_2689_: i32;
    var phi_2709_: vec3<f32>;
    var phi_2710_: vec3<f32>;
    var phi_2726_: vec3<f32>;
    var phi_2727_: vec3<f32>;
    var phi_2743_: vec3<f32>;
    var phi_2744_: vec3<f32>;
    var phi_2780_: vec3<f32>;
    var phi_2962_: f32;
    var phi_2980_: bool;
    var phi_2981_: bool;
    var phi_3000_: bool;
    var phi_3001_: bool;
    var phi_3007_: type_42;
    var phi_3008_: type_42;
    var phi_3009_: type_42;
    var phi_1094_: type_42;
    var phi_4588_: bool;
    var phi_4805_: bool;
    var phi_4249_: type_42;
    var phi_4250_: type_57;
    var phi_4251_: bool;
    var phi_4252_: u32;
    var phi_4804_: bool;
    var phi_4253_: type_42;
    var phi_4254_: type_57;
    var phi_4255_: u32;
    var phi_4256_: bool;
    var phi_4257_: u32;
    var phi_4803_: bool;
    var phi_4258_: type_42;
    var phi_4259_: type_57;
    var phi_4260_: u32;
    var phi_4261_: bool;
    var phi_4262_: u32;
    var phi_4802_: bool;
    var phi_967_: type_42;
    var phi_970_: type_57;
    var phi_972_: u32;
    var phi_974_: bool;
    var phi_976_: u32;
    var phi_4263_: bool;
    var phi_4801_: bool;
    var local_10: type_42;
    var phi_4315_: type_25;
    var local_11: type_42;

    switch bitcast<i32>(0u) {
        default: {
            let _e101 = global;
            let _e103 = arrayLength((&global_4.member));
            let _e106 = arrayLength((&global_10.member));
            let _e118 = arrayLength((&global_9.member));
            let _e122 = global_3.member[0u][0u];
            let _e126 = global_3.member[0u][1u];
            let _e130 = global_3.member[0u][2u];
            let _e134 = global_3.member[0u][3u];
            let _e138 = global_3.member[1u][0u];
            let _e142 = global_3.member[1u][1u];
            let _e146 = global_3.member[1u][2u];
            let _e150 = (_e101.x + (_e101.y * 2097152u));
            let _e162 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e134) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e122), bitcast<i32>(_e126), bitcast<i32>(_e130));
            local = array<i32, 3>(bitcast<i32>(_e138), bitcast<i32>(_e142), bitcast<i32>(_e146));
            let _e165 = (_e150 < arrayLength((&global_7.member)));
            if _e165 {
                if _e165 {
                } else {
                    break;
                }
                let _e169 = global_7.member[_e150].member_2;
                phi_334_ = _e169;
            } else {
                phi_334_ = 4294967295u;
            }
            let _e171 = phi_334_;
            let _e174 = global_1.member[0u];
            let _e178 = global_2.member[0u][0u];
            let _e182 = global_2.member[0u][1u];
            let _e186 = global_2.member[0u][2u];
            let _e190 = global_2.member[0u][3u];
            let _e194 = global_2.member[1u][0u];
            let _e198 = global_2.member[1u][1u];
            let _e202 = global_2.member[1u][2u];
            let _e206 = global_2.member[1u][3u];
            let _e207 = bitcast<f32>(_e178);
            let _e208 = bitcast<f32>(_e182);
            let _e209 = bitcast<f32>(_e186);
            let _e211 = bitcast<f32>(_e194);
            let _e212 = array<u32, 3>(_e198, _e202, _e206);
            let _e214 = bitcast<i32>(_e174);
            if (_e214 < -126i) {
                phi_378_ = -126i;
            } else {
                phi_378_ = select(_e214, 127i, (_e214 > 127i));
            }
            let _e219 = phi_378_;
            let _e224 = bitcast<f32>((bitcast<u32>((_e219 + 127i)) << bitcast<u32>(23i)));
            let _e230 = bitcast<f32>((bitcast<u32>(((_e214 - _e219) + 127i)) << bitcast<u32>(23i)));
            if (_e190 == 0u) {
                phi_402_ = type_39(array<f32, 3>(_e207, _e208, _e209), _e190, _e211, _e212);
            } else {
                phi_402_ = type_39(array<f32, 3>(((_e207 * _e224) * _e230), ((_e208 * _e224) * _e230), ((_e209 * _e224) * _e230)), _e190, ((_e211 * _e224) * _e230), _e212);
            }
            let _e243 = phi_402_;
            if _e165 {
                let _e244 = (_e150 < arrayLength((&global_8.member)));
                if _e244 {
                    if _e165 {
                    } else {
                        break;
                    }
                    let _e254 = global_7.member[_e150].member.member_2[0u];
                    let _e256 = (bitcast<u32>(_e254) & 2147483647u);
                    let _e262 = global_7.member[_e150].member.member_2[1u];
                    let _e264 = (bitcast<u32>(_e262) & 2147483647u);
                    let _e270 = global_7.member[_e150].member.member_2[2u];
                    let _e272 = (bitcast<u32>(_e270) & 2147483647u);
                    let _e278 = global_7.member[_e150].member.member[0u];
                    let _e280 = (bitcast<u32>(_e278) & 2147483647u);
                    let _e286 = global_7.member[_e150].member.member[1u];
                    let _e288 = (bitcast<u32>(_e286) & 2147483647u);
                    let _e294 = global_7.member[_e150].member.member[2u];
                    let _e296 = (bitcast<u32>(_e294) & 2147483647u);
                    let _e298 = select(_e264, _e256, (_e264 < _e256));
                    let _e300 = select(_e272, _e298, (_e272 < _e298));
                    let _e302 = select(_e280, _e300, (_e280 < _e300));
                    let _e304 = select(_e288, _e302, (_e288 < _e302));
                    let _e306 = select(_e296, _e304, (_e296 < _e304));
                    let _e311 = global_7.member[_e150].member.member_1;
                    let _e313 = (bitcast<u32>(_e311) & 2147483647u);
                    let _e321 = global_7.member[_e150].member.member_3;
                    let _e327 = (((select(_e313, _e306, (_e313 < _e306)) < 2139095040u) && ((bitcast<u32>(_e321) & 2147483647u) <= 2139095040u)) && (_e300 > 0u));
                    if _e327 {
                        let _e330 = (bitcast<u32>(bitcast<f32>(_e300)) & 2147483647u);
                        if (_e330 >= 8388608u) {
                            phi_508_ = (bitcast<i32>((_e330 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_508_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e330)), 32u, (_e330 == 0u))));
                        }
                        let _e344 = phi_508_;
                        phi_509_ = _e344;
                    } else {
                        phi_509_ = 0i;
                    }
                    let _e346 = phi_509_;
                    let _e347 = (_e256 == _e300);
                    if _e347 {
                        phi_519_ = true;
                    } else {
                        phi_519_ = (_e264 == _e300);
                    }
                    let _e350 = phi_519_;
                    let _e351 = select(1u, 0u, _e347);
                    if _e350 {
                        let _e352 = (_e351 + 1u);
                        phi_529_ = _e352;
                        phi_530_ = _e352;
                        phi_532_ = select(true, false, (_e352 == 2u));
                    } else {
                        phi_529_ = u32();
                        phi_530_ = 0u;
                        phi_532_ = true;
                    }
                    let _e356 = phi_529_;
                    let _e358 = phi_530_;
                    let _e360 = phi_532_;
                    if _e360 {
                        phi_537_ = (_e358 + 1u);
                    } else {
                        phi_537_ = 0u;
                    }
                    let _e364 = phi_537_;
                    let _e365 = select(_e356, _e358, _e360);
                    let _e366 = select(_e351, select(2u, _e351, _e350), _e360);
                    let _e367 = -(_e346);
                    if (_e367 < -126i) {
                        phi_569_ = -126i;
                    } else {
                        phi_569_ = select(_e367, 127i, (_e367 > 127i));
                    }
                    let _e372 = phi_569_;
                    let _e377 = bitcast<f32>((bitcast<u32>((_e372 + 127i)) << bitcast<u32>(23i)));
                    let _e383 = bitcast<f32>((bitcast<u32>(((_e367 - _e372) + 127i)) << bitcast<u32>(23i)));
                    let _e388 = global_7.member[_e150].member.member;
                    let _e389 = (_e365 == 0u);
                    if _e389 {
                        phi_587_ = _e388[0];
                    } else {
                        phi_587_ = _e388[1];
                    }
                    let _e393 = phi_587_;
                    let _e394 = (_e365 == 2u);
                    if _e394 {
                        phi_593_ = _e388[2];
                    } else {
                        phi_593_ = _e393;
                    }
                    let _e397 = phi_593_;
                    let _e398 = global_7.member[_e150].member.member_2;
                    if _e389 {
                        phi_604_ = _e398[0];
                    } else {
                        phi_604_ = _e398[1];
                    }
                    let _e402 = phi_604_;
                    if _e394 {
                        phi_610_ = _e398[2];
                    } else {
                        phi_610_ = _e402;
                    }
                    let _e405 = phi_610_;
                    let _e407 = ((_e405 * _e377) * _e383);
                    let _e411 = (bitcast<f32>((bitcast<u32>(_e407) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e411 {
                        let _e415 = (bitcast<f32>((bitcast<u32>(_e397) & 2147483647u)) * 0.00000011920929f);
                        phi_633_ = select(0.00000000000011368684f, _e415, (_e415 > 0.00000000000011368684f));
                    } else {
                        phi_633_ = 0f;
                    }
                    let _e419 = phi_633_;
                    let _e420 = (_e397 + _e419);
                    let _e421 = (_e397 - _e419);
                    let _e422 = select(_e407, 0f, _e411);
                    if _e411 {
                        phi_644_ = 38685626000000000000000000f;
                    } else {
                        phi_644_ = (1f / _e407);
                    }
                    let _e425 = phi_644_;
                    let _e426 = (_e364 == 0u);
                    if _e426 {
                        phi_653_ = _e388[0];
                    } else {
                        phi_653_ = _e388[1];
                    }
                    let _e430 = phi_653_;
                    let _e431 = (_e364 == 2u);
                    if _e431 {
                        phi_659_ = _e388[2];
                    } else {
                        phi_659_ = _e430;
                    }
                    let _e434 = phi_659_;
                    if _e426 {
                        phi_670_ = _e398[0];
                    } else {
                        phi_670_ = _e398[1];
                    }
                    let _e438 = phi_670_;
                    if _e431 {
                        phi_676_ = _e398[2];
                    } else {
                        phi_676_ = _e438;
                    }
                    let _e441 = phi_676_;
                    let _e443 = ((_e441 * _e377) * _e383);
                    let _e447 = (bitcast<f32>((bitcast<u32>(_e443) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e447 {
                        let _e451 = (bitcast<f32>((bitcast<u32>(_e434) & 2147483647u)) * 0.00000011920929f);
                        phi_699_ = select(0.00000000000011368684f, _e451, (_e451 > 0.00000000000011368684f));
                    } else {
                        phi_699_ = 0f;
                    }
                    let _e455 = phi_699_;
                    let _e456 = (_e434 + _e455);
                    let _e457 = (_e434 - _e455);
                    let _e458 = select(_e443, 0f, _e447);
                    if _e447 {
                        phi_710_ = 38685626000000000000000000f;
                    } else {
                        phi_710_ = (1f / _e443);
                    }
                    let _e461 = phi_710_;
                    let _e462 = (_e366 == 0u);
                    if _e462 {
                        phi_719_ = _e388[0];
                    } else {
                        phi_719_ = _e388[1];
                    }
                    let _e466 = phi_719_;
                    let _e467 = (_e366 == 2u);
                    if _e467 {
                        phi_725_ = _e388[2];
                    } else {
                        phi_725_ = _e466;
                    }
                    let _e470 = phi_725_;
                    if _e462 {
                        phi_736_ = _e398[0];
                    } else {
                        phi_736_ = _e398[1];
                    }
                    let _e474 = phi_736_;
                    if _e467 {
                        phi_742_ = _e398[2];
                    } else {
                        phi_742_ = _e474;
                    }
                    let _e477 = phi_742_;
                    let _e479 = ((_e477 * _e377) * _e383);
                    let _e483 = (bitcast<f32>((bitcast<u32>(_e479) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e483 {
                        let _e487 = (bitcast<f32>((bitcast<u32>(_e470) & 2147483647u)) * 0.00000011920929f);
                        phi_765_ = select(0.00000000000011368684f, _e487, (_e487 > 0.00000000000011368684f));
                    } else {
                        phi_765_ = 0f;
                    }
                    let _e491 = phi_765_;
                    let _e492 = (_e470 + _e491);
                    let _e493 = (_e470 - _e491);
                    let _e494 = select(_e479, 0f, _e483);
                    if _e483 {
                        phi_776_ = 38685626000000000000000000f;
                    } else {
                        phi_776_ = (1f / _e479);
                    }
                    let _e497 = phi_776_;
                    let _e500 = bitcast<f32>((bitcast<u32>(_e397) & 2147483647u));
                    let _e503 = bitcast<f32>((bitcast<u32>(_e434) & 2147483647u));
                    let _e505 = select(_e503, _e500, (_e500 > _e503));
                    let _e508 = bitcast<f32>((bitcast<u32>(_e470) & 2147483647u));
                    if (_e327 && (select(_e508, _e505, (_e505 > _e508)) <= 1099511600000f)) {
                        let _e513 = (_e346 / 3i);
                        let _e520 = bitcast<f32>((bitcast<u32>((_e513 + 127i)) << bitcast<u32>(23i)));
                        let _e527 = bitcast<f32>((bitcast<u32>(((_e346 - (2i * _e513)) + 127i)) << bitcast<u32>(23i)));
                        let _e528 = (((_e311 * _e520) * _e520) * _e527);
                        let _e530 = select(340282350000000000000000000000000000000f, _e528, (_e528 < 340282350000000000000000000000000000000f));
                        let _e535 = (((_e321 * _e520) * _e520) * _e527);
                        let _e537 = select(340282350000000000000000000000000000000f, _e535, (_e535 < 340282350000000000000000000000000000000f));
                        phi_876_ = select(-340282350000000000000000000000000000000f, _e537, (_e537 > -340282350000000000000000000000000000000f));
                        phi_877_ = select(-340282350000000000000000000000000000000f, _e530, (_e530 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_876_ = 0f;
                        phi_877_ = 1f;
                    }
                    let _e541 = phi_876_;
                    let _e543 = phi_877_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e547 = (_e365 % 3u);
                    let _e548 = (_e547 < 3u);
                    if _e548 {
                    } else {
                        break;
                    }
                    let _e550 = local_1[_e547];
                    let _e553 = (_e364 % 3u);
                    let _e554 = (_e553 < 3u);
                    if _e554 {
                    } else {
                        break;
                    }
                    let _e556 = local_1[_e553];
                    let _e559 = (_e366 % 3u);
                    let _e560 = (_e559 < 3u);
                    if _e560 {
                    } else {
                        break;
                    }
                    let _e562 = local_1[_e559];
                    if _e548 {
                    } else {
                        break;
                    }
                    let _e567 = local[_e547];
                    if _e554 {
                    } else {
                        break;
                    }
                    let _e571 = local[_e553];
                    if _e560 {
                    } else {
                        break;
                    }
                    let _e575 = local[_e559];
                    phi_4594_ = false;
                    phi_966_ = type_42(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e541);
                    phi_969_ = type_57(type_37(vec4<f32>((f32(_e550) * _e162), (f32(_e556) * _e162), (f32(_e562) * _e162), 0f), vec4<f32>((f32(_e567) * _e162), (f32(_e571) * _e162), (f32(_e575) * _e162), 0f)), select(0u, 2147483648u, (_e103 == 0u)));
                    phi_971_ = ((3u * _e103) + 1u);
                    phi_973_ = (_e543 <= _e541);
                    phi_975_ = 0u;
                    loop {
                        let _e585 = phi_4594_;
                        let _e587 = phi_966_;
                        let _e589 = phi_969_;
                        let _e591 = phi_971_;
                        let _e593 = phi_973_;
                        let _e595 = phi_975_;
                        local_10 = _e587;
                        if _e593 {
                            phi_986_ = true;
                        } else {
                            phi_986_ = (_e595 > 0u);
                        }
                        let _e598 = phi_986_;
                        if _e598 {
                            let _e599 = (_e591 > 0u);
                            if _e599 {
                                if _e593 {
                                    phi_1072_ = _e589;
                                    phi_1073_ = _e593;
                                    phi_1074_ = _e595;
                                } else {
                                    let _e600 = (_e595 - 1u);
                                    let _e601 = (_e600 % 128u);
                                    let _e602 = (_e601 < 128u);
                                    if _e602 {
                                    } else {
                                        phi_4801_ = true;
                                        break;
                                    }
                                    let _e604 = local_7[_e601];
                                    if _e602 {
                                    } else {
                                        phi_4801_ = true;
                                        break;
                                    }
                                    let _e606 = local_6[_e601];
                                    if _e602 {
                                    } else {
                                        phi_4801_ = true;
                                        break;
                                    }
                                    let _e608 = local_5[_e601];
                                    if _e602 {
                                    } else {
                                        phi_4801_ = true;
                                        break;
                                    }
                                    let _e610 = local_4[_e601];
                                    if _e602 {
                                    } else {
                                        phi_4801_ = true;
                                        break;
                                    }
                                    let _e612 = local_3[_e601];
                                    if _e602 {
                                    } else {
                                        phi_4801_ = true;
                                        break;
                                    }
                                    let _e614 = local_2[_e601];
                                    if _e602 {
                                    } else {
                                        phi_4801_ = true;
                                        break;
                                    }
                                    let _e619 = local_8[_e601];
                                    if _e602 {
                                    } else {
                                        phi_4801_ = true;
                                        break;
                                    }
                                    let _e622 = local_9[_e601];
                                    phi_1072_ = type_57(type_37(vec4<f32>(_e604, _e606, _e608, 0f), vec4<f32>(_e610, _e612, _e614, 0f)), _e619);
                                    phi_1073_ = (_e622 <= _e587.member_1);
                                    phi_1074_ = _e600;
                                }
                                let _e626 = phi_1072_;
                                let _e628 = phi_1073_;
                                let _e630 = phi_1074_;
                                if _e628 {
                                    let _e635 = (_e626.member_1 & 268435455u);
                                    if ((_e626.member_1 & 2147483648u) != 0u) {
                                        phi_1093_ = _e587;
                                        phi_1096_ = type_8(0u, ((_e626.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1095 = phi_1093_;
                                            let _e1097 = phi_1096_;
                                            local_11 = _e1095;
                                            if (_e1097.member < _e1097.member_1) {
                                                phi_1097_ = type_8((_e1097.member + 1u), _e1097.member_1);
                                                phi_1119_ = type_8(1u, _e1097.member);
                                            } else {
                                                phi_1097_ = _e1097;
                                                phi_1119_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1110 = phi_1097_;
                                            let _e1112 = phi_1119_;
                                            let _e1116 = (bitcast<i32>(_e1112.member) != 0i);
                                            if _e1116 {
                                                let _e1121 = (_e626.member.member_1.x - _e626.member.member.x);
                                                let _e1124 = (_e626.member.member_1.y - _e626.member.member.y);
                                                let _e1127 = (_e626.member.member_1.z - _e626.member.member.z);
                                                let _e1129 = select(_e1124, _e1121, (_e1121 > _e1124));
                                                let _e1131 = select(_e1127, _e1129, (_e1129 > _e1127));
                                                let _e1133 = (_e1131 < (1024f * _e162));
                                                if _e1133 {
                                                    phi_1160_ = 0u;
                                                } else {
                                                    phi_1160_ = select(2u, 1u, (_e1131 < (2097152f * _e162)));
                                                }
                                                let _e1138 = phi_1160_;
                                                switch bitcast<i32>(_e1138) {
                                                    case 0: {
                                                        phi_1166_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1166_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1166_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1166_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1141 = phi_1166_;
                                                switch bitcast<i32>(_e1138) {
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
                                                let _e1148 = phi_1176_;
                                                let _e1150 = ((_e635 + (_e1112.member_1 * ((3u * _e1141) + 1u))) + (3u * _e1148));
                                                let _e1151 = (_e1150 < _e106);
                                                if _e1151 {
                                                    if _e1151 {
                                                    } else {
                                                        phi_4588_ = true;
                                                        break;
                                                    }
                                                    let _e1153 = global_10.member[_e1150];
                                                    phi_1192_ = _e1153;
                                                } else {
                                                    phi_1192_ = 4294967295u;
                                                }
                                                let _e1155 = phi_1192_;
                                                if _e1133 {
                                                    phi_1225_ = 0u;
                                                } else {
                                                    phi_1225_ = select(2u, 1u, (_e1131 < (2097152f * _e162)));
                                                }
                                                let _e1160 = phi_1225_;
                                                switch bitcast<i32>(_e1160) {
                                                    case 0: {
                                                        phi_1231_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1231_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1231_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1231_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1163 = phi_1231_;
                                                let _e1167 = (_e635 + (_e1112.member_1 * ((3u * _e1163) + 1u)));
                                                switch bitcast<i32>(_e1160) {
                                                    case 0: {
                                                        let _e1433 = (_e1167 < _e106);
                                                        if _e1433 {
                                                            if _e1433 {
                                                            } else {
                                                                phi_4588_ = true;
                                                                break;
                                                            }
                                                            let _e1435 = global_10.member[_e1167];
                                                            phi_1255_ = _e1435;
                                                        } else {
                                                            phi_1255_ = 0u;
                                                        }
                                                        let _e1437 = phi_1255_;
                                                        let _e1439 = ((10u * _e365) & 31u);
                                                        let _e1448 = ((10u * _e364) & 31u);
                                                        let _e1457 = ((10u * _e366) & 31u);
                                                        let _e1466 = (_e1167 + 1u);
                                                        let _e1467 = (_e1466 < _e106);
                                                        if _e1467 {
                                                            if _e1467 {
                                                            } else {
                                                                phi_4588_ = true;
                                                                break;
                                                            }
                                                            let _e1469 = global_10.member[_e1466];
                                                            phi_1298_ = _e1469;
                                                        } else {
                                                            phi_1298_ = 0u;
                                                        }
                                                        let _e1471 = phi_1298_;
                                                        let _e1494 = (_e1167 + 2u);
                                                        let _e1495 = (_e1494 < _e106);
                                                        if _e1495 {
                                                            if _e1495 {
                                                            } else {
                                                                phi_4588_ = true;
                                                                break;
                                                            }
                                                            let _e1497 = global_10.member[_e1494];
                                                            phi_1341_ = _e1497;
                                                        } else {
                                                            phi_1341_ = 0u;
                                                        }
                                                        let _e1499 = phi_1341_;
                                                        phi_1812_ = array<array<f32, 3>, 3>(array<f32, 3>((_e626.member.member.x + (f32(bitcast<i32>(((_e1437 >> bitcast<u32>(_e1439)) & 1023u))) * _e162)), (_e626.member.member.y + (f32(bitcast<i32>(((_e1437 >> bitcast<u32>(_e1448)) & 1023u))) * _e162)), (_e626.member.member.z + (f32(bitcast<i32>(((_e1437 >> bitcast<u32>(_e1457)) & 1023u))) * _e162))), array<f32, 3>((_e626.member.member.x + (f32(bitcast<i32>(((_e1471 >> bitcast<u32>(_e1439)) & 1023u))) * _e162)), (_e626.member.member.y + (f32(bitcast<i32>(((_e1471 >> bitcast<u32>(_e1448)) & 1023u))) * _e162)), (_e626.member.member.z + (f32(bitcast<i32>(((_e1471 >> bitcast<u32>(_e1457)) & 1023u))) * _e162))), array<f32, 3>((_e626.member.member.x + (f32(bitcast<i32>(((_e1499 >> bitcast<u32>(_e1439)) & 1023u))) * _e162)), (_e626.member.member.y + (f32(bitcast<i32>(((_e1499 >> bitcast<u32>(_e1448)) & 1023u))) * _e162)), (_e626.member.member.z + (f32(bitcast<i32>(((_e1499 >> bitcast<u32>(_e1457)) & 1023u))) * _e162))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1256 = (_e1167 < _e106);
                                                        if _e1256 {
                                                            if _e1256 {
                                                            } else {
                                                                phi_4588_ = true;
                                                                break;
                                                            }
                                                            let _e1258 = global_10.member[_e1167];
                                                            phi_1384_ = _e1258;
                                                        } else {
                                                            phi_1384_ = 0u;
                                                        }
                                                        let _e1260 = phi_1384_;
                                                        let _e1261 = (_e1167 + 1u);
                                                        let _e1262 = (_e1261 < _e106);
                                                        if _e1262 {
                                                            if _e1262 {
                                                            } else {
                                                                phi_4588_ = true;
                                                                break;
                                                            }
                                                            let _e1264 = global_10.member[_e1261];
                                                            phi_1399_ = _e1264;
                                                        } else {
                                                            phi_1399_ = 0u;
                                                        }
                                                        let _e1266 = phi_1399_;
                                                        let _e1267 = (_e365 == 1u);
                                                        if _e1267 {
                                                            phi_1409_ = ((_e1260 >> bitcast<u32>(21i)) | (_e1266 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1409_ = (_e1266 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1276 = phi_1409_;
                                                        let _e1283 = (_e364 == 1u);
                                                        if _e1283 {
                                                            phi_1429_ = ((_e1260 >> bitcast<u32>(21i)) | (_e1266 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1429_ = (_e1266 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1292 = phi_1429_;
                                                        let _e1299 = (_e366 == 1u);
                                                        if _e1299 {
                                                            phi_1449_ = ((_e1260 >> bitcast<u32>(21i)) | (_e1266 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1449_ = (_e1266 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1308 = phi_1449_;
                                                        let _e1316 = (_e1167 + 2u);
                                                        let _e1317 = (_e1316 < _e106);
                                                        if _e1317 {
                                                            if _e1317 {
                                                            } else {
                                                                phi_4588_ = true;
                                                                break;
                                                            }
                                                            let _e1319 = global_10.member[_e1316];
                                                            phi_1475_ = _e1319;
                                                        } else {
                                                            phi_1475_ = 0u;
                                                        }
                                                        let _e1321 = phi_1475_;
                                                        let _e1322 = (_e1167 + 3u);
                                                        let _e1323 = (_e1322 < _e106);
                                                        if _e1323 {
                                                            if _e1323 {
                                                            } else {
                                                                phi_4588_ = true;
                                                                break;
                                                            }
                                                            let _e1325 = global_10.member[_e1322];
                                                            phi_1490_ = _e1325;
                                                        } else {
                                                            phi_1490_ = 0u;
                                                        }
                                                        let _e1327 = phi_1490_;
                                                        if _e1267 {
                                                            phi_1500_ = ((_e1321 >> bitcast<u32>(21i)) | (_e1327 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1500_ = (_e1327 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1336 = phi_1500_;
                                                        if _e1283 {
                                                            phi_1520_ = ((_e1321 >> bitcast<u32>(21i)) | (_e1327 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1520_ = (_e1327 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1351 = phi_1520_;
                                                        if _e1299 {
                                                            phi_1540_ = ((_e1321 >> bitcast<u32>(21i)) | (_e1327 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1540_ = (_e1327 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1366 = phi_1540_;
                                                        let _e1374 = (_e1167 + 4u);
                                                        let _e1375 = (_e1374 < _e106);
                                                        if _e1375 {
                                                            if _e1375 {
                                                            } else {
                                                                phi_4588_ = true;
                                                                break;
                                                            }
                                                            let _e1377 = global_10.member[_e1374];
                                                            phi_1566_ = _e1377;
                                                        } else {
                                                            phi_1566_ = 0u;
                                                        }
                                                        let _e1379 = phi_1566_;
                                                        let _e1380 = (_e1167 + 5u);
                                                        let _e1381 = (_e1380 < _e106);
                                                        if _e1381 {
                                                            if _e1381 {
                                                            } else {
                                                                phi_4588_ = true;
                                                                break;
                                                            }
                                                            let _e1383 = global_10.member[_e1380];
                                                            phi_1581_ = _e1383;
                                                        } else {
                                                            phi_1581_ = 0u;
                                                        }
                                                        let _e1385 = phi_1581_;
                                                        if _e1267 {
                                                            phi_1591_ = ((_e1379 >> bitcast<u32>(21i)) | (_e1385 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1591_ = (_e1385 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1394 = phi_1591_;
                                                        if _e1283 {
                                                            phi_1611_ = ((_e1379 >> bitcast<u32>(21i)) | (_e1385 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1611_ = (_e1385 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1409 = phi_1611_;
                                                        if _e1299 {
                                                            phi_1631_ = ((_e1379 >> bitcast<u32>(21i)) | (_e1385 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1631_ = (_e1385 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1424 = phi_1631_;
                                                        phi_1812_ = array<array<f32, 3>, 3>(array<f32, 3>((_e626.member.member.x + (f32(bitcast<i32>((select(_e1276, _e1260, _e389) & 2097151u))) * _e162)), (_e626.member.member.y + (f32(bitcast<i32>((select(_e1292, _e1260, _e426) & 2097151u))) * _e162)), (_e626.member.member.z + (f32(bitcast<i32>((select(_e1308, _e1260, _e462) & 2097151u))) * _e162))), array<f32, 3>((_e626.member.member.x + (f32(bitcast<i32>((select(_e1336, _e1321, _e389) & 2097151u))) * _e162)), (_e626.member.member.y + (f32(bitcast<i32>((select(_e1351, _e1321, _e426) & 2097151u))) * _e162)), (_e626.member.member.z + (f32(bitcast<i32>((select(_e1366, _e1321, _e462) & 2097151u))) * _e162))), array<f32, 3>((_e626.member.member.x + (f32(bitcast<i32>((select(_e1394, _e1379, _e389) & 2097151u))) * _e162)), (_e626.member.member.y + (f32(bitcast<i32>((select(_e1409, _e1379, _e426) & 2097151u))) * _e162)), (_e626.member.member.z + (f32(bitcast<i32>((select(_e1424, _e1379, _e462) & 2097151u))) * _e162))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1169 = (_e1167 + _e365);
                                                        let _e1170 = (_e1169 < _e106);
                                                        if _e1170 {
                                                            if _e1170 {
                                                            } else {
                                                                phi_4588_ = true;
                                                                break;
                                                            }
                                                            let _e1172 = global_10.member[_e1169];
                                                            phi_1658_ = _e1172;
                                                        } else {
                                                            phi_1658_ = 0u;
                                                        }
                                                        let _e1174 = phi_1658_;
                                                        let _e1178 = (_e1167 + _e364);
                                                        let _e1179 = (_e1178 < _e106);
                                                        if _e1179 {
                                                            if _e1179 {
                                                            } else {
                                                                phi_4588_ = true;
                                                                break;
                                                            }
                                                            let _e1181 = global_10.member[_e1178];
                                                            phi_1676_ = _e1181;
                                                        } else {
                                                            phi_1676_ = 0u;
                                                        }
                                                        let _e1183 = phi_1676_;
                                                        let _e1187 = (_e1167 + _e366);
                                                        let _e1188 = (_e1187 < _e106);
                                                        if _e1188 {
                                                            if _e1188 {
                                                            } else {
                                                                phi_4588_ = true;
                                                                break;
                                                            }
                                                            let _e1190 = global_10.member[_e1187];
                                                            phi_1694_ = _e1190;
                                                        } else {
                                                            phi_1694_ = 0u;
                                                        }
                                                        let _e1192 = phi_1694_;
                                                        let _e1197 = (_e1167 + 3u);
                                                        let _e1198 = (_e1197 + _e365);
                                                        let _e1199 = (_e1198 < _e106);
                                                        if _e1199 {
                                                            if _e1199 {
                                                            } else {
                                                                phi_4588_ = true;
                                                                break;
                                                            }
                                                            let _e1201 = global_10.member[_e1198];
                                                            phi_1714_ = _e1201;
                                                        } else {
                                                            phi_1714_ = 0u;
                                                        }
                                                        let _e1203 = phi_1714_;
                                                        let _e1207 = (_e1197 + _e364);
                                                        let _e1208 = (_e1207 < _e106);
                                                        if _e1208 {
                                                            if _e1208 {
                                                            } else {
                                                                phi_4588_ = true;
                                                                break;
                                                            }
                                                            let _e1210 = global_10.member[_e1207];
                                                            phi_1732_ = _e1210;
                                                        } else {
                                                            phi_1732_ = 0u;
                                                        }
                                                        let _e1212 = phi_1732_;
                                                        let _e1216 = (_e1197 + _e366);
                                                        let _e1217 = (_e1216 < _e106);
                                                        if _e1217 {
                                                            if _e1217 {
                                                            } else {
                                                                phi_4588_ = true;
                                                                break;
                                                            }
                                                            let _e1219 = global_10.member[_e1216];
                                                            phi_1750_ = _e1219;
                                                        } else {
                                                            phi_1750_ = 0u;
                                                        }
                                                        let _e1221 = phi_1750_;
                                                        let _e1226 = (_e1167 + 6u);
                                                        let _e1227 = (_e1226 + _e365);
                                                        let _e1228 = (_e1227 < _e106);
                                                        if _e1228 {
                                                            if _e1228 {
                                                            } else {
                                                                phi_4588_ = true;
                                                                break;
                                                            }
                                                            let _e1230 = global_10.member[_e1227];
                                                            phi_1770_ = _e1230;
                                                        } else {
                                                            phi_1770_ = 0u;
                                                        }
                                                        let _e1232 = phi_1770_;
                                                        let _e1236 = (_e1226 + _e364);
                                                        let _e1237 = (_e1236 < _e106);
                                                        if _e1237 {
                                                            if _e1237 {
                                                            } else {
                                                                phi_4588_ = true;
                                                                break;
                                                            }
                                                            let _e1239 = global_10.member[_e1236];
                                                            phi_1788_ = _e1239;
                                                        } else {
                                                            phi_1788_ = 0u;
                                                        }
                                                        let _e1241 = phi_1788_;
                                                        let _e1245 = (_e1226 + _e366);
                                                        let _e1246 = (_e1245 < _e106);
                                                        if _e1246 {
                                                            if _e1246 {
                                                            } else {
                                                                phi_4588_ = true;
                                                                break;
                                                            }
                                                            let _e1248 = global_10.member[_e1245];
                                                            phi_1806_ = _e1248;
                                                        } else {
                                                            phi_1806_ = 0u;
                                                        }
                                                        let _e1250 = phi_1806_;
                                                        phi_1812_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1174)) * _e162), (f32(bitcast<i32>(_e1183)) * _e162), (f32(bitcast<i32>(_e1192)) * _e162)), array<f32, 3>((f32(bitcast<i32>(_e1203)) * _e162), (f32(bitcast<i32>(_e1212)) * _e162), (f32(bitcast<i32>(_e1221)) * _e162)), array<f32, 3>((f32(bitcast<i32>(_e1232)) * _e162), (f32(bitcast<i32>(_e1241)) * _e162), (f32(bitcast<i32>(_e1250)) * _e162)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1812_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1524 = phi_1812_;
                                                let _e1532 = (_e1524[0][2] - _e470);
                                                let _e1535 = (((_e1524[0][0] - _e397) * _e494) - (_e1532 * _e422));
                                                let _e1538 = (((_e1524[0][1] - _e434) * _e494) - (_e1532 * _e458));
                                                let _e1545 = (_e1524[1][2] - _e470);
                                                let _e1548 = (((_e1524[1][0] - _e397) * _e494) - (_e1545 * _e422));
                                                let _e1551 = (((_e1524[1][1] - _e434) * _e494) - (_e1545 * _e458));
                                                let _e1558 = (_e1524[2][2] - _e470);
                                                let _e1561 = (((_e1524[2][0] - _e397) * _e494) - (_e1558 * _e422));
                                                let _e1564 = (((_e1524[2][1] - _e434) * _e494) - (_e1558 * _e458));
                                                let _e1565 = (_e1561 * _e1551);
                                                let _e1566 = (_e1564 * _e1548);
                                                let _e1567 = (_e1535 * _e1564);
                                                let _e1568 = (_e1538 * _e1561);
                                                let _e1569 = (_e1548 * _e1538);
                                                let _e1570 = (_e1551 * _e1535);
                                                let _e1575 = (((_e1565 >= _e1566) && (_e1567 >= _e1568)) && (_e1569 >= _e1570));
                                                if (_e1575 || (((_e1565 <= _e1566) && (_e1567 <= _e1568)) && (_e1569 <= _e1570))) {
                                                    let _e1582 = select(-1f, 1f, _e1575);
                                                    let _e1584 = ((_e1565 - _e1566) * _e1582);
                                                    let _e1586 = select(0f, _e1584, (_e1584 > 0f));
                                                    let _e1588 = ((_e1567 - _e1568) * _e1582);
                                                    let _e1590 = select(0f, _e1588, (_e1588 > 0f));
                                                    let _e1592 = ((_e1569 - _e1570) * _e1582);
                                                    let _e1594 = select(0f, _e1592, (_e1592 > 0f));
                                                    let _e1596 = ((_e1586 + _e1590) + _e1594);
                                                    if (_e1596 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2637_ = type_25();
                                                        phi_2638_ = true;
                                                        phi_2639_ = false;
                                                    } else {
                                                        let _e1599 = select(_e1548, _e1535, (_e1535 < _e1548));
                                                        if (select(_e1561, _e1599, (_e1599 < _e1561)) > 0f) {
                                                            phi_1929_ = true;
                                                        } else {
                                                            let _e1604 = select(_e1548, _e1535, (_e1535 > _e1548));
                                                            phi_1929_ = (select(_e1561, _e1604, (_e1604 > _e1561)) < 0f);
                                                        }
                                                        let _e1609 = phi_1929_;
                                                        if _e1609 {
                                                            phi_2634_ = type_25();
                                                            phi_2635_ = true;
                                                            phi_2636_ = false;
                                                        } else {
                                                            let _e1611 = select(_e1551, _e1538, (_e1538 < _e1551));
                                                            if (select(_e1564, _e1611, (_e1611 < _e1564)) > 0f) {
                                                                phi_1958_ = true;
                                                            } else {
                                                                let _e1616 = select(_e1551, _e1538, (_e1538 > _e1551));
                                                                phi_1958_ = (select(_e1564, _e1616, (_e1616 > _e1564)) < 0f);
                                                            }
                                                            let _e1621 = phi_1958_;
                                                            if _e1621 {
                                                                phi_2632_ = type_25();
                                                                phi_2633_ = false;
                                                            } else {
                                                                let _e1623 = select(_e1524[1][0], _e1524[0][0], (_e1524[0][0] < _e1524[1][0]));
                                                                let _e1627 = select(_e1524[1][0], _e1524[0][0], (_e1524[0][0] > _e1524[1][0]));
                                                                let _e1631 = select(_e1524[1][1], _e1524[0][1], (_e1524[0][1] < _e1524[1][1]));
                                                                let _e1635 = select(_e1524[1][1], _e1524[0][1], (_e1524[0][1] > _e1524[1][1]));
                                                                let _e1639 = select(_e1524[1][2], _e1524[0][2], (_e1524[0][2] < _e1524[1][2]));
                                                                let _e1643 = select(_e1524[1][2], _e1524[0][2], (_e1524[0][2] > _e1524[1][2]));
                                                                let _e1648 = ((select(_e1524[2][0], _e1623, (_e1623 < _e1524[2][0])) - _e420) * _e425);
                                                                let _e1649 = ((select(_e1524[2][0], _e1627, (_e1627 > _e1524[2][0])) - _e421) * _e425);
                                                                let _e1652 = ((select(_e1524[2][1], _e1631, (_e1631 < _e1524[2][1])) - _e456) * _e461);
                                                                let _e1653 = ((select(_e1524[2][1], _e1635, (_e1635 > _e1524[2][1])) - _e457) * _e461);
                                                                let _e1656 = ((select(_e1524[2][2], _e1639, (_e1639 < _e1524[2][2])) - _e492) * _e497);
                                                                let _e1657 = ((select(_e1524[2][2], _e1643, (_e1643 > _e1524[2][2])) - _e493) * _e497);
                                                                let _e1659 = select(_e1657, _e1656, (_e1656 < _e1657));
                                                                let _e1661 = select(_e1657, _e1656, (_e1656 > _e1657));
                                                                let _e1663 = select(_e1649, _e1648, (_e1648 < _e1649));
                                                                let _e1665 = select(_e1653, _e1652, (_e1652 < _e1653));
                                                                let _e1667 = select(_e1665, _e1663, (_e1663 > _e1665));
                                                                let _e1669 = select(_e1659, _e1667, (_e1667 > _e1659));
                                                                let _e1671 = select(_e1649, _e1648, (_e1648 > _e1649));
                                                                let _e1673 = select(_e1653, _e1652, (_e1652 > _e1653));
                                                                let _e1675 = select(_e1673, _e1671, (_e1671 < _e1673));
                                                                let _e1677 = select(_e1661, _e1675, (_e1675 < _e1661));
                                                                let _e1678 = -(_e1659);
                                                                let _e1684 = select(_e543, _e1669, (_e1669 > _e543));
                                                                if (_e1684 > (_e1677 + (select(_e1678, _e1661, (_e1661 > _e1678)) * 0.0000019073523f))) {
                                                                    phi_2627_ = type_25();
                                                                    phi_2628_ = true;
                                                                } else {
                                                                    let _e1686 = (_e1684 > _e1095.member_1);
                                                                    if _e1686 {
                                                                        phi_2626_ = type_25();
                                                                    } else {
                                                                        let _e1687 = vec3<f32>(_e1524[0][0], _e1524[0][1], _e1524[0][2]);
                                                                        let _e1688 = vec3<f32>(_e1524[1][0], _e1524[1][1], _e1524[1][2]);
                                                                        let _e1689 = vec3<f32>(_e1524[2][0], _e1524[2][1], _e1524[2][2]);
                                                                        let _e1690 = (_e1524[1][0] - _e1524[0][0]);
                                                                        let _e1691 = (_e1524[1][1] - _e1524[0][1]);
                                                                        let _e1692 = (_e1524[1][2] - _e1524[0][2]);
                                                                        let _e1693 = vec3<f32>(_e1690, _e1691, _e1692);
                                                                        let _e1694 = (_e1524[2][0] - _e1524[1][0]);
                                                                        let _e1695 = (_e1524[2][1] - _e1524[1][1]);
                                                                        let _e1696 = (_e1524[2][2] - _e1524[1][2]);
                                                                        let _e1697 = vec3<f32>(_e1694, _e1695, _e1696);
                                                                        let _e1698 = (_e1524[0][0] - _e1524[2][0]);
                                                                        let _e1699 = (_e1524[0][1] - _e1524[2][1]);
                                                                        let _e1700 = (_e1524[0][2] - _e1524[2][2]);
                                                                        let _e1701 = vec3<f32>(_e1698, _e1699, _e1700);
                                                                        let _e1704 = bitcast<f32>((bitcast<u32>(_e1690) & 2147483647u));
                                                                        let _e1707 = bitcast<f32>((bitcast<u32>(_e1691) & 2147483647u));
                                                                        let _e1709 = select(_e1707, _e1704, (_e1704 > _e1707));
                                                                        let _e1712 = bitcast<f32>((bitcast<u32>(_e1692) & 2147483647u));
                                                                        let _e1714 = select(_e1712, _e1709, (_e1709 > _e1712));
                                                                        let _e1717 = bitcast<f32>((bitcast<u32>(_e1694) & 2147483647u));
                                                                        let _e1720 = bitcast<f32>((bitcast<u32>(_e1695) & 2147483647u));
                                                                        let _e1722 = select(_e1720, _e1717, (_e1717 > _e1720));
                                                                        let _e1725 = bitcast<f32>((bitcast<u32>(_e1696) & 2147483647u));
                                                                        let _e1727 = select(_e1725, _e1722, (_e1722 > _e1725));
                                                                        let _e1730 = bitcast<f32>((bitcast<u32>(_e1698) & 2147483647u));
                                                                        let _e1733 = bitcast<f32>((bitcast<u32>(_e1699) & 2147483647u));
                                                                        let _e1735 = select(_e1733, _e1730, (_e1730 > _e1733));
                                                                        let _e1738 = bitcast<f32>((bitcast<u32>(_e1700) & 2147483647u));
                                                                        let _e1740 = select(_e1738, _e1735, (_e1735 > _e1738));
                                                                        let _e1742 = select(_e1727, _e1714, (_e1714 > _e1727));
                                                                        let _e1744 = select(_e1740, _e1742, (_e1742 > _e1740));
                                                                        if (_e1714 == _e1744) {
                                                                            phi_2359_ = _e1551;
                                                                            phi_2360_ = _e1548;
                                                                            phi_2361_ = _e1538;
                                                                            phi_2362_ = _e1535;
                                                                            phi_2363_ = _e1687;
                                                                            phi_2364_ = _e1701;
                                                                            phi_2365_ = _e1697;
                                                                            phi_2366_ = _e1693;
                                                                        } else {
                                                                            let _e1746 = (_e1727 == _e1744);
                                                                            let _e1751 = vec3(_e1746);
                                                                            phi_2359_ = select(_e1538, _e1564, _e1746);
                                                                            phi_2360_ = select(_e1535, _e1561, _e1746);
                                                                            phi_2361_ = select(_e1564, _e1551, _e1746);
                                                                            phi_2362_ = select(_e1561, _e1548, _e1746);
                                                                            phi_2363_ = select(_e1689, _e1688, _e1751);
                                                                            phi_2364_ = select(_e1697, _e1693, _e1751);
                                                                            phi_2365_ = select(_e1693, _e1701, _e1751);
                                                                            phi_2366_ = select(_e1701, _e1697, _e1751);
                                                                        }
                                                                        let _e1757 = phi_2359_;
                                                                        let _e1759 = phi_2360_;
                                                                        let _e1761 = phi_2361_;
                                                                        let _e1763 = phi_2362_;
                                                                        let _e1765 = phi_2363_;
                                                                        let _e1767 = phi_2364_;
                                                                        let _e1769 = phi_2365_;
                                                                        let _e1771 = phi_2366_;
                                                                        let _e1778 = ((_e1769.y * _e1767.z) - (_e1767.y * _e1769.z));
                                                                        let _e1783 = ((_e1769.z * _e1767.x) - (_e1767.z * _e1769.x));
                                                                        let _e1786 = ((_e1769.x * _e1767.y) - (_e1767.x * _e1769.y));
                                                                        if (_e1586 >= _e1590) {
                                                                            phi_2397_ = select(true, false, (_e1586 >= _e1594));
                                                                        } else {
                                                                            phi_2397_ = true;
                                                                        }
                                                                        let _e1791 = phi_2397_;
                                                                        if _e1791 {
                                                                            phi_2406_ = select(_e1689, _e1688, vec3((_e1590 >= _e1594)));
                                                                        } else {
                                                                            phi_2406_ = _e1687;
                                                                        }
                                                                        let _e1796 = phi_2406_;
                                                                        let _e1807 = (((_e1778 * (_e1796.x - _e397)) + (_e1783 * (_e1796.y - _e434))) + (_e1786 * (_e1796.z - _e470)));
                                                                        let _e1812 = (((_e1778 * _e422) + (_e1783 * _e458)) + (_e1786 * _e494));
                                                                        let _e1813 = (_e1759 - _e1763);
                                                                        let _e1814 = (_e1757 - _e1761);
                                                                        let _e1822 = (-(((_e1763 * _e1813) + (_e1761 * _e1814))) / ((_e1813 * _e1813) + (_e1814 * _e1814)));
                                                                        let _e1824 = select(1f, _e1822, (_e1822 < 1f));
                                                                        let _e1826 = select(0f, _e1824, (_e1824 > 0f));
                                                                        let _e1839 = ((_e1765.x + (_e1771.x * _e1826)) - _e397);
                                                                        let _e1840 = ((_e1765.y + (_e1771.y * _e1826)) - _e434);
                                                                        let _e1841 = ((_e1765.z + (_e1771.z * _e1826)) - _e470);
                                                                        let _e1842 = (_e1841 / _e494);
                                                                        let _e1854 = bitcast<f32>((bitcast<u32>(_e1839) & 2147483647u));
                                                                        let _e1857 = bitcast<f32>((bitcast<u32>(_e1840) & 2147483647u));
                                                                        let _e1859 = select(_e1857, _e1854, (_e1854 > _e1857));
                                                                        let _e1862 = bitcast<f32>((bitcast<u32>(_e1841) & 2147483647u));
                                                                        let _e1864 = select(_e1862, _e1859, (_e1859 > _e1862));
                                                                        let _e1870 = bitcast<f32>((bitcast<u32>(_e1778) & 2147483647u));
                                                                        let _e1873 = bitcast<f32>((bitcast<u32>(_e1783) & 2147483647u));
                                                                        let _e1875 = select(_e1873, _e1870, (_e1870 > _e1873));
                                                                        let _e1878 = bitcast<f32>((bitcast<u32>(_e1786) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1778 * _e1839) + (_e1783 * _e1840)) + (_e1786 * _e1841)) - _e1807)) & 2147483647u)) <= ((0.0000009536743f * select(_e1744, _e1864, (_e1864 > _e1744))) * select(_e1878, _e1875, (_e1875 > _e1878)))) {
                                                                            let _e1888 = bitcast<f32>((bitcast<u32>(_e1769.x) & 2147483647u));
                                                                            let _e1891 = bitcast<f32>((bitcast<u32>(_e1769.y) & 2147483647u));
                                                                            let _e1893 = select(_e1891, _e1888, (_e1888 > _e1891));
                                                                            let _e1896 = bitcast<f32>((bitcast<u32>(_e1769.z) & 2147483647u));
                                                                            let _e1902 = bitcast<f32>((bitcast<u32>(_e1767.x) & 2147483647u));
                                                                            let _e1905 = bitcast<f32>((bitcast<u32>(_e1767.y) & 2147483647u));
                                                                            let _e1907 = select(_e1905, _e1902, (_e1902 > _e1905));
                                                                            let _e1910 = bitcast<f32>((bitcast<u32>(_e1767.z) & 2147483647u));
                                                                            let _e1914 = (bitcast<f32>((bitcast<u32>(_e1812) & 2147483647u)) > ((0.0000038146973f * select(_e1896, _e1893, (_e1893 > _e1896))) * select(_e1910, _e1907, (_e1907 > _e1910))));
                                                                            if _e1914 {
                                                                                phi_2571_ = (_e1807 / _e1812);
                                                                            } else {
                                                                                phi_2571_ = f32();
                                                                            }
                                                                            let _e1917 = phi_2571_;
                                                                            phi_2573_ = _e1917;
                                                                            phi_2574_ = select(true, false, _e1914);
                                                                        } else {
                                                                            phi_2573_ = f32();
                                                                            phi_2574_ = true;
                                                                        }
                                                                        let _e1920 = phi_2573_;
                                                                        let _e1922 = phi_2574_;
                                                                        if _e1922 {
                                                                            let _e1930 = (((_e1778 * (_e1839 - (_e422 * _e1842))) + (_e1783 * (_e1840 - (_e458 * _e1842)))) / _e1812);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1930) & 2147483647u)) <= _e1744) {
                                                                                phi_2594_ = (_e1842 + _e1930);
                                                                            } else {
                                                                                phi_2594_ = _e1842;
                                                                            }
                                                                            let _e1937 = phi_2594_;
                                                                            phi_2595_ = _e1937;
                                                                        } else {
                                                                            phi_2595_ = _e1920;
                                                                        }
                                                                        let _e1939 = phi_2595_;
                                                                        let _e1941 = select(_e1677, _e1939, (_e1939 < _e1677));
                                                                        let _e1943 = select(_e1669, _e1941, (_e1941 > _e1669));
                                                                        if (_e1943 >= _e543) {
                                                                            let _e1945 = (_e1943 <= _e1095.member_1);
                                                                            if _e1945 {
                                                                                let _e1946 = (1f / _e1596);
                                                                                phi_2618_ = type_25(_e1943, (_e1590 * _e1946), (_e1594 * _e1946), _e1155);
                                                                            } else {
                                                                                phi_2618_ = type_25();
                                                                            }
                                                                            let _e1951 = phi_2618_;
                                                                            phi_2620_ = _e1951;
                                                                            phi_2621_ = select(true, false, _e1945);
                                                                        } else {
                                                                            phi_2620_ = type_25();
                                                                            phi_2621_ = true;
                                                                        }
                                                                        let _e1954 = phi_2620_;
                                                                        let _e1956 = phi_2621_;
                                                                        if _e1956 {
                                                                            phi_2625_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2625_ = _e1954;
                                                                        }
                                                                        let _e1958 = phi_2625_;
                                                                        phi_2626_ = _e1958;
                                                                    }
                                                                    let _e1960 = phi_2626_;
                                                                    phi_2627_ = _e1960;
                                                                    phi_2628_ = _e1686;
                                                                }
                                                                let _e1962 = phi_2627_;
                                                                let _e1964 = phi_2628_;
                                                                phi_2632_ = _e1962;
                                                                phi_2633_ = _e1964;
                                                            }
                                                            let _e1966 = phi_2632_;
                                                            let _e1968 = phi_2633_;
                                                            phi_2634_ = _e1966;
                                                            phi_2635_ = _e1621;
                                                            phi_2636_ = _e1968;
                                                        }
                                                        let _e1970 = phi_2634_;
                                                        let _e1972 = phi_2635_;
                                                        let _e1974 = phi_2636_;
                                                        phi_2637_ = _e1970;
                                                        phi_2638_ = _e1972;
                                                        phi_2639_ = _e1974;
                                                    }
                                                    let _e1976 = phi_2637_;
                                                    let _e1978 = phi_2638_;
                                                    let _e1980 = phi_2639_;
                                                    phi_2647_ = _e1976;
                                                    phi_2648_ = select(_e1980, true, _e1978);
                                                } else {
                                                    phi_2647_ = type_25();
                                                    phi_2648_ = true;
                                                }
                                                let _e1983 = phi_2647_;
                                                let _e1985 = phi_2648_;
                                                if _e1985 {
                                                    phi_2652_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2652_ = _e1983;
                                                }
                                                let _e1987 = phi_2652_;
                                                if (_e1987.member_3 != 4294967295u) {
                                                    if (_e1155 == _e171) {
                                                        phi_2981_ = false;
                                                    } else {
                                                        let _e1991 = (_e1155 < arrayLength((&global_5.member)));
                                                        if _e1991 {
                                                            if _e1991 {
                                                            } else {
                                                                phi_4588_ = true;
                                                                break;
                                                            }
                                                            let _e1993 = global_5.member[_e1155];
                                                            phi_2675_ = _e1993;
                                                        } else {
                                                            phi_2675_ = 4294967295u;
                                                        }
                                                        let _e1995 = phi_2675_;
                                                        let _e1996 = (_e1995 < arrayLength((&global_6.member)));
                                                        if _e1996 {
                                                            if _e1996 {
                                                            } else {
                                                                phi_4588_ = true;
                                                                break;
                                                            }
                                                            let _e1998 = global_6.member[_e1995];
                                                            phi_2689_ = _e1998;
                                                        } else {
                                                            phi_2689_ = 0i;
                                                        }
                                                        let _e2000 = phi_2689_;
                                                        let _e2001 = (_e2000 == 0i);
                                                        if _e2001 {
                                                            phi_2980_ = true;
                                                        } else {
                                                            if _e389 {
                                                                phi_2710_ = vec3<f32>(_e1524[0][0], _e1524[0][1], _e1524[0][2]);
                                                            } else {
                                                                if (_e365 == 1u) {
                                                                    phi_2709_ = vec3<f32>(_e1524[0][2], _e1524[0][0], _e1524[0][1]);
                                                                } else {
                                                                    phi_2709_ = vec3<f32>(_e1524[0][1], _e1524[0][2], _e1524[0][0]);
                                                                }
                                                                let _e2006 = phi_2709_;
                                                                phi_2710_ = _e2006;
                                                            }
                                                            let _e2009 = phi_2710_;
                                                            if _e389 {
                                                                phi_2727_ = vec3<f32>(_e1524[1][0], _e1524[1][1], _e1524[1][2]);
                                                            } else {
                                                                if (_e365 == 1u) {
                                                                    phi_2726_ = vec3<f32>(_e1524[1][2], _e1524[1][0], _e1524[1][1]);
                                                                } else {
                                                                    phi_2726_ = vec3<f32>(_e1524[1][1], _e1524[1][2], _e1524[1][0]);
                                                                }
                                                                let _e2014 = phi_2726_;
                                                                phi_2727_ = _e2014;
                                                            }
                                                            let _e2017 = phi_2727_;
                                                            if _e389 {
                                                                phi_2744_ = vec3<f32>(_e1524[2][0], _e1524[2][1], _e1524[2][2]);
                                                            } else {
                                                                if (_e365 == 1u) {
                                                                    phi_2743_ = vec3<f32>(_e1524[2][2], _e1524[2][0], _e1524[2][1]);
                                                                } else {
                                                                    phi_2743_ = vec3<f32>(_e1524[2][1], _e1524[2][2], _e1524[2][0]);
                                                                }
                                                                let _e2022 = phi_2743_;
                                                                phi_2744_ = _e2022;
                                                            }
                                                            let _e2025 = phi_2744_;
                                                            let _e2028 = (_e2017.x - _e2009.x);
                                                            let _e2031 = (_e2017.y - _e2009.y);
                                                            let _e2034 = (_e2017.z - _e2009.z);
                                                            let _e2036 = (_e2025.x - _e2009.x);
                                                            let _e2038 = (_e2025.y - _e2009.y);
                                                            let _e2040 = (_e2025.z - _e2009.z);
                                                            if (_e243.member_1 == 1u) {
                                                                phi_2780_ = (vec3<f32>(_e243.member[0], _e243.member[1], _e243.member[2]) - _e2009);
                                                            } else {
                                                                phi_2780_ = vec3<f32>(_e243.member[0], _e243.member[1], _e243.member[2]);
                                                            }
                                                            let _e2055 = phi_2780_;
                                                            let _e2061 = bitcast<f32>((bitcast<u32>((_e2028 * _e2038)) ^ _e243.member_3[0]));
                                                            let _e2065 = bitcast<f32>((bitcast<u32>((_e2031 * _e2036)) ^ _e243.member_3[0]));
                                                            let _e2069 = bitcast<f32>((bitcast<u32>((_e2031 * _e2040)) ^ _e243.member_3[0]));
                                                            let _e2073 = bitcast<f32>((bitcast<u32>((_e2034 * _e2038)) ^ _e243.member_3[0]));
                                                            let _e2077 = bitcast<f32>((bitcast<u32>((_e2034 * _e2036)) ^ _e243.member_3[0]));
                                                            let _e2081 = bitcast<f32>((bitcast<u32>((_e2028 * _e2040)) ^ _e243.member_3[0]));
                                                            let _e2082 = (_e2069 - _e2073);
                                                            let _e2083 = (_e2077 - _e2081);
                                                            let _e2084 = (_e2061 - _e2065);
                                                            let _e2108 = (bitcast<f32>((bitcast<u32>(_e2069) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2073) & 2147483647u)));
                                                            let _e2115 = (bitcast<f32>((bitcast<u32>(_e2077) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2081) & 2147483647u)));
                                                            let _e2122 = (bitcast<f32>((bitcast<u32>(_e2061) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2065) & 2147483647u)));
                                                            if (_e243.member_2 == 0f) {
                                                                phi_2962_ = 0f;
                                                            } else {
                                                                let _e2152 = bitcast<f32>((bitcast<u32>(_e2082) & 2147483647u));
                                                                let _e2155 = bitcast<f32>((bitcast<u32>(_e2083) & 2147483647u));
                                                                let _e2158 = bitcast<f32>((bitcast<u32>(_e2084) & 2147483647u));
                                                                let _e2160 = select(_e2158, _e2155, (_e2155 > _e2158));
                                                                let _e2164 = select(_e2158, _e2155, (_e2155 < _e2158));
                                                                let _e2168 = select(_e2155, _e2152, (_e2152 < _e2155));
                                                                let _e2170 = select(_e2155, _e2152, (_e2152 > _e2155));
                                                                let _e2172 = select(_e2158, _e2170, (_e2170 < _e2158));
                                                                phi_2962_ = bitcast<f32>((bitcast<u32>((_e243.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e2160, _e2152, (_e2152 > _e2160)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e2172, _e2168, (_e2168 > _e2172)))) ^ _e243.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e2164, _e2152, (_e2152 < _e2164)))) ^ _e243.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e2108 + _e2115) + _e2122))) ^ _e243.member_3[0]))) * 1.0000005f)) ^ _e243.member_3[0])))) ^ _e243.member_3[0]));
                                                            }
                                                            let _e2199 = phi_2962_;
                                                            phi_2980_ = (_e2001 || !(((((bitcast<f32>((bitcast<u32>((_e2055.x * _e2082)) ^ _e243.member_3[0])) + bitcast<f32>((bitcast<u32>((_e2055.y * _e2083)) ^ _e243.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e2055.z * _e2084)) ^ _e243.member_3[0]))) * f32(-(_e2000))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2055.x) & 2147483647u)) * _e2108)) ^ _e243.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2055.y) & 2147483647u)) * _e2115)) ^ _e243.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2055.z) & 2147483647u)) * _e2122)) ^ _e243.member_3[0]))))) ^ _e243.member_3[0])) + _e2199) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e2213 = phi_2980_;
                                                        phi_2981_ = _e2213;
                                                    }
                                                    let _e2215 = phi_2981_;
                                                    if _e2215 {
                                                        if (_e1987.member < _e1095.member.member) {
                                                            phi_3001_ = true;
                                                        } else {
                                                            if (_e1987.member == _e1095.member.member) {
                                                                phi_3000_ = (_e1987.member_3 < _e1095.member.member_3);
                                                            } else {
                                                                phi_3000_ = false;
                                                            }
                                                            let _e2225 = phi_3000_;
                                                            phi_3001_ = _e2225;
                                                        }
                                                        let _e2227 = phi_3001_;
                                                        if _e2227 {
                                                            phi_3007_ = type_42(_e1987, _e1987.member);
                                                        } else {
                                                            phi_3007_ = _e1095;
                                                        }
                                                        let _e2230 = phi_3007_;
                                                        phi_3008_ = _e2230;
                                                    } else {
                                                        phi_3008_ = _e1095;
                                                    }
                                                    let _e2232 = phi_3008_;
                                                    phi_3009_ = _e2232;
                                                } else {
                                                    phi_3009_ = _e1095;
                                                }
                                                let _e2234 = phi_3009_;
                                                phi_1094_ = _e2234;
                                            } else {
                                                phi_1094_ = type_42();
                                            }
                                            let _e2236 = phi_1094_;
                                            continue;
                                            continuing {
                                                phi_1093_ = _e2236;
                                                phi_1096_ = _e1110;
                                                phi_4588_ = _e585;
                                                break if !(_e1116);
                                            }
                                        }
                                        let _e2239 = phi_4588_;
                                        phi_4801_ = _e2239;
                                        if _e2239 {
                                            break;
                                        }
                                        phi_4805_ = _e2239;
                                        let _e2507 = local_11;
                                        phi_4249_ = _e2507;
                                        phi_4250_ = _e626;
                                        phi_4251_ = false;
                                        phi_4252_ = _e630;
                                    } else {
                                        if (_e626.member_1 >= _e103) {
                                            phi_3805_ = type_58(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_57(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_57(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e626.member_1 < _e103) {
                                            } else {
                                                phi_4801_ = true;
                                                break;
                                            }
                                            let _e643 = ((1u + _e365) % 4u);
                                            if (_e643 < 4u) {
                                            } else {
                                                phi_4801_ = true;
                                                break;
                                            }
                                            let _e648 = global_4.member[_e626.member_1][_e643];
                                            let _e650 = (_e648 >> bitcast<u32>(11u));
                                            let _e652 = ((1u + _e364) % 4u);
                                            if (_e652 < 4u) {
                                            } else {
                                                phi_4801_ = true;
                                                break;
                                            }
                                            let _e657 = global_4.member[_e626.member_1][_e652];
                                            let _e659 = (_e657 >> bitcast<u32>(11u));
                                            let _e661 = ((1u + _e366) % 4u);
                                            if (_e661 < 4u) {
                                            } else {
                                                phi_4801_ = true;
                                                break;
                                            }
                                            let _e666 = global_4.member[_e626.member_1][_e661];
                                            let _e668 = (_e666 >> bitcast<u32>(11u));
                                            let _e691 = (bitcast<f32>((bitcast<u32>((_e626.member.member_1.x - _e626.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e692 = (bitcast<f32>((bitcast<u32>((_e626.member.member_1.y - _e626.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e693 = (bitcast<f32>((bitcast<u32>((_e626.member.member_1.z - _e626.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e695 = select(_e162, _e691, (_e691 > _e162));
                                            let _e697 = select(_e162, _e692, (_e692 > _e162));
                                            let _e699 = select(_e162, _e693, (_e693 > _e162));
                                            let _e724 = bitcast<u32>((f32(bitcast<i32>((_e648 & 1023u))) * _e695));
                                            let _e729 = (bitcast<i32>((_e648 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e732 = bitcast<f32>((_e724 & bitcast<u32>(_e729)));
                                            let _e733 = bitcast<u32>((f32(bitcast<i32>((_e657 & 1023u))) * _e697));
                                            let _e738 = (bitcast<i32>((_e657 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e741 = bitcast<f32>((_e733 & bitcast<u32>(_e738)));
                                            let _e742 = bitcast<u32>((f32(bitcast<i32>((_e666 & 1023u))) * _e699));
                                            let _e747 = (bitcast<i32>((_e666 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e750 = bitcast<f32>((_e742 & bitcast<u32>(_e747)));
                                            let _e754 = bitcast<f32>((_e724 & bitcast<u32>(~(_e729))));
                                            let _e758 = bitcast<f32>((_e733 & bitcast<u32>(~(_e738))));
                                            let _e762 = bitcast<f32>((_e742 & bitcast<u32>(~(_e747))));
                                            let _e763 = bitcast<u32>((f32(bitcast<i32>((_e650 & 1023u))) * _e695));
                                            let _e768 = (bitcast<i32>((_e650 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e771 = bitcast<f32>((_e763 & bitcast<u32>(_e768)));
                                            let _e772 = bitcast<u32>((f32(bitcast<i32>((_e659 & 1023u))) * _e697));
                                            let _e777 = (bitcast<i32>((_e659 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e780 = bitcast<f32>((_e772 & bitcast<u32>(_e777)));
                                            let _e781 = bitcast<u32>((f32(bitcast<i32>((_e668 & 1023u))) * _e699));
                                            let _e786 = (bitcast<i32>((_e668 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e789 = bitcast<f32>((_e781 & bitcast<u32>(_e786)));
                                            let _e793 = bitcast<f32>((_e763 & bitcast<u32>(~(_e768))));
                                            let _e797 = bitcast<f32>((_e772 & bitcast<u32>(~(_e777))));
                                            let _e801 = bitcast<f32>((_e781 & bitcast<u32>(~(_e786))));
                                            let _e802 = (_e626.member.member.x + _e732);
                                            let _e803 = (_e626.member.member.y + _e741);
                                            let _e804 = (_e626.member.member.z + _e750);
                                            let _e807 = (_e626.member.member_1.x - _e771);
                                            let _e808 = (_e626.member.member_1.y - _e780);
                                            let _e809 = (_e626.member.member_1.z - _e789);
                                            let _e828 = (_e807 - _e802);
                                            let _e829 = (_e808 - _e803);
                                            let _e830 = (_e809 - _e804);
                                            let _e832 = select(_e829, _e828, (_e828 > _e829));
                                            let _e834 = select(_e830, _e832, (_e832 > _e830));
                                            if (_e834 < (1024f * _e162)) {
                                                phi_3506_ = 0u;
                                            } else {
                                                phi_3506_ = select(2u, 1u, (_e834 < (2097152f * _e162)));
                                            }
                                            let _e841 = phi_3506_;
                                            switch bitcast<i32>(_e841) {
                                                case 0: {
                                                    phi_3512_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3512_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3512_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3512_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e844 = phi_3512_;
                                            let _e850 = global_4.member[_e626.member_1][0u];
                                            let _e854 = global_4.member[_e626.member_1][1u];
                                            let _e858 = global_4.member[_e626.member_1][2u];
                                            let _e862 = global_4.member[_e626.member_1][3u];
                                            let _e874 = (((_e854 >> bitcast<u32>(22i)) | ((_e858 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e862 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e875 = (_e850 & 268435455u);
                                            let _e876 = (_e874 & 268435455u);
                                            let _e879 = ((_e850 >> bitcast<u32>(28u)) & 7u);
                                            let _e887 = ((_e850 >> bitcast<u32>(31i)) | (((_e874 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e888 = (_e879 != 0u);
                                            if (_e879 == 0u) {
                                                phi_3767_ = _e875;
                                            } else {
                                                if (_e879 == 7u) {
                                                    phi_3766_ = 2147483648u;
                                                } else {
                                                    phi_3766_ = ((2147483648u | (_e879 << bitcast<u32>(28u))) | (_e876 & 268435455u));
                                                }
                                                let _e897 = phi_3766_;
                                                phi_3767_ = _e897;
                                            }
                                            let _e899 = phi_3767_;
                                            if _e888 {
                                                let _e900 = (_e879 != 7u);
                                                if _e900 {
                                                    phi_3777_ = (_e876 + (_e879 * ((3u * _e844) + 1u)));
                                                } else {
                                                    phi_3777_ = u32();
                                                }
                                                let _e904 = phi_3777_;
                                                phi_3779_ = _e904;
                                                phi_3780_ = select(true, false, _e900);
                                            } else {
                                                phi_3779_ = u32();
                                                phi_3780_ = true;
                                            }
                                            let _e907 = phi_3779_;
                                            let _e909 = phi_3780_;
                                            if (_e887 == 0u) {
                                                phi_3801_ = (_e875 + select(0u, 1u, !(_e888)));
                                            } else {
                                                if (_e887 == 7u) {
                                                    phi_3800_ = 2147483648u;
                                                } else {
                                                    phi_3800_ = ((2147483648u | (_e887 << bitcast<u32>(28u))) | (select(_e907, _e876, _e909) & 268435455u));
                                                }
                                                let _e922 = phi_3800_;
                                                phi_3801_ = _e922;
                                            }
                                            let _e924 = phi_3801_;
                                            phi_3805_ = type_58(array<vec4<f32>, 3>(vec4<f32>(_e802, (_e626.member.member.x + _e754), _e807, (_e626.member.member_1.x - _e793)), vec4<f32>(_e803, (_e626.member.member.y + _e758), _e808, (_e626.member.member_1.y - _e797)), vec4<f32>(_e804, (_e626.member.member.z + _e762), _e809, (_e626.member.member_1.z - _e801))), type_57(type_37((_e626.member.member + vec4<f32>(_e732, _e741, _e750, 0f)), (_e626.member.member_1 - vec4<f32>(_e771, _e780, _e789, 0f))), _e899), type_57(type_37((_e626.member.member + vec4<f32>(_e754, _e758, _e762, 0f)), (_e626.member.member_1 - vec4<f32>(_e793, _e797, _e801, 0f))), _e924));
                                        }
                                        let _e929 = phi_3805_;
                                        let _e941 = ((_e929.member[0].x - _e420) * _e425);
                                        let _e942 = ((_e929.member[0].y - _e420) * _e425);
                                        let _e943 = ((_e929.member[0].z - _e421) * _e425);
                                        let _e944 = ((_e929.member[0].w - _e421) * _e425);
                                        let _e954 = ((_e929.member[1].x - _e456) * _e461);
                                        let _e955 = ((_e929.member[1].y - _e456) * _e461);
                                        let _e956 = ((_e929.member[1].z - _e457) * _e461);
                                        let _e957 = ((_e929.member[1].w - _e457) * _e461);
                                        let _e967 = ((_e929.member[2].x - _e492) * _e497);
                                        let _e968 = ((_e929.member[2].y - _e492) * _e497);
                                        let _e969 = ((_e929.member[2].z - _e493) * _e497);
                                        let _e970 = ((_e929.member[2].w - _e493) * _e497);
                                        let _e972 = select(_e969, _e967, (_e967 < _e969));
                                        let _e974 = select(_e970, _e968, (_e968 < _e970));
                                        let _e976 = select(_e969, _e967, (_e967 > _e969));
                                        let _e978 = select(_e970, _e968, (_e968 > _e970));
                                        let _e980 = select(_e943, _e941, (_e941 < _e943));
                                        let _e982 = select(_e944, _e942, (_e942 < _e944));
                                        let _e984 = select(_e956, _e954, (_e954 < _e956));
                                        let _e986 = select(_e957, _e955, (_e955 < _e957));
                                        let _e988 = select(_e984, _e980, (_e980 > _e984));
                                        let _e990 = select(_e986, _e982, (_e982 > _e986));
                                        let _e992 = select(_e972, _e988, (_e988 > _e972));
                                        let _e994 = select(_e974, _e990, (_e990 > _e974));
                                        let _e996 = select(_e943, _e941, (_e941 > _e943));
                                        let _e998 = select(_e944, _e942, (_e942 > _e944));
                                        let _e1000 = select(_e956, _e954, (_e954 > _e956));
                                        let _e1002 = select(_e957, _e955, (_e955 > _e957));
                                        let _e1004 = select(_e1000, _e996, (_e996 < _e1000));
                                        let _e1006 = select(_e1002, _e998, (_e998 < _e1002));
                                        let _e1011 = -(_e972);
                                        let _e1012 = -(_e974);
                                        let _e1019 = (select(_e976, _e1004, (_e1004 < _e976)) + (select(_e1011, _e976, (_e976 > _e1011)) * 0.0000019073523f));
                                        let _e1020 = (select(_e978, _e1006, (_e1006 < _e978)) + (select(_e1012, _e978, (_e978 > _e1012)) * 0.0000019073523f));
                                        let _e1022 = select(_e543, _e992, (_e992 > _e543));
                                        let _e1024 = select(_e543, _e994, (_e994 > _e543));
                                        let _e1029 = (_e1022 <= select(_e587.member_1, _e1019, (_e1019 < _e587.member_1)));
                                        let _e1030 = (_e1024 <= select(_e587.member_1, _e1020, (_e1020 < _e587.member_1)));
                                        let _e1031 = (_e1022 <= _e1024);
                                        if _e1029 {
                                            if _e1030 {
                                                if _e1031 {
                                                    phi_4149_ = _e929.member_2;
                                                } else {
                                                    phi_4149_ = _e929.member_1;
                                                }
                                                let _e1035 = phi_4149_;
                                                let _e1057 = (_e630 % 128u);
                                                let _e1058 = (_e1057 < 128u);
                                                if _e1058 {
                                                } else {
                                                    phi_4801_ = true;
                                                    break;
                                                }
                                                local_8[_e1057] = _e1035.member_1;
                                                if _e1058 {
                                                } else {
                                                    phi_4801_ = true;
                                                    break;
                                                }
                                                local_7[_e1057] = _e1035.member.member.x;
                                                if _e1058 {
                                                } else {
                                                    phi_4801_ = true;
                                                    break;
                                                }
                                                local_6[_e1057] = _e1035.member.member.y;
                                                if _e1058 {
                                                } else {
                                                    phi_4801_ = true;
                                                    break;
                                                }
                                                local_5[_e1057] = _e1035.member.member.z;
                                                if _e1058 {
                                                } else {
                                                    phi_4801_ = true;
                                                    break;
                                                }
                                                local_4[_e1057] = _e1035.member.member_1.x;
                                                if _e1058 {
                                                } else {
                                                    phi_4801_ = true;
                                                    break;
                                                }
                                                local_3[_e1057] = _e1035.member.member_1.y;
                                                if _e1058 {
                                                } else {
                                                    phi_4801_ = true;
                                                    break;
                                                }
                                                local_2[_e1057] = _e1035.member.member_1.z;
                                                if _e1058 {
                                                } else {
                                                    phi_4801_ = true;
                                                    break;
                                                }
                                                local_9[_e1057] = select(_e1024, _e1022, (_e1022 > _e1024));
                                                if _e1031 {
                                                    phi_4226_ = _e929.member_1;
                                                } else {
                                                    phi_4226_ = _e929.member_2;
                                                }
                                                let _e1071 = phi_4226_;
                                                phi_4227_ = _e1071;
                                                phi_4228_ = (_e630 + 1u);
                                            } else {
                                                phi_4227_ = type_57();
                                                phi_4228_ = u32();
                                            }
                                            let _e1073 = phi_4227_;
                                            let _e1075 = phi_4228_;
                                            phi_4230_ = _e1073;
                                            phi_4231_ = _e1075;
                                            phi_4232_ = select(true, false, _e1030);
                                        } else {
                                            phi_4230_ = type_57();
                                            phi_4231_ = u32();
                                            phi_4232_ = true;
                                        }
                                        let _e1078 = phi_4230_;
                                        let _e1080 = phi_4231_;
                                        let _e1082 = phi_4232_;
                                        if _e1082 {
                                            if _e1029 {
                                                phi_4241_ = _e929.member_1;
                                            } else {
                                                phi_4241_ = _e929.member_2;
                                            }
                                            let _e1086 = phi_4241_;
                                            phi_4246_ = _e1086;
                                            phi_4247_ = select(_e1030, true, _e1029);
                                        } else {
                                            phi_4246_ = _e1078;
                                            phi_4247_ = _e628;
                                        }
                                        let _e1089 = phi_4246_;
                                        let _e1091 = phi_4247_;
                                        phi_4805_ = _e585;
                                        phi_4249_ = _e587;
                                        phi_4250_ = _e1089;
                                        phi_4251_ = _e1091;
                                        phi_4252_ = select(_e1080, _e630, _e1082);
                                    }
                                    let _e2241 = phi_4805_;
                                    let _e2243 = phi_4249_;
                                    let _e2245 = phi_4250_;
                                    let _e2247 = phi_4251_;
                                    let _e2249 = phi_4252_;
                                    phi_4804_ = _e2241;
                                    phi_4253_ = _e2243;
                                    phi_4254_ = _e2245;
                                    phi_4255_ = (_e591 - 1u);
                                    phi_4256_ = _e2247;
                                    phi_4257_ = _e2249;
                                } else {
                                    phi_4804_ = _e585;
                                    phi_4253_ = _e587;
                                    phi_4254_ = _e626;
                                    phi_4255_ = _e591;
                                    phi_4256_ = _e628;
                                    phi_4257_ = _e630;
                                }
                                let _e2251 = phi_4804_;
                                let _e2253 = phi_4253_;
                                let _e2255 = phi_4254_;
                                let _e2257 = phi_4255_;
                                let _e2259 = phi_4256_;
                                let _e2261 = phi_4257_;
                                phi_4803_ = _e2251;
                                phi_4258_ = _e2253;
                                phi_4259_ = _e2255;
                                phi_4260_ = _e2257;
                                phi_4261_ = _e2259;
                                phi_4262_ = _e2261;
                            } else {
                                phi_4803_ = _e585;
                                phi_4258_ = type_42();
                                phi_4259_ = type_57();
                                phi_4260_ = u32();
                                phi_4261_ = bool();
                                phi_4262_ = u32();
                            }
                            let _e2263 = phi_4803_;
                            let _e2265 = phi_4258_;
                            let _e2267 = phi_4259_;
                            let _e2269 = phi_4260_;
                            let _e2271 = phi_4261_;
                            let _e2273 = phi_4262_;
                            phi_4802_ = _e2263;
                            phi_967_ = _e2265;
                            phi_970_ = _e2267;
                            phi_972_ = _e2269;
                            phi_974_ = _e2271;
                            phi_976_ = _e2273;
                            phi_4263_ = _e599;
                        } else {
                            phi_4802_ = _e585;
                            phi_967_ = type_42();
                            phi_970_ = type_57();
                            phi_972_ = u32();
                            phi_974_ = bool();
                            phi_976_ = u32();
                            phi_4263_ = false;
                        }
                        let _e2275 = phi_4802_;
                        let _e2277 = phi_967_;
                        let _e2279 = phi_970_;
                        let _e2281 = phi_972_;
                        let _e2283 = phi_974_;
                        let _e2285 = phi_976_;
                        let _e2287 = phi_4263_;
                        continue;
                        continuing {
                            phi_4594_ = _e2275;
                            phi_966_ = _e2277;
                            phi_969_ = _e2279;
                            phi_971_ = _e2281;
                            phi_973_ = _e2283;
                            phi_975_ = _e2285;
                            phi_4801_ = _e2275;
                            break if !(_e2287);
                        }
                    }
                    let _e2290 = phi_4801_;
                    if _e2290 {
                        break;
                    }
                    let _e2292 = local_10;
                    if (_e2292.member.member_3 != 4294967295u) {
                        let _e2297 = (_e367 / 3i);
                        let _e2304 = bitcast<f32>((bitcast<u32>((_e2297 + 127i)) << bitcast<u32>(23i)));
                        let _e2312 = (((_e2292.member.member * _e2304) * _e2304) * bitcast<f32>((bitcast<u32>(((_e367 - (2i * _e2297)) + 127i)) << bitcast<u32>(23i))));
                        let _e2314 = select(340282350000000000000000000000000000000f, _e2312, (_e2312 < 340282350000000000000000000000000000000f));
                        phi_4315_ = type_25(select(-340282350000000000000000000000000000000f, _e2314, (_e2314 > -340282350000000000000000000000000000000f)), _e2292.member.member_1, _e2292.member.member_2, _e2292.member.member_3);
                    } else {
                        phi_4315_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e2321 = phi_4315_;
                    if _e244 {
                    } else {
                        break;
                    }
                    global_8.member[_e150] = _e2321;
                    if _e165 {
                    } else {
                        break;
                    }
                    let _e2325 = select(0u, 1u, (_e311 <= _e321));
                    if (_e2325 > 0u) {
                        let _e2327 = (1u < _e118);
                        if _e2327 {
                            if (0u < _e118) {
                            } else {
                                break;
                            }
                            let _e2331 = atomicAdd((&global_9.member[0u]), _e2325);
                            if ((_e2331 + _e2325) < _e2331) {
                                if _e2327 {
                                } else {
                                    break;
                                }
                                let _e2336 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                    }
                    let _e2339 = select(0u, 1u, (_e2321.member_3 != 4294967295u));
                    if (_e2339 > 0u) {
                        let _e2341 = (3u < _e118);
                        if _e2341 {
                            if (2u < _e118) {
                            } else {
                                break;
                            }
                            let _e2345 = atomicAdd((&global_9.member[2u]), _e2339);
                            if ((_e2345 + _e2339) < _e2345) {
                                if _e2341 {
                                } else {
                                    break;
                                }
                                let _e2350 = atomicAdd((&global_9.member[3u]), 1u);
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
