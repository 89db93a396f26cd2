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

struct type_35 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_38 {
    member: type_22,
    member_1: f32,
}

struct type_41 {
    member: array<vec4<u32>, 2>,
}

struct type_44 {
    member: array<i32>,
}

struct type_48 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_50 {
    member: array<type_48>,
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

struct type_69 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_41;
@group(0) @binding(2) 
var<uniform> global_3: type_41;
@group(0) @binding(5) 
var<storage> global_4: type_4;
@group(0) @binding(6) 
var<storage> global_5: type_44;
@group(0) @binding(7) 
var<storage> global_6: type_29;
@group(0) @binding(8) 
var<storage, read_write> global_7: type_24;
@group(0) @binding(9) 
var<storage, read_write> global_8: type_69;
@group(0) @binding(3) 
var<storage> global_9: type_50;
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
    var local_7: array<f32, 3>;
    var local_8: array<f32, 3>;
    var local_9: array<f32, 3>;
    var local_10: array<f32, 3>;
    var local_11: array<f32, 128>;
    var local_12: array<f32, 3>;
    var local_13: array<f32, 3>;
    var local_14: array<f32, 3>;
    var local_15: array<f32, 3>;
    var local_16: array<u32, 3>;
    var local_17: array<u32, 3>;
    var local_18: array<u32, 3>;
    var local_19: array<array<f32, 3>, 3>;
    var local_20: array<u32, 3>;
    var local_21: array<f32, 3>;
    var local_22: array<f32, 3>;
    var phi_289_: u32;
    var phi_333_: i32;
    var phi_357_: type_35;
    var phi_463_: i32;
    var phi_464_: i32;
    var phi_474_: bool;
    var phi_484_: u32;
    var phi_485_: u32;
    var phi_487_: bool;
    var phi_492_: u32;
    var phi_525_: i32;
    var phi_543_: f32;
    var phi_549_: f32;
    var phi_560_: f32;
    var phi_566_: f32;
    var phi_589_: f32;
    var phi_600_: f32;
    var phi_609_: f32;
    var phi_615_: f32;
    var phi_626_: f32;
    var phi_632_: f32;
    var phi_655_: f32;
    var phi_666_: f32;
    var phi_675_: f32;
    var phi_681_: f32;
    var phi_692_: f32;
    var phi_698_: f32;
    var phi_721_: f32;
    var phi_732_: f32;
    var phi_832_: f32;
    var phi_833_: f32;
    var phi_3339_: bool;
    var phi_906_: type_38;
    var phi_909_: type_62;
    var phi_911_: u32;
    var phi_913_: bool;
    var phi_915_: u32;
    var phi_926_: bool;
    var phi_1012_: type_62;
    var phi_1013_: bool;
    var phi_1014_: u32;
    var phi_2253_: type_48;
    var phi_2262_: type_8;
    var phi_2263_: type_8;
    var phi_2286_: type_8;
    var phi_3332_: bool;
    var phi_2416_: type_8;
    var phi_2417_: type_8;
    var phi_2440_: type_8;
    var phi_3396_: bool;
    var phi_3003_: type_62;
    var phi_3080_: type_62;
    var phi_3081_: type_62;
    var phi_3082_: u32;
    var phi_3084_: type_62;
    var phi_3085_: u32;
    var phi_3086_: bool;
    var phi_3093_: type_62;
    var phi_3098_: type_62;
    var phi_3099_: bool;
    var phi_3413_: bool;
    var phi_1033_: type_38;
    var phi_1036_: type_8;
    var phi_1037_: type_8;
    var phi_1059_: type_8;
    var phi_1101_: u32;
    var phi_1125_: type_56;
    var phi_3409_: bool;
    var phi_1136_: type_8;
    var phi_1137_: type_8;
    var phi_1160_: type_8;
    var phi_1170_: type_8;
    var phi_1171_: type_8;
    var phi_1194_: type_8;
    var phi_3404_: bool;
    var phi_3417_: bool;
    var phi_3416_: bool;
    var phi_1757_: vec3<f32>;
    var phi_1758_: vec3<f32>;
    var phi_1789_: bool;
    var phi_1798_: vec3<f32>;
    var phi_1838_: type_22;
    var phi_1840_: type_22;
    var phi_1841_: bool;
    var phi_1845_: type_22;
    var phi_1846_: type_22;
    var phi_1847_: type_22;
    var phi_1848_: bool;
    var phi_1852_: type_22;
    var phi_1853_: bool;
    var phi_1857_: type_22;
    var phi_1858_: bool;
    var phi_1862_: type_22;
    var phi_1885_: u32;
    var phi_1899_: i32;
    var phi_1919_: vec3<f32>;
    var phi_1920_: vec3<f32>;
    var phi_1936_: vec3<f32>;
    var phi_1937_: vec3<f32>;
    var phi_1953_: vec3<f32>;
    var phi_1954_: vec3<f32>;
    var phi_1990_: vec3<f32>;
    var phi_2172_: f32;
    var phi_2190_: bool;
    var phi_2191_: bool;
    var phi_2210_: bool;
    var phi_2211_: bool;
    var phi_2217_: type_38;
    var phi_2218_: type_38;
    var phi_2219_: type_38;
    var phi_3419_: bool;
    var phi_1034_: type_38;
    var phi_3418_: bool;
    var phi_3501_: bool;
    var phi_3101_: type_38;
    var phi_3102_: type_62;
    var phi_3103_: bool;
    var phi_3104_: u32;
    var phi_3500_: bool;
    var phi_3105_: type_38;
    var phi_3106_: type_62;
    var phi_3107_: u32;
    var phi_3108_: bool;
    var phi_3109_: u32;
    var phi_3499_: bool;
    var phi_3110_: type_38;
    var phi_3111_: type_62;
    var phi_3112_: u32;
    var phi_3113_: bool;
    var phi_3114_: u32;
    var phi_3498_: bool;
    var phi_907_: type_38;
    var phi_910_: type_62;
    var phi_912_: u32;
    var phi_914_: bool;
    var phi_916_: u32;
    var phi_3115_: bool;
    var phi_3497_: bool;
    var local_23: type_38;
    var phi_3167_: type_22;
    var local_24: type_38;

    switch bitcast<i32>(0u) {
        default: {
            let _e98 = global;
            let _e101 = arrayLength((&global_9.member));
            let _e116 = arrayLength((&global_8.member));
            let _e120 = global_3.member[0u][0u];
            let _e124 = global_3.member[0u][1u];
            let _e128 = global_3.member[0u][2u];
            let _e132 = global_3.member[1u][0u];
            let _e136 = global_3.member[1u][1u];
            let _e140 = global_3.member[1u][2u];
            let _e144 = global_3.member[1u][3u];
            let _e148 = (_e98.x + (_e98.y * 2097152u));
            let _e155 = (_e148 < arrayLength((&global_6.member)));
            if _e155 {
                if _e155 {
                } else {
                    break;
                }
                let _e159 = global_6.member[_e148].member_2;
                phi_289_ = _e159;
            } else {
                phi_289_ = 4294967295u;
            }
            let _e161 = phi_289_;
            let _e164 = global_1.member[0u];
            let _e168 = global_2.member[0u][0u];
            let _e172 = global_2.member[0u][1u];
            let _e176 = global_2.member[0u][2u];
            let _e180 = global_2.member[0u][3u];
            let _e184 = global_2.member[1u][0u];
            let _e188 = global_2.member[1u][1u];
            let _e192 = global_2.member[1u][2u];
            let _e196 = global_2.member[1u][3u];
            let _e197 = bitcast<f32>(_e168);
            let _e198 = bitcast<f32>(_e172);
            let _e199 = bitcast<f32>(_e176);
            let _e201 = bitcast<f32>(_e184);
            let _e202 = array<u32, 3>(_e188, _e192, _e196);
            let _e204 = bitcast<i32>(_e164);
            if (_e204 < -126i) {
                phi_333_ = -126i;
            } else {
                phi_333_ = select(_e204, 127i, (_e204 > 127i));
            }
            let _e209 = phi_333_;
            let _e214 = bitcast<f32>((bitcast<u32>((_e209 + 127i)) << bitcast<u32>(23i)));
            let _e220 = bitcast<f32>((bitcast<u32>(((_e204 - _e209) + 127i)) << bitcast<u32>(23i)));
            if (_e180 == 0u) {
                phi_357_ = type_35(array<f32, 3>(_e197, _e198, _e199), _e180, _e201, _e202);
            } else {
                phi_357_ = type_35(array<f32, 3>(((_e197 * _e214) * _e220), ((_e198 * _e214) * _e220), ((_e199 * _e214) * _e220)), _e180, ((_e201 * _e214) * _e220), _e202);
            }
            let _e233 = phi_357_;
            if _e155 {
                let _e234 = (_e148 < arrayLength((&global_7.member)));
                if _e234 {
                    if _e155 {
                    } else {
                        break;
                    }
                    let _e244 = global_6.member[_e148].member.member_2[0u];
                    let _e246 = (bitcast<u32>(_e244) & 2147483647u);
                    let _e252 = global_6.member[_e148].member.member_2[1u];
                    let _e254 = (bitcast<u32>(_e252) & 2147483647u);
                    let _e260 = global_6.member[_e148].member.member_2[2u];
                    let _e262 = (bitcast<u32>(_e260) & 2147483647u);
                    let _e268 = global_6.member[_e148].member.member[0u];
                    let _e270 = (bitcast<u32>(_e268) & 2147483647u);
                    let _e276 = global_6.member[_e148].member.member[1u];
                    let _e278 = (bitcast<u32>(_e276) & 2147483647u);
                    let _e284 = global_6.member[_e148].member.member[2u];
                    let _e286 = (bitcast<u32>(_e284) & 2147483647u);
                    let _e288 = select(_e254, _e246, (_e254 < _e246));
                    let _e290 = select(_e262, _e288, (_e262 < _e288));
                    let _e292 = select(_e270, _e290, (_e270 < _e290));
                    let _e294 = select(_e278, _e292, (_e278 < _e292));
                    let _e296 = select(_e286, _e294, (_e286 < _e294));
                    let _e301 = global_6.member[_e148].member.member_1;
                    let _e303 = (bitcast<u32>(_e301) & 2147483647u);
                    let _e311 = global_6.member[_e148].member.member_3;
                    let _e317 = (((select(_e303, _e296, (_e303 < _e296)) < 2139095040u) && ((bitcast<u32>(_e311) & 2147483647u) <= 2139095040u)) && (_e290 > 0u));
                    if _e317 {
                        let _e320 = (bitcast<u32>(bitcast<f32>(_e290)) & 2147483647u);
                        if (_e320 >= 8388608u) {
                            phi_463_ = (bitcast<i32>((_e320 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_463_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e320)), 32u, (_e320 == 0u))));
                        }
                        let _e334 = phi_463_;
                        phi_464_ = _e334;
                    } else {
                        phi_464_ = 0i;
                    }
                    let _e336 = phi_464_;
                    let _e337 = (_e246 == _e290);
                    if _e337 {
                        phi_474_ = true;
                    } else {
                        phi_474_ = (_e254 == _e290);
                    }
                    let _e340 = phi_474_;
                    let _e341 = select(1u, 0u, _e337);
                    if _e340 {
                        let _e342 = (_e341 + 1u);
                        phi_484_ = _e342;
                        phi_485_ = _e342;
                        phi_487_ = select(true, false, (_e342 == 2u));
                    } else {
                        phi_484_ = u32();
                        phi_485_ = 0u;
                        phi_487_ = true;
                    }
                    let _e346 = phi_484_;
                    let _e348 = phi_485_;
                    let _e350 = phi_487_;
                    if _e350 {
                        phi_492_ = (_e348 + 1u);
                    } else {
                        phi_492_ = 0u;
                    }
                    let _e354 = phi_492_;
                    let _e355 = select(_e346, _e348, _e350);
                    let _e356 = select(_e341, select(2u, _e341, _e340), _e350);
                    let _e357 = -(_e336);
                    if (_e357 < -126i) {
                        phi_525_ = -126i;
                    } else {
                        phi_525_ = select(_e357, 127i, (_e357 > 127i));
                    }
                    let _e362 = phi_525_;
                    let _e367 = bitcast<f32>((bitcast<u32>((_e362 + 127i)) << bitcast<u32>(23i)));
                    let _e373 = bitcast<f32>((bitcast<u32>(((_e357 - _e362) + 127i)) << bitcast<u32>(23i)));
                    let _e378 = global_6.member[_e148].member.member;
                    let _e379 = (_e355 == 0u);
                    if _e379 {
                        phi_543_ = _e378[0];
                    } else {
                        phi_543_ = _e378[1];
                    }
                    let _e383 = phi_543_;
                    let _e384 = (_e355 == 2u);
                    if _e384 {
                        phi_549_ = _e378[2];
                    } else {
                        phi_549_ = _e383;
                    }
                    let _e387 = phi_549_;
                    let _e388 = global_6.member[_e148].member.member_2;
                    if _e379 {
                        phi_560_ = _e388[0];
                    } else {
                        phi_560_ = _e388[1];
                    }
                    let _e392 = phi_560_;
                    if _e384 {
                        phi_566_ = _e388[2];
                    } else {
                        phi_566_ = _e392;
                    }
                    let _e395 = phi_566_;
                    let _e397 = ((_e395 * _e367) * _e373);
                    let _e401 = (bitcast<f32>((bitcast<u32>(_e397) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e401 {
                        let _e405 = (bitcast<f32>((bitcast<u32>(_e387) & 2147483647u)) * 0.00000011920929f);
                        phi_589_ = select(0.00000000000011368684f, _e405, (_e405 > 0.00000000000011368684f));
                    } else {
                        phi_589_ = 0f;
                    }
                    let _e409 = phi_589_;
                    let _e410 = (_e387 + _e409);
                    let _e411 = (_e387 - _e409);
                    let _e412 = select(_e397, 0f, _e401);
                    if _e401 {
                        phi_600_ = 38685626000000000000000000f;
                    } else {
                        phi_600_ = (1f / _e397);
                    }
                    let _e415 = phi_600_;
                    let _e416 = (_e354 == 0u);
                    if _e416 {
                        phi_609_ = _e378[0];
                    } else {
                        phi_609_ = _e378[1];
                    }
                    let _e420 = phi_609_;
                    let _e421 = (_e354 == 2u);
                    if _e421 {
                        phi_615_ = _e378[2];
                    } else {
                        phi_615_ = _e420;
                    }
                    let _e424 = phi_615_;
                    if _e416 {
                        phi_626_ = _e388[0];
                    } else {
                        phi_626_ = _e388[1];
                    }
                    let _e428 = phi_626_;
                    if _e421 {
                        phi_632_ = _e388[2];
                    } else {
                        phi_632_ = _e428;
                    }
                    let _e431 = phi_632_;
                    let _e433 = ((_e431 * _e367) * _e373);
                    let _e437 = (bitcast<f32>((bitcast<u32>(_e433) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e437 {
                        let _e441 = (bitcast<f32>((bitcast<u32>(_e424) & 2147483647u)) * 0.00000011920929f);
                        phi_655_ = select(0.00000000000011368684f, _e441, (_e441 > 0.00000000000011368684f));
                    } else {
                        phi_655_ = 0f;
                    }
                    let _e445 = phi_655_;
                    let _e446 = (_e424 + _e445);
                    let _e447 = (_e424 - _e445);
                    let _e448 = select(_e433, 0f, _e437);
                    if _e437 {
                        phi_666_ = 38685626000000000000000000f;
                    } else {
                        phi_666_ = (1f / _e433);
                    }
                    let _e451 = phi_666_;
                    let _e452 = (_e356 == 0u);
                    if _e452 {
                        phi_675_ = _e378[0];
                    } else {
                        phi_675_ = _e378[1];
                    }
                    let _e456 = phi_675_;
                    let _e457 = (_e356 == 2u);
                    if _e457 {
                        phi_681_ = _e378[2];
                    } else {
                        phi_681_ = _e456;
                    }
                    let _e460 = phi_681_;
                    if _e452 {
                        phi_692_ = _e388[0];
                    } else {
                        phi_692_ = _e388[1];
                    }
                    let _e464 = phi_692_;
                    if _e457 {
                        phi_698_ = _e388[2];
                    } else {
                        phi_698_ = _e464;
                    }
                    let _e467 = phi_698_;
                    let _e469 = ((_e467 * _e367) * _e373);
                    let _e473 = (bitcast<f32>((bitcast<u32>(_e469) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e473 {
                        let _e477 = (bitcast<f32>((bitcast<u32>(_e460) & 2147483647u)) * 0.00000011920929f);
                        phi_721_ = select(0.00000000000011368684f, _e477, (_e477 > 0.00000000000011368684f));
                    } else {
                        phi_721_ = 0f;
                    }
                    let _e481 = phi_721_;
                    let _e482 = (_e460 + _e481);
                    let _e483 = (_e460 - _e481);
                    let _e484 = select(_e469, 0f, _e473);
                    if _e473 {
                        phi_732_ = 38685626000000000000000000f;
                    } else {
                        phi_732_ = (1f / _e469);
                    }
                    let _e487 = phi_732_;
                    let _e490 = bitcast<f32>((bitcast<u32>(_e387) & 2147483647u));
                    let _e493 = bitcast<f32>((bitcast<u32>(_e424) & 2147483647u));
                    let _e495 = select(_e493, _e490, (_e490 > _e493));
                    let _e498 = bitcast<f32>((bitcast<u32>(_e460) & 2147483647u));
                    if (_e317 && (select(_e498, _e495, (_e495 > _e498)) <= 1099511600000f)) {
                        let _e503 = (_e336 / 3i);
                        let _e510 = bitcast<f32>((bitcast<u32>((_e503 + 127i)) << bitcast<u32>(23i)));
                        let _e517 = bitcast<f32>((bitcast<u32>(((_e336 - (2i * _e503)) + 127i)) << bitcast<u32>(23i)));
                        let _e518 = (((_e301 * _e510) * _e510) * _e517);
                        let _e520 = select(340282350000000000000000000000000000000f, _e518, (_e518 < 340282350000000000000000000000000000000f));
                        let _e525 = (((_e311 * _e510) * _e510) * _e517);
                        let _e527 = select(340282350000000000000000000000000000000f, _e525, (_e525 < 340282350000000000000000000000000000000f));
                        phi_832_ = select(-340282350000000000000000000000000000000f, _e527, (_e527 > -340282350000000000000000000000000000000f));
                        phi_833_ = select(-340282350000000000000000000000000000000f, _e520, (_e520 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_832_ = 0f;
                        phi_833_ = 1f;
                    }
                    let _e531 = phi_832_;
                    let _e533 = phi_833_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_11 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_22 = array<f32, 3>(bitcast<f32>(_e120), bitcast<f32>(_e124), bitcast<f32>(_e128));
                    let _e538 = (_e355 % 3u);
                    let _e539 = (_e538 < 3u);
                    if _e539 {
                    } else {
                        break;
                    }
                    let _e541 = local_22[_e538];
                    let _e542 = (_e354 % 3u);
                    let _e543 = (_e542 < 3u);
                    if _e543 {
                    } else {
                        break;
                    }
                    let _e545 = local_22[_e542];
                    let _e546 = (_e356 % 3u);
                    let _e547 = (_e546 < 3u);
                    if _e547 {
                    } else {
                        break;
                    }
                    let _e549 = local_22[_e546];
                    local_21 = array<f32, 3>(bitcast<f32>(_e132), bitcast<f32>(_e136), bitcast<f32>(_e140));
                    if _e539 {
                    } else {
                        break;
                    }
                    let _e553 = local_21[_e538];
                    if _e543 {
                    } else {
                        break;
                    }
                    let _e555 = local_21[_e542];
                    if _e547 {
                    } else {
                        break;
                    }
                    let _e557 = local_21[_e546];
                    phi_3339_ = false;
                    phi_906_ = type_38(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e531);
                    phi_909_ = type_62(type_54(array<f32, 3>(_e541, _e545, _e549), array<f32, 3>(_e553, _e555, _e557)), select(0u, 2147483648u, (_e101 == 0u)));
                    phi_911_ = ((3u * _e101) + 1u);
                    phi_913_ = (_e533 <= _e531);
                    phi_915_ = 0u;
                    loop {
                        let _e565 = phi_3339_;
                        let _e567 = phi_906_;
                        let _e569 = phi_909_;
                        let _e571 = phi_911_;
                        let _e573 = phi_913_;
                        let _e575 = phi_915_;
                        local_23 = _e567;
                        if _e573 {
                            phi_926_ = true;
                        } else {
                            phi_926_ = (_e575 > 0u);
                        }
                        let _e578 = phi_926_;
                        if _e578 {
                            let _e579 = (_e571 > 0u);
                            if _e579 {
                                if _e573 {
                                    phi_1012_ = _e569;
                                    phi_1013_ = _e573;
                                    phi_1014_ = _e575;
                                } else {
                                    let _e580 = (_e575 - 1u);
                                    let _e581 = (_e580 % 128u);
                                    let _e582 = (_e581 < 128u);
                                    if _e582 {
                                    } else {
                                        phi_3497_ = true;
                                        break;
                                    }
                                    let _e584 = local_6[_e581];
                                    if _e582 {
                                    } else {
                                        phi_3497_ = true;
                                        break;
                                    }
                                    let _e586 = local_5[_e581];
                                    if _e582 {
                                    } else {
                                        phi_3497_ = true;
                                        break;
                                    }
                                    let _e588 = local_4[_e581];
                                    if _e582 {
                                    } else {
                                        phi_3497_ = true;
                                        break;
                                    }
                                    let _e590 = local_3[_e581];
                                    if _e582 {
                                    } else {
                                        phi_3497_ = true;
                                        break;
                                    }
                                    let _e593 = local_2[_e581];
                                    if _e582 {
                                    } else {
                                        phi_3497_ = true;
                                        break;
                                    }
                                    let _e595 = local_1[_e581];
                                    if _e582 {
                                    } else {
                                        phi_3497_ = true;
                                        break;
                                    }
                                    let _e597 = local[_e581];
                                    if _e582 {
                                    } else {
                                        phi_3497_ = true;
                                        break;
                                    }
                                    let _e602 = local_11[_e581];
                                    phi_1012_ = type_62(type_54(array<f32, 3>(_e586, _e588, _e590), array<f32, 3>(_e593, _e595, _e597)), _e584);
                                    phi_1013_ = (_e602 <= _e567.member_1);
                                    phi_1014_ = _e580;
                                }
                                let _e606 = phi_1012_;
                                let _e608 = phi_1013_;
                                let _e610 = phi_1014_;
                                if _e608 {
                                    if ((_e606.member_1 & 2147483648u) != 0u) {
                                        phi_3413_ = _e565;
                                        phi_1033_ = _e567;
                                        phi_1036_ = type_8(0u, ((_e606.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e935 = phi_3413_;
                                            let _e937 = phi_1033_;
                                            let _e939 = phi_1036_;
                                            local_24 = _e937;
                                            if (_e939.member < _e939.member_1) {
                                                phi_1037_ = type_8((_e939.member + 1u), _e939.member_1);
                                                phi_1059_ = type_8(1u, _e939.member);
                                            } else {
                                                phi_1037_ = _e939;
                                                phi_1059_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e952 = phi_1037_;
                                            let _e954 = phi_1059_;
                                            let _e958 = (bitcast<i32>(_e954.member) != 0i);
                                            if _e958 {
                                                local_8 = array<f32, 3>(_e606.member.member[0], _e606.member.member[1], _e606.member.member[2]);
                                                local_7 = array<f32, 3>(_e606.member.member_1[0], _e606.member.member_1[1], _e606.member.member_1[2]);
                                                let _e969 = ((_e606.member_1 & 268435455u) + _e954.member_1);
                                                let _e970 = (_e969 < arrayLength((&global_10.member)));
                                                if _e970 {
                                                    if _e970 {
                                                    } else {
                                                        phi_3418_ = true;
                                                        break;
                                                    }
                                                    let _e973 = global_10.member[_e969].member_1;
                                                    phi_1101_ = _e973;
                                                } else {
                                                    phi_1101_ = 4294967295u;
                                                }
                                                let _e975 = phi_1101_;
                                                local_18 = array<u32, 3>(_e355, _e354, _e356);
                                                if _e970 {
                                                    if _e970 {
                                                    } else {
                                                        phi_3418_ = true;
                                                        break;
                                                    }
                                                    let _e978 = global_10.member[_e969];
                                                    phi_1125_ = _e978;
                                                } else {
                                                    phi_1125_ = type_56(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e980 = phi_1125_;
                                                local_20 = array<u32, 3>(_e980.member[0], _e980.member[1], _e980.member[2]);
                                                local_19[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_19[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_19[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_3409_ = _e935;
                                                phi_1136_ = type_8(0u, 3u);
                                                loop {
                                                    let _e990 = phi_3409_;
                                                    let _e992 = phi_1136_;
                                                    if (_e992.member < _e992.member_1) {
                                                        phi_1137_ = type_8((_e992.member + 1u), _e992.member_1);
                                                        phi_1160_ = type_8(1u, _e992.member);
                                                    } else {
                                                        phi_1137_ = _e992;
                                                        phi_1160_ = type_8(0u, type_8().member_1);
                                                    }
                                                    let _e1005 = phi_1137_;
                                                    let _e1007 = phi_1160_;
                                                    let _e1011 = (bitcast<i32>(_e1007.member) != 0i);
                                                    if _e1011 {
                                                        phi_1170_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e1013 = phi_1170_;
                                                            if (_e1013.member < _e1013.member_1) {
                                                                phi_1171_ = type_8((_e1013.member + 1u), _e1013.member_1);
                                                                phi_1194_ = type_8(1u, _e1013.member);
                                                            } else {
                                                                phi_1171_ = _e1013;
                                                                phi_1194_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1026 = phi_1171_;
                                                            let _e1028 = phi_1194_;
                                                            let _e1032 = (bitcast<i32>(_e1028.member) != 0i);
                                                            if _e1032 {
                                                                let _e1033 = (_e1007.member_1 < 3u);
                                                                if _e1033 {
                                                                } else {
                                                                    phi_3404_ = true;
                                                                    break;
                                                                }
                                                                let _e1035 = local_20[_e1007.member_1];
                                                                let _e1036 = (_e1028.member_1 < 3u);
                                                                if _e1036 {
                                                                } else {
                                                                    phi_3404_ = true;
                                                                    break;
                                                                }
                                                                let _e1038 = local_18[_e1028.member_1];
                                                                let _e1043 = ((_e1035 >> bitcast<u32>(((10u * _e1038) & 31u))) & 1023u);
                                                                if _e1036 {
                                                                } else {
                                                                    phi_3404_ = true;
                                                                    break;
                                                                }
                                                                let _e1045 = local_8[_e1028.member_1];
                                                                if _e1036 {
                                                                } else {
                                                                    phi_3404_ = true;
                                                                    break;
                                                                }
                                                                let _e1047 = local_7[_e1028.member_1];
                                                                let _e1058 = (_e1045 + bitcast<f32>((bitcast<u32>((f32(_e1043) * bitcast<f32>((bitcast<u32>(((_e1047 - _e1045) * 0.0009775171f)) ^ _e144)))) ^ _e144)));
                                                                if _e1033 {
                                                                } else {
                                                                    phi_3404_ = true;
                                                                    break;
                                                                }
                                                                if _e1036 {
                                                                } else {
                                                                    phi_3404_ = true;
                                                                    break;
                                                                }
                                                                local_19[_e1007.member_1][_e1028.member_1] = select(select(_e1047, _e1058, (_e1058 < _e1047)), _e1047, (_e1043 == 1023u));
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_1170_ = _e1026;
                                                                phi_3404_ = _e990;
                                                                break if !(_e1032);
                                                            }
                                                        }
                                                        let _e1067 = phi_3404_;
                                                        phi_3416_ = _e1067;
                                                        if _e1067 {
                                                            break;
                                                        }
                                                        phi_3417_ = _e1067;
                                                    } else {
                                                        phi_3417_ = _e990;
                                                    }
                                                    let _e1069 = phi_3417_;
                                                    continue;
                                                    continuing {
                                                        phi_3409_ = _e1069;
                                                        phi_1136_ = _e1005;
                                                        phi_3416_ = _e1069;
                                                        break if !(_e1011);
                                                    }
                                                }
                                                let _e1072 = phi_3416_;
                                                phi_3418_ = _e1072;
                                                if _e1072 {
                                                    break;
                                                }
                                                let _e1073 = local_19;
                                                let _e1089 = (_e1073[0][2] - _e460);
                                                let _e1092 = (((_e1073[0][0] - _e387) * _e484) - (_e1089 * _e412));
                                                let _e1095 = (((_e1073[0][1] - _e424) * _e484) - (_e1089 * _e448));
                                                let _e1098 = (_e1073[1][2] - _e460);
                                                let _e1101 = (((_e1073[1][0] - _e387) * _e484) - (_e1098 * _e412));
                                                let _e1104 = (((_e1073[1][1] - _e424) * _e484) - (_e1098 * _e448));
                                                let _e1107 = (_e1073[2][2] - _e460);
                                                let _e1110 = (((_e1073[2][0] - _e387) * _e484) - (_e1107 * _e412));
                                                let _e1113 = (((_e1073[2][1] - _e424) * _e484) - (_e1107 * _e448));
                                                let _e1114 = (_e1110 * _e1104);
                                                let _e1115 = (_e1113 * _e1101);
                                                let _e1116 = (_e1092 * _e1113);
                                                let _e1117 = (_e1095 * _e1110);
                                                let _e1118 = (_e1101 * _e1095);
                                                let _e1119 = (_e1104 * _e1092);
                                                let _e1124 = (((_e1114 >= _e1115) && (_e1116 >= _e1117)) && (_e1118 >= _e1119));
                                                if (_e1124 || (((_e1114 <= _e1115) && (_e1116 <= _e1117)) && (_e1118 <= _e1119))) {
                                                    let _e1131 = select(-1f, 1f, _e1124);
                                                    let _e1133 = ((_e1114 - _e1115) * _e1131);
                                                    let _e1135 = select(0f, _e1133, (_e1133 > 0f));
                                                    let _e1137 = ((_e1116 - _e1117) * _e1131);
                                                    let _e1139 = select(0f, _e1137, (_e1137 > 0f));
                                                    let _e1141 = ((_e1118 - _e1119) * _e1131);
                                                    let _e1143 = select(0f, _e1141, (_e1141 > 0f));
                                                    let _e1145 = ((_e1135 + _e1139) + _e1143);
                                                    if (_e1145 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_1852_ = type_22();
                                                        phi_1853_ = true;
                                                    } else {
                                                        let _e1148 = select(_e1073[1][0], _e1073[0][0], (_e1073[0][0] < _e1073[1][0]));
                                                        let _e1152 = select(_e1073[1][0], _e1073[0][0], (_e1073[0][0] > _e1073[1][0]));
                                                        let _e1156 = select(_e1073[1][1], _e1073[0][1], (_e1073[0][1] < _e1073[1][1]));
                                                        let _e1160 = select(_e1073[1][1], _e1073[0][1], (_e1073[0][1] > _e1073[1][1]));
                                                        let _e1164 = select(_e1073[1][2], _e1073[0][2], (_e1073[0][2] < _e1073[1][2]));
                                                        let _e1168 = select(_e1073[1][2], _e1073[0][2], (_e1073[0][2] > _e1073[1][2]));
                                                        let _e1173 = ((select(_e1073[2][0], _e1148, (_e1148 < _e1073[2][0])) - _e410) * _e415);
                                                        let _e1174 = ((select(_e1073[2][0], _e1152, (_e1152 > _e1073[2][0])) - _e411) * _e415);
                                                        let _e1177 = ((select(_e1073[2][1], _e1156, (_e1156 < _e1073[2][1])) - _e446) * _e451);
                                                        let _e1178 = ((select(_e1073[2][1], _e1160, (_e1160 > _e1073[2][1])) - _e447) * _e451);
                                                        let _e1181 = ((select(_e1073[2][2], _e1164, (_e1164 < _e1073[2][2])) - _e482) * _e487);
                                                        let _e1182 = ((select(_e1073[2][2], _e1168, (_e1168 > _e1073[2][2])) - _e483) * _e487);
                                                        let _e1184 = select(_e1182, _e1181, (_e1181 < _e1182));
                                                        let _e1186 = select(_e1182, _e1181, (_e1181 > _e1182));
                                                        let _e1188 = select(_e1174, _e1173, (_e1173 < _e1174));
                                                        let _e1190 = select(_e1178, _e1177, (_e1177 < _e1178));
                                                        let _e1192 = select(_e1190, _e1188, (_e1188 > _e1190));
                                                        let _e1194 = select(_e1184, _e1192, (_e1192 > _e1184));
                                                        let _e1196 = select(_e1174, _e1173, (_e1173 > _e1174));
                                                        let _e1198 = select(_e1178, _e1177, (_e1177 > _e1178));
                                                        let _e1200 = select(_e1198, _e1196, (_e1196 < _e1198));
                                                        let _e1202 = select(_e1186, _e1200, (_e1200 < _e1186));
                                                        let _e1203 = -(_e1184);
                                                        let _e1209 = select(_e533, _e1194, (_e1194 > _e533));
                                                        if (_e1209 > (_e1202 + (select(_e1203, _e1186, (_e1186 > _e1203)) * 0.0000019073523f))) {
                                                            phi_1847_ = type_22();
                                                            phi_1848_ = true;
                                                        } else {
                                                            let _e1211 = (_e1209 > _e937.member_1);
                                                            if _e1211 {
                                                                phi_1846_ = type_22();
                                                            } else {
                                                                let _e1215 = (_e1073[1][0] - _e1073[0][0]);
                                                                let _e1216 = (_e1073[1][1] - _e1073[0][1]);
                                                                let _e1217 = (_e1073[1][2] - _e1073[0][2]);
                                                                let _e1218 = vec3<f32>(_e1215, _e1216, _e1217);
                                                                let _e1219 = (_e1073[2][0] - _e1073[1][0]);
                                                                let _e1220 = (_e1073[2][1] - _e1073[1][1]);
                                                                let _e1221 = (_e1073[2][2] - _e1073[1][2]);
                                                                let _e1222 = vec3<f32>(_e1219, _e1220, _e1221);
                                                                let _e1223 = (_e1073[0][0] - _e1073[2][0]);
                                                                let _e1224 = (_e1073[0][1] - _e1073[2][1]);
                                                                let _e1225 = (_e1073[0][2] - _e1073[2][2]);
                                                                let _e1226 = vec3<f32>(_e1223, _e1224, _e1225);
                                                                let _e1229 = bitcast<f32>((bitcast<u32>(_e1215) & 2147483647u));
                                                                let _e1232 = bitcast<f32>((bitcast<u32>(_e1216) & 2147483647u));
                                                                let _e1234 = select(_e1232, _e1229, (_e1229 > _e1232));
                                                                let _e1237 = bitcast<f32>((bitcast<u32>(_e1217) & 2147483647u));
                                                                let _e1239 = select(_e1237, _e1234, (_e1234 > _e1237));
                                                                let _e1242 = bitcast<f32>((bitcast<u32>(_e1219) & 2147483647u));
                                                                let _e1245 = bitcast<f32>((bitcast<u32>(_e1220) & 2147483647u));
                                                                let _e1247 = select(_e1245, _e1242, (_e1242 > _e1245));
                                                                let _e1250 = bitcast<f32>((bitcast<u32>(_e1221) & 2147483647u));
                                                                let _e1252 = select(_e1250, _e1247, (_e1247 > _e1250));
                                                                let _e1255 = bitcast<f32>((bitcast<u32>(_e1223) & 2147483647u));
                                                                let _e1258 = bitcast<f32>((bitcast<u32>(_e1224) & 2147483647u));
                                                                let _e1260 = select(_e1258, _e1255, (_e1255 > _e1258));
                                                                let _e1263 = bitcast<f32>((bitcast<u32>(_e1225) & 2147483647u));
                                                                let _e1265 = select(_e1263, _e1260, (_e1260 > _e1263));
                                                                let _e1267 = select(_e1252, _e1239, (_e1239 > _e1252));
                                                                let _e1269 = select(_e1265, _e1267, (_e1267 > _e1265));
                                                                if (_e1239 == _e1269) {
                                                                    phi_1757_ = _e1222;
                                                                    phi_1758_ = _e1226;
                                                                } else {
                                                                    let _e1272 = vec3((_e1252 == _e1269));
                                                                    phi_1757_ = select(_e1218, _e1226, _e1272);
                                                                    phi_1758_ = select(_e1222, _e1218, _e1272);
                                                                }
                                                                let _e1276 = phi_1757_;
                                                                let _e1278 = phi_1758_;
                                                                let _e1285 = ((_e1276.y * _e1278.z) - (_e1278.y * _e1276.z));
                                                                let _e1290 = ((_e1276.z * _e1278.x) - (_e1278.z * _e1276.x));
                                                                let _e1293 = ((_e1276.x * _e1278.y) - (_e1278.x * _e1276.y));
                                                                if (_e1135 >= _e1139) {
                                                                    phi_1789_ = select(true, false, (_e1135 >= _e1143));
                                                                } else {
                                                                    phi_1789_ = true;
                                                                }
                                                                let _e1298 = phi_1789_;
                                                                if _e1298 {
                                                                    phi_1798_ = select(vec3<f32>(_e1073[2][0], _e1073[2][1], _e1073[2][2]), vec3<f32>(_e1073[1][0], _e1073[1][1], _e1073[1][2]), vec3((_e1139 >= _e1143)));
                                                                } else {
                                                                    phi_1798_ = vec3<f32>(_e1073[0][0], _e1073[0][1], _e1073[0][2]);
                                                                }
                                                                let _e1303 = phi_1798_;
                                                                let _e1320 = ((((_e1285 * (_e1303.x - _e387)) + (_e1290 * (_e1303.y - _e424))) + (_e1293 * (_e1303.z - _e460))) / (((_e1285 * _e412) + (_e1290 * _e448)) + (_e1293 * _e484)));
                                                                let _e1322 = select(_e1202, _e1320, (_e1320 < _e1202));
                                                                let _e1324 = select(_e1194, _e1322, (_e1322 > _e1194));
                                                                if (_e1324 >= _e533) {
                                                                    let _e1326 = (_e1324 <= _e937.member_1);
                                                                    if _e1326 {
                                                                        let _e1327 = (1f / _e1145);
                                                                        phi_1838_ = type_22(_e1324, (_e1139 * _e1327), (_e1143 * _e1327), _e975);
                                                                    } else {
                                                                        phi_1838_ = type_22();
                                                                    }
                                                                    let _e1332 = phi_1838_;
                                                                    phi_1840_ = _e1332;
                                                                    phi_1841_ = select(true, false, _e1326);
                                                                } else {
                                                                    phi_1840_ = type_22();
                                                                    phi_1841_ = true;
                                                                }
                                                                let _e1335 = phi_1840_;
                                                                let _e1337 = phi_1841_;
                                                                if _e1337 {
                                                                    phi_1845_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_1845_ = _e1335;
                                                                }
                                                                let _e1339 = phi_1845_;
                                                                phi_1846_ = _e1339;
                                                            }
                                                            let _e1341 = phi_1846_;
                                                            phi_1847_ = _e1341;
                                                            phi_1848_ = _e1211;
                                                        }
                                                        let _e1343 = phi_1847_;
                                                        let _e1345 = phi_1848_;
                                                        phi_1852_ = _e1343;
                                                        phi_1853_ = _e1345;
                                                    }
                                                    let _e1347 = phi_1852_;
                                                    let _e1349 = phi_1853_;
                                                    phi_1857_ = _e1347;
                                                    phi_1858_ = _e1349;
                                                } else {
                                                    phi_1857_ = type_22();
                                                    phi_1858_ = true;
                                                }
                                                let _e1351 = phi_1857_;
                                                let _e1353 = phi_1858_;
                                                if _e1353 {
                                                    phi_1862_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_1862_ = _e1351;
                                                }
                                                let _e1355 = phi_1862_;
                                                if (_e1355.member_3 != 4294967295u) {
                                                    if (_e975 == _e161) {
                                                        phi_2191_ = false;
                                                    } else {
                                                        let _e1359 = (_e975 < arrayLength((&global_4.member)));
                                                        if _e1359 {
                                                            if _e1359 {
                                                            } else {
                                                                phi_3418_ = true;
                                                                break;
                                                            }
                                                            let _e1361 = global_4.member[_e975];
                                                            phi_1885_ = _e1361;
                                                        } else {
                                                            phi_1885_ = 4294967295u;
                                                        }
                                                        let _e1363 = phi_1885_;
                                                        let _e1364 = (_e1363 < arrayLength((&global_5.member)));
                                                        if _e1364 {
                                                            if _e1364 {
                                                            } else {
                                                                phi_3418_ = true;
                                                                break;
                                                            }
                                                            let _e1366 = global_5.member[_e1363];
                                                            phi_1899_ = _e1366;
                                                        } else {
                                                            phi_1899_ = 0i;
                                                        }
                                                        let _e1368 = phi_1899_;
                                                        let _e1369 = (_e1368 == 0i);
                                                        if _e1369 {
                                                            phi_2190_ = true;
                                                        } else {
                                                            if _e379 {
                                                                phi_1920_ = vec3<f32>(_e1073[0][0], _e1073[0][1], _e1073[0][2]);
                                                            } else {
                                                                if (_e355 == 1u) {
                                                                    phi_1919_ = vec3<f32>(_e1073[0][2], _e1073[0][0], _e1073[0][1]);
                                                                } else {
                                                                    phi_1919_ = vec3<f32>(_e1073[0][1], _e1073[0][2], _e1073[0][0]);
                                                                }
                                                                let _e1374 = phi_1919_;
                                                                phi_1920_ = _e1374;
                                                            }
                                                            let _e1377 = phi_1920_;
                                                            if _e379 {
                                                                phi_1937_ = vec3<f32>(_e1073[1][0], _e1073[1][1], _e1073[1][2]);
                                                            } else {
                                                                if (_e355 == 1u) {
                                                                    phi_1936_ = vec3<f32>(_e1073[1][2], _e1073[1][0], _e1073[1][1]);
                                                                } else {
                                                                    phi_1936_ = vec3<f32>(_e1073[1][1], _e1073[1][2], _e1073[1][0]);
                                                                }
                                                                let _e1382 = phi_1936_;
                                                                phi_1937_ = _e1382;
                                                            }
                                                            let _e1385 = phi_1937_;
                                                            if _e379 {
                                                                phi_1954_ = vec3<f32>(_e1073[2][0], _e1073[2][1], _e1073[2][2]);
                                                            } else {
                                                                if (_e355 == 1u) {
                                                                    phi_1953_ = vec3<f32>(_e1073[2][2], _e1073[2][0], _e1073[2][1]);
                                                                } else {
                                                                    phi_1953_ = vec3<f32>(_e1073[2][1], _e1073[2][2], _e1073[2][0]);
                                                                }
                                                                let _e1390 = phi_1953_;
                                                                phi_1954_ = _e1390;
                                                            }
                                                            let _e1393 = phi_1954_;
                                                            let _e1396 = (_e1385.x - _e1377.x);
                                                            let _e1399 = (_e1385.y - _e1377.y);
                                                            let _e1402 = (_e1385.z - _e1377.z);
                                                            let _e1404 = (_e1393.x - _e1377.x);
                                                            let _e1406 = (_e1393.y - _e1377.y);
                                                            let _e1408 = (_e1393.z - _e1377.z);
                                                            if (_e233.member_1 == 1u) {
                                                                phi_1990_ = (vec3<f32>(_e233.member[0], _e233.member[1], _e233.member[2]) - _e1377);
                                                            } else {
                                                                phi_1990_ = vec3<f32>(_e233.member[0], _e233.member[1], _e233.member[2]);
                                                            }
                                                            let _e1423 = phi_1990_;
                                                            let _e1429 = bitcast<f32>((bitcast<u32>((_e1396 * _e1406)) ^ _e233.member_3[0]));
                                                            let _e1433 = bitcast<f32>((bitcast<u32>((_e1399 * _e1404)) ^ _e233.member_3[0]));
                                                            let _e1437 = bitcast<f32>((bitcast<u32>((_e1399 * _e1408)) ^ _e233.member_3[0]));
                                                            let _e1441 = bitcast<f32>((bitcast<u32>((_e1402 * _e1406)) ^ _e233.member_3[0]));
                                                            let _e1445 = bitcast<f32>((bitcast<u32>((_e1402 * _e1404)) ^ _e233.member_3[0]));
                                                            let _e1449 = bitcast<f32>((bitcast<u32>((_e1396 * _e1408)) ^ _e233.member_3[0]));
                                                            let _e1450 = (_e1437 - _e1441);
                                                            let _e1451 = (_e1445 - _e1449);
                                                            let _e1452 = (_e1429 - _e1433);
                                                            let _e1476 = (bitcast<f32>((bitcast<u32>(_e1437) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1441) & 2147483647u)));
                                                            let _e1483 = (bitcast<f32>((bitcast<u32>(_e1445) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1449) & 2147483647u)));
                                                            let _e1490 = (bitcast<f32>((bitcast<u32>(_e1429) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1433) & 2147483647u)));
                                                            if (_e233.member_2 == 0f) {
                                                                phi_2172_ = 0f;
                                                            } else {
                                                                let _e1520 = bitcast<f32>((bitcast<u32>(_e1450) & 2147483647u));
                                                                let _e1523 = bitcast<f32>((bitcast<u32>(_e1451) & 2147483647u));
                                                                let _e1526 = bitcast<f32>((bitcast<u32>(_e1452) & 2147483647u));
                                                                let _e1528 = select(_e1526, _e1523, (_e1523 > _e1526));
                                                                let _e1532 = select(_e1526, _e1523, (_e1523 < _e1526));
                                                                let _e1536 = select(_e1523, _e1520, (_e1520 < _e1523));
                                                                let _e1538 = select(_e1523, _e1520, (_e1520 > _e1523));
                                                                let _e1540 = select(_e1526, _e1538, (_e1538 < _e1526));
                                                                phi_2172_ = bitcast<f32>((bitcast<u32>((_e233.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1528, _e1520, (_e1520 > _e1528)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1540, _e1536, (_e1536 > _e1540)))) ^ _e233.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1532, _e1520, (_e1520 < _e1532)))) ^ _e233.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1476 + _e1483) + _e1490))) ^ _e233.member_3[0]))) * 1.0000005f)) ^ _e233.member_3[0])))) ^ _e233.member_3[0]));
                                                            }
                                                            let _e1567 = phi_2172_;
                                                            phi_2190_ = (_e1369 || !(((((bitcast<f32>((bitcast<u32>((_e1423.x * _e1450)) ^ _e233.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1423.y * _e1451)) ^ _e233.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1423.z * _e1452)) ^ _e233.member_3[0]))) * f32(-(_e1368))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1423.x) & 2147483647u)) * _e1476)) ^ _e233.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1423.y) & 2147483647u)) * _e1483)) ^ _e233.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1423.z) & 2147483647u)) * _e1490)) ^ _e233.member_3[0]))))) ^ _e233.member_3[0])) + _e1567) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1581 = phi_2190_;
                                                        phi_2191_ = _e1581;
                                                    }
                                                    let _e1583 = phi_2191_;
                                                    if _e1583 {
                                                        if (_e1355.member < _e937.member.member) {
                                                            phi_2211_ = true;
                                                        } else {
                                                            if (_e1355.member == _e937.member.member) {
                                                                phi_2210_ = (_e1355.member_3 < _e937.member.member_3);
                                                            } else {
                                                                phi_2210_ = false;
                                                            }
                                                            let _e1593 = phi_2210_;
                                                            phi_2211_ = _e1593;
                                                        }
                                                        let _e1595 = phi_2211_;
                                                        if _e1595 {
                                                            phi_2217_ = type_38(_e1355, _e1355.member);
                                                        } else {
                                                            phi_2217_ = _e937;
                                                        }
                                                        let _e1598 = phi_2217_;
                                                        phi_2218_ = _e1598;
                                                    } else {
                                                        phi_2218_ = _e937;
                                                    }
                                                    let _e1600 = phi_2218_;
                                                    phi_2219_ = _e1600;
                                                } else {
                                                    phi_2219_ = _e937;
                                                }
                                                let _e1602 = phi_2219_;
                                                phi_3419_ = _e1072;
                                                phi_1034_ = _e1602;
                                            } else {
                                                phi_3419_ = _e935;
                                                phi_1034_ = type_38();
                                            }
                                            let _e1604 = phi_3419_;
                                            let _e1606 = phi_1034_;
                                            continue;
                                            continuing {
                                                phi_3413_ = _e1604;
                                                phi_1033_ = _e1606;
                                                phi_1036_ = _e952;
                                                phi_3418_ = _e1604;
                                                break if !(_e958);
                                            }
                                        }
                                        let _e1609 = phi_3418_;
                                        phi_3497_ = _e1609;
                                        if _e1609 {
                                            break;
                                        }
                                        phi_3501_ = _e1609;
                                        let _e1837 = local_24;
                                        phi_3101_ = _e1837;
                                        phi_3102_ = _e606;
                                        phi_3103_ = false;
                                        phi_3104_ = _e610;
                                    } else {
                                        local_10 = array<f32, 3>(_e606.member.member[0], _e606.member.member[1], _e606.member.member[2]);
                                        local_9 = array<f32, 3>(_e606.member.member_1[0], _e606.member.member_1[1], _e606.member.member_1[2]);
                                        let _e630 = (_e606.member_1 < _e101);
                                        if _e630 {
                                            if _e630 {
                                            } else {
                                                phi_3497_ = true;
                                                break;
                                            }
                                            let _e632 = global_9.member[_e606.member_1];
                                            phi_2253_ = _e632;
                                        } else {
                                            phi_2253_ = type_48(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e634 = phi_2253_;
                                        let _e636 = array<u32, 3>(_e355, _e354, _e356);
                                        local_17 = _e636;
                                        local_13 = array<f32, 3>(0f, 0f, 0f);
                                        local_12 = array<f32, 3>(0f, 0f, 0f);
                                        phi_2262_ = type_8(0u, 3u);
                                        loop {
                                            let _e638 = phi_2262_;
                                            if (_e638.member < _e638.member_1) {
                                                phi_2263_ = type_8((_e638.member + 1u), _e638.member_1);
                                                phi_2286_ = type_8(1u, _e638.member);
                                            } else {
                                                phi_2263_ = _e638;
                                                phi_2286_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e651 = phi_2263_;
                                            let _e653 = phi_2286_;
                                            let _e657 = (bitcast<i32>(_e653.member) != 0i);
                                            if _e657 {
                                                let _e658 = (_e653.member_1 < 3u);
                                                if _e658 {
                                                } else {
                                                    phi_3332_ = true;
                                                    break;
                                                }
                                                let _e660 = local_17[_e653.member_1];
                                                if _e658 {
                                                } else {
                                                    phi_3332_ = true;
                                                    break;
                                                }
                                                let _e662 = local_10[_e653.member_1];
                                                if _e658 {
                                                } else {
                                                    phi_3332_ = true;
                                                    break;
                                                }
                                                let _e664 = local_9[_e653.member_1];
                                                let _e667 = ((10u * _e660) & 31u);
                                                let _e670 = ((_e634.member[0] >> bitcast<u32>(_e667)) & 1023u);
                                                let _e675 = bitcast<f32>((bitcast<u32>(((_e664 - _e662) * 0.0009775171f)) ^ _e144));
                                                let _e681 = (_e662 + bitcast<f32>((bitcast<u32>((f32(_e670) * _e675)) ^ _e144)));
                                                if _e658 {
                                                } else {
                                                    phi_3332_ = true;
                                                    break;
                                                }
                                                local_13[_e653.member_1] = select(select(_e664, _e681, (_e681 < _e664)), _e664, (_e670 == 1023u));
                                                let _e690 = ((_e634.member[1] >> bitcast<u32>(_e667)) & 1023u);
                                                let _e696 = (_e662 + bitcast<f32>((bitcast<u32>((f32(_e690) * _e675)) ^ _e144)));
                                                if _e658 {
                                                } else {
                                                    phi_3332_ = true;
                                                    break;
                                                }
                                                local_12[_e653.member_1] = select(select(_e664, _e696, (_e696 < _e664)), _e664, (_e690 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_2262_ = _e651;
                                                phi_3332_ = _e565;
                                                break if !(_e657);
                                            }
                                        }
                                        let _e704 = phi_3332_;
                                        phi_3497_ = _e704;
                                        if _e704 {
                                            break;
                                        }
                                        let _e705 = local_12;
                                        let _e706 = local_13;
                                        local_16 = _e636;
                                        local_15 = array<f32, 3>(0f, 0f, 0f);
                                        local_14 = array<f32, 3>(0f, 0f, 0f);
                                        phi_2416_ = type_8(0u, 3u);
                                        loop {
                                            let _e715 = phi_2416_;
                                            if (_e715.member < _e715.member_1) {
                                                phi_2417_ = type_8((_e715.member + 1u), _e715.member_1);
                                                phi_2440_ = type_8(1u, _e715.member);
                                            } else {
                                                phi_2417_ = _e715;
                                                phi_2440_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e728 = phi_2417_;
                                            let _e730 = phi_2440_;
                                            let _e734 = (bitcast<i32>(_e730.member) != 0i);
                                            if _e734 {
                                                let _e735 = (_e730.member_1 < 3u);
                                                if _e735 {
                                                } else {
                                                    phi_3396_ = true;
                                                    break;
                                                }
                                                let _e737 = local_16[_e730.member_1];
                                                if _e735 {
                                                } else {
                                                    phi_3396_ = true;
                                                    break;
                                                }
                                                let _e739 = local_10[_e730.member_1];
                                                if _e735 {
                                                } else {
                                                    phi_3396_ = true;
                                                    break;
                                                }
                                                let _e741 = local_9[_e730.member_1];
                                                let _e744 = ((10u * _e737) & 31u);
                                                let _e747 = ((_e634.member_1[0] >> bitcast<u32>(_e744)) & 1023u);
                                                let _e752 = bitcast<f32>((bitcast<u32>(((_e741 - _e739) * 0.0009775171f)) ^ _e144));
                                                let _e758 = (_e739 + bitcast<f32>((bitcast<u32>((f32(_e747) * _e752)) ^ _e144)));
                                                if _e735 {
                                                } else {
                                                    phi_3396_ = true;
                                                    break;
                                                }
                                                local_15[_e730.member_1] = select(select(_e741, _e758, (_e758 < _e741)), _e741, (_e747 == 1023u));
                                                let _e767 = ((_e634.member_1[1] >> bitcast<u32>(_e744)) & 1023u);
                                                let _e773 = (_e739 + bitcast<f32>((bitcast<u32>((f32(_e767) * _e752)) ^ _e144)));
                                                if _e735 {
                                                } else {
                                                    phi_3396_ = true;
                                                    break;
                                                }
                                                local_14[_e730.member_1] = select(select(_e741, _e773, (_e773 < _e741)), _e741, (_e767 == 1023u));
                                            }
                                            continue;
                                            continuing {
                                                phi_2416_ = _e728;
                                                phi_3396_ = _e704;
                                                break if !(_e734);
                                            }
                                        }
                                        let _e781 = phi_3396_;
                                        phi_3497_ = _e781;
                                        if _e781 {
                                            break;
                                        }
                                        let _e782 = local_14;
                                        let _e783 = local_15;
                                        let _e794 = type_62(type_54(array<f32, 3>(_e706[0], _e706[1], _e706[2]), array<f32, 3>(_e705[0], _e705[1], _e705[2])), _e634.member_2);
                                        let _e799 = type_62(type_54(array<f32, 3>(_e783[0], _e783[1], _e783[2]), array<f32, 3>(_e782[0], _e782[1], _e782[2])), _e634.member_3);
                                        let _e805 = ((_e706[0] - _e410) * _e415);
                                        let _e806 = ((_e783[0] - _e410) * _e415);
                                        let _e807 = ((_e705[0] - _e411) * _e415);
                                        let _e808 = ((_e782[0] - _e411) * _e415);
                                        let _e813 = ((_e706[1] - _e446) * _e451);
                                        let _e814 = ((_e783[1] - _e446) * _e451);
                                        let _e815 = ((_e705[1] - _e447) * _e451);
                                        let _e816 = ((_e782[1] - _e447) * _e451);
                                        let _e821 = ((_e706[2] - _e482) * _e487);
                                        let _e822 = ((_e783[2] - _e482) * _e487);
                                        let _e823 = ((_e705[2] - _e483) * _e487);
                                        let _e824 = ((_e782[2] - _e483) * _e487);
                                        let _e826 = select(_e823, _e821, (_e821 < _e823));
                                        let _e828 = select(_e824, _e822, (_e822 < _e824));
                                        let _e830 = select(_e823, _e821, (_e821 > _e823));
                                        let _e832 = select(_e824, _e822, (_e822 > _e824));
                                        let _e834 = select(_e807, _e805, (_e805 < _e807));
                                        let _e836 = select(_e808, _e806, (_e806 < _e808));
                                        let _e838 = select(_e815, _e813, (_e813 < _e815));
                                        let _e840 = select(_e816, _e814, (_e814 < _e816));
                                        let _e842 = select(_e838, _e834, (_e834 > _e838));
                                        let _e844 = select(_e840, _e836, (_e836 > _e840));
                                        let _e846 = select(_e826, _e842, (_e842 > _e826));
                                        let _e848 = select(_e828, _e844, (_e844 > _e828));
                                        let _e850 = select(_e807, _e805, (_e805 > _e807));
                                        let _e852 = select(_e808, _e806, (_e806 > _e808));
                                        let _e854 = select(_e815, _e813, (_e813 > _e815));
                                        let _e856 = select(_e816, _e814, (_e814 > _e816));
                                        let _e858 = select(_e854, _e850, (_e850 < _e854));
                                        let _e860 = select(_e856, _e852, (_e852 < _e856));
                                        let _e865 = -(_e826);
                                        let _e866 = -(_e828);
                                        let _e873 = (select(_e830, _e858, (_e858 < _e830)) + (select(_e865, _e830, (_e830 > _e865)) * 0.0000019073523f));
                                        let _e874 = (select(_e832, _e860, (_e860 < _e832)) + (select(_e866, _e832, (_e832 > _e866)) * 0.0000019073523f));
                                        let _e876 = select(_e533, _e846, (_e846 > _e533));
                                        let _e878 = select(_e533, _e848, (_e848 > _e533));
                                        let _e883 = (_e876 <= select(_e567.member_1, _e873, (_e873 < _e567.member_1)));
                                        let _e884 = (_e878 <= select(_e567.member_1, _e874, (_e874 < _e567.member_1)));
                                        let _e885 = (_e876 <= _e878);
                                        if _e883 {
                                            if _e884 {
                                                if _e885 {
                                                    phi_3003_ = _e799;
                                                } else {
                                                    phi_3003_ = _e794;
                                                }
                                                let _e887 = phi_3003_;
                                                let _e895 = (_e610 % 128u);
                                                let _e896 = (_e895 < 128u);
                                                if _e896 {
                                                } else {
                                                    phi_3497_ = true;
                                                    break;
                                                }
                                                local_6[_e895] = _e887.member_1;
                                                if _e896 {
                                                } else {
                                                    phi_3497_ = true;
                                                    break;
                                                }
                                                local_5[_e895] = _e887.member.member[0];
                                                if _e896 {
                                                } else {
                                                    phi_3497_ = true;
                                                    break;
                                                }
                                                local_4[_e895] = _e887.member.member[1];
                                                if _e896 {
                                                } else {
                                                    phi_3497_ = true;
                                                    break;
                                                }
                                                local_3[_e895] = _e887.member.member[2];
                                                if _e896 {
                                                } else {
                                                    phi_3497_ = true;
                                                    break;
                                                }
                                                local_2[_e895] = _e887.member.member_1[0];
                                                if _e896 {
                                                } else {
                                                    phi_3497_ = true;
                                                    break;
                                                }
                                                local_1[_e895] = _e887.member.member_1[1];
                                                if _e896 {
                                                } else {
                                                    phi_3497_ = true;
                                                    break;
                                                }
                                                local[_e895] = _e887.member.member_1[2];
                                                if _e896 {
                                                } else {
                                                    phi_3497_ = true;
                                                    break;
                                                }
                                                local_11[_e895] = select(_e878, _e876, (_e876 > _e878));
                                                if _e885 {
                                                    phi_3080_ = _e794;
                                                } else {
                                                    phi_3080_ = _e799;
                                                }
                                                let _e913 = phi_3080_;
                                                phi_3081_ = _e913;
                                                phi_3082_ = (_e610 + 1u);
                                            } else {
                                                phi_3081_ = type_62();
                                                phi_3082_ = u32();
                                            }
                                            let _e915 = phi_3081_;
                                            let _e917 = phi_3082_;
                                            phi_3084_ = _e915;
                                            phi_3085_ = _e917;
                                            phi_3086_ = select(true, false, _e884);
                                        } else {
                                            phi_3084_ = type_62();
                                            phi_3085_ = u32();
                                            phi_3086_ = true;
                                        }
                                        let _e920 = phi_3084_;
                                        let _e922 = phi_3085_;
                                        let _e924 = phi_3086_;
                                        if _e924 {
                                            if _e883 {
                                                phi_3093_ = _e794;
                                            } else {
                                                phi_3093_ = _e799;
                                            }
                                            let _e926 = phi_3093_;
                                            phi_3098_ = _e926;
                                            phi_3099_ = select(_e884, true, _e883);
                                        } else {
                                            phi_3098_ = _e920;
                                            phi_3099_ = _e608;
                                        }
                                        let _e929 = phi_3098_;
                                        let _e931 = phi_3099_;
                                        phi_3501_ = _e781;
                                        phi_3101_ = _e567;
                                        phi_3102_ = _e929;
                                        phi_3103_ = _e931;
                                        phi_3104_ = select(_e922, _e610, _e924);
                                    }
                                    let _e1611 = phi_3501_;
                                    let _e1613 = phi_3101_;
                                    let _e1615 = phi_3102_;
                                    let _e1617 = phi_3103_;
                                    let _e1619 = phi_3104_;
                                    phi_3500_ = _e1611;
                                    phi_3105_ = _e1613;
                                    phi_3106_ = _e1615;
                                    phi_3107_ = (_e571 - 1u);
                                    phi_3108_ = _e1617;
                                    phi_3109_ = _e1619;
                                } else {
                                    phi_3500_ = _e565;
                                    phi_3105_ = _e567;
                                    phi_3106_ = _e606;
                                    phi_3107_ = _e571;
                                    phi_3108_ = _e608;
                                    phi_3109_ = _e610;
                                }
                                let _e1621 = phi_3500_;
                                let _e1623 = phi_3105_;
                                let _e1625 = phi_3106_;
                                let _e1627 = phi_3107_;
                                let _e1629 = phi_3108_;
                                let _e1631 = phi_3109_;
                                phi_3499_ = _e1621;
                                phi_3110_ = _e1623;
                                phi_3111_ = _e1625;
                                phi_3112_ = _e1627;
                                phi_3113_ = _e1629;
                                phi_3114_ = _e1631;
                            } else {
                                phi_3499_ = _e565;
                                phi_3110_ = type_38();
                                phi_3111_ = type_62();
                                phi_3112_ = u32();
                                phi_3113_ = bool();
                                phi_3114_ = u32();
                            }
                            let _e1633 = phi_3499_;
                            let _e1635 = phi_3110_;
                            let _e1637 = phi_3111_;
                            let _e1639 = phi_3112_;
                            let _e1641 = phi_3113_;
                            let _e1643 = phi_3114_;
                            phi_3498_ = _e1633;
                            phi_907_ = _e1635;
                            phi_910_ = _e1637;
                            phi_912_ = _e1639;
                            phi_914_ = _e1641;
                            phi_916_ = _e1643;
                            phi_3115_ = _e579;
                        } else {
                            phi_3498_ = _e565;
                            phi_907_ = type_38();
                            phi_910_ = type_62();
                            phi_912_ = u32();
                            phi_914_ = bool();
                            phi_916_ = u32();
                            phi_3115_ = false;
                        }
                        let _e1645 = phi_3498_;
                        let _e1647 = phi_907_;
                        let _e1649 = phi_910_;
                        let _e1651 = phi_912_;
                        let _e1653 = phi_914_;
                        let _e1655 = phi_916_;
                        let _e1657 = phi_3115_;
                        continue;
                        continuing {
                            phi_3339_ = _e1645;
                            phi_906_ = _e1647;
                            phi_909_ = _e1649;
                            phi_911_ = _e1651;
                            phi_913_ = _e1653;
                            phi_915_ = _e1655;
                            phi_3497_ = _e1645;
                            break if !(_e1657);
                        }
                    }
                    let _e1660 = phi_3497_;
                    if _e1660 {
                        break;
                    }
                    let _e1662 = local_23;
                    if (_e1662.member.member_3 != 4294967295u) {
                        let _e1667 = (_e357 / 3i);
                        let _e1674 = bitcast<f32>((bitcast<u32>((_e1667 + 127i)) << bitcast<u32>(23i)));
                        let _e1682 = (((_e1662.member.member * _e1674) * _e1674) * bitcast<f32>((bitcast<u32>(((_e357 - (2i * _e1667)) + 127i)) << bitcast<u32>(23i))));
                        let _e1684 = select(340282350000000000000000000000000000000f, _e1682, (_e1682 < 340282350000000000000000000000000000000f));
                        phi_3167_ = type_22(select(-340282350000000000000000000000000000000f, _e1684, (_e1684 > -340282350000000000000000000000000000000f)), _e1662.member.member_1, _e1662.member.member_2, _e1662.member.member_3);
                    } else {
                        phi_3167_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1691 = phi_3167_;
                    if _e234 {
                    } else {
                        break;
                    }
                    global_7.member[_e148] = _e1691;
                    if _e155 {
                    } else {
                        break;
                    }
                    let _e1695 = select(0u, 1u, (_e301 <= _e311));
                    if (_e1695 > 0u) {
                        let _e1697 = (1u < _e116);
                        if _e1697 {
                            if (0u < _e116) {
                            } else {
                                break;
                            }
                            let _e1701 = atomicAdd((&global_8.member[0u]), _e1695);
                            if ((_e1701 + _e1695) < _e1701) {
                                if _e1697 {
                                } else {
                                    break;
                                }
                                let _e1706 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1709 = select(0u, 1u, (_e1691.member_3 != 4294967295u));
                    if (_e1709 > 0u) {
                        let _e1711 = (3u < _e116);
                        if _e1711 {
                            if (2u < _e116) {
                            } else {
                                break;
                            }
                            let _e1715 = atomicAdd((&global_8.member[2u]), _e1709);
                            if ((_e1715 + _e1709) < _e1715) {
                                if _e1711 {
                                } else {
                                    break;
                                }
                                let _e1720 = atomicAdd((&global_8.member[3u]), 1u);
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
fn trace_paths_printed_leaf10_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
