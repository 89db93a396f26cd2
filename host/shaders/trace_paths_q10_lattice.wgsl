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
    var phi_340_: u32;
    var phi_384_: i32;
    var phi_408_: type_40;
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
    var phi_973_: type_43;
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
    var phi_1100_: type_43;
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
    var phi_2008_: type_25;
    var phi_2010_: type_25;
    var phi_2011_: bool;
    var phi_2015_: type_25;
    var phi_2016_: type_25;
    var phi_2017_: type_25;
    var phi_2018_: bool;
    var phi_2022_: type_25;
    var phi_2023_: bool;
    var phi_2027_: type_25;
    var phi_2028_: bool;
    var phi_2032_: type_25;
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
    var phi_2387_: type_43;
    var phi_2388_: type_43;
    var phi_2389_: type_43;
    var phi_4057_: bool;
    var phi_1101_: type_43;
    var phi_4056_: bool;
    var phi_4139_: bool;
    var phi_3629_: type_43;
    var phi_3630_: type_60;
    var phi_3631_: bool;
    var phi_3632_: u32;
    var phi_4138_: bool;
    var phi_3633_: type_43;
    var phi_3634_: type_60;
    var phi_3635_: u32;
    var phi_3636_: bool;
    var phi_3637_: u32;
    var phi_4137_: bool;
    var phi_3638_: type_43;
    var phi_3639_: type_60;
    var phi_3640_: u32;
    var phi_3641_: bool;
    var phi_3642_: u32;
    var phi_4136_: bool;
    var phi_974_: type_43;
    var phi_977_: type_60;
    var phi_979_: u32;
    var phi_981_: bool;
    var phi_983_: u32;
    var phi_3643_: bool;
    var phi_4135_: bool;
    var local_13: type_43;
    var phi_3695_: type_25;
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
                phi_340_ = _e170;
            } else {
                phi_340_ = 4294967295u;
            }
            let _e172 = phi_340_;
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
                phi_384_ = -126i;
            } else {
                phi_384_ = select(_e215, 127i, (_e215 > 127i));
            }
            let _e220 = phi_384_;
            let _e225 = bitcast<f32>((bitcast<u32>((_e220 + 127i)) << bitcast<u32>(23i)));
            let _e231 = bitcast<f32>((bitcast<u32>(((_e215 - _e220) + 127i)) << bitcast<u32>(23i)));
            if (_e191 == 0u) {
                phi_408_ = type_40(array<f32, 3>(_e208, _e209, _e210), _e191, _e212, _e213);
            } else {
                phi_408_ = type_40(array<f32, 3>(((_e208 * _e225) * _e231), ((_e209 * _e225) * _e231), ((_e210 * _e225) * _e231)), _e191, ((_e212 * _e225) * _e231), _e213);
            }
            let _e244 = phi_408_;
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
                            phi_514_ = (bitcast<i32>((_e331 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_514_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e331)), 32u, (_e331 == 0u))));
                        }
                        let _e345 = phi_514_;
                        phi_515_ = _e345;
                    } else {
                        phi_515_ = 0i;
                    }
                    let _e347 = phi_515_;
                    let _e348 = (_e257 == _e301);
                    if _e348 {
                        phi_525_ = true;
                    } else {
                        phi_525_ = (_e265 == _e301);
                    }
                    let _e351 = phi_525_;
                    let _e352 = select(1u, 0u, _e348);
                    if _e351 {
                        let _e353 = (_e352 + 1u);
                        phi_535_ = _e353;
                        phi_536_ = _e353;
                        phi_538_ = select(true, false, (_e353 == 2u));
                    } else {
                        phi_535_ = u32();
                        phi_536_ = 0u;
                        phi_538_ = true;
                    }
                    let _e357 = phi_535_;
                    let _e359 = phi_536_;
                    let _e361 = phi_538_;
                    if _e361 {
                        phi_543_ = (_e359 + 1u);
                    } else {
                        phi_543_ = 0u;
                    }
                    let _e365 = phi_543_;
                    let _e366 = select(_e357, _e359, _e361);
                    let _e367 = select(_e352, select(2u, _e352, _e351), _e361);
                    let _e368 = -(_e347);
                    if (_e368 < -126i) {
                        phi_576_ = -126i;
                    } else {
                        phi_576_ = select(_e368, 127i, (_e368 > 127i));
                    }
                    let _e373 = phi_576_;
                    let _e378 = bitcast<f32>((bitcast<u32>((_e373 + 127i)) << bitcast<u32>(23i)));
                    let _e384 = bitcast<f32>((bitcast<u32>(((_e368 - _e373) + 127i)) << bitcast<u32>(23i)));
                    let _e389 = global_7.member[_e151].member.member;
                    let _e390 = (_e366 == 0u);
                    if _e390 {
                        phi_594_ = _e389[0];
                    } else {
                        phi_594_ = _e389[1];
                    }
                    let _e394 = phi_594_;
                    let _e395 = (_e366 == 2u);
                    if _e395 {
                        phi_600_ = _e389[2];
                    } else {
                        phi_600_ = _e394;
                    }
                    let _e398 = phi_600_;
                    let _e399 = global_7.member[_e151].member.member_2;
                    if _e390 {
                        phi_611_ = _e399[0];
                    } else {
                        phi_611_ = _e399[1];
                    }
                    let _e403 = phi_611_;
                    if _e395 {
                        phi_617_ = _e399[2];
                    } else {
                        phi_617_ = _e403;
                    }
                    let _e406 = phi_617_;
                    let _e408 = ((_e406 * _e378) * _e384);
                    let _e412 = (bitcast<f32>((bitcast<u32>(_e408) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e412 {
                        let _e416 = (bitcast<f32>((bitcast<u32>(_e398) & 2147483647u)) * 0.00000011920929f);
                        phi_640_ = select(0.00000000000011368684f, _e416, (_e416 > 0.00000000000011368684f));
                    } else {
                        phi_640_ = 0f;
                    }
                    let _e420 = phi_640_;
                    let _e421 = (_e398 + _e420);
                    let _e422 = (_e398 - _e420);
                    let _e423 = select(_e408, 0f, _e412);
                    if _e412 {
                        phi_651_ = 38685626000000000000000000f;
                    } else {
                        phi_651_ = (1f / _e408);
                    }
                    let _e426 = phi_651_;
                    let _e427 = (_e365 == 0u);
                    if _e427 {
                        phi_660_ = _e389[0];
                    } else {
                        phi_660_ = _e389[1];
                    }
                    let _e431 = phi_660_;
                    let _e432 = (_e365 == 2u);
                    if _e432 {
                        phi_666_ = _e389[2];
                    } else {
                        phi_666_ = _e431;
                    }
                    let _e435 = phi_666_;
                    if _e427 {
                        phi_677_ = _e399[0];
                    } else {
                        phi_677_ = _e399[1];
                    }
                    let _e439 = phi_677_;
                    if _e432 {
                        phi_683_ = _e399[2];
                    } else {
                        phi_683_ = _e439;
                    }
                    let _e442 = phi_683_;
                    let _e444 = ((_e442 * _e378) * _e384);
                    let _e448 = (bitcast<f32>((bitcast<u32>(_e444) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e448 {
                        let _e452 = (bitcast<f32>((bitcast<u32>(_e435) & 2147483647u)) * 0.00000011920929f);
                        phi_706_ = select(0.00000000000011368684f, _e452, (_e452 > 0.00000000000011368684f));
                    } else {
                        phi_706_ = 0f;
                    }
                    let _e456 = phi_706_;
                    let _e457 = (_e435 + _e456);
                    let _e458 = (_e435 - _e456);
                    let _e459 = select(_e444, 0f, _e448);
                    if _e448 {
                        phi_717_ = 38685626000000000000000000f;
                    } else {
                        phi_717_ = (1f / _e444);
                    }
                    let _e462 = phi_717_;
                    let _e463 = (_e367 == 0u);
                    if _e463 {
                        phi_726_ = _e389[0];
                    } else {
                        phi_726_ = _e389[1];
                    }
                    let _e467 = phi_726_;
                    let _e468 = (_e367 == 2u);
                    if _e468 {
                        phi_732_ = _e389[2];
                    } else {
                        phi_732_ = _e467;
                    }
                    let _e471 = phi_732_;
                    if _e463 {
                        phi_743_ = _e399[0];
                    } else {
                        phi_743_ = _e399[1];
                    }
                    let _e475 = phi_743_;
                    if _e468 {
                        phi_749_ = _e399[2];
                    } else {
                        phi_749_ = _e475;
                    }
                    let _e478 = phi_749_;
                    let _e480 = ((_e478 * _e378) * _e384);
                    let _e484 = (bitcast<f32>((bitcast<u32>(_e480) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e484 {
                        let _e488 = (bitcast<f32>((bitcast<u32>(_e471) & 2147483647u)) * 0.00000011920929f);
                        phi_772_ = select(0.00000000000011368684f, _e488, (_e488 > 0.00000000000011368684f));
                    } else {
                        phi_772_ = 0f;
                    }
                    let _e492 = phi_772_;
                    let _e493 = (_e471 + _e492);
                    let _e494 = (_e471 - _e492);
                    let _e495 = select(_e480, 0f, _e484);
                    if _e484 {
                        phi_783_ = 38685626000000000000000000f;
                    } else {
                        phi_783_ = (1f / _e480);
                    }
                    let _e498 = phi_783_;
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
                        phi_883_ = select(-340282350000000000000000000000000000000f, _e538, (_e538 > -340282350000000000000000000000000000000f));
                        phi_884_ = select(-340282350000000000000000000000000000000f, _e531, (_e531 > -340282350000000000000000000000000000000f));
                    } else {
                        phi_883_ = 0f;
                        phi_884_ = 1f;
                    }
                    let _e542 = phi_883_;
                    let _e544 = phi_884_;
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
                    phi_3997_ = false;
                    phi_973_ = type_43(type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e542);
                    phi_976_ = type_60(type_37(vec4<f32>((f32(_e551) * _e163), (f32(_e557) * _e163), (f32(_e563) * _e163), 0f), vec4<f32>((f32(_e568) * _e163), (f32(_e572) * _e163), (f32(_e576) * _e163), 0f)), select(0u, 2147483648u, (_e104 == 0u)));
                    phi_978_ = ((3u * _e104) + 1u);
                    phi_980_ = (_e544 <= _e542);
                    phi_982_ = 0u;
                    loop {
                        let _e586 = phi_3997_;
                        let _e588 = phi_973_;
                        let _e590 = phi_976_;
                        let _e592 = phi_978_;
                        let _e594 = phi_980_;
                        let _e596 = phi_982_;
                        local_13 = _e588;
                        if _e594 {
                            phi_993_ = true;
                        } else {
                            phi_993_ = (_e596 > 0u);
                        }
                        let _e599 = phi_993_;
                        if _e599 {
                            let _e600 = (_e592 > 0u);
                            if _e600 {
                                if _e594 {
                                    phi_1079_ = _e590;
                                    phi_1080_ = _e594;
                                    phi_1081_ = _e596;
                                } else {
                                    let _e601 = (_e596 - 1u);
                                    let _e602 = (_e601 % 128u);
                                    let _e603 = (_e602 < 128u);
                                    if _e603 {
                                    } else {
                                        phi_4135_ = true;
                                        break;
                                    }
                                    let _e605 = local_7[_e602];
                                    if _e603 {
                                    } else {
                                        phi_4135_ = true;
                                        break;
                                    }
                                    let _e607 = local_6[_e602];
                                    if _e603 {
                                    } else {
                                        phi_4135_ = true;
                                        break;
                                    }
                                    let _e609 = local_5[_e602];
                                    if _e603 {
                                    } else {
                                        phi_4135_ = true;
                                        break;
                                    }
                                    let _e611 = local_4[_e602];
                                    if _e603 {
                                    } else {
                                        phi_4135_ = true;
                                        break;
                                    }
                                    let _e613 = local_3[_e602];
                                    if _e603 {
                                    } else {
                                        phi_4135_ = true;
                                        break;
                                    }
                                    let _e615 = local_2[_e602];
                                    if _e603 {
                                    } else {
                                        phi_4135_ = true;
                                        break;
                                    }
                                    let _e620 = local_8[_e602];
                                    if _e603 {
                                    } else {
                                        phi_4135_ = true;
                                        break;
                                    }
                                    let _e623 = local_9[_e602];
                                    phi_1079_ = type_60(type_37(vec4<f32>(_e605, _e607, _e609, 0f), vec4<f32>(_e611, _e613, _e615, 0f)), _e620);
                                    phi_1080_ = (_e623 <= _e588.member_1);
                                    phi_1081_ = _e601;
                                }
                                let _e627 = phi_1079_;
                                let _e629 = phi_1080_;
                                let _e631 = phi_1081_;
                                if _e629 {
                                    let _e636 = (_e627.member_1 & 268435455u);
                                    if ((_e627.member_1 & 2147483648u) != 0u) {
                                        phi_3994_ = _e586;
                                        phi_1100_ = _e588;
                                        phi_1103_ = type_8(0u, ((_e627.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1096 = phi_3994_;
                                            let _e1098 = phi_1100_;
                                            let _e1100 = phi_1103_;
                                            local_14 = _e1098;
                                            if (_e1100.member < _e1100.member_1) {
                                                phi_1104_ = type_8((_e1100.member + 1u), _e1100.member_1);
                                                phi_1126_ = type_8(1u, _e1100.member);
                                            } else {
                                                phi_1104_ = _e1100;
                                                phi_1126_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1113 = phi_1104_;
                                            let _e1115 = phi_1126_;
                                            let _e1119 = (bitcast<i32>(_e1115.member) != 0i);
                                            if _e1119 {
                                                let _e1124 = (_e627.member.member_1.x - _e627.member.member.x);
                                                let _e1127 = (_e627.member.member_1.y - _e627.member.member.y);
                                                let _e1130 = (_e627.member.member_1.z - _e627.member.member.z);
                                                let _e1132 = select(_e1127, _e1124, (_e1124 > _e1127));
                                                let _e1134 = select(_e1130, _e1132, (_e1132 > _e1130));
                                                let _e1136 = (_e1134 < (1024f * _e163));
                                                if _e1136 {
                                                    phi_1167_ = 0u;
                                                } else {
                                                    phi_1167_ = select(2u, 1u, (_e1134 < (2097152f * _e163)));
                                                }
                                                let _e1141 = phi_1167_;
                                                switch bitcast<i32>(_e1141) {
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
                                                let _e1144 = phi_1173_;
                                                switch bitcast<i32>(_e1141) {
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
                                                let _e1151 = phi_1183_;
                                                let _e1153 = ((_e636 + (_e1115.member_1 * ((3u * _e1144) + 1u))) + (3u * _e1151));
                                                let _e1154 = (_e1153 < _e107);
                                                if _e1154 {
                                                    if _e1154 {
                                                    } else {
                                                        phi_4056_ = true;
                                                        break;
                                                    }
                                                    let _e1156 = global_10.member[_e1153];
                                                    phi_1199_ = _e1156;
                                                } else {
                                                    phi_1199_ = 4294967295u;
                                                }
                                                let _e1158 = phi_1199_;
                                                local_10 = array<u32, 3>(_e366, _e365, _e367);
                                                if _e1136 {
                                                    phi_1236_ = 0u;
                                                } else {
                                                    phi_1236_ = select(2u, 1u, (_e1134 < (2097152f * _e163)));
                                                }
                                                let _e1164 = phi_1236_;
                                                switch bitcast<i32>(_e1164) {
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
                                                let _e1167 = phi_1242_;
                                                switch bitcast<i32>(_e1164) {
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
                                                let _e1174 = phi_1252_;
                                                local_12 = array<f32, 4>(_e627.member.member.x, _e627.member.member.y, _e627.member.member.z, _e627.member.member.w);
                                                local_11[0u] = array<f32, 3>(0f, 0f, 0f);
                                                local_11[1u] = array<f32, 3>(0f, 0f, 0f);
                                                local_11[2u] = array<f32, 3>(0f, 0f, 0f);
                                                phi_3979_ = _e1096;
                                                phi_1268_ = type_8(0u, 3u);
                                                loop {
                                                    let _e1188 = phi_3979_;
                                                    let _e1190 = phi_1268_;
                                                    if (_e1190.member < _e1190.member_1) {
                                                        phi_1269_ = type_8((_e1190.member + 1u), _e1190.member_1);
                                                        phi_1292_ = type_8(1u, _e1190.member);
                                                    } else {
                                                        phi_1269_ = _e1190;
                                                        phi_1292_ = type_8(0u, type_8().member_1);
                                                    }
                                                    let _e1203 = phi_1269_;
                                                    let _e1205 = phi_1292_;
                                                    let _e1209 = (bitcast<i32>(_e1205.member) != 0i);
                                                    if _e1209 {
                                                        let _e1211 = ((_e636 + (_e1115.member_1 * ((3u * _e1167) + 1u))) + (_e1205.member_1 * _e1174));
                                                        let _e1212 = (_e1211 < _e107);
                                                        if _e1212 {
                                                            if _e1212 {
                                                            } else {
                                                                phi_4054_ = true;
                                                                break;
                                                            }
                                                            let _e1214 = global_10.member[_e1211];
                                                            phi_1315_ = _e1214;
                                                        } else {
                                                            phi_1315_ = 0u;
                                                        }
                                                        let _e1216 = phi_1315_;
                                                        let _e1217 = (_e1211 + 1u);
                                                        let _e1218 = (_e1217 < _e107);
                                                        if _e1218 {
                                                            if _e1218 {
                                                            } else {
                                                                phi_4054_ = true;
                                                                break;
                                                            }
                                                            let _e1220 = global_10.member[_e1217];
                                                            phi_1330_ = _e1220;
                                                        } else {
                                                            phi_1330_ = 0u;
                                                        }
                                                        let _e1222 = phi_1330_;
                                                        phi_1333_ = type_8(0u, 3u);
                                                        loop {
                                                            let _e1224 = phi_1333_;
                                                            if (_e1224.member < _e1224.member_1) {
                                                                phi_1334_ = type_8((_e1224.member + 1u), _e1224.member_1);
                                                                phi_1357_ = type_8(1u, _e1224.member);
                                                            } else {
                                                                phi_1334_ = _e1224;
                                                                phi_1357_ = type_8(0u, type_8().member_1);
                                                            }
                                                            let _e1237 = phi_1334_;
                                                            let _e1239 = phi_1357_;
                                                            let _e1243 = (bitcast<i32>(_e1239.member) != 0i);
                                                            if _e1243 {
                                                                let _e1244 = (_e1239.member_1 < 3u);
                                                                if _e1244 {
                                                                } else {
                                                                    phi_3972_ = true;
                                                                    break;
                                                                }
                                                                let _e1246 = local_10[_e1239.member_1];
                                                                if (_e1239.member_1 < 4u) {
                                                                } else {
                                                                    phi_3972_ = true;
                                                                    break;
                                                                }
                                                                let _e1249 = local_12[_e1239.member_1];
                                                                switch bitcast<i32>(_e1164) {
                                                                    case 0: {
                                                                        phi_1427_ = (_e1249 + (f32(((_e1216 >> bitcast<u32>(((10u * _e1246) & 31u))) & 1023u)) * _e163));
                                                                        break;
                                                                    }
                                                                    case 1: {
                                                                        if (_e1246 == 0u) {
                                                                            phi_1404_ = _e1216;
                                                                        } else {
                                                                            if (_e1246 == 1u) {
                                                                                phi_1403_ = ((_e1216 >> bitcast<u32>(21i)) | (_e1222 << bitcast<u32>(11i)));
                                                                            } else {
                                                                                phi_1403_ = (_e1222 >> bitcast<u32>(10i));
                                                                            }
                                                                            let _e1270 = phi_1403_;
                                                                            phi_1404_ = _e1270;
                                                                        }
                                                                        let _e1272 = phi_1404_;
                                                                        phi_1427_ = (_e1249 + (f32((_e1272 & 2097151u)) * _e163));
                                                                        break;
                                                                    }
                                                                    case 2: {
                                                                        let _e1251 = (_e1211 + _e1246);
                                                                        let _e1252 = (_e1251 < _e107);
                                                                        if _e1252 {
                                                                            if _e1252 {
                                                                            } else {
                                                                                phi_3972_ = true;
                                                                                break;
                                                                            }
                                                                            let _e1254 = global_10.member[_e1251];
                                                                            phi_1423_ = _e1254;
                                                                        } else {
                                                                            phi_1423_ = 0u;
                                                                        }
                                                                        let _e1256 = phi_1423_;
                                                                        phi_1427_ = (f32(bitcast<i32>(_e1256)) * _e163);
                                                                        break;
                                                                    }
                                                                    default: {
                                                                        phi_1427_ = f32();
                                                                        break;
                                                                    }
                                                                }
                                                                let _e1286 = phi_1427_;
                                                                if (_e1205.member_1 < 3u) {
                                                                } else {
                                                                    phi_3972_ = true;
                                                                    break;
                                                                }
                                                                if _e1244 {
                                                                } else {
                                                                    phi_3972_ = true;
                                                                    break;
                                                                }
                                                                local_11[_e1205.member_1][_e1239.member_1] = _e1286;
                                                            }
                                                            continue;
                                                            continuing {
                                                                phi_1333_ = _e1237;
                                                                phi_3972_ = _e1188;
                                                                break if !(_e1243);
                                                            }
                                                        }
                                                        let _e1292 = phi_3972_;
                                                        phi_4054_ = _e1292;
                                                        if _e1292 {
                                                            break;
                                                        }
                                                        phi_4055_ = _e1292;
                                                    } else {
                                                        phi_4055_ = _e1188;
                                                    }
                                                    let _e1294 = phi_4055_;
                                                    continue;
                                                    continuing {
                                                        phi_3979_ = _e1294;
                                                        phi_1268_ = _e1203;
                                                        phi_4054_ = _e1294;
                                                        break if !(_e1209);
                                                    }
                                                }
                                                let _e1297 = phi_4054_;
                                                phi_4056_ = _e1297;
                                                if _e1297 {
                                                    break;
                                                }
                                                let _e1298 = local_11;
                                                let _e1314 = (_e1298[0][2] - _e471);
                                                let _e1317 = (((_e1298[0][0] - _e398) * _e495) - (_e1314 * _e423));
                                                let _e1320 = (((_e1298[0][1] - _e435) * _e495) - (_e1314 * _e459));
                                                let _e1323 = (_e1298[1][2] - _e471);
                                                let _e1326 = (((_e1298[1][0] - _e398) * _e495) - (_e1323 * _e423));
                                                let _e1329 = (((_e1298[1][1] - _e435) * _e495) - (_e1323 * _e459));
                                                let _e1332 = (_e1298[2][2] - _e471);
                                                let _e1335 = (((_e1298[2][0] - _e398) * _e495) - (_e1332 * _e423));
                                                let _e1338 = (((_e1298[2][1] - _e435) * _e495) - (_e1332 * _e459));
                                                let _e1339 = (_e1335 * _e1329);
                                                let _e1340 = (_e1338 * _e1326);
                                                let _e1341 = (_e1317 * _e1338);
                                                let _e1342 = (_e1320 * _e1335);
                                                let _e1343 = (_e1326 * _e1320);
                                                let _e1344 = (_e1329 * _e1317);
                                                let _e1349 = (((_e1339 >= _e1340) && (_e1341 >= _e1342)) && (_e1343 >= _e1344));
                                                if (_e1349 || (((_e1339 <= _e1340) && (_e1341 <= _e1342)) && (_e1343 <= _e1344))) {
                                                    let _e1356 = select(-1f, 1f, _e1349);
                                                    let _e1358 = ((_e1339 - _e1340) * _e1356);
                                                    let _e1360 = select(0f, _e1358, (_e1358 > 0f));
                                                    let _e1362 = ((_e1341 - _e1342) * _e1356);
                                                    let _e1364 = select(0f, _e1362, (_e1362 > 0f));
                                                    let _e1366 = ((_e1343 - _e1344) * _e1356);
                                                    let _e1368 = select(0f, _e1366, (_e1366 > 0f));
                                                    let _e1370 = ((_e1360 + _e1364) + _e1368);
                                                    if (_e1370 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2022_ = type_25();
                                                        phi_2023_ = true;
                                                    } else {
                                                        let _e1373 = select(_e1298[1][0], _e1298[0][0], (_e1298[0][0] < _e1298[1][0]));
                                                        let _e1377 = select(_e1298[1][0], _e1298[0][0], (_e1298[0][0] > _e1298[1][0]));
                                                        let _e1381 = select(_e1298[1][1], _e1298[0][1], (_e1298[0][1] < _e1298[1][1]));
                                                        let _e1385 = select(_e1298[1][1], _e1298[0][1], (_e1298[0][1] > _e1298[1][1]));
                                                        let _e1389 = select(_e1298[1][2], _e1298[0][2], (_e1298[0][2] < _e1298[1][2]));
                                                        let _e1393 = select(_e1298[1][2], _e1298[0][2], (_e1298[0][2] > _e1298[1][2]));
                                                        let _e1398 = ((select(_e1298[2][0], _e1373, (_e1373 < _e1298[2][0])) - _e421) * _e426);
                                                        let _e1399 = ((select(_e1298[2][0], _e1377, (_e1377 > _e1298[2][0])) - _e422) * _e426);
                                                        let _e1402 = ((select(_e1298[2][1], _e1381, (_e1381 < _e1298[2][1])) - _e457) * _e462);
                                                        let _e1403 = ((select(_e1298[2][1], _e1385, (_e1385 > _e1298[2][1])) - _e458) * _e462);
                                                        let _e1406 = ((select(_e1298[2][2], _e1389, (_e1389 < _e1298[2][2])) - _e493) * _e498);
                                                        let _e1407 = ((select(_e1298[2][2], _e1393, (_e1393 > _e1298[2][2])) - _e494) * _e498);
                                                        let _e1409 = select(_e1407, _e1406, (_e1406 < _e1407));
                                                        let _e1411 = select(_e1407, _e1406, (_e1406 > _e1407));
                                                        let _e1413 = select(_e1399, _e1398, (_e1398 < _e1399));
                                                        let _e1415 = select(_e1403, _e1402, (_e1402 < _e1403));
                                                        let _e1417 = select(_e1415, _e1413, (_e1413 > _e1415));
                                                        let _e1419 = select(_e1409, _e1417, (_e1417 > _e1409));
                                                        let _e1421 = select(_e1399, _e1398, (_e1398 > _e1399));
                                                        let _e1423 = select(_e1403, _e1402, (_e1402 > _e1403));
                                                        let _e1425 = select(_e1423, _e1421, (_e1421 < _e1423));
                                                        let _e1427 = select(_e1411, _e1425, (_e1425 < _e1411));
                                                        let _e1428 = -(_e1409);
                                                        let _e1434 = select(_e544, _e1419, (_e1419 > _e544));
                                                        if (_e1434 > (_e1427 + (select(_e1428, _e1411, (_e1411 > _e1428)) * 0.0000019073523f))) {
                                                            phi_2017_ = type_25();
                                                            phi_2018_ = true;
                                                        } else {
                                                            let _e1436 = (_e1434 > _e1098.member_1);
                                                            if _e1436 {
                                                                phi_2016_ = type_25();
                                                            } else {
                                                                let _e1440 = (_e1298[1][0] - _e1298[0][0]);
                                                                let _e1441 = (_e1298[1][1] - _e1298[0][1]);
                                                                let _e1442 = (_e1298[1][2] - _e1298[0][2]);
                                                                let _e1443 = vec3<f32>(_e1440, _e1441, _e1442);
                                                                let _e1444 = (_e1298[2][0] - _e1298[1][0]);
                                                                let _e1445 = (_e1298[2][1] - _e1298[1][1]);
                                                                let _e1446 = (_e1298[2][2] - _e1298[1][2]);
                                                                let _e1447 = vec3<f32>(_e1444, _e1445, _e1446);
                                                                let _e1448 = (_e1298[0][0] - _e1298[2][0]);
                                                                let _e1449 = (_e1298[0][1] - _e1298[2][1]);
                                                                let _e1450 = (_e1298[0][2] - _e1298[2][2]);
                                                                let _e1451 = vec3<f32>(_e1448, _e1449, _e1450);
                                                                let _e1454 = bitcast<f32>((bitcast<u32>(_e1440) & 2147483647u));
                                                                let _e1457 = bitcast<f32>((bitcast<u32>(_e1441) & 2147483647u));
                                                                let _e1459 = select(_e1457, _e1454, (_e1454 > _e1457));
                                                                let _e1462 = bitcast<f32>((bitcast<u32>(_e1442) & 2147483647u));
                                                                let _e1464 = select(_e1462, _e1459, (_e1459 > _e1462));
                                                                let _e1467 = bitcast<f32>((bitcast<u32>(_e1444) & 2147483647u));
                                                                let _e1470 = bitcast<f32>((bitcast<u32>(_e1445) & 2147483647u));
                                                                let _e1472 = select(_e1470, _e1467, (_e1467 > _e1470));
                                                                let _e1475 = bitcast<f32>((bitcast<u32>(_e1446) & 2147483647u));
                                                                let _e1477 = select(_e1475, _e1472, (_e1472 > _e1475));
                                                                let _e1480 = bitcast<f32>((bitcast<u32>(_e1448) & 2147483647u));
                                                                let _e1483 = bitcast<f32>((bitcast<u32>(_e1449) & 2147483647u));
                                                                let _e1485 = select(_e1483, _e1480, (_e1480 > _e1483));
                                                                let _e1488 = bitcast<f32>((bitcast<u32>(_e1450) & 2147483647u));
                                                                let _e1490 = select(_e1488, _e1485, (_e1485 > _e1488));
                                                                let _e1492 = select(_e1477, _e1464, (_e1464 > _e1477));
                                                                let _e1494 = select(_e1490, _e1492, (_e1492 > _e1490));
                                                                if (_e1464 == _e1494) {
                                                                    phi_1927_ = _e1447;
                                                                    phi_1928_ = _e1451;
                                                                } else {
                                                                    let _e1497 = vec3((_e1477 == _e1494));
                                                                    phi_1927_ = select(_e1443, _e1451, _e1497);
                                                                    phi_1928_ = select(_e1447, _e1443, _e1497);
                                                                }
                                                                let _e1501 = phi_1927_;
                                                                let _e1503 = phi_1928_;
                                                                let _e1510 = ((_e1501.y * _e1503.z) - (_e1503.y * _e1501.z));
                                                                let _e1515 = ((_e1501.z * _e1503.x) - (_e1503.z * _e1501.x));
                                                                let _e1518 = ((_e1501.x * _e1503.y) - (_e1503.x * _e1501.y));
                                                                if (_e1360 >= _e1364) {
                                                                    phi_1959_ = select(true, false, (_e1360 >= _e1368));
                                                                } else {
                                                                    phi_1959_ = true;
                                                                }
                                                                let _e1523 = phi_1959_;
                                                                if _e1523 {
                                                                    phi_1968_ = select(vec3<f32>(_e1298[2][0], _e1298[2][1], _e1298[2][2]), vec3<f32>(_e1298[1][0], _e1298[1][1], _e1298[1][2]), vec3((_e1364 >= _e1368)));
                                                                } else {
                                                                    phi_1968_ = vec3<f32>(_e1298[0][0], _e1298[0][1], _e1298[0][2]);
                                                                }
                                                                let _e1528 = phi_1968_;
                                                                let _e1545 = ((((_e1510 * (_e1528.x - _e398)) + (_e1515 * (_e1528.y - _e435))) + (_e1518 * (_e1528.z - _e471))) / (((_e1510 * _e423) + (_e1515 * _e459)) + (_e1518 * _e495)));
                                                                let _e1547 = select(_e1427, _e1545, (_e1545 < _e1427));
                                                                let _e1549 = select(_e1419, _e1547, (_e1547 > _e1419));
                                                                if (_e1549 >= _e544) {
                                                                    let _e1551 = (_e1549 <= _e1098.member_1);
                                                                    if _e1551 {
                                                                        let _e1552 = (1f / _e1370);
                                                                        phi_2008_ = type_25(_e1549, (_e1364 * _e1552), (_e1368 * _e1552), _e1158);
                                                                    } else {
                                                                        phi_2008_ = type_25();
                                                                    }
                                                                    let _e1557 = phi_2008_;
                                                                    phi_2010_ = _e1557;
                                                                    phi_2011_ = select(true, false, _e1551);
                                                                } else {
                                                                    phi_2010_ = type_25();
                                                                    phi_2011_ = true;
                                                                }
                                                                let _e1560 = phi_2010_;
                                                                let _e1562 = phi_2011_;
                                                                if _e1562 {
                                                                    phi_2015_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                } else {
                                                                    phi_2015_ = _e1560;
                                                                }
                                                                let _e1564 = phi_2015_;
                                                                phi_2016_ = _e1564;
                                                            }
                                                            let _e1566 = phi_2016_;
                                                            phi_2017_ = _e1566;
                                                            phi_2018_ = _e1436;
                                                        }
                                                        let _e1568 = phi_2017_;
                                                        let _e1570 = phi_2018_;
                                                        phi_2022_ = _e1568;
                                                        phi_2023_ = _e1570;
                                                    }
                                                    let _e1572 = phi_2022_;
                                                    let _e1574 = phi_2023_;
                                                    phi_2027_ = _e1572;
                                                    phi_2028_ = _e1574;
                                                } else {
                                                    phi_2027_ = type_25();
                                                    phi_2028_ = true;
                                                }
                                                let _e1576 = phi_2027_;
                                                let _e1578 = phi_2028_;
                                                if _e1578 {
                                                    phi_2032_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2032_ = _e1576;
                                                }
                                                let _e1580 = phi_2032_;
                                                if (_e1580.member_3 != 4294967295u) {
                                                    if (_e1158 == _e172) {
                                                        phi_2361_ = false;
                                                    } else {
                                                        let _e1584 = (_e1158 < arrayLength((&global_5.member)));
                                                        if _e1584 {
                                                            if _e1584 {
                                                            } else {
                                                                phi_4056_ = true;
                                                                break;
                                                            }
                                                            let _e1586 = global_5.member[_e1158];
                                                            phi_2055_ = _e1586;
                                                        } else {
                                                            phi_2055_ = 4294967295u;
                                                        }
                                                        let _e1588 = phi_2055_;
                                                        let _e1589 = (_e1588 < arrayLength((&global_6.member)));
                                                        if _e1589 {
                                                            if _e1589 {
                                                            } else {
                                                                phi_4056_ = true;
                                                                break;
                                                            }
                                                            let _e1591 = global_6.member[_e1588];
                                                            phi_2069_ = _e1591;
                                                        } else {
                                                            phi_2069_ = 0i;
                                                        }
                                                        let _e1593 = phi_2069_;
                                                        let _e1594 = (_e1593 == 0i);
                                                        if _e1594 {
                                                            phi_2360_ = true;
                                                        } else {
                                                            if _e390 {
                                                                phi_2090_ = vec3<f32>(_e1298[0][0], _e1298[0][1], _e1298[0][2]);
                                                            } else {
                                                                if (_e366 == 1u) {
                                                                    phi_2089_ = vec3<f32>(_e1298[0][2], _e1298[0][0], _e1298[0][1]);
                                                                } else {
                                                                    phi_2089_ = vec3<f32>(_e1298[0][1], _e1298[0][2], _e1298[0][0]);
                                                                }
                                                                let _e1599 = phi_2089_;
                                                                phi_2090_ = _e1599;
                                                            }
                                                            let _e1602 = phi_2090_;
                                                            if _e390 {
                                                                phi_2107_ = vec3<f32>(_e1298[1][0], _e1298[1][1], _e1298[1][2]);
                                                            } else {
                                                                if (_e366 == 1u) {
                                                                    phi_2106_ = vec3<f32>(_e1298[1][2], _e1298[1][0], _e1298[1][1]);
                                                                } else {
                                                                    phi_2106_ = vec3<f32>(_e1298[1][1], _e1298[1][2], _e1298[1][0]);
                                                                }
                                                                let _e1607 = phi_2106_;
                                                                phi_2107_ = _e1607;
                                                            }
                                                            let _e1610 = phi_2107_;
                                                            if _e390 {
                                                                phi_2124_ = vec3<f32>(_e1298[2][0], _e1298[2][1], _e1298[2][2]);
                                                            } else {
                                                                if (_e366 == 1u) {
                                                                    phi_2123_ = vec3<f32>(_e1298[2][2], _e1298[2][0], _e1298[2][1]);
                                                                } else {
                                                                    phi_2123_ = vec3<f32>(_e1298[2][1], _e1298[2][2], _e1298[2][0]);
                                                                }
                                                                let _e1615 = phi_2123_;
                                                                phi_2124_ = _e1615;
                                                            }
                                                            let _e1618 = phi_2124_;
                                                            let _e1621 = (_e1610.x - _e1602.x);
                                                            let _e1624 = (_e1610.y - _e1602.y);
                                                            let _e1627 = (_e1610.z - _e1602.z);
                                                            let _e1629 = (_e1618.x - _e1602.x);
                                                            let _e1631 = (_e1618.y - _e1602.y);
                                                            let _e1633 = (_e1618.z - _e1602.z);
                                                            if (_e244.member_1 == 1u) {
                                                                phi_2160_ = (vec3<f32>(_e244.member[0], _e244.member[1], _e244.member[2]) - _e1602);
                                                            } else {
                                                                phi_2160_ = vec3<f32>(_e244.member[0], _e244.member[1], _e244.member[2]);
                                                            }
                                                            let _e1648 = phi_2160_;
                                                            let _e1654 = bitcast<f32>((bitcast<u32>((_e1621 * _e1631)) ^ _e244.member_3[0]));
                                                            let _e1658 = bitcast<f32>((bitcast<u32>((_e1624 * _e1629)) ^ _e244.member_3[0]));
                                                            let _e1662 = bitcast<f32>((bitcast<u32>((_e1624 * _e1633)) ^ _e244.member_3[0]));
                                                            let _e1666 = bitcast<f32>((bitcast<u32>((_e1627 * _e1631)) ^ _e244.member_3[0]));
                                                            let _e1670 = bitcast<f32>((bitcast<u32>((_e1627 * _e1629)) ^ _e244.member_3[0]));
                                                            let _e1674 = bitcast<f32>((bitcast<u32>((_e1621 * _e1633)) ^ _e244.member_3[0]));
                                                            let _e1675 = (_e1662 - _e1666);
                                                            let _e1676 = (_e1670 - _e1674);
                                                            let _e1677 = (_e1654 - _e1658);
                                                            let _e1701 = (bitcast<f32>((bitcast<u32>(_e1662) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1666) & 2147483647u)));
                                                            let _e1708 = (bitcast<f32>((bitcast<u32>(_e1670) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1674) & 2147483647u)));
                                                            let _e1715 = (bitcast<f32>((bitcast<u32>(_e1654) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1658) & 2147483647u)));
                                                            if (_e244.member_2 == 0f) {
                                                                phi_2342_ = 0f;
                                                            } else {
                                                                let _e1745 = bitcast<f32>((bitcast<u32>(_e1675) & 2147483647u));
                                                                let _e1748 = bitcast<f32>((bitcast<u32>(_e1676) & 2147483647u));
                                                                let _e1751 = bitcast<f32>((bitcast<u32>(_e1677) & 2147483647u));
                                                                let _e1753 = select(_e1751, _e1748, (_e1748 > _e1751));
                                                                let _e1757 = select(_e1751, _e1748, (_e1748 < _e1751));
                                                                let _e1761 = select(_e1748, _e1745, (_e1745 < _e1748));
                                                                let _e1763 = select(_e1748, _e1745, (_e1745 > _e1748));
                                                                let _e1765 = select(_e1751, _e1763, (_e1763 < _e1751));
                                                                phi_2342_ = bitcast<f32>((bitcast<u32>((_e244.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1753, _e1745, (_e1745 > _e1753)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1765, _e1761, (_e1761 > _e1765)))) ^ _e244.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1757, _e1745, (_e1745 < _e1757)))) ^ _e244.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1701 + _e1708) + _e1715))) ^ _e244.member_3[0]))) * 1.0000005f)) ^ _e244.member_3[0])))) ^ _e244.member_3[0]));
                                                            }
                                                            let _e1792 = phi_2342_;
                                                            phi_2360_ = (_e1594 || !(((((bitcast<f32>((bitcast<u32>((_e1648.x * _e1675)) ^ _e244.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1648.y * _e1676)) ^ _e244.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1648.z * _e1677)) ^ _e244.member_3[0]))) * f32(-(_e1593))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1648.x) & 2147483647u)) * _e1701)) ^ _e244.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1648.y) & 2147483647u)) * _e1708)) ^ _e244.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1648.z) & 2147483647u)) * _e1715)) ^ _e244.member_3[0]))))) ^ _e244.member_3[0])) + _e1792) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1806 = phi_2360_;
                                                        phi_2361_ = _e1806;
                                                    }
                                                    let _e1808 = phi_2361_;
                                                    if _e1808 {
                                                        if (_e1580.member < _e1098.member.member) {
                                                            phi_2381_ = true;
                                                        } else {
                                                            if (_e1580.member == _e1098.member.member) {
                                                                phi_2380_ = (_e1580.member_3 < _e1098.member.member_3);
                                                            } else {
                                                                phi_2380_ = false;
                                                            }
                                                            let _e1818 = phi_2380_;
                                                            phi_2381_ = _e1818;
                                                        }
                                                        let _e1820 = phi_2381_;
                                                        if _e1820 {
                                                            phi_2387_ = type_43(_e1580, _e1580.member);
                                                        } else {
                                                            phi_2387_ = _e1098;
                                                        }
                                                        let _e1823 = phi_2387_;
                                                        phi_2388_ = _e1823;
                                                    } else {
                                                        phi_2388_ = _e1098;
                                                    }
                                                    let _e1825 = phi_2388_;
                                                    phi_2389_ = _e1825;
                                                } else {
                                                    phi_2389_ = _e1098;
                                                }
                                                let _e1827 = phi_2389_;
                                                phi_4057_ = _e1297;
                                                phi_1101_ = _e1827;
                                            } else {
                                                phi_4057_ = _e1096;
                                                phi_1101_ = type_43();
                                            }
                                            let _e1829 = phi_4057_;
                                            let _e1831 = phi_1101_;
                                            continue;
                                            continuing {
                                                phi_3994_ = _e1829;
                                                phi_1100_ = _e1831;
                                                phi_1103_ = _e1113;
                                                phi_4056_ = _e1829;
                                                break if !(_e1119);
                                            }
                                        }
                                        let _e1834 = phi_4056_;
                                        phi_4135_ = _e1834;
                                        if _e1834 {
                                            break;
                                        }
                                        phi_4139_ = _e1834;
                                        let _e2074 = local_14;
                                        phi_3629_ = _e2074;
                                        phi_3630_ = _e627;
                                        phi_3631_ = false;
                                        phi_3632_ = _e631;
                                    } else {
                                        if (_e627.member_1 >= _e104) {
                                            phi_3185_ = type_61(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_60(type_37(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e627.member_1 < _e104) {
                                            } else {
                                                phi_4135_ = true;
                                                break;
                                            }
                                            let _e644 = ((1u + _e366) % 4u);
                                            if (_e644 < 4u) {
                                            } else {
                                                phi_4135_ = true;
                                                break;
                                            }
                                            let _e649 = global_4.member[_e627.member_1][_e644];
                                            let _e651 = (_e649 >> bitcast<u32>(11u));
                                            let _e653 = ((1u + _e365) % 4u);
                                            if (_e653 < 4u) {
                                            } else {
                                                phi_4135_ = true;
                                                break;
                                            }
                                            let _e658 = global_4.member[_e627.member_1][_e653];
                                            let _e660 = (_e658 >> bitcast<u32>(11u));
                                            let _e662 = ((1u + _e367) % 4u);
                                            if (_e662 < 4u) {
                                            } else {
                                                phi_4135_ = true;
                                                break;
                                            }
                                            let _e667 = global_4.member[_e627.member_1][_e662];
                                            let _e669 = (_e667 >> bitcast<u32>(11u));
                                            let _e692 = (bitcast<f32>((bitcast<u32>((_e627.member.member_1.x - _e627.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e693 = (bitcast<f32>((bitcast<u32>((_e627.member.member_1.y - _e627.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e694 = (bitcast<f32>((bitcast<u32>((_e627.member.member_1.z - _e627.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e696 = select(_e163, _e692, (_e692 > _e163));
                                            let _e698 = select(_e163, _e693, (_e693 > _e163));
                                            let _e700 = select(_e163, _e694, (_e694 > _e163));
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
                                            let _e803 = (_e627.member.member.x + _e733);
                                            let _e804 = (_e627.member.member.y + _e742);
                                            let _e805 = (_e627.member.member.z + _e751);
                                            let _e808 = (_e627.member.member_1.x - _e772);
                                            let _e809 = (_e627.member.member_1.y - _e781);
                                            let _e810 = (_e627.member.member_1.z - _e790);
                                            let _e829 = (_e808 - _e803);
                                            let _e830 = (_e809 - _e804);
                                            let _e831 = (_e810 - _e805);
                                            let _e833 = select(_e830, _e829, (_e829 > _e830));
                                            let _e835 = select(_e831, _e833, (_e833 > _e831));
                                            if (_e835 < (1024f * _e163)) {
                                                phi_2886_ = 0u;
                                            } else {
                                                phi_2886_ = select(2u, 1u, (_e835 < (2097152f * _e163)));
                                            }
                                            let _e842 = phi_2886_;
                                            switch bitcast<i32>(_e842) {
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
                                            let _e845 = phi_2892_;
                                            let _e851 = global_4.member[_e627.member_1][0u];
                                            let _e855 = global_4.member[_e627.member_1][1u];
                                            let _e859 = global_4.member[_e627.member_1][2u];
                                            let _e863 = global_4.member[_e627.member_1][3u];
                                            let _e875 = (((_e855 >> bitcast<u32>(22i)) | ((_e859 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e863 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e876 = (_e851 & 268435455u);
                                            let _e877 = (_e875 & 268435455u);
                                            let _e880 = ((_e851 >> bitcast<u32>(28u)) & 7u);
                                            let _e888 = ((_e851 >> bitcast<u32>(31i)) | (((_e875 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e889 = (_e880 != 0u);
                                            if (_e880 == 0u) {
                                                phi_3147_ = _e876;
                                            } else {
                                                if (_e880 == 7u) {
                                                    phi_3146_ = 2147483648u;
                                                } else {
                                                    phi_3146_ = ((2147483648u | (_e880 << bitcast<u32>(28u))) | (_e877 & 268435455u));
                                                }
                                                let _e898 = phi_3146_;
                                                phi_3147_ = _e898;
                                            }
                                            let _e900 = phi_3147_;
                                            if _e889 {
                                                let _e901 = (_e880 != 7u);
                                                if _e901 {
                                                    phi_3157_ = (_e877 + (_e880 * ((3u * _e845) + 1u)));
                                                } else {
                                                    phi_3157_ = u32();
                                                }
                                                let _e905 = phi_3157_;
                                                phi_3159_ = _e905;
                                                phi_3160_ = select(true, false, _e901);
                                            } else {
                                                phi_3159_ = u32();
                                                phi_3160_ = true;
                                            }
                                            let _e908 = phi_3159_;
                                            let _e910 = phi_3160_;
                                            if (_e888 == 0u) {
                                                phi_3181_ = (_e876 + select(0u, 1u, !(_e889)));
                                            } else {
                                                if (_e888 == 7u) {
                                                    phi_3180_ = 2147483648u;
                                                } else {
                                                    phi_3180_ = ((2147483648u | (_e888 << bitcast<u32>(28u))) | (select(_e908, _e877, _e910) & 268435455u));
                                                }
                                                let _e923 = phi_3180_;
                                                phi_3181_ = _e923;
                                            }
                                            let _e925 = phi_3181_;
                                            phi_3185_ = type_61(array<vec4<f32>, 3>(vec4<f32>(_e803, (_e627.member.member.x + _e755), _e808, (_e627.member.member_1.x - _e794)), vec4<f32>(_e804, (_e627.member.member.y + _e759), _e809, (_e627.member.member_1.y - _e798)), vec4<f32>(_e805, (_e627.member.member.z + _e763), _e810, (_e627.member.member_1.z - _e802))), type_60(type_37((_e627.member.member + vec4<f32>(_e733, _e742, _e751, 0f)), (_e627.member.member_1 - vec4<f32>(_e772, _e781, _e790, 0f))), _e900), type_60(type_37((_e627.member.member + vec4<f32>(_e755, _e759, _e763, 0f)), (_e627.member.member_1 - vec4<f32>(_e794, _e798, _e802, 0f))), _e925));
                                        }
                                        let _e930 = phi_3185_;
                                        let _e942 = ((_e930.member[0].x - _e421) * _e426);
                                        let _e943 = ((_e930.member[0].y - _e421) * _e426);
                                        let _e944 = ((_e930.member[0].z - _e422) * _e426);
                                        let _e945 = ((_e930.member[0].w - _e422) * _e426);
                                        let _e955 = ((_e930.member[1].x - _e457) * _e462);
                                        let _e956 = ((_e930.member[1].y - _e457) * _e462);
                                        let _e957 = ((_e930.member[1].z - _e458) * _e462);
                                        let _e958 = ((_e930.member[1].w - _e458) * _e462);
                                        let _e968 = ((_e930.member[2].x - _e493) * _e498);
                                        let _e969 = ((_e930.member[2].y - _e493) * _e498);
                                        let _e970 = ((_e930.member[2].z - _e494) * _e498);
                                        let _e971 = ((_e930.member[2].w - _e494) * _e498);
                                        let _e973 = select(_e970, _e968, (_e968 < _e970));
                                        let _e975 = select(_e971, _e969, (_e969 < _e971));
                                        let _e977 = select(_e970, _e968, (_e968 > _e970));
                                        let _e979 = select(_e971, _e969, (_e969 > _e971));
                                        let _e981 = select(_e944, _e942, (_e942 < _e944));
                                        let _e983 = select(_e945, _e943, (_e943 < _e945));
                                        let _e985 = select(_e957, _e955, (_e955 < _e957));
                                        let _e987 = select(_e958, _e956, (_e956 < _e958));
                                        let _e989 = select(_e985, _e981, (_e981 > _e985));
                                        let _e991 = select(_e987, _e983, (_e983 > _e987));
                                        let _e993 = select(_e973, _e989, (_e989 > _e973));
                                        let _e995 = select(_e975, _e991, (_e991 > _e975));
                                        let _e997 = select(_e944, _e942, (_e942 > _e944));
                                        let _e999 = select(_e945, _e943, (_e943 > _e945));
                                        let _e1001 = select(_e957, _e955, (_e955 > _e957));
                                        let _e1003 = select(_e958, _e956, (_e956 > _e958));
                                        let _e1005 = select(_e1001, _e997, (_e997 < _e1001));
                                        let _e1007 = select(_e1003, _e999, (_e999 < _e1003));
                                        let _e1012 = -(_e973);
                                        let _e1013 = -(_e975);
                                        let _e1020 = (select(_e977, _e1005, (_e1005 < _e977)) + (select(_e1012, _e977, (_e977 > _e1012)) * 0.0000019073523f));
                                        let _e1021 = (select(_e979, _e1007, (_e1007 < _e979)) + (select(_e1013, _e979, (_e979 > _e1013)) * 0.0000019073523f));
                                        let _e1023 = select(_e544, _e993, (_e993 > _e544));
                                        let _e1025 = select(_e544, _e995, (_e995 > _e544));
                                        let _e1030 = (_e1023 <= select(_e588.member_1, _e1020, (_e1020 < _e588.member_1)));
                                        let _e1031 = (_e1025 <= select(_e588.member_1, _e1021, (_e1021 < _e588.member_1)));
                                        let _e1032 = (_e1023 <= _e1025);
                                        if _e1030 {
                                            if _e1031 {
                                                if _e1032 {
                                                    phi_3529_ = _e930.member_2;
                                                } else {
                                                    phi_3529_ = _e930.member_1;
                                                }
                                                let _e1036 = phi_3529_;
                                                let _e1058 = (_e631 % 128u);
                                                let _e1059 = (_e1058 < 128u);
                                                if _e1059 {
                                                } else {
                                                    phi_4135_ = true;
                                                    break;
                                                }
                                                local_8[_e1058] = _e1036.member_1;
                                                if _e1059 {
                                                } else {
                                                    phi_4135_ = true;
                                                    break;
                                                }
                                                local_7[_e1058] = _e1036.member.member.x;
                                                if _e1059 {
                                                } else {
                                                    phi_4135_ = true;
                                                    break;
                                                }
                                                local_6[_e1058] = _e1036.member.member.y;
                                                if _e1059 {
                                                } else {
                                                    phi_4135_ = true;
                                                    break;
                                                }
                                                local_5[_e1058] = _e1036.member.member.z;
                                                if _e1059 {
                                                } else {
                                                    phi_4135_ = true;
                                                    break;
                                                }
                                                local_4[_e1058] = _e1036.member.member_1.x;
                                                if _e1059 {
                                                } else {
                                                    phi_4135_ = true;
                                                    break;
                                                }
                                                local_3[_e1058] = _e1036.member.member_1.y;
                                                if _e1059 {
                                                } else {
                                                    phi_4135_ = true;
                                                    break;
                                                }
                                                local_2[_e1058] = _e1036.member.member_1.z;
                                                if _e1059 {
                                                } else {
                                                    phi_4135_ = true;
                                                    break;
                                                }
                                                local_9[_e1058] = select(_e1025, _e1023, (_e1023 > _e1025));
                                                if _e1032 {
                                                    phi_3606_ = _e930.member_1;
                                                } else {
                                                    phi_3606_ = _e930.member_2;
                                                }
                                                let _e1072 = phi_3606_;
                                                phi_3607_ = _e1072;
                                                phi_3608_ = (_e631 + 1u);
                                            } else {
                                                phi_3607_ = type_60();
                                                phi_3608_ = u32();
                                            }
                                            let _e1074 = phi_3607_;
                                            let _e1076 = phi_3608_;
                                            phi_3610_ = _e1074;
                                            phi_3611_ = _e1076;
                                            phi_3612_ = select(true, false, _e1031);
                                        } else {
                                            phi_3610_ = type_60();
                                            phi_3611_ = u32();
                                            phi_3612_ = true;
                                        }
                                        let _e1079 = phi_3610_;
                                        let _e1081 = phi_3611_;
                                        let _e1083 = phi_3612_;
                                        if _e1083 {
                                            if _e1030 {
                                                phi_3621_ = _e930.member_1;
                                            } else {
                                                phi_3621_ = _e930.member_2;
                                            }
                                            let _e1087 = phi_3621_;
                                            phi_3626_ = _e1087;
                                            phi_3627_ = select(_e1031, true, _e1030);
                                        } else {
                                            phi_3626_ = _e1079;
                                            phi_3627_ = _e629;
                                        }
                                        let _e1090 = phi_3626_;
                                        let _e1092 = phi_3627_;
                                        phi_4139_ = _e586;
                                        phi_3629_ = _e588;
                                        phi_3630_ = _e1090;
                                        phi_3631_ = _e1092;
                                        phi_3632_ = select(_e1081, _e631, _e1083);
                                    }
                                    let _e1836 = phi_4139_;
                                    let _e1838 = phi_3629_;
                                    let _e1840 = phi_3630_;
                                    let _e1842 = phi_3631_;
                                    let _e1844 = phi_3632_;
                                    phi_4138_ = _e1836;
                                    phi_3633_ = _e1838;
                                    phi_3634_ = _e1840;
                                    phi_3635_ = (_e592 - 1u);
                                    phi_3636_ = _e1842;
                                    phi_3637_ = _e1844;
                                } else {
                                    phi_4138_ = _e586;
                                    phi_3633_ = _e588;
                                    phi_3634_ = _e627;
                                    phi_3635_ = _e592;
                                    phi_3636_ = _e629;
                                    phi_3637_ = _e631;
                                }
                                let _e1846 = phi_4138_;
                                let _e1848 = phi_3633_;
                                let _e1850 = phi_3634_;
                                let _e1852 = phi_3635_;
                                let _e1854 = phi_3636_;
                                let _e1856 = phi_3637_;
                                phi_4137_ = _e1846;
                                phi_3638_ = _e1848;
                                phi_3639_ = _e1850;
                                phi_3640_ = _e1852;
                                phi_3641_ = _e1854;
                                phi_3642_ = _e1856;
                            } else {
                                phi_4137_ = _e586;
                                phi_3638_ = type_43();
                                phi_3639_ = type_60();
                                phi_3640_ = u32();
                                phi_3641_ = bool();
                                phi_3642_ = u32();
                            }
                            let _e1858 = phi_4137_;
                            let _e1860 = phi_3638_;
                            let _e1862 = phi_3639_;
                            let _e1864 = phi_3640_;
                            let _e1866 = phi_3641_;
                            let _e1868 = phi_3642_;
                            phi_4136_ = _e1858;
                            phi_974_ = _e1860;
                            phi_977_ = _e1862;
                            phi_979_ = _e1864;
                            phi_981_ = _e1866;
                            phi_983_ = _e1868;
                            phi_3643_ = _e600;
                        } else {
                            phi_4136_ = _e586;
                            phi_974_ = type_43();
                            phi_977_ = type_60();
                            phi_979_ = u32();
                            phi_981_ = bool();
                            phi_983_ = u32();
                            phi_3643_ = false;
                        }
                        let _e1870 = phi_4136_;
                        let _e1872 = phi_974_;
                        let _e1874 = phi_977_;
                        let _e1876 = phi_979_;
                        let _e1878 = phi_981_;
                        let _e1880 = phi_983_;
                        let _e1882 = phi_3643_;
                        continue;
                        continuing {
                            phi_3997_ = _e1870;
                            phi_973_ = _e1872;
                            phi_976_ = _e1874;
                            phi_978_ = _e1876;
                            phi_980_ = _e1878;
                            phi_982_ = _e1880;
                            phi_4135_ = _e1870;
                            break if !(_e1882);
                        }
                    }
                    let _e1885 = phi_4135_;
                    if _e1885 {
                        break;
                    }
                    let _e1887 = local_13;
                    if (_e1887.member.member_3 != 4294967295u) {
                        let _e1892 = (_e368 / 3i);
                        let _e1899 = bitcast<f32>((bitcast<u32>((_e1892 + 127i)) << bitcast<u32>(23i)));
                        let _e1907 = (((_e1887.member.member * _e1899) * _e1899) * bitcast<f32>((bitcast<u32>(((_e368 - (2i * _e1892)) + 127i)) << bitcast<u32>(23i))));
                        let _e1909 = select(340282350000000000000000000000000000000f, _e1907, (_e1907 < 340282350000000000000000000000000000000f));
                        phi_3695_ = type_25(select(-340282350000000000000000000000000000000f, _e1909, (_e1909 > -340282350000000000000000000000000000000f)), _e1887.member.member_1, _e1887.member.member_2, _e1887.member.member_3);
                    } else {
                        phi_3695_ = type_25(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e1916 = phi_3695_;
                    if _e245 {
                    } else {
                        break;
                    }
                    global_8.member[_e151] = _e1916;
                    if _e166 {
                    } else {
                        break;
                    }
                    let _e1920 = select(0u, 1u, (_e312 <= _e322));
                    if (_e1920 > 0u) {
                        let _e1922 = (1u < _e119);
                        if _e1922 {
                            if (0u < _e119) {
                            } else {
                                break;
                            }
                            let _e1926 = atomicAdd((&global_9.member[0u]), _e1920);
                            if ((_e1926 + _e1920) < _e1926) {
                                if _e1922 {
                                } else {
                                    break;
                                }
                                let _e1931 = atomicAdd((&global_9.member[1u]), 1u);
                            }
                        }
                    }
                    let _e1934 = select(0u, 1u, (_e1916.member_3 != 4294967295u));
                    if (_e1934 > 0u) {
                        let _e1936 = (3u < _e119);
                        if _e1936 {
                            if (2u < _e119) {
                            } else {
                                break;
                            }
                            let _e1940 = atomicAdd((&global_9.member[2u]), _e1934);
                            if ((_e1940 + _e1934) < _e1940) {
                                if _e1936 {
                                } else {
                                    break;
                                }
                                let _e1945 = atomicAdd((&global_9.member[3u]), 1u);
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
