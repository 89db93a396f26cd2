struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
}

struct type_11 {
    member: vec4<u32>,
}

struct type_15 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_17 {
    member: array<type_15>,
}

struct type_25 {
    member: array<array<f32, 8>>,
}

struct type_28 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_29 {
    member: u32,
    member_1: u32,
    member_2: bool,
}

struct type_31 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_35 {
    member: array<array<i32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_37 {
    member: array<type_35>,
}

struct type_40 {
    member: vec3<f32>,
    member_1: vec3<f32>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_11;
@group(0) @binding(1) 
var<uniform> global_2: type_11;
@group(0) @binding(2) 
var<uniform> global_3: type_11;
@group(0) @binding(3) 
var<storage> global_4: type_17;
@group(0) @binding(4) 
var<storage> global_5: type_25;
@group(0) @binding(5) 
var<storage> global_6: type_4;
@group(0) @binding(6) 
var<storage, read_write> global_7: type_37;

fn function_() {
    var phi_210_: u32;
    var phi_440_: type_7;
    var phi_443_: type_31;
    var phi_441_: type_7;
    var phi_466_: type_7;
    var phi_485_: type_15;
    var phi_444_: type_31;
    var phi_2438_: bool;
    var phi_644_: type_29;
    var phi_647_: type_31;
    var phi_659_: bool;
    var phi_684_: type_29;
    var phi_645_: type_29;
    var phi_687_: type_7;
    var phi_706_: type_15;
    var phi_648_: type_31;
    var phi_2468_: bool;
    var phi_877_: u32;
    var phi_880_: type_7;
    var phi_883_: u32;
    var phi_885_: u32;
    var phi_887_: u32;
    var phi_889_: u32;
    var phi_891_: type_31;
    var phi_881_: type_7;
    var phi_914_: type_7;
    var phi_942_: array<f32, 8>;
    var phi_1013_: u32;
    var phi_1014_: type_31;
    var phi_1033_: array<f32, 8>;
    var phi_1103_: u32;
    var phi_1104_: type_31;
    var phi_1123_: u32;
    var phi_1124_: u32;
    var phi_1125_: u32;
    var phi_1126_: u32;
    var phi_1127_: u32;
    var phi_1128_: type_31;
    var phi_884_: u32;
    var phi_886_: u32;
    var phi_888_: u32;
    var phi_890_: u32;
    var phi_892_: type_31;
    var phi_1130_: bool;
    var phi_2499_: bool;
    var phi_219_: type_29;
    var phi_222_: type_31;
    var phi_234_: bool;
    var phi_259_: type_29;
    var phi_220_: type_29;
    var phi_262_: type_7;
    var phi_281_: type_15;
    var phi_223_: type_31;
    var phi_2526_: bool;
    var phi_2562_: bool;
    var phi_1131_: type_31;
    var phi_1157_: u32;
    var phi_1387_: type_7;
    var phi_1390_: type_31;
    var phi_1388_: type_7;
    var phi_1413_: type_7;
    var phi_1432_: type_15;
    var phi_1391_: type_31;
    var phi_2557_: bool;
    var phi_1591_: type_29;
    var phi_1594_: type_31;
    var phi_1606_: bool;
    var phi_1631_: type_29;
    var phi_1592_: type_29;
    var phi_1634_: type_7;
    var phi_1653_: type_15;
    var phi_1595_: type_31;
    var phi_2588_: bool;
    var phi_1824_: u32;
    var phi_1827_: type_7;
    var phi_1830_: u32;
    var phi_1832_: u32;
    var phi_1834_: u32;
    var phi_1836_: u32;
    var phi_1838_: type_31;
    var phi_1828_: type_7;
    var phi_1861_: type_7;
    var phi_1889_: array<f32, 8>;
    var phi_1960_: u32;
    var phi_1961_: type_31;
    var phi_1980_: array<f32, 8>;
    var phi_2050_: u32;
    var phi_2051_: type_31;
    var phi_2070_: u32;
    var phi_2071_: u32;
    var phi_2072_: u32;
    var phi_2073_: u32;
    var phi_2074_: u32;
    var phi_2075_: type_31;
    var phi_1831_: u32;
    var phi_1833_: u32;
    var phi_1835_: u32;
    var phi_1837_: u32;
    var phi_1839_: type_31;
    var phi_2077_: bool;
    var phi_2619_: bool;
    var phi_1166_: type_29;
    var phi_1169_: type_31;
    var phi_1181_: bool;
    var phi_1206_: type_29;
    var phi_1167_: type_29;
    var phi_1209_: type_7;
    var phi_1228_: type_15;
    var phi_1170_: type_31;
    var phi_2646_: bool;
    var phi_2078_: type_31;
    var phi_2096_: type_28;
    var phi_2122_: i32;
    var phi_2123_: i32;
    var phi_2141_: type_40;
    var phi_2159_: type_40;
    var local: type_31;
    var local_1: type_31;
    var local_2: type_31;
    var local_3: type_31;
    var local_4: type_31;
    var local_5: type_31;
    var local_6: type_31;
    var local_7: type_31;

    switch bitcast<i32>(0u) {
        default: {
            let _e47 = global;
            let _e49 = arrayLength((&global_4.member));
            let _e51 = arrayLength((&global_5.member));
            let _e59 = (_e47.x + (_e47.y * 2097152u));
            let _e62 = global_1.member[0u];
            if (_e59 < _e62) {
                let _e64 = (_e59 < arrayLength((&global_7.member)));
                if _e64 {
                    let _e65 = (_e59 < arrayLength((&global_6.member)));
                    if _e65 {
                        if _e64 {
                        } else {
                            break;
                        }
                        let _e71 = global_7.member[_e59].member_1;
                        let _e75 = global_7.member[_e59].member_2;
                        let _e79 = global_7.member[_e59].member_3;
                        let _e83 = global_7.member[_e59].member_4;
                        if _e65 {
                        } else {
                            break;
                        }
                        let _e87 = global_6.member[_e59];
                        if (_e71 == 2147483648u) {
                            phi_2096_ = type_28(array<array<f32, 4>, 3>(array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f), array<f32, 4>(0f, 0f, 0f, 0f)), _e71, _e75, _e79, _e83);
                        } else {
                            let _e89 = (_e79 / 8u);
                            if ((_e79 % 8u) > 0u) {
                                phi_210_ = (_e89 + 1u);
                            } else {
                                phi_210_ = _e89;
                            }
                            let _e94 = phi_210_;
                            let _e95 = (_e87 + 1u);
                            let _e96 = (_e95 / 8u);
                            if (_e94 >= _e96) {
                                phi_219_ = type_29(_e79, _e87, false);
                                phi_222_ = type_31(vec4<f32>(340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f), vec4<f32>(-340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f));
                                loop {
                                    let _e506 = phi_219_;
                                    let _e508 = phi_222_;
                                    local_2 = _e508;
                                    if _e506.member_2 {
                                        phi_234_ = true;
                                    } else {
                                        phi_234_ = !((_e506.member <= _e506.member_1));
                                    }
                                    let _e515 = phi_234_;
                                    if _e515 {
                                        phi_220_ = _e506;
                                        phi_262_ = type_7(0u, type_7().member_1);
                                    } else {
                                        if (_e506.member < _e506.member_1) {
                                            phi_259_ = type_29((_e506.member + 1u), _e506.member_1, _e506.member_2);
                                        } else {
                                            phi_259_ = type_29(_e506.member, _e506.member_1, true);
                                        }
                                        let _e529 = phi_259_;
                                        phi_220_ = _e529;
                                        phi_262_ = type_7(1u, _e506.member);
                                    }
                                    let _e535 = phi_220_;
                                    let _e537 = phi_262_;
                                    let _e541 = (bitcast<i32>(_e537.member) != 0i);
                                    if _e541 {
                                        let _e542 = (_e537.member_1 < _e49);
                                        if _e542 {
                                            if _e542 {
                                            } else {
                                                phi_2526_ = true;
                                                break;
                                            }
                                            let _e545 = global_4.member[_e537.member_1];
                                            phi_281_ = _e545;
                                        } else {
                                            phi_281_ = type_15(array<f32, 9>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f), 0u);
                                        }
                                        let _e547 = phi_281_;
                                        let _e559 = bitcast<f32>(_e547.member_1);
                                        let _e561 = select(_e547.member[3], _e547.member[0], (_e547.member[0] < _e547.member[3]));
                                        let _e563 = select(_e547.member[4], _e547.member[1], (_e547.member[1] < _e547.member[4]));
                                        let _e565 = select(_e547.member[5], _e547.member[2], (_e547.member[2] < _e547.member[5]));
                                        let _e567 = select(_e547.member[6], _e547.member[3], (_e547.member[3] < _e547.member[6]));
                                        let _e569 = select(_e547.member[6], _e561, (_e561 < _e547.member[6]));
                                        let _e571 = select(_e547.member[7], _e563, (_e563 < _e547.member[7]));
                                        let _e573 = select(_e547.member[8], _e565, (_e565 < _e547.member[8]));
                                        let _e575 = select(_e559, _e567, (_e567 < _e559));
                                        let _e577 = select(_e547.member[3], _e547.member[0], (_e547.member[0] > _e547.member[3]));
                                        let _e579 = select(_e547.member[4], _e547.member[1], (_e547.member[1] > _e547.member[4]));
                                        let _e581 = select(_e547.member[5], _e547.member[2], (_e547.member[2] > _e547.member[5]));
                                        let _e583 = select(_e547.member[6], _e547.member[3], (_e547.member[3] > _e547.member[6]));
                                        let _e585 = select(_e547.member[6], _e577, (_e577 > _e547.member[6]));
                                        let _e587 = select(_e547.member[7], _e579, (_e579 > _e547.member[7]));
                                        let _e589 = select(_e547.member[8], _e581, (_e581 > _e547.member[8]));
                                        let _e591 = select(_e559, _e583, (_e583 > _e559));
                                        phi_223_ = type_31(vec4<f32>(select(_e569, _e508.member.x, (_e508.member.x < _e569)), select(_e571, _e508.member.y, (_e508.member.y < _e571)), select(_e573, _e508.member.z, (_e508.member.z < _e573)), select(_e575, _e508.member.w, (_e508.member.w < _e575))), vec4<f32>(select(_e585, _e508.member_1.x, (_e508.member_1.x > _e585)), select(_e587, _e508.member_1.y, (_e508.member_1.y > _e587)), select(_e589, _e508.member_1.z, (_e508.member_1.z > _e589)), select(_e591, _e508.member_1.w, (_e508.member_1.w > _e591))));
                                    } else {
                                        phi_223_ = type_31();
                                    }
                                    let _e622 = phi_223_;
                                    continue;
                                    continuing {
                                        phi_219_ = _e535;
                                        phi_222_ = _e622;
                                        phi_2526_ = false;
                                        break if !(_e541);
                                    }
                                }
                                let _e625 = phi_2526_;
                                if _e625 {
                                    break;
                                }
                                phi_2562_ = _e625;
                                let _e1498 = local_2;
                                phi_1131_ = _e1498;
                            } else {
                                phi_440_ = type_7(_e79, (_e94 * 8u));
                                phi_443_ = type_31(vec4<f32>(340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f), vec4<f32>(-340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f));
                                loop {
                                    let _e101 = phi_440_;
                                    let _e103 = phi_443_;
                                    local = _e103;
                                    if (_e101.member < _e101.member_1) {
                                        phi_441_ = type_7((_e101.member + 1u), _e101.member_1);
                                        phi_466_ = type_7(1u, _e101.member);
                                    } else {
                                        phi_441_ = _e101;
                                        phi_466_ = type_7(0u, type_7().member_1);
                                    }
                                    let _e116 = phi_441_;
                                    let _e118 = phi_466_;
                                    let _e122 = (bitcast<i32>(_e118.member) != 0i);
                                    if _e122 {
                                        let _e123 = (_e118.member_1 < _e49);
                                        if _e123 {
                                            if _e123 {
                                            } else {
                                                phi_2438_ = true;
                                                break;
                                            }
                                            let _e126 = global_4.member[_e118.member_1];
                                            phi_485_ = _e126;
                                        } else {
                                            phi_485_ = type_15(array<f32, 9>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f), 0u);
                                        }
                                        let _e128 = phi_485_;
                                        let _e140 = bitcast<f32>(_e128.member_1);
                                        let _e142 = select(_e128.member[3], _e128.member[0], (_e128.member[0] < _e128.member[3]));
                                        let _e144 = select(_e128.member[4], _e128.member[1], (_e128.member[1] < _e128.member[4]));
                                        let _e146 = select(_e128.member[5], _e128.member[2], (_e128.member[2] < _e128.member[5]));
                                        let _e148 = select(_e128.member[6], _e128.member[3], (_e128.member[3] < _e128.member[6]));
                                        let _e150 = select(_e128.member[6], _e142, (_e142 < _e128.member[6]));
                                        let _e152 = select(_e128.member[7], _e144, (_e144 < _e128.member[7]));
                                        let _e154 = select(_e128.member[8], _e146, (_e146 < _e128.member[8]));
                                        let _e156 = select(_e140, _e148, (_e148 < _e140));
                                        let _e158 = select(_e128.member[3], _e128.member[0], (_e128.member[0] > _e128.member[3]));
                                        let _e160 = select(_e128.member[4], _e128.member[1], (_e128.member[1] > _e128.member[4]));
                                        let _e162 = select(_e128.member[5], _e128.member[2], (_e128.member[2] > _e128.member[5]));
                                        let _e164 = select(_e128.member[6], _e128.member[3], (_e128.member[3] > _e128.member[6]));
                                        let _e166 = select(_e128.member[6], _e158, (_e158 > _e128.member[6]));
                                        let _e168 = select(_e128.member[7], _e160, (_e160 > _e128.member[7]));
                                        let _e170 = select(_e128.member[8], _e162, (_e162 > _e128.member[8]));
                                        let _e172 = select(_e140, _e164, (_e164 > _e140));
                                        phi_444_ = type_31(vec4<f32>(select(_e150, _e103.member.x, (_e103.member.x < _e150)), select(_e152, _e103.member.y, (_e103.member.y < _e152)), select(_e154, _e103.member.z, (_e103.member.z < _e154)), select(_e156, _e103.member.w, (_e103.member.w < _e156))), vec4<f32>(select(_e166, _e103.member_1.x, (_e103.member_1.x > _e166)), select(_e168, _e103.member_1.y, (_e103.member_1.y > _e168)), select(_e170, _e103.member_1.z, (_e103.member_1.z > _e170)), select(_e172, _e103.member_1.w, (_e103.member_1.w > _e172))));
                                    } else {
                                        phi_444_ = type_31();
                                    }
                                    let _e203 = phi_444_;
                                    continue;
                                    continuing {
                                        phi_440_ = _e116;
                                        phi_443_ = _e203;
                                        phi_2438_ = false;
                                        break if !(_e122);
                                    }
                                }
                                let _e206 = phi_2438_;
                                if _e206 {
                                    break;
                                }
                                phi_644_ = type_29((_e96 * 8u), _e87, false);
                                let _e1448 = local;
                                phi_647_ = _e1448;
                                loop {
                                    let _e210 = phi_644_;
                                    let _e212 = phi_647_;
                                    local_1 = _e212;
                                    if _e210.member_2 {
                                        phi_659_ = true;
                                    } else {
                                        phi_659_ = !((_e210.member <= _e210.member_1));
                                    }
                                    let _e219 = phi_659_;
                                    if _e219 {
                                        phi_645_ = _e210;
                                        phi_687_ = type_7(0u, type_7().member_1);
                                    } else {
                                        if (_e210.member < _e210.member_1) {
                                            phi_684_ = type_29((_e210.member + 1u), _e210.member_1, _e210.member_2);
                                        } else {
                                            phi_684_ = type_29(_e210.member, _e210.member_1, true);
                                        }
                                        let _e233 = phi_684_;
                                        phi_645_ = _e233;
                                        phi_687_ = type_7(1u, _e210.member);
                                    }
                                    let _e239 = phi_645_;
                                    let _e241 = phi_687_;
                                    let _e245 = (bitcast<i32>(_e241.member) != 0i);
                                    if _e245 {
                                        let _e246 = (_e241.member_1 < _e49);
                                        if _e246 {
                                            if _e246 {
                                            } else {
                                                phi_2468_ = true;
                                                break;
                                            }
                                            let _e249 = global_4.member[_e241.member_1];
                                            phi_706_ = _e249;
                                        } else {
                                            phi_706_ = type_15(array<f32, 9>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f), 0u);
                                        }
                                        let _e251 = phi_706_;
                                        let _e263 = bitcast<f32>(_e251.member_1);
                                        let _e265 = select(_e251.member[3], _e251.member[0], (_e251.member[0] < _e251.member[3]));
                                        let _e267 = select(_e251.member[4], _e251.member[1], (_e251.member[1] < _e251.member[4]));
                                        let _e269 = select(_e251.member[5], _e251.member[2], (_e251.member[2] < _e251.member[5]));
                                        let _e271 = select(_e251.member[6], _e251.member[3], (_e251.member[3] < _e251.member[6]));
                                        let _e273 = select(_e251.member[6], _e265, (_e265 < _e251.member[6]));
                                        let _e275 = select(_e251.member[7], _e267, (_e267 < _e251.member[7]));
                                        let _e277 = select(_e251.member[8], _e269, (_e269 < _e251.member[8]));
                                        let _e279 = select(_e263, _e271, (_e271 < _e263));
                                        let _e281 = select(_e251.member[3], _e251.member[0], (_e251.member[0] > _e251.member[3]));
                                        let _e283 = select(_e251.member[4], _e251.member[1], (_e251.member[1] > _e251.member[4]));
                                        let _e285 = select(_e251.member[5], _e251.member[2], (_e251.member[2] > _e251.member[5]));
                                        let _e287 = select(_e251.member[6], _e251.member[3], (_e251.member[3] > _e251.member[6]));
                                        let _e289 = select(_e251.member[6], _e281, (_e281 > _e251.member[6]));
                                        let _e291 = select(_e251.member[7], _e283, (_e283 > _e251.member[7]));
                                        let _e293 = select(_e251.member[8], _e285, (_e285 > _e251.member[8]));
                                        let _e295 = select(_e263, _e287, (_e287 > _e263));
                                        phi_648_ = type_31(vec4<f32>(select(_e273, _e212.member.x, (_e212.member.x < _e273)), select(_e275, _e212.member.y, (_e212.member.y < _e275)), select(_e277, _e212.member.z, (_e212.member.z < _e277)), select(_e279, _e212.member.w, (_e212.member.w < _e279))), vec4<f32>(select(_e289, _e212.member_1.x, (_e212.member_1.x > _e289)), select(_e291, _e212.member_1.y, (_e212.member_1.y > _e291)), select(_e293, _e212.member_1.z, (_e212.member_1.z > _e293)), select(_e295, _e212.member_1.w, (_e212.member_1.w > _e295))));
                                    } else {
                                        phi_648_ = type_31();
                                    }
                                    let _e326 = phi_648_;
                                    continue;
                                    continuing {
                                        phi_644_ = _e239;
                                        phi_647_ = _e326;
                                        phi_2468_ = _e206;
                                        break if !(_e245);
                                    }
                                }
                                let _e329 = phi_2468_;
                                if _e329 {
                                    break;
                                }
                                let _e330 = (_e49 / 8u);
                                if ((_e49 % 8u) > 0u) {
                                    phi_877_ = (_e330 + 1u);
                                } else {
                                    phi_877_ = _e330;
                                }
                                let _e335 = phi_877_;
                                phi_880_ = type_7(0u, 32u);
                                phi_883_ = _e335;
                                phi_885_ = 0u;
                                phi_887_ = _e96;
                                phi_889_ = _e94;
                                let _e1464 = local_1;
                                phi_891_ = _e1464;
                                loop {
                                    let _e337 = phi_880_;
                                    let _e339 = phi_883_;
                                    let _e341 = phi_885_;
                                    let _e343 = phi_887_;
                                    let _e345 = phi_889_;
                                    let _e347 = phi_891_;
                                    local_3 = _e347;
                                    if (_e337.member < _e337.member_1) {
                                        phi_881_ = type_7((_e337.member + 1u), _e337.member_1);
                                        phi_914_ = type_7(1u, _e337.member);
                                    } else {
                                        phi_881_ = _e337;
                                        phi_914_ = type_7(0u, type_7().member_1);
                                    }
                                    let _e360 = phi_881_;
                                    let _e362 = phi_914_;
                                    if (bitcast<i32>(_e362.member) != 0i) {
                                        let _e366 = (_e345 >= _e343);
                                        if _e366 {
                                            phi_1124_ = u32();
                                            phi_1125_ = u32();
                                            phi_1126_ = u32();
                                            phi_1127_ = u32();
                                            phi_1128_ = type_31();
                                        } else {
                                            if ((_e345 & 1u) == 1u) {
                                                let _e369 = (_e341 + _e345);
                                                let _e370 = (_e369 < _e51);
                                                if _e370 {
                                                    if _e370 {
                                                    } else {
                                                        phi_2499_ = true;
                                                        break;
                                                    }
                                                    let _e373 = global_5.member[_e369];
                                                    phi_942_ = _e373;
                                                } else {
                                                    phi_942_ = array<f32, 8>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                                                }
                                                let _e375 = phi_942_;
                                                phi_1013_ = (_e345 + 1u);
                                                phi_1014_ = type_31(vec4<f32>(select(_e375[0], _e347.member.x, (_e347.member.x < _e375[0])), select(_e375[1], _e347.member.y, (_e347.member.y < _e375[1])), select(_e375[2], _e347.member.z, (_e347.member.z < _e375[2])), select(_e375[3], _e347.member.w, (_e347.member.w < _e375[3]))), vec4<f32>(select(_e375[4], _e347.member_1.x, (_e347.member_1.x > _e375[4])), select(_e375[5], _e347.member_1.y, (_e347.member_1.y > _e375[5])), select(_e375[6], _e347.member_1.z, (_e347.member_1.z > _e375[6])), select(_e375[7], _e347.member_1.w, (_e347.member_1.w > _e375[7]))));
                                            } else {
                                                phi_1013_ = _e345;
                                                phi_1014_ = _e347;
                                            }
                                            let _e415 = phi_1013_;
                                            let _e417 = phi_1014_;
                                            if ((_e343 & 1u) == 1u) {
                                                let _e420 = (_e343 - 1u);
                                                let _e421 = (_e341 + _e420);
                                                let _e422 = (_e421 < _e51);
                                                if _e422 {
                                                    if _e422 {
                                                    } else {
                                                        phi_2499_ = true;
                                                        break;
                                                    }
                                                    let _e425 = global_5.member[_e421];
                                                    phi_1033_ = _e425;
                                                } else {
                                                    phi_1033_ = array<f32, 8>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                                                }
                                                let _e427 = phi_1033_;
                                                phi_1103_ = _e420;
                                                phi_1104_ = type_31(vec4<f32>(select(_e427[0], _e417.member.x, (_e417.member.x < _e427[0])), select(_e427[1], _e417.member.y, (_e417.member.y < _e427[1])), select(_e427[2], _e417.member.z, (_e417.member.z < _e427[2])), select(_e427[3], _e417.member.w, (_e417.member.w < _e427[3]))), vec4<f32>(select(_e427[4], _e417.member_1.x, (_e417.member_1.x > _e427[4])), select(_e427[5], _e417.member_1.y, (_e417.member_1.y > _e427[5])), select(_e427[6], _e417.member_1.z, (_e417.member_1.z > _e427[6])), select(_e427[7], _e417.member_1.w, (_e417.member_1.w > _e427[7]))));
                                            } else {
                                                phi_1103_ = _e343;
                                                phi_1104_ = _e417;
                                            }
                                            let _e466 = phi_1103_;
                                            let _e468 = phi_1104_;
                                            let _e472 = (_e339 / 2u);
                                            if ((_e339 % 2u) > 0u) {
                                                phi_1123_ = (_e472 + 1u);
                                            } else {
                                                phi_1123_ = _e472;
                                            }
                                            let _e477 = phi_1123_;
                                            phi_1124_ = _e477;
                                            phi_1125_ = (_e341 + _e339);
                                            phi_1126_ = (_e466 / 2u);
                                            phi_1127_ = (_e415 / 2u);
                                            phi_1128_ = _e468;
                                        }
                                        let _e479 = phi_1124_;
                                        let _e481 = phi_1125_;
                                        let _e483 = phi_1126_;
                                        let _e485 = phi_1127_;
                                        let _e487 = phi_1128_;
                                        phi_884_ = _e479;
                                        phi_886_ = _e481;
                                        phi_888_ = _e483;
                                        phi_890_ = _e485;
                                        phi_892_ = _e487;
                                        phi_1130_ = select(true, false, _e366);
                                    } else {
                                        phi_884_ = u32();
                                        phi_886_ = u32();
                                        phi_888_ = u32();
                                        phi_890_ = u32();
                                        phi_892_ = type_31();
                                        phi_1130_ = false;
                                    }
                                    let _e490 = phi_884_;
                                    let _e492 = phi_886_;
                                    let _e494 = phi_888_;
                                    let _e496 = phi_890_;
                                    let _e498 = phi_892_;
                                    let _e500 = phi_1130_;
                                    continue;
                                    continuing {
                                        phi_880_ = _e360;
                                        phi_883_ = _e490;
                                        phi_885_ = _e492;
                                        phi_887_ = _e494;
                                        phi_889_ = _e496;
                                        phi_891_ = _e498;
                                        phi_2499_ = _e329;
                                        break if !(_e500);
                                    }
                                }
                                let _e503 = phi_2499_;
                                if _e503 {
                                    break;
                                }
                                phi_2562_ = _e503;
                                let _e1500 = local_3;
                                phi_1131_ = _e1500;
                            }
                            let _e627 = phi_2562_;
                            let _e629 = phi_1131_;
                            if ((_e95 % 8u) > 0u) {
                                phi_1157_ = (_e96 + 1u);
                            } else {
                                phi_1157_ = _e96;
                            }
                            let _e642 = phi_1157_;
                            let _e644 = ((_e83 + 1u) / 8u);
                            if (_e642 >= _e644) {
                                phi_1166_ = type_29(_e95, _e83, false);
                                phi_1169_ = type_31(vec4<f32>(340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f), vec4<f32>(-340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f));
                                loop {
                                    let _e1054 = phi_1166_;
                                    let _e1056 = phi_1169_;
                                    local_6 = _e1056;
                                    if _e1054.member_2 {
                                        phi_1181_ = true;
                                    } else {
                                        phi_1181_ = !((_e1054.member <= _e1054.member_1));
                                    }
                                    let _e1063 = phi_1181_;
                                    if _e1063 {
                                        phi_1167_ = _e1054;
                                        phi_1209_ = type_7(0u, type_7().member_1);
                                    } else {
                                        if (_e1054.member < _e1054.member_1) {
                                            phi_1206_ = type_29((_e1054.member + 1u), _e1054.member_1, _e1054.member_2);
                                        } else {
                                            phi_1206_ = type_29(_e1054.member, _e1054.member_1, true);
                                        }
                                        let _e1077 = phi_1206_;
                                        phi_1167_ = _e1077;
                                        phi_1209_ = type_7(1u, _e1054.member);
                                    }
                                    let _e1083 = phi_1167_;
                                    let _e1085 = phi_1209_;
                                    let _e1089 = (bitcast<i32>(_e1085.member) != 0i);
                                    if _e1089 {
                                        let _e1090 = (_e1085.member_1 < _e49);
                                        if _e1090 {
                                            if _e1090 {
                                            } else {
                                                phi_2646_ = true;
                                                break;
                                            }
                                            let _e1093 = global_4.member[_e1085.member_1];
                                            phi_1228_ = _e1093;
                                        } else {
                                            phi_1228_ = type_15(array<f32, 9>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f), 0u);
                                        }
                                        let _e1095 = phi_1228_;
                                        let _e1107 = bitcast<f32>(_e1095.member_1);
                                        let _e1109 = select(_e1095.member[3], _e1095.member[0], (_e1095.member[0] < _e1095.member[3]));
                                        let _e1111 = select(_e1095.member[4], _e1095.member[1], (_e1095.member[1] < _e1095.member[4]));
                                        let _e1113 = select(_e1095.member[5], _e1095.member[2], (_e1095.member[2] < _e1095.member[5]));
                                        let _e1115 = select(_e1095.member[6], _e1095.member[3], (_e1095.member[3] < _e1095.member[6]));
                                        let _e1117 = select(_e1095.member[6], _e1109, (_e1109 < _e1095.member[6]));
                                        let _e1119 = select(_e1095.member[7], _e1111, (_e1111 < _e1095.member[7]));
                                        let _e1121 = select(_e1095.member[8], _e1113, (_e1113 < _e1095.member[8]));
                                        let _e1123 = select(_e1107, _e1115, (_e1115 < _e1107));
                                        let _e1125 = select(_e1095.member[3], _e1095.member[0], (_e1095.member[0] > _e1095.member[3]));
                                        let _e1127 = select(_e1095.member[4], _e1095.member[1], (_e1095.member[1] > _e1095.member[4]));
                                        let _e1129 = select(_e1095.member[5], _e1095.member[2], (_e1095.member[2] > _e1095.member[5]));
                                        let _e1131 = select(_e1095.member[6], _e1095.member[3], (_e1095.member[3] > _e1095.member[6]));
                                        let _e1133 = select(_e1095.member[6], _e1125, (_e1125 > _e1095.member[6]));
                                        let _e1135 = select(_e1095.member[7], _e1127, (_e1127 > _e1095.member[7]));
                                        let _e1137 = select(_e1095.member[8], _e1129, (_e1129 > _e1095.member[8]));
                                        let _e1139 = select(_e1107, _e1131, (_e1131 > _e1107));
                                        phi_1170_ = type_31(vec4<f32>(select(_e1117, _e1056.member.x, (_e1056.member.x < _e1117)), select(_e1119, _e1056.member.y, (_e1056.member.y < _e1119)), select(_e1121, _e1056.member.z, (_e1056.member.z < _e1121)), select(_e1123, _e1056.member.w, (_e1056.member.w < _e1123))), vec4<f32>(select(_e1133, _e1056.member_1.x, (_e1056.member_1.x > _e1133)), select(_e1135, _e1056.member_1.y, (_e1056.member_1.y > _e1135)), select(_e1137, _e1056.member_1.z, (_e1056.member_1.z > _e1137)), select(_e1139, _e1056.member_1.w, (_e1056.member_1.w > _e1139))));
                                    } else {
                                        phi_1170_ = type_31();
                                    }
                                    let _e1170 = phi_1170_;
                                    continue;
                                    continuing {
                                        phi_1166_ = _e1083;
                                        phi_1169_ = _e1170;
                                        phi_2646_ = _e627;
                                        break if !(_e1089);
                                    }
                                }
                                let _e1173 = phi_2646_;
                                if _e1173 {
                                    break;
                                }
                                let _e1561 = local_6;
                                phi_2078_ = _e1561;
                            } else {
                                phi_1387_ = type_7(_e95, (_e642 * 8u));
                                phi_1390_ = type_31(vec4<f32>(340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f, 340282350000000000000000000000000000000f), vec4<f32>(-340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f, -340282350000000000000000000000000000000f));
                                loop {
                                    let _e649 = phi_1387_;
                                    let _e651 = phi_1390_;
                                    local_4 = _e651;
                                    if (_e649.member < _e649.member_1) {
                                        phi_1388_ = type_7((_e649.member + 1u), _e649.member_1);
                                        phi_1413_ = type_7(1u, _e649.member);
                                    } else {
                                        phi_1388_ = _e649;
                                        phi_1413_ = type_7(0u, type_7().member_1);
                                    }
                                    let _e664 = phi_1388_;
                                    let _e666 = phi_1413_;
                                    let _e670 = (bitcast<i32>(_e666.member) != 0i);
                                    if _e670 {
                                        let _e671 = (_e666.member_1 < _e49);
                                        if _e671 {
                                            if _e671 {
                                            } else {
                                                phi_2557_ = true;
                                                break;
                                            }
                                            let _e674 = global_4.member[_e666.member_1];
                                            phi_1432_ = _e674;
                                        } else {
                                            phi_1432_ = type_15(array<f32, 9>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f), 0u);
                                        }
                                        let _e676 = phi_1432_;
                                        let _e688 = bitcast<f32>(_e676.member_1);
                                        let _e690 = select(_e676.member[3], _e676.member[0], (_e676.member[0] < _e676.member[3]));
                                        let _e692 = select(_e676.member[4], _e676.member[1], (_e676.member[1] < _e676.member[4]));
                                        let _e694 = select(_e676.member[5], _e676.member[2], (_e676.member[2] < _e676.member[5]));
                                        let _e696 = select(_e676.member[6], _e676.member[3], (_e676.member[3] < _e676.member[6]));
                                        let _e698 = select(_e676.member[6], _e690, (_e690 < _e676.member[6]));
                                        let _e700 = select(_e676.member[7], _e692, (_e692 < _e676.member[7]));
                                        let _e702 = select(_e676.member[8], _e694, (_e694 < _e676.member[8]));
                                        let _e704 = select(_e688, _e696, (_e696 < _e688));
                                        let _e706 = select(_e676.member[3], _e676.member[0], (_e676.member[0] > _e676.member[3]));
                                        let _e708 = select(_e676.member[4], _e676.member[1], (_e676.member[1] > _e676.member[4]));
                                        let _e710 = select(_e676.member[5], _e676.member[2], (_e676.member[2] > _e676.member[5]));
                                        let _e712 = select(_e676.member[6], _e676.member[3], (_e676.member[3] > _e676.member[6]));
                                        let _e714 = select(_e676.member[6], _e706, (_e706 > _e676.member[6]));
                                        let _e716 = select(_e676.member[7], _e708, (_e708 > _e676.member[7]));
                                        let _e718 = select(_e676.member[8], _e710, (_e710 > _e676.member[8]));
                                        let _e720 = select(_e688, _e712, (_e712 > _e688));
                                        phi_1391_ = type_31(vec4<f32>(select(_e698, _e651.member.x, (_e651.member.x < _e698)), select(_e700, _e651.member.y, (_e651.member.y < _e700)), select(_e702, _e651.member.z, (_e651.member.z < _e702)), select(_e704, _e651.member.w, (_e651.member.w < _e704))), vec4<f32>(select(_e714, _e651.member_1.x, (_e651.member_1.x > _e714)), select(_e716, _e651.member_1.y, (_e651.member_1.y > _e716)), select(_e718, _e651.member_1.z, (_e651.member_1.z > _e718)), select(_e720, _e651.member_1.w, (_e651.member_1.w > _e720))));
                                    } else {
                                        phi_1391_ = type_31();
                                    }
                                    let _e751 = phi_1391_;
                                    continue;
                                    continuing {
                                        phi_1387_ = _e664;
                                        phi_1390_ = _e751;
                                        phi_2557_ = _e627;
                                        break if !(_e670);
                                    }
                                }
                                let _e754 = phi_2557_;
                                if _e754 {
                                    break;
                                }
                                phi_1591_ = type_29((_e644 * 8u), _e83, false);
                                let _e1512 = local_4;
                                phi_1594_ = _e1512;
                                loop {
                                    let _e758 = phi_1591_;
                                    let _e760 = phi_1594_;
                                    local_5 = _e760;
                                    if _e758.member_2 {
                                        phi_1606_ = true;
                                    } else {
                                        phi_1606_ = !((_e758.member <= _e758.member_1));
                                    }
                                    let _e767 = phi_1606_;
                                    if _e767 {
                                        phi_1592_ = _e758;
                                        phi_1634_ = type_7(0u, type_7().member_1);
                                    } else {
                                        if (_e758.member < _e758.member_1) {
                                            phi_1631_ = type_29((_e758.member + 1u), _e758.member_1, _e758.member_2);
                                        } else {
                                            phi_1631_ = type_29(_e758.member, _e758.member_1, true);
                                        }
                                        let _e781 = phi_1631_;
                                        phi_1592_ = _e781;
                                        phi_1634_ = type_7(1u, _e758.member);
                                    }
                                    let _e787 = phi_1592_;
                                    let _e789 = phi_1634_;
                                    let _e793 = (bitcast<i32>(_e789.member) != 0i);
                                    if _e793 {
                                        let _e794 = (_e789.member_1 < _e49);
                                        if _e794 {
                                            if _e794 {
                                            } else {
                                                phi_2588_ = true;
                                                break;
                                            }
                                            let _e797 = global_4.member[_e789.member_1];
                                            phi_1653_ = _e797;
                                        } else {
                                            phi_1653_ = type_15(array<f32, 9>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f), 0u);
                                        }
                                        let _e799 = phi_1653_;
                                        let _e811 = bitcast<f32>(_e799.member_1);
                                        let _e813 = select(_e799.member[3], _e799.member[0], (_e799.member[0] < _e799.member[3]));
                                        let _e815 = select(_e799.member[4], _e799.member[1], (_e799.member[1] < _e799.member[4]));
                                        let _e817 = select(_e799.member[5], _e799.member[2], (_e799.member[2] < _e799.member[5]));
                                        let _e819 = select(_e799.member[6], _e799.member[3], (_e799.member[3] < _e799.member[6]));
                                        let _e821 = select(_e799.member[6], _e813, (_e813 < _e799.member[6]));
                                        let _e823 = select(_e799.member[7], _e815, (_e815 < _e799.member[7]));
                                        let _e825 = select(_e799.member[8], _e817, (_e817 < _e799.member[8]));
                                        let _e827 = select(_e811, _e819, (_e819 < _e811));
                                        let _e829 = select(_e799.member[3], _e799.member[0], (_e799.member[0] > _e799.member[3]));
                                        let _e831 = select(_e799.member[4], _e799.member[1], (_e799.member[1] > _e799.member[4]));
                                        let _e833 = select(_e799.member[5], _e799.member[2], (_e799.member[2] > _e799.member[5]));
                                        let _e835 = select(_e799.member[6], _e799.member[3], (_e799.member[3] > _e799.member[6]));
                                        let _e837 = select(_e799.member[6], _e829, (_e829 > _e799.member[6]));
                                        let _e839 = select(_e799.member[7], _e831, (_e831 > _e799.member[7]));
                                        let _e841 = select(_e799.member[8], _e833, (_e833 > _e799.member[8]));
                                        let _e843 = select(_e811, _e835, (_e835 > _e811));
                                        phi_1595_ = type_31(vec4<f32>(select(_e821, _e760.member.x, (_e760.member.x < _e821)), select(_e823, _e760.member.y, (_e760.member.y < _e823)), select(_e825, _e760.member.z, (_e760.member.z < _e825)), select(_e827, _e760.member.w, (_e760.member.w < _e827))), vec4<f32>(select(_e837, _e760.member_1.x, (_e760.member_1.x > _e837)), select(_e839, _e760.member_1.y, (_e760.member_1.y > _e839)), select(_e841, _e760.member_1.z, (_e760.member_1.z > _e841)), select(_e843, _e760.member_1.w, (_e760.member_1.w > _e843))));
                                    } else {
                                        phi_1595_ = type_31();
                                    }
                                    let _e874 = phi_1595_;
                                    continue;
                                    continuing {
                                        phi_1591_ = _e787;
                                        phi_1594_ = _e874;
                                        phi_2588_ = _e754;
                                        break if !(_e793);
                                    }
                                }
                                let _e877 = phi_2588_;
                                if _e877 {
                                    break;
                                }
                                let _e878 = (_e49 / 8u);
                                if ((_e49 % 8u) > 0u) {
                                    phi_1824_ = (_e878 + 1u);
                                } else {
                                    phi_1824_ = _e878;
                                }
                                let _e883 = phi_1824_;
                                phi_1827_ = type_7(0u, 32u);
                                phi_1830_ = _e883;
                                phi_1832_ = 0u;
                                phi_1834_ = _e644;
                                phi_1836_ = _e642;
                                let _e1528 = local_5;
                                phi_1838_ = _e1528;
                                loop {
                                    let _e885 = phi_1827_;
                                    let _e887 = phi_1830_;
                                    let _e889 = phi_1832_;
                                    let _e891 = phi_1834_;
                                    let _e893 = phi_1836_;
                                    let _e895 = phi_1838_;
                                    local_7 = _e895;
                                    if (_e885.member < _e885.member_1) {
                                        phi_1828_ = type_7((_e885.member + 1u), _e885.member_1);
                                        phi_1861_ = type_7(1u, _e885.member);
                                    } else {
                                        phi_1828_ = _e885;
                                        phi_1861_ = type_7(0u, type_7().member_1);
                                    }
                                    let _e908 = phi_1828_;
                                    let _e910 = phi_1861_;
                                    if (bitcast<i32>(_e910.member) != 0i) {
                                        let _e914 = (_e893 >= _e891);
                                        if _e914 {
                                            phi_2071_ = u32();
                                            phi_2072_ = u32();
                                            phi_2073_ = u32();
                                            phi_2074_ = u32();
                                            phi_2075_ = type_31();
                                        } else {
                                            if ((_e893 & 1u) == 1u) {
                                                let _e917 = (_e889 + _e893);
                                                let _e918 = (_e917 < _e51);
                                                if _e918 {
                                                    if _e918 {
                                                    } else {
                                                        phi_2619_ = true;
                                                        break;
                                                    }
                                                    let _e921 = global_5.member[_e917];
                                                    phi_1889_ = _e921;
                                                } else {
                                                    phi_1889_ = array<f32, 8>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                                                }
                                                let _e923 = phi_1889_;
                                                phi_1960_ = (_e893 + 1u);
                                                phi_1961_ = type_31(vec4<f32>(select(_e923[0], _e895.member.x, (_e895.member.x < _e923[0])), select(_e923[1], _e895.member.y, (_e895.member.y < _e923[1])), select(_e923[2], _e895.member.z, (_e895.member.z < _e923[2])), select(_e923[3], _e895.member.w, (_e895.member.w < _e923[3]))), vec4<f32>(select(_e923[4], _e895.member_1.x, (_e895.member_1.x > _e923[4])), select(_e923[5], _e895.member_1.y, (_e895.member_1.y > _e923[5])), select(_e923[6], _e895.member_1.z, (_e895.member_1.z > _e923[6])), select(_e923[7], _e895.member_1.w, (_e895.member_1.w > _e923[7]))));
                                            } else {
                                                phi_1960_ = _e893;
                                                phi_1961_ = _e895;
                                            }
                                            let _e963 = phi_1960_;
                                            let _e965 = phi_1961_;
                                            if ((_e891 & 1u) == 1u) {
                                                let _e968 = (_e891 - 1u);
                                                let _e969 = (_e889 + _e968);
                                                let _e970 = (_e969 < _e51);
                                                if _e970 {
                                                    if _e970 {
                                                    } else {
                                                        phi_2619_ = true;
                                                        break;
                                                    }
                                                    let _e973 = global_5.member[_e969];
                                                    phi_1980_ = _e973;
                                                } else {
                                                    phi_1980_ = array<f32, 8>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                                                }
                                                let _e975 = phi_1980_;
                                                phi_2050_ = _e968;
                                                phi_2051_ = type_31(vec4<f32>(select(_e975[0], _e965.member.x, (_e965.member.x < _e975[0])), select(_e975[1], _e965.member.y, (_e965.member.y < _e975[1])), select(_e975[2], _e965.member.z, (_e965.member.z < _e975[2])), select(_e975[3], _e965.member.w, (_e965.member.w < _e975[3]))), vec4<f32>(select(_e975[4], _e965.member_1.x, (_e965.member_1.x > _e975[4])), select(_e975[5], _e965.member_1.y, (_e965.member_1.y > _e975[5])), select(_e975[6], _e965.member_1.z, (_e965.member_1.z > _e975[6])), select(_e975[7], _e965.member_1.w, (_e965.member_1.w > _e975[7]))));
                                            } else {
                                                phi_2050_ = _e891;
                                                phi_2051_ = _e965;
                                            }
                                            let _e1014 = phi_2050_;
                                            let _e1016 = phi_2051_;
                                            let _e1020 = (_e887 / 2u);
                                            if ((_e887 % 2u) > 0u) {
                                                phi_2070_ = (_e1020 + 1u);
                                            } else {
                                                phi_2070_ = _e1020;
                                            }
                                            let _e1025 = phi_2070_;
                                            phi_2071_ = _e1025;
                                            phi_2072_ = (_e889 + _e887);
                                            phi_2073_ = (_e1014 / 2u);
                                            phi_2074_ = (_e963 / 2u);
                                            phi_2075_ = _e1016;
                                        }
                                        let _e1027 = phi_2071_;
                                        let _e1029 = phi_2072_;
                                        let _e1031 = phi_2073_;
                                        let _e1033 = phi_2074_;
                                        let _e1035 = phi_2075_;
                                        phi_1831_ = _e1027;
                                        phi_1833_ = _e1029;
                                        phi_1835_ = _e1031;
                                        phi_1837_ = _e1033;
                                        phi_1839_ = _e1035;
                                        phi_2077_ = select(true, false, _e914);
                                    } else {
                                        phi_1831_ = u32();
                                        phi_1833_ = u32();
                                        phi_1835_ = u32();
                                        phi_1837_ = u32();
                                        phi_1839_ = type_31();
                                        phi_2077_ = false;
                                    }
                                    let _e1038 = phi_1831_;
                                    let _e1040 = phi_1833_;
                                    let _e1042 = phi_1835_;
                                    let _e1044 = phi_1837_;
                                    let _e1046 = phi_1839_;
                                    let _e1048 = phi_2077_;
                                    continue;
                                    continuing {
                                        phi_1827_ = _e908;
                                        phi_1830_ = _e1038;
                                        phi_1832_ = _e1040;
                                        phi_1834_ = _e1042;
                                        phi_1836_ = _e1044;
                                        phi_1838_ = _e1046;
                                        phi_2619_ = _e877;
                                        break if !(_e1048);
                                    }
                                }
                                let _e1051 = phi_2619_;
                                if _e1051 {
                                    break;
                                }
                                let _e1563 = local_7;
                                phi_2078_ = _e1563;
                            }
                            let _e1175 = phi_2078_;
                            phi_2096_ = type_28(array<array<f32, 4>, 3>(array<f32, 4>(_e629.member.x, _e1175.member.x, _e629.member_1.x, _e1175.member_1.x), array<f32, 4>(_e629.member.y, _e1175.member.y, _e629.member_1.y, _e1175.member_1.y), array<f32, 4>(_e629.member.z, _e1175.member.z, _e629.member_1.z, _e1175.member_1.z)), _e71, _e75, _e79, _e83);
                        }
                        let _e1190 = phi_2096_;
                        let _e1193 = global_3.member[1u];
                        if (_e1193 == 0u) {
                            let _e1211 = global_3.member[0u];
                            phi_2123_ = bitcast<i32>(_e1211);
                        } else {
                            let _e1197 = global_3.member[0u];
                            let _e1201 = global_2.member[0u];
                            let _e1203 = (bitcast<i32>(_e1197) + bitcast<i32>(_e1201));
                            if (_e1203 < -126i) {
                                phi_2122_ = -126i;
                            } else {
                                phi_2122_ = select(_e1203, 127i, (_e1203 > 127i));
                            }
                            let _e1208 = phi_2122_;
                            phi_2123_ = _e1208;
                        }
                        let _e1214 = phi_2123_;
                        if (_e1190.member_1 == 2147483648u) {
                            phi_2141_ = type_40(vec3<f32>(0f, 0f, 0f), vec3<f32>(0f, 0f, 0f));
                        } else {
                            phi_2141_ = type_40(vec3<f32>(_e1190.member[0][0], _e1190.member[1][0], _e1190.member[2][0]), vec3<f32>(_e1190.member[0][2], _e1190.member[1][2], _e1190.member[2][2]));
                        }
                        let _e1233 = phi_2141_;
                        if (_e1190.member_2 == 2147483648u) {
                            phi_2159_ = _e1233;
                        } else {
                            phi_2159_ = type_40(vec3<f32>(_e1190.member[0][1], _e1190.member[1][1], _e1190.member[2][1]), vec3<f32>(_e1190.member[0][3], _e1190.member[1][3], _e1190.member[2][3]));
                        }
                        let _e1252 = phi_2159_;
                        let _e1275 = bitcast<f32>((bitcast<u32>((127i - _e1214)) << bitcast<u32>(23i)));
                        let _e1276 = (_e1233.member.x * _e1275);
                        let _e1277 = (_e1252.member.x * _e1275);
                        let _e1278 = (-(_e1233.member_1.x) * _e1275);
                        let _e1279 = (-(_e1252.member_1.x) * _e1275);
                        let _e1286 = select(0i, select(select(i32(_e1276), i32(-2147483648), (_e1276 < -2147483600f)), 2147483647i, (_e1276 > 2147483500f)), (_e1276 == _e1276));
                        let _e1293 = select(0i, select(select(i32(_e1277), i32(-2147483648), (_e1277 < -2147483600f)), 2147483647i, (_e1277 > 2147483500f)), (_e1277 == _e1277));
                        let _e1300 = select(0i, select(select(i32(_e1278), i32(-2147483648), (_e1278 < -2147483600f)), 2147483647i, (_e1278 > 2147483500f)), (_e1278 == _e1278));
                        let _e1307 = select(0i, select(select(i32(_e1279), i32(-2147483648), (_e1279 < -2147483600f)), 2147483647i, (_e1279 > 2147483500f)), (_e1279 == _e1279));
                        let _e1329 = (_e1233.member.y * _e1275);
                        let _e1330 = (_e1252.member.y * _e1275);
                        let _e1331 = (-(_e1233.member_1.y) * _e1275);
                        let _e1332 = (-(_e1252.member_1.y) * _e1275);
                        let _e1339 = select(0i, select(select(i32(_e1329), i32(-2147483648), (_e1329 < -2147483600f)), 2147483647i, (_e1329 > 2147483500f)), (_e1329 == _e1329));
                        let _e1346 = select(0i, select(select(i32(_e1330), i32(-2147483648), (_e1330 < -2147483600f)), 2147483647i, (_e1330 > 2147483500f)), (_e1330 == _e1330));
                        let _e1353 = select(0i, select(select(i32(_e1331), i32(-2147483648), (_e1331 < -2147483600f)), 2147483647i, (_e1331 > 2147483500f)), (_e1331 == _e1331));
                        let _e1360 = select(0i, select(select(i32(_e1332), i32(-2147483648), (_e1332 < -2147483600f)), 2147483647i, (_e1332 > 2147483500f)), (_e1332 == _e1332));
                        let _e1382 = (_e1233.member.z * _e1275);
                        let _e1383 = (_e1252.member.z * _e1275);
                        let _e1384 = (-(_e1233.member_1.z) * _e1275);
                        let _e1385 = (-(_e1252.member_1.z) * _e1275);
                        let _e1392 = select(0i, select(select(i32(_e1382), i32(-2147483648), (_e1382 < -2147483600f)), 2147483647i, (_e1382 > 2147483500f)), (_e1382 == _e1382));
                        let _e1399 = select(0i, select(select(i32(_e1383), i32(-2147483648), (_e1383 < -2147483600f)), 2147483647i, (_e1383 > 2147483500f)), (_e1383 == _e1383));
                        let _e1406 = select(0i, select(select(i32(_e1384), i32(-2147483648), (_e1384 < -2147483600f)), 2147483647i, (_e1384 > 2147483500f)), (_e1384 == _e1384));
                        let _e1413 = select(0i, select(select(i32(_e1385), i32(-2147483648), (_e1385 < -2147483600f)), 2147483647i, (_e1385 > 2147483500f)), (_e1385 == _e1385));
                        if _e64 {
                        } else {
                            break;
                        }
                        global_7.member[_e59] = type_35(array<array<i32, 4>, 3>(array<i32, 4>((_e1286 - select(0i, 1i, (f32(_e1286) > _e1276))), (_e1293 - select(0i, 1i, (f32(_e1293) > _e1277))), -((_e1300 - select(0i, 1i, (f32(_e1300) > _e1278)))), -((_e1307 - select(0i, 1i, (f32(_e1307) > _e1279))))), array<i32, 4>((_e1339 - select(0i, 1i, (f32(_e1339) > _e1329))), (_e1346 - select(0i, 1i, (f32(_e1346) > _e1330))), -((_e1353 - select(0i, 1i, (f32(_e1353) > _e1331)))), -((_e1360 - select(0i, 1i, (f32(_e1360) > _e1332))))), array<i32, 4>((_e1392 - select(0i, 1i, (f32(_e1392) > _e1382))), (_e1399 - select(0i, 1i, (f32(_e1399) > _e1383))), -((_e1406 - select(0i, 1i, (f32(_e1406) > _e1384)))), -((_e1413 - select(0i, 1i, (f32(_e1413) > _e1385)))))), _e1190.member_1, _e1190.member_2, _e1190.member_3, _e1190.member_4);
                    }
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn refit_rounded(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
