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

struct type_18 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_20 {
    member: array<type_18>,
}

struct type_28 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_30 {
    member: array<type_28>,
}

struct type_32 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_33 {
    member: type_32,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_35 {
    member: array<type_33>,
}

struct type_40 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_42 {
    member: array<type_40>,
}

struct type_46 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_49 {
    member: type_28,
    member_1: f32,
}

struct type_54 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_56 {
    member: array<vec4<u32>, 2>,
}

struct type_59 {
    member: array<i32>,
}

struct type_66 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(3) 
var<storage> global_2: type_20;
@group(0) @binding(1) 
var<uniform> global_3: type_56;
@group(0) @binding(2) 
var<storage> global_4: type_42;
@group(0) @binding(4) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage> global_6: type_59;
@group(0) @binding(6) 
var<storage> global_7: type_35;
@group(0) @binding(7) 
var<storage, read_write> global_8: type_30;
@group(0) @binding(8) 
var<storage, read_write> global_9: type_66;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_222_: u32;
    var phi_266_: i32;
    var phi_290_: type_46;
    var phi_396_: i32;
    var phi_397_: i32;
    var phi_407_: bool;
    var phi_417_: u32;
    var phi_418_: u32;
    var phi_420_: bool;
    var phi_425_: u32;
    var phi_457_: i32;
    var phi_475_: f32;
    var phi_481_: f32;
    var phi_492_: f32;
    var phi_498_: f32;
    var phi_521_: f32;
    var phi_532_: f32;
    var phi_541_: f32;
    var phi_547_: f32;
    var phi_558_: f32;
    var phi_564_: f32;
    var phi_587_: f32;
    var phi_598_: f32;
    var phi_607_: f32;
    var phi_613_: f32;
    var phi_624_: f32;
    var phi_630_: f32;
    var phi_653_: f32;
    var phi_664_: f32;
    var phi_764_: f32;
    var phi_765_: f32;
    var phi_2804_: bool;
    var phi_776_: type_49;
    var phi_779_: u32;
    var phi_781_: u32;
    var phi_783_: bool;
    var phi_785_: u32;
    var phi_796_: bool;
    var phi_828_: u32;
    var phi_829_: bool;
    var phi_830_: u32;
    var phi_2241_: type_54;
    var phi_2585_: u32;
    var phi_2613_: u32;
    var phi_2614_: u32;
    var phi_2615_: u32;
    var phi_2617_: u32;
    var phi_2618_: u32;
    var phi_2619_: bool;
    var phi_2628_: u32;
    var phi_2633_: u32;
    var phi_2634_: bool;
    var phi_845_: type_49;
    var phi_848_: type_8;
    var phi_849_: type_8;
    var phi_871_: type_8;
    var phi_892_: u32;
    var phi_981_: array<array<f32, 3>, 3>;
    var phi_1098_: bool;
    var phi_1127_: bool;
    var phi_1528_: f32;
    var phi_1529_: f32;
    var phi_1530_: f32;
    var phi_1531_: f32;
    var phi_1532_: vec3<f32>;
    var phi_1533_: vec3<f32>;
    var phi_1534_: vec3<f32>;
    var phi_1535_: vec3<f32>;
    var phi_1566_: bool;
    var phi_1575_: vec3<f32>;
    var phi_1742_: bool;
    var phi_1766_: f32;
    var phi_1767_: f32;
    var phi_1790_: type_28;
    var phi_1792_: type_28;
    var phi_1793_: bool;
    var phi_1797_: type_28;
    var phi_1798_: type_28;
    var phi_1799_: type_28;
    var phi_1800_: bool;
    var phi_1804_: type_28;
    var phi_1805_: bool;
    var phi_1806_: type_28;
    var phi_1807_: bool;
    var phi_1808_: bool;
    var phi_1809_: type_28;
    var phi_1810_: bool;
    var phi_1811_: bool;
    var phi_1819_: type_28;
    var phi_1820_: bool;
    var phi_1824_: type_28;
    var phi_1847_: u32;
    var phi_1861_: i32;
    var phi_1881_: vec3<f32>;
    var phi_1882_: vec3<f32>;
    var phi_1898_: vec3<f32>;
    var phi_1899_: vec3<f32>;
    var phi_1915_: vec3<f32>;
    var phi_1916_: vec3<f32>;
    var phi_1952_: vec3<f32>;
    var phi_2134_: f32;
    var phi_2152_: bool;
    var phi_2153_: bool;
    var phi_2172_: bool;
    var phi_2173_: bool;
    var phi_2179_: type_49;
    var phi_2180_: type_49;
    var phi_2181_: type_49;
    var phi_846_: type_49;
    var phi_2798_: bool;
    var phi_2968_: bool;
    var phi_2636_: type_49;
    var phi_2637_: u32;
    var phi_2638_: bool;
    var phi_2639_: u32;
    var phi_2967_: bool;
    var phi_2640_: type_49;
    var phi_2641_: u32;
    var phi_2642_: u32;
    var phi_2643_: bool;
    var phi_2644_: u32;
    var phi_2966_: bool;
    var phi_2645_: type_49;
    var phi_2646_: u32;
    var phi_2647_: u32;
    var phi_2648_: bool;
    var phi_2649_: u32;
    var phi_2965_: bool;
    var phi_777_: type_49;
    var phi_780_: u32;
    var phi_782_: u32;
    var phi_784_: bool;
    var phi_786_: u32;
    var phi_2650_: bool;
    var phi_2964_: bool;
    var local_2: type_49;
    var phi_2702_: type_28;
    var local_3: type_49;

    switch bitcast<i32>(0u) {
        default: {
            let _e75 = global;
            let _e77 = arrayLength((&global_4.member));
            let _e79 = arrayLength((&global_2.member));
            let _e91 = arrayLength((&global_9.member));
            let _e95 = (_e75.x + (_e75.y * 2097152u));
            let _e96 = (_e95 < arrayLength((&global_7.member)));
            if _e96 {
                if _e96 {
                } else {
                    break;
                }
                let _e100 = global_7.member[_e95].member_2;
                phi_222_ = _e100;
            } else {
                phi_222_ = 4294967295u;
            }
            let _e102 = phi_222_;
            let _e105 = global_1.member[0u];
            let _e109 = global_3.member[0u][0u];
            let _e113 = global_3.member[0u][1u];
            let _e117 = global_3.member[0u][2u];
            let _e121 = global_3.member[0u][3u];
            let _e125 = global_3.member[1u][0u];
            let _e129 = global_3.member[1u][1u];
            let _e133 = global_3.member[1u][2u];
            let _e137 = global_3.member[1u][3u];
            let _e138 = bitcast<f32>(_e109);
            let _e139 = bitcast<f32>(_e113);
            let _e140 = bitcast<f32>(_e117);
            let _e142 = bitcast<f32>(_e125);
            let _e143 = array<u32, 3>(_e129, _e133, _e137);
            let _e145 = bitcast<i32>(_e105);
            if (_e145 < -126i) {
                phi_266_ = -126i;
            } else {
                phi_266_ = select(_e145, 127i, (_e145 > 127i));
            }
            let _e150 = phi_266_;
            let _e155 = bitcast<f32>((bitcast<u32>((_e150 + 127i)) << bitcast<u32>(23i)));
            let _e161 = bitcast<f32>((bitcast<u32>(((_e145 - _e150) + 127i)) << bitcast<u32>(23i)));
            if (_e121 == 0u) {
                phi_290_ = type_46(array<f32, 3>(_e138, _e139, _e140), _e121, _e142, _e143);
            } else {
                phi_290_ = type_46(array<f32, 3>(((_e138 * _e155) * _e161), ((_e139 * _e155) * _e161), ((_e140 * _e155) * _e161)), _e121, ((_e142 * _e155) * _e161), _e143);
            }
            let _e174 = phi_290_;
            if _e96 {
                let _e175 = (_e95 < arrayLength((&global_8.member)));
                if _e175 {
                    if _e96 {
                    } else {
                        break;
                    }
                    let _e185 = global_7.member[_e95].member.member_2[0u];
                    let _e187 = (bitcast<u32>(_e185) & 2147483647u);
                    let _e193 = global_7.member[_e95].member.member_2[1u];
                    let _e195 = (bitcast<u32>(_e193) & 2147483647u);
                    let _e201 = global_7.member[_e95].member.member_2[2u];
                    let _e203 = (bitcast<u32>(_e201) & 2147483647u);
                    let _e209 = global_7.member[_e95].member.member[0u];
                    let _e211 = (bitcast<u32>(_e209) & 2147483647u);
                    let _e217 = global_7.member[_e95].member.member[1u];
                    let _e219 = (bitcast<u32>(_e217) & 2147483647u);
                    let _e225 = global_7.member[_e95].member.member[2u];
                    let _e227 = (bitcast<u32>(_e225) & 2147483647u);
                    let _e229 = select(_e195, _e187, (_e195 < _e187));
                    let _e231 = select(_e203, _e229, (_e203 < _e229));
                    let _e233 = select(_e211, _e231, (_e211 < _e231));
                    let _e235 = select(_e219, _e233, (_e219 < _e233));
                    let _e237 = select(_e227, _e235, (_e227 < _e235));
                    let _e242 = global_7.member[_e95].member.member_1;
                    let _e244 = (bitcast<u32>(_e242) & 2147483647u);
                    let _e252 = global_7.member[_e95].member.member_3;
                    let _e258 = (((select(_e244, _e237, (_e244 < _e237)) < 2139095040u) && ((bitcast<u32>(_e252) & 2147483647u) <= 2139095040u)) && (_e231 > 0u));
                    if _e258 {
                        let _e261 = (bitcast<u32>(bitcast<f32>(_e231)) & 2147483647u);
                        if (_e261 >= 8388608u) {
                            phi_396_ = (bitcast<i32>((_e261 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_396_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e261)), 32u, (_e261 == 0u))));
                        }
                        let _e275 = phi_396_;
                        phi_397_ = _e275;
                    } else {
                        phi_397_ = 0i;
                    }
                    let _e277 = phi_397_;
                    let _e278 = (_e187 == _e231);
                    if _e278 {
                        phi_407_ = true;
                    } else {
                        phi_407_ = (_e195 == _e231);
                    }
                    let _e281 = phi_407_;
                    let _e282 = select(1u, 0u, _e278);
                    if _e281 {
                        let _e283 = (_e282 + 1u);
                        phi_417_ = _e283;
                        phi_418_ = _e283;
                        phi_420_ = select(true, false, (_e283 == 2u));
                    } else {
                        phi_417_ = u32();
                        phi_418_ = 0u;
                        phi_420_ = true;
                    }
                    let _e287 = phi_417_;
                    let _e289 = phi_418_;
                    let _e291 = phi_420_;
                    if _e291 {
                        phi_425_ = (_e289 + 1u);
                    } else {
                        phi_425_ = 0u;
                    }
                    let _e295 = phi_425_;
                    let _e296 = select(_e287, _e289, _e291);
                    let _e297 = select(_e282, select(2u, _e282, _e281), _e291);
                    let _e298 = -(_e277);
                    if (_e298 < -126i) {
                        phi_457_ = -126i;
                    } else {
                        phi_457_ = select(_e298, 127i, (_e298 > 127i));
                    }
                    let _e303 = phi_457_;
                    let _e308 = bitcast<f32>((bitcast<u32>((_e303 + 127i)) << bitcast<u32>(23i)));
                    let _e314 = bitcast<f32>((bitcast<u32>(((_e298 - _e303) + 127i)) << bitcast<u32>(23i)));
                    let _e319 = global_7.member[_e95].member.member;
                    let _e320 = (_e296 == 0u);
                    if _e320 {
                        phi_475_ = _e319[0];
                    } else {
                        phi_475_ = _e319[1];
                    }
                    let _e324 = phi_475_;
                    let _e325 = (_e296 == 2u);
                    if _e325 {
                        phi_481_ = _e319[2];
                    } else {
                        phi_481_ = _e324;
                    }
                    let _e328 = phi_481_;
                    let _e329 = global_7.member[_e95].member.member_2;
                    if _e320 {
                        phi_492_ = _e329[0];
                    } else {
                        phi_492_ = _e329[1];
                    }
                    let _e333 = phi_492_;
                    if _e325 {
                        phi_498_ = _e329[2];
                    } else {
                        phi_498_ = _e333;
                    }
                    let _e336 = phi_498_;
                    let _e338 = ((_e336 * _e308) * _e314);
                    let _e342 = (bitcast<f32>((bitcast<u32>(_e338) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e342 {
                        let _e346 = (bitcast<f32>((bitcast<u32>(_e328) & 2147483647u)) * 0.00000011920929f);
                        phi_521_ = select(0.00000000000011368684f, _e346, (_e346 > 0.00000000000011368684f));
                    } else {
                        phi_521_ = 0f;
                    }
                    let _e350 = phi_521_;
                    let _e351 = (_e328 + _e350);
                    let _e352 = (_e328 - _e350);
                    let _e353 = select(_e338, 0f, _e342);
                    if _e342 {
                        phi_532_ = 38685626000000000000000000f;
                    } else {
                        phi_532_ = (1f / _e338);
                    }
                    let _e356 = phi_532_;
                    let _e357 = (_e295 == 0u);
                    if _e357 {
                        phi_541_ = _e319[0];
                    } else {
                        phi_541_ = _e319[1];
                    }
                    let _e361 = phi_541_;
                    let _e362 = (_e295 == 2u);
                    if _e362 {
                        phi_547_ = _e319[2];
                    } else {
                        phi_547_ = _e361;
                    }
                    let _e365 = phi_547_;
                    if _e357 {
                        phi_558_ = _e329[0];
                    } else {
                        phi_558_ = _e329[1];
                    }
                    let _e369 = phi_558_;
                    if _e362 {
                        phi_564_ = _e329[2];
                    } else {
                        phi_564_ = _e369;
                    }
                    let _e372 = phi_564_;
                    let _e374 = ((_e372 * _e308) * _e314);
                    let _e378 = (bitcast<f32>((bitcast<u32>(_e374) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e378 {
                        let _e382 = (bitcast<f32>((bitcast<u32>(_e365) & 2147483647u)) * 0.00000011920929f);
                        phi_587_ = select(0.00000000000011368684f, _e382, (_e382 > 0.00000000000011368684f));
                    } else {
                        phi_587_ = 0f;
                    }
                    let _e386 = phi_587_;
                    let _e387 = (_e365 + _e386);
                    let _e388 = (_e365 - _e386);
                    let _e389 = select(_e374, 0f, _e378);
                    if _e378 {
                        phi_598_ = 38685626000000000000000000f;
                    } else {
                        phi_598_ = (1f / _e374);
                    }
                    let _e392 = phi_598_;
                    let _e393 = (_e297 == 0u);
                    if _e393 {
                        phi_607_ = _e319[0];
                    } else {
                        phi_607_ = _e319[1];
                    }
                    let _e397 = phi_607_;
                    let _e398 = (_e297 == 2u);
                    if _e398 {
                        phi_613_ = _e319[2];
                    } else {
                        phi_613_ = _e397;
                    }
                    let _e401 = phi_613_;
                    if _e393 {
                        phi_624_ = _e329[0];
                    } else {
                        phi_624_ = _e329[1];
                    }
                    let _e405 = phi_624_;
                    if _e398 {
                        phi_630_ = _e329[2];
                    } else {
                        phi_630_ = _e405;
                    }
                    let _e408 = phi_630_;
                    let _e410 = ((_e408 * _e308) * _e314);
                    let _e414 = (bitcast<f32>((bitcast<u32>(_e410) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e414 {
                        let _e418 = (bitcast<f32>((bitcast<u32>(_e401) & 2147483647u)) * 0.00000011920929f);
                        phi_653_ = select(0.00000000000011368684f, _e418, (_e418 > 0.00000000000011368684f));
                    } else {
                        phi_653_ = 0f;
                    }
                    let _e422 = phi_653_;
                    let _e423 = (_e401 + _e422);
                    let _e424 = (_e401 - _e422);
                    let _e425 = select(_e410, 0f, _e414);
                    if _e414 {
                        phi_664_ = 38685626000000000000000000f;
                    } else {
                        phi_664_ = (1f / _e410);
                    }
                    let _e428 = phi_664_;
                    let _e431 = bitcast<f32>((bitcast<u32>(_e328) & 2147483647u));
                    let _e434 = bitcast<f32>((bitcast<u32>(_e365) & 2147483647u));
                    let _e436 = select(_e434, _e431, (_e431 > _e434));
                    let _e439 = bitcast<f32>((bitcast<u32>(_e401) & 2147483647u));
                    if (_e258 && (select(_e439, _e436, (_e436 > _e439)) <= 1099511600000f)) {
                        let _e444 = (_e277 / 3i);
                        let _e451 = bitcast<f32>((bitcast<u32>((_e444 + 127i)) << bitcast<u32>(23i)));
                        let _e458 = bitcast<f32>((bitcast<u32>(((_e277 - (2i * _e444)) + 127i)) << bitcast<u32>(23i)));
                        let _e459 = (((_e242 * _e451) * _e451) * _e458);
                        let _e461 = select(340282350000000000000000000000000000000f, _e459, (_e459 < 340282350000000000000000000000000000000f));
                        let _e466 = (((_e252 * _e451) * _e451) * _e458);
                        let _e468 = select(340282350000000000000000000000000000000f, _e466, (_e466 < 340282350000000000000000000000000000000f));
                        phi_764_ = select(-340282350000000000000000000000000000000f, _e468, (_e468 > -340282350000000000000000000000000000000f));
                        phi_765_ = select(-340282350000000000000000000000000000000f, _e461, (_e461 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_764_ = 0f;
                        phi_765_ = 1f;
                    }
                    let _e472 = phi_764_;
                    let _e474 = phi_765_;
                    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_2804_ = false;
                    phi_776_ = type_49(type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e472);
                    phi_779_ = select(0u, 2147483648u, (_e77 == 0u));
                    phi_781_ = ((3u * _e77) + 1u);
                    phi_783_ = (_e474 <= _e472);
                    phi_785_ = 0u;
                    loop {
                        let _e482 = phi_2804_;
                        let _e484 = phi_776_;
                        let _e486 = phi_779_;
                        let _e488 = phi_781_;
                        let _e490 = phi_783_;
                        let _e492 = phi_785_;
                        local_2 = _e484;
                        if _e490 {
                            phi_796_ = true;
                        } else {
                            phi_796_ = (_e492 > 0u);
                        }
                        let _e495 = phi_796_;
                        if _e495 {
                            let _e496 = (_e488 > 0u);
                            if _e496 {
                                if _e490 {
                                    phi_828_ = _e486;
                                    phi_829_ = _e490;
                                    phi_830_ = _e492;
                                } else {
                                    let _e497 = (_e492 - 1u);
                                    let _e498 = (_e497 % 128u);
                                    let _e499 = (_e498 < 128u);
                                    if _e499 {
                                    } else {
                                        phi_2964_ = true;
                                        break;
                                    }
                                    let _e501 = local_1[_e498];
                                    if _e499 {
                                    } else {
                                        phi_2964_ = true;
                                        break;
                                    }
                                    let _e503 = local[_e498];
                                    phi_828_ = _e501;
                                    phi_829_ = (_e503 <= _e484.member_1);
                                    phi_830_ = _e497;
                                }
                                let _e507 = phi_828_;
                                let _e509 = phi_829_;
                                let _e511 = phi_830_;
                                if _e509 {
                                    if ((_e507 & 2147483648u) != 0u) {
                                        phi_845_ = _e484;
                                        phi_848_ = type_8(0u, ((_e507 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e709 = phi_845_;
                                            let _e711 = phi_848_;
                                            local_3 = _e709;
                                            if (_e711.member < _e711.member_1) {
                                                phi_849_ = type_8((_e711.member + 1u), _e711.member_1);
                                                phi_871_ = type_8(1u, _e711.member);
                                            } else {
                                                phi_849_ = _e711;
                                                phi_871_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e724 = phi_849_;
                                            let _e726 = phi_871_;
                                            let _e730 = (bitcast<i32>(_e726.member) != 0i);
                                            if _e730 {
                                                let _e731 = ((_e507 & 268435455u) + _e726.member_1);
                                                let _e732 = (_e731 < _e79);
                                                if _e732 {
                                                    if _e732 {
                                                    } else {
                                                        phi_2798_ = true;
                                                        break;
                                                    }
                                                    let _e736 = global_2.member[_e731].member_1;
                                                    phi_892_ = _e736;
                                                } else {
                                                    phi_892_ = 4294967295u;
                                                }
                                                let _e738 = phi_892_;
                                                if (_e731 >= _e79) {
                                                    phi_981_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e732 {
                                                    } else {
                                                        phi_2798_ = true;
                                                        break;
                                                    }
                                                    let _e740 = (_e296 % 3u);
                                                    let _e741 = (_e295 % 3u);
                                                    let _e742 = (_e297 % 3u);
                                                    if (_e740 < 9u) {
                                                    } else {
                                                        phi_2798_ = true;
                                                        break;
                                                    }
                                                    let _e748 = global_2.member[_e731].member[_e740];
                                                    if (_e741 < 9u) {
                                                    } else {
                                                        phi_2798_ = true;
                                                        break;
                                                    }
                                                    let _e754 = global_2.member[_e731].member[_e741];
                                                    if (_e742 < 9u) {
                                                    } else {
                                                        phi_2798_ = true;
                                                        break;
                                                    }
                                                    let _e760 = global_2.member[_e731].member[_e742];
                                                    let _e762 = (3u + _e740);
                                                    if (_e762 < 9u) {
                                                    } else {
                                                        phi_2798_ = true;
                                                        break;
                                                    }
                                                    let _e768 = global_2.member[_e731].member[_e762];
                                                    let _e769 = (3u + _e741);
                                                    if (_e769 < 9u) {
                                                    } else {
                                                        phi_2798_ = true;
                                                        break;
                                                    }
                                                    let _e775 = global_2.member[_e731].member[_e769];
                                                    let _e776 = (3u + _e742);
                                                    if (_e776 < 9u) {
                                                    } else {
                                                        phi_2798_ = true;
                                                        break;
                                                    }
                                                    let _e782 = global_2.member[_e731].member[_e776];
                                                    let _e784 = (6u + _e740);
                                                    if (_e784 < 9u) {
                                                    } else {
                                                        phi_2798_ = true;
                                                        break;
                                                    }
                                                    let _e790 = global_2.member[_e731].member[_e784];
                                                    let _e791 = (6u + _e741);
                                                    if (_e791 < 9u) {
                                                    } else {
                                                        phi_2798_ = true;
                                                        break;
                                                    }
                                                    let _e797 = global_2.member[_e731].member[_e791];
                                                    let _e798 = (6u + _e742);
                                                    if (_e798 < 9u) {
                                                    } else {
                                                        phi_2798_ = true;
                                                        break;
                                                    }
                                                    let _e804 = global_2.member[_e731].member[_e798];
                                                    phi_981_ = array<array<f32, 3>, 3>(array<f32, 3>(_e748, _e754, _e760), array<f32, 3>(_e768, _e775, _e782), array<f32, 3>(_e790, _e797, _e804));
                                                }
                                                let _e808 = phi_981_;
                                                let _e816 = (_e808[0][2] - _e401);
                                                let _e819 = (((_e808[0][0] - _e328) * _e425) - (_e816 * _e353));
                                                let _e822 = (((_e808[0][1] - _e365) * _e425) - (_e816 * _e389));
                                                let _e829 = (_e808[1][2] - _e401);
                                                let _e832 = (((_e808[1][0] - _e328) * _e425) - (_e829 * _e353));
                                                let _e835 = (((_e808[1][1] - _e365) * _e425) - (_e829 * _e389));
                                                let _e842 = (_e808[2][2] - _e401);
                                                let _e845 = (((_e808[2][0] - _e328) * _e425) - (_e842 * _e353));
                                                let _e848 = (((_e808[2][1] - _e365) * _e425) - (_e842 * _e389));
                                                let _e849 = (_e845 * _e835);
                                                let _e850 = (_e848 * _e832);
                                                let _e851 = (_e819 * _e848);
                                                let _e852 = (_e822 * _e845);
                                                let _e853 = (_e832 * _e822);
                                                let _e854 = (_e835 * _e819);
                                                let _e859 = (((_e849 >= _e850) && (_e851 >= _e852)) && (_e853 >= _e854));
                                                if (_e859 || (((_e849 <= _e850) && (_e851 <= _e852)) && (_e853 <= _e854))) {
                                                    let _e866 = select(-1f, 1f, _e859);
                                                    let _e868 = ((_e849 - _e850) * _e866);
                                                    let _e870 = select(0f, _e868, (_e868 > 0f));
                                                    let _e872 = ((_e851 - _e852) * _e866);
                                                    let _e874 = select(0f, _e872, (_e872 > 0f));
                                                    let _e876 = ((_e853 - _e854) * _e866);
                                                    let _e878 = select(0f, _e876, (_e876 > 0f));
                                                    let _e880 = ((_e870 + _e874) + _e878);
                                                    if (_e880 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1809_ = type_28();
                                                        phi_1810_ = true;
                                                        phi_1811_ = false;
                                                    } else {
                                                        let _e883 = select(_e832, _e819, (_e819 < _e832));
                                                        if (select(_e845, _e883, (_e883 < _e845)) > 0f) {
                                                            phi_1098_ = true;
                                                        } else {
                                                            let _e888 = select(_e832, _e819, (_e819 > _e832));
                                                            phi_1098_ = (select(_e845, _e888, (_e888 > _e845)) < 0f);
                                                        }
                                                        let _e893 = phi_1098_;
                                                        if _e893 {
                                                            phi_1806_ = type_28();
                                                            phi_1807_ = true;
                                                            phi_1808_ = false;
                                                        } else {
                                                            let _e895 = select(_e835, _e822, (_e822 < _e835));
                                                            if (select(_e848, _e895, (_e895 < _e848)) > 0f) {
                                                                phi_1127_ = true;
                                                            } else {
                                                                let _e900 = select(_e835, _e822, (_e822 > _e835));
                                                                phi_1127_ = (select(_e848, _e900, (_e900 > _e848)) < 0f);
                                                            }
                                                            let _e905 = phi_1127_;
                                                            if _e905 {
                                                                phi_1804_ = type_28();
                                                                phi_1805_ = false;
                                                            } else {
                                                                let _e907 = select(_e808[1][0], _e808[0][0], (_e808[0][0] < _e808[1][0]));
                                                                let _e911 = select(_e808[1][0], _e808[0][0], (_e808[0][0] > _e808[1][0]));
                                                                let _e915 = select(_e808[1][1], _e808[0][1], (_e808[0][1] < _e808[1][1]));
                                                                let _e919 = select(_e808[1][1], _e808[0][1], (_e808[0][1] > _e808[1][1]));
                                                                let _e923 = select(_e808[1][2], _e808[0][2], (_e808[0][2] < _e808[1][2]));
                                                                let _e927 = select(_e808[1][2], _e808[0][2], (_e808[0][2] > _e808[1][2]));
                                                                let _e932 = ((select(_e808[2][0], _e907, (_e907 < _e808[2][0])) - _e351) * _e356);
                                                                let _e933 = ((select(_e808[2][0], _e911, (_e911 > _e808[2][0])) - _e352) * _e356);
                                                                let _e936 = ((select(_e808[2][1], _e915, (_e915 < _e808[2][1])) - _e387) * _e392);
                                                                let _e937 = ((select(_e808[2][1], _e919, (_e919 > _e808[2][1])) - _e388) * _e392);
                                                                let _e940 = ((select(_e808[2][2], _e923, (_e923 < _e808[2][2])) - _e423) * _e428);
                                                                let _e941 = ((select(_e808[2][2], _e927, (_e927 > _e808[2][2])) - _e424) * _e428);
                                                                let _e943 = select(_e941, _e940, (_e940 < _e941));
                                                                let _e945 = select(_e941, _e940, (_e940 > _e941));
                                                                let _e947 = select(_e933, _e932, (_e932 < _e933));
                                                                let _e949 = select(_e937, _e936, (_e936 < _e937));
                                                                let _e951 = select(_e949, _e947, (_e947 > _e949));
                                                                let _e953 = select(_e943, _e951, (_e951 > _e943));
                                                                let _e955 = select(_e933, _e932, (_e932 > _e933));
                                                                let _e957 = select(_e937, _e936, (_e936 > _e937));
                                                                let _e959 = select(_e957, _e955, (_e955 < _e957));
                                                                let _e961 = select(_e945, _e959, (_e959 < _e945));
                                                                let _e962 = -(_e943);
                                                                let _e968 = select(_e474, _e953, (_e953 > _e474));
                                                                if (_e968 > (_e961 + (select(_e962, _e945, (_e945 > _e962)) * 0.0000019073523f))) {
                                                                    phi_1799_ = type_28();
                                                                    phi_1800_ = true;
                                                                } else {
                                                                    let _e970 = (_e968 > _e709.member_1);
                                                                    if _e970 {
                                                                        phi_1798_ = type_28();
                                                                    } else {
                                                                        let _e971 = vec3<f32>(_e808[0][0], _e808[0][1], _e808[0][2]);
                                                                        let _e972 = vec3<f32>(_e808[1][0], _e808[1][1], _e808[1][2]);
                                                                        let _e973 = vec3<f32>(_e808[2][0], _e808[2][1], _e808[2][2]);
                                                                        let _e974 = (_e808[1][0] - _e808[0][0]);
                                                                        let _e975 = (_e808[1][1] - _e808[0][1]);
                                                                        let _e976 = (_e808[1][2] - _e808[0][2]);
                                                                        let _e977 = vec3<f32>(_e974, _e975, _e976);
                                                                        let _e978 = (_e808[2][0] - _e808[1][0]);
                                                                        let _e979 = (_e808[2][1] - _e808[1][1]);
                                                                        let _e980 = (_e808[2][2] - _e808[1][2]);
                                                                        let _e981 = vec3<f32>(_e978, _e979, _e980);
                                                                        let _e982 = (_e808[0][0] - _e808[2][0]);
                                                                        let _e983 = (_e808[0][1] - _e808[2][1]);
                                                                        let _e984 = (_e808[0][2] - _e808[2][2]);
                                                                        let _e985 = vec3<f32>(_e982, _e983, _e984);
                                                                        let _e988 = bitcast<f32>((bitcast<u32>(_e974) & 2147483647u));
                                                                        let _e991 = bitcast<f32>((bitcast<u32>(_e975) & 2147483647u));
                                                                        let _e993 = select(_e991, _e988, (_e988 > _e991));
                                                                        let _e996 = bitcast<f32>((bitcast<u32>(_e976) & 2147483647u));
                                                                        let _e998 = select(_e996, _e993, (_e993 > _e996));
                                                                        let _e1001 = bitcast<f32>((bitcast<u32>(_e978) & 2147483647u));
                                                                        let _e1004 = bitcast<f32>((bitcast<u32>(_e979) & 2147483647u));
                                                                        let _e1006 = select(_e1004, _e1001, (_e1001 > _e1004));
                                                                        let _e1009 = bitcast<f32>((bitcast<u32>(_e980) & 2147483647u));
                                                                        let _e1011 = select(_e1009, _e1006, (_e1006 > _e1009));
                                                                        let _e1014 = bitcast<f32>((bitcast<u32>(_e982) & 2147483647u));
                                                                        let _e1017 = bitcast<f32>((bitcast<u32>(_e983) & 2147483647u));
                                                                        let _e1019 = select(_e1017, _e1014, (_e1014 > _e1017));
                                                                        let _e1022 = bitcast<f32>((bitcast<u32>(_e984) & 2147483647u));
                                                                        let _e1024 = select(_e1022, _e1019, (_e1019 > _e1022));
                                                                        let _e1026 = select(_e1011, _e998, (_e998 > _e1011));
                                                                        let _e1028 = select(_e1024, _e1026, (_e1026 > _e1024));
                                                                        if (_e998 == _e1028) {
                                                                            phi_1528_ = _e835;
                                                                            phi_1529_ = _e832;
                                                                            phi_1530_ = _e822;
                                                                            phi_1531_ = _e819;
                                                                            phi_1532_ = _e971;
                                                                            phi_1533_ = _e985;
                                                                            phi_1534_ = _e981;
                                                                            phi_1535_ = _e977;
                                                                        } else {
                                                                            let _e1030 = (_e1011 == _e1028);
                                                                            let _e1035 = vec3(_e1030);
                                                                            phi_1528_ = select(_e822, _e848, _e1030);
                                                                            phi_1529_ = select(_e819, _e845, _e1030);
                                                                            phi_1530_ = select(_e848, _e835, _e1030);
                                                                            phi_1531_ = select(_e845, _e832, _e1030);
                                                                            phi_1532_ = select(_e973, _e972, _e1035);
                                                                            phi_1533_ = select(_e981, _e977, _e1035);
                                                                            phi_1534_ = select(_e977, _e985, _e1035);
                                                                            phi_1535_ = select(_e985, _e981, _e1035);
                                                                        }
                                                                        let _e1041 = phi_1528_;
                                                                        let _e1043 = phi_1529_;
                                                                        let _e1045 = phi_1530_;
                                                                        let _e1047 = phi_1531_;
                                                                        let _e1049 = phi_1532_;
                                                                        let _e1051 = phi_1533_;
                                                                        let _e1053 = phi_1534_;
                                                                        let _e1055 = phi_1535_;
                                                                        let _e1062 = ((_e1053.y * _e1051.z) - (_e1051.y * _e1053.z));
                                                                        let _e1067 = ((_e1053.z * _e1051.x) - (_e1051.z * _e1053.x));
                                                                        let _e1070 = ((_e1053.x * _e1051.y) - (_e1051.x * _e1053.y));
                                                                        if (_e870 >= _e874) {
                                                                            phi_1566_ = select(true, false, (_e870 >= _e878));
                                                                        } else {
                                                                            phi_1566_ = true;
                                                                        }
                                                                        let _e1075 = phi_1566_;
                                                                        if _e1075 {
                                                                            phi_1575_ = select(_e973, _e972, vec3((_e874 >= _e878)));
                                                                        } else {
                                                                            phi_1575_ = _e971;
                                                                        }
                                                                        let _e1080 = phi_1575_;
                                                                        let _e1085 = (((_e1062 * _e353) + (_e1067 * _e389)) + (_e1070 * _e425));
                                                                        let _e1096 = (((_e1062 * (_e1080.x - _e328)) + (_e1067 * (_e1080.y - _e365))) + (_e1070 * (_e1080.z - _e401)));
                                                                        let _e1098 = (_e1043 - _e1047);
                                                                        let _e1099 = (_e1041 - _e1045);
                                                                        let _e1107 = (-(((_e1047 * _e1098) + (_e1045 * _e1099))) / ((_e1098 * _e1098) + (_e1099 * _e1099)));
                                                                        let _e1109 = select(1f, _e1107, (_e1107 < 1f));
                                                                        let _e1111 = select(0f, _e1109, (_e1109 > 0f));
                                                                        let _e1124 = ((_e1049.x + (_e1055.x * _e1111)) - _e328);
                                                                        let _e1125 = ((_e1049.y + (_e1055.y * _e1111)) - _e365);
                                                                        let _e1126 = ((_e1049.z + (_e1055.z * _e1111)) - _e401);
                                                                        let _e1127 = (_e1126 / _e425);
                                                                        let _e1139 = bitcast<f32>((bitcast<u32>(_e1124) & 2147483647u));
                                                                        let _e1142 = bitcast<f32>((bitcast<u32>(_e1125) & 2147483647u));
                                                                        let _e1144 = select(_e1142, _e1139, (_e1139 > _e1142));
                                                                        let _e1147 = bitcast<f32>((bitcast<u32>(_e1126) & 2147483647u));
                                                                        let _e1149 = select(_e1147, _e1144, (_e1144 > _e1147));
                                                                        let _e1155 = bitcast<f32>((bitcast<u32>(_e1062) & 2147483647u));
                                                                        let _e1158 = bitcast<f32>((bitcast<u32>(_e1067) & 2147483647u));
                                                                        let _e1160 = select(_e1158, _e1155, (_e1155 > _e1158));
                                                                        let _e1163 = bitcast<f32>((bitcast<u32>(_e1070) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1062 * _e1124) + (_e1067 * _e1125)) + (_e1070 * _e1126)) - _e1096)) & 2147483647u)) <= ((0.0000009536743f * select(_e1028, _e1149, (_e1149 > _e1028))) * select(_e1163, _e1160, (_e1160 > _e1163)))) {
                                                                            let _e1173 = bitcast<f32>((bitcast<u32>(_e1053.x) & 2147483647u));
                                                                            let _e1176 = bitcast<f32>((bitcast<u32>(_e1053.y) & 2147483647u));
                                                                            let _e1178 = select(_e1176, _e1173, (_e1173 > _e1176));
                                                                            let _e1181 = bitcast<f32>((bitcast<u32>(_e1053.z) & 2147483647u));
                                                                            let _e1187 = bitcast<f32>((bitcast<u32>(_e1051.x) & 2147483647u));
                                                                            let _e1190 = bitcast<f32>((bitcast<u32>(_e1051.y) & 2147483647u));
                                                                            let _e1192 = select(_e1190, _e1187, (_e1187 > _e1190));
                                                                            let _e1195 = bitcast<f32>((bitcast<u32>(_e1051.z) & 2147483647u));
                                                                            phi_1742_ = select(true, false, (bitcast<f32>((bitcast<u32>(_e1085) & 2147483647u)) > ((0.0000038146973f * select(_e1181, _e1178, (_e1178 > _e1181))) * select(_e1195, _e1192, (_e1192 > _e1195)))));
                                                                        } else {
                                                                            phi_1742_ = true;
                                                                        }
                                                                        let _e1202 = phi_1742_;
                                                                        if _e1202 {
                                                                            let _e1213 = ((((_e1062 * (_e1124 - (_e353 * _e1127))) + (_e1067 * (_e1125 - (_e389 * _e1127)))) + (_e1070 * (_e1126 - _e1126))) / _e1085);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1213) & 2147483647u)) <= _e1028) {
                                                                                phi_1766_ = (_e1127 + _e1213);
                                                                            } else {
                                                                                phi_1766_ = _e1127;
                                                                            }
                                                                            let _e1220 = phi_1766_;
                                                                            phi_1767_ = _e1220;
                                                                        } else {
                                                                            phi_1767_ = (_e1096 / _e1085);
                                                                        }
                                                                        let _e1222 = phi_1767_;
                                                                        let _e1224 = select(_e961, _e1222, (_e1222 < _e961));
                                                                        let _e1226 = select(_e953, _e1224, (_e1224 > _e953));
                                                                        if (_e1226 >= _e474) {
                                                                            let _e1228 = (_e1226 <= _e709.member_1);
                                                                            if _e1228 {
                                                                                let _e1229 = (1f / _e880);
                                                                                phi_1790_ = type_28(_e1226, (_e874 * _e1229), (_e878 * _e1229), _e738);
                                                                            } else {
                                                                                phi_1790_ = type_28();
                                                                            }
                                                                            let _e1234 = phi_1790_;
                                                                            phi_1792_ = _e1234;
                                                                            phi_1793_ = select(true, false, _e1228);
                                                                        } else {
                                                                            phi_1792_ = type_28();
                                                                            phi_1793_ = true;
                                                                        }
                                                                        let _e1237 = phi_1792_;
                                                                        let _e1239 = phi_1793_;
                                                                        if _e1239 {
                                                                            phi_1797_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_1797_ = _e1237;
                                                                        }
                                                                        let _e1241 = phi_1797_;
                                                                        phi_1798_ = _e1241;
                                                                    }
                                                                    let _e1243 = phi_1798_;
                                                                    phi_1799_ = _e1243;
                                                                    phi_1800_ = _e970;
                                                                }
                                                                let _e1245 = phi_1799_;
                                                                let _e1247 = phi_1800_;
                                                                phi_1804_ = _e1245;
                                                                phi_1805_ = _e1247;
                                                            }
                                                            let _e1249 = phi_1804_;
                                                            let _e1251 = phi_1805_;
                                                            phi_1806_ = _e1249;
                                                            phi_1807_ = _e905;
                                                            phi_1808_ = _e1251;
                                                        }
                                                        let _e1253 = phi_1806_;
                                                        let _e1255 = phi_1807_;
                                                        let _e1257 = phi_1808_;
                                                        phi_1809_ = _e1253;
                                                        phi_1810_ = _e1255;
                                                        phi_1811_ = _e1257;
                                                    }
                                                    let _e1259 = phi_1809_;
                                                    let _e1261 = phi_1810_;
                                                    let _e1263 = phi_1811_;
                                                    phi_1819_ = _e1259;
                                                    phi_1820_ = select(_e1263, true, _e1261);
                                                } else {
                                                    phi_1819_ = type_28();
                                                    phi_1820_ = true;
                                                }
                                                let _e1266 = phi_1819_;
                                                let _e1268 = phi_1820_;
                                                if _e1268 {
                                                    phi_1824_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1824_ = _e1266;
                                                }
                                                let _e1270 = phi_1824_;
                                                if (_e1270.member_3 != 4294967295u) {
                                                    if (_e738 == _e102) {
                                                        phi_2153_ = false;
                                                    } else {
                                                        let _e1274 = (_e738 < arrayLength((&global_5.member)));
                                                        if _e1274 {
                                                            if _e1274 {
                                                            } else {
                                                                phi_2798_ = true;
                                                                break;
                                                            }
                                                            let _e1276 = global_5.member[_e738];
                                                            phi_1847_ = _e1276;
                                                        } else {
                                                            phi_1847_ = 4294967295u;
                                                        }
                                                        let _e1278 = phi_1847_;
                                                        let _e1279 = (_e1278 < arrayLength((&global_6.member)));
                                                        if _e1279 {
                                                            if _e1279 {
                                                            } else {
                                                                phi_2798_ = true;
                                                                break;
                                                            }
                                                            let _e1281 = global_6.member[_e1278];
                                                            phi_1861_ = _e1281;
                                                        } else {
                                                            phi_1861_ = 0i;
                                                        }
                                                        let _e1283 = phi_1861_;
                                                        let _e1284 = (_e1283 == 0i);
                                                        if _e1284 {
                                                            phi_2152_ = true;
                                                        } else {
                                                            if _e320 {
                                                                phi_1882_ = vec3<f32>(_e808[0][0], _e808[0][1], _e808[0][2]);
                                                            } else {
                                                                if (_e296 == 1u) {
                                                                    phi_1881_ = vec3<f32>(_e808[0][2], _e808[0][0], _e808[0][1]);
                                                                } else {
                                                                    phi_1881_ = vec3<f32>(_e808[0][1], _e808[0][2], _e808[0][0]);
                                                                }
                                                                let _e1289 = phi_1881_;
                                                                phi_1882_ = _e1289;
                                                            }
                                                            let _e1292 = phi_1882_;
                                                            if _e320 {
                                                                phi_1899_ = vec3<f32>(_e808[1][0], _e808[1][1], _e808[1][2]);
                                                            } else {
                                                                if (_e296 == 1u) {
                                                                    phi_1898_ = vec3<f32>(_e808[1][2], _e808[1][0], _e808[1][1]);
                                                                } else {
                                                                    phi_1898_ = vec3<f32>(_e808[1][1], _e808[1][2], _e808[1][0]);
                                                                }
                                                                let _e1297 = phi_1898_;
                                                                phi_1899_ = _e1297;
                                                            }
                                                            let _e1300 = phi_1899_;
                                                            if _e320 {
                                                                phi_1916_ = vec3<f32>(_e808[2][0], _e808[2][1], _e808[2][2]);
                                                            } else {
                                                                if (_e296 == 1u) {
                                                                    phi_1915_ = vec3<f32>(_e808[2][2], _e808[2][0], _e808[2][1]);
                                                                } else {
                                                                    phi_1915_ = vec3<f32>(_e808[2][1], _e808[2][2], _e808[2][0]);
                                                                }
                                                                let _e1305 = phi_1915_;
                                                                phi_1916_ = _e1305;
                                                            }
                                                            let _e1308 = phi_1916_;
                                                            let _e1311 = (_e1300.x - _e1292.x);
                                                            let _e1314 = (_e1300.y - _e1292.y);
                                                            let _e1317 = (_e1300.z - _e1292.z);
                                                            let _e1319 = (_e1308.x - _e1292.x);
                                                            let _e1321 = (_e1308.y - _e1292.y);
                                                            let _e1323 = (_e1308.z - _e1292.z);
                                                            if (_e174.member_1 == 1u) {
                                                                phi_1952_ = (vec3<f32>(_e174.member[0], _e174.member[1], _e174.member[2]) - _e1292);
                                                            } else {
                                                                phi_1952_ = vec3<f32>(_e174.member[0], _e174.member[1], _e174.member[2]);
                                                            }
                                                            let _e1338 = phi_1952_;
                                                            let _e1344 = bitcast<f32>((bitcast<u32>((_e1311 * _e1321)) ^ _e174.member_3[0]));
                                                            let _e1348 = bitcast<f32>((bitcast<u32>((_e1314 * _e1319)) ^ _e174.member_3[0]));
                                                            let _e1352 = bitcast<f32>((bitcast<u32>((_e1314 * _e1323)) ^ _e174.member_3[0]));
                                                            let _e1356 = bitcast<f32>((bitcast<u32>((_e1317 * _e1321)) ^ _e174.member_3[0]));
                                                            let _e1360 = bitcast<f32>((bitcast<u32>((_e1317 * _e1319)) ^ _e174.member_3[0]));
                                                            let _e1364 = bitcast<f32>((bitcast<u32>((_e1311 * _e1323)) ^ _e174.member_3[0]));
                                                            let _e1365 = (_e1352 - _e1356);
                                                            let _e1366 = (_e1360 - _e1364);
                                                            let _e1367 = (_e1344 - _e1348);
                                                            let _e1391 = (bitcast<f32>((bitcast<u32>(_e1352) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1356) & 2147483647u)));
                                                            let _e1398 = (bitcast<f32>((bitcast<u32>(_e1360) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1364) & 2147483647u)));
                                                            let _e1405 = (bitcast<f32>((bitcast<u32>(_e1344) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1348) & 2147483647u)));
                                                            if (_e174.member_2 == 0f) {
                                                                phi_2134_ = 0f;
                                                            } else {
                                                                let _e1435 = bitcast<f32>((bitcast<u32>(_e1365) & 2147483647u));
                                                                let _e1438 = bitcast<f32>((bitcast<u32>(_e1366) & 2147483647u));
                                                                let _e1441 = bitcast<f32>((bitcast<u32>(_e1367) & 2147483647u));
                                                                let _e1443 = select(_e1441, _e1438, (_e1438 > _e1441));
                                                                let _e1447 = select(_e1441, _e1438, (_e1438 < _e1441));
                                                                let _e1451 = select(_e1438, _e1435, (_e1435 < _e1438));
                                                                let _e1453 = select(_e1438, _e1435, (_e1435 > _e1438));
                                                                let _e1455 = select(_e1441, _e1453, (_e1453 < _e1441));
                                                                phi_2134_ = bitcast<f32>((bitcast<u32>((_e174.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1443, _e1435, (_e1435 > _e1443)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1455, _e1451, (_e1451 > _e1455)))) ^ _e174.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1447, _e1435, (_e1435 < _e1447)))) ^ _e174.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1391 + _e1398) + _e1405))) ^ _e174.member_3[0]))) * 1.0000005f)) ^ _e174.member_3[0])))) ^ _e174.member_3[0]));
                                                            }
                                                            let _e1482 = phi_2134_;
                                                            phi_2152_ = (_e1284 || !(((((bitcast<f32>((bitcast<u32>((_e1338.x * _e1365)) ^ _e174.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1338.y * _e1366)) ^ _e174.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1338.z * _e1367)) ^ _e174.member_3[0]))) * f32(-(_e1283))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1338.x) & 2147483647u)) * _e1391)) ^ _e174.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1338.y) & 2147483647u)) * _e1398)) ^ _e174.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1338.z) & 2147483647u)) * _e1405)) ^ _e174.member_3[0]))))) ^ _e174.member_3[0])) + _e1482) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1496 = phi_2152_;
                                                        phi_2153_ = _e1496;
                                                    }
                                                    let _e1498 = phi_2153_;
                                                    if _e1498 {
                                                        if (_e1270.member < _e709.member.member) {
                                                            phi_2173_ = true;
                                                        } else {
                                                            if (_e1270.member == _e709.member.member) {
                                                                phi_2172_ = (_e1270.member_3 < _e709.member.member_3);
                                                            } else {
                                                                phi_2172_ = false;
                                                            }
                                                            let _e1508 = phi_2172_;
                                                            phi_2173_ = _e1508;
                                                        }
                                                        let _e1510 = phi_2173_;
                                                        if _e1510 {
                                                            phi_2179_ = type_49(_e1270, _e1270.member);
                                                        } else {
                                                            phi_2179_ = _e709;
                                                        }
                                                        let _e1513 = phi_2179_;
                                                        phi_2180_ = _e1513;
                                                    } else {
                                                        phi_2180_ = _e709;
                                                    }
                                                    let _e1515 = phi_2180_;
                                                    phi_2181_ = _e1515;
                                                } else {
                                                    phi_2181_ = _e709;
                                                }
                                                let _e1517 = phi_2181_;
                                                phi_846_ = _e1517;
                                            } else {
                                                phi_846_ = type_49();
                                            }
                                            let _e1519 = phi_846_;
                                            continue;
                                            continuing {
                                                phi_845_ = _e1519;
                                                phi_848_ = _e724;
                                                phi_2798_ = _e482;
                                                break if !(_e730);
                                            }
                                        }
                                        let _e1522 = phi_2798_;
                                        phi_2964_ = _e1522;
                                        if _e1522 {
                                            break;
                                        }
                                        phi_2968_ = _e1522;
                                        let _e1747 = local_3;
                                        phi_2636_ = _e1747;
                                        phi_2637_ = _e507;
                                        phi_2638_ = false;
                                        phi_2639_ = _e511;
                                    } else {
                                        if (_e507 >= _e77) {
                                            phi_2241_ = type_54(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e507 < _e77) {
                                            } else {
                                                phi_2964_ = true;
                                                break;
                                            }
                                            let _e521 = (_e296 % 3u);
                                            if (_e521 < 3u) {
                                            } else {
                                                phi_2964_ = true;
                                                break;
                                            }
                                            let _e527 = global_4.member[_e507].member[_e521];
                                            let _e533 = (_e295 % 3u);
                                            if (_e533 < 3u) {
                                            } else {
                                                phi_2964_ = true;
                                                break;
                                            }
                                            let _e539 = global_4.member[_e507].member[_e533];
                                            let _e545 = (_e297 % 3u);
                                            if (_e545 < 3u) {
                                            } else {
                                                phi_2964_ = true;
                                                break;
                                            }
                                            let _e551 = global_4.member[_e507].member[_e545];
                                            let _e561 = global_4.member[_e507].member_1;
                                            let _e565 = global_4.member[_e507].member_2;
                                            phi_2241_ = type_54(array<vec4<f32>, 3>(vec4<f32>(_e527[0], _e527[1], _e527[2], _e527[3]), vec4<f32>(_e539[0], _e539[1], _e539[2], _e539[3]), vec4<f32>(_e551[0], _e551[1], _e551[2], _e551[3])), _e561, _e565);
                                        }
                                        let _e568 = phi_2241_;
                                        let _e580 = ((_e568.member[0].x - _e351) * _e356);
                                        let _e581 = ((_e568.member[0].y - _e351) * _e356);
                                        let _e582 = ((_e568.member[0].z - _e352) * _e356);
                                        let _e583 = ((_e568.member[0].w - _e352) * _e356);
                                        let _e593 = ((_e568.member[1].x - _e387) * _e392);
                                        let _e594 = ((_e568.member[1].y - _e387) * _e392);
                                        let _e595 = ((_e568.member[1].z - _e388) * _e392);
                                        let _e596 = ((_e568.member[1].w - _e388) * _e392);
                                        let _e606 = ((_e568.member[2].x - _e423) * _e428);
                                        let _e607 = ((_e568.member[2].y - _e423) * _e428);
                                        let _e608 = ((_e568.member[2].z - _e424) * _e428);
                                        let _e609 = ((_e568.member[2].w - _e424) * _e428);
                                        let _e611 = select(_e608, _e606, (_e606 < _e608));
                                        let _e613 = select(_e609, _e607, (_e607 < _e609));
                                        let _e615 = select(_e608, _e606, (_e606 > _e608));
                                        let _e617 = select(_e609, _e607, (_e607 > _e609));
                                        let _e619 = select(_e582, _e580, (_e580 < _e582));
                                        let _e621 = select(_e583, _e581, (_e581 < _e583));
                                        let _e623 = select(_e595, _e593, (_e593 < _e595));
                                        let _e625 = select(_e596, _e594, (_e594 < _e596));
                                        let _e627 = select(_e623, _e619, (_e619 > _e623));
                                        let _e629 = select(_e625, _e621, (_e621 > _e625));
                                        let _e631 = select(_e611, _e627, (_e627 > _e611));
                                        let _e633 = select(_e613, _e629, (_e629 > _e613));
                                        let _e635 = select(_e582, _e580, (_e580 > _e582));
                                        let _e637 = select(_e583, _e581, (_e581 > _e583));
                                        let _e639 = select(_e595, _e593, (_e593 > _e595));
                                        let _e641 = select(_e596, _e594, (_e594 > _e596));
                                        let _e643 = select(_e639, _e635, (_e635 < _e639));
                                        let _e645 = select(_e641, _e637, (_e637 < _e641));
                                        let _e650 = -(_e611);
                                        let _e651 = -(_e613);
                                        let _e658 = (select(_e615, _e643, (_e643 < _e615)) + (select(_e650, _e615, (_e615 > _e650)) * 0.0000019073523f));
                                        let _e659 = (select(_e617, _e645, (_e645 < _e617)) + (select(_e651, _e617, (_e617 > _e651)) * 0.0000019073523f));
                                        let _e661 = select(_e474, _e631, (_e631 > _e474));
                                        let _e663 = select(_e474, _e633, (_e633 > _e474));
                                        let _e668 = (_e661 <= select(_e484.member_1, _e658, (_e658 < _e484.member_1)));
                                        let _e669 = (_e663 <= select(_e484.member_1, _e659, (_e659 < _e484.member_1)));
                                        let _e670 = (_e661 <= _e663);
                                        if _e668 {
                                            if _e669 {
                                                if _e670 {
                                                    phi_2585_ = _e568.member_2;
                                                } else {
                                                    phi_2585_ = _e568.member_1;
                                                }
                                                let _e674 = phi_2585_;
                                                let _e677 = (_e511 % 128u);
                                                let _e678 = (_e677 < 128u);
                                                if _e678 {
                                                } else {
                                                    phi_2964_ = true;
                                                    break;
                                                }
                                                local_1[_e677] = _e674;
                                                if _e678 {
                                                } else {
                                                    phi_2964_ = true;
                                                    break;
                                                }
                                                local[_e677] = select(_e663, _e661, (_e661 > _e663));
                                                if _e670 {
                                                    phi_2613_ = _e568.member_1;
                                                } else {
                                                    phi_2613_ = _e568.member_2;
                                                }
                                                let _e685 = phi_2613_;
                                                phi_2614_ = _e685;
                                                phi_2615_ = (_e511 + 1u);
                                            } else {
                                                phi_2614_ = u32();
                                                phi_2615_ = u32();
                                            }
                                            let _e687 = phi_2614_;
                                            let _e689 = phi_2615_;
                                            phi_2617_ = _e687;
                                            phi_2618_ = _e689;
                                            phi_2619_ = select(true, false, _e669);
                                        } else {
                                            phi_2617_ = u32();
                                            phi_2618_ = u32();
                                            phi_2619_ = true;
                                        }
                                        let _e692 = phi_2617_;
                                        let _e694 = phi_2618_;
                                        let _e696 = phi_2619_;
                                        if _e696 {
                                            if _e668 {
                                                phi_2628_ = _e568.member_1;
                                            } else {
                                                phi_2628_ = _e568.member_2;
                                            }
                                            let _e700 = phi_2628_;
                                            phi_2633_ = _e700;
                                            phi_2634_ = select(_e669, true, _e668);
                                        } else {
                                            phi_2633_ = _e692;
                                            phi_2634_ = _e509;
                                        }
                                        let _e703 = phi_2633_;
                                        let _e705 = phi_2634_;
                                        phi_2968_ = _e482;
                                        phi_2636_ = _e484;
                                        phi_2637_ = _e703;
                                        phi_2638_ = _e705;
                                        phi_2639_ = select(_e694, _e511, _e696);
                                    }
                                    let _e1524 = phi_2968_;
                                    let _e1526 = phi_2636_;
                                    let _e1528 = phi_2637_;
                                    let _e1530 = phi_2638_;
                                    let _e1532 = phi_2639_;
                                    phi_2967_ = _e1524;
                                    phi_2640_ = _e1526;
                                    phi_2641_ = _e1528;
                                    phi_2642_ = (_e488 - 1u);
                                    phi_2643_ = _e1530;
                                    phi_2644_ = _e1532;
                                } else {
                                    phi_2967_ = _e482;
                                    phi_2640_ = _e484;
                                    phi_2641_ = _e507;
                                    phi_2642_ = _e488;
                                    phi_2643_ = _e509;
                                    phi_2644_ = _e511;
                                }
                                let _e1534 = phi_2967_;
                                let _e1536 = phi_2640_;
                                let _e1538 = phi_2641_;
                                let _e1540 = phi_2642_;
                                let _e1542 = phi_2643_;
                                let _e1544 = phi_2644_;
                                phi_2966_ = _e1534;
                                phi_2645_ = _e1536;
                                phi_2646_ = _e1538;
                                phi_2647_ = _e1540;
                                phi_2648_ = _e1542;
                                phi_2649_ = _e1544;
                            } else {
                                phi_2966_ = _e482;
                                phi_2645_ = type_49();
                                phi_2646_ = u32();
                                phi_2647_ = u32();
                                phi_2648_ = bool();
                                phi_2649_ = u32();
                            }
                            let _e1546 = phi_2966_;
                            let _e1548 = phi_2645_;
                            let _e1550 = phi_2646_;
                            let _e1552 = phi_2647_;
                            let _e1554 = phi_2648_;
                            let _e1556 = phi_2649_;
                            phi_2965_ = _e1546;
                            phi_777_ = _e1548;
                            phi_780_ = _e1550;
                            phi_782_ = _e1552;
                            phi_784_ = _e1554;
                            phi_786_ = _e1556;
                            phi_2650_ = _e496;
                        } else {
                            phi_2965_ = _e482;
                            phi_777_ = type_49();
                            phi_780_ = u32();
                            phi_782_ = u32();
                            phi_784_ = bool();
                            phi_786_ = u32();
                            phi_2650_ = false;
                        }
                        let _e1558 = phi_2965_;
                        let _e1560 = phi_777_;
                        let _e1562 = phi_780_;
                        let _e1564 = phi_782_;
                        let _e1566 = phi_784_;
                        let _e1568 = phi_786_;
                        let _e1570 = phi_2650_;
                        continue;
                        continuing {
                            phi_2804_ = _e1558;
                            phi_776_ = _e1560;
                            phi_779_ = _e1562;
                            phi_781_ = _e1564;
                            phi_783_ = _e1566;
                            phi_785_ = _e1568;
                            phi_2964_ = _e1558;
                            break if !(_e1570);
                        }
                    }
                    let _e1573 = phi_2964_;
                    if _e1573 {
                        break;
                    }
                    let _e1575 = local_2;
                    if (_e1575.member.member_3 != 4294967295u) {
                        let _e1580 = (_e298 / 3i);
                        let _e1587 = bitcast<f32>((bitcast<u32>((_e1580 + 127i)) << bitcast<u32>(23i)));
                        let _e1595 = (((_e1575.member.member * _e1587) * _e1587) * bitcast<f32>((bitcast<u32>(((_e298 - (2i * _e1580)) + 127i)) << bitcast<u32>(23i))));
                        let _e1597 = select(340282350000000000000000000000000000000f, _e1595, (_e1595 < 340282350000000000000000000000000000000f));
                        phi_2702_ = type_28(select(-340282350000000000000000000000000000000f, _e1597, (_e1597 > -340282350000000000000000000000000000000f)), _e1575.member.member_1, _e1575.member.member_2, _e1575.member.member_3);
                    } else {
                        phi_2702_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1604 = phi_2702_;
                    if _e175 {
                    } else {
                        break;
                    }
                    global_8.member[_e95] = _e1604;
                    if _e96 {
                    } else {
                        break;
                    }
                    let _e1608 = select(0u, 1u, (_e242 <= _e252));
                    if (_e1608 > 0u) {
                        let _e1610 = (1u < _e91);
                        if _e1610 {
                            if (0u < _e91) {
                            } else {
                                break;
                            }
                            let _e1614 = atomicAdd((&global_9.member[0u]), _e1608);
                            if ((_e1614 + _e1608) < _e1614) {
                                if _e1610 {
                                } else {
                                    break;
                                }
                                let _e1619 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1622 = select(0u, 1u, (_e1604.member_3 != 4294967295u));
                    if (_e1622 > 0u) {
                        let _e1624 = (3u < _e91);
                        if _e1624 {
                            if (2u < _e91) {
                            } else {
                                break;
                            }
                            let _e1628 = atomicAdd((&global_9.member[2u]), _e1622);
                            if ((_e1628 + _e1622) < _e1628) {
                                if _e1624 {
                                } else {
                                    break;
                                }
                                let _e1633 = atomicAdd((&global_9.member[3u]), 1u);
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
fn trace_paths_facing(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
