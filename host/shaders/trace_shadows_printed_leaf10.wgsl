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
    var phi_4112_: bool;
    var phi_1298_: type_40;
    var phi_1301_: u32;
    var phi_1303_: bool;
    var phi_1305_: u32;
    var phi_1307_: type_62;
    var phi_1318_: bool;
    var phi_1404_: bool;
    var phi_1405_: u32;
    var phi_1406_: type_62;
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
    var phi_4106_: bool;
    var phi_4375_: bool;
    var phi_2983_: type_40;
    var phi_3004_: type_49;
    var phi_3890_: type_62;
    var phi_3966_: type_62;
    var phi_3967_: u32;
    var phi_3968_: type_62;
    var phi_3970_: u32;
    var phi_3971_: type_62;
    var phi_3972_: bool;
    var phi_3979_: type_62;
    var phi_3984_: bool;
    var phi_3986_: type_62;
    var phi_3990_: bool;
    var phi_3991_: u32;
    var phi_3992_: type_62;
    var phi_4002_: u32;
    var phi_4003_: type_62;
    var phi_4319_: bool;
    var phi_4004_: type_40;
    var phi_4005_: u32;
    var phi_4006_: bool;
    var phi_4007_: u32;
    var phi_4008_: type_62;
    var phi_4318_: bool;
    var phi_4009_: type_40;
    var phi_4010_: u32;
    var phi_4011_: bool;
    var phi_4012_: u32;
    var phi_4013_: type_62;
    var phi_4317_: bool;
    var phi_1299_: type_40;
    var phi_1302_: u32;
    var phi_1304_: bool;
    var phi_1306_: u32;
    var phi_1308_: type_62;
    var phi_4014_: bool;
    var phi_4316_: bool;
    var local_10: type_40;
    var local_11: type_40;

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
                        phi_4112_ = false;
                        phi_1298_ = type_40(_e749, false);
                        phi_1301_ = ((3u * _e93) + 1u);
                        phi_1303_ = (_e751 <= _e749);
                        phi_1305_ = 0u;
                        phi_1307_ = type_62(type_54(array<f32, 3>(_e759, _e763, _e767), array<f32, 3>(_e771, _e773, _e775)), select(0u, 2147483648u, (_e93 == 0u)));
                        loop {
                            let _e783 = phi_4112_;
                            let _e785 = phi_1298_;
                            let _e787 = phi_1301_;
                            let _e789 = phi_1303_;
                            let _e791 = phi_1305_;
                            let _e793 = phi_1307_;
                            local_10 = _e785;
                            if _e789 {
                                phi_1318_ = true;
                            } else {
                                phi_1318_ = (_e791 > 0u);
                            }
                            let _e796 = phi_1318_;
                            if _e796 {
                                let _e797 = (_e787 > 0u);
                                if _e797 {
                                    if _e789 {
                                        phi_1404_ = _e789;
                                        phi_1405_ = _e791;
                                        phi_1406_ = _e793;
                                    } else {
                                        let _e798 = (_e791 - 1u);
                                        let _e799 = (_e798 % 128u);
                                        let _e800 = (_e799 < 128u);
                                        if _e800 {
                                        } else {
                                            phi_4316_ = true;
                                            break;
                                        }
                                        let _e802 = local_6[_e799];
                                        if _e800 {
                                        } else {
                                            phi_4316_ = true;
                                            break;
                                        }
                                        let _e804 = local_5[_e799];
                                        if _e800 {
                                        } else {
                                            phi_4316_ = true;
                                            break;
                                        }
                                        let _e806 = local_4[_e799];
                                        if _e800 {
                                        } else {
                                            phi_4316_ = true;
                                            break;
                                        }
                                        let _e808 = local_3[_e799];
                                        if _e800 {
                                        } else {
                                            phi_4316_ = true;
                                            break;
                                        }
                                        let _e811 = local_2[_e799];
                                        if _e800 {
                                        } else {
                                            phi_4316_ = true;
                                            break;
                                        }
                                        let _e813 = local_1[_e799];
                                        if _e800 {
                                        } else {
                                            phi_4316_ = true;
                                            break;
                                        }
                                        let _e815 = local[_e799];
                                        if _e800 {
                                        } else {
                                            phi_4316_ = true;
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
                                        let _e832 = ((_e828.member_1 & 2147483648u) != 0u);
                                        if _e832 {
                                            phi_1425_ = _e785;
                                            phi_1428_ = type_8(0u, ((_e828.member_1 >> bitcast<u32>(28u)) & 7u));
                                            loop {
                                                let _e840 = phi_1425_;
                                                let _e842 = phi_1428_;
                                                local_11 = _e840;
                                                if (_e842.member < _e842.member_1) {
                                                    phi_1429_ = type_8((_e842.member + 1u), _e842.member_1);
                                                    phi_1451_ = type_8(1u, _e842.member);
                                                } else {
                                                    phi_1429_ = _e842;
                                                    phi_1451_ = type_8(0u, type_8().member_1);
                                                }
                                                let _e855 = phi_1429_;
                                                let _e857 = phi_1451_;
                                                let _e861 = (bitcast<i32>(_e857.member) != 0i);
                                                if _e861 {
                                                    let _e862 = ((_e828.member_1 & 268435455u) + _e857.member_1);
                                                    let _e863 = (_e862 < arrayLength((&global_10.member)));
                                                    if _e863 {
                                                        if _e863 {
                                                        } else {
                                                            phi_4106_ = true;
                                                            break;
                                                        }
                                                        let _e866 = global_10.member[_e862].member_1;
                                                        phi_1476_ = _e866;
                                                    } else {
                                                        phi_1476_ = 4294967295u;
                                                    }
                                                    let _e868 = phi_1476_;
                                                    if _e863 {
                                                        if _e863 {
                                                        } else {
                                                            phi_4106_ = true;
                                                            break;
                                                        }
                                                        let _e870 = global_10.member[_e862];
                                                        phi_1492_ = _e870;
                                                    } else {
                                                        phi_1492_ = type_56(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                    }
                                                    let _e872 = phi_1492_;
                                                    let _e884 = ((10u * _e418) & 31u);
                                                    let _e887 = ((_e872.member[0] >> bitcast<u32>(_e884)) & 1023u);
                                                    let _e895 = bitcast<f32>((bitcast<u32>(((_e828.member.member_1[0] - _e828.member.member[0]) * 0.0009775171f)) ^ _e136));
                                                    let _e900 = (_e828.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e887)) - 8388608f) * _e895)) ^ _e136)));
                                                    let _e904 = select(select(_e828.member.member_1[0], _e900, (_e900 < _e828.member.member_1[0])), _e828.member.member_1[0], (_e887 == 1023u));
                                                    let _e906 = ((10u * _e417) & 31u);
                                                    let _e909 = ((_e872.member[0] >> bitcast<u32>(_e906)) & 1023u);
                                                    let _e917 = bitcast<f32>((bitcast<u32>(((_e828.member.member_1[1] - _e828.member.member[1]) * 0.0009775171f)) ^ _e136));
                                                    let _e922 = (_e828.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e909)) - 8388608f) * _e917)) ^ _e136)));
                                                    let _e926 = select(select(_e828.member.member_1[1], _e922, (_e922 < _e828.member.member_1[1])), _e828.member.member_1[1], (_e909 == 1023u));
                                                    let _e928 = ((10u * _e419) & 31u);
                                                    let _e931 = ((_e872.member[0] >> bitcast<u32>(_e928)) & 1023u);
                                                    let _e939 = bitcast<f32>((bitcast<u32>(((_e828.member.member_1[2] - _e828.member.member[2]) * 0.0009775171f)) ^ _e136));
                                                    let _e944 = (_e828.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e931)) - 8388608f) * _e939)) ^ _e136)));
                                                    let _e948 = select(select(_e828.member.member_1[2], _e944, (_e944 < _e828.member.member_1[2])), _e828.member.member_1[2], (_e931 == 1023u));
                                                    let _e952 = ((_e872.member[1] >> bitcast<u32>(_e884)) & 1023u);
                                                    let _e960 = (_e828.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e952)) - 8388608f) * _e895)) ^ _e136)));
                                                    let _e964 = select(select(_e828.member.member_1[0], _e960, (_e960 < _e828.member.member_1[0])), _e828.member.member_1[0], (_e952 == 1023u));
                                                    let _e967 = ((_e872.member[1] >> bitcast<u32>(_e906)) & 1023u);
                                                    let _e975 = (_e828.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e967)) - 8388608f) * _e917)) ^ _e136)));
                                                    let _e979 = select(select(_e828.member.member_1[1], _e975, (_e975 < _e828.member.member_1[1])), _e828.member.member_1[1], (_e967 == 1023u));
                                                    let _e982 = ((_e872.member[1] >> bitcast<u32>(_e928)) & 1023u);
                                                    let _e990 = (_e828.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e982)) - 8388608f) * _e939)) ^ _e136)));
                                                    let _e994 = select(select(_e828.member.member_1[2], _e990, (_e990 < _e828.member.member_1[2])), _e828.member.member_1[2], (_e982 == 1023u));
                                                    let _e998 = ((_e872.member[2] >> bitcast<u32>(_e884)) & 1023u);
                                                    let _e1006 = (_e828.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e998)) - 8388608f) * _e895)) ^ _e136)));
                                                    let _e1010 = select(select(_e828.member.member_1[0], _e1006, (_e1006 < _e828.member.member_1[0])), _e828.member.member_1[0], (_e998 == 1023u));
                                                    let _e1013 = ((_e872.member[2] >> bitcast<u32>(_e906)) & 1023u);
                                                    let _e1021 = (_e828.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1013)) - 8388608f) * _e917)) ^ _e136)));
                                                    let _e1025 = select(select(_e828.member.member_1[1], _e1021, (_e1021 < _e828.member.member_1[1])), _e828.member.member_1[1], (_e1013 == 1023u));
                                                    let _e1028 = ((_e872.member[2] >> bitcast<u32>(_e928)) & 1023u);
                                                    let _e1036 = (_e828.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1028)) - 8388608f) * _e939)) ^ _e136)));
                                                    let _e1040 = select(select(_e828.member.member_1[2], _e1036, (_e1036 < _e828.member.member_1[2])), _e828.member.member_1[2], (_e1028 == 1023u));
                                                    let _e1044 = (_e948 - _e598);
                                                    let _e1047 = (((_e904 - _e465) * _e637) - (_e1044 * _e505));
                                                    let _e1050 = (((_e926 - _e532) * _e637) - (_e1044 * _e571));
                                                    let _e1053 = (_e994 - _e598);
                                                    let _e1056 = (((_e964 - _e465) * _e637) - (_e1053 * _e505));
                                                    let _e1059 = (((_e979 - _e532) * _e637) - (_e1053 * _e571));
                                                    let _e1062 = (_e1040 - _e598);
                                                    let _e1065 = (((_e1010 - _e465) * _e637) - (_e1062 * _e505));
                                                    let _e1068 = (((_e1025 - _e532) * _e637) - (_e1062 * _e571));
                                                    let _e1069 = (_e1065 * _e1059);
                                                    let _e1070 = (_e1068 * _e1056);
                                                    let _e1071 = (_e1047 * _e1068);
                                                    let _e1072 = (_e1050 * _e1065);
                                                    let _e1073 = (_e1056 * _e1050);
                                                    let _e1074 = (_e1059 * _e1047);
                                                    let _e1079 = (((_e1069 >= _e1070) && (_e1071 >= _e1072)) && (_e1073 >= _e1074));
                                                    if (_e1079 || (((_e1069 <= _e1070) && (_e1071 <= _e1072)) && (_e1073 <= _e1074))) {
                                                        let _e1086 = select(-1f, 1f, _e1079);
                                                        let _e1088 = ((_e1069 - _e1070) * _e1086);
                                                        let _e1090 = select(0f, _e1088, (_e1088 > 0f));
                                                        let _e1092 = ((_e1071 - _e1072) * _e1086);
                                                        let _e1094 = select(0f, _e1092, (_e1092 > 0f));
                                                        let _e1096 = ((_e1073 - _e1074) * _e1086);
                                                        let _e1098 = select(0f, _e1096, (_e1096 > 0f));
                                                        let _e1100 = ((_e1090 + _e1094) + _e1098);
                                                        if (_e1100 < 0.000000000000000000000000000000000000011754944f) {
                                                            phi_2638_ = type_22();
                                                            phi_2639_ = true;
                                                            phi_2640_ = false;
                                                        } else {
                                                            let _e1103 = select(_e1056, _e1047, (_e1047 < _e1056));
                                                            if (select(_e1065, _e1103, (_e1103 < _e1065)) > 0f) {
                                                                phi_1930_ = true;
                                                            } else {
                                                                let _e1108 = select(_e1056, _e1047, (_e1047 > _e1056));
                                                                phi_1930_ = (select(_e1065, _e1108, (_e1108 > _e1065)) < 0f);
                                                            }
                                                            let _e1113 = phi_1930_;
                                                            if _e1113 {
                                                                phi_2635_ = type_22();
                                                                phi_2636_ = true;
                                                                phi_2637_ = false;
                                                            } else {
                                                                let _e1115 = select(_e1059, _e1050, (_e1050 < _e1059));
                                                                if (select(_e1068, _e1115, (_e1115 < _e1068)) > 0f) {
                                                                    phi_1959_ = true;
                                                                } else {
                                                                    let _e1120 = select(_e1059, _e1050, (_e1050 > _e1059));
                                                                    phi_1959_ = (select(_e1068, _e1120, (_e1120 > _e1068)) < 0f);
                                                                }
                                                                let _e1125 = phi_1959_;
                                                                if _e1125 {
                                                                    phi_2633_ = type_22();
                                                                    phi_2634_ = false;
                                                                } else {
                                                                    let _e1127 = select(_e964, _e904, (_e904 < _e964));
                                                                    let _e1131 = select(_e964, _e904, (_e904 > _e964));
                                                                    let _e1135 = select(_e979, _e926, (_e926 < _e979));
                                                                    let _e1139 = select(_e979, _e926, (_e926 > _e979));
                                                                    let _e1143 = select(_e994, _e948, (_e948 < _e994));
                                                                    let _e1147 = select(_e994, _e948, (_e948 > _e994));
                                                                    let _e1152 = ((select(_e1010, _e1127, (_e1127 < _e1010)) - _e503) * _e508);
                                                                    let _e1153 = ((select(_e1010, _e1131, (_e1131 > _e1010)) - _e504) * _e508);
                                                                    let _e1156 = ((select(_e1025, _e1135, (_e1135 < _e1025)) - _e569) * _e574);
                                                                    let _e1157 = ((select(_e1025, _e1139, (_e1139 > _e1025)) - _e570) * _e574);
                                                                    let _e1160 = ((select(_e1040, _e1143, (_e1143 < _e1040)) - _e635) * _e640);
                                                                    let _e1161 = ((select(_e1040, _e1147, (_e1147 > _e1040)) - _e636) * _e640);
                                                                    let _e1163 = select(_e1161, _e1160, (_e1160 < _e1161));
                                                                    let _e1165 = select(_e1161, _e1160, (_e1160 > _e1161));
                                                                    let _e1167 = select(_e1153, _e1152, (_e1152 < _e1153));
                                                                    let _e1169 = select(_e1157, _e1156, (_e1156 < _e1157));
                                                                    let _e1171 = select(_e1169, _e1167, (_e1167 > _e1169));
                                                                    let _e1173 = select(_e1163, _e1171, (_e1171 > _e1163));
                                                                    let _e1175 = select(_e1153, _e1152, (_e1152 > _e1153));
                                                                    let _e1177 = select(_e1157, _e1156, (_e1156 > _e1157));
                                                                    let _e1179 = select(_e1177, _e1175, (_e1175 < _e1177));
                                                                    let _e1181 = select(_e1165, _e1179, (_e1179 < _e1165));
                                                                    let _e1182 = -(_e1163);
                                                                    let _e1188 = select(_e751, _e1173, (_e1173 > _e751));
                                                                    if (_e1188 > (_e1181 + (select(_e1182, _e1165, (_e1165 > _e1182)) * 0.0000019073523f))) {
                                                                        phi_2628_ = type_22();
                                                                        phi_2629_ = true;
                                                                    } else {
                                                                        let _e1190 = (_e1188 > _e840.member);
                                                                        if _e1190 {
                                                                            phi_2627_ = type_22();
                                                                        } else {
                                                                            let _e1191 = vec3<f32>(_e904, _e926, _e948);
                                                                            let _e1192 = vec3<f32>(_e964, _e979, _e994);
                                                                            let _e1193 = vec3<f32>(_e1010, _e1025, _e1040);
                                                                            let _e1194 = (_e964 - _e904);
                                                                            let _e1195 = (_e979 - _e926);
                                                                            let _e1196 = (_e994 - _e948);
                                                                            let _e1197 = vec3<f32>(_e1194, _e1195, _e1196);
                                                                            let _e1198 = (_e1010 - _e964);
                                                                            let _e1199 = (_e1025 - _e979);
                                                                            let _e1200 = (_e1040 - _e994);
                                                                            let _e1201 = vec3<f32>(_e1198, _e1199, _e1200);
                                                                            let _e1202 = (_e904 - _e1010);
                                                                            let _e1203 = (_e926 - _e1025);
                                                                            let _e1204 = (_e948 - _e1040);
                                                                            let _e1205 = vec3<f32>(_e1202, _e1203, _e1204);
                                                                            let _e1208 = bitcast<f32>((bitcast<u32>(_e1194) & 2147483647u));
                                                                            let _e1211 = bitcast<f32>((bitcast<u32>(_e1195) & 2147483647u));
                                                                            let _e1213 = select(_e1211, _e1208, (_e1208 > _e1211));
                                                                            let _e1216 = bitcast<f32>((bitcast<u32>(_e1196) & 2147483647u));
                                                                            let _e1218 = select(_e1216, _e1213, (_e1213 > _e1216));
                                                                            let _e1221 = bitcast<f32>((bitcast<u32>(_e1198) & 2147483647u));
                                                                            let _e1224 = bitcast<f32>((bitcast<u32>(_e1199) & 2147483647u));
                                                                            let _e1226 = select(_e1224, _e1221, (_e1221 > _e1224));
                                                                            let _e1229 = bitcast<f32>((bitcast<u32>(_e1200) & 2147483647u));
                                                                            let _e1231 = select(_e1229, _e1226, (_e1226 > _e1229));
                                                                            let _e1234 = bitcast<f32>((bitcast<u32>(_e1202) & 2147483647u));
                                                                            let _e1237 = bitcast<f32>((bitcast<u32>(_e1203) & 2147483647u));
                                                                            let _e1239 = select(_e1237, _e1234, (_e1234 > _e1237));
                                                                            let _e1242 = bitcast<f32>((bitcast<u32>(_e1204) & 2147483647u));
                                                                            let _e1244 = select(_e1242, _e1239, (_e1239 > _e1242));
                                                                            let _e1246 = select(_e1231, _e1218, (_e1218 > _e1231));
                                                                            let _e1248 = select(_e1244, _e1246, (_e1246 > _e1244));
                                                                            if (_e1218 == _e1248) {
                                                                                phi_2354_ = _e1059;
                                                                                phi_2355_ = _e1056;
                                                                                phi_2356_ = _e1050;
                                                                                phi_2357_ = _e1047;
                                                                                phi_2358_ = _e1191;
                                                                                phi_2359_ = _e1205;
                                                                                phi_2360_ = _e1201;
                                                                                phi_2361_ = _e1197;
                                                                            } else {
                                                                                let _e1250 = (_e1231 == _e1248);
                                                                                let _e1255 = vec3(_e1250);
                                                                                phi_2354_ = select(_e1050, _e1068, _e1250);
                                                                                phi_2355_ = select(_e1047, _e1065, _e1250);
                                                                                phi_2356_ = select(_e1068, _e1059, _e1250);
                                                                                phi_2357_ = select(_e1065, _e1056, _e1250);
                                                                                phi_2358_ = select(_e1193, _e1192, _e1255);
                                                                                phi_2359_ = select(_e1201, _e1197, _e1255);
                                                                                phi_2360_ = select(_e1197, _e1205, _e1255);
                                                                                phi_2361_ = select(_e1205, _e1201, _e1255);
                                                                            }
                                                                            let _e1261 = phi_2354_;
                                                                            let _e1263 = phi_2355_;
                                                                            let _e1265 = phi_2356_;
                                                                            let _e1267 = phi_2357_;
                                                                            let _e1269 = phi_2358_;
                                                                            let _e1271 = phi_2359_;
                                                                            let _e1273 = phi_2360_;
                                                                            let _e1275 = phi_2361_;
                                                                            let _e1282 = ((_e1273.y * _e1271.z) - (_e1271.y * _e1273.z));
                                                                            let _e1287 = ((_e1273.z * _e1271.x) - (_e1271.z * _e1273.x));
                                                                            let _e1290 = ((_e1273.x * _e1271.y) - (_e1271.x * _e1273.y));
                                                                            if (_e1090 >= _e1094) {
                                                                                phi_2398_ = select(true, false, (_e1090 >= _e1098));
                                                                            } else {
                                                                                phi_2398_ = true;
                                                                            }
                                                                            let _e1295 = phi_2398_;
                                                                            if _e1295 {
                                                                                phi_2407_ = select(_e1193, _e1192, vec3((_e1094 >= _e1098)));
                                                                            } else {
                                                                                phi_2407_ = _e1191;
                                                                            }
                                                                            let _e1300 = phi_2407_;
                                                                            let _e1311 = (((_e1282 * (_e1300.x - _e465)) + (_e1287 * (_e1300.y - _e532))) + (_e1290 * (_e1300.z - _e598)));
                                                                            let _e1316 = (((_e1282 * _e505) + (_e1287 * _e571)) + (_e1290 * _e637));
                                                                            let _e1317 = (_e1263 - _e1267);
                                                                            let _e1318 = (_e1261 - _e1265);
                                                                            let _e1326 = (-(((_e1267 * _e1317) + (_e1265 * _e1318))) / ((_e1317 * _e1317) + (_e1318 * _e1318)));
                                                                            let _e1328 = select(1f, _e1326, (_e1326 < 1f));
                                                                            let _e1330 = select(0f, _e1328, (_e1328 > 0f));
                                                                            let _e1343 = ((_e1269.x + (_e1275.x * _e1330)) - _e465);
                                                                            let _e1344 = ((_e1269.y + (_e1275.y * _e1330)) - _e532);
                                                                            let _e1345 = ((_e1269.z + (_e1275.z * _e1330)) - _e598);
                                                                            let _e1346 = (_e1345 / _e637);
                                                                            let _e1358 = bitcast<f32>((bitcast<u32>(_e1343) & 2147483647u));
                                                                            let _e1361 = bitcast<f32>((bitcast<u32>(_e1344) & 2147483647u));
                                                                            let _e1363 = select(_e1361, _e1358, (_e1358 > _e1361));
                                                                            let _e1366 = bitcast<f32>((bitcast<u32>(_e1345) & 2147483647u));
                                                                            let _e1368 = select(_e1366, _e1363, (_e1363 > _e1366));
                                                                            let _e1374 = bitcast<f32>((bitcast<u32>(_e1282) & 2147483647u));
                                                                            let _e1377 = bitcast<f32>((bitcast<u32>(_e1287) & 2147483647u));
                                                                            let _e1379 = select(_e1377, _e1374, (_e1374 > _e1377));
                                                                            let _e1382 = bitcast<f32>((bitcast<u32>(_e1290) & 2147483647u));
                                                                            if (bitcast<f32>((bitcast<u32>(((((_e1282 * _e1343) + (_e1287 * _e1344)) + (_e1290 * _e1345)) - _e1311)) & 2147483647u)) <= ((0.0000009536743f * select(_e1248, _e1368, (_e1368 > _e1248))) * select(_e1382, _e1379, (_e1379 > _e1382)))) {
                                                                                let _e1392 = bitcast<f32>((bitcast<u32>(_e1273.x) & 2147483647u));
                                                                                let _e1395 = bitcast<f32>((bitcast<u32>(_e1273.y) & 2147483647u));
                                                                                let _e1397 = select(_e1395, _e1392, (_e1392 > _e1395));
                                                                                let _e1400 = bitcast<f32>((bitcast<u32>(_e1273.z) & 2147483647u));
                                                                                let _e1406 = bitcast<f32>((bitcast<u32>(_e1271.x) & 2147483647u));
                                                                                let _e1409 = bitcast<f32>((bitcast<u32>(_e1271.y) & 2147483647u));
                                                                                let _e1411 = select(_e1409, _e1406, (_e1406 > _e1409));
                                                                                let _e1414 = bitcast<f32>((bitcast<u32>(_e1271.z) & 2147483647u));
                                                                                let _e1418 = (bitcast<f32>((bitcast<u32>(_e1316) & 2147483647u)) > ((0.0000038146973f * select(_e1400, _e1397, (_e1397 > _e1400))) * select(_e1414, _e1411, (_e1411 > _e1414))));
                                                                                if _e1418 {
                                                                                    phi_2572_ = (_e1311 / _e1316);
                                                                                } else {
                                                                                    phi_2572_ = f32();
                                                                                }
                                                                                let _e1421 = phi_2572_;
                                                                                phi_2574_ = _e1421;
                                                                                phi_2575_ = select(true, false, _e1418);
                                                                            } else {
                                                                                phi_2574_ = f32();
                                                                                phi_2575_ = true;
                                                                            }
                                                                            let _e1424 = phi_2574_;
                                                                            let _e1426 = phi_2575_;
                                                                            if _e1426 {
                                                                                let _e1434 = (((_e1282 * (_e1343 - (_e505 * _e1346))) + (_e1287 * (_e1344 - (_e571 * _e1346)))) / _e1316);
                                                                                if (bitcast<f32>((bitcast<u32>(_e1434) & 2147483647u)) <= _e1248) {
                                                                                    phi_2595_ = (_e1346 + _e1434);
                                                                                } else {
                                                                                    phi_2595_ = _e1346;
                                                                                }
                                                                                let _e1441 = phi_2595_;
                                                                                phi_2596_ = _e1441;
                                                                            } else {
                                                                                phi_2596_ = _e1424;
                                                                            }
                                                                            let _e1443 = phi_2596_;
                                                                            let _e1445 = select(_e1181, _e1443, (_e1443 < _e1181));
                                                                            let _e1447 = select(_e1173, _e1445, (_e1445 > _e1173));
                                                                            if (_e1447 >= _e751) {
                                                                                let _e1449 = (_e1447 <= _e840.member);
                                                                                if _e1449 {
                                                                                    let _e1450 = (1f / _e1100);
                                                                                    phi_2619_ = type_22(_e1447, (_e1094 * _e1450), (_e1098 * _e1450), _e868);
                                                                                } else {
                                                                                    phi_2619_ = type_22();
                                                                                }
                                                                                let _e1455 = phi_2619_;
                                                                                phi_2621_ = _e1455;
                                                                                phi_2622_ = select(true, false, _e1449);
                                                                            } else {
                                                                                phi_2621_ = type_22();
                                                                                phi_2622_ = true;
                                                                            }
                                                                            let _e1458 = phi_2621_;
                                                                            let _e1460 = phi_2622_;
                                                                            if _e1460 {
                                                                                phi_2626_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                            } else {
                                                                                phi_2626_ = _e1458;
                                                                            }
                                                                            let _e1462 = phi_2626_;
                                                                            phi_2627_ = _e1462;
                                                                        }
                                                                        let _e1464 = phi_2627_;
                                                                        phi_2628_ = _e1464;
                                                                        phi_2629_ = _e1190;
                                                                    }
                                                                    let _e1466 = phi_2628_;
                                                                    let _e1468 = phi_2629_;
                                                                    phi_2633_ = _e1466;
                                                                    phi_2634_ = _e1468;
                                                                }
                                                                let _e1470 = phi_2633_;
                                                                let _e1472 = phi_2634_;
                                                                phi_2635_ = _e1470;
                                                                phi_2636_ = _e1125;
                                                                phi_2637_ = _e1472;
                                                            }
                                                            let _e1474 = phi_2635_;
                                                            let _e1476 = phi_2636_;
                                                            let _e1478 = phi_2637_;
                                                            phi_2638_ = _e1474;
                                                            phi_2639_ = _e1476;
                                                            phi_2640_ = _e1478;
                                                        }
                                                        let _e1480 = phi_2638_;
                                                        let _e1482 = phi_2639_;
                                                        let _e1484 = phi_2640_;
                                                        phi_2648_ = _e1480;
                                                        phi_2649_ = select(_e1484, true, _e1482);
                                                    } else {
                                                        phi_2648_ = type_22();
                                                        phi_2649_ = true;
                                                    }
                                                    let _e1487 = phi_2648_;
                                                    let _e1489 = phi_2649_;
                                                    if _e1489 {
                                                        phi_2653_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                    } else {
                                                        phi_2653_ = _e1487;
                                                    }
                                                    let _e1491 = phi_2653_;
                                                    if (_e1491.member_3 != 4294967295u) {
                                                        if (_e868 == _e153) {
                                                            phi_2976_ = false;
                                                        } else {
                                                            let _e1495 = (_e868 < arrayLength((&global_5.member)));
                                                            if _e1495 {
                                                                if _e1495 {
                                                                } else {
                                                                    phi_4106_ = true;
                                                                    break;
                                                                }
                                                                let _e1497 = global_5.member[_e868];
                                                                phi_2676_ = _e1497;
                                                            } else {
                                                                phi_2676_ = 4294967295u;
                                                            }
                                                            let _e1499 = phi_2676_;
                                                            let _e1500 = (_e1499 < arrayLength((&global_6.member)));
                                                            if _e1500 {
                                                                if _e1500 {
                                                                } else {
                                                                    phi_4106_ = true;
                                                                    break;
                                                                }
                                                                let _e1502 = global_6.member[_e1499];
                                                                phi_2690_ = _e1502;
                                                            } else {
                                                                phi_2690_ = 0i;
                                                            }
                                                            let _e1504 = phi_2690_;
                                                            let _e1505 = (_e1504 == 0i);
                                                            if _e1505 {
                                                                phi_2975_ = true;
                                                            } else {
                                                                if _e442 {
                                                                    phi_2709_ = vec3<f32>(_e904, _e926, _e948);
                                                                } else {
                                                                    if (_e418 == 1u) {
                                                                        phi_2708_ = vec3<f32>(_e948, _e904, _e926);
                                                                    } else {
                                                                        phi_2708_ = vec3<f32>(_e926, _e948, _e904);
                                                                    }
                                                                    let _e1510 = phi_2708_;
                                                                    phi_2709_ = _e1510;
                                                                }
                                                                let _e1513 = phi_2709_;
                                                                if _e442 {
                                                                    phi_2724_ = vec3<f32>(_e964, _e979, _e994);
                                                                } else {
                                                                    if (_e418 == 1u) {
                                                                        phi_2723_ = vec3<f32>(_e994, _e964, _e979);
                                                                    } else {
                                                                        phi_2723_ = vec3<f32>(_e979, _e994, _e964);
                                                                    }
                                                                    let _e1518 = phi_2723_;
                                                                    phi_2724_ = _e1518;
                                                                }
                                                                let _e1521 = phi_2724_;
                                                                if _e442 {
                                                                    phi_2739_ = vec3<f32>(_e1010, _e1025, _e1040);
                                                                } else {
                                                                    if (_e418 == 1u) {
                                                                        phi_2738_ = vec3<f32>(_e1040, _e1010, _e1025);
                                                                    } else {
                                                                        phi_2738_ = vec3<f32>(_e1025, _e1040, _e1010);
                                                                    }
                                                                    let _e1526 = phi_2738_;
                                                                    phi_2739_ = _e1526;
                                                                }
                                                                let _e1529 = phi_2739_;
                                                                let _e1532 = (_e1521.x - _e1513.x);
                                                                let _e1535 = (_e1521.y - _e1513.y);
                                                                let _e1538 = (_e1521.z - _e1513.z);
                                                                let _e1540 = (_e1529.x - _e1513.x);
                                                                let _e1542 = (_e1529.y - _e1513.y);
                                                                let _e1544 = (_e1529.z - _e1513.z);
                                                                if (_e285.member_1 == 1u) {
                                                                    phi_2775_ = (vec3<f32>(_e285.member[0], _e285.member[1], _e285.member[2]) - _e1513);
                                                                } else {
                                                                    phi_2775_ = vec3<f32>(_e285.member[0], _e285.member[1], _e285.member[2]);
                                                                }
                                                                let _e1559 = phi_2775_;
                                                                let _e1565 = bitcast<f32>((bitcast<u32>((_e1532 * _e1542)) ^ _e285.member_3[0]));
                                                                let _e1569 = bitcast<f32>((bitcast<u32>((_e1535 * _e1540)) ^ _e285.member_3[0]));
                                                                let _e1573 = bitcast<f32>((bitcast<u32>((_e1535 * _e1544)) ^ _e285.member_3[0]));
                                                                let _e1577 = bitcast<f32>((bitcast<u32>((_e1538 * _e1542)) ^ _e285.member_3[0]));
                                                                let _e1581 = bitcast<f32>((bitcast<u32>((_e1538 * _e1540)) ^ _e285.member_3[0]));
                                                                let _e1585 = bitcast<f32>((bitcast<u32>((_e1532 * _e1544)) ^ _e285.member_3[0]));
                                                                let _e1586 = (_e1573 - _e1577);
                                                                let _e1587 = (_e1581 - _e1585);
                                                                let _e1588 = (_e1565 - _e1569);
                                                                let _e1612 = (bitcast<f32>((bitcast<u32>(_e1573) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1577) & 2147483647u)));
                                                                let _e1619 = (bitcast<f32>((bitcast<u32>(_e1581) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1585) & 2147483647u)));
                                                                let _e1626 = (bitcast<f32>((bitcast<u32>(_e1565) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1569) & 2147483647u)));
                                                                if (_e285.member_2 == 0f) {
                                                                    phi_2957_ = 0f;
                                                                } else {
                                                                    let _e1656 = bitcast<f32>((bitcast<u32>(_e1586) & 2147483647u));
                                                                    let _e1659 = bitcast<f32>((bitcast<u32>(_e1587) & 2147483647u));
                                                                    let _e1662 = bitcast<f32>((bitcast<u32>(_e1588) & 2147483647u));
                                                                    let _e1664 = select(_e1662, _e1659, (_e1659 > _e1662));
                                                                    let _e1668 = select(_e1662, _e1659, (_e1659 < _e1662));
                                                                    let _e1672 = select(_e1659, _e1656, (_e1656 < _e1659));
                                                                    let _e1674 = select(_e1659, _e1656, (_e1656 > _e1659));
                                                                    let _e1676 = select(_e1662, _e1674, (_e1674 < _e1662));
                                                                    phi_2957_ = bitcast<f32>((bitcast<u32>((_e285.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1664, _e1656, (_e1656 > _e1664)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1676, _e1672, (_e1672 > _e1676)))) ^ _e285.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1668, _e1656, (_e1656 < _e1668)))) ^ _e285.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1612 + _e1619) + _e1626))) ^ _e285.member_3[0]))) * 1.0000005f)) ^ _e285.member_3[0])))) ^ _e285.member_3[0]));
                                                                }
                                                                let _e1703 = phi_2957_;
                                                                phi_2975_ = (_e1505 || !(((((bitcast<f32>((bitcast<u32>((_e1559.x * _e1586)) ^ _e285.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1559.y * _e1587)) ^ _e285.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1559.z * _e1588)) ^ _e285.member_3[0]))) * f32(-(_e1504))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1559.x) & 2147483647u)) * _e1612)) ^ _e285.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1559.y) & 2147483647u)) * _e1619)) ^ _e285.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1559.z) & 2147483647u)) * _e1626)) ^ _e285.member_3[0]))))) ^ _e285.member_3[0])) + _e1703) + 0.0000000000000000000000000000000000001880791f))));
                                                            }
                                                            let _e1717 = phi_2975_;
                                                            phi_2976_ = _e1717;
                                                        }
                                                        let _e1719 = phi_2976_;
                                                        if _e1719 {
                                                            phi_2981_ = type_40(_e840.member, true);
                                                        } else {
                                                            phi_2981_ = _e840;
                                                        }
                                                        let _e1724 = phi_2981_;
                                                        phi_2982_ = _e1724;
                                                    } else {
                                                        phi_2982_ = _e840;
                                                    }
                                                    let _e1726 = phi_2982_;
                                                    phi_1426_ = _e1726;
                                                } else {
                                                    phi_1426_ = type_40();
                                                }
                                                let _e1728 = phi_1426_;
                                                continue;
                                                continuing {
                                                    phi_1425_ = _e1728;
                                                    phi_1428_ = _e855;
                                                    phi_4106_ = _e783;
                                                    break if !(_e861);
                                                }
                                            }
                                            let _e1731 = phi_4106_;
                                            phi_4316_ = _e1731;
                                            if _e1731 {
                                                break;
                                            }
                                            phi_4375_ = _e1731;
                                            let _e2293 = local_11;
                                            phi_2983_ = _e2293;
                                        } else {
                                            phi_4375_ = _e783;
                                            phi_2983_ = _e785;
                                        }
                                        let _e1733 = phi_4375_;
                                        let _e1735 = phi_2983_;
                                        if _e832 {
                                            phi_3990_ = bool();
                                            phi_3991_ = u32();
                                            phi_3992_ = type_62();
                                        } else {
                                            let _e1736 = (_e828.member_1 < _e93);
                                            if _e1736 {
                                                if _e1736 {
                                                } else {
                                                    phi_4316_ = true;
                                                    break;
                                                }
                                                let _e1738 = global_9.member[_e828.member_1];
                                                phi_3004_ = _e1738;
                                            } else {
                                                phi_3004_ = type_49(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                            }
                                            let _e1740 = phi_3004_;
                                            let _e1755 = ((10u * _e418) & 31u);
                                            let _e1758 = ((_e1740.member[0] >> bitcast<u32>(_e1755)) & 1023u);
                                            let _e1766 = bitcast<f32>((bitcast<u32>(((_e828.member.member_1[0] - _e828.member.member[0]) * 0.0009775171f)) ^ _e136));
                                            let _e1771 = (_e828.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1758)) - 8388608f) * _e1766)) ^ _e136)));
                                            let _e1775 = select(select(_e828.member.member_1[0], _e1771, (_e1771 < _e828.member.member_1[0])), _e828.member.member_1[0], (_e1758 == 1023u));
                                            let _e1777 = ((10u * _e417) & 31u);
                                            let _e1780 = ((_e1740.member[0] >> bitcast<u32>(_e1777)) & 1023u);
                                            let _e1788 = bitcast<f32>((bitcast<u32>(((_e828.member.member_1[1] - _e828.member.member[1]) * 0.0009775171f)) ^ _e136));
                                            let _e1793 = (_e828.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1780)) - 8388608f) * _e1788)) ^ _e136)));
                                            let _e1797 = select(select(_e828.member.member_1[1], _e1793, (_e1793 < _e828.member.member_1[1])), _e828.member.member_1[1], (_e1780 == 1023u));
                                            let _e1799 = ((10u * _e419) & 31u);
                                            let _e1802 = ((_e1740.member[0] >> bitcast<u32>(_e1799)) & 1023u);
                                            let _e1810 = bitcast<f32>((bitcast<u32>(((_e828.member.member_1[2] - _e828.member.member[2]) * 0.0009775171f)) ^ _e136));
                                            let _e1815 = (_e828.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1802)) - 8388608f) * _e1810)) ^ _e136)));
                                            let _e1819 = select(select(_e828.member.member_1[2], _e1815, (_e1815 < _e828.member.member_1[2])), _e828.member.member_1[2], (_e1802 == 1023u));
                                            let _e1822 = ((_e1740.member[1] >> bitcast<u32>(_e1755)) & 1023u);
                                            let _e1830 = (_e828.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1822)) - 8388608f) * _e1766)) ^ _e136)));
                                            let _e1834 = select(select(_e828.member.member_1[0], _e1830, (_e1830 < _e828.member.member_1[0])), _e828.member.member_1[0], (_e1822 == 1023u));
                                            let _e1837 = ((_e1740.member[1] >> bitcast<u32>(_e1777)) & 1023u);
                                            let _e1845 = (_e828.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1837)) - 8388608f) * _e1788)) ^ _e136)));
                                            let _e1849 = select(select(_e828.member.member_1[1], _e1845, (_e1845 < _e828.member.member_1[1])), _e828.member.member_1[1], (_e1837 == 1023u));
                                            let _e1852 = ((_e1740.member[1] >> bitcast<u32>(_e1799)) & 1023u);
                                            let _e1860 = (_e828.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1852)) - 8388608f) * _e1810)) ^ _e136)));
                                            let _e1864 = select(select(_e828.member.member_1[2], _e1860, (_e1860 < _e828.member.member_1[2])), _e828.member.member_1[2], (_e1852 == 1023u));
                                            let _e1870 = ((_e1740.member_1[0] >> bitcast<u32>(_e1755)) & 1023u);
                                            let _e1878 = (_e828.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1870)) - 8388608f) * _e1766)) ^ _e136)));
                                            let _e1882 = select(select(_e828.member.member_1[0], _e1878, (_e1878 < _e828.member.member_1[0])), _e828.member.member_1[0], (_e1870 == 1023u));
                                            let _e1885 = ((_e1740.member_1[0] >> bitcast<u32>(_e1777)) & 1023u);
                                            let _e1893 = (_e828.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1885)) - 8388608f) * _e1788)) ^ _e136)));
                                            let _e1897 = select(select(_e828.member.member_1[1], _e1893, (_e1893 < _e828.member.member_1[1])), _e828.member.member_1[1], (_e1885 == 1023u));
                                            let _e1900 = ((_e1740.member_1[0] >> bitcast<u32>(_e1799)) & 1023u);
                                            let _e1908 = (_e828.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1900)) - 8388608f) * _e1810)) ^ _e136)));
                                            let _e1912 = select(select(_e828.member.member_1[2], _e1908, (_e1908 < _e828.member.member_1[2])), _e828.member.member_1[2], (_e1900 == 1023u));
                                            let _e1915 = ((_e1740.member_1[1] >> bitcast<u32>(_e1755)) & 1023u);
                                            let _e1923 = (_e828.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1915)) - 8388608f) * _e1766)) ^ _e136)));
                                            let _e1927 = select(select(_e828.member.member_1[0], _e1923, (_e1923 < _e828.member.member_1[0])), _e828.member.member_1[0], (_e1915 == 1023u));
                                            let _e1930 = ((_e1740.member_1[1] >> bitcast<u32>(_e1777)) & 1023u);
                                            let _e1938 = (_e828.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1930)) - 8388608f) * _e1788)) ^ _e136)));
                                            let _e1942 = select(select(_e828.member.member_1[1], _e1938, (_e1938 < _e828.member.member_1[1])), _e828.member.member_1[1], (_e1930 == 1023u));
                                            let _e1945 = ((_e1740.member_1[1] >> bitcast<u32>(_e1799)) & 1023u);
                                            let _e1953 = (_e828.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1945)) - 8388608f) * _e1810)) ^ _e136)));
                                            let _e1957 = select(select(_e828.member.member_1[2], _e1953, (_e1953 < _e828.member.member_1[2])), _e828.member.member_1[2], (_e1945 == 1023u));
                                            let _e1962 = type_62(type_54(array<f32, 3>(_e1775, _e1797, _e1819), array<f32, 3>(_e1834, _e1849, _e1864)), _e1740.member_2);
                                            let _e1967 = type_62(type_54(array<f32, 3>(_e1882, _e1897, _e1912), array<f32, 3>(_e1927, _e1942, _e1957)), _e1740.member_3);
                                            let _e1973 = ((_e1775 - _e503) * _e508);
                                            let _e1974 = ((_e1882 - _e503) * _e508);
                                            let _e1975 = ((_e1834 - _e504) * _e508);
                                            let _e1976 = ((_e1927 - _e504) * _e508);
                                            let _e1981 = ((_e1797 - _e569) * _e574);
                                            let _e1982 = ((_e1897 - _e569) * _e574);
                                            let _e1983 = ((_e1849 - _e570) * _e574);
                                            let _e1984 = ((_e1942 - _e570) * _e574);
                                            let _e1989 = ((_e1819 - _e635) * _e640);
                                            let _e1990 = ((_e1912 - _e635) * _e640);
                                            let _e1991 = ((_e1864 - _e636) * _e640);
                                            let _e1992 = ((_e1957 - _e636) * _e640);
                                            let _e1994 = select(_e1991, _e1989, (_e1989 < _e1991));
                                            let _e1996 = select(_e1992, _e1990, (_e1990 < _e1992));
                                            let _e1998 = select(_e1991, _e1989, (_e1989 > _e1991));
                                            let _e2000 = select(_e1992, _e1990, (_e1990 > _e1992));
                                            let _e2002 = select(_e1975, _e1973, (_e1973 < _e1975));
                                            let _e2004 = select(_e1976, _e1974, (_e1974 < _e1976));
                                            let _e2006 = select(_e1983, _e1981, (_e1981 < _e1983));
                                            let _e2008 = select(_e1984, _e1982, (_e1982 < _e1984));
                                            let _e2010 = select(_e2006, _e2002, (_e2002 > _e2006));
                                            let _e2012 = select(_e2008, _e2004, (_e2004 > _e2008));
                                            let _e2014 = select(_e1994, _e2010, (_e2010 > _e1994));
                                            let _e2016 = select(_e1996, _e2012, (_e2012 > _e1996));
                                            let _e2018 = select(_e1975, _e1973, (_e1973 > _e1975));
                                            let _e2020 = select(_e1976, _e1974, (_e1974 > _e1976));
                                            let _e2022 = select(_e1983, _e1981, (_e1981 > _e1983));
                                            let _e2024 = select(_e1984, _e1982, (_e1982 > _e1984));
                                            let _e2026 = select(_e2022, _e2018, (_e2018 < _e2022));
                                            let _e2028 = select(_e2024, _e2020, (_e2020 < _e2024));
                                            let _e2033 = -(_e1994);
                                            let _e2034 = -(_e1996);
                                            let _e2041 = (select(_e1998, _e2026, (_e2026 < _e1998)) + (select(_e2033, _e1998, (_e1998 > _e2033)) * 0.0000019073523f));
                                            let _e2042 = (select(_e2000, _e2028, (_e2028 < _e2000)) + (select(_e2034, _e2000, (_e2000 > _e2034)) * 0.0000019073523f));
                                            let _e2044 = select(_e751, _e2014, (_e2014 > _e751));
                                            let _e2046 = select(_e751, _e2016, (_e2016 > _e751));
                                            let _e2051 = (_e2044 <= select(_e1735.member, _e2041, (_e2041 < _e1735.member)));
                                            let _e2052 = (_e2046 <= select(_e1735.member, _e2042, (_e2042 < _e1735.member)));
                                            let _e2053 = (_e2044 <= _e2046);
                                            if _e2051 {
                                                if _e2052 {
                                                    if _e2053 {
                                                        phi_3890_ = _e1967;
                                                    } else {
                                                        phi_3890_ = _e1962;
                                                    }
                                                    let _e2055 = phi_3890_;
                                                    let _e2062 = (_e826 % 128u);
                                                    let _e2063 = (_e2062 < 128u);
                                                    if _e2063 {
                                                    } else {
                                                        phi_4316_ = true;
                                                        break;
                                                    }
                                                    local_6[_e2062] = _e2055.member_1;
                                                    if _e2063 {
                                                    } else {
                                                        phi_4316_ = true;
                                                        break;
                                                    }
                                                    local_5[_e2062] = _e2055.member.member[0];
                                                    if _e2063 {
                                                    } else {
                                                        phi_4316_ = true;
                                                        break;
                                                    }
                                                    local_4[_e2062] = _e2055.member.member[1];
                                                    if _e2063 {
                                                    } else {
                                                        phi_4316_ = true;
                                                        break;
                                                    }
                                                    local_3[_e2062] = _e2055.member.member[2];
                                                    if _e2063 {
                                                    } else {
                                                        phi_4316_ = true;
                                                        break;
                                                    }
                                                    local_2[_e2062] = _e2055.member.member_1[0];
                                                    if _e2063 {
                                                    } else {
                                                        phi_4316_ = true;
                                                        break;
                                                    }
                                                    local_1[_e2062] = _e2055.member.member_1[1];
                                                    if _e2063 {
                                                    } else {
                                                        phi_4316_ = true;
                                                        break;
                                                    }
                                                    local[_e2062] = _e2055.member.member_1[2];
                                                    if _e2063 {
                                                    } else {
                                                        phi_4316_ = true;
                                                        break;
                                                    }
                                                    local_7[_e2062] = select(_e2044, _e2046, _e2053);
                                                    if _e2053 {
                                                        phi_3966_ = _e1962;
                                                    } else {
                                                        phi_3966_ = _e1967;
                                                    }
                                                    let _e2080 = phi_3966_;
                                                    phi_3967_ = (_e826 + 1u);
                                                    phi_3968_ = _e2080;
                                                } else {
                                                    phi_3967_ = u32();
                                                    phi_3968_ = type_62();
                                                }
                                                let _e2082 = phi_3967_;
                                                let _e2084 = phi_3968_;
                                                phi_3970_ = _e2082;
                                                phi_3971_ = _e2084;
                                                phi_3972_ = select(true, false, _e2052);
                                            } else {
                                                phi_3970_ = u32();
                                                phi_3971_ = type_62();
                                                phi_3972_ = true;
                                            }
                                            let _e2087 = phi_3970_;
                                            let _e2089 = phi_3971_;
                                            let _e2091 = phi_3972_;
                                            if _e2091 {
                                                if _e2051 {
                                                    phi_3979_ = _e1962;
                                                } else {
                                                    phi_3979_ = _e1967;
                                                }
                                                let _e2093 = phi_3979_;
                                                phi_3984_ = select(_e2052, true, _e2051);
                                                phi_3986_ = _e2093;
                                            } else {
                                                phi_3984_ = _e824;
                                                phi_3986_ = _e2089;
                                            }
                                            let _e2096 = phi_3984_;
                                            let _e2098 = phi_3986_;
                                            phi_3990_ = _e2096;
                                            phi_3991_ = select(_e2087, _e826, _e2091);
                                            phi_3992_ = _e2098;
                                        }
                                        let _e2101 = phi_3990_;
                                        let _e2103 = phi_3991_;
                                        let _e2105 = phi_3992_;
                                        if _e832 {
                                            phi_4002_ = select(_e826, 0u, _e1735.member_1);
                                            phi_4003_ = _e828;
                                        } else {
                                            phi_4002_ = _e2103;
                                            phi_4003_ = _e2105;
                                        }
                                        let _e2109 = phi_4002_;
                                        let _e2111 = phi_4003_;
                                        phi_4319_ = _e1733;
                                        phi_4004_ = _e1735;
                                        phi_4005_ = (_e787 - 1u);
                                        phi_4006_ = select(_e2101, false, _e832);
                                        phi_4007_ = _e2109;
                                        phi_4008_ = _e2111;
                                    } else {
                                        phi_4319_ = _e783;
                                        phi_4004_ = _e785;
                                        phi_4005_ = _e787;
                                        phi_4006_ = _e824;
                                        phi_4007_ = _e826;
                                        phi_4008_ = _e828;
                                    }
                                    let _e2114 = phi_4319_;
                                    let _e2116 = phi_4004_;
                                    let _e2118 = phi_4005_;
                                    let _e2120 = phi_4006_;
                                    let _e2122 = phi_4007_;
                                    let _e2124 = phi_4008_;
                                    phi_4318_ = _e2114;
                                    phi_4009_ = _e2116;
                                    phi_4010_ = _e2118;
                                    phi_4011_ = _e2120;
                                    phi_4012_ = _e2122;
                                    phi_4013_ = _e2124;
                                } else {
                                    phi_4318_ = _e783;
                                    phi_4009_ = type_40();
                                    phi_4010_ = u32();
                                    phi_4011_ = bool();
                                    phi_4012_ = u32();
                                    phi_4013_ = type_62();
                                }
                                let _e2126 = phi_4318_;
                                let _e2128 = phi_4009_;
                                let _e2130 = phi_4010_;
                                let _e2132 = phi_4011_;
                                let _e2134 = phi_4012_;
                                let _e2136 = phi_4013_;
                                phi_4317_ = _e2126;
                                phi_1299_ = _e2128;
                                phi_1302_ = _e2130;
                                phi_1304_ = _e2132;
                                phi_1306_ = _e2134;
                                phi_1308_ = _e2136;
                                phi_4014_ = _e797;
                            } else {
                                phi_4317_ = _e783;
                                phi_1299_ = type_40();
                                phi_1302_ = u32();
                                phi_1304_ = bool();
                                phi_1306_ = u32();
                                phi_1308_ = type_62();
                                phi_4014_ = false;
                            }
                            let _e2138 = phi_4317_;
                            let _e2140 = phi_1299_;
                            let _e2142 = phi_1302_;
                            let _e2144 = phi_1304_;
                            let _e2146 = phi_1306_;
                            let _e2148 = phi_1308_;
                            let _e2150 = phi_4014_;
                            continue;
                            continuing {
                                phi_4112_ = _e2138;
                                phi_1298_ = _e2140;
                                phi_1301_ = _e2142;
                                phi_1303_ = _e2144;
                                phi_1305_ = _e2146;
                                phi_1307_ = _e2148;
                                phi_4316_ = _e2138;
                                break if !(_e2150);
                            }
                        }
                        let _e2153 = phi_4316_;
                        if _e2153 {
                            break;
                        }
                        let _e2155 = local_10;
                        if _e2155.member_1 {
                        } else {
                            if _e286 {
                            } else {
                                break;
                            }
                            let _e2159 = global_2.member[_e140];
                            if _e147 {
                            } else {
                                break;
                            }
                            let _e2163 = global_8.member[_e140].member_1;
                            if _e286 {
                            } else {
                                break;
                            }
                            global_2.member[_e140] = type_24(_e2159.member, _e2159.member_1, _e2159.member_2, array<f32, 3>((_e2159.member_3[0] + (_e2163[0] * _e2159.member_1[0])), (_e2159.member_3[1] + (_e2163[1] * _e2159.member_1[1])), (_e2159.member_3[2] + (_e2163[2] * _e2159.member_1[2]))), _e2159.member_4);
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
