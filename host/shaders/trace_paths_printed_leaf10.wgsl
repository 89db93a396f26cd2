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

struct type_24 {
    member: array<type_22>,
}

struct type_26 {
    member: array<f32, 3>,
    member_1: f32,
    member_2: array<f32, 3>,
    member_3: f32,
}

struct type_27 {
    member: type_26,
    member_1: array<f32, 3>,
    member_2: u32,
    member_3: array<f32, 3>,
    member_4: u32,
}

struct type_29 {
    member: array<type_27>,
}

struct type_35 {
    member: array<f32, 3>,
    member_1: u32,
    member_2: f32,
    member_3: array<u32, 3>,
}

struct type_38 {
    member: type_22,
    member_1: f32,
}

struct type_41 {
    member: array<vec4<u32>, 2>,
}

struct type_44 {
    member: array<i32>,
}

struct type_48 {
    member: array<u32, 2>,
    member_1: array<u32, 2>,
    member_2: u32,
    member_3: u32,
}

struct type_50 {
    member: array<type_48>,
}

struct type_53 {
    member: array<f32, 3>,
    member_1: array<f32, 3>,
}

struct type_55 {
    member: array<u32, 3>,
    member_1: u32,
}

struct type_57 {
    member: array<type_55>,
}

struct type_61 {
    member: type_53,
    member_1: u32,
}

struct type_66 {
    member: array<atomic<u32>>,
}

var<private> global: vec3<u32>;
@group(0) @binding(0) 
var<uniform> global_1: type_12;
@group(0) @binding(1) 
var<uniform> global_2: type_41;
@group(0) @binding(2) 
var<uniform> global_3: type_41;
@group(0) @binding(5) 
var<storage> global_4: type_4;
@group(0) @binding(6) 
var<storage> global_5: type_44;
@group(0) @binding(7) 
var<storage> global_6: type_29;
@group(0) @binding(8) 
var<storage, read_write> global_7: type_24;
@group(0) @binding(9) 
var<storage, read_write> global_8: type_66;
@group(0) @binding(3) 
var<storage> global_9: type_50;
@group(0) @binding(4) 
var<storage> global_10: type_57;

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
    var phi_367_: u32;
    var phi_411_: i32;
    var phi_551_: type_35;
    var phi_657_: i32;
    var phi_658_: i32;
    var phi_668_: bool;
    var phi_678_: u32;
    var phi_679_: u32;
    var phi_681_: bool;
    var phi_686_: u32;
    var phi_719_: i32;
    var phi_737_: f32;
    var phi_743_: f32;
    var phi_783_: f32;
    var phi_789_: f32;
    var phi_841_: f32;
    var phi_853_: f32;
    var phi_862_: f32;
    var phi_868_: f32;
    var phi_908_: f32;
    var phi_914_: f32;
    var phi_966_: f32;
    var phi_978_: f32;
    var phi_987_: f32;
    var phi_993_: f32;
    var phi_1033_: f32;
    var phi_1039_: f32;
    var phi_1091_: f32;
    var phi_1103_: f32;
    var phi_1158_: i32;
    var phi_1180_: u32;
    var phi_1181_: u32;
    var phi_1218_: i32;
    var phi_1240_: u32;
    var phi_1241_: u32;
    var phi_1249_: f32;
    var phi_1250_: f32;
    var phi_4347_: bool;
    var phi_1333_: type_38;
    var phi_1336_: u32;
    var phi_1338_: bool;
    var phi_1340_: u32;
    var phi_1342_: type_61;
    var phi_1353_: bool;
    var phi_1439_: bool;
    var phi_1440_: u32;
    var phi_1441_: type_61;
    var phi_1460_: type_38;
    var phi_1463_: type_8;
    var phi_1464_: type_8;
    var phi_1486_: type_8;
    var phi_1511_: u32;
    var phi_1527_: type_55;
    var phi_1965_: bool;
    var phi_1994_: bool;
    var phi_2389_: f32;
    var phi_2390_: f32;
    var phi_2391_: f32;
    var phi_2392_: f32;
    var phi_2393_: vec3<f32>;
    var phi_2394_: vec3<f32>;
    var phi_2395_: vec3<f32>;
    var phi_2396_: vec3<f32>;
    var phi_2433_: bool;
    var phi_2442_: vec3<f32>;
    var phi_2607_: f32;
    var phi_2609_: f32;
    var phi_2610_: bool;
    var phi_2630_: f32;
    var phi_2631_: f32;
    var phi_2654_: type_22;
    var phi_2656_: type_22;
    var phi_2657_: bool;
    var phi_2661_: type_22;
    var phi_2662_: type_22;
    var phi_2663_: type_22;
    var phi_2664_: bool;
    var phi_2668_: type_22;
    var phi_2669_: bool;
    var phi_2670_: type_22;
    var phi_2671_: bool;
    var phi_2672_: bool;
    var phi_2673_: type_22;
    var phi_2674_: bool;
    var phi_2675_: bool;
    var phi_2683_: type_22;
    var phi_2684_: bool;
    var phi_2688_: type_22;
    var phi_2711_: u32;
    var phi_2725_: i32;
    var phi_2743_: vec3<f32>;
    var phi_2744_: vec3<f32>;
    var phi_2758_: vec3<f32>;
    var phi_2759_: vec3<f32>;
    var phi_2773_: vec3<f32>;
    var phi_2774_: vec3<f32>;
    var phi_2810_: vec3<f32>;
    var phi_2992_: f32;
    var phi_3010_: bool;
    var phi_3011_: bool;
    var phi_3030_: bool;
    var phi_3031_: bool;
    var phi_3037_: type_38;
    var phi_3038_: type_38;
    var phi_3039_: type_38;
    var phi_1461_: type_38;
    var phi_4341_: bool;
    var phi_4610_: bool;
    var phi_3040_: type_38;
    var phi_3061_: type_48;
    var phi_3947_: type_61;
    var phi_4023_: type_61;
    var phi_4024_: u32;
    var phi_4025_: type_61;
    var phi_4027_: u32;
    var phi_4028_: type_61;
    var phi_4029_: bool;
    var phi_4036_: type_61;
    var phi_4041_: bool;
    var phi_4043_: type_61;
    var phi_4047_: bool;
    var phi_4048_: u32;
    var phi_4049_: type_61;
    var phi_4059_: type_61;
    var phi_4554_: bool;
    var phi_4060_: type_38;
    var phi_4061_: u32;
    var phi_4062_: bool;
    var phi_4063_: u32;
    var phi_4064_: type_61;
    var phi_4553_: bool;
    var phi_4065_: type_38;
    var phi_4066_: u32;
    var phi_4067_: bool;
    var phi_4068_: u32;
    var phi_4069_: type_61;
    var phi_4552_: bool;
    var phi_1334_: type_38;
    var phi_1337_: u32;
    var phi_1339_: bool;
    var phi_1341_: u32;
    var phi_1343_: type_61;
    var phi_4070_: bool;
    var phi_4551_: bool;
    var local_10: type_38;
    var phi_4108_: f32;
    var phi_4110_: f32;
    var phi_4111_: bool;
    var phi_4112_: f32;
    var phi_4113_: bool;
    var phi_4261_: u32;
    var phi_4279_: bool;
    var phi_4282_: bool;
    var phi_4295_: f32;
    var phi_4296_: f32;
    var phi_4301_: f32;
    var phi_4302_: f32;
    var phi_4303_: bool;
    var phi_4311_: f32;
    var phi_4128_: f32;
    var phi_4129_: f32;
    var phi_4141_: f32;
    var phi_4146_: type_22;
    var local_11: type_38;

    switch bitcast<i32>(0u) {
        default: {
            let _e93 = global;
            let _e96 = arrayLength((&global_9.member));
            let _e111 = arrayLength((&global_8.member));
            let _e115 = global_3.member[0u][0u];
            let _e119 = global_3.member[0u][1u];
            let _e123 = global_3.member[0u][2u];
            let _e127 = global_3.member[1u][0u];
            let _e131 = global_3.member[1u][1u];
            let _e135 = global_3.member[1u][2u];
            let _e139 = global_3.member[1u][3u];
            let _e143 = (_e93.x + (_e93.y * 2097152u));
            let _e150 = (_e143 < arrayLength((&global_6.member)));
            if _e150 {
                if _e150 {
                } else {
                    break;
                }
                let _e154 = global_6.member[_e143].member_2;
                phi_367_ = _e154;
            } else {
                phi_367_ = 4294967295u;
            }
            let _e156 = phi_367_;
            let _e159 = global_1.member[0u];
            let _e163 = global_2.member[0u][0u];
            let _e167 = global_2.member[0u][1u];
            let _e171 = global_2.member[0u][2u];
            let _e175 = global_2.member[0u][3u];
            let _e179 = global_2.member[1u][0u];
            let _e183 = global_2.member[1u][1u];
            let _e187 = global_2.member[1u][2u];
            let _e191 = global_2.member[1u][3u];
            let _e192 = bitcast<f32>(_e163);
            let _e193 = bitcast<f32>(_e167);
            let _e194 = bitcast<f32>(_e171);
            let _e196 = bitcast<f32>(_e179);
            let _e197 = array<u32, 3>(_e183, _e187, _e191);
            let _e199 = bitcast<i32>(_e159);
            if (_e199 < -126i) {
                phi_411_ = -126i;
            } else {
                phi_411_ = select(_e199, 127i, (_e199 > 127i));
            }
            let _e204 = phi_411_;
            let _e209 = bitcast<f32>((bitcast<u32>((_e204 + 127i)) << bitcast<u32>(23i)));
            let _e215 = bitcast<f32>((bitcast<u32>(((_e199 - _e204) + 127i)) << bitcast<u32>(23i)));
            if (_e175 == 0u) {
                phi_551_ = type_35(array<f32, 3>(_e192, _e193, _e194), _e175, _e196, _e197);
            } else {
                let _e217 = bitcast<u32>(_e192);
                let _e219 = ((_e217 & 2139095040u) != 0u);
                let _e234 = bitcast<u32>(_e193);
                let _e236 = ((_e234 & 2139095040u) != 0u);
                let _e251 = bitcast<u32>(_e194);
                let _e253 = ((_e251 & 2139095040u) != 0u);
                let _e269 = bitcast<u32>(_e196);
                let _e271 = ((_e269 & 2139095040u) != 0u);
                phi_551_ = type_35(array<f32, 3>((((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e217 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e217 & 2147483648u))), _e192, _e219) * _e209) * select(0.00000011920929f, 1f, _e219)) * _e215), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e234 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e234 & 2147483648u))), _e193, _e236) * _e209) * select(0.00000011920929f, 1f, _e236)) * _e215), (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e251 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e251 & 2147483648u))), _e194, _e253) * _e209) * select(0.00000011920929f, 1f, _e253)) * _e215)), _e175, (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e269 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e269 & 2147483648u))), _e196, _e271) * _e209) * select(0.00000011920929f, 1f, _e271)) * _e215), _e197);
            }
            let _e288 = phi_551_;
            if _e150 {
                let _e289 = (_e143 < arrayLength((&global_7.member)));
                if _e289 {
                    if _e150 {
                    } else {
                        break;
                    }
                    let _e299 = global_6.member[_e143].member.member_2[0u];
                    let _e301 = (bitcast<u32>(_e299) & 2147483647u);
                    let _e307 = global_6.member[_e143].member.member_2[1u];
                    let _e309 = (bitcast<u32>(_e307) & 2147483647u);
                    let _e315 = global_6.member[_e143].member.member_2[2u];
                    let _e317 = (bitcast<u32>(_e315) & 2147483647u);
                    let _e323 = global_6.member[_e143].member.member[0u];
                    let _e325 = (bitcast<u32>(_e323) & 2147483647u);
                    let _e331 = global_6.member[_e143].member.member[1u];
                    let _e333 = (bitcast<u32>(_e331) & 2147483647u);
                    let _e339 = global_6.member[_e143].member.member[2u];
                    let _e341 = (bitcast<u32>(_e339) & 2147483647u);
                    let _e343 = select(_e309, _e301, (_e309 < _e301));
                    let _e345 = select(_e317, _e343, (_e317 < _e343));
                    let _e347 = select(_e325, _e345, (_e325 < _e345));
                    let _e349 = select(_e333, _e347, (_e333 < _e347));
                    let _e351 = select(_e341, _e349, (_e341 < _e349));
                    let _e356 = global_6.member[_e143].member.member_1;
                    let _e357 = bitcast<u32>(_e356);
                    let _e358 = (_e357 & 2147483647u);
                    let _e366 = global_6.member[_e143].member.member_3;
                    let _e367 = bitcast<u32>(_e366);
                    let _e368 = (_e367 & 2147483647u);
                    let _e372 = (((select(_e358, _e351, (_e358 < _e351)) < 2139095040u) && (_e368 <= 2139095040u)) && (_e345 > 0u));
                    if _e372 {
                        let _e375 = (bitcast<u32>(bitcast<f32>(_e345)) & 2147483647u);
                        if (_e375 >= 8388608u) {
                            phi_657_ = (bitcast<i32>((_e375 >> bitcast<u32>(23i))) - 127i);
                        } else {
                            phi_657_ = (-118i - bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e375)), 32u, (_e375 == 0u))));
                        }
                        let _e389 = phi_657_;
                        phi_658_ = _e389;
                    } else {
                        phi_658_ = 0i;
                    }
                    let _e391 = phi_658_;
                    let _e392 = (_e301 == _e345);
                    if _e392 {
                        phi_668_ = true;
                    } else {
                        phi_668_ = (_e309 == _e345);
                    }
                    let _e395 = phi_668_;
                    let _e396 = select(1u, 0u, _e392);
                    if _e395 {
                        let _e397 = (_e396 + 1u);
                        phi_678_ = _e397;
                        phi_679_ = _e397;
                        phi_681_ = select(true, false, (_e397 == 2u));
                    } else {
                        phi_678_ = u32();
                        phi_679_ = 0u;
                        phi_681_ = true;
                    }
                    let _e401 = phi_678_;
                    let _e403 = phi_679_;
                    let _e405 = phi_681_;
                    if _e405 {
                        phi_686_ = (_e403 + 1u);
                    } else {
                        phi_686_ = 0u;
                    }
                    let _e409 = phi_686_;
                    let _e410 = select(_e401, _e403, _e405);
                    let _e411 = select(_e396, select(2u, _e396, _e395), _e405);
                    let _e412 = -(_e391);
                    if (_e412 < -126i) {
                        phi_719_ = -126i;
                    } else {
                        phi_719_ = select(_e412, 127i, (_e412 > 127i));
                    }
                    let _e417 = phi_719_;
                    let _e422 = bitcast<f32>((bitcast<u32>((_e417 + 127i)) << bitcast<u32>(23i)));
                    let _e428 = bitcast<f32>((bitcast<u32>(((_e412 - _e417) + 127i)) << bitcast<u32>(23i)));
                    let _e433 = global_6.member[_e143].member.member;
                    let _e434 = (_e410 == 0u);
                    if _e434 {
                        phi_737_ = _e433[0];
                    } else {
                        phi_737_ = _e433[1];
                    }
                    let _e438 = phi_737_;
                    let _e439 = (_e410 == 2u);
                    if _e439 {
                        phi_743_ = _e433[2];
                    } else {
                        phi_743_ = _e438;
                    }
                    let _e442 = phi_743_;
                    let _e443 = bitcast<u32>(_e442);
                    let _e445 = ((_e443 & 2139095040u) != 0u);
                    let _e457 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e443 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e443 & 2147483648u))), _e442, _e445) * select(0.00000011920929f, 1f, _e445));
                    let _e458 = global_6.member[_e143].member.member_2;
                    if _e434 {
                        phi_783_ = _e458[0];
                    } else {
                        phi_783_ = _e458[1];
                    }
                    let _e462 = phi_783_;
                    if _e439 {
                        phi_789_ = _e458[2];
                    } else {
                        phi_789_ = _e462;
                    }
                    let _e465 = phi_789_;
                    let _e466 = bitcast<u32>(_e465);
                    let _e468 = ((_e466 & 2139095040u) != 0u);
                    let _e482 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e466 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e466 & 2147483648u))), _e465, _e468) * _e422) * select(0.00000011920929f, 1f, _e468)) * _e428);
                    let _e486 = (bitcast<f32>((bitcast<u32>(_e482) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e486 {
                        let _e490 = (bitcast<f32>((bitcast<u32>(_e457) & 2147483647u)) * 0.00000011920929f);
                        phi_841_ = select(0.00000000000011368684f, _e490, (_e490 > 0.00000000000011368684f));
                    } else {
                        phi_841_ = 0f;
                    }
                    let _e494 = phi_841_;
                    let _e495 = (_e457 + _e494);
                    let _e496 = (_e457 - _e494);
                    let _e497 = select(_e482, 0f, _e486);
                    if _e486 {
                        phi_853_ = 38685626000000000000000000f;
                    } else {
                        phi_853_ = (1f / _e482);
                    }
                    let _e500 = phi_853_;
                    let _e501 = (_e409 == 0u);
                    if _e501 {
                        phi_862_ = _e433[0];
                    } else {
                        phi_862_ = _e433[1];
                    }
                    let _e505 = phi_862_;
                    let _e506 = (_e409 == 2u);
                    if _e506 {
                        phi_868_ = _e433[2];
                    } else {
                        phi_868_ = _e505;
                    }
                    let _e509 = phi_868_;
                    let _e510 = bitcast<u32>(_e509);
                    let _e512 = ((_e510 & 2139095040u) != 0u);
                    let _e524 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e510 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e510 & 2147483648u))), _e509, _e512) * select(0.00000011920929f, 1f, _e512));
                    if _e501 {
                        phi_908_ = _e458[0];
                    } else {
                        phi_908_ = _e458[1];
                    }
                    let _e528 = phi_908_;
                    if _e506 {
                        phi_914_ = _e458[2];
                    } else {
                        phi_914_ = _e528;
                    }
                    let _e531 = phi_914_;
                    let _e532 = bitcast<u32>(_e531);
                    let _e534 = ((_e532 & 2139095040u) != 0u);
                    let _e548 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e532 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e532 & 2147483648u))), _e531, _e534) * _e422) * select(0.00000011920929f, 1f, _e534)) * _e428);
                    let _e552 = (bitcast<f32>((bitcast<u32>(_e548) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e552 {
                        let _e556 = (bitcast<f32>((bitcast<u32>(_e524) & 2147483647u)) * 0.00000011920929f);
                        phi_966_ = select(0.00000000000011368684f, _e556, (_e556 > 0.00000000000011368684f));
                    } else {
                        phi_966_ = 0f;
                    }
                    let _e560 = phi_966_;
                    let _e561 = (_e524 + _e560);
                    let _e562 = (_e524 - _e560);
                    let _e563 = select(_e548, 0f, _e552);
                    if _e552 {
                        phi_978_ = 38685626000000000000000000f;
                    } else {
                        phi_978_ = (1f / _e548);
                    }
                    let _e566 = phi_978_;
                    let _e567 = (_e411 == 0u);
                    if _e567 {
                        phi_987_ = _e433[0];
                    } else {
                        phi_987_ = _e433[1];
                    }
                    let _e571 = phi_987_;
                    let _e572 = (_e411 == 2u);
                    if _e572 {
                        phi_993_ = _e433[2];
                    } else {
                        phi_993_ = _e571;
                    }
                    let _e575 = phi_993_;
                    let _e576 = bitcast<u32>(_e575);
                    let _e578 = ((_e576 & 2139095040u) != 0u);
                    let _e590 = (select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e576 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e576 & 2147483648u))), _e575, _e578) * select(0.00000011920929f, 1f, _e578));
                    if _e567 {
                        phi_1033_ = _e458[0];
                    } else {
                        phi_1033_ = _e458[1];
                    }
                    let _e594 = phi_1033_;
                    if _e572 {
                        phi_1039_ = _e458[2];
                    } else {
                        phi_1039_ = _e594;
                    }
                    let _e597 = phi_1039_;
                    let _e598 = bitcast<u32>(_e597);
                    let _e600 = ((_e598 & 2139095040u) != 0u);
                    let _e614 = (((select(bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | (_e598 & 8388607u))) - 8388608f) * 0.000000000000000000000000000000000000011754944f)) | (_e598 & 2147483648u))), _e597, _e600) * _e422) * select(0.00000011920929f, 1f, _e600)) * _e428);
                    let _e618 = (bitcast<f32>((bitcast<u32>(_e614) & 2147483647u)) < 0.00000000000000000086736174f);
                    if _e618 {
                        let _e622 = (bitcast<f32>((bitcast<u32>(_e590) & 2147483647u)) * 0.00000011920929f);
                        phi_1091_ = select(0.00000000000011368684f, _e622, (_e622 > 0.00000000000011368684f));
                    } else {
                        phi_1091_ = 0f;
                    }
                    let _e626 = phi_1091_;
                    let _e627 = (_e590 + _e626);
                    let _e628 = (_e590 - _e626);
                    let _e629 = select(_e614, 0f, _e618);
                    if _e618 {
                        phi_1103_ = 38685626000000000000000000f;
                    } else {
                        phi_1103_ = (1f / _e614);
                    }
                    let _e632 = phi_1103_;
                    let _e635 = bitcast<f32>((bitcast<u32>(_e457) & 2147483647u));
                    let _e638 = bitcast<f32>((bitcast<u32>(_e524) & 2147483647u));
                    let _e640 = select(_e638, _e635, (_e635 > _e638));
                    let _e643 = bitcast<f32>((bitcast<u32>(_e590) & 2147483647u));
                    if (_e372 && (select(_e643, _e640, (_e640 > _e643)) <= 1099511600000f)) {
                        let _e655 = ((_e358 & 8388607u) | (select(0u, 1u, ((_e358 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e658 = bitcast<i32>((_e358 >> bitcast<u32>(23i)));
                        let _e662 = (_e655 == 0u);
                        let _e665 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e655)), 32u, _e662)) - 8i);
                        if (_e658 == 255i) {
                            phi_1158_ = 255i;
                        } else {
                            phi_1158_ = (((_e658 + select(0i, 1i, (_e658 == 0i))) - _e665) + _e391);
                        }
                        let _e673 = phi_1158_;
                        let _e683 = (_e673 <= 0i);
                        if _e683 {
                            phi_1181_ = u32();
                        } else {
                            if _e662 {
                                phi_1180_ = u32();
                            } else {
                                phi_1180_ = select(((bitcast<u32>(_e673) << bitcast<u32>(23i)) | ((_e655 << bitcast<u32>(((_e665 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e673 >= 255i));
                            }
                            let _e687 = phi_1180_;
                            phi_1181_ = _e687;
                        }
                        let _e689 = phi_1181_;
                        let _e701 = ((_e368 & 8388607u) | (select(0u, 1u, ((_e368 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                        let _e704 = bitcast<i32>((_e368 >> bitcast<u32>(23i)));
                        let _e708 = (_e701 == 0u);
                        let _e711 = (bitcast<i32>(select((bitcast<u32>(31i) - firstLeadingBit(_e701)), 32u, _e708)) - 8i);
                        if (_e704 == 255i) {
                            phi_1218_ = 255i;
                        } else {
                            phi_1218_ = (((_e704 + select(0i, 1i, (_e704 == 0i))) - _e711) + _e391);
                        }
                        let _e719 = phi_1218_;
                        let _e729 = (_e719 <= 0i);
                        if _e729 {
                            phi_1241_ = u32();
                        } else {
                            if _e708 {
                                phi_1240_ = u32();
                            } else {
                                phi_1240_ = select(((bitcast<u32>(_e719) << bitcast<u32>(23i)) | ((_e701 << bitcast<u32>(((_e711 & 31i) & 31i))) & 8388607u)), 2139095039u, (_e719 >= 255i));
                            }
                            let _e733 = phi_1240_;
                            phi_1241_ = _e733;
                        }
                        let _e735 = phi_1241_;
                        phi_1249_ = bitcast<f32>(((_e367 & 2147483648u) | select(_e735, 0u, select(_e708, true, _e729))));
                        phi_1250_ = bitcast<f32>(((_e357 & 2147483648u) | select(_e689, 0u, select(_e662, true, _e683))));
                    } else {
                        phi_1249_ = 0f;
                        phi_1250_ = 1f;
                    }
                    let _e741 = phi_1249_;
                    let _e743 = phi_1250_;
                    local_6 = array<u32, 128>(0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u, 0u);
                    local_5 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_4 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_3 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_2 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_1 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_7 = array<f32, 128>(0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f, 0f);
                    local_9 = array<f32, 3>(bitcast<f32>(_e115), bitcast<f32>(_e119), bitcast<f32>(_e123));
                    let _e748 = (_e410 % 3u);
                    let _e749 = (_e748 < 3u);
                    if _e749 {
                    } else {
                        break;
                    }
                    let _e751 = local_9[_e748];
                    let _e752 = (_e409 % 3u);
                    let _e753 = (_e752 < 3u);
                    if _e753 {
                    } else {
                        break;
                    }
                    let _e755 = local_9[_e752];
                    let _e756 = (_e411 % 3u);
                    let _e757 = (_e756 < 3u);
                    if _e757 {
                    } else {
                        break;
                    }
                    let _e759 = local_9[_e756];
                    local_8 = array<f32, 3>(bitcast<f32>(_e127), bitcast<f32>(_e131), bitcast<f32>(_e135));
                    if _e749 {
                    } else {
                        break;
                    }
                    let _e763 = local_8[_e748];
                    if _e753 {
                    } else {
                        break;
                    }
                    let _e765 = local_8[_e752];
                    if _e757 {
                    } else {
                        break;
                    }
                    let _e767 = local_8[_e756];
                    phi_4347_ = false;
                    phi_1333_ = type_38(type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u), _e741);
                    phi_1336_ = ((3u * _e96) + 1u);
                    phi_1338_ = (_e743 <= _e741);
                    phi_1340_ = 0u;
                    phi_1342_ = type_61(type_53(array<f32, 3>(_e751, _e755, _e759), array<f32, 3>(_e763, _e765, _e767)), select(0u, 2147483648u, (_e96 == 0u)));
                    loop {
                        let _e775 = phi_4347_;
                        let _e777 = phi_1333_;
                        let _e779 = phi_1336_;
                        let _e781 = phi_1338_;
                        let _e783 = phi_1340_;
                        let _e785 = phi_1342_;
                        local_10 = _e777;
                        if _e781 {
                            phi_1353_ = true;
                        } else {
                            phi_1353_ = (_e783 > 0u);
                        }
                        let _e788 = phi_1353_;
                        if _e788 {
                            let _e789 = (_e779 > 0u);
                            if _e789 {
                                if _e781 {
                                    phi_1439_ = _e781;
                                    phi_1440_ = _e783;
                                    phi_1441_ = _e785;
                                } else {
                                    let _e790 = (_e783 - 1u);
                                    let _e791 = (_e790 % 128u);
                                    let _e792 = (_e791 < 128u);
                                    if _e792 {
                                    } else {
                                        phi_4551_ = true;
                                        break;
                                    }
                                    let _e794 = local_6[_e791];
                                    if _e792 {
                                    } else {
                                        phi_4551_ = true;
                                        break;
                                    }
                                    let _e796 = local_5[_e791];
                                    if _e792 {
                                    } else {
                                        phi_4551_ = true;
                                        break;
                                    }
                                    let _e798 = local_4[_e791];
                                    if _e792 {
                                    } else {
                                        phi_4551_ = true;
                                        break;
                                    }
                                    let _e800 = local_3[_e791];
                                    if _e792 {
                                    } else {
                                        phi_4551_ = true;
                                        break;
                                    }
                                    let _e803 = local_2[_e791];
                                    if _e792 {
                                    } else {
                                        phi_4551_ = true;
                                        break;
                                    }
                                    let _e805 = local_1[_e791];
                                    if _e792 {
                                    } else {
                                        phi_4551_ = true;
                                        break;
                                    }
                                    let _e807 = local[_e791];
                                    if _e792 {
                                    } else {
                                        phi_4551_ = true;
                                        break;
                                    }
                                    let _e812 = local_7[_e791];
                                    phi_1439_ = (_e812 <= _e777.member_1);
                                    phi_1440_ = _e790;
                                    phi_1441_ = type_61(type_53(array<f32, 3>(_e796, _e798, _e800), array<f32, 3>(_e803, _e805, _e807)), _e794);
                                }
                                let _e816 = phi_1439_;
                                let _e818 = phi_1440_;
                                let _e820 = phi_1441_;
                                if _e816 {
                                    let _e824 = ((_e820.member_1 & 2147483648u) != 0u);
                                    if _e824 {
                                        phi_1460_ = _e777;
                                        phi_1463_ = type_8(0u, ((_e820.member_1 >> bitcast<u32>(28u)) & 7u));
                                        loop {
                                            let _e832 = phi_1460_;
                                            let _e834 = phi_1463_;
                                            local_11 = _e832;
                                            if (_e834.member < _e834.member_1) {
                                                phi_1464_ = type_8((_e834.member + 1u), _e834.member_1);
                                                phi_1486_ = type_8(1u, _e834.member);
                                            } else {
                                                phi_1464_ = _e834;
                                                phi_1486_ = type_8(0u, type_8().member_1);
                                            }
                                            let _e847 = phi_1464_;
                                            let _e849 = phi_1486_;
                                            let _e853 = (bitcast<i32>(_e849.member) != 0i);
                                            if _e853 {
                                                let _e854 = ((_e820.member_1 & 268435455u) + _e849.member_1);
                                                let _e855 = (_e854 < arrayLength((&global_10.member)));
                                                if _e855 {
                                                    if _e855 {
                                                    } else {
                                                        phi_4341_ = true;
                                                        break;
                                                    }
                                                    let _e858 = global_10.member[_e854].member_1;
                                                    phi_1511_ = _e858;
                                                } else {
                                                    phi_1511_ = 4294967295u;
                                                }
                                                let _e860 = phi_1511_;
                                                if _e855 {
                                                    if _e855 {
                                                    } else {
                                                        phi_4341_ = true;
                                                        break;
                                                    }
                                                    let _e862 = global_10.member[_e854];
                                                    phi_1527_ = _e862;
                                                } else {
                                                    phi_1527_ = type_55(array<u32, 3>(0u, 0u, 0u), 4294967295u);
                                                }
                                                let _e864 = phi_1527_;
                                                let _e876 = ((10u * _e410) & 31u);
                                                let _e879 = ((_e864.member[0] >> bitcast<u32>(_e876)) & 1023u);
                                                let _e887 = bitcast<f32>((bitcast<u32>(((_e820.member.member_1[0] - _e820.member.member[0]) * 0.0009775171f)) ^ _e139));
                                                let _e892 = (_e820.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e879)) - 8388608f) * _e887)) ^ _e139)));
                                                let _e896 = select(select(_e820.member.member_1[0], _e892, (_e892 < _e820.member.member_1[0])), _e820.member.member_1[0], (_e879 == 1023u));
                                                let _e898 = ((10u * _e409) & 31u);
                                                let _e901 = ((_e864.member[0] >> bitcast<u32>(_e898)) & 1023u);
                                                let _e909 = bitcast<f32>((bitcast<u32>(((_e820.member.member_1[1] - _e820.member.member[1]) * 0.0009775171f)) ^ _e139));
                                                let _e914 = (_e820.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e901)) - 8388608f) * _e909)) ^ _e139)));
                                                let _e918 = select(select(_e820.member.member_1[1], _e914, (_e914 < _e820.member.member_1[1])), _e820.member.member_1[1], (_e901 == 1023u));
                                                let _e920 = ((10u * _e411) & 31u);
                                                let _e923 = ((_e864.member[0] >> bitcast<u32>(_e920)) & 1023u);
                                                let _e931 = bitcast<f32>((bitcast<u32>(((_e820.member.member_1[2] - _e820.member.member[2]) * 0.0009775171f)) ^ _e139));
                                                let _e936 = (_e820.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e923)) - 8388608f) * _e931)) ^ _e139)));
                                                let _e940 = select(select(_e820.member.member_1[2], _e936, (_e936 < _e820.member.member_1[2])), _e820.member.member_1[2], (_e923 == 1023u));
                                                let _e944 = ((_e864.member[1] >> bitcast<u32>(_e876)) & 1023u);
                                                let _e952 = (_e820.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e944)) - 8388608f) * _e887)) ^ _e139)));
                                                let _e956 = select(select(_e820.member.member_1[0], _e952, (_e952 < _e820.member.member_1[0])), _e820.member.member_1[0], (_e944 == 1023u));
                                                let _e959 = ((_e864.member[1] >> bitcast<u32>(_e898)) & 1023u);
                                                let _e967 = (_e820.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e959)) - 8388608f) * _e909)) ^ _e139)));
                                                let _e971 = select(select(_e820.member.member_1[1], _e967, (_e967 < _e820.member.member_1[1])), _e820.member.member_1[1], (_e959 == 1023u));
                                                let _e974 = ((_e864.member[1] >> bitcast<u32>(_e920)) & 1023u);
                                                let _e982 = (_e820.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e974)) - 8388608f) * _e931)) ^ _e139)));
                                                let _e986 = select(select(_e820.member.member_1[2], _e982, (_e982 < _e820.member.member_1[2])), _e820.member.member_1[2], (_e974 == 1023u));
                                                let _e990 = ((_e864.member[2] >> bitcast<u32>(_e876)) & 1023u);
                                                let _e998 = (_e820.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e990)) - 8388608f) * _e887)) ^ _e139)));
                                                let _e1002 = select(select(_e820.member.member_1[0], _e998, (_e998 < _e820.member.member_1[0])), _e820.member.member_1[0], (_e990 == 1023u));
                                                let _e1005 = ((_e864.member[2] >> bitcast<u32>(_e898)) & 1023u);
                                                let _e1013 = (_e820.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1005)) - 8388608f) * _e909)) ^ _e139)));
                                                let _e1017 = select(select(_e820.member.member_1[1], _e1013, (_e1013 < _e820.member.member_1[1])), _e820.member.member_1[1], (_e1005 == 1023u));
                                                let _e1020 = ((_e864.member[2] >> bitcast<u32>(_e920)) & 1023u);
                                                let _e1028 = (_e820.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1020)) - 8388608f) * _e931)) ^ _e139)));
                                                let _e1032 = select(select(_e820.member.member_1[2], _e1028, (_e1028 < _e820.member.member_1[2])), _e820.member.member_1[2], (_e1020 == 1023u));
                                                let _e1036 = (_e940 - _e590);
                                                let _e1039 = (((_e896 - _e457) * _e629) - (_e1036 * _e497));
                                                let _e1042 = (((_e918 - _e524) * _e629) - (_e1036 * _e563));
                                                let _e1045 = (_e986 - _e590);
                                                let _e1048 = (((_e956 - _e457) * _e629) - (_e1045 * _e497));
                                                let _e1051 = (((_e971 - _e524) * _e629) - (_e1045 * _e563));
                                                let _e1054 = (_e1032 - _e590);
                                                let _e1057 = (((_e1002 - _e457) * _e629) - (_e1054 * _e497));
                                                let _e1060 = (((_e1017 - _e524) * _e629) - (_e1054 * _e563));
                                                let _e1061 = (_e1057 * _e1051);
                                                let _e1062 = (_e1060 * _e1048);
                                                let _e1063 = (_e1039 * _e1060);
                                                let _e1064 = (_e1042 * _e1057);
                                                let _e1065 = (_e1048 * _e1042);
                                                let _e1066 = (_e1051 * _e1039);
                                                let _e1071 = (((_e1061 >= _e1062) && (_e1063 >= _e1064)) && (_e1065 >= _e1066));
                                                if (_e1071 || (((_e1061 <= _e1062) && (_e1063 <= _e1064)) && (_e1065 <= _e1066))) {
                                                    let _e1078 = select(-1f, 1f, _e1071);
                                                    let _e1080 = ((_e1061 - _e1062) * _e1078);
                                                    let _e1082 = select(0f, _e1080, (_e1080 > 0f));
                                                    let _e1084 = ((_e1063 - _e1064) * _e1078);
                                                    let _e1086 = select(0f, _e1084, (_e1084 > 0f));
                                                    let _e1088 = ((_e1065 - _e1066) * _e1078);
                                                    let _e1090 = select(0f, _e1088, (_e1088 > 0f));
                                                    let _e1092 = ((_e1082 + _e1086) + _e1090);
                                                    if (_e1092 < 0.000000000000000000000000000000000000011754944f) {
                                                        phi_2673_ = type_22();
                                                        phi_2674_ = true;
                                                        phi_2675_ = false;
                                                    } else {
                                                        let _e1095 = select(_e1048, _e1039, (_e1039 < _e1048));
                                                        if (select(_e1057, _e1095, (_e1095 < _e1057)) > 0f) {
                                                            phi_1965_ = true;
                                                        } else {
                                                            let _e1100 = select(_e1048, _e1039, (_e1039 > _e1048));
                                                            phi_1965_ = (select(_e1057, _e1100, (_e1100 > _e1057)) < 0f);
                                                        }
                                                        let _e1105 = phi_1965_;
                                                        if _e1105 {
                                                            phi_2670_ = type_22();
                                                            phi_2671_ = true;
                                                            phi_2672_ = false;
                                                        } else {
                                                            let _e1107 = select(_e1051, _e1042, (_e1042 < _e1051));
                                                            if (select(_e1060, _e1107, (_e1107 < _e1060)) > 0f) {
                                                                phi_1994_ = true;
                                                            } else {
                                                                let _e1112 = select(_e1051, _e1042, (_e1042 > _e1051));
                                                                phi_1994_ = (select(_e1060, _e1112, (_e1112 > _e1060)) < 0f);
                                                            }
                                                            let _e1117 = phi_1994_;
                                                            if _e1117 {
                                                                phi_2668_ = type_22();
                                                                phi_2669_ = false;
                                                            } else {
                                                                let _e1119 = select(_e956, _e896, (_e896 < _e956));
                                                                let _e1123 = select(_e956, _e896, (_e896 > _e956));
                                                                let _e1127 = select(_e971, _e918, (_e918 < _e971));
                                                                let _e1131 = select(_e971, _e918, (_e918 > _e971));
                                                                let _e1135 = select(_e986, _e940, (_e940 < _e986));
                                                                let _e1139 = select(_e986, _e940, (_e940 > _e986));
                                                                let _e1144 = ((select(_e1002, _e1119, (_e1119 < _e1002)) - _e495) * _e500);
                                                                let _e1145 = ((select(_e1002, _e1123, (_e1123 > _e1002)) - _e496) * _e500);
                                                                let _e1148 = ((select(_e1017, _e1127, (_e1127 < _e1017)) - _e561) * _e566);
                                                                let _e1149 = ((select(_e1017, _e1131, (_e1131 > _e1017)) - _e562) * _e566);
                                                                let _e1152 = ((select(_e1032, _e1135, (_e1135 < _e1032)) - _e627) * _e632);
                                                                let _e1153 = ((select(_e1032, _e1139, (_e1139 > _e1032)) - _e628) * _e632);
                                                                let _e1155 = select(_e1153, _e1152, (_e1152 < _e1153));
                                                                let _e1157 = select(_e1153, _e1152, (_e1152 > _e1153));
                                                                let _e1159 = select(_e1145, _e1144, (_e1144 < _e1145));
                                                                let _e1161 = select(_e1149, _e1148, (_e1148 < _e1149));
                                                                let _e1163 = select(_e1161, _e1159, (_e1159 > _e1161));
                                                                let _e1165 = select(_e1155, _e1163, (_e1163 > _e1155));
                                                                let _e1167 = select(_e1145, _e1144, (_e1144 > _e1145));
                                                                let _e1169 = select(_e1149, _e1148, (_e1148 > _e1149));
                                                                let _e1171 = select(_e1169, _e1167, (_e1167 < _e1169));
                                                                let _e1173 = select(_e1157, _e1171, (_e1171 < _e1157));
                                                                let _e1174 = -(_e1155);
                                                                let _e1180 = select(_e743, _e1165, (_e1165 > _e743));
                                                                if (_e1180 > (_e1173 + (select(_e1174, _e1157, (_e1157 > _e1174)) * 0.0000019073523f))) {
                                                                    phi_2663_ = type_22();
                                                                    phi_2664_ = true;
                                                                } else {
                                                                    let _e1182 = (_e1180 > _e832.member_1);
                                                                    if _e1182 {
                                                                        phi_2662_ = type_22();
                                                                    } else {
                                                                        let _e1183 = vec3<f32>(_e896, _e918, _e940);
                                                                        let _e1184 = vec3<f32>(_e956, _e971, _e986);
                                                                        let _e1185 = vec3<f32>(_e1002, _e1017, _e1032);
                                                                        let _e1186 = (_e956 - _e896);
                                                                        let _e1187 = (_e971 - _e918);
                                                                        let _e1188 = (_e986 - _e940);
                                                                        let _e1189 = vec3<f32>(_e1186, _e1187, _e1188);
                                                                        let _e1190 = (_e1002 - _e956);
                                                                        let _e1191 = (_e1017 - _e971);
                                                                        let _e1192 = (_e1032 - _e986);
                                                                        let _e1193 = vec3<f32>(_e1190, _e1191, _e1192);
                                                                        let _e1194 = (_e896 - _e1002);
                                                                        let _e1195 = (_e918 - _e1017);
                                                                        let _e1196 = (_e940 - _e1032);
                                                                        let _e1197 = vec3<f32>(_e1194, _e1195, _e1196);
                                                                        let _e1200 = bitcast<f32>((bitcast<u32>(_e1186) & 2147483647u));
                                                                        let _e1203 = bitcast<f32>((bitcast<u32>(_e1187) & 2147483647u));
                                                                        let _e1205 = select(_e1203, _e1200, (_e1200 > _e1203));
                                                                        let _e1208 = bitcast<f32>((bitcast<u32>(_e1188) & 2147483647u));
                                                                        let _e1210 = select(_e1208, _e1205, (_e1205 > _e1208));
                                                                        let _e1213 = bitcast<f32>((bitcast<u32>(_e1190) & 2147483647u));
                                                                        let _e1216 = bitcast<f32>((bitcast<u32>(_e1191) & 2147483647u));
                                                                        let _e1218 = select(_e1216, _e1213, (_e1213 > _e1216));
                                                                        let _e1221 = bitcast<f32>((bitcast<u32>(_e1192) & 2147483647u));
                                                                        let _e1223 = select(_e1221, _e1218, (_e1218 > _e1221));
                                                                        let _e1226 = bitcast<f32>((bitcast<u32>(_e1194) & 2147483647u));
                                                                        let _e1229 = bitcast<f32>((bitcast<u32>(_e1195) & 2147483647u));
                                                                        let _e1231 = select(_e1229, _e1226, (_e1226 > _e1229));
                                                                        let _e1234 = bitcast<f32>((bitcast<u32>(_e1196) & 2147483647u));
                                                                        let _e1236 = select(_e1234, _e1231, (_e1231 > _e1234));
                                                                        let _e1238 = select(_e1223, _e1210, (_e1210 > _e1223));
                                                                        let _e1240 = select(_e1236, _e1238, (_e1238 > _e1236));
                                                                        if (_e1210 == _e1240) {
                                                                            phi_2389_ = _e1051;
                                                                            phi_2390_ = _e1048;
                                                                            phi_2391_ = _e1042;
                                                                            phi_2392_ = _e1039;
                                                                            phi_2393_ = _e1183;
                                                                            phi_2394_ = _e1197;
                                                                            phi_2395_ = _e1193;
                                                                            phi_2396_ = _e1189;
                                                                        } else {
                                                                            let _e1242 = (_e1223 == _e1240);
                                                                            let _e1247 = vec3(_e1242);
                                                                            phi_2389_ = select(_e1042, _e1060, _e1242);
                                                                            phi_2390_ = select(_e1039, _e1057, _e1242);
                                                                            phi_2391_ = select(_e1060, _e1051, _e1242);
                                                                            phi_2392_ = select(_e1057, _e1048, _e1242);
                                                                            phi_2393_ = select(_e1185, _e1184, _e1247);
                                                                            phi_2394_ = select(_e1193, _e1189, _e1247);
                                                                            phi_2395_ = select(_e1189, _e1197, _e1247);
                                                                            phi_2396_ = select(_e1197, _e1193, _e1247);
                                                                        }
                                                                        let _e1253 = phi_2389_;
                                                                        let _e1255 = phi_2390_;
                                                                        let _e1257 = phi_2391_;
                                                                        let _e1259 = phi_2392_;
                                                                        let _e1261 = phi_2393_;
                                                                        let _e1263 = phi_2394_;
                                                                        let _e1265 = phi_2395_;
                                                                        let _e1267 = phi_2396_;
                                                                        let _e1274 = ((_e1265.y * _e1263.z) - (_e1263.y * _e1265.z));
                                                                        let _e1279 = ((_e1265.z * _e1263.x) - (_e1263.z * _e1265.x));
                                                                        let _e1282 = ((_e1265.x * _e1263.y) - (_e1263.x * _e1265.y));
                                                                        if (_e1082 >= _e1086) {
                                                                            phi_2433_ = select(true, false, (_e1082 >= _e1090));
                                                                        } else {
                                                                            phi_2433_ = true;
                                                                        }
                                                                        let _e1287 = phi_2433_;
                                                                        if _e1287 {
                                                                            phi_2442_ = select(_e1185, _e1184, vec3((_e1086 >= _e1090)));
                                                                        } else {
                                                                            phi_2442_ = _e1183;
                                                                        }
                                                                        let _e1292 = phi_2442_;
                                                                        let _e1303 = (((_e1274 * (_e1292.x - _e457)) + (_e1279 * (_e1292.y - _e524))) + (_e1282 * (_e1292.z - _e590)));
                                                                        let _e1308 = (((_e1274 * _e497) + (_e1279 * _e563)) + (_e1282 * _e629));
                                                                        let _e1309 = (_e1255 - _e1259);
                                                                        let _e1310 = (_e1253 - _e1257);
                                                                        let _e1318 = (-(((_e1259 * _e1309) + (_e1257 * _e1310))) / ((_e1309 * _e1309) + (_e1310 * _e1310)));
                                                                        let _e1320 = select(1f, _e1318, (_e1318 < 1f));
                                                                        let _e1322 = select(0f, _e1320, (_e1320 > 0f));
                                                                        let _e1335 = ((_e1261.x + (_e1267.x * _e1322)) - _e457);
                                                                        let _e1336 = ((_e1261.y + (_e1267.y * _e1322)) - _e524);
                                                                        let _e1337 = ((_e1261.z + (_e1267.z * _e1322)) - _e590);
                                                                        let _e1338 = (_e1337 / _e629);
                                                                        let _e1350 = bitcast<f32>((bitcast<u32>(_e1335) & 2147483647u));
                                                                        let _e1353 = bitcast<f32>((bitcast<u32>(_e1336) & 2147483647u));
                                                                        let _e1355 = select(_e1353, _e1350, (_e1350 > _e1353));
                                                                        let _e1358 = bitcast<f32>((bitcast<u32>(_e1337) & 2147483647u));
                                                                        let _e1360 = select(_e1358, _e1355, (_e1355 > _e1358));
                                                                        let _e1366 = bitcast<f32>((bitcast<u32>(_e1274) & 2147483647u));
                                                                        let _e1369 = bitcast<f32>((bitcast<u32>(_e1279) & 2147483647u));
                                                                        let _e1371 = select(_e1369, _e1366, (_e1366 > _e1369));
                                                                        let _e1374 = bitcast<f32>((bitcast<u32>(_e1282) & 2147483647u));
                                                                        if (bitcast<f32>((bitcast<u32>(((((_e1274 * _e1335) + (_e1279 * _e1336)) + (_e1282 * _e1337)) - _e1303)) & 2147483647u)) <= ((0.0000009536743f * select(_e1240, _e1360, (_e1360 > _e1240))) * select(_e1374, _e1371, (_e1371 > _e1374)))) {
                                                                            let _e1384 = bitcast<f32>((bitcast<u32>(_e1265.x) & 2147483647u));
                                                                            let _e1387 = bitcast<f32>((bitcast<u32>(_e1265.y) & 2147483647u));
                                                                            let _e1389 = select(_e1387, _e1384, (_e1384 > _e1387));
                                                                            let _e1392 = bitcast<f32>((bitcast<u32>(_e1265.z) & 2147483647u));
                                                                            let _e1398 = bitcast<f32>((bitcast<u32>(_e1263.x) & 2147483647u));
                                                                            let _e1401 = bitcast<f32>((bitcast<u32>(_e1263.y) & 2147483647u));
                                                                            let _e1403 = select(_e1401, _e1398, (_e1398 > _e1401));
                                                                            let _e1406 = bitcast<f32>((bitcast<u32>(_e1263.z) & 2147483647u));
                                                                            let _e1410 = (bitcast<f32>((bitcast<u32>(_e1308) & 2147483647u)) > ((0.0000038146973f * select(_e1392, _e1389, (_e1389 > _e1392))) * select(_e1406, _e1403, (_e1403 > _e1406))));
                                                                            if _e1410 {
                                                                                phi_2607_ = (_e1303 / _e1308);
                                                                            } else {
                                                                                phi_2607_ = f32();
                                                                            }
                                                                            let _e1413 = phi_2607_;
                                                                            phi_2609_ = _e1413;
                                                                            phi_2610_ = select(true, false, _e1410);
                                                                        } else {
                                                                            phi_2609_ = f32();
                                                                            phi_2610_ = true;
                                                                        }
                                                                        let _e1416 = phi_2609_;
                                                                        let _e1418 = phi_2610_;
                                                                        if _e1418 {
                                                                            let _e1426 = (((_e1274 * (_e1335 - (_e497 * _e1338))) + (_e1279 * (_e1336 - (_e563 * _e1338)))) / _e1308);
                                                                            if (bitcast<f32>((bitcast<u32>(_e1426) & 2147483647u)) <= _e1240) {
                                                                                phi_2630_ = (_e1338 + _e1426);
                                                                            } else {
                                                                                phi_2630_ = _e1338;
                                                                            }
                                                                            let _e1433 = phi_2630_;
                                                                            phi_2631_ = _e1433;
                                                                        } else {
                                                                            phi_2631_ = _e1416;
                                                                        }
                                                                        let _e1435 = phi_2631_;
                                                                        let _e1437 = select(_e1173, _e1435, (_e1435 < _e1173));
                                                                        let _e1439 = select(_e1165, _e1437, (_e1437 > _e1165));
                                                                        if (_e1439 >= _e743) {
                                                                            let _e1441 = (_e1439 <= _e832.member_1);
                                                                            if _e1441 {
                                                                                let _e1442 = (1f / _e1092);
                                                                                phi_2654_ = type_22(_e1439, (_e1086 * _e1442), (_e1090 * _e1442), _e860);
                                                                            } else {
                                                                                phi_2654_ = type_22();
                                                                            }
                                                                            let _e1447 = phi_2654_;
                                                                            phi_2656_ = _e1447;
                                                                            phi_2657_ = select(true, false, _e1441);
                                                                        } else {
                                                                            phi_2656_ = type_22();
                                                                            phi_2657_ = true;
                                                                        }
                                                                        let _e1450 = phi_2656_;
                                                                        let _e1452 = phi_2657_;
                                                                        if _e1452 {
                                                                            phi_2661_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                                        } else {
                                                                            phi_2661_ = _e1450;
                                                                        }
                                                                        let _e1454 = phi_2661_;
                                                                        phi_2662_ = _e1454;
                                                                    }
                                                                    let _e1456 = phi_2662_;
                                                                    phi_2663_ = _e1456;
                                                                    phi_2664_ = _e1182;
                                                                }
                                                                let _e1458 = phi_2663_;
                                                                let _e1460 = phi_2664_;
                                                                phi_2668_ = _e1458;
                                                                phi_2669_ = _e1460;
                                                            }
                                                            let _e1462 = phi_2668_;
                                                            let _e1464 = phi_2669_;
                                                            phi_2670_ = _e1462;
                                                            phi_2671_ = _e1117;
                                                            phi_2672_ = _e1464;
                                                        }
                                                        let _e1466 = phi_2670_;
                                                        let _e1468 = phi_2671_;
                                                        let _e1470 = phi_2672_;
                                                        phi_2673_ = _e1466;
                                                        phi_2674_ = _e1468;
                                                        phi_2675_ = _e1470;
                                                    }
                                                    let _e1472 = phi_2673_;
                                                    let _e1474 = phi_2674_;
                                                    let _e1476 = phi_2675_;
                                                    phi_2683_ = _e1472;
                                                    phi_2684_ = select(_e1476, true, _e1474);
                                                } else {
                                                    phi_2683_ = type_22();
                                                    phi_2684_ = true;
                                                }
                                                let _e1479 = phi_2683_;
                                                let _e1481 = phi_2684_;
                                                if _e1481 {
                                                    phi_2688_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                                                } else {
                                                    phi_2688_ = _e1479;
                                                }
                                                let _e1483 = phi_2688_;
                                                if (_e1483.member_3 != 4294967295u) {
                                                    if (_e860 == _e156) {
                                                        phi_3011_ = false;
                                                    } else {
                                                        let _e1487 = (_e860 < arrayLength((&global_4.member)));
                                                        if _e1487 {
                                                            if _e1487 {
                                                            } else {
                                                                phi_4341_ = true;
                                                                break;
                                                            }
                                                            let _e1489 = global_4.member[_e860];
                                                            phi_2711_ = _e1489;
                                                        } else {
                                                            phi_2711_ = 4294967295u;
                                                        }
                                                        let _e1491 = phi_2711_;
                                                        let _e1492 = (_e1491 < arrayLength((&global_5.member)));
                                                        if _e1492 {
                                                            if _e1492 {
                                                            } else {
                                                                phi_4341_ = true;
                                                                break;
                                                            }
                                                            let _e1494 = global_5.member[_e1491];
                                                            phi_2725_ = _e1494;
                                                        } else {
                                                            phi_2725_ = 0i;
                                                        }
                                                        let _e1496 = phi_2725_;
                                                        let _e1497 = (_e1496 == 0i);
                                                        if _e1497 {
                                                            phi_3010_ = true;
                                                        } else {
                                                            if _e434 {
                                                                phi_2744_ = vec3<f32>(_e896, _e918, _e940);
                                                            } else {
                                                                if (_e410 == 1u) {
                                                                    phi_2743_ = vec3<f32>(_e940, _e896, _e918);
                                                                } else {
                                                                    phi_2743_ = vec3<f32>(_e918, _e940, _e896);
                                                                }
                                                                let _e1502 = phi_2743_;
                                                                phi_2744_ = _e1502;
                                                            }
                                                            let _e1505 = phi_2744_;
                                                            if _e434 {
                                                                phi_2759_ = vec3<f32>(_e956, _e971, _e986);
                                                            } else {
                                                                if (_e410 == 1u) {
                                                                    phi_2758_ = vec3<f32>(_e986, _e956, _e971);
                                                                } else {
                                                                    phi_2758_ = vec3<f32>(_e971, _e986, _e956);
                                                                }
                                                                let _e1510 = phi_2758_;
                                                                phi_2759_ = _e1510;
                                                            }
                                                            let _e1513 = phi_2759_;
                                                            if _e434 {
                                                                phi_2774_ = vec3<f32>(_e1002, _e1017, _e1032);
                                                            } else {
                                                                if (_e410 == 1u) {
                                                                    phi_2773_ = vec3<f32>(_e1032, _e1002, _e1017);
                                                                } else {
                                                                    phi_2773_ = vec3<f32>(_e1017, _e1032, _e1002);
                                                                }
                                                                let _e1518 = phi_2773_;
                                                                phi_2774_ = _e1518;
                                                            }
                                                            let _e1521 = phi_2774_;
                                                            let _e1524 = (_e1513.x - _e1505.x);
                                                            let _e1527 = (_e1513.y - _e1505.y);
                                                            let _e1530 = (_e1513.z - _e1505.z);
                                                            let _e1532 = (_e1521.x - _e1505.x);
                                                            let _e1534 = (_e1521.y - _e1505.y);
                                                            let _e1536 = (_e1521.z - _e1505.z);
                                                            if (_e288.member_1 == 1u) {
                                                                phi_2810_ = (vec3<f32>(_e288.member[0], _e288.member[1], _e288.member[2]) - _e1505);
                                                            } else {
                                                                phi_2810_ = vec3<f32>(_e288.member[0], _e288.member[1], _e288.member[2]);
                                                            }
                                                            let _e1551 = phi_2810_;
                                                            let _e1557 = bitcast<f32>((bitcast<u32>((_e1524 * _e1534)) ^ _e288.member_3[0]));
                                                            let _e1561 = bitcast<f32>((bitcast<u32>((_e1527 * _e1532)) ^ _e288.member_3[0]));
                                                            let _e1565 = bitcast<f32>((bitcast<u32>((_e1527 * _e1536)) ^ _e288.member_3[0]));
                                                            let _e1569 = bitcast<f32>((bitcast<u32>((_e1530 * _e1534)) ^ _e288.member_3[0]));
                                                            let _e1573 = bitcast<f32>((bitcast<u32>((_e1530 * _e1532)) ^ _e288.member_3[0]));
                                                            let _e1577 = bitcast<f32>((bitcast<u32>((_e1524 * _e1536)) ^ _e288.member_3[0]));
                                                            let _e1578 = (_e1565 - _e1569);
                                                            let _e1579 = (_e1573 - _e1577);
                                                            let _e1580 = (_e1557 - _e1561);
                                                            let _e1604 = (bitcast<f32>((bitcast<u32>(_e1565) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1569) & 2147483647u)));
                                                            let _e1611 = (bitcast<f32>((bitcast<u32>(_e1573) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1577) & 2147483647u)));
                                                            let _e1618 = (bitcast<f32>((bitcast<u32>(_e1557) & 2147483647u)) + bitcast<f32>((bitcast<u32>(_e1561) & 2147483647u)));
                                                            if (_e288.member_2 == 0f) {
                                                                phi_2992_ = 0f;
                                                            } else {
                                                                let _e1648 = bitcast<f32>((bitcast<u32>(_e1578) & 2147483647u));
                                                                let _e1651 = bitcast<f32>((bitcast<u32>(_e1579) & 2147483647u));
                                                                let _e1654 = bitcast<f32>((bitcast<u32>(_e1580) & 2147483647u));
                                                                let _e1656 = select(_e1654, _e1651, (_e1651 > _e1654));
                                                                let _e1660 = select(_e1654, _e1651, (_e1651 < _e1654));
                                                                let _e1664 = select(_e1651, _e1648, (_e1648 < _e1651));
                                                                let _e1666 = select(_e1651, _e1648, (_e1648 > _e1651));
                                                                let _e1668 = select(_e1654, _e1666, (_e1666 < _e1654));
                                                                phi_2992_ = bitcast<f32>((bitcast<u32>((_e288.member_2 * bitcast<f32>((bitcast<u32>(((((select(_e1656, _e1648, (_e1648 > _e1656)) + bitcast<f32>((bitcast<u32>((0.414214f * select(_e1668, _e1664, (_e1664 > _e1668)))) ^ _e288.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.317838f * select(_e1660, _e1648, (_e1648 < _e1660)))) ^ _e288.member_3[0]))) + bitcast<f32>((bitcast<u32>((0.0000004768374f * ((_e1604 + _e1611) + _e1618))) ^ _e288.member_3[0]))) * 1.0000005f)) ^ _e288.member_3[0])))) ^ _e288.member_3[0]));
                                                            }
                                                            let _e1695 = phi_2992_;
                                                            phi_3010_ = (_e1497 || !(((((bitcast<f32>((bitcast<u32>((_e1551.x * _e1578)) ^ _e288.member_3[0])) + bitcast<f32>((bitcast<u32>((_e1551.y * _e1579)) ^ _e288.member_3[0]))) + bitcast<f32>((bitcast<u32>((_e1551.z * _e1580)) ^ _e288.member_3[0]))) * f32(-(_e1496))) > ((bitcast<f32>((bitcast<u32>((0.0000009536752f * ((bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1551.x) & 2147483647u)) * _e1604)) ^ _e288.member_3[0])) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1551.y) & 2147483647u)) * _e1611)) ^ _e288.member_3[0]))) + bitcast<f32>((bitcast<u32>((bitcast<f32>((bitcast<u32>(_e1551.z) & 2147483647u)) * _e1618)) ^ _e288.member_3[0]))))) ^ _e288.member_3[0])) + _e1695) + 0.0000000000000000000000000000000000001880791f))));
                                                        }
                                                        let _e1709 = phi_3010_;
                                                        phi_3011_ = _e1709;
                                                    }
                                                    let _e1711 = phi_3011_;
                                                    if _e1711 {
                                                        if (_e1483.member < _e832.member.member) {
                                                            phi_3031_ = true;
                                                        } else {
                                                            if (_e1483.member == _e832.member.member) {
                                                                phi_3030_ = (_e1483.member_3 < _e832.member.member_3);
                                                            } else {
                                                                phi_3030_ = false;
                                                            }
                                                            let _e1721 = phi_3030_;
                                                            phi_3031_ = _e1721;
                                                        }
                                                        let _e1723 = phi_3031_;
                                                        if _e1723 {
                                                            phi_3037_ = type_38(_e1483, _e1483.member);
                                                        } else {
                                                            phi_3037_ = _e832;
                                                        }
                                                        let _e1726 = phi_3037_;
                                                        phi_3038_ = _e1726;
                                                    } else {
                                                        phi_3038_ = _e832;
                                                    }
                                                    let _e1728 = phi_3038_;
                                                    phi_3039_ = _e1728;
                                                } else {
                                                    phi_3039_ = _e832;
                                                }
                                                let _e1730 = phi_3039_;
                                                phi_1461_ = _e1730;
                                            } else {
                                                phi_1461_ = type_38();
                                            }
                                            let _e1732 = phi_1461_;
                                            continue;
                                            continuing {
                                                phi_1460_ = _e1732;
                                                phi_1463_ = _e847;
                                                phi_4341_ = _e775;
                                                break if !(_e853);
                                            }
                                        }
                                        let _e1735 = phi_4341_;
                                        phi_4551_ = _e1735;
                                        if _e1735 {
                                            break;
                                        }
                                        phi_4610_ = _e1735;
                                        let _e2418 = local_11;
                                        phi_3040_ = _e2418;
                                    } else {
                                        phi_4610_ = _e775;
                                        phi_3040_ = _e777;
                                    }
                                    let _e1737 = phi_4610_;
                                    let _e1739 = phi_3040_;
                                    if _e824 {
                                        phi_4047_ = bool();
                                        phi_4048_ = u32();
                                        phi_4049_ = type_61();
                                    } else {
                                        let _e1740 = (_e820.member_1 < _e96);
                                        if _e1740 {
                                            if _e1740 {
                                            } else {
                                                phi_4551_ = true;
                                                break;
                                            }
                                            let _e1742 = global_9.member[_e820.member_1];
                                            phi_3061_ = _e1742;
                                        } else {
                                            phi_3061_ = type_48(array<u32, 2>(0u, 0u), array<u32, 2>(0u, 0u), 2147483648u, 2147483648u);
                                        }
                                        let _e1744 = phi_3061_;
                                        let _e1759 = ((10u * _e410) & 31u);
                                        let _e1762 = ((_e1744.member[0] >> bitcast<u32>(_e1759)) & 1023u);
                                        let _e1770 = bitcast<f32>((bitcast<u32>(((_e820.member.member_1[0] - _e820.member.member[0]) * 0.0009775171f)) ^ _e139));
                                        let _e1775 = (_e820.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1762)) - 8388608f) * _e1770)) ^ _e139)));
                                        let _e1779 = select(select(_e820.member.member_1[0], _e1775, (_e1775 < _e820.member.member_1[0])), _e820.member.member_1[0], (_e1762 == 1023u));
                                        let _e1781 = ((10u * _e409) & 31u);
                                        let _e1784 = ((_e1744.member[0] >> bitcast<u32>(_e1781)) & 1023u);
                                        let _e1792 = bitcast<f32>((bitcast<u32>(((_e820.member.member_1[1] - _e820.member.member[1]) * 0.0009775171f)) ^ _e139));
                                        let _e1797 = (_e820.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1784)) - 8388608f) * _e1792)) ^ _e139)));
                                        let _e1801 = select(select(_e820.member.member_1[1], _e1797, (_e1797 < _e820.member.member_1[1])), _e820.member.member_1[1], (_e1784 == 1023u));
                                        let _e1803 = ((10u * _e411) & 31u);
                                        let _e1806 = ((_e1744.member[0] >> bitcast<u32>(_e1803)) & 1023u);
                                        let _e1814 = bitcast<f32>((bitcast<u32>(((_e820.member.member_1[2] - _e820.member.member[2]) * 0.0009775171f)) ^ _e139));
                                        let _e1819 = (_e820.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1806)) - 8388608f) * _e1814)) ^ _e139)));
                                        let _e1823 = select(select(_e820.member.member_1[2], _e1819, (_e1819 < _e820.member.member_1[2])), _e820.member.member_1[2], (_e1806 == 1023u));
                                        let _e1826 = ((_e1744.member[1] >> bitcast<u32>(_e1759)) & 1023u);
                                        let _e1834 = (_e820.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1826)) - 8388608f) * _e1770)) ^ _e139)));
                                        let _e1838 = select(select(_e820.member.member_1[0], _e1834, (_e1834 < _e820.member.member_1[0])), _e820.member.member_1[0], (_e1826 == 1023u));
                                        let _e1841 = ((_e1744.member[1] >> bitcast<u32>(_e1781)) & 1023u);
                                        let _e1849 = (_e820.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1841)) - 8388608f) * _e1792)) ^ _e139)));
                                        let _e1853 = select(select(_e820.member.member_1[1], _e1849, (_e1849 < _e820.member.member_1[1])), _e820.member.member_1[1], (_e1841 == 1023u));
                                        let _e1856 = ((_e1744.member[1] >> bitcast<u32>(_e1803)) & 1023u);
                                        let _e1864 = (_e820.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1856)) - 8388608f) * _e1814)) ^ _e139)));
                                        let _e1868 = select(select(_e820.member.member_1[2], _e1864, (_e1864 < _e820.member.member_1[2])), _e820.member.member_1[2], (_e1856 == 1023u));
                                        let _e1874 = ((_e1744.member_1[0] >> bitcast<u32>(_e1759)) & 1023u);
                                        let _e1882 = (_e820.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1874)) - 8388608f) * _e1770)) ^ _e139)));
                                        let _e1886 = select(select(_e820.member.member_1[0], _e1882, (_e1882 < _e820.member.member_1[0])), _e820.member.member_1[0], (_e1874 == 1023u));
                                        let _e1889 = ((_e1744.member_1[0] >> bitcast<u32>(_e1781)) & 1023u);
                                        let _e1897 = (_e820.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1889)) - 8388608f) * _e1792)) ^ _e139)));
                                        let _e1901 = select(select(_e820.member.member_1[1], _e1897, (_e1897 < _e820.member.member_1[1])), _e820.member.member_1[1], (_e1889 == 1023u));
                                        let _e1904 = ((_e1744.member_1[0] >> bitcast<u32>(_e1803)) & 1023u);
                                        let _e1912 = (_e820.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1904)) - 8388608f) * _e1814)) ^ _e139)));
                                        let _e1916 = select(select(_e820.member.member_1[2], _e1912, (_e1912 < _e820.member.member_1[2])), _e820.member.member_1[2], (_e1904 == 1023u));
                                        let _e1919 = ((_e1744.member_1[1] >> bitcast<u32>(_e1759)) & 1023u);
                                        let _e1927 = (_e820.member.member[0] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1919)) - 8388608f) * _e1770)) ^ _e139)));
                                        let _e1931 = select(select(_e820.member.member_1[0], _e1927, (_e1927 < _e820.member.member_1[0])), _e820.member.member_1[0], (_e1919 == 1023u));
                                        let _e1934 = ((_e1744.member_1[1] >> bitcast<u32>(_e1781)) & 1023u);
                                        let _e1942 = (_e820.member.member[1] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1934)) - 8388608f) * _e1792)) ^ _e139)));
                                        let _e1946 = select(select(_e820.member.member_1[1], _e1942, (_e1942 < _e820.member.member_1[1])), _e820.member.member_1[1], (_e1934 == 1023u));
                                        let _e1949 = ((_e1744.member_1[1] >> bitcast<u32>(_e1803)) & 1023u);
                                        let _e1957 = (_e820.member.member[2] + bitcast<f32>((bitcast<u32>(((bitcast<f32>((1258291200u | _e1949)) - 8388608f) * _e1814)) ^ _e139)));
                                        let _e1961 = select(select(_e820.member.member_1[2], _e1957, (_e1957 < _e820.member.member_1[2])), _e820.member.member_1[2], (_e1949 == 1023u));
                                        let _e1966 = type_61(type_53(array<f32, 3>(_e1779, _e1801, _e1823), array<f32, 3>(_e1838, _e1853, _e1868)), _e1744.member_2);
                                        let _e1971 = type_61(type_53(array<f32, 3>(_e1886, _e1901, _e1916), array<f32, 3>(_e1931, _e1946, _e1961)), _e1744.member_3);
                                        let _e1977 = ((_e1779 - _e495) * _e500);
                                        let _e1978 = ((_e1886 - _e495) * _e500);
                                        let _e1979 = ((_e1838 - _e496) * _e500);
                                        let _e1980 = ((_e1931 - _e496) * _e500);
                                        let _e1985 = ((_e1801 - _e561) * _e566);
                                        let _e1986 = ((_e1901 - _e561) * _e566);
                                        let _e1987 = ((_e1853 - _e562) * _e566);
                                        let _e1988 = ((_e1946 - _e562) * _e566);
                                        let _e1993 = ((_e1823 - _e627) * _e632);
                                        let _e1994 = ((_e1916 - _e627) * _e632);
                                        let _e1995 = ((_e1868 - _e628) * _e632);
                                        let _e1996 = ((_e1961 - _e628) * _e632);
                                        let _e1998 = select(_e1995, _e1993, (_e1993 < _e1995));
                                        let _e2000 = select(_e1996, _e1994, (_e1994 < _e1996));
                                        let _e2002 = select(_e1995, _e1993, (_e1993 > _e1995));
                                        let _e2004 = select(_e1996, _e1994, (_e1994 > _e1996));
                                        let _e2006 = select(_e1979, _e1977, (_e1977 < _e1979));
                                        let _e2008 = select(_e1980, _e1978, (_e1978 < _e1980));
                                        let _e2010 = select(_e1987, _e1985, (_e1985 < _e1987));
                                        let _e2012 = select(_e1988, _e1986, (_e1986 < _e1988));
                                        let _e2014 = select(_e2010, _e2006, (_e2006 > _e2010));
                                        let _e2016 = select(_e2012, _e2008, (_e2008 > _e2012));
                                        let _e2018 = select(_e1998, _e2014, (_e2014 > _e1998));
                                        let _e2020 = select(_e2000, _e2016, (_e2016 > _e2000));
                                        let _e2022 = select(_e1979, _e1977, (_e1977 > _e1979));
                                        let _e2024 = select(_e1980, _e1978, (_e1978 > _e1980));
                                        let _e2026 = select(_e1987, _e1985, (_e1985 > _e1987));
                                        let _e2028 = select(_e1988, _e1986, (_e1986 > _e1988));
                                        let _e2030 = select(_e2026, _e2022, (_e2022 < _e2026));
                                        let _e2032 = select(_e2028, _e2024, (_e2024 < _e2028));
                                        let _e2037 = -(_e1998);
                                        let _e2038 = -(_e2000);
                                        let _e2045 = (select(_e2002, _e2030, (_e2030 < _e2002)) + (select(_e2037, _e2002, (_e2002 > _e2037)) * 0.0000019073523f));
                                        let _e2046 = (select(_e2004, _e2032, (_e2032 < _e2004)) + (select(_e2038, _e2004, (_e2004 > _e2038)) * 0.0000019073523f));
                                        let _e2048 = select(_e743, _e2018, (_e2018 > _e743));
                                        let _e2050 = select(_e743, _e2020, (_e2020 > _e743));
                                        let _e2055 = (_e2048 <= select(_e1739.member_1, _e2045, (_e2045 < _e1739.member_1)));
                                        let _e2056 = (_e2050 <= select(_e1739.member_1, _e2046, (_e2046 < _e1739.member_1)));
                                        let _e2057 = (_e2048 <= _e2050);
                                        if _e2055 {
                                            if _e2056 {
                                                if _e2057 {
                                                    phi_3947_ = _e1971;
                                                } else {
                                                    phi_3947_ = _e1966;
                                                }
                                                let _e2059 = phi_3947_;
                                                let _e2066 = (_e818 % 128u);
                                                let _e2067 = (_e2066 < 128u);
                                                if _e2067 {
                                                } else {
                                                    phi_4551_ = true;
                                                    break;
                                                }
                                                local_6[_e2066] = _e2059.member_1;
                                                if _e2067 {
                                                } else {
                                                    phi_4551_ = true;
                                                    break;
                                                }
                                                local_5[_e2066] = _e2059.member.member[0];
                                                if _e2067 {
                                                } else {
                                                    phi_4551_ = true;
                                                    break;
                                                }
                                                local_4[_e2066] = _e2059.member.member[1];
                                                if _e2067 {
                                                } else {
                                                    phi_4551_ = true;
                                                    break;
                                                }
                                                local_3[_e2066] = _e2059.member.member[2];
                                                if _e2067 {
                                                } else {
                                                    phi_4551_ = true;
                                                    break;
                                                }
                                                local_2[_e2066] = _e2059.member.member_1[0];
                                                if _e2067 {
                                                } else {
                                                    phi_4551_ = true;
                                                    break;
                                                }
                                                local_1[_e2066] = _e2059.member.member_1[1];
                                                if _e2067 {
                                                } else {
                                                    phi_4551_ = true;
                                                    break;
                                                }
                                                local[_e2066] = _e2059.member.member_1[2];
                                                if _e2067 {
                                                } else {
                                                    phi_4551_ = true;
                                                    break;
                                                }
                                                local_7[_e2066] = select(_e2048, _e2050, _e2057);
                                                if _e2057 {
                                                    phi_4023_ = _e1966;
                                                } else {
                                                    phi_4023_ = _e1971;
                                                }
                                                let _e2084 = phi_4023_;
                                                phi_4024_ = (_e818 + 1u);
                                                phi_4025_ = _e2084;
                                            } else {
                                                phi_4024_ = u32();
                                                phi_4025_ = type_61();
                                            }
                                            let _e2086 = phi_4024_;
                                            let _e2088 = phi_4025_;
                                            phi_4027_ = _e2086;
                                            phi_4028_ = _e2088;
                                            phi_4029_ = select(true, false, _e2056);
                                        } else {
                                            phi_4027_ = u32();
                                            phi_4028_ = type_61();
                                            phi_4029_ = true;
                                        }
                                        let _e2091 = phi_4027_;
                                        let _e2093 = phi_4028_;
                                        let _e2095 = phi_4029_;
                                        if _e2095 {
                                            if _e2055 {
                                                phi_4036_ = _e1966;
                                            } else {
                                                phi_4036_ = _e1971;
                                            }
                                            let _e2097 = phi_4036_;
                                            phi_4041_ = select(_e2056, true, _e2055);
                                            phi_4043_ = _e2097;
                                        } else {
                                            phi_4041_ = _e816;
                                            phi_4043_ = _e2093;
                                        }
                                        let _e2100 = phi_4041_;
                                        let _e2102 = phi_4043_;
                                        phi_4047_ = _e2100;
                                        phi_4048_ = select(_e2091, _e818, _e2095);
                                        phi_4049_ = _e2102;
                                    }
                                    let _e2105 = phi_4047_;
                                    let _e2107 = phi_4048_;
                                    let _e2109 = phi_4049_;
                                    if _e824 {
                                        phi_4059_ = _e820;
                                    } else {
                                        phi_4059_ = _e2109;
                                    }
                                    let _e2111 = phi_4059_;
                                    phi_4554_ = _e1737;
                                    phi_4060_ = _e1739;
                                    phi_4061_ = (_e779 - 1u);
                                    phi_4062_ = select(_e2105, false, _e824);
                                    phi_4063_ = select(_e2107, _e818, _e824);
                                    phi_4064_ = _e2111;
                                } else {
                                    phi_4554_ = _e775;
                                    phi_4060_ = _e777;
                                    phi_4061_ = _e779;
                                    phi_4062_ = _e816;
                                    phi_4063_ = _e818;
                                    phi_4064_ = _e820;
                                }
                                let _e2115 = phi_4554_;
                                let _e2117 = phi_4060_;
                                let _e2119 = phi_4061_;
                                let _e2121 = phi_4062_;
                                let _e2123 = phi_4063_;
                                let _e2125 = phi_4064_;
                                phi_4553_ = _e2115;
                                phi_4065_ = _e2117;
                                phi_4066_ = _e2119;
                                phi_4067_ = _e2121;
                                phi_4068_ = _e2123;
                                phi_4069_ = _e2125;
                            } else {
                                phi_4553_ = _e775;
                                phi_4065_ = type_38();
                                phi_4066_ = u32();
                                phi_4067_ = bool();
                                phi_4068_ = u32();
                                phi_4069_ = type_61();
                            }
                            let _e2127 = phi_4553_;
                            let _e2129 = phi_4065_;
                            let _e2131 = phi_4066_;
                            let _e2133 = phi_4067_;
                            let _e2135 = phi_4068_;
                            let _e2137 = phi_4069_;
                            phi_4552_ = _e2127;
                            phi_1334_ = _e2129;
                            phi_1337_ = _e2131;
                            phi_1339_ = _e2133;
                            phi_1341_ = _e2135;
                            phi_1343_ = _e2137;
                            phi_4070_ = _e789;
                        } else {
                            phi_4552_ = _e775;
                            phi_1334_ = type_38();
                            phi_1337_ = u32();
                            phi_1339_ = bool();
                            phi_1341_ = u32();
                            phi_1343_ = type_61();
                            phi_4070_ = false;
                        }
                        let _e2139 = phi_4552_;
                        let _e2141 = phi_1334_;
                        let _e2143 = phi_1337_;
                        let _e2145 = phi_1339_;
                        let _e2147 = phi_1341_;
                        let _e2149 = phi_1343_;
                        let _e2151 = phi_4070_;
                        continue;
                        continuing {
                            phi_4347_ = _e2139;
                            phi_1333_ = _e2141;
                            phi_1336_ = _e2143;
                            phi_1338_ = _e2145;
                            phi_1340_ = _e2147;
                            phi_1342_ = _e2149;
                            phi_4551_ = _e2139;
                            break if !(_e2151);
                        }
                    }
                    let _e2154 = phi_4551_;
                    if _e2154 {
                        break;
                    }
                    let _e2156 = local_10;
                    if (_e2156.member.member_3 != 4294967295u) {
                        let _e2161 = bitcast<u32>(_e2156.member.member);
                        let _e2165 = (bitcast<i32>((_e2161 >> bitcast<u32>(23i))) & 255i);
                        let _e2166 = (_e2165 + _e412);
                        if (_e2165 == 255i) {
                            phi_4129_ = _e2156.member.member;
                        } else {
                            if (_e2165 > 0i) {
                                if (_e2166 > 0i) {
                                    let _e2170 = (_e2166 < 255i);
                                    if _e2170 {
                                        phi_4108_ = bitcast<f32>((_e2161 + bitcast<u32>((_e412 << bitcast<u32>(23i)))));
                                    } else {
                                        phi_4108_ = f32();
                                    }
                                    let _e2177 = phi_4108_;
                                    phi_4110_ = _e2177;
                                    phi_4111_ = select(true, false, _e2170);
                                } else {
                                    phi_4110_ = f32();
                                    phi_4111_ = true;
                                }
                                let _e2180 = phi_4110_;
                                let _e2182 = phi_4111_;
                                phi_4112_ = _e2180;
                                phi_4113_ = _e2182;
                            } else {
                                phi_4112_ = f32();
                                phi_4113_ = true;
                            }
                            let _e2184 = phi_4112_;
                            let _e2186 = phi_4113_;
                            if _e2186 {
                                let _e2187 = (_e2161 & 2147483648u);
                                let _e2194 = ((_e2161 & 8388607u) | (select(0u, 1u, ((_e2161 & 2139095040u) != 0u)) << bitcast<u32>(23i)));
                                let _e2198 = (_e2194 == 0u);
                                if _e2198 {
                                    phi_4311_ = bitcast<f32>(_e2187);
                                } else {
                                    let _e2203 = (select((bitcast<u32>(31i) - firstLeadingBit(_e2194)), 32u, _e2198) - 8u);
                                    let _e2206 = (_e2194 << bitcast<u32>((_e2203 & 31u)));
                                    let _e2208 = ((_e2166 + select(0i, 1i, (_e2165 == 0i))) - bitcast<i32>(_e2203));
                                    if (_e2208 >= 255i) {
                                        phi_4301_ = bitcast<f32>((_e2187 | 2139095040u));
                                        phi_4302_ = f32();
                                        phi_4303_ = true;
                                    } else {
                                        let _e2210 = (_e2208 > 0i);
                                        if _e2210 {
                                            phi_4295_ = bitcast<f32>(((_e2187 | (bitcast<u32>(_e2208) << bitcast<u32>(23i))) | (_e2206 & 8388607u)));
                                            phi_4296_ = f32();
                                        } else {
                                            if (_e2208 < -24i) {
                                                phi_4261_ = 26u;
                                            } else {
                                                phi_4261_ = bitcast<u32>((1i - _e2208));
                                            }
                                            let _e2215 = phi_4261_;
                                            let _e2216 = (_e2215 & 31u);
                                            let _e2218 = (_e2206 >> bitcast<u32>(_e2216));
                                            let _e2222 = (_e2206 & ((1u << bitcast<u32>(_e2216)) - 1u));
                                            let _e2226 = (1u << bitcast<u32>(((_e2215 - 1u) & 31u)));
                                            if (_e2222 > _e2226) {
                                                phi_4282_ = true;
                                            } else {
                                                if (_e2222 == _e2226) {
                                                    phi_4279_ = ((_e2218 & 1u) == 1u);
                                                } else {
                                                    phi_4279_ = false;
                                                }
                                                let _e2232 = phi_4279_;
                                                phi_4282_ = _e2232;
                                            }
                                            let _e2234 = phi_4282_;
                                            phi_4295_ = f32();
                                            phi_4296_ = bitcast<f32>((_e2187 | (_e2218 + select(0u, 1u, _e2234))));
                                        }
                                        let _e2247 = phi_4295_;
                                        let _e2249 = phi_4296_;
                                        phi_4301_ = _e2247;
                                        phi_4302_ = _e2249;
                                        phi_4303_ = _e2210;
                                    }
                                    let _e2253 = phi_4301_;
                                    let _e2255 = phi_4302_;
                                    let _e2257 = phi_4303_;
                                    phi_4311_ = select(_e2255, _e2253, _e2257);
                                }
                                let _e2261 = phi_4311_;
                                phi_4128_ = _e2261;
                            } else {
                                phi_4128_ = _e2184;
                            }
                            let _e2263 = phi_4128_;
                            phi_4129_ = _e2263;
                        }
                        let _e2265 = phi_4129_;
                        let _e2266 = bitcast<u32>(_e2265);
                        if ((_e2266 & 2147483647u) >= 2139095040u) {
                            phi_4141_ = bitcast<f32>(((_e2266 & 2147483648u) | 2139095039u));
                        } else {
                            phi_4141_ = _e2265;
                        }
                        let _e2273 = phi_4141_;
                        phi_4146_ = type_22(_e2273, _e2156.member.member_1, _e2156.member.member_2, _e2156.member.member_3);
                    } else {
                        phi_4146_ = type_22(340282350000000000000000000000000000000f, 0f, 0f, 4294967295u);
                    }
                    let _e2278 = phi_4146_;
                    if _e289 {
                    } else {
                        break;
                    }
                    global_7.member[_e143] = _e2278;
                    if _e150 {
                    } else {
                        break;
                    }
                    let _e2282 = select(0u, 1u, (_e356 <= _e366));
                    if (_e2282 > 0u) {
                        let _e2284 = (1u < _e111);
                        if _e2284 {
                            if (0u < _e111) {
                            } else {
                                break;
                            }
                            let _e2288 = atomicAdd((&global_8.member[0u]), _e2282);
                            if ((_e2288 + _e2282) < _e2288) {
                                if _e2284 {
                                } else {
                                    break;
                                }
                                let _e2293 = atomicAdd((&global_8.member[1u]), 1u);
                            }
                        }
                    }
                    let _e2296 = select(0u, 1u, (_e2278.member_3 != 4294967295u));
                    if (_e2296 > 0u) {
                        let _e2298 = (3u < _e111);
                        if _e2298 {
                            if (2u < _e111) {
                            } else {
                                break;
                            }
                            let _e2302 = atomicAdd((&global_8.member[2u]), _e2296);
                            if ((_e2302 + _e2296) < _e2302) {
                                if _e2298 {
                                } else {
                                    break;
                                }
                                let _e2307 = atomicAdd((&global_8.member[3u]), 1u);
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
fn trace_paths_printed_leaf10_(@builtin(global_invocation_id) param: vec3<u32>) {
    global = param;
    function_();
}
