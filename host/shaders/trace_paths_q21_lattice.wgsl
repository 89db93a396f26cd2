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
    var phi_334_: u32;
    var phi_378_: i32;
    var phi_402_: type_35;
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
    var phi_966_: type_38;
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
    var phi_1093_: type_38;
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
    var phi_2618_: type_21;
    var phi_2620_: type_21;
    var phi_2621_: bool;
    var phi_2625_: type_21;
    var phi_2626_: type_21;
    var phi_2627_: type_21;
    var phi_2628_: bool;
    var phi_2632_: type_21;
    var phi_2633_: bool;
    var phi_2634_: type_21;
    var phi_2635_: bool;
    var phi_2636_: bool;
    var phi_2637_: type_21;
    var phi_2638_: bool;
    var phi_2639_: bool;
    var phi_2647_: type_21;
    var phi_2648_: bool;
    var phi_2652_: type_21;
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
    var phi_3007_: type_38;
    var phi_3008_: type_38;
    var phi_3009_: type_38;
    var phi_1094_: type_38;
    var phi_4588_: bool;
    var phi_4805_: bool;
    var phi_4249_: type_38;
    var phi_4250_: type_57;
    var phi_4251_: bool;
    var phi_4252_: u32;
    var phi_4804_: bool;
    var phi_4253_: type_38;
    var phi_4254_: type_57;
    var phi_4255_: u32;
    var phi_4256_: bool;
    var phi_4257_: u32;
    var phi_4803_: bool;
    var phi_4258_: type_38;
    var phi_4259_: type_57;
    var phi_4260_: u32;
    var phi_4261_: bool;
    var phi_4262_: u32;
    var phi_4802_: bool;
    var phi_967_: type_38;
    var phi_970_: type_57;
    var phi_972_: u32;
    var phi_974_: bool;
    var phi_976_: u32;
    var phi_4263_: bool;
    var phi_4801_: bool;
    var local_10: type_38;
    var phi_4315_: type_21;
    var local_11: type_38;

    switch bitcast<i32>(0u) {
        default: {
            let _e98 = global;
            let _e100 = arrayLength((&global_9.member));
            let _e103 = arrayLength((&global_10.member));
            let _e115 = arrayLength((&global_8.member));
            let _e119 = global_3.member[0u][0u];
            let _e123 = global_3.member[0u][1u];
            let _e127 = global_3.member[0u][2u];
            let _e131 = global_3.member[0u][3u];
            let _e135 = global_3.member[1u][0u];
            let _e139 = global_3.member[1u][1u];
            let _e143 = global_3.member[1u][2u];
            let _e147 = (_e98.x + (_e98.y * 2097152u));
            let _e159 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e131) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e119), bitcast<i32>(_e123), bitcast<i32>(_e127));
            local = array<i32, 3>(bitcast<i32>(_e135), bitcast<i32>(_e139), bitcast<i32>(_e143));
            let _e162 = (_e147 < arrayLength((&global_6.member)));
            if _e162 {
                if _e162 {
                } else {
                    break;
                }
                let _e166 = global_6.member[_e147].member_2;
                phi_334_ = _e166;
            } else {
                phi_334_ = 4294967295u;
            }
            let _e168 = phi_334_;
            let _e171 = global_1.member[0u];
            let _e175 = global_2.member[0u][0u];
            let _e179 = global_2.member[0u][1u];
            let _e183 = global_2.member[0u][2u];
            let _e187 = global_2.member[0u][3u];
            let _e191 = global_2.member[1u][0u];
            let _e195 = global_2.member[1u][1u];
            let _e199 = global_2.member[1u][2u];
            let _e203 = global_2.member[1u][3u];
            let _e204 = bitcast<f32>(_e175);
            let _e205 = bitcast<f32>(_e179);
            let _e206 = bitcast<f32>(_e183);
            let _e208 = bitcast<f32>(_e191);
            let _e209 = array<u32, 3>(_e195, _e199, _e203);
            let _e211 = bitcast<i32>(_e171);
            if (_e211 < -126i) {
                phi_378_ = -126i;
            } else {
                phi_378_ = select(_e211, 127i, (_e211 > 127i));
            }
            let _e216 = phi_378_;
            let _e221 = bitcast<f32>((bitcast<u32>((_e216 + 127i)) << bitcast<u32>(23i)));
            let _e227 = bitcast<f32>((bitcast<u32>(((_e211 - _e216) + 127i)) << bitcast<u32>(23i)));
            if (_e187 == 0u) {
                phi_402_ = type_35(array<f32, 3>(_e204, _e205, _e206), _e187, _e208, _e209);
            } else {
                phi_402_ = type_35(array<f32, 3>(((_e204 * _e221) * _e227), ((_e205 * _e221) * _e227), ((_e206 * _e221) * _e227)), _e187, ((_e208 * _e221) * _e227), _e209);
            }
            let _e240 = phi_402_;
            if _e162 {
                let _e241 = (_e147 < arrayLength((&global_7.member)));
                if _e241 {
                    if _e162 {
                    } else {
                        break;
                    }
                    let _e251 = global_6.member[_e147].member.member_2[0u];
                    let _e253 = (bitcast<u32>(_e251) & 2147483647u);
                    let _e259 = global_6.member[_e147].member.member_2[1u];
                    let _e261 = (bitcast<u32>(_e259) & 2147483647u);
                    let _e267 = global_6.member[_e147].member.member_2[2u];
                    let _e269 = (bitcast<u32>(_e267) & 2147483647u);
                    let _e275 = global_6.member[_e147].member.member[0u];
                    let _e277 = (bitcast<u32>(_e275) & 2147483647u);
                    let _e283 = global_6.member[_e147].member.member[1u];
                    let _e285 = (bitcast<u32>(_e283) & 2147483647u);
                    let _e291 = global_6.member[_e147].member.member[2u];
                    let _e293 = (bitcast<u32>(_e291) & 2147483647u);
                    let _e295 = select(_e261, _e253, (_e261 < _e253));
                    let _e297 = select(_e269, _e295, (_e269 < _e295));
                    let _e299 = select(_e277, _e297, (_e277 < _e297));
                    let _e301 = select(_e285, _e299, (_e285 < _e299));
                    let _e303 = select(_e293, _e301, (_e293 < _e301));
                    let _e308 = global_6.member[_e147].member.member_1;
                    let _e310 = (bitcast<u32>(_e308) & 2147483647u);
                    let _e318 = global_6.member[_e147].member.member_3;
                    let _e324 = (((select(_e310, _e303, (_e310 < _e303)) < 2139095040u) && ((bitcast<u32>(_e318) & 2147483647u) <= 2139095040u)) && (_e297 > 0u));
                    if _e324 {
                        let _e327 = (bitcast<u32>(bitcast<f32>(_e297)) & 2147483647u);
                        if (_e327 >= 8388608u) {
                            phi_508_ = (bitcast<i32>((_e327 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_508_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e327)), 32u, (_e327 == 0u))));
                        }
                        let _e341 = phi_508_;
                        phi_509_ = _e341;
                    } else {
                        phi_509_ = 0i;
                    }
                    let _e343 = phi_509_;
                    let _e344 = (_e253 == _e297);
                    if _e344 {
                        phi_519_ = true;
                    } else {
                        phi_519_ = (_e261 == _e297);
                    }
                    let _e347 = phi_519_;
                    let _e348 = select(1u, 0u, _e344);
                    if _e347 {
                        let _e349 = (_e348 + 1u);
                        phi_529_ = _e349;
                        phi_530_ = _e349;
                        phi_532_ = select(true, false, (_e349 == 2u));
                    } else {
                        phi_529_ = u32();
                        phi_530_ = 0u;
                        phi_532_ = true;
                    }
                    let _e353 = phi_529_;
                    let _e355 = phi_530_;
                    let _e357 = phi_532_;
                    if _e357 {
                        phi_537_ = (_e355 + 1u);
                    } else {
                        phi_537_ = 0u;
                    }
                    let _e361 = phi_537_;
                    let _e362 = select(_e353, _e355, _e357);
                    let _e363 = select(_e348, select(2u, _e348, _e347), _e357);
                    let _e364 = -(_e343);
                    if (_e364 < -126i) {
                        phi_569_ = -126i;
                    } else {
                        phi_569_ = select(_e364, 127i, (_e364 > 127i));
                    }
                    let _e369 = phi_569_;
                    let _e374 = bitcast<f32>((bitcast<u32>((_e369 + 127i)) << bitcast<u32>(23i)));
                    let _e380 = bitcast<f32>((bitcast<u32>(((_e364 - _e369) + 127i)) << bitcast<u32>(23i)));
                    let _e385 = global_6.member[_e147].member.member;
                    let _e386 = (_e362 == 0u);
                    if _e386 {
                        phi_587_ = _e385[0];
                    } else {
                        phi_587_ = _e385[1];
                    }
                    let _e390 = phi_587_;
                    let _e391 = (_e362 == 2u);
                    if _e391 {
                        phi_593_ = _e385[2];
                    } else {
                        phi_593_ = _e390;
                    }
                    let _e394 = phi_593_;
                    let _e395 = global_6.member[_e147].member.member_2;
                    if _e386 {
                        phi_604_ = _e395[0];
                    } else {
                        phi_604_ = _e395[1];
                    }
                    let _e399 = phi_604_;
                    if _e391 {
                        phi_610_ = _e395[2];
                    } else {
                        phi_610_ = _e399;
                    }
                    let _e402 = phi_610_;
                    let _e404 = ((_e402 * _e374) * _e380);
                    let _e408 = (bitcast<f32>((bitcast<u32>(_e404) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e408 {
                        let _e412 = (bitcast<f32>((bitcast<u32>(_e394) & 2147483647u)) * 0.00000011920929f);
                        phi_633_ = select(0.00000000000011368684f, _e412, (_e412 > 0.00000000000011368684f));
                    } else {
                        phi_633_ = 0f;
                    }
                    let _e416 = phi_633_;
                    let _e417 = (_e394 + _e416);
                    let _e418 = (_e394 - _e416);
                    let _e419 = select(_e404, 0f, _e408);
                    if _e408 {
                        phi_644_ = 38685626000000000000000000f;
                    } else {
                        phi_644_ = (1f / _e404);
                    }
                    let _e422 = phi_644_;
                    let _e423 = (_e361 == 0u);
                    if _e423 {
                        phi_653_ = _e385[0];
                    } else {
                        phi_653_ = _e385[1];
                    }
                    let _e427 = phi_653_;
                    let _e428 = (_e361 == 2u);
                    if _e428 {
                        phi_659_ = _e385[2];
                    } else {
                        phi_659_ = _e427;
                    }
                    let _e431 = phi_659_;
                    if _e423 {
                        phi_670_ = _e395[0];
                    } else {
                        phi_670_ = _e395[1];
                    }
                    let _e435 = phi_670_;
                    if _e428 {
                        phi_676_ = _e395[2];
                    } else {
                        phi_676_ = _e435;
                    }
                    let _e438 = phi_676_;
                    let _e440 = ((_e438 * _e374) * _e380);
                    let _e444 = (bitcast<f32>((bitcast<u32>(_e440) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e444 {
                        let _e448 = (bitcast<f32>((bitcast<u32>(_e431) & 2147483647u)) * 0.00000011920929f);
                        phi_699_ = select(0.00000000000011368684f, _e448, (_e448 > 0.00000000000011368684f));
                    } else {
                        phi_699_ = 0f;
                    }
                    let _e452 = phi_699_;
                    let _e453 = (_e431 + _e452);
                    let _e454 = (_e431 - _e452);
                    let _e455 = select(_e440, 0f, _e444);
                    if _e444 {
                        phi_710_ = 38685626000000000000000000f;
                    } else {
                        phi_710_ = (1f / _e440);
                    }
                    let _e458 = phi_710_;
                    let _e459 = (_e363 == 0u);
                    if _e459 {
                        phi_719_ = _e385[0];
                    } else {
                        phi_719_ = _e385[1];
                    }
                    let _e463 = phi_719_;
                    let _e464 = (_e363 == 2u);
                    if _e464 {
                        phi_725_ = _e385[2];
                    } else {
                        phi_725_ = _e463;
                    }
                    let _e467 = phi_725_;
                    if _e459 {
                        phi_736_ = _e395[0];
                    } else {
                        phi_736_ = _e395[1];
                    }
                    let _e471 = phi_736_;
                    if _e464 {
                        phi_742_ = _e395[2];
                    } else {
                        phi_742_ = _e471;
                    }
                    let _e474 = phi_742_;
                    let _e476 = ((_e474 * _e374) * _e380);
                    let _e480 = (bitcast<f32>((bitcast<u32>(_e476) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e480 {
                        let _e484 = (bitcast<f32>((bitcast<u32>(_e467) & 2147483647u)) * 0.00000011920929f);
                        phi_765_ = select(0.00000000000011368684f, _e484, (_e484 > 0.00000000000011368684f));
                    } else {
                        phi_765_ = 0f;
                    }
                    let _e488 = phi_765_;
                    let _e489 = (_e467 + _e488);
                    let _e490 = (_e467 - _e488);
                    let _e491 = select(_e476, 0f, _e480);
                    if _e480 {
                        phi_776_ = 38685626000000000000000000f;
                    } else {
                        phi_776_ = (1f / _e476);
                    }
                    let _e494 = phi_776_;
                    let _e497 = bitcast<f32>((bitcast<u32>(_e394) & 2147483647u));
                    let _e500 = bitcast<f32>((bitcast<u32>(_e431) & 2147483647u));
                    let _e502 = select(_e500, _e497, (_e497 > _e500));
                    let _e505 = bitcast<f32>((bitcast<u32>(_e467) & 2147483647u));
                    if (_e324 && (select(_e505, _e502, (_e502 > _e505)) <= 1099511600000f)) {
                        let _e510 = (_e343 / 3i);
                        let _e517 = bitcast<f32>((bitcast<u32>((_e510 + 127i)) << bitcast<u32>(23i)));
                        let _e524 = bitcast<f32>((bitcast<u32>(((_e343 - (2i * _e510)) + 127i)) << bitcast<u32>(23i)));
                        let _e525 = (((_e308 * _e517) * _e517) * _e524);
                        let _e527 = select(340282350000000000000000000000000000000f, _e525, (_e525 < 340282350000000000000000000000000000000f));
                        let _e532 = (((_e318 * _e517) * _e517) * _e524);
                        let _e534 = select(340282350000000000000000000000000000000f, _e532, (_e532 < 340282350000000000000000000000000000000f));
                        phi_876_ = select(-340282350000000000000000000000000000000f, _e534, (_e534 > -340282350000000000000000000000000000000f));
                        phi_877_ = select(-340282350000000000000000000000000000000f, _e527, (_e527 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_876_ = 0f;
                        phi_877_ = 1f;
                    }
                    let _e538 = phi_876_;
                    let _e540 = phi_877_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e544 = (_e362 % 3u);
                    let _e545 = (_e544 < 3u);
                    if _e545 {
                    } else {
                        break;
                    }
                    let _e547 = local_1[_e544];
                    let _e550 = (_e361 % 3u);
                    let _e551 = (_e550 < 3u);
                    if _e551 {
                    } else {
                        break;
                    }
                    let _e553 = local_1[_e550];
                    let _e556 = (_e363 % 3u);
                    let _e557 = (_e556 < 3u);
                    if _e557 {
                    } else {
                        break;
                    }
                    let _e559 = local_1[_e556];
                    if _e545 {
                    } else {
                        break;
                    }
                    let _e564 = local[_e544];
                    if _e551 {
                    } else {
                        break;
                    }
                    let _e568 = local[_e550];
                    if _e557 {
                    } else {
                        break;
                    }
                    let _e572 = local[_e556];
                    phi_4594_ = false;
                    phi_966_ = type_38(type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e538);
                    phi_969_ = type_57(type_33(vec4<f32>((f32(_e547) * _e159), (f32(_e553) * _e159), (f32(_e559) * _e159), 0f), vec4<f32>((f32(_e564) * _e159), (f32(_e568) * _e159), (f32(_e572) * _e159), 0f)), select(0u, 2147483648u, (_e100 == 0u)));
                    phi_971_ = ((3u * _e100) + 1u);
                    phi_973_ = (_e540 <= _e538);
                    phi_975_ = 0u;
                    loop {
                        let _e582 = phi_4594_;
                        let _e584 = phi_966_;
                        let _e586 = phi_969_;
                        let _e588 = phi_971_;
                        let _e590 = phi_973_;
                        let _e592 = phi_975_;
                        local_10 = _e584;
                        if _e590 {
                            phi_986_ = true;
                        } else {
                            phi_986_ = (_e592 > 0u);
                        }
                        let _e595 = phi_986_;
                        if _e595 {
                            let _e596 = (_e588 > 0u);
                            if _e596 {
                                if _e590 {
                                    phi_1072_ = _e586;
                                    phi_1073_ = _e590;
                                    phi_1074_ = _e592;
                                } else {
                                    let _e597 = (_e592 - 1u);
                                    let _e598 = (_e597 % 128u);
                                    let _e599 = (_e598 < 128u);
                                    if _e599 {
                                    } else {
                                        phi_4801_ = true;
                                        break;
                                    }
                                    let _e601 = local_7[_e598];
                                    if _e599 {
                                    } else {
                                        phi_4801_ = true;
                                        break;
                                    }
                                    let _e603 = local_6[_e598];
                                    if _e599 {
                                    } else {
                                        phi_4801_ = true;
                                        break;
                                    }
                                    let _e605 = local_5[_e598];
                                    if _e599 {
                                    } else {
                                        phi_4801_ = true;
                                        break;
                                    }
                                    let _e607 = local_4[_e598];
                                    if _e599 {
                                    } else {
                                        phi_4801_ = true;
                                        break;
                                    }
                                    let _e609 = local_3[_e598];
                                    if _e599 {
                                    } else {
                                        phi_4801_ = true;
                                        break;
                                    }
                                    let _e611 = local_2[_e598];
                                    if _e599 {
                                    } else {
                                        phi_4801_ = true;
                                        break;
                                    }
                                    let _e616 = local_8[_e598];
                                    if _e599 {
                                    } else {
                                        phi_4801_ = true;
                                        break;
                                    }
                                    let _e619 = local_9[_e598];
                                    phi_1072_ = type_57(type_33(vec4<f32>(_e601, _e603, _e605, 0f), vec4<f32>(_e607, _e609, _e611, 0f)), _e616);
                                    phi_1073_ = (_e619 <= _e584.member_1);
                                    phi_1074_ = _e597;
                                }
                                let _e623 = phi_1072_;
                                let _e625 = phi_1073_;
                                let _e627 = phi_1074_;
                                if _e625 {
                                    let _e632 = (_e623.member_1 & 268435455u);
                                    if ((_e623.member_1 & 2147483648u) != 0u) {
                                        phi_1093_ = _e584;
                                        phi_1096_ = type_8(0u, ((_e623.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1110 = phi_1093_;
                                            let _e1112 = phi_1096_;
                                            local_11 = _e1110;
                                            if (_e1112.member < _e1112.member_1) {
                                                phi_1097_ = type_8((_e1112.member + 1u), _e1112.member_1);
                                                phi_1119_ = type_8(1u, _e1112.member);
                                            } else {
                                                phi_1097_ = _e1112;
                                                phi_1119_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1125 = phi_1097_;
                                            let _e1127 = phi_1119_;
                                            let _e1131 = (bitcast<i32>(_e1127.member) != 0i);
                                            if _e1131 {
                                                let _e1136 = (_e623.member.member_1.x - _e623.member.member.x);
                                                let _e1139 = (_e623.member.member_1.y - _e623.member.member.y);
                                                let _e1142 = (_e623.member.member_1.z - _e623.member.member.z);
                                                let _e1144 = select(_e1139, _e1136, (_e1136 > _e1139));
                                                let _e1146 = select(_e1142, _e1144, (_e1144 > _e1142));
                                                let _e1148 = (_e1146 < (1024f * _e159));
                                                if _e1148 {
                                                    phi_1160_ = 0u;
                                                } else {
                                                    phi_1160_ = select(2u, 1u, (_e1146 < (2097152f * _e159)));
                                                }
                                                let _e1153 = phi_1160_;
                                                switch bitcast<i32>(_e1153) {
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
                                                let _e1156 = phi_1166_;
                                                switch bitcast<i32>(_e1153) {
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
                                                let _e1163 = phi_1176_;
                                                let _e1165 = ((_e632 + (_e1127.member_1 * ((3u * _e1156) + 1u))) + (3u * _e1163));
                                                let _e1166 = (_e1165 < _e103);
                                                if _e1166 {
                                                    if _e1166 {
                                                    } else {
                                                        phi_4588_ = true;
                                                        break;
                                                    }
                                                    let _e1168 = global_10.member[_e1165];
                                                    phi_1192_ = _e1168;
                                                } else {
                                                    phi_1192_ = 4294967295u;
                                                }
                                                let _e1170 = phi_1192_;
                                                if _e1148 {
                                                    phi_1225_ = 0u;
                                                } else {
                                                    phi_1225_ = select(2u, 1u, (_e1146 < (2097152f * _e159)));
                                                }
                                                let _e1175 = phi_1225_;
                                                switch bitcast<i32>(_e1175) {
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
                                                let _e1178 = phi_1231_;
                                                let _e1182 = (_e632 + (_e1127.member_1 * ((3u * _e1178) + 1u)));
                                                switch bitcast<i32>(_e1175) {
                                                    case 0: {
                                                        let _e1448 = (_e1182 < _e103);
                                                        if _e1448 {
                                                            if _e1448 {
                                                            } else {
                                                                phi_4588_ = true;
                                                                break;
                                                            }
                                                            let _e1450 = global_10.member[_e1182];
                                                            phi_1255_ = _e1450;
                                                        } else {
                                                            phi_1255_ = 0u;
                                                        }
                                                        let _e1452 = phi_1255_;
                                                        let _e1454 = ((10u * _e362) & 31u);
                                                        let _e1463 = ((10u * _e361) & 31u);
                                                        let _e1472 = ((10u * _e363) & 31u);
                                                        let _e1481 = (_e1182 + 1u);
                                                        let _e1482 = (_e1481 < _e103);
                                                        if _e1482 {
                                                            if _e1482 {
                                                            } else {
                                                                phi_4588_ = true;
                                                                break;
                                                            }
                                                            let _e1484 = global_10.member[_e1481];
                                                            phi_1298_ = _e1484;
                                                        } else {
                                                            phi_1298_ = 0u;
                                                        }
                                                        let _e1486 = phi_1298_;
                                                        let _e1509 = (_e1182 + 2u);
                                                        let _e1510 = (_e1509 < _e103);
                                                        if _e1510 {
                                                            if _e1510 {
                                                            } else {
                                                                phi_4588_ = true;
                                                                break;
                                                            }
                                                            let _e1512 = global_10.member[_e1509];
                                                            phi_1341_ = _e1512;
                                                        } else {
                                                            phi_1341_ = 0u;
                                                        }
                                                        let _e1514 = phi_1341_;
                                                        phi_1812_ = array<array<f32, 3>, 3>(array<f32, 3>((_e623.member.member.x + (f32(bitcast<i32>(((_e1452 >> bitcast<u32>(_e1454)) & 1023u))) * _e159)), (_e623.member.member.y + (f32(bitcast<i32>(((_e1452 >> bitcast<u32>(_e1463)) & 1023u))) * _e159)), (_e623.member.member.z + (f32(bitcast<i32>(((_e1452 >> bitcast<u32>(_e1472)) & 1023u))) * _e159))), array<f32, 3>((_e623.member.member.x + (f32(bitcast<i32>(((_e1486 >> bitcast<u32>(_e1454)) & 1023u))) * _e159)), (_e623.member.member.y + (f32(bitcast<i32>(((_e1486 >> bitcast<u32>(_e1463)) & 1023u))) * _e159)), (_e623.member.member.z + (f32(bitcast<i32>(((_e1486 >> bitcast<u32>(_e1472)) & 1023u))) * _e159))), array<f32, 3>((_e623.member.member.x + (f32(bitcast<i32>(((_e1514 >> bitcast<u32>(_e1454)) & 1023u))) * _e159)), (_e623.member.member.y + (f32(bitcast<i32>(((_e1514 >> bitcast<u32>(_e1463)) & 1023u))) * _e159)), (_e623.member.member.z + (f32(bitcast<i32>(((_e1514 >> bitcast<u32>(_e1472)) & 1023u))) * _e159))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1271 = (_e1182 < _e103);
                                                        if _e1271 {
                                                            if _e1271 {
                                                            } else {
                                                                phi_4588_ = true;
                                                                break;
                                                            }
                                                            let _e1273 = global_10.member[_e1182];
                                                            phi_1384_ = _e1273;
                                                        } else {
                                                            phi_1384_ = 0u;
                                                        }
                                                        let _e1275 = phi_1384_;
                                                        let _e1276 = (_e1182 + 1u);
                                                        let _e1277 = (_e1276 < _e103);
                                                        if _e1277 {
                                                            if _e1277 {
                                                            } else {
                                                                phi_4588_ = true;
                                                                break;
                                                            }
                                                            let _e1279 = global_10.member[_e1276];
                                                            phi_1399_ = _e1279;
                                                        } else {
                                                            phi_1399_ = 0u;
                                                        }
                                                        let _e1281 = phi_1399_;
                                                        let _e1282 = (_e362 == 1u);
                                                        if _e1282 {
                                                            phi_1409_ = ((_e1275 >> bitcast<u32>(21i)) | (_e1281 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1409_ = (_e1281 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1291 = phi_1409_;
                                                        let _e1298 = (_e361 == 1u);
                                                        if _e1298 {
                                                            phi_1429_ = ((_e1275 >> bitcast<u32>(21i)) | (_e1281 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1429_ = (_e1281 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1307 = phi_1429_;
                                                        let _e1314 = (_e363 == 1u);
                                                        if _e1314 {
                                                            phi_1449_ = ((_e1275 >> bitcast<u32>(21i)) | (_e1281 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1449_ = (_e1281 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1323 = phi_1449_;
                                                        let _e1331 = (_e1182 + 2u);
                                                        let _e1332 = (_e1331 < _e103);
                                                        if _e1332 {
                                                            if _e1332 {
                                                            } else {
                                                                phi_4588_ = true;
                                                                break;
                                                            }
                                                            let _e1334 = global_10.member[_e1331];
                                                            phi_1475_ = _e1334;
                                                        } else {
                                                            phi_1475_ = 0u;
                                                        }
                                                        let _e1336 = phi_1475_;
                                                        let _e1337 = (_e1182 + 3u);
                                                        let _e1338 = (_e1337 < _e103);
                                                        if _e1338 {
                                                            if _e1338 {
                                                            } else {
                                                                phi_4588_ = true;
                                                                break;
                                                            }
                                                            let _e1340 = global_10.member[_e1337];
                                                            phi_1490_ = _e1340;
                                                        } else {
                                                            phi_1490_ = 0u;
                                                        }
                                                        let _e1342 = phi_1490_;
                                                        if _e1282 {
                                                            phi_1500_ = ((_e1336 >> bitcast<u32>(21i)) | (_e1342 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1500_ = (_e1342 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1351 = phi_1500_;
                                                        if _e1298 {
                                                            phi_1520_ = ((_e1336 >> bitcast<u32>(21i)) | (_e1342 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1520_ = (_e1342 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1366 = phi_1520_;
                                                        if _e1314 {
                                                            phi_1540_ = ((_e1336 >> bitcast<u32>(21i)) | (_e1342 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1540_ = (_e1342 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1381 = phi_1540_;
                                                        let _e1389 = (_e1182 + 4u);
                                                        let _e1390 = (_e1389 < _e103);
                                                        if _e1390 {
                                                            if _e1390 {
                                                            } else {
                                                                phi_4588_ = true;
                                                                break;
                                                            }
                                                            let _e1392 = global_10.member[_e1389];
                                                            phi_1566_ = _e1392;
                                                        } else {
                                                            phi_1566_ = 0u;
                                                        }
                                                        let _e1394 = phi_1566_;
                                                        let _e1395 = (_e1182 + 5u);
                                                        let _e1396 = (_e1395 < _e103);
                                                        if _e1396 {
                                                            if _e1396 {
                                                            } else {
                                                                phi_4588_ = true;
                                                                break;
                                                            }
                                                            let _e1398 = global_10.member[_e1395];
                                                            phi_1581_ = _e1398;
                                                        } else {
                                                            phi_1581_ = 0u;
                                                        }
                                                        let _e1400 = phi_1581_;
                                                        if _e1282 {
                                                            phi_1591_ = ((_e1394 >> bitcast<u32>(21i)) | (_e1400 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1591_ = (_e1400 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1409 = phi_1591_;
                                                        if _e1298 {
                                                            phi_1611_ = ((_e1394 >> bitcast<u32>(21i)) | (_e1400 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1611_ = (_e1400 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1424 = phi_1611_;
                                                        if _e1314 {
                                                            phi_1631_ = ((_e1394 >> bitcast<u32>(21i)) | (_e1400 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1631_ = (_e1400 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1439 = phi_1631_;
                                                        phi_1812_ = array<array<f32, 3>, 3>(array<f32, 3>((_e623.member.member.x + (f32(bitcast<i32>((select(_e1291, _e1275, _e386) & 2097151u))) * _e159)), (_e623.member.member.y + (f32(bitcast<i32>((select(_e1307, _e1275, _e423) & 2097151u))) * _e159)), (_e623.member.member.z + (f32(bitcast<i32>((select(_e1323, _e1275, _e459) & 2097151u))) * _e159))), array<f32, 3>((_e623.member.member.x + (f32(bitcast<i32>((select(_e1351, _e1336, _e386) & 2097151u))) * _e159)), (_e623.member.member.y + (f32(bitcast<i32>((select(_e1366, _e1336, _e423) & 2097151u))) * _e159)), (_e623.member.member.z + (f32(bitcast<i32>((select(_e1381, _e1336, _e459) & 2097151u))) * _e159))), array<f32, 3>((_e623.member.member.x + (f32(bitcast<i32>((select(_e1409, _e1394, _e386) & 2097151u))) * _e159)), (_e623.member.member.y + (f32(bitcast<i32>((select(_e1424, _e1394, _e423) & 2097151u))) * _e159)), (_e623.member.member.z + (f32(bitcast<i32>((select(_e1439, _e1394, _e459) & 2097151u))) * _e159))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1184 = (_e1182 + _e362);
                                                        let _e1185 = (_e1184 < _e103);
                                                        if _e1185 {
                                                            if _e1185 {
                                                            } else {
                                                                phi_4588_ = true;
                                                                break;
                                                            }
                                                            let _e1187 = global_10.member[_e1184];
                                                            phi_1658_ = _e1187;
                                                        } else {
                                                            phi_1658_ = 0u;
                                                        }
                                                        let _e1189 = phi_1658_;
                                                        let _e1193 = (_e1182 + _e361);
                                                        let _e1194 = (_e1193 < _e103);
                                                        if _e1194 {
                                                            if _e1194 {
                                                            } else {
                                                                phi_4588_ = true;
                                                                break;
                                                            }
                                                            let _e1196 = global_10.member[_e1193];
                                                            phi_1676_ = _e1196;
                                                        } else {
                                                            phi_1676_ = 0u;
                                                        }
                                                        let _e1198 = phi_1676_;
                                                        let _e1202 = (_e1182 + _e363);
                                                        let _e1203 = (_e1202 < _e103);
                                                        if _e1203 {
                                                            if _e1203 {
                                                            } else {
                                                                phi_4588_ = true;
                                                                break;
                                                            }
                                                            let _e1205 = global_10.member[_e1202];
                                                            phi_1694_ = _e1205;
                                                        } else {
                                                            phi_1694_ = 0u;
                                                        }
                                                        let _e1207 = phi_1694_;
                                                        let _e1212 = (_e1182 + 3u);
                                                        let _e1213 = (_e1212 + _e362);
                                                        let _e1214 = (_e1213 < _e103);
                                                        if _e1214 {
                                                            if _e1214 {
                                                            } else {
                                                                phi_4588_ = true;
                                                                break;
                                                            }
                                                            let _e1216 = global_10.member[_e1213];
                                                            phi_1714_ = _e1216;
                                                        } else {
                                                            phi_1714_ = 0u;
                                                        }
                                                        let _e1218 = phi_1714_;
                                                        let _e1222 = (_e1212 + _e361);
                                                        let _e1223 = (_e1222 < _e103);
                                                        if _e1223 {
                                                            if _e1223 {
                                                            } else {
                                                                phi_4588_ = true;
                                                                break;
                                                            }
                                                            let _e1225 = global_10.member[_e1222];
                                                            phi_1732_ = _e1225;
                                                        } else {
                                                            phi_1732_ = 0u;
                                                        }
                                                        let _e1227 = phi_1732_;
                                                        let _e1231 = (_e1212 + _e363);
                                                        let _e1232 = (_e1231 < _e103);
                                                        if _e1232 {
                                                            if _e1232 {
                                                            } else {
                                                                phi_4588_ = true;
                                                                break;
                                                            }
                                                            let _e1234 = global_10.member[_e1231];
                                                            phi_1750_ = _e1234;
                                                        } else {
                                                            phi_1750_ = 0u;
                                                        }
                                                        let _e1236 = phi_1750_;
                                                        let _e1241 = (_e1182 + 6u);
                                                        let _e1242 = (_e1241 + _e362);
                                                        let _e1243 = (_e1242 < _e103);
                                                        if _e1243 {
                                                            if _e1243 {
                                                            } else {
                                                                phi_4588_ = true;
                                                                break;
                                                            }
                                                            let _e1245 = global_10.member[_e1242];
                                                            phi_1770_ = _e1245;
                                                        } else {
                                                            phi_1770_ = 0u;
                                                        }
                                                        let _e1247 = phi_1770_;
                                                        let _e1251 = (_e1241 + _e361);
                                                        let _e1252 = (_e1251 < _e103);
                                                        if _e1252 {
                                                            if _e1252 {
                                                            } else {
                                                                phi_4588_ = true;
                                                                break;
                                                            }
                                                            let _e1254 = global_10.member[_e1251];
                                                            phi_1788_ = _e1254;
                                                        } else {
                                                            phi_1788_ = 0u;
                                                        }
                                                        let _e1256 = phi_1788_;
                                                        let _e1260 = (_e1241 + _e363);
                                                        let _e1261 = (_e1260 < _e103);
                                                        if _e1261 {
                                                            if _e1261 {
                                                            } else {
                                                                phi_4588_ = true;
                                                                break;
                                                            }
                                                            let _e1263 = global_10.member[_e1260];
                                                            phi_1806_ = _e1263;
                                                        } else {
                                                            phi_1806_ = 0u;
                                                        }
                                                        let _e1265 = phi_1806_;
                                                        phi_1812_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1189)) * _e159), (f32(bitcast<i32>(_e1198)) * _e159), (f32(bitcast<i32>(_e1207)) * _e159)), array<f32, 3>((f32(bitcast<i32>(_e1218)) * _e159), (f32(bitcast<i32>(_e1227)) * _e159), (f32(bitcast<i32>(_e1236)) * _e159)), array<f32, 3>((f32(bitcast<i32>(_e1247)) * _e159), (f32(bitcast<i32>(_e1256)) * _e159), (f32(bitcast<i32>(_e1265)) * _e159)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1812_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1539 = phi_1812_;
                                                let _e1547 = (_e1539[0][2] - _e467);
                                                let _e1550 = (((_e1539[0][0] - _e394) * _e491) - (_e1547 * _e419));
                                                let _e1553 = (((_e1539[0][1] - _e431) * _e491) - (_e1547 * _e455));
                                                let _e1560 = (_e1539[1][2] - _e467);
                                                let _e1563 = (((_e1539[1][0] - _e394) * _e491) - (_e1560 * _e419));
                                                let _e1566 = (((_e1539[1][1] - _e431) * _e491) - (_e1560 * _e455));
                                                let _e1573 = (_e1539[2][2] - _e467);
                                                let _e1576 = (((_e1539[2][0] - _e394) * _e491) - (_e1573 * _e419));
                                                let _e1579 = (((_e1539[2][1] - _e431) * _e491) - (_e1573 * _e455));
                                                let _e1580 = (_e1576 * _e1566);
                                                let _e1581 = (_e1579 * _e1563);
                                                let _e1582 = (_e1550 * _e1579);
                                                let _e1583 = (_e1553 * _e1576);
                                                let _e1584 = (_e1563 * _e1553);
                                                let _e1585 = (_e1566 * _e1550);
                                                let _e1590 = (((_e1580 >= _e1581) && (_e1582 >= _e1583)) && (_e1584 >= _e1585));
                                                if (_e1590 || (((_e1580 <= _e1581) && (_e1582 <= _e1583)) && (_e1584 <= _e1585))) {
                                                    let _e1597 = select(-1f, 1f, _e1590);
                                                    let _e1599 = ((_e1580 - _e1581) * _e1597);
                                                    let _e1601 = select(0f, _e1599, (_e1599 > 0f));
                                                    let _e1603 = ((_e1582 - _e1583) * _e1597);
                                                    let _e1605 = select(0f, _e1603, (_e1603 > 0f));
                                                    let _e1607 = ((_e1584 - _e1585) * _e1597);
                                                    let _e1609 = select(0f, _e1607, (_e1607 > 0f));
                                                    let _e1611 = ((_e1601 + _e1605) + _e1609);
                                                    if (_e1611 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2637_ = type_21();
                                                        phi_2638_ = true;
                                                        phi_2639_ = false;
                                                    } else {
                                                        let _e1614 = select(_e1563, _e1550, (_e1550 < _e1563));
                                                        if (select(_e1576, _e1614, (_e1614 < _e1576)) > 0f) {
                                                            phi_1929_ = true;
                                                        } else {
                                                            let _e1619 = select(_e1563, _e1550, (_e1550 > _e1563));
                                                            phi_1929_ = (select(_e1576, _e1619, (_e1619 > _e1576)) < 0f);
                                                        }
                                                        let _e1624 = phi_1929_;
                                                        if _e1624 {
                                                            phi_2634_ = type_21();
                                                            phi_2635_ = true;
                                                            phi_2636_ = false;
                                                        } else {
                                                            let _e1626 = select(_e1566, _e1553, (_e1553 < _e1566));
                                                            if (select(_e1579, _e1626, (_e1626 < _e1579)) > 0f) {
                                                                phi_1958_ = true;
                                                            } else {
                                                                let _e1631 = select(_e1566, _e1553, (_e1553 > _e1566));
                                                                phi_1958_ = (select(_e1579, _e1631, (_e1631 > _e1579)) < 0f);
                                                            }
                                                            let _e1636 = phi_1958_;
                                                            if _e1636 {
                                                                phi_2632_ = type_21();
                                                                phi_2633_ = false;
                                                            } else {
                                                                let _e1638 = select(_e1539[1][0], _e1539[0][0], (_e1539[0][0] < _e1539[1][0]));
                                                                let _e1642 = select(_e1539[1][0], _e1539[0][0], (_e1539[0][0] > _e1539[1][0]));
                                                                let _e1646 = select(_e1539[1][1], _e1539[0][1], (_e1539[0][1] < _e1539[1][1]));
                                                                let _e1650 = select(_e1539[1][1], _e1539[0][1], (_e1539[0][1] > _e1539[1][1]));
                                                                let _e1654 = select(_e1539[1][2], _e1539[0][2], (_e1539[0][2] < _e1539[1][2]));
                                                                let _e1658 = select(_e1539[1][2], _e1539[0][2], (_e1539[0][2] > _e1539[1][2]));
                                                                let _e1663 = ((select(_e1539[2][0], _e1638, (_e1638 < _e1539[2][0])) - _e417) * _e422);
                                                                let _e1664 = ((select(_e1539[2][0], _e1642, (_e1642 > _e1539[2][0])) - _e418) * _e422);
                                                                let _e1667 = ((select(_e1539[2][1], _e1646, (_e1646 < _e1539[2][1])) - _e453) * _e458);
                                                                let _e1668 = ((select(_e1539[2][1], _e1650, (_e1650 > _e1539[2][1])) - _e454) * _e458);
                                                                let _e1671 = ((select(_e1539[2][2], _e1654, (_e1654 < _e1539[2][2])) - _e489) * _e494);
                                                                let _e1672 = ((select(_e1539[2][2], _e1658, (_e1658 > _e1539[2][2])) - _e490) * _e494);
                                                                let _e1674 = select(_e1672, _e1671, (_e1671 < _e1672));
                                                                let _e1676 = select(_e1672, _e1671, (_e1671 > _e1672));
                                                                let _e1678 = select(_e1664, _e1663, (_e1663 < _e1664));
                                                                let _e1680 = select(_e1668, _e1667, (_e1667 < _e1668));
                                                                let _e1682 = select(_e1680, _e1678, (_e1678 > _e1680));
                                                                let _e1684 = select(_e1674, _e1682, (_e1682 > _e1674));
                                                                let _e1686 = select(_e1664, _e1663, (_e1663 > _e1664));
                                                                let _e1688 = select(_e1668, _e1667, (_e1667 > _e1668));
                                                                let _e1690 = select(_e1688, _e1686, (_e1686 < _e1688));
                                                                let _e1692 = select(_e1676, _e1690, (_e1690 < _e1676));
                                                                let _e1693 = -(_e1674);
                                                                let _e1699 = select(_e540, _e1684, (_e1684 > _e540));
                                                                if (_e1699 > (_e1692 + (select(_e1693, _e1676, (_e1676 > _e1693)) * 0.0000019073523f))) {
                                                                    phi_2627_ = type_21();
                                                                    phi_2628_ = true;
                                                                } else {
                                                                    let _e1701 = (_e1699 > _e1110.member_1);
                                                                    if _e1701 {
                                                                        phi_2626_ = type_21();
                                                                    } else {
                                                                        let _e1702 = vec3<f32>(_e1539[0][0], _e1539[0][1], _e1539[0][2]);
                                                                        let _e1703 = vec3<f32>(_e1539[1][0], _e1539[1][1], _e1539[1][2]);
                                                                        let _e1704 = vec3<f32>(_e1539[2][0], _e1539[2][1], _e1539[2][2]);
                                                                        let _e1705 = (_e1539[1][0] - _e1539[0][0]);
                                                                        let _e1706 = (_e1539[1][1] - _e1539[0][1]);
                                                                        let _e1707 = (_e1539[1][2] - _e1539[0][2]);
                                                                        let _e1708 = vec3<f32>(_e1705, _e1706, _e1707);
                                                                        let _e1709 = (_e1539[2][0] - _e1539[1][0]);
                                                                        let _e1710 = (_e1539[2][1] - _e1539[1][1]);
                                                                        let _e1711 = (_e1539[2][2] - _e1539[1][2]);
                                                                        let _e1712 = vec3<f32>(_e1709, _e1710, _e1711);
                                                                        let _e1713 = (_e1539[0][0] - _e1539[2][0]);
                                                                        let _e1714 = (_e1539[0][1] - _e1539[2][1]);
                                                                        let _e1715 = (_e1539[0][2] - _e1539[2][2]);
                                                                        let _e1716 = vec3<f32>(_e1713, _e1714, _e1715);
                                                                        let _e1719 = bitcast<f32>((bitcast<u32>(_e1705) & 2147483647u));
                                                                        let _e1722 = bitcast<f32>((bitcast<u32>(_e1706) & 2147483647u));
                                                                        let _e1724 = select(_e1722, _e1719, (_e1719 > _e1722));
                                                                        let _e1727 = bitcast<f32>((bitcast<u32>(_e1707) & 2147483647u));
                                                                        let _e1729 = select(_e1727, _e1724, (_e1724 > _e1727));
                                                                        let _e1732 = bitcast<f32>((bitcast<u32>(_e1709) & 2147483647u));
                                                                        let _e1735 = bitcast<f32>((bitcast<u32>(_e1710) & 2147483647u));
                                                                        let _e1737 = select(_e1735, _e1732, (_e1732 > _e1735));
                                                                        let _e1740 = bitcast<f32>((bitcast<u32>(_e1711) & 2147483647u));
                                                                        let _e1742 = select(_e1740, _e1737, (_e1737 > _e1740));
                                                                        let _e1745 = bitcast<f32>((bitcast<u32>(_e1713) & 2147483647u));
                                                                        let _e1748 = bitcast<f32>((bitcast<u32>(_e1714) & 2147483647u));
                                                                        let _e1750 = select(_e1748, _e1745, (_e1745 > _e1748));
                                                                        let _e1753 = bitcast<f32>((bitcast<u32>(_e1715) & 2147483647u));
                                                                        let _e1755 = select(_e1753, _e1750, (_e1750 > _e1753));
                                                                        let _e1757 = select(_e1742, _e1729, (_e1729 > _e1742));
                                                                        let _e1759 = select(_e1755, _e1757, (_e1757 > _e1755));
                                                                        if (_e1729 == _e1759) {
                                                                            phi_2359_ = _e1566;
                                                                            phi_2360_ = _e1563;
                                                                            phi_2361_ = _e1553;
                                                                            phi_2362_ = _e1550;
                                                                            phi_2363_ = _e1702;
                                                                            phi_2364_ = _e1716;
                                                                            phi_2365_ = _e1712;
                                                                            phi_2366_ = _e1708;
                                                                        } else {
                                                                            let _e1761 = (_e1742 == _e1759);
                                                                            let _e1766 = vec3(_e1761);
                                                                            phi_2359_ = select(_e1553, _e1579, _e1761);
                                                                            phi_2360_ = select(_e1550, _e1576, _e1761);
                                                                            phi_2361_ = select(_e1579, _e1566, _e1761);
                                                                            phi_2362_ = select(_e1576, _e1563, _e1761);
                                                                            phi_2363_ = select(_e1704, _e1703, _e1766);
                                                                            phi_2364_ = select(_e1712, _e1708, _e1766);
                                                                            phi_2365_ = select(_e1708, _e1716, _e1766);
                                                                            phi_2366_ = select(_e1716, _e1712, _e1766);
                                                                        }
                                                                        let _e1772 = phi_2359_;
                                                                        let _e1774 = phi_2360_;
                                                                        let _e1776 = phi_2361_;
                                                                        let _e1778 = phi_2362_;
                                                                        let _e1780 = phi_2363_;
                                                                        let _e1782 = phi_2364_;
                                                                        let _e1784 = phi_2365_;
                                                                        let _e1786 = phi_2366_;
                                                                        let _e1793 = ((_e1784.y * _e1782.z) - (_e1782.y * _e1784.z));
                                                                        let _e1798 = ((_e1784.z * _e1782.x) - (_e1782.z * _e1784.x));
                                                                        let _e1801 = ((_e1784.x * _e1782.y) - (_e1782.x * _e1784.y));
                                                                        if (_e1601 >= _e1605) {
                                                                            phi_2397_ = select(true, false, (_e1601 >= _e1609));
                                                                        } else {
                                                                            phi_2397_ = true;
                                                                        }
                                                                        let _e1806 = phi_2397_;
                                                                        if _e1806 {
                                                                            phi_2406_ = select(_e1704, _e1703, vec3((_e1605 >= _e1609)));
                                                                        } else {
                                                                            phi_2406_ = _e1702;
                                                                        }
                                                                        let _e1811 = phi_2406_;
                                                                        let _e1822 = (((_e1793 * (_e1811.x - _e394)) + (_e1798 * (_e1811.y - _e431))) + (_e1801 * (_e1811.z - _e467)));
                                                                        let _e1827 = (((_e1793 * _e419) + (_e1798 * _e455)) + (_e1801 * _e491));
                                                                        let _e1828 = (_e1774 - _e1778);
                                                                        let _e1829 = (_e1772 - _e1776);
                                                                        let _e1837 = (-(((_e1778 * _e1828) + (_e1776 * _e1829))) / ((_e1828 * _e1828) + (_e1829 * _e1829)));
                                                                        let _e1839 = select(1f, _e1837, (_e1837 < 1f));
                                                                        let _e1841 = select(0f, _e1839, (_e1839 > 0f));
                                                                        let _e1854 = ((_e1780.x + (_e1786.x * _e1841)) - _e394);
                                                                        let _e1855 = ((_e1780.y + (_e1786.y * _e1841)) - _e431);
                                                                        let _e1856 = ((_e1780.z + (_e1786.z * _e1841)) - _e467);
                                                                        let _e1857 = (_e1856 / _e491);
                                                                        let _e1869 = bitcast<f32>((bitcast<u32>(_e1854) & 2147483647u));
                                                                        let _e1872 = bitcast<f32>((bitcast<u32>(_e1855) & 2147483647u));
                                                                        let _e1874 = select(_e1872, _e1869, (_e1869 > _e1872));
                                                                        let _e1877 = bitcast<f32>((bitcast<u32>(_e1856) & 2147483647u));
                                                                        let _e1879 = select(_e1877, _e1874, (_e1874 > _e1877));
                                                                        let _e1885 = bitcast<f32>((bitcast<u32>(_e1793) & 2147483647u));
                                                                        let _e1888 = bitcast<f32>((bitcast<u32>(_e1798) & 2147483647u));
                                                                        let _e1890 = select(_e1888, _e1885, (_e1885 > _e1888));
                                                                        let _e1893 = bitcast<f32>((bitcast<u32>(_e1801) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1793 * _e1854) + (_e1798 * _e1855)) + (_e1801 * _e1856)) - _e1822)) & 2147483647u)) <= ((0.0000009536743f * select(_e1759, _e1879, (_e1879 > _e1759))) * select(_e1893, _e1890, (_e1890 > _e1893)))) {
                                                                            let _e1903 = bitcast<f32>((bitcast<u32>(_e1784.x) & 2147483647u));
                                                                            let _e1906 = bitcast<f32>((bitcast<u32>(_e1784.y) & 2147483647u));
                                                                            let _e1908 = select(_e1906, _e1903, (_e1903 > _e1906));
                                                                            let _e1911 = bitcast<f32>((bitcast<u32>(_e1784.z) & 2147483647u));
                                                                            let _e1917 = bitcast<f32>((bitcast<u32>(_e1782.x) & 2147483647u));
                                                                            let _e1920 = bitcast<f32>((bitcast<u32>(_e1782.y) & 2147483647u));
                                                                            let _e1922 = select(_e1920, _e1917, (_e1917 > _e1920));
                                                                            let _e1925 = bitcast<f32>((bitcast<u32>(_e1782.z) & 2147483647u));
                                                                            let _e1929 = (bitcast<f32>((bitcast<u32>(_e1827) & 2147483647u)) > ((0.0000038146973f * select(_e1911, _e1908, (_e1908 > _e1911))) * select(_e1925, _e1922, (_e1922 > _e1925))));
                                                                            if _e1929 {
                                                                                phi_2571_ = (_e1822 / _e1827);
                                                                            } else {
                                                                                phi_2571_ = f32();
                                                                            }
                                                                            let _e1932 = phi_2571_;
                                                                            phi_2573_ = _e1932;
                                                                            phi_2574_ = select(true, false, _e1929);
                                                                        } else {
                                                                            phi_2573_ = f32();
                                                                            phi_2574_ = true;
                                                                        }
                                                                        let _e1935 = phi_2573_;
                                                                        let _e1937 = phi_2574_;
                                                                        if _e1937 {
                                                                            let _e1945 = (((_e1793 * (_e1854 - (_e419 * _e1857))) + (_e1798 * (_e1855 - (_e455 * _e1857)))) / _e1827);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1945) & 2147483647u)) <= _e1759) {
                                                                                phi_2594_ = (_e1857 + _e1945);
                                                                            } else {
                                                                                phi_2594_ = _e1857;
                                                                            }
                                                                            let _e1952 = phi_2594_;
                                                                            phi_2595_ = _e1952;
                                                                        } else {
                                                                            phi_2595_ = _e1935;
                                                                        }
                                                                        let _e1954 = phi_2595_;
                                                                        let _e1956 = select(_e1692, _e1954, (_e1954 < _e1692));
                                                                        let _e1958 = select(_e1684, _e1956, (_e1956 > _e1684));
                                                                        if (_e1958 >= _e540) {
                                                                            let _e1960 = (_e1958 <= _e1110.member_1);
                                                                            if _e1960 {
                                                                                let _e1961 = (1f / _e1611);
                                                                                phi_2618_ = type_21(_e1958, (_e1605 * _e1961), (_e1609 * _e1961), _e1170);
                                                                            } else {
                                                                                phi_2618_ = type_21();
                                                                            }
                                                                            let _e1966 = phi_2618_;
                                                                            phi_2620_ = _e1966;
                                                                            phi_2621_ = select(true, false, _e1960);
                                                                        } else {
                                                                            phi_2620_ = type_21();
                                                                            phi_2621_ = true;
                                                                        }
                                                                        let _e1969 = phi_2620_;
                                                                        let _e1971 = phi_2621_;
                                                                        if _e1971 {
                                                                            phi_2625_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2625_ = _e1969;
                                                                        }
                                                                        let _e1973 = phi_2625_;
                                                                        phi_2626_ = _e1973;
                                                                    }
                                                                    let _e1975 = phi_2626_;
                                                                    phi_2627_ = _e1975;
                                                                    phi_2628_ = _e1701;
                                                                }
                                                                let _e1977 = phi_2627_;
                                                                let _e1979 = phi_2628_;
                                                                phi_2632_ = _e1977;
                                                                phi_2633_ = _e1979;
                                                            }
                                                            let _e1981 = phi_2632_;
                                                            let _e1983 = phi_2633_;
                                                            phi_2634_ = _e1981;
                                                            phi_2635_ = _e1636;
                                                            phi_2636_ = _e1983;
                                                        }
                                                        let _e1985 = phi_2634_;
                                                        let _e1987 = phi_2635_;
                                                        let _e1989 = phi_2636_;
                                                        phi_2637_ = _e1985;
                                                        phi_2638_ = _e1987;
                                                        phi_2639_ = _e1989;
                                                    }
                                                    let _e1991 = phi_2637_;
                                                    let _e1993 = phi_2638_;
                                                    let _e1995 = phi_2639_;
                                                    phi_2647_ = _e1991;
                                                    phi_2648_ = select(_e1995, true, _e1993);
                                                } else {
                                                    phi_2647_ = type_21();
                                                    phi_2648_ = true;
                                                }
                                                let _e1998 = phi_2647_;
                                                let _e2000 = phi_2648_;
                                                if _e2000 {
                                                    phi_2652_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2652_ = _e1998;
                                                }
                                                let _e2002 = phi_2652_;
                                                if (_e2002.member_3 != 4294967295u) {
                                                    if (_e1170 == _e168) {
                                                        phi_2981_ = false;
                                                    } else {
                                                        let _e2006 = (_e1170 < arrayLength((&global_4.member)));
                                                        if _e2006 {
                                                            if _e2006 {
                                                            } else {
                                                                phi_4588_ = true;
                                                                break;
                                                            }
                                                            let _e2008 = global_4.member[_e1170];
                                                            phi_2675_ = _e2008;
                                                        } else {
                                                            phi_2675_ = 4294967295u;
                                                        }
                                                        let _e2010 = phi_2675_;
                                                        let _e2011 = (_e2010 < arrayLength((&global_5.member)));
                                                        if _e2011 {
                                                            if _e2011 {
                                                            } else {
                                                                phi_4588_ = true;
                                                                break;
                                                            }
                                                            let _e2013 = global_5.member[_e2010];
                                                            phi_2689_ = _e2013;
                                                        } else {
                                                            phi_2689_ = 0i;
                                                        }
                                                        let _e2015 = phi_2689_;
                                                        let _e2016 = (_e2015 == 0i);
                                                        if _e2016 {
                                                            phi_2980_ = true;
                                                        } else {
                                                            if _e386 {
                                                                phi_2710_ = vec3<f32>(_e1539[0][0], _e1539[0][1], _e1539[0][2]);
                                                            } else {
                                                                if (_e362 == 1u) {
                                                                    phi_2709_ = vec3<f32>(_e1539[0][2], _e1539[0][0], _e1539[0][1]);
                                                                } else {
                                                                    phi_2709_ = vec3<f32>(_e1539[0][1], _e1539[0][2], _e1539[0][0]);
                                                                }
                                                                let _e2021 = phi_2709_;
                                                                phi_2710_ = _e2021;
                                                            }
                                                            let _e2024 = phi_2710_;
                                                            if _e386 {
                                                                phi_2727_ = vec3<f32>(_e1539[1][0], _e1539[1][1], _e1539[1][2]);
                                                            } else {
                                                                if (_e362 == 1u) {
                                                                    phi_2726_ = vec3<f32>(_e1539[1][2], _e1539[1][0], _e1539[1][1]);
                                                                } else {
                                                                    phi_2726_ = vec3<f32>(_e1539[1][1], _e1539[1][2], _e1539[1][0]);
                                                                }
                                                                let _e2029 = phi_2726_;
                                                                phi_2727_ = _e2029;
                                                            }
                                                            let _e2032 = phi_2727_;
                                                            if _e386 {
                                                                phi_2744_ = vec3<f32>(_e1539[2][0], _e1539[2][1], _e1539[2][2]);
                                                            } else {
                                                                if (_e362 == 1u) {
                                                                    phi_2743_ = vec3<f32>(_e1539[2][2], _e1539[2][0], _e1539[2][1]);
                                                                } else {
                                                                    phi_2743_ = vec3<f32>(_e1539[2][1], _e1539[2][2], _e1539[2][0]);
                                                                }
                                                                let _e2037 = phi_2743_;
                                                                phi_2744_ = _e2037;
                                                            }
                                                            let _e2040 = phi_2744_;
                                                            let _e2043 = (_e2032.x - _e2024.x);
                                                            let _e2046 = (_e2032.y - _e2024.y);
                                                            let _e2049 = (_e2032.z - _e2024.z);
                                                            let _e2051 = (_e2040.x - _e2024.x);
                                                            let _e2053 = (_e2040.y - _e2024.y);
                                                            let _e2055 = (_e2040.z - _e2024.z);
                                                            if (_e240.member_1 == 1u) {
                                                                phi_2780_ = (vec3<f32>(_e240.member[0], _e240.member[1], _e240.member[2]) - _e2024);
                                                            } else {
                                                                phi_2780_ = vec3<f32>(_e240.member[0], _e240.member[1], _e240.member[2]);
                                                            }
                                                            let _e2070 = phi_2780_;
                                                            let _e2076 = bitcast<f32>((bitcast<u32>((_e2043 * _e2053)) ^ _e240.member_3[0]));
                                                            let _e2080 = bitcast<f32>((bitcast<u32>((_e2046 * _e2051)) ^ _e240.member_3[0]));
                                                            let _e2084 = bitcast<f32>((bitcast<u32>((_e2046 * _e2055)) ^ _e240.member_3[0]));
                                                            let _e2088 = bitcast<f32>((bitcast<u32>((_e2049 * _e2053)) ^ _e240.member_3[0]));
                                                            let _e2092 = bitcast<f32>((bitcast<u32>((_e2049 * _e2051)) ^ _e240.member_3[0]));
                                                            let _e2096 = bitcast<f32>((bitcast<u32>((_e2043 * _e2055)) ^ _e240.member_3[0]));
                                                            let _e2097 = (_e2084 - _e2088);
                                                            let _e2098 = (_e2092 - _e2096);
                                                            let _e2099 = (_e2076 - _e2080);
                                                            let _e2123 = (bitcast<f32>((bitcast<u32>(_e2084) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2088) & 2147483647u)));
                                                            let _e2130 = (bitcast<f32>((bitcast<u32>(_e2092) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2096) & 2147483647u)));
                                                            let _e2137 = (bitcast<f32>((bitcast<u32>(_e2076) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e2080) & 2147483647u)));
                                                            if (_e240.member_2 == 0f) {
                                                                phi_2962_ = 0f;
                                                            } else {
                                                                let _e2167 = bitcast<f32>((bitcast<u32>(_e2097) & 2147483647u));
                                                                let _e2170 = bitcast<f32>((bitcast<u32>(_e2098) & 2147483647u));
                                                                let _e2173 = bitcast<f32>((bitcast<u32>(_e2099) & 2147483647u));
                                                                let _e2175 = select(_e2173, _e2170, (_e2170 > _e2173));
                                                                let _e2179 = select(_e2173, _e2170, (_e2170 < _e2173));
                                                                let _e2183 = select(_e2170, _e2167, (_e2167 < _e2170));
                                                                let _e2185 = select(_e2170, _e2167, (_e2167 > _e2170));
                                                                let _e2187 = select(_e2173, _e2185, (_e2185 < _e2173));
                                                                phi_2962_ = bitcast<f32>((bitcast<u32>((_e240.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e2175, _e2167, (_e2167 > _e2175)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e2187, _e2183, (_e2183 > _e2187)))) ^ _e240.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e2179, _e2167, (_e2167 < _e2179)))) ^ _e240.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e2123 + _e2130) + _e2137))) ^ _e240.member_3[0]))) * 1.0000005f)) ^ _e240.member_3[0])))) ^ _e240.member_3[0]));
                                                            }
                                                            let _e2214 = phi_2962_;
                                                            phi_2980_ = (_e2016 || !(((((bitcast<f32>((bitcast<u32>((_e2070.x * _e2097)) ^ _e240.member_3[0])) + bitcast<f32>((bitcast<u32>((_e2070.y * _e2098)) ^ _e240.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e2070.z * _e2099)) ^ _e240.member_3[0]))) * f32(-(_e2015))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2070.x) & 2147483647u)) * _e2123)) ^ _e240.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2070.y) & 2147483647u)) * _e2130)) ^ _e240.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e2070.z) & 2147483647u)) * _e2137)) ^ _e240.member_3[0]))))) ^ _e240.member_3[0])) + _e2214) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e2228 = phi_2980_;
                                                        phi_2981_ = _e2228;
                                                    }
                                                    let _e2230 = phi_2981_;
                                                    if _e2230 {
                                                        if (_e2002.member < _e1110.member.member) {
                                                            phi_3001_ = true;
                                                        } else {
                                                            if (_e2002.member == _e1110.member.member) {
                                                                phi_3000_ = (_e2002.member_3 < _e1110.member.member_3);
                                                            } else {
                                                                phi_3000_ = false;
                                                            }
                                                            let _e2240 = phi_3000_;
                                                            phi_3001_ = _e2240;
                                                        }
                                                        let _e2242 = phi_3001_;
                                                        if _e2242 {
                                                            phi_3007_ = type_38(_e2002, _e2002.member);
                                                        } else {
                                                            phi_3007_ = _e1110;
                                                        }
                                                        let _e2245 = phi_3007_;
                                                        phi_3008_ = _e2245;
                                                    } else {
                                                        phi_3008_ = _e1110;
                                                    }
                                                    let _e2247 = phi_3008_;
                                                    phi_3009_ = _e2247;
                                                } else {
                                                    phi_3009_ = _e1110;
                                                }
                                                let _e2249 = phi_3009_;
                                                phi_1094_ = _e2249;
                                            } else {
                                                phi_1094_ = type_38();
                                            }
                                            let _e2251 = phi_1094_;
                                            continue;
                                            continuing {
                                                phi_1093_ = _e2251;
                                                phi_1096_ = _e1125;
                                                phi_4588_ = _e582;
                                                break if !(_e1131);
                                            }
                                        }
                                        let _e2254 = phi_4588_;
                                        phi_4801_ = _e2254;
                                        if _e2254 {
                                            break;
                                        }
                                        phi_4805_ = _e2254;
                                        let _e2522 = local_11;
                                        phi_4249_ = _e2522;
                                        phi_4250_ = _e623;
                                        phi_4251_ = false;
                                        phi_4252_ = _e627;
                                    } else {
                                        if (_e623.member_1 >= _e100) {
                                            phi_3805_ = type_58(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_57(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_57(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e623.member_1 < _e100) {
                                            } else {
                                                phi_4801_ = true;
                                                break;
                                            }
                                            let _e639 = (_e362 * 2u);
                                            let _e641 = ((1u + _e639) % 7u);
                                            if (_e641 < 7u) {
                                            } else {
                                                phi_4801_ = true;
                                                break;
                                            }
                                            let _e646 = global_9.member[_e623.member_1][_e641];
                                            let _e648 = ((_e639 + 2u) % 7u);
                                            if (_e648 < 7u) {
                                            } else {
                                                phi_4801_ = true;
                                                break;
                                            }
                                            let _e653 = global_9.member[_e623.member_1][_e648];
                                            let _e654 = (_e361 * 2u);
                                            let _e656 = ((1u + _e654) % 7u);
                                            if (_e656 < 7u) {
                                            } else {
                                                phi_4801_ = true;
                                                break;
                                            }
                                            let _e661 = global_9.member[_e623.member_1][_e656];
                                            let _e663 = ((_e654 + 2u) % 7u);
                                            if (_e663 < 7u) {
                                            } else {
                                                phi_4801_ = true;
                                                break;
                                            }
                                            let _e668 = global_9.member[_e623.member_1][_e663];
                                            let _e669 = (_e363 * 2u);
                                            let _e671 = ((1u + _e669) % 7u);
                                            if (_e671 < 7u) {
                                            } else {
                                                phi_4801_ = true;
                                                break;
                                            }
                                            let _e676 = global_9.member[_e623.member_1][_e671];
                                            let _e678 = ((_e669 + 2u) % 7u);
                                            if (_e678 < 7u) {
                                            } else {
                                                phi_4801_ = true;
                                                break;
                                            }
                                            let _e683 = global_9.member[_e623.member_1][_e678];
                                            let _e706 = (bitcast<f32>((bitcast<u32>((_e623.member.member_1.x - _e623.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e707 = (bitcast<f32>((bitcast<u32>((_e623.member.member_1.y - _e623.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e708 = (bitcast<f32>((bitcast<u32>((_e623.member.member_1.z - _e623.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e710 = select(_e159, _e706, (_e706 > _e159));
                                            let _e712 = select(_e159, _e707, (_e707 > _e159));
                                            let _e714 = select(_e159, _e708, (_e708 > _e159));
                                            let _e739 = bitcast<u32>((f32(bitcast<i32>((_e646 & 2097151u))) * _e710));
                                            let _e744 = (bitcast<i32>((_e646 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e747 = bitcast<f32>((_e739 & bitcast<u32>(_e744)));
                                            let _e748 = bitcast<u32>((f32(bitcast<i32>((_e661 & 2097151u))) * _e712));
                                            let _e753 = (bitcast<i32>((_e661 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e756 = bitcast<f32>((_e748 & bitcast<u32>(_e753)));
                                            let _e757 = bitcast<u32>((f32(bitcast<i32>((_e676 & 2097151u))) * _e714));
                                            let _e762 = (bitcast<i32>((_e676 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e765 = bitcast<f32>((_e757 & bitcast<u32>(_e762)));
                                            let _e769 = bitcast<f32>((_e739 & bitcast<u32>(~(_e744))));
                                            let _e773 = bitcast<f32>((_e748 & bitcast<u32>(~(_e753))));
                                            let _e777 = bitcast<f32>((_e757 & bitcast<u32>(~(_e762))));
                                            let _e778 = bitcast<u32>((f32(bitcast<i32>((_e653 & 2097151u))) * _e710));
                                            let _e783 = (bitcast<i32>((_e653 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e786 = bitcast<f32>((_e778 & bitcast<u32>(_e783)));
                                            let _e787 = bitcast<u32>((f32(bitcast<i32>((_e668 & 2097151u))) * _e712));
                                            let _e792 = (bitcast<i32>((_e668 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e795 = bitcast<f32>((_e787 & bitcast<u32>(_e792)));
                                            let _e796 = bitcast<u32>((f32(bitcast<i32>((_e683 & 2097151u))) * _e714));
                                            let _e801 = (bitcast<i32>((_e683 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e804 = bitcast<f32>((_e796 & bitcast<u32>(_e801)));
                                            let _e808 = bitcast<f32>((_e778 & bitcast<u32>(~(_e783))));
                                            let _e812 = bitcast<f32>((_e787 & bitcast<u32>(~(_e792))));
                                            let _e816 = bitcast<f32>((_e796 & bitcast<u32>(~(_e801))));
                                            let _e817 = (_e623.member.member.x + _e747);
                                            let _e818 = (_e623.member.member.y + _e756);
                                            let _e819 = (_e623.member.member.z + _e765);
                                            let _e822 = (_e623.member.member_1.x - _e786);
                                            let _e823 = (_e623.member.member_1.y - _e795);
                                            let _e824 = (_e623.member.member_1.z - _e804);
                                            let _e843 = (_e822 - _e817);
                                            let _e844 = (_e823 - _e818);
                                            let _e845 = (_e824 - _e819);
                                            let _e847 = select(_e844, _e843, (_e843 > _e844));
                                            let _e849 = select(_e845, _e847, (_e847 > _e845));
                                            if (_e849 < (1024f * _e159)) {
                                                phi_3506_ = 0u;
                                            } else {
                                                phi_3506_ = select(2u, 1u, (_e849 < (2097152f * _e159)));
                                            }
                                            let _e856 = phi_3506_;
                                            switch bitcast<i32>(_e856) {
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
                                            let _e859 = phi_3512_;
                                            let _e865 = global_9.member[_e623.member_1][0u];
                                            let _e869 = global_9.member[_e623.member_1][2u];
                                            let _e873 = global_9.member[_e623.member_1][4u];
                                            let _e877 = global_9.member[_e623.member_1][6u];
                                            let _e889 = (((_e869 >> bitcast<u32>(22i)) | ((_e873 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e877 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e890 = (_e865 & 268435455u);
                                            let _e891 = (_e889 & 268435455u);
                                            let _e894 = ((_e865 >> bitcast<u32>(28u)) & 7u);
                                            let _e902 = ((_e865 >> bitcast<u32>(31i)) | (((_e889 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e903 = (_e894 != 0u);
                                            if (_e894 == 0u) {
                                                phi_3767_ = _e890;
                                            } else {
                                                if (_e894 == 7u) {
                                                    phi_3766_ = 2147483648u;
                                                } else {
                                                    phi_3766_ = ((2147483648u | (_e894 << bitcast<u32>(28u))) | (_e891 & 268435455u));
                                                }
                                                let _e912 = phi_3766_;
                                                phi_3767_ = _e912;
                                            }
                                            let _e914 = phi_3767_;
                                            if _e903 {
                                                let _e915 = (_e894 != 7u);
                                                if _e915 {
                                                    phi_3777_ = (_e891 + (_e894 * ((3u * _e859) + 1u)));
                                                } else {
                                                    phi_3777_ = u32();
                                                }
                                                let _e919 = phi_3777_;
                                                phi_3779_ = _e919;
                                                phi_3780_ = select(true, false, _e915);
                                            } else {
                                                phi_3779_ = u32();
                                                phi_3780_ = true;
                                            }
                                            let _e922 = phi_3779_;
                                            let _e924 = phi_3780_;
                                            if (_e902 == 0u) {
                                                phi_3801_ = (_e890 + select(0u, 1u, !(_e903)));
                                            } else {
                                                if (_e902 == 7u) {
                                                    phi_3800_ = 2147483648u;
                                                } else {
                                                    phi_3800_ = ((2147483648u | (_e902 << bitcast<u32>(28u))) | (select(_e922, _e891, _e924) & 268435455u));
                                                }
                                                let _e937 = phi_3800_;
                                                phi_3801_ = _e937;
                                            }
                                            let _e939 = phi_3801_;
                                            phi_3805_ = type_58(array<vec4<f32>, 3>(vec4<f32>(_e817, (_e623.member.member.x + _e769), _e822, (_e623.member.member_1.x - _e808)), vec4<f32>(_e818, (_e623.member.member.y + _e773), _e823, (_e623.member.member_1.y - _e812)), vec4<f32>(_e819, (_e623.member.member.z + _e777), _e824, (_e623.member.member_1.z - _e816))), type_57(type_33((_e623.member.member + vec4<f32>(_e747, _e756, _e765, 0f)), (_e623.member.member_1 - vec4<f32>(_e786, _e795, _e804, 0f))), _e914), type_57(type_33((_e623.member.member + vec4<f32>(_e769, _e773, _e777, 0f)), (_e623.member.member_1 - vec4<f32>(_e808, _e812, _e816, 0f))), _e939));
                                        }
                                        let _e944 = phi_3805_;
                                        let _e956 = ((_e944.member[0].x - _e417) * _e422);
                                        let _e957 = ((_e944.member[0].y - _e417) * _e422);
                                        let _e958 = ((_e944.member[0].z - _e418) * _e422);
                                        let _e959 = ((_e944.member[0].w - _e418) * _e422);
                                        let _e969 = ((_e944.member[1].x - _e453) * _e458);
                                        let _e970 = ((_e944.member[1].y - _e453) * _e458);
                                        let _e971 = ((_e944.member[1].z - _e454) * _e458);
                                        let _e972 = ((_e944.member[1].w - _e454) * _e458);
                                        let _e982 = ((_e944.member[2].x - _e489) * _e494);
                                        let _e983 = ((_e944.member[2].y - _e489) * _e494);
                                        let _e984 = ((_e944.member[2].z - _e490) * _e494);
                                        let _e985 = ((_e944.member[2].w - _e490) * _e494);
                                        let _e987 = select(_e984, _e982, (_e982 < _e984));
                                        let _e989 = select(_e985, _e983, (_e983 < _e985));
                                        let _e991 = select(_e984, _e982, (_e982 > _e984));
                                        let _e993 = select(_e985, _e983, (_e983 > _e985));
                                        let _e995 = select(_e958, _e956, (_e956 < _e958));
                                        let _e997 = select(_e959, _e957, (_e957 < _e959));
                                        let _e999 = select(_e971, _e969, (_e969 < _e971));
                                        let _e1001 = select(_e972, _e970, (_e970 < _e972));
                                        let _e1003 = select(_e999, _e995, (_e995 > _e999));
                                        let _e1005 = select(_e1001, _e997, (_e997 > _e1001));
                                        let _e1007 = select(_e987, _e1003, (_e1003 > _e987));
                                        let _e1009 = select(_e989, _e1005, (_e1005 > _e989));
                                        let _e1011 = select(_e958, _e956, (_e956 > _e958));
                                        let _e1013 = select(_e959, _e957, (_e957 > _e959));
                                        let _e1015 = select(_e971, _e969, (_e969 > _e971));
                                        let _e1017 = select(_e972, _e970, (_e970 > _e972));
                                        let _e1019 = select(_e1015, _e1011, (_e1011 < _e1015));
                                        let _e1021 = select(_e1017, _e1013, (_e1013 < _e1017));
                                        let _e1026 = -(_e987);
                                        let _e1027 = -(_e989);
                                        let _e1034 = (select(_e991, _e1019, (_e1019 < _e991)) + (select(_e1026, _e991, (_e991 > _e1026)) * 0.0000019073523f));
                                        let _e1035 = (select(_e993, _e1021, (_e1021 < _e993)) + (select(_e1027, _e993, (_e993 > _e1027)) * 0.0000019073523f));
                                        let _e1037 = select(_e540, _e1007, (_e1007 > _e540));
                                        let _e1039 = select(_e540, _e1009, (_e1009 > _e540));
                                        let _e1044 = (_e1037 <= select(_e584.member_1, _e1034, (_e1034 < _e584.member_1)));
                                        let _e1045 = (_e1039 <= select(_e584.member_1, _e1035, (_e1035 < _e584.member_1)));
                                        let _e1046 = (_e1037 <= _e1039);
                                        if _e1044 {
                                            if _e1045 {
                                                if _e1046 {
                                                    phi_4149_ = _e944.member_2;
                                                } else {
                                                    phi_4149_ = _e944.member_1;
                                                }
                                                let _e1050 = phi_4149_;
                                                let _e1072 = (_e627 % 128u);
                                                let _e1073 = (_e1072 < 128u);
                                                if _e1073 {
                                                } else {
                                                    phi_4801_ = true;
                                                    break;
                                                }
                                                local_8[_e1072] = _e1050.member_1;
                                                if _e1073 {
                                                } else {
                                                    phi_4801_ = true;
                                                    break;
                                                }
                                                local_7[_e1072] = _e1050.member.member.x;
                                                if _e1073 {
                                                } else {
                                                    phi_4801_ = true;
                                                    break;
                                                }
                                                local_6[_e1072] = _e1050.member.member.y;
                                                if _e1073 {
                                                } else {
                                                    phi_4801_ = true;
                                                    break;
                                                }
                                                local_5[_e1072] = _e1050.member.member.z;
                                                if _e1073 {
                                                } else {
                                                    phi_4801_ = true;
                                                    break;
                                                }
                                                local_4[_e1072] = _e1050.member.member_1.x;
                                                if _e1073 {
                                                } else {
                                                    phi_4801_ = true;
                                                    break;
                                                }
                                                local_3[_e1072] = _e1050.member.member_1.y;
                                                if _e1073 {
                                                } else {
                                                    phi_4801_ = true;
                                                    break;
                                                }
                                                local_2[_e1072] = _e1050.member.member_1.z;
                                                if _e1073 {
                                                } else {
                                                    phi_4801_ = true;
                                                    break;
                                                }
                                                local_9[_e1072] = select(_e1039, _e1037, (_e1037 > _e1039));
                                                if _e1046 {
                                                    phi_4226_ = _e944.member_1;
                                                } else {
                                                    phi_4226_ = _e944.member_2;
                                                }
                                                let _e1086 = phi_4226_;
                                                phi_4227_ = _e1086;
                                                phi_4228_ = (_e627 + 1u);
                                            } else {
                                                phi_4227_ = type_57();
                                                phi_4228_ = u32();
                                            }
                                            let _e1088 = phi_4227_;
                                            let _e1090 = phi_4228_;
                                            phi_4230_ = _e1088;
                                            phi_4231_ = _e1090;
                                            phi_4232_ = select(true, false, _e1045);
                                        } else {
                                            phi_4230_ = type_57();
                                            phi_4231_ = u32();
                                            phi_4232_ = true;
                                        }
                                        let _e1093 = phi_4230_;
                                        let _e1095 = phi_4231_;
                                        let _e1097 = phi_4232_;
                                        if _e1097 {
                                            if _e1044 {
                                                phi_4241_ = _e944.member_1;
                                            } else {
                                                phi_4241_ = _e944.member_2;
                                            }
                                            let _e1101 = phi_4241_;
                                            phi_4246_ = _e1101;
                                            phi_4247_ = select(_e1045, true, _e1044);
                                        } else {
                                            phi_4246_ = _e1093;
                                            phi_4247_ = _e625;
                                        }
                                        let _e1104 = phi_4246_;
                                        let _e1106 = phi_4247_;
                                        phi_4805_ = _e582;
                                        phi_4249_ = _e584;
                                        phi_4250_ = _e1104;
                                        phi_4251_ = _e1106;
                                        phi_4252_ = select(_e1095, _e627, _e1097);
                                    }
                                    let _e2256 = phi_4805_;
                                    let _e2258 = phi_4249_;
                                    let _e2260 = phi_4250_;
                                    let _e2262 = phi_4251_;
                                    let _e2264 = phi_4252_;
                                    phi_4804_ = _e2256;
                                    phi_4253_ = _e2258;
                                    phi_4254_ = _e2260;
                                    phi_4255_ = (_e588 - 1u);
                                    phi_4256_ = _e2262;
                                    phi_4257_ = _e2264;
                                } else {
                                    phi_4804_ = _e582;
                                    phi_4253_ = _e584;
                                    phi_4254_ = _e623;
                                    phi_4255_ = _e588;
                                    phi_4256_ = _e625;
                                    phi_4257_ = _e627;
                                }
                                let _e2266 = phi_4804_;
                                let _e2268 = phi_4253_;
                                let _e2270 = phi_4254_;
                                let _e2272 = phi_4255_;
                                let _e2274 = phi_4256_;
                                let _e2276 = phi_4257_;
                                phi_4803_ = _e2266;
                                phi_4258_ = _e2268;
                                phi_4259_ = _e2270;
                                phi_4260_ = _e2272;
                                phi_4261_ = _e2274;
                                phi_4262_ = _e2276;
                            } else {
                                phi_4803_ = _e582;
                                phi_4258_ = type_38();
                                phi_4259_ = type_57();
                                phi_4260_ = u32();
                                phi_4261_ = bool();
                                phi_4262_ = u32();
                            }
                            let _e2278 = phi_4803_;
                            let _e2280 = phi_4258_;
                            let _e2282 = phi_4259_;
                            let _e2284 = phi_4260_;
                            let _e2286 = phi_4261_;
                            let _e2288 = phi_4262_;
                            phi_4802_ = _e2278;
                            phi_967_ = _e2280;
                            phi_970_ = _e2282;
                            phi_972_ = _e2284;
                            phi_974_ = _e2286;
                            phi_976_ = _e2288;
                            phi_4263_ = _e596;
                        } else {
                            phi_4802_ = _e582;
                            phi_967_ = type_38();
                            phi_970_ = type_57();
                            phi_972_ = u32();
                            phi_974_ = bool();
                            phi_976_ = u32();
                            phi_4263_ = false;
                        }
                        let _e2290 = phi_4802_;
                        let _e2292 = phi_967_;
                        let _e2294 = phi_970_;
                        let _e2296 = phi_972_;
                        let _e2298 = phi_974_;
                        let _e2300 = phi_976_;
                        let _e2302 = phi_4263_;
                        continue;
                        continuing {
                            phi_4594_ = _e2290;
                            phi_966_ = _e2292;
                            phi_969_ = _e2294;
                            phi_971_ = _e2296;
                            phi_973_ = _e2298;
                            phi_975_ = _e2300;
                            phi_4801_ = _e2290;
                            break if !(_e2302);
                        }
                    }
                    let _e2305 = phi_4801_;
                    if _e2305 {
                        break;
                    }
                    let _e2307 = local_10;
                    if (_e2307.member.member_3 != 4294967295u) {
                        let _e2312 = (_e364 / 3i);
                        let _e2319 = bitcast<f32>((bitcast<u32>((_e2312 + 127i)) << bitcast<u32>(23i)));
                        let _e2327 = (((_e2307.member.member * _e2319) * _e2319) * bitcast<f32>((bitcast<u32>(((_e364 - (2i * _e2312)) + 127i)) << bitcast<u32>(23i))));
                        let _e2329 = select(340282350000000000000000000000000000000f, _e2327, (_e2327 < 340282350000000000000000000000000000000f));
                        phi_4315_ = type_21(select(-340282350000000000000000000000000000000f, _e2329, (_e2329 > -340282350000000000000000000000000000000f)), _e2307.member.member_1, _e2307.member.member_2, _e2307.member.member_3);
                    } else {
                        phi_4315_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e2336 = phi_4315_;
                    if _e241 {
                    } else {
                        break;
                    }
                    global_7.member[_e147] = _e2336;
                    if _e162 {
                    } else {
                        break;
                    }
                    let _e2340 = select(0u, 1u, (_e308 <= _e318));
                    if (_e2340 > 0u) {
                        let _e2342 = (1u < _e115);
                        if _e2342 {
                            if (0u < _e115) {
                            } else {
                                break;
                            }
                            let _e2346 = atomicAdd((&global_8.member[0u]), _e2340);
                            if ((_e2346 + _e2340) < _e2346) {
                                if _e2342 {
                                } else {
                                    break;
                                }
                                let _e2351 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                    }
                    let _e2354 = select(0u, 1u, (_e2336.member_3 != 4294967295u));
                    if (_e2354 > 0u) {
                        let _e2356 = (3u < _e115);
                        if _e2356 {
                            if (2u < _e115) {
                            } else {
                                break;
                            }
                            let _e2360 = atomicAdd((&global_8.member[2u]), _e2354);
                            if ((_e2360 + _e2354) < _e2360) {
                                if _e2356 {
                                } else {
                                    break;
                                }
                                let _e2365 = atomicAdd((&global_8.member[3u]), 1u);
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
