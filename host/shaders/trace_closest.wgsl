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
    var phi_2794_: bool;
    var phi_972_: type_40;
    var phi_975_: u32;
    var phi_977_: bool;
    var phi_979_: u32;
    var phi_981_: u32;
    var phi_992_: bool;
    var phi_1024_: bool;
    var phi_1025_: u32;
    var phi_1026_: u32;
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
    var phi_2788_: bool;
    var phi_2983_: bool;
    var phi_2114_: type_40;
    var phi_2179_: type_44;
    var phi_2541_: u32;
    var phi_2568_: u32;
    var phi_2569_: u32;
    var phi_2570_: u32;
    var phi_2572_: u32;
    var phi_2573_: u32;
    var phi_2574_: bool;
    var phi_2583_: u32;
    var phi_2588_: bool;
    var phi_2590_: u32;
    var phi_2594_: bool;
    var phi_2595_: u32;
    var phi_2596_: u32;
    var phi_2951_: bool;
    var phi_2607_: type_40;
    var phi_2608_: u32;
    var phi_2609_: bool;
    var phi_2610_: u32;
    var phi_2611_: u32;
    var phi_2950_: bool;
    var phi_2612_: type_40;
    var phi_2613_: u32;
    var phi_2614_: bool;
    var phi_2615_: u32;
    var phi_2616_: u32;
    var phi_2949_: bool;
    var phi_973_: type_40;
    var phi_976_: u32;
    var phi_978_: bool;
    var phi_980_: u32;
    var phi_982_: u32;
    var phi_2617_: bool;
    var phi_2948_: bool;
    var local_2: type_40;
    var phi_2655_: f32;
    var phi_2657_: f32;
    var phi_2658_: bool;
    var phi_2659_: f32;
    var phi_2660_: bool;
    var phi_2733_: u32;
    var phi_2751_: bool;
    var phi_2754_: bool;
    var phi_2767_: f32;
    var phi_2768_: f32;
    var phi_2773_: f32;
    var phi_2774_: f32;
    var phi_2775_: bool;
    var phi_2783_: f32;
    var phi_2675_: f32;
    var phi_2676_: f32;
    var phi_2688_: f32;
    var phi_2693_: type_23;
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
                    phi_2794_ = false;
                    phi_972_ = type_40(type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e556);
                    phi_975_ = ((3u * _e75) + 1u);
                    phi_977_ = (_e558 <= _e556);
                    phi_979_ = 0u;
                    phi_981_ = select(0u, 2147483648u, (_e75 == 0u));
                    loop {
                        let _e566 = phi_2794_;
                        let _e568 = phi_972_;
                        let _e570 = phi_975_;
                        let _e572 = phi_977_;
                        let _e574 = phi_979_;
                        let _e576 = phi_981_;
                        local_2 = _e568;
                        if _e572 {
                            phi_992_ = true;
                        } else {
                            phi_992_ = (_e574 > 0u);
                        }
                        let _e579 = phi_992_;
                        if _e579 {
                            let _e580 = (_e570 > 0u);
                            if _e580 {
                                if _e572 {
                                    phi_1024_ = _e572;
                                    phi_1025_ = _e574;
                                    phi_1026_ = _e576;
                                } else {
                                    let _e581 = (_e574 - 1u);
                                    let _e582 = (_e581 % 128u);
                                    let _e583 = (_e582 < 128u);
                                    if _e583 {
                                    } else {
                                        phi_2948_ = true;
                                        break;
                                    }
                                    let _e585 = local_1[_e582];
                                    if _e583 {
                                    } else {
                                        phi_2948_ = true;
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
                                    let _e598 = ((_e595 & 2147483648u) != 0u);
                                    if _e598 {
                                        phi_1041_ = _e568;
                                        phi_1044_ = type_4(0u, ((_e595 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e605 = phi_1041_;
                                            let _e607 = phi_1044_;
                                            local_3 = _e605;
                                            if (_e607.member < _e607.member_1) {
                                                phi_1045_ = type_4((_e607.member + 1u), _e607.member_1);
                                                phi_1067_ = type_4(1u, _e607.member);
                                            } else {
                                                phi_1045_ = _e607;
                                                phi_1067_ = type_4(0u, type_4().member_1);
                                            }
                                            let _e620 = phi_1045_;
                                            let _e622 = phi_1067_;
                                            let _e626 = (bitcast<i32>(_e622.member) != 0i);
                                            if _e626 {
                                                let _e627 = ((_e595 & 268435455u) + _e622.member_1);
                                                let _e628 = (_e627 < _e77);
                                                if _e628 {
                                                    if _e628 {
                                                    } else {
                                                        phi_2788_ = true;
                                                        break;
                                                    }
                                                    let _e632 = global_3.member[_e627].member_1;
                                                    phi_1088_ = _e632;
                                                } else {
                                                    phi_1088_ = 4294967295u;
                                                }
                                                let _e634 = phi_1088_;
                                                if (_e627 >= _e77) {
                                                    phi_1180_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e628 {
                                                    } else {
                                                        phi_2788_ = true;
                                                        break;
                                                    }
                                                    let _e636 = (_e203 % 3u);
                                                    let _e637 = (_e202 % 3u);
                                                    let _e638 = (_e204 % 3u);
                                                    if (_e636 < 9u) {
                                                    } else {
                                                        phi_2788_ = true;
                                                        break;
                                                    }
                                                    let _e644 = global_3.member[_e627].member[_e636];
                                                    if (_e637 < 9u) {
                                                    } else {
                                                        phi_2788_ = true;
                                                        break;
                                                    }
                                                    let _e650 = global_3.member[_e627].member[_e637];
                                                    if (_e638 < 9u) {
                                                    } else {
                                                        phi_2788_ = true;
                                                        break;
                                                    }
                                                    let _e656 = global_3.member[_e627].member[_e638];
                                                    let _e658 = (3u + _e636);
                                                    if (_e658 < 9u) {
                                                    } else {
                                                        phi_2788_ = true;
                                                        break;
                                                    }
                                                    let _e664 = global_3.member[_e627].member[_e658];
                                                    let _e665 = (3u + _e637);
                                                    if (_e665 < 9u) {
                                                    } else {
                                                        phi_2788_ = true;
                                                        break;
                                                    }
                                                    let _e671 = global_3.member[_e627].member[_e665];
                                                    let _e672 = (3u + _e638);
                                                    if (_e672 < 9u) {
                                                    } else {
                                                        phi_2788_ = true;
                                                        break;
                                                    }
                                                    let _e678 = global_3.member[_e627].member[_e672];
                                                    let _e680 = (6u + _e636);
                                                    if (_e680 < 9u) {
                                                    } else {
                                                        phi_2788_ = true;
                                                        break;
                                                    }
                                                    let _e686 = global_3.member[_e627].member[_e680];
                                                    let _e687 = (6u + _e637);
                                                    if (_e687 < 9u) {
                                                    } else {
                                                        phi_2788_ = true;
                                                        break;
                                                    }
                                                    let _e693 = global_3.member[_e627].member[_e687];
                                                    let _e694 = (6u + _e638);
                                                    if (_e694 < 9u) {
                                                    } else {
                                                        phi_2788_ = true;
                                                        break;
                                                    }
                                                    let _e700 = global_3.member[_e627].member[_e694];
                                                    phi_1180_ = array<array<f32, 3>, 3>(array<f32, 3>(_e644, _e650, _e656), array<f32, 3>(_e664, _e671, _e678), array<f32, 3>(_e686, _e693, _e700));
                                                }
                                                let _e704 = phi_1180_;
                                                let _e712 = (_e704[0][2] - _e404);
                                                let _e715 = (((_e704[0][0] - _e267) * _e443) - (_e712 * _e307));
                                                let _e718 = (((_e704[0][1] - _e336) * _e443) - (_e712 * _e375));
                                                let _e725 = (_e704[1][2] - _e404);
                                                let _e728 = (((_e704[1][0] - _e267) * _e443) - (_e725 * _e307));
                                                let _e731 = (((_e704[1][1] - _e336) * _e443) - (_e725 * _e375));
                                                let _e738 = (_e704[2][2] - _e404);
                                                let _e741 = (((_e704[2][0] - _e267) * _e443) - (_e738 * _e307));
                                                let _e744 = (((_e704[2][1] - _e336) * _e443) - (_e738 * _e375));
                                                let _e745 = (_e741 * _e731);
                                                let _e746 = (_e744 * _e728);
                                                let _e747 = (_e715 * _e744);
                                                let _e748 = (_e718 * _e741);
                                                let _e749 = (_e728 * _e718);
                                                let _e750 = (_e731 * _e715);
                                                let _e755 = (((_e745 >= _e746) && (_e747 >= _e748)) && (_e749 >= _e750));
                                                if (_e755 || (((_e745 <= _e746) && (_e747 <= _e748)) && (_e749 <= _e750))) {
                                                    let _e762 = select(-1f, 1f, _e755);
                                                    let _e764 = ((_e745 - _e746) * _e762);
                                                    let _e766 = select(0f, _e764, (_e764 > 0f));
                                                    let _e768 = ((_e747 - _e748) * _e762);
                                                    let _e770 = select(0f, _e768, (_e768 > 0f));
                                                    let _e772 = ((_e749 - _e750) * _e762);
                                                    let _e774 = select(0f, _e772, (_e772 > 0f));
                                                    let _e776 = ((_e766 + _e770) + _e774);
                                                    if (_e776 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2064_ = type_23();
                                                        phi_2065_ = true;
                                                        phi_2066_ = false;
                                                    } else {
                                                        let _e779 = select(_e728, _e715, (_e715 < _e728));
                                                        if (select(_e741, _e779, (_e779 < _e741)) > 0f) {
                                                            phi_1332_ = true;
                                                        } else {
                                                            let _e784 = select(_e728, _e715, (_e715 > _e728));
                                                            phi_1332_ = (select(_e741, _e784, (_e784 > _e741)) < 0f);
                                                        }
                                                        let _e789 = phi_1332_;
                                                        if _e789 {
                                                            phi_2061_ = type_23();
                                                            phi_2062_ = true;
                                                            phi_2063_ = false;
                                                        } else {
                                                            let _e791 = select(_e731, _e718, (_e718 < _e731));
                                                            if (select(_e744, _e791, (_e791 < _e744)) > 0f) {
                                                                phi_1361_ = true;
                                                            } else {
                                                                let _e796 = select(_e731, _e718, (_e718 > _e731));
                                                                phi_1361_ = (select(_e744, _e796, (_e796 > _e744)) < 0f);
                                                            }
                                                            let _e801 = phi_1361_;
                                                            if _e801 {
                                                                phi_2059_ = type_23();
                                                                phi_2060_ = false;
                                                            } else {
                                                                let _e803 = select(_e704[1][0], _e704[0][0], (_e704[0][0] < _e704[1][0]));
                                                                let _e807 = select(_e704[1][0], _e704[0][0], (_e704[0][0] > _e704[1][0]));
                                                                let _e811 = select(_e704[1][1], _e704[0][1], (_e704[0][1] < _e704[1][1]));
                                                                let _e815 = select(_e704[1][1], _e704[0][1], (_e704[0][1] > _e704[1][1]));
                                                                let _e819 = select(_e704[1][2], _e704[0][2], (_e704[0][2] < _e704[1][2]));
                                                                let _e823 = select(_e704[1][2], _e704[0][2], (_e704[0][2] > _e704[1][2]));
                                                                let _e828 = ((select(_e704[2][0], _e803, (_e803 < _e704[2][0])) - _e305) * _e310);
                                                                let _e829 = ((select(_e704[2][0], _e807, (_e807 > _e704[2][0])) - _e306) * _e310);
                                                                let _e832 = ((select(_e704[2][1], _e811, (_e811 < _e704[2][1])) - _e373) * _e378);
                                                                let _e833 = ((select(_e704[2][1], _e815, (_e815 > _e704[2][1])) - _e374) * _e378);
                                                                let _e836 = ((select(_e704[2][2], _e819, (_e819 < _e704[2][2])) - _e441) * _e446);
                                                                let _e837 = ((select(_e704[2][2], _e823, (_e823 > _e704[2][2])) - _e442) * _e446);
                                                                let _e839 = select(_e837, _e836, (_e836 < _e837));
                                                                let _e841 = select(_e837, _e836, (_e836 > _e837));
                                                                let _e843 = select(_e829, _e828, (_e828 < _e829));
                                                                let _e845 = select(_e833, _e832, (_e832 < _e833));
                                                                let _e847 = select(_e845, _e843, (_e843 > _e845));
                                                                let _e849 = select(_e839, _e847, (_e847 > _e839));
                                                                let _e851 = select(_e829, _e828, (_e828 > _e829));
                                                                let _e853 = select(_e833, _e832, (_e832 > _e833));
                                                                let _e855 = select(_e853, _e851, (_e851 < _e853));
                                                                let _e857 = select(_e841, _e855, (_e855 < _e841));
                                                                let _e858 = -(_e839);
                                                                let _e864 = select(_e558, _e849, (_e849 > _e558));
                                                                if (_e864 > (_e857 + (select(_e858, _e841, (_e841 > _e858)) * 0.0000019073523f))) {
                                                                    phi_2054_ = type_23();
                                                                    phi_2055_ = true;
                                                                } else {
                                                                    let _e866 = (_e864 > _e605.member_1);
                                                                    if _e866 {
                                                                        phi_2053_ = type_23();
                                                                    } else {
                                                                        let _e867 = vec3<f32>(_e704[0][0], _e704[0][1], _e704[0][2]);
                                                                        let _e868 = vec3<f32>(_e704[1][0], _e704[1][1], _e704[1][2]);
                                                                        let _e869 = vec3<f32>(_e704[2][0], _e704[2][1], _e704[2][2]);
                                                                        let _e870 = (_e704[1][0] - _e704[0][0]);
                                                                        let _e871 = (_e704[1][1] - _e704[0][1]);
                                                                        let _e872 = (_e704[1][2] - _e704[0][2]);
                                                                        let _e873 = vec3<f32>(_e870, _e871, _e872);
                                                                        let _e874 = (_e704[2][0] - _e704[1][0]);
                                                                        let _e875 = (_e704[2][1] - _e704[1][1]);
                                                                        let _e876 = (_e704[2][2] - _e704[1][2]);
                                                                        let _e877 = vec3<f32>(_e874, _e875, _e876);
                                                                        let _e878 = (_e704[0][0] - _e704[2][0]);
                                                                        let _e879 = (_e704[0][1] - _e704[2][1]);
                                                                        let _e880 = (_e704[0][2] - _e704[2][2]);
                                                                        let _e881 = vec3<f32>(_e878, _e879, _e880);
                                                                        let _e884 = bitcast<f32>((bitcast<u32>(_e870) & 2147483647u));
                                                                        let _e887 = bitcast<f32>((bitcast<u32>(_e871) & 2147483647u));
                                                                        let _e889 = select(_e887, _e884, (_e884 > _e887));
                                                                        let _e892 = bitcast<f32>((bitcast<u32>(_e872) & 2147483647u));
                                                                        let _e894 = select(_e892, _e889, (_e889 > _e892));
                                                                        let _e897 = bitcast<f32>((bitcast<u32>(_e874) & 2147483647u));
                                                                        let _e900 = bitcast<f32>((bitcast<u32>(_e875) & 2147483647u));
                                                                        let _e902 = select(_e900, _e897, (_e897 > _e900));
                                                                        let _e905 = bitcast<f32>((bitcast<u32>(_e876) & 2147483647u));
                                                                        let _e907 = select(_e905, _e902, (_e902 > _e905));
                                                                        let _e910 = bitcast<f32>((bitcast<u32>(_e878) & 2147483647u));
                                                                        let _e913 = bitcast<f32>((bitcast<u32>(_e879) & 2147483647u));
                                                                        let _e915 = select(_e913, _e910, (_e910 > _e913));
                                                                        let _e918 = bitcast<f32>((bitcast<u32>(_e880) & 2147483647u));
                                                                        let _e920 = select(_e918, _e915, (_e915 > _e918));
                                                                        let _e922 = select(_e907, _e894, (_e894 > _e907));
                                                                        let _e924 = select(_e920, _e922, (_e922 > _e920));
                                                                        if (_e894 == _e924) {
                                                                            phi_1780_ = _e731;
                                                                            phi_1781_ = _e728;
                                                                            phi_1782_ = _e718;
                                                                            phi_1783_ = _e715;
                                                                            phi_1784_ = _e867;
                                                                            phi_1785_ = _e881;
                                                                            phi_1786_ = _e877;
                                                                            phi_1787_ = _e873;
                                                                        } else {
                                                                            let _e926 = (_e907 == _e924);
                                                                            let _e931 = vec3(_e926);
                                                                            phi_1780_ = select(_e718, _e744, _e926);
                                                                            phi_1781_ = select(_e715, _e741, _e926);
                                                                            phi_1782_ = select(_e744, _e731, _e926);
                                                                            phi_1783_ = select(_e741, _e728, _e926);
                                                                            phi_1784_ = select(_e869, _e868, _e931);
                                                                            phi_1785_ = select(_e877, _e873, _e931);
                                                                            phi_1786_ = select(_e873, _e881, _e931);
                                                                            phi_1787_ = select(_e881, _e877, _e931);
                                                                        }
                                                                        let _e937 = phi_1780_;
                                                                        let _e939 = phi_1781_;
                                                                        let _e941 = phi_1782_;
                                                                        let _e943 = phi_1783_;
                                                                        let _e945 = phi_1784_;
                                                                        let _e947 = phi_1785_;
                                                                        let _e949 = phi_1786_;
                                                                        let _e951 = phi_1787_;
                                                                        let _e958 = ((_e949.y * _e947.z) - (_e947.y * _e949.z));
                                                                        let _e963 = ((_e949.z * _e947.x) - (_e947.z * _e949.x));
                                                                        let _e966 = ((_e949.x * _e947.y) - (_e947.x * _e949.y));
                                                                        if (_e766 >= _e770) {
                                                                            phi_1824_ = select(true, false, (_e766 >= _e774));
                                                                        } else {
                                                                            phi_1824_ = true;
                                                                        }
                                                                        let _e971 = phi_1824_;
                                                                        if _e971 {
                                                                            phi_1833_ = select(_e869, _e868, vec3((_e770 >= _e774)));
                                                                        } else {
                                                                            phi_1833_ = _e867;
                                                                        }
                                                                        let _e976 = phi_1833_;
                                                                        let _e987 = (((_e958 * (_e976.x - _e267)) + (_e963 * (_e976.y - _e336))) + (_e966 * (_e976.z - _e404)));
                                                                        let _e992 = (((_e958 * _e307) + (_e963 * _e375)) + (_e966 * _e443));
                                                                        let _e993 = (_e939 - _e943);
                                                                        let _e994 = (_e937 - _e941);
                                                                        let _e1002 = (-(((_e943 * _e993) + (_e941 * _e994))) / ((_e993 * _e993) + (_e994 * _e994)));
                                                                        let _e1004 = select(1f, _e1002, (_e1002 < 1f));
                                                                        let _e1006 = select(0f, _e1004, (_e1004 > 0f));
                                                                        let _e1019 = ((_e945.x + (_e951.x * _e1006)) - _e267);
                                                                        let _e1020 = ((_e945.y + (_e951.y * _e1006)) - _e336);
                                                                        let _e1021 = ((_e945.z + (_e951.z * _e1006)) - _e404);
                                                                        let _e1022 = (_e1021 / _e443);
                                                                        let _e1034 = bitcast<f32>((bitcast<u32>(_e1019) & 2147483647u));
                                                                        let _e1037 = bitcast<f32>((bitcast<u32>(_e1020) & 2147483647u));
                                                                        let _e1039 = select(_e1037, _e1034, (_e1034 > _e1037));
                                                                        let _e1042 = bitcast<f32>((bitcast<u32>(_e1021) & 2147483647u));
                                                                        let _e1044 = select(_e1042, _e1039, (_e1039 > _e1042));
                                                                        let _e1050 = bitcast<f32>((bitcast<u32>(_e958) & 2147483647u));
                                                                        let _e1053 = bitcast<f32>((bitcast<u32>(_e963) & 2147483647u));
                                                                        let _e1055 = select(_e1053, _e1050, (_e1050 > _e1053));
                                                                        let _e1058 = bitcast<f32>((bitcast<u32>(_e966) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e958 * _e1019) + (_e963 * _e1020)) + (_e966 * _e1021)) - _e987)) & 2147483647u)) <= ((0.0000009536743f * select(_e924, _e1044, (_e1044 > _e924))) * select(_e1058, _e1055, (_e1055 > _e1058)))) {
                                                                            let _e1068 = bitcast<f32>((bitcast<u32>(_e949.x) & 2147483647u));
                                                                            let _e1071 = bitcast<f32>((bitcast<u32>(_e949.y) & 2147483647u));
                                                                            let _e1073 = select(_e1071, _e1068, (_e1068 > _e1071));
                                                                            let _e1076 = bitcast<f32>((bitcast<u32>(_e949.z) & 2147483647u));
                                                                            let _e1082 = bitcast<f32>((bitcast<u32>(_e947.x) & 2147483647u));
                                                                            let _e1085 = bitcast<f32>((bitcast<u32>(_e947.y) & 2147483647u));
                                                                            let _e1087 = select(_e1085, _e1082, (_e1082 > _e1085));
                                                                            let _e1090 = bitcast<f32>((bitcast<u32>(_e947.z) & 2147483647u));
                                                                            let _e1094 = (bitcast<f32>((bitcast<u32>(_e992) & 2147483647u)) > ((0.0000038146973f * select(_e1076, _e1073, (_e1073 > _e1076))) * select(_e1090, _e1087, (_e1087 > _e1090))));
                                                                            if _e1094 {
                                                                                phi_1998_ = (_e987 / _e992);
                                                                            } else {
                                                                                phi_1998_ = f32();
                                                                            }
                                                                            let _e1097 = phi_1998_;
                                                                            phi_2000_ = _e1097;
                                                                            phi_2001_ = select(true, false, _e1094);
                                                                        } else {
                                                                            phi_2000_ = f32();
                                                                            phi_2001_ = true;
                                                                        }
                                                                        let _e1100 = phi_2000_;
                                                                        let _e1102 = phi_2001_;
                                                                        if _e1102 {
                                                                            let _e1110 = (((_e958 * (_e1019 - (_e307 * _e1022))) + (_e963 * (_e1020 - (_e375 * _e1022)))) / _e992);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1110) & 2147483647u)) <= _e924) {
                                                                                phi_2021_ = (_e1022 + _e1110);
                                                                            } else {
                                                                                phi_2021_ = _e1022;
                                                                            }
                                                                            let _e1117 = phi_2021_;
                                                                            phi_2022_ = _e1117;
                                                                        } else {
                                                                            phi_2022_ = _e1100;
                                                                        }
                                                                        let _e1119 = phi_2022_;
                                                                        let _e1121 = select(_e857, _e1119, (_e1119 < _e857));
                                                                        let _e1123 = select(_e849, _e1121, (_e1121 > _e849));
                                                                        if (_e1123 >= _e558) {
                                                                            let _e1125 = (_e1123 <= _e605.member_1);
                                                                            if _e1125 {
                                                                                let _e1126 = (1f / _e776);
                                                                                phi_2045_ = type_23(_e1123, (_e770 * _e1126), (_e774 * _e1126), _e634);
                                                                            } else {
                                                                                phi_2045_ = type_23();
                                                                            }
                                                                            let _e1131 = phi_2045_;
                                                                            phi_2047_ = _e1131;
                                                                            phi_2048_ = select(true, false, _e1125);
                                                                        } else {
                                                                            phi_2047_ = type_23();
                                                                            phi_2048_ = true;
                                                                        }
                                                                        let _e1134 = phi_2047_;
                                                                        let _e1136 = phi_2048_;
                                                                        if _e1136 {
                                                                            phi_2052_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2052_ = _e1134;
                                                                        }
                                                                        let _e1138 = phi_2052_;
                                                                        phi_2053_ = _e1138;
                                                                    }
                                                                    let _e1140 = phi_2053_;
                                                                    phi_2054_ = _e1140;
                                                                    phi_2055_ = _e866;
                                                                }
                                                                let _e1142 = phi_2054_;
                                                                let _e1144 = phi_2055_;
                                                                phi_2059_ = _e1142;
                                                                phi_2060_ = _e1144;
                                                            }
                                                            let _e1146 = phi_2059_;
                                                            let _e1148 = phi_2060_;
                                                            phi_2061_ = _e1146;
                                                            phi_2062_ = _e801;
                                                            phi_2063_ = _e1148;
                                                        }
                                                        let _e1150 = phi_2061_;
                                                        let _e1152 = phi_2062_;
                                                        let _e1154 = phi_2063_;
                                                        phi_2064_ = _e1150;
                                                        phi_2065_ = _e1152;
                                                        phi_2066_ = _e1154;
                                                    }
                                                    let _e1156 = phi_2064_;
                                                    let _e1158 = phi_2065_;
                                                    let _e1160 = phi_2066_;
                                                    phi_2074_ = _e1156;
                                                    phi_2075_ = select(_e1160, true, _e1158);
                                                } else {
                                                    phi_2074_ = type_23();
                                                    phi_2075_ = true;
                                                }
                                                let _e1163 = phi_2074_;
                                                let _e1165 = phi_2075_;
                                                if _e1165 {
                                                    phi_2079_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2079_ = _e1163;
                                                }
                                                let _e1167 = phi_2079_;
                                                if (_e1167.member_3 != 4294967295u) {
                                                    if (_e634 != 4294967295u) {
                                                        if (_e1167.member < _e605.member.member) {
                                                            phi_2105_ = true;
                                                        } else {
                                                            if (_e1167.member == _e605.member.member) {
                                                                phi_2104_ = (_e1167.member_3 < _e605.member.member_3);
                                                            } else {
                                                                phi_2104_ = false;
                                                            }
                                                            let _e1180 = phi_2104_;
                                                            phi_2105_ = _e1180;
                                                        }
                                                        let _e1182 = phi_2105_;
                                                        if _e1182 {
                                                            phi_2111_ = type_40(_e1167, _e1167.member);
                                                        } else {
                                                            phi_2111_ = _e605;
                                                        }
                                                        let _e1185 = phi_2111_;
                                                        phi_2112_ = _e1185;
                                                    } else {
                                                        phi_2112_ = _e605;
                                                    }
                                                    let _e1187 = phi_2112_;
                                                    phi_2113_ = _e1187;
                                                } else {
                                                    phi_2113_ = _e605;
                                                }
                                                let _e1189 = phi_2113_;
                                                phi_1042_ = _e1189;
                                            } else {
                                                phi_1042_ = type_40();
                                            }
                                            let _e1191 = phi_1042_;
                                            continue;
                                            continuing {
                                                phi_1041_ = _e1191;
                                                phi_1044_ = _e620;
                                                phi_2788_ = _e566;
                                                break if !(_e626);
                                            }
                                        }
                                        let _e1194 = phi_2788_;
                                        phi_2948_ = _e1194;
                                        if _e1194 {
                                            break;
                                        }
                                        phi_2983_ = _e1194;
                                        let _e1659 = local_3;
                                        phi_2114_ = _e1659;
                                    } else {
                                        phi_2983_ = _e566;
                                        phi_2114_ = _e568;
                                    }
                                    let _e1196 = phi_2983_;
                                    let _e1198 = phi_2114_;
                                    if _e598 {
                                        phi_2594_ = bool();
                                        phi_2595_ = u32();
                                        phi_2596_ = u32();
                                    } else {
                                        if (_e595 >= _e75) {
                                            phi_2179_ = type_44(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e595 < _e75) {
                                            } else {
                                                phi_2948_ = true;
                                                break;
                                            }
                                            let _e1201 = (_e203 % 3u);
                                            if (_e1201 < 3u) {
                                            } else {
                                                phi_2948_ = true;
                                                break;
                                            }
                                            let _e1207 = global_2.member[_e595].member[_e1201];
                                            let _e1213 = (_e202 % 3u);
                                            if (_e1213 < 3u) {
                                            } else {
                                                phi_2948_ = true;
                                                break;
                                            }
                                            let _e1219 = global_2.member[_e595].member[_e1213];
                                            let _e1225 = (_e204 % 3u);
                                            if (_e1225 < 3u) {
                                            } else {
                                                phi_2948_ = true;
                                                break;
                                            }
                                            let _e1231 = global_2.member[_e595].member[_e1225];
                                            let _e1241 = global_2.member[_e595].member_1;
                                            let _e1245 = global_2.member[_e595].member_2;
                                            phi_2179_ = type_44(array<vec4<f32>, 3>(vec4<f32>(_e1207[0], _e1207[1], _e1207[2], _e1207[3]), vec4<f32>(_e1219[0], _e1219[1], _e1219[2], _e1219[3]), vec4<f32>(_e1231[0], _e1231[1], _e1231[2], _e1231[3])), _e1241, _e1245);
                                        }
                                        let _e1248 = phi_2179_;
                                        let _e1260 = ((_e1248.member[0].x - _e305) * _e310);
                                        let _e1261 = ((_e1248.member[0].y - _e305) * _e310);
                                        let _e1262 = ((_e1248.member[0].z - _e306) * _e310);
                                        let _e1263 = ((_e1248.member[0].w - _e306) * _e310);
                                        let _e1273 = ((_e1248.member[1].x - _e373) * _e378);
                                        let _e1274 = ((_e1248.member[1].y - _e373) * _e378);
                                        let _e1275 = ((_e1248.member[1].z - _e374) * _e378);
                                        let _e1276 = ((_e1248.member[1].w - _e374) * _e378);
                                        let _e1286 = ((_e1248.member[2].x - _e441) * _e446);
                                        let _e1287 = ((_e1248.member[2].y - _e441) * _e446);
                                        let _e1288 = ((_e1248.member[2].z - _e442) * _e446);
                                        let _e1289 = ((_e1248.member[2].w - _e442) * _e446);
                                        let _e1291 = select(_e1288, _e1286, (_e1286 < _e1288));
                                        let _e1293 = select(_e1289, _e1287, (_e1287 < _e1289));
                                        let _e1295 = select(_e1288, _e1286, (_e1286 > _e1288));
                                        let _e1297 = select(_e1289, _e1287, (_e1287 > _e1289));
                                        let _e1299 = select(_e1262, _e1260, (_e1260 < _e1262));
                                        let _e1301 = select(_e1263, _e1261, (_e1261 < _e1263));
                                        let _e1303 = select(_e1275, _e1273, (_e1273 < _e1275));
                                        let _e1305 = select(_e1276, _e1274, (_e1274 < _e1276));
                                        let _e1307 = select(_e1303, _e1299, (_e1299 > _e1303));
                                        let _e1309 = select(_e1305, _e1301, (_e1301 > _e1305));
                                        let _e1311 = select(_e1291, _e1307, (_e1307 > _e1291));
                                        let _e1313 = select(_e1293, _e1309, (_e1309 > _e1293));
                                        let _e1315 = select(_e1262, _e1260, (_e1260 > _e1262));
                                        let _e1317 = select(_e1263, _e1261, (_e1261 > _e1263));
                                        let _e1319 = select(_e1275, _e1273, (_e1273 > _e1275));
                                        let _e1321 = select(_e1276, _e1274, (_e1274 > _e1276));
                                        let _e1323 = select(_e1319, _e1315, (_e1315 < _e1319));
                                        let _e1325 = select(_e1321, _e1317, (_e1317 < _e1321));
                                        let _e1330 = -(_e1291);
                                        let _e1331 = -(_e1293);
                                        let _e1338 = (select(_e1295, _e1323, (_e1323 < _e1295)) + (select(_e1330, _e1295, (_e1295 > _e1330)) * 0.0000019073523f));
                                        let _e1339 = (select(_e1297, _e1325, (_e1325 < _e1297)) + (select(_e1331, _e1297, (_e1297 > _e1331)) * 0.0000019073523f));
                                        let _e1341 = select(_e558, _e1311, (_e1311 > _e558));
                                        let _e1343 = select(_e558, _e1313, (_e1313 > _e558));
                                        let _e1348 = (_e1341 <= select(_e1198.member_1, _e1338, (_e1338 < _e1198.member_1)));
                                        let _e1349 = (_e1343 <= select(_e1198.member_1, _e1339, (_e1339 < _e1198.member_1)));
                                        let _e1350 = (_e1341 <= _e1343);
                                        if _e1348 {
                                            if _e1349 {
                                                if _e1350 {
                                                    phi_2541_ = _e1248.member_2;
                                                } else {
                                                    phi_2541_ = _e1248.member_1;
                                                }
                                                let _e1354 = phi_2541_;
                                                let _e1356 = (_e593 % 128u);
                                                let _e1357 = (_e1356 < 128u);
                                                if _e1357 {
                                                } else {
                                                    phi_2948_ = true;
                                                    break;
                                                }
                                                local_1[_e1356] = _e1354;
                                                if _e1357 {
                                                } else {
                                                    phi_2948_ = true;
                                                    break;
                                                }
                                                local[_e1356] = select(_e1341, _e1343, _e1350);
                                                if _e1350 {
                                                    phi_2568_ = _e1248.member_1;
                                                } else {
                                                    phi_2568_ = _e1248.member_2;
                                                }
                                                let _e1364 = phi_2568_;
                                                phi_2569_ = (_e593 + 1u);
                                                phi_2570_ = _e1364;
                                            } else {
                                                phi_2569_ = u32();
                                                phi_2570_ = u32();
                                            }
                                            let _e1366 = phi_2569_;
                                            let _e1368 = phi_2570_;
                                            phi_2572_ = _e1366;
                                            phi_2573_ = _e1368;
                                            phi_2574_ = select(true, false, _e1349);
                                        } else {
                                            phi_2572_ = u32();
                                            phi_2573_ = u32();
                                            phi_2574_ = true;
                                        }
                                        let _e1371 = phi_2572_;
                                        let _e1373 = phi_2573_;
                                        let _e1375 = phi_2574_;
                                        if _e1375 {
                                            if _e1348 {
                                                phi_2583_ = _e1248.member_1;
                                            } else {
                                                phi_2583_ = _e1248.member_2;
                                            }
                                            let _e1379 = phi_2583_;
                                            phi_2588_ = select(_e1349, true, _e1348);
                                            phi_2590_ = _e1379;
                                        } else {
                                            phi_2588_ = _e591;
                                            phi_2590_ = _e1373;
                                        }
                                        let _e1382 = phi_2588_;
                                        let _e1384 = phi_2590_;
                                        phi_2594_ = _e1382;
                                        phi_2595_ = select(_e1371, _e593, _e1375);
                                        phi_2596_ = _e1384;
                                    }
                                    let _e1387 = phi_2594_;
                                    let _e1389 = phi_2595_;
                                    let _e1391 = phi_2596_;
                                    phi_2951_ = _e1196;
                                    phi_2607_ = _e1198;
                                    phi_2608_ = (_e570 - 1u);
                                    phi_2609_ = select(_e1387, false, _e598);
                                    phi_2610_ = select(_e1389, _e593, _e598);
                                    phi_2611_ = select(_e1391, _e595, _e598);
                                } else {
                                    phi_2951_ = _e566;
                                    phi_2607_ = _e568;
                                    phi_2608_ = _e570;
                                    phi_2609_ = _e591;
                                    phi_2610_ = _e593;
                                    phi_2611_ = _e595;
                                }
                                let _e1396 = phi_2951_;
                                let _e1398 = phi_2607_;
                                let _e1400 = phi_2608_;
                                let _e1402 = phi_2609_;
                                let _e1404 = phi_2610_;
                                let _e1406 = phi_2611_;
                                phi_2950_ = _e1396;
                                phi_2612_ = _e1398;
                                phi_2613_ = _e1400;
                                phi_2614_ = _e1402;
                                phi_2615_ = _e1404;
                                phi_2616_ = _e1406;
                            } else {
                                phi_2950_ = _e566;
                                phi_2612_ = type_40();
                                phi_2613_ = u32();
                                phi_2614_ = bool();
                                phi_2615_ = u32();
                                phi_2616_ = u32();
                            }
                            let _e1408 = phi_2950_;
                            let _e1410 = phi_2612_;
                            let _e1412 = phi_2613_;
                            let _e1414 = phi_2614_;
                            let _e1416 = phi_2615_;
                            let _e1418 = phi_2616_;
                            phi_2949_ = _e1408;
                            phi_973_ = _e1410;
                            phi_976_ = _e1412;
                            phi_978_ = _e1414;
                            phi_980_ = _e1416;
                            phi_982_ = _e1418;
                            phi_2617_ = _e580;
                        } else {
                            phi_2949_ = _e566;
                            phi_973_ = type_40();
                            phi_976_ = u32();
                            phi_978_ = bool();
                            phi_980_ = u32();
                            phi_982_ = u32();
                            phi_2617_ = false;
                        }
                        let _e1420 = phi_2949_;
                        let _e1422 = phi_973_;
                        let _e1424 = phi_976_;
                        let _e1426 = phi_978_;
                        let _e1428 = phi_980_;
                        let _e1430 = phi_982_;
                        let _e1432 = phi_2617_;
                        continue;
                        continuing {
                            phi_2794_ = _e1420;
                            phi_972_ = _e1422;
                            phi_975_ = _e1424;
                            phi_977_ = _e1426;
                            phi_979_ = _e1428;
                            phi_981_ = _e1430;
                            phi_2948_ = _e1420;
                            break if !(_e1432);
                        }
                    }
                    let _e1435 = phi_2948_;
                    if _e1435 {
                        break;
                    }
                    let _e1437 = local_2;
                    if (_e1437.member.member_3 != 4294967295u) {
                        let _e1442 = -(_e460);
                        let _e1443 = bitcast<u32>(_e1437.member.member);
                        let _e1447 = (bitcast<i32>((_e1443 >> bitcast<u32>(23i))) & 255i);
                        let _e1448 = (_e1447 + _e1442);
                        if (_e1447 == 255i) {
                            phi_2676_ = _e1437.member.member;
                        } else {
                            if (_e1447 > 0i) {
                                if (_e1448 > 0i) {
                                    let _e1452 = (_e1448 < 255i);
                                    if _e1452 {
                                        phi_2655_ = bitcast<f32>((_e1443 + bitcast<u32>((_e1442 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_2655_ = f32();
                                    }
                                    let _e1459 = phi_2655_;
                                    phi_2657_ = _e1459;
                                    phi_2658_ = select(true, false, _e1452);
                                } else {
                                    phi_2657_ = f32();
                                    phi_2658_ = true;
                                }
                                let _e1462 = phi_2657_;
                                let _e1464 = phi_2658_;
                                phi_2659_ = _e1462;
                                phi_2660_ = _e1464;
                            } else {
                                phi_2659_ = f32();
                                phi_2660_ = true;
                            }
                            let _e1466 = phi_2659_;
                            let _e1468 = phi_2660_;
                            if _e1468 {
                                let _e1469 = (_e1443 & 2147483648u);
                                let _e1476 = ((_e1443 & 8388607u) | (select(0u, 1u, ((_e1443 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e1480 = (_e1476 == 0u);
                                if _e1480 {
                                    phi_2783_ = bitcast<f32>(_e1469);
                                } else {
                                    let _e1485 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1476)), 32u, _e1480) - 8u);
                                    let _e1488 = (_e1476 << bitcast<u32>((_e1485 & 31u)));
                                    let _e1490 = ((_e1448 + select(0i, 1i, (_e1447 == 0i))) - bitcast<i32>(_e1485));
                                    if (_e1490 >= 255i) {
                                        phi_2773_ = bitcast<f32>((_e1469 | 2139095040u));
                                        phi_2774_ = f32();
                                        phi_2775_ = true;
                                    } else {
                                        let _e1492 = (_e1490 > 0i);
                                        if _e1492 {
                                            phi_2767_ = bitcast<f32>(((_e1469 | (bitcast<u32>(_e1490) << bitcast<u32>(23i))) | (_e1488 & 8388607u)));
                                            phi_2768_ = f32();
                                        } else {
                                            if (_e1490 < -24i) {
                                                phi_2733_ = 26u;
                                            } else {
                                                phi_2733_ = bitcast<u32>((1i - _e1490));
                                            }
                                            let _e1497 = phi_2733_;
                                            let _e1498 = (_e1497 & 31u);
                                            let _e1500 = (_e1488 >> bitcast<u32>(_e1498));
                                            let _e1504 = (_e1488 & ((1u << bitcast<u32>(_e1498)) - 1u));
                                            let _e1508 = (1u << bitcast<u32>(((_e1497 - 1u) & 31u)));
                                            if (_e1504 > _e1508) {
                                                phi_2754_ = true;
                                            } else {
                                                if (_e1504 == _e1508) {
                                                    phi_2751_ = ((_e1500 & 1u) == 1u);
                                                } else {
                                                    phi_2751_ = false;
                                                }
                                                let _e1514 = phi_2751_;
                                                phi_2754_ = _e1514;
                                            }
                                            let _e1516 = phi_2754_;
                                            phi_2767_ = f32();
                                            phi_2768_ = bitcast<f32>((_e1469 | (_e1500 + select(0u, 1u, _e1516))));
                                        }
                                        let _e1529 = phi_2767_;
                                        let _e1531 = phi_2768_;
                                        phi_2773_ = _e1529;
                                        phi_2774_ = _e1531;
                                        phi_2775_ = _e1492;
                                    }
                                    let _e1535 = phi_2773_;
                                    let _e1537 = phi_2774_;
                                    let _e1539 = phi_2775_;
                                    phi_2783_ = select(_e1537, _e1535, _e1539);
                                }
                                let _e1543 = phi_2783_;
                                phi_2675_ = _e1543;
                            } else {
                                phi_2675_ = _e1466;
                            }
                            let _e1545 = phi_2675_;
                            phi_2676_ = _e1545;
                        }
                        let _e1547 = phi_2676_;
                        let _e1548 = bitcast<u32>(_e1547);
                        if ((_e1548 & 2147483647u) >= 2139095040u) {
                            phi_2688_ = bitcast<f32>(((_e1548 & 2147483648u) | 2139095039u));
                        } else {
                            phi_2688_ = _e1547;
                        }
                        let _e1555 = phi_2688_;
                        phi_2693_ = type_23(_e1555, _e1437.member.member_1, _e1437.member.member_2, _e1437.member.member_3);
                    } else {
                        phi_2693_ = type_23(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1560 = phi_2693_;
                    if _e91 {
                    } else {
                        break;
                    }
                    global_5.member[_e85] = _e1560;
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
