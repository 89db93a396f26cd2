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

struct type_31 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_33 {
    member: array<type_31>,
}

struct type_40 {
    member: type_23,
    member_1: f32,
}

struct type_44 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_46 {
    member: array<type_27>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_8;
@group(0) @binding(1) 
var<storage> global_2: type_33;
@group(0) @binding(2) 
var<storage> global_3: type_15;
@group(0) @binding(3) 
var<storage> global_4: type_46;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_25;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_364_: i32;
    var phi_365_: i32;
    var phi_375_: bool;
    var phi_385_: u32;
    var phi_386_: u32;
    var phi_388_: bool;
    var phi_393_: u32;
    var phi_406_: i32;
    var phi_426_: i32;
    var phi_444_: f32;
    var phi_450_: f32;
    var phi_490_: f32;
    var phi_496_: f32;
    var phi_548_: f32;
    var phi_560_: f32;
    var phi_569_: f32;
    var phi_575_: f32;
    var phi_615_: f32;
    var phi_621_: f32;
    var phi_673_: f32;
    var phi_685_: f32;
    var phi_694_: f32;
    var phi_700_: f32;
    var phi_740_: f32;
    var phi_746_: f32;
    var phi_798_: f32;
    var phi_810_: f32;
    var phi_865_: i32;
    var phi_887_: u32;
    var phi_888_: u32;
    var phi_925_: i32;
    var phi_947_: u32;
    var phi_948_: u32;
    var phi_956_: f32;
    var phi_957_: f32;
    var phi_2790_: bool;
    var phi_972_: type_40;
    var phi_975_: bool;
    var phi_977_: u32;
    var phi_979_: u32;
    var phi_981_: u32;
    var phi_992_: bool;
    var phi_1024_: bool;
    var phi_1025_: u32;
    var phi_1026_: u32;
    var phi_2183_: type_44;
    var phi_2545_: u32;
    var phi_2573_: u32;
    var phi_2574_: u32;
    var phi_2575_: u32;
    var phi_2577_: u32;
    var phi_2578_: u32;
    var phi_2579_: bool;
    var phi_2588_: u32;
    var phi_2593_: bool;
    var phi_2595_: u32;
    var phi_1041_: type_40;
    var phi_1044_: type_4;
    var phi_1045_: type_4;
    var phi_1067_: type_4;
    var phi_1088_: u32;
    var phi_1180_: array<array<f32, 3>, 3>;
    var phi_1332_: bool;
    var phi_1361_: bool;
    var phi_1780_: f32;
    var phi_1781_: f32;
    var phi_1782_: f32;
    var phi_1783_: f32;
    var phi_1784_: vec3<f32>;
    var phi_1785_: vec3<f32>;
    var phi_1786_: vec3<f32>;
    var phi_1787_: vec3<f32>;
    var phi_1824_: bool;
    var phi_1833_: vec3<f32>;
    var phi_1998_: f32;
    var phi_2000_: f32;
    var phi_2001_: bool;
    var phi_2021_: f32;
    var phi_2022_: f32;
    var phi_2045_: type_23;
    var phi_2047_: type_23;
    var phi_2048_: bool;
    var phi_2052_: type_23;
    var phi_2053_: type_23;
    var phi_2054_: type_23;
    var phi_2055_: bool;
    var phi_2059_: type_23;
    var phi_2060_: bool;
    var phi_2061_: type_23;
    var phi_2062_: bool;
    var phi_2063_: bool;
    var phi_2064_: type_23;
    var phi_2065_: bool;
    var phi_2066_: bool;
    var phi_2074_: type_23;
    var phi_2075_: bool;
    var phi_2079_: type_23;
    var phi_2104_: bool;
    var phi_2105_: bool;
    var phi_2111_: type_40;
    var phi_2112_: type_40;
    var phi_2113_: type_40;
    var phi_1042_: type_40;
    var phi_2784_: bool;
    var phi_2948_: bool;
    var phi_2599_: type_40;
    var phi_2600_: bool;
    var phi_2601_: u32;
    var phi_2602_: u32;
    var phi_2947_: bool;
    var phi_2603_: type_40;
    var phi_2604_: bool;
    var phi_2605_: u32;
    var phi_2606_: u32;
    var phi_2607_: u32;
    var phi_2946_: bool;
    var phi_2608_: type_40;
    var phi_2609_: bool;
    var phi_2610_: u32;
    var phi_2611_: u32;
    var phi_2612_: u32;
    var phi_2945_: bool;
    var phi_973_: type_40;
    var phi_976_: bool;
    var phi_978_: u32;
    var phi_980_: u32;
    var phi_982_: u32;
    var phi_2613_: bool;
    var phi_2944_: bool;
    var local_2: type_40;
    var phi_2651_: f32;
    var phi_2653_: f32;
    var phi_2654_: bool;
    var phi_2655_: f32;
    var phi_2656_: bool;
    var phi_2729_: u32;
    var phi_2747_: bool;
    var phi_2750_: bool;
    var phi_2763_: f32;
    var phi_2764_: f32;
    var phi_2769_: f32;
    var phi_2770_: f32;
    var phi_2771_: bool;
    var phi_2779_: f32;
    var phi_2671_: f32;
    var phi_2672_: f32;
    var phi_2684_: f32;
    var phi_2689_: type_23;
    var local_3: type_40;

    switch bitcast<i32>(0u) {
        default: {
            let _e73 = global;
            let _e75 = arrayLength((&global_2.member));
            let _e77 = arrayLength((&global_3.member));
            let _e85 = (_e73.x + (_e73.y * 2097152u));
            let _e88 = global_1.member[0u];
            let _e89 = bitcast<i32>(_e88);
            let _e90 = (_e85 < arrayLength((&global_4.member)));
            if _e90 {
                let _e91 = (_e85 < arrayLength((&global_5.member)));
                if _e91 {
                    if _e90 {
                    } else {
                        break;
                    }
                    let _e99 = global_4.member[_e85].member_2[0u];
                    let _e101 = (bitcast<u32>(_e99) & 2147483647u);
                    let _e106 = global_4.member[_e85].member_2[1u];
                    let _e108 = (bitcast<u32>(_e106) & 2147483647u);
                    let _e113 = global_4.member[_e85].member_2[2u];
                    let _e115 = (bitcast<u32>(_e113) & 2147483647u);
                    let _e120 = global_4.member[_e85].member[0u];
                    let _e122 = (bitcast<u32>(_e120) & 2147483647u);
                    let _e127 = global_4.member[_e85].member[1u];
                    let _e129 = (bitcast<u32>(_e127) & 2147483647u);
                    let _e134 = global_4.member[_e85].member[2u];
                    let _e136 = (bitcast<u32>(_e134) & 2147483647u);
                    let _e138 = select(_e108, _e101, (_e108 < _e101));
                    let _e140 = select(_e115, _e138, (_e115 < _e138));
                    let _e142 = select(_e122, _e140, (_e122 < _e140));
                    let _e144 = select(_e129, _e142, (_e129 < _e142));
                    let _e146 = select(_e136, _e144, (_e136 < _e144));
                    let _e150 = global_4.member[_e85].member_1;
                    let _e151 = bitcast<u32>(_e150);
                    let _e152 = (_e151 & 2147483647u);
                    let _e159 = global_4.member[_e85].member_3;
                    let _e160 = bitcast<u32>(_e159);
                    let _e161 = (_e160 & 2147483647u);
                    let _e165 = (((select(_e152, _e146, (_e152 < _e146)) < 2139095040u) && (_e161 <= 2139095040u)) && (_e140 > 0u));
                    if _e165 {
                        let _e168 = (bitcast<u32>(bitcast<f32>(_e140)) & 2147483647u);
                        if (_e168 >= 8388608u) {
                            phi_364_ = (bitcast<i32>((_e168 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_364_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e168)), 32u, (_e168 == 0u))));
                        }
                        let _e182 = phi_364_;
                        phi_365_ = _e182;
                    } else {
                        phi_365_ = 0i;
                    }
                    let _e184 = phi_365_;
                    let _e185 = (_e101 == _e140);
                    if _e185 {
                        phi_375_ = true;
                    } else {
                        phi_375_ = (_e108 == _e140);
                    }
                    let _e188 = phi_375_;
                    let _e189 = select(1u, 0u, _e185);
                    if _e188 {
                        let _e190 = (_e189 + 1u);
                        phi_385_ = _e190;
                        phi_386_ = _e190;
                        phi_388_ = select(true, false, (_e190 == 2u));
                    } else {
                        phi_385_ = u32();
                        phi_386_ = 0u;
                        phi_388_ = true;
                    }
                    let _e194 = phi_385_;
                    let _e196 = phi_386_;
                    let _e198 = phi_388_;
                    if _e198 {
                        phi_393_ = (_e196 + 1u);
                    } else {
                        phi_393_ = 0u;
                    }
                    let _e202 = phi_393_;
                    let _e203 = select(_e194, _e196, _e198);
                    let _e204 = select(_e189, select(2u, _e189, _e188), _e198);
                    if (_e89 < -126i) {
                        phi_406_ = -126i;
                    } else {
                        phi_406_ = select(_e89, 127i, (_e89 > 127i));
                    }
                    let _e209 = phi_406_;
                    let _e214 = bitcast<f32>((bitcast<u32>((_e209 + 127i)) << bitcast<u32>(23i)));
                    let _e220 = bitcast<f32>((bitcast<u32>(((_e89 - _e209) + 127i)) << bitcast<u32>(23i)));
                    let _e221 = -(_e184);
                    if (_e221 < -126i) {
                        phi_426_ = -126i;
                    } else {
                        phi_426_ = select(_e221, 127i, (_e221 > 127i));
                    }
                    let _e226 = phi_426_;
                    let _e231 = bitcast<f32>((bitcast<u32>((_e226 + 127i)) << bitcast<u32>(23i)));
                    let _e237 = bitcast<f32>((bitcast<u32>(((_e221 - _e226) + 127i)) << bitcast<u32>(23i)));
                    let _e241 = global_4.member[_e85].member;
                    let _e242 = (_e203 == 0u);
                    if _e242 {
                        phi_444_ = _e241[0];
                    } else {
                        phi_444_ = _e241[1];
                    }
                    let _e246 = phi_444_;
                    let _e247 = (_e203 == 2u);
                    if _e247 {
                        phi_450_ = _e241[2];
                    } else {
                        phi_450_ = _e246;
                    }
                    let _e250 = phi_450_;
                    let _e251 = bitcast<u32>(_e250);
                    let _e253 = ((_e251 & 2139095040u) != 0u);
                    let _e267 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e251 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e251 & 2147483648u))), _e250, _e253) * _e214) * select(0.00000011920929f, 1f, _e253)) * _e220);
                    let _e268 = global_4.member[_e85].member_2;
                    if _e242 {
                        phi_490_ = _e268[0];
                    } else {
                        phi_490_ = _e268[1];
                    }
                    let _e272 = phi_490_;
                    if _e247 {
                        phi_496_ = _e268[2];
                    } else {
                        phi_496_ = _e272;
                    }
                    let _e275 = phi_496_;
                    let _e276 = bitcast<u32>(_e275);
                    let _e278 = ((_e276 & 2139095040u) != 0u);
                    let _e292 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e276 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e276 & 2147483648u))), _e275, _e278) * _e231) * select(0.00000011920929f, 1f, _e278)) * _e237);
                    let _e296 = (bitcast<f32>((bitcast<u32>(_e292) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e296 {
                        let _e300 = (bitcast<f32>((bitcast<u32>(_e267) & 2147483647u)) * 0.00000011920929f);
                        phi_548_ = select(0.00000000000011368684f, _e300, (_e300 > 0.00000000000011368684f));
                    } else {
                        phi_548_ = 0f;
                    }
                    let _e304 = phi_548_;
                    let _e305 = (_e267 + _e304);
                    let _e306 = (_e267 - _e304);
                    let _e307 = select(_e292, 0f, _e296);
                    if _e296 {
                        phi_560_ = 38685626000000000000000000f;
                    } else {
                        phi_560_ = (1f / _e292);
                    }
                    let _e310 = phi_560_;
                    let _e311 = (_e202 == 0u);
                    if _e311 {
                        phi_569_ = _e241[0];
                    } else {
                        phi_569_ = _e241[1];
                    }
                    let _e315 = phi_569_;
                    let _e316 = (_e202 == 2u);
                    if _e316 {
                        phi_575_ = _e241[2];
                    } else {
                        phi_575_ = _e315;
                    }
                    let _e319 = phi_575_;
                    let _e320 = bitcast<u32>(_e319);
                    let _e322 = ((_e320 & 2139095040u) != 0u);
                    let _e336 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e320 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e320 & 2147483648u))), _e319, _e322) * _e214) * select(0.00000011920929f, 1f, _e322)) * _e220);
                    if _e311 {
                        phi_615_ = _e268[0];
                    } else {
                        phi_615_ = _e268[1];
                    }
                    let _e340 = phi_615_;
                    if _e316 {
                        phi_621_ = _e268[2];
                    } else {
                        phi_621_ = _e340;
                    }
                    let _e343 = phi_621_;
                    let _e344 = bitcast<u32>(_e343);
                    let _e346 = ((_e344 & 2139095040u) != 0u);
                    let _e360 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e344 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e344 & 2147483648u))), _e343, _e346) * _e231) * select(0.00000011920929f, 1f, _e346)) * _e237);
                    let _e364 = (bitcast<f32>((bitcast<u32>(_e360) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e364 {
                        let _e368 = (bitcast<f32>((bitcast<u32>(_e336) & 2147483647u)) * 0.00000011920929f);
                        phi_673_ = select(0.00000000000011368684f, _e368, (_e368 > 0.00000000000011368684f));
                    } else {
                        phi_673_ = 0f;
                    }
                    let _e372 = phi_673_;
                    let _e373 = (_e336 + _e372);
                    let _e374 = (_e336 - _e372);
                    let _e375 = select(_e360, 0f, _e364);
                    if _e364 {
                        phi_685_ = 38685626000000000000000000f;
                    } else {
                        phi_685_ = (1f / _e360);
                    }
                    let _e378 = phi_685_;
                    let _e379 = (_e204 == 0u);
                    if _e379 {
                        phi_694_ = _e241[0];
                    } else {
                        phi_694_ = _e241[1];
                    }
                    let _e383 = phi_694_;
                    let _e384 = (_e204 == 2u);
                    if _e384 {
                        phi_700_ = _e241[2];
                    } else {
                        phi_700_ = _e383;
                    }
                    let _e387 = phi_700_;
                    let _e388 = bitcast<u32>(_e387);
                    let _e390 = ((_e388 & 2139095040u) != 0u);
                    let _e404 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e388 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e388 & 2147483648u))), _e387, _e390) * _e214) * select(0.00000011920929f, 1f, _e390)) * _e220);
                    if _e379 {
                        phi_740_ = _e268[0];
                    } else {
                        phi_740_ = _e268[1];
                    }
                    let _e408 = phi_740_;
                    if _e384 {
                        phi_746_ = _e268[2];
                    } else {
                        phi_746_ = _e408;
                    }
                    let _e411 = phi_746_;
                    let _e412 = bitcast<u32>(_e411);
                    let _e414 = ((_e412 & 2139095040u) != 0u);
                    let _e428 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e412 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e412 & 2147483648u))), _e411, _e414) * _e231) * select(0.00000011920929f, 1f, _e414)) * _e237);
                    let _e432 = (bitcast<f32>((bitcast<u32>(_e428) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e432 {
                        let _e436 = (bitcast<f32>((bitcast<u32>(_e404) & 2147483647u)) * 0.00000011920929f);
                        phi_798_ = select(0.00000000000011368684f, _e436, (_e436 > 0.00000000000011368684f));
                    } else {
                        phi_798_ = 0f;
                    }
                    let _e440 = phi_798_;
                    let _e441 = (_e404 + _e440);
                    let _e442 = (_e404 - _e440);
                    let _e443 = select(_e428, 0f, _e432);
                    if _e432 {
                        phi_810_ = 38685626000000000000000000f;
                    } else {
                        phi_810_ = (1f / _e428);
                    }
                    let _e446 = phi_810_;
                    let _e449 = bitcast<f32>((bitcast<u32>(_e267) & 2147483647u));
                    let _e452 = bitcast<f32>((bitcast<u32>(_e336) & 2147483647u));
                    let _e454 = select(_e452, _e449, (_e449 > _e452));
                    let _e457 = bitcast<f32>((bitcast<u32>(_e404) & 2147483647u));
                    let _e460 = (_e89 + _e184);
                    if (_e165 && (select(_e457, _e454, (_e454 > _e457)) <= 1099511600000f)) {
                        let _e470 = ((_e152 & 8388607u) | (select(0u, 1u, ((_e152 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e473 = bitcast<i32>((_e152 >> bitcast<u32>(23i)));
                        let _e477 = (_e470 == 0u);
                        let _e480 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e470)), 32u, _e477)) - 8i);
                        if (_e473 == 255i) {
                            phi_865_ = 255i;
                        } else {
                            phi_865_ = (((_e473 + select(0i, 1i, (_e473 == 0i))) - _e480) + _e460);
                        }
                        let _e488 = phi_865_;
                        let _e498 = (_e488 <= 0i);
                        if _e498 {
                            phi_888_ = u32();
                        } else {
                            if _e477 {
                                phi_887_ = u32();
                            } else {
                                phi_887_ = select(((bitcast<u32>(_e488) << bitcast<u32>(23i)) | ((_e470 << bitcast<u32>(((_e480 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e488 >= 255i));
                            }
                            let _e502 = phi_887_;
                            phi_888_ = _e502;
                        }
                        let _e504 = phi_888_;
                        let _e516 = ((_e161 & 8388607u) | (select(0u, 1u, ((_e161 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e519 = bitcast<i32>((_e161 >> bitcast<u32>(23i)));
                        let _e523 = (_e516 == 0u);
                        let _e526 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e516)), 32u, _e523)) - 8i);
                        if (_e519 == 255i) {
                            phi_925_ = 255i;
                        } else {
                            phi_925_ = (((_e519 + select(0i, 1i, (_e519 == 0i))) - _e526) + _e460);
                        }
                        let _e534 = phi_925_;
                        let _e544 = (_e534 <= 0i);
                        if _e544 {
                            phi_948_ = u32();
                        } else {
                            if _e523 {
                                phi_947_ = u32();
                            } else {
                                phi_947_ = select(((bitcast<u32>(_e534) << bitcast<u32>(23i)) | ((_e516 << bitcast<u32>(((_e526 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e534 >= 255i));
                            }
                            let _e548 = phi_947_;
                            phi_948_ = _e548;
                        }
                        let _e550 = phi_948_;
                        phi_956_ = bitcast<f32>(((_e160 & 2147483648u) | select(_e550, 0u, select(_e523, true, _e544))));
                        phi_957_ = bitcast<f32>(((_e151 & 2147483648u) | select(_e504, 0u, select(_e477, true, _e498))));
                    } else {
                        phi_956_ = 0f;
                        phi_957_ = 1f;
                    }
                    let _e556 = phi_956_;
                    let _e558 = phi_957_;
                    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_2790_ = false;
                    phi_972_ = type_40(type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e556);
                    phi_975_ = (_e558 <= _e556);
                    phi_977_ = ((3u * _e75) + 1u);
                    phi_979_ = 0u;
                    phi_981_ = select(0u, 2147483648u, (_e75 == 0u));
                    loop {
                        let _e566 = phi_2790_;
                        let _e568 = phi_972_;
                        let _e570 = phi_975_;
                        let _e572 = phi_977_;
                        let _e574 = phi_979_;
                        let _e576 = phi_981_;
                        local_2 = _e568;
                        if _e570 {
                            phi_992_ = true;
                        } else {
                            phi_992_ = (_e574 > 0u);
                        }
                        let _e579 = phi_992_;
                        if _e579 {
                            let _e580 = (_e572 > 0u);
                            if _e580 {
                                if _e570 {
                                    phi_1024_ = _e570;
                                    phi_1025_ = _e574;
                                    phi_1026_ = _e576;
                                } else {
                                    let _e581 = (_e574 - 1u);
                                    let _e582 = (_e581 % 128u);
                                    let _e583 = (_e582 < 128u);
                                    if _e583 {
                                    } else {
                                        phi_2944_ = true;
                                        break;
                                    }
                                    let _e585 = local_1[_e582];
                                    if _e583 {
                                    } else {
                                        phi_2944_ = true;
                                        break;
                                    }
                                    let _e587 = local[_e582];
                                    phi_1024_ = (_e587 <= _e568.member_1);
                                    phi_1025_ = _e581;
                                    phi_1026_ = _e585;
                                }
                                let _e591 = phi_1024_;
                                let _e593 = phi_1025_;
                                let _e595 = phi_1026_;
                                if _e591 {
                                    if ((_e595 & 2147483648u) != 0u) {
                                        phi_1041_ = _e568;
                                        phi_1044_ = type_4(0u, ((_e595 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e793 = phi_1041_;
                                            let _e795 = phi_1044_;
                                            local_3 = _e793;
                                            if (_e795.member < _e795.member_1) {
                                                phi_1045_ = type_4((_e795.member + 1u), _e795.member_1);
                                                phi_1067_ = type_4(1u, _e795.member);
                                            } else {
                                                phi_1045_ = _e795;
                                                phi_1067_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e808 = phi_1045_;
                                            let _e810 = phi_1067_;
                                            let _e814 = (bitcast<i32>(_e810.member) != 0i);
                                            if _e814 {
                                                let _e815 = ((_e595 & 268435455u) + _e810.member_1);
                                                let _e816 = (_e815 < _e77);
                                                if _e816 {
                                                    if _e816 {
                                                    } else {
                                                        phi_2784_ = true;
                                                        break;
                                                    }
                                                    let _e820 = global_3.member[_e815].member_1;
                                                    phi_1088_ = _e820;
                                                } else {
                                                    phi_1088_ = 4294967295u;
                                                }
                                                let _e822 = phi_1088_;
                                                if (_e815 >= _e77) {
                                                    phi_1180_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e816 {
                                                    } else {
                                                        phi_2784_ = true;
                                                        break;
                                                    }
                                                    let _e824 = (_e203 % 3u);
                                                    let _e825 = (_e202 % 3u);
                                                    let _e826 = (_e204 % 3u);
                                                    if (_e824 < 9u) {
                                                    } else {
                                                        phi_2784_ = true;
                                                        break;
                                                    }
                                                    let _e832 = global_3.member[_e815].member[_e824];
                                                    if (_e825 < 9u) {
                                                    } else {
                                                        phi_2784_ = true;
                                                        break;
                                                    }
                                                    let _e838 = global_3.member[_e815].member[_e825];
                                                    if (_e826 < 9u) {
                                                    } else {
                                                        phi_2784_ = true;
                                                        break;
                                                    }
                                                    let _e844 = global_3.member[_e815].member[_e826];
                                                    let _e846 = (3u + _e824);
                                                    if (_e846 < 9u) {
                                                    } else {
                                                        phi_2784_ = true;
                                                        break;
                                                    }
                                                    let _e852 = global_3.member[_e815].member[_e846];
                                                    let _e853 = (3u + _e825);
                                                    if (_e853 < 9u) {
                                                    } else {
                                                        phi_2784_ = true;
                                                        break;
                                                    }
                                                    let _e859 = global_3.member[_e815].member[_e853];
                                                    let _e860 = (3u + _e826);
                                                    if (_e860 < 9u) {
                                                    } else {
                                                        phi_2784_ = true;
                                                        break;
                                                    }
                                                    let _e866 = global_3.member[_e815].member[_e860];
                                                    let _e868 = (6u + _e824);
                                                    if (_e868 < 9u) {
                                                    } else {
                                                        phi_2784_ = true;
                                                        break;
                                                    }
                                                    let _e874 = global_3.member[_e815].member[_e868];
                                                    let _e875 = (6u + _e825);
                                                    if (_e875 < 9u) {
                                                    } else {
                                                        phi_2784_ = true;
                                                        break;
                                                    }
                                                    let _e881 = global_3.member[_e815].member[_e875];
                                                    let _e882 = (6u + _e826);
                                                    if (_e882 < 9u) {
                                                    } else {
                                                        phi_2784_ = true;
                                                        break;
                                                    }
                                                    let _e888 = global_3.member[_e815].member[_e882];
                                                    phi_1180_ = array<array<f32, 3>, 3>(array<f32, 3>(_e832, _e838, _e844), array<f32, 3>(_e852, _e859, _e866), array<f32, 3>(_e874, _e881, _e888));
                                                }
                                                let _e892 = phi_1180_;
                                                let _e900 = (_e892[0][2] - _e404);
                                                let _e903 = (((_e892[0][0] - _e267) * _e443) - (_e900 * _e307));
                                                let _e906 = (((_e892[0][1] - _e336) * _e443) - (_e900 * _e375));
                                                let _e913 = (_e892[1][2] - _e404);
                                                let _e916 = (((_e892[1][0] - _e267) * _e443) - (_e913 * _e307));
                                                let _e919 = (((_e892[1][1] - _e336) * _e443) - (_e913 * _e375));
                                                let _e926 = (_e892[2][2] - _e404);
                                                let _e929 = (((_e892[2][0] - _e267) * _e443) - (_e926 * _e307));
                                                let _e932 = (((_e892[2][1] - _e336) * _e443) - (_e926 * _e375));
                                                let _e933 = (_e929 * _e919);
                                                let _e934 = (_e932 * _e916);
                                                let _e935 = (_e903 * _e932);
                                                let _e936 = (_e906 * _e929);
                                                let _e937 = (_e916 * _e906);
                                                let _e938 = (_e919 * _e903);
                                                let _e943 = (((_e933 >= _e934) && (_e935 >= _e936)) && (_e937 >= _e938));
                                                if (_e943 || (((_e933 <= _e934) && (_e935 <= _e936)) && (_e937 <= _e938))) {
                                                    let _e950 = select(-1f, 1f, _e943);
                                                    let _e952 = ((_e933 - _e934) * _e950);
                                                    let _e954 = select(0f, _e952, (_e952 > 0f));
                                                    let _e956 = ((_e935 - _e936) * _e950);
                                                    let _e958 = select(0f, _e956, (_e956 > 0f));
                                                    let _e960 = ((_e937 - _e938) * _e950);
                                                    let _e962 = select(0f, _e960, (_e960 > 0f));
                                                    let _e964 = ((_e954 + _e958) + _e962);
                                                    if (_e964 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2064_ = type_23();
                                                        phi_2065_ = true;
                                                        phi_2066_ = false;
                                                    } else {
                                                        let _e967 = select(_e916, _e903, (_e903 < _e916));
                                                        if (select(_e929, _e967, (_e967 < _e929)) > 0f) {
                                                            phi_1332_ = true;
                                                        } else {
                                                            let _e972 = select(_e916, _e903, (_e903 > _e916));
                                                            phi_1332_ = (select(_e929, _e972, (_e972 > _e929)) < 0f);
                                                        }
                                                        let _e977 = phi_1332_;
                                                        if _e977 {
                                                            phi_2061_ = type_23();
                                                            phi_2062_ = true;
                                                            phi_2063_ = false;
                                                        } else {
                                                            let _e979 = select(_e919, _e906, (_e906 < _e919));
                                                            if (select(_e932, _e979, (_e979 < _e932)) > 0f) {
                                                                phi_1361_ = true;
                                                            } else {
                                                                let _e984 = select(_e919, _e906, (_e906 > _e919));
                                                                phi_1361_ = (select(_e932, _e984, (_e984 > _e932)) < 0f);
                                                            }
                                                            let _e989 = phi_1361_;
                                                            if _e989 {
                                                                phi_2059_ = type_23();
                                                                phi_2060_ = false;
                                                            } else {
                                                                let _e991 = select(_e892[1][0], _e892[0][0], (_e892[0][0] < _e892[1][0]));
                                                                let _e995 = select(_e892[1][0], _e892[0][0], (_e892[0][0] > _e892[1][0]));
                                                                let _e999 = select(_e892[1][1], _e892[0][1], (_e892[0][1] < _e892[1][1]));
                                                                let _e1003 = select(_e892[1][1], _e892[0][1], (_e892[0][1] > _e892[1][1]));
                                                                let _e1007 = select(_e892[1][2], _e892[0][2], (_e892[0][2] < _e892[1][2]));
                                                                let _e1011 = select(_e892[1][2], _e892[0][2], (_e892[0][2] > _e892[1][2]));
                                                                let _e1016 = ((select(_e892[2][0], _e991, (_e991 < _e892[2][0])) - _e305) * _e310);
                                                                let _e1017 = ((select(_e892[2][0], _e995, (_e995 > _e892[2][0])) - _e306) * _e310);
                                                                let _e1020 = ((select(_e892[2][1], _e999, (_e999 < _e892[2][1])) - _e373) * _e378);
                                                                let _e1021 = ((select(_e892[2][1], _e1003, (_e1003 > _e892[2][1])) - _e374) * _e378);
                                                                let _e1024 = ((select(_e892[2][2], _e1007, (_e1007 < _e892[2][2])) - _e441) * _e446);
                                                                let _e1025 = ((select(_e892[2][2], _e1011, (_e1011 > _e892[2][2])) - _e442) * _e446);
                                                                let _e1027 = select(_e1025, _e1024, (_e1024 < _e1025));
                                                                let _e1029 = select(_e1025, _e1024, (_e1024 > _e1025));
                                                                let _e1031 = select(_e1017, _e1016, (_e1016 < _e1017));
                                                                let _e1033 = select(_e1021, _e1020, (_e1020 < _e1021));
                                                                let _e1035 = select(_e1033, _e1031, (_e1031 > _e1033));
                                                                let _e1037 = select(_e1027, _e1035, (_e1035 > _e1027));
                                                                let _e1039 = select(_e1017, _e1016, (_e1016 > _e1017));
                                                                let _e1041 = select(_e1021, _e1020, (_e1020 > _e1021));
                                                                let _e1043 = select(_e1041, _e1039, (_e1039 < _e1041));
                                                                let _e1045 = select(_e1029, _e1043, (_e1043 < _e1029));
                                                                let _e1046 = -(_e1027);
                                                                let _e1052 = select(_e558, _e1037, (_e1037 > _e558));
                                                                if (_e1052 > (_e1045 + (select(_e1046, _e1029, (_e1029 > _e1046)) * 0.0000019073523f))) {
                                                                    phi_2054_ = type_23();
                                                                    phi_2055_ = true;
                                                                } else {
                                                                    let _e1054 = (_e1052 > _e793.member_1);
                                                                    if _e1054 {
                                                                        phi_2053_ = type_23();
                                                                    } else {
                                                                        let _e1055 = vec3<f32>(_e892[0][0], _e892[0][1], _e892[0][2]);
                                                                        let _e1056 = vec3<f32>(_e892[1][0], _e892[1][1], _e892[1][2]);
                                                                        let _e1057 = vec3<f32>(_e892[2][0], _e892[2][1], _e892[2][2]);
                                                                        let _e1058 = (_e892[1][0] - _e892[0][0]);
                                                                        let _e1059 = (_e892[1][1] - _e892[0][1]);
                                                                        let _e1060 = (_e892[1][2] - _e892[0][2]);
                                                                        let _e1061 = vec3<f32>(_e1058, _e1059, _e1060);
                                                                        let _e1062 = (_e892[2][0] - _e892[1][0]);
                                                                        let _e1063 = (_e892[2][1] - _e892[1][1]);
                                                                        let _e1064 = (_e892[2][2] - _e892[1][2]);
                                                                        let _e1065 = vec3<f32>(_e1062, _e1063, _e1064);
                                                                        let _e1066 = (_e892[0][0] - _e892[2][0]);
                                                                        let _e1067 = (_e892[0][1] - _e892[2][1]);
                                                                        let _e1068 = (_e892[0][2] - _e892[2][2]);
                                                                        let _e1069 = vec3<f32>(_e1066, _e1067, _e1068);
                                                                        let _e1072 = bitcast<f32>((bitcast<u32>(_e1058) & 2147483647u));
                                                                        let _e1075 = bitcast<f32>((bitcast<u32>(_e1059) & 2147483647u));
                                                                        let _e1077 = select(_e1075, _e1072, (_e1072 > _e1075));
                                                                        let _e1080 = bitcast<f32>((bitcast<u32>(_e1060) & 2147483647u));
                                                                        let _e1082 = select(_e1080, _e1077, (_e1077 > _e1080));
                                                                        let _e1085 = bitcast<f32>((bitcast<u32>(_e1062) & 2147483647u));
                                                                        let _e1088 = bitcast<f32>((bitcast<u32>(_e1063) & 2147483647u));
                                                                        let _e1090 = select(_e1088, _e1085, (_e1085 > _e1088));
                                                                        let _e1093 = bitcast<f32>((bitcast<u32>(_e1064) & 2147483647u));
                                                                        let _e1095 = select(_e1093, _e1090, (_e1090 > _e1093));
                                                                        let _e1098 = bitcast<f32>((bitcast<u32>(_e1066) & 2147483647u));
                                                                        let _e1101 = bitcast<f32>((bitcast<u32>(_e1067) & 2147483647u));
                                                                        let _e1103 = select(_e1101, _e1098, (_e1098 > _e1101));
                                                                        let _e1106 = bitcast<f32>((bitcast<u32>(_e1068) & 2147483647u));
                                                                        let _e1108 = select(_e1106, _e1103, (_e1103 > _e1106));
                                                                        let _e1110 = select(_e1095, _e1082, (_e1082 > _e1095));
                                                                        let _e1112 = select(_e1108, _e1110, (_e1110 > _e1108));
                                                                        if (_e1082 == _e1112) {
                                                                            phi_1780_ = _e919;
                                                                            phi_1781_ = _e916;
                                                                            phi_1782_ = _e906;
                                                                            phi_1783_ = _e903;
                                                                            phi_1784_ = _e1055;
                                                                            phi_1785_ = _e1069;
                                                                            phi_1786_ = _e1065;
                                                                            phi_1787_ = _e1061;
                                                                        } else {
                                                                            let _e1114 = (_e1095 == _e1112);
                                                                            let _e1119 = vec3(_e1114);
                                                                            phi_1780_ = select(_e906, _e932, _e1114);
                                                                            phi_1781_ = select(_e903, _e929, _e1114);
                                                                            phi_1782_ = select(_e932, _e919, _e1114);
                                                                            phi_1783_ = select(_e929, _e916, _e1114);
                                                                            phi_1784_ = select(_e1057, _e1056, _e1119);
                                                                            phi_1785_ = select(_e1065, _e1061, _e1119);
                                                                            phi_1786_ = select(_e1061, _e1069, _e1119);
                                                                            phi_1787_ = select(_e1069, _e1065, _e1119);
                                                                        }
                                                                        let _e1125 = phi_1780_;
                                                                        let _e1127 = phi_1781_;
                                                                        let _e1129 = phi_1782_;
                                                                        let _e1131 = phi_1783_;
                                                                        let _e1133 = phi_1784_;
                                                                        let _e1135 = phi_1785_;
                                                                        let _e1137 = phi_1786_;
                                                                        let _e1139 = phi_1787_;
                                                                        let _e1146 = ((_e1137.y * _e1135.z) - (_e1135.y * _e1137.z));
                                                                        let _e1151 = ((_e1137.z * _e1135.x) - (_e1135.z * _e1137.x));
                                                                        let _e1154 = ((_e1137.x * _e1135.y) - (_e1135.x * _e1137.y));
                                                                        if (_e954 >= _e958) {
                                                                            phi_1824_ = select(true, false, (_e954 >= _e962));
                                                                        } else {
                                                                            phi_1824_ = true;
                                                                        }
                                                                        let _e1159 = phi_1824_;
                                                                        if _e1159 {
                                                                            phi_1833_ = select(_e1057, _e1056, vec3((_e958 >= _e962)));
                                                                        } else {
                                                                            phi_1833_ = _e1055;
                                                                        }
                                                                        let _e1164 = phi_1833_;
                                                                        let _e1175 = (((_e1146 * (_e1164.x - _e267)) + (_e1151 * (_e1164.y - _e336))) + (_e1154 * (_e1164.z - _e404)));
                                                                        let _e1180 = (((_e1146 * _e307) + (_e1151 * _e375)) + (_e1154 * _e443));
                                                                        let _e1181 = (_e1127 - _e1131);
                                                                        let _e1182 = (_e1125 - _e1129);
                                                                        let _e1190 = (-(((_e1131 * _e1181) + (_e1129 * _e1182))) / ((_e1181 * _e1181) + (_e1182 * _e1182)));
                                                                        let _e1192 = select(1f, _e1190, (_e1190 < 1f));
                                                                        let _e1194 = select(0f, _e1192, (_e1192 > 0f));
                                                                        let _e1207 = ((_e1133.x + (_e1139.x * _e1194)) - _e267);
                                                                        let _e1208 = ((_e1133.y + (_e1139.y * _e1194)) - _e336);
                                                                        let _e1209 = ((_e1133.z + (_e1139.z * _e1194)) - _e404);
                                                                        let _e1210 = (_e1209 / _e443);
                                                                        let _e1222 = bitcast<f32>((bitcast<u32>(_e1207) & 2147483647u));
                                                                        let _e1225 = bitcast<f32>((bitcast<u32>(_e1208) & 2147483647u));
                                                                        let _e1227 = select(_e1225, _e1222, (_e1222 > _e1225));
                                                                        let _e1230 = bitcast<f32>((bitcast<u32>(_e1209) & 2147483647u));
                                                                        let _e1232 = select(_e1230, _e1227, (_e1227 > _e1230));
                                                                        let _e1238 = bitcast<f32>((bitcast<u32>(_e1146) & 2147483647u));
                                                                        let _e1241 = bitcast<f32>((bitcast<u32>(_e1151) & 2147483647u));
                                                                        let _e1243 = select(_e1241, _e1238, (_e1238 > _e1241));
                                                                        let _e1246 = bitcast<f32>((bitcast<u32>(_e1154) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1146 * _e1207) + (_e1151 * _e1208)) + (_e1154 * _e1209)) - _e1175)) & 2147483647u)) <= ((0.0000009536743f * select(_e1112, _e1232, (_e1232 > _e1112))) * select(_e1246, _e1243, (_e1243 > _e1246)))) {
                                                                            let _e1256 = bitcast<f32>((bitcast<u32>(_e1137.x) & 2147483647u));
                                                                            let _e1259 = bitcast<f32>((bitcast<u32>(_e1137.y) & 2147483647u));
                                                                            let _e1261 = select(_e1259, _e1256, (_e1256 > _e1259));
                                                                            let _e1264 = bitcast<f32>((bitcast<u32>(_e1137.z) & 2147483647u));
                                                                            let _e1270 = bitcast<f32>((bitcast<u32>(_e1135.x) & 2147483647u));
                                                                            let _e1273 = bitcast<f32>((bitcast<u32>(_e1135.y) & 2147483647u));
                                                                            let _e1275 = select(_e1273, _e1270, (_e1270 > _e1273));
                                                                            let _e1278 = bitcast<f32>((bitcast<u32>(_e1135.z) & 2147483647u));
                                                                            let _e1282 = (bitcast<f32>((bitcast<u32>(_e1180) & 2147483647u)) > ((0.0000038146973f * select(_e1264, _e1261, (_e1261 > _e1264))) * select(_e1278, _e1275, (_e1275 > _e1278))));
                                                                            if _e1282 {
                                                                                phi_1998_ = (_e1175 / _e1180);
                                                                            } else {
                                                                                phi_1998_ = f32();
                                                                            }
                                                                            let _e1285 = phi_1998_;
                                                                            phi_2000_ = _e1285;
                                                                            phi_2001_ = select(true, false, _e1282);
                                                                        } else {
                                                                            phi_2000_ = f32();
                                                                            phi_2001_ = true;
                                                                        }
                                                                        let _e1288 = phi_2000_;
                                                                        let _e1290 = phi_2001_;
                                                                        if _e1290 {
                                                                            let _e1298 = (((_e1146 * (_e1207 - (_e307 * _e1210))) + (_e1151 * (_e1208 - (_e375 * _e1210)))) / _e1180);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1298) & 2147483647u)) <= _e1112) {
                                                                                phi_2021_ = (_e1210 + _e1298);
                                                                            } else {
                                                                                phi_2021_ = _e1210;
                                                                            }
                                                                            let _e1305 = phi_2021_;
                                                                            phi_2022_ = _e1305;
                                                                        } else {
                                                                            phi_2022_ = _e1288;
                                                                        }
                                                                        let _e1307 = phi_2022_;
                                                                        let _e1309 = select(_e1045, _e1307, (_e1307 < _e1045));
                                                                        let _e1311 = select(_e1037, _e1309, (_e1309 > _e1037));
                                                                        if (_e1311 >= _e558) {
                                                                            let _e1313 = (_e1311 <= _e793.member_1);
                                                                            if _e1313 {
                                                                                let _e1314 = (1f / _e964);
                                                                                phi_2045_ = type_23(_e1311, (_e958 * _e1314), (_e962 * _e1314), _e822);
                                                                            } else {
                                                                                phi_2045_ = type_23();
                                                                            }
                                                                            let _e1319 = phi_2045_;
                                                                            phi_2047_ = _e1319;
                                                                            phi_2048_ = select(true, false, _e1313);
                                                                        } else {
                                                                            phi_2047_ = type_23();
                                                                            phi_2048_ = true;
                                                                        }
                                                                        let _e1322 = phi_2047_;
                                                                        let _e1324 = phi_2048_;
                                                                        if _e1324 {
                                                                            phi_2052_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2052_ = _e1322;
                                                                        }
                                                                        let _e1326 = phi_2052_;
                                                                        phi_2053_ = _e1326;
                                                                    }
                                                                    let _e1328 = phi_2053_;
                                                                    phi_2054_ = _e1328;
                                                                    phi_2055_ = _e1054;
                                                                }
                                                                let _e1330 = phi_2054_;
                                                                let _e1332 = phi_2055_;
                                                                phi_2059_ = _e1330;
                                                                phi_2060_ = _e1332;
                                                            }
                                                            let _e1334 = phi_2059_;
                                                            let _e1336 = phi_2060_;
                                                            phi_2061_ = _e1334;
                                                            phi_2062_ = _e989;
                                                            phi_2063_ = _e1336;
                                                        }
                                                        let _e1338 = phi_2061_;
                                                        let _e1340 = phi_2062_;
                                                        let _e1342 = phi_2063_;
                                                        phi_2064_ = _e1338;
                                                        phi_2065_ = _e1340;
                                                        phi_2066_ = _e1342;
                                                    }
                                                    let _e1344 = phi_2064_;
                                                    let _e1346 = phi_2065_;
                                                    let _e1348 = phi_2066_;
                                                    phi_2074_ = _e1344;
                                                    phi_2075_ = select(_e1348, true, _e1346);
                                                } else {
                                                    phi_2074_ = type_23();
                                                    phi_2075_ = true;
                                                }
                                                let _e1351 = phi_2074_;
                                                let _e1353 = phi_2075_;
                                                if _e1353 {
                                                    phi_2079_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2079_ = _e1351;
                                                }
                                                let _e1355 = phi_2079_;
                                                if (_e1355.member_3 != 4294967295u) {
                                                    if (_e822 != 4294967295u) {
                                                        if (_e1355.member < _e793.member.member) {
                                                            phi_2105_ = true;
                                                        } else {
                                                            if (_e1355.member == _e793.member.member) {
                                                                phi_2104_ = (_e1355.member_3 < _e793.member.member_3);
                                                            } else {
                                                                phi_2104_ = false;
                                                            }
                                                            let _e1368 = phi_2104_;
                                                            phi_2105_ = _e1368;
                                                        }
                                                        let _e1370 = phi_2105_;
                                                        if _e1370 {
                                                            phi_2111_ = type_40(_e1355, _e1355.member);
                                                        } else {
                                                            phi_2111_ = _e793;
                                                        }
                                                        let _e1373 = phi_2111_;
                                                        phi_2112_ = _e1373;
                                                    } else {
                                                        phi_2112_ = _e793;
                                                    }
                                                    let _e1375 = phi_2112_;
                                                    phi_2113_ = _e1375;
                                                } else {
                                                    phi_2113_ = _e793;
                                                }
                                                let _e1377 = phi_2113_;
                                                phi_1042_ = _e1377;
                                            } else {
                                                phi_1042_ = type_40();
                                            }
                                            let _e1379 = phi_1042_;
                                            continue;
                                            continuing {
                                                phi_1041_ = _e1379;
                                                phi_1044_ = _e808;
                                                phi_2784_ = _e566;
                                                break if !(_e814);
                                            }
                                        }
                                        let _e1382 = phi_2784_;
                                        phi_2944_ = _e1382;
                                        if _e1382 {
                                            break;
                                        }
                                        phi_2948_ = _e1382;
                                        let _e1668 = local_3;
                                        phi_2599_ = _e1668;
                                        phi_2600_ = false;
                                        phi_2601_ = _e593;
                                        phi_2602_ = _e595;
                                    } else {
                                        if (_e595 >= _e75) {
                                            phi_2183_ = type_44(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e595 < _e75) {
                                            } else {
                                                phi_2944_ = true;
                                                break;
                                            }
                                            let _e605 = (_e203 % 3u);
                                            if (_e605 < 3u) {
                                            } else {
                                                phi_2944_ = true;
                                                break;
                                            }
                                            let _e611 = global_2.member[_e595].member[_e605];
                                            let _e617 = (_e202 % 3u);
                                            if (_e617 < 3u) {
                                            } else {
                                                phi_2944_ = true;
                                                break;
                                            }
                                            let _e623 = global_2.member[_e595].member[_e617];
                                            let _e629 = (_e204 % 3u);
                                            if (_e629 < 3u) {
                                            } else {
                                                phi_2944_ = true;
                                                break;
                                            }
                                            let _e635 = global_2.member[_e595].member[_e629];
                                            let _e645 = global_2.member[_e595].member_1;
                                            let _e649 = global_2.member[_e595].member_2;
                                            phi_2183_ = type_44(array<vec4<f32>, 3>(vec4<f32>(_e611[0], _e611[1], _e611[2], _e611[3]), vec4<f32>(_e623[0], _e623[1], _e623[2], _e623[3]), vec4<f32>(_e635[0], _e635[1], _e635[2], _e635[3])), _e645, _e649);
                                        }
                                        let _e652 = phi_2183_;
                                        let _e664 = ((_e652.member[0].x - _e305) * _e310);
                                        let _e665 = ((_e652.member[0].y - _e305) * _e310);
                                        let _e666 = ((_e652.member[0].z - _e306) * _e310);
                                        let _e667 = ((_e652.member[0].w - _e306) * _e310);
                                        let _e677 = ((_e652.member[1].x - _e373) * _e378);
                                        let _e678 = ((_e652.member[1].y - _e373) * _e378);
                                        let _e679 = ((_e652.member[1].z - _e374) * _e378);
                                        let _e680 = ((_e652.member[1].w - _e374) * _e378);
                                        let _e690 = ((_e652.member[2].x - _e441) * _e446);
                                        let _e691 = ((_e652.member[2].y - _e441) * _e446);
                                        let _e692 = ((_e652.member[2].z - _e442) * _e446);
                                        let _e693 = ((_e652.member[2].w - _e442) * _e446);
                                        let _e695 = select(_e692, _e690, (_e690 < _e692));
                                        let _e697 = select(_e693, _e691, (_e691 < _e693));
                                        let _e699 = select(_e692, _e690, (_e690 > _e692));
                                        let _e701 = select(_e693, _e691, (_e691 > _e693));
                                        let _e703 = select(_e666, _e664, (_e664 < _e666));
                                        let _e705 = select(_e667, _e665, (_e665 < _e667));
                                        let _e707 = select(_e679, _e677, (_e677 < _e679));
                                        let _e709 = select(_e680, _e678, (_e678 < _e680));
                                        let _e711 = select(_e707, _e703, (_e703 > _e707));
                                        let _e713 = select(_e709, _e705, (_e705 > _e709));
                                        let _e715 = select(_e695, _e711, (_e711 > _e695));
                                        let _e717 = select(_e697, _e713, (_e713 > _e697));
                                        let _e719 = select(_e666, _e664, (_e664 > _e666));
                                        let _e721 = select(_e667, _e665, (_e665 > _e667));
                                        let _e723 = select(_e679, _e677, (_e677 > _e679));
                                        let _e725 = select(_e680, _e678, (_e678 > _e680));
                                        let _e727 = select(_e723, _e719, (_e719 < _e723));
                                        let _e729 = select(_e725, _e721, (_e721 < _e725));
                                        let _e734 = -(_e695);
                                        let _e735 = -(_e697);
                                        let _e742 = (select(_e699, _e727, (_e727 < _e699)) + (select(_e734, _e699, (_e699 > _e734)) * 0.0000019073523f));
                                        let _e743 = (select(_e701, _e729, (_e729 < _e701)) + (select(_e735, _e701, (_e701 > _e735)) * 0.0000019073523f));
                                        let _e745 = select(_e558, _e715, (_e715 > _e558));
                                        let _e747 = select(_e558, _e717, (_e717 > _e558));
                                        let _e752 = (_e745 <= select(_e568.member_1, _e742, (_e742 < _e568.member_1)));
                                        let _e753 = (_e747 <= select(_e568.member_1, _e743, (_e743 < _e568.member_1)));
                                        let _e754 = (_e745 <= _e747);
                                        if _e752 {
                                            if _e753 {
                                                if _e754 {
                                                    phi_2545_ = _e652.member_2;
                                                } else {
                                                    phi_2545_ = _e652.member_1;
                                                }
                                                let _e758 = phi_2545_;
                                                let _e761 = (_e593 % 128u);
                                                let _e762 = (_e761 < 128u);
                                                if _e762 {
                                                } else {
                                                    phi_2944_ = true;
                                                    break;
                                                }
                                                local_1[_e761] = _e758;
                                                if _e762 {
                                                } else {
                                                    phi_2944_ = true;
                                                    break;
                                                }
                                                local[_e761] = select(_e747, _e745, !(_e754));
                                                if _e754 {
                                                    phi_2573_ = _e652.member_1;
                                                } else {
                                                    phi_2573_ = _e652.member_2;
                                                }
                                                let _e769 = phi_2573_;
                                                phi_2574_ = (_e593 + 1u);
                                                phi_2575_ = _e769;
                                            } else {
                                                phi_2574_ = u32();
                                                phi_2575_ = u32();
                                            }
                                            let _e771 = phi_2574_;
                                            let _e773 = phi_2575_;
                                            phi_2577_ = _e771;
                                            phi_2578_ = _e773;
                                            phi_2579_ = select(true, false, _e753);
                                        } else {
                                            phi_2577_ = u32();
                                            phi_2578_ = u32();
                                            phi_2579_ = true;
                                        }
                                        let _e776 = phi_2577_;
                                        let _e778 = phi_2578_;
                                        let _e780 = phi_2579_;
                                        if _e780 {
                                            if _e752 {
                                                phi_2588_ = _e652.member_1;
                                            } else {
                                                phi_2588_ = _e652.member_2;
                                            }
                                            let _e784 = phi_2588_;
                                            phi_2593_ = select(_e753, true, _e752);
                                            phi_2595_ = _e784;
                                        } else {
                                            phi_2593_ = _e591;
                                            phi_2595_ = _e778;
                                        }
                                        let _e787 = phi_2593_;
                                        let _e789 = phi_2595_;
                                        phi_2948_ = _e566;
                                        phi_2599_ = _e568;
                                        phi_2600_ = _e787;
                                        phi_2601_ = select(_e776, _e593, _e780);
                                        phi_2602_ = _e789;
                                    }
                                    let _e1384 = phi_2948_;
                                    let _e1386 = phi_2599_;
                                    let _e1388 = phi_2600_;
                                    let _e1390 = phi_2601_;
                                    let _e1392 = phi_2602_;
                                    phi_2947_ = _e1384;
                                    phi_2603_ = _e1386;
                                    phi_2604_ = _e1388;
                                    phi_2605_ = (_e572 - 1u);
                                    phi_2606_ = _e1390;
                                    phi_2607_ = _e1392;
                                } else {
                                    phi_2947_ = _e566;
                                    phi_2603_ = _e568;
                                    phi_2604_ = _e591;
                                    phi_2605_ = _e572;
                                    phi_2606_ = _e593;
                                    phi_2607_ = _e595;
                                }
                                let _e1394 = phi_2947_;
                                let _e1396 = phi_2603_;
                                let _e1398 = phi_2604_;
                                let _e1400 = phi_2605_;
                                let _e1402 = phi_2606_;
                                let _e1404 = phi_2607_;
                                phi_2946_ = _e1394;
                                phi_2608_ = _e1396;
                                phi_2609_ = _e1398;
                                phi_2610_ = _e1400;
                                phi_2611_ = _e1402;
                                phi_2612_ = _e1404;
                            } else {
                                phi_2946_ = _e566;
                                phi_2608_ = type_40();
                                phi_2609_ = bool();
                                phi_2610_ = u32();
                                phi_2611_ = u32();
                                phi_2612_ = u32();
                            }
                            let _e1406 = phi_2946_;
                            let _e1408 = phi_2608_;
                            let _e1410 = phi_2609_;
                            let _e1412 = phi_2610_;
                            let _e1414 = phi_2611_;
                            let _e1416 = phi_2612_;
                            phi_2945_ = _e1406;
                            phi_973_ = _e1408;
                            phi_976_ = _e1410;
                            phi_978_ = _e1412;
                            phi_980_ = _e1414;
                            phi_982_ = _e1416;
                            phi_2613_ = _e580;
                        } else {
                            phi_2945_ = _e566;
                            phi_973_ = type_40();
                            phi_976_ = bool();
                            phi_978_ = u32();
                            phi_980_ = u32();
                            phi_982_ = u32();
                            phi_2613_ = false;
                        }
                        let _e1418 = phi_2945_;
                        let _e1420 = phi_973_;
                        let _e1422 = phi_976_;
                        let _e1424 = phi_978_;
                        let _e1426 = phi_980_;
                        let _e1428 = phi_982_;
                        let _e1430 = phi_2613_;
                        continue;
                        continuing {
                            phi_2790_ = _e1418;
                            phi_972_ = _e1420;
                            phi_975_ = _e1422;
                            phi_977_ = _e1424;
                            phi_979_ = _e1426;
                            phi_981_ = _e1428;
                            phi_2944_ = _e1418;
                            break if !(_e1430);
                        }
                    }
                    let _e1433 = phi_2944_;
                    if _e1433 {
                        break;
                    }
                    let _e1435 = local_2;
                    if (_e1435.member.member_3 != 4294967295u) {
                        let _e1440 = -(_e460);
                        let _e1441 = bitcast<u32>(_e1435.member.member);
                        let _e1445 = (bitcast<i32>((_e1441 >> bitcast<u32>(23i))) & 255i);
                        let _e1446 = (_e1445 + _e1440);
                        if (_e1445 == 255i) {
                            phi_2672_ = _e1435.member.member;
                        } else {
                            if (_e1445 > 0i) {
                                if (_e1446 > 0i) {
                                    let _e1450 = (_e1446 < 255i);
                                    if _e1450 {
                                        phi_2651_ = bitcast<f32>((_e1441 + bitcast<u32>((_e1440 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_2651_ = f32();
                                    }
                                    let _e1457 = phi_2651_;
                                    phi_2653_ = _e1457;
                                    phi_2654_ = select(true, false, _e1450);
                                } else {
                                    phi_2653_ = f32();
                                    phi_2654_ = true;
                                }
                                let _e1460 = phi_2653_;
                                let _e1462 = phi_2654_;
                                phi_2655_ = _e1460;
                                phi_2656_ = _e1462;
                            } else {
                                phi_2655_ = f32();
                                phi_2656_ = true;
                            }
                            let _e1464 = phi_2655_;
                            let _e1466 = phi_2656_;
                            if _e1466 {
                                let _e1467 = (_e1441 & 2147483648u);
                                let _e1474 = ((_e1441 & 8388607u) | (select(0u, 1u, ((_e1441 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e1478 = (_e1474 == 0u);
                                if _e1478 {
                                    phi_2779_ = bitcast<f32>(_e1467);
                                } else {
                                    let _e1483 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1474)), 32u, _e1478) - 8u);
                                    let _e1486 = (_e1474 << bitcast<u32>((_e1483 & 31u)));
                                    let _e1488 = ((_e1446 + select(0i, 1i, (_e1445 == 0i))) - bitcast<i32>(_e1483));
                                    if (_e1488 >= 255i) {
                                        phi_2769_ = bitcast<f32>((_e1467 | 2139095040u));
                                        phi_2770_ = f32();
                                        phi_2771_ = true;
                                    } else {
                                        let _e1490 = (_e1488 > 0i);
                                        if _e1490 {
                                            phi_2763_ = bitcast<f32>(((_e1467 | (bitcast<u32>(_e1488) << bitcast<u32>(23i))) | (_e1486 & 8388607u)));
                                            phi_2764_ = f32();
                                        } else {
                                            if (_e1488 < -24i) {
                                                phi_2729_ = 26u;
                                            } else {
                                                phi_2729_ = bitcast<u32>((1i - _e1488));
                                            }
                                            let _e1495 = phi_2729_;
                                            let _e1496 = (_e1495 & 31u);
                                            let _e1498 = (_e1486 >> bitcast<u32>(_e1496));
                                            let _e1502 = (_e1486 & ((1u << bitcast<u32>(_e1496)) - 1u));
                                            let _e1506 = (1u << bitcast<u32>(((_e1495 - 1u) & 31u)));
                                            if (_e1502 > _e1506) {
                                                phi_2750_ = true;
                                            } else {
                                                if (_e1502 == _e1506) {
                                                    phi_2747_ = ((_e1498 & 1u) == 1u);
                                                } else {
                                                    phi_2747_ = false;
                                                }
                                                let _e1512 = phi_2747_;
                                                phi_2750_ = _e1512;
                                            }
                                            let _e1514 = phi_2750_;
                                            phi_2763_ = f32();
                                            phi_2764_ = bitcast<f32>((_e1467 | (_e1498 + select(0u, 1u, _e1514))));
                                        }
                                        let _e1527 = phi_2763_;
                                        let _e1529 = phi_2764_;
                                        phi_2769_ = _e1527;
                                        phi_2770_ = _e1529;
                                        phi_2771_ = _e1490;
                                    }
                                    let _e1533 = phi_2769_;
                                    let _e1535 = phi_2770_;
                                    let _e1537 = phi_2771_;
                                    phi_2779_ = select(_e1535, _e1533, _e1537);
                                }
                                let _e1541 = phi_2779_;
                                phi_2671_ = _e1541;
                            } else {
                                phi_2671_ = _e1464;
                            }
                            let _e1543 = phi_2671_;
                            phi_2672_ = _e1543;
                        }
                        let _e1545 = phi_2672_;
                        let _e1546 = bitcast<u32>(_e1545);
                        if ((_e1546 & 2147483647u) >= 2139095040u) {
                            phi_2684_ = bitcast<f32>(((_e1546 & 2147483648u) | 2139095039u));
                        } else {
                            phi_2684_ = _e1545;
                        }
                        let _e1553 = phi_2684_;
                        phi_2689_ = type_23(_e1553, _e1435.member.member_1, _e1435.member.member_2, _e1435.member.member_3);
                    } else {
                        phi_2689_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1558 = phi_2689_;
                    if _e91 {
                    } else {
                        break;
                    }
                    global_5.member[_e85] = _e1558;
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_closest(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
