struct type_4 {
    member: u32,
    member_1: u32,
}

struct type_8 {
    member: vec4<u32>,
}

struct type_13 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_15 {
    member: array<type_13>,
}

struct type_22 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_23 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_32 {
    member: array<type_23>,
}

struct type_36 {
    member: array<array<type_22, 8>>,
}

struct type_42 {
    member: array<vec4<u32>, 2>,
}

struct type_44 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_46 {
    member: array<type_44>,
}

struct type_49 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_51 {
    member: type_49,
    member_1: u32,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(3) 
var<storage> global_2: type_15;
@group(0) @binding(1) 
var<uniform> global_3: type_42;
@group(0) @binding(4) 
var<storage> global_4: type_32;
@group(0) @binding(2) 
var<storage> global_5: type_46;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_36;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<f32, 128>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<u32, 128>;
    var local_7: array<type_22, 8>;
    var local_8: array<f32, 128>;
    var local_9: array<f32, 3>;
    var local_10: array<f32, 3>;
    var phi_332_: i32;
    var phi_333_: i32;
    var phi_343_: bool;
    var phi_353_: u32;
    var phi_354_: u32;
    var phi_356_: bool;
    var phi_361_: u32;
    var phi_373_: i32;
    var phi_393_: i32;
    var phi_411_: f32;
    var phi_417_: f32;
    var phi_428_: f32;
    var phi_434_: f32;
    var phi_457_: f32;
    var phi_468_: f32;
    var phi_477_: f32;
    var phi_483_: f32;
    var phi_494_: f32;
    var phi_500_: f32;
    var phi_523_: f32;
    var phi_534_: f32;
    var phi_543_: f32;
    var phi_549_: f32;
    var phi_560_: f32;
    var phi_566_: f32;
    var phi_589_: f32;
    var phi_600_: f32;
    var phi_700_: f32;
    var phi_701_: f32;
    var phi_2991_: bool;
    var phi_2947_: f32;
    var phi_827_: type_51;
    var phi_830_: u32;
    var phi_832_: bool;
    var phi_834_: u32;
    var phi_845_: bool;
    var phi_932_: type_51;
    var phi_933_: bool;
    var phi_934_: u32;
    var phi_1785_: type_44;
    var phi_2618_: type_51;
    var phi_2695_: type_51;
    var phi_2696_: type_51;
    var phi_2697_: u32;
    var phi_2699_: type_51;
    var phi_2700_: u32;
    var phi_2701_: bool;
    var phi_2708_: type_51;
    var phi_2713_: type_51;
    var phi_2714_: bool;
    var phi_2988_: bool;
    var phi_2978_: f32;
    var phi_952_: type_4;
    var phi_953_: type_4;
    var phi_976_: type_4;
    var phi_997_: u32;
    var phi_1086_: array<array<f32, 3>, 3>;
    var phi_1558_: vec3<f32>;
    var phi_1559_: vec3<f32>;
    var phi_1590_: bool;
    var phi_1599_: vec3<f32>;
    var phi_1639_: type_22;
    var phi_1641_: type_22;
    var phi_1642_: bool;
    var phi_1646_: type_22;
    var phi_1647_: type_22;
    var phi_1648_: type_22;
    var phi_1649_: bool;
    var phi_1653_: type_22;
    var phi_1654_: bool;
    var phi_1658_: type_22;
    var phi_1659_: bool;
    var phi_1663_: type_22;
    var phi_1675_: type_4;
    var phi_1678_: type_22;
    var phi_1676_: type_4;
    var phi_1701_: type_4;
    var phi_1733_: bool;
    var phi_1734_: bool;
    var phi_1755_: type_22;
    var phi_1679_: type_22;
    var phi_2979_: bool;
    var phi_3270_: f32;
    var phi_3269_: f32;
    var phi_3096_: bool;
    var phi_3268_: f32;
    var phi_3095_: bool;
    var phi_3267_: f32;
    var phi_3094_: bool;
    var phi_3207_: f32;
    var phi_3093_: bool;
    var phi_3172_: f32;
    var phi_3102_: bool;
    var phi_2716_: type_51;
    var phi_2717_: bool;
    var phi_2718_: u32;
    var phi_3171_: f32;
    var phi_3101_: bool;
    var phi_2719_: type_51;
    var phi_2720_: u32;
    var phi_2721_: bool;
    var phi_2722_: u32;
    var phi_3170_: f32;
    var phi_3100_: bool;
    var phi_2723_: type_51;
    var phi_2724_: u32;
    var phi_2725_: bool;
    var phi_2726_: u32;
    var phi_3169_: f32;
    var phi_3099_: bool;
    var phi_828_: type_51;
    var phi_831_: u32;
    var phi_833_: bool;
    var phi_835_: u32;
    var phi_2727_: bool;
    var phi_3098_: bool;
    var phi_2734_: type_4;
    var phi_2735_: type_4;
    var phi_2758_: type_4;
    var phi_2824_: type_22;
    var phi_3162_: bool;

    switch bitcast<i32>(0u) {
        default: {
            let _e78 = global;
            let _e81 = arrayLength((&global_5.member));
            let _e83 = arrayLength((&global_2.member));
            let _e91 = global_3.member[0u][0u];
            let _e95 = global_3.member[0u][1u];
            let _e99 = global_3.member[0u][2u];
            let _e103 = global_3.member[1u][0u];
            let _e107 = global_3.member[1u][1u];
            let _e111 = global_3.member[1u][2u];
            let _e115 = global_3.member[1u][3u];
            let _e118 = global_1.member[0u];
            let _e119 = bitcast<i32>(_e118);
            let _e129 = (_e78.x + (_e78.y * 2097152u));
            let _e130 = (_e129 < arrayLength((&global_4.member)));
            if _e130 {
                let _e131 = (_e129 < arrayLength((&global_6.member)));
                if _e131 {
                    if _e130 {
                    } else {
                        break;
                    }
                    let _e139 = global_4.member[_e129].member_2[0u];
                    let _e141 = (bitcast<u32>(_e139) & 2147483647u);
                    let _e146 = global_4.member[_e129].member_2[1u];
                    let _e148 = (bitcast<u32>(_e146) & 2147483647u);
                    let _e153 = global_4.member[_e129].member_2[2u];
                    let _e155 = (bitcast<u32>(_e153) & 2147483647u);
                    let _e160 = global_4.member[_e129].member[0u];
                    let _e162 = (bitcast<u32>(_e160) & 2147483647u);
                    let _e167 = global_4.member[_e129].member[1u];
                    let _e169 = (bitcast<u32>(_e167) & 2147483647u);
                    let _e174 = global_4.member[_e129].member[2u];
                    let _e176 = (bitcast<u32>(_e174) & 2147483647u);
                    let _e178 = select(_e148, _e141, (_e148 < _e141));
                    let _e180 = select(_e155, _e178, (_e155 < _e178));
                    let _e182 = select(_e162, _e180, (_e162 < _e180));
                    let _e184 = select(_e169, _e182, (_e169 < _e182));
                    let _e186 = select(_e176, _e184, (_e176 < _e184));
                    let _e190 = global_4.member[_e129].member_1;
                    let _e192 = (bitcast<u32>(_e190) & 2147483647u);
                    let _e199 = global_4.member[_e129].member_3;
                    let _e205 = (((select(_e192, _e186, (_e192 < _e186)) < 2139095040u) && ((bitcast<u32>(_e199) & 2147483647u) <= 2139095040u)) && (_e180 > 0u));
                    if _e205 {
                        let _e208 = (bitcast<u32>(bitcast<f32>(_e180)) & 2147483647u);
                        if (_e208 >= 8388608u) {
                            phi_332_ = (bitcast<i32>((_e208 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_332_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e208)), 32u, (_e208 == 0u))));
                        }
                        let _e222 = phi_332_;
                        phi_333_ = _e222;
                    } else {
                        phi_333_ = 0i;
                    }
                    let _e224 = phi_333_;
                    let _e225 = (_e141 == _e180);
                    if _e225 {
                        phi_343_ = true;
                    } else {
                        phi_343_ = (_e148 == _e180);
                    }
                    let _e228 = phi_343_;
                    let _e229 = select(1u, 0u, _e225);
                    if _e228 {
                        let _e230 = (_e229 + 1u);
                        phi_353_ = _e230;
                        phi_354_ = _e230;
                        phi_356_ = select(true, false, (_e230 == 2u));
                    } else {
                        phi_353_ = u32();
                        phi_354_ = 0u;
                        phi_356_ = true;
                    }
                    let _e234 = phi_353_;
                    let _e236 = phi_354_;
                    let _e238 = phi_356_;
                    if _e238 {
                        phi_361_ = (_e236 + 1u);
                    } else {
                        phi_361_ = 0u;
                    }
                    let _e242 = phi_361_;
                    let _e243 = select(_e234, _e236, _e238);
                    let _e244 = select(_e229, select(2u, _e229, _e228), _e238);
                    if (_e119 < -126i) {
                        phi_373_ = -126i;
                    } else {
                        phi_373_ = select(_e119, 127i, (_e119 > 127i));
                    }
                    let _e249 = phi_373_;
                    let _e254 = bitcast<f32>((bitcast<u32>((_e249 + 127i)) << bitcast<u32>(23i)));
                    let _e260 = bitcast<f32>((bitcast<u32>(((_e119 - _e249) + 127i)) << bitcast<u32>(23i)));
                    let _e261 = -(_e224);
                    if (_e261 < -126i) {
                        phi_393_ = -126i;
                    } else {
                        phi_393_ = select(_e261, 127i, (_e261 > 127i));
                    }
                    let _e266 = phi_393_;
                    let _e271 = bitcast<f32>((bitcast<u32>((_e266 + 127i)) << bitcast<u32>(23i)));
                    let _e277 = bitcast<f32>((bitcast<u32>(((_e261 - _e266) + 127i)) << bitcast<u32>(23i)));
                    let _e281 = global_4.member[_e129].member;
                    let _e282 = (_e243 == 0u);
                    if _e282 {
                        phi_411_ = _e281[0];
                    } else {
                        phi_411_ = _e281[1];
                    }
                    let _e286 = phi_411_;
                    let _e287 = (_e243 == 2u);
                    if _e287 {
                        phi_417_ = _e281[2];
                    } else {
                        phi_417_ = _e286;
                    }
                    let _e290 = phi_417_;
                    let _e292 = ((_e290 * _e254) * _e260);
                    let _e293 = global_4.member[_e129].member_2;
                    if _e282 {
                        phi_428_ = _e293[0];
                    } else {
                        phi_428_ = _e293[1];
                    }
                    let _e297 = phi_428_;
                    if _e287 {
                        phi_434_ = _e293[2];
                    } else {
                        phi_434_ = _e297;
                    }
                    let _e300 = phi_434_;
                    let _e302 = ((_e300 * _e271) * _e277);
                    let _e306 = (bitcast<f32>((bitcast<u32>(_e302) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e306 {
                        let _e310 = (bitcast<f32>((bitcast<u32>(_e292) & 2147483647u)) * 0.00000011920929f);
                        phi_457_ = select(0.00000000000011368684f, _e310, (_e310 > 0.00000000000011368684f));
                    } else {
                        phi_457_ = 0f;
                    }
                    let _e314 = phi_457_;
                    let _e315 = (_e292 + _e314);
                    let _e316 = (_e292 - _e314);
                    let _e317 = select(_e302, 0f, _e306);
                    if _e306 {
                        phi_468_ = 38685626000000000000000000f;
                    } else {
                        phi_468_ = (1f / _e302);
                    }
                    let _e320 = phi_468_;
                    let _e321 = (_e242 == 0u);
                    if _e321 {
                        phi_477_ = _e281[0];
                    } else {
                        phi_477_ = _e281[1];
                    }
                    let _e325 = phi_477_;
                    let _e326 = (_e242 == 2u);
                    if _e326 {
                        phi_483_ = _e281[2];
                    } else {
                        phi_483_ = _e325;
                    }
                    let _e329 = phi_483_;
                    let _e331 = ((_e329 * _e254) * _e260);
                    if _e321 {
                        phi_494_ = _e293[0];
                    } else {
                        phi_494_ = _e293[1];
                    }
                    let _e335 = phi_494_;
                    if _e326 {
                        phi_500_ = _e293[2];
                    } else {
                        phi_500_ = _e335;
                    }
                    let _e338 = phi_500_;
                    let _e340 = ((_e338 * _e271) * _e277);
                    let _e344 = (bitcast<f32>((bitcast<u32>(_e340) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e344 {
                        let _e348 = (bitcast<f32>((bitcast<u32>(_e331) & 2147483647u)) * 0.00000011920929f);
                        phi_523_ = select(0.00000000000011368684f, _e348, (_e348 > 0.00000000000011368684f));
                    } else {
                        phi_523_ = 0f;
                    }
                    let _e352 = phi_523_;
                    let _e353 = (_e331 + _e352);
                    let _e354 = (_e331 - _e352);
                    let _e355 = select(_e340, 0f, _e344);
                    if _e344 {
                        phi_534_ = 38685626000000000000000000f;
                    } else {
                        phi_534_ = (1f / _e340);
                    }
                    let _e358 = phi_534_;
                    let _e359 = (_e244 == 0u);
                    if _e359 {
                        phi_543_ = _e281[0];
                    } else {
                        phi_543_ = _e281[1];
                    }
                    let _e363 = phi_543_;
                    let _e364 = (_e244 == 2u);
                    if _e364 {
                        phi_549_ = _e281[2];
                    } else {
                        phi_549_ = _e363;
                    }
                    let _e367 = phi_549_;
                    let _e369 = ((_e367 * _e254) * _e260);
                    if _e359 {
                        phi_560_ = _e293[0];
                    } else {
                        phi_560_ = _e293[1];
                    }
                    let _e373 = phi_560_;
                    if _e364 {
                        phi_566_ = _e293[2];
                    } else {
                        phi_566_ = _e373;
                    }
                    let _e376 = phi_566_;
                    let _e378 = ((_e376 * _e271) * _e277);
                    let _e382 = (bitcast<f32>((bitcast<u32>(_e378) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e382 {
                        let _e386 = (bitcast<f32>((bitcast<u32>(_e369) & 2147483647u)) * 0.00000011920929f);
                        phi_589_ = select(0.00000000000011368684f, _e386, (_e386 > 0.00000000000011368684f));
                    } else {
                        phi_589_ = 0f;
                    }
                    let _e390 = phi_589_;
                    let _e391 = (_e369 + _e390);
                    let _e392 = (_e369 - _e390);
                    let _e393 = select(_e378, 0f, _e382);
                    if _e382 {
                        phi_600_ = 38685626000000000000000000f;
                    } else {
                        phi_600_ = (1f / _e378);
                    }
                    let _e396 = phi_600_;
                    let _e399 = bitcast<f32>((bitcast<u32>(_e292) & 2147483647u));
                    let _e402 = bitcast<f32>((bitcast<u32>(_e331) & 2147483647u));
                    let _e404 = select(_e402, _e399, (_e399 > _e402));
                    let _e407 = bitcast<f32>((bitcast<u32>(_e369) & 2147483647u));
                    let _e410 = (_e119 + _e224);
                    if (_e205 && (select(_e407, _e404, (_e404 > _e407)) <= 1099511600000f)) {
                        let _e413 = (_e410 / 3i);
                        let _e420 = bitcast<f32>((bitcast<u32>((_e413 + 127i)) << bitcast<u32>(23i)));
                        let _e427 = bitcast<f32>((bitcast<u32>(((_e410 - (2i * _e413)) + 127i)) << bitcast<u32>(23i)));
                        let _e428 = (((_e190 * _e420) * _e420) * _e427);
                        let _e430 = select(340282350000000000000000000000000000000f, _e428, (_e428 < 340282350000000000000000000000000000000f));
                        let _e435 = (((_e199 * _e420) * _e420) * _e427);
                        let _e437 = select(340282350000000000000000000000000000000f, _e435, (_e435 < 340282350000000000000000000000000000000f));
                        phi_700_ = select(-340282350000000000000000000000000000000f, _e437, (_e437 > -340282350000000000000000000000000000000f));
                        phi_701_ = select(-340282350000000000000000000000000000000f, _e430, (_e430 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_700_ = 0f;
                        phi_701_ = 1f;
                    }
                    let _e441 = phi_700_;
                    let _e443 = phi_701_;
                    local_7 = array<type_22, 8>(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u));
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_8 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_10 = array<f32, 3>(bitcast<f32>(_e91), bitcast<f32>(_e95), bitcast<f32>(_e99));
                    let _e447 = (_e243 % 3u);
                    let _e448 = (_e447 < 3u);
                    if _e448 {
                    } else {
                        break;
                    }
                    let _e450 = local_10[_e447];
                    let _e451 = (_e242 % 3u);
                    let _e452 = (_e451 < 3u);
                    if _e452 {
                    } else {
                        break;
                    }
                    let _e454 = local_10[_e451];
                    let _e455 = (_e244 % 3u);
                    let _e456 = (_e455 < 3u);
                    if _e456 {
                    } else {
                        break;
                    }
                    let _e458 = local_10[_e455];
                    local_9 = array<f32, 3>(bitcast<f32>(_e103), bitcast<f32>(_e107), bitcast<f32>(_e111));
                    if _e448 {
                    } else {
                        break;
                    }
                    let _e462 = local_9[_e447];
                    if _e452 {
                    } else {
                        break;
                    }
                    let _e464 = local_9[_e451];
                    if _e456 {
                    } else {
                        break;
                    }
                    let _e466 = local_9[_e455];
                    phi_2991_ = false;
                    phi_2947_ = _e441;
                    phi_827_ = type_51(type_49(array<f32, 3>(_e450, _e454, _e458), array<f32, 3>(_e462, _e464, _e466)), select(0u, 2147483648u, (_e81 == 0u)));
                    phi_830_ = ((3u * _e81) + 1u);
                    phi_832_ = (_e443 <= _e441);
                    phi_834_ = 0u;
                    loop {
                        let _e474 = phi_2991_;
                        let _e476 = phi_2947_;
                        let _e478 = phi_827_;
                        let _e480 = phi_830_;
                        let _e482 = phi_832_;
                        let _e484 = phi_834_;
                        if _e482 {
                            phi_845_ = true;
                        } else {
                            phi_845_ = (_e484 > 0u);
                        }
                        let _e487 = phi_845_;
                        if _e487 {
                            let _e488 = (_e480 > 0u);
                            if _e488 {
                                if _e482 {
                                    phi_932_ = _e478;
                                    phi_933_ = _e482;
                                    phi_934_ = _e484;
                                } else {
                                    let _e489 = (_e484 - 1u);
                                    let _e490 = (_e489 % 128u);
                                    let _e491 = (_e490 < 128u);
                                    if _e491 {
                                    } else {
                                        phi_3098_ = true;
                                        break;
                                    }
                                    let _e493 = local_6[_e490];
                                    if _e491 {
                                    } else {
                                        phi_3098_ = true;
                                        break;
                                    }
                                    let _e495 = local_5[_e490];
                                    if _e491 {
                                    } else {
                                        phi_3098_ = true;
                                        break;
                                    }
                                    let _e497 = local_4[_e490];
                                    if _e491 {
                                    } else {
                                        phi_3098_ = true;
                                        break;
                                    }
                                    let _e499 = local_3[_e490];
                                    if _e491 {
                                    } else {
                                        phi_3098_ = true;
                                        break;
                                    }
                                    let _e502 = local_2[_e490];
                                    if _e491 {
                                    } else {
                                        phi_3098_ = true;
                                        break;
                                    }
                                    let _e504 = local_1[_e490];
                                    if _e491 {
                                    } else {
                                        phi_3098_ = true;
                                        break;
                                    }
                                    let _e506 = local[_e490];
                                    if _e491 {
                                    } else {
                                        phi_3098_ = true;
                                        break;
                                    }
                                    let _e511 = local_8[_e490];
                                    phi_932_ = type_51(type_49(array<f32, 3>(_e495, _e497, _e499), array<f32, 3>(_e502, _e504, _e506)), _e493);
                                    phi_933_ = (_e511 <= _e476);
                                    phi_934_ = _e489;
                                }
                                let _e514 = phi_932_;
                                let _e516 = phi_933_;
                                let _e518 = phi_934_;
                                if _e516 {
                                    if ((_e514.member_1 & 2147483648u) != 0u) {
                                        phi_2988_ = _e474;
                                        phi_2978_ = _e476;
                                        phi_952_ = type_4(0u, ((_e514.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e869 = phi_2988_;
                                            let _e871 = phi_2978_;
                                            let _e873 = phi_952_;
                                            if (_e873.member < _e873.member_1) {
                                                phi_953_ = type_4((_e873.member + 1u), _e873.member_1);
                                                phi_976_ = type_4(1u, _e873.member);
                                            } else {
                                                phi_953_ = _e873;
                                                phi_976_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e886 = phi_953_;
                                            let _e888 = phi_976_;
                                            let _e892 = (bitcast<i32>(_e888.member) != 0i);
                                            if _e892 {
                                                let _e893 = ((_e514.member_1 & 268435455u) + _e888.member_1);
                                                let _e894 = (_e893 < _e83);
                                                if _e894 {
                                                    if _e894 {
                                                    } else {
                                                        phi_3207_ = _e871;
                                                        phi_3093_ = true;
                                                        break;
                                                    }
                                                    let _e898 = global_2.member[_e893].member_1;
                                                    phi_997_ = _e898;
                                                } else {
                                                    phi_997_ = 4294967295u;
                                                }
                                                let _e900 = phi_997_;
                                                if (_e893 >= _e83) {
                                                    phi_1086_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e894 {
                                                    } else {
                                                        phi_3207_ = _e871;
                                                        phi_3093_ = true;
                                                        break;
                                                    }
                                                    if (_e447 < 9u) {
                                                    } else {
                                                        phi_3207_ = _e871;
                                                        phi_3093_ = true;
                                                        break;
                                                    }
                                                    let _e907 = global_2.member[_e893].member[_e447];
                                                    if (_e451 < 9u) {
                                                    } else {
                                                        phi_3207_ = _e871;
                                                        phi_3093_ = true;
                                                        break;
                                                    }
                                                    let _e913 = global_2.member[_e893].member[_e451];
                                                    if (_e455 < 9u) {
                                                    } else {
                                                        phi_3207_ = _e871;
                                                        phi_3093_ = true;
                                                        break;
                                                    }
                                                    let _e919 = global_2.member[_e893].member[_e455];
                                                    let _e921 = (3u + _e447);
                                                    if (_e921 < 9u) {
                                                    } else {
                                                        phi_3207_ = _e871;
                                                        phi_3093_ = true;
                                                        break;
                                                    }
                                                    let _e927 = global_2.member[_e893].member[_e921];
                                                    let _e928 = (3u + _e451);
                                                    if (_e928 < 9u) {
                                                    } else {
                                                        phi_3207_ = _e871;
                                                        phi_3093_ = true;
                                                        break;
                                                    }
                                                    let _e934 = global_2.member[_e893].member[_e928];
                                                    let _e935 = (3u + _e455);
                                                    if (_e935 < 9u) {
                                                    } else {
                                                        phi_3207_ = _e871;
                                                        phi_3093_ = true;
                                                        break;
                                                    }
                                                    let _e941 = global_2.member[_e893].member[_e935];
                                                    let _e943 = (6u + _e447);
                                                    if (_e943 < 9u) {
                                                    } else {
                                                        phi_3207_ = _e871;
                                                        phi_3093_ = true;
                                                        break;
                                                    }
                                                    let _e949 = global_2.member[_e893].member[_e943];
                                                    let _e950 = (6u + _e451);
                                                    if (_e950 < 9u) {
                                                    } else {
                                                        phi_3207_ = _e871;
                                                        phi_3093_ = true;
                                                        break;
                                                    }
                                                    let _e956 = global_2.member[_e893].member[_e950];
                                                    let _e957 = (6u + _e455);
                                                    if (_e957 < 9u) {
                                                    } else {
                                                        phi_3207_ = _e871;
                                                        phi_3093_ = true;
                                                        break;
                                                    }
                                                    let _e963 = global_2.member[_e893].member[_e957];
                                                    phi_1086_ = array<array<f32, 3>, 3>(array<f32, 3>(_e907, _e913, _e919), array<f32, 3>(_e927, _e934, _e941), array<f32, 3>(_e949, _e956, _e963));
                                                }
                                                let _e967 = phi_1086_;
                                                let _e974 = (_e967[0][2] - _e369);
                                                let _e977 = (((_e967[0][0] - _e292) * _e393) - (_e974 * _e317));
                                                let _e980 = (((_e967[0][1] - _e331) * _e393) - (_e974 * _e355));
                                                let _e987 = (_e967[1][2] - _e369);
                                                let _e990 = (((_e967[1][0] - _e292) * _e393) - (_e987 * _e317));
                                                let _e993 = (((_e967[1][1] - _e331) * _e393) - (_e987 * _e355));
                                                let _e1000 = (_e967[2][2] - _e369);
                                                let _e1003 = (((_e967[2][0] - _e292) * _e393) - (_e1000 * _e317));
                                                let _e1006 = (((_e967[2][1] - _e331) * _e393) - (_e1000 * _e355));
                                                let _e1007 = (_e1003 * _e993);
                                                let _e1008 = (_e1006 * _e990);
                                                let _e1009 = (_e977 * _e1006);
                                                let _e1010 = (_e980 * _e1003);
                                                let _e1011 = (_e990 * _e980);
                                                let _e1012 = (_e993 * _e977);
                                                let _e1017 = (((_e1007 >= _e1008) && (_e1009 >= _e1010)) && (_e1011 >= _e1012));
                                                if (_e1017 || (((_e1007 <= _e1008) && (_e1009 <= _e1010)) && (_e1011 <= _e1012))) {
                                                    let _e1024 = select(-1f, 1f, _e1017);
                                                    let _e1026 = ((_e1007 - _e1008) * _e1024);
                                                    let _e1028 = select(0f, _e1026, (_e1026 > 0f));
                                                    let _e1030 = ((_e1009 - _e1010) * _e1024);
                                                    let _e1032 = select(0f, _e1030, (_e1030 > 0f));
                                                    let _e1034 = ((_e1011 - _e1012) * _e1024);
                                                    let _e1036 = select(0f, _e1034, (_e1034 > 0f));
                                                    let _e1038 = ((_e1028 + _e1032) + _e1036);
                                                    if (_e1038 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1653_ = type_22();
                                                        phi_1654_ = true;
                                                    } else {
                                                        let _e1041 = select(_e967[1][0], _e967[0][0], (_e967[0][0] < _e967[1][0]));
                                                        let _e1045 = select(_e967[1][0], _e967[0][0], (_e967[0][0] > _e967[1][0]));
                                                        let _e1049 = select(_e967[1][1], _e967[0][1], (_e967[0][1] < _e967[1][1]));
                                                        let _e1053 = select(_e967[1][1], _e967[0][1], (_e967[0][1] > _e967[1][1]));
                                                        let _e1057 = select(_e967[1][2], _e967[0][2], (_e967[0][2] < _e967[1][2]));
                                                        let _e1061 = select(_e967[1][2], _e967[0][2], (_e967[0][2] > _e967[1][2]));
                                                        let _e1066 = ((select(_e967[2][0], _e1041, (_e1041 < _e967[2][0])) - _e315) * _e320);
                                                        let _e1067 = ((select(_e967[2][0], _e1045, (_e1045 > _e967[2][0])) - _e316) * _e320);
                                                        let _e1070 = ((select(_e967[2][1], _e1049, (_e1049 < _e967[2][1])) - _e353) * _e358);
                                                        let _e1071 = ((select(_e967[2][1], _e1053, (_e1053 > _e967[2][1])) - _e354) * _e358);
                                                        let _e1074 = ((select(_e967[2][2], _e1057, (_e1057 < _e967[2][2])) - _e391) * _e396);
                                                        let _e1075 = ((select(_e967[2][2], _e1061, (_e1061 > _e967[2][2])) - _e392) * _e396);
                                                        let _e1077 = select(_e1075, _e1074, (_e1074 < _e1075));
                                                        let _e1079 = select(_e1075, _e1074, (_e1074 > _e1075));
                                                        let _e1081 = select(_e1067, _e1066, (_e1066 < _e1067));
                                                        let _e1083 = select(_e1071, _e1070, (_e1070 < _e1071));
                                                        let _e1085 = select(_e1083, _e1081, (_e1081 > _e1083));
                                                        let _e1087 = select(_e1077, _e1085, (_e1085 > _e1077));
                                                        let _e1089 = select(_e1067, _e1066, (_e1066 > _e1067));
                                                        let _e1091 = select(_e1071, _e1070, (_e1070 > _e1071));
                                                        let _e1093 = select(_e1091, _e1089, (_e1089 < _e1091));
                                                        let _e1095 = select(_e1079, _e1093, (_e1093 < _e1079));
                                                        let _e1096 = -(_e1077);
                                                        let _e1102 = select(_e443, _e1087, (_e1087 > _e443));
                                                        if (_e1102 > (_e1095 + (select(_e1096, _e1079, (_e1079 > _e1096)) * 0.0000019073523f))) {
                                                            phi_1648_ = type_22();
                                                            phi_1649_ = true;
                                                        } else {
                                                            let _e1104 = (_e1102 > _e871);
                                                            if _e1104 {
                                                                phi_1647_ = type_22();
                                                            } else {
                                                                let _e1108 = (_e967[1][0] - _e967[0][0]);
                                                                let _e1109 = (_e967[1][1] - _e967[0][1]);
                                                                let _e1110 = (_e967[1][2] - _e967[0][2]);
                                                                let _e1111 = vec3<f32>(_e1108, _e1109, _e1110);
                                                                let _e1112 = (_e967[2][0] - _e967[1][0]);
                                                                let _e1113 = (_e967[2][1] - _e967[1][1]);
                                                                let _e1114 = (_e967[2][2] - _e967[1][2]);
                                                                let _e1115 = vec3<f32>(_e1112, _e1113, _e1114);
                                                                let _e1116 = (_e967[0][0] - _e967[2][0]);
                                                                let _e1117 = (_e967[0][1] - _e967[2][1]);
                                                                let _e1118 = (_e967[0][2] - _e967[2][2]);
                                                                let _e1119 = vec3<f32>(_e1116, _e1117, _e1118);
                                                                let _e1122 = bitcast<f32>((bitcast<u32>(_e1108) & 2147483647u));
                                                                let _e1125 = bitcast<f32>((bitcast<u32>(_e1109) & 2147483647u));
                                                                let _e1127 = select(_e1125, _e1122, (_e1122 > _e1125));
                                                                let _e1130 = bitcast<f32>((bitcast<u32>(_e1110) & 2147483647u));
                                                                let _e1132 = select(_e1130, _e1127, (_e1127 > _e1130));
                                                                let _e1135 = bitcast<f32>((bitcast<u32>(_e1112) & 2147483647u));
                                                                let _e1138 = bitcast<f32>((bitcast<u32>(_e1113) & 2147483647u));
                                                                let _e1140 = select(_e1138, _e1135, (_e1135 > _e1138));
                                                                let _e1143 = bitcast<f32>((bitcast<u32>(_e1114) & 2147483647u));
                                                                let _e1145 = select(_e1143, _e1140, (_e1140 > _e1143));
                                                                let _e1148 = bitcast<f32>((bitcast<u32>(_e1116) & 2147483647u));
                                                                let _e1151 = bitcast<f32>((bitcast<u32>(_e1117) & 2147483647u));
                                                                let _e1153 = select(_e1151, _e1148, (_e1148 > _e1151));
                                                                let _e1156 = bitcast<f32>((bitcast<u32>(_e1118) & 2147483647u));
                                                                let _e1158 = select(_e1156, _e1153, (_e1153 > _e1156));
                                                                let _e1160 = select(_e1145, _e1132, (_e1132 > _e1145));
                                                                let _e1162 = select(_e1158, _e1160, (_e1160 > _e1158));
                                                                if (_e1132 == _e1162) {
                                                                    phi_1558_ = _e1115;
                                                                    phi_1559_ = _e1119;
                                                                } else {
                                                                    let _e1165 = vec3((_e1145 == _e1162));
                                                                    phi_1558_ = select(_e1111, _e1119, _e1165);
                                                                    phi_1559_ = select(_e1115, _e1111, _e1165);
                                                                }
                                                                let _e1169 = phi_1558_;
                                                                let _e1171 = phi_1559_;
                                                                let _e1178 = ((_e1169.y * _e1171.z) - (_e1171.y * _e1169.z));
                                                                let _e1183 = ((_e1169.z * _e1171.x) - (_e1171.z * _e1169.x));
                                                                let _e1186 = ((_e1169.x * _e1171.y) - (_e1171.x * _e1169.y));
                                                                if (_e1028 >= _e1032) {
                                                                    phi_1590_ = select(true, false, (_e1028 >= _e1036));
                                                                } else {
                                                                    phi_1590_ = true;
                                                                }
                                                                let _e1191 = phi_1590_;
                                                                if _e1191 {
                                                                    phi_1599_ = select(vec3<f32>(_e967[2][0], _e967[2][1], _e967[2][2]), vec3<f32>(_e967[1][0], _e967[1][1], _e967[1][2]), vec3((_e1032 >= _e1036)));
                                                                } else {
                                                                    phi_1599_ = vec3<f32>(_e967[0][0], _e967[0][1], _e967[0][2]);
                                                                }
                                                                let _e1196 = phi_1599_;
                                                                let _e1213 = ((((_e1178 * (_e1196.x - _e292)) + (_e1183 * (_e1196.y - _e331))) + (_e1186 * (_e1196.z - _e369))) / (((_e1178 * _e317) + (_e1183 * _e355)) + (_e1186 * _e393)));
                                                                let _e1215 = select(_e1095, _e1213, (_e1213 < _e1095));
                                                                let _e1217 = select(_e1087, _e1215, (_e1215 > _e1087));
                                                                if (_e1217 >= _e443) {
                                                                    let _e1219 = (_e1217 <= _e871);
                                                                    if _e1219 {
                                                                        let _e1220 = (1f / _e1038);
                                                                        phi_1639_ = type_22(_e1217, (_e1032 * _e1220), (_e1036 * _e1220), _e900);
                                                                    } else {
                                                                        phi_1639_ = type_22();
                                                                    }
                                                                    let _e1225 = phi_1639_;
                                                                    phi_1641_ = _e1225;
                                                                    phi_1642_ = select(true, false, _e1219);
                                                                } else {
                                                                    phi_1641_ = type_22();
                                                                    phi_1642_ = true;
                                                                }
                                                                let _e1228 = phi_1641_;
                                                                let _e1230 = phi_1642_;
                                                                if _e1230 {
                                                                    phi_1646_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1646_ = _e1228;
                                                                }
                                                                let _e1232 = phi_1646_;
                                                                phi_1647_ = _e1232;
                                                            }
                                                            let _e1234 = phi_1647_;
                                                            phi_1648_ = _e1234;
                                                            phi_1649_ = _e1104;
                                                        }
                                                        let _e1236 = phi_1648_;
                                                        let _e1238 = phi_1649_;
                                                        phi_1653_ = _e1236;
                                                        phi_1654_ = _e1238;
                                                    }
                                                    let _e1240 = phi_1653_;
                                                    let _e1242 = phi_1654_;
                                                    phi_1658_ = _e1240;
                                                    phi_1659_ = _e1242;
                                                } else {
                                                    phi_1658_ = type_22();
                                                    phi_1659_ = true;
                                                }
                                                let _e1244 = phi_1658_;
                                                let _e1246 = phi_1659_;
                                                if _e1246 {
                                                    phi_1663_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1663_ = _e1244;
                                                }
                                                let _e1248 = phi_1663_;
                                                if (_e1248.member_3 != 4294967295u) {
                                                    if (_e900 != 4294967295u) {
                                                        phi_1675_ = type_4(0u, 8u);
                                                        phi_1678_ = _e1248;
                                                        loop {
                                                            let _e1253 = phi_1675_;
                                                            let _e1255 = phi_1678_;
                                                            if (_e1253.member < _e1253.member_1) {
                                                                phi_1676_ = type_4((_e1253.member + 1u), _e1253.member_1);
                                                                phi_1701_ = type_4(1u, _e1253.member);
                                                            } else {
                                                                phi_1676_ = _e1253;
                                                                phi_1701_ = type_4(0u, type_4().member_1);
                                                            }
                                                            let _e1268 = phi_1676_;
                                                            let _e1270 = phi_1701_;
                                                            let _e1274 = (bitcast<i32>(_e1270.member) != 0i);
                                                            if _e1274 {
                                                                let _e1275 = (_e1270.member_1 < 8u);
                                                                if _e1275 {
                                                                } else {
                                                                    phi_2979_ = true;
                                                                    break;
                                                                }
                                                                let _e1280 = local_7[_e1270.member_1].member;
                                                                if (_e1255.member < _e1280) {
                                                                    phi_1734_ = true;
                                                                } else {
                                                                    let _e1282 = local_7[_e1270.member_1].member;
                                                                    if (_e1255.member == _e1282) {
                                                                        let _e1287 = local_7[_e1270.member_1].member_3;
                                                                        phi_1733_ = (_e1255.member_3 < _e1287);
                                                                    } else {
                                                                        phi_1733_ = false;
                                                                    }
                                                                    let _e1290 = phi_1733_;
                                                                    phi_1734_ = _e1290;
                                                                }
                                                                let _e1292 = phi_1734_;
                                                                if _e1292 {
                                                                    if _e1275 {
                                                                    } else {
                                                                        phi_2979_ = true;
                                                                        break;
                                                                    }
                                                                    let _e1293 = local_7[_e1270.member_1];
                                                                    local_7[_e1270.member_1] = type_22(_e1255.member, _e1255.member_1, _e1255.member_2, _e1255.member_3);
                                                                    phi_1755_ = type_22(_e1293.member, _e1293.member_1, _e1293.member_2, _e1293.member_3);
                                                                } else {
                                                                    phi_1755_ = _e1255;
                                                                }
                                                                let _e1304 = phi_1755_;
                                                                phi_1679_ = _e1304;
                                                            } else {
                                                                phi_1679_ = type_22();
                                                            }
                                                            let _e1306 = phi_1679_;
                                                            continue;
                                                            continuing {
                                                                phi_1675_ = _e1268;
                                                                phi_1678_ = _e1306;
                                                                phi_2979_ = _e869;
                                                                break if !(_e1274);
                                                            }
                                                        }
                                                        let _e1309 = phi_2979_;
                                                        phi_3207_ = _e871;
                                                        phi_3093_ = _e1309;
                                                        if _e1309 {
                                                            break;
                                                        }
                                                        let _e1312 = local_7[7u].member_3;
                                                        if (_e1312 != 4294967295u) {
                                                            let _e1316 = local_7[7u].member;
                                                            phi_3270_ = _e1316;
                                                        } else {
                                                            phi_3270_ = _e871;
                                                        }
                                                        let _e1318 = phi_3270_;
                                                        phi_3269_ = _e1318;
                                                        phi_3096_ = _e1309;
                                                    } else {
                                                        phi_3269_ = _e871;
                                                        phi_3096_ = _e869;
                                                    }
                                                    let _e1320 = phi_3269_;
                                                    let _e1322 = phi_3096_;
                                                    phi_3268_ = _e1320;
                                                    phi_3095_ = _e1322;
                                                } else {
                                                    phi_3268_ = _e871;
                                                    phi_3095_ = _e869;
                                                }
                                                let _e1324 = phi_3268_;
                                                let _e1326 = phi_3095_;
                                                phi_3267_ = _e1324;
                                                phi_3094_ = _e1326;
                                            } else {
                                                phi_3267_ = _e871;
                                                phi_3094_ = _e869;
                                            }
                                            let _e1328 = phi_3267_;
                                            let _e1330 = phi_3094_;
                                            continue;
                                            continuing {
                                                phi_2988_ = _e1330;
                                                phi_2978_ = _e1328;
                                                phi_952_ = _e886;
                                                phi_3207_ = _e1328;
                                                phi_3093_ = _e1330;
                                                break if !(_e892);
                                            }
                                        }
                                        let _e1333 = phi_3207_;
                                        let _e1335 = phi_3093_;
                                        phi_3098_ = _e1335;
                                        if _e1335 {
                                            break;
                                        }
                                        phi_3172_ = _e1333;
                                        phi_3102_ = _e1335;
                                        phi_2716_ = _e514;
                                        phi_2717_ = false;
                                        phi_2718_ = _e518;
                                    } else {
                                        let _e527 = (_e514.member_1 < _e81);
                                        if _e527 {
                                            if _e527 {
                                            } else {
                                                phi_3098_ = true;
                                                break;
                                            }
                                            let _e529 = global_5.member[_e514.member_1];
                                            phi_1785_ = _e529;
                                        } else {
                                            phi_1785_ = type_44(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e531 = phi_1785_;
                                        let _e546 = ((10u * _e243) & 31u);
                                        let _e549 = ((_e531.member[0] >> bitcast<u32>(_e546)) & 1023u);
                                        let _e554 = bitcast<f32>((bitcast<u32>(((_e514.member.member_1[0] - _e514.member.member[0]) * 0.0009775171f)) ^ _e115));
                                        let _e560 = (_e514.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e549) * _e554)) ^ _e115)));
                                        let _e564 = select(select(_e514.member.member_1[0], _e560, (_e560 < _e514.member.member_1[0])), _e514.member.member_1[0], (_e549 == 1023u));
                                        let _e566 = ((10u * _e242) & 31u);
                                        let _e569 = ((_e531.member[0] >> bitcast<u32>(_e566)) & 1023u);
                                        let _e574 = bitcast<f32>((bitcast<u32>(((_e514.member.member_1[1] - _e514.member.member[1]) * 0.0009775171f)) ^ _e115));
                                        let _e580 = (_e514.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e569) * _e574)) ^ _e115)));
                                        let _e584 = select(select(_e514.member.member_1[1], _e580, (_e580 < _e514.member.member_1[1])), _e514.member.member_1[1], (_e569 == 1023u));
                                        let _e586 = ((10u * _e244) & 31u);
                                        let _e589 = ((_e531.member[0] >> bitcast<u32>(_e586)) & 1023u);
                                        let _e594 = bitcast<f32>((bitcast<u32>(((_e514.member.member_1[2] - _e514.member.member[2]) * 0.0009775171f)) ^ _e115));
                                        let _e600 = (_e514.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e589) * _e594)) ^ _e115)));
                                        let _e604 = select(select(_e514.member.member_1[2], _e600, (_e600 < _e514.member.member_1[2])), _e514.member.member_1[2], (_e589 == 1023u));
                                        let _e607 = ((_e531.member[1] >> bitcast<u32>(_e546)) & 1023u);
                                        let _e613 = (_e514.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e607) * _e554)) ^ _e115)));
                                        let _e617 = select(select(_e514.member.member_1[0], _e613, (_e613 < _e514.member.member_1[0])), _e514.member.member_1[0], (_e607 == 1023u));
                                        let _e620 = ((_e531.member[1] >> bitcast<u32>(_e566)) & 1023u);
                                        let _e626 = (_e514.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e620) * _e574)) ^ _e115)));
                                        let _e630 = select(select(_e514.member.member_1[1], _e626, (_e626 < _e514.member.member_1[1])), _e514.member.member_1[1], (_e620 == 1023u));
                                        let _e633 = ((_e531.member[1] >> bitcast<u32>(_e586)) & 1023u);
                                        let _e639 = (_e514.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e633) * _e594)) ^ _e115)));
                                        let _e643 = select(select(_e514.member.member_1[2], _e639, (_e639 < _e514.member.member_1[2])), _e514.member.member_1[2], (_e633 == 1023u));
                                        let _e649 = ((_e531.member_1[0] >> bitcast<u32>(_e546)) & 1023u);
                                        let _e655 = (_e514.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e649) * _e554)) ^ _e115)));
                                        let _e659 = select(select(_e514.member.member_1[0], _e655, (_e655 < _e514.member.member_1[0])), _e514.member.member_1[0], (_e649 == 1023u));
                                        let _e662 = ((_e531.member_1[0] >> bitcast<u32>(_e566)) & 1023u);
                                        let _e668 = (_e514.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e662) * _e574)) ^ _e115)));
                                        let _e672 = select(select(_e514.member.member_1[1], _e668, (_e668 < _e514.member.member_1[1])), _e514.member.member_1[1], (_e662 == 1023u));
                                        let _e675 = ((_e531.member_1[0] >> bitcast<u32>(_e586)) & 1023u);
                                        let _e681 = (_e514.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e675) * _e594)) ^ _e115)));
                                        let _e685 = select(select(_e514.member.member_1[2], _e681, (_e681 < _e514.member.member_1[2])), _e514.member.member_1[2], (_e675 == 1023u));
                                        let _e688 = ((_e531.member_1[1] >> bitcast<u32>(_e546)) & 1023u);
                                        let _e694 = (_e514.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e688) * _e554)) ^ _e115)));
                                        let _e698 = select(select(_e514.member.member_1[0], _e694, (_e694 < _e514.member.member_1[0])), _e514.member.member_1[0], (_e688 == 1023u));
                                        let _e701 = ((_e531.member_1[1] >> bitcast<u32>(_e566)) & 1023u);
                                        let _e707 = (_e514.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e701) * _e574)) ^ _e115)));
                                        let _e711 = select(select(_e514.member.member_1[1], _e707, (_e707 < _e514.member.member_1[1])), _e514.member.member_1[1], (_e701 == 1023u));
                                        let _e714 = ((_e531.member_1[1] >> bitcast<u32>(_e586)) & 1023u);
                                        let _e720 = (_e514.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e714) * _e594)) ^ _e115)));
                                        let _e724 = select(select(_e514.member.member_1[2], _e720, (_e720 < _e514.member.member_1[2])), _e514.member.member_1[2], (_e714 == 1023u));
                                        let _e729 = type_51(type_49(array<f32, 3>(_e564, _e584, _e604), array<f32, 3>(_e617, _e630, _e643)), _e531.member_2);
                                        let _e734 = type_51(type_49(array<f32, 3>(_e659, _e672, _e685), array<f32, 3>(_e698, _e711, _e724)), _e531.member_3);
                                        let _e739 = ((_e564 - _e315) * _e320);
                                        let _e740 = ((_e659 - _e315) * _e320);
                                        let _e741 = ((_e617 - _e316) * _e320);
                                        let _e742 = ((_e698 - _e316) * _e320);
                                        let _e747 = ((_e584 - _e353) * _e358);
                                        let _e748 = ((_e672 - _e353) * _e358);
                                        let _e749 = ((_e630 - _e354) * _e358);
                                        let _e750 = ((_e711 - _e354) * _e358);
                                        let _e755 = ((_e604 - _e391) * _e396);
                                        let _e756 = ((_e685 - _e391) * _e396);
                                        let _e757 = ((_e643 - _e392) * _e396);
                                        let _e758 = ((_e724 - _e392) * _e396);
                                        let _e760 = select(_e757, _e755, (_e755 < _e757));
                                        let _e762 = select(_e758, _e756, (_e756 < _e758));
                                        let _e764 = select(_e757, _e755, (_e755 > _e757));
                                        let _e766 = select(_e758, _e756, (_e756 > _e758));
                                        let _e768 = select(_e741, _e739, (_e739 < _e741));
                                        let _e770 = select(_e742, _e740, (_e740 < _e742));
                                        let _e772 = select(_e749, _e747, (_e747 < _e749));
                                        let _e774 = select(_e750, _e748, (_e748 < _e750));
                                        let _e776 = select(_e772, _e768, (_e768 > _e772));
                                        let _e778 = select(_e774, _e770, (_e770 > _e774));
                                        let _e780 = select(_e760, _e776, (_e776 > _e760));
                                        let _e782 = select(_e762, _e778, (_e778 > _e762));
                                        let _e784 = select(_e741, _e739, (_e739 > _e741));
                                        let _e786 = select(_e742, _e740, (_e740 > _e742));
                                        let _e788 = select(_e749, _e747, (_e747 > _e749));
                                        let _e790 = select(_e750, _e748, (_e748 > _e750));
                                        let _e792 = select(_e788, _e784, (_e784 < _e788));
                                        let _e794 = select(_e790, _e786, (_e786 < _e790));
                                        let _e799 = -(_e760);
                                        let _e800 = -(_e762);
                                        let _e807 = (select(_e764, _e792, (_e792 < _e764)) + (select(_e799, _e764, (_e764 > _e799)) * 0.0000019073523f));
                                        let _e808 = (select(_e766, _e794, (_e794 < _e766)) + (select(_e800, _e766, (_e766 > _e800)) * 0.0000019073523f));
                                        let _e810 = select(_e443, _e780, (_e780 > _e443));
                                        let _e812 = select(_e443, _e782, (_e782 > _e443));
                                        let _e817 = (_e810 <= select(_e476, _e807, (_e807 < _e476)));
                                        let _e818 = (_e812 <= select(_e476, _e808, (_e808 < _e476)));
                                        let _e819 = (_e810 <= _e812);
                                        if _e817 {
                                            if _e818 {
                                                if _e819 {
                                                    phi_2618_ = _e734;
                                                } else {
                                                    phi_2618_ = _e729;
                                                }
                                                let _e821 = phi_2618_;
                                                let _e829 = (_e518 % 128u);
                                                let _e830 = (_e829 < 128u);
                                                if _e830 {
                                                } else {
                                                    phi_3098_ = true;
                                                    break;
                                                }
                                                local_6[_e829] = _e821.member_1;
                                                if _e830 {
                                                } else {
                                                    phi_3098_ = true;
                                                    break;
                                                }
                                                local_5[_e829] = _e821.member.member[0];
                                                if _e830 {
                                                } else {
                                                    phi_3098_ = true;
                                                    break;
                                                }
                                                local_4[_e829] = _e821.member.member[1];
                                                if _e830 {
                                                } else {
                                                    phi_3098_ = true;
                                                    break;
                                                }
                                                local_3[_e829] = _e821.member.member[2];
                                                if _e830 {
                                                } else {
                                                    phi_3098_ = true;
                                                    break;
                                                }
                                                local_2[_e829] = _e821.member.member_1[0];
                                                if _e830 {
                                                } else {
                                                    phi_3098_ = true;
                                                    break;
                                                }
                                                local_1[_e829] = _e821.member.member_1[1];
                                                if _e830 {
                                                } else {
                                                    phi_3098_ = true;
                                                    break;
                                                }
                                                local[_e829] = _e821.member.member_1[2];
                                                if _e830 {
                                                } else {
                                                    phi_3098_ = true;
                                                    break;
                                                }
                                                local_8[_e829] = select(_e812, _e810, (_e810 > _e812));
                                                if _e819 {
                                                    phi_2695_ = _e729;
                                                } else {
                                                    phi_2695_ = _e734;
                                                }
                                                let _e847 = phi_2695_;
                                                phi_2696_ = _e847;
                                                phi_2697_ = (_e518 + 1u);
                                            } else {
                                                phi_2696_ = type_51();
                                                phi_2697_ = u32();
                                            }
                                            let _e849 = phi_2696_;
                                            let _e851 = phi_2697_;
                                            phi_2699_ = _e849;
                                            phi_2700_ = _e851;
                                            phi_2701_ = select(true, false, _e818);
                                        } else {
                                            phi_2699_ = type_51();
                                            phi_2700_ = u32();
                                            phi_2701_ = true;
                                        }
                                        let _e854 = phi_2699_;
                                        let _e856 = phi_2700_;
                                        let _e858 = phi_2701_;
                                        if _e858 {
                                            if _e817 {
                                                phi_2708_ = _e729;
                                            } else {
                                                phi_2708_ = _e734;
                                            }
                                            let _e860 = phi_2708_;
                                            phi_2713_ = _e860;
                                            phi_2714_ = select(_e818, true, _e817);
                                        } else {
                                            phi_2713_ = _e854;
                                            phi_2714_ = _e516;
                                        }
                                        let _e863 = phi_2713_;
                                        let _e865 = phi_2714_;
                                        phi_3172_ = _e476;
                                        phi_3102_ = _e474;
                                        phi_2716_ = _e863;
                                        phi_2717_ = _e865;
                                        phi_2718_ = select(_e856, _e518, _e858);
                                    }
                                    let _e1337 = phi_3172_;
                                    let _e1339 = phi_3102_;
                                    let _e1341 = phi_2716_;
                                    let _e1343 = phi_2717_;
                                    let _e1345 = phi_2718_;
                                    phi_3171_ = _e1337;
                                    phi_3101_ = _e1339;
                                    phi_2719_ = _e1341;
                                    phi_2720_ = (_e480 - 1u);
                                    phi_2721_ = _e1343;
                                    phi_2722_ = _e1345;
                                } else {
                                    phi_3171_ = _e476;
                                    phi_3101_ = _e474;
                                    phi_2719_ = _e514;
                                    phi_2720_ = _e480;
                                    phi_2721_ = _e516;
                                    phi_2722_ = _e518;
                                }
                                let _e1347 = phi_3171_;
                                let _e1349 = phi_3101_;
                                let _e1351 = phi_2719_;
                                let _e1353 = phi_2720_;
                                let _e1355 = phi_2721_;
                                let _e1357 = phi_2722_;
                                phi_3170_ = _e1347;
                                phi_3100_ = _e1349;
                                phi_2723_ = _e1351;
                                phi_2724_ = _e1353;
                                phi_2725_ = _e1355;
                                phi_2726_ = _e1357;
                            } else {
                                phi_3170_ = _e476;
                                phi_3100_ = _e474;
                                phi_2723_ = type_51();
                                phi_2724_ = u32();
                                phi_2725_ = bool();
                                phi_2726_ = u32();
                            }
                            let _e1359 = phi_3170_;
                            let _e1361 = phi_3100_;
                            let _e1363 = phi_2723_;
                            let _e1365 = phi_2724_;
                            let _e1367 = phi_2725_;
                            let _e1369 = phi_2726_;
                            phi_3169_ = _e1359;
                            phi_3099_ = _e1361;
                            phi_828_ = _e1363;
                            phi_831_ = _e1365;
                            phi_833_ = _e1367;
                            phi_835_ = _e1369;
                            phi_2727_ = _e488;
                        } else {
                            phi_3169_ = _e476;
                            phi_3099_ = _e474;
                            phi_828_ = type_51();
                            phi_831_ = u32();
                            phi_833_ = bool();
                            phi_835_ = u32();
                            phi_2727_ = false;
                        }
                        let _e1371 = phi_3169_;
                        let _e1373 = phi_3099_;
                        let _e1375 = phi_828_;
                        let _e1377 = phi_831_;
                        let _e1379 = phi_833_;
                        let _e1381 = phi_835_;
                        let _e1383 = phi_2727_;
                        continue;
                        continuing {
                            phi_2991_ = _e1373;
                            phi_2947_ = _e1371;
                            phi_827_ = _e1375;
                            phi_830_ = _e1377;
                            phi_832_ = _e1379;
                            phi_834_ = _e1381;
                            phi_3098_ = _e1373;
                            break if !(_e1383);
                        }
                    }
                    let _e1386 = phi_3098_;
                    if _e1386 {
                        break;
                    }
                    phi_2734_ = type_4(0u, 8u);
                    loop {
                        let _e1388 = phi_2734_;
                        if (_e1388.member < _e1388.member_1) {
                            phi_2735_ = type_4((_e1388.member + 1u), _e1388.member_1);
                            phi_2758_ = type_4(1u, _e1388.member);
                        } else {
                            phi_2735_ = _e1388;
                            phi_2758_ = type_4(0u, type_4().member_1);
                        }
                        let _e1401 = phi_2735_;
                        let _e1403 = phi_2758_;
                        let _e1407 = (bitcast<i32>(_e1403.member) != 0i);
                        if _e1407 {
                            let _e1408 = (_e1403.member_1 < 8u);
                            if _e1408 {
                            } else {
                                phi_3162_ = true;
                                break;
                            }
                            let _e1410 = local_7[_e1403.member_1];
                            if (_e1410.member_3 != 4294967295u) {
                                let _e1416 = -(_e410);
                                let _e1417 = (_e1416 / 3i);
                                let _e1424 = bitcast<f32>((bitcast<u32>((_e1417 + 127i)) << bitcast<u32>(23i)));
                                let _e1432 = (((_e1410.member * _e1424) * _e1424) * bitcast<f32>((bitcast<u32>(((_e1416 - (2i * _e1417)) + 127i)) << bitcast<u32>(23i))));
                                let _e1434 = select(340282350000000000000000000000000000000f, _e1432, (_e1432 < 340282350000000000000000000000000000000f));
                                phi_2824_ = type_22(select(-340282350000000000000000000000000000000f, _e1434, (_e1434 > -340282350000000000000000000000000000000f)), _e1410.member_1, _e1410.member_2, _e1410.member_3);
                            } else {
                                phi_2824_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                            }
                            let _e1439 = phi_2824_;
                            if _e1408 {
                            } else {
                                phi_3162_ = true;
                                break;
                            }
                            local_7[_e1403.member_1] = type_22(_e1439.member, _e1439.member_1, _e1439.member_2, _e1439.member_3);
                        }
                        continue;
                        continuing {
                            phi_2734_ = _e1401;
                            phi_3162_ = _e1386;
                            break if !(_e1407);
                        }
                    }
                    let _e1447 = phi_3162_;
                    if _e1447 {
                        break;
                    }
                    let _e1448 = local_7;
                    if _e131 {
                    } else {
                        break;
                    }
                    global_6.member[_e129] = array<type_22, 8>(type_22(_e1448[0].member, _e1448[0].member_1, _e1448[0].member_2, _e1448[0].member_3), type_22(_e1448[1].member, _e1448[1].member_1, _e1448[1].member_2, _e1448[1].member_3), type_22(_e1448[2].member, _e1448[2].member_1, _e1448[2].member_2, _e1448[2].member_3), type_22(_e1448[3].member, _e1448[3].member_1, _e1448[3].member_2, _e1448[3].member_3), type_22(_e1448[4].member, _e1448[4].member_1, _e1448[4].member_2, _e1448[4].member_3), type_22(_e1448[5].member, _e1448[5].member_1, _e1448[5].member_2, _e1448[5].member_3), type_22(_e1448[6].member, _e1448[6].member_1, _e1448[6].member_2, _e1448[6].member_3), type_22(_e1448[7].member, _e1448[7].member_1, _e1448[7].member_2, _e1448[7].member_3));
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_nearest_printed_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
