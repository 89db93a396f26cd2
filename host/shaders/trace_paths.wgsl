struct type_4 {
    member: array<u32>,
}

struct type_7 {
    member: u32,
    member_1: u32,
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

struct type_24 {
    member: array<type_22>,
}

struct type_26 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_27 {
    member: type_26,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_29 {
    member: array<type_27>,
}

struct type_34 {
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_36 {
    member: array<type_34>,
}

struct type_43 {
    member: type_22,
    member_1: f32,
}

struct type_47 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_51 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(1) 
var<storage> global_1: type_15;
@group(0) @binding(0) 
var<storage> global_2: type_36;
@group(0) @binding(2) 
var<storage> global_3: type_29;
@group(0) @binding(3) 
var<storage, read_write> global_4: type_24;
@group(0) @binding(4) 
var<storage, read_write> global_5: type_51;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_275_: u32;
    var phi_380_: i32;
    var phi_381_: i32;
    var phi_391_: bool;
    var phi_401_: u32;
    var phi_402_: u32;
    var phi_404_: bool;
    var phi_409_: u32;
    var phi_442_: i32;
    var phi_460_: f32;
    var phi_466_: f32;
    var phi_506_: f32;
    var phi_512_: f32;
    var phi_564_: f32;
    var phi_576_: f32;
    var phi_585_: f32;
    var phi_591_: f32;
    var phi_631_: f32;
    var phi_637_: f32;
    var phi_689_: f32;
    var phi_701_: f32;
    var phi_710_: f32;
    var phi_716_: f32;
    var phi_756_: f32;
    var phi_762_: f32;
    var phi_814_: f32;
    var phi_826_: f32;
    var phi_881_: i32;
    var phi_903_: u32;
    var phi_904_: u32;
    var phi_941_: i32;
    var phi_963_: u32;
    var phi_964_: u32;
    var phi_972_: f32;
    var phi_973_: f32;
    var phi_2885_: bool;
    var phi_988_: type_43;
    var phi_991_: u32;
    var phi_993_: bool;
    var phi_995_: u32;
    var phi_997_: u32;
    var phi_1008_: bool;
    var phi_1040_: bool;
    var phi_1041_: u32;
    var phi_1042_: u32;
    var phi_1057_: type_43;
    var phi_1060_: type_7;
    var phi_1061_: type_7;
    var phi_1083_: type_7;
    var phi_1104_: u32;
    var phi_1196_: array<array<f32, 3>, 3>;
    var phi_1348_: bool;
    var phi_1377_: bool;
    var phi_1796_: f32;
    var phi_1797_: f32;
    var phi_1798_: f32;
    var phi_1799_: f32;
    var phi_1800_: vec3<f32>;
    var phi_1801_: vec3<f32>;
    var phi_1802_: vec3<f32>;
    var phi_1803_: vec3<f32>;
    var phi_1840_: bool;
    var phi_1849_: vec3<f32>;
    var phi_2014_: f32;
    var phi_2016_: f32;
    var phi_2017_: bool;
    var phi_2037_: f32;
    var phi_2038_: f32;
    var phi_2061_: type_22;
    var phi_2063_: type_22;
    var phi_2064_: bool;
    var phi_2068_: type_22;
    var phi_2069_: type_22;
    var phi_2070_: type_22;
    var phi_2071_: bool;
    var phi_2075_: type_22;
    var phi_2076_: bool;
    var phi_2077_: type_22;
    var phi_2078_: bool;
    var phi_2079_: bool;
    var phi_2080_: type_22;
    var phi_2081_: bool;
    var phi_2082_: bool;
    var phi_2090_: type_22;
    var phi_2091_: bool;
    var phi_2095_: type_22;
    var phi_2120_: bool;
    var phi_2121_: bool;
    var phi_2127_: type_43;
    var phi_2128_: type_43;
    var phi_2129_: type_43;
    var phi_1058_: type_43;
    var phi_2879_: bool;
    var phi_3075_: bool;
    var phi_2130_: type_43;
    var phi_2195_: type_47;
    var phi_2557_: u32;
    var phi_2584_: u32;
    var phi_2585_: u32;
    var phi_2586_: u32;
    var phi_2588_: u32;
    var phi_2589_: u32;
    var phi_2590_: bool;
    var phi_2599_: u32;
    var phi_2604_: bool;
    var phi_2606_: u32;
    var phi_2610_: bool;
    var phi_2611_: u32;
    var phi_2612_: u32;
    var phi_3043_: bool;
    var phi_2623_: type_43;
    var phi_2624_: u32;
    var phi_2625_: bool;
    var phi_2626_: u32;
    var phi_2627_: u32;
    var phi_3042_: bool;
    var phi_2628_: type_43;
    var phi_2629_: u32;
    var phi_2630_: bool;
    var phi_2631_: u32;
    var phi_2632_: u32;
    var phi_3041_: bool;
    var phi_989_: type_43;
    var phi_992_: u32;
    var phi_994_: bool;
    var phi_996_: u32;
    var phi_998_: u32;
    var phi_2633_: bool;
    var phi_3040_: bool;
    var local_2: type_43;
    var phi_2671_: f32;
    var phi_2673_: f32;
    var phi_2674_: bool;
    var phi_2675_: f32;
    var phi_2676_: bool;
    var phi_2824_: u32;
    var phi_2842_: bool;
    var phi_2845_: bool;
    var phi_2858_: f32;
    var phi_2859_: f32;
    var phi_2864_: f32;
    var phi_2865_: f32;
    var phi_2866_: bool;
    var phi_2874_: f32;
    var phi_2691_: f32;
    var phi_2692_: f32;
    var phi_2704_: f32;
    var phi_2709_: type_22;
    var local_3: type_43;

    switch bitcast<i32>(0u) {
        default: {
            let _e74 = global;
            let _e76 = arrayLength((&global_2.member));
            let _e78 = arrayLength((&global_1.member));
            let _e84 = arrayLength((&global_5.member));
            let _e88 = (_e74.x + (_e74.y * 2097152u));
            let _e89 = (_e88 < arrayLength((&global_3.member)));
            if _e89 {
                if _e89 {
                } else {
                    break;
                }
                let _e93 = global_3.member[_e88].member_2;
                phi_275_ = _e93;
            } else {
                phi_275_ = 4294967295u;
            }
            let _e95 = phi_275_;
            if _e89 {
                let _e96 = (_e88 < arrayLength((&global_4.member)));
                if _e96 {
                    if _e89 {
                    } else {
                        break;
                    }
                    let _e106 = global_3.member[_e88].member.member_2[0u];
                    let _e108 = (bitcast<u32>(_e106) & 2147483647u);
                    let _e114 = global_3.member[_e88].member.member_2[1u];
                    let _e116 = (bitcast<u32>(_e114) & 2147483647u);
                    let _e122 = global_3.member[_e88].member.member_2[2u];
                    let _e124 = (bitcast<u32>(_e122) & 2147483647u);
                    let _e130 = global_3.member[_e88].member.member[0u];
                    let _e132 = (bitcast<u32>(_e130) & 2147483647u);
                    let _e138 = global_3.member[_e88].member.member[1u];
                    let _e140 = (bitcast<u32>(_e138) & 2147483647u);
                    let _e146 = global_3.member[_e88].member.member[2u];
                    let _e148 = (bitcast<u32>(_e146) & 2147483647u);
                    let _e150 = select(_e116, _e108, (_e116 < _e108));
                    let _e152 = select(_e124, _e150, (_e124 < _e150));
                    let _e154 = select(_e132, _e152, (_e132 < _e152));
                    let _e156 = select(_e140, _e154, (_e140 < _e154));
                    let _e158 = select(_e148, _e156, (_e148 < _e156));
                    let _e163 = global_3.member[_e88].member.member_1;
                    let _e164 = bitcast<u32>(_e163);
                    let _e165 = (_e164 & 2147483647u);
                    let _e173 = global_3.member[_e88].member.member_3;
                    let _e174 = bitcast<u32>(_e173);
                    let _e175 = (_e174 & 2147483647u);
                    let _e179 = (((select(_e165, _e158, (_e165 < _e158)) < 2139095040u) && (_e175 <= 2139095040u)) && (_e152 > 0u));
                    if _e179 {
                        let _e182 = (bitcast<u32>(bitcast<f32>(_e152)) & 2147483647u);
                        if (_e182 >= 8388608u) {
                            phi_380_ = (bitcast<i32>((_e182 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_380_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e182)), 32u, (_e182 == 0u))));
                        }
                        let _e196 = phi_380_;
                        phi_381_ = _e196;
                    } else {
                        phi_381_ = 0i;
                    }
                    let _e198 = phi_381_;
                    let _e199 = (_e108 == _e152);
                    if _e199 {
                        phi_391_ = true;
                    } else {
                        phi_391_ = (_e116 == _e152);
                    }
                    let _e202 = phi_391_;
                    let _e203 = select(1u, 0u, _e199);
                    if _e202 {
                        let _e204 = (_e203 + 1u);
                        phi_401_ = _e204;
                        phi_402_ = _e204;
                        phi_404_ = select(true, false, (_e204 == 2u));
                    } else {
                        phi_401_ = u32();
                        phi_402_ = 0u;
                        phi_404_ = true;
                    }
                    let _e208 = phi_401_;
                    let _e210 = phi_402_;
                    let _e212 = phi_404_;
                    if _e212 {
                        phi_409_ = (_e210 + 1u);
                    } else {
                        phi_409_ = 0u;
                    }
                    let _e216 = phi_409_;
                    let _e217 = select(_e208, _e210, _e212);
                    let _e218 = select(_e203, select(2u, _e203, _e202), _e212);
                    let _e219 = -(_e198);
                    if (_e219 < -126i) {
                        phi_442_ = -126i;
                    } else {
                        phi_442_ = select(_e219, 127i, (_e219 > 127i));
                    }
                    let _e224 = phi_442_;
                    let _e229 = bitcast<f32>((bitcast<u32>((_e224 + 127i)) << bitcast<u32>(23i)));
                    let _e235 = bitcast<f32>((bitcast<u32>(((_e219 - _e224) + 127i)) << bitcast<u32>(23i)));
                    let _e240 = global_3.member[_e88].member.member;
                    let _e241 = (_e217 == 0u);
                    if _e241 {
                        phi_460_ = _e240[0];
                    } else {
                        phi_460_ = _e240[1];
                    }
                    let _e245 = phi_460_;
                    let _e246 = (_e217 == 2u);
                    if _e246 {
                        phi_466_ = _e240[2];
                    } else {
                        phi_466_ = _e245;
                    }
                    let _e249 = phi_466_;
                    let _e250 = bitcast<u32>(_e249);
                    let _e252 = ((_e250 & 2139095040u) != 0u);
                    let _e264 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e250 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e250 & 2147483648u))), _e249, _e252) * select(0.00000011920929f, 1f, _e252));
                    let _e265 = global_3.member[_e88].member.member_2;
                    if _e241 {
                        phi_506_ = _e265[0];
                    } else {
                        phi_506_ = _e265[1];
                    }
                    let _e269 = phi_506_;
                    if _e246 {
                        phi_512_ = _e265[2];
                    } else {
                        phi_512_ = _e269;
                    }
                    let _e272 = phi_512_;
                    let _e273 = bitcast<u32>(_e272);
                    let _e275 = ((_e273 & 2139095040u) != 0u);
                    let _e289 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e273 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e273 & 2147483648u))), _e272, _e275) * _e229) * select(0.00000011920929f, 1f, _e275)) * _e235);
                    let _e293 = (bitcast<f32>((bitcast<u32>(_e289) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e293 {
                        let _e297 = (bitcast<f32>((bitcast<u32>(_e264) & 2147483647u)) * 0.00000011920929f);
                        phi_564_ = select(0.00000000000011368684f, _e297, (_e297 > 0.00000000000011368684f));
                    } else {
                        phi_564_ = 0f;
                    }
                    let _e301 = phi_564_;
                    let _e302 = (_e264 + _e301);
                    let _e303 = (_e264 - _e301);
                    let _e304 = select(_e289, 0f, _e293);
                    if _e293 {
                        phi_576_ = 38685626000000000000000000f;
                    } else {
                        phi_576_ = (1f / _e289);
                    }
                    let _e307 = phi_576_;
                    let _e308 = (_e216 == 0u);
                    if _e308 {
                        phi_585_ = _e240[0];
                    } else {
                        phi_585_ = _e240[1];
                    }
                    let _e312 = phi_585_;
                    let _e313 = (_e216 == 2u);
                    if _e313 {
                        phi_591_ = _e240[2];
                    } else {
                        phi_591_ = _e312;
                    }
                    let _e316 = phi_591_;
                    let _e317 = bitcast<u32>(_e316);
                    let _e319 = ((_e317 & 2139095040u) != 0u);
                    let _e331 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e317 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e317 & 2147483648u))), _e316, _e319) * select(0.00000011920929f, 1f, _e319));
                    if _e308 {
                        phi_631_ = _e265[0];
                    } else {
                        phi_631_ = _e265[1];
                    }
                    let _e335 = phi_631_;
                    if _e313 {
                        phi_637_ = _e265[2];
                    } else {
                        phi_637_ = _e335;
                    }
                    let _e338 = phi_637_;
                    let _e339 = bitcast<u32>(_e338);
                    let _e341 = ((_e339 & 2139095040u) != 0u);
                    let _e355 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e339 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e339 & 2147483648u))), _e338, _e341) * _e229) * select(0.00000011920929f, 1f, _e341)) * _e235);
                    let _e359 = (bitcast<f32>((bitcast<u32>(_e355) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e359 {
                        let _e363 = (bitcast<f32>((bitcast<u32>(_e331) & 2147483647u)) * 0.00000011920929f);
                        phi_689_ = select(0.00000000000011368684f, _e363, (_e363 > 0.00000000000011368684f));
                    } else {
                        phi_689_ = 0f;
                    }
                    let _e367 = phi_689_;
                    let _e368 = (_e331 + _e367);
                    let _e369 = (_e331 - _e367);
                    let _e370 = select(_e355, 0f, _e359);
                    if _e359 {
                        phi_701_ = 38685626000000000000000000f;
                    } else {
                        phi_701_ = (1f / _e355);
                    }
                    let _e373 = phi_701_;
                    let _e374 = (_e218 == 0u);
                    if _e374 {
                        phi_710_ = _e240[0];
                    } else {
                        phi_710_ = _e240[1];
                    }
                    let _e378 = phi_710_;
                    let _e379 = (_e218 == 2u);
                    if _e379 {
                        phi_716_ = _e240[2];
                    } else {
                        phi_716_ = _e378;
                    }
                    let _e382 = phi_716_;
                    let _e383 = bitcast<u32>(_e382);
                    let _e385 = ((_e383 & 2139095040u) != 0u);
                    let _e397 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e383 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e383 & 2147483648u))), _e382, _e385) * select(0.00000011920929f, 1f, _e385));
                    if _e374 {
                        phi_756_ = _e265[0];
                    } else {
                        phi_756_ = _e265[1];
                    }
                    let _e401 = phi_756_;
                    if _e379 {
                        phi_762_ = _e265[2];
                    } else {
                        phi_762_ = _e401;
                    }
                    let _e404 = phi_762_;
                    let _e405 = bitcast<u32>(_e404);
                    let _e407 = ((_e405 & 2139095040u) != 0u);
                    let _e421 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e405 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e405 & 2147483648u))), _e404, _e407) * _e229) * select(0.00000011920929f, 1f, _e407)) * _e235);
                    let _e425 = (bitcast<f32>((bitcast<u32>(_e421) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e425 {
                        let _e429 = (bitcast<f32>((bitcast<u32>(_e397) & 2147483647u)) * 0.00000011920929f);
                        phi_814_ = select(0.00000000000011368684f, _e429, (_e429 > 0.00000000000011368684f));
                    } else {
                        phi_814_ = 0f;
                    }
                    let _e433 = phi_814_;
                    let _e434 = (_e397 + _e433);
                    let _e435 = (_e397 - _e433);
                    let _e436 = select(_e421, 0f, _e425);
                    if _e425 {
                        phi_826_ = 38685626000000000000000000f;
                    } else {
                        phi_826_ = (1f / _e421);
                    }
                    let _e439 = phi_826_;
                    let _e442 = bitcast<f32>((bitcast<u32>(_e264) & 2147483647u));
                    let _e445 = bitcast<f32>((bitcast<u32>(_e331) & 2147483647u));
                    let _e447 = select(_e445, _e442, (_e442 > _e445));
                    let _e450 = bitcast<f32>((bitcast<u32>(_e397) & 2147483647u));
                    if (_e179 && (select(_e450, _e447, (_e447 > _e450)) <= 1099511600000f)) {
                        let _e462 = ((_e165 & 8388607u) | (select(0u, 1u, ((_e165 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e465 = bitcast<i32>((_e165 >> bitcast<u32>(23i)));
                        let _e469 = (_e462 == 0u);
                        let _e472 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e462)), 32u, _e469)) - 8i);
                        if (_e465 == 255i) {
                            phi_881_ = 255i;
                        } else {
                            phi_881_ = (((_e465 + select(0i, 1i, (_e465 == 0i))) - _e472) + _e198);
                        }
                        let _e480 = phi_881_;
                        let _e490 = (_e480 <= 0i);
                        if _e490 {
                            phi_904_ = u32();
                        } else {
                            if _e469 {
                                phi_903_ = u32();
                            } else {
                                phi_903_ = select(((bitcast<u32>(_e480) << bitcast<u32>(23i)) | ((_e462 << bitcast<u32>(((_e472 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e480 >= 255i));
                            }
                            let _e494 = phi_903_;
                            phi_904_ = _e494;
                        }
                        let _e496 = phi_904_;
                        let _e508 = ((_e175 & 8388607u) | (select(0u, 1u, ((_e175 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e511 = bitcast<i32>((_e175 >> bitcast<u32>(23i)));
                        let _e515 = (_e508 == 0u);
                        let _e518 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e508)), 32u, _e515)) - 8i);
                        if (_e511 == 255i) {
                            phi_941_ = 255i;
                        } else {
                            phi_941_ = (((_e511 + select(0i, 1i, (_e511 == 0i))) - _e518) + _e198);
                        }
                        let _e526 = phi_941_;
                        let _e536 = (_e526 <= 0i);
                        if _e536 {
                            phi_964_ = u32();
                        } else {
                            if _e515 {
                                phi_963_ = u32();
                            } else {
                                phi_963_ = select(((bitcast<u32>(_e526) << bitcast<u32>(23i)) | ((_e508 << bitcast<u32>(((_e518 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e526 >= 255i));
                            }
                            let _e540 = phi_963_;
                            phi_964_ = _e540;
                        }
                        let _e542 = phi_964_;
                        phi_972_ = bitcast<f32>(((_e174 & 2147483648u) | select(_e542, 0u, select(_e515, true, _e536))));
                        phi_973_ = bitcast<f32>(((_e164 & 2147483648u) | select(_e496, 0u, select(_e469, true, _e490))));
                    } else {
                        phi_972_ = 0f;
                        phi_973_ = 1f;
                    }
                    let _e548 = phi_972_;
                    let _e550 = phi_973_;
                    local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    phi_2885_ = false;
                    phi_988_ = type_43(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e548);
                    phi_991_ = ((3u * _e76) + 1u);
                    phi_993_ = (_e550 <= _e548);
                    phi_995_ = 0u;
                    phi_997_ = select(0u, 2147483648u, (_e76 == 0u));
                    loop {
                        let _e558 = phi_2885_;
                        let _e560 = phi_988_;
                        let _e562 = phi_991_;
                        let _e564 = phi_993_;
                        let _e566 = phi_995_;
                        let _e568 = phi_997_;
                        local_2 = _e560;
                        if _e564 {
                            phi_1008_ = true;
                        } else {
                            phi_1008_ = (_e566 > 0u);
                        }
                        let _e571 = phi_1008_;
                        if _e571 {
                            let _e572 = (_e562 > 0u);
                            if _e572 {
                                if _e564 {
                                    phi_1040_ = _e564;
                                    phi_1041_ = _e566;
                                    phi_1042_ = _e568;
                                } else {
                                    let _e573 = (_e566 - 1u);
                                    let _e574 = (_e573 % 128u);
                                    let _e575 = (_e574 < 128u);
                                    if _e575 {
                                    } else {
                                        phi_3040_ = true;
                                        break;
                                    }
                                    let _e577 = local_1[_e574];
                                    if _e575 {
                                    } else {
                                        phi_3040_ = true;
                                        break;
                                    }
                                    let _e579 = local[_e574];
                                    phi_1040_ = (_e579 <= _e560.member_1);
                                    phi_1041_ = _e573;
                                    phi_1042_ = _e577;
                                }
                                let _e583 = phi_1040_;
                                let _e585 = phi_1041_;
                                let _e587 = phi_1042_;
                                if _e583 {
                                    let _e590 = ((_e587 & 2147483648u) != 0u);
                                    if _e590 {
                                        phi_1057_ = _e560;
                                        phi_1060_ = type_7(0u, ((_e587 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e597 = phi_1057_;
                                            let _e599 = phi_1060_;
                                            local_3 = _e597;
                                            if (_e599.member < _e599.member_1) {
                                                phi_1061_ = type_7((_e599.member + 1u), _e599.member_1);
                                                phi_1083_ = type_7(1u, _e599.member);
                                            } else {
                                                phi_1061_ = _e599;
                                                phi_1083_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e612 = phi_1061_;
                                            let _e614 = phi_1083_;
                                            let _e618 = (bitcast<i32>(_e614.member) != 0i);
                                            if _e618 {
                                                let _e619 = ((_e587 & 268435455u) + _e614.member_1);
                                                let _e620 = (_e619 < _e78);
                                                if _e620 {
                                                    if _e620 {
                                                    } else {
                                                        phi_2879_ = true;
                                                        break;
                                                    }
                                                    let _e624 = global_1.member[_e619].member_1;
                                                    phi_1104_ = _e624;
                                                } else {
                                                    phi_1104_ = 4294967295u;
                                                }
                                                let _e626 = phi_1104_;
                                                if (_e619 >= _e78) {
                                                    phi_1196_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e620 {
                                                    } else {
                                                        phi_2879_ = true;
                                                        break;
                                                    }
                                                    let _e628 = (_e217 % 3u);
                                                    let _e629 = (_e216 % 3u);
                                                    let _e630 = (_e218 % 3u);
                                                    if (_e628 < 9u) {
                                                    } else {
                                                        phi_2879_ = true;
                                                        break;
                                                    }
                                                    let _e636 = global_1.member[_e619].member[_e628];
                                                    if (_e629 < 9u) {
                                                    } else {
                                                        phi_2879_ = true;
                                                        break;
                                                    }
                                                    let _e642 = global_1.member[_e619].member[_e629];
                                                    if (_e630 < 9u) {
                                                    } else {
                                                        phi_2879_ = true;
                                                        break;
                                                    }
                                                    let _e648 = global_1.member[_e619].member[_e630];
                                                    let _e650 = (3u + _e628);
                                                    if (_e650 < 9u) {
                                                    } else {
                                                        phi_2879_ = true;
                                                        break;
                                                    }
                                                    let _e656 = global_1.member[_e619].member[_e650];
                                                    let _e657 = (3u + _e629);
                                                    if (_e657 < 9u) {
                                                    } else {
                                                        phi_2879_ = true;
                                                        break;
                                                    }
                                                    let _e663 = global_1.member[_e619].member[_e657];
                                                    let _e664 = (3u + _e630);
                                                    if (_e664 < 9u) {
                                                    } else {
                                                        phi_2879_ = true;
                                                        break;
                                                    }
                                                    let _e670 = global_1.member[_e619].member[_e664];
                                                    let _e672 = (6u + _e628);
                                                    if (_e672 < 9u) {
                                                    } else {
                                                        phi_2879_ = true;
                                                        break;
                                                    }
                                                    let _e678 = global_1.member[_e619].member[_e672];
                                                    let _e679 = (6u + _e629);
                                                    if (_e679 < 9u) {
                                                    } else {
                                                        phi_2879_ = true;
                                                        break;
                                                    }
                                                    let _e685 = global_1.member[_e619].member[_e679];
                                                    let _e686 = (6u + _e630);
                                                    if (_e686 < 9u) {
                                                    } else {
                                                        phi_2879_ = true;
                                                        break;
                                                    }
                                                    let _e692 = global_1.member[_e619].member[_e686];
                                                    phi_1196_ = array<array<f32, 3>, 3>(array<f32, 3>(_e636, _e642, _e648), array<f32, 3>(_e656, _e663, _e670), array<f32, 3>(_e678, _e685, _e692));
                                                }
                                                let _e696 = phi_1196_;
                                                let _e704 = (_e696[0][2] - _e397);
                                                let _e707 = (((_e696[0][0] - _e264) * _e436) - (_e704 * _e304));
                                                let _e710 = (((_e696[0][1] - _e331) * _e436) - (_e704 * _e370));
                                                let _e717 = (_e696[1][2] - _e397);
                                                let _e720 = (((_e696[1][0] - _e264) * _e436) - (_e717 * _e304));
                                                let _e723 = (((_e696[1][1] - _e331) * _e436) - (_e717 * _e370));
                                                let _e730 = (_e696[2][2] - _e397);
                                                let _e733 = (((_e696[2][0] - _e264) * _e436) - (_e730 * _e304));
                                                let _e736 = (((_e696[2][1] - _e331) * _e436) - (_e730 * _e370));
                                                let _e737 = (_e733 * _e723);
                                                let _e738 = (_e736 * _e720);
                                                let _e739 = (_e707 * _e736);
                                                let _e740 = (_e710 * _e733);
                                                let _e741 = (_e720 * _e710);
                                                let _e742 = (_e723 * _e707);
                                                let _e747 = (((_e737 >= _e738) && (_e739 >= _e740)) && (_e741 >= _e742));
                                                if (_e747 || (((_e737 <= _e738) && (_e739 <= _e740)) && (_e741 <= _e742))) {
                                                    let _e754 = select(-1f, 1f, _e747);
                                                    let _e756 = ((_e737 - _e738) * _e754);
                                                    let _e758 = select(0f, _e756, (_e756 > 0f));
                                                    let _e760 = ((_e739 - _e740) * _e754);
                                                    let _e762 = select(0f, _e760, (_e760 > 0f));
                                                    let _e764 = ((_e741 - _e742) * _e754);
                                                    let _e766 = select(0f, _e764, (_e764 > 0f));
                                                    let _e768 = ((_e758 + _e762) + _e766);
                                                    if (_e768 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2080_ = type_22();
                                                        phi_2081_ = true;
                                                        phi_2082_ = false;
                                                    } else {
                                                        let _e771 = select(_e720, _e707, (_e707 < _e720));
                                                        if (select(_e733, _e771, (_e771 < _e733)) > 0f) {
                                                            phi_1348_ = true;
                                                        } else {
                                                            let _e776 = select(_e720, _e707, (_e707 > _e720));
                                                            phi_1348_ = (select(_e733, _e776, (_e776 > _e733)) < 0f);
                                                        }
                                                        let _e781 = phi_1348_;
                                                        if _e781 {
                                                            phi_2077_ = type_22();
                                                            phi_2078_ = true;
                                                            phi_2079_ = false;
                                                        } else {
                                                            let _e783 = select(_e723, _e710, (_e710 < _e723));
                                                            if (select(_e736, _e783, (_e783 < _e736)) > 0f) {
                                                                phi_1377_ = true;
                                                            } else {
                                                                let _e788 = select(_e723, _e710, (_e710 > _e723));
                                                                phi_1377_ = (select(_e736, _e788, (_e788 > _e736)) < 0f);
                                                            }
                                                            let _e793 = phi_1377_;
                                                            if _e793 {
                                                                phi_2075_ = type_22();
                                                                phi_2076_ = false;
                                                            } else {
                                                                let _e795 = select(_e696[1][0], _e696[0][0], (_e696[0][0] < _e696[1][0]));
                                                                let _e799 = select(_e696[1][0], _e696[0][0], (_e696[0][0] > _e696[1][0]));
                                                                let _e803 = select(_e696[1][1], _e696[0][1], (_e696[0][1] < _e696[1][1]));
                                                                let _e807 = select(_e696[1][1], _e696[0][1], (_e696[0][1] > _e696[1][1]));
                                                                let _e811 = select(_e696[1][2], _e696[0][2], (_e696[0][2] < _e696[1][2]));
                                                                let _e815 = select(_e696[1][2], _e696[0][2], (_e696[0][2] > _e696[1][2]));
                                                                let _e820 = ((select(_e696[2][0], _e795, (_e795 < _e696[2][0])) - _e302) * _e307);
                                                                let _e821 = ((select(_e696[2][0], _e799, (_e799 > _e696[2][0])) - _e303) * _e307);
                                                                let _e824 = ((select(_e696[2][1], _e803, (_e803 < _e696[2][1])) - _e368) * _e373);
                                                                let _e825 = ((select(_e696[2][1], _e807, (_e807 > _e696[2][1])) - _e369) * _e373);
                                                                let _e828 = ((select(_e696[2][2], _e811, (_e811 < _e696[2][2])) - _e434) * _e439);
                                                                let _e829 = ((select(_e696[2][2], _e815, (_e815 > _e696[2][2])) - _e435) * _e439);
                                                                let _e831 = select(_e829, _e828, (_e828 < _e829));
                                                                let _e833 = select(_e829, _e828, (_e828 > _e829));
                                                                let _e835 = select(_e821, _e820, (_e820 < _e821));
                                                                let _e837 = select(_e825, _e824, (_e824 < _e825));
                                                                let _e839 = select(_e837, _e835, (_e835 > _e837));
                                                                let _e841 = select(_e831, _e839, (_e839 > _e831));
                                                                let _e843 = select(_e821, _e820, (_e820 > _e821));
                                                                let _e845 = select(_e825, _e824, (_e824 > _e825));
                                                                let _e847 = select(_e845, _e843, (_e843 < _e845));
                                                                let _e849 = select(_e833, _e847, (_e847 < _e833));
                                                                let _e850 = -(_e831);
                                                                let _e856 = select(_e550, _e841, (_e841 > _e550));
                                                                if (_e856 > (_e849 + (select(_e850, _e833, (_e833 > _e850)) * 0.0000019073523f))) {
                                                                    phi_2070_ = type_22();
                                                                    phi_2071_ = true;
                                                                } else {
                                                                    let _e858 = (_e856 > _e597.member_1);
                                                                    if _e858 {
                                                                        phi_2069_ = type_22();
                                                                    } else {
                                                                        let _e859 = vec3<f32>(_e696[0][0], _e696[0][1], _e696[0][2]);
                                                                        let _e860 = vec3<f32>(_e696[1][0], _e696[1][1], _e696[1][2]);
                                                                        let _e861 = vec3<f32>(_e696[2][0], _e696[2][1], _e696[2][2]);
                                                                        let _e862 = (_e696[1][0] - _e696[0][0]);
                                                                        let _e863 = (_e696[1][1] - _e696[0][1]);
                                                                        let _e864 = (_e696[1][2] - _e696[0][2]);
                                                                        let _e865 = vec3<f32>(_e862, _e863, _e864);
                                                                        let _e866 = (_e696[2][0] - _e696[1][0]);
                                                                        let _e867 = (_e696[2][1] - _e696[1][1]);
                                                                        let _e868 = (_e696[2][2] - _e696[1][2]);
                                                                        let _e869 = vec3<f32>(_e866, _e867, _e868);
                                                                        let _e870 = (_e696[0][0] - _e696[2][0]);
                                                                        let _e871 = (_e696[0][1] - _e696[2][1]);
                                                                        let _e872 = (_e696[0][2] - _e696[2][2]);
                                                                        let _e873 = vec3<f32>(_e870, _e871, _e872);
                                                                        let _e876 = bitcast<f32>((bitcast<u32>(_e862) & 2147483647u));
                                                                        let _e879 = bitcast<f32>((bitcast<u32>(_e863) & 2147483647u));
                                                                        let _e881 = select(_e879, _e876, (_e876 > _e879));
                                                                        let _e884 = bitcast<f32>((bitcast<u32>(_e864) & 2147483647u));
                                                                        let _e886 = select(_e884, _e881, (_e881 > _e884));
                                                                        let _e889 = bitcast<f32>((bitcast<u32>(_e866) & 2147483647u));
                                                                        let _e892 = bitcast<f32>((bitcast<u32>(_e867) & 2147483647u));
                                                                        let _e894 = select(_e892, _e889, (_e889 > _e892));
                                                                        let _e897 = bitcast<f32>((bitcast<u32>(_e868) & 2147483647u));
                                                                        let _e899 = select(_e897, _e894, (_e894 > _e897));
                                                                        let _e902 = bitcast<f32>((bitcast<u32>(_e870) & 2147483647u));
                                                                        let _e905 = bitcast<f32>((bitcast<u32>(_e871) & 2147483647u));
                                                                        let _e907 = select(_e905, _e902, (_e902 > _e905));
                                                                        let _e910 = bitcast<f32>((bitcast<u32>(_e872) & 2147483647u));
                                                                        let _e912 = select(_e910, _e907, (_e907 > _e910));
                                                                        let _e914 = select(_e899, _e886, (_e886 > _e899));
                                                                        let _e916 = select(_e912, _e914, (_e914 > _e912));
                                                                        if (_e886 == _e916) {
                                                                            phi_1796_ = _e723;
                                                                            phi_1797_ = _e720;
                                                                            phi_1798_ = _e710;
                                                                            phi_1799_ = _e707;
                                                                            phi_1800_ = _e859;
                                                                            phi_1801_ = _e873;
                                                                            phi_1802_ = _e869;
                                                                            phi_1803_ = _e865;
                                                                        } else {
                                                                            let _e918 = (_e899 == _e916);
                                                                            let _e923 = vec3(_e918);
                                                                            phi_1796_ = select(_e710, _e736, _e918);
                                                                            phi_1797_ = select(_e707, _e733, _e918);
                                                                            phi_1798_ = select(_e736, _e723, _e918);
                                                                            phi_1799_ = select(_e733, _e720, _e918);
                                                                            phi_1800_ = select(_e861, _e860, _e923);
                                                                            phi_1801_ = select(_e869, _e865, _e923);
                                                                            phi_1802_ = select(_e865, _e873, _e923);
                                                                            phi_1803_ = select(_e873, _e869, _e923);
                                                                        }
                                                                        let _e929 = phi_1796_;
                                                                        let _e931 = phi_1797_;
                                                                        let _e933 = phi_1798_;
                                                                        let _e935 = phi_1799_;
                                                                        let _e937 = phi_1800_;
                                                                        let _e939 = phi_1801_;
                                                                        let _e941 = phi_1802_;
                                                                        let _e943 = phi_1803_;
                                                                        let _e950 = ((_e941.y * _e939.z) - (_e939.y * _e941.z));
                                                                        let _e955 = ((_e941.z * _e939.x) - (_e939.z * _e941.x));
                                                                        let _e958 = ((_e941.x * _e939.y) - (_e939.x * _e941.y));
                                                                        if (_e758 >= _e762) {
                                                                            phi_1840_ = select(true, false, (_e758 >= _e766));
                                                                        } else {
                                                                            phi_1840_ = true;
                                                                        }
                                                                        let _e963 = phi_1840_;
                                                                        if _e963 {
                                                                            phi_1849_ = select(_e861, _e860, vec3((_e762 >= _e766)));
                                                                        } else {
                                                                            phi_1849_ = _e859;
                                                                        }
                                                                        let _e968 = phi_1849_;
                                                                        let _e979 = (((_e950 * (_e968.x - _e264)) + (_e955 * (_e968.y - _e331))) + (_e958 * (_e968.z - _e397)));
                                                                        let _e984 = (((_e950 * _e304) + (_e955 * _e370)) + (_e958 * _e436));
                                                                        let _e985 = (_e931 - _e935);
                                                                        let _e986 = (_e929 - _e933);
                                                                        let _e994 = (-(((_e935 * _e985) + (_e933 * _e986))) / ((_e985 * _e985) + (_e986 * _e986)));
                                                                        let _e996 = select(1f, _e994, (_e994 < 1f));
                                                                        let _e998 = select(0f, _e996, (_e996 > 0f));
                                                                        let _e1011 = ((_e937.x + (_e943.x * _e998)) - _e264);
                                                                        let _e1012 = ((_e937.y + (_e943.y * _e998)) - _e331);
                                                                        let _e1013 = ((_e937.z + (_e943.z * _e998)) - _e397);
                                                                        let _e1014 = (_e1013 / _e436);
                                                                        let _e1026 = bitcast<f32>((bitcast<u32>(_e1011) & 2147483647u));
                                                                        let _e1029 = bitcast<f32>((bitcast<u32>(_e1012) & 2147483647u));
                                                                        let _e1031 = select(_e1029, _e1026, (_e1026 > _e1029));
                                                                        let _e1034 = bitcast<f32>((bitcast<u32>(_e1013) & 2147483647u));
                                                                        let _e1036 = select(_e1034, _e1031, (_e1031 > _e1034));
                                                                        let _e1042 = bitcast<f32>((bitcast<u32>(_e950) & 2147483647u));
                                                                        let _e1045 = bitcast<f32>((bitcast<u32>(_e955) & 2147483647u));
                                                                        let _e1047 = select(_e1045, _e1042, (_e1042 > _e1045));
                                                                        let _e1050 = bitcast<f32>((bitcast<u32>(_e958) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e950 * _e1011) + (_e955 * _e1012)) + (_e958 * _e1013)) - _e979)) & 2147483647u)) <= ((0.0000009536743f * select(_e916, _e1036, (_e1036 > _e916))) * select(_e1050, _e1047, (_e1047 > _e1050)))) {
                                                                            let _e1060 = bitcast<f32>((bitcast<u32>(_e941.x) & 2147483647u));
                                                                            let _e1063 = bitcast<f32>((bitcast<u32>(_e941.y) & 2147483647u));
                                                                            let _e1065 = select(_e1063, _e1060, (_e1060 > _e1063));
                                                                            let _e1068 = bitcast<f32>((bitcast<u32>(_e941.z) & 2147483647u));
                                                                            let _e1074 = bitcast<f32>((bitcast<u32>(_e939.x) & 2147483647u));
                                                                            let _e1077 = bitcast<f32>((bitcast<u32>(_e939.y) & 2147483647u));
                                                                            let _e1079 = select(_e1077, _e1074, (_e1074 > _e1077));
                                                                            let _e1082 = bitcast<f32>((bitcast<u32>(_e939.z) & 2147483647u));
                                                                            let _e1086 = (bitcast<f32>((bitcast<u32>(_e984) & 2147483647u)) > ((0.0000038146973f * select(_e1068, _e1065, (_e1065 > _e1068))) * select(_e1082, _e1079, (_e1079 > _e1082))));
                                                                            if _e1086 {
                                                                                phi_2014_ = (_e979 / _e984);
                                                                            } else {
                                                                                phi_2014_ = f32();
                                                                            }
                                                                            let _e1089 = phi_2014_;
                                                                            phi_2016_ = _e1089;
                                                                            phi_2017_ = select(true, false, _e1086);
                                                                        } else {
                                                                            phi_2016_ = f32();
                                                                            phi_2017_ = true;
                                                                        }
                                                                        let _e1092 = phi_2016_;
                                                                        let _e1094 = phi_2017_;
                                                                        if _e1094 {
                                                                            let _e1102 = (((_e950 * (_e1011 - (_e304 * _e1014))) + (_e955 * (_e1012 - (_e370 * _e1014)))) / _e984);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1102) & 2147483647u)) <= _e916) {
                                                                                phi_2037_ = (_e1014 + _e1102);
                                                                            } else {
                                                                                phi_2037_ = _e1014;
                                                                            }
                                                                            let _e1109 = phi_2037_;
                                                                            phi_2038_ = _e1109;
                                                                        } else {
                                                                            phi_2038_ = _e1092;
                                                                        }
                                                                        let _e1111 = phi_2038_;
                                                                        let _e1113 = select(_e849, _e1111, (_e1111 < _e849));
                                                                        let _e1115 = select(_e841, _e1113, (_e1113 > _e841));
                                                                        if (_e1115 >= _e550) {
                                                                            let _e1117 = (_e1115 <= _e597.member_1);
                                                                            if _e1117 {
                                                                                let _e1118 = (1f / _e768);
                                                                                phi_2061_ = type_22(_e1115, (_e762 * _e1118), (_e766 * _e1118), _e626);
                                                                            } else {
                                                                                phi_2061_ = type_22();
                                                                            }
                                                                            let _e1123 = phi_2061_;
                                                                            phi_2063_ = _e1123;
                                                                            phi_2064_ = select(true, false, _e1117);
                                                                        } else {
                                                                            phi_2063_ = type_22();
                                                                            phi_2064_ = true;
                                                                        }
                                                                        let _e1126 = phi_2063_;
                                                                        let _e1128 = phi_2064_;
                                                                        if _e1128 {
                                                                            phi_2068_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2068_ = _e1126;
                                                                        }
                                                                        let _e1130 = phi_2068_;
                                                                        phi_2069_ = _e1130;
                                                                    }
                                                                    let _e1132 = phi_2069_;
                                                                    phi_2070_ = _e1132;
                                                                    phi_2071_ = _e858;
                                                                }
                                                                let _e1134 = phi_2070_;
                                                                let _e1136 = phi_2071_;
                                                                phi_2075_ = _e1134;
                                                                phi_2076_ = _e1136;
                                                            }
                                                            let _e1138 = phi_2075_;
                                                            let _e1140 = phi_2076_;
                                                            phi_2077_ = _e1138;
                                                            phi_2078_ = _e793;
                                                            phi_2079_ = _e1140;
                                                        }
                                                        let _e1142 = phi_2077_;
                                                        let _e1144 = phi_2078_;
                                                        let _e1146 = phi_2079_;
                                                        phi_2080_ = _e1142;
                                                        phi_2081_ = _e1144;
                                                        phi_2082_ = _e1146;
                                                    }
                                                    let _e1148 = phi_2080_;
                                                    let _e1150 = phi_2081_;
                                                    let _e1152 = phi_2082_;
                                                    phi_2090_ = _e1148;
                                                    phi_2091_ = select(_e1152, true, _e1150);
                                                } else {
                                                    phi_2090_ = type_22();
                                                    phi_2091_ = true;
                                                }
                                                let _e1155 = phi_2090_;
                                                let _e1157 = phi_2091_;
                                                if _e1157 {
                                                    phi_2095_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2095_ = _e1155;
                                                }
                                                let _e1159 = phi_2095_;
                                                if (_e1159.member_3 != 4294967295u) {
                                                    if (_e626 != _e95) {
                                                        if (_e1159.member < _e597.member.member) {
                                                            phi_2121_ = true;
                                                        } else {
                                                            if (_e1159.member == _e597.member.member) {
                                                                phi_2120_ = (_e1159.member_3 < _e597.member.member_3);
                                                            } else {
                                                                phi_2120_ = false;
                                                            }
                                                            let _e1172 = phi_2120_;
                                                            phi_2121_ = _e1172;
                                                        }
                                                        let _e1174 = phi_2121_;
                                                        if _e1174 {
                                                            phi_2127_ = type_43(_e1159, _e1159.member);
                                                        } else {
                                                            phi_2127_ = _e597;
                                                        }
                                                        let _e1177 = phi_2127_;
                                                        phi_2128_ = _e1177;
                                                    } else {
                                                        phi_2128_ = _e597;
                                                    }
                                                    let _e1179 = phi_2128_;
                                                    phi_2129_ = _e1179;
                                                } else {
                                                    phi_2129_ = _e597;
                                                }
                                                let _e1181 = phi_2129_;
                                                phi_1058_ = _e1181;
                                            } else {
                                                phi_1058_ = type_43();
                                            }
                                            let _e1183 = phi_1058_;
                                            continue;
                                            continuing {
                                                phi_1057_ = _e1183;
                                                phi_1060_ = _e612;
                                                phi_2879_ = _e558;
                                                break if !(_e618);
                                            }
                                        }
                                        let _e1186 = phi_2879_;
                                        phi_3040_ = _e1186;
                                        if _e1186 {
                                            break;
                                        }
                                        phi_3075_ = _e1186;
                                        let _e1677 = local_3;
                                        phi_2130_ = _e1677;
                                    } else {
                                        phi_3075_ = _e558;
                                        phi_2130_ = _e560;
                                    }
                                    let _e1188 = phi_3075_;
                                    let _e1190 = phi_2130_;
                                    if _e590 {
                                        phi_2610_ = bool();
                                        phi_2611_ = u32();
                                        phi_2612_ = u32();
                                    } else {
                                        if (_e587 >= _e76) {
                                            phi_2195_ = type_47(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e587 < _e76) {
                                            } else {
                                                phi_3040_ = true;
                                                break;
                                            }
                                            let _e1193 = (_e217 % 3u);
                                            if (_e1193 < 3u) {
                                            } else {
                                                phi_3040_ = true;
                                                break;
                                            }
                                            let _e1199 = global_2.member[_e587].member[_e1193];
                                            let _e1205 = (_e216 % 3u);
                                            if (_e1205 < 3u) {
                                            } else {
                                                phi_3040_ = true;
                                                break;
                                            }
                                            let _e1211 = global_2.member[_e587].member[_e1205];
                                            let _e1217 = (_e218 % 3u);
                                            if (_e1217 < 3u) {
                                            } else {
                                                phi_3040_ = true;
                                                break;
                                            }
                                            let _e1223 = global_2.member[_e587].member[_e1217];
                                            let _e1233 = global_2.member[_e587].member_1;
                                            let _e1237 = global_2.member[_e587].member_2;
                                            phi_2195_ = type_47(array<vec4<f32>, 3>(vec4<f32>(_e1199[0], _e1199[1], _e1199[2], _e1199[3]), vec4<f32>(_e1211[0], _e1211[1], _e1211[2], _e1211[3]), vec4<f32>(_e1223[0], _e1223[1], _e1223[2], _e1223[3])), _e1233, _e1237);
                                        }
                                        let _e1240 = phi_2195_;
                                        let _e1252 = ((_e1240.member[0].x - _e302) * _e307);
                                        let _e1253 = ((_e1240.member[0].y - _e302) * _e307);
                                        let _e1254 = ((_e1240.member[0].z - _e303) * _e307);
                                        let _e1255 = ((_e1240.member[0].w - _e303) * _e307);
                                        let _e1265 = ((_e1240.member[1].x - _e368) * _e373);
                                        let _e1266 = ((_e1240.member[1].y - _e368) * _e373);
                                        let _e1267 = ((_e1240.member[1].z - _e369) * _e373);
                                        let _e1268 = ((_e1240.member[1].w - _e369) * _e373);
                                        let _e1278 = ((_e1240.member[2].x - _e434) * _e439);
                                        let _e1279 = ((_e1240.member[2].y - _e434) * _e439);
                                        let _e1280 = ((_e1240.member[2].z - _e435) * _e439);
                                        let _e1281 = ((_e1240.member[2].w - _e435) * _e439);
                                        let _e1283 = select(_e1280, _e1278, (_e1278 < _e1280));
                                        let _e1285 = select(_e1281, _e1279, (_e1279 < _e1281));
                                        let _e1287 = select(_e1280, _e1278, (_e1278 > _e1280));
                                        let _e1289 = select(_e1281, _e1279, (_e1279 > _e1281));
                                        let _e1291 = select(_e1254, _e1252, (_e1252 < _e1254));
                                        let _e1293 = select(_e1255, _e1253, (_e1253 < _e1255));
                                        let _e1295 = select(_e1267, _e1265, (_e1265 < _e1267));
                                        let _e1297 = select(_e1268, _e1266, (_e1266 < _e1268));
                                        let _e1299 = select(_e1295, _e1291, (_e1291 > _e1295));
                                        let _e1301 = select(_e1297, _e1293, (_e1293 > _e1297));
                                        let _e1303 = select(_e1283, _e1299, (_e1299 > _e1283));
                                        let _e1305 = select(_e1285, _e1301, (_e1301 > _e1285));
                                        let _e1307 = select(_e1254, _e1252, (_e1252 > _e1254));
                                        let _e1309 = select(_e1255, _e1253, (_e1253 > _e1255));
                                        let _e1311 = select(_e1267, _e1265, (_e1265 > _e1267));
                                        let _e1313 = select(_e1268, _e1266, (_e1266 > _e1268));
                                        let _e1315 = select(_e1311, _e1307, (_e1307 < _e1311));
                                        let _e1317 = select(_e1313, _e1309, (_e1309 < _e1313));
                                        let _e1322 = -(_e1283);
                                        let _e1323 = -(_e1285);
                                        let _e1330 = (select(_e1287, _e1315, (_e1315 < _e1287)) + (select(_e1322, _e1287, (_e1287 > _e1322)) * 0.0000019073523f));
                                        let _e1331 = (select(_e1289, _e1317, (_e1317 < _e1289)) + (select(_e1323, _e1289, (_e1289 > _e1323)) * 0.0000019073523f));
                                        let _e1333 = select(_e550, _e1303, (_e1303 > _e550));
                                        let _e1335 = select(_e550, _e1305, (_e1305 > _e550));
                                        let _e1340 = (_e1333 <= select(_e1190.member_1, _e1330, (_e1330 < _e1190.member_1)));
                                        let _e1341 = (_e1335 <= select(_e1190.member_1, _e1331, (_e1331 < _e1190.member_1)));
                                        let _e1342 = (_e1333 <= _e1335);
                                        if _e1340 {
                                            if _e1341 {
                                                if _e1342 {
                                                    phi_2557_ = _e1240.member_2;
                                                } else {
                                                    phi_2557_ = _e1240.member_1;
                                                }
                                                let _e1346 = phi_2557_;
                                                let _e1348 = (_e585 % 128u);
                                                let _e1349 = (_e1348 < 128u);
                                                if _e1349 {
                                                } else {
                                                    phi_3040_ = true;
                                                    break;
                                                }
                                                local_1[_e1348] = _e1346;
                                                if _e1349 {
                                                } else {
                                                    phi_3040_ = true;
                                                    break;
                                                }
                                                local[_e1348] = select(_e1333, _e1335, _e1342);
                                                if _e1342 {
                                                    phi_2584_ = _e1240.member_1;
                                                } else {
                                                    phi_2584_ = _e1240.member_2;
                                                }
                                                let _e1356 = phi_2584_;
                                                phi_2585_ = (_e585 + 1u);
                                                phi_2586_ = _e1356;
                                            } else {
                                                phi_2585_ = u32();
                                                phi_2586_ = u32();
                                            }
                                            let _e1358 = phi_2585_;
                                            let _e1360 = phi_2586_;
                                            phi_2588_ = _e1358;
                                            phi_2589_ = _e1360;
                                            phi_2590_ = select(true, false, _e1341);
                                        } else {
                                            phi_2588_ = u32();
                                            phi_2589_ = u32();
                                            phi_2590_ = true;
                                        }
                                        let _e1363 = phi_2588_;
                                        let _e1365 = phi_2589_;
                                        let _e1367 = phi_2590_;
                                        if _e1367 {
                                            if _e1340 {
                                                phi_2599_ = _e1240.member_1;
                                            } else {
                                                phi_2599_ = _e1240.member_2;
                                            }
                                            let _e1371 = phi_2599_;
                                            phi_2604_ = select(_e1341, true, _e1340);
                                            phi_2606_ = _e1371;
                                        } else {
                                            phi_2604_ = _e583;
                                            phi_2606_ = _e1365;
                                        }
                                        let _e1374 = phi_2604_;
                                        let _e1376 = phi_2606_;
                                        phi_2610_ = _e1374;
                                        phi_2611_ = select(_e1363, _e585, _e1367);
                                        phi_2612_ = _e1376;
                                    }
                                    let _e1379 = phi_2610_;
                                    let _e1381 = phi_2611_;
                                    let _e1383 = phi_2612_;
                                    phi_3043_ = _e1188;
                                    phi_2623_ = _e1190;
                                    phi_2624_ = (_e562 - 1u);
                                    phi_2625_ = select(_e1379, false, _e590);
                                    phi_2626_ = select(_e1381, _e585, _e590);
                                    phi_2627_ = select(_e1383, _e587, _e590);
                                } else {
                                    phi_3043_ = _e558;
                                    phi_2623_ = _e560;
                                    phi_2624_ = _e562;
                                    phi_2625_ = _e583;
                                    phi_2626_ = _e585;
                                    phi_2627_ = _e587;
                                }
                                let _e1388 = phi_3043_;
                                let _e1390 = phi_2623_;
                                let _e1392 = phi_2624_;
                                let _e1394 = phi_2625_;
                                let _e1396 = phi_2626_;
                                let _e1398 = phi_2627_;
                                phi_3042_ = _e1388;
                                phi_2628_ = _e1390;
                                phi_2629_ = _e1392;
                                phi_2630_ = _e1394;
                                phi_2631_ = _e1396;
                                phi_2632_ = _e1398;
                            } else {
                                phi_3042_ = _e558;
                                phi_2628_ = type_43();
                                phi_2629_ = u32();
                                phi_2630_ = bool();
                                phi_2631_ = u32();
                                phi_2632_ = u32();
                            }
                            let _e1400 = phi_3042_;
                            let _e1402 = phi_2628_;
                            let _e1404 = phi_2629_;
                            let _e1406 = phi_2630_;
                            let _e1408 = phi_2631_;
                            let _e1410 = phi_2632_;
                            phi_3041_ = _e1400;
                            phi_989_ = _e1402;
                            phi_992_ = _e1404;
                            phi_994_ = _e1406;
                            phi_996_ = _e1408;
                            phi_998_ = _e1410;
                            phi_2633_ = _e572;
                        } else {
                            phi_3041_ = _e558;
                            phi_989_ = type_43();
                            phi_992_ = u32();
                            phi_994_ = bool();
                            phi_996_ = u32();
                            phi_998_ = u32();
                            phi_2633_ = false;
                        }
                        let _e1412 = phi_3041_;
                        let _e1414 = phi_989_;
                        let _e1416 = phi_992_;
                        let _e1418 = phi_994_;
                        let _e1420 = phi_996_;
                        let _e1422 = phi_998_;
                        let _e1424 = phi_2633_;
                        continue;
                        continuing {
                            phi_2885_ = _e1412;
                            phi_988_ = _e1414;
                            phi_991_ = _e1416;
                            phi_993_ = _e1418;
                            phi_995_ = _e1420;
                            phi_997_ = _e1422;
                            phi_3040_ = _e1412;
                            break if !(_e1424);
                        }
                    }
                    let _e1427 = phi_3040_;
                    if _e1427 {
                        break;
                    }
                    let _e1429 = local_2;
                    if (_e1429.member.member_3 != 4294967295u) {
                        let _e1434 = bitcast<u32>(_e1429.member.member);
                        let _e1438 = (bitcast<i32>((_e1434 >> bitcast<u32>(23i))) & 255i);
                        let _e1439 = (_e1438 + _e219);
                        if (_e1438 == 255i) {
                            phi_2692_ = _e1429.member.member;
                        } else {
                            if (_e1438 > 0i) {
                                if (_e1439 > 0i) {
                                    let _e1443 = (_e1439 < 255i);
                                    if _e1443 {
                                        phi_2671_ = bitcast<f32>((_e1434 + bitcast<u32>((_e219 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_2671_ = f32();
                                    }
                                    let _e1450 = phi_2671_;
                                    phi_2673_ = _e1450;
                                    phi_2674_ = select(true, false, _e1443);
                                } else {
                                    phi_2673_ = f32();
                                    phi_2674_ = true;
                                }
                                let _e1453 = phi_2673_;
                                let _e1455 = phi_2674_;
                                phi_2675_ = _e1453;
                                phi_2676_ = _e1455;
                            } else {
                                phi_2675_ = f32();
                                phi_2676_ = true;
                            }
                            let _e1457 = phi_2675_;
                            let _e1459 = phi_2676_;
                            if _e1459 {
                                let _e1460 = (_e1434 & 2147483648u);
                                let _e1467 = ((_e1434 & 8388607u) | (select(0u, 1u, ((_e1434 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e1471 = (_e1467 == 0u);
                                if _e1471 {
                                    phi_2874_ = bitcast<f32>(_e1460);
                                } else {
                                    let _e1476 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1467)), 32u, _e1471) - 8u);
                                    let _e1479 = (_e1467 << bitcast<u32>((_e1476 & 31u)));
                                    let _e1481 = ((_e1439 + select(0i, 1i, (_e1438 == 0i))) - bitcast<i32>(_e1476));
                                    if (_e1481 >= 255i) {
                                        phi_2864_ = bitcast<f32>((_e1460 | 2139095040u));
                                        phi_2865_ = f32();
                                        phi_2866_ = true;
                                    } else {
                                        let _e1483 = (_e1481 > 0i);
                                        if _e1483 {
                                            phi_2858_ = bitcast<f32>(((_e1460 | (bitcast<u32>(_e1481) << bitcast<u32>(23i))) | (_e1479 & 8388607u)));
                                            phi_2859_ = f32();
                                        } else {
                                            if (_e1481 < -24i) {
                                                phi_2824_ = 26u;
                                            } else {
                                                phi_2824_ = bitcast<u32>((1i - _e1481));
                                            }
                                            let _e1488 = phi_2824_;
                                            let _e1489 = (_e1488 & 31u);
                                            let _e1491 = (_e1479 >> bitcast<u32>(_e1489));
                                            let _e1495 = (_e1479 & ((1u << bitcast<u32>(_e1489)) - 1u));
                                            let _e1499 = (1u << bitcast<u32>(((_e1488 - 1u) & 31u)));
                                            if (_e1495 > _e1499) {
                                                phi_2845_ = true;
                                            } else {
                                                if (_e1495 == _e1499) {
                                                    phi_2842_ = ((_e1491 & 1u) == 1u);
                                                } else {
                                                    phi_2842_ = false;
                                                }
                                                let _e1505 = phi_2842_;
                                                phi_2845_ = _e1505;
                                            }
                                            let _e1507 = phi_2845_;
                                            phi_2858_ = f32();
                                            phi_2859_ = bitcast<f32>((_e1460 | (_e1491 + select(0u, 1u, _e1507))));
                                        }
                                        let _e1520 = phi_2858_;
                                        let _e1522 = phi_2859_;
                                        phi_2864_ = _e1520;
                                        phi_2865_ = _e1522;
                                        phi_2866_ = _e1483;
                                    }
                                    let _e1526 = phi_2864_;
                                    let _e1528 = phi_2865_;
                                    let _e1530 = phi_2866_;
                                    phi_2874_ = select(_e1528, _e1526, _e1530);
                                }
                                let _e1534 = phi_2874_;
                                phi_2691_ = _e1534;
                            } else {
                                phi_2691_ = _e1457;
                            }
                            let _e1536 = phi_2691_;
                            phi_2692_ = _e1536;
                        }
                        let _e1538 = phi_2692_;
                        let _e1539 = bitcast<u32>(_e1538);
                        if ((_e1539 & 2147483647u) >= 2139095040u) {
                            phi_2704_ = bitcast<f32>(((_e1539 & 2147483648u) | 2139095039u));
                        } else {
                            phi_2704_ = _e1538;
                        }
                        let _e1546 = phi_2704_;
                        phi_2709_ = type_22(_e1546, _e1429.member.member_1, _e1429.member.member_2, _e1429.member.member_3);
                    } else {
                        phi_2709_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1551 = phi_2709_;
                    if _e96 {
                    } else {
                        break;
                    }
                    global_4.member[_e88] = _e1551;
                    if _e89 {
                    } else {
                        break;
                    }
                    let _e1555 = select(0u, 1u, (_e163 <= _e173));
                    if (_e1555 > 0u) {
                        let _e1557 = (1u < _e84);
                        if _e1557 {
                            if (0u < _e84) {
                            } else {
                                break;
                            }
                            let _e1561 = atomicAdd((&global_5.member[0u]), _e1555);
                            if ((_e1561 + _e1555) < _e1561) {
                                if _e1557 {
                                } else {
                                    break;
                                }
                                let _e1566 = atomicAdd((&global_5.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1569 = select(0u, 1u, (_e1551.member_3 != 4294967295u));
                    if (_e1569 > 0u) {
                        let _e1571 = (3u < _e84);
                        if _e1571 {
                            if (2u < _e84) {
                            } else {
                                break;
                            }
                            let _e1575 = atomicAdd((&global_5.member[2u]), _e1569);
                            if ((_e1575 + _e1569) < _e1575) {
                                if _e1571 {
                                } else {
                                    break;
                                }
                                let _e1580 = atomicAdd((&global_5.member[3u]), 1u);
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
fn trace_paths(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
