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
    var phi_418_: i32;
    var phi_419_: i32;
    var phi_429_: bool;
    var phi_439_: u32;
    var phi_440_: u32;
    var phi_442_: bool;
    var phi_447_: u32;
    var phi_460_: i32;
    var phi_480_: i32;
    var phi_498_: f32;
    var phi_504_: f32;
    var phi_544_: f32;
    var phi_550_: f32;
    var phi_623_: f32;
    var phi_629_: f32;
    var phi_669_: f32;
    var phi_675_: f32;
    var phi_748_: f32;
    var phi_754_: f32;
    var phi_794_: f32;
    var phi_800_: f32;
    var phi_919_: i32;
    var phi_941_: u32;
    var phi_942_: u32;
    var phi_979_: i32;
    var phi_1001_: u32;
    var phi_1002_: u32;
    var phi_1010_: f32;
    var phi_1011_: f32;
    var phi_4494_: bool;
    var phi_1107_: type_35;
    var phi_1110_: u32;
    var phi_1112_: bool;
    var phi_1114_: u32;
    var phi_1116_: type_46;
    var phi_1127_: bool;
    var phi_1213_: bool;
    var phi_1214_: u32;
    var phi_1215_: type_46;
    var phi_1234_: type_35;
    var phi_1237_: type_8;
    var phi_1238_: type_8;
    var phi_1260_: type_8;
    var phi_1301_: u32;
    var phi_1307_: u32;
    var phi_1317_: u32;
    var phi_1333_: u32;
    var phi_1366_: u32;
    var phi_1372_: u32;
    var phi_1838_: u32;
    var phi_1856_: u32;
    var phi_1874_: u32;
    var phi_1897_: u32;
    var phi_1915_: u32;
    var phi_1933_: u32;
    var phi_1956_: u32;
    var phi_1974_: u32;
    var phi_1992_: u32;
    var phi_1546_: u32;
    var phi_1561_: u32;
    var phi_1571_: u32;
    var phi_1592_: u32;
    var phi_1613_: u32;
    var phi_1643_: u32;
    var phi_1658_: u32;
    var phi_1668_: u32;
    var phi_1689_: u32;
    var phi_1710_: u32;
    var phi_1740_: u32;
    var phi_1755_: u32;
    var phi_1765_: u32;
    var phi_1786_: u32;
    var phi_1807_: u32;
    var phi_1399_: u32;
    var phi_1448_: u32;
    var phi_1497_: u32;
    var phi_1998_: array<array<f32, 3>, 3>;
    var phi_4129_: bool;
    var phi_4144_: bool;
    var phi_4159_: bool;
    var phi_4174_: bool;
    var phi_4189_: bool;
    var phi_4204_: bool;
    var phi_2540_: f32;
    var phi_2541_: f32;
    var phi_2542_: f32;
    var phi_2543_: f32;
    var phi_2544_: vec3<f32>;
    var phi_2545_: vec3<f32>;
    var phi_2546_: vec3<f32>;
    var phi_2547_: vec3<f32>;
    var phi_4219_: bool;
    var phi_4234_: bool;
    var phi_4249_: bool;
    var phi_4264_: bool;
    var phi_4279_: bool;
    var phi_4294_: bool;
    var phi_2755_: f32;
    var phi_2775_: type_31;
    var phi_2776_: type_31;
    var phi_2779_: type_31;
    var phi_2780_: type_31;
    var phi_2781_: bool;
    var phi_2785_: type_31;
    var phi_2794_: type_20;
    var phi_2805_: type_35;
    var phi_2806_: type_35;
    var phi_1235_: type_35;
    var phi_4488_: bool;
    var phi_4788_: bool;
    var phi_2807_: type_35;
    var phi_3309_: u32;
    var phi_3315_: u32;
    var phi_3569_: u32;
    var phi_3570_: u32;
    var phi_3580_: u32;
    var phi_3582_: u32;
    var phi_3583_: bool;
    var phi_3603_: u32;
    var phi_3604_: u32;
    var phi_3608_: type_47;
    var phi_3970_: type_46;
    var phi_4046_: type_46;
    var phi_4047_: u32;
    var phi_4048_: type_46;
    var phi_4050_: u32;
    var phi_4051_: type_46;
    var phi_4052_: bool;
    var phi_4061_: type_46;
    var phi_4066_: bool;
    var phi_4068_: type_46;
    var phi_4072_: bool;
    var phi_4073_: u32;
    var phi_4074_: type_46;
    var phi_4084_: u32;
    var phi_4085_: type_46;
    var phi_4700_: bool;
    var phi_4086_: type_35;
    var phi_4087_: u32;
    var phi_4088_: bool;
    var phi_4089_: u32;
    var phi_4090_: type_46;
    var phi_4699_: bool;
    var phi_4091_: type_35;
    var phi_4092_: u32;
    var phi_4093_: bool;
    var phi_4094_: u32;
    var phi_4095_: type_46;
    var phi_4698_: bool;
    var phi_1108_: type_35;
    var phi_1111_: u32;
    var phi_1113_: bool;
    var phi_1115_: u32;
    var phi_1117_: type_46;
    var phi_4096_: bool;
    var phi_4697_: bool;
    var local_10: type_35;
    var local_11: type_35;

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
                            phi_418_ = (bitcast<i32>((_e230 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_418_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e230)), 32u, (_e230 == 0u))));
                        }
                        let _e244 = phi_418_;
                        phi_419_ = _e244;
                    } else {
                        phi_419_ = 0i;
                    }
                    let _e246 = phi_419_;
                    let _e247 = (_e163 == _e202);
                    if _e247 {
                        phi_429_ = true;
                    } else {
                        phi_429_ = (_e170 == _e202);
                    }
                    let _e250 = phi_429_;
                    let _e251 = select(1u, 0u, _e247);
                    if _e250 {
                        let _e252 = (_e251 + 1u);
                        phi_439_ = _e252;
                        phi_440_ = _e252;
                        phi_442_ = select(true, false, (_e252 == 2u));
                    } else {
                        phi_439_ = u32();
                        phi_440_ = 0u;
                        phi_442_ = true;
                    }
                    let _e256 = phi_439_;
                    let _e258 = phi_440_;
                    let _e260 = phi_442_;
                    if _e260 {
                        phi_447_ = (_e258 + 1u);
                    } else {
                        phi_447_ = 0u;
                    }
                    let _e264 = phi_447_;
                    let _e265 = select(_e256, _e258, _e260);
                    let _e266 = select(_e251, select(2u, _e251, _e250), _e260);
                    if (_e133 < -126i) {
                        phi_460_ = -126i;
                    } else {
                        phi_460_ = select(_e133, 127i, (_e133 > 127i));
                    }
                    let _e271 = phi_460_;
                    let _e276 = bitcast<f32>((bitcast<u32>((_e271 + 127i)) << bitcast<u32>(23i)));
                    let _e282 = bitcast<f32>((bitcast<u32>(((_e133 - _e271) + 127i)) << bitcast<u32>(23i)));
                    let _e283 = -(_e246);
                    if (_e283 < -126i) {
                        phi_480_ = -126i;
                    } else {
                        phi_480_ = select(_e283, 127i, (_e283 > 127i));
                    }
                    let _e288 = phi_480_;
                    let _e293 = bitcast<f32>((bitcast<u32>((_e288 + 127i)) << bitcast<u32>(23i)));
                    let _e299 = bitcast<f32>((bitcast<u32>(((_e283 - _e288) + 127i)) << bitcast<u32>(23i)));
                    let _e303 = global_3.member[_e151].member;
                    let _e304 = (_e265 == 0u);
                    if _e304 {
                        phi_498_ = _e303[0];
                    } else {
                        phi_498_ = _e303[1];
                    }
                    let _e308 = phi_498_;
                    let _e309 = (_e265 == 2u);
                    if _e309 {
                        phi_504_ = _e303[2];
                    } else {
                        phi_504_ = _e308;
                    }
                    let _e312 = phi_504_;
                    let _e313 = bitcast<u32>(_e312);
                    let _e315 = ((_e313 & 2139095040u) != 0u);
                    let _e329 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e313 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e313 & 2147483648u))), _e312, _e315) * _e276) * select(0.00000011920929f, 1f, _e315)) * _e282);
                    let _e330 = global_3.member[_e151].member_2;
                    if _e304 {
                        phi_544_ = _e330[0];
                    } else {
                        phi_544_ = _e330[1];
                    }
                    let _e334 = phi_544_;
                    if _e309 {
                        phi_550_ = _e330[2];
                    } else {
                        phi_550_ = _e334;
                    }
                    let _e337 = phi_550_;
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
                        phi_623_ = _e303[0];
                    } else {
                        phi_623_ = _e303[1];
                    }
                    let _e375 = phi_623_;
                    let _e376 = (_e264 == 2u);
                    if _e376 {
                        phi_629_ = _e303[2];
                    } else {
                        phi_629_ = _e375;
                    }
                    let _e379 = phi_629_;
                    let _e380 = bitcast<u32>(_e379);
                    let _e382 = ((_e380 & 2139095040u) != 0u);
                    let _e396 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e380 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e380 & 2147483648u))), _e379, _e382) * _e276) * select(0.00000011920929f, 1f, _e382)) * _e282);
                    if _e371 {
                        phi_669_ = _e330[0];
                    } else {
                        phi_669_ = _e330[1];
                    }
                    let _e400 = phi_669_;
                    if _e376 {
                        phi_675_ = _e330[2];
                    } else {
                        phi_675_ = _e400;
                    }
                    let _e403 = phi_675_;
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
                        phi_748_ = _e303[0];
                    } else {
                        phi_748_ = _e303[1];
                    }
                    let _e441 = phi_748_;
                    let _e442 = (_e266 == 2u);
                    if _e442 {
                        phi_754_ = _e303[2];
                    } else {
                        phi_754_ = _e441;
                    }
                    let _e445 = phi_754_;
                    let _e446 = bitcast<u32>(_e445);
                    let _e448 = ((_e446 & 2139095040u) != 0u);
                    let _e462 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e446 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e446 & 2147483648u))), _e445, _e448) * _e276) * select(0.00000011920929f, 1f, _e448)) * _e282);
                    if _e437 {
                        phi_794_ = _e330[0];
                    } else {
                        phi_794_ = _e330[1];
                    }
                    let _e466 = phi_794_;
                    if _e442 {
                        phi_800_ = _e330[2];
                    } else {
                        phi_800_ = _e466;
                    }
                    let _e469 = phi_800_;
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
                            phi_919_ = 255i;
                        } else {
                            phi_919_ = (((_e520 + select(0i, 1i, (_e520 == 0i))) - _e527) + _e507);
                        }
                        let _e535 = phi_919_;
                        let _e545 = (_e535 <= 0i);
                        if _e545 {
                            phi_942_ = u32();
                        } else {
                            if _e524 {
                                phi_941_ = u32();
                            } else {
                                phi_941_ = select(((bitcast<u32>(_e535) << bitcast<u32>(23i)) | ((_e517 << bitcast<u32>(((_e527 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e535 >= 255i));
                            }
                            let _e549 = phi_941_;
                            phi_942_ = _e549;
                        }
                        let _e551 = phi_942_;
                        let _e563 = ((_e223 & 8388607u) | (select(0u, 1u, ((_e223 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e566 = bitcast<i32>((_e223 >> bitcast<u32>(23i)));
                        let _e570 = (_e563 == 0u);
                        let _e573 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e563)), 32u, _e570)) - 8i);
                        if (_e566 == 255i) {
                            phi_979_ = 255i;
                        } else {
                            phi_979_ = (((_e566 + select(0i, 1i, (_e566 == 0i))) - _e573) + _e507);
                        }
                        let _e581 = phi_979_;
                        let _e591 = (_e581 <= 0i);
                        if _e591 {
                            phi_1002_ = u32();
                        } else {
                            if _e570 {
                                phi_1001_ = u32();
                            } else {
                                phi_1001_ = select(((bitcast<u32>(_e581) << bitcast<u32>(23i)) | ((_e563 << bitcast<u32>(((_e573 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e581 >= 255i));
                            }
                            let _e595 = phi_1001_;
                            phi_1002_ = _e595;
                        }
                        let _e597 = phi_1002_;
                        phi_1010_ = bitcast<f32>(((_e222 & 2147483648u) | select(_e597, 0u, select(_e570, true, _e591))));
                        phi_1011_ = bitcast<f32>(((_e213 & 2147483648u) | select(_e551, 0u, select(_e524, true, _e545))));
                    } else {
                        phi_1010_ = 0f;
                        phi_1011_ = 1f;
                    }
                    let _e603 = phi_1010_;
                    let _e605 = phi_1011_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e609 = (_e265 % 3u);
                    let _e610 = (_e609 < 3u);
                    if _e610 {
                    } else {
                        break;
                    }
                    let _e612 = local_1[_e609];
                    let _e615 = (_e264 % 3u);
                    let _e616 = (_e615 < 3u);
                    if _e616 {
                    } else {
                        break;
                    }
                    let _e618 = local_1[_e615];
                    let _e621 = (_e266 % 3u);
                    let _e622 = (_e621 < 3u);
                    if _e622 {
                    } else {
                        break;
                    }
                    let _e624 = local_1[_e621];
                    if _e610 {
                    } else {
                        break;
                    }
                    let _e629 = local[_e609];
                    if _e616 {
                    } else {
                        break;
                    }
                    let _e633 = local[_e615];
                    if _e622 {
                    } else {
                        break;
                    }
                    let _e637 = local[_e621];
                    phi_4494_ = false;
                    phi_1107_ = type_35(_e603, false);
                    phi_1110_ = ((3u * _e94) + 1u);
                    phi_1112_ = (_e605 <= _e603);
                    phi_1114_ = 0u;
                    phi_1116_ = type_46(type_24(vec4<f32>((f32(_e612) * _e145), (f32(_e618) * _e145), (f32(_e624) * _e145), 0f), vec4<f32>((f32(_e629) * _e145), (f32(_e633) * _e145), (f32(_e637) * _e145), 0f)), select(0u, 2147483648u, (_e94 == 0u)));
                    loop {
                        let _e647 = phi_4494_;
                        let _e649 = phi_1107_;
                        let _e651 = phi_1110_;
                        let _e653 = phi_1112_;
                        let _e655 = phi_1114_;
                        let _e657 = phi_1116_;
                        local_10 = _e649;
                        if _e653 {
                            phi_1127_ = true;
                        } else {
                            phi_1127_ = (_e655 > 0u);
                        }
                        let _e660 = phi_1127_;
                        if _e660 {
                            let _e661 = (_e651 > 0u);
                            if _e661 {
                                if _e653 {
                                    phi_1213_ = _e653;
                                    phi_1214_ = _e655;
                                    phi_1215_ = _e657;
                                } else {
                                    let _e662 = (_e655 - 1u);
                                    let _e663 = (_e662 % 128u);
                                    let _e664 = (_e663 < 128u);
                                    if _e664 {
                                    } else {
                                        phi_4697_ = true;
                                        break;
                                    }
                                    let _e666 = local_7[_e663];
                                    if _e664 {
                                    } else {
                                        phi_4697_ = true;
                                        break;
                                    }
                                    let _e668 = local_6[_e663];
                                    if _e664 {
                                    } else {
                                        phi_4697_ = true;
                                        break;
                                    }
                                    let _e670 = local_5[_e663];
                                    if _e664 {
                                    } else {
                                        phi_4697_ = true;
                                        break;
                                    }
                                    let _e672 = local_4[_e663];
                                    if _e664 {
                                    } else {
                                        phi_4697_ = true;
                                        break;
                                    }
                                    let _e674 = local_3[_e663];
                                    if _e664 {
                                    } else {
                                        phi_4697_ = true;
                                        break;
                                    }
                                    let _e676 = local_2[_e663];
                                    if _e664 {
                                    } else {
                                        phi_4697_ = true;
                                        break;
                                    }
                                    let _e681 = local_8[_e663];
                                    if _e664 {
                                    } else {
                                        phi_4697_ = true;
                                        break;
                                    }
                                    let _e684 = local_9[_e663];
                                    phi_1213_ = (_e684 <= _e649.member);
                                    phi_1214_ = _e662;
                                    phi_1215_ = type_46(type_24(vec4<f32>(_e666, _e668, _e670, 0f), vec4<f32>(_e672, _e674, _e676, 0f)), _e681);
                                }
                                let _e688 = phi_1213_;
                                let _e690 = phi_1214_;
                                let _e692 = phi_1215_;
                                if _e688 {
                                    let _e696 = ((_e692.member_1 & 2147483648u) != 0u);
                                    let _e697 = (_e692.member_1 & 268435455u);
                                    if _e696 {
                                        phi_1234_ = _e649;
                                        phi_1237_ = type_8(0u, ((_e692.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e704 = phi_1234_;
                                            let _e706 = phi_1237_;
                                            local_11 = _e704;
                                            if (_e706.member < _e706.member_1) {
                                                phi_1238_ = type_8((_e706.member + 1u), _e706.member_1);
                                                phi_1260_ = type_8(1u, _e706.member);
                                            } else {
                                                phi_1238_ = _e706;
                                                phi_1260_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e719 = phi_1238_;
                                            let _e721 = phi_1260_;
                                            let _e725 = (bitcast<i32>(_e721.member) != 0i);
                                            if _e725 {
                                                let _e730 = (_e692.member.member_1.x - _e692.member.member.x);
                                                let _e733 = (_e692.member.member_1.y - _e692.member.member.y);
                                                let _e736 = (_e692.member.member_1.z - _e692.member.member.z);
                                                let _e738 = select(_e733, _e730, (_e730 > _e733));
                                                let _e740 = select(_e736, _e738, (_e738 > _e736));
                                                let _e742 = (_e740 < (1024f * _e145));
                                                if _e742 {
                                                    phi_1301_ = 0u;
                                                } else {
                                                    phi_1301_ = select(2u, 1u, (_e740 < (2097152f * _e145)));
                                                }
                                                let _e747 = phi_1301_;
                                                switch bitcast<i32>(_e747) {
                                                    case 0: {
                                                        phi_1307_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1307_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1307_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1307_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e750 = phi_1307_;
                                                switch bitcast<i32>(_e747) {
                                                    case 0: {
                                                        phi_1317_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1317_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1317_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1317_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e757 = phi_1317_;
                                                let _e759 = ((_e697 + (_e721.member_1 * ((3u * _e750) + 1u))) + (3u * _e757));
                                                let _e760 = (_e759 < _e97);
                                                if _e760 {
                                                    if _e760 {
                                                    } else {
                                                        phi_4488_ = true;
                                                        break;
                                                    }
                                                    let _e762 = global_6.member[_e759];
                                                    phi_1333_ = _e762;
                                                } else {
                                                    phi_1333_ = 4294967295u;
                                                }
                                                let _e764 = phi_1333_;
                                                if _e742 {
                                                    phi_1366_ = 0u;
                                                } else {
                                                    phi_1366_ = select(2u, 1u, (_e740 < (2097152f * _e145)));
                                                }
                                                let _e769 = phi_1366_;
                                                switch bitcast<i32>(_e769) {
                                                    case 0: {
                                                        phi_1372_ = 1u;
                                                        break;
                                                    }
                                                    case 1: {
                                                        phi_1372_ = 2u;
                                                        break;
                                                    }
                                                    case 2: {
                                                        phi_1372_ = 3u;
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1372_ = u32();
                                                        break;
                                                    }
                                                }
                                                let _e772 = phi_1372_;
                                                let _e776 = (_e697 + (_e721.member_1 * ((3u * _e772) + 1u)));
                                                switch bitcast<i32>(_e769) {
                                                    case 0: {
                                                        let _e1051 = (_e776 < _e97);
                                                        if _e1051 {
                                                            if _e1051 {
                                                            } else {
                                                                phi_4488_ = true;
                                                                break;
                                                            }
                                                            let _e1053 = global_6.member[_e776];
                                                            phi_1399_ = _e1053;
                                                        } else {
                                                            phi_1399_ = 0u;
                                                        }
                                                        let _e1055 = phi_1399_;
                                                        let _e1057 = ((10u * _e265) & 31u);
                                                        let _e1067 = ((10u * _e264) & 31u);
                                                        let _e1077 = ((10u * _e266) & 31u);
                                                        let _e1087 = (_e776 + 1u);
                                                        let _e1088 = (_e1087 < _e97);
                                                        if _e1088 {
                                                            if _e1088 {
                                                            } else {
                                                                phi_4488_ = true;
                                                                break;
                                                            }
                                                            let _e1090 = global_6.member[_e1087];
                                                            phi_1448_ = _e1090;
                                                        } else {
                                                            phi_1448_ = 0u;
                                                        }
                                                        let _e1092 = phi_1448_;
                                                        let _e1118 = (_e776 + 2u);
                                                        let _e1119 = (_e1118 < _e97);
                                                        if _e1119 {
                                                            if _e1119 {
                                                            } else {
                                                                phi_4488_ = true;
                                                                break;
                                                            }
                                                            let _e1121 = global_6.member[_e1118];
                                                            phi_1497_ = _e1121;
                                                        } else {
                                                            phi_1497_ = 0u;
                                                        }
                                                        let _e1123 = phi_1497_;
                                                        phi_1998_ = array<array<f32, 3>, 3>(array<f32, 3>((_e692.member.member.x + ((bitcast<f32>((1258291200u | ((_e1055 >> bitcast<u32>(_e1057)) & 1023u))) - 8388608f) * _e145)), (_e692.member.member.y + ((bitcast<f32>((1258291200u | ((_e1055 >> bitcast<u32>(_e1067)) & 1023u))) - 8388608f) * _e145)), (_e692.member.member.z + ((bitcast<f32>((1258291200u | ((_e1055 >> bitcast<u32>(_e1077)) & 1023u))) - 8388608f) * _e145))), array<f32, 3>((_e692.member.member.x + ((bitcast<f32>((1258291200u | ((_e1092 >> bitcast<u32>(_e1057)) & 1023u))) - 8388608f) * _e145)), (_e692.member.member.y + ((bitcast<f32>((1258291200u | ((_e1092 >> bitcast<u32>(_e1067)) & 1023u))) - 8388608f) * _e145)), (_e692.member.member.z + ((bitcast<f32>((1258291200u | ((_e1092 >> bitcast<u32>(_e1077)) & 1023u))) - 8388608f) * _e145))), array<f32, 3>((_e692.member.member.x + ((bitcast<f32>((1258291200u | ((_e1123 >> bitcast<u32>(_e1057)) & 1023u))) - 8388608f) * _e145)), (_e692.member.member.y + ((bitcast<f32>((1258291200u | ((_e1123 >> bitcast<u32>(_e1067)) & 1023u))) - 8388608f) * _e145)), (_e692.member.member.z + ((bitcast<f32>((1258291200u | ((_e1123 >> bitcast<u32>(_e1077)) & 1023u))) - 8388608f) * _e145))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e865 = (_e776 < _e97);
                                                        if _e865 {
                                                            if _e865 {
                                                            } else {
                                                                phi_4488_ = true;
                                                                break;
                                                            }
                                                            let _e867 = global_6.member[_e776];
                                                            phi_1546_ = _e867;
                                                        } else {
                                                            phi_1546_ = 0u;
                                                        }
                                                        let _e869 = phi_1546_;
                                                        let _e870 = (_e776 + 1u);
                                                        let _e871 = (_e870 < _e97);
                                                        if _e871 {
                                                            if _e871 {
                                                            } else {
                                                                phi_4488_ = true;
                                                                break;
                                                            }
                                                            let _e873 = global_6.member[_e870];
                                                            phi_1561_ = _e873;
                                                        } else {
                                                            phi_1561_ = 0u;
                                                        }
                                                        let _e875 = phi_1561_;
                                                        let _e876 = (_e265 == 1u);
                                                        if _e876 {
                                                            phi_1571_ = ((_e869 >> bitcast<u32>(21i)) | (_e875 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1571_ = (_e875 >> bitcast<u32>(10i));
                                                        }
                                                        let _e885 = phi_1571_;
                                                        let _e893 = (_e264 == 1u);
                                                        if _e893 {
                                                            phi_1592_ = ((_e869 >> bitcast<u32>(21i)) | (_e875 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1592_ = (_e875 >> bitcast<u32>(10i));
                                                        }
                                                        let _e902 = phi_1592_;
                                                        let _e910 = (_e266 == 1u);
                                                        if _e910 {
                                                            phi_1613_ = ((_e869 >> bitcast<u32>(21i)) | (_e875 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1613_ = (_e875 >> bitcast<u32>(10i));
                                                        }
                                                        let _e919 = phi_1613_;
                                                        let _e928 = (_e776 + 2u);
                                                        let _e929 = (_e928 < _e97);
                                                        if _e929 {
                                                            if _e929 {
                                                            } else {
                                                                phi_4488_ = true;
                                                                break;
                                                            }
                                                            let _e931 = global_6.member[_e928];
                                                            phi_1643_ = _e931;
                                                        } else {
                                                            phi_1643_ = 0u;
                                                        }
                                                        let _e933 = phi_1643_;
                                                        let _e934 = (_e776 + 3u);
                                                        let _e935 = (_e934 < _e97);
                                                        if _e935 {
                                                            if _e935 {
                                                            } else {
                                                                phi_4488_ = true;
                                                                break;
                                                            }
                                                            let _e937 = global_6.member[_e934];
                                                            phi_1658_ = _e937;
                                                        } else {
                                                            phi_1658_ = 0u;
                                                        }
                                                        let _e939 = phi_1658_;
                                                        if _e876 {
                                                            phi_1668_ = ((_e933 >> bitcast<u32>(21i)) | (_e939 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1668_ = (_e939 >> bitcast<u32>(10i));
                                                        }
                                                        let _e948 = phi_1668_;
                                                        if _e893 {
                                                            phi_1689_ = ((_e933 >> bitcast<u32>(21i)) | (_e939 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1689_ = (_e939 >> bitcast<u32>(10i));
                                                        }
                                                        let _e964 = phi_1689_;
                                                        if _e910 {
                                                            phi_1710_ = ((_e933 >> bitcast<u32>(21i)) | (_e939 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1710_ = (_e939 >> bitcast<u32>(10i));
                                                        }
                                                        let _e980 = phi_1710_;
                                                        let _e989 = (_e776 + 4u);
                                                        let _e990 = (_e989 < _e97);
                                                        if _e990 {
                                                            if _e990 {
                                                            } else {
                                                                phi_4488_ = true;
                                                                break;
                                                            }
                                                            let _e992 = global_6.member[_e989];
                                                            phi_1740_ = _e992;
                                                        } else {
                                                            phi_1740_ = 0u;
                                                        }
                                                        let _e994 = phi_1740_;
                                                        let _e995 = (_e776 + 5u);
                                                        let _e996 = (_e995 < _e97);
                                                        if _e996 {
                                                            if _e996 {
                                                            } else {
                                                                phi_4488_ = true;
                                                                break;
                                                            }
                                                            let _e998 = global_6.member[_e995];
                                                            phi_1755_ = _e998;
                                                        } else {
                                                            phi_1755_ = 0u;
                                                        }
                                                        let _e1000 = phi_1755_;
                                                        if _e876 {
                                                            phi_1765_ = ((_e994 >> bitcast<u32>(21i)) | (_e1000 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1765_ = (_e1000 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1009 = phi_1765_;
                                                        if _e893 {
                                                            phi_1786_ = ((_e994 >> bitcast<u32>(21i)) | (_e1000 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1786_ = (_e1000 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1025 = phi_1786_;
                                                        if _e910 {
                                                            phi_1807_ = ((_e994 >> bitcast<u32>(21i)) | (_e1000 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1807_ = (_e1000 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1041 = phi_1807_;
                                                        phi_1998_ = array<array<f32, 3>, 3>(array<f32, 3>((_e692.member.member.x + ((bitcast<f32>((1258291200u | (select(_e885, _e869, _e304) & 2097151u))) - 8388608f) * _e145)), (_e692.member.member.y + ((bitcast<f32>((1258291200u | (select(_e902, _e869, _e371) & 2097151u))) - 8388608f) * _e145)), (_e692.member.member.z + ((bitcast<f32>((1258291200u | (select(_e919, _e869, _e437) & 2097151u))) - 8388608f) * _e145))), array<f32, 3>((_e692.member.member.x + ((bitcast<f32>((1258291200u | (select(_e948, _e933, _e304) & 2097151u))) - 8388608f) * _e145)), (_e692.member.member.y + ((bitcast<f32>((1258291200u | (select(_e964, _e933, _e371) & 2097151u))) - 8388608f) * _e145)), (_e692.member.member.z + ((bitcast<f32>((1258291200u | (select(_e980, _e933, _e437) & 2097151u))) - 8388608f) * _e145))), array<f32, 3>((_e692.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1009, _e994, _e304) & 2097151u))) - 8388608f) * _e145)), (_e692.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1025, _e994, _e371) & 2097151u))) - 8388608f) * _e145)), (_e692.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1041, _e994, _e437) & 2097151u))) - 8388608f) * _e145))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e778 = (_e776 + _e265);
                                                        let _e779 = (_e778 < _e97);
                                                        if _e779 {
                                                            if _e779 {
                                                            } else {
                                                                phi_4488_ = true;
                                                                break;
                                                            }
                                                            let _e781 = global_6.member[_e778];
                                                            phi_1838_ = _e781;
                                                        } else {
                                                            phi_1838_ = 0u;
                                                        }
                                                        let _e783 = phi_1838_;
                                                        let _e787 = (_e776 + _e264);
                                                        let _e788 = (_e787 < _e97);
                                                        if _e788 {
                                                            if _e788 {
                                                            } else {
                                                                phi_4488_ = true;
                                                                break;
                                                            }
                                                            let _e790 = global_6.member[_e787];
                                                            phi_1856_ = _e790;
                                                        } else {
                                                            phi_1856_ = 0u;
                                                        }
                                                        let _e792 = phi_1856_;
                                                        let _e796 = (_e776 + _e266);
                                                        let _e797 = (_e796 < _e97);
                                                        if _e797 {
                                                            if _e797 {
                                                            } else {
                                                                phi_4488_ = true;
                                                                break;
                                                            }
                                                            let _e799 = global_6.member[_e796];
                                                            phi_1874_ = _e799;
                                                        } else {
                                                            phi_1874_ = 0u;
                                                        }
                                                        let _e801 = phi_1874_;
                                                        let _e806 = (_e776 + 3u);
                                                        let _e807 = (_e806 + _e265);
                                                        let _e808 = (_e807 < _e97);
                                                        if _e808 {
                                                            if _e808 {
                                                            } else {
                                                                phi_4488_ = true;
                                                                break;
                                                            }
                                                            let _e810 = global_6.member[_e807];
                                                            phi_1897_ = _e810;
                                                        } else {
                                                            phi_1897_ = 0u;
                                                        }
                                                        let _e812 = phi_1897_;
                                                        let _e816 = (_e806 + _e264);
                                                        let _e817 = (_e816 < _e97);
                                                        if _e817 {
                                                            if _e817 {
                                                            } else {
                                                                phi_4488_ = true;
                                                                break;
                                                            }
                                                            let _e819 = global_6.member[_e816];
                                                            phi_1915_ = _e819;
                                                        } else {
                                                            phi_1915_ = 0u;
                                                        }
                                                        let _e821 = phi_1915_;
                                                        let _e825 = (_e806 + _e266);
                                                        let _e826 = (_e825 < _e97);
                                                        if _e826 {
                                                            if _e826 {
                                                            } else {
                                                                phi_4488_ = true;
                                                                break;
                                                            }
                                                            let _e828 = global_6.member[_e825];
                                                            phi_1933_ = _e828;
                                                        } else {
                                                            phi_1933_ = 0u;
                                                        }
                                                        let _e830 = phi_1933_;
                                                        let _e835 = (_e776 + 6u);
                                                        let _e836 = (_e835 + _e265);
                                                        let _e837 = (_e836 < _e97);
                                                        if _e837 {
                                                            if _e837 {
                                                            } else {
                                                                phi_4488_ = true;
                                                                break;
                                                            }
                                                            let _e839 = global_6.member[_e836];
                                                            phi_1956_ = _e839;
                                                        } else {
                                                            phi_1956_ = 0u;
                                                        }
                                                        let _e841 = phi_1956_;
                                                        let _e845 = (_e835 + _e264);
                                                        let _e846 = (_e845 < _e97);
                                                        if _e846 {
                                                            if _e846 {
                                                            } else {
                                                                phi_4488_ = true;
                                                                break;
                                                            }
                                                            let _e848 = global_6.member[_e845];
                                                            phi_1974_ = _e848;
                                                        } else {
                                                            phi_1974_ = 0u;
                                                        }
                                                        let _e850 = phi_1974_;
                                                        let _e854 = (_e835 + _e266);
                                                        let _e855 = (_e854 < _e97);
                                                        if _e855 {
                                                            if _e855 {
                                                            } else {
                                                                phi_4488_ = true;
                                                                break;
                                                            }
                                                            let _e857 = global_6.member[_e854];
                                                            phi_1992_ = _e857;
                                                        } else {
                                                            phi_1992_ = 0u;
                                                        }
                                                        let _e859 = phi_1992_;
                                                        phi_1998_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e783)) * _e145), (f32(bitcast<i32>(_e792)) * _e145), (f32(bitcast<i32>(_e801)) * _e145)), array<f32, 3>((f32(bitcast<i32>(_e812)) * _e145), (f32(bitcast<i32>(_e821)) * _e145), (f32(bitcast<i32>(_e830)) * _e145)), array<f32, 3>((f32(bitcast<i32>(_e841)) * _e145), (f32(bitcast<i32>(_e850)) * _e145), (f32(bitcast<i32>(_e859)) * _e145)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1998_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1151 = phi_1998_;
                                                let _e1167 = (_e1151[0][2] - _e462);
                                                let _e1170 = (((_e1151[0][0] - _e329) * _e498) - (_e1167 * _e366));
                                                let _e1173 = (((_e1151[0][1] - _e396) * _e498) - (_e1167 * _e432));
                                                let _e1176 = (_e1151[1][2] - _e462);
                                                let _e1179 = (((_e1151[1][0] - _e329) * _e498) - (_e1176 * _e366));
                                                let _e1182 = (((_e1151[1][1] - _e396) * _e498) - (_e1176 * _e432));
                                                let _e1185 = (_e1151[2][2] - _e462);
                                                let _e1188 = (((_e1151[2][0] - _e329) * _e498) - (_e1185 * _e366));
                                                let _e1191 = (((_e1151[2][1] - _e396) * _e498) - (_e1185 * _e432));
                                                let _e1192 = (_e1188 * _e1182);
                                                let _e1193 = (_e1191 * _e1179);
                                                let _e1194 = (_e1170 * _e1191);
                                                let _e1195 = (_e1173 * _e1188);
                                                let _e1196 = (_e1179 * _e1173);
                                                let _e1197 = (_e1182 * _e1170);
                                                let _e1202 = (((_e1192 >= _e1193) && (_e1194 >= _e1195)) && (_e1196 >= _e1197));
                                                let _e1208 = (_e1202 || (((_e1192 <= _e1193) && (_e1194 <= _e1195)) && (_e1196 <= _e1197)));
                                                if _e1208 {
                                                    let _e1210 = select(-1f, 1f, _e1202);
                                                    let _e1212 = ((_e1192 - _e1193) * _e1210);
                                                    let _e1214 = select(0f, _e1212, (_e1212 > 0f));
                                                    let _e1216 = ((_e1194 - _e1195) * _e1210);
                                                    let _e1218 = select(0f, _e1216, (_e1216 > 0f));
                                                    let _e1220 = ((_e1196 - _e1197) * _e1210);
                                                    let _e1222 = select(0f, _e1220, (_e1220 > 0f));
                                                    let _e1224 = ((_e1214 + _e1218) + _e1222);
                                                    let _e1226 = select(_e1151[1][0], _e1151[0][0], (_e1151[0][0] < _e1151[1][0]));
                                                    let _e1230 = select(_e1151[1][0], _e1151[0][0], (_e1151[0][0] > _e1151[1][0]));
                                                    let _e1234 = select(_e1151[1][1], _e1151[0][1], (_e1151[0][1] < _e1151[1][1]));
                                                    let _e1238 = select(_e1151[1][1], _e1151[0][1], (_e1151[0][1] > _e1151[1][1]));
                                                    let _e1242 = select(_e1151[1][2], _e1151[0][2], (_e1151[0][2] < _e1151[1][2]));
                                                    let _e1246 = select(_e1151[1][2], _e1151[0][2], (_e1151[0][2] > _e1151[1][2]));
                                                    let _e1251 = ((select(_e1151[2][0], _e1226, (_e1226 < _e1151[2][0])) - _e367) * _e370);
                                                    let _e1252 = ((select(_e1151[2][0], _e1230, (_e1230 > _e1151[2][0])) - _e368) * _e370);
                                                    let _e1255 = ((select(_e1151[2][1], _e1234, (_e1234 < _e1151[2][1])) - _e433) * _e436);
                                                    let _e1256 = ((select(_e1151[2][1], _e1238, (_e1238 > _e1151[2][1])) - _e434) * _e436);
                                                    let _e1259 = ((select(_e1151[2][2], _e1242, (_e1242 < _e1151[2][2])) - _e499) * _e502);
                                                    let _e1260 = ((select(_e1151[2][2], _e1246, (_e1246 > _e1151[2][2])) - _e500) * _e502);
                                                    let _e1262 = select(_e1260, _e1259, (_e1259 < _e1260));
                                                    let _e1264 = select(_e1260, _e1259, (_e1259 > _e1260));
                                                    let _e1266 = select(_e1252, _e1251, (_e1251 < _e1252));
                                                    let _e1268 = select(_e1256, _e1255, (_e1255 < _e1256));
                                                    let _e1270 = select(_e1268, _e1266, (_e1266 > _e1268));
                                                    let _e1272 = select(_e1262, _e1270, (_e1270 > _e1262));
                                                    let _e1274 = select(_e1252, _e1251, (_e1251 > _e1252));
                                                    let _e1276 = select(_e1256, _e1255, (_e1255 > _e1256));
                                                    let _e1278 = select(_e1276, _e1274, (_e1274 < _e1276));
                                                    let _e1280 = select(_e1264, _e1278, (_e1278 < _e1264));
                                                    let _e1281 = -(_e1262);
                                                    let _e1287 = select(_e605, _e1272, (_e1272 > _e605));
                                                    let _e1291 = select(_e1179, _e1170, (_e1170 < _e1179));
                                                    let _e1296 = select(_e1179, _e1170, (_e1170 > _e1179));
                                                    let _e1303 = select(_e1182, _e1173, (_e1173 < _e1182));
                                                    let _e1308 = select(_e1182, _e1173, (_e1173 > _e1182));
                                                    let _e1317 = (((((_e1208 && (_e1224 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1188, _e1291, (_e1291 < _e1188)) <= 0f) && (select(_e1188, _e1296, (_e1296 > _e1188)) >= 0f))) && ((select(_e1191, _e1303, (_e1303 < _e1191)) <= 0f) && (select(_e1191, _e1308, (_e1308 > _e1191)) >= 0f))) && (_e1287 <= (_e1280 + (select(_e1281, _e1264, (_e1264 > _e1281)) * 0.0000019073523f)))) && (_e1287 <= _e704.member));
                                                    if _e1317 {
                                                        let _e1322 = (_e1151[1][0] - _e1151[0][0]);
                                                        let _e1323 = (_e1151[1][1] - _e1151[0][1]);
                                                        let _e1324 = (_e1151[1][2] - _e1151[0][2]);
                                                        let _e1325 = vec3<f32>(_e1322, _e1323, _e1324);
                                                        let _e1326 = (_e1151[2][0] - _e1151[1][0]);
                                                        let _e1327 = (_e1151[2][1] - _e1151[1][1]);
                                                        let _e1328 = (_e1151[2][2] - _e1151[1][2]);
                                                        let _e1329 = vec3<f32>(_e1326, _e1327, _e1328);
                                                        let _e1330 = (_e1151[0][0] - _e1151[2][0]);
                                                        let _e1331 = (_e1151[0][1] - _e1151[2][1]);
                                                        let _e1332 = (_e1151[0][2] - _e1151[2][2]);
                                                        let _e1333 = vec3<f32>(_e1330, _e1331, _e1332);
                                                        let _e1334 = abs(_e1322);
                                                        let _e1335 = abs(_e1323);
                                                        if (_e1334 != _e1334) {
                                                            phi_4129_ = true;
                                                        } else {
                                                            phi_4129_ = (_e1335 >= _e1334);
                                                        }
                                                        let _e1339 = phi_4129_;
                                                        let _e1340 = select(_e1334, _e1335, _e1339);
                                                        let _e1341 = abs(_e1324);
                                                        if (_e1340 != _e1340) {
                                                            phi_4144_ = true;
                                                        } else {
                                                            phi_4144_ = (_e1341 >= _e1340);
                                                        }
                                                        let _e1345 = phi_4144_;
                                                        let _e1346 = select(_e1340, _e1341, _e1345);
                                                        let _e1347 = abs(_e1326);
                                                        let _e1348 = abs(_e1327);
                                                        if (_e1347 != _e1347) {
                                                            phi_4159_ = true;
                                                        } else {
                                                            phi_4159_ = (_e1348 >= _e1347);
                                                        }
                                                        let _e1352 = phi_4159_;
                                                        let _e1353 = select(_e1347, _e1348, _e1352);
                                                        let _e1354 = abs(_e1328);
                                                        if (_e1353 != _e1353) {
                                                            phi_4174_ = true;
                                                        } else {
                                                            phi_4174_ = (_e1354 >= _e1353);
                                                        }
                                                        let _e1358 = phi_4174_;
                                                        let _e1359 = select(_e1353, _e1354, _e1358);
                                                        let _e1360 = abs(_e1330);
                                                        let _e1361 = abs(_e1331);
                                                        if (_e1360 != _e1360) {
                                                            phi_4189_ = true;
                                                        } else {
                                                            phi_4189_ = (_e1361 >= _e1360);
                                                        }
                                                        let _e1365 = phi_4189_;
                                                        let _e1366 = select(_e1360, _e1361, _e1365);
                                                        let _e1367 = abs(_e1332);
                                                        if (_e1366 != _e1366) {
                                                            phi_4204_ = true;
                                                        } else {
                                                            phi_4204_ = (_e1367 >= _e1366);
                                                        }
                                                        let _e1371 = phi_4204_;
                                                        let _e1372 = select(_e1366, _e1367, _e1371);
                                                        let _e1374 = select(_e1359, _e1346, (_e1346 > _e1359));
                                                        let _e1376 = select(_e1372, _e1374, (_e1374 > _e1372));
                                                        if (_e1346 == _e1376) {
                                                            phi_2540_ = _e1182;
                                                            phi_2541_ = _e1179;
                                                            phi_2542_ = _e1173;
                                                            phi_2543_ = _e1170;
                                                            phi_2544_ = vec3<f32>(_e1151[0][0], _e1151[0][1], _e1151[0][2]);
                                                            phi_2545_ = _e1333;
                                                            phi_2546_ = _e1329;
                                                            phi_2547_ = _e1325;
                                                        } else {
                                                            let _e1378 = (_e1359 == _e1376);
                                                            let _e1383 = vec3(_e1378);
                                                            phi_2540_ = select(_e1173, _e1191, _e1378);
                                                            phi_2541_ = select(_e1170, _e1188, _e1378);
                                                            phi_2542_ = select(_e1191, _e1182, _e1378);
                                                            phi_2543_ = select(_e1188, _e1179, _e1378);
                                                            phi_2544_ = select(vec3<f32>(_e1151[2][0], _e1151[2][1], _e1151[2][2]), vec3<f32>(_e1151[1][0], _e1151[1][1], _e1151[1][2]), _e1383);
                                                            phi_2545_ = select(_e1329, _e1325, _e1383);
                                                            phi_2546_ = select(_e1325, _e1333, _e1383);
                                                            phi_2547_ = select(_e1333, _e1329, _e1383);
                                                        }
                                                        let _e1389 = phi_2540_;
                                                        let _e1391 = phi_2541_;
                                                        let _e1393 = phi_2542_;
                                                        let _e1395 = phi_2543_;
                                                        let _e1397 = phi_2544_;
                                                        let _e1399 = phi_2545_;
                                                        let _e1401 = phi_2546_;
                                                        let _e1403 = phi_2547_;
                                                        let _e1410 = ((_e1401.y * _e1399.z) - (_e1399.y * _e1401.z));
                                                        let _e1415 = ((_e1401.z * _e1399.x) - (_e1399.z * _e1401.x));
                                                        let _e1418 = ((_e1401.x * _e1399.y) - (_e1399.x * _e1401.y));
                                                        let _e1421 = ((_e1214 >= _e1218) && (_e1214 >= _e1222));
                                                        let _e1422 = (_e1218 >= _e1222);
                                                        let _e1436 = (((_e1410 * (select(select(_e1151[2][0], _e1151[1][0], _e1422), _e1151[0][0], _e1421) - _e329)) + (_e1415 * (select(select(_e1151[2][1], _e1151[1][1], _e1422), _e1151[0][1], _e1421) - _e396))) + (_e1418 * (select(select(_e1151[2][2], _e1151[1][2], _e1422), _e1151[0][2], _e1421) - _e462)));
                                                        let _e1441 = (((_e1410 * _e366) + (_e1415 * _e432)) + (_e1418 * _e498));
                                                        let _e1442 = (_e1391 - _e1395);
                                                        let _e1443 = (_e1389 - _e1393);
                                                        let _e1446 = ((_e1442 * _e1442) + (_e1443 * _e1443));
                                                        let _e1453 = (-(((_e1395 * _e1442) + (_e1393 * _e1443))) / select(0.000000000000000000000000000000000000011754944f, _e1446, (_e1446 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1455 = select(1f, _e1453, (_e1453 < 1f));
                                                        let _e1457 = select(0f, _e1455, (_e1455 > 0f));
                                                        let _e1466 = ((_e1397.x + (_e1403.x * _e1457)) - _e329);
                                                        let _e1469 = ((_e1397.y + (_e1403.y * _e1457)) - _e396);
                                                        let _e1472 = ((_e1397.z + (_e1403.z * _e1457)) - _e462);
                                                        let _e1475 = bitcast<f32>((bitcast<u32>(_e1466) & 2147483647u));
                                                        let _e1478 = bitcast<f32>((bitcast<u32>(_e1469) & 2147483647u));
                                                        let _e1480 = select(_e1478, _e1475, (_e1475 > _e1478));
                                                        let _e1483 = bitcast<f32>((bitcast<u32>(_e1472) & 2147483647u));
                                                        let _e1485 = select(_e1483, _e1480, (_e1480 > _e1483));
                                                        let _e1489 = abs(_e1410);
                                                        let _e1490 = abs(_e1415);
                                                        if (_e1489 != _e1489) {
                                                            phi_4219_ = true;
                                                        } else {
                                                            phi_4219_ = (_e1490 >= _e1489);
                                                        }
                                                        let _e1494 = phi_4219_;
                                                        let _e1495 = select(_e1489, _e1490, _e1494);
                                                        let _e1496 = abs(_e1418);
                                                        if (_e1495 != _e1495) {
                                                            phi_4234_ = true;
                                                        } else {
                                                            phi_4234_ = (_e1496 >= _e1495);
                                                        }
                                                        let _e1500 = phi_4234_;
                                                        let _e1516 = abs(_e1401.x);
                                                        let _e1517 = abs(_e1401.y);
                                                        if (_e1516 != _e1516) {
                                                            phi_4249_ = true;
                                                        } else {
                                                            phi_4249_ = (_e1517 >= _e1516);
                                                        }
                                                        let _e1521 = phi_4249_;
                                                        let _e1522 = select(_e1516, _e1517, _e1521);
                                                        let _e1523 = abs(_e1401.z);
                                                        if (_e1522 != _e1522) {
                                                            phi_4264_ = true;
                                                        } else {
                                                            phi_4264_ = (_e1523 >= _e1522);
                                                        }
                                                        let _e1527 = phi_4264_;
                                                        let _e1530 = abs(_e1399.x);
                                                        let _e1531 = abs(_e1399.y);
                                                        if (_e1530 != _e1530) {
                                                            phi_4279_ = true;
                                                        } else {
                                                            phi_4279_ = (_e1531 >= _e1530);
                                                        }
                                                        let _e1535 = phi_4279_;
                                                        let _e1536 = select(_e1530, _e1531, _e1535);
                                                        let _e1537 = abs(_e1399.z);
                                                        if (_e1536 != _e1536) {
                                                            phi_4294_ = true;
                                                        } else {
                                                            phi_4294_ = (_e1537 >= _e1536);
                                                        }
                                                        let _e1541 = phi_4294_;
                                                        let _e1546 = ((bitcast<f32>((bitcast<u32>(((((_e1410 * _e1466) + (_e1415 * _e1469)) + (_e1418 * _e1472)) - _e1436)) & 2147483647u)) <= ((0.0000009536743f * select(_e1376, _e1485, (_e1485 > _e1376))) * select(_e1495, _e1496, _e1500))) && !((bitcast<f32>((bitcast<u32>(_e1441) & 2147483647u)) <= ((0.0000038146973f * select(_e1522, _e1523, _e1527)) * select(_e1536, _e1537, _e1541)))));
                                                        let _e1547 = (_e1436 / _e1441);
                                                        if (_e1317 && !(_e1546)) {
                                                            let _e1550 = (_e1472 / _e498);
                                                            let _e1558 = (((_e1410 * (_e1466 - (_e366 * _e1550))) + (_e1415 * (_e1469 - (_e432 * _e1550)))) / _e1441);
                                                            phi_2755_ = select(select(_e1550, (_e1550 + _e1558), (bitcast<f32>((bitcast<u32>(_e1558) & 2147483647u)) <= _e1376)), _e1547, _e1546);
                                                        } else {
                                                            phi_2755_ = _e1547;
                                                        }
                                                        let _e1567 = phi_2755_;
                                                        let _e1569 = select(_e1280, _e1567, (_e1567 < _e1280));
                                                        let _e1571 = select(_e1272, _e1569, (_e1569 > _e1272));
                                                        let _e1572 = (1f / _e1224);
                                                        phi_2775_ = type_31(_e1571, (_e1218 * _e1572), (_e1222 * _e1572), ((_e1317 && (_e1571 >= _e605)) && (_e1571 <= _e704.member)));
                                                        phi_2776_ = type_31();
                                                    } else {
                                                        phi_2775_ = type_31();
                                                        phi_2776_ = type_31(0f, 0f, 0f, _e1317);
                                                    }
                                                    let _e1581 = phi_2775_;
                                                    let _e1583 = phi_2776_;
                                                    phi_2779_ = _e1581;
                                                    phi_2780_ = _e1583;
                                                    phi_2781_ = select(true, false, _e1317);
                                                } else {
                                                    phi_2779_ = type_31();
                                                    phi_2780_ = type_31(0f, 0f, 0f, _e1208);
                                                    phi_2781_ = true;
                                                }
                                                let _e1586 = phi_2779_;
                                                let _e1588 = phi_2780_;
                                                let _e1590 = phi_2781_;
                                                if _e1590 {
                                                    phi_2785_ = _e1588;
                                                } else {
                                                    phi_2785_ = _e1586;
                                                }
                                                let _e1592 = phi_2785_;
                                                if _e1592.member_3 {
                                                    phi_2794_ = type_20(_e1592.member, _e1592.member_1, _e1592.member_2, _e764);
                                                } else {
                                                    phi_2794_ = type_20(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1599 = phi_2794_;
                                                if (_e1599.member_3 != 4294967295u) {
                                                    if (_e764 != 4294967295u) {
                                                        phi_2805_ = type_35(-340282350000000000000000000000000000000f, true);
                                                    } else {
                                                        phi_2805_ = _e704;
                                                    }
                                                    let _e1604 = phi_2805_;
                                                    phi_2806_ = _e1604;
                                                } else {
                                                    phi_2806_ = _e704;
                                                }
                                                let _e1606 = phi_2806_;
                                                phi_1235_ = _e1606;
                                            } else {
                                                phi_1235_ = type_35();
                                            }
                                            let _e1608 = phi_1235_;
                                            continue;
                                            continuing {
                                                phi_1234_ = _e1608;
                                                phi_1237_ = _e719;
                                                phi_4488_ = _e647;
                                                break if !(_e725);
                                            }
                                        }
                                        let _e1611 = phi_4488_;
                                        phi_4697_ = _e1611;
                                        if _e1611 {
                                            break;
                                        }
                                        phi_4788_ = _e1611;
                                        let _e2264 = local_11;
                                        phi_2807_ = _e2264;
                                    } else {
                                        phi_4788_ = _e647;
                                        phi_2807_ = _e649;
                                    }
                                    let _e1613 = phi_4788_;
                                    let _e1615 = phi_2807_;
                                    if _e696 {
                                        phi_4072_ = bool();
                                        phi_4073_ = u32();
                                        phi_4074_ = type_46();
                                    } else {
                                        if (_e692.member_1 >= _e94) {
                                            phi_3608_ = type_47(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_46(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_46(type_24(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e692.member_1 < _e94) {
                                            } else {
                                                phi_4697_ = true;
                                                break;
                                            }
                                            let _e1618 = (_e265 * 2u);
                                            let _e1620 = ((1u + _e1618) % 7u);
                                            if (_e1620 < 7u) {
                                            } else {
                                                phi_4697_ = true;
                                                break;
                                            }
                                            let _e1625 = global_5.member[_e692.member_1][_e1620];
                                            let _e1627 = ((_e1618 + 2u) % 7u);
                                            if (_e1627 < 7u) {
                                            } else {
                                                phi_4697_ = true;
                                                break;
                                            }
                                            let _e1632 = global_5.member[_e692.member_1][_e1627];
                                            let _e1633 = (_e264 * 2u);
                                            let _e1635 = ((1u + _e1633) % 7u);
                                            if (_e1635 < 7u) {
                                            } else {
                                                phi_4697_ = true;
                                                break;
                                            }
                                            let _e1640 = global_5.member[_e692.member_1][_e1635];
                                            let _e1642 = ((_e1633 + 2u) % 7u);
                                            if (_e1642 < 7u) {
                                            } else {
                                                phi_4697_ = true;
                                                break;
                                            }
                                            let _e1647 = global_5.member[_e692.member_1][_e1642];
                                            let _e1648 = (_e266 * 2u);
                                            let _e1650 = ((1u + _e1648) % 7u);
                                            if (_e1650 < 7u) {
                                            } else {
                                                phi_4697_ = true;
                                                break;
                                            }
                                            let _e1655 = global_5.member[_e692.member_1][_e1650];
                                            let _e1657 = ((_e1648 + 2u) % 7u);
                                            if (_e1657 < 7u) {
                                            } else {
                                                phi_4697_ = true;
                                                break;
                                            }
                                            let _e1662 = global_5.member[_e692.member_1][_e1657];
                                            let _e1685 = (bitcast<f32>((bitcast<u32>((_e692.member.member_1.x - _e692.member.member.x)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1686 = (bitcast<f32>((bitcast<u32>((_e692.member.member_1.y - _e692.member.member.y)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1687 = (bitcast<f32>((bitcast<u32>((_e692.member.member_1.z - _e692.member.member.z)) & 2139095040u)) * 0.0000009536743f);
                                            let _e1689 = select(_e145, _e1685, (_e1685 > _e145));
                                            let _e1691 = select(_e145, _e1686, (_e1686 > _e145));
                                            let _e1693 = select(_e145, _e1687, (_e1687 > _e145));
                                            let _e1724 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1625 & 2097151u))) - 8388608f) * _e1689));
                                            let _e1729 = (bitcast<i32>((_e1625 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1732 = bitcast<f32>((_e1724 & bitcast<u32>(_e1729)));
                                            let _e1733 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1640 & 2097151u))) - 8388608f) * _e1691));
                                            let _e1738 = (bitcast<i32>((_e1640 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1741 = bitcast<f32>((_e1733 & bitcast<u32>(_e1738)));
                                            let _e1742 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1655 & 2097151u))) - 8388608f) * _e1693));
                                            let _e1747 = (bitcast<i32>((_e1655 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1750 = bitcast<f32>((_e1742 & bitcast<u32>(_e1747)));
                                            let _e1754 = bitcast<f32>((_e1724 & bitcast<u32>(~(_e1729))));
                                            let _e1758 = bitcast<f32>((_e1733 & bitcast<u32>(~(_e1738))));
                                            let _e1762 = bitcast<f32>((_e1742 & bitcast<u32>(~(_e1747))));
                                            let _e1763 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1632 & 2097151u))) - 8388608f) * _e1689));
                                            let _e1768 = (bitcast<i32>((_e1632 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1771 = bitcast<f32>((_e1763 & bitcast<u32>(_e1768)));
                                            let _e1772 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1647 & 2097151u))) - 8388608f) * _e1691));
                                            let _e1777 = (bitcast<i32>((_e1647 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1780 = bitcast<f32>((_e1772 & bitcast<u32>(_e1777)));
                                            let _e1781 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1662 & 2097151u))) - 8388608f) * _e1693));
                                            let _e1786 = (bitcast<i32>((_e1662 << bitcast<u32>(10u))) >> bitcast<u32>(31i));
                                            let _e1789 = bitcast<f32>((_e1781 & bitcast<u32>(_e1786)));
                                            let _e1793 = bitcast<f32>((_e1763 & bitcast<u32>(~(_e1768))));
                                            let _e1797 = bitcast<f32>((_e1772 & bitcast<u32>(~(_e1777))));
                                            let _e1801 = bitcast<f32>((_e1781 & bitcast<u32>(~(_e1786))));
                                            let _e1802 = (_e692.member.member.x + _e1732);
                                            let _e1803 = (_e692.member.member.y + _e1741);
                                            let _e1804 = (_e692.member.member.z + _e1750);
                                            let _e1807 = (_e692.member.member_1.x - _e1771);
                                            let _e1808 = (_e692.member.member_1.y - _e1780);
                                            let _e1809 = (_e692.member.member_1.z - _e1789);
                                            let _e1828 = (_e1807 - _e1802);
                                            let _e1829 = (_e1808 - _e1803);
                                            let _e1830 = (_e1809 - _e1804);
                                            let _e1832 = select(_e1829, _e1828, (_e1828 > _e1829));
                                            let _e1834 = select(_e1830, _e1832, (_e1832 > _e1830));
                                            if (_e1834 < (1024f * _e145)) {
                                                phi_3309_ = 0u;
                                            } else {
                                                phi_3309_ = select(2u, 1u, (_e1834 < (2097152f * _e145)));
                                            }
                                            let _e1841 = phi_3309_;
                                            switch bitcast<i32>(_e1841) {
                                                case 0: {
                                                    phi_3315_ = 1u;
                                                    break;
                                                }
                                                case 1: {
                                                    phi_3315_ = 2u;
                                                    break;
                                                }
                                                case 2: {
                                                    phi_3315_ = 3u;
                                                    break;
                                                }
                                                default: {
                                                    phi_3315_ = u32();
                                                    break;
                                                }
                                            }
                                            let _e1844 = phi_3315_;
                                            let _e1850 = global_5.member[_e692.member_1][0u];
                                            let _e1854 = global_5.member[_e692.member_1][2u];
                                            let _e1858 = global_5.member[_e692.member_1][4u];
                                            let _e1862 = global_5.member[_e692.member_1][6u];
                                            let _e1874 = (((_e1854 >> bitcast<u32>(22i)) | ((_e1858 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1862 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e1875 = (_e1850 & 268435455u);
                                            let _e1876 = (_e1874 & 268435455u);
                                            let _e1879 = ((_e1850 >> bitcast<u32>(28u)) & 7u);
                                            let _e1887 = ((_e1850 >> bitcast<u32>(31i)) | (((_e1874 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e1888 = (_e1879 != 0u);
                                            if (_e1879 == 0u) {
                                                phi_3570_ = _e1875;
                                            } else {
                                                if (_e1879 == 7u) {
                                                    phi_3569_ = 2147483648u;
                                                } else {
                                                    phi_3569_ = ((2147483648u | (_e1879 << bitcast<u32>(28u))) | (_e1876 & 268435455u));
                                                }
                                                let _e1897 = phi_3569_;
                                                phi_3570_ = _e1897;
                                            }
                                            let _e1899 = phi_3570_;
                                            if _e1888 {
                                                let _e1900 = (_e1879 != 7u);
                                                if _e1900 {
                                                    phi_3580_ = (_e1876 + (_e1879 * ((3u * _e1844) + 1u)));
                                                } else {
                                                    phi_3580_ = u32();
                                                }
                                                let _e1904 = phi_3580_;
                                                phi_3582_ = _e1904;
                                                phi_3583_ = select(true, false, _e1900);
                                            } else {
                                                phi_3582_ = u32();
                                                phi_3583_ = true;
                                            }
                                            let _e1907 = phi_3582_;
                                            let _e1909 = phi_3583_;
                                            if (_e1887 == 0u) {
                                                phi_3604_ = (_e1875 + select(0u, 1u, !(_e1888)));
                                            } else {
                                                if (_e1887 == 7u) {
                                                    phi_3603_ = 2147483648u;
                                                } else {
                                                    phi_3603_ = ((2147483648u | (_e1887 << bitcast<u32>(28u))) | (select(_e1907, _e1876, _e1909) & 268435455u));
                                                }
                                                let _e1922 = phi_3603_;
                                                phi_3604_ = _e1922;
                                            }
                                            let _e1924 = phi_3604_;
                                            phi_3608_ = type_47(array<vec4<f32>, 3>(vec4<f32>(_e1802, (_e692.member.member.x + _e1754), _e1807, (_e692.member.member_1.x - _e1793)), vec4<f32>(_e1803, (_e692.member.member.y + _e1758), _e1808, (_e692.member.member_1.y - _e1797)), vec4<f32>(_e1804, (_e692.member.member.z + _e1762), _e1809, (_e692.member.member_1.z - _e1801))), type_46(type_24((_e692.member.member + vec4<f32>(_e1732, _e1741, _e1750, 0f)), (_e692.member.member_1 - vec4<f32>(_e1771, _e1780, _e1789, 0f))), _e1899), type_46(type_24((_e692.member.member + vec4<f32>(_e1754, _e1758, _e1762, 0f)), (_e692.member.member_1 - vec4<f32>(_e1793, _e1797, _e1801, 0f))), _e1924));
                                        }
                                        let _e1929 = phi_3608_;
                                        let _e1941 = ((_e1929.member[0].x - _e367) * _e370);
                                        let _e1942 = ((_e1929.member[0].y - _e367) * _e370);
                                        let _e1943 = ((_e1929.member[0].z - _e368) * _e370);
                                        let _e1944 = ((_e1929.member[0].w - _e368) * _e370);
                                        let _e1954 = ((_e1929.member[1].x - _e433) * _e436);
                                        let _e1955 = ((_e1929.member[1].y - _e433) * _e436);
                                        let _e1956 = ((_e1929.member[1].z - _e434) * _e436);
                                        let _e1957 = ((_e1929.member[1].w - _e434) * _e436);
                                        let _e1967 = ((_e1929.member[2].x - _e499) * _e502);
                                        let _e1968 = ((_e1929.member[2].y - _e499) * _e502);
                                        let _e1969 = ((_e1929.member[2].z - _e500) * _e502);
                                        let _e1970 = ((_e1929.member[2].w - _e500) * _e502);
                                        let _e1972 = select(_e1969, _e1967, (_e1967 < _e1969));
                                        let _e1974 = select(_e1970, _e1968, (_e1968 < _e1970));
                                        let _e1976 = select(_e1969, _e1967, (_e1967 > _e1969));
                                        let _e1978 = select(_e1970, _e1968, (_e1968 > _e1970));
                                        let _e1980 = select(_e1943, _e1941, (_e1941 < _e1943));
                                        let _e1982 = select(_e1944, _e1942, (_e1942 < _e1944));
                                        let _e1984 = select(_e1956, _e1954, (_e1954 < _e1956));
                                        let _e1986 = select(_e1957, _e1955, (_e1955 < _e1957));
                                        let _e1988 = select(_e1984, _e1980, (_e1980 > _e1984));
                                        let _e1990 = select(_e1986, _e1982, (_e1982 > _e1986));
                                        let _e1992 = select(_e1972, _e1988, (_e1988 > _e1972));
                                        let _e1994 = select(_e1974, _e1990, (_e1990 > _e1974));
                                        let _e1996 = select(_e1943, _e1941, (_e1941 > _e1943));
                                        let _e1998 = select(_e1944, _e1942, (_e1942 > _e1944));
                                        let _e2000 = select(_e1956, _e1954, (_e1954 > _e1956));
                                        let _e2002 = select(_e1957, _e1955, (_e1955 > _e1957));
                                        let _e2004 = select(_e2000, _e1996, (_e1996 < _e2000));
                                        let _e2006 = select(_e2002, _e1998, (_e1998 < _e2002));
                                        let _e2011 = -(_e1972);
                                        let _e2012 = -(_e1974);
                                        let _e2019 = (select(_e1976, _e2004, (_e2004 < _e1976)) + (select(_e2011, _e1976, (_e1976 > _e2011)) * 0.0000019073523f));
                                        let _e2020 = (select(_e1978, _e2006, (_e2006 < _e1978)) + (select(_e2012, _e1978, (_e1978 > _e2012)) * 0.0000019073523f));
                                        let _e2022 = select(_e605, _e1992, (_e1992 > _e605));
                                        let _e2024 = select(_e605, _e1994, (_e1994 > _e605));
                                        let _e2029 = (_e2022 <= select(_e1615.member, _e2019, (_e2019 < _e1615.member)));
                                        let _e2030 = (_e2024 <= select(_e1615.member, _e2020, (_e2020 < _e1615.member)));
                                        let _e2031 = (_e2022 <= _e2024);
                                        if _e2029 {
                                            if _e2030 {
                                                if _e2031 {
                                                    phi_3970_ = _e1929.member_2;
                                                } else {
                                                    phi_3970_ = _e1929.member_1;
                                                }
                                                let _e2035 = phi_3970_;
                                                let _e2056 = (_e690 % 128u);
                                                let _e2057 = (_e2056 < 128u);
                                                if _e2057 {
                                                } else {
                                                    phi_4697_ = true;
                                                    break;
                                                }
                                                local_8[_e2056] = _e2035.member_1;
                                                if _e2057 {
                                                } else {
                                                    phi_4697_ = true;
                                                    break;
                                                }
                                                local_7[_e2056] = _e2035.member.member.x;
                                                if _e2057 {
                                                } else {
                                                    phi_4697_ = true;
                                                    break;
                                                }
                                                local_6[_e2056] = _e2035.member.member.y;
                                                if _e2057 {
                                                } else {
                                                    phi_4697_ = true;
                                                    break;
                                                }
                                                local_5[_e2056] = _e2035.member.member.z;
                                                if _e2057 {
                                                } else {
                                                    phi_4697_ = true;
                                                    break;
                                                }
                                                local_4[_e2056] = _e2035.member.member_1.x;
                                                if _e2057 {
                                                } else {
                                                    phi_4697_ = true;
                                                    break;
                                                }
                                                local_3[_e2056] = _e2035.member.member_1.y;
                                                if _e2057 {
                                                } else {
                                                    phi_4697_ = true;
                                                    break;
                                                }
                                                local_2[_e2056] = _e2035.member.member_1.z;
                                                if _e2057 {
                                                } else {
                                                    phi_4697_ = true;
                                                    break;
                                                }
                                                local_9[_e2056] = select(_e2022, _e2024, _e2031);
                                                if _e2031 {
                                                    phi_4046_ = _e1929.member_1;
                                                } else {
                                                    phi_4046_ = _e1929.member_2;
                                                }
                                                let _e2070 = phi_4046_;
                                                phi_4047_ = (_e690 + 1u);
                                                phi_4048_ = _e2070;
                                            } else {
                                                phi_4047_ = u32();
                                                phi_4048_ = type_46();
                                            }
                                            let _e2072 = phi_4047_;
                                            let _e2074 = phi_4048_;
                                            phi_4050_ = _e2072;
                                            phi_4051_ = _e2074;
                                            phi_4052_ = select(true, false, _e2030);
                                        } else {
                                            phi_4050_ = u32();
                                            phi_4051_ = type_46();
                                            phi_4052_ = true;
                                        }
                                        let _e2077 = phi_4050_;
                                        let _e2079 = phi_4051_;
                                        let _e2081 = phi_4052_;
                                        if _e2081 {
                                            if _e2029 {
                                                phi_4061_ = _e1929.member_1;
                                            } else {
                                                phi_4061_ = _e1929.member_2;
                                            }
                                            let _e2085 = phi_4061_;
                                            phi_4066_ = select(_e2030, true, _e2029);
                                            phi_4068_ = _e2085;
                                        } else {
                                            phi_4066_ = _e688;
                                            phi_4068_ = _e2079;
                                        }
                                        let _e2088 = phi_4066_;
                                        let _e2090 = phi_4068_;
                                        phi_4072_ = _e2088;
                                        phi_4073_ = select(_e2077, _e690, _e2081);
                                        phi_4074_ = _e2090;
                                    }
                                    let _e2093 = phi_4072_;
                                    let _e2095 = phi_4073_;
                                    let _e2097 = phi_4074_;
                                    if _e696 {
                                        phi_4084_ = select(_e690, 0u, _e1615.member_1);
                                        phi_4085_ = _e692;
                                    } else {
                                        phi_4084_ = _e2095;
                                        phi_4085_ = _e2097;
                                    }
                                    let _e2101 = phi_4084_;
                                    let _e2103 = phi_4085_;
                                    phi_4700_ = _e1613;
                                    phi_4086_ = _e1615;
                                    phi_4087_ = (_e651 - 1u);
                                    phi_4088_ = select(_e2093, false, _e696);
                                    phi_4089_ = _e2101;
                                    phi_4090_ = _e2103;
                                } else {
                                    phi_4700_ = _e647;
                                    phi_4086_ = _e649;
                                    phi_4087_ = _e651;
                                    phi_4088_ = _e688;
                                    phi_4089_ = _e690;
                                    phi_4090_ = _e692;
                                }
                                let _e2106 = phi_4700_;
                                let _e2108 = phi_4086_;
                                let _e2110 = phi_4087_;
                                let _e2112 = phi_4088_;
                                let _e2114 = phi_4089_;
                                let _e2116 = phi_4090_;
                                phi_4699_ = _e2106;
                                phi_4091_ = _e2108;
                                phi_4092_ = _e2110;
                                phi_4093_ = _e2112;
                                phi_4094_ = _e2114;
                                phi_4095_ = _e2116;
                            } else {
                                phi_4699_ = _e647;
                                phi_4091_ = type_35();
                                phi_4092_ = u32();
                                phi_4093_ = bool();
                                phi_4094_ = u32();
                                phi_4095_ = type_46();
                            }
                            let _e2118 = phi_4699_;
                            let _e2120 = phi_4091_;
                            let _e2122 = phi_4092_;
                            let _e2124 = phi_4093_;
                            let _e2126 = phi_4094_;
                            let _e2128 = phi_4095_;
                            phi_4698_ = _e2118;
                            phi_1108_ = _e2120;
                            phi_1111_ = _e2122;
                            phi_1113_ = _e2124;
                            phi_1115_ = _e2126;
                            phi_1117_ = _e2128;
                            phi_4096_ = _e661;
                        } else {
                            phi_4698_ = _e647;
                            phi_1108_ = type_35();
                            phi_1111_ = u32();
                            phi_1113_ = bool();
                            phi_1115_ = u32();
                            phi_1117_ = type_46();
                            phi_4096_ = false;
                        }
                        let _e2130 = phi_4698_;
                        let _e2132 = phi_1108_;
                        let _e2134 = phi_1111_;
                        let _e2136 = phi_1113_;
                        let _e2138 = phi_1115_;
                        let _e2140 = phi_1117_;
                        let _e2142 = phi_4096_;
                        continue;
                        continuing {
                            phi_4494_ = _e2130;
                            phi_1107_ = _e2132;
                            phi_1110_ = _e2134;
                            phi_1112_ = _e2136;
                            phi_1114_ = _e2138;
                            phi_1116_ = _e2140;
                            phi_4697_ = _e2130;
                            break if !(_e2142);
                        }
                    }
                    let _e2145 = phi_4697_;
                    if _e2145 {
                        break;
                    }
                    let _e2147 = local_10;
                    if _e153 {
                    } else {
                        break;
                    }
                    global_4.member[_e151] = select(0u, 1u, _e2147.member_1);
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
