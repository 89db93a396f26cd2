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

struct type_26 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_28 {
    member: array<type_26>,
}

struct type_30 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_31 {
    member: type_30,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_33 {
    member: array<type_31>,
}

struct type_38 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_40 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_43 {
    member: type_26,
    member_1: f32,
}

struct type_48 {
    member: array<vec4<u32>, 2>,
}

struct type_51 {
    member: array<i32>,
}

struct type_57 {
    member: array<array<u32, 7>>,
}

struct type_62 {
    member: type_38,
    member_1: u32,
}

struct type_63 {
    member: array<vec4<f32>, 3>,
    member_1: type_62,
    member_2: type_62,
}

struct type_68 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_48;
@group(0) @binding(2) 
var<uniform> global_3: type_48;
@group(0) @binding(4) 
var<storage> global_4: type_20;
@group(0) @binding(5) 
var<storage> global_5: type_4;
@group(0) @binding(6) 
var<storage> global_6: type_51;
@group(0) @binding(7) 
var<storage> global_7: type_33;
@group(0) @binding(8) 
var<storage, read_write> global_8: type_28;
@group(0) @binding(9) 
var<storage, read_write> global_9: type_68;
@group(0) @binding(3) 
var<storage> global_10: type_57;

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
    var phi_327_: u32;
    var phi_371_: i32;
    var phi_395_: type_40;
    var phi_501_: i32;
    var phi_502_: i32;
    var phi_512_: bool;
    var phi_522_: u32;
    var phi_523_: u32;
    var phi_525_: bool;
    var phi_530_: u32;
    var phi_562_: i32;
    var phi_580_: f32;
    var phi_586_: f32;
    var phi_597_: f32;
    var phi_603_: f32;
    var phi_626_: f32;
    var phi_637_: f32;
    var phi_646_: f32;
    var phi_652_: f32;
    var phi_663_: f32;
    var phi_669_: f32;
    var phi_692_: f32;
    var phi_703_: f32;
    var phi_712_: f32;
    var phi_718_: f32;
    var phi_729_: f32;
    var phi_735_: f32;
    var phi_758_: f32;
    var phi_769_: f32;
    var phi_869_: f32;
    var phi_870_: f32;
    var phi_3968_: bool;
    var phi_959_: type_43;
    var phi_962_: type_62;
    var phi_964_: u32;
    var phi_966_: bool;
    var phi_968_: u32;
    var phi_979_: bool;
    var phi_1065_: type_62;
    var phi_1066_: bool;
    var phi_1067_: u32;
    var phi_3140_: u32;
    var phi_3141_: u32;
    var phi_3151_: u32;
    var phi_3153_: u32;
    var phi_3154_: bool;
    var phi_3174_: u32;
    var phi_3175_: u32;
    var phi_3179_: type_63;
    var phi_3523_: type_62;
    var phi_3600_: type_62;
    var phi_3601_: type_62;
    var phi_3602_: u32;
    var phi_3604_: type_62;
    var phi_3605_: u32;
    var phi_3606_: bool;
    var phi_3615_: type_62;
    var phi_3620_: type_62;
    var phi_3621_: bool;
    var phi_1085_: type_43;
    var phi_1088_: type_8;
    var phi_1089_: type_8;
    var phi_1111_: type_8;
    var phi_1132_: u32;
    var phi_1221_: array<array<f32, 3>, 3>;
    var phi_1338_: bool;
    var phi_1367_: bool;
    var phi_1768_: f32;
    var phi_1769_: f32;
    var phi_1770_: f32;
    var phi_1771_: f32;
    var phi_1772_: vec3<f32>;
    var phi_1773_: vec3<f32>;
    var phi_1774_: vec3<f32>;
    var phi_1775_: vec3<f32>;
    var phi_1806_: bool;
    var phi_1815_: vec3<f32>;
    var phi_1980_: f32;
    var phi_1982_: f32;
    var phi_1983_: bool;
    var phi_2003_: f32;
    var phi_2004_: f32;
    var phi_2027_: type_26;
    var phi_2029_: type_26;
    var phi_2030_: bool;
    var phi_2034_: type_26;
    var phi_2035_: type_26;
    var phi_2036_: type_26;
    var phi_2037_: bool;
    var phi_2041_: type_26;
    var phi_2042_: bool;
    var phi_2043_: type_26;
    var phi_2044_: bool;
    var phi_2045_: bool;
    var phi_2046_: type_26;
    var phi_2047_: bool;
    var phi_2048_: bool;
    var phi_2056_: type_26;
    var phi_2057_: bool;
    var phi_2061_: type_26;
    var phi_2084_: u32;
    var phi_2098_: i32;
    var phi_2118_: vec3<f32>;
    var phi_2119_: vec3<f32>;
    var phi_2135_: vec3<f32>;
    var phi_2136_: vec3<f32>;
    var phi_2152_: vec3<f32>;
    var phi_2153_: vec3<f32>;
    var phi_2189_: vec3<f32>;
    var phi_2371_: f32;
    var phi_2389_: bool;
    var phi_2390_: bool;
    var phi_2409_: bool;
    var phi_2410_: bool;
    var phi_2416_: type_43;
    var phi_2417_: type_43;
    var phi_2418_: type_43;
    var phi_1086_: type_43;
    var phi_3962_: bool;
    var phi_4132_: bool;
    var phi_3623_: type_43;
    var phi_3624_: type_62;
    var phi_3625_: bool;
    var phi_3626_: u32;
    var phi_4131_: bool;
    var phi_3627_: type_43;
    var phi_3628_: type_62;
    var phi_3629_: u32;
    var phi_3630_: bool;
    var phi_3631_: u32;
    var phi_4130_: bool;
    var phi_3632_: type_43;
    var phi_3633_: type_62;
    var phi_3634_: u32;
    var phi_3635_: bool;
    var phi_3636_: u32;
    var phi_4129_: bool;
    var phi_960_: type_43;
    var phi_963_: type_62;
    var phi_965_: u32;
    var phi_967_: bool;
    var phi_969_: u32;
    var phi_3637_: bool;
    var phi_4128_: bool;
    var local_10: type_43;
    var phi_3689_: type_26;
    var local_11: type_43;

    switch bitcast<i32>(0u) {
        default: {
            let _e94 = global;
            let _e96 = arrayLength((&global_10.member));
            let _e98 = arrayLength((&global_4.member));
            let _e110 = arrayLength((&global_9.member));
            let _e114 = global_3.member[0u][0u];
            let _e118 = global_3.member[0u][1u];
            let _e122 = global_3.member[0u][2u];
            let _e126 = global_3.member[0u][3u];
            let _e130 = global_3.member[1u][0u];
            let _e134 = global_3.member[1u][1u];
            let _e138 = global_3.member[1u][2u];
            let _e142 = (_e94.x + (_e94.y * 2097152u));
            let _e154 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e126) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e114), bitcast<i32>(_e118), bitcast<i32>(_e122));
            local = array<i32, 3>(bitcast<i32>(_e130), bitcast<i32>(_e134), bitcast<i32>(_e138));
            let _e157 = (_e142 < arrayLength((&global_7.member)));
            if _e157 {
                if _e157 {
                } else {
                    break;
                }
                let _e161 = global_7.member[_e142].member_2;
                phi_327_ = _e161;
            } else {
                phi_327_ = 4294967295u;
            }
            let _e163 = phi_327_;
            let _e166 = global_1.member[0u];
            let _e170 = global_2.member[0u][0u];
            let _e174 = global_2.member[0u][1u];
            let _e178 = global_2.member[0u][2u];
            let _e182 = global_2.member[0u][3u];
            let _e186 = global_2.member[1u][0u];
            let _e190 = global_2.member[1u][1u];
            let _e194 = global_2.member[1u][2u];
            let _e198 = global_2.member[1u][3u];
            let _e199 = bitcast<f32>(_e170);
            let _e200 = bitcast<f32>(_e174);
            let _e201 = bitcast<f32>(_e178);
            let _e203 = bitcast<f32>(_e186);
            let _e204 = array<u32, 3>(_e190, _e194, _e198);
            let _e206 = bitcast<i32>(_e166);
            if (_e206 < -126i) {
                phi_371_ = -126i;
            } else {
                phi_371_ = select(_e206, 127i, (_e206 > 127i));
            }
            let _e211 = phi_371_;
            let _e216 = bitcast<f32>((bitcast<u32>((_e211 + 127i)) << bitcast<u32>(23i)));
            let _e222 = bitcast<f32>((bitcast<u32>(((_e206 - _e211) + 127i)) << bitcast<u32>(23i)));
            if (_e182 == 0u) {
                phi_395_ = type_40(array<f32, 3>(_e199, _e200, _e201), _e182, _e203, _e204);
            } else {
                phi_395_ = type_40(array<f32, 3>(((_e199 * _e216) * _e222), ((_e200 * _e216) * _e222), ((_e201 * _e216) * _e222)), _e182, ((_e203 * _e216) * _e222), _e204);
            }
            let _e235 = phi_395_;
            if _e157 {
                let _e236 = (_e142 < arrayLength((&global_8.member)));
                if _e236 {
                    if _e157 {
                    } else {
                        break;
                    }
                    let _e246 = global_7.member[_e142].member.member_2[0u];
                    let _e248 = (bitcast<u32>(_e246) & 2147483647u);
                    let _e254 = global_7.member[_e142].member.member_2[1u];
                    let _e256 = (bitcast<u32>(_e254) & 2147483647u);
                    let _e262 = global_7.member[_e142].member.member_2[2u];
                    let _e264 = (bitcast<u32>(_e262) & 2147483647u);
                    let _e270 = global_7.member[_e142].member.member[0u];
                    let _e272 = (bitcast<u32>(_e270) & 2147483647u);
                    let _e278 = global_7.member[_e142].member.member[1u];
                    let _e280 = (bitcast<u32>(_e278) & 2147483647u);
                    let _e286 = global_7.member[_e142].member.member[2u];
                    let _e288 = (bitcast<u32>(_e286) & 2147483647u);
                    let _e290 = select(_e256, _e248, (_e256 < _e248));
                    let _e292 = select(_e264, _e290, (_e264 < _e290));
                    let _e294 = select(_e272, _e292, (_e272 < _e292));
                    let _e296 = select(_e280, _e294, (_e280 < _e294));
                    let _e298 = select(_e288, _e296, (_e288 < _e296));
                    let _e303 = global_7.member[_e142].member.member_1;
                    let _e305 = (bitcast<u32>(_e303) & 2147483647u);
                    let _e313 = global_7.member[_e142].member.member_3;
                    let _e319 = (((select(_e305, _e298, (_e305 < _e298)) < 2139095040u) && ((bitcast<u32>(_e313) & 2147483647u) <= 2139095040u)) && (_e292 > 0u));
                    if _e319 {
                        let _e322 = (bitcast<u32>(bitcast<f32>(_e292)) & 2147483647u);
                        if (_e322 >= 8388608u) {
                            phi_501_ = (bitcast<i32>((_e322 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_501_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e322)), 32u, (_e322 == 0u))));
                        }
                        let _e336 = phi_501_;
                        phi_502_ = _e336;
                    } else {
                        phi_502_ = 0i;
                    }
                    let _e338 = phi_502_;
                    let _e339 = (_e248 == _e292);
                    if _e339 {
                        phi_512_ = true;
                    } else {
                        phi_512_ = (_e256 == _e292);
                    }
                    let _e342 = phi_512_;
                    let _e343 = select(1u, 0u, _e339);
                    if _e342 {
                        let _e344 = (_e343 + 1u);
                        phi_522_ = _e344;
                        phi_523_ = _e344;
                        phi_525_ = select(true, false, (_e344 == 2u));
                    } else {
                        phi_522_ = u32();
                        phi_523_ = 0u;
                        phi_525_ = true;
                    }
                    let _e348 = phi_522_;
                    let _e350 = phi_523_;
                    let _e352 = phi_525_;
                    if _e352 {
                        phi_530_ = (_e350 + 1u);
                    } else {
                        phi_530_ = 0u;
                    }
                    let _e356 = phi_530_;
                    let _e357 = select(_e348, _e350, _e352);
                    let _e358 = select(_e343, select(2u, _e343, _e342), _e352);
                    let _e359 = -(_e338);
                    if (_e359 < -126i) {
                        phi_562_ = -126i;
                    } else {
                        phi_562_ = select(_e359, 127i, (_e359 > 127i));
                    }
                    let _e364 = phi_562_;
                    let _e369 = bitcast<f32>((bitcast<u32>((_e364 + 127i)) << bitcast<u32>(23i)));
                    let _e375 = bitcast<f32>((bitcast<u32>(((_e359 - _e364) + 127i)) << bitcast<u32>(23i)));
                    let _e380 = global_7.member[_e142].member.member;
                    let _e381 = (_e357 == 0u);
                    if _e381 {
                        phi_580_ = _e380[0];
                    } else {
                        phi_580_ = _e380[1];
                    }
                    let _e385 = phi_580_;
                    let _e386 = (_e357 == 2u);
                    if _e386 {
                        phi_586_ = _e380[2];
                    } else {
                        phi_586_ = _e385;
                    }
                    let _e389 = phi_586_;
                    let _e390 = global_7.member[_e142].member.member_2;
                    if _e381 {
                        phi_597_ = _e390[0];
                    } else {
                        phi_597_ = _e390[1];
                    }
                    let _e394 = phi_597_;
                    if _e386 {
                        phi_603_ = _e390[2];
                    } else {
                        phi_603_ = _e394;
                    }
                    let _e397 = phi_603_;
                    let _e399 = ((_e397 * _e369) * _e375);
                    let _e403 = (bitcast<f32>((bitcast<u32>(_e399) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e403 {
                        let _e407 = (bitcast<f32>((bitcast<u32>(_e389) & 2147483647u)) * 0.00000011920929f);
                        phi_626_ = select(0.00000000000011368684f, _e407, (_e407 > 0.00000000000011368684f));
                    } else {
                        phi_626_ = 0f;
                    }
                    let _e411 = phi_626_;
                    let _e412 = (_e389 + _e411);
                    let _e413 = (_e389 - _e411);
                    let _e414 = select(_e399, 0f, _e403);
                    if _e403 {
                        phi_637_ = 38685626000000000000000000f;
                    } else {
                        phi_637_ = (1f / _e399);
                    }
                    let _e417 = phi_637_;
                    let _e418 = (_e356 == 0u);
                    if _e418 {
                        phi_646_ = _e380[0];
                    } else {
                        phi_646_ = _e380[1];
                    }
                    let _e422 = phi_646_;
                    let _e423 = (_e356 == 2u);
                    if _e423 {
                        phi_652_ = _e380[2];
                    } else {
                        phi_652_ = _e422;
                    }
                    let _e426 = phi_652_;
                    if _e418 {
                        phi_663_ = _e390[0];
                    } else {
                        phi_663_ = _e390[1];
                    }
                    let _e430 = phi_663_;
                    if _e423 {
                        phi_669_ = _e390[2];
                    } else {
                        phi_669_ = _e430;
                    }
                    let _e433 = phi_669_;
                    let _e435 = ((_e433 * _e369) * _e375);
                    let _e439 = (bitcast<f32>((bitcast<u32>(_e435) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e439 {
                        let _e443 = (bitcast<f32>((bitcast<u32>(_e426) & 2147483647u)) * 0.00000011920929f);
                        phi_692_ = select(0.00000000000011368684f, _e443, (_e443 > 0.00000000000011368684f));
                    } else {
                        phi_692_ = 0f;
                    }
                    let _e447 = phi_692_;
                    let _e448 = (_e426 + _e447);
                    let _e449 = (_e426 - _e447);
                    let _e450 = select(_e435, 0f, _e439);
                    if _e439 {
                        phi_703_ = 38685626000000000000000000f;
                    } else {
                        phi_703_ = (1f / _e435);
                    }
                    let _e453 = phi_703_;
                    let _e454 = (_e358 == 0u);
                    if _e454 {
                        phi_712_ = _e380[0];
                    } else {
                        phi_712_ = _e380[1];
                    }
                    let _e458 = phi_712_;
                    let _e459 = (_e358 == 2u);
                    if _e459 {
                        phi_718_ = _e380[2];
                    } else {
                        phi_718_ = _e458;
                    }
                    let _e462 = phi_718_;
                    if _e454 {
                        phi_729_ = _e390[0];
                    } else {
                        phi_729_ = _e390[1];
                    }
                    let _e466 = phi_729_;
                    if _e459 {
                        phi_735_ = _e390[2];
                    } else {
                        phi_735_ = _e466;
                    }
                    let _e469 = phi_735_;
                    let _e471 = ((_e469 * _e369) * _e375);
                    let _e475 = (bitcast<f32>((bitcast<u32>(_e471) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e475 {
                        let _e479 = (bitcast<f32>((bitcast<u32>(_e462) & 2147483647u)) * 0.00000011920929f);
                        phi_758_ = select(0.00000000000011368684f, _e479, (_e479 > 0.00000000000011368684f));
                    } else {
                        phi_758_ = 0f;
                    }
                    let _e483 = phi_758_;
                    let _e484 = (_e462 + _e483);
                    let _e485 = (_e462 - _e483);
                    let _e486 = select(_e471, 0f, _e475);
                    if _e475 {
                        phi_769_ = 38685626000000000000000000f;
                    } else {
                        phi_769_ = (1f / _e471);
                    }
                    let _e489 = phi_769_;
                    let _e492 = bitcast<f32>((bitcast<u32>(_e389) & 2147483647u));
                    let _e495 = bitcast<f32>((bitcast<u32>(_e426) & 2147483647u));
                    let _e497 = select(_e495, _e492, (_e492 > _e495));
                    let _e500 = bitcast<f32>((bitcast<u32>(_e462) & 2147483647u));
                    if (_e319 && (select(_e500, _e497, (_e497 > _e500)) <= 1099511600000f)) {
                        let _e505 = (_e338 / 3i);
                        let _e512 = bitcast<f32>((bitcast<u32>((_e505 + 127i)) << bitcast<u32>(23i)));
                        let _e519 = bitcast<f32>((bitcast<u32>(((_e338 - (2i * _e505)) + 127i)) << bitcast<u32>(23i)));
                        let _e520 = (((_e303 * _e512) * _e512) * _e519);
                        let _e522 = select(340282350000000000000000000000000000000f, _e520, (_e520 < 340282350000000000000000000000000000000f));
                        let _e527 = (((_e313 * _e512) * _e512) * _e519);
                        let _e529 = select(340282350000000000000000000000000000000f, _e527, (_e527 < 340282350000000000000000000000000000000f));
                        phi_869_ = select(-340282350000000000000000000000000000000f, _e529, (_e529 > -340282350000000000000000000000000000000f));
                        phi_870_ = select(-340282350000000000000000000000000000000f, _e522, (_e522 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_869_ = 0f;
                        phi_870_ = 1f;
                    }
                    let _e533 = phi_869_;
                    let _e535 = phi_870_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e539 = (_e357 % 3u);
                    let _e540 = (_e539 < 3u);
                    if _e540 {
                    } else {
                        break;
                    }
                    let _e542 = local_1[_e539];
                    let _e545 = (_e356 % 3u);
                    let _e546 = (_e545 < 3u);
                    if _e546 {
                    } else {
                        break;
                    }
                    let _e548 = local_1[_e545];
                    let _e551 = (_e358 % 3u);
                    let _e552 = (_e551 < 3u);
                    if _e552 {
                    } else {
                        break;
                    }
                    let _e554 = local_1[_e551];
                    if _e540 {
                    } else {
                        break;
                    }
                    let _e559 = local[_e539];
                    if _e546 {
                    } else {
                        break;
                    }
                    let _e563 = local[_e545];
                    if _e552 {
                    } else {
                        break;
                    }
                    let _e567 = local[_e551];
                    phi_3968_ = false;
                    phi_959_ = type_43(type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e533);
                    phi_962_ = type_62(type_38(vec4<f32>((f32(_e542) * _e154), (f32(_e548) * _e154), (f32(_e554) * _e154), 0f), vec4<f32>((f32(_e559) * _e154), (f32(_e563) * _e154), (f32(_e567) * _e154), 0f)), select(0u, 2147483648u, (_e96 == 0u)));
                    phi_964_ = ((3u * _e96) + 1u);
                    phi_966_ = (_e535 <= _e533);
                    phi_968_ = 0u;
                    loop {
                        let _e577 = phi_3968_;
                        let _e579 = phi_959_;
                        let _e581 = phi_962_;
                        let _e583 = phi_964_;
                        let _e585 = phi_966_;
                        let _e587 = phi_968_;
                        local_10 = _e579;
                        if _e585 {
                            phi_979_ = true;
                        } else {
                            phi_979_ = (_e587 > 0u);
                        }
                        let _e590 = phi_979_;
                        if _e590 {
                            let _e591 = (_e583 > 0u);
                            if _e591 {
                                if _e585 {
                                    phi_1065_ = _e581;
                                    phi_1066_ = _e585;
                                    phi_1067_ = _e587;
                                } else {
                                    let _e592 = (_e587 - 1u);
                                    let _e593 = (_e592 % 128u);
                                    let _e594 = (_e593 < 128u);
                                    if _e594 {
                                    } else {
                                        phi_4128_ = true;
                                        break;
                                    }
                                    let _e596 = local_7[_e593];
                                    if _e594 {
                                    } else {
                                        phi_4128_ = true;
                                        break;
                                    }
                                    let _e598 = local_6[_e593];
                                    if _e594 {
                                    } else {
                                        phi_4128_ = true;
                                        break;
                                    }
                                    let _e600 = local_5[_e593];
                                    if _e594 {
                                    } else {
                                        phi_4128_ = true;
                                        break;
                                    }
                                    let _e602 = local_4[_e593];
                                    if _e594 {
                                    } else {
                                        phi_4128_ = true;
                                        break;
                                    }
                                    let _e604 = local_3[_e593];
                                    if _e594 {
                                    } else {
                                        phi_4128_ = true;
                                        break;
                                    }
                                    let _e606 = local_2[_e593];
                                    if _e594 {
                                    } else {
                                        phi_4128_ = true;
                                        break;
                                    }
                                    let _e611 = local_8[_e593];
                                    if _e594 {
                                    } else {
                                        phi_4128_ = true;
                                        break;
                                    }
                                    let _e614 = local_9[_e593];
                                    phi_1065_ = type_62(type_38(vec4<f32>(_e596, _e598, _e600, 0f), vec4<f32>(_e602, _e604, _e606, 0f)), _e611);
                                    phi_1066_ = (_e614 <= _e579.member_1);
                                    phi_1067_ = _e592;
                                }
                                let _e618 = phi_1065_;
                                let _e620 = phi_1066_;
                                let _e622 = phi_1067_;
                                if _e620 {
                                    if ((_e618.member_1 & 2147483648u) != 0u) {
                                        phi_1085_ = _e579;
                                        phi_1088_ = type_8(0u, ((_e618.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1084 = phi_1085_;
                                            let _e1086 = phi_1088_;
                                            local_11 = _e1084;
                                            if (_e1086.member < _e1086.member_1) {
                                                phi_1089_ = type_8((_e1086.member + 1u), _e1086.member_1);
                                                phi_1111_ = type_8(1u, _e1086.member);
                                            } else {
                                                phi_1089_ = _e1086;
                                                phi_1111_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1099 = phi_1089_;
                                            let _e1101 = phi_1111_;
                                            let _e1105 = (bitcast<i32>(_e1101.member) != 0i);
                                            if _e1105 {
                                                let _e1106 = ((_e618.member_1 & 268435455u) + _e1101.member_1);
                                                let _e1107 = (_e1106 < _e98);
                                                if _e1107 {
                                                    if _e1107 {
                                                    } else {
                                                        phi_3962_ = true;
                                                        break;
                                                    }
                                                    let _e1111 = global_4.member[_e1106].member_1;
                                                    phi_1132_ = _e1111;
                                                } else {
                                                    phi_1132_ = 4294967295u;
                                                }
                                                let _e1113 = phi_1132_;
                                                if (_e1106 >= _e98) {
                                                    phi_1221_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1107 {
                                                    } else {
                                                        phi_3962_ = true;
                                                        break;
                                                    }
                                                    if (_e539 < 9u) {
                                                    } else {
                                                        phi_3962_ = true;
                                                        break;
                                                    }
                                                    let _e1120 = global_4.member[_e1106].member[_e539];
                                                    if (_e545 < 9u) {
                                                    } else {
                                                        phi_3962_ = true;
                                                        break;
                                                    }
                                                    let _e1126 = global_4.member[_e1106].member[_e545];
                                                    if (_e551 < 9u) {
                                                    } else {
                                                        phi_3962_ = true;
                                                        break;
                                                    }
                                                    let _e1132 = global_4.member[_e1106].member[_e551];
                                                    let _e1134 = (3u + _e539);
                                                    if (_e1134 < 9u) {
                                                    } else {
                                                        phi_3962_ = true;
                                                        break;
                                                    }
                                                    let _e1140 = global_4.member[_e1106].member[_e1134];
                                                    let _e1141 = (3u + _e545);
                                                    if (_e1141 < 9u) {
                                                    } else {
                                                        phi_3962_ = true;
                                                        break;
                                                    }
                                                    let _e1147 = global_4.member[_e1106].member[_e1141];
                                                    let _e1148 = (3u + _e551);
                                                    if (_e1148 < 9u) {
                                                    } else {
                                                        phi_3962_ = true;
                                                        break;
                                                    }
                                                    let _e1154 = global_4.member[_e1106].member[_e1148];
                                                    let _e1156 = (6u + _e539);
                                                    if (_e1156 < 9u) {
                                                    } else {
                                                        phi_3962_ = true;
                                                        break;
                                                    }
                                                    let _e1162 = global_4.member[_e1106].member[_e1156];
                                                    let _e1163 = (6u + _e545);
                                                    if (_e1163 < 9u) {
                                                    } else {
                                                        phi_3962_ = true;
                                                        break;
                                                    }
                                                    let _e1169 = global_4.member[_e1106].member[_e1163];
                                                    let _e1170 = (6u + _e551);
                                                    if (_e1170 < 9u) {
                                                    } else {
                                                        phi_3962_ = true;
                                                        break;
                                                    }
                                                    let _e1176 = global_4.member[_e1106].member[_e1170];
                                                    phi_1221_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1120, _e1126, _e1132), array<f32, 3>(_e1140, _e1147, _e1154), array<f32, 3>(_e1162, _e1169, _e1176));
                                                }
                                                let _e1180 = phi_1221_;
                                                let _e1188 = (_e1180[0][2] - _e462);
                                                let _e1191 = (((_e1180[0][0] - _e389) * _e486) - (_e1188 * _e414));
                                                let _e1194 = (((_e1180[0][1] - _e426) * _e486) - (_e1188 * _e450));
                                                let _e1201 = (_e1180[1][2] - _e462);
                                                let _e1204 = (((_e1180[1][0] - _e389) * _e486) - (_e1201 * _e414));
                                                let _e1207 = (((_e1180[1][1] - _e426) * _e486) - (_e1201 * _e450));
                                                let _e1214 = (_e1180[2][2] - _e462);
                                                let _e1217 = (((_e1180[2][0] - _e389) * _e486) - (_e1214 * _e414));
                                                let _e1220 = (((_e1180[2][1] - _e426) * _e486) - (_e1214 * _e450));
                                                let _e1221 = (_e1217 * _e1207);
                                                let _e1222 = (_e1220 * _e1204);
                                                let _e1223 = (_e1191 * _e1220);
                                                let _e1224 = (_e1194 * _e1217);
                                                let _e1225 = (_e1204 * _e1194);
                                                let _e1226 = (_e1207 * _e1191);
                                                let _e1231 = (((_e1221 >= _e1222) && (_e1223 >= _e1224)) && (_e1225 >= _e1226));
                                                if (_e1231 || (((_e1221 <= _e1222) && (_e1223 <= _e1224)) && (_e1225 <= _e1226))) {
                                                    let _e1238 = select(-1f, 1f, _e1231);
                                                    let _e1240 = ((_e1221 - _e1222) * _e1238);
                                                    let _e1242 = select(0f, _e1240, (_e1240 > 0f));
                                                    let _e1244 = ((_e1223 - _e1224) * _e1238);
                                                    let _e1246 = select(0f, _e1244, (_e1244 > 0f));
                                                    let _e1248 = ((_e1225 - _e1226) * _e1238);
                                                    let _e1250 = select(0f, _e1248, (_e1248 > 0f));
                                                    let _e1252 = ((_e1242 + _e1246) + _e1250);
                                                    if (_e1252 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2046_ = type_26();
                                                        phi_2047_ = true;
                                                        phi_2048_ = false;
                                                    } else {
                                                        let _e1255 = select(_e1204, _e1191, (_e1191 < _e1204));
                                                        if (select(_e1217, _e1255, (_e1255 < _e1217)) > 0f) {
                                                            phi_1338_ = true;
                                                        } else {
                                                            let _e1260 = select(_e1204, _e1191, (_e1191 > _e1204));
                                                            phi_1338_ = (select(_e1217, _e1260, (_e1260 > _e1217)) < 0f);
                                                        }
                                                        let _e1265 = phi_1338_;
                                                        if _e1265 {
                                                            phi_2043_ = type_26();
                                                            phi_2044_ = true;
                                                            phi_2045_ = false;
                                                        } else {
                                                            let _e1267 = select(_e1207, _e1194, (_e1194 < _e1207));
                                                            if (select(_e1220, _e1267, (_e1267 < _e1220)) > 0f) {
                                                                phi_1367_ = true;
                                                            } else {
                                                                let _e1272 = select(_e1207, _e1194, (_e1194 > _e1207));
                                                                phi_1367_ = (select(_e1220, _e1272, (_e1272 > _e1220)) < 0f);
                                                            }
                                                            let _e1277 = phi_1367_;
                                                            if _e1277 {
                                                                phi_2041_ = type_26();
                                                                phi_2042_ = false;
                                                            } else {
                                                                let _e1279 = select(_e1180[1][0], _e1180[0][0], (_e1180[0][0] < _e1180[1][0]));
                                                                let _e1283 = select(_e1180[1][0], _e1180[0][0], (_e1180[0][0] > _e1180[1][0]));
                                                                let _e1287 = select(_e1180[1][1], _e1180[0][1], (_e1180[0][1] < _e1180[1][1]));
                                                                let _e1291 = select(_e1180[1][1], _e1180[0][1], (_e1180[0][1] > _e1180[1][1]));
                                                                let _e1295 = select(_e1180[1][2], _e1180[0][2], (_e1180[0][2] < _e1180[1][2]));
                                                                let _e1299 = select(_e1180[1][2], _e1180[0][2], (_e1180[0][2] > _e1180[1][2]));
                                                                let _e1304 = ((select(_e1180[2][0], _e1279, (_e1279 < _e1180[2][0])) - _e412) * _e417);
                                                                let _e1305 = ((select(_e1180[2][0], _e1283, (_e1283 > _e1180[2][0])) - _e413) * _e417);
                                                                let _e1308 = ((select(_e1180[2][1], _e1287, (_e1287 < _e1180[2][1])) - _e448) * _e453);
                                                                let _e1309 = ((select(_e1180[2][1], _e1291, (_e1291 > _e1180[2][1])) - _e449) * _e453);
                                                                let _e1312 = ((select(_e1180[2][2], _e1295, (_e1295 < _e1180[2][2])) - _e484) * _e489);
                                                                let _e1313 = ((select(_e1180[2][2], _e1299, (_e1299 > _e1180[2][2])) - _e485) * _e489);
                                                                let _e1315 = select(_e1313, _e1312, (_e1312 < _e1313));
                                                                let _e1317 = select(_e1313, _e1312, (_e1312 > _e1313));
                                                                let _e1319 = select(_e1305, _e1304, (_e1304 < _e1305));
                                                                let _e1321 = select(_e1309, _e1308, (_e1308 < _e1309));
                                                                let _e1323 = select(_e1321, _e1319, (_e1319 > _e1321));
                                                                let _e1325 = select(_e1315, _e1323, (_e1323 > _e1315));
                                                                let _e1327 = select(_e1305, _e1304, (_e1304 > _e1305));
                                                                let _e1329 = select(_e1309, _e1308, (_e1308 > _e1309));
                                                                let _e1331 = select(_e1329, _e1327, (_e1327 < _e1329));
                                                                let _e1333 = select(_e1317, _e1331, (_e1331 < _e1317));
                                                                let _e1334 = -(_e1315);
                                                                let _e1340 = select(_e535, _e1325, (_e1325 > _e535));
                                                                if (_e1340 > (_e1333 + (select(_e1334, _e1317, (_e1317 > _e1334)) * 0.0000019073523f))) {
                                                                    phi_2036_ = type_26();
                                                                    phi_2037_ = true;
                                                                } else {
                                                                    let _e1342 = (_e1340 > _e1084.member_1);
                                                                    if _e1342 {
                                                                        phi_2035_ = type_26();
                                                                    } else {
                                                                        let _e1343 = vec3<f32>(_e1180[0][0], _e1180[0][1], _e1180[0][2]);
                                                                        let _e1344 = vec3<f32>(_e1180[1][0], _e1180[1][1], _e1180[1][2]);
                                                                        let _e1345 = vec3<f32>(_e1180[2][0], _e1180[2][1], _e1180[2][2]);
                                                                        let _e1346 = (_e1180[1][0] - _e1180[0][0]);
                                                                        let _e1347 = (_e1180[1][1] - _e1180[0][1]);
                                                                        let _e1348 = (_e1180[1][2] - _e1180[0][2]);
                                                                        let _e1349 = vec3<f32>(_e1346, _e1347, _e1348);
                                                                        let _e1350 = (_e1180[2][0] - _e1180[1][0]);
                                                                        let _e1351 = (_e1180[2][1] - _e1180[1][1]);
                                                                        let _e1352 = (_e1180[2][2] - _e1180[1][2]);
                                                                        let _e1353 = vec3<f32>(_e1350, _e1351, _e1352);
                                                                        let _e1354 = (_e1180[0][0] - _e1180[2][0]);
                                                                        let _e1355 = (_e1180[0][1] - _e1180[2][1]);
                                                                        let _e1356 = (_e1180[0][2] - _e1180[2][2]);
                                                                        let _e1357 = vec3<f32>(_e1354, _e1355, _e1356);
                                                                        let _e1360 = bitcast<f32>((bitcast<u32>(_e1346) & 2147483647u));
                                                                        let _e1363 = bitcast<f32>((bitcast<u32>(_e1347) & 2147483647u));
                                                                        let _e1365 = select(_e1363, _e1360, (_e1360 > _e1363));
                                                                        let _e1368 = bitcast<f32>((bitcast<u32>(_e1348) & 2147483647u));
                                                                        let _e1370 = select(_e1368, _e1365, (_e1365 > _e1368));
                                                                        let _e1373 = bitcast<f32>((bitcast<u32>(_e1350) & 2147483647u));
                                                                        let _e1376 = bitcast<f32>((bitcast<u32>(_e1351) & 2147483647u));
                                                                        let _e1378 = select(_e1376, _e1373, (_e1373 > _e1376));
                                                                        let _e1381 = bitcast<f32>((bitcast<u32>(_e1352) & 2147483647u));
                                                                        let _e1383 = select(_e1381, _e1378, (_e1378 > _e1381));
                                                                        let _e1386 = bitcast<f32>((bitcast<u32>(_e1354) & 2147483647u));
                                                                        let _e1389 = bitcast<f32>((bitcast<u32>(_e1355) & 2147483647u));
                                                                        let _e1391 = select(_e1389, _e1386, (_e1386 > _e1389));
                                                                        let _e1394 = bitcast<f32>((bitcast<u32>(_e1356) & 2147483647u));
                                                                        let _e1396 = select(_e1394, _e1391, (_e1391 > _e1394));
                                                                        let _e1398 = select(_e1383, _e1370, (_e1370 > _e1383));
                                                                        let _e1400 = select(_e1396, _e1398, (_e1398 > _e1396));
                                                                        if (_e1370 == _e1400) {
                                                                            phi_1768_ = _e1207;
                                                                            phi_1769_ = _e1204;
                                                                            phi_1770_ = _e1194;
                                                                            phi_1771_ = _e1191;
                                                                            phi_1772_ = _e1343;
                                                                            phi_1773_ = _e1357;
                                                                            phi_1774_ = _e1353;
                                                                            phi_1775_ = _e1349;
                                                                        } else {
                                                                            let _e1402 = (_e1383 == _e1400);
                                                                            let _e1407 = vec3(_e1402);
                                                                            phi_1768_ = select(_e1194, _e1220, _e1402);
                                                                            phi_1769_ = select(_e1191, _e1217, _e1402);
                                                                            phi_1770_ = select(_e1220, _e1207, _e1402);
                                                                            phi_1771_ = select(_e1217, _e1204, _e1402);
                                                                            phi_1772_ = select(_e1345, _e1344, _e1407);
                                                                            phi_1773_ = select(_e1353, _e1349, _e1407);
                                                                            phi_1774_ = select(_e1349, _e1357, _e1407);
                                                                            phi_1775_ = select(_e1357, _e1353, _e1407);
                                                                        }
                                                                        let _e1413 = phi_1768_;
                                                                        let _e1415 = phi_1769_;
                                                                        let _e1417 = phi_1770_;
                                                                        let _e1419 = phi_1771_;
                                                                        let _e1421 = phi_1772_;
                                                                        let _e1423 = phi_1773_;
                                                                        let _e1425 = phi_1774_;
                                                                        let _e1427 = phi_1775_;
                                                                        let _e1434 = ((_e1425.y * _e1423.z) - (_e1423.y * _e1425.z));
                                                                        let _e1439 = ((_e1425.z * _e1423.x) - (_e1423.z * _e1425.x));
                                                                        let _e1442 = ((_e1425.x * _e1423.y) - (_e1423.x * _e1425.y));
                                                                        if (_e1242 >= _e1246) {
                                                                            phi_1806_ = select(true, false, (_e1242 >= _e1250));
                                                                        } else {
                                                                            phi_1806_ = true;
                                                                        }
                                                                        let _e1447 = phi_1806_;
                                                                        if _e1447 {
                                                                            phi_1815_ = select(_e1345, _e1344, vec3((_e1246 >= _e1250)));
                                                                        } else {
                                                                            phi_1815_ = _e1343;
                                                                        }
                                                                        let _e1452 = phi_1815_;
                                                                        let _e1463 = (((_e1434 * (_e1452.x - _e389)) + (_e1439 * (_e1452.y - _e426))) + (_e1442 * (_e1452.z - _e462)));
                                                                        let _e1468 = (((_e1434 * _e414) + (_e1439 * _e450)) + (_e1442 * _e486));
                                                                        let _e1469 = (_e1415 - _e1419);
                                                                        let _e1470 = (_e1413 - _e1417);
                                                                        let _e1478 = (-(((_e1419 * _e1469) + (_e1417 * _e1470))) / ((_e1469 * _e1469) + (_e1470 * _e1470)));
                                                                        let _e1480 = select(1f, _e1478, (_e1478 < 1f));
                                                                        let _e1482 = select(0f, _e1480, (_e1480 > 0f));
                                                                        let _e1495 = ((_e1421.x + (_e1427.x * _e1482)) - _e389);
                                                                        let _e1496 = ((_e1421.y + (_e1427.y * _e1482)) - _e426);
                                                                        let _e1497 = ((_e1421.z + (_e1427.z * _e1482)) - _e462);
                                                                        let _e1498 = (_e1497 / _e486);
                                                                        let _e1510 = bitcast<f32>((bitcast<u32>(_e1495) & 2147483647u));
                                                                        let _e1513 = bitcast<f32>((bitcast<u32>(_e1496) & 2147483647u));
                                                                        let _e1515 = select(_e1513, _e1510, (_e1510 > _e1513));
                                                                        let _e1518 = bitcast<f32>((bitcast<u32>(_e1497) & 2147483647u));
                                                                        let _e1520 = select(_e1518, _e1515, (_e1515 > _e1518));
                                                                        let _e1526 = bitcast<f32>((bitcast<u32>(_e1434) & 2147483647u));
                                                                        let _e1529 = bitcast<f32>((bitcast<u32>(_e1439) & 2147483647u));
                                                                        let _e1531 = select(_e1529, _e1526, (_e1526 > _e1529));
                                                                        let _e1534 = bitcast<f32>((bitcast<u32>(_e1442) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1434 * _e1495) + (_e1439 * _e1496)) + (_e1442 * _e1497)) - _e1463)) & 2147483647u)) <= ((0.0000009536743f * select(_e1400, _e1520, (_e1520 > _e1400))) * select(_e1534, _e1531, (_e1531 > _e1534)))) {
                                                                            let _e1544 = bitcast<f32>((bitcast<u32>(_e1425.x) & 2147483647u));
                                                                            let _e1547 = bitcast<f32>((bitcast<u32>(_e1425.y) & 2147483647u));
                                                                            let _e1549 = select(_e1547, _e1544, (_e1544 > _e1547));
                                                                            let _e1552 = bitcast<f32>((bitcast<u32>(_e1425.z) & 2147483647u));
                                                                            let _e1558 = bitcast<f32>((bitcast<u32>(_e1423.x) & 2147483647u));
                                                                            let _e1561 = bitcast<f32>((bitcast<u32>(_e1423.y) & 2147483647u));
                                                                            let _e1563 = select(_e1561, _e1558, (_e1558 > _e1561));
                                                                            let _e1566 = bitcast<f32>((bitcast<u32>(_e1423.z) & 2147483647u));
                                                                            let _e1570 = (bitcast<f32>((bitcast<u32>(_e1468) & 2147483647u)) > ((0.0000038146973f * select(_e1552, _e1549, (_e1549 > _e1552))) * select(_e1566, _e1563, (_e1563 > _e1566))));
                                                                            if _e1570 {
                                                                                phi_1980_ = (_e1463 / _e1468);
                                                                            } else {
                                                                                phi_1980_ = f32();
                                                                            }
                                                                            let _e1573 = phi_1980_;
                                                                            phi_1982_ = _e1573;
                                                                            phi_1983_ = select(true, false, _e1570);
                                                                        } else {
                                                                            phi_1982_ = f32();
                                                                            phi_1983_ = true;
                                                                        }
                                                                        let _e1576 = phi_1982_;
                                                                        let _e1578 = phi_1983_;
                                                                        if _e1578 {
                                                                            let _e1586 = (((_e1434 * (_e1495 - (_e414 * _e1498))) + (_e1439 * (_e1496 - (_e450 * _e1498)))) / _e1468);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1586) & 2147483647u)) <= _e1400) {
                                                                                phi_2003_ = (_e1498 + _e1586);
                                                                            } else {
                                                                                phi_2003_ = _e1498;
                                                                            }
                                                                            let _e1593 = phi_2003_;
                                                                            phi_2004_ = _e1593;
                                                                        } else {
                                                                            phi_2004_ = _e1576;
                                                                        }
                                                                        let _e1595 = phi_2004_;
                                                                        let _e1597 = select(_e1333, _e1595, (_e1595 < _e1333));
                                                                        let _e1599 = select(_e1325, _e1597, (_e1597 > _e1325));
                                                                        if (_e1599 >= _e535) {
                                                                            let _e1601 = (_e1599 <= _e1084.member_1);
                                                                            if _e1601 {
                                                                                let _e1602 = (1f / _e1252);
                                                                                phi_2027_ = type_26(_e1599, (_e1246 * _e1602), (_e1250 * _e1602), _e1113);
                                                                            } else {
                                                                                phi_2027_ = type_26();
                                                                            }
                                                                            let _e1607 = phi_2027_;
                                                                            phi_2029_ = _e1607;
                                                                            phi_2030_ = select(true, false, _e1601);
                                                                        } else {
                                                                            phi_2029_ = type_26();
                                                                            phi_2030_ = true;
                                                                        }
                                                                        let _e1610 = phi_2029_;
                                                                        let _e1612 = phi_2030_;
                                                                        if _e1612 {
                                                                            phi_2034_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2034_ = _e1610;
                                                                        }
                                                                        let _e1614 = phi_2034_;
                                                                        phi_2035_ = _e1614;
                                                                    }
                                                                    let _e1616 = phi_2035_;
                                                                    phi_2036_ = _e1616;
                                                                    phi_2037_ = _e1342;
                                                                }
                                                                let _e1618 = phi_2036_;
                                                                let _e1620 = phi_2037_;
                                                                phi_2041_ = _e1618;
                                                                phi_2042_ = _e1620;
                                                            }
                                                            let _e1622 = phi_2041_;
                                                            let _e1624 = phi_2042_;
                                                            phi_2043_ = _e1622;
                                                            phi_2044_ = _e1277;
                                                            phi_2045_ = _e1624;
                                                        }
                                                        let _e1626 = phi_2043_;
                                                        let _e1628 = phi_2044_;
                                                        let _e1630 = phi_2045_;
                                                        phi_2046_ = _e1626;
                                                        phi_2047_ = _e1628;
                                                        phi_2048_ = _e1630;
                                                    }
                                                    let _e1632 = phi_2046_;
                                                    let _e1634 = phi_2047_;
                                                    let _e1636 = phi_2048_;
                                                    phi_2056_ = _e1632;
                                                    phi_2057_ = select(_e1636, true, _e1634);
                                                } else {
                                                    phi_2056_ = type_26();
                                                    phi_2057_ = true;
                                                }
                                                let _e1639 = phi_2056_;
                                                let _e1641 = phi_2057_;
                                                if _e1641 {
                                                    phi_2061_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2061_ = _e1639;
                                                }
                                                let _e1643 = phi_2061_;
                                                if (_e1643.member_3 != 4294967295u) {
                                                    if (_e1113 == _e163) {
                                                        phi_2390_ = false;
                                                    } else {
                                                        let _e1647 = (_e1113 < arrayLength((&global_5.member)));
                                                        if _e1647 {
                                                            if _e1647 {
                                                            } else {
                                                                phi_3962_ = true;
                                                                break;
                                                            }
                                                            let _e1649 = global_5.member[_e1113];
                                                            phi_2084_ = _e1649;
                                                        } else {
                                                            phi_2084_ = 4294967295u;
                                                        }
                                                        let _e1651 = phi_2084_;
                                                        let _e1652 = (_e1651 < arrayLength((&global_6.member)));
                                                        if _e1652 {
                                                            if _e1652 {
                                                            } else {
                                                                phi_3962_ = true;
                                                                break;
                                                            }
                                                            let _e1654 = global_6.member[_e1651];
                                                            phi_2098_ = _e1654;
                                                        } else {
                                                            phi_2098_ = 0i;
                                                        }
                                                        let _e1656 = phi_2098_;
                                                        let _e1657 = (_e1656 == 0i);
                                                        if _e1657 {
                                                            phi_2389_ = true;
                                                        } else {
                                                            if _e381 {
                                                                phi_2119_ = vec3<f32>(_e1180[0][0], _e1180[0][1], _e1180[0][2]);
                                                            } else {
                                                                if (_e357 == 1u) {
                                                                    phi_2118_ = vec3<f32>(_e1180[0][2], _e1180[0][0], _e1180[0][1]);
                                                                } else {
                                                                    phi_2118_ = vec3<f32>(_e1180[0][1], _e1180[0][2], _e1180[0][0]);
                                                                }
                                                                let _e1662 = phi_2118_;
                                                                phi_2119_ = _e1662;
                                                            }
                                                            let _e1665 = phi_2119_;
                                                            if _e381 {
                                                                phi_2136_ = vec3<f32>(_e1180[1][0], _e1180[1][1], _e1180[1][2]);
                                                            } else {
                                                                if (_e357 == 1u) {
                                                                    phi_2135_ = vec3<f32>(_e1180[1][2], _e1180[1][0], _e1180[1][1]);
                                                                } else {
                                                                    phi_2135_ = vec3<f32>(_e1180[1][1], _e1180[1][2], _e1180[1][0]);
                                                                }
                                                                let _e1670 = phi_2135_;
                                                                phi_2136_ = _e1670;
                                                            }
                                                            let _e1673 = phi_2136_;
                                                            if _e381 {
                                                                phi_2153_ = vec3<f32>(_e1180[2][0], _e1180[2][1], _e1180[2][2]);
                                                            } else {
                                                                if (_e357 == 1u) {
                                                                    phi_2152_ = vec3<f32>(_e1180[2][2], _e1180[2][0], _e1180[2][1]);
                                                                } else {
                                                                    phi_2152_ = vec3<f32>(_e1180[2][1], _e1180[2][2], _e1180[2][0]);
                                                                }
                                                                let _e1678 = phi_2152_;
                                                                phi_2153_ = _e1678;
                                                            }
                                                            let _e1681 = phi_2153_;
                                                            let _e1684 = (_e1673.x - _e1665.x);
                                                            let _e1687 = (_e1673.y - _e1665.y);
                                                            let _e1690 = (_e1673.z - _e1665.z);
                                                            let _e1692 = (_e1681.x - _e1665.x);
                                                            let _e1694 = (_e1681.y - _e1665.y);
                                                            let _e1696 = (_e1681.z - _e1665.z);
                                                            if (_e235.member_1 == 1u) {
                                                                phi_2189_ = (vec3<f32>(_e235.member[0], _e235.member[1], _e235.member[2]) - _e1665);
                                                            } else {
                                                                phi_2189_ = vec3<f32>(_e235.member[0], _e235.member[1], _e235.member[2]);
                                                            }
                                                            let _e1711 = phi_2189_;
                                                            let _e1717 = bitcast<f32>((bitcast<u32>((_e1684 * _e1694)) ^ _e235.member_3[0]));
                                                            let _e1721 = bitcast<f32>((bitcast<u32>((_e1687 * _e1692)) ^ _e235.member_3[0]));
                                                            let _e1725 = bitcast<f32>((bitcast<u32>((_e1687 * _e1696)) ^ _e235.member_3[0]));
                                                            let _e1729 = bitcast<f32>((bitcast<u32>((_e1690 * _e1694)) ^ _e235.member_3[0]));
                                                            let _e1733 = bitcast<f32>((bitcast<u32>((_e1690 * _e1692)) ^ _e235.member_3[0]));
                                                            let _e1737 = bitcast<f32>((bitcast<u32>((_e1684 * _e1696)) ^ _e235.member_3[0]));
                                                            let _e1738 = (_e1725 - _e1729);
                                                            let _e1739 = (_e1733 - _e1737);
                                                            let _e1740 = (_e1717 - _e1721);
                                                            let _e1764 = (bitcast<f32>((bitcast<u32>(_e1725) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1729) & 2147483647u)));
                                                            let _e1771 = (bitcast<f32>((bitcast<u32>(_e1733) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1737) & 2147483647u)));
                                                            let _e1778 = (bitcast<f32>((bitcast<u32>(_e1717) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1721) & 2147483647u)));
                                                            if (_e235.member_2 == 0f) {
                                                                phi_2371_ = 0f;
                                                            } else {
                                                                let _e1808 = bitcast<f32>((bitcast<u32>(_e1738) & 2147483647u));
                                                                let _e1811 = bitcast<f32>((bitcast<u32>(_e1739) & 2147483647u));
                                                                let _e1814 = bitcast<f32>((bitcast<u32>(_e1740) & 2147483647u));
                                                                let _e1816 = select(_e1814, _e1811, (_e1811 > _e1814));
                                                                let _e1820 = select(_e1814, _e1811, (_e1811 < _e1814));
                                                                let _e1824 = select(_e1811, _e1808, (_e1808 < _e1811));
                                                                let _e1826 = select(_e1811, _e1808, (_e1808 > _e1811));
                                                                let _e1828 = select(_e1814, _e1826, (_e1826 < _e1814));
                                                                phi_2371_ = bitcast<f32>((bitcast<u32>((_e235.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1816, _e1808, (_e1808 > _e1816)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1828, _e1824, (_e1824 > _e1828)))) ^ _e235.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1820, _e1808, (_e1808 < _e1820)))) ^ _e235.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1764 + _e1771) + _e1778))) ^ _e235.member_3[0]))) * 1.0000005f)) ^ _e235.member_3[0])))) ^ _e235.member_3[0]));
                                                            }
                                                            let _e1855 = phi_2371_;
                                                            phi_2389_ = (_e1657 || !(((((bitcast<f32>((bitcast<u32>((_e1711.x * _e1738)) ^ _e235.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1711.y * _e1739)) ^ _e235.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1711.z * _e1740)) ^ _e235.member_3[0]))) * f32(-(_e1656))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1711.x) & 2147483647u)) * _e1764)) ^ _e235.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1711.y) & 2147483647u)) * _e1771)) ^ _e235.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1711.z) & 2147483647u)) * _e1778)) ^ _e235.member_3[0]))))) ^ _e235.member_3[0])) + _e1855) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1869 = phi_2389_;
                                                        phi_2390_ = _e1869;
                                                    }
                                                    let _e1871 = phi_2390_;
                                                    if _e1871 {
                                                        if (_e1643.member < _e1084.member.member) {
                                                            phi_2410_ = true;
                                                        } else {
                                                            if (_e1643.member == _e1084.member.member) {
                                                                phi_2409_ = (_e1643.member_3 < _e1084.member.member_3);
                                                            } else {
                                                                phi_2409_ = false;
                                                            }
                                                            let _e1881 = phi_2409_;
                                                            phi_2410_ = _e1881;
                                                        }
                                                        let _e1883 = phi_2410_;
                                                        if _e1883 {
                                                            phi_2416_ = type_43(_e1643, _e1643.member);
                                                        } else {
                                                            phi_2416_ = _e1084;
                                                        }
                                                        let _e1886 = phi_2416_;
                                                        phi_2417_ = _e1886;
                                                    } else {
                                                        phi_2417_ = _e1084;
                                                    }
                                                    let _e1888 = phi_2417_;
                                                    phi_2418_ = _e1888;
                                                } else {
                                                    phi_2418_ = _e1084;
                                                }
                                                let _e1890 = phi_2418_;
                                                phi_1086_ = _e1890;
                                            } else {
                                                phi_1086_ = type_43();
                                            }
                                            let _e1892 = phi_1086_;
                                            continue;
                                            continuing {
                                                phi_1085_ = _e1892;
                                                phi_1088_ = _e1099;
                                                phi_3962_ = _e577;
                                                break if !(_e1105);
                                            }
                                        }
                                        let _e1895 = phi_3962_;
                                        phi_4128_ = _e1895;
                                        if _e1895 {
                                            break;
                                        }
                                        phi_4132_ = _e1895;
                                        let _e2129 = local_11;
                                        phi_3623_ = _e2129;
                                        phi_3624_ = _e618;
                                        phi_3625_ = false;
                                        phi_3626_ = _e622;
                                    } else {
                                        if (_e618.member_1 >= _e96) {
                                            phi_3179_ = type_63(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_62(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_62(type_38(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e618.member_1 < _e96) {
                                            } else {
                                                phi_4128_ = true;
                                                break;
                                            }
                                            let _e633 = (_e357 * 2u);
                                            let _e635 = ((1u + _e633) % 7u);
                                            if (_e635 < 7u) {
                                            } else {
                                                phi_4128_ = true;
                                                break;
                                            }
                                            let _e640 = global_10.member[_e618.member_1][_e635];
                                            let _e642 = ((_e633 + 2u) % 7u);
                                            if (_e642 < 7u) {
                                            } else {
                                                phi_4128_ = true;
                                                break;
                                            }
                                            let _e647 = global_10.member[_e618.member_1][_e642];
                                            let _e648 = (_e356 * 2u);
                                            let _e650 = ((1u + _e648) % 7u);
                                            if (_e650 < 7u) {
                                            } else {
                                                phi_4128_ = true;
                                                break;
                                            }
                                            let _e655 = global_10.member[_e618.member_1][_e650];
                                            let _e657 = ((_e648 + 2u) % 7u);
                                            if (_e657 < 7u) {
                                            } else {
                                                phi_4128_ = true;
                                                break;
                                            }
                                            let _e662 = global_10.member[_e618.member_1][_e657];
                                            let _e663 = (_e358 * 2u);
                                            let _e665 = ((1u + _e663) % 7u);
                                            if (_e665 < 7u) {
                                            } else {
                                                phi_4128_ = true;
                                                break;
                                            }
                                            let _e670 = global_10.member[_e618.member_1][_e665];
                                            let _e672 = ((_e663 + 2u) % 7u);
                                            if (_e672 < 7u) {
                                            } else {
                                                phi_4128_ = true;
                                                break;
                                            }
                                            let _e677 = global_10.member[_e618.member_1][_e672];
                                            let _e700 = (bitcast<f32>((bitcast<u32>((_e618.member.member_1.x - _e618.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e701 = (bitcast<f32>((bitcast<u32>((_e618.member.member_1.y - _e618.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e702 = (bitcast<f32>((bitcast<u32>((_e618.member.member_1.z - _e618.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e704 = select(_e154, _e700, (_e700 > _e154));
                                            let _e706 = select(_e154, _e701, (_e701 > _e154));
                                            let _e708 = select(_e154, _e702, (_e702 > _e154));
                                            let _e733 = bitcast<u32>((f32(bitcast<i32>((_e640 & 2097151u))) * _e704));
                                            let _e738 = (bitcast<i32>((_e640 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e741 = bitcast<f32>((_e733 & bitcast<u32>(_e738)));
                                            let _e742 = bitcast<u32>((f32(bitcast<i32>((_e655 & 2097151u))) * _e706));
                                            let _e747 = (bitcast<i32>((_e655 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e750 = bitcast<f32>((_e742 & bitcast<u32>(_e747)));
                                            let _e751 = bitcast<u32>((f32(bitcast<i32>((_e670 & 2097151u))) * _e708));
                                            let _e756 = (bitcast<i32>((_e670 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e759 = bitcast<f32>((_e751 & bitcast<u32>(_e756)));
                                            let _e763 = bitcast<f32>((_e733 & bitcast<u32>(~(_e738))));
                                            let _e767 = bitcast<f32>((_e742 & bitcast<u32>(~(_e747))));
                                            let _e771 = bitcast<f32>((_e751 & bitcast<u32>(~(_e756))));
                                            let _e772 = bitcast<u32>((f32(bitcast<i32>((_e647 & 2097151u))) * _e704));
                                            let _e777 = (bitcast<i32>((_e647 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e780 = bitcast<f32>((_e772 & bitcast<u32>(_e777)));
                                            let _e781 = bitcast<u32>((f32(bitcast<i32>((_e662 & 2097151u))) * _e706));
                                            let _e786 = (bitcast<i32>((_e662 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e789 = bitcast<f32>((_e781 & bitcast<u32>(_e786)));
                                            let _e790 = bitcast<u32>((f32(bitcast<i32>((_e677 & 2097151u))) * _e708));
                                            let _e795 = (bitcast<i32>((_e677 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e798 = bitcast<f32>((_e790 & bitcast<u32>(_e795)));
                                            let _e802 = bitcast<f32>((_e772 & bitcast<u32>(~(_e777))));
                                            let _e806 = bitcast<f32>((_e781 & bitcast<u32>(~(_e786))));
                                            let _e810 = bitcast<f32>((_e790 & bitcast<u32>(~(_e795))));
                                            let _e840 = global_10.member[_e618.member_1][0u];
                                            let _e844 = global_10.member[_e618.member_1][2u];
                                            let _e848 = global_10.member[_e618.member_1][4u];
                                            let _e852 = global_10.member[_e618.member_1][6u];
                                            let _e864 = (((_e844 >> bitcast<u32>(22i)) | ((_e848 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e852 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e865 = (_e840 & 268435455u);
                                            let _e866 = (_e864 & 268435455u);
                                            let _e869 = ((_e840 >> bitcast<u32>(28u)) & 7u);
                                            let _e877 = ((_e840 >> bitcast<u32>(31i)) | (((_e864 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e878 = (_e869 != 0u);
                                            if (_e869 == 0u) {
                                                phi_3141_ = _e865;
                                            } else {
                                                if (_e869 == 7u) {
                                                    phi_3140_ = 2147483648u;
                                                } else {
                                                    phi_3140_ = ((2147483648u | (_e869 << bitcast<u32>(28u))) | (_e866 & 268435455u));
                                                }
                                                let _e887 = phi_3140_;
                                                phi_3141_ = _e887;
                                            }
                                            let _e889 = phi_3141_;
                                            if _e878 {
                                                let _e890 = (_e869 != 7u);
                                                if _e890 {
                                                    phi_3151_ = (_e866 + _e869);
                                                } else {
                                                    phi_3151_ = u32();
                                                }
                                                let _e893 = phi_3151_;
                                                phi_3153_ = _e893;
                                                phi_3154_ = select(true, false, _e890);
                                            } else {
                                                phi_3153_ = u32();
                                                phi_3154_ = true;
                                            }
                                            let _e896 = phi_3153_;
                                            let _e898 = phi_3154_;
                                            if (_e877 == 0u) {
                                                phi_3175_ = (_e865 + select(0u, 1u, !(_e878)));
                                            } else {
                                                if (_e877 == 7u) {
                                                    phi_3174_ = 2147483648u;
                                                } else {
                                                    phi_3174_ = ((2147483648u | (_e877 << bitcast<u32>(28u))) | (select(_e896, _e866, _e898) & 268435455u));
                                                }
                                                let _e911 = phi_3174_;
                                                phi_3175_ = _e911;
                                            }
                                            let _e913 = phi_3175_;
                                            phi_3179_ = type_63(array<vec4<f32>, 3>(vec4<f32>((_e618.member.member.x + _e741), (_e618.member.member.x + _e763), (_e618.member.member_1.x - _e780), (_e618.member.member_1.x - _e802)), vec4<f32>((_e618.member.member.y + _e750), (_e618.member.member.y + _e767), (_e618.member.member_1.y - _e789), (_e618.member.member_1.y - _e806)), vec4<f32>((_e618.member.member.z + _e759), (_e618.member.member.z + _e771), (_e618.member.member_1.z - _e798), (_e618.member.member_1.z - _e810))), type_62(type_38((_e618.member.member + vec4<f32>(_e741, _e750, _e759, 0f)), (_e618.member.member_1 - vec4<f32>(_e780, _e789, _e798, 0f))), _e889), type_62(type_38((_e618.member.member + vec4<f32>(_e763, _e767, _e771, 0f)), (_e618.member.member_1 - vec4<f32>(_e802, _e806, _e810, 0f))), _e913));
                                        }
                                        let _e918 = phi_3179_;
                                        let _e930 = ((_e918.member[0].x - _e412) * _e417);
                                        let _e931 = ((_e918.member[0].y - _e412) * _e417);
                                        let _e932 = ((_e918.member[0].z - _e413) * _e417);
                                        let _e933 = ((_e918.member[0].w - _e413) * _e417);
                                        let _e943 = ((_e918.member[1].x - _e448) * _e453);
                                        let _e944 = ((_e918.member[1].y - _e448) * _e453);
                                        let _e945 = ((_e918.member[1].z - _e449) * _e453);
                                        let _e946 = ((_e918.member[1].w - _e449) * _e453);
                                        let _e956 = ((_e918.member[2].x - _e484) * _e489);
                                        let _e957 = ((_e918.member[2].y - _e484) * _e489);
                                        let _e958 = ((_e918.member[2].z - _e485) * _e489);
                                        let _e959 = ((_e918.member[2].w - _e485) * _e489);
                                        let _e961 = select(_e958, _e956, (_e956 < _e958));
                                        let _e963 = select(_e959, _e957, (_e957 < _e959));
                                        let _e965 = select(_e958, _e956, (_e956 > _e958));
                                        let _e967 = select(_e959, _e957, (_e957 > _e959));
                                        let _e969 = select(_e932, _e930, (_e930 < _e932));
                                        let _e971 = select(_e933, _e931, (_e931 < _e933));
                                        let _e973 = select(_e945, _e943, (_e943 < _e945));
                                        let _e975 = select(_e946, _e944, (_e944 < _e946));
                                        let _e977 = select(_e973, _e969, (_e969 > _e973));
                                        let _e979 = select(_e975, _e971, (_e971 > _e975));
                                        let _e981 = select(_e961, _e977, (_e977 > _e961));
                                        let _e983 = select(_e963, _e979, (_e979 > _e963));
                                        let _e985 = select(_e932, _e930, (_e930 > _e932));
                                        let _e987 = select(_e933, _e931, (_e931 > _e933));
                                        let _e989 = select(_e945, _e943, (_e943 > _e945));
                                        let _e991 = select(_e946, _e944, (_e944 > _e946));
                                        let _e993 = select(_e989, _e985, (_e985 < _e989));
                                        let _e995 = select(_e991, _e987, (_e987 < _e991));
                                        let _e1000 = -(_e961);
                                        let _e1001 = -(_e963);
                                        let _e1008 = (select(_e965, _e993, (_e993 < _e965)) + (select(_e1000, _e965, (_e965 > _e1000)) * 0.0000019073523f));
                                        let _e1009 = (select(_e967, _e995, (_e995 < _e967)) + (select(_e1001, _e967, (_e967 > _e1001)) * 0.0000019073523f));
                                        let _e1011 = select(_e535, _e981, (_e981 > _e535));
                                        let _e1013 = select(_e535, _e983, (_e983 > _e535));
                                        let _e1018 = (_e1011 <= select(_e579.member_1, _e1008, (_e1008 < _e579.member_1)));
                                        let _e1019 = (_e1013 <= select(_e579.member_1, _e1009, (_e1009 < _e579.member_1)));
                                        let _e1020 = (_e1011 <= _e1013);
                                        if _e1018 {
                                            if _e1019 {
                                                if _e1020 {
                                                    phi_3523_ = _e918.member_2;
                                                } else {
                                                    phi_3523_ = _e918.member_1;
                                                }
                                                let _e1024 = phi_3523_;
                                                let _e1046 = (_e622 % 128u);
                                                let _e1047 = (_e1046 < 128u);
                                                if _e1047 {
                                                } else {
                                                    phi_4128_ = true;
                                                    break;
                                                }
                                                local_8[_e1046] = _e1024.member_1;
                                                if _e1047 {
                                                } else {
                                                    phi_4128_ = true;
                                                    break;
                                                }
                                                local_7[_e1046] = _e1024.member.member.x;
                                                if _e1047 {
                                                } else {
                                                    phi_4128_ = true;
                                                    break;
                                                }
                                                local_6[_e1046] = _e1024.member.member.y;
                                                if _e1047 {
                                                } else {
                                                    phi_4128_ = true;
                                                    break;
                                                }
                                                local_5[_e1046] = _e1024.member.member.z;
                                                if _e1047 {
                                                } else {
                                                    phi_4128_ = true;
                                                    break;
                                                }
                                                local_4[_e1046] = _e1024.member.member_1.x;
                                                if _e1047 {
                                                } else {
                                                    phi_4128_ = true;
                                                    break;
                                                }
                                                local_3[_e1046] = _e1024.member.member_1.y;
                                                if _e1047 {
                                                } else {
                                                    phi_4128_ = true;
                                                    break;
                                                }
                                                local_2[_e1046] = _e1024.member.member_1.z;
                                                if _e1047 {
                                                } else {
                                                    phi_4128_ = true;
                                                    break;
                                                }
                                                local_9[_e1046] = select(_e1013, _e1011, (_e1011 > _e1013));
                                                if _e1020 {
                                                    phi_3600_ = _e918.member_1;
                                                } else {
                                                    phi_3600_ = _e918.member_2;
                                                }
                                                let _e1060 = phi_3600_;
                                                phi_3601_ = _e1060;
                                                phi_3602_ = (_e622 + 1u);
                                            } else {
                                                phi_3601_ = type_62();
                                                phi_3602_ = u32();
                                            }
                                            let _e1062 = phi_3601_;
                                            let _e1064 = phi_3602_;
                                            phi_3604_ = _e1062;
                                            phi_3605_ = _e1064;
                                            phi_3606_ = select(true, false, _e1019);
                                        } else {
                                            phi_3604_ = type_62();
                                            phi_3605_ = u32();
                                            phi_3606_ = true;
                                        }
                                        let _e1067 = phi_3604_;
                                        let _e1069 = phi_3605_;
                                        let _e1071 = phi_3606_;
                                        if _e1071 {
                                            if _e1018 {
                                                phi_3615_ = _e918.member_1;
                                            } else {
                                                phi_3615_ = _e918.member_2;
                                            }
                                            let _e1075 = phi_3615_;
                                            phi_3620_ = _e1075;
                                            phi_3621_ = select(_e1019, true, _e1018);
                                        } else {
                                            phi_3620_ = _e1067;
                                            phi_3621_ = _e620;
                                        }
                                        let _e1078 = phi_3620_;
                                        let _e1080 = phi_3621_;
                                        phi_4132_ = _e577;
                                        phi_3623_ = _e579;
                                        phi_3624_ = _e1078;
                                        phi_3625_ = _e1080;
                                        phi_3626_ = select(_e1069, _e622, _e1071);
                                    }
                                    let _e1897 = phi_4132_;
                                    let _e1899 = phi_3623_;
                                    let _e1901 = phi_3624_;
                                    let _e1903 = phi_3625_;
                                    let _e1905 = phi_3626_;
                                    phi_4131_ = _e1897;
                                    phi_3627_ = _e1899;
                                    phi_3628_ = _e1901;
                                    phi_3629_ = (_e583 - 1u);
                                    phi_3630_ = _e1903;
                                    phi_3631_ = _e1905;
                                } else {
                                    phi_4131_ = _e577;
                                    phi_3627_ = _e579;
                                    phi_3628_ = _e618;
                                    phi_3629_ = _e583;
                                    phi_3630_ = _e620;
                                    phi_3631_ = _e622;
                                }
                                let _e1907 = phi_4131_;
                                let _e1909 = phi_3627_;
                                let _e1911 = phi_3628_;
                                let _e1913 = phi_3629_;
                                let _e1915 = phi_3630_;
                                let _e1917 = phi_3631_;
                                phi_4130_ = _e1907;
                                phi_3632_ = _e1909;
                                phi_3633_ = _e1911;
                                phi_3634_ = _e1913;
                                phi_3635_ = _e1915;
                                phi_3636_ = _e1917;
                            } else {
                                phi_4130_ = _e577;
                                phi_3632_ = type_43();
                                phi_3633_ = type_62();
                                phi_3634_ = u32();
                                phi_3635_ = bool();
                                phi_3636_ = u32();
                            }
                            let _e1919 = phi_4130_;
                            let _e1921 = phi_3632_;
                            let _e1923 = phi_3633_;
                            let _e1925 = phi_3634_;
                            let _e1927 = phi_3635_;
                            let _e1929 = phi_3636_;
                            phi_4129_ = _e1919;
                            phi_960_ = _e1921;
                            phi_963_ = _e1923;
                            phi_965_ = _e1925;
                            phi_967_ = _e1927;
                            phi_969_ = _e1929;
                            phi_3637_ = _e591;
                        } else {
                            phi_4129_ = _e577;
                            phi_960_ = type_43();
                            phi_963_ = type_62();
                            phi_965_ = u32();
                            phi_967_ = bool();
                            phi_969_ = u32();
                            phi_3637_ = false;
                        }
                        let _e1931 = phi_4129_;
                        let _e1933 = phi_960_;
                        let _e1935 = phi_963_;
                        let _e1937 = phi_965_;
                        let _e1939 = phi_967_;
                        let _e1941 = phi_969_;
                        let _e1943 = phi_3637_;
                        continue;
                        continuing {
                            phi_3968_ = _e1931;
                            phi_959_ = _e1933;
                            phi_962_ = _e1935;
                            phi_964_ = _e1937;
                            phi_966_ = _e1939;
                            phi_968_ = _e1941;
                            phi_4128_ = _e1931;
                            break if !(_e1943);
                        }
                    }
                    let _e1946 = phi_4128_;
                    if _e1946 {
                        break;
                    }
                    let _e1948 = local_10;
                    if (_e1948.member.member_3 != 4294967295u) {
                        let _e1953 = (_e359 / 3i);
                        let _e1960 = bitcast<f32>((bitcast<u32>((_e1953 + 127i)) << bitcast<u32>(23i)));
                        let _e1968 = (((_e1948.member.member * _e1960) * _e1960) * bitcast<f32>((bitcast<u32>(((_e359 - (2i * _e1953)) + 127i)) << bitcast<u32>(23i))));
                        let _e1970 = select(340282350000000000000000000000000000000f, _e1968, (_e1968 < 340282350000000000000000000000000000000f));
                        phi_3689_ = type_26(select(-340282350000000000000000000000000000000f, _e1970, (_e1970 > -340282350000000000000000000000000000000f)), _e1948.member.member_1, _e1948.member.member_2, _e1948.member.member_3);
                    } else {
                        phi_3689_ = type_26(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1977 = phi_3689_;
                    if _e236 {
                    } else {
                        break;
                    }
                    global_8.member[_e142] = _e1977;
                    if _e157 {
                    } else {
                        break;
                    }
                    let _e1981 = select(0u, 1u, (_e303 <= _e313));
                    if (_e1981 > 0u) {
                        let _e1983 = (1u < _e110);
                        if _e1983 {
                            if (0u < _e110) {
                            } else {
                                break;
                            }
                            let _e1987 = atomicAdd((&global_9.member[0u]), _e1981);
                            if ((_e1987 + _e1981) < _e1987) {
                                if _e1983 {
                                } else {
                                    break;
                                }
                                let _e1992 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1995 = select(0u, 1u, (_e1977.member_3 != 4294967295u));
                    if (_e1995 > 0u) {
                        let _e1997 = (3u < _e110);
                        if _e1997 {
                            if (2u < _e110) {
                            } else {
                                break;
                            }
                            let _e2001 = atomicAdd((&global_9.member[2u]), _e1995);
                            if ((_e2001 + _e1995) < _e2001) {
                                if _e1997 {
                                } else {
                                    break;
                                }
                                let _e2006 = atomicAdd((&global_9.member[3u]), 1u);
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
fn trace_paths_q21_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
