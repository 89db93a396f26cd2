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

struct type_21 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_23 {
    member: array<type_21>,
}

struct type_25 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_26 {
    member: type_25,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_28 {
    member: array<type_26>,
}

struct type_33 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_36 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_39 {
    member: type_21,
    member_1: f32,
}

struct type_43 {
    member: array<vec4<u32>, 2>,
}

struct type_46 {
    member: array<i32>,
}

struct type_52 {
    member: array<array<u32, 7>>,
}

struct type_60 {
    member: type_33,
    member_1: u32,
}

struct type_61 {
    member: array<vec4<f32>, 3>,
    member_1: type_60,
    member_2: type_60,
}

struct type_68 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_43;
@group(0) @binding(2) 
var<uniform> global_3: type_43;
@group(0) @binding(5) 
var<storage> global_4: type_4;
@group(0) @binding(6) 
var<storage> global_5: type_46;
@group(0) @binding(7) 
var<storage> global_6: type_28;
@group(0) @binding(8) 
var<storage, read_write> global_7: type_23;
@group(0) @binding(9) 
var<storage, read_write> global_8: type_68;
@group(0) @binding(3) 
var<storage> global_9: type_52;
@group(0) @binding(4) 
var<storage> global_10: type_4;

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
    var local_10: array<u32, 3>;
    var local_11: array<array<f32, 3>, 3>;
    var local_12: array<f32, 4>;
    var phi_340_: u32;
    var phi_384_: i32;
    var phi_408_: type_36;
    var phi_514_: i32;
    var phi_515_: i32;
    var phi_525_: bool;
    var phi_535_: u32;
    var phi_536_: u32;
    var phi_538_: bool;
    var phi_543_: u32;
    var phi_576_: i32;
    var phi_594_: f32;
    var phi_600_: f32;
    var phi_611_: f32;
    var phi_617_: f32;
    var phi_640_: f32;
    var phi_651_: f32;
    var phi_660_: f32;
    var phi_666_: f32;
    var phi_677_: f32;
    var phi_683_: f32;
    var phi_706_: f32;
    var phi_717_: f32;
    var phi_726_: f32;
    var phi_732_: f32;
    var phi_743_: f32;
    var phi_749_: f32;
    var phi_772_: f32;
    var phi_783_: f32;
    var phi_883_: f32;
    var phi_884_: f32;
    var phi_3997_: bool;
    var phi_973_: type_39;
    var phi_976_: type_60;
    var phi_978_: u32;
    var phi_980_: bool;
    var phi_982_: u32;
    var phi_993_: bool;
    var phi_1079_: type_60;
    var phi_1080_: bool;
    var phi_1081_: u32;
    var phi_2886_: u32;
    var phi_2892_: u32;
    var phi_3146_: u32;
    var phi_3147_: u32;
    var phi_3157_: u32;
    var phi_3159_: u32;
    var phi_3160_: bool;
    var phi_3180_: u32;
    var phi_3181_: u32;
    var phi_3185_: type_61;
    var phi_3529_: type_60;
    var phi_3606_: type_60;
    var phi_3607_: type_60;
    var phi_3608_: u32;
    var phi_3610_: type_60;
    var phi_3611_: u32;
    var phi_3612_: bool;
    var phi_3621_: type_60;
    var phi_3626_: type_60;
    var phi_3627_: bool;
    var phi_3994_: bool;
    var phi_1100_: type_39;
    var phi_1103_: type_8;
    var phi_1104_: type_8;
    var phi_1126_: type_8;
    var phi_1167_: u32;
    var phi_1173_: u32;
    var phi_1183_: u32;
    var phi_1199_: u32;
    var phi_1236_: u32;
    var phi_1242_: u32;
    var phi_1252_: u32;
    var phi_3979_: bool;
    var phi_1268_: type_8;
    var phi_1269_: type_8;
    var phi_1292_: type_8;
    var phi_1315_: u32;
    var phi_1330_: u32;
    var phi_1333_: type_8;
    var phi_1334_: type_8;
    var phi_1357_: type_8;
    var phi_1423_: u32;
    var phi_1403_: u32;
    var phi_1404_: u32;
    var phi_1427_: f32;
    var phi_3972_: bool;
    var phi_4055_: bool;
    var phi_4054_: bool;
    var phi_1927_: vec3<f32>;
    var phi_1928_: vec3<f32>;
    var phi_1959_: bool;
    var phi_1968_: vec3<f32>;
    var phi_2008_: type_21;
    var phi_2010_: type_21;
    var phi_2011_: bool;
    var phi_2015_: type_21;
    var phi_2016_: type_21;
    var phi_2017_: type_21;
    var phi_2018_: bool;
    var phi_2022_: type_21;
    var phi_2023_: bool;
    var phi_2027_: type_21;
    var phi_2028_: bool;
    var phi_2032_: type_21;
    var phi_2055_: u32;
    var phi_2069_: i32;
    var phi_2089_: vec3<f32>;
    var phi_2090_: vec3<f32>;
    var phi_2106_: vec3<f32>;
    var phi_2107_: vec3<f32>;
    var phi_2123_: vec3<f32>;
    var phi_2124_: vec3<f32>;
    var phi_2160_: vec3<f32>;
    var phi_2342_: f32;
    var phi_2360_: bool;
    var phi_2361_: bool;
    var phi_2380_: bool;
    var phi_2381_: bool;
    var phi_2387_: type_39;
    var phi_2388_: type_39;
    var phi_2389_: type_39;
    var phi_4057_: bool;
    var phi_1101_: type_39;
    var phi_4056_: bool;
    var phi_4139_: bool;
    var phi_3629_: type_39;
    var phi_3630_: type_60;
    var phi_3631_: bool;
    var phi_3632_: u32;
    var phi_4138_: bool;
    var phi_3633_: type_39;
    var phi_3634_: type_60;
    var phi_3635_: u32;
    var phi_3636_: bool;
    var phi_3637_: u32;
    var phi_4137_: bool;
    var phi_3638_: type_39;
    var phi_3639_: type_60;
    var phi_3640_: u32;
    var phi_3641_: bool;
    var phi_3642_: u32;
    var phi_4136_: bool;
    var phi_974_: type_39;
    var phi_977_: type_60;
    var phi_979_: u32;
    var phi_981_: bool;
    var phi_983_: u32;
    var phi_3643_: bool;
    var phi_4135_: bool;
    var local_13: type_39;
    var phi_3695_: type_21;
    var local_14: type_39;

    switch bitcast<i32>(0u) {
        default: {
            let _e101 = global;
            let _e103 = arrayLength((&global_9.member));
            let _e106 = arrayLength((&global_10.member));
            let _e118 = arrayLength((&global_8.member));
            let _e122 = global_3.member[0u][0u];
            let _e126 = global_3.member[0u][1u];
            let _e130 = global_3.member[0u][2u];
            let _e134 = global_3.member[0u][3u];
            let _e138 = global_3.member[1u][0u];
            let _e142 = global_3.member[1u][1u];
            let _e146 = global_3.member[1u][2u];
            let _e150 = (_e101.x + (_e101.y * 2097152u));
            let _e162 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e134) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e122), bitcast<i32>(_e126), bitcast<i32>(_e130));
            local = array<i32, 3>(bitcast<i32>(_e138), bitcast<i32>(_e142), bitcast<i32>(_e146));
            let _e165 = (_e150 < arrayLength((&global_6.member)));
            if _e165 {
                if _e165 {
                } else {
                    break;
                }
                let _e169 = global_6.member[_e150].member_2;
                phi_340_ = _e169;
            } else {
                phi_340_ = 4294967295u;
            }
            let _e171 = phi_340_;
            let _e174 = global_1.member[0u];
            let _e178 = global_2.member[0u][0u];
            let _e182 = global_2.member[0u][1u];
            let _e186 = global_2.member[0u][2u];
            let _e190 = global_2.member[0u][3u];
            let _e194 = global_2.member[1u][0u];
            let _e198 = global_2.member[1u][1u];
            let _e202 = global_2.member[1u][2u];
            let _e206 = global_2.member[1u][3u];
            let _e207 = bitcast<f32>(_e178);
            let _e208 = bitcast<f32>(_e182);
            let _e209 = bitcast<f32>(_e186);
            let _e211 = bitcast<f32>(_e194);
            let _e212 = array<u32, 3>(_e198, _e202, _e206);
            let _e214 = bitcast<i32>(_e174);
            if (_e214 < -126i) {
                phi_384_ = -126i;
            } else {
                phi_384_ = select(_e214, 127i, (_e214 > 127i));
            }
            let _e219 = phi_384_;
            let _e224 = bitcast<f32>((bitcast<u32>((_e219 + 127i)) << bitcast<u32>(23i)));
            let _e230 = bitcast<f32>((bitcast<u32>(((_e214 - _e219) + 127i)) << bitcast<u32>(23i)));
            if (_e190 == 0u) {
                phi_408_ = type_36(array<f32, 3>(_e207, _e208, _e209), _e190, _e211, _e212);
            } else {
                phi_408_ = type_36(array<f32, 3>(((_e207 * _e224) * _e230), ((_e208 * _e224) * _e230), ((_e209 * _e224) * _e230)), _e190, ((_e211 * _e224) * _e230), _e212);
            }
            let _e243 = phi_408_;
            if _e165 {
                let _e244 = (_e150 < arrayLength((&global_7.member)));
                if _e244 {
                    if _e165 {
                    } else {
                        break;
                    }
                    let _e254 = global_6.member[_e150].member.member_2[0u];
                    let _e256 = (bitcast<u32>(_e254) & 2147483647u);
                    let _e262 = global_6.member[_e150].member.member_2[1u];
                    let _e264 = (bitcast<u32>(_e262) & 2147483647u);
                    let _e270 = global_6.member[_e150].member.member_2[2u];
                    let _e272 = (bitcast<u32>(_e270) & 2147483647u);
                    let _e278 = global_6.member[_e150].member.member[0u];
                    let _e280 = (bitcast<u32>(_e278) & 2147483647u);
                    let _e286 = global_6.member[_e150].member.member[1u];
                    let _e288 = (bitcast<u32>(_e286) & 2147483647u);
                    let _e294 = global_6.member[_e150].member.member[2u];
                    let _e296 = (bitcast<u32>(_e294) & 2147483647u);
                    let _e298 = select(_e264, _e256, (_e264 < _e256));
                    let _e300 = select(_e272, _e298, (_e272 < _e298));
                    let _e302 = select(_e280, _e300, (_e280 < _e300));
                    let _e304 = select(_e288, _e302, (_e288 < _e302));
                    let _e306 = select(_e296, _e304, (_e296 < _e304));
                    let _e311 = global_6.member[_e150].member.member_1;
                    let _e313 = (bitcast<u32>(_e311) & 2147483647u);
                    let _e321 = global_6.member[_e150].member.member_3;
                    let _e327 = (((select(_e313, _e306, (_e313 < _e306)) < 2139095040u) && ((bitcast<u32>(_e321) & 2147483647u) <= 2139095040u)) && (_e300 > 0u));
                    if _e327 {
                        let _e330 = (bitcast<u32>(bitcast<f32>(_e300)) & 2147483647u);
                        if (_e330 >= 8388608u) {
                            phi_514_ = (bitcast<i32>((_e330 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_514_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e330)), 32u, (_e330 == 0u))));
                        }
                        let _e344 = phi_514_;
                        phi_515_ = _e344;
                    } else {
                        phi_515_ = 0i;
                    }
                    let _e346 = phi_515_;
                    let _e347 = (_e256 == _e300);
                    if _e347 {
                        phi_525_ = true;
                    } else {
                        phi_525_ = (_e264 == _e300);
                    }
                    let _e350 = phi_525_;
                    let _e351 = select(1u, 0u, _e347);
                    if _e350 {
                        let _e352 = (_e351 + 1u);
                        phi_535_ = _e352;
                        phi_536_ = _e352;
                        phi_538_ = select(true, false, (_e352 == 2u));
                    } else {
                        phi_535_ = u32();
                        phi_536_ = 0u;
                        phi_538_ = true;
                    }
                    let _e356 = phi_535_;
                    let _e358 = phi_536_;
                    let _e360 = phi_538_;
                    if _e360 {
                        phi_543_ = (_e358 + 1u);
                    } else {
                        phi_543_ = 0u;
                    }
                    let _e364 = phi_543_;
                    let _e365 = select(_e356, _e358, _e360);
                    let _e366 = select(_e351, select(2u, _e351, _e350), _e360);
                    let _e367 = -(_e346);
                    if (_e367 < -126i) {
                        phi_576_ = -126i;
                    } else {
                        phi_576_ = select(_e367, 127i, (_e367 > 127i));
                    }
                    let _e372 = phi_576_;
                    let _e377 = bitcast<f32>((bitcast<u32>((_e372 + 127i)) << bitcast<u32>(23i)));
                    let _e383 = bitcast<f32>((bitcast<u32>(((_e367 - _e372) + 127i)) << bitcast<u32>(23i)));
                    let _e388 = global_6.member[_e150].member.member;
                    let _e389 = (_e365 == 0u);
                    if _e389 {
                        phi_594_ = _e388[0];
                    } else {
                        phi_594_ = _e388[1];
                    }
                    let _e393 = phi_594_;
                    let _e394 = (_e365 == 2u);
                    if _e394 {
                        phi_600_ = _e388[2];
                    } else {
                        phi_600_ = _e393;
                    }
                    let _e397 = phi_600_;
                    let _e398 = global_6.member[_e150].member.member_2;
                    if _e389 {
                        phi_611_ = _e398[0];
                    } else {
                        phi_611_ = _e398[1];
                    }
                    let _e402 = phi_611_;
                    if _e394 {
                        phi_617_ = _e398[2];
                    } else {
                        phi_617_ = _e402;
                    }
                    let _e405 = phi_617_;
                    let _e407 = ((_e405 * _e377) * _e383);
                    let _e411 = (bitcast<f32>((bitcast<u32>(_e407) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e411 {
                        let _e415 = (bitcast<f32>((bitcast<u32>(_e397) & 2147483647u)) * 0.00000011920929f);
                        phi_640_ = select(0.00000000000011368684f, _e415, (_e415 > 0.00000000000011368684f));
                    } else {
                        phi_640_ = 0f;
                    }
                    let _e419 = phi_640_;
                    let _e420 = (_e397 + _e419);
                    let _e421 = (_e397 - _e419);
                    let _e422 = select(_e407, 0f, _e411);
                    if _e411 {
                        phi_651_ = 38685626000000000000000000f;
                    } else {
                        phi_651_ = (1f / _e407);
                    }
                    let _e425 = phi_651_;
                    let _e426 = (_e364 == 0u);
                    if _e426 {
                        phi_660_ = _e388[0];
                    } else {
                        phi_660_ = _e388[1];
                    }
                    let _e430 = phi_660_;
                    let _e431 = (_e364 == 2u);
                    if _e431 {
                        phi_666_ = _e388[2];
                    } else {
                        phi_666_ = _e430;
                    }
                    let _e434 = phi_666_;
                    if _e426 {
                        phi_677_ = _e398[0];
                    } else {
                        phi_677_ = _e398[1];
                    }
                    let _e438 = phi_677_;
                    if _e431 {
                        phi_683_ = _e398[2];
                    } else {
                        phi_683_ = _e438;
                    }
                    let _e441 = phi_683_;
                    let _e443 = ((_e441 * _e377) * _e383);
                    let _e447 = (bitcast<f32>((bitcast<u32>(_e443) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e447 {
                        let _e451 = (bitcast<f32>((bitcast<u32>(_e434) & 2147483647u)) * 0.00000011920929f);
                        phi_706_ = select(0.00000000000011368684f, _e451, (_e451 > 0.00000000000011368684f));
                    } else {
                        phi_706_ = 0f;
                    }
                    let _e455 = phi_706_;
                    let _e456 = (_e434 + _e455);
                    let _e457 = (_e434 - _e455);
                    let _e458 = select(_e443, 0f, _e447);
                    if _e447 {
                        phi_717_ = 38685626000000000000000000f;
                    } else {
                        phi_717_ = (1f / _e443);
                    }
                    let _e461 = phi_717_;
                    let _e462 = (_e366 == 0u);
                    if _e462 {
                        phi_726_ = _e388[0];
                    } else {
                        phi_726_ = _e388[1];
                    }
                    let _e466 = phi_726_;
                    let _e467 = (_e366 == 2u);
                    if _e467 {
                        phi_732_ = _e388[2];
                    } else {
                        phi_732_ = _e466;
                    }
                    let _e470 = phi_732_;
                    if _e462 {
                        phi_743_ = _e398[0];
                    } else {
                        phi_743_ = _e398[1];
                    }
                    let _e474 = phi_743_;
                    if _e467 {
                        phi_749_ = _e398[2];
                    } else {
                        phi_749_ = _e474;
                    }
                    let _e477 = phi_749_;
                    let _e479 = ((_e477 * _e377) * _e383);
                    let _e483 = (bitcast<f32>((bitcast<u32>(_e479) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e483 {
                        let _e487 = (bitcast<f32>((bitcast<u32>(_e470) & 2147483647u)) * 0.00000011920929f);
                        phi_772_ = select(0.00000000000011368684f, _e487, (_e487 > 0.00000000000011368684f));
                    } else {
                        phi_772_ = 0f;
                    }
                    let _e491 = phi_772_;
                    let _e492 = (_e470 + _e491);
                    let _e493 = (_e470 - _e491);
                    let _e494 = select(_e479, 0f, _e483);
                    if _e483 {
                        phi_783_ = 38685626000000000000000000f;
                    } else {
                        phi_783_ = (1f / _e479);
                    }
                    let _e497 = phi_783_;
                    let _e500 = bitcast<f32>((bitcast<u32>(_e397) & 2147483647u));
                    let _e503 = bitcast<f32>((bitcast<u32>(_e434) & 2147483647u));
                    let _e505 = select(_e503, _e500, (_e500 > _e503));
                    let _e508 = bitcast<f32>((bitcast<u32>(_e470) & 2147483647u));
                    if (_e327 && (select(_e508, _e505, (_e505 > _e508)) <= 1099511600000f)) {
                        let _e513 = (_e346 / 3i);
                        let _e520 = bitcast<f32>((bitcast<u32>((_e513 + 127i)) << bitcast<u32>(23i)));
                        let _e527 = bitcast<f32>((bitcast<u32>(((_e346 - (2i * _e513)) + 127i)) << bitcast<u32>(23i)));
                        let _e528 = (((_e311 * _e520) * _e520) * _e527);
                        let _e530 = select(340282350000000000000000000000000000000f, _e528, (_e528 < 340282350000000000000000000000000000000f));
                        let _e535 = (((_e321 * _e520) * _e520) * _e527);
                        let _e537 = select(340282350000000000000000000000000000000f, _e535, (_e535 < 340282350000000000000000000000000000000f));
                        phi_883_ = select(-340282350000000000000000000000000000000f, _e537, (_e537 > -340282350000000000000000000000000000000f));
                        phi_884_ = select(-340282350000000000000000000000000000000f, _e530, (_e530 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_883_ = 0f;
                        phi_884_ = 1f;
                    }
                    let _e541 = phi_883_;
                    let _e543 = phi_884_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e547 = (_e365 % 3u);
                    let _e548 = (_e547 < 3u);
                    if _e548 {
                    } else {
                        break;
                    }
                    let _e550 = local_1[_e547];
                    let _e553 = (_e364 % 3u);
                    let _e554 = (_e553 < 3u);
                    if _e554 {
                    } else {
                        break;
                    }
                    let _e556 = local_1[_e553];
                    let _e559 = (_e366 % 3u);
                    let _e560 = (_e559 < 3u);
                    if _e560 {
                    } else {
                        break;
                    }
                    let _e562 = local_1[_e559];
                    if _e548 {
                    } else {
                        break;
                    }
                    let _e567 = local[_e547];
                    if _e554 {
                    } else {
                        break;
                    }
                    let _e571 = local[_e553];
                    if _e560 {
                    } else {
                        break;
                    }
                    let _e575 = local[_e559];
                    phi_3997_ = false;
                    phi_973_ = type_39(type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e541);
                    phi_976_ = type_60(type_33(vec4<f32>((f32(_e550) * _e162), (f32(_e556) * _e162), (f32(_e562) * _e162), 0f), vec4<f32>((f32(_e567) * _e162), (f32(_e571) * _e162), (f32(_e575) * _e162), 0f)), select(0u, 2147483648u, (_e103 == 0u)));
                    phi_978_ = ((3u * _e103) + 1u);
                    phi_980_ = (_e543 <= _e541);
                    phi_982_ = 0u;
                    loop {
                        let _e585 = phi_3997_;
                        let _e587 = phi_973_;
                        let _e589 = phi_976_;
                        let _e591 = phi_978_;
                        let _e593 = phi_980_;
                        let _e595 = phi_982_;
                        local_13 = _e587;
                        if _e593 {
                            phi_993_ = true;
                        } else {
                            phi_993_ = (_e595 > 0u);
                        }
                        let _e598 = phi_993_;
                        if _e598 {
                            let _e599 = (_e591 > 0u);
                            if _e599 {
                                if _e593 {
                                    phi_1079_ = _e589;
                                    phi_1080_ = _e593;
                                    phi_1081_ = _e595;
                                } else {
                                    let _e600 = (_e595 - 1u);
                                    let _e601 = (_e600 % 128u);
                                    let _e602 = (_e601 < 128u);
                                    if _e602 {
                                    } else {
                                        phi_4135_ = true;
                                        break;
                                    }
                                    let _e604 = local_7[_e601];
                                    if _e602 {
                                    } else {
                                        phi_4135_ = true;
                                        break;
                                    }
                                    let _e606 = local_6[_e601];
                                    if _e602 {
                                    } else {
                                        phi_4135_ = true;
                                        break;
                                    }
                                    let _e608 = local_5[_e601];
                                    if _e602 {
                                    } else {
                                        phi_4135_ = true;
                                        break;
                                    }
                                    let _e610 = local_4[_e601];
                                    if _e602 {
                                    } else {
                                        phi_4135_ = true;
                                        break;
                                    }
                                    let _e612 = local_3[_e601];
                                    if _e602 {
                                    } else {
                                        phi_4135_ = true;
                                        break;
                                    }
                                    let _e614 = local_2[_e601];
                                    if _e602 {
                                    } else {
                                        phi_4135_ = true;
                                        break;
                                    }
                                    let _e619 = local_8[_e601];
                                    if _e602 {
                                    } else {
                                        phi_4135_ = true;
                                        break;
                                    }
                                    let _e622 = local_9[_e601];
                                    phi_1079_ = type_60(type_33(vec4<f32>(_e604, _e606, _e608, 0f), vec4<f32>(_e610, _e612, _e614, 0f)), _e619);
                                    phi_1080_ = (_e622 <= _e587.member_1);
                                    phi_1081_ = _e600;
                                }
                                let _e626 = phi_1079_;
                                let _e628 = phi_1080_;
                                let _e630 = phi_1081_;
                                if _e628 {
                                    let _e635 = (_e626.member_1 & 268435455u);
                                    if ((_e626.member_1 & 2147483648u) != 0u) {
                                        phi_3994_ = _e585;
                                        phi_1100_ = _e587;
                                        phi_1103_ = type_8(0u, ((_e626.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1113 = phi_3994_;
                                            let _e1115 = phi_1100_;
                                            let _e1117 = phi_1103_;
                                            local_14 = _e1115;
                                            if (_e1117.member < _e1117.member_1) {
                                                phi_1104_ = type_8((_e1117.member + 1u), _e1117.member_1);
                                                phi_1126_ = type_8(1u, _e1117.member);
                                            } else {
                                                phi_1104_ = _e1117;
                                                phi_1126_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1130 = phi_1104_;
                                            let _e1132 = phi_1126_;
                                            let _e1136 = (bitcast<i32>(_e1132.member) != 0i);
                                            if _e1136 {
                                                let _e1141 = (_e626.member.member_1.x - _e626.member.member.x);
                                                let _e1144 = (_e626.member.member_1.y - _e626.member.member.y);
                                                let _e1147 = (_e626.member.member_1.z - _e626.member.member.z);
                                                let _e1149 = select(_e1144, _e1141, (_e1141 > _e1144));
                                                let _e1151 = select(_e1147, _e1149, (_e1149 > _e1147));
                                                let _e1153 = (_e1151 < (1024f * _e162));
                                                if _e1153 {
                                                    phi_1167_ = 0u;
                                                } else {
                                                    phi_1167_ = select(2u, 1u, (_e1151 < (2097152f * _e162)));
                                                }
                                                let _e1158 = phi_1167_;
                                                switch bitcast<i32>(_e1158) {
                                                    case 0: {
                                                        phi_1173_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1173_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1173_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1173_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1161 = phi_1173_;
                                                switch bitcast<i32>(_e1158) {
                                                    case 0: {
                                                        phi_1183_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1183_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1183_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1183_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1168 = phi_1183_;
                                                let _e1170 = ((_e635 + (_e1132.member_1 * ((3u * _e1161) + 1u))) + (3u * _e1168));
                                                let _e1171 = (_e1170 < _e106);
                                                if _e1171 {
                                                    if _e1171 {
                                                    } else {
                                                        phi_4056_ = true;
                                                        break;
                                                    }
                                                    let _e1173 = global_10.member[_e1170];
                                                    phi_1199_ = _e1173;
                                                } else {
                                                    phi_1199_ = 4294967295u;
                                                }
                                                let _e1175 = phi_1199_;
                                                local_10 = array<u32, 3>(_e365, _e364, _e366);
                                                if _e1153 {
                                                    phi_1236_ = 0u;
                                                } else {
                                                    phi_1236_ = select(2u, 1u, (_e1151 < (2097152f * _e162)));
                                                }
                                                let _e1181 = phi_1236_;
                                                switch bitcast<i32>(_e1181) {
                                                    case 0: {
                                                        phi_1242_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1242_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1242_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1242_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1184 = phi_1242_;
                                                switch bitcast<i32>(_e1181) {
                                                    case 0: {
                                                        phi_1252_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1252_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1252_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1252_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1191 = phi_1252_;
                                                local_12 = array<f32, 4>(_e626.member.member.x, _e626.member.member.y, _e626.member.member.z, _e626.member.member.w);
                                                local_11[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_11[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_11[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_3979_ = _e1113;
                                                phi_1268_ = type_8(0u, 3u);
                                                loop {
                                                    let _e1205 = phi_3979_;
                                                    let _e1207 = phi_1268_;
                                                    if (_e1207.member < _e1207.member_1) {
                                                        phi_1269_ = type_8((_e1207.member + 1u), _e1207.member_1);
                                                        phi_1292_ = type_8(1u, _e1207.member);
                                                    } else {
                                                        phi_1269_ = _e1207;
                                                        phi_1292_ = type_8(0u, type_8().member_1);
                                                    }
                                                    let _e1220 = phi_1269_;
                                                    let _e1222 = phi_1292_;
                                                    let _e1226 = (bitcast<i32>(_e1222.member) != 0i);
                                                    if _e1226 {
                                                        let _e1228 = ((_e635 + (_e1132.member_1 * ((3u * _e1184) + 1u))) + (_e1222.member_1 * _e1191));
                                                        let _e1229 = (_e1228 < _e106);
                                                        if _e1229 {
                                                            if _e1229 {
                                                            } else {
                                                                phi_4054_ = true;
                                                                break;
                                                            }
                                                            let _e1231 = global_10.member[_e1228];
                                                            phi_1315_ = _e1231;
                                                        } else {
                                                            phi_1315_ = 0u;
                                                        }
                                                        let _e1233 = phi_1315_;
                                                        let _e1234 = (_e1228 + 1u);
                                                        let _e1235 = (_e1234 < _e106);
                                                        if _e1235 {
                                                            if _e1235 {
                                                            } else {
                                                                phi_4054_ = true;
                                                                break;
                                                            }
                                                            let _e1237 = global_10.member[_e1234];
                                                            phi_1330_ = _e1237;
                                                        } else {
                                                            phi_1330_ = 0u;
                                                        }
                                                        let _e1239 = phi_1330_;
                                                        phi_1333_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e1241 = phi_1333_;
                                                            if (_e1241.member < _e1241.member_1) {
                                                                phi_1334_ = type_8((_e1241.member + 1u), _e1241.member_1);
                                                                phi_1357_ = type_8(1u, _e1241.member);
                                                            } else {
                                                                phi_1334_ = _e1241;
                                                                phi_1357_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1254 = phi_1334_;
                                                            let _e1256 = phi_1357_;
                                                            let _e1260 = (bitcast<i32>(_e1256.member) != 0i);
                                                            if _e1260 {
                                                                let _e1261 = (_e1256.member_1 < 3u);
                                                                if _e1261 {
                                                                } else {
                                                                    phi_3972_ = true;
                                                                    break;
                                                                }
                                                                let _e1263 = local_10[_e1256.member_1];
                                                                if (_e1256.member_1 < 4u) {
                                                                } else {
                                                                    phi_3972_ = true;
                                                                    break;
                                                                }
                                                                let _e1266 = local_12[_e1256.member_1];
                                                                switch bitcast<i32>(_e1181) {
                                                                    case 0: {
                                                                        phi_1427_ = (_e1266 + (f32(((_e1233 >> bitcast<u32>(((10u * _e1263) & 31u))) & 1023u)) * _e162));
                                                                        break;
                                                                    }
                                                                    case 1: {
                                                                        if (_e1263 == 0u) {
                                                                            phi_1404_ = _e1233;
                                                                        } else {
                                                                            if (_e1263 == 1u) {
                                                                                phi_1403_ = ((_e1233 >> bitcast<u32>(21i)) | (_e1239 << bitcast<u32>(11i)));
                                                                            } else {
                                                                                phi_1403_ = (_e1239 >> bitcast<u32>(10i));
                                                                            }
                                                                            let _e1287 = phi_1403_;
                                                                            phi_1404_ = _e1287;
                                                                        }
                                                                        let _e1289 = phi_1404_;
                                                                        phi_1427_ = (_e1266 + (f32((_e1289 & 2097151u)) * _e162));
                                                                        break;
                                                                    }
                                                                    case 2: {
                                                                        let _e1268 = (_e1228 + _e1263);
                                                                        let _e1269 = (_e1268 < _e106);
                                                                        if _e1269 {
                                                                            if _e1269 {
                                                                            } else {
                                                                                phi_3972_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1271 = global_10.member[_e1268];
                                                                            phi_1423_ = _e1271;
                                                                        } else {
                                                                            phi_1423_ = 0u;
                                                                        }
                                                                        let _e1273 = phi_1423_;
                                                                        phi_1427_ = (f32(bitcast<i32>(_e1273)) * _e162);
                                                                        break;
                                                                    }
                                                                    default: {
                                                                        phi_1427_ = f32();
                                                                        break;
                                                                    }
                                                                }
                                                                let _e1303 = phi_1427_;
                                                                if (_e1222.member_1 < 3u) {
                                                                } else {
                                                                    phi_3972_ = true;
                                                                    break;
                                                                }
                                                                if _e1261 {
                                                                } else {
                                                                    phi_3972_ = true;
                                                                    break;
                                                                }
                                                                local_11[_e1222.member_1][_e1256.member_1] = _e1303;
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_1333_ = _e1254;
                                                                phi_3972_ = _e1205;
                                                                break if !(_e1260);
                                                            }
                                                        }
                                                        let _e1309 = phi_3972_;
                                                        phi_4054_ = _e1309;
                                                        if _e1309 {
                                                            break;
                                                        }
                                                        phi_4055_ = _e1309;
                                                    } else {
                                                        phi_4055_ = _e1205;
                                                    }
                                                    let _e1311 = phi_4055_;
                                                    continue;
                                                    continuing {
                                                        phi_3979_ = _e1311;
                                                        phi_1268_ = _e1220;
                                                        phi_4054_ = _e1311;
                                                        break if !(_e1226);
                                                    }
                                                }
                                                let _e1314 = phi_4054_;
                                                phi_4056_ = _e1314;
                                                if _e1314 {
                                                    break;
                                                }
                                                let _e1315 = local_11;
                                                let _e1331 = (_e1315[0][2] - _e470);
                                                let _e1334 = (((_e1315[0][0] - _e397) * _e494) - (_e1331 * _e422));
                                                let _e1337 = (((_e1315[0][1] - _e434) * _e494) - (_e1331 * _e458));
                                                let _e1340 = (_e1315[1][2] - _e470);
                                                let _e1343 = (((_e1315[1][0] - _e397) * _e494) - (_e1340 * _e422));
                                                let _e1346 = (((_e1315[1][1] - _e434) * _e494) - (_e1340 * _e458));
                                                let _e1349 = (_e1315[2][2] - _e470);
                                                let _e1352 = (((_e1315[2][0] - _e397) * _e494) - (_e1349 * _e422));
                                                let _e1355 = (((_e1315[2][1] - _e434) * _e494) - (_e1349 * _e458));
                                                let _e1356 = (_e1352 * _e1346);
                                                let _e1357 = (_e1355 * _e1343);
                                                let _e1358 = (_e1334 * _e1355);
                                                let _e1359 = (_e1337 * _e1352);
                                                let _e1360 = (_e1343 * _e1337);
                                                let _e1361 = (_e1346 * _e1334);
                                                let _e1366 = (((_e1356 >= _e1357) && (_e1358 >= _e1359)) && (_e1360 >= _e1361));
                                                if (_e1366 || (((_e1356 <= _e1357) && (_e1358 <= _e1359)) && (_e1360 <= _e1361))) {
                                                    let _e1373 = select(-1f, 1f, _e1366);
                                                    let _e1375 = ((_e1356 - _e1357) * _e1373);
                                                    let _e1377 = select(0f, _e1375, (_e1375 > 0f));
                                                    let _e1379 = ((_e1358 - _e1359) * _e1373);
                                                    let _e1381 = select(0f, _e1379, (_e1379 > 0f));
                                                    let _e1383 = ((_e1360 - _e1361) * _e1373);
                                                    let _e1385 = select(0f, _e1383, (_e1383 > 0f));
                                                    let _e1387 = ((_e1377 + _e1381) + _e1385);
                                                    if (_e1387 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2022_ = type_21();
                                                        phi_2023_ = true;
                                                    } else {
                                                        let _e1390 = select(_e1315[1][0], _e1315[0][0], (_e1315[0][0] < _e1315[1][0]));
                                                        let _e1394 = select(_e1315[1][0], _e1315[0][0], (_e1315[0][0] > _e1315[1][0]));
                                                        let _e1398 = select(_e1315[1][1], _e1315[0][1], (_e1315[0][1] < _e1315[1][1]));
                                                        let _e1402 = select(_e1315[1][1], _e1315[0][1], (_e1315[0][1] > _e1315[1][1]));
                                                        let _e1406 = select(_e1315[1][2], _e1315[0][2], (_e1315[0][2] < _e1315[1][2]));
                                                        let _e1410 = select(_e1315[1][2], _e1315[0][2], (_e1315[0][2] > _e1315[1][2]));
                                                        let _e1415 = ((select(_e1315[2][0], _e1390, (_e1390 < _e1315[2][0])) - _e420) * _e425);
                                                        let _e1416 = ((select(_e1315[2][0], _e1394, (_e1394 > _e1315[2][0])) - _e421) * _e425);
                                                        let _e1419 = ((select(_e1315[2][1], _e1398, (_e1398 < _e1315[2][1])) - _e456) * _e461);
                                                        let _e1420 = ((select(_e1315[2][1], _e1402, (_e1402 > _e1315[2][1])) - _e457) * _e461);
                                                        let _e1423 = ((select(_e1315[2][2], _e1406, (_e1406 < _e1315[2][2])) - _e492) * _e497);
                                                        let _e1424 = ((select(_e1315[2][2], _e1410, (_e1410 > _e1315[2][2])) - _e493) * _e497);
                                                        let _e1426 = select(_e1424, _e1423, (_e1423 < _e1424));
                                                        let _e1428 = select(_e1424, _e1423, (_e1423 > _e1424));
                                                        let _e1430 = select(_e1416, _e1415, (_e1415 < _e1416));
                                                        let _e1432 = select(_e1420, _e1419, (_e1419 < _e1420));
                                                        let _e1434 = select(_e1432, _e1430, (_e1430 > _e1432));
                                                        let _e1436 = select(_e1426, _e1434, (_e1434 > _e1426));
                                                        let _e1438 = select(_e1416, _e1415, (_e1415 > _e1416));
                                                        let _e1440 = select(_e1420, _e1419, (_e1419 > _e1420));
                                                        let _e1442 = select(_e1440, _e1438, (_e1438 < _e1440));
                                                        let _e1444 = select(_e1428, _e1442, (_e1442 < _e1428));
                                                        let _e1445 = -(_e1426);
                                                        let _e1451 = select(_e543, _e1436, (_e1436 > _e543));
                                                        if (_e1451 > (_e1444 + (select(_e1445, _e1428, (_e1428 > _e1445)) * 0.0000019073523f))) {
                                                            phi_2017_ = type_21();
                                                            phi_2018_ = true;
                                                        } else {
                                                            let _e1453 = (_e1451 > _e1115.member_1);
                                                            if _e1453 {
                                                                phi_2016_ = type_21();
                                                            } else {
                                                                let _e1457 = (_e1315[1][0] - _e1315[0][0]);
                                                                let _e1458 = (_e1315[1][1] - _e1315[0][1]);
                                                                let _e1459 = (_e1315[1][2] - _e1315[0][2]);
                                                                let _e1460 = vec3<f32>(_e1457, _e1458, _e1459);
                                                                let _e1461 = (_e1315[2][0] - _e1315[1][0]);
                                                                let _e1462 = (_e1315[2][1] - _e1315[1][1]);
                                                                let _e1463 = (_e1315[2][2] - _e1315[1][2]);
                                                                let _e1464 = vec3<f32>(_e1461, _e1462, _e1463);
                                                                let _e1465 = (_e1315[0][0] - _e1315[2][0]);
                                                                let _e1466 = (_e1315[0][1] - _e1315[2][1]);
                                                                let _e1467 = (_e1315[0][2] - _e1315[2][2]);
                                                                let _e1468 = vec3<f32>(_e1465, _e1466, _e1467);
                                                                let _e1471 = bitcast<f32>((bitcast<u32>(_e1457) & 2147483647u));
                                                                let _e1474 = bitcast<f32>((bitcast<u32>(_e1458) & 2147483647u));
                                                                let _e1476 = select(_e1474, _e1471, (_e1471 > _e1474));
                                                                let _e1479 = bitcast<f32>((bitcast<u32>(_e1459) & 2147483647u));
                                                                let _e1481 = select(_e1479, _e1476, (_e1476 > _e1479));
                                                                let _e1484 = bitcast<f32>((bitcast<u32>(_e1461) & 2147483647u));
                                                                let _e1487 = bitcast<f32>((bitcast<u32>(_e1462) & 2147483647u));
                                                                let _e1489 = select(_e1487, _e1484, (_e1484 > _e1487));
                                                                let _e1492 = bitcast<f32>((bitcast<u32>(_e1463) & 2147483647u));
                                                                let _e1494 = select(_e1492, _e1489, (_e1489 > _e1492));
                                                                let _e1497 = bitcast<f32>((bitcast<u32>(_e1465) & 2147483647u));
                                                                let _e1500 = bitcast<f32>((bitcast<u32>(_e1466) & 2147483647u));
                                                                let _e1502 = select(_e1500, _e1497, (_e1497 > _e1500));
                                                                let _e1505 = bitcast<f32>((bitcast<u32>(_e1467) & 2147483647u));
                                                                let _e1507 = select(_e1505, _e1502, (_e1502 > _e1505));
                                                                let _e1509 = select(_e1494, _e1481, (_e1481 > _e1494));
                                                                let _e1511 = select(_e1507, _e1509, (_e1509 > _e1507));
                                                                if (_e1481 == _e1511) {
                                                                    phi_1927_ = _e1464;
                                                                    phi_1928_ = _e1468;
                                                                } else {
                                                                    let _e1514 = vec3((_e1494 == _e1511));
                                                                    phi_1927_ = select(_e1460, _e1468, _e1514);
                                                                    phi_1928_ = select(_e1464, _e1460, _e1514);
                                                                }
                                                                let _e1518 = phi_1927_;
                                                                let _e1520 = phi_1928_;
                                                                let _e1527 = ((_e1518.y * _e1520.z) - (_e1520.y * _e1518.z));
                                                                let _e1532 = ((_e1518.z * _e1520.x) - (_e1520.z * _e1518.x));
                                                                let _e1535 = ((_e1518.x * _e1520.y) - (_e1520.x * _e1518.y));
                                                                if (_e1377 >= _e1381) {
                                                                    phi_1959_ = select(true, false, (_e1377 >= _e1385));
                                                                } else {
                                                                    phi_1959_ = true;
                                                                }
                                                                let _e1540 = phi_1959_;
                                                                if _e1540 {
                                                                    phi_1968_ = select(vec3<f32>(_e1315[2][0], _e1315[2][1], _e1315[2][2]), vec3<f32>(_e1315[1][0], _e1315[1][1], _e1315[1][2]), vec3((_e1381 >= _e1385)));
                                                                } else {
                                                                    phi_1968_ = vec3<f32>(_e1315[0][0], _e1315[0][1], _e1315[0][2]);
                                                                }
                                                                let _e1545 = phi_1968_;
                                                                let _e1562 = ((((_e1527 * (_e1545.x - _e397)) + (_e1532 * (_e1545.y - _e434))) + (_e1535 * (_e1545.z - _e470))) / (((_e1527 * _e422) + (_e1532 * _e458)) + (_e1535 * _e494)));
                                                                let _e1564 = select(_e1444, _e1562, (_e1562 < _e1444));
                                                                let _e1566 = select(_e1436, _e1564, (_e1564 > _e1436));
                                                                if (_e1566 >= _e543) {
                                                                    let _e1568 = (_e1566 <= _e1115.member_1);
                                                                    if _e1568 {
                                                                        let _e1569 = (1f / _e1387);
                                                                        phi_2008_ = type_21(_e1566, (_e1381 * _e1569), (_e1385 * _e1569), _e1175);
                                                                    } else {
                                                                        phi_2008_ = type_21();
                                                                    }
                                                                    let _e1574 = phi_2008_;
                                                                    phi_2010_ = _e1574;
                                                                    phi_2011_ = select(true, false, _e1568);
                                                                } else {
                                                                    phi_2010_ = type_21();
                                                                    phi_2011_ = true;
                                                                }
                                                                let _e1577 = phi_2010_;
                                                                let _e1579 = phi_2011_;
                                                                if _e1579 {
                                                                    phi_2015_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2015_ = _e1577;
                                                                }
                                                                let _e1581 = phi_2015_;
                                                                phi_2016_ = _e1581;
                                                            }
                                                            let _e1583 = phi_2016_;
                                                            phi_2017_ = _e1583;
                                                            phi_2018_ = _e1453;
                                                        }
                                                        let _e1585 = phi_2017_;
                                                        let _e1587 = phi_2018_;
                                                        phi_2022_ = _e1585;
                                                        phi_2023_ = _e1587;
                                                    }
                                                    let _e1589 = phi_2022_;
                                                    let _e1591 = phi_2023_;
                                                    phi_2027_ = _e1589;
                                                    phi_2028_ = _e1591;
                                                } else {
                                                    phi_2027_ = type_21();
                                                    phi_2028_ = true;
                                                }
                                                let _e1593 = phi_2027_;
                                                let _e1595 = phi_2028_;
                                                if _e1595 {
                                                    phi_2032_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2032_ = _e1593;
                                                }
                                                let _e1597 = phi_2032_;
                                                if (_e1597.member_3 != 4294967295u) {
                                                    if (_e1175 == _e171) {
                                                        phi_2361_ = false;
                                                    } else {
                                                        let _e1601 = (_e1175 < arrayLength((&global_4.member)));
                                                        if _e1601 {
                                                            if _e1601 {
                                                            } else {
                                                                phi_4056_ = true;
                                                                break;
                                                            }
                                                            let _e1603 = global_4.member[_e1175];
                                                            phi_2055_ = _e1603;
                                                        } else {
                                                            phi_2055_ = 4294967295u;
                                                        }
                                                        let _e1605 = phi_2055_;
                                                        let _e1606 = (_e1605 < arrayLength((&global_5.member)));
                                                        if _e1606 {
                                                            if _e1606 {
                                                            } else {
                                                                phi_4056_ = true;
                                                                break;
                                                            }
                                                            let _e1608 = global_5.member[_e1605];
                                                            phi_2069_ = _e1608;
                                                        } else {
                                                            phi_2069_ = 0i;
                                                        }
                                                        let _e1610 = phi_2069_;
                                                        let _e1611 = (_e1610 == 0i);
                                                        if _e1611 {
                                                            phi_2360_ = true;
                                                        } else {
                                                            if _e389 {
                                                                phi_2090_ = vec3<f32>(_e1315[0][0], _e1315[0][1], _e1315[0][2]);
                                                            } else {
                                                                if (_e365 == 1u) {
                                                                    phi_2089_ = vec3<f32>(_e1315[0][2], _e1315[0][0], _e1315[0][1]);
                                                                } else {
                                                                    phi_2089_ = vec3<f32>(_e1315[0][1], _e1315[0][2], _e1315[0][0]);
                                                                }
                                                                let _e1616 = phi_2089_;
                                                                phi_2090_ = _e1616;
                                                            }
                                                            let _e1619 = phi_2090_;
                                                            if _e389 {
                                                                phi_2107_ = vec3<f32>(_e1315[1][0], _e1315[1][1], _e1315[1][2]);
                                                            } else {
                                                                if (_e365 == 1u) {
                                                                    phi_2106_ = vec3<f32>(_e1315[1][2], _e1315[1][0], _e1315[1][1]);
                                                                } else {
                                                                    phi_2106_ = vec3<f32>(_e1315[1][1], _e1315[1][2], _e1315[1][0]);
                                                                }
                                                                let _e1624 = phi_2106_;
                                                                phi_2107_ = _e1624;
                                                            }
                                                            let _e1627 = phi_2107_;
                                                            if _e389 {
                                                                phi_2124_ = vec3<f32>(_e1315[2][0], _e1315[2][1], _e1315[2][2]);
                                                            } else {
                                                                if (_e365 == 1u) {
                                                                    phi_2123_ = vec3<f32>(_e1315[2][2], _e1315[2][0], _e1315[2][1]);
                                                                } else {
                                                                    phi_2123_ = vec3<f32>(_e1315[2][1], _e1315[2][2], _e1315[2][0]);
                                                                }
                                                                let _e1632 = phi_2123_;
                                                                phi_2124_ = _e1632;
                                                            }
                                                            let _e1635 = phi_2124_;
                                                            let _e1638 = (_e1627.x - _e1619.x);
                                                            let _e1641 = (_e1627.y - _e1619.y);
                                                            let _e1644 = (_e1627.z - _e1619.z);
                                                            let _e1646 = (_e1635.x - _e1619.x);
                                                            let _e1648 = (_e1635.y - _e1619.y);
                                                            let _e1650 = (_e1635.z - _e1619.z);
                                                            if (_e243.member_1 == 1u) {
                                                                phi_2160_ = (vec3<f32>(_e243.member[0], _e243.member[1], _e243.member[2]) - _e1619);
                                                            } else {
                                                                phi_2160_ = vec3<f32>(_e243.member[0], _e243.member[1], _e243.member[2]);
                                                            }
                                                            let _e1665 = phi_2160_;
                                                            let _e1671 = bitcast<f32>((bitcast<u32>((_e1638 * _e1648)) ^ _e243.member_3[0]));
                                                            let _e1675 = bitcast<f32>((bitcast<u32>((_e1641 * _e1646)) ^ _e243.member_3[0]));
                                                            let _e1679 = bitcast<f32>((bitcast<u32>((_e1641 * _e1650)) ^ _e243.member_3[0]));
                                                            let _e1683 = bitcast<f32>((bitcast<u32>((_e1644 * _e1648)) ^ _e243.member_3[0]));
                                                            let _e1687 = bitcast<f32>((bitcast<u32>((_e1644 * _e1646)) ^ _e243.member_3[0]));
                                                            let _e1691 = bitcast<f32>((bitcast<u32>((_e1638 * _e1650)) ^ _e243.member_3[0]));
                                                            let _e1692 = (_e1679 - _e1683);
                                                            let _e1693 = (_e1687 - _e1691);
                                                            let _e1694 = (_e1671 - _e1675);
                                                            let _e1718 = (bitcast<f32>((bitcast<u32>(_e1679) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1683) & 2147483647u)));
                                                            let _e1725 = (bitcast<f32>((bitcast<u32>(_e1687) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1691) & 2147483647u)));
                                                            let _e1732 = (bitcast<f32>((bitcast<u32>(_e1671) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1675) & 2147483647u)));
                                                            if (_e243.member_2 == 0f) {
                                                                phi_2342_ = 0f;
                                                            } else {
                                                                let _e1762 = bitcast<f32>((bitcast<u32>(_e1692) & 2147483647u));
                                                                let _e1765 = bitcast<f32>((bitcast<u32>(_e1693) & 2147483647u));
                                                                let _e1768 = bitcast<f32>((bitcast<u32>(_e1694) & 2147483647u));
                                                                let _e1770 = select(_e1768, _e1765, (_e1765 > _e1768));
                                                                let _e1774 = select(_e1768, _e1765, (_e1765 < _e1768));
                                                                let _e1778 = select(_e1765, _e1762, (_e1762 < _e1765));
                                                                let _e1780 = select(_e1765, _e1762, (_e1762 > _e1765));
                                                                let _e1782 = select(_e1768, _e1780, (_e1780 < _e1768));
                                                                phi_2342_ = bitcast<f32>((bitcast<u32>((_e243.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1770, _e1762, (_e1762 > _e1770)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1782, _e1778, (_e1778 > _e1782)))) ^ _e243.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1774, _e1762, (_e1762 < _e1774)))) ^ _e243.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1718 + _e1725) + _e1732))) ^ _e243.member_3[0]))) * 1.0000005f)) ^ _e243.member_3[0])))) ^ _e243.member_3[0]));
                                                            }
                                                            let _e1809 = phi_2342_;
                                                            phi_2360_ = (_e1611 || !(((((bitcast<f32>((bitcast<u32>((_e1665.x * _e1692)) ^ _e243.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1665.y * _e1693)) ^ _e243.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1665.z * _e1694)) ^ _e243.member_3[0]))) * f32(-(_e1610))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1665.x) & 2147483647u)) * _e1718)) ^ _e243.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1665.y) & 2147483647u)) * _e1725)) ^ _e243.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1665.z) & 2147483647u)) * _e1732)) ^ _e243.member_3[0]))))) ^ _e243.member_3[0])) + _e1809) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1823 = phi_2360_;
                                                        phi_2361_ = _e1823;
                                                    }
                                                    let _e1825 = phi_2361_;
                                                    if _e1825 {
                                                        if (_e1597.member < _e1115.member.member) {
                                                            phi_2381_ = true;
                                                        } else {
                                                            if (_e1597.member == _e1115.member.member) {
                                                                phi_2380_ = (_e1597.member_3 < _e1115.member.member_3);
                                                            } else {
                                                                phi_2380_ = false;
                                                            }
                                                            let _e1835 = phi_2380_;
                                                            phi_2381_ = _e1835;
                                                        }
                                                        let _e1837 = phi_2381_;
                                                        if _e1837 {
                                                            phi_2387_ = type_39(_e1597, _e1597.member);
                                                        } else {
                                                            phi_2387_ = _e1115;
                                                        }
                                                        let _e1840 = phi_2387_;
                                                        phi_2388_ = _e1840;
                                                    } else {
                                                        phi_2388_ = _e1115;
                                                    }
                                                    let _e1842 = phi_2388_;
                                                    phi_2389_ = _e1842;
                                                } else {
                                                    phi_2389_ = _e1115;
                                                }
                                                let _e1844 = phi_2389_;
                                                phi_4057_ = _e1314;
                                                phi_1101_ = _e1844;
                                            } else {
                                                phi_4057_ = _e1113;
                                                phi_1101_ = type_39();
                                            }
                                            let _e1846 = phi_4057_;
                                            let _e1848 = phi_1101_;
                                            continue;
                                            continuing {
                                                phi_3994_ = _e1846;
                                                phi_1100_ = _e1848;
                                                phi_1103_ = _e1130;
                                                phi_4056_ = _e1846;
                                                break if !(_e1136);
                                            }
                                        }
                                        let _e1851 = phi_4056_;
                                        phi_4135_ = _e1851;
                                        if _e1851 {
                                            break;
                                        }
                                        phi_4139_ = _e1851;
                                        let _e2091 = local_14;
                                        phi_3629_ = _e2091;
                                        phi_3630_ = _e626;
                                        phi_3631_ = false;
                                        phi_3632_ = _e630;
                                    } else {
                                        if (_e626.member_1 >= _e103) {
                                            phi_3185_ = type_61(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_60(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_60(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e626.member_1 < _e103) {
                                            } else {
                                                phi_4135_ = true;
                                                break;
                                            }
                                            let _e642 = (_e365 * 2u);
                                            let _e644 = ((1u + _e642) % 7u);
                                            if (_e644 < 7u) {
                                            } else {
                                                phi_4135_ = true;
                                                break;
                                            }
                                            let _e649 = global_9.member[_e626.member_1][_e644];
                                            let _e651 = ((_e642 + 2u) % 7u);
                                            if (_e651 < 7u) {
                                            } else {
                                                phi_4135_ = true;
                                                break;
                                            }
                                            let _e656 = global_9.member[_e626.member_1][_e651];
                                            let _e657 = (_e364 * 2u);
                                            let _e659 = ((1u + _e657) % 7u);
                                            if (_e659 < 7u) {
                                            } else {
                                                phi_4135_ = true;
                                                break;
                                            }
                                            let _e664 = global_9.member[_e626.member_1][_e659];
                                            let _e666 = ((_e657 + 2u) % 7u);
                                            if (_e666 < 7u) {
                                            } else {
                                                phi_4135_ = true;
                                                break;
                                            }
                                            let _e671 = global_9.member[_e626.member_1][_e666];
                                            let _e672 = (_e366 * 2u);
                                            let _e674 = ((1u + _e672) % 7u);
                                            if (_e674 < 7u) {
                                            } else {
                                                phi_4135_ = true;
                                                break;
                                            }
                                            let _e679 = global_9.member[_e626.member_1][_e674];
                                            let _e681 = ((_e672 + 2u) % 7u);
                                            if (_e681 < 7u) {
                                            } else {
                                                phi_4135_ = true;
                                                break;
                                            }
                                            let _e686 = global_9.member[_e626.member_1][_e681];
                                            let _e709 = (bitcast<f32>((bitcast<u32>((_e626.member.member_1.x - _e626.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e710 = (bitcast<f32>((bitcast<u32>((_e626.member.member_1.y - _e626.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e711 = (bitcast<f32>((bitcast<u32>((_e626.member.member_1.z - _e626.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e713 = select(_e162, _e709, (_e709 > _e162));
                                            let _e715 = select(_e162, _e710, (_e710 > _e162));
                                            let _e717 = select(_e162, _e711, (_e711 > _e162));
                                            let _e742 = bitcast<u32>((f32(bitcast<i32>((_e649 & 2097151u))) * _e713));
                                            let _e747 = (bitcast<i32>((_e649 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e750 = bitcast<f32>((_e742 & bitcast<u32>(_e747)));
                                            let _e751 = bitcast<u32>((f32(bitcast<i32>((_e664 & 2097151u))) * _e715));
                                            let _e756 = (bitcast<i32>((_e664 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e759 = bitcast<f32>((_e751 & bitcast<u32>(_e756)));
                                            let _e760 = bitcast<u32>((f32(bitcast<i32>((_e679 & 2097151u))) * _e717));
                                            let _e765 = (bitcast<i32>((_e679 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e768 = bitcast<f32>((_e760 & bitcast<u32>(_e765)));
                                            let _e772 = bitcast<f32>((_e742 & bitcast<u32>(~(_e747))));
                                            let _e776 = bitcast<f32>((_e751 & bitcast<u32>(~(_e756))));
                                            let _e780 = bitcast<f32>((_e760 & bitcast<u32>(~(_e765))));
                                            let _e781 = bitcast<u32>((f32(bitcast<i32>((_e656 & 2097151u))) * _e713));
                                            let _e786 = (bitcast<i32>((_e656 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e789 = bitcast<f32>((_e781 & bitcast<u32>(_e786)));
                                            let _e790 = bitcast<u32>((f32(bitcast<i32>((_e671 & 2097151u))) * _e715));
                                            let _e795 = (bitcast<i32>((_e671 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e798 = bitcast<f32>((_e790 & bitcast<u32>(_e795)));
                                            let _e799 = bitcast<u32>((f32(bitcast<i32>((_e686 & 2097151u))) * _e717));
                                            let _e804 = (bitcast<i32>((_e686 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e807 = bitcast<f32>((_e799 & bitcast<u32>(_e804)));
                                            let _e811 = bitcast<f32>((_e781 & bitcast<u32>(~(_e786))));
                                            let _e815 = bitcast<f32>((_e790 & bitcast<u32>(~(_e795))));
                                            let _e819 = bitcast<f32>((_e799 & bitcast<u32>(~(_e804))));
                                            let _e820 = (_e626.member.member.x + _e750);
                                            let _e821 = (_e626.member.member.y + _e759);
                                            let _e822 = (_e626.member.member.z + _e768);
                                            let _e825 = (_e626.member.member_1.x - _e789);
                                            let _e826 = (_e626.member.member_1.y - _e798);
                                            let _e827 = (_e626.member.member_1.z - _e807);
                                            let _e846 = (_e825 - _e820);
                                            let _e847 = (_e826 - _e821);
                                            let _e848 = (_e827 - _e822);
                                            let _e850 = select(_e847, _e846, (_e846 > _e847));
                                            let _e852 = select(_e848, _e850, (_e850 > _e848));
                                            if (_e852 < (1024f * _e162)) {
                                                phi_2886_ = 0u;
                                            } else {
                                                phi_2886_ = select(2u, 1u, (_e852 < (2097152f * _e162)));
                                            }
                                            let _e859 = phi_2886_;
                                            switch bitcast<i32>(_e859) {
                                                case 0: {
                                                    phi_2892_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_2892_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_2892_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_2892_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e862 = phi_2892_;
                                            let _e868 = global_9.member[_e626.member_1][0u];
                                            let _e872 = global_9.member[_e626.member_1][2u];
                                            let _e876 = global_9.member[_e626.member_1][4u];
                                            let _e880 = global_9.member[_e626.member_1][6u];
                                            let _e892 = (((_e872 >> bitcast<u32>(22i)) | ((_e876 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e880 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e893 = (_e868 & 268435455u);
                                            let _e894 = (_e892 & 268435455u);
                                            let _e897 = ((_e868 >> bitcast<u32>(28u)) & 7u);
                                            let _e905 = ((_e868 >> bitcast<u32>(31i)) | (((_e892 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e906 = (_e897 != 0u);
                                            if (_e897 == 0u) {
                                                phi_3147_ = _e893;
                                            } else {
                                                if (_e897 == 7u) {
                                                    phi_3146_ = 2147483648u;
                                                } else {
                                                    phi_3146_ = ((2147483648u | (_e897 << bitcast<u32>(28u))) | (_e894 & 268435455u));
                                                }
                                                let _e915 = phi_3146_;
                                                phi_3147_ = _e915;
                                            }
                                            let _e917 = phi_3147_;
                                            if _e906 {
                                                let _e918 = (_e897 != 7u);
                                                if _e918 {
                                                    phi_3157_ = (_e894 + (_e897 * ((3u * _e862) + 1u)));
                                                } else {
                                                    phi_3157_ = u32();
                                                }
                                                let _e922 = phi_3157_;
                                                phi_3159_ = _e922;
                                                phi_3160_ = select(true, false, _e918);
                                            } else {
                                                phi_3159_ = u32();
                                                phi_3160_ = true;
                                            }
                                            let _e925 = phi_3159_;
                                            let _e927 = phi_3160_;
                                            if (_e905 == 0u) {
                                                phi_3181_ = (_e893 + select(0u, 1u, !(_e906)));
                                            } else {
                                                if (_e905 == 7u) {
                                                    phi_3180_ = 2147483648u;
                                                } else {
                                                    phi_3180_ = ((2147483648u | (_e905 << bitcast<u32>(28u))) | (select(_e925, _e894, _e927) & 268435455u));
                                                }
                                                let _e940 = phi_3180_;
                                                phi_3181_ = _e940;
                                            }
                                            let _e942 = phi_3181_;
                                            phi_3185_ = type_61(array<vec4<f32>, 3>(vec4<f32>(_e820, (_e626.member.member.x + _e772), _e825, (_e626.member.member_1.x - _e811)), vec4<f32>(_e821, (_e626.member.member.y + _e776), _e826, (_e626.member.member_1.y - _e815)), vec4<f32>(_e822, (_e626.member.member.z + _e780), _e827, (_e626.member.member_1.z - _e819))), type_60(type_33((_e626.member.member + vec4<f32>(_e750, _e759, _e768, 0f)), (_e626.member.member_1 - vec4<f32>(_e789, _e798, _e807, 0f))), _e917), type_60(type_33((_e626.member.member + vec4<f32>(_e772, _e776, _e780, 0f)), (_e626.member.member_1 - vec4<f32>(_e811, _e815, _e819, 0f))), _e942));
                                        }
                                        let _e947 = phi_3185_;
                                        let _e959 = ((_e947.member[0].x - _e420) * _e425);
                                        let _e960 = ((_e947.member[0].y - _e420) * _e425);
                                        let _e961 = ((_e947.member[0].z - _e421) * _e425);
                                        let _e962 = ((_e947.member[0].w - _e421) * _e425);
                                        let _e972 = ((_e947.member[1].x - _e456) * _e461);
                                        let _e973 = ((_e947.member[1].y - _e456) * _e461);
                                        let _e974 = ((_e947.member[1].z - _e457) * _e461);
                                        let _e975 = ((_e947.member[1].w - _e457) * _e461);
                                        let _e985 = ((_e947.member[2].x - _e492) * _e497);
                                        let _e986 = ((_e947.member[2].y - _e492) * _e497);
                                        let _e987 = ((_e947.member[2].z - _e493) * _e497);
                                        let _e988 = ((_e947.member[2].w - _e493) * _e497);
                                        let _e990 = select(_e987, _e985, (_e985 < _e987));
                                        let _e992 = select(_e988, _e986, (_e986 < _e988));
                                        let _e994 = select(_e987, _e985, (_e985 > _e987));
                                        let _e996 = select(_e988, _e986, (_e986 > _e988));
                                        let _e998 = select(_e961, _e959, (_e959 < _e961));
                                        let _e1000 = select(_e962, _e960, (_e960 < _e962));
                                        let _e1002 = select(_e974, _e972, (_e972 < _e974));
                                        let _e1004 = select(_e975, _e973, (_e973 < _e975));
                                        let _e1006 = select(_e1002, _e998, (_e998 > _e1002));
                                        let _e1008 = select(_e1004, _e1000, (_e1000 > _e1004));
                                        let _e1010 = select(_e990, _e1006, (_e1006 > _e990));
                                        let _e1012 = select(_e992, _e1008, (_e1008 > _e992));
                                        let _e1014 = select(_e961, _e959, (_e959 > _e961));
                                        let _e1016 = select(_e962, _e960, (_e960 > _e962));
                                        let _e1018 = select(_e974, _e972, (_e972 > _e974));
                                        let _e1020 = select(_e975, _e973, (_e973 > _e975));
                                        let _e1022 = select(_e1018, _e1014, (_e1014 < _e1018));
                                        let _e1024 = select(_e1020, _e1016, (_e1016 < _e1020));
                                        let _e1029 = -(_e990);
                                        let _e1030 = -(_e992);
                                        let _e1037 = (select(_e994, _e1022, (_e1022 < _e994)) + (select(_e1029, _e994, (_e994 > _e1029)) * 0.0000019073523f));
                                        let _e1038 = (select(_e996, _e1024, (_e1024 < _e996)) + (select(_e1030, _e996, (_e996 > _e1030)) * 0.0000019073523f));
                                        let _e1040 = select(_e543, _e1010, (_e1010 > _e543));
                                        let _e1042 = select(_e543, _e1012, (_e1012 > _e543));
                                        let _e1047 = (_e1040 <= select(_e587.member_1, _e1037, (_e1037 < _e587.member_1)));
                                        let _e1048 = (_e1042 <= select(_e587.member_1, _e1038, (_e1038 < _e587.member_1)));
                                        let _e1049 = (_e1040 <= _e1042);
                                        if _e1047 {
                                            if _e1048 {
                                                if _e1049 {
                                                    phi_3529_ = _e947.member_2;
                                                } else {
                                                    phi_3529_ = _e947.member_1;
                                                }
                                                let _e1053 = phi_3529_;
                                                let _e1075 = (_e630 % 128u);
                                                let _e1076 = (_e1075 < 128u);
                                                if _e1076 {
                                                } else {
                                                    phi_4135_ = true;
                                                    break;
                                                }
                                                local_8[_e1075] = _e1053.member_1;
                                                if _e1076 {
                                                } else {
                                                    phi_4135_ = true;
                                                    break;
                                                }
                                                local_7[_e1075] = _e1053.member.member.x;
                                                if _e1076 {
                                                } else {
                                                    phi_4135_ = true;
                                                    break;
                                                }
                                                local_6[_e1075] = _e1053.member.member.y;
                                                if _e1076 {
                                                } else {
                                                    phi_4135_ = true;
                                                    break;
                                                }
                                                local_5[_e1075] = _e1053.member.member.z;
                                                if _e1076 {
                                                } else {
                                                    phi_4135_ = true;
                                                    break;
                                                }
                                                local_4[_e1075] = _e1053.member.member_1.x;
                                                if _e1076 {
                                                } else {
                                                    phi_4135_ = true;
                                                    break;
                                                }
                                                local_3[_e1075] = _e1053.member.member_1.y;
                                                if _e1076 {
                                                } else {
                                                    phi_4135_ = true;
                                                    break;
                                                }
                                                local_2[_e1075] = _e1053.member.member_1.z;
                                                if _e1076 {
                                                } else {
                                                    phi_4135_ = true;
                                                    break;
                                                }
                                                local_9[_e1075] = select(_e1042, _e1040, (_e1040 > _e1042));
                                                if _e1049 {
                                                    phi_3606_ = _e947.member_1;
                                                } else {
                                                    phi_3606_ = _e947.member_2;
                                                }
                                                let _e1089 = phi_3606_;
                                                phi_3607_ = _e1089;
                                                phi_3608_ = (_e630 + 1u);
                                            } else {
                                                phi_3607_ = type_60();
                                                phi_3608_ = u32();
                                            }
                                            let _e1091 = phi_3607_;
                                            let _e1093 = phi_3608_;
                                            phi_3610_ = _e1091;
                                            phi_3611_ = _e1093;
                                            phi_3612_ = select(true, false, _e1048);
                                        } else {
                                            phi_3610_ = type_60();
                                            phi_3611_ = u32();
                                            phi_3612_ = true;
                                        }
                                        let _e1096 = phi_3610_;
                                        let _e1098 = phi_3611_;
                                        let _e1100 = phi_3612_;
                                        if _e1100 {
                                            if _e1047 {
                                                phi_3621_ = _e947.member_1;
                                            } else {
                                                phi_3621_ = _e947.member_2;
                                            }
                                            let _e1104 = phi_3621_;
                                            phi_3626_ = _e1104;
                                            phi_3627_ = select(_e1048, true, _e1047);
                                        } else {
                                            phi_3626_ = _e1096;
                                            phi_3627_ = _e628;
                                        }
                                        let _e1107 = phi_3626_;
                                        let _e1109 = phi_3627_;
                                        phi_4139_ = _e585;
                                        phi_3629_ = _e587;
                                        phi_3630_ = _e1107;
                                        phi_3631_ = _e1109;
                                        phi_3632_ = select(_e1098, _e630, _e1100);
                                    }
                                    let _e1853 = phi_4139_;
                                    let _e1855 = phi_3629_;
                                    let _e1857 = phi_3630_;
                                    let _e1859 = phi_3631_;
                                    let _e1861 = phi_3632_;
                                    phi_4138_ = _e1853;
                                    phi_3633_ = _e1855;
                                    phi_3634_ = _e1857;
                                    phi_3635_ = (_e591 - 1u);
                                    phi_3636_ = _e1859;
                                    phi_3637_ = _e1861;
                                } else {
                                    phi_4138_ = _e585;
                                    phi_3633_ = _e587;
                                    phi_3634_ = _e626;
                                    phi_3635_ = _e591;
                                    phi_3636_ = _e628;
                                    phi_3637_ = _e630;
                                }
                                let _e1863 = phi_4138_;
                                let _e1865 = phi_3633_;
                                let _e1867 = phi_3634_;
                                let _e1869 = phi_3635_;
                                let _e1871 = phi_3636_;
                                let _e1873 = phi_3637_;
                                phi_4137_ = _e1863;
                                phi_3638_ = _e1865;
                                phi_3639_ = _e1867;
                                phi_3640_ = _e1869;
                                phi_3641_ = _e1871;
                                phi_3642_ = _e1873;
                            } else {
                                phi_4137_ = _e585;
                                phi_3638_ = type_39();
                                phi_3639_ = type_60();
                                phi_3640_ = u32();
                                phi_3641_ = bool();
                                phi_3642_ = u32();
                            }
                            let _e1875 = phi_4137_;
                            let _e1877 = phi_3638_;
                            let _e1879 = phi_3639_;
                            let _e1881 = phi_3640_;
                            let _e1883 = phi_3641_;
                            let _e1885 = phi_3642_;
                            phi_4136_ = _e1875;
                            phi_974_ = _e1877;
                            phi_977_ = _e1879;
                            phi_979_ = _e1881;
                            phi_981_ = _e1883;
                            phi_983_ = _e1885;
                            phi_3643_ = _e599;
                        } else {
                            phi_4136_ = _e585;
                            phi_974_ = type_39();
                            phi_977_ = type_60();
                            phi_979_ = u32();
                            phi_981_ = bool();
                            phi_983_ = u32();
                            phi_3643_ = false;
                        }
                        let _e1887 = phi_4136_;
                        let _e1889 = phi_974_;
                        let _e1891 = phi_977_;
                        let _e1893 = phi_979_;
                        let _e1895 = phi_981_;
                        let _e1897 = phi_983_;
                        let _e1899 = phi_3643_;
                        continue;
                        continuing {
                            phi_3997_ = _e1887;
                            phi_973_ = _e1889;
                            phi_976_ = _e1891;
                            phi_978_ = _e1893;
                            phi_980_ = _e1895;
                            phi_982_ = _e1897;
                            phi_4135_ = _e1887;
                            break if !(_e1899);
                        }
                    }
                    let _e1902 = phi_4135_;
                    if _e1902 {
                        break;
                    }
                    let _e1904 = local_13;
                    if (_e1904.member.member_3 != 4294967295u) {
                        let _e1909 = (_e367 / 3i);
                        let _e1916 = bitcast<f32>((bitcast<u32>((_e1909 + 127i)) << bitcast<u32>(23i)));
                        let _e1924 = (((_e1904.member.member * _e1916) * _e1916) * bitcast<f32>((bitcast<u32>(((_e367 - (2i * _e1909)) + 127i)) << bitcast<u32>(23i))));
                        let _e1926 = select(340282350000000000000000000000000000000f, _e1924, (_e1924 < 340282350000000000000000000000000000000f));
                        phi_3695_ = type_21(select(-340282350000000000000000000000000000000f, _e1926, (_e1926 > -340282350000000000000000000000000000000f)), _e1904.member.member_1, _e1904.member.member_2, _e1904.member.member_3);
                    } else {
                        phi_3695_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1933 = phi_3695_;
                    if _e244 {
                    } else {
                        break;
                    }
                    global_7.member[_e150] = _e1933;
                    if _e165 {
                    } else {
                        break;
                    }
                    let _e1937 = select(0u, 1u, (_e311 <= _e321));
                    if (_e1937 > 0u) {
                        let _e1939 = (1u < _e118);
                        if _e1939 {
                            if (0u < _e118) {
                            } else {
                                break;
                            }
                            let _e1943 = atomicAdd((&global_8.member[0u]), _e1937);
                            if ((_e1943 + _e1937) < _e1943) {
                                if _e1939 {
                                } else {
                                    break;
                                }
                                let _e1948 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1951 = select(0u, 1u, (_e1933.member_3 != 4294967295u));
                    if (_e1951 > 0u) {
                        let _e1953 = (3u < _e118);
                        if _e1953 {
                            if (2u < _e118) {
                            } else {
                                break;
                            }
                            let _e1957 = atomicAdd((&global_8.member[2u]), _e1951);
                            if ((_e1957 + _e1951) < _e1957) {
                                if _e1953 {
                                } else {
                                    break;
                                }
                                let _e1962 = atomicAdd((&global_8.member[3u]), 1u);
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
fn trace_paths_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
