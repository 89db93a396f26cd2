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
    var phi_252_: u32;
    var phi_296_: i32;
    var phi_436_: type_47;
    var phi_586_: i32;
    var phi_587_: i32;
    var phi_597_: bool;
    var phi_607_: u32;
    var phi_608_: u32;
    var phi_610_: bool;
    var phi_615_: u32;
    var phi_648_: i32;
    var phi_666_: f32;
    var phi_672_: f32;
    var phi_712_: f32;
    var phi_718_: f32;
    var phi_791_: f32;
    var phi_797_: f32;
    var phi_837_: f32;
    var phi_843_: f32;
    var phi_916_: f32;
    var phi_922_: f32;
    var phi_962_: f32;
    var phi_968_: f32;
    var phi_1087_: i32;
    var phi_1109_: u32;
    var phi_1110_: u32;
    var phi_1147_: i32;
    var phi_1169_: u32;
    var phi_1170_: u32;
    var phi_1178_: f32;
    var phi_1179_: f32;
    var phi_3297_: bool;
    var phi_1194_: type_56;
    var phi_1197_: u32;
    var phi_1199_: bool;
    var phi_1201_: u32;
    var phi_1203_: u32;
    var phi_1214_: bool;
    var phi_1246_: bool;
    var phi_1247_: u32;
    var phi_1248_: u32;
    var phi_1263_: type_56;
    var phi_1266_: type_8;
    var phi_1267_: type_8;
    var phi_1289_: type_8;
    var phi_1310_: u32;
    var phi_1402_: array<array<f32, 3>, 3>;
    var phi_3117_: bool;
    var phi_3132_: bool;
    var phi_3147_: bool;
    var phi_3162_: bool;
    var phi_3177_: bool;
    var phi_3192_: bool;
    var phi_1944_: f32;
    var phi_1945_: f32;
    var phi_1946_: f32;
    var phi_1947_: f32;
    var phi_1948_: vec3<f32>;
    var phi_1949_: vec3<f32>;
    var phi_1950_: vec3<f32>;
    var phi_1951_: vec3<f32>;
    var phi_3207_: bool;
    var phi_3222_: bool;
    var phi_3237_: bool;
    var phi_3252_: bool;
    var phi_3267_: bool;
    var phi_3282_: bool;
    var phi_2159_: f32;
    var phi_2179_: type_54;
    var phi_2180_: type_54;
    var phi_2183_: type_54;
    var phi_2184_: type_54;
    var phi_2185_: bool;
    var phi_2189_: type_54;
    var phi_2198_: type_28;
    var phi_2221_: u32;
    var phi_2235_: i32;
    var phi_2257_: vec3<f32>;
    var phi_2258_: vec3<f32>;
    var phi_2276_: vec3<f32>;
    var phi_2277_: vec3<f32>;
    var phi_2295_: vec3<f32>;
    var phi_2296_: vec3<f32>;
    var phi_2332_: vec3<f32>;
    var phi_2514_: f32;
    var phi_2532_: bool;
    var phi_2533_: bool;
    var phi_2538_: type_56;
    var phi_2539_: type_56;
    var phi_1264_: type_56;
    var phi_3291_: bool;
    var phi_3523_: bool;
    var phi_2540_: type_56;
    var phi_2605_: type_55;
    var phi_2967_: u32;
    var phi_2994_: u32;
    var phi_2995_: u32;
    var phi_2996_: u32;
    var phi_2998_: u32;
    var phi_2999_: u32;
    var phi_3000_: bool;
    var phi_3009_: u32;
    var phi_3014_: bool;
    var phi_3016_: u32;
    var phi_3020_: bool;
    var phi_3021_: u32;
    var phi_3022_: u32;
    var phi_3032_: u32;
    var phi_3491_: bool;
    var phi_3034_: type_56;
    var phi_3035_: u32;
    var phi_3036_: bool;
    var phi_3037_: u32;
    var phi_3038_: u32;
    var phi_3490_: bool;
    var phi_3039_: type_56;
    var phi_3040_: u32;
    var phi_3041_: bool;
    var phi_3042_: u32;
    var phi_3043_: u32;
    var phi_3489_: bool;
    var phi_1195_: type_56;
    var phi_1198_: u32;
    var phi_1200_: bool;
    var phi_1202_: u32;
    var phi_1204_: u32;
    var phi_3044_: bool;
    var phi_3488_: bool;
    var local_2: type_56;
    var local_3: type_56;

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
                phi_252_ = _e106;
            } else {
                phi_252_ = 4294967295u;
            }
            let _e108 = phi_252_;
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
                phi_296_ = -126i;
            } else {
                phi_296_ = select(_e151, 127i, (_e151 > 127i));
            }
            let _e156 = phi_296_;
            let _e161 = bitcast<f32>((bitcast<u32>((_e156 + 127i)) << bitcast<u32>(23i)));
            let _e167 = bitcast<f32>((bitcast<u32>(((_e151 - _e156) + 127i)) << bitcast<u32>(23i)));
            if (_e127 == 0u) {
                phi_436_ = type_47(array<f32, 3>(_e144, _e145, _e146), _e127, _e148, _e149);
            } else {
                let _e169 = bitcast<u32>(_e144);
                let _e171 = ((_e169 & 2139095040u) != 0u);
                let _e186 = bitcast<u32>(_e145);
                let _e188 = ((_e186 & 2139095040u) != 0u);
                let _e203 = bitcast<u32>(_e146);
                let _e205 = ((_e203 & 2139095040u) != 0u);
                let _e221 = bitcast<u32>(_e148);
                let _e223 = ((_e221 & 2139095040u) != 0u);
                phi_436_ = type_47(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e169 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e169 & 2147483648u))), _e144, _e171) * _e161) * select(0.00000011920929f, 1f, _e171)) * _e167), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e186 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e186 & 2147483648u))), _e145, _e188) * _e161) * select(0.00000011920929f, 1f, _e188)) * _e167), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e203 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e203 & 2147483648u))), _e146, _e205) * _e161) * select(0.00000011920929f, 1f, _e205)) * _e167)), _e127, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e221 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e221 & 2147483648u))), _e148, _e223) * _e161) * select(0.00000011920929f, 1f, _e223)) * _e167), _e149);
            }
            let _e240 = phi_436_;
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
                                phi_586_ = (bitcast<i32>((_e338 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_586_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e338)), 32u, (_e338 == 0u))));
                            }
                            let _e352 = phi_586_;
                            phi_587_ = _e352;
                        } else {
                            phi_587_ = 0i;
                        }
                        let _e354 = phi_587_;
                        let _e355 = (_e274 == _e318);
                        if _e355 {
                            phi_597_ = true;
                        } else {
                            phi_597_ = (_e282 == _e318);
                        }
                        let _e358 = phi_597_;
                        let _e359 = select(1u, 0u, _e355);
                        if _e358 {
                            let _e360 = (_e359 + 1u);
                            phi_607_ = _e360;
                            phi_608_ = _e360;
                            phi_610_ = select(true, false, (_e360 == 2u));
                        } else {
                            phi_607_ = u32();
                            phi_608_ = 0u;
                            phi_610_ = true;
                        }
                        let _e364 = phi_607_;
                        let _e366 = phi_608_;
                        let _e368 = phi_610_;
                        if _e368 {
                            phi_615_ = (_e366 + 1u);
                        } else {
                            phi_615_ = 0u;
                        }
                        let _e372 = phi_615_;
                        let _e373 = select(_e364, _e366, _e368);
                        let _e374 = select(_e359, select(2u, _e359, _e358), _e368);
                        let _e375 = -(_e354);
                        if (_e375 < -126i) {
                            phi_648_ = -126i;
                        } else {
                            phi_648_ = select(_e375, 127i, (_e375 > 127i));
                        }
                        let _e380 = phi_648_;
                        let _e385 = bitcast<f32>((bitcast<u32>((_e380 + 127i)) << bitcast<u32>(23i)));
                        let _e391 = bitcast<f32>((bitcast<u32>(((_e375 - _e380) + 127i)) << bitcast<u32>(23i)));
                        let _e396 = global_8.member[_e101].member.member;
                        let _e397 = (_e373 == 0u);
                        if _e397 {
                            phi_666_ = _e396[0];
                        } else {
                            phi_666_ = _e396[1];
                        }
                        let _e401 = phi_666_;
                        let _e402 = (_e373 == 2u);
                        if _e402 {
                            phi_672_ = _e396[2];
                        } else {
                            phi_672_ = _e401;
                        }
                        let _e405 = phi_672_;
                        let _e406 = bitcast<u32>(_e405);
                        let _e408 = ((_e406 & 2139095040u) != 0u);
                        let _e420 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e406 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e406 & 2147483648u))), _e405, _e408) * select(0.00000011920929f, 1f, _e408));
                        let _e421 = global_8.member[_e101].member.member_2;
                        if _e397 {
                            phi_712_ = _e421[0];
                        } else {
                            phi_712_ = _e421[1];
                        }
                        let _e425 = phi_712_;
                        if _e402 {
                            phi_718_ = _e421[2];
                        } else {
                            phi_718_ = _e425;
                        }
                        let _e428 = phi_718_;
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
                            phi_791_ = _e396[0];
                        } else {
                            phi_791_ = _e396[1];
                        }
                        let _e466 = phi_791_;
                        let _e467 = (_e372 == 2u);
                        if _e467 {
                            phi_797_ = _e396[2];
                        } else {
                            phi_797_ = _e466;
                        }
                        let _e470 = phi_797_;
                        let _e471 = bitcast<u32>(_e470);
                        let _e473 = ((_e471 & 2139095040u) != 0u);
                        let _e485 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e471 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e471 & 2147483648u))), _e470, _e473) * select(0.00000011920929f, 1f, _e473));
                        if _e462 {
                            phi_837_ = _e421[0];
                        } else {
                            phi_837_ = _e421[1];
                        }
                        let _e489 = phi_837_;
                        if _e467 {
                            phi_843_ = _e421[2];
                        } else {
                            phi_843_ = _e489;
                        }
                        let _e492 = phi_843_;
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
                            phi_916_ = _e396[0];
                        } else {
                            phi_916_ = _e396[1];
                        }
                        let _e530 = phi_916_;
                        let _e531 = (_e374 == 2u);
                        if _e531 {
                            phi_922_ = _e396[2];
                        } else {
                            phi_922_ = _e530;
                        }
                        let _e534 = phi_922_;
                        let _e535 = bitcast<u32>(_e534);
                        let _e537 = ((_e535 & 2139095040u) != 0u);
                        let _e549 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e535 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e535 & 2147483648u))), _e534, _e537) * select(0.00000011920929f, 1f, _e537));
                        if _e526 {
                            phi_962_ = _e421[0];
                        } else {
                            phi_962_ = _e421[1];
                        }
                        let _e553 = phi_962_;
                        if _e531 {
                            phi_968_ = _e421[2];
                        } else {
                            phi_968_ = _e553;
                        }
                        let _e556 = phi_968_;
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
                                phi_1087_ = 255i;
                            } else {
                                phi_1087_ = (((_e606 + select(0i, 1i, (_e606 == 0i))) - _e613) + _e354);
                            }
                            let _e621 = phi_1087_;
                            let _e631 = (_e621 <= 0i);
                            if _e631 {
                                phi_1110_ = u32();
                            } else {
                                if _e610 {
                                    phi_1109_ = u32();
                                } else {
                                    phi_1109_ = select(((bitcast<u32>(_e621) << bitcast<u32>(23i)) | ((_e603 << bitcast<u32>(((_e613 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e621 >= 255i));
                                }
                                let _e635 = phi_1109_;
                                phi_1110_ = _e635;
                            }
                            let _e637 = phi_1110_;
                            let _e649 = ((_e331 & 8388607u) | (select(0u, 1u, ((_e331 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e652 = bitcast<i32>((_e331 >> bitcast<u32>(23i)));
                            let _e656 = (_e649 == 0u);
                            let _e659 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e649)), 32u, _e656)) - 8i);
                            if (_e652 == 255i) {
                                phi_1147_ = 255i;
                            } else {
                                phi_1147_ = (((_e652 + select(0i, 1i, (_e652 == 0i))) - _e659) + _e354);
                            }
                            let _e667 = phi_1147_;
                            let _e677 = (_e667 <= 0i);
                            if _e677 {
                                phi_1170_ = u32();
                            } else {
                                if _e656 {
                                    phi_1169_ = u32();
                                } else {
                                    phi_1169_ = select(((bitcast<u32>(_e667) << bitcast<u32>(23i)) | ((_e649 << bitcast<u32>(((_e659 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e667 >= 255i));
                                }
                                let _e681 = phi_1169_;
                                phi_1170_ = _e681;
                            }
                            let _e683 = phi_1170_;
                            phi_1178_ = bitcast<f32>(((_e330 & 2147483648u) | select(_e683, 0u, select(_e656, true, _e677))));
                            phi_1179_ = bitcast<f32>(((_e325 & 2147483648u) | select(_e637, 0u, select(_e610, true, _e631))));
                        } else {
                            phi_1178_ = 0f;
                            phi_1179_ = 1f;
                        }
                        let _e689 = phi_1178_;
                        let _e691 = phi_1179_;
                        local_1 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        phi_3297_ = false;
                        phi_1194_ = type_56(_e689, false);
                        phi_1197_ = ((3u * _e83) + 1u);
                        phi_1199_ = (_e691 <= _e689);
                        phi_1201_ = 0u;
                        phi_1203_ = select(0u, 2147483648u, (_e83 == 0u));
                        loop {
                            let _e699 = phi_3297_;
                            let _e701 = phi_1194_;
                            let _e703 = phi_1197_;
                            let _e705 = phi_1199_;
                            let _e707 = phi_1201_;
                            let _e709 = phi_1203_;
                            local_2 = _e701;
                            if _e705 {
                                phi_1214_ = true;
                            } else {
                                phi_1214_ = (_e707 > 0u);
                            }
                            let _e712 = phi_1214_;
                            if _e712 {
                                let _e713 = (_e703 > 0u);
                                if _e713 {
                                    if _e705 {
                                        phi_1246_ = _e705;
                                        phi_1247_ = _e707;
                                        phi_1248_ = _e709;
                                    } else {
                                        let _e714 = (_e707 - 1u);
                                        let _e715 = (_e714 % 128u);
                                        let _e716 = (_e715 < 128u);
                                        if _e716 {
                                        } else {
                                            phi_3488_ = true;
                                            break;
                                        }
                                        let _e718 = local_1[_e715];
                                        if _e716 {
                                        } else {
                                            phi_3488_ = true;
                                            break;
                                        }
                                        let _e720 = local[_e715];
                                        phi_1246_ = (_e720 <= _e701.member);
                                        phi_1247_ = _e714;
                                        phi_1248_ = _e718;
                                    }
                                    let _e724 = phi_1246_;
                                    let _e726 = phi_1247_;
                                    let _e728 = phi_1248_;
                                    if _e724 {
                                        let _e731 = ((_e728 & 2147483648u) != 0u);
                                        if _e731 {
                                            phi_1263_ = _e701;
                                            phi_1266_ = type_8(0u, ((_e728 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e738 = phi_1263_;
                                                let _e740 = phi_1266_;
                                                local_3 = _e738;
                                                if (_e740.member < _e740.member_1) {
                                                    phi_1267_ = type_8((_e740.member + 1u), _e740.member_1);
                                                    phi_1289_ = type_8(1u, _e740.member);
                                                } else {
                                                    phi_1267_ = _e740;
                                                    phi_1289_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e753 = phi_1267_;
                                                let _e755 = phi_1289_;
                                                let _e759 = (bitcast<i32>(_e755.member) != 0i);
                                                if _e759 {
                                                    let _e760 = ((_e728 & 268435455u) + _e755.member_1);
                                                    let _e761 = (_e760 < _e85);
                                                    if _e761 {
                                                        if _e761 {
                                                        } else {
                                                            phi_3291_ = true;
                                                            break;
                                                        }
                                                        let _e765 = global_2.member[_e760].member_1;
                                                        phi_1310_ = _e765;
                                                    } else {
                                                        phi_1310_ = 4294967295u;
                                                    }
                                                    let _e767 = phi_1310_;
                                                    if (_e760 >= _e85) {
                                                        phi_1402_ = array<array<f32, 3>, 3>(array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f), array<f32, 3>(0f, 0f, 0f));
                                                    } else {
                                                        if _e761 {
                                                        } else {
                                                            phi_3291_ = true;
                                                            break;
                                                        }
                                                        let _e769 = (_e373 % 3u);
                                                        let _e770 = (_e372 % 3u);
                                                        let _e771 = (_e374 % 3u);
                                                        if (_e769 < 9u) {
                                                        } else {
                                                            phi_3291_ = true;
                                                            break;
                                                        }
                                                        let _e777 = global_2.member[_e760].member[_e769];
                                                        if (_e770 < 9u) {
                                                        } else {
                                                            phi_3291_ = true;
                                                            break;
                                                        }
                                                        let _e783 = global_2.member[_e760].member[_e770];
                                                        if (_e771 < 9u) {
                                                        } else {
                                                            phi_3291_ = true;
                                                            break;
                                                        }
                                                        let _e789 = global_2.member[_e760].member[_e771];
                                                        let _e791 = (3u + _e769);
                                                        if (_e791 < 9u) {
                                                        } else {
                                                            phi_3291_ = true;
                                                            break;
                                                        }
                                                        let _e797 = global_2.member[_e760].member[_e791];
                                                        let _e798 = (3u + _e770);
                                                        if (_e798 < 9u) {
                                                        } else {
                                                            phi_3291_ = true;
                                                            break;
                                                        }
                                                        let _e804 = global_2.member[_e760].member[_e798];
                                                        let _e805 = (3u + _e771);
                                                        if (_e805 < 9u) {
                                                        } else {
                                                            phi_3291_ = true;
                                                            break;
                                                        }
                                                        let _e811 = global_2.member[_e760].member[_e805];
                                                        let _e813 = (6u + _e769);
                                                        if (_e813 < 9u) {
                                                        } else {
                                                            phi_3291_ = true;
                                                            break;
                                                        }
                                                        let _e819 = global_2.member[_e760].member[_e813];
                                                        let _e820 = (6u + _e770);
                                                        if (_e820 < 9u) {
                                                        } else {
                                                            phi_3291_ = true;
                                                            break;
                                                        }
                                                        let _e826 = global_2.member[_e760].member[_e820];
                                                        let _e827 = (6u + _e771);
                                                        if (_e827 < 9u) {
                                                        } else {
                                                            phi_3291_ = true;
                                                            break;
                                                        }
                                                        let _e833 = global_2.member[_e760].member[_e827];
                                                        phi_1402_ = array<array<f32, 3>, 3>(array<f32, 3>(_e777, _e783, _e789), array<f32, 3>(_e797, _e804, _e811), array<f32, 3>(_e819, _e826, _e833));
                                                    }
                                                    let _e837 = phi_1402_;
                                                    let _e853 = (_e837[0][2] - _e549);
                                                    let _e856 = (((_e837[0][0] - _e420) * _e585) - (_e853 * _e457));
                                                    let _e859 = (((_e837[0][1] - _e485) * _e585) - (_e853 * _e521));
                                                    let _e862 = (_e837[1][2] - _e549);
                                                    let _e865 = (((_e837[1][0] - _e420) * _e585) - (_e862 * _e457));
                                                    let _e868 = (((_e837[1][1] - _e485) * _e585) - (_e862 * _e521));
                                                    let _e871 = (_e837[2][2] - _e549);
                                                    let _e874 = (((_e837[2][0] - _e420) * _e585) - (_e871 * _e457));
                                                    let _e877 = (((_e837[2][1] - _e485) * _e585) - (_e871 * _e521));
                                                    let _e878 = (_e874 * _e868);
                                                    let _e879 = (_e877 * _e865);
                                                    let _e880 = (_e856 * _e877);
                                                    let _e881 = (_e859 * _e874);
                                                    let _e882 = (_e865 * _e859);
                                                    let _e883 = (_e868 * _e856);
                                                    let _e888 = (((_e878 >= _e879) && (_e880 >= _e881)) && (_e882 >= _e883));
                                                    let _e894 = (_e888 || (((_e878 <= _e879) && (_e880 <= _e881)) && (_e882 <= _e883)));
                                                    if _e894 {
                                                        let _e896 = select(-1f, 1f, _e888);
                                                        let _e898 = ((_e878 - _e879) * _e896);
                                                        let _e900 = select(0f, _e898, (_e898 > 0f));
                                                        let _e902 = ((_e880 - _e881) * _e896);
                                                        let _e904 = select(0f, _e902, (_e902 > 0f));
                                                        let _e906 = ((_e882 - _e883) * _e896);
                                                        let _e908 = select(0f, _e906, (_e906 > 0f));
                                                        let _e910 = ((_e900 + _e904) + _e908);
                                                        let _e912 = select(_e837[1][0], _e837[0][0], (_e837[0][0] < _e837[1][0]));
                                                        let _e916 = select(_e837[1][0], _e837[0][0], (_e837[0][0] > _e837[1][0]));
                                                        let _e920 = select(_e837[1][1], _e837[0][1], (_e837[0][1] < _e837[1][1]));
                                                        let _e924 = select(_e837[1][1], _e837[0][1], (_e837[0][1] > _e837[1][1]));
                                                        let _e928 = select(_e837[1][2], _e837[0][2], (_e837[0][2] < _e837[1][2]));
                                                        let _e932 = select(_e837[1][2], _e837[0][2], (_e837[0][2] > _e837[1][2]));
                                                        let _e937 = ((select(_e837[2][0], _e912, (_e912 < _e837[2][0])) - _e458) * _e461);
                                                        let _e938 = ((select(_e837[2][0], _e916, (_e916 > _e837[2][0])) - _e459) * _e461);
                                                        let _e941 = ((select(_e837[2][1], _e920, (_e920 < _e837[2][1])) - _e522) * _e525);
                                                        let _e942 = ((select(_e837[2][1], _e924, (_e924 > _e837[2][1])) - _e523) * _e525);
                                                        let _e945 = ((select(_e837[2][2], _e928, (_e928 < _e837[2][2])) - _e586) * _e589);
                                                        let _e946 = ((select(_e837[2][2], _e932, (_e932 > _e837[2][2])) - _e587) * _e589);
                                                        let _e948 = select(_e946, _e945, (_e945 < _e946));
                                                        let _e950 = select(_e946, _e945, (_e945 > _e946));
                                                        let _e952 = select(_e938, _e937, (_e937 < _e938));
                                                        let _e954 = select(_e942, _e941, (_e941 < _e942));
                                                        let _e956 = select(_e954, _e952, (_e952 > _e954));
                                                        let _e958 = select(_e948, _e956, (_e956 > _e948));
                                                        let _e960 = select(_e938, _e937, (_e937 > _e938));
                                                        let _e962 = select(_e942, _e941, (_e941 > _e942));
                                                        let _e964 = select(_e962, _e960, (_e960 < _e962));
                                                        let _e966 = select(_e950, _e964, (_e964 < _e950));
                                                        let _e967 = -(_e948);
                                                        let _e973 = select(_e691, _e958, (_e958 > _e691));
                                                        let _e977 = select(_e865, _e856, (_e856 < _e865));
                                                        let _e982 = select(_e865, _e856, (_e856 > _e865));
                                                        let _e989 = select(_e868, _e859, (_e859 < _e868));
                                                        let _e994 = select(_e868, _e859, (_e859 > _e868));
                                                        let _e1003 = (((((_e894 && (_e910 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e874, _e977, (_e977 < _e874)) <= 0f) && (select(_e874, _e982, (_e982 > _e874)) >= 0f))) && ((select(_e877, _e989, (_e989 < _e877)) <= 0f) && (select(_e877, _e994, (_e994 > _e877)) >= 0f))) && (_e973 <= (_e966 + (select(_e967, _e950, (_e950 > _e967)) * 0.0000019073523f)))) && (_e973 <= _e738.member));
                                                        if _e1003 {
                                                            let _e1008 = (_e837[1][0] - _e837[0][0]);
                                                            let _e1009 = (_e837[1][1] - _e837[0][1]);
                                                            let _e1010 = (_e837[1][2] - _e837[0][2]);
                                                            let _e1011 = vec3<f32>(_e1008, _e1009, _e1010);
                                                            let _e1012 = (_e837[2][0] - _e837[1][0]);
                                                            let _e1013 = (_e837[2][1] - _e837[1][1]);
                                                            let _e1014 = (_e837[2][2] - _e837[1][2]);
                                                            let _e1015 = vec3<f32>(_e1012, _e1013, _e1014);
                                                            let _e1016 = (_e837[0][0] - _e837[2][0]);
                                                            let _e1017 = (_e837[0][1] - _e837[2][1]);
                                                            let _e1018 = (_e837[0][2] - _e837[2][2]);
                                                            let _e1019 = vec3<f32>(_e1016, _e1017, _e1018);
                                                            let _e1020 = abs(_e1008);
                                                            let _e1021 = abs(_e1009);
                                                            if (_e1020 != _e1020) {
                                                                phi_3117_ = true;
                                                            } else {
                                                                phi_3117_ = (_e1021 >= _e1020);
                                                            }
                                                            let _e1025 = phi_3117_;
                                                            let _e1026 = select(_e1020, _e1021, _e1025);
                                                            let _e1027 = abs(_e1010);
                                                            if (_e1026 != _e1026) {
                                                                phi_3132_ = true;
                                                            } else {
                                                                phi_3132_ = (_e1027 >= _e1026);
                                                            }
                                                            let _e1031 = phi_3132_;
                                                            let _e1032 = select(_e1026, _e1027, _e1031);
                                                            let _e1033 = abs(_e1012);
                                                            let _e1034 = abs(_e1013);
                                                            if (_e1033 != _e1033) {
                                                                phi_3147_ = true;
                                                            } else {
                                                                phi_3147_ = (_e1034 >= _e1033);
                                                            }
                                                            let _e1038 = phi_3147_;
                                                            let _e1039 = select(_e1033, _e1034, _e1038);
                                                            let _e1040 = abs(_e1014);
                                                            if (_e1039 != _e1039) {
                                                                phi_3162_ = true;
                                                            } else {
                                                                phi_3162_ = (_e1040 >= _e1039);
                                                            }
                                                            let _e1044 = phi_3162_;
                                                            let _e1045 = select(_e1039, _e1040, _e1044);
                                                            let _e1046 = abs(_e1016);
                                                            let _e1047 = abs(_e1017);
                                                            if (_e1046 != _e1046) {
                                                                phi_3177_ = true;
                                                            } else {
                                                                phi_3177_ = (_e1047 >= _e1046);
                                                            }
                                                            let _e1051 = phi_3177_;
                                                            let _e1052 = select(_e1046, _e1047, _e1051);
                                                            let _e1053 = abs(_e1018);
                                                            if (_e1052 != _e1052) {
                                                                phi_3192_ = true;
                                                            } else {
                                                                phi_3192_ = (_e1053 >= _e1052);
                                                            }
                                                            let _e1057 = phi_3192_;
                                                            let _e1058 = select(_e1052, _e1053, _e1057);
                                                            let _e1060 = select(_e1045, _e1032, (_e1032 > _e1045));
                                                            let _e1062 = select(_e1058, _e1060, (_e1060 > _e1058));
                                                            if (_e1032 == _e1062) {
                                                                phi_1944_ = _e868;
                                                                phi_1945_ = _e865;
                                                                phi_1946_ = _e859;
                                                                phi_1947_ = _e856;
                                                                phi_1948_ = vec3<f32>(_e837[0][0], _e837[0][1], _e837[0][2]);
                                                                phi_1949_ = _e1019;
                                                                phi_1950_ = _e1015;
                                                                phi_1951_ = _e1011;
                                                            } else {
                                                                let _e1064 = (_e1045 == _e1062);
                                                                let _e1069 = vec3(_e1064);
                                                                phi_1944_ = select(_e859, _e877, _e1064);
                                                                phi_1945_ = select(_e856, _e874, _e1064);
                                                                phi_1946_ = select(_e877, _e868, _e1064);
                                                                phi_1947_ = select(_e874, _e865, _e1064);
                                                                phi_1948_ = select(vec3<f32>(_e837[2][0], _e837[2][1], _e837[2][2]), vec3<f32>(_e837[1][0], _e837[1][1], _e837[1][2]), _e1069);
                                                                phi_1949_ = select(_e1015, _e1011, _e1069);
                                                                phi_1950_ = select(_e1011, _e1019, _e1069);
                                                                phi_1951_ = select(_e1019, _e1015, _e1069);
                                                            }
                                                            let _e1075 = phi_1944_;
                                                            let _e1077 = phi_1945_;
                                                            let _e1079 = phi_1946_;
                                                            let _e1081 = phi_1947_;
                                                            let _e1083 = phi_1948_;
                                                            let _e1085 = phi_1949_;
                                                            let _e1087 = phi_1950_;
                                                            let _e1089 = phi_1951_;
                                                            let _e1096 = ((_e1087.y * _e1085.z) - (_e1085.y * _e1087.z));
                                                            let _e1101 = ((_e1087.z * _e1085.x) - (_e1085.z * _e1087.x));
                                                            let _e1104 = ((_e1087.x * _e1085.y) - (_e1085.x * _e1087.y));
                                                            let _e1107 = ((_e900 >= _e904) && (_e900 >= _e908));
                                                            let _e1108 = (_e904 >= _e908);
                                                            let _e1122 = (((_e1096 * (select(select(_e837[2][0], _e837[1][0], _e1108), _e837[0][0], _e1107) - _e420)) + (_e1101 * (select(select(_e837[2][1], _e837[1][1], _e1108), _e837[0][1], _e1107) - _e485))) + (_e1104 * (select(select(_e837[2][2], _e837[1][2], _e1108), _e837[0][2], _e1107) - _e549)));
                                                            let _e1127 = (((_e1096 * _e457) + (_e1101 * _e521)) + (_e1104 * _e585));
                                                            let _e1128 = (_e1077 - _e1081);
                                                            let _e1129 = (_e1075 - _e1079);
                                                            let _e1132 = ((_e1128 * _e1128) + (_e1129 * _e1129));
                                                            let _e1139 = (-(((_e1081 * _e1128) + (_e1079 * _e1129))) / select(0.000000000000000000000000000000000000011754944f, _e1132, (_e1132 > 0.000000000000000000000000000000000000011754944f)));
                                                            let _e1141 = select(1f, _e1139, (_e1139 < 1f));
                                                            let _e1143 = select(0f, _e1141, (_e1141 > 0f));
                                                            let _e1152 = ((_e1083.x + (_e1089.x * _e1143)) - _e420);
                                                            let _e1155 = ((_e1083.y + (_e1089.y * _e1143)) - _e485);
                                                            let _e1158 = ((_e1083.z + (_e1089.z * _e1143)) - _e549);
                                                            let _e1161 = bitcast<f32>((bitcast<u32>(_e1152) & 2147483647u));
                                                            let _e1164 = bitcast<f32>((bitcast<u32>(_e1155) & 2147483647u));
                                                            let _e1166 = select(_e1164, _e1161, (_e1161 > _e1164));
                                                            let _e1169 = bitcast<f32>((bitcast<u32>(_e1158) & 2147483647u));
                                                            let _e1171 = select(_e1169, _e1166, (_e1166 > _e1169));
                                                            let _e1175 = abs(_e1096);
                                                            let _e1176 = abs(_e1101);
                                                            if (_e1175 != _e1175) {
                                                                phi_3207_ = true;
                                                            } else {
                                                                phi_3207_ = (_e1176 >= _e1175);
                                                            }
                                                            let _e1180 = phi_3207_;
                                                            let _e1181 = select(_e1175, _e1176, _e1180);
                                                            let _e1182 = abs(_e1104);
                                                            if (_e1181 != _e1181) {
                                                                phi_3222_ = true;
                                                            } else {
                                                                phi_3222_ = (_e1182 >= _e1181);
                                                            }
                                                            let _e1186 = phi_3222_;
                                                            let _e1202 = abs(_e1087.x);
                                                            let _e1203 = abs(_e1087.y);
                                                            if (_e1202 != _e1202) {
                                                                phi_3237_ = true;
                                                            } else {
                                                                phi_3237_ = (_e1203 >= _e1202);
                                                            }
                                                            let _e1207 = phi_3237_;
                                                            let _e1208 = select(_e1202, _e1203, _e1207);
                                                            let _e1209 = abs(_e1087.z);
                                                            if (_e1208 != _e1208) {
                                                                phi_3252_ = true;
                                                            } else {
                                                                phi_3252_ = (_e1209 >= _e1208);
                                                            }
                                                            let _e1213 = phi_3252_;
                                                            let _e1216 = abs(_e1085.x);
                                                            let _e1217 = abs(_e1085.y);
                                                            if (_e1216 != _e1216) {
                                                                phi_3267_ = true;
                                                            } else {
                                                                phi_3267_ = (_e1217 >= _e1216);
                                                            }
                                                            let _e1221 = phi_3267_;
                                                            let _e1222 = select(_e1216, _e1217, _e1221);
                                                            let _e1223 = abs(_e1085.z);
                                                            if (_e1222 != _e1222) {
                                                                phi_3282_ = true;
                                                            } else {
                                                                phi_3282_ = (_e1223 >= _e1222);
                                                            }
                                                            let _e1227 = phi_3282_;
                                                            let _e1232 = ((bitcast<f32>((bitcast<u32>(((((_e1096 * _e1152) + (_e1101 * _e1155)) + (_e1104 * _e1158)) - _e1122)) & 2147483647u)) <= ((0.0000009536743f * select(_e1062, _e1171, (_e1171 > _e1062))) * select(_e1181, _e1182, _e1186))) && !((bitcast<f32>((bitcast<u32>(_e1127) & 2147483647u)) <= ((0.0000038146973f * select(_e1208, _e1209, _e1213)) * select(_e1222, _e1223, _e1227)))));
                                                            let _e1233 = (_e1122 / _e1127);
                                                            if (_e1003 && !(_e1232)) {
                                                                let _e1236 = (_e1158 / _e585);
                                                                let _e1244 = (((_e1096 * (_e1152 - (_e457 * _e1236))) + (_e1101 * (_e1155 - (_e521 * _e1236)))) / _e1127);
                                                                phi_2159_ = select(select(_e1236, (_e1236 + _e1244), (bitcast<f32>((bitcast<u32>(_e1244) & 2147483647u)) <= _e1062)), _e1233, _e1232);
                                                            } else {
                                                                phi_2159_ = _e1233;
                                                            }
                                                            let _e1253 = phi_2159_;
                                                            let _e1255 = select(_e966, _e1253, (_e1253 < _e966));
                                                            let _e1257 = select(_e958, _e1255, (_e1255 > _e958));
                                                            let _e1258 = (1f / _e910);
                                                            phi_2179_ = type_54(_e1257, (_e904 * _e1258), (_e908 * _e1258), ((_e1003 && (_e1257 >= _e691)) && (_e1257 <= _e738.member)));
                                                            phi_2180_ = type_54();
                                                        } else {
                                                            phi_2179_ = type_54();
                                                            phi_2180_ = type_54(0f, 0f, 0f, _e1003);
                                                        }
                                                        let _e1267 = phi_2179_;
                                                        let _e1269 = phi_2180_;
                                                        phi_2183_ = _e1267;
                                                        phi_2184_ = _e1269;
                                                        phi_2185_ = select(true, false, _e1003);
                                                    } else {
                                                        phi_2183_ = type_54();
                                                        phi_2184_ = type_54(0f, 0f, 0f, _e894);
                                                        phi_2185_ = true;
                                                    }
                                                    let _e1272 = phi_2183_;
                                                    let _e1274 = phi_2184_;
                                                    let _e1276 = phi_2185_;
                                                    if _e1276 {
                                                        phi_2189_ = _e1274;
                                                    } else {
                                                        phi_2189_ = _e1272;
                                                    }
                                                    let _e1278 = phi_2189_;
                                                    if _e1278.member_3 {
                                                        phi_2198_ = type_28(_e1278.member, _e1278.member_1, _e1278.member_2, _e767);
                                                    } else {
                                                        phi_2198_ = type_28(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    }
                                                    let _e1285 = phi_2198_;
                                                    if (_e1285.member_3 != 4294967295u) {
                                                        if (_e767 == _e108) {
                                                            phi_2533_ = false;
                                                        } else {
                                                            let _e1289 = (_e767 < arrayLength((&global_5.member)));
                                                            if _e1289 {
                                                                if _e1289 {
                                                                } else {
                                                                    phi_3291_ = true;
                                                                    break;
                                                                }
                                                                let _e1291 = global_5.member[_e767];
                                                                phi_2221_ = _e1291;
                                                            } else {
                                                                phi_2221_ = 4294967295u;
                                                            }
                                                            let _e1293 = phi_2221_;
                                                            let _e1294 = (_e1293 < arrayLength((&global_6.member)));
                                                            if _e1294 {
                                                                if _e1294 {
                                                                } else {
                                                                    phi_3291_ = true;
                                                                    break;
                                                                }
                                                                let _e1296 = global_6.member[_e1293];
                                                                phi_2235_ = _e1296;
                                                            } else {
                                                                phi_2235_ = 0i;
                                                            }
                                                            let _e1298 = phi_2235_;
                                                            let _e1299 = (_e1298 == 0i);
                                                            if _e1299 {
                                                                phi_2532_ = true;
                                                            } else {
                                                                if _e397 {
                                                                    phi_2258_ = vec3<f32>(_e837[0][0], _e837[0][1], _e837[0][2]);
                                                                } else {
                                                                    if (_e373 == 1u) {
                                                                        phi_2257_ = vec3<f32>(_e837[0][2], _e837[0][0], _e837[0][1]);
                                                                    } else {
                                                                        phi_2257_ = vec3<f32>(_e837[0][1], _e837[0][2], _e837[0][0]);
                                                                    }
                                                                    let _e1304 = phi_2257_;
                                                                    phi_2258_ = _e1304;
                                                                }
                                                                let _e1307 = phi_2258_;
                                                                if _e397 {
                                                                    phi_2277_ = vec3<f32>(_e837[1][0], _e837[1][1], _e837[1][2]);
                                                                } else {
                                                                    if (_e373 == 1u) {
                                                                        phi_2276_ = vec3<f32>(_e837[1][2], _e837[1][0], _e837[1][1]);
                                                                    } else {
                                                                        phi_2276_ = vec3<f32>(_e837[1][1], _e837[1][2], _e837[1][0]);
                                                                    }
                                                                    let _e1312 = phi_2276_;
                                                                    phi_2277_ = _e1312;
                                                                }
                                                                let _e1315 = phi_2277_;
                                                                if _e397 {
                                                                    phi_2296_ = vec3<f32>(_e837[2][0], _e837[2][1], _e837[2][2]);
                                                                } else {
                                                                    if (_e373 == 1u) {
                                                                        phi_2295_ = vec3<f32>(_e837[2][2], _e837[2][0], _e837[2][1]);
                                                                    } else {
                                                                        phi_2295_ = vec3<f32>(_e837[2][1], _e837[2][2], _e837[2][0]);
                                                                    }
                                                                    let _e1320 = phi_2295_;
                                                                    phi_2296_ = _e1320;
                                                                }
                                                                let _e1323 = phi_2296_;
                                                                let _e1326 = (_e1315.x - _e1307.x);
                                                                let _e1329 = (_e1315.y - _e1307.y);
                                                                let _e1332 = (_e1315.z - _e1307.z);
                                                                let _e1334 = (_e1323.x - _e1307.x);
                                                                let _e1336 = (_e1323.y - _e1307.y);
                                                                let _e1338 = (_e1323.z - _e1307.z);
                                                                if (_e240.member_1 == 1u) {
                                                                    phi_2332_ = (vec3<f32>(_e240.member[0], _e240.member[1], _e240.member[2]) - _e1307);
                                                                } else {
                                                                    phi_2332_ = vec3<f32>(_e240.member[0], _e240.member[1], _e240.member[2]);
                                                                }
                                                                let _e1353 = phi_2332_;
                                                                let _e1359 = bitcast<f32>((bitcast<u32>((_e1326 * _e1336)) ^ _e240.member_3[0]));
                                                                let _e1363 = bitcast<f32>((bitcast<u32>((_e1329 * _e1334)) ^ _e240.member_3[0]));
                                                                let _e1367 = bitcast<f32>((bitcast<u32>((_e1329 * _e1338)) ^ _e240.member_3[0]));
                                                                let _e1371 = bitcast<f32>((bitcast<u32>((_e1332 * _e1336)) ^ _e240.member_3[0]));
                                                                let _e1375 = bitcast<f32>((bitcast<u32>((_e1332 * _e1334)) ^ _e240.member_3[0]));
                                                                let _e1379 = bitcast<f32>((bitcast<u32>((_e1326 * _e1338)) ^ _e240.member_3[0]));
                                                                let _e1380 = (_e1367 - _e1371);
                                                                let _e1381 = (_e1375 - _e1379);
                                                                let _e1382 = (_e1359 - _e1363);
                                                                let _e1406 = (bitcast<f32>((bitcast<u32>(_e1367) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1371) & 2147483647u)));
                                                                let _e1413 = (bitcast<f32>((bitcast<u32>(_e1375) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1379) & 2147483647u)));
                                                                let _e1420 = (bitcast<f32>((bitcast<u32>(_e1359) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1363) & 2147483647u)));
                                                                if (_e240.member_2 == 0f) {
                                                                    phi_2514_ = 0f;
                                                                } else {
                                                                    let _e1450 = bitcast<f32>((bitcast<u32>(_e1380) & 2147483647u));
                                                                    let _e1453 = bitcast<f32>((bitcast<u32>(_e1381) & 2147483647u));
                                                                    let _e1456 = bitcast<f32>((bitcast<u32>(_e1382) & 2147483647u));
                                                                    let _e1458 = select(_e1456, _e1453, (_e1453 > _e1456));
                                                                    let _e1462 = select(_e1456, _e1453, (_e1453 < _e1456));
                                                                    let _e1466 = select(_e1453, _e1450, (_e1450 < _e1453));
                                                                    let _e1468 = select(_e1453, _e1450, (_e1450 > _e1453));
                                                                    let _e1470 = select(_e1456, _e1468, (_e1468 < _e1456));
                                                                    phi_2514_ = bitcast<f32>((bitcast<u32>((_e240.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1458, _e1450, (_e1450 > _e1458)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1470, _e1466, (_e1466 > _e1470)))) ^ _e240.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1462, _e1450, (_e1450 < _e1462)))) ^ _e240.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1406 + _e1413) + _e1420))) ^ _e240.member_3[0]))) * 1.0000005f)) ^ _e240.member_3[0])))) ^ _e240.member_3[0]));
                                                                }
                                                                let _e1497 = phi_2514_;
                                                                phi_2532_ = (_e1299 || !(((((bitcast<f32>((bitcast<u32>((_e1353.x * _e1380)) ^ _e240.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1353.y * _e1381)) ^ _e240.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1353.z * _e1382)) ^ _e240.member_3[0]))) * f32(-(_e1298))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1353.x) & 2147483647u)) * _e1406)) ^ _e240.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1353.y) & 2147483647u)) * _e1413)) ^ _e240.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1353.z) & 2147483647u)) * _e1420)) ^ _e240.member_3[0]))))) ^ _e240.member_3[0])) + _e1497) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1511 = phi_2532_;
                                                            phi_2533_ = _e1511;
                                                        }
                                                        let _e1513 = phi_2533_;
                                                        if _e1513 {
                                                            phi_2538_ = type_56(-340282350000000000000000000000000000000f, true);
                                                        } else {
                                                            phi_2538_ = _e738;
                                                        }
                                                        let _e1515 = phi_2538_;
                                                        phi_2539_ = _e1515;
                                                    } else {
                                                        phi_2539_ = _e738;
                                                    }
                                                    let _e1517 = phi_2539_;
                                                    phi_1264_ = _e1517;
                                                } else {
                                                    phi_1264_ = type_56();
                                                }
                                                let _e1519 = phi_1264_;
                                                continue;
                                                continuing {
                                                    phi_1263_ = _e1519;
                                                    phi_1266_ = _e753;
                                                    phi_3291_ = _e699;
                                                    break if !(_e759);
                                                }
                                            }
                                            let _e1522 = phi_3291_;
                                            phi_3488_ = _e1522;
                                            if _e1522 {
                                                break;
                                            }
                                            phi_3523_ = _e1522;
                                            let _e1893 = local_3;
                                            phi_2540_ = _e1893;
                                        } else {
                                            phi_3523_ = _e699;
                                            phi_2540_ = _e701;
                                        }
                                        let _e1524 = phi_3523_;
                                        let _e1526 = phi_2540_;
                                        if _e731 {
                                            phi_3020_ = bool();
                                            phi_3021_ = u32();
                                            phi_3022_ = u32();
                                        } else {
                                            if (_e728 >= _e83) {
                                                phi_2605_ = type_55(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u, 2147483648u);
                                            } else {
                                                if (_e728 < _e83) {
                                                } else {
                                                    phi_3488_ = true;
                                                    break;
                                                }
                                                let _e1529 = (_e373 % 3u);
                                                if (_e1529 < 3u) {
                                                } else {
                                                    phi_3488_ = true;
                                                    break;
                                                }
                                                let _e1535 = global_4.member[_e728].member[_e1529];
                                                let _e1541 = (_e372 % 3u);
                                                if (_e1541 < 3u) {
                                                } else {
                                                    phi_3488_ = true;
                                                    break;
                                                }
                                                let _e1547 = global_4.member[_e728].member[_e1541];
                                                let _e1553 = (_e374 % 3u);
                                                if (_e1553 < 3u) {
                                                } else {
                                                    phi_3488_ = true;
                                                    break;
                                                }
                                                let _e1559 = global_4.member[_e728].member[_e1553];
                                                let _e1569 = global_4.member[_e728].member_1;
                                                let _e1573 = global_4.member[_e728].member_2;
                                                phi_2605_ = type_55(array<vec4<f32>, 3>(vec4<f32>(_e1535[0], _e1535[1], _e1535[2], _e1535[3]), vec4<f32>(_e1547[0], _e1547[1], _e1547[2], _e1547[3]), vec4<f32>(_e1559[0], _e1559[1], _e1559[2], _e1559[3])), _e1569, _e1573);
                                            }
                                            let _e1576 = phi_2605_;
                                            let _e1588 = ((_e1576.member[0].x - _e458) * _e461);
                                            let _e1589 = ((_e1576.member[0].y - _e458) * _e461);
                                            let _e1590 = ((_e1576.member[0].z - _e459) * _e461);
                                            let _e1591 = ((_e1576.member[0].w - _e459) * _e461);
                                            let _e1601 = ((_e1576.member[1].x - _e522) * _e525);
                                            let _e1602 = ((_e1576.member[1].y - _e522) * _e525);
                                            let _e1603 = ((_e1576.member[1].z - _e523) * _e525);
                                            let _e1604 = ((_e1576.member[1].w - _e523) * _e525);
                                            let _e1614 = ((_e1576.member[2].x - _e586) * _e589);
                                            let _e1615 = ((_e1576.member[2].y - _e586) * _e589);
                                            let _e1616 = ((_e1576.member[2].z - _e587) * _e589);
                                            let _e1617 = ((_e1576.member[2].w - _e587) * _e589);
                                            let _e1619 = select(_e1616, _e1614, (_e1614 < _e1616));
                                            let _e1621 = select(_e1617, _e1615, (_e1615 < _e1617));
                                            let _e1623 = select(_e1616, _e1614, (_e1614 > _e1616));
                                            let _e1625 = select(_e1617, _e1615, (_e1615 > _e1617));
                                            let _e1627 = select(_e1590, _e1588, (_e1588 < _e1590));
                                            let _e1629 = select(_e1591, _e1589, (_e1589 < _e1591));
                                            let _e1631 = select(_e1603, _e1601, (_e1601 < _e1603));
                                            let _e1633 = select(_e1604, _e1602, (_e1602 < _e1604));
                                            let _e1635 = select(_e1631, _e1627, (_e1627 > _e1631));
                                            let _e1637 = select(_e1633, _e1629, (_e1629 > _e1633));
                                            let _e1639 = select(_e1619, _e1635, (_e1635 > _e1619));
                                            let _e1641 = select(_e1621, _e1637, (_e1637 > _e1621));
                                            let _e1643 = select(_e1590, _e1588, (_e1588 > _e1590));
                                            let _e1645 = select(_e1591, _e1589, (_e1589 > _e1591));
                                            let _e1647 = select(_e1603, _e1601, (_e1601 > _e1603));
                                            let _e1649 = select(_e1604, _e1602, (_e1602 > _e1604));
                                            let _e1651 = select(_e1647, _e1643, (_e1643 < _e1647));
                                            let _e1653 = select(_e1649, _e1645, (_e1645 < _e1649));
                                            let _e1658 = -(_e1619);
                                            let _e1659 = -(_e1621);
                                            let _e1666 = (select(_e1623, _e1651, (_e1651 < _e1623)) + (select(_e1658, _e1623, (_e1623 > _e1658)) * 0.0000019073523f));
                                            let _e1667 = (select(_e1625, _e1653, (_e1653 < _e1625)) + (select(_e1659, _e1625, (_e1625 > _e1659)) * 0.0000019073523f));
                                            let _e1669 = select(_e691, _e1639, (_e1639 > _e691));
                                            let _e1671 = select(_e691, _e1641, (_e1641 > _e691));
                                            let _e1676 = (_e1669 <= select(_e1526.member, _e1666, (_e1666 < _e1526.member)));
                                            let _e1677 = (_e1671 <= select(_e1526.member, _e1667, (_e1667 < _e1526.member)));
                                            let _e1678 = (_e1669 <= _e1671);
                                            if _e1676 {
                                                if _e1677 {
                                                    if _e1678 {
                                                        phi_2967_ = _e1576.member_2;
                                                    } else {
                                                        phi_2967_ = _e1576.member_1;
                                                    }
                                                    let _e1682 = phi_2967_;
                                                    let _e1684 = (_e726 % 128u);
                                                    let _e1685 = (_e1684 < 128u);
                                                    if _e1685 {
                                                    } else {
                                                        phi_3488_ = true;
                                                        break;
                                                    }
                                                    local_1[_e1684] = _e1682;
                                                    if _e1685 {
                                                    } else {
                                                        phi_3488_ = true;
                                                        break;
                                                    }
                                                    local[_e1684] = select(_e1669, _e1671, _e1678);
                                                    if _e1678 {
                                                        phi_2994_ = _e1576.member_1;
                                                    } else {
                                                        phi_2994_ = _e1576.member_2;
                                                    }
                                                    let _e1692 = phi_2994_;
                                                    phi_2995_ = (_e726 + 1u);
                                                    phi_2996_ = _e1692;
                                                } else {
                                                    phi_2995_ = u32();
                                                    phi_2996_ = u32();
                                                }
                                                let _e1694 = phi_2995_;
                                                let _e1696 = phi_2996_;
                                                phi_2998_ = _e1694;
                                                phi_2999_ = _e1696;
                                                phi_3000_ = select(true, false, _e1677);
                                            } else {
                                                phi_2998_ = u32();
                                                phi_2999_ = u32();
                                                phi_3000_ = true;
                                            }
                                            let _e1699 = phi_2998_;
                                            let _e1701 = phi_2999_;
                                            let _e1703 = phi_3000_;
                                            if _e1703 {
                                                if _e1676 {
                                                    phi_3009_ = _e1576.member_1;
                                                } else {
                                                    phi_3009_ = _e1576.member_2;
                                                }
                                                let _e1707 = phi_3009_;
                                                phi_3014_ = select(_e1677, true, _e1676);
                                                phi_3016_ = _e1707;
                                            } else {
                                                phi_3014_ = _e724;
                                                phi_3016_ = _e1701;
                                            }
                                            let _e1710 = phi_3014_;
                                            let _e1712 = phi_3016_;
                                            phi_3020_ = _e1710;
                                            phi_3021_ = select(_e1699, _e726, _e1703);
                                            phi_3022_ = _e1712;
                                        }
                                        let _e1715 = phi_3020_;
                                        let _e1717 = phi_3021_;
                                        let _e1719 = phi_3022_;
                                        if _e731 {
                                            phi_3032_ = select(_e726, 0u, _e1526.member_1);
                                        } else {
                                            phi_3032_ = _e1717;
                                        }
                                        let _e1723 = phi_3032_;
                                        phi_3491_ = _e1524;
                                        phi_3034_ = _e1526;
                                        phi_3035_ = (_e703 - 1u);
                                        phi_3036_ = select(_e1715, false, _e731);
                                        phi_3037_ = _e1723;
                                        phi_3038_ = select(_e1719, _e728, _e731);
                                    } else {
                                        phi_3491_ = _e699;
                                        phi_3034_ = _e701;
                                        phi_3035_ = _e703;
                                        phi_3036_ = _e724;
                                        phi_3037_ = _e726;
                                        phi_3038_ = _e728;
                                    }
                                    let _e1727 = phi_3491_;
                                    let _e1729 = phi_3034_;
                                    let _e1731 = phi_3035_;
                                    let _e1733 = phi_3036_;
                                    let _e1735 = phi_3037_;
                                    let _e1737 = phi_3038_;
                                    phi_3490_ = _e1727;
                                    phi_3039_ = _e1729;
                                    phi_3040_ = _e1731;
                                    phi_3041_ = _e1733;
                                    phi_3042_ = _e1735;
                                    phi_3043_ = _e1737;
                                } else {
                                    phi_3490_ = _e699;
                                    phi_3039_ = type_56();
                                    phi_3040_ = u32();
                                    phi_3041_ = bool();
                                    phi_3042_ = u32();
                                    phi_3043_ = u32();
                                }
                                let _e1739 = phi_3490_;
                                let _e1741 = phi_3039_;
                                let _e1743 = phi_3040_;
                                let _e1745 = phi_3041_;
                                let _e1747 = phi_3042_;
                                let _e1749 = phi_3043_;
                                phi_3489_ = _e1739;
                                phi_1195_ = _e1741;
                                phi_1198_ = _e1743;
                                phi_1200_ = _e1745;
                                phi_1202_ = _e1747;
                                phi_1204_ = _e1749;
                                phi_3044_ = _e713;
                            } else {
                                phi_3489_ = _e699;
                                phi_1195_ = type_56();
                                phi_1198_ = u32();
                                phi_1200_ = bool();
                                phi_1202_ = u32();
                                phi_1204_ = u32();
                                phi_3044_ = false;
                            }
                            let _e1751 = phi_3489_;
                            let _e1753 = phi_1195_;
                            let _e1755 = phi_1198_;
                            let _e1757 = phi_1200_;
                            let _e1759 = phi_1202_;
                            let _e1761 = phi_1204_;
                            let _e1763 = phi_3044_;
                            continue;
                            continuing {
                                phi_3297_ = _e1751;
                                phi_1194_ = _e1753;
                                phi_1197_ = _e1755;
                                phi_1199_ = _e1757;
                                phi_1201_ = _e1759;
                                phi_1203_ = _e1761;
                                phi_3488_ = _e1751;
                                break if !(_e1763);
                            }
                        }
                        let _e1766 = phi_3488_;
                        if _e1766 {
                            break;
                        }
                        let _e1768 = local_2;
                        if _e1768.member_1 {
                        } else {
                            if _e241 {
                            } else {
                                break;
                            }
                            let _e1772 = global_9.member[_e101];
                            if _e102 {
                            } else {
                                break;
                            }
                            let _e1776 = global_8.member[_e101].member_1;
                            if _e241 {
                            } else {
                                break;
                            }
                            global_9.member[_e101] = type_30(_e1772.member, _e1772.member_1, _e1772.member_2, array<f32, 3>((_e1772.member_3[0] + (_e1776[0] * _e1772.member_1[0])), (_e1772.member_3[1] + (_e1776[1] * _e1772.member_1[1])), (_e1772.member_3[2] + (_e1776[2] * _e1772.member_1[2]))), _e1772.member_4);
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
