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

struct type_22 {
    member: f32,
    member_1: f32,
    member_2: f32,
    member_3: u32,
}

struct type_23 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_24 {
    member: type_23,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_26 {
    member: array<type_24>,
}

struct type_30 {
    member: type_23,
    member_1: array<f32, 3>,
    member_2: u32,
}

struct type_32 {
    member: array<type_30>,
}

struct type_36 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_40 {
    member: f32,
    member_1: bool,
}

struct type_42 {
    member: array<vec4<u32>, 2>,
}

struct type_45 {
    member: array<i32>,
}

struct type_49 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_51 {
    member: array<type_49>,
}

struct type_54 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_56 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_58 {
    member: array<type_56>,
}

struct type_62 {
    member: type_54,
    member_1: u32,
}

struct type_67 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(8) 
var<storage, read_write> global_2: type_26;
@group(0) @binding(1) 
var<uniform> global_3: type_42;
@group(0) @binding(2) 
var<uniform> global_4: type_42;
@group(0) @binding(5) 
var<storage> global_5: type_4;
@group(0) @binding(6) 
var<storage> global_6: type_45;
@group(0) @binding(9) 
var<storage, read_write> global_7: type_67;
@group(0) @binding(7) 
var<storage> global_8: type_32;
@group(0) @binding(3) 
var<storage> global_9: type_51;
@group(0) @binding(4) 
var<storage> global_10: type_58;

fn function_() {
    var local: array<f32, 128>;
    var local_1: array<f32, 128>;
    var local_2: array<f32, 128>;
    var local_3: array<f32, 128>;
    var local_4: array<f32, 128>;
    var local_5: array<f32, 128>;
    var local_6: array<u32, 128>;
    var local_7: array<f32, 128>;
    var local_8: array<f32, 3>;
    var local_9: array<f32, 3>;
    var phi_288_: u32;
    var phi_332_: i32;
    var phi_472_: type_36;
    var phi_622_: i32;
    var phi_623_: i32;
    var phi_633_: bool;
    var phi_643_: u32;
    var phi_644_: u32;
    var phi_646_: bool;
    var phi_651_: u32;
    var phi_684_: i32;
    var phi_702_: f32;
    var phi_708_: f32;
    var phi_748_: f32;
    var phi_754_: f32;
    var phi_806_: f32;
    var phi_818_: f32;
    var phi_827_: f32;
    var phi_833_: f32;
    var phi_873_: f32;
    var phi_879_: f32;
    var phi_931_: f32;
    var phi_943_: f32;
    var phi_952_: f32;
    var phi_958_: f32;
    var phi_998_: f32;
    var phi_1004_: f32;
    var phi_1056_: f32;
    var phi_1068_: f32;
    var phi_1123_: i32;
    var phi_1145_: u32;
    var phi_1146_: u32;
    var phi_1183_: i32;
    var phi_1205_: u32;
    var phi_1206_: u32;
    var phi_1214_: f32;
    var phi_1215_: f32;
    var phi_4109_: bool;
    var phi_1298_: type_40;
    var phi_1301_: bool;
    var phi_1303_: u32;
    var phi_1305_: u32;
    var phi_1307_: type_62;
    var phi_1318_: bool;
    var phi_1404_: bool;
    var phi_1405_: u32;
    var phi_1406_: type_62;
    var phi_3010_: type_49;
    var phi_3896_: type_62;
    var phi_3973_: type_62;
    var phi_3974_: u32;
    var phi_3975_: type_62;
    var phi_3977_: u32;
    var phi_3978_: type_62;
    var phi_3979_: bool;
    var phi_3986_: type_62;
    var phi_3991_: bool;
    var phi_3993_: type_62;
    var phi_1425_: type_40;
    var phi_1428_: type_8;
    var phi_1429_: type_8;
    var phi_1451_: type_8;
    var phi_1476_: u32;
    var phi_1492_: type_56;
    var phi_1930_: bool;
    var phi_1959_: bool;
    var phi_2354_: f32;
    var phi_2355_: f32;
    var phi_2356_: f32;
    var phi_2357_: f32;
    var phi_2358_: vec3<f32>;
    var phi_2359_: vec3<f32>;
    var phi_2360_: vec3<f32>;
    var phi_2361_: vec3<f32>;
    var phi_2398_: bool;
    var phi_2407_: vec3<f32>;
    var phi_2572_: f32;
    var phi_2574_: f32;
    var phi_2575_: bool;
    var phi_2595_: f32;
    var phi_2596_: f32;
    var phi_2619_: type_22;
    var phi_2621_: type_22;
    var phi_2622_: bool;
    var phi_2626_: type_22;
    var phi_2627_: type_22;
    var phi_2628_: type_22;
    var phi_2629_: bool;
    var phi_2633_: type_22;
    var phi_2634_: bool;
    var phi_2635_: type_22;
    var phi_2636_: bool;
    var phi_2637_: bool;
    var phi_2638_: type_22;
    var phi_2639_: bool;
    var phi_2640_: bool;
    var phi_2648_: type_22;
    var phi_2649_: bool;
    var phi_2653_: type_22;
    var phi_2676_: u32;
    var phi_2690_: i32;
    var phi_2708_: vec3<f32>;
    var phi_2709_: vec3<f32>;
    var phi_2723_: vec3<f32>;
    var phi_2724_: vec3<f32>;
    var phi_2738_: vec3<f32>;
    var phi_2739_: vec3<f32>;
    var phi_2775_: vec3<f32>;
    var phi_2957_: f32;
    var phi_2975_: bool;
    var phi_2976_: bool;
    var phi_2981_: type_40;
    var phi_2982_: type_40;
    var phi_1426_: type_40;
    var phi_4103_: bool;
    var local_10: type_40;
    var phi_4317_: bool;
    var phi_3997_: type_40;
    var phi_3998_: bool;
    var phi_3999_: u32;
    var phi_4000_: type_62;
    var phi_4316_: bool;
    var phi_4001_: type_40;
    var phi_4002_: bool;
    var phi_4003_: u32;
    var phi_4004_: u32;
    var phi_4005_: type_62;
    var phi_4315_: bool;
    var phi_4006_: type_40;
    var phi_4007_: bool;
    var phi_4008_: u32;
    var phi_4009_: u32;
    var phi_4010_: type_62;
    var phi_4314_: bool;
    var phi_1299_: type_40;
    var phi_1302_: bool;
    var phi_1304_: u32;
    var phi_1306_: u32;
    var phi_1308_: type_62;
    var phi_4011_: bool;
    var phi_4313_: bool;
    var local_11: type_40;
    var local_12: type_40;

    switch bitcast<i32>(0u) {
        default: {
            let _e90 = global;
            let _e93 = arrayLength((&global_9.member));
            let _e108 = arrayLength((&global_7.member));
            let _e112 = global_4.member[0u][0u];
            let _e116 = global_4.member[0u][1u];
            let _e120 = global_4.member[0u][2u];
            let _e124 = global_4.member[1u][0u];
            let _e128 = global_4.member[1u][1u];
            let _e132 = global_4.member[1u][2u];
            let _e136 = global_4.member[1u][3u];
            let _e140 = (_e90.x + (_e90.y * 2097152u));
            let _e147 = (_e140 < arrayLength((&global_8.member)));
            if _e147 {
                if _e147 {
                } else {
                    break;
                }
                let _e151 = global_8.member[_e140].member_2;
                phi_288_ = _e151;
            } else {
                phi_288_ = 4294967295u;
            }
            let _e153 = phi_288_;
            let _e156 = global_1.member[0u];
            let _e160 = global_3.member[0u][0u];
            let _e164 = global_3.member[0u][1u];
            let _e168 = global_3.member[0u][2u];
            let _e172 = global_3.member[0u][3u];
            let _e176 = global_3.member[1u][0u];
            let _e180 = global_3.member[1u][1u];
            let _e184 = global_3.member[1u][2u];
            let _e188 = global_3.member[1u][3u];
            let _e189 = bitcast<f32>(_e160);
            let _e190 = bitcast<f32>(_e164);
            let _e191 = bitcast<f32>(_e168);
            let _e193 = bitcast<f32>(_e176);
            let _e194 = array<u32, 3>(_e180, _e184, _e188);
            let _e196 = bitcast<i32>(_e156);
            if (_e196 < -126i) {
                phi_332_ = -126i;
            } else {
                phi_332_ = select(_e196, 127i, (_e196 > 127i));
            }
            let _e201 = phi_332_;
            let _e206 = bitcast<f32>((bitcast<u32>((_e201 + 127i)) << bitcast<u32>(23i)));
            let _e212 = bitcast<f32>((bitcast<u32>(((_e196 - _e201) + 127i)) << bitcast<u32>(23i)));
            if (_e172 == 0u) {
                phi_472_ = type_36(array<f32, 3>(_e189, _e190, _e191), _e172, _e193, _e194);
            } else {
                let _e214 = bitcast<u32>(_e189);
                let _e216 = ((_e214 & 2139095040u) != 0u);
                let _e231 = bitcast<u32>(_e190);
                let _e233 = ((_e231 & 2139095040u) != 0u);
                let _e248 = bitcast<u32>(_e191);
                let _e250 = ((_e248 & 2139095040u) != 0u);
                let _e266 = bitcast<u32>(_e193);
                let _e268 = ((_e266 & 2139095040u) != 0u);
                phi_472_ = type_36(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e214 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e214 & 2147483648u))), _e189, _e216) * _e206) * select(0.00000011920929f, 1f, _e216)) * _e212), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e231 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e231 & 2147483648u))), _e190, _e233) * _e206) * select(0.00000011920929f, 1f, _e233)) * _e212), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e248 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e248 & 2147483648u))), _e191, _e250) * _e206) * select(0.00000011920929f, 1f, _e250)) * _e212)), _e172, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e266 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e266 & 2147483648u))), _e193, _e268) * _e206) * select(0.00000011920929f, 1f, _e268)) * _e212), _e194);
            }
            let _e285 = phi_472_;
            if _e147 {
                let _e286 = (_e140 < arrayLength((&global_2.member)));
                if _e286 {
                    if _e147 {
                    } else {
                        break;
                    }
                    let _e291 = global_8.member[_e140].member.member_1;
                    let _e296 = global_8.member[_e140].member.member_3;
                    if (_e291 <= _e296) {
                        let _e298 = (1u < _e108);
                        if _e298 {
                            if (0u < _e108) {
                            } else {
                                break;
                            }
                            let _e302 = atomicAdd((&global_7.member[0u]), 1u);
                            if ((_e302 + 1u) < _e302) {
                                if _e298 {
                                } else {
                                    break;
                                }
                                let _e307 = atomicAdd((&global_7.member[1u]), 1u);
                            }
                        }
                        if _e147 {
                        } else {
                            break;
                        }
                        let _e317 = global_8.member[_e140].member.member_2[0u];
                        let _e319 = (bitcast<u32>(_e317) & 2147483647u);
                        let _e325 = global_8.member[_e140].member.member_2[1u];
                        let _e327 = (bitcast<u32>(_e325) & 2147483647u);
                        let _e333 = global_8.member[_e140].member.member_2[2u];
                        let _e335 = (bitcast<u32>(_e333) & 2147483647u);
                        let _e341 = global_8.member[_e140].member.member[0u];
                        let _e343 = (bitcast<u32>(_e341) & 2147483647u);
                        let _e349 = global_8.member[_e140].member.member[1u];
                        let _e351 = (bitcast<u32>(_e349) & 2147483647u);
                        let _e357 = global_8.member[_e140].member.member[2u];
                        let _e359 = (bitcast<u32>(_e357) & 2147483647u);
                        let _e361 = select(_e327, _e319, (_e327 < _e319));
                        let _e363 = select(_e335, _e361, (_e335 < _e361));
                        let _e365 = select(_e343, _e363, (_e343 < _e363));
                        let _e367 = select(_e351, _e365, (_e351 < _e365));
                        let _e369 = select(_e359, _e367, (_e359 < _e367));
                        let _e370 = bitcast<u32>(_e291);
                        let _e371 = (_e370 & 2147483647u);
                        let _e375 = bitcast<u32>(_e296);
                        let _e376 = (_e375 & 2147483647u);
                        let _e380 = (((select(_e371, _e369, (_e371 < _e369)) < 2139095040u) && (_e376 <= 2139095040u)) && (_e363 > 0u));
                        if _e380 {
                            let _e383 = (bitcast<u32>(bitcast<f32>(_e363)) & 2147483647u);
                            if (_e383 >= 8388608u) {
                                phi_622_ = (bitcast<i32>((_e383 >> bitcast<u32>(23i))) - 127i);
                            } else {
                                phi_622_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e383)), 32u, (_e383 == 0u))));
                            }
                            let _e397 = phi_622_;
                            phi_623_ = _e397;
                        } else {
                            phi_623_ = 0i;
                        }
                        let _e399 = phi_623_;
                        let _e400 = (_e319 == _e363);
                        if _e400 {
                            phi_633_ = true;
                        } else {
                            phi_633_ = (_e327 == _e363);
                        }
                        let _e403 = phi_633_;
                        let _e404 = select(1u, 0u, _e400);
                        if _e403 {
                            let _e405 = (_e404 + 1u);
                            phi_643_ = _e405;
                            phi_644_ = _e405;
                            phi_646_ = select(true, false, (_e405 == 2u));
                        } else {
                            phi_643_ = u32();
                            phi_644_ = 0u;
                            phi_646_ = true;
                        }
                        let _e409 = phi_643_;
                        let _e411 = phi_644_;
                        let _e413 = phi_646_;
                        if _e413 {
                            phi_651_ = (_e411 + 1u);
                        } else {
                            phi_651_ = 0u;
                        }
                        let _e417 = phi_651_;
                        let _e418 = select(_e409, _e411, _e413);
                        let _e419 = select(_e404, select(2u, _e404, _e403), _e413);
                        let _e420 = -(_e399);
                        if (_e420 < -126i) {
                            phi_684_ = -126i;
                        } else {
                            phi_684_ = select(_e420, 127i, (_e420 > 127i));
                        }
                        let _e425 = phi_684_;
                        let _e430 = bitcast<f32>((bitcast<u32>((_e425 + 127i)) << bitcast<u32>(23i)));
                        let _e436 = bitcast<f32>((bitcast<u32>(((_e420 - _e425) + 127i)) << bitcast<u32>(23i)));
                        let _e441 = global_8.member[_e140].member.member;
                        let _e442 = (_e418 == 0u);
                        if _e442 {
                            phi_702_ = _e441[0];
                        } else {
                            phi_702_ = _e441[1];
                        }
                        let _e446 = phi_702_;
                        let _e447 = (_e418 == 2u);
                        if _e447 {
                            phi_708_ = _e441[2];
                        } else {
                            phi_708_ = _e446;
                        }
                        let _e450 = phi_708_;
                        let _e451 = bitcast<u32>(_e450);
                        let _e453 = ((_e451 & 2139095040u) != 0u);
                        let _e465 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e451 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e451 & 2147483648u))), _e450, _e453) * select(0.00000011920929f, 1f, _e453));
                        let _e466 = global_8.member[_e140].member.member_2;
                        if _e442 {
                            phi_748_ = _e466[0];
                        } else {
                            phi_748_ = _e466[1];
                        }
                        let _e470 = phi_748_;
                        if _e447 {
                            phi_754_ = _e466[2];
                        } else {
                            phi_754_ = _e470;
                        }
                        let _e473 = phi_754_;
                        let _e474 = bitcast<u32>(_e473);
                        let _e476 = ((_e474 & 2139095040u) != 0u);
                        let _e490 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e474 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e474 & 2147483648u))), _e473, _e476) * _e430) * select(0.00000011920929f, 1f, _e476)) * _e436);
                        let _e494 = (bitcast<f32>((bitcast<u32>(_e490) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e494 {
                            let _e498 = (bitcast<f32>((bitcast<u32>(_e465) & 2147483647u)) * 0.00000011920929f);
                            phi_806_ = select(0.00000000000011368684f, _e498, (_e498 > 0.00000000000011368684f));
                        } else {
                            phi_806_ = 0f;
                        }
                        let _e502 = phi_806_;
                        let _e503 = (_e465 + _e502);
                        let _e504 = (_e465 - _e502);
                        let _e505 = select(_e490, 0f, _e494);
                        if _e494 {
                            phi_818_ = 38685626000000000000000000f;
                        } else {
                            phi_818_ = (1f / _e490);
                        }
                        let _e508 = phi_818_;
                        let _e509 = (_e417 == 0u);
                        if _e509 {
                            phi_827_ = _e441[0];
                        } else {
                            phi_827_ = _e441[1];
                        }
                        let _e513 = phi_827_;
                        let _e514 = (_e417 == 2u);
                        if _e514 {
                            phi_833_ = _e441[2];
                        } else {
                            phi_833_ = _e513;
                        }
                        let _e517 = phi_833_;
                        let _e518 = bitcast<u32>(_e517);
                        let _e520 = ((_e518 & 2139095040u) != 0u);
                        let _e532 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e518 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e518 & 2147483648u))), _e517, _e520) * select(0.00000011920929f, 1f, _e520));
                        if _e509 {
                            phi_873_ = _e466[0];
                        } else {
                            phi_873_ = _e466[1];
                        }
                        let _e536 = phi_873_;
                        if _e514 {
                            phi_879_ = _e466[2];
                        } else {
                            phi_879_ = _e536;
                        }
                        let _e539 = phi_879_;
                        let _e540 = bitcast<u32>(_e539);
                        let _e542 = ((_e540 & 2139095040u) != 0u);
                        let _e556 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e540 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e540 & 2147483648u))), _e539, _e542) * _e430) * select(0.00000011920929f, 1f, _e542)) * _e436);
                        let _e560 = (bitcast<f32>((bitcast<u32>(_e556) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e560 {
                            let _e564 = (bitcast<f32>((bitcast<u32>(_e532) & 2147483647u)) * 0.00000011920929f);
                            phi_931_ = select(0.00000000000011368684f, _e564, (_e564 > 0.00000000000011368684f));
                        } else {
                            phi_931_ = 0f;
                        }
                        let _e568 = phi_931_;
                        let _e569 = (_e532 + _e568);
                        let _e570 = (_e532 - _e568);
                        let _e571 = select(_e556, 0f, _e560);
                        if _e560 {
                            phi_943_ = 38685626000000000000000000f;
                        } else {
                            phi_943_ = (1f / _e556);
                        }
                        let _e574 = phi_943_;
                        let _e575 = (_e419 == 0u);
                        if _e575 {
                            phi_952_ = _e441[0];
                        } else {
                            phi_952_ = _e441[1];
                        }
                        let _e579 = phi_952_;
                        let _e580 = (_e419 == 2u);
                        if _e580 {
                            phi_958_ = _e441[2];
                        } else {
                            phi_958_ = _e579;
                        }
                        let _e583 = phi_958_;
                        let _e584 = bitcast<u32>(_e583);
                        let _e586 = ((_e584 & 2139095040u) != 0u);
                        let _e598 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e584 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e584 & 2147483648u))), _e583, _e586) * select(0.00000011920929f, 1f, _e586));
                        if _e575 {
                            phi_998_ = _e466[0];
                        } else {
                            phi_998_ = _e466[1];
                        }
                        let _e602 = phi_998_;
                        if _e580 {
                            phi_1004_ = _e466[2];
                        } else {
                            phi_1004_ = _e602;
                        }
                        let _e605 = phi_1004_;
                        let _e606 = bitcast<u32>(_e605);
                        let _e608 = ((_e606 & 2139095040u) != 0u);
                        let _e622 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e606 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e606 & 2147483648u))), _e605, _e608) * _e430) * select(0.00000011920929f, 1f, _e608)) * _e436);
                        let _e626 = (bitcast<f32>((bitcast<u32>(_e622) & 2147483647u)) < 0.00000000000000000086736174f);
                        if _e626 {
                            let _e630 = (bitcast<f32>((bitcast<u32>(_e598) & 2147483647u)) * 0.00000011920929f);
                            phi_1056_ = select(0.00000000000011368684f, _e630, (_e630 > 0.00000000000011368684f));
                        } else {
                            phi_1056_ = 0f;
                        }
                        let _e634 = phi_1056_;
                        let _e635 = (_e598 + _e634);
                        let _e636 = (_e598 - _e634);
                        let _e637 = select(_e622, 0f, _e626);
                        if _e626 {
                            phi_1068_ = 38685626000000000000000000f;
                        } else {
                            phi_1068_ = (1f / _e622);
                        }
                        let _e640 = phi_1068_;
                        let _e643 = bitcast<f32>((bitcast<u32>(_e465) & 2147483647u));
                        let _e646 = bitcast<f32>((bitcast<u32>(_e532) & 2147483647u));
                        let _e648 = select(_e646, _e643, (_e643 > _e646));
                        let _e651 = bitcast<f32>((bitcast<u32>(_e598) & 2147483647u));
                        if (_e380 && (select(_e651, _e648, (_e648 > _e651)) <= 1099511600000f)) {
                            let _e663 = ((_e371 & 8388607u) | (select(0u, 1u, ((_e371 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e666 = bitcast<i32>((_e371 >> bitcast<u32>(23i)));
                            let _e670 = (_e663 == 0u);
                            let _e673 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e663)), 32u, _e670)) - 8i);
                            if (_e666 == 255i) {
                                phi_1123_ = 255i;
                            } else {
                                phi_1123_ = (((_e666 + select(0i, 1i, (_e666 == 0i))) - _e673) + _e399);
                            }
                            let _e681 = phi_1123_;
                            let _e691 = (_e681 <= 0i);
                            if _e691 {
                                phi_1146_ = u32();
                            } else {
                                if _e670 {
                                    phi_1145_ = u32();
                                } else {
                                    phi_1145_ = select(((bitcast<u32>(_e681) << bitcast<u32>(23i)) | ((_e663 << bitcast<u32>(((_e673 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e681 >= 255i));
                                }
                                let _e695 = phi_1145_;
                                phi_1146_ = _e695;
                            }
                            let _e697 = phi_1146_;
                            let _e709 = ((_e376 & 8388607u) | (select(0u, 1u, ((_e376 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                            let _e712 = bitcast<i32>((_e376 >> bitcast<u32>(23i)));
                            let _e716 = (_e709 == 0u);
                            let _e719 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e709)), 32u, _e716)) - 8i);
                            if (_e712 == 255i) {
                                phi_1183_ = 255i;
                            } else {
                                phi_1183_ = (((_e712 + select(0i, 1i, (_e712 == 0i))) - _e719) + _e399);
                            }
                            let _e727 = phi_1183_;
                            let _e737 = (_e727 <= 0i);
                            if _e737 {
                                phi_1206_ = u32();
                            } else {
                                if _e716 {
                                    phi_1205_ = u32();
                                } else {
                                    phi_1205_ = select(((bitcast<u32>(_e727) << bitcast<u32>(23i)) | ((_e709 << bitcast<u32>(((_e719 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e727 >= 255i));
                                }
                                let _e741 = phi_1205_;
                                phi_1206_ = _e741;
                            }
                            let _e743 = phi_1206_;
                            phi_1214_ = bitcast<f32>(((_e375 & 2147483648u) | select(_e743, 0u, select(_e716, true, _e737))));
                            phi_1215_ = bitcast<f32>(((_e370 & 2147483648u) | select(_e697, 0u, select(_e670, true, _e691))));
                        } else {
                            phi_1214_ = 0f;
                            phi_1215_ = 1f;
                        }
                        let _e749 = phi_1214_;
                        let _e751 = phi_1215_;
                        local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                        local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                        local_9 = array<f32, 3>(bitcast<f32>(_e112), bitcast<f32>(_e116), bitcast<f32>(_e120));
                        let _e756 = (_e418 % 3u);
                        let _e757 = (_e756 < 3u);
                        if _e757 {
                        } else {
                            break;
                        }
                        let _e759 = local_9[_e756];
                        let _e760 = (_e417 % 3u);
                        let _e761 = (_e760 < 3u);
                        if _e761 {
                        } else {
                            break;
                        }
                        let _e763 = local_9[_e760];
                        let _e764 = (_e419 % 3u);
                        let _e765 = (_e764 < 3u);
                        if _e765 {
                        } else {
                            break;
                        }
                        let _e767 = local_9[_e764];
                        local_8 = array<f32, 3>(bitcast<f32>(_e124), bitcast<f32>(_e128), bitcast<f32>(_e132));
                        if _e757 {
                        } else {
                            break;
                        }
                        let _e771 = local_8[_e756];
                        if _e761 {
                        } else {
                            break;
                        }
                        let _e773 = local_8[_e760];
                        if _e765 {
                        } else {
                            break;
                        }
                        let _e775 = local_8[_e764];
                        phi_4109_ = false;
                        phi_1298_ = type_40(_e749, false);
                        phi_1301_ = (_e751 <= _e749);
                        phi_1303_ = ((3u * _e93) + 1u);
                        phi_1305_ = 0u;
                        phi_1307_ = type_62(type_54(array<f32, 3>(_e759, _e763, _e767), array<f32, 3>(_e771, _e773, _e775)), select(0u, 2147483648u, (_e93 == 0u)));
                        loop {
                            let _e783 = phi_4109_;
                            let _e785 = phi_1298_;
                            let _e787 = phi_1301_;
                            let _e789 = phi_1303_;
                            let _e791 = phi_1305_;
                            let _e793 = phi_1307_;
                            local_11 = _e785;
                            if _e787 {
                                phi_1318_ = true;
                            } else {
                                phi_1318_ = (_e791 > 0u);
                            }
                            let _e796 = phi_1318_;
                            if _e796 {
                                let _e797 = (_e789 > 0u);
                                if _e797 {
                                    if _e787 {
                                        phi_1404_ = _e787;
                                        phi_1405_ = _e791;
                                        phi_1406_ = _e793;
                                    } else {
                                        let _e798 = (_e791 - 1u);
                                        let _e799 = (_e798 % 128u);
                                        let _e800 = (_e799 < 128u);
                                        if _e800 {
                                        } else {
                                            phi_4313_ = true;
                                            break;
                                        }
                                        let _e802 = local_6[_e799];
                                        if _e800 {
                                        } else {
                                            phi_4313_ = true;
                                            break;
                                        }
                                        let _e804 = local_5[_e799];
                                        if _e800 {
                                        } else {
                                            phi_4313_ = true;
                                            break;
                                        }
                                        let _e806 = local_4[_e799];
                                        if _e800 {
                                        } else {
                                            phi_4313_ = true;
                                            break;
                                        }
                                        let _e808 = local_3[_e799];
                                        if _e800 {
                                        } else {
                                            phi_4313_ = true;
                                            break;
                                        }
                                        let _e811 = local_2[_e799];
                                        if _e800 {
                                        } else {
                                            phi_4313_ = true;
                                            break;
                                        }
                                        let _e813 = local_1[_e799];
                                        if _e800 {
                                        } else {
                                            phi_4313_ = true;
                                            break;
                                        }
                                        let _e815 = local[_e799];
                                        if _e800 {
                                        } else {
                                            phi_4313_ = true;
                                            break;
                                        }
                                        let _e820 = local_7[_e799];
                                        phi_1404_ = (_e820 <= _e785.member);
                                        phi_1405_ = _e798;
                                        phi_1406_ = type_62(type_54(array<f32, 3>(_e804, _e806, _e808), array<f32, 3>(_e811, _e813, _e815)), _e802);
                                    }
                                    let _e824 = phi_1404_;
                                    let _e826 = phi_1405_;
                                    let _e828 = phi_1406_;
                                    if _e824 {
                                        if ((_e828.member_1 & 2147483648u) != 0u) {
                                            phi_1425_ = _e785;
                                            phi_1428_ = type_8(0u, ((_e828.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e1205 = phi_1425_;
                                                let _e1207 = phi_1428_;
                                                local_10 = _e1205;
                                                local_12 = _e1205;
                                                if (_e1207.member < _e1207.member_1) {
                                                    phi_1429_ = type_8((_e1207.member + 1u), _e1207.member_1);
                                                    phi_1451_ = type_8(1u, _e1207.member);
                                                } else {
                                                    phi_1429_ = _e1207;
                                                    phi_1451_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e1220 = phi_1429_;
                                                let _e1222 = phi_1451_;
                                                let _e1226 = (bitcast<i32>(_e1222.member) != 0i);
                                                if _e1226 {
                                                    let _e1227 = ((_e828.member_1 & 268435455u) + _e1222.member_1);
                                                    let _e1228 = (_e1227 < arrayLength((&global_10.member)));
                                                    if _e1228 {
                                                        if _e1228 {
                                                        } else {
                                                            phi_4103_ = true;
                                                            break;
                                                        }
                                                        let _e1231 = global_10.member[_e1227].member_1;
                                                        phi_1476_ = _e1231;
                                                    } else {
                                                        phi_1476_ = 4294967295u;
                                                    }
                                                    let _e1233 = phi_1476_;
                                                    if _e1228 {
                                                        if _e1228 {
                                                        } else {
                                                            phi_4103_ = true;
                                                            break;
                                                        }
                                                        let _e1235 = global_10.member[_e1227];
                                                        phi_1492_ = _e1235;
                                                    } else {
                                                        phi_1492_ = type_56(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                    }
                                                    let _e1237 = phi_1492_;
                                                    let _e1249 = ((10u * _e418) & 31u);
                                                    let _e1252 = ((_e1237.member[0] >> bitcast<u32>(_e1249)) & 1023u);
                                                    let _e1260 = bitcast<f32>((bitcast<u32>(((_e828.member.member_1[0] - _e828.member.member[0]) * 0.0009775171f)) ^ _e136));
                                                    let _e1265 = (_e828.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1252)) - 8388608f) * _e1260)) ^ _e136)));
                                                    let _e1269 = select(select(_e828.member.member_1[0], _e1265, (_e1265 < _e828.member.member_1[0])), _e828.member.member_1[0], (_e1252 == 1023u));
                                                    let _e1271 = ((10u * _e417) & 31u);
                                                    let _e1274 = ((_e1237.member[0] >> bitcast<u32>(_e1271)) & 1023u);
                                                    let _e1282 = bitcast<f32>((bitcast<u32>(((_e828.member.member_1[1] - _e828.member.member[1]) * 0.0009775171f)) ^ _e136));
                                                    let _e1287 = (_e828.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1274)) - 8388608f) * _e1282)) ^ _e136)));
                                                    let _e1291 = select(select(_e828.member.member_1[1], _e1287, (_e1287 < _e828.member.member_1[1])), _e828.member.member_1[1], (_e1274 == 1023u));
                                                    let _e1293 = ((10u * _e419) & 31u);
                                                    let _e1296 = ((_e1237.member[0] >> bitcast<u32>(_e1293)) & 1023u);
                                                    let _e1304 = bitcast<f32>((bitcast<u32>(((_e828.member.member_1[2] - _e828.member.member[2]) * 0.0009775171f)) ^ _e136));
                                                    let _e1309 = (_e828.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1296)) - 8388608f) * _e1304)) ^ _e136)));
                                                    let _e1313 = select(select(_e828.member.member_1[2], _e1309, (_e1309 < _e828.member.member_1[2])), _e828.member.member_1[2], (_e1296 == 1023u));
                                                    let _e1317 = ((_e1237.member[1] >> bitcast<u32>(_e1249)) & 1023u);
                                                    let _e1325 = (_e828.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1317)) - 8388608f) * _e1260)) ^ _e136)));
                                                    let _e1329 = select(select(_e828.member.member_1[0], _e1325, (_e1325 < _e828.member.member_1[0])), _e828.member.member_1[0], (_e1317 == 1023u));
                                                    let _e1332 = ((_e1237.member[1] >> bitcast<u32>(_e1271)) & 1023u);
                                                    let _e1340 = (_e828.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1332)) - 8388608f) * _e1282)) ^ _e136)));
                                                    let _e1344 = select(select(_e828.member.member_1[1], _e1340, (_e1340 < _e828.member.member_1[1])), _e828.member.member_1[1], (_e1332 == 1023u));
                                                    let _e1347 = ((_e1237.member[1] >> bitcast<u32>(_e1293)) & 1023u);
                                                    let _e1355 = (_e828.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1347)) - 8388608f) * _e1304)) ^ _e136)));
                                                    let _e1359 = select(select(_e828.member.member_1[2], _e1355, (_e1355 < _e828.member.member_1[2])), _e828.member.member_1[2], (_e1347 == 1023u));
                                                    let _e1363 = ((_e1237.member[2] >> bitcast<u32>(_e1249)) & 1023u);
                                                    let _e1371 = (_e828.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1363)) - 8388608f) * _e1260)) ^ _e136)));
                                                    let _e1375 = select(select(_e828.member.member_1[0], _e1371, (_e1371 < _e828.member.member_1[0])), _e828.member.member_1[0], (_e1363 == 1023u));
                                                    let _e1378 = ((_e1237.member[2] >> bitcast<u32>(_e1271)) & 1023u);
                                                    let _e1386 = (_e828.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1378)) - 8388608f) * _e1282)) ^ _e136)));
                                                    let _e1390 = select(select(_e828.member.member_1[1], _e1386, (_e1386 < _e828.member.member_1[1])), _e828.member.member_1[1], (_e1378 == 1023u));
                                                    let _e1393 = ((_e1237.member[2] >> bitcast<u32>(_e1293)) & 1023u);
                                                    let _e1401 = (_e828.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1393)) - 8388608f) * _e1304)) ^ _e136)));
                                                    let _e1405 = select(select(_e828.member.member_1[2], _e1401, (_e1401 < _e828.member.member_1[2])), _e828.member.member_1[2], (_e1393 == 1023u));
                                                    let _e1409 = (_e1313 - _e598);
                                                    let _e1412 = (((_e1269 - _e465) * _e637) - (_e1409 * _e505));
                                                    let _e1415 = (((_e1291 - _e532) * _e637) - (_e1409 * _e571));
                                                    let _e1418 = (_e1359 - _e598);
                                                    let _e1421 = (((_e1329 - _e465) * _e637) - (_e1418 * _e505));
                                                    let _e1424 = (((_e1344 - _e532) * _e637) - (_e1418 * _e571));
                                                    let _e1427 = (_e1405 - _e598);
                                                    let _e1430 = (((_e1375 - _e465) * _e637) - (_e1427 * _e505));
                                                    let _e1433 = (((_e1390 - _e532) * _e637) - (_e1427 * _e571));
                                                    let _e1434 = (_e1430 * _e1424);
                                                    let _e1435 = (_e1433 * _e1421);
                                                    let _e1436 = (_e1412 * _e1433);
                                                    let _e1437 = (_e1415 * _e1430);
                                                    let _e1438 = (_e1421 * _e1415);
                                                    let _e1439 = (_e1424 * _e1412);
                                                    let _e1444 = (((_e1434 >= _e1435) && (_e1436 >= _e1437)) && (_e1438 >= _e1439));
                                                    if (_e1444 || (((_e1434 <= _e1435) && (_e1436 <= _e1437)) && (_e1438 <= _e1439))) {
                                                        let _e1451 = select(-1f, 1f, _e1444);
                                                        let _e1453 = ((_e1434 - _e1435) * _e1451);
                                                        let _e1455 = select(0f, _e1453, (_e1453 > 0f));
                                                        let _e1457 = ((_e1436 - _e1437) * _e1451);
                                                        let _e1459 = select(0f, _e1457, (_e1457 > 0f));
                                                        let _e1461 = ((_e1438 - _e1439) * _e1451);
                                                        let _e1463 = select(0f, _e1461, (_e1461 > 0f));
                                                        let _e1465 = ((_e1455 + _e1459) + _e1463);
                                                        if (_e1465 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2638_ = type_22();
                                                            phi_2639_ = true;
                                                            phi_2640_ = false;
                                                        } else {
                                                            let _e1468 = select(_e1421, _e1412, (_e1412 < _e1421));
                                                            if (select(_e1430, _e1468, (_e1468 < _e1430)) > 0f) {
                                                                phi_1930_ = true;
                                                            } else {
                                                                let _e1473 = select(_e1421, _e1412, (_e1412 > _e1421));
                                                                phi_1930_ = (select(_e1430, _e1473, (_e1473 > _e1430)) < 0f);
                                                            }
                                                            let _e1478 = phi_1930_;
                                                            if _e1478 {
                                                                phi_2635_ = type_22();
                                                                phi_2636_ = true;
                                                                phi_2637_ = false;
                                                            } else {
                                                                let _e1480 = select(_e1424, _e1415, (_e1415 < _e1424));
                                                                if (select(_e1433, _e1480, (_e1480 < _e1433)) > 0f) {
                                                                    phi_1959_ = true;
                                                                } else {
                                                                    let _e1485 = select(_e1424, _e1415, (_e1415 > _e1424));
                                                                    phi_1959_ = (select(_e1433, _e1485, (_e1485 > _e1433)) < 0f);
                                                                }
                                                                let _e1490 = phi_1959_;
                                                                if _e1490 {
                                                                    phi_2633_ = type_22();
                                                                    phi_2634_ = false;
                                                                } else {
                                                                    let _e1492 = select(_e1329, _e1269, (_e1269 < _e1329));
                                                                    let _e1496 = select(_e1329, _e1269, (_e1269 > _e1329));
                                                                    let _e1500 = select(_e1344, _e1291, (_e1291 < _e1344));
                                                                    let _e1504 = select(_e1344, _e1291, (_e1291 > _e1344));
                                                                    let _e1508 = select(_e1359, _e1313, (_e1313 < _e1359));
                                                                    let _e1512 = select(_e1359, _e1313, (_e1313 > _e1359));
                                                                    let _e1517 = ((select(_e1375, _e1492, (_e1492 < _e1375)) - _e503) * _e508);
                                                                    let _e1518 = ((select(_e1375, _e1496, (_e1496 > _e1375)) - _e504) * _e508);
                                                                    let _e1521 = ((select(_e1390, _e1500, (_e1500 < _e1390)) - _e569) * _e574);
                                                                    let _e1522 = ((select(_e1390, _e1504, (_e1504 > _e1390)) - _e570) * _e574);
                                                                    let _e1525 = ((select(_e1405, _e1508, (_e1508 < _e1405)) - _e635) * _e640);
                                                                    let _e1526 = ((select(_e1405, _e1512, (_e1512 > _e1405)) - _e636) * _e640);
                                                                    let _e1528 = select(_e1526, _e1525, (_e1525 < _e1526));
                                                                    let _e1530 = select(_e1526, _e1525, (_e1525 > _e1526));
                                                                    let _e1532 = select(_e1518, _e1517, (_e1517 < _e1518));
                                                                    let _e1534 = select(_e1522, _e1521, (_e1521 < _e1522));
                                                                    let _e1536 = select(_e1534, _e1532, (_e1532 > _e1534));
                                                                    let _e1538 = select(_e1528, _e1536, (_e1536 > _e1528));
                                                                    let _e1540 = select(_e1518, _e1517, (_e1517 > _e1518));
                                                                    let _e1542 = select(_e1522, _e1521, (_e1521 > _e1522));
                                                                    let _e1544 = select(_e1542, _e1540, (_e1540 < _e1542));
                                                                    let _e1546 = select(_e1530, _e1544, (_e1544 < _e1530));
                                                                    let _e1547 = -(_e1528);
                                                                    let _e1553 = select(_e751, _e1538, (_e1538 > _e751));
                                                                    if (_e1553 > (_e1546 + (select(_e1547, _e1530, (_e1530 > _e1547)) * 0.0000019073523f))) {
                                                                        phi_2628_ = type_22();
                                                                        phi_2629_ = true;
                                                                    } else {
                                                                        let _e1555 = (_e1553 > _e1205.member);
                                                                        if _e1555 {
                                                                            phi_2627_ = type_22();
                                                                        } else {
                                                                            let _e1556 = vec3<f32>(_e1269, _e1291, _e1313);
                                                                            let _e1557 = vec3<f32>(_e1329, _e1344, _e1359);
                                                                            let _e1558 = vec3<f32>(_e1375, _e1390, _e1405);
                                                                            let _e1559 = (_e1329 - _e1269);
                                                                            let _e1560 = (_e1344 - _e1291);
                                                                            let _e1561 = (_e1359 - _e1313);
                                                                            let _e1562 = vec3<f32>(_e1559, _e1560, _e1561);
                                                                            let _e1563 = (_e1375 - _e1329);
                                                                            let _e1564 = (_e1390 - _e1344);
                                                                            let _e1565 = (_e1405 - _e1359);
                                                                            let _e1566 = vec3<f32>(_e1563, _e1564, _e1565);
                                                                            let _e1567 = (_e1269 - _e1375);
                                                                            let _e1568 = (_e1291 - _e1390);
                                                                            let _e1569 = (_e1313 - _e1405);
                                                                            let _e1570 = vec3<f32>(_e1567, _e1568, _e1569);
                                                                            let _e1573 = bitcast<f32>((bitcast<u32>(_e1559) & 2147483647u));
                                                                            let _e1576 = bitcast<f32>((bitcast<u32>(_e1560) & 2147483647u));
                                                                            let _e1578 = select(_e1576, _e1573, (_e1573 > _e1576));
                                                                            let _e1581 = bitcast<f32>((bitcast<u32>(_e1561) & 2147483647u));
                                                                            let _e1583 = select(_e1581, _e1578, (_e1578 > _e1581));
                                                                            let _e1586 = bitcast<f32>((bitcast<u32>(_e1563) & 2147483647u));
                                                                            let _e1589 = bitcast<f32>((bitcast<u32>(_e1564) & 2147483647u));
                                                                            let _e1591 = select(_e1589, _e1586, (_e1586 > _e1589));
                                                                            let _e1594 = bitcast<f32>((bitcast<u32>(_e1565) & 2147483647u));
                                                                            let _e1596 = select(_e1594, _e1591, (_e1591 > _e1594));
                                                                            let _e1599 = bitcast<f32>((bitcast<u32>(_e1567) & 2147483647u));
                                                                            let _e1602 = bitcast<f32>((bitcast<u32>(_e1568) & 2147483647u));
                                                                            let _e1604 = select(_e1602, _e1599, (_e1599 > _e1602));
                                                                            let _e1607 = bitcast<f32>((bitcast<u32>(_e1569) & 2147483647u));
                                                                            let _e1609 = select(_e1607, _e1604, (_e1604 > _e1607));
                                                                            let _e1611 = select(_e1596, _e1583, (_e1583 > _e1596));
                                                                            let _e1613 = select(_e1609, _e1611, (_e1611 > _e1609));
                                                                            if (_e1583 == _e1613) {
                                                                                phi_2354_ = _e1424;
                                                                                phi_2355_ = _e1421;
                                                                                phi_2356_ = _e1415;
                                                                                phi_2357_ = _e1412;
                                                                                phi_2358_ = _e1556;
                                                                                phi_2359_ = _e1570;
                                                                                phi_2360_ = _e1566;
                                                                                phi_2361_ = _e1562;
                                                                            } else {
                                                                                let _e1615 = (_e1596 == _e1613);
                                                                                let _e1620 = vec3(_e1615);
                                                                                phi_2354_ = select(_e1415, _e1433, _e1615);
                                                                                phi_2355_ = select(_e1412, _e1430, _e1615);
                                                                                phi_2356_ = select(_e1433, _e1424, _e1615);
                                                                                phi_2357_ = select(_e1430, _e1421, _e1615);
                                                                                phi_2358_ = select(_e1558, _e1557, _e1620);
                                                                                phi_2359_ = select(_e1566, _e1562, _e1620);
                                                                                phi_2360_ = select(_e1562, _e1570, _e1620);
                                                                                phi_2361_ = select(_e1570, _e1566, _e1620);
                                                                            }
                                                                            let _e1626 = phi_2354_;
                                                                            let _e1628 = phi_2355_;
                                                                            let _e1630 = phi_2356_;
                                                                            let _e1632 = phi_2357_;
                                                                            let _e1634 = phi_2358_;
                                                                            let _e1636 = phi_2359_;
                                                                            let _e1638 = phi_2360_;
                                                                            let _e1640 = phi_2361_;
                                                                            let _e1647 = ((_e1638.y * _e1636.z) - (_e1636.y * _e1638.z));
                                                                            let _e1652 = ((_e1638.z * _e1636.x) - (_e1636.z * _e1638.x));
                                                                            let _e1655 = ((_e1638.x * _e1636.y) - (_e1636.x * _e1638.y));
                                                                            if (_e1455 >= _e1459) {
                                                                                phi_2398_ = select(true, false, (_e1455 >= _e1463));
                                                                            } else {
                                                                                phi_2398_ = true;
                                                                            }
                                                                            let _e1660 = phi_2398_;
                                                                            if _e1660 {
                                                                                phi_2407_ = select(_e1558, _e1557, vec3((_e1459 >= _e1463)));
                                                                            } else {
                                                                                phi_2407_ = _e1556;
                                                                            }
                                                                            let _e1665 = phi_2407_;
                                                                            let _e1676 = (((_e1647 * (_e1665.x - _e465)) + (_e1652 * (_e1665.y - _e532))) + (_e1655 * (_e1665.z - _e598)));
                                                                            let _e1681 = (((_e1647 * _e505) + (_e1652 * _e571)) + (_e1655 * _e637));
                                                                            let _e1682 = (_e1628 - _e1632);
                                                                            let _e1683 = (_e1626 - _e1630);
                                                                            let _e1691 = (-(((_e1632 * _e1682) + (_e1630 * _e1683))) / ((_e1682 * _e1682) + (_e1683 * _e1683)));
                                                                            let _e1693 = select(1f, _e1691, (_e1691 < 1f));
                                                                            let _e1695 = select(0f, _e1693, (_e1693 > 0f));
                                                                            let _e1708 = ((_e1634.x + (_e1640.x * _e1695)) - _e465);
                                                                            let _e1709 = ((_e1634.y + (_e1640.y * _e1695)) - _e532);
                                                                            let _e1710 = ((_e1634.z + (_e1640.z * _e1695)) - _e598);
                                                                            let _e1711 = (_e1710 / _e637);
                                                                            let _e1723 = bitcast<f32>((bitcast<u32>(_e1708) & 2147483647u));
                                                                            let _e1726 = bitcast<f32>((bitcast<u32>(_e1709) & 2147483647u));
                                                                            let _e1728 = select(_e1726, _e1723, (_e1723 > _e1726));
                                                                            let _e1731 = bitcast<f32>((bitcast<u32>(_e1710) & 2147483647u));
                                                                            let _e1733 = select(_e1731, _e1728, (_e1728 > _e1731));
                                                                            let _e1739 = bitcast<f32>((bitcast<u32>(_e1647) & 2147483647u));
                                                                            let _e1742 = bitcast<f32>((bitcast<u32>(_e1652) & 2147483647u));
                                                                            let _e1744 = select(_e1742, _e1739, (_e1739 > _e1742));
                                                                            let _e1747 = bitcast<f32>((bitcast<u32>(_e1655) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1647 * _e1708) + (_e1652 * _e1709)) + (_e1655 * _e1710)) - _e1676)) & 2147483647u)) <= ((0.0000009536743f * select(_e1613, _e1733, (_e1733 > _e1613))) * select(_e1747, _e1744, (_e1744 > _e1747)))) {
                                                                                let _e1757 = bitcast<f32>((bitcast<u32>(_e1638.x) & 2147483647u));
                                                                                let _e1760 = bitcast<f32>((bitcast<u32>(_e1638.y) & 2147483647u));
                                                                                let _e1762 = select(_e1760, _e1757, (_e1757 > _e1760));
                                                                                let _e1765 = bitcast<f32>((bitcast<u32>(_e1638.z) & 2147483647u));
                                                                                let _e1771 = bitcast<f32>((bitcast<u32>(_e1636.x) & 2147483647u));
                                                                                let _e1774 = bitcast<f32>((bitcast<u32>(_e1636.y) & 2147483647u));
                                                                                let _e1776 = select(_e1774, _e1771, (_e1771 > _e1774));
                                                                                let _e1779 = bitcast<f32>((bitcast<u32>(_e1636.z) & 2147483647u));
                                                                                let _e1783 = (bitcast<f32>((bitcast<u32>(_e1681) & 2147483647u)) > ((0.0000038146973f * select(_e1765, _e1762, (_e1762 > _e1765))) * select(_e1779, _e1776, (_e1776 > _e1779))));
                                                                                if _e1783 {
                                                                                    phi_2572_ = (_e1676 / _e1681);
                                                                                } else {
                                                                                    phi_2572_ = f32();
                                                                                }
                                                                                let _e1786 = phi_2572_;
                                                                                phi_2574_ = _e1786;
                                                                                phi_2575_ = select(true, false, _e1783);
                                                                            } else {
                                                                                phi_2574_ = f32();
                                                                                phi_2575_ = true;
                                                                            }
                                                                            let _e1789 = phi_2574_;
                                                                            let _e1791 = phi_2575_;
                                                                            if _e1791 {
                                                                                let _e1799 = (((_e1647 * (_e1708 - (_e505 * _e1711))) + (_e1652 * (_e1709 - (_e571 * _e1711)))) / _e1681);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1799) & 2147483647u)) <= _e1613) {
                                                                                    phi_2595_ = (_e1711 + _e1799);
                                                                                } else {
                                                                                    phi_2595_ = _e1711;
                                                                                }
                                                                                let _e1806 = phi_2595_;
                                                                                phi_2596_ = _e1806;
                                                                            } else {
                                                                                phi_2596_ = _e1789;
                                                                            }
                                                                            let _e1808 = phi_2596_;
                                                                            let _e1810 = select(_e1546, _e1808, (_e1808 < _e1546));
                                                                            let _e1812 = select(_e1538, _e1810, (_e1810 > _e1538));
                                                                            if (_e1812 >= _e751) {
                                                                                let _e1814 = (_e1812 <= _e1205.member);
                                                                                if _e1814 {
                                                                                    let _e1815 = (1f / _e1465);
                                                                                    phi_2619_ = type_22(_e1812, (_e1459 * _e1815), (_e1463 * _e1815), _e1233);
                                                                                } else {
                                                                                    phi_2619_ = type_22();
                                                                                }
                                                                                let _e1820 = phi_2619_;
                                                                                phi_2621_ = _e1820;
                                                                                phi_2622_ = select(true, false, _e1814);
                                                                            } else {
                                                                                phi_2621_ = type_22();
                                                                                phi_2622_ = true;
                                                                            }
                                                                            let _e1823 = phi_2621_;
                                                                            let _e1825 = phi_2622_;
                                                                            if _e1825 {
                                                                                phi_2626_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2626_ = _e1823;
                                                                            }
                                                                            let _e1827 = phi_2626_;
                                                                            phi_2627_ = _e1827;
                                                                        }
                                                                        let _e1829 = phi_2627_;
                                                                        phi_2628_ = _e1829;
                                                                        phi_2629_ = _e1555;
                                                                    }
                                                                    let _e1831 = phi_2628_;
                                                                    let _e1833 = phi_2629_;
                                                                    phi_2633_ = _e1831;
                                                                    phi_2634_ = _e1833;
                                                                }
                                                                let _e1835 = phi_2633_;
                                                                let _e1837 = phi_2634_;
                                                                phi_2635_ = _e1835;
                                                                phi_2636_ = _e1490;
                                                                phi_2637_ = _e1837;
                                                            }
                                                            let _e1839 = phi_2635_;
                                                            let _e1841 = phi_2636_;
                                                            let _e1843 = phi_2637_;
                                                            phi_2638_ = _e1839;
                                                            phi_2639_ = _e1841;
                                                            phi_2640_ = _e1843;
                                                        }
                                                        let _e1845 = phi_2638_;
                                                        let _e1847 = phi_2639_;
                                                        let _e1849 = phi_2640_;
                                                        phi_2648_ = _e1845;
                                                        phi_2649_ = select(_e1849, true, _e1847);
                                                    } else {
                                                        phi_2648_ = type_22();
                                                        phi_2649_ = true;
                                                    }
                                                    let _e1852 = phi_2648_;
                                                    let _e1854 = phi_2649_;
                                                    if _e1854 {
                                                        phi_2653_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2653_ = _e1852;
                                                    }
                                                    let _e1856 = phi_2653_;
                                                    if (_e1856.member_3 != 4294967295u) {
                                                        if (_e1233 == _e153) {
                                                            phi_2976_ = false;
                                                        } else {
                                                            let _e1860 = (_e1233 < arrayLength((&global_5.member)));
                                                            if _e1860 {
                                                                if _e1860 {
                                                                } else {
                                                                    phi_4103_ = true;
                                                                    break;
                                                                }
                                                                let _e1862 = global_5.member[_e1233];
                                                                phi_2676_ = _e1862;
                                                            } else {
                                                                phi_2676_ = 4294967295u;
                                                            }
                                                            let _e1864 = phi_2676_;
                                                            let _e1865 = (_e1864 < arrayLength((&global_6.member)));
                                                            if _e1865 {
                                                                if _e1865 {
                                                                } else {
                                                                    phi_4103_ = true;
                                                                    break;
                                                                }
                                                                let _e1867 = global_6.member[_e1864];
                                                                phi_2690_ = _e1867;
                                                            } else {
                                                                phi_2690_ = 0i;
                                                            }
                                                            let _e1869 = phi_2690_;
                                                            let _e1870 = (_e1869 == 0i);
                                                            if _e1870 {
                                                                phi_2975_ = true;
                                                            } else {
                                                                if _e442 {
                                                                    phi_2709_ = vec3<f32>(_e1269, _e1291, _e1313);
                                                                } else {
                                                                    if (_e418 == 1u) {
                                                                        phi_2708_ = vec3<f32>(_e1313, _e1269, _e1291);
                                                                    } else {
                                                                        phi_2708_ = vec3<f32>(_e1291, _e1313, _e1269);
                                                                    }
                                                                    let _e1875 = phi_2708_;
                                                                    phi_2709_ = _e1875;
                                                                }
                                                                let _e1878 = phi_2709_;
                                                                if _e442 {
                                                                    phi_2724_ = vec3<f32>(_e1329, _e1344, _e1359);
                                                                } else {
                                                                    if (_e418 == 1u) {
                                                                        phi_2723_ = vec3<f32>(_e1359, _e1329, _e1344);
                                                                    } else {
                                                                        phi_2723_ = vec3<f32>(_e1344, _e1359, _e1329);
                                                                    }
                                                                    let _e1883 = phi_2723_;
                                                                    phi_2724_ = _e1883;
                                                                }
                                                                let _e1886 = phi_2724_;
                                                                if _e442 {
                                                                    phi_2739_ = vec3<f32>(_e1375, _e1390, _e1405);
                                                                } else {
                                                                    if (_e418 == 1u) {
                                                                        phi_2738_ = vec3<f32>(_e1405, _e1375, _e1390);
                                                                    } else {
                                                                        phi_2738_ = vec3<f32>(_e1390, _e1405, _e1375);
                                                                    }
                                                                    let _e1891 = phi_2738_;
                                                                    phi_2739_ = _e1891;
                                                                }
                                                                let _e1894 = phi_2739_;
                                                                let _e1897 = (_e1886.x - _e1878.x);
                                                                let _e1900 = (_e1886.y - _e1878.y);
                                                                let _e1903 = (_e1886.z - _e1878.z);
                                                                let _e1905 = (_e1894.x - _e1878.x);
                                                                let _e1907 = (_e1894.y - _e1878.y);
                                                                let _e1909 = (_e1894.z - _e1878.z);
                                                                if (_e285.member_1 == 1u) {
                                                                    phi_2775_ = (vec3<f32>(_e285.member[0], _e285.member[1], _e285.member[2]) - _e1878);
                                                                } else {
                                                                    phi_2775_ = vec3<f32>(_e285.member[0], _e285.member[1], _e285.member[2]);
                                                                }
                                                                let _e1924 = phi_2775_;
                                                                let _e1930 = bitcast<f32>((bitcast<u32>((_e1897 * _e1907)) ^ _e285.member_3[0]));
                                                                let _e1934 = bitcast<f32>((bitcast<u32>((_e1900 * _e1905)) ^ _e285.member_3[0]));
                                                                let _e1938 = bitcast<f32>((bitcast<u32>((_e1900 * _e1909)) ^ _e285.member_3[0]));
                                                                let _e1942 = bitcast<f32>((bitcast<u32>((_e1903 * _e1907)) ^ _e285.member_3[0]));
                                                                let _e1946 = bitcast<f32>((bitcast<u32>((_e1903 * _e1905)) ^ _e285.member_3[0]));
                                                                let _e1950 = bitcast<f32>((bitcast<u32>((_e1897 * _e1909)) ^ _e285.member_3[0]));
                                                                let _e1951 = (_e1938 - _e1942);
                                                                let _e1952 = (_e1946 - _e1950);
                                                                let _e1953 = (_e1930 - _e1934);
                                                                let _e1977 = (bitcast<f32>((bitcast<u32>(_e1938) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1942) & 2147483647u)));
                                                                let _e1984 = (bitcast<f32>((bitcast<u32>(_e1946) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1950) & 2147483647u)));
                                                                let _e1991 = (bitcast<f32>((bitcast<u32>(_e1930) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1934) & 2147483647u)));
                                                                if (_e285.member_2 == 0f) {
                                                                    phi_2957_ = 0f;
                                                                } else {
                                                                    let _e2021 = bitcast<f32>((bitcast<u32>(_e1951) & 2147483647u));
                                                                    let _e2024 = bitcast<f32>((bitcast<u32>(_e1952) & 2147483647u));
                                                                    let _e2027 = bitcast<f32>((bitcast<u32>(_e1953) & 2147483647u));
                                                                    let _e2029 = select(_e2027, _e2024, (_e2024 > _e2027));
                                                                    let _e2033 = select(_e2027, _e2024, (_e2024 < _e2027));
                                                                    let _e2037 = select(_e2024, _e2021, (_e2021 < _e2024));
                                                                    let _e2039 = select(_e2024, _e2021, (_e2021 > _e2024));
                                                                    let _e2041 = select(_e2027, _e2039, (_e2039 < _e2027));
                                                                    phi_2957_ = bitcast<f32>((bitcast<u32>((_e285.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e2029, _e2021, (_e2021 > _e2029)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e2041, _e2037, (_e2037 > _e2041)))) ^ _e285.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e2033, _e2021, (_e2021 < _e2033)))) ^ _e285.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1977 + _e1984) + _e1991))) ^ _e285.member_3[0]))) * 1.0000005f)) ^ _e285.member_3[0])))) ^ _e285.member_3[0]));
                                                                }
                                                                let _e2068 = phi_2957_;
                                                                phi_2975_ = (_e1870 || !(((((bitcast<f32>((bitcast<u32>((_e1924.x * _e1951)) ^ _e285.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1924.y * _e1952)) ^ _e285.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1924.z * _e1953)) ^ _e285.member_3[0]))) * f32(-(_e1869))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1924.x) & 2147483647u)) * _e1977)) ^ _e285.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1924.y) & 2147483647u)) * _e1984)) ^ _e285.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1924.z) & 2147483647u)) * _e1991)) ^ _e285.member_3[0]))))) ^ _e285.member_3[0])) + _e2068) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e2082 = phi_2975_;
                                                            phi_2976_ = _e2082;
                                                        }
                                                        let _e2084 = phi_2976_;
                                                        if _e2084 {
                                                            phi_2981_ = type_40(_e1205.member, true);
                                                        } else {
                                                            phi_2981_ = _e1205;
                                                        }
                                                        let _e2089 = phi_2981_;
                                                        phi_2982_ = _e2089;
                                                    } else {
                                                        phi_2982_ = _e1205;
                                                    }
                                                    let _e2091 = phi_2982_;
                                                    phi_1426_ = _e2091;
                                                } else {
                                                    phi_1426_ = type_40();
                                                }
                                                let _e2093 = phi_1426_;
                                                continue;
                                                continuing {
                                                    phi_1425_ = _e2093;
                                                    phi_1428_ = _e1220;
                                                    phi_4103_ = _e783;
                                                    break if !(_e1226);
                                                }
                                            }
                                            let _e2096 = phi_4103_;
                                            phi_4313_ = _e2096;
                                            if _e2096 {
                                                break;
                                            }
                                            let _e2098 = local_10;
                                            phi_4317_ = _e2096;
                                            let _e2303 = local_12;
                                            phi_3997_ = _e2303;
                                            phi_3998_ = false;
                                            phi_3999_ = select(_e826, 0u, _e2098.member_1);
                                            phi_4000_ = _e828;
                                        } else {
                                            let _e838 = (_e828.member_1 < _e93);
                                            if _e838 {
                                                if _e838 {
                                                } else {
                                                    phi_4313_ = true;
                                                    break;
                                                }
                                                let _e840 = global_9.member[_e828.member_1];
                                                phi_3010_ = _e840;
                                            } else {
                                                phi_3010_ = type_49(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                            }
                                            let _e842 = phi_3010_;
                                            let _e857 = ((10u * _e418) & 31u);
                                            let _e860 = ((_e842.member[0] >> bitcast<u32>(_e857)) & 1023u);
                                            let _e868 = bitcast<f32>((bitcast<u32>(((_e828.member.member_1[0] - _e828.member.member[0]) * 0.0009775171f)) ^ _e136));
                                            let _e873 = (_e828.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e860)) - 8388608f) * _e868)) ^ _e136)));
                                            let _e877 = select(select(_e828.member.member_1[0], _e873, (_e873 < _e828.member.member_1[0])), _e828.member.member_1[0], (_e860 == 1023u));
                                            let _e879 = ((10u * _e417) & 31u);
                                            let _e882 = ((_e842.member[0] >> bitcast<u32>(_e879)) & 1023u);
                                            let _e890 = bitcast<f32>((bitcast<u32>(((_e828.member.member_1[1] - _e828.member.member[1]) * 0.0009775171f)) ^ _e136));
                                            let _e895 = (_e828.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e882)) - 8388608f) * _e890)) ^ _e136)));
                                            let _e899 = select(select(_e828.member.member_1[1], _e895, (_e895 < _e828.member.member_1[1])), _e828.member.member_1[1], (_e882 == 1023u));
                                            let _e901 = ((10u * _e419) & 31u);
                                            let _e904 = ((_e842.member[0] >> bitcast<u32>(_e901)) & 1023u);
                                            let _e912 = bitcast<f32>((bitcast<u32>(((_e828.member.member_1[2] - _e828.member.member[2]) * 0.0009775171f)) ^ _e136));
                                            let _e917 = (_e828.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e904)) - 8388608f) * _e912)) ^ _e136)));
                                            let _e921 = select(select(_e828.member.member_1[2], _e917, (_e917 < _e828.member.member_1[2])), _e828.member.member_1[2], (_e904 == 1023u));
                                            let _e924 = ((_e842.member[1] >> bitcast<u32>(_e857)) & 1023u);
                                            let _e932 = (_e828.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e924)) - 8388608f) * _e868)) ^ _e136)));
                                            let _e936 = select(select(_e828.member.member_1[0], _e932, (_e932 < _e828.member.member_1[0])), _e828.member.member_1[0], (_e924 == 1023u));
                                            let _e939 = ((_e842.member[1] >> bitcast<u32>(_e879)) & 1023u);
                                            let _e947 = (_e828.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e939)) - 8388608f) * _e890)) ^ _e136)));
                                            let _e951 = select(select(_e828.member.member_1[1], _e947, (_e947 < _e828.member.member_1[1])), _e828.member.member_1[1], (_e939 == 1023u));
                                            let _e954 = ((_e842.member[1] >> bitcast<u32>(_e901)) & 1023u);
                                            let _e962 = (_e828.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e954)) - 8388608f) * _e912)) ^ _e136)));
                                            let _e966 = select(select(_e828.member.member_1[2], _e962, (_e962 < _e828.member.member_1[2])), _e828.member.member_1[2], (_e954 == 1023u));
                                            let _e972 = ((_e842.member_1[0] >> bitcast<u32>(_e857)) & 1023u);
                                            let _e980 = (_e828.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e972)) - 8388608f) * _e868)) ^ _e136)));
                                            let _e984 = select(select(_e828.member.member_1[0], _e980, (_e980 < _e828.member.member_1[0])), _e828.member.member_1[0], (_e972 == 1023u));
                                            let _e987 = ((_e842.member_1[0] >> bitcast<u32>(_e879)) & 1023u);
                                            let _e995 = (_e828.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e987)) - 8388608f) * _e890)) ^ _e136)));
                                            let _e999 = select(select(_e828.member.member_1[1], _e995, (_e995 < _e828.member.member_1[1])), _e828.member.member_1[1], (_e987 == 1023u));
                                            let _e1002 = ((_e842.member_1[0] >> bitcast<u32>(_e901)) & 1023u);
                                            let _e1010 = (_e828.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1002)) - 8388608f) * _e912)) ^ _e136)));
                                            let _e1014 = select(select(_e828.member.member_1[2], _e1010, (_e1010 < _e828.member.member_1[2])), _e828.member.member_1[2], (_e1002 == 1023u));
                                            let _e1017 = ((_e842.member_1[1] >> bitcast<u32>(_e857)) & 1023u);
                                            let _e1025 = (_e828.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1017)) - 8388608f) * _e868)) ^ _e136)));
                                            let _e1029 = select(select(_e828.member.member_1[0], _e1025, (_e1025 < _e828.member.member_1[0])), _e828.member.member_1[0], (_e1017 == 1023u));
                                            let _e1032 = ((_e842.member_1[1] >> bitcast<u32>(_e879)) & 1023u);
                                            let _e1040 = (_e828.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1032)) - 8388608f) * _e890)) ^ _e136)));
                                            let _e1044 = select(select(_e828.member.member_1[1], _e1040, (_e1040 < _e828.member.member_1[1])), _e828.member.member_1[1], (_e1032 == 1023u));
                                            let _e1047 = ((_e842.member_1[1] >> bitcast<u32>(_e901)) & 1023u);
                                            let _e1055 = (_e828.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1047)) - 8388608f) * _e912)) ^ _e136)));
                                            let _e1059 = select(select(_e828.member.member_1[2], _e1055, (_e1055 < _e828.member.member_1[2])), _e828.member.member_1[2], (_e1047 == 1023u));
                                            let _e1064 = type_62(type_54(array<f32, 3>(_e877, _e899, _e921), array<f32, 3>(_e936, _e951, _e966)), _e842.member_2);
                                            let _e1069 = type_62(type_54(array<f32, 3>(_e984, _e999, _e1014), array<f32, 3>(_e1029, _e1044, _e1059)), _e842.member_3);
                                            let _e1075 = ((_e877 - _e503) * _e508);
                                            let _e1076 = ((_e984 - _e503) * _e508);
                                            let _e1077 = ((_e936 - _e504) * _e508);
                                            let _e1078 = ((_e1029 - _e504) * _e508);
                                            let _e1083 = ((_e899 - _e569) * _e574);
                                            let _e1084 = ((_e999 - _e569) * _e574);
                                            let _e1085 = ((_e951 - _e570) * _e574);
                                            let _e1086 = ((_e1044 - _e570) * _e574);
                                            let _e1091 = ((_e921 - _e635) * _e640);
                                            let _e1092 = ((_e1014 - _e635) * _e640);
                                            let _e1093 = ((_e966 - _e636) * _e640);
                                            let _e1094 = ((_e1059 - _e636) * _e640);
                                            let _e1096 = select(_e1093, _e1091, (_e1091 < _e1093));
                                            let _e1098 = select(_e1094, _e1092, (_e1092 < _e1094));
                                            let _e1100 = select(_e1093, _e1091, (_e1091 > _e1093));
                                            let _e1102 = select(_e1094, _e1092, (_e1092 > _e1094));
                                            let _e1104 = select(_e1077, _e1075, (_e1075 < _e1077));
                                            let _e1106 = select(_e1078, _e1076, (_e1076 < _e1078));
                                            let _e1108 = select(_e1085, _e1083, (_e1083 < _e1085));
                                            let _e1110 = select(_e1086, _e1084, (_e1084 < _e1086));
                                            let _e1112 = select(_e1108, _e1104, (_e1104 > _e1108));
                                            let _e1114 = select(_e1110, _e1106, (_e1106 > _e1110));
                                            let _e1116 = select(_e1096, _e1112, (_e1112 > _e1096));
                                            let _e1118 = select(_e1098, _e1114, (_e1114 > _e1098));
                                            let _e1120 = select(_e1077, _e1075, (_e1075 > _e1077));
                                            let _e1122 = select(_e1078, _e1076, (_e1076 > _e1078));
                                            let _e1124 = select(_e1085, _e1083, (_e1083 > _e1085));
                                            let _e1126 = select(_e1086, _e1084, (_e1084 > _e1086));
                                            let _e1128 = select(_e1124, _e1120, (_e1120 < _e1124));
                                            let _e1130 = select(_e1126, _e1122, (_e1122 < _e1126));
                                            let _e1135 = -(_e1096);
                                            let _e1136 = -(_e1098);
                                            let _e1143 = (select(_e1100, _e1128, (_e1128 < _e1100)) + (select(_e1135, _e1100, (_e1100 > _e1135)) * 0.0000019073523f));
                                            let _e1144 = (select(_e1102, _e1130, (_e1130 < _e1102)) + (select(_e1136, _e1102, (_e1102 > _e1136)) * 0.0000019073523f));
                                            let _e1146 = select(_e751, _e1116, (_e1116 > _e751));
                                            let _e1148 = select(_e751, _e1118, (_e1118 > _e751));
                                            let _e1153 = (_e1146 <= select(_e785.member, _e1143, (_e1143 < _e785.member)));
                                            let _e1154 = (_e1148 <= select(_e785.member, _e1144, (_e1144 < _e785.member)));
                                            let _e1155 = (_e1146 <= _e1148);
                                            if _e1153 {
                                                if _e1154 {
                                                    if _e1155 {
                                                        phi_3896_ = _e1069;
                                                    } else {
                                                        phi_3896_ = _e1064;
                                                    }
                                                    let _e1157 = phi_3896_;
                                                    let _e1165 = (_e826 % 128u);
                                                    let _e1166 = (_e1165 < 128u);
                                                    if _e1166 {
                                                    } else {
                                                        phi_4313_ = true;
                                                        break;
                                                    }
                                                    local_6[_e1165] = _e1157.member_1;
                                                    if _e1166 {
                                                    } else {
                                                        phi_4313_ = true;
                                                        break;
                                                    }
                                                    local_5[_e1165] = _e1157.member.member[0];
                                                    if _e1166 {
                                                    } else {
                                                        phi_4313_ = true;
                                                        break;
                                                    }
                                                    local_4[_e1165] = _e1157.member.member[1];
                                                    if _e1166 {
                                                    } else {
                                                        phi_4313_ = true;
                                                        break;
                                                    }
                                                    local_3[_e1165] = _e1157.member.member[2];
                                                    if _e1166 {
                                                    } else {
                                                        phi_4313_ = true;
                                                        break;
                                                    }
                                                    local_2[_e1165] = _e1157.member.member_1[0];
                                                    if _e1166 {
                                                    } else {
                                                        phi_4313_ = true;
                                                        break;
                                                    }
                                                    local_1[_e1165] = _e1157.member.member_1[1];
                                                    if _e1166 {
                                                    } else {
                                                        phi_4313_ = true;
                                                        break;
                                                    }
                                                    local[_e1165] = _e1157.member.member_1[2];
                                                    if _e1166 {
                                                    } else {
                                                        phi_4313_ = true;
                                                        break;
                                                    }
                                                    local_7[_e1165] = select(_e1148, _e1146, !(_e1155));
                                                    if _e1155 {
                                                        phi_3973_ = _e1064;
                                                    } else {
                                                        phi_3973_ = _e1069;
                                                    }
                                                    let _e1183 = phi_3973_;
                                                    phi_3974_ = (_e826 + 1u);
                                                    phi_3975_ = _e1183;
                                                } else {
                                                    phi_3974_ = u32();
                                                    phi_3975_ = type_62();
                                                }
                                                let _e1185 = phi_3974_;
                                                let _e1187 = phi_3975_;
                                                phi_3977_ = _e1185;
                                                phi_3978_ = _e1187;
                                                phi_3979_ = select(true, false, _e1154);
                                            } else {
                                                phi_3977_ = u32();
                                                phi_3978_ = type_62();
                                                phi_3979_ = true;
                                            }
                                            let _e1190 = phi_3977_;
                                            let _e1192 = phi_3978_;
                                            let _e1194 = phi_3979_;
                                            if _e1194 {
                                                if _e1153 {
                                                    phi_3986_ = _e1064;
                                                } else {
                                                    phi_3986_ = _e1069;
                                                }
                                                let _e1196 = phi_3986_;
                                                phi_3991_ = select(_e1154, true, _e1153);
                                                phi_3993_ = _e1196;
                                            } else {
                                                phi_3991_ = _e824;
                                                phi_3993_ = _e1192;
                                            }
                                            let _e1199 = phi_3991_;
                                            let _e1201 = phi_3993_;
                                            phi_4317_ = _e783;
                                            phi_3997_ = _e785;
                                            phi_3998_ = _e1199;
                                            phi_3999_ = select(_e1190, _e826, _e1194);
                                            phi_4000_ = _e1201;
                                        }
                                        let _e2102 = phi_4317_;
                                        let _e2104 = phi_3997_;
                                        let _e2106 = phi_3998_;
                                        let _e2108 = phi_3999_;
                                        let _e2110 = phi_4000_;
                                        phi_4316_ = _e2102;
                                        phi_4001_ = _e2104;
                                        phi_4002_ = _e2106;
                                        phi_4003_ = (_e789 - 1u);
                                        phi_4004_ = _e2108;
                                        phi_4005_ = _e2110;
                                    } else {
                                        phi_4316_ = _e783;
                                        phi_4001_ = _e785;
                                        phi_4002_ = _e824;
                                        phi_4003_ = _e789;
                                        phi_4004_ = _e826;
                                        phi_4005_ = _e828;
                                    }
                                    let _e2112 = phi_4316_;
                                    let _e2114 = phi_4001_;
                                    let _e2116 = phi_4002_;
                                    let _e2118 = phi_4003_;
                                    let _e2120 = phi_4004_;
                                    let _e2122 = phi_4005_;
                                    phi_4315_ = _e2112;
                                    phi_4006_ = _e2114;
                                    phi_4007_ = _e2116;
                                    phi_4008_ = _e2118;
                                    phi_4009_ = _e2120;
                                    phi_4010_ = _e2122;
                                } else {
                                    phi_4315_ = _e783;
                                    phi_4006_ = type_40();
                                    phi_4007_ = bool();
                                    phi_4008_ = u32();
                                    phi_4009_ = u32();
                                    phi_4010_ = type_62();
                                }
                                let _e2124 = phi_4315_;
                                let _e2126 = phi_4006_;
                                let _e2128 = phi_4007_;
                                let _e2130 = phi_4008_;
                                let _e2132 = phi_4009_;
                                let _e2134 = phi_4010_;
                                phi_4314_ = _e2124;
                                phi_1299_ = _e2126;
                                phi_1302_ = _e2128;
                                phi_1304_ = _e2130;
                                phi_1306_ = _e2132;
                                phi_1308_ = _e2134;
                                phi_4011_ = _e797;
                            } else {
                                phi_4314_ = _e783;
                                phi_1299_ = type_40();
                                phi_1302_ = bool();
                                phi_1304_ = u32();
                                phi_1306_ = u32();
                                phi_1308_ = type_62();
                                phi_4011_ = false;
                            }
                            let _e2136 = phi_4314_;
                            let _e2138 = phi_1299_;
                            let _e2140 = phi_1302_;
                            let _e2142 = phi_1304_;
                            let _e2144 = phi_1306_;
                            let _e2146 = phi_1308_;
                            let _e2148 = phi_4011_;
                            continue;
                            continuing {
                                phi_4109_ = _e2136;
                                phi_1298_ = _e2138;
                                phi_1301_ = _e2140;
                                phi_1303_ = _e2142;
                                phi_1305_ = _e2144;
                                phi_1307_ = _e2146;
                                phi_4313_ = _e2136;
                                break if !(_e2148);
                            }
                        }
                        let _e2151 = phi_4313_;
                        if _e2151 {
                            break;
                        }
                        let _e2153 = local_11;
                        if _e2153.member_1 {
                        } else {
                            if _e286 {
                            } else {
                                break;
                            }
                            let _e2157 = global_2.member[_e140];
                            if _e147 {
                            } else {
                                break;
                            }
                            let _e2161 = global_8.member[_e140].member_1;
                            if _e286 {
                            } else {
                                break;
                            }
                            global_2.member[_e140] = type_24(_e2157.member, _e2157.member_1, _e2157.member_2, array<f32, 3>((_e2157.member_3[0] + (_e2161[0] * _e2157.member_1[0])), (_e2157.member_3[1] + (_e2161[1] * _e2157.member_1[1])), (_e2157.member_3[2] + (_e2161[2] * _e2157.member_1[2]))), _e2157.member_4);
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
fn trace_shadows_printed_leaf10_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
