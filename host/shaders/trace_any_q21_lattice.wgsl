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

struct type_20 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_21 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_24 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_31 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_33 {
    member: array<type_21>,
}

struct type_35 {
    member: f32,
    member_1: bool,
}

struct type_37 {
    member: array<vec4<u32>, 2>,
}

struct type_41 {
    member: array<array<u32, 7>>,
}

struct type_46 {
    member: type_24,
    member_1: u32,
}

struct type_47 {
    member: array<vec4<f32>, 3>,
    member_1: type_46,
    member_2: type_46,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_37;
@group(0) @binding(4) 
var<storage> global_3: type_33;
@group(0) @binding(5) 
var<storage, read_write> global_4: type_4;
@group(0) @binding(2) 
var<storage> global_5: type_41;
@group(0) @binding(3) 
var<storage> global_6: type_4;

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
    var phi_425_: i32;
    var phi_426_: i32;
    var phi_436_: bool;
    var phi_446_: u32;
    var phi_447_: u32;
    var phi_449_: bool;
    var phi_454_: u32;
    var phi_467_: i32;
    var phi_487_: i32;
    var phi_505_: f32;
    var phi_511_: f32;
    var phi_551_: f32;
    var phi_557_: f32;
    var phi_630_: f32;
    var phi_636_: f32;
    var phi_676_: f32;
    var phi_682_: f32;
    var phi_755_: f32;
    var phi_761_: f32;
    var phi_801_: f32;
    var phi_807_: f32;
    var phi_926_: i32;
    var phi_948_: u32;
    var phi_949_: u32;
    var phi_986_: i32;
    var phi_1008_: u32;
    var phi_1009_: u32;
    var phi_1017_: f32;
    var phi_1018_: f32;
    var phi_4422_: bool;
    var phi_1114_: type_35;
    var phi_1117_: bool;
    var phi_1119_: type_46;
    var phi_1121_: u32;
    var phi_1123_: u32;
    var phi_1134_: bool;
    var phi_1220_: bool;
    var phi_1221_: type_46;
    var phi_1222_: u32;
    var phi_3286_: u32;
    var phi_3292_: u32;
    var phi_3546_: u32;
    var phi_3547_: u32;
    var phi_3557_: u32;
    var phi_3559_: u32;
    var phi_3560_: bool;
    var phi_3580_: u32;
    var phi_3581_: u32;
    var phi_3585_: type_47;
    var phi_3947_: type_46;
    var phi_4023_: type_46;
    var phi_4024_: type_46;
    var phi_4025_: u32;
    var phi_4027_: type_46;
    var phi_4028_: u32;
    var phi_4029_: bool;
    var phi_4038_: type_46;
    var phi_4043_: bool;
    var phi_4044_: type_46;
    var phi_1241_: type_35;
    var phi_1244_: type_8;
    var phi_1245_: type_8;
    var phi_1267_: type_8;
    var phi_1308_: u32;
    var phi_1314_: u32;
    var phi_1324_: u32;
    var phi_1340_: u32;
    var phi_1373_: u32;
    var phi_1379_: u32;
    var phi_1845_: u32;
    var phi_1863_: u32;
    var phi_1881_: u32;
    var phi_1904_: u32;
    var phi_1922_: u32;
    var phi_1940_: u32;
    var phi_1963_: u32;
    var phi_1981_: u32;
    var phi_1999_: u32;
    var phi_1553_: u32;
    var phi_1568_: u32;
    var phi_1578_: u32;
    var phi_1599_: u32;
    var phi_1620_: u32;
    var phi_1650_: u32;
    var phi_1665_: u32;
    var phi_1675_: u32;
    var phi_1696_: u32;
    var phi_1717_: u32;
    var phi_1747_: u32;
    var phi_1762_: u32;
    var phi_1772_: u32;
    var phi_1793_: u32;
    var phi_1814_: u32;
    var phi_1406_: u32;
    var phi_1455_: u32;
    var phi_1504_: u32;
    var phi_2005_: array<array<f32, 3>, 3>;
    var phi_2535_: f32;
    var phi_2536_: f32;
    var phi_2537_: f32;
    var phi_2538_: f32;
    var phi_2539_: vec3<f32>;
    var phi_2540_: vec3<f32>;
    var phi_2541_: vec3<f32>;
    var phi_2542_: vec3<f32>;
    var phi_2733_: f32;
    var phi_2753_: type_31;
    var phi_2754_: type_31;
    var phi_2757_: type_31;
    var phi_2758_: type_31;
    var phi_2759_: bool;
    var phi_2763_: type_31;
    var phi_2772_: type_20;
    var phi_2783_: type_35;
    var phi_2784_: type_35;
    var phi_1242_: type_35;
    var phi_4416_: bool;
    var local_10: type_35;
    var phi_4617_: bool;
    var phi_4046_: type_35;
    var phi_4047_: bool;
    var phi_4048_: type_46;
    var phi_4049_: u32;
    var phi_4616_: bool;
    var phi_4050_: type_35;
    var phi_4051_: bool;
    var phi_4052_: type_46;
    var phi_4053_: u32;
    var phi_4054_: u32;
    var phi_4615_: bool;
    var phi_4055_: type_35;
    var phi_4056_: bool;
    var phi_4057_: type_46;
    var phi_4058_: u32;
    var phi_4059_: u32;
    var phi_4614_: bool;
    var phi_1115_: type_35;
    var phi_1118_: bool;
    var phi_1120_: type_46;
    var phi_1122_: u32;
    var phi_1124_: u32;
    var phi_4060_: bool;
    var phi_4613_: bool;
    var local_11: type_35;
    var local_12: type_35;

    switch bitcast<i32>(0u) {
        default: {
            let _e92 = global;
            let _e94 = arrayLength((&global_5.member));
            let _e97 = arrayLength((&global_6.member));
            let _e105 = global_2.member[0u][0u];
            let _e109 = global_2.member[0u][1u];
            let _e113 = global_2.member[0u][2u];
            let _e117 = global_2.member[0u][3u];
            let _e121 = global_2.member[1u][0u];
            let _e125 = global_2.member[1u][1u];
            let _e129 = global_2.member[1u][2u];
            let _e132 = global_1.member[0u];
            let _e133 = bitcast<i32>(_e132);
            let _e145 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e117) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e105), bitcast<i32>(_e109), bitcast<i32>(_e113));
            local = array<i32, 3>(bitcast<i32>(_e121), bitcast<i32>(_e125), bitcast<i32>(_e129));
            let _e151 = (_e92.x + (_e92.y * 2097152u));
            let _e152 = (_e151 < arrayLength((&global_3.member)));
            if _e152 {
                let _e153 = (_e151 < arrayLength((&global_4.member)));
                if _e153 {
                    if _e152 {
                    } else {
                        break;
                    }
                    let _e161 = global_3.member[_e151].member_2[0u];
                    let _e163 = (bitcast<u32>(_e161) & 2147483647u);
                    let _e168 = global_3.member[_e151].member_2[1u];
                    let _e170 = (bitcast<u32>(_e168) & 2147483647u);
                    let _e175 = global_3.member[_e151].member_2[2u];
                    let _e177 = (bitcast<u32>(_e175) & 2147483647u);
                    let _e182 = global_3.member[_e151].member[0u];
                    let _e184 = (bitcast<u32>(_e182) & 2147483647u);
                    let _e189 = global_3.member[_e151].member[1u];
                    let _e191 = (bitcast<u32>(_e189) & 2147483647u);
                    let _e196 = global_3.member[_e151].member[2u];
                    let _e198 = (bitcast<u32>(_e196) & 2147483647u);
                    let _e200 = select(_e170, _e163, (_e170 < _e163));
                    let _e202 = select(_e177, _e200, (_e177 < _e200));
                    let _e204 = select(_e184, _e202, (_e184 < _e202));
                    let _e206 = select(_e191, _e204, (_e191 < _e204));
                    let _e208 = select(_e198, _e206, (_e198 < _e206));
                    let _e212 = global_3.member[_e151].member_1;
                    let _e213 = bitcast<u32>(_e212);
                    let _e214 = (_e213 & 2147483647u);
                    let _e221 = global_3.member[_e151].member_3;
                    let _e222 = bitcast<u32>(_e221);
                    let _e223 = (_e222 & 2147483647u);
                    let _e227 = (((select(_e214, _e208, (_e214 < _e208)) < 2139095040u) && (_e223 <= 2139095040u)) && (_e202 > 0u));
                    if _e227 {
                        let _e230 = (bitcast<u32>(bitcast<f32>(_e202)) & 2147483647u);
                        if (_e230 >= 8388608u) {
                            phi_425_ = (bitcast<i32>((_e230 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_425_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e230)), 32u, (_e230 == 0u))));
                        }
                        let _e244 = phi_425_;
                        phi_426_ = _e244;
                    } else {
                        phi_426_ = 0i;
                    }
                    let _e246 = phi_426_;
                    let _e247 = (_e163 == _e202);
                    if _e247 {
                        phi_436_ = true;
                    } else {
                        phi_436_ = (_e170 == _e202);
                    }
                    let _e250 = phi_436_;
                    let _e251 = select(1u, 0u, _e247);
                    if _e250 {
                        let _e252 = (_e251 + 1u);
                        phi_446_ = _e252;
                        phi_447_ = _e252;
                        phi_449_ = select(true, false, (_e252 == 2u));
                    } else {
                        phi_446_ = u32();
                        phi_447_ = 0u;
                        phi_449_ = true;
                    }
                    let _e256 = phi_446_;
                    let _e258 = phi_447_;
                    let _e260 = phi_449_;
                    if _e260 {
                        phi_454_ = (_e258 + 1u);
                    } else {
                        phi_454_ = 0u;
                    }
                    let _e264 = phi_454_;
                    let _e265 = select(_e256, _e258, _e260);
                    let _e266 = select(_e251, select(2u, _e251, _e250), _e260);
                    if (_e133 < -126i) {
                        phi_467_ = -126i;
                    } else {
                        phi_467_ = select(_e133, 127i, (_e133 > 127i));
                    }
                    let _e271 = phi_467_;
                    let _e276 = bitcast<f32>((bitcast<u32>((_e271 + 127i)) << bitcast<u32>(23i)));
                    let _e282 = bitcast<f32>((bitcast<u32>(((_e133 - _e271) + 127i)) << bitcast<u32>(23i)));
                    let _e283 = -(_e246);
                    if (_e283 < -126i) {
                        phi_487_ = -126i;
                    } else {
                        phi_487_ = select(_e283, 127i, (_e283 > 127i));
                    }
                    let _e288 = phi_487_;
                    let _e293 = bitcast<f32>((bitcast<u32>((_e288 + 127i)) << bitcast<u32>(23i)));
                    let _e299 = bitcast<f32>((bitcast<u32>(((_e283 - _e288) + 127i)) << bitcast<u32>(23i)));
                    let _e303 = global_3.member[_e151].member;
                    let _e304 = (_e265 == 0u);
                    if _e304 {
                        phi_505_ = _e303[0];
                    } else {
                        phi_505_ = _e303[1];
                    }
                    let _e308 = phi_505_;
                    let _e309 = (_e265 == 2u);
                    if _e309 {
                        phi_511_ = _e303[2];
                    } else {
                        phi_511_ = _e308;
                    }
                    let _e312 = phi_511_;
                    let _e313 = bitcast<u32>(_e312);
                    let _e315 = ((_e313 & 2139095040u) != 0u);
                    let _e329 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e313 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e313 & 2147483648u))), _e312, _e315) * _e276) * select(0.00000011920929f, 1f, _e315)) * _e282);
                    let _e330 = global_3.member[_e151].member_2;
                    if _e304 {
                        phi_551_ = _e330[0];
                    } else {
                        phi_551_ = _e330[1];
                    }
                    let _e334 = phi_551_;
                    if _e309 {
                        phi_557_ = _e330[2];
                    } else {
                        phi_557_ = _e334;
                    }
                    let _e337 = phi_557_;
                    let _e338 = bitcast<u32>(_e337);
                    let _e340 = ((_e338 & 2139095040u) != 0u);
                    let _e354 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e338 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e338 & 2147483648u))), _e337, _e340) * _e293) * select(0.00000011920929f, 1f, _e340)) * _e299);
                    let _e358 = (bitcast<f32>((bitcast<u32>(_e354) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e361 = bitcast<f32>((bitcast<u32>(_e329) & 2147483647u));
                    let _e362 = (_e361 * 0.00000011920929f);
                    let _e365 = select(select(0.00000000000011368684f, _e362, (_e362 > 0.00000000000011368684f)), 0f, _e358);
                    let _e366 = select(0f, _e354, _e358);
                    let _e367 = (_e329 + _e365);
                    let _e368 = (_e329 - _e365);
                    let _e370 = select(38685626000000000000000000f, (1f / _e354), _e358);
                    let _e371 = (_e264 == 0u);
                    if _e371 {
                        phi_630_ = _e303[0];
                    } else {
                        phi_630_ = _e303[1];
                    }
                    let _e375 = phi_630_;
                    let _e376 = (_e264 == 2u);
                    if _e376 {
                        phi_636_ = _e303[2];
                    } else {
                        phi_636_ = _e375;
                    }
                    let _e379 = phi_636_;
                    let _e380 = bitcast<u32>(_e379);
                    let _e382 = ((_e380 & 2139095040u) != 0u);
                    let _e396 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e380 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e380 & 2147483648u))), _e379, _e382) * _e276) * select(0.00000011920929f, 1f, _e382)) * _e282);
                    if _e371 {
                        phi_676_ = _e330[0];
                    } else {
                        phi_676_ = _e330[1];
                    }
                    let _e400 = phi_676_;
                    if _e376 {
                        phi_682_ = _e330[2];
                    } else {
                        phi_682_ = _e400;
                    }
                    let _e403 = phi_682_;
                    let _e404 = bitcast<u32>(_e403);
                    let _e406 = ((_e404 & 2139095040u) != 0u);
                    let _e420 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e404 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e404 & 2147483648u))), _e403, _e406) * _e293) * select(0.00000011920929f, 1f, _e406)) * _e299);
                    let _e424 = (bitcast<f32>((bitcast<u32>(_e420) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e427 = bitcast<f32>((bitcast<u32>(_e396) & 2147483647u));
                    let _e428 = (_e427 * 0.00000011920929f);
                    let _e431 = select(select(0.00000000000011368684f, _e428, (_e428 > 0.00000000000011368684f)), 0f, _e424);
                    let _e432 = select(0f, _e420, _e424);
                    let _e433 = (_e396 + _e431);
                    let _e434 = (_e396 - _e431);
                    let _e436 = select(38685626000000000000000000f, (1f / _e420), _e424);
                    let _e437 = (_e266 == 0u);
                    if _e437 {
                        phi_755_ = _e303[0];
                    } else {
                        phi_755_ = _e303[1];
                    }
                    let _e441 = phi_755_;
                    let _e442 = (_e266 == 2u);
                    if _e442 {
                        phi_761_ = _e303[2];
                    } else {
                        phi_761_ = _e441;
                    }
                    let _e445 = phi_761_;
                    let _e446 = bitcast<u32>(_e445);
                    let _e448 = ((_e446 & 2139095040u) != 0u);
                    let _e462 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e446 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e446 & 2147483648u))), _e445, _e448) * _e276) * select(0.00000011920929f, 1f, _e448)) * _e282);
                    if _e437 {
                        phi_801_ = _e330[0];
                    } else {
                        phi_801_ = _e330[1];
                    }
                    let _e466 = phi_801_;
                    if _e442 {
                        phi_807_ = _e330[2];
                    } else {
                        phi_807_ = _e466;
                    }
                    let _e469 = phi_807_;
                    let _e470 = bitcast<u32>(_e469);
                    let _e472 = ((_e470 & 2139095040u) != 0u);
                    let _e486 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e470 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e470 & 2147483648u))), _e469, _e472) * _e293) * select(0.00000011920929f, 1f, _e472)) * _e299);
                    let _e490 = (bitcast<f32>((bitcast<u32>(_e486) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e493 = bitcast<f32>((bitcast<u32>(_e462) & 2147483647u));
                    let _e494 = (_e493 * 0.00000011920929f);
                    let _e497 = select(select(0.00000000000011368684f, _e494, (_e494 > 0.00000000000011368684f)), 0f, _e490);
                    let _e498 = select(0f, _e486, _e490);
                    let _e499 = (_e462 + _e497);
                    let _e500 = (_e462 - _e497);
                    let _e502 = select(38685626000000000000000000f, (1f / _e486), _e490);
                    let _e504 = select(_e427, _e361, (_e361 > _e427));
                    let _e507 = (_e133 + _e246);
                    if (_e227 && (select(_e493, _e504, (_e504 > _e493)) <= 1099511600000f)) {
                        let _e517 = ((_e214 & 8388607u) | (select(0u, 1u, ((_e214 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e520 = bitcast<i32>((_e214 >> bitcast<u32>(23i)));
                        let _e524 = (_e517 == 0u);
                        let _e527 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e517)), 32u, _e524)) - 8i);
                        if (_e520 == 255i) {
                            phi_926_ = 255i;
                        } else {
                            phi_926_ = (((_e520 + select(0i, 1i, (_e520 == 0i))) - _e527) + _e507);
                        }
                        let _e535 = phi_926_;
                        let _e545 = (_e535 <= 0i);
                        if _e545 {
                            phi_949_ = u32();
                        } else {
                            if _e524 {
                                phi_948_ = u32();
                            } else {
                                phi_948_ = select(((bitcast<u32>(_e535) << bitcast<u32>(23i)) | ((_e517 << bitcast<u32>(((_e527 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e535 >= 255i));
                            }
                            let _e549 = phi_948_;
                            phi_949_ = _e549;
                        }
                        let _e551 = phi_949_;
                        let _e563 = ((_e223 & 8388607u) | (select(0u, 1u, ((_e223 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e566 = bitcast<i32>((_e223 >> bitcast<u32>(23i)));
                        let _e570 = (_e563 == 0u);
                        let _e573 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e563)), 32u, _e570)) - 8i);
                        if (_e566 == 255i) {
                            phi_986_ = 255i;
                        } else {
                            phi_986_ = (((_e566 + select(0i, 1i, (_e566 == 0i))) - _e573) + _e507);
                        }
                        let _e581 = phi_986_;
                        let _e591 = (_e581 <= 0i);
                        if _e591 {
                            phi_1009_ = u32();
                        } else {
                            if _e570 {
                                phi_1008_ = u32();
                            } else {
                                phi_1008_ = select(((bitcast<u32>(_e581) << bitcast<u32>(23i)) | ((_e563 << bitcast<u32>(((_e573 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e581 >= 255i));
                            }
                            let _e595 = phi_1008_;
                            phi_1009_ = _e595;
                        }
                        let _e597 = phi_1009_;
                        phi_1017_ = bitcast<f32>(((_e222 & 2147483648u) | select(_e597, 0u, select(_e570, true, _e591))));
                        phi_1018_ = bitcast<f32>(((_e213 & 2147483648u) | select(_e551, 0u, select(_e524, true, _e545))));
                    } else {
                        phi_1017_ = 0f;
                        phi_1018_ = 1f;
                    }
                    let _e603 = phi_1017_;
                    let _e605 = phi_1018_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e611 = (_e265 % 3u);
                    let _e612 = (_e611 < 3u);
                    if _e612 {
                    } else {
                        break;
                    }
                    let _e614 = local_1[_e611];
                    let _e617 = (_e264 % 3u);
                    let _e618 = (_e617 < 3u);
                    if _e618 {
                    } else {
                        break;
                    }
                    let _e620 = local_1[_e617];
                    let _e623 = (_e266 % 3u);
                    let _e624 = (_e623 < 3u);
                    if _e624 {
                    } else {
                        break;
                    }
                    let _e626 = local_1[_e623];
                    if _e612 {
                    } else {
                        break;
                    }
                    let _e631 = local[_e611];
                    if _e618 {
                    } else {
                        break;
                    }
                    let _e635 = local[_e617];
                    if _e624 {
                    } else {
                        break;
                    }
                    let _e639 = local[_e623];
                    phi_4422_ = false;
                    phi_1114_ = type_35(_e603, false);
                    phi_1117_ = (_e605 <= _e603);
                    phi_1119_ = type_46(type_24(vec4<f32>((f32(_e614) * _e145), (f32(_e620) * _e145), (f32(_e626) * _e145), 0f), vec4<f32>((f32(_e631) * _e145), (f32(_e635) * _e145), (f32(_e639) * _e145), 0f)), select(0u, 2147483648u, (_e94 == 0u)));
                    phi_1121_ = 0u;
                    phi_1123_ = ((3u * _e94) + 1u);
                    loop {
                        let _e647 = phi_4422_;
                        let _e649 = phi_1114_;
                        let _e651 = phi_1117_;
                        let _e653 = phi_1119_;
                        let _e655 = phi_1121_;
                        let _e657 = phi_1123_;
                        local_11 = _e649;
                        if _e651 {
                            phi_1134_ = true;
                        } else {
                            phi_1134_ = (_e655 > 0u);
                        }
                        let _e660 = phi_1134_;
                        if _e660 {
                            let _e661 = (_e657 > 0u);
                            if _e661 {
                                if _e651 {
                                    phi_1220_ = _e651;
                                    phi_1221_ = _e653;
                                    phi_1222_ = _e655;
                                } else {
                                    let _e662 = (_e655 - 1u);
                                    let _e663 = (_e662 % 128u);
                                    let _e664 = (_e663 < 128u);
                                    if _e664 {
                                    } else {
                                        phi_4613_ = true;
                                        break;
                                    }
                                    let _e666 = local_7[_e663];
                                    if _e664 {
                                    } else {
                                        phi_4613_ = true;
                                        break;
                                    }
                                    let _e668 = local_6[_e663];
                                    if _e664 {
                                    } else {
                                        phi_4613_ = true;
                                        break;
                                    }
                                    let _e670 = local_5[_e663];
                                    if _e664 {
                                    } else {
                                        phi_4613_ = true;
                                        break;
                                    }
                                    let _e672 = local_4[_e663];
                                    if _e664 {
                                    } else {
                                        phi_4613_ = true;
                                        break;
                                    }
                                    let _e674 = local_3[_e663];
                                    if _e664 {
                                    } else {
                                        phi_4613_ = true;
                                        break;
                                    }
                                    let _e676 = local_2[_e663];
                                    if _e664 {
                                    } else {
                                        phi_4613_ = true;
                                        break;
                                    }
                                    let _e681 = local_8[_e663];
                                    if _e664 {
                                    } else {
                                        phi_4613_ = true;
                                        break;
                                    }
                                    let _e684 = local_9[_e663];
                                    phi_1220_ = (_e684 <= _e649.member);
                                    phi_1221_ = type_46(type_24(vec4<f32>(_e666, _e668, _e670, 0f), vec4<f32>(_e672, _e674, _e676, 0f)), _e681);
                                    phi_1222_ = _e662;
                                }
                                let _e688 = phi_1220_;
                                let _e690 = phi_1221_;
                                let _e692 = phi_1222_;
                                if _e688 {
                                    let _e697 = (_e690.member_1 & 268435455u);
                                    if ((_e690.member_1 & 2147483648u) != 0u) {
                                        phi_1241_ = _e649;
                                        phi_1244_ = type_8(0u, ((_e690.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1180 = phi_1241_;
                                            let _e1182 = phi_1244_;
                                            local_10 = _e1180;
                                            local_12 = _e1180;
                                            if (_e1182.member < _e1182.member_1) {
                                                phi_1245_ = type_8((_e1182.member + 1u), _e1182.member_1);
                                                phi_1267_ = type_8(1u, _e1182.member);
                                            } else {
                                                phi_1245_ = _e1182;
                                                phi_1267_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1195 = phi_1245_;
                                            let _e1197 = phi_1267_;
                                            let _e1201 = (bitcast<i32>(_e1197.member) != 0i);
                                            if _e1201 {
                                                let _e1206 = (_e690.member.member_1.x - _e690.member.member.x);
                                                let _e1209 = (_e690.member.member_1.y - _e690.member.member.y);
                                                let _e1212 = (_e690.member.member_1.z - _e690.member.member.z);
                                                let _e1214 = select(_e1209, _e1206, (_e1206 > _e1209));
                                                let _e1216 = select(_e1212, _e1214, (_e1214 > _e1212));
                                                let _e1218 = (_e1216 < (1024f * _e145));
                                                if _e1218 {
                                                    phi_1308_ = 0u;
                                                } else {
                                                    phi_1308_ = select(2u, 1u, (_e1216 < (2097152f * _e145)));
                                                }
                                                let _e1223 = phi_1308_;
                                                switch bitcast<i32>(_e1223) {
                                                    case 0: {
                                                        phi_1314_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1314_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1314_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1314_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1226 = phi_1314_;
                                                switch bitcast<i32>(_e1223) {
                                                    case 0: {
                                                        phi_1324_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1324_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1324_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1324_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1233 = phi_1324_;
                                                let _e1235 = ((_e697 + (_e1197.member_1 * ((3u * _e1226) + 1u))) + (3u * _e1233));
                                                let _e1236 = (_e1235 < _e97);
                                                if _e1236 {
                                                    if _e1236 {
                                                    } else {
                                                        phi_4416_ = true;
                                                        break;
                                                    }
                                                    let _e1238 = global_6.member[_e1235];
                                                    phi_1340_ = _e1238;
                                                } else {
                                                    phi_1340_ = 4294967295u;
                                                }
                                                let _e1240 = phi_1340_;
                                                if _e1218 {
                                                    phi_1373_ = 0u;
                                                } else {
                                                    phi_1373_ = select(2u, 1u, (_e1216 < (2097152f * _e145)));
                                                }
                                                let _e1245 = phi_1373_;
                                                switch bitcast<i32>(_e1245) {
                                                    case 0: {
                                                        phi_1379_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1379_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1379_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1379_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e1248 = phi_1379_;
                                                let _e1252 = (_e697 + (_e1197.member_1 * ((3u * _e1248) + 1u)));
                                                switch bitcast<i32>(_e1245) {
                                                    case 0: {
                                                        let _e1527 = (_e1252 < _e97);
                                                        if _e1527 {
                                                            if _e1527 {
                                                            } else {
                                                                phi_4416_ = true;
                                                                break;
                                                            }
                                                            let _e1529 = global_6.member[_e1252];
                                                            phi_1406_ = _e1529;
                                                        } else {
                                                            phi_1406_ = 0u;
                                                        }
                                                        let _e1531 = phi_1406_;
                                                        let _e1533 = ((10u * _e265) & 31u);
                                                        let _e1543 = ((10u * _e264) & 31u);
                                                        let _e1553 = ((10u * _e266) & 31u);
                                                        let _e1563 = (_e1252 + 1u);
                                                        let _e1564 = (_e1563 < _e97);
                                                        if _e1564 {
                                                            if _e1564 {
                                                            } else {
                                                                phi_4416_ = true;
                                                                break;
                                                            }
                                                            let _e1566 = global_6.member[_e1563];
                                                            phi_1455_ = _e1566;
                                                        } else {
                                                            phi_1455_ = 0u;
                                                        }
                                                        let _e1568 = phi_1455_;
                                                        let _e1594 = (_e1252 + 2u);
                                                        let _e1595 = (_e1594 < _e97);
                                                        if _e1595 {
                                                            if _e1595 {
                                                            } else {
                                                                phi_4416_ = true;
                                                                break;
                                                            }
                                                            let _e1597 = global_6.member[_e1594];
                                                            phi_1504_ = _e1597;
                                                        } else {
                                                            phi_1504_ = 0u;
                                                        }
                                                        let _e1599 = phi_1504_;
                                                        phi_2005_ = array<array<f32, 3>, 3>(array<f32, 3>((_e690.member.member.x + ((bitcast<f32>((1258291200u | ((_e1531 >> bitcast<u32>(_e1533)) & 1023u))) - 8388608f) * _e145)), (_e690.member.member.y + ((bitcast<f32>((1258291200u | ((_e1531 >> bitcast<u32>(_e1543)) & 1023u))) - 8388608f) * _e145)), (_e690.member.member.z + ((bitcast<f32>((1258291200u | ((_e1531 >> bitcast<u32>(_e1553)) & 1023u))) - 8388608f) * _e145))), array<f32, 3>((_e690.member.member.x + ((bitcast<f32>((1258291200u | ((_e1568 >> bitcast<u32>(_e1533)) & 1023u))) - 8388608f) * _e145)), (_e690.member.member.y + ((bitcast<f32>((1258291200u | ((_e1568 >> bitcast<u32>(_e1543)) & 1023u))) - 8388608f) * _e145)), (_e690.member.member.z + ((bitcast<f32>((1258291200u | ((_e1568 >> bitcast<u32>(_e1553)) & 1023u))) - 8388608f) * _e145))), array<f32, 3>((_e690.member.member.x + ((bitcast<f32>((1258291200u | ((_e1599 >> bitcast<u32>(_e1533)) & 1023u))) - 8388608f) * _e145)), (_e690.member.member.y + ((bitcast<f32>((1258291200u | ((_e1599 >> bitcast<u32>(_e1543)) & 1023u))) - 8388608f) * _e145)), (_e690.member.member.z + ((bitcast<f32>((1258291200u | ((_e1599 >> bitcast<u32>(_e1553)) & 1023u))) - 8388608f) * _e145))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1341 = (_e1252 < _e97);
                                                        if _e1341 {
                                                            if _e1341 {
                                                            } else {
                                                                phi_4416_ = true;
                                                                break;
                                                            }
                                                            let _e1343 = global_6.member[_e1252];
                                                            phi_1553_ = _e1343;
                                                        } else {
                                                            phi_1553_ = 0u;
                                                        }
                                                        let _e1345 = phi_1553_;
                                                        let _e1346 = (_e1252 + 1u);
                                                        let _e1347 = (_e1346 < _e97);
                                                        if _e1347 {
                                                            if _e1347 {
                                                            } else {
                                                                phi_4416_ = true;
                                                                break;
                                                            }
                                                            let _e1349 = global_6.member[_e1346];
                                                            phi_1568_ = _e1349;
                                                        } else {
                                                            phi_1568_ = 0u;
                                                        }
                                                        let _e1351 = phi_1568_;
                                                        let _e1352 = (_e265 == 1u);
                                                        if _e1352 {
                                                            phi_1578_ = ((_e1345 >> bitcast<u32>(21i)) | (_e1351 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1578_ = (_e1351 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1361 = phi_1578_;
                                                        let _e1369 = (_e264 == 1u);
                                                        if _e1369 {
                                                            phi_1599_ = ((_e1345 >> bitcast<u32>(21i)) | (_e1351 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1599_ = (_e1351 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1378 = phi_1599_;
                                                        let _e1386 = (_e266 == 1u);
                                                        if _e1386 {
                                                            phi_1620_ = ((_e1345 >> bitcast<u32>(21i)) | (_e1351 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1620_ = (_e1351 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1395 = phi_1620_;
                                                        let _e1404 = (_e1252 + 2u);
                                                        let _e1405 = (_e1404 < _e97);
                                                        if _e1405 {
                                                            if _e1405 {
                                                            } else {
                                                                phi_4416_ = true;
                                                                break;
                                                            }
                                                            let _e1407 = global_6.member[_e1404];
                                                            phi_1650_ = _e1407;
                                                        } else {
                                                            phi_1650_ = 0u;
                                                        }
                                                        let _e1409 = phi_1650_;
                                                        let _e1410 = (_e1252 + 3u);
                                                        let _e1411 = (_e1410 < _e97);
                                                        if _e1411 {
                                                            if _e1411 {
                                                            } else {
                                                                phi_4416_ = true;
                                                                break;
                                                            }
                                                            let _e1413 = global_6.member[_e1410];
                                                            phi_1665_ = _e1413;
                                                        } else {
                                                            phi_1665_ = 0u;
                                                        }
                                                        let _e1415 = phi_1665_;
                                                        if _e1352 {
                                                            phi_1675_ = ((_e1409 >> bitcast<u32>(21i)) | (_e1415 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1675_ = (_e1415 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1424 = phi_1675_;
                                                        if _e1369 {
                                                            phi_1696_ = ((_e1409 >> bitcast<u32>(21i)) | (_e1415 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1696_ = (_e1415 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1440 = phi_1696_;
                                                        if _e1386 {
                                                            phi_1717_ = ((_e1409 >> bitcast<u32>(21i)) | (_e1415 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1717_ = (_e1415 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1456 = phi_1717_;
                                                        let _e1465 = (_e1252 + 4u);
                                                        let _e1466 = (_e1465 < _e97);
                                                        if _e1466 {
                                                            if _e1466 {
                                                            } else {
                                                                phi_4416_ = true;
                                                                break;
                                                            }
                                                            let _e1468 = global_6.member[_e1465];
                                                            phi_1747_ = _e1468;
                                                        } else {
                                                            phi_1747_ = 0u;
                                                        }
                                                        let _e1470 = phi_1747_;
                                                        let _e1471 = (_e1252 + 5u);
                                                        let _e1472 = (_e1471 < _e97);
                                                        if _e1472 {
                                                            if _e1472 {
                                                            } else {
                                                                phi_4416_ = true;
                                                                break;
                                                            }
                                                            let _e1474 = global_6.member[_e1471];
                                                            phi_1762_ = _e1474;
                                                        } else {
                                                            phi_1762_ = 0u;
                                                        }
                                                        let _e1476 = phi_1762_;
                                                        if _e1352 {
                                                            phi_1772_ = ((_e1470 >> bitcast<u32>(21i)) | (_e1476 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1772_ = (_e1476 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1485 = phi_1772_;
                                                        if _e1369 {
                                                            phi_1793_ = ((_e1470 >> bitcast<u32>(21i)) | (_e1476 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1793_ = (_e1476 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1501 = phi_1793_;
                                                        if _e1386 {
                                                            phi_1814_ = ((_e1470 >> bitcast<u32>(21i)) | (_e1476 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1814_ = (_e1476 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1517 = phi_1814_;
                                                        phi_2005_ = array<array<f32, 3>, 3>(array<f32, 3>((_e690.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1361, _e1345, _e304) & 2097151u))) - 8388608f) * _e145)), (_e690.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1378, _e1345, _e371) & 2097151u))) - 8388608f) * _e145)), (_e690.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1395, _e1345, _e437) & 2097151u))) - 8388608f) * _e145))), array<f32, 3>((_e690.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1424, _e1409, _e304) & 2097151u))) - 8388608f) * _e145)), (_e690.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1440, _e1409, _e371) & 2097151u))) - 8388608f) * _e145)), (_e690.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1456, _e1409, _e437) & 2097151u))) - 8388608f) * _e145))), array<f32, 3>((_e690.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1485, _e1470, _e304) & 2097151u))) - 8388608f) * _e145)), (_e690.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1501, _e1470, _e371) & 2097151u))) - 8388608f) * _e145)), (_e690.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1517, _e1470, _e437) & 2097151u))) - 8388608f) * _e145))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1254 = (_e1252 + _e265);
                                                        let _e1255 = (_e1254 < _e97);
                                                        if _e1255 {
                                                            if _e1255 {
                                                            } else {
                                                                phi_4416_ = true;
                                                                break;
                                                            }
                                                            let _e1257 = global_6.member[_e1254];
                                                            phi_1845_ = _e1257;
                                                        } else {
                                                            phi_1845_ = 0u;
                                                        }
                                                        let _e1259 = phi_1845_;
                                                        let _e1263 = (_e1252 + _e264);
                                                        let _e1264 = (_e1263 < _e97);
                                                        if _e1264 {
                                                            if _e1264 {
                                                            } else {
                                                                phi_4416_ = true;
                                                                break;
                                                            }
                                                            let _e1266 = global_6.member[_e1263];
                                                            phi_1863_ = _e1266;
                                                        } else {
                                                            phi_1863_ = 0u;
                                                        }
                                                        let _e1268 = phi_1863_;
                                                        let _e1272 = (_e1252 + _e266);
                                                        let _e1273 = (_e1272 < _e97);
                                                        if _e1273 {
                                                            if _e1273 {
                                                            } else {
                                                                phi_4416_ = true;
                                                                break;
                                                            }
                                                            let _e1275 = global_6.member[_e1272];
                                                            phi_1881_ = _e1275;
                                                        } else {
                                                            phi_1881_ = 0u;
                                                        }
                                                        let _e1277 = phi_1881_;
                                                        let _e1282 = (_e1252 + 3u);
                                                        let _e1283 = (_e1282 + _e265);
                                                        let _e1284 = (_e1283 < _e97);
                                                        if _e1284 {
                                                            if _e1284 {
                                                            } else {
                                                                phi_4416_ = true;
                                                                break;
                                                            }
                                                            let _e1286 = global_6.member[_e1283];
                                                            phi_1904_ = _e1286;
                                                        } else {
                                                            phi_1904_ = 0u;
                                                        }
                                                        let _e1288 = phi_1904_;
                                                        let _e1292 = (_e1282 + _e264);
                                                        let _e1293 = (_e1292 < _e97);
                                                        if _e1293 {
                                                            if _e1293 {
                                                            } else {
                                                                phi_4416_ = true;
                                                                break;
                                                            }
                                                            let _e1295 = global_6.member[_e1292];
                                                            phi_1922_ = _e1295;
                                                        } else {
                                                            phi_1922_ = 0u;
                                                        }
                                                        let _e1297 = phi_1922_;
                                                        let _e1301 = (_e1282 + _e266);
                                                        let _e1302 = (_e1301 < _e97);
                                                        if _e1302 {
                                                            if _e1302 {
                                                            } else {
                                                                phi_4416_ = true;
                                                                break;
                                                            }
                                                            let _e1304 = global_6.member[_e1301];
                                                            phi_1940_ = _e1304;
                                                        } else {
                                                            phi_1940_ = 0u;
                                                        }
                                                        let _e1306 = phi_1940_;
                                                        let _e1311 = (_e1252 + 6u);
                                                        let _e1312 = (_e1311 + _e265);
                                                        let _e1313 = (_e1312 < _e97);
                                                        if _e1313 {
                                                            if _e1313 {
                                                            } else {
                                                                phi_4416_ = true;
                                                                break;
                                                            }
                                                            let _e1315 = global_6.member[_e1312];
                                                            phi_1963_ = _e1315;
                                                        } else {
                                                            phi_1963_ = 0u;
                                                        }
                                                        let _e1317 = phi_1963_;
                                                        let _e1321 = (_e1311 + _e264);
                                                        let _e1322 = (_e1321 < _e97);
                                                        if _e1322 {
                                                            if _e1322 {
                                                            } else {
                                                                phi_4416_ = true;
                                                                break;
                                                            }
                                                            let _e1324 = global_6.member[_e1321];
                                                            phi_1981_ = _e1324;
                                                        } else {
                                                            phi_1981_ = 0u;
                                                        }
                                                        let _e1326 = phi_1981_;
                                                        let _e1330 = (_e1311 + _e266);
                                                        let _e1331 = (_e1330 < _e97);
                                                        if _e1331 {
                                                            if _e1331 {
                                                            } else {
                                                                phi_4416_ = true;
                                                                break;
                                                            }
                                                            let _e1333 = global_6.member[_e1330];
                                                            phi_1999_ = _e1333;
                                                        } else {
                                                            phi_1999_ = 0u;
                                                        }
                                                        let _e1335 = phi_1999_;
                                                        phi_2005_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1259)) * _e145), (f32(bitcast<i32>(_e1268)) * _e145), (f32(bitcast<i32>(_e1277)) * _e145)), array<f32, 3>((f32(bitcast<i32>(_e1288)) * _e145), (f32(bitcast<i32>(_e1297)) * _e145), (f32(bitcast<i32>(_e1306)) * _e145)), array<f32, 3>((f32(bitcast<i32>(_e1317)) * _e145), (f32(bitcast<i32>(_e1326)) * _e145), (f32(bitcast<i32>(_e1335)) * _e145)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2005_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1627 = phi_2005_;
                                                let _e1643 = (_e1627[0][2] - _e462);
                                                let _e1646 = (((_e1627[0][0] - _e329) * _e498) - (_e1643 * _e366));
                                                let _e1649 = (((_e1627[0][1] - _e396) * _e498) - (_e1643 * _e432));
                                                let _e1652 = (_e1627[1][2] - _e462);
                                                let _e1655 = (((_e1627[1][0] - _e329) * _e498) - (_e1652 * _e366));
                                                let _e1658 = (((_e1627[1][1] - _e396) * _e498) - (_e1652 * _e432));
                                                let _e1661 = (_e1627[2][2] - _e462);
                                                let _e1664 = (((_e1627[2][0] - _e329) * _e498) - (_e1661 * _e366));
                                                let _e1667 = (((_e1627[2][1] - _e396) * _e498) - (_e1661 * _e432));
                                                let _e1668 = (_e1664 * _e1658);
                                                let _e1669 = (_e1667 * _e1655);
                                                let _e1670 = (_e1646 * _e1667);
                                                let _e1671 = (_e1649 * _e1664);
                                                let _e1672 = (_e1655 * _e1649);
                                                let _e1673 = (_e1658 * _e1646);
                                                let _e1678 = (((_e1668 >= _e1669) && (_e1670 >= _e1671)) && (_e1672 >= _e1673));
                                                let _e1684 = (_e1678 || (((_e1668 <= _e1669) && (_e1670 <= _e1671)) && (_e1672 <= _e1673)));
                                                if _e1684 {
                                                    let _e1686 = select(-1f, 1f, _e1678);
                                                    let _e1688 = ((_e1668 - _e1669) * _e1686);
                                                    let _e1690 = select(0f, _e1688, (_e1688 > 0f));
                                                    let _e1692 = ((_e1670 - _e1671) * _e1686);
                                                    let _e1694 = select(0f, _e1692, (_e1692 > 0f));
                                                    let _e1696 = ((_e1672 - _e1673) * _e1686);
                                                    let _e1698 = select(0f, _e1696, (_e1696 > 0f));
                                                    let _e1700 = ((_e1690 + _e1694) + _e1698);
                                                    let _e1702 = select(_e1627[1][0], _e1627[0][0], (_e1627[0][0] < _e1627[1][0]));
                                                    let _e1706 = select(_e1627[1][0], _e1627[0][0], (_e1627[0][0] > _e1627[1][0]));
                                                    let _e1710 = select(_e1627[1][1], _e1627[0][1], (_e1627[0][1] < _e1627[1][1]));
                                                    let _e1714 = select(_e1627[1][1], _e1627[0][1], (_e1627[0][1] > _e1627[1][1]));
                                                    let _e1718 = select(_e1627[1][2], _e1627[0][2], (_e1627[0][2] < _e1627[1][2]));
                                                    let _e1722 = select(_e1627[1][2], _e1627[0][2], (_e1627[0][2] > _e1627[1][2]));
                                                    let _e1727 = ((select(_e1627[2][0], _e1702, (_e1702 < _e1627[2][0])) - _e367) * _e370);
                                                    let _e1728 = ((select(_e1627[2][0], _e1706, (_e1706 > _e1627[2][0])) - _e368) * _e370);
                                                    let _e1731 = ((select(_e1627[2][1], _e1710, (_e1710 < _e1627[2][1])) - _e433) * _e436);
                                                    let _e1732 = ((select(_e1627[2][1], _e1714, (_e1714 > _e1627[2][1])) - _e434) * _e436);
                                                    let _e1735 = ((select(_e1627[2][2], _e1718, (_e1718 < _e1627[2][2])) - _e499) * _e502);
                                                    let _e1736 = ((select(_e1627[2][2], _e1722, (_e1722 > _e1627[2][2])) - _e500) * _e502);
                                                    let _e1738 = select(_e1736, _e1735, (_e1735 < _e1736));
                                                    let _e1740 = select(_e1736, _e1735, (_e1735 > _e1736));
                                                    let _e1742 = select(_e1728, _e1727, (_e1727 < _e1728));
                                                    let _e1744 = select(_e1732, _e1731, (_e1731 < _e1732));
                                                    let _e1746 = select(_e1744, _e1742, (_e1742 > _e1744));
                                                    let _e1748 = select(_e1738, _e1746, (_e1746 > _e1738));
                                                    let _e1750 = select(_e1728, _e1727, (_e1727 > _e1728));
                                                    let _e1752 = select(_e1732, _e1731, (_e1731 > _e1732));
                                                    let _e1754 = select(_e1752, _e1750, (_e1750 < _e1752));
                                                    let _e1756 = select(_e1740, _e1754, (_e1754 < _e1740));
                                                    let _e1757 = -(_e1738);
                                                    let _e1763 = select(_e605, _e1748, (_e1748 > _e605));
                                                    let _e1767 = select(_e1655, _e1646, (_e1646 < _e1655));
                                                    let _e1772 = select(_e1655, _e1646, (_e1646 > _e1655));
                                                    let _e1779 = select(_e1658, _e1649, (_e1649 < _e1658));
                                                    let _e1784 = select(_e1658, _e1649, (_e1649 > _e1658));
                                                    let _e1793 = (((((_e1684 && (_e1700 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1664, _e1767, (_e1767 < _e1664)) <= 0f) && (select(_e1664, _e1772, (_e1772 > _e1664)) >= 0f))) && ((select(_e1667, _e1779, (_e1779 < _e1667)) <= 0f) && (select(_e1667, _e1784, (_e1784 > _e1667)) >= 0f))) && (_e1763 <= (_e1756 + (select(_e1757, _e1740, (_e1740 > _e1757)) * 0.0000019073523f)))) && (_e1763 <= _e1180.member));
                                                    if _e1793 {
                                                        let _e1798 = (_e1627[1][0] - _e1627[0][0]);
                                                        let _e1799 = (_e1627[1][1] - _e1627[0][1]);
                                                        let _e1800 = (_e1627[1][2] - _e1627[0][2]);
                                                        let _e1801 = vec3<f32>(_e1798, _e1799, _e1800);
                                                        let _e1802 = (_e1627[2][0] - _e1627[1][0]);
                                                        let _e1803 = (_e1627[2][1] - _e1627[1][1]);
                                                        let _e1804 = (_e1627[2][2] - _e1627[1][2]);
                                                        let _e1805 = vec3<f32>(_e1802, _e1803, _e1804);
                                                        let _e1806 = (_e1627[0][0] - _e1627[2][0]);
                                                        let _e1807 = (_e1627[0][1] - _e1627[2][1]);
                                                        let _e1808 = (_e1627[0][2] - _e1627[2][2]);
                                                        let _e1809 = vec3<f32>(_e1806, _e1807, _e1808);
                                                        let _e1812 = bitcast<f32>((bitcast<u32>(_e1798) & 2147483647u));
                                                        let _e1815 = bitcast<f32>((bitcast<u32>(_e1799) & 2147483647u));
                                                        let _e1817 = select(_e1815, _e1812, (_e1812 > _e1815));
                                                        let _e1820 = bitcast<f32>((bitcast<u32>(_e1800) & 2147483647u));
                                                        let _e1822 = select(_e1820, _e1817, (_e1817 > _e1820));
                                                        let _e1825 = bitcast<f32>((bitcast<u32>(_e1802) & 2147483647u));
                                                        let _e1828 = bitcast<f32>((bitcast<u32>(_e1803) & 2147483647u));
                                                        let _e1830 = select(_e1828, _e1825, (_e1825 > _e1828));
                                                        let _e1833 = bitcast<f32>((bitcast<u32>(_e1804) & 2147483647u));
                                                        let _e1835 = select(_e1833, _e1830, (_e1830 > _e1833));
                                                        let _e1838 = bitcast<f32>((bitcast<u32>(_e1806) & 2147483647u));
                                                        let _e1841 = bitcast<f32>((bitcast<u32>(_e1807) & 2147483647u));
                                                        let _e1843 = select(_e1841, _e1838, (_e1838 > _e1841));
                                                        let _e1846 = bitcast<f32>((bitcast<u32>(_e1808) & 2147483647u));
                                                        let _e1848 = select(_e1846, _e1843, (_e1843 > _e1846));
                                                        let _e1850 = select(_e1835, _e1822, (_e1822 > _e1835));
                                                        let _e1852 = select(_e1848, _e1850, (_e1850 > _e1848));
                                                        if (_e1822 == _e1852) {
                                                            phi_2535_ = _e1658;
                                                            phi_2536_ = _e1655;
                                                            phi_2537_ = _e1649;
                                                            phi_2538_ = _e1646;
                                                            phi_2539_ = vec3<f32>(_e1627[0][0], _e1627[0][1], _e1627[0][2]);
                                                            phi_2540_ = _e1809;
                                                            phi_2541_ = _e1805;
                                                            phi_2542_ = _e1801;
                                                        } else {
                                                            let _e1854 = (_e1835 == _e1852);
                                                            let _e1859 = vec3(_e1854);
                                                            phi_2535_ = select(_e1649, _e1667, _e1854);
                                                            phi_2536_ = select(_e1646, _e1664, _e1854);
                                                            phi_2537_ = select(_e1667, _e1658, _e1854);
                                                            phi_2538_ = select(_e1664, _e1655, _e1854);
                                                            phi_2539_ = select(vec3<f32>(_e1627[2][0], _e1627[2][1], _e1627[2][2]), vec3<f32>(_e1627[1][0], _e1627[1][1], _e1627[1][2]), _e1859);
                                                            phi_2540_ = select(_e1805, _e1801, _e1859);
                                                            phi_2541_ = select(_e1801, _e1809, _e1859);
                                                            phi_2542_ = select(_e1809, _e1805, _e1859);
                                                        }
                                                        let _e1865 = phi_2535_;
                                                        let _e1867 = phi_2536_;
                                                        let _e1869 = phi_2537_;
                                                        let _e1871 = phi_2538_;
                                                        let _e1873 = phi_2539_;
                                                        let _e1875 = phi_2540_;
                                                        let _e1877 = phi_2541_;
                                                        let _e1879 = phi_2542_;
                                                        let _e1886 = ((_e1877.y * _e1875.z) - (_e1875.y * _e1877.z));
                                                        let _e1891 = ((_e1877.z * _e1875.x) - (_e1875.z * _e1877.x));
                                                        let _e1894 = ((_e1877.x * _e1875.y) - (_e1875.x * _e1877.y));
                                                        let _e1897 = ((_e1690 >= _e1694) && (_e1690 >= _e1698));
                                                        let _e1898 = (_e1694 >= _e1698);
                                                        let _e1912 = (((_e1886 * (select(select(_e1627[2][0], _e1627[1][0], _e1898), _e1627[0][0], _e1897) - _e329)) + (_e1891 * (select(select(_e1627[2][1], _e1627[1][1], _e1898), _e1627[0][1], _e1897) - _e396))) + (_e1894 * (select(select(_e1627[2][2], _e1627[1][2], _e1898), _e1627[0][2], _e1897) - _e462)));
                                                        let _e1917 = (((_e1886 * _e366) + (_e1891 * _e432)) + (_e1894 * _e498));
                                                        let _e1918 = (_e1867 - _e1871);
                                                        let _e1919 = (_e1865 - _e1869);
                                                        let _e1922 = ((_e1918 * _e1918) + (_e1919 * _e1919));
                                                        let _e1929 = (-(((_e1871 * _e1918) + (_e1869 * _e1919))) / select(0.000000000000000000000000000000000000011754944f, _e1922, (_e1922 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1931 = select(1f, _e1929, (_e1929 < 1f));
                                                        let _e1933 = select(0f, _e1931, (_e1931 > 0f));
                                                        let _e1942 = ((_e1873.x + (_e1879.x * _e1933)) - _e329);
                                                        let _e1945 = ((_e1873.y + (_e1879.y * _e1933)) - _e396);
                                                        let _e1948 = ((_e1873.z + (_e1879.z * _e1933)) - _e462);
                                                        let _e1951 = bitcast<f32>((bitcast<u32>(_e1942) & 2147483647u));
                                                        let _e1954 = bitcast<f32>((bitcast<u32>(_e1945) & 2147483647u));
                                                        let _e1956 = select(_e1954, _e1951, (_e1951 > _e1954));
                                                        let _e1959 = bitcast<f32>((bitcast<u32>(_e1948) & 2147483647u));
                                                        let _e1961 = select(_e1959, _e1956, (_e1956 > _e1959));
                                                        let _e1967 = bitcast<f32>((bitcast<u32>(_e1886) & 2147483647u));
                                                        let _e1970 = bitcast<f32>((bitcast<u32>(_e1891) & 2147483647u));
                                                        let _e1972 = select(_e1970, _e1967, (_e1967 > _e1970));
                                                        let _e1975 = bitcast<f32>((bitcast<u32>(_e1894) & 2147483647u));
                                                        let _e1994 = bitcast<f32>((bitcast<u32>(_e1877.x) & 2147483647u));
                                                        let _e1997 = bitcast<f32>((bitcast<u32>(_e1877.y) & 2147483647u));
                                                        let _e1999 = select(_e1997, _e1994, (_e1994 > _e1997));
                                                        let _e2002 = bitcast<f32>((bitcast<u32>(_e1877.z) & 2147483647u));
                                                        let _e2008 = bitcast<f32>((bitcast<u32>(_e1875.x) & 2147483647u));
                                                        let _e2011 = bitcast<f32>((bitcast<u32>(_e1875.y) & 2147483647u));
                                                        let _e2013 = select(_e2011, _e2008, (_e2008 > _e2011));
                                                        let _e2016 = bitcast<f32>((bitcast<u32>(_e1875.z) & 2147483647u));
                                                        let _e2022 = ((bitcast<f32>((bitcast<u32>(((((_e1886 * _e1942) + (_e1891 * _e1945)) + (_e1894 * _e1948)) - _e1912)) & 2147483647u)) <= ((0.0000009536743f * select(_e1852, _e1961, (_e1961 > _e1852))) * select(_e1975, _e1972, (_e1972 > _e1975)))) && !((bitcast<f32>((bitcast<u32>(_e1917) & 2147483647u)) <= ((0.0000038146973f * select(_e2002, _e1999, (_e1999 > _e2002))) * select(_e2016, _e2013, (_e2013 > _e2016))))));
                                                        let _e2023 = (_e1912 / _e1917);
                                                        if (_e1793 && !(_e2022)) {
                                                            let _e2026 = (_e1948 / _e498);
                                                            let _e2034 = (((_e1886 * (_e1942 - (_e366 * _e2026))) + (_e1891 * (_e1945 - (_e432 * _e2026)))) / _e1917);
                                                            phi_2733_ = select(select(_e2026, (_e2026 + _e2034), (bitcast<f32>((bitcast<u32>(_e2034) & 2147483647u)) <= _e1852)), _e2023, _e2022);
                                                        } else {
                                                            phi_2733_ = _e2023;
                                                        }
                                                        let _e2043 = phi_2733_;
                                                        let _e2045 = select(_e1756, _e2043, (_e2043 < _e1756));
                                                        let _e2047 = select(_e1748, _e2045, (_e2045 > _e1748));
                                                        let _e2048 = (1f / _e1700);
                                                        phi_2753_ = type_31(_e2047, (_e1694 * _e2048), (_e1698 * _e2048), ((_e1793 && (_e2047 >= _e605)) && (_e2047 <= _e1180.member)));
                                                        phi_2754_ = type_31();
                                                    } else {
                                                        phi_2753_ = type_31();
                                                        phi_2754_ = type_31(0f, 0f, 0f, _e1793);
                                                    }
                                                    let _e2057 = phi_2753_;
                                                    let _e2059 = phi_2754_;
                                                    phi_2757_ = _e2057;
                                                    phi_2758_ = _e2059;
                                                    phi_2759_ = select(true, false, _e1793);
                                                } else {
                                                    phi_2757_ = type_31();
                                                    phi_2758_ = type_31(0f, 0f, 0f, _e1684);
                                                    phi_2759_ = true;
                                                }
                                                let _e2062 = phi_2757_;
                                                let _e2064 = phi_2758_;
                                                let _e2066 = phi_2759_;
                                                if _e2066 {
                                                    phi_2763_ = _e2064;
                                                } else {
                                                    phi_2763_ = _e2062;
                                                }
                                                let _e2068 = phi_2763_;
                                                if _e2068.member_3 {
                                                    phi_2772_ = type_20(_e2068.member, _e2068.member_1, _e2068.member_2, _e1240);
                                                } else {
                                                    phi_2772_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e2075 = phi_2772_;
                                                if (_e2075.member_3 != 4294967295u) {
                                                    if (_e1240 != 4294967295u) {
                                                        phi_2783_ = type_35(-340282350000000000000000000000000000000f, true);
                                                    } else {
                                                        phi_2783_ = _e1180;
                                                    }
                                                    let _e2080 = phi_2783_;
                                                    phi_2784_ = _e2080;
                                                } else {
                                                    phi_2784_ = _e1180;
                                                }
                                                let _e2082 = phi_2784_;
                                                phi_1242_ = _e2082;
                                            } else {
                                                phi_1242_ = type_35();
                                            }
                                            let _e2084 = phi_1242_;
                                            continue;
                                            continuing {
                                                phi_1241_ = _e2084;
                                                phi_1244_ = _e1195;
                                                phi_4416_ = _e647;
                                                break if !(_e1201);
                                            }
                                        }
                                        let _e2087 = phi_4416_;
                                        phi_4613_ = _e2087;
                                        if _e2087 {
                                            break;
                                        }
                                        let _e2089 = local_10;
                                        phi_4617_ = _e2087;
                                        let _e2271 = local_12;
                                        phi_4046_ = _e2271;
                                        phi_4047_ = false;
                                        phi_4048_ = _e690;
                                        phi_4049_ = select(_e692, 0u, (_e605 > _e2089.member));
                                    } else {
                                        if (_e690.member_1 >= _e94) {
                                            phi_3585_ = type_47(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_46(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_46(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e690.member_1 < _e94) {
                                            } else {
                                                phi_4613_ = true;
                                                break;
                                            }
                                            let _e704 = (_e265 * 2u);
                                            let _e706 = ((1u + _e704) % 7u);
                                            if (_e706 < 7u) {
                                            } else {
                                                phi_4613_ = true;
                                                break;
                                            }
                                            let _e711 = global_5.member[_e690.member_1][_e706];
                                            let _e713 = ((_e704 + 2u) % 7u);
                                            if (_e713 < 7u) {
                                            } else {
                                                phi_4613_ = true;
                                                break;
                                            }
                                            let _e718 = global_5.member[_e690.member_1][_e713];
                                            let _e719 = (_e264 * 2u);
                                            let _e721 = ((1u + _e719) % 7u);
                                            if (_e721 < 7u) {
                                            } else {
                                                phi_4613_ = true;
                                                break;
                                            }
                                            let _e726 = global_5.member[_e690.member_1][_e721];
                                            let _e728 = ((_e719 + 2u) % 7u);
                                            if (_e728 < 7u) {
                                            } else {
                                                phi_4613_ = true;
                                                break;
                                            }
                                            let _e733 = global_5.member[_e690.member_1][_e728];
                                            let _e734 = (_e266 * 2u);
                                            let _e736 = ((1u + _e734) % 7u);
                                            if (_e736 < 7u) {
                                            } else {
                                                phi_4613_ = true;
                                                break;
                                            }
                                            let _e741 = global_5.member[_e690.member_1][_e736];
                                            let _e743 = ((_e734 + 2u) % 7u);
                                            if (_e743 < 7u) {
                                            } else {
                                                phi_4613_ = true;
                                                break;
                                            }
                                            let _e748 = global_5.member[_e690.member_1][_e743];
                                            let _e771 = (bitcast<f32>((bitcast<u32>((_e690.member.member_1.x - _e690.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e772 = (bitcast<f32>((bitcast<u32>((_e690.member.member_1.y - _e690.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e773 = (bitcast<f32>((bitcast<u32>((_e690.member.member_1.z - _e690.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e775 = select(_e145, _e771, (_e771 > _e145));
                                            let _e777 = select(_e145, _e772, (_e772 > _e145));
                                            let _e779 = select(_e145, _e773, (_e773 > _e145));
                                            let _e810 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e711 & 2097151u))) - 8388608f) * _e775));
                                            let _e815 = (bitcast<i32>((_e711 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e818 = bitcast<f32>((_e810 & bitcast<u32>(_e815)));
                                            let _e819 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e726 & 2097151u))) - 8388608f) * _e777));
                                            let _e824 = (bitcast<i32>((_e726 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e827 = bitcast<f32>((_e819 & bitcast<u32>(_e824)));
                                            let _e828 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e741 & 2097151u))) - 8388608f) * _e779));
                                            let _e833 = (bitcast<i32>((_e741 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e836 = bitcast<f32>((_e828 & bitcast<u32>(_e833)));
                                            let _e840 = bitcast<f32>((_e810 & bitcast<u32>(~(_e815))));
                                            let _e844 = bitcast<f32>((_e819 & bitcast<u32>(~(_e824))));
                                            let _e848 = bitcast<f32>((_e828 & bitcast<u32>(~(_e833))));
                                            let _e849 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e718 & 2097151u))) - 8388608f) * _e775));
                                            let _e854 = (bitcast<i32>((_e718 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e857 = bitcast<f32>((_e849 & bitcast<u32>(_e854)));
                                            let _e858 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e733 & 2097151u))) - 8388608f) * _e777));
                                            let _e863 = (bitcast<i32>((_e733 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e866 = bitcast<f32>((_e858 & bitcast<u32>(_e863)));
                                            let _e867 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e748 & 2097151u))) - 8388608f) * _e779));
                                            let _e872 = (bitcast<i32>((_e748 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e875 = bitcast<f32>((_e867 & bitcast<u32>(_e872)));
                                            let _e879 = bitcast<f32>((_e849 & bitcast<u32>(~(_e854))));
                                            let _e883 = bitcast<f32>((_e858 & bitcast<u32>(~(_e863))));
                                            let _e887 = bitcast<f32>((_e867 & bitcast<u32>(~(_e872))));
                                            let _e888 = (_e690.member.member.x + _e818);
                                            let _e889 = (_e690.member.member.y + _e827);
                                            let _e890 = (_e690.member.member.z + _e836);
                                            let _e893 = (_e690.member.member_1.x - _e857);
                                            let _e894 = (_e690.member.member_1.y - _e866);
                                            let _e895 = (_e690.member.member_1.z - _e875);
                                            let _e914 = (_e893 - _e888);
                                            let _e915 = (_e894 - _e889);
                                            let _e916 = (_e895 - _e890);
                                            let _e918 = select(_e915, _e914, (_e914 > _e915));
                                            let _e920 = select(_e916, _e918, (_e918 > _e916));
                                            if (_e920 < (1024f * _e145)) {
                                                phi_3286_ = 0u;
                                            } else {
                                                phi_3286_ = select(2u, 1u, (_e920 < (2097152f * _e145)));
                                            }
                                            let _e927 = phi_3286_;
                                            switch bitcast<i32>(_e927) {
                                                case 0: {
                                                    phi_3292_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3292_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3292_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3292_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e930 = phi_3292_;
                                            let _e936 = global_5.member[_e690.member_1][0u];
                                            let _e940 = global_5.member[_e690.member_1][2u];
                                            let _e944 = global_5.member[_e690.member_1][4u];
                                            let _e948 = global_5.member[_e690.member_1][6u];
                                            let _e960 = (((_e940 >> bitcast<u32>(22i)) | ((_e944 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e948 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e961 = (_e936 & 268435455u);
                                            let _e962 = (_e960 & 268435455u);
                                            let _e965 = ((_e936 >> bitcast<u32>(28u)) & 7u);
                                            let _e973 = ((_e936 >> bitcast<u32>(31i)) | (((_e960 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e974 = (_e965 != 0u);
                                            if (_e965 == 0u) {
                                                phi_3547_ = _e961;
                                            } else {
                                                if (_e965 == 7u) {
                                                    phi_3546_ = 2147483648u;
                                                } else {
                                                    phi_3546_ = ((2147483648u | (_e965 << bitcast<u32>(28u))) | (_e962 & 268435455u));
                                                }
                                                let _e983 = phi_3546_;
                                                phi_3547_ = _e983;
                                            }
                                            let _e985 = phi_3547_;
                                            if _e974 {
                                                let _e986 = (_e965 != 7u);
                                                if _e986 {
                                                    phi_3557_ = (_e962 + (_e965 * ((3u * _e930) + 1u)));
                                                } else {
                                                    phi_3557_ = u32();
                                                }
                                                let _e990 = phi_3557_;
                                                phi_3559_ = _e990;
                                                phi_3560_ = select(true, false, _e986);
                                            } else {
                                                phi_3559_ = u32();
                                                phi_3560_ = true;
                                            }
                                            let _e993 = phi_3559_;
                                            let _e995 = phi_3560_;
                                            if (_e973 == 0u) {
                                                phi_3581_ = (_e961 + select(0u, 1u, !(_e974)));
                                            } else {
                                                if (_e973 == 7u) {
                                                    phi_3580_ = 2147483648u;
                                                } else {
                                                    phi_3580_ = ((2147483648u | (_e973 << bitcast<u32>(28u))) | (select(_e993, _e962, _e995) & 268435455u));
                                                }
                                                let _e1008 = phi_3580_;
                                                phi_3581_ = _e1008;
                                            }
                                            let _e1010 = phi_3581_;
                                            phi_3585_ = type_47(array<vec4<f32>, 3>(vec4<f32>(_e888, (_e690.member.member.x + _e840), _e893, (_e690.member.member_1.x - _e879)), vec4<f32>(_e889, (_e690.member.member.y + _e844), _e894, (_e690.member.member_1.y - _e883)), vec4<f32>(_e890, (_e690.member.member.z + _e848), _e895, (_e690.member.member_1.z - _e887))), type_46(type_24((_e690.member.member + vec4<f32>(_e818, _e827, _e836, 0f)), (_e690.member.member_1 - vec4<f32>(_e857, _e866, _e875, 0f))), _e985), type_46(type_24((_e690.member.member + vec4<f32>(_e840, _e844, _e848, 0f)), (_e690.member.member_1 - vec4<f32>(_e879, _e883, _e887, 0f))), _e1010));
                                        }
                                        let _e1015 = phi_3585_;
                                        let _e1027 = ((_e1015.member[0].x - _e367) * _e370);
                                        let _e1028 = ((_e1015.member[0].y - _e367) * _e370);
                                        let _e1029 = ((_e1015.member[0].z - _e368) * _e370);
                                        let _e1030 = ((_e1015.member[0].w - _e368) * _e370);
                                        let _e1040 = ((_e1015.member[1].x - _e433) * _e436);
                                        let _e1041 = ((_e1015.member[1].y - _e433) * _e436);
                                        let _e1042 = ((_e1015.member[1].z - _e434) * _e436);
                                        let _e1043 = ((_e1015.member[1].w - _e434) * _e436);
                                        let _e1053 = ((_e1015.member[2].x - _e499) * _e502);
                                        let _e1054 = ((_e1015.member[2].y - _e499) * _e502);
                                        let _e1055 = ((_e1015.member[2].z - _e500) * _e502);
                                        let _e1056 = ((_e1015.member[2].w - _e500) * _e502);
                                        let _e1058 = select(_e1055, _e1053, (_e1053 < _e1055));
                                        let _e1060 = select(_e1056, _e1054, (_e1054 < _e1056));
                                        let _e1062 = select(_e1055, _e1053, (_e1053 > _e1055));
                                        let _e1064 = select(_e1056, _e1054, (_e1054 > _e1056));
                                        let _e1066 = select(_e1029, _e1027, (_e1027 < _e1029));
                                        let _e1068 = select(_e1030, _e1028, (_e1028 < _e1030));
                                        let _e1070 = select(_e1042, _e1040, (_e1040 < _e1042));
                                        let _e1072 = select(_e1043, _e1041, (_e1041 < _e1043));
                                        let _e1074 = select(_e1070, _e1066, (_e1066 > _e1070));
                                        let _e1076 = select(_e1072, _e1068, (_e1068 > _e1072));
                                        let _e1078 = select(_e1058, _e1074, (_e1074 > _e1058));
                                        let _e1080 = select(_e1060, _e1076, (_e1076 > _e1060));
                                        let _e1082 = select(_e1029, _e1027, (_e1027 > _e1029));
                                        let _e1084 = select(_e1030, _e1028, (_e1028 > _e1030));
                                        let _e1086 = select(_e1042, _e1040, (_e1040 > _e1042));
                                        let _e1088 = select(_e1043, _e1041, (_e1041 > _e1043));
                                        let _e1090 = select(_e1086, _e1082, (_e1082 < _e1086));
                                        let _e1092 = select(_e1088, _e1084, (_e1084 < _e1088));
                                        let _e1097 = -(_e1058);
                                        let _e1098 = -(_e1060);
                                        let _e1105 = (select(_e1062, _e1090, (_e1090 < _e1062)) + (select(_e1097, _e1062, (_e1062 > _e1097)) * 0.0000019073523f));
                                        let _e1106 = (select(_e1064, _e1092, (_e1092 < _e1064)) + (select(_e1098, _e1064, (_e1064 > _e1098)) * 0.0000019073523f));
                                        let _e1108 = select(_e605, _e1078, (_e1078 > _e605));
                                        let _e1110 = select(_e605, _e1080, (_e1080 > _e605));
                                        let _e1115 = (_e1108 <= select(_e649.member, _e1105, (_e1105 < _e649.member)));
                                        let _e1116 = (_e1110 <= select(_e649.member, _e1106, (_e1106 < _e649.member)));
                                        let _e1117 = (_e1108 <= _e1110);
                                        if _e1115 {
                                            if _e1116 {
                                                if _e1117 {
                                                    phi_3947_ = _e1015.member_2;
                                                } else {
                                                    phi_3947_ = _e1015.member_1;
                                                }
                                                let _e1121 = phi_3947_;
                                                let _e1142 = (_e692 % 128u);
                                                let _e1143 = (_e1142 < 128u);
                                                if _e1143 {
                                                } else {
                                                    phi_4613_ = true;
                                                    break;
                                                }
                                                local_8[_e1142] = _e1121.member_1;
                                                if _e1143 {
                                                } else {
                                                    phi_4613_ = true;
                                                    break;
                                                }
                                                local_7[_e1142] = _e1121.member.member.x;
                                                if _e1143 {
                                                } else {
                                                    phi_4613_ = true;
                                                    break;
                                                }
                                                local_6[_e1142] = _e1121.member.member.y;
                                                if _e1143 {
                                                } else {
                                                    phi_4613_ = true;
                                                    break;
                                                }
                                                local_5[_e1142] = _e1121.member.member.z;
                                                if _e1143 {
                                                } else {
                                                    phi_4613_ = true;
                                                    break;
                                                }
                                                local_4[_e1142] = _e1121.member.member_1.x;
                                                if _e1143 {
                                                } else {
                                                    phi_4613_ = true;
                                                    break;
                                                }
                                                local_3[_e1142] = _e1121.member.member_1.y;
                                                if _e1143 {
                                                } else {
                                                    phi_4613_ = true;
                                                    break;
                                                }
                                                local_2[_e1142] = _e1121.member.member_1.z;
                                                if _e1143 {
                                                } else {
                                                    phi_4613_ = true;
                                                    break;
                                                }
                                                local_9[_e1142] = select(_e1108, _e1110, _e1117);
                                                if _e1117 {
                                                    phi_4023_ = _e1015.member_1;
                                                } else {
                                                    phi_4023_ = _e1015.member_2;
                                                }
                                                let _e1156 = phi_4023_;
                                                phi_4024_ = _e1156;
                                                phi_4025_ = (_e692 + 1u);
                                            } else {
                                                phi_4024_ = type_46();
                                                phi_4025_ = u32();
                                            }
                                            let _e1158 = phi_4024_;
                                            let _e1160 = phi_4025_;
                                            phi_4027_ = _e1158;
                                            phi_4028_ = _e1160;
                                            phi_4029_ = select(true, false, _e1116);
                                        } else {
                                            phi_4027_ = type_46();
                                            phi_4028_ = u32();
                                            phi_4029_ = true;
                                        }
                                        let _e1163 = phi_4027_;
                                        let _e1165 = phi_4028_;
                                        let _e1167 = phi_4029_;
                                        if _e1167 {
                                            if _e1115 {
                                                phi_4038_ = _e1015.member_1;
                                            } else {
                                                phi_4038_ = _e1015.member_2;
                                            }
                                            let _e1171 = phi_4038_;
                                            phi_4043_ = select(_e1116, true, _e1115);
                                            phi_4044_ = _e1171;
                                        } else {
                                            phi_4043_ = _e688;
                                            phi_4044_ = _e1163;
                                        }
                                        let _e1174 = phi_4043_;
                                        let _e1176 = phi_4044_;
                                        phi_4617_ = _e647;
                                        phi_4046_ = _e649;
                                        phi_4047_ = _e1174;
                                        phi_4048_ = _e1176;
                                        phi_4049_ = select(_e1165, _e692, _e1167);
                                    }
                                    let _e2094 = phi_4617_;
                                    let _e2096 = phi_4046_;
                                    let _e2098 = phi_4047_;
                                    let _e2100 = phi_4048_;
                                    let _e2102 = phi_4049_;
                                    phi_4616_ = _e2094;
                                    phi_4050_ = _e2096;
                                    phi_4051_ = _e2098;
                                    phi_4052_ = _e2100;
                                    phi_4053_ = _e2102;
                                    phi_4054_ = (_e657 - 1u);
                                } else {
                                    phi_4616_ = _e647;
                                    phi_4050_ = _e649;
                                    phi_4051_ = _e688;
                                    phi_4052_ = _e690;
                                    phi_4053_ = _e692;
                                    phi_4054_ = _e657;
                                }
                                let _e2104 = phi_4616_;
                                let _e2106 = phi_4050_;
                                let _e2108 = phi_4051_;
                                let _e2110 = phi_4052_;
                                let _e2112 = phi_4053_;
                                let _e2114 = phi_4054_;
                                phi_4615_ = _e2104;
                                phi_4055_ = _e2106;
                                phi_4056_ = _e2108;
                                phi_4057_ = _e2110;
                                phi_4058_ = _e2112;
                                phi_4059_ = _e2114;
                            } else {
                                phi_4615_ = _e647;
                                phi_4055_ = type_35();
                                phi_4056_ = bool();
                                phi_4057_ = type_46();
                                phi_4058_ = u32();
                                phi_4059_ = u32();
                            }
                            let _e2116 = phi_4615_;
                            let _e2118 = phi_4055_;
                            let _e2120 = phi_4056_;
                            let _e2122 = phi_4057_;
                            let _e2124 = phi_4058_;
                            let _e2126 = phi_4059_;
                            phi_4614_ = _e2116;
                            phi_1115_ = _e2118;
                            phi_1118_ = _e2120;
                            phi_1120_ = _e2122;
                            phi_1122_ = _e2124;
                            phi_1124_ = _e2126;
                            phi_4060_ = _e661;
                        } else {
                            phi_4614_ = _e647;
                            phi_1115_ = type_35();
                            phi_1118_ = bool();
                            phi_1120_ = type_46();
                            phi_1122_ = u32();
                            phi_1124_ = u32();
                            phi_4060_ = false;
                        }
                        let _e2128 = phi_4614_;
                        let _e2130 = phi_1115_;
                        let _e2132 = phi_1118_;
                        let _e2134 = phi_1120_;
                        let _e2136 = phi_1122_;
                        let _e2138 = phi_1124_;
                        let _e2140 = phi_4060_;
                        continue;
                        continuing {
                            phi_4422_ = _e2128;
                            phi_1114_ = _e2130;
                            phi_1117_ = _e2132;
                            phi_1119_ = _e2134;
                            phi_1121_ = _e2136;
                            phi_1123_ = _e2138;
                            phi_4613_ = _e2128;
                            break if !(_e2140);
                        }
                    }
                    let _e2143 = phi_4613_;
                    if _e2143 {
                        break;
                    }
                    let _e2145 = local_11;
                    if _e153 {
                    } else {
                        break;
                    }
                    global_4.member[_e151] = select(0u, 1u, _e2145.member_1);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_any_q21_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
