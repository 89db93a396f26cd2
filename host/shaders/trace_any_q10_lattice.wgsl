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
    var phi_1107_: type_39;
    var phi_1110_: u32;
    var phi_1112_: bool;
    var phi_1114_: u32;
    var phi_1116_: type_46;
    var phi_1127_: bool;
    var phi_1213_: bool;
    var phi_1214_: u32;
    var phi_1215_: type_46;
    var phi_1234_: type_39;
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
    var phi_2775_: type_35;
    var phi_2776_: type_35;
    var phi_2779_: type_35;
    var phi_2780_: type_35;
    var phi_2781_: bool;
    var phi_2785_: type_35;
    var phi_2794_: type_24;
    var phi_2805_: type_39;
    var phi_2806_: type_39;
    var phi_1235_: type_39;
    var phi_4488_: bool;
    var phi_4788_: bool;
    var phi_2807_: type_39;
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
    var phi_4086_: type_39;
    var phi_4087_: u32;
    var phi_4088_: bool;
    var phi_4089_: u32;
    var phi_4090_: type_46;
    var phi_4699_: bool;
    var phi_4091_: type_39;
    var phi_4092_: u32;
    var phi_4093_: bool;
    var phi_4094_: u32;
    var phi_4095_: type_46;
    var phi_4698_: bool;
    var phi_1108_: type_39;
    var phi_1111_: u32;
    var phi_1113_: bool;
    var phi_1115_: u32;
    var phi_1117_: type_46;
    var phi_4096_: bool;
    var phi_4697_: bool;
    var local_10: type_39;
    var local_11: type_39;

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
                            phi_418_ = (bitcast<i32>((_e233 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_418_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e233)), 32u, (_e233 == 0u))));
                        }
                        let _e247 = phi_418_;
                        phi_419_ = _e247;
                    } else {
                        phi_419_ = 0i;
                    }
                    let _e249 = phi_419_;
                    let _e250 = (_e166 == _e205);
                    if _e250 {
                        phi_429_ = true;
                    } else {
                        phi_429_ = (_e173 == _e205);
                    }
                    let _e253 = phi_429_;
                    let _e254 = select(1u, 0u, _e250);
                    if _e253 {
                        let _e255 = (_e254 + 1u);
                        phi_439_ = _e255;
                        phi_440_ = _e255;
                        phi_442_ = select(true, false, (_e255 == 2u));
                    } else {
                        phi_439_ = u32();
                        phi_440_ = 0u;
                        phi_442_ = true;
                    }
                    let _e259 = phi_439_;
                    let _e261 = phi_440_;
                    let _e263 = phi_442_;
                    if _e263 {
                        phi_447_ = (_e261 + 1u);
                    } else {
                        phi_447_ = 0u;
                    }
                    let _e267 = phi_447_;
                    let _e268 = select(_e259, _e261, _e263);
                    let _e269 = select(_e254, select(2u, _e254, _e253), _e263);
                    if (_e136 < -126i) {
                        phi_460_ = -126i;
                    } else {
                        phi_460_ = select(_e136, 127i, (_e136 > 127i));
                    }
                    let _e274 = phi_460_;
                    let _e279 = bitcast<f32>((bitcast<u32>((_e274 + 127i)) << bitcast<u32>(23i)));
                    let _e285 = bitcast<f32>((bitcast<u32>(((_e136 - _e274) + 127i)) << bitcast<u32>(23i)));
                    let _e286 = -(_e249);
                    if (_e286 < -126i) {
                        phi_480_ = -126i;
                    } else {
                        phi_480_ = select(_e286, 127i, (_e286 > 127i));
                    }
                    let _e291 = phi_480_;
                    let _e296 = bitcast<f32>((bitcast<u32>((_e291 + 127i)) << bitcast<u32>(23i)));
                    let _e302 = bitcast<f32>((bitcast<u32>(((_e286 - _e291) + 127i)) << bitcast<u32>(23i)));
                    let _e306 = global_4.member[_e154].member;
                    let _e307 = (_e268 == 0u);
                    if _e307 {
                        phi_498_ = _e306[0];
                    } else {
                        phi_498_ = _e306[1];
                    }
                    let _e311 = phi_498_;
                    let _e312 = (_e268 == 2u);
                    if _e312 {
                        phi_504_ = _e306[2];
                    } else {
                        phi_504_ = _e311;
                    }
                    let _e315 = phi_504_;
                    let _e316 = bitcast<u32>(_e315);
                    let _e318 = ((_e316 & 2139095040u) != 0u);
                    let _e332 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e316 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e316 & 2147483648u))), _e315, _e318) * _e279) * select(0.00000011920929f, 1f, _e318)) * _e285);
                    let _e333 = global_4.member[_e154].member_2;
                    if _e307 {
                        phi_544_ = _e333[0];
                    } else {
                        phi_544_ = _e333[1];
                    }
                    let _e337 = phi_544_;
                    if _e312 {
                        phi_550_ = _e333[2];
                    } else {
                        phi_550_ = _e337;
                    }
                    let _e340 = phi_550_;
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
                        phi_623_ = _e306[0];
                    } else {
                        phi_623_ = _e306[1];
                    }
                    let _e378 = phi_623_;
                    let _e379 = (_e267 == 2u);
                    if _e379 {
                        phi_629_ = _e306[2];
                    } else {
                        phi_629_ = _e378;
                    }
                    let _e382 = phi_629_;
                    let _e383 = bitcast<u32>(_e382);
                    let _e385 = ((_e383 & 2139095040u) != 0u);
                    let _e399 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e383 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e383 & 2147483648u))), _e382, _e385) * _e279) * select(0.00000011920929f, 1f, _e385)) * _e285);
                    if _e374 {
                        phi_669_ = _e333[0];
                    } else {
                        phi_669_ = _e333[1];
                    }
                    let _e403 = phi_669_;
                    if _e379 {
                        phi_675_ = _e333[2];
                    } else {
                        phi_675_ = _e403;
                    }
                    let _e406 = phi_675_;
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
                        phi_748_ = _e306[0];
                    } else {
                        phi_748_ = _e306[1];
                    }
                    let _e444 = phi_748_;
                    let _e445 = (_e269 == 2u);
                    if _e445 {
                        phi_754_ = _e306[2];
                    } else {
                        phi_754_ = _e444;
                    }
                    let _e448 = phi_754_;
                    let _e449 = bitcast<u32>(_e448);
                    let _e451 = ((_e449 & 2139095040u) != 0u);
                    let _e465 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e449 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e449 & 2147483648u))), _e448, _e451) * _e279) * select(0.00000011920929f, 1f, _e451)) * _e285);
                    if _e440 {
                        phi_794_ = _e333[0];
                    } else {
                        phi_794_ = _e333[1];
                    }
                    let _e469 = phi_794_;
                    if _e445 {
                        phi_800_ = _e333[2];
                    } else {
                        phi_800_ = _e469;
                    }
                    let _e472 = phi_800_;
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
                            phi_919_ = 255i;
                        } else {
                            phi_919_ = (((_e523 + select(0i, 1i, (_e523 == 0i))) - _e530) + _e510);
                        }
                        let _e538 = phi_919_;
                        let _e548 = (_e538 <= 0i);
                        if _e548 {
                            phi_942_ = u32();
                        } else {
                            if _e527 {
                                phi_941_ = u32();
                            } else {
                                phi_941_ = select(((bitcast<u32>(_e538) << bitcast<u32>(23i)) | ((_e520 << bitcast<u32>(((_e530 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e538 >= 255i));
                            }
                            let _e552 = phi_941_;
                            phi_942_ = _e552;
                        }
                        let _e554 = phi_942_;
                        let _e566 = ((_e226 & 8388607u) | (select(0u, 1u, ((_e226 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e569 = bitcast<i32>((_e226 >> bitcast<u32>(23i)));
                        let _e573 = (_e566 == 0u);
                        let _e576 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e566)), 32u, _e573)) - 8i);
                        if (_e569 == 255i) {
                            phi_979_ = 255i;
                        } else {
                            phi_979_ = (((_e569 + select(0i, 1i, (_e569 == 0i))) - _e576) + _e510);
                        }
                        let _e584 = phi_979_;
                        let _e594 = (_e584 <= 0i);
                        if _e594 {
                            phi_1002_ = u32();
                        } else {
                            if _e573 {
                                phi_1001_ = u32();
                            } else {
                                phi_1001_ = select(((bitcast<u32>(_e584) << bitcast<u32>(23i)) | ((_e566 << bitcast<u32>(((_e576 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e584 >= 255i));
                            }
                            let _e598 = phi_1001_;
                            phi_1002_ = _e598;
                        }
                        let _e600 = phi_1002_;
                        phi_1010_ = bitcast<f32>(((_e225 & 2147483648u) | select(_e600, 0u, select(_e573, true, _e594))));
                        phi_1011_ = bitcast<f32>(((_e216 & 2147483648u) | select(_e554, 0u, select(_e527, true, _e548))));
                    } else {
                        phi_1010_ = 0f;
                        phi_1011_ = 1f;
                    }
                    let _e606 = phi_1010_;
                    let _e608 = phi_1011_;
                    local_8 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_6 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    let _e612 = (_e268 % 3u);
                    let _e613 = (_e612 < 3u);
                    if _e613 {
                    } else {
                        break;
                    }
                    let _e615 = local_1[_e612];
                    let _e618 = (_e267 % 3u);
                    let _e619 = (_e618 < 3u);
                    if _e619 {
                    } else {
                        break;
                    }
                    let _e621 = local_1[_e618];
                    let _e624 = (_e269 % 3u);
                    let _e625 = (_e624 < 3u);
                    if _e625 {
                    } else {
                        break;
                    }
                    let _e627 = local_1[_e624];
                    if _e613 {
                    } else {
                        break;
                    }
                    let _e632 = local[_e612];
                    if _e619 {
                    } else {
                        break;
                    }
                    let _e636 = local[_e618];
                    if _e625 {
                    } else {
                        break;
                    }
                    let _e640 = local[_e624];
                    phi_4494_ = false;
                    phi_1107_ = type_39(_e606, false);
                    phi_1110_ = ((3u * _e97) + 1u);
                    phi_1112_ = (_e608 <= _e606);
                    phi_1114_ = 0u;
                    phi_1116_ = type_46(type_28(vec4<f32>((f32(_e615) * _e148), (f32(_e621) * _e148), (f32(_e627) * _e148), 0f), vec4<f32>((f32(_e632) * _e148), (f32(_e636) * _e148), (f32(_e640) * _e148), 0f)), select(0u, 2147483648u, (_e97 == 0u)));
                    loop {
                        let _e650 = phi_4494_;
                        let _e652 = phi_1107_;
                        let _e654 = phi_1110_;
                        let _e656 = phi_1112_;
                        let _e658 = phi_1114_;
                        let _e660 = phi_1116_;
                        local_10 = _e652;
                        if _e656 {
                            phi_1127_ = true;
                        } else {
                            phi_1127_ = (_e658 > 0u);
                        }
                        let _e663 = phi_1127_;
                        if _e663 {
                            let _e664 = (_e654 > 0u);
                            if _e664 {
                                if _e656 {
                                    phi_1213_ = _e656;
                                    phi_1214_ = _e658;
                                    phi_1215_ = _e660;
                                } else {
                                    let _e665 = (_e658 - 1u);
                                    let _e666 = (_e665 % 128u);
                                    let _e667 = (_e666 < 128u);
                                    if _e667 {
                                    } else {
                                        phi_4697_ = true;
                                        break;
                                    }
                                    let _e669 = local_7[_e666];
                                    if _e667 {
                                    } else {
                                        phi_4697_ = true;
                                        break;
                                    }
                                    let _e671 = local_6[_e666];
                                    if _e667 {
                                    } else {
                                        phi_4697_ = true;
                                        break;
                                    }
                                    let _e673 = local_5[_e666];
                                    if _e667 {
                                    } else {
                                        phi_4697_ = true;
                                        break;
                                    }
                                    let _e675 = local_4[_e666];
                                    if _e667 {
                                    } else {
                                        phi_4697_ = true;
                                        break;
                                    }
                                    let _e677 = local_3[_e666];
                                    if _e667 {
                                    } else {
                                        phi_4697_ = true;
                                        break;
                                    }
                                    let _e679 = local_2[_e666];
                                    if _e667 {
                                    } else {
                                        phi_4697_ = true;
                                        break;
                                    }
                                    let _e684 = local_8[_e666];
                                    if _e667 {
                                    } else {
                                        phi_4697_ = true;
                                        break;
                                    }
                                    let _e687 = local_9[_e666];
                                    phi_1213_ = (_e687 <= _e652.member);
                                    phi_1214_ = _e665;
                                    phi_1215_ = type_46(type_28(vec4<f32>(_e669, _e671, _e673, 0f), vec4<f32>(_e675, _e677, _e679, 0f)), _e684);
                                }
                                let _e691 = phi_1213_;
                                let _e693 = phi_1214_;
                                let _e695 = phi_1215_;
                                if _e691 {
                                    let _e699 = ((_e695.member_1 & 2147483648u) != 0u);
                                    let _e700 = (_e695.member_1 & 268435455u);
                                    if _e699 {
                                        phi_1234_ = _e652;
                                        phi_1237_ = type_8(0u, ((_e695.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e707 = phi_1234_;
                                            let _e709 = phi_1237_;
                                            local_11 = _e707;
                                            if (_e709.member < _e709.member_1) {
                                                phi_1238_ = type_8((_e709.member + 1u), _e709.member_1);
                                                phi_1260_ = type_8(1u, _e709.member);
                                            } else {
                                                phi_1238_ = _e709;
                                                phi_1260_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e722 = phi_1238_;
                                            let _e724 = phi_1260_;
                                            let _e728 = (bitcast<i32>(_e724.member) != 0i);
                                            if _e728 {
                                                let _e733 = (_e695.member.member_1.x - _e695.member.member.x);
                                                let _e736 = (_e695.member.member_1.y - _e695.member.member.y);
                                                let _e739 = (_e695.member.member_1.z - _e695.member.member.z);
                                                let _e741 = select(_e736, _e733, (_e733 > _e736));
                                                let _e743 = select(_e739, _e741, (_e741 > _e739));
                                                let _e745 = (_e743 < (1024f * _e148));
                                                if _e745 {
                                                    phi_1301_ = 0u;
                                                } else {
                                                    phi_1301_ = select(2u, 1u, (_e743 < (2097152f * _e148)));
                                                }
                                                let _e750 = phi_1301_;
                                                switch bitcast<i32>(_e750) {
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
                                                let _e753 = phi_1307_;
                                                switch bitcast<i32>(_e750) {
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
                                                let _e760 = phi_1317_;
                                                let _e762 = ((_e700 + (_e724.member_1 * ((3u * _e753) + 1u))) + (3u * _e760));
                                                let _e763 = (_e762 < _e100);
                                                if _e763 {
                                                    if _e763 {
                                                    } else {
                                                        phi_4488_ = true;
                                                        break;
                                                    }
                                                    let _e765 = global_6.member[_e762];
                                                    phi_1333_ = _e765;
                                                } else {
                                                    phi_1333_ = 4294967295u;
                                                }
                                                let _e767 = phi_1333_;
                                                if _e745 {
                                                    phi_1366_ = 0u;
                                                } else {
                                                    phi_1366_ = select(2u, 1u, (_e743 < (2097152f * _e148)));
                                                }
                                                let _e772 = phi_1366_;
                                                switch bitcast<i32>(_e772) {
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
                                                let _e775 = phi_1372_;
                                                let _e779 = (_e700 + (_e724.member_1 * ((3u * _e775) + 1u)));
                                                switch bitcast<i32>(_e772) {
                                                    case 0: {
                                                        let _e1054 = (_e779 < _e100);
                                                        if _e1054 {
                                                            if _e1054 {
                                                            } else {
                                                                phi_4488_ = true;
                                                                break;
                                                            }
                                                            let _e1056 = global_6.member[_e779];
                                                            phi_1399_ = _e1056;
                                                        } else {
                                                            phi_1399_ = 0u;
                                                        }
                                                        let _e1058 = phi_1399_;
                                                        let _e1060 = ((10u * _e268) & 31u);
                                                        let _e1070 = ((10u * _e267) & 31u);
                                                        let _e1080 = ((10u * _e269) & 31u);
                                                        let _e1090 = (_e779 + 1u);
                                                        let _e1091 = (_e1090 < _e100);
                                                        if _e1091 {
                                                            if _e1091 {
                                                            } else {
                                                                phi_4488_ = true;
                                                                break;
                                                            }
                                                            let _e1093 = global_6.member[_e1090];
                                                            phi_1448_ = _e1093;
                                                        } else {
                                                            phi_1448_ = 0u;
                                                        }
                                                        let _e1095 = phi_1448_;
                                                        let _e1121 = (_e779 + 2u);
                                                        let _e1122 = (_e1121 < _e100);
                                                        if _e1122 {
                                                            if _e1122 {
                                                            } else {
                                                                phi_4488_ = true;
                                                                break;
                                                            }
                                                            let _e1124 = global_6.member[_e1121];
                                                            phi_1497_ = _e1124;
                                                        } else {
                                                            phi_1497_ = 0u;
                                                        }
                                                        let _e1126 = phi_1497_;
                                                        phi_1998_ = array<array<f32, 3>, 3>(array<f32, 3>((_e695.member.member.x + ((bitcast<f32>((1258291200u | ((_e1058 >> bitcast<u32>(_e1060)) & 1023u))) - 8388608f) * _e148)), (_e695.member.member.y + ((bitcast<f32>((1258291200u | ((_e1058 >> bitcast<u32>(_e1070)) & 1023u))) - 8388608f) * _e148)), (_e695.member.member.z + ((bitcast<f32>((1258291200u | ((_e1058 >> bitcast<u32>(_e1080)) & 1023u))) - 8388608f) * _e148))), array<f32, 3>((_e695.member.member.x + ((bitcast<f32>((1258291200u | ((_e1095 >> bitcast<u32>(_e1060)) & 1023u))) - 8388608f) * _e148)), (_e695.member.member.y + ((bitcast<f32>((1258291200u | ((_e1095 >> bitcast<u32>(_e1070)) & 1023u))) - 8388608f) * _e148)), (_e695.member.member.z + ((bitcast<f32>((1258291200u | ((_e1095 >> bitcast<u32>(_e1080)) & 1023u))) - 8388608f) * _e148))), array<f32, 3>((_e695.member.member.x + ((bitcast<f32>((1258291200u | ((_e1126 >> bitcast<u32>(_e1060)) & 1023u))) - 8388608f) * _e148)), (_e695.member.member.y + ((bitcast<f32>((1258291200u | ((_e1126 >> bitcast<u32>(_e1070)) & 1023u))) - 8388608f) * _e148)), (_e695.member.member.z + ((bitcast<f32>((1258291200u | ((_e1126 >> bitcast<u32>(_e1080)) & 1023u))) - 8388608f) * _e148))));
                                                        break;
                                                    }
                                                    case 1: {
                                                        let _e868 = (_e779 < _e100);
                                                        if _e868 {
                                                            if _e868 {
                                                            } else {
                                                                phi_4488_ = true;
                                                                break;
                                                            }
                                                            let _e870 = global_6.member[_e779];
                                                            phi_1546_ = _e870;
                                                        } else {
                                                            phi_1546_ = 0u;
                                                        }
                                                        let _e872 = phi_1546_;
                                                        let _e873 = (_e779 + 1u);
                                                        let _e874 = (_e873 < _e100);
                                                        if _e874 {
                                                            if _e874 {
                                                            } else {
                                                                phi_4488_ = true;
                                                                break;
                                                            }
                                                            let _e876 = global_6.member[_e873];
                                                            phi_1561_ = _e876;
                                                        } else {
                                                            phi_1561_ = 0u;
                                                        }
                                                        let _e878 = phi_1561_;
                                                        let _e879 = (_e268 == 1u);
                                                        if _e879 {
                                                            phi_1571_ = ((_e872 >> bitcast<u32>(21i)) | (_e878 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1571_ = (_e878 >> bitcast<u32>(10i));
                                                        }
                                                        let _e888 = phi_1571_;
                                                        let _e896 = (_e267 == 1u);
                                                        if _e896 {
                                                            phi_1592_ = ((_e872 >> bitcast<u32>(21i)) | (_e878 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1592_ = (_e878 >> bitcast<u32>(10i));
                                                        }
                                                        let _e905 = phi_1592_;
                                                        let _e913 = (_e269 == 1u);
                                                        if _e913 {
                                                            phi_1613_ = ((_e872 >> bitcast<u32>(21i)) | (_e878 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1613_ = (_e878 >> bitcast<u32>(10i));
                                                        }
                                                        let _e922 = phi_1613_;
                                                        let _e931 = (_e779 + 2u);
                                                        let _e932 = (_e931 < _e100);
                                                        if _e932 {
                                                            if _e932 {
                                                            } else {
                                                                phi_4488_ = true;
                                                                break;
                                                            }
                                                            let _e934 = global_6.member[_e931];
                                                            phi_1643_ = _e934;
                                                        } else {
                                                            phi_1643_ = 0u;
                                                        }
                                                        let _e936 = phi_1643_;
                                                        let _e937 = (_e779 + 3u);
                                                        let _e938 = (_e937 < _e100);
                                                        if _e938 {
                                                            if _e938 {
                                                            } else {
                                                                phi_4488_ = true;
                                                                break;
                                                            }
                                                            let _e940 = global_6.member[_e937];
                                                            phi_1658_ = _e940;
                                                        } else {
                                                            phi_1658_ = 0u;
                                                        }
                                                        let _e942 = phi_1658_;
                                                        if _e879 {
                                                            phi_1668_ = ((_e936 >> bitcast<u32>(21i)) | (_e942 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1668_ = (_e942 >> bitcast<u32>(10i));
                                                        }
                                                        let _e951 = phi_1668_;
                                                        if _e896 {
                                                            phi_1689_ = ((_e936 >> bitcast<u32>(21i)) | (_e942 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1689_ = (_e942 >> bitcast<u32>(10i));
                                                        }
                                                        let _e967 = phi_1689_;
                                                        if _e913 {
                                                            phi_1710_ = ((_e936 >> bitcast<u32>(21i)) | (_e942 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1710_ = (_e942 >> bitcast<u32>(10i));
                                                        }
                                                        let _e983 = phi_1710_;
                                                        let _e992 = (_e779 + 4u);
                                                        let _e993 = (_e992 < _e100);
                                                        if _e993 {
                                                            if _e993 {
                                                            } else {
                                                                phi_4488_ = true;
                                                                break;
                                                            }
                                                            let _e995 = global_6.member[_e992];
                                                            phi_1740_ = _e995;
                                                        } else {
                                                            phi_1740_ = 0u;
                                                        }
                                                        let _e997 = phi_1740_;
                                                        let _e998 = (_e779 + 5u);
                                                        let _e999 = (_e998 < _e100);
                                                        if _e999 {
                                                            if _e999 {
                                                            } else {
                                                                phi_4488_ = true;
                                                                break;
                                                            }
                                                            let _e1001 = global_6.member[_e998];
                                                            phi_1755_ = _e1001;
                                                        } else {
                                                            phi_1755_ = 0u;
                                                        }
                                                        let _e1003 = phi_1755_;
                                                        if _e879 {
                                                            phi_1765_ = ((_e997 >> bitcast<u32>(21i)) | (_e1003 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1765_ = (_e1003 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1012 = phi_1765_;
                                                        if _e896 {
                                                            phi_1786_ = ((_e997 >> bitcast<u32>(21i)) | (_e1003 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1786_ = (_e1003 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1028 = phi_1786_;
                                                        if _e913 {
                                                            phi_1807_ = ((_e997 >> bitcast<u32>(21i)) | (_e1003 << bitcast<u32>(11i)));
                                                        } else {
                                                            phi_1807_ = (_e1003 >> bitcast<u32>(10i));
                                                        }
                                                        let _e1044 = phi_1807_;
                                                        phi_1998_ = array<array<f32, 3>, 3>(array<f32, 3>((_e695.member.member.x + ((bitcast<f32>((1258291200u | (select(_e888, _e872, _e307) & 2097151u))) - 8388608f) * _e148)), (_e695.member.member.y + ((bitcast<f32>((1258291200u | (select(_e905, _e872, _e374) & 2097151u))) - 8388608f) * _e148)), (_e695.member.member.z + ((bitcast<f32>((1258291200u | (select(_e922, _e872, _e440) & 2097151u))) - 8388608f) * _e148))), array<f32, 3>((_e695.member.member.x + ((bitcast<f32>((1258291200u | (select(_e951, _e936, _e307) & 2097151u))) - 8388608f) * _e148)), (_e695.member.member.y + ((bitcast<f32>((1258291200u | (select(_e967, _e936, _e374) & 2097151u))) - 8388608f) * _e148)), (_e695.member.member.z + ((bitcast<f32>((1258291200u | (select(_e983, _e936, _e440) & 2097151u))) - 8388608f) * _e148))), array<f32, 3>((_e695.member.member.x + ((bitcast<f32>((1258291200u | (select(_e1012, _e997, _e307) & 2097151u))) - 8388608f) * _e148)), (_e695.member.member.y + ((bitcast<f32>((1258291200u | (select(_e1028, _e997, _e374) & 2097151u))) - 8388608f) * _e148)), (_e695.member.member.z + ((bitcast<f32>((1258291200u | (select(_e1044, _e997, _e440) & 2097151u))) - 8388608f) * _e148))));
                                                        break;
                                                    }
                                                    case 2: {
                                                        let _e781 = (_e779 + _e268);
                                                        let _e782 = (_e781 < _e100);
                                                        if _e782 {
                                                            if _e782 {
                                                            } else {
                                                                phi_4488_ = true;
                                                                break;
                                                            }
                                                            let _e784 = global_6.member[_e781];
                                                            phi_1838_ = _e784;
                                                        } else {
                                                            phi_1838_ = 0u;
                                                        }
                                                        let _e786 = phi_1838_;
                                                        let _e790 = (_e779 + _e267);
                                                        let _e791 = (_e790 < _e100);
                                                        if _e791 {
                                                            if _e791 {
                                                            } else {
                                                                phi_4488_ = true;
                                                                break;
                                                            }
                                                            let _e793 = global_6.member[_e790];
                                                            phi_1856_ = _e793;
                                                        } else {
                                                            phi_1856_ = 0u;
                                                        }
                                                        let _e795 = phi_1856_;
                                                        let _e799 = (_e779 + _e269);
                                                        let _e800 = (_e799 < _e100);
                                                        if _e800 {
                                                            if _e800 {
                                                            } else {
                                                                phi_4488_ = true;
                                                                break;
                                                            }
                                                            let _e802 = global_6.member[_e799];
                                                            phi_1874_ = _e802;
                                                        } else {
                                                            phi_1874_ = 0u;
                                                        }
                                                        let _e804 = phi_1874_;
                                                        let _e809 = (_e779 + 3u);
                                                        let _e810 = (_e809 + _e268);
                                                        let _e811 = (_e810 < _e100);
                                                        if _e811 {
                                                            if _e811 {
                                                            } else {
                                                                phi_4488_ = true;
                                                                break;
                                                            }
                                                            let _e813 = global_6.member[_e810];
                                                            phi_1897_ = _e813;
                                                        } else {
                                                            phi_1897_ = 0u;
                                                        }
                                                        let _e815 = phi_1897_;
                                                        let _e819 = (_e809 + _e267);
                                                        let _e820 = (_e819 < _e100);
                                                        if _e820 {
                                                            if _e820 {
                                                            } else {
                                                                phi_4488_ = true;
                                                                break;
                                                            }
                                                            let _e822 = global_6.member[_e819];
                                                            phi_1915_ = _e822;
                                                        } else {
                                                            phi_1915_ = 0u;
                                                        }
                                                        let _e824 = phi_1915_;
                                                        let _e828 = (_e809 + _e269);
                                                        let _e829 = (_e828 < _e100);
                                                        if _e829 {
                                                            if _e829 {
                                                            } else {
                                                                phi_4488_ = true;
                                                                break;
                                                            }
                                                            let _e831 = global_6.member[_e828];
                                                            phi_1933_ = _e831;
                                                        } else {
                                                            phi_1933_ = 0u;
                                                        }
                                                        let _e833 = phi_1933_;
                                                        let _e838 = (_e779 + 6u);
                                                        let _e839 = (_e838 + _e268);
                                                        let _e840 = (_e839 < _e100);
                                                        if _e840 {
                                                            if _e840 {
                                                            } else {
                                                                phi_4488_ = true;
                                                                break;
                                                            }
                                                            let _e842 = global_6.member[_e839];
                                                            phi_1956_ = _e842;
                                                        } else {
                                                            phi_1956_ = 0u;
                                                        }
                                                        let _e844 = phi_1956_;
                                                        let _e848 = (_e838 + _e267);
                                                        let _e849 = (_e848 < _e100);
                                                        if _e849 {
                                                            if _e849 {
                                                            } else {
                                                                phi_4488_ = true;
                                                                break;
                                                            }
                                                            let _e851 = global_6.member[_e848];
                                                            phi_1974_ = _e851;
                                                        } else {
                                                            phi_1974_ = 0u;
                                                        }
                                                        let _e853 = phi_1974_;
                                                        let _e857 = (_e838 + _e269);
                                                        let _e858 = (_e857 < _e100);
                                                        if _e858 {
                                                            if _e858 {
                                                            } else {
                                                                phi_4488_ = true;
                                                                break;
                                                            }
                                                            let _e860 = global_6.member[_e857];
                                                            phi_1992_ = _e860;
                                                        } else {
                                                            phi_1992_ = 0u;
                                                        }
                                                        let _e862 = phi_1992_;
                                                        phi_1998_ = array<array<f32, 3>, 3>(array<f32, 3>((f32(bitcast<i32>(_e786)) * _e148), (f32(bitcast<i32>(_e795)) * _e148), (f32(bitcast<i32>(_e804)) * _e148)), array<f32, 3>((f32(bitcast<i32>(_e815)) * _e148), (f32(bitcast<i32>(_e824)) * _e148), (f32(bitcast<i32>(_e833)) * _e148)), array<f32, 3>((f32(bitcast<i32>(_e844)) * _e148), (f32(bitcast<i32>(_e853)) * _e148), (f32(bitcast<i32>(_e862)) * _e148)));
                                                        break;
                                                    }
                                                    default: {
                                                        phi_1998_ = array<array<f32, 3>, 3>();
                                                        break;
                                                    }
                                                }
                                                let _e1154 = phi_1998_;
                                                let _e1170 = (_e1154[0][2] - _e465);
                                                let _e1173 = (((_e1154[0][0] - _e332) * _e501) - (_e1170 * _e369));
                                                let _e1176 = (((_e1154[0][1] - _e399) * _e501) - (_e1170 * _e435));
                                                let _e1179 = (_e1154[1][2] - _e465);
                                                let _e1182 = (((_e1154[1][0] - _e332) * _e501) - (_e1179 * _e369));
                                                let _e1185 = (((_e1154[1][1] - _e399) * _e501) - (_e1179 * _e435));
                                                let _e1188 = (_e1154[2][2] - _e465);
                                                let _e1191 = (((_e1154[2][0] - _e332) * _e501) - (_e1188 * _e369));
                                                let _e1194 = (((_e1154[2][1] - _e399) * _e501) - (_e1188 * _e435));
                                                let _e1195 = (_e1191 * _e1185);
                                                let _e1196 = (_e1194 * _e1182);
                                                let _e1197 = (_e1173 * _e1194);
                                                let _e1198 = (_e1176 * _e1191);
                                                let _e1199 = (_e1182 * _e1176);
                                                let _e1200 = (_e1185 * _e1173);
                                                let _e1205 = (((_e1195 >= _e1196) && (_e1197 >= _e1198)) && (_e1199 >= _e1200));
                                                let _e1211 = (_e1205 || (((_e1195 <= _e1196) && (_e1197 <= _e1198)) && (_e1199 <= _e1200)));
                                                if _e1211 {
                                                    let _e1213 = select(-1f, 1f, _e1205);
                                                    let _e1215 = ((_e1195 - _e1196) * _e1213);
                                                    let _e1217 = select(0f, _e1215, (_e1215 > 0f));
                                                    let _e1219 = ((_e1197 - _e1198) * _e1213);
                                                    let _e1221 = select(0f, _e1219, (_e1219 > 0f));
                                                    let _e1223 = ((_e1199 - _e1200) * _e1213);
                                                    let _e1225 = select(0f, _e1223, (_e1223 > 0f));
                                                    let _e1227 = ((_e1217 + _e1221) + _e1225);
                                                    let _e1229 = select(_e1154[1][0], _e1154[0][0], (_e1154[0][0] < _e1154[1][0]));
                                                    let _e1233 = select(_e1154[1][0], _e1154[0][0], (_e1154[0][0] > _e1154[1][0]));
                                                    let _e1237 = select(_e1154[1][1], _e1154[0][1], (_e1154[0][1] < _e1154[1][1]));
                                                    let _e1241 = select(_e1154[1][1], _e1154[0][1], (_e1154[0][1] > _e1154[1][1]));
                                                    let _e1245 = select(_e1154[1][2], _e1154[0][2], (_e1154[0][2] < _e1154[1][2]));
                                                    let _e1249 = select(_e1154[1][2], _e1154[0][2], (_e1154[0][2] > _e1154[1][2]));
                                                    let _e1254 = ((select(_e1154[2][0], _e1229, (_e1229 < _e1154[2][0])) - _e370) * _e373);
                                                    let _e1255 = ((select(_e1154[2][0], _e1233, (_e1233 > _e1154[2][0])) - _e371) * _e373);
                                                    let _e1258 = ((select(_e1154[2][1], _e1237, (_e1237 < _e1154[2][1])) - _e436) * _e439);
                                                    let _e1259 = ((select(_e1154[2][1], _e1241, (_e1241 > _e1154[2][1])) - _e437) * _e439);
                                                    let _e1262 = ((select(_e1154[2][2], _e1245, (_e1245 < _e1154[2][2])) - _e502) * _e505);
                                                    let _e1263 = ((select(_e1154[2][2], _e1249, (_e1249 > _e1154[2][2])) - _e503) * _e505);
                                                    let _e1265 = select(_e1263, _e1262, (_e1262 < _e1263));
                                                    let _e1267 = select(_e1263, _e1262, (_e1262 > _e1263));
                                                    let _e1269 = select(_e1255, _e1254, (_e1254 < _e1255));
                                                    let _e1271 = select(_e1259, _e1258, (_e1258 < _e1259));
                                                    let _e1273 = select(_e1271, _e1269, (_e1269 > _e1271));
                                                    let _e1275 = select(_e1265, _e1273, (_e1273 > _e1265));
                                                    let _e1277 = select(_e1255, _e1254, (_e1254 > _e1255));
                                                    let _e1279 = select(_e1259, _e1258, (_e1258 > _e1259));
                                                    let _e1281 = select(_e1279, _e1277, (_e1277 < _e1279));
                                                    let _e1283 = select(_e1267, _e1281, (_e1281 < _e1267));
                                                    let _e1284 = -(_e1265);
                                                    let _e1290 = select(_e608, _e1275, (_e1275 > _e608));
                                                    let _e1294 = select(_e1182, _e1173, (_e1173 < _e1182));
                                                    let _e1299 = select(_e1182, _e1173, (_e1173 > _e1182));
                                                    let _e1306 = select(_e1185, _e1176, (_e1176 < _e1185));
                                                    let _e1311 = select(_e1185, _e1176, (_e1176 > _e1185));
                                                    let _e1320 = (((((_e1211 && (_e1227 >= 0.000000000000000000000000000000000000011754944f)) && ((select(_e1191, _e1294, (_e1294 < _e1191)) <= 0f) && (select(_e1191, _e1299, (_e1299 > _e1191)) >= 0f))) && ((select(_e1194, _e1306, (_e1306 < _e1194)) <= 0f) && (select(_e1194, _e1311, (_e1311 > _e1194)) >= 0f))) && (_e1290 <= (_e1283 + (select(_e1284, _e1267, (_e1267 > _e1284)) * 0.0000019073523f)))) && (_e1290 <= _e707.member));
                                                    if _e1320 {
                                                        let _e1325 = (_e1154[1][0] - _e1154[0][0]);
                                                        let _e1326 = (_e1154[1][1] - _e1154[0][1]);
                                                        let _e1327 = (_e1154[1][2] - _e1154[0][2]);
                                                        let _e1328 = vec3<f32>(_e1325, _e1326, _e1327);
                                                        let _e1329 = (_e1154[2][0] - _e1154[1][0]);
                                                        let _e1330 = (_e1154[2][1] - _e1154[1][1]);
                                                        let _e1331 = (_e1154[2][2] - _e1154[1][2]);
                                                        let _e1332 = vec3<f32>(_e1329, _e1330, _e1331);
                                                        let _e1333 = (_e1154[0][0] - _e1154[2][0]);
                                                        let _e1334 = (_e1154[0][1] - _e1154[2][1]);
                                                        let _e1335 = (_e1154[0][2] - _e1154[2][2]);
                                                        let _e1336 = vec3<f32>(_e1333, _e1334, _e1335);
                                                        let _e1337 = abs(_e1325);
                                                        let _e1338 = abs(_e1326);
                                                        if (_e1337 != _e1337) {
                                                            phi_4129_ = true;
                                                        } else {
                                                            phi_4129_ = (_e1338 >= _e1337);
                                                        }
                                                        let _e1342 = phi_4129_;
                                                        let _e1343 = select(_e1337, _e1338, _e1342);
                                                        let _e1344 = abs(_e1327);
                                                        if (_e1343 != _e1343) {
                                                            phi_4144_ = true;
                                                        } else {
                                                            phi_4144_ = (_e1344 >= _e1343);
                                                        }
                                                        let _e1348 = phi_4144_;
                                                        let _e1349 = select(_e1343, _e1344, _e1348);
                                                        let _e1350 = abs(_e1329);
                                                        let _e1351 = abs(_e1330);
                                                        if (_e1350 != _e1350) {
                                                            phi_4159_ = true;
                                                        } else {
                                                            phi_4159_ = (_e1351 >= _e1350);
                                                        }
                                                        let _e1355 = phi_4159_;
                                                        let _e1356 = select(_e1350, _e1351, _e1355);
                                                        let _e1357 = abs(_e1331);
                                                        if (_e1356 != _e1356) {
                                                            phi_4174_ = true;
                                                        } else {
                                                            phi_4174_ = (_e1357 >= _e1356);
                                                        }
                                                        let _e1361 = phi_4174_;
                                                        let _e1362 = select(_e1356, _e1357, _e1361);
                                                        let _e1363 = abs(_e1333);
                                                        let _e1364 = abs(_e1334);
                                                        if (_e1363 != _e1363) {
                                                            phi_4189_ = true;
                                                        } else {
                                                            phi_4189_ = (_e1364 >= _e1363);
                                                        }
                                                        let _e1368 = phi_4189_;
                                                        let _e1369 = select(_e1363, _e1364, _e1368);
                                                        let _e1370 = abs(_e1335);
                                                        if (_e1369 != _e1369) {
                                                            phi_4204_ = true;
                                                        } else {
                                                            phi_4204_ = (_e1370 >= _e1369);
                                                        }
                                                        let _e1374 = phi_4204_;
                                                        let _e1375 = select(_e1369, _e1370, _e1374);
                                                        let _e1377 = select(_e1362, _e1349, (_e1349 > _e1362));
                                                        let _e1379 = select(_e1375, _e1377, (_e1377 > _e1375));
                                                        if (_e1349 == _e1379) {
                                                            phi_2540_ = _e1185;
                                                            phi_2541_ = _e1182;
                                                            phi_2542_ = _e1176;
                                                            phi_2543_ = _e1173;
                                                            phi_2544_ = vec3<f32>(_e1154[0][0], _e1154[0][1], _e1154[0][2]);
                                                            phi_2545_ = _e1336;
                                                            phi_2546_ = _e1332;
                                                            phi_2547_ = _e1328;
                                                        } else {
                                                            let _e1381 = (_e1362 == _e1379);
                                                            let _e1386 = vec3(_e1381);
                                                            phi_2540_ = select(_e1176, _e1194, _e1381);
                                                            phi_2541_ = select(_e1173, _e1191, _e1381);
                                                            phi_2542_ = select(_e1194, _e1185, _e1381);
                                                            phi_2543_ = select(_e1191, _e1182, _e1381);
                                                            phi_2544_ = select(vec3<f32>(_e1154[2][0], _e1154[2][1], _e1154[2][2]), vec3<f32>(_e1154[1][0], _e1154[1][1], _e1154[1][2]), _e1386);
                                                            phi_2545_ = select(_e1332, _e1328, _e1386);
                                                            phi_2546_ = select(_e1328, _e1336, _e1386);
                                                            phi_2547_ = select(_e1336, _e1332, _e1386);
                                                        }
                                                        let _e1392 = phi_2540_;
                                                        let _e1394 = phi_2541_;
                                                        let _e1396 = phi_2542_;
                                                        let _e1398 = phi_2543_;
                                                        let _e1400 = phi_2544_;
                                                        let _e1402 = phi_2545_;
                                                        let _e1404 = phi_2546_;
                                                        let _e1406 = phi_2547_;
                                                        let _e1413 = ((_e1404.y * _e1402.z) - (_e1402.y * _e1404.z));
                                                        let _e1418 = ((_e1404.z * _e1402.x) - (_e1402.z * _e1404.x));
                                                        let _e1421 = ((_e1404.x * _e1402.y) - (_e1402.x * _e1404.y));
                                                        let _e1424 = ((_e1217 >= _e1221) && (_e1217 >= _e1225));
                                                        let _e1425 = (_e1221 >= _e1225);
                                                        let _e1439 = (((_e1413 * (select(select(_e1154[2][0], _e1154[1][0], _e1425), _e1154[0][0], _e1424) - _e332)) + (_e1418 * (select(select(_e1154[2][1], _e1154[1][1], _e1425), _e1154[0][1], _e1424) - _e399))) + (_e1421 * (select(select(_e1154[2][2], _e1154[1][2], _e1425), _e1154[0][2], _e1424) - _e465)));
                                                        let _e1444 = (((_e1413 * _e369) + (_e1418 * _e435)) + (_e1421 * _e501));
                                                        let _e1445 = (_e1394 - _e1398);
                                                        let _e1446 = (_e1392 - _e1396);
                                                        let _e1449 = ((_e1445 * _e1445) + (_e1446 * _e1446));
                                                        let _e1456 = (-(((_e1398 * _e1445) + (_e1396 * _e1446))) / select(0.000000000000000000000000000000000000011754944f, _e1449, (_e1449 > 0.000000000000000000000000000000000000011754944f)));
                                                        let _e1458 = select(1f, _e1456, (_e1456 < 1f));
                                                        let _e1460 = select(0f, _e1458, (_e1458 > 0f));
                                                        let _e1469 = ((_e1400.x + (_e1406.x * _e1460)) - _e332);
                                                        let _e1472 = ((_e1400.y + (_e1406.y * _e1460)) - _e399);
                                                        let _e1475 = ((_e1400.z + (_e1406.z * _e1460)) - _e465);
                                                        let _e1478 = bitcast<f32>((bitcast<u32>(_e1469) & 2147483647u));
                                                        let _e1481 = bitcast<f32>((bitcast<u32>(_e1472) & 2147483647u));
                                                        let _e1483 = select(_e1481, _e1478, (_e1478 > _e1481));
                                                        let _e1486 = bitcast<f32>((bitcast<u32>(_e1475) & 2147483647u));
                                                        let _e1488 = select(_e1486, _e1483, (_e1483 > _e1486));
                                                        let _e1492 = abs(_e1413);
                                                        let _e1493 = abs(_e1418);
                                                        if (_e1492 != _e1492) {
                                                            phi_4219_ = true;
                                                        } else {
                                                            phi_4219_ = (_e1493 >= _e1492);
                                                        }
                                                        let _e1497 = phi_4219_;
                                                        let _e1498 = select(_e1492, _e1493, _e1497);
                                                        let _e1499 = abs(_e1421);
                                                        if (_e1498 != _e1498) {
                                                            phi_4234_ = true;
                                                        } else {
                                                            phi_4234_ = (_e1499 >= _e1498);
                                                        }
                                                        let _e1503 = phi_4234_;
                                                        let _e1519 = abs(_e1404.x);
                                                        let _e1520 = abs(_e1404.y);
                                                        if (_e1519 != _e1519) {
                                                            phi_4249_ = true;
                                                        } else {
                                                            phi_4249_ = (_e1520 >= _e1519);
                                                        }
                                                        let _e1524 = phi_4249_;
                                                        let _e1525 = select(_e1519, _e1520, _e1524);
                                                        let _e1526 = abs(_e1404.z);
                                                        if (_e1525 != _e1525) {
                                                            phi_4264_ = true;
                                                        } else {
                                                            phi_4264_ = (_e1526 >= _e1525);
                                                        }
                                                        let _e1530 = phi_4264_;
                                                        let _e1533 = abs(_e1402.x);
                                                        let _e1534 = abs(_e1402.y);
                                                        if (_e1533 != _e1533) {
                                                            phi_4279_ = true;
                                                        } else {
                                                            phi_4279_ = (_e1534 >= _e1533);
                                                        }
                                                        let _e1538 = phi_4279_;
                                                        let _e1539 = select(_e1533, _e1534, _e1538);
                                                        let _e1540 = abs(_e1402.z);
                                                        if (_e1539 != _e1539) {
                                                            phi_4294_ = true;
                                                        } else {
                                                            phi_4294_ = (_e1540 >= _e1539);
                                                        }
                                                        let _e1544 = phi_4294_;
                                                        let _e1549 = ((bitcast<f32>((bitcast<u32>(((((_e1413 * _e1469) + (_e1418 * _e1472)) + (_e1421 * _e1475)) - _e1439)) & 2147483647u)) <= ((0.0000009536743f * select(_e1379, _e1488, (_e1488 > _e1379))) * select(_e1498, _e1499, _e1503))) && !((bitcast<f32>((bitcast<u32>(_e1444) & 2147483647u)) <= ((0.0000038146973f * select(_e1525, _e1526, _e1530)) * select(_e1539, _e1540, _e1544)))));
                                                        let _e1550 = (_e1439 / _e1444);
                                                        if (_e1320 && !(_e1549)) {
                                                            let _e1553 = (_e1475 / _e501);
                                                            let _e1561 = (((_e1413 * (_e1469 - (_e369 * _e1553))) + (_e1418 * (_e1472 - (_e435 * _e1553)))) / _e1444);
                                                            phi_2755_ = select(select(_e1553, (_e1553 + _e1561), (bitcast<f32>((bitcast<u32>(_e1561) & 2147483647u)) <= _e1379)), _e1550, _e1549);
                                                        } else {
                                                            phi_2755_ = _e1550;
                                                        }
                                                        let _e1570 = phi_2755_;
                                                        let _e1572 = select(_e1283, _e1570, (_e1570 < _e1283));
                                                        let _e1574 = select(_e1275, _e1572, (_e1572 > _e1275));
                                                        let _e1575 = (1f / _e1227);
                                                        phi_2775_ = type_35(_e1574, (_e1221 * _e1575), (_e1225 * _e1575), ((_e1320 && (_e1574 >= _e608)) && (_e1574 <= _e707.member)));
                                                        phi_2776_ = type_35();
                                                    } else {
                                                        phi_2775_ = type_35();
                                                        phi_2776_ = type_35(0f, 0f, 0f, _e1320);
                                                    }
                                                    let _e1584 = phi_2775_;
                                                    let _e1586 = phi_2776_;
                                                    phi_2779_ = _e1584;
                                                    phi_2780_ = _e1586;
                                                    phi_2781_ = select(true, false, _e1320);
                                                } else {
                                                    phi_2779_ = type_35();
                                                    phi_2780_ = type_35(0f, 0f, 0f, _e1211);
                                                    phi_2781_ = true;
                                                }
                                                let _e1589 = phi_2779_;
                                                let _e1591 = phi_2780_;
                                                let _e1593 = phi_2781_;
                                                if _e1593 {
                                                    phi_2785_ = _e1591;
                                                } else {
                                                    phi_2785_ = _e1589;
                                                }
                                                let _e1595 = phi_2785_;
                                                if _e1595.member_3 {
                                                    phi_2794_ = type_24(_e1595.member, _e1595.member_1, _e1595.member_2, _e767);
                                                } else {
                                                    phi_2794_ = type_24(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                }
                                                let _e1602 = phi_2794_;
                                                if (_e1602.member_3 != 4294967295u) {
                                                    if (_e767 != 4294967295u) {
                                                        phi_2805_ = type_39(-340282350000000000000000000000000000000f, true);
                                                    } else {
                                                        phi_2805_ = _e707;
                                                    }
                                                    let _e1607 = phi_2805_;
                                                    phi_2806_ = _e1607;
                                                } else {
                                                    phi_2806_ = _e707;
                                                }
                                                let _e1609 = phi_2806_;
                                                phi_1235_ = _e1609;
                                            } else {
                                                phi_1235_ = type_39();
                                            }
                                            let _e1611 = phi_1235_;
                                            continue;
                                            continuing {
                                                phi_1234_ = _e1611;
                                                phi_1237_ = _e722;
                                                phi_4488_ = _e650;
                                                break if !(_e728);
                                            }
                                        }
                                        let _e1614 = phi_4488_;
                                        phi_4697_ = _e1614;
                                        if _e1614 {
                                            break;
                                        }
                                        phi_4788_ = _e1614;
                                        let _e2249 = local_11;
                                        phi_2807_ = _e2249;
                                    } else {
                                        phi_4788_ = _e650;
                                        phi_2807_ = _e652;
                                    }
                                    let _e1616 = phi_4788_;
                                    let _e1618 = phi_2807_;
                                    if _e699 {
                                        phi_4072_ = bool();
                                        phi_4073_ = u32();
                                        phi_4074_ = type_46();
                                    } else {
                                        if (_e695.member_1 >= _e97) {
                                            phi_3608_ = type_47(array<vec4<f32>, 3>(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), type_46(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u), type_46(type_28(vec4<f32>(0f, 0f, 0f, 0f), vec4<f32>(0f, 0f, 0f, 0f)), 2147483648u));
                                        } else {
                                            if (_e695.member_1 < _e97) {
                                            } else {
                                                phi_4697_ = true;
                                                break;
                                            }
                                            let _e1622 = ((1u + _e268) % 4u);
                                            if (_e1622 < 4u) {
                                            } else {
                                                phi_4697_ = true;
                                                break;
                                            }
                                            let _e1627 = global_3.member[_e695.member_1][_e1622];
                                            let _e1629 = (_e1627 >> bitcast<u32>(11u));
                                            let _e1631 = ((1u + _e267) % 4u);
                                            if (_e1631 < 4u) {
                                            } else {
                                                phi_4697_ = true;
                                                break;
                                            }
                                            let _e1636 = global_3.member[_e695.member_1][_e1631];
                                            let _e1638 = (_e1636 >> bitcast<u32>(11u));
                                            let _e1640 = ((1u + _e269) % 4u);
                                            if (_e1640 < 4u) {
                                            } else {
                                                phi_4697_ = true;
                                                break;
                                            }
                                            let _e1645 = global_3.member[_e695.member_1][_e1640];
                                            let _e1647 = (_e1645 >> bitcast<u32>(11u));
                                            let _e1670 = (bitcast<f32>((bitcast<u32>((_e695.member.member_1.x - _e695.member.member.x)) & 2139095040u)) * 0.001953125f);
                                            let _e1671 = (bitcast<f32>((bitcast<u32>((_e695.member.member_1.y - _e695.member.member.y)) & 2139095040u)) * 0.001953125f);
                                            let _e1672 = (bitcast<f32>((bitcast<u32>((_e695.member.member_1.z - _e695.member.member.z)) & 2139095040u)) * 0.001953125f);
                                            let _e1674 = select(_e148, _e1670, (_e1670 > _e148));
                                            let _e1676 = select(_e148, _e1671, (_e1671 > _e148));
                                            let _e1678 = select(_e148, _e1672, (_e1672 > _e148));
                                            let _e1709 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1627 & 1023u))) - 8388608f) * _e1674));
                                            let _e1714 = (bitcast<i32>((_e1627 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1717 = bitcast<f32>((_e1709 & bitcast<u32>(_e1714)));
                                            let _e1718 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1636 & 1023u))) - 8388608f) * _e1676));
                                            let _e1723 = (bitcast<i32>((_e1636 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1726 = bitcast<f32>((_e1718 & bitcast<u32>(_e1723)));
                                            let _e1727 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1645 & 1023u))) - 8388608f) * _e1678));
                                            let _e1732 = (bitcast<i32>((_e1645 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1735 = bitcast<f32>((_e1727 & bitcast<u32>(_e1732)));
                                            let _e1739 = bitcast<f32>((_e1709 & bitcast<u32>(~(_e1714))));
                                            let _e1743 = bitcast<f32>((_e1718 & bitcast<u32>(~(_e1723))));
                                            let _e1747 = bitcast<f32>((_e1727 & bitcast<u32>(~(_e1732))));
                                            let _e1748 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1629 & 1023u))) - 8388608f) * _e1674));
                                            let _e1753 = (bitcast<i32>((_e1629 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1756 = bitcast<f32>((_e1748 & bitcast<u32>(_e1753)));
                                            let _e1757 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1638 & 1023u))) - 8388608f) * _e1676));
                                            let _e1762 = (bitcast<i32>((_e1638 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1765 = bitcast<f32>((_e1757 & bitcast<u32>(_e1762)));
                                            let _e1766 = bitcast<u32>(((bitcast<f32>((1258291200u | (_e1647 & 1023u))) - 8388608f) * _e1678));
                                            let _e1771 = (bitcast<i32>((_e1647 << bitcast<u32>(21u))) >> bitcast<u32>(31i));
                                            let _e1774 = bitcast<f32>((_e1766 & bitcast<u32>(_e1771)));
                                            let _e1778 = bitcast<f32>((_e1748 & bitcast<u32>(~(_e1753))));
                                            let _e1782 = bitcast<f32>((_e1757 & bitcast<u32>(~(_e1762))));
                                            let _e1786 = bitcast<f32>((_e1766 & bitcast<u32>(~(_e1771))));
                                            let _e1787 = (_e695.member.member.x + _e1717);
                                            let _e1788 = (_e695.member.member.y + _e1726);
                                            let _e1789 = (_e695.member.member.z + _e1735);
                                            let _e1792 = (_e695.member.member_1.x - _e1756);
                                            let _e1793 = (_e695.member.member_1.y - _e1765);
                                            let _e1794 = (_e695.member.member_1.z - _e1774);
                                            let _e1813 = (_e1792 - _e1787);
                                            let _e1814 = (_e1793 - _e1788);
                                            let _e1815 = (_e1794 - _e1789);
                                            let _e1817 = select(_e1814, _e1813, (_e1813 > _e1814));
                                            let _e1819 = select(_e1815, _e1817, (_e1817 > _e1815));
                                            if (_e1819 < (1024f * _e148)) {
                                                phi_3309_ = 0u;
                                            } else {
                                                phi_3309_ = select(2u, 1u, (_e1819 < (2097152f * _e148)));
                                            }
                                            let _e1826 = phi_3309_;
                                            switch bitcast<i32>(_e1826) {
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
                                            let _e1829 = phi_3315_;
                                            let _e1835 = global_3.member[_e695.member_1][0u];
                                            let _e1839 = global_3.member[_e695.member_1][1u];
                                            let _e1843 = global_3.member[_e695.member_1][2u];
                                            let _e1847 = global_3.member[_e695.member_1][3u];
                                            let _e1859 = (((_e1839 >> bitcast<u32>(22i)) | ((_e1843 >> bitcast<u32>(22i)) << bitcast<u32>(10i))) | ((_e1847 >> bitcast<u32>(22i)) << bitcast<u32>(20i)));
                                            let _e1860 = (_e1835 & 268435455u);
                                            let _e1861 = (_e1859 & 268435455u);
                                            let _e1864 = ((_e1835 >> bitcast<u32>(28u)) & 7u);
                                            let _e1872 = ((_e1835 >> bitcast<u32>(31i)) | (((_e1859 >> bitcast<u32>(28u)) & 3u) << bitcast<u32>(1i)));
                                            let _e1873 = (_e1864 != 0u);
                                            if (_e1864 == 0u) {
                                                phi_3570_ = _e1860;
                                            } else {
                                                if (_e1864 == 7u) {
                                                    phi_3569_ = 2147483648u;
                                                } else {
                                                    phi_3569_ = ((2147483648u | (_e1864 << bitcast<u32>(28u))) | (_e1861 & 268435455u));
                                                }
                                                let _e1882 = phi_3569_;
                                                phi_3570_ = _e1882;
                                            }
                                            let _e1884 = phi_3570_;
                                            if _e1873 {
                                                let _e1885 = (_e1864 != 7u);
                                                if _e1885 {
                                                    phi_3580_ = (_e1861 + (_e1864 * ((3u * _e1829) + 1u)));
                                                } else {
                                                    phi_3580_ = u32();
                                                }
                                                let _e1889 = phi_3580_;
                                                phi_3582_ = _e1889;
                                                phi_3583_ = select(true, false, _e1885);
                                            } else {
                                                phi_3582_ = u32();
                                                phi_3583_ = true;
                                            }
                                            let _e1892 = phi_3582_;
                                            let _e1894 = phi_3583_;
                                            if (_e1872 == 0u) {
                                                phi_3604_ = (_e1860 + select(0u, 1u, !(_e1873)));
                                            } else {
                                                if (_e1872 == 7u) {
                                                    phi_3603_ = 2147483648u;
                                                } else {
                                                    phi_3603_ = ((2147483648u | (_e1872 << bitcast<u32>(28u))) | (select(_e1892, _e1861, _e1894) & 268435455u));
                                                }
                                                let _e1907 = phi_3603_;
                                                phi_3604_ = _e1907;
                                            }
                                            let _e1909 = phi_3604_;
                                            phi_3608_ = type_47(array<vec4<f32>, 3>(vec4<f32>(_e1787, (_e695.member.member.x + _e1739), _e1792, (_e695.member.member_1.x - _e1778)), vec4<f32>(_e1788, (_e695.member.member.y + _e1743), _e1793, (_e695.member.member_1.y - _e1782)), vec4<f32>(_e1789, (_e695.member.member.z + _e1747), _e1794, (_e695.member.member_1.z - _e1786))), type_46(type_28((_e695.member.member + vec4<f32>(_e1717, _e1726, _e1735, 0f)), (_e695.member.member_1 - vec4<f32>(_e1756, _e1765, _e1774, 0f))), _e1884), type_46(type_28((_e695.member.member + vec4<f32>(_e1739, _e1743, _e1747, 0f)), (_e695.member.member_1 - vec4<f32>(_e1778, _e1782, _e1786, 0f))), _e1909));
                                        }
                                        let _e1914 = phi_3608_;
                                        let _e1926 = ((_e1914.member[0].x - _e370) * _e373);
                                        let _e1927 = ((_e1914.member[0].y - _e370) * _e373);
                                        let _e1928 = ((_e1914.member[0].z - _e371) * _e373);
                                        let _e1929 = ((_e1914.member[0].w - _e371) * _e373);
                                        let _e1939 = ((_e1914.member[1].x - _e436) * _e439);
                                        let _e1940 = ((_e1914.member[1].y - _e436) * _e439);
                                        let _e1941 = ((_e1914.member[1].z - _e437) * _e439);
                                        let _e1942 = ((_e1914.member[1].w - _e437) * _e439);
                                        let _e1952 = ((_e1914.member[2].x - _e502) * _e505);
                                        let _e1953 = ((_e1914.member[2].y - _e502) * _e505);
                                        let _e1954 = ((_e1914.member[2].z - _e503) * _e505);
                                        let _e1955 = ((_e1914.member[2].w - _e503) * _e505);
                                        let _e1957 = select(_e1954, _e1952, (_e1952 < _e1954));
                                        let _e1959 = select(_e1955, _e1953, (_e1953 < _e1955));
                                        let _e1961 = select(_e1954, _e1952, (_e1952 > _e1954));
                                        let _e1963 = select(_e1955, _e1953, (_e1953 > _e1955));
                                        let _e1965 = select(_e1928, _e1926, (_e1926 < _e1928));
                                        let _e1967 = select(_e1929, _e1927, (_e1927 < _e1929));
                                        let _e1969 = select(_e1941, _e1939, (_e1939 < _e1941));
                                        let _e1971 = select(_e1942, _e1940, (_e1940 < _e1942));
                                        let _e1973 = select(_e1969, _e1965, (_e1965 > _e1969));
                                        let _e1975 = select(_e1971, _e1967, (_e1967 > _e1971));
                                        let _e1977 = select(_e1957, _e1973, (_e1973 > _e1957));
                                        let _e1979 = select(_e1959, _e1975, (_e1975 > _e1959));
                                        let _e1981 = select(_e1928, _e1926, (_e1926 > _e1928));
                                        let _e1983 = select(_e1929, _e1927, (_e1927 > _e1929));
                                        let _e1985 = select(_e1941, _e1939, (_e1939 > _e1941));
                                        let _e1987 = select(_e1942, _e1940, (_e1940 > _e1942));
                                        let _e1989 = select(_e1985, _e1981, (_e1981 < _e1985));
                                        let _e1991 = select(_e1987, _e1983, (_e1983 < _e1987));
                                        let _e1996 = -(_e1957);
                                        let _e1997 = -(_e1959);
                                        let _e2004 = (select(_e1961, _e1989, (_e1989 < _e1961)) + (select(_e1996, _e1961, (_e1961 > _e1996)) * 0.0000019073523f));
                                        let _e2005 = (select(_e1963, _e1991, (_e1991 < _e1963)) + (select(_e1997, _e1963, (_e1963 > _e1997)) * 0.0000019073523f));
                                        let _e2007 = select(_e608, _e1977, (_e1977 > _e608));
                                        let _e2009 = select(_e608, _e1979, (_e1979 > _e608));
                                        let _e2014 = (_e2007 <= select(_e1618.member, _e2004, (_e2004 < _e1618.member)));
                                        let _e2015 = (_e2009 <= select(_e1618.member, _e2005, (_e2005 < _e1618.member)));
                                        let _e2016 = (_e2007 <= _e2009);
                                        if _e2014 {
                                            if _e2015 {
                                                if _e2016 {
                                                    phi_3970_ = _e1914.member_2;
                                                } else {
                                                    phi_3970_ = _e1914.member_1;
                                                }
                                                let _e2020 = phi_3970_;
                                                let _e2041 = (_e693 % 128u);
                                                let _e2042 = (_e2041 < 128u);
                                                if _e2042 {
                                                } else {
                                                    phi_4697_ = true;
                                                    break;
                                                }
                                                local_8[_e2041] = _e2020.member_1;
                                                if _e2042 {
                                                } else {
                                                    phi_4697_ = true;
                                                    break;
                                                }
                                                local_7[_e2041] = _e2020.member.member.x;
                                                if _e2042 {
                                                } else {
                                                    phi_4697_ = true;
                                                    break;
                                                }
                                                local_6[_e2041] = _e2020.member.member.y;
                                                if _e2042 {
                                                } else {
                                                    phi_4697_ = true;
                                                    break;
                                                }
                                                local_5[_e2041] = _e2020.member.member.z;
                                                if _e2042 {
                                                } else {
                                                    phi_4697_ = true;
                                                    break;
                                                }
                                                local_4[_e2041] = _e2020.member.member_1.x;
                                                if _e2042 {
                                                } else {
                                                    phi_4697_ = true;
                                                    break;
                                                }
                                                local_3[_e2041] = _e2020.member.member_1.y;
                                                if _e2042 {
                                                } else {
                                                    phi_4697_ = true;
                                                    break;
                                                }
                                                local_2[_e2041] = _e2020.member.member_1.z;
                                                if _e2042 {
                                                } else {
                                                    phi_4697_ = true;
                                                    break;
                                                }
                                                local_9[_e2041] = select(_e2007, _e2009, _e2016);
                                                if _e2016 {
                                                    phi_4046_ = _e1914.member_1;
                                                } else {
                                                    phi_4046_ = _e1914.member_2;
                                                }
                                                let _e2055 = phi_4046_;
                                                phi_4047_ = (_e693 + 1u);
                                                phi_4048_ = _e2055;
                                            } else {
                                                phi_4047_ = u32();
                                                phi_4048_ = type_46();
                                            }
                                            let _e2057 = phi_4047_;
                                            let _e2059 = phi_4048_;
                                            phi_4050_ = _e2057;
                                            phi_4051_ = _e2059;
                                            phi_4052_ = select(true, false, _e2015);
                                        } else {
                                            phi_4050_ = u32();
                                            phi_4051_ = type_46();
                                            phi_4052_ = true;
                                        }
                                        let _e2062 = phi_4050_;
                                        let _e2064 = phi_4051_;
                                        let _e2066 = phi_4052_;
                                        if _e2066 {
                                            if _e2014 {
                                                phi_4061_ = _e1914.member_1;
                                            } else {
                                                phi_4061_ = _e1914.member_2;
                                            }
                                            let _e2070 = phi_4061_;
                                            phi_4066_ = select(_e2015, true, _e2014);
                                            phi_4068_ = _e2070;
                                        } else {
                                            phi_4066_ = _e691;
                                            phi_4068_ = _e2064;
                                        }
                                        let _e2073 = phi_4066_;
                                        let _e2075 = phi_4068_;
                                        phi_4072_ = _e2073;
                                        phi_4073_ = select(_e2062, _e693, _e2066);
                                        phi_4074_ = _e2075;
                                    }
                                    let _e2078 = phi_4072_;
                                    let _e2080 = phi_4073_;
                                    let _e2082 = phi_4074_;
                                    if _e699 {
                                        phi_4084_ = select(_e693, 0u, _e1618.member_1);
                                        phi_4085_ = _e695;
                                    } else {
                                        phi_4084_ = _e2080;
                                        phi_4085_ = _e2082;
                                    }
                                    let _e2086 = phi_4084_;
                                    let _e2088 = phi_4085_;
                                    phi_4700_ = _e1616;
                                    phi_4086_ = _e1618;
                                    phi_4087_ = (_e654 - 1u);
                                    phi_4088_ = select(_e2078, false, _e699);
                                    phi_4089_ = _e2086;
                                    phi_4090_ = _e2088;
                                } else {
                                    phi_4700_ = _e650;
                                    phi_4086_ = _e652;
                                    phi_4087_ = _e654;
                                    phi_4088_ = _e691;
                                    phi_4089_ = _e693;
                                    phi_4090_ = _e695;
                                }
                                let _e2091 = phi_4700_;
                                let _e2093 = phi_4086_;
                                let _e2095 = phi_4087_;
                                let _e2097 = phi_4088_;
                                let _e2099 = phi_4089_;
                                let _e2101 = phi_4090_;
                                phi_4699_ = _e2091;
                                phi_4091_ = _e2093;
                                phi_4092_ = _e2095;
                                phi_4093_ = _e2097;
                                phi_4094_ = _e2099;
                                phi_4095_ = _e2101;
                            } else {
                                phi_4699_ = _e650;
                                phi_4091_ = type_39();
                                phi_4092_ = u32();
                                phi_4093_ = bool();
                                phi_4094_ = u32();
                                phi_4095_ = type_46();
                            }
                            let _e2103 = phi_4699_;
                            let _e2105 = phi_4091_;
                            let _e2107 = phi_4092_;
                            let _e2109 = phi_4093_;
                            let _e2111 = phi_4094_;
                            let _e2113 = phi_4095_;
                            phi_4698_ = _e2103;
                            phi_1108_ = _e2105;
                            phi_1111_ = _e2107;
                            phi_1113_ = _e2109;
                            phi_1115_ = _e2111;
                            phi_1117_ = _e2113;
                            phi_4096_ = _e664;
                        } else {
                            phi_4698_ = _e650;
                            phi_1108_ = type_39();
                            phi_1111_ = u32();
                            phi_1113_ = bool();
                            phi_1115_ = u32();
                            phi_1117_ = type_46();
                            phi_4096_ = false;
                        }
                        let _e2115 = phi_4698_;
                        let _e2117 = phi_1108_;
                        let _e2119 = phi_1111_;
                        let _e2121 = phi_1113_;
                        let _e2123 = phi_1115_;
                        let _e2125 = phi_1117_;
                        let _e2127 = phi_4096_;
                        continue;
                        continuing {
                            phi_4494_ = _e2115;
                            phi_1107_ = _e2117;
                            phi_1110_ = _e2119;
                            phi_1112_ = _e2121;
                            phi_1114_ = _e2123;
                            phi_1116_ = _e2125;
                            phi_4697_ = _e2115;
                            break if !(_e2127);
                        }
                    }
                    let _e2130 = phi_4697_;
                    if _e2130 {
                        break;
                    }
                    let _e2132 = local_10;
                    if _e156 {
                    } else {
                        break;
                    }
                    global_5.member[_e154] = select(0u, 1u, _e2132.member_1);
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
