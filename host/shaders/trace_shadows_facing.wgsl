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

struct type_28 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
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
    member: array<array<f32, 4>, 3>,
    member_1: u32,
    member_2: u32,
    member_3: u32,
    member_4: u32,
}

struct type_39 {
    member: array<type_37>,
}

struct type_42 {
    member: type_29,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_44 {
    member: array<type_42>,
}

struct type_47 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_54 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_55 {
    member: array<vec4<f32>, 3>,
    member_1: u32,
    member_2: u32,
}

struct type_56 {
    member: f32,
    member_1: bool,
}

struct type_58 {
    member: array<vec4<u32>, 2>,
}

struct type_61 {
    member: array<i32>,
}

struct type_68 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(3) 
var<storage> global_2: type_20;
@group(0) @binding(1) 
var<uniform> global_3: type_58;
@group(0) @binding(2) 
var<storage> global_4: type_39;
@group(0) @binding(4) 
var<storage> global_5: type_4;
@group(0) @binding(5) 
var<storage> global_6: type_61;
@group(0) @binding(8) 
var<storage, read_write> global_7: type_68;
@group(0) @binding(6) 
var<storage> global_8: type_44;
@group(0) @binding(7) 
var<storage, read_write> global_9: type_32;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<u32, 128>;
    var phi_259_: u32;
    var phi_303_: i32;
    var phi_443_: type_47;
    var phi_593_: i32;
    var phi_594_: i32;
    var phi_604_: bool;
    var phi_614_: u32;
    var phi_615_: u32;
    var phi_617_: bool;
    var phi_622_: u32;
    var phi_655_: i32;
    var phi_673_: f32;
    var phi_679_: f32;
    var phi_719_: f32;
    var phi_725_: f32;
    var phi_798_: f32;
    var phi_804_: f32;
    var phi_844_: f32;
    var phi_850_: f32;
    var phi_923_: f32;
    var phi_929_: f32;
    var phi_969_: f32;
    var phi_975_: f32;
    var phi_1094_: i32;
    var phi_1116_: u32;
    var phi_1117_: u32;
    var phi_1154_: i32;
    var phi_1176_: u32;
    var phi_1177_: u32;
    var phi_1185_: f32;
    var phi_1186_: f32;
    var phi_3225_: bool;
    var phi_1201_: type_56;
    var phi_1204_: bool;
    var phi_1206_: u32;
    var phi_1208_: u32;
    var phi_1210_: u32;
    var phi_1221_: bool;
    var phi_1253_: bool;
    var phi_1254_: u32;
    var phi_1255_: u32;
    var phi_2582_: type_55;
    var phi_2944_: u32;
    var phi_2971_: u32;
    var phi_2972_: u32;
    var phi_2973_: u32;
    var phi_2975_: u32;
    var phi_2976_: u32;
    var phi_2977_: bool;
    var phi_2986_: u32;
    var phi_2991_: bool;
    var phi_2992_: u32;
    var phi_1270_: type_56;
    var phi_1273_: type_8;
    var phi_1274_: type_8;
    var phi_1296_: type_8;
    var phi_1317_: u32;
    var phi_1409_: array<array<f32, 3>, 3>;
    var phi_1939_: f32;
    var phi_1940_: f32;
    var phi_1941_: f32;
    var phi_1942_: f32;
    var phi_1943_: vec3<f32>;
    var phi_1944_: vec3<f32>;
    var phi_1945_: vec3<f32>;
    var phi_1946_: vec3<f32>;
    var phi_2137_: f32;
    var phi_2157_: type_54;
    var phi_2158_: type_54;
    var phi_2161_: type_54;
    var phi_2162_: type_54;
    var phi_2163_: bool;
    var phi_2167_: type_54;
    var phi_2176_: type_28;
    var phi_2199_: u32;
    var phi_2213_: i32;
    var phi_2235_: vec3<f32>;
    var phi_2236_: vec3<f32>;
    var phi_2254_: vec3<f32>;
    var phi_2255_: vec3<f32>;
    var phi_2273_: vec3<f32>;
    var phi_2274_: vec3<f32>;
    var phi_2310_: vec3<f32>;
    var phi_2492_: f32;
    var phi_2510_: bool;
    var phi_2511_: bool;
    var phi_2516_: type_56;
    var phi_2517_: type_56;
    var phi_1271_: type_56;
    var phi_3219_: bool;
    var local_2: type_56;
    var phi_3408_: bool;
    var phi_2994_: type_56;
    var phi_2995_: bool;
    var phi_2996_: u32;
    var phi_2997_: u32;
    var phi_3407_: bool;
    var phi_2998_: type_56;
    var phi_2999_: bool;
    var phi_3000_: u32;
    var phi_3001_: u32;
    var phi_3002_: u32;
    var phi_3406_: bool;
    var phi_3003_: type_56;
    var phi_3004_: bool;
    var phi_3005_: u32;
    var phi_3006_: u32;
    var phi_3007_: u32;
    var phi_3405_: bool;
    var phi_1202_: type_56;
    var phi_1205_: bool;
    var phi_1207_: u32;
    var phi_1209_: u32;
    var phi_1211_: u32;
    var phi_3008_: bool;
    var phi_3404_: bool;
    var local_3: type_56;
    var local_4: type_56;

    switch bitcast<i32>(0u) {
        default: {
            let _e81 = global;
            let _e83 = arrayLength((&global_4.member));
            let _e85 = arrayLength((&global_2.member));
            let _e97 = arrayLength((&global_7.member));
            let _e101 = (_e81.x + (_e81.y * 2097152u));
            let _e102 = (_e101 < arrayLength((&global_8.member)));
            if _e102 {
                if _e102 {
                } else {
                    break;
                }
                let _e106 = global_8.member[_e101].member_2;
                phi_259_ = _e106;
            } else {
                phi_259_ = 4294967295u;
            }
            let _e108 = phi_259_;
            let _e111 = global_1.member[0u];
            let _e115 = global_3.member[0u][0u];
            let _e119 = global_3.member[0u][1u];
            let _e123 = global_3.member[0u][2u];
            let _e127 = global_3.member[0u][3u];
            let _e131 = global_3.member[1u][0u];
            let _e135 = global_3.member[1u][1u];
            let _e139 = global_3.member[1u][2u];
            let _e143 = global_3.member[1u][3u];
            let _e144 = bitcast<f32>(_e115);
            let _e145 = bitcast<f32>(_e119);
            let _e146 = bitcast<f32>(_e123);
            let _e148 = bitcast<f32>(_e131);
            let _e149 = array<u32, 3>(_e135, _e139, _e143);
            let _e151 = bitcast<i32>(_e111);
            if (_e151 < -126i) {
                phi_303_ = -126i;
            } else {
                phi_303_ = select(_e151, 127i, (_e151 > 127i));
            }
            let _e156 = phi_303_;
            let _e161 = bitcast<f32>((bitcast<u32>((_e156 + 127i)) << bitcast<u32>(23i)));
            let _e167 = bitcast<f32>((bitcast<u32>(((_e151 - _e156) + 127i)) << bitcast<u32>(23i)));
            if (_e127 == 0u) {
                phi_443_ = type_47(array<f32, 3>(_e144, _e145, _e146), _e127, _e148, _e149);
            } else {
                let _e169 = bitcast<u32>(_e144);
                let _e171 = ((_e169 & 2139095040u) != 0u);
                let _e186 = bitcast<u32>(_e145);
                let _e188 = ((_e186 & 2139095040u) != 0u);
                let _e203 = bitcast<u32>(_e146);
                let _e205 = ((_e203 & 2139095040u) != 0u);
                let _e221 = bitcast<u32>(_e148);
                let _e223 = ((_e221 & 2139095040u) != 0u);
                phi_443_ = type_47(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e169 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e169 & 2147483648u))), _e144, _e171) * _e161) * select(0.00000011920929f, 1f, _e171)) * _e167), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e186 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e186 & 2147483648u))), _e145, _e188) * _e161) * select(0.00000011920929f, 1f, _e188)) * _e167), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e203 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e203 & 2147483648u))), _e146, _e205) * _e161) * select(0.00000011920929f, 1f, _e205)) * _e167)), _e127, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e221 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e221 & 2147483648u))), _e148, _e223) * _e161) * select(0.00000011920929f, 1f, _e223)) * _e167), _e149);
            }
            let _e240 = phi_443_;
            if _e102 {
                let _e241 = (_e101 < arrayLength((&global_9.member)));
                if _e241 {
                    if _e102 {
                    } else {
                        break;
                    }
                    let _e246 = global_8.member[_e101].member.member_1;
                    let _e251 = global_8.member[_e101].member.member_3;
                    if (_e246 <= _e251) {
                        let _e253 = (1u < _e97);
                        if _e253 {
                            if (0u < _e97) {
                            } else {
                                break;
                            }
                            let _e257 = atomicAdd((&global_7.member[0u]), 1u);
                            if ((_e257 + 1u) < _e257) {
                                if _e253 {
                                } else {
                                    break;
                                }
                                let _e262 = atomicAdd((&global_7.member[1u]), 1u);
                            }
                        }
                        if _e102 {
                        } else {
                            break;
                        }
                        let _e272 = global_8.member[_e101].member.member_2[0u];
                        let _e274 = (bitcast<u32>(_e272) & 2147483647u);
                        let _e280 = global_8.member[_e101].member.member_2[1u];
                        let _e282 = (bitcast<u32>(_e280) & 2147483647u);
                        let _e288 = global_8.member[_e101].member.member_2[2u];
                        let _e290 = (bitcast<u32>(_e288) & 2147483647u);
                        let _e296 = global_8.member[_e101].member.member[0u];
                        let _e298 = (bitcast<u32>(_e296) & 2147483647u);
                        let _e304 = global_8.member[_e101].member.member[1u];
                        let _e306 = (bitcast<u32>(_e304) & 2147483647u);
                        let _e312 = global_8.member[_e101].member.member[2u];
                        let _e314 = (bitcast<u32>(_e312) & 2147483647u);
                        let _e316 = select(_e282, _e274, (_e282 < _e274));
                        let _e318 = select(_e290, _e316, (_e290 < _e316));
                        let _e320 = select(_e298, _e318, (_e298 < _e318));
                        let _e322 = select(_e306, _e320, (_e306 < _e320));
                        let _e324 = select(_e314, _e322, (_e314 < _e322));
                        let _e325 = bitcast<u32>(_e246);
                        let _e326 = (_e325 & 2147483647u);
                        let _e330 = bitcast<u32>(_e251);
                        let _e331 = (_e330 & 2147483647u);
                        let _e335 = (((select(_e326, _e324, (_e326 < _e324)) < 2139095040u) && (_e331 <= 2139095040u)) && (_e318 > 0u));
                        if _e335 {
                            let _e338 = (bitcast<u32>(bitcast<f32>(_e318)) & 2147483647u);
                            if (_e338 >= 8388608u) {
                                phi_593_ = (bitcast<i32>((_e338 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_593_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e338)), 32u, (_e338 == 0u))));
                            }
                            let _e352 = phi_593_;
                            phi_594_ = _e352;
                        } else {
                            phi_594_ = 0i;
                        }
                        let _e354 = phi_594_;
                        let _e355 = (_e274 == _e318);
                        if _e355 {
                            phi_604_ = true;
                        } else {
                            phi_604_ = (_e282 == _e318);
                        }
                        let _e358 = phi_604_;
                        let _e359 = select(1u, 0u, _e355);
                        if _e358 {
                            let _e360 = (_e359 + 1u);
                            phi_614_ = _e360;
                            phi_615_ = _e360;
                            phi_617_ = select(true, false, (_e360 == 2u));
                        } else {
                            phi_614_ = u32();
                            phi_615_ = 0u;
                            phi_617_ = true;
                        }
                        let _e364 = phi_614_;
                        let _e366 = phi_615_;
                        let _e368 = phi_617_;
                        if _e368 {
                            phi_622_ = (_e366 + 1u);
                        } else {
                            phi_622_ = 0u;
                        }
                        let _e372 = phi_622_;
                        let _e373 = select(_e364, _e366, _e368);
                        let _e374 = select(_e359, select(2u, _e359, _e358), _e368);
                        let _e375 = -(_e354);
                        if (_e375 < -126i) {
                            phi_655_ = -126i;
                        } else {
                            phi_655_ = select(_e375, 127i, (_e375 > 127i));
                        }
                        let _e380 = phi_655_;
                        let _e385 = bitcast<f32>((bitcast<u32>((_e380 + 127i)) << bitcast<u32>(23i)));
                        let _e391 = bitcast<f32>((bitcast<u32>(((_e375 - _e380) + 127i)) << bitcast<u32>(23i)));
                        let _e396 = global_8.member[_e101].member.member;
                        let _e397 = (_e373 == 0u);
                        if _e397 {
                            phi_673_ = _e396[0];
                        } else {
                            phi_673_ = _e396[1];
                        }
                        let _e401 = phi_673_;
                        let _e402 = (_e373 == 2u);
                        if _e402 {
                            phi_679_ = _e396[2];
                        } else {
                            phi_679_ = _e401;
                        }
                        let _e405 = phi_679_;
                        let _e406 = bitcast<u32>(_e405);
                        let _e408 = ((_e406 & 2139095040u) != 0u);
                        let _e420 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e406 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e406 & 2147483648u))), _e405, _e408) * select(0.00000011920929f, 1f, _e408));
                        let _e421 = global_8.member[_e101].member.member_2;
                        if _e397 {
                            phi_719_ = _e421[0];
                        } else {
                            phi_719_ = _e421[1];
                        }
                        let _e425 = phi_719_;
                        if _e402 {
                            phi_725_ = _e421[2];
                        } else {
                            phi_725_ = _e425;
                        }
                        let _e428 = phi_725_;
                        let _e429 = bitcast<u32>(_e428);
                        let _e431 = ((_e429 & 2139095040u) != 0u);
                        let _e445 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e429 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e429 & 2147483648u))), _e428, _e431) * _e385) * select(0.00000011920929f, 1f, _e431)) * _e391);
                        let _e449 = (bitcast<f32>((bitcast<u32>(_e445) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e452 = bitcast<f32>((bitcast<u32>(_e420) & 2147483647u));
                        let _e453 = (_e452 * 0.00000011920929f);
                        let _e456 = select(select(0.00000000000011368684f, _e453, (_e453 > 0.00000000000011368684f)), 0f, _e449);
                        let _e457 = select(0f, _e445, _e449);
                        let _e458 = (_e420 + _e456);
                        let _e459 = (_e420 - _e456);
                        let _e461 = select(38685626000000000000000000f, (1f / _e445), _e449);
                        let _e462 = (_e372 == 0u);
                        if _e462 {
                            phi_798_ = _e396[0];
                        } else {
                            phi_798_ = _e396[1];
                        }
                        let _e466 = phi_798_;
                        let _e467 = (_e372 == 2u);
                        if _e467 {
                            phi_804_ = _e396[2];
                        } else {
                            phi_804_ = _e466;
                        }
                        let _e470 = phi_804_;
                        let _e471 = bitcast<u32>(_e470);
                        let _e473 = ((_e471 & 2139095040u) != 0u);
                        let _e485 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e471 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e471 & 2147483648u))), _e470, _e473) * select(0.00000011920929f, 1f, _e473));
                        if _e462 {
                            phi_844_ = _e421[0];
                        } else {
                            phi_844_ = _e421[1];
                        }
                        let _e489 = phi_844_;
                        if _e467 {
                            phi_850_ = _e421[2];
                        } else {
                            phi_850_ = _e489;
                        }
                        let _e492 = phi_850_;
                        let _e493 = bitcast<u32>(_e492);
                        let _e495 = ((_e493 & 2139095040u) != 0u);
                        let _e509 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e493 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e493 & 2147483648u))), _e492, _e495) * _e385) * select(0.00000011920929f, 1f, _e495)) * _e391);
                        let _e513 = (bitcast<f32>((bitcast<u32>(_e509) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e516 = bitcast<f32>((bitcast<u32>(_e485) & 2147483647u));
                        let _e517 = (_e516 * 0.00000011920929f);
                        let _e520 = select(select(0.00000000000011368684f, _e517, (_e517 > 0.00000000000011368684f)), 0f, _e513);
                        let _e521 = select(0f, _e509, _e513);
                        let _e522 = (_e485 + _e520);
                        let _e523 = (_e485 - _e520);
                        let _e525 = select(38685626000000000000000000f, (1f / _e509), _e513);
                        let _e526 = (_e374 == 0u);
                        if _e526 {
                            phi_923_ = _e396[0];
                        } else {
                            phi_923_ = _e396[1];
                        }
                        let _e530 = phi_923_;
                        let _e531 = (_e374 == 2u);
                        if _e531 {
                            phi_929_ = _e396[2];
                        } else {
                            phi_929_ = _e530;
                        }
                        let _e534 = phi_929_;
                        let _e535 = bitcast<u32>(_e534);
                        let _e537 = ((_e535 & 2139095040u) != 0u);
                        let _e549 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e535 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e535 & 2147483648u))), _e534, _e537) * select(0.00000011920929f, 1f, _e537));
                        if _e526 {
                            phi_969_ = _e421[0];
                        } else {
                            phi_969_ = _e421[1];
                        }
                        let _e553 = phi_969_;
                        if _e531 {
                            phi_975_ = _e421[2];
                        } else {
                            phi_975_ = _e553;
                        }
                        let _e556 = phi_975_;
                        let _e557 = bitcast<u32>(_e556);
                        let _e559 = ((_e557 & 2139095040u) != 0u);
                        let _e573 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e557 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e557 & 2147483648u))), _e556, _e559) * _e385) * select(0.00000011920929f, 1f, _e559)) * _e391);
                        let _e577 = (bitcast<f32>((bitcast<u32>(_e573) & 2147483647u)) >= 0.00000000000000000086736174f);
                        let _e580 = bitcast<f32>((bitcast<u32>(_e549) & 2147483647u));
                        let _e581 = (_e580 * 0.00000011920929f);
                        let _e584 = select(select(0.00000000000011368684f, _e581, (_e581 > 0.00000000000011368684f)), 0f, _e577);
                        let _e585 = select(0f, _e573, _e577);
                        let _e586 = (_e549 + _e584);
                        let _e587 = (_e549 - _e584);
                        let _e589 = select(38685626000000000000000000f, (1f / _e573), _e577);
                        let _e591 = select(_e516, _e452, (_e452 > _e516));
                        if (_e335 && (select(_e580, _e591, (_e591 > _e580)) <= 1099511600000f)) {
                            let _e603 = ((_e326 & 8388607u) | (select(0u, 1u, ((_e326 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e606 = bitcast<i32>((_e326 >> bitcast<u32>(23i)));
                            let _e610 = (_e603 == 0u);
                            let _e613 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e603)), 32u, _e610)) - 8i);
                            if (_e606 == 255i) {
                                phi_1094_ = 255i;
                            } else {
                                phi_1094_ = (((_e606 + select(0i, 1i, (_e606 == 0i))) - _e613) + _e354);
                            }
                            let _e621 = phi_1094_;
                            let _e631 = (_e621 <= 0i);
                            if _e631 {
                                phi_1117_ = u32();
                            } else {
                                if _e610 {
                                    phi_1116_ = u32();
                                } else {
                                    phi_1116_ = select(((bitcast<u32>(_e621) << bitcast<u32>(23i)) | ((_e603 << bitcast<u32>(((_e613 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e621 >= 255i));
                                }
                                let _e635 = phi_1116_;
                                phi_1117_ = _e635;
                            }
                            let _e637 = phi_1117_;
                            let _e649 = ((_e331 & 8388607u) | (select(0u, 1u, ((_e331 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e652 = bitcast<i32>((_e331 >> bitcast<u32>(23i)));
                            let _e656 = (_e649 == 0u);
                            let _e659 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e649)), 32u, _e656)) - 8i);
                            if (_e652 == 255i) {
                                phi_1154_ = 255i;
                            } else {
                                phi_1154_ = (((_e652 + select(0i, 1i, (_e652 == 0i))) - _e659) + _e354);
                            }
                            let _e667 = phi_1154_;
                            let _e677 = (_e667 <= 0i);
                            if _e677 {
                                phi_1177_ = u32();
                            } else {
                                if _e656 {
                                    phi_1176_ = u32();
                                } else {
                                    phi_1176_ = select(((bitcast<u32>(_e667) << bitcast<u32>(23i)) | ((_e649 << bitcast<u32>(((_e659 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e667 >= 255i));
                                }
                                let _e681 = phi_1176_;
                                phi_1177_ = _e681;
                            }
                            let _e683 = phi_1177_;
                            phi_1185_ = bitcast<f32>(((_e330 & 2147483648u) | select(_e683, 0u, select(_e656, true, _e677))));
                            phi_1186_ = bitcast<f32>(((_e325 & 2147483648u) | select(_e637, 0u, select(_e610, true, _e631))));
                        } else {
                            phi_1185_ = 0f;
                            phi_1186_ = 1f;
                        }
                        let _e689 = phi_1185_;
                        let _e691 = phi_1186_;
                        local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        phi_3225_ = false;
                        phi_1201_ = type_56(_e689, false);
                        phi_1204_ = (_e691 <= _e689);
                        phi_1206_ = select(0u, 2147483648u, (_e83 == 0u));
                        phi_1208_ = 0u;
                        phi_1210_ = ((3u * _e83) + 1u);
                        loop {
                            let _e699 = phi_3225_;
                            let _e701 = phi_1201_;
                            let _e703 = phi_1204_;
                            let _e705 = phi_1206_;
                            let _e707 = phi_1208_;
                            let _e709 = phi_1210_;
                            local_3 = _e701;
                            if _e703 {
                                phi_1221_ = true;
                            } else {
                                phi_1221_ = (_e707 > 0u);
                            }
                            let _e712 = phi_1221_;
                            if _e712 {
                                let _e713 = (_e709 > 0u);
                                if _e713 {
                                    if _e703 {
                                        phi_1253_ = _e703;
                                        phi_1254_ = _e705;
                                        phi_1255_ = _e707;
                                    } else {
                                        let _e714 = (_e707 - 1u);
                                        let _e715 = (_e714 % 128u);
                                        let _e716 = (_e715 < 128u);
                                        if _e716 {
                                        } else {
                                            phi_3404_ = true;
                                            break;
                                        }
                                        let _e718 = local_1[_e715];
                                        if _e716 {
                                        } else {
                                            phi_3404_ = true;
                                            break;
                                        }
                                        let _e720 = local[_e715];
                                        phi_1253_ = (_e720 <= _e701.member);
                                        phi_1254_ = _e718;
                                        phi_1255_ = _e714;
                                    }
                                    let _e724 = phi_1253_;
                                    let _e726 = phi_1254_;
                                    let _e728 = phi_1255_;
                                    if _e724 {
                                        if ((_e726 & 2147483648u) != 0u) {
                                            phi_1270_ = _e701;
                                            phi_1273_ = type_8(0u, ((_e726 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e925 = phi_1270_;
                                                let _e927 = phi_1273_;
                                                local_2 = _e925;
                                                local_4 = _e925;
                                                if (_e927.member < _e927.member_1) {
                                                    phi_1274_ = type_8((_e927.member + 1u), _e927.member_1);
                                                    phi_1296_ = type_8(1u, _e927.member);
                                                } else {
                                                    phi_1274_ = _e927;
                                                    phi_1296_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e940 = phi_1274_;
                                                let _e942 = phi_1296_;
                                                let _e946 = (bitcast<i32>(_e942.member) != 0i);
                                                if _e946 {
                                                    let _e947 = ((_e726 & 268435455u) + _e942.member_1);
                                                    let _e948 = (_e947 < _e85);
                                                    if _e948 {
                                                        if _e948 {
                                                        } else {
                                                            phi_3219_ = true;
                                                            break;
                                                        }
                                                        let _e952 = global_2.member[_e947].member_1;
                                                        phi_1317_ = _e952;
                                                    } else {
                                                        phi_1317_ = 4294967295u;
                                                    }
                                                    let _e954 = phi_1317_;
                                                    if (_e947 >= _e85) {
                                                        phi_1409_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e948 {
                                                        } else {
                                                            phi_3219_ = true;
                                                            break;
                                                        }
                                                        let _e956 = (_e373 % 3u);
                                                        let _e957 = (_e372 % 3u);
                                                        let _e958 = (_e374 % 3u);
                                                        if (_e956 < 9u) {
                                                        } else {
                                                            phi_3219_ = true;
                                                            break;
                                                        }
                                                        let _e964 = global_2.member[_e947].member[_e956];
                                                        if (_e957 < 9u) {
                                                        } else {
                                                            phi_3219_ = true;
                                                            break;
                                                        }
                                                        let _e970 = global_2.member[_e947].member[_e957];
                                                        if (_e958 < 9u) {
                                                        } else {
                                                            phi_3219_ = true;
                                                            break;
                                                        }
                                                        let _e976 = global_2.member[_e947].member[_e958];
                                                        let _e978 = (3u + _e956);
                                                        if (_e978 < 9u) {
                                                        } else {
                                                            phi_3219_ = true;
                                                            break;
                                                        }
                                                        let _e984 = global_2.member[_e947].member[_e978];
                                                        let _e985 = (3u + _e957);
                                                        if (_e985 < 9u) {
                                                        } else {
                                                            phi_3219_ = true;
                                                            break;
                                                        }
                                                        let _e991 = global_2.member[_e947].member[_e985];
                                                        let _e992 = (3u + _e958);
                                                        if (_e992 < 9u) {
                                                        } else {
                                                            phi_3219_ = true;
                                                            break;
                                                        }
                                                        let _e998 = global_2.member[_e947].member[_e992];
                                                        let _e1000 = (6u + _e956);
                                                        if (_e1000 < 9u) {
                                                        } else {
                                                            phi_3219_ = true;
                                                            break;
                                                        }
                                                        let _e1006 = global_2.member[_e947].member[_e1000];
                                                        let _e1007 = (6u + _e957);
                                                        if (_e1007 < 9u) {
                                                        } else {
                                                            phi_3219_ = true;
                                                            break;
                                                        }
                                                        let _e1013 = global_2.member[_e947].member[_e1007];
                                                        let _e1014 = (6u + _e958);
                                                        if (_e1014 < 9u) {
                                                        } else {
                                                            phi_3219_ = true;
                                                            break;
                                                        }
                                                        let _e1020 = global_2.member[_e947].member[_e1014];
                                                        phi_1409_ = array<array<f32, 3>, 3>(array<f32, 3>(_e964, _e970, _e976), array<f32, 3>(_e984, _e991, _e998), array<f32, 3>(_e1006, _e1013, _e1020));
                                                    }
                                                    let _e1024 = phi_1409_;
                                                    let _e1040 = (_e1024[0][2] - _e549);
                                                    let _e1043 = (((_e1024[0][0] - _e420) * _e585) - (_e1040 * _e457));
                                                    let _e1046 = (((_e1024[0][1] - _e485) * _e585) - (_e1040 * _e521));
                                                    let _e1049 = (_e1024[1][2] - _e549);
                                                    let _e1052 = (((_e1024[1][0] - _e420) * _e585) - (_e1049 * _e457));
                                                    let _e1055 = (((_e1024[1][1] - _e485) * _e585) - (_e1049 * _e521));
                                                    let _e1058 = (_e1024[2][2] - _e549);
                                                    let _e1061 = (((_e1024[2][0] - _e420) * _e585) - (_e1058 * _e457));
                                                    let _e1064 = (((_e1024[2][1] - _e485) * _e585) - (_e1058 * _e521));
                                                    let _e1065 = (_e1061 * _e1055);
                                                    let _e1066 = (_e1064 * _e1052);
                                                    let _e1067 = (_e1043 * _e1064);
                                                    let _e1068 = (_e1046 * _e1061);
                                                    let _e1069 = (_e1052 * _e1046);
                                                    let _e1070 = (_e1055 * _e1043);
                                                    let _e1075 = (((_e1065 >= _e1066) && (_e1067 >= _e1068)) && (_e1069 >= _e1070));
                                                    let _e1081 = (_e1075 || (((_e1065 <= _e1066) && (_e1067 <= _e1068)) && (_e1069 <= _e1070)));
                                                    if _e1081 {
                                                        let _e1083 = select(-1f, 1f, _e1075);
                                                        let _e1085 = ((_e1065 - _e1066) * _e1083);
                                                        let _e1087 = select(0f, _e1085, (_e1085 > 0f));
                                                        let _e1089 = ((_e1067 - _e1068) * _e1083);
                                                        let _e1091 = select(0f, _e1089, (_e1089 > 0f));
                                                        let _e1093 = ((_e1069 - _e1070) * _e1083);
                                                        let _e1095 = select(0f, _e1093, (_e1093 > 0f));
                                                        let _e1097 = ((_e1087 + _e1091) + _e1095);
                                                        let _e1099 = select(_e1024[1][0], _e1024[0][0], (_e1024[0][0] < _e1024[1][0]));
                                                        let _e1103 = select(_e1024[1][0], _e1024[0][0], (_e1024[0][0] > _e1024[1][0]));
                                                        let _e1107 = select(_e1024[1][1], _e1024[0][1], (_e1024[0][1] < _e1024[1][1]));
                                                        let _e1111 = select(_e1024[1][1], _e1024[0][1], (_e1024[0][1] > _e1024[1][1]));
                                                        let _e1115 = select(_e1024[1][2], _e1024[0][2], (_e1024[0][2] < _e1024[1][2]));
                                                        let _e1119 = select(_e1024[1][2], _e1024[0][2], (_e1024[0][2] > _e1024[1][2]));
                                                        let _e1124 = ((select(_e1024[2][0], _e1099, (_e1099 < _e1024[2][0])) - _e458) * _e461);
                                                        let _e1125 = ((select(_e1024[2][0], _e1103, (_e1103 > _e1024[2][0])) - _e459) * _e461);
                                                        let _e1128 = ((select(_e1024[2][1], _e1107, (_e1107 < _e1024[2][1])) - _e522) * _e525);
                                                        let _e1129 = ((select(_e1024[2][1], _e1111, (_e1111 > _e1024[2][1])) - _e523) * _e525);
                                                        let _e1132 = ((select(_e1024[2][2], _e1115, (_e1115 < _e1024[2][2])) - _e586) * _e589);
                                                        let _e1133 = ((select(_e1024[2][2], _e1119, (_e1119 > _e1024[2][2])) - _e587) * _e589);
                                                        let _e1135 = select(_e1133, _e1132, (_e1132 < _e1133));
                                                        let _e1137 = select(_e1133, _e1132, (_e1132 > _e1133));
                                                        let _e1139 = select(_e1125, _e1124, (_e1124 < _e1125));
                                                        let _e1141 = select(_e1129, _e1128, (_e1128 < _e1129));
                                                        let _e1143 = select(_e1141, _e1139, (_e1139 > _e1141));
                                                        let _e1145 = select(_e1135, _e1143, (_e1143 > _e1135));
                                                        let _e1147 = select(_e1125, _e1124, (_e1124 > _e1125));
                                                        let _e1149 = select(_e1129, _e1128, (_e1128 > _e1129));
                                                        let _e1151 = select(_e1149, _e1147, (_e1147 < _e1149));
                                                        let _e1153 = select(_e1137, _e1151, (_e1151 < _e1137));
                                                        let _e1154 = -(_e1135);
                                                        let _e1160 = select(_e691, _e1145, (_e1145 > _e691));
                                                        let _e1164 = select(_e1052, _e1043, (_e1043 < _e1052));
                                                        let _e1169 = select(_e1052, _e1043, (_e1043 > _e1052));
                                                        let _e1176 = select(_e1055, _e1046, (_e1046 < _e1055));
                                                        let _e1181 = select(_e1055, _e1046, (_e1046 > _e1055));
                                                        let _e1190 = (((((_e1081 && (_e1097 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1061, _e1164, (_e1164 < _e1061)) <= 0f) && (select(_e1061, _e1169, (_e1169 > _e1061)) >= 0f))) && ((select(_e1064, _e1176, (_e1176 < _e1064)) <= 0f) && (select(_e1064, _e1181, (_e1181 > _e1064)) >= 0f))) && (_e1160 <= (_e1153 + (select(_e1154, _e1137, (_e1137 > _e1154)) * 0.0000019073523f)))) && (_e1160 <= _e925.member));
                                                        if _e1190 {
                                                            let _e1195 = (_e1024[1][0] - _e1024[0][0]);
                                                            let _e1196 = (_e1024[1][1] - _e1024[0][1]);
                                                            let _e1197 = (_e1024[1][2] - _e1024[0][2]);
                                                            let _e1198 = vec3<f32>(_e1195, _e1196, _e1197);
                                                            let _e1199 = (_e1024[2][0] - _e1024[1][0]);
                                                            let _e1200 = (_e1024[2][1] - _e1024[1][1]);
                                                            let _e1201 = (_e1024[2][2] - _e1024[1][2]);
                                                            let _e1202 = vec3<f32>(_e1199, _e1200, _e1201);
                                                            let _e1203 = (_e1024[0][0] - _e1024[2][0]);
                                                            let _e1204 = (_e1024[0][1] - _e1024[2][1]);
                                                            let _e1205 = (_e1024[0][2] - _e1024[2][2]);
                                                            let _e1206 = vec3<f32>(_e1203, _e1204, _e1205);
                                                            let _e1209 = bitcast<f32>((bitcast<u32>(_e1195) & 2147483647u));
                                                            let _e1212 = bitcast<f32>((bitcast<u32>(_e1196) & 2147483647u));
                                                            let _e1214 = select(_e1212, _e1209, (_e1209 > _e1212));
                                                            let _e1217 = bitcast<f32>((bitcast<u32>(_e1197) & 2147483647u));
                                                            let _e1219 = select(_e1217, _e1214, (_e1214 > _e1217));
                                                            let _e1222 = bitcast<f32>((bitcast<u32>(_e1199) & 2147483647u));
                                                            let _e1225 = bitcast<f32>((bitcast<u32>(_e1200) & 2147483647u));
                                                            let _e1227 = select(_e1225, _e1222, (_e1222 > _e1225));
                                                            let _e1230 = bitcast<f32>((bitcast<u32>(_e1201) & 2147483647u));
                                                            let _e1232 = select(_e1230, _e1227, (_e1227 > _e1230));
                                                            let _e1235 = bitcast<f32>((bitcast<u32>(_e1203) & 2147483647u));
                                                            let _e1238 = bitcast<f32>((bitcast<u32>(_e1204) & 2147483647u));
                                                            let _e1240 = select(_e1238, _e1235, (_e1235 > _e1238));
                                                            let _e1243 = bitcast<f32>((bitcast<u32>(_e1205) & 2147483647u));
                                                            let _e1245 = select(_e1243, _e1240, (_e1240 > _e1243));
                                                            let _e1247 = select(_e1232, _e1219, (_e1219 > _e1232));
                                                            let _e1249 = select(_e1245, _e1247, (_e1247 > _e1245));
                                                            if (_e1219 == _e1249) {
                                                                phi_1939_ = _e1055;
                                                                phi_1940_ = _e1052;
                                                                phi_1941_ = _e1046;
                                                                phi_1942_ = _e1043;
                                                                phi_1943_ = vec3<f32>(_e1024[0][0], _e1024[0][1], _e1024[0][2]);
                                                                phi_1944_ = _e1206;
                                                                phi_1945_ = _e1202;
                                                                phi_1946_ = _e1198;
                                                            } else {
                                                                let _e1251 = (_e1232 == _e1249);
                                                                let _e1256 = vec3(_e1251);
                                                                phi_1939_ = select(_e1046, _e1064, _e1251);
                                                                phi_1940_ = select(_e1043, _e1061, _e1251);
                                                                phi_1941_ = select(_e1064, _e1055, _e1251);
                                                                phi_1942_ = select(_e1061, _e1052, _e1251);
                                                                phi_1943_ = select(vec3<f32>(_e1024[2][0], _e1024[2][1], _e1024[2][2]), vec3<f32>(_e1024[1][0], _e1024[1][1], _e1024[1][2]), _e1256);
                                                                phi_1944_ = select(_e1202, _e1198, _e1256);
                                                                phi_1945_ = select(_e1198, _e1206, _e1256);
                                                                phi_1946_ = select(_e1206, _e1202, _e1256);
                                                            }
                                                            let _e1262 = phi_1939_;
                                                            let _e1264 = phi_1940_;
                                                            let _e1266 = phi_1941_;
                                                            let _e1268 = phi_1942_;
                                                            let _e1270 = phi_1943_;
                                                            let _e1272 = phi_1944_;
                                                            let _e1274 = phi_1945_;
                                                            let _e1276 = phi_1946_;
                                                            let _e1283 = ((_e1274.y * _e1272.z) - (_e1272.y * _e1274.z));
                                                            let _e1288 = ((_e1274.z * _e1272.x) - (_e1272.z * _e1274.x));
                                                            let _e1291 = ((_e1274.x * _e1272.y) - (_e1272.x * _e1274.y));
                                                            let _e1294 = ((_e1087 >= _e1091) && (_e1087 >= _e1095));
                                                            let _e1295 = (_e1091 >= _e1095);
                                                            let _e1309 = (((_e1283 * (select(select(_e1024[2][0], _e1024[1][0], _e1295), _e1024[0][0], _e1294) - _e420)) + (_e1288 * (select(select(_e1024[2][1], _e1024[1][1], _e1295), _e1024[0][1], _e1294) - _e485))) + (_e1291 * (select(select(_e1024[2][2], _e1024[1][2], _e1295), _e1024[0][2], _e1294) - _e549)));
                                                            let _e1314 = (((_e1283 * _e457) + (_e1288 * _e521)) + (_e1291 * _e585));
                                                            let _e1315 = (_e1264 - _e1268);
                                                            let _e1316 = (_e1262 - _e1266);
                                                            let _e1319 = ((_e1315 * _e1315) + (_e1316 * _e1316));
                                                            let _e1326 = (-(((_e1268 * _e1315) + (_e1266 * _e1316))) / select(0.000000000000000000000000000000000000011754944f, _e1319, (_e1319 > 0.000000000000000000000000000000000000011754944f)));
                                                            let _e1328 = select(1f, _e1326, (_e1326 < 1f));
                                                            let _e1330 = select(0f, _e1328, (_e1328 > 0f));
                                                            let _e1339 = ((_e1270.x + (_e1276.x * _e1330)) - _e420);
                                                            let _e1342 = ((_e1270.y + (_e1276.y * _e1330)) - _e485);
                                                            let _e1345 = ((_e1270.z + (_e1276.z * _e1330)) - _e549);
                                                            let _e1348 = bitcast<f32>((bitcast<u32>(_e1339) & 2147483647u));
                                                            let _e1351 = bitcast<f32>((bitcast<u32>(_e1342) & 2147483647u));
                                                            let _e1353 = select(_e1351, _e1348, (_e1348 > _e1351));
                                                            let _e1356 = bitcast<f32>((bitcast<u32>(_e1345) & 2147483647u));
                                                            let _e1358 = select(_e1356, _e1353, (_e1353 > _e1356));
                                                            let _e1364 = bitcast<f32>((bitcast<u32>(_e1283) & 2147483647u));
                                                            let _e1367 = bitcast<f32>((bitcast<u32>(_e1288) & 2147483647u));
                                                            let _e1369 = select(_e1367, _e1364, (_e1364 > _e1367));
                                                            let _e1372 = bitcast<f32>((bitcast<u32>(_e1291) & 2147483647u));
                                                            let _e1391 = bitcast<f32>((bitcast<u32>(_e1274.x) & 2147483647u));
                                                            let _e1394 = bitcast<f32>((bitcast<u32>(_e1274.y) & 2147483647u));
                                                            let _e1396 = select(_e1394, _e1391, (_e1391 > _e1394));
                                                            let _e1399 = bitcast<f32>((bitcast<u32>(_e1274.z) & 2147483647u));
                                                            let _e1405 = bitcast<f32>((bitcast<u32>(_e1272.x) & 2147483647u));
                                                            let _e1408 = bitcast<f32>((bitcast<u32>(_e1272.y) & 2147483647u));
                                                            let _e1410 = select(_e1408, _e1405, (_e1405 > _e1408));
                                                            let _e1413 = bitcast<f32>((bitcast<u32>(_e1272.z) & 2147483647u));
                                                            let _e1419 = ((bitcast<f32>((bitcast<u32>(((((_e1283 * _e1339) + (_e1288 * _e1342)) + (_e1291 * _e1345)) - _e1309)) & 2147483647u)) <= ((0.0000009536743f * select(_e1249, _e1358, (_e1358 > _e1249))) * select(_e1372, _e1369, (_e1369 > _e1372)))) && !((bitcast<f32>((bitcast<u32>(_e1314) & 2147483647u)) <= ((0.0000038146973f * select(_e1399, _e1396, (_e1396 > _e1399))) * select(_e1413, _e1410, (_e1410 > _e1413))))));
                                                            let _e1420 = (_e1309 / _e1314);
                                                            if (_e1190 && !(_e1419)) {
                                                                let _e1423 = (_e1345 / _e585);
                                                                let _e1431 = (((_e1283 * (_e1339 - (_e457 * _e1423))) + (_e1288 * (_e1342 - (_e521 * _e1423)))) / _e1314);
                                                                phi_2137_ = select(select(_e1423, (_e1423 + _e1431), (bitcast<f32>((bitcast<u32>(_e1431) & 2147483647u)) <= _e1249)), _e1420, _e1419);
                                                            } else {
                                                                phi_2137_ = _e1420;
                                                            }
                                                            let _e1440 = phi_2137_;
                                                            let _e1442 = select(_e1153, _e1440, (_e1440 < _e1153));
                                                            let _e1444 = select(_e1145, _e1442, (_e1442 > _e1145));
                                                            let _e1445 = (1f / _e1097);
                                                            phi_2157_ = type_54(_e1444, (_e1091 * _e1445), (_e1095 * _e1445), ((_e1190 && (_e1444 >= _e691)) && (_e1444 <= _e925.member)));
                                                            phi_2158_ = type_54();
                                                        } else {
                                                            phi_2157_ = type_54();
                                                            phi_2158_ = type_54(0f, 0f, 0f, _e1190);
                                                        }
                                                        let _e1454 = phi_2157_;
                                                        let _e1456 = phi_2158_;
                                                        phi_2161_ = _e1454;
                                                        phi_2162_ = _e1456;
                                                        phi_2163_ = select(true, false, _e1190);
                                                    } else {
                                                        phi_2161_ = type_54();
                                                        phi_2162_ = type_54(0f, 0f, 0f, _e1081);
                                                        phi_2163_ = true;
                                                    }
                                                    let _e1459 = phi_2161_;
                                                    let _e1461 = phi_2162_;
                                                    let _e1463 = phi_2163_;
                                                    if _e1463 {
                                                        phi_2167_ = _e1461;
                                                    } else {
                                                        phi_2167_ = _e1459;
                                                    }
                                                    let _e1465 = phi_2167_;
                                                    if _e1465.member_3 {
                                                        phi_2176_ = type_28(_e1465.member, _e1465.member_1, _e1465.member_2, _e954);
                                                    } else {
                                                        phi_2176_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    }
                                                    let _e1472 = phi_2176_;
                                                    if (_e1472.member_3 != 4294967295u) {
                                                        if (_e954 == _e108) {
                                                            phi_2511_ = false;
                                                        } else {
                                                            let _e1476 = (_e954 < arrayLength((&global_5.member)));
                                                            if _e1476 {
                                                                if _e1476 {
                                                                } else {
                                                                    phi_3219_ = true;
                                                                    break;
                                                                }
                                                                let _e1478 = global_5.member[_e954];
                                                                phi_2199_ = _e1478;
                                                            } else {
                                                                phi_2199_ = 4294967295u;
                                                            }
                                                            let _e1480 = phi_2199_;
                                                            let _e1481 = (_e1480 < arrayLength((&global_6.member)));
                                                            if _e1481 {
                                                                if _e1481 {
                                                                } else {
                                                                    phi_3219_ = true;
                                                                    break;
                                                                }
                                                                let _e1483 = global_6.member[_e1480];
                                                                phi_2213_ = _e1483;
                                                            } else {
                                                                phi_2213_ = 0i;
                                                            }
                                                            let _e1485 = phi_2213_;
                                                            let _e1486 = (_e1485 == 0i);
                                                            if _e1486 {
                                                                phi_2510_ = true;
                                                            } else {
                                                                if _e397 {
                                                                    phi_2236_ = vec3<f32>(_e1024[0][0], _e1024[0][1], _e1024[0][2]);
                                                                } else {
                                                                    if (_e373 == 1u) {
                                                                        phi_2235_ = vec3<f32>(_e1024[0][2], _e1024[0][0], _e1024[0][1]);
                                                                    } else {
                                                                        phi_2235_ = vec3<f32>(_e1024[0][1], _e1024[0][2], _e1024[0][0]);
                                                                    }
                                                                    let _e1491 = phi_2235_;
                                                                    phi_2236_ = _e1491;
                                                                }
                                                                let _e1494 = phi_2236_;
                                                                if _e397 {
                                                                    phi_2255_ = vec3<f32>(_e1024[1][0], _e1024[1][1], _e1024[1][2]);
                                                                } else {
                                                                    if (_e373 == 1u) {
                                                                        phi_2254_ = vec3<f32>(_e1024[1][2], _e1024[1][0], _e1024[1][1]);
                                                                    } else {
                                                                        phi_2254_ = vec3<f32>(_e1024[1][1], _e1024[1][2], _e1024[1][0]);
                                                                    }
                                                                    let _e1499 = phi_2254_;
                                                                    phi_2255_ = _e1499;
                                                                }
                                                                let _e1502 = phi_2255_;
                                                                if _e397 {
                                                                    phi_2274_ = vec3<f32>(_e1024[2][0], _e1024[2][1], _e1024[2][2]);
                                                                } else {
                                                                    if (_e373 == 1u) {
                                                                        phi_2273_ = vec3<f32>(_e1024[2][2], _e1024[2][0], _e1024[2][1]);
                                                                    } else {
                                                                        phi_2273_ = vec3<f32>(_e1024[2][1], _e1024[2][2], _e1024[2][0]);
                                                                    }
                                                                    let _e1507 = phi_2273_;
                                                                    phi_2274_ = _e1507;
                                                                }
                                                                let _e1510 = phi_2274_;
                                                                let _e1513 = (_e1502.x - _e1494.x);
                                                                let _e1516 = (_e1502.y - _e1494.y);
                                                                let _e1519 = (_e1502.z - _e1494.z);
                                                                let _e1521 = (_e1510.x - _e1494.x);
                                                                let _e1523 = (_e1510.y - _e1494.y);
                                                                let _e1525 = (_e1510.z - _e1494.z);
                                                                if (_e240.member_1 == 1u) {
                                                                    phi_2310_ = (vec3<f32>(_e240.member[0], _e240.member[1], _e240.member[2]) - _e1494);
                                                                } else {
                                                                    phi_2310_ = vec3<f32>(_e240.member[0], _e240.member[1], _e240.member[2]);
                                                                }
                                                                let _e1540 = phi_2310_;
                                                                let _e1546 = bitcast<f32>((bitcast<u32>((_e1513 * _e1523)) ^ _e240.member_3[0]));
                                                                let _e1550 = bitcast<f32>((bitcast<u32>((_e1516 * _e1521)) ^ _e240.member_3[0]));
                                                                let _e1554 = bitcast<f32>((bitcast<u32>((_e1516 * _e1525)) ^ _e240.member_3[0]));
                                                                let _e1558 = bitcast<f32>((bitcast<u32>((_e1519 * _e1523)) ^ _e240.member_3[0]));
                                                                let _e1562 = bitcast<f32>((bitcast<u32>((_e1519 * _e1521)) ^ _e240.member_3[0]));
                                                                let _e1566 = bitcast<f32>((bitcast<u32>((_e1513 * _e1525)) ^ _e240.member_3[0]));
                                                                let _e1567 = (_e1554 - _e1558);
                                                                let _e1568 = (_e1562 - _e1566);
                                                                let _e1569 = (_e1546 - _e1550);
                                                                let _e1593 = (bitcast<f32>((bitcast<u32>(_e1554) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1558) & 2147483647u)));
                                                                let _e1600 = (bitcast<f32>((bitcast<u32>(_e1562) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1566) & 2147483647u)));
                                                                let _e1607 = (bitcast<f32>((bitcast<u32>(_e1546) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1550) & 2147483647u)));
                                                                if (_e240.member_2 == 0f) {
                                                                    phi_2492_ = 0f;
                                                                } else {
                                                                    let _e1637 = bitcast<f32>((bitcast<u32>(_e1567) & 2147483647u));
                                                                    let _e1640 = bitcast<f32>((bitcast<u32>(_e1568) & 2147483647u));
                                                                    let _e1643 = bitcast<f32>((bitcast<u32>(_e1569) & 2147483647u));
                                                                    let _e1645 = select(_e1643, _e1640, (_e1640 > _e1643));
                                                                    let _e1649 = select(_e1643, _e1640, (_e1640 < _e1643));
                                                                    let _e1653 = select(_e1640, _e1637, (_e1637 < _e1640));
                                                                    let _e1655 = select(_e1640, _e1637, (_e1637 > _e1640));
                                                                    let _e1657 = select(_e1643, _e1655, (_e1655 < _e1643));
                                                                    phi_2492_ = bitcast<f32>((bitcast<u32>((_e240.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1645, _e1637, (_e1637 > _e1645)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1657, _e1653, (_e1653 > _e1657)))) ^ _e240.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1649, _e1637, (_e1637 < _e1649)))) ^ _e240.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1593 + _e1600) + _e1607))) ^ _e240.member_3[0]))) * 1.0000005f)) ^ _e240.member_3[0])))) ^ _e240.member_3[0]));
                                                                }
                                                                let _e1684 = phi_2492_;
                                                                phi_2510_ = (_e1486 || !(((((bitcast<f32>((bitcast<u32>((_e1540.x * _e1567)) ^ _e240.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1540.y * _e1568)) ^ _e240.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1540.z * _e1569)) ^ _e240.member_3[0]))) * f32(-(_e1485))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1540.x) & 2147483647u)) * _e1593)) ^ _e240.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1540.y) & 2147483647u)) * _e1600)) ^ _e240.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1540.z) & 2147483647u)) * _e1607)) ^ _e240.member_3[0]))))) ^ _e240.member_3[0])) + _e1684) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1698 = phi_2510_;
                                                            phi_2511_ = _e1698;
                                                        }
                                                        let _e1700 = phi_2511_;
                                                        if _e1700 {
                                                            phi_2516_ = type_56(-340282350000000000000000000000000000000f, true);
                                                        } else {
                                                            phi_2516_ = _e925;
                                                        }
                                                        let _e1702 = phi_2516_;
                                                        phi_2517_ = _e1702;
                                                    } else {
                                                        phi_2517_ = _e925;
                                                    }
                                                    let _e1704 = phi_2517_;
                                                    phi_1271_ = _e1704;
                                                } else {
                                                    phi_1271_ = type_56();
                                                }
                                                let _e1706 = phi_1271_;
                                                continue;
                                                continuing {
                                                    phi_1270_ = _e1706;
                                                    phi_1273_ = _e940;
                                                    phi_3219_ = _e699;
                                                    break if !(_e946);
                                                }
                                            }
                                            let _e1709 = phi_3219_;
                                            phi_3404_ = _e1709;
                                            if _e1709 {
                                                break;
                                            }
                                            let _e1711 = local_2;
                                            phi_3408_ = _e1709;
                                            let _e1892 = local_4;
                                            phi_2994_ = _e1892;
                                            phi_2995_ = false;
                                            phi_2996_ = _e726;
                                            phi_2997_ = select(_e728, 0u, (_e691 > _e1711.member));
                                        } else {
                                            if (_e726 >= _e83) {
                                                phi_2582_ = type_55(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                            } else {
                                                if (_e726 < _e83) {
                                                } else {
                                                    phi_3404_ = true;
                                                    break;
                                                }
                                                let _e738 = (_e373 % 3u);
                                                if (_e738 < 3u) {
                                                } else {
                                                    phi_3404_ = true;
                                                    break;
                                                }
                                                let _e744 = global_4.member[_e726].member[_e738];
                                                let _e750 = (_e372 % 3u);
                                                if (_e750 < 3u) {
                                                } else {
                                                    phi_3404_ = true;
                                                    break;
                                                }
                                                let _e756 = global_4.member[_e726].member[_e750];
                                                let _e762 = (_e374 % 3u);
                                                if (_e762 < 3u) {
                                                } else {
                                                    phi_3404_ = true;
                                                    break;
                                                }
                                                let _e768 = global_4.member[_e726].member[_e762];
                                                let _e778 = global_4.member[_e726].member_1;
                                                let _e782 = global_4.member[_e726].member_2;
                                                phi_2582_ = type_55(array<vec4<f32>, 3>(vec4<f32>(_e744[0], _e744[1], _e744[2], _e744[3]), vec4<f32>(_e756[0], _e756[1], _e756[2], _e756[3]), vec4<f32>(_e768[0], _e768[1], _e768[2], _e768[3])), _e778, _e782);
                                            }
                                            let _e785 = phi_2582_;
                                            let _e797 = ((_e785.member[0].x - _e458) * _e461);
                                            let _e798 = ((_e785.member[0].y - _e458) * _e461);
                                            let _e799 = ((_e785.member[0].z - _e459) * _e461);
                                            let _e800 = ((_e785.member[0].w - _e459) * _e461);
                                            let _e810 = ((_e785.member[1].x - _e522) * _e525);
                                            let _e811 = ((_e785.member[1].y - _e522) * _e525);
                                            let _e812 = ((_e785.member[1].z - _e523) * _e525);
                                            let _e813 = ((_e785.member[1].w - _e523) * _e525);
                                            let _e823 = ((_e785.member[2].x - _e586) * _e589);
                                            let _e824 = ((_e785.member[2].y - _e586) * _e589);
                                            let _e825 = ((_e785.member[2].z - _e587) * _e589);
                                            let _e826 = ((_e785.member[2].w - _e587) * _e589);
                                            let _e828 = select(_e825, _e823, (_e823 < _e825));
                                            let _e830 = select(_e826, _e824, (_e824 < _e826));
                                            let _e832 = select(_e825, _e823, (_e823 > _e825));
                                            let _e834 = select(_e826, _e824, (_e824 > _e826));
                                            let _e836 = select(_e799, _e797, (_e797 < _e799));
                                            let _e838 = select(_e800, _e798, (_e798 < _e800));
                                            let _e840 = select(_e812, _e810, (_e810 < _e812));
                                            let _e842 = select(_e813, _e811, (_e811 < _e813));
                                            let _e844 = select(_e840, _e836, (_e836 > _e840));
                                            let _e846 = select(_e842, _e838, (_e838 > _e842));
                                            let _e848 = select(_e828, _e844, (_e844 > _e828));
                                            let _e850 = select(_e830, _e846, (_e846 > _e830));
                                            let _e852 = select(_e799, _e797, (_e797 > _e799));
                                            let _e854 = select(_e800, _e798, (_e798 > _e800));
                                            let _e856 = select(_e812, _e810, (_e810 > _e812));
                                            let _e858 = select(_e813, _e811, (_e811 > _e813));
                                            let _e860 = select(_e856, _e852, (_e852 < _e856));
                                            let _e862 = select(_e858, _e854, (_e854 < _e858));
                                            let _e867 = -(_e828);
                                            let _e868 = -(_e830);
                                            let _e875 = (select(_e832, _e860, (_e860 < _e832)) + (select(_e867, _e832, (_e832 > _e867)) * 0.0000019073523f));
                                            let _e876 = (select(_e834, _e862, (_e862 < _e834)) + (select(_e868, _e834, (_e834 > _e868)) * 0.0000019073523f));
                                            let _e878 = select(_e691, _e848, (_e848 > _e691));
                                            let _e880 = select(_e691, _e850, (_e850 > _e691));
                                            let _e885 = (_e878 <= select(_e701.member, _e875, (_e875 < _e701.member)));
                                            let _e886 = (_e880 <= select(_e701.member, _e876, (_e876 < _e701.member)));
                                            let _e887 = (_e878 <= _e880);
                                            if _e885 {
                                                if _e886 {
                                                    if _e887 {
                                                        phi_2944_ = _e785.member_2;
                                                    } else {
                                                        phi_2944_ = _e785.member_1;
                                                    }
                                                    let _e891 = phi_2944_;
                                                    let _e893 = (_e728 % 128u);
                                                    let _e894 = (_e893 < 128u);
                                                    if _e894 {
                                                    } else {
                                                        phi_3404_ = true;
                                                        break;
                                                    }
                                                    local_1[_e893] = _e891;
                                                    if _e894 {
                                                    } else {
                                                        phi_3404_ = true;
                                                        break;
                                                    }
                                                    local[_e893] = select(_e878, _e880, _e887);
                                                    if _e887 {
                                                        phi_2971_ = _e785.member_1;
                                                    } else {
                                                        phi_2971_ = _e785.member_2;
                                                    }
                                                    let _e901 = phi_2971_;
                                                    phi_2972_ = _e901;
                                                    phi_2973_ = (_e728 + 1u);
                                                } else {
                                                    phi_2972_ = u32();
                                                    phi_2973_ = u32();
                                                }
                                                let _e903 = phi_2972_;
                                                let _e905 = phi_2973_;
                                                phi_2975_ = _e903;
                                                phi_2976_ = _e905;
                                                phi_2977_ = select(true, false, _e886);
                                            } else {
                                                phi_2975_ = u32();
                                                phi_2976_ = u32();
                                                phi_2977_ = true;
                                            }
                                            let _e908 = phi_2975_;
                                            let _e910 = phi_2976_;
                                            let _e912 = phi_2977_;
                                            if _e912 {
                                                if _e885 {
                                                    phi_2986_ = _e785.member_1;
                                                } else {
                                                    phi_2986_ = _e785.member_2;
                                                }
                                                let _e916 = phi_2986_;
                                                phi_2991_ = select(_e886, true, _e885);
                                                phi_2992_ = _e916;
                                            } else {
                                                phi_2991_ = _e724;
                                                phi_2992_ = _e908;
                                            }
                                            let _e919 = phi_2991_;
                                            let _e921 = phi_2992_;
                                            phi_3408_ = _e699;
                                            phi_2994_ = _e701;
                                            phi_2995_ = _e919;
                                            phi_2996_ = _e921;
                                            phi_2997_ = select(_e910, _e728, _e912);
                                        }
                                        let _e1716 = phi_3408_;
                                        let _e1718 = phi_2994_;
                                        let _e1720 = phi_2995_;
                                        let _e1722 = phi_2996_;
                                        let _e1724 = phi_2997_;
                                        phi_3407_ = _e1716;
                                        phi_2998_ = _e1718;
                                        phi_2999_ = _e1720;
                                        phi_3000_ = _e1722;
                                        phi_3001_ = _e1724;
                                        phi_3002_ = (_e709 - 1u);
                                    } else {
                                        phi_3407_ = _e699;
                                        phi_2998_ = _e701;
                                        phi_2999_ = _e724;
                                        phi_3000_ = _e726;
                                        phi_3001_ = _e728;
                                        phi_3002_ = _e709;
                                    }
                                    let _e1726 = phi_3407_;
                                    let _e1728 = phi_2998_;
                                    let _e1730 = phi_2999_;
                                    let _e1732 = phi_3000_;
                                    let _e1734 = phi_3001_;
                                    let _e1736 = phi_3002_;
                                    phi_3406_ = _e1726;
                                    phi_3003_ = _e1728;
                                    phi_3004_ = _e1730;
                                    phi_3005_ = _e1732;
                                    phi_3006_ = _e1734;
                                    phi_3007_ = _e1736;
                                } else {
                                    phi_3406_ = _e699;
                                    phi_3003_ = type_56();
                                    phi_3004_ = bool();
                                    phi_3005_ = u32();
                                    phi_3006_ = u32();
                                    phi_3007_ = u32();
                                }
                                let _e1738 = phi_3406_;
                                let _e1740 = phi_3003_;
                                let _e1742 = phi_3004_;
                                let _e1744 = phi_3005_;
                                let _e1746 = phi_3006_;
                                let _e1748 = phi_3007_;
                                phi_3405_ = _e1738;
                                phi_1202_ = _e1740;
                                phi_1205_ = _e1742;
                                phi_1207_ = _e1744;
                                phi_1209_ = _e1746;
                                phi_1211_ = _e1748;
                                phi_3008_ = _e713;
                            } else {
                                phi_3405_ = _e699;
                                phi_1202_ = type_56();
                                phi_1205_ = bool();
                                phi_1207_ = u32();
                                phi_1209_ = u32();
                                phi_1211_ = u32();
                                phi_3008_ = false;
                            }
                            let _e1750 = phi_3405_;
                            let _e1752 = phi_1202_;
                            let _e1754 = phi_1205_;
                            let _e1756 = phi_1207_;
                            let _e1758 = phi_1209_;
                            let _e1760 = phi_1211_;
                            let _e1762 = phi_3008_;
                            continue;
                            continuing {
                                phi_3225_ = _e1750;
                                phi_1201_ = _e1752;
                                phi_1204_ = _e1754;
                                phi_1206_ = _e1756;
                                phi_1208_ = _e1758;
                                phi_1210_ = _e1760;
                                phi_3404_ = _e1750;
                                break if !(_e1762);
                            }
                        }
                        let _e1765 = phi_3404_;
                        if _e1765 {
                            break;
                        }
                        let _e1767 = local_3;
                        if _e1767.member_1 {
                        } else {
                            if _e241 {
                            } else {
                                break;
                            }
                            let _e1771 = global_9.member[_e101];
                            if _e102 {
                            } else {
                                break;
                            }
                            let _e1775 = global_8.member[_e101].member_1;
                            if _e241 {
                            } else {
                                break;
                            }
                            global_9.member[_e101] = type_30(_e1771.member, _e1771.member_1, _e1771.member_2, array<f32, 3>((_e1771.member_3[0] + (_e1775[0] * _e1771.member_1[0])), (_e1771.member_3[1] + (_e1775[1] * _e1771.member_1[1])), (_e1771.member_3[2] + (_e1775[2] * _e1771.member_1[2]))), _e1771.member_4);
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
fn trace_shadows_facing(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
