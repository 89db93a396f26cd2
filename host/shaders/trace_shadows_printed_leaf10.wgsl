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

struct type_24 {
    member: type_23,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_26 {
    member: array<type_24>,
}

struct type_30 {
    member: type_23,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_32 {
    member: array<type_30>,
}

struct type_36 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_40 {
    member: f32,
    member_1: bool,
}

struct type_42 {
    member: array<vec4<u32>, 2>,
}

struct type_45 {
    member: array<i32>,
}

struct type_49 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_51 {
    member: array<type_49>,
}

struct type_54 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_56 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_58 {
    member: array<type_56>,
}

struct type_62 {
    member: type_54,
    member_1: u32,
}

struct type_67 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(8) 
var<storage, read_write> global_2: type_26;
@group(0) @binding(1) 
var<uniform> global_3: type_42;
@group(0) @binding(2) 
var<uniform> global_4: type_42;
@group(0) @binding(5) 
var<storage> global_5: type_4;
@group(0) @binding(6) 
var<storage> global_6: type_45;
@group(0) @binding(9) 
var<storage, read_write> global_7: type_67;
@group(0) @binding(7) 
var<storage> global_8: type_32;
@group(0) @binding(3) 
var<storage> global_9: type_51;
@group(0) @binding(4) 
var<storage> global_10: type_58;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<f32, 128>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<u32, 128>;
    var local_7: array<f32, 128>;
    var local_8: array<f32, 3>;
    var local_9: array<f32, 3>;
    var phi_271_: u32;
    var phi_315_: i32;
    var phi_339_: type_36;
    var phi_489_: i32;
    var phi_490_: i32;
    var phi_500_: bool;
    var phi_510_: u32;
    var phi_511_: u32;
    var phi_513_: bool;
    var phi_518_: u32;
    var phi_550_: i32;
    var phi_568_: f32;
    var phi_574_: f32;
    var phi_585_: f32;
    var phi_591_: f32;
    var phi_614_: f32;
    var phi_625_: f32;
    var phi_634_: f32;
    var phi_640_: f32;
    var phi_651_: f32;
    var phi_657_: f32;
    var phi_680_: f32;
    var phi_691_: f32;
    var phi_700_: f32;
    var phi_706_: f32;
    var phi_717_: f32;
    var phi_723_: f32;
    var phi_746_: f32;
    var phi_757_: f32;
    var phi_857_: f32;
    var phi_858_: f32;
    var phi_3321_: bool;
    var phi_931_: type_40;
    var phi_934_: type_62;
    var phi_936_: u32;
    var phi_938_: bool;
    var phi_940_: u32;
    var phi_951_: bool;
    var phi_1037_: type_62;
    var phi_1038_: bool;
    var phi_1039_: u32;
    var phi_2279_: type_49;
    var phi_3111_: type_62;
    var phi_3188_: type_62;
    var phi_3189_: type_62;
    var phi_3190_: u32;
    var phi_3192_: type_62;
    var phi_3193_: u32;
    var phi_3194_: bool;
    var phi_3201_: type_62;
    var phi_3206_: type_62;
    var phi_3207_: bool;
    var phi_1058_: type_40;
    var phi_1061_: type_8;
    var phi_1062_: type_8;
    var phi_1084_: type_8;
    var phi_1109_: u32;
    var phi_1125_: type_56;
    var phi_1831_: vec3<f32>;
    var phi_1832_: vec3<f32>;
    var phi_1863_: bool;
    var phi_1872_: vec3<f32>;
    var phi_1912_: type_22;
    var phi_1914_: type_22;
    var phi_1915_: bool;
    var phi_1919_: type_22;
    var phi_1920_: type_22;
    var phi_1921_: type_22;
    var phi_1922_: bool;
    var phi_1926_: type_22;
    var phi_1927_: bool;
    var phi_1931_: type_22;
    var phi_1932_: bool;
    var phi_1936_: type_22;
    var phi_1959_: u32;
    var phi_1973_: i32;
    var phi_1989_: vec3<f32>;
    var phi_1990_: vec3<f32>;
    var phi_2002_: vec3<f32>;
    var phi_2003_: vec3<f32>;
    var phi_2015_: vec3<f32>;
    var phi_2016_: vec3<f32>;
    var phi_2052_: vec3<f32>;
    var phi_2234_: f32;
    var phi_2252_: bool;
    var phi_2253_: bool;
    var phi_2258_: type_40;
    var phi_2259_: type_40;
    var phi_1059_: type_40;
    var phi_3315_: bool;
    var local_10: type_40;
    var phi_3475_: bool;
    var phi_3209_: type_40;
    var phi_3210_: type_62;
    var phi_3211_: bool;
    var phi_3212_: u32;
    var phi_3474_: bool;
    var phi_3213_: type_40;
    var phi_3214_: type_62;
    var phi_3215_: u32;
    var phi_3216_: bool;
    var phi_3217_: u32;
    var phi_3473_: bool;
    var phi_3218_: type_40;
    var phi_3219_: type_62;
    var phi_3220_: u32;
    var phi_3221_: bool;
    var phi_3222_: u32;
    var phi_3472_: bool;
    var phi_932_: type_40;
    var phi_935_: type_62;
    var phi_937_: u32;
    var phi_939_: bool;
    var phi_941_: u32;
    var phi_3223_: bool;
    var phi_3471_: bool;
    var local_11: type_40;
    var local_12: type_40;

    switch bitcast<i32>(0u) {
        default: {
            let _e83 = global;
            let _e86 = arrayLength((&global_9.member));
            let _e101 = arrayLength((&global_7.member));
            let _e105 = global_4.member[0u][0u];
            let _e109 = global_4.member[0u][1u];
            let _e113 = global_4.member[0u][2u];
            let _e117 = global_4.member[1u][0u];
            let _e121 = global_4.member[1u][1u];
            let _e125 = global_4.member[1u][2u];
            let _e129 = global_4.member[1u][3u];
            let _e133 = (_e83.x + (_e83.y * 2097152u));
            let _e140 = (_e133 < arrayLength((&global_8.member)));
            if _e140 {
                if _e140 {
                } else {
                    break;
                }
                let _e144 = global_8.member[_e133].member_2;
                phi_271_ = _e144;
            } else {
                phi_271_ = 4294967295u;
            }
            let _e146 = phi_271_;
            let _e149 = global_1.member[0u];
            let _e153 = global_3.member[0u][0u];
            let _e157 = global_3.member[0u][1u];
            let _e161 = global_3.member[0u][2u];
            let _e165 = global_3.member[0u][3u];
            let _e169 = global_3.member[1u][0u];
            let _e173 = global_3.member[1u][1u];
            let _e177 = global_3.member[1u][2u];
            let _e181 = global_3.member[1u][3u];
            let _e182 = bitcast<f32>(_e153);
            let _e183 = bitcast<f32>(_e157);
            let _e184 = bitcast<f32>(_e161);
            let _e186 = bitcast<f32>(_e169);
            let _e187 = array<u32, 3>(_e173, _e177, _e181);
            let _e189 = bitcast<i32>(_e149);
            if (_e189 < -126i) {
                phi_315_ = -126i;
            } else {
                phi_315_ = select(_e189, 127i, (_e189 > 127i));
            }
            let _e194 = phi_315_;
            let _e199 = bitcast<f32>((bitcast<u32>((_e194 + 127i)) << bitcast<u32>(23i)));
            let _e205 = bitcast<f32>((bitcast<u32>(((_e189 - _e194) + 127i)) << bitcast<u32>(23i)));
            if (_e165 == 0u) {
                phi_339_ = type_36(array<f32, 3>(_e182, _e183, _e184), _e165, _e186, _e187);
            } else {
                phi_339_ = type_36(array<f32, 3>(((_e182 * _e199) * _e205), ((_e183 * _e199) * _e205), ((_e184 * _e199) * _e205)), _e165, ((_e186 * _e199) * _e205), _e187);
            }
            let _e218 = phi_339_;
            if _e140 {
                let _e219 = (_e133 < arrayLength((&global_2.member)));
                if _e219 {
                    if _e140 {
                    } else {
                        break;
                    }
                    let _e224 = global_8.member[_e133].member.member_1;
                    let _e229 = global_8.member[_e133].member.member_3;
                    if (_e224 <= _e229) {
                        let _e231 = (1u < _e101);
                        if _e231 {
                            if (0u < _e101) {
                            } else {
                                break;
                            }
                            let _e235 = atomicAdd((&global_7.member[0u]), 1u);
                            if ((_e235 + 1u) < _e235) {
                                if _e231 {
                                } else {
                                    break;
                                }
                                let _e240 = atomicAdd((&global_7.member[1u]), 1u);
                            }
                        }
                        if _e140 {
                        } else {
                            break;
                        }
                        let _e250 = global_8.member[_e133].member.member_2[0u];
                        let _e252 = (bitcast<u32>(_e250) & 2147483647u);
                        let _e258 = global_8.member[_e133].member.member_2[1u];
                        let _e260 = (bitcast<u32>(_e258) & 2147483647u);
                        let _e266 = global_8.member[_e133].member.member_2[2u];
                        let _e268 = (bitcast<u32>(_e266) & 2147483647u);
                        let _e274 = global_8.member[_e133].member.member[0u];
                        let _e276 = (bitcast<u32>(_e274) & 2147483647u);
                        let _e282 = global_8.member[_e133].member.member[1u];
                        let _e284 = (bitcast<u32>(_e282) & 2147483647u);
                        let _e290 = global_8.member[_e133].member.member[2u];
                        let _e292 = (bitcast<u32>(_e290) & 2147483647u);
                        let _e294 = select(_e260, _e252, (_e260 < _e252));
                        let _e296 = select(_e268, _e294, (_e268 < _e294));
                        let _e298 = select(_e276, _e296, (_e276 < _e296));
                        let _e300 = select(_e284, _e298, (_e284 < _e298));
                        let _e302 = select(_e292, _e300, (_e292 < _e300));
                        let _e304 = (bitcast<u32>(_e224) & 2147483647u);
                        let _e313 = (((select(_e304, _e302, (_e304 < _e302)) < 2139095040u) && ((bitcast<u32>(_e229) & 2147483647u) <= 2139095040u)) && (_e296 > 0u));
                        if _e313 {
                            let _e316 = (bitcast<u32>(bitcast<f32>(_e296)) & 2147483647u);
                            if (_e316 >= 8388608u) {
                                phi_489_ = (bitcast<i32>((_e316 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_489_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e316)), 32u, (_e316 == 0u))));
                            }
                            let _e330 = phi_489_;
                            phi_490_ = _e330;
                        } else {
                            phi_490_ = 0i;
                        }
                        let _e332 = phi_490_;
                        let _e333 = (_e252 == _e296);
                        if _e333 {
                            phi_500_ = true;
                        } else {
                            phi_500_ = (_e260 == _e296);
                        }
                        let _e336 = phi_500_;
                        let _e337 = select(1u, 0u, _e333);
                        if _e336 {
                            let _e338 = (_e337 + 1u);
                            phi_510_ = _e338;
                            phi_511_ = _e338;
                            phi_513_ = select(true, false, (_e338 == 2u));
                        } else {
                            phi_510_ = u32();
                            phi_511_ = 0u;
                            phi_513_ = true;
                        }
                        let _e342 = phi_510_;
                        let _e344 = phi_511_;
                        let _e346 = phi_513_;
                        if _e346 {
                            phi_518_ = (_e344 + 1u);
                        } else {
                            phi_518_ = 0u;
                        }
                        let _e350 = phi_518_;
                        let _e351 = select(_e342, _e344, _e346);
                        let _e352 = select(_e337, select(2u, _e337, _e336), _e346);
                        let _e353 = -(_e332);
                        if (_e353 < -126i) {
                            phi_550_ = -126i;
                        } else {
                            phi_550_ = select(_e353, 127i, (_e353 > 127i));
                        }
                        let _e358 = phi_550_;
                        let _e363 = bitcast<f32>((bitcast<u32>((_e358 + 127i)) << bitcast<u32>(23i)));
                        let _e369 = bitcast<f32>((bitcast<u32>(((_e353 - _e358) + 127i)) << bitcast<u32>(23i)));
                        let _e374 = global_8.member[_e133].member.member;
                        let _e375 = (_e351 == 0u);
                        if _e375 {
                            phi_568_ = _e374[0];
                        } else {
                            phi_568_ = _e374[1];
                        }
                        let _e379 = phi_568_;
                        let _e380 = (_e351 == 2u);
                        if _e380 {
                            phi_574_ = _e374[2];
                        } else {
                            phi_574_ = _e379;
                        }
                        let _e383 = phi_574_;
                        let _e384 = global_8.member[_e133].member.member_2;
                        if _e375 {
                            phi_585_ = _e384[0];
                        } else {
                            phi_585_ = _e384[1];
                        }
                        let _e388 = phi_585_;
                        if _e380 {
                            phi_591_ = _e384[2];
                        } else {
                            phi_591_ = _e388;
                        }
                        let _e391 = phi_591_;
                        let _e393 = ((_e391 * _e363) * _e369);
                        let _e397 = (bitcast<f32>((bitcast<u32>(_e393) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e397 {
                            let _e401 = (bitcast<f32>((bitcast<u32>(_e383) & 2147483647u)) * 0.00000011920929f);
                            phi_614_ = select(0.00000000000011368684f, _e401, (_e401 > 0.00000000000011368684f));
                        } else {
                            phi_614_ = 0f;
                        }
                        let _e405 = phi_614_;
                        let _e406 = (_e383 + _e405);
                        let _e407 = (_e383 - _e405);
                        let _e408 = select(_e393, 0f, _e397);
                        if _e397 {
                            phi_625_ = 38685626000000000000000000f;
                        } else {
                            phi_625_ = (1f / _e393);
                        }
                        let _e411 = phi_625_;
                        let _e412 = (_e350 == 0u);
                        if _e412 {
                            phi_634_ = _e374[0];
                        } else {
                            phi_634_ = _e374[1];
                        }
                        let _e416 = phi_634_;
                        let _e417 = (_e350 == 2u);
                        if _e417 {
                            phi_640_ = _e374[2];
                        } else {
                            phi_640_ = _e416;
                        }
                        let _e420 = phi_640_;
                        if _e412 {
                            phi_651_ = _e384[0];
                        } else {
                            phi_651_ = _e384[1];
                        }
                        let _e424 = phi_651_;
                        if _e417 {
                            phi_657_ = _e384[2];
                        } else {
                            phi_657_ = _e424;
                        }
                        let _e427 = phi_657_;
                        let _e429 = ((_e427 * _e363) * _e369);
                        let _e433 = (bitcast<f32>((bitcast<u32>(_e429) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e433 {
                            let _e437 = (bitcast<f32>((bitcast<u32>(_e420) & 2147483647u)) * 0.00000011920929f);
                            phi_680_ = select(0.00000000000011368684f, _e437, (_e437 > 0.00000000000011368684f));
                        } else {
                            phi_680_ = 0f;
                        }
                        let _e441 = phi_680_;
                        let _e442 = (_e420 + _e441);
                        let _e443 = (_e420 - _e441);
                        let _e444 = select(_e429, 0f, _e433);
                        if _e433 {
                            phi_691_ = 38685626000000000000000000f;
                        } else {
                            phi_691_ = (1f / _e429);
                        }
                        let _e447 = phi_691_;
                        let _e448 = (_e352 == 0u);
                        if _e448 {
                            phi_700_ = _e374[0];
                        } else {
                            phi_700_ = _e374[1];
                        }
                        let _e452 = phi_700_;
                        let _e453 = (_e352 == 2u);
                        if _e453 {
                            phi_706_ = _e374[2];
                        } else {
                            phi_706_ = _e452;
                        }
                        let _e456 = phi_706_;
                        if _e448 {
                            phi_717_ = _e384[0];
                        } else {
                            phi_717_ = _e384[1];
                        }
                        let _e460 = phi_717_;
                        if _e453 {
                            phi_723_ = _e384[2];
                        } else {
                            phi_723_ = _e460;
                        }
                        let _e463 = phi_723_;
                        let _e465 = ((_e463 * _e363) * _e369);
                        let _e469 = (bitcast<f32>((bitcast<u32>(_e465) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e469 {
                            let _e473 = (bitcast<f32>((bitcast<u32>(_e456) & 2147483647u)) * 0.00000011920929f);
                            phi_746_ = select(0.00000000000011368684f, _e473, (_e473 > 0.00000000000011368684f));
                        } else {
                            phi_746_ = 0f;
                        }
                        let _e477 = phi_746_;
                        let _e478 = (_e456 + _e477);
                        let _e479 = (_e456 - _e477);
                        let _e480 = select(_e465, 0f, _e469);
                        if _e469 {
                            phi_757_ = 38685626000000000000000000f;
                        } else {
                            phi_757_ = (1f / _e465);
                        }
                        let _e483 = phi_757_;
                        let _e486 = bitcast<f32>((bitcast<u32>(_e383) & 2147483647u));
                        let _e489 = bitcast<f32>((bitcast<u32>(_e420) & 2147483647u));
                        let _e491 = select(_e489, _e486, (_e486 > _e489));
                        let _e494 = bitcast<f32>((bitcast<u32>(_e456) & 2147483647u));
                        if (_e313 && (select(_e494, _e491, (_e491 > _e494)) <= 1099511600000f)) {
                            let _e499 = (_e332 / 3i);
                            let _e506 = bitcast<f32>((bitcast<u32>((_e499 + 127i)) << bitcast<u32>(23i)));
                            let _e513 = bitcast<f32>((bitcast<u32>(((_e332 - (2i * _e499)) + 127i)) << bitcast<u32>(23i)));
                            let _e514 = (((_e224 * _e506) * _e506) * _e513);
                            let _e516 = select(340282350000000000000000000000000000000f, _e514, (_e514 < 340282350000000000000000000000000000000f));
                            let _e521 = (((_e229 * _e506) * _e506) * _e513);
                            let _e523 = select(340282350000000000000000000000000000000f, _e521, (_e521 < 340282350000000000000000000000000000000f));
                            phi_857_ = select(-340282350000000000000000000000000000000f, _e523, (_e523 > -340282350000000000000000000000000000000f));
                            phi_858_ = select(-340282350000000000000000000000000000000f, _e516, (_e516 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_857_ = 0f;
                            phi_858_ = 1f;
                        }
                        let _e527 = phi_857_;
                        let _e529 = phi_858_;
                        local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 3>(bitcast<f32>(_e105), bitcast<f32>(_e109), bitcast<f32>(_e113));
                        let _e534 = (_e351 % 3u);
                        let _e535 = (_e534 < 3u);
                        if _e535 {
                        } else {
                            break;
                        }
                        let _e537 = local_9[_e534];
                        let _e538 = (_e350 % 3u);
                        let _e539 = (_e538 < 3u);
                        if _e539 {
                        } else {
                            break;
                        }
                        let _e541 = local_9[_e538];
                        let _e542 = (_e352 % 3u);
                        let _e543 = (_e542 < 3u);
                        if _e543 {
                        } else {
                            break;
                        }
                        let _e545 = local_9[_e542];
                        local_8 = array<f32, 3>(bitcast<f32>(_e117), bitcast<f32>(_e121), bitcast<f32>(_e125));
                        if _e535 {
                        } else {
                            break;
                        }
                        let _e549 = local_8[_e534];
                        if _e539 {
                        } else {
                            break;
                        }
                        let _e551 = local_8[_e538];
                        if _e543 {
                        } else {
                            break;
                        }
                        let _e553 = local_8[_e542];
                        phi_3321_ = false;
                        phi_931_ = type_40(_e527, false);
                        phi_934_ = type_62(type_54(array<f32, 3>(_e537, _e541, _e545), array<f32, 3>(_e549, _e551, _e553)), select(0u, 2147483648u, (_e86 == 0u)));
                        phi_936_ = ((3u * _e86) + 1u);
                        phi_938_ = (_e529 <= _e527);
                        phi_940_ = 0u;
                        loop {
                            let _e561 = phi_3321_;
                            let _e563 = phi_931_;
                            let _e565 = phi_934_;
                            let _e567 = phi_936_;
                            let _e569 = phi_938_;
                            let _e571 = phi_940_;
                            local_11 = _e563;
                            if _e569 {
                                phi_951_ = true;
                            } else {
                                phi_951_ = (_e571 > 0u);
                            }
                            let _e574 = phi_951_;
                            if _e574 {
                                let _e575 = (_e567 > 0u);
                                if _e575 {
                                    if _e569 {
                                        phi_1037_ = _e565;
                                        phi_1038_ = _e569;
                                        phi_1039_ = _e571;
                                    } else {
                                        let _e576 = (_e571 - 1u);
                                        let _e577 = (_e576 % 128u);
                                        let _e578 = (_e577 < 128u);
                                        if _e578 {
                                        } else {
                                            phi_3471_ = true;
                                            break;
                                        }
                                        let _e580 = local_6[_e577];
                                        if _e578 {
                                        } else {
                                            phi_3471_ = true;
                                            break;
                                        }
                                        let _e582 = local_5[_e577];
                                        if _e578 {
                                        } else {
                                            phi_3471_ = true;
                                            break;
                                        }
                                        let _e584 = local_4[_e577];
                                        if _e578 {
                                        } else {
                                            phi_3471_ = true;
                                            break;
                                        }
                                        let _e586 = local_3[_e577];
                                        if _e578 {
                                        } else {
                                            phi_3471_ = true;
                                            break;
                                        }
                                        let _e589 = local_2[_e577];
                                        if _e578 {
                                        } else {
                                            phi_3471_ = true;
                                            break;
                                        }
                                        let _e591 = local_1[_e577];
                                        if _e578 {
                                        } else {
                                            phi_3471_ = true;
                                            break;
                                        }
                                        let _e593 = local[_e577];
                                        if _e578 {
                                        } else {
                                            phi_3471_ = true;
                                            break;
                                        }
                                        let _e598 = local_7[_e577];
                                        phi_1037_ = type_62(type_54(array<f32, 3>(_e582, _e584, _e586), array<f32, 3>(_e589, _e591, _e593)), _e580);
                                        phi_1038_ = (_e598 <= _e563.member);
                                        phi_1039_ = _e576;
                                    }
                                    let _e602 = phi_1037_;
                                    let _e604 = phi_1038_;
                                    let _e606 = phi_1039_;
                                    if _e604 {
                                        if ((_e602.member_1 & 2147483648u) != 0u) {
                                            phi_1058_ = _e563;
                                            phi_1061_ = type_8(0u, ((_e602.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e959 = phi_1058_;
                                                let _e961 = phi_1061_;
                                                local_10 = _e959;
                                                local_12 = _e959;
                                                if (_e961.member < _e961.member_1) {
                                                    phi_1062_ = type_8((_e961.member + 1u), _e961.member_1);
                                                    phi_1084_ = type_8(1u, _e961.member);
                                                } else {
                                                    phi_1062_ = _e961;
                                                    phi_1084_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e974 = phi_1062_;
                                                let _e976 = phi_1084_;
                                                let _e980 = (bitcast<i32>(_e976.member) != 0i);
                                                if _e980 {
                                                    let _e981 = ((_e602.member_1 & 268435455u) + _e976.member_1);
                                                    let _e982 = (_e981 < arrayLength((&global_10.member)));
                                                    if _e982 {
                                                        if _e982 {
                                                        } else {
                                                            phi_3315_ = true;
                                                            break;
                                                        }
                                                        let _e985 = global_10.member[_e981].member_1;
                                                        phi_1109_ = _e985;
                                                    } else {
                                                        phi_1109_ = 4294967295u;
                                                    }
                                                    let _e987 = phi_1109_;
                                                    if _e982 {
                                                        if _e982 {
                                                        } else {
                                                            phi_3315_ = true;
                                                            break;
                                                        }
                                                        let _e989 = global_10.member[_e981];
                                                        phi_1125_ = _e989;
                                                    } else {
                                                        phi_1125_ = type_56(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                    }
                                                    let _e991 = phi_1125_;
                                                    let _e1003 = ((10u * _e351) & 31u);
                                                    let _e1006 = ((_e991.member[0] >> bitcast<u32>(_e1003)) & 1023u);
                                                    let _e1011 = bitcast<f32>((bitcast<u32>(((_e602.member.member_1[0] - _e602.member.member[0]) * 0.0009775171f)) ^ _e129));
                                                    let _e1017 = (_e602.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1006) * _e1011)) ^ _e129)));
                                                    let _e1021 = select(select(_e602.member.member_1[0], _e1017, (_e1017 < _e602.member.member_1[0])), _e602.member.member_1[0], (_e1006 == 1023u));
                                                    let _e1023 = ((10u * _e350) & 31u);
                                                    let _e1026 = ((_e991.member[0] >> bitcast<u32>(_e1023)) & 1023u);
                                                    let _e1031 = bitcast<f32>((bitcast<u32>(((_e602.member.member_1[1] - _e602.member.member[1]) * 0.0009775171f)) ^ _e129));
                                                    let _e1037 = (_e602.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1026) * _e1031)) ^ _e129)));
                                                    let _e1041 = select(select(_e602.member.member_1[1], _e1037, (_e1037 < _e602.member.member_1[1])), _e602.member.member_1[1], (_e1026 == 1023u));
                                                    let _e1043 = ((10u * _e352) & 31u);
                                                    let _e1046 = ((_e991.member[0] >> bitcast<u32>(_e1043)) & 1023u);
                                                    let _e1051 = bitcast<f32>((bitcast<u32>(((_e602.member.member_1[2] - _e602.member.member[2]) * 0.0009775171f)) ^ _e129));
                                                    let _e1057 = (_e602.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1046) * _e1051)) ^ _e129)));
                                                    let _e1061 = select(select(_e602.member.member_1[2], _e1057, (_e1057 < _e602.member.member_1[2])), _e602.member.member_1[2], (_e1046 == 1023u));
                                                    let _e1065 = ((_e991.member[1] >> bitcast<u32>(_e1003)) & 1023u);
                                                    let _e1071 = (_e602.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1065) * _e1011)) ^ _e129)));
                                                    let _e1075 = select(select(_e602.member.member_1[0], _e1071, (_e1071 < _e602.member.member_1[0])), _e602.member.member_1[0], (_e1065 == 1023u));
                                                    let _e1078 = ((_e991.member[1] >> bitcast<u32>(_e1023)) & 1023u);
                                                    let _e1084 = (_e602.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1078) * _e1031)) ^ _e129)));
                                                    let _e1088 = select(select(_e602.member.member_1[1], _e1084, (_e1084 < _e602.member.member_1[1])), _e602.member.member_1[1], (_e1078 == 1023u));
                                                    let _e1091 = ((_e991.member[1] >> bitcast<u32>(_e1043)) & 1023u);
                                                    let _e1097 = (_e602.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1091) * _e1051)) ^ _e129)));
                                                    let _e1101 = select(select(_e602.member.member_1[2], _e1097, (_e1097 < _e602.member.member_1[2])), _e602.member.member_1[2], (_e1091 == 1023u));
                                                    let _e1105 = ((_e991.member[2] >> bitcast<u32>(_e1003)) & 1023u);
                                                    let _e1111 = (_e602.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e1105) * _e1011)) ^ _e129)));
                                                    let _e1115 = select(select(_e602.member.member_1[0], _e1111, (_e1111 < _e602.member.member_1[0])), _e602.member.member_1[0], (_e1105 == 1023u));
                                                    let _e1118 = ((_e991.member[2] >> bitcast<u32>(_e1023)) & 1023u);
                                                    let _e1124 = (_e602.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e1118) * _e1031)) ^ _e129)));
                                                    let _e1128 = select(select(_e602.member.member_1[1], _e1124, (_e1124 < _e602.member.member_1[1])), _e602.member.member_1[1], (_e1118 == 1023u));
                                                    let _e1131 = ((_e991.member[2] >> bitcast<u32>(_e1043)) & 1023u);
                                                    let _e1137 = (_e602.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e1131) * _e1051)) ^ _e129)));
                                                    let _e1141 = select(select(_e602.member.member_1[2], _e1137, (_e1137 < _e602.member.member_1[2])), _e602.member.member_1[2], (_e1131 == 1023u));
                                                    let _e1145 = (_e1061 - _e456);
                                                    let _e1148 = (((_e1021 - _e383) * _e480) - (_e1145 * _e408));
                                                    let _e1151 = (((_e1041 - _e420) * _e480) - (_e1145 * _e444));
                                                    let _e1154 = (_e1101 - _e456);
                                                    let _e1157 = (((_e1075 - _e383) * _e480) - (_e1154 * _e408));
                                                    let _e1160 = (((_e1088 - _e420) * _e480) - (_e1154 * _e444));
                                                    let _e1163 = (_e1141 - _e456);
                                                    let _e1166 = (((_e1115 - _e383) * _e480) - (_e1163 * _e408));
                                                    let _e1169 = (((_e1128 - _e420) * _e480) - (_e1163 * _e444));
                                                    let _e1170 = (_e1166 * _e1160);
                                                    let _e1171 = (_e1169 * _e1157);
                                                    let _e1172 = (_e1148 * _e1169);
                                                    let _e1173 = (_e1151 * _e1166);
                                                    let _e1174 = (_e1157 * _e1151);
                                                    let _e1175 = (_e1160 * _e1148);
                                                    let _e1180 = (((_e1170 >= _e1171) && (_e1172 >= _e1173)) && (_e1174 >= _e1175));
                                                    if (_e1180 || (((_e1170 <= _e1171) && (_e1172 <= _e1173)) && (_e1174 <= _e1175))) {
                                                        let _e1187 = select(-1f, 1f, _e1180);
                                                        let _e1189 = ((_e1170 - _e1171) * _e1187);
                                                        let _e1191 = select(0f, _e1189, (_e1189 > 0f));
                                                        let _e1193 = ((_e1172 - _e1173) * _e1187);
                                                        let _e1195 = select(0f, _e1193, (_e1193 > 0f));
                                                        let _e1197 = ((_e1174 - _e1175) * _e1187);
                                                        let _e1199 = select(0f, _e1197, (_e1197 > 0f));
                                                        let _e1201 = ((_e1191 + _e1195) + _e1199);
                                                        if (_e1201 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_1926_ = type_22();
                                                            phi_1927_ = true;
                                                        } else {
                                                            let _e1204 = select(_e1075, _e1021, (_e1021 < _e1075));
                                                            let _e1208 = select(_e1075, _e1021, (_e1021 > _e1075));
                                                            let _e1212 = select(_e1088, _e1041, (_e1041 < _e1088));
                                                            let _e1216 = select(_e1088, _e1041, (_e1041 > _e1088));
                                                            let _e1220 = select(_e1101, _e1061, (_e1061 < _e1101));
                                                            let _e1224 = select(_e1101, _e1061, (_e1061 > _e1101));
                                                            let _e1229 = ((select(_e1115, _e1204, (_e1204 < _e1115)) - _e406) * _e411);
                                                            let _e1230 = ((select(_e1115, _e1208, (_e1208 > _e1115)) - _e407) * _e411);
                                                            let _e1233 = ((select(_e1128, _e1212, (_e1212 < _e1128)) - _e442) * _e447);
                                                            let _e1234 = ((select(_e1128, _e1216, (_e1216 > _e1128)) - _e443) * _e447);
                                                            let _e1237 = ((select(_e1141, _e1220, (_e1220 < _e1141)) - _e478) * _e483);
                                                            let _e1238 = ((select(_e1141, _e1224, (_e1224 > _e1141)) - _e479) * _e483);
                                                            let _e1240 = select(_e1238, _e1237, (_e1237 < _e1238));
                                                            let _e1242 = select(_e1238, _e1237, (_e1237 > _e1238));
                                                            let _e1244 = select(_e1230, _e1229, (_e1229 < _e1230));
                                                            let _e1246 = select(_e1234, _e1233, (_e1233 < _e1234));
                                                            let _e1248 = select(_e1246, _e1244, (_e1244 > _e1246));
                                                            let _e1250 = select(_e1240, _e1248, (_e1248 > _e1240));
                                                            let _e1252 = select(_e1230, _e1229, (_e1229 > _e1230));
                                                            let _e1254 = select(_e1234, _e1233, (_e1233 > _e1234));
                                                            let _e1256 = select(_e1254, _e1252, (_e1252 < _e1254));
                                                            let _e1258 = select(_e1242, _e1256, (_e1256 < _e1242));
                                                            let _e1259 = -(_e1240);
                                                            let _e1265 = select(_e529, _e1250, (_e1250 > _e529));
                                                            if (_e1265 > (_e1258 + (select(_e1259, _e1242, (_e1242 > _e1259)) * 0.0000019073523f))) {
                                                                phi_1921_ = type_22();
                                                                phi_1922_ = true;
                                                            } else {
                                                                let _e1267 = (_e1265 > _e959.member);
                                                                if _e1267 {
                                                                    phi_1920_ = type_22();
                                                                } else {
                                                                    let _e1271 = (_e1075 - _e1021);
                                                                    let _e1272 = (_e1088 - _e1041);
                                                                    let _e1273 = (_e1101 - _e1061);
                                                                    let _e1274 = vec3<f32>(_e1271, _e1272, _e1273);
                                                                    let _e1275 = (_e1115 - _e1075);
                                                                    let _e1276 = (_e1128 - _e1088);
                                                                    let _e1277 = (_e1141 - _e1101);
                                                                    let _e1278 = vec3<f32>(_e1275, _e1276, _e1277);
                                                                    let _e1279 = (_e1021 - _e1115);
                                                                    let _e1280 = (_e1041 - _e1128);
                                                                    let _e1281 = (_e1061 - _e1141);
                                                                    let _e1282 = vec3<f32>(_e1279, _e1280, _e1281);
                                                                    let _e1285 = bitcast<f32>((bitcast<u32>(_e1271) & 2147483647u));
                                                                    let _e1288 = bitcast<f32>((bitcast<u32>(_e1272) & 2147483647u));
                                                                    let _e1290 = select(_e1288, _e1285, (_e1285 > _e1288));
                                                                    let _e1293 = bitcast<f32>((bitcast<u32>(_e1273) & 2147483647u));
                                                                    let _e1295 = select(_e1293, _e1290, (_e1290 > _e1293));
                                                                    let _e1298 = bitcast<f32>((bitcast<u32>(_e1275) & 2147483647u));
                                                                    let _e1301 = bitcast<f32>((bitcast<u32>(_e1276) & 2147483647u));
                                                                    let _e1303 = select(_e1301, _e1298, (_e1298 > _e1301));
                                                                    let _e1306 = bitcast<f32>((bitcast<u32>(_e1277) & 2147483647u));
                                                                    let _e1308 = select(_e1306, _e1303, (_e1303 > _e1306));
                                                                    let _e1311 = bitcast<f32>((bitcast<u32>(_e1279) & 2147483647u));
                                                                    let _e1314 = bitcast<f32>((bitcast<u32>(_e1280) & 2147483647u));
                                                                    let _e1316 = select(_e1314, _e1311, (_e1311 > _e1314));
                                                                    let _e1319 = bitcast<f32>((bitcast<u32>(_e1281) & 2147483647u));
                                                                    let _e1321 = select(_e1319, _e1316, (_e1316 > _e1319));
                                                                    let _e1323 = select(_e1308, _e1295, (_e1295 > _e1308));
                                                                    let _e1325 = select(_e1321, _e1323, (_e1323 > _e1321));
                                                                    if (_e1295 == _e1325) {
                                                                        phi_1831_ = _e1278;
                                                                        phi_1832_ = _e1282;
                                                                    } else {
                                                                        let _e1328 = vec3((_e1308 == _e1325));
                                                                        phi_1831_ = select(_e1274, _e1282, _e1328);
                                                                        phi_1832_ = select(_e1278, _e1274, _e1328);
                                                                    }
                                                                    let _e1332 = phi_1831_;
                                                                    let _e1334 = phi_1832_;
                                                                    let _e1341 = ((_e1332.y * _e1334.z) - (_e1334.y * _e1332.z));
                                                                    let _e1346 = ((_e1332.z * _e1334.x) - (_e1334.z * _e1332.x));
                                                                    let _e1349 = ((_e1332.x * _e1334.y) - (_e1334.x * _e1332.y));
                                                                    if (_e1191 >= _e1195) {
                                                                        phi_1863_ = select(true, false, (_e1191 >= _e1199));
                                                                    } else {
                                                                        phi_1863_ = true;
                                                                    }
                                                                    let _e1354 = phi_1863_;
                                                                    if _e1354 {
                                                                        phi_1872_ = select(vec3<f32>(_e1115, _e1128, _e1141), vec3<f32>(_e1075, _e1088, _e1101), vec3((_e1195 >= _e1199)));
                                                                    } else {
                                                                        phi_1872_ = vec3<f32>(_e1021, _e1041, _e1061);
                                                                    }
                                                                    let _e1359 = phi_1872_;
                                                                    let _e1376 = ((((_e1341 * (_e1359.x - _e383)) + (_e1346 * (_e1359.y - _e420))) + (_e1349 * (_e1359.z - _e456))) / (((_e1341 * _e408) + (_e1346 * _e444)) + (_e1349 * _e480)));
                                                                    let _e1378 = select(_e1258, _e1376, (_e1376 < _e1258));
                                                                    let _e1380 = select(_e1250, _e1378, (_e1378 > _e1250));
                                                                    if (_e1380 >= _e529) {
                                                                        let _e1382 = (_e1380 <= _e959.member);
                                                                        if _e1382 {
                                                                            let _e1383 = (1f / _e1201);
                                                                            phi_1912_ = type_22(_e1380, (_e1195 * _e1383), (_e1199 * _e1383), _e987);
                                                                        } else {
                                                                            phi_1912_ = type_22();
                                                                        }
                                                                        let _e1388 = phi_1912_;
                                                                        phi_1914_ = _e1388;
                                                                        phi_1915_ = select(true, false, _e1382);
                                                                    } else {
                                                                        phi_1914_ = type_22();
                                                                        phi_1915_ = true;
                                                                    }
                                                                    let _e1391 = phi_1914_;
                                                                    let _e1393 = phi_1915_;
                                                                    if _e1393 {
                                                                        phi_1919_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_1919_ = _e1391;
                                                                    }
                                                                    let _e1395 = phi_1919_;
                                                                    phi_1920_ = _e1395;
                                                                }
                                                                let _e1397 = phi_1920_;
                                                                phi_1921_ = _e1397;
                                                                phi_1922_ = _e1267;
                                                            }
                                                            let _e1399 = phi_1921_;
                                                            let _e1401 = phi_1922_;
                                                            phi_1926_ = _e1399;
                                                            phi_1927_ = _e1401;
                                                        }
                                                        let _e1403 = phi_1926_;
                                                        let _e1405 = phi_1927_;
                                                        phi_1931_ = _e1403;
                                                        phi_1932_ = _e1405;
                                                    } else {
                                                        phi_1931_ = type_22();
                                                        phi_1932_ = true;
                                                    }
                                                    let _e1407 = phi_1931_;
                                                    let _e1409 = phi_1932_;
                                                    if _e1409 {
                                                        phi_1936_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1936_ = _e1407;
                                                    }
                                                    let _e1411 = phi_1936_;
                                                    if (_e1411.member_3 != 4294967295u) {
                                                        if (_e987 == _e146) {
                                                            phi_2253_ = false;
                                                        } else {
                                                            let _e1415 = (_e987 < arrayLength((&global_5.member)));
                                                            if _e1415 {
                                                                if _e1415 {
                                                                } else {
                                                                    phi_3315_ = true;
                                                                    break;
                                                                }
                                                                let _e1417 = global_5.member[_e987];
                                                                phi_1959_ = _e1417;
                                                            } else {
                                                                phi_1959_ = 4294967295u;
                                                            }
                                                            let _e1419 = phi_1959_;
                                                            let _e1420 = (_e1419 < arrayLength((&global_6.member)));
                                                            if _e1420 {
                                                                if _e1420 {
                                                                } else {
                                                                    phi_3315_ = true;
                                                                    break;
                                                                }
                                                                let _e1422 = global_6.member[_e1419];
                                                                phi_1973_ = _e1422;
                                                            } else {
                                                                phi_1973_ = 0i;
                                                            }
                                                            let _e1424 = phi_1973_;
                                                            let _e1425 = (_e1424 == 0i);
                                                            if _e1425 {
                                                                phi_2252_ = true;
                                                            } else {
                                                                if _e375 {
                                                                    phi_1990_ = vec3<f32>(_e1021, _e1041, _e1061);
                                                                } else {
                                                                    if (_e351 == 1u) {
                                                                        phi_1989_ = vec3<f32>(_e1061, _e1021, _e1041);
                                                                    } else {
                                                                        phi_1989_ = vec3<f32>(_e1041, _e1061, _e1021);
                                                                    }
                                                                    let _e1430 = phi_1989_;
                                                                    phi_1990_ = _e1430;
                                                                }
                                                                let _e1433 = phi_1990_;
                                                                if _e375 {
                                                                    phi_2003_ = vec3<f32>(_e1075, _e1088, _e1101);
                                                                } else {
                                                                    if (_e351 == 1u) {
                                                                        phi_2002_ = vec3<f32>(_e1101, _e1075, _e1088);
                                                                    } else {
                                                                        phi_2002_ = vec3<f32>(_e1088, _e1101, _e1075);
                                                                    }
                                                                    let _e1438 = phi_2002_;
                                                                    phi_2003_ = _e1438;
                                                                }
                                                                let _e1441 = phi_2003_;
                                                                if _e375 {
                                                                    phi_2016_ = vec3<f32>(_e1115, _e1128, _e1141);
                                                                } else {
                                                                    if (_e351 == 1u) {
                                                                        phi_2015_ = vec3<f32>(_e1141, _e1115, _e1128);
                                                                    } else {
                                                                        phi_2015_ = vec3<f32>(_e1128, _e1141, _e1115);
                                                                    }
                                                                    let _e1446 = phi_2015_;
                                                                    phi_2016_ = _e1446;
                                                                }
                                                                let _e1449 = phi_2016_;
                                                                let _e1452 = (_e1441.x - _e1433.x);
                                                                let _e1455 = (_e1441.y - _e1433.y);
                                                                let _e1458 = (_e1441.z - _e1433.z);
                                                                let _e1460 = (_e1449.x - _e1433.x);
                                                                let _e1462 = (_e1449.y - _e1433.y);
                                                                let _e1464 = (_e1449.z - _e1433.z);
                                                                if (_e218.member_1 == 1u) {
                                                                    phi_2052_ = (vec3<f32>(_e218.member[0], _e218.member[1], _e218.member[2]) - _e1433);
                                                                } else {
                                                                    phi_2052_ = vec3<f32>(_e218.member[0], _e218.member[1], _e218.member[2]);
                                                                }
                                                                let _e1479 = phi_2052_;
                                                                let _e1485 = bitcast<f32>((bitcast<u32>((_e1452 * _e1462)) ^ _e218.member_3[0]));
                                                                let _e1489 = bitcast<f32>((bitcast<u32>((_e1455 * _e1460)) ^ _e218.member_3[0]));
                                                                let _e1493 = bitcast<f32>((bitcast<u32>((_e1455 * _e1464)) ^ _e218.member_3[0]));
                                                                let _e1497 = bitcast<f32>((bitcast<u32>((_e1458 * _e1462)) ^ _e218.member_3[0]));
                                                                let _e1501 = bitcast<f32>((bitcast<u32>((_e1458 * _e1460)) ^ _e218.member_3[0]));
                                                                let _e1505 = bitcast<f32>((bitcast<u32>((_e1452 * _e1464)) ^ _e218.member_3[0]));
                                                                let _e1506 = (_e1493 - _e1497);
                                                                let _e1507 = (_e1501 - _e1505);
                                                                let _e1508 = (_e1485 - _e1489);
                                                                let _e1532 = (bitcast<f32>((bitcast<u32>(_e1493) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1497) & 2147483647u)));
                                                                let _e1539 = (bitcast<f32>((bitcast<u32>(_e1501) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1505) & 2147483647u)));
                                                                let _e1546 = (bitcast<f32>((bitcast<u32>(_e1485) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1489) & 2147483647u)));
                                                                if (_e218.member_2 == 0f) {
                                                                    phi_2234_ = 0f;
                                                                } else {
                                                                    let _e1576 = bitcast<f32>((bitcast<u32>(_e1506) & 2147483647u));
                                                                    let _e1579 = bitcast<f32>((bitcast<u32>(_e1507) & 2147483647u));
                                                                    let _e1582 = bitcast<f32>((bitcast<u32>(_e1508) & 2147483647u));
                                                                    let _e1584 = select(_e1582, _e1579, (_e1579 > _e1582));
                                                                    let _e1588 = select(_e1582, _e1579, (_e1579 < _e1582));
                                                                    let _e1592 = select(_e1579, _e1576, (_e1576 < _e1579));
                                                                    let _e1594 = select(_e1579, _e1576, (_e1576 > _e1579));
                                                                    let _e1596 = select(_e1582, _e1594, (_e1594 < _e1582));
                                                                    phi_2234_ = bitcast<f32>((bitcast<u32>((_e218.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1584, _e1576, (_e1576 > _e1584)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1596, _e1592, (_e1592 > _e1596)))) ^ _e218.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1588, _e1576, (_e1576 < _e1588)))) ^ _e218.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1532 + _e1539) + _e1546))) ^ _e218.member_3[0]))) * 1.0000005f)) ^ _e218.member_3[0])))) ^ _e218.member_3[0]));
                                                                }
                                                                let _e1623 = phi_2234_;
                                                                phi_2252_ = (_e1425 || !(((((bitcast<f32>((bitcast<u32>((_e1479.x * _e1506)) ^ _e218.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1479.y * _e1507)) ^ _e218.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1479.z * _e1508)) ^ _e218.member_3[0]))) * f32(-(_e1424))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1479.x) & 2147483647u)) * _e1532)) ^ _e218.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1479.y) & 2147483647u)) * _e1539)) ^ _e218.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1479.z) & 2147483647u)) * _e1546)) ^ _e218.member_3[0]))))) ^ _e218.member_3[0])) + _e1623) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1637 = phi_2252_;
                                                            phi_2253_ = _e1637;
                                                        }
                                                        let _e1639 = phi_2253_;
                                                        if _e1639 {
                                                            phi_2258_ = type_40(_e959.member, true);
                                                        } else {
                                                            phi_2258_ = _e959;
                                                        }
                                                        let _e1644 = phi_2258_;
                                                        phi_2259_ = _e1644;
                                                    } else {
                                                        phi_2259_ = _e959;
                                                    }
                                                    let _e1646 = phi_2259_;
                                                    phi_1059_ = _e1646;
                                                } else {
                                                    phi_1059_ = type_40();
                                                }
                                                let _e1648 = phi_1059_;
                                                continue;
                                                continuing {
                                                    phi_1058_ = _e1648;
                                                    phi_1061_ = _e974;
                                                    phi_3315_ = _e561;
                                                    break if !(_e980);
                                                }
                                            }
                                            let _e1651 = phi_3315_;
                                            phi_3471_ = _e1651;
                                            if _e1651 {
                                                break;
                                            }
                                            let _e1653 = local_10;
                                            phi_3475_ = _e1651;
                                            let _e1833 = local_12;
                                            phi_3209_ = _e1833;
                                            phi_3210_ = _e602;
                                            phi_3211_ = false;
                                            phi_3212_ = select(_e606, 0u, _e1653.member_1);
                                        } else {
                                            let _e616 = (_e602.member_1 < _e86);
                                            if _e616 {
                                                if _e616 {
                                                } else {
                                                    phi_3471_ = true;
                                                    break;
                                                }
                                                let _e618 = global_9.member[_e602.member_1];
                                                phi_2279_ = _e618;
                                            } else {
                                                phi_2279_ = type_49(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                            }
                                            let _e620 = phi_2279_;
                                            let _e635 = ((10u * _e351) & 31u);
                                            let _e638 = ((_e620.member[0] >> bitcast<u32>(_e635)) & 1023u);
                                            let _e643 = bitcast<f32>((bitcast<u32>(((_e602.member.member_1[0] - _e602.member.member[0]) * 0.0009775171f)) ^ _e129));
                                            let _e649 = (_e602.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e638) * _e643)) ^ _e129)));
                                            let _e653 = select(select(_e602.member.member_1[0], _e649, (_e649 < _e602.member.member_1[0])), _e602.member.member_1[0], (_e638 == 1023u));
                                            let _e655 = ((10u * _e350) & 31u);
                                            let _e658 = ((_e620.member[0] >> bitcast<u32>(_e655)) & 1023u);
                                            let _e663 = bitcast<f32>((bitcast<u32>(((_e602.member.member_1[1] - _e602.member.member[1]) * 0.0009775171f)) ^ _e129));
                                            let _e669 = (_e602.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e658) * _e663)) ^ _e129)));
                                            let _e673 = select(select(_e602.member.member_1[1], _e669, (_e669 < _e602.member.member_1[1])), _e602.member.member_1[1], (_e658 == 1023u));
                                            let _e675 = ((10u * _e352) & 31u);
                                            let _e678 = ((_e620.member[0] >> bitcast<u32>(_e675)) & 1023u);
                                            let _e683 = bitcast<f32>((bitcast<u32>(((_e602.member.member_1[2] - _e602.member.member[2]) * 0.0009775171f)) ^ _e129));
                                            let _e689 = (_e602.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e678) * _e683)) ^ _e129)));
                                            let _e693 = select(select(_e602.member.member_1[2], _e689, (_e689 < _e602.member.member_1[2])), _e602.member.member_1[2], (_e678 == 1023u));
                                            let _e696 = ((_e620.member[1] >> bitcast<u32>(_e635)) & 1023u);
                                            let _e702 = (_e602.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e696) * _e643)) ^ _e129)));
                                            let _e706 = select(select(_e602.member.member_1[0], _e702, (_e702 < _e602.member.member_1[0])), _e602.member.member_1[0], (_e696 == 1023u));
                                            let _e709 = ((_e620.member[1] >> bitcast<u32>(_e655)) & 1023u);
                                            let _e715 = (_e602.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e709) * _e663)) ^ _e129)));
                                            let _e719 = select(select(_e602.member.member_1[1], _e715, (_e715 < _e602.member.member_1[1])), _e602.member.member_1[1], (_e709 == 1023u));
                                            let _e722 = ((_e620.member[1] >> bitcast<u32>(_e675)) & 1023u);
                                            let _e728 = (_e602.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e722) * _e683)) ^ _e129)));
                                            let _e732 = select(select(_e602.member.member_1[2], _e728, (_e728 < _e602.member.member_1[2])), _e602.member.member_1[2], (_e722 == 1023u));
                                            let _e738 = ((_e620.member_1[0] >> bitcast<u32>(_e635)) & 1023u);
                                            let _e744 = (_e602.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e738) * _e643)) ^ _e129)));
                                            let _e748 = select(select(_e602.member.member_1[0], _e744, (_e744 < _e602.member.member_1[0])), _e602.member.member_1[0], (_e738 == 1023u));
                                            let _e751 = ((_e620.member_1[0] >> bitcast<u32>(_e655)) & 1023u);
                                            let _e757 = (_e602.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e751) * _e663)) ^ _e129)));
                                            let _e761 = select(select(_e602.member.member_1[1], _e757, (_e757 < _e602.member.member_1[1])), _e602.member.member_1[1], (_e751 == 1023u));
                                            let _e764 = ((_e620.member_1[0] >> bitcast<u32>(_e675)) & 1023u);
                                            let _e770 = (_e602.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e764) * _e683)) ^ _e129)));
                                            let _e774 = select(select(_e602.member.member_1[2], _e770, (_e770 < _e602.member.member_1[2])), _e602.member.member_1[2], (_e764 == 1023u));
                                            let _e777 = ((_e620.member_1[1] >> bitcast<u32>(_e635)) & 1023u);
                                            let _e783 = (_e602.member.member[0] + bitcast<f32>((bitcast<u32>((f32(_e777) * _e643)) ^ _e129)));
                                            let _e787 = select(select(_e602.member.member_1[0], _e783, (_e783 < _e602.member.member_1[0])), _e602.member.member_1[0], (_e777 == 1023u));
                                            let _e790 = ((_e620.member_1[1] >> bitcast<u32>(_e655)) & 1023u);
                                            let _e796 = (_e602.member.member[1] + bitcast<f32>((bitcast<u32>((f32(_e790) * _e663)) ^ _e129)));
                                            let _e800 = select(select(_e602.member.member_1[1], _e796, (_e796 < _e602.member.member_1[1])), _e602.member.member_1[1], (_e790 == 1023u));
                                            let _e803 = ((_e620.member_1[1] >> bitcast<u32>(_e675)) & 1023u);
                                            let _e809 = (_e602.member.member[2] + bitcast<f32>((bitcast<u32>((f32(_e803) * _e683)) ^ _e129)));
                                            let _e813 = select(select(_e602.member.member_1[2], _e809, (_e809 < _e602.member.member_1[2])), _e602.member.member_1[2], (_e803 == 1023u));
                                            let _e818 = type_62(type_54(array<f32, 3>(_e653, _e673, _e693), array<f32, 3>(_e706, _e719, _e732)), _e620.member_2);
                                            let _e823 = type_62(type_54(array<f32, 3>(_e748, _e761, _e774), array<f32, 3>(_e787, _e800, _e813)), _e620.member_3);
                                            let _e829 = ((_e653 - _e406) * _e411);
                                            let _e830 = ((_e748 - _e406) * _e411);
                                            let _e831 = ((_e706 - _e407) * _e411);
                                            let _e832 = ((_e787 - _e407) * _e411);
                                            let _e837 = ((_e673 - _e442) * _e447);
                                            let _e838 = ((_e761 - _e442) * _e447);
                                            let _e839 = ((_e719 - _e443) * _e447);
                                            let _e840 = ((_e800 - _e443) * _e447);
                                            let _e845 = ((_e693 - _e478) * _e483);
                                            let _e846 = ((_e774 - _e478) * _e483);
                                            let _e847 = ((_e732 - _e479) * _e483);
                                            let _e848 = ((_e813 - _e479) * _e483);
                                            let _e850 = select(_e847, _e845, (_e845 < _e847));
                                            let _e852 = select(_e848, _e846, (_e846 < _e848));
                                            let _e854 = select(_e847, _e845, (_e845 > _e847));
                                            let _e856 = select(_e848, _e846, (_e846 > _e848));
                                            let _e858 = select(_e831, _e829, (_e829 < _e831));
                                            let _e860 = select(_e832, _e830, (_e830 < _e832));
                                            let _e862 = select(_e839, _e837, (_e837 < _e839));
                                            let _e864 = select(_e840, _e838, (_e838 < _e840));
                                            let _e866 = select(_e862, _e858, (_e858 > _e862));
                                            let _e868 = select(_e864, _e860, (_e860 > _e864));
                                            let _e870 = select(_e850, _e866, (_e866 > _e850));
                                            let _e872 = select(_e852, _e868, (_e868 > _e852));
                                            let _e874 = select(_e831, _e829, (_e829 > _e831));
                                            let _e876 = select(_e832, _e830, (_e830 > _e832));
                                            let _e878 = select(_e839, _e837, (_e837 > _e839));
                                            let _e880 = select(_e840, _e838, (_e838 > _e840));
                                            let _e882 = select(_e878, _e874, (_e874 < _e878));
                                            let _e884 = select(_e880, _e876, (_e876 < _e880));
                                            let _e889 = -(_e850);
                                            let _e890 = -(_e852);
                                            let _e897 = (select(_e854, _e882, (_e882 < _e854)) + (select(_e889, _e854, (_e854 > _e889)) * 0.0000019073523f));
                                            let _e898 = (select(_e856, _e884, (_e884 < _e856)) + (select(_e890, _e856, (_e856 > _e890)) * 0.0000019073523f));
                                            let _e900 = select(_e529, _e870, (_e870 > _e529));
                                            let _e902 = select(_e529, _e872, (_e872 > _e529));
                                            let _e907 = (_e900 <= select(_e563.member, _e897, (_e897 < _e563.member)));
                                            let _e908 = (_e902 <= select(_e563.member, _e898, (_e898 < _e563.member)));
                                            let _e909 = (_e900 <= _e902);
                                            if _e907 {
                                                if _e908 {
                                                    if _e909 {
                                                        phi_3111_ = _e823;
                                                    } else {
                                                        phi_3111_ = _e818;
                                                    }
                                                    let _e911 = phi_3111_;
                                                    let _e919 = (_e606 % 128u);
                                                    let _e920 = (_e919 < 128u);
                                                    if _e920 {
                                                    } else {
                                                        phi_3471_ = true;
                                                        break;
                                                    }
                                                    local_6[_e919] = _e911.member_1;
                                                    if _e920 {
                                                    } else {
                                                        phi_3471_ = true;
                                                        break;
                                                    }
                                                    local_5[_e919] = _e911.member.member[0];
                                                    if _e920 {
                                                    } else {
                                                        phi_3471_ = true;
                                                        break;
                                                    }
                                                    local_4[_e919] = _e911.member.member[1];
                                                    if _e920 {
                                                    } else {
                                                        phi_3471_ = true;
                                                        break;
                                                    }
                                                    local_3[_e919] = _e911.member.member[2];
                                                    if _e920 {
                                                    } else {
                                                        phi_3471_ = true;
                                                        break;
                                                    }
                                                    local_2[_e919] = _e911.member.member_1[0];
                                                    if _e920 {
                                                    } else {
                                                        phi_3471_ = true;
                                                        break;
                                                    }
                                                    local_1[_e919] = _e911.member.member_1[1];
                                                    if _e920 {
                                                    } else {
                                                        phi_3471_ = true;
                                                        break;
                                                    }
                                                    local[_e919] = _e911.member.member_1[2];
                                                    if _e920 {
                                                    } else {
                                                        phi_3471_ = true;
                                                        break;
                                                    }
                                                    local_7[_e919] = select(_e902, _e900, (_e900 > _e902));
                                                    if _e909 {
                                                        phi_3188_ = _e818;
                                                    } else {
                                                        phi_3188_ = _e823;
                                                    }
                                                    let _e937 = phi_3188_;
                                                    phi_3189_ = _e937;
                                                    phi_3190_ = (_e606 + 1u);
                                                } else {
                                                    phi_3189_ = type_62();
                                                    phi_3190_ = u32();
                                                }
                                                let _e939 = phi_3189_;
                                                let _e941 = phi_3190_;
                                                phi_3192_ = _e939;
                                                phi_3193_ = _e941;
                                                phi_3194_ = select(true, false, _e908);
                                            } else {
                                                phi_3192_ = type_62();
                                                phi_3193_ = u32();
                                                phi_3194_ = true;
                                            }
                                            let _e944 = phi_3192_;
                                            let _e946 = phi_3193_;
                                            let _e948 = phi_3194_;
                                            if _e948 {
                                                if _e907 {
                                                    phi_3201_ = _e818;
                                                } else {
                                                    phi_3201_ = _e823;
                                                }
                                                let _e950 = phi_3201_;
                                                phi_3206_ = _e950;
                                                phi_3207_ = select(_e908, true, _e907);
                                            } else {
                                                phi_3206_ = _e944;
                                                phi_3207_ = _e604;
                                            }
                                            let _e953 = phi_3206_;
                                            let _e955 = phi_3207_;
                                            phi_3475_ = _e561;
                                            phi_3209_ = _e563;
                                            phi_3210_ = _e953;
                                            phi_3211_ = _e955;
                                            phi_3212_ = select(_e946, _e606, _e948);
                                        }
                                        let _e1657 = phi_3475_;
                                        let _e1659 = phi_3209_;
                                        let _e1661 = phi_3210_;
                                        let _e1663 = phi_3211_;
                                        let _e1665 = phi_3212_;
                                        phi_3474_ = _e1657;
                                        phi_3213_ = _e1659;
                                        phi_3214_ = _e1661;
                                        phi_3215_ = (_e567 - 1u);
                                        phi_3216_ = _e1663;
                                        phi_3217_ = _e1665;
                                    } else {
                                        phi_3474_ = _e561;
                                        phi_3213_ = _e563;
                                        phi_3214_ = _e602;
                                        phi_3215_ = _e567;
                                        phi_3216_ = _e604;
                                        phi_3217_ = _e606;
                                    }
                                    let _e1667 = phi_3474_;
                                    let _e1669 = phi_3213_;
                                    let _e1671 = phi_3214_;
                                    let _e1673 = phi_3215_;
                                    let _e1675 = phi_3216_;
                                    let _e1677 = phi_3217_;
                                    phi_3473_ = _e1667;
                                    phi_3218_ = _e1669;
                                    phi_3219_ = _e1671;
                                    phi_3220_ = _e1673;
                                    phi_3221_ = _e1675;
                                    phi_3222_ = _e1677;
                                } else {
                                    phi_3473_ = _e561;
                                    phi_3218_ = type_40();
                                    phi_3219_ = type_62();
                                    phi_3220_ = u32();
                                    phi_3221_ = bool();
                                    phi_3222_ = u32();
                                }
                                let _e1679 = phi_3473_;
                                let _e1681 = phi_3218_;
                                let _e1683 = phi_3219_;
                                let _e1685 = phi_3220_;
                                let _e1687 = phi_3221_;
                                let _e1689 = phi_3222_;
                                phi_3472_ = _e1679;
                                phi_932_ = _e1681;
                                phi_935_ = _e1683;
                                phi_937_ = _e1685;
                                phi_939_ = _e1687;
                                phi_941_ = _e1689;
                                phi_3223_ = _e575;
                            } else {
                                phi_3472_ = _e561;
                                phi_932_ = type_40();
                                phi_935_ = type_62();
                                phi_937_ = u32();
                                phi_939_ = bool();
                                phi_941_ = u32();
                                phi_3223_ = false;
                            }
                            let _e1691 = phi_3472_;
                            let _e1693 = phi_932_;
                            let _e1695 = phi_935_;
                            let _e1697 = phi_937_;
                            let _e1699 = phi_939_;
                            let _e1701 = phi_941_;
                            let _e1703 = phi_3223_;
                            continue;
                            continuing {
                                phi_3321_ = _e1691;
                                phi_931_ = _e1693;
                                phi_934_ = _e1695;
                                phi_936_ = _e1697;
                                phi_938_ = _e1699;
                                phi_940_ = _e1701;
                                phi_3471_ = _e1691;
                                break if !(_e1703);
                            }
                        }
                        let _e1706 = phi_3471_;
                        if _e1706 {
                            break;
                        }
                        let _e1708 = local_11;
                        if _e1708.member_1 {
                        } else {
                            if _e219 {
                            } else {
                                break;
                            }
                            let _e1712 = global_2.member[_e133];
                            if _e140 {
                            } else {
                                break;
                            }
                            let _e1716 = global_8.member[_e133].member_1;
                            if _e219 {
                            } else {
                                break;
                            }
                            global_2.member[_e133] = type_24(_e1712.member, _e1712.member_1, _e1712.member_2, array<f32, 3>((_e1712.member_3[0] + (_e1716[0] * _e1712.member_1[0])), (_e1712.member_3[1] + (_e1716[1] * _e1712.member_1[1])), (_e1712.member_3[2] + (_e1716[2] * _e1712.member_1[2]))), _e1712.member_4);
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
fn trace_shadows_printed_leaf10_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
