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

struct type_55 {
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
var<storage> global_9: type_55;
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
    var phi_341_: u32;
    var phi_385_: i32;
    var phi_409_: type_36;
    var phi_515_: i32;
    var phi_516_: i32;
    var phi_526_: bool;
    var phi_536_: u32;
    var phi_537_: u32;
    var phi_539_: bool;
    var phi_544_: u32;
    var phi_577_: i32;
    var phi_595_: f32;
    var phi_601_: f32;
    var phi_612_: f32;
    var phi_618_: f32;
    var phi_641_: f32;
    var phi_652_: f32;
    var phi_661_: f32;
    var phi_667_: f32;
    var phi_678_: f32;
    var phi_684_: f32;
    var phi_707_: f32;
    var phi_718_: f32;
    var phi_727_: f32;
    var phi_733_: f32;
    var phi_744_: f32;
    var phi_750_: f32;
    var phi_773_: f32;
    var phi_784_: f32;
    var phi_884_: f32;
    var phi_885_: f32;
    var phi_4140_: bool;
    var phi_974_: type_39;
    var phi_977_: type_60;
    var phi_979_: u32;
    var phi_981_: bool;
    var phi_983_: u32;
    var phi_994_: bool;
    var phi_1080_: type_60;
    var phi_1081_: bool;
    var phi_1082_: u32;
    var phi_3029_: u32;
    var phi_3035_: u32;
    var phi_3289_: u32;
    var phi_3290_: u32;
    var phi_3300_: u32;
    var phi_3302_: u32;
    var phi_3303_: bool;
    var phi_3323_: u32;
    var phi_3324_: u32;
    var phi_3328_: type_61;
    var phi_3672_: type_60;
    var phi_3749_: type_60;
    var phi_3750_: type_60;
    var phi_3751_: u32;
    var phi_3753_: type_60;
    var phi_3754_: u32;
    var phi_3755_: bool;
    var phi_3764_: type_60;
    var phi_3769_: type_60;
    var phi_3770_: bool;
    var phi_4137_: bool;
    var phi_1101_: type_39;
    var phi_1104_: type_8;
    var phi_1105_: type_8;
    var phi_1127_: type_8;
    var phi_1168_: u32;
    var phi_1174_: u32;
    var phi_1184_: u32;
    var phi_1200_: u32;
    var phi_1237_: u32;
    var phi_1243_: u32;
    var phi_1253_: u32;
    var phi_4122_: bool;
    var phi_1269_: type_8;
    var phi_1270_: type_8;
    var phi_1293_: type_8;
    var phi_1316_: u32;
    var phi_1331_: u32;
    var phi_1334_: type_8;
    var phi_1335_: type_8;
    var phi_1358_: type_8;
    var phi_1424_: u32;
    var phi_1404_: u32;
    var phi_1405_: u32;
    var phi_1428_: f32;
    var phi_4115_: bool;
    var phi_4198_: bool;
    var phi_4197_: bool;
    var phi_1928_: vec3<f32>;
    var phi_1929_: vec3<f32>;
    var phi_1960_: bool;
    var phi_1969_: vec3<f32>;
    var phi_2009_: type_21;
    var phi_2011_: type_21;
    var phi_2012_: bool;
    var phi_2016_: type_21;
    var phi_2017_: type_21;
    var phi_2018_: type_21;
    var phi_2019_: bool;
    var phi_2023_: type_21;
    var phi_2024_: bool;
    var phi_2028_: type_21;
    var phi_2029_: bool;
    var phi_2033_: type_21;
    var phi_2056_: u32;
    var phi_2070_: i32;
    var phi_2090_: vec3<f32>;
    var phi_2091_: vec3<f32>;
    var phi_2107_: vec3<f32>;
    var phi_2108_: vec3<f32>;
    var phi_2124_: vec3<f32>;
    var phi_2125_: vec3<f32>;
    var phi_2161_: vec3<f32>;
    var phi_2343_: f32;
    var phi_2361_: bool;
    var phi_2362_: bool;
    var phi_2381_: bool;
    var phi_2382_: bool;
    var phi_2388_: type_39;
    var phi_2389_: type_39;
    var phi_2390_: type_39;
    var phi_4200_: bool;
    var phi_1102_: type_39;
    var phi_4199_: bool;
    var phi_4282_: bool;
    var phi_3772_: type_39;
    var phi_3773_: type_60;
    var phi_3774_: bool;
    var phi_3775_: u32;
    var phi_4281_: bool;
    var phi_3776_: type_39;
    var phi_3777_: type_60;
    var phi_3778_: u32;
    var phi_3779_: bool;
    var phi_3780_: u32;
    var phi_4280_: bool;
    var phi_3781_: type_39;
    var phi_3782_: type_60;
    var phi_3783_: u32;
    var phi_3784_: bool;
    var phi_3785_: u32;
    var phi_4279_: bool;
    var phi_975_: type_39;
    var phi_978_: type_60;
    var phi_980_: u32;
    var phi_982_: bool;
    var phi_984_: u32;
    var phi_3786_: bool;
    var phi_4278_: bool;
    var local_13: type_39;
    var phi_3838_: type_21;
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
                phi_341_ = _e169;
            } else {
                phi_341_ = 4294967295u;
            }
            let _e171 = phi_341_;
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
                phi_385_ = -126i;
            } else {
                phi_385_ = select(_e214, 127i, (_e214 > 127i));
            }
            let _e219 = phi_385_;
            let _e224 = bitcast<f32>((bitcast<u32>((_e219 + 127i)) << bitcast<u32>(23i)));
            let _e230 = bitcast<f32>((bitcast<u32>(((_e214 - _e219) + 127i)) << bitcast<u32>(23i)));
            if (_e190 == 0u) {
                phi_409_ = type_36(array<f32, 3>(_e207, _e208, _e209), _e190, _e211, _e212);
            } else {
                phi_409_ = type_36(array<f32, 3>(((_e207 * _e224) * _e230), ((_e208 * _e224) * _e230), ((_e209 * _e224) * _e230)), _e190, ((_e211 * _e224) * _e230), _e212);
            }
            let _e243 = phi_409_;
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
                            phi_515_ = (bitcast<i32>((_e330 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_515_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e330)), 32u, (_e330 == 0u))));
                        }
                        let _e344 = phi_515_;
                        phi_516_ = _e344;
                    } else {
                        phi_516_ = 0i;
                    }
                    let _e346 = phi_516_;
                    let _e347 = (_e256 == _e300);
                    if _e347 {
                        phi_526_ = true;
                    } else {
                        phi_526_ = (_e264 == _e300);
                    }
                    let _e350 = phi_526_;
                    let _e351 = select(1u, 0u, _e347);
                    if _e350 {
                        let _e352 = (_e351 + 1u);
                        phi_536_ = _e352;
                        phi_537_ = _e352;
                        phi_539_ = select(true, false, (_e352 == 2u));
                    } else {
                        phi_536_ = u32();
                        phi_537_ = 0u;
                        phi_539_ = true;
                    }
                    let _e356 = phi_536_;
                    let _e358 = phi_537_;
                    let _e360 = phi_539_;
                    if _e360 {
                        phi_544_ = (_e358 + 1u);
                    } else {
                        phi_544_ = 0u;
                    }
                    let _e364 = phi_544_;
                    let _e365 = select(_e356, _e358, _e360);
                    let _e366 = select(_e351, select(2u, _e351, _e350), _e360);
                    let _e367 = -(_e346);
                    if (_e367 < -126i) {
                        phi_577_ = -126i;
                    } else {
                        phi_577_ = select(_e367, 127i, (_e367 > 127i));
                    }
                    let _e372 = phi_577_;
                    let _e377 = bitcast<f32>((bitcast<u32>((_e372 + 127i)) << bitcast<u32>(23i)));
                    let _e383 = bitcast<f32>((bitcast<u32>(((_e367 - _e372) + 127i)) << bitcast<u32>(23i)));
                    let _e388 = global_6.member[_e150].member.member;
                    let _e389 = (_e365 == 0u);
                    if _e389 {
                        phi_595_ = _e388[0];
                    } else {
                        phi_595_ = _e388[1];
                    }
                    let _e393 = phi_595_;
                    let _e394 = (_e365 == 2u);
                    if _e394 {
                        phi_601_ = _e388[2];
                    } else {
                        phi_601_ = _e393;
                    }
                    let _e397 = phi_601_;
                    let _e398 = global_6.member[_e150].member.member_2;
                    if _e389 {
                        phi_612_ = _e398[0];
                    } else {
                        phi_612_ = _e398[1];
                    }
                    let _e402 = phi_612_;
                    if _e394 {
                        phi_618_ = _e398[2];
                    } else {
                        phi_618_ = _e402;
                    }
                    let _e405 = phi_618_;
                    let _e407 = ((_e405 * _e377) * _e383);
                    let _e411 = (bitcast<f32>((bitcast<u32>(_e407) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e411 {
                        let _e415 = (bitcast<f32>((bitcast<u32>(_e397) & 2147483647u)) * 0.00000011920929f);
                        phi_641_ = select(0.00000000000011368684f, _e415, (_e415 > 0.00000000000011368684f));
                    } else {
                        phi_641_ = 0f;
                    }
                    let _e419 = phi_641_;
                    let _e420 = (_e397 + _e419);
                    let _e421 = (_e397 - _e419);
                    let _e422 = select(_e407, 0f, _e411);
                    if _e411 {
                        phi_652_ = 38685626000000000000000000f;
                    } else {
                        phi_652_ = (1f / _e407);
                    }
                    let _e425 = phi_652_;
                    let _e426 = (_e364 == 0u);
                    if _e426 {
                        phi_661_ = _e388[0];
                    } else {
                        phi_661_ = _e388[1];
                    }
                    let _e430 = phi_661_;
                    let _e431 = (_e364 == 2u);
                    if _e431 {
                        phi_667_ = _e388[2];
                    } else {
                        phi_667_ = _e430;
                    }
                    let _e434 = phi_667_;
                    if _e426 {
                        phi_678_ = _e398[0];
                    } else {
                        phi_678_ = _e398[1];
                    }
                    let _e438 = phi_678_;
                    if _e431 {
                        phi_684_ = _e398[2];
                    } else {
                        phi_684_ = _e438;
                    }
                    let _e441 = phi_684_;
                    let _e443 = ((_e441 * _e377) * _e383);
                    let _e447 = (bitcast<f32>((bitcast<u32>(_e443) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e447 {
                        let _e451 = (bitcast<f32>((bitcast<u32>(_e434) & 2147483647u)) * 0.00000011920929f);
                        phi_707_ = select(0.00000000000011368684f, _e451, (_e451 > 0.00000000000011368684f));
                    } else {
                        phi_707_ = 0f;
                    }
                    let _e455 = phi_707_;
                    let _e456 = (_e434 + _e455);
                    let _e457 = (_e434 - _e455);
                    let _e458 = select(_e443, 0f, _e447);
                    if _e447 {
                        phi_718_ = 38685626000000000000000000f;
                    } else {
                        phi_718_ = (1f / _e443);
                    }
                    let _e461 = phi_718_;
                    let _e462 = (_e366 == 0u);
                    if _e462 {
                        phi_727_ = _e388[0];
                    } else {
                        phi_727_ = _e388[1];
                    }
                    let _e466 = phi_727_;
                    let _e467 = (_e366 == 2u);
                    if _e467 {
                        phi_733_ = _e388[2];
                    } else {
                        phi_733_ = _e466;
                    }
                    let _e470 = phi_733_;
                    if _e462 {
                        phi_744_ = _e398[0];
                    } else {
                        phi_744_ = _e398[1];
                    }
                    let _e474 = phi_744_;
                    if _e467 {
                        phi_750_ = _e398[2];
                    } else {
                        phi_750_ = _e474;
                    }
                    let _e477 = phi_750_;
                    let _e479 = ((_e477 * _e377) * _e383);
                    let _e483 = (bitcast<f32>((bitcast<u32>(_e479) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e483 {
                        let _e487 = (bitcast<f32>((bitcast<u32>(_e470) & 2147483647u)) * 0.00000011920929f);
                        phi_773_ = select(0.00000000000011368684f, _e487, (_e487 > 0.00000000000011368684f));
                    } else {
                        phi_773_ = 0f;
                    }
                    let _e491 = phi_773_;
                    let _e492 = (_e470 + _e491);
                    let _e493 = (_e470 - _e491);
                    let _e494 = select(_e479, 0f, _e483);
                    if _e483 {
                        phi_784_ = 38685626000000000000000000f;
                    } else {
                        phi_784_ = (1f / _e479);
                    }
                    let _e497 = phi_784_;
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
                        phi_884_ = select(-340282350000000000000000000000000000000f, _e537, (_e537 > -340282350000000000000000000000000000000f));
                        phi_885_ = select(-340282350000000000000000000000000000000f, _e530, (_e530 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_884_ = 0f;
                        phi_885_ = 1f;
                    }
                    let _e541 = phi_884_;
                    let _e543 = phi_885_;
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
                    phi_4140_ = false;
                    phi_974_ = type_39(type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e541);
                    phi_977_ = type_60(type_33(vec4<f32>((f32(_e550) * _e162), (f32(_e556) * _e162), (f32(_e562) * _e162), 0f), vec4<f32>((f32(_e567) * _e162), (f32(_e571) * _e162), (f32(_e575) * _e162), 0f)), select(0u, 2147483648u, (_e103 == 0u)));
                    phi_979_ = ((3u * _e103) + 1u);
                    phi_981_ = (_e543 <= _e541);
                    phi_983_ = 0u;
                    loop {
                        let _e585 = phi_4140_;
                        let _e587 = phi_974_;
                        let _e589 = phi_977_;
                        let _e591 = phi_979_;
                        let _e593 = phi_981_;
                        let _e595 = phi_983_;
                        local_13 = _e587;
                        if _e593 {
                            phi_994_ = true;
                        } else {
                            phi_994_ = (_e595 > 0u);
                        }
                        let _e598 = phi_994_;
                        if _e598 {
                            let _e599 = (_e591 > 0u);
                            if _e599 {
                                if _e593 {
                                    phi_1080_ = _e589;
                                    phi_1081_ = _e593;
                                    phi_1082_ = _e595;
                                } else {
                                    let _e600 = (_e595 - 1u);
                                    let _e601 = (_e600 % 128u);
                                    let _e602 = (_e601 < 128u);
                                    if _e602 {
                                    } else {
                                        phi_4278_ = true;
                                        break;
                                    }
                                    let _e604 = local_7[_e601];
                                    if _e602 {
                                    } else {
                                        phi_4278_ = true;
                                        break;
                                    }
                                    let _e606 = local_6[_e601];
                                    if _e602 {
                                    } else {
                                        phi_4278_ = true;
                                        break;
                                    }
                                    let _e608 = local_5[_e601];
                                    if _e602 {
                                    } else {
                                        phi_4278_ = true;
                                        break;
                                    }
                                    let _e610 = local_4[_e601];
                                    if _e602 {
                                    } else {
                                        phi_4278_ = true;
                                        break;
                                    }
                                    let _e612 = local_3[_e601];
                                    if _e602 {
                                    } else {
                                        phi_4278_ = true;
                                        break;
                                    }
                                    let _e614 = local_2[_e601];
                                    if _e602 {
                                    } else {
                                        phi_4278_ = true;
                                        break;
                                    }
                                    let _e619 = local_8[_e601];
                                    if _e602 {
                                    } else {
                                        phi_4278_ = true;
                                        break;
                                    }
                                    let _e622 = local_9[_e601];
                                    phi_1080_ = type_60(type_33(vec4<f32>(_e604, _e606, _e608, 0f), vec4<f32>(_e610, _e612, _e614, 0f)), _e619);
                                    phi_1081_ = (_e622 <= _e587.member_1);
                                    phi_1082_ = _e600;
                                }
                                let _e626 = phi_1080_;
                                let _e628 = phi_1081_;
                                let _e630 = phi_1082_;
                                if _e628 {
                                    let _e635 = (_e626.member_1 & 268435455u);
                                    if ((_e626.member_1 & 2147483648u) != 0u) {
                                        phi_4137_ = _e585;
                                        phi_1101_ = _e587;
                                        phi_1104_ = type_8(0u, ((_e626.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1116 = phi_4137_;
                                            let _e1118 = phi_1101_;
                                            let _e1120 = phi_1104_;
                                            local_14 = _e1118;
                                            if (_e1120.member < _e1120.member_1) {
                                                phi_1105_ = type_8((_e1120.member + 1u), _e1120.member_1);
                                                phi_1127_ = type_8(1u, _e1120.member);
                                            } else {
                                                phi_1105_ = _e1120;
                                                phi_1127_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1133 = phi_1105_;
                                            let _e1135 = phi_1127_;
                                            let _e1139 = (bitcast<i32>(_e1135.member) != 0i);
                                            if _e1139 {
                                                let _e1144 = (_e626.member.member_1.x - _e626.member.member.x);
                                                let _e1147 = (_e626.member.member_1.y - _e626.member.member.y);
                                                let _e1150 = (_e626.member.member_1.z - _e626.member.member.z);
                                                let _e1152 = select(_e1147, _e1144, (_e1144 > _e1147));
                                                let _e1154 = select(_e1150, _e1152, (_e1152 > _e1150));
                                                let _e1156 = (_e1154 < (1024f * _e162));
                                                if _e1156 {
                                                    phi_1168_ = 0u;
                                                } else {
                                                    phi_1168_ = select(2u, 1u, (_e1154 < (2097152f * _e162)));
                                                }
                                                let _e1161 = phi_1168_;
                                                switch bitcast<i32>(_e1161) {
                                                    case 0: {
                                                        phi_1174_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1174_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1174_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1174_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1164 = phi_1174_;
                                                switch bitcast<i32>(_e1161) {
                                                    case 0: {
                                                        phi_1184_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1184_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1184_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1184_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1171 = phi_1184_;
                                                let _e1173 = ((_e635 + (_e1135.member_1 * ((3u * _e1164) + 1u))) + (3u * _e1171));
                                                let _e1174 = (_e1173 < _e106);
                                                if _e1174 {
                                                    if _e1174 {
                                                    } else {
                                                        phi_4199_ = true;
                                                        break;
                                                    }
                                                    let _e1176 = global_10.member[_e1173];
                                                    phi_1200_ = _e1176;
                                                } else {
                                                    phi_1200_ = 4294967295u;
                                                }
                                                let _e1178 = phi_1200_;
                                                local_10 = array<u32, 3>(_e365, _e364, _e366);
                                                if _e1156 {
                                                    phi_1237_ = 0u;
                                                } else {
                                                    phi_1237_ = select(2u, 1u, (_e1154 < (2097152f * _e162)));
                                                }
                                                let _e1184 = phi_1237_;
                                                switch bitcast<i32>(_e1184) {
                                                    case 0: {
                                                        phi_1243_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1243_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1243_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1243_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1187 = phi_1243_;
                                                switch bitcast<i32>(_e1184) {
                                                    case 0: {
                                                        phi_1253_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1253_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1253_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1253_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1194 = phi_1253_;
                                                local_12 = array<f32, 4>(_e626.member.member.x, _e626.member.member.y, _e626.member.member.z, _e626.member.member.w);
                                                local_11[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_11[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_11[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_4122_ = _e1116;
                                                phi_1269_ = type_8(0u, 3u);
                                                loop {
                                                    let _e1208 = phi_4122_;
                                                    let _e1210 = phi_1269_;
                                                    if (_e1210.member < _e1210.member_1) {
                                                        phi_1270_ = type_8((_e1210.member + 1u), _e1210.member_1);
                                                        phi_1293_ = type_8(1u, _e1210.member);
                                                    } else {
                                                        phi_1270_ = _e1210;
                                                        phi_1293_ = type_8(0u, type_8().member_1);
                                                    }
                                                    let _e1223 = phi_1270_;
                                                    let _e1225 = phi_1293_;
                                                    let _e1229 = (bitcast<i32>(_e1225.member) != 0i);
                                                    if _e1229 {
                                                        let _e1231 = ((_e635 + (_e1135.member_1 * ((3u * _e1187) + 1u))) + (_e1225.member_1 * _e1194));
                                                        let _e1232 = (_e1231 < _e106);
                                                        if _e1232 {
                                                            if _e1232 {
                                                            } else {
                                                                phi_4197_ = true;
                                                                break;
                                                            }
                                                            let _e1234 = global_10.member[_e1231];
                                                            phi_1316_ = _e1234;
                                                        } else {
                                                            phi_1316_ = 0u;
                                                        }
                                                        let _e1236 = phi_1316_;
                                                        let _e1237 = (_e1231 + 1u);
                                                        let _e1238 = (_e1237 < _e106);
                                                        if _e1238 {
                                                            if _e1238 {
                                                            } else {
                                                                phi_4197_ = true;
                                                                break;
                                                            }
                                                            let _e1240 = global_10.member[_e1237];
                                                            phi_1331_ = _e1240;
                                                        } else {
                                                            phi_1331_ = 0u;
                                                        }
                                                        let _e1242 = phi_1331_;
                                                        phi_1334_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e1244 = phi_1334_;
                                                            if (_e1244.member < _e1244.member_1) {
                                                                phi_1335_ = type_8((_e1244.member + 1u), _e1244.member_1);
                                                                phi_1358_ = type_8(1u, _e1244.member);
                                                            } else {
                                                                phi_1335_ = _e1244;
                                                                phi_1358_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1257 = phi_1335_;
                                                            let _e1259 = phi_1358_;
                                                            let _e1263 = (bitcast<i32>(_e1259.member) != 0i);
                                                            if _e1263 {
                                                                let _e1264 = (_e1259.member_1 < 3u);
                                                                if _e1264 {
                                                                } else {
                                                                    phi_4115_ = true;
                                                                    break;
                                                                }
                                                                let _e1266 = local_10[_e1259.member_1];
                                                                if (_e1259.member_1 < 4u) {
                                                                } else {
                                                                    phi_4115_ = true;
                                                                    break;
                                                                }
                                                                let _e1269 = local_12[_e1259.member_1];
                                                                switch bitcast<i32>(_e1184) {
                                                                    case 0: {
                                                                        phi_1428_ = (_e1269 + (f32(((_e1236 >> bitcast<u32>(((10u * _e1266) & 31u))) & 1023u)) * _e162));
                                                                        break;
                                                                    }
                                                                    case 1: {
                                                                        if (_e1266 == 0u) {
                                                                            phi_1405_ = _e1236;
                                                                        } else {
                                                                            if (_e1266 == 1u) {
                                                                                phi_1404_ = ((_e1236 >> bitcast<u32>(21i)) | (_e1242 << bitcast<u32>(11i)));
                                                                            } else {
                                                                                phi_1404_ = (_e1242 >> bitcast<u32>(10i));
                                                                            }
                                                                            let _e1290 = phi_1404_;
                                                                            phi_1405_ = _e1290;
                                                                        }
                                                                        let _e1292 = phi_1405_;
                                                                        phi_1428_ = (_e1269 + (f32((_e1292 & 2097151u)) * _e162));
                                                                        break;
                                                                    }
                                                                    case 2: {
                                                                        let _e1271 = (_e1231 + _e1266);
                                                                        let _e1272 = (_e1271 < _e106);
                                                                        if _e1272 {
                                                                            if _e1272 {
                                                                            } else {
                                                                                phi_4115_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1274 = global_10.member[_e1271];
                                                                            phi_1424_ = _e1274;
                                                                        } else {
                                                                            phi_1424_ = 0u;
                                                                        }
                                                                        let _e1276 = phi_1424_;
                                                                        phi_1428_ = (f32(bitcast<i32>(_e1276)) * _e162);
                                                                        break;
                                                                    }
                                                                    default: {
                                                                        phi_1428_ = f32();
                                                                        break;
                                                                    }
                                                                }
                                                                let _e1306 = phi_1428_;
                                                                if (_e1225.member_1 < 3u) {
                                                                } else {
                                                                    phi_4115_ = true;
                                                                    break;
                                                                }
                                                                if _e1264 {
                                                                } else {
                                                                    phi_4115_ = true;
                                                                    break;
                                                                }
                                                                local_11[_e1225.member_1][_e1259.member_1] = _e1306;
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_1334_ = _e1257;
                                                                phi_4115_ = _e1208;
                                                                break if !(_e1263);
                                                            }
                                                        }
                                                        let _e1312 = phi_4115_;
                                                        phi_4197_ = _e1312;
                                                        if _e1312 {
                                                            break;
                                                        }
                                                        phi_4198_ = _e1312;
                                                    } else {
                                                        phi_4198_ = _e1208;
                                                    }
                                                    let _e1314 = phi_4198_;
                                                    continue;
                                                    continuing {
                                                        phi_4122_ = _e1314;
                                                        phi_1269_ = _e1223;
                                                        phi_4197_ = _e1314;
                                                        break if !(_e1229);
                                                    }
                                                }
                                                let _e1317 = phi_4197_;
                                                phi_4199_ = _e1317;
                                                if _e1317 {
                                                    break;
                                                }
                                                let _e1318 = local_11;
                                                let _e1334 = (_e1318[0][2] - _e470);
                                                let _e1337 = (((_e1318[0][0] - _e397) * _e494) - (_e1334 * _e422));
                                                let _e1340 = (((_e1318[0][1] - _e434) * _e494) - (_e1334 * _e458));
                                                let _e1343 = (_e1318[1][2] - _e470);
                                                let _e1346 = (((_e1318[1][0] - _e397) * _e494) - (_e1343 * _e422));
                                                let _e1349 = (((_e1318[1][1] - _e434) * _e494) - (_e1343 * _e458));
                                                let _e1352 = (_e1318[2][2] - _e470);
                                                let _e1355 = (((_e1318[2][0] - _e397) * _e494) - (_e1352 * _e422));
                                                let _e1358 = (((_e1318[2][1] - _e434) * _e494) - (_e1352 * _e458));
                                                let _e1359 = (_e1355 * _e1349);
                                                let _e1360 = (_e1358 * _e1346);
                                                let _e1361 = (_e1337 * _e1358);
                                                let _e1362 = (_e1340 * _e1355);
                                                let _e1363 = (_e1346 * _e1340);
                                                let _e1364 = (_e1349 * _e1337);
                                                let _e1369 = (((_e1359 >= _e1360) && (_e1361 >= _e1362)) && (_e1363 >= _e1364));
                                                if (_e1369 || (((_e1359 <= _e1360) && (_e1361 <= _e1362)) && (_e1363 <= _e1364))) {
                                                    let _e1376 = select(-1f, 1f, _e1369);
                                                    let _e1378 = ((_e1359 - _e1360) * _e1376);
                                                    let _e1380 = select(0f, _e1378, (_e1378 > 0f));
                                                    let _e1382 = ((_e1361 - _e1362) * _e1376);
                                                    let _e1384 = select(0f, _e1382, (_e1382 > 0f));
                                                    let _e1386 = ((_e1363 - _e1364) * _e1376);
                                                    let _e1388 = select(0f, _e1386, (_e1386 > 0f));
                                                    let _e1390 = ((_e1380 + _e1384) + _e1388);
                                                    if (_e1390 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2023_ = type_21();
                                                        phi_2024_ = true;
                                                    } else {
                                                        let _e1393 = select(_e1318[1][0], _e1318[0][0], (_e1318[0][0] < _e1318[1][0]));
                                                        let _e1397 = select(_e1318[1][0], _e1318[0][0], (_e1318[0][0] > _e1318[1][0]));
                                                        let _e1401 = select(_e1318[1][1], _e1318[0][1], (_e1318[0][1] < _e1318[1][1]));
                                                        let _e1405 = select(_e1318[1][1], _e1318[0][1], (_e1318[0][1] > _e1318[1][1]));
                                                        let _e1409 = select(_e1318[1][2], _e1318[0][2], (_e1318[0][2] < _e1318[1][2]));
                                                        let _e1413 = select(_e1318[1][2], _e1318[0][2], (_e1318[0][2] > _e1318[1][2]));
                                                        let _e1418 = ((select(_e1318[2][0], _e1393, (_e1393 < _e1318[2][0])) - _e420) * _e425);
                                                        let _e1419 = ((select(_e1318[2][0], _e1397, (_e1397 > _e1318[2][0])) - _e421) * _e425);
                                                        let _e1422 = ((select(_e1318[2][1], _e1401, (_e1401 < _e1318[2][1])) - _e456) * _e461);
                                                        let _e1423 = ((select(_e1318[2][1], _e1405, (_e1405 > _e1318[2][1])) - _e457) * _e461);
                                                        let _e1426 = ((select(_e1318[2][2], _e1409, (_e1409 < _e1318[2][2])) - _e492) * _e497);
                                                        let _e1427 = ((select(_e1318[2][2], _e1413, (_e1413 > _e1318[2][2])) - _e493) * _e497);
                                                        let _e1429 = select(_e1427, _e1426, (_e1426 < _e1427));
                                                        let _e1431 = select(_e1427, _e1426, (_e1426 > _e1427));
                                                        let _e1433 = select(_e1419, _e1418, (_e1418 < _e1419));
                                                        let _e1435 = select(_e1423, _e1422, (_e1422 < _e1423));
                                                        let _e1437 = select(_e1435, _e1433, (_e1433 > _e1435));
                                                        let _e1439 = select(_e1429, _e1437, (_e1437 > _e1429));
                                                        let _e1441 = select(_e1419, _e1418, (_e1418 > _e1419));
                                                        let _e1443 = select(_e1423, _e1422, (_e1422 > _e1423));
                                                        let _e1445 = select(_e1443, _e1441, (_e1441 < _e1443));
                                                        let _e1447 = select(_e1431, _e1445, (_e1445 < _e1431));
                                                        let _e1448 = -(_e1429);
                                                        let _e1454 = select(_e543, _e1439, (_e1439 > _e543));
                                                        if (_e1454 > (_e1447 + (select(_e1448, _e1431, (_e1431 > _e1448)) * 0.0000019073523f))) {
                                                            phi_2018_ = type_21();
                                                            phi_2019_ = true;
                                                        } else {
                                                            let _e1456 = (_e1454 > _e1118.member_1);
                                                            if _e1456 {
                                                                phi_2017_ = type_21();
                                                            } else {
                                                                let _e1460 = (_e1318[1][0] - _e1318[0][0]);
                                                                let _e1461 = (_e1318[1][1] - _e1318[0][1]);
                                                                let _e1462 = (_e1318[1][2] - _e1318[0][2]);
                                                                let _e1463 = vec3<f32>(_e1460, _e1461, _e1462);
                                                                let _e1464 = (_e1318[2][0] - _e1318[1][0]);
                                                                let _e1465 = (_e1318[2][1] - _e1318[1][1]);
                                                                let _e1466 = (_e1318[2][2] - _e1318[1][2]);
                                                                let _e1467 = vec3<f32>(_e1464, _e1465, _e1466);
                                                                let _e1468 = (_e1318[0][0] - _e1318[2][0]);
                                                                let _e1469 = (_e1318[0][1] - _e1318[2][1]);
                                                                let _e1470 = (_e1318[0][2] - _e1318[2][2]);
                                                                let _e1471 = vec3<f32>(_e1468, _e1469, _e1470);
                                                                let _e1474 = bitcast<f32>((bitcast<u32>(_e1460) & 2147483647u));
                                                                let _e1477 = bitcast<f32>((bitcast<u32>(_e1461) & 2147483647u));
                                                                let _e1479 = select(_e1477, _e1474, (_e1474 > _e1477));
                                                                let _e1482 = bitcast<f32>((bitcast<u32>(_e1462) & 2147483647u));
                                                                let _e1484 = select(_e1482, _e1479, (_e1479 > _e1482));
                                                                let _e1487 = bitcast<f32>((bitcast<u32>(_e1464) & 2147483647u));
                                                                let _e1490 = bitcast<f32>((bitcast<u32>(_e1465) & 2147483647u));
                                                                let _e1492 = select(_e1490, _e1487, (_e1487 > _e1490));
                                                                let _e1495 = bitcast<f32>((bitcast<u32>(_e1466) & 2147483647u));
                                                                let _e1497 = select(_e1495, _e1492, (_e1492 > _e1495));
                                                                let _e1500 = bitcast<f32>((bitcast<u32>(_e1468) & 2147483647u));
                                                                let _e1503 = bitcast<f32>((bitcast<u32>(_e1469) & 2147483647u));
                                                                let _e1505 = select(_e1503, _e1500, (_e1500 > _e1503));
                                                                let _e1508 = bitcast<f32>((bitcast<u32>(_e1470) & 2147483647u));
                                                                let _e1510 = select(_e1508, _e1505, (_e1505 > _e1508));
                                                                let _e1512 = select(_e1497, _e1484, (_e1484 > _e1497));
                                                                let _e1514 = select(_e1510, _e1512, (_e1512 > _e1510));
                                                                if (_e1484 == _e1514) {
                                                                    phi_1928_ = _e1467;
                                                                    phi_1929_ = _e1471;
                                                                } else {
                                                                    let _e1517 = vec3((_e1497 == _e1514));
                                                                    phi_1928_ = select(_e1463, _e1471, _e1517);
                                                                    phi_1929_ = select(_e1467, _e1463, _e1517);
                                                                }
                                                                let _e1521 = phi_1928_;
                                                                let _e1523 = phi_1929_;
                                                                let _e1530 = ((_e1521.y * _e1523.z) - (_e1523.y * _e1521.z));
                                                                let _e1535 = ((_e1521.z * _e1523.x) - (_e1523.z * _e1521.x));
                                                                let _e1538 = ((_e1521.x * _e1523.y) - (_e1523.x * _e1521.y));
                                                                if (_e1380 >= _e1384) {
                                                                    phi_1960_ = select(true, false, (_e1380 >= _e1388));
                                                                } else {
                                                                    phi_1960_ = true;
                                                                }
                                                                let _e1543 = phi_1960_;
                                                                if _e1543 {
                                                                    phi_1969_ = select(vec3<f32>(_e1318[2][0], _e1318[2][1], _e1318[2][2]), vec3<f32>(_e1318[1][0], _e1318[1][1], _e1318[1][2]), vec3((_e1384 >= _e1388)));
                                                                } else {
                                                                    phi_1969_ = vec3<f32>(_e1318[0][0], _e1318[0][1], _e1318[0][2]);
                                                                }
                                                                let _e1548 = phi_1969_;
                                                                let _e1565 = ((((_e1530 * (_e1548.x - _e397)) + (_e1535 * (_e1548.y - _e434))) + (_e1538 * (_e1548.z - _e470))) / (((_e1530 * _e422) + (_e1535 * _e458)) + (_e1538 * _e494)));
                                                                let _e1567 = select(_e1447, _e1565, (_e1565 < _e1447));
                                                                let _e1569 = select(_e1439, _e1567, (_e1567 > _e1439));
                                                                if (_e1569 >= _e543) {
                                                                    let _e1571 = (_e1569 <= _e1118.member_1);
                                                                    if _e1571 {
                                                                        let _e1572 = (1f / _e1390);
                                                                        phi_2009_ = type_21(_e1569, (_e1384 * _e1572), (_e1388 * _e1572), _e1178);
                                                                    } else {
                                                                        phi_2009_ = type_21();
                                                                    }
                                                                    let _e1577 = phi_2009_;
                                                                    phi_2011_ = _e1577;
                                                                    phi_2012_ = select(true, false, _e1571);
                                                                } else {
                                                                    phi_2011_ = type_21();
                                                                    phi_2012_ = true;
                                                                }
                                                                let _e1580 = phi_2011_;
                                                                let _e1582 = phi_2012_;
                                                                if _e1582 {
                                                                    phi_2016_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2016_ = _e1580;
                                                                }
                                                                let _e1584 = phi_2016_;
                                                                phi_2017_ = _e1584;
                                                            }
                                                            let _e1586 = phi_2017_;
                                                            phi_2018_ = _e1586;
                                                            phi_2019_ = _e1456;
                                                        }
                                                        let _e1588 = phi_2018_;
                                                        let _e1590 = phi_2019_;
                                                        phi_2023_ = _e1588;
                                                        phi_2024_ = _e1590;
                                                    }
                                                    let _e1592 = phi_2023_;
                                                    let _e1594 = phi_2024_;
                                                    phi_2028_ = _e1592;
                                                    phi_2029_ = _e1594;
                                                } else {
                                                    phi_2028_ = type_21();
                                                    phi_2029_ = true;
                                                }
                                                let _e1596 = phi_2028_;
                                                let _e1598 = phi_2029_;
                                                if _e1598 {
                                                    phi_2033_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2033_ = _e1596;
                                                }
                                                let _e1600 = phi_2033_;
                                                if (_e1600.member_3 != 4294967295u) {
                                                    if (_e1178 == _e171) {
                                                        phi_2362_ = false;
                                                    } else {
                                                        let _e1604 = (_e1178 < arrayLength((&global_4.member)));
                                                        if _e1604 {
                                                            if _e1604 {
                                                            } else {
                                                                phi_4199_ = true;
                                                                break;
                                                            }
                                                            let _e1606 = global_4.member[_e1178];
                                                            phi_2056_ = _e1606;
                                                        } else {
                                                            phi_2056_ = 4294967295u;
                                                        }
                                                        let _e1608 = phi_2056_;
                                                        let _e1609 = (_e1608 < arrayLength((&global_5.member)));
                                                        if _e1609 {
                                                            if _e1609 {
                                                            } else {
                                                                phi_4199_ = true;
                                                                break;
                                                            }
                                                            let _e1611 = global_5.member[_e1608];
                                                            phi_2070_ = _e1611;
                                                        } else {
                                                            phi_2070_ = 0i;
                                                        }
                                                        let _e1613 = phi_2070_;
                                                        let _e1614 = (_e1613 == 0i);
                                                        if _e1614 {
                                                            phi_2361_ = true;
                                                        } else {
                                                            if _e389 {
                                                                phi_2091_ = vec3<f32>(_e1318[0][0], _e1318[0][1], _e1318[0][2]);
                                                            } else {
                                                                if (_e365 == 1u) {
                                                                    phi_2090_ = vec3<f32>(_e1318[0][2], _e1318[0][0], _e1318[0][1]);
                                                                } else {
                                                                    phi_2090_ = vec3<f32>(_e1318[0][1], _e1318[0][2], _e1318[0][0]);
                                                                }
                                                                let _e1619 = phi_2090_;
                                                                phi_2091_ = _e1619;
                                                            }
                                                            let _e1622 = phi_2091_;
                                                            if _e389 {
                                                                phi_2108_ = vec3<f32>(_e1318[1][0], _e1318[1][1], _e1318[1][2]);
                                                            } else {
                                                                if (_e365 == 1u) {
                                                                    phi_2107_ = vec3<f32>(_e1318[1][2], _e1318[1][0], _e1318[1][1]);
                                                                } else {
                                                                    phi_2107_ = vec3<f32>(_e1318[1][1], _e1318[1][2], _e1318[1][0]);
                                                                }
                                                                let _e1627 = phi_2107_;
                                                                phi_2108_ = _e1627;
                                                            }
                                                            let _e1630 = phi_2108_;
                                                            if _e389 {
                                                                phi_2125_ = vec3<f32>(_e1318[2][0], _e1318[2][1], _e1318[2][2]);
                                                            } else {
                                                                if (_e365 == 1u) {
                                                                    phi_2124_ = vec3<f32>(_e1318[2][2], _e1318[2][0], _e1318[2][1]);
                                                                } else {
                                                                    phi_2124_ = vec3<f32>(_e1318[2][1], _e1318[2][2], _e1318[2][0]);
                                                                }
                                                                let _e1635 = phi_2124_;
                                                                phi_2125_ = _e1635;
                                                            }
                                                            let _e1638 = phi_2125_;
                                                            let _e1641 = (_e1630.x - _e1622.x);
                                                            let _e1644 = (_e1630.y - _e1622.y);
                                                            let _e1647 = (_e1630.z - _e1622.z);
                                                            let _e1649 = (_e1638.x - _e1622.x);
                                                            let _e1651 = (_e1638.y - _e1622.y);
                                                            let _e1653 = (_e1638.z - _e1622.z);
                                                            if (_e243.member_1 == 1u) {
                                                                phi_2161_ = (vec3<f32>(_e243.member[0], _e243.member[1], _e243.member[2]) - _e1622);
                                                            } else {
                                                                phi_2161_ = vec3<f32>(_e243.member[0], _e243.member[1], _e243.member[2]);
                                                            }
                                                            let _e1668 = phi_2161_;
                                                            let _e1674 = bitcast<f32>((bitcast<u32>((_e1641 * _e1651)) ^ _e243.member_3[0]));
                                                            let _e1678 = bitcast<f32>((bitcast<u32>((_e1644 * _e1649)) ^ _e243.member_3[0]));
                                                            let _e1682 = bitcast<f32>((bitcast<u32>((_e1644 * _e1653)) ^ _e243.member_3[0]));
                                                            let _e1686 = bitcast<f32>((bitcast<u32>((_e1647 * _e1651)) ^ _e243.member_3[0]));
                                                            let _e1690 = bitcast<f32>((bitcast<u32>((_e1647 * _e1649)) ^ _e243.member_3[0]));
                                                            let _e1694 = bitcast<f32>((bitcast<u32>((_e1641 * _e1653)) ^ _e243.member_3[0]));
                                                            let _e1695 = (_e1682 - _e1686);
                                                            let _e1696 = (_e1690 - _e1694);
                                                            let _e1697 = (_e1674 - _e1678);
                                                            let _e1721 = (bitcast<f32>((bitcast<u32>(_e1682) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1686) & 2147483647u)));
                                                            let _e1728 = (bitcast<f32>((bitcast<u32>(_e1690) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1694) & 2147483647u)));
                                                            let _e1735 = (bitcast<f32>((bitcast<u32>(_e1674) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1678) & 2147483647u)));
                                                            if (_e243.member_2 == 0f) {
                                                                phi_2343_ = 0f;
                                                            } else {
                                                                let _e1765 = bitcast<f32>((bitcast<u32>(_e1695) & 2147483647u));
                                                                let _e1768 = bitcast<f32>((bitcast<u32>(_e1696) & 2147483647u));
                                                                let _e1771 = bitcast<f32>((bitcast<u32>(_e1697) & 2147483647u));
                                                                let _e1773 = select(_e1771, _e1768, (_e1768 > _e1771));
                                                                let _e1777 = select(_e1771, _e1768, (_e1768 < _e1771));
                                                                let _e1781 = select(_e1768, _e1765, (_e1765 < _e1768));
                                                                let _e1783 = select(_e1768, _e1765, (_e1765 > _e1768));
                                                                let _e1785 = select(_e1771, _e1783, (_e1783 < _e1771));
                                                                phi_2343_ = bitcast<f32>((bitcast<u32>((_e243.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1773, _e1765, (_e1765 > _e1773)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1785, _e1781, (_e1781 > _e1785)))) ^ _e243.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1777, _e1765, (_e1765 < _e1777)))) ^ _e243.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1721 + _e1728) + _e1735))) ^ _e243.member_3[0]))) * 1.0000005f)) ^ _e243.member_3[0])))) ^ _e243.member_3[0]));
                                                            }
                                                            let _e1812 = phi_2343_;
                                                            phi_2361_ = (_e1614 || !(((((bitcast<f32>((bitcast<u32>((_e1668.x * _e1695)) ^ _e243.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1668.y * _e1696)) ^ _e243.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1668.z * _e1697)) ^ _e243.member_3[0]))) * f32(-(_e1613))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1668.x) & 2147483647u)) * _e1721)) ^ _e243.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1668.y) & 2147483647u)) * _e1728)) ^ _e243.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1668.z) & 2147483647u)) * _e1735)) ^ _e243.member_3[0]))))) ^ _e243.member_3[0])) + _e1812) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1826 = phi_2361_;
                                                        phi_2362_ = _e1826;
                                                    }
                                                    let _e1828 = phi_2362_;
                                                    if _e1828 {
                                                        if (_e1600.member < _e1118.member.member) {
                                                            phi_2382_ = true;
                                                        } else {
                                                            if (_e1600.member == _e1118.member.member) {
                                                                phi_2381_ = (_e1600.member_3 < _e1118.member.member_3);
                                                            } else {
                                                                phi_2381_ = false;
                                                            }
                                                            let _e1838 = phi_2381_;
                                                            phi_2382_ = _e1838;
                                                        }
                                                        let _e1840 = phi_2382_;
                                                        if _e1840 {
                                                            phi_2388_ = type_39(_e1600, _e1600.member);
                                                        } else {
                                                            phi_2388_ = _e1118;
                                                        }
                                                        let _e1843 = phi_2388_;
                                                        phi_2389_ = _e1843;
                                                    } else {
                                                        phi_2389_ = _e1118;
                                                    }
                                                    let _e1845 = phi_2389_;
                                                    phi_2390_ = _e1845;
                                                } else {
                                                    phi_2390_ = _e1118;
                                                }
                                                let _e1847 = phi_2390_;
                                                phi_4200_ = _e1317;
                                                phi_1102_ = _e1847;
                                            } else {
                                                phi_4200_ = _e1116;
                                                phi_1102_ = type_39();
                                            }
                                            let _e1849 = phi_4200_;
                                            let _e1851 = phi_1102_;
                                            continue;
                                            continuing {
                                                phi_4137_ = _e1849;
                                                phi_1101_ = _e1851;
                                                phi_1104_ = _e1133;
                                                phi_4199_ = _e1849;
                                                break if !(_e1139);
                                            }
                                        }
                                        let _e1854 = phi_4199_;
                                        phi_4278_ = _e1854;
                                        if _e1854 {
                                            break;
                                        }
                                        phi_4282_ = _e1854;
                                        let _e2094 = local_14;
                                        phi_3772_ = _e2094;
                                        phi_3773_ = _e626;
                                        phi_3774_ = false;
                                        phi_3775_ = _e630;
                                    } else {
                                        if (_e626.member_1 >= _e103) {
                                            phi_3328_ = type_61(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_60(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_60(type_33(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e626.member_1 < _e103) {
                                            } else {
                                                phi_4278_ = true;
                                                break;
                                            }
                                            let _e644 = ((1u + (_e365 * 2u)) % 7u);
                                            if (_e644 < 7u) {
                                            } else {
                                                phi_4278_ = true;
                                                break;
                                            }
                                            let _e649 = global_9.member[_e626.member_1][_e644];
                                            let _e652 = ((1u + (_e364 * 2u)) % 7u);
                                            if (_e652 < 7u) {
                                            } else {
                                                phi_4278_ = true;
                                                break;
                                            }
                                            let _e657 = global_9.member[_e626.member_1][_e652];
                                            let _e660 = ((1u + (_e366 * 2u)) % 7u);
                                            if (_e660 < 7u) {
                                            } else {
                                                phi_4278_ = true;
                                                break;
                                            }
                                            let _e665 = global_9.member[_e626.member_1][_e660];
                                            let _e668 = (((_e365 + 1u) * 2u) % 7u);
                                            if (_e668 < 7u) {
                                            } else {
                                                phi_4278_ = true;
                                                break;
                                            }
                                            let _e673 = global_9.member[_e626.member_1][_e668];
                                            let _e676 = (((_e364 + 1u) * 2u) % 7u);
                                            if (_e676 < 7u) {
                                            } else {
                                                phi_4278_ = true;
                                                break;
                                            }
                                            let _e681 = global_9.member[_e626.member_1][_e676];
                                            let _e684 = (((_e366 + 1u) * 2u) % 7u);
                                            if (_e684 < 7u) {
                                            } else {
                                                phi_4278_ = true;
                                                break;
                                            }
                                            let _e689 = global_9.member[_e626.member_1][_e684];
                                            let _e712 = (bitcast<f32>((bitcast<u32>((_e626.member.member_1.x - _e626.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e713 = (bitcast<f32>((bitcast<u32>((_e626.member.member_1.y - _e626.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e714 = (bitcast<f32>((bitcast<u32>((_e626.member.member_1.z - _e626.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e716 = select(_e162, _e712, (_e712 > _e162));
                                            let _e718 = select(_e162, _e713, (_e713 > _e162));
                                            let _e720 = select(_e162, _e714, (_e714 > _e162));
                                            let _e745 = bitcast<u32>((f32(bitcast<i32>((_e649 & 2097151u))) * _e716));
                                            let _e750 = (bitcast<i32>((_e649 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e753 = bitcast<f32>((_e745 & bitcast<u32>(_e750)));
                                            let _e754 = bitcast<u32>((f32(bitcast<i32>((_e657 & 2097151u))) * _e718));
                                            let _e759 = (bitcast<i32>((_e657 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e762 = bitcast<f32>((_e754 & bitcast<u32>(_e759)));
                                            let _e763 = bitcast<u32>((f32(bitcast<i32>((_e665 & 2097151u))) * _e720));
                                            let _e768 = (bitcast<i32>((_e665 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e771 = bitcast<f32>((_e763 & bitcast<u32>(_e768)));
                                            let _e775 = bitcast<f32>((_e745 & bitcast<u32>(~(_e750))));
                                            let _e779 = bitcast<f32>((_e754 & bitcast<u32>(~(_e759))));
                                            let _e783 = bitcast<f32>((_e763 & bitcast<u32>(~(_e768))));
                                            let _e784 = bitcast<u32>((f32(bitcast<i32>((_e673 & 2097151u))) * _e716));
                                            let _e789 = (bitcast<i32>((_e673 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e792 = bitcast<f32>((_e784 & bitcast<u32>(_e789)));
                                            let _e793 = bitcast<u32>((f32(bitcast<i32>((_e681 & 2097151u))) * _e718));
                                            let _e798 = (bitcast<i32>((_e681 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e801 = bitcast<f32>((_e793 & bitcast<u32>(_e798)));
                                            let _e802 = bitcast<u32>((f32(bitcast<i32>((_e689 & 2097151u))) * _e720));
                                            let _e807 = (bitcast<i32>((_e689 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e810 = bitcast<f32>((_e802 & bitcast<u32>(_e807)));
                                            let _e814 = bitcast<f32>((_e784 & bitcast<u32>(~(_e789))));
                                            let _e818 = bitcast<f32>((_e793 & bitcast<u32>(~(_e798))));
                                            let _e822 = bitcast<f32>((_e802 & bitcast<u32>(~(_e807))));
                                            let _e823 = (_e626.member.member.x + _e753);
                                            let _e824 = (_e626.member.member.y + _e762);
                                            let _e825 = (_e626.member.member.z + _e771);
                                            let _e828 = (_e626.member.member_1.x - _e792);
                                            let _e829 = (_e626.member.member_1.y - _e801);
                                            let _e830 = (_e626.member.member_1.z - _e810);
                                            let _e849 = (_e828 - _e823);
                                            let _e850 = (_e829 - _e824);
                                            let _e851 = (_e830 - _e825);
                                            let _e853 = select(_e850, _e849, (_e849 > _e850));
                                            let _e855 = select(_e851, _e853, (_e853 > _e851));
                                            if (_e855 < (1024f * _e162)) {
                                                phi_3029_ = 0u;
                                            } else {
                                                phi_3029_ = select(2u, 1u, (_e855 < (2097152f * _e162)));
                                            }
                                            let _e862 = phi_3029_;
                                            switch bitcast<i32>(_e862) {
                                                case 0: {
                                                    phi_3035_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3035_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3035_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3035_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e865 = phi_3035_;
                                            let _e871 = global_9.member[_e626.member_1][0u];
                                            let _e875 = global_9.member[_e626.member_1][2u];
                                            let _e879 = global_9.member[_e626.member_1][4u];
                                            let _e883 = global_9.member[_e626.member_1][6u];
                                            let _e895 = (((_e875 >> bitcast<u32>(22i)) | ((_e879 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e883 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e896 = (_e871 & 268435455u);
                                            let _e897 = (_e895 & 268435455u);
                                            let _e900 = ((_e871 >> bitcast<u32>(28u)) & 7u);
                                            let _e908 = ((_e871 >> bitcast<u32>(31i)) | (((_e895 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e909 = (_e900 != 0u);
                                            if (_e900 == 0u) {
                                                phi_3290_ = _e896;
                                            } else {
                                                if (_e900 == 7u) {
                                                    phi_3289_ = 2147483648u;
                                                } else {
                                                    phi_3289_ = ((2147483648u | (_e900 << bitcast<u32>(28u))) | (_e897 & 268435455u));
                                                }
                                                let _e918 = phi_3289_;
                                                phi_3290_ = _e918;
                                            }
                                            let _e920 = phi_3290_;
                                            if _e909 {
                                                let _e921 = (_e900 != 7u);
                                                if _e921 {
                                                    phi_3300_ = (_e897 + (_e900 * ((3u * _e865) + 1u)));
                                                } else {
                                                    phi_3300_ = u32();
                                                }
                                                let _e925 = phi_3300_;
                                                phi_3302_ = _e925;
                                                phi_3303_ = select(true, false, _e921);
                                            } else {
                                                phi_3302_ = u32();
                                                phi_3303_ = true;
                                            }
                                            let _e928 = phi_3302_;
                                            let _e930 = phi_3303_;
                                            if (_e908 == 0u) {
                                                phi_3324_ = (_e896 + select(0u, 1u, !(_e909)));
                                            } else {
                                                if (_e908 == 7u) {
                                                    phi_3323_ = 2147483648u;
                                                } else {
                                                    phi_3323_ = ((2147483648u | (_e908 << bitcast<u32>(28u))) | (select(_e928, _e897, _e930) & 268435455u));
                                                }
                                                let _e943 = phi_3323_;
                                                phi_3324_ = _e943;
                                            }
                                            let _e945 = phi_3324_;
                                            phi_3328_ = type_61(array<vec4<f32>, 3>(vec4<f32>(_e823, (_e626.member.member.x + _e775), _e828, (_e626.member.member_1.x - _e814)), vec4<f32>(_e824, (_e626.member.member.y + _e779), _e829, (_e626.member.member_1.y - _e818)), vec4<f32>(_e825, (_e626.member.member.z + _e783), _e830, (_e626.member.member_1.z - _e822))), type_60(type_33((_e626.member.member + vec4<f32>(_e753, _e762, _e771, 0f)), (_e626.member.member_1 - vec4<f32>(_e792, _e801, _e810, 0f))), _e920), type_60(type_33((_e626.member.member + vec4<f32>(_e775, _e779, _e783, 0f)), (_e626.member.member_1 - vec4<f32>(_e814, _e818, _e822, 0f))), _e945));
                                        }
                                        let _e950 = phi_3328_;
                                        let _e962 = ((_e950.member[0].x - _e420) * _e425);
                                        let _e963 = ((_e950.member[0].y - _e420) * _e425);
                                        let _e964 = ((_e950.member[0].z - _e421) * _e425);
                                        let _e965 = ((_e950.member[0].w - _e421) * _e425);
                                        let _e975 = ((_e950.member[1].x - _e456) * _e461);
                                        let _e976 = ((_e950.member[1].y - _e456) * _e461);
                                        let _e977 = ((_e950.member[1].z - _e457) * _e461);
                                        let _e978 = ((_e950.member[1].w - _e457) * _e461);
                                        let _e988 = ((_e950.member[2].x - _e492) * _e497);
                                        let _e989 = ((_e950.member[2].y - _e492) * _e497);
                                        let _e990 = ((_e950.member[2].z - _e493) * _e497);
                                        let _e991 = ((_e950.member[2].w - _e493) * _e497);
                                        let _e993 = select(_e990, _e988, (_e988 < _e990));
                                        let _e995 = select(_e991, _e989, (_e989 < _e991));
                                        let _e997 = select(_e990, _e988, (_e988 > _e990));
                                        let _e999 = select(_e991, _e989, (_e989 > _e991));
                                        let _e1001 = select(_e964, _e962, (_e962 < _e964));
                                        let _e1003 = select(_e965, _e963, (_e963 < _e965));
                                        let _e1005 = select(_e977, _e975, (_e975 < _e977));
                                        let _e1007 = select(_e978, _e976, (_e976 < _e978));
                                        let _e1009 = select(_e1005, _e1001, (_e1001 > _e1005));
                                        let _e1011 = select(_e1007, _e1003, (_e1003 > _e1007));
                                        let _e1013 = select(_e993, _e1009, (_e1009 > _e993));
                                        let _e1015 = select(_e995, _e1011, (_e1011 > _e995));
                                        let _e1017 = select(_e964, _e962, (_e962 > _e964));
                                        let _e1019 = select(_e965, _e963, (_e963 > _e965));
                                        let _e1021 = select(_e977, _e975, (_e975 > _e977));
                                        let _e1023 = select(_e978, _e976, (_e976 > _e978));
                                        let _e1025 = select(_e1021, _e1017, (_e1017 < _e1021));
                                        let _e1027 = select(_e1023, _e1019, (_e1019 < _e1023));
                                        let _e1032 = -(_e993);
                                        let _e1033 = -(_e995);
                                        let _e1040 = (select(_e997, _e1025, (_e1025 < _e997)) + (select(_e1032, _e997, (_e997 > _e1032)) * 0.0000019073523f));
                                        let _e1041 = (select(_e999, _e1027, (_e1027 < _e999)) + (select(_e1033, _e999, (_e999 > _e1033)) * 0.0000019073523f));
                                        let _e1043 = select(_e543, _e1013, (_e1013 > _e543));
                                        let _e1045 = select(_e543, _e1015, (_e1015 > _e543));
                                        let _e1050 = (_e1043 <= select(_e587.member_1, _e1040, (_e1040 < _e587.member_1)));
                                        let _e1051 = (_e1045 <= select(_e587.member_1, _e1041, (_e1041 < _e587.member_1)));
                                        let _e1052 = (_e1043 <= _e1045);
                                        if _e1050 {
                                            if _e1051 {
                                                if _e1052 {
                                                    phi_3672_ = _e950.member_2;
                                                } else {
                                                    phi_3672_ = _e950.member_1;
                                                }
                                                let _e1056 = phi_3672_;
                                                let _e1078 = (_e630 % 128u);
                                                let _e1079 = (_e1078 < 128u);
                                                if _e1079 {
                                                } else {
                                                    phi_4278_ = true;
                                                    break;
                                                }
                                                local_8[_e1078] = _e1056.member_1;
                                                if _e1079 {
                                                } else {
                                                    phi_4278_ = true;
                                                    break;
                                                }
                                                local_7[_e1078] = _e1056.member.member.x;
                                                if _e1079 {
                                                } else {
                                                    phi_4278_ = true;
                                                    break;
                                                }
                                                local_6[_e1078] = _e1056.member.member.y;
                                                if _e1079 {
                                                } else {
                                                    phi_4278_ = true;
                                                    break;
                                                }
                                                local_5[_e1078] = _e1056.member.member.z;
                                                if _e1079 {
                                                } else {
                                                    phi_4278_ = true;
                                                    break;
                                                }
                                                local_4[_e1078] = _e1056.member.member_1.x;
                                                if _e1079 {
                                                } else {
                                                    phi_4278_ = true;
                                                    break;
                                                }
                                                local_3[_e1078] = _e1056.member.member_1.y;
                                                if _e1079 {
                                                } else {
                                                    phi_4278_ = true;
                                                    break;
                                                }
                                                local_2[_e1078] = _e1056.member.member_1.z;
                                                if _e1079 {
                                                } else {
                                                    phi_4278_ = true;
                                                    break;
                                                }
                                                local_9[_e1078] = select(_e1045, _e1043, (_e1043 > _e1045));
                                                if _e1052 {
                                                    phi_3749_ = _e950.member_1;
                                                } else {
                                                    phi_3749_ = _e950.member_2;
                                                }
                                                let _e1092 = phi_3749_;
                                                phi_3750_ = _e1092;
                                                phi_3751_ = (_e630 + 1u);
                                            } else {
                                                phi_3750_ = type_60();
                                                phi_3751_ = u32();
                                            }
                                            let _e1094 = phi_3750_;
                                            let _e1096 = phi_3751_;
                                            phi_3753_ = _e1094;
                                            phi_3754_ = _e1096;
                                            phi_3755_ = select(true, false, _e1051);
                                        } else {
                                            phi_3753_ = type_60();
                                            phi_3754_ = u32();
                                            phi_3755_ = true;
                                        }
                                        let _e1099 = phi_3753_;
                                        let _e1101 = phi_3754_;
                                        let _e1103 = phi_3755_;
                                        if _e1103 {
                                            if _e1050 {
                                                phi_3764_ = _e950.member_1;
                                            } else {
                                                phi_3764_ = _e950.member_2;
                                            }
                                            let _e1107 = phi_3764_;
                                            phi_3769_ = _e1107;
                                            phi_3770_ = select(_e1051, true, _e1050);
                                        } else {
                                            phi_3769_ = _e1099;
                                            phi_3770_ = _e628;
                                        }
                                        let _e1110 = phi_3769_;
                                        let _e1112 = phi_3770_;
                                        phi_4282_ = _e585;
                                        phi_3772_ = _e587;
                                        phi_3773_ = _e1110;
                                        phi_3774_ = _e1112;
                                        phi_3775_ = select(_e1101, _e630, _e1103);
                                    }
                                    let _e1856 = phi_4282_;
                                    let _e1858 = phi_3772_;
                                    let _e1860 = phi_3773_;
                                    let _e1862 = phi_3774_;
                                    let _e1864 = phi_3775_;
                                    phi_4281_ = _e1856;
                                    phi_3776_ = _e1858;
                                    phi_3777_ = _e1860;
                                    phi_3778_ = (_e591 - 1u);
                                    phi_3779_ = _e1862;
                                    phi_3780_ = _e1864;
                                } else {
                                    phi_4281_ = _e585;
                                    phi_3776_ = _e587;
                                    phi_3777_ = _e626;
                                    phi_3778_ = _e591;
                                    phi_3779_ = _e628;
                                    phi_3780_ = _e630;
                                }
                                let _e1866 = phi_4281_;
                                let _e1868 = phi_3776_;
                                let _e1870 = phi_3777_;
                                let _e1872 = phi_3778_;
                                let _e1874 = phi_3779_;
                                let _e1876 = phi_3780_;
                                phi_4280_ = _e1866;
                                phi_3781_ = _e1868;
                                phi_3782_ = _e1870;
                                phi_3783_ = _e1872;
                                phi_3784_ = _e1874;
                                phi_3785_ = _e1876;
                            } else {
                                phi_4280_ = _e585;
                                phi_3781_ = type_39();
                                phi_3782_ = type_60();
                                phi_3783_ = u32();
                                phi_3784_ = bool();
                                phi_3785_ = u32();
                            }
                            let _e1878 = phi_4280_;
                            let _e1880 = phi_3781_;
                            let _e1882 = phi_3782_;
                            let _e1884 = phi_3783_;
                            let _e1886 = phi_3784_;
                            let _e1888 = phi_3785_;
                            phi_4279_ = _e1878;
                            phi_975_ = _e1880;
                            phi_978_ = _e1882;
                            phi_980_ = _e1884;
                            phi_982_ = _e1886;
                            phi_984_ = _e1888;
                            phi_3786_ = _e599;
                        } else {
                            phi_4279_ = _e585;
                            phi_975_ = type_39();
                            phi_978_ = type_60();
                            phi_980_ = u32();
                            phi_982_ = bool();
                            phi_984_ = u32();
                            phi_3786_ = false;
                        }
                        let _e1890 = phi_4279_;
                        let _e1892 = phi_975_;
                        let _e1894 = phi_978_;
                        let _e1896 = phi_980_;
                        let _e1898 = phi_982_;
                        let _e1900 = phi_984_;
                        let _e1902 = phi_3786_;
                        continue;
                        continuing {
                            phi_4140_ = _e1890;
                            phi_974_ = _e1892;
                            phi_977_ = _e1894;
                            phi_979_ = _e1896;
                            phi_981_ = _e1898;
                            phi_983_ = _e1900;
                            phi_4278_ = _e1890;
                            break if !(_e1902);
                        }
                    }
                    let _e1905 = phi_4278_;
                    if _e1905 {
                        break;
                    }
                    let _e1907 = local_13;
                    if (_e1907.member.member_3 != 4294967295u) {
                        let _e1912 = (_e367 / 3i);
                        let _e1919 = bitcast<f32>((bitcast<u32>((_e1912 + 127i)) << bitcast<u32>(23i)));
                        let _e1927 = (((_e1907.member.member * _e1919) * _e1919) * bitcast<f32>((bitcast<u32>(((_e367 - (2i * _e1912)) + 127i)) << bitcast<u32>(23i))));
                        let _e1929 = select(340282350000000000000000000000000000000f, _e1927, (_e1927 < 340282350000000000000000000000000000000f));
                        phi_3838_ = type_21(select(-340282350000000000000000000000000000000f, _e1929, (_e1929 > -340282350000000000000000000000000000000f)), _e1907.member.member_1, _e1907.member.member_2, _e1907.member.member_3);
                    } else {
                        phi_3838_ = type_21(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1936 = phi_3838_;
                    if _e244 {
                    } else {
                        break;
                    }
                    global_7.member[_e150] = _e1936;
                    if _e165 {
                    } else {
                        break;
                    }
                    let _e1940 = select(0u, 1u, (_e311 <= _e321));
                    if (_e1940 > 0u) {
                        let _e1942 = (1u < _e118);
                        if _e1942 {
                            if (0u < _e118) {
                            } else {
                                break;
                            }
                            let _e1946 = atomicAdd((&global_8.member[0u]), _e1940);
                            if ((_e1946 + _e1940) < _e1946) {
                                if _e1942 {
                                } else {
                                    break;
                                }
                                let _e1951 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1954 = select(0u, 1u, (_e1936.member_3 != 4294967295u));
                    if (_e1954 > 0u) {
                        let _e1956 = (3u < _e118);
                        if _e1956 {
                            if (2u < _e118) {
                            } else {
                                break;
                            }
                            let _e1960 = atomicAdd((&global_8.member[2u]), _e1954);
                            if ((_e1960 + _e1954) < _e1960) {
                                if _e1956 {
                                } else {
                                    break;
                                }
                                let _e1965 = atomicAdd((&global_8.member[3u]), 1u);
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
