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

struct type_25 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_27 {
    member: array<type_25>,
}

struct type_29 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_30 {
    member: type_29,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_32 {
    member: array<type_30>,
}

struct type_37 {
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
    member: type_25,
    member_1: f32,
}

struct type_47 {
    member: array<vec4<u32>, 2>,
}

struct type_50 {
    member: array<i32>,
}

struct type_60 {
    member: type_37,
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
var<uniform> global_1: type_16;
@group(0) @binding(1) 
var<uniform> global_2: type_47;
@group(0) @binding(2) 
var<uniform> global_3: type_47;
@group(0) @binding(3) 
var<storage> global_4: type_13;
@group(0) @binding(5) 
var<storage> global_5: type_4;
@group(0) @binding(6) 
var<storage> global_6: type_50;
@group(0) @binding(7) 
var<storage> global_7: type_32;
@group(0) @binding(8) 
var<storage, read_write> global_8: type_27;
@group(0) @binding(9) 
var<storage, read_write> global_9: type_68;
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
    var phi_409_: type_40;
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
    var phi_974_: type_43;
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
    var phi_1101_: type_43;
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
    var phi_2009_: type_25;
    var phi_2011_: type_25;
    var phi_2012_: bool;
    var phi_2016_: type_25;
    var phi_2017_: type_25;
    var phi_2018_: type_25;
    var phi_2019_: bool;
    var phi_2023_: type_25;
    var phi_2024_: bool;
    var phi_2028_: type_25;
    var phi_2029_: bool;
    var phi_2033_: type_25;
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
    var phi_2388_: type_43;
    var phi_2389_: type_43;
    var phi_2390_: type_43;
    var phi_4200_: bool;
    var phi_1102_: type_43;
    var phi_4199_: bool;
    var phi_4282_: bool;
    var phi_3772_: type_43;
    var phi_3773_: type_60;
    var phi_3774_: bool;
    var phi_3775_: u32;
    var phi_4281_: bool;
    var phi_3776_: type_43;
    var phi_3777_: type_60;
    var phi_3778_: u32;
    var phi_3779_: bool;
    var phi_3780_: u32;
    var phi_4280_: bool;
    var phi_3781_: type_43;
    var phi_3782_: type_60;
    var phi_3783_: u32;
    var phi_3784_: bool;
    var phi_3785_: u32;
    var phi_4279_: bool;
    var phi_975_: type_43;
    var phi_978_: type_60;
    var phi_980_: u32;
    var phi_982_: bool;
    var phi_984_: u32;
    var phi_3786_: bool;
    var phi_4278_: bool;
    var local_13: type_43;
    var phi_3838_: type_25;
    var local_14: type_43;

    switch bitcast<i32>(0u) {
        default: {
            let _e102 = global;
            let _e104 = arrayLength((&global_4.member));
            let _e107 = arrayLength((&global_10.member));
            let _e119 = arrayLength((&global_9.member));
            let _e123 = global_3.member[0u][0u];
            let _e127 = global_3.member[0u][1u];
            let _e131 = global_3.member[0u][2u];
            let _e135 = global_3.member[0u][3u];
            let _e139 = global_3.member[1u][0u];
            let _e143 = global_3.member[1u][1u];
            let _e147 = global_3.member[1u][2u];
            let _e151 = (_e102.x + (_e102.y * 2097152u));
            let _e163 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e135) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e123), bitcast<i32>(_e127), bitcast<i32>(_e131));
            local = array<i32, 3>(bitcast<i32>(_e139), bitcast<i32>(_e143), bitcast<i32>(_e147));
            let _e166 = (_e151 < arrayLength((&global_7.member)));
            if _e166 {
                if _e166 {
                } else {
                    break;
                }
                let _e170 = global_7.member[_e151].member_2;
                phi_341_ = _e170;
            } else {
                phi_341_ = 4294967295u;
            }
            let _e172 = phi_341_;
            let _e175 = global_1.member[0u];
            let _e179 = global_2.member[0u][0u];
            let _e183 = global_2.member[0u][1u];
            let _e187 = global_2.member[0u][2u];
            let _e191 = global_2.member[0u][3u];
            let _e195 = global_2.member[1u][0u];
            let _e199 = global_2.member[1u][1u];
            let _e203 = global_2.member[1u][2u];
            let _e207 = global_2.member[1u][3u];
            let _e208 = bitcast<f32>(_e179);
            let _e209 = bitcast<f32>(_e183);
            let _e210 = bitcast<f32>(_e187);
            let _e212 = bitcast<f32>(_e195);
            let _e213 = array<u32, 3>(_e199, _e203, _e207);
            let _e215 = bitcast<i32>(_e175);
            if (_e215 < -126i) {
                phi_385_ = -126i;
            } else {
                phi_385_ = select(_e215, 127i, (_e215 > 127i));
            }
            let _e220 = phi_385_;
            let _e225 = bitcast<f32>((bitcast<u32>((_e220 + 127i)) << bitcast<u32>(23i)));
            let _e231 = bitcast<f32>((bitcast<u32>(((_e215 - _e220) + 127i)) << bitcast<u32>(23i)));
            if (_e191 == 0u) {
                phi_409_ = type_40(array<f32, 3>(_e208, _e209, _e210), _e191, _e212, _e213);
            } else {
                phi_409_ = type_40(array<f32, 3>(((_e208 * _e225) * _e231), ((_e209 * _e225) * _e231), ((_e210 * _e225) * _e231)), _e191, ((_e212 * _e225) * _e231), _e213);
            }
            let _e244 = phi_409_;
            if _e166 {
                let _e245 = (_e151 < arrayLength((&global_8.member)));
                if _e245 {
                    if _e166 {
                    } else {
                        break;
                    }
                    let _e255 = global_7.member[_e151].member.member_2[0u];
                    let _e257 = (bitcast<u32>(_e255) & 2147483647u);
                    let _e263 = global_7.member[_e151].member.member_2[1u];
                    let _e265 = (bitcast<u32>(_e263) & 2147483647u);
                    let _e271 = global_7.member[_e151].member.member_2[2u];
                    let _e273 = (bitcast<u32>(_e271) & 2147483647u);
                    let _e279 = global_7.member[_e151].member.member[0u];
                    let _e281 = (bitcast<u32>(_e279) & 2147483647u);
                    let _e287 = global_7.member[_e151].member.member[1u];
                    let _e289 = (bitcast<u32>(_e287) & 2147483647u);
                    let _e295 = global_7.member[_e151].member.member[2u];
                    let _e297 = (bitcast<u32>(_e295) & 2147483647u);
                    let _e299 = select(_e265, _e257, (_e265 < _e257));
                    let _e301 = select(_e273, _e299, (_e273 < _e299));
                    let _e303 = select(_e281, _e301, (_e281 < _e301));
                    let _e305 = select(_e289, _e303, (_e289 < _e303));
                    let _e307 = select(_e297, _e305, (_e297 < _e305));
                    let _e312 = global_7.member[_e151].member.member_1;
                    let _e314 = (bitcast<u32>(_e312) & 2147483647u);
                    let _e322 = global_7.member[_e151].member.member_3;
                    let _e328 = (((select(_e314, _e307, (_e314 < _e307)) < 2139095040u) && ((bitcast<u32>(_e322) & 2147483647u) <= 2139095040u)) && (_e301 > 0u));
                    if _e328 {
                        let _e331 = (bitcast<u32>(bitcast<f32>(_e301)) & 2147483647u);
                        if (_e331 >= 8388608u) {
                            phi_515_ = (bitcast<i32>((_e331 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_515_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e331)), 32u, (_e331 == 0u))));
                        }
                        let _e345 = phi_515_;
                        phi_516_ = _e345;
                    } else {
                        phi_516_ = 0i;
                    }
                    let _e347 = phi_516_;
                    let _e348 = (_e257 == _e301);
                    if _e348 {
                        phi_526_ = true;
                    } else {
                        phi_526_ = (_e265 == _e301);
                    }
                    let _e351 = phi_526_;
                    let _e352 = select(1u, 0u, _e348);
                    if _e351 {
                        let _e353 = (_e352 + 1u);
                        phi_536_ = _e353;
                        phi_537_ = _e353;
                        phi_539_ = select(true, false, (_e353 == 2u));
                    } else {
                        phi_536_ = u32();
                        phi_537_ = 0u;
                        phi_539_ = true;
                    }
                    let _e357 = phi_536_;
                    let _e359 = phi_537_;
                    let _e361 = phi_539_;
                    if _e361 {
                        phi_544_ = (_e359 + 1u);
                    } else {
                        phi_544_ = 0u;
                    }
                    let _e365 = phi_544_;
                    let _e366 = select(_e357, _e359, _e361);
                    let _e367 = select(_e352, select(2u, _e352, _e351), _e361);
                    let _e368 = -(_e347);
                    if (_e368 < -126i) {
                        phi_577_ = -126i;
                    } else {
                        phi_577_ = select(_e368, 127i, (_e368 > 127i));
                    }
                    let _e373 = phi_577_;
                    let _e378 = bitcast<f32>((bitcast<u32>((_e373 + 127i)) << bitcast<u32>(23i)));
                    let _e384 = bitcast<f32>((bitcast<u32>(((_e368 - _e373) + 127i)) << bitcast<u32>(23i)));
                    let _e389 = global_7.member[_e151].member.member;
                    let _e390 = (_e366 == 0u);
                    if _e390 {
                        phi_595_ = _e389[0];
                    } else {
                        phi_595_ = _e389[1];
                    }
                    let _e394 = phi_595_;
                    let _e395 = (_e366 == 2u);
                    if _e395 {
                        phi_601_ = _e389[2];
                    } else {
                        phi_601_ = _e394;
                    }
                    let _e398 = phi_601_;
                    let _e399 = global_7.member[_e151].member.member_2;
                    if _e390 {
                        phi_612_ = _e399[0];
                    } else {
                        phi_612_ = _e399[1];
                    }
                    let _e403 = phi_612_;
                    if _e395 {
                        phi_618_ = _e399[2];
                    } else {
                        phi_618_ = _e403;
                    }
                    let _e406 = phi_618_;
                    let _e408 = ((_e406 * _e378) * _e384);
                    let _e412 = (bitcast<f32>((bitcast<u32>(_e408) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e412 {
                        let _e416 = (bitcast<f32>((bitcast<u32>(_e398) & 2147483647u)) * 0.00000011920929f);
                        phi_641_ = select(0.00000000000011368684f, _e416, (_e416 > 0.00000000000011368684f));
                    } else {
                        phi_641_ = 0f;
                    }
                    let _e420 = phi_641_;
                    let _e421 = (_e398 + _e420);
                    let _e422 = (_e398 - _e420);
                    let _e423 = select(_e408, 0f, _e412);
                    if _e412 {
                        phi_652_ = 38685626000000000000000000f;
                    } else {
                        phi_652_ = (1f / _e408);
                    }
                    let _e426 = phi_652_;
                    let _e427 = (_e365 == 0u);
                    if _e427 {
                        phi_661_ = _e389[0];
                    } else {
                        phi_661_ = _e389[1];
                    }
                    let _e431 = phi_661_;
                    let _e432 = (_e365 == 2u);
                    if _e432 {
                        phi_667_ = _e389[2];
                    } else {
                        phi_667_ = _e431;
                    }
                    let _e435 = phi_667_;
                    if _e427 {
                        phi_678_ = _e399[0];
                    } else {
                        phi_678_ = _e399[1];
                    }
                    let _e439 = phi_678_;
                    if _e432 {
                        phi_684_ = _e399[2];
                    } else {
                        phi_684_ = _e439;
                    }
                    let _e442 = phi_684_;
                    let _e444 = ((_e442 * _e378) * _e384);
                    let _e448 = (bitcast<f32>((bitcast<u32>(_e444) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e448 {
                        let _e452 = (bitcast<f32>((bitcast<u32>(_e435) & 2147483647u)) * 0.00000011920929f);
                        phi_707_ = select(0.00000000000011368684f, _e452, (_e452 > 0.00000000000011368684f));
                    } else {
                        phi_707_ = 0f;
                    }
                    let _e456 = phi_707_;
                    let _e457 = (_e435 + _e456);
                    let _e458 = (_e435 - _e456);
                    let _e459 = select(_e444, 0f, _e448);
                    if _e448 {
                        phi_718_ = 38685626000000000000000000f;
                    } else {
                        phi_718_ = (1f / _e444);
                    }
                    let _e462 = phi_718_;
                    let _e463 = (_e367 == 0u);
                    if _e463 {
                        phi_727_ = _e389[0];
                    } else {
                        phi_727_ = _e389[1];
                    }
                    let _e467 = phi_727_;
                    let _e468 = (_e367 == 2u);
                    if _e468 {
                        phi_733_ = _e389[2];
                    } else {
                        phi_733_ = _e467;
                    }
                    let _e471 = phi_733_;
                    if _e463 {
                        phi_744_ = _e399[0];
                    } else {
                        phi_744_ = _e399[1];
                    }
                    let _e475 = phi_744_;
                    if _e468 {
                        phi_750_ = _e399[2];
                    } else {
                        phi_750_ = _e475;
                    }
                    let _e478 = phi_750_;
                    let _e480 = ((_e478 * _e378) * _e384);
                    let _e484 = (bitcast<f32>((bitcast<u32>(_e480) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e484 {
                        let _e488 = (bitcast<f32>((bitcast<u32>(_e471) & 2147483647u)) * 0.00000011920929f);
                        phi_773_ = select(0.00000000000011368684f, _e488, (_e488 > 0.00000000000011368684f));
                    } else {
                        phi_773_ = 0f;
                    }
                    let _e492 = phi_773_;
                    let _e493 = (_e471 + _e492);
                    let _e494 = (_e471 - _e492);
                    let _e495 = select(_e480, 0f, _e484);
                    if _e484 {
                        phi_784_ = 38685626000000000000000000f;
                    } else {
                        phi_784_ = (1f / _e480);
                    }
                    let _e498 = phi_784_;
                    let _e501 = bitcast<f32>((bitcast<u32>(_e398) & 2147483647u));
                    let _e504 = bitcast<f32>((bitcast<u32>(_e435) & 2147483647u));
                    let _e506 = select(_e504, _e501, (_e501 > _e504));
                    let _e509 = bitcast<f32>((bitcast<u32>(_e471) & 2147483647u));
                    if (_e328 && (select(_e509, _e506, (_e506 > _e509)) <= 1099511600000f)) {
                        let _e514 = (_e347 / 3i);
                        let _e521 = bitcast<f32>((bitcast<u32>((_e514 + 127i)) << bitcast<u32>(23i)));
                        let _e528 = bitcast<f32>((bitcast<u32>(((_e347 - (2i * _e514)) + 127i)) << bitcast<u32>(23i)));
                        let _e529 = (((_e312 * _e521) * _e521) * _e528);
                        let _e531 = select(340282350000000000000000000000000000000f, _e529, (_e529 < 340282350000000000000000000000000000000f));
                        let _e536 = (((_e322 * _e521) * _e521) * _e528);
                        let _e538 = select(340282350000000000000000000000000000000f, _e536, (_e536 < 340282350000000000000000000000000000000f));
                        phi_884_ = select(-340282350000000000000000000000000000000f, _e538, (_e538 > -340282350000000000000000000000000000000f));
                        phi_885_ = select(-340282350000000000000000000000000000000f, _e531, (_e531 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_884_ = 0f;
                        phi_885_ = 1f;
                    }
                    let _e542 = phi_884_;
                    let _e544 = phi_885_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e548 = (_e366 % 3u);
                    let _e549 = (_e548 < 3u);
                    if _e549 {
                    } else {
                        break;
                    }
                    let _e551 = local_1[_e548];
                    let _e554 = (_e365 % 3u);
                    let _e555 = (_e554 < 3u);
                    if _e555 {
                    } else {
                        break;
                    }
                    let _e557 = local_1[_e554];
                    let _e560 = (_e367 % 3u);
                    let _e561 = (_e560 < 3u);
                    if _e561 {
                    } else {
                        break;
                    }
                    let _e563 = local_1[_e560];
                    if _e549 {
                    } else {
                        break;
                    }
                    let _e568 = local[_e548];
                    if _e555 {
                    } else {
                        break;
                    }
                    let _e572 = local[_e554];
                    if _e561 {
                    } else {
                        break;
                    }
                    let _e576 = local[_e560];
                    phi_4140_ = false;
                    phi_974_ = type_43(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e542);
                    phi_977_ = type_60(type_37(vec4<f32>((f32(_e551) * _e163), (f32(_e557) * _e163), (f32(_e563) * _e163), 0f), vec4<f32>((f32(_e568) * _e163), (f32(_e572) * _e163), (f32(_e576) * _e163), 0f)), select(0u, 2147483648u, (_e104 == 0u)));
                    phi_979_ = ((3u * _e104) + 1u);
                    phi_981_ = (_e544 <= _e542);
                    phi_983_ = 0u;
                    loop {
                        let _e586 = phi_4140_;
                        let _e588 = phi_974_;
                        let _e590 = phi_977_;
                        let _e592 = phi_979_;
                        let _e594 = phi_981_;
                        let _e596 = phi_983_;
                        local_13 = _e588;
                        if _e594 {
                            phi_994_ = true;
                        } else {
                            phi_994_ = (_e596 > 0u);
                        }
                        let _e599 = phi_994_;
                        if _e599 {
                            let _e600 = (_e592 > 0u);
                            if _e600 {
                                if _e594 {
                                    phi_1080_ = _e590;
                                    phi_1081_ = _e594;
                                    phi_1082_ = _e596;
                                } else {
                                    let _e601 = (_e596 - 1u);
                                    let _e602 = (_e601 % 128u);
                                    let _e603 = (_e602 < 128u);
                                    if _e603 {
                                    } else {
                                        phi_4278_ = true;
                                        break;
                                    }
                                    let _e605 = local_7[_e602];
                                    if _e603 {
                                    } else {
                                        phi_4278_ = true;
                                        break;
                                    }
                                    let _e607 = local_6[_e602];
                                    if _e603 {
                                    } else {
                                        phi_4278_ = true;
                                        break;
                                    }
                                    let _e609 = local_5[_e602];
                                    if _e603 {
                                    } else {
                                        phi_4278_ = true;
                                        break;
                                    }
                                    let _e611 = local_4[_e602];
                                    if _e603 {
                                    } else {
                                        phi_4278_ = true;
                                        break;
                                    }
                                    let _e613 = local_3[_e602];
                                    if _e603 {
                                    } else {
                                        phi_4278_ = true;
                                        break;
                                    }
                                    let _e615 = local_2[_e602];
                                    if _e603 {
                                    } else {
                                        phi_4278_ = true;
                                        break;
                                    }
                                    let _e620 = local_8[_e602];
                                    if _e603 {
                                    } else {
                                        phi_4278_ = true;
                                        break;
                                    }
                                    let _e623 = local_9[_e602];
                                    phi_1080_ = type_60(type_37(vec4<f32>(_e605, _e607, _e609, 0f), vec4<f32>(_e611, _e613, _e615, 0f)), _e620);
                                    phi_1081_ = (_e623 <= _e588.member_1);
                                    phi_1082_ = _e601;
                                }
                                let _e627 = phi_1080_;
                                let _e629 = phi_1081_;
                                let _e631 = phi_1082_;
                                if _e629 {
                                    let _e636 = (_e627.member_1 & 268435455u);
                                    if ((_e627.member_1 & 2147483648u) != 0u) {
                                        phi_4137_ = _e586;
                                        phi_1101_ = _e588;
                                        phi_1104_ = type_8(0u, ((_e627.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1117 = phi_4137_;
                                            let _e1119 = phi_1101_;
                                            let _e1121 = phi_1104_;
                                            local_14 = _e1119;
                                            if (_e1121.member < _e1121.member_1) {
                                                phi_1105_ = type_8((_e1121.member + 1u), _e1121.member_1);
                                                phi_1127_ = type_8(1u, _e1121.member);
                                            } else {
                                                phi_1105_ = _e1121;
                                                phi_1127_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1134 = phi_1105_;
                                            let _e1136 = phi_1127_;
                                            let _e1140 = (bitcast<i32>(_e1136.member) != 0i);
                                            if _e1140 {
                                                let _e1145 = (_e627.member.member_1.x - _e627.member.member.x);
                                                let _e1148 = (_e627.member.member_1.y - _e627.member.member.y);
                                                let _e1151 = (_e627.member.member_1.z - _e627.member.member.z);
                                                let _e1153 = select(_e1148, _e1145, (_e1145 > _e1148));
                                                let _e1155 = select(_e1151, _e1153, (_e1153 > _e1151));
                                                let _e1157 = (_e1155 < (1024f * _e163));
                                                if _e1157 {
                                                    phi_1168_ = 0u;
                                                } else {
                                                    phi_1168_ = select(2u, 1u, (_e1155 < (2097152f * _e163)));
                                                }
                                                let _e1162 = phi_1168_;
                                                switch bitcast<i32>(_e1162) {
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
                                                let _e1165 = phi_1174_;
                                                switch bitcast<i32>(_e1162) {
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
                                                let _e1172 = phi_1184_;
                                                let _e1174 = ((_e636 + (_e1136.member_1 * ((3u * _e1165) + 1u))) + (3u * _e1172));
                                                let _e1175 = (_e1174 < _e107);
                                                if _e1175 {
                                                    if _e1175 {
                                                    } else {
                                                        phi_4199_ = true;
                                                        break;
                                                    }
                                                    let _e1177 = global_10.member[_e1174];
                                                    phi_1200_ = _e1177;
                                                } else {
                                                    phi_1200_ = 4294967295u;
                                                }
                                                let _e1179 = phi_1200_;
                                                local_10 = array<u32, 3>(_e366, _e365, _e367);
                                                if _e1157 {
                                                    phi_1237_ = 0u;
                                                } else {
                                                    phi_1237_ = select(2u, 1u, (_e1155 < (2097152f * _e163)));
                                                }
                                                let _e1185 = phi_1237_;
                                                switch bitcast<i32>(_e1185) {
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
                                                let _e1188 = phi_1243_;
                                                switch bitcast<i32>(_e1185) {
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
                                                let _e1195 = phi_1253_;
                                                local_12 = array<f32, 4>(_e627.member.member.x, _e627.member.member.y, _e627.member.member.z, _e627.member.member.w);
                                                local_11[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_11[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_11[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_4122_ = _e1117;
                                                phi_1269_ = type_8(0u, 3u);
                                                loop {
                                                    let _e1209 = phi_4122_;
                                                    let _e1211 = phi_1269_;
                                                    if (_e1211.member < _e1211.member_1) {
                                                        phi_1270_ = type_8((_e1211.member + 1u), _e1211.member_1);
                                                        phi_1293_ = type_8(1u, _e1211.member);
                                                    } else {
                                                        phi_1270_ = _e1211;
                                                        phi_1293_ = type_8(0u, type_8().member_1);
                                                    }
                                                    let _e1224 = phi_1270_;
                                                    let _e1226 = phi_1293_;
                                                    let _e1230 = (bitcast<i32>(_e1226.member) != 0i);
                                                    if _e1230 {
                                                        let _e1232 = ((_e636 + (_e1136.member_1 * ((3u * _e1188) + 1u))) + (_e1226.member_1 * _e1195));
                                                        let _e1233 = (_e1232 < _e107);
                                                        if _e1233 {
                                                            if _e1233 {
                                                            } else {
                                                                phi_4197_ = true;
                                                                break;
                                                            }
                                                            let _e1235 = global_10.member[_e1232];
                                                            phi_1316_ = _e1235;
                                                        } else {
                                                            phi_1316_ = 0u;
                                                        }
                                                        let _e1237 = phi_1316_;
                                                        let _e1238 = (_e1232 + 1u);
                                                        let _e1239 = (_e1238 < _e107);
                                                        if _e1239 {
                                                            if _e1239 {
                                                            } else {
                                                                phi_4197_ = true;
                                                                break;
                                                            }
                                                            let _e1241 = global_10.member[_e1238];
                                                            phi_1331_ = _e1241;
                                                        } else {
                                                            phi_1331_ = 0u;
                                                        }
                                                        let _e1243 = phi_1331_;
                                                        phi_1334_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e1245 = phi_1334_;
                                                            if (_e1245.member < _e1245.member_1) {
                                                                phi_1335_ = type_8((_e1245.member + 1u), _e1245.member_1);
                                                                phi_1358_ = type_8(1u, _e1245.member);
                                                            } else {
                                                                phi_1335_ = _e1245;
                                                                phi_1358_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1258 = phi_1335_;
                                                            let _e1260 = phi_1358_;
                                                            let _e1264 = (bitcast<i32>(_e1260.member) != 0i);
                                                            if _e1264 {
                                                                let _e1265 = (_e1260.member_1 < 3u);
                                                                if _e1265 {
                                                                } else {
                                                                    phi_4115_ = true;
                                                                    break;
                                                                }
                                                                let _e1267 = local_10[_e1260.member_1];
                                                                if (_e1260.member_1 < 4u) {
                                                                } else {
                                                                    phi_4115_ = true;
                                                                    break;
                                                                }
                                                                let _e1270 = local_12[_e1260.member_1];
                                                                switch bitcast<i32>(_e1185) {
                                                                    case 0: {
                                                                        phi_1428_ = (_e1270 + (f32(((_e1237 >> bitcast<u32>(((10u * _e1267) & 31u))) & 1023u)) * _e163));
                                                                        break;
                                                                    }
                                                                    case 1: {
                                                                        if (_e1267 == 0u) {
                                                                            phi_1405_ = _e1237;
                                                                        } else {
                                                                            if (_e1267 == 1u) {
                                                                                phi_1404_ = ((_e1237 >> bitcast<u32>(21i)) | (_e1243 << bitcast<u32>(11i)));
                                                                            } else {
                                                                                phi_1404_ = (_e1243 >> bitcast<u32>(10i));
                                                                            }
                                                                            let _e1291 = phi_1404_;
                                                                            phi_1405_ = _e1291;
                                                                        }
                                                                        let _e1293 = phi_1405_;
                                                                        phi_1428_ = (_e1270 + (f32((_e1293 & 2097151u)) * _e163));
                                                                        break;
                                                                    }
                                                                    case 2: {
                                                                        let _e1272 = (_e1232 + _e1267);
                                                                        let _e1273 = (_e1272 < _e107);
                                                                        if _e1273 {
                                                                            if _e1273 {
                                                                            } else {
                                                                                phi_4115_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1275 = global_10.member[_e1272];
                                                                            phi_1424_ = _e1275;
                                                                        } else {
                                                                            phi_1424_ = 0u;
                                                                        }
                                                                        let _e1277 = phi_1424_;
                                                                        phi_1428_ = (f32(bitcast<i32>(_e1277)) * _e163);
                                                                        break;
                                                                    }
                                                                    default: {
                                                                        phi_1428_ = f32();
                                                                        break;
                                                                    }
                                                                }
                                                                let _e1307 = phi_1428_;
                                                                if (_e1226.member_1 < 3u) {
                                                                } else {
                                                                    phi_4115_ = true;
                                                                    break;
                                                                }
                                                                if _e1265 {
                                                                } else {
                                                                    phi_4115_ = true;
                                                                    break;
                                                                }
                                                                local_11[_e1226.member_1][_e1260.member_1] = _e1307;
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_1334_ = _e1258;
                                                                phi_4115_ = _e1209;
                                                                break if !(_e1264);
                                                            }
                                                        }
                                                        let _e1313 = phi_4115_;
                                                        phi_4197_ = _e1313;
                                                        if _e1313 {
                                                            break;
                                                        }
                                                        phi_4198_ = _e1313;
                                                    } else {
                                                        phi_4198_ = _e1209;
                                                    }
                                                    let _e1315 = phi_4198_;
                                                    continue;
                                                    continuing {
                                                        phi_4122_ = _e1315;
                                                        phi_1269_ = _e1224;
                                                        phi_4197_ = _e1315;
                                                        break if !(_e1230);
                                                    }
                                                }
                                                let _e1318 = phi_4197_;
                                                phi_4199_ = _e1318;
                                                if _e1318 {
                                                    break;
                                                }
                                                let _e1319 = local_11;
                                                let _e1335 = (_e1319[0][2] - _e471);
                                                let _e1338 = (((_e1319[0][0] - _e398) * _e495) - (_e1335 * _e423));
                                                let _e1341 = (((_e1319[0][1] - _e435) * _e495) - (_e1335 * _e459));
                                                let _e1344 = (_e1319[1][2] - _e471);
                                                let _e1347 = (((_e1319[1][0] - _e398) * _e495) - (_e1344 * _e423));
                                                let _e1350 = (((_e1319[1][1] - _e435) * _e495) - (_e1344 * _e459));
                                                let _e1353 = (_e1319[2][2] - _e471);
                                                let _e1356 = (((_e1319[2][0] - _e398) * _e495) - (_e1353 * _e423));
                                                let _e1359 = (((_e1319[2][1] - _e435) * _e495) - (_e1353 * _e459));
                                                let _e1360 = (_e1356 * _e1350);
                                                let _e1361 = (_e1359 * _e1347);
                                                let _e1362 = (_e1338 * _e1359);
                                                let _e1363 = (_e1341 * _e1356);
                                                let _e1364 = (_e1347 * _e1341);
                                                let _e1365 = (_e1350 * _e1338);
                                                let _e1370 = (((_e1360 >= _e1361) && (_e1362 >= _e1363)) && (_e1364 >= _e1365));
                                                if (_e1370 || (((_e1360 <= _e1361) && (_e1362 <= _e1363)) && (_e1364 <= _e1365))) {
                                                    let _e1377 = select(-1f, 1f, _e1370);
                                                    let _e1379 = ((_e1360 - _e1361) * _e1377);
                                                    let _e1381 = select(0f, _e1379, (_e1379 > 0f));
                                                    let _e1383 = ((_e1362 - _e1363) * _e1377);
                                                    let _e1385 = select(0f, _e1383, (_e1383 > 0f));
                                                    let _e1387 = ((_e1364 - _e1365) * _e1377);
                                                    let _e1389 = select(0f, _e1387, (_e1387 > 0f));
                                                    let _e1391 = ((_e1381 + _e1385) + _e1389);
                                                    if (_e1391 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2023_ = type_25();
                                                        phi_2024_ = true;
                                                    } else {
                                                        let _e1394 = select(_e1319[1][0], _e1319[0][0], (_e1319[0][0] < _e1319[1][0]));
                                                        let _e1398 = select(_e1319[1][0], _e1319[0][0], (_e1319[0][0] > _e1319[1][0]));
                                                        let _e1402 = select(_e1319[1][1], _e1319[0][1], (_e1319[0][1] < _e1319[1][1]));
                                                        let _e1406 = select(_e1319[1][1], _e1319[0][1], (_e1319[0][1] > _e1319[1][1]));
                                                        let _e1410 = select(_e1319[1][2], _e1319[0][2], (_e1319[0][2] < _e1319[1][2]));
                                                        let _e1414 = select(_e1319[1][2], _e1319[0][2], (_e1319[0][2] > _e1319[1][2]));
                                                        let _e1419 = ((select(_e1319[2][0], _e1394, (_e1394 < _e1319[2][0])) - _e421) * _e426);
                                                        let _e1420 = ((select(_e1319[2][0], _e1398, (_e1398 > _e1319[2][0])) - _e422) * _e426);
                                                        let _e1423 = ((select(_e1319[2][1], _e1402, (_e1402 < _e1319[2][1])) - _e457) * _e462);
                                                        let _e1424 = ((select(_e1319[2][1], _e1406, (_e1406 > _e1319[2][1])) - _e458) * _e462);
                                                        let _e1427 = ((select(_e1319[2][2], _e1410, (_e1410 < _e1319[2][2])) - _e493) * _e498);
                                                        let _e1428 = ((select(_e1319[2][2], _e1414, (_e1414 > _e1319[2][2])) - _e494) * _e498);
                                                        let _e1430 = select(_e1428, _e1427, (_e1427 < _e1428));
                                                        let _e1432 = select(_e1428, _e1427, (_e1427 > _e1428));
                                                        let _e1434 = select(_e1420, _e1419, (_e1419 < _e1420));
                                                        let _e1436 = select(_e1424, _e1423, (_e1423 < _e1424));
                                                        let _e1438 = select(_e1436, _e1434, (_e1434 > _e1436));
                                                        let _e1440 = select(_e1430, _e1438, (_e1438 > _e1430));
                                                        let _e1442 = select(_e1420, _e1419, (_e1419 > _e1420));
                                                        let _e1444 = select(_e1424, _e1423, (_e1423 > _e1424));
                                                        let _e1446 = select(_e1444, _e1442, (_e1442 < _e1444));
                                                        let _e1448 = select(_e1432, _e1446, (_e1446 < _e1432));
                                                        let _e1449 = -(_e1430);
                                                        let _e1455 = select(_e544, _e1440, (_e1440 > _e544));
                                                        if (_e1455 > (_e1448 + (select(_e1449, _e1432, (_e1432 > _e1449)) * 0.0000019073523f))) {
                                                            phi_2018_ = type_25();
                                                            phi_2019_ = true;
                                                        } else {
                                                            let _e1457 = (_e1455 > _e1119.member_1);
                                                            if _e1457 {
                                                                phi_2017_ = type_25();
                                                            } else {
                                                                let _e1461 = (_e1319[1][0] - _e1319[0][0]);
                                                                let _e1462 = (_e1319[1][1] - _e1319[0][1]);
                                                                let _e1463 = (_e1319[1][2] - _e1319[0][2]);
                                                                let _e1464 = vec3<f32>(_e1461, _e1462, _e1463);
                                                                let _e1465 = (_e1319[2][0] - _e1319[1][0]);
                                                                let _e1466 = (_e1319[2][1] - _e1319[1][1]);
                                                                let _e1467 = (_e1319[2][2] - _e1319[1][2]);
                                                                let _e1468 = vec3<f32>(_e1465, _e1466, _e1467);
                                                                let _e1469 = (_e1319[0][0] - _e1319[2][0]);
                                                                let _e1470 = (_e1319[0][1] - _e1319[2][1]);
                                                                let _e1471 = (_e1319[0][2] - _e1319[2][2]);
                                                                let _e1472 = vec3<f32>(_e1469, _e1470, _e1471);
                                                                let _e1475 = bitcast<f32>((bitcast<u32>(_e1461) & 2147483647u));
                                                                let _e1478 = bitcast<f32>((bitcast<u32>(_e1462) & 2147483647u));
                                                                let _e1480 = select(_e1478, _e1475, (_e1475 > _e1478));
                                                                let _e1483 = bitcast<f32>((bitcast<u32>(_e1463) & 2147483647u));
                                                                let _e1485 = select(_e1483, _e1480, (_e1480 > _e1483));
                                                                let _e1488 = bitcast<f32>((bitcast<u32>(_e1465) & 2147483647u));
                                                                let _e1491 = bitcast<f32>((bitcast<u32>(_e1466) & 2147483647u));
                                                                let _e1493 = select(_e1491, _e1488, (_e1488 > _e1491));
                                                                let _e1496 = bitcast<f32>((bitcast<u32>(_e1467) & 2147483647u));
                                                                let _e1498 = select(_e1496, _e1493, (_e1493 > _e1496));
                                                                let _e1501 = bitcast<f32>((bitcast<u32>(_e1469) & 2147483647u));
                                                                let _e1504 = bitcast<f32>((bitcast<u32>(_e1470) & 2147483647u));
                                                                let _e1506 = select(_e1504, _e1501, (_e1501 > _e1504));
                                                                let _e1509 = bitcast<f32>((bitcast<u32>(_e1471) & 2147483647u));
                                                                let _e1511 = select(_e1509, _e1506, (_e1506 > _e1509));
                                                                let _e1513 = select(_e1498, _e1485, (_e1485 > _e1498));
                                                                let _e1515 = select(_e1511, _e1513, (_e1513 > _e1511));
                                                                if (_e1485 == _e1515) {
                                                                    phi_1928_ = _e1468;
                                                                    phi_1929_ = _e1472;
                                                                } else {
                                                                    let _e1518 = vec3((_e1498 == _e1515));
                                                                    phi_1928_ = select(_e1464, _e1472, _e1518);
                                                                    phi_1929_ = select(_e1468, _e1464, _e1518);
                                                                }
                                                                let _e1522 = phi_1928_;
                                                                let _e1524 = phi_1929_;
                                                                let _e1531 = ((_e1522.y * _e1524.z) - (_e1524.y * _e1522.z));
                                                                let _e1536 = ((_e1522.z * _e1524.x) - (_e1524.z * _e1522.x));
                                                                let _e1539 = ((_e1522.x * _e1524.y) - (_e1524.x * _e1522.y));
                                                                if (_e1381 >= _e1385) {
                                                                    phi_1960_ = select(true, false, (_e1381 >= _e1389));
                                                                } else {
                                                                    phi_1960_ = true;
                                                                }
                                                                let _e1544 = phi_1960_;
                                                                if _e1544 {
                                                                    phi_1969_ = select(vec3<f32>(_e1319[2][0], _e1319[2][1], _e1319[2][2]), vec3<f32>(_e1319[1][0], _e1319[1][1], _e1319[1][2]), vec3((_e1385 >= _e1389)));
                                                                } else {
                                                                    phi_1969_ = vec3<f32>(_e1319[0][0], _e1319[0][1], _e1319[0][2]);
                                                                }
                                                                let _e1549 = phi_1969_;
                                                                let _e1566 = ((((_e1531 * (_e1549.x - _e398)) + (_e1536 * (_e1549.y - _e435))) + (_e1539 * (_e1549.z - _e471))) / (((_e1531 * _e423) + (_e1536 * _e459)) + (_e1539 * _e495)));
                                                                let _e1568 = select(_e1448, _e1566, (_e1566 < _e1448));
                                                                let _e1570 = select(_e1440, _e1568, (_e1568 > _e1440));
                                                                if (_e1570 >= _e544) {
                                                                    let _e1572 = (_e1570 <= _e1119.member_1);
                                                                    if _e1572 {
                                                                        let _e1573 = (1f / _e1391);
                                                                        phi_2009_ = type_25(_e1570, (_e1385 * _e1573), (_e1389 * _e1573), _e1179);
                                                                    } else {
                                                                        phi_2009_ = type_25();
                                                                    }
                                                                    let _e1578 = phi_2009_;
                                                                    phi_2011_ = _e1578;
                                                                    phi_2012_ = select(true, false, _e1572);
                                                                } else {
                                                                    phi_2011_ = type_25();
                                                                    phi_2012_ = true;
                                                                }
                                                                let _e1581 = phi_2011_;
                                                                let _e1583 = phi_2012_;
                                                                if _e1583 {
                                                                    phi_2016_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2016_ = _e1581;
                                                                }
                                                                let _e1585 = phi_2016_;
                                                                phi_2017_ = _e1585;
                                                            }
                                                            let _e1587 = phi_2017_;
                                                            phi_2018_ = _e1587;
                                                            phi_2019_ = _e1457;
                                                        }
                                                        let _e1589 = phi_2018_;
                                                        let _e1591 = phi_2019_;
                                                        phi_2023_ = _e1589;
                                                        phi_2024_ = _e1591;
                                                    }
                                                    let _e1593 = phi_2023_;
                                                    let _e1595 = phi_2024_;
                                                    phi_2028_ = _e1593;
                                                    phi_2029_ = _e1595;
                                                } else {
                                                    phi_2028_ = type_25();
                                                    phi_2029_ = true;
                                                }
                                                let _e1597 = phi_2028_;
                                                let _e1599 = phi_2029_;
                                                if _e1599 {
                                                    phi_2033_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2033_ = _e1597;
                                                }
                                                let _e1601 = phi_2033_;
                                                if (_e1601.member_3 != 4294967295u) {
                                                    if (_e1179 == _e172) {
                                                        phi_2362_ = false;
                                                    } else {
                                                        let _e1605 = (_e1179 < arrayLength((&global_5.member)));
                                                        if _e1605 {
                                                            if _e1605 {
                                                            } else {
                                                                phi_4199_ = true;
                                                                break;
                                                            }
                                                            let _e1607 = global_5.member[_e1179];
                                                            phi_2056_ = _e1607;
                                                        } else {
                                                            phi_2056_ = 4294967295u;
                                                        }
                                                        let _e1609 = phi_2056_;
                                                        let _e1610 = (_e1609 < arrayLength((&global_6.member)));
                                                        if _e1610 {
                                                            if _e1610 {
                                                            } else {
                                                                phi_4199_ = true;
                                                                break;
                                                            }
                                                            let _e1612 = global_6.member[_e1609];
                                                            phi_2070_ = _e1612;
                                                        } else {
                                                            phi_2070_ = 0i;
                                                        }
                                                        let _e1614 = phi_2070_;
                                                        let _e1615 = (_e1614 == 0i);
                                                        if _e1615 {
                                                            phi_2361_ = true;
                                                        } else {
                                                            if _e390 {
                                                                phi_2091_ = vec3<f32>(_e1319[0][0], _e1319[0][1], _e1319[0][2]);
                                                            } else {
                                                                if (_e366 == 1u) {
                                                                    phi_2090_ = vec3<f32>(_e1319[0][2], _e1319[0][0], _e1319[0][1]);
                                                                } else {
                                                                    phi_2090_ = vec3<f32>(_e1319[0][1], _e1319[0][2], _e1319[0][0]);
                                                                }
                                                                let _e1620 = phi_2090_;
                                                                phi_2091_ = _e1620;
                                                            }
                                                            let _e1623 = phi_2091_;
                                                            if _e390 {
                                                                phi_2108_ = vec3<f32>(_e1319[1][0], _e1319[1][1], _e1319[1][2]);
                                                            } else {
                                                                if (_e366 == 1u) {
                                                                    phi_2107_ = vec3<f32>(_e1319[1][2], _e1319[1][0], _e1319[1][1]);
                                                                } else {
                                                                    phi_2107_ = vec3<f32>(_e1319[1][1], _e1319[1][2], _e1319[1][0]);
                                                                }
                                                                let _e1628 = phi_2107_;
                                                                phi_2108_ = _e1628;
                                                            }
                                                            let _e1631 = phi_2108_;
                                                            if _e390 {
                                                                phi_2125_ = vec3<f32>(_e1319[2][0], _e1319[2][1], _e1319[2][2]);
                                                            } else {
                                                                if (_e366 == 1u) {
                                                                    phi_2124_ = vec3<f32>(_e1319[2][2], _e1319[2][0], _e1319[2][1]);
                                                                } else {
                                                                    phi_2124_ = vec3<f32>(_e1319[2][1], _e1319[2][2], _e1319[2][0]);
                                                                }
                                                                let _e1636 = phi_2124_;
                                                                phi_2125_ = _e1636;
                                                            }
                                                            let _e1639 = phi_2125_;
                                                            let _e1642 = (_e1631.x - _e1623.x);
                                                            let _e1645 = (_e1631.y - _e1623.y);
                                                            let _e1648 = (_e1631.z - _e1623.z);
                                                            let _e1650 = (_e1639.x - _e1623.x);
                                                            let _e1652 = (_e1639.y - _e1623.y);
                                                            let _e1654 = (_e1639.z - _e1623.z);
                                                            if (_e244.member_1 == 1u) {
                                                                phi_2161_ = (vec3<f32>(_e244.member[0], _e244.member[1], _e244.member[2]) - _e1623);
                                                            } else {
                                                                phi_2161_ = vec3<f32>(_e244.member[0], _e244.member[1], _e244.member[2]);
                                                            }
                                                            let _e1669 = phi_2161_;
                                                            let _e1675 = bitcast<f32>((bitcast<u32>((_e1642 * _e1652)) ^ _e244.member_3[0]));
                                                            let _e1679 = bitcast<f32>((bitcast<u32>((_e1645 * _e1650)) ^ _e244.member_3[0]));
                                                            let _e1683 = bitcast<f32>((bitcast<u32>((_e1645 * _e1654)) ^ _e244.member_3[0]));
                                                            let _e1687 = bitcast<f32>((bitcast<u32>((_e1648 * _e1652)) ^ _e244.member_3[0]));
                                                            let _e1691 = bitcast<f32>((bitcast<u32>((_e1648 * _e1650)) ^ _e244.member_3[0]));
                                                            let _e1695 = bitcast<f32>((bitcast<u32>((_e1642 * _e1654)) ^ _e244.member_3[0]));
                                                            let _e1696 = (_e1683 - _e1687);
                                                            let _e1697 = (_e1691 - _e1695);
                                                            let _e1698 = (_e1675 - _e1679);
                                                            let _e1722 = (bitcast<f32>((bitcast<u32>(_e1683) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1687) & 2147483647u)));
                                                            let _e1729 = (bitcast<f32>((bitcast<u32>(_e1691) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1695) & 2147483647u)));
                                                            let _e1736 = (bitcast<f32>((bitcast<u32>(_e1675) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1679) & 2147483647u)));
                                                            if (_e244.member_2 == 0f) {
                                                                phi_2343_ = 0f;
                                                            } else {
                                                                let _e1766 = bitcast<f32>((bitcast<u32>(_e1696) & 2147483647u));
                                                                let _e1769 = bitcast<f32>((bitcast<u32>(_e1697) & 2147483647u));
                                                                let _e1772 = bitcast<f32>((bitcast<u32>(_e1698) & 2147483647u));
                                                                let _e1774 = select(_e1772, _e1769, (_e1769 > _e1772));
                                                                let _e1778 = select(_e1772, _e1769, (_e1769 < _e1772));
                                                                let _e1782 = select(_e1769, _e1766, (_e1766 < _e1769));
                                                                let _e1784 = select(_e1769, _e1766, (_e1766 > _e1769));
                                                                let _e1786 = select(_e1772, _e1784, (_e1784 < _e1772));
                                                                phi_2343_ = bitcast<f32>((bitcast<u32>((_e244.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1774, _e1766, (_e1766 > _e1774)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1786, _e1782, (_e1782 > _e1786)))) ^ _e244.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1778, _e1766, (_e1766 < _e1778)))) ^ _e244.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1722 + _e1729) + _e1736))) ^ _e244.member_3[0]))) * 1.0000005f)) ^ _e244.member_3[0])))) ^ _e244.member_3[0]));
                                                            }
                                                            let _e1813 = phi_2343_;
                                                            phi_2361_ = (_e1615 || !(((((bitcast<f32>((bitcast<u32>((_e1669.x * _e1696)) ^ _e244.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1669.y * _e1697)) ^ _e244.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1669.z * _e1698)) ^ _e244.member_3[0]))) * f32(-(_e1614))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1669.x) & 2147483647u)) * _e1722)) ^ _e244.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1669.y) & 2147483647u)) * _e1729)) ^ _e244.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1669.z) & 2147483647u)) * _e1736)) ^ _e244.member_3[0]))))) ^ _e244.member_3[0])) + _e1813) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1827 = phi_2361_;
                                                        phi_2362_ = _e1827;
                                                    }
                                                    let _e1829 = phi_2362_;
                                                    if _e1829 {
                                                        if (_e1601.member < _e1119.member.member) {
                                                            phi_2382_ = true;
                                                        } else {
                                                            if (_e1601.member == _e1119.member.member) {
                                                                phi_2381_ = (_e1601.member_3 < _e1119.member.member_3);
                                                            } else {
                                                                phi_2381_ = false;
                                                            }
                                                            let _e1839 = phi_2381_;
                                                            phi_2382_ = _e1839;
                                                        }
                                                        let _e1841 = phi_2382_;
                                                        if _e1841 {
                                                            phi_2388_ = type_43(_e1601, _e1601.member);
                                                        } else {
                                                            phi_2388_ = _e1119;
                                                        }
                                                        let _e1844 = phi_2388_;
                                                        phi_2389_ = _e1844;
                                                    } else {
                                                        phi_2389_ = _e1119;
                                                    }
                                                    let _e1846 = phi_2389_;
                                                    phi_2390_ = _e1846;
                                                } else {
                                                    phi_2390_ = _e1119;
                                                }
                                                let _e1848 = phi_2390_;
                                                phi_4200_ = _e1318;
                                                phi_1102_ = _e1848;
                                            } else {
                                                phi_4200_ = _e1117;
                                                phi_1102_ = type_43();
                                            }
                                            let _e1850 = phi_4200_;
                                            let _e1852 = phi_1102_;
                                            continue;
                                            continuing {
                                                phi_4137_ = _e1850;
                                                phi_1101_ = _e1852;
                                                phi_1104_ = _e1134;
                                                phi_4199_ = _e1850;
                                                break if !(_e1140);
                                            }
                                        }
                                        let _e1855 = phi_4199_;
                                        phi_4278_ = _e1855;
                                        if _e1855 {
                                            break;
                                        }
                                        phi_4282_ = _e1855;
                                        let _e2095 = local_14;
                                        phi_3772_ = _e2095;
                                        phi_3773_ = _e627;
                                        phi_3774_ = false;
                                        phi_3775_ = _e631;
                                    } else {
                                        if (_e627.member_1 >= _e104) {
                                            phi_3328_ = type_61(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e627.member_1 < _e104) {
                                            } else {
                                                phi_4278_ = true;
                                                break;
                                            }
                                            let _e644 = ((1u + _e366) % 4u);
                                            if (_e644 < 4u) {
                                            } else {
                                                phi_4278_ = true;
                                                break;
                                            }
                                            let _e649 = global_4.member[_e627.member_1][_e644];
                                            let _e651 = ((1u + _e365) % 4u);
                                            if (_e651 < 4u) {
                                            } else {
                                                phi_4278_ = true;
                                                break;
                                            }
                                            let _e656 = global_4.member[_e627.member_1][_e651];
                                            let _e658 = ((1u + _e367) % 4u);
                                            if (_e658 < 4u) {
                                            } else {
                                                phi_4278_ = true;
                                                break;
                                            }
                                            let _e663 = global_4.member[_e627.member_1][_e658];
                                            let _e665 = ((_e366 + 1u) % 4u);
                                            if (_e665 < 4u) {
                                            } else {
                                                phi_4278_ = true;
                                                break;
                                            }
                                            let _e670 = global_4.member[_e627.member_1][_e665];
                                            let _e672 = (_e670 >> bitcast<u32>(11u));
                                            let _e674 = ((_e365 + 1u) % 4u);
                                            if (_e674 < 4u) {
                                            } else {
                                                phi_4278_ = true;
                                                break;
                                            }
                                            let _e679 = global_4.member[_e627.member_1][_e674];
                                            let _e681 = (_e679 >> bitcast<u32>(11u));
                                            let _e683 = ((_e367 + 1u) % 4u);
                                            if (_e683 < 4u) {
                                            } else {
                                                phi_4278_ = true;
                                                break;
                                            }
                                            let _e688 = global_4.member[_e627.member_1][_e683];
                                            let _e690 = (_e688 >> bitcast<u32>(11u));
                                            let _e713 = (bitcast<f32>((bitcast<u32>((_e627.member.member_1.x - _e627.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e714 = (bitcast<f32>((bitcast<u32>((_e627.member.member_1.y - _e627.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e715 = (bitcast<f32>((bitcast<u32>((_e627.member.member_1.z - _e627.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e717 = select(_e163, _e713, (_e713 > _e163));
                                            let _e719 = select(_e163, _e714, (_e714 > _e163));
                                            let _e721 = select(_e163, _e715, (_e715 > _e163));
                                            let _e746 = bitcast<u32>((f32(bitcast<i32>((_e649 & 1023u))) * _e717));
                                            let _e751 = (bitcast<i32>((_e649 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e754 = bitcast<f32>((_e746 & bitcast<u32>(_e751)));
                                            let _e755 = bitcast<u32>((f32(bitcast<i32>((_e656 & 1023u))) * _e719));
                                            let _e760 = (bitcast<i32>((_e656 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e763 = bitcast<f32>((_e755 & bitcast<u32>(_e760)));
                                            let _e764 = bitcast<u32>((f32(bitcast<i32>((_e663 & 1023u))) * _e721));
                                            let _e769 = (bitcast<i32>((_e663 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e772 = bitcast<f32>((_e764 & bitcast<u32>(_e769)));
                                            let _e776 = bitcast<f32>((_e746 & bitcast<u32>(~(_e751))));
                                            let _e780 = bitcast<f32>((_e755 & bitcast<u32>(~(_e760))));
                                            let _e784 = bitcast<f32>((_e764 & bitcast<u32>(~(_e769))));
                                            let _e785 = bitcast<u32>((f32(bitcast<i32>((_e672 & 1023u))) * _e717));
                                            let _e790 = (bitcast<i32>((_e672 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e793 = bitcast<f32>((_e785 & bitcast<u32>(_e790)));
                                            let _e794 = bitcast<u32>((f32(bitcast<i32>((_e681 & 1023u))) * _e719));
                                            let _e799 = (bitcast<i32>((_e681 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e802 = bitcast<f32>((_e794 & bitcast<u32>(_e799)));
                                            let _e803 = bitcast<u32>((f32(bitcast<i32>((_e690 & 1023u))) * _e721));
                                            let _e808 = (bitcast<i32>((_e690 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e811 = bitcast<f32>((_e803 & bitcast<u32>(_e808)));
                                            let _e815 = bitcast<f32>((_e785 & bitcast<u32>(~(_e790))));
                                            let _e819 = bitcast<f32>((_e794 & bitcast<u32>(~(_e799))));
                                            let _e823 = bitcast<f32>((_e803 & bitcast<u32>(~(_e808))));
                                            let _e824 = (_e627.member.member.x + _e754);
                                            let _e825 = (_e627.member.member.y + _e763);
                                            let _e826 = (_e627.member.member.z + _e772);
                                            let _e829 = (_e627.member.member_1.x - _e793);
                                            let _e830 = (_e627.member.member_1.y - _e802);
                                            let _e831 = (_e627.member.member_1.z - _e811);
                                            let _e850 = (_e829 - _e824);
                                            let _e851 = (_e830 - _e825);
                                            let _e852 = (_e831 - _e826);
                                            let _e854 = select(_e851, _e850, (_e850 > _e851));
                                            let _e856 = select(_e852, _e854, (_e854 > _e852));
                                            if (_e856 < (1024f * _e163)) {
                                                phi_3029_ = 0u;
                                            } else {
                                                phi_3029_ = select(2u, 1u, (_e856 < (2097152f * _e163)));
                                            }
                                            let _e863 = phi_3029_;
                                            switch bitcast<i32>(_e863) {
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
                                            let _e866 = phi_3035_;
                                            let _e872 = global_4.member[_e627.member_1][0u];
                                            let _e876 = global_4.member[_e627.member_1][1u];
                                            let _e880 = global_4.member[_e627.member_1][2u];
                                            let _e884 = global_4.member[_e627.member_1][3u];
                                            let _e896 = (((_e876 >> bitcast<u32>(22i)) | ((_e880 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e884 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e897 = (_e872 & 268435455u);
                                            let _e898 = (_e896 & 268435455u);
                                            let _e901 = ((_e872 >> bitcast<u32>(28u)) & 7u);
                                            let _e909 = ((_e872 >> bitcast<u32>(31i)) | (((_e896 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e910 = (_e901 != 0u);
                                            if (_e901 == 0u) {
                                                phi_3290_ = _e897;
                                            } else {
                                                if (_e901 == 7u) {
                                                    phi_3289_ = 2147483648u;
                                                } else {
                                                    phi_3289_ = ((2147483648u | (_e901 << bitcast<u32>(28u))) | (_e898 & 268435455u));
                                                }
                                                let _e919 = phi_3289_;
                                                phi_3290_ = _e919;
                                            }
                                            let _e921 = phi_3290_;
                                            if _e910 {
                                                let _e922 = (_e901 != 7u);
                                                if _e922 {
                                                    phi_3300_ = (_e898 + (_e901 * ((3u * _e866) + 1u)));
                                                } else {
                                                    phi_3300_ = u32();
                                                }
                                                let _e926 = phi_3300_;
                                                phi_3302_ = _e926;
                                                phi_3303_ = select(true, false, _e922);
                                            } else {
                                                phi_3302_ = u32();
                                                phi_3303_ = true;
                                            }
                                            let _e929 = phi_3302_;
                                            let _e931 = phi_3303_;
                                            if (_e909 == 0u) {
                                                phi_3324_ = (_e897 + select(0u, 1u, !(_e910)));
                                            } else {
                                                if (_e909 == 7u) {
                                                    phi_3323_ = 2147483648u;
                                                } else {
                                                    phi_3323_ = ((2147483648u | (_e909 << bitcast<u32>(28u))) | (select(_e929, _e898, _e931) & 268435455u));
                                                }
                                                let _e944 = phi_3323_;
                                                phi_3324_ = _e944;
                                            }
                                            let _e946 = phi_3324_;
                                            phi_3328_ = type_61(array<vec4<f32>, 3>(vec4<f32>(_e824, (_e627.member.member.x + _e776), _e829, (_e627.member.member_1.x - _e815)), vec4<f32>(_e825, (_e627.member.member.y + _e780), _e830, (_e627.member.member_1.y - _e819)), vec4<f32>(_e826, (_e627.member.member.z + _e784), _e831, (_e627.member.member_1.z - _e823))), type_60(type_37((_e627.member.member + vec4<f32>(_e754, _e763, _e772, 0f)), (_e627.member.member_1 - vec4<f32>(_e793, _e802, _e811, 0f))), _e921), type_60(type_37((_e627.member.member + vec4<f32>(_e776, _e780, _e784, 0f)), (_e627.member.member_1 - vec4<f32>(_e815, _e819, _e823, 0f))), _e946));
                                        }
                                        let _e951 = phi_3328_;
                                        let _e963 = ((_e951.member[0].x - _e421) * _e426);
                                        let _e964 = ((_e951.member[0].y - _e421) * _e426);
                                        let _e965 = ((_e951.member[0].z - _e422) * _e426);
                                        let _e966 = ((_e951.member[0].w - _e422) * _e426);
                                        let _e976 = ((_e951.member[1].x - _e457) * _e462);
                                        let _e977 = ((_e951.member[1].y - _e457) * _e462);
                                        let _e978 = ((_e951.member[1].z - _e458) * _e462);
                                        let _e979 = ((_e951.member[1].w - _e458) * _e462);
                                        let _e989 = ((_e951.member[2].x - _e493) * _e498);
                                        let _e990 = ((_e951.member[2].y - _e493) * _e498);
                                        let _e991 = ((_e951.member[2].z - _e494) * _e498);
                                        let _e992 = ((_e951.member[2].w - _e494) * _e498);
                                        let _e994 = select(_e991, _e989, (_e989 < _e991));
                                        let _e996 = select(_e992, _e990, (_e990 < _e992));
                                        let _e998 = select(_e991, _e989, (_e989 > _e991));
                                        let _e1000 = select(_e992, _e990, (_e990 > _e992));
                                        let _e1002 = select(_e965, _e963, (_e963 < _e965));
                                        let _e1004 = select(_e966, _e964, (_e964 < _e966));
                                        let _e1006 = select(_e978, _e976, (_e976 < _e978));
                                        let _e1008 = select(_e979, _e977, (_e977 < _e979));
                                        let _e1010 = select(_e1006, _e1002, (_e1002 > _e1006));
                                        let _e1012 = select(_e1008, _e1004, (_e1004 > _e1008));
                                        let _e1014 = select(_e994, _e1010, (_e1010 > _e994));
                                        let _e1016 = select(_e996, _e1012, (_e1012 > _e996));
                                        let _e1018 = select(_e965, _e963, (_e963 > _e965));
                                        let _e1020 = select(_e966, _e964, (_e964 > _e966));
                                        let _e1022 = select(_e978, _e976, (_e976 > _e978));
                                        let _e1024 = select(_e979, _e977, (_e977 > _e979));
                                        let _e1026 = select(_e1022, _e1018, (_e1018 < _e1022));
                                        let _e1028 = select(_e1024, _e1020, (_e1020 < _e1024));
                                        let _e1033 = -(_e994);
                                        let _e1034 = -(_e996);
                                        let _e1041 = (select(_e998, _e1026, (_e1026 < _e998)) + (select(_e1033, _e998, (_e998 > _e1033)) * 0.0000019073523f));
                                        let _e1042 = (select(_e1000, _e1028, (_e1028 < _e1000)) + (select(_e1034, _e1000, (_e1000 > _e1034)) * 0.0000019073523f));
                                        let _e1044 = select(_e544, _e1014, (_e1014 > _e544));
                                        let _e1046 = select(_e544, _e1016, (_e1016 > _e544));
                                        let _e1051 = (_e1044 <= select(_e588.member_1, _e1041, (_e1041 < _e588.member_1)));
                                        let _e1052 = (_e1046 <= select(_e588.member_1, _e1042, (_e1042 < _e588.member_1)));
                                        let _e1053 = (_e1044 <= _e1046);
                                        if _e1051 {
                                            if _e1052 {
                                                if _e1053 {
                                                    phi_3672_ = _e951.member_2;
                                                } else {
                                                    phi_3672_ = _e951.member_1;
                                                }
                                                let _e1057 = phi_3672_;
                                                let _e1079 = (_e631 % 128u);
                                                let _e1080 = (_e1079 < 128u);
                                                if _e1080 {
                                                } else {
                                                    phi_4278_ = true;
                                                    break;
                                                }
                                                local_8[_e1079] = _e1057.member_1;
                                                if _e1080 {
                                                } else {
                                                    phi_4278_ = true;
                                                    break;
                                                }
                                                local_7[_e1079] = _e1057.member.member.x;
                                                if _e1080 {
                                                } else {
                                                    phi_4278_ = true;
                                                    break;
                                                }
                                                local_6[_e1079] = _e1057.member.member.y;
                                                if _e1080 {
                                                } else {
                                                    phi_4278_ = true;
                                                    break;
                                                }
                                                local_5[_e1079] = _e1057.member.member.z;
                                                if _e1080 {
                                                } else {
                                                    phi_4278_ = true;
                                                    break;
                                                }
                                                local_4[_e1079] = _e1057.member.member_1.x;
                                                if _e1080 {
                                                } else {
                                                    phi_4278_ = true;
                                                    break;
                                                }
                                                local_3[_e1079] = _e1057.member.member_1.y;
                                                if _e1080 {
                                                } else {
                                                    phi_4278_ = true;
                                                    break;
                                                }
                                                local_2[_e1079] = _e1057.member.member_1.z;
                                                if _e1080 {
                                                } else {
                                                    phi_4278_ = true;
                                                    break;
                                                }
                                                local_9[_e1079] = select(_e1046, _e1044, (_e1044 > _e1046));
                                                if _e1053 {
                                                    phi_3749_ = _e951.member_1;
                                                } else {
                                                    phi_3749_ = _e951.member_2;
                                                }
                                                let _e1093 = phi_3749_;
                                                phi_3750_ = _e1093;
                                                phi_3751_ = (_e631 + 1u);
                                            } else {
                                                phi_3750_ = type_60();
                                                phi_3751_ = u32();
                                            }
                                            let _e1095 = phi_3750_;
                                            let _e1097 = phi_3751_;
                                            phi_3753_ = _e1095;
                                            phi_3754_ = _e1097;
                                            phi_3755_ = select(true, false, _e1052);
                                        } else {
                                            phi_3753_ = type_60();
                                            phi_3754_ = u32();
                                            phi_3755_ = true;
                                        }
                                        let _e1100 = phi_3753_;
                                        let _e1102 = phi_3754_;
                                        let _e1104 = phi_3755_;
                                        if _e1104 {
                                            if _e1051 {
                                                phi_3764_ = _e951.member_1;
                                            } else {
                                                phi_3764_ = _e951.member_2;
                                            }
                                            let _e1108 = phi_3764_;
                                            phi_3769_ = _e1108;
                                            phi_3770_ = select(_e1052, true, _e1051);
                                        } else {
                                            phi_3769_ = _e1100;
                                            phi_3770_ = _e629;
                                        }
                                        let _e1111 = phi_3769_;
                                        let _e1113 = phi_3770_;
                                        phi_4282_ = _e586;
                                        phi_3772_ = _e588;
                                        phi_3773_ = _e1111;
                                        phi_3774_ = _e1113;
                                        phi_3775_ = select(_e1102, _e631, _e1104);
                                    }
                                    let _e1857 = phi_4282_;
                                    let _e1859 = phi_3772_;
                                    let _e1861 = phi_3773_;
                                    let _e1863 = phi_3774_;
                                    let _e1865 = phi_3775_;
                                    phi_4281_ = _e1857;
                                    phi_3776_ = _e1859;
                                    phi_3777_ = _e1861;
                                    phi_3778_ = (_e592 - 1u);
                                    phi_3779_ = _e1863;
                                    phi_3780_ = _e1865;
                                } else {
                                    phi_4281_ = _e586;
                                    phi_3776_ = _e588;
                                    phi_3777_ = _e627;
                                    phi_3778_ = _e592;
                                    phi_3779_ = _e629;
                                    phi_3780_ = _e631;
                                }
                                let _e1867 = phi_4281_;
                                let _e1869 = phi_3776_;
                                let _e1871 = phi_3777_;
                                let _e1873 = phi_3778_;
                                let _e1875 = phi_3779_;
                                let _e1877 = phi_3780_;
                                phi_4280_ = _e1867;
                                phi_3781_ = _e1869;
                                phi_3782_ = _e1871;
                                phi_3783_ = _e1873;
                                phi_3784_ = _e1875;
                                phi_3785_ = _e1877;
                            } else {
                                phi_4280_ = _e586;
                                phi_3781_ = type_43();
                                phi_3782_ = type_60();
                                phi_3783_ = u32();
                                phi_3784_ = bool();
                                phi_3785_ = u32();
                            }
                            let _e1879 = phi_4280_;
                            let _e1881 = phi_3781_;
                            let _e1883 = phi_3782_;
                            let _e1885 = phi_3783_;
                            let _e1887 = phi_3784_;
                            let _e1889 = phi_3785_;
                            phi_4279_ = _e1879;
                            phi_975_ = _e1881;
                            phi_978_ = _e1883;
                            phi_980_ = _e1885;
                            phi_982_ = _e1887;
                            phi_984_ = _e1889;
                            phi_3786_ = _e600;
                        } else {
                            phi_4279_ = _e586;
                            phi_975_ = type_43();
                            phi_978_ = type_60();
                            phi_980_ = u32();
                            phi_982_ = bool();
                            phi_984_ = u32();
                            phi_3786_ = false;
                        }
                        let _e1891 = phi_4279_;
                        let _e1893 = phi_975_;
                        let _e1895 = phi_978_;
                        let _e1897 = phi_980_;
                        let _e1899 = phi_982_;
                        let _e1901 = phi_984_;
                        let _e1903 = phi_3786_;
                        continue;
                        continuing {
                            phi_4140_ = _e1891;
                            phi_974_ = _e1893;
                            phi_977_ = _e1895;
                            phi_979_ = _e1897;
                            phi_981_ = _e1899;
                            phi_983_ = _e1901;
                            phi_4278_ = _e1891;
                            break if !(_e1903);
                        }
                    }
                    let _e1906 = phi_4278_;
                    if _e1906 {
                        break;
                    }
                    let _e1908 = local_13;
                    if (_e1908.member.member_3 != 4294967295u) {
                        let _e1913 = (_e368 / 3i);
                        let _e1920 = bitcast<f32>((bitcast<u32>((_e1913 + 127i)) << bitcast<u32>(23i)));
                        let _e1928 = (((_e1908.member.member * _e1920) * _e1920) * bitcast<f32>((bitcast<u32>(((_e368 - (2i * _e1913)) + 127i)) << bitcast<u32>(23i))));
                        let _e1930 = select(340282350000000000000000000000000000000f, _e1928, (_e1928 < 340282350000000000000000000000000000000f));
                        phi_3838_ = type_25(select(-340282350000000000000000000000000000000f, _e1930, (_e1930 > -340282350000000000000000000000000000000f)), _e1908.member.member_1, _e1908.member.member_2, _e1908.member.member_3);
                    } else {
                        phi_3838_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1937 = phi_3838_;
                    if _e245 {
                    } else {
                        break;
                    }
                    global_8.member[_e151] = _e1937;
                    if _e166 {
                    } else {
                        break;
                    }
                    let _e1941 = select(0u, 1u, (_e312 <= _e322));
                    if (_e1941 > 0u) {
                        let _e1943 = (1u < _e119);
                        if _e1943 {
                            if (0u < _e119) {
                            } else {
                                break;
                            }
                            let _e1947 = atomicAdd((&global_9.member[0u]), _e1941);
                            if ((_e1947 + _e1941) < _e1947) {
                                if _e1943 {
                                } else {
                                    break;
                                }
                                let _e1952 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1955 = select(0u, 1u, (_e1937.member_3 != 4294967295u));
                    if (_e1955 > 0u) {
                        let _e1957 = (3u < _e119);
                        if _e1957 {
                            if (2u < _e119) {
                            } else {
                                break;
                            }
                            let _e1961 = atomicAdd((&global_9.member[2u]), _e1955);
                            if ((_e1961 + _e1955) < _e1961) {
                                if _e1957 {
                                } else {
                                    break;
                                }
                                let _e1966 = atomicAdd((&global_9.member[3u]), 1u);
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
fn trace_paths_q10_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
