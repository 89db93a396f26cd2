struct type_4 {
    member: array<u32>,
}

struct type_8 {
    member: u32,
    member_1: u32,
}

struct type_13 {
    member: array<array<u32, 4>>,
}

struct type_16 {
    member: vec4<u32>,
}

struct type_22 {
    member: array<f32, 9>,
    member_1: u32,
}

struct type_24 {
    member: array<type_22>,
}

struct type_30 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_31 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_32 {
    member: type_31,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_34 {
    member: array<type_32>,
}

struct type_39 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_40 {
    member: type_31,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_42 {
    member: array<type_40>,
}

struct type_45 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_51 {
    member: f32,
    member_1: bool,
}

struct type_53 {
    member: array<vec4<u32>, 2>,
}

struct type_56 {
    member: array<i32>,
}

struct type_63 {
    member: type_39,
    member_1: u32,
}

struct type_64 {
    member: array<vec4<f32>, 3>,
    member_1: type_63,
    member_2: type_63,
}

struct type_69 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_16;
@group(0) @binding(8) 
var<storage, read_write> global_2: type_34;
@group(0) @binding(1) 
var<uniform> global_3: type_53;
@group(0) @binding(2) 
var<uniform> global_4: type_53;
@group(0) @binding(3) 
var<storage> global_5: type_13;
@group(0) @binding(4) 
var<storage> global_6: type_24;
@group(0) @binding(5) 
var<storage> global_7: type_4;
@group(0) @binding(6) 
var<storage> global_8: type_56;
@group(0) @binding(9) 
var<storage, read_write> global_9: type_69;
@group(0) @binding(7) 
var<storage> global_10: type_42;

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
    var phi_321_: u32;
    var phi_365_: i32;
    var phi_389_: type_45;
    var phi_539_: i32;
    var phi_540_: i32;
    var phi_550_: bool;
    var phi_560_: u32;
    var phi_561_: u32;
    var phi_563_: bool;
    var phi_568_: u32;
    var phi_600_: i32;
    var phi_618_: f32;
    var phi_624_: f32;
    var phi_635_: f32;
    var phi_641_: f32;
    var phi_664_: f32;
    var phi_675_: f32;
    var phi_684_: f32;
    var phi_690_: f32;
    var phi_701_: f32;
    var phi_707_: f32;
    var phi_730_: f32;
    var phi_741_: f32;
    var phi_750_: f32;
    var phi_756_: f32;
    var phi_767_: f32;
    var phi_773_: f32;
    var phi_796_: f32;
    var phi_807_: f32;
    var phi_907_: f32;
    var phi_908_: f32;
    var phi_3640_: bool;
    var phi_997_: type_51;
    var phi_1000_: type_63;
    var phi_1002_: u32;
    var phi_1004_: bool;
    var phi_1006_: u32;
    var phi_1017_: bool;
    var phi_1103_: type_63;
    var phi_1104_: bool;
    var phi_1105_: u32;
    var phi_2893_: u32;
    var phi_2894_: u32;
    var phi_2904_: u32;
    var phi_2906_: u32;
    var phi_2907_: bool;
    var phi_2927_: u32;
    var phi_2928_: u32;
    var phi_2932_: type_64;
    var phi_3276_: type_63;
    var phi_3353_: type_63;
    var phi_3354_: type_63;
    var phi_3355_: u32;
    var phi_3357_: type_63;
    var phi_3358_: u32;
    var phi_3359_: bool;
    var phi_3368_: type_63;
    var phi_3373_: type_63;
    var phi_3374_: bool;
    var phi_1123_: type_51;
    var phi_1126_: type_8;
    var phi_1127_: type_8;
    var phi_1149_: type_8;
    var phi_1170_: u32;
    var phi_1259_: array<array<f32, 3>, 3>;
    var phi_1730_: vec3<f32>;
    var phi_1731_: vec3<f32>;
    var phi_1762_: bool;
    var phi_1771_: vec3<f32>;
    var phi_1811_: type_30;
    var phi_1813_: type_30;
    var phi_1814_: bool;
    var phi_1818_: type_30;
    var phi_1819_: type_30;
    var phi_1820_: type_30;
    var phi_1821_: bool;
    var phi_1825_: type_30;
    var phi_1826_: bool;
    var phi_1830_: type_30;
    var phi_1831_: bool;
    var phi_1835_: type_30;
    var phi_1858_: u32;
    var phi_1872_: i32;
    var phi_1892_: vec3<f32>;
    var phi_1893_: vec3<f32>;
    var phi_1909_: vec3<f32>;
    var phi_1910_: vec3<f32>;
    var phi_1926_: vec3<f32>;
    var phi_1927_: vec3<f32>;
    var phi_1963_: vec3<f32>;
    var phi_2145_: f32;
    var phi_2163_: bool;
    var phi_2164_: bool;
    var phi_2169_: type_51;
    var phi_2170_: type_51;
    var phi_1124_: type_51;
    var phi_3634_: bool;
    var local_10: type_51;
    var phi_3776_: bool;
    var phi_3376_: type_51;
    var phi_3377_: type_63;
    var phi_3378_: bool;
    var phi_3379_: u32;
    var phi_3775_: bool;
    var phi_3380_: type_51;
    var phi_3381_: type_63;
    var phi_3382_: u32;
    var phi_3383_: bool;
    var phi_3384_: u32;
    var phi_3774_: bool;
    var phi_3385_: type_51;
    var phi_3386_: type_63;
    var phi_3387_: u32;
    var phi_3388_: bool;
    var phi_3389_: u32;
    var phi_3773_: bool;
    var phi_998_: type_51;
    var phi_1001_: type_63;
    var phi_1003_: u32;
    var phi_1005_: bool;
    var phi_1007_: u32;
    var phi_3390_: bool;
    var phi_3772_: bool;
    var local_11: type_51;
    var local_12: type_51;

    switch bitcast<i32>(0u) {
        default: {
            let _e93 = global;
            let _e95 = arrayLength((&global_5.member));
            let _e97 = arrayLength((&global_6.member));
            let _e109 = arrayLength((&global_9.member));
            let _e113 = global_4.member[0u][0u];
            let _e117 = global_4.member[0u][1u];
            let _e121 = global_4.member[0u][2u];
            let _e125 = global_4.member[0u][3u];
            let _e129 = global_4.member[1u][0u];
            let _e133 = global_4.member[1u][1u];
            let _e137 = global_4.member[1u][2u];
            let _e141 = (_e93.x + (_e93.y * 2097152u));
            let _e153 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e125) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e113), bitcast<i32>(_e117), bitcast<i32>(_e121));
            local = array<i32, 3>(bitcast<i32>(_e129), bitcast<i32>(_e133), bitcast<i32>(_e137));
            let _e156 = (_e141 < arrayLength((&global_10.member)));
            if _e156 {
                if _e156 {
                } else {
                    break;
                }
                let _e160 = global_10.member[_e141].member_2;
                phi_321_ = _e160;
            } else {
                phi_321_ = 4294967295u;
            }
            let _e162 = phi_321_;
            let _e165 = global_1.member[0u];
            let _e169 = global_3.member[0u][0u];
            let _e173 = global_3.member[0u][1u];
            let _e177 = global_3.member[0u][2u];
            let _e181 = global_3.member[0u][3u];
            let _e185 = global_3.member[1u][0u];
            let _e189 = global_3.member[1u][1u];
            let _e193 = global_3.member[1u][2u];
            let _e197 = global_3.member[1u][3u];
            let _e198 = bitcast<f32>(_e169);
            let _e199 = bitcast<f32>(_e173);
            let _e200 = bitcast<f32>(_e177);
            let _e202 = bitcast<f32>(_e185);
            let _e203 = array<u32, 3>(_e189, _e193, _e197);
            let _e205 = bitcast<i32>(_e165);
            if (_e205 < -126i) {
                phi_365_ = -126i;
            } else {
                phi_365_ = select(_e205, 127i, (_e205 > 127i));
            }
            let _e210 = phi_365_;
            let _e215 = bitcast<f32>((bitcast<u32>((_e210 + 127i)) << bitcast<u32>(23i)));
            let _e221 = bitcast<f32>((bitcast<u32>(((_e205 - _e210) + 127i)) << bitcast<u32>(23i)));
            if (_e181 == 0u) {
                phi_389_ = type_45(array<f32, 3>(_e198, _e199, _e200), _e181, _e202, _e203);
            } else {
                phi_389_ = type_45(array<f32, 3>(((_e198 * _e215) * _e221), ((_e199 * _e215) * _e221), ((_e200 * _e215) * _e221)), _e181, ((_e202 * _e215) * _e221), _e203);
            }
            let _e234 = phi_389_;
            if _e156 {
                let _e235 = (_e141 < arrayLength((&global_2.member)));
                if _e235 {
                    if _e156 {
                    } else {
                        break;
                    }
                    let _e240 = global_10.member[_e141].member.member_1;
                    let _e245 = global_10.member[_e141].member.member_3;
                    if (_e240 <= _e245) {
                        let _e247 = (1u < _e109);
                        if _e247 {
                            if (0u < _e109) {
                            } else {
                                break;
                            }
                            let _e251 = atomicAdd((&global_9.member[0u]), 1u);
                            if ((_e251 + 1u) < _e251) {
                                if _e247 {
                                } else {
                                    break;
                                }
                                let _e256 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                        if _e156 {
                        } else {
                            break;
                        }
                        let _e266 = global_10.member[_e141].member.member_2[0u];
                        let _e268 = (bitcast<u32>(_e266) & 2147483647u);
                        let _e274 = global_10.member[_e141].member.member_2[1u];
                        let _e276 = (bitcast<u32>(_e274) & 2147483647u);
                        let _e282 = global_10.member[_e141].member.member_2[2u];
                        let _e284 = (bitcast<u32>(_e282) & 2147483647u);
                        let _e290 = global_10.member[_e141].member.member[0u];
                        let _e292 = (bitcast<u32>(_e290) & 2147483647u);
                        let _e298 = global_10.member[_e141].member.member[1u];
                        let _e300 = (bitcast<u32>(_e298) & 2147483647u);
                        let _e306 = global_10.member[_e141].member.member[2u];
                        let _e308 = (bitcast<u32>(_e306) & 2147483647u);
                        let _e310 = select(_e276, _e268, (_e276 < _e268));
                        let _e312 = select(_e284, _e310, (_e284 < _e310));
                        let _e314 = select(_e292, _e312, (_e292 < _e312));
                        let _e316 = select(_e300, _e314, (_e300 < _e314));
                        let _e318 = select(_e308, _e316, (_e308 < _e316));
                        let _e320 = (bitcast<u32>(_e240) & 2147483647u);
                        let _e329 = (((select(_e320, _e318, (_e320 < _e318)) < 2139095040u) && ((bitcast<u32>(_e245) & 2147483647u) <= 2139095040u)) && (_e312 > 0u));
                        if _e329 {
                            let _e332 = (bitcast<u32>(bitcast<f32>(_e312)) & 2147483647u);
                            if (_e332 >= 8388608u) {
                                phi_539_ = (bitcast<i32>((_e332 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_539_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e332)), 32u, (_e332 == 0u))));
                            }
                            let _e346 = phi_539_;
                            phi_540_ = _e346;
                        } else {
                            phi_540_ = 0i;
                        }
                        let _e348 = phi_540_;
                        let _e349 = (_e268 == _e312);
                        if _e349 {
                            phi_550_ = true;
                        } else {
                            phi_550_ = (_e276 == _e312);
                        }
                        let _e352 = phi_550_;
                        let _e353 = select(1u, 0u, _e349);
                        if _e352 {
                            let _e354 = (_e353 + 1u);
                            phi_560_ = _e354;
                            phi_561_ = _e354;
                            phi_563_ = select(true, false, (_e354 == 2u));
                        } else {
                            phi_560_ = u32();
                            phi_561_ = 0u;
                            phi_563_ = true;
                        }
                        let _e358 = phi_560_;
                        let _e360 = phi_561_;
                        let _e362 = phi_563_;
                        if _e362 {
                            phi_568_ = (_e360 + 1u);
                        } else {
                            phi_568_ = 0u;
                        }
                        let _e366 = phi_568_;
                        let _e367 = select(_e358, _e360, _e362);
                        let _e368 = select(_e353, select(2u, _e353, _e352), _e362);
                        let _e369 = -(_e348);
                        if (_e369 < -126i) {
                            phi_600_ = -126i;
                        } else {
                            phi_600_ = select(_e369, 127i, (_e369 > 127i));
                        }
                        let _e374 = phi_600_;
                        let _e379 = bitcast<f32>((bitcast<u32>((_e374 + 127i)) << bitcast<u32>(23i)));
                        let _e385 = bitcast<f32>((bitcast<u32>(((_e369 - _e374) + 127i)) << bitcast<u32>(23i)));
                        let _e390 = global_10.member[_e141].member.member;
                        let _e391 = (_e367 == 0u);
                        if _e391 {
                            phi_618_ = _e390[0];
                        } else {
                            phi_618_ = _e390[1];
                        }
                        let _e395 = phi_618_;
                        let _e396 = (_e367 == 2u);
                        if _e396 {
                            phi_624_ = _e390[2];
                        } else {
                            phi_624_ = _e395;
                        }
                        let _e399 = phi_624_;
                        let _e400 = global_10.member[_e141].member.member_2;
                        if _e391 {
                            phi_635_ = _e400[0];
                        } else {
                            phi_635_ = _e400[1];
                        }
                        let _e404 = phi_635_;
                        if _e396 {
                            phi_641_ = _e400[2];
                        } else {
                            phi_641_ = _e404;
                        }
                        let _e407 = phi_641_;
                        let _e409 = ((_e407 * _e379) * _e385);
                        let _e413 = (bitcast<f32>((bitcast<u32>(_e409) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e413 {
                            let _e417 = (bitcast<f32>((bitcast<u32>(_e399) & 2147483647u)) * 0.00000011920929f);
                            phi_664_ = select(0.00000000000011368684f, _e417, (_e417 > 0.00000000000011368684f));
                        } else {
                            phi_664_ = 0f;
                        }
                        let _e421 = phi_664_;
                        let _e422 = (_e399 + _e421);
                        let _e423 = (_e399 - _e421);
                        let _e424 = select(_e409, 0f, _e413);
                        if _e413 {
                            phi_675_ = 38685626000000000000000000f;
                        } else {
                            phi_675_ = (1f / _e409);
                        }
                        let _e427 = phi_675_;
                        let _e428 = (_e366 == 0u);
                        if _e428 {
                            phi_684_ = _e390[0];
                        } else {
                            phi_684_ = _e390[1];
                        }
                        let _e432 = phi_684_;
                        let _e433 = (_e366 == 2u);
                        if _e433 {
                            phi_690_ = _e390[2];
                        } else {
                            phi_690_ = _e432;
                        }
                        let _e436 = phi_690_;
                        if _e428 {
                            phi_701_ = _e400[0];
                        } else {
                            phi_701_ = _e400[1];
                        }
                        let _e440 = phi_701_;
                        if _e433 {
                            phi_707_ = _e400[2];
                        } else {
                            phi_707_ = _e440;
                        }
                        let _e443 = phi_707_;
                        let _e445 = ((_e443 * _e379) * _e385);
                        let _e449 = (bitcast<f32>((bitcast<u32>(_e445) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e449 {
                            let _e453 = (bitcast<f32>((bitcast<u32>(_e436) & 2147483647u)) * 0.00000011920929f);
                            phi_730_ = select(0.00000000000011368684f, _e453, (_e453 > 0.00000000000011368684f));
                        } else {
                            phi_730_ = 0f;
                        }
                        let _e457 = phi_730_;
                        let _e458 = (_e436 + _e457);
                        let _e459 = (_e436 - _e457);
                        let _e460 = select(_e445, 0f, _e449);
                        if _e449 {
                            phi_741_ = 38685626000000000000000000f;
                        } else {
                            phi_741_ = (1f / _e445);
                        }
                        let _e463 = phi_741_;
                        let _e464 = (_e368 == 0u);
                        if _e464 {
                            phi_750_ = _e390[0];
                        } else {
                            phi_750_ = _e390[1];
                        }
                        let _e468 = phi_750_;
                        let _e469 = (_e368 == 2u);
                        if _e469 {
                            phi_756_ = _e390[2];
                        } else {
                            phi_756_ = _e468;
                        }
                        let _e472 = phi_756_;
                        if _e464 {
                            phi_767_ = _e400[0];
                        } else {
                            phi_767_ = _e400[1];
                        }
                        let _e476 = phi_767_;
                        if _e469 {
                            phi_773_ = _e400[2];
                        } else {
                            phi_773_ = _e476;
                        }
                        let _e479 = phi_773_;
                        let _e481 = ((_e479 * _e379) * _e385);
                        let _e485 = (bitcast<f32>((bitcast<u32>(_e481) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e485 {
                            let _e489 = (bitcast<f32>((bitcast<u32>(_e472) & 2147483647u)) * 0.00000011920929f);
                            phi_796_ = select(0.00000000000011368684f, _e489, (_e489 > 0.00000000000011368684f));
                        } else {
                            phi_796_ = 0f;
                        }
                        let _e493 = phi_796_;
                        let _e494 = (_e472 + _e493);
                        let _e495 = (_e472 - _e493);
                        let _e496 = select(_e481, 0f, _e485);
                        if _e485 {
                            phi_807_ = 38685626000000000000000000f;
                        } else {
                            phi_807_ = (1f / _e481);
                        }
                        let _e499 = phi_807_;
                        let _e502 = bitcast<f32>((bitcast<u32>(_e399) & 2147483647u));
                        let _e505 = bitcast<f32>((bitcast<u32>(_e436) & 2147483647u));
                        let _e507 = select(_e505, _e502, (_e502 > _e505));
                        let _e510 = bitcast<f32>((bitcast<u32>(_e472) & 2147483647u));
                        if (_e329 && (select(_e510, _e507, (_e507 > _e510)) <= 1099511600000f)) {
                            let _e515 = (_e348 / 3i);
                            let _e522 = bitcast<f32>((bitcast<u32>((_e515 + 127i)) << bitcast<u32>(23i)));
                            let _e529 = bitcast<f32>((bitcast<u32>(((_e348 - (2i * _e515)) + 127i)) << bitcast<u32>(23i)));
                            let _e530 = (((_e240 * _e522) * _e522) * _e529);
                            let _e532 = select(340282350000000000000000000000000000000f, _e530, (_e530 < 340282350000000000000000000000000000000f));
                            let _e537 = (((_e245 * _e522) * _e522) * _e529);
                            let _e539 = select(340282350000000000000000000000000000000f, _e537, (_e537 < 340282350000000000000000000000000000000f));
                            phi_907_ = select(-340282350000000000000000000000000000000f, _e539, (_e539 > -340282350000000000000000000000000000000f));
                            phi_908_ = select(-340282350000000000000000000000000000000f, _e532, (_e532 > -340282350000000000000000000000000000000f));
                        } else {
                            phi_907_ = 0f;
                            phi_908_ = 1f;
                        }
                        let _e543 = phi_907_;
                        let _e545 = phi_908_;
                        local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        let _e549 = (_e367 % 3u);
                        let _e550 = (_e549 < 3u);
                        if _e550 {
                        } else {
                            break;
                        }
                        let _e552 = local_1[_e549];
                        let _e555 = (_e366 % 3u);
                        let _e556 = (_e555 < 3u);
                        if _e556 {
                        } else {
                            break;
                        }
                        let _e558 = local_1[_e555];
                        let _e561 = (_e368 % 3u);
                        let _e562 = (_e561 < 3u);
                        if _e562 {
                        } else {
                            break;
                        }
                        let _e564 = local_1[_e561];
                        if _e550 {
                        } else {
                            break;
                        }
                        let _e569 = local[_e549];
                        if _e556 {
                        } else {
                            break;
                        }
                        let _e573 = local[_e555];
                        if _e562 {
                        } else {
                            break;
                        }
                        let _e577 = local[_e561];
                        phi_3640_ = false;
                        phi_997_ = type_51(_e543, false);
                        phi_1000_ = type_63(type_39(vec4<f32>((f32(_e552) * _e153), (f32(_e558) * _e153), (f32(_e564) * _e153), 0f), vec4<f32>((f32(_e569) * _e153), (f32(_e573) * _e153), (f32(_e577) * _e153), 0f)), select(0u, 2147483648u, (_e95 == 0u)));
                        phi_1002_ = ((3u * _e95) + 1u);
                        phi_1004_ = (_e545 <= _e543);
                        phi_1006_ = 0u;
                        loop {
                            let _e587 = phi_3640_;
                            let _e589 = phi_997_;
                            let _e591 = phi_1000_;
                            let _e593 = phi_1002_;
                            let _e595 = phi_1004_;
                            let _e597 = phi_1006_;
                            local_11 = _e589;
                            if _e595 {
                                phi_1017_ = true;
                            } else {
                                phi_1017_ = (_e597 > 0u);
                            }
                            let _e600 = phi_1017_;
                            if _e600 {
                                let _e601 = (_e593 > 0u);
                                if _e601 {
                                    if _e595 {
                                        phi_1103_ = _e591;
                                        phi_1104_ = _e595;
                                        phi_1105_ = _e597;
                                    } else {
                                        let _e602 = (_e597 - 1u);
                                        let _e603 = (_e602 % 128u);
                                        let _e604 = (_e603 < 128u);
                                        if _e604 {
                                        } else {
                                            phi_3772_ = true;
                                            break;
                                        }
                                        let _e606 = local_7[_e603];
                                        if _e604 {
                                        } else {
                                            phi_3772_ = true;
                                            break;
                                        }
                                        let _e608 = local_6[_e603];
                                        if _e604 {
                                        } else {
                                            phi_3772_ = true;
                                            break;
                                        }
                                        let _e610 = local_5[_e603];
                                        if _e604 {
                                        } else {
                                            phi_3772_ = true;
                                            break;
                                        }
                                        let _e612 = local_4[_e603];
                                        if _e604 {
                                        } else {
                                            phi_3772_ = true;
                                            break;
                                        }
                                        let _e614 = local_3[_e603];
                                        if _e604 {
                                        } else {
                                            phi_3772_ = true;
                                            break;
                                        }
                                        let _e616 = local_2[_e603];
                                        if _e604 {
                                        } else {
                                            phi_3772_ = true;
                                            break;
                                        }
                                        let _e621 = local_8[_e603];
                                        if _e604 {
                                        } else {
                                            phi_3772_ = true;
                                            break;
                                        }
                                        let _e624 = local_9[_e603];
                                        phi_1103_ = type_63(type_39(vec4<f32>(_e606, _e608, _e610, 0f), vec4<f32>(_e612, _e614, _e616, 0f)), _e621);
                                        phi_1104_ = (_e624 <= _e589.member);
                                        phi_1105_ = _e602;
                                    }
                                    let _e628 = phi_1103_;
                                    let _e630 = phi_1104_;
                                    let _e632 = phi_1105_;
                                    if _e630 {
                                        if ((_e628.member_1 & 2147483648u) != 0u) {
                                            phi_1123_ = _e589;
                                            phi_1126_ = type_8(0u, ((_e628.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1076 = phi_1123_;
                                                let _e1078 = phi_1126_;
                                                local_10 = _e1076;
                                                local_12 = _e1076;
                                                if (_e1078.member < _e1078.member_1) {
                                                    phi_1127_ = type_8((_e1078.member + 1u), _e1078.member_1);
                                                    phi_1149_ = type_8(1u, _e1078.member);
                                                } else {
                                                    phi_1127_ = _e1078;
                                                    phi_1149_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1091 = phi_1127_;
                                                let _e1093 = phi_1149_;
                                                let _e1097 = (bitcast<i32>(_e1093.member) != 0i);
                                                if _e1097 {
                                                    let _e1098 = ((_e628.member_1 & 268435455u) + _e1093.member_1);
                                                    let _e1099 = (_e1098 < _e97);
                                                    if _e1099 {
                                                        if _e1099 {
                                                        } else {
                                                            phi_3634_ = true;
                                                            break;
                                                        }
                                                        let _e1103 = global_6.member[_e1098].member_1;
                                                        phi_1170_ = _e1103;
                                                    } else {
                                                        phi_1170_ = 4294967295u;
                                                    }
                                                    let _e1105 = phi_1170_;
                                                    if (_e1098 >= _e97) {
                                                        phi_1259_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e1099 {
                                                        } else {
                                                            phi_3634_ = true;
                                                            break;
                                                        }
                                                        if (_e549 < 9u) {
                                                        } else {
                                                            phi_3634_ = true;
                                                            break;
                                                        }
                                                        let _e1112 = global_6.member[_e1098].member[_e549];
                                                        if (_e555 < 9u) {
                                                        } else {
                                                            phi_3634_ = true;
                                                            break;
                                                        }
                                                        let _e1118 = global_6.member[_e1098].member[_e555];
                                                        if (_e561 < 9u) {
                                                        } else {
                                                            phi_3634_ = true;
                                                            break;
                                                        }
                                                        let _e1124 = global_6.member[_e1098].member[_e561];
                                                        let _e1126 = (3u + _e549);
                                                        if (_e1126 < 9u) {
                                                        } else {
                                                            phi_3634_ = true;
                                                            break;
                                                        }
                                                        let _e1132 = global_6.member[_e1098].member[_e1126];
                                                        let _e1133 = (3u + _e555);
                                                        if (_e1133 < 9u) {
                                                        } else {
                                                            phi_3634_ = true;
                                                            break;
                                                        }
                                                        let _e1139 = global_6.member[_e1098].member[_e1133];
                                                        let _e1140 = (3u + _e561);
                                                        if (_e1140 < 9u) {
                                                        } else {
                                                            phi_3634_ = true;
                                                            break;
                                                        }
                                                        let _e1146 = global_6.member[_e1098].member[_e1140];
                                                        let _e1148 = (6u + _e549);
                                                        if (_e1148 < 9u) {
                                                        } else {
                                                            phi_3634_ = true;
                                                            break;
                                                        }
                                                        let _e1154 = global_6.member[_e1098].member[_e1148];
                                                        let _e1155 = (6u + _e555);
                                                        if (_e1155 < 9u) {
                                                        } else {
                                                            phi_3634_ = true;
                                                            break;
                                                        }
                                                        let _e1161 = global_6.member[_e1098].member[_e1155];
                                                        let _e1162 = (6u + _e561);
                                                        if (_e1162 < 9u) {
                                                        } else {
                                                            phi_3634_ = true;
                                                            break;
                                                        }
                                                        let _e1168 = global_6.member[_e1098].member[_e1162];
                                                        phi_1259_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1112, _e1118, _e1124), array<f32, 3>(_e1132, _e1139, _e1146), array<f32, 3>(_e1154, _e1161, _e1168));
                                                    }
                                                    let _e1172 = phi_1259_;
                                                    let _e1180 = (_e1172[0][2] - _e472);
                                                    let _e1183 = (((_e1172[0][0] - _e399) * _e496) - (_e1180 * _e424));
                                                    let _e1186 = (((_e1172[0][1] - _e436) * _e496) - (_e1180 * _e460));
                                                    let _e1193 = (_e1172[1][2] - _e472);
                                                    let _e1196 = (((_e1172[1][0] - _e399) * _e496) - (_e1193 * _e424));
                                                    let _e1199 = (((_e1172[1][1] - _e436) * _e496) - (_e1193 * _e460));
                                                    let _e1206 = (_e1172[2][2] - _e472);
                                                    let _e1209 = (((_e1172[2][0] - _e399) * _e496) - (_e1206 * _e424));
                                                    let _e1212 = (((_e1172[2][1] - _e436) * _e496) - (_e1206 * _e460));
                                                    let _e1213 = (_e1209 * _e1199);
                                                    let _e1214 = (_e1212 * _e1196);
                                                    let _e1215 = (_e1183 * _e1212);
                                                    let _e1216 = (_e1186 * _e1209);
                                                    let _e1217 = (_e1196 * _e1186);
                                                    let _e1218 = (_e1199 * _e1183);
                                                    let _e1223 = (((_e1213 >= _e1214) && (_e1215 >= _e1216)) && (_e1217 >= _e1218));
                                                    if (_e1223 || (((_e1213 <= _e1214) && (_e1215 <= _e1216)) && (_e1217 <= _e1218))) {
                                                        let _e1230 = select(-1f, 1f, _e1223);
                                                        let _e1232 = ((_e1213 - _e1214) * _e1230);
                                                        let _e1234 = select(0f, _e1232, (_e1232 > 0f));
                                                        let _e1236 = ((_e1215 - _e1216) * _e1230);
                                                        let _e1238 = select(0f, _e1236, (_e1236 > 0f));
                                                        let _e1240 = ((_e1217 - _e1218) * _e1230);
                                                        let _e1242 = select(0f, _e1240, (_e1240 > 0f));
                                                        let _e1244 = ((_e1234 + _e1238) + _e1242);
                                                        if (_e1244 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_1825_ = type_30();
                                                            phi_1826_ = true;
                                                        } else {
                                                            let _e1247 = select(_e1172[1][0], _e1172[0][0], (_e1172[0][0] < _e1172[1][0]));
                                                            let _e1251 = select(_e1172[1][0], _e1172[0][0], (_e1172[0][0] > _e1172[1][0]));
                                                            let _e1255 = select(_e1172[1][1], _e1172[0][1], (_e1172[0][1] < _e1172[1][1]));
                                                            let _e1259 = select(_e1172[1][1], _e1172[0][1], (_e1172[0][1] > _e1172[1][1]));
                                                            let _e1263 = select(_e1172[1][2], _e1172[0][2], (_e1172[0][2] < _e1172[1][2]));
                                                            let _e1267 = select(_e1172[1][2], _e1172[0][2], (_e1172[0][2] > _e1172[1][2]));
                                                            let _e1272 = ((select(_e1172[2][0], _e1247, (_e1247 < _e1172[2][0])) - _e422) * _e427);
                                                            let _e1273 = ((select(_e1172[2][0], _e1251, (_e1251 > _e1172[2][0])) - _e423) * _e427);
                                                            let _e1276 = ((select(_e1172[2][1], _e1255, (_e1255 < _e1172[2][1])) - _e458) * _e463);
                                                            let _e1277 = ((select(_e1172[2][1], _e1259, (_e1259 > _e1172[2][1])) - _e459) * _e463);
                                                            let _e1280 = ((select(_e1172[2][2], _e1263, (_e1263 < _e1172[2][2])) - _e494) * _e499);
                                                            let _e1281 = ((select(_e1172[2][2], _e1267, (_e1267 > _e1172[2][2])) - _e495) * _e499);
                                                            let _e1283 = select(_e1281, _e1280, (_e1280 < _e1281));
                                                            let _e1285 = select(_e1281, _e1280, (_e1280 > _e1281));
                                                            let _e1287 = select(_e1273, _e1272, (_e1272 < _e1273));
                                                            let _e1289 = select(_e1277, _e1276, (_e1276 < _e1277));
                                                            let _e1291 = select(_e1289, _e1287, (_e1287 > _e1289));
                                                            let _e1293 = select(_e1283, _e1291, (_e1291 > _e1283));
                                                            let _e1295 = select(_e1273, _e1272, (_e1272 > _e1273));
                                                            let _e1297 = select(_e1277, _e1276, (_e1276 > _e1277));
                                                            let _e1299 = select(_e1297, _e1295, (_e1295 < _e1297));
                                                            let _e1301 = select(_e1285, _e1299, (_e1299 < _e1285));
                                                            let _e1302 = -(_e1283);
                                                            let _e1308 = select(_e545, _e1293, (_e1293 > _e545));
                                                            if (_e1308 > (_e1301 + (select(_e1302, _e1285, (_e1285 > _e1302)) * 0.0000019073523f))) {
                                                                phi_1820_ = type_30();
                                                                phi_1821_ = true;
                                                            } else {
                                                                let _e1310 = (_e1308 > _e1076.member);
                                                                if _e1310 {
                                                                    phi_1819_ = type_30();
                                                                } else {
                                                                    let _e1314 = (_e1172[1][0] - _e1172[0][0]);
                                                                    let _e1315 = (_e1172[1][1] - _e1172[0][1]);
                                                                    let _e1316 = (_e1172[1][2] - _e1172[0][2]);
                                                                    let _e1317 = vec3<f32>(_e1314, _e1315, _e1316);
                                                                    let _e1318 = (_e1172[2][0] - _e1172[1][0]);
                                                                    let _e1319 = (_e1172[2][1] - _e1172[1][1]);
                                                                    let _e1320 = (_e1172[2][2] - _e1172[1][2]);
                                                                    let _e1321 = vec3<f32>(_e1318, _e1319, _e1320);
                                                                    let _e1322 = (_e1172[0][0] - _e1172[2][0]);
                                                                    let _e1323 = (_e1172[0][1] - _e1172[2][1]);
                                                                    let _e1324 = (_e1172[0][2] - _e1172[2][2]);
                                                                    let _e1325 = vec3<f32>(_e1322, _e1323, _e1324);
                                                                    let _e1328 = bitcast<f32>((bitcast<u32>(_e1314) & 2147483647u));
                                                                    let _e1331 = bitcast<f32>((bitcast<u32>(_e1315) & 2147483647u));
                                                                    let _e1333 = select(_e1331, _e1328, (_e1328 > _e1331));
                                                                    let _e1336 = bitcast<f32>((bitcast<u32>(_e1316) & 2147483647u));
                                                                    let _e1338 = select(_e1336, _e1333, (_e1333 > _e1336));
                                                                    let _e1341 = bitcast<f32>((bitcast<u32>(_e1318) & 2147483647u));
                                                                    let _e1344 = bitcast<f32>((bitcast<u32>(_e1319) & 2147483647u));
                                                                    let _e1346 = select(_e1344, _e1341, (_e1341 > _e1344));
                                                                    let _e1349 = bitcast<f32>((bitcast<u32>(_e1320) & 2147483647u));
                                                                    let _e1351 = select(_e1349, _e1346, (_e1346 > _e1349));
                                                                    let _e1354 = bitcast<f32>((bitcast<u32>(_e1322) & 2147483647u));
                                                                    let _e1357 = bitcast<f32>((bitcast<u32>(_e1323) & 2147483647u));
                                                                    let _e1359 = select(_e1357, _e1354, (_e1354 > _e1357));
                                                                    let _e1362 = bitcast<f32>((bitcast<u32>(_e1324) & 2147483647u));
                                                                    let _e1364 = select(_e1362, _e1359, (_e1359 > _e1362));
                                                                    let _e1366 = select(_e1351, _e1338, (_e1338 > _e1351));
                                                                    let _e1368 = select(_e1364, _e1366, (_e1366 > _e1364));
                                                                    if (_e1338 == _e1368) {
                                                                        phi_1730_ = _e1321;
                                                                        phi_1731_ = _e1325;
                                                                    } else {
                                                                        let _e1371 = vec3((_e1351 == _e1368));
                                                                        phi_1730_ = select(_e1317, _e1325, _e1371);
                                                                        phi_1731_ = select(_e1321, _e1317, _e1371);
                                                                    }
                                                                    let _e1375 = phi_1730_;
                                                                    let _e1377 = phi_1731_;
                                                                    let _e1384 = ((_e1375.y * _e1377.z) - (_e1377.y * _e1375.z));
                                                                    let _e1389 = ((_e1375.z * _e1377.x) - (_e1377.z * _e1375.x));
                                                                    let _e1392 = ((_e1375.x * _e1377.y) - (_e1377.x * _e1375.y));
                                                                    if (_e1234 >= _e1238) {
                                                                        phi_1762_ = select(true, false, (_e1234 >= _e1242));
                                                                    } else {
                                                                        phi_1762_ = true;
                                                                    }
                                                                    let _e1397 = phi_1762_;
                                                                    if _e1397 {
                                                                        phi_1771_ = select(vec3<f32>(_e1172[2][0], _e1172[2][1], _e1172[2][2]), vec3<f32>(_e1172[1][0], _e1172[1][1], _e1172[1][2]), vec3((_e1238 >= _e1242)));
                                                                    } else {
                                                                        phi_1771_ = vec3<f32>(_e1172[0][0], _e1172[0][1], _e1172[0][2]);
                                                                    }
                                                                    let _e1402 = phi_1771_;
                                                                    let _e1419 = ((((_e1384 * (_e1402.x - _e399)) + (_e1389 * (_e1402.y - _e436))) + (_e1392 * (_e1402.z - _e472))) / (((_e1384 * _e424) + (_e1389 * _e460)) + (_e1392 * _e496)));
                                                                    let _e1421 = select(_e1301, _e1419, (_e1419 < _e1301));
                                                                    let _e1423 = select(_e1293, _e1421, (_e1421 > _e1293));
                                                                    if (_e1423 >= _e545) {
                                                                        let _e1425 = (_e1423 <= _e1076.member);
                                                                        if _e1425 {
                                                                            let _e1426 = (1f / _e1244);
                                                                            phi_1811_ = type_30(_e1423, (_e1238 * _e1426), (_e1242 * _e1426), _e1105);
                                                                        } else {
                                                                            phi_1811_ = type_30();
                                                                        }
                                                                        let _e1431 = phi_1811_;
                                                                        phi_1813_ = _e1431;
                                                                        phi_1814_ = select(true, false, _e1425);
                                                                    } else {
                                                                        phi_1813_ = type_30();
                                                                        phi_1814_ = true;
                                                                    }
                                                                    let _e1434 = phi_1813_;
                                                                    let _e1436 = phi_1814_;
                                                                    if _e1436 {
                                                                        phi_1818_ = type_30(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                    } else {
                                                                        phi_1818_ = _e1434;
                                                                    }
                                                                    let _e1438 = phi_1818_;
                                                                    phi_1819_ = _e1438;
                                                                }
                                                                let _e1440 = phi_1819_;
                                                                phi_1820_ = _e1440;
                                                                phi_1821_ = _e1310;
                                                            }
                                                            let _e1442 = phi_1820_;
                                                            let _e1444 = phi_1821_;
                                                            phi_1825_ = _e1442;
                                                            phi_1826_ = _e1444;
                                                        }
                                                        let _e1446 = phi_1825_;
                                                        let _e1448 = phi_1826_;
                                                        phi_1830_ = _e1446;
                                                        phi_1831_ = _e1448;
                                                    } else {
                                                        phi_1830_ = type_30();
                                                        phi_1831_ = true;
                                                    }
                                                    let _e1450 = phi_1830_;
                                                    let _e1452 = phi_1831_;
                                                    if _e1452 {
                                                        phi_1835_ = type_30(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_1835_ = _e1450;
                                                    }
                                                    let _e1454 = phi_1835_;
                                                    if (_e1454.member_3 != 4294967295u) {
                                                        if (_e1105 == _e162) {
                                                            phi_2164_ = false;
                                                        } else {
                                                            let _e1458 = (_e1105 < arrayLength((&global_7.member)));
                                                            if _e1458 {
                                                                if _e1458 {
                                                                } else {
                                                                    phi_3634_ = true;
                                                                    break;
                                                                }
                                                                let _e1460 = global_7.member[_e1105];
                                                                phi_1858_ = _e1460;
                                                            } else {
                                                                phi_1858_ = 4294967295u;
                                                            }
                                                            let _e1462 = phi_1858_;
                                                            let _e1463 = (_e1462 < arrayLength((&global_8.member)));
                                                            if _e1463 {
                                                                if _e1463 {
                                                                } else {
                                                                    phi_3634_ = true;
                                                                    break;
                                                                }
                                                                let _e1465 = global_8.member[_e1462];
                                                                phi_1872_ = _e1465;
                                                            } else {
                                                                phi_1872_ = 0i;
                                                            }
                                                            let _e1467 = phi_1872_;
                                                            let _e1468 = (_e1467 == 0i);
                                                            if _e1468 {
                                                                phi_2163_ = true;
                                                            } else {
                                                                if _e391 {
                                                                    phi_1893_ = vec3<f32>(_e1172[0][0], _e1172[0][1], _e1172[0][2]);
                                                                } else {
                                                                    if (_e367 == 1u) {
                                                                        phi_1892_ = vec3<f32>(_e1172[0][2], _e1172[0][0], _e1172[0][1]);
                                                                    } else {
                                                                        phi_1892_ = vec3<f32>(_e1172[0][1], _e1172[0][2], _e1172[0][0]);
                                                                    }
                                                                    let _e1473 = phi_1892_;
                                                                    phi_1893_ = _e1473;
                                                                }
                                                                let _e1476 = phi_1893_;
                                                                if _e391 {
                                                                    phi_1910_ = vec3<f32>(_e1172[1][0], _e1172[1][1], _e1172[1][2]);
                                                                } else {
                                                                    if (_e367 == 1u) {
                                                                        phi_1909_ = vec3<f32>(_e1172[1][2], _e1172[1][0], _e1172[1][1]);
                                                                    } else {
                                                                        phi_1909_ = vec3<f32>(_e1172[1][1], _e1172[1][2], _e1172[1][0]);
                                                                    }
                                                                    let _e1481 = phi_1909_;
                                                                    phi_1910_ = _e1481;
                                                                }
                                                                let _e1484 = phi_1910_;
                                                                if _e391 {
                                                                    phi_1927_ = vec3<f32>(_e1172[2][0], _e1172[2][1], _e1172[2][2]);
                                                                } else {
                                                                    if (_e367 == 1u) {
                                                                        phi_1926_ = vec3<f32>(_e1172[2][2], _e1172[2][0], _e1172[2][1]);
                                                                    } else {
                                                                        phi_1926_ = vec3<f32>(_e1172[2][1], _e1172[2][2], _e1172[2][0]);
                                                                    }
                                                                    let _e1489 = phi_1926_;
                                                                    phi_1927_ = _e1489;
                                                                }
                                                                let _e1492 = phi_1927_;
                                                                let _e1495 = (_e1484.x - _e1476.x);
                                                                let _e1498 = (_e1484.y - _e1476.y);
                                                                let _e1501 = (_e1484.z - _e1476.z);
                                                                let _e1503 = (_e1492.x - _e1476.x);
                                                                let _e1505 = (_e1492.y - _e1476.y);
                                                                let _e1507 = (_e1492.z - _e1476.z);
                                                                if (_e234.member_1 == 1u) {
                                                                    phi_1963_ = (vec3<f32>(_e234.member[0], _e234.member[1], _e234.member[2]) - _e1476);
                                                                } else {
                                                                    phi_1963_ = vec3<f32>(_e234.member[0], _e234.member[1], _e234.member[2]);
                                                                }
                                                                let _e1522 = phi_1963_;
                                                                let _e1528 = bitcast<f32>((bitcast<u32>((_e1495 * _e1505)) ^ _e234.member_3[0]));
                                                                let _e1532 = bitcast<f32>((bitcast<u32>((_e1498 * _e1503)) ^ _e234.member_3[0]));
                                                                let _e1536 = bitcast<f32>((bitcast<u32>((_e1498 * _e1507)) ^ _e234.member_3[0]));
                                                                let _e1540 = bitcast<f32>((bitcast<u32>((_e1501 * _e1505)) ^ _e234.member_3[0]));
                                                                let _e1544 = bitcast<f32>((bitcast<u32>((_e1501 * _e1503)) ^ _e234.member_3[0]));
                                                                let _e1548 = bitcast<f32>((bitcast<u32>((_e1495 * _e1507)) ^ _e234.member_3[0]));
                                                                let _e1549 = (_e1536 - _e1540);
                                                                let _e1550 = (_e1544 - _e1548);
                                                                let _e1551 = (_e1528 - _e1532);
                                                                let _e1575 = (bitcast<f32>((bitcast<u32>(_e1536) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1540) & 2147483647u)));
                                                                let _e1582 = (bitcast<f32>((bitcast<u32>(_e1544) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1548) & 2147483647u)));
                                                                let _e1589 = (bitcast<f32>((bitcast<u32>(_e1528) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1532) & 2147483647u)));
                                                                if (_e234.member_2 == 0f) {
                                                                    phi_2145_ = 0f;
                                                                } else {
                                                                    let _e1619 = bitcast<f32>((bitcast<u32>(_e1549) & 2147483647u));
                                                                    let _e1622 = bitcast<f32>((bitcast<u32>(_e1550) & 2147483647u));
                                                                    let _e1625 = bitcast<f32>((bitcast<u32>(_e1551) & 2147483647u));
                                                                    let _e1627 = select(_e1625, _e1622, (_e1622 > _e1625));
                                                                    let _e1631 = select(_e1625, _e1622, (_e1622 < _e1625));
                                                                    let _e1635 = select(_e1622, _e1619, (_e1619 < _e1622));
                                                                    let _e1637 = select(_e1622, _e1619, (_e1619 > _e1622));
                                                                    let _e1639 = select(_e1625, _e1637, (_e1637 < _e1625));
                                                                    phi_2145_ = bitcast<f32>((bitcast<u32>((_e234.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1627, _e1619, (_e1619 > _e1627)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1639, _e1635, (_e1635 > _e1639)))) ^ _e234.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1631, _e1619, (_e1619 < _e1631)))) ^ _e234.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1575 + _e1582) + _e1589))) ^ _e234.member_3[0]))) * 1.0000005f)) ^ _e234.member_3[0])))) ^ _e234.member_3[0]));
                                                                }
                                                                let _e1666 = phi_2145_;
                                                                phi_2163_ = (_e1468 || !(((((bitcast<f32>((bitcast<u32>((_e1522.x * _e1549)) ^ _e234.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1522.y * _e1550)) ^ _e234.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1522.z * _e1551)) ^ _e234.member_3[0]))) * f32(-(_e1467))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1522.x) & 2147483647u)) * _e1575)) ^ _e234.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1522.y) & 2147483647u)) * _e1582)) ^ _e234.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1522.z) & 2147483647u)) * _e1589)) ^ _e234.member_3[0]))))) ^ _e234.member_3[0])) + _e1666) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1680 = phi_2163_;
                                                            phi_2164_ = _e1680;
                                                        }
                                                        let _e1682 = phi_2164_;
                                                        if _e1682 {
                                                            phi_2169_ = type_51(_e1076.member, true);
                                                        } else {
                                                            phi_2169_ = _e1076;
                                                        }
                                                        let _e1687 = phi_2169_;
                                                        phi_2170_ = _e1687;
                                                    } else {
                                                        phi_2170_ = _e1076;
                                                    }
                                                    let _e1689 = phi_2170_;
                                                    phi_1124_ = _e1689;
                                                } else {
                                                    phi_1124_ = type_51();
                                                }
                                                let _e1691 = phi_1124_;
                                                continue;
                                                continuing {
                                                    phi_1123_ = _e1691;
                                                    phi_1126_ = _e1091;
                                                    phi_3634_ = _e587;
                                                    break if !(_e1097);
                                                }
                                            }
                                            let _e1694 = phi_3634_;
                                            phi_3772_ = _e1694;
                                            if _e1694 {
                                                break;
                                            }
                                            let _e1696 = local_10;
                                            phi_3776_ = _e1694;
                                            let _e1883 = local_12;
                                            phi_3376_ = _e1883;
                                            phi_3377_ = _e628;
                                            phi_3378_ = false;
                                            phi_3379_ = select(_e632, 0u, _e1696.member_1);
                                        } else {
                                            if (_e628.member_1 >= _e95) {
                                                phi_2932_ = type_64(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_63(type_39(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_63(type_39(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                            } else {
                                                if (_e628.member_1 < _e95) {
                                                } else {
                                                    phi_3772_ = true;
                                                    break;
                                                }
                                                let _e644 = ((1u + _e367) % 4u);
                                                if (_e644 < 4u) {
                                                } else {
                                                    phi_3772_ = true;
                                                    break;
                                                }
                                                let _e649 = global_5.member[_e628.member_1][_e644];
                                                let _e651 = (_e649 >> bitcast<u32>(11u));
                                                let _e653 = ((1u + _e366) % 4u);
                                                if (_e653 < 4u) {
                                                } else {
                                                    phi_3772_ = true;
                                                    break;
                                                }
                                                let _e658 = global_5.member[_e628.member_1][_e653];
                                                let _e660 = (_e658 >> bitcast<u32>(11u));
                                                let _e662 = ((1u + _e368) % 4u);
                                                if (_e662 < 4u) {
                                                } else {
                                                    phi_3772_ = true;
                                                    break;
                                                }
                                                let _e667 = global_5.member[_e628.member_1][_e662];
                                                let _e669 = (_e667 >> bitcast<u32>(11u));
                                                let _e692 = (bitcast<f32>((bitcast<u32>((_e628.member.member_1.x - _e628.member.member.x)) & 2139095040u)) * 0.001953125f);
                                                let _e693 = (bitcast<f32>((bitcast<u32>((_e628.member.member_1.y - _e628.member.member.y)) & 2139095040u)) * 0.001953125f);
                                                let _e694 = (bitcast<f32>((bitcast<u32>((_e628.member.member_1.z - _e628.member.member.z)) & 2139095040u)) * 0.001953125f);
                                                let _e696 = select(_e153, _e692, (_e692 > _e153));
                                                let _e698 = select(_e153, _e693, (_e693 > _e153));
                                                let _e700 = select(_e153, _e694, (_e694 > _e153));
                                                let _e725 = bitcast<u32>((f32(bitcast<i32>((_e649 & 1023u))) * _e696));
                                                let _e730 = (bitcast<i32>((_e649 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e733 = bitcast<f32>((_e725 & bitcast<u32>(_e730)));
                                                let _e734 = bitcast<u32>((f32(bitcast<i32>((_e658 & 1023u))) * _e698));
                                                let _e739 = (bitcast<i32>((_e658 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e742 = bitcast<f32>((_e734 & bitcast<u32>(_e739)));
                                                let _e743 = bitcast<u32>((f32(bitcast<i32>((_e667 & 1023u))) * _e700));
                                                let _e748 = (bitcast<i32>((_e667 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e751 = bitcast<f32>((_e743 & bitcast<u32>(_e748)));
                                                let _e755 = bitcast<f32>((_e725 & bitcast<u32>(~(_e730))));
                                                let _e759 = bitcast<f32>((_e734 & bitcast<u32>(~(_e739))));
                                                let _e763 = bitcast<f32>((_e743 & bitcast<u32>(~(_e748))));
                                                let _e764 = bitcast<u32>((f32(bitcast<i32>((_e651 & 1023u))) * _e696));
                                                let _e769 = (bitcast<i32>((_e651 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e772 = bitcast<f32>((_e764 & bitcast<u32>(_e769)));
                                                let _e773 = bitcast<u32>((f32(bitcast<i32>((_e660 & 1023u))) * _e698));
                                                let _e778 = (bitcast<i32>((_e660 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e781 = bitcast<f32>((_e773 & bitcast<u32>(_e778)));
                                                let _e782 = bitcast<u32>((f32(bitcast<i32>((_e669 & 1023u))) * _e700));
                                                let _e787 = (bitcast<i32>((_e669 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                                let _e790 = bitcast<f32>((_e782 & bitcast<u32>(_e787)));
                                                let _e794 = bitcast<f32>((_e764 & bitcast<u32>(~(_e769))));
                                                let _e798 = bitcast<f32>((_e773 & bitcast<u32>(~(_e778))));
                                                let _e802 = bitcast<f32>((_e782 & bitcast<u32>(~(_e787))));
                                                let _e832 = global_5.member[_e628.member_1][0u];
                                                let _e836 = global_5.member[_e628.member_1][1u];
                                                let _e840 = global_5.member[_e628.member_1][2u];
                                                let _e844 = global_5.member[_e628.member_1][3u];
                                                let _e856 = (((_e836 >> bitcast<u32>(22i)) | ((_e840 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e844 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                                let _e857 = (_e832 & 268435455u);
                                                let _e858 = (_e856 & 268435455u);
                                                let _e861 = ((_e832 >> bitcast<u32>(28u)) & 7u);
                                                let _e869 = ((_e832 >> bitcast<u32>(31i)) | (((_e856 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                                let _e870 = (_e861 != 0u);
                                                if (_e861 == 0u) {
                                                    phi_2894_ = _e857;
                                                } else {
                                                    if (_e861 == 7u) {
                                                        phi_2893_ = 2147483648u;
                                                    } else {
                                                        phi_2893_ = ((2147483648u | (_e861 << bitcast<u32>(28u))) | (_e858 & 268435455u));
                                                    }
                                                    let _e879 = phi_2893_;
                                                    phi_2894_ = _e879;
                                                }
                                                let _e881 = phi_2894_;
                                                if _e870 {
                                                    let _e882 = (_e861 != 7u);
                                                    if _e882 {
                                                        phi_2904_ = (_e858 + _e861);
                                                    } else {
                                                        phi_2904_ = u32();
                                                    }
                                                    let _e885 = phi_2904_;
                                                    phi_2906_ = _e885;
                                                    phi_2907_ = select(true, false, _e882);
                                                } else {
                                                    phi_2906_ = u32();
                                                    phi_2907_ = true;
                                                }
                                                let _e888 = phi_2906_;
                                                let _e890 = phi_2907_;
                                                if (_e869 == 0u) {
                                                    phi_2928_ = (_e857 + select(0u, 1u, !(_e870)));
                                                } else {
                                                    if (_e869 == 7u) {
                                                        phi_2927_ = 2147483648u;
                                                    } else {
                                                        phi_2927_ = ((2147483648u | (_e869 << bitcast<u32>(28u))) | (select(_e888, _e858, _e890) & 268435455u));
                                                    }
                                                    let _e903 = phi_2927_;
                                                    phi_2928_ = _e903;
                                                }
                                                let _e905 = phi_2928_;
                                                phi_2932_ = type_64(array<vec4<f32>, 3>(vec4<f32>((_e628.member.member.x + _e733), (_e628.member.member.x + _e755), (_e628.member.member_1.x - _e772), (_e628.member.member_1.x - _e794)), vec4<f32>((_e628.member.member.y + _e742), (_e628.member.member.y + _e759), (_e628.member.member_1.y - _e781), (_e628.member.member_1.y - _e798)), vec4<f32>((_e628.member.member.z + _e751), (_e628.member.member.z + _e763), (_e628.member.member_1.z - _e790), (_e628.member.member_1.z - _e802))), type_63(type_39((_e628.member.member + vec4<f32>(_e733, _e742, _e751, 0f)), (_e628.member.member_1 - vec4<f32>(_e772, _e781, _e790, 0f))), _e881), type_63(type_39((_e628.member.member + vec4<f32>(_e755, _e759, _e763, 0f)), (_e628.member.member_1 - vec4<f32>(_e794, _e798, _e802, 0f))), _e905));
                                            }
                                            let _e910 = phi_2932_;
                                            let _e922 = ((_e910.member[0].x - _e422) * _e427);
                                            let _e923 = ((_e910.member[0].y - _e422) * _e427);
                                            let _e924 = ((_e910.member[0].z - _e423) * _e427);
                                            let _e925 = ((_e910.member[0].w - _e423) * _e427);
                                            let _e935 = ((_e910.member[1].x - _e458) * _e463);
                                            let _e936 = ((_e910.member[1].y - _e458) * _e463);
                                            let _e937 = ((_e910.member[1].z - _e459) * _e463);
                                            let _e938 = ((_e910.member[1].w - _e459) * _e463);
                                            let _e948 = ((_e910.member[2].x - _e494) * _e499);
                                            let _e949 = ((_e910.member[2].y - _e494) * _e499);
                                            let _e950 = ((_e910.member[2].z - _e495) * _e499);
                                            let _e951 = ((_e910.member[2].w - _e495) * _e499);
                                            let _e953 = select(_e950, _e948, (_e948 < _e950));
                                            let _e955 = select(_e951, _e949, (_e949 < _e951));
                                            let _e957 = select(_e950, _e948, (_e948 > _e950));
                                            let _e959 = select(_e951, _e949, (_e949 > _e951));
                                            let _e961 = select(_e924, _e922, (_e922 < _e924));
                                            let _e963 = select(_e925, _e923, (_e923 < _e925));
                                            let _e965 = select(_e937, _e935, (_e935 < _e937));
                                            let _e967 = select(_e938, _e936, (_e936 < _e938));
                                            let _e969 = select(_e965, _e961, (_e961 > _e965));
                                            let _e971 = select(_e967, _e963, (_e963 > _e967));
                                            let _e973 = select(_e953, _e969, (_e969 > _e953));
                                            let _e975 = select(_e955, _e971, (_e971 > _e955));
                                            let _e977 = select(_e924, _e922, (_e922 > _e924));
                                            let _e979 = select(_e925, _e923, (_e923 > _e925));
                                            let _e981 = select(_e937, _e935, (_e935 > _e937));
                                            let _e983 = select(_e938, _e936, (_e936 > _e938));
                                            let _e985 = select(_e981, _e977, (_e977 < _e981));
                                            let _e987 = select(_e983, _e979, (_e979 < _e983));
                                            let _e992 = -(_e953);
                                            let _e993 = -(_e955);
                                            let _e1000 = (select(_e957, _e985, (_e985 < _e957)) + (select(_e992, _e957, (_e957 > _e992)) * 0.0000019073523f));
                                            let _e1001 = (select(_e959, _e987, (_e987 < _e959)) + (select(_e993, _e959, (_e959 > _e993)) * 0.0000019073523f));
                                            let _e1003 = select(_e545, _e973, (_e973 > _e545));
                                            let _e1005 = select(_e545, _e975, (_e975 > _e545));
                                            let _e1010 = (_e1003 <= select(_e589.member, _e1000, (_e1000 < _e589.member)));
                                            let _e1011 = (_e1005 <= select(_e589.member, _e1001, (_e1001 < _e589.member)));
                                            let _e1012 = (_e1003 <= _e1005);
                                            if _e1010 {
                                                if _e1011 {
                                                    if _e1012 {
                                                        phi_3276_ = _e910.member_2;
                                                    } else {
                                                        phi_3276_ = _e910.member_1;
                                                    }
                                                    let _e1016 = phi_3276_;
                                                    let _e1038 = (_e632 % 128u);
                                                    let _e1039 = (_e1038 < 128u);
                                                    if _e1039 {
                                                    } else {
                                                        phi_3772_ = true;
                                                        break;
                                                    }
                                                    local_8[_e1038] = _e1016.member_1;
                                                    if _e1039 {
                                                    } else {
                                                        phi_3772_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1038] = _e1016.member.member.x;
                                                    if _e1039 {
                                                    } else {
                                                        phi_3772_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1038] = _e1016.member.member.y;
                                                    if _e1039 {
                                                    } else {
                                                        phi_3772_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1038] = _e1016.member.member.z;
                                                    if _e1039 {
                                                    } else {
                                                        phi_3772_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1038] = _e1016.member.member_1.x;
                                                    if _e1039 {
                                                    } else {
                                                        phi_3772_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1038] = _e1016.member.member_1.y;
                                                    if _e1039 {
                                                    } else {
                                                        phi_3772_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1038] = _e1016.member.member_1.z;
                                                    if _e1039 {
                                                    } else {
                                                        phi_3772_ = true;
                                                        break;
                                                    }
                                                    local_9[_e1038] = select(_e1005, _e1003, (_e1003 > _e1005));
                                                    if _e1012 {
                                                        phi_3353_ = _e910.member_1;
                                                    } else {
                                                        phi_3353_ = _e910.member_2;
                                                    }
                                                    let _e1052 = phi_3353_;
                                                    phi_3354_ = _e1052;
                                                    phi_3355_ = (_e632 + 1u);
                                                } else {
                                                    phi_3354_ = type_63();
                                                    phi_3355_ = u32();
                                                }
                                                let _e1054 = phi_3354_;
                                                let _e1056 = phi_3355_;
                                                phi_3357_ = _e1054;
                                                phi_3358_ = _e1056;
                                                phi_3359_ = select(true, false, _e1011);
                                            } else {
                                                phi_3357_ = type_63();
                                                phi_3358_ = u32();
                                                phi_3359_ = true;
                                            }
                                            let _e1059 = phi_3357_;
                                            let _e1061 = phi_3358_;
                                            let _e1063 = phi_3359_;
                                            if _e1063 {
                                                if _e1010 {
                                                    phi_3368_ = _e910.member_1;
                                                } else {
                                                    phi_3368_ = _e910.member_2;
                                                }
                                                let _e1067 = phi_3368_;
                                                phi_3373_ = _e1067;
                                                phi_3374_ = select(_e1011, true, _e1010);
                                            } else {
                                                phi_3373_ = _e1059;
                                                phi_3374_ = _e630;
                                            }
                                            let _e1070 = phi_3373_;
                                            let _e1072 = phi_3374_;
                                            phi_3776_ = _e587;
                                            phi_3376_ = _e589;
                                            phi_3377_ = _e1070;
                                            phi_3378_ = _e1072;
                                            phi_3379_ = select(_e1061, _e632, _e1063);
                                        }
                                        let _e1700 = phi_3776_;
                                        let _e1702 = phi_3376_;
                                        let _e1704 = phi_3377_;
                                        let _e1706 = phi_3378_;
                                        let _e1708 = phi_3379_;
                                        phi_3775_ = _e1700;
                                        phi_3380_ = _e1702;
                                        phi_3381_ = _e1704;
                                        phi_3382_ = (_e593 - 1u);
                                        phi_3383_ = _e1706;
                                        phi_3384_ = _e1708;
                                    } else {
                                        phi_3775_ = _e587;
                                        phi_3380_ = _e589;
                                        phi_3381_ = _e628;
                                        phi_3382_ = _e593;
                                        phi_3383_ = _e630;
                                        phi_3384_ = _e632;
                                    }
                                    let _e1710 = phi_3775_;
                                    let _e1712 = phi_3380_;
                                    let _e1714 = phi_3381_;
                                    let _e1716 = phi_3382_;
                                    let _e1718 = phi_3383_;
                                    let _e1720 = phi_3384_;
                                    phi_3774_ = _e1710;
                                    phi_3385_ = _e1712;
                                    phi_3386_ = _e1714;
                                    phi_3387_ = _e1716;
                                    phi_3388_ = _e1718;
                                    phi_3389_ = _e1720;
                                } else {
                                    phi_3774_ = _e587;
                                    phi_3385_ = type_51();
                                    phi_3386_ = type_63();
                                    phi_3387_ = u32();
                                    phi_3388_ = bool();
                                    phi_3389_ = u32();
                                }
                                let _e1722 = phi_3774_;
                                let _e1724 = phi_3385_;
                                let _e1726 = phi_3386_;
                                let _e1728 = phi_3387_;
                                let _e1730 = phi_3388_;
                                let _e1732 = phi_3389_;
                                phi_3773_ = _e1722;
                                phi_998_ = _e1724;
                                phi_1001_ = _e1726;
                                phi_1003_ = _e1728;
                                phi_1005_ = _e1730;
                                phi_1007_ = _e1732;
                                phi_3390_ = _e601;
                            } else {
                                phi_3773_ = _e587;
                                phi_998_ = type_51();
                                phi_1001_ = type_63();
                                phi_1003_ = u32();
                                phi_1005_ = bool();
                                phi_1007_ = u32();
                                phi_3390_ = false;
                            }
                            let _e1734 = phi_3773_;
                            let _e1736 = phi_998_;
                            let _e1738 = phi_1001_;
                            let _e1740 = phi_1003_;
                            let _e1742 = phi_1005_;
                            let _e1744 = phi_1007_;
                            let _e1746 = phi_3390_;
                            continue;
                            continuing {
                                phi_3640_ = _e1734;
                                phi_997_ = _e1736;
                                phi_1000_ = _e1738;
                                phi_1002_ = _e1740;
                                phi_1004_ = _e1742;
                                phi_1006_ = _e1744;
                                phi_3772_ = _e1734;
                                break if !(_e1746);
                            }
                        }
                        let _e1749 = phi_3772_;
                        if _e1749 {
                            break;
                        }
                        let _e1751 = local_11;
                        if _e1751.member_1 {
                        } else {
                            if _e235 {
                            } else {
                                break;
                            }
                            let _e1755 = global_2.member[_e141];
                            if _e156 {
                            } else {
                                break;
                            }
                            let _e1759 = global_10.member[_e141].member_1;
                            if _e235 {
                            } else {
                                break;
                            }
                            global_2.member[_e141] = type_32(_e1755.member, _e1755.member_1, _e1755.member_2, array<f32, 3>((_e1755.member_3[0] + (_e1759[0] * _e1755.member_1[0])), (_e1755.member_3[1] + (_e1759[1] * _e1755.member_1[1])), (_e1755.member_3[2] + (_e1759[2] * _e1755.member_1[2]))), _e1755.member_4);
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
fn trace_shadows_q10_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
