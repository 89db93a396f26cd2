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

struct type_32 {
    member: array<type_30>,
}

struct type_34 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_35 {
    member: type_34,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_37 {
    member: array<type_35>,
}

struct type_42 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_44 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_47 {
    member: type_30,
    member_1: f32,
}

struct type_52 {
    member: array<vec4<u32>, 2>,
}

struct type_55 {
    member: array<i32>,
}

struct type_62 {
    member: type_42,
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
var<uniform> global_1: type_16;
@group(0) @binding(1) 
var<uniform> global_2: type_52;
@group(0) @binding(2) 
var<uniform> global_3: type_52;
@group(0) @binding(3) 
var<storage> global_4: type_13;
@group(0) @binding(4) 
var<storage> global_5: type_24;
@group(0) @binding(5) 
var<storage> global_6: type_4;
@group(0) @binding(6) 
var<storage> global_7: type_55;
@group(0) @binding(7) 
var<storage> global_8: type_37;
@group(0) @binding(8) 
var<storage, read_write> global_9: type_32;
@group(0) @binding(9) 
var<storage, read_write> global_10: type_68;

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
    var phi_395_: type_44;
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
    var phi_959_: type_47;
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
    var phi_1085_: type_47;
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
    var phi_2027_: type_30;
    var phi_2029_: type_30;
    var phi_2030_: bool;
    var phi_2034_: type_30;
    var phi_2035_: type_30;
    var phi_2036_: type_30;
    var phi_2037_: bool;
    var phi_2041_: type_30;
    var phi_2042_: bool;
    var phi_2043_: type_30;
    var phi_2044_: bool;
    var phi_2045_: bool;
    var phi_2046_: type_30;
    var phi_2047_: bool;
    var phi_2048_: bool;
    var phi_2056_: type_30;
    var phi_2057_: bool;
    var phi_2061_: type_30;
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
    var phi_2416_: type_47;
    var phi_2417_: type_47;
    var phi_2418_: type_47;
    var phi_1086_: type_47;
    var phi_3962_: bool;
    var phi_4132_: bool;
    var phi_3623_: type_47;
    var phi_3624_: type_62;
    var phi_3625_: bool;
    var phi_3626_: u32;
    var phi_4131_: bool;
    var phi_3627_: type_47;
    var phi_3628_: type_62;
    var phi_3629_: u32;
    var phi_3630_: bool;
    var phi_3631_: u32;
    var phi_4130_: bool;
    var phi_3632_: type_47;
    var phi_3633_: type_62;
    var phi_3634_: u32;
    var phi_3635_: bool;
    var phi_3636_: u32;
    var phi_4129_: bool;
    var phi_960_: type_47;
    var phi_963_: type_62;
    var phi_965_: u32;
    var phi_967_: bool;
    var phi_969_: u32;
    var phi_3637_: bool;
    var phi_4128_: bool;
    var local_10: type_47;
    var phi_3689_: type_30;
    var local_11: type_47;

    switch bitcast<i32>(0u) {
        default: {
            let _e96 = global;
            let _e98 = arrayLength((&global_4.member));
            let _e100 = arrayLength((&global_5.member));
            let _e112 = arrayLength((&global_10.member));
            let _e116 = global_3.member[0u][0u];
            let _e120 = global_3.member[0u][1u];
            let _e124 = global_3.member[0u][2u];
            let _e128 = global_3.member[0u][3u];
            let _e132 = global_3.member[1u][0u];
            let _e136 = global_3.member[1u][1u];
            let _e140 = global_3.member[1u][2u];
            let _e144 = (_e96.x + (_e96.y * 2097152u));
            let _e156 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e128) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e116), bitcast<i32>(_e120), bitcast<i32>(_e124));
            local = array<i32, 3>(bitcast<i32>(_e132), bitcast<i32>(_e136), bitcast<i32>(_e140));
            let _e159 = (_e144 < arrayLength((&global_8.member)));
            if _e159 {
                if _e159 {
                } else {
                    break;
                }
                let _e163 = global_8.member[_e144].member_2;
                phi_327_ = _e163;
            } else {
                phi_327_ = 4294967295u;
            }
            let _e165 = phi_327_;
            let _e168 = global_1.member[0u];
            let _e172 = global_2.member[0u][0u];
            let _e176 = global_2.member[0u][1u];
            let _e180 = global_2.member[0u][2u];
            let _e184 = global_2.member[0u][3u];
            let _e188 = global_2.member[1u][0u];
            let _e192 = global_2.member[1u][1u];
            let _e196 = global_2.member[1u][2u];
            let _e200 = global_2.member[1u][3u];
            let _e201 = bitcast<f32>(_e172);
            let _e202 = bitcast<f32>(_e176);
            let _e203 = bitcast<f32>(_e180);
            let _e205 = bitcast<f32>(_e188);
            let _e206 = array<u32, 3>(_e192, _e196, _e200);
            let _e208 = bitcast<i32>(_e168);
            if (_e208 < -126i) {
                phi_371_ = -126i;
            } else {
                phi_371_ = select(_e208, 127i, (_e208 > 127i));
            }
            let _e213 = phi_371_;
            let _e218 = bitcast<f32>((bitcast<u32>((_e213 + 127i)) << bitcast<u32>(23i)));
            let _e224 = bitcast<f32>((bitcast<u32>(((_e208 - _e213) + 127i)) << bitcast<u32>(23i)));
            if (_e184 == 0u) {
                phi_395_ = type_44(array<f32, 3>(_e201, _e202, _e203), _e184, _e205, _e206);
            } else {
                phi_395_ = type_44(array<f32, 3>(((_e201 * _e218) * _e224), ((_e202 * _e218) * _e224), ((_e203 * _e218) * _e224)), _e184, ((_e205 * _e218) * _e224), _e206);
            }
            let _e237 = phi_395_;
            if _e159 {
                let _e238 = (_e144 < arrayLength((&global_9.member)));
                if _e238 {
                    if _e159 {
                    } else {
                        break;
                    }
                    let _e248 = global_8.member[_e144].member.member_2[0u];
                    let _e250 = (bitcast<u32>(_e248) & 2147483647u);
                    let _e256 = global_8.member[_e144].member.member_2[1u];
                    let _e258 = (bitcast<u32>(_e256) & 2147483647u);
                    let _e264 = global_8.member[_e144].member.member_2[2u];
                    let _e266 = (bitcast<u32>(_e264) & 2147483647u);
                    let _e272 = global_8.member[_e144].member.member[0u];
                    let _e274 = (bitcast<u32>(_e272) & 2147483647u);
                    let _e280 = global_8.member[_e144].member.member[1u];
                    let _e282 = (bitcast<u32>(_e280) & 2147483647u);
                    let _e288 = global_8.member[_e144].member.member[2u];
                    let _e290 = (bitcast<u32>(_e288) & 2147483647u);
                    let _e292 = select(_e258, _e250, (_e258 < _e250));
                    let _e294 = select(_e266, _e292, (_e266 < _e292));
                    let _e296 = select(_e274, _e294, (_e274 < _e294));
                    let _e298 = select(_e282, _e296, (_e282 < _e296));
                    let _e300 = select(_e290, _e298, (_e290 < _e298));
                    let _e305 = global_8.member[_e144].member.member_1;
                    let _e307 = (bitcast<u32>(_e305) & 2147483647u);
                    let _e315 = global_8.member[_e144].member.member_3;
                    let _e321 = (((select(_e307, _e300, (_e307 < _e300)) < 2139095040u) && ((bitcast<u32>(_e315) & 2147483647u) <= 2139095040u)) && (_e294 > 0u));
                    if _e321 {
                        let _e324 = (bitcast<u32>(bitcast<f32>(_e294)) & 2147483647u);
                        if (_e324 >= 8388608u) {
                            phi_501_ = (bitcast<i32>((_e324 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_501_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e324)), 32u, (_e324 == 0u))));
                        }
                        let _e338 = phi_501_;
                        phi_502_ = _e338;
                    } else {
                        phi_502_ = 0i;
                    }
                    let _e340 = phi_502_;
                    let _e341 = (_e250 == _e294);
                    if _e341 {
                        phi_512_ = true;
                    } else {
                        phi_512_ = (_e258 == _e294);
                    }
                    let _e344 = phi_512_;
                    let _e345 = select(1u, 0u, _e341);
                    if _e344 {
                        let _e346 = (_e345 + 1u);
                        phi_522_ = _e346;
                        phi_523_ = _e346;
                        phi_525_ = select(true, false, (_e346 == 2u));
                    } else {
                        phi_522_ = u32();
                        phi_523_ = 0u;
                        phi_525_ = true;
                    }
                    let _e350 = phi_522_;
                    let _e352 = phi_523_;
                    let _e354 = phi_525_;
                    if _e354 {
                        phi_530_ = (_e352 + 1u);
                    } else {
                        phi_530_ = 0u;
                    }
                    let _e358 = phi_530_;
                    let _e359 = select(_e350, _e352, _e354);
                    let _e360 = select(_e345, select(2u, _e345, _e344), _e354);
                    let _e361 = -(_e340);
                    if (_e361 < -126i) {
                        phi_562_ = -126i;
                    } else {
                        phi_562_ = select(_e361, 127i, (_e361 > 127i));
                    }
                    let _e366 = phi_562_;
                    let _e371 = bitcast<f32>((bitcast<u32>((_e366 + 127i)) << bitcast<u32>(23i)));
                    let _e377 = bitcast<f32>((bitcast<u32>(((_e361 - _e366) + 127i)) << bitcast<u32>(23i)));
                    let _e382 = global_8.member[_e144].member.member;
                    let _e383 = (_e359 == 0u);
                    if _e383 {
                        phi_580_ = _e382[0];
                    } else {
                        phi_580_ = _e382[1];
                    }
                    let _e387 = phi_580_;
                    let _e388 = (_e359 == 2u);
                    if _e388 {
                        phi_586_ = _e382[2];
                    } else {
                        phi_586_ = _e387;
                    }
                    let _e391 = phi_586_;
                    let _e392 = global_8.member[_e144].member.member_2;
                    if _e383 {
                        phi_597_ = _e392[0];
                    } else {
                        phi_597_ = _e392[1];
                    }
                    let _e396 = phi_597_;
                    if _e388 {
                        phi_603_ = _e392[2];
                    } else {
                        phi_603_ = _e396;
                    }
                    let _e399 = phi_603_;
                    let _e401 = ((_e399 * _e371) * _e377);
                    let _e405 = (bitcast<f32>((bitcast<u32>(_e401) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e405 {
                        let _e409 = (bitcast<f32>((bitcast<u32>(_e391) & 2147483647u)) * 0.00000011920929f);
                        phi_626_ = select(0.00000000000011368684f, _e409, (_e409 > 0.00000000000011368684f));
                    } else {
                        phi_626_ = 0f;
                    }
                    let _e413 = phi_626_;
                    let _e414 = (_e391 + _e413);
                    let _e415 = (_e391 - _e413);
                    let _e416 = select(_e401, 0f, _e405);
                    if _e405 {
                        phi_637_ = 38685626000000000000000000f;
                    } else {
                        phi_637_ = (1f / _e401);
                    }
                    let _e419 = phi_637_;
                    let _e420 = (_e358 == 0u);
                    if _e420 {
                        phi_646_ = _e382[0];
                    } else {
                        phi_646_ = _e382[1];
                    }
                    let _e424 = phi_646_;
                    let _e425 = (_e358 == 2u);
                    if _e425 {
                        phi_652_ = _e382[2];
                    } else {
                        phi_652_ = _e424;
                    }
                    let _e428 = phi_652_;
                    if _e420 {
                        phi_663_ = _e392[0];
                    } else {
                        phi_663_ = _e392[1];
                    }
                    let _e432 = phi_663_;
                    if _e425 {
                        phi_669_ = _e392[2];
                    } else {
                        phi_669_ = _e432;
                    }
                    let _e435 = phi_669_;
                    let _e437 = ((_e435 * _e371) * _e377);
                    let _e441 = (bitcast<f32>((bitcast<u32>(_e437) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e441 {
                        let _e445 = (bitcast<f32>((bitcast<u32>(_e428) & 2147483647u)) * 0.00000011920929f);
                        phi_692_ = select(0.00000000000011368684f, _e445, (_e445 > 0.00000000000011368684f));
                    } else {
                        phi_692_ = 0f;
                    }
                    let _e449 = phi_692_;
                    let _e450 = (_e428 + _e449);
                    let _e451 = (_e428 - _e449);
                    let _e452 = select(_e437, 0f, _e441);
                    if _e441 {
                        phi_703_ = 38685626000000000000000000f;
                    } else {
                        phi_703_ = (1f / _e437);
                    }
                    let _e455 = phi_703_;
                    let _e456 = (_e360 == 0u);
                    if _e456 {
                        phi_712_ = _e382[0];
                    } else {
                        phi_712_ = _e382[1];
                    }
                    let _e460 = phi_712_;
                    let _e461 = (_e360 == 2u);
                    if _e461 {
                        phi_718_ = _e382[2];
                    } else {
                        phi_718_ = _e460;
                    }
                    let _e464 = phi_718_;
                    if _e456 {
                        phi_729_ = _e392[0];
                    } else {
                        phi_729_ = _e392[1];
                    }
                    let _e468 = phi_729_;
                    if _e461 {
                        phi_735_ = _e392[2];
                    } else {
                        phi_735_ = _e468;
                    }
                    let _e471 = phi_735_;
                    let _e473 = ((_e471 * _e371) * _e377);
                    let _e477 = (bitcast<f32>((bitcast<u32>(_e473) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e477 {
                        let _e481 = (bitcast<f32>((bitcast<u32>(_e464) & 2147483647u)) * 0.00000011920929f);
                        phi_758_ = select(0.00000000000011368684f, _e481, (_e481 > 0.00000000000011368684f));
                    } else {
                        phi_758_ = 0f;
                    }
                    let _e485 = phi_758_;
                    let _e486 = (_e464 + _e485);
                    let _e487 = (_e464 - _e485);
                    let _e488 = select(_e473, 0f, _e477);
                    if _e477 {
                        phi_769_ = 38685626000000000000000000f;
                    } else {
                        phi_769_ = (1f / _e473);
                    }
                    let _e491 = phi_769_;
                    let _e494 = bitcast<f32>((bitcast<u32>(_e391) & 2147483647u));
                    let _e497 = bitcast<f32>((bitcast<u32>(_e428) & 2147483647u));
                    let _e499 = select(_e497, _e494, (_e494 > _e497));
                    let _e502 = bitcast<f32>((bitcast<u32>(_e464) & 2147483647u));
                    if (_e321 && (select(_e502, _e499, (_e499 > _e502)) <= 1099511600000f)) {
                        let _e507 = (_e340 / 3i);
                        let _e514 = bitcast<f32>((bitcast<u32>((_e507 + 127i)) << bitcast<u32>(23i)));
                        let _e521 = bitcast<f32>((bitcast<u32>(((_e340 - (2i * _e507)) + 127i)) << bitcast<u32>(23i)));
                        let _e522 = (((_e305 * _e514) * _e514) * _e521);
                        let _e524 = select(340282350000000000000000000000000000000f, _e522, (_e522 < 340282350000000000000000000000000000000f));
                        let _e529 = (((_e315 * _e514) * _e514) * _e521);
                        let _e531 = select(340282350000000000000000000000000000000f, _e529, (_e529 < 340282350000000000000000000000000000000f));
                        phi_869_ = select(-340282350000000000000000000000000000000f, _e531, (_e531 > -340282350000000000000000000000000000000f));
                        phi_870_ = select(-340282350000000000000000000000000000000f, _e524, (_e524 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_869_ = 0f;
                        phi_870_ = 1f;
                    }
                    let _e535 = phi_869_;
                    let _e537 = phi_870_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e541 = (_e359 % 3u);
                    let _e542 = (_e541 < 3u);
                    if _e542 {
                    } else {
                        break;
                    }
                    let _e544 = local_1[_e541];
                    let _e547 = (_e358 % 3u);
                    let _e548 = (_e547 < 3u);
                    if _e548 {
                    } else {
                        break;
                    }
                    let _e550 = local_1[_e547];
                    let _e553 = (_e360 % 3u);
                    let _e554 = (_e553 < 3u);
                    if _e554 {
                    } else {
                        break;
                    }
                    let _e556 = local_1[_e553];
                    if _e542 {
                    } else {
                        break;
                    }
                    let _e561 = local[_e541];
                    if _e548 {
                    } else {
                        break;
                    }
                    let _e565 = local[_e547];
                    if _e554 {
                    } else {
                        break;
                    }
                    let _e569 = local[_e553];
                    phi_3968_ = false;
                    phi_959_ = type_47(type_30(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e535);
                    phi_962_ = type_62(type_42(vec4<f32>((f32(_e544) * _e156), (f32(_e550) * _e156), (f32(_e556) * _e156), 0f), vec4<f32>((f32(_e561) * _e156), (f32(_e565) * _e156), (f32(_e569) * _e156), 0f)), select(0u, 2147483648u, (_e98 == 0u)));
                    phi_964_ = ((3u * _e98) + 1u);
                    phi_966_ = (_e537 <= _e535);
                    phi_968_ = 0u;
                    loop {
                        let _e579 = phi_3968_;
                        let _e581 = phi_959_;
                        let _e583 = phi_962_;
                        let _e585 = phi_964_;
                        let _e587 = phi_966_;
                        let _e589 = phi_968_;
                        local_10 = _e581;
                        if _e587 {
                            phi_979_ = true;
                        } else {
                            phi_979_ = (_e589 > 0u);
                        }
                        let _e592 = phi_979_;
                        if _e592 {
                            let _e593 = (_e585 > 0u);
                            if _e593 {
                                if _e587 {
                                    phi_1065_ = _e583;
                                    phi_1066_ = _e587;
                                    phi_1067_ = _e589;
                                } else {
                                    let _e594 = (_e589 - 1u);
                                    let _e595 = (_e594 % 128u);
                                    let _e596 = (_e595 < 128u);
                                    if _e596 {
                                    } else {
                                        phi_4128_ = true;
                                        break;
                                    }
                                    let _e598 = local_7[_e595];
                                    if _e596 {
                                    } else {
                                        phi_4128_ = true;
                                        break;
                                    }
                                    let _e600 = local_6[_e595];
                                    if _e596 {
                                    } else {
                                        phi_4128_ = true;
                                        break;
                                    }
                                    let _e602 = local_5[_e595];
                                    if _e596 {
                                    } else {
                                        phi_4128_ = true;
                                        break;
                                    }
                                    let _e604 = local_4[_e595];
                                    if _e596 {
                                    } else {
                                        phi_4128_ = true;
                                        break;
                                    }
                                    let _e606 = local_3[_e595];
                                    if _e596 {
                                    } else {
                                        phi_4128_ = true;
                                        break;
                                    }
                                    let _e608 = local_2[_e595];
                                    if _e596 {
                                    } else {
                                        phi_4128_ = true;
                                        break;
                                    }
                                    let _e613 = local_8[_e595];
                                    if _e596 {
                                    } else {
                                        phi_4128_ = true;
                                        break;
                                    }
                                    let _e616 = local_9[_e595];
                                    phi_1065_ = type_62(type_42(vec4<f32>(_e598, _e600, _e602, 0f), vec4<f32>(_e604, _e606, _e608, 0f)), _e613);
                                    phi_1066_ = (_e616 <= _e581.member_1);
                                    phi_1067_ = _e594;
                                }
                                let _e620 = phi_1065_;
                                let _e622 = phi_1066_;
                                let _e624 = phi_1067_;
                                if _e622 {
                                    if ((_e620.member_1 & 2147483648u) != 0u) {
                                        phi_1085_ = _e581;
                                        phi_1088_ = type_8(0u, ((_e620.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1068 = phi_1085_;
                                            let _e1070 = phi_1088_;
                                            local_11 = _e1068;
                                            if (_e1070.member < _e1070.member_1) {
                                                phi_1089_ = type_8((_e1070.member + 1u), _e1070.member_1);
                                                phi_1111_ = type_8(1u, _e1070.member);
                                            } else {
                                                phi_1089_ = _e1070;
                                                phi_1111_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1083 = phi_1089_;
                                            let _e1085 = phi_1111_;
                                            let _e1089 = (bitcast<i32>(_e1085.member) != 0i);
                                            if _e1089 {
                                                let _e1090 = ((_e620.member_1 & 268435455u) + _e1085.member_1);
                                                let _e1091 = (_e1090 < _e100);
                                                if _e1091 {
                                                    if _e1091 {
                                                    } else {
                                                        phi_3962_ = true;
                                                        break;
                                                    }
                                                    let _e1095 = global_5.member[_e1090].member_1;
                                                    phi_1132_ = _e1095;
                                                } else {
                                                    phi_1132_ = 4294967295u;
                                                }
                                                let _e1097 = phi_1132_;
                                                if (_e1090 >= _e100) {
                                                    phi_1221_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                } else {
                                                    if _e1091 {
                                                    } else {
                                                        phi_3962_ = true;
                                                        break;
                                                    }
                                                    if (_e541 < 9u) {
                                                    } else {
                                                        phi_3962_ = true;
                                                        break;
                                                    }
                                                    let _e1104 = global_5.member[_e1090].member[_e541];
                                                    if (_e547 < 9u) {
                                                    } else {
                                                        phi_3962_ = true;
                                                        break;
                                                    }
                                                    let _e1110 = global_5.member[_e1090].member[_e547];
                                                    if (_e553 < 9u) {
                                                    } else {
                                                        phi_3962_ = true;
                                                        break;
                                                    }
                                                    let _e1116 = global_5.member[_e1090].member[_e553];
                                                    let _e1118 = (3u + _e541);
                                                    if (_e1118 < 9u) {
                                                    } else {
                                                        phi_3962_ = true;
                                                        break;
                                                    }
                                                    let _e1124 = global_5.member[_e1090].member[_e1118];
                                                    let _e1125 = (3u + _e547);
                                                    if (_e1125 < 9u) {
                                                    } else {
                                                        phi_3962_ = true;
                                                        break;
                                                    }
                                                    let _e1131 = global_5.member[_e1090].member[_e1125];
                                                    let _e1132 = (3u + _e553);
                                                    if (_e1132 < 9u) {
                                                    } else {
                                                        phi_3962_ = true;
                                                        break;
                                                    }
                                                    let _e1138 = global_5.member[_e1090].member[_e1132];
                                                    let _e1140 = (6u + _e541);
                                                    if (_e1140 < 9u) {
                                                    } else {
                                                        phi_3962_ = true;
                                                        break;
                                                    }
                                                    let _e1146 = global_5.member[_e1090].member[_e1140];
                                                    let _e1147 = (6u + _e547);
                                                    if (_e1147 < 9u) {
                                                    } else {
                                                        phi_3962_ = true;
                                                        break;
                                                    }
                                                    let _e1153 = global_5.member[_e1090].member[_e1147];
                                                    let _e1154 = (6u + _e553);
                                                    if (_e1154 < 9u) {
                                                    } else {
                                                        phi_3962_ = true;
                                                        break;
                                                    }
                                                    let _e1160 = global_5.member[_e1090].member[_e1154];
                                                    phi_1221_ = array<array<f32, 3>, 3>(array<f32, 3>(_e1104, _e1110, _e1116), array<f32, 3>(_e1124, _e1131, _e1138), array<f32, 3>(_e1146, _e1153, _e1160));
                                                }
                                                let _e1164 = phi_1221_;
                                                let _e1172 = (_e1164[0][2] - _e464);
                                                let _e1175 = (((_e1164[0][0] - _e391) * _e488) - (_e1172 * _e416));
                                                let _e1178 = (((_e1164[0][1] - _e428) * _e488) - (_e1172 * _e452));
                                                let _e1185 = (_e1164[1][2] - _e464);
                                                let _e1188 = (((_e1164[1][0] - _e391) * _e488) - (_e1185 * _e416));
                                                let _e1191 = (((_e1164[1][1] - _e428) * _e488) - (_e1185 * _e452));
                                                let _e1198 = (_e1164[2][2] - _e464);
                                                let _e1201 = (((_e1164[2][0] - _e391) * _e488) - (_e1198 * _e416));
                                                let _e1204 = (((_e1164[2][1] - _e428) * _e488) - (_e1198 * _e452));
                                                let _e1205 = (_e1201 * _e1191);
                                                let _e1206 = (_e1204 * _e1188);
                                                let _e1207 = (_e1175 * _e1204);
                                                let _e1208 = (_e1178 * _e1201);
                                                let _e1209 = (_e1188 * _e1178);
                                                let _e1210 = (_e1191 * _e1175);
                                                let _e1215 = (((_e1205 >= _e1206) && (_e1207 >= _e1208)) && (_e1209 >= _e1210));
                                                if (_e1215 || (((_e1205 <= _e1206) && (_e1207 <= _e1208)) && (_e1209 <= _e1210))) {
                                                    let _e1222 = select(-1f, 1f, _e1215);
                                                    let _e1224 = ((_e1205 - _e1206) * _e1222);
                                                    let _e1226 = select(0f, _e1224, (_e1224 > 0f));
                                                    let _e1228 = ((_e1207 - _e1208) * _e1222);
                                                    let _e1230 = select(0f, _e1228, (_e1228 > 0f));
                                                    let _e1232 = ((_e1209 - _e1210) * _e1222);
                                                    let _e1234 = select(0f, _e1232, (_e1232 > 0f));
                                                    let _e1236 = ((_e1226 + _e1230) + _e1234);
                                                    if (_e1236 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2046_ = type_30();
                                                        phi_2047_ = true;
                                                        phi_2048_ = false;
                                                    } else {
                                                        let _e1239 = select(_e1188, _e1175, (_e1175 < _e1188));
                                                        if (select(_e1201, _e1239, (_e1239 < _e1201)) > 0f) {
                                                            phi_1338_ = true;
                                                        } else {
                                                            let _e1244 = select(_e1188, _e1175, (_e1175 > _e1188));
                                                            phi_1338_ = (select(_e1201, _e1244, (_e1244 > _e1201)) < 0f);
                                                        }
                                                        let _e1249 = phi_1338_;
                                                        if _e1249 {
                                                            phi_2043_ = type_30();
                                                            phi_2044_ = true;
                                                            phi_2045_ = false;
                                                        } else {
                                                            let _e1251 = select(_e1191, _e1178, (_e1178 < _e1191));
                                                            if (select(_e1204, _e1251, (_e1251 < _e1204)) > 0f) {
                                                                phi_1367_ = true;
                                                            } else {
                                                                let _e1256 = select(_e1191, _e1178, (_e1178 > _e1191));
                                                                phi_1367_ = (select(_e1204, _e1256, (_e1256 > _e1204)) < 0f);
                                                            }
                                                            let _e1261 = phi_1367_;
                                                            if _e1261 {
                                                                phi_2041_ = type_30();
                                                                phi_2042_ = false;
                                                            } else {
                                                                let _e1263 = select(_e1164[1][0], _e1164[0][0], (_e1164[0][0] < _e1164[1][0]));
                                                                let _e1267 = select(_e1164[1][0], _e1164[0][0], (_e1164[0][0] > _e1164[1][0]));
                                                                let _e1271 = select(_e1164[1][1], _e1164[0][1], (_e1164[0][1] < _e1164[1][1]));
                                                                let _e1275 = select(_e1164[1][1], _e1164[0][1], (_e1164[0][1] > _e1164[1][1]));
                                                                let _e1279 = select(_e1164[1][2], _e1164[0][2], (_e1164[0][2] < _e1164[1][2]));
                                                                let _e1283 = select(_e1164[1][2], _e1164[0][2], (_e1164[0][2] > _e1164[1][2]));
                                                                let _e1288 = ((select(_e1164[2][0], _e1263, (_e1263 < _e1164[2][0])) - _e414) * _e419);
                                                                let _e1289 = ((select(_e1164[2][0], _e1267, (_e1267 > _e1164[2][0])) - _e415) * _e419);
                                                                let _e1292 = ((select(_e1164[2][1], _e1271, (_e1271 < _e1164[2][1])) - _e450) * _e455);
                                                                let _e1293 = ((select(_e1164[2][1], _e1275, (_e1275 > _e1164[2][1])) - _e451) * _e455);
                                                                let _e1296 = ((select(_e1164[2][2], _e1279, (_e1279 < _e1164[2][2])) - _e486) * _e491);
                                                                let _e1297 = ((select(_e1164[2][2], _e1283, (_e1283 > _e1164[2][2])) - _e487) * _e491);
                                                                let _e1299 = select(_e1297, _e1296, (_e1296 < _e1297));
                                                                let _e1301 = select(_e1297, _e1296, (_e1296 > _e1297));
                                                                let _e1303 = select(_e1289, _e1288, (_e1288 < _e1289));
                                                                let _e1305 = select(_e1293, _e1292, (_e1292 < _e1293));
                                                                let _e1307 = select(_e1305, _e1303, (_e1303 > _e1305));
                                                                let _e1309 = select(_e1299, _e1307, (_e1307 > _e1299));
                                                                let _e1311 = select(_e1289, _e1288, (_e1288 > _e1289));
                                                                let _e1313 = select(_e1293, _e1292, (_e1292 > _e1293));
                                                                let _e1315 = select(_e1313, _e1311, (_e1311 < _e1313));
                                                                let _e1317 = select(_e1301, _e1315, (_e1315 < _e1301));
                                                                let _e1318 = -(_e1299);
                                                                let _e1324 = select(_e537, _e1309, (_e1309 > _e537));
                                                                if (_e1324 > (_e1317 + (select(_e1318, _e1301, (_e1301 > _e1318)) * 0.0000019073523f))) {
                                                                    phi_2036_ = type_30();
                                                                    phi_2037_ = true;
                                                                } else {
                                                                    let _e1326 = (_e1324 > _e1068.member_1);
                                                                    if _e1326 {
                                                                        phi_2035_ = type_30();
                                                                    } else {
                                                                        let _e1327 = vec3<f32>(_e1164[0][0], _e1164[0][1], _e1164[0][2]);
                                                                        let _e1328 = vec3<f32>(_e1164[1][0], _e1164[1][1], _e1164[1][2]);
                                                                        let _e1329 = vec3<f32>(_e1164[2][0], _e1164[2][1], _e1164[2][2]);
                                                                        let _e1330 = (_e1164[1][0] - _e1164[0][0]);
                                                                        let _e1331 = (_e1164[1][1] - _e1164[0][1]);
                                                                        let _e1332 = (_e1164[1][2] - _e1164[0][2]);
                                                                        let _e1333 = vec3<f32>(_e1330, _e1331, _e1332);
                                                                        let _e1334 = (_e1164[2][0] - _e1164[1][0]);
                                                                        let _e1335 = (_e1164[2][1] - _e1164[1][1]);
                                                                        let _e1336 = (_e1164[2][2] - _e1164[1][2]);
                                                                        let _e1337 = vec3<f32>(_e1334, _e1335, _e1336);
                                                                        let _e1338 = (_e1164[0][0] - _e1164[2][0]);
                                                                        let _e1339 = (_e1164[0][1] - _e1164[2][1]);
                                                                        let _e1340 = (_e1164[0][2] - _e1164[2][2]);
                                                                        let _e1341 = vec3<f32>(_e1338, _e1339, _e1340);
                                                                        let _e1344 = bitcast<f32>((bitcast<u32>(_e1330) & 2147483647u));
                                                                        let _e1347 = bitcast<f32>((bitcast<u32>(_e1331) & 2147483647u));
                                                                        let _e1349 = select(_e1347, _e1344, (_e1344 > _e1347));
                                                                        let _e1352 = bitcast<f32>((bitcast<u32>(_e1332) & 2147483647u));
                                                                        let _e1354 = select(_e1352, _e1349, (_e1349 > _e1352));
                                                                        let _e1357 = bitcast<f32>((bitcast<u32>(_e1334) & 2147483647u));
                                                                        let _e1360 = bitcast<f32>((bitcast<u32>(_e1335) & 2147483647u));
                                                                        let _e1362 = select(_e1360, _e1357, (_e1357 > _e1360));
                                                                        let _e1365 = bitcast<f32>((bitcast<u32>(_e1336) & 2147483647u));
                                                                        let _e1367 = select(_e1365, _e1362, (_e1362 > _e1365));
                                                                        let _e1370 = bitcast<f32>((bitcast<u32>(_e1338) & 2147483647u));
                                                                        let _e1373 = bitcast<f32>((bitcast<u32>(_e1339) & 2147483647u));
                                                                        let _e1375 = select(_e1373, _e1370, (_e1370 > _e1373));
                                                                        let _e1378 = bitcast<f32>((bitcast<u32>(_e1340) & 2147483647u));
                                                                        let _e1380 = select(_e1378, _e1375, (_e1375 > _e1378));
                                                                        let _e1382 = select(_e1367, _e1354, (_e1354 > _e1367));
                                                                        let _e1384 = select(_e1380, _e1382, (_e1382 > _e1380));
                                                                        if (_e1354 == _e1384) {
                                                                            phi_1768_ = _e1191;
                                                                            phi_1769_ = _e1188;
                                                                            phi_1770_ = _e1178;
                                                                            phi_1771_ = _e1175;
                                                                            phi_1772_ = _e1327;
                                                                            phi_1773_ = _e1341;
                                                                            phi_1774_ = _e1337;
                                                                            phi_1775_ = _e1333;
                                                                        } else {
                                                                            let _e1386 = (_e1367 == _e1384);
                                                                            let _e1391 = vec3(_e1386);
                                                                            phi_1768_ = select(_e1178, _e1204, _e1386);
                                                                            phi_1769_ = select(_e1175, _e1201, _e1386);
                                                                            phi_1770_ = select(_e1204, _e1191, _e1386);
                                                                            phi_1771_ = select(_e1201, _e1188, _e1386);
                                                                            phi_1772_ = select(_e1329, _e1328, _e1391);
                                                                            phi_1773_ = select(_e1337, _e1333, _e1391);
                                                                            phi_1774_ = select(_e1333, _e1341, _e1391);
                                                                            phi_1775_ = select(_e1341, _e1337, _e1391);
                                                                        }
                                                                        let _e1397 = phi_1768_;
                                                                        let _e1399 = phi_1769_;
                                                                        let _e1401 = phi_1770_;
                                                                        let _e1403 = phi_1771_;
                                                                        let _e1405 = phi_1772_;
                                                                        let _e1407 = phi_1773_;
                                                                        let _e1409 = phi_1774_;
                                                                        let _e1411 = phi_1775_;
                                                                        let _e1418 = ((_e1409.y * _e1407.z) - (_e1407.y * _e1409.z));
                                                                        let _e1423 = ((_e1409.z * _e1407.x) - (_e1407.z * _e1409.x));
                                                                        let _e1426 = ((_e1409.x * _e1407.y) - (_e1407.x * _e1409.y));
                                                                        if (_e1226 >= _e1230) {
                                                                            phi_1806_ = select(true, false, (_e1226 >= _e1234));
                                                                        } else {
                                                                            phi_1806_ = true;
                                                                        }
                                                                        let _e1431 = phi_1806_;
                                                                        if _e1431 {
                                                                            phi_1815_ = select(_e1329, _e1328, vec3((_e1230 >= _e1234)));
                                                                        } else {
                                                                            phi_1815_ = _e1327;
                                                                        }
                                                                        let _e1436 = phi_1815_;
                                                                        let _e1447 = (((_e1418 * (_e1436.x - _e391)) + (_e1423 * (_e1436.y - _e428))) + (_e1426 * (_e1436.z - _e464)));
                                                                        let _e1452 = (((_e1418 * _e416) + (_e1423 * _e452)) + (_e1426 * _e488));
                                                                        let _e1453 = (_e1399 - _e1403);
                                                                        let _e1454 = (_e1397 - _e1401);
                                                                        let _e1462 = (-(((_e1403 * _e1453) + (_e1401 * _e1454))) / ((_e1453 * _e1453) + (_e1454 * _e1454)));
                                                                        let _e1464 = select(1f, _e1462, (_e1462 < 1f));
                                                                        let _e1466 = select(0f, _e1464, (_e1464 > 0f));
                                                                        let _e1479 = ((_e1405.x + (_e1411.x * _e1466)) - _e391);
                                                                        let _e1480 = ((_e1405.y + (_e1411.y * _e1466)) - _e428);
                                                                        let _e1481 = ((_e1405.z + (_e1411.z * _e1466)) - _e464);
                                                                        let _e1482 = (_e1481 / _e488);
                                                                        let _e1494 = bitcast<f32>((bitcast<u32>(_e1479) & 2147483647u));
                                                                        let _e1497 = bitcast<f32>((bitcast<u32>(_e1480) & 2147483647u));
                                                                        let _e1499 = select(_e1497, _e1494, (_e1494 > _e1497));
                                                                        let _e1502 = bitcast<f32>((bitcast<u32>(_e1481) & 2147483647u));
                                                                        let _e1504 = select(_e1502, _e1499, (_e1499 > _e1502));
                                                                        let _e1510 = bitcast<f32>((bitcast<u32>(_e1418) & 2147483647u));
                                                                        let _e1513 = bitcast<f32>((bitcast<u32>(_e1423) & 2147483647u));
                                                                        let _e1515 = select(_e1513, _e1510, (_e1510 > _e1513));
                                                                        let _e1518 = bitcast<f32>((bitcast<u32>(_e1426) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1418 * _e1479) + (_e1423 * _e1480)) + (_e1426 * _e1481)) - _e1447)) & 2147483647u)) <= ((0.0000009536743f * select(_e1384, _e1504, (_e1504 > _e1384))) * select(_e1518, _e1515, (_e1515 > _e1518)))) {
                                                                            let _e1528 = bitcast<f32>((bitcast<u32>(_e1409.x) & 2147483647u));
                                                                            let _e1531 = bitcast<f32>((bitcast<u32>(_e1409.y) & 2147483647u));
                                                                            let _e1533 = select(_e1531, _e1528, (_e1528 > _e1531));
                                                                            let _e1536 = bitcast<f32>((bitcast<u32>(_e1409.z) & 2147483647u));
                                                                            let _e1542 = bitcast<f32>((bitcast<u32>(_e1407.x) & 2147483647u));
                                                                            let _e1545 = bitcast<f32>((bitcast<u32>(_e1407.y) & 2147483647u));
                                                                            let _e1547 = select(_e1545, _e1542, (_e1542 > _e1545));
                                                                            let _e1550 = bitcast<f32>((bitcast<u32>(_e1407.z) & 2147483647u));
                                                                            let _e1554 = (bitcast<f32>((bitcast<u32>(_e1452) & 2147483647u)) > ((0.0000038146973f * select(_e1536, _e1533, (_e1533 > _e1536))) * select(_e1550, _e1547, (_e1547 > _e1550))));
                                                                            if _e1554 {
                                                                                phi_1980_ = (_e1447 / _e1452);
                                                                            } else {
                                                                                phi_1980_ = f32();
                                                                            }
                                                                            let _e1557 = phi_1980_;
                                                                            phi_1982_ = _e1557;
                                                                            phi_1983_ = select(true, false, _e1554);
                                                                        } else {
                                                                            phi_1982_ = f32();
                                                                            phi_1983_ = true;
                                                                        }
                                                                        let _e1560 = phi_1982_;
                                                                        let _e1562 = phi_1983_;
                                                                        if _e1562 {
                                                                            let _e1570 = (((_e1418 * (_e1479 - (_e416 * _e1482))) + (_e1423 * (_e1480 - (_e452 * _e1482)))) / _e1452);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1570) & 2147483647u)) <= _e1384) {
                                                                                phi_2003_ = (_e1482 + _e1570);
                                                                            } else {
                                                                                phi_2003_ = _e1482;
                                                                            }
                                                                            let _e1577 = phi_2003_;
                                                                            phi_2004_ = _e1577;
                                                                        } else {
                                                                            phi_2004_ = _e1560;
                                                                        }
                                                                        let _e1579 = phi_2004_;
                                                                        let _e1581 = select(_e1317, _e1579, (_e1579 < _e1317));
                                                                        let _e1583 = select(_e1309, _e1581, (_e1581 > _e1309));
                                                                        if (_e1583 >= _e537) {
                                                                            let _e1585 = (_e1583 <= _e1068.member_1);
                                                                            if _e1585 {
                                                                                let _e1586 = (1f / _e1236);
                                                                                phi_2027_ = type_30(_e1583, (_e1230 * _e1586), (_e1234 * _e1586), _e1097);
                                                                            } else {
                                                                                phi_2027_ = type_30();
                                                                            }
                                                                            let _e1591 = phi_2027_;
                                                                            phi_2029_ = _e1591;
                                                                            phi_2030_ = select(true, false, _e1585);
                                                                        } else {
                                                                            phi_2029_ = type_30();
                                                                            phi_2030_ = true;
                                                                        }
                                                                        let _e1594 = phi_2029_;
                                                                        let _e1596 = phi_2030_;
                                                                        if _e1596 {
                                                                            phi_2034_ = type_30(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2034_ = _e1594;
                                                                        }
                                                                        let _e1598 = phi_2034_;
                                                                        phi_2035_ = _e1598;
                                                                    }
                                                                    let _e1600 = phi_2035_;
                                                                    phi_2036_ = _e1600;
                                                                    phi_2037_ = _e1326;
                                                                }
                                                                let _e1602 = phi_2036_;
                                                                let _e1604 = phi_2037_;
                                                                phi_2041_ = _e1602;
                                                                phi_2042_ = _e1604;
                                                            }
                                                            let _e1606 = phi_2041_;
                                                            let _e1608 = phi_2042_;
                                                            phi_2043_ = _e1606;
                                                            phi_2044_ = _e1261;
                                                            phi_2045_ = _e1608;
                                                        }
                                                        let _e1610 = phi_2043_;
                                                        let _e1612 = phi_2044_;
                                                        let _e1614 = phi_2045_;
                                                        phi_2046_ = _e1610;
                                                        phi_2047_ = _e1612;
                                                        phi_2048_ = _e1614;
                                                    }
                                                    let _e1616 = phi_2046_;
                                                    let _e1618 = phi_2047_;
                                                    let _e1620 = phi_2048_;
                                                    phi_2056_ = _e1616;
                                                    phi_2057_ = select(_e1620, true, _e1618);
                                                } else {
                                                    phi_2056_ = type_30();
                                                    phi_2057_ = true;
                                                }
                                                let _e1623 = phi_2056_;
                                                let _e1625 = phi_2057_;
                                                if _e1625 {
                                                    phi_2061_ = type_30(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2061_ = _e1623;
                                                }
                                                let _e1627 = phi_2061_;
                                                if (_e1627.member_3 != 4294967295u) {
                                                    if (_e1097 == _e165) {
                                                        phi_2390_ = false;
                                                    } else {
                                                        let _e1631 = (_e1097 < arrayLength((&global_6.member)));
                                                        if _e1631 {
                                                            if _e1631 {
                                                            } else {
                                                                phi_3962_ = true;
                                                                break;
                                                            }
                                                            let _e1633 = global_6.member[_e1097];
                                                            phi_2084_ = _e1633;
                                                        } else {
                                                            phi_2084_ = 4294967295u;
                                                        }
                                                        let _e1635 = phi_2084_;
                                                        let _e1636 = (_e1635 < arrayLength((&global_7.member)));
                                                        if _e1636 {
                                                            if _e1636 {
                                                            } else {
                                                                phi_3962_ = true;
                                                                break;
                                                            }
                                                            let _e1638 = global_7.member[_e1635];
                                                            phi_2098_ = _e1638;
                                                        } else {
                                                            phi_2098_ = 0i;
                                                        }
                                                        let _e1640 = phi_2098_;
                                                        let _e1641 = (_e1640 == 0i);
                                                        if _e1641 {
                                                            phi_2389_ = true;
                                                        } else {
                                                            if _e383 {
                                                                phi_2119_ = vec3<f32>(_e1164[0][0], _e1164[0][1], _e1164[0][2]);
                                                            } else {
                                                                if (_e359 == 1u) {
                                                                    phi_2118_ = vec3<f32>(_e1164[0][2], _e1164[0][0], _e1164[0][1]);
                                                                } else {
                                                                    phi_2118_ = vec3<f32>(_e1164[0][1], _e1164[0][2], _e1164[0][0]);
                                                                }
                                                                let _e1646 = phi_2118_;
                                                                phi_2119_ = _e1646;
                                                            }
                                                            let _e1649 = phi_2119_;
                                                            if _e383 {
                                                                phi_2136_ = vec3<f32>(_e1164[1][0], _e1164[1][1], _e1164[1][2]);
                                                            } else {
                                                                if (_e359 == 1u) {
                                                                    phi_2135_ = vec3<f32>(_e1164[1][2], _e1164[1][0], _e1164[1][1]);
                                                                } else {
                                                                    phi_2135_ = vec3<f32>(_e1164[1][1], _e1164[1][2], _e1164[1][0]);
                                                                }
                                                                let _e1654 = phi_2135_;
                                                                phi_2136_ = _e1654;
                                                            }
                                                            let _e1657 = phi_2136_;
                                                            if _e383 {
                                                                phi_2153_ = vec3<f32>(_e1164[2][0], _e1164[2][1], _e1164[2][2]);
                                                            } else {
                                                                if (_e359 == 1u) {
                                                                    phi_2152_ = vec3<f32>(_e1164[2][2], _e1164[2][0], _e1164[2][1]);
                                                                } else {
                                                                    phi_2152_ = vec3<f32>(_e1164[2][1], _e1164[2][2], _e1164[2][0]);
                                                                }
                                                                let _e1662 = phi_2152_;
                                                                phi_2153_ = _e1662;
                                                            }
                                                            let _e1665 = phi_2153_;
                                                            let _e1668 = (_e1657.x - _e1649.x);
                                                            let _e1671 = (_e1657.y - _e1649.y);
                                                            let _e1674 = (_e1657.z - _e1649.z);
                                                            let _e1676 = (_e1665.x - _e1649.x);
                                                            let _e1678 = (_e1665.y - _e1649.y);
                                                            let _e1680 = (_e1665.z - _e1649.z);
                                                            if (_e237.member_1 == 1u) {
                                                                phi_2189_ = (vec3<f32>(_e237.member[0], _e237.member[1], _e237.member[2]) - _e1649);
                                                            } else {
                                                                phi_2189_ = vec3<f32>(_e237.member[0], _e237.member[1], _e237.member[2]);
                                                            }
                                                            let _e1695 = phi_2189_;
                                                            let _e1701 = bitcast<f32>((bitcast<u32>((_e1668 * _e1678)) ^ _e237.member_3[0]));
                                                            let _e1705 = bitcast<f32>((bitcast<u32>((_e1671 * _e1676)) ^ _e237.member_3[0]));
                                                            let _e1709 = bitcast<f32>((bitcast<u32>((_e1671 * _e1680)) ^ _e237.member_3[0]));
                                                            let _e1713 = bitcast<f32>((bitcast<u32>((_e1674 * _e1678)) ^ _e237.member_3[0]));
                                                            let _e1717 = bitcast<f32>((bitcast<u32>((_e1674 * _e1676)) ^ _e237.member_3[0]));
                                                            let _e1721 = bitcast<f32>((bitcast<u32>((_e1668 * _e1680)) ^ _e237.member_3[0]));
                                                            let _e1722 = (_e1709 - _e1713);
                                                            let _e1723 = (_e1717 - _e1721);
                                                            let _e1724 = (_e1701 - _e1705);
                                                            let _e1748 = (bitcast<f32>((bitcast<u32>(_e1709) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1713) & 2147483647u)));
                                                            let _e1755 = (bitcast<f32>((bitcast<u32>(_e1717) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1721) & 2147483647u)));
                                                            let _e1762 = (bitcast<f32>((bitcast<u32>(_e1701) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1705) & 2147483647u)));
                                                            if (_e237.member_2 == 0f) {
                                                                phi_2371_ = 0f;
                                                            } else {
                                                                let _e1792 = bitcast<f32>((bitcast<u32>(_e1722) & 2147483647u));
                                                                let _e1795 = bitcast<f32>((bitcast<u32>(_e1723) & 2147483647u));
                                                                let _e1798 = bitcast<f32>((bitcast<u32>(_e1724) & 2147483647u));
                                                                let _e1800 = select(_e1798, _e1795, (_e1795 > _e1798));
                                                                let _e1804 = select(_e1798, _e1795, (_e1795 < _e1798));
                                                                let _e1808 = select(_e1795, _e1792, (_e1792 < _e1795));
                                                                let _e1810 = select(_e1795, _e1792, (_e1792 > _e1795));
                                                                let _e1812 = select(_e1798, _e1810, (_e1810 < _e1798));
                                                                phi_2371_ = bitcast<f32>((bitcast<u32>((_e237.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1800, _e1792, (_e1792 > _e1800)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1812, _e1808, (_e1808 > _e1812)))) ^ _e237.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1804, _e1792, (_e1792 < _e1804)))) ^ _e237.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1748 + _e1755) + _e1762))) ^ _e237.member_3[0]))) * 1.0000005f)) ^ _e237.member_3[0])))) ^ _e237.member_3[0]));
                                                            }
                                                            let _e1839 = phi_2371_;
                                                            phi_2389_ = (_e1641 || !(((((bitcast<f32>((bitcast<u32>((_e1695.x * _e1722)) ^ _e237.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1695.y * _e1723)) ^ _e237.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1695.z * _e1724)) ^ _e237.member_3[0]))) * f32(-(_e1640))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1695.x) & 2147483647u)) * _e1748)) ^ _e237.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1695.y) & 2147483647u)) * _e1755)) ^ _e237.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1695.z) & 2147483647u)) * _e1762)) ^ _e237.member_3[0]))))) ^ _e237.member_3[0])) + _e1839) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1853 = phi_2389_;
                                                        phi_2390_ = _e1853;
                                                    }
                                                    let _e1855 = phi_2390_;
                                                    if _e1855 {
                                                        if (_e1627.member < _e1068.member.member) {
                                                            phi_2410_ = true;
                                                        } else {
                                                            if (_e1627.member == _e1068.member.member) {
                                                                phi_2409_ = (_e1627.member_3 < _e1068.member.member_3);
                                                            } else {
                                                                phi_2409_ = false;
                                                            }
                                                            let _e1865 = phi_2409_;
                                                            phi_2410_ = _e1865;
                                                        }
                                                        let _e1867 = phi_2410_;
                                                        if _e1867 {
                                                            phi_2416_ = type_47(_e1627, _e1627.member);
                                                        } else {
                                                            phi_2416_ = _e1068;
                                                        }
                                                        let _e1870 = phi_2416_;
                                                        phi_2417_ = _e1870;
                                                    } else {
                                                        phi_2417_ = _e1068;
                                                    }
                                                    let _e1872 = phi_2417_;
                                                    phi_2418_ = _e1872;
                                                } else {
                                                    phi_2418_ = _e1068;
                                                }
                                                let _e1874 = phi_2418_;
                                                phi_1086_ = _e1874;
                                            } else {
                                                phi_1086_ = type_47();
                                            }
                                            let _e1876 = phi_1086_;
                                            continue;
                                            continuing {
                                                phi_1085_ = _e1876;
                                                phi_1088_ = _e1083;
                                                phi_3962_ = _e579;
                                                break if !(_e1089);
                                            }
                                        }
                                        let _e1879 = phi_3962_;
                                        phi_4128_ = _e1879;
                                        if _e1879 {
                                            break;
                                        }
                                        phi_4132_ = _e1879;
                                        let _e2113 = local_11;
                                        phi_3623_ = _e2113;
                                        phi_3624_ = _e620;
                                        phi_3625_ = false;
                                        phi_3626_ = _e624;
                                    } else {
                                        if (_e620.member_1 >= _e98) {
                                            phi_3179_ = type_63(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_62(type_42(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_62(type_42(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e620.member_1 < _e98) {
                                            } else {
                                                phi_4128_ = true;
                                                break;
                                            }
                                            let _e636 = ((1u + _e359) % 4u);
                                            if (_e636 < 4u) {
                                            } else {
                                                phi_4128_ = true;
                                                break;
                                            }
                                            let _e641 = global_4.member[_e620.member_1][_e636];
                                            let _e643 = (_e641 >> bitcast<u32>(11u));
                                            let _e645 = ((1u + _e358) % 4u);
                                            if (_e645 < 4u) {
                                            } else {
                                                phi_4128_ = true;
                                                break;
                                            }
                                            let _e650 = global_4.member[_e620.member_1][_e645];
                                            let _e652 = (_e650 >> bitcast<u32>(11u));
                                            let _e654 = ((1u + _e360) % 4u);
                                            if (_e654 < 4u) {
                                            } else {
                                                phi_4128_ = true;
                                                break;
                                            }
                                            let _e659 = global_4.member[_e620.member_1][_e654];
                                            let _e661 = (_e659 >> bitcast<u32>(11u));
                                            let _e684 = (bitcast<f32>((bitcast<u32>((_e620.member.member_1.x - _e620.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e685 = (bitcast<f32>((bitcast<u32>((_e620.member.member_1.y - _e620.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e686 = (bitcast<f32>((bitcast<u32>((_e620.member.member_1.z - _e620.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e688 = select(_e156, _e684, (_e684 > _e156));
                                            let _e690 = select(_e156, _e685, (_e685 > _e156));
                                            let _e692 = select(_e156, _e686, (_e686 > _e156));
                                            let _e717 = bitcast<u32>((f32(bitcast<i32>((_e641 & 1023u))) * _e688));
                                            let _e722 = (bitcast<i32>((_e641 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e725 = bitcast<f32>((_e717 & bitcast<u32>(_e722)));
                                            let _e726 = bitcast<u32>((f32(bitcast<i32>((_e650 & 1023u))) * _e690));
                                            let _e731 = (bitcast<i32>((_e650 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e734 = bitcast<f32>((_e726 & bitcast<u32>(_e731)));
                                            let _e735 = bitcast<u32>((f32(bitcast<i32>((_e659 & 1023u))) * _e692));
                                            let _e740 = (bitcast<i32>((_e659 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e743 = bitcast<f32>((_e735 & bitcast<u32>(_e740)));
                                            let _e747 = bitcast<f32>((_e717 & bitcast<u32>(~(_e722))));
                                            let _e751 = bitcast<f32>((_e726 & bitcast<u32>(~(_e731))));
                                            let _e755 = bitcast<f32>((_e735 & bitcast<u32>(~(_e740))));
                                            let _e756 = bitcast<u32>((f32(bitcast<i32>((_e643 & 1023u))) * _e688));
                                            let _e761 = (bitcast<i32>((_e643 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e764 = bitcast<f32>((_e756 & bitcast<u32>(_e761)));
                                            let _e765 = bitcast<u32>((f32(bitcast<i32>((_e652 & 1023u))) * _e690));
                                            let _e770 = (bitcast<i32>((_e652 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e773 = bitcast<f32>((_e765 & bitcast<u32>(_e770)));
                                            let _e774 = bitcast<u32>((f32(bitcast<i32>((_e661 & 1023u))) * _e692));
                                            let _e779 = (bitcast<i32>((_e661 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e782 = bitcast<f32>((_e774 & bitcast<u32>(_e779)));
                                            let _e786 = bitcast<f32>((_e756 & bitcast<u32>(~(_e761))));
                                            let _e790 = bitcast<f32>((_e765 & bitcast<u32>(~(_e770))));
                                            let _e794 = bitcast<f32>((_e774 & bitcast<u32>(~(_e779))));
                                            let _e824 = global_4.member[_e620.member_1][0u];
                                            let _e828 = global_4.member[_e620.member_1][1u];
                                            let _e832 = global_4.member[_e620.member_1][2u];
                                            let _e836 = global_4.member[_e620.member_1][3u];
                                            let _e848 = (((_e828 >> bitcast<u32>(22i)) | ((_e832 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e836 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e849 = (_e824 & 268435455u);
                                            let _e850 = (_e848 & 268435455u);
                                            let _e853 = ((_e824 >> bitcast<u32>(28u)) & 7u);
                                            let _e861 = ((_e824 >> bitcast<u32>(31i)) | (((_e848 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e862 = (_e853 != 0u);
                                            if (_e853 == 0u) {
                                                phi_3141_ = _e849;
                                            } else {
                                                if (_e853 == 7u) {
                                                    phi_3140_ = 2147483648u;
                                                } else {
                                                    phi_3140_ = ((2147483648u | (_e853 << bitcast<u32>(28u))) | (_e850 & 268435455u));
                                                }
                                                let _e871 = phi_3140_;
                                                phi_3141_ = _e871;
                                            }
                                            let _e873 = phi_3141_;
                                            if _e862 {
                                                let _e874 = (_e853 != 7u);
                                                if _e874 {
                                                    phi_3151_ = (_e850 + _e853);
                                                } else {
                                                    phi_3151_ = u32();
                                                }
                                                let _e877 = phi_3151_;
                                                phi_3153_ = _e877;
                                                phi_3154_ = select(true, false, _e874);
                                            } else {
                                                phi_3153_ = u32();
                                                phi_3154_ = true;
                                            }
                                            let _e880 = phi_3153_;
                                            let _e882 = phi_3154_;
                                            if (_e861 == 0u) {
                                                phi_3175_ = (_e849 + select(0u, 1u, !(_e862)));
                                            } else {
                                                if (_e861 == 7u) {
                                                    phi_3174_ = 2147483648u;
                                                } else {
                                                    phi_3174_ = ((2147483648u | (_e861 << bitcast<u32>(28u))) | (select(_e880, _e850, _e882) & 268435455u));
                                                }
                                                let _e895 = phi_3174_;
                                                phi_3175_ = _e895;
                                            }
                                            let _e897 = phi_3175_;
                                            phi_3179_ = type_63(array<vec4<f32>, 3>(vec4<f32>((_e620.member.member.x + _e725), (_e620.member.member.x + _e747), (_e620.member.member_1.x - _e764), (_e620.member.member_1.x - _e786)), vec4<f32>((_e620.member.member.y + _e734), (_e620.member.member.y + _e751), (_e620.member.member_1.y - _e773), (_e620.member.member_1.y - _e790)), vec4<f32>((_e620.member.member.z + _e743), (_e620.member.member.z + _e755), (_e620.member.member_1.z - _e782), (_e620.member.member_1.z - _e794))), type_62(type_42((_e620.member.member + vec4<f32>(_e725, _e734, _e743, 0f)), (_e620.member.member_1 - vec4<f32>(_e764, _e773, _e782, 0f))), _e873), type_62(type_42((_e620.member.member + vec4<f32>(_e747, _e751, _e755, 0f)), (_e620.member.member_1 - vec4<f32>(_e786, _e790, _e794, 0f))), _e897));
                                        }
                                        let _e902 = phi_3179_;
                                        let _e914 = ((_e902.member[0].x - _e414) * _e419);
                                        let _e915 = ((_e902.member[0].y - _e414) * _e419);
                                        let _e916 = ((_e902.member[0].z - _e415) * _e419);
                                        let _e917 = ((_e902.member[0].w - _e415) * _e419);
                                        let _e927 = ((_e902.member[1].x - _e450) * _e455);
                                        let _e928 = ((_e902.member[1].y - _e450) * _e455);
                                        let _e929 = ((_e902.member[1].z - _e451) * _e455);
                                        let _e930 = ((_e902.member[1].w - _e451) * _e455);
                                        let _e940 = ((_e902.member[2].x - _e486) * _e491);
                                        let _e941 = ((_e902.member[2].y - _e486) * _e491);
                                        let _e942 = ((_e902.member[2].z - _e487) * _e491);
                                        let _e943 = ((_e902.member[2].w - _e487) * _e491);
                                        let _e945 = select(_e942, _e940, (_e940 < _e942));
                                        let _e947 = select(_e943, _e941, (_e941 < _e943));
                                        let _e949 = select(_e942, _e940, (_e940 > _e942));
                                        let _e951 = select(_e943, _e941, (_e941 > _e943));
                                        let _e953 = select(_e916, _e914, (_e914 < _e916));
                                        let _e955 = select(_e917, _e915, (_e915 < _e917));
                                        let _e957 = select(_e929, _e927, (_e927 < _e929));
                                        let _e959 = select(_e930, _e928, (_e928 < _e930));
                                        let _e961 = select(_e957, _e953, (_e953 > _e957));
                                        let _e963 = select(_e959, _e955, (_e955 > _e959));
                                        let _e965 = select(_e945, _e961, (_e961 > _e945));
                                        let _e967 = select(_e947, _e963, (_e963 > _e947));
                                        let _e969 = select(_e916, _e914, (_e914 > _e916));
                                        let _e971 = select(_e917, _e915, (_e915 > _e917));
                                        let _e973 = select(_e929, _e927, (_e927 > _e929));
                                        let _e975 = select(_e930, _e928, (_e928 > _e930));
                                        let _e977 = select(_e973, _e969, (_e969 < _e973));
                                        let _e979 = select(_e975, _e971, (_e971 < _e975));
                                        let _e984 = -(_e945);
                                        let _e985 = -(_e947);
                                        let _e992 = (select(_e949, _e977, (_e977 < _e949)) + (select(_e984, _e949, (_e949 > _e984)) * 0.0000019073523f));
                                        let _e993 = (select(_e951, _e979, (_e979 < _e951)) + (select(_e985, _e951, (_e951 > _e985)) * 0.0000019073523f));
                                        let _e995 = select(_e537, _e965, (_e965 > _e537));
                                        let _e997 = select(_e537, _e967, (_e967 > _e537));
                                        let _e1002 = (_e995 <= select(_e581.member_1, _e992, (_e992 < _e581.member_1)));
                                        let _e1003 = (_e997 <= select(_e581.member_1, _e993, (_e993 < _e581.member_1)));
                                        let _e1004 = (_e995 <= _e997);
                                        if _e1002 {
                                            if _e1003 {
                                                if _e1004 {
                                                    phi_3523_ = _e902.member_2;
                                                } else {
                                                    phi_3523_ = _e902.member_1;
                                                }
                                                let _e1008 = phi_3523_;
                                                let _e1030 = (_e624 % 128u);
                                                let _e1031 = (_e1030 < 128u);
                                                if _e1031 {
                                                } else {
                                                    phi_4128_ = true;
                                                    break;
                                                }
                                                local_8[_e1030] = _e1008.member_1;
                                                if _e1031 {
                                                } else {
                                                    phi_4128_ = true;
                                                    break;
                                                }
                                                local_7[_e1030] = _e1008.member.member.x;
                                                if _e1031 {
                                                } else {
                                                    phi_4128_ = true;
                                                    break;
                                                }
                                                local_6[_e1030] = _e1008.member.member.y;
                                                if _e1031 {
                                                } else {
                                                    phi_4128_ = true;
                                                    break;
                                                }
                                                local_5[_e1030] = _e1008.member.member.z;
                                                if _e1031 {
                                                } else {
                                                    phi_4128_ = true;
                                                    break;
                                                }
                                                local_4[_e1030] = _e1008.member.member_1.x;
                                                if _e1031 {
                                                } else {
                                                    phi_4128_ = true;
                                                    break;
                                                }
                                                local_3[_e1030] = _e1008.member.member_1.y;
                                                if _e1031 {
                                                } else {
                                                    phi_4128_ = true;
                                                    break;
                                                }
                                                local_2[_e1030] = _e1008.member.member_1.z;
                                                if _e1031 {
                                                } else {
                                                    phi_4128_ = true;
                                                    break;
                                                }
                                                local_9[_e1030] = select(_e997, _e995, (_e995 > _e997));
                                                if _e1004 {
                                                    phi_3600_ = _e902.member_1;
                                                } else {
                                                    phi_3600_ = _e902.member_2;
                                                }
                                                let _e1044 = phi_3600_;
                                                phi_3601_ = _e1044;
                                                phi_3602_ = (_e624 + 1u);
                                            } else {
                                                phi_3601_ = type_62();
                                                phi_3602_ = u32();
                                            }
                                            let _e1046 = phi_3601_;
                                            let _e1048 = phi_3602_;
                                            phi_3604_ = _e1046;
                                            phi_3605_ = _e1048;
                                            phi_3606_ = select(true, false, _e1003);
                                        } else {
                                            phi_3604_ = type_62();
                                            phi_3605_ = u32();
                                            phi_3606_ = true;
                                        }
                                        let _e1051 = phi_3604_;
                                        let _e1053 = phi_3605_;
                                        let _e1055 = phi_3606_;
                                        if _e1055 {
                                            if _e1002 {
                                                phi_3615_ = _e902.member_1;
                                            } else {
                                                phi_3615_ = _e902.member_2;
                                            }
                                            let _e1059 = phi_3615_;
                                            phi_3620_ = _e1059;
                                            phi_3621_ = select(_e1003, true, _e1002);
                                        } else {
                                            phi_3620_ = _e1051;
                                            phi_3621_ = _e622;
                                        }
                                        let _e1062 = phi_3620_;
                                        let _e1064 = phi_3621_;
                                        phi_4132_ = _e579;
                                        phi_3623_ = _e581;
                                        phi_3624_ = _e1062;
                                        phi_3625_ = _e1064;
                                        phi_3626_ = select(_e1053, _e624, _e1055);
                                    }
                                    let _e1881 = phi_4132_;
                                    let _e1883 = phi_3623_;
                                    let _e1885 = phi_3624_;
                                    let _e1887 = phi_3625_;
                                    let _e1889 = phi_3626_;
                                    phi_4131_ = _e1881;
                                    phi_3627_ = _e1883;
                                    phi_3628_ = _e1885;
                                    phi_3629_ = (_e585 - 1u);
                                    phi_3630_ = _e1887;
                                    phi_3631_ = _e1889;
                                } else {
                                    phi_4131_ = _e579;
                                    phi_3627_ = _e581;
                                    phi_3628_ = _e620;
                                    phi_3629_ = _e585;
                                    phi_3630_ = _e622;
                                    phi_3631_ = _e624;
                                }
                                let _e1891 = phi_4131_;
                                let _e1893 = phi_3627_;
                                let _e1895 = phi_3628_;
                                let _e1897 = phi_3629_;
                                let _e1899 = phi_3630_;
                                let _e1901 = phi_3631_;
                                phi_4130_ = _e1891;
                                phi_3632_ = _e1893;
                                phi_3633_ = _e1895;
                                phi_3634_ = _e1897;
                                phi_3635_ = _e1899;
                                phi_3636_ = _e1901;
                            } else {
                                phi_4130_ = _e579;
                                phi_3632_ = type_47();
                                phi_3633_ = type_62();
                                phi_3634_ = u32();
                                phi_3635_ = bool();
                                phi_3636_ = u32();
                            }
                            let _e1903 = phi_4130_;
                            let _e1905 = phi_3632_;
                            let _e1907 = phi_3633_;
                            let _e1909 = phi_3634_;
                            let _e1911 = phi_3635_;
                            let _e1913 = phi_3636_;
                            phi_4129_ = _e1903;
                            phi_960_ = _e1905;
                            phi_963_ = _e1907;
                            phi_965_ = _e1909;
                            phi_967_ = _e1911;
                            phi_969_ = _e1913;
                            phi_3637_ = _e593;
                        } else {
                            phi_4129_ = _e579;
                            phi_960_ = type_47();
                            phi_963_ = type_62();
                            phi_965_ = u32();
                            phi_967_ = bool();
                            phi_969_ = u32();
                            phi_3637_ = false;
                        }
                        let _e1915 = phi_4129_;
                        let _e1917 = phi_960_;
                        let _e1919 = phi_963_;
                        let _e1921 = phi_965_;
                        let _e1923 = phi_967_;
                        let _e1925 = phi_969_;
                        let _e1927 = phi_3637_;
                        continue;
                        continuing {
                            phi_3968_ = _e1915;
                            phi_959_ = _e1917;
                            phi_962_ = _e1919;
                            phi_964_ = _e1921;
                            phi_966_ = _e1923;
                            phi_968_ = _e1925;
                            phi_4128_ = _e1915;
                            break if !(_e1927);
                        }
                    }
                    let _e1930 = phi_4128_;
                    if _e1930 {
                        break;
                    }
                    let _e1932 = local_10;
                    if (_e1932.member.member_3 != 4294967295u) {
                        let _e1937 = (_e361 / 3i);
                        let _e1944 = bitcast<f32>((bitcast<u32>((_e1937 + 127i)) << bitcast<u32>(23i)));
                        let _e1952 = (((_e1932.member.member * _e1944) * _e1944) * bitcast<f32>((bitcast<u32>(((_e361 - (2i * _e1937)) + 127i)) << bitcast<u32>(23i))));
                        let _e1954 = select(340282350000000000000000000000000000000f, _e1952, (_e1952 < 340282350000000000000000000000000000000f));
                        phi_3689_ = type_30(select(-340282350000000000000000000000000000000f, _e1954, (_e1954 > -340282350000000000000000000000000000000f)), _e1932.member.member_1, _e1932.member.member_2, _e1932.member.member_3);
                    } else {
                        phi_3689_ = type_30(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1961 = phi_3689_;
                    if _e238 {
                    } else {
                        break;
                    }
                    global_9.member[_e144] = _e1961;
                    if _e159 {
                    } else {
                        break;
                    }
                    let _e1965 = select(0u, 1u, (_e305 <= _e315));
                    if (_e1965 > 0u) {
                        let _e1967 = (1u < _e112);
                        if _e1967 {
                            if (0u < _e112) {
                            } else {
                                break;
                            }
                            let _e1971 = atomicAdd((&global_10.member[0u]), _e1965);
                            if ((_e1971 + _e1965) < _e1971) {
                                if _e1967 {
                                } else {
                                    break;
                                }
                                let _e1976 = atomicAdd((&global_10.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1979 = select(0u, 1u, (_e1961.member_3 != 4294967295u));
                    if (_e1979 > 0u) {
                        let _e1981 = (3u < _e112);
                        if _e1981 {
                            if (2u < _e112) {
                            } else {
                                break;
                            }
                            let _e1985 = atomicAdd((&global_10.member[2u]), _e1979);
                            if ((_e1985 + _e1979) < _e1985) {
                                if _e1981 {
                                } else {
                                    break;
                                }
                                let _e1990 = atomicAdd((&global_10.member[3u]), 1u);
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
fn trace_paths_q10_f32_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
