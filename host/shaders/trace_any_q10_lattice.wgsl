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

struct type_24 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_25 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_28 {
    member: vec4<f32>,
    member_1: vec4<f32>,
}

struct type_35 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: bool,
}

struct type_37 {
    member: array<type_25>,
}

struct type_39 {
    member: f32,
    member_1: bool,
}

struct type_41 {
    member: array<vec4<u32>, 2>,
}

struct type_46 {
    member: type_28,
    member_1: u32,
}

struct type_47 {
    member: array<vec4<f32>, 3>,
    member_1: type_46,
    member_2: type_46,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_16;
@group(0) @binding(1) 
var<uniform> global_2: type_41;
@group(0) @binding(2) 
var<storage> global_3: type_13;
@group(0) @binding(4) 
var<storage> global_4: type_37;
@group(0) @binding(5) 
var<storage, read_write> global_5: type_4;
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
    var phi_1114_: type_39;
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
    var phi_1241_: type_39;
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
    var phi_2753_: type_35;
    var phi_2754_: type_35;
    var phi_2757_: type_35;
    var phi_2758_: type_35;
    var phi_2759_: bool;
    var phi_2763_: type_35;
    var phi_2772_: type_24;
    var phi_2783_: type_39;
    var phi_2784_: type_39;
    var phi_1242_: type_39;
    var phi_4416_: bool;
    var local_10: type_39;
    var phi_4617_: bool;
    var phi_4046_: type_39;
    var phi_4047_: bool;
    var phi_4048_: type_46;
    var phi_4049_: u32;
    var phi_4616_: bool;
    var phi_4050_: type_39;
    var phi_4051_: bool;
    var phi_4052_: type_46;
    var phi_4053_: u32;
    var phi_4054_: u32;
    var phi_4615_: bool;
    var phi_4055_: type_39;
    var phi_4056_: bool;
    var phi_4057_: type_46;
    var phi_4058_: u32;
    var phi_4059_: u32;
    var phi_4614_: bool;
    var phi_1115_: type_39;
    var phi_1118_: bool;
    var phi_1120_: type_46;
    var phi_1122_: u32;
    var phi_1124_: u32;
    var phi_4060_: bool;
    var phi_4613_: bool;
    var local_11: type_39;
    var local_12: type_39;

    switch bitcast<i32>(0u) {
        default: {
            let _e95 = global;
            let _e97 = arrayLength((&global_3.member));
            let _e100 = arrayLength((&global_6.member));
            let _e108 = global_2.member[0u][0u];
            let _e112 = global_2.member[0u][1u];
            let _e116 = global_2.member[0u][2u];
            let _e120 = global_2.member[0u][3u];
            let _e124 = global_2.member[1u][0u];
            let _e128 = global_2.member[1u][1u];
            let _e132 = global_2.member[1u][2u];
            let _e135 = global_1.member[0u];
            let _e136 = bitcast<i32>(_e135);
            let _e148 = bitcast<f32>((bitcast<u32>((bitcast<i32>(_e120) + 127i)) << bitcast<u32>(23i)));
            local_1 = array<i32, 3>(bitcast<i32>(_e108), bitcast<i32>(_e112), bitcast<i32>(_e116));
            local = array<i32, 3>(bitcast<i32>(_e124), bitcast<i32>(_e128), bitcast<i32>(_e132));
            let _e154 = (_e95.x + (_e95.y * 2097152u));
            let _e155 = (_e154 < arrayLength((&global_4.member)));
            if _e155 {
                let _e156 = (_e154 < arrayLength((&global_5.member)));
                if _e156 {
                    if _e155 {
                    } else {
                        break;
                    }
                    let _e164 = global_4.member[_e154].member_2[0u];
                    let _e166 = (bitcast<u32>(_e164) & 2147483647u);
                    let _e171 = global_4.member[_e154].member_2[1u];
                    let _e173 = (bitcast<u32>(_e171) & 2147483647u);
                    let _e178 = global_4.member[_e154].member_2[2u];
                    let _e180 = (bitcast<u32>(_e178) & 2147483647u);
                    let _e185 = global_4.member[_e154].member[0u];
                    let _e187 = (bitcast<u32>(_e185) & 2147483647u);
                    let _e192 = global_4.member[_e154].member[1u];
                    let _e194 = (bitcast<u32>(_e192) & 2147483647u);
                    let _e199 = global_4.member[_e154].member[2u];
                    let _e201 = (bitcast<u32>(_e199) & 2147483647u);
                    let _e203 = select(_e173, _e166, (_e173 < _e166));
                    let _e205 = select(_e180, _e203, (_e180 < _e203));
                    let _e207 = select(_e187, _e205, (_e187 < _e205));
                    let _e209 = select(_e194, _e207, (_e194 < _e207));
                    let _e211 = select(_e201, _e209, (_e201 < _e209));
                    let _e215 = global_4.member[_e154].member_1;
                    let _e216 = bitcast<u32>(_e215);
                    let _e217 = (_e216 & 2147483647u);
                    let _e224 = global_4.member[_e154].member_3;
                    let _e225 = bitcast<u32>(_e224);
                    let _e226 = (_e225 & 2147483647u);
                    let _e230 = (((select(_e217, _e211, (_e217 < _e211)) < 2139095040u) && (_e226 <= 2139095040u)) && (_e205 > 0u));
                    if _e230 {
                        let _e233 = (bitcast<u32>(bitcast<f32>(_e205)) & 2147483647u);
                        if (_e233 >= 8388608u) {
                            phi_425_ = (bitcast<i32>((_e233 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_425_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e233)), 32u, (_e233 == 0u))));
                        }
                        let _e247 = phi_425_;
                        phi_426_ = _e247;
                    } else {
                        phi_426_ = 0i;
                    }
                    let _e249 = phi_426_;
                    let _e250 = (_e166 == _e205);
                    if _e250 {
                        phi_436_ = true;
                    } else {
                        phi_436_ = (_e173 == _e205);
                    }
                    let _e253 = phi_436_;
                    let _e254 = select(1u, 0u, _e250);
                    if _e253 {
                        let _e255 = (_e254 + 1u);
                        phi_446_ = _e255;
                        phi_447_ = _e255;
                        phi_449_ = select(true, false, (_e255 == 2u));
                    } else {
                        phi_446_ = u32();
                        phi_447_ = 0u;
                        phi_449_ = true;
                    }
                    let _e259 = phi_446_;
                    let _e261 = phi_447_;
                    let _e263 = phi_449_;
                    if _e263 {
                        phi_454_ = (_e261 + 1u);
                    } else {
                        phi_454_ = 0u;
                    }
                    let _e267 = phi_454_;
                    let _e268 = select(_e259, _e261, _e263);
                    let _e269 = select(_e254, select(2u, _e254, _e253), _e263);
                    if (_e136 < -126i) {
                        phi_467_ = -126i;
                    } else {
                        phi_467_ = select(_e136, 127i, (_e136 > 127i));
                    }
                    let _e274 = phi_467_;
                    let _e279 = bitcast<f32>((bitcast<u32>((_e274 + 127i)) << bitcast<u32>(23i)));
                    let _e285 = bitcast<f32>((bitcast<u32>(((_e136 - _e274) + 127i)) << bitcast<u32>(23i)));
                    let _e286 = -(_e249);
                    if (_e286 < -126i) {
                        phi_487_ = -126i;
                    } else {
                        phi_487_ = select(_e286, 127i, (_e286 > 127i));
                    }
                    let _e291 = phi_487_;
                    let _e296 = bitcast<f32>((bitcast<u32>((_e291 + 127i)) << bitcast<u32>(23i)));
                    let _e302 = bitcast<f32>((bitcast<u32>(((_e286 - _e291) + 127i)) << bitcast<u32>(23i)));
                    let _e306 = global_4.member[_e154].member;
                    let _e307 = (_e268 == 0u);
                    if _e307 {
                        phi_505_ = _e306[0];
                    } else {
                        phi_505_ = _e306[1];
                    }
                    let _e311 = phi_505_;
                    let _e312 = (_e268 == 2u);
                    if _e312 {
                        phi_511_ = _e306[2];
                    } else {
                        phi_511_ = _e311;
                    }
                    let _e315 = phi_511_;
                    let _e316 = bitcast<u32>(_e315);
                    let _e318 = ((_e316 & 2139095040u) != 0u);
                    let _e332 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e316 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e316 & 2147483648u))), _e315, _e318) * _e279) * select(0.00000011920929f, 1f, _e318)) * _e285);
                    let _e333 = global_4.member[_e154].member_2;
                    if _e307 {
                        phi_551_ = _e333[0];
                    } else {
                        phi_551_ = _e333[1];
                    }
                    let _e337 = phi_551_;
                    if _e312 {
                        phi_557_ = _e333[2];
                    } else {
                        phi_557_ = _e337;
                    }
                    let _e340 = phi_557_;
                    let _e341 = bitcast<u32>(_e340);
                    let _e343 = ((_e341 & 2139095040u) != 0u);
                    let _e357 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e341 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e341 & 2147483648u))), _e340, _e343) * _e296) * select(0.00000011920929f, 1f, _e343)) * _e302);
                    let _e361 = (bitcast<f32>((bitcast<u32>(_e357) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e364 = bitcast<f32>((bitcast<u32>(_e332) & 2147483647u));
                    let _e365 = (_e364 * 0.00000011920929f);
                    let _e368 = select(select(0.00000000000011368684f, _e365, (_e365 > 0.00000000000011368684f)), 0f, _e361);
                    let _e369 = select(0f, _e357, _e361);
                    let _e370 = (_e332 + _e368);
                    let _e371 = (_e332 - _e368);
                    let _e373 = select(38685626000000000000000000f, (1f / _e357), _e361);
                    let _e374 = (_e267 == 0u);
                    if _e374 {
                        phi_630_ = _e306[0];
                    } else {
                        phi_630_ = _e306[1];
                    }
                    let _e378 = phi_630_;
                    let _e379 = (_e267 == 2u);
                    if _e379 {
                        phi_636_ = _e306[2];
                    } else {
                        phi_636_ = _e378;
                    }
                    let _e382 = phi_636_;
                    let _e383 = bitcast<u32>(_e382);
                    let _e385 = ((_e383 & 2139095040u) != 0u);
                    let _e399 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e383 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e383 & 2147483648u))), _e382, _e385) * _e279) * select(0.00000011920929f, 1f, _e385)) * _e285);
                    if _e374 {
                        phi_676_ = _e333[0];
                    } else {
                        phi_676_ = _e333[1];
                    }
                    let _e403 = phi_676_;
                    if _e379 {
                        phi_682_ = _e333[2];
                    } else {
                        phi_682_ = _e403;
                    }
                    let _e406 = phi_682_;
                    let _e407 = bitcast<u32>(_e406);
                    let _e409 = ((_e407 & 2139095040u) != 0u);
                    let _e423 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e407 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e407 & 2147483648u))), _e406, _e409) * _e296) * select(0.00000011920929f, 1f, _e409)) * _e302);
                    let _e427 = (bitcast<f32>((bitcast<u32>(_e423) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e430 = bitcast<f32>((bitcast<u32>(_e399) & 2147483647u));
                    let _e431 = (_e430 * 0.00000011920929f);
                    let _e434 = select(select(0.00000000000011368684f, _e431, (_e431 > 0.00000000000011368684f)), 0f, _e427);
                    let _e435 = select(0f, _e423, _e427);
                    let _e436 = (_e399 + _e434);
                    let _e437 = (_e399 - _e434);
                    let _e439 = select(38685626000000000000000000f, (1f / _e423), _e427);
                    let _e440 = (_e269 == 0u);
                    if _e440 {
                        phi_755_ = _e306[0];
                    } else {
                        phi_755_ = _e306[1];
                    }
                    let _e444 = phi_755_;
                    let _e445 = (_e269 == 2u);
                    if _e445 {
                        phi_761_ = _e306[2];
                    } else {
                        phi_761_ = _e444;
                    }
                    let _e448 = phi_761_;
                    let _e449 = bitcast<u32>(_e448);
                    let _e451 = ((_e449 & 2139095040u) != 0u);
                    let _e465 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e449 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e449 & 2147483648u))), _e448, _e451) * _e279) * select(0.00000011920929f, 1f, _e451)) * _e285);
                    if _e440 {
                        phi_801_ = _e333[0];
                    } else {
                        phi_801_ = _e333[1];
                    }
                    let _e469 = phi_801_;
                    if _e445 {
                        phi_807_ = _e333[2];
                    } else {
                        phi_807_ = _e469;
                    }
                    let _e472 = phi_807_;
                    let _e473 = bitcast<u32>(_e472);
                    let _e475 = ((_e473 & 2139095040u) != 0u);
                    let _e489 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e473 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e473 & 2147483648u))), _e472, _e475) * _e296) * select(0.00000011920929f, 1f, _e475)) * _e302);
                    let _e493 = (bitcast<f32>((bitcast<u32>(_e489) & 2147483647u)) >= 0.00000000000000000086736174f);
                    let _e496 = bitcast<f32>((bitcast<u32>(_e465) & 2147483647u));
                    let _e497 = (_e496 * 0.00000011920929f);
                    let _e500 = select(select(0.00000000000011368684f, _e497, (_e497 > 0.00000000000011368684f)), 0f, _e493);
                    let _e501 = select(0f, _e489, _e493);
                    let _e502 = (_e465 + _e500);
                    let _e503 = (_e465 - _e500);
                    let _e505 = select(38685626000000000000000000f, (1f / _e489), _e493);
                    let _e507 = select(_e430, _e364, (_e364 > _e430));
                    let _e510 = (_e136 + _e249);
                    if (_e230 && (select(_e496, _e507, (_e507 > _e496)) <= 1099511600000f)) {
                        let _e520 = ((_e217 & 8388607u) | (select(0u, 1u, ((_e217 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e523 = bitcast<i32>((_e217 >> bitcast<u32>(23i)));
                        let _e527 = (_e520 == 0u);
                        let _e530 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e520)), 32u, _e527)) - 8i);
                        if (_e523 == 255i) {
                            phi_926_ = 255i;
                        } else {
                            phi_926_ = (((_e523 + select(0i, 1i, (_e523 == 0i))) - _e530) + _e510);
                        }
                        let _e538 = phi_926_;
                        let _e548 = (_e538 <= 0i);
                        if _e548 {
                            phi_949_ = u32();
                        } else {
                            if _e527 {
                                phi_948_ = u32();
                            } else {
                                phi_948_ = select(((bitcast<u32>(_e538) << bitcast<u32>(23i)) | ((_e520 << bitcast<u32>(((_e530 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e538 >= 255i));
                            }
                            let _e552 = phi_948_;
                            phi_949_ = _e552;
                        }
                        let _e554 = phi_949_;
                        let _e566 = ((_e226 & 8388607u) | (select(0u, 1u, ((_e226 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e569 = bitcast<i32>((_e226 >> bitcast<u32>(23i)));
                        let _e573 = (_e566 == 0u);
                        let _e576 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e566)), 32u, _e573)) - 8i);
                        if (_e569 == 255i) {
                            phi_986_ = 255i;
                        } else {
                            phi_986_ = (((_e569 + select(0i, 1i, (_e569 == 0i))) - _e576) + _e510);
                        }
                        let _e584 = phi_986_;
                        let _e594 = (_e584 <= 0i);
                        if _e594 {
                            phi_1009_ = u32();
                        } else {
                            if _e573 {
                                phi_1008_ = u32();
                            } else {
                                phi_1008_ = select(((bitcast<u32>(_e584) << bitcast<u32>(23i)) | ((_e566 << bitcast<u32>(((_e576 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e584 >= 255i));
                            }
                            let _e598 = phi_1008_;
                            phi_1009_ = _e598;
                        }
                        let _e600 = phi_1009_;
                        phi_1017_ = bitcast<f32>(((_e225 & 2147483648u) | select(_e600, 0u, select(_e573, true, _e594))));
                        phi_1018_ = bitcast<f32>(((_e216 & 2147483648u) | select(_e554, 0u, select(_e527, true, _e548))));
                    } else {
                        phi_1017_ = 0f;
                        phi_1018_ = 1f;
                    }
                    let _e606 = phi_1017_;
                    let _e608 = phi_1018_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e614 = (_e268 % 3u);
                    let _e615 = (_e614 < 3u);
                    if _e615 {
                    } else {
                        break;
                    }
                    let _e617 = local_1[_e614];
                    let _e620 = (_e267 % 3u);
                    let _e621 = (_e620 < 3u);
                    if _e621 {
                    } else {
                        break;
                    }
                    let _e623 = local_1[_e620];
                    let _e626 = (_e269 % 3u);
                    let _e627 = (_e626 < 3u);
                    if _e627 {
                    } else {
                        break;
                    }
                    let _e629 = local_1[_e626];
                    if _e615 {
                    } else {
                        break;
                    }
                    let _e634 = local[_e614];
                    if _e621 {
                    } else {
                        break;
                    }
                    let _e638 = local[_e620];
                    if _e627 {
                    } else {
                        break;
                    }
                    let _e642 = local[_e626];
                    phi_4422_ = false;
                    phi_1114_ = type_39(_e606, false);
                    phi_1117_ = (_e608 <= _e606);
                    phi_1119_ = type_46(type_28(vec4<f32>((f32(_e617) * _e148), (f32(_e623) * _e148), (f32(_e629) * _e148), 0f), vec4<f32>((f32(_e634) * _e148), (f32(_e638) * _e148), (f32(_e642) * _e148), 0f)), select(0u, 2147483648u, (_e97 == 0u)));
                    phi_1121_ = 0u;
                    phi_1123_ = ((3u * _e97) + 1u);
                    loop {
                        let _e650 = phi_4422_;
                        let _e652 = phi_1114_;
                        let _e654 = phi_1117_;
                        let _e656 = phi_1119_;
                        let _e658 = phi_1121_;
                        let _e660 = phi_1123_;
                        local_11 = _e652;
                        if _e654 {
                            phi_1134_ = true;
                        } else {
                            phi_1134_ = (_e658 > 0u);
                        }
                        let _e663 = phi_1134_;
                        if _e663 {
                            let _e664 = (_e660 > 0u);
                            if _e664 {
                                if _e654 {
                                    phi_1220_ = _e654;
                                    phi_1221_ = _e656;
                                    phi_1222_ = _e658;
                                } else {
                                    let _e665 = (_e658 - 1u);
                                    let _e666 = (_e665 % 128u);
                                    let _e667 = (_e666 < 128u);
                                    if _e667 {
                                    } else {
                                        phi_4613_ = true;
                                        break;
                                    }
                                    let _e669 = local_7[_e666];
                                    if _e667 {
                                    } else {
                                        phi_4613_ = true;
                                        break;
                                    }
                                    let _e671 = local_6[_e666];
                                    if _e667 {
                                    } else {
                                        phi_4613_ = true;
                                        break;
                                    }
                                    let _e673 = local_5[_e666];
                                    if _e667 {
                                    } else {
                                        phi_4613_ = true;
                                        break;
                                    }
                                    let _e675 = local_4[_e666];
                                    if _e667 {
                                    } else {
                                        phi_4613_ = true;
                                        break;
                                    }
                                    let _e677 = local_3[_e666];
                                    if _e667 {
                                    } else {
                                        phi_4613_ = true;
                                        break;
                                    }
                                    let _e679 = local_2[_e666];
                                    if _e667 {
                                    } else {
                                        phi_4613_ = true;
                                        break;
                                    }
                                    let _e684 = local_8[_e666];
                                    if _e667 {
                                    } else {
                                        phi_4613_ = true;
                                        break;
                                    }
                                    let _e687 = local_9[_e666];
                                    phi_1220_ = (_e687 <= _e652.member);
                                    phi_1221_ = type_46(type_28(vec4<f32>(_e669, _e671, _e673, 0f), vec4<f32>(_e675, _e677, _e679, 0f)), _e684);
                                    phi_1222_ = _e665;
                                }
                                let _e691 = phi_1220_;
                                let _e693 = phi_1221_;
                                let _e695 = phi_1222_;
                                if _e691 {
                                    let _e700 = (_e693.member_1 & 268435455u);
                                    if ((_e693.member_1 & 2147483648u) != 0u) {
                                        phi_1241_ = _e652;
                                        phi_1244_ = type_8(0u, ((_e693.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e1165 = phi_1241_;
                                            let _e1167 = phi_1244_;
                                            local_10 = _e1165;
                                            local_12 = _e1165;
                                            if (_e1167.member < _e1167.member_1) {
                                                phi_1245_ = type_8((_e1167.member + 1u), _e1167.member_1);
                                                phi_1267_ = type_8(1u, _e1167.member);
                                            } else {
                                                phi_1245_ = _e1167;
                                                phi_1267_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e1180 = phi_1245_;
                                            let _e1182 = phi_1267_;
                                            let _e1186 = (bitcast<i32>(_e1182.member) != 0i);
                                            if _e1186 {
                                                let _e1191 = (_e693.member.member_1.x - _e693.member.member.x);
                                                let _e1194 = (_e693.member.member_1.y - _e693.member.member.y);
                                                let _e1197 = (_e693.member.member_1.z - _e693.member.member.z);
                                                let _e1199 = select(_e1194, _e1191, (_e1191 > _e1194));
                                                let _e1201 = select(_e1197, _e1199, (_e1199 > _e1197));
                                                let _e1203 = (_e1201 < (1024f * _e148));
                                                if _e1203 {
                                                    phi_1308_ = 0u;
                                                } else {
                                                    phi_1308_ = select(2u, 1u, (_e1201 < (2097152f * _e148)));
                                                }
                                                let _e1208 = phi_1308_;
                                                switch bitcast<i32>(_e1208) {
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
                                                let _e1211 = phi_1314_;
                                                switch bitcast<i32>(_e1208) {
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
                                                let _e1218 = phi_1324_;
                                                let _e1220 = ((_e700 + (_e1182.member_1 * ((3u * _e1211) + 1u))) + (3u * _e1218));
                                                let _e1221 = (_e1220 < _e100);
                                                if _e1221 {
                                                    if _e1221 {
                                                    } else {
                                                        phi_4416_ = true;
                                                        break;
                                                    }
                                                    let _e1223 = global_6.member[_e1220];
                                                    phi_1340_ = _e1223;
                                                } else {
                                                    phi_1340_ = 4294967295u;
                                                }
                                                let _e1225 = phi_1340_;
                                                if _e1203 {
                                                    phi_1373_ = 0u;
                                                } else {
                                                    phi_1373_ = select(2u, 1u, (_e1201 < (2097152f * _e148)));
                                                }
                                                let _e1230 = phi_1373_;
                                                switch bitcast<i32>(_e1230) {
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
                                                let _e1233 = phi_1379_;
                                                let _e1237 = (_e700 + (_e1182.member_1 * ((3u * _e1233) + 1u)));
                                                switch bitcast<i32>(_e1230) {
                                                    case 0: {
                                                        let _e1512 = (_e1237 < _e100);
                                                        if _e1512 {
                                                            if _e1512 {
                                                            } else {
                                                                phi_4416_ = true;
                                                                break;
                                                            }
                                                            let _e1514 = global_6.member[_e1237];
                                                            phi_1406_ = _e1514;
                                                        } else {
                                                            phi_1406_ = 0u;
                                                        }
                                                        let _e1516 = phi_1406_;
                                                        let _e1518 = ((10u * _e268) & 31u);
                                                        let _e1528 = ((10u * _e267) & 31u);
                                                        let _e1538 = ((10u * _e269) & 31u);
                                                        let _e1548 = (_e1237 + 1u);
                                                        let _e1549 = (_e1548 < _e100);
                                                        if _e1549 {
                                                            if _e1549 {
                                                            } else {
                                                                phi_4416_ = true;
                                                                break;
                                                            }
                                                            let _e1551 = global_6.member[_e1548];
                                                            phi_1455_ = _e1551;
                                                        } else {
                                                            phi_1455_ = 0u;
                                                        }
                                                        let _e1553 = phi_1455_;
                                                        let _e1579 = (_e1237 + 2u);
                                                        let _e1580 = (_e1579 < _e100);
                                                        if _e1580 {
                                                            if _e1580 {
                                                            } else {
                                                                phi_4416_ = true;
                                                                break;
                                                            }
                                                            let _e1582 = global_6.member[_e1579];
                                                            phi_1504_ = _e1582;
                                                        } else {
                                                            phi_1504_ = 0u;
                                                        }
                                                        let _e1584 = phi_1504_;
                                                        phi_2005_ = array<array<f32, 3>, 3>(array<f32, 3>((_e693.member.member.x + ((bitcast<f32>((1258291200u | ((_e1516 >> bitcast<u32>(_e1518)) & 1023u))) - 8388608f) * _e148)), (_e693.member.member.y + ((bitcast<f32>((1258291200u | ((_e1516 >> bitcast<u32>(_e1528)) & 1023u))) - 8388608f) * _e148)), (_e693.member.member.z + ((bitcast<f32>((1258291200u | ((_e1516 >> bitcast<u32>(_e1538)) & 1023u))) - 8388608f) * _e148))), array<f32, 3>((_e693.member.member.x + ((bitcast<f32>((1258291200u | ((_e1553 >> bitcast<u32>(_e1518)) & 1023u))) - 8388608f) * _e148)), (_e693.member.member.y + ((bitcast<f32>((1258291200u | ((_e1553 >> bitcast<u32>(_e1528)) & 1023u))) - 8388608f) * _e148)), (_e693.member.member.z + ((bitcast<f32>((1258291200u | ((_e1553 >> bitcast<u32>(_e1538)) & 1023u))) - 8388608f) * _e148))), array<f32, 3>((_e693.member.member.x + ((bitcast<f32>((1258291200u | ((_e1584 >> bitcast<u32>(_e1518)) & 1023u))) - 8388608f) * _e148)), (_e693.member.member.y + ((bitcast<f32>((1258291200u | ((_e1584 >> bitcast<u32>(_e1528)) & 1023u))) - 8388608f) * _e148)), (_e693.member.member.z + ((bitcast<f32>((1258291200u | ((_e1584 >> bitcast<u32>(_e1538)) & 1023u))) - 8388608f) * _e148))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e1326 = (_e1237 < _e100);
                                                        if _e1326 {
                                                            if _e1326 {
                                                            } else {
                                                                phi_4416_ = true;
                                                                break;
                                                            }
                                                            let _e1328 = global_6.member[_e1237];
                                                            phi_1553_ = _e1328;
                                                        } else {
                                                            phi_1553_ = 0u;
                                                        }
                                                        let _e1330 = phi_1553_;
                                                        let _e1331 = (_e1237 + 1u);
                                                        let _e1332 = (_e1331 < _e100);
                                                        if _e1332 {
                                                            if _e1332 {
                                                            } else {
                                                                phi_4416_ = true;
                                                                break;
                                                            }
                                                            let _e1334 = global_6.member[_e1331];
                                                            phi_1568_ = _e1334;
                                                        } else {
                                                            phi_1568_ = 0u;
                                                        }
                                                        let _e1336 = phi_1568_;
                                                        let _e1337 = (_e268 == 1u);
                                                        if _e1337 {
                                                            phi_1578_ = ((_e1330 >> bitcast<u32>(21i)) | (_e1336 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1578_ = (_e1336 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1346 = phi_1578_;
                                                        let _e1354 = (_e267 == 1u);
                                                        if _e1354 {
                                                            phi_1599_ = ((_e1330 >> bitcast<u32>(21i)) | (_e1336 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1599_ = (_e1336 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1363 = phi_1599_;
                                                        let _e1371 = (_e269 == 1u);
                                                        if _e1371 {
                                                            phi_1620_ = ((_e1330 >> bitcast<u32>(21i)) | (_e1336 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1620_ = (_e1336 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1380 = phi_1620_;
                                                        let _e1389 = (_e1237 + 2u);
                                                        let _e1390 = (_e1389 < _e100);
                                                        if _e1390 {
                                                            if _e1390 {
                                                            } else {
                                                                phi_4416_ = true;
                                                                break;
                                                            }
                                                            let _e1392 = global_6.member[_e1389];
                                                            phi_1650_ = _e1392;
                                                        } else {
                                                            phi_1650_ = 0u;
                                                        }
                                                        let _e1394 = phi_1650_;
                                                        let _e1395 = (_e1237 + 3u);
                                                        let _e1396 = (_e1395 < _e100);
                                                        if _e1396 {
                                                            if _e1396 {
                                                            } else {
                                                                phi_4416_ = true;
                                                                break;
                                                            }
                                                            let _e1398 = global_6.member[_e1395];
                                                            phi_1665_ = _e1398;
                                                        } else {
                                                            phi_1665_ = 0u;
                                                        }
                                                        let _e1400 = phi_1665_;
                                                        if _e1337 {
                                                            phi_1675_ = ((_e1394 >> bitcast<u32>(21i)) | (_e1400 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1675_ = (_e1400 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1409 = phi_1675_;
                                                        if _e1354 {
                                                            phi_1696_ = ((_e1394 >> bitcast<u32>(21i)) | (_e1400 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1696_ = (_e1400 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1425 = phi_1696_;
                                                        if _e1371 {
                                                            phi_1717_ = ((_e1394 >> bitcast<u32>(21i)) | (_e1400 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1717_ = (_e1400 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1441 = phi_1717_;
                                                        let _e1450 = (_e1237 + 4u);
                                                        let _e1451 = (_e1450 < _e100);
                                                        if _e1451 {
                                                            if _e1451 {
                                                            } else {
                                                                phi_4416_ = true;
                                                                break;
                                                            }
                                                            let _e1453 = global_6.member[_e1450];
                                                            phi_1747_ = _e1453;
                                                        } else {
                                                            phi_1747_ = 0u;
                                                        }
                                                        let _e1455 = phi_1747_;
                                                        let _e1456 = (_e1237 + 5u);
                                                        let _e1457 = (_e1456 < _e100);
                                                        if _e1457 {
                                                            if _e1457 {
                                                            } else {
                                                                phi_4416_ = true;
                                                                break;
                                                            }
                                                            let _e1459 = global_6.member[_e1456];
                                                            phi_1762_ = _e1459;
                                                        } else {
                                                            phi_1762_ = 0u;
                                                        }
                                                        let _e1461 = phi_1762_;
                                                        if _e1337 {
                                                            phi_1772_ = ((_e1455 >> bitcast<u32>(21i)) | (_e1461 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1772_ = (_e1461 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1470 = phi_1772_;
                                                        if _e1354 {
                                                            phi_1793_ = ((_e1455 >> bitcast<u32>(21i)) | (_e1461 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1793_ = (_e1461 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1486 = phi_1793_;
                                                        if _e1371 {
                                                            phi_1814_ = ((_e1455 >> bitcast<u32>(21i)) | (_e1461 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1814_ = (_e1461 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1502 = phi_1814_;
                                                        phi_2005_ = array<array<f32, 3>, 3>(array<f32, 3>((_e693.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1346, _e1330, _e307) & 2097151u))) - 8388608f) * _e148)), (_e693.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1363, _e1330, _e374) & 2097151u))) - 8388608f) * _e148)), (_e693.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1380, _e1330, _e440) & 2097151u))) - 8388608f) * _e148))), array<f32, 3>((_e693.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1409, _e1394, _e307) & 2097151u))) - 8388608f) * _e148)), (_e693.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1425, _e1394, _e374) & 2097151u))) - 8388608f) * _e148)), (_e693.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1441, _e1394, _e440) & 2097151u))) - 8388608f) * _e148))), array<f32, 3>((_e693.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1470, _e1455, _e307) & 2097151u))) - 8388608f) * _e148)), (_e693.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1486, _e1455, _e374) & 2097151u))) - 8388608f) * _e148)), (_e693.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1502, _e1455, _e440) & 2097151u))) - 8388608f) * _e148))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e1239 = (_e1237 + _e268);
                                                        let _e1240 = (_e1239 < _e100);
                                                        if _e1240 {
                                                            if _e1240 {
                                                            } else {
                                                                phi_4416_ = true;
                                                                break;
                                                            }
                                                            let _e1242 = global_6.member[_e1239];
                                                            phi_1845_ = _e1242;
                                                        } else {
                                                            phi_1845_ = 0u;
                                                        }
                                                        let _e1244 = phi_1845_;
                                                        let _e1248 = (_e1237 + _e267);
                                                        let _e1249 = (_e1248 < _e100);
                                                        if _e1249 {
                                                            if _e1249 {
                                                            } else {
                                                                phi_4416_ = true;
                                                                break;
                                                            }
                                                            let _e1251 = global_6.member[_e1248];
                                                            phi_1863_ = _e1251;
                                                        } else {
                                                            phi_1863_ = 0u;
                                                        }
                                                        let _e1253 = phi_1863_;
                                                        let _e1257 = (_e1237 + _e269);
                                                        let _e1258 = (_e1257 < _e100);
                                                        if _e1258 {
                                                            if _e1258 {
                                                            } else {
                                                                phi_4416_ = true;
                                                                break;
                                                            }
                                                            let _e1260 = global_6.member[_e1257];
                                                            phi_1881_ = _e1260;
                                                        } else {
                                                            phi_1881_ = 0u;
                                                        }
                                                        let _e1262 = phi_1881_;
                                                        let _e1267 = (_e1237 + 3u);
                                                        let _e1268 = (_e1267 + _e268);
                                                        let _e1269 = (_e1268 < _e100);
                                                        if _e1269 {
                                                            if _e1269 {
                                                            } else {
                                                                phi_4416_ = true;
                                                                break;
                                                            }
                                                            let _e1271 = global_6.member[_e1268];
                                                            phi_1904_ = _e1271;
                                                        } else {
                                                            phi_1904_ = 0u;
                                                        }
                                                        let _e1273 = phi_1904_;
                                                        let _e1277 = (_e1267 + _e267);
                                                        let _e1278 = (_e1277 < _e100);
                                                        if _e1278 {
                                                            if _e1278 {
                                                            } else {
                                                                phi_4416_ = true;
                                                                break;
                                                            }
                                                            let _e1280 = global_6.member[_e1277];
                                                            phi_1922_ = _e1280;
                                                        } else {
                                                            phi_1922_ = 0u;
                                                        }
                                                        let _e1282 = phi_1922_;
                                                        let _e1286 = (_e1267 + _e269);
                                                        let _e1287 = (_e1286 < _e100);
                                                        if _e1287 {
                                                            if _e1287 {
                                                            } else {
                                                                phi_4416_ = true;
                                                                break;
                                                            }
                                                            let _e1289 = global_6.member[_e1286];
                                                            phi_1940_ = _e1289;
                                                        } else {
                                                            phi_1940_ = 0u;
                                                        }
                                                        let _e1291 = phi_1940_;
                                                        let _e1296 = (_e1237 + 6u);
                                                        let _e1297 = (_e1296 + _e268);
                                                        let _e1298 = (_e1297 < _e100);
                                                        if _e1298 {
                                                            if _e1298 {
                                                            } else {
                                                                phi_4416_ = true;
                                                                break;
                                                            }
                                                            let _e1300 = global_6.member[_e1297];
                                                            phi_1963_ = _e1300;
                                                        } else {
                                                            phi_1963_ = 0u;
                                                        }
                                                        let _e1302 = phi_1963_;
                                                        let _e1306 = (_e1296 + _e267);
                                                        let _e1307 = (_e1306 < _e100);
                                                        if _e1307 {
                                                            if _e1307 {
                                                            } else {
                                                                phi_4416_ = true;
                                                                break;
                                                            }
                                                            let _e1309 = global_6.member[_e1306];
                                                            phi_1981_ = _e1309;
                                                        } else {
                                                            phi_1981_ = 0u;
                                                        }
                                                        let _e1311 = phi_1981_;
                                                        let _e1315 = (_e1296 + _e269);
                                                        let _e1316 = (_e1315 < _e100);
                                                        if _e1316 {
                                                            if _e1316 {
                                                            } else {
                                                                phi_4416_ = true;
                                                                break;
                                                            }
                                                            let _e1318 = global_6.member[_e1315];
                                                            phi_1999_ = _e1318;
                                                        } else {
                                                            phi_1999_ = 0u;
                                                        }
                                                        let _e1320 = phi_1999_;
                                                        phi_2005_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e1244)) * _e148), (f32(bitcast<i32>(_e1253)) * _e148), (f32(bitcast<i32>(_e1262)) * _e148)), array<f32, 3>((f32(bitcast<i32>(_e1273)) * _e148), (f32(bitcast<i32>(_e1282)) * _e148), (f32(bitcast<i32>(_e1291)) * _e148)), array<f32, 3>((f32(bitcast<i32>(_e1302)) * _e148), (f32(bitcast<i32>(_e1311)) * _e148), (f32(bitcast<i32>(_e1320)) * _e148)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_2005_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1612 = phi_2005_;
                                                let _e1628 = (_e1612[0][2] - _e465);
                                                let _e1631 = (((_e1612[0][0] - _e332) * _e501) - (_e1628 * _e369));
                                                let _e1634 = (((_e1612[0][1] - _e399) * _e501) - (_e1628 * _e435));
                                                let _e1637 = (_e1612[1][2] - _e465);
                                                let _e1640 = (((_e1612[1][0] - _e332) * _e501) - (_e1637 * _e369));
                                                let _e1643 = (((_e1612[1][1] - _e399) * _e501) - (_e1637 * _e435));
                                                let _e1646 = (_e1612[2][2] - _e465);
                                                let _e1649 = (((_e1612[2][0] - _e332) * _e501) - (_e1646 * _e369));
                                                let _e1652 = (((_e1612[2][1] - _e399) * _e501) - (_e1646 * _e435));
                                                let _e1653 = (_e1649 * _e1643);
                                                let _e1654 = (_e1652 * _e1640);
                                                let _e1655 = (_e1631 * _e1652);
                                                let _e1656 = (_e1634 * _e1649);
                                                let _e1657 = (_e1640 * _e1634);
                                                let _e1658 = (_e1643 * _e1631);
                                                let _e1663 = (((_e1653 >= _e1654) && (_e1655 >= _e1656)) && (_e1657 >= _e1658));
                                                let _e1669 = (_e1663 || (((_e1653 <= _e1654) && (_e1655 <= _e1656)) && (_e1657 <= _e1658)));
                                                if _e1669 {
                                                    let _e1671 = select(-1f, 1f, _e1663);
                                                    let _e1673 = ((_e1653 - _e1654) * _e1671);
                                                    let _e1675 = select(0f, _e1673, (_e1673 > 0f));
                                                    let _e1677 = ((_e1655 - _e1656) * _e1671);
                                                    let _e1679 = select(0f, _e1677, (_e1677 > 0f));
                                                    let _e1681 = ((_e1657 - _e1658) * _e1671);
                                                    let _e1683 = select(0f, _e1681, (_e1681 > 0f));
                                                    let _e1685 = ((_e1675 + _e1679) + _e1683);
                                                    let _e1687 = select(_e1612[1][0], _e1612[0][0], (_e1612[0][0] < _e1612[1][0]));
                                                    let _e1691 = select(_e1612[1][0], _e1612[0][0], (_e1612[0][0] > _e1612[1][0]));
                                                    let _e1695 = select(_e1612[1][1], _e1612[0][1], (_e1612[0][1] < _e1612[1][1]));
                                                    let _e1699 = select(_e1612[1][1], _e1612[0][1], (_e1612[0][1] > _e1612[1][1]));
                                                    let _e1703 = select(_e1612[1][2], _e1612[0][2], (_e1612[0][2] < _e1612[1][2]));
                                                    let _e1707 = select(_e1612[1][2], _e1612[0][2], (_e1612[0][2] > _e1612[1][2]));
                                                    let _e1712 = ((select(_e1612[2][0], _e1687, (_e1687 < _e1612[2][0])) - _e370) * _e373);
                                                    let _e1713 = ((select(_e1612[2][0], _e1691, (_e1691 > _e1612[2][0])) - _e371) * _e373);
                                                    let _e1716 = ((select(_e1612[2][1], _e1695, (_e1695 < _e1612[2][1])) - _e436) * _e439);
                                                    let _e1717 = ((select(_e1612[2][1], _e1699, (_e1699 > _e1612[2][1])) - _e437) * _e439);
                                                    let _e1720 = ((select(_e1612[2][2], _e1703, (_e1703 < _e1612[2][2])) - _e502) * _e505);
                                                    let _e1721 = ((select(_e1612[2][2], _e1707, (_e1707 > _e1612[2][2])) - _e503) * _e505);
                                                    let _e1723 = select(_e1721, _e1720, (_e1720 < _e1721));
                                                    let _e1725 = select(_e1721, _e1720, (_e1720 > _e1721));
                                                    let _e1727 = select(_e1713, _e1712, (_e1712 < _e1713));
                                                    let _e1729 = select(_e1717, _e1716, (_e1716 < _e1717));
                                                    let _e1731 = select(_e1729, _e1727, (_e1727 > _e1729));
                                                    let _e1733 = select(_e1723, _e1731, (_e1731 > _e1723));
                                                    let _e1735 = select(_e1713, _e1712, (_e1712 > _e1713));
                                                    let _e1737 = select(_e1717, _e1716, (_e1716 > _e1717));
                                                    let _e1739 = select(_e1737, _e1735, (_e1735 < _e1737));
                                                    let _e1741 = select(_e1725, _e1739, (_e1739 < _e1725));
                                                    let _e1742 = -(_e1723);
                                                    let _e1748 = select(_e608, _e1733, (_e1733 > _e608));
                                                    let _e1752 = select(_e1640, _e1631, (_e1631 < _e1640));
                                                    let _e1757 = select(_e1640, _e1631, (_e1631 > _e1640));
                                                    let _e1764 = select(_e1643, _e1634, (_e1634 < _e1643));
                                                    let _e1769 = select(_e1643, _e1634, (_e1634 > _e1643));
                                                    let _e1778 = (((((_e1669 && (_e1685 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1649, _e1752, (_e1752 < _e1649)) <= 0f) && (select(_e1649, _e1757, (_e1757 > _e1649)) >= 0f))) && ((select(_e1652, _e1764, (_e1764 < _e1652)) <= 0f) && (select(_e1652, _e1769, (_e1769 > _e1652)) >= 0f))) && (_e1748 <= (_e1741 + (select(_e1742, _e1725, (_e1725 > _e1742)) * 0.0000019073523f)))) && (_e1748 <= _e1165.member));
                                                    if _e1778 {
                                                        let _e1783 = (_e1612[1][0] - _e1612[0][0]);
                                                        let _e1784 = (_e1612[1][1] - _e1612[0][1]);
                                                        let _e1785 = (_e1612[1][2] - _e1612[0][2]);
                                                        let _e1786 = vec3<f32>(_e1783, _e1784, _e1785);
                                                        let _e1787 = (_e1612[2][0] - _e1612[1][0]);
                                                        let _e1788 = (_e1612[2][1] - _e1612[1][1]);
                                                        let _e1789 = (_e1612[2][2] - _e1612[1][2]);
                                                        let _e1790 = vec3<f32>(_e1787, _e1788, _e1789);
                                                        let _e1791 = (_e1612[0][0] - _e1612[2][0]);
                                                        let _e1792 = (_e1612[0][1] - _e1612[2][1]);
                                                        let _e1793 = (_e1612[0][2] - _e1612[2][2]);
                                                        let _e1794 = vec3<f32>(_e1791, _e1792, _e1793);
                                                        let _e1797 = bitcast<f32>((bitcast<u32>(_e1783) & 2147483647u));
                                                        let _e1800 = bitcast<f32>((bitcast<u32>(_e1784) & 2147483647u));
                                                        let _e1802 = select(_e1800, _e1797, (_e1797 > _e1800));
                                                        let _e1805 = bitcast<f32>((bitcast<u32>(_e1785) & 2147483647u));
                                                        let _e1807 = select(_e1805, _e1802, (_e1802 > _e1805));
                                                        let _e1810 = bitcast<f32>((bitcast<u32>(_e1787) & 2147483647u));
                                                        let _e1813 = bitcast<f32>((bitcast<u32>(_e1788) & 2147483647u));
                                                        let _e1815 = select(_e1813, _e1810, (_e1810 > _e1813));
                                                        let _e1818 = bitcast<f32>((bitcast<u32>(_e1789) & 2147483647u));
                                                        let _e1820 = select(_e1818, _e1815, (_e1815 > _e1818));
                                                        let _e1823 = bitcast<f32>((bitcast<u32>(_e1791) & 2147483647u));
                                                        let _e1826 = bitcast<f32>((bitcast<u32>(_e1792) & 2147483647u));
                                                        let _e1828 = select(_e1826, _e1823, (_e1823 > _e1826));
                                                        let _e1831 = bitcast<f32>((bitcast<u32>(_e1793) & 2147483647u));
                                                        let _e1833 = select(_e1831, _e1828, (_e1828 > _e1831));
                                                        let _e1835 = select(_e1820, _e1807, (_e1807 > _e1820));
                                                        let _e1837 = select(_e1833, _e1835, (_e1835 > _e1833));
                                                        if (_e1807 == _e1837) {
                                                            phi_2535_ = _e1643;
                                                            phi_2536_ = _e1640;
                                                            phi_2537_ = _e1634;
                                                            phi_2538_ = _e1631;
                                                            phi_2539_ = vec3<f32>(_e1612[0][0], _e1612[0][1], _e1612[0][2]);
                                                            phi_2540_ = _e1794;
                                                            phi_2541_ = _e1790;
                                                            phi_2542_ = _e1786;
                                                        } else {
                                                            let _e1839 = (_e1820 == _e1837);
                                                            let _e1844 = vec3(_e1839);
                                                            phi_2535_ = select(_e1634, _e1652, _e1839);
                                                            phi_2536_ = select(_e1631, _e1649, _e1839);
                                                            phi_2537_ = select(_e1652, _e1643, _e1839);
                                                            phi_2538_ = select(_e1649, _e1640, _e1839);
                                                            phi_2539_ = select(vec3<f32>(_e1612[2][0], _e1612[2][1], _e1612[2][2]), vec3<f32>(_e1612[1][0], _e1612[1][1], _e1612[1][2]), _e1844);
                                                            phi_2540_ = select(_e1790, _e1786, _e1844);
                                                            phi_2541_ = select(_e1786, _e1794, _e1844);
                                                            phi_2542_ = select(_e1794, _e1790, _e1844);
                                                        }
                                                        let _e1850 = phi_2535_;
                                                        let _e1852 = phi_2536_;
                                                        let _e1854 = phi_2537_;
                                                        let _e1856 = phi_2538_;
                                                        let _e1858 = phi_2539_;
                                                        let _e1860 = phi_2540_;
                                                        let _e1862 = phi_2541_;
                                                        let _e1864 = phi_2542_;
                                                        let _e1871 = ((_e1862.y * _e1860.z) - (_e1860.y * _e1862.z));
                                                        let _e1876 = ((_e1862.z * _e1860.x) - (_e1860.z * _e1862.x));
                                                        let _e1879 = ((_e1862.x * _e1860.y) - (_e1860.x * _e1862.y));
                                                        let _e1882 = ((_e1675 >= _e1679) && (_e1675 >= _e1683));
                                                        let _e1883 = (_e1679 >= _e1683);
                                                        let _e1897 = (((_e1871 * (select(select(_e1612[2][0], _e1612[1][0], _e1883), _e1612[0][0], _e1882) - _e332)) + (_e1876 * (select(select(_e1612[2][1], _e1612[1][1], _e1883), _e1612[0][1], _e1882) - _e399))) + (_e1879 * (select(select(_e1612[2][2], _e1612[1][2], _e1883), _e1612[0][2], _e1882) - _e465)));
                                                        let _e1902 = (((_e1871 * _e369) + (_e1876 * _e435)) + (_e1879 * _e501));
                                                        let _e1903 = (_e1852 - _e1856);
                                                        let _e1904 = (_e1850 - _e1854);
                                                        let _e1907 = ((_e1903 * _e1903) + (_e1904 * _e1904));
                                                        let _e1914 = (-(((_e1856 * _e1903) + (_e1854 * _e1904))) / select(0.000000000000000000000000000000000000011754944f, _e1907, (_e1907 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1916 = select(1f, _e1914, (_e1914 < 1f));
                                                        let _e1918 = select(0f, _e1916, (_e1916 > 0f));
                                                        let _e1927 = ((_e1858.x + (_e1864.x * _e1918)) - _e332);
                                                        let _e1930 = ((_e1858.y + (_e1864.y * _e1918)) - _e399);
                                                        let _e1933 = ((_e1858.z + (_e1864.z * _e1918)) - _e465);
                                                        let _e1936 = bitcast<f32>((bitcast<u32>(_e1927) & 2147483647u));
                                                        let _e1939 = bitcast<f32>((bitcast<u32>(_e1930) & 2147483647u));
                                                        let _e1941 = select(_e1939, _e1936, (_e1936 > _e1939));
                                                        let _e1944 = bitcast<f32>((bitcast<u32>(_e1933) & 2147483647u));
                                                        let _e1946 = select(_e1944, _e1941, (_e1941 > _e1944));
                                                        let _e1952 = bitcast<f32>((bitcast<u32>(_e1871) & 2147483647u));
                                                        let _e1955 = bitcast<f32>((bitcast<u32>(_e1876) & 2147483647u));
                                                        let _e1957 = select(_e1955, _e1952, (_e1952 > _e1955));
                                                        let _e1960 = bitcast<f32>((bitcast<u32>(_e1879) & 2147483647u));
                                                        let _e1979 = bitcast<f32>((bitcast<u32>(_e1862.x) & 2147483647u));
                                                        let _e1982 = bitcast<f32>((bitcast<u32>(_e1862.y) & 2147483647u));
                                                        let _e1984 = select(_e1982, _e1979, (_e1979 > _e1982));
                                                        let _e1987 = bitcast<f32>((bitcast<u32>(_e1862.z) & 2147483647u));
                                                        let _e1993 = bitcast<f32>((bitcast<u32>(_e1860.x) & 2147483647u));
                                                        let _e1996 = bitcast<f32>((bitcast<u32>(_e1860.y) & 2147483647u));
                                                        let _e1998 = select(_e1996, _e1993, (_e1993 > _e1996));
                                                        let _e2001 = bitcast<f32>((bitcast<u32>(_e1860.z) & 2147483647u));
                                                        let _e2007 = ((bitcast<f32>((bitcast<u32>(((((_e1871 * _e1927) + (_e1876 * _e1930)) + (_e1879 * _e1933)) - _e1897)) & 2147483647u)) <= ((0.0000009536743f * select(_e1837, _e1946, (_e1946 > _e1837))) * select(_e1960, _e1957, (_e1957 > _e1960)))) && !((bitcast<f32>((bitcast<u32>(_e1902) & 2147483647u)) <= ((0.0000038146973f * select(_e1987, _e1984, (_e1984 > _e1987))) * select(_e2001, _e1998, (_e1998 > _e2001))))));
                                                        let _e2008 = (_e1897 / _e1902);
                                                        if (_e1778 && !(_e2007)) {
                                                            let _e2011 = (_e1933 / _e501);
                                                            let _e2019 = (((_e1871 * (_e1927 - (_e369 * _e2011))) + (_e1876 * (_e1930 - (_e435 * _e2011)))) / _e1902);
                                                            phi_2733_ = select(select(_e2011, (_e2011 + _e2019), (bitcast<f32>((bitcast<u32>(_e2019) & 2147483647u)) <= _e1837)), _e2008, _e2007);
                                                        } else {
                                                            phi_2733_ = _e2008;
                                                        }
                                                        let _e2028 = phi_2733_;
                                                        let _e2030 = select(_e1741, _e2028, (_e2028 < _e1741));
                                                        let _e2032 = select(_e1733, _e2030, (_e2030 > _e1733));
                                                        let _e2033 = (1f / _e1685);
                                                        phi_2753_ = type_35(_e2032, (_e1679 * _e2033), (_e1683 * _e2033), ((_e1778 && (_e2032 >= _e608)) && (_e2032 <= _e1165.member)));
                                                        phi_2754_ = type_35();
                                                    } else {
                                                        phi_2753_ = type_35();
                                                        phi_2754_ = type_35(0f, 0f, 0f, _e1778);
                                                    }
                                                    let _e2042 = phi_2753_;
                                                    let _e2044 = phi_2754_;
                                                    phi_2757_ = _e2042;
                                                    phi_2758_ = _e2044;
                                                    phi_2759_ = select(true, false, _e1778);
                                                } else {
                                                    phi_2757_ = type_35();
                                                    phi_2758_ = type_35(0f, 0f, 0f, _e1669);
                                                    phi_2759_ = true;
                                                }
                                                let _e2047 = phi_2757_;
                                                let _e2049 = phi_2758_;
                                                let _e2051 = phi_2759_;
                                                if _e2051 {
                                                    phi_2763_ = _e2049;
                                                } else {
                                                    phi_2763_ = _e2047;
                                                }
                                                let _e2053 = phi_2763_;
                                                if _e2053.member_3 {
                                                    phi_2772_ = type_24(_e2053.member, _e2053.member_1, _e2053.member_2, _e1225);
                                                } else {
                                                    phi_2772_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e2060 = phi_2772_;
                                                if (_e2060.member_3 != 4294967295u) {
                                                    if (_e1225 != 4294967295u) {
                                                        phi_2783_ = type_39(-340282350000000000000000000000000000000f, true);
                                                    } else {
                                                        phi_2783_ = _e1165;
                                                    }
                                                    let _e2065 = phi_2783_;
                                                    phi_2784_ = _e2065;
                                                } else {
                                                    phi_2784_ = _e1165;
                                                }
                                                let _e2067 = phi_2784_;
                                                phi_1242_ = _e2067;
                                            } else {
                                                phi_1242_ = type_39();
                                            }
                                            let _e2069 = phi_1242_;
                                            continue;
                                            continuing {
                                                phi_1241_ = _e2069;
                                                phi_1244_ = _e1180;
                                                phi_4416_ = _e650;
                                                break if !(_e1186);
                                            }
                                        }
                                        let _e2072 = phi_4416_;
                                        phi_4613_ = _e2072;
                                        if _e2072 {
                                            break;
                                        }
                                        let _e2074 = local_10;
                                        phi_4617_ = _e2072;
                                        let _e2256 = local_12;
                                        phi_4046_ = _e2256;
                                        phi_4047_ = false;
                                        phi_4048_ = _e693;
                                        phi_4049_ = select(_e695, 0u, (_e608 > _e2074.member));
                                    } else {
                                        if (_e693.member_1 >= _e97) {
                                            phi_3585_ = type_47(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_46(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_46(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e693.member_1 < _e97) {
                                            } else {
                                                phi_4613_ = true;
                                                break;
                                            }
                                            let _e708 = ((1u + _e268) % 4u);
                                            if (_e708 < 4u) {
                                            } else {
                                                phi_4613_ = true;
                                                break;
                                            }
                                            let _e713 = global_3.member[_e693.member_1][_e708];
                                            let _e715 = (_e713 >> bitcast<u32>(11u));
                                            let _e717 = ((1u + _e267) % 4u);
                                            if (_e717 < 4u) {
                                            } else {
                                                phi_4613_ = true;
                                                break;
                                            }
                                            let _e722 = global_3.member[_e693.member_1][_e717];
                                            let _e724 = (_e722 >> bitcast<u32>(11u));
                                            let _e726 = ((1u + _e269) % 4u);
                                            if (_e726 < 4u) {
                                            } else {
                                                phi_4613_ = true;
                                                break;
                                            }
                                            let _e731 = global_3.member[_e693.member_1][_e726];
                                            let _e733 = (_e731 >> bitcast<u32>(11u));
                                            let _e756 = (bitcast<f32>((bitcast<u32>((_e693.member.member_1.x - _e693.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e757 = (bitcast<f32>((bitcast<u32>((_e693.member.member_1.y - _e693.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e758 = (bitcast<f32>((bitcast<u32>((_e693.member.member_1.z - _e693.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e760 = select(_e148, _e756, (_e756 > _e148));
                                            let _e762 = select(_e148, _e757, (_e757 > _e148));
                                            let _e764 = select(_e148, _e758, (_e758 > _e148));
                                            let _e795 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e713 & 1023u))) - 8388608f) * _e760));
                                            let _e800 = (bitcast<i32>((_e713 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e803 = bitcast<f32>((_e795 & bitcast<u32>(_e800)));
                                            let _e804 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e722 & 1023u))) - 8388608f) * _e762));
                                            let _e809 = (bitcast<i32>((_e722 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e812 = bitcast<f32>((_e804 & bitcast<u32>(_e809)));
                                            let _e813 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e731 & 1023u))) - 8388608f) * _e764));
                                            let _e818 = (bitcast<i32>((_e731 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e821 = bitcast<f32>((_e813 & bitcast<u32>(_e818)));
                                            let _e825 = bitcast<f32>((_e795 & bitcast<u32>(~(_e800))));
                                            let _e829 = bitcast<f32>((_e804 & bitcast<u32>(~(_e809))));
                                            let _e833 = bitcast<f32>((_e813 & bitcast<u32>(~(_e818))));
                                            let _e834 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e715 & 1023u))) - 8388608f) * _e760));
                                            let _e839 = (bitcast<i32>((_e715 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e842 = bitcast<f32>((_e834 & bitcast<u32>(_e839)));
                                            let _e843 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e724 & 1023u))) - 8388608f) * _e762));
                                            let _e848 = (bitcast<i32>((_e724 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e851 = bitcast<f32>((_e843 & bitcast<u32>(_e848)));
                                            let _e852 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e733 & 1023u))) - 8388608f) * _e764));
                                            let _e857 = (bitcast<i32>((_e733 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e860 = bitcast<f32>((_e852 & bitcast<u32>(_e857)));
                                            let _e864 = bitcast<f32>((_e834 & bitcast<u32>(~(_e839))));
                                            let _e868 = bitcast<f32>((_e843 & bitcast<u32>(~(_e848))));
                                            let _e872 = bitcast<f32>((_e852 & bitcast<u32>(~(_e857))));
                                            let _e873 = (_e693.member.member.x + _e803);
                                            let _e874 = (_e693.member.member.y + _e812);
                                            let _e875 = (_e693.member.member.z + _e821);
                                            let _e878 = (_e693.member.member_1.x - _e842);
                                            let _e879 = (_e693.member.member_1.y - _e851);
                                            let _e880 = (_e693.member.member_1.z - _e860);
                                            let _e899 = (_e878 - _e873);
                                            let _e900 = (_e879 - _e874);
                                            let _e901 = (_e880 - _e875);
                                            let _e903 = select(_e900, _e899, (_e899 > _e900));
                                            let _e905 = select(_e901, _e903, (_e903 > _e901));
                                            if (_e905 < (1024f * _e148)) {
                                                phi_3286_ = 0u;
                                            } else {
                                                phi_3286_ = select(2u, 1u, (_e905 < (2097152f * _e148)));
                                            }
                                            let _e912 = phi_3286_;
                                            switch bitcast<i32>(_e912) {
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
                                            let _e915 = phi_3292_;
                                            let _e921 = global_3.member[_e693.member_1][0u];
                                            let _e925 = global_3.member[_e693.member_1][1u];
                                            let _e929 = global_3.member[_e693.member_1][2u];
                                            let _e933 = global_3.member[_e693.member_1][3u];
                                            let _e945 = (((_e925 >> bitcast<u32>(22i)) | ((_e929 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e933 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e946 = (_e921 & 268435455u);
                                            let _e947 = (_e945 & 268435455u);
                                            let _e950 = ((_e921 >> bitcast<u32>(28u)) & 7u);
                                            let _e958 = ((_e921 >> bitcast<u32>(31i)) | (((_e945 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e959 = (_e950 != 0u);
                                            if (_e950 == 0u) {
                                                phi_3547_ = _e946;
                                            } else {
                                                if (_e950 == 7u) {
                                                    phi_3546_ = 2147483648u;
                                                } else {
                                                    phi_3546_ = ((2147483648u | (_e950 << bitcast<u32>(28u))) | (_e947 & 268435455u));
                                                }
                                                let _e968 = phi_3546_;
                                                phi_3547_ = _e968;
                                            }
                                            let _e970 = phi_3547_;
                                            if _e959 {
                                                let _e971 = (_e950 != 7u);
                                                if _e971 {
                                                    phi_3557_ = (_e947 + (_e950 * ((3u * _e915) + 1u)));
                                                } else {
                                                    phi_3557_ = u32();
                                                }
                                                let _e975 = phi_3557_;
                                                phi_3559_ = _e975;
                                                phi_3560_ = select(true, false, _e971);
                                            } else {
                                                phi_3559_ = u32();
                                                phi_3560_ = true;
                                            }
                                            let _e978 = phi_3559_;
                                            let _e980 = phi_3560_;
                                            if (_e958 == 0u) {
                                                phi_3581_ = (_e946 + select(0u, 1u, !(_e959)));
                                            } else {
                                                if (_e958 == 7u) {
                                                    phi_3580_ = 2147483648u;
                                                } else {
                                                    phi_3580_ = ((2147483648u | (_e958 << bitcast<u32>(28u))) | (select(_e978, _e947, _e980) & 268435455u));
                                                }
                                                let _e993 = phi_3580_;
                                                phi_3581_ = _e993;
                                            }
                                            let _e995 = phi_3581_;
                                            phi_3585_ = type_47(array<vec4<f32>, 3>(vec4<f32>(_e873, (_e693.member.member.x + _e825), _e878, (_e693.member.member_1.x - _e864)), vec4<f32>(_e874, (_e693.member.member.y + _e829), _e879, (_e693.member.member_1.y - _e868)), vec4<f32>(_e875, (_e693.member.member.z + _e833), _e880, (_e693.member.member_1.z - _e872))), type_46(type_28((_e693.member.member + vec4<f32>(_e803, _e812, _e821, 0f)), (_e693.member.member_1 - vec4<f32>(_e842, _e851, _e860, 0f))), _e970), type_46(type_28((_e693.member.member + vec4<f32>(_e825, _e829, _e833, 0f)), (_e693.member.member_1 - vec4<f32>(_e864, _e868, _e872, 0f))), _e995));
                                        }
                                        let _e1000 = phi_3585_;
                                        let _e1012 = ((_e1000.member[0].x - _e370) * _e373);
                                        let _e1013 = ((_e1000.member[0].y - _e370) * _e373);
                                        let _e1014 = ((_e1000.member[0].z - _e371) * _e373);
                                        let _e1015 = ((_e1000.member[0].w - _e371) * _e373);
                                        let _e1025 = ((_e1000.member[1].x - _e436) * _e439);
                                        let _e1026 = ((_e1000.member[1].y - _e436) * _e439);
                                        let _e1027 = ((_e1000.member[1].z - _e437) * _e439);
                                        let _e1028 = ((_e1000.member[1].w - _e437) * _e439);
                                        let _e1038 = ((_e1000.member[2].x - _e502) * _e505);
                                        let _e1039 = ((_e1000.member[2].y - _e502) * _e505);
                                        let _e1040 = ((_e1000.member[2].z - _e503) * _e505);
                                        let _e1041 = ((_e1000.member[2].w - _e503) * _e505);
                                        let _e1043 = select(_e1040, _e1038, (_e1038 < _e1040));
                                        let _e1045 = select(_e1041, _e1039, (_e1039 < _e1041));
                                        let _e1047 = select(_e1040, _e1038, (_e1038 > _e1040));
                                        let _e1049 = select(_e1041, _e1039, (_e1039 > _e1041));
                                        let _e1051 = select(_e1014, _e1012, (_e1012 < _e1014));
                                        let _e1053 = select(_e1015, _e1013, (_e1013 < _e1015));
                                        let _e1055 = select(_e1027, _e1025, (_e1025 < _e1027));
                                        let _e1057 = select(_e1028, _e1026, (_e1026 < _e1028));
                                        let _e1059 = select(_e1055, _e1051, (_e1051 > _e1055));
                                        let _e1061 = select(_e1057, _e1053, (_e1053 > _e1057));
                                        let _e1063 = select(_e1043, _e1059, (_e1059 > _e1043));
                                        let _e1065 = select(_e1045, _e1061, (_e1061 > _e1045));
                                        let _e1067 = select(_e1014, _e1012, (_e1012 > _e1014));
                                        let _e1069 = select(_e1015, _e1013, (_e1013 > _e1015));
                                        let _e1071 = select(_e1027, _e1025, (_e1025 > _e1027));
                                        let _e1073 = select(_e1028, _e1026, (_e1026 > _e1028));
                                        let _e1075 = select(_e1071, _e1067, (_e1067 < _e1071));
                                        let _e1077 = select(_e1073, _e1069, (_e1069 < _e1073));
                                        let _e1082 = -(_e1043);
                                        let _e1083 = -(_e1045);
                                        let _e1090 = (select(_e1047, _e1075, (_e1075 < _e1047)) + (select(_e1082, _e1047, (_e1047 > _e1082)) * 0.0000019073523f));
                                        let _e1091 = (select(_e1049, _e1077, (_e1077 < _e1049)) + (select(_e1083, _e1049, (_e1049 > _e1083)) * 0.0000019073523f));
                                        let _e1093 = select(_e608, _e1063, (_e1063 > _e608));
                                        let _e1095 = select(_e608, _e1065, (_e1065 > _e608));
                                        let _e1100 = (_e1093 <= select(_e652.member, _e1090, (_e1090 < _e652.member)));
                                        let _e1101 = (_e1095 <= select(_e652.member, _e1091, (_e1091 < _e652.member)));
                                        let _e1102 = (_e1093 <= _e1095);
                                        if _e1100 {
                                            if _e1101 {
                                                if _e1102 {
                                                    phi_3947_ = _e1000.member_2;
                                                } else {
                                                    phi_3947_ = _e1000.member_1;
                                                }
                                                let _e1106 = phi_3947_;
                                                let _e1127 = (_e695 % 128u);
                                                let _e1128 = (_e1127 < 128u);
                                                if _e1128 {
                                                } else {
                                                    phi_4613_ = true;
                                                    break;
                                                }
                                                local_8[_e1127] = _e1106.member_1;
                                                if _e1128 {
                                                } else {
                                                    phi_4613_ = true;
                                                    break;
                                                }
                                                local_7[_e1127] = _e1106.member.member.x;
                                                if _e1128 {
                                                } else {
                                                    phi_4613_ = true;
                                                    break;
                                                }
                                                local_6[_e1127] = _e1106.member.member.y;
                                                if _e1128 {
                                                } else {
                                                    phi_4613_ = true;
                                                    break;
                                                }
                                                local_5[_e1127] = _e1106.member.member.z;
                                                if _e1128 {
                                                } else {
                                                    phi_4613_ = true;
                                                    break;
                                                }
                                                local_4[_e1127] = _e1106.member.member_1.x;
                                                if _e1128 {
                                                } else {
                                                    phi_4613_ = true;
                                                    break;
                                                }
                                                local_3[_e1127] = _e1106.member.member_1.y;
                                                if _e1128 {
                                                } else {
                                                    phi_4613_ = true;
                                                    break;
                                                }
                                                local_2[_e1127] = _e1106.member.member_1.z;
                                                if _e1128 {
                                                } else {
                                                    phi_4613_ = true;
                                                    break;
                                                }
                                                local_9[_e1127] = select(_e1093, _e1095, _e1102);
                                                if _e1102 {
                                                    phi_4023_ = _e1000.member_1;
                                                } else {
                                                    phi_4023_ = _e1000.member_2;
                                                }
                                                let _e1141 = phi_4023_;
                                                phi_4024_ = _e1141;
                                                phi_4025_ = (_e695 + 1u);
                                            } else {
                                                phi_4024_ = type_46();
                                                phi_4025_ = u32();
                                            }
                                            let _e1143 = phi_4024_;
                                            let _e1145 = phi_4025_;
                                            phi_4027_ = _e1143;
                                            phi_4028_ = _e1145;
                                            phi_4029_ = select(true, false, _e1101);
                                        } else {
                                            phi_4027_ = type_46();
                                            phi_4028_ = u32();
                                            phi_4029_ = true;
                                        }
                                        let _e1148 = phi_4027_;
                                        let _e1150 = phi_4028_;
                                        let _e1152 = phi_4029_;
                                        if _e1152 {
                                            if _e1100 {
                                                phi_4038_ = _e1000.member_1;
                                            } else {
                                                phi_4038_ = _e1000.member_2;
                                            }
                                            let _e1156 = phi_4038_;
                                            phi_4043_ = select(_e1101, true, _e1100);
                                            phi_4044_ = _e1156;
                                        } else {
                                            phi_4043_ = _e691;
                                            phi_4044_ = _e1148;
                                        }
                                        let _e1159 = phi_4043_;
                                        let _e1161 = phi_4044_;
                                        phi_4617_ = _e650;
                                        phi_4046_ = _e652;
                                        phi_4047_ = _e1159;
                                        phi_4048_ = _e1161;
                                        phi_4049_ = select(_e1150, _e695, _e1152);
                                    }
                                    let _e2079 = phi_4617_;
                                    let _e2081 = phi_4046_;
                                    let _e2083 = phi_4047_;
                                    let _e2085 = phi_4048_;
                                    let _e2087 = phi_4049_;
                                    phi_4616_ = _e2079;
                                    phi_4050_ = _e2081;
                                    phi_4051_ = _e2083;
                                    phi_4052_ = _e2085;
                                    phi_4053_ = _e2087;
                                    phi_4054_ = (_e660 - 1u);
                                } else {
                                    phi_4616_ = _e650;
                                    phi_4050_ = _e652;
                                    phi_4051_ = _e691;
                                    phi_4052_ = _e693;
                                    phi_4053_ = _e695;
                                    phi_4054_ = _e660;
                                }
                                let _e2089 = phi_4616_;
                                let _e2091 = phi_4050_;
                                let _e2093 = phi_4051_;
                                let _e2095 = phi_4052_;
                                let _e2097 = phi_4053_;
                                let _e2099 = phi_4054_;
                                phi_4615_ = _e2089;
                                phi_4055_ = _e2091;
                                phi_4056_ = _e2093;
                                phi_4057_ = _e2095;
                                phi_4058_ = _e2097;
                                phi_4059_ = _e2099;
                            } else {
                                phi_4615_ = _e650;
                                phi_4055_ = type_39();
                                phi_4056_ = bool();
                                phi_4057_ = type_46();
                                phi_4058_ = u32();
                                phi_4059_ = u32();
                            }
                            let _e2101 = phi_4615_;
                            let _e2103 = phi_4055_;
                            let _e2105 = phi_4056_;
                            let _e2107 = phi_4057_;
                            let _e2109 = phi_4058_;
                            let _e2111 = phi_4059_;
                            phi_4614_ = _e2101;
                            phi_1115_ = _e2103;
                            phi_1118_ = _e2105;
                            phi_1120_ = _e2107;
                            phi_1122_ = _e2109;
                            phi_1124_ = _e2111;
                            phi_4060_ = _e664;
                        } else {
                            phi_4614_ = _e650;
                            phi_1115_ = type_39();
                            phi_1118_ = bool();
                            phi_1120_ = type_46();
                            phi_1122_ = u32();
                            phi_1124_ = u32();
                            phi_4060_ = false;
                        }
                        let _e2113 = phi_4614_;
                        let _e2115 = phi_1115_;
                        let _e2117 = phi_1118_;
                        let _e2119 = phi_1120_;
                        let _e2121 = phi_1122_;
                        let _e2123 = phi_1124_;
                        let _e2125 = phi_4060_;
                        continue;
                        continuing {
                            phi_4422_ = _e2113;
                            phi_1114_ = _e2115;
                            phi_1117_ = _e2117;
                            phi_1119_ = _e2119;
                            phi_1121_ = _e2121;
                            phi_1123_ = _e2123;
                            phi_4613_ = _e2113;
                            break if !(_e2125);
                        }
                    }
                    let _e2128 = phi_4613_;
                    if _e2128 {
                        break;
                    }
                    let _e2130 = local_11;
                    if _e156 {
                    } else {
                        break;
                    }
                    global_5.member[_e154] = select(0u, 1u, _e2130.member_1);
                }
            }
            break;
        }
    }
    return;
}

@compute @workgroup_size(64, 1, 1) 
fn trace_any_q10_lattice(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
