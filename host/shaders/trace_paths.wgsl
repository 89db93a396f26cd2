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
    var phi_2881_: bool;
    var phi_988_: type_43;
    var phi_991_: bool;
    var phi_993_: u32;
    var phi_995_: u32;
    var phi_997_: u32;
    var phi_1008_: bool;
    var phi_1040_: bool;
    var phi_1041_: u32;
    var phi_1042_: u32;
    var phi_2199_: type_47;
    var phi_2561_: u32;
    var phi_2589_: u32;
    var phi_2590_: u32;
    var phi_2591_: u32;
    var phi_2593_: u32;
    var phi_2594_: u32;
    var phi_2595_: bool;
    var phi_2604_: u32;
    var phi_2609_: bool;
    var phi_2611_: u32;
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
    var phi_2875_: bool;
    var phi_3040_: bool;
    var phi_2615_: type_43;
    var phi_2616_: bool;
    var phi_2617_: u32;
    var phi_2618_: u32;
    var phi_3039_: bool;
    var phi_2619_: type_43;
    var phi_2620_: bool;
    var phi_2621_: u32;
    var phi_2622_: u32;
    var phi_2623_: u32;
    var phi_3038_: bool;
    var phi_2624_: type_43;
    var phi_2625_: bool;
    var phi_2626_: u32;
    var phi_2627_: u32;
    var phi_2628_: u32;
    var phi_3037_: bool;
    var phi_989_: type_43;
    var phi_992_: bool;
    var phi_994_: u32;
    var phi_996_: u32;
    var phi_998_: u32;
    var phi_2629_: bool;
    var phi_3036_: bool;
    var local_2: type_43;
    var phi_2667_: f32;
    var phi_2669_: f32;
    var phi_2670_: bool;
    var phi_2671_: f32;
    var phi_2672_: bool;
    var phi_2820_: u32;
    var phi_2838_: bool;
    var phi_2841_: bool;
    var phi_2854_: f32;
    var phi_2855_: f32;
    var phi_2860_: f32;
    var phi_2861_: f32;
    var phi_2862_: bool;
    var phi_2870_: f32;
    var phi_2687_: f32;
    var phi_2688_: f32;
    var phi_2700_: f32;
    var phi_2705_: type_22;
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
                    phi_2881_ = false;
                    phi_988_ = type_43(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e548);
                    phi_991_ = (_e550 <= _e548);
                    phi_993_ = ((3u * _e76) + 1u);
                    phi_995_ = 0u;
                    phi_997_ = select(0u, 2147483648u, (_e76 == 0u));
                    loop {
                        let _e558 = phi_2881_;
                        let _e560 = phi_988_;
                        let _e562 = phi_991_;
                        let _e564 = phi_993_;
                        let _e566 = phi_995_;
                        let _e568 = phi_997_;
                        local_2 = _e560;
                        if _e562 {
                            phi_1008_ = true;
                        } else {
                            phi_1008_ = (_e566 > 0u);
                        }
                        let _e571 = phi_1008_;
                        if _e571 {
                            let _e572 = (_e564 > 0u);
                            if _e572 {
                                if _e562 {
                                    phi_1040_ = _e562;
                                    phi_1041_ = _e566;
                                    phi_1042_ = _e568;
                                } else {
                                    let _e573 = (_e566 - 1u);
                                    let _e574 = (_e573 % 128u);
                                    let _e575 = (_e574 < 128u);
                                    if _e575 {
                                    } else {
                                        phi_3036_ = true;
                                        break;
                                    }
                                    let _e577 = local_1[_e574];
                                    if _e575 {
                                    } else {
                                        phi_3036_ = true;
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
                                    if ((_e587 & 2147483648u) != 0u) {
                                        phi_1057_ = _e560;
                                        phi_1060_ = type_7(0u, ((_e587 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e785 = phi_1057_;
                                            let _e787 = phi_1060_;
                                            local_3 = _e785;
                                            if (_e787.member < _e787.member_1) {
                                                phi_1061_ = type_7((_e787.member + 1u), _e787.member_1);
                                                phi_1083_ = type_7(1u, _e787.member);
                                            } else {
                                                phi_1061_ = _e787;
                                                phi_1083_ = type_7(0u, type_7().member_1);
                                            }
                                            let _e800 = phi_1061_;
                                            let _e802 = phi_1083_;
                                            let _e806 = (bitcast<i32>(_e802.member) != 0i);
                                            if _e806 {
                                                let _e807 = ((_e587 & 268435455u) + _e802.member_1);
                                                let _e808 = (_e807 < _e78);
                                                if _e808 {
                                                    if _e808 {
                                                    } else {
                                                        phi_2875_ = true;
                                                        break;
                                                    }
                                                    let _e812 = global_1.member[_e807].member_1;
                                                    phi_1104_ = _e812;
                                                } else {
                                                    phi_1104_ = 4294967295u;
                                                }
                                                let _e814 = phi_1104_;
                                                if (_e807 >= _e78) {
                                                    phi_1196_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e808 {
                                                    } else {
                                                        phi_2875_ = true;
                                                        break;
                                                    }
                                                    let _e816 = (_e217 % 3u);
                                                    let _e817 = (_e216 % 3u);
                                                    let _e818 = (_e218 % 3u);
                                                    if (_e816 < 9u) {
                                                    } else {
                                                        phi_2875_ = true;
                                                        break;
                                                    }
                                                    let _e824 = global_1.member[_e807].member[_e816];
                                                    if (_e817 < 9u) {
                                                    } else {
                                                        phi_2875_ = true;
                                                        break;
                                                    }
                                                    let _e830 = global_1.member[_e807].member[_e817];
                                                    if (_e818 < 9u) {
                                                    } else {
                                                        phi_2875_ = true;
                                                        break;
                                                    }
                                                    let _e836 = global_1.member[_e807].member[_e818];
                                                    let _e838 = (3u + _e816);
                                                    if (_e838 < 9u) {
                                                    } else {
                                                        phi_2875_ = true;
                                                        break;
                                                    }
                                                    let _e844 = global_1.member[_e807].member[_e838];
                                                    let _e845 = (3u + _e817);
                                                    if (_e845 < 9u) {
                                                    } else {
                                                        phi_2875_ = true;
                                                        break;
                                                    }
                                                    let _e851 = global_1.member[_e807].member[_e845];
                                                    let _e852 = (3u + _e818);
                                                    if (_e852 < 9u) {
                                                    } else {
                                                        phi_2875_ = true;
                                                        break;
                                                    }
                                                    let _e858 = global_1.member[_e807].member[_e852];
                                                    let _e860 = (6u + _e816);
                                                    if (_e860 < 9u) {
                                                    } else {
                                                        phi_2875_ = true;
                                                        break;
                                                    }
                                                    let _e866 = global_1.member[_e807].member[_e860];
                                                    let _e867 = (6u + _e817);
                                                    if (_e867 < 9u) {
                                                    } else {
                                                        phi_2875_ = true;
                                                        break;
                                                    }
                                                    let _e873 = global_1.member[_e807].member[_e867];
                                                    let _e874 = (6u + _e818);
                                                    if (_e874 < 9u) {
                                                    } else {
                                                        phi_2875_ = true;
                                                        break;
                                                    }
                                                    let _e880 = global_1.member[_e807].member[_e874];
                                                    phi_1196_ = array<array<f32, 3>, 3>(array<f32, 3>(_e824, _e830, _e836), array<f32, 3>(_e844, _e851, _e858), array<f32, 3>(_e866, _e873, _e880));
                                                }
                                                let _e884 = phi_1196_;
                                                let _e892 = (_e884[0][2] - _e397);
                                                let _e895 = (((_e884[0][0] - _e264) * _e436) - (_e892 * _e304));
                                                let _e898 = (((_e884[0][1] - _e331) * _e436) - (_e892 * _e370));
                                                let _e905 = (_e884[1][2] - _e397);
                                                let _e908 = (((_e884[1][0] - _e264) * _e436) - (_e905 * _e304));
                                                let _e911 = (((_e884[1][1] - _e331) * _e436) - (_e905 * _e370));
                                                let _e918 = (_e884[2][2] - _e397);
                                                let _e921 = (((_e884[2][0] - _e264) * _e436) - (_e918 * _e304));
                                                let _e924 = (((_e884[2][1] - _e331) * _e436) - (_e918 * _e370));
                                                let _e925 = (_e921 * _e911);
                                                let _e926 = (_e924 * _e908);
                                                let _e927 = (_e895 * _e924);
                                                let _e928 = (_e898 * _e921);
                                                let _e929 = (_e908 * _e898);
                                                let _e930 = (_e911 * _e895);
                                                let _e935 = (((_e925 >= _e926) && (_e927 >= _e928)) && (_e929 >= _e930));
                                                if (_e935 || (((_e925 <= _e926) && (_e927 <= _e928)) && (_e929 <= _e930))) {
                                                    let _e942 = select(-1f, 1f, _e935);
                                                    let _e944 = ((_e925 - _e926) * _e942);
                                                    let _e946 = select(0f, _e944, (_e944 > 0f));
                                                    let _e948 = ((_e927 - _e928) * _e942);
                                                    let _e950 = select(0f, _e948, (_e948 > 0f));
                                                    let _e952 = ((_e929 - _e930) * _e942);
                                                    let _e954 = select(0f, _e952, (_e952 > 0f));
                                                    let _e956 = ((_e946 + _e950) + _e954);
                                                    if (_e956 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2080_ = type_22();
                                                        phi_2081_ = true;
                                                        phi_2082_ = false;
                                                    } else {
                                                        let _e959 = select(_e908, _e895, (_e895 < _e908));
                                                        if (select(_e921, _e959, (_e959 < _e921)) > 0f) {
                                                            phi_1348_ = true;
                                                        } else {
                                                            let _e964 = select(_e908, _e895, (_e895 > _e908));
                                                            phi_1348_ = (select(_e921, _e964, (_e964 > _e921)) < 0f);
                                                        }
                                                        let _e969 = phi_1348_;
                                                        if _e969 {
                                                            phi_2077_ = type_22();
                                                            phi_2078_ = true;
                                                            phi_2079_ = false;
                                                        } else {
                                                            let _e971 = select(_e911, _e898, (_e898 < _e911));
                                                            if (select(_e924, _e971, (_e971 < _e924)) > 0f) {
                                                                phi_1377_ = true;
                                                            } else {
                                                                let _e976 = select(_e911, _e898, (_e898 > _e911));
                                                                phi_1377_ = (select(_e924, _e976, (_e976 > _e924)) < 0f);
                                                            }
                                                            let _e981 = phi_1377_;
                                                            if _e981 {
                                                                phi_2075_ = type_22();
                                                                phi_2076_ = false;
                                                            } else {
                                                                let _e983 = select(_e884[1][0], _e884[0][0], (_e884[0][0] < _e884[1][0]));
                                                                let _e987 = select(_e884[1][0], _e884[0][0], (_e884[0][0] > _e884[1][0]));
                                                                let _e991 = select(_e884[1][1], _e884[0][1], (_e884[0][1] < _e884[1][1]));
                                                                let _e995 = select(_e884[1][1], _e884[0][1], (_e884[0][1] > _e884[1][1]));
                                                                let _e999 = select(_e884[1][2], _e884[0][2], (_e884[0][2] < _e884[1][2]));
                                                                let _e1003 = select(_e884[1][2], _e884[0][2], (_e884[0][2] > _e884[1][2]));
                                                                let _e1008 = ((select(_e884[2][0], _e983, (_e983 < _e884[2][0])) - _e302) * _e307);
                                                                let _e1009 = ((select(_e884[2][0], _e987, (_e987 > _e884[2][0])) - _e303) * _e307);
                                                                let _e1012 = ((select(_e884[2][1], _e991, (_e991 < _e884[2][1])) - _e368) * _e373);
                                                                let _e1013 = ((select(_e884[2][1], _e995, (_e995 > _e884[2][1])) - _e369) * _e373);
                                                                let _e1016 = ((select(_e884[2][2], _e999, (_e999 < _e884[2][2])) - _e434) * _e439);
                                                                let _e1017 = ((select(_e884[2][2], _e1003, (_e1003 > _e884[2][2])) - _e435) * _e439);
                                                                let _e1019 = select(_e1017, _e1016, (_e1016 < _e1017));
                                                                let _e1021 = select(_e1017, _e1016, (_e1016 > _e1017));
                                                                let _e1023 = select(_e1009, _e1008, (_e1008 < _e1009));
                                                                let _e1025 = select(_e1013, _e1012, (_e1012 < _e1013));
                                                                let _e1027 = select(_e1025, _e1023, (_e1023 > _e1025));
                                                                let _e1029 = select(_e1019, _e1027, (_e1027 > _e1019));
                                                                let _e1031 = select(_e1009, _e1008, (_e1008 > _e1009));
                                                                let _e1033 = select(_e1013, _e1012, (_e1012 > _e1013));
                                                                let _e1035 = select(_e1033, _e1031, (_e1031 < _e1033));
                                                                let _e1037 = select(_e1021, _e1035, (_e1035 < _e1021));
                                                                let _e1038 = -(_e1019);
                                                                let _e1044 = select(_e550, _e1029, (_e1029 > _e550));
                                                                if (_e1044 > (_e1037 + (select(_e1038, _e1021, (_e1021 > _e1038)) * 0.0000019073523f))) {
                                                                    phi_2070_ = type_22();
                                                                    phi_2071_ = true;
                                                                } else {
                                                                    let _e1046 = (_e1044 > _e785.member_1);
                                                                    if _e1046 {
                                                                        phi_2069_ = type_22();
                                                                    } else {
                                                                        let _e1047 = vec3<f32>(_e884[0][0], _e884[0][1], _e884[0][2]);
                                                                        let _e1048 = vec3<f32>(_e884[1][0], _e884[1][1], _e884[1][2]);
                                                                        let _e1049 = vec3<f32>(_e884[2][0], _e884[2][1], _e884[2][2]);
                                                                        let _e1050 = (_e884[1][0] - _e884[0][0]);
                                                                        let _e1051 = (_e884[1][1] - _e884[0][1]);
                                                                        let _e1052 = (_e884[1][2] - _e884[0][2]);
                                                                        let _e1053 = vec3<f32>(_e1050, _e1051, _e1052);
                                                                        let _e1054 = (_e884[2][0] - _e884[1][0]);
                                                                        let _e1055 = (_e884[2][1] - _e884[1][1]);
                                                                        let _e1056 = (_e884[2][2] - _e884[1][2]);
                                                                        let _e1057 = vec3<f32>(_e1054, _e1055, _e1056);
                                                                        let _e1058 = (_e884[0][0] - _e884[2][0]);
                                                                        let _e1059 = (_e884[0][1] - _e884[2][1]);
                                                                        let _e1060 = (_e884[0][2] - _e884[2][2]);
                                                                        let _e1061 = vec3<f32>(_e1058, _e1059, _e1060);
                                                                        let _e1064 = bitcast<f32>((bitcast<u32>(_e1050) & 2147483647u));
                                                                        let _e1067 = bitcast<f32>((bitcast<u32>(_e1051) & 2147483647u));
                                                                        let _e1069 = select(_e1067, _e1064, (_e1064 > _e1067));
                                                                        let _e1072 = bitcast<f32>((bitcast<u32>(_e1052) & 2147483647u));
                                                                        let _e1074 = select(_e1072, _e1069, (_e1069 > _e1072));
                                                                        let _e1077 = bitcast<f32>((bitcast<u32>(_e1054) & 2147483647u));
                                                                        let _e1080 = bitcast<f32>((bitcast<u32>(_e1055) & 2147483647u));
                                                                        let _e1082 = select(_e1080, _e1077, (_e1077 > _e1080));
                                                                        let _e1085 = bitcast<f32>((bitcast<u32>(_e1056) & 2147483647u));
                                                                        let _e1087 = select(_e1085, _e1082, (_e1082 > _e1085));
                                                                        let _e1090 = bitcast<f32>((bitcast<u32>(_e1058) & 2147483647u));
                                                                        let _e1093 = bitcast<f32>((bitcast<u32>(_e1059) & 2147483647u));
                                                                        let _e1095 = select(_e1093, _e1090, (_e1090 > _e1093));
                                                                        let _e1098 = bitcast<f32>((bitcast<u32>(_e1060) & 2147483647u));
                                                                        let _e1100 = select(_e1098, _e1095, (_e1095 > _e1098));
                                                                        let _e1102 = select(_e1087, _e1074, (_e1074 > _e1087));
                                                                        let _e1104 = select(_e1100, _e1102, (_e1102 > _e1100));
                                                                        if (_e1074 == _e1104) {
                                                                            phi_1796_ = _e911;
                                                                            phi_1797_ = _e908;
                                                                            phi_1798_ = _e898;
                                                                            phi_1799_ = _e895;
                                                                            phi_1800_ = _e1047;
                                                                            phi_1801_ = _e1061;
                                                                            phi_1802_ = _e1057;
                                                                            phi_1803_ = _e1053;
                                                                        } else {
                                                                            let _e1106 = (_e1087 == _e1104);
                                                                            let _e1111 = vec3(_e1106);
                                                                            phi_1796_ = select(_e898, _e924, _e1106);
                                                                            phi_1797_ = select(_e895, _e921, _e1106);
                                                                            phi_1798_ = select(_e924, _e911, _e1106);
                                                                            phi_1799_ = select(_e921, _e908, _e1106);
                                                                            phi_1800_ = select(_e1049, _e1048, _e1111);
                                                                            phi_1801_ = select(_e1057, _e1053, _e1111);
                                                                            phi_1802_ = select(_e1053, _e1061, _e1111);
                                                                            phi_1803_ = select(_e1061, _e1057, _e1111);
                                                                        }
                                                                        let _e1117 = phi_1796_;
                                                                        let _e1119 = phi_1797_;
                                                                        let _e1121 = phi_1798_;
                                                                        let _e1123 = phi_1799_;
                                                                        let _e1125 = phi_1800_;
                                                                        let _e1127 = phi_1801_;
                                                                        let _e1129 = phi_1802_;
                                                                        let _e1131 = phi_1803_;
                                                                        let _e1138 = ((_e1129.y * _e1127.z) - (_e1127.y * _e1129.z));
                                                                        let _e1143 = ((_e1129.z * _e1127.x) - (_e1127.z * _e1129.x));
                                                                        let _e1146 = ((_e1129.x * _e1127.y) - (_e1127.x * _e1129.y));
                                                                        if (_e946 >= _e950) {
                                                                            phi_1840_ = select(true, false, (_e946 >= _e954));
                                                                        } else {
                                                                            phi_1840_ = true;
                                                                        }
                                                                        let _e1151 = phi_1840_;
                                                                        if _e1151 {
                                                                            phi_1849_ = select(_e1049, _e1048, vec3((_e950 >= _e954)));
                                                                        } else {
                                                                            phi_1849_ = _e1047;
                                                                        }
                                                                        let _e1156 = phi_1849_;
                                                                        let _e1167 = (((_e1138 * (_e1156.x - _e264)) + (_e1143 * (_e1156.y - _e331))) + (_e1146 * (_e1156.z - _e397)));
                                                                        let _e1172 = (((_e1138 * _e304) + (_e1143 * _e370)) + (_e1146 * _e436));
                                                                        let _e1173 = (_e1119 - _e1123);
                                                                        let _e1174 = (_e1117 - _e1121);
                                                                        let _e1182 = (-(((_e1123 * _e1173) + (_e1121 * _e1174))) / ((_e1173 * _e1173) + (_e1174 * _e1174)));
                                                                        let _e1184 = select(1f, _e1182, (_e1182 < 1f));
                                                                        let _e1186 = select(0f, _e1184, (_e1184 > 0f));
                                                                        let _e1199 = ((_e1125.x + (_e1131.x * _e1186)) - _e264);
                                                                        let _e1200 = ((_e1125.y + (_e1131.y * _e1186)) - _e331);
                                                                        let _e1201 = ((_e1125.z + (_e1131.z * _e1186)) - _e397);
                                                                        let _e1202 = (_e1201 / _e436);
                                                                        let _e1214 = bitcast<f32>((bitcast<u32>(_e1199) & 2147483647u));
                                                                        let _e1217 = bitcast<f32>((bitcast<u32>(_e1200) & 2147483647u));
                                                                        let _e1219 = select(_e1217, _e1214, (_e1214 > _e1217));
                                                                        let _e1222 = bitcast<f32>((bitcast<u32>(_e1201) & 2147483647u));
                                                                        let _e1224 = select(_e1222, _e1219, (_e1219 > _e1222));
                                                                        let _e1230 = bitcast<f32>((bitcast<u32>(_e1138) & 2147483647u));
                                                                        let _e1233 = bitcast<f32>((bitcast<u32>(_e1143) & 2147483647u));
                                                                        let _e1235 = select(_e1233, _e1230, (_e1230 > _e1233));
                                                                        let _e1238 = bitcast<f32>((bitcast<u32>(_e1146) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1138 * _e1199) + (_e1143 * _e1200)) + (_e1146 * _e1201)) - _e1167)) & 2147483647u)) <= ((0.0000009536743f * select(_e1104, _e1224, (_e1224 > _e1104))) * select(_e1238, _e1235, (_e1235 > _e1238)))) {
                                                                            let _e1248 = bitcast<f32>((bitcast<u32>(_e1129.x) & 2147483647u));
                                                                            let _e1251 = bitcast<f32>((bitcast<u32>(_e1129.y) & 2147483647u));
                                                                            let _e1253 = select(_e1251, _e1248, (_e1248 > _e1251));
                                                                            let _e1256 = bitcast<f32>((bitcast<u32>(_e1129.z) & 2147483647u));
                                                                            let _e1262 = bitcast<f32>((bitcast<u32>(_e1127.x) & 2147483647u));
                                                                            let _e1265 = bitcast<f32>((bitcast<u32>(_e1127.y) & 2147483647u));
                                                                            let _e1267 = select(_e1265, _e1262, (_e1262 > _e1265));
                                                                            let _e1270 = bitcast<f32>((bitcast<u32>(_e1127.z) & 2147483647u));
                                                                            let _e1274 = (bitcast<f32>((bitcast<u32>(_e1172) & 2147483647u)) > ((0.0000038146973f * select(_e1256, _e1253, (_e1253 > _e1256))) * select(_e1270, _e1267, (_e1267 > _e1270))));
                                                                            if _e1274 {
                                                                                phi_2014_ = (_e1167 / _e1172);
                                                                            } else {
                                                                                phi_2014_ = f32();
                                                                            }
                                                                            let _e1277 = phi_2014_;
                                                                            phi_2016_ = _e1277;
                                                                            phi_2017_ = select(true, false, _e1274);
                                                                        } else {
                                                                            phi_2016_ = f32();
                                                                            phi_2017_ = true;
                                                                        }
                                                                        let _e1280 = phi_2016_;
                                                                        let _e1282 = phi_2017_;
                                                                        if _e1282 {
                                                                            let _e1290 = (((_e1138 * (_e1199 - (_e304 * _e1202))) + (_e1143 * (_e1200 - (_e370 * _e1202)))) / _e1172);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1290) & 2147483647u)) <= _e1104) {
                                                                                phi_2037_ = (_e1202 + _e1290);
                                                                            } else {
                                                                                phi_2037_ = _e1202;
                                                                            }
                                                                            let _e1297 = phi_2037_;
                                                                            phi_2038_ = _e1297;
                                                                        } else {
                                                                            phi_2038_ = _e1280;
                                                                        }
                                                                        let _e1299 = phi_2038_;
                                                                        let _e1301 = select(_e1037, _e1299, (_e1299 < _e1037));
                                                                        let _e1303 = select(_e1029, _e1301, (_e1301 > _e1029));
                                                                        if (_e1303 >= _e550) {
                                                                            let _e1305 = (_e1303 <= _e785.member_1);
                                                                            if _e1305 {
                                                                                let _e1306 = (1f / _e956);
                                                                                phi_2061_ = type_22(_e1303, (_e950 * _e1306), (_e954 * _e1306), _e814);
                                                                            } else {
                                                                                phi_2061_ = type_22();
                                                                            }
                                                                            let _e1311 = phi_2061_;
                                                                            phi_2063_ = _e1311;
                                                                            phi_2064_ = select(true, false, _e1305);
                                                                        } else {
                                                                            phi_2063_ = type_22();
                                                                            phi_2064_ = true;
                                                                        }
                                                                        let _e1314 = phi_2063_;
                                                                        let _e1316 = phi_2064_;
                                                                        if _e1316 {
                                                                            phi_2068_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2068_ = _e1314;
                                                                        }
                                                                        let _e1318 = phi_2068_;
                                                                        phi_2069_ = _e1318;
                                                                    }
                                                                    let _e1320 = phi_2069_;
                                                                    phi_2070_ = _e1320;
                                                                    phi_2071_ = _e1046;
                                                                }
                                                                let _e1322 = phi_2070_;
                                                                let _e1324 = phi_2071_;
                                                                phi_2075_ = _e1322;
                                                                phi_2076_ = _e1324;
                                                            }
                                                            let _e1326 = phi_2075_;
                                                            let _e1328 = phi_2076_;
                                                            phi_2077_ = _e1326;
                                                            phi_2078_ = _e981;
                                                            phi_2079_ = _e1328;
                                                        }
                                                        let _e1330 = phi_2077_;
                                                        let _e1332 = phi_2078_;
                                                        let _e1334 = phi_2079_;
                                                        phi_2080_ = _e1330;
                                                        phi_2081_ = _e1332;
                                                        phi_2082_ = _e1334;
                                                    }
                                                    let _e1336 = phi_2080_;
                                                    let _e1338 = phi_2081_;
                                                    let _e1340 = phi_2082_;
                                                    phi_2090_ = _e1336;
                                                    phi_2091_ = select(_e1340, true, _e1338);
                                                } else {
                                                    phi_2090_ = type_22();
                                                    phi_2091_ = true;
                                                }
                                                let _e1343 = phi_2090_;
                                                let _e1345 = phi_2091_;
                                                if _e1345 {
                                                    phi_2095_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2095_ = _e1343;
                                                }
                                                let _e1347 = phi_2095_;
                                                if (_e1347.member_3 != 4294967295u) {
                                                    if (_e814 != _e95) {
                                                        if (_e1347.member < _e785.member.member) {
                                                            phi_2121_ = true;
                                                        } else {
                                                            if (_e1347.member == _e785.member.member) {
                                                                phi_2120_ = (_e1347.member_3 < _e785.member.member_3);
                                                            } else {
                                                                phi_2120_ = false;
                                                            }
                                                            let _e1360 = phi_2120_;
                                                            phi_2121_ = _e1360;
                                                        }
                                                        let _e1362 = phi_2121_;
                                                        if _e1362 {
                                                            phi_2127_ = type_43(_e1347, _e1347.member);
                                                        } else {
                                                            phi_2127_ = _e785;
                                                        }
                                                        let _e1365 = phi_2127_;
                                                        phi_2128_ = _e1365;
                                                    } else {
                                                        phi_2128_ = _e785;
                                                    }
                                                    let _e1367 = phi_2128_;
                                                    phi_2129_ = _e1367;
                                                } else {
                                                    phi_2129_ = _e785;
                                                }
                                                let _e1369 = phi_2129_;
                                                phi_1058_ = _e1369;
                                            } else {
                                                phi_1058_ = type_43();
                                            }
                                            let _e1371 = phi_1058_;
                                            continue;
                                            continuing {
                                                phi_1057_ = _e1371;
                                                phi_1060_ = _e800;
                                                phi_2875_ = _e558;
                                                break if !(_e806);
                                            }
                                        }
                                        let _e1374 = phi_2875_;
                                        phi_3036_ = _e1374;
                                        if _e1374 {
                                            break;
                                        }
                                        phi_3040_ = _e1374;
                                        let _e1686 = local_3;
                                        phi_2615_ = _e1686;
                                        phi_2616_ = false;
                                        phi_2617_ = _e585;
                                        phi_2618_ = _e587;
                                    } else {
                                        if (_e587 >= _e76) {
                                            phi_2199_ = type_47(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                        } else {
                                            if (_e587 < _e76) {
                                            } else {
                                                phi_3036_ = true;
                                                break;
                                            }
                                            let _e597 = (_e217 % 3u);
                                            if (_e597 < 3u) {
                                            } else {
                                                phi_3036_ = true;
                                                break;
                                            }
                                            let _e603 = global_2.member[_e587].member[_e597];
                                            let _e609 = (_e216 % 3u);
                                            if (_e609 < 3u) {
                                            } else {
                                                phi_3036_ = true;
                                                break;
                                            }
                                            let _e615 = global_2.member[_e587].member[_e609];
                                            let _e621 = (_e218 % 3u);
                                            if (_e621 < 3u) {
                                            } else {
                                                phi_3036_ = true;
                                                break;
                                            }
                                            let _e627 = global_2.member[_e587].member[_e621];
                                            let _e637 = global_2.member[_e587].member_1;
                                            let _e641 = global_2.member[_e587].member_2;
                                            phi_2199_ = type_47(array<vec4<f32>, 3>(vec4<f32>(_e603[0], _e603[1], _e603[2], _e603[3]), vec4<f32>(_e615[0], _e615[1], _e615[2], _e615[3]), vec4<f32>(_e627[0], _e627[1], _e627[2], _e627[3])), _e637, _e641);
                                        }
                                        let _e644 = phi_2199_;
                                        let _e656 = ((_e644.member[0].x - _e302) * _e307);
                                        let _e657 = ((_e644.member[0].y - _e302) * _e307);
                                        let _e658 = ((_e644.member[0].z - _e303) * _e307);
                                        let _e659 = ((_e644.member[0].w - _e303) * _e307);
                                        let _e669 = ((_e644.member[1].x - _e368) * _e373);
                                        let _e670 = ((_e644.member[1].y - _e368) * _e373);
                                        let _e671 = ((_e644.member[1].z - _e369) * _e373);
                                        let _e672 = ((_e644.member[1].w - _e369) * _e373);
                                        let _e682 = ((_e644.member[2].x - _e434) * _e439);
                                        let _e683 = ((_e644.member[2].y - _e434) * _e439);
                                        let _e684 = ((_e644.member[2].z - _e435) * _e439);
                                        let _e685 = ((_e644.member[2].w - _e435) * _e439);
                                        let _e687 = select(_e684, _e682, (_e682 < _e684));
                                        let _e689 = select(_e685, _e683, (_e683 < _e685));
                                        let _e691 = select(_e684, _e682, (_e682 > _e684));
                                        let _e693 = select(_e685, _e683, (_e683 > _e685));
                                        let _e695 = select(_e658, _e656, (_e656 < _e658));
                                        let _e697 = select(_e659, _e657, (_e657 < _e659));
                                        let _e699 = select(_e671, _e669, (_e669 < _e671));
                                        let _e701 = select(_e672, _e670, (_e670 < _e672));
                                        let _e703 = select(_e699, _e695, (_e695 > _e699));
                                        let _e705 = select(_e701, _e697, (_e697 > _e701));
                                        let _e707 = select(_e687, _e703, (_e703 > _e687));
                                        let _e709 = select(_e689, _e705, (_e705 > _e689));
                                        let _e711 = select(_e658, _e656, (_e656 > _e658));
                                        let _e713 = select(_e659, _e657, (_e657 > _e659));
                                        let _e715 = select(_e671, _e669, (_e669 > _e671));
                                        let _e717 = select(_e672, _e670, (_e670 > _e672));
                                        let _e719 = select(_e715, _e711, (_e711 < _e715));
                                        let _e721 = select(_e717, _e713, (_e713 < _e717));
                                        let _e726 = -(_e687);
                                        let _e727 = -(_e689);
                                        let _e734 = (select(_e691, _e719, (_e719 < _e691)) + (select(_e726, _e691, (_e691 > _e726)) * 0.0000019073523f));
                                        let _e735 = (select(_e693, _e721, (_e721 < _e693)) + (select(_e727, _e693, (_e693 > _e727)) * 0.0000019073523f));
                                        let _e737 = select(_e550, _e707, (_e707 > _e550));
                                        let _e739 = select(_e550, _e709, (_e709 > _e550));
                                        let _e744 = (_e737 <= select(_e560.member_1, _e734, (_e734 < _e560.member_1)));
                                        let _e745 = (_e739 <= select(_e560.member_1, _e735, (_e735 < _e560.member_1)));
                                        let _e746 = (_e737 <= _e739);
                                        if _e744 {
                                            if _e745 {
                                                if _e746 {
                                                    phi_2561_ = _e644.member_2;
                                                } else {
                                                    phi_2561_ = _e644.member_1;
                                                }
                                                let _e750 = phi_2561_;
                                                let _e753 = (_e585 % 128u);
                                                let _e754 = (_e753 < 128u);
                                                if _e754 {
                                                } else {
                                                    phi_3036_ = true;
                                                    break;
                                                }
                                                local_1[_e753] = _e750;
                                                if _e754 {
                                                } else {
                                                    phi_3036_ = true;
                                                    break;
                                                }
                                                local[_e753] = select(_e739, _e737, !(_e746));
                                                if _e746 {
                                                    phi_2589_ = _e644.member_1;
                                                } else {
                                                    phi_2589_ = _e644.member_2;
                                                }
                                                let _e761 = phi_2589_;
                                                phi_2590_ = (_e585 + 1u);
                                                phi_2591_ = _e761;
                                            } else {
                                                phi_2590_ = u32();
                                                phi_2591_ = u32();
                                            }
                                            let _e763 = phi_2590_;
                                            let _e765 = phi_2591_;
                                            phi_2593_ = _e763;
                                            phi_2594_ = _e765;
                                            phi_2595_ = select(true, false, _e745);
                                        } else {
                                            phi_2593_ = u32();
                                            phi_2594_ = u32();
                                            phi_2595_ = true;
                                        }
                                        let _e768 = phi_2593_;
                                        let _e770 = phi_2594_;
                                        let _e772 = phi_2595_;
                                        if _e772 {
                                            if _e744 {
                                                phi_2604_ = _e644.member_1;
                                            } else {
                                                phi_2604_ = _e644.member_2;
                                            }
                                            let _e776 = phi_2604_;
                                            phi_2609_ = select(_e745, true, _e744);
                                            phi_2611_ = _e776;
                                        } else {
                                            phi_2609_ = _e583;
                                            phi_2611_ = _e770;
                                        }
                                        let _e779 = phi_2609_;
                                        let _e781 = phi_2611_;
                                        phi_3040_ = _e558;
                                        phi_2615_ = _e560;
                                        phi_2616_ = _e779;
                                        phi_2617_ = select(_e768, _e585, _e772);
                                        phi_2618_ = _e781;
                                    }
                                    let _e1376 = phi_3040_;
                                    let _e1378 = phi_2615_;
                                    let _e1380 = phi_2616_;
                                    let _e1382 = phi_2617_;
                                    let _e1384 = phi_2618_;
                                    phi_3039_ = _e1376;
                                    phi_2619_ = _e1378;
                                    phi_2620_ = _e1380;
                                    phi_2621_ = (_e564 - 1u);
                                    phi_2622_ = _e1382;
                                    phi_2623_ = _e1384;
                                } else {
                                    phi_3039_ = _e558;
                                    phi_2619_ = _e560;
                                    phi_2620_ = _e583;
                                    phi_2621_ = _e564;
                                    phi_2622_ = _e585;
                                    phi_2623_ = _e587;
                                }
                                let _e1386 = phi_3039_;
                                let _e1388 = phi_2619_;
                                let _e1390 = phi_2620_;
                                let _e1392 = phi_2621_;
                                let _e1394 = phi_2622_;
                                let _e1396 = phi_2623_;
                                phi_3038_ = _e1386;
                                phi_2624_ = _e1388;
                                phi_2625_ = _e1390;
                                phi_2626_ = _e1392;
                                phi_2627_ = _e1394;
                                phi_2628_ = _e1396;
                            } else {
                                phi_3038_ = _e558;
                                phi_2624_ = type_43();
                                phi_2625_ = bool();
                                phi_2626_ = u32();
                                phi_2627_ = u32();
                                phi_2628_ = u32();
                            }
                            let _e1398 = phi_3038_;
                            let _e1400 = phi_2624_;
                            let _e1402 = phi_2625_;
                            let _e1404 = phi_2626_;
                            let _e1406 = phi_2627_;
                            let _e1408 = phi_2628_;
                            phi_3037_ = _e1398;
                            phi_989_ = _e1400;
                            phi_992_ = _e1402;
                            phi_994_ = _e1404;
                            phi_996_ = _e1406;
                            phi_998_ = _e1408;
                            phi_2629_ = _e572;
                        } else {
                            phi_3037_ = _e558;
                            phi_989_ = type_43();
                            phi_992_ = bool();
                            phi_994_ = u32();
                            phi_996_ = u32();
                            phi_998_ = u32();
                            phi_2629_ = false;
                        }
                        let _e1410 = phi_3037_;
                        let _e1412 = phi_989_;
                        let _e1414 = phi_992_;
                        let _e1416 = phi_994_;
                        let _e1418 = phi_996_;
                        let _e1420 = phi_998_;
                        let _e1422 = phi_2629_;
                        continue;
                        continuing {
                            phi_2881_ = _e1410;
                            phi_988_ = _e1412;
                            phi_991_ = _e1414;
                            phi_993_ = _e1416;
                            phi_995_ = _e1418;
                            phi_997_ = _e1420;
                            phi_3036_ = _e1410;
                            break if !(_e1422);
                        }
                    }
                    let _e1425 = phi_3036_;
                    if _e1425 {
                        break;
                    }
                    let _e1427 = local_2;
                    if (_e1427.member.member_3 != 4294967295u) {
                        let _e1432 = bitcast<u32>(_e1427.member.member);
                        let _e1436 = (bitcast<i32>((_e1432 >> bitcast<u32>(23i))) & 255i);
                        let _e1437 = (_e1436 + _e219);
                        if (_e1436 == 255i) {
                            phi_2688_ = _e1427.member.member;
                        } else {
                            if (_e1436 > 0i) {
                                if (_e1437 > 0i) {
                                    let _e1441 = (_e1437 < 255i);
                                    if _e1441 {
                                        phi_2667_ = bitcast<f32>((_e1432 + bitcast<u32>((_e219 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_2667_ = f32();
                                    }
                                    let _e1448 = phi_2667_;
                                    phi_2669_ = _e1448;
                                    phi_2670_ = select(true, false, _e1441);
                                } else {
                                    phi_2669_ = f32();
                                    phi_2670_ = true;
                                }
                                let _e1451 = phi_2669_;
                                let _e1453 = phi_2670_;
                                phi_2671_ = _e1451;
                                phi_2672_ = _e1453;
                            } else {
                                phi_2671_ = f32();
                                phi_2672_ = true;
                            }
                            let _e1455 = phi_2671_;
                            let _e1457 = phi_2672_;
                            if _e1457 {
                                let _e1458 = (_e1432 & 2147483648u);
                                let _e1465 = ((_e1432 & 8388607u) | (select(0u, 1u, ((_e1432 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e1469 = (_e1465 == 0u);
                                if _e1469 {
                                    phi_2870_ = bitcast<f32>(_e1458);
                                } else {
                                    let _e1474 = (select((bitcast<u32>(31i) - firstLeadingBit(_e1465)), 32u, _e1469) - 8u);
                                    let _e1477 = (_e1465 << bitcast<u32>((_e1474 & 31u)));
                                    let _e1479 = ((_e1437 + select(0i, 1i, (_e1436 == 0i))) - bitcast<i32>(_e1474));
                                    if (_e1479 >= 255i) {
                                        phi_2860_ = bitcast<f32>((_e1458 | 2139095040u));
                                        phi_2861_ = f32();
                                        phi_2862_ = true;
                                    } else {
                                        let _e1481 = (_e1479 > 0i);
                                        if _e1481 {
                                            phi_2854_ = bitcast<f32>(((_e1458 | (bitcast<u32>(_e1479) << bitcast<u32>(23i))) | (_e1477 & 8388607u)));
                                            phi_2855_ = f32();
                                        } else {
                                            if (_e1479 < -24i) {
                                                phi_2820_ = 26u;
                                            } else {
                                                phi_2820_ = bitcast<u32>((1i - _e1479));
                                            }
                                            let _e1486 = phi_2820_;
                                            let _e1487 = (_e1486 & 31u);
                                            let _e1489 = (_e1477 >> bitcast<u32>(_e1487));
                                            let _e1493 = (_e1477 & ((1u << bitcast<u32>(_e1487)) - 1u));
                                            let _e1497 = (1u << bitcast<u32>(((_e1486 - 1u) & 31u)));
                                            if (_e1493 > _e1497) {
                                                phi_2841_ = true;
                                            } else {
                                                if (_e1493 == _e1497) {
                                                    phi_2838_ = ((_e1489 & 1u) == 1u);
                                                } else {
                                                    phi_2838_ = false;
                                                }
                                                let _e1503 = phi_2838_;
                                                phi_2841_ = _e1503;
                                            }
                                            let _e1505 = phi_2841_;
                                            phi_2854_ = f32();
                                            phi_2855_ = bitcast<f32>((_e1458 | (_e1489 + select(0u, 1u, _e1505))));
                                        }
                                        let _e1518 = phi_2854_;
                                        let _e1520 = phi_2855_;
                                        phi_2860_ = _e1518;
                                        phi_2861_ = _e1520;
                                        phi_2862_ = _e1481;
                                    }
                                    let _e1524 = phi_2860_;
                                    let _e1526 = phi_2861_;
                                    let _e1528 = phi_2862_;
                                    phi_2870_ = select(_e1526, _e1524, _e1528);
                                }
                                let _e1532 = phi_2870_;
                                phi_2687_ = _e1532;
                            } else {
                                phi_2687_ = _e1455;
                            }
                            let _e1534 = phi_2687_;
                            phi_2688_ = _e1534;
                        }
                        let _e1536 = phi_2688_;
                        let _e1537 = bitcast<u32>(_e1536);
                        if ((_e1537 & 2147483647u) >= 2139095040u) {
                            phi_2700_ = bitcast<f32>(((_e1537 & 2147483648u) | 2139095039u));
                        } else {
                            phi_2700_ = _e1536;
                        }
                        let _e1544 = phi_2700_;
                        phi_2705_ = type_22(_e1544, _e1427.member.member_1, _e1427.member.member_2, _e1427.member.member_3);
                    } else {
                        phi_2705_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1549 = phi_2705_;
                    if _e96 {
                    } else {
                        break;
                    }
                    global_4.member[_e88] = _e1549;
                    if _e89 {
                    } else {
                        break;
                    }
                    let _e1553 = select(0u, 1u, (_e163 <= _e173));
                    if (_e1553 > 0u) {
                        let _e1555 = (1u < _e84);
                        if _e1555 {
                            if (0u < _e84) {
                            } else {
                                break;
                            }
                            let _e1559 = atomicAdd((&global_5.member[0u]), _e1553);
                            if ((_e1559 + _e1553) < _e1559) {
                                if _e1555 {
                                } else {
                                    break;
                                }
                                let _e1564 = atomicAdd((&global_5.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1567 = select(0u, 1u, (_e1549.member_3 != 4294967295u));
                    if (_e1567 > 0u) {
                        let _e1569 = (3u < _e84);
                        if _e1569 {
                            if (2u < _e84) {
                            } else {
                                break;
                            }
                            let _e1573 = atomicAdd((&global_5.member[2u]), _e1567);
                            if ((_e1573 + _e1567) < _e1573) {
                                if _e1569 {
                                } else {
                                    break;
                                }
                                let _e1578 = atomicAdd((&global_5.member[3u]), 1u);
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
