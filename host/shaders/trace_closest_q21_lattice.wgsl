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

struct type_22 {
    member: array<type_20>,
}

struct type_24 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_28 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_33 {
    member: type_20,
    member_1: f32,
}

struct type_36 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_38 {
    member: array<type_24>,
}

struct type_41 {
    member: array<vec4<u32>, 2>,
}

struct type_45 {
    member: array<array<u32, 7>>,
}

struct type_50 {
    member: type_28,
    member_1: u32,
}

struct type_51 {
    member: array<vec4<f32>, 3>,
    member_1: type_50,
    member_2: type_50,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_41;
@group(0) @binding(4) 
var<storage> global_3: type_38;
@group(0) @binding(2) 
var<storage> global_4: type_45;
@group(0) @binding(3) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage, read_write> global_6: type_22;

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
    var phi_504_: i32;
    var phi_505_: i32;
    var phi_515_: bool;
    var phi_525_: u32;
    var phi_526_: u32;
    var phi_528_: bool;
    var phi_533_: u32;
    var phi_546_: i32;
    var phi_566_: i32;
    var phi_584_: f32;
    var phi_590_: f32;
    var phi_630_: f32;
    var phi_636_: f32;
    var phi_709_: f32;
    var phi_715_: f32;
    var phi_755_: f32;
    var phi_761_: f32;
    var phi_834_: f32;
    var phi_840_: f32;
    var phi_880_: f32;
    var phi_886_: f32;
    var phi_1005_: i32;
    var phi_1027_: u32;
    var phi_1028_: u32;
    var phi_1065_: i32;
    var phi_1087_: u32;
    var phi_1088_: u32;
    var phi_1096_: f32;
    var phi_1097_: f32;
    var phi_4745_: bool;
    var phi_1193_: type_33;
    var phi_1196_: u32;
    var phi_1198_: bool;
    var phi_1200_: u32;
    var phi_1202_: type_50;
    var phi_1213_: bool;
    var phi_1299_: bool;
    var phi_1300_: u32;
    var phi_1301_: type_50;
    var phi_1320_: type_33;
    var phi_1323_: type_8;
    var phi_1324_: type_8;
    var phi_1346_: type_8;
    var phi_1387_: u32;
    var phi_1393_: u32;
    var phi_1403_: u32;
    var phi_1419_: u32;
    var phi_1452_: u32;
    var phi_1458_: u32;
    var phi_1924_: u32;
    var phi_1942_: u32;
    var phi_1960_: u32;
    var phi_1983_: u32;
    var phi_2001_: u32;
    var phi_2019_: u32;
    var phi_2042_: u32;
    var phi_2060_: u32;
    var phi_2078_: u32;
    var phi_1632_: u32;
    var phi_1647_: u32;
    var phi_1657_: u32;
    var phi_1678_: u32;
    var phi_1699_: u32;
    var phi_1729_: u32;
    var phi_1744_: u32;
    var phi_1754_: u32;
    var phi_1775_: u32;
    var phi_1796_: u32;
    var phi_1826_: u32;
    var phi_1841_: u32;
    var phi_1851_: u32;
    var phi_1872_: u32;
    var phi_1893_: u32;
    var phi_1485_: u32;
    var phi_1534_: u32;
    var phi_1583_: u32;
    var phi_2084_: array<array<f32, 3>, 3>;
    var phi_4306_: bool;
    var phi_4321_: bool;
    var phi_4336_: bool;
    var phi_4351_: bool;
    var phi_4366_: bool;
    var phi_4381_: bool;
    var phi_2626_: f32;
    var phi_2627_: f32;
    var phi_2628_: f32;
    var phi_2629_: f32;
    var phi_2630_: vec3<f32>;
    var phi_2631_: vec3<f32>;
    var phi_2632_: vec3<f32>;
    var phi_2633_: vec3<f32>;
    var phi_4396_: bool;
    var phi_4411_: bool;
    var phi_4426_: bool;
    var phi_4441_: bool;
    var phi_4456_: bool;
    var phi_4471_: bool;
    var phi_2841_: f32;
    var phi_2861_: type_36;
    var phi_2862_: type_36;
    var phi_2865_: type_36;
    var phi_2866_: type_36;
    var phi_2867_: bool;
    var phi_2871_: type_36;
    var phi_2880_: type_20;
    var phi_2905_: bool;
    var phi_2906_: bool;
    var phi_2912_: type_33;
    var phi_2913_: type_33;
    var phi_2914_: type_33;
    var phi_1321_: type_33;
    var phi_4739_: bool;
    var phi_5042_: bool;
    var phi_2915_: type_33;
    var phi_3417_: u32;
    var phi_3423_: u32;
    var phi_3677_: u32;
    var phi_3678_: u32;
    var phi_3688_: u32;
    var phi_3690_: u32;
    var phi_3691_: bool;
    var phi_3711_: u32;
    var phi_3712_: u32;
    var phi_3716_: type_51;
    var phi_4078_: type_50;
    var phi_4154_: type_50;
    var phi_4155_: u32;
    var phi_4156_: type_50;
    var phi_4158_: u32;
    var phi_4159_: type_50;
    var phi_4160_: bool;
    var phi_4169_: type_50;
    var phi_4174_: bool;
    var phi_4176_: type_50;
    var phi_4180_: bool;
    var phi_4181_: u32;
    var phi_4182_: type_50;
    var phi_4192_: type_50;
    var phi_4954_: bool;
    var phi_4193_: type_33;
    var phi_4194_: u32;
    var phi_4195_: bool;
    var phi_4196_: u32;
    var phi_4197_: type_50;
    var phi_4953_: bool;
    var phi_4198_: type_33;
    var phi_4199_: u32;
    var phi_4200_: bool;
    var phi_4201_: u32;
    var phi_4202_: type_50;
    var phi_4952_: bool;
    var phi_1194_: type_33;
    var phi_1197_: u32;
    var phi_1199_: bool;
    var phi_1201_: u32;
    var phi_1203_: type_50;
    var phi_4203_: bool;
    var phi_4951_: bool;
    var local_10: type_33;
    var phi_4241_: f32;
    var phi_4243_: f32;
    var phi_4244_: bool;
    var phi_4245_: f32;
    var phi_4246_: bool;
    var phi_4647_: u32;
    var phi_4665_: bool;
    var phi_4668_: bool;
    var phi_4681_: f32;
    var phi_4682_: f32;
    var phi_4687_: f32;
    var phi_4688_: f32;
    var phi_4689_: bool;
    var phi_4697_: f32;
    var phi_4261_: f32;
    var phi_4262_: f32;
    var phi_4274_: f32;
    var phi_4279_: type_20;
    var local_11: type_33;

    switch bitcast<i32>(0u) {
        default: {
            let _e94 = global;
            let _e96 = arrayLength((&global_4.member));
            let _e99 = arrayLength((&global_5.member));
            let _e107 = global_2.member[0u][0u];
            let _e111 = global_2.member[0u][1u];
            let _e115 = global_2.member[0u][2u];
            let _e119 = global_2.member[0u][3u];
            let _e123 = global_2.member[1u][0u];
            let _e127 = global_2.member[1u][1u];
            let _e131 = global_2.member[1u][2u];
            let _e134 = global_1.member[0u];
            let _e135 = bitcast<i32>(_e134);
            let _e147 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e119) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e107), bitcast<i32>(_e111), bitcast<i32>(_e115));
            local = array<i32, 3>(bitcast<i32>(_e123), bitcast<i32>(_e127), bitcast<i32>(_e131));
            let _e153 = (_e94.x + (_e94.y * 2097152u));
            let _e154 = (_e153 < arrayLength((&global_3.member)));
            if _e154 {
                let _e155 = (_e153 < arrayLength((&global_6.member)));
                if _e155 {
                    if _e154 {
                    } else {
                        break;
                    }
                    let _e163 = global_3.member[_e153].member_2[0u];
                    let _e165 = (bitcast<u32>(_e163) & 2147483647u);
                    let _e170 = global_3.member[_e153].member_2[1u];
                    let _e172 = (bitcast<u32>(_e170) & 2147483647u);
                    let _e177 = global_3.member[_e153].member_2[2u];
                    let _e179 = (bitcast<u32>(_e177) & 2147483647u);
                    let _e184 = global_3.member[_e153].member[0u];
                    let _e186 = (bitcast<u32>(_e184) & 2147483647u);
                    let _e191 = global_3.member[_e153].member[1u];
                    let _e193 = (bitcast<u32>(_e191) & 2147483647u);
                    let _e198 = global_3.member[_e153].member[2u];
                    let _e200 = (bitcast<u32>(_e198) & 2147483647u);
                    let _e202 = select(_e172, _e165, (_e172 < _e165));
                    let _e204 = select(_e179, _e202, (_e179 < _e202));
                    let _e206 = select(_e186, _e204, (_e186 < _e204));
                    let _e208 = select(_e193, _e206, (_e193 < _e206));
                    let _e210 = select(_e200, _e208, (_e200 < _e208));
                    let _e214 = global_3.member[_e153].member_1;
                    let _e215 = bitcast<u32>(_e214);
                    let _e216 = (_e215 & 2147483647u);
                    let _e223 = global_3.member[_e153].member_3;
                    let _e224 = bitcast<u32>(_e223);
                    let _e225 = (_e224 & 2147483647u);
                    let _e229 = (((select(_e216, _e210, (_e216 < _e210)) < 2139095040u) && (_e225 <= 2139095040u)) && (_e204 > 0u));
                    if _e229 {
                        let _e232 = (bitcast<u32>(bitcast<f32>(_e204)) & 2147483647u);
                        if (_e232 >= 8388608u) {
                            phi_504_ = (bitcast<i32>((_e232 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_504_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e232)), 32u, (_e232 == 0u))));
                        }
                        let _e246 = phi_504_;
                        phi_505_ = _e246;
                    } else {
                        phi_505_ = 0i;
                    }
                    let _e248 = phi_505_;
                    let _e249 = (_e165 == _e204);
                    if _e249 {
                        phi_515_ = true;
                    } else {
                        phi_515_ = (_e172 == _e204);
                    }
                    let _e252 = phi_515_;
                    let _e253 = select(1u, 0u, _e249);
                    if _e252 {
                        let _e254 = (_e253 + 1u);
                        phi_525_ = _e254;
                        phi_526_ = _e254;
                        phi_528_ = select(true, false, (_e254 == 2u));
                    } else {
                        phi_525_ = u32();
                        phi_526_ = 0u;
                        phi_528_ = true;
                    }
                    let _e258 = phi_525_;
                    let _e260 = phi_526_;
                    let _e262 = phi_528_;
                    if _e262 {
                        phi_533_ = (_e260 + 1u);
                    } else {
                        phi_533_ = 0u;
                    }
                    let _e266 = phi_533_;
                    let _e267 = select(_e258, _e260, _e262);
                    let _e268 = select(_e253, select(2u, _e253, _e252), _e262);
                    if (_e135 < -126i) {
                        phi_546_ = -126i;
                    } else {
                        phi_546_ = select(_e135, 127i, (_e135 > 127i));
                    }
                    let _e273 = phi_546_;
                    let _e278 = bitcast<f32>((bitcast<u32>((_e273 + 127i)) << bitcast<u32>(23i)));
                    let _e284 = bitcast<f32>((bitcast<u32>(((_e135 - _e273) + 127i)) << bitcast<u32>(23i)));
                    let _e285 = -(_e248);
                    if (_e285 < -126i) {
                        phi_566_ = -126i;
                    } else {
                        phi_566_ = select(_e285, 127i, (_e285 > 127i));
                    }
                    let _e290 = phi_566_;
                    let _e295 = bitcast<f32>((bitcast<u32>((_e290 + 127i)) << bitcast<u32>(23i)));
                    let _e301 = bitcast<f32>((bitcast<u32>(((_e285 - _e290) + 127i)) << bitcast<u32>(23i)));
                    let _e305 = global_3.member[_e153].member;
                    let _e306 = (_e267 == 0u);
                    if _e306 {
                        phi_584_ = _e305[0];
                    } else {
                        phi_584_ = _e305[1];
                    }
                    let _e310 = phi_584_;
                    let _e311 = (_e267 == 2u);
                    if _e311 {
                        phi_590_ = _e305[2];
                    } else {
                        phi_590_ = _e310;
                    }
                    let _e314 = phi_590_;
                    let _e315 = bitcast<u32>(_e314);
                    let _e317 = ((_e315 & 2139095040u) != 0u);
                    let _e331 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e315 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e315 & 2147483648u))), _e314, _e317) * _e278) * select(0.00000011920929f, 1f, _e317)) * _e284);
                    let _e332 = global_3.member[_e153].member_2;
                    if _e306 {
                        phi_630_ = _e332[0];
                    } else {
                        phi_630_ = _e332[1];
                    }
                    let _e336 = phi_630_;
                    if _e311 {
                        phi_636_ = _e332[2];
                    } else {
                        phi_636_ = _e336;
                    }
                    let _e339 = phi_636_;
                    let _e340 = bitcast<u32>(_e339);
                    let _e342 = ((_e340 & 2139095040u) != 0u);
                    let _e356 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e340 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e340 & 2147483648u))), _e339, _e342) * _e295) * select(0.00000011920929f, 1f, _e342)) * _e301);
                    let _e360 = (bitcast<f32>((bitcast<u32>(_e356) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e363 = bitcast<f32>((bitcast<u32>(_e331) & 2147483647u));
                    let _e364 = (_e363 * 0.00000011920929f);
                    let _e367 = select(select(0.00000000000011368684f, _e364, (_e364 > 0.00000000000011368684f)), 0f, _e360);
                    let _e368 = select(0f, _e356, _e360);
                    let _e369 = (_e331 + _e367);
                    let _e370 = (_e331 - _e367);
                    let _e372 = select(38685626000000000000000000f, (1f / _e356), _e360);
                    let _e373 = (_e266 == 0u);
                    if _e373 {
                        phi_709_ = _e305[0];
                    } else {
                        phi_709_ = _e305[1];
                    }
                    let _e377 = phi_709_;
                    let _e378 = (_e266 == 2u);
                    if _e378 {
                        phi_715_ = _e305[2];
                    } else {
                        phi_715_ = _e377;
                    }
                    let _e381 = phi_715_;
                    let _e382 = bitcast<u32>(_e381);
                    let _e384 = ((_e382 & 2139095040u) != 0u);
                    let _e398 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e382 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e382 & 2147483648u))), _e381, _e384) * _e278) * select(0.00000011920929f, 1f, _e384)) * _e284);
                    if _e373 {
                        phi_755_ = _e332[0];
                    } else {
                        phi_755_ = _e332[1];
                    }
                    let _e402 = phi_755_;
                    if _e378 {
                        phi_761_ = _e332[2];
                    } else {
                        phi_761_ = _e402;
                    }
                    let _e405 = phi_761_;
                    let _e406 = bitcast<u32>(_e405);
                    let _e408 = ((_e406 & 2139095040u) != 0u);
                    let _e422 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e406 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e406 & 2147483648u))), _e405, _e408) * _e295) * select(0.00000011920929f, 1f, _e408)) * _e301);
                    let _e426 = (bitcast<f32>((bitcast<u32>(_e422) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e429 = bitcast<f32>((bitcast<u32>(_e398) & 2147483647u));
                    let _e430 = (_e429 * 0.00000011920929f);
                    let _e433 = select(select(0.00000000000011368684f, _e430, (_e430 > 0.00000000000011368684f)), 0f, _e426);
                    let _e434 = select(0f, _e422, _e426);
                    let _e435 = (_e398 + _e433);
                    let _e436 = (_e398 - _e433);
                    let _e438 = select(38685626000000000000000000f, (1f / _e422), _e426);
                    let _e439 = (_e268 == 0u);
                    if _e439 {
                        phi_834_ = _e305[0];
                    } else {
                        phi_834_ = _e305[1];
                    }
                    let _e443 = phi_834_;
                    let _e444 = (_e268 == 2u);
                    if _e444 {
                        phi_840_ = _e305[2];
                    } else {
                        phi_840_ = _e443;
                    }
                    let _e447 = phi_840_;
                    let _e448 = bitcast<u32>(_e447);
                    let _e450 = ((_e448 & 2139095040u) != 0u);
                    let _e464 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e448 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e448 & 2147483648u))), _e447, _e450) * _e278) * select(0.00000011920929f, 1f, _e450)) * _e284);
                    if _e439 {
                        phi_880_ = _e332[0];
                    } else {
                        phi_880_ = _e332[1];
                    }
                    let _e468 = phi_880_;
                    if _e444 {
                        phi_886_ = _e332[2];
                    } else {
                        phi_886_ = _e468;
                    }
                    let _e471 = phi_886_;
                    let _e472 = bitcast<u32>(_e471);
                    let _e474 = ((_e472 & 2139095040u) != 0u);
                    let _e488 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e472 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e472 & 2147483648u))), _e471, _e474) * _e295) * select(0.00000011920929f, 1f, _e474)) * _e301);
                    let _e492 = (bitcast<f32>((bitcast<u32>(_e488) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e495 = bitcast<f32>((bitcast<u32>(_e464) & 2147483647u));
                    let _e496 = (_e495 * 0.00000011920929f);
                    let _e499 = select(select(0.00000000000011368684f, _e496, (_e496 > 0.00000000000011368684f)), 0f, _e492);
                    let _e500 = select(0f, _e488, _e492);
                    let _e501 = (_e464 + _e499);
                    let _e502 = (_e464 - _e499);
                    let _e504 = select(38685626000000000000000000f, (1f / _e488), _e492);
                    let _e506 = select(_e429, _e363, (_e363 > _e429));
                    let _e509 = (_e135 + _e248);
                    if (_e229 && (select(_e495, _e506, (_e506 > _e495)) <= 1099511600000f)) {
                        let _e519 = ((_e216 & 8388607u) | (select(0u, 1u, ((_e216 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e522 = bitcast<i32>((_e216 >> bitcast<u32>(23i)));
                        let _e526 = (_e519 == 0u);
                        let _e529 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e519)), 32u, _e526)) - 8i);
                        if (_e522 == 255i) {
                            phi_1005_ = 255i;
                        } else {
                            phi_1005_ = (((_e522 + select(0i, 1i, (_e522 == 0i))) - _e529) + _e509);
                        }
                        let _e537 = phi_1005_;
                        let _e547 = (_e537 <= 0i);
                        if _e547 {
                            phi_1028_ = u32();
                        } else {
                            if _e526 {
                                phi_1027_ = u32();
                            } else {
                                phi_1027_ = select(((bitcast<u32>(_e537) << bitcast<u32>(23i)) | ((_e519 << bitcast<u32>(((_e529 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e537 >= 255i));
                            }
                            let _e551 = phi_1027_;
                            phi_1028_ = _e551;
                        }
                        let _e553 = phi_1028_;
                        let _e565 = ((_e225 & 8388607u) | (select(0u, 1u, ((_e225 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e568 = bitcast<i32>((_e225 >> bitcast<u32>(23i)));
                        let _e572 = (_e565 == 0u);
                        let _e575 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e565)), 32u, _e572)) - 8i);
                        if (_e568 == 255i) {
                            phi_1065_ = 255i;
                        } else {
                            phi_1065_ = (((_e568 + select(0i, 1i, (_e568 == 0i))) - _e575) + _e509);
                        }
                        let _e583 = phi_1065_;
                        let _e593 = (_e583 <= 0i);
                        if _e593 {
                            phi_1088_ = u32();
                        } else {
                            if _e572 {
                                phi_1087_ = u32();
                            } else {
                                phi_1087_ = select(((bitcast<u32>(_e583) << bitcast<u32>(23i)) | ((_e565 << bitcast<u32>(((_e575 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e583 >= 255i));
                            }
                            let _e597 = phi_1087_;
                            phi_1088_ = _e597;
                        }
                        let _e599 = phi_1088_;
                        phi_1096_ = bitcast<f32>(((_e224 & 2147483648u) | select(_e599, 0u, select(_e572, true, _e593))));
                        phi_1097_ = bitcast<f32>(((_e215 & 2147483648u) | select(_e553, 0u, select(_e526, true, _e547))));
                    } else {
                        phi_1096_ = 0f;
                        phi_1097_ = 1f;
                    }
                    let _e605 = phi_1096_;
                    let _e607 = phi_1097_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e611 = (_e267 % 3u);
                    let _e612 = (_e611 < 3u);
                    if _e612 {
                    } else {
                        break;
                    }
                    let _e614 = local_1[_e611];
                    let _e617 = (_e266 % 3u);
                    let _e618 = (_e617 < 3u);
                    if _e618 {
                    } else {
                        break;
                    }
                    let _e620 = local_1[_e617];
                    let _e623 = (_e268 % 3u);
                    let _e624 = (_e623 < 3u);
                    if _e624 {
                    } else {
                        break;
                    }
                    let _e626 = local_1[_e623];
                    if _e612 {
                    } else {
                        break;
                    }
                    let _e631 = local[_e611];
                    if _e618 {
                    } else {
                        break;
                    }
                    let _e635 = local[_e617];
                    if _e624 {
                    } else {
                        break;
                    }
                    let _e639 = local[_e623];
                    phi_4745_ = false;
                    phi_1193_ = type_33(type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e605);
                    phi_1196_ = ((3u * _e96) + 1u);
                    phi_1198_ = (_e607 <= _e605);
                    phi_1200_ = 0u;
                    phi_1202_ = type_50(type_28(vec4<f32>((f32(_e614) * _e147), (f32(_e620) * _e147), (f32(_e626) * _e147), 0f), vec4<f32>((f32(_e631) * _e147), (f32(_e635) * _e147), (f32(_e639) * _e147), 0f)), select(0u, 2147483648u, (_e96 == 0u)));
                    loop {
                        let _e649 = phi_4745_;
                        let _e651 = phi_1193_;
                        let _e653 = phi_1196_;
                        let _e655 = phi_1198_;
                        let _e657 = phi_1200_;
                        let _e659 = phi_1202_;
                        local_10 = _e651;
                        if _e655 {
                            phi_1213_ = true;
                        } else {
                            phi_1213_ = (_e657 > 0u);
                        }
                        let _e662 = phi_1213_;
                        if _e662 {
                            let _e663 = (_e653 > 0u);
                            if _e663 {
                                if _e655 {
                                    phi_1299_ = _e655;
                                    phi_1300_ = _e657;
                                    phi_1301_ = _e659;
                                } else {
                                    let _e664 = (_e657 - 1u);
                                    let _e665 = (_e664 % 128u);
                                    let _e666 = (_e665 < 128u);
                                    if _e666 {
                                    } else {
                                        phi_4951_ = true;
                                        break;
                                    }
                                    let _e668 = local_7[_e665];
                                    if _e666 {
                                    } else {
                                        phi_4951_ = true;
                                        break;
                                    }
                                    let _e670 = local_6[_e665];
                                    if _e666 {
                                    } else {
                                        phi_4951_ = true;
                                        break;
                                    }
                                    let _e672 = local_5[_e665];
                                    if _e666 {
                                    } else {
                                        phi_4951_ = true;
                                        break;
                                    }
                                    let _e674 = local_4[_e665];
                                    if _e666 {
                                    } else {
                                        phi_4951_ = true;
                                        break;
                                    }
                                    let _e676 = local_3[_e665];
                                    if _e666 {
                                    } else {
                                        phi_4951_ = true;
                                        break;
                                    }
                                    let _e678 = local_2[_e665];
                                    if _e666 {
                                    } else {
                                        phi_4951_ = true;
                                        break;
                                    }
                                    let _e683 = local_8[_e665];
                                    if _e666 {
                                    } else {
                                        phi_4951_ = true;
                                        break;
                                    }
                                    let _e686 = local_9[_e665];
                                    phi_1299_ = (_e686 <= _e651.member_1);
                                    phi_1300_ = _e664;
                                    phi_1301_ = type_50(type_28(vec4<f32>(_e668, _e670, _e672, 0f), vec4<f32>(_e674, _e676, _e678, 0f)), _e683);
                                }
                                let _e690 = phi_1299_;
                                let _e692 = phi_1300_;
                                let _e694 = phi_1301_;
                                if _e690 {
                                    let _e698 = ((_e694.member_1 & 2147483648u) != 0u);
                                    let _e699 = (_e694.member_1 & 268435455u);
                                    if _e698 {
                                        phi_1320_ = _e651;
                                        phi_1323_ = type_8(0u, ((_e694.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e706 = phi_1320_;
                                            let _e708 = phi_1323_;
                                            local_11 = _e706;
                                            if (_e708.member < _e708.member_1) {
                                                phi_1324_ = type_8((_e708.member + 1u), _e708.member_1);
                                                phi_1346_ = type_8(1u, _e708.member);
                                            } else {
                                                phi_1324_ = _e708;
                                                phi_1346_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e721 = phi_1324_;
                                            let _e723 = phi_1346_;
                                            let _e727 = (bitcast<i32>(_e723.member) != 0i);
                                            if _e727 {
                                                let _e732 = (_e694.member.member_1.x - _e694.member.member.x);
                                                let _e735 = (_e694.member.member_1.y - _e694.member.member.y);
                                                let _e738 = (_e694.member.member_1.z - _e694.member.member.z);
                                                let _e740 = select(_e735, _e732, (_e732 > _e735));
                                                let _e742 = select(_e738, _e740, (_e740 > _e738));
                                                let _e744 = (_e742 < (1024f * _e147));
                                                if _e744 {
                                                    phi_1387_ = 0u;
                                                } else {
                                                    phi_1387_ = select(2u, 1u, (_e742 < (2097152f * _e147)));
                                                }
                                                let _e749 = phi_1387_;
                                                switch bitcast<i32>(_e749) {
                                                    case 0: {
                                                        phi_1393_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1393_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1393_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1393_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e752 = phi_1393_;
                                                switch bitcast<i32>(_e749) {
                                                    case 0: {
                                                        phi_1403_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1403_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1403_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1403_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e759 = phi_1403_;
                                                let _e761 = ((_e699 + (_e723.member_1 * ((3u * _e752) + 1u))) + (3u * _e759));
                                                let _e762 = (_e761 < _e99);
                                                if _e762 {
                                                    if _e762 {
                                                    } else {
                                                        phi_4739_ = true;
                                                        break;
                                                    }
                                                    let _e764 = global_5.member[_e761];
                                                    phi_1419_ = _e764;
                                                } else {
                                                    phi_1419_ = 4294967295u;
                                                }
                                                let _e766 = phi_1419_;
                                                if _e744 {
                                                    phi_1452_ = 0u;
                                                } else {
                                                    phi_1452_ = select(2u, 1u, (_e742 < (2097152f * _e147)));
                                                }
                                                let _e771 = phi_1452_;
                                                switch bitcast<i32>(_e771) {
                                                    case 0: {
                                                        phi_1458_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1458_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1458_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1458_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e774 = phi_1458_;
                                                let _e778 = (_e699 + (_e723.member_1 * ((3u * _e774) + 1u)));
                                                switch bitcast<i32>(_e771) {
                                                    case 0: {
                                                        let _e1053 = (_e778 < _e99);
                                                        if _e1053 {
                                                            if _e1053 {
                                                            } else {
                                                                phi_4739_ = true;
                                                                break;
                                                            }
                                                            let _e1055 = global_5.member[_e778];
                                                            phi_1485_ = _e1055;
                                                        } else {
                                                            phi_1485_ = 0u;
                                                        }
                                                        let _e1057 = phi_1485_;
                                                        let _e1059 = ((10u * _e267) & 31u);
                                                        let _e1069 = ((10u * _e266) & 31u);
                                                        let _e1079 = ((10u * _e268) & 31u);
                                                        let _e1089 = (_e778 + 1u);
                                                        let _e1090 = (_e1089 < _e99);
                                                        if _e1090 {
                                                            if _e1090 {
                                                            } else {
                                                                phi_4739_ = true;
                                                                break;
                                                            }
                                                            let _e1092 = global_5.member[_e1089];
                                                            phi_1534_ = _e1092;
                                                        } else {
                                                            phi_1534_ = 0u;
                                                        }
                                                        let _e1094 = phi_1534_;
                                                        let _e1120 = (_e778 + 2u);
                                                        let _e1121 = (_e1120 < _e99);
                                                        if _e1121 {
                                                            if _e1121 {
                                                            } else {
                                                                phi_4739_ = true;
                                                                break;
                                                            }
                                                            let _e1123 = global_5.member[_e1120];
                                                            phi_1583_ = _e1123;
                                                        } else {
                                                            phi_1583_ = 0u;
                                                        }
                                                        let _e1125 = phi_1583_;
                                                        phi_2084_ = array<array<f32, 3>, 3>(array<f32, 3>((_e694.member.member.x + ((bitcast<f32>((1258291200u | ((_e1057 >> bitcast<u32>(_e1059)) & 1023u))) - 8388608f) * _e147)), (_e694.member.member.y + ((bitcast<f32>((1258291200u | ((_e1057 >> bitcast<u32>(_e1069)) & 1023u))) - 8388608f) * _e147)), (_e694.member.member.z + ((bitcast<f32>((1258291200u | ((_e1057 >> bitcast<u32>(_e1079)) & 1023u))) - 8388608f) * _e147))), array<f32, 3>((_e694.member.member.x + ((bitcast<f32>((1258291200u | ((_e1094 >> bitcast<u32>(_e1059)) & 1023u))) - 8388608f) * _e147)), (_e694.member.member.y + ((bitcast<f32>((1258291200u | ((_e1094 >> bitcast<u32>(_e1069)) & 1023u))) - 8388608f) * _e147)), (_e694.member.member.z + ((bitcast<f32>((1258291200u | ((_e1094 >> bitcast<u32>(_e1079)) & 1023u))) - 8388608f) * _e147))), array<f32, 3>((_e694.member.member.x + ((bitcast<f32>((1258291200u | ((_e1125 >> bitcast<u32>(_e1059)) & 1023u))) - 8388608f) * _e147)), (_e694.member.member.y + ((bitcast<f32>((1258291200u | ((_e1125 >> bitcast<u32>(_e1069)) & 1023u))) - 8388608f) * _e147)), (_e694.member.member.z + ((bitcast<f32>((1258291200u | ((_e1125 >> bitcast<u32>(_e1079)) & 1023u))) - 8388608f) * _e147))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e867 = (_e778 < _e99);
                                                        if _e867 {
                                                            if _e867 {
                                                            } else {
                                                                phi_4739_ = true;
                                                                break;
                                                            }
                                                            let _e869 = global_5.member[_e778];
                                                            phi_1632_ = _e869;
                                                        } else {
                                                            phi_1632_ = 0u;
                                                        }
                                                        let _e871 = phi_1632_;
                                                        let _e872 = (_e778 + 1u);
                                                        let _e873 = (_e872 < _e99);
                                                        if _e873 {
                                                            if _e873 {
                                                            } else {
                                                                phi_4739_ = true;
                                                                break;
                                                            }
                                                            let _e875 = global_5.member[_e872];
                                                            phi_1647_ = _e875;
                                                        } else {
                                                            phi_1647_ = 0u;
                                                        }
                                                        let _e877 = phi_1647_;
                                                        let _e878 = (_e267 == 1u);
                                                        if _e878 {
                                                            phi_1657_ = ((_e871 >> bitcast<u32>(21i)) | (_e877 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1657_ = (_e877 >> bitcast<u32>(10i));
                                                        }
                                                        let _e887 = phi_1657_;
                                                        let _e895 = (_e266 == 1u);
                                                        if _e895 {
                                                            phi_1678_ = ((_e871 >> bitcast<u32>(21i)) | (_e877 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1678_ = (_e877 >> bitcast<u32>(10i));
                                                        }
                                                        let _e904 = phi_1678_;
                                                        let _e912 = (_e268 == 1u);
                                                        if _e912 {
                                                            phi_1699_ = ((_e871 >> bitcast<u32>(21i)) | (_e877 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1699_ = (_e877 >> bitcast<u32>(10i));
                                                        }
                                                        let _e921 = phi_1699_;
                                                        let _e930 = (_e778 + 2u);
                                                        let _e931 = (_e930 < _e99);
                                                        if _e931 {
                                                            if _e931 {
                                                            } else {
                                                                phi_4739_ = true;
                                                                break;
                                                            }
                                                            let _e933 = global_5.member[_e930];
                                                            phi_1729_ = _e933;
                                                        } else {
                                                            phi_1729_ = 0u;
                                                        }
                                                        let _e935 = phi_1729_;
                                                        let _e936 = (_e778 + 3u);
                                                        let _e937 = (_e936 < _e99);
                                                        if _e937 {
                                                            if _e937 {
                                                            } else {
                                                                phi_4739_ = true;
                                                                break;
                                                            }
                                                            let _e939 = global_5.member[_e936];
                                                            phi_1744_ = _e939;
                                                        } else {
                                                            phi_1744_ = 0u;
                                                        }
                                                        let _e941 = phi_1744_;
                                                        if _e878 {
                                                            phi_1754_ = ((_e935 >> bitcast<u32>(21i)) | (_e941 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1754_ = (_e941 >> bitcast<u32>(10i));
                                                        }
                                                        let _e950 = phi_1754_;
                                                        if _e895 {
                                                            phi_1775_ = ((_e935 >> bitcast<u32>(21i)) | (_e941 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1775_ = (_e941 >> bitcast<u32>(10i));
                                                        }
                                                        let _e966 = phi_1775_;
                                                        if _e912 {
                                                            phi_1796_ = ((_e935 >> bitcast<u32>(21i)) | (_e941 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1796_ = (_e941 >> bitcast<u32>(10i));
                                                        }
                                                        let _e982 = phi_1796_;
                                                        let _e991 = (_e778 + 4u);
                                                        let _e992 = (_e991 < _e99);
                                                        if _e992 {
                                                            if _e992 {
                                                            } else {
                                                                phi_4739_ = true;
                                                                break;
                                                            }
                                                            let _e994 = global_5.member[_e991];
                                                            phi_1826_ = _e994;
                                                        } else {
                                                            phi_1826_ = 0u;
                                                        }
                                                        let _e996 = phi_1826_;
                                                        let _e997 = (_e778 + 5u);
                                                        let _e998 = (_e997 < _e99);
                                                        if _e998 {
                                                            if _e998 {
                                                            } else {
                                                                phi_4739_ = true;
                                                                break;
                                                            }
                                                            let _e1000 = global_5.member[_e997];
                                                            phi_1841_ = _e1000;
                                                        } else {
                                                            phi_1841_ = 0u;
                                                        }
                                                        let _e1002 = phi_1841_;
                                                        if _e878 {
                                                            phi_1851_ = ((_e996 >> bitcast<u32>(21i)) | (_e1002 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1851_ = (_e1002 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1011 = phi_1851_;
                                                        if _e895 {
                                                            phi_1872_ = ((_e996 >> bitcast<u32>(21i)) | (_e1002 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1872_ = (_e1002 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1027 = phi_1872_;
                                                        if _e912 {
                                                            phi_1893_ = ((_e996 >> bitcast<u32>(21i)) | (_e1002 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1893_ = (_e1002 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1043 = phi_1893_;
                                                        phi_2084_ = array<array<f32, 3>, 3>(array<f32, 3>((_e694.member.member.x + ((bitcast<f32>((1258291200u | (select(_e887, _e871, _e306) & 2097151u))) - 8388608f) * _e147)), (_e694.member.member.y + ((bitcast<f32>((1258291200u | (select(_e904, _e871, _e373) & 2097151u))) - 8388608f) * _e147)), (_e694.member.member.z + ((bitcast<f32>((1258291200u | (select(_e921, _e871, _e439) & 2097151u))) - 8388608f) * _e147))), array<f32, 3>((_e694.member.member.x + ((bitcast<f32>((1258291200u | (select(_e950, _e935, _e306) & 2097151u))) - 8388608f) * _e147)), (_e694.member.member.y + ((bitcast<f32>((1258291200u | (select(_e966, _e935, _e373) & 2097151u))) - 8388608f) * _e147)), (_e694.member.member.z + ((bitcast<f32>((1258291200u | (select(_e982, _e935, _e439) & 2097151u))) - 8388608f) * _e147))), array<f32, 3>((_e694.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1011, _e996, _e306) & 2097151u))) - 8388608f) * _e147)), (_e694.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1027, _e996, _e373) & 2097151u))) - 8388608f) * _e147)), (_e694.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1043, _e996, _e439) & 2097151u))) - 8388608f) * _e147))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e780 = (_e778 + _e267);
                                                        let _e781 = (_e780 < _e99);
                                                        if _e781 {
                                                            if _e781 {
                                                            } else {
                                                                phi_4739_ = true;
                                                                break;
                                                            }
                                                            let _e783 = global_5.member[_e780];
                                                            phi_1924_ = _e783;
                                                        } else {
                                                            phi_1924_ = 0u;
                                                        }
                                                        let _e785 = phi_1924_;
                                                        let _e789 = (_e778 + _e266);
                                                        let _e790 = (_e789 < _e99);
                                                        if _e790 {
                                                            if _e790 {
                                                            } else {
                                                                phi_4739_ = true;
                                                                break;
                                                            }
                                                            let _e792 = global_5.member[_e789];
                                                            phi_1942_ = _e792;
                                                        } else {
                                                            phi_1942_ = 0u;
                                                        }
                                                        let _e794 = phi_1942_;
                                                        let _e798 = (_e778 + _e268);
                                                        let _e799 = (_e798 < _e99);
                                                        if _e799 {
                                                            if _e799 {
                                                            } else {
                                                                phi_4739_ = true;
                                                                break;
                                                            }
                                                            let _e801 = global_5.member[_e798];
                                                            phi_1960_ = _e801;
                                                        } else {
                                                            phi_1960_ = 0u;
                                                        }
                                                        let _e803 = phi_1960_;
                                                        let _e808 = (_e778 + 3u);
                                                        let _e809 = (_e808 + _e267);
                                                        let _e810 = (_e809 < _e99);
                                                        if _e810 {
                                                            if _e810 {
                                                            } else {
                                                                phi_4739_ = true;
                                                                break;
                                                            }
                                                            let _e812 = global_5.member[_e809];
                                                            phi_1983_ = _e812;
                                                        } else {
                                                            phi_1983_ = 0u;
                                                        }
                                                        let _e814 = phi_1983_;
                                                        let _e818 = (_e808 + _e266);
                                                        let _e819 = (_e818 < _e99);
                                                        if _e819 {
                                                            if _e819 {
                                                            } else {
                                                                phi_4739_ = true;
                                                                break;
                                                            }
                                                            let _e821 = global_5.member[_e818];
                                                            phi_2001_ = _e821;
                                                        } else {
                                                            phi_2001_ = 0u;
                                                        }
                                                        let _e823 = phi_2001_;
                                                        let _e827 = (_e808 + _e268);
                                                        let _e828 = (_e827 < _e99);
                                                        if _e828 {
                                                            if _e828 {
                                                            } else {
                                                                phi_4739_ = true;
                                                                break;
                                                            }
                                                            let _e830 = global_5.member[_e827];
                                                            phi_2019_ = _e830;
                                                        } else {
                                                            phi_2019_ = 0u;
                                                        }
                                                        let _e832 = phi_2019_;
                                                        let _e837 = (_e778 + 6u);
                                                        let _e838 = (_e837 + _e267);
                                                        let _e839 = (_e838 < _e99);
                                                        if _e839 {
                                                            if _e839 {
                                                            } else {
                                                                phi_4739_ = true;
                                                                break;
                                                            }
                                                            let _e841 = global_5.member[_e838];
                                                            phi_2042_ = _e841;
                                                        } else {
                                                            phi_2042_ = 0u;
                                                        }
                                                        let _e843 = phi_2042_;
                                                        let _e847 = (_e837 + _e266);
                                                        let _e848 = (_e847 < _e99);
                                                        if _e848 {
                                                            if _e848 {
                                                            } else {
                                                                phi_4739_ = true;
                                                                break;
                                                            }
                                                            let _e850 = global_5.member[_e847];
                                                            phi_2060_ = _e850;
                                                        } else {
                                                            phi_2060_ = 0u;
                                                        }
                                                        let _e852 = phi_2060_;
                                                        let _e856 = (_e837 + _e268);
                                                        let _e857 = (_e856 < _e99);
                                                        if _e857 {
                                                            if _e857 {
                                                            } else {
                                                                phi_4739_ = true;
                                                                break;
                                                            }
                                                            let _e859 = global_5.member[_e856];
                                                            phi_2078_ = _e859;
                                                        } else {
                                                            phi_2078_ = 0u;
                                                        }
                                                        let _e861 = phi_2078_;
                                                        phi_2084_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e785)) * _e147), (f32(bitcast<i32>(_e794)) * _e147), (f32(bitcast<i32>(_e803)) * _e147)), array<f32, 3>((f32(bitcast<i32>(_e814)) * _e147), (f32(bitcast<i32>(_e823)) * _e147), (f32(bitcast<i32>(_e832)) * _e147)), array<f32, 3>((f32(bitcast<i32>(_e843)) * _e147), (f32(bitcast<i32>(_e852)) * _e147), (f32(bitcast<i32>(_e861)) * _e147)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2084_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1153 = phi_2084_;
                                                let _e1169 = (_e1153[0][2] - _e464);
                                                let _e1172 = (((_e1153[0][0] - _e331) * _e500) - (_e1169 * _e368));
                                                let _e1175 = (((_e1153[0][1] - _e398) * _e500) - (_e1169 * _e434));
                                                let _e1178 = (_e1153[1][2] - _e464);
                                                let _e1181 = (((_e1153[1][0] - _e331) * _e500) - (_e1178 * _e368));
                                                let _e1184 = (((_e1153[1][1] - _e398) * _e500) - (_e1178 * _e434));
                                                let _e1187 = (_e1153[2][2] - _e464);
                                                let _e1190 = (((_e1153[2][0] - _e331) * _e500) - (_e1187 * _e368));
                                                let _e1193 = (((_e1153[2][1] - _e398) * _e500) - (_e1187 * _e434));
                                                let _e1194 = (_e1190 * _e1184);
                                                let _e1195 = (_e1193 * _e1181);
                                                let _e1196 = (_e1172 * _e1193);
                                                let _e1197 = (_e1175 * _e1190);
                                                let _e1198 = (_e1181 * _e1175);
                                                let _e1199 = (_e1184 * _e1172);
                                                let _e1204 = (((_e1194 >= _e1195) && (_e1196 >= _e1197)) && (_e1198 >= _e1199));
                                                let _e1210 = (_e1204 || (((_e1194 <= _e1195) && (_e1196 <= _e1197)) && (_e1198 <= _e1199)));
                                                if _e1210 {
                                                    let _e1212 = select(-1f, 1f, _e1204);
                                                    let _e1214 = ((_e1194 - _e1195) * _e1212);
                                                    let _e1216 = select(0f, _e1214, (_e1214 > 0f));
                                                    let _e1218 = ((_e1196 - _e1197) * _e1212);
                                                    let _e1220 = select(0f, _e1218, (_e1218 > 0f));
                                                    let _e1222 = ((_e1198 - _e1199) * _e1212);
                                                    let _e1224 = select(0f, _e1222, (_e1222 > 0f));
                                                    let _e1226 = ((_e1216 + _e1220) + _e1224);
                                                    let _e1228 = select(_e1153[1][0], _e1153[0][0], (_e1153[0][0] < _e1153[1][0]));
                                                    let _e1232 = select(_e1153[1][0], _e1153[0][0], (_e1153[0][0] > _e1153[1][0]));
                                                    let _e1236 = select(_e1153[1][1], _e1153[0][1], (_e1153[0][1] < _e1153[1][1]));
                                                    let _e1240 = select(_e1153[1][1], _e1153[0][1], (_e1153[0][1] > _e1153[1][1]));
                                                    let _e1244 = select(_e1153[1][2], _e1153[0][2], (_e1153[0][2] < _e1153[1][2]));
                                                    let _e1248 = select(_e1153[1][2], _e1153[0][2], (_e1153[0][2] > _e1153[1][2]));
                                                    let _e1253 = ((select(_e1153[2][0], _e1228, (_e1228 < _e1153[2][0])) - _e369) * _e372);
                                                    let _e1254 = ((select(_e1153[2][0], _e1232, (_e1232 > _e1153[2][0])) - _e370) * _e372);
                                                    let _e1257 = ((select(_e1153[2][1], _e1236, (_e1236 < _e1153[2][1])) - _e435) * _e438);
                                                    let _e1258 = ((select(_e1153[2][1], _e1240, (_e1240 > _e1153[2][1])) - _e436) * _e438);
                                                    let _e1261 = ((select(_e1153[2][2], _e1244, (_e1244 < _e1153[2][2])) - _e501) * _e504);
                                                    let _e1262 = ((select(_e1153[2][2], _e1248, (_e1248 > _e1153[2][2])) - _e502) * _e504);
                                                    let _e1264 = select(_e1262, _e1261, (_e1261 < _e1262));
                                                    let _e1266 = select(_e1262, _e1261, (_e1261 > _e1262));
                                                    let _e1268 = select(_e1254, _e1253, (_e1253 < _e1254));
                                                    let _e1270 = select(_e1258, _e1257, (_e1257 < _e1258));
                                                    let _e1272 = select(_e1270, _e1268, (_e1268 > _e1270));
                                                    let _e1274 = select(_e1264, _e1272, (_e1272 > _e1264));
                                                    let _e1276 = select(_e1254, _e1253, (_e1253 > _e1254));
                                                    let _e1278 = select(_e1258, _e1257, (_e1257 > _e1258));
                                                    let _e1280 = select(_e1278, _e1276, (_e1276 < _e1278));
                                                    let _e1282 = select(_e1266, _e1280, (_e1280 < _e1266));
                                                    let _e1283 = -(_e1264);
                                                    let _e1289 = select(_e607, _e1274, (_e1274 > _e607));
                                                    let _e1293 = select(_e1181, _e1172, (_e1172 < _e1181));
                                                    let _e1298 = select(_e1181, _e1172, (_e1172 > _e1181));
                                                    let _e1305 = select(_e1184, _e1175, (_e1175 < _e1184));
                                                    let _e1310 = select(_e1184, _e1175, (_e1175 > _e1184));
                                                    let _e1319 = (((((_e1210 && (_e1226 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1190, _e1293, (_e1293 < _e1190)) <= 0f) && (select(_e1190, _e1298, (_e1298 > _e1190)) >= 0f))) && ((select(_e1193, _e1305, (_e1305 < _e1193)) <= 0f) && (select(_e1193, _e1310, (_e1310 > _e1193)) >= 0f))) && (_e1289 <= (_e1282 + (select(_e1283, _e1266, (_e1266 > _e1283)) * 0.0000019073523f)))) && (_e1289 <= _e706.member_1));
                                                    if _e1319 {
                                                        let _e1324 = (_e1153[1][0] - _e1153[0][0]);
                                                        let _e1325 = (_e1153[1][1] - _e1153[0][1]);
                                                        let _e1326 = (_e1153[1][2] - _e1153[0][2]);
                                                        let _e1327 = vec3<f32>(_e1324, _e1325, _e1326);
                                                        let _e1328 = (_e1153[2][0] - _e1153[1][0]);
                                                        let _e1329 = (_e1153[2][1] - _e1153[1][1]);
                                                        let _e1330 = (_e1153[2][2] - _e1153[1][2]);
                                                        let _e1331 = vec3<f32>(_e1328, _e1329, _e1330);
                                                        let _e1332 = (_e1153[0][0] - _e1153[2][0]);
                                                        let _e1333 = (_e1153[0][1] - _e1153[2][1]);
                                                        let _e1334 = (_e1153[0][2] - _e1153[2][2]);
                                                        let _e1335 = vec3<f32>(_e1332, _e1333, _e1334);
                                                        let _e1336 = abs(_e1324);
                                                        let _e1337 = abs(_e1325);
                                                        if (_e1336 != _e1336) {
                                                            phi_4306_ = true;
                                                        } else {
                                                            phi_4306_ = (_e1337 >= _e1336);
                                                        }
                                                        let _e1341 = phi_4306_;
                                                        let _e1342 = select(_e1336, _e1337, _e1341);
                                                        let _e1343 = abs(_e1326);
                                                        if (_e1342 != _e1342) {
                                                            phi_4321_ = true;
                                                        } else {
                                                            phi_4321_ = (_e1343 >= _e1342);
                                                        }
                                                        let _e1347 = phi_4321_;
                                                        let _e1348 = select(_e1342, _e1343, _e1347);
                                                        let _e1349 = abs(_e1328);
                                                        let _e1350 = abs(_e1329);
                                                        if (_e1349 != _e1349) {
                                                            phi_4336_ = true;
                                                        } else {
                                                            phi_4336_ = (_e1350 >= _e1349);
                                                        }
                                                        let _e1354 = phi_4336_;
                                                        let _e1355 = select(_e1349, _e1350, _e1354);
                                                        let _e1356 = abs(_e1330);
                                                        if (_e1355 != _e1355) {
                                                            phi_4351_ = true;
                                                        } else {
                                                            phi_4351_ = (_e1356 >= _e1355);
                                                        }
                                                        let _e1360 = phi_4351_;
                                                        let _e1361 = select(_e1355, _e1356, _e1360);
                                                        let _e1362 = abs(_e1332);
                                                        let _e1363 = abs(_e1333);
                                                        if (_e1362 != _e1362) {
                                                            phi_4366_ = true;
                                                        } else {
                                                            phi_4366_ = (_e1363 >= _e1362);
                                                        }
                                                        let _e1367 = phi_4366_;
                                                        let _e1368 = select(_e1362, _e1363, _e1367);
                                                        let _e1369 = abs(_e1334);
                                                        if (_e1368 != _e1368) {
                                                            phi_4381_ = true;
                                                        } else {
                                                            phi_4381_ = (_e1369 >= _e1368);
                                                        }
                                                        let _e1373 = phi_4381_;
                                                        let _e1374 = select(_e1368, _e1369, _e1373);
                                                        let _e1376 = select(_e1361, _e1348, (_e1348 > _e1361));
                                                        let _e1378 = select(_e1374, _e1376, (_e1376 > _e1374));
                                                        if (_e1348 == _e1378) {
                                                            phi_2626_ = _e1184;
                                                            phi_2627_ = _e1181;
                                                            phi_2628_ = _e1175;
                                                            phi_2629_ = _e1172;
                                                            phi_2630_ = vec3<f32>(_e1153[0][0], _e1153[0][1], _e1153[0][2]);
                                                            phi_2631_ = _e1335;
                                                            phi_2632_ = _e1331;
                                                            phi_2633_ = _e1327;
                                                        } else {
                                                            let _e1380 = (_e1361 == _e1378);
                                                            let _e1385 = vec3(_e1380);
                                                            phi_2626_ = select(_e1175, _e1193, _e1380);
                                                            phi_2627_ = select(_e1172, _e1190, _e1380);
                                                            phi_2628_ = select(_e1193, _e1184, _e1380);
                                                            phi_2629_ = select(_e1190, _e1181, _e1380);
                                                            phi_2630_ = select(vec3<f32>(_e1153[2][0], _e1153[2][1], _e1153[2][2]), vec3<f32>(_e1153[1][0], _e1153[1][1], _e1153[1][2]), _e1385);
                                                            phi_2631_ = select(_e1331, _e1327, _e1385);
                                                            phi_2632_ = select(_e1327, _e1335, _e1385);
                                                            phi_2633_ = select(_e1335, _e1331, _e1385);
                                                        }
                                                        let _e1391 = phi_2626_;
                                                        let _e1393 = phi_2627_;
                                                        let _e1395 = phi_2628_;
                                                        let _e1397 = phi_2629_;
                                                        let _e1399 = phi_2630_;
                                                        let _e1401 = phi_2631_;
                                                        let _e1403 = phi_2632_;
                                                        let _e1405 = phi_2633_;
                                                        let _e1412 = ((_e1403.y * _e1401.z) - (_e1401.y * _e1403.z));
                                                        let _e1417 = ((_e1403.z * _e1401.x) - (_e1401.z * _e1403.x));
                                                        let _e1420 = ((_e1403.x * _e1401.y) - (_e1401.x * _e1403.y));
                                                        let _e1423 = ((_e1216 >= _e1220) && (_e1216 >= _e1224));
                                                        let _e1424 = (_e1220 >= _e1224);
                                                        let _e1438 = (((_e1412 * (select(select(_e1153[2][0], _e1153[1][0], _e1424), _e1153[0][0], _e1423) - _e331)) + (_e1417 * (select(select(_e1153[2][1], _e1153[1][1], _e1424), _e1153[0][1], _e1423) - _e398))) + (_e1420 * (select(select(_e1153[2][2], _e1153[1][2], _e1424), _e1153[0][2], _e1423) - _e464)));
                                                        let _e1443 = (((_e1412 * _e368) + (_e1417 * _e434)) + (_e1420 * _e500));
                                                        let _e1444 = (_e1393 - _e1397);
                                                        let _e1445 = (_e1391 - _e1395);
                                                        let _e1448 = ((_e1444 * _e1444) + (_e1445 * _e1445));
                                                        let _e1455 = (-(((_e1397 * _e1444) + (_e1395 * _e1445))) / select(0.000000000000000000000000000000000000011754944f, _e1448, (_e1448 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1457 = select(1f, _e1455, (_e1455 < 1f));
                                                        let _e1459 = select(0f, _e1457, (_e1457 > 0f));
                                                        let _e1468 = ((_e1399.x + (_e1405.x * _e1459)) - _e331);
                                                        let _e1471 = ((_e1399.y + (_e1405.y * _e1459)) - _e398);
                                                        let _e1474 = ((_e1399.z + (_e1405.z * _e1459)) - _e464);
                                                        let _e1477 = bitcast<f32>((bitcast<u32>(_e1468) & 2147483647u));
                                                        let _e1480 = bitcast<f32>((bitcast<u32>(_e1471) & 2147483647u));
                                                        let _e1482 = select(_e1480, _e1477, (_e1477 > _e1480));
                                                        let _e1485 = bitcast<f32>((bitcast<u32>(_e1474) & 2147483647u));
                                                        let _e1487 = select(_e1485, _e1482, (_e1482 > _e1485));
                                                        let _e1491 = abs(_e1412);
                                                        let _e1492 = abs(_e1417);
                                                        if (_e1491 != _e1491) {
                                                            phi_4396_ = true;
                                                        } else {
                                                            phi_4396_ = (_e1492 >= _e1491);
                                                        }
                                                        let _e1496 = phi_4396_;
                                                        let _e1497 = select(_e1491, _e1492, _e1496);
                                                        let _e1498 = abs(_e1420);
                                                        if (_e1497 != _e1497) {
                                                            phi_4411_ = true;
                                                        } else {
                                                            phi_4411_ = (_e1498 >= _e1497);
                                                        }
                                                        let _e1502 = phi_4411_;
                                                        let _e1518 = abs(_e1403.x);
                                                        let _e1519 = abs(_e1403.y);
                                                        if (_e1518 != _e1518) {
                                                            phi_4426_ = true;
                                                        } else {
                                                            phi_4426_ = (_e1519 >= _e1518);
                                                        }
                                                        let _e1523 = phi_4426_;
                                                        let _e1524 = select(_e1518, _e1519, _e1523);
                                                        let _e1525 = abs(_e1403.z);
                                                        if (_e1524 != _e1524) {
                                                            phi_4441_ = true;
                                                        } else {
                                                            phi_4441_ = (_e1525 >= _e1524);
                                                        }
                                                        let _e1529 = phi_4441_;
                                                        let _e1532 = abs(_e1401.x);
                                                        let _e1533 = abs(_e1401.y);
                                                        if (_e1532 != _e1532) {
                                                            phi_4456_ = true;
                                                        } else {
                                                            phi_4456_ = (_e1533 >= _e1532);
                                                        }
                                                        let _e1537 = phi_4456_;
                                                        let _e1538 = select(_e1532, _e1533, _e1537);
                                                        let _e1539 = abs(_e1401.z);
                                                        if (_e1538 != _e1538) {
                                                            phi_4471_ = true;
                                                        } else {
                                                            phi_4471_ = (_e1539 >= _e1538);
                                                        }
                                                        let _e1543 = phi_4471_;
                                                        let _e1548 = ((bitcast<f32>((bitcast<u32>(((((_e1412 * _e1468) + (_e1417 * _e1471)) + (_e1420 * _e1474)) - _e1438)) & 2147483647u)) <= ((0.0000009536743f * select(_e1378, _e1487, (_e1487 > _e1378))) * select(_e1497, _e1498, _e1502))) && !((bitcast<f32>((bitcast<u32>(_e1443) & 2147483647u)) <= ((0.0000038146973f * select(_e1524, _e1525, _e1529)) * select(_e1538, _e1539, _e1543)))));
                                                        let _e1549 = (_e1438 / _e1443);
                                                        if (_e1319 && !(_e1548)) {
                                                            let _e1552 = (_e1474 / _e500);
                                                            let _e1560 = (((_e1412 * (_e1468 - (_e368 * _e1552))) + (_e1417 * (_e1471 - (_e434 * _e1552)))) / _e1443);
                                                            phi_2841_ = select(select(_e1552, (_e1552 + _e1560), (bitcast<f32>((bitcast<u32>(_e1560) & 2147483647u)) <= _e1378)), _e1549, _e1548);
                                                        } else {
                                                            phi_2841_ = _e1549;
                                                        }
                                                        let _e1569 = phi_2841_;
                                                        let _e1571 = select(_e1282, _e1569, (_e1569 < _e1282));
                                                        let _e1573 = select(_e1274, _e1571, (_e1571 > _e1274));
                                                        let _e1574 = (1f / _e1226);
                                                        phi_2861_ = type_36(_e1573, (_e1220 * _e1574), (_e1224 * _e1574), ((_e1319 && (_e1573 >= _e607)) && (_e1573 <= _e706.member_1)));
                                                        phi_2862_ = type_36();
                                                    } else {
                                                        phi_2861_ = type_36();
                                                        phi_2862_ = type_36(0f, 0f, 0f, _e1319);
                                                    }
                                                    let _e1583 = phi_2861_;
                                                    let _e1585 = phi_2862_;
                                                    phi_2865_ = _e1583;
                                                    phi_2866_ = _e1585;
                                                    phi_2867_ = select(true, false, _e1319);
                                                } else {
                                                    phi_2865_ = type_36();
                                                    phi_2866_ = type_36(0f, 0f, 0f, _e1210);
                                                    phi_2867_ = true;
                                                }
                                                let _e1588 = phi_2865_;
                                                let _e1590 = phi_2866_;
                                                let _e1592 = phi_2867_;
                                                if _e1592 {
                                                    phi_2871_ = _e1590;
                                                } else {
                                                    phi_2871_ = _e1588;
                                                }
                                                let _e1594 = phi_2871_;
                                                if _e1594.member_3 {
                                                    phi_2880_ = type_20(_e1594.member, _e1594.member_1, _e1594.member_2, _e766);
                                                } else {
                                                    phi_2880_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1601 = phi_2880_;
                                                if (_e1601.member_3 != 4294967295u) {
                                                    if (_e766 != 4294967295u) {
                                                        if (_e1601.member < _e706.member.member) {
                                                            phi_2906_ = true;
                                                        } else {
                                                            if (_e1601.member == _e706.member.member) {
                                                                phi_2905_ = (_e1601.member_3 < _e706.member.member_3);
                                                            } else {
                                                                phi_2905_ = false;
                                                            }
                                                            let _e1614 = phi_2905_;
                                                            phi_2906_ = _e1614;
                                                        }
                                                        let _e1616 = phi_2906_;
                                                        if _e1616 {
                                                            phi_2912_ = type_33(_e1601, _e1601.member);
                                                        } else {
                                                            phi_2912_ = _e706;
                                                        }
                                                        let _e1619 = phi_2912_;
                                                        phi_2913_ = _e1619;
                                                    } else {
                                                        phi_2913_ = _e706;
                                                    }
                                                    let _e1621 = phi_2913_;
                                                    phi_2914_ = _e1621;
                                                } else {
                                                    phi_2914_ = _e706;
                                                }
                                                let _e1623 = phi_2914_;
                                                phi_1321_ = _e1623;
                                            } else {
                                                phi_1321_ = type_33();
                                            }
                                            let _e1625 = phi_1321_;
                                            continue;
                                            continuing {
                                                phi_1320_ = _e1625;
                                                phi_1323_ = _e721;
                                                phi_4739_ = _e649;
                                                break if !(_e727);
                                            }
                                        }
                                        let _e1628 = phi_4739_;
                                        phi_4951_ = _e1628;
                                        if _e1628 {
                                            break;
                                        }
                                        phi_5042_ = _e1628;
                                        let _e2402 = local_11;
                                        phi_2915_ = _e2402;
                                    } else {
                                        phi_5042_ = _e649;
                                        phi_2915_ = _e651;
                                    }
                                    let _e1630 = phi_5042_;
                                    let _e1632 = phi_2915_;
                                    if _e698 {
                                        phi_4180_ = bool();
                                        phi_4181_ = u32();
                                        phi_4182_ = type_50();
                                    } else {
                                        if (_e694.member_1 >= _e96) {
                                            phi_3716_ = type_51(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_50(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_50(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e694.member_1 < _e96) {
                                            } else {
                                                phi_4951_ = true;
                                                break;
                                            }
                                            let _e1635 = (_e267 * 2u);
                                            let _e1637 = ((1u + _e1635) % 7u);
                                            if (_e1637 < 7u) {
                                            } else {
                                                phi_4951_ = true;
                                                break;
                                            }
                                            let _e1642 = global_4.member[_e694.member_1][_e1637];
                                            let _e1644 = ((_e1635 + 2u) % 7u);
                                            if (_e1644 < 7u) {
                                            } else {
                                                phi_4951_ = true;
                                                break;
                                            }
                                            let _e1649 = global_4.member[_e694.member_1][_e1644];
                                            let _e1650 = (_e266 * 2u);
                                            let _e1652 = ((1u + _e1650) % 7u);
                                            if (_e1652 < 7u) {
                                            } else {
                                                phi_4951_ = true;
                                                break;
                                            }
                                            let _e1657 = global_4.member[_e694.member_1][_e1652];
                                            let _e1659 = ((_e1650 + 2u) % 7u);
                                            if (_e1659 < 7u) {
                                            } else {
                                                phi_4951_ = true;
                                                break;
                                            }
                                            let _e1664 = global_4.member[_e694.member_1][_e1659];
                                            let _e1665 = (_e268 * 2u);
                                            let _e1667 = ((1u + _e1665) % 7u);
                                            if (_e1667 < 7u) {
                                            } else {
                                                phi_4951_ = true;
                                                break;
                                            }
                                            let _e1672 = global_4.member[_e694.member_1][_e1667];
                                            let _e1674 = ((_e1665 + 2u) % 7u);
                                            if (_e1674 < 7u) {
                                            } else {
                                                phi_4951_ = true;
                                                break;
                                            }
                                            let _e1679 = global_4.member[_e694.member_1][_e1674];
                                            let _e1702 = (bitcast<f32>((bitcast<u32>((_e694.member.member_1.x - _e694.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1703 = (bitcast<f32>((bitcast<u32>((_e694.member.member_1.y - _e694.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1704 = (bitcast<f32>((bitcast<u32>((_e694.member.member_1.z - _e694.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1706 = select(_e147, _e1702, (_e1702 > _e147));
                                            let _e1708 = select(_e147, _e1703, (_e1703 > _e147));
                                            let _e1710 = select(_e147, _e1704, (_e1704 > _e147));
                                            let _e1741 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1642 & 2097151u))) - 8388608f) * _e1706));
                                            let _e1746 = (bitcast<i32>((_e1642 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1749 = bitcast<f32>((_e1741 & bitcast<u32>(_e1746)));
                                            let _e1750 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1657 & 2097151u))) - 8388608f) * _e1708));
                                            let _e1755 = (bitcast<i32>((_e1657 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1758 = bitcast<f32>((_e1750 & bitcast<u32>(_e1755)));
                                            let _e1759 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1672 & 2097151u))) - 8388608f) * _e1710));
                                            let _e1764 = (bitcast<i32>((_e1672 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1767 = bitcast<f32>((_e1759 & bitcast<u32>(_e1764)));
                                            let _e1771 = bitcast<f32>((_e1741 & bitcast<u32>(~(_e1746))));
                                            let _e1775 = bitcast<f32>((_e1750 & bitcast<u32>(~(_e1755))));
                                            let _e1779 = bitcast<f32>((_e1759 & bitcast<u32>(~(_e1764))));
                                            let _e1780 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1649 & 2097151u))) - 8388608f) * _e1706));
                                            let _e1785 = (bitcast<i32>((_e1649 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1788 = bitcast<f32>((_e1780 & bitcast<u32>(_e1785)));
                                            let _e1789 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1664 & 2097151u))) - 8388608f) * _e1708));
                                            let _e1794 = (bitcast<i32>((_e1664 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1797 = bitcast<f32>((_e1789 & bitcast<u32>(_e1794)));
                                            let _e1798 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1679 & 2097151u))) - 8388608f) * _e1710));
                                            let _e1803 = (bitcast<i32>((_e1679 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1806 = bitcast<f32>((_e1798 & bitcast<u32>(_e1803)));
                                            let _e1810 = bitcast<f32>((_e1780 & bitcast<u32>(~(_e1785))));
                                            let _e1814 = bitcast<f32>((_e1789 & bitcast<u32>(~(_e1794))));
                                            let _e1818 = bitcast<f32>((_e1798 & bitcast<u32>(~(_e1803))));
                                            let _e1819 = (_e694.member.member.x + _e1749);
                                            let _e1820 = (_e694.member.member.y + _e1758);
                                            let _e1821 = (_e694.member.member.z + _e1767);
                                            let _e1824 = (_e694.member.member_1.x - _e1788);
                                            let _e1825 = (_e694.member.member_1.y - _e1797);
                                            let _e1826 = (_e694.member.member_1.z - _e1806);
                                            let _e1845 = (_e1824 - _e1819);
                                            let _e1846 = (_e1825 - _e1820);
                                            let _e1847 = (_e1826 - _e1821);
                                            let _e1849 = select(_e1846, _e1845, (_e1845 > _e1846));
                                            let _e1851 = select(_e1847, _e1849, (_e1849 > _e1847));
                                            if (_e1851 < (1024f * _e147)) {
                                                phi_3417_ = 0u;
                                            } else {
                                                phi_3417_ = select(2u, 1u, (_e1851 < (2097152f * _e147)));
                                            }
                                            let _e1858 = phi_3417_;
                                            switch bitcast<i32>(_e1858) {
                                                case 0: {
                                                    phi_3423_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3423_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3423_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3423_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e1861 = phi_3423_;
                                            let _e1867 = global_4.member[_e694.member_1][0u];
                                            let _e1871 = global_4.member[_e694.member_1][2u];
                                            let _e1875 = global_4.member[_e694.member_1][4u];
                                            let _e1879 = global_4.member[_e694.member_1][6u];
                                            let _e1891 = (((_e1871 >> bitcast<u32>(22i)) | ((_e1875 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1879 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e1892 = (_e1867 & 268435455u);
                                            let _e1893 = (_e1891 & 268435455u);
                                            let _e1896 = ((_e1867 >> bitcast<u32>(28u)) & 7u);
                                            let _e1904 = ((_e1867 >> bitcast<u32>(31i)) | (((_e1891 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e1905 = (_e1896 != 0u);
                                            if (_e1896 == 0u) {
                                                phi_3678_ = _e1892;
                                            } else {
                                                if (_e1896 == 7u) {
                                                    phi_3677_ = 2147483648u;
                                                } else {
                                                    phi_3677_ = ((2147483648u | (_e1896 << bitcast<u32>(28u))) | (_e1893 & 268435455u));
                                                }
                                                let _e1914 = phi_3677_;
                                                phi_3678_ = _e1914;
                                            }
                                            let _e1916 = phi_3678_;
                                            if _e1905 {
                                                let _e1917 = (_e1896 != 7u);
                                                if _e1917 {
                                                    phi_3688_ = (_e1893 + (_e1896 * ((3u * _e1861) + 1u)));
                                                } else {
                                                    phi_3688_ = u32();
                                                }
                                                let _e1921 = phi_3688_;
                                                phi_3690_ = _e1921;
                                                phi_3691_ = select(true, false, _e1917);
                                            } else {
                                                phi_3690_ = u32();
                                                phi_3691_ = true;
                                            }
                                            let _e1924 = phi_3690_;
                                            let _e1926 = phi_3691_;
                                            if (_e1904 == 0u) {
                                                phi_3712_ = (_e1892 + select(0u, 1u, !(_e1905)));
                                            } else {
                                                if (_e1904 == 7u) {
                                                    phi_3711_ = 2147483648u;
                                                } else {
                                                    phi_3711_ = ((2147483648u | (_e1904 << bitcast<u32>(28u))) | (select(_e1924, _e1893, _e1926) & 268435455u));
                                                }
                                                let _e1939 = phi_3711_;
                                                phi_3712_ = _e1939;
                                            }
                                            let _e1941 = phi_3712_;
                                            phi_3716_ = type_51(array<vec4<f32>, 3>(vec4<f32>(_e1819, (_e694.member.member.x + _e1771), _e1824, (_e694.member.member_1.x - _e1810)), vec4<f32>(_e1820, (_e694.member.member.y + _e1775), _e1825, (_e694.member.member_1.y - _e1814)), vec4<f32>(_e1821, (_e694.member.member.z + _e1779), _e1826, (_e694.member.member_1.z - _e1818))), type_50(type_28((_e694.member.member + vec4<f32>(_e1749, _e1758, _e1767, 0f)), (_e694.member.member_1 - vec4<f32>(_e1788, _e1797, _e1806, 0f))), _e1916), type_50(type_28((_e694.member.member + vec4<f32>(_e1771, _e1775, _e1779, 0f)), (_e694.member.member_1 - vec4<f32>(_e1810, _e1814, _e1818, 0f))), _e1941));
                                        }
                                        let _e1946 = phi_3716_;
                                        let _e1958 = ((_e1946.member[0].x - _e369) * _e372);
                                        let _e1959 = ((_e1946.member[0].y - _e369) * _e372);
                                        let _e1960 = ((_e1946.member[0].z - _e370) * _e372);
                                        let _e1961 = ((_e1946.member[0].w - _e370) * _e372);
                                        let _e1971 = ((_e1946.member[1].x - _e435) * _e438);
                                        let _e1972 = ((_e1946.member[1].y - _e435) * _e438);
                                        let _e1973 = ((_e1946.member[1].z - _e436) * _e438);
                                        let _e1974 = ((_e1946.member[1].w - _e436) * _e438);
                                        let _e1984 = ((_e1946.member[2].x - _e501) * _e504);
                                        let _e1985 = ((_e1946.member[2].y - _e501) * _e504);
                                        let _e1986 = ((_e1946.member[2].z - _e502) * _e504);
                                        let _e1987 = ((_e1946.member[2].w - _e502) * _e504);
                                        let _e1989 = select(_e1986, _e1984, (_e1984 < _e1986));
                                        let _e1991 = select(_e1987, _e1985, (_e1985 < _e1987));
                                        let _e1993 = select(_e1986, _e1984, (_e1984 > _e1986));
                                        let _e1995 = select(_e1987, _e1985, (_e1985 > _e1987));
                                        let _e1997 = select(_e1960, _e1958, (_e1958 < _e1960));
                                        let _e1999 = select(_e1961, _e1959, (_e1959 < _e1961));
                                        let _e2001 = select(_e1973, _e1971, (_e1971 < _e1973));
                                        let _e2003 = select(_e1974, _e1972, (_e1972 < _e1974));
                                        let _e2005 = select(_e2001, _e1997, (_e1997 > _e2001));
                                        let _e2007 = select(_e2003, _e1999, (_e1999 > _e2003));
                                        let _e2009 = select(_e1989, _e2005, (_e2005 > _e1989));
                                        let _e2011 = select(_e1991, _e2007, (_e2007 > _e1991));
                                        let _e2013 = select(_e1960, _e1958, (_e1958 > _e1960));
                                        let _e2015 = select(_e1961, _e1959, (_e1959 > _e1961));
                                        let _e2017 = select(_e1973, _e1971, (_e1971 > _e1973));
                                        let _e2019 = select(_e1974, _e1972, (_e1972 > _e1974));
                                        let _e2021 = select(_e2017, _e2013, (_e2013 < _e2017));
                                        let _e2023 = select(_e2019, _e2015, (_e2015 < _e2019));
                                        let _e2028 = -(_e1989);
                                        let _e2029 = -(_e1991);
                                        let _e2036 = (select(_e1993, _e2021, (_e2021 < _e1993)) + (select(_e2028, _e1993, (_e1993 > _e2028)) * 0.0000019073523f));
                                        let _e2037 = (select(_e1995, _e2023, (_e2023 < _e1995)) + (select(_e2029, _e1995, (_e1995 > _e2029)) * 0.0000019073523f));
                                        let _e2039 = select(_e607, _e2009, (_e2009 > _e607));
                                        let _e2041 = select(_e607, _e2011, (_e2011 > _e607));
                                        let _e2046 = (_e2039 <= select(_e1632.member_1, _e2036, (_e2036 < _e1632.member_1)));
                                        let _e2047 = (_e2041 <= select(_e1632.member_1, _e2037, (_e2037 < _e1632.member_1)));
                                        let _e2048 = (_e2039 <= _e2041);
                                        if _e2046 {
                                            if _e2047 {
                                                if _e2048 {
                                                    phi_4078_ = _e1946.member_2;
                                                } else {
                                                    phi_4078_ = _e1946.member_1;
                                                }
                                                let _e2052 = phi_4078_;
                                                let _e2073 = (_e692 % 128u);
                                                let _e2074 = (_e2073 < 128u);
                                                if _e2074 {
                                                } else {
                                                    phi_4951_ = true;
                                                    break;
                                                }
                                                local_8[_e2073] = _e2052.member_1;
                                                if _e2074 {
                                                } else {
                                                    phi_4951_ = true;
                                                    break;
                                                }
                                                local_7[_e2073] = _e2052.member.member.x;
                                                if _e2074 {
                                                } else {
                                                    phi_4951_ = true;
                                                    break;
                                                }
                                                local_6[_e2073] = _e2052.member.member.y;
                                                if _e2074 {
                                                } else {
                                                    phi_4951_ = true;
                                                    break;
                                                }
                                                local_5[_e2073] = _e2052.member.member.z;
                                                if _e2074 {
                                                } else {
                                                    phi_4951_ = true;
                                                    break;
                                                }
                                                local_4[_e2073] = _e2052.member.member_1.x;
                                                if _e2074 {
                                                } else {
                                                    phi_4951_ = true;
                                                    break;
                                                }
                                                local_3[_e2073] = _e2052.member.member_1.y;
                                                if _e2074 {
                                                } else {
                                                    phi_4951_ = true;
                                                    break;
                                                }
                                                local_2[_e2073] = _e2052.member.member_1.z;
                                                if _e2074 {
                                                } else {
                                                    phi_4951_ = true;
                                                    break;
                                                }
                                                local_9[_e2073] = select(_e2039, _e2041, _e2048);
                                                if _e2048 {
                                                    phi_4154_ = _e1946.member_1;
                                                } else {
                                                    phi_4154_ = _e1946.member_2;
                                                }
                                                let _e2087 = phi_4154_;
                                                phi_4155_ = (_e692 + 1u);
                                                phi_4156_ = _e2087;
                                            } else {
                                                phi_4155_ = u32();
                                                phi_4156_ = type_50();
                                            }
                                            let _e2089 = phi_4155_;
                                            let _e2091 = phi_4156_;
                                            phi_4158_ = _e2089;
                                            phi_4159_ = _e2091;
                                            phi_4160_ = select(true, false, _e2047);
                                        } else {
                                            phi_4158_ = u32();
                                            phi_4159_ = type_50();
                                            phi_4160_ = true;
                                        }
                                        let _e2094 = phi_4158_;
                                        let _e2096 = phi_4159_;
                                        let _e2098 = phi_4160_;
                                        if _e2098 {
                                            if _e2046 {
                                                phi_4169_ = _e1946.member_1;
                                            } else {
                                                phi_4169_ = _e1946.member_2;
                                            }
                                            let _e2102 = phi_4169_;
                                            phi_4174_ = select(_e2047, true, _e2046);
                                            phi_4176_ = _e2102;
                                        } else {
                                            phi_4174_ = _e690;
                                            phi_4176_ = _e2096;
                                        }
                                        let _e2105 = phi_4174_;
                                        let _e2107 = phi_4176_;
                                        phi_4180_ = _e2105;
                                        phi_4181_ = select(_e2094, _e692, _e2098);
                                        phi_4182_ = _e2107;
                                    }
                                    let _e2110 = phi_4180_;
                                    let _e2112 = phi_4181_;
                                    let _e2114 = phi_4182_;
                                    if _e698 {
                                        phi_4192_ = _e694;
                                    } else {
                                        phi_4192_ = _e2114;
                                    }
                                    let _e2116 = phi_4192_;
                                    phi_4954_ = _e1630;
                                    phi_4193_ = _e1632;
                                    phi_4194_ = (_e653 - 1u);
                                    phi_4195_ = select(_e2110, false, _e698);
                                    phi_4196_ = select(_e2112, _e692, _e698);
                                    phi_4197_ = _e2116;
                                } else {
                                    phi_4954_ = _e649;
                                    phi_4193_ = _e651;
                                    phi_4194_ = _e653;
                                    phi_4195_ = _e690;
                                    phi_4196_ = _e692;
                                    phi_4197_ = _e694;
                                }
                                let _e2120 = phi_4954_;
                                let _e2122 = phi_4193_;
                                let _e2124 = phi_4194_;
                                let _e2126 = phi_4195_;
                                let _e2128 = phi_4196_;
                                let _e2130 = phi_4197_;
                                phi_4953_ = _e2120;
                                phi_4198_ = _e2122;
                                phi_4199_ = _e2124;
                                phi_4200_ = _e2126;
                                phi_4201_ = _e2128;
                                phi_4202_ = _e2130;
                            } else {
                                phi_4953_ = _e649;
                                phi_4198_ = type_33();
                                phi_4199_ = u32();
                                phi_4200_ = bool();
                                phi_4201_ = u32();
                                phi_4202_ = type_50();
                            }
                            let _e2132 = phi_4953_;
                            let _e2134 = phi_4198_;
                            let _e2136 = phi_4199_;
                            let _e2138 = phi_4200_;
                            let _e2140 = phi_4201_;
                            let _e2142 = phi_4202_;
                            phi_4952_ = _e2132;
                            phi_1194_ = _e2134;
                            phi_1197_ = _e2136;
                            phi_1199_ = _e2138;
                            phi_1201_ = _e2140;
                            phi_1203_ = _e2142;
                            phi_4203_ = _e663;
                        } else {
                            phi_4952_ = _e649;
                            phi_1194_ = type_33();
                            phi_1197_ = u32();
                            phi_1199_ = bool();
                            phi_1201_ = u32();
                            phi_1203_ = type_50();
                            phi_4203_ = false;
                        }
                        let _e2144 = phi_4952_;
                        let _e2146 = phi_1194_;
                        let _e2148 = phi_1197_;
                        let _e2150 = phi_1199_;
                        let _e2152 = phi_1201_;
                        let _e2154 = phi_1203_;
                        let _e2156 = phi_4203_;
                        continue;
                        continuing {
                            phi_4745_ = _e2144;
                            phi_1193_ = _e2146;
                            phi_1196_ = _e2148;
                            phi_1198_ = _e2150;
                            phi_1200_ = _e2152;
                            phi_1202_ = _e2154;
                            phi_4951_ = _e2144;
                            break if !(_e2156);
                        }
                    }
                    let _e2159 = phi_4951_;
                    if _e2159 {
                        break;
                    }
                    let _e2161 = local_10;
                    if (_e2161.member.member_3 != 4294967295u) {
                        let _e2166 = -(_e509);
                        let _e2167 = bitcast<u32>(_e2161.member.member);
                        let _e2171 = (bitcast<i32>((_e2167 >> bitcast<u32>(23i))) & 255i);
                        let _e2172 = (_e2171 + _e2166);
                        if (_e2171 == 255i) {
                            phi_4262_ = _e2161.member.member;
                        } else {
                            if (_e2171 > 0i) {
                                if (_e2172 > 0i) {
                                    let _e2176 = (_e2172 < 255i);
                                    if _e2176 {
                                        phi_4241_ = bitcast<f32>((_e2167 + bitcast<u32>((_e2166 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_4241_ = f32();
                                    }
                                    let _e2183 = phi_4241_;
                                    phi_4243_ = _e2183;
                                    phi_4244_ = select(true, false, _e2176);
                                } else {
                                    phi_4243_ = f32();
                                    phi_4244_ = true;
                                }
                                let _e2186 = phi_4243_;
                                let _e2188 = phi_4244_;
                                phi_4245_ = _e2186;
                                phi_4246_ = _e2188;
                            } else {
                                phi_4245_ = f32();
                                phi_4246_ = true;
                            }
                            let _e2190 = phi_4245_;
                            let _e2192 = phi_4246_;
                            if _e2192 {
                                let _e2193 = (_e2167 & 2147483648u);
                                let _e2200 = ((_e2167 & 8388607u) | (select(0u, 1u, ((_e2167 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e2204 = (_e2200 == 0u);
                                if _e2204 {
                                    phi_4697_ = bitcast<f32>(_e2193);
                                } else {
                                    let _e2209 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2200)), 32u, _e2204) - 8u);
                                    let _e2212 = (_e2200 << bitcast<u32>((_e2209 & 31u)));
                                    let _e2214 = ((_e2172 + select(0i, 1i, (_e2171 == 0i))) - bitcast<i32>(_e2209));
                                    if (_e2214 >= 255i) {
                                        phi_4687_ = bitcast<f32>((_e2193 | 2139095040u));
                                        phi_4688_ = f32();
                                        phi_4689_ = true;
                                    } else {
                                        let _e2216 = (_e2214 > 0i);
                                        if _e2216 {
                                            phi_4681_ = bitcast<f32>(((_e2193 | (bitcast<u32>(_e2214) << bitcast<u32>(23i))) | (_e2212 & 8388607u)));
                                            phi_4682_ = f32();
                                        } else {
                                            if (_e2214 < -24i) {
                                                phi_4647_ = 26u;
                                            } else {
                                                phi_4647_ = bitcast<u32>((1i - _e2214));
                                            }
                                            let _e2221 = phi_4647_;
                                            let _e2222 = (_e2221 & 31u);
                                            let _e2224 = (_e2212 >> bitcast<u32>(_e2222));
                                            let _e2228 = (_e2212 & ((1u << bitcast<u32>(_e2222)) - 1u));
                                            let _e2232 = (1u << bitcast<u32>(((_e2221 - 1u) & 31u)));
                                            if (_e2228 > _e2232) {
                                                phi_4668_ = true;
                                            } else {
                                                if (_e2228 == _e2232) {
                                                    phi_4665_ = ((_e2224 & 1u) == 1u);
                                                } else {
                                                    phi_4665_ = false;
                                                }
                                                let _e2238 = phi_4665_;
                                                phi_4668_ = _e2238;
                                            }
                                            let _e2240 = phi_4668_;
                                            phi_4681_ = f32();
                                            phi_4682_ = bitcast<f32>((_e2193 | (_e2224 + select(0u, 1u, _e2240))));
                                        }
                                        let _e2253 = phi_4681_;
                                        let _e2255 = phi_4682_;
                                        phi_4687_ = _e2253;
                                        phi_4688_ = _e2255;
                                        phi_4689_ = _e2216;
                                    }
                                    let _e2259 = phi_4687_;
                                    let _e2261 = phi_4688_;
                                    let _e2263 = phi_4689_;
                                    phi_4697_ = select(_e2261, _e2259, _e2263);
                                }
                                let _e2267 = phi_4697_;
                                phi_4261_ = _e2267;
                            } else {
                                phi_4261_ = _e2190;
                            }
                            let _e2269 = phi_4261_;
                            phi_4262_ = _e2269;
                        }
                        let _e2271 = phi_4262_;
                        let _e2272 = bitcast<u32>(_e2271);
                        if ((_e2272 & 2147483647u) >= 2139095040u) {
                            phi_4274_ = bitcast<f32>(((_e2272 & 2147483648u) | 2139095039u));
                        } else {
                            phi_4274_ = _e2271;
                        }
                        let _e2279 = phi_4274_;
                        phi_4279_ = type_20(_e2279, _e2161.member.member_1, _e2161.member.member_2, _e2161.member.member_3);
                    } else {
                        phi_4279_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e2284 = phi_4279_;
                    if _e155 {
                    } else {
                        break;
                    }
                    global_6.member[_e153] = _e2284;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_closest_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
